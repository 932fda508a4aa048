/* SPDX-License-Identifier: MIT */
#include "support/eps_plot.h"

#include <math.h>
#include <stdio.h>

#include "support/console.h"
#include "support/gnuplot.h"
#include "support/output.h"

enum { WIDTH = 720, HEIGHT = 470 };

static const char *const colour[] = {"blue", "red", "green", "violet", "amber", "grey"};
enum { COLOURS = sizeof colour / sizeof *colour };

static void write_script(FILE *script, const char *title, const char *label, double least,
                         const struct eps_curve *curve, size_t curves)
{
    fputs("set key bottom left\nset xlabel ", script);
    gnuplot_quote(script, label);
    fprintf(script, "\nset ylabel 'coefficient of restitution ε'\n%s\nset logscale x\nset format x '%%g'\n",
            isnan(least) ? "set yrange [*:1]" : "set yrange [0:1]\nset ytics 0.2\nset mytics 2");
    fputs("set title ", script);
    gnuplot_quote(script, title);
    fputs(" noenhanced\n", script);
    for (size_t i = 0; i < curves; i++) {
        fprintf(script, "$curve%zu << end_of_curve\n", i);
        for (size_t k = 0; k < curve[i].count; k++)
            if (!isnan(curve[i].eps[k]))
                fprintf(script, "%.17g %.17g\n", curve[i].speed[k], curve[i].eps[k]);
        fputs("end_of_curve\n", script);
    }
    for (size_t i = 0; i < curves; i++) {
        fprintf(script, "%s$curve%zu using 1:2 with lines lw 2.2 dt %zu lc rgb %s title ", i ? ", " : "plot ", i,
                i / COLOURS + 1, colour[i % COLOURS]);
        gnuplot_quote(script, curve[i].title);
    }
    fputs("\nset output\n", script);
}

int eps_plot(const char *path, const char *title, const char *label, double least, const struct eps_curve *curve,
             size_t curves)
{
    struct output out;
    const int status = output_open(&out, path);
    if (status != STATUS_OK)
        return status;
    FILE *const script = gnuplot_begin(WIDTH, HEIGHT);
    if (!script)
        return output_finish(&out, STATUS_FAILED);
    write_script(script, title, label, least, curve, curves);
    return output_finish(&out, gnuplot_run(script, out.file, path));
}
