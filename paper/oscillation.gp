# SPDX-License-Identifier: MIT
# Not in the paper, drawn by paper/run from oscillation.csv.
stem = "oscillation"; home = "docs/paper"; width = 760; height = 480
load "docs/style.gp"
curve = dir."/rayleigh.csv"
limit = dir."/rigid_wall.csv"

# Columns: 1 speed; 1 - eps^2: 2 limit, 3, 4 within the uncertainty, 5 to 7 N = 940, 1300, 1800. Of rayleigh.csv: 1 speed,
# 3 centre of mass, all modes. Of rigid_wall.csv: 2 speed, 3 1 - eps^2
set lmargin 9
set logscale x
set format x "%g"
set xrange [6e-4:0.12]
set yrange [0:0.1]
set xtics (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1)
set ytics 0.02
set xlabel "impact speed v (√(E/ρ))"
set ylabel "1 − ε^2" offset 0.5
set object 1 rectangle from 0.03, graph 0 to 0.12, graph 1 fc rgb shade fillstyle solid noborder behind
set label 1 "beyond\nRayleigh's theory" at 0.032, 0.0955 tc rgb grey font small
set title "a disk and a rigid wall, ν = 0.33"
set key top left
plot curve using 1:3 skip 1 with lines lw 2.2 lc rgb blue title "Rayleigh, centre of mass", \
     csv using 1:2:3:4 skip 1 with yerrorbars pt 7 ps 0.6 lw 1.4 lc rgb red title "full dynamics, extrapolated", \
     limit using 2:3 index 0 skip 1 with lines lw 1.8 lc rgb black title "all modes, rigid wall", \
     csv using 1:5 skip 1 with points pt 8 ps 0.7 lw 1 lc rgb grey title "full dynamics, N = 940", \
     csv using 1:6 skip 1 with points pt 4 ps 0.6 lw 1 lc rgb grey title "N = 1300", \
     csv using 1:7 skip 1 with points pt 6 ps 0.7 lw 1.2 lc rgb black title "N = 1800"
