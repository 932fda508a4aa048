/* SPDX-License-Identifier: MIT */
/* Tests numbers as text: valid and invalid texts, exact values, nearest doubles, limits, and the shortest text. */
#include "support/console.h" /* must precede cmocka.h, which defines a macro fail */

#include <float.h>

#include "check.h"
#include "support/decimal.h"
#include "support/local.h"

static void assert_value(const char *text, const char *exact)
{
    struct decimal x = {0};
    check(decimal_parse(&x, text, DECIMAL_EXPONENT_DIGITS), "%s", text);
    assert_ptr_equal(x.text, text);
    char *value = fmpq_get_str(NULL, 10, x.value);
    assert_string_equal(value, exact);
    flint_free(value);
    decimal_clear(&x);
    assert_null(x.text);
}

TEST(test_values)
{
    assert_value("0", "0");
    assert_value("7", "7");
    assert_value("0.33", "33/100");
    assert_value("-.50", "-1/2");
    assert_value("2.", "2");
    assert_value("1.5e-3", "3/2000");
    assert_value("1.5E+3", "1500");
    assert_value("-2e-1", "-1/5");
    assert_value("6/4", "3/2");
    assert_value("-2/6", "-1/3");
    assert_value("0000000001e000003", "1000");
}

/* Texts that are not numbers. 1e0000001 has one digit more than the longest exponent. */
TEST(test_no_numbers)
{
    static const char *const wrong[] = {
        "",      ".",     "-",     "--1",   "+1",    " 1",   "1 ",  "1,5",       "e3",        ".e3",  "1e",   "1e+",
        "1e-",   "1e.5",  "1e1e1", "1.2.3", "0x1",   "nan",  "inf", "1/",        "/2",        "1/0",  "1/00", "1/-2",
        "1/2/3", "1.5/2", "1/2.5", "1/e",   "1e2/3", "1 /2", "- 1", "1e1234567", "1e0000001", "\xb2", "1\n"};
    struct decimal x = {0};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        check(!decimal_parse(&x, wrong[i], DECIMAL_EXPONENT_DIGITS) && !x.text, "%s", wrong[i]);
    for (int digits = 1; digits <= DECIMAL_EXPONENT_DIGITS; digits++) {
        char text[16];
        for (int more = 0; more <= 1; more++) {
            snprintf(text, sizeof text, "1e-%0*d", digits + more, 5);
            check(decimal_parse(&x, text, digits) == (more == 0), "%s", text);
            decimal_clear(&x);
        }
    }
    assert_true(decimal_parse(&x, "1e999999", DECIMAL_EXPONENT_DIGITS));
    assert_true(isinf(decimal_value(&x)));
    decimal_clear(&x);
}

/* glibc's strtod rounds correctly, also to subnormal numbers. decimal_nearest must agree with it. */
TEST(test_nearest)
{
    static const char *const special[] = {
        "0",
        "5e-324",
        "2.47e-324",
        "2.4703282292062327208e-324", /* just below half of the least double */
        "2.4703282292062327209e-324", /* just above */
        "2.2250738585072011e-308",
        "2.2250738585072014e-308",
        "1.7976931348623157e308",
        "1.7976931348623158e308",
        "1.7976931348623159e308",
        "9007199254740993",
        "9007199254740995",
        "1e-400",
        "-1e-320",
    };
    struct decimal x = {0};
    char text[64];
    for (size_t i = 0; i < sizeof special / sizeof *special; i++) {
        assert_true(decimal_parse(&x, special[i], DECIMAL_EXPONENT_DIGITS));
        check(decimal_value(&x) == strtod(special[i], NULL), "%s: %a", special[i], decimal_value(&x));
        decimal_clear(&x);
    }
    for (int i = 0; i < 3000; i++) {
        const double y = random_log(&draw, i % 3 == 0 ? 4e-324 : 1e-300, i % 3 == 0 ? 1e-306 : 1e300);
        snprintf(text, sizeof text, "%s%.*g", i % 2 ? "-" : "", 1 + i % 25, y);
        assert_true(decimal_parse(&x, text, DECIMAL_EXPONENT_DIGITS));
        check(decimal_value(&x) == strtod(text, NULL), "%s: %a", text, decimal_value(&x));
        decimal_clear(&x);
    }
    /* half of the least subnormal double is a tie, which rounds to 0; anything above it does not */
    LOCAL(fmpq, tie);
    fmpz_one(fmpq_numref(tie));
    fmpz_one_2exp(fmpq_denref(tie), 1075);
    assert_true(decimal_nearest(tie) == 0);
    fmpz_sub_ui(fmpq_denref(tie), fmpq_denref(tie), 1);
    assert_true(decimal_nearest(tie) == DBL_TRUE_MIN);
    fmpq_neg(tie, tie);
    assert_true(decimal_nearest(tie) == -DBL_TRUE_MIN);
}

static bool inside(const struct decimal_range *range, const char *text)
{
    struct decimal x = {0};
    assert_true(decimal_parse(&x, text, DECIMAL_EXPONENT_DIGITS));
    const bool is = decimal_inside(range, x.value);
    decimal_clear(&x);
    return is;
}

TEST(test_ranges)
{
    struct decimal_range range = {"-1", "1", true, false, false, ""};
    assert_true(inside(&range, "-1") && inside(&range, "0.99999999999999999999"));
    assert_false(inside(&range, "1") || inside(&range, "-1.00000000000000000001"));
    range.nearest = true; /* refuses numbers whose nearest double is the excluded limit */
    assert_false(inside(&range, "0.99999999999999999999"));
    range.high_allowed = true;
    assert_true(inside(&range, "1") && inside(&range, "0.99999999999999999999"));
    assert_false(inside(&range, "1.00000000000000000001"));
    range = (struct decimal_range){"0", NULL, false, false, true, ""};
    assert_true(inside(&range, "1e308") && inside(&range, "5e-324"));
    assert_false(inside(&range, "0") || inside(&range, "1e-400") || inside(&range, "1e309"));
}

/* The shortest text of a double reads back as that double. */
TEST(test_texts)
{
    char text[DECIMAL_TEXT];
    for (int i = 0; i < 2000; i++) {
        const double x = random_log(&draw, 1e-300, 1e300);
        decimal_text(text, i % 2 ? x : -x);
        check(strtod(text, NULL) == (i % 2 ? x : -x), "%s", text);
    }
    assert_string_equal(decimal_text(text, -(double)NAN), "nan");
    assert_string_equal(decimal_text(text, 0.1), "0.1");
}
