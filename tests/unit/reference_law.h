/* SPDX-License-Identifier: MIT */
/* Restitution of the laws of law.h in long double, by other formulas than the library's: what their doubles are judged by.
 * Each function gives L = -ln(eps), relative error some 2^-62. eps and 1 - eps follow by expl and expm1l, which keep 2^-60
 * while L is below 16; beyond, tests/accuracy asks MPFR. */
#ifndef COR_TESTS_REFERENCE_LAW_H
#define COR_TESTS_REFERENCE_LAW_H

enum law_end { LAW_ZERO_OVERLAP, LAW_ZERO_FORCE, LAW_LIMITED, LAW_APPROACH_ONLY, LAW_ENDS };

/* The linear dashpot and Tsuji's damping, zeta > 0: acos and acosh, and the one formula where zeta = 1 */
long double reference_ratio_exponent(enum law_end end, long double zeta);

/* Hunt and Crossley: -ln(beta eps/beta) from f(-h) = f(beta), f by its series or by log1pl; beta > -1, not 0. */
long double reference_hunt_crossley_loss(long double beta);
long double reference_hunt_crossley_eps(long double beta);
/* With damping while approaching only */
long double reference_hunt_crossley_approach_loss(long double beta);
long double reference_hunt_crossley_approach_eps(long double beta);

#endif
