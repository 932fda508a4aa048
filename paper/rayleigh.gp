# SPDX-License-Identifier: MIT
# Fig. 12, drawn by paper/run from rayleigh.csv.
stem = "rayleigh"; home = "docs/paper"; width = 960; height = 490
load "docs/style.gp"
full = dir."/restitution.csv"
slow = dir."/oscillation.csv"
limit = dir."/rigid_wall.csv"

# Columns: 1 speed; nu = 0.33: 2 to 4 centre of mass (1800 modes, all modes, quadrupole), 5 to 7 diameter, 8 to 10 as
# printed; nu = 0.9: 11 to 19 likewise. Of restitution.csv: 2 speed, 6 1 - eps^2, one block for each nu; of
# oscillation.csv: 1 speed, 2 1 - eps^2; of rigid_wall.csv: 2 speed, 3 1 - eps^2, one block for each nu
set multiplot layout 1,2 title "Rayleigh's energy of a disk by datum, and 1 − ε^2  of the dynamics at a rigid wall" \
    margins 0.08,0.985,0.12,0.85 spacing 0.085
set logscale xy
set format "10^{%L}"
set xrange [1e-6:0.1]
set yrange [1e-3:3]
set xlabel "impact speed v (√(E/ρ))"
set object 1 rectangle from 0.03, graph 0 to 0.1, graph 1 fc rgb shade fillstyle solid noborder behind
set label 1 "beyond the theory" at 0.026, 1.9 right tc rgb grey font small
set key top left

set ylabel "energy left in the modes/(m v^2/2)" offset 0.5
array datum[3] = ["centre of mass", "as printed", "diameter"]
array column_of[3] = [2, 8, 5]
array colour[3] = [blue, red, green]
do for [nu = 0:1] {
    set title nu == 0 ? "ν = 0.33" : "ν = 0.9"
    plot for [k = 1:3] csv using 1:column_of[k] + 9*nu skip 1 with lines lw 2.4 lc rgb colour[k] title datum[k], \
         for [k = 1:3] csv using 1:column_of[k] + 9*nu + 2 skip 1 with lines lw 1.2 dt (4,3) lc rgb colour[k] \
             title (k == 1 ? "quadrupole alone" : ""), \
         limit using 2:3 index nu skip (nu == 0) with lines lw 1.8 lc rgb black title "all modes, rigid wall", \
         slow using 1:(nu == 0 ? $2 : NaN) skip 1 \
             with points pt 12 ps 0.65 lw 1.3 lc rgb black title "full dynamics, extrapolated", \
         full using 2:6 index nu skip (nu == 0) with points pt 12 ps 0.65 lw 1.3 lc rgb black notitle
    unset key
}
