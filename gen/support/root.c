/* SPDX-License-Identifier: MIT */
#include "support/root.h"

#include "support/formula.h"

void bracket_init(struct bracket *b)
{
    FOR_ALL(arb, init, b->low, b->high, b->f_low, b->f_high);
    b->side = 0;
}

void bracket_clear(struct bracket *b)
{
    FOR_ALL(arb, clear, b->low, b->high, b->f_low, b->f_high);
}

void bracket_guess(arb_t x, const struct bracket *b, slong prec)
{
    LET(x, prec, "b->low - (b->high - b->low)*b->f_low/(b->f_high - b->f_low)", b->low, b->high, b->f_low, b->f_high);
    arb_get_mid_arb(x, x);
}

void bracket_shrink(struct bracket *b, const arb_t x, const arb_t f)
{
    const bool above = arf_sgn(arb_midref(f)) > 0;
    arb_set(above ? b->low : b->high, x);
    arb_get_mid_arb(above ? b->f_low : b->f_high, f);
    if (b->side == (above ? 1 : -1))
        arb_mul_2exp_si(above ? b->f_high : b->f_low, above ? b->f_high : b->f_low, -1);
    b->side = above ? 1 : -1;
}

void arb_around(arb_t low, arb_t high, const arb_t x, slong exponent, slong prec)
{
    LOCAL(arb, width);
    arb_mul_2exp_si(width, x, exponent);
    arb_sub(low, x, width, prec);
    arb_add(high, x, width, prec);
    arb_get_mid_arb(low, low);
    arb_get_mid_arb(high, high);
}

bool root_near(arb_t x, falling_function *f, const void *context, slong bits, slong prec)
{
    enum { STEPS = 60 };
    LOCAL(arb, low, high, f_low, f_high);
    for (int step = 0; step < STEPS && arb_is_positive(x); step++) {
        arb_get_mid_arb(x, x);
        arb_around(low, high, x, -bits, prec);
        if (!f(f_low, low, context, prec) || !f(f_high, high, context, prec))
            return false;
        if (arb_is_positive(f_low) && arb_is_negative(f_high)) {
            arb_union(x, low, high, prec);
            return true;
        }
        LET(x, prec, "low + f_low/((f_low - f_high)/(high - low))", low, f_low, f_high, high);
    }
    return false;
}
