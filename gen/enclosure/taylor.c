/* SPDX-License-Identifier: MIT */
#include "enclosure/taylor.h"

#include "support/console.h"
#include "support/local.h"
#include "support/root.h"

#include <math.h>
#include <stdlib.h>

enum {
    /* Norms and remainders need only a few correct digits. */
    NORM_BITS = 40,
    /* A step is about 2^-STEP_BITS of the radius of convergence, so every term gains STEP_BITS bits. N = prec/STEP_BITS
     * terms cost about N^2 products, and a radius takes about 2^STEP_BITS steps. 2^q/q^2 is smallest near q = 3. */
    STEP_BITS = 3,
    /* The Lipschitz constant holds in a tube of this relative width around the polynomials. */
    TUBE_BITS = 10,
    /* Coefficient n needs STEP_BITS n bits less than coefficient 0. COEFFICIENT_GUARD more bits cover the round-off of
     * its sums. */
    COEFFICIENT_GUARD = 24,
    /* With this number of coefficients or more, products of polynomials cost less than sums of products. */
    ONLINE_FROM = 96
};

/* The product f g. exponent: its exponent if it is a power of w, otherwise 0. */
struct taylor_product {
    slong exponent;
    arb_ptr out, f, g; /* arrays of degree + 1 coefficients */
};

static arb_ptr block_new(const struct taylor *y)
{
    return _arb_vec_init(y->degree + 1);
}

static arb_ptr product_new(struct taylor *y, slong exponent, arb_ptr f, arb_ptr g)
{
    y->product = flint_realloc(y->product, (size_t)(y->products + 1) * sizeof *y->product);
    y->product[y->products] = (struct taylor_product){exponent, block_new(y), f, g};
    return y->product[y->products++].out;
}

/* Returns w^exponent. Adds it and its factors to the products if they are missing. */
static arb_ptr power_of_w(struct taylor *y, slong exponent)
{
    if (exponent < 2)
        return exponent == 1 ? y->w : y->one;
    for (int i = 0; i < y->products; i++)
        if (y->product[i].exponent == exponent)
            return y->product[i].out;
    arb_struct *const f = power_of_w(y, exponent / 2), *const g = power_of_w(y, exponent - exponent / 2);
    return product_new(y, exponent, f, g);
}

void taylor_init(struct taylor *y, const struct cor_exponents *law, slong degree, slong prec)
{
    const slong m = FLINT_MIN(law->elastic, law->damping);
    y->law = *law;
    y->degree = degree;
    y->prec = prec;
    y->product = NULL;
    y->products = 0;
    y->one = block_new(y);
    y->w = block_new(y);
    y->v = block_new(y);
    y->t = block_new(y);
    y->force = block_new(y);
    arb_one(y->one);
    y->time_slope = power_of_w(y, law->denominator - 1);
    y->elastic = power_of_w(y, law->elastic - m);
    arb_struct *const outer = power_of_w(y, law->denominator - 1 + m), *const damping = power_of_w(y, law->damping - m);
    y->damped = damping == y->one ? y->v : product_new(y, 0, damping, y->v);
    y->whole_force = product_new(y, 0, outer, y->force); /* computed last */
    FOR_ALL(mag, init, y->error_w, y->error_v, y->error_t);
    FOR_ALL(arb, init, y->c1, y->c2, y->c3, y->step);
}

void taylor_clear(struct taylor *y)
{
    const arb_ptr block[] = {y->one, y->w, y->v, y->t, y->force, NULL};
    for (const arb_ptr *one = block; *one; one++)
        _arb_vec_clear(*one, y->degree + 1);
    for (int i = 0; i < y->products; i++)
        _arb_vec_clear(y->product[i].out, y->degree + 1);
    flint_free(y->product);
    FOR_ALL(mag, clear, y->error_w, y->error_v, y->error_t);
    FOR_ALL(arb, clear, y->c1, y->c2, y->c3, y->step);
}

/* A step is an eighth of the radius of convergence, so a term gains 3 bits. */
slong taylor_degree(slong prec)
{
    return prec / 3 + 10;
}

/* Returns the bits of coefficient n. They affect only widths, because every ball contains its round-off. */
static slong coefficient_bits(slong prec, slong n)
{
    return FLINT_MAX(prec - STEP_BITS * n, 0) + COEFFICIENT_GUARD;
}

