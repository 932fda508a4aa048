/* SPDX-License-Identifier: MIT */
/* The interpolant of the collision against collisions at places of its own, and what it is made of: collisions without
 * their unloading, and one that once found no end. */
#include "ball.h"

#include <unistd.h>

#include "approximation/chebyshev.h"
#include "approximation/interpolant.h"
#include "enclosure/collision.h"
#include "random.h"
#include "support/local.h"

static const slong PREC = 320;

static struct random_state random_state = {19990101};

static arb_srcptr field(const struct collision *c, enum quantity quantity)
{
    const arb_srcptr fields[QUANTITIES] = {c->eps_zero_overlap, c->eps_zero_force, c->t_zero_overlap,
                                           c->t_zero_force,     c->x_max,          c->t_max};
    return fields[quantity];
}

/* |x/y - 1| */
static double relative(const arb_t x, const arb_t y)
{
    LOCAL(arb, d);
    LOCAL(arf, bound);
    LET(d, PREC, "x/y - 1", x, y);
    arb_get_abs_ubound_arf(bound, d, 30);
    return arf_get_d(bound, ARF_RND_UP);
}

/* Both functions enclose the same numbers, whichever way the first of them went. */
TEST(test_loading_alone)
{
    static const double betas[] = {1e-20, 0.01, 0.5, 1, 1.0000001, 3, 7, 12, 40, 1000, 1e6};
    LOCAL(collision, whole, loading);
    LOCAL(arb, beta);
    for (size_t i = 0; i < sizeof betas / sizeof *betas; i++) {
        arb_set_d(beta, betas[i]);
        assert_int_equal(collision_solve(whole, beta, &law_sphere, 60), 0);
        assert_int_equal(collision_solve_force(loading, beta, &law_sphere, 100), 0);
        const enum quantity quantities[] = {EPS_ZERO_FORCE, DURATION_ZERO_FORCE, MAX_OVERLAP, TIME_OF_MAX_OVERLAP};
        for (size_t k = 0; k < sizeof quantities / sizeof *quantities; k++) {
            assert_bits(field(loading, quantities[k]), 100);
            assert_overlap(field(whole, quantities[k]), field(loading, quantities[k]), "loading alone, beta", (slong)i);
        }
        /* unknown, unless the last step reached that far */
        assert_overlap(whole->eps_zero_overlap, loading->eps_zero_overlap, "the end, beta", (slong)i);
        assert_true(betas[i] < 0.1 || !arb_is_finite(loading->t_zero_overlap));
    }
    /* beta = 0 has no force to vanish; neither have laws with a <= b */
    arb_zero(beta);
    assert_int_equal(collision_solve_force(loading, beta, &law_sphere, 60), 1);
    arb_set_si(beta, -1);
    assert_int_equal(collision_solve_force(loading, beta, &law_sphere, 60), 1);
    arb_indeterminate(beta);
    assert_int_equal(collision_solve_force(loading, beta, &law_sphere, 60), 1);
}

/* Between the methods: too early for the slow manifold at so many bits. It was tried for ever. The alarm ends the
 * test, and the answer is that of the loading and of h*^5 beta^-5. */
TEST(test_between_methods)
{
    LOCAL(collision, c, loading);
    LOCAL(arb, beta, h);
    alarm(120);
    for (int k = 0; k < 2; k++) {
        arb_set_d(beta, k == 0 ? 13.155 : 12.5);
        assert_int_equal(collision_solve(c, beta, &law_sphere, 114), 0);
        assert_bits(c->eps_zero_overlap, 114);
        assert_bits(c->t_zero_overlap, 114);
        assert_int_equal(collision_solve_force(loading, beta, &law_sphere, 114), 0);
        assert_overlap(c->eps_zero_force, loading->eps_zero_force, "eps at zero force", k);
        assert_int_equal(collision_h_star(h, 114), 0);
        LET(h, PREC, "(h/beta)^5", h, beta);
        assert_true(relative(c->eps_zero_overlap, h) < 0x1p-112);
    }
    alarm(0);
}

