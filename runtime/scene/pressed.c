/* SPDX-License-Identifier: MIT */
/* Collisions under a constant force. With x = w^d and dt = d w^(d-1) ds the law is the polynomial system
 *
 *     dw/ds = v,     dv/ds = -d w^(d-1) (F - f),     F = elastic w^(a d) + damper w^(b d) v
 *
 * which is regular at x = 0 and at the turning point v = 0. d is at least 2, so that w = v = 0 is a place of rest: a
 * motion that turns just before x = 0 turns there slowly, and no step hides that. */
#include "runtime/scene/motion.h"

#include "runtime/scene/exponents.h"

static int motion_init(struct motion *m, const struct cor_exponents *law, double elastic, double damper, double press)
{
    const int twice = law->denominator == 1 ? 2 : 1, d = twice * law->denominator;
    m->time[0] = (struct motion_term){(double)d, d - 1, 0};
    m->spring[0] = (struct motion_term){elastic, twice * law->elastic, 0};
    m->damper = (struct motion_term){damper, twice * law->damping, 0};
    m->time[1] = m->spring[1] = (struct motion_term){0, 0, 0};
    m->press = press;
    return cor_motion_init(m, 0, 1);
}

double cor_pressed_force_max(const struct cor_exponents *law, double elastic, double damper)
{
    struct motion m;
    double force_max;
    return motion_init(&m, law, elastic, damper, 0) && cor_motion_compress(&m, &force_max, NULL) ? force_max
                                                                                                 : (double)NAN;
}

/* ---- the end of the contact ---- */

static int order_of(const struct motion *m) /* d */
{
    return m->time[0].exponent + 1;
}

static double overlap(const struct motion *m)
{
    return whole_power(cor_motion_start(m), order_of(m));
}

/* The force over the power of w that both of its terms have */
static double contact_force(const struct motion *m, double s, double level)
{
    const int ad = m->spring[0].exponent, bd = m->damper.exponent, low = ad < bd ? ad : bd;
    const double w = cor_motion_u(m, s, 0);
    return m->spring[0].factor * whole_power(w, ad - low) +
           m->damper.factor * whole_power(w, bd - low) * cor_motion_v(m, s, 0) - level;
}

/* v^2/2 + elastic x^(a+1)/(a+1) - f x, which never grows */
static double energy(const struct motion *m, double w, double v)
{
    const int d = order_of(m), ad = m->spring[0].exponent;
    const double a1 = (double)(ad + d) / d;
    return v * v / 2 + whole_power(w, d) * (m->spring[0].factor * whole_power(w, ad) / a1 - m->press);
}

/* Where the force can vanish: at overlaps from this one on if 2 (a - b) > 1; negative: at any */
static double release_height(const struct motion *m)
{
    const int d = order_of(m), difference = m->spring[0].exponent - m->damper.exponent, power = 2 * difference - d;
    const double ratio = m->damper.factor / m->spring[0].factor;
    return power > 0 ? pow(m->press * ratio * ratio * d / difference, 1.0 / power) : -1; /* w */
}

/* -v where the force vanishes */
static double release_speed(const struct motion *m, double w)
{
    return m->spring[0].factor / m->damper.factor * whole_power(w, m->spring[0].exponent - m->damper.exponent);
}

/* The overlap at which force and spring balance */
static double overlap_of_rest(const struct motion *m)
{
    return pow(m->press / m->spring[0].factor, (double)order_of(m) / m->spring[0].exponent);
}

/* Whether the overlap rises to that of rest and never beyond: while x'/(x_e - x) is below half of the damping
 * coefficient it stays so. */
static int creeps_up(const struct motion *m)
{
    const double a = (double)m->spring[0].exponent / order_of(m), rest = overlap_of_rest(m), x = overlap(m);
    const double damping = m->damper.factor * whole_power(cor_motion_start(m), m->damper.exponent);
    const double stiffness = m->spring[0].factor * a * fmax(pow(rest, a - 1), pow(x, a - 1));
    return x < rest && damping * damping > 4 * stiffness && m->v[0] < damping / 2 * (rest - x);
}

