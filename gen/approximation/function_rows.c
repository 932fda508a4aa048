/* SPDX-License-Identifier: MIT */
#include "approximation/function_rows.h"

#include <math.h>
#include <stdlib.h>

#include "approximation/interpolant.h"
#include "support/console.h"
#include "support/digits.h"

enum {
    ENCLOSURE_BITS = 144, /* working precision */
    SAMPLE_BITS = 100,
    WORKING_BITS = 320,
    BLOCK_ROWS = 6,
    BLOCK_POINTS = 40,
    POINTS = 24 /* where a row's error is sampled */
};

/* Allowed error of a block's polynomial relative to the function */
#define BLOCK_LIMIT 1e-20

/* The function in [lo, hi] as a polynomial through BLOCK_POINTS samples, in barycentric form */
struct block {
    arb_ptr at, value, weight;
};

static double block_point(double lo, double hi, slong j)
{
    const double x = lo + (hi - lo) * (1 + chebyshev_point(j, BLOCK_POINTS)) / 2;
    return ldexp(nearbyint(ldexp(x, 44)), -44);
}

/* f(x) rounded to SAMPLE_BITS; the rounded number then counts as exact */
static int sample(arb_t value, const struct function_rows *r, const arb_t x)
{
    arf_t low, high;
    r->value(value, x, ENCLOSURE_BITS);
    arf_init(low);
    arf_init(high);
    arb_get_interval_arf(low, high, value, ENCLOSURE_BITS);
    arf_set_round(low, low, SAMPLE_BITS, ARF_RND_NEAR);
    arf_set_round(high, high, SAMPLE_BITS, ARF_RND_NEAR);
    const int decided = arf_is_finite(low) && arf_equal(low, high);
    arb_set_arf(value, low);
    arf_clear(low);
    arf_clear(high);
    return decided ? STATUS_OK : fail("%s: a sample cannot be rounded to %d bits", r->name, SAMPLE_BITS);
}

static int block_make(struct block *b, const struct function_rows *r, double lo, double hi)
{
    int status = STATUS_OK;
    arb_t difference;
    arb_init(difference);
    b->at = _arb_vec_init(BLOCK_POINTS);
    b->value = _arb_vec_init(BLOCK_POINTS);
    b->weight = _arb_vec_init(BLOCK_POINTS);
    for (slong j = 0; j < BLOCK_POINTS && status == STATUS_OK; j++) {
        arb_set_d(b->at + j, block_point(lo, hi, j));
        status = sample(b->value + j, r, b->at + j);
    }
    for (slong j = 0; j < BLOCK_POINTS && status == STATUS_OK; j++) {
        arb_one(b->weight + j);
        for (slong k = 0; k < BLOCK_POINTS; k++) {
            if (k == j)
                continue;
            arb_sub(difference, b->at + j, b->at + k, WORKING_BITS);
            arb_div(b->weight + j, b->weight + j, difference, WORKING_BITS);
        }
    }
    arb_clear(difference);
    return status;
}

static void block_clear(struct block *b)
{
    _arb_vec_clear(b->at, BLOCK_POINTS);
    _arb_vec_clear(b->value, BLOCK_POINTS);
    _arb_vec_clear(b->weight, BLOCK_POINTS);
}

static void block_value(arb_t y, const struct block *b, const arb_t x)
{
    arb_t above, below, term;
    arb_init(above);
    arb_init(below);
    arb_init(term);
    for (slong j = 0; j < BLOCK_POINTS; j++) {
        arb_sub(term, x, b->at + j, WORKING_BITS);
        if (arb_is_zero(term)) {
            arb_set(above, b->value + j);
            arb_one(below);
            break;
        }
        arb_div(term, b->weight + j, term, WORKING_BITS);
        arb_add(below, below, term, WORKING_BITS);
        arb_addmul(above, term, b->value + j, WORKING_BITS);
    }
    arb_div(y, above, below, WORKING_BITS);
    arb_clear(above);
    arb_clear(below);
    arb_clear(term);
}

