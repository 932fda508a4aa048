/* SPDX-License-Identifier: MIT */
/* eps over the impact speed as a picture, drawn by gnuplot */
#ifndef COR_GEN_CONTACT_CONTACT_PLOT_H
#define COR_GEN_CONTACT_CONTACT_PLOT_H

#include <stddef.h>

/* A curve eps(speed). Speeds are positive and rise; an eps of NaN is left out. */
struct contact_curve {
    const char *title;
    const double *speed_m_s, *eps;
    size_t count;
};

/* Writes an SVG file, whole or not at all. Returns STATUS_OK, or STATUS_FAILED after a message, also where gnuplot is
 * not installed. */
int contact_plot(const char *path, const char *title, const struct contact_curve *curve, size_t curves);

#endif
