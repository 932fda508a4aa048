/* SPDX-License-Identifier: MIT */
/* Digits are printed only if the ball proves them, and are then correctly rounded. */
#include "check.h"

#include "support/digits.h"
#include "support/formula.h"
#include "support/local.h"

TEST(test_spelling)
{
    static const struct {
        const char *value, *spelling;
        slong digits;
    } known[] = {
        {"1.0933620739432780563", "1.0933620739", 11},
        {"-5.0449e-12", "-5.04e-12", 3},
        {"0.00012345", "0.000123", 3},
        {"0.000012345", "0.0000123", 3},
        {"0.0000012345", "1.23e-6", 3},
        {"123456", "1.23e5", 3},
        {"123456", "123456", 6},
        {"123456", "123456.00", 8},
        {"-0.99996", "-1.000", 4},
        {"9.9999999", "10", 2},
        {"3", "3", 1},
        {"6e-300", "6e-300", 1},
        {"1e300", "1e300", 1},
        {"0", "0", 50},
        {"0.125", "0.12", 2}, /* exact ties: half to even, as everywhere in IEEE arithmetic */
        {"0.375", "0.38", 2},
        {"1 +/- 1e-30", "1.0000000000000000000", 20}, /* no tie: the digits do not depend on the width */
    };
    LOCAL(arb, x);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        arb_set_str(x, known[i].value, 300);
        char *s = digits_of_ball(x, known[i].digits);
        assert_non_null(s);
        assert_string_equal(s, known[i].spelling);
        free(s);
    }
}

/* Balls that are too wide for the digits, or beyond the range of MPFR, give no digits. Cases with 16 digits give no
 * double either. */
TEST(test_undecided)
{
    static const struct {
        const char *value;
        slong digits;
    } undecided[] = {{"1.05 +/- 0.001", 2}, {"0.15 +/- 1e-50", 1}, {"1 +/- 2", 1},
                     {"0.55 +/- 0.45", 1}, /* could be any number from 0.1 to 1 */
                     {"0 +/- 1e-100", 16},  {"1 +/- 1.2e-16", 16}, {"0 +/- 1e-400", 16}};
    LOCAL(arb, x);
    double y = 7;
    for (size_t i = 0; i < sizeof undecided / sizeof *undecided; i++) {
        arb_set_str(x, undecided[i].value, 300);
        assert_null(digits_of_ball(x, undecided[i].digits));
        if (undecided[i].digits == 16)
            check(!digits_to_double(&y, x) && y == 7, "%s", undecided[i].value);
    }
    for (int sign = -1; sign <= 1; sign += 2) {
        arb_set_si(x, 3);
        arb_mul_2exp_si(x, x, sign * (WORD(1) << 40));
        assert_null(digits_of_ball(x, 10));
        assert_true(digits_to_double(&y, x) == (sign < 0)); /* the nearest double of a tiny number is 0 */
        y = 7;
    }
    arb_set_str(x, "1e400", 100); /* beyond the range of a double */
    assert_false(digits_to_double(&y, x));
    arb_indeterminate(x);
    assert_null(digits_of_ball(x, 3));
    arb_pos_inf(x);
    char *s = digits_of_ball(x, 3);
    assert_string_equal(s, "inf");
    free(s);
    arb_zero(x);
    assert_true(digits_to_double(&y, x) && y == 0);
}

/* Nearest doubles of centre + sign 2^power, also subnormal ones, with a radius of 2^(power - 10) and without one */
TEST(test_doubles)
{
    const double ulp = DBL_EPSILON;
    const struct {
        double centre;
        slong power, sign;
    } cases[] = {{1, -60, 0} /* the centre has few bits, but the ends of the ball need more */,
                 {1, -200, 1},
                 {1 - ulp / 2, -200, -1},
                 {1, -54, 1},
                 {1 + ulp, -54, -1},
                 {0x1p-1074, -1080, 1},
                 {0x1.8p-1073, -1100, 1},
                 {0x1p-1022, -1076, -1}, /* 2^-1076 is a quarter of the smallest positive double */
                 {DBL_MAX, 960, 1}};
    LOCAL(arb, x);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double centre = cases[i].centre;
        const slong sign = cases[i].sign, power = cases[i].power;
        LET(x, 3000, "centre + sign*2^power", centre, sign, power);
        for (int wide = 0; wide < 2; wide++) {
            double y = -1;
            check(digits_to_double(&y, x) && y == centre, "case %zu: %a", i, y);
            arb_add_error_2exp_si(x, power - 10);
        }
    }
}

TEST(test_precision_ends)
{
    struct precision p = precision_start(10);
    int raised = 0;
    for (slong before = p.bits; precision_raise(&p); before = p.bits, raised++)
        assert_true(p.bits > before);
    assert_in_range(raised, 3, 20);
    assert_true(p.bits >= p.limit);

    p = precision_doubling(100, 800);
    for (slong bits = 100; bits <= 800; bits *= 2) {
        assert_int_equal(p.bits, bits);
        assert_int_equal(precision_raise(&p), bits < 800);
    }
    p = precision_doubling(100, 199);
    assert_false(precision_raise(&p));
}
