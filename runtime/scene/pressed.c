/* SPDX-License-Identifier: MIT */
/* Collisions under a constant force, by Taylor series. With x = w^d and dt = d w^(d-1) ds the law is the polynomial
 * system
 *
 *     dw/ds = v,     dv/ds = -d w^(d-1) (F - f),     F = elastic w^(a d) + damper w^(b d) v
 *
 * which is regular at x = 0 and at the turning point v = 0. d is at least 2, so that w = v = 0 is a place of rest: a
 * motion that turns just before x = 0 turns there slowly, and no step hides that. */
#include "runtime/scene/pressed.h"

#include "runtime/scene/exponents.h"
#include "runtime/scene/series.h"

enum { ORDER = SERIES_ORDER, NODES = 40, MOST_STEPS = SERIES_MOST_STEPS, BISECTIONS = 80 };
enum { NODE_ONE = -2, NODE_W = -1 };

/* A power of w, the product of two others */
struct node {
    int exponent, left, right;
    double c[ORDER + 1];
};

struct motion {
    double elastic, damper, press;
    int d, ad, bd, low; /* low: the smaller of ad and bd */
    int nodes, of_time, of_spring, of_damper;
    struct node node[NODES];
    double w[ORDER + 1], v[ORDER + 1], t[ORDER + 1], force[ORDER + 1];
    double step;
};

static int power_node(struct motion *m, int exponent)
{
    if (exponent <= 1)
        return exponent == 1 ? NODE_W : NODE_ONE;
    for (int i = 0; i < m->nodes; i++)
        if (m->node[i].exponent == exponent)
            return i;
    const int left = power_node(m, exponent / 2), right = power_node(m, exponent - exponent / 2);
    struct node *const node = &m->node[m->nodes];
    node->exponent = exponent;
    node->left = left;
    node->right = right;
    return m->nodes++;
}

static void motion_init(struct motion *m, const struct cor_exponents *law, double elastic, double damper, double press)
{
    m->elastic = elastic;
    m->damper = damper;
    m->press = press;
    const int twice = law->denominator == 1 ? 2 : 1;
    m->d = twice * law->denominator;
    m->ad = twice * law->elastic;
    m->bd = twice * law->damping;
    m->low = m->ad < m->bd ? m->ad : m->bd;
    m->nodes = 0;
    m->of_time = power_node(m, m->d - 1);
    m->of_spring = power_node(m, m->ad);
    m->of_damper = power_node(m, m->bd);
    m->w[0] = m->t[0] = 0;
    m->v[0] = 1;
}

static double coefficient(const struct motion *m, int node, int k)
{
    return node == NODE_ONE ? k == 0 : node == NODE_W ? m->w[k] : m->node[node].c[k];
}

static double product(const struct motion *m, int node, const double *other, int n)
{
    double sum = 0;
    for (int k = 0; k <= n; k++)
        sum += coefficient(m, node, k) * other[n - k];
    return sum;
}

/* The coefficients of w, v and t, and a step at which the last ones do not matter */
static void motion_expand(struct motion *m)
{
    double rest[ORDER + 1];
    for (int n = 0; n < ORDER; n++) {
        for (int i = 0; i < m->nodes; i++) {
            struct node *const p = &m->node[i];
            p->c[n] = product(m, p->left, p->right == NODE_W ? m->w : m->node[p->right].c, n);
        }
        m->force[n] = m->elastic * coefficient(m, m->of_spring, n) + m->damper * product(m, m->of_damper, m->v, n);
        rest[n] = m->force[n] - (n == 0 ? m->press : 0);
        const double scale = (double)m->d / (n + 1);
        m->w[n + 1] = m->v[n] / (n + 1);
        m->v[n + 1] = -scale * product(m, m->of_time, rest, n);
        m->t[n + 1] = scale * coefficient(m, m->of_time, n);
    }
    m->force[ORDER] = 0;
    m->step = series_step(m->w, m->v);
}

static void motion_advance(struct motion *m)
{
    const double w = series_at(m->w, m->step), v = series_at(m->v, m->step), t = series_at(m->t, m->step);
    m->w[0] = w;
    m->v[0] = v;
    m->t[0] = t;
}

/* Functions of the place in a step: the force over the power of w that both of its terms have, the overlap above
 * `level`, and the slope of the force */
typedef double function(const struct motion *m, double s, double level);

static double velocity(const struct motion *m, double s, double level)
{
    return series_at(m->v, s) - level;
}

static double height(const struct motion *m, double s, double level)
{
    return series_at(m->w, s) - level;
}

static double contact_force(const struct motion *m, double s, double level)
{
    const double w = series_at(m->w, s);
    return m->elastic * whole_power(w, m->ad - m->low) +
           m->damper * whole_power(w, m->bd - m->low) * series_at(m->v, s) - level;
}

static double force_slope(const struct motion *m, double s, double level)
{
    return series_slope(m->force, s) - level;
}

