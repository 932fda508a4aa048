/* SPDX-License-Identifier: MIT */
/* Free modes of an elastic disk in double arithmetic. These modes are not proved; gen/disk/modes.c encloses and proves
 * them, and the tests compare both. docs/theory-disks.md, 11.
 *
 * With e = 1 + nu, s = 1 - nu and g = e omega^2, the squared arguments of the Bessel functions are z = s g
 * (longitudinal waves, kappa^2) and z = 2 g (transverse waves, kappa'^2). */
#ifndef COR_RUNTIME_DISK_MODE_SOURCE_H
#define COR_RUNTIME_DISK_MODE_SOURCE_H

#include <stddef.h>

#include "cor/disk.h"
#include "runtime/number/sets.h"

/* Number of points (omega, n) that are evaluated at once, and number of terms of a series in kappa */
enum { COR_MODE_LANES = 16, COR_MODE_TERMS = 19 };

/* e and s are separate, so that no digits are lost for nu close to 1 or -1. */
struct cor_mode_material {
    double e, s;
};

/* One wave, longitudinal or transverse, up to a factor for each lane: N = n + 1, h = J_N(kappa), k = (kappa/(2N))
 * J_(N+1)(kappa). zeros is the number of zeros of J_N below kappa. */
struct cor_mode_wave {
    double z[COR_MODE_LANES], h[COR_MODE_LANES], k[COR_MODE_LANES], zeros[COR_MODE_LANES];
};

/* Both waves at COR_MODE_LANES points (omega, n). step: a step of Halley's method in omega^2; omega sqrt(1 - step) is
 * closer to a root. below: the number of roots below omega. */
struct cor_mode_point {
    double omega[COR_MODE_LANES], g[COR_MODE_LANES], n[COR_MODE_LANES];
    struct cor_mode_wave a, b;
    double step[COR_MODE_LANES], below[COR_MODE_LANES];
};

/* Taylor series of J_N and J_(N+1) about kappa, where J_N = here and J_(N+1) = above */
struct cor_mode_series {
    double kappa[COR_MODE_LANES], here[COR_MODE_LANES], above[COR_MODE_LANES], zeros[COR_MODE_LANES];
    double term[COR_MODE_TERMS][2][COR_MODE_LANES];
};

struct cor_mode_loops {
    /* For COR_MODE_LANES arguments kappa, computes J_(end+1)/J_end from J_(start+1)/J_start, and the number of changes
     * of sign in J_start, ..., J_end. */
    void (*recurrence)(const double *two_over_kappa, const double *first_quotient, long start, long end,
                       double *quotient, double *zeros);
    /* Advances `count` recurrences by one order, from J_(m+1), J_m to J_m, J_(m-1). Adds changes of sign to zeros. */
    void (*order_step)(size_t count, double m, const double *two_over_kappa, double *above, double *here,
                       double *zeros);
    void (*series)(struct cor_mode_series *series, double N);
    /* Computes a wave at kappa + t from its series about kappa. */
    void (*move)(struct cor_mode_wave *wave, const struct cor_mode_series *series, double N, const double *t);
    void (*equation)(struct cor_mode_point *point, const struct cor_mode_material *material);
};

COR_TABLES(struct cor_mode_loops, cor_mode, cor_mode_set)

/* Returns an n such that all modes of this n and of larger n are at omega or above: omega_nl^2 >= n (n - 1)/10 for
 * every n >= 2, l and nu, (11.4). */
long cor_mode_orders(double omega);

/* Returns the number of modes below omega, without the translation n = 1, omega = 0. The number may be wrong by one if
 * omega is within rounding errors of a root. */
double cor_mode_total(const struct cor_mode_material *material, double omega);

/* Returns a frequency with slightly more than `count` modes below it. */
double cor_mode_upper_end(const struct cor_mode_material *material, size_t count);

/* Computes every mode below omega, by increasing frequency, into *mode, which it allocates. The caller frees *mode,
 * even after a failure. Two modes that doubles cannot separate may have the same frequency. All loops give the same
 * bits. Returns COR_OK, COR_ERROR_MEMORY, or COR_ERROR_MODES if more modes are found than were counted. */
int cor_mode_find(const struct cor_mode_material *material, const struct cor_mode_loops *loops, double omega,
                  struct cor_disk_mode **mode, size_t *found);

/* Returns an order m > n such that the recurrence gives a_n = kappa J_(n+1)/J_n to `bits` bits from any a_m in
 * [z/(2(m+1)), z/(m+1)]. This interval contains a_m for kappa <= m + 1. */
long cor_mode_recurrence_start(long n, double kappa, long bits);

#endif
