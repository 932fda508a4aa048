/* SPDX-License-Identifier: MIT */
/* The polynomials of runtime/number/elementary.h, runtime/number/lambert_w.c and runtime/law/: the errors that stand
 * beside them, proved: in each cell of the interval the error is Taylor's polynomial in balls around the middle and a
 * remainder enclosed over the cell. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "runtime/law/damping_ratio.h"
#include "runtime/law/hunt_crossley.h"
#include "runtime/number/lambert_w.c"
#include "support/local.h"
#include "tests/proof/disk_errors.h"

enum { BITS = 400, LENGTH = 20 };

/* ---- series of an error around a point, which may be a ball ---- */

/* sum of c[k] x^k for a series x */
static void compose(arb_poly_t y, const double *c, slong n, const arb_poly_t x, slong length)
{
    LOCAL(arb, coefficient, added);
    arb_poly_zero(y);
    while (n-- > 0) {
        arb_poly_mullow(y, y, x, length, BITS);
        arb_poly_get_coeff_arb(coefficient, y, 0);
        arb_set_d(added, c[n]);
        arb_add(coefficient, coefficient, added, BITS);
        arb_poly_set_coeff_arb(y, 0, coefficient);
    }
}

/* the variable itself: centre + t */
static void variable(arb_poly_t x, const arb_t centre)
{
    arb_poly_zero(x);
    arb_poly_set_coeff_arb(x, 0, centre);
    arb_poly_set_coeff_si(x, 1, 1);
}

typedef void error_series(arb_poly_t e, const arb_poly_t x, slong length);

/* s^2 p(s) - (exp(s) - 1 - s) */
static void exp_error(arb_poly_t e, const arb_poly_t s, slong length)
{
    LOCAL(arb_poly, p);
    compose(p, cor_kernel_exp_polynomial, 11, s, length);
    arb_poly_mullow(p, p, s, length, BITS);
    arb_poly_mullow(p, p, s, length, BITS);
    arb_poly_exp_series(e, s, length, BITS);
    arb_poly_sub(e, e, s, BITS);
    arb_poly_add_si(e, e, -1, BITS);
    arb_poly_sub(e, p, e, BITS);
}

/* s + s^3 factor p(sign s^2) */
static void odd(arb_poly_t e, const double *c, slong n, const arb_poly_t s, int sign, int halves, slong length)
{
    LOCAL(arb_poly, square);
    arb_poly_mullow(square, s, s, length, BITS);
    if (sign < 0)
        arb_poly_neg(square, square);
    compose(e, c, n, square, length);
    arb_poly_mullow(e, e, square, length, BITS);
    arb_poly_scalar_mul_2exp_si(e, e, -halves);
    arb_poly_mullow(e, e, s, length, BITS);
    arb_poly_add(e, e, s, BITS);
}

/* atanh by its derivative */
static void atanh_series(arb_poly_t y, const arb_poly_t s, slong length)
{
    LOCAL(arb_poly, plus, minus);
    arb_poly_add_si(plus, s, 1, BITS);
    arb_poly_neg(minus, s);
    arb_poly_add_si(minus, minus, 1, BITS);
    arb_poly_log_series(plus, plus, length, BITS);
    arb_poly_log_series(minus, minus, length, BITS);
    arb_poly_sub(y, plus, minus, BITS);
    arb_poly_scalar_mul_2exp_si(y, y, -1);
}

static void odd_error(arb_poly_t e, const double *c, slong n, const arb_poly_t s, int sign, int halves, slong length)
{
    LOCAL(arb_poly, exact);
    if (sign * (c[0] < 0 ? -1 : 1) > 0)
        atanh_series(exact, s, length);
    else
        arb_poly_atan_series(exact, s, length, BITS);
    odd(e, c, n, s, sign, halves, length);
    arb_poly_sub(e, e, exact, BITS);
}

static void log_error(arb_poly_t e, const arb_poly_t s, slong length)
{
    odd_error(e, cor_kernel_log_polynomial, 8, s, 1, 1, length);
}

static void atan_error(arb_poly_t e, const arb_poly_t t, slong length)
{
    odd_error(e, cor_ratio_phase_polynomial, 15, t, 1, 0, length);
}

static void phase_atanh_error(arb_poly_t e, const arb_poly_t t, slong length)
{
    odd_error(e, cor_ratio_phase_polynomial, 15, t, -1, 0, length);
}

/* 1/3 is a pair there, exact here */
static void add_third(arb_poly_t e)
{
    LOCAL(arb_poly, third);
    LOCAL(arb, value);
    arb_set_ui(value, 1);
    arb_div_ui(value, value, 3, BITS);
    arb_poly_set_coeff_arb(third, 0, value);
    arb_poly_add(e, e, third, BITS);
}

/* s + s^3 (1/3 + s^2 p(s^2)) - atanh(s) */
static void approach_error(arb_poly_t e, const arb_poly_t s, slong length)
{
    LOCAL(arb_poly, square, exact);
    arb_poly_mullow(square, s, s, length, BITS);
    compose(e, cor_hc_atanh_polynomial, 13, square, length);
    arb_poly_mullow(e, e, square, length, BITS);
    add_third(e);
    arb_poly_mullow(e, e, square, length, BITS);
    arb_poly_mullow(e, e, s, length, BITS);
    arb_poly_add(e, e, s, BITS);
    atanh_series(exact, s, length);
    arb_poly_sub(e, e, exact, BITS);
}

