/* SPDX-License-Identifier: MIT */
/* Compares printed numbers with exact ones: proves which prints are wrong, and that the corrections are right. */
#include "ball.h"

#include "approximation/pade.h"
#include "series/series.h"
#include "support/local.h"

enum { ORDER = 4, BITS = 128 };

/* y_2 and y_3 are misprinted; (61) is right. (62) also lacks a factor 1/6, which has no effect because x_0''' vanishes
 * at the turning point. C_3, C_4, a_3, a_4 and Table I inherit the error. a_1 and a_2 are exact. */
static const struct {
    char quantity; /* y_k, C_k or a_k */
    int index;
    const char *equation, *printed, *correct;
} published[] = {
    {'y', 0, "(59)", "1.093362", "1.09336207394"},
    {'y', 1, "(60)", "-0.504455", "-0.50445489427"},
    {'y', 2, "(61)", "0.260542", "0.28404301890"},
    {'y', 3, "(62)", "-0.136769", "-0.17022077850"},
    {'C', 1, "(67)", "-1.153449", "-1.15344885810"},
    {'C', 2, "(67)", "0.798267", "0.79826656094"},
    {'C', 3, "(34), (67)", "-0.483582", "-0.52288256809"},
    {'C', 4, "(34), (67)", "0.285279", "0.34874267526"},
    {'a', 1, "(32)", NULL, "1"},
    {'a', 2, "(32)", NULL, "3/5"},
    {'a', 3, "(33), (70)", NULL, "0.3407290271"},
    {'a', 4, "(33), (71)", NULL, "0.1970206380"},
};

/* True if x, which is proved, is within one unit of the last digit of the text. */
static bool agrees(const arb_t x, const char *text)
{
    LOCAL(arb, y);
    const slong decimals = (slong)strlen(strchr(text, '.') + 1);
    assert_int_equal(arb_set_str(y, text, BITS), 0);
    LET(y, BITS, "abs(y - x)*10^decimals - 1", y, x, decimals);
    assert_true(arb_is_nonpositive(y) || arb_is_positive(y)); /* the ball must be narrow enough to decide */
    return arb_is_nonpositive(y);
}

TEST(test_values)
{
    LOCAL(series, s);
    LOCAL(arb, x, c1);
    LOCAL(fmpq, exact);
    assert_int_equal(series_compute(s, ORDER, &law_sphere, BITS), 0);
    arb_poly_get_coeff_arb(c1, s->c, 1);
    for (size_t i = 0; i < sizeof published / sizeof *published; i++) {
        const bool is_a = published[i].quantity == 'a';
        const slong k = published[i].index;
        const char *const printed = is_a ? published_a[k - 1] : published[i].printed, *const correct =
                                                                                          published[i].correct;
        arb_poly_get_coeff_arb(x, published[i].quantity == 'y' ? s->y : s->c, k);
        if (is_a)
            LET(x, BITS, "abs(x/c1^k)", x, c1, k);
        if (is_a && k < 3) { /* the first two printed numbers are correct */
            assert_string_equal(printed, correct);
            assert_int_equal(fmpq_set_str(exact, correct, 10), 0);
            assert_true(arb_contains_fmpq(x, exact));
            continue;
        }
        const bool wrong = published[i].quantity == 'y' ? k == 2 || k == 3 : k > 2;
        check(agrees(x, correct), "%s: %s is not the right value", published[i].equation, correct);
        check(agrees(x, printed) != wrong, "%s: the print %s is %s", published[i].equation, printed,
              wrong ? "right" : "wrong");
    }
}

/* The printed numbers agree with each other: a_k = |C_k|/|C_1|^k for the printed C_k. So (70) and (71) are right, and
 * C_3 and C_4 are wrong. */
TEST(test_print_is_consistent)
{
    for (int k = 3; k <= 4; k++)
        assert_true(fabs(fabs(atof(published[3 + k].printed) / pow(atof(published[4].printed), k)) -
                         atof(published_a[k - 1])) < 2e-6);
}
