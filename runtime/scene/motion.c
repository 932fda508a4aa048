/* SPDX-License-Identifier: MIT */
#include "runtime/scene/motion.h"

#include <float.h>
#include <stddef.h>

enum { ORDER = MOTION_ORDER, BISECTIONS = 80 };

int cor_motion_power(struct motion *m, int exponent)
{
    for (int i = 0; i < m->powers; i++)
        if (m->power[i].exponent == exponent)
            return i;
    if (m->powers == MOTION_POWERS) /* cor_motion_init refuses the motion */
        return 0;
    const int left = cor_motion_power(m, exponent / 2), right = cor_motion_power(m, exponent - exponent / 2);
    if (m->powers == MOTION_POWERS)
        return 0;
    struct motion_power *const power = &m->power[m->powers];
    power->exponent = exponent;
    power->left = left;
    power->right = right;
    return m->powers++;
}

int cor_motion_init(struct motion *m, double u, double v)
{
    enum { TERMS = 5 };
    struct motion_term *const terms[TERMS] = {&m->time[0], &m->time[1], &m->spring[0], &m->spring[1], &m->damper};
    if (!(isless(fabs(u), 1e150) && isless(fabs(v), 1e150)))
        return 0;
    m->powers = 2;
    for (int i = 0; i < 2; i++)
        m->power[i] = (struct motion_power){i, 0, 0, {i == 0}};
    for (int i = 0; i < TERMS; i++)
        terms[i]->power = cor_motion_power(m, terms[i]->exponent);
    m->power[1].c[0] = u;
    m->v[0] = v;
    m->t[0] = m->loss[0] = 0;
    m->energy = v * v / 2;
    m->follows_energy = 0;
    return m->powers < MOTION_POWERS;
}

/* ---- series ---- */

static double square_coefficient(const double *x, int n)
{
    double sum = 0;
    for (int k = 0; 2 * k < n; k++)
        sum += x[k] * x[n - k];
    return n % 2 ? 2 * sum : 2 * sum + x[n / 2] * x[n / 2];
}

static double polynomial_at(const double *c, double s)
{
    double y = c[ORDER];
    for (int n = ORDER - 1; n >= 0; n--)
        y = y * s + c[n];
    return y;
}

static int order_of(const struct motion *m) /* returns d of x = u^d; only if m->follows_energy */
{
    return m->time[0].exponent + 1;
}

/* Returns a step at which the last terms of the series of u and v are negligible. A series that starts at u = 0 may
 * have gaps: its last terms may be 0 although later terms, with factors of the order of 1, are not. */
static double longest_step(const struct motion *m)
{
    const double *const u = m->power[1].c, *const v = m->v;
    const double size = fmax(fabs(u[0]), fabs(v[0]));
    double least = u[0] == 0 ? 0.1 / m->unit : INFINITY, u_size = size, v_size = size;
    if (m->follows_energy &&
        u[0] > 0) { /* u and v differ in size: each has its own scale, and u grows at most fivefold */
        least = v[0] > 0 ? 4 * u[0] / v[0] / m->unit : least;
        u_size = u[0];
        v_size = fmax(fabs(v[0]), sqrt(m->press * whole_power(u[0], order_of(m))));
    }
    for (int n = ORDER - 2; n <= ORDER; n++) {
        const double last = fmax(fabs(u[n]) / u_size, fabs(v[n]) / v_size);
        if (last > 0)
            least = fmin(least, pow(DBL_EPSILON / 8 / last, 1.0 / n));
    }
    return isfinite(least) ? 0.9 * least : 1 / m->unit;
}

static double sum_of(const struct motion *m, const struct motion_term term[2], int n)
{
    return term[0].factor * m->power[term[0].power].c[n] + term[1].factor * m->power[term[1].power].c[n];
}

