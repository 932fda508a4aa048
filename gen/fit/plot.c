/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "fit/plot.h"

#include <errno.h>
#include <math.h>
#include <string.h>

#include "support/console.h"
#include "support/gnuplot.h"

enum { CURVE_POINTS = 201, WIDTH = 960, HEIGHT = 640, WIDE_RANGE = 10, MAX_POINTS = 4000 };

static const struct {
    const char *name, *colour, *dash;
} styles[FIT_CURVES] = {
    [FIT_SPHERE_ZERO_OVERLAP] = {"viscoelastic, zero overlap", "blue", "1"},
    [FIT_SPHERE_ZERO_FORCE] = {"viscoelastic, zero force", "red", "(8,5)"},
    [FIT_CONSTANT] = {"constant", "grey", "1"},
    [FIT_HUNT_CROSSLEY] = {"Hunt-Crossley", "green", "1"},
    [FIT_HERTZ_DASHPOT_ZERO_OVERLAP] = {"Hertz, dashpot, zero overlap", "amber", "1"},
    [FIT_HERTZ_DASHPOT_ZERO_FORCE] = {"Hertz, dashpot, zero force", "'#d9a441'", "(8,5)"},
    [FIT_POWER_LAW] = {"power law", "violet", "1"},
    [FIT_ELASTIC_PLASTIC] = {"elastic-plastic", "'#8c564b'", "1"},
    [FIT_ADHESIVE] = {"adhesive", "'#17becf'", "1"},
    [FIT_ADHESIVE_SPHERE_ZERO_OVERLAP] = {"adhesive, viscoelastic, zero overlap", "'#0e7c86'", "1"},
    [FIT_ADHESIVE_SPHERE_ZERO_FORCE] = {"adhesive, viscoelastic, zero force", "'#0e7c86'", "(8,5)"},
    [FIT_WET] = {"wet", "'#bcbd22'", "1"},
    [FIT_WET_SPHERE_ZERO_OVERLAP] = {"wet, viscoelastic, zero overlap", "'#7f7f22'", "1"},
    [FIT_WET_SPHERE_ZERO_FORCE] = {"wet, viscoelastic, zero force", "'#7f7f22'", "(8,5)"},
};

/* Of very many points only every so many-th is drawn. */
static size_t points_step(const struct fit_data *data)
{
    return (data->points + MAX_POINTS - 1) / MAX_POINTS;
}

static void write_points(FILE *script, const struct fit_data *data)
{
    fputs("$data << END\n", script);
    for (size_t i = 0; i < data->points; i += points_step(data))
        fprintf(script, "%.9g %.9g %.9g\n", data->speed_m_s[i], data->eps[i], data->sigma ? data->sigma[i] : 0);
    fputs("END\n", script);
}

/* The curve, and the residuals of the points */
static void write_curve(FILE *script, const struct fit_estimate *e, const struct fit_data *data)
{
    const double from = log(data->speed_m_s[0]), to = log(data->speed_m_s[data->points - 1]);
    fprintf(script, "$curve%d << END\n", (int)e->curve);
    for (int i = 0; i < CURVE_POINTS; i++) {
        const double x = from + (to - from) * i / (CURVE_POINTS - 1);
        double eps;
        fit_curve_eps(e->curve, e->theta, &x, &eps, 1);
        fprintf(script, "%.9g %.9g\n", exp(x), eps);
    }
    fprintf(script, "END\n$residual%d << END\n", (int)e->curve);
    for (size_t i = 0; i < data->points; i += points_step(data)) {
        const double x = log(data->speed_m_s[i]);
        double eps;
        fit_curve_eps(e->curve, e->theta, &x, &eps, 1);
        fprintf(script, "%.9g %.9g %.9g\n", data->speed_m_s[i], data->eps[i] - eps, data->sigma ? data->sigma[i] : 0);
    }
    fputs("END\n", script);
}

static void plot_upper(FILE *script, const struct fit_comparison *c, const struct fit_data *data, const char *title)
{
    fputs("set title ", script);
    gnuplot_quote(script, title);
    fputs(" noenhanced\nset ylabel 'coefficient of restitution ε'\nset format x ''\nset key outside right top\nplot ",
          script);
    for (int curve = 0; curve < FIT_CURVES; curve++)
        if (c->used[curve])
            fprintf(script, "$curve%d using 1:2 with lines lw 2 dt %s lc rgb %s title '%s', ", curve,
                    styles[curve].dash, styles[curve].colour, styles[curve].name);
    fprintf(script, "$data using 1:2%s pt 7 ps 0.45 lc rgb black title 'data'\n",
            data->sigma ? ":3 with yerrorbars" : " with points");
}

static void plot_lower(FILE *script, const struct fit_comparison *c, const struct fit_data *data)
{
    fputs(
        "unset title\nset ylabel 'residual'\nset xlabel 'impact speed g (m/s)'\nset format x '%g'\nset format y '%g'\n"
        "set yrange [*:*]\nset key off\nplot 0 lc rgb black lw 0.7 notitle",
        script);
    for (int curve = 0; curve < FIT_CURVES; curve++)
        if (c->used[curve])
            fprintf(script, ", $residual%d using 1:2%s pt 7 ps 0.35 lc rgb %s notitle", curve,
                    data->sigma ? ":3 with yerrorbars" : " with points", styles[curve].colour);
    fputs("\n", script);
}

static void write_script(FILE *script, const struct fit_comparison *c, const struct fit_data *data, const char *title)
{
    gnuplot_style(script, WIDTH, HEIGHT);
    write_points(script, data);
    for (int curve = 0; curve < FIT_CURVES; curve++)
        if (c->used[curve])
            write_curve(script, &c->estimate[curve], data);
    const double least = data->speed_m_s[0], most = data->speed_m_s[data->points - 1];
    if (most > (double)WIDE_RANGE * least)
        fputs("set logscale x\n", script);
    fputs("set multiplot\nset lmargin at screen 0.085\nset rmargin at screen 0.71\n"
          "set tmargin at screen 0.93\nset bmargin at screen 0.44\n",
          script);
    plot_upper(script, c, data, title);
    fputs("set tmargin at screen 0.39\nset bmargin at screen 0.1\n", script);
    plot_lower(script, c, data);
    fputs("unset multiplot\nset output\n", script);
}

int fit_plot(const struct fit_comparison *comparison, const struct fit_data *data, const char *title, FILE *out,
             const char *path)
{
    FILE *const script = tmpfile();
    if (!script)
        return fail("cannot make a temporary file: %s", strerror(errno));
    write_script(script, comparison, data, title);
    const int status = gnuplot_run(script, out, path);
    fclose(script);
    return status;
}
