/* SPDX-License-Identifier: MIT */
/* Proves the stated errors of the polynomials of runtime/number/elementary.h, runtime/number/lambert_w.c and
 * runtime/law/. In each cell of the interval the error is a Taylor polynomial in balls around the middle plus a
 * remainder enclosed over the cell. pair_exp of runtime/disk/quasistatic.c is tested at sampled numbers, because no
 * double shows its last digits. */
#include "runtime/disk/quasistatic.c"
#include "runtime/law/damping_ratio.h"
#include "runtime/law/hunt_crossley.h"
#include "runtime/number/lambert_w.c"

#include <stdio.h>
#include <stdlib.h>

#include "support/formula.h"
#include "support/local.h"
#include "tests/proof/errors.h"

enum { BITS = 400, LENGTH = 20 };

static const double exp_polynomial[] = COR_KERNEL_EXP_POLYNOMIAL, log_polynomial[] = COR_KERNEL_LOG_POLYNOMIAL;

/* A polynomial p of `argument`. error: a formula in s, p and atan(s), whose value is below bound |s|^power */
static const struct polynomial {
    const char *name;
    const double *c;
    slong length;
    const char *argument, *error;
    double low, high;
    int power;
    double bound;
} polynomials[] = {
#define ROW(name, c, ...)                                                                                              \
    {                                                                                                                  \
        name, c, sizeof(c) / sizeof *(c), __VA_ARGS__                                                                  \
    }
    ROW("exp", exp_polynomial, "s", "s^2*p - (exp(s) - 1 - s)", -1, 0.3467, 0, 0x1p-60),
    ROW("ln", log_polynomial, "s^2", "s + s^3*p/2 - (log(1 + s) - log(1 - s))/2", 0, 0.1717, 1, 0x1p-59),
    ROW("phase, zeta < 1", cor_ratio_phase_polynomial, "s^2", "s + s^3*p - atan", 0, 0.41437, 1, 0x1p-57),
    ROW("phase, zeta > 1", cor_ratio_phase_polynomial, "-s^2", "s - s^3*p - (log(1 + s) - log(1 - s))/2", 0, 0.41437, 1,
        0x1p-57),
    /* The error of this formula is sinh(s), which is at least s, times the error of the polynomial. s coth(s) - 1 is at
     * least 0.29 s^2. */
    ROW("s coth(s) - 1", cor_hc_coth_polynomial, "s^2",
        "(s^2*(1/3 + s^2*p) + 1)*(exp(s) - exp(-s))/2 - s*(exp(s) + exp(-s))/2", 0, 1.503, 3, 0.29 * 0x1p-55),
    ROW("atanh, approach only", cor_hc_atanh_polynomial, "s^2", "s + s^3*(1/3 + s^2*p) - (log(1 + s) - log(1 - s))/2",
        0, 0.5, 3, 0x1p-55),
    /* Formula: t - ln(1 + t) - s^2/2. The error of t is 1 + 1/t times as large, and at most 2^-55.6 s. */
    ROW("W_-1 near its branch point", lambert_series, "s", "s + s^2*p - log(1 + s + s^2*p) - s^2/2", 0,
        COR_PROOF_SERIES_MAX_P, 3, COR_PROOF_SERIES_DEFECT),
};

/* ---- series, of `length` terms ---- */

static slong length;

static void multiply(arb_poly_t z, const arb_poly_t x, const arb_poly_t y)
{
    arb_poly_mullow(z, x, y, length, BITS);
}

#define OF_SERIES(name, function)                                                                                      \
    static bool name(arb_poly_t y, const arb_poly_t x)                                                                 \
    {                                                                                                                  \
        function(y, x, length, BITS);                                                                                  \
        return true;                                                                                                   \
    }
OF_SERIES(inverse, arb_poly_inv_series)
OF_SERIES(exponential, arb_poly_exp_series)
OF_SERIES(logarithm, arb_poly_log_series)
OF_SERIES(root, arb_poly_sqrt_series)
static const struct formula_algebra algebra = {BITS, multiply, inverse, exponential, logarithm, root};

