/* SPDX-License-Identifier: MIT */
/* Tests Hertz's dashpot of law.h against enclosed collisions. */
#include "law_check.h"

#include "../unit/check.h"
#include "cor/law.h"

static struct law_functions functions = {"hertz_dashpot", "3/2", "0", .one_ulp = 1, .two_ulp = 2, .approach_ulp = 2};

/* Fills the functions from the table, with these bounds. */
static int setup(void **state)
{
    static const enum cor_end ends[LAW_ENDS] = {COR_END_ZERO_OVERLAP, COR_END_ZERO_FORCE, COR_END_APPROACH_ONLY};
    law_function **const of_quantity[] = {functions.eps,
                                          functions.loss,
                                          functions.beta,
                                          functions.beta_of_loss,
                                          functions.duration,
                                          &functions.max_overlap,
                                          &functions.time_of_max_overlap};
    (void)state;
    for (int end = 0; end < LAW_ENDS; end++)
        for (int q = 0; q < COR_QUANTITIES; q++) {
            const struct cor_law_function *const f =
                cor_law_function(COR_LAW_HERTZ_DASHPOT, ends[end], (enum cor_quantity)q);
            const bool is_one = q == COR_MAX_OVERLAP || (end < 2 && q <= COR_LOSS);
            of_quantity[q][q < COR_MAX_OVERLAP ? end : 0] = f->value;
            assert_true(f->max_ulp <= (is_one ? functions.one_ulp : functions.two_ulp));
        }
    return 0;
}

TEST(test_special)
{
    law_check_special(&functions);
    assert_true(functions.beta[0](0) == COR_HERTZ_DASHPOT_BETA_C);
}

TEST(test_random)
{
    law_check_random(&functions, points(16));
}

TEST(test_borders)
{
    law_check_borders(&functions, points(4));
}

/* Places where the tables for damped approach meet: the series, the near rows, the octaves and the tail */
TEST(test_approach_only)
{
    leave_to_turn(1, 2);
    double beta[52] = {nextafter(0.0625, 0), 0.0625, nextafter(0.125, 0), 0.125, nextafter(8, 0), 8};
    for (int k = 4; k < 50; k++)
        beta[k + 2] = ldexp(1, k);
    law_check_at(&functions, beta, COUNT_OF(beta));
}

GROUP(setup, NULL)