/* Where the function falls to zero between two places */
static double root(const struct motion *m, function *f, double low, double high, double level)
{
    for (int k = 0; k < BISECTIONS && low < high; k++) {
        const double middle = low + (high - low) / 2;
        if (middle == low || middle == high)
            break;
        if (f(m, middle, level) > 0)
            low = middle;
        else
            high = middle;
    }
    return high;
}

/* ---- the events ---- */

static double overlap(const struct motion *m, double w)
{
    return whole_power(w, m->d);
}

/* v^2/2 + elastic x^(a+1)/(a+1) - f x, which never grows */
static double energy(const struct motion *m, double w, double v)
{
    const double x = overlap(m, w), a1 = (double)(m->ad + m->d) / m->d;
    return v * v / 2 + x * (m->elastic * whole_power(w, m->ad) / a1 - m->press);
}

/* Where the force can vanish: at overlaps from this one on if 2 (a - b) > 1; negative: at any */
static double release_height(const struct motion *m)
{
    const int difference = m->ad - m->bd, power = 2 * difference - m->d;
    const double ratio = m->damper / m->elastic;
    return power > 0 ? pow(m->press * ratio * ratio * m->d / difference, 1.0 / power) : -1; /* w */
}

/* Below this energy the force never vanishes. */
static double release_energy(const struct motion *m, double w)
{
    return w > 0 ? energy(m, w, m->elastic / m->damper * whole_power(w, m->ad - m->bd)) : 0;
}

/* Whether the overlap rises to that of rest and never beyond: while x'/(x_e - x) is below half of the damping
 * coefficient it stays so. */
static int creeps_up(const struct motion *m)
{
    const double a = (double)m->ad / m->d, rest = pow(m->press / m->elastic, 1 / a), x = overlap(m, m->w[0]);
    const double damping = m->damper * whole_power(m->w[0], m->bd);
    const double stiffness = m->elastic * a * fmax(pow(rest, a - 1), pow(x, a - 1));
    return x < rest && damping * damping > 4 * stiffness && m->v[0] < damping / 2 * (rest - x);
}

struct events {
    double time, length; /* units */
    int turned, released, held, parted, stuck;
    double release, least;
};

static void record(struct cor_pressed_impact *impact, int end, const struct motion *m, const struct events *e, double s)
{
    impact->eps[end] = -series_at(m->v, s);
    impact->duration[end] = series_at(m->t, s) * e->time;
}

/* Events of one step */
static void find_events(struct cor_pressed_impact *impact, struct events *e, struct motion *m)
{
    double begin = 0, end = m->step;
    if (!e->turned) {
        if (force_slope(m, 0, 0) > 0 && force_slope(m, end, 0) < 0)
            impact->force_max = fmax(impact->force_max, series_at(m->force, root(m, force_slope, 0, end, 0)));
        impact->force_max = fmax(impact->force_max, m->force[0]);
        if (series_at(m->v, end) > 0)
            return;
        begin = root(m, velocity, 0, end, 0);
        e->turned = 1;
        impact->max_overlap = overlap(m, series_at(m->w, begin)) * e->length;
        impact->force_max = fmax(impact->force_max, series_at(m->force, begin));
    }
    if (!e->parted && !e->stuck && series_at(m->w, end) <= 0) {
        end = root(m, height, begin, end, 0);
        record(impact, COR_END_ZERO_OVERLAP, m, e, end);
        e->parted = 1;
    }
    if (e->released || e->held)
        return;
    const double last = e->release > 0 && series_at(m->w, begin) > e->release && series_at(m->w, end) < e->release
                            ? root(m, height, begin, end, e->release)
                            : end;
    if (contact_force(m, last, 0) < 0) {
        record(impact, COR_END_ZERO_FORCE, m, e, root(m, contact_force, begin, last, 0));
        e->released = 1;
    } else if (last < end) {
        e->held = 1;
    }
}

static void stay(struct cor_pressed_impact *impact, int end)
{
    impact->eps[end] = 0;
    impact->duration[end] = INFINITY;
}

/* Whether the motion goes on after a step */
static int goes_on(struct cor_pressed_impact *impact, struct events *e, const struct motion *m)
{
    const double level = energy(m, m->w[0], m->v[0]);
    if (!e->turned && creeps_up(m)) {
        impact->max_overlap = pow(m->press / m->elastic, (double)m->d / m->ad) * e->length;
        e->turned = 1;
    }
    if (!e->turned)
        return 1;
    e->held = e->held || (!e->released && level < e->least);
    e->stuck = e->stuck || (!e->parted && level < 0);
    return !((e->released || e->held) && (e->parted || e->stuck));
}

/* ---- the linear dashpot, x'' + 2 zeta x' + x = f: elementary motion, of which only the ends of contact need a search.
 * x - f and its derivatives are oscillations y'' + 2 zeta y' + y = 0. ---- */

struct oscillation {
    double zeta, frequency; /* sqrt(|1 - zeta^2|) */
};

static const double pi = 3.14159265358979323846;

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
        return (phase > 0 ? phase : phase + pi) / w;
    }
    if (!(ratio > 0))
        return INFINITY;
    return w == 0 ? ratio : ratio * w < 1 ? atanh(ratio * w) / w : INFINITY;
}

