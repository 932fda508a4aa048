/* SPDX-License-Identifier: MIT */
/* The request of corgen contact and corgen sample: a contact as numbers already parsed, and what each combination of
 * them means. Bodies and exponents are those of a scene (embed/request.h). */
#ifndef COR_GEN_CONTACT_CONTACT_REQUEST_H
#define COR_GEN_CONTACT_CONTACT_REQUEST_H

#include "contact/contact_model.h"
#include "embed/request.h"

enum contact_number {
    CONTACT_RESTITUTION, /* at the speed EMBED_AT, or at every speed where q = 0 */
    CONTACT_ZETA,
    CONTACT_PLATE_THICKNESS,
    CONTACT_NUMBERS
};

/* Laws with a name, --law: those of a scene, and Zener's plate */
enum { CONTACT_LAW_PLATE = EMBED_LAWS };
extern const char *const contact_law_names[];

enum { CONTACT_BOTH_ENDS = -1 };

struct contact_request {
    struct embed_request scene; /* bodies, stiffness, mass, damping, exponents */
    struct decimal number[CONTACT_NUMBERS];
    int law;                             /* index of contact_law_names */
    const char *viscosity, *viscosity_2; /* "ETA1,ETA2" in Pa s; NULL: not given */
    int end;                             /* enum contact_end, or CONTACT_BOTH_ENDS */
};

/* A contact; two, one for each end, if a measured eps was given and its end was not. */
struct contact_models {
    int count;
    struct contact_model model[CONTACT_ENDS];
    enum contact_end measured_end[CONTACT_ENDS]; /* where count is 2 */
};

/* Returns STATUS_OK, STATUS_USAGE after a message that says what is missing or contradictory, or STATUS_FAILED. */
int contact_request_models(struct contact_models *models, const struct contact_request *request);

#endif
