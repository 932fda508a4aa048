# SPDX-License-Identifier: MIT
# Fig. 10, the dynamic curves, drawn by paper/run from load_dynamic.csv and load.csv.
stem = "load_dynamic"; home = "docs/paper"; width = 960; height = 460
load "docs/style.gp"
static = dir."/load.csv"

# Columns: 1 speed, 2 time, 3 compression, 4 load, one block for each speed. Of load.csv: 1 compression, 2 law, centre
# of mass, 6 relaxed, 1300 modes, alpha = 500

# Arrows along the curves, one for each tenth of the time
array from_x[20]
array from_y[20]
array to_x[20]
array to_y[20]
do for [k = 0:1] {
    stats csv using 2 index k skip (k == 0) nooutput
    first = STATS_min
    whole = STATS_max - STATS_min
    do for [i = 0:9] {
        at = first + (i + 0.4)*whole/10
        stats csv using ($2 >= at && $2 <= at + 0.04*whole ? $3 : NaN):4 index k skip (k == 0) nooutput
        up = i < 5
        from_x[10*k + i + 1] = up ? STATS_min_x : STATS_max_x
        to_x[10*k + i + 1] = up ? STATS_max_x : STATS_min_x
        from_y[10*k + i + 1] = up ? STATS_min_y : STATS_max_y
        to_y[10*k + i + 1] = up ? STATS_max_y : STATS_min_y
    }
}

set multiplot layout 1,2 title "collisions of a disk with a wall: ν = 0.33, α = 500/R, 1300 modes" margins 0.08,0.985,0.125,0.85 spacing 0.085
set key top left
set xlabel "compression δ (R)"
do for [k = 0:1] {
    set title sprintf("v = %s √(E/ρ)", k == 0 ? "0.1" : "0.04")
    set xrange [-0.005:(k == 0 ? 0.175 : 0.08)]
    set yrange [0:(k == 0 ? 0.22 : 0.09)]
    tick = k == 0 ? 0.05 : 0.02
    set xtics tick
    set ytics tick
    set ylabel "load P (E R)" offset 0.5
    unset arrow
    do for [i = 1:8] {
        if (i != 4 && i != 5) {
            j = 10*k + i + 1
            set arrow from from_x[j],from_y[j] to to_x[j],to_y[j] \
                head filled size (k == 0 ? 0.004 : 0.0018),20 lw 1.6 lc rgb red front
        }
    }
    plot static using 1:2 skip 1 with lines lw 2 lc rgb blue title "law, centre of mass", \
         static using 1:6 skip 1 with lines lw 2 dt (10,4,2,4) lc rgb black title "relaxed disk", \
         csv using 3:4 index k skip (k == 0) with lines lw 1.5 lc rgb red title "collision"
}
