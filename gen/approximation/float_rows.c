/* SPDX-License-Identifier: MIT */
#include "approximation/float_rows.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/parallel.h"

enum { DEGREE = 3, WORKING_BITS = 128, POINTS = 8 /* a row's error is sampled at POINTS + 1 places */ };

/* ---- cells ---- */

struct float_cell {
    double node, lo, hi;
};

static struct float_cell cell_of(const struct float_rows *r, slong row)
{
    if (row == 0)
        return (struct float_cell){0, 0, ldexp(1, r->first_octave)};
    const slong above = row - 1, per_octave = WORD(1) << r->octave_bits;
    const int octave = r->first_octave + (int)(above / per_octave);
    const double width = ldexp(1, octave - r->octave_bits);
    const double lo = ldexp(1, octave) + (double)(above % per_octave) * width;
    return (struct float_cell){lo + width / 2, lo, lo + width};
}

/* A place in the cell, rounded to a number of few bits */
static double place_in(const struct float_cell *cell, double fraction)
{
    const double unit = ldexp(cell->hi, -30);
    return nearbyint((cell->lo + (cell->hi - cell->lo) * fraction) / unit) * unit;
}

/* ---- one row ---- */

static void quantity_at(arb_t y, const struct float_rows *r, const struct interpolant *f, double beta)
{
    arb_t z;
    arb_init(z);
    arb_set_d(z, beta);
    arb_sqrt(z, z, WORKING_BITS);
    interpolant_value(y, f, r->quantity, z, WORKING_BITS);
    arb_clear(z);
}

/* The cubic in t = beta - node through f - c_0 at the Chebyshev points of the cell */
static void cubic_of_cell(double a[DEGREE + 1], const struct float_rows *r, const struct interpolant *f,
                          const struct float_cell *cell, double c_0)
{
    arb_ptr t = _arb_vec_init(DEGREE + 1), value = _arb_vec_init(DEGREE + 1);
    arb_poly_t polynomial;
    arb_t beta;
    arb_poly_init(polynomial);
    arb_init(beta);
    for (slong j = 0; j <= DEGREE; j++) {
        const double place = place_in(cell, (1 + chebyshev_point(j, DEGREE + 1)) / 2);
        quantity_at(value + j, r, f, place);
        arb_set_d(beta, c_0);
        arb_sub(value + j, value + j, beta, WORKING_BITS);
        arb_set_d(t + j, place - cell->node); /* exact */
    }
    arb_poly_interpolate_barycentric(polynomial, t, value, DEGREE + 1, WORKING_BITS);
    for (slong k = 0; k <= DEGREE; k++) {
        arb_poly_get_coeff_arb(beta, polynomial, k);
        a[k] = arf_get_d(arb_midref(beta), ARF_RND_NEAR);
    }
    arb_clear(beta);
    arb_poly_clear(polynomial);
    _arb_vec_clear(t, DEGREE + 1);
    _arb_vec_clear(value, DEGREE + 1);
}

/* c_0 at a node, and its remainder */
static double head_of(double *remainder, const struct float_rows *r, const struct interpolant *f, double node)
{
    const slong bits = r->head_bits > 0 ? r->head_bits : FLT_MANT_DIG;
    arb_t y;
    arf_t head;
    arb_init(y);
    arf_init(head);
    quantity_at(y, r, f, node);
    arf_set_round(head, arb_midref(y), bits, ARF_RND_NEAR);
    arb_sub_arf(y, y, head, WORKING_BITS);
    *remainder = arf_get_d(arb_midref(y), ARF_RND_NEAR);
    const double c_0 = arf_get_d(head, ARF_RND_NEAR);
    arf_clear(head);
    arb_clear(y);
    return c_0;
}

static uint32_t word_of(float x)
{
    uint32_t word;
    memcpy(&word, &x, sizeof word);
    return word;
}

static float float_of(uint32_t word)
{
    float x;
    memcpy(&x, &word, sizeof x);
    return x;
}

/* c_0' as the evaluator sees it */
static float remainder_in(float c_3)
{
    return float_of(word_of(c_3) << 16);
}

/* The float nearest to c_3 whose lower half of bits is c_0' to 8 bits */
static float with_remainder(double c_3, double remainder)
{
    const uint32_t low = (word_of((float)remainder) + 0x8000) >> 16;
    const uint32_t high = word_of((float)c_3) & 0xffff0000;
    float nearest = float_of(high | low);
    for (int up = -1; up <= 1; up += 2) {
        const float other = float_of((high + (uint32_t)up * 0x10000) | low);
        if (fabs((double)other - c_3) < fabs((double)nearest - c_3))
            nearest = other;
    }
    return nearest;
}

/* c_3 is off by d = a_3 - c_3. In the cell of half width h around m, d t^3 is a polynomial of degree 2 plus
 * d h^3 T_3((t - m)/h)/4. The polynomial goes to the other coefficients, its constant term to c_0'. */
