/* SPDX-License-Identifier: MIT */
/* Oblique impacts with friction (docs/theory.md, 20). In the units of the normal motion (motion.h), with the overlap x
 * = u^d, the velocity w of the contact point and the force S of a spring with memory q obey
 *
 *     dw/dt = -(S + gamma x^b w),     S = kappa x^r q,     dq/dt = x^(p-r) w
 *
 * while the contact sticks. For r = p the spring remembers its displacement, for r = 0 its force. On the way back r is
 * larger by 1/2 if the memory shrinks with the contact radius. While the contact slips the force is the cap M |F|, and
 * the spring holds that force. All of this is polynomial in u. */
#include "cor/scene.h"

#include <float.h>

#include "cor/status.h"
#include "runtime/scene/exponents.h"
#include "runtime/scene/motion.h"

enum { ORDER = MOTION_ORDER, MOST_STEPS = 20000, MOST_IDLE = 6, MOST_PARTS = 200 };
#define TOLERANCE 2e-15 /* a value below this fraction of the sum of its terms counts as 0 */
#define RATIO 0.26      /* largest step as a fraction of the radius of convergence: RATIO^ORDER = 1e-14 */
#define STRETCH 1.6     /* largest step as a multiple of the step of motion.c, whose last terms are 1e-17 */
#define MOMENT 1e-11    /* negligible fraction of a step */
#define NEAR 0.01       /* an event is accurate if it is in this first fraction of a step */
#define JUMP 1e-12      /* largest jump of w, in units of `size`, at which creep may begin */
#define POWER_MOST 1e280
#define PRESS_MOST 1e12
#define KAPPA_MOST 1e24

/* STICKS: spring and damper act. SLIPS: the cap acts. CREEPS: w is at the threshold between STICKS and SLIPS, where a
 * damper that acts only in STICKS keeps it. */
enum mode { STICKS, SLIPS, CREEPS };

struct slide {
    struct motion m;
    int memory, damper_in_cap, slips, d, mode, idle, parts; /* idle: successive changes of the mode without a step */
    int least;                                              /* `held` and T u x^p contain the factor u^least */
    int time, spring, rate, damper;                         /* indices in m.power of T/d, x^r, T x^(p-r)/d and x^b */
    int stiff, elastic, damping;                            /* indices of u^-least times T u x^p/d, x^a and x^b */
    double p, r, kappa, gamma, cap, side, sign;             /* side: direction of the slip force. sign: the sign of F */
    double w, q, size, moment;                              /* size: w at the start. moment: length of a short step */
    double series_w[ORDER + 1], series_q[ORDER + 1], held[ORDER + 1], damped[ORDER + 1], test[2][ORDER + 1],
        terms[ORDER + 1]; /* terms: sums of the absolute values of the terms of a test */
};

/* ---- series ---- */

static double value_at(const double *c, double s)
{
    double y = c[ORDER];
    for (int n = ORDER - 1; n >= 0; n--)
        y = y * s + c[n];
    return y;
}

/* Returns the first place up to `end` at which a series falls below zero, or infinity. terms: for each coefficient, the
 * sum of the absolute values of its terms. Leading zeros of a series from x = 0 are divided out. In each part of the
 * way, the series is at least c_0 + c_1 s + least s^2, and the part ends where this bound is zero, so no fall is
 * missed. */
static double first_fall(const double *series, const double *terms, double end)
{
    double c[ORDER + 1] = {0}, size = 0, power = 1, place = 0, length = 1; /* in units of `end` */
    int first = 0;
    while (first < ORDER && series[first] == 0)
        first++;
    for (int n = 0; n <= ORDER - first && power < POWER_MOST; n++, power *= end) {
        c[n] = series[n + first] * power;
        size += fabs(terms[n + first]) * power;
    }
    for (int k = 0; k < MOST_PARTS && c[0] >= -TOLERANCE * size; k++) {
        double least = c[ORDER];
        for (int n = ORDER - 1; n > 1; n--)
            least = c[n] + fmin(length * least, 0);
        const double above = c[0] + 2 * TOLERANCE * size, square = c[1] * c[1] - 4 * least * above,
                     slope = square > 0 ? sqrt(square) - c[1] : 0;
        if (2 * above < length * slope)
            length = 2 * above / slope;
        else if (place + length >= 1)
            return INFINITY;
        for (int i = 0; i < ORDER; i++)
            for (int n = ORDER - 1; n >= i; n--)
                c[n] += length * c[n + 1];
        place += length;
        length = fmin(2 * length, 1 - place);
    }
    return place < MOMENT ? 0 : place * end;
}