/* Computes coefficient n of the product f g, the sum over i + j = n, from coefficients 0 to n of f and g. If
 * `first` > 0, add_known_terms has already added the terms with i < first and j < first. */
static void convolve_product(const struct taylor_product *product, slong n, slong first, const struct taylor *y)
{
    arb_struct *const out = product->out, *const f = product->f, *const g = product->g;
    const slong terms = n - first + 1, prec = coefficient_bits(y->prec, n);
    LOCAL(arb, sum, own);
    if (f == g) {
        /* each product of two different coefficients occurs twice: it is added once and doubled */
        arb_dot(sum, NULL, 0, f + first, 1, f + n - first, -1, first > 0 ? terms : (n + 1) / 2, prec);
        if (first == 0 && n % 2 == 0)
            arb_sqr(own, f + n / 2, prec);
        arb_mul_2exp_si(sum, sum, 1);
        arb_add(sum, sum, own, prec);
    } else {
        arb_dot(sum, NULL, 0, f + first, 1, g + n - first, -1, terms, prec);
        if (first > 0)
            arb_dot(sum, sum, 0, g + first, 1, f + n - first, -1, terms, prec);
    }
    if (first > 0)
        arb_add(out + n, out + n, sum, prec);
    else
        arb_swap(out + n, sum);
}

/* Computes coefficients first to end - 1 of all products, then first + 1 to end of w, v and t. */
static void expand_block(struct taylor *y, slong first, slong end)
{
    LOCAL(arb, x);
    for (slong n = first; n < end; n++) {
        const slong prec = coefficient_bits(y->prec, n);
        for (int i = 0; i < y->products; i++) {
            if (i == y->products - 1) {
                arb_mul(y->force + n, y->c1, y->damped + n, prec);
                arb_addmul(y->force + n, y->c2, y->elastic + n, prec);
            }
            convolve_product(&y->product[i], n, first, y);
        }
        arb_div_si(y->w + n + 1, y->v + n, y->law.denominator * (n + 1), prec);
        arb_mul(x, y->c3, y->time_slope + n, prec);
        arb_sub(x, x, y->whole_force + n, prec);
        arb_div_si(y->v + n + 1, x, n + 1, prec);
        arb_div_si(y->t + n + 1, y->time_slope + n, n + 1, prec);
    }
}

/* ---- online multiplication ---- */

/* Adds the terms that the block of known coefficients first to middle - 1 contributes to coefficients middle to end - 1
 * of the product. If first = 0, both factors are in the block. Otherwise one factor is in the block, and the other is
 * among the known coefficients 0 to end - first - 1. */
static void add_known_terms(const struct taylor_product *product_of, slong first, slong middle, slong end,
                            const struct taylor *y)
{
    arb_struct *const out = product_of->out, *const f = product_of->f, *const g = product_of->g;
    const slong length = end - first, known = middle - first, others = first == 0 ? known : length;
    const slong prec = coefficient_bits(y->prec, middle);
    arb_ptr product = _arb_vec_init(length), left = _arb_vec_init(length), right = _arb_vec_init(known);
    for (int i = 0; i < (first == 0 || f == g ? 1 : 2); i++) {
        _arb_vec_set_round(left, i == 0 ? g : f, others, prec);
        _arb_vec_set_round(right, (i == 0 ? f : g) + first, known, prec);
        _arb_poly_mullow(product, left, others, right, known, FLINT_MIN(length, others + known - 1), prec);
        if (f == g && first > 0)
            _arb_vec_scalar_mul_2exp_si(product, product, length, 1);
        _arb_vec_add(out + middle, out + middle, product + known, end - middle, prec);
    }
    _arb_vec_clear(product, length);
    _arb_vec_clear(left, length);
    _arb_vec_clear(right, known);
}

/* Computes a range of coefficients by the online multiplication of Fischer and Stockmeyer. The factors of a product
 * contain coefficients that follow from lower coefficients of the product. Once the first half of a range is known, its
 * contribution to the second half is a product of polynomials, which FLINT multiplies fast. */
static void expand_range(struct taylor *y, slong first, slong end)
{
    if (end - first <= ONLINE_FROM) {
        expand_block(y, first, end);
        return;
    }
    const slong middle = first + (end - first + 1) / 2;
    expand_range(y, first, middle);
    for (int i = 0; i < y->products; i++)
        add_known_terms(&y->product[i], first, middle, end, y);
    expand_range(y, middle, end);
}

