/* SPDX-License-Identifier: MIT */
#include "support/enclosed_function.h"
#include "support/formula.h"
#include "support/local.h"

#include <math.h>

/* A bound of a ratio suffices if it is at most this factor times the value `known`. */
#define NEAR_KNOWN 1.03

enum {
    MOST_DEGREE = 44,
    NEGLIGIBLE = -100 /* terms below 2^NEGLIGIBLE times the value are added to the constant term's radius */
};

void enclosed_shorten(arb_poly_t p)
{
    LOCAL(mag, limit, sum, term);
    slong degree = arb_poly_degree(p);
    if (degree < 1)
        return;
    arb_get_mag(limit, arb_poly_get_coeff_ptr(p, 0));
    mag_mul_2exp_si(limit, limit, NEGLIGIBLE);
    for (; degree > 0; degree--) {
        arb_get_mag(term, arb_poly_get_coeff_ptr(p, degree));
        if (degree <= MOST_DEGREE && mag_cmp(term, limit) > 0)
            break;
        mag_add(sum, sum, term);
    }
    arb_poly_truncate(p, degree + 1);
    arb_add_error_mag(arb_poly_get_coeff_ptr(p, 0), sum);
}

void enclosed_multiply(arb_poly_t z, const arb_poly_t x, const arb_poly_t y)
{
    arb_poly_mul(z, x, y, ENCLOSED_BITS);
    enclosed_shorten(z);
}

void enclosed_add_number(arb_poly_t p, const arb_t c)
{
    LOCAL(arb, constant);
    arb_poly_get_coeff_arb(constant, p, 0);
    arb_add(constant, constant, c, ENCLOSED_BITS);
    arb_poly_set_coeff_arb(p, 0, constant);
}

void enclosed_add_double(arb_poly_t p, double c)
{
    LOCAL(arb, number);
    arb_set_d(number, c);
    enclosed_add_number(p, number);
}

void enclosed_add_radius(arb_poly_t p, const arb_t radius)
{
    LOCAL(arb, constant);
    arb_poly_get_coeff_arb(constant, p, 0);
    arb_add_error(constant, radius);
    arb_poly_set_coeff_arb(p, 0, constant);
}

void enclosed_range(arb_t range, const arb_poly_t p)
{
    LOCAL(arb, radius, c);
    for (slong k = arb_poly_degree(p); k >= 1; k--) {
        arb_abs(c, arb_poly_get_coeff_ptr(p, k));
        arb_add(radius, radius, c, ENCLOSED_BITS);
    }
    arb_poly_get_coeff_arb(range, p, 0);
    arb_add_error(range, radius);
}

void enclosed_rescale(arb_poly_t y, const arb_poly_t p, const arb_t middle, const arb_t half, slong prec)
{
    LOCAL(arb_poly, line);
    arb_poly_set_coeff_arb(line, 1, half);
    arb_poly_set_coeff_arb(line, 0, middle);
    arb_poly_compose(y, p, line, prec);
}

void enclosed_variable(arb_poly_t x, double lo, double hi)
{
    arb_poly_zero(x);
    arb_poly_fit_length(x, 2);
    LET(x->coeffs, ENCLOSED_BITS, "(lo + hi)/2", lo, hi);
    LET(x->coeffs + 1, ENCLOSED_BITS, "(hi - lo)/2", lo, hi);
    _arb_poly_set_length(x, 2);
    _arb_poly_normalise(x);
}

/* exp(c) (1 + w + w^2/2 + ...), w = p - c. The omitted terms are below |w|^(TERMS + 1) exp(|w|)/(TERMS + 1)!. */
bool enclosed_exp(arb_poly_t y, const arb_poly_t p)
{
    enum { TERMS = 30 };
    LOCAL(arb_poly, w, sum);
    LOCAL(arb, c, most, x);
    arb_poly_get_coeff_arb(c, p, 0);
    arb_get_mid_arb(c, c);
    arb_neg(x, c);
    arb_poly_set(w, p);
    enclosed_add_number(w, x);
    enclosed_range(most, w);
    arb_abs(most, most);
    arb_poly_one(sum);
    for (slong k = TERMS; k >= 1; k--) {
        enclosed_multiply(sum, sum, w);
        arb_set_ui(x, (ulong)k);
        arb_poly_scalar_div(sum, sum, x, ENCLOSED_BITS);
        enclosed_add_double(sum, 1);
    }
    LET(x, ENCLOSED_BITS, "most^(TERMS + 1)*exp(most)/gamma(TERMS + 2)", most, TERMS);
    enclosed_add_radius(sum, x);
    arb_exp(c, c, ENCLOSED_BITS);
    arb_poly_scalar_mul(y, sum, c, ENCLOSED_BITS);
    return true;
}