static const double *power_series(const struct slide *s, int place)
{
    return s->m.power[place].c;
}

/* Returns the coefficient n of the product of a power of u and a series. */
static double times(const struct slide *s, int place, const double *series, int n)
{
    return place == 0 ? series[n] : product_coefficient(power_series(s, place), series, n);
}

/* Sets w and q, and the two tests: the cap minus the force in either direction. */
static void expand_stick(struct slide *s)
{
    double total[ORDER + 1];
    const struct motion *const m = &s->m;
    const double unit = m->unit * s->d;
    s->series_w[0] = s->w;
    s->series_q[0] = s->q;
    for (int n = 0; n < ORDER; n++) {
        const double spring = s->kappa * times(s, s->spring, s->series_q, n),
                     damper = s->gamma > 0 ? s->gamma * times(s, s->damper, s->series_w, n) : 0,
                     cap = s->cap * s->sign * m->force[n],
                     elastic = m->spring[0].factor * power_series(s, m->spring[0].power)[n];
        total[n] = spring + damper;
        const double capped = spring + (s->damper_in_cap ? damper : 0);
        s->series_w[n + 1] = -unit * times(s, s->time, total, n) / (n + 1);
        s->series_q[n + 1] = unit * times(s, s->rate, s->series_w, n) / (n + 1);
        for (int k = 0; k < 2; k++)
            s->test[k][n] = cap - (k == 0 ? 1 : -1) * capped;
        s->terms[n] = s->cap * (fabs(elastic) + fabs(m->force[n] - elastic)) + fabs(spring) + fabs(damper);
    }
    s->test[0][ORDER] = s->test[1][ORDER] = 0;
}

/* Sets w and `held`, which is u^-least times the spring force in the direction of slip. The spring force is the cap,
 * minus the force of a damper that the cap includes. */
static void expand_slip(struct slide *s)
{
    const struct motion *const m = &s->m;
    const double *const x_a = power_series(s, s->elastic), *const slope = power_series(s, s->time);
    const double cap = s->cap * s->sign, press = m->press * m->unit * s->d,
                 damper = s->damper_in_cap ? s->side * s->gamma : 0;
    s->series_w[0] = s->w;
    for (int n = 0; n < ORDER; n++) {
        const double spring = cap * m->spring[0].factor * x_a[n],
                     damping = m->damper.factor > 0 ? cap * m->damper.factor * times(s, s->damping, m->v, n) : 0,
                     damped = damper != 0 ? damper * times(s, s->damping, s->series_w, n) : 0;
        s->held[n] = spring + damping - damped;
        s->terms[n] = fabs(spring) + fabs(damping) + fabs(damped);
        s->series_w[n + 1] = s->side * cap * (m->v[n + 1] - press * slope[n] / (n + 1));
    }
    s->held[ORDER] = 0;
}

/* Sets `excess` to T u/u^least times a difference: the rate at which the spring force would grow in the direction of
 * the slip, minus the rate of the held force. The contact slips while the difference is positive. If w is NULL, the
 * first rate is omitted. */
static void expand_excess(struct slide *s, double *excess, const double *w)
{
    double rise[ORDER + 1] = {0}; /* derivative of `held` in s */
    for (int n = 0; n < ORDER; n++)
        rise[n] = (n + 1) * s->held[n + 1] / s->m.unit;
    for (int n = 0; n < ORDER; n++) {
        const double grows = w ? s->side * s->kappa * s->d * times(s, s->stiff, w, n) : 0, rises = times(s, 1, rise, n),
                     shrinks = (s->r * s->d - s->least) * product_coefficient(s->m.v, s->held, n);
        excess[n] = grows - rises + shrinks;
        s->terms[n] += fabs(grows) + fabs(rises) + fabs(shrinks);
    }
    excess[ORDER - 1] = excess[ORDER] = 0; /* these two need the unknown last coefficient of `held` */
}

/* Sets w to the threshold, and `test` to the two conditions of creep. The contact creeps while w would fall below the
 * threshold if it slipped, and would exceed the threshold if it stuck. */
