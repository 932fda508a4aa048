/* SPDX-License-Identifier: MIT */
/* The quasistatic contact law of the disk. With q = ln(limit/argument) and t - ln(1 + t) = q (lambert_w.h) the law is
 *
 *     P = pi delta/(1 + t)               q = ln(delta_limit/delta)
 *     delta = (P/pi) (1 + t)             t = ln(P_limit/P)
 *     V = P^2/(2 pi) (1/2 + t)           t = ln(P_limit/P)
 *     P = sqrt(4 pi V/(1 + t))           q = ln(V_limit/V)
 *     P = sqrt(2) pi v/sqrt(1 + t)       q = 2 ln(v_limit/v),     delta = sqrt(2) v (1 + t/2)/sqrt(1 + t)
 *
 * Nothing cancels here. For small q, t is near sqrt(2 q). Close to the limit q must therefore be more accurate than a
 * double, and the limits are pairs. Far from the limit their logarithms, which are linear in nu, suffice. */
#include "runtime/disk/quasistatic.h"

#include "runtime/number/elementary.h"
#include "runtime/number/lambert_w.h"

typedef struct cor_inline_pair pair;

static const pair pi = {COR_PI, COR_PI_TAIL};
static const pair half_pi = {COR_PI / 2, COR_PI_TAIL / 2};
static const pair four_pi = {4 * COR_PI, 4 * COR_PI_TAIL};
static const pair one_over_pi = {0.318309886183790691, -1.96786766751824859e-17};
static const pair one_over_two_pi = {0.159154943091895346, -9.83933833759124294e-18};
static const pair root_2 = {1.41421356237309515, -9.66729331345291345e-17};
static const pair root_2_pi = {4.4428829381583661, 1.4522739312260849e-16};
static const pair not_a_number = {NAN, 0};

/* ---- pairs ---- */

/* Returns sqrt(x); 0 -> 0. */
static pair pair_sqrt(pair x)
{
    if (x.hi == 0)
        return x;
    const pair root = cor_pair_root(x);
    return cor_inline_sum(root.hi, root.lo);
}

/* Returns exp(x), |x| < 2, with relative error 2^-101. The map s -> 2 s + s^2, applied nine times to the power series
 * of exp(x/2^9) - 1, gives exp(x) - 1. */
static pair pair_exp(double x)
{
    static const pair one_over_factorial[] = {{1, 0},
                                              {0.5, 0},
                                              {0.166666666666666657, 9.25185853854297066e-18},
                                              {0.0416666666666666644, 2.31296463463574266e-18},
                                              {0.00833333333333333322, 1.15648231731787138e-19},
                                              {0.00138888888888888894, -5.30054395437357706e-20}};
    const double r = x / 512;
    const double rest = r * (1.0 / 5040 + r * (1.0 / 40320 + r * (1.0 / 362880 + r * (1.0 / 3628800))));
    pair s = cor_pair(rest, 0);
    for (int i = 5; i >= 0; i--)
        s = cor_inline_pair_times(cor_pair_plus(one_over_factorial[i], s), cor_pair(r, 0));
    for (int i = 0; i < 9; i++) {
        s = cor_pair_plus(cor_pair_scaled(s, 2), cor_inline_pair_times(s, s));
    }
    return cor_pair_plus(cor_pair(1, 0), s);
}

/* Returns x f, rounded once, even if the product is subnormal; NaN if f is NaN. */
static double times_pair(double x, pair f)
{
    if (cor_inline_is_refused(f.hi))
        return NAN;
    const double unit = x < COR_INLINE_2_M900 ? COR_INLINE_2_M200 : 1;
    if (x < COR_INLINE_2_M900)
        x *= COR_INLINE_2_200;
    const pair product = cor_inline_product(x, f.hi);
    return (product.hi + (product.lo + x * f.lo)) * unit;
}

/* Returns x^2 f. */
static double square_times(double x, pair f)
{
    if (cor_inline_is_refused(f.hi))
        return NAN;
    if (!(x < COR_INLINE_2_M200)) {
        const pair product = cor_inline_pair_times(cor_inline_product(x, x), f);
        return product.hi + product.lo;
    }
    x *= COR_INLINE_2_500;
    const pair product = cor_inline_pair_times(cor_inline_product(x, x), f);
    return product.hi * COR_INLINE_2_M500 * COR_INLINE_2_M500;
}

/* ---- limits ---- */

enum quantity { COMPRESSION, LOAD, SPEED, ENERGY };

/* A limit is at_zero.number exp(exponent), and its logarithm is at_zero.log + exponent. */
struct limit {
    struct cor_logarithm at_zero;
    double exponent; /* slope nu */
};

/* Finds a limit. Returns 0 if nu is outside its domain or the datum does not exist. at_zero: limits at nu = 0, for the
 * centre of mass (exp(b - 1) is exp(-5/4)/4) and for the other data (exp(-2)). */
