/* SPDX-License-Identifier: MIT */
/* With dt = (4 u^3 - 1) ds the motion is the polynomial system
 *
 *     du/ds = p,     dp/ds = -(4 u^3 - 1) (f + kappa u^power p),     p = dx/dt
 *
 * which is regular to the end of the tail, 4 u^3 = 1, where dx/du = 0. */
#include "runtime/scene/jkr.h"

#include "runtime/scene/exponents.h"
#include "runtime/scene/series.h"

enum { ORDER = SERIES_ORDER };

/* u where the contact breaks: the end of the tail, 4^(-1/3), and the largest pull, (3/4)^(1/3); twice the energy that
 * the way from u = 1 to there takes, 2 (3/5 + u^4 - (8/3) u^7 + (16/15) u^10); and half of the largest pull */
static const double broken_at[COR_SCENE_ENDS] = {0.62996052494743658238, 0.90856029641606982944};
static const double lost[COR_SCENE_ENDS] = {1.3259921049894873165, 0.65486382215035810233};

struct motion {
    double kappa;
    int power;
    double u[ORDER + 1], p[ORDER + 1], t[ORDER + 1], force[ORDER + 1];
    double u2[ORDER + 1], u3[ORDER + 1], u6[ORDER + 1], damper[ORDER + 1], one[ORDER + 1];
    double step;
};

static double product(const double *x, const double *y, int n)
{
    double sum = 0;
    for (int k = 0; k <= n; k++)
        sum += x[k] * y[n - k];
    return sum;
}

static void motion_init(struct motion *m, double kappa, int power, double speed)
{
    m->kappa = kappa;
    m->power = power;
    m->u[0] = 1;
    m->p[0] = speed;
    m->t[0] = 0;
    for (int n = 0; n <= ORDER; n++)
        m->one[n] = n == 0;
}

/* u^power for the powers of Hertz's laws: constant, Tsuji's, viscoelastic, Hunt and Crossley's dampers */
static const double *damper_power(const struct motion *m)
{
    return m->power == 0 ? m->one : m->power == 1 ? m->u : m->power == 2 ? m->u2 : m->u6;
}

static void motion_expand(struct motion *m)
{
    double slope[ORDER + 1]; /* dx/du */
    for (int n = 0; n < ORDER; n++) {
        m->u2[n] = product(m->u, m->u, n);
        m->u3[n] = product(m->u2, m->u, n);
        m->u6[n] = product(m->u3, m->u3, n);
        m->damper[n] = m->kappa * product(damper_power(m), m->p, n);
        m->force[n] = 8.0 / 3 * m->u6[n] - 4 * m->u3[n] + m->damper[n];
        slope[n] = 4 * m->u3[n] - (n == 0);
        m->u[n + 1] = m->p[n] / (n + 1);
        m->p[n + 1] = -product(slope, m->force, n) / (n + 1);
        m->t[n + 1] = slope[n] / (n + 1);
    }
    m->force[ORDER] = 0;
    m->step = series_step(m->u, m->p);
}

static void motion_advance(struct motion *m)
{
    const double u = series_at(m->u, m->step), p = series_at(m->p, m->step), t = series_at(m->t, m->step);
    m->u[0] = u;
    m->p[0] = p;
    m->t[0] = t;
}

/* The way in, to the turning point, where the next step begins */
static int compress(struct cor_jkr_impact *impact, struct motion *m)
{
    impact->force_max = -HUGE_VAL;
    for (int k = 0; k < SERIES_MOST_STEPS; k++) {
        motion_expand(m);
        const double end = series_at(m->p, m->step) > 0 ? m->step : series_root(series_at, m->p, 0, 0, m->step);
        impact->force_max = fmax(impact->force_max, fmax(m->force[0], series_at(m->force, end)));
        if (m->force[1] > 0 && series_slope(m->force, end) < 0)
            impact->force_max =
                fmax(impact->force_max, series_at(m->force, series_root(series_slope, m->force, 0, 0, end)));
        const int turned = end < m->step || series_at(m->p, m->step) <= 0;
        m->step = end;
        motion_advance(m);
        if (turned) {
            const double u = m->u[0];
            impact->max_overlap = u * (u * u * u - 1);
            m->p[0] = 0;
            return 1;
        }
    }
    return 0;
}

static void part(struct cor_jkr_impact *impact, int end, const struct motion *m, double s, double speed)
{
    impact->eps[end] = -series_at(m->p, s) / speed;
    impact->duration[end] = series_at(m->t, s);
}

