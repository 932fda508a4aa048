# SPDX-License-Identifier: MIT
# What models of eps leave out, spheres: drawn by bench/plots/left_out from rows of corgen plan.
# The lines that name the gnuplot version are removed.
set output "| sed -e '/^<desc>/d' -e '/Gnuplot/d' -e '/GNUPLOT/d' > docs/speed/left_out_spheres.svg"
set terminal svg size 960,600 fixed font "DejaVu Sans,12" background "white"
black = "#222222"; grey = "#888888"; light = "#e4e4e4"; blue = "#0060ad"; red = "#c8421a"; green = "#3a7d34"
set datafile separator comma
set datafile missing "nan"
set logscale xy
set border 3 lc rgb black
set tics nomirror
set grid lc rgb light lw 0.7
set xrange [0.05:6]
set yrange [1e-16:30]
set format y "10^{%T}"
set xtics (0.05, 0.1, 0.2, 0.5, 1, 2, 5)
set xlabel "β"
set key below maxrows 5 samplen 2 spacing 1.1 reverse Left font ",10"

# Columns: 1 model, 2 beta, 4 error. A model is the rows whose name begins like that.
of(name) = strcol(1)[1:strlen(name)] eq name ? column(4) : NaN
set multiplot layout 1,2 margins 0.075,0.985,0.27,0.93 spacing 0.07
set title "contact to zero overlap"
set ylabel "relative error of ε" offset 1
csv = dir."/zero-overlap.csv"
plot csv using 2:(of("the other end")) skip 1 with lines lw 2 dt (6,4) lc rgb black title "zero force instead", \
     csv using 2:(of("constant eps of")) skip 1 with lines lw 1.4 lc rgb grey title "constant ε", \
     csv using 2:(of("power law")) skip 1 with lines lw 1.4 dt (2,2) lc rgb grey title "power law", \
     csv using 2:(of("simple theory")) skip 1 with lines lw 2 lc rgb red title "simple theory, (27)", \
     csv using 2:(of("Pade [1/4] as printed in 1999")) skip 1 with lines lw 2 dt (8,3) lc rgb red title "Padé of 1999, (35)", \
     csv using 2:(of("Pade [4/6]")) skip 1 with lines lw 2 lc rgb "#8fc0e8" title "Padé [4/6]", \
     csv using 2:(of("Pade [6/9]")) skip 1 with lines lw 2 lc rgb "#4b93d0" title "Padé [6/9]", \
     csv using 2:(of("Pade [8/12]")) skip 1 with lines lw 2 lc rgb blue title "Padé [8/12]", \
     csv using 2:(of("Pade [10/15]")) skip 1 with lines lw 2 lc rgb "#003a6b" title "Padé [10/15]", \
     csv using 2:(of("two-point Pade [8/13]")) skip 1 with lines lw 2 lc rgb green title "two-point [8/13]"
set title "contact to zero force"
unset ylabel
csv = dir."/zero-force.csv"
plot csv using 2:(of("the other end")) skip 1 with lines lw 2 dt (6,4) lc rgb black title "zero overlap instead", \
     csv using 2:(of("constant eps of")) skip 1 with lines lw 1.4 lc rgb grey title "constant ε", \
     csv using 2:(of("power law")) skip 1 with lines lw 1.4 dt (2,2) lc rgb grey title "power law", \
     csv using 2:(of("simple theory")) skip 1 with lines lw 2 lc rgb red title "simple theory, (27)", \
     csv using 2:(of("Pade [1/4] as printed in 2011")) skip 1 with lines lw 2 dt (8,3) lc rgb red title "Padé of 2011", \
     csv using 2:(of("Pade [4/6]")) skip 1 with lines lw 2 lc rgb "#8fc0e8" title "Padé [4/6]", \
     csv using 2:(of("Pade [6/9]")) skip 1 with lines lw 2 lc rgb "#4b93d0" title "Padé [6/9]", \
     csv using 2:(of("Pade [8/12]")) skip 1 with lines lw 2 lc rgb blue title "Padé [8/12]", \
     csv using 2:(of("Pade [10/15]")) skip 1 with lines lw 2 lc rgb "#003a6b" title "Padé [10/15]"
unset multiplot
set output
