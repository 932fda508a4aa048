/* SPDX-License-Identifier: MIT */
/* The request of corgen embed, and of corgen plan for spheres: parsed numbers with their texts */
#ifndef COR_GEN_EMBED_REQUEST_H
#define COR_GEN_EMBED_REQUEST_H

#include "series/law.h"
#include "series/series.h"
#include "support/decimal.h"

/* Speeds are in m/s, the tolerance is a relative error of eps, and the other numbers are in SI units. The index of a
 * number of body 2 is that of body 1 plus a constant. */
enum embed_number {
    EMBED_SPEED_MIN,
    EMBED_SPEED_MAX,
    EMBED_TOLERANCE,
    EMBED_G_STAR,
    EMBED_YOUNG,
    EMBED_POISSON,
    EMBED_RADIUS,
    EMBED_DENSITY,
    EMBED_MASS,
    EMBED_DISSIPATION_TIME,
    EMBED_YOUNG_2,
    EMBED_POISSON_2,
    EMBED_RADIUS_2,
    EMBED_DENSITY_2,
    EMBED_MASS_2,
    EMBED_DISSIPATION_TIME_2,
    EMBED_BETA, /* at the speed EMBED_AT */
    EMBED_AT,
    EMBED_STIFFNESS, /* K, C and m of m x'' + C x^b x' + K x^a = 0, SI units */
    EMBED_DAMPING_COEFFICIENT,
    EMBED_EFFECTIVE_MASS,
    EMBED_NUMBERS,
    EMBED_BODY = EMBED_YOUNG_2 - EMBED_YOUNG /* number of indices of a body */
};
extern const char *const embed_number_names[EMBED_NUMBERS]; /* names of the options: "speed-min", ... */

/* The purpose of a form: single calls, vectorised loops, or both */
enum embed_purpose { PURPOSE_BALANCED, PURPOSE_SCALAR, PURPOSE_ARRAY };
extern const char *const embed_purpose_names[]; /* these two end with NULL */

enum embed_type { EMBED_DOUBLE, EMBED_FLOAT };
extern const char *const embed_type_names[];

/* Laws with a name, --law. The exponents of the first are the default of --elastic and --damping. */
enum embed_law { EMBED_VISCOELASTIC, EMBED_LINEAR, EMBED_TSUJI, EMBED_HUNT_CROSSLEY, EMBED_HERTZ_DASHPOT, EMBED_LAWS };
extern const char *const embed_law_names[];

struct embed_request {
    struct decimal number[EMBED_NUMBERS]; /* text NULL: not given */
    enum contact_end end;
    enum embed_purpose purpose;
    enum embed_type type;
    enum embed_law law;            /* by name */
    const char *elastic, *damping; /* the exponents as written; NULL: those of the name */
    bool wall;                     /* body 2 is flat and held fast */
    const char *name;              /* name of the function; NULL: cor_scene_eps */
};

bool embed_given(const struct embed_request *request, enum embed_number which);
double embed_number(const struct embed_request *request, enum embed_number which); /* the nearest double; whether the
                                                                                    * number is given */

#define EMBED_COARSEST 0.1 /* the coarsest tolerance of a header */

/* Checks that eps of the law depends on the speed, that the range of speeds and the tolerance suit the type, and that
 * the request gives all numbers of the contact and no contradiction. Returns STATUS_OK, or STATUS_USAGE after a message
 * on stderr. */
int embed_request_check(const struct embed_request *request);

/* Sets the law of a request. Returns STATUS_OK, or STATUS_USAGE after a message. */
int embed_request_law(struct law *law, const struct embed_request *request);

/* " --law tsuji", " --elastic 2 --damping 1/2", or nothing for viscoelastic spheres by default */
enum { EMBED_LAW_OPTIONS = 192 };
const char *embed_law_options(char text[EMBED_LAW_OPTIONS], const struct embed_request *request);

/* The number of body 2 if it is given, otherwise that of body 1. A mass of body 2 replaces the density of body 1, and a
 * density the mass. */
const struct decimal *embed_number_of_body(const struct embed_request *request, enum embed_number which, int body);
bool embed_mass_is_given(const struct embed_request *request, int body); /* otherwise the density is given */

#endif