/* Computes the error in powers of s - centre. */
static void error_series(arb_poly_t e, const struct polynomial *f, const arb_t centre)
{
    LOCAL(arb_poly, s, p, x, atan);
    const struct operand operands[] = {{.name = "s", .function = s, .real = NAN},
                                       {.name = "p", .function = p, .real = NAN},
                                       {.name = "atan", .function = atan, .real = NAN},
                                       {.name = NULL}};
    arb_poly_set_coeff_arb(s, 0, centre);
    arb_poly_set_coeff_si(s, 1, 1);
    arb_poly_atan_series(atan, s, length, BITS);
    formula_function(x, &algebra, f->argument, operands);
    for (slong k = f->length; k-- > 0;) {
        const double c = f->c[k];
        formula_function(p, &algebra, FORMULA("p*x + c", p, x, c));
    }
    formula_function(e, &algebra, f->error, operands);
}

/* ---- the proof ---- */

/* True if the bound holds in the cell middle +- radius, where middle = 0 or 0 is outside the cell. */
static bool cell_holds(const struct polynomial *f, double middle, double radius)
{
    LOCAL(arb_poly, at_middle, in_cell);
    LOCAL(arb, centre, sum, c);
    const slong lost = middle == 0 ? f->power : 0;
    const double bound = middle == 0 ? f->bound : f->bound * pow(fabs(middle) - radius, f->power) * (1 - 1e-12);
    arb_set_d(centre, middle);
    length = LENGTH;
    error_series(at_middle, f, centre);
    arb_set_d(c, radius);
    arb_add_error(centre, c);
    length = LENGTH + 1; /* the remainder */
    error_series(in_cell, f, centre);
    for (slong k = 0; k <= LENGTH; k++) {
        const slong n = k - lost;
        arb_poly_get_coeff_arb(c, k < LENGTH ? at_middle : in_cell, k);
        if (n >= 0)
            LET(sum, BITS, "sum + abs(c)*radius^n", sum, c, radius, n);
        else if (!arb_is_zero(c))
            return false;
    }
    return HOLDS(BITS, "sum < bound", sum, bound);
}

static bool holds(const struct polynomial *f)
{
    /* Outside the wide cell around 0, |s|^power varies by at most 1.3 in a cell. */
    enum { CELLS = 300, FIRST = 16 };
    const double radius = f->high / (2 * CELLS - 1);
    bool good = cell_holds(f, 0, (2 * FIRST - 1) * radius * (1 + 1e-9));
    for (int i = f->low < 0 ? -CELLS + 1 : FIRST; i < CELLS; i++)
        if (abs(i) >= FIRST)
            good = cell_holds(f, 2 * i * radius, radius * (1 + 1e-9)) && good;
    printf("%s  %-34s  |s| <= %-8g  error below 2^%.1f |s|^%d, proved\n", good ? "ok  " : "FAIL", f->name, f->high,
           log2(f->bound), f->power);
    return good;
}

/* ---- exp in pairs ---- */

/* True if the largest error (2^-101.85) and the mean error near the ends of the domain (2^-104.3) are small enough. A
 * wrong sign of the series' last coefficient, which counts most there, gives 2^-101.5 and 2^-102.4 (measured). */
static bool pair_exp_is_good(void)
{
    enum { POINTS = 4001 };
    bool good = true;
    double worst = 0, end = 0;
    LOCAL(arb, off);
    for (int i = 0; i < POINTS; i++) {
        const double x = nextafter(2, 0) * (2.0 * i / (POINTS - 1) - 1);
        const pair computed = pair_exp(x);
        LET(off, 256, "abs((computed.lo + computed.hi)*exp(-x) - 1)", computed.lo, computed.hi, x);
        const double error = arf_get_d(arb_midref(off), ARF_RND_UP);
        good = good && error <= 0x1p-101;
        worst = fmax(worst, error);
        end += fabs(x) >= 1.9 ? error / ((double)POINTS / 20.0) : 0;
    }
    good = good && end <= 0x1p-103;
    printf("%s  pair_exp: 2^%.2f, mean of |x| > 1.9 2^%.2f, %d points\n", good ? "ok  " : "FAIL", log2(worst),
           log2(end), POINTS);
    return good;
}

int main(void)
{
    bool good = pair_exp_is_good();
    for (size_t i = 0; i < sizeof polynomials / sizeof *polynomials; i++)
        good = holds(&polynomials[i]) && good;
    flint_cleanup();
    return good ? 0 : 1;
}
