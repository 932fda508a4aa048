# SPDX-License-Identifier: MIT
# The errors of models of collisions of disks: docs/speed/left_out_disks.svg, drawn by bench/plots/left_out from rows
# of corgen plan --disks.
stem = "left_out_disks"; home = "docs/speed"; width = 1060; height = 560
load "docs/style.gp"

# Columns: 1 model, 2 speed, 3 error, 4 uncertainty of the reference
of(name) = strcol(1) eq name ? column(3) : NaN
band(name) = strcol(1) eq name ? column(4) : NaN
array modes[4] = ["10", "100", "940", "3600"]
set logscale xy
set xrange [0.003:0.3]
set yrange [1e-4:1]
set format y power
set xtics (0.003, 0.01, 0.03, 0.1, 0.3)
set xlabel "impact speed v (√(E/ρ))"
set multiplot layout 1,3 title "models of a collision of a disk with a rigid wall, ν = 0.33; α in 1/R" \
    margins 0.065,0.99,0.31,0.88 spacing 0.075
set title "restitution"
set ylabel "error of ε" offset 1
set key at screen 0.02,0.01 left bottom maxrows 5 spacing 1.05 font small
csv = rows."/eps.csv"
plot csv using 2:(1e-4):(band("eps = 1")) skip 1 with filledcurves fc rgb shade title "below the reference’s uncertainty", \
     csv using 2:(of("eps = 1")) skip 1 with lines lw 2 dt (6,4) lc rgb black title "ε = 1", \
     csv using 2:(of("Rayleigh: 1000 modes and tail")) skip 1 with lines lw 2 lc rgb green title "Rayleigh, 1000 modes and tail", \
     for [k = 1:4] csv using 2:(of("dynamics: ".modes[k]." modes; alpha = 56/v")) skip 1 \
         with lines lw 2 lc rgb blues[k] title modes[k]." modes, α = 56/v", \
     csv using 2:(of("dynamics: 1800 modes; alpha = 22/v")) skip 1 with lines lw 2 dt (8,3) lc rgb red title "1800 modes, α = 22/v", \
     csv using 2:(of("dynamics: 1800 modes; alpha = 11/v")) skip 1 with lines lw 2 lc rgb red title "1800 modes, α = 11/v", \
     csv using 2:(of("dynamics: 940 modes; alpha = 500")) skip 1 with lines lw 1.6 dt (2,2) lc rgb grey title "940 modes, α = 500"
do for [q in "contact-time compression"] {
    csv = rows."/".q.".csv"
    set title q eq "compression" ? "largest compression" : "contact time"
    set ylabel "relative error of ".(q eq "compression" ? "δ_{max}" : "τ")
    if (q eq "compression") { unset key } else { set key at screen 0.665,0.01 left bottom maxrows 5 }
    plot csv using 2:(1e-4):(band("leading logarithm (61)")) skip 1 with filledcurves fc rgb shade notitle, \
         csv using 2:(of("leading logarithm (61)")) skip 1 with lines lw 2 dt (6,4) lc rgb black title "leading logarithm, (61)", \
         csv using 2:(of("quasistatic law: centre of mass")) skip 1 with lines lw 2 lc rgb green title "law (57), from the centre of mass", \
         csv using 2:(of("quasistatic law: as printed")) skip 1 with lines lw 2 dt (8,3) lc rgb green title "law (57), as printed", \
         for [k = 1:3] csv using 2:(of("dynamics: ".modes[k]." modes; alpha = 56/v")) skip 1 \
             with lines lw 2 lc rgb blues[k] notitle, \
         csv using 2:(of("dynamics: 1800 modes; alpha = 11/v")) skip 1 with lines lw 2 lc rgb red notitle
}
