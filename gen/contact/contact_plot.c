/* SPDX-License-Identifier: MIT */
#include "contact/contact_plot.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "support/console.h"
#include "support/gnuplot.h"
#include "support/output.h"

enum { WIDTH = 720, HEIGHT = 470 };

static const char *const colour[] = {"blue", "red", "green", "violet"};
enum { COLOURS = sizeof colour / sizeof *colour };

static void write_script(FILE *script, const char *title, const struct contact_curve *curve, size_t curves)
{
    gnuplot_style(script, WIDTH, HEIGHT);
    fputs("set key bottom left\nset xlabel 'impact speed (m/s)'\nset ylabel 'coefficient of restitution ε'\n"
          "set yrange [0:1]\nset ytics 0.2\nset mytics 2\nset logscale x\nset format x '%g'\n",
          script);
    fputs("set title ", script);
    gnuplot_quote(script, title);
    fputs(" noenhanced\n", script);
    for (size_t i = 0; i < curves; i++) {
        fprintf(script, "$curve%zu << end_of_curve\n", i);
        for (size_t k = 0; k < curve[i].count; k++)
            if (!isnan(curve[i].eps[k]))
                fprintf(script, "%.17g %.17g\n", curve[i].speed_m_s[k], curve[i].eps[k]);
        fputs("end_of_curve\n", script);
    }
    for (size_t i = 0; i < curves; i++) {
        fprintf(script, "%s$curve%zu using 1:2 with lines lw 2.2 lc rgb %s title ", i ? ", " : "plot ", i,
                colour[i % COLOURS]);
        gnuplot_quote(script, curve[i].title);
    }
    fputs("\nset output\n", script);
}

int contact_plot(const char *path, const char *title, const struct contact_curve *curve, size_t curves)
{
    struct output out;
    FILE *const script = tmpfile();
    if (!script)
        return fail("cannot make a temporary file: %s", strerror(errno));
    write_script(script, title, curve, curves);
    int status = output_open(&out, path);
    if (status == STATUS_OK) {
        status = gnuplot_run(script, out.file, path);
        if (status == STATUS_OK)
            status = output_commit(&out);
        else
            output_discard(&out);
    }
    fclose(script);
    return status;
}
