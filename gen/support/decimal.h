/* SPDX-License-Identifier: MIT */
/* Numbers as text. Only this file converts a text to an exact rational, and a double to its shortest text. */
#ifndef COR_GEN_SUPPORT_DECIMAL_H
#define COR_GEN_SUPPORT_DECIMAL_H

#include <stdbool.h>

#include "support/flint.h"

/* Forms of a number besides digits, a point and an exponent ("0.1", "1.5e-3") */
enum decimal_forms {
    DECIMAL_PLAIN = 0,
    DECIMAL_SIGN = 1, /* a leading minus sign: "-0.33" */
    DECIMAL_RATIO = 2 /* a quotient of integers: "2/3" */
};

/* Largest number of digits of an exponent, in a single number and in a number of a list */
enum { DECIMAL_EXPONENT_DIGITS = 6, DECIMAL_EXPONENT_DIGITS_IN_LIST = 3 };

/* A number as the user wrote it, with its exact value. text is NULL if no number was given; the text is not copied. */
struct decimal {
    const char *text;
    fmpq_t value;
    enum decimal_forms forms; /* the forms that the text uses */
};

/* Reads a text of any form whose exponent has at most exponent_digits digits. If it returns false, *x is unchanged. */
bool decimal_parse(struct decimal *x, const char *text, int exponent_digits);

/* Reads a constant of the program. Ends the program if the text is not a number. */
void decimal_set(struct decimal *x, const char *text);

void decimal_clear(struct decimal *x); /* accepts a struct of zeros, which was never set */

/* The allowed range of a number. `low` and `high` are texts of numbers, or NULL for no limit. */
struct decimal_range {
    const char *low, *high;
    bool low_allowed, high_allowed;
    bool nearest;        /* the nearest double must also be finite and in the range */
    const char *allowed; /* the range in words, such as "a number from 0 to 1e6" */
};
bool decimal_inside(const struct decimal_range *range, const fmpq_t x);

/* Returns the double nearest to x, ties to even, or infinity beyond the largest double. A subnormal result is rounded
 * once. */
double decimal_nearest(const fmpq_t x);

/* Returns the double nearest to the exact value, or INFINITY. */
double decimal_value(const struct decimal *x);

/* The value of a macro as text */
#define TEXT_OF_(x) #x
#define TEXT_OF(x) TEXT_OF_(x)

/* Writes the shortest decimal text of at most 17 digits that reads back as x, or "nan" or "inf". */
enum { DECIMAL_TEXT = 32 };
const char *decimal_text(char text[DECIMAL_TEXT], double x);

#endif
