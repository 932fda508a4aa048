/* SPDX-License-Identifier: MIT */
#include "fit/compare.h"

#include <math.h>
#include <string.h>

#include "support/console.h"
#include "support/gnuplot.h"

enum {
    CURVE_POINTS = 201,
    PANEL_WIDTH = 330,
    PANEL_HEIGHT = 325,
    HEAD = 62,
    FOOT = 36,
    MOST_COLUMNS = 3,
    MAX_POINTS = 4000
};
#define WIDE_RANGE 10.0

/* A model to a panel: its curve, or those of both ends of contact */
static const struct {
    const char *title;
    enum fit_curve first, last;
} panels[] = {
    {"viscoelastic", FIT_SPHERE_ZERO_OVERLAP, FIT_SPHERE_ZERO_FORCE},
    {"constant", FIT_CONSTANT, FIT_CONSTANT},
    {"Hunt-Crossley", FIT_HUNT_CROSSLEY, FIT_HUNT_CROSSLEY},
    {"Hertz, dashpot", FIT_HERTZ_DASHPOT_ZERO_OVERLAP, FIT_HERTZ_DASHPOT_ZERO_FORCE},
    {"power law", FIT_POWER_LAW, FIT_POWER_LAW},
    {"elastic-plastic", FIT_ELASTIC_PLASTIC, FIT_ELASTIC_PLASTIC},
    {"adhesive", FIT_ADHESIVE, FIT_ADHESIVE},
    {"adhesive, viscoelastic", FIT_ADHESIVE_SPHERE_ZERO_OVERLAP, FIT_ADHESIVE_SPHERE_ZERO_FORCE},
    {"wet", FIT_WET, FIT_WET},
    {"wet, viscoelastic", FIT_WET_SPHERE_ZERO_OVERLAP, FIT_WET_SPHERE_ZERO_FORCE},
};
enum { PANELS = sizeof panels / sizeof *panels };

/* Of very many points only every so many-th is drawn. */
static size_t points_step(const struct fit_data *data)
{
    return (data->points + MAX_POINTS - 1) / MAX_POINTS;
}

static double eps_at(const struct fit_estimate *e, double log_speed)
{
    double eps;
    fit_curve_eps(e->curve, e->theta, &log_speed, &eps, 1);
    return eps;
}

/* eps less that of a curve, if there is one */
static double residual(const struct fit_estimate *e, const struct fit_data *data, size_t point)
{
    return data->point[point].eps - (e ? eps_at(e, log(data->point[point].speed_m_s)) : 0);
}

/* The points as a table whose name ends with the number of the curve, if there is one */
static void write_points(FILE *script, const struct fit_estimate *e, const struct fit_data *data)
{
    if (e)
        fprintf(script, "$residual%d << END\n", (int)e->curve);
    else
        fputs("$data << END\n", script);
    for (size_t i = 0; i < data->points; i += points_step(data))
        fprintf(script, "%.9g %.9g %.9g\n", data->point[i].speed_m_s, residual(e, data, i),
                data->has_sigma ? data->point[i].sigma : 0);
    fputs("END\n", script);
}

/* The curve, and the residuals of the points */
static void write_curve(FILE *script, const struct fit_estimate *e, const struct fit_data *data)
{
    const double from = log(data->point[0].speed_m_s), to = log(data->point[data->points - 1].speed_m_s);
    fprintf(script, "$curve%d << END\n", (int)e->curve);
    for (int i = 0; i < CURVE_POINTS; i++) {
        const double x = from + (to - from) * i / (CURVE_POINTS - 1);
        fprintf(script, "%.9g %.9g\n", exp(x), eps_at(e, x));
    }
    fputs("END\n", script);
    write_points(script, e, data);
}

static bool is_drawn(const struct fit_comparison *c, int panel)
{
    return c->used[panels[panel].first] || c->used[panels[panel].last];
}

/* `row` 0: curves and points; 1: what the points are off by. Zero overlap, or the only curve, is a full line in blue;
 * zero force is dashed in red. */
