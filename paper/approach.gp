# SPDX-License-Identifier: MIT
# Not in the paper, drawn by paper/run from approach.csv.
stem = "approach"; home = "docs/paper"; width = 960; height = 440
load "docs/style.gp"

# Columns: 1 -log10 of the speed, 2 1 - eps^2 of all modes at a rigid wall, 3 Rayleigh's, 4 2 over 3
set multiplot layout 1,2 margins 0.08,0.965,0.135,0.91 spacing 0.1
set logscale x
set xrange [3:300]
set xtics (3, 10, 30, 100, 300)
set format x "10^{-%g}"
set xlabel "impact speed v (√(E/ρ))"
set title "energy left in the modes, ν = 0.33"
set logscale y
set format y "10^{%L}"
set yrange [3e-6:1e-1]
set ylabel "energy (m v^2/2)" offset 0.5
set key top right
plot csv using 1:3 skip 1 with lines lw 2.2 lc rgb blue title "Rayleigh, centre of mass", \
     csv using 1:2 skip 1 with points pt 7 ps 0.6 lc rgb black title "all modes, rigid wall"
unset logscale y
set format y "%g"
set title "their ratio"
set yrange [0:2]
set ytics 0.5
set ylabel "all modes over Rayleigh" offset 1
plot csv using 1:(1 + 1/sqrt($1*log(10))) skip 1 with lines lw 1.4 dt (6,4) lc rgb grey title "1 ± 1/√ln(1/v)", \
     csv using 1:(1 - 1/sqrt($1*log(10))) skip 1 with lines lw 1.4 dt (6,4) lc rgb grey notitle, \
     csv using 1:4 skip 1 with linespoints pt 7 ps 0.6 lw 1 lc rgb black notitle
