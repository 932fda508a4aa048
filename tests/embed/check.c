/* SPDX-License-Identifier: MIT */
/* Compares an embedded scene header, included twice together with another one, with libcor. Prints the largest relative
 * error over the range. Fails if it exceeds the tolerance or a special value is wrong. tests/embed/run writes files
 * that define the macros HEADER, OTHER, FUNCTION, OTHER_FUNCTION, SPEED_MIN, SPEED_MAX, TOLERANCE, LIBRARY, REAL, and
 * CONTACT, which fills `contact`, and then include this one. */
#include HEADER
#include HEADER
#include OTHER

#include <stdio.h>

#include <cor/cor.h>

#ifdef __CUDACC__
/* computes eps on the device, if it exists; always compiled */
__global__ void on_device(const REAL *speed, REAL *eps, int n)
{
    const int i = (int)(blockIdx.x * blockDim.x + threadIdx.x);
    if (i < n)
        eps[i] = FUNCTION(speed[i]);
}
#endif

static int wrong(const char *what, double speed, double got, double expected)
{
    printf("%s: eps(%.17g) = %.17g, not %.17g\n", what, speed, got, expected);
    return 1;
}

int main(void)
{
    enum { POINTS = 20011 };
    struct cor_sphere_contact contact;
    CONTACT;
    const double low = (double)(REAL)(SPEED_MIN), high = (double)(REAL)(SPEED_MAX);
    double worst = 0, worst_at = low;
    for (int i = 0; i < POINTS; i++) {
        double speed = (double)(REAL)(low * pow(high / low, i / (POINTS - 1.0)));
        speed = speed < low ? low : speed > high ? high : speed;
        const double eps = LIBRARY(&contact, speed);
        const double error = fabs((double)FUNCTION((REAL)speed) / eps - 1);
        if (!(error <= worst)) {
            worst = error;
            worst_at = speed;
        }
    }
    printf("%.2e at %g m/s, tolerance %.2e\n", worst, worst_at, TOLERANCE);
    if (!(worst <= TOLERANCE))
        return 1;

    /* volatile, because compilers may compute constants with fused products */
    const volatile REAL ends[] = {(REAL)low, (REAL)high};
    const double first = (double)FUNCTION(ends[0]), last = (double)FUNCTION(ends[1]);
    const REAL infinity = (REAL)INFINITY, nan = (REAL)NAN; /* casts, because NAN is a float */
    const volatile REAL below[] = {0, -(REAL)0.0, (REAL)(low / 2), (REAL)(low / 1e30)},
                        above[] = {(REAL)(high * 2), infinity};
    for (int i = 0; i < 4; i++)
        if ((double)FUNCTION(below[i]) != first)
            return wrong("below", (double)below[i], (double)FUNCTION(below[i]), first);
    for (int i = 0; i < 2; i++)
        if ((double)FUNCTION(above[i]) != last)
            return wrong("above", (double)above[i], (double)FUNCTION(above[i]), last);
    const REAL bad[] = {nan, -nan, -infinity, (REAL)-1, (REAL)-1e-30};
    for (int i = 0; i < 5; i++)
        if (FUNCTION(bad[i]) == FUNCTION(bad[i]))
            return wrong("no speed", (double)bad[i], (double)FUNCTION(bad[i]), (double)nan);
    return OTHER_FUNCTION(1) > 0 ? 0 : 1;
}
