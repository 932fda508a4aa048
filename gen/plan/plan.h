/* SPDX-License-Identifier: MIT */
/* A plan: ways to get a number of a collision, how far each is off over a range of speeds, what it costs, and the
 * cheapest that is near enough. */
#ifndef COR_GEN_PLAN_PLAN_H
#define COR_GEN_PLAN_PLAN_H

#include <stdbool.h>
#include <stdio.h>

#include "embed/request.h"
#include "support/output.h"

struct embed_form;

/* What corgen plan is asked for. points: 0 for the default. */
enum plan_quantity { PLAN_EPS, PLAN_CONTACT_TIME, PLAN_COMPRESSION };
extern const char *const plan_quantity_names[]; /* ends with NULL */

struct plan_spheres_request {
    struct embed_request scene; /* its tolerance: 1e-15 to below 1 */
    slong points;
};

struct plan_disks_request {
    struct decimal speed_min, speed_max; /* in sqrt(E/rho) */
    struct decimal tolerance, poisson;
    enum plan_quantity quantity;
    slong points;
};

/* Between the points the error may be a little larger. */
#define PLAN_MARGIN 0.97

enum {
    PLAN_NAME = 48,
    PLAN_DEFAULT_POINTS = 33,
    PLAN_DEFAULT_POINTS_DISKS = 9,
    PLAN_MIN_POINTS = 2,
    PLAN_MAX_POINTS = 1000
};

enum plan_verdict {
    PLAN_CHOSEN,
    PLAN_MEETS,   /* the tolerance, at a higher cost */
    PLAN_MISSES,  /* it */
    PLAN_OUTSIDE, /* has no value, or is not to be trusted, somewhere in the range */
    PLAN_SHOWN    /* nothing to choose: what a mistake costs */
};

struct plan_model {
    char name[PLAN_NAME]; /* without commas and quotation marks */
    double *value;        /* at each point; NaN: none */
    double *error;        /* likewise; relative, but absolute for eps of disks */
    double worst;         /* the largest error, elsewhere included; INFINITY where one is missing */
    slong worst_at;
    double cost;            /* ns for each collision */
    const char *leaves_out; /* in words */
    char *use;              /* the exact command or call; malloc'ed, lines that end with \n */
    double elsewhere;       /* an error that is known from other places than the points; 0 for none */
    bool outside, shown;
    bool promised; /* error: what the library promises; the uncertainty of the truth does not count */
    enum plan_verdict verdict;
    /* spheres: the model itself, at a speed that has this beta; NULL where there are but the values at the points */
    double (*eps)(const struct plan_model *model, double speed, double beta);
    double number[4];
    const double *coefficient; /* of a quotient of degrees m and n in beta or its square root */
    slong m, n, root;
    const struct embed_form *form;
};

struct plan {
    const char *argument; /* what the points are of: "beta" or "speed" */
    const char *quantity; /* "eps", "contact time", "largest compression" */
    char *title;          /* lines that end with \n */
    const char *unit;     /* of the tolerance: "relative error", "error" */
    const char *note;     /* how errors and costs are known; likewise */
    char *remark;         /* what no model says; likewise; NULL: nothing */
    double tolerance;
    slong points;
    double *speed, *at;  /* at: the argument */
    double *truth;       /* the quantity */
    double *uncertainty; /* of the truth, in the measure of the errors */
    struct plan_model *model;
    int models;
    int chosen;  /* -1: none */
    void *owned; /* what the models point to; plan_spheres.c */
};

/* Points from speed_min to speed_max, even in their logarithm, both ends included. */
void plan_init(struct plan *plan, slong points, double speed_min, double speed_max);
void plan_clear(struct plan *plan); /* not *owned */

/* A new last model, its values NaN. The name is a format. Valid until the next is added. */
struct plan_model *plan_add(struct plan *plan, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Text that is printed to malloc'ed memory. */
char *plan_text(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* error = |value/truth - 1|, or |value - truth|, at every point. */
void plan_compare(const struct plan *plan, struct plan_model *model, bool relative);

/* Fills worst and verdict of all, and chosen: of those that meet the tolerance at every point, uncertainty of the truth
 * included, the one of least cost, of these the one of least error. */
void plan_choose(struct plan *plan);

/* FORMAT_TEXT, FORMAT_CSV or FORMAT_JSON */
void plan_print(const struct plan *plan, enum output_format format, FILE *file);

/* Each returns STATUS_OK, or another status after a sentence on stderr; clear it in any case. */
int plan_spheres(struct plan *plan, const struct plan_spheres_request *request);
void plan_spheres_clear(struct plan *plan);
int plan_disks(struct plan *plan, const struct plan_disks_request *request);

#endif
