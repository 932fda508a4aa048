/* SPDX-License-Identifier: MIT */
/* The turning point: t_max = sum tau_k beta^k, x_max = sum y_k beta^k, (50)-(62). */
#ifndef COR_GEN_SERIES_TURNING_POINT_H
#define COR_GEN_SERIES_TURNING_POINT_H

#include "series/law.h"

/* Closed forms (51) for any a: y_0 = ((a+1)/2)^(1/(a+1)), tau_0 = y_0 B(1/(a+1), 1/2)/(a+1). */
void turning_point_elastic(arb_t y0, arb_t tau0, const struct law *law, slong prec);

enum turning_point_verdict {
    TURNING_POINT_OK,
    TURNING_POINT_FEW_TERMS, /* the truncation of the t-series dominates the error */
    TURNING_POINT_FEW_BITS   /* rounding dominates the error */
};

/* Encloses y_k and tau_k, k = 0..order, from the t-series up to s^terms with prec bits; the intervals include the
 * truncation error. If the intervals are wider than `bits` relative bits, the verdict names the number to raise. */
enum turning_point_verdict turning_point_series(arb_poly_t y, arb_poly_t tau, slong order, slong terms,
                                                const struct law *law, slong bits, slong prec);

#endif
