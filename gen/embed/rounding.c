/* SPDX-License-Identifier: MIT */
#include "embed/form.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "support/console.h"
#include "support/enclosed_function.h"
#include "support/local.h"
#include "support/parallel.h"

enum {
    BITS = 64,        /* of intermediate results */
    CELLS = 1024,     /* of the range of a variable */
    ROW_CELLS = 4,    /* of a row */
    SEED_CELLS = 256, /* of an octave */
    ROOT_HALVINGS = 12
};

/* More than the rounding of the few operations on bounds that are doubles. Bounds near 1e-16 are added, or pass through
 * expm1 and log1p: 1 + bound - 1 would lose them. */
#define RAISE (1 + 1e-12)
/* Upper limit of |1 - g r^5| for the start of the fifth root; its series are of little use beyond. */
#define SEED_LIMIT 0.2

/* Half a unit in the last place of 1, half of the smallest positive number, and the largest one, of doubles and of
 * floats */
static const struct arithmetic {
    double unit, least, most;
} arithmetic[] = {{0x1p-53, 0, DBL_MAX}, {0x1p-24, 0x1p-150, (double)FLT_MAX}};

/* ---- a result and its error ---- */

/* All values of an expression without rounding, and how far the computed value can be from it */
struct rounded {
    arb_t exact;
    double error;
};

static void rounded_init(struct rounded *x)
{
    *x = (struct rounded){.error = 0};
    arb_init(x->exact);
}

static void rounded_clear(struct rounded *x)
{
    arb_clear(x->exact);
}
LOCAL_STRUCT(rounded)

/* (1 + x)(1 + y) - 1 and (1 + x)^n - 1 */
static double both(double x, double y)
{
    return x + y + x * y;
}

static double power_of_error(double x, double n)
{
    return expm1(n * log1p(x));
}

/* |x| where the computed x may be */
static double rounded_size(const struct rounded *x)
{
    return (ball_magnitude(x->exact) + x->error) * RAISE;
}

/* The error of one rounding; infinite where the result may overflow */
static double rounding_of(const struct rounded *x, const struct arithmetic *a)
{
    const double size = rounded_size(x);
    return size < a->most / 2 ? size * a->unit + a->least + DBL_MIN : HUGE_VAL;
}

/* z = x y + c; the product and the sum are rounded each, which covers the fused operation. */
static void rounded_mul_add(struct rounded *z, const struct rounded *x, const struct rounded *y, double c,
                            const struct arithmetic *a)
{
    LOCAL(arb, addend);
    arb_set_d(addend, c);
    const double error = ball_magnitude(x->exact) * y->error + rounded_size(y) * x->error;
    arb_mul(z->exact, x->exact, y->exact, BITS);
    z->error = error * RAISE;
    z->error += rounding_of(z, a);
    if (c != 0) {
        arb_add(z->exact, z->exact, addend, BITS);
        z->error += rounding_of(z, a);
    }
    z->error *= RAISE;
}

static void rounded_horner(struct rounded *y, const double *c, slong degree, slong step, const struct rounded *x,
                           const struct arithmetic *a)
{
    arb_set_d(y->exact, c[degree]);
    y->error = 0;
    for (slong k = degree - step; k >= 0; k -= step)
        rounded_mul_add(y, x, y, c[k], a);
}

/* As polynomial() of form.c; without the split as horner() */
static void rounded_polynomial(struct rounded *y, const double *c, slong degree, const struct rounded *x, bool split,
                               const struct arithmetic *a)
{
    if (!split || degree < EMBED_SPLIT) {
        rounded_horner(y, c, degree, 1, x, a);
        return;
    }
    LOCAL(rounded, square, even, odd);
    rounded_mul_add(square, x, x, 0, a);
    rounded_horner(even, c, degree - degree % 2, 2, square, a);
    rounded_horner(odd, c + 1, degree - 1 - (degree - 1) % 2, 2, square, a);
    rounded_mul_add(y, x, odd, 0, a);
    arb_add(y->exact, y->exact, even->exact, BITS);
    y->error += even->error;
    y->error = (y->error + rounding_of(y, a)) * RAISE;
}

/* ---- the fifth root ---- */

/* A step takes r with |1 - g r^5| <= e to r S(1 - g r^5), S of degree `degree`. Without rounding, its relative distance
 * from g^(-1/5) is h with (1 + h)^5 = 1 + H(x), H(x) = S(x)^5 (1 - x) - 1, |x| <= e. The rounding error is that in
 * units in which r = 1, so that g = 1 - x. Returns a bound of the distance with rounding, infinite if |H| may reach
 * 1/2, which it does not for e < SEED_LIMIT. */