static void part(struct cor_full_impact *impact, int end, const struct motion *m, double s, double unit_of_time)
{
    impact->eps[end] = -cor_motion_v(m, s, 0);
    impact->duration[end] = cor_motion_t(m, s) * unit_of_time;
}

/* ---- the linear dashpot, x'' + 2 zeta x' + x = f: elementary motion, of which only the ends of contact need a search.
 * x - f and its derivatives are oscillations y'' + 2 zeta y' + y = 0. ---- */

struct oscillation {
    double zeta, frequency; /* sqrt(|1 - zeta^2|) */
};

/* y(time) of y(0) = value, y'(0) = slope */
static double oscillation_at(const struct oscillation *o, double value, double slope, double time)
{
    const double w = o->frequency, rest = slope + o->zeta * value;
    if (o->zeta > 1) {
        const double slow = exp(-time / (o->zeta + w)), fast = exp(-time * (o->zeta + w));
        return value * (slow + fast) / 2 + rest * (slow - fast) / (2 * w);
    }
    return exp(-o->zeta * time) * (w > 0 ? value * cos(w * time) + rest * sin(w * time) / w : value + rest * time);
}

/* The first zero after the start; infinite: there is none */
static double oscillation_zero(const struct oscillation *o, double value, double slope)
{
    const double w = o->frequency, rest = slope + o->zeta * value, ratio = -value / rest;
    if (o->zeta < 1) {
        const double phase = atan2(w * value, -rest);
        return (phase > 0 ? phase : phase + COR_PI) / w;
    }
    if (!(ratio > 0))
        return INFINITY;
    return w == 0 ? ratio : ratio * w < 1 ? atanh(ratio * w) / w : INFINITY;
}

/* Where sign (y - level) falls through zero between two times */
static double oscillation_root(const struct oscillation *o, double value, double slope, double level, int sign,
                               double low, double high)
{
    for (int k = 0; k < 80; k++) {
        const double middle = low + (high - low) / 2;
        *(sign * (oscillation_at(o, value, slope, middle) - level) > 0 ? &low : &high) = middle;
    }
    return high;
}

static void linear_solve(struct cor_full_impact *impact, double beta, double f)
{
    const struct oscillation o = {beta / 2, sqrt(fabs((1 - beta / 2) * (1 + beta / 2)))};
    const double a = f - beta, jerk = -beta * a - 1; /* the second and the third derivative of x at first */
    const double half = o.zeta < 1 ? COR_PI / o.frequency : INFINITY;
    const double turn = oscillation_zero(&o, 1, a), peak = oscillation_zero(&o, jerk, -beta * jerk - a);
    const double back = turn + half; /* the second turning point */
    impact->max_overlap = isinf(turn) ? f : f + oscillation_at(&o, -f, 1, turn);
    /* the contact force is f less the acceleration */
    impact->force_max =
        jerk < 0 && peak < turn ? f - oscillation_at(&o, a, jerk, peak) : fmax(beta, impact->max_overlap);
    if (!isinf(back) && f + oscillation_at(&o, -f, 1, back) < 0) {
        const double time = oscillation_root(&o, -f, 1, -f, 1, turn, back);
        impact->duration[COR_END_ZERO_OVERLAP] = time;
        impact->eps[COR_END_ZERO_OVERLAP] = -oscillation_at(&o, 1, a, time);
    }
    const double least = jerk < 0 ? peak + half : peak; /* of the contact force */
    if (!isinf(least) && !isinf(turn) && oscillation_at(&o, a, jerk, least) > f) {
        const double time = oscillation_root(&o, a, jerk, f, -1, turn, least);
        impact->duration[COR_END_ZERO_FORCE] = time;
        impact->eps[COR_END_ZERO_FORCE] = -oscillation_at(&o, 1, a, time);
    }
}

