# SPDX-License-Identifier: MIT
# Fig. 11, drawn by paper/run from contact.csv.
stem = "contact"; home = "docs/paper"; width = 960; height = 470
load "docs/style.gp"
points = dir."/collisions.csv"
limit = dir."/rigid_wall.csv"

# Columns: 1 speed; contact time: 2 centre of mass, 3 diameter, 4 as printed, 5 leading logarithm; largest compression:
# 6 to 9 likewise
# rigid_wall.csv: 2 speed, 6 contact time, 7 largest compression
# collisions.csv: 1 nu, 2 modes, 3 alpha, 4 speed, 7 contact time, 8 largest compression
chosen(nu, modes, alpha, speed) = nu == 0.33 && modes == 1800 && alpha*speed > 99

set multiplot layout 1,2 title "a disk and a wall, ν = 0.33: the law by datum, and the dynamics of 1800 modes with α v ≥ 100 √(E/ρ)/R" \
    margins 0.06,0.985,0.125,0.85 spacing 0.085
set logscale x
set format x "10^{%L}"
set xrange [1e-6:0.5]
set xlabel "impact speed v (√(E/ρ))"

set key bottom left
array datum[3] = ["diameter", "as printed", "centre of mass"]
array column_of[3] = [3, 4, 2]
array colour[3] = [green, red, blue]
do for [q = 0:1] {
    set title q == 0 ? "contact time" : "largest compression over speed"
    set ylabel (q == 0 ? "τ" : "δ_{max}/v")." (R √(ρ/E))" offset 0.5
    set yrange [0:(q == 0 ? 14 : 4.5)]
    tick = 2 - q
    set ytics tick
    per(speed) = q == 0 ? 1 : speed
    plot for [k = 1:3] csv using 1:(column(column_of[k] + 4*q)/per($1)) skip 1 \
             with lines lw 2.2 lc rgb colour[k] title datum[k], \
         csv using 1:(column(5 + 4*q)/per($1)) skip 1 with lines lw 2 dt (8,5) lc rgb grey title "leading logarithm, (61)", \
         limit using 2:(column(6 + q)/per($2)) index 0 skip 1 with lines lw 1.6 lc rgb black title "all modes, rigid wall", \
         points using (chosen($1, $2, $3, $4) ? $4 : NaN):(column(7 + q)/per($4)) skip 1 \
             with points pt 12 ps 0.65 lw 1.3 lc rgb black title "full dynamics"
}
