/* SPDX-License-Identifier: MIT */
#include "fit/likelihood.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fit/least_squares.h"
#include "support/console.h"

enum { SCAN_STEPS = 400, SCAN_POINTS = 1000, STARTS = 3, SCALE_ROUNDS = 40, ROOT_STEPS = 60 };

/* Residuals below the rounding error of eps count as this large, so that a curve through all points has a finite AIC.
 */
#define LEAST_RESIDUAL DBL_EPSILON

struct problem {
    enum fit_curve curve;
    size_t points;
    const double *eps, *sigma; /* sigma NULL: weight 1/scale */
    double *log_speed, *buffer;
    double scale;
    bool robust;
    double low[FIT_MAX_PARAMETERS], high[FIT_MAX_PARAMETERS];
    int parameters;
    int held; /* the coordinate that is held in a profile, or -1 */
    double held_at;
};

/* ---- residuals ---- */

/* sign(z) sqrt(rho(z)): least squares of these minimise the sum of Huber's rho. */
static double huber_root(double z)
{
    const double size = fabs(z);
    return size <= FIT_HUBER ? z : copysign(sqrt(FIT_HUBER * (2 * size - FIT_HUBER)), z);
}

static void whole_theta(double whole[FIT_MAX_PARAMETERS], const struct problem *p, const double *free_theta)
{
    for (int j = 0, next = 0; j < p->parameters; j++)
        whole[j] = j == p->held ? p->held_at : free_theta[next++];
}

static void residuals(const void *context, const double *theta, double *residual)
{
    const struct problem *const p = context;
    double whole[FIT_MAX_PARAMETERS];
    whole_theta(whole, p, theta);
    fit_curve_eps(p->curve, whole, p->log_speed, residual, p->points);
    for (size_t i = 0; i < p->points; i++) {
        const double z = (p->eps[i] - residual[i]) / (p->sigma ? p->sigma[i] : p->scale);
        residual[i] = p->robust ? huber_root(z) : z;
    }
}

static double objective(const struct problem *p, const double *theta)
{
    double sum = 0;
    residuals(p, theta, p->buffer);
    for (size_t i = 0; i < p->points; i++)
        sum += p->buffer[i] * p->buffer[i];
    return sum;
}

/* ---- the minimum ---- */

static void keep_better(double *best, double *best_theta, const struct problem *p, const double *start)
{
    double theta[FIT_MAX_PARAMETERS];
    memcpy(theta, start, sizeof theta);
    least_squares_minimise(residuals, p, p->points, p->parameters, theta);
    for (int j = 0; j < p->parameters; j++)
        theta[j] = fmin(fmax(theta[j], p->low[j]), p->high[j]);
    const double at_start = objective(p, start);
    double sum = objective(p, theta);
    if (!(sum <= at_start)) {
        memcpy(theta, start, sizeof theta);
        sum = at_start;
    }
    if (sum < *best) {
        *best = sum;
        memcpy(best_theta, theta, sizeof theta);
    }
}

/* Scans the range of the only coordinate on a thinned set of points, and starts from the lowest local minima: eps of
 * the Hertzian dashpot has a kink where the contact ends to separate. */
static double minimise_by_scan(double *theta, const struct problem *p)
{
    struct problem thin = *p;
    const size_t stride = (p->points + SCAN_POINTS - 1) / SCAN_POINTS;
    double value[SCAN_STEPS + 1], best = INFINITY;
    double *const log_speed = xmalloc(3 * (size_t)SCAN_POINTS * sizeof(double)), *const eps = log_speed + SCAN_POINTS;
    double *const sigma = eps + SCAN_POINTS;
    thin.points = 0;
    for (size_t i = 0; i < p->points; i += stride, thin.points++) {
        log_speed[thin.points] = p->log_speed[i];
        eps[thin.points] = p->eps[i];
        sigma[thin.points] = p->sigma ? p->sigma[i] : 0;
    }
    thin.log_speed = log_speed;
    thin.eps = eps;
    thin.sigma = p->sigma ? sigma : NULL;
    const double step = (p->high[0] - p->low[0]) / (double)SCAN_STEPS;
    for (int i = 0; i <= SCAN_STEPS; i++) {
        const double at[FIT_MAX_PARAMETERS] = {p->low[0] + step * i};
        value[i] = objective(&thin, at);
    }
    for (int start = 0; start < STARTS; start++) {
        int lowest = -1;
        for (int i = 0; i <= SCAN_STEPS; i++)
            if ((i == 0 || value[i] <= value[i - 1]) && (i == SCAN_STEPS || value[i] <= value[i + 1]) &&
                value[i] < INFINITY && (lowest < 0 || value[i] < value[lowest]))
                lowest = i;
        if (lowest < 0)
            break;
        const double from[FIT_MAX_PARAMETERS] = {p->low[0] + step * lowest};
        keep_better(&best, theta, p, from);
        value[lowest] = INFINITY;
    }
    free(log_speed);
    return best;
}

