# SPDX-License-Identifier: MIT
# Rayleigh's energy of a disk, error against time: docs/speed/rayleigh.svg from disks.csv.
stem = "rayleigh"; home = "docs/speed"; width = 640; height = 500
if (!exists("dir")) dir = home
csv = dir."/disks.csv"
load "docs/style.gp"

# Columns: 1 table, 2 method, 5 modes, 6 seconds, 7 error.
y(table, method) = strcol(1) eq table && strcol(2) eq method ? column(7) : NaN
named(n) = n == 3 || n == 100 || n == 1800 || n == 20000
is_named(i) = strcol(1) eq "energy" && strcol(2) eq "truncation" && named(column(5)) ? column(7) : NaN
ms(x) = 1e3*x

set style textbox opaque noborder margins 0.3,0.3 fillcolor rgb "white"
set logscale xy
set format xy power
set xrange [0.03:1e4]
set xlabel "time, one core (ms)"
set title "Rayleigh's energy in all modes of a disk, ν = 0.33, v = 0.001 √(E/ρ)"
set bmargin at screen 0.25
set ylabel "relative error" offset 0.5
set yrange [1e-8:1]
set key at screen 0.53,0.01 center bottom maxrows 2 width 2
plot csv using (ms($6)):(y("energy", "truncation")) skip 1 with linespoints pt 5 ps 0.5 lw 1.8 lc rgb red \
         title "cor, the sum over as many modes as written", \
     csv using (ms($6)):(y("energy", "cor")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 lc rgb blue \
         title "cor, to a tolerance", \
     csv using (ms($6)):(is_named(0)):(strcol(5)) skip 1 with labels left boxed offset 0.8,0 tc rgb red font small notitle