void taylor_expand(struct taylor *y)
{
    for (int i = 0; i < y->products; i++)
        _arb_vec_zero(y->product[i].out, y->degree + 1);
    expand_range(y, 0, y->degree);
}

/* Bounds sum_n |f_n| r^n over n = first..degree from above. */
static void component_norm(arb_t norm, arb_srcptr f, slong first, const struct taylor *y, const mag_t r)
{
    LOCAL(mag, sum, term);
    for (slong n = y->degree; n >= 0; n--) {
        mag_mul(sum, sum, r);
        if (n < first)
            continue;
        arb_get_mag(term, f + n);
        mag_add(sum, sum, term);
    }
    arb_set_upper(norm, sum);
}

/* Bounds the residuals by a radius R > h: terms of degree N and above are below (h/R)^N times their norms at R. */
static void residuals_at(arb_t residual_v, arb_t residual_t, const struct taylor *y, const mag_t h, double ratio)
{
    const slong d = y->law.denominator, ad = y->law.elastic, bd = y->law.damping, N = y->degree;
    const arb_srcptr c1 = y->c1, c2 = y->c2, c3 = y->c3;
    LOCAL(mag, R);
    LOCAL(arb, w, v);
    mag_set_d(R, ratio);
    mag_mul(R, R, h); /* rounded up, so R is at least ratio h */
    component_norm(w, y->w, 0, y, R);
    component_norm(v, y->v, 0, y, R);
    LET(residual_t, NORM_BITS, "w^(d - 1)/ratio^N", w, d, ratio, N);
    LET(residual_v, NORM_BITS, "(abs(c1)*w^bd*v + abs(c2)*w^ad + abs(c3))*residual_t", c1, w, bd, v, c2, ad, c3,
        residual_t);
}

/* Bounds the residuals. Polynomials of degree N solve the equations of motion except for terms of degree N and above in
 * the products. Any radius gives a valid bound. The best radius is at most the radius of convergence, 2^STEP_BITS h.
 * The logarithms of the bounds are convex functions of log R, so each has one minimum. */
static void bound_residuals(arb_t least_v, arb_t least_t, const struct taylor *y, const mag_t h)
{
    enum { PER_OCTAVE = 2 };
    bool falling = true;
    LOCAL(arb, residual_v, residual_t);
    arb_pos_inf(least_v);
    arb_pos_inf(least_t);
    for (int i = STEP_BITS * PER_OCTAVE; i >= PER_OCTAVE && falling; i--) {
        residuals_at(residual_v, residual_t, y, h, exp2((double)i / (double)PER_OCTAVE));
        falling = arb_lt(residual_v, least_v) || arb_lt(residual_t, least_t);
        arb_min(least_v, least_v, residual_v, NORM_BITS);
        arb_min(least_t, least_t, residual_t, NORM_BITS);
    }
}

/* Proves one step on [0, h] in the norm max(kappa |e_w|, |e_v|), where e is the distance of the exact solution from the
 * polynomials (docs/theory.md, 6). Sets the remainders. Returns false if the proof fails. */
