/* SPDX-License-Identifier: MIT */
/* One enclosed collision: reference values, closed forms, identities, and two methods on one beta. */
#include "ball.h"
#include "check.h"

#include <math.h>

#include "enclosure/collision.h"
#include "series/restitution.h"
#include "series/series.h"
#include "series/turning_point.h"
#include "support/local.h"

static const slong PREC = 400;

static void collision_of(struct collision *c, const char *beta, const char *a, const char *b, slong bits)
{
    struct law law;
    LOCAL(arb, x);
    assert_null(law_parse(&law, a, b));
    assert_int_equal(arb_set_str(x, beta, 4 * bits + 400), 0);
    assert_int_equal(collision_solve(c, x, &law, bits), 0);
}

/* Values made by other programs; eps_zero_force(10) to the digits on which two of them agree. */
static void test_reference_values(void **state)
{
    (void)state;
    static const struct {
        const char *beta, *overlap, *force;
        int overlap_decimals, force_decimals;
    } known[] = {
        {"0.1", "0.892147587290229345", NULL, 18, 0},
        {"0.5", "0.573824628664948983", "0.595251501135126961", 18, 18},
        {"1", "0.331164810466640935", "0.393930603229873193", 18, 18},
        {"2", "0.095330365354151543", "0.211646054603642811", 18, 18},
        {"5", "0.001650682071773317", NULL, 18, 0},
        {"10", NULL, "0.02509570443151839", 0, 17},
    };
    struct collision c;
    collision_init(&c);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        collision_of(&c, known[i].beta, "3/2", "1/2", 100);
        assert_bits(c.eps_zero_overlap, 100);
        assert_bits(c.eps_zero_force, 100);
        if (known[i].overlap)
            assert_truncates_to(c.eps_zero_overlap, known[i].overlap, known[i].overlap_decimals);
        if (known[i].force)
            assert_truncates_to(c.eps_zero_force, known[i].force, known[i].force_decimals);
    }
    collision_clear(&c);
}

/* Inside the radius of convergence the series and the collision are the same function. */
static void test_series(void **state)
{
    (void)state;
    const slong ORDER = 60;
    static const char *const betas[] = {"1/64", "1/8", "0.4", "0.5"};
    struct series s;
    struct collision c;
    LOCAL(arb_poly, force);
    LOCAL(arb, x, y, z);
    slong root;
    series_init(&s);
    collision_init(&c);
    assert_int_equal(series_compute(&s, ORDER, &law_sphere, 120), 0);
    assert_int_equal(series_eps(force, &root, END_ZERO_FORCE, 2 * ORDER, &law_sphere, 120), 0);
    for (size_t i = 0; i < sizeof betas / sizeof *betas; i++) {
        LOCAL(fmpq, beta);
        if (fmpq_set_str(beta, betas[i], 10) != 0)
            fmpq_set_si(beta, betas[i][2] - '0', 10);
        arb_set_fmpq(x, beta, PREC);
        assert_int_equal(collision_solve(&c, x, &law_sphere, 120), 0);
        /* Terms fall like (beta/1.388)^k, at zero force somewhat slower: their sum is well below
         * (beta/0.75)^60. */
        arb_set_d(y, 0.75);
        arb_div(z, x, y, PREC);
        arb_pow_ui(z, z, (ulong)ORDER, PREC);
        arb_poly_evaluate(y, s.y, x, PREC);
        arb_add_error(y, z);
        assert_overlap(y, c.x_max, "x_max at beta", (slong)i);
        arb_poly_evaluate(y, s.tau, x, PREC);
        arb_add_error(y, z);
        assert_overlap(y, c.t_max, "t_max at beta", (slong)i);
        arb_poly_evaluate(y, s.c, x, PREC);
        arb_add_error(y, z);
        assert_overlap(y, c.eps_zero_overlap, "zero overlap at beta", (slong)i);
        arb_sqrt(x, x, PREC);
        arb_poly_evaluate(y, force, x, PREC);
        arb_add_error(y, z);
        assert_overlap(y, c.eps_zero_force, "zero force at beta", (slong)i);
    }
    series_clear(&s);
    collision_clear(&c);
}

