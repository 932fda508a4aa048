/* SPDX-License-Identifier: MIT */
/* The sphere with damping during the approach only, from its largest overlap Y (runtime/core/hertz_approach_only.h). */
#include "cor/sphere.h"
#include "runtime/core/hertz_approach_only.h"
#include "runtime/number/environment.h"
#include "runtime/sphere/eval.h"
#include "runtime/sphere/float_exceptions.h"

/* 1 - eps = a_1 beta + a_2 beta^2 + ..., beta < 1/16: from (Y/Y_0)^(5/4) with Y = sum y_k beta^k as `corgen series`
 * prints it; a_1 = |C_1|/2. The omitted terms are below 2^-63 of the first one. */
#define SPHERE_LOSS_END 0.0625
#define SPHERE_LOSS_FIRST 5.76724429047644399565e-01
#define SPHERE_LOSS_FIRST_TAIL (-2.72725649217512272651e-17)
static const double sphere_loss[] = {
    -0.357996875477300856206957,   0.228227166486789627332456,    -0.1479010467748215453820562,
    0.09699205237612851587977732,  -0.06419780183731598014841568, 0.04281135700459568726536033,
    -0.02872776921365397029640947, 0.01937909219602718423407543,  -0.01313197791512802216717732,
    0.008933760024851350510757242, -0.0060986902633595910371795,  0.004176038942461575602135091,
    -0.00286730685217634081146152,
};

/* (1 - eps)/beta, beta < SPHERE_LOSS_END */
static struct cor_inline_pair loss_per_beta(double beta)
{
    double sum = 0;
    for (int k = (int)(sizeof sphere_loss / sizeof *sphere_loss) - 1; k >= 0; k--)
        sum = sphere_loss[k] + beta * sum;
    return cor_inline_sum(SPHERE_LOSS_FIRST, SPHERE_LOSS_FIRST_TAIL + beta * sum);
}

/* Row i of the table of Y, and beta minus its node */
struct overlap_place {
    const double *row;
    double t;
};

static struct overlap_place overlap_place(double beta)
{
    const struct cor_inline_grid grid = COR_INLINE_GRID(COR_ROWS_MAX_OVERLAP);
    const int i = cor_inline_grid_row(grid, beta);
    const struct overlap_place place = {cor_rows_max_overlap(i), cor_inline_grid_t(grid, beta, i)};
    return place;
}

/* c_2 + c_3 t + ... of a row c_0 + c_0' + t (c_1 + t (...)) */
static double overlap_curvature(struct overlap_place place)
{
    double sum = 0;
    for (int k = COR_INLINE_COLUMNS - 1; k >= 3; k--)
        sum = place.row[k] + place.t * sum;
    return sum;
}

/* Y for beta below the end of the table. c_1 t is exact, so that 1 - eps has the accuracy of the table. */
static struct cor_inline_pair overlap_near(double beta)
{
    const struct overlap_place place = overlap_place(beta);
    const struct cor_inline_pair slope = cor_inline_product(place.row[2], place.t);
    const struct cor_inline_pair sum = cor_inline_sum(place.row[0], slope.hi);
    const double rest = place.t * place.t * overlap_curvature(place);
    return cor_inline_sum(sum.hi, sum.lo + (place.row[1] + slope.lo + rest));
}

/* Y for finite beta beyond the table */
static struct cor_inline_pair overlap_far(double beta)
{
    int exponent;
    const struct cor_inline_pair value =
        cor_inline_power_parts(beta, COR_INLINE_LOG_FACTOR(beta, max_overlap, COR_ROWS_TAIL_MAX_OVERLAP), 0, &exponent);
    return cor_pair_scaled(value, cor_kernel_power_of_two(exponent));
}

static struct cor_inline_pair overlap(double beta)
{
    return beta < COR_ROWS_MAX_OVERLAP_END ? overlap_near(beta) : overlap_far(beta);
}

static double eps_approach_only(double beta)
{
    if (!(beta >= 0))
        return NAN;
    return isinf(beta) ? 0 : cor_hertz_eps_approach_only(overlap(beta)).hi;
}

static double loss_approach_only(double beta)
{
    if (!(beta >= 0))
        return NAN;
    if (beta < SPHERE_LOSS_END) { /* units of 2^-200 for a tiny beta, so that the product loses no bits */
        const double unit = beta < COR_INLINE_2_M500 ? COR_INLINE_2_M200 : 1, scale = unit < 1 ? COR_INLINE_2_200 : 1;
        const struct cor_inline_pair scaled = cor_pair(beta * scale, 0);
        return cor_inline_pair_times(loss_per_beta(beta), scaled).hi * unit;
    }
    if (isinf(beta))
        return 1;
    const struct cor_inline_pair eps = cor_hertz_eps_approach_only(overlap(beta));
    return (1 - eps.hi) - eps.lo;
}

/* beta = loss/quotient, until the quotient no longer changes */
static double beta_of_small_loss(struct cor_inline_pair loss)
{
    double beta = loss.hi / SPHERE_LOSS_FIRST;
    for (int k = 0; k < 20; k++) {
        const double next = loss.hi / loss_per_beta(beta).hi, step = next - beta;
        beta = next;
        if (fabs(step) <= 1e-17 * beta)
            break;
    }
    return cor_pair_over(loss, loss_per_beta(beta)).hi;
}

