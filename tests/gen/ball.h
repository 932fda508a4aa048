/* SPDX-License-Identifier: MIT */
/* Assertions about balls of Arb, for the tests of the generator. */
#ifndef COR_TESTS_GEN_BALL_H
#define COR_TESTS_GEN_BALL_H

#include "check.h"
#include "series/law.h"
#include "support/flint.h"
#include "support/formula.h"
#include "support/local.h"

static inline double middle(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

static inline struct cor_exponents law_of(const char *a, const char *b)
{
    struct cor_exponents law;
    assert_null(law_parse(&law, a, b));
    return law;
}

/* Fails unless x is enclosed to at least `bits` relative bits. */
static inline void assert_bits(const arb_t x, slong bits)
{
    if (arb_rel_accuracy_bits(x) < bits) {
        arb_fprintd(stderr, x, 20);
        fail_msg(": only %ld relative bits, not %ld", (long)arb_rel_accuracy_bits(x), (long)bits);
    }
}

/* Fails unless two enclosures of one number overlap. */
static inline void assert_overlap(const arb_t x, const arb_t y, const char *what, slong index)
{
    if (!arb_overlaps(x, y)) {
        arb_fprintn(stderr, x, 40, 0);
        fprintf(stderr, " and ");
        arb_fprintn(stderr, y, 40, 0);
        fail_msg(": %s %ld do not overlap", what, (long)index);
    }
}

/* Fails unless x overlaps the value of a formula, written as for LET. */
#define assert_is(x, what, index, ...)                                                                                 \
    do {                                                                                                               \
        LOCAL(arb, formula_);                                                                                          \
        LET(formula_, 600, __VA_ARGS__);                                                                               \
        assert_overlap(x, formula_, what, index);                                                                      \
    } while (0)

/* Fails unless every point of x is within one unit of the last digit of the decimal text. */
static inline void assert_digits(const arb_t x, const char *text)
{
    LOCAL(arb, y);
    const char *point = strchr(text, '.');
    const slong decimals = point ? (slong)strlen(point + 1) : 0;
    assert_int_equal(arb_set_str(y, text, 1000), 0);
    LET(y, 1000, "abs(y - x)*10^decimals - 1", y, x, decimals);
    if (!arb_is_nonpositive(y)) {
        arb_fprintn(stderr, x, 50, 0);
        fail_msg(" is not %s", text);
    }
}

static inline void assert_poly_overlap(const arb_poly_t f, const arb_poly_t g, slong order, const char *what)
{
    LOCAL(arb, x, y);
    for (slong k = 0; k <= order; k++) {
        arb_poly_get_coeff_arb(x, f, k);
        arb_poly_get_coeff_arb(y, g, k);
        assert_overlap(x, y, what, k);
    }
}

#endif
