/* SPDX-License-Identifier: MIT */
/* Digits are printed only if the ball proves them, and then correctly rounded. */
#include "check.h"

#include "support/digits.h"
#include "support/local.h"

/* The ball of prec bits around the number `text` to so many digits. */
static char *spelled(const char *text, slong prec, slong digits)
{
    LOCAL(arb, x);
    arb_set_str(x, text, prec);
    return digits_of_ball(x, digits);
}

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
        {"1 +/- 1e-30", "1.0000000000000000000", 20}, /* no tie: the width does no harm, below a power of ten either */
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        char *s = spelled(known[i].value, 300, known[i].digits);
        assert_non_null(s);
        assert_string_equal(s, known[i].spelling);
        free(s);
    }
}

TEST(test_wide_balls)
{
    static const char *const undecided[] = {"1.05 +/- 0.001", "0 +/- 1e-100", "1 +/- 2", "0.15 +/- 1e-50"};
    for (size_t i = 0; i < sizeof undecided / sizeof *undecided; i++)
        assert_null(spelled(undecided[i], 300, i == 0 ? 2 : 1));
    LOCAL(arb, x);
    arb_pos_inf(x);
    char *s = digits_of_ball(x, 3);
    assert_string_equal(s, "inf");
    free(s);
    arb_indeterminate(x);
    assert_null(digits_of_ball(x, 3));
}

static void check_double(double centre, slong exponent_of_offset, int sign, double expected)
{
    LOCAL(arb, x, offset);
    arb_set_si(offset, sign);
    arb_mul_2exp_si(offset, offset, exponent_of_offset);
    arb_set_d(x, centre);
    arb_add(x, x, offset, ARF_PREC_EXACT);
    double y = -1;
    assert_true(digits_to_double(&y, x));
    assert_true(y == expected);
    arb_add_error_2exp_si(x, exponent_of_offset - 10);
    y = -1;
    assert_true(digits_to_double(&y, x));
    assert_true(y == expected);
}

TEST(test_doubles)
{
    const double ulp = DBL_EPSILON;
    check_double(1, -200, 1, 1);
    check_double(1 - ulp / 2, -200, -1, 1 - ulp / 2);
    check_double(1, -54, 1, 1);
    check_double(1 + ulp, -54, -1, 1 + ulp);
    check_double(0x1p-1074, -1080, 1, 0x1p-1074); /* the least subnormal */
    check_double(0x1.8p-1073, -1100, 1, 0x1.8p-1073);
    check_double(0x1p-1022, -1076, -1, 0x1p-1022); /* from below, a quarter of the subnormals' ulp */
    check_double(DBL_MAX, 960, 1, DBL_MAX);
}

/* A midpoint of a few bits, 1 above all, and a radius that leaves no doubt: both ends must not be rounded to so few. */
TEST(test_short_midpoints)
{
    static const double midpoint[] = {1, -1, 2, 0.5, -0.75, 5, 0x1p-1000, 0x1p900};
    LOCAL(arb, x);
    for (size_t i = 0; i < sizeof midpoint / sizeof *midpoint; i++) {
        for (int bits = 56; bits < 400; bits += bits / 8) {
            double y = 7;
            arb_set_d(x, midpoint[i]);
            arb_add_error_2exp_si(x, ilogb(midpoint[i]) - bits);
            assert_true(digits_to_double(&y, x));
            assert_true(y == midpoint[i]);
            char *text = digits_of_ball(x, 16);
            assert_non_null(text);
            assert_true(strtod(text, NULL) == midpoint[i] || fabs(midpoint[i]) < 0.1 || fabs(midpoint[i]) > 10);
            free(text);
        }
    }
}

TEST(test_doubles_undecided)
{
    LOCAL(arb, x);
    double y = 7;
    arb_set_d(x, 1);
    arb_add_error_2exp_si(x, -53);
    assert_false(digits_to_double(&y, x));
    arb_set_str(x, "0 +/- 1e-400", 100);
    assert_false(digits_to_double(&y, x));
    arb_set_str(x, "1e400", 100);
    assert_false(digits_to_double(&y, x));
    assert_true(y == 7);
    arb_zero(x);
    assert_true(digits_to_double(&y, x));
    assert_true(y == 0);
}

/* Numbers beyond what MPFR holds have no digits. */
TEST(test_far_numbers)
{
    LOCAL(arb, x);
    double y;
    for (int sign = -1; sign <= 1; sign += 2) {
        arb_set_si(x, 3);
        arb_mul_2exp_si(x, x, sign * (WORD(1) << 40));
        assert_null(digits_of_ball(x, 10));
        assert_false(digits_to_double(&y, x));
    }
}

TEST(test_precision_ends)
{
    struct precision p = precision_start(10);
    int raised = 0;
    slong before = p.bits;
    while (precision_raise(&p)) {
        assert_true(p.bits > before);
        before = p.bits;
        raised++;
    }
    assert_in_range(raised, 3, 20);
    assert_true(before >= p.limit);

    p = precision_doubling(100, 4);
    for (slong bits = 100; bits <= 800; bits *= 2) {
        assert_int_equal(p.bits, bits);
        assert_int_equal(precision_raise(&p), bits < 800);
    }
    p = precision_doubling(100, 1);
    assert_false(precision_raise(&p));
}

RUN_TESTS(test_spelling, test_wide_balls, test_doubles, test_short_midpoints, test_doubles_undecided,
          test_precision_ends, test_far_numbers)