static void expand_creep(struct slide *s)
{
    const double *const stiff = power_series(s, s->stiff), *const slope = power_series(s, s->time),
                        *const x_b = power_series(s, s->damper);
    double threshold[ORDER + 1];
    expand_slip(s);
    expand_excess(s, threshold, NULL);
    for (int n = 0; n < ORDER - 1; n++) {
        double rest = -s->side * threshold[n] / (s->kappa * s->d);
        for (int k = 1; k <= n; k++)
            rest -= stiff[k] * s->series_w[n - k];
        s->series_w[n] = rest / stiff[0];
    }
    s->series_w[ORDER - 1] = s->series_w[ORDER] = 0; /* as in expand_excess */
    for (int n = 0; n < ORDER; n++) {
        const double rise = s->side * (n + 1) * s->series_w[n + 1] / s->m.unit;
        s->damped[n] = s->side * s->gamma * product_coefficient(x_b, s->series_w, n);
        const double slips = s->d * s->cap * s->sign * product_coefficient(slope, s->m.force, n);
        s->test[0][n] = slips + rise;
        s->terms[n] = fabs(slips) + fabs(rise);
        s->test[1][n] = -s->test[0][n] - s->d * product_coefficient(slope, s->damped, n);
    }
    for (int k = 0; k < 2; k++)
        s->test[k][ORDER - 2] = s->test[k][ORDER - 1] = s->test[k][ORDER] = 0;
}

/* ---- modes ---- */

/* Returns a step at which the last terms of a series are negligible. A series that starts at or near x = 0 has gaps. */
static double longest_step(const double *c, double size)
{
    double growth = -INFINITY; /* binary logarithm of the largest ratio of coefficients */
    for (int n = ORDER / 2; n <= ORDER; n++) {
        int exponent;
        if (c[n] != 0 && isless(fabs(c[n] / size), INFINITY)) {
            frexp(c[n] / size, &exponent);
            growth = fmax(growth, (double)exponent / n);
        }
    }
    return RATIO * exp2(-growth);
}

/* Begins a mode at the start of the step of m. A contact that slipped and now sticks keeps its spring force. If the
 * cap includes the damper, the spring force near x = 0 is of the order of x^b, b < a. If b < r, this force needs an
 * infinite q. The contact then slips in the opposite direction. */
static void change_mode(struct slide *s, int mode, double side)
{
    const int touches = cor_motion_start(&s->m) == 0, order = (int)lround(s->r * s->d);
    mode = mode == CREEPS && touches ? STICKS : mode;
    if (mode == STICKS && s->mode != STICKS && s->kappa > 0 && touches) {
        s->q = s->least == order ? s->side * s->held[0] / s->kappa : 0;
        if (s->least < order && s->held[0] != 0) {
            mode = SLIPS;
            side = -s->side;
        }
    } else if (mode == STICKS && s->mode != STICKS && s->kappa > 0) {
        const double damper = s->damper_in_cap ? s->gamma * power_series(s, s->damper)[0] * s->w : 0;
        s->q = (s->side * s->cap * s->sign * s->m.force[0] - damper) / (s->kappa * power_series(s, s->spring)[0]);
    }
    s->mode = mode;
    s->side = side;
}

