# SPDX-License-Identifier: MIT
# What the figures of docs/paper share. dir: where the csv files lie and the svg files go.
if (!exists("dir")) dir = "docs/paper"
csv = dir."/".stem.".csv"

# The same bytes on every run and machine: the lines that name the gnuplot version are removed.
set output "| sed -e '/^<desc>/d' -e '/Gnuplot/d' -e '/GNUPLOT/d' > '".dir."/".stem.".svg'"

black = "#222222"; grey = "#888888"; light = "#dddddd"; blue = "#0060ad"; red = "#c8421a"; green = "#3a7d34"
shade = "#f1f0ea"
set datafile separator comma
set datafile missing ""
set border 3 lc rgb black
set tics nomirror
set grid ytics lc rgb light lw 0.7
set key samplen 2.2 spacing 1.15 reverse Left
