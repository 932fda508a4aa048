# SPDX-License-Identifier: MIT
# Rayleigh's energy of a disk, error against time: of all modes, and of every mode.
#     gnuplot -e "csv = 'disk.csv'; svg = 'disk_speed.svg'" bench/plots/plot_disk.gp
# The lines that name the gnuplot version are removed.
set output "| sed -e '/^<desc>/d' -e '/Gnuplot/d' -e '/GNUPLOT/d' > " . svg
set terminal svg size 960,520 fixed font "DejaVu Sans,12" background "white"

black = "#222222"; grey = "#777777"; blue = "#0060ad"; red = "#c8421a"

set datafile separator comma
set datafile missing ""
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [1e-5:10]
set xtics nomirror
set ytics nomirror
set border 3 lc rgb black
set grid lc rgb "#e4e4e4" lw 0.7
set xlabel "time, one core (s)"

# Columns: 1 table, 2 method, 5 modes, 6 seconds, 7 error.
y(table, method) = strcol(1) eq table && strcol(2) eq method ? column(7) : NaN
number(table, method) = y(table, method) * (column(5) == 3 || column(5) == 100 || column(5) == 1800 || column(5) == 20000)

set multiplot layout 1,2 title "Rayleigh's energy of a disk, ν = 0.33, v = 10^{−3}" margins 0.08,0.98,0.27,0.87 spacing 0.1

set title "energy left in all modes"
set ylabel "relative error" offset 0.5
set yrange [1e-7:1]
set key at screen 0.53,0.02 center bottom maxrows 2 samplen 2 spacing 1.3 width 2 Left reverse
plot csv using 6:(y("energy", "Runge-Kutta")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 dt (8,5) lc rgb grey \
         title "Runge–Kutta 5(4) of (65) to (67)", \
     csv using 6:(y("energy", "cosines")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 lc rgb black \
         title "cosine integrals on the real axis", \
     csv using 6:(y("energy", "truncation")) skip 1 with linespoints pt 5 ps 0.6 lw 1.8 lc rgb red \
         title "cor, the sum alone", \
     csv using 6:(y("energy", "cor")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 lc rgb blue \
         title "cor, to a tolerance", \
     csv using 6:(y("energy", "truncation") > 0 && number("energy", "truncation") > 0 ? column(7) : NaN):(column(5) == 3 ? "3 modes" : strcol(5)) skip 1 with labels left \
         offset 0.6,0.4 tc rgb black font ",10" notitle

set title "the fraction of each of 1800 modes"
set yrange [1e-13:1]
unset ylabel
unset key
plot csv using 6:(y("modes", "Runge-Kutta")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 dt (8,5) lc rgb grey, \
     csv using 6:(y("modes", "cosines")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 lc rgb black, \
     csv using 6:(y("modes", "cor")) skip 1 with points pt 7 ps 1 lc rgb blue
unset multiplot
set output
