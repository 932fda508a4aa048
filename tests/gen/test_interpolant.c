/* SPDX-License-Identifier: MIT */
/* Tests the interpolant of the collision against collisions at places that are not samples. */
#include "ball.h"

#include "approximation/interpolant.h"
#include "enclosure/collision.h"
#include "random.h"
#include "support/local.h"

static const slong PREC = 320;

static struct random_state random_state = {19990101};

/* Returns |x/y - 1|. */
static double relative(const arb_t x, const arb_t y)
{
    LOCAL(arb, d);
    LOCAL(arf, bound);
    LET(d, PREC, "x/y - 1", x, y);
    arb_get_abs_ubound_arf(bound, d, 30);
    return arf_get_d(bound, ARF_RND_UP);
}

/* For beta from 0 to 3/8 the interpolant also contains the loss divided by beta. */
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
            interpolant_at(y, f, (enum quantity)q, INTERVAL_ROOT, z, PREC);
            worst = fmax(worst, relative(y, c->field[q]));
            if (q != EPS_ZERO_OVERLAP && q != EPS_ZERO_FORCE)
                continue;
            const arb_srcptr eps = c->field[q];
            LET(exact, PREC, "(1 - eps)/beta", eps, beta);
            interpolant_at(y, f, q == EPS_ZERO_FORCE ? LOSS_QUOTIENT_ZERO_FORCE : LOSS_QUOTIENT_ZERO_OVERLAP,
                           INTERVAL_ROOT, z, PREC);
            worst = fmax(worst, relative(y, exact));
        }
    }
    assert_true(worst < 1e-18);
    for (int side = -1; side <= 1; side += 2) { /* the values of an interval contain the values at its ends */
        arb_set_d(z, 0.4);
        arb_add_error_2exp_si(z, -20);
        interpolant_at(exact, f, MAX_OVERLAP, INTERVAL_ROOT, z, PREC);
        arb_set_d(z, 0.4 + side * 0x1p-20);
        interpolant_at(y, f, MAX_OVERLAP, INTERVAL_ROOT, z, PREC);
        assert_true(arb_contains(exact, y));
    }
    assert_int_equal(interpolant_check(&error, f, 3), 0);
    assert_true(error < 1e-17);
    interpolant_free(f);
}

/* Five Chebyshev points interpolate worst at the ends of an interval. The check must find these errors. */
TEST(test_check_at_ends)
{
    static const struct interval coarse = {INTERVAL_ROOT, 0.5, 1, 5, 100, FORM_VALUE, 1 << MAX_OVERLAP};
    const struct interpolant_layout layout = {.law = {3, 1, 2}, .root = 2, .interval = &coarse, .intervals = 1};
    struct interpolant *f = interpolant_new(&layout, 0.25, 1);
    LOCAL(collision, c);
    LOCAL(arb, one, y);
    double error;
    assert_non_null(f);
    arb_one(one);
    assert_int_equal(collision_solve(c, one, &law_sphere, 110), 0);
    interpolant_at(y, f, MAX_OVERLAP, INTERVAL_ROOT, one, PREC);
    assert_int_equal(interpolant_check(&error, f, 3), 0);
    check(error >= 0.99 * relative(y, c->x_max) && error < 1e-3, "%g, at beta = 1: %g", error, relative(y, c->x_max));
    interpolant_free(f);
}
