/* SPDX-License-Identifier: MIT */
/* The fit of one curve to measured restitution, and profile-likelihood intervals of its coordinates.
 *
 * The objective is Q(theta) = sum of rho(r_i/s_i), r_i = eps_i - eps(g_i). In least squares rho(z) = z^2. The robust
 * fit takes Huber's rho, which is z^2 for |z| <= c and 2c|z| - c^2 beyond, with c = FIT_HUBER (95 % efficiency for
 * normal errors). s_i is the given standard deviation. If the file has none, s is a common unknown scale: in least
 * squares s^2 = Q/(n - k) for n points and k parameters; in the robust fit s is the median of |r_i| over its normal
 * value 0.6745, times sqrt(n/(n - k)).
 *
 * Of bounces the times are fitted. Time t_i has an independent error of standard deviation s, and eps of a bounce
 * scatters by s sqrt(lambda) about the curve. y_k = T_(k+1) - T_k eps(g T_k/2), in the measured flights, is free of the
 * first time and the first speed of a drop; to first order in the errors, with a_k = d[T eps(g T/2)]/dT at T_k,
 *
 *     y_k = e_(k+2) - (1 + a_k) e_(k+1) + a_k e_k + T_k h_k,    cov y = s^2 (B + lambda diag T_k^2) = s^2 W
 *
 * with a band B. z = L^-1 y for W = L L^T takes the place of r, times sqrt(det W/det B)^(1/n), so that the least Q is
 * that of the restricted likelihood over lambda, too; the robust fit takes the lambda of the least scale.
 *
 * The interval of a coordinate holds the values at which the least Q over the other coordinates exceeds the minimum by
 * at most z^2 (s_i given), or t^2 s^2 with Student's t of n - k degrees of freedom (s unknown). In the robust fit that
 * threshold is multiplied by Huber's factor [sum psi^2/(n - k)]/[sum psi'/n], psi = rho'/2.
 *
 * A curve is judged by p_value (docs/fit.md, "Verdict"). With given s_i, p_value is the tail of chi^2 with n - k
 * degrees of freedom. Without them, and in the robust fit, where psi(r_i/s_i) takes the place of r_i, it is the tail of
 * Fisher's F of m = n/3 groups of neighbours, at least k + 1 and at most FIT_MAX_GROUPS, for
 *
 *     [sum over groups n_j mean_j^2/(m - k)]/[sum (r_i - mean_j)^2/(n - m)] */
#ifndef COR_GEN_FIT_LIKELIHOOD_H
#define COR_GEN_FIT_LIKELIHOOD_H

#include "fit/data.h"
#include "fit/models.h"

/* ---- distribution.c: the normal one, Student's t, chi squared, Fisher's F ---- */

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

/* ---- fits ---- */

#define FIT_HUBER 1.345
enum { FIT_MAX_GROUPS = 12 };
#define FIT_SIGNIFICANCE 0.01 /* a curve with a smaller p value does not fit */

struct fit_interval {
    double low, high; /* of theta; an infinity where the range of theta ends before the interval */
};

struct fit_estimate {
    enum fit_curve curve;
    int parameters;
    bool fitted; /* false: fewer points than parameters and one more */
    double theta[FIT_MAX_PARAMETERS];
    struct fit_interval interval[FIT_MAX_PARAMETERS][LEVELS];
    double rms;  /* of the residuals, each of weight 1 */
    double chi2; /* sum (r_i/s_i)^2 with the given s_i; NAN if the file has none */
    double aic;
    double p_value;      /* probability of a misfit as large as this one if the curve is right; NAN: too few points */
    bool p_of_chi2;      /* p_value is that of chi2; otherwise that of the means of groups, see below */
    double scale;        /* s; NAN if the s_i are given. Of bounces times the root of the determinants */
    double ratio;        /* lambda, 1/s^2; 0 unless the points are bounces */
    double time_sigma_s; /* of bounces: s */
};

/* The distances of all points from the curve in standard deviations, (eps_i - eps(g_i))/s_i; of bounces those of their
 * times: the error of a time over its standard deviation, as the bounces of its drop from that time on determine it.
 */
struct fit_distance {
    long line;
    double distance;
};
size_t fit_lines(const struct fit_data *data); /* their number */
void fit_distances(struct fit_distance *distance, const struct fit_estimate *estimate, const struct fit_data *data);

/* Fits one curve; everything but `aic`, which depends on the other curves. */
void fit_estimate_curve(struct fit_estimate *estimate, enum fit_curve curve, const struct fit_data *data, bool robust);

/* AIC up to a constant that all curves share. With given s_i: Q + 2k. Without: n ln(Q/n) + 2(k + 1) with s_i = 1; in
 * the robust fit Q + 2k at the scale and lambda of `best`, the curve of the least scale. */
double fit_aic(const struct fit_estimate *estimate, const struct fit_data *data, bool robust,
               const struct fit_estimate *best);

#endif
