/* SPDX-License-Identifier: MIT */
/* The restitution series: closed forms at high order, and a second route to every coefficient. */
#include "ball.h"
#include "check.h"

#include "enclosure/collision.h"
#include "series/restitution.h"
#include "series/series.h"
#include "series/turning_point.h"
#include "support/local.h"

static const slong BITS = 160, PREC = 260;

/* C_1 = -sqrt(pi) Gamma(3/5) / (2^(1/5) 5^(2/5) Gamma(21/10)), (30); C_2 = (3/5) C_1^2, (69); (51). */
static void test_closed_forms(void **state)
{
    (void)state;
    struct series s;
    LOCAL(arb, x, y, c);
    LOCAL(fmpq, q);
    series_init(&s);
    assert_int_equal(series_compute(&s, 6, &law_sphere, BITS), 0);
    fmpq_set_si(q, 3, 5);
    arb_gamma_fmpq(x, q, PREC);
    fmpq_set_si(q, 21, 10);
    arb_gamma_fmpq(y, q, PREC);
    arb_div(x, x, y, PREC);
    arb_const_sqrt_pi(y, PREC);
    arb_mul(x, x, y, PREC);
    arb_set_si(y, 50); /* 2 5^2 */
    arb_root_ui(y, y, 5, PREC);
    arb_div(x, x, y, PREC);
    arb_neg(x, x);
    arb_poly_get_coeff_arb(c, s.c, 1);
    assert_overlap(x, c, "C_k", 1);
    assert_bits(c, BITS);
    arb_sqr(x, x, PREC);
    arb_mul_si(x, x, 3, PREC);
    arb_div_si(x, x, 5, PREC);
    arb_poly_get_coeff_arb(c, s.c, 2);
    assert_overlap(x, c, "C_k", 2);
    /* (51) by another beta function: t_0 = (4/5)^(3/5) Gamma(2/5) Gamma(1/2) / (2 Gamma(9/10)) */
    fmpq_set_si(q, 2, 5);
    arb_gamma_fmpq(x, q, PREC);
    fmpq_set_si(q, 9, 10);
    arb_gamma_fmpq(y, q, PREC);
    arb_div(x, x, y, PREC);
    arb_const_sqrt_pi(y, PREC);
    arb_mul(x, x, y, PREC);
    arb_mul_2exp_si(x, x, -1);
    arb_set_si(y, 4);
    arb_div_si(y, y, 5, PREC);
    fmpq_set_si(q, 3, 5);
    arb_pow_fmpq(y, y, q, PREC);
    arb_mul(x, x, y, PREC);
    arb_poly_get_coeff_arb(c, s.tau, 0);
    assert_overlap(x, c, "tau_k", 0);
    series_clear(&s);
}

/* exp(-z (pi - both asin z)/sqrt(1 - z^2)) with z = beta scale: the linear dashpot at zero overlap (both = 0) and
 * at zero force (both = 2). */
static void dashpot(arb_poly_t eps, const arb_t scale, int both, slong n, slong prec)
{
    LOCAL(arb_poly, z, f, g);
    LOCAL(arb, pi);
    arb_poly_set_coeff_arb(z, 1, scale);
    arb_poly_asin_series(f, z, n, prec);
    arb_set_si(pi, -both);
    arb_poly_scalar_mul(f, f, pi, prec);
    arb_const_pi(pi, prec);
    arb_poly_set_coeff_arb(f, 0, pi);
    arb_poly_mullow(g, z, z, n, prec);
    arb_poly_neg(g, g);
    arb_poly_add_si(g, g, 1, prec);
    arb_poly_rsqrt_series(g, g, n, prec);
    arb_poly_mullow(f, f, g, n, prec);
    arb_poly_mullow(f, f, z, n, prec);
    arb_poly_neg(f, f);
    arb_poly_exp_series(eps, f, n, prec);
}

