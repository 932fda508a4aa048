/* SPDX-License-Identifier: MIT */
#include "series/series.h"

#include <math.h>

#include "series/restitution.h"
#include "support/console.h"
#include "support/local.h"

const char *const contact_end_options[] = {"zero-overlap", "zero-force", NULL};
const char *const contact_end_options_pressed[] = {"zero-overlap", "zero-force", "surface", NULL};
const char *const contact_end_options_all[] = {"zero-overlap", "zero-force", "surface", "approach-only", NULL};
const char *const contact_end_names[] = {"zero_overlap", "zero_force", "surface"};

int contact_end_given(int *end, bool pressed)
{
    if (*end == (pressed ? COR_END_ZERO_FORCE : END_SURFACE))
        return pressed ? usage_error("--end zero-force does not apply under a constant force, where eps is measured at "
                                     "the surface; write --end surface or --end zero-overlap")
                       : usage_error("--end surface needs a constant force; without a force write --end zero-force");
    if (*end == END_SURFACE)
        *end = COR_END_ZERO_FORCE;
    return STATUS_OK;
}

int contact_end_named(int end, bool pressed)
{
    return pressed && end == COR_END_ZERO_FORCE ? END_SURFACE : end;
}

void series_init(struct series *s)
{
    FOR_ALL(arb_poly, init, s->y, s->tau, s->c);
    s->order = 0;
}

void series_clear(struct series *s)
{
    FOR_ALL(arb_poly, clear, s->y, s->tau, s->c);
}

/* Returns the smallest relative accuracy in bits, or absolute accuracy for an interval that contains zero. */
static slong reached_bits(const arb_poly_t f, slong order)
{
    slong reached = WORD_MAX;
    LOCAL(arb, c);
    for (slong k = 0; k <= order; k++) {
        arb_poly_get_coeff_arb(c, f, k);
        if (arb_is_exact(c))
            continue;
        slong bits = arb_rel_accuracy_bits(c);
        if (arb_contains_zero(c)) {
            const fmpz *const e = MAG_EXPREF(arb_radref(c));
            bits = fmpz_fits_si(e) ? -fmpz_get_si(e) : -WORD_MAX / 2;
        }
        reached = FLINT_MIN(reached, bits);
    }
    return reached;
}

/* Bits and terms of the first attempt. They are fitted, with a margin, to the needs of the sphere for at most 300 bits
 * and order 100. A term adds (a+1) log2 R bits, where R is law_elastic_radius; for the sphere these are 5/2 bits. Only
 * the computing time depends on this choice. */
struct start {
    slong prec, terms;
};

static struct start start_of(slong order, const struct cor_exponents *law, slong bits)
{
    const double worth =
        (double)(law->elastic + law->denominator) / (double)law->denominator * log2(law_elastic_radius(law)) / 2.5;
    const struct start start = {bits + 21 * order / 10 + 50,
                                (slong)((0.45 * (double)bits + 1.25 * (double)order + 24) / worth)};
    return start;
}

int series_compute(struct series *s, slong order, const struct cor_exponents *law, slong bits)
{
    const struct start start = start_of(order, law, bits);
    slong prec = start.prec, terms = start.terms;
    for (int attempt = 0; attempt < 16; attempt++) {
        switch (turning_point_series(s->y, s->tau, order, terms, law, bits + 8, prec)) {
        case TURNING_POINT_FEW_TERMS:
            terms += terms / 4 + 8;
            continue;
        case TURNING_POINT_FEW_BITS:
            prec += prec / 4 + 32;
            continue;
        case TURNING_POINT_OK:
            break;
        }
        profile_step("restitution");
        restitution_zero_overlap(s->c, s->y, order, law, prec);
        if (reached_bits(s->c, order) >= bits) {
            profile_step(NULL);
            s->order = order;
            return STATUS_OK;
        }
        /* the accuracy of y limits the accuracy of C */
        prec += prec / 4 + 32;
        terms += terms / 4 + 8;
    }
    return fail("cannot prove the series of order %ld to %ld bits with %ld terms and %ld bits of precision; use a "
                "lower --order or fewer --digits",
                (long)order, (long)bits, (long)terms, (long)prec);
}

int series_eps(arb_poly_t eps, slong *root, enum cor_end end, slong order, const struct cor_exponents *law, slong bits)
{
    *root = end == COR_END_ZERO_FORCE ? restitution_zero_force_root(law) : 1;
    LOCAL(series, s);
    int status = STATUS_OK;
    for (slong extra = 16; status == STATUS_OK; extra *= 2) {
        status = series_compute(s, order / *root, law, bits + extra);
        if (status != STATUS_OK)
            break;
        if (end == COR_END_ZERO_FORCE)
            restitution_zero_force(eps, s->c, order, law, bits + 4 * extra + order);
        else
            arb_poly_set(eps, s->c);
        if (reached_bits(eps, order) >= bits)
            break;
    }
    return status;
}