TEST(test_points)
{
    for (slong n = 1; n < 60; n += 7)
        for (slong j = 0; j < n; j++) {
            const double x = chebyshev_point(j, n);
            assert_true(x > -1 && x < 1 && fabs(x + chebyshev_point(n - 1 - j, n)) < 1e-15);
            assert_true(fabs(cos((double)n * acos(x))) < 1e-13);
            assert_true(j == 0 || x > chebyshev_point(j - 1, n));
        }
}

/* Up to beta = 3/8, where the loss has a quotient of its own. */
TEST(test_small_beta)
{
    struct interpolant *f = interpolant_new(&interpolant_sphere_proof, 0, 0.375);
    LOCAL(collision, c);
    LOCAL(arb, z, beta, y, exact);
    double worst = 0, error;
    assert_non_null(f);
    for (int k = 0; k < (int)few_or_all(20, 60); k++) {
        arb_set_d(z, k == 0 ? 0x1p-10 : k == 1 ? 0.612 : random_uniform(&random_state, 0, 0.612));
        arb_sqr(beta, z, PREC);
        assert_int_equal(collision_solve(c, beta, &law_sphere, 110), 0);
        for (int q = 0; q < QUANTITIES; q++) {
            interpolant_value(y, f, (enum quantity)q, z, PREC);
            worst = fmax(worst, relative(y, field(c, (enum quantity)q)));
            if (q != EPS_ZERO_OVERLAP && q != EPS_ZERO_FORCE)
                continue;
            const arb_srcptr eps = field(c, (enum quantity)q);
            LET(exact, PREC, "(1 - eps)/beta", eps, beta);
            interpolant_value(y, f, q == EPS_ZERO_FORCE ? LOSS_QUOTIENT_ZERO_FORCE : LOSS_QUOTIENT_ZERO_OVERLAP, z,
                              PREC);
            worst = fmax(worst, relative(y, exact));
        }
    }
    print_message("beta < 3/8: %.1e\n", worst);
    assert_true(worst < 1e-18);
    assert_int_equal(interpolant_check(&error, f, 3), 0);
    assert_true(error < 1e-17);
    interpolant_free(f);
}

/* Strong damping: sqrt(beta) up to 17, then ln(beta) with the powers taken out. */
TEST(test_large_beta)
{
    if (!few_or_all(0, 1)) /* building takes 10 s; accuracy.functions tests what is made of it */
        skip();
    struct interpolant *f = interpolant_new(&interpolant_sphere_proof, 8.5, 9);
    LOCAL(collision, c);
    LOCAL(arb, x, beta, y);
    double worst[2] = {0};
    assert_non_null(f);
    for (int k = 0; k < 40; k++) {
        const bool tail = k >= 20;
        if (tail) {
            arb_set_d(beta, exp(random_uniform(&random_state, 2.1, 10)));
            arb_log(x, beta, PREC);
        } else {
            arb_set_d(x, random_uniform(&random_state, 2.875, 4.125));
            arb_sqr(beta, x, PREC);
        }
        const bool whole = tail && k % 8 == 0; /* these cost the most */
        assert_int_equal(
            whole ? collision_solve(c, beta, &law_sphere, 80) : collision_solve_force(c, beta, &law_sphere, 80), 0);
        for (int q = 0; q < QUANTITIES; q++) {
            const enum quantity quantity = (enum quantity)q;
            if (quantity == EPS_ZERO_OVERLAP || (quantity == DURATION_ZERO_OVERLAP && !whole))
                continue;
            if (tail) {
                interpolant_tail(y, f, quantity, x, PREC);
                const struct ratio power = interpolant_tail_power(&law_sphere, quantity);
                LET(y, PREC, "y*beta^power", y, beta, power);
            } else {
                interpolant_value(y, f, quantity, x, PREC);
            }
            worst[tail] = fmax(worst[tail], relative(y, field(c, quantity)));
        }
    }
    print_message("beta > 8: %.1e, in ln(beta) %.1e\n", worst[0], worst[1]);
    assert_true(worst[0] < 1e-18 && worst[1] < 1e-17);
    interpolant_free(f);
}

RUN_TESTS(test_loading_alone, test_between_methods, test_points, test_small_beta, test_large_beta)
