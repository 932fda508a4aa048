# SPDX-License-Identifier: MIT
# corgen: time and memory as the order and the digits grow.
#     gnuplot -e "csv = 'generator.csv'; svg = 'generator.svg'" bench/plots/plot_generator.gp
# The lines that name the gnuplot version are removed.
set output "| sed -e '/^<desc>/d' -e '/Gnuplot/d' -e '/GNUPLOT/d' > " . svg
set terminal svg size 960,760 fixed font "DejaVu Sans,12" background "white"

black = "#222222"; blue = "#0060ad"; red = "#c8421a"; green = "#2a7f3b"; violet = "#7b3f99"

set datafile separator comma
set logscale xy
set format x "10^{%T}"
set xtics nomirror
set ytics nomirror
set border 3 lc rgb black
set grid lc rgb "#e4e4e4" lw 0.7

# Columns: 1 command, 2 fixed, 3 varied, 4 value, 5 seconds, 6 megabytes.
is(command, fixed, varied) = strcol(1) eq command && strcol(2) eq fixed && strcol(3) eq varied ? column(4) : NaN

set multiplot layout 2,2 title "corgen, one core" font ",14" margins 0.09,0.98,0.16,0.92 spacing 0.1,0.09
do for [panel = 0:3] {
    set yrange [5:1000]
    if (panel % 2 == 0) { set ylabel (panel < 2 ? "order" : "digits") } else { unset ylabel }
    if (panel >= 2) { set xlabel (panel == 2 ? "time (s)" : "memory (MB)") } else { unset xlabel }
    x = panel % 2 == 0 ? 5 : 6
    if (panel % 2 == 0) { set xrange [3e-3:100] } else { set xrange [5:1000] }
    if (panel == 0) { set key at screen 0.5,0.01 center bottom maxrows 2 samplen 2 width 1 Left reverse } else { unset key }
    if (panel < 2) {
        plot csv using x:(is("series", "40 digits", "order")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 lc rgb blue title "series, 40 digits", \
             csv using x:(is("series", "100 digits", "order")) skip 1 with points pt 5 ps 0.8 lc rgb blue title "series, 100 digits", \
             csv using x:(is("trajectory", "20 terms", "order")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 lc rgb red title "trajectory, 20 terms, exact", \
             NaN with linespoints pt 5 ps 0.6 lw 1.8 dt (8,5) lc rgb blue title "series, order 40", \
             NaN with linespoints pt 7 ps 0.6 lw 1.8 lc rgb green title "collide, β = 1", \
             NaN with linespoints pt 7 ps 0.6 lw 1.8 lc rgb violet title "disk-modes, 1800 modes"
    } else {
        plot csv using x:(is("series", "order 40", "digits")) skip 1 with linespoints pt 5 ps 0.6 lw 1.8 dt (8,5) lc rgb blue, \
             csv using x:(is("collide", "beta 1", "digits")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 lc rgb green, \
             csv using x:(is("disk-modes", "1800 modes", "digits")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 lc rgb violet
    }
}
unset multiplot
set output
