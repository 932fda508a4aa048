/* SPDX-License-Identifier: MIT */
/* Computes the series of the turning point, t_max = sum tau_k beta^k, x_max = sum y_k beta^k, (50)-(62), and from it
 * the restitution at both ends of contact (docs/theory.md, 4 and 5). */
#ifndef COR_GEN_SERIES_RESTITUTION_H
#define COR_GEN_SERIES_RESTITUTION_H

#include "series/law.h"

/* ---- turning_point.c ---- */

/* Computes the closed forms (51) for any a: y_0 = ((a+1)/2)^(1/(a+1)), tau_0 = y_0 B(1/(a+1), 1/2)/(a+1). */
void turning_point_elastic(arb_t y0, arb_t tau0, const struct cor_exponents *law, slong prec);

enum turning_point_verdict {
    TURNING_POINT_OK,
    TURNING_POINT_FEW_TERMS, /* the truncation of the t-series dominates the error */
    TURNING_POINT_FEW_BITS   /* rounding dominates the error */
};

/* Encloses y_k and tau_k, k = 0..order, from the t-series up to s^terms with prec bits. The intervals include the
 * truncation error. If their relative accuracy is below `bits` bits, the result names the number to increase. */
enum turning_point_verdict turning_point_series(arb_poly_t y, arb_poly_t tau, slong order, slong terms,
                                                const struct cor_exponents *law, slong bits, slong prec);

/* ---- restitution.c ---- */

/* Computes C_k, k = 0..order, of eps = sum C_k beta^k at zero overlap. With Y = sum y_k beta^k, eps is the E(beta) with
 * E(0) = 1 and E^(2/(1+a)) Y(-beta E^q) = Y(beta), which is (63) for any law. */
void restitution_zero_overlap(arb_poly_t c, const arb_poly_t y, slong order, const struct cor_exponents *law,
                              slong prec);

/* Computes eps^power up to beta^(n-1) from eps = sum C_k beta^k at zero overlap. The coefficient of
 * restitution_exact_zero() is set to an exact 0. */
void restitution_power(arb_poly_t z, const arb_poly_t eps, struct ratio power, const struct cor_exponents *law, slong n,
                       slong prec);

/* Returns the k > 0 for which the coefficient of beta^k in eps^power is exactly 0 by the involution beta -> -h. It is
 * -2 power/q if that is an even positive integer. Otherwise returns 0. */
slong restitution_exact_zero(struct ratio power, const struct cor_exponents *law);

/* Computes G and T up to w^order with exact coefficients. With h = beta eps_zero_overlap^q and w = h^((a+1)/(a-b)),
 * eps_zero_force = eps_zero_overlap G(w), and the force vanishes at backward time h^(1/(a-b)) T(w). For a <= b the
 * force vanishes only together with the overlap: G = 1, T = 0. */
void restitution_zero_force_exact(fmpq_poly_t G, fmpq_poly_t T, slong order, const struct cor_exponents *law);

/* Returns the smallest root for which eps_zero_force is a series in beta^(1/root). w = beta^(p/root) times a series. */
slong restitution_zero_force_root(const struct cor_exponents *law);

/* Computes eps_zero_force up to z^order, z = beta^(1/root), from C_0..C_(order/root). */
void restitution_zero_force(arb_poly_t eps, const arb_poly_t c, slong order, const struct cor_exponents *law,
                            slong prec);

#endif