/* The straight line of ln eps over ln g, each point weighted by eps^2 as in least squares of eps, and the mean */
static double minimise_power_law(double *theta, const struct problem *p)
{
    double w = 0, x = 0, y = 0, xx = 0, xy = 0, best = INFINITY;
    for (size_t i = 0; i < p->points; i++) {
        if (p->eps[i] <= 0)
            continue;
        const double s = p->sigma ? p->sigma[i] : 1, weight = p->eps[i] * p->eps[i] / (s * s);
        const double lx = p->log_speed[i], ly = log(p->eps[i]);
        w += weight;
        x += weight * lx;
        y += weight * ly;
        xx += weight * lx * lx;
        xy += weight * lx * ly;
    }
    const double spread = w * xx - x * x, mean = w > 0 ? y / w : -1;
    const double slope = spread > 1e-12 * w * xx ? (w * xy - x * y) / spread : 0;
    const double line[FIT_MAX_PARAMETERS] = {w > 0 ? (y - slope * x) / w : mean, slope};
    const double level[FIT_MAX_PARAMETERS] = {mean, 0};
    keep_better(&best, theta, p, line);
    keep_better(&best, theta, p, level);
    return best;
}

static double minimise_constant(double *theta, const struct problem *p)
{
    double w = 0, sum = 0, best = INFINITY;
    for (size_t i = 0; i < p->points; i++) {
        const double weight = p->sigma ? 1 / (p->sigma[i] * p->sigma[i]) : 1;
        w += weight;
        sum += weight * p->eps[i];
    }
    const double mean[FIT_MAX_PARAMETERS] = {sum / w};
    keep_better(&best, theta, p, mean);
    return best;
}

static double minimise(double *theta, const struct problem *p)
{
    if (p->curve == FIT_CONSTANT)
        return minimise_constant(theta, p);
    if (p->curve == FIT_POWER_LAW)
        return minimise_power_law(theta, p);
    return minimise_by_scan(theta, p);
}

/* ---- the robust scale ---- */

static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* The median of |r| over 0.6745, times sqrt(n/(n - k)) */
static double residual_scale(const struct problem *p, const double *theta)
{
    const double normal_median = 0.67448975019608171, n = (double)p->points;
    double *const r = p->buffer;
    fit_curve_eps(p->curve, theta, p->log_speed, r, p->points);
    for (size_t i = 0; i < p->points; i++)
        r[i] = fabs(p->eps[i] - r[i]);
    qsort(r, p->points, sizeof *r, compare_doubles);
    const double median = (r[(p->points - 1) / 2] + r[p->points / 2]) / 2;
    return fmax(median / normal_median * sqrt(n / (n - p->parameters)), LEAST_RESIDUAL);
}

static double minimise_with_scale(double *theta, struct problem *p)
{
    const bool robust = p->robust;
    p->robust = false;
    const double best = minimise(theta, p);
    p->robust = robust;
    if (!robust || p->sigma)
        return robust ? minimise(theta, p) : best;
    p->scale = residual_scale(p, theta);
    for (int round = 0; round < SCALE_ROUNDS; round++) {
        minimise(theta, p);
        const double scale = residual_scale(p, theta);
        if (fabs(scale - p->scale) <= 1e-9 * scale)
            break;
        p->scale = scale;
    }
    return minimise(theta, p);
}

/* ---- intervals ---- */

/* The least Q where coordinate j has the value x. `rest` holds the other coordinate: a start, then the minimiser. */
static double profile(struct problem *p, int j, double x, double *rest)
{
    p->held = j;
    p->held_at = x;
    const double q = p->parameters == 1 ? objective(p, NULL)
                                        : least_squares_minimise(residuals, p, p->points, p->parameters - 1, rest);
    p->held = -1;
    return q;
}

/* The value of coordinate j, beyond theta_j in the direction `sign`, where the profile exceeds `minimum` by
 * `threshold`. sqrt(Q - minimum) is nearly linear there. */
