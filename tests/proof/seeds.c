/* SPDX-License-Identifier: MIT */
/* Proves the start of the fifth root, cor_inline_fifth_root_parts: |x - r^5| <= 4e-4 r^5 for every normal x, where r is
 * the head. The seed of Halley's step depends only on the upper 32 bits of x. For each of their values the program
 * evaluates both ends of the interval of x and requires 3.99e-4. Within the interval, x changes by one part in 2^20 and
 * r by a fifth of that. This changes the quotient by less than 1e-6, because Halley's error has a slope below 0.01 in
 * x. The seeds of exponents that differ by five agree up to one part in 2^20, so the program tests five exponents.
 * --all tests the exponents -1000 to 999. */
#include "runtime/number/fifth_root.h"

#include <stdio.h>

static double quotient(double x)
{
    const long double r = cor_inline_fifth_root_parts(x).hi;
    const long double r5 = r * r * r * r * r;
    return (double)fabsl((x - r5) / r5);
}

int main(int argc, char **argv)
{
    const int all = argc > 1 && strcmp(argv[1], "--all") == 0, first = all ? -1000 : 0, last = all ? 1000 : 5;
    const uint64_t stride = all ? 16 : 1; /* every 16th seed, except for the exponents 0 to 4 */
    double worst = 0, at = 0;
    for (int e = first; e < last; e++) {
        const uint64_t start = cor_inline_bits(cor_inline_power_of_two(e)) >> 32;
        for (uint64_t top = start; top < start + (1 << 20); top += e >= 0 && e < 5 ? 1 : stride) {
            const double ends[] = {cor_inline_from_bits(top << 32),
                                   cor_inline_from_bits(top << 32 | UINT64_C(0xffffffff))};
            for (int i = 0; i < 2; i++) {
                const double q = quotient(ends[i]);
                if (!(q <= worst)) {
                    worst = q;
                    at = ends[i];
                }
            }
        }
    }
    printf("|x - r^5|/r^5 <= %.3g, at %a\n", worst, at);
    return !(worst <= 3.99e-4);
}
