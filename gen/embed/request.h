/* SPDX-License-Identifier: MIT */
/* What corgen embed, and corgen plan for spheres, are asked for: numbers that have been parsed, with their texts. */
#ifndef COR_GEN_EMBED_REQUEST_H
#define COR_GEN_EMBED_REQUEST_H

#include "series/law.h"
#include "series/series.h"
#include "support/decimal.h"

/* Speeds in m/s, tolerance as a relative error of eps, the rest in SI units. The numbers of body 2 stand at a fixed
 * distance behind those of body 1. */
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
    EMBED_BODY = EMBED_YOUNG_2 - EMBED_YOUNG /* numbers of a body */
};
extern const char *const embed_number_names[EMBED_NUMBERS]; /* of the options that give them: "speed-min", ... */

/* What the time of a form counts: calls one at a time, loops that become vectors, or both. */
enum embed_purpose { PURPOSE_BALANCED, PURPOSE_SCALAR, PURPOSE_ARRAY };
extern const char *const embed_purpose_names[]; /* ends with NULL, as the next */

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
    const char *elastic, *damping; /* the exponents as they are written; NULL: those of the name */
    bool wall;                     /* body 2 is flat and held fast */
    const char *name;              /* of the function; NULL: cor_scene_eps */
};

bool embed_given(const struct embed_request *request, enum embed_number which);
double embed_number(const struct embed_request *request, enum embed_number which); /* the nearest double; it is given */

#define EMBED_COARSEST 0.1 /* the coarsest tolerance of a header */

/* Whether eps of the law depends on the speed, the range of speeds and the tolerance suit the type, and the contact has
 * all that it needs and nothing that contradicts it. STATUS_OK, or STATUS_USAGE after a sentence on stderr. */
int embed_request_check(const struct embed_request *request);

/* The law of a request. STATUS_OK, or STATUS_USAGE after a sentence. */
int embed_request_law(struct law *law, const struct embed_request *request);

/* " --law tsuji", " --elastic 2 --damping 1/2", or nothing for viscoelastic spheres by default */
enum { EMBED_LAW_OPTIONS = 192 };
const char *embed_law_options(char text[EMBED_LAW_OPTIONS], const struct embed_request *request);

/* The option that names body 2's number if it has one of its own, else body 1's. A mass of body 2 replaces the density
 * that body 2 would have from body 1, and a density the mass. */
const struct decimal *embed_number_of_body(const struct embed_request *request, enum embed_number which, int body);
bool embed_mass_is_given(const struct embed_request *request, int body); /* otherwise the density is */

#endif
