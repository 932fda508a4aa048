/* SPDX-License-Identifier: MIT */
/* Draws pictures with gnuplot, in the style of the project's figures (docs/style.gp). */
#ifndef COR_GEN_SUPPORT_GNUPLOT_H
#define COR_GEN_SUPPORT_GNUPLOT_H

#include <stddef.h>
#include <stdio.h>

/* Checks the ending of a picture's file name, which sets the format: .svg, .png or .pdf; none means .svg. Returns
 * STATUS_OK, or STATUS_USAGE after a message that names the option --plot. */
int gnuplot_check(const char *path);

/* Begins a script: terminal, colours (black, grey, light, blue, red, green, violet, amber), axes. Returns NULL after a
 * message if the script cannot be created. */
FILE *gnuplot_begin(int width, int height);

/* Runs and closes the script, which contains its data. Copies to `out` the picture that the script prints, in the
 * format of `path`; svg without the lines that name the version of gnuplot. Returns STATUS_OK, or STATUS_FAILED after a
 * message. */
int gnuplot_run(FILE *script, FILE *out, const char *path);

/* Writes any text as a string of gnuplot, "...", which appears in the picture as xprintable(text). */
void gnuplot_quote(FILE *script, const char *text);

/* A curve eps(speed). Speeds are positive and rise; an eps of NaN is omitted. */
struct eps_curve {
    const char *title;
    const double *speed, *eps;
    size_t count;
};

/* Draws curves with the label of the abscissa, and eps from `least` to 1. least = NAN: from the smallest eps. Writes
 * the picture in the format of `path`, whole or not at all. Returns STATUS_OK, or STATUS_FAILED after a message, also
 * if gnuplot is not installed. */
int eps_plot(const char *path, const char *title, const char *label, double least, const struct eps_curve *curve,
             size_t curves);

#endif
