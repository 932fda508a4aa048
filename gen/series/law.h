/* SPDX-License-Identifier: MIT */
/* The contact law x'' + beta x^b x' + x^a = 0, x(0) = 0, x'(0) = 1 (docs/theory.md, 1 and 9).
 * Everything that corgen computes is a function of the two rational exponents below. */
#ifndef COR_GEN_SERIES_LAW_H
#define COR_GEN_SERIES_LAW_H

#include <stdbool.h>

#include "cor/law.h"
#include "support/formula.h"
#include "support/local.h"

extern const struct cor_exponents law_sphere;

/* Return the exponents a and b. With x = w^denominator the law is polynomial. */
struct ratio law_elastic(const struct cor_exponents *law);
struct ratio law_damping(const struct cor_exponents *law);

/* Largest exponent, numerator and denominator that law_parse accepts. A larger a moves the singularity of the elastic
 * motion closer to the turning point, and the t-series then needs more terms. */
#define LAW_MAX_EXPONENT 24
#define LAW_MAX_NUMERATOR 64
#define LAW_MAX_DENOMINATOR 16

/* Reads "3/2", "1.5" or "2" for each exponent. Returns NULL, or a sentence that describes the error. */
const char *law_parse(struct cor_exponents *law, const char *elastic, const char *damping);

/* Returns the law itself if its denominator is above 1. Otherwise doubles its numerators and its denominator. */
struct cor_exponents law_even(const struct cor_exponents *law);

bool law_is_sphere(const struct cor_exponents *law);
bool law_equal(const struct cor_exponents *law, const struct cor_exponents *other);

/* Returns q = (2 b - a + 1)/(1 + a). beta is proportional to g^q. eps is independent of g iff q = 0, (12). */
struct ratio law_speed_exponent(const struct cor_exponents *law);

/* Returns n = q (a + 1) = 2 b - a + 1. With x = beta^(-2/n) z the law is z'' + z^b z' + z^a = 0 (docs/theory.md, 9). */
struct ratio law_fall_power(const struct cor_exponents *law);

/* Returns (a+1)/(b+1). With mu = beta^(-(a+1)/(b+1)) and x = beta^(-1/(b+1)) X the law is X'' + X^b X' + mu X^a = 0. */
struct ratio law_mu_power(const struct cor_exponents *law);

/* True if a > b: the force vanishes before the overlap. Otherwise the two ends of contact coincide. */
bool law_force_ends(const struct cor_exponents *law);

/* True if q = 0, that is b = (a-1)/2. Then u = x^((a+1)/2) obeys a linear equation. Examples: the linear dashpot (1, 0)
 * and Tsuji's law (3/2, 1/4). */
bool law_is_linear(const struct cor_exponents *law);

/* True if a = b, the law of Hunt and Crossley. */
bool law_is_hunt_crossley(const struct cor_exponents *law);

/* True if docs/theory.md, 9, proves that the force has only one maximum in a contact: b = 0 or 4 a b + a + b + 2
 * b^2 >= a^2. */
bool law_force_has_one_peak(const struct cor_exponents *law);

/* Returns k = (b+1)^(n/(b+1))/n, n > 0. At strong damping, loading affects unloading only by about exp(-k/mu). */
double law_forgetting(const struct cor_exponents *law);

/* Return scales to a few digits. law_elastic_time: tau_0 of (51). law_elastic_radius: the radius of convergence of the
 * elastic trajectory in units of tau_0. This is the smaller of 2 (the end of contact) and 1/cos(pi/(a+1)), where x'' =
 * x^a is singular. */
double law_elastic_time(const struct cor_exponents *law);
double law_elastic_radius(const struct cor_exponents *law);

/* ratio_text writes "3/2" or "2". ratio_power writes an exponent: "(3/2)", "(-1)" or "2". */
struct ratio_text {
    char text[48];
};
struct ratio_text ratio_text(struct ratio x);
struct ratio_text ratio_power(struct ratio x);

/* The equation of motion as text: "x'' + beta sqrt(x) x' + x^(3/2) = 0" */
struct law_text {
    char text[160];
};
struct law_text law_equation(const struct cor_exponents *law);

double ratio_double(struct ratio x);
void arb_set_upper(arb_t y, const mag_t m); /* sets the ball y to the exact number m */

#endif