static double interval_end(struct problem *p, const double *theta, int j, int sign, double minimum, double threshold)
{
    const double limit = sign > 0 ? p->high[j] : p->low[j], target = sqrt(threshold);
    double rest = theta[1 - j * (p->parameters - 1)]; /* the other coordinate, if there are two */
    double near = theta[j], near_height = -target, far = near, far_height = -target;
    for (double step = 1e-7 * fmax(fabs(near), 1); far_height < 0; step *= 2) {
        near = far;
        near_height = far_height;
        if (near == limit)
            return p->curve == FIT_CONSTANT ? limit : copysign((double)INFINITY, sign);
        far = sign > 0 ? fmin(theta[j] + step, limit) : fmax(theta[j] - step, limit);
        far_height = sqrt(fmax(profile(p, j, far, &rest) - minimum, 0)) - target;
    }
    /* Regula falsi with the Illinois rule */
    for (int i = 0, last = 0; i < ROOT_STEPS && fabs(far - near) > 1e-11 * fmax(fabs(far), 1); i++) {
        double middle = near - near_height * (far - near) / (far_height - near_height);
        if (!(fmin(near, far) < middle && middle < fmax(near, far)))
            middle = (near + far) / 2;
        const double height = sqrt(fmax(profile(p, j, middle, &rest) - minimum, 0)) - target;
        if (fabs(height) <= 1e-9 * target)
            return middle;
        if (height < 0) {
            near = middle;
            near_height = height;
            far_height /= last == -1 ? 2 : 1;
            last = -1;
        } else {
            far = middle;
            far_height = height;
            near_height /= last == 1 ? 2 : 1;
            last = 1;
        }
    }
    return (near + far) / 2;
}

/* Huber's factor [sum psi^2/(n - k)]/[sum psi'/n] */
static double huber_factor(const struct problem *p, const double *theta)
{
    double psi2 = 0, slope = 0;
    residuals(p, theta, p->buffer);
    for (size_t i = 0; i < p->points; i++) {
        const double root = fabs(p->buffer[i]); /* of rho; equals psi up to FIT_HUBER, where psi stays */
        psi2 += root <= FIT_HUBER ? root * root : FIT_HUBER * FIT_HUBER;
        slope += root <= FIT_HUBER;
    }
    const double n = (double)p->points;
    return psi2 / (n - p->parameters) / (fmax(slope, 1) / n);
}

/* The excess of the profile over its minimum at the ends of the interval */
static double profile_threshold(const struct problem *p, const double *theta, double minimum,
                                enum distribution_level level)
{
    const size_t freedom = p->points - (size_t)p->parameters;
    const double quantile = p->sigma ? normal_quantile(level) : student_quantile(level, freedom);
    double unit = 1;
    if (p->robust)
        unit = huber_factor(p, theta);
    else if (!p->sigma)
        unit = minimum / (double)freedom;
    return quantile * quantile * unit;
}

static void find_intervals(struct fit_estimate *e, struct problem *p, double minimum)
{
    for (int level = 0; level < LEVELS; level++) {
        const double threshold = profile_threshold(p, e->theta, minimum, (enum distribution_level)level);
        for (int j = 0; j < p->parameters; j++) {
            struct fit_interval *const interval = &e->interval[j][level];
            interval->low = interval->high = e->theta[j];
            if (!(threshold > 0))
                continue;
            interval->low = interval_end(p, e->theta, j, -1, minimum, threshold);
            interval->high = interval_end(p, e->theta, j, 1, minimum, threshold);
        }
    }
}

/* ---- how well the curve fits ---- */

/* The tail of F for the means of groups of neighbours among the residuals */
static double groups_p_value(const double *r, size_t n, size_t parameters)
{
    if (n < 2 * (parameters + 1))
        return NAN;
    size_t groups = n / 3 < FIT_MAX_GROUPS ? n / 3 : FIT_MAX_GROUPS;
    if (groups < parameters + 1)
        groups = parameters + 1;
    double between = 0, within = 0;
    for (size_t j = 0; j < groups; j++) {
        const size_t first = j * n / groups, end = (j + 1) * n / groups;
        double mean = 0;
        for (size_t i = first; i < end; i++)
            mean += r[i] / (double)(end - first);
        between += (double)(end - first) * mean * mean;
        for (size_t i = first; i < end; i++)
            within += (r[i] - mean) * (r[i] - mean);
    }
    if (!(within > 0))
        return between > 0 ? 0 : 1;
    const double mean_squares = between / (double)(groups - parameters);
    return fisher_tail(mean_squares / (within / (double)(n - groups)), groups - parameters, n - groups);
}