/* (1, 0), zeta = beta/2, at both ends: eps = exp(-z (pi - 2 both asin zeta)), z = zeta/sqrt(1 - zeta^2). */
static void dashpot(arb_t eps, arb_t time, const arb_t zeta, int both)
{
    LOCAL(arb, w, angle);
    arb_mul(w, zeta, zeta, PREC);
    arb_sub_si(w, w, 1, PREC);
    arb_neg(w, w);
    arb_sqrt(w, w, PREC);
    arb_asin(angle, zeta, PREC);
    arb_mul_si(angle, angle, -2L * both, PREC);
    arb_const_pi(time, PREC);
    arb_add(angle, angle, time, PREC);
    arb_div(time, angle, w, PREC);
    arb_mul(eps, time, zeta, PREC);
    arb_neg(eps, eps);
    arb_exp(eps, eps, PREC);
}

static void test_closed_forms(void **state)
{
    (void)state;
    static const char *const betas[] = {"0.01", "0.5", "1", "1.5", "1.9"};
    struct collision c;
    LOCAL(arb, zeta, eps, time, x);
    collision_init(&c);
    for (size_t i = 0; i < sizeof betas / sizeof *betas; i++) {
        collision_of(&c, betas[i], "1", "0", 150);
        arb_set_str(zeta, betas[i], PREC);
        arb_mul_2exp_si(zeta, zeta, -1);
        for (int both = 0; both <= 1; both++) {
            dashpot(eps, time, zeta, both);
            assert_overlap(eps, both ? c.eps_zero_force : c.eps_zero_overlap, "dashpot eps", (slong)i);
            assert_overlap(time, both ? c.t_zero_force : c.t_zero_overlap, "dashpot time", (slong)i);
        }
        /* Tsuji: the same function with zeta = beta/sqrt(5); times differ. */
        collision_of(&c, betas[i], "3/2", "1/4", 150);
        arb_mul_2exp_si(zeta, zeta, 1);
        arb_set_si(x, 5);
        arb_sqrt(x, x, PREC);
        arb_div(zeta, zeta, x, PREC);
        for (int both = 0; both <= 1; both++) {
            dashpot(eps, time, zeta, both);
            assert_overlap(eps, both ? c.eps_zero_force : c.eps_zero_overlap, "Tsuji eps", (slong)i);
        }
        /* Hunt-Crossley, a = 3/2 and 2: beta - ln(1+beta) + beta eps + ln(1 - beta eps) = 0. */
        for (int two = 0; two <= 1; two++) {
            collision_of(&c, betas[i], two ? "2" : "3/2", two ? "2" : "3/2", 150);
            arb_set_str(zeta, betas[i], PREC);
            arb_mul(x, zeta, c.eps_zero_overlap, PREC);
            arb_neg(eps, x);
            arb_log1p(eps, eps, PREC);
            arb_add(eps, eps, x, PREC);
            arb_add(eps, eps, zeta, PREC);
            arb_log1p(x, zeta, PREC);
            arb_sub(eps, eps, x, PREC);
            assert_true(arb_contains_zero(eps));
            assert_true(mag_cmp_2exp_si(arb_radref(eps), -120) < 0);
            assert_true(arb_equal(c.eps_zero_force, c.eps_zero_overlap));
        }
    }
    collision_clear(&c);
}

/* Laws whose bodies never part: eps exactly 0 after infinite time, the zero-force end finite. */
static void test_overdamped(void **state)
{
    (void)state;
    static const char *const cases[][3] = {{"3", "1", "0"}, {"2", "1", "0"}, {"2.5", "3/2", "1/4"}, {"30", "3/2", "0"}};
    struct collision c;
    collision_init(&c);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        collision_of(&c, cases[i][0], cases[i][1], cases[i][2], 80);
        assert_true(arb_is_zero(c.eps_zero_overlap));
        assert_false(arb_is_finite(c.t_zero_overlap));
        assert_true(arb_is_positive(c.eps_zero_force));
        assert_bits(c.t_zero_force, 80);
    }
    /* Critical damping, beta = 2: x = t exp(-t), force zero at t = 2 with speed exp(-2). */
    LOCAL(arb, x);
    collision_of(&c, "2", "1", "0", 80);
    arb_set_si(x, -2);
    arb_exp(x, x, PREC);
    assert_overlap(x, c.eps_zero_force, "critical eps", 0);
    arb_set_si(x, 2);
    assert_overlap(x, c.t_zero_force, "critical time", 0);
    collision_clear(&c);
}

/* Integration to the end and the slow manifold are different methods; at beta = 12 the first serves 330 bits
 * and the second 30. */
