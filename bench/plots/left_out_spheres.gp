# SPDX-License-Identifier: MIT
# The errors of models of eps for spheres: docs/speed/left_out_spheres.svg, drawn by bench/plots/left_out from rows of
# corgen plan.
stem = "left_out_spheres"; home = "docs/speed"; width = 960; height = 600
load "docs/style.gp"

# Columns: 1 model, 2 beta, 3 error. The rows of a model have names that begin with its name.
of(name) = strcol(1)[1:strlen(name)] eq name ? column(3) : NaN
set logscale xy
set xrange [0.05:6]
set yrange [1e-15:30]
set format y power
set xtics (0.05, 0.1, 0.2, 0.5, 1, 2, 5)
set xlabel "β = 0.867 (impact speed/g*)^{1/5}"
set ylabel "relative error of ε" offset 1
set multiplot layout 1,2 title "models of ε of viscoelastic spheres; constant and power law fitted to this range of β" \
    margins 0.08,0.985,0.3,0.88 spacing 0.09
do for [end in "overlap force"] {
    other = end eq "overlap" ? "force" : "overlap"
    year = end eq "overlap" ? "1999" : "2011"
    rows_of = rows."/zero-".end.".csv"
    set title "contact ends at zero ".end
    set key at screen (end eq "overlap" ? 0.28 : 0.77),0.01 center bottom maxrows 5 font small
    plot rows_of using 2:(of("the other end")) skip 1 with lines lw 2 dt (6,4) lc rgb black title "zero ".other." instead", \
         rows_of using 2:(of("constant eps of")) skip 1 with lines lw 1.6 lc rgb grey title "constant ε", \
         rows_of using 2:(of("power law")) skip 1 with lines lw 1.6 dt (2,2) lc rgb grey title "power law", \
         rows_of using 2:(of("simple theory")) skip 1 with lines lw 2 lc rgb red title "simple theory, (27)", \
         rows_of using 2:(of("Pade [1/4] as printed in ".year)) skip 1 with lines lw 2 dt (8,3) lc rgb red \
             title "Padé [1/4] as printed in ".year, \
         for [k = 1:4] rows_of using 2:(of(sprintf("Pade [%d/%d]", 2*k + 2, 3*k + 3))) skip 1 \
             with lines lw 2 lc rgb blues[k] title sprintf("Padé [%d/%d]", 2*k + 2, 3*k + 3), \
         rows_of using 2:(of("two-point Pade [8/13]")) skip 1 with lines lw 2 lc rgb green \
             title (end eq "overlap" ? "two-point Padé [8/13]" : "")
}
