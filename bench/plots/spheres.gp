# SPDX-License-Identifier: MIT
# eps of spheres, error against time of all methods: docs/speed/spheres_<input>.svg from spheres_<input>.csv, with
# gnuplot -e "input = 'speed'" or 'beta'.
stem = "spheres_".input; home = "docs/speed"; width = 1060; height = 1000
load "docs/style.gp"

# Columns: 1 scene, 2 curve, 3 setting, 4 instructions, 5 end, 6 form, 7 ns, 9 error. Of loops those for AVX2.
least = 3e-17 # an error of 0 is drawn here
error(i) = column(9) > least ? column(9) : least
here(i) = strcol(1) eq scene && strcol(5) eq end
calls(curve) = here(0) && strcol(2) eq curve && strcol(6) eq "scalar" ? error(0) : NaN
loops(curve) = here(0) && strcol(2) eq curve && strcol(6) eq "array" && (strcol(4) eq "AVX2" || strcol(4) eq "as shipped") ? error(0) : NaN
arrays(set) = here(0) && strcol(2) eq "cor" && strcol(4) eq set ? error(0) : NaN
from_beta = input eq "beta"
speeds(text) = from_beta ? "" : text # headers take a speed
betas(text) = from_beta ? text : ""  # float, and loops without pow, take beta

set logscale xy
set format x power
set xrange [0.05:3e5]
set yrange [1e-17:20]
set ytics format power 1e-16, 100, 1
set multiplot layout 2,2 title "ε of spheres from ".(from_beta ? "β" : "an impact speed").": error against time, one core" \
    margins 0.07,0.985,0.22,0.93 spacing 0.085,0.09
do for [panel = 0:3] {
    scene = panel < 2 ? "weak" : "ordinary"
    end = panel % 2 == 0 ? "overlap" : "force"
    set title (panel < 2 ? "0.03 ≤ β ≤ 0.19" : "0.3 ≤ β ≤ 1.9") . ", contact ends at zero " . end
    set ylabel (panel % 2 ? "" : "largest relative error of ε") offset 1
    set xlabel (panel < 2 ? "" : "time per ε (ns)")
    if (panel == 0) { set key at screen 0.5,0.008 center bottom maxrows 6 width -3 } else { unset key }
    plot csv using 7:(calls("published")) skip 1 with points pt 2 ps 0.9 lw 1.6 lc rgb black title "published formulas", \
         csv using 7:(calls("series")) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb amber title "series", \
         csv using 7:(calls("Padé")) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb red title "Padé", \
         csv using 7:(loops("Padé")) skip 1 with linespoints pt 4 ps 0.5 lw 1.2 dt (6,4) lc rgb red title betas("Padé, loops (AVX2)"), \
         csv using 7:(calls("two-point Padé")) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb violet title "two-point Padé", \
         csv using 7:(loops("two-point Padé")) skip 1 with linespoints pt 4 ps 0.5 lw 1.2 dt (6,4) lc rgb violet title betas("two-point, loops (AVX2)"), \
         csv using 7:(calls("scene header")) skip 1 with linespoints pt 7 ps 0.5 lw 1.6 lc rgb green title speeds("scene header"), \
         csv using 7:(loops("scene header")) skip 1 with linespoints pt 4 ps 0.5 lw 1.2 dt (6,4) lc rgb green title speeds("scene header, loops (AVX2)"), \
         csv using 7:(calls("scene header float")) skip 1 with points pt 9 ps 0.8 lc rgb green title speeds("scene header, float"), \
         csv using 7:(calls("cor float")) skip 1 with points pt 9 ps 1 lc rgb blue title betas("cor, float"), \
         csv using 7:(loops("cor float")) skip 1 with points pt 8 ps 1 lc rgb blue title betas("cor, float array"), \
         csv using 7:(calls("cor")) skip 1 with points pt 7 ps 1.1 lc rgb blue title "cor", \
         csv using 7:(arrays("portable")) skip 1 with points pt 4 ps 1 lw 1.4 lc rgb blue title "cor array, portable", \
         csv using 7:(arrays("AVX2")) skip 1 with points pt 6 ps 1 lw 1.4 lc rgb blue title "cor array, AVX2", \
         csv using 7:(arrays("AVX-512")) skip 1 with points pt 12 ps 1.2 lw 1.4 lc rgb blue title "cor array, AVX-512", \
         csv using 7:(calls("Verlet")) skip 1 with linespoints pt 7 ps 0.4 lw 1.3 dt (2,3) lc rgb grey title "velocity Verlet"
}
unset multiplot
set output