/* (y^2 (1/3 + y^2 p(y^2))) sinh(y) - (y cosh(y) - sinh(y)); 1/3 as above */
static void coth_error(arb_poly_t e, const arb_poly_t y, slong length)
{
    LOCAL(arb_poly, square, sinh, cosh);
    arb_poly_mullow(square, y, y, length, BITS);
    compose(e, cor_hc_coth_polynomial, 13, square, length);
    arb_poly_mullow(e, e, square, length, BITS);
    add_third(e);
    arb_poly_mullow(e, e, square, length, BITS);
    arb_poly_sinh_cosh_series(sinh, cosh, y, length, BITS);
    arb_poly_mullow(e, e, sinh, length, BITS);
    arb_poly_mullow(cosh, cosh, y, length, BITS);
    arb_poly_sub(e, e, cosh, BITS);
    arb_poly_add(e, e, sinh, BITS);
}

/* t - ln(1 + t) - p^2/2 for t = p + p^2 (a_2 + a_3 p + ...), the disk's contact law */
static void branch_point_error(arb_poly_t e, const arb_poly_t p, slong length)
{
    LOCAL(arb_poly, square, log);
    arb_poly_mullow(square, p, p, length, BITS);
    compose(e, lambert_series, sizeof lambert_series / sizeof *lambert_series, p, length);
    arb_poly_mullow(e, e, square, length, BITS);
    arb_poly_add(e, e, p, BITS);
    arb_poly_add_si(log, e, 1, BITS);
    arb_poly_log_series(log, log, length, BITS);
    arb_poly_sub(e, e, log, BITS);
    arb_poly_scalar_mul_2exp_si(square, square, -1);
    arb_poly_sub(e, e, square, BITS);
}

/* ---- the proof ---- */

/* |e| <= bound |x|^power in the cell middle +- radius, middle = 0 or the cell away from 0 */
static bool cell_holds(error_series *series, double middle, double radius, int power, double bound)
{
    LOCAL(arb_poly, x, e);
    LOCAL(arb, centre, sum, scale, term);
    /* the remainder: coefficient LENGTH over the cell */
    arb_set_d(centre, middle);
    arb_set_d(scale, radius);
    arb_add_error(centre, scale);
    variable(x, centre);
    series(e, x, LENGTH + 1);
    arb_poly_get_coeff_arb(sum, e, LENGTH);
    arb_abs(sum, sum);
    arb_pow_ui(term, scale, (ulong)(middle == 0 ? LENGTH - power : LENGTH), BITS);
    arb_mul(sum, sum, term, BITS);
    /* Taylor's polynomial */
    arb_set_d(centre, middle);
    variable(x, centre);
    series(e, x, LENGTH);
    bool divisible = true;
    for (slong k = 0; k < LENGTH; k++) {
        arb_poly_get_coeff_arb(term, e, k);
        if (middle == 0 && k < power) {
            divisible = divisible && arb_is_zero(term);
            continue;
        }
        arb_abs(term, term);
        arb_pow_ui(centre, scale, (ulong)(middle == 0 ? k - power : k), BITS);
        arb_addmul(sum, term, centre, BITS);
    }
    arb_set_d(term, middle == 0 ? bound : bound * pow(fabs(middle) - radius, power) * (1 - 1e-12));
    const bool holds = divisible && arb_lt(sum, term);
    return holds;
}

static bool prove(const char *name, error_series *series, double low, double high, int power, double bound)
{
    /* The cell around 0 is as wide as 31, so that |x|^power varies by 1.3 at most in each of the others. */
    enum { CELLS = 300, FIRST = 16 };
    const double radius = high / (2 * CELLS - 1);
    bool good = cell_holds(series, 0, (2 * FIRST - 1) * radius * (1 + 1e-9), power, bound);
    for (int i = low < 0 ? -CELLS + 1 : FIRST; i < CELLS; i++)
        if (abs(i) >= FIRST)
            good = cell_holds(series, 2 * i * radius, radius * (1 + 1e-9), power, bound) && good;
    printf("%s  %-34s  |x| <= %-8g  error below 2^%.1f |x|^%d, proved\n", good ? "ok  " : "FAIL", name, high,
           log2(bound), power);
    return good;
}

int main(void)
{
    bool good = prove("exp", exp_error, -1, 0.3467, 0, 0x1p-60);
    good = prove("ln", log_error, 0, 0.1717, 1, 0x1p-59) && good;
    good = prove("phase, zeta < 1", atan_error, 0, 0.41437, 1, 0x1p-57) && good;
    good = prove("phase, zeta > 1", phase_atanh_error, 0, 0.41437, 1, 0x1p-57) && good;
    /* c >= 0.29 y^2 and sinh(y) >= y */
    good = prove("y coth(y) - 1", coth_error, 0, 1.503, 3, 0.29 * 0x1p-55) && good;
    good = prove("atanh, approach only", approach_error, 0, 0.5, 3, 0x1p-55) && good;
    /* t itself is off by (1 + 1/t) times as much: 2^-55.6 p */
    good = prove("W_-1 near its branch point", branch_point_error, 0, COR_PROOF_SERIES_MAX_P, 3,
                 COR_PROOF_SERIES_DEFECT) &&
           good;
    return good ? 0 : 1;
}
