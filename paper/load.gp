# SPDX-License-Identifier: MIT
# Fig. 10, drawn by paper/run from load.csv.
stem = "load"; home = "docs/paper"; width = 960; height = 470
load "docs/style.gp"

# Columns: 1 compression; the law: 2 centre of mass, 3 diameter, 4 as printed, 5 leading logarithm; relaxed: 6 1300
# modes, alpha = 500; all modes: 7 alpha = 500, 8 2000, 9 20000
set multiplot layout 1,2 title "a disk pressed against a wall, ν = 0.33; α in 1/R" margins 0.07,0.985,0.12,0.85 spacing 0.085

set title "load"
set xrange [0:0.3]
set yrange [0:0.6]
set xtics 0.1
set mxtics 2
set ytics 0.1
set xlabel "compression δ (R)"
set ylabel "load P (E R)" offset 0.5
set key top left
plot csv using 1:2 skip 1 with lines lw 2.2 lc rgb blue title "law, centre of mass", \
     csv using 1:4 skip 1 with lines lw 2.2 lc rgb red title "law as printed, (57)", \
     csv using 1:3 skip 1 with lines lw 2.2 lc rgb green title "law, diameter", \
     csv using 1:6 skip 1 with lines lw 2.4 dt (10,4,2,4) lc rgb black title "relaxed, 1300 modes, α = 500", \
     csv using 1:9 skip 1 with lines lw 2 dt (3,3) lc rgb black title "relaxed, all modes, α = 20000"

set title "relative to the law, centre of mass"
set logscale x
set format x "%g"
set xrange [0.001:0.3]
set yrange [0.6:1.6]
set xtics (0.001, 0.003, 0.01, 0.03, 0.1, 0.3)
set ytics 0.2
set ylabel "load over that of the law"
unset key
set label 1 "relaxed, α = 500:" at 0.0205, 1.54 tc rgb black font small
set label 2 "1300 modes, all modes" at 0.0205, 1.49 tc rgb black font small
set label 3 "α = 2000" at 0.0058, 1.49 tc rgb grey font small
set label 4 "α = 20000" at 0.00125, 1.27 tc rgb black font small
set label 5 "law, centre of mass" at 0.0011, 1.025 tc rgb blue font small
set label 6 "as printed" at 0.0045, 0.96 tc rgb red font small
set label 7 "diameter" at 0.0045, 0.86 tc rgb green font small
plot 1 with lines lw 2.2 lc rgb blue, \
     csv using 1:($4/$2) skip 1 with lines lw 2.2 lc rgb red, \
     csv using 1:($3/$2) skip 1 with lines lw 2.2 lc rgb green, \
     csv using 1:($6/$2) skip 1 with lines lw 2.4 dt (10,4,2,4) lc rgb black, \
     csv using 1:($7/$2) skip 1 with lines lw 1.2 lc rgb grey, \
     csv using 1:($8/$2) skip 1 with lines lw 2 lc rgb grey, \
     csv using 1:($9/$2) skip 1 with lines lw 2 dt (3,3) lc rgb black