static void judge(struct fit_estimate *e, const struct problem *p)
{
    double squares = 0, chi2 = 0;
    double *const r = p->buffer;
    fit_curve_eps(p->curve, e->theta, p->log_speed, r, p->points);
    for (size_t i = 0; i < p->points; i++) {
        r[i] = p->eps[i] - r[i];
        squares += r[i] * r[i];
        chi2 += p->sigma ? r[i] * r[i] / (p->sigma[i] * p->sigma[i]) : 0;
    }
    e->rms = sqrt(squares / (double)p->points);
    e->chi2 = p->sigma ? chi2 : NAN;
    e->p_of_chi2 = p->sigma && !p->robust;
    for (size_t i = 0; p->robust && i < p->points; i++) {
        const double z = r[i] / (p->sigma ? p->sigma[i] : p->scale);
        r[i] = fmin(fmax(z, -FIT_HUBER), FIT_HUBER);
    }
    e->p_value = e->p_of_chi2 ? chi_squared_tail(chi2, p->points - (size_t)p->parameters)
                              : groups_p_value(r, p->points, (size_t)p->parameters);
}

/* A beta at an end of its range stands for 0 or infinity: eps is 1, or 0, at all speeds. So do ends of intervals. */
static void set_limit(struct fit_estimate *e, const struct problem *p)
{
    const double near = 1e-6;
    if (p->curve == FIT_CONSTANT || p->curve == FIT_POWER_LAW)
        return;
    const bool least = e->theta[0] - p->low[0] < near, most = !least && p->high[0] - e->theta[0] < near;
    if (least || most)
        e->theta[0] = most ? INFINITY : -INFINITY;
    for (int level = 0; level < LEVELS; level++) {
        struct fit_interval *const interval = &e->interval[0][level];
        if (least) {
            interval->low = -INFINITY;
            interval->high = interval->high - p->low[0] < near ? -INFINITY : interval->high;
        } else if (most) {
            interval->high = INFINITY;
            interval->low = p->high[0] - interval->low < near ? INFINITY : interval->low;
        }
    }
}

static void problem_init(struct problem *p, enum fit_curve curve, const struct fit_data *data, bool robust)
{
    *p = (struct problem){.curve = curve,
                          .points = data->points,
                          .eps = data->eps,
                          .sigma = data->sigma,
                          .log_speed = xmalloc(data->points * sizeof(double)),
                          .buffer = xmalloc(data->points * sizeof(double)),
                          .scale = 1,
                          .robust = robust,
                          .parameters = fit_curve_parameters(curve),
                          .held = -1};
    for (size_t i = 0; i < data->points; i++)
        p->log_speed[i] = log(data->speed_m_s[i]);
    for (int j = 0; j < p->parameters; j++)
        fit_curve_range(curve, j, p->log_speed[0], p->log_speed[p->points - 1], &p->low[j], &p->high[j]);
}

static void problem_clear(struct problem *p)
{
    free(p->log_speed);
    free(p->buffer);
}

void fit_estimate_curve(struct fit_estimate *estimate, enum fit_curve curve, const struct fit_data *data, bool robust)
{
    struct problem p;
    problem_init(&p, curve, data, robust);
    *estimate =
        (struct fit_estimate){.curve = curve, .parameters = p.parameters, .fitted = p.points > (size_t)p.parameters};
    if (estimate->fitted) {
        const double minimum = minimise_with_scale(estimate->theta, &p);
        find_intervals(estimate, &p, minimum);
        set_limit(estimate, &p);
        judge(estimate, &p);
        estimate->scale = p.sigma ? NAN : p.scale;
        if (!p.sigma && !robust)
            estimate->scale = sqrt(minimum / (double)(p.points - (size_t)p.parameters));
    }
    problem_clear(&p);
}

double fit_aic(const struct fit_estimate *estimate, const struct fit_data *data, bool robust, double common_scale)
{
    const double n = (double)data->points, rms = fmax(estimate->rms, LEAST_RESIDUAL);
    if (!data->sigma && !robust)
        return n * log(rms * rms) + 2 * (estimate->parameters + 1);
    struct problem p;
    problem_init(&p, estimate->curve, data, robust);
    p.scale = common_scale;
    const double q = objective(&p, estimate->theta);
    problem_clear(&p);
    return q + 2 * estimate->parameters;
}
