/* SPDX-License-Identifier: MIT */
#include "approximation/pade.h"

#include <float.h>
#include <math.h>
#include <stdatomic.h>
#include <stdbool.h>

#include "enclosure/collision.h"
#include "support/console.h"
#include "support/digits.h"
#include "support/local.h"
#include "support/parallel.h"

enum {
    BITS = 192,                /* precision of references and of all computations in this file */
    SMALL_STEP = 6,            /* ratio of small sample points, as a power of 2 */
    FAR_STEP = 5,              /* large sample points have the ratio 5/4 */
    PIECES = 512,              /* pieces up to PADE_NEAR, and the same number above; the condition is bounded on each */
    OPERATIONS_PER_DEGREE = 3, /* the rounding of z, one product, one sum */
};

void pade_rounded_init(struct pade_rounded *r)
{
    FOR_ALL(arb_poly, init, r->p, r->q, r->l, r->p_double, r->q_double, r->l_double);
    r->root = 1;
}

void pade_rounded_clear(struct pade_rounded *r)
{
    FOR_ALL(arb_poly, clear, r->p, r->q, r->l, r->p_double, r->q_double, r->l_double);
}

static int round_polynomial(arb_poly_t rounded, const arb_poly_t exact, const char *name)
{
    LOCAL(arb, x);
    arb_poly_zero(rounded);
    int status = 0;
    for (slong i = 0; i < arb_poly_length(exact) && status == 0; i++) {
        double y;
        if (digits_to_double(&y, arb_poly_get_coeff_ptr(exact, i))) {
            arb_set_d(x, y);
            arb_poly_set_coeff_arb(rounded, i, x);
        } else {
            status = fail("cannot round coefficient %ld of the %s: its enclosure is too wide", (long)i, name);
        }
    }
    return status;
}

int pade_round(struct pade_rounded *r, const struct pade *f)
{
    r->root = f->root;
    arb_poly_set(r->p, f->p);
    arb_poly_set(r->q, f->q);
    /* eps = 1 + O(beta), so the coefficients of Q - P below z^root are exactly 0, and their intervals contain 0. */
    arb_poly_sub(r->l, f->q, f->p, ARF_PREC_EXACT);
    for (slong i = 0; i < r->root; i++)
        if (i < arb_poly_length(r->l) && !arb_contains_zero(arb_poly_get_coeff_ptr(r->l, i)))
            return fail("1 - P/Q is not of the order of beta");
    arb_poly_shift_right(r->l, r->l, r->root);
    return round_polynomial(r->p_double, r->p, "numerator") || round_polynomial(r->q_double, r->q, "denominator") ||
           round_polynomial(r->l_double, r->l, "loss");
}

struct collecting {
    struct references *references;
    const struct cor_exponents *law;
    atomic_bool failed;
};

static void reference_collide(void *context, slong i)
{
    struct collecting *const work = context;
    struct references *const s = work->references;
    LOCAL(collision, c);
    LOCAL(arb, beta);
    arb_set_fmpq(beta, s->beta + i, 2 * BITS);
    if (collision_solve(c, beta, work->law, BITS) != STATUS_OK)
        atomic_store(&work->failed, true);
    arb_set(s->eps[COR_END_ZERO_OVERLAP] + i, c->eps_zero_overlap);
    arb_set(s->eps[COR_END_ZERO_FORCE] + i, c->eps_zero_force);
}

int references_init(struct references *s, const struct cor_exponents *law, slong beta_max, slong even, slong small)
{
    const slong near = FLINT_MIN(beta_max, PADE_NEAR);
    s->even = even;
    s->far = (slong)ceil(log((double)beta_max / (double)near) / log((double)FAR_STEP / (FAR_STEP - 1)));
    s->count = even + small + s->far;
    s->beta = _fmpq_vec_init(s->count);
    for (int end = 0; end < 2; end++)
        s->eps[end] = _arb_vec_init(s->count);
    for (slong i = 0; i < s->count; i++) {
        const slong j = i - even + 1, above = j - small;
        if (i < even)
            EXACT(s->beta + i, "near*(i + 1)/even", near, i, even);
        else if (above <= 0)
            EXACT(s->beta + i, "near/2^(SMALL_STEP*j)", near, SMALL_STEP, j);
        else
            EXACT(s->beta + i, "near*(FAR_STEP/(FAR_STEP - 1))^above", near, FAR_STEP, above);
        if (fmpq_cmp_si(s->beta + i, beta_max) > 0)
            fmpq_set_si(s->beta + i, beta_max, 1);
    }
    struct collecting work = {.references = s, .law = law};
    parallel_for(reference_collide, &work, s->count, "collisions to compare with");
    if (!atomic_load(&work.failed))
        return STATUS_OK;
    references_clear(s);
    return STATUS_FAILED;
}

void references_clear(struct references *s)
{
    _fmpq_vec_clear(s->beta, s->count);
    for (int end = 0; end < 2; end++)
        _arb_vec_clear(s->eps[end], s->count);
}

void pade_error_init(struct pade_error *e)
{
    e->eps = e->loss = 0;
    fmpq_init(e->eps_at_beta);
    fmpq_init(e->loss_at_beta);
}

void pade_error_clear(struct pade_error *e)
{
    fmpq_clear(e->eps_at_beta);
    fmpq_clear(e->loss_at_beta);
}

static double upper_bound(const arb_t x)
{
    return arb_is_finite(x) ? ball_end(x, true) : INFINITY;
}

/* Returns |approximate/exact - 1|, rounded up. */
static double relative_difference(const arb_t approximate, const arb_t exact)
{
    LOCAL(arb, x);
    LET(x, BITS, "abs(approximate/exact - 1)", approximate, exact);
    return upper_bound(x);
}

