# SPDX-License-Identifier: MIT
# Oblique impacts by the theory of Mindlin and Deresiewicz and by the models of simulators: tests/reference/mindlin.py
csv = "docs/oblique.csv"; svg = "docs/oblique.svg"
stem = "oblique"; home = "docs"; width = 800; height = 430
load "docs/style.gp"

set title "The contact point after an oblique impact of elastic spheres, ν = 0.3" font small
set xrange [0:10]
set yrange [-0.7:1.1]
set xlabel "2 κ u/(7 μ v), the tangential over the normal speed"
set ylabel "u\'/u"
set object 1 rectangle from 0,-0.51 to 10,-0.37 fc rgb "#e8e8e8" fs solid noborder behind
set label "glass, measured: Foerster et al. (1994)" at 5.2,-0.6 tc rgb grey
set key top center
plot csv u 2:($1 == 0.3 ? $3 : NaN) w l lc rgb black lw 2.5 t "Mindlin and Deresiewicz", \
    csv u 2:($1 == 0.3 ? $4 : NaN) w l lc rgb blue lw 2 t "displacement", \
    csv u 2:($1 == 0.3 ? $5 : NaN) w l lc rgb amber lw 2 t "force", \
    csv u 2:($1 == 0.3 ? $7 : NaN) w l lc rgb red lw 2 t "rescaled-force"