/* Compares the polynomial with enclosures at two places between samples. */
static int block_check(const struct block *b, const struct function_rows *r, double lo, double hi)
{
    double worst = 0;
    arb_t x, exact, value;
    arb_init(x);
    arb_init(exact);
    arb_init(value);
    for (int k = 0; k < 2; k++) {
        arb_set_d(x, lo + (hi - lo) * (k == 0 ? 0.0371 : 0.9173));
        r->enclosure(exact, x, ENCLOSURE_BITS);
        block_value(value, b, x);
        arb_sub(value, value, exact, WORKING_BITS);
        arb_div(value, value, exact, WORKING_BITS);
        worst = fmax(worst, fabs(arf_get_d(arb_midref(value), ARF_RND_UP)) + mag_get_d(arb_radref(value)));
    }
    arb_clear(x);
    arb_clear(exact);
    arb_clear(value);
    return worst <= BLOCK_LIMIT ? STATUS_OK
                                : fail("%s: the polynomial on [%g, %g] is off by %.1e", r->name, lo, hi, worst);
}

static double node_of(const struct function_rows *r, slong row)
{
    return r->first + (double)row * r->step;
}

/* A sample point of a cell: a double with few bits between its ends */
static double between(const struct function_rows *r, slong row, double fraction)
{
    return ldexp(nearbyint(ldexp(node_of(r, row) + r->step * (fraction - 0.5), 40)), -40);
}

static void row_cut(arb_ptr c, const struct function_rows *r, const struct block *b, slong row)
{
    enum { N = FUNCTION_ROWS_DEGREE };
    arb_ptr t = _arb_vec_init(N), quotient = _arb_vec_init(N);
    arb_poly_t polynomial;
    arb_t node, y;
    arb_poly_init(polynomial);
    arb_init(node);
    arb_init(y);
    arb_set_d(node, node_of(r, row));
    block_value(c, b, node);
    for (slong j = 0; j < N; j++) {
        /* never the node itself, where the quotient is 0/0 */
        arb_set_d(y, between(r, row, (1 + chebyshev_point(j, N)) / 2) + ldexp(1, -41));
        block_value(quotient + j, b, y);
        arb_sub(t + j, y, node, WORKING_BITS);
        arb_sub(quotient + j, quotient + j, c, WORKING_BITS);
        arb_div(quotient + j, quotient + j, t + j, WORKING_BITS);
    }
    arb_poly_interpolate_barycentric(polynomial, t, quotient, N, WORKING_BITS);
    for (slong k = 0; k < N; k++)
        arb_poly_get_coeff_arb(c + 2 + k, polynomial, k);
    /* the remainder of the double nearest to c_0 */
    arb_set_d(c + 1, arf_get_d(arb_midref(c), ARF_RND_NEAR));
    arb_sub(c + 1, c, c + 1, WORKING_BITS);
    arb_poly_clear(polynomial);
    arb_clear(node);
    arb_clear(y);
    _arb_vec_clear(t, N);
    _arb_vec_clear(quotient, N);
}

/* The row of doubles at y, exactly evaluated */
static void row_value(arb_t value, const double *c, double node, const arb_t y)
{
    arb_t t, term;
    arb_init(t);
    arb_init(term);
    arb_set_d(t, node);
    arb_sub(t, y, t, WORKING_BITS);
    arb_zero(value);
    for (slong k = FUNCTION_ROWS_COLUMNS - 1; k >= 1; k--) {
        arb_mul(value, value, t, WORKING_BITS);
        arb_set_d(term, c[k]);
        arb_add(value, value, term, WORKING_BITS);
    }
    arb_set_d(term, c[0]);
    arb_add(value, value, term, WORKING_BITS);
    arb_clear(t);
    arb_clear(term);
}

/* -log2 of the largest relative error found in a cell */
static double row_bits(const struct function_rows *r, const struct block *b, slong row, const double *c)
{
    double worst = 0;
    arb_t y, exact, value;
    arb_init(y);
    arb_init(exact);
    arb_init(value);
    for (int k = 0; k <= POINTS; k++) {
        arb_set_d(y, between(r, row, k / (double)POINTS));
        block_value(exact, b, y);
        row_value(value, c, node_of(r, row), y);
        arb_sub(value, value, exact, WORKING_BITS);
        arb_div(value, value, exact, WORKING_BITS);
        worst = fmax(worst, fabs(arf_get_d(arb_midref(value), ARF_RND_UP)));
    }
    arb_clear(y);
    arb_clear(exact);
    arb_clear(value);
    return -log2(worst);
}

