# SPDX-License-Identifier: MIT
# A gas that cools: temperature against time, and its deviation from theory. cool.py --write draws it.
stem = "cooling"; home = "docs/gas"; width = 1000; height = 460
load "docs/style.gp"

# Columns: 1 time, 2 T/m, 3 to 5 theory (zero overlap, zero force, without overlaps), 6 standard error of ln T
stats csv using 2 every ::1::1 nooutput
first = STATS_max
deviation(n) = 100*log(column(n)/column(3))
t0 = 3.6

set multiplot layout 1,2 margins 0.075,0.985,0.15,0.96 spacing 0.095,0
set logscale xy
set format x power
set format y power
set xlabel "1 + t/t_0"
set ylabel "T(t)/T(0)" offset 1
set xrange [0.95:8]
set yrange [0.015:1.3]
set format x "%g"
set xtics (1, 2, 3, 4, 5, 6, 7)
set key bottom left
plot csv every ::1 u (1+$1/t0):($2/first) w p pt 7 ps 0.6 lc rgb red t "LAMMPS", \
    csv every ::1 u (1+$1/t0):($3/first) w l lc rgb blue lw 1.5 t "kinetic theory with cor's eps(g)", \
    [3:8] 1.25*x**(-5./3) w l lc rgb black dt 2 lw 1 t "slope -5/3"

unset logscale y
set ylabel "ln T - ln T of theory, %" offset 1
set format y "%g"
set yrange [-2.6:2.4]
set key top left
plot csv every ::1 u (1+$1/t0):(-200*$6):(200*$6) w filledcurves lc rgb light t "two standard errors", \
    csv every ::1 u (1+$1/t0):(100*log($2/$3)) w p pt 7 ps 0.6 lc rgb red t "LAMMPS", \
    0 w l lc rgb blue lw 1.5 notitle, \
    csv every ::1 u (1+$1/t0):(100*log($4/$3)) w l lc rgb amber lw 1.5 t "theory, contact ends at zero force", \
    csv every ::1 u (1+$1/t0):(100*log($5/$3)) w l lc rgb violet lw 1.5 t "theory without overlaps"
unset multiplot
