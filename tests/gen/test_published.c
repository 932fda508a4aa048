/* SPDX-License-Identifier: MIT */
/* The printed numbers beside the right ones: which prints are wrong, and that ours are not. */
#include "ball.h"

#include "approximation/published.h"
#include "series/series.h"
#include "support/local.h"

enum { ORDER = 4, BITS = 128 };

/* Whether x, proved, lies within `units` of the last printed digit of the text. */
static bool agrees(const arb_t x, const char *text, double units)
{
    LOCAL(arb, printed);
    LOCAL(fmpq, exact);
    const char *const point = strchr(text, '.');
    const slong decimals = point ? (slong)strlen(point + 1) : 0;
    if (fmpq_set_str(exact, text, 10) == 0)
        arb_set_fmpq(printed, exact, BITS);
    else
        assert_int_equal(arb_set_str(printed, text, BITS), 0);
    LET(printed, BITS, "abs(printed - x)*10^decimals - units", printed, x, decimals, units);
    const bool near = arb_is_nonpositive(printed);
    assert_true(near || arb_is_positive(printed)); /* decided */
    return near;
}

/* The true number: y_k and C_k of the series, a_k = |C_k|/|C_1|^k. */
static void true_value(arb_t x, const struct series *s, const struct published *row)
{
    LOCAL(arb, c1);
    arb_poly_get_coeff_arb(x, row->quantity == PUBLISHED_Y ? s->y : s->c, row->index);
    if (row->quantity == PUBLISHED_A) {
        arb_poly_get_coeff_arb(c1, s->c, 1);
        LET(x, BITS, "abs(x/c1^row->index)", x, c1, row->index);
    }
}

TEST(test_values)
{
    LOCAL(series, s);
    LOCAL(arb, x);
    int wrong = 0;
    assert_int_equal(series_compute(s, ORDER, &law_sphere, BITS), 0);
    for (const struct published *row = published; row->printed; row++) {
        if (row->quantity == PUBLISHED_D)
            continue;
        true_value(x, s, row);
        if (row->index == 1 && row->quantity == PUBLISHED_A) {
            assert_true(arb_contains_si(x, 1));
            continue;
        }
        /* a_2 = 3/5 is exact, so its ball is never proved to differ */
        if (strchr(row->printed, '/')) {
            LOCAL(fmpq, exact);
            assert_int_equal(fmpq_set_str(exact, row->printed, 10), 0);
            assert_true(arb_contains_fmpq(x, exact));
            continue;
        }
        check(agrees(x, row->correct, 1), "%s: %s is not the right value", row->equation, row->correct);
        check(agrees(x, row->printed, 1) == row->right, "%s: the print %s is %s", row->equation, row->printed,
              row->right ? "wrong" : "right");
        wrong += !row->right;
    }
    assert_int_equal(wrong, 6); /* y_2, y_3, C_3, C_4, a_3, a_4 */
}

/* The print is consistent with itself: a_k = |C_k|/|C_1|^k of the printed C_k, so the error came in
 * with the numbers and not with (70), (71). */
TEST(test_print_is_consistent)
{
    const double c1 = atof(published_value(PUBLISHED_C, 1));
    for (int k = 3; k <= 4; k++)
        assert_true(fabs(fabs(atof(published_value(PUBLISHED_C, k)) / pow(c1, k)) -
                         atof(published_value(PUBLISHED_A, k))) < 2e-6);
}

TEST(test_lookup)
{
    assert_string_equal(published_value(PUBLISHED_Y, 2), "0.260542");
    assert_string_equal(published_value(PUBLISHED_D, 5), "0.3265");
    assert_null(published_value(PUBLISHED_A, 5));
    assert_null(published_value(PUBLISHED_D, 0));
}

RUN_TESTS(test_values, test_print_is_consistent, test_lookup)
