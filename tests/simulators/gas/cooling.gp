# SPDX-License-Identifier: MIT
# Two gases that cool: temperature against time, and its deviation from theory. cool.py --write draws them.
stem = "cooling"; home = "docs/gas"; width = 1000; height = 460
load "docs/style.gp"
large = dir."/cooling_100000.csv"; small = dir."/cooling_10000.csv"; fine = dir."/cooling_100000_50.csv"

# Columns: 1 time, 2 T/m, 3 to 5 theory (zero overlap, zero force, without overlaps), 6 standard error of ln T
stats large using 2 every ::1::1 nooutput
first = STATS_max
deviation(n) = 100*log(column(n)/column(3))
t1 = 3.6

set multiplot layout 1,2 margins 0.075,0.985,0.15,0.96 spacing 0.095,0
set logscale xy
set format x power
set format y power
set xlabel "1 + t/t_1"
set ylabel "T(t)/T(0)" offset 1
set xrange [0.95:18]
set yrange [0.006:1.3]
set format x "%g"
set xtics (1, 2, 3, 5, 10, 16)
set key bottom left
plot small every ::1 u (1+$1/t1):($2/first) w p pt 6 ps 0.7 lc rgb green t "LAMMPS, 10^4  spheres", \
    large every ::1 u (1+$1/t1):($2/first) w p pt 7 ps 0.6 lc rgb red t "LAMMPS, 10^5  spheres", \
    small every ::1 u (1+$1/t1):($3/first) w l lc rgb blue lw 1.5 t "kinetic theory with cor's eps(g)", \
    [5:16] 1.45*x**(-5./3) w l lc rgb black dt 2 lw 1 t "slope -5/3"

unset logscale y
set ylabel "ln T - ln T of theory, %" offset 1
set format y "%g"
set yrange [-2.6:3.4]
set key top left
plot small every ::1 u (1+$1/t1):(-200*$6):(200*$6) w filledcurves lc rgb shade t "two standard errors, 10^4  spheres", \
    large every ::1 u (1+$1/t1):(-200*$6):(200*$6) w filledcurves lc rgb light t "two standard errors, 10^5  spheres", \
    small every ::1 u (1+$1/t1):(100*log($2/$3)) w p pt 6 ps 0.7 lc rgb green notitle, \
    large every ::1 u (1+$1/t1):(100*log($2/$3)) w p pt 7 ps 0.6 lc rgb red notitle, \
    fine every ::1 u (1+$1/t1):(100*log($2/$3)) w p pt 4 ps 0.9 lc rgb black t "10^5  spheres, 50 steps in a contact", \
    0 w l lc rgb blue lw 1.5 notitle, \
    small every ::1 u (1+$1/t1):(100*log($4/$3)) w l lc rgb amber lw 1.5 t "theory, contact ends at zero force", \
    small every ::1 u (1+$1/t1):(100*log($5/$3)) w l lc rgb violet lw 1.5 t "theory without overlaps"
