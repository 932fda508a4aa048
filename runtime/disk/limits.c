/* SPDX-License-Identifier: MIT */
/* The restitution of a disk of infinitely many modes at a hard wall. Products of Chebyshev polynomials in ln v and nu
 * interpolate the limits of generated/disk_limits.h. */
#include <math.h>
#include <stddef.h>

#include "cor/disk.h"
#include "generated/disk_limits.h"

enum { SPEEDS = COR_DISK_LIMIT_SPEEDS, NUS = COR_DISK_LIMIT_NUS };

/* sum c_k T_k(x), |x| <= 1, by Clenshaw's recurrence */
static double chebyshev(const double *c, int n, double x)
{
    double b = 0, before = 0;
    for (int k = n - 1; k > 0; k--) {
        const double next = c[k] + (2 * x * b - before);
        before = b;
        b = next;
    }
    return c[0] + (x * b - before);
}

/* False if speed or nu is NaN */
static int is_inside(double speed, double nu)
{
    return speed >= COR_DISK_EPS_MIN_SPEED && speed <= COR_DISK_EPS_MAX_SPEED && nu >= COR_DISK_EPS_MIN_NU &&
           nu <= COR_DISK_EPS_MAX_NU;
}

double cor_disk_one_minus_eps2(double speed, double nu)
{
    if (!is_inside(speed, nu))
        return NAN;
    const double x = log10(speed / COR_DISK_LIMIT_MIDDLE_SPEED);
    const double y = (nu - COR_DISK_LIMIT_MIDDLE_NU) / COR_DISK_LIMIT_NU_RANGE;
    double of_nu[NUS];
    for (int j = 0; j < NUS; j++)
        of_nu[j] = chebyshev(cor_disk_limit_coefficients + j * SPEEDS, SPEEDS, x);
    return chebyshev(of_nu, NUS, y);
}

double cor_disk_one_minus_eps2_uncertainty(double speed, double nu)
{
    if (!is_inside(speed, nu))
        return NAN;
    /* the largest uncertainty at the corners of the cell that contains the point */
    int i = 0, j = 0;
    while (j < NUS - 2 && cor_disk_limits[(j + 1) * SPEEDS].nu < nu)
        j++;
    while (i < SPEEDS - 2 && cor_disk_limits[i + 1].speed < speed)
        i++;
    const struct cor_disk_limit *const corner = cor_disk_limits + j * SPEEDS + i;
    return fmax(fmax(corner[0].uncertainty, corner[1].uncertainty),
                fmax(corner[SPEEDS].uncertainty, corner[SPEEDS + 1].uncertainty)) +
           COR_DISK_LIMIT_INTERPOLATION;
}

double cor_disk_eps(double speed, double nu)
{
    return sqrt(1 - cor_disk_one_minus_eps2(speed, nu));
}

/* d eps = d(1 - eps^2)/(2 eps); eps is above 0.7 */
double cor_disk_eps_uncertainty(double speed, double nu)
{
    return cor_disk_one_minus_eps2_uncertainty(speed, nu) / (2 * cor_disk_eps(speed, nu));
}
