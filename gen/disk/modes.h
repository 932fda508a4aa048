/* SPDX-License-Identifier: MIT */
/* Computes the lowest free modes of an elastic disk, without gaps, all enclosed; docs/theory-disks.md, 11. */
#ifndef COR_GEN_DISK_MODES_H
#define COR_GEN_DISK_MODES_H

#include "cor/disk.h"
#include "support/flint.h"

#define DISK_MODES_MAX 10000000 /* largest number of modes of one disk */

/* Mode l = 0, 1, 2, ... of n. c = u_r(1) > 0 and s = u_phi(1), (28), normalised by (26). */
struct disk_mode {
    slong n, l;
    arb_t omega, c, s;
};

struct disk_modes {
    slong count;
    struct disk_mode *mode; /* by increasing omega */
};

void disk_modes_init(struct disk_modes *modes);
void disk_modes_clear(struct disk_modes *modes);

/* Computes the `count` lowest modes for -1 < nu < 1, at least DISK_MARGIN from the ends, and proves that no mode is
 * missing. The intervals of omega, c and s are so narrow that digits_of_ball gives `digits` decimal digits, and
 * digits_to_double the nearest double. For n = 0, s is exactly 0. The result does not depend on the number of threads,
 * parallel_threads(). Returns 0, or 1 after reporting the failure. */
int disk_modes_solve(struct disk_modes *modes, const fmpq_t nu, slong count, slong digits);

/* Computes the `count` lowest modes; each double is the one nearest to the exact value. modes->mode is malloc'ed.
 * Returns 0, or 1 after reporting the failure. */
int disk_modes_rounded(struct cor_disk_modes *modes, const fmpq_t nu, slong count);

/* Computes the mode (n, l) to about `bits` relative bits from an approximation to its omega, which may be wrong. For
 * omega = 0 it uses only the count, which is slower. Returns 0, or 1 after reporting the failure. */
int disk_mode_solve(struct disk_mode *mode, const fmpq_t nu, slong n, slong l, double omega, slong bits);
void disk_mode_init(struct disk_mode *mode);
void disk_mode_clear(struct disk_mode *mode);

/* ---- equation.c: the frequency equation, the exact count of its roots and the amplitudes at the rim, in interval
 * (ball) arithmetic ----
 *
 * With w = omega^2, e = 1 + nu, s = 1 - nu, g = e w, the squared arguments are kappa^2 = s g and kappa'^2 = 2 g. Of the
 * Bessel functions the equation needs only a_m(z) = kappa J_{m+1}(kappa)/J_m(kappa), z = kappa^2. The recurrence
 * a_{m-1} = z/(2m - a_m), started at any m > kappa, computes a_m without overflow, and kappa J_n'/J_n = n - a_n. */

/* corgen refuses a nu closer to 1 or -1 than this: squares of the difference would underflow a double. */
#define DISK_MARGIN "1e-100"

struct disk {
    arb_t e, s; /* 1 + nu and 1 - nu */
    double e_double, s_double;
    slong prec; /* bits of precision of the functions below; callers change it in copies of the struct */
};

void disk_init(struct disk *d, const fmpq_t nu, slong prec);
void disk_clear(struct disk *d);

/* A count that is undecided. More precision or another w may decide it. */
#define DISK_UNDECIDED (-1)

/* Returns the number of roots of one n below omega, w = omega^2 > 0, or DISK_UNDECIDED. Does not count the translation
 * n = 1, omega = 0. */
slong disk_count(const struct disk *d, slong n, const arb_t w);

/* Computes a Newton step; w (1 - step) is nearer to a root than w. Returns 0 if the interval is too wide. */
int disk_newton(arb_t step, const struct disk *d, slong n, const arb_t w);

/* Computes C and S of a mode by (26), (28), C > 0, from an interval that contains the w of a root. Returns 0 if the
 * interval is too wide. */
int disk_amplitudes(arb_t c, arb_t s, const struct disk *d, slong n, const arb_t w);

#endif
