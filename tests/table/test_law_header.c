/* SPDX-License-Identifier: MIT */
/* Tests a header of `corgen law` against enclosed collisions: LAW_HEADER, with the law (LAW_ELASTIC, LAW_DAMPING) and
 * the name `law`. tests/law/run writes such headers and compiles this file for each. */
#include "law_check.h"

#include "../unit/check.h"

#include LAW_HEADER

static const struct law_functions functions =
    LAW_FUNCTIONS(LAW_HEADER, LAW_ELASTIC, LAW_DAMPING, law, LAW_TWO_ENDS, 1.0, 2.0, 0);

TEST(test_special)
{
    law_check_special(&functions);
}

TEST(test_random)
{
    law_check_random(&functions, points(200));
}

TEST(test_borders)
{
    law_check_borders(&functions, points(24));
}

TEST(test_round_trip)
{
    law_check_round_trip(&functions, points(20000));
}

#ifdef LAW_IS_SPHERE
#include "cor/sphere.h"

/* Checks that two functions differ by at most `most` ulp, and give the same bits at more than 80 % of the places. */
static void compare(law_function *one, law_function *other, double from, double to, double most, const char *name)
{
    struct random_state r = random_start();
    size_t same = 0;
    const size_t n = points(200000);
    for (size_t i = 0; i < n; i++) {
        const double x = i % 2 == 0 ? random_log(&r, from, to) : random_uniform(&r, 0, to < 20 ? to : 20);
        const double y = one(x), z = other(x);
        same += (size_t)same_bits(y, z);
        check(ulp_error(y, (long double)z) <= most, "%s of %.17g: %.17g and %.17g", name, x, y, z);
    }
    check(10 * same > 8 * n, "%s: the same bits at %zu of %zu places only", name, same, n);
}

TEST(test_sphere)
{
#define COMPARE(quantity, from, to, most) compare(law_##quantity, cor_sphere_##quantity, from, to, most, #quantity)
    COMPARE(eps_zero_overlap, 1e-300, 1e60, 2);
    COMPARE(eps_zero_force, 1e-300, 1e180, 2);
    COMPARE(loss_zero_overlap, 1e-300, 1e60, 2);
    COMPARE(loss_zero_force, 1e-300, 1e180, 2);
    COMPARE(duration_zero_overlap, 1e-300, 1e300, 4);
    COMPARE(duration_zero_force, 1e-300, 1e300, 4);
    COMPARE(max_overlap, 1e-300, 1e300, 2);
    COMPARE(time_of_max_overlap, 1e-300, 1e300, 4);
    COMPARE(beta_zero_overlap, 1e-300, 1, 4);
    COMPARE(beta_zero_force, 1e-300, 1, 4);
}
#endif
