/* SPDX-License-Identifier: MIT */
/* The probability distributions of the fits: normal, Student's t, chi squared, Fisher's F. */
#ifndef COR_GEN_FIT_DISTRIBUTION_H
#define COR_GEN_FIT_DISTRIBUTION_H

#include <stddef.h>

/* The two probabilities of the intervals: 68 % means P(|Z| < 1) of a normal Z, 0.6827. */
enum distribution_level { LEVEL_68, LEVEL_95, LEVELS };

/* The z with P(|Z| < z) = level for a normal Z, and the t with P(|T| < t) = level for Student's T with that many
 * degrees of freedom, at least 1. Relative error below 1e-8, compared with FLINT's incomplete beta function. */
double normal_quantile(enum distribution_level level);
double student_quantile(enum distribution_level level, size_t degrees_of_freedom);

/* P(X >= chi2) of chi squared with that many degrees of freedom, at least 1 */
double chi_squared_tail(double chi2, size_t degrees_of_freedom);

/* P(F >= f) of Fisher's F with so many degrees of freedom of the numerator and the denominator, at least 1. Beyond
 * 10,000 of the denominator: of chi squared, f times those of the numerator; relative error then below 1 % where the
 * probability exceeds 1e-3. */
double fisher_tail(double f, size_t numerator, size_t denominator);

#endif
