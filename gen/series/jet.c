/* SPDX-License-Identifier: MIT */
#include "series/jet.h"

#include "support/local.h"

arb_poly_struct *jet_new(slong count)
{
    arb_poly_struct *f = flint_malloc((size_t)count * sizeof *f);
    for (slong m = 0; m < count; m++)
        arb_poly_init(f + m);
    return f;
}

void jet_free(arb_poly_struct *f, slong count)
{
    for (slong m = 0; m < count; m++)
        arb_poly_clear(f + m);
    flint_free(f);
}

void jet_derivative(arb_poly_struct *slope, const arb_poly_struct *f, slong count, slong prec)
{
    LOCAL(arb, scale);
    for (slong m = 1; m < count; m++) {
        arb_set_si(scale, m);
        arb_poly_scalar_mul(slope + m - 1, f + m, scale, prec);
    }
}

void jet_compose(arb_poly_t y, const arb_poly_struct *f, slong count, const arb_poly_t delta, slong n, slong prec)
{
    LOCAL(arb_poly, sum);
    for (slong m = FLINT_MIN(count, n) - 1; m >= 0; m--) {
        /* delta^m = O(beta^m), so the factor of delta^m is needed only up to beta^(n-1-m). */
        arb_poly_mullow(sum, sum, delta, n - m, prec);
        arb_poly_add_series(sum, sum, f + m, n - m, prec);
    }
    arb_poly_swap(y, sum);
}

void jet_solve(arb_poly_t delta, const arb_poly_struct *f, slong count, slong n, slong prec)
{
    arb_poly_struct *slope = jet_new(count - 1);
    LOCAL(arb_poly, value, derivative);
    jet_derivative(slope, f, count, prec);

    arb_poly_zero(delta);
    /* Newton's method: the coefficients below beta^known are correct, and each pass doubles `known`. Correct
     * coefficients are not recomputed, so their intervals do not grow. */
    for (slong known = 1; known < n;) {
        const slong next = FLINT_MIN(2 * known, n);
        jet_compose(value, f, count, delta, next, prec);
        jet_compose(derivative, slope, count - 1, delta, next - known, prec);
        for (slong k = 0; k < FLINT_MIN(known, value->length); k++)
            arb_zero(value->coeffs + k);
        _arb_poly_normalise(value);
        arb_poly_shift_right(value, value, known);
        arb_poly_div_series(value, value, derivative, next - known, prec);
        arb_poly_shift_left(value, value, known);
        arb_poly_sub(delta, delta, value, prec);
        known = next;
    }

    jet_free(slope, count - 1);
}
