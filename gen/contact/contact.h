/* SPDX-License-Identifier: MIT */
/* The contact of a request of corgen contact or corgen sample: cor/scene.h, where laws without functions are enclosed,
 * some milliseconds for each speed */
#ifndef COR_GEN_CONTACT_CONTACT_H
#define COR_GEN_CONTACT_CONTACT_H

#include "embed/request.h"

/* The names of the laws of --law, with a NULL at the end */
extern const char *const contact_law_names[];

/* One contact, or one for each end at which a restitution may have been measured */
struct contacts {
    struct cor_scene scene;
    struct law law; /* of the scene */
    int count;
    struct cor_scene_contact contact[COR_SCENE_ENDS];
};

/* Returns STATUS_OK, STATUS_USAGE after a message that says what is missing or contradictory, or STATUS_FAILED. */
int contacts_of_request(struct contacts *contacts, const struct embed_request *request);
/* The same for other commands, which refuse a contact that adheres as in JKR, whose ends are others */
int contacts_without_jkr(struct contacts *contacts, const struct embed_request *request);

/* The law of a contact, its yield speed and its liquid as text: "x'' + beta x^(1/2) x' + x^(3/2) = 0" */
enum { CONTACT_LAW_TEXT = 256 };
const char *contact_law_text(char text[CONTACT_LAW_TEXT], const struct cor_scene_contact *contact,
                             const struct law *law);

/* Warns on stderr where the spheres of a law without yield would yield at this impact speed. */
void contact_warn_yield(const struct contacts *contacts, double speed_m_s);

/* The exit status of a function of cor/scene.h for such a contact */
int contact_status(int status);

struct law contact_law(const struct cor_exponents *exponents);

cor_scene_solver contact_enclosed;

#endif
