/* SPDX-License-Identifier: MIT */
/* Numbers as the paper of 1999 prints them, right or wrong, with their equation numbers. No table of values may use
 * these numbers; they serve --as-published and tests. */
#ifndef COR_GEN_APPROXIMATION_PUBLISHED_H
#define COR_GEN_APPROXIMATION_PUBLISHED_H

#include <stdbool.h>

enum published_quantity { PUBLISHED_Y, PUBLISHED_C, PUBLISHED_A, PUBLISHED_D };

struct published {
    enum published_quantity quantity;
    int index; /* y_k, C_k, a_k, d_k */
    const char *equation;
    const char *printed; /* the printed decimal text, or an exact fraction */
    const char *correct; /* the number of the true series with more digits, or NULL: see note */
    bool right;          /* the printed number equals `correct` except for the rounding of its last digit */
};

/* Ends with a row whose `printed` is NULL. d_k is from Table I; its `correct` is the coefficient of the true [1/4]. */
extern const struct published published[];

/* The printed text, or NULL if there is none. */
const char *published_value(enum published_quantity quantity, int index);

#endif
