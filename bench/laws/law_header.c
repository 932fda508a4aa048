/* SPDX-License-Identifier: MIT */
/* ns of eps in a loop of calls, by a header that corgen law has written; for the table of docs/laws.md:
 *
 *     corgen law --elastic 3/2 --damping 0 --name law --output law.h
 *     gcc -O2 -I. bench/laws/law_header.c -lm -o law_header && ./law_header
 *     gcc -O2 -I. '-DCOR_INLINE=static inline' bench/laws/law_header.c -lm -o law_header && ./law_header
 *
 * the latter without functions that are always inline. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "law.h"

enum { ARGUMENTS = 4096, ROUNDS = 40 };

/* Least ns of so many rounds over the arguments, each from..to */
#define MEASURE(function, from, to)                                                                                    \
    do {                                                                                                               \
        double least = HUGE_VAL;                                                                                       \
        for (int round = 0; round < ROUNDS; round++) {                                                                 \
            const clock_t start = clock();                                                                             \
            double sum = 0;                                                                                            \
            for (int repeat = 0; repeat < 100; repeat++)                                                               \
                for (int i = 0; i < ARGUMENTS; i++)                                                                    \
                    sum += function((from) + ((to) - (from)) * place[i]);                                              \
            sink = sum;                                                                                                \
            least = fmin(least, (double)(clock() - start) * (1e9 / CLOCKS_PER_SEC / 100 / ARGUMENTS));                 \
        }                                                                                                              \
        printf("%s, %g < beta < %g: %.1f ns\n", #function, from, to, least);                                           \
    } while (0)

int main(void)
{
    static double place[ARGUMENTS];
    volatile double sink = 0;
    uint64_t state = 1;
    for (int i = 0; i < ARGUMENTS; i++) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        place[i] = (double)(state >> 11) * 0x1p-53;
    }
    MEASURE(law_eps_zero_overlap, 0.01, 1.1);
    MEASURE(law_eps_zero_force, 0.01, 1.1);
    MEASURE(law_eps_zero_force, 0.2, 5.0);
    (void)sink;
    return 0;
}
