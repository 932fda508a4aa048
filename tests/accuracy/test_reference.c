/* SPDX-License-Identifier: MIT */
/* The reference of the accuracy test against balls of collision_solve with 30 digits, at random beta. */
#include "check.h"

#include "enclosure/collision.h"
#include "reference.h"
#include "support/local.h"

/* Largest difference allowed, relative: 2^-61, that is 1/256 unit of the last place of a double. */
static const double MAX_DIFFERENCE = 0x1p-61;
enum { BITS = 100 };

static struct random_state state;

static double difference(enum quantity quantity, double beta, const arb_t exact)
{
    const long double value = reference_value(quantity, beta);
    LOCAL(arb, x);
    mpfr_t y;
    mpfr_init2(y, 64);
    mpfr_set_ld(y, value, MPFR_RNDN);
    arf_set_mpfr(arb_midref(x), y);
    arb_sub(x, x, exact, 2 * BITS);
    arb_div(x, x, exact, 2 * BITS);
    arb_abs(x, x);
    const double result = arf_get_d(arb_midref(x), ARF_RND_UP);
    mpfr_clear(y);
    return result;
}

/* Random beta between the limits, all quantities. */
static void compare(double low, double high, size_t count)
{
    double worst = 0, at = 0;
    LOCAL(collision, c);
    LOCAL(arb, beta, loss);
    for (size_t i = 0; i < count; i++) {
        const double b = random_log(&state, low, high);
        arb_set_d(beta, b);
        /* 1 - eps loses what beta is small by; with more bits the collision is integrated to its end up to beta = 16 */
        const slong bits = b < 1 ? BITS - (slong)logb(b) : b > 8 && b < 16 ? 2 * BITS : BITS;
        assert_int_equal(collision_solve(c, beta, &law_sphere, bits), 0);
        const arb_srcptr exact[QUANTITIES] = {
            [EPS_ZERO_OVERLAP] = c->eps_zero_overlap,
            [EPS_ZERO_FORCE] = c->eps_zero_force,
            [DURATION_ZERO_OVERLAP] = c->t_zero_overlap,
            [DURATION_ZERO_FORCE] = c->t_zero_force,
            [MAX_OVERLAP] = c->x_max,
            [TIME_OF_MAX_OVERLAP] = c->t_max,
        };
        for (int q = 0; q < QUANTITIES; q++) {
            arb_sub_si(loss, q == LOSS_ZERO_OVERLAP ? c->eps_zero_overlap : c->eps_zero_force, 1, 4 * BITS);
            arb_neg(loss, loss);
            const double error = difference((enum quantity)q, b, exact[q] != NULL ? exact[q] : loss);
            if (error > worst) {
                worst = error;
                at = b;
            }
            check(error <= MAX_DIFFERENCE, "quantity %d, beta = %a: relative difference %g", q, b, error);
        }
    }
    print_message("%g <= beta <= %g: %zu points, worst relative difference %.3g = 2^%.2f at %a\n", low, high, count,
                  worst, log2(worst), at);
}

TEST(test_series)
{
    compare(1e-6, 0.125, points(few_or_all(7, 20)));
    compare(1e-60, 1e-6, points(few_or_all(2, 4)));
}

TEST(test_interpolation)
{
    compare(0.125, 1, points(few_or_all(6, 18)));
    compare(1, 4, points(few_or_all(6, 18)));
    compare(4, 8, points(few_or_all(4, 12)));
    compare(8, 16, points(few_or_all(2, 6)));
    compare(16, 64, points(few_or_all(2, 6)));
    compare(64, 0x1p48, points(few_or_all(2, 6)));
}

TEST(test_asymptotics)
{
    compare(0x1p48, 1e17, points(few_or_all(1, 3)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {test_series, test_interpolation, test_asymptotics};
    if (LDBL_MANT_DIG < 64) {
        print_message("skipped: long double has only %d bits\n", LDBL_MANT_DIG);
        return 77;
    }
    state = random_start();
    if (reference_build() != 0 || reference_save() != 0)
        return 1;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
