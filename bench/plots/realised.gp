# SPDX-License-Identifier: MIT
# Restitution realised against asked, by simulator: cor_realised curve.
#     gnuplot -e "csv = 'curve.csv'; svg = 'realised.svg'" bench/plots/realised.gp
stem = "realised"; home = "docs/laws"; width = 1000; height = 560
load "docs/style.gp"
teal = "#00a0a0"; pink = "#d07090"

set datafile missing ""
set xlabel "ε asked"
set xrange [0:1]

# Columns: 1 model, 3 asked, 4 realised
is(part) = strstrt(strcol(1), part) > 0
realised(part) = is(part) ? column(4) : NaN
off(part) = is(part) ? column(4) - column(3) : NaN

cut = "chrono: SMC; Hooke or Hertz"
tsuji = "hertz; damping tsuji; releases"
tsuji_limit = "hertz; damping tsuji; limit_damping"
tsuji_new = "hertz; damping tsuji; source after"
thornton = "granulars.jl"
mfix = "mfix: DEM; HERTZIAN"
flores = "chrono-multicore"

set multiplot layout 1,2 title "coefficient of restitution ε that simulators realise, against the one asked for" \
    margins 0.06,0.985,0.33,0.9 spacing 0.1,0
set ylabel "ε realised"
set yrange [0:1]
set key at screen 0.06, 0.03 bottom left samplen 2 spacing 1.15 # half of the names here, half below the other plot
plot x w l lc rgb black dt 2 lw 1 t "exact", \
    csv every ::1 u 3:(realised(tsuji_limit)) w l lc rgb amber lw 2 t "LAMMPS tsuji to July 2026, limit\\_damping", \
    csv every ::1 u 3:(realised(tsuji)) w l lc rgb red lw 2 t "LAMMPS tsuji to July 2026", \
    csv every ::1 u 3:(realised(cut)) w l lc rgb blue lw 2 t "zero-overlap formula, force cut off: Chrono", \
    csv every ::1 u 3:(realised(mfix)) w l lc rgb green lw 2 notitle, \
    csv every ::1 u 3:(realised(flores)) w l lc rgb violet lw 2 notitle, \
    csv every ::1 u 3:(realised(thornton)) w l lc rgb teal lw 2 notitle, \
    csv every ::1 u 3:(realised(tsuji_new)) w l lc rgb pink lw 2 notitle
set ylabel "ε realised - ε asked"
set yrange [-0.06:0.28]
set key at screen 0.56, 0.03 bottom left
plot 0 w l lc rgb black dt 2 lw 1 notitle, \
    csv every ::1 u 3:(off(tsuji_limit)) w l lc rgb amber lw 2 notitle, \
    csv every ::1 u 3:(off(tsuji)) w l lc rgb red lw 2 notitle, \
    csv every ::1 u 3:(off(cut)) w l lc rgb blue lw 2 notitle, \
    csv every ::1 u 3:(off(mfix)) w l lc rgb green lw 2 t "MFiX Hertz", \
    csv every ::1 u 3:(off(flores)) w l lc rgb violet lw 2 t "Flores: Chrono multicore", \
    csv every ::1 u 3:(off(thornton)) w l lc rgb teal lw 2 t "Thornton: YADE, Granulars.jl", \
    csv every ::1 u 3:(off(tsuji_new)) w l lc rgb pink lw 2 t "LAMMPS tsuji since July 2026"
unset multiplot