static int row_make(struct function_rows *r, const struct block *b, slong row)
{
    double c[FUNCTION_ROWS_COLUMNS];
    arb_ptr exact = r->coefficient + row * FUNCTION_ROWS_COLUMNS;
    row_cut(exact, r, b, row);
    for (slong k = 0; k < FUNCTION_ROWS_COLUMNS; k++)
        if (!digits_to_double(&c[k], exact + k))
            return fail("%s, row %ld: coefficient %ld cannot be rounded", r->name, (long)row, (long)k);
    r->bits[row] = row_bits(r, b, row, c);
    if (!(r->bits[row] >= r->least_bits))
        return fail("%s, row %ld reaches %.1f bits, not the %.1f it must", r->name, (long)row, r->bits[row],
                    r->least_bits);
    return STATUS_OK;
}

int function_rows_make(struct function_rows *r)
{
    r->coefficient = _arb_vec_init(r->rows * FUNCTION_ROWS_COLUMNS);
    r->bits = xmalloc((size_t)r->rows * sizeof *r->bits);
    int status = STATUS_OK;
    for (slong row = 0; row < r->rows && status == STATUS_OK; row += BLOCK_ROWS) {
        const slong last = row + BLOCK_ROWS < r->rows ? row + BLOCK_ROWS : r->rows;
        const double lo = node_of(r, row) - r->step / 2, hi = node_of(r, last - 1) + r->step / 2;
        struct block b;
        status = block_make(&b, r, lo, hi);
        if (status == STATUS_OK)
            status = block_check(&b, r, lo, hi);
        for (slong i = row; i < last && status == STATUS_OK; i++)
            status = row_make(r, &b, i);
        block_clear(&b);
    }
    return status;
}

void function_rows_clear(struct function_rows *r)
{
    if (r->coefficient)
        _arb_vec_clear(r->coefficient, r->rows * FUNCTION_ROWS_COLUMNS);
    free(r->bits);
    r->coefficient = NULL;
    r->bits = NULL;
}

static void emit_geometry(struct emit *e, const struct function_rows *r)
{
    emit_geometry_real(e, r->name, "FIRST", r->first);
    emit_geometry_real(e, r->name, "STEP", r->step);
    emit_geometry_real(e, r->name, "PER_UNIT", 1 / r->step);
    emit_geometry_integer(e, r->name, "ROWS", r->rows);
    emit_geometry_real(e, r->name, "END", r->end);
}

int function_rows_emit(struct emit *e, const struct function_rows *r)
{
    double worst = INFINITY;
    for (slong row = 0; row < r->rows; row++)
        worst = fmin(worst, r->bits[row]);
    emit_comment(e,
                 "%s: %ld rows of degree %d in y = %s, nodes %g + i %g, y < %g.\n"
                 "Relative error of the approximation: 2^-%.1f at most, sampled at %d places of each row.",
                 r->title, (long)r->rows, FUNCTION_ROWS_DEGREE, r->variable, r->first, r->step, r->end,
                 floor(worst * 10) / 10, POINTS + 1);
    emit_geometry(e, r);
    emit_rows_open(e, r->name, r->rows, FUNCTION_ROWS_COLUMNS);
    for (slong row = 0; row < r->rows; row++) {
        const double node = node_of(r, row);
        char text[128];
        snprintf(text, sizeof text, "[%ld] %g <= y <= %g, %.1f bits", (long)row, node - r->step / 2, node + r->step / 2,
                 floor(r->bits[row] * 10) / 10);
        if (emit_row(e, text, r->coefficient + row * FUNCTION_ROWS_COLUMNS, FUNCTION_ROWS_COLUMNS, row + 1 == r->rows))
            return STATUS_FAILED;
    }
    emit_rows_close(e);
    return STATUS_OK;
}
