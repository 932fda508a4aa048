/* SPDX-License-Identifier: MIT */
/* eps over the impact speed as a picture, drawn by gnuplot */
#ifndef COR_GEN_SUPPORT_EPS_PLOT_H
#define COR_GEN_SUPPORT_EPS_PLOT_H

#include <stddef.h>

/* A curve eps(speed). Speeds are positive and rise; an eps of NaN is left out. */
struct eps_curve {
    const char *title;
    const double *speed, *eps;
    size_t count;
};

/* Draws curves with the label of the abscissa, and eps from `least` to 1: 0, or NAN, from the least eps. Writes the
 * picture in the format of `path` (gnuplot.h), whole or not at all. Returns STATUS_OK, or STATUS_FAILED after a
 * message, also where gnuplot is not installed. */
int eps_plot(const char *path, const char *title, const char *label, double least, const struct eps_curve *curve,
             size_t curves);

#endif