int cor_pressed_solve(struct cor_full_impact *impact, const struct cor_exponents *law, double beta, double f)
{
    struct motion m;
    double unit = 1, release = -1, least = 0; /* of length and time; w and energy where the force can vanish */
    const int ends_differ = law->elastic > law->damping && beta > 0;
    *impact = cor_together;
    if (cor_law_is(law, 2, 0)) {
        linear_solve(impact, beta, f);
        return COR_FAULT_NONE;
    }
    if (beta > 1) /* x = unit X, t = unit s: the damping sets the scales */
        unit = pow(beta, -1 / (cor_damping(law) + 1));
    if (!motion_init(&m, law, beta > 1 ? pow(unit, cor_elastic(law) + 1) : 1, fmin(beta, 1), f * unit) ||
        !cor_motion_compress(&m, &impact->force_max, creeps_up))
        return COR_FAULT_PRESSED;
    impact->max_overlap = (m.v[0] > 0 ? overlap_of_rest(&m) : overlap(&m)) * unit;
    impact->force_max /= unit;
    if (ends_differ) {
        release = release_height(&m);
        least = release > 0 ? energy(&m, release, release_speed(&m, release)) : 0;
    }
    int held = !ends_differ, parted = 0, k = 0; /* held: the force vanishes no more, or has vanished */
    for (; !parted; k++) {
        const double level = energy(&m, cor_motion_start(&m), m.v[0]); /* below 0 the bodies never part */
        held = held || level < least;
        if (level < 0 && held)
            break;
        if (k == MOTION_MOST_STEPS)
            return COR_FAULT_PRESSED;
        cor_motion_expand(&m);
        double end = m.step;
        parted = cor_motion_u(&m, end, 0) <= 0;
        if (parted) {
            end = cor_motion_root(&m, cor_motion_u, 0, end, 0);
            part(impact, COR_END_ZERO_OVERLAP, &m, end, unit);
        }
        const int below = cor_motion_start(&m) > release && cor_motion_u(&m, end, 0) < release;
        const double last = release > 0 && below ? cor_motion_root(&m, cor_motion_u, 0, end, release) : end;
        if (!held && contact_force(&m, last, 0) < 0) {
            part(impact, COR_END_ZERO_FORCE, &m, cor_motion_root(&m, contact_force, 0, last, 0), unit);
            held = 1;
        }
        held = held || last < end;
        cor_motion_advance(&m);
    }
    if (!ends_differ) {
        impact->eps[COR_END_ZERO_FORCE] = impact->eps[COR_END_ZERO_OVERLAP];
        impact->duration[COR_END_ZERO_FORCE] = impact->duration[COR_END_ZERO_OVERLAP];
    }
    return COR_FAULT_NONE;
}

/* ---- the sticking speed ---- */

#define LARGEST_OVERLAP 1e15
#define START 1e-8 /* relative size of the first terms that the start leaves squared */

double cor_pressed_sticking_speed(const struct cor_exponents *law, double damping, int end)
{
    const double a = cor_elastic(law), b = cor_damping(law);
    struct motion m;
    if (damping == 0)
        return 0;
    if (!motion_init(&m, law, 1, damping, 1))
        return NAN;
    const double release = end == COR_END_ZERO_FORCE ? release_height(&m) : -1;
    m.power[1].c[0] = release;
    m.v[0] = release > 0 ? release_speed(&m, release) : 0;
    m.damper.factor = -damping; /* in backward time */
    if (!(release > 0)) {
        const double x = fmin(pow(START / fmax(damping, 1), 1 / (b + 0.5)), pow(START, 1 / a));
        const double gained = sqrt(2) * damping * pow(x, b + 0.5) / (b + 1.5) - pow(x, a) / (a + 1);
        m.power[1].c[0] = pow(x, 1.0 / order_of(&m));
        m.v[0] = sqrt(2 * x * (1 + gained));
    }
    int turned = 0;
    for (int k = 0; k < MOTION_MOST_STEPS && cor_motion_start(&m) < LARGEST_OVERLAP; k++) {
        cor_motion_expand(&m);
        const double begin =
            turned || cor_motion_v(&m, m.step, 0) > 0 ? 0 : cor_motion_root(&m, cor_motion_v, 0, m.step, 0);
        turned = turned || begin > 0;
        if (turned && cor_motion_u(&m, m.step, 0) <= 0)
            return -cor_motion_v(&m, cor_motion_root(&m, cor_motion_u, begin, m.step, 0), 0);
        cor_motion_advance(&m);
    }
    return INFINITY;
}