static bool prove_step(struct taylor *y, const arb_t step)
{
    const slong d = y->law.denominator, ad = y->law.elastic, bd = y->law.damping;
    const arb_srcptr c1 = y->c1, c2 = y->c2, c3 = y->c3;
    LOCAL(mag, h_mag);
    LOCAL(arb, h, w, v, residual_w, residual_v, residual_t); /* w and v: largest values in the tube */
    LOCAL(arb, by_w, by_v, kappa, lipschitz, error_w, error_v, error_t);
    arb_get_mag(h_mag, step);
    arb_set_upper(h, h_mag);
    component_norm(w, y->w, 0, y, h_mag);
    component_norm(v, y->v, 0, y, h_mag);
    LET(w, NORM_BITS, "w*(1 + 2^-TUBE_BITS)", w, TUBE_BITS);
    LET(v, NORM_BITS, "v*(1 + 2^-TUBE_BITS)", v, TUBE_BITS);
    component_norm(residual_w, y->v, y->degree, y, h_mag);
    arb_div_si(residual_w, residual_w, d, NORM_BITS);
    bound_residuals(residual_v, residual_t, y, h_mag);

    /* L = max(kappa/d, L_w/kappa + L_v) with L_w, L_v >= |d(v')/dw|, |d(v')/dv| in the tube. Any kappa > 0 gives a
     * valid bound; sqrt(d L_w) makes L_w/kappa equal to kappa/d. */
    LET(by_v, NORM_BITS, "abs(c1)*w^(d - 1 + bd)", c1, w, d, bd);
    LET(by_w, NORM_BITS, "(d - 1 + ad)*abs(c2)*w^ad + (d - 1)*abs(c3)", d, ad, c2, w, c3);
    LET(by_w, NORM_BITS, "w^(d - 2)*((d - 1 + bd)*abs(c1)*w^bd*v + by_w)", w, d, bd, c1, v, by_w);
    LET(kappa, NORM_BITS, "sqrt(by_w*d)", by_w, d);
    arb_get_mid_arb(kappa, kappa);
    if (!arb_is_positive(kappa))
        arb_one(kappa);
    LET(lipschitz, NORM_BITS, "max(by_w/kappa + by_v, kappa/d)", by_w, kappa, by_v, d);

    /* |e| <= h max(kappa r_w, r_v) exp(L h), which holds if the right side stays inside the tube. t' = w^(d-1) does not
     * involve t. */
    LET(error_v, NORM_BITS, "max(residual_w*kappa, residual_v)*h*exp(lipschitz*h)", residual_w, kappa, residual_v, h,
        lipschitz);
    arb_div(error_w, error_v, kappa, NORM_BITS);
    LET(error_t, NORM_BITS, "(residual_t + (d - 1)*w^(d - 2)*error_w)*h", residual_t, d, w, error_w, h);
    arb_get_mag(y->error_w, error_w);
    arb_get_mag(y->error_v, error_v);
    arb_get_mag(y->error_t, error_t);

    /* The tube extends by w 2^-TUBE_BITS/(1 + 2^-TUBE_BITS) on each side, which is more than w 2^-TUBE_BITS/2. w must
     * have no pair of zeros inside the step, which its signs at both ends would not show. One of two conditions
     * suffices: (kappa w, v) turns by an angle of at most 2 L h < 3 < pi, or w cannot fall to 0 at the speed v/d. Under
     * a constant force only the first condition also excludes such a pair of zeros of v (24). */
    return HOLDS(NORM_BITS, "error_w < w/2^(TUBE_BITS + 1)", error_w, w, TUBE_BITS) &&
           HOLDS(NORM_BITS, "error_v < v/2^(TUBE_BITS + 1)", error_v, v, TUBE_BITS) &&
           (HOLDS(NORM_BITS, "2*lipschitz*h < 3", lipschitz, h) ||
            (arb_is_zero(c3) && HOLDS(NORM_BITS, "y->w > v*h/d", y->w, v, h, d)));
}

/* Returns log2 of the radius of convergence, estimated from the last coefficients. */
static double radius_guess(const struct taylor *y)
{
    const arb_srcptr component[2] = {y->w, y->v};
    double radius = HUGE_VAL;
    LOCAL(mag, m);
    for (int i = 0; i < 2; i++) {
        arb_get_mag(m, component[i]);
        const double scale = mag_is_zero(m) ? 0.0 : mag_get_d_log2_approx(m);
        for (slong n = y->degree - y->degree / 4; n <= y->degree; n++) {
            arb_get_mag(m, component[i] + n);
            if (!mag_is_zero(m))
                radius = fmin(radius, (scale - mag_get_d_log2_approx(m)) / (double)n);
        }
    }
    return radius == HUGE_VAL ? 0.0 : radius;
}

bool taylor_choose_step(struct taylor *y)
{
    LOCAL(mag, goal, scale);
    bool proved = false;
    /* the remainders must be at most 2^-prec times the larger of |w| and |v|, the size of rounding errors */
    arb_get_mag(goal, y->v);
    arb_get_mag(scale, y->w);
    mag_max(goal, goal, scale);
    mag_mul_2exp_si(goal, goal, -y->prec);
    /* Each trial shortens the step a little, and after FINE_TRIALS failures by much more. A nearly elastic motion under
     * a constant force is nearly a parabola, whose coefficients give no estimate of the radius. */
    enum { FINE_TRIALS = 40, TRIALS = 80, FINE = 8 };
    double exponent = radius_guess(y) - (double)STEP_BITS;
    for (int trial = 0; trial < TRIALS && !proved; trial++) {
        arb_set_d(y->step, exp2(exponent - floor(exponent)));
        arb_mul_2exp_si(y->step, y->step, (slong)floor(exponent));
        proved = prove_step(y, y->step) && mag_cmp(y->error_v, goal) <= 0 && mag_cmp(y->error_w, goal) <= 0;
        exponent -= trial < FINE_TRIALS ? 1.0 / (double)FINE : trial - FINE_TRIALS + 1;
    }
    return proved;
}

