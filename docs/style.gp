# SPDX-License-Identifier: MIT
# What all pictures share: terminal, colours, axes, where the data lie. Dark text on a white rectangle, so that a
# picture is legible on a dark page too. A script is run from the root of the repository and begins with
#     stem = "load"; home = "docs/paper"; width = 960; height = 460
#     load "docs/style.gp"
# It then draws dir/stem.svg from the file csv = dir/stem.csv; gnuplot -e "dir = '...'" takes another folder than home.
if (!exists("dir")) dir = home
if (!exists("csv")) csv = dir."/".stem.".csv"
if (!exists("svg")) svg = dir."/".stem.".svg"

# The same bytes on every run and machine: sed removes the lines that name the version of gnuplot.
set output "| sed -e '/^<desc>/d' -e '/Gnuplot/d' -e '/GNUPLOT/d' > '".svg."'"
set terminal svg size width,height fixed font "DejaVu Sans,13" background "white"

black = "#222222"; grey = "#777777"; light = "#dddddd"; shade = "#f1f0ea"
blue = "#0060ad"; red = "#c8421a"; green = "#3a7d34"; violet = "#7b3f99"; amber = "#b8860b"
array blues[4] = ["#8fc0e8", "#4b93d0", blue, "#003a6b"]
small = ",11"      # font of labels inside a picture
power = "10^{%T}"  # format of a logarithmic axis

set datafile separator comma
set datafile missing ""
set border 3 lc rgb black
set tics nomirror
set grid lc rgb light lw 0.7
set key samplen 2.2 spacing 1.15 reverse Left
