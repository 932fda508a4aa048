# SPDX-License-Identifier: MIT
# Fig. 1, drawn by paper/run from restitution.csv.
stem = "restitution"; home = "docs/paper"; width = 960; height = 480
load "docs/style.gp"

# Columns: 1 nu, 2 speed, 3 eps, 4, 5 eps within the uncertainty, 6 1 - eps^2, 7 its uncertainty; one block for each nu;
# of rigid_wall.csv: 2 speed, 5 eps, one block for each nu
limit = dir."/rigid_wall.csv"
array colour[2] = [blue, red]
set multiplot layout 1,2 title "a disk of all its modes at a rigid wall, and N ≤ 1800 modes extrapolated" \
    margins 0.07,0.985,0.13,0.86 spacing 0.09
set xlabel "impact speed v (√(E/ρ))"
set title "as in the paper"
set xrange [0:0.32]
set yrange [0.6:1]
set xtics 0.05
set ytics 0.1
set ylabel "coefficient of restitution ε" offset 0.5
set key bottom left
plot for [k = 0:1] limit using 2:5 index k skip (k == 0) with lines lw 2.2 lc rgb colour[k + 1] \
         title (k == 0 ? "ν = 0.33" : "ν = 0.9").", all modes, rigid wall", \
     for [k = 0:1] csv using 2:3:4:5 index k skip (k == 0) with yerrorbars lw 1.2 pt 7 ps 0.6 lc rgb colour[k + 1] \
         title (k == 0 ? "N ≤ 1800, extrapolated" : ""), \
     "+" using (0.3):(0.65) every ::0::0 with points pt 4 ps 1.1 lw 2 lc rgb grey title "ν = 0.9, the paper's text"

set title "the energy lost, small speeds drawn out"
set logscale xy
set xrange [0.003:0.32]
set yrange [0.01:0.6]
set xtics (0.003, 0.01, 0.03, 0.1, 0.3)
set ytics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set ylabel "1 − ε^2" offset 0.5
unset key
plot for [k = 0:1] limit using 2:3 index k skip (k == 0) with lines lw 2.2 lc rgb colour[k + 1], \
     for [k = 0:1] csv using 2:6:7 index k skip (k == 0) with yerrorbars lw 1.2 pt 7 ps 0.6 lc rgb colour[k + 1]
