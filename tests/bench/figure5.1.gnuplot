# gnuplot -c figure5.1.gnuplot CSV SVG PNG CAPTION: draws what figure5.1.tcl has measured.
set datafile separator comma
set datafile columnheaders
# The rows of other accelerators: a line goes on behind them.
set datafile missing NaN
seconds(accelerator, column_name) = strcol("accelerator") eq accelerator ? column(column_name) : NaN

set title "Seconds to render a picture, by the number of spheres in it"
set label 1 ARG4 at screen 0.5, 0.035 center
set bmargin 5.5
set rmargin 6
set xlabel "spheres"
set ylabel "seconds"
set logscale xy
set xrange [3:1.3e6]
set yrange [0.001:*]
set xtics ("4" 4, "10" 10, "100" 100, "1000" 1000, "10 000" 1e4, "100 000" 1e5, "1 000 000" 1e6)
set ytics ("0.001" 0.001, "0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10, "100" 100, "1000" 1000)
set grid linecolor "#d8d8d8" linetype 1 linewidth 1
set border 3
set tics nomirror
set key top left reverse Left samplen 3

# Three colours of Okabe and Ito's, told apart by all eyes; the shapes tell them apart without colour.
set linetype 1 linecolor "#d55e00" linewidth 2 pointtype 7 pointsize 0.8
set linetype 2 linecolor "#0072b2" linewidth 2 pointtype 5 pointsize 0.8
set linetype 3 linecolor "#009e73" linewidth 2 pointtype 9 pointsize 1

# Who looks at the SVG has fonts of their own; the PNG's comes with gnuplot's libraries on Debian.
set terminal svg size 860,560 noenhanced font "sans-serif,16" background "white"
set output ARG2
plot ARG1 \
    using "spheres":(seconds("off", "render_seconds")) with linespoints linetype 1 title "off: every sphere tested", \
    "" using "spheres":(seconds("grid", "render_seconds")) with linespoints linetype 2 title "grid", \
    "" using "spheres":(seconds("embree", "render_seconds")) with linespoints linetype 3 title "Embree", \
    "" using "spheres":(seconds("grid", "build_seconds")) with lines linetype 2 dashtype 2 \
        title "building the grid, once", \
    "" using "spheres":(seconds("embree", "build_seconds")) with lines linetype 3 dashtype 2 \
        title "building Embree's tree, once"
set terminal pngcairo size 860,560 noenhanced font "DejaVu Sans,13" background "white"
set output ARG3
replot
