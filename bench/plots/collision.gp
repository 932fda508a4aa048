# SPDX-License-Identifier: MIT
# Collisions of a disk, error against time: docs/speed/collision.svg from disks.csv. Left: one disk and wall at
# tolerances of 1e-2 to 1e-12. Right: the errors from omitted modes and from the softness of the wall.
stem = "collision"; home = "docs/speed"; width = 1060; height = 640
if (!exists("dir")) dir = home
csv = dir."/disks.csv"
load "docs/style.gp"

# Columns: 1 table, 2 method, 3 speed, 4 setting, 5 modes, 6 seconds, 7 error
y(table, method) = strcol(1) eq table && strcol(2) eq method ? column(7) : NaN
model(n) = strcol(1) eq "collision models" && strcol(2) eq "cor" && column(3) == 0.1 && column(5) == n ? column(7) : NaN
other(method) = strcol(1) eq "collision models" && strcol(2) eq method && column(3) == 0.1 ? column(7) : NaN
ms(x) = 1e3*x

set logscale xy
set format xy power
set xlabel "time, one core (ms)"
set multiplot layout 1,2 title "a collision of a disk with a wall, ν = 0.33, v = 0.1 √(E/ρ)" \
    margins 0.07,0.985,0.32,0.88 spacing 0.085
set title "one disk and wall, tolerances 1e-2 to 1e-12: 940 modes, α = 500/R"
set ylabel "error of ε" offset 0.5
set xrange [0.8:100]
set yrange [1e-14:1e-2]
unset key
plot csv using (ms($6)):(y("collision", "cor")) skip 1 with linespoints pt 7 ps 0.8 lw 2.4 lc rgb blue

set title "modes left out and a soft wall: α = 125, 250, ... 2000/R along a line"
set ylabel "distance of ε to all modes and a rigid wall" offset 0.5
set xrange [1e-5:2000]
set yrange [3e-6:1]
set key at screen 0.77,0.01 center bottom maxrows 4
array modes[6] = [56, 112, 225, 450, 900, 1800]
array colour[6] = [grey, amber, red, green, violet, blue]
plot for [k = 1:6] csv using (ms($6)):(model(modes[k])) skip 1 \
         with linespoints pt 7 ps 0.5 lw 1.6 lc rgb colour[k] title sprintf("%d modes", modes[k]), \
     csv using (ms($6)):(other("cor_disk_eps")) skip 1 with points pt 5 ps 1 lc rgb blue title "cor\\_disk\\_eps (its uncertainty)", \
     csv using (ms($6)):(other("Rayleigh")) skip 1 with points pt 2 ps 1 lw 1.6 lc rgb black title "Rayleigh’s energy"
