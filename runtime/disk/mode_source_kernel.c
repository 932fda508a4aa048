/* SPDX-License-Identifier: MIT */
/* Ladders of Bessel functions, for one instruction set (sets.h). All sets give the same bits
 * (kernel_vector.h). */
#include <stdint.h>

#include "runtime/disk/mode_source.h"
#include "runtime/number/kernel_vector.h"

#ifdef __GNUC__
typedef __typeof__(all(0) < all(1)) changes; /* -1 for true */
#define NO_CHANGES(count) memset(&(count), 0, sizeof(count))
#define COUNT_CHANGE(count, x, y) ((count) = (count) - ((x) * (y) < all(0)))
#else
typedef struct {
    int64_t of[VECTOR];
} changes;
#define NO_CHANGES(count) memset(&(count), 0, sizeof(count))
#define COUNT_CHANGE(count, x, y)                                                                                      \
    do {                                                                                                               \
        for (int lane = 0; lane < VECTOR; lane++)                                                                      \
            (count).of[lane] += (x).of[lane] * (y).of[lane] < 0;                                                       \
    } while (0)
#endif

/* Computes J_m(kappa) up to a factor by J_(m-1) = (2m/kappa) J_m - J_(m+1), from `start` down to `end`, and counts the
 * changes of sign. Numbers grow by 2^64 at most until they oscillate. */
static void kernel_ladder(const double *two_over_kappa, const double *first_quotient, long start, long end,
                          double *quotient, double *zeros)
{
    enum { VECTORS = COR_MODE_LANES / VECTOR };
    vector step[VECTORS], above[VECTORS], here[VECTORS];
    changes count[VECTORS];
    for (size_t i = 0; i < VECTORS; i++) {
        step[i] = load(two_over_kappa + i * VECTOR);
        above[i] = load(first_quotient + i * VECTOR);
        here[i] = all(1);
        NO_CHANGES(count[i]);
    }
    for (long m = start; m > end; m--) {
        const vector order = all((double)m);
        for (size_t i = 0; i < VECTORS; i++) {
            const vector below = MINUS(TIMES(TIMES(order, step[i]), here[i]), above[i]);
            COUNT_CHANGE(count[i], below, here[i]);
            above[i] = here[i];
            here[i] = below;
        }
    }
    for (size_t i = 0; i < VECTORS; i++) {
        double over[VECTOR], under[VECTOR];
        int64_t signs[VECTOR];
        store(over, above[i]);
        store(under, here[i]);
        memcpy(signs, &count[i], sizeof signs);
        for (size_t k = 0; k < VECTOR; k++) {
            quotient[i * VECTOR + k] = over[k] / under[k];
            zeros[i * VECTOR + k] = (double)signs[k];
        }
    }
}

const struct cor_mode_loops COR_OF_SET(cor_mode) = {kernel_ladder};
