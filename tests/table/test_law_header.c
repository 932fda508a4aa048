/* SPDX-License-Identifier: MIT */
/* One header of `corgen law`, LAW_HEADER of the law (LAW_ELASTIC, LAW_DAMPING) with the name `law`, against enclosed
 * collisions. tests/law/run writes such headers and compiles this for each. */
#include "law_check.h"

#include "../unit/check.h"

#include LAW_HEADER

static const struct law_functions functions = LAW_FUNCTIONS(LAW_HEADER, LAW_ELASTIC, LAW_DAMPING, law, 1.0, 2.0);

static void test_special(void **state)
{
    (void)state;
    law_check_special(&functions);
}

static void test_random(void **state)
{
    (void)state;
    law_check_random(&functions, points(200));
}

static void test_borders(void **state)
{
    (void)state;
    law_check_borders(&functions, points(24));
}

static void test_round_trip(void **state)
{
    (void)state;
    law_check_round_trip(&functions, points(20000));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_special),
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_borders),
        cmocka_unit_test(test_round_trip),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
