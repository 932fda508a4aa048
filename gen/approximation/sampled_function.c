/* SPDX-License-Identifier: MIT */
#include "approximation/pieces.h"

#include <math.h>
#include <stdlib.h>

#include "support/console.h"
#include "support/formula.h"
#include "support/local.h"

enum {
    ENCLOSURE_BITS = 144, /* working precision */
    SAMPLE_BITS = 100,
    WORKING_BITS = 320,
    BLOCK_ROWS = 6,
    BLOCK_POINTS = 40
};

/* Largest error of a block's polynomial relative to the function */
#define BLOCK_LIMIT 1e-20

struct block {
    double lo, hi;
    arb_poly_t polynomial; /* polynomial in t, -1 <= t <= 1 */
};

struct sampled_function {
    const struct pieces *p;
    function_of_ball *value;
    const void *what;
    struct block *block;
};

static int block_make(struct block *b, const struct sampled_function *s)
{
    LOCAL_VECTOR(at, BLOCK_POINTS);
    LOCAL_VECTOR(value, BLOCK_POINTS);
    for (slong j = 0; j < BLOCK_POINTS; j++) {
        const double x = b->lo + (b->hi - b->lo) * (1 + chebyshev_point(j, BLOCK_POINTS)) / 2;
        arb_set_d(at + j, ldexp(nearbyint(ldexp(x, 44)), -44));
        s->value(value + j, s->what, at + j, false, ENCLOSURE_BITS);
        if (!sample_rounded(value + j, value + j, SAMPLE_BITS))
            return fail("%s: cannot round a sample to %d bits", s->p->name, SAMPLE_BITS);
        unit_place(at + j, at + j, b->lo, b->hi, WORKING_BITS);
    }
    arb_poly_interpolate_newton(b->polynomial, at, value, BLOCK_POINTS, WORKING_BITS);
    return STATUS_OK;
}

static void block_value(arb_t y, const struct block *b, const arb_t x)
{
    LOCAL(arb, t);
    unit_place(t, x, b->lo, b->hi, WORKING_BITS);
    arb_poly_evaluate(y, b->polynomial, t, WORKING_BITS);
}

/* Compares the polynomial with enclosures at two places between samples. */
static int block_check(const struct block *b, const struct sampled_function *s)
{
    static const double fraction[] = {0.0371, 0.9173};
    double worst = 0;
    LOCAL(arb, x, exact, value);
    for (int k = 0; k < 2; k++) {
        arb_set_d(x, b->lo + (b->hi - b->lo) * fraction[k]);
        s->value(exact, s->what, x, true, ENCLOSURE_BITS);
        block_value(value, b, x);
        LET(value, WORKING_BITS, "(value - exact)/exact", value, exact);
        worst = fmax(worst, fabs(arf_get_d(arb_midref(value), ARF_RND_UP)) + mag_get_d(arb_radref(value)));
    }
    return worst <= BLOCK_LIMIT
               ? STATUS_OK
               : fail("%s: the polynomial on [%g, %g] has an error of %.1e", s->p->name, b->lo, b->hi, worst);
}

static int samples_at(arb_t f, const void *context, const struct pieces *p, const struct cell *cell, const arb_t y)
{
    const struct sampled_function *const s = context;
    slong row;
    if (p->variable != VARIABLE_OTHER)
        row = (slong)ldexp((double)(cell->octave - (slong)p->first) + cell->node - 1, (int)p->octave_bits);
    else
        row = (slong)nearbyint((cell->node - p->first) / p->step);
    LOCAL(arb, x);
    arb_mul_2exp_si(x, y, cell->octave);
    block_value(f, &s->block[row / BLOCK_ROWS], x);
    return STATUS_OK;
}

int sampled_function_write(struct emit *e, struct pieces *p, function_of_ball *value, const void *what)
{
    const slong rows = p->rows, blocks = (rows + BLOCK_ROWS - 1) / BLOCK_ROWS;
    const struct sampled_function s = {p, value, what, xmalloc((size_t)blocks * sizeof *s.block)};
    int status = STATUS_OK;
    for (slong i = 0; i < blocks; i++) {
        struct block *const b = &s.block[i];
        const struct cell from = pieces_cell(p, i * BLOCK_ROWS);
        const struct cell to = pieces_cell(p, FLINT_MIN((i + 1) * BLOCK_ROWS, rows) - 1);
        b->lo = ldexp(from.lo, (int)from.octave);
        b->hi = ldexp(to.hi, (int)to.octave);
        arb_poly_init(b->polynomial);
        status = status || block_make(b, &s) || block_check(b, &s);
    }
    if (status == STATUS_OK)
        status = pieces_write(e, p, (struct pieces_function){samples_at, &s});
    for (slong i = 0; i < blocks; i++)
        arb_poly_clear(s.block[i].polynomial);
    free(s.block);
    return status;
}
