/* SPDX-License-Identifier: MIT */
/* hertz_dashpot.h against enclosed collisions. */
#include "law_check.h"

#include "../unit/check.h"
#include "cor/hertz_dashpot.h"

static const struct law_functions functions = LAW_FUNCTIONS(
    "hertz_dashpot", "3/2", "0", cor_hertz_dashpot, COR_HERTZ_DASHPOT_EPS_MAX_ULP, COR_HERTZ_DASHPOT_TIME_MAX_ULP);

static void test_bounds(void **state)
{
    (void)state;
    assert_true(COR_HERTZ_DASHPOT_LOSS_MAX_ULP == functions.one_ulp &&
                COR_HERTZ_DASHPOT_MAX_OVERLAP_MAX_ULP == functions.one_ulp &&
                COR_HERTZ_DASHPOT_BETA_MAX_ULP == functions.two_ulp);
}

static void test_special(void **state)
{
    (void)state;
    law_check_special(&functions);
    assert_true(cor_hertz_dashpot_beta_zero_overlap(0) == COR_HERTZ_DASHPOT_BETA_C);
}

static void test_random(void **state)
{
    (void)state;
    law_check_random(&functions, points(16));
}

static void test_borders(void **state)
{
    (void)state;
    law_check_borders(&functions, points(4));
}

static void test_round_trip(void **state)
{
    (void)state;
    law_check_round_trip(&functions, points(20000));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bounds),  cmocka_unit_test(test_special),    cmocka_unit_test(test_random),
        cmocka_unit_test(test_borders), cmocka_unit_test(test_round_trip),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
