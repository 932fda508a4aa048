# SPDX-License-Identifier: MIT
# Fig. 7, drawn by paper/run from collisions.csv and, the lines, wall_limit.csv.
stem = "wall_limit"; home = "docs/paper"; width = 800; height = 460
load "docs/style.gp"
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

set title "a disk of 940 modes and a wall exp(α x), ν = 0.33; lines through α v ≥ 25 √(E/ρ)/R"
set lmargin 9
set xrange [-0.0005:0.1]
set yrange [0.6:1.02]
set xtics 0.02
set ytics 0.1
set xlabel "1/(α v)  (R √(ρ/E))"
set ylabel "(1 − ε^2)/its limit at a rigid wall, 940 modes" offset 0.5
set key bottom left
array shown[4] = [17, 7, 4, 1]
array colour[4] = [blue, red, green, grey]
plot for [k = 1:4] [0:0.045] 1 + slope[shown[k]]*v[shown[k]]/limit[shown[k]]*x \
         with lines lw 1.4 lc rgb colour[k] notitle, \
     for [k = 1:4] points using (is($1, $2, $4, shown[k]) ? 1/($3*$4) : NaN):($6/limit[shown[k]]) skip 1 \
         with points pt 6 ps 0.7 lw 1.6 lc rgb colour[k] title sprintf("v = %g √(E/ρ)", v[shown[k]]), \
     for [k = 1:4] csv using (int($0) == shown[k] - 1 ? 0 : NaN):($5/$3) skip 1 with points pt 7 ps 0.8 \
         lc rgb colour[k] notitle, \
     NaN with points pt 7 ps 0.8 lc rgb black title "all modes at a rigid wall"
