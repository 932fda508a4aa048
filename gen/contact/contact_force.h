/* SPDX-License-Identifier: MIT */
/* The largest force of a collision */
#ifndef COR_GEN_CONTACT_CONTACT_FORCE_H
#define COR_GEN_CONTACT_CONTACT_FORCE_H

#include "series/law.h"

/* The largest value of x^a + beta x^b x' during the collision x'' + beta x^b x' + x^a = 0, x(0) = 0, x'(0) = 1. In SI
 * units the largest force is m g/T times this number, where T is the unit of time.
 *
 * Relative error: CONTACT_FORCE_MAX_ERROR, sampled in tests/gen/test_contact.c and test_contact_force.c. Where q = 0
 * (the damping is zeta) and where a = b the result is a closed form. Otherwise an adaptive Runge-Kutta method
 * integrates until no larger force can follow. Where the spring is too weak to matter, the limit of strong damping is
 * the result. 0 <= damping < inf. */
#define CONTACT_FORCE_MAX_ERROR 1e-12
double contact_force_max(const struct law *law, double damping);

#endif
