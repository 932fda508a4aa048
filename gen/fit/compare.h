/* SPDX-License-Identifier: MIT */
/* Fits several models to the same data and ranks them by AIC. */
#ifndef COR_GEN_FIT_COMPARE_H
#define COR_GEN_FIT_COMPARE_H

#include "fit/likelihood.h"

enum { FIT_MAX_MODELS = 16 };

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

/* Whether nothing speaks against the curve: its p value is at least FIT_SIGNIFICANCE, or not known. */
bool fit_is_accepted(const struct fit_estimate *estimate);

#endif
