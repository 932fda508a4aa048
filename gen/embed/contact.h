/* SPDX-License-Identifier: MIT */
/* beta of a contact as a function of the impact speed, from materials or from g* */
#ifndef COR_GEN_EMBED_CONTACT_H
#define COR_GEN_EMBED_CONTACT_H

#include "embed/request.h"

/* beta_per_root of beta = beta_per_root (speed/(m/s))^(1/5), enclosed to `prec` bits. The request has passed
 * embed_request_check. */
void embed_contact_beta_per_root(arb_t beta_per_root, const struct embed_request *request, slong prec);

#endif
