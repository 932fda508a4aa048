/* SPDX-License-Identifier: MIT */
#include "support/digits.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/local.h"

enum { GUARD_BITS = 32, LEADING_ZEROS_MAX = 4 };

slong digits_to_bits(slong digits)
{
    return (digits * 3322 + 999) / 1000 + GUARD_BITS; /* log2(10) < 3.322 */
}

/* Returns the shortest text with all digits of a mantissa such as "-12345", with the point after `point` digits. */
static char *digits_spell(const char *mantissa, long point)
{
    static const char zeros[LEADING_ZEROS_MAX + 1] = "0000";
    const char *const sign = *mantissa == '-' ? "-" : "", *const digits = mantissa + strlen(sign);
    const long n = (long)strlen(digits);
    if (point > 0 && point <= n)
        return xprintf("%s%.*s%s%s", sign, (int)point, digits, point < n ? "." : "", digits + point);
    if (point <= 0 && -point <= LEADING_ZEROS_MAX)
        return xprintf("%s0.%.*s%s", sign, (int)-point, zeros, digits);
    return xprintf("%s%c%s%se%ld", sign, *digits, n > 1 ? "." : "", digits + 1, point - 1);
}

char *digits_of_ball(const arb_t x, slong digits)
{
    if (arb_is_zero(x))
        return xstrdup("0");
    /* An interval with infinite midpoint represents the duration of a contact that never ends; [+/- inf] is
     * undecided. */
    if (arf_is_pos_inf(arb_midref(x)))
        return xstrdup("inf");

    /* enough bits for both ends rounded outwards, or for x itself if it is exact */
    const slong prec = FLINT_MAX(arb_bits(x), digits_to_bits(digits)) + GUARD_BITS;
    mpfr_t lower, upper;
    char *text = NULL;
    mpfr_init2(lower, prec);
    mpfr_init2(upper, prec);
    arb_get_interval_mpfr(lower, upper, x);
    mpfr_check_range(lower, 0, MPFR_RNDD);
    mpfr_check_range(upper, 0, MPFR_RNDU);
    if (mpfr_number_p(lower) && mpfr_number_p(upper) && mpfr_sgn(lower) * mpfr_sgn(upper) > 0) {
        mpfr_exp_t lower_point, upper_point;
        char *a = mpfr_get_str(NULL, &lower_point, 10, (size_t)digits, lower, MPFR_RNDN);
        char *b = mpfr_get_str(NULL, &upper_point, 10, (size_t)digits, upper, MPFR_RNDN);
        if (lower_point == upper_point && strcmp(a, b) == 0)
            text = digits_spell(a, (long)lower_point);
        mpfr_free_str(a);
        mpfr_free_str(b);
    }
    mpfr_clear(lower);
    mpfr_clear(upper);
    return text;
}

int digits_to_double(double *y, const arb_t x)
{
    const slong prec = FLINT_MAX(arb_bits(x), DBL_MANT_DIG) + GUARD_BITS;
    LOCAL(arf, lower, upper);
    arb_get_lbound_arf(lower, x, prec);
    arb_get_ubound_arf(upper, x, prec);
    const double a = arf_get_d(lower, ARF_RND_NEAR), b = arf_get_d(upper, ARF_RND_NEAR);
    const int decided = a == b && isfinite(a) && (!arb_contains_zero(x) || arb_is_zero(x));
    if (decided)
        *y = a;
    return decided;
}

/* ---- more bits ---- */

enum { FIRST_STEP = 32 };

struct precision precision_start(slong digits)
{
    const slong bits = digits_to_bits(digits);
    return (struct precision){.bits = bits, .step = FIRST_STEP, .limit = 3 * bits + 512};
}

struct precision precision_doubling(slong bits, slong limit)
{
    /* each attempt doubles bits and step; the last value of bits is above limit/2 and at most the limit */
    return (struct precision){.bits = bits, .step = bits, .limit = limit / 2 + 1};
}

bool precision_raise(struct precision *p)
{
    if (p->bits >= p->limit)
        return false;
    p->bits += p->step;
    p->step *= 2;
    return true;
}

int precision_spent(const struct precision *p, const char *what, slong digits)
{
    return fail("%s: cannot decide with %ld bits how to round to %ld digits: the number is 0, or halfway between two "
                "numbers of that length; use another --digits",
                what, (long)p->bits, (long)digits);
}
