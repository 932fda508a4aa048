/* SPDX-License-Identifier: MIT */
/* beta of a contact as a function of the impact speed: from materials, from g*, from beta at one speed, or from the
 * coefficients of the force */
#ifndef COR_GEN_EMBED_CONTACT_H
#define COR_GEN_EMBED_CONTACT_H

#include "embed/request.h"

/* beta_per_root of beta = beta_per_root (speed/(m/s))^q, q = 1/5 for spheres, enclosed to `prec` bits. The request has
 * passed embed_request_check. */
void embed_contact_beta_per_root(arb_t beta_per_root, const struct embed_request *request, const struct law *law,
                                 slong prec);

#endif
