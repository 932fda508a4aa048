/* SPDX-License-Identifier: MIT */
/* Fits several models to the same data, ranks them by AIC, and says which fit. */
#ifndef COR_GEN_FIT_COMPARE_H
#define COR_GEN_FIT_COMPARE_H

#include "fit/likelihood.h"
#include "support/output.h"

enum { FIT_MAX_MODELS = 24, FIT_MAX_OUTLIERS = 8 };

struct fit_request {
    bool wanted[FIT_MAX_MODELS]; /* by index in fit_models */
    bool robust;
    const struct fit_bodies *bodies; /* NULL: not given */
};

struct fit_comparison {
    struct fit_estimate estimate[FIT_CURVES];
    bool used[FIT_CURVES];      /* curves of the wanted models, if they have enough points */
    int ranked[FIT_MAX_MODELS]; /* indices in fit_models, the least AIC first; equal AICs in the order of the table */
    int models;                 /* how many are ranked */
    int too_many_parameters;    /* models left out because the points are too few */
};

/* Marks the models of a list of names, "viscoelastic,power-law" or "all". If end is not NULL, only models of
 * that end, and those whose ends coincide. Returns STATUS_OK, or STATUS_USAGE after a message. */
int fit_request_models(struct fit_request *request, const char *names, const char *end);

void fit_compare(struct fit_comparison *comparison, const struct fit_data *data, const struct fit_request *request);

/* Lines that lie too far from the curve of the first model of the robust fits. The line farthest from the robust fit
 * is left out while n normal errors would reach so far with a probability below 1/20, at most FIT_MAX_OUTLIERS and a
 * fourth of the points. Then the nearest is put back while the probability of one, Student's t times the number of
 * lines, is FIT_SIGNIFICANCE or more. With given eps_sigma the tail is the normal one; if those are too small for the
 * other points, too, they are scaled to chi^2 = n - k first. */
struct fit_outliers {
    int count;
    struct fit_distance outlier[FIT_MAX_OUTLIERS]; /* in sigma of the errors, without the outliers; above 0: eps is too
                                                    * large, or a time late */
    enum fit_curve curve;
    struct fit_data rest; /* the points without them, if there are any; to be cleared by fit_data_clear */
};
void fit_find_outliers(struct fit_outliers *outliers, const struct fit_data *data, const struct fit_request *request);

/* Whether nothing speaks against the curve: its p value is at least FIT_SIGNIFICANCE, or not known. */
bool fit_is_accepted(const struct fit_estimate *estimate);

/* ---- report.c, plot.c: tables, sentences and a picture ---- */

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
int fit_plot(const struct fit_report *report, const char *title, FILE *out, const char *path);

#endif
