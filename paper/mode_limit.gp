# SPDX-License-Identifier: MIT
# Fig. 8, drawn by paper/run from mode_limit.csv.
stem = "mode_limit"; home = "docs/paper"; width = 800; height = 460
load "docs/style.gp"

# Columns: 1 speed, 2 to 7 N = 300, 400, 600, 940, 1300, 1800; limit and slope: 8, 9 of N = 300 to 940, 10, 11 of 940 up; 13 all modes at a rigid wall
stats csv using 1 skip 1 nooutput
rows = STATS_records
array v[rows]
array few[rows]
array few_slope[rows]
array many[rows]
array many_slope[rows]
stats csv using (v[int($0) + 1] = $1, few[int($0) + 1] = $8, few_slope[int($0) + 1] = $9, many[int($0) + 1] = $10, \
                 many_slope[int($0) + 1] = $11) skip 1 nooutput
array modes[6] = [300, 400, 600, 940, 1300, 1800]

set title "a disk and a rigid wall, ν = 0.33, N modes; lines through N = 300 to 940, dashed, and 940 to 1800"
set lmargin 9
set xlabel "1/√N"
set xrange [0:0.06]
set yrange [0.98:1.12]
set ytics 0.02
set ylabel "(1 − ε^2)/its limit from N = 940 to 1800" offset 0.5
set key top left
array shown[4] = [3, 7, 12, 17]
array colour[4] = [green, red, grey, blue]
plot for [k = 1:4] [0:0.06] (few[shown[k]] + few_slope[shown[k]]*x)/many[shown[k]] \
         with lines lw 1 dt (6,4) lc rgb colour[k] notitle, \
     for [k = 1:4] [0:0.034] 1 + many_slope[shown[k]]/many[shown[k]]*x with lines lw 1.6 lc rgb colour[k] notitle, \
     for [k = 1:4] for [j = 1:6] csv using (int($0) == shown[k] - 1 ? 1/sqrt(modes[j]) : NaN):(column(j + 1)/$10) \
         skip 1 with points pt 6 ps 0.7 lw 1.6 lc rgb colour[k] title (j == 1 ? sprintf("v = %g √(E/ρ)", v[shown[k]]) : ""), \
     for [k = 1:4] csv using (int($0) == shown[k] - 1 ? 0 : NaN):($13/$10) skip 1 with points pt 7 ps 0.8 lc rgb colour[k] notitle
