/* SPDX-License-Identifier: MIT */
/* Tables, sentences and a picture of the fits of corgen fit */
#ifndef COR_GEN_FIT_REPORT_H
#define COR_GEN_FIT_REPORT_H

#include <stdio.h>

#include "fit/compare.h"
#include "support/output.h"

/* The table, the models with the least AIC first: a row for each parameter. As text, the remarks follow. */
struct fit_report {
    const struct fit_data *data;
    const struct fit_request *request;
    struct fit_comparison comparison;
    struct fit_outliers outliers;
    struct fit_comparison without_outliers; /* if there are outliers */
};
void fit_report_print(const struct fit_report *report, enum output_format format, FILE *file);

/* What the data are, which models fit and which do not. The lines are for a person; every line ends with LF. */
void fit_report_remarks(const struct fit_report *report, FILE *file);

/* Writes a picture of the data, their error bars, the fitted curves and the residuals, drawn by gnuplot in the format
 * of `path` (gnuplot.h). The title is that of the data. Returns STATUS_OK, or STATUS_FAILED after a message. */
int fit_plot(const struct fit_comparison *comparison, const struct fit_data *data, const char *title, FILE *out,
             const char *path);

#endif
