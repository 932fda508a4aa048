/* SPDX-License-Identifier: MIT */
/* hertz_dashpot.h against enclosed collisions. */
#include "law_check.h"

#include "../accuracy/ball_value.h"
#include "../unit/check.h"
#include "cor/hertz_dashpot.h"
#include "enclosure/collision.h"
#include "support/formula.h"
#include "support/local.h"

static const struct law_functions functions = LAW_FUNCTIONS(
    "hertz_dashpot", "3/2", "0", cor_hertz_dashpot, COR_HERTZ_DASHPOT_EPS_MAX_ULP, COR_HERTZ_DASHPOT_TIME_MAX_ULP);

TEST(test_bounds)
{
    assert_true(COR_HERTZ_DASHPOT_LOSS_MAX_ULP == functions.one_ulp &&
                COR_HERTZ_DASHPOT_MAX_OVERLAP_MAX_ULP == functions.one_ulp &&
                COR_HERTZ_DASHPOT_BETA_MAX_ULP == functions.two_ulp);
}

TEST(test_special)
{
    law_check_special(&functions);
    assert_true(cor_hertz_dashpot_beta_zero_overlap(0) == COR_HERTZ_DASHPOT_BETA_C);
}

TEST(test_random)
{
    law_check_random(&functions, points(16));
}

TEST(test_borders)
{
    law_check_borders(&functions, points(4));
}

enum { APPROACH_BITS = 160 };

/* eps and the duration with damping while approaching only, by an enclosed largest overlap */
static void approach(arb_t eps, arb_t duration, double beta)
{
    struct law law;
    LOCAL(collision, c, elastic);
    LOCAL(arb, x);
    assert_null(law_parse(&law, "3/2", "0"));
    arb_set_d(x, beta);
    assert_int_equal(collision_solve_force(c, x, &law, APPROACH_BITS), 0);
    arb_zero(x);
    assert_int_equal(collision_solve(elastic, x, &law, APPROACH_BITS), 0);
    LET(eps, APPROACH_BITS, "sqrt(4/5)*c->x_max^(5/4)", c->x_max);
    LET(duration, APPROACH_BITS, "c->t_max + elastic->t_max*eps^(-1/5)", c->t_max, elastic->t_max, eps);
}

static double moved(double x, int ulp)
{
    for (; ulp > 0; ulp--)
        x = nextafter(x, INFINITY);
    for (; ulp < 0; ulp++)
        x = nextafter(x, 0);
    return x;
}

/* The beta of this eps lies within the bound of `beta`, for eps falls: eps as an exact number. */
static void check_approach_inverse(double beta, const arb_t eps, const char *what)
{
    LOCAL(arb, at, duration);
    approach(at, duration, moved(beta, -(int)COR_HERTZ_DASHPOT_APPROACH_MAX_ULP));
    check(arb_ge(at, eps), "%s: %.17g is too large", what, beta);
    approach(at, duration, moved(beta, (int)COR_HERTZ_DASHPOT_APPROACH_MAX_ULP));
    check(arb_le(at, eps), "%s: %.17g is too small", what, beta);
}

static void check_approach(double worst[3], double beta, bool inverse)
{
    LOCAL(arb, exact, exact_loss, duration, x);
    approach(exact, duration, beta);
    LET(exact_loss, APPROACH_BITS, "1 - exact", exact);
    const double eps = cor_hertz_dashpot_eps_approach_only(beta), loss = cor_hertz_dashpot_loss_approach_only(beta);
    const double error[] = {ulp_error(eps, ball_value(exact)), ulp_error(loss, ball_value(exact_loss)),
                            ulp_error(cor_hertz_dashpot_duration_approach_only(beta), ball_value(duration))};
    for (int k = 0; k < 3; k++) {
        check(error[k] <= COR_HERTZ_DASHPOT_APPROACH_MAX_ULP, "quantity %d at %.17g: %.3f ulp", k, beta, error[k]);
        worst[k] = fmax(worst[k], error[k]);
    }
    if (inverse) {
        LET(x, APPROACH_BITS, "1 - loss", loss);
        check_approach_inverse(cor_hertz_dashpot_beta_of_loss_approach_only(loss), x, "of loss");
        arb_set_d(x, eps);
        if (eps < 1)
            check_approach_inverse(cor_hertz_dashpot_beta_approach_only(eps), x, "of eps");
    }
}

/* Random beta, and the places where the series, the near rows, the octaves and the tail meet */
TEST(test_approach_only)
{
    static const double borders[] = {0.0625, 0.125, 8};
    struct random_state r = random_start();
    double worst[3] = {0};
    const size_t n = points(16);
    for (size_t i = 0; i < n; i++)
        check_approach(worst, i % 2 ? random_uniform(&r, 0, 3) : random_log(&r, 1e-12, 1e15), i % 4 < 2);
    for (int k = 4; k < 50; k++)
        check_approach(worst, ldexp(1, k), false);
    for (size_t i = 0; i < sizeof borders / sizeof *borders; i++)
        for (int ulp = -1; ulp <= 1; ulp += 2)
            check_approach(worst, moved(borders[i], ulp), false);
    print_message("approach only: eps %.3f, loss %.3f, duration %.3f ulp at the worst\n", worst[0], worst[1], worst[2]);
}

RUN_TESTS(test_bounds, test_special, test_random, test_borders, test_approach_only)
