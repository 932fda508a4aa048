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
    BITS = 64,        /* bits of intermediate results */
    CELLS = 1024,     /* cells of the range of a variable */
    ROW_CELLS = 4,    /* cells of a row */
    SEED_CELLS = 256, /* cells of an octave */
    ROOT_HALVINGS = 12
};

/* Covers the rounding errors of the few operations on doubles that compute a bound. Bounds may be near 1e-16, so 1 +
 * bound is never computed: see add_relative and power_of_error. */
#define RAISE (1 + 1e-12)
/* Upper limit of |1 - g r^5| for the start of the fifth root. Above this limit the series are of little use. */
#define SEED_LIMIT 0.2

/* For doubles and floats: half a unit in the last place of 1, half the smallest positive number, and the largest
 * number */
static const struct arithmetic {
    double unit, least, most;
} arithmetic[] = {{0x1p-53, 0, DBL_MAX}, {0x1p-24, 0x1p-150, (double)FLT_MAX}};

/* ---- the steps of a program ---- */

enum { NUMBER = EMBED_STEPS, NONE };

/* Encloses each step without rounding, and bounds the errors of the computed values. Step NUMBER is a constant. */
struct rounded {
    const struct arithmetic *arithmetic;
    arb_ptr exact;
    double error[EMBED_STEPS + 1];
};

/* Return (1 + x)(1 + y) - 1 and (1 + x)^n - 1. */
static double add_relative(double x, double y)
{
    return x + y + x * y;
}

static double power_of_error(double x, double n)
{
    return expm1(n * log1p(x));
}

/* Returns a bound of |x| for the computed x. */
static double rounded_size(const struct rounded *v, int x)
{
    return (ball_magnitude(v->exact + x) + v->error[x]) * RAISE;
}

/* Returns the error of one rounding; infinite if the result may overflow */
static double rounding_of(const struct rounded *v, int x)
{
    const double size = rounded_size(v, x);
    return size < v->arithmetic->most / 2 ? size * v->arithmetic->unit + v->arithmetic->least + DBL_MIN : HUGE_VAL;
}

/* Bounds z = x y + addend. The product and the sum are rounded separately, which covers the fused operation. */
static void rounded_mul_add(struct rounded *v, int z, int x, int y, int addend)
{
    const double error = ball_magnitude(v->exact + x) * v->error[y] + rounded_size(v, y) * v->error[x];
    arb_mul(v->exact + z, v->exact + x, v->exact + y, BITS);
    v->error[z] = error * RAISE;
    v->error[z] += rounding_of(v, z);
    if (addend != NONE) {
        arb_add(v->exact + z, v->exact + z, v->exact + addend, BITS);
        v->error[z] += v->error[addend];
        v->error[z] += rounding_of(v, z);
    }
    v->error[z] *= RAISE;
}

/* Bounds steps first to last of a program. row: the coefficients of a row */
static void rounded_steps(struct rounded *v, const struct embed_program *p, int first, int last, const double *row)
{
    for (int i = first; i <= last; i++) {
        const struct embed_step *const s = &p->step[i];
        const double *const c = s->c ? s->c : row;
        arb_set_d(v->exact + NUMBER, -1);
        if (s->code != STEP_HORNER)
            rounded_mul_add(v, i, s->x, s->y, s->code == STEP_MUL ? NONE : s->code == STEP_OFF ? NUMBER : s->z);
        else
            arb_set_d(v->exact + i, c[s->degree]);
        if (s->code == STEP_OFF) /* x y - 1 */
            arb_neg(v->exact + i, v->exact + i);
        for (slong k = s->degree - s->stride; s->code == STEP_HORNER && k >= 0; k -= s->stride) {
            arb_set_d(v->exact + NUMBER, c[k]);
            rounded_mul_add(v, i, s->x, i, c[k] != 0 ? NUMBER : NONE);
        }
    }
}

/* ---- the fifth root ---- */

/* Bounds the error of one refinement: six steps from `first` onward, which compute r S(1 - g r^5) from an r with
 * |1 - g r^5| <= e, where S is a polynomial. Without rounding, the relative distance h of the result from g^(-1/5)
 * satisfies (1 + h)^5 = 1 + H(x), |x| <= e, H(x) = S(x)^5 (1 - x) - 1. The rounding error is computed in units in which
 * r = 1, so g = 1 - x. Returns the bound with rounding; infinite if |H| may reach 1/2, which needs e >= SEED_LIMIT. */
