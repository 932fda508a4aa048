/* SPDX-License-Identifier: MIT */
/* Enclosed times of Tsuji's damping, of Hunt and Crossley's law and of the disk's contact law: quadrature of the
 * integrals of docs/laws.md and docs/theory-disks.md in interval (ball) arithmetic. Times of the laws of damping are in
 * units of (m/K)^(1/(a+1)) g^((1-a)/(a+1)). */
#ifndef COR_GEN_TABLES_LAW_TIMES_H
#define COR_GEN_TABLES_LAW_TIMES_H

#include "support/flint.h"

/* ENCLOSED is adaptive, proves its enclosure and takes 5 to 10 ms. GAUSS is a pair of Gauss-Legendre rules of 56
 * points. It is 20 times faster, but its interval omits the quadrature error. It serves for samples, which are compared
 * with enclosures. */
enum quadrature { QUADRATURE_ENCLOSED, QUADRATURE_GAUSS };

/* Frees the Gauss-Legendre rule. */
void law_times_clear(void);

/* ---- Tsuji's damping, (a, b) = (3/2, 1/4), by the damping ratio zeta > 0 ---- */

void tsuji_time_of_max_overlap(arb_t t, enum quadrature how, const arb_t zeta, slong prec);
void tsuji_duration_zero_force(arb_t t, enum quadrature how, const arb_t zeta, slong prec);
void tsuji_duration_limited(arb_t t, enum quadrature how, const arb_t zeta, slong prec);
/* exp(2 pi y) (1 - zeta^2)^(-2/5) V(y), y = zeta/(10 sqrt(1 - zeta^2)), zeta < 1, and V(y): closed forms, enclosed in
 * either case */
void tsuji_duration_zero_overlap(arb_t t, enum quadrature how, const arb_t zeta, slong prec);
void tsuji_overlap_factor(arb_t v, enum quadrature how, const arb_t y, slong prec);

/* ---- Hunt and Crossley's law with a = 1 or 3/2, by beta > 0 ---- */

void crossley_time_of_max_overlap_1(arb_t t, enum quadrature how, const arb_t beta, slong prec);
void crossley_time_of_max_overlap_3_2(arb_t t, enum quadrature how, const arb_t beta, slong prec);
void crossley_duration_1(arb_t t, enum quadrature how, const arb_t beta, slong prec);
void crossley_duration_3_2(arb_t t, enum quadrature how, const arb_t beta, slong prec);

/* ---- the disk's contact law, runtime/disk/quasistatic.c, by q >= 1/4 ---- */

/* The contact time, q = 2 ln(v_limit/v) */
void disk_contact_time(arb_t tau, enum quadrature how, const arb_t q, slong prec);
/* The load over the compression, pi/(1 + t), q = ln(delta_limit/delta): closed form */
void disk_load_factor(arb_t factor, enum quadrature how, const arb_t q, slong prec);

#endif