static void test_slow_manifold(void **state)
{
    (void)state;
    leave_to_turn(0, 3);
    static const char *const betas[] = {"12", "17.5"};
    struct collision direct, slow;
    LOCAL(arb, h, x);
    collision_init(&direct);
    collision_init(&slow);
    for (size_t i = 0; i < sizeof betas / sizeof *betas; i++) {
        collision_of(&slow, betas[i], "3/2", "1/2", 30);
        collision_of(&direct, betas[i], "3/2", "1/2", 330);
        assert_overlap(direct.eps_zero_overlap, slow.eps_zero_overlap, "eps", (slong)i);
        assert_overlap(direct.t_zero_overlap, slow.t_zero_overlap, "time", (slong)i);
        assert_overlap(direct.eps_zero_force, slow.eps_zero_force, "eps at zero force", (slong)i);
    }
    /* h*, and beta^5 eps -> h*^5 from below, closer than 100 exp(-beta^(5/3)). */
    assert_int_equal(collision_h_star(h, 150), 0);
    assert_bits(h, 150);
    assert_truncates_to(h, "1.388361925615829410", 18);
    arb_pow_ui(h, h, 5, PREC);
    assert_truncates_to(h, "5.158381704267685216", 18);
    for (int beta = 2; beta <= 6; beta += 2) {
        char text[8];
        snprintf(text, sizeof text, "%d", beta);
        collision_of(&direct, text, "3/2", "1/2", 150);
        arb_set_si(x, beta);
        arb_pow_ui(x, x, 5, PREC);
        arb_mul(x, x, direct.eps_zero_overlap, PREC);
        arb_sub(x, h, x, PREC);
        assert_true(arb_is_positive(x));
        LOCAL(arb, bound, power);
        arb_set_si(power, -1);
        arb_set_si(bound, beta);
        arb_pow_ratio(bound, bound, (struct ratio){5, 3}, PREC);
        arb_mul(bound, bound, power, PREC);
        arb_exp(bound, bound, PREC);
        arb_mul_si(bound, bound, 100, PREC);
        assert_true(arb_lt(x, bound));
    }
    collision_clear(&direct);
    collision_clear(&slow);
}

/* eps_zero_force ~ (3/2)^(2/3) beta^(-5/3), and the duration grows like (10/3) beta ln beta. */
static void test_strong_damping(void **state)
{
    (void)state;
    struct collision c[3];
    double t[3], e[3];
    static const char *const betas[3] = {"1e4", "1e5", "1e6"};
    for (int i = 0; i < 3; i++) {
        const double beta = strtod(betas[i], NULL);
        collision_init(&c[i]);
        collision_of(&c[i], betas[i], "3/2", "1/2", 60);
        t[i] = arf_get_d(arb_midref(c[i].t_zero_overlap), ARF_RND_NEAR) / beta - 10.0 / 3.0 * log(beta);
        e[i] = arf_get_d(arb_midref(c[i].eps_zero_force), ARF_RND_NEAR) * pow(beta, 5.0 / 3.0) / pow(1.5, 2.0 / 3.0);
        collision_clear(&c[i]);
    }
    assert_true(fabs(t[1] - t[0]) < 1e-4 && fabs(t[2] - t[1]) < 1e-5);
    assert_true(fabs(e[0] - 1) < 1e-5 && fabs(e[2] - 1) < 1e-8);
}

/* The involution: h^4 Y(-h) = beta^4 x_max, T = t_max + eps^(-1/5) t_max(-h), h = beta eps^(1/5) < h*. */
static void test_involution(void **state)
{
    (void)state;
    enum { ORDER = 80 };
    struct series s;
    struct collision c;
    LOCAL(arb, h, x, y, z);
    series_init(&s);
    collision_init(&c);
    assert_int_equal(series_compute(&s, ORDER, &law_sphere, 100), 0);
    collision_of(&c, "0.5", "3/2", "1/2", 100);
    arb_root_ui(z, c.eps_zero_overlap, 5, PREC);
    arb_mul_2exp_si(h, z, -1);
    arb_neg(h, h);
    arb_poly_evaluate(x, s.y, h, PREC);
    arb_add_error_2exp_si(x, -100);
    arb_pow_ui(y, z, 4, PREC);
    arb_mul(x, x, y, PREC);
    assert_overlap(x, c.x_max, "x_max", 0);
    arb_poly_evaluate(x, s.tau, h, PREC);
    arb_add_error_2exp_si(x, -100);
    arb_div(x, x, z, PREC);
    arb_add(x, x, c.t_max, PREC);
    assert_overlap(x, c.t_zero_overlap, "duration", 0);
    series_clear(&s);
    collision_clear(&c);
}

