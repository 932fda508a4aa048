# SPDX-License-Identifier: MIT
# eps(g) of ice spheres, Fig. 1 of the paper of 1999, in docs/ice.svg. From the root of the repository:
#     ice --csv docs/ice.csv && gnuplot docs/ice.gp
stem = "ice"; home = "docs"; width = 960; height = 470
load "docs/style.gp"

# Columns: 1 speed, 2 Bridges, then each curve with the published and with its refitted g*, whose
# value ends the column's name.
g_star(column) = system(sprintf("head -n 1 %s | cut -d, -f%d | sed 's/.*_//'", csv, column))
label(name, column) = sprintf("%s, g* = %.2f", name, real(g_star(column)))

set logscale x
set format x "%g"
set xrange [0.001:10]
set yrange [0:1]
set ytics 0.2
set mytics 2
set xlabel "impact speed g (cm/s)"
set key bottom left width -2
set object 1 rectangle from 0.015, graph 0 to 5.1, graph 1 fc rgb shade fillstyle solid noborder behind
set label 1 "measured range" at 0.28, 0.965 center tc rgb grey font small

set multiplot layout 1,2 title "ice spheres: ε of the viscoelastic model and Bridges' experiment of 1984" \
    margins 0.07,0.985,0.125,0.85 spacing 0.085

set ylabel "coefficient of restitution ε" offset 0.5
set title "with the published g* = 0.32 cm/s"
plot csv using 1:2 skip 1 with lines lw 3.5 lc rgb black title "experiment, 0.32 g^{−0.234}", \
     csv using 1:3 skip 1 with lines lw 2 dt (8,5) lc rgb grey title "published Padé (35)", \
     csv using 1:5 skip 1 with lines lw 2.2 lc rgb blue title "exact, zero overlap", \
     csv using 1:7 skip 1 with lines lw 2.2 lc rgb red title "exact, zero force"

set title "with g* refitted (cm/s)"
plot csv using 1:2 skip 1 with lines lw 3.5 lc rgb black title "experiment, 0.32 g^{−0.234}", \
     csv using 1:4 skip 1 with lines lw 2 dt (8,5) lc rgb grey title label("published Padé (35)", 4), \
     csv using 1:6 skip 1 with lines lw 2.2 lc rgb blue title label("exact, zero overlap", 6), \
     csv using 1:8 skip 1 with lines lw 2.2 lc rgb red title label("exact, zero force", 8)

unset multiplot
set output
