/* SPDX-License-Identifier: MIT */
/* Tests the proved bounds of 1/Z and of Z^p against powers by another route: the binomial series of the rows of Z. */
#include "ball.h"

#include "series/jet.h"
#include "series/power_bounds.h"
#include "support/local.h"

enum { PREC = 400 };

/* Returns rows 0..order of f^p up to s^(n-1), from f = f_0 (1 + W): f_0^p sum_m binomial(p, m) W^m. */
static arb_poly_struct *rows_power(const arb_poly_struct *f, struct ratio p, slong order, slong n)
{
    arb_poly_struct *w = jet_new(order + 1), *power = jet_new(order + 1), *sum = jet_new(order + 1);
    LOCAL(arb_poly, first, term);
    LOCAL(arb, exponent, binomial);
    for (slong k = 1; k <= order; k++)
        arb_poly_div_series(w + k, f + k, f, n, PREC);
    arb_poly_one(power);
    arb_one(binomial);
    for (slong m = 0; m <= order; m++) {
        for (slong k = m; k <= order; k++) {
            arb_poly_scalar_mul(term, power + k, binomial, PREC);
            arb_poly_add(sum + k, sum + k, term, PREC);
        }
        /* W has no row 0, so row k needs only rows of `power` below k: the largest k comes first. */
        for (slong k = order; k >= 0; k--) {
            arb_poly_zero(first);
            for (slong i = 1; i <= k; i++) {
                arb_poly_mullow(term, w + i, power + k - i, n, PREC);
                arb_poly_add(first, first, term, PREC);
            }
            arb_poly_swap(power + k, first);
        }
        LET(binomial, PREC, "binomial*(p - m)/(m + 1)", binomial, p, m);
    }
    LET(exponent, PREC, "p", p);
    arb_poly_pow_arb_series(first, f, exponent, n, PREC);
    for (slong k = 0; k <= order; k++)
        arb_poly_mullow(sum + k, sum + k, first, n, PREC);
    jet_free(w, order + 1);
    jet_free(power, order + 1);
    return sum;
}

/* Computes sum_k U^k sum_{j >= start} |f_kj| rho^j. */
static void rows_norm(arb_t norm, const arb_poly_struct *f, slong order, slong start, double U, double rho)
{
    arb_zero(norm);
    for (slong k = order; k >= 0; k--) {
        LOCAL(arb, row);
        for (slong j = f[k].length - 1; j >= 0; j--) {
            const arb_srcptr c = f[k].coeffs + j;
            const slong counts = j >= start;
            LET(row, PREC, "row*rho + abs(c)*counts", row, rho, c, counts);
        }
        LET(norm, PREC, "norm*U + row", norm, U, row);
    }
}

/* Fails unless norm <= bound <= 2^slack norm. */
static void assert_bounds(const arb_t bound, const arb_t norm, slong slack, const char *what, const char *law)
{
    LOCAL(arb, most);
    arb_mul_2exp_si(most, norm, slack);
    if (!arb_le(norm, bound) || !arb_le(bound, most)) {
        arb_fprintd(stderr, bound, 10);
        fprintf(stderr, " should bound ");
        arb_fprintd(stderr, norm, 10);
        fail_msg(" to %ld bits: %s, law %s", (long)slack, what, law);
    }
}

static void assert_bounds_of(const struct trajectory *t, const struct power_bounds *b, double U, double rho,
                             const char *name)
{
    const slong columns = 4 * t->terms;
    const struct ratio exponent[] = {{-1, 1}, law_elastic(&t->law), RATIO("t->law.b + 1", &t->law)};
    const int powers = t->x_to_a == t->x_to_b1 ? 1 : 2;
    LOCAL(arb, norm);
    for (int i = -1; i < powers; i++) {
        arb_poly_struct *rows = rows_power(t->x, exponent[i + 1], t->order, columns);
        rows_norm(norm, rows, t->order, 0, U, rho);
        if (i < 0) {
            assert_bounds(b->inverse, norm, 1, "1/Z", name);
        } else {
            assert_bounds(b->size[i], norm, 1, "a power of Z", name);
            rows_norm(norm, rows, t->order, t->terms + 1, U, rho);
            assert_bounds(b->error[i], norm, 12, "the error of a power", name);
        }
        if (i == 0) {
            rows_norm(norm, rows, t->order, t->terms, U, rho);
            assert_bounds(b->last_column, norm, 12, "the last column", name);
        }
        jet_free(rows, t->order + 1);
    }
}

