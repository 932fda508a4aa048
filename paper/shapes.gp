# SPDX-License-Identifier: MIT
# Fig. 2, drawn by paper/run from shapes.csv: one block for each mode, one curve for each circle and radius.
stem = "shapes"; home = "docs/paper"; width = 960; height = 370
load "docs/style.gp"

# before the ranges are set, because stats would apply them
array n[3]
array omega[3]
do for [i = 0:2] {
    stats csv using 1 index i skip (i == 0) nooutput
    n[i + 1] = STATS_max
    stats csv using 3 index i skip (i == 0) nooutput
    omega[i + 1] = STATS_max
}

set multiplot layout 1,3 title "the three lowest modes of a free disk, ν = 0.33; frequency ω in √(E/ρ)/R" margins 0.01,0.99,0.02,0.79 spacing 0.01
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.36:1.36]
set yrange [-1.28:1.28]
set object 1 circle at 0,0 size 1 behind fillstyle empty border lc rgb grey lw 1.2 dt (5,5)
do for [i = 0:2] {
    set title sprintf("n = %d, l = 0:  ω = %.4f", n[i + 1], omega[i + 1])
    plot csv using 5:(strcol(4) eq "rim" ? NaN : $6) index i skip (i == 0) with lines lw 1 lc rgb blue, \
         csv using 5:(strcol(4) eq "rim" ? $6 : NaN) index i skip (i == 0) with lines lw 3 lc rgb blue
}