static void columns_of_cubic(float c[FLOAT_ROWS_COLUMNS], double c_0, const double a[DEGREE + 1],
                             const struct float_cell *cell)
{
    const double m = (cell->lo + cell->hi) / 2 - cell->node, h2 = pow((cell->hi - cell->lo) / 2, 2);
    c[0] = (float)c_0;
    c[3] = with_remainder(a[3], a[0]);
    if (cell->node > 0)
        c[3] = with_remainder(a[3], a[0] + (a[3] - (double)c[3]) * m * (m * m - 0.75 * h2));
    const double d = a[3] - (double)c[3];
    c[1] = (float)(a[1] + d * (0.75 * h2 - 3 * m * m));
    c[2] = (float)(a[2] + d * 3 * m);
}

/* -log2 of the largest relative error that is found in the cell, exactly evaluated */
static double row_bits(const struct float_rows *r, const struct interpolant *f, const struct float_cell *cell,
                       const float *c)
{
    const double pi = 3.14159265358979323846;
    double worst = 0;
    arb_t beta, exact, value, term;
    arb_init(beta);
    arb_init(exact);
    arb_init(value);
    arb_init(term);
    for (int k = 0; k <= POINTS; k++) {
        const double place = place_in(cell, (1 - cos(k * pi / (double)POINTS)) / 2);
        quantity_at(exact, r, f, place);
        arb_zero(value);
        arb_set_d(beta, place - cell->node);
        for (int i = DEGREE; i >= 1; i--) {
            arb_set_d(term, (double)c[i]);
            arb_add(value, value, term, WORKING_BITS);
            arb_mul(value, value, beta, WORKING_BITS);
        }
        arb_set_d(term, (double)remainder_in(c[3]));
        arb_add(value, value, term, WORKING_BITS);
        arb_set_d(term, (double)c[0]);
        arb_add(value, value, term, WORKING_BITS);
        arb_sub(value, value, exact, WORKING_BITS);
        arb_div(value, value, exact, WORKING_BITS);
        const double error = fabs(arf_get_d(arb_midref(value), ARF_RND_UP)) + mag_get_d(arb_radref(value));
        worst = error <= worst ? worst : error; /* a NaN stays */
    }
    arb_clear(beta);
    arb_clear(exact);
    arb_clear(value);
    arb_clear(term);
    return -log2(worst);
}

/* ---- all rows ---- */

struct float_cutting {
    struct float_rows *rows;
    const struct interpolant *f;
};

static void cut_float_row(void *context, slong row)
{
    const struct float_cutting *const work = context;
    struct float_rows *const r = work->rows;
    const struct float_cell cell = cell_of(r, row);
    float *const c = r->column + row * FLOAT_ROWS_COLUMNS;
    double a[DEGREE + 1], remainder;
    const double c_0 = head_of(&remainder, r, work->f, cell.node);
    cubic_of_cell(a, r, work->f, &cell, c_0);
    if (row == 0) /* exact at beta = 0: eps never exceeds 1, however the caller rounds */
        a[0] = remainder;
    columns_of_cubic(c, c_0, a, &cell);
    r->bits[row] = row_bits(r, work->f, &cell, c);
}

int float_rows_make(struct float_rows *r, const struct interpolant *f)
{
    struct float_cutting work = {r, f};
    r->rows = 1 + ((slong)(r->end_octave - r->first_octave) << r->octave_bits);
    r->column = xmalloc((size_t)r->rows * FLOAT_ROWS_COLUMNS * sizeof *r->column);
    r->bits = xmalloc((size_t)r->rows * sizeof *r->bits);
    parallel_for(cut_float_row, &work, r->rows, r->name);
    for (slong row = 0; row < r->rows; row++)
        if (!(r->bits[row] >= r->least_bits))
            return fail("%s, row %ld reaches %.1f bits, not the %.1f it must", r->name, (long)row, r->bits[row],
                        r->least_bits);
    return STATUS_OK;
}

void float_rows_clear(struct float_rows *r)
{
    free(r->column);
    free(r->bits);
    r->column = NULL;
    r->bits = NULL;
}

void float_rows_emit(struct emit *e, const struct float_rows *r)
{
    double worst = INFINITY;
    for (slong row = 0; row < r->rows; row++)
        worst = fmin(worst, r->bits[row]);
    emit_comment(e,
                 "%s: beta < %g in row 0, then %d rows to an octave, beta < %g.\n"
                 "Relative error of the approximation: 2^-%.1f at most, sampled at %d places of each row.",
                 r->title, ldexp(1, r->first_octave), 1 << r->octave_bits, ldexp(1, r->end_octave),
                 floor(worst * 10) / 10, POINTS + 1);
    emit_geometry_real(e, r->name, "FIRST", ldexp(1, r->first_octave));
    emit_geometry_integer(e, r->name, "OCTAVE_BITS", r->octave_bits);
    emit_geometry_integer(e, r->name, "ROWS", r->rows);
    emit_geometry_real(e, r->name, "END", ldexp(1, r->end_octave));
    emit_float_rows_open(e, r->name, r->rows, FLOAT_ROWS_COLUMNS);
    for (slong row = 0; row < r->rows; row++) {
        const struct float_cell cell = cell_of(r, row);
        char text[128];
        snprintf(text, sizeof text, "[%ld] beta < %g, %.1f bits", (long)row, cell.hi, floor(r->bits[row] * 10) / 10);
        emit_float_row(e, text, r->column + row * FLOAT_ROWS_COLUMNS, FLOAT_ROWS_COLUMNS, row + 1 == r->rows);
    }
    emit_float_rows_close(e);
}
