/* SPDX-License-Identifier: MIT */
/* The stability suite: inputs at which a numerical method fails first, each with a reference of higher precision. */
#ifndef COR_TESTS_STABILITY_H
#define COR_TESTS_STABILITY_H

#include <stdbool.h>
#include <stddef.h>

#include "support/flint.h"

/* The worst found of a case */
struct outcome {
    double error;     /* in the unit of the case */
    double condition; /* of the problem where it is largest, 0 where it is about one: error is divided by it */
    size_t points;
    char input[160], reference[80], value[80]; /* where the error is largest */
};

struct hard_case {
    const char *name;      /* one of stability_names */
    const char *wrong;     /* what could go wrong */
    const char *input;     /* what is tried; "(full)": only in the full form */
    const char *reference; /* where the truth comes from */
    const char *unit;      /* of error and bound */
    double bound;
    void (*run)(struct outcome *out, bool full);
};

struct case_list {
    const struct hard_case *cases;
    size_t count;
};

extern const struct case_list stability_sphere, stability_generator, stability_law, stability_modes, stability_rayleigh,
    stability_collision;

/* A point: kept if its error is the largest so far, a NaN included. */
void outcome_take(struct outcome *out, double error, const char *input, const char *reference, const char *value);
/* The same with numbers; input is `name` = x in decimal and hexadecimal. */
void take_number(struct outcome *out, double error, const char *name, double x, const arb_t reference, double value);

/* |computed - exact| in ulp of the double nearest to the exact value, what the ball leaves open included */
double ball_ulp(double computed, const arb_t exact);
/* |computed/exact - 1| or |computed - exact|, what the balls leave open included */
double ball_relative(const arb_t computed, const arb_t exact);
double ball_absolute(const arb_t computed, const arb_t exact);
double upper(const arb_t x); /* of |x| */

/* The double so many representable numbers further from zero */
double moved(double x, long steps);
/* Uniform in [low, high), started anew for each case */
double drawn(double low, double high);

#endif