/* Expands the tangential motion. Returns the place at which the mode ends, or the length of the step. */
static double expand_mode(struct slide *s, double end, int *next, double *side)
{
    double step, place[2] = {INFINITY, INFINITY};
    *next = STICKS;
    *side = s->side;
    if (s->mode == STICKS)
        expand_stick(s);
    else if (s->mode == SLIPS)
        expand_slip(s);
    else
        expand_creep(s);
    if (s->mode == CREEPS && !(fabs(s->series_w[0] - s->w) < JUMP * s->size)) {
        s->series_w[0] = s->w; /* next to x = 0 all forces are small for any w */
        return 0;
    }
    step = fmin(end, longest_step(s->series_w, s->size));
    if (s->mode == STICKS)
        step = fmin(step, longest_step(s->series_q, s->size / fmax(1, sqrt(s->kappa))));
    if (!s->slips)
        return step;
    if (s->idle >= MOST_IDLE) /* only rounding errors distinguish the modes: keep this mode for a short step */
        return *next = s->mode, fmin(step, s->moment);
    if (s->mode == SLIPS) {
        if (s->memory == COR_REMEMBERS_NOTHING)
            for (int n = 0; n <= ORDER; n++)
                s->test[0][n] = -s->held[n];
        else
            expand_excess(s, s->test[0], s->series_w);
        place[0] = first_fall(s->test[0], s->terms, step);
        if (!s->damper_in_cap && s->gamma > 0)
            *next = CREEPS;
    } else {
        for (int k = 0; k < 2; k++)
            place[k] = first_fall(s->test[k], s->terms, step);
        if (s->mode == STICKS || place[0] < place[1])
            *next = SLIPS;
        if (s->mode == STICKS)
            *side = place[0] <= place[1] ? 1 : -1;
    }
    const double first = fmin(place[0], place[1]);
    /* If a damper outside the cap makes the force jump, the place must be accurate: expand again next to it. */
    const int jumps = s->mode == STICKS && !s->damper_in_cap && s->gamma > 0;
    if (first < step && !(jumps && first > NEAR * step))
        return first;
    *next = s->mode;
    return first < step ? (1 - NEAR) * first : step;
}

/* ---- an impact ---- */

/* Length and time for which mass, stiffness and impact speed are 1 */
struct scales {
    double length, time;
};

static struct scales speed_scales(const struct cor_scene_contact *contact, double speed_m_s)
{
    const double a = cor_elastic(&contact->law), ratio = cor_quiet_quotient(contact->mass_kg, contact->stiffness),
                 time = cor_quiet_product(cor_quiet_power(ratio, 1 / (a + 1)),
                                          cor_quiet_power(speed_m_s, (1 - a) / (1 + a)));
    return (struct scales){cor_quiet_product(time, speed_m_s), time};
}

/* Sets the units of the normal motion. They come from the impact speed, and are smaller if damping or constant force
 * exceeds the inertia. Returns 0 if the motion overflows. */
static int begin(struct slide *s, const struct cor_scene_contact *contact, const struct cor_tangential *tangential,
                 double speed_m_s)
{
    const struct cor_exponents *const law = &contact->law;
    const double a = cor_elastic(law), b = cor_damping(law), beta = cor_scene_beta(contact, speed_m_s);
    const int twice = law->denominator % 2 ? 2 : 1, d = twice * law->denominator;
    const double time = speed_scales(contact, speed_m_s).time;
    const double press = contact->force_n > 0 ? cor_quiet_quotient(cor_quiet_product(contact->force_n, time),
                                                                   cor_quiet_product(contact->mass_kg, speed_m_s))
                                              : 0;
    double length = beta > 1 ? cor_quiet_power(beta, -1 / (b + 1)) : 1, unit = length;
    if (press > 1) {
        length = cor_quiet_power(press, 1 / a);
        unit = sqrt(length / press);
    }
    struct motion *const m = &s->m;
    m->time[0] = (struct motion_term){(double)d, d - 1, 0};
    m->spring[0] = (struct motion_term){cor_quiet_power(length, a - 1) * unit * unit, twice * law->elastic, 0};
    m->damper = (struct motion_term){beta * cor_quiet_power(length, b) * unit, twice * law->damping, 0};
    m->time[1] = m->spring[1] = (struct motion_term){0, 0, 0};
    m->press = press * unit * unit / length;
    if (!cor_motion_init(m, 0, unit / length))
        return 0;
    m->follows_energy = press > 1;
    s->d = d;
    s->memory = tangential->kappa == 0 && tangential->damper_in_cap ? COR_REMEMBERS_NOTHING : tangential->memory;
    s->damper_in_cap = tangential->damper_in_cap || s->memory == COR_REMEMBERS_NOTHING;
    s->p = tangential->constant_stiffness ? 0 : a - 1;
    s->kappa = s->memory == COR_REMEMBERS_NOTHING ? 0 : tangential->kappa * unit * unit * cor_quiet_power(length, s->p);
    s->gamma = tangential->damping * unit * cor_quiet_power(length, b);
    s->cap = length / unit;
    return isless(press, PRESS_MOST) && isless(s->kappa, KAPPA_MOST);
}

