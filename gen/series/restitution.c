/* SPDX-License-Identifier: MIT */
#include "series/restitution.h"

#include "series/trajectory.h"
#include "support/console.h"
#include "support/local.h"

/* Computes z = x^e for a series with x(0) > 0 and a rational e of either sign. */
static void series_pow(arb_poly_t z, const arb_poly_t x, struct ratio e, slong n, slong prec)
{
    LOCAL(arb, exponent);
    LET(exponent, prec, "e", e);
    arb_poly_pow_arb_series(z, x, exponent, n, prec);
}

/* The map beta -> -h is an involution. Residues before and after this substitution show that (docs/theory.md, 4)
 *
 *     [beta^k] (h/beta)^p = (-1)^k p/(k+p) [beta^k] (h/beta)^(-k-p),      eps^power = (h/beta)^p, p = power/q,
 *
 * so the coefficient of an even k = -2 p is its own negative and vanishes. */
slong restitution_exact_zero(struct ratio power, const struct cor_exponents *law)
{
    const struct ratio q = law_speed_exponent(law);
    if (q.num == 0)
        return 0;
    const struct ratio k = RATIO("-2*power/q", power, q);
    return k.den == 1 && k.num > 0 && k.num % 2 == 0 ? k.num : 0;
}

void restitution_power(arb_poly_t z, const arb_poly_t eps, struct ratio power, const struct cor_exponents *law, slong n,
                       slong prec)
{
    series_pow(z, eps, power, n, prec);
    const slong k = restitution_exact_zero(power, law);
    if (k > 0 && k < z->length)
        arb_zero(z->coeffs + k);
}

void restitution_zero_overlap(arb_poly_t c, const arb_poly_t y, slong order, const struct cor_exponents *law,
                              slong prec)
{
    /* The equation for Z = E^(2/(1+a)) is F(Z) = Z Y(-beta Z^p) - Y(beta) = 0, p = q (1+a)/2, with F' = Y(v) + p v
     * Y'(v) at v = -beta Z^p. Newton's iteration on the series of Z solves it. */
    const struct ratio half_a1 = RATIO("(law->a + 1)/2", law), p = RATIO("law->b - (law->a - 1)/2", law);
    const slong n = order + 1;
    LOCAL(arb_poly, z, v, value, slope, step, y_prime);
    LOCAL(arb, scale);
    arb_poly_derivative(y_prime, y, prec);
    LET(scale, prec, "p", p);

    arb_poly_one(z);
    for (slong known = 1; known < n;) {
        const slong next = FLINT_MIN(2 * known, n), fresh = next - known;
        series_pow(v, z, p, next, prec);
        arb_poly_shift_left(v, v, 1);
        arb_poly_neg(v, v);
        arb_poly_truncate(v, next);
        arb_poly_compose_series(value, y, v, next, prec);
        arb_poly_mullow(value, value, z, next, prec);
        arb_poly_sub_series(value, value, y, next, prec);
        arb_poly_shift_right(value, value, known);
        arb_poly_compose_series(slope, y, v, fresh, prec);
        arb_poly_compose_series(step, y_prime, v, fresh, prec);
        arb_poly_mullow(step, step, v, fresh, prec);
        arb_poly_scalar_mul(step, step, scale, prec);
        arb_poly_add(slope, slope, step, prec);
        arb_poly_div_series(step, value, slope, fresh, prec);
        arb_poly_shift_left(step, step, known);
        arb_poly_sub(z, z, step, prec);
        known = next;
    }
    series_pow(c, z, half_a1, n, prec);
    restitution_power(c, c, (struct ratio){1, 1}, law, n, prec);
}

/* Computes sum_(k,j) c[k][j] A^k B^j with A = -w T^(b+1), B = w T^(a+1), up to w^(n-1). The sum is X in backward time.
 * If `velocity` is true, the weights e + 1, e = k (b+1) + j (a+1), turn the sum into V = X + D X. Horner's rule sums
 * each row in B, and all rows in A. A and B are O(w), so inner sums, which are multiplied by A and B more often, need
 * fewer terms. */
