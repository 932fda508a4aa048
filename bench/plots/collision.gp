# SPDX-License-Identifier: MIT
# Collisions of a disk, error against time: docs/speed/collision.svg from disks.csv. Left the methods at one disk and
# wall, right what the modes left out and the softness of the wall cost.
stem = "collision"; home = "docs/speed"; width = 1060; height = 640
if (!exists("dir")) dir = home
csv = dir."/disks.csv"
load "docs/style.gp"

# Columns: 1 table, 2 method, 3 speed, 4 setting, 5 modes, 6 seconds, 7 error. The rivals built for the machine where that
# was possible.
rivals = system("grep -q '^collision native,' '" . csv . "' && echo 'collision native' || echo collision")
y(table, method) = strcol(1) eq table && strcol(2) eq method ? column(7) : NaN
model(n) = strcol(1) eq "collision models" && strcol(2) eq "cor" && column(3) == 0.1 && column(5) == n ? column(7) : NaN
other(method) = strcol(1) eq "collision models" && strcol(2) eq method && column(3) == 0.1 ? column(7) : NaN
ms(x) = 1e3*x

set logscale xy
set format xy power
set xlabel "time, one core (ms)"
set multiplot layout 1,2 title "a collision of a disk with a wall, ν = 0.33, v = 0.1 √(E/ρ)" \
    margins 0.07,0.985,0.32,0.88 spacing 0.085
set title "940 modes, α = 500/R"
set ylabel "error of ε" offset 0.5
set xrange [0.8:2000]
set yrange [1e-14:1e-2]
set key at screen 0.27,0.01 center bottom maxrows 5 width -2
set label 1 (rivals eq "collision" ? "rivals built with cor's flags" : "rivals built with -O3 -march=native -ffast-math") \
    at graph 0.98,0.965 right font small tc rgb black
plot csv using (ms($6)):(y("collision", "RK4")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 dt (8,5) lc rgb grey title "Runge–Kutta 4, cor's flags", \
     csv using (ms($6)):(y(rivals, "RK4")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 lc rgb black title "Runge–Kutta 4", \
     csv using (ms($6)):(y(rivals, "Strang")) skip 1 with linespoints pt 5 ps 0.5 lw 1.8 lc rgb amber title "Strang", \
     csv using (ms($6)):(y(rivals, "Yoshida 4")) skip 1 with linespoints pt 9 ps 0.6 lw 1.8 lc rgb red title "Yoshida 4", \
     csv using (ms($6)):(y(rivals, "SRKN 6-4")) skip 1 with linespoints pt 11 ps 0.6 lw 1.8 lc rgb green title "SRKN_6^4", \
     csv using (ms($6)):(y(rivals, "SRKN 11-6")) skip 1 with linespoints pt 13 ps 0.6 lw 1.8 lc rgb violet title "SRKN_{11}^6", \
     csv using (ms($6)):(y(rivals, "SRKN 14-6")) skip 1 with linespoints pt 13 ps 0.6 lw 1.8 dt (8,5) lc rgb violet title "SRKN_{14}^6", \
     csv using (ms($6)):(y("collision cor's", "SRKN 11-6")) skip 1 with linespoints pt 6 ps 0.6 lw 1.4 lc rgb blue title "SRKN_{11}^6  on cor's loops", \
     csv using (ms($6)):(y("collision", "cor")) skip 1 with linespoints pt 7 ps 0.8 lw 2.4 lc rgb blue title "cor, to a tolerance"

set title "α = 125, 250, ... 2000/R along each line"
unset label 1
set ylabel "distance of ε to all modes and a rigid wall" offset 0.5
set xrange [1e-5:2000]
set yrange [3e-6:1]
set key at screen 0.77,0.01 center bottom maxrows 4
plot csv using (ms($6)):(model(56)) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb grey title "56 modes", \
     csv using (ms($6)):(model(112)) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb amber title "112 modes", \
     csv using (ms($6)):(model(225)) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb red title "225 modes", \
     csv using (ms($6)):(model(450)) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb green title "450 modes", \
     csv using (ms($6)):(model(900)) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb violet title "900 modes", \
     csv using (ms($6)):(model(1800)) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb blue title "1800 modes", \
     csv using (ms($6)):(other("cor_disk_eps")) skip 1 with points pt 5 ps 1 lc rgb blue title "cor\\_disk\\_eps (its uncertainty)", \
     csv using (ms($6)):(other("Rayleigh")) skip 1 with points pt 2 ps 1 lw 1.6 lc rgb black title "Rayleigh’s energy"
unset multiplot
set output