/* eps_zero_force = eps_zero_overlap G(w), t_zero_force = t_zero_overlap - eps^(-1/5) h T(w), w = h^(5/2). */
static void test_backward_series(void **state)
{
    (void)state;
    enum { ORDER = 24 };
    static const char *const betas[] = {"1e-12", "0.02", "0.1"};
    LOCAL(fmpq_poly, G, T);
    LOCAL(arb_poly, f);
    struct collision c;
    LOCAL(arb, w, x, beta);
    collision_init(&c);
    restitution_zero_force_exact(G, T, ORDER, &law_sphere);
    for (size_t i = 0; i < sizeof betas / sizeof *betas; i++) {
        collision_of(&c, betas[i], "3/2", "1/2", 90);
        arb_set_str(beta, betas[i], PREC);
        arb_pow_ratio(w, beta, (struct ratio){5, 2}, PREC);
        arb_sqrt(x, c.eps_zero_overlap, PREC);
        arb_mul(w, w, x, PREC);
        arb_poly_set_fmpq_poly(f, G, PREC);
        arb_poly_evaluate(x, f, w, PREC);
        arb_add_error_2exp_si(x, -80);
        arb_mul(x, x, c.eps_zero_overlap, PREC);
        assert_overlap(x, c.eps_zero_force, "eps", (slong)i);
        arb_poly_set_fmpq_poly(f, T, PREC);
        arb_poly_evaluate(x, f, w, PREC);
        arb_add_error_2exp_si(x, -80);
        arb_mul(x, x, beta, PREC); /* eps^(-1/5) h = beta */
        arb_sub(x, c.t_zero_overlap, x, PREC);
        assert_overlap(x, c.t_zero_force, "time", (slong)i);
    }
    collision_clear(&c);
}

static void test_edges(void **state)
{
    (void)state;
    struct collision c;
    LOCAL(arb, x, y0, t0);
    collision_init(&c);
    turning_point_elastic(y0, t0, &law_sphere, PREC);
    collision_of(&c, "0", "3/2", "1/2", 200);
    assert_true(arb_is_one(c.eps_zero_overlap) && arb_is_one(c.eps_zero_force));
    assert_overlap(c.x_max, y0, "x_max", 0);
    arb_mul_2exp_si(t0, t0, 1);
    assert_overlap(c.t_zero_overlap, t0, "duration", 0);
    assert_overlap(c.t_zero_force, t0, "duration", 1);
    /* 1 - eps = |C_1| beta however small beta is, given the digits. */
    collision_of(&c, "1e-30", "3/2", "1/2", 200);
    arb_sub_si(x, c.eps_zero_overlap, 1, PREC);
    arb_set_str(y0, "1e30", PREC);
    arb_mul(x, x, y0, PREC);
    arb_add_error_2exp_si(x, -90);
    struct series s;
    series_init(&s);
    assert_int_equal(series_compute(&s, 1, &law_sphere, 100), 0);
    arb_poly_get_coeff_arb(y0, s.c, 1);
    assert_overlap(x, y0, "1 - eps", 0);
    series_clear(&s);
    /* Next to beta = 1, where the scales change. */
    for (int side = -1; side <= 1; side++) {
        arb_set_si(x, side);
        arb_mul_2exp_si(x, x, -60);
        arb_add_si(x, x, 1, PREC);
        assert_int_equal(collision_solve(&c, x, &law_sphere, 100), 0);
        arb_add_error_2exp_si(c.eps_zero_overlap, -58);
        assert_truncates_to(c.eps_zero_overlap, "0.3311648104666409", 16);
    }
    collision_clear(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reference_values),
        cmocka_unit_test(test_series),
        cmocka_unit_test(test_closed_forms),
        cmocka_unit_test(test_overdamped),
        cmocka_unit_test(test_slow_manifold),
        cmocka_unit_test(test_strong_damping),
        cmocka_unit_test(test_involution),
        cmocka_unit_test(test_backward_series),
        cmocka_unit_test(test_edges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
