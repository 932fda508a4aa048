# SPDX-License-Identifier: MIT
# Fig. 5, drawn by paper/run from sequence.csv: one block for each moment, one curve for each circle and radius.
stem = "sequence"; home = "docs/paper"; width = 1000; height = 470
load "docs/style.gp"

set multiplot layout 2,5 title "a disk and a wall (grey), true to scale: ν = 0.33, v = 0.2 √(E/ρ), α = 500/R, 940 modes; time t in R √(ρ/E)" \
    margins 0.005,0.995,0.01,0.86 spacing 0.004,0.075
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-2.84:0.16]
set yrange [-1.3:1.3]
set object 1 rectangle from 0,-1.3 to 0.16,1.3 fc rgb light fillstyle solid noborder behind
set arrow 1 from 0,-1.3 to 0,1.3 nohead lw 1.5 lc rgb black
do for [i = 0:9] {
    set title sprintf("t = %d", i) offset 0,-0.7
    plot csv using 3:(strcol(2) eq "rim" ? NaN : $4) index i skip (i == 0) with lines lw 0.9 lc rgb blue, \
         csv using 3:(strcol(2) eq "rim" ? $4 : NaN) index i skip (i == 0) with lines lw 2.4 lc rgb blue
}
