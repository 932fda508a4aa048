# SPDX-License-Identifier: MIT
# Rayleigh's energy of a disk, error against time.
#     gnuplot -e "csv = 'rayleigh.csv'; svg = 'rayleigh.svg'" bench/plots/plot_rayleigh.gp
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

# Columns: 1 quantity, 2 method, 4 modes, 5 seconds, 6 error.
y(quantity, method) = strcol(1) eq quantity && strcol(2) eq method ? column(6) : NaN
number(quantity, method) = y(quantity, method) * (column(4) == 3 || column(4) == 100 || column(4) == 1800 || column(4) == 20000)

set multiplot layout 1,2 title "Rayleigh's energy of a disk, ν = 0.33, v = 10^{−3}" margins 0.08,0.98,0.27,0.87 spacing 0.1
set title "energy left in all modes"
set ylabel "relative error" offset 0.5
set yrange [1e-9:1]
set key at screen 0.53,0.02 center bottom maxrows 2 samplen 2 spacing 1.3 width 2 Left reverse
plot csv using 5:(y("energy", "Runge-Kutta")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 dt (8,5) lc rgb grey \
         title "Runge–Kutta 5(4) of (65) to (67)", \
     csv using 5:(y("energy", "cosines")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 lc rgb black \
         title "cosine integrals on the real axis", \
     csv using 5:(y("energy", "truncation")) skip 1 with linespoints pt 5 ps 0.6 lw 1.8 lc rgb red \
         title "cor, the sum of 3 to 20000 modes alone", \
     csv using 5:(y("energy", "cor")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 lc rgb blue \
         title "cor, to a tolerance", \
     csv using 5:(y("energy", "truncation") > 0 && number("energy", "truncation") > 0 ? column(6) : NaN):(strcol(4)) skip 1 \
         with labels left offset 0.6,0.4 tc rgb black font ",10" notitle
set title "the fraction of each of 1800 modes"
set yrange [1e-13:1]
unset ylabel
unset key
plot csv using 5:(y("modes", "Runge-Kutta")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 dt (8,5) lc rgb grey, \
     csv using 5:(y("modes", "cosines")) skip 1 with linespoints pt 7 ps 0.6 lw 1.8 lc rgb black, \
     csv using 5:(y("modes", "cor")) skip 1 with points pt 7 ps 1 lc rgb blue
unset multiplot
set output
