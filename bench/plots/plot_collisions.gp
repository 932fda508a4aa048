# SPDX-License-Identifier: MIT
# Collisions of a disk, error against time: the methods at one disk and wall, and what disk and wall leave out.
#     gnuplot -e "csv = 'collision.csv'; svg = 'collision.svg'" bench/plots/plot_collisions.gp
# The lines that name the gnuplot version are removed.
set output "| sed -e '/^<desc>/d' -e '/Gnuplot/d' -e '/GNUPLOT/d' > " . svg
set terminal svg size 1060,620 fixed font "DejaVu Sans,12" background "white"

black = "#222222"; grey = "#777777"; blue = "#0060ad"; red = "#c8421a"; green = "#2a7f3b"; violet = "#7b3f99"; amber = "#b8860b"

set datafile separator comma
set datafile missing ""
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xtics nomirror
set ytics nomirror
set border 3 lc rgb black
set grid lc rgb "#e4e4e4" lw 0.7
set xlabel "time, one core (ms)"

# Columns: 1 question, 2 built, 3 method, 4 speed, 5 setting, 6 modes, 7 seconds, 8 error. The rivals built for the
# machine where that was possible.
rivals = system("grep -q '^method,for the machine,' '" . csv . "' && echo 'for the machine' || echo library")
y(built, method) = strcol(1) eq "method" && strcol(2) eq built && strcol(3) eq method ? column(8) : NaN
model(n) = strcol(1) eq "model" && strcol(3) eq "cor" && column(4) == 0.1 && column(6) == n ? column(8) : NaN
other(method) = strcol(1) eq "model" && strcol(3) eq method && column(4) == 0.1 ? column(8) : NaN
ms(x) = 1e3 * x

set multiplot layout 1,2 title "a collision of a disk with a wall, ν = 0.33, v = 0.1" font ",14" margins 0.07,0.98,0.33,0.85 spacing 0.08
set title "940 modes, α = 500: methods"
set ylabel "error of ε" offset 0.5
set xrange [0.5:2000]
set yrange [1e-14:1e-2]
set key at screen 0.28,0.02 center bottom maxrows 5 samplen 2 spacing 1.2 width -2 Left reverse
plot csv using (ms($7)):(y("library", "RK4")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 dt (8,5) lc rgb grey title "RK 4, library’s flags", \
     csv using (ms($7)):(y(rivals, "RK4")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 lc rgb black title "Runge–Kutta 4", \
     csv using (ms($7)):(y(rivals, "Strang")) skip 1 with linespoints pt 5 ps 0.5 lw 1.8 lc rgb amber title "Strang", \
     csv using (ms($7)):(y(rivals, "Yoshida 4")) skip 1 with linespoints pt 9 ps 0.6 lw 1.8 lc rgb red title "Yoshida 4", \
     csv using (ms($7)):(y(rivals, "SRKN 6-4")) skip 1 with linespoints pt 11 ps 0.6 lw 1.8 lc rgb green title "SRKN_6^4", \
     csv using (ms($7)):(y(rivals, "SRKN 11-6")) skip 1 with linespoints pt 13 ps 0.6 lw 1.8 lc rgb violet title "SRKN_{11}^6", \
     csv using (ms($7)):(y(rivals, "SRKN 14-6")) skip 1 with linespoints pt 13 ps 0.6 lw 1.8 dt (8,5) lc rgb violet title "SRKN_{14}^6", \
     csv using (ms($7)):(y("with cor loops", "SRKN 11-6")) skip 1 with linespoints pt 6 ps 0.6 lw 1.4 lc rgb blue title "cor’s loops, SRKN_{11}^6", \
     csv using (ms($7)):(y("library", "cor")) skip 1 with linespoints pt 7 ps 0.8 lw 2.4 lc rgb blue title "cor, to a tolerance"

set title "distance to all modes and a hard wall; α = 125, 250, ... 2000"
unset ylabel
set xrange [1e-4:2000]
set yrange [1e-4:1]
set key at screen 0.77,0.02 center bottom maxrows 4
plot csv using (ms($7)):(model(56)) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb grey title "56 modes", \
     csv using (ms($7)):(model(112)) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb amber title "112", \
     csv using (ms($7)):(model(225)) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb red title "225", \
     csv using (ms($7)):(model(450)) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb green title "450", \
     csv using (ms($7)):(model(900)) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb violet title "900", \
     csv using (ms($7)):(model(1800)) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb blue title "1800", \
     csv using (ms($7)):(other("cor_disk_eps")) skip 1 with points pt 5 ps 1 lc rgb blue title "cor\\_disk\\_eps (its uncertainty)", \
     csv using (ms($7)):(other("Rayleigh")) skip 1 with points pt 2 ps 1 lw 1.6 lc rgb black title "Rayleigh’s energy"
unset multiplot
set output
