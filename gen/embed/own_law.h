/* SPDX-License-Identifier: MIT */
/* An own law: the user gives eps as a function of the impact speed in m/s, without bodies or a force.
 *
 *     power-law:   min(1, A v^-B), A > 0; eps falls if B > 0
 *     exponential: E + (1 - E) exp(-v/V)
 *     table:       cubics through the rows of a csv file, monotone between them (Fritsch and Carlson 1980), with the
 *                  slopes of Fritsch and Butland (1984), as in SciPy's PchipInterpolator */
#ifndef COR_GEN_EMBED_OWN_LAW_H
#define COR_GEN_EMBED_OWN_LAW_H

#include "embed/request.h"

#define OWN_ROWS_MOST 400
enum { OWN_TEXT = 512 };

struct own_law {
    int law; /* law of the request; 0: a law of cor/law.h, and all other fields are 0 */
    const char *formula;
    fmpq *number;       /* two numbers: A and B, or E and V */
    double real[2];     /* the nearest doubles */
    const double *part; /* speeds between which eps is smooth: the rows, the kink at eps = 1, or multiples of V */
    slong parts;
    double own_part[6];
    slong rows;                   /* rows of the table; 0: no table */
    double *speed, *place, *near; /* for each row: its speed, ln(speed), and the doubles nearest to `cubic` */
    arb_ptr cubic; /* five numbers for each row but the last: speed, coefficients of (v - speed)^k; 0 without a table */
    char text[OWN_TEXT];
};

/* Returns STATUS_OK, or STATUS_USAGE after a message about missing or contradictory options, or about the table. Call
 * own_law_clear in either case. */
int own_law_init(struct own_law *law, const struct embed_request *request);
void own_law_clear(struct own_law *law);
#define OWN_LAW(x) __attribute__((cleanup(own_law_clear))) struct own_law x = {0} /* cleared at the end of its block */

/* Returns STATUS_OK, or STATUS_USAGE after a message if the table does not cover these speeds. */
int own_law_check(const struct own_law *law, double speed_min, double speed_max);

/* Compute eps at a speed, limited to 1. own_law_eps encloses it. own_law_value returns a double with a relative error
 * of 1e-12 or an absolute error of 1e-300. */
void own_law_eps(arb_t eps, const struct own_law *law, const arb_t speed, slong prec);
double own_law_value(const struct own_law *law, double speed);

/* Computes the speed at which A v^-B is 1; not finite if no such speed exists */
void own_law_onset(arb_t speed, const struct own_law *law, slong prec);

/* own_law_row returns the row of a table at x = ln(speed); *end is the x at which the next row begins. Without a table
 * the row is 0 and *end is infinity. own_law_function encloses eps, not limited to 1, as a function of x on a row
 * (enclosed_function.h). */
slong own_law_row(double *end, const struct own_law *law, double x);
bool own_law_function(arb_poly_t eps, const arb_poly_t x, const struct own_law *law, slong row);

#endif
