/* SPDX-License-Identifier: MIT */
#ifndef COR_TESTS_ACCURACY_BALL_VALUE_H
#define COR_TESTS_ACCURACY_BALL_VALUE_H

#include "support/flint.h"

/* Returns the middle of a ball, rounded. */
static inline long double ball_value(const arb_t x)
{
    mpfr_t y;
    mpfr_init2(y, 128);
    arf_get_mpfr(y, arb_midref(x), MPFR_RNDN);
    const long double value = mpfr_get_ld(y, MPFR_RNDN);
    mpfr_clear(y);
    return value;
}

#endif
