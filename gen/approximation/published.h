/* SPDX-License-Identifier: MIT */
/* Numbers as the paper of 1999 prints them, right or wrong, with their equation numbers. Nothing
 * here may reach a table that serves values: they exist for --as-published and for tests. */
#ifndef COR_GEN_APPROXIMATION_PUBLISHED_H
#define COR_GEN_APPROXIMATION_PUBLISHED_H

#include <stdbool.h>

enum published_quantity { PUBLISHED_Y, PUBLISHED_C, PUBLISHED_A, PUBLISHED_D };

struct published {
    enum published_quantity quantity;
    int index; /* y_k, C_k, a_k, d_k */
    const char *equation;
    const char *printed; /* the decimal text of the print, or an exact fraction */
    const char *correct; /* the same number of the true series to more digits, or NULL: see note */
    bool right;          /* the print is `correct`, but for the rounding of its last digit */
};

/* Ends with a row whose `printed` is NULL. d_k: Table I, of which `correct` is what the true [1/4]
 * has in its place. */
extern const struct published published[];

/* The printed text, or NULL if there is none. */
const char *published_value(enum published_quantity quantity, int index);

#endif