/* The bounds hold for a block of all coefficients of Z, and for a small block, where the rest of Z matters. */
TEST(test_trajectories)
{
    enum { ORDER = 4, TERMS = 30 };
    static const char *const laws[][2] = {{"3/2", "1/2"}, {"3/2", "1/4"}, {"2", "1/2"}, {"1/2", "1"}};
    static const double weights[][2] = {{0.125, 0.25}, {0.25, 0.2}};
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
        const struct cor_exponents law = law_of(laws[i][0], laws[i][1]);
        struct trajectory t;
        trajectory_init(&t, ORDER, TERMS, &law, PREC);
        for (int n = 0; n < 2; n++)
            for (int whole = 0; whole < 2; whole++) {
                struct power_evidence e;
                LOCAL(power_bounds, b);
                const double U = weights[n][0], rho = weights[n][1];
                power_evidence_init(&e, &t, whole ? ORDER + 1 : 2, whole ? TERMS + 1 : 3);
                assert_true(power_bounds_prove(b, &e, U, rho));
                assert_bounds_of(&t, b, U, rho, laws[i][0]);
                power_evidence_clear(&e);
            }
        trajectory_clear(&t);
    }
}

/* For Z = 1 - c s^20, the norm of 1/Z is 1/(1 - c rho^20). A block with the powers s^0 to s^9 contains the 1, but not
 * c. */
TEST(test_one_term)
{
    enum { TERMS = 25, POWER = 20, BLOCK = 10 };
    struct trajectory t = {.law = law_sphere, .order = 0, .terms = TERMS, .prec = PREC, .shift = 0};
    struct power_evidence e;
    LOCAL(power_bounds, b);
    LOCAL(arb, c);
    t.x = jet_new(1);
    arb_poly_one(t.x);
    arb_set_d(c, -0.25);
    arb_poly_set_coeff_arb(t.x, POWER, c);
    t.x_to_a = t.x_to_b1 = rows_power(t.x, law_elastic(&law_sphere), 0, TERMS + 1);
    power_evidence_init(&e, &t, 1, BLOCK);

    assert_true(power_bounds_prove(b, &e, 1, 1));
    assert_bounds_of(&t, b, 1, 1, "3/2");
    assert_true(HOLDS(PREC, "abs(b->inverse - 4/3) < 1/2^20", b->inverse));

    assert_false(power_bounds_prove(b, &e, 1, 1.05)); /* c rho^20 = 0.66 */

    power_evidence_clear(&e);
    jet_free(t.x, 1);
    jet_free(t.x_to_a, 1);
}

/* For Z = 1 + U, a block of two rows gives V = 1 - U. Therefore 1 - Z V is U^2, and the bound is 1/(1 - U). */
TEST(test_rest_of_block)
{
    enum { ORDER = 2, TERMS = 3 };
    struct trajectory t = {.law = law_sphere, .order = ORDER, .terms = TERMS, .prec = PREC, .shift = 0};
    struct power_evidence e;
    LOCAL(power_bounds, b);
    t.x = jet_new(ORDER + 1);
    arb_poly_one(t.x);
    arb_poly_one(t.x + 1);
    t.x_to_a = t.x_to_b1 = rows_power(t.x, law_elastic(&law_sphere), ORDER, TERMS + 1);
    power_evidence_init(&e, &t, 2, 2);
    assert_true(power_bounds_prove(b, &e, 0.5, 1));
    assert_true(HOLDS(PREC, "abs(b->inverse - 2) < 1/2^20", b->inverse));
    power_evidence_clear(&e);
    jet_free(t.x, ORDER + 1);
    jet_free(t.x_to_a, ORDER + 1);
}
