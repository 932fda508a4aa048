/* SPDX-License-Identifier: MIT */
#include "fit/likelihood.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cminpack.h>

#include "support/console.h"
#include "support/local.h"

enum {
    SCAN_STEPS = 400,
    SCAN_POINTS = 1000,
    STARTS = 3,
    SCALE_ROUNDS = 40,
    ROOT_STEPS = 60,
    RATIO_STEPS = 42,
    ROBUST_RATIO_STEPS = 14,
    RATIO_GOLDEN = 24,
    REACH = 64 /* bounces after a time that still tell its error */
};

/* Residuals below the rounding error of eps count as this large, so that a curve through all points has a finite AIC.
 */
#define LEAST_RESIDUAL DBL_EPSILON

struct problem {
    enum fit_curve curve;
    size_t points;
    const struct fit_point *point;
    bool has_sigma; /* false: weight 1/scale */
    double *log_speed, *buffer;
    const struct fit_bounce *bounce; /* NULL: eps of each point has an error of its own */
    struct whitening {
        double *y, *slope;   /* by bounce, in the order of the file */
        double (*factor)[3]; /* rows of L: two places and one place before the diagonal, and the diagonal */
        double *shifted, *above, *below;
    } w;
    double ratio; /* lambda */
    double scale;
    bool robust;
    double low[FIT_MAX_PARAMETERS], high[FIT_MAX_PARAMETERS];
    int parameters;
    int held; /* the coordinate that is held in a profile, or -1 */
    double held_at;
};

/* ---- the covariance of bounces ---- */

/* a_k = eps + d eps/d ln g, which is d[T eps]/dT */
static void set_slopes(const struct problem *p, const double *theta)
{
    const double step = 1e-4;
    const struct whitening *const w = &p->w;
    for (int sign = -1; sign <= 1; sign += 2) {
        for (size_t i = 0; i < p->points; i++)
            w->shifted[i] = p->log_speed[i] + sign * step;
        fit_curve_eps(p->curve, theta, w->shifted, sign > 0 ? w->above : w->below, p->points);
    }
    for (size_t k = 0; k < p->points; k++) {
        const double above = w->above[p->bounce[k].point], below = w->below[p->bounce[k].point];
        w->slope[k] = (above + below) / 2 + (above - below) / (2 * step);
    }
}

/* Factors W of that ratio and makes y of the residuals r, and z of y. Returns ln det W. */
static double whiten(const struct problem *p, double ratio, const double *r)
{
    const struct whitening *const w = &p->w;
    double log_determinant = 0;
    for (size_t k = 0; k < p->points; k++) {
        const struct fit_bounce *const b = &p->bounce[k];
        const double a = w->slope[k], flight = b->flight_s;
        double *const row = w->factor[k];
        w->y[k] = flight * r[b->point];
        row[0] = row[1] = 0;
        if (!b->begins) {
            const bool third = !b[-1].begins;
            row[0] = third ? a / w->factor[k - 2][2] : 0;
            row[1] = (-a * (1 + w->slope[k - 1]) - (1 + a) - row[0] * w->factor[k - 1][1]) / w->factor[k - 1][2];
            w->y[k] -= row[1] * w->y[k - 1] + (third ? row[0] * w->y[k - 2] : 0);
        }
        const double square =
            1 + (1 + a) * (1 + a) + a * a + ratio * flight * flight - row[0] * row[0] - row[1] * row[1];
        row[2] = sqrt(square);
        w->y[k] /= row[2];
        log_determinant += log(square);
    }
    return log_determinant;
}

/* z, scaled by the determinants, takes the place of r, by point. `base` is ln det B. Returns that scale. */
static double scale_whitened(const struct problem *p, double ratio, double base, const double *r, double *z)
{
    const double scale = exp((whiten(p, ratio, r) - base) / (2 * (double)p->points));
    for (size_t k = 0; k < p->points; k++)
        z[p->bounce[k].point] = scale * p->w.y[k];
    return scale;
}

/* ---- residuals ---- */

/* All coordinates from those that are not held */
static void whole_theta(double whole[FIT_MAX_PARAMETERS], const struct problem *p, const double *free_theta)
{
    for (int j = 0, next = 0; j < p->parameters; j++)
        whole[j] = j == p->held ? p->held_at : free_theta[next++];
}

