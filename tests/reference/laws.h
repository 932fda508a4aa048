/* SPDX-License-Identifier: MIT */
/* Computes the restitution of the laws of law.h in long double by other formulas than the library's, as a reference.
 * Each function gives L = -ln(eps) with a relative error of about 2^-62. eps and 1 - eps follow by expl and expm1l,
 * with errors of 2^-60 while L is below 16; above, tests/accuracy uses MPFR. */
#ifndef COR_TESTS_REFERENCE_LAWS_H
#define COR_TESTS_REFERENCE_LAWS_H

#include "cor/law.h"

/* Returns L of the linear dashpot and Tsuji's damping for zeta > 0, from inverses of cos, tan, cosh and tanh. */
long double reference_ratio_exponent(enum cor_end end, long double zeta);

/* Returns L of Hunt and Crossley's law from f(-h) = f(beta), with f by its series or log1pl; beta > -1, not 0. */
long double reference_hunt_crossley_loss(long double beta);
long double reference_hunt_crossley_eps(long double beta);
/* As above, with damping during the approach only */
long double reference_hunt_crossley_approach_loss(long double beta);
long double reference_hunt_crossley_approach_eps(long double beta);

/* Returns the duration for Tsuji's damping, zeta > 0, or for COR_END_APPROACH_ONLY the time of the largest overlap. The
 * relative error is below 1e-17. At zero overlap zeta must be below 0.999. Uses double exponential quadrature of
 * exp(zeta s/5) (sin(om s)/om)^(-1/5). */
long double reference_tsuji_time(enum cor_end end, long double zeta);

/* Return the time of the largest overlap and the duration for Hunt and Crossley's law, -1 < beta < inf, not 0, elastic
 * exponents 0 <= a <= 100. The relative error is below 2e-15, and 1e-17 where |ln(beta)| is below 10. The method is
 * double exponential quadrature over the velocity, or over ln(1 + beta v) if beta > 2 or beta < -1/2. */
long double reference_crossley_time_of_max_overlap(long double a, long double beta);
long double reference_crossley_duration(long double a, long double beta);
long double reference_crossley_duration_approach_only(long double a, long double beta);
/* Returns half of the duration for beta = 0, by Gamma functions. */
long double reference_crossley_elastic_half(long double a);

#endif
