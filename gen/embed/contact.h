/* SPDX-License-Identifier: MIT */
/* beta of a contact as a function of the impact speed, as exact as its numbers are written. cor_scene_contacts has
 * accepted them, and computes the same in doubles. */
#ifndef COR_GEN_EMBED_CONTACT_H
#define COR_GEN_EMBED_CONTACT_H

#include "embed/request.h"

/* beta_per_root of beta = beta_per_root (speed/(m/s))^q, q = 1/5 for spheres, enclosed to `prec` bits, or, from a
 * restitution, to 2^-79 of itself, under a constant force 2^-149. Returns STATUS_OK, or STATUS_FAILED after a
 * message. */
int embed_contact_beta_per_root(arb_t beta_per_root, const struct embed_request *request,
                                const struct cor_scene_contact *contact, const struct law *law, slong prec);

/* f_1 of the constant force f = f_1 (speed/(m/s))^(-2a/(a+1)) of x'' + beta x^b x' + x^a = f; 0 without one */
void embed_contact_force(arb_t force, const struct embed_request *request, const struct law *law, slong prec);

/* eps of one collision, under a constant force that may be 0, enclosed to `bits` bits; `end` is that of contact.
 * Returns the same. */
int embed_contact_eps(arb_t eps, const arb_t beta, const arb_t force, const struct law *law, int end, slong bits);

/* v_y of elastic-plastic spheres in m/s, and the speed that a liquid takes on each way, 0 without one. The first
 * returns STATUS_OK, or STATUS_FAILED after a message. */
int embed_contact_yield_speed(arb_t speed, const struct embed_request *request, const struct cor_scene_contact *contact,
                              slong prec);
void embed_contact_liquid_speed(arb_t speed, const struct embed_request *request, slong prec);

/* eps of elastic-plastic spheres above the yield speed */
void embed_elastic_plastic_eps(arb_t eps, const arb_t speed, const arb_t yield_speed, slong prec);

#endif