static double root_step(const double *c, slong degree, double e, const struct arithmetic *a)
{
    LOCAL(arb_poly, x, S, h, one);
    LOCAL(rounded, r, fourth, product, off, series);
    LOCAL(arb, radius);
    enclosed_variable(x, -e, e);
    for (slong k = degree; k >= 0; k--) {
        const double c_k = c[k];
        LET_FUNCTION(S, "S*x + c_k", S, x, c_k);
    }
    LET_FUNCTION(h, "S^5*(1 - x) - 1", S, x);
    arb_poly_one(one);
    double known = 0;
    for (int k = -16; k <= 16; k++)
        known = fmax(known, enclosed_ratio_at(h, one, k / 16.0));
    const double most = enclosed_largest_ratio(h, one, known, ROOT_HALVINGS);
    if (!(most < 0.5))
        return HUGE_VAL;
    const double exact = -power_of_error(-most, 0.2) * RAISE + 1e-18;
    arb_one(r->exact);
    rounded_mul_add(fourth, r, r, 0, a);
    rounded_mul_add(fourth, fourth, fourth, 0, a);
    arb_set_d(radius, e);
    arb_set_si(product->exact, -1);
    arb_add_error(product->exact, radius);
    product->error = rounding_of(product, a);
    rounded_mul_add(off, product, fourth, 1, a);
    rounded_horner(series, c, degree, 1, off, a);
    rounded_mul_add(series, r, series, 0, a);
    const double least = 1 / pow(1 + e, 0.2) * (1 - 2 * exact); /* of S */
    return both(exact, series->error / least) * RAISE;
}

/* Relative error of the variable of the polynomials; `more` covers products of the errors of its roots. Of the fifth
 * root a start r is off by e >= |1 - g r^5|: the upper bits of r fall as those of g rise, so the ends of an interval of
 * speeds bound r. In half of an interval r falls by 400 units of 2^-20 or more, and a fused operation moves it by one:
 * whichever half g is in, the bound of the whole interval holds for that r, too. */
static double variable_bound(const struct embed_form *f, const struct arithmetic *a)
{
    static const double more[] = {[FOURTH_ROOT_OF_SPEED] = 1e-6, [TENTH_ROOT_OF_SPEED] = 1e-4};
    const uint64_t step = UINT64_C(1) << ((f->single ? 23 : 52) - 8), last = emit_bits_of(f->single, f->speed_max);
    double e = 0, error = 0;
    if (embed_roots[f->variable].fifth) {
        for (uint64_t bits = emit_bits_of(f->single, f->speed_min) & ~(step - 1); bits <= last; bits += step) {
            const double lo = embed_from_bits(f, bits), hi = embed_from_bits(f, bits + step - 1);
            const double most = embed_root_start(f, lo), least = embed_root_start(f, hi);
            e = fmax(e, fmax(fabs(1 - hi * pow(most, 5)), fabs(1 - lo * pow(least, 5))));
        }
        e = e * (1 + 1e-9) + 1e-12;
        if (!(e < SEED_LIMIT))
            return HUGE_VAL;
        double r = root_step(embed_root_coefficients[f->single][0], 3, e, a);
        if (f->refinement > 0)
            r = root_step(embed_root_coefficients[f->single][1], f->refinement, power_of_error(r, 5) * RAISE, a);
        /* g (r^2)^2 */
        error = both(power_of_error(r, 4), power_of_error(a->unit, 4)) * RAISE;
    }
    for (int k = 0; k < embed_roots[f->variable].square_roots; k++)
        error = 0.5 * error + a->unit;
    return error * (1 + more[f->variable]);
}

/* ---- polynomials on a cell ---- */

/* p on the cell middle + radius t: its values, and those of its derivative */
static void cell_values(arb_t value, arb_t slope, const double *c, slong degree, const arb_t middle, const arb_t radius)
{
    LOCAL(arb_poly, p);
    for (slong k = degree; k >= 0; k--) {
        arb_set_d(value, c[k]);
        arb_poly_set_coeff_arb(p, k, value);
    }
    enclosed_rescale(p, p, middle, radius, ENCLOSED_BITS);
    enclosed_range(value, p);
    arb_poly_derivative(p, p, ENCLOSED_BITS);
    enclosed_range(slope, p);
    arb_div(slope, slope, radius, BITS);
}

/* Lower bound of |x| */
static double least_size(const arb_t x)
{
    LOCAL(arf, least);
    arb_get_abs_lbound_arf(least, x, 53);
    return arf_get_d(least, ARF_RND_DOWN);
}

/* Relative rounding error of the result for arguments lo <= x <= hi of the polynomials, whose own error is at most
 * x_error, absolute. The cell is widened by that. */
