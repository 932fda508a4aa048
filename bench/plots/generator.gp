# SPDX-License-Identifier: MIT
# corgen, time and memory as the order and the digits grow: docs/speed/generator.svg from generator.csv.
stem = "generator"; home = "docs/speed"; width = 960; height = 760
load "docs/style.gp"

# Columns: 1 command, 2 fixed, 3 varied, 4 value, 5 seconds, 6 megabytes.
is(command, fixed, varied, y) = strcol(1) eq command && strcol(2) eq fixed && strcol(3) eq varied ? column(y) : NaN

set logscale xy
set multiplot layout 2,2 title "corgen, one core: time and memory" margins 0.08,0.985,0.21,0.93 spacing 0.1,0.09
do for [panel = 0:3] {
    y = panel < 2 ? 5 : 6
    set xtics (10, 20, 50, 100, 200, 500, 1000)
    set format y (panel < 2 ? power : "%g")
    if (panel < 2) { set ylabel "time (s)"; set yrange [5e-3:100]; unset xlabel } else { set ylabel "memory (MB)"; set yrange [5:1000] }
    if (panel >= 2) { set xlabel (panel % 2 ? "proved digits" : "order") }
    set xrange [8:(panel % 2 ? 1200 : 250)]
    if (panel == 0) { set key at screen 0.3,0.01 center bottom maxrows 3 } else { unset key }
    if (panel == 1) { set key at screen 0.78,0.01 center bottom maxrows 3 }
    if (panel % 2 == 0) {
        plot csv using 4:(is("series", "40 digits", "order", y)) skip 1 smooth unique with linespoints pt 7 ps 0.6 lw 1.8 lc rgb blue title "series, 40 digits", \
             csv using 4:(is("series", "100 digits", "order", y)) skip 1 with points pt 5 ps 0.8 lc rgb blue title "series, 100 digits", \
             csv using 4:(is("trajectory", "20 terms", "order", y)) skip 1 smooth unique with linespoints pt 7 ps 0.6 lw 1.8 lc rgb red title "trajectory, 20 terms, exact"
    } else {
        plot csv using 4:(is("series", "order 40", "digits", y)) skip 1 smooth unique with linespoints pt 5 ps 0.6 lw 1.8 dt (8,5) lc rgb blue title "series, order 40", \
             csv using 4:(is("collide", "beta 1", "digits", y)) skip 1 smooth unique with linespoints pt 7 ps 0.6 lw 1.8 lc rgb green title "collide, β = 1", \
             csv using 4:(is("disk-modes", "1800 modes", "digits", y)) skip 1 smooth unique with linespoints pt 7 ps 0.6 lw 1.8 lc rgb violet title "disk-modes, 1800 modes, ν = 0.33"
    }
}
unset multiplot
set output