/* Linear dashpot (1, 0), zeta = beta/2, and Tsuji's (3/2, 1/4), zeta = beta/sqrt(5): both ends. */
static void test_linear_laws(void **state)
{
    (void)state;
    const slong order = points(24) > 24 ? 40 : 24;
    static const char *const law_text[2][2] = {{"1", "0"}, {"3/2", "1/4"}};
    for (int i = 0; i < 2; i++) {
        struct law law;
        LOCAL(arb, scale);
        LOCAL(arb_poly, want, got);
        slong root;
        assert_null(law_parse(&law, law_text[i][0], law_text[i][1]));
        arb_set_si(scale, i == 0 ? 4 : 5);
        arb_rsqrt(scale, scale, 2 * PREC);
        assert_int_equal(series_eps(got, &root, END_ZERO_OVERLAP, order, &law, BITS), 0);
        dashpot(want, scale, 0, order + 1, 2 * PREC);
        assert_int_equal(root, 1);
        assert_poly_overlap(got, want, order, "zero overlap, coefficient");
        assert_int_equal(series_eps(got, &root, END_ZERO_FORCE, order, &law, BITS), 0);
        dashpot(want, scale, 2, order + 1, 2 * PREC);
        assert_int_equal(root, 1);
        assert_poly_overlap(got, want, order, "zero force, coefficient");
    }
}

/* Hunt-Crossley (a, a): beta - ln(1 + beta) = -beta eps - ln(1 - beta eps), any a, both ends one. */
static void test_hunt_crossley(void **state)
{
    (void)state;
    const slong order = points(24) > 24 ? 40 : 24;
    static const char *const exponent[2] = {"3/2", "1"};
    for (int i = 0; i < 2; i++) {
        struct law law;
        LOCAL(arb_poly, eps, v, sum);
        LOCAL(arb, c);
        slong root;
        assert_null(law_parse(&law, exponent[i], exponent[i]));
        assert_int_equal(series_eps(eps, &root, END_ZERO_FORCE, order, &law, BITS), 0);
        assert_int_equal(root, 1);
        /* The ends of the equation start at beta^2: order k + 1 of it decides coefficient k of eps. */
        arb_poly_shift_left(v, eps, 1);
        arb_poly_neg(v, v);
        arb_poly_log1p_series(sum, v, order + 2, 2 * PREC);
        arb_poly_sub(sum, v, sum, 2 * PREC);
        arb_poly_zero(v);
        arb_poly_set_coeff_si(v, 1, 1);
        arb_poly_sub(sum, sum, v, 2 * PREC);
        arb_poly_log1p_series(v, v, order + 2, 2 * PREC);
        arb_poly_add(sum, sum, v, 2 * PREC);
        for (slong k = 0; k <= order + 1; k++) {
            arb_poly_get_coeff_arb(c, sum, k);
            assert_true(arb_contains_zero(c));
            assert_true(mag_cmp_2exp_si(arb_radref(c), -100) < 0);
        }
    }
}

/* G and T of docs/derivation.md, 5, and the series in sqrt(beta). */
static void test_zero_force(void **state)
{
    (void)state;
    static const char *const g_text[] = {"1", "4/15", "13/150", "4897/160875"};
    static const char *const t_text[] = {"1", "4/35", "2/75"};
    LOCAL(fmpq_poly, G, T);
    LOCAL(fmpq, want, got);
    restitution_zero_force_exact(G, T, 6, &law_sphere);
    for (slong k = 0; k < 4; k++) {
        fmpq_set_str(want, g_text[k], 10);
        fmpq_poly_get_coeff_fmpq(got, G, k);
        assert_true(fmpq_equal(want, got));
    }
    for (slong k = 0; k < 3; k++) {
        fmpq_set_str(want, t_text[k], 10);
        fmpq_poly_get_coeff_fmpq(got, T, k);
        assert_true(fmpq_equal(want, got));
    }
    static const char *const known[] = {"1",
                                        "0",
                                        "-1.15344885810",
                                        "0",
                                        "0.79826656094",
                                        "0.266666666666",
                                        "-0.52288256809",
                                        "-0.46137954324",
                                        "0.34874267526",
                                        "0.45235105120"};
    LOCAL(arb_poly, eps);
    LOCAL(arb, x, y);
    slong root;
    assert_int_equal(series_eps(eps, &root, END_ZERO_FORCE, 9, &law_sphere, BITS), 0);
    assert_int_equal(root, 2);
    for (slong k = 0; k < 10; k++) {
        arb_poly_get_coeff_arb(x, eps, k);
        arb_set_str(y, known[k], PREC);
        arb_sub(x, x, y, PREC);
        assert_true(mag_cmp_2exp_si(arb_radref(x), -100) < 0);
        arb_abs(x, x);
        arb_set_d(y, 1e-11);
        assert_true(arb_lt(x, y));
    }
}