static int find_limit(enum quantity quantity, double nu, enum cor_disk_datum datum, struct limit *limit)
{
    static const struct cor_logarithm at_zero[4][2] = {
        {{{0.286504796860190092, 8.47983007760764371e-18}, {-1.25, 0}},
         {{0.541341132946450809, -4.16952569315467595e-17}, {-0.613705638880109428, 4.63809362769259912e-17}}},
        {{{0.900081365034209324, -4.48326081344595376e-17}, {-0.105270114150599822, -3.61183664510663038e-18}},
         {{1.70067332635054536, -4.19664535413403417e-17}, {0.531024246969290847, -5.43754150228818365e-17}}},
        {{{0.202589484702314693, -3.27135359085663891e-18}, {-1.5965735902799727, 4.39159171620263277e-17}},
         {{0.382785986041643711, -1.51544099505634689e-17}, {-0.960279229160082015, -2.07254490235633321e-17}}},
        {{{0.0644694071616921799, 5.68575250841498294e-18}, {-2.74156447527049041, -3.61149851142181648e-17}},
         {{0.230161106314603292, 8.96601817150281698e-18}, {-1.46897575303070926, 5.66468874396338237e-17}}}};
    if (!cor_inline_below(fabs(nu), 1))
        return 0;
    double slope;
    switch ((int)datum) {
    case COR_DISK_DATUM_CENTRE_OF_MASS:
        slope = -0.25;
        break;
    case COR_DISK_DATUM_DIAMETER:
        slope = 0;
        break;
    case COR_DISK_DATUM_PRINTED:
        slope = -1;
        break;
    default:
        return 0;
    }
    limit->at_zero = at_zero[quantity][datum != COR_DISK_DATUM_CENTRE_OF_MASS];
    limit->exponent = (quantity == ENERGY ? 2 * slope : slope) * nu;
    return 1;
}

static pair limit_number(const struct limit *limit)
{
    if (limit->exponent == 0)
        return limit->at_zero.number;
    return cor_inline_pair_times(limit->at_zero.number, pair_exp(limit->exponent));
}

/* Returns the largest double that does not exceed a positive number. */
static double largest_double(pair x)
{
    return x.lo >= 0 ? x.hi : cor_inline_from_bits(cor_inline_bits(x.hi) - 1);
}

static double law_limit(enum quantity quantity, double nu, enum cor_disk_datum datum)
{
    struct limit limit;
    return find_limit(quantity, nu, datum, &limit) ? largest_double(limit_number(&limit)) : NAN;
}

/* Returns ln(limit/x), 0 < x far from the limit, in the form of cor_log_ratio_parts; NaN for an invalid nu or datum. */
static pair far_parts(enum quantity quantity, double x, double nu, enum cor_disk_datum datum)
{
    struct limit limit;
    if (!find_limit(quantity, nu, datum, &limit))
        return not_a_number;
    return cor_log_ratio_parts(cor_pair_plus(limit.at_zero.log, cor_pair(limit.exponent, 0)), x);
}

/* Returns ln(limit/x) for every x > 0; NaN beyond the limit. */
static pair pair_depth(enum quantity quantity, double x, double nu, enum cor_disk_datum datum)
{
    const pair parts = far_parts(quantity, x, nu, datum), q = cor_inline_sum(parts.hi, parts.lo);
    struct limit limit;
    if (!find_limit(quantity, nu, datum, &limit) || q.hi > COR_LOG_RATIO_NEAR)
        return q;
    return cor_log_ratio_near(limit_number(&limit), x);
}

/* ---- the law ---- */

static int is_positive(double x)
{
    return !cor_inline_is_refused(x) && x != 0;
}

/* Returns the result for an argument that is 0, negative or NaN: at_zero for 0 if nu and datum are valid, else NaN. */
static double not_positive(double x, double at_zero, double nu, enum cor_disk_datum datum)
{
    struct limit limit;
    return x == 0 && find_limit(LOAD, nu, datum, &limit) ? at_zero : NAN;
}

static pair one_plus(pair t)
{
    return cor_pair_plus(cor_pair(1, 0), t);
}

struct cor_inline_pair cor_disk_compression_depth(double compression, double nu, enum cor_disk_datum datum)
{
    return far_parts(COMPRESSION, compression, nu, datum);
}

double cor_disk_load_by_pairs(double compression, double nu, enum cor_disk_datum datum)
{
    if (!is_positive(compression))
        return not_positive(compression, 0, nu, datum);
    const pair t = cor_lambert_t_pair(pair_depth(COMPRESSION, compression, nu, datum));
    return times_pair(compression, cor_pair_over(pi, one_plus(t)));
}

