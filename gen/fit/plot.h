/* SPDX-License-Identifier: MIT */
/* A picture of the data, their error bars, the fitted curves and the residuals, drawn by gnuplot. */
#ifndef COR_GEN_FIT_PLOT_H
#define COR_GEN_FIT_PLOT_H

#include <stdio.h>

#include "fit/compare.h"

/* Writes a picture in the format of `path` (gnuplot.h). The title is that of the data. Returns STATUS_OK, or
 * STATUS_FAILED after a message. */
int fit_plot(const struct fit_comparison *comparison, const struct fit_data *data, const char *title, FILE *out,
             const char *path);

#endif
