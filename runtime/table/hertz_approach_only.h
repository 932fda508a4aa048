/* SPDX-License-Identifier: MIT */
/* Damping during the approach only, for any law with Hertz's elastic force. The approach follows the full law and the
 * rebound is elastic, so eps^2/2 = (2/5) Y^(5/2) with the largest overlap Y of the full law. */
#ifndef COR_RUNTIME_TABLE_HERTZ_APPROACH_ONLY_H
#define COR_RUNTIME_TABLE_HERTZ_APPROACH_ONLY_H

#include "runtime/number/elementary.h"
#include "runtime/number/environment.h"
#include "runtime/table/law.h"
#include "runtime/table/row_loops.h"

/* sqrt(4/5) = (4/5)^(1/2) and (4/5)^(-1/10) as pairs */
#define COR_HERTZ_SPEED 8.94427190999915855407e-01
#define COR_HERTZ_SPEED_TAIL 2.31564598480493453558e-17
#define COR_HERTZ_TIME 1.02256518256357287200
#define COR_HERTZ_TIME_TAIL 5.54898733737113814765e-17
/* Half of the elastic duration, X_0 sqrt(pi) Gamma(7/5)/Gamma(9/10) */
#define COR_HERTZ_HALF_DURATION 1.60903272985952150442
#define COR_HERTZ_HALF_DURATION_TAIL 3.78449505742605387477e-17

/* Returns eps = sqrt(4/5) Y^(5/4). */
COR_INLINE struct cor_inline_pair cor_hertz_eps_approach_only(struct cor_inline_pair overlap)
{
    const struct cor_inline_pair fourth_root = cor_pair_root(cor_pair_root(overlap));
    const struct cor_inline_pair power = cor_inline_pair_times(overlap, fourth_root);
    return cor_inline_pair_times(power, cor_pair(COR_HERTZ_SPEED, COR_HERTZ_SPEED_TAIL));
}

/* Returns the overlap Y of an eps, (5/4)^(2/5) eps^(4/5), with a few rounding errors. */
COR_INLINE double cor_hertz_overlap_of_eps(double eps)
{
    const struct cor_inline_pair l = cor_kernel_minus_log(cor_pair(eps, 0));
    return 1.09336207394327805637 * cor_kernel_exp_minus_pair(cor_pair(0.8 * l.hi, 0)).hi;
}

/* Returns the duration: the time of the largest overlap plus the time of the elastic rebound. The rebound to the speed
 * eps takes half of the elastic duration times eps^(-1/5) = (4/5)^(-1/10) Y^(-1/4). */
COR_INLINE double cor_hertz_duration_approach_only(struct cor_inline_pair overlap, double time_of_max_overlap)
{
    const struct cor_inline_pair fourth_root = cor_pair_root(cor_pair_root(overlap));
    const struct cor_inline_pair half = cor_inline_pair_times(
        cor_pair(COR_HERTZ_HALF_DURATION, COR_HERTZ_HALF_DURATION_TAIL), cor_pair(COR_HERTZ_TIME, COR_HERTZ_TIME_TAIL));
    return cor_pair_plus(cor_pair_over(half, fourth_root), cor_pair(time_of_max_overlap, 0)).hi;
}

/* ---- functions by rows ----
 *
 * A law whose rows of eps, loss, duration and the inverse start at 0. Functions with an argument of this type must be
 * inlined, so that the argument is a constant of each caller. */
struct cor_hertz_law {
    struct cor_row_table eps, loss, duration, beta;
    struct cor_inline_pair (*overlap)(double beta, int *fourth); /* returns Y 2^(-4 *fourth) where beta has no row */
    double (*time_of_max_overlap)(double beta);
};

static inline double cor_hertz_eps_beyond(const void *of, double beta)
{
    const struct cor_hertz_law *const law = of;
    if (cor_inline_is_refused(beta))
        return NAN;
    if (beta < 1 || isinf(beta)) /* beta < 2^-60, where a row that is rounded upward may exceed 1 */
        return beta < 1;
    int fourth;
    const struct cor_inline_pair eps = cor_hertz_eps_approach_only(law->overlap(beta, &fourth));
    return fourth ? cor_inline_pair_scaled(eps, 5 * fourth) : eps.hi;
}

COR_KERNEL double cor_hertz_eps(const struct cor_hertz_law *law, double beta)
{
    if (cor_inline_between(beta, COR_INLINE_2_M60, law->eps.end))
        return cor_inline_row_value(cor_row_near(&law->eps, beta));
    return cor_in_environment_with(cor_hertz_eps_beyond, law, beta);
}

static inline double cor_hertz_loss_beyond(const void *of, double beta)
{
    const struct cor_hertz_law *const law = of;
    if (cor_inline_is_refused(beta))
        return NAN;
    if (cor_inline_is_zero(beta) || isinf(beta))
        return beta > 0;
    int fourth;
    struct cor_inline_pair eps = cor_hertz_eps_approach_only(law->overlap(beta, &fourth));
    if (fourth < -40)
        return 1;
    if (fourth)
        eps = cor_pair_scaled(eps, ldexp(1, 5 * fourth));
    return (1 - eps.hi) - eps.lo;
}

COR_KERNEL double cor_hertz_loss(const struct cor_hertz_law *law, double beta)
{
    if (cor_inline_below(beta, law->loss.end))
        return cor_inline_law_product(cor_row_near(&law->loss, beta), beta);
    return cor_in_environment_with(cor_hertz_loss_beyond, law, beta);
}

static inline double cor_hertz_duration_beyond(const void *of, double beta)
{
    const struct cor_hertz_law *const law = of;
    if (cor_inline_is_refused(beta))
        return NAN;
    if (isinf(beta))
        return INFINITY;
    int fourth; /* Y = overlap 16^fourth, and the duration of the rebound has the factor Y^(-1/4) */
    const struct cor_inline_pair overlap = law->overlap(beta, &fourth);
    const double time = law->time_of_max_overlap(beta);
    return fourth ? ldexp(cor_hertz_duration_approach_only(overlap, ldexp(time, fourth)), -fourth)
                  : cor_hertz_duration_approach_only(overlap, time);
}

COR_KERNEL double cor_hertz_duration(const struct cor_hertz_law *law, double beta)
{
    if (cor_inline_below(beta, law->duration.end) || cor_inline_is_zero(beta))
        return cor_inline_row_value(cor_row_near(&law->duration, beta));
    return cor_in_environment_with(cor_hertz_duration_beyond, law, beta);
}

/* Returns beta for 0 <= loss <= 1/2. */
COR_KERNEL double cor_hertz_beta_near(const struct cor_hertz_law *law, double loss)
{
    return cor_inline_law_product(cor_row_near(&law->beta, loss), loss);
}

/* Returns beta of any loss. beta_of_eps: the inverse for every eps. */
COR_KERNEL double cor_hertz_beta_of_loss(const struct cor_hertz_law *law, double (*beta_of_eps)(double eps),
                                         double loss)
{
    if (cor_inline_below(loss, 0x1.0000000000001p-1)) /* 1/2, too */
        return cor_hertz_beta_near(law, loss);
    if (cor_inline_is_zero(loss))
        return 0;
    return cor_inline_is_refused(loss) ? (double)NAN : beta_of_eps(1 - loss); /* exact from 1/2 to 1 */
}

#endif
