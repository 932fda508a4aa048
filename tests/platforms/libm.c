/* SPDX-License-Identifier: MIT */
/* Evaluates functions of another C library for tests/accuracy/test_libm.c (COR_TEST_LIBM). Reads lines NAME BITS and
 * prints the bits of each value. */
#include <math.h>
#include <stdio.h>
#include <string.h>

int main(void)
{
    char name[16];
    unsigned long long bits;
    while (scanf("%15s %llx", name, &bits) == 2) {
        double x;
        memcpy(&x, &bits, sizeof x);
        const double y = strcmp(name, "cbrt") == 0    ? cbrt(x)
                         : strcmp(name, "log") == 0   ? log(x)
                         : strcmp(name, "log1p") == 0 ? log1p(x)
                         : strcmp(name, "x^5") == 0   ? pow(x, 5)
                         : strcmp(name, "x^0.2") == 0 ? pow(x, 0.2)
                                                      : NAN;
        memcpy(&bits, &y, sizeof bits);
        printf("%016llx\n", bits);
        fflush(stdout);
    }
    return 0;
}
