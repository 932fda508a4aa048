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

/* Frequencies of one n that are evaluated at once, as independent ladders of Bessel functions */
enum { COR_MODE_LANES = 16 };

struct cor_mode_loops {
    /* For COR_MODE_LANES arguments kappa: J_(end+1)/J_end, from J_(start+1)/J_start, and how often J_start, ..., J_end
     * change their sign */
    void (*ladder)(const double *two_over_kappa, const double *first_quotient, long start, long end, double *quotient,
                   double *zeros);
};

COR_TABLES(struct cor_mode_loops, cor_mode, cor_mode_set)

/* e and s are separate, so that nu close to 1 or -1 loses no digits. */
struct cor_mode_material {
    double e, s;
};

/* An n such that no mode of this or a larger n is below omega: omega_nl^2 >= n (n - 1)/10 for every n >= 2, l and nu,
 * (11.4). */
long cor_mode_orders(double omega);

/* Number of modes below omega, of one n and of all n. The number is wrong by one if omega is within rounding errors of
 * a root. The translation n = 1, omega = 0 is not counted. */
long cor_mode_count(const struct cor_mode_material *material, long n, double omega);
double cor_mode_total(const struct cor_mode_material *material, double omega);

/* A frequency with slightly more than `count` modes below it */
double cor_mode_upper_end(const struct cor_mode_material *material, size_t count);

/* Computes the modes of one n below omega by increasing frequency, mode[0..count-1] with count from cor_mode_count. Two
 * modes that doubles cannot separate get the same frequency. Returns COR_OK or COR_ERROR_MEMORY. */
int cor_mode_find(const struct cor_mode_material *material, long n, double omega, struct cor_disk_mode *mode,
                  long count);

/* A rung m > n such that the ladder from a_m in [z/(2(m+1)), z/(m+1)], which holds for kappa <= m + 1, gives a_n to
 * `bits` bits. */
long cor_mode_ladder_start(long n, double kappa, long bits);

#endif
