# SPDX-License-Identifier: MIT
# A collision of a disk, error against time: the paper's Runge-Kutta method, splittings, the library.
#     gnuplot -e "csv = 'disk.csv'; svg = 'disk_collision_speed.svg'" bench/plots/plot_collision.gp
# The lines that name the gnuplot version are removed.
set output "| sed -e '/^<desc>/d' -e '/Gnuplot/d' -e '/GNUPLOT/d' > " . svg
set terminal svg size 860,620 fixed font "DejaVu Sans,12" background "white"

black = "#222222"; grey = "#777777"; blue = "#0060ad"; red = "#c8421a"; green = "#2a7f3b"; violet = "#7b3f99"; amber = "#b8860b"

set datafile separator comma
set datafile missing ""
set logscale xy
set format y "10^{%T}"
set xrange [1:1000]
set yrange [1e-14:1e-2]
set xtics nomirror
set ytics nomirror
set border 3 lc rgb black
set grid lc rgb "#e4e4e4" lw 0.7
set xlabel "time, one core (ms)"
set ylabel "error of ε" offset 0.5
set title "a collision of 940 modes, ν = 0.33, α = 500, v = 0.1\nRunge–Kutta with 256 angles, splittings with 128; but where it says so, rivals are built for the machine"
set key at screen 0.58,0.02 center bottom maxrows 5 samplen 2 spacing 1.3 width 2 Left reverse
set bmargin 11

# Columns: 1 table, 2 method, 6 seconds, 7 error. The rivals as they are fastest, built for the machine, where they are;
# the paper's method also with the flags of the library's loops; of splittings with its loops, one.
rivals = system("grep -q '^collision native,' '" . csv . "' && echo 'collision native' || echo collision")
y(table, method) = strcol(1) eq table && strcol(2) eq method ? column(7) : NaN
ms(x) = 1e3 * x

plot csv using (ms($6)):(y("collision", "RK4")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 dt (8,5) lc rgb grey \
         title "Runge–Kutta 4, the library’s flags", \
     csv using (ms($6)):(y(rivals, "RK4")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 lc rgb black \
         title "Runge–Kutta 4", \
     csv using (ms($6)):(y(rivals, "Strang")) skip 1 with linespoints pt 5 ps 0.5 lw 1.8 lc rgb amber \
         title "Strang", \
     csv using (ms($6)):(y(rivals, "Yoshida 4")) skip 1 with linespoints pt 9 ps 0.6 lw 1.8 lc rgb red \
         title "Yoshida 4 (larger steps explode)", \
     csv using (ms($6)):(y(rivals, "SRKN 6-4")) skip 1 with linespoints pt 11 ps 0.6 lw 1.8 lc rgb green \
         title "Blanes–Moan SRKN_6^4", \
     csv using (ms($6)):(y(rivals, "SRKN 11-6")) skip 1 with linespoints pt 13 ps 0.6 lw 1.8 lc rgb violet \
         title "Blanes–Moan SRKN_{11}^6", \
     csv using (ms($6)):(y(rivals, "SRKN 14-6")) skip 1 with linespoints pt 13 ps 0.6 lw 1.8 dt (8,5) lc rgb violet \
         title "Blanes–Moan SRKN_{14}^6", \
     csv using (ms($6)):(y("collision cor's", "SRKN 11-6")) skip 1 with linespoints pt 6 ps 0.6 lw 1.4 lc rgb blue \
         title "cor’s inner loops, SRKN_{11}^6", \
     csv using (ms($6)):(y("collision", "cor")) skip 1 with linespoints pt 7 ps 0.8 lw 2.4 lc rgb blue \
         title "cor, to a tolerance"
set output
