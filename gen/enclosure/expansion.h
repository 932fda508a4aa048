/* SPDX-License-Identifier: MIT */
/* Taylor models in two small variables a and b: a polynomial and a bound of what it lacks. The model of f is
 *
 *     |f - sum c_ij(z) a^i b^j| <= rest,   i + j <= EXPANSION_ORDER,   |a| <= a_0, |b| <= b_0, 0 <= z <= 1,
 *
 * where each c_ij is a polynomial in z of length EXPANSION_LENGTH at most, with intervals as coefficients. The bound
 * holds at every point of the domain. Sums, products and power series of models bound all terms that they leave out. */
#ifndef COR_GEN_ENCLOSURE_EXPANSION_H
#define COR_GEN_ENCLOSURE_EXPANSION_H

#include <stdbool.h>

#include "support/formula.h"
#include "support/local.h"

enum {
    EXPANSION_ORDER = 4,
    EXPANSION_TERMS = (EXPANSION_ORDER + 1) * (EXPANSION_ORDER + 2) / 2,
    EXPANSION_LENGTH = 96,
    EXPANSION_BITS = 192
};

/* a_0 and b_0 */
struct expansion_domain {
    mag_t a, b;
};

struct expansion {
    const struct expansion_domain *domain; /* must live as long as the model */
    arb_poly_struct c[EXPANSION_TERMS];
    mag_t rest;
};

void expansion_init(struct expansion *x, const struct expansion_domain *domain);
void expansion_clear(struct expansion *x);

/* LOCAL_EXPANSION(domain, x, y) declares models over a domain, which the end of their block clears. */
typedef struct expansion expansion_struct, expansion_t[1];
static inline struct expansion expansion_local(const struct expansion_domain *domain)
{
    struct expansion x;
    expansion_init(&x, domain);
    return x;
}
static inline void expansion_local_clear(expansion_t *x)
{
    expansion_clear(*x);
}
#define EXPANSIONS_INIT(domain, ...)                                                                                   \
    do {                                                                                                               \
        struct expansion *const all_[] = {__VA_ARGS__};                                                                \
        for (size_t i_ = 0; i_ < sizeof all_ / sizeof *all_; i_++)                                                     \
            expansion_init(all_[i_], domain);                                                                          \
    } while (0)
#define LOCAL_EXPANSION(domain, ...) LOCAL_FROM(expansion, expansion_local(domain), __VA_ARGS__)

void expansion_zero(struct expansion *x);
void expansion_set(struct expansion *y, const struct expansion *x);

/* c_ij, to be changed or read */
arb_poly_struct *expansion_term(struct expansion *x, slong i, slong j);
const arb_poly_struct *expansion_term_of(const struct expansion *x, slong i, slong j);

/* Adds c to the constant of c_ij, and a bound to the rest. */
void expansion_add_number(struct expansion *x, slong i, slong j, const arb_t c);
void expansion_add_rest(struct expansion *x, const mag_t bound);

/* Bounds of the terms of a degree in a and b, and of the whole model with its rest */
void expansion_norm_of_degree(mag_t bound, const struct expansion *x, slong degree);
void expansion_norm(mag_t bound, const struct expansion *x);

/* The results may be the arguments. */
void expansion_add(struct expansion *z, const struct expansion *x, const struct expansion *y);
void expansion_sub(struct expansion *z, const struct expansion *x, const struct expansion *y);
void expansion_scale(struct expansion *y, const struct expansion *x, const arb_t c);
void expansion_multiply(struct expansion *z, const struct expansion *x, const struct expansion *y);
void expansion_times_a(struct expansion *y, const struct expansion *x, slong power);

/* sum_k coefficient[k] x^k, k <= EXPANSION_ORDER, of a power series without a later coefficient above 1. c_00 of x,
 * which should be a rounding error, joins its rest. The rest of the result is infinite unless |x| < 1. */
void expansion_series(struct expansion *y, const struct expansion *x, arb_srcptr coefficient);

/* (1 + x)^(p/q) by expansion_series, |p/q| <= 1 */
void expansion_power(struct expansion *y, const struct expansion *x, slong p, slong q);

/* y = x(a, tau, e): replaces b and z. tau and e are models over the domain of y, and e has no constant term. The rest
 * is infinite if their values leave the domain of x. */
void expansion_substitute(struct expansion *y, const struct expansion *x, const struct expansion *tau,
                          const struct expansion *e);

/* Encloses a fixed point x = map(x), where x is a first approximation. `map` must be continuous, enclose the images of
 * all values of its argument, and correct one degree of its argument each time. Returns false if the proof, that the
 * map takes an enclosure to itself, fails. */
typedef void expansion_map(struct expansion *y, const struct expansion *x, void *context);
bool expansion_fixed_point(struct expansion *x, expansion_map *map, void *context);

#endif