static double law_compression(double load, double nu, enum cor_disk_datum datum)
{
    const pair t = pair_depth(LOAD, load, nu, datum);
    return times_pair(load, cor_inline_pair_times(one_over_pi, one_plus(t)));
}

static double law_energy(double load, double nu, enum cor_disk_datum datum)
{
    const pair t = pair_depth(LOAD, load, nu, datum);
    return square_times(load, cor_inline_pair_times(one_over_two_pi, cor_pair_plus(cor_pair(0.5, 0), t)));
}

static double law_load_of_energy(double energy, double nu, enum cor_disk_datum datum)
{
    const pair t = cor_lambert_t_pair(pair_depth(ENERGY, energy, nu, datum));
    if (cor_inline_is_refused(t.hi))
        return NAN;
    const int small = energy < COR_INLINE_2_M900;
    const pair scaled = cor_pair(small ? energy * COR_INLINE_2_200 : energy, 0);
    const pair root = pair_sqrt(cor_pair_over(cor_inline_pair_times(four_pi, scaled), one_plus(t)));
    return small ? root.hi / COR_INLINE_2_100 : root.hi;
}

/* ---- a collision ---- */

static pair t_of_speed(double speed, double nu, enum cor_disk_datum datum)
{
    return cor_lambert_t_pair(cor_pair_scaled(pair_depth(SPEED, speed, nu, datum), 2));
}

struct cor_inline_pair cor_disk_speed_depth(double speed, double nu, enum cor_disk_datum datum)
{
    return far_parts(SPEED, speed, nu, datum);
}

double cor_disk_depth(double speed, double nu, enum cor_disk_datum datum)
{
    const pair q = pair_depth(SPEED, speed, nu, datum);
    return 2 * (q.hi + q.lo);
}

static double law_max_load(double speed, double nu, enum cor_disk_datum datum)
{
    const pair t = t_of_speed(speed, nu, datum);
    return times_pair(speed, cor_pair_over(root_2_pi, pair_sqrt(one_plus(t))));
}

static double law_max_compression(double speed, double nu, enum cor_disk_datum datum)
{
    const pair t = t_of_speed(speed, nu, datum), half = {t.hi / 2, t.lo / 2};
    const pair numerator = cor_inline_pair_times(root_2, one_plus(half));
    return times_pair(speed, cor_pair_over(numerator, pair_sqrt(one_plus(t))));
}

/* Returns exp(u) - 1 - u, 0 <= u < 100, with an error of 3 ulp. For tiny u the relative error is u/3, but such u
 * contribute little to the integral below. */
static double exp_less_two_terms(double u)
{
    if (u >= 1)
        return (exp(u) - 1) - u;
    if (u < COR_INLINE_2_M40)
        return u * u / 2;
    /* 2/(k + 2)! */
    static const double c[] = {1,
                               1.0 / 3,
                               1.0 / 12,
                               1.0 / 60,
                               1.0 / 360,
                               1.0 / 2520,
                               1.0 / 20160,
                               1.0 / 181440,
                               1.0 / 1814400,
                               1.0 / 19958400,
                               1.0 / 239500800,
                               1.0 / 3113510400,
                               1.0 / 43589145600,
                               1.0 / 653837184000,
                               1.0 / 10461394944000,
                               1.0 / 177843714048000};
    const double square = u * u;
    double even = c[14], odd = c[15];
    for (int k = 12; k >= 0; k -= 2) {
        even = c[k] + square * even;
        odd = c[k + 1] + square * odd;
    }
    return square / 2 * (even + u * odd);
}

/* Returns tau = sqrt(2) int sqrt(1 + T) dtheta, where T - ln(1 + T) = q - 2 ln(sin(theta)) and T = t at theta = pi/2.
 * The variable u = T - t avoids the inversion,
 *
 *     tau = (1/sqrt(2)) int_0^inf (t + u) du/sqrt((1 + t) (exp(u) - 1 - u) + t u)
 *
 * and the root has zeros at u = 0 and near u = -c, c = t + t/(1 + t). They are close together near the edge of the
 * domain. The substitution u = c sinh^2(x/2) removes both zeros. The integrand becomes
 *
 *     f(x) = (t + u) sqrt(u (u + c)/((1 + t) (exp(u) - 1 - u) + t u)),
 *
 * which is even and decreases like exp(-u/2). Its first singularities, where the root vanishes near u = 2 +- 7 i, are
 * at x = +-i a + ... with 0.99 < a/(1.29/sqrt(1 + c/7.6)) < 1.19. The trapezoidal rule with the step 2 pi 1.29/(38.5
 * sqrt(1 + c/7.6)) has a relative error of exp(-38), and so has the cutoff at u = 88. The rule needs 27 to 60 points,
 * 115 at t = 1e-8 and at most 200. */
