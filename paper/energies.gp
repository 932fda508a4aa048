# SPDX-License-Identifier: MIT
# Fig. 6, drawn by paper/run from energies.csv.
stem = "energies"; home = "docs/paper"; width = 960; height = 490
load "docs/style.gp"

# Columns: 1 n, 2 l, 3 energy
set multiplot title "energy of the modes at closest approach to the wall: ν = 0.33, v = 0.1 √(E/ρ), α = 500/R, 1600 modes"
set lmargin at screen 0.06
set rmargin at screen 0.45
set tmargin at screen 0.85
set bmargin at screen 0.12
unset key
unset grid
set title "log_{10}(energy/(m v^2/2))"
set xrange [-0.5:15.5]
set yrange [-0.5:15.5]
set xtics 0,5 scale 0
set ytics 0,5 scale 0
set xlabel "angular number n"
set ylabel "radial number l" offset 0.5
set palette defined (0 "#f4f1e8", 0.35 "#a9c5de", 0.7 "#3577b5", 1 "#0a2748")
set cbrange [-8:0]
set cbtics 2
set colorbox user origin 0.462,0.12 size 0.014,0.73
plot csv using 1:2:(0.46):(0.46):($1 <= 15 && $2 <= 15 ? log10($3) : NaN) skip 1 with boxxyerror \
     lc palette fillstyle solid noborder

unset colorbox
set lmargin at screen 0.6
set rmargin at screen 0.985
set grid ytics
set title "the modes l = 0, n = 0 and n = 1"
set xrange [-0.5:20.5]
set xtics 0,5 scale 1
set logscale y
set yrange [1e-8:1]
set format y "10^{%L}"
set ytics 1e-8,100,1 scale 1
set xlabel "n or l, as the legend says"
set ylabel "energy/(m v^2/2)" offset 0.5
set key top right
plot csv using ($2 == 0 ? $1 : NaN):3 skip 1 with points pt 7 ps 0.7 lc rgb blue title "l = 0, against n", \
     csv using ($1 == 0 ? $2 : NaN):3 skip 1 with points pt 6 ps 0.8 lw 1.6 lc rgb red title "n = 0, against l", \
     csv using ($1 == 1 ? $2 : NaN):3 skip 1 with points pt 4 ps 0.7 lw 1.2 lc rgb grey title "n = 1, against l"
