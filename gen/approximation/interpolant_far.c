/* SPDX-License-Identifier: MIT */
#include "approximation/interpolant_parts.h"
#include "support/console.h"
#include "support/local.h"

enum {
    FAR_BITS = 112,
    SOLVING_BITS = 960 /* bits for the linear equations of the far coefficients, which may be ill-conditioned */
};

/* Fills a row with 1, u; mu, mu u, mu u^2; mu^2, mu^2 u, mu^2 u^2, mu^2 u^3. */
static void far_basis(arb_mat_t a, slong row, const arb_t u, const struct cor_exponents *law, slong prec)
{
    LOCAL(arb, mu, term);
    interpolant_power(mu, u, interpolant_tail_power(law, EPS_ZERO_FORCE), prec);
    slong column = 0;
    for (slong order = 0; order < 3; order++) {
        arb_pow_ui(term, mu, (ulong)order, prec);
        for (slong exponent = 0; exponent <= order + 1; exponent++) {
            arb_set(arb_mat_entry(a, row, column++), term);
            arb_mul(term, term, u, prec);
        }
    }
}

/* True if the duration at zero overlap has a term beta^((a-1)/n) that is not among beta^(a/(b+1)) mu^i. Then
 * kappa = (b-a+1)/n is neither 0 nor 1. For the sphere kappa is 0. */
static bool falls_apart(const struct cor_exponents *law)
{
    const slong n = 2 * law->damping - law->elastic + law->denominator,
                m = law->damping - law->elastic + law->denominator; /* kappa = m/n */
    return n > 0 && m != 0 && m != n;
}

/* Returns an exponent of beta minus interpolant_tail_power. fall: true for the factor of the coefficient `fall`, false
 * for the factor of the sum over mu^i u^j. */
static struct ratio far_excess(const struct cor_exponents *law, bool fall)
{
    const struct ratio a = law_elastic(law), b = law_damping(law),
                       leading = interpolant_tail_power(law, DURATION_ZERO_OVERLAP);
    return fall ? RATIO("(a - 1)/(2*b - a + 1) - leading", a, b, leading) : RATIO("a/(b + 1) - leading", a, b, leading);
}

static bool has_far(const struct interpolant *f, enum quantity quantity)
{
    const struct interpolant_layout *layout = f->layout;
    for (int i = 0; i < layout->intervals; i++)
        if (layout->interval[i].variable == INTERVAL_LOG && layout->interval[i].form == FORM_POWER &&
            has_quantity(&layout->interval[i], quantity))
            return quantity != EPS_ZERO_OVERLAP;
    return false;
}

/* Fits the coefficients of a quantity to an equal number of samples. */
static bool fit_far(struct interpolant *f, enum quantity quantity, const struct samples *s)
{
    const struct cor_exponents *const law = &f->layout->law;
    const bool falls = quantity == DURATION_ZERO_OVERLAP && falls_apart(law);
    const slong n = INTERPOLANT_FAR + falls;
    LOCAL(arb, u, excess);
    LOCAL_MATRIX(n, n, a);
    LOCAL_MATRIX(n, 1, b);
    for (slong k = 0; k < n; k++) {
        arb_log(u, s->beta + k, SOLVING_BITS);
        far_basis(a, k, u, law, SOLVING_BITS);
        arb_set(arb_mat_entry(b, k, 0), s->value[quantity] + k);
        if (!falls)
            continue;
        interpolant_power(excess, u, far_excess(law, false), SOLVING_BITS);
        _arb_vec_scalar_mul(arb_mat_entry(a, k, 0), arb_mat_entry(a, k, 0), INTERPOLANT_FAR, excess, SOLVING_BITS);
        interpolant_power(arb_mat_entry(a, k, INTERPOLANT_FAR), u, far_excess(law, true), SOLVING_BITS);
    }
    const bool solved = arb_mat_solve(b, a, b, SOLVING_BITS);
    for (slong k = 0; k < INTERPOLANT_FAR; k++)
        arb_set(f->far[quantity] + k, arb_mat_entry(b, k, 0));
    if (falls)
        arb_set(f->fall, arb_mat_entry(b, INTERPOLANT_FAR, 0));
    return solved;
}

