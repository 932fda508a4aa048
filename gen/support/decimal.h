/* SPDX-License-Identifier: MIT */
/* Numbers as text: the one place where a text becomes an exact rational, and a double the shortest text. */
#ifndef COR_GEN_SUPPORT_DECIMAL_H
#define COR_GEN_SUPPORT_DECIMAL_H

#include <stdbool.h>

#include "support/flint.h"

/* What a text may have besides digits, a point and an exponent ("0.1", "1.5e-3"). */
enum decimal_forms {
    DECIMAL_PLAIN = 0,
    DECIMAL_SIGN = 1, /* a minus before it: "-0.33" */
    DECIMAL_RATIO = 2 /* a quotient of whole numbers instead: "2/3" */
};

/* The longest exponent that a number may have, and a number in a list. */
enum { DECIMAL_EXPONENT_DIGITS = 6, DECIMAL_EXPONENT_DIGITS_IN_LIST = 3 };

/* A number as its user wrote it, with the exact value. text is NULL where none is given; it is not copied. */
struct decimal {
    const char *text;
    fmpq_t value;
    enum decimal_forms forms; /* that the text has */
};

/* Reads a text of any form whose exponent has at most so many digits. On false *x is as it was. */
bool decimal_parse(struct decimal *x, const char *text, int exponent_digits);

/* The same of a constant of the program; ends the program if the text is not a number. */
void decimal_set(struct decimal *x, const char *text);

void decimal_clear(struct decimal *x); /* also of one that was never given, all zero */

/* Where a number may lie. `low` and `high` are texts of numbers; NULL: no limit. */
struct decimal_range {
    const char *low, *high;
    bool low_allowed, high_allowed;
    bool nearest;        /* the double nearest to the number must lie there too, and be finite */
    const char *allowed; /* in words: "a number from 0 to 1e6" */
};
bool decimal_inside(const struct decimal_range *range, const fmpq_t x);

/* The double nearest to x, ties to even; infinite beyond the largest, and rounded once where it is subnormal. */
double decimal_nearest(const fmpq_t x);

/* The same of a number as it is written. */
double decimal_value(const struct decimal *x);

/* The shortest decimal text of at most 17 digits that is read back as x; "nan" and "inf" for what is no number. */
enum { DECIMAL_TEXT = 32 };
const char *decimal_text(char text[DECIMAL_TEXT], double x);

#endif
