# SPDX-License-Identifier: MIT
# eps of spheres from an impact speed, error against time, for the usual choices: docs/speed/speed.svg from
# spheres_speed.csv.
stem = "speed"; home = "docs/speed"; width = 960; height = 460
if (!exists("dir")) dir = home
csv = dir."/spheres_speed.csv"
load "docs/style.gp"

# Columns: 1 scene, 2 curve, 3 setting, 4 instructions, 5 end, 6 form, 7 ns, 9 error.
here(curve) = strcol(1) eq "ordinary" && strcol(5) eq "overlap" && strcol(2) eq curve
calls(curve) = here(curve) && strcol(6) eq "scalar" ? column(9) : NaN
loops(curve, set) = here(curve) && strcol(6) eq "array" && strcol(4) eq set ? column(9) : NaN

set logscale xy
set format x "%g"
set format y power
set xrange [0.1:2e5]
set yrange [1e-17:3]
set ytics 1e-16, 100, 1
set lmargin 9
set xlabel "time per collision, one core (ns)"
set ylabel "largest relative error of ε" offset 0.5
set title "ε of spheres from an impact speed: 0.3 ≤ β ≤ 1.9, contact ends at zero overlap"
set key off
set label "published Padé" at 20, 0.42 left tc rgb black
set label "Padé, right\ncoefficients" at 42, 1e-11 left tc rgb red
set label "header by\ncorgen embed,\none by one" at 3.6, 1e-7 left tc rgb green
set label "in loops\n(AVX2)" at 0.75, 1e-7 right tc rgb green
set label "cor, one by one" at 6.5, 1.6e-16 left tc rgb blue
set label "cor, arrays (AVX-512)" at 1.4, 1.6e-16 right tc rgb blue
set label "velocity Verlet" at 1.2e4, 1e-2 left tc rgb grey
plot csv using 7:(calls("published")) skip 1 with points pt 2 ps 1 lw 2 lc rgb black, \
     csv using 7:(calls("Padé")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 lc rgb red, \
     csv using 7:(calls("scene header")) skip 1 with linespoints pt 7 ps 0.5 lw 1.8 lc rgb green, \
     csv using 7:(loops("scene header", "AVX2")) skip 1 with linespoints pt 4 ps 0.5 lw 1.4 dt (6,4) lc rgb green, \
     csv using 7:(calls("cor")) skip 1 with points pt 7 ps 1.2 lc rgb blue, \
     csv using 7:(loops("cor", "AVX-512")) skip 1 with points pt 12 ps 1.3 lw 1.6 lc rgb blue, \
     csv using 7:(calls("Verlet")) skip 1 with linespoints pt 7 ps 0.4 lw 1.5 dt (2,3) lc rgb grey