static double cell_bound(const struct embed_form *f, const double *c, double lo, double hi, double x_error)
{
    const struct arithmetic *const a = &arithmetic[f->single];
    const slong m = f->numerator, n = f->denominator;
    LOCAL(arb, middle, radius, value, slope, q_value, q_slope);
    LOCAL(rounded, x, p, q);
    arb_set_d(middle, lo / 2 + hi / 2);
    arb_set_d(radius, ((hi - lo) / 2 + x_error + 1e-15 * fabs(hi) + DBL_MIN) * RAISE);
    arb_set(x->exact, middle);
    arb_add_error(x->exact, radius);
    rounded_polynomial(p, c, m, x, f->rows == 0, a);
    cell_values(value, slope, c, m, middle, radius);
    double least = least_size(value), relative = p->error / least;
    arb_div(slope, slope, value, BITS);
    if (n > 0) {
        rounded_polynomial(q, c + m + 1, n, x, true, a);
        cell_values(q_value, q_slope, c + m + 1, n, middle, radius);
        const double of_q = q->error / least_size(q_value);
        relative = of_q < 0.5 ? (relative + of_q) / (1 - of_q) : HUGE_VAL;
        relative += (1 + relative) * a->unit;
        least /= ball_magnitude(q_value);
        relative += a->least / least;
        LET(slope, BITS, "slope - q_slope/q_value", slope, q_slope, q_value);
    }
    const double of_x = expm1(ball_magnitude(slope) * x_error);
    const double bound = both(relative, of_x) * RAISE + 1e-18;
    return least > 0 ? bound : HUGE_VAL; /* a NaN becomes a failure below */
}

struct cells {
    const struct embed_form *f;
    double lo, hi; /* of the variable, without rounding */
    double root, place;
    double *bound; /* of each cell */
};

static void bound_cell(void *context, slong i)
{
    struct cells *const w = context;
    const struct embed_form *const f = w->f;
    const slong row = i / ROW_CELLS;
    if (f->rows == 0) {
        const double step = log(w->hi / w->lo) / (double)CELLS;
        const double lo = w->lo * exp(step * (double)i) * (1 - 1e-12),
                     hi = w->lo * exp(step * (double)(i + 1)) * (1 + 1e-12);
        w->bound[i] = cell_bound(f, f->number, lo, hi, w->root * hi * RAISE);
        return;
    }
    double lo = 0, hi = 1;
    if (f->family == FAMILY_PIECES_SPEED) {
        const double start = embed_row_start(f, row);
        lo = fmax(f->speed_min - start, 0);
        hi = fmin(embed_row_start(f, row + 1), f->speed_max) - start;
    }
    const double width = (hi - lo) / (double)ROW_CELLS, first = lo + width * (double)(i % ROW_CELLS);
    w->bound[i] = cell_bound(f, f->number + row * (f->numerator + 1), first, first + width, w->place);
}

bool embed_rounding_bound(struct embed_rounding *bound, const struct embed_form *f)
{
    const struct arithmetic *const a = &arithmetic[f->single];
    const double power = 1 / (double)embed_roots[f->variable].degree;
    const slong count = f->rows > 0 ? f->rows * ROW_CELLS : CELLS;
    struct cells w = {.f = f,
                      .lo = pow(f->speed_min, power) * (1 - 1e-12),
                      .hi = pow(f->speed_max, power) * (1 + 1e-12),
                      .root = variable_bound(f, a),
                      .bound = xmalloc((size_t)count * sizeof(double))};
    if (f->family == FAMILY_PIECES_BETA) {
        /* the place x slope + shift, which rounding keeps on its side of 0 and below the number of rows */
        const double most = (double)f->rows, end = most * (1 - a->unit);
        const double of_product = (w.root + a->unit * (1 + w.root)) * RAISE;
        const bool inside = HOLDS(ENCLOSED_BITS, "f->speed_min^(1/5)*f->slope*(1 - of_product) + f->shift > 0",
                                  f->speed_min, f->slope, of_product, f->shift) &&
                            HOLDS(ENCLOSED_BITS, "f->speed_max^(1/5)*f->slope*(1 + of_product) + f->shift < end",
                                  f->speed_max, f->slope, of_product, f->shift, end);
        w.place = inside ? (w.hi * f->slope * of_product + most * a->unit) * (1 + 1e-6) : HUGE_VAL;
    }
    *bound = (struct embed_rounding){.root = w.root, .place = w.place};
    bool found = w.root < 0.01 && w.place < 0.01;
    if (found)
        parallel_for(bound_cell, &w, count, "rounding");
    for (slong i = 0; i < count && found; i++) {
        found = w.bound[i] < 1;
        bound->error = fmax(bound->error, w.bound[i]);
    }
    free(w.bound);
    return found;
}
