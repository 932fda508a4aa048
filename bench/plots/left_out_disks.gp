# SPDX-License-Identifier: MIT
# What models of collisions of disks leave out: drawn by bench/plots/left_out from rows of corgen plan --disks.
# The lines that name the gnuplot version are removed.
set output "| sed -e '/^<desc>/d' -e '/Gnuplot/d' -e '/GNUPLOT/d' > docs/speed/left_out_disks.svg"
set terminal svg size 960,660 fixed font "DejaVu Sans,12" background "white"
black = "#222222"; grey = "#888888"; light = "#e4e4e4"; blue = "#0060ad"; red = "#c8421a"; green = "#3a7d34"
set datafile separator comma
set datafile missing "nan"
set logscale xy
set border 3 lc rgb black
set tics nomirror
set grid lc rgb light lw 0.7
set xrange [0.003:0.3]
set yrange [1e-5:1]
set format y "10^{%T}"
set xtics (0.003, 0.01, 0.03, 0.1, 0.3)
set xlabel "speed (√(E/ρ))"
set key below maxrows 5 samplen 2 spacing 1.05 reverse Left font ",9"

# Columns: 1 model, 2 speed, 4 error, 6 uncertainty of what it is compared with
of(name) = strcol(1) eq name ? column(4) : NaN
band(name) = strcol(1) eq name ? column(6) : NaN
set multiplot layout 1,3 margins 0.07,0.99,0.36,0.93 spacing 0.055
set title "ε, error (ν = 0.33)"
csv = dir."/eps.csv"
plot csv using 2:(1e-5):(band("eps = 1")) skip 1 with filledcurves fc rgb "#f1f0ea" title "not known better", \
     csv using 2:(of("eps = 1")) skip 1 with lines lw 2 dt (6,4) lc rgb black title "ε = 1", \
     csv using 2:(of("Rayleigh: 1000 modes and tail")) skip 1 with lines lw 2 lc rgb green title "Rayleigh", \
     csv using 2:(of("dynamics: 10 modes; alpha = 56/v")) skip 1 with lines lw 2 lc rgb "#b9d8f0" title "10 modes, α = 56/v", \
     csv using 2:(of("dynamics: 100 modes; alpha = 56/v")) skip 1 with lines lw 2 lc rgb "#6aaade" title "100 modes", \
     csv using 2:(of("dynamics: 940 modes; alpha = 56/v")) skip 1 with lines lw 2 lc rgb blue title "940 modes", \
     csv using 2:(of("dynamics: 3600 modes; alpha = 56/v")) skip 1 with lines lw 2 lc rgb "#003a6b" title "3600 modes", \
     csv using 2:(of("dynamics: 1800 modes; alpha = 22/v")) skip 1 with lines lw 2 dt (8,3) lc rgb red title "1800, α = 22/v", \
     csv using 2:(of("dynamics: 1800 modes; alpha = 11/v")) skip 1 with lines lw 2 lc rgb red title "1800, α = 11/v", \
     csv using 2:(of("dynamics: 940 modes; alpha = 500")) skip 1 with lines lw 1.4 dt (2,2) lc rgb grey title "940, α = 500"
do for [q in "contact-time compression"] {
    csv = dir."/".q.".csv"
    set title q eq "compression" ? "largest compression, relative" : "contact time, relative"
    plot csv using 2:(1e-5):(band("leading logarithm (61)")) skip 1 with filledcurves fc rgb "#f1f0ea" title "not known better", \
         csv using 2:(of("leading logarithm (61)")) skip 1 with lines lw 2 dt (6,4) lc rgb black title "leading logarithm", \
         csv using 2:(of("quasistatic law: centre of mass")) skip 1 with lines lw 2 lc rgb green title "law, centre of mass", \
         csv using 2:(of("quasistatic law: as printed")) skip 1 with lines lw 2 dt (8,3) lc rgb green title "law, as printed", \
         csv using 2:(of("dynamics: 10 modes; alpha = 56/v")) skip 1 with lines lw 2 lc rgb "#b9d8f0" title "10 modes, α = 56/v", \
         csv using 2:(of("dynamics: 100 modes; alpha = 56/v")) skip 1 with lines lw 2 lc rgb "#6aaade" title "100 modes", \
         csv using 2:(of("dynamics: 940 modes; alpha = 56/v")) skip 1 with lines lw 2 lc rgb blue title "940 modes", \
         csv using 2:(of("dynamics: 1800 modes; alpha = 11/v")) skip 1 with lines lw 2 lc rgb red title "1800, α = 11/v"
}
unset multiplot
set output
