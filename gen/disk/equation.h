/* SPDX-License-Identifier: MIT */
/* Free modes of the elastic disk, E = rho = R = 1 in plane stress: the frequency equation, the exact count of its roots
 * and the amplitudes at the rim, in interval (ball) arithmetic.
 *
 * With w = omega^2, e = 1 + nu, s = 1 - nu, g = e w, the squared arguments are kappa^2 = s g and kappa'^2 = 2 g. The
 * equation needs only a_m(z) = kappa J_{m+1}(kappa)/J_m(kappa), z = kappa^2, of the Bessel functions. The recurrence
 * a_{m-1} = z/(2m - a_m) from any m > kappa computes a_m without overflow, and kappa J_n'/J_n = n - a_n. */
#ifndef COR_GEN_DISK_EQUATION_H
#define COR_GEN_DISK_EQUATION_H

#include "support/flint.h"

/* corgen refuses a nu closer to 1 or -1 than this: squares of the difference would underflow a double. */
#define DISK_MARGIN "1e-100"

struct disk {
    arb_t e, s; /* 1 + nu and 1 - nu */
    double e_double, s_double;
    slong prec; /* of the functions below; a copy of the struct may have another */
};

void disk_init(struct disk *d, const fmpq_t nu, slong prec);
void disk_clear(struct disk *d);

/* The result of an undecided count; more precision or another w may decide it. */
#define DISK_UNDECIDED (-1)

/* Number of roots of one n below omega, w = omega^2 > 0, without the translation n = 1, omega = 0; or DISK_UNDECIDED.
 * */
slong disk_count(const struct disk *d, slong n, const arb_t w);

/* A step of Newton's method: w (1 - step) is nearer to a root. Returns 0 if the interval is too wide. */
int disk_newton(arb_t step, const struct disk *d, slong n, const arb_t w);

/* C and S of a mode by (26), (28), C > 0, from an interval that contains the w of a root. Returns 0 if the interval is
 * too wide. */
int disk_amplitudes(arb_t c, arb_t s, const struct disk *d, slong n, const arb_t w);

#endif
