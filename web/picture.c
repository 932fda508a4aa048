/* SPDX-License-Identifier: MIT */
/* eps over the impact speed as a picture, as a table, and at the speed under a pointer: curves of the request, of
 * requests that were kept to be compared, and of what the simulator makes of the same e. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "web/web.h"

enum { KEPT = 5, MODELS = 4, CURVES = COR_SCENE_ENDS * (KEPT + 1) + MODELS, POINTS = 201, LABEL = 240, LINE = 18 };

static struct web_request kept[KEPT];
static int kept_count;

/* Keeps the request, so that pictures show its curves, too. Returns 0 where there are too many. */
WEB_EXPORT(web_keep) int web_keep(void)
{
    if (kept_count == KEPT)
        return 0;
    kept[kept_count++] = web_now;
    return 1;
}

WEB_EXPORT(web_keep_none) void web_keep_none(void)
{
    kept_count = 0;
}

/* ---- curves ---- */

static struct curve {
    const struct web_request *request;
    const struct cor_simulator_model *model; /* NULL: eps of the contact */
    int contact, end, colour;                /* of a model: `end` counts the models */
    char label[LABEL];
    double eps[POINTS];
} curves[CURVES];
static int curve_count;

static double eps_of(const struct curve *c, double speed_m_s)
{
    double eps = NAN;
    if (c->model)
        return web_realised(c->model, c->request, speed_m_s);
    cor_scene_eps(&eps, &c->request->contact[c->contact], speed_m_s, c->end);
    return eps;
}

/* The speed of a point, 0 <= at <= POINTS - 1; those of corgen contact --plot */
static double speed_of(double at)
{
    return web_now.speed_min_m_s * pow(web_now.speed_max_m_s / web_now.speed_min_m_s, at / (POINTS - 1));
}

static struct curve *add_curve(const struct web_request *r, int colour)
{
    struct curve *const c = &curves[curve_count++];
    *c = (struct curve){.request = r, .colour = colour};
    return c;
}

static void add_contacts(const struct web_request *r, int colour)
{
    const int first = curve_count;
    for (int end = 0; end < COR_SCENE_ENDS; end++) {
        const int k = r->count > 1 ? end : 0;
        const int wanted = r->scene.end == COR_BOTH_ENDS || r->scene.end == end;
        const int differ = cor_scene_ends_differ(&r->contact[k]);
        if (!wanted || !cor_scene_has_end(&r->contact[k], end) || (curve_count > first && !differ))
            continue;
        struct curve *const c = add_curve(r, colour);
        c->contact = k;
        c->end = end;
        snprintf(c->label, LABEL, "%s%s%s%s", r->label, *r->label ? ", " : "",
                 differ || r->scene.plate ? "ends at " : "",
                 !(differ || r->scene.plate)                                       ? "both ends"
                 : end == COR_END_ZERO_FORCE && c->request->contact[0].force_n > 0 ? "the surface"
                                                                                   : cor_end_names[end]);
    }
}

static void make_curves(void)
{
    const struct web_asked asked = web_asked(&web_now);
    int models = 0, next = 0;
    curve_count = 0;
    add_contacts(&web_now, 0);
    for (int i = 0; i < kept_count; i++)
        add_contacts(&kept[i], i + 1);
    for (const struct cor_simulator_model *model; models < MODELS && (model = web_model(&web_now, &next));) {
        if (isnan(web_realised(model, &web_now, speed_of(0))))
            continue;
        struct curve *const c = add_curve(&web_now, 0);
        c->model = model;
        c->end = models++;
        snprintf(c->label, LABEL, "%s, %s, with e = %.6g", web_now.simulator->title, model->model, asked.eps);
    }
    for (int i = 0; i < curve_count; i++)
        for (int k = 0; k < POINTS; k++)
            curves[i].eps[k] = eps_of(&curves[i], speed_of(k));
}

/* ---- axes ---- */

static struct plot {
    double left, right, top, bottom;
    double least, most, step; /* of eps */
} plot;

static void find_range(void)
{
    static const double steps[] = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2};
    double least = 1, most = 0;
    for (int i = 0; i < curve_count; i++)
        for (int k = 0; k < POINTS; k++) {
            least = fmin(least, curves[i].eps[k]);
            most = fmax(most, curves[i].eps[k]);
        }
    size_t i = 0;
    while (i + 1 < sizeof steps / sizeof *steps && (most - least) / steps[i] > 5)
        i++;
    plot.step = steps[i];
    plot.least = floor(least / plot.step + 1e-9) * plot.step;
    plot.most = fmax(ceil(most / plot.step - 1e-9) * plot.step, plot.least + plot.step);
}

static double x_of(double speed_m_s)
{
    return plot.left + (plot.right - plot.left) * log(speed_m_s / web_now.speed_min_m_s) /
                           log(web_now.speed_max_m_s / web_now.speed_min_m_s);
}

