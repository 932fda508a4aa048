# SPDX-License-Identifier: MIT
# Realised restitution minus the requested one, by simulator: cor_realised curve.
#     gnuplot -e "csv = 'curve.csv'; svg = 'realised.svg'" bench/plots/realised.gp
stem = "realised"; home = "docs/laws"; width = 960; height = 520
load "docs/style.gp"
teal = "#00a0a0"; pink = "#d07090"

set title "simulators asked for ε realise another"
set xlabel "ε asked"
set xrange [0:1]

# Columns: 1 model, 3 requested, 4 realised
off(part) = strstrt(strcol(1), part) > 0 ? column(4) - column(3) : NaN

set ylabel "ε realised - ε asked"
set yrange [-0.06:0.28]
set key off
set lmargin 9
set label "LAMMPS tsuji to July 2026, limit\\_damping" at 0.25, 0.238 left tc rgb amber
set label "LAMMPS tsuji to July 2026" at 0.19, 0.152 left tc rgb red
set label "zero-overlap formula,\nforce cut off: Chrono" at 0.2, 0.095 right tc rgb blue
set label "MFiX Hertz" at 0.25, 0.053 center tc rgb green
set label "Flores: Chrono multicore" at 0.42, -0.046 left tc rgb violet
set label "Thornton: YADE, Granulars.jl" at 0.985, -0.018 right tc rgb teal
set label "LAMMPS tsuji since July 2026" at 0.07, 0.013 left tc rgb pink
plot 0 w l lc rgb black dt 2 lw 1, \
    csv every ::1 u 3:(off("hertz; damping tsuji; limit_damping")) w l lc rgb amber lw 2, \
    csv every ::1 u 3:(off("hertz; damping tsuji; releases")) w l lc rgb red lw 2, \
    csv every ::1 u 3:(off("chrono: SMC; Hooke or Hertz")) w l lc rgb blue lw 2, \
    csv every ::1 u 3:(off("mfix: DEM; HERTZIAN")) w l lc rgb green lw 2, \
    csv every ::1 u 3:(off("chrono-multicore")) w l lc rgb violet lw 2, \
    csv every ::1 u 3:(off("granulars.jl")) w l lc rgb teal lw 2, \
    csv every ::1 u 3:(off("hertz; damping tsuji; source after")) w l lc rgb pink lw 2
