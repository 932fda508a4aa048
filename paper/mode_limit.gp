# SPDX-License-Identifier: MIT
# Fig. 8, drawn by paper/run from mode_limit.csv.
stem = "mode_limit"; home = "docs/paper"; width = 960; height = 520
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

set multiplot layout 1,2 title "a disk and a rigid wall (α → ∞), ν = 0.33, N modes; lines through N = 300 to 940, dashed, and 940 to 1800, full; black: all modes" \
    margins 0.085,0.985,0.12,0.86 spacing 0.09
set title "each line one speed v (√(E/ρ))"
set xrange [0:0.07]
set yrange [0:0.32]
set xtics 0.02
set mxtics 2
set ytics 0.05
set xlabel "1/√N"
set ylabel "1 − ε^2" offset 0.3
unset key
do for [i = 3:rows:2] {
    set label i sprintf(i == rows ? "v = %g" : "%g", v[i]) at 0.059, few[i] + few_slope[i]*0.0577 font small tc rgb black
}
plot for [i = 1:rows] [0:0.058] few[i] + few_slope[i]*x with lines lw 1 dt (6,4) lc rgb grey notitle, \
     for [i = 1:rows] [0:0.034] many[i] + many_slope[i]*x with lines lw 1.6 lc rgb blue notitle, \
     for [k = 1:6] csv using (1/sqrt(modes[k])):(column(k + 1)) skip 1 with points pt 6 ps 0.5 lw 1.4 lc rgb red notitle, \
     csv using (0):13 skip 1 with points pt 7 ps 0.5 lc rgb black notitle

unset label
set xrange [0:0.06]
set title "relative to the limit from N = 940 to 1800"
set yrange [0.98:1.12]
set ytics 0.02
set ylabel "(1 − ε^2)/its limit" offset 1
set key top left
array shown[4] = [3, 7, 12, 17]
array colour[4] = [green, red, grey, blue]
plot for [k = 1:4] [0:0.06] (few[shown[k]] + few_slope[shown[k]]*x)/many[shown[k]] \
         with lines lw 1 dt (6,4) lc rgb colour[k] notitle, \
     for [k = 1:4] [0:0.034] 1 + many_slope[shown[k]]/many[shown[k]]*x with lines lw 1.6 lc rgb colour[k] notitle, \
     for [k = 1:4] for [j = 1:6] csv using (int($0) == shown[k] - 1 ? 1/sqrt(modes[j]) : NaN):(column(j + 1)/$10) \
         skip 1 with points pt 6 ps 0.7 lw 1.6 lc rgb colour[k] title (j == 1 ? sprintf("v = %g √(E/ρ)", v[shown[k]]) : ""), \
     for [k = 1:4] csv using (int($0) == shown[k] - 1 ? 0 : NaN):($13/$10) skip 1 with points pt 7 ps 0.8 lc rgb colour[k] notitle
unset multiplot
set output