static double y_of(double eps)
{
    return plot.bottom - (plot.bottom - plot.top) * (eps - plot.least) / (plot.most - plot.least);
}

static void put_x_tick(double speed_m_s, int has_text)
{
    const double x = x_of(speed_m_s);
    if (!(x >= plot.left - 0.01 && x <= plot.right + 0.01))
        return;
    web_put("<path class=\"cor-g\" d=\"M%.1f %.1fV%.1f\"/>", x, plot.top, plot.bottom);
    if (has_text)
        web_put("<text class=\"cor-t\" text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">%g</text>", x, plot.bottom + 16,
                speed_m_s);
}

static void put_axes(void)
{
    const double decades = log10(web_now.speed_max_m_s / web_now.speed_min_m_s);
    const int stride = (int)ceil(decades / (plot.right - plot.left) * 52);
    for (int e = (int)floor(log10(web_now.speed_min_m_s)); e <= (int)ceil(log10(web_now.speed_max_m_s)); e++) {
        if (e % stride != 0)
            continue;
        put_x_tick(pow(10, e), 1);
        for (int digit = 2; digit <= 5 && decades < 2.5; digit += 3)
            put_x_tick(digit * pow(10, e), 1);
    }
    for (int i = 0; plot.least + i * plot.step < plot.most + plot.step / 2; i++) {
        const double eps = plot.least + i * plot.step;
        web_put("<path class=\"cor-g\" d=\"M%.1f %.1fH%.1f\"/>", plot.left, y_of(eps), plot.right);
        web_put("<text class=\"cor-t\" text-anchor=\"end\" x=\"%.1f\" y=\"%.1f\">%.3g</text>", plot.left - 6,
                y_of(eps) + 4, eps);
    }
    web_put("<path class=\"cor-a\" d=\"M%.1f %.1fV%.1fH%.1f\"/>", plot.left, plot.top, plot.bottom, plot.right);
    web_put("<text class=\"cor-t\" text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">impact speed, m/s</text>",
            (plot.left + plot.right) / 2, plot.bottom + 34);
    web_put("<text class=\"cor-t\" x=\"%.1f\" y=\"%.1f\">eps</text>", plot.left - 38, plot.top - 8);
}

/* ---- the picture ---- */

static void put_escaped(const char *text, size_t length)
{
    for (; length-- > 0 && *text; text++)
        web_put(*text == '<' ? "&lt;" : *text == '&' ? "&amp;" : *text == '"' ? "&quot;" : "%c", *text);
}

/* Of a label that is to be broken: how many characters the next line has */
static size_t line_of(const char *label, size_t most)
{
    size_t length = strlen(label) <= most ? strlen(label) : most;
    if (label[length] != '\0')
        while (length > most / 2 && label[length] != ' ')
            length--;
    return length;
}

static size_t letters(double width)
{
    return (size_t)fmax((width - 60) / 6.6, 12);
}

static const char *dash_of(const struct curve *c)
{
    static const char *const of_model[MODELS] = {" cor-m cor-m0", " cor-m cor-m1", " cor-m cor-m2", " cor-m cor-m3"};
    return c->model ? of_model[c->end] : c->end == COR_END_ZERO_FORCE ? " cor-f" : "";
}

static void put_legend(double width, double y)
{
    for (int i = 0; i < curve_count; i++) {
        const char *label = curves[i].label;
        web_put("<path class=\"cor-c cor-%d%s\" d=\"M8 %.1fH38\"/>", curves[i].colour, dash_of(&curves[i]), y - 4);
        while (*label) {
            const size_t length = line_of(label, letters(width));
            web_put("<text class=\"cor-t\" x=\"46\" y=\"%.1f\">", y);
            put_escaped(label, length);
            web_put("</text>");
            label += length;
            label += *label == ' ';
            y += LINE;
        }
    }
}

static void put_curve(const struct curve *c)
{
    int down = 0;
    web_put("<path class=\"cor-c cor-%d%s\" d=\"", c->colour, dash_of(c));
    for (int k = 0; k < POINTS; k++) {
        if (!isnan(c->eps[k]))
            web_put("%c%.1f %.1f", down ? 'L' : 'M', x_of(speed_of(k)), y_of(c->eps[k]));
        down = !isnan(c->eps[k]);
    }
    web_put("\"/>");
    const double at = c->request->scene.number[COR_SCENE_AT], eps = c->request->scene.number[COR_SCENE_RESTITUTION];
    if (!c->model && eps >= plot.least && at >= web_now.speed_min_m_s && at <= web_now.speed_max_m_s)
        web_put("<circle class=\"cor-p cor-%d\" cx=\"%.1f\" cy=\"%.1f\" r=\"4\"/>", c->colour, x_of(at), y_of(eps));
}

