# SPDX-License-Identifier: MIT
# Fig. 7, drawn by paper/run from collisions.csv and, the lines, wall_limit.csv.
stem = "wall_limit"
set terminal svg size 960,480 fixed font "DejaVu Sans,13" background "white"
load "paper/style.gp"
points = dir."/collisions.csv"

# Columns of collisions: 1 nu, 2 modes, 3 alpha, 4 speed, 5 converged, 6 1 - eps^2; of wall_limit: 1 speed, 2 modes,
# 3 limit, 4 slope, 5 all modes at a rigid wall
stats csv using 1 skip 1 nooutput
rows = STATS_records
array v[rows]
array limit[rows]
array slope[rows]
stats csv using (v[int($0) + 1] = $1, limit[int($0) + 1] = $3, slope[int($0) + 1] = $4) skip 1 nooutput
is(nu, modes, speed, i) = nu == 0.33 && modes == 940 && abs(speed/v[i] - 1) < 1e-6

set multiplot layout 1,2 margins 0.08,0.985,0.125,0.91 spacing 0.1
unset key
set title "ν = 0.33, N = 940, v = 0.005 ... 0.30"
set xrange [0:0.0042]
set yrange [0:0.32]
set xtics 0.001
set ytics 0.05
set xlabel "1/α (R)"
set ylabel "1 − ε^2" offset 1
plot for [i = 1:rows] [0:v[i]/20] limit[i] + slope[i]*x with lines lw 1.2 lc rgb blue, \
     for [i = 1:rows] points using (is($1, $2, $4, i) ? 1/$3 : NaN):6 skip 1 with points pt 6 ps 0.5 lw 1.4 lc rgb red, \
     csv using (0):5 skip 1 with points pt 7 ps 0.5 lc rgb black

set title "over its limit, against 1/(α v)"
set xrange [0:0.105]
set yrange [0.6:1.02]
set xtics 0.02
set ytics 0.1
set xlabel "1/(α v)"
set ylabel "(1 − ε^2) over its limit" offset 1
set key bottom left
array shown[4] = [17, 7, 4, 1]
array colour[4] = [blue, red, green, grey]
plot for [k = 1:4] [0:0.045] 1 + slope[shown[k]]*v[shown[k]]/limit[shown[k]]*x \
         with lines lw 1.4 lc rgb colour[k] notitle, \
     for [k = 1:4] points using (is($1, $2, $4, shown[k]) ? 1/($3*$4) : NaN):($6/limit[shown[k]]) skip 1 \
         with points pt 6 ps 0.7 lw 1.6 lc rgb colour[k] title sprintf("v = %g", v[shown[k]])
unset multiplot
set output