/* Computes components that are formulas of the enclosed w and v. A power of w with the factor 0 has the exponent 0. */
static void formula_value(arb_t value, const struct taylor *y, enum taylor_component component, const arb_t w,
                          const arb_t v, slong prec)
{
    const slong d = y->law.denominator, ad = y->law.elastic, bd = y->law.damping, m = FLINT_MIN(ad, bd);
    const arb_srcptr c1 = y->c1, c2 = y->c2;
    if (component == TAYLOR_FORCE) {
        LET(value, prec, "c1*w^(bd - m)*v + c2*w^(ad - m)", c1, w, bd, m, v, c2, ad);
    } else if (component == TAYLOR_DAMPING_EXCESS) {
        LET(value, prec, "(ad - d)*c1*v - ad*c2*w^ad", ad, d, c1, v, c2, w);
    } else {
        /* F' = (c2 a w^(ad-1) v + c1 b w^(bd-1) v^2) - c1 w^(bd+d-1) F, with d w' = v and v' = -w^(d-1) F */
        const slong least = FLINT_MIN(ad > 0 ? ad - 1 : WORD_MAX, bd > 0 ? bd - 1 : d - 1), rest = bd + d - 1 - least;
        const slong by_a = FLINT_MAX(ad - 1 - least, 0), by_b = FLINT_MAX(bd - 1 - least, 0);
        LOCAL(arb, force);
        LET(force, prec, "d*c1*w^rest*(c1*w^bd*v + c2*w^ad)", d, c1, w, rest, bd, v, c2, ad);
        LET(value, prec, "(ad*c2*w^by_a + bd*c1*w^by_b*v)*v - force", ad, c2, w, by_a, bd, c1, by_b, v, force);
    }
}

/* Computes a component at s. With fewer bits than y->prec it drops terms, and the value is then no enclosure. */
static void value_with(arb_t value, const struct taylor *y, enum taylor_component component, const arb_t s, slong prec)
{
    if (component >= TAYLOR_FORCE) {
        LOCAL(arb, w, v);
        value_with(w, y, TAYLOR_W, s, prec);
        value_with(v, y, TAYLOR_V, s, prec);
        formula_value(value, y, component, w, v, prec);
        return;
    }
    const arb_srcptr f = component == TAYLOR_W ? y->w : component == TAYLOR_V ? y->v : y->t;
    LOCAL(arb, sum, place);
    for (slong n = prec < y->prec ? FLINT_MIN(taylor_degree(prec), y->degree) : y->degree; n >= 0; n--) {
        const slong bits = coefficient_bits(prec, n);
        arb_set_round(place, s, bits);
        arb_mul(sum, sum, place, bits);
        arb_add(sum, sum, f + n, bits);
    }
    arb_swap(value, sum);
    arb_add_error_mag(value, component == TAYLOR_W ? y->error_w : component == TAYLOR_V ? y->error_v : y->error_t);
}

void taylor_value(arb_t value, const struct taylor *y, enum taylor_component component, const arb_t s)
{
    value_with(value, y, component, s, y->prec);
}

void taylor_advance(struct taylor *y, const arb_t s)
{
    LOCAL(arb, w, v, t);
    taylor_value(w, y, TAYLOR_W, s);
    taylor_value(v, y, TAYLOR_V, s);
    taylor_value(t, y, TAYLOR_T, s);
    arb_swap(y->w, w);
    arb_swap(y->v, v);
    arb_swap(y->t, t);
}

/* ---- zeros ---- */

/* Sets the values at both ends of the bracket. True if prec bits show that the zero is between them. */
static bool has_signs(struct bracket *b, const struct taylor *y, enum taylor_component component, slong prec)
{
    value_with(b->f_low, y, component, b->low, prec);
    value_with(b->f_high, y, component, b->high, prec);
    return arb_is_positive(b->f_low) && arb_is_negative(b->f_high);
}