/* beta from eps by Newton's method. The start is the row of Y that contains beta; beyond the rows the method uses that
 * eps beta^(5/6) changes little. The residual is computed with pairs. */
static double beta_of_eps(struct cor_inline_pair eps)
{
    const double wanted = cor_hertz_overlap_of_eps(eps.hi);
    int low = 0, high = COR_ROWS_MAX_OVERLAP_ROWS - 1;
    const int far = wanted < cor_rows_max_overlap(high)[0];
    while (!far && high - low > 1) {
        const int middle = (low + high) / 2;
        if (cor_rows_max_overlap(middle)[0] >= wanted)
            low = middle;
        else
            high = middle;
    }
    double beta = COR_ROWS_MAX_OVERLAP_FIRST + (low + 0.5) * COR_ROWS_MAX_OVERLAP_STEP;
    if (far) { /* Y is about (3/2)^(2/3) beta^(-2/3) */
        const double log_y = -cor_kernel_minus_log(cor_pair(wanted, 0)).hi;
        beta = 1.5 * cor_kernel_exp_minus_pair(cor_pair(0.75 * log_y, 0)).hi;
        beta = beta * cor_kernel_exp_minus_pair(cor_pair(0.75 * log_y, 0)).hi;
    }
    for (int k = 0; k < 40; k++) {
        const struct cor_inline_pair y = overlap(beta), at = cor_hertz_eps_approach_only(y);
        const double off = ((at.hi - eps.hi) + (at.lo - eps.lo)) / eps.hi;
        double slope = 1.2; /* -d ln(beta)/d ln(eps) */
        if (beta < COR_ROWS_MAX_OVERLAP_END) {
            const struct overlap_place place = overlap_place(beta);
            double derivative = 0;
            for (int n = COR_INLINE_COLUMNS - 1; n >= 2; n--)
                derivative = (n - 1) * place.row[n] + place.t * derivative;
            slope = -0.8 * y.hi / (derivative * beta);
        }
        beta += beta * (off * slope);
        if (fabs(off) < (beta < COR_ROWS_MAX_OVERLAP_END ? 1e-9 : 1e-15)) /* the slope 1.2 is wrong by some percent */
            break;
    }
    return beta;
}

/* eps and 1 - eps, both as pairs, 2^-500 < loss */
static double beta_of_pairs(struct cor_inline_pair eps, struct cor_inline_pair loss)
{
    return loss.hi < 0.03 ? beta_of_small_loss(loss) : beta_of_eps(eps);
}

/* Below this eps, beta is beyond the largest double. */
#define SPHERE_LEAST_EPS 1.65713570994383150e-257

static double beta_approach_only(double eps)
{
    if (!(eps >= 0 && eps <= 1))
        return NAN;
    if (eps < SPHERE_LEAST_EPS)
        return INFINITY;
    const double loss = 1 - eps;
    return eps == 1 ? 0 : beta_of_pairs(cor_pair(eps, 0), cor_pair(loss, (1 - loss) - eps));
}

static double beta_of_loss_approach_only(double loss)
{
    if (!(loss >= 0 && loss <= 1))
        return NAN;
    if (loss < COR_INLINE_2_M500) /* in units of 2^-200, so that the quotient's remainder loses no bits */
        return beta_of_small_loss(cor_pair(loss * COR_INLINE_2_200, 0)) * COR_INLINE_2_M200;
    const double eps = 1 - loss;
    return loss == 1 ? INFINITY : beta_of_pairs(cor_pair(eps, (1 - eps) - loss), cor_pair(loss, 0));
}

static double duration_approach_only(double beta)
{
    if (!(beta >= 0))
        return NAN;
    if (isinf(beta))
        return INFINITY;
    return cor_hertz_duration_approach_only(overlap(beta), cor_inline_time_of_max_overlap(beta));
}

#define SPHERE_APPROACH_ONLY(quantity)                                                                                 \
    static float quantity##_approach_onlyf(float x)                                                                    \
    {                                                                                                                  \
        static const struct cor_float_exception exception = COR_FLOAT_EXCEPTION_##quantity##_approach_only;            \
        return cor_float_corrected(exception, x, (float)quantity##_approach_only((double)x));                          \
    }                                                                                                                  \
    COR_IN_ENVIRONMENT(double, cor_sphere_##quantity##_approach_only, quantity##_approach_only, (double x), (x))       \
    COR_IN_ENVIRONMENT(float, cor_sphere_##quantity##_approach_onlyf, quantity##_approach_onlyf, (float x), (x))       \
    COR_ARRAY_IN_ENVIRONMENT(double, cor_sphere_##quantity##_approach_only_array, quantity##_approach_only)            \
    COR_ARRAY_IN_ENVIRONMENT(float, cor_sphere_##quantity##_approach_only_arrayf, quantity##_approach_onlyf)

SPHERE_APPROACH_ONLY(eps)
SPHERE_APPROACH_ONLY(loss)
SPHERE_APPROACH_ONLY(beta)
SPHERE_APPROACH_ONLY(beta_of_loss)
SPHERE_APPROACH_ONLY(duration)
