# SPDX-License-Identifier: MIT
# Fig. 11, drawn by paper/run from contact.csv.
stem = "contact"; home = "docs/paper"; width = 960; height = 470
load "docs/style.gp"
points = dir."/collisions.csv"
limit = dir."/rigid_wall.csv"

# Columns: 1 speed; contact time: 2 centre of mass, 3 diameter, 4 as printed, 5 leading logarithm; largest compression:
# 6 to 9 likewise
# Of rigid_wall.csv: 2 speed, 6 contact time, 7 largest compression
# Of collisions.csv: 1 nu, 2 modes, 3 alpha, 4 speed, 7 contact time, 8 largest compression
chosen(nu, modes, alpha, speed) = nu == 0.33 && modes == 1800 && alpha*speed > 99

set multiplot layout 1,2 title "a disk and a wall, ν = 0.33: the law by datum, and the dynamics of 1800 modes with α v ≥ 100 √(E/ρ)/R" \
    margins 0.06,0.985,0.125,0.85 spacing 0.085
set logscale x
set format x "10^{%L}"
set xrange [1e-6:0.5]
set xlabel "impact speed v (√(E/ρ))"

set title "contact time"
set ylabel "τ (R √(ρ/E))" offset 0.5
set yrange [0:14]
set ytics 2
set key bottom left
plot csv using 1:3 skip 1 with lines lw 2.2 lc rgb green title "diameter", \
     csv using 1:4 skip 1 with lines lw 2.2 lc rgb red title "as printed", \
     csv using 1:2 skip 1 with lines lw 2.2 lc rgb blue title "centre of mass", \
     csv using 1:5 skip 1 with lines lw 2 dt (8,5) lc rgb grey title "leading logarithm, (61)", \
     limit using 2:6 index 0 skip 1 with lines lw 1.6 lc rgb black title "all modes, rigid wall", \
     points using (chosen($1, $2, $3, $4) ? $4 : NaN):7 skip 1 \
         with points pt 12 ps 0.65 lw 1.3 lc rgb black title "full dynamics"

set title "largest compression over speed"
set ylabel "δ_{max}/v (R √(ρ/E))" offset 0.5
set yrange [0:4.5]
set ytics 1
plot csv using 1:($7/$1) skip 1 with lines lw 2.2 lc rgb green title "diameter", \
     csv using 1:($8/$1) skip 1 with lines lw 2.2 lc rgb red title "as printed", \
     csv using 1:($6/$1) skip 1 with lines lw 2.2 lc rgb blue title "centre of mass", \
     csv using 1:($9/$1) skip 1 with lines lw 2 dt (8,5) lc rgb grey title "leading logarithm, (61)", \
     limit using 2:($7/$2) index 0 skip 1 with lines lw 1.6 lc rgb black title "all modes, rigid wall", \
     points using (chosen($1, $2, $3, $4) ? $4 : NaN):($8/$4) skip 1 \
         with points pt 12 ps 0.65 lw 1.3 lc rgb black title "full dynamics"
