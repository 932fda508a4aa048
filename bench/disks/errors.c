/* SPDX-License-Identifier: MIT */
#include "errors.h"

#include <math.h>

enum { NEIGHBOURS = 25 };
static const long double cancelled = 0.01L;

static long double response(const struct cor_disk_mode *mode, long double fraction)
{
    const long double square = (long double)mode->omega * mode->omega;
    return fraction * square * square / ((long double)mode->c * mode->c);
}

double disk_worst_error(const struct cor_disk_mode *mode, size_t n, const double *fraction,
                        const long double *reference)
{
    double worst = 0;
    for (size_t i = 0; i < n; i++) {
        const size_t low = i > NEIGHBOURS ? i - NEIGHBOURS : 0, high = i + NEIGHBOURS < n ? i + NEIGHBOURS : n - 1;
        long double size = 0;
        for (size_t k = low; k <= high; k++)
            size = fmaxl(size, response(&mode[k], reference[k]));
        const double error = fabs((double)((fraction[i] - reference[i]) / reference[i]));
        if (response(&mode[i], reference[i]) > cancelled * size && !(error <= worst)) /* a NaN too */
            worst = error;
        if (isnan(error))
            break;
    }
    return worst;
}