/* Computes the root s of the polynomial p with its radii set to 0, and adds the radius |p - s^2|/s. */
bool enclosed_square_root(arb_poly_t y, const arb_poly_t p)
{
    LOCAL(arb_poly, s, rest);
    LOCAL(arb, least, most);
    arb_poly_set(s, p);
    for (slong k = 0; k < arb_poly_length(s); k++)
        mag_zero(arb_radref(s->coeffs + k));
    const bool positive = arb_poly_length(s) > 0 && arb_is_positive(arb_poly_get_coeff_ptr(s, 0));
    if (positive)
        arb_poly_sqrt_series(s, s, MOST_DEGREE / 2, ENCLOSED_BITS);
    arb_poly_mul(rest, s, s, ENCLOSED_BITS);
    arb_poly_sub(rest, p, rest, ENCLOSED_BITS);
    enclosed_range(most, rest);
    enclosed_range(least, s);
    const bool done = positive && arb_is_positive(least);
    LET(most, ENCLOSED_BITS, "abs(most/least)", most, least);
    arb_poly_set(y, s);
    if (done)
        enclosed_add_radius(y, most);
    enclosed_shorten(y);
    return done;
}

/* Computes c_0 = p(0), and ln(1 + w) or 1/(1 + w) - 1 for w = p/c_0 - 1, by a power series. The sum of its omitted
 * terms is below |w|^(TERMS + 1)/(1 - |w|). */
static bool series_in_rest(arb_poly_t y, arb_t c, const arb_poly_t p, bool logarithm)
{
    enum { TERMS = 64, LEFT_OUT = TERMS + 1 };
    LOCAL(arb_poly, w);
    LOCAL(arb, most, x);
    arb_poly_get_coeff_arb(c, p, 0);
    arb_get_mid_arb(c, c);
    const bool positive = arb_is_positive(c);
    arb_poly_scalar_div(w, p, c, ENCLOSED_BITS);
    enclosed_add_double(w, -1);
    enclosed_range(most, w);
    arb_abs(most, most);
    arb_get_ubound_arf(arb_midref(most), most, ENCLOSED_BITS);
    mag_zero(arb_radref(most));
    arb_poly_zero(y);
    for (slong k = TERMS; k >= 1; k--) {
        const slong sign = k % 2 ? 1 : -1;
        if (logarithm)
            LET(x, ENCLOSED_BITS, "sign/k", sign, k);
        else
            arb_set_si(x, -sign);
        enclosed_add_number(y, x);
        enclosed_multiply(y, y, w);
    }
    const bool done = positive && HOLDS(ENCLOSED_BITS, "most < 1/2", most);
    LET(x, ENCLOSED_BITS, "2*most^LEFT_OUT", most, LEFT_OUT);
    enclosed_add_radius(y, x);
    return done;
}

bool enclosed_logarithm(arb_poly_t y, const arb_poly_t p)
{
    LOCAL(arb, c);
    const bool done = series_in_rest(y, c, p, true);
    if (done) {
        arb_log(c, c, ENCLOSED_BITS);
        enclosed_add_number(y, c);
    }
    return done;
}

bool enclosed_inverse(arb_poly_t y, const arb_poly_t p)
{
    LOCAL(arb, c);
    const bool done = series_in_rest(y, c, p, false);
    if (done) {
        enclosed_add_double(y, 1);
        arb_poly_scalar_div(y, y, c, ENCLOSED_BITS);
    }
    return done;
}

const struct formula_algebra enclosed_algebra = {ENCLOSED_BITS, enclosed_multiply,  enclosed_inverse,
                                                 enclosed_exp,  enclosed_logarithm, enclosed_square_root};

double enclosed_ratio_at(const arb_poly_t f, const arb_poly_t g, double t)
{
    LOCAL(arb, at, x, y);
    arb_set_d(at, t);
    arb_poly_evaluate(x, f, at, ENCLOSED_BITS);
    arb_poly_evaluate(y, g, at, ENCLOSED_BITS);
    return fabs(ball_middle(x) / ball_middle(y));
}

double enclosed_largest_ratio(const arb_poly_t f, const arb_poly_t g, double known, int halvings)
{
    LOCAL(arb, x, y);
    enclosed_range(x, f);
    enclosed_range(y, g);
    arb_div(x, x, y, ENCLOSED_BITS);
    double bound = ball_magnitude(x);
    if (bound > known * NEAR_KNOWN && halvings > 0) {
        LOCAL(arb_poly, part, scale);
        bound = 0;
        for (int side = -1; side <= 1; side += 2) {
            arb_set_d(x, side * 0.5);
            arb_set_d(y, 0.5);
            enclosed_rescale(part, f, x, y, ENCLOSED_BITS);
            enclosed_rescale(scale, g, x, y, ENCLOSED_BITS);
            bound = fmax(bound, enclosed_largest_ratio(part, scale, known, halvings - 1));
        }
    }
    return bound;
}
