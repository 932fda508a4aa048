/* SPDX-License-Identifier: MIT */
/* Declares the request of corgen embed, plan, contact, sample and fit: the numbers of a scene (cor/scene.h) as written.
 * Its functions report missing or contradictory numbers. */
#ifndef COR_GEN_EMBED_REQUEST_H
#define COR_GEN_EMBED_REQUEST_H

#include "cor/scene.h"
#include "series/law.h"
#include "series/series.h"
#include "support/decimal.h"

/* The numbers of a request: the numbers of cor/scene.h, the range of speeds in m/s, the tolerance and the parameters of
 * own laws (own_law.h). The tolerance is a relative error of eps. */
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
/* The own laws of --law (own_law.h), numbered after the laws of cor/law.h */
enum { EMBED_LAW_POWER = COR_LAW_ELASTIC_PLASTIC + 1, EMBED_LAW_EXPONENTIAL, EMBED_LAW_TABLE };
extern const char *const embed_law_names[]; /* ends with NULL */

/* The use for which a form must be cheapest: single calls, vectorised loops, or a mixture. PURPOSE_REBOUND
 * means the single calls of REBOUND's callback. */
enum embed_purpose { PURPOSE_BALANCED, PURPOSE_SCALAR, PURPOSE_ARRAY, PURPOSE_REBOUND };
extern const char *const embed_purpose_names[]; /* ends with NULL, like the next arrays */

enum embed_type { EMBED_DOUBLE, EMBED_FLOAT };
extern const char *const embed_type_names[];
extern const char *const embed_adhesion_names[]; /* words of --adhesion-model by enum cor_adhesion; ends with NULL */

struct embed_request {
    struct decimal number[EMBED_NUMBERS]; /* text NULL: not given; viscosities: see `viscosity` */
    const char *viscosity[2];             /* "ETA1,ETA2" in Pa s of each body; NULL: not given */
    int end;                              /* index of the word of --end; or COR_BOTH_ENDS */
    enum embed_purpose purpose;
    enum embed_type type;
    int law;                       /* enum cor_law up to COR_LAW_ELASTIC_PLASTIC, or an own law */
    const char *table;             /* the file of EMBED_LAW_TABLE; NULL: not given */
    const char *elastic, *damping; /* exponents as written; NULL: the exponents of the law */
    bool wall;                     /* body 2 is flat and cannot move */
    const char *name;              /* name of the function; NULL: cor_scene_eps */
    int adhesion_model;            /* enum cor_adhesion */
    int equivalent;                /* enum cor_equivalence; set by corgen contact only */
};

bool embed_given(const struct embed_request *request, int number);
double embed_number(const struct embed_request *request, int number); /* the nearest double */
/* Reads "ETA1,ETA2", two numbers without a sign. */
bool embed_viscosity(struct decimal eta[2], const char *text);

/* Returns the malloc'ed options of a request as written, such as " --speed-min 0.1 --law tsuji". Omits options that
 * only a header has. Breaks lines that would be longer than `width`, for a banner. */
char *embed_options(const struct embed_request *request, int width);
const char *embed_end_option(const struct embed_request *request); /* " --end zero-force"; empty for an own law */

#define EMBED_COARSEST 0.1 /* the coarsest tolerance of a header */

/* Checks min < max and least <= tolerance <= most, with a tolerance below 1. Returns STATUS_OK, or STATUS_USAGE after a
 * message. */
int embed_check_numbers(const struct decimal *number, double min, double max, double least, double most);

/* Checks that the range of speeds and the tolerance suit the type. Returns STATUS_OK, or STATUS_USAGE after a message
 * on stderr. */
int embed_request_check(const struct embed_request *request);

/* True if a constant force acts, from gravity or DMT adhesion */
bool embed_is_pressed(const struct embed_request *request);

/* Makes the scene of a request, without a solver. The end `surface` becomes COR_END_ZERO_FORCE. A viscosity that cannot
 * be read becomes -1. Returns STATUS_OK, or STATUS_USAGE after a message. */
int embed_request_scene(struct cor_scene *scene, const struct embed_request *request);

/* Do the same as cor_scene_of_body and cor_scene_mass_is_given, with the decimal numbers as the user wrote them. */
const struct decimal *embed_number_of_body(const struct embed_request *request, int number, int body);
bool embed_mass_is_given(const struct embed_request *request, int body);

#endif