/* Where sign (y - level) falls through zero between two times */
static double oscillation_root(const struct oscillation *o, double value, double slope, double level, int sign,
                               double low, double high)
{
    for (int k = 0; k < BISECTIONS; k++) {
        const double middle = low + (high - low) / 2;
        *(sign * (oscillation_at(o, value, slope, middle) - level) > 0 ? &low : &high) = middle;
    }
    return high;
}

static void linear_solve(struct cor_pressed_impact *impact, double beta, double f)
{
    const struct oscillation o = {beta / 2, sqrt(fabs((1 - beta / 2) * (1 + beta / 2)))};
    const double a = f - beta, jerk = -beta * a - 1; /* the second and the third derivative of x at first */
    const double half = o.zeta < 1 ? pi / o.frequency : INFINITY;
    const double turn = oscillation_zero(&o, 1, a), peak = oscillation_zero(&o, jerk, -beta * jerk - a);
    const double back = turn + half; /* the second turning point */
    impact->max_overlap = isinf(turn) ? f : f + oscillation_at(&o, -f, 1, turn);
    /* the contact force is f less the acceleration */
    impact->force_max =
        jerk < 0 && peak < turn ? f - oscillation_at(&o, a, jerk, peak) : fmax(beta, impact->max_overlap);
    stay(impact, COR_END_ZERO_OVERLAP);
    stay(impact, COR_END_ZERO_FORCE);
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

int cor_pressed_solve(struct cor_pressed_impact *impact, const struct cor_exponents *law, double beta, double f)
{
    struct motion m;
    struct events e = {1, 1, 0, 0, 0, 0, 0, -1, 0};
    const int ends_differ = law->elastic > law->damping && beta > 0;
    if (cor_law_is(law, 2, 0)) {
        linear_solve(impact, beta, f);
        return COR_FAULT_NONE;
    }
    if (beta > 1) { /* x = length X, t = length s: the damping sets the scales */
        const double a1 = cor_elastic(law) + 1, b1 = cor_damping(law) + 1;
        e.length = e.time = pow(beta, -1 / b1);
        motion_init(&m, law, pow(beta, -a1 / b1), 1, f * e.length);
    } else {
        motion_init(&m, law, 1, beta, f);
    }
    if (ends_differ) {
        e.release = release_height(&m);
        e.least = release_energy(&m, e.release);
    }
    e.held = !ends_differ;
    impact->force_max = 0;
    for (int k = 0; k < MOST_STEPS; k++) {
        motion_expand(&m);
        find_events(impact, &e, &m);
        motion_advance(&m);
        if (!e.parted && !goes_on(impact, &e, &m))
            break;
        if (e.parted)
            break;
    }
    if (!(e.parted || e.stuck))
        return COR_FAULT_PRESSED;
    if (e.stuck)
        stay(impact, COR_END_ZERO_OVERLAP);
    if (!ends_differ) {
        impact->eps[COR_END_ZERO_FORCE] = impact->eps[COR_END_ZERO_OVERLAP];
        impact->duration[COR_END_ZERO_FORCE] = impact->duration[COR_END_ZERO_OVERLAP];
    } else if (!e.released) {
        stay(impact, COR_END_ZERO_FORCE);
    }
    impact->force_max /= e.length;
    return COR_FAULT_NONE;
}

/* ---- the sticking speed ---- */

#define FAR_OVERLAP 1e15
#define START 1e-8 /* relative size of the first terms that the start leaves squared */

double cor_pressed_sticking_speed(const struct cor_exponents *law, double damping, int end)
{
    const double a = cor_elastic(law), b = cor_damping(law);
    struct motion m;
    motion_init(&m, law, 1, damping, 1);
    const double release = end == COR_END_ZERO_FORCE && damping > 0 ? release_height(&m) : -1;
    if (damping == 0)
        return 0;
    m.damper = -damping; /* in backward time */
    if (release > 0) {
        m.w[0] = release;
        m.v[0] = whole_power(release, m.ad - m.bd) / damping;
    } else {
        const double x = fmin(pow(START / fmax(damping, 1), 1 / (b + 0.5)), pow(START, 1 / a));
        const double gained = sqrt(2) * damping * pow(x, b + 0.5) / (b + 1.5) - pow(x, a) / (a + 1);
        m.w[0] = pow(x, 1.0 / m.d);
        m.v[0] = sqrt(2 * x * (1 + gained));
    }
    int turned = 0;
    for (int k = 0; k < MOST_STEPS && m.w[0] < FAR_OVERLAP; k++) {
        motion_expand(&m);
        const double begin = turned || series_at(m.v, m.step) > 0 ? 0 : root(&m, velocity, 0, m.step, 0);
        turned = turned || begin > 0;
        if (turned && series_at(m.w, m.step) <= 0)
            return -series_at(m.v, root(&m, height, begin, m.step, 0));
        motion_advance(&m);
    }
    return INFINITY;
}