/* y_k, tau_k and C_k, k = 0..order, by the t-series and the involution, and up to second_order by the ODE in power
 * series of beta: the balls overlap, and are narrow enough (bits; 20 bits for the second route) for that to mean
 * something. */
static void compare_routes(const struct law *law, slong order, slong second_order, slong bits, slong second_prec)
{
    struct series s;
    LOCAL(arb_poly, y, tau, c);
    LOCAL(arb, x);
    series_init(&s);
    assert_int_equal(series_compute(&s, order, law, bits), 0);
    assert_int_equal(collision_series(y, tau, c, second_order, law, second_prec), 0);
    assert_poly_overlap(s.y, y, second_order, "y_k");
    assert_poly_overlap(s.tau, tau, second_order, "tau_k");
    assert_poly_overlap(s.c, c, second_order, "C_k");
    for (slong k = 1; k <= order; k++) {
        arb_poly_get_coeff_arb(x, s.c, k);
        if (arb_is_zero(x))
            continue; /* exactly so, see test_vanishing_coefficient */
        assert_bits(x, bits);
        arb_poly_get_coeff_arb(x, c, k);
        if (k <= second_order)
            assert_bits(x, 20);
    }
    series_clear(&s);
}

static void test_two_routes(void **state)
{
    (void)state;
    leave_to_turn(2, 3);
    const slong order = points(32) > 32 ? 60 : (slong)few_or_all(16, 32); /* 60: half a minute */
    compare_routes(&law_sphere, order, order, 100, 260);
}

/* Other laws by both routes: nothing in them is special to the sphere. */
static void test_two_routes_other_law(void **state)
{
    (void)state;
    static const char *const law_text[][2] = {{"2", "1/3"}, {"5/4", "1"}, {"3/2", "0"}, {"4", "3"}};
    for (size_t i = 0; i < sizeof law_text / sizeof *law_text; i++) {
        if (!in_turn(i, 4))
            continue;
        struct law law;
        assert_null(law_parse(&law, law_text[i][0], law_text[i][1]));
        const slong order = (slong)few_or_all(8, 12);
        compare_routes(&law, order, order, 80, 200);
    }
}

/* The rows of the law (2, 1/2) grow fast with s. A bound of the truncation whose errors are the same in every column
 * proves nothing here. The second route to order 30 takes ten seconds, so an ordinary run takes it to order 8. */
static void test_two_routes_steep_rows(void **state)
{
    (void)state;
    struct law law;
    assert_null(law_parse(&law, "2", "1/2"));
    compare_routes(&law, 30, points(32) > 32 ? 30 : 8, 64, 260);
}

/* C_k = 0 exactly for even k = -2/q, q < 0; by the second route, which does not know it, zero to 100 bits. */
static void test_vanishing_coefficient(void **state)
{
    (void)state;
    static const struct {
        const char *a, *b;
        slong k;
    } cases[] = {{"3", "0", 4}, {"2", "0", 6}, {"3", "1/2", 8}, {"3/2", "0", 10}, {"2", "1/4", 12}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (!in_turn(i, 5))
            continue;
        struct law law;
        struct series s;
        LOCAL(arb_poly, y, tau, c);
        LOCAL(arb, x);
        series_init(&s);
        assert_null(law_parse(&law, cases[i].a, cases[i].b));
        const slong order = cases[i].k + 2;
        assert_int_equal(series_compute(&s, order, &law, 80), 0);
        assert_int_equal(collision_series(y, tau, c, order, &law, 300), 0);
        for (slong k = 1; k <= order; k++) {
            arb_poly_get_coeff_arb(x, s.c, k);
            assert_true(arb_is_zero(x) == (k == cases[i].k));
            arb_poly_get_coeff_arb(x, c, k);
            assert_true(arb_contains_zero(x) == (k == cases[i].k));
            assert_true(mag_cmp_2exp_si(arb_radref(x), -100) < 0);
        }
        series_clear(&s);
    }
}