static void plain_residuals(const struct problem *p, const double *theta, double *residual)
{
    fit_curve_eps(p->curve, theta, p->log_speed, residual, p->points);
    for (size_t i = 0; i < p->points; i++)
        residual[i] = p->point[i].eps - residual[i];
}

static void residuals(const struct problem *p, const double *theta, double *residual)
{
    double whole[FIT_MAX_PARAMETERS];
    whole_theta(whole, p, theta);
    plain_residuals(p, whole, residual);
    if (p->bounce) {
        set_slopes(p, whole);
        scale_whitened(p, p->ratio, whiten(p, 0, residual), residual, residual);
    }
    for (size_t i = 0; i < p->points; i++) {
        const double z = residual[i] / (p->has_sigma ? p->point[i].sigma : p->scale), size = fabs(z);
        /* sign(z) sqrt(rho(z)): least squares of these minimise the sum of Huber's rho */
        residual[i] = !p->robust || size <= FIT_HUBER ? z : copysign(sqrt(FIT_HUBER * (2 * size - FIT_HUBER)), z);
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

static int call_residuals(void *p, int m, int n, const double *theta, double *residual, int flag)
{
    (void)n;
    (void)flag;
    residuals(p, theta, residual);
    for (int i = 0; i < m; i++)
        if (!isfinite(residual[i]))
            return -1; /* stop */
    return 0;
}

/* The Levenberg-Marquardt method of MINPACK, from theta on, which becomes the minimiser; returns Q there. It stops
 * where the relative change of Q or of theta is below 1e-14. */
static double least_squares(struct problem *p, double *theta)
{
    const int m = (int)p->points, n = p->parameters - (p->held >= 0), length = m * n + 5 * n + m;
    int pivot[FIT_MAX_PARAMETERS];
    if (n > 0) {
        double *const work = xmalloc((size_t)(length + m) * sizeof *work);
        lmdif1(call_residuals, p, m, n, theta, work + length, 1e-14, pivot, work, length);
        free(work);
    }
    const double q = objective(p, theta);
    return isfinite(q) ? q : INFINITY;
}

static void keep_better(double *best, double *best_theta, struct problem *p, const double *start)
{
    double theta[FIT_MAX_PARAMETERS];
    memcpy(theta, start, sizeof theta);
    least_squares(p, theta);
    for (int j = 0; j < p->parameters; j++)
        theta[j] = fmin(fmax(theta[j], p->low[j]), p->high[j]);
    const double at_start = objective(p, start), at_end = objective(p, theta);
    const bool moved = at_end <= at_start;
    if ((moved ? at_end : at_start) < *best) {
        *best = moved ? at_end : at_start;
        memcpy(best_theta, moved ? theta : start, sizeof theta);
    }
}

struct thin {
    struct problem p;
    struct fit_point point[SCAN_POINTS];
    double log_speed[SCAN_POINTS], buffer[SCAN_POINTS];
};

/* The problem on at most `most` of its points, without the covariance of bounces, for starts */
static void thin_problem(struct thin *thin, const struct problem *p, size_t most)
{
    size_t n = 0;
    for (size_t i = 0; i < p->points; i += (p->points + most - 1) / most, n++) {
        thin->log_speed[n] = p->log_speed[i];
        thin->point[n] = p->point[i];
    }
    thin->p = *p;
    thin->p.points = n;
    thin->p.bounce = NULL;
    thin->p.robust = p->robust && !p->bounce;
    thin->p.log_speed = thin->log_speed;
    thin->p.point = thin->point;
    thin->p.buffer = thin->buffer;
}

/* Scans the range of the only coordinate on a thinned set of points, and starts from the lowest local minima: eps of
 * the Hertzian dashpot has a kink where the contact ends to separate. */
static double minimise_by_scan(double *theta, struct problem *p)
{
    struct thin thin;
    double value[SCAN_STEPS + 1], best = INFINITY;
    thin_problem(&thin, p, SCAN_POINTS);
    const double step = (p->high[0] - p->low[0]) / (double)SCAN_STEPS;
    for (int i = 0; i <= SCAN_STEPS; i++) {
        const double at[FIT_MAX_PARAMETERS] = {p->low[0] + step * i};
        value[i] = objective(&thin.p, at);
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
    return best;
}

static double minimise(double *theta, struct problem *p);

/* The problem of the dry curve of a curve with a loss */
static struct problem dry_problem(const struct problem *p)
{
    struct problem dry = *p;
    dry.curve = fit_curve_dry(p->curve);
    dry.parameters = fit_curve_parameters(dry.curve);
    return dry;
}

/* The least of a grid of both coordinates in each third of the second, which ranges from no loss to all of it. Beside a
 * loss the damping is weaker than without: of a logarithm a range below that of the dry curve is enough. */
static double minimise_on_grid(double *theta, struct problem *p)
{
    enum { FIRST = 60, SECOND = 75, PARTS = 3, POINTS = 250 };
    struct problem dry = dry_problem(p);
    double dry_theta[FIT_MAX_PARAMETERS] = {0, p->low[1]}, low = p->low[0], high = p->high[0];
    minimise(dry_theta, &dry);
    dry_theta[1] = p->low[1];
    if (fit_coordinate_is_logarithm(p->curve, 0)) {
        low = fmax(low, dry_theta[0] - 4);
        high = fmin(high, dry_theta[0] + 0.5);
    }
    struct thin thin;
    double best = INFINITY;
    thin_problem(&thin, p, POINTS);
    for (int part = 0; part < PARTS; part++) {
        double least = INFINITY, start[FIT_MAX_PARAMETERS] = {p->low[0], p->low[1]};
        for (int k = part * SECOND / PARTS; k < (part + 1) * SECOND / PARTS; k++)
            for (int i = 0; i <= FIRST; i++) {
                const double at[FIT_MAX_PARAMETERS] = {low + (high - low) * i / FIRST,
                                                       p->low[1] + (p->high[1] - p->low[1]) * k / SECOND};
                const double sum = objective(&thin.p, at);
                if (sum < least) {
                    least = sum;
                    memcpy(start, at, sizeof start);
                }
            }
        keep_better(&best, theta, p, start);
    }
    keep_better(&best, theta, p, dry_theta);
    return best;
}

/* From the weighted mean of a constant, or from the mean and the straight line of ln eps over ln g, each point weighted
 * by eps^2 as in least squares of eps */
static double minimise_from_lines(double *theta, struct problem *p)
{
    const bool constant = p->curve == FIT_CONSTANT;
    double w = 0, x = 0, y = 0, xx = 0, xy = 0, best = INFINITY;
    for (size_t i = 0; i < p->points; i++) {
        const double eps = p->point[i].eps, s = p->has_sigma ? p->point[i].sigma : 1;
        if (!constant && eps <= 0)
            continue;
        const double weight = (constant ? 1 : eps * eps) / (s * s);
        const double lx = constant ? 0 : p->log_speed[i], ly = constant ? eps : log(eps);
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

static double minimise(double *theta, struct problem *p)
{
    if (p->curve == FIT_CONSTANT || p->curve == FIT_POWER_LAW)
        return minimise_from_lines(theta, p);
    return p->parameters == 2 ? minimise_on_grid(theta, p) : minimise_by_scan(theta, p);
}

/* ---- the scale, and the ratio of bounces ---- */

static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* sqrt(sum z^2/(n - k)), or the median of |z| over 0.6745, times sqrt(n/(n - k)) */
static double scale_of(const struct problem *p, const double *z)
{
    const double normal_median = 0.67448975019608171, n = (double)p->points, freedom = n - p->parameters;
    double squares = 0;
    for (size_t i = 0; i < p->points; i++)
        squares += z[i] * z[i];
    if (!p->robust)
        return fmax(sqrt(squares / freedom), LEAST_RESIDUAL);
    double *const size = xmalloc(p->points * sizeof *size);
    for (size_t i = 0; i < p->points; i++)
        size[i] = fabs(z[i]);
    qsort(size, p->points, sizeof *size, compare_doubles);
    const double median = (size[(p->points - 1) / 2] + size[p->points / 2]) / 2;
    free(size);
    return fmax(median / normal_median * sqrt(n / freedom), LEAST_RESIDUAL);
}

/* The scale, for points or for bounces with the ratio exp(u) of a flight of the mean square */
static double scale_at(const struct problem *p, const double *r, double base, double u, double flight2)
{
    if (!p->bounce)
        return scale_of(p, r);
    scale_whitened(p, exp(u) / flight2, base, r, p->w.shifted);
    return scale_of(p, p->w.shifted);
}

/* The least scale over the ratio: a scan, then golden sections beside each of its local minima, since errors of times
 * alone and scatter of bounces alone may both be likely. A median has many by chance: there only the lowest counts. */
static void set_noise(struct problem *p, const double *theta)
{
    const int steps = p->robust ? ROBUST_RATIO_STEPS : RATIO_STEPS;
    const double low = log(1e-10), step = log(1e18) / steps, golden = 0.6180339887498949;
    double *const r = p->buffer, base = 0, flight2 = 0, best = low, least = INFINITY, lowest = INFINITY;
    double scale[RATIO_STEPS + 1];
    plain_residuals(p, theta, r);
    if (p->bounce) {
        set_slopes(p, theta);
        base = whiten(p, 0, r);
        for (size_t k = 0; k < p->points; k++)
            flight2 += p->bounce[k].flight_s * p->bounce[k].flight_s / (double)p->points;
        for (int i = 0; i <= steps; i++) {
            scale[i] = scale_at(p, r, base, low + i * step, flight2);
            lowest = fmin(scale[i], lowest);
        }
        for (int i = 0; i <= steps; i++) {
            if ((i > 0 && scale[i] >= scale[i - 1]) || (i < steps && scale[i] > scale[i + 1]) ||
                (p->robust && scale[i] > lowest))
                continue;
            const double middle = low + i * step;
            double far = middle + step, from = middle - step; /* the golden section lies nearer to `from` */
            double at = from + (1 - golden) * (far - from), height = scale_at(p, r, base, at, flight2);
            for (int round = 0; round < RATIO_GOLDEN; round++) {
                const double next = from + golden * (far - from), next_height = scale_at(p, r, base, next, flight2);
                if (next_height < height) {
                    from = at;
                    at = next;
                    height = next_height;
                } else {
                    far = from;
                    from = next;
                }
            }
            best = height < least ? at : best;
            least = fmin(height, least);
        }
        p->ratio = exp(best) / flight2;
    }
    p->scale = scale_at(p, r, base, best, flight2);
}

/* theta and the noise in turn, until the scale stays */
static void settle(double *theta, struct problem *p)
{
    for (int round = 0; round < SCALE_ROUNDS; round++) {
        const double before = p->scale;
        double from[FIT_MAX_PARAMETERS], sum = INFINITY;
        p->scale = p->robust ? before : 1;
        memcpy(from, theta, sizeof from);
        keep_better(&sum, theta, p, from);
        set_noise(p, theta);
        if (fabs(p->scale - before) <= 1e-9 * p->scale)
            break;
    }
}

static double minimise_with_noise(double *theta, struct problem *p)
{
    const bool robust = p->robust;
    const struct fit_bounce *const bounce = p->bounce;
    p->robust = false;
    p->bounce = NULL;
    const double best = minimise(theta, p);
    p->robust = robust;
    p->bounce = bounce;
    if (!bounce && (!robust || p->has_sigma))
        return robust ? minimise(theta, p) : best;
    set_noise(p, theta);
    struct problem other = *p;
    double other_theta[FIT_MAX_PARAMETERS];
    memcpy(other_theta, theta, sizeof other_theta);
    settle(theta, p);
    /* errors of the times alone, scatter alone, and, of a curve with a loss, the fit without it */
    const int starts = fit_curve_dry(p->curve) != p->curve ? 3 : 2;
    for (int start = 0; bounce && !robust && start < starts; start++) {
        struct problem q = other;
        double from[FIT_MAX_PARAMETERS];
        memcpy(from, other_theta, sizeof from);
        q.ratio = start == 0 ? 0 : 1e8;
        if (start == 2) {
            struct problem dry = dry_problem(&other);
            minimise_with_noise(from, &dry);
            from[1] = p->low[1];
            q.ratio = dry.ratio;
        }
        settle(from, &q);
        if (q.scale < p->scale) {
            *p = q;
            memcpy(theta, from, sizeof from);
        }
    }
    p->scale = robust ? p->scale : 1;
    return minimise(theta, p);
}

/* ---- intervals ---- */

/* The least Q where coordinate j has the value x. `rest` holds the other coordinate: a start, then the minimiser. */
static double profile(struct problem *p, int j, double x, double *rest)
{
    double q = INFINITY, before;
    p->held_at = x;
    do {
        before = q;
        p->held = j;
        q = least_squares(p, rest);
        if (p->bounce && !p->robust) {
            double whole[FIT_MAX_PARAMETERS];
            whole_theta(whole, p, rest);
            p->held = -1;
            set_noise(p, whole);
            q = p->scale * p->scale * (double)(p->points - (size_t)p->parameters);
            p->scale = 1;
        }
    } while (p->bounce && !p->robust && p->parameters > 1 && q < before * (1 - 1e-9));
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
            return fit_coordinate_is_logarithm(p->curve, j) || p->curve == FIT_POWER_LAW
                       ? copysign((double)INFINITY, sign)
                       : limit;
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

static void find_intervals(struct fit_estimate *e, struct problem *p, double minimum)
{
    const size_t freedom = p->points - (size_t)p->parameters;
    const double unit = p->robust ? huber_factor(p, e->theta) : p->has_sigma ? 1 : minimum / (double)freedom;
    for (int level = 0; level < LEVELS; level++) {
        const enum distribution_level l = (enum distribution_level)level;
        const double quantile = p->has_sigma ? normal_quantile(l) : student_quantile(l, freedom);
        const double threshold =
            quantile * quantile * unit; /* the excess of the profile over its minimum at the ends */
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

static void judge(struct fit_estimate *e, struct problem *p)
{
    double squares = 0, chi2 = 0;
    double *const r = p->buffer;
    plain_residuals(p, e->theta, r);
    for (size_t i = 0; i < p->points; i++) {
        squares += r[i] * r[i];
        chi2 += p->has_sigma ? r[i] * r[i] / (p->point[i].sigma * p->point[i].sigma) : 0;
    }
    e->rms = sqrt(squares / (double)p->points);
    e->chi2 = p->has_sigma ? chi2 : NAN;
    e->p_of_chi2 = p->has_sigma && !p->robust;
    if (p->bounce) {
        set_slopes(p, e->theta);
        e->time_sigma_s = e->scale / scale_whitened(p, p->ratio, whiten(p, 0, r), r, r);
    }
    for (size_t i = 0; p->robust && i < p->points; i++) {
        const double z = r[i] / (p->has_sigma ? p->point[i].sigma : p->scale);
        r[i] = fmin(fmax(z, -FIT_HUBER), FIT_HUBER);
    }
    e->p_value = e->p_of_chi2 ? chi_squared_tail(chi2, p->points - (size_t)p->parameters)
                              : groups_p_value(r, p->points, (size_t)p->parameters);
}

/* A logarithm at an end of its range stands for 0 or infinity. So do ends of intervals. */
static void set_limit(struct fit_estimate *e, const struct problem *p)
{
    const double near = 1e-6;
    for (int j = 0; j < e->parameters; j++) {
        if (!fit_coordinate_is_logarithm(p->curve, j) || p->curve == FIT_POWER_LAW)
            continue;
        const bool least = e->theta[j] - p->low[j] < near, most = !least && p->high[j] - e->theta[j] < near;
        if (least || most)
            e->theta[j] = most ? INFINITY : -INFINITY;
        for (int level = 0; level < LEVELS; level++) {
            struct fit_interval *const interval = &e->interval[j][level];
            if (least) {
                interval->low = -INFINITY;
                interval->high = interval->high - p->low[j] < near ? -INFINITY : interval->high;
            } else if (most) {
                interval->high = INFINITY;
                interval->low = p->high[j] - interval->low < near ? INFINITY : interval->low;
            }
        }
    }
}

static void problem_init(struct problem *p, enum fit_curve curve, const struct fit_data *data, bool robust)
{
    const size_t n = data->points;
    double *const memory = xmalloc((data->bounce ? 7 : 2) * n * sizeof *memory);
    *p = (struct problem){.curve = curve,
                          .points = n,
                          .point = data->point,
                          .has_sigma = data->has_sigma,
                          .log_speed = memory,
                          .buffer = memory + n,
                          .bounce = data->bounce,
                          .scale = 1,
                          .robust = robust,
                          .parameters = fit_curve_parameters(curve),
                          .held = -1};
    if (data->bounce)
        p->w = (struct whitening){memory + 2 * n, memory + 3 * n, xmalloc(n * sizeof *p->w.factor),
                                  memory + 4 * n, memory + 5 * n, memory + 6 * n};
    for (size_t i = 0; i < n; i++)
        p->log_speed[i] = log(data->point[i].speed_m_s);
    for (int j = 0; j < p->parameters; j++)
        fit_curve_range(curve, j, p->log_speed[0], p->log_speed[n - 1], &p->low[j], &p->high[j]);
}

static void problem_clear(struct problem *p)
{
    free(p->log_speed); /* and all other arrays of numbers */
    free(p->w.factor);
}

void fit_estimate_curve(struct fit_estimate *estimate, enum fit_curve curve, const struct fit_data *data, bool robust)
{
    LOCAL_INIT(problem, p, (&p, curve, data, robust));
    *estimate =
        (struct fit_estimate){.curve = curve, .parameters = p.parameters, .fitted = p.points > (size_t)p.parameters};
    if (estimate->fitted) {
        const double minimum = minimise_with_noise(estimate->theta, &p);
        estimate->scale = p.has_sigma ? NAN : p.scale;
        if (!p.has_sigma && !robust)
            estimate->scale = sqrt(minimum / (double)(p.points - (size_t)p.parameters));
        estimate->ratio = p.ratio;
        find_intervals(estimate, &p, minimum);
        p.ratio = estimate->ratio; /* a profile has others */
        set_limit(estimate, &p);
        judge(estimate, &p);
    }
}

double fit_aic(const struct fit_estimate *estimate, const struct fit_data *data, bool robust,
               const struct fit_estimate *best)
{
    const double n = (double)data->points;
    if (!data->has_sigma && !robust) {
        const double scale = fmax(estimate->scale * sqrt((n - estimate->parameters) / n), LEAST_RESIDUAL);
        return 2 * n * log(scale) + 2 * (estimate->parameters + 1);
    }
    LOCAL_INIT(problem, p, (&p, estimate->curve, data, robust));
    p.scale = best->scale;
    p.ratio = best->ratio;
    const double q = objective(&p, estimate->theta);
    return q + 2 * estimate->parameters;
}

/* ---- distances ---- */

size_t fit_lines(const struct fit_data *data)
{
    size_t lines = data->points;
    for (size_t k = 0; data->bounce && k < data->points; k++)
        lines += data->bounce[k].begins ? 2 : 0;
    return lines;
}

/* Generalised least squares of the error e of time w of bounce `first` from z = w e + noise */
static double time_distance(const struct problem *p, size_t first, size_t time)
{
    const struct whitening *const whitening = &p->w;
    double w[REACH + 2] = {0}, product = 0, squares = 0; /* two zeros before the first */
    for (size_t k = first; k < p->points && k < first + REACH && (k == first || !p->bounce[k].begins); k++) {
        const size_t place = k - first + 2, before = time + first - k; /* times from t_k to this one */
        const double a = whitening->slope[k], *const row = whitening->factor[k];
        const double direct = k > first + time ? 0 : before == 2 ? 1 : before == 1 ? -(1 + a) : a;
        w[place] = (direct - row[1] * w[place - 1] - row[0] * w[place - 2]) / row[2];
        product += w[place] * whitening->y[k];
        squares += w[place] * w[place];
    }
    return product / sqrt(squares);
}

void fit_distances(struct fit_distance *out, const struct fit_estimate *estimate, const struct fit_data *data)
{
    LOCAL_INIT(problem, p, (&p, estimate->curve, data, false));
    plain_residuals(&p, estimate->theta, p.buffer);
    for (size_t i = 0; !p.bounce && i < p.points; i++)
        *out++ =
            (struct fit_distance){p.point[i].line, p.buffer[i] / (p.has_sigma ? p.point[i].sigma : estimate->scale)};
    if (p.bounce) {
        set_slopes(&p, estimate->theta);
        whiten(&p, estimate->ratio, p.buffer);
    }
    for (size_t k = 0; p.bounce && k < p.points; k++)
        for (size_t time = p.bounce[k].begins ? 0 : 2; time < 3; time++)
            *out++ = (struct fit_distance){p.bounce[k].line[time], time_distance(&p, k, time) / estimate->time_sigma_s};
}
