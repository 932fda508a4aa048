# SPDX-License-Identifier: MIT
# Work and precision of every method: error against time per eps, independent speeds.
#     gnuplot -e "csv = 'speed.csv'; svg = 'speed.svg'" bench/plots/plot.gp
# The lines that name the gnuplot version are removed.
set output "| sed -e '/^<desc>/d' -e '/Gnuplot/d' -e '/GNUPLOT/d' > " . svg
set terminal svg size 960,660 fixed font "DejaVu Sans,12" background "white"

black = "#222222"; grey = "#777777"; blue = "#0060ad"; red = "#c8421a"
bottom = 1e-20; top = 30

set datafile separator comma
set datafile missing ""
set logscale xy
set format x "10^{%T}"
set xrange [0.03:3e5]
set yrange [bottom:top]
set xtics nomirror
set ytics nomirror ("1" 1, "10^{−2}" 1e-2, "10^{−4}" 1e-4, "10^{−6}" 1e-6, "10^{−8}" 1e-8, "10^{−10}" 1e-10, \
    "10^{−12}" 1e-12, "10^{−14}" 1e-14, "10^{−16}" 1e-16)
set border 3 lc rgb black
set grid lc rgb "#e4e4e4" lw 0.7
set xlabel "time per collision, one core, independent speeds (ns)"
set ylabel "largest relative error of ε" offset 0.5
set title "ε at an impact speed: four decades of speed, 0.3 ≤ β ≤ 1.9; blue: zero overlap, red: zero force"
set key below center maxrows 3 samplen 2 spacing 1.2 Left reverse

# Columns: 1 build, 2 scene, 3 method, 4 label, 5 curve, 6 end, 7 input, 8 form, 11 ns, 15 error.
# Drawn: the shipped build in the scene of the title, and in two decades what only knows those.
drawn(form, curve) = strcol(1) eq "shipped" && strcol(8) eq form && strcol(5) eq curve \
    && (strcol(2) eq "ordinary" || (strcol(2) eq "two decades" && strcol(3)[1:3] ne "pow"))
error(i) = column(15) > 1e-17 ? column(15) : 1e-17
y(end, form, curve) = drawn(form, curve) && strcol(6) eq end && strcol(7) eq "speed" ? error(0) : NaN
from_beta(end) = strcol(6) eq end && strcol(7) eq "beta" && (drawn("scalar", "") || drawn("array", "")) ? error(0) : NaN
copy(i) = drawn("array", "") && strcol(3) eq "copy of the array memcpy" ? bottom : NaN

# Labels stand once, at zero overlap, and at zero force where a method has no other end.
pow(i) = strcol(3)[1:3] eq "pow"
once(form) = drawn(form, "") && strcol(7) eq "speed" && (strcol(6) eq "overlap" || strcol(4) eq "pow + Müller & Pöschel") ? 1 : NaN

plot csv using (column(11)):(copy(0)):(0):(top) skip 1 with vectors nohead lw 1.5 dt (2,4) lc rgb grey \
         title "copy of the array, in the cache", \
     csv using (column(11)):(y("overlap", "scalar", "Runge-Kutta")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 dt (8,5) \
         lc rgb blue title "Runge–Kutta 5(4) in x and t", \
     csv using (column(11)):(y("force", "scalar", "Runge-Kutta")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 dt (8,5) \
         lc rgb red notitle, \
     csv using (column(11)):(y("overlap", "scalar", "Taylor")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 lc rgb blue \
         title "Taylor, polynomial form", \
     csv using (column(11)):(y("force", "scalar", "Taylor")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 lc rgb red notitle, \
     csv using (column(11)):(y("overlap", "scalar", "")) skip 1 with points pt 7 ps 0.9 lc rgb blue \
         title "one at a time", \
     csv using (column(11)):(y("force", "scalar", "")) skip 1 with points pt 7 ps 0.9 lc rgb red notitle, \
     csv using (column(11)):(y("overlap", "array", "")) skip 1 with points pt 5 ps 0.9 lc rgb blue \
         title "array, in the cache", \
     csv using (column(11)):(y("force", "array", "")) skip 1 with points pt 5 ps 0.9 lc rgb red notitle, \
     csv using (column(11)):(from_beta("overlap")) skip 1 with points pt 6 ps 0.7 lc rgb blue \
         title "from β instead of speed", \
     csv using (column(11)):(from_beta("force")) skip 1 with points pt 6 ps 0.7 lc rgb red notitle, \
     csv using (column(11)):(pow(0) ? once("scalar") * error(0) : NaN):(strcol(4)) skip 1 with labels left noenhanced \
         offset 1,0 tc rgb black font ",10" notitle, \
     csv using (column(11)):(pow(0) ? NaN : once("scalar") * error(0)):(strcol(4)) skip 1 with labels left noenhanced \
         rotate by -60 offset 0,-0.8 tc rgb black font ",10" notitle, \
     csv using (column(11)):(once("array") * error(0)):(strcol(4)) skip 1 with labels left noenhanced \
         rotate by 60 offset 0,0.8 tc rgb black font ",10" notitle
set output