void pade_approximation_error(struct pade_error *e, const struct pade_rounded *r, enum cor_end end,
                              const struct references *s)
{
    LOCAL(arb, beta, z, p, q, l, lost);
    e->eps = e->loss = 0;
    for (slong i = 0; i < s->count; i++) {
        const arb_srcptr exact = s->eps[end] + i;
        arb_set_fmpq(beta, s->beta + i, BITS);
        arb_root_ui(z, beta, (ulong)r->root, BITS);
        arb_poly_evaluate(p, r->p_double, z, BITS);
        arb_poly_evaluate(q, r->q_double, z, BITS);
        arb_poly_evaluate(l, r->l_double, z, BITS);
        LET(p, BITS, "p/q", p, q);
        LET(l, BITS, "l*beta/q", l, beta, q);
        LET(lost, BITS, "1 - exact", exact);
        const double eps = relative_difference(p, exact), loss = relative_difference(l, lost);
        if (!(eps <= e->eps)) {
            e->eps = eps;
            fmpq_set(e->eps_at_beta, s->beta + i);
        }
        if (!(loss <= e->loss)) {
            e->loss = loss;
            fmpq_set(e->loss_at_beta, s->beta + i);
        }
    }
}

/* Computes gamma_k = k u/(1 - k u), u = 2^-53. */
static void gamma_bound(arb_t g, slong k)
{
    LET(g, BITS, "k/(2^53 - k)", k);
}

/* Bounds the relative error of Horner's rule for P(z), for every z of the interval. Each coefficient carries at most
 * OPERATIONS_PER_DEGREE deg P + 1 factors (1 + delta), |delta| <= u (Higham 2002, 5.1). The condition sum |p_i|
 * z^i / |P(z)| multiplies their effect. */
static void horner_error(arb_t error, const arb_poly_t p, const arb_poly_t magnitude, const arb_poly_t slope,
                         const arb_t z)
{
    LOCAL(arb, centre, at_centre, rise, gamma);
    /* mean value form: P at the midpoint, P' over the interval */
    arb_get_mid_arb(centre, z);
    arb_poly_evaluate(rise, slope, z, BITS);
    arb_poly_evaluate(at_centre, p, centre, BITS);
    arb_poly_evaluate(error, magnitude, z, BITS);
    gamma_bound(gamma, OPERATIONS_PER_DEGREE * arb_poly_degree(p) + 1);
    LET(error, BITS, "error/abs(at_centre + (z - centre)*rise)*gamma", error, at_centre, z, centre, rise, gamma);
}

/* Returns (1 + n)/(1 - d) (1 + u)^rounded - 1. */
static double quotient_error(const arb_t n, const arb_t d, slong rounded)
{
    LOCAL(arb, x, gamma);
    gamma_bound(gamma, rounded);
    LET(x, BITS, "(1 + n)/(1 - d)*(1 + gamma) - 1", n, d, gamma);
    return HOLDS(BITS, "d < 1", d) ? upper_bound(x) : INFINITY;
}

/* Computes the start z of piece k: PIECES equal pieces up to PADE_NEAR, then PIECES in geometric progression. */
static void piece_end(arb_t z, const struct pade_rounded *r, slong beta_max, slong k)
{
    const slong near = FLINT_MIN(beta_max, PADE_NEAR);
    if (k <= PIECES)
        LET(z, BITS, "near^(1/r->root)*k/PIECES", near, r->root, k, PIECES);
    else
        LET(z, BITS, "((beta_max/near)^((k - PIECES)/PIECES)*near)^(1/r->root)", beta_max, near, k, PIECES, r->root);
}

void pade_evaluation_error(double *eps, double *loss, const struct pade_rounded *r, slong beta_max)
{
    const arb_poly_struct *poly[3] = {r->p_double, r->q_double, r->l_double};
    arb_poly_t magnitude[3], slope[3];
    arb_t error[3];
    LOCAL(arb, z, low, high, sum);
    arb_set_si(z, beta_max);
    arb_root_ui(z, z, (ulong)r->root, BITS);
    *eps = *loss = 0;
    for (int i = 0; i < 3; i++) {
        FOR_ALL(arb_poly, init, magnitude[i], slope[i]);
        arb_init(error[i]);
        arb_poly_set(magnitude[i], poly[i]);
        for (slong k = 0; k < arb_poly_length(poly[i]); k++)
            arb_abs(magnitude[i]->coeffs + k, poly[i]->coeffs + k);
        arb_poly_derivative(slope[i], poly[i], BITS);
        /* no partial sum of Horner's rule may overflow; sum |p_i| z^i at the largest z bounds all of them */
        arb_poly_evaluate(sum, magnitude[i], z, BITS);
        if (!arb_is_finite(sum) || arf_cmpabs_2exp_si(arb_midref(sum), DBL_MAX_EXP - 2) > 0)
            *eps = *loss = INFINITY;
    }
    for (slong k = 0; k < (beta_max > PADE_NEAR ? 2 : 1) * PIECES; k++) {
        piece_end(low, r, beta_max, k);
        piece_end(high, r, beta_max, k + 1);
        arb_union(z, low, high, BITS);
        for (int i = 0; i < 3; i++)
            horner_error(error[i], poly[i], magnitude[i], slope[i], z);
        *eps = fmax(*eps, quotient_error(error[0], error[1], 1));
        *loss = fmax(*loss, quotient_error(error[2], error[1], 2));
    }
    for (int i = 0; i < 3; i++) {
        FOR_ALL(arb_poly, clear, magnitude[i], slope[i]);
        arb_clear(error[i]);
    }
}