static double root_step(const struct embed_program *p, int first, double e, const struct arithmetic *a)
{
    const struct embed_step *const factor = &p->step[first + 4];
    LOCAL(arb_poly, x, S, h, one);
    LOCAL(arb, radius);
    LOCAL_VECTOR(values, EMBED_STEPS + 1);
    struct rounded v = {a, values, {0}};
    enclosed_variable(x, -e, e);
    for (slong k = factor->degree; k >= 0; k--) {
        const double c_k = factor->c[k];
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
    arb_set_d(radius, e);
    arb_one(values);
    arb_add_error(values, radius);
    arb_one(values + p->step[first].x);
    rounded_steps(&v, p, first, first + 5, NULL);
    const double least = 1 / pow(1 + e, 0.2) * (1 - 2 * exact); /* least S */
    return add_relative(exact, v.error[first + 5] / least) * RAISE;
}

/* Returns a bound of |1 - g r^5| for the start value r. The upper bits of r fall as the upper bits of g rise, so the
 * ends of a speed interval bound r. Over half an interval r falls by 400 units of 2^-20 or more, while a fused
 * operation changes r by one unit. The bound of an interval therefore covers fused operations, too. */
static double start_bound(const struct embed_form *f)
{
    const uint64_t step = UINT64_C(1) << ((f->single ? 23 : 52) - 8), last = emit_bits_of(f->single, f->speed_max);
    double e = 0;
    for (uint64_t bits = emit_bits_of(f->single, f->speed_min) & ~(step - 1); bits <= last; bits += step) {
        const double lo = embed_from_bits(f, bits), hi = embed_from_bits(f, bits + step - 1);
        const double most = embed_root_start(f, lo), least = embed_root_start(f, hi);
        e = fmax(e, fmax(fabs(1 - hi * pow(most, 5)), fabs(1 - lo * pow(least, 5))));
    }
    return e * (1 + 1e-9) + 1e-12;
}

/* Bounds the relative error of the variable of the polynomials. more: allowance for terms of second order */
static double variable_bound(const struct embed_form *f, const struct embed_program *p, const struct arithmetic *a)
{
    static const double more[] = {[FOURTH_ROOT_OF_SPEED] = 1e-6, [TENTH_ROOT_OF_SPEED] = 1e-4};
    double error[EMBED_STEPS] = {0}, e = 0;
    for (int i = 1; i <= p->x; i++) {
        const struct embed_step *const s = &p->step[i];
        if (s->code == STEP_START) {
            e = start_bound(f);
        } else if (p->step[i + 3].code == STEP_OFF) {
            i += 5;
            error[i] = e < SEED_LIMIT ? root_step(p, i - 5, e, a) : HUGE_VAL;
            e = power_of_error(error[i], 5) * RAISE;
        } else if (s->code == STEP_SQRT) {
            error[i] = 0.5 * error[s->x] + a->unit;
        } else {
            error[i] = add_relative(add_relative(error[s->x], error[s->y]), a->unit) * RAISE;
        }
    }
    return error[p->x] * (1 + more[f->variable]);
}

/* ---- polynomials on a cell ---- */

/* Encloses the values of p and of its derivative on the cell middle + radius t. */
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

/* Returns a lower bound of |x| */
static double least_size(const arb_t x)
{
    LOCAL(arf, least);
    arb_get_abs_lbound_arf(least, x, 53);
    return arf_get_d(least, ARF_RND_DOWN);
}

/* Bounds the relative rounding error of the result for arguments lo <= x <= hi of the polynomials. The absolute error
 * of an argument is at most x_error. */
static double cell_bound(const struct embed_form *f, const struct embed_program *program, const double *c, double lo,
                         double hi, double x_error)
{
    const struct arithmetic *const a = &arithmetic[f->single];
    const slong m = f->numerator, n = f->denominator;
    LOCAL(arb, middle, radius, value, slope, q_value, q_slope);
    LOCAL_VECTOR(values, EMBED_STEPS + 1);
    struct rounded v = {a, values, {0}};
    arb_set_d(middle, lo / 2 + hi / 2);
    arb_set_d(radius, ((hi - lo) / 2 + x_error + 1e-15 * fabs(hi) + DBL_MIN) * RAISE);
    arb_set(values + program->argument, middle);
    arb_add_error(values + program->argument, radius);
    rounded_steps(&v, program, program->argument + 1, n > 0 ? program->q : program->p, c);
    cell_values(value, slope, c, m, middle, radius);
    double least = least_size(value), relative = v.error[program->p] / least;
    arb_div(slope, slope, value, BITS);
    if (n > 0) {
        cell_values(q_value, q_slope, c + m + 1, n, middle, radius);
        const double of_q = v.error[program->q] / least_size(q_value);
        relative = of_q < 0.5 ? (relative + of_q) / (1 - of_q) : HUGE_VAL;
        relative += (1 + relative) * a->unit;
        least /= ball_magnitude(q_value);
        relative += a->least / least;
        LET(slope, BITS, "slope - q_slope/q_value", slope, q_slope, q_value);
    }
    const double of_x = expm1(ball_magnitude(slope) * x_error);
    const double bound = add_relative(relative, of_x) * RAISE + 1e-18;
    return least > 0 ? bound : HUGE_VAL; /* if the bound is NaN, embed_rounding_bound fails */
}

struct cells {
    const struct embed_form *f;
    struct embed_program program;
    double lo, hi; /* range of the variable, without rounding */
    double root, place;
    double *bound; /* bound of each cell */
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
        w->bound[i] = cell_bound(f, &w->program, f->number, lo, hi, w->root * hi * RAISE);
        return;
    }
    double lo = 0, hi = 1, place = w->place;
    if (f->family == FAMILY_PIECES_SPEED) {
        const double start = embed_row_start(f, row);
        lo = fmax(f->speed_min - start, 0);
        hi = fmin(embed_row_start(f, row + 1), f->speed_max) - start;
        place = f->knot ? arithmetic[f->single].unit * hi * RAISE : 0; /* speed - start is rounded if start < speed/2 */
    }
    const double width = (hi - lo) / (double)ROW_CELLS, first = lo + width * (double)(i % ROW_CELLS);
    w->bound[i] = cell_bound(f, &w->program, f->number + row * (f->numerator + 1), first, first + width, place);
}

bool embed_rounding_bound(struct embed_rounding *bound, const struct embed_form *f)
{
    const struct arithmetic *const a = &arithmetic[f->single];
    const double power = 1 / (double)embed_roots[f->variable].degree;
    const slong count = f->rows > 0 ? f->rows * ROW_CELLS : CELLS;
    struct cells w = {.f = f,
                      .program = embed_program_of(f),
                      .lo = pow(f->speed_min, power) * (1 - 1e-12),
                      .hi = pow(f->speed_max, power) * (1 + 1e-12),
                      .bound = xmalloc((size_t)count * sizeof(double))};
    w.root = variable_bound(f, &w.program, a);
    if (f->family == FAMILY_PIECES_BETA) {
        /* the rounded place x slope + shift must be above 0 and below the number of rows */
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