#define COLOURS(c0, c1, c2, c3, c4, c5)                                                                                \
    ".cor-0{stroke:" c0 "}.cor-1{stroke:" c1 "}.cor-2{stroke:" c2 "}.cor-3{stroke:" c3 "}.cor-4{stroke:" c4            \
    "}.cor-5{stroke:" c5 "}"
static const char style[] =
    "<style>.cor-b{fill:#fff}.cor-t{fill:#222;font:12px system-ui,sans-serif}.cor-g{stroke:#ddd;fill:none}"
    ".cor-a{stroke:#555;fill:none}.cor-c{fill:none;stroke-width:2}.cor-f{stroke-dasharray:7 4}"
    ".cor-m{stroke-linecap:round}.cor-m0{stroke-dasharray:1 4}.cor-m1{stroke-dasharray:1 8}"
    ".cor-m2{stroke-dasharray:1 4 6 4}.cor-m3{stroke-dasharray:1 4 1 4 6 "
    "4}.cor-p{fill:#fff;stroke-width:2}.cor-l{stroke:#555}" COLOURS(
        "#0060ad", "#c8421a", "#3a7d34", "#7b3f99", "#8a6508",
        "#555") "@media(prefers-color-scheme:dark){.cor-b,.cor-p{fill:#16181d}.cor-t{fill:#ddd}.cor-g{stroke:#3a3d44}"
                ".cor-a,.cor-l{stroke:#aaa}" COLOURS("#6cb4f5", "#ff8a5c", "#7fc97a", "#c79be0", "#e0b84c",
                                                     "#bbb") "}</style>";

/* The picture as svg, so many pixels wide */
WEB_EXPORT(web_picture) const char *web_picture(double width)
{
    double legend = 0;
    web_text_clear();
    if (web_now.count == 0)
        return web_text(); /* nothing was read yet */
    make_curves();
    find_range();
    for (int i = 0; i < curve_count; i++)
        for (const char *at = curves[i].label; *at; at += line_of(at, letters(width)), at += *at == ' ')
            legend += LINE;
    const double height = fmin(fmax(0.5 * width, 220), 420);
    plot.left = 50;
    plot.right = width - 14;
    plot.top = 26;
    plot.bottom = 26 + height;
    const double all = plot.bottom + 44 + legend + 6;
    web_put("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\" "
            "role=\"img\" aria-labelledby=\"cor-title\"><title id=\"cor-title\">eps over the impact speed:",
            width, all, width, all);
    for (int i = 0; i < curve_count; i++) {
        web_put(i > 0 ? "; " : " ");
        put_escaped(curves[i].label, LABEL);
        web_put(" from %.3g to %.3g", curves[i].eps[0], curves[i].eps[POINTS - 1]);
    }
    web_put("</title>%s<rect class=\"cor-b\" width=\"100%%\" height=\"100%%\"/>", style);
    put_axes();
    for (int i = curve_count - 1; i >= 0; i--)
        put_curve(&curves[i]);
    web_put("<path class=\"cor-l\" id=\"cor-line\" d=\"M0 %.1fV%.1f\" visibility=\"hidden\"/>", plot.top, plot.bottom);
    put_legend(width, plot.bottom + 62);
    web_put("</svg>");
    return web_text();
}

/* ---- values ---- */

/* eps of all curves at a point of the axis, 0 to 200: its x in the picture, the speed, the
 * point, then labels and values */
static const char *read_at(double at, int digits)
{
    const double speed = speed_of(at);
    web_text_clear();
    web_put("%.2f\t%.4g\t%g\n", x_of(speed), speed, at);
    for (int i = 0; i < curve_count; i++) {
        web_put("%s", curves[i].label);
        web_put_cell('\t', eps_of(&curves[i], speed), digits);
        web_put("\n");
    }
    return web_text();
}

WEB_EXPORT(web_read_step) const char *web_read_step(double step, int digits)
{
    return read_at(fmin(fmax(step, 0), POINTS - 1), digits);
}

/* The same for an x of the picture */
WEB_EXPORT(web_read_x) const char *web_read_x(double x, int digits)
{
    const double at = (x - plot.left) / (plot.right - plot.left) * (POINTS - 1);
    return read_at(round(fmin(fmax(at, 0), POINTS - 1)), digits);
}

static void put_quoted(const char *text)
{
    web_put(",\"");
    for (; *text; text++)
        web_put(*text == '"' ? "\"\"" : "%c", *text);
    web_put("\"");
}

/* All curves as csv */
WEB_EXPORT(web_curves) const char *web_curves(int digits)
{
    make_curves();
    web_text_clear();
    web_put("speed_m_s");
    for (int i = 0; i < curve_count; i++)
        put_quoted(curves[i].label);
    for (int k = 0; k < POINTS; k++) {
        web_put("\n%.*g", digits, speed_of(k));
        for (int i = 0; i < curve_count; i++)
            web_put_cell(',', curves[i].eps[k], digits);
    }
    web_put("\n");
    return web_text();
}
