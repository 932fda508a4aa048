# SPDX-License-Identifier: MIT
# corgen, time against the order and the digits: docs/speed/generator.svg from generator.csv.
stem = "generator"; home = "docs/speed"; width = 960; height = 440
load "docs/style.gp"

# Columns: 1 command, 2 fixed, 3 varied, 4 value, 5 seconds, 6 megabytes.
is(command, fixed, varied) = strcol(1) eq command && strcol(2) eq fixed && strcol(3) eq varied ? column(5) : NaN

set logscale xy
set multiplot layout 1,2 title "corgen, one core: time" margins 0.08,0.985,0.13,0.9 spacing 0.09
set xtics (10, 20, 50, 100, 200, 500, 1000)
set format y power
set ylabel "time (s)" offset 0.5
set yrange [5e-3:100]
set key top left
set xlabel "order"
set xrange [8:250]
plot csv using 4:(is("series", "40 digits", "order")) skip 1 smooth unique with linespoints pt 7 ps 0.6 lw 1.8 lc rgb blue title "series, 40 digits", \
     csv using 4:(is("series", "100 digits", "order")) skip 1 with points pt 5 ps 0.8 lc rgb blue title "series, 100 digits", \
     csv using 4:(is("trajectory", "20 terms", "order")) skip 1 smooth unique with linespoints pt 7 ps 0.6 lw 1.8 lc rgb red title "trajectory, 20 terms, exact"
set xlabel "proved digits"
set xrange [8:1200]
unset ylabel
plot csv using 4:(is("series", "order 40", "digits")) skip 1 smooth unique with linespoints pt 5 ps 0.6 lw 1.8 dt (8,5) lc rgb blue title "series, order 40", \
     csv using 4:(is("collide", "beta 1", "digits")) skip 1 smooth unique with linespoints pt 7 ps 0.6 lw 1.8 lc rgb green title "collide, β = 1", \
     csv using 4:(is("disk-modes", "1800 modes", "digits")) skip 1 smooth unique with linespoints pt 7 ps 0.6 lw 1.8 lc rgb violet title "disk-modes, 1800 modes, ν = 0.33"