/* -1/q = 3/2 is no whole number: no coefficient vanishes. The value: docs/derivation.md, 9. */
static void test_no_vanishing_coefficient(void **state)
{
    (void)state;
    struct law law;
    struct series s;
    LOCAL(arb, x);
    series_init(&s);
    assert_null(law_parse(&law, "5", "0"));
    assert_int_equal(series_compute(&s, 12, &law, 80), 0);
    for (slong k = 0; k <= 12; k++) {
        arb_poly_get_coeff_arb(x, s.c, k);
        assert_false(arb_contains_zero(x));
    }
    arb_poly_get_coeff_arb(x, s.c, 3);
    assert_truncates_to(x, "0.0237", 4);
    series_clear(&s);
}

/* |C_(k+1)/C_k| -> 1/h*. */
static void test_radius(void **state)
{
    (void)state;
    struct series s;
    LOCAL(arb, x, y);
    series_init(&s);
    assert_int_equal(series_compute(&s, 60, &law_sphere, 80), 0);
    assert_int_equal(collision_h_star(y, 80), 0);
    arb_poly_get_coeff_arb(x, s.c, 60);
    LOCAL(arb, z);
    arb_poly_get_coeff_arb(z, s.c, 59);
    arb_div(x, z, x, PREC);
    arb_div(x, x, y, PREC);
    arb_add_si(x, x, 1, PREC);
    arb_abs(x, x);
    arb_set_d(y, 0.05);
    assert_true(arb_lt(x, y));
    series_clear(&s);
}

/* Too few bits or terms for what is promised are refused; a ball holds the truth in any case. */
static void test_verdicts(void **state)
{
    (void)state;
    enum { ORDER = 12 };
    static const struct {
        slong terms, bits, prec;
    } tried[] = {{30, 100, 64}, {60, 100, 90}, {60, 100, 128}, {90, 100, 200}, {10, 60, 400}};
    struct series s;
    arb_poly_t y, tau;
    arb_t x;
    series_init(&s);
    arb_poly_init(y);
    arb_poly_init(tau);
    arb_init(x);
    assert_int_equal(series_compute(&s, ORDER, &law_sphere, 200), 0);
    for (size_t i = 0; i < sizeof tried / sizeof *tried; i++) {
        const enum turning_point_verdict verdict =
            turning_point_series(y, tau, ORDER, tried[i].terms, &law_sphere, tried[i].bits, tried[i].prec);
        assert_poly_overlap(y, s.y, ORDER, "y_k");
        assert_poly_overlap(tau, s.tau, ORDER, "tau_k");
        for (slong k = 0; k <= ORDER && verdict == TURNING_POINT_OK; k++) {
            arb_poly_get_coeff_arb(x, y, k);
            assert_bits(x, tried[i].bits);
        }
    }
    series_clear(&s);
    arb_poly_clear(y);
    arb_poly_clear(tau);
    arb_clear(x);
}

/* Peaks of memory in docs/speed/generator.csv, less the 7.5 MB of a program that computes little */
static void test_memory(void **state)
{
    (void)state;
    static const struct {
        slong order, digits;
        double megabytes;
    } peak[] = {{100, 40, 26.1}, {140, 40, 70.2}, {200, 100, 172.7}, {40, 320, 93.9}};
    for (size_t i = 0; i < sizeof peak / sizeof *peak; i++) {
        const double bytes = series_bytes(peak[i].order, &law_sphere, (slong)((double)peak[i].digits * 3.3219) + 8);
        assert_true(bytes > 0.8e6 * peak[i].megabytes && bytes < 1e6 * peak[i].megabytes);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_closed_forms),
        cmocka_unit_test(test_linear_laws),
        cmocka_unit_test(test_hunt_crossley),
        cmocka_unit_test(test_zero_force),
        cmocka_unit_test(test_two_routes),
        cmocka_unit_test(test_two_routes_other_law),
        cmocka_unit_test(test_two_routes_steep_rows),
        cmocka_unit_test(test_vanishing_coefficient),
        cmocka_unit_test(test_no_vanishing_coefficient),
        cmocka_unit_test(test_radius),
        cmocka_unit_test(test_verdicts),
        cmocka_unit_test(test_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
