/* SPDX-License-Identifier: MIT */
/* Tests the restitution series against enclosed collisions, which prove every coefficient, and against closed forms. */
#include "ball.h"

#include "enclosure/collision.h"
#include "series/restitution.h"
#include "series/series.h"

/* ---- against collisions ---- */

/* Checks that sum f_k x^k, k <= order, differs from `value` by x^(order + 1/2) at most. This exceeds the omitted terms
 * but not the terms up to `order`, so those coefficients are right. */
static void assert_sum(const arb_poly_t f, const arb_t x, slong order, const arb_t value, slong prec, const char *what)
{
    LOCAL(arb_poly, head);
    LOCAL(arb, sum, bound);
    LOCAL(mag, width, least);
    arb_poly_set(head, f);
    arb_poly_truncate(head, order + 1);
    arb_poly_evaluate(sum, head, x, prec);
    LET(bound, prec, "sqrt(x)^(2*order + 1)", x, order);
    arb_add_error(sum, bound);
    assert_overlap(sum, value, what, order);
    /* the collision must be narrow enough to decide this */
    mag_mul_2exp_si(width, arb_radref(value), 8);
    arb_get_mag_lower(least, bound);
    assert_true(mag_cmp(width, least) < 0);
}

/* Compares the sum of the series at beta = 2^-shift with an enclosed collision, which detects an error of C_k above
 * 2^(-shift (order - k + 1/2)). A second computation finds the same coefficients to `bits` bits. */
static void compare_with_collision(const struct cor_exponents *law, slong order, slong shift, slong bits)
{
    LOCAL(series, s, few);
    LOCAL(collision, c);
    LOCAL(arb_poly, force, few_force);
    LOCAL(arb, x);
    const slong exact = shift * (order + 1) + 40, root = restitution_zero_force_root(law);
    slong found;
    assert_int_equal(series_compute(s, order, law, exact), 0);
    LET(x, exact, "1/2^shift", shift);
    assert_int_equal(collision_solve(c, x, law, exact), 0);
    assert_sum(s->y, x, order, c->x_max, 2 * exact, "x_max");
    assert_sum(s->tau, x, order, c->t_max, 2 * exact, "t_max");
    assert_sum(s->c, x, order, c->eps_zero_overlap, 2 * exact, "zero overlap");
    restitution_zero_force(force, s->c, order * root, law, 2 * exact);
    arb_root_ui(x, x, (ulong)root, 2 * exact);
    assert_sum(force, x, order * root, c->eps_zero_force, 2 * exact, "zero force");
    assert_int_equal(series_eps(few_force, &found, COR_END_ZERO_FORCE, order * root, law, bits), 0);
    assert_int_equal(found, root);
    assert_poly_overlap(force, few_force, order * root, "zero force");
    assert_int_equal(series_compute(few, order, law, bits), 0);
    assert_poly_overlap(s->c, few->c, order, "C_k");
    for (slong k = 1; k <= order; k++) {
        arb_poly_get_coeff_arb(x, few->c, k);
        if (!arb_is_zero(x)) /* test_exact_zeros tests exact zeros */
            assert_bits(x, bits);
    }
}

/* Tests the sphere and other laws. The coefficients of (2, 1/2) grow fast with the power of s, so a truncation bound
 * that allows the same error for every power would prove nothing. Collisions of the linear dashpot, of Tsuji's law, and
 * of Hunt and Crossley's law are closed forms. */
TEST(test_collisions)
{
    leave_to_turn(1, 2);
    static const struct {
        const char *a, *b;
        slong few, all, shift;
    } cases[] = {{"3/2", "1/2", 16, 60, 32}, {"2", "1/2", 8, 30, 48},    {"2", "1/3", 8, 12, 48},
                 {"5/4", "1", 8, 12, 48},    {"3/2", "0", 8, 12, 48},    {"4", "3", 8, 12, 48},
                 {"1", "0", 24, 40, 32},     {"3/2", "1/4", 24, 40, 32}, {"3/2", "3/2", 24, 40, 32},
                 {"1/2", "1/2", 24, 40, 32}, {"1/2", "0", 4, 8, 48},     {"0", "0", 4, 8, 48},
                 {"1", "2", 4, 8, 48},       {"24", "1/16", 2, 2, 48}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const struct cor_exponents law = law_of(cases[i].a, cases[i].b);
        if (i < 2 || in_turn(i, 4))
            compare_with_collision(&law, (slong)few_or_all((size_t)cases[i].few, (size_t)cases[i].all), cases[i].shift,
                                   100);
    }
}