static double opposite(const double *c, double s)
{
    return -series_at(c, s);
}

/* In the units of jkr.h */
static int solve(struct cor_jkr_impact *impact, double kappa, int power, double speed)
{
    struct motion m;
    motion_init(&m, kappa, power, speed);
    for (int end = 0; end < COR_SCENE_ENDS; end++) {
        impact->eps[end] = 0;
        impact->duration[end] = INFINITY;
    }
    if (!compress(impact, &m))
        return COR_FAULT_PRESSED;
    for (int k = 0; k < SERIES_MOST_STEPS; k++) {
        motion_expand(&m);
        double last = m.step; /* where the bodies turn inward again: they have less energy than the way out takes */
        int turned = 0;
        if (series_at(m.p, last) > 0) {
            last = series_root(opposite, m.p, 0, k == 0 ? m.step * 0x1p-20 : 0, last);
            turned = 1;
        }
        for (int end = 0; end < COR_SCENE_ENDS; end++)
            if (m.u[0] > broken_at[end] && series_at(m.u, last) <= broken_at[end])
                part(impact, end, &m, series_root(series_at, m.u, broken_at[end], 0, last), speed);
        if (turned || series_at(m.u, last) <= broken_at[COR_END_ZERO_OVERLAP])
            break;
        if (k == SERIES_MOST_STEPS - 1)
            return COR_FAULT_PRESSED;
        motion_advance(&m);
    }
    if (kappa == 0) /* exactly, and without loss of digits next to the sticking speed */
        for (int end = 0; end < COR_SCENE_ENDS; end++) {
            const double stick = sqrt(lost[end]);
            impact->eps[end] = speed > stick ? sqrt((speed - stick) * (speed + stick)) / speed : 0;
        }
    return COR_FAULT_NONE;
}

static double sticking_speed(double kappa, int power, int end)
{
    double low = sqrt(lost[end]), high = low;
    struct cor_jkr_impact impact;
    if (kappa == 0)
        return low;
    do { /* damping makes it larger */
        low = high;
        high *= 2;
        if (!(high < 1e150) || solve(&impact, kappa, power, high) != COR_FAULT_NONE)
            return NAN;
    } while (impact.eps[end] == 0);
    for (;;) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high)
            return high;
        if (solve(&impact, kappa, power, middle) != COR_FAULT_NONE)
            return NAN;
        if (impact.eps[end] > 0)
            high = middle;
        else
            low = middle;
    }
}

/* ---- in SI units ---- */

struct units {
    double length, time, force, speed, kappa;
    int power;
};

static struct units units_of(const struct cor_scene_contact *contact, double coefficient)
{
    static const double pi = 3.14159265358979323846;
    const double w = contact->adhesion_j_m2, R = contact->radius_m, b = cor_damping(&contact->law);
    const double modulus = 0.75 * contact->stiffness / sqrt(R); /* E* */
    const double radius = cbrt(2 * pi * w * R * R / modulus);   /* c_0 */
    struct units unit = {.length = radius * radius / R, .force = pi * w * R, .power = (int)(4 * b)};
    unit.time = sqrt(contact->mass_kg * unit.length / unit.force);
    unit.speed = unit.length / unit.time;
    unit.kappa = coefficient * pow(unit.length, b) * unit.speed / unit.force;
    return unit;
}

int cor_jkr_impact(struct cor_jkr_impact *impact, const struct cor_scene_contact *contact, double coefficient,
                   double speed_m_s)
{
    const struct units unit = units_of(contact, coefficient);
    const int status = solve(impact, unit.kappa, unit.power, speed_m_s / unit.speed);
    for (int end = 0; end < COR_SCENE_ENDS; end++)
        impact->duration[end] *= unit.time;
    impact->max_overlap *= unit.length;
    impact->force_max *= unit.force;
    return status;
}

double cor_jkr_sticking_speed(const struct cor_scene_contact *contact, double coefficient, int end)
{
    const struct units unit = units_of(contact, coefficient);
    return unit.speed * sticking_speed(unit.kappa, unit.power, end);
}

int cor_jkr_has_law(const struct cor_exponents *law)
{
    const int power = 4 * law->damping / law->denominator;
    return cor_law_is_hertz(law) && 4 * law->damping % law->denominator == 0 && (power <= 2 || power == 6);
}