static void backward_sum(fmpq_poly_t f, const fmpq_poly_struct *row, bool velocity, const fmpq_poly_t T, slong n,
                         const struct cor_exponents *law)
{
    const slong d = law->denominator, exponent[2] = {law->damping + d, law->elastic + d};
    LOCAL(fmpq_poly, log_t, A, B, inner, term);
    LOCAL(fmpq, c, e);
    fmpq_poly_struct *const power[2] = {A, B};
    fmpq_poly_log_series(log_t, T, n);
    for (int i = 0; i < 2; i++) {
        fmpq_set_si(e, exponent[i], (ulong)d);
        fmpq_poly_scalar_mul_fmpq(power[i], log_t, e);
        fmpq_poly_exp_series(power[i], power[i], n);
        fmpq_poly_shift_left(power[i], power[i], 1);
    }
    fmpq_poly_neg(A, A);
    fmpq_poly_zero(f);
    for (slong k = n - 1; k >= 0; k--) {
        fmpq_poly_zero(inner);
        for (slong j = n - 1 - k; j >= 0; j--) {
            fmpq_poly_mullow(inner, inner, B, n - k - j);
            fmpq_poly_get_coeff_fmpq(c, row + k, j);
            if (velocity) {
                fmpq_set_si(e, k * exponent[0] + j * exponent[1] + d, (ulong)d);
                fmpq_mul(c, c, e);
            }
            fmpq_poly_set_fmpq(term, c);
            fmpq_poly_add(inner, inner, term);
        }
        fmpq_poly_mullow(f, f, A, n - k);
        fmpq_poly_add(f, f, inner);
    }
}

void restitution_zero_force_exact(fmpq_poly_t G, fmpq_poly_t T, slong order, const struct cor_exponents *law)
{
    /* In backward time -h replaces beta, x = t X and x' = V. The force vanishes where x^(a-b) = h x', that is at
     * T = (V/X^(a-b))^(1/(a-b)). T enters V and X with a factor w, so each pass makes one more coefficient correct. */
    const slong n = order + 1;
    const struct ratio m = RATIO("law->a - law->b", law);
    fmpq_poly_one(G);
    fmpq_poly_zero(T);
    if (m.num <= 0)
        return;

    fmpq_poly_struct *const row = trajectory_exact(order, order, law);
    LOCAL(fmpq_poly, x, next);
    LOCAL(fmpq, e);
    fmpq_poly_one(T);
    for (slong known = 1; known <= n; known++) {
        progress("zero force, exact", known, n);
        backward_sum(G, row, true, T, known, law);
        backward_sum(x, row, false, T, known, law);
        fmpq_set_si(e, m.den, (ulong)m.num);
        fmpq_poly_log_series(next, G, known);
        fmpq_poly_scalar_mul_fmpq(next, next, e);
        fmpq_poly_log_series(x, x, known);
        fmpq_poly_sub(next, next, x);
        fmpq_poly_exp_series(T, next, known);
    }
    backward_sum(G, row, true, T, n, law);

    trajectory_exact_free(row, n);
}

/* Returns (a+1)/(a-b), the exponent of h in w, for a > b. */
static struct ratio force_exponent(const struct cor_exponents *law)
{
    return RATIO("(law->a + 1)/(law->a - law->b)", law);
}

slong restitution_zero_force_root(const struct cor_exponents *law)
{
    return law_force_ends(law) ? force_exponent(law).den : 1;
}

void restitution_zero_force(arb_poly_t eps, const arb_poly_t c, slong order, const struct cor_exponents *law,
                            slong prec)
{
    const slong root = restitution_zero_force_root(law);
    const slong n = order / root + 1;
    LOCAL(fmpq_poly, G, T);
    LOCAL(arb_poly, h, sum);
    LOCAL(arb, g);
    if (!law_force_ends(law)) {
        arb_poly_set(eps, c);
        arb_poly_truncate(eps, order + 1);
        return;
    }
    const struct ratio e = force_exponent(law);
    const struct ratio q = law_speed_exponent(law);
    const slong terms = order / e.num;

    restitution_zero_force_exact(G, T, terms, law);
    /* w^i = beta^(i e) (eps^q)^(i e); beta^(i e) = z^(i e.num), and the other factor is a series in beta = z^root. */
    for (slong i = 0; i <= terms; i++) {
        LOCAL(fmpq, coefficient);
        fmpq_poly_get_coeff_fmpq(coefficient, G, i);
        arb_set_fmpq(g, coefficient, prec);
        restitution_power(h, c, RATIO("1 + q*e*i", q, e, i), law, n, prec);
        arb_poly_scalar_mul(h, h, g, prec);
        for (slong k = 0; k < h->length && k * root + i * e.num <= order; k++) {
            arb_poly_get_coeff_arb(g, sum, k * root + i * e.num);
            arb_add(g, g, h->coeffs + k, prec);
            arb_poly_set_coeff_arb(sum, k * root + i * e.num, g);
        }
    }
    arb_poly_swap(eps, sum);
}
