/* SPDX-License-Identifier: MIT */
/* beta of a contact as a function of the impact speed, as exact as its numbers are written. cor_scene_contacts has
 * accepted them, and computes the same in doubles. */
#ifndef COR_GEN_EMBED_CONTACT_H
#define COR_GEN_EMBED_CONTACT_H

#include "embed/request.h"

/* beta_per_root of beta = beta_per_root (speed/(m/s))^q, q = 1/5 for spheres, enclosed to `prec` bits, or, from a
 * restitution, to 2^-79 of itself. Returns STATUS_OK, or STATUS_FAILED after a message. */
int embed_contact_beta_per_root(arb_t beta_per_root, const struct embed_request *request,
                                const struct cor_scene_contact *contact, const struct law *law, slong prec);

/* eps of one collision, enclosed to `bits` bits; `end` is that of contact. Returns the same. */
int embed_contact_eps(arb_t eps, const arb_t beta, const struct law *law, int end, slong bits);

#endif
