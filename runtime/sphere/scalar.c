/* SPDX-License-Identifier: MIT */
#include "cor/sphere.h"
#include "runtime/sphere/eval.h"
#include "runtime/sphere/float_exceptions.h"

/* NARROW_BOUNDED is for functions that cannot exceed the largest float. */
#define NARROW_BOUNDED(x) ((float)(x))
#define SPHERE_FUNCTION(quantity, narrow) COR_SPHERE_SCALARS(quantity, cor_inline_##quantity, narrow)
SPHERE_FUNCTION(eps_zero_overlap, NARROW_BOUNDED)
SPHERE_FUNCTION(eps_zero_force, NARROW_BOUNDED)
SPHERE_FUNCTION(loss_zero_overlap, NARROW_BOUNDED)
SPHERE_FUNCTION(loss_zero_force, NARROW_BOUNDED)
SPHERE_FUNCTION(beta_zero_overlap, cor_inline_narrow)
SPHERE_FUNCTION(beta_zero_force, cor_inline_narrow)
SPHERE_FUNCTION(duration_zero_overlap, cor_inline_narrow)
SPHERE_FUNCTION(duration_zero_force, NARROW_BOUNDED)
SPHERE_FUNCTION(max_overlap, NARROW_BOUNDED)
SPHERE_FUNCTION(time_of_max_overlap, NARROW_BOUNDED)