/* Sets r and the powers of u that it needs. */
static int set_memory(struct slide *s, int returns)
{
    const int shrinks = s->memory == COR_REMEMBERS_DISPLACEMENT_RESCALED || s->memory == COR_REMEMBERS_FORCE_RESCALED;
    const int force = s->memory == COR_REMEMBERS_FORCE || s->memory == COR_REMEMBERS_FORCE_RESCALED ||
                      s->memory == COR_REMEMBERS_NOTHING;
    const int pd = (int)lround(s->p * s->d), rd = (force ? 0 : pd) + (shrinks && returns ? s->d / 2 : 0);
    struct motion *const m = &s->m;
    s->r = (double)rd / s->d;
    s->time = cor_motion_power(m, s->d - 1);
    s->spring = cor_motion_power(m, rd > 0 ? rd : 0);
    s->rate = cor_motion_power(m, s->d - 1 + pd - rd);
    s->damper = cor_motion_power(m, m->damper.exponent);
    const int ad = m->spring[0].exponent, bd = m->damper.exponent;
    s->least = pd + s->d < ad ? pd + s->d : ad;
    if (bd < s->least && (m->damper.factor > 0 || (s->gamma > 0 && s->damper_in_cap)))
        s->least = bd;
    s->stiff = cor_motion_power(m, pd + s->d - s->least);
    s->elastic = cor_motion_power(m, ad - s->least);
    s->damping = cor_motion_power(m, bd > s->least ? bd - s->least : 0);
    return m->powers < MOTION_POWERS && rd >= 0 && pd + s->d >= 0;
}

/* Follows the impact to its end. Returns 0 if it needs too many steps. */
static int follow(struct slide *s, int end)
{
    struct motion *const m = &s->m;
    int next = STICKS, returns = 0, moves = 1;
    double side = 1, most = 0, whole = 0, parts = 0, vanishes = INFINITY, turns = 0;
    /* most: the largest u. moves: the normal motion needs a new expansion, whose length is `whole` */
    s->mode = STICKS;
    s->side = s->sign = 1;
    for (int k = 0; k < MOST_STEPS; k++) {
        if (moves) {
            double force[ORDER + 1];
            if (!cor_motion_expand(m))
                return 0;
            m->force[0] = isless(vanishes, INFINITY) ? 0 : m->force[0]; /* the force vanishes here */
            for (int n = 0; n <= ORDER; n++)
                force[n] = s->sign * m->force[n];
            parts = vanishes = turns = INFINITY;
            const double size = fmax(cor_motion_start(m), fabs(m->v[0]));
            whole = fmin(longest_step(m->v, size), longest_step(m->power[1].c, size));
            whole = fmin(whole, STRETCH * m->step);
            s->moment = MOMENT * whole;
            if (!returns)
                whole = fmin(whole, turns = first_fall(m->v, m->v, whole));
            if (m->v[0] < 0) {
                whole = fmin(whole, parts = first_fall(m->power[1].c, m->power[1].c, whole));
                whole = fmin(whole, vanishes = first_fall(force, force, whole));
            }
        }
        change_mode(s, next, side);
        const double step = expand_mode(s, whole, &next, &side);
        s->idle = step >= s->moment ? 0 : s->idle + 1;
        if (step > 0)
            s->parts |= s->mode == SLIPS ? COR_OBLIQUE_SLIPS : COR_OBLIQUE_STICKS;
        s->w = value_at(s->series_w, step);
        s->q = s->mode == STICKS ? value_at(s->series_q, step) : s->q;
        m->step = step;
        cor_motion_advance(m);
        if (parts <= step || (returns && cor_motion_start(m) < MOMENT * most) ||
            (vanishes <= step && end == COR_END_ZERO_FORCE))
            return 1;
        moves = step > 0 || vanishes <= step;
        if (vanishes <= step) {
            s->sign = -s->sign;
            next = STICKS;
        } else {
            vanishes = moves ? (double)INFINITY : vanishes;
        }
        if (turns <= step) {
            const double r = s->r;
            returns = moves = 1;
            most = cor_motion_start(m);
            if (!set_memory(s, returns))
                return 0;
            s->q *= cor_quiet_power(whole_power(most, s->d), r - s->r);
        }
    }
    return 0;
}

#ifdef __GNUC__
#define NOT_INLINE static __attribute__((noinline))
#else
#define NOT_INLINE static
#endif

