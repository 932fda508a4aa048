# SPDX-License-Identifier: MIT
# Fig. 3, drawn by paper/run from spectrum.csv.
stem = "spectrum"; home = "docs/paper"; width = 960; height = 560
load "docs/style.gp"

set lmargin at screen 0.07
set rmargin at screen 0.985
set xrange [-1:41]
set yrange [0:32]
set xtics 0, 5, 40
set ytics 0, 5, 30
set xlabel "angular number n"
set ylabel "frequency ω  (√(E/ρ)/R)" offset 0.5
set key at graph 0.985, 0.15 right
set title "the modes of a free disk below ω = 32, ν = 0.33; l counts the modes of one n upwards"
set label 1 "l = 0" at 36.7, 19.6 center tc rgb grey font small
set label 2 "l = 1" at 37.9, 27 center tc rgb grey font small
radial = "radial: |C| > |S|"; tangential = "tangential: |C| < |S|"
plot csv using 1:(strcol(6) eq "radial" ? $3 : NaN) skip 1 \
         with points pt 7 ps 0.5 lc rgb blue title radial, \
     csv using 1:(strcol(6) eq "tangential" ? $3 : NaN) skip 1 \
         with points pt 7 ps 0.5 lc rgb red title tangential