static double time_of_t(double t)
{
    /* For t < `least` f has a kink at x = 0. Its slope jumps by less than 2e-15, a negligible error of the sum. */
    const double least = 1e-15, end = 88;
    const double y = 1 + t, between = t + t / y, c = between < least ? least : between;
    /* rounded to few bits, so that k step is exact */
    const double step = cor_inline_head(0.2105 / sqrt(1 + c / 7.6));
    pair sum = cor_pair(sqrt(t * c) / 2, 0);
    for (int k = 1;; k++) {
        const double m = expm1(k * step), u = c / 4 * (m * m / (1 + m));
        if (u > end)
            break;
        const double f = (t + u) * sqrt(u * (u + c) / (y * exp_less_two_terms(u) + t * u));
        const pair next = cor_pair_two_sum(sum.hi, f);
        sum.hi = next.hi;
        sum.lo += next.lo;
    }
    const pair tau = cor_inline_pair_times(cor_inline_pair_times(sum, cor_pair(step / 2, 0)), root_2);
    return tau.hi;
}

double cor_disk_contact_time_by_quadrature(double speed, double nu, enum cor_disk_datum datum)
{
    if (!is_positive(speed))
        return not_positive(speed, INFINITY, nu, datum);
    const pair t = t_of_speed(speed, nu, datum);
    return cor_inline_is_refused(t.hi) ? NAN : time_of_t(t.hi + t.lo);
}

/* ---- to leading logarithm ---- */

static const struct cor_logarithm four = {{4, 0}, {1.38629436111989057, 4.63809362769259912e-17}};
static const struct cor_logarithm log_four_pi = {{4 * COR_PI, 4 * COR_PI_TAIL},
                                                 {2.53102424696929074, 5.66468874396338237e-17}};
/* the largest double below 4 pi/e */
static const double load_end = 4.62290939916368604;

/* ---- the public functions ---- */

double cor_disk_load_limit(double nu, enum cor_disk_datum datum)
{
    return law_limit(LOAD, nu, datum);
}

double cor_disk_compression_limit(double nu, enum cor_disk_datum datum)
{
    return law_limit(COMPRESSION, nu, datum);
}

double cor_disk_energy_limit(double nu, enum cor_disk_datum datum)
{
    return law_limit(ENERGY, nu, datum);
}

double cor_disk_speed_limit(double nu, enum cor_disk_datum datum)
{
    return law_limit(SPEED, nu, datum);
}

double cor_disk_compression(double load, double nu, enum cor_disk_datum datum)
{
    return is_positive(load) ? law_compression(load, nu, datum) : not_positive(load, 0, nu, datum);
}

double cor_disk_energy(double load, double nu, enum cor_disk_datum datum)
{
    return is_positive(load) ? law_energy(load, nu, datum) : not_positive(load, 0, nu, datum);
}

double cor_disk_load_of_energy(double energy, double nu, enum cor_disk_datum datum)
{
    return is_positive(energy) ? law_load_of_energy(energy, nu, datum) : not_positive(energy, 0, nu, datum);
}

double cor_disk_max_load(double speed, double nu, enum cor_disk_datum datum)
{
    return is_positive(speed) ? law_max_load(speed, nu, datum) : not_positive(speed, 0, nu, datum);
}

double cor_disk_max_compression(double speed, double nu, enum cor_disk_datum datum)
{
    return is_positive(speed) ? law_max_compression(speed, nu, datum) : not_positive(speed, 0, nu, datum);
}

double cor_disk_compression_leading_log(double load)
{
    if (!is_positive(load))
        return load == 0 ? 0 : NAN;
    return load <= load_end ? times_pair(load, cor_inline_pair_times(one_over_pi, cor_log_ratio(&log_four_pi, load)))
                            : NAN;
}

double cor_disk_load_leading_log(double compression)
{
    if (!is_positive(compression))
        return compression == 0 ? 0 : NAN;
    return compression < 4 ? times_pair(compression, cor_pair_over(pi, cor_log_ratio(&four, compression))) : NAN;
}

double cor_disk_energy_leading_log(double compression)
{
    if (!is_positive(compression))
        return compression == 0 ? 0 : NAN;
    return compression < 4 ? square_times(compression, cor_pair_over(half_pi, cor_log_ratio(&four, compression))) : NAN;
}

double cor_disk_max_compression_leading_log(double speed)
{
    if (!is_positive(speed))
        return speed == 0 ? 0 : NAN;
    return times_pair(speed, pair_sqrt(cor_log_ratio(&four, speed)));
}

double cor_disk_contact_time_leading_log(double speed)
{
    if (!is_positive(speed))
        return speed == 0 ? INFINITY : NAN;
    return cor_inline_pair_times(pi, pair_sqrt(cor_log_ratio(&four, speed))).hi;
}