/* Computes an impact for arguments in range. It is not inlined, so that cor_scene_eps needs less stack. */
NOT_INLINE int follow_impact(struct cor_oblique_impact *oblique, const struct cor_scene_contact *contact,
                             const struct cor_tangential *tangential, double friction, double speed_m_s, double tangent,
                             int end)
{
    struct slide s;
    if (!begin(&s, contact, tangential, speed_m_s) || !set_memory(&s, 0))
        return COR_FAULT_RANGE;
    const double speed = s.m.v[0];
    s.slips = tangent > 0 && !cor_is_infinity(friction); /* tangent 0: the limit of small angles */
    s.cap *= s.slips ? 3.5 * friction : 0;
    s.w = s.size = tangent > 0 ? tangent : 1;
    s.q = 0;
    s.idle = s.parts = 0;
    s.terms[ORDER] = 0;
    if (!follow(&s, end))
        return COR_FAULT_PRESSED;
    oblique->eps = contact->force_n > 0 ? oblique->eps : fmax(-s.m.v[0] / speed, 0);
    oblique->restitution = s.w / s.size;
    oblique->rebound_tangent = cor_quiet_quotient(cor_quiet_product(tangent, oblique->restitution), oblique->eps);
    oblique->impulse = tangent * (1 - oblique->restitution) / 3.5;
    oblique->regime = s.parts;
    return COR_FAULT_NONE;
}

/* Returns time_step_s. If the damper exceeds the cap at first touch, the first step gives the spring an opposite force,
 * which then grows faster than the damper's. At `spread` times the overlap of the first step the contact slips
 * backwards, up to the overlap slip_end. With infinitely small steps it slips backwards immediately. Before it slips,
 * the force is wrong by at most twice the cap. This error is tolerable up to the overlap `early`. */
static double needed_step(const struct cor_scene_contact *contact, const struct cor_tangential *t, double friction,
                          double speed_m_s, double tangent)
{
    const double p = t->constant_stiffness ? 0 : cor_elastic(&contact->law) - 1, b = cor_damping(&contact->law),
                 cap = 3.5 * friction * cor_scene_beta(contact, speed_m_s), force = t->damping * tangent;
    const int displaced = t->memory == COR_REMEMBERS_DISPLACEMENT || t->memory == COR_REMEMBERS_DISPLACEMENT_RESCALED;
    if (!t->damper_in_cap || !displaced || b >= p || !(t->kappa > 0 && cap > 0 && isless(cap, force)))
        return INFINITY;
    const double spread = cor_quiet_power(1 + cor_quiet_quotient(2 * cap, force - cap), 1 / (p - b)),
                 slip_end = cor_quiet_power((cap + force) * (p - b) / (t->kappa * tangent), 1 / (1 + p - b)),
                 early = cor_quiet_power(0.1 * COR_OBLIQUE_STEP_ERROR * tangent * (b + 1) / cap, 1 / (b + 1));
    return cor_quiet_product(cor_quiet_quotient(fmin(early, slip_end / 5), spread),
                             speed_scales(contact, speed_m_s).time);
}

static int is_within(double x, double largest)
{
    return isgreaterequal(x, 0) && x <= largest;
}

int cor_scene_oblique(struct cor_oblique_impact *oblique, const struct cor_scene_contact *contact,
                      const struct cor_tangential *tangential, double friction, double speed_m_s, double tangent,
                      int end)
{
    const int memory = tangential->memory,
              rescaled = memory == COR_REMEMBERS_DISPLACEMENT_RESCALED || memory == COR_REMEMBERS_FORCE_RESCALED;
    *oblique = (struct cor_oblique_impact){NAN, NAN, NAN, NAN, NAN, 0};
    if (!cor_contact_is_sound(contact) || !is_within(cor_scene_beta(contact, speed_m_s), COR_OBLIQUE_MOST) ||
        !(is_within(friction, COR_OBLIQUE_MOST) || cor_is_infinity(friction)) ||
        !is_within(tangent, COR_OBLIQUE_MOST) || !is_within(tangential->kappa, COR_OBLIQUE_MOST) ||
        !is_within(tangential->damping, COR_OBLIQUE_MOST) || memory < 0 || memory >= COR_TANGENTIAL_MEMORIES ||
        (rescaled && tangential->constant_stiffness) || !cor_scene_has_end(contact, end) || contact->plate ||
        contact->plastic || contact->liquid_speed_m_s > 0 || contact->adhesion_j_m2 > 0)
        return COR_FAULT_RANGE;
    if (contact->force_n > 0 || cor_scene_beta(contact, speed_m_s) > 0.5) { /* the bodies may stay together */
        const int status = cor_scene_eps(&oblique->eps, contact, speed_m_s, end);
        if (oblique->eps == 0 || (contact->force_n > 0 && status != COR_FAULT_NONE))
            return status;
    }
    oblique->time_step_s = needed_step(contact, tangential, friction, speed_m_s, tangent);
    return follow_impact(oblique, contact, tangential, friction, speed_m_s, tangent, end);
}

