# SPDX-License-Identifier: MIT
# eps of a material as a function of the speed, and the results of simulators for one e: cor_realised speeds.
#     gnuplot -e "csv = 'speeds.csv'; svg = 'speeds.svg'" bench/plots/speeds.gp
stem = "speeds"; home = "docs/laws"; width = 800; height = 430
load "docs/style.gp"

set title "Spheres rebound with ε = 0.5 at 1 m/s. Other speeds, and simulators asked for 0.5, give another ε." font small
set logscale x
set format x power
set xrange [1e-3:10]
set yrange [0.2:1]
set xlabel "impact speed, m/s"
set ylabel "coefficient of restitution ε"
unset key
set label "viscoelastic spheres," at 2.2e-3,0.885 tc rgb blue
set label "contact ends at zero force; dashed: at zero overlap" at 2.2e-3,0.85 tc rgb blue
set label "LAMMPS to July 2026, damping tsuji" at 1.3e-3,0.64 tc rgb red
set label "Chrono, cr; YADE, ViscElMat" at 1.3e-3,0.572 tc rgb amber
set label "one e for every speed" at 1.3e-3,0.475 tc rgb grey
set label "measured: 0.5" at 1.15,0.53 tc rgb black
plot csv every ::1 u 1:3 w l lc rgb blue lw 2.5, csv every ::1 u 1:2 w l lc rgb blue lw 1.5 dt 2, \
    csv every ::1 u 1:5 w l lc rgb red lw 2, csv every ::1 u 1:6 w l lc rgb amber lw 2, \
    csv every ::1 u 1:4 w l lc rgb grey lw 2, "<echo 1,0.5" u 1:2 w p pt 7 ps 1 lc rgb black
