/* SPDX-License-Identifier: MIT */
#include "embed/form.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "approximation/interpolant.h"
#include "support/console.h"
#include "support/local.h"

enum { LANDEN_STEPS = 12, CHECK_CELLS = 2048, NODE_BITS = 40 };

/* ---- interpolation points ---- */

/* Returns the Jacobi function dn(u K, k') from the complementary modulus k, by descending Landen transformations. */
static double jacobi_dn(double u, double k)
{
    double a[LANDEN_STEPS + 1], c[LANDEN_STEPS + 1], b = k;
    a[0] = 1;
    c[0] = sqrt(1 - k * k);
    for (int i = 0; i < LANDEN_STEPS; i++) {
        a[i + 1] = (a[i] + b) / 2;
        c[i + 1] = (a[i] - b) / 2;
        b = sqrt(a[i] * b);
    }
    /* start with phi = 2^N a_N u K, K = pi/(2 a_N) */
    double phi = ldexp(u * acos(-1.0) / 2, LANDEN_STEPS), before = phi;
    for (int i = LANDEN_STEPS; i > 0; i--) {
        before = phi;
        phi = (phi + asin(c[i] / a[i] * sin(phi))) / 2;
    }
    const double divisor = cos(before - phi);
    return fabs(divisor) > 1e-9 ? cos(phi) / divisor : k;
}

/* Returns point j of n between lo and hi. Chebyshev points are best for a polynomial, or if eps has no cut near [lo,
 * hi]. For a rational interpolant of a function with a cut along the negative axis, the best points are hi dn^2. They
 * follow from Green's function of the plane between the cut and [lo, hi]. */
static double fit_node(const struct embed_form *f, double lo, double hi, slong j, slong n)
{
    const bool elliptic = f->denominator > 0 && f->variable <= FOURTH_ROOT_OF_SPEED;
    double x;
    if (elliptic) {
        const double d = jacobi_dn((2 * (double)j + 1) / (2 * (double)n), sqrt(lo / hi));
        x = hi * d * d;
    } else {
        x = (lo + hi) / 2 + (hi - lo) / 2 * chebyshev_point(j, n);
    }
    int exponent;
    x = frexp(fmin(fmax(x, lo), hi), &exponent);
    return ldexp(nearbyint(ldexp(x, NODE_BITS)), exponent - NODE_BITS);
}

/* Computes eps at the variable x. */
static void eps_at(arb_t eps, const struct embed_form *f, const struct embed_scene *s, const arb_t x)
{
    LOCAL(arb, g);
    arb_pow_ui(g, x, (ulong)embed_roots[f->variable].degree, EMBED_BITS);
    embed_scene_eps(eps, s, g);
}

/* ---- rounding ---- */

/* Rounds coefficients to the type. Returns false if one is out of the type's range, or near its ends. */
static bool round_numbers(struct embed_form *f, arb_srcptr exact, slong count)
{
    const double least = 1e3 * (f->single ? (double)FLT_MIN : DBL_MIN),
                 most = 1e-3 * (f->single ? (double)FLT_MAX : DBL_MAX);
    f->number = xrealloc(f->number, (size_t)count * sizeof *f->number);
    for (slong k = 0; k < count; k++) {
        const double x = ball_middle(exact + k);
        f->number[k] = f->single ? (double)(float)x : x;
        const double size = fabs(f->number[k]);
        if (!arb_is_finite(exact + k) || !(size == 0 || (size >= least && size <= most)))
            return false;
    }
    return true;
}

/* True if q > 0 is proved on [lo, hi]. On each of CHECK_CELLS cells, the positive terms at its lower end and the
 * negative terms at its upper end bound q from below. */
static bool quotient_is_positive(const double *q, slong degree, double lo, double hi)
{
    bool all = true;
    for (slong k = 0; k <= degree; k++)
        all = all && q[k] >= 0;
    if (all)
        return true;
    const double step = pow(hi / lo, 1.0 / (double)CHECK_CELLS);
    for (double x = lo; x < hi; x *= step) {
        double sum = 0, size = 0, low = 1, high = 1;
        for (slong k = 0; k <= degree; k++) {
            const double term = q[k] * (q[k] > 0 ? low : high);
            sum += term;
            size += fabs(term);
            low *= x;
            high *= x * step * (1 + 1e-12);
        }
        if (!(sum > 1e-12 * size))
            return false;
    }
    return true;
}

/* Converts p_0, ..., p_m, q_0, ..., q_n from the unit 2^scale of the variable to the variable itself, with q_n = 1. */
static bool finish_quotient(struct embed_form *f, arb_ptr c, slong scale)
{
    const slong m = f->numerator, n = f->denominator;
    const slong count = m + 1 + (n > 0 ? n + 1 : 0);
    for (slong k = 0; k < count; k++)
        arb_mul_2exp_si(c + k, c + k, -scale * (k <= m ? k : k - m - 1));
    if (n > 0) {
        LOCAL(arb, top);
        arb_set(top, c + count - 1);
        _arb_vec_scalar_div(c, c, count, top, EMBED_BITS);
        arb_one(c + count - 1);
    }
    if (!round_numbers(f, c, count))
        return false;
    const double power = 1 / (double)embed_roots[f->variable].degree;
    return n == 0 || quotient_is_positive(f->number + m + 1, n, pow(f->speed_min, power) * (1 - 1e-5),
                                          pow(f->speed_max, power) * (1 + 1e-5));
}

