/* SPDX-License-Identifier: MIT */
/* The restitution of a disk with infinitely many modes at a rigid wall, from the table of generated/disk_limits.h. */
#include <math.h>

#include "cor/disk.h"
#include "generated/disk_limits.h"

static const struct cor_disk_limit_table table = {
    COR_DISK_LIMIT_X_ROOTS, COR_DISK_LIMIT_NU_ROOTS, COR_DISK_LIMIT_X_FIRST,
    COR_DISK_LIMIT_X_STEP,  COR_DISK_LIMIT_NU_FIRST, COR_DISK_LIMIT_NU_STEP,
    cor_disk_limit_square,  cor_disk_limit_place,    cor_disk_limit_piece};

/* False if speed or nu is NaN, without FE_INVALID */
static int is_inside(double speed, double nu)
{
    return isgreaterequal(speed, COR_DISK_EPS_MIN_SPEED) && islessequal(speed, COR_DISK_EPS_MAX_SPEED) &&
           isgreaterequal(nu, COR_DISK_EPS_MIN_NU) && islessequal(nu, COR_DISK_EPS_MAX_NU);
}

COR_INLINE double loss_at(double speed, double nu)
{
    if (!is_inside(speed, nu))
        return NAN;
    const double x = cor_disk_limit_x(&table, speed), y = cor_disk_limit_nu(&table, nu);
    return cor_disk_limit_value(cor_disk_limit_find(&table, x, y), x, y);
}

double cor_disk_one_minus_eps2(double speed, double nu)
{
    return loss_at(speed, nu);
}

double cor_disk_one_minus_eps2_uncertainty(double speed, double nu)
{
    return is_inside(speed, nu)
               ? cor_disk_limit_uncertainty(&table, cor_disk_limit_x(&table, speed), cor_disk_limit_nu(&table, nu))
               : NAN;
}

double cor_disk_eps(double speed, double nu)
{
    return sqrt(1 - loss_at(speed, nu));
}

void cor_disk_eps_array(const double *speed, double nu, double *eps, size_t n)
{
    for (size_t i = 0; i < n; i++)
        eps[i] = cor_disk_eps(speed[i], nu);
}

/* Uses d eps = d(1 - eps^2)/(2 eps). eps is above 0.7. */
double cor_disk_eps_uncertainty(double speed, double nu)
{
    return cor_disk_one_minus_eps2_uncertainty(speed, nu) / (2 * cor_disk_eps(speed, nu));
}