/* q = -1/N with a whole N: C_2N = 0. The series contains an exact zero, the collision only a small ball. For (5, 0),
 * where q = -2/3, no coefficient vanishes. Source of the value: docs/theory.md, 9. */
TEST(test_exact_zeros)
{
    leave_to_turn(1, 3);
    static const struct {
        const char *a, *b;
        slong zero;
    } cases[] = {{"5", "0", 0}, {"3", "0", 4}, {"2", "0", 6}, {"3", "1/2", 8}, {"3/2", "0", 10}, {"2", "1/4", 12}};
    LOCAL(series, s);
    LOCAL(arb, x);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const struct cor_exponents law = law_of(cases[i].a, cases[i].b);
        const slong order = cases[i].zero ? cases[i].zero + 2 : 12;
        assert_int_equal(series_compute(s, order, &law, 80), 0);
        for (slong k = 1; k <= order; k++) {
            arb_poly_get_coeff_arb(x, s->c, k);
            assert_true(arb_is_zero(x) == (k == cases[i].zero));
            assert_true(arb_is_zero(x) || !arb_contains_zero(x));
            if (i == 0 && k == 3)
                assert_digits(x, "0.0237");
        }
        if (in_turn(i, 3))
            compare_with_collision(&law, order, 48, 80);
    }
}

/* Too few bits or terms for the requested accuracy are refused. The balls contain the truth in any case. */
TEST(test_verdicts)
{
    enum { ORDER = 12 };
    static const struct {
        slong terms, bits, prec;
    } tried[] = {{30, 100, 64}, {60, 100, 90}, {60, 100, 128}, {90, 100, 200}, {10, 60, 400}};
    LOCAL(series, s);
    LOCAL(arb_poly, y, tau);
    LOCAL(arb, x);
    assert_int_equal(series_compute(s, ORDER, &law_sphere, 200), 0);
    for (size_t i = 0; i < sizeof tried / sizeof *tried; i++) {
        const enum turning_point_verdict verdict =
            turning_point_series(y, tau, ORDER, tried[i].terms, &law_sphere, tried[i].bits, tried[i].prec);
        assert_poly_overlap(y, s->y, ORDER, "y_k");
        assert_poly_overlap(tau, s->tau, ORDER, "tau_k");
        for (slong k = 0; k <= ORDER && verdict == TURNING_POINT_OK; k++) {
            arb_poly_get_coeff_arb(x, y, k);
            assert_bits(x, tried[i].bits);
        }
    }
}

/* ---- closed forms ---- */

/* G and T of docs/theory.md, 5, for spheres, and for Hertz with a constant dashpot */
TEST(test_zero_force)
{
    static const struct {
        const char *b, *G[5], *T[3];
    } known[] = {
        {"1/2", {"1", "4/15", "13/150", "4897/160875"}, {"1", "4/35", "2/75"}},
        {"0", {"1", "3/5", "36/175", "368/7875", "69788/10308375"}, {"1", "1/70", "-17/1575"}},
    };
    LOCAL(fmpq_poly, G, T);
    LOCAL(fmpq, want, got);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const struct cor_exponents law = law_of("3/2", known[i].b);
        restitution_zero_force_exact(G, T, 4, &law);
        for (slong k = 0; k < 8; k++) {
            const char *const text = k < 5 ? known[i].G[k] : known[i].T[k - 5];
            fmpq_poly_get_coeff_fmpq(got, k < 5 ? G : T, k < 5 ? k : k - 5);
            assert_true(!text || (fmpq_set_str(want, text, 10) == 0 && fmpq_equal(want, got)));
        }
    }
}

/* |C_(k+1)/C_k| -> 1/h* */
TEST(test_radius)
{
    LOCAL(series, s);
    LOCAL(arb, x, y, z);
    assert_int_equal(series_compute(s, 60, &law_sphere, 80), 0);
    assert_int_equal(collision_h_star(y, 80), 0);
    arb_poly_get_coeff_arb(x, s->c, 60);
    arb_poly_get_coeff_arb(z, s->c, 59);
    LET(x, 80, "z/x/y", z, x, y);
    assert_true(fabs(middle(x) + 1) < 0.05);
}