/* ---- interpolation ---- */

bool embed_fit_rational(struct embed_form *f, const struct embed_scene *s)
{
    const slong m = f->numerator, n = f->denominator, count = m + n + 1;
    const double power = 1 / (double)embed_roots[f->variable].degree;
    /* slightly inside the range, because the rounded speed of a point must not leave it */
    const double lo = pow(s->speed_min, power) * (1 + 1e-13), hi = pow(s->speed_max, power) * (1 - 1e-13);
    const slong scale = lround(log2(lo * hi) / 2);
    LOCAL(arb, x, eps, term);
    LOCAL_VECTOR(c, count + 1);
    LOCAL_MATRIX(count, count, a);
    LOCAL_MATRIX(count, 1, b);
    for (slong j = 0; j < count; j++) { /* equation j: p(x) - eps (q_0 + ... + q_(n-1) x^(n-1)) = eps x^n */
        arb_set_d(x, fit_node(f, lo, hi, j, count));
        eps_at(eps, f, s, x);
        arb_mul_2exp_si(x, x, -scale);
        arb_one(term);
        for (slong k = 0; k <= FLINT_MAX(m, n); k++) {
            if (k <= m)
                arb_set(arb_mat_entry(a, j, k), term);
            if (k < n)
                LET(arb_mat_entry(a, j, m + 1 + k), EMBED_BITS, "-eps*term", eps, term);
            if (k == n)
                arb_mul(arb_mat_entry(b, j, 0), eps, term, EMBED_BITS);
            arb_mul(term, term, x, EMBED_BITS);
        }
    }
    if (!arb_mat_solve(b, a, b, EMBED_BITS))
        return false;
    for (slong k = 0; k < count; k++)
        arb_set(c + k, arb_mat_entry(b, k, 0));
    arb_one(c + count);
    return finish_quotient(f, c, scale);
}

bool embed_fit_quotient(struct embed_form *f, const struct embed_scene *s, const arb_poly_t p, const arb_poly_t q)
{
    const slong m = f->numerator, n = f->denominator;
    LOCAL_VECTOR(c, m + n + 2);
    LOCAL(arb, unit);
    arb_root_ui(unit, s->beta_per_root, (ulong)s->series_root, EMBED_BITS); /* z = unit*speed^(1/(5*series_root)) */
    for (slong k = 0; k <= m + n + 1; k++) {
        const slong degree = k <= m ? k : k - m - 1;
        arb_poly_get_coeff_arb(c + k, k <= m ? p : q, degree);
        const arb_srcptr own = c + k;
        LET(c + k, EMBED_BITS, "own*unit^degree", own, unit, degree);
    }
    return finish_quotient(f, c, 0);
}

/* Interpolates eps on each row at Chebyshev points, by a polynomial in the argument t of the row. */
bool embed_fit_pieces(struct embed_form *f, const struct embed_scene *s)
{
    const slong columns = f->numerator + 1;
    const bool of_speed = f->family == FAMILY_PIECES_SPEED;
    const double least = pow(s->speed_min, 0.2), most = pow(s->speed_max, 0.2);
    if (!of_speed) {
        const double error = 2 * embed_root_error(f->refinement, f->single) + (f->single ? 1e-6 : 1e-14);
        const double lo = least * (1 - error), hi = most * (1 + error);
        f->slope = embed_rounded(s, (double)f->rows / (hi - lo));
        f->shift = embed_rounded(s, -lo * f->slope);
    }
    LOCAL_VECTOR(exact, f->rows * columns);
    LOCAL_VECTOR(t, columns);
    LOCAL_VECTOR(eps, columns);
    LOCAL(arb, x);
    LOCAL(arb_poly, polynomial);
    for (slong row = 0; row < f->rows; row++) {
        const double start = embed_row_start(f, row), end = embed_row_start(f, row + 1);
        const double lo = fmax(start, s->speed_min), hi = fmin(end, s->speed_max), shift = f->shift - (double)row;
        const slong used = of_speed && hi - lo <= 1e-6 * (end - start) ? 1 : columns;
        for (slong j = 0; j < used; j++) {
            const double place = chebyshev_point(j, used);
            if (of_speed) {
                arb_set_d(x, fmin(fmax((lo + hi) / 2 + (hi - lo) / 2 * place, lo), hi));
                LET(t + j, EMBED_BITS, "x - start", x, start);
            } else {
                const double y = ((double)row + (1 + place) / 2 - f->shift) / f->slope;
                arb_set_d(x, fmin(fmax(y, least * (1 + 1e-14)), most * (1 - 1e-14)));
                LET(t + j, EMBED_BITS, "x*f->slope + shift", x, f->slope, shift);
            }
            eps_at(eps + j, f, s, x);
        }
        arb_poly_interpolate_newton(polynomial, t, eps, used, EMBED_BITS);
        for (slong k = 0; k < used; k++)
            arb_poly_get_coeff_arb(exact + row * columns + k, polynomial, k);
    }
    return round_numbers(f, exact, f->rows * columns);
}