/* ---- models of simulators ---- */

const struct cor_tangential_model cor_tangential_models[COR_TANGENTIAL_MODELS] = {
    {"displacement", "", COR_REMEMBERS_DISPLACEMENT, 0, 1},
    {"force", "", COR_REMEMBERS_FORCE, 0, 1},
    {"rescaled", "", COR_REMEMBERS_DISPLACEMENT_RESCALED, 0, 1},
    {"rescaled-force", "", COR_REMEMBERS_FORCE_RESCALED, 0, 1},
    {"viscous", "", COR_REMEMBERS_NOTHING, 0, 1},
    {"mindlin", "LAMMPS", COR_REMEMBERS_DISPLACEMENT, 0, 1},
    {"mindlin/force", "LAMMPS", COR_REMEMBERS_FORCE, 0, 1},
    {"mindlin_rescale", "LAMMPS", COR_REMEMBERS_DISPLACEMENT_RESCALED, 0, 1},
    {"mindlin_rescale/force", "LAMMPS", COR_REMEMBERS_FORCE_RESCALED, 0, 1},
    {"linear_history", "LAMMPS", COR_REMEMBERS_DISPLACEMENT, 1, 1},
    {"linear_nohistory", "LAMMPS", COR_REMEMBERS_NOTHING, 1, 1},
    {"history", "LIGGGHTS", COR_REMEMBERS_DISPLACEMENT, 0, 0},
    {"hertz-mindlin", "YADE, MindlinPhys", COR_REMEMBERS_FORCE, 0, 0},
    {"viscel", "YADE, ViscElPhys", COR_REMEMBERS_FORCE, 1, 0},
    {"cundall-strack", "YADE, FrictPhys", COR_REMEMBERS_FORCE, 1, 0},
    {"sliding-friction", "MercuryDPM", COR_REMEMBERS_DISPLACEMENT, 1, 1},
};

int cor_scene_tangential_scaled(struct cor_tangential *tangential, const struct cor_scene_contact *contact,
                                enum cor_tangential_id model_id, double stiffness, double damping_coefficient,
                                double speed_m_s)
{
    const double a = cor_elastic(&contact->law), b = cor_damping(&contact->law), nothing = NAN;
    *tangential = (struct cor_tangential){0, 0, 0, nothing, nothing};
    if (!cor_contact_is_sound(contact) || !cor_si_in_range(speed_m_s) || (int)model_id < 0 ||
        model_id >= COR_TANGENTIAL_MODELS || !(isgreater(contact->mass_kg, 0) && isgreater(contact->stiffness, 0)))
        return COR_FAULT_RANGE;
    const struct cor_tangential_model *const model = &cor_tangential_models[model_id];
    const struct scales unit = speed_scales(contact, speed_m_s);
    const double p = model->constant_stiffness ? 0 : a - 1;
    const double spring =
        cor_quiet_product(cor_quiet_quotient(stiffness, contact->stiffness), cor_quiet_power(unit.length, p - (a - 1)));
    const double damper = cor_quiet_product(cor_quiet_quotient(damping_coefficient, contact->mass_kg),
                                            cor_quiet_product(unit.time, cor_quiet_power(unit.length, b)));
    *tangential = (struct cor_tangential){model->memory, model->constant_stiffness, model->damper_in_cap, 3.5 * spring,
                                          3.5 * damper};
    return is_within(tangential->kappa, COR_OBLIQUE_MOST) && is_within(tangential->damping, COR_OBLIQUE_MOST)
               ? COR_OK
               : COR_FAULT_RANGE;
}