static int expand_in_unit(struct motion *m)
{
    /* slope: T. rest: F - press. damping: the force of the damper. lost: its power */
    double slope[ORDER + 1], rest[ORDER + 1], damping[ORDER + 1], lost[ORDER + 1];
    double *const u = m->power[1].c;
    const double most = 1e150, factor = fabs(m->damper.factor), most_damping = most * most / fmax(1, factor);
    if (!(isless(factor, most) && isless(fabs(m->spring[0].factor), most) && isless(m->press, most) &&
          isless(fabs(m->v[0]), most) && isless(fabs(u[0]), most)))
        return 0;
    for (int n = 0; n < ORDER; n++) {
        for (int i = 2; i < m->powers; i++) {
            struct motion_power *const p = &m->power[i];
            const double *const left = m->power[p->left].c;
            p->c[n] =
                p->left == p->right ? square_coefficient(left, n) : product_coefficient(left, m->power[p->right].c, n);
            if (!(fabs(p->c[n]) < most))
                return 0;
        }
        slope[n] = sum_of(m, m->time, n);
        damping[n] = product_coefficient(m->power[m->damper.power].c, m->v, n);
        if (fabs(damping[n]) > most_damping)
            return 0;
        damping[n] *= m->damper.factor;
        m->force[n] = sum_of(m, m->spring, n) + damping[n];
        rest[n] = m->force[n] - (n == 0 ? m->press : 0);
        if (!(fabs(slope[n]) < most && fabs(damping[n]) < most && fabs(rest[n]) < most && fabs(u[n]) < most))
            return 0;
        u[n + 1] = m->unit * m->v[n] / (n + 1);
        m->v[n + 1] = -m->unit * product_coefficient(slope, rest, n) / (n + 1);
        if (!(fabs(m->v[n + 1]) < most))
            return 0;
        m->t[n + 1] = m->unit * slope[n] / (n + 1);
        if (m->follows_energy) {
            lost[n] = product_coefficient(damping, m->v, n);
            m->loss[n + 1] = m->unit * product_coefficient(slope, lost, n) / (n + 1);
        }
    }
    m->force[ORDER] = 0;
    m->step = longest_step(m);
    return 1;
}

int cor_motion_expand(struct motion *m)
{
    for (m->unit = 1; m->unit > 0x1p-100; m->unit *= 0x1p-10)
        if (expand_in_unit(m))
            return 1;
    return 0;
}

/* Sets v from the energy, if the spring's energy is below half the work of `press`. v is then accurate. */
static void restore_speed(struct motion *m)
{
    const int d = order_of(m);
    const double x = whole_power(cor_motion_start(m), d), a1 = (double)(m->spring[0].exponent + d) / d;
    const double spring = m->spring[0].factor * whole_power(cor_motion_start(m), m->spring[0].exponent) / a1;
    const double kinetic = m->energy - m->loss[0] + x * (m->press - spring);
    if (spring < m->press / 2 && kinetic > 0)
        m->v[0] = copysign(sqrt(2 * kinetic), m->v[0]);
}

void cor_motion_advance(struct motion *m)
{
    double *const series[] = {m->power[1].c, m->v, m->t, m->loss};
    for (size_t i = 0; i < (m->follows_energy ? 4 : 3); i++)
        series[i][0] = polynomial_at(series[i], m->step);
    if (m->follows_energy)
        restore_speed(m);
}

/* ---- places ---- */

double cor_motion_u(const struct motion *m, double s, double level)
{
    return polynomial_at(m->power[1].c, s) - level;
}

double cor_motion_v(const struct motion *m, double s, double level)
{
    return polynomial_at(m->v, s) - level;
}

double cor_motion_t(const struct motion *m, double s)
{
    return polynomial_at(m->t, s);
}

double cor_motion_loss(const struct motion *m, double s)
{
    return polynomial_at(m->loss, s);
}

static double force_slope(const struct motion *m, double s, double level)
{
    double y = ORDER * m->force[ORDER];
    for (int n = ORDER - 1; n > 0; n--)
        y = y * s + n * m->force[n];
    return y - level;
}

double cor_motion_root(const struct motion *m, motion_function *f, double low, double high, double level)
{
    double middle;
    for (int k = 0; k < BISECTIONS && cor_halve(&middle, low, high); k++)
        *(f(m, middle, level) > 0 ? &low : &high) = middle;
    return high;
}

int cor_motion_compress(struct motion *m, double *force_max, int (*rests)(const struct motion *m))
{
    *force_max = -HUGE_VAL;
    for (int k = 0; k < MOTION_MOST_STEPS && cor_motion_expand(m); k++) {
        const int turns = cor_motion_v(m, m->step, 0) <= 0;
        const double end = turns ? cor_motion_root(m, cor_motion_v, 0, m->step, 0) : m->step;
        *force_max = fmax(*force_max, fmax(m->force[0], polynomial_at(m->force, end)));
        const int falls = force_slope(m, end, 0) < 0;
        if (force_slope(m, 0, 0) > 0 && falls)
            *force_max = fmax(*force_max, polynomial_at(m->force, cor_motion_root(m, force_slope, 0, end, 0)));
        m->step = end;
        cor_motion_advance(m);
        if (turns)
            m->v[0] = 0;
        if (turns || (falls && rests && rests(m)))
            return 1;
    }
    return 0;
}
