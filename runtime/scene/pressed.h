/* SPDX-License-Identifier: MIT */
/* The collision x'' + beta x^b x' + x^a = f, x(0) = 0, x'(0) = 1, under a constant force f > 0 that presses the bodies
 * together (docs/theory.md, 24) */
#ifndef COR_RUNTIME_SCENE_PRESSED_H
#define COR_RUNTIME_SCENE_PRESSED_H

#include "runtime/scene/motion.h"

/* The largest force of x'' + damper x^b x' + elastic x^a = 0; NaN where the motion takes too many steps */
double cor_pressed_force_max(const struct cor_exponents *law, double elastic, double damper);

/* `force_max` is that of x^a + beta x^b x'. Returns COR_OK, or COR_FAULT_PRESSED where the motion takes too many
 * steps. */
int cor_pressed_solve(struct cor_full_impact *impact, const struct cor_exponents *law, double beta, double f);

/* x'' + damping x^b x' + x^a = 1: the impact speed up to which the bodies stay together; infinite: every speed, or
 * those up to 1e9 and more */
double cor_pressed_sticking_speed(const struct cor_exponents *law, double damping, int end);

#endif