/* Makes the bracket narrow around x, where the component is f. Its half width is 1, 2, 4, ... times 2 |f| over the
 * slope of the old bracket, until the signs at its ends enclose the zero. */
static bool surround_zero(struct bracket *b, const struct taylor *y, enum taylor_component component, const arb_t x,
                          const arb_t f, const arb_t begin, const arb_t end, slong prec)
{
    const slong bits = y->prec + COEFFICIENT_GUARD;
    bool signs = false;
    LOCAL(arb, width, least);
    LET(width, NORM_BITS, "2*abs(f)*(b->high - b->low)/(b->f_low - b->f_high)", f, b->high, b->low, b->f_low,
        b->f_high);
    arb_get_ubound_arf(arb_midref(width), width, NORM_BITS);
    mag_zero(arb_radref(width));
    arb_get_mid_arb(least, end);
    arb_mul_2exp_si(least, least, -prec);
    if (!arb_is_finite(width) || arb_lt(width, least))
        arb_set(width, least);
    for (slong i = 0; i < prec && !signs; i++) {
        LET(b->low, bits, "max(x - width, begin)", x, width, begin);
        LET(b->high, bits, "min(x + width, end)", x, width, end);
        arb_get_mid_arb(b->low, b->low);
        arb_get_mid_arb(b->high, b->high);
        signs = has_signs(b, y, component, prec);
        arb_mul_2exp_si(width, width, 1);
    }
    b->side = 0;
    return signs;
}

/* Encloses the zero of a component that falls from positive to negative in [begin, end] and has no other zero there.
 * The Illinois method finds the zero, with few bits at first. Signs on both sides prove it with all bits. */
static bool taylor_root(arb_t root, const struct taylor *y, enum taylor_component component, const arb_t begin,
                        const arb_t end)
{
    enum { STEPS = 200, FIRST_BITS = 64 };
    slong prec = FLINT_MIN(FIRST_BITS, y->prec);
    LOCAL(bracket, b);
    LOCAL(arb, x, f);
    arb_get_mid_arb(b->low, begin);
    arb_get_mid_arb(b->high, end);
    while (!has_signs(b, y, component, prec) && prec < y->prec)
        prec = FLINT_MIN(2 * prec, y->prec);
    arb_get_mid_arb(b->f_low, b->f_low);
    arb_get_mid_arb(b->f_high, b->f_high);
    bool found = false, signs = true;
    while (signs && !found) {
        const bool all = prec == y->prec;
        bool zero = false;
        for (int i = 0; i < STEPS && !zero; i++) {
            bracket_guess(x, b, y->prec + COEFFICIENT_GUARD); /* as narrow as the round-off of f permits */
            value_with(f, y, component, x, prec);
            zero = arb_contains_zero(f);
            if (!zero)
                bracket_shrink(b, x, f);
        }
        prec = FLINT_MIN(2 * prec, y->prec);
        signs = surround_zero(b, y, component, x, f, begin, end, prec);
        found = all && signs;
    }
    if (found)
        arb_union(root, b->low, b->high, y->prec);
    return found;
}

enum taylor_crossing taylor_crosses(arb_t root, const struct taylor *y, enum taylor_component component,
                                    const arb_t begin, const arb_t end)
{
    LOCAL(arb, value);
    taylor_value(value, y, component, end);
    if (arb_is_positive(value))
        return TAYLOR_NOT_YET;
    return arb_is_negative(value) && taylor_root(root, y, component, begin, end) ? TAYLOR_CROSSED : TAYLOR_UNDECIDED;
}

bool taylor_follow(arb_t root, struct taylor *y, enum taylor_component component, const char *what)
{
    LOCAL(arb, begin);
    for (slong step = 0; step < TAYLOR_MAX_STEPS; step++) {
        progress(what, step, 0);
        taylor_expand(y);
        if (!taylor_choose_step(y))
            return false;
        const enum taylor_crossing crossing = taylor_crosses(root, y, component, begin, y->step);
        if (crossing != TAYLOR_NOT_YET)
            return crossing == TAYLOR_CROSSED;
        taylor_advance(y, y->step);
    }
    return false;
}