int interpolant_make_far(struct interpolant *f)
{
    struct interval interval = {INTERVAL_LOG, 0, 0, 0, FAR_BITS, FORM_POWER, 0};
    for (int q = 0; q < QUANTITIES; q++)
        if (has_far(f, (enum quantity)q))
            interval.set |= 1u << q;
    interval.count = INTERPOLANT_FAR + (falls_apart(&f->layout->law) && has_far(f, DURATION_ZERO_OVERLAP));
    struct samples s;
    samples_init(&s, interval.count);
    /* u of sample k: 9.5, 10, ... for spheres, larger if mu falls more slowly */
    const double slower = 5.0 / 3 / ratio_double(law_mu_power(&f->layout->law));
    for (slong k = 0; k < interval.count; k++)
        interpolant_place(s.beta + k, s.node + k, f, &interval, (9.5 + 0.5 * (double)k) * slower);
    int status = samples_collide(&s, 1, f, &interval, "collisions at large beta");
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++)
        if (has_quantity(&interval, (enum quantity)q) && !fit_far(f, (enum quantity)q, &s))
            status = fail("cannot solve for the coefficients at large beta");
    samples_clear(&s, interval.count);
    return status;
}

void interpolant_far_value(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t u, slong prec)
{
    const struct cor_exponents *law = &f->layout->law;
    LOCAL(arb, power, own);
    LOCAL_MATRIX(1, INTERPOLANT_FAR, basis);
    far_basis(basis, 0, u, law, INTERPOLANT_BITS);
    arb_zero(y);
    for (slong k = 0; k < INTERPOLANT_FAR; k++)
        arb_addmul(y, arb_mat_entry(basis, 0, k), f->far[quantity] + k, prec);
    if (quantity == DURATION_ZERO_OVERLAP && !arb_is_zero(f->fall)) {
        interpolant_power(power, u, far_excess(law, false), prec);
        interpolant_power(own, u, far_excess(law, true), prec);
        LET(y, prec, "y*power + f->fall*own", y, power, f->fall, own);
    }
    interpolant_power(power, u, interpolant_tail_power(law, quantity), prec);
    arb_mul(y, y, power, prec);
}

/* Solves e = mu (1 + mu q_1(u) + mu^2 q_2(u)), u = -(3/5) ln(mu), for beta = mu^(-3/5) in powers of e. With v = -(3/5)
 * ln(e), the first order is (3/5) q_1(v), and the second is (9/25) (q_1 q_1' - 2 q_1^2) + (3/5) q_2 at v. */
void interpolant_far_inverse(arb_ptr coefficient, const struct interpolant *f)
{
    const slong prec = INTERPOLANT_BITS;
    arb_srcptr far = f->far[EPS_ZERO_FORCE]; /* coefficients of 1, u; mu (1, u, u^2); mu^2 (1, ..., u^3) */
    LOCAL(arb_poly, q1, q2, second);
    LOCAL(arb, c, d);
    for (slong k = 0; k < 3; k++)
        arb_poly_set_coeff_arb(q1, k, far + 2 + k);
    for (slong k = 0; k < 4; k++)
        arb_poly_set_coeff_arb(q2, k, far + 5 + k);
    arb_poly_scalar_div(q1, q1, far, prec);
    arb_poly_scalar_div(q2, q2, far, prec);
    arb_poly_derivative(second, q1, prec);
    arb_poly_sub(second, second, q1, prec);
    arb_poly_sub(second, second, q1, prec);
    arb_poly_mul(second, second, q1, prec);
    arb_set(coefficient, far);
    for (slong k = 0; k < INTERPOLANT_FAR_INVERSE - 1; k++) {
        const slong power = k < 3 ? k : k - 3;
        arb_poly_get_coeff_arb(c, k < 3 ? q1 : q2, power);
        arb_zero(d);
        if (k >= 3)
            arb_poly_get_coeff_arb(d, second, power);
        LET(coefficient + 1 + k, prec, "(15*c + 9*d)/25", c, d);
    }
}
