/* SPDX-License-Identifier: MIT */
#include "support/decimal.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/local.h"

static const char digits[] = "0123456789";

static bool is_ratio(const char *text)
{
    const char *const slash = text + strspn(text, digits);
    if (slash == text || *slash != '/')
        return false;
    const char *const end = slash + 1 + strspn(slash + 1, digits);
    return end != slash + 1 && *end == '\0' && slash[1 + strspn(slash + 1, "0")] != '\0';
}

/* Reads digits with an optional point and an optional exponent. Returns false if the text is anything else. */
static bool read_decimal(fmpq_t x, const char *text, int exponent_digits)
{
    const size_t whole = strspn(text, digits), point = text[whole] == '.';
    const size_t fraction = point ? strspn(text + whole + 1, digits) : 0;
    const char *end = text + whole + point + fraction;
    slong exponent = 0;
    if (whole + fraction == 0)
        return false;
    if (*end == 'e' || *end == 'E') {
        exponent = strtol(end + 1, NULL, 10);
        end += end[1] == '+' || end[1] == '-' ? 2 : 1;
        const int length = (int)strspn(end, digits);
        if (length == 0 || length > exponent_digits)
            return false;
        end += length;
    }
    if (*end)
        return false;
    char *const mantissa = xprintf("%.*s%.*s", (int)whole, text, (int)fraction, text + whole + 1);
    fmpz_set_str(fmpq_numref(x), mantissa, 10);
    free(mantissa);
    exponent -= (slong)fraction;
    LOCAL(fmpz, power);
    fmpz_ui_pow_ui(power, 10, (ulong)labs(exponent));
    (exponent < 0 ? fmpq_div_fmpz : fmpq_mul_fmpz)(x, x, power);
    return true;
}

bool decimal_parse(struct decimal *x, const char *text, int exponent_digits)
{
    const bool sign = *text == '-', ratio = is_ratio(text + sign);
    LOCAL(fmpq, value);
    if (ratio)
        fmpq_set_str(value, text + sign, 10);
    else if (!read_decimal(value, text + sign, exponent_digits))
        return false;
    if (!x->text)
        fmpq_init(x->value);
    x->text = text;
    x->forms = (sign ? DECIMAL_SIGN : DECIMAL_PLAIN) | (ratio ? DECIMAL_RATIO : DECIMAL_PLAIN);
    fmpq_canonicalise(value);
    (sign ? fmpq_neg : fmpq_set)(x->value, value);
    return true;
}

void decimal_set(struct decimal *x, const char *text)
{
    if (!decimal_parse(x, text, DECIMAL_EXPONENT_DIGITS))
        exit(fail("the constant '%s' of corgen is not a number", text));
}

void decimal_clear(struct decimal *x)
{
    if (x->text)
        fmpq_clear(x->value);
    x->text = NULL;
}

bool decimal_inside(const struct decimal_range *range, const fmpq_t x)
{
    const double nearest = decimal_nearest(x);
    bool good = !range->nearest || isfinite(nearest);
    for (int sign = -1; sign <= 1; sign += 2) {
        const char *const limit = sign < 0 ? range->high : range->low;
        struct decimal y = {0};
        if (!limit)
            continue;
        decimal_set(&y, limit);
        const int order = sign * fmpq_cmp(x, y.value);
        const bool beyond = range->nearest && sign * nearest <= sign * decimal_value(&y);
        good = good && ((sign < 0 ? range->high_allowed : range->low_allowed) ? order >= 0 : order > 0 && !beyond);
        decimal_clear(&y);
    }
    return good;
}

double decimal_nearest(const fmpq_t x)
{
    LOCAL(arb, ball);
    LOCAL(arf, low, high);
    double nearest = 0, other = 1;
    for (slong prec = 128; nearest != other; prec *= 2) {
        arb_set_fmpq(ball, x, prec);
        arb_get_lbound_arf(low, ball, prec);
        arb_get_ubound_arf(high, ball, prec);
        nearest = arf_get_d(low, ARF_RND_NEAR);
        other = arf_get_d(high, ARF_RND_NEAR);
    }
    return nearest + 0; /* no -0 */
}

double decimal_value(const struct decimal *x)
{
    return decimal_nearest(x->value);
}

const char *decimal_text(char text[DECIMAL_TEXT], double x)
{
    if (isnan(x)) { /* NaN of either sign */
        snprintf(text, DECIMAL_TEXT, "nan");
        return text;
    }
    for (int digits = DBL_DIG; digits <= DBL_DECIMAL_DIG; digits++) {
        snprintf(text, DECIMAL_TEXT, "%.*g", digits, x);
        if (strtod(text, NULL) == x)
            break;
    }
    return text;
}
