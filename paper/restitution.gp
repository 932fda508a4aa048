# SPDX-License-Identifier: MIT
# Fig. 1, drawn by paper/run from restitution.csv.
stem = "restitution"
set terminal svg size 760,480 fixed font "DejaVu Sans,14" background "white"
load "paper/style.gp"

# Columns: 1 nu, 2 speed, 3 eps, 4, 5 eps within the uncertainty, 6 1 - eps^2, 7 its uncertainty; one block for each nu;
# of rigid_wall.csv: 2 speed, 5 eps, one block for each nu
limit = dir."/rigid_wall.csv"
set lmargin 9
set xrange [0:0.32]
set yrange [0.6:1]
set xtics 0.05
set ytics 0.1
set xlabel "impact speed v (√(E/ρ))"
set ylabel "coefficient of restitution ε" offset 0.5
set key bottom left
plot limit using 2:5 index 0 skip 1 with lines lw 2.2 lc rgb blue title "ν = 0.33, all modes, rigid wall", \
     limit using 2:5 index 1 with lines lw 2.2 lc rgb red title "ν = 0.9, all modes, rigid wall", \
     csv using 2:3:4:5 index 0 skip 1 with yerrorbars lw 1.2 pt 7 ps 0.6 lc rgb blue title "N ≤ 1800, extrapolated", \
     csv using 2:3:4:5 index 1 with yerrorbars lw 1.2 pt 7 ps 0.6 lc rgb red notitle, \
     "+" using (0.3):(0.65) every ::0::0 with points pt 4 ps 1.1 lw 2 lc rgb grey title "ν = 0.9, the paper's text"
set output