static void plot_panel(FILE *script, const struct fit_comparison *c, const struct fit_data *data, int panel, int row)
{
    const char *const points = data->has_sigma ? ":3 with yerrorbars" : " with points";
    fprintf(script, row == 0 ? "plot $data using 1:2%s pt 7 ps 0.35 lc rgb grey notitle" : "plot 0 lc rgb black lw 0.7",
            points);
    for (int curve = (int)panels[panel].first; curve <= (int)panels[panel].last; curve++) {
        const bool blue = curve == (int)panels[panel].first;
        if (c->used[curve] && row == 0)
            fprintf(script, ", $curve%d using 1:2 with lines lw 2 dt %s lc rgb %s", curve, blue ? "1" : "(8,5)",
                    blue ? "blue" : "red");
        else if (c->used[curve])
            fprintf(script, ", $residual%d using 1:2%s pt 7 ps 0.3 lc rgb %s", curve, points, blue ? "blue" : "red");
    }
    fputs("\n", script);
}

/* A distance of marks that leaves three to five of them on the axis of the residuals */
static double residual_marks(const struct fit_comparison *c, const struct fit_data *data, int panel)
{
    double low = 0, high = 0;
    for (int curve = (int)panels[panel].first; curve <= (int)panels[panel].last; curve++)
        for (size_t i = 0; i < data->points && c->used[curve]; i += points_step(data)) {
            const double rest = residual(&c->estimate[curve], data, i);
            low = fmin(low, rest);
            high = fmax(high, rest);
        }
    const double unit = pow(10, floor(log10(fmax((high - low) / 2, 1e-15))));
    const double units = (high - low) / 2 / unit;
    return unit * (units < 2 ? 1 : units < 5 ? 2 : 5);
}

static FILE *script_of(const struct fit_comparison *c, const struct fit_data *data, const char *title)
{
    int drawn = 0, place = 0;
    for (int i = 0; i < PANELS; i++)
        drawn += is_drawn(c, i);
    const int columns = drawn < MOST_COLUMNS ? drawn : MOST_COLUMNS, rows = (drawn + columns - 1) / columns;
    const double height = rows * PANEL_HEIGHT + HEAD + FOOT;
    FILE *const script = gnuplot_begin(columns * PANEL_WIDTH, (int)height);
    if (!script)
        return NULL;
    write_points(script, NULL, data);
    for (int curve = 0; curve < FIT_CURVES; curve++)
        if (c->used[curve])
            write_curve(script, &c->estimate[curve], data);
    if (data->point[data->points - 1].speed_m_s > WIDE_RANGE * data->point[0].speed_m_s)
        fputs("set logscale x\n", script);
    fputs("set key off\nset multiplot title ", script);
    gnuplot_quote(script, title);
    fputs(" noenhanced\nset tics font ',10'\nset label 1 \"ε and residual over the impact speed (m/s)\\nblue: zero "
          "overlap or only; red: zero force\" at screen 0.5,",
          script);
    fprintf(script, "%.4f center\n", 0.8 * FOOT / height);
    for (int i = 0; i < PANELS; i++) {
        if (!is_drawn(c, i))
            continue;
        const int line = place / columns;
        const double left = (place % columns + 0.17) / columns, right = (place % columns + 0.97) / columns;
        const double top = line * (double)PANEL_HEIGHT + HEAD, unit = 1 / height;
        fprintf(script,
                "set lmargin at screen %.4f\nset rmargin at screen %.4f\nset tmargin at screen %.4f\n"
                "set bmargin at screen %.4f\nset title '%s' offset 0,-0.7\nset format x ''\nset ytics autofreq\n",
                left, right, 1 - (top - 6) * unit, 1 - (top + 165) * unit, panels[i].title);
        plot_panel(script, c, data, i, 0);
        fprintf(script,
                "unset label 1\nunset title\nset tmargin at screen %.4f\nset bmargin at screen %.4f\nset format '%%g'\n"
                "set ytics %g\n",
                1 - (top + 177) * unit, 1 - (top + 260) * unit, residual_marks(c, data, i));
        plot_panel(script, c, data, i, 1);
        place++;
    }
    fputs("unset multiplot\nset output\n", script);
    return script;
}

int fit_plot(const struct fit_report *report, const char *title, FILE *out, const char *path)
{
    FILE *const script = script_of(&report->comparison, report->data, title);
    return script ? gnuplot_run(script, out, path) : STATUS_FAILED;
}
