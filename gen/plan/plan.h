/* SPDX-License-Identifier: MIT */
/* A plan compares models that compute a quantity of a collision: their errors over a range of speeds, and their costs.
 * It chooses the cheapest model within the tolerance. */
#ifndef COR_GEN_PLAN_PLAN_H
#define COR_GEN_PLAN_PLAN_H

#include <stdbool.h>
#include <stdio.h>

#include "embed/request.h"
#include "support/output.h"

enum plan_quantity { PLAN_EPS, PLAN_CONTACT_TIME, PLAN_COMPRESSION };
extern const char *const plan_quantity_names[]; /* ends with NULL */

/* Fraction of the tolerance that errors at the points may use; errors between points may be slightly larger. */
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
    PLAN_MEETS,   /* meets the tolerance; another model is chosen */
    PLAN_MISSES,  /* misses the tolerance */
    PLAN_OUTSIDE, /* no reliable value somewhere in the range */
    PLAN_SHOWN    /* shown only as a warning, never chosen */
};

struct plan_model {
    char name[PLAN_NAME]; /* name; contains no comma and no quotation mark */
    double *value;        /* value at each point; NaN: none */
    double *error;        /* error at each point */
    double worst;         /* largest error, `elsewhere` included; INFINITY if an error is missing */
    slong worst_at;
    double cost;            /* nanoseconds for each collision */
    const char *leaves_out; /* the neglected effects, as text */
    char *use;              /* the exact command or call; malloc'ed, lines that end with \n */
    double elsewhere;       /* largest error at samples other than the points; 0: none */
    bool outside, shown;
    bool promised; /* the error is the library's bound and does not depend on the reference */
    enum plan_verdict verdict;
};

struct plan {
    const char *argument; /* name of the points' argument: "beta" or "speed" */
    const char *quantity; /* "eps", "contact time", "largest compression" */
    char *title;          /* lines that end with \n */
    bool relative;        /* errors and tolerance are relative */
    const char *note;     /* origin of errors and costs; lines that end with \n */
    char *remark;         /* a remark on other effects; lines that end with \n; NULL: none */
    double tolerance;
    slong points;
    double *speed, *at;  /* speed and argument of each point; allocated together with the next two */
    double *truth;       /* the quantity at each point */
    double *uncertainty; /* uncertainty of `truth`, in the unit of the errors */
    struct plan_model *model;
    int models;
    int chosen; /* -1: none */
};

/* Sets points from speed_min to speed_max, both included, equally spaced in their logarithm. */
void plan_init(struct plan *plan, slong points, double speed_min, double speed_max);
void plan_clear(struct plan *plan);

/* Adds a model with values NaN. The name is a format. The pointer is valid until the next call. */
struct plan_model *plan_add(struct plan *plan, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Sets cost, leaves_out and use. Also sets error = |value/truth - 1|, or |value - truth|, at every point, unless the
 * model has a promised error. */
void plan_model_is(const struct plan *plan, struct plan_model *model, double cost, const char *leaves_out, char *use);

/* Sets worst and verdict of all models, and `chosen`: the cheapest model whose error plus the uncertainty of the
 * reference meets the tolerance at every point. Among equally cheap models it is the most accurate one. */
void plan_choose(struct plan *plan);

void plan_print(const struct plan *plan, enum output_format format, FILE *file);

/* Fill a plan, which the caller always clears. Return STATUS_OK, or another status after a message. request, contact:
 * the scene without its constant force. with_force, pressed: the scene with the force. If no force acts, they equal
 * request and contact. points: 0 for the default. For disks the request has the speeds in sqrt(E/rho), tolerance and
 * Poisson's ratio. */
int plan_spheres(struct plan *plan, const struct embed_request *request, const struct cor_scene_contact *contact,
                 const struct embed_request *with_force, const struct cor_scene_contact *pressed, slong points);
int plan_disks(struct plan *plan, const struct embed_request *request, enum plan_quantity quantity, slong points);

/* Returns a malloc'ed sentence about the energy lost to elastic waves (cor_contact_wave_loss) if the sphere hits a
 * massive wall of its own density. speed: the largest speed; eps: the restitution there from the scene's dissipation
 * time. NULL for a scene without a wall or without materials */
char *plan_wave_remark(const struct embed_request *request, double speed, double eps);

#endif
