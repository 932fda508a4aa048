/* SPDX-License-Identifier: MIT */
/* A scene as the subcommands embed, plan, contact, sample and fit read it: numbers with their texts, and the sentences
 * for those that are missing or contradict one another (cor/scene.h) */
#ifndef COR_GEN_EMBED_REQUEST_H
#define COR_GEN_EMBED_REQUEST_H

#include "cor/scene.h"
#include "series/law.h"
#include "series/series.h"
#include "support/decimal.h"

/* The numbers of cor/scene.h, of a range of speeds in m/s, and of laws of one's own (own_law.h). The tolerance is a
 * relative error of eps. */
enum {
    EMBED_SPEED_MIN = COR_SCENE_NUMBERS,
    EMBED_SPEED_MAX,
    EMBED_TOLERANCE,
    EMBED_COEFFICIENT,
    EMBED_EXPONENT,
    EMBED_EPS_INF,
    EMBED_DECAY_SPEED,
    EMBED_NUMBERS
};
/* Laws of one's own, as --law has them; they follow the laws of cor/law.h */
enum { EMBED_LAW_POWER = COR_LAW_ELASTIC_PLASTIC + 1, EMBED_LAW_EXPONENTIAL, EMBED_LAW_TABLE };
extern const char *const embed_law_names[]; /* ends with NULL */

/* The purpose of a form: single calls, vectorised loops, or both; or single calls by REBOUND, with its callback */
enum embed_purpose { PURPOSE_BALANCED, PURPOSE_SCALAR, PURPOSE_ARRAY, PURPOSE_REBOUND };
extern const char *const embed_purpose_names[]; /* these two end with NULL */

enum embed_type { EMBED_DOUBLE, EMBED_FLOAT };
extern const char *const embed_type_names[];
extern const char *const embed_adhesion_names[]; /* of enum cor_adhesion, as options have them; ends with NULL */

struct embed_request {
    struct decimal number[EMBED_NUMBERS]; /* text NULL: not given; none for viscosities */
    const char *viscosity[2];             /* "ETA1,ETA2" in Pa s of each body; NULL: not given */
    int end;                              /* enum cor_end as an option has it, or COR_BOTH_ENDS */
    enum embed_purpose purpose;
    enum embed_type type;
    int law;                       /* enum cor_law up to COR_LAW_ELASTIC_PLASTIC, or one's own */
    const char *table;             /* the file of EMBED_LAW_TABLE; NULL: not given */
    const char *elastic, *damping; /* the exponents as written; NULL: those of the law */
    bool wall;                     /* body 2 is flat and held fast */
    const char *name;              /* name of the function; NULL: cor_scene_eps */
    int adhesion_model;            /* enum cor_adhesion */
    int equivalent;                /* enum cor_equivalence; only corgen contact has it */
};

bool embed_given(const struct embed_request *request, int number);
double embed_number(const struct embed_request *request, int number); /* the nearest double */
/* Reads "ETA1,ETA2", two numbers without a sign. */
bool embed_viscosity(struct decimal eta[2], const char *text);

/* The options of a request from " --speed-min 0.1" to " --law tsuji" as written, malloc'ed, without those of the header
 * alone. Lines of numbers that would be longer than `width` are continued as in a banner. */
char *embed_options(const struct embed_request *request, int width);
const char *
embed_end_option(const struct embed_request *request); /* " --end zero-force"; empty for a law of one's own */

#define EMBED_COARSEST 0.1 /* the coarsest tolerance of a header */

/* Checks that the range of speeds and the tolerance suit the type. Returns STATUS_OK, or STATUS_USAGE after a message
 * on stderr. */
int embed_request_check(const struct embed_request *request);

/* True if a constant force acts, of gravity or of DMT adhesion */
bool embed_is_pressed(const struct embed_request *request);

/* The scene of a request without a solver; its end is COR_END_ZERO_FORCE for the surface, too. Returns STATUS_OK, or
 * STATUS_USAGE after a message. A viscosity that cannot be read is negative. */
int embed_request_scene(struct cor_scene *scene, const struct embed_request *request);

/* As cor_scene_of_body and cor_scene_mass_is_given, exactly as written */
const struct decimal *embed_number_of_body(const struct embed_request *request, int number, int body);
bool embed_mass_is_given(const struct embed_request *request, int body);

#endif
