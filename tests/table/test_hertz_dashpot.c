/* SPDX-License-Identifier: MIT */
/* hertz_dashpot.h against enclosed collisions. */
#include "law_check.h"

#include "../unit/check.h"
#include "cor/hertz_dashpot.h"

static const struct law_functions functions =
    LAW_FUNCTIONS("hertz_dashpot", "3/2", "0", cor_hertz_dashpot, LAW_THREE_ENDS, COR_HERTZ_DASHPOT_EPS_MAX_ULP,
                  COR_HERTZ_DASHPOT_TIME_MAX_ULP, COR_HERTZ_DASHPOT_APPROACH_MAX_ULP);

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

/* Where the rows of damping while approaching only meet: the series, the near rows, the octaves and the tail */
TEST(test_approach_only)
{
    leave_to_turn(1, 2);
    double beta[52] = {nextafter(0.0625, 0), 0.0625, nextafter(0.125, 0), 0.125, nextafter(8, 0), 8};
    for (int k = 4; k < 50; k++)
        beta[k + 2] = ldexp(1, k);
    law_check_at(&functions, beta, COUNT_OF(beta));
}

RUN_TESTS(test_bounds, test_special, test_random, test_borders, test_approach_only)
