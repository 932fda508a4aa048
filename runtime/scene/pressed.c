/* SPDX-License-Identifier: MIT */
/* Collisions under a constant force. With x = w^d and dt = d w^(d-1) ds the law is the polynomial system
 *
 *     dw/ds = v,     dv/ds = -d w^(d-1) (F - f),     F = elastic w^(a d) + damper w^(b d) v
 *
 * which is regular at x = 0 and at the turning point v = 0. d is at least 2, so that w = v = 0 is a state of rest. A
 * motion that turns just before x = 0 therefore turns slowly in s, and no step passes over the turn. */
#include "runtime/scene/motion.h"

#include "runtime/scene/exponents.h"

static int motion_init(struct motion *m, const struct cor_exponents *law, double elastic, double damper, double press,
                       double speed)
{
    const int twice = law->denominator == 1 ? 2 : 1, d = twice * law->denominator;
    m->time[0] = (struct motion_term){(double)d, d - 1, 0};
    m->spring[0] = (struct motion_term){elastic, twice * law->elastic, 0};
    m->damper = (struct motion_term){damper, twice * law->damping, 0};
    m->time[1] = m->spring[1] = (struct motion_term){0, 0, 0};
    m->press = press;
    return cor_motion_init(m, 0, speed);
}

double cor_pressed_force_max(const struct cor_exponents *law, double elastic, double damper)
{
    struct motion m;
    double force_max;
    return motion_init(&m, law, elastic, damper, 0, 1) && cor_motion_compress(&m, &force_max, NULL) ? force_max
                                                                                                    : (double)NAN;
}

/* ---- the end of the contact ---- */

static int order_of(const struct motion *m) /* returns d */
{
    return m->time[0].exponent + 1;
}

static double overlap_of(const struct motion *m)
{
    return whole_power(cor_motion_start(m), order_of(m));
}

/* Returns the force divided by the power of w that both of its terms contain. */
static double contact_force(const struct motion *m, double s, double level)
{
    const int ad = m->spring[0].exponent, bd = m->damper.exponent, low = ad < bd ? ad : bd;
    const double w = cor_motion_u(m, s, 0);
    return m->spring[0].factor * whole_power(w, ad - low) +
           m->damper.factor * whole_power(w, bd - low) * cor_motion_v(m, s, 0) - level;
}

/* Returns elastic x^(a+1)/(a+1). */
static double spring_energy(const struct motion *m, double w)
{
    const int d = order_of(m), ad = m->spring[0].exponent;
    return m->spring[0].factor * whole_power(w, ad + d) * d / (ad + d);
}

/* Returns v^2/2 + elastic x^(a+1)/(a+1) - f x, which never grows. */
static double energy_of(const struct motion *m)
{
    const double w = cor_motion_start(m);
    return m->follows_energy ? m->energy - m->loss[0]
                             : m->v[0] * m->v[0] / 2 + spring_energy(m, w) - m->press * whole_power(w, order_of(m));
}

/* Returns w at the least overlap at which the force can vanish. Returns -1 if 2 (a - b) <= 1: the force can then vanish
 * at any overlap. */
static double release_height(const struct motion *m)
{
    const int d = order_of(m), difference = m->spring[0].exponent - m->damper.exponent, power = 2 * difference - d;
    const double ratio = cor_quiet_quotient(m->damper.factor, m->spring[0].factor);
    const double square = cor_quiet_product(cor_quiet_product(m->press, ratio), ratio);
    return power > 0 ? cor_quiet_power(cor_quiet_product(square, d) / difference, 1.0 / power) : -1; /* w */
}

/* Returns the overlap at which force and spring balance. */
static double overlap_of_rest(const struct motion *m)
{
    return cor_quiet_power(cor_quiet_quotient(m->press, m->spring[0].factor),
                           (double)order_of(m) / m->spring[0].exponent);
}

/* True if x rises to the equilibrium x_e without passing it: c = damper x^b > 2 sqrt(dF/dx) and x'/(x_e - x) < c/2. */
static int creeps_up(const struct motion *m)
{
    const double a = (double)m->spring[0].exponent / order_of(m), rest = overlap_of_rest(m), x = overlap_of(m);
    const double damping = m->damper.factor * whole_power(cor_motion_start(m), m->damper.exponent);
    const double steepest = fmax(cor_quiet_power(rest, a - 1), cor_quiet_power(x, a - 1)),
                 stiffness = cor_quiet_product(m->spring[0].factor * a, steepest);
    return x < rest && damping * damping > 4 * stiffness && m->v[0] < damping / 2 * (rest - x);
}

/* The units of length and time of a motion, and its speed at x = 0 in these units */
struct scales {
    double length, time, speed;
};

static void set_end(struct cor_full_impact *impact, int end, double eps, double duration)
{
    impact->eps[end] = eps;
    impact->duration[end] = duration;
}

static void part_at_zero_overlap(struct cor_full_impact *impact, const struct motion *m, double s,
                                 const struct scales *unit)
{
    const double left = fmax(m->energy - cor_motion_loss(m, s), 0);
    const double speed = m->follows_energy ? sqrt(2 * left) : -cor_motion_v(m, s, 0);
    set_end(impact, COR_END_ZERO_OVERLAP, speed / unit->speed, cor_motion_t(m, s) * unit->time);
}

/* Sets the end at the surface. The force vanishes at s, with overlap x and speed v. A body that flies on to x = 0
 * arrives with the speed (v^2 - 2 f x)^(1/2). If this root is not real, the body falls back and stays in contact. */
static void part_at_surface(struct cor_full_impact *impact, const struct motion *m, double s, const struct scales *unit)
{
    const double w = cor_motion_u(m, s, 0), x = whole_power(w, order_of(m)), v = -cor_motion_v(m, s, 0);
    const double square =
        m->follows_energy ? 2 * (m->energy - cor_motion_loss(m, s) - spring_energy(m, w)) : v * v - 2 * m->press * x;
    if (!(square > 0))
        return;
    const double speed = sqrt(square);
    set_end(impact, COR_END_ZERO_FORCE, speed / unit->speed, (cor_motion_t(m, s) + 2 * x / (v + speed)) * unit->time);
}

/* Follows the rebound from the turning point to the end, or until the energy does not suffice to reach the end. */
static int follow_rebound(struct cor_full_impact *impact, struct motion *m, int ends_differ, const struct scales *unit)
{
    const double release = ends_differ ? release_height(m) : -1; /* the force can vanish only at w >= release */
    int held = !ends_differ, parted = 0; /* held: the end at the surface is found or cannot occur */
    for (int k = 0; !parted && energy_of(m) >= 0; k++) {
        if (k == MOTION_MOST_STEPS || !cor_motion_expand(m))
            return COR_FAULT_PRESSED;
        double end = m->step;
        parted = cor_motion_u(m, end, 0) <= 0;
        if (parted) {
            end = cor_motion_root(m, cor_motion_u, 0, end, 0);
            part_at_zero_overlap(impact, m, end, unit);
        }
        const int below = cor_motion_start(m) > release && cor_motion_u(m, end, 0) < release;
        const double last = release > 0 && below ? cor_motion_root(m, cor_motion_u, 0, end, release) : end;
        if (!held && contact_force(m, last, 0) < 0) {
            part_at_surface(impact, m, cor_motion_root(m, contact_force, 0, last, 0), unit);
            held = 1;
        }
        held = held || last < end;
        cor_motion_advance(m);
    }
    if (!ends_differ)
        set_end(impact, COR_END_ZERO_FORCE, impact->eps[COR_END_ZERO_OVERLAP], impact->duration[COR_END_ZERO_OVERLAP]);
    return COR_FAULT_NONE;
}

/* ---- slow impacts and weak damping: an elastic motion from rest, which loses the energy `damping` times J ---- */

#define SLOW 1e-8           /* largest speed of a slow impact; its square is neglected */
#define WEAK 1e-16          /* largest damping of a slow impact */
#define EXPONENT_MOST 100.0 /* largest argument of the beta functions */
#define RELEASE_SHARE 1e-17 /* largest share of the impact energy in the spring when the force vanishes */

static double beta_function(double x, double y)
{
    return tgamma(x) * tgamma(y) / tgamma(x + y);
}

/* Returns (2 damping J)^(1/2). J is int x^b x' dx to the turning point and back, which is 2^(3/2) (a+1)^p/a B(p, 3/2)
 * with p = (b + 3/2)/a. */
static double slow_sticking_speed(const struct cor_exponents *law, double damping)
{
    const double a = cor_elastic(law), p = (cor_damping(law) + 1.5) / a;
    if (!(p < EXPONENT_MOST))
        return INFINITY; /* the motion is not slow */
    const double factor = cor_quiet_product(cor_quiet_product(damping * 4, sqrt(2)), cor_quiet_power(a + 1, p));
    return sqrt(cor_quiet_product(factor / a, beta_function(p, 1.5)));
}

/* True if the motion at this speed is nearly elastic. The force vanishes at x^(a-b) = damping v, where v^2 is about
 * speed^2 + 2 x. */
static int is_slow(const struct cor_exponents *law, double damping, double speed)
{
    const double a = cor_elastic(law), b = cor_damping(law), c = a - b;
    if (!(speed < SLOW && damping < WEAK && (b + 1.5) / a < EXPONENT_MOST))
        return 0;
    const double fast = c > 0 ? cor_quiet_power(2 * damping * speed, 1 / c) : 0;
    const double late = c > 0.5 ? cor_quiet_power(4 * damping, 1 / (c - 0.5)) : 0;
    return cor_quiet_power(fmax(fast, late), (a + 1) / 2) < sqrt(RELEASE_SHARE) * speed;
}

static void solve_slow(struct cor_full_impact *impact, const struct cor_exponents *law, double damping, double speed)
{
    const double a = cor_elastic(law), p = 0.5 / a,
                 ratio = cor_quiet_quotient(slow_sticking_speed(law, damping), speed);
    const double eps = ratio < 1 ? sqrt((1 - ratio) * (1 + ratio)) : 0;
    const double elastic = sqrt(2) * pow(a + 1, p) / a * beta_function(p, 0.5); /* the duration from rest */
    for (int end = 0; end < COR_SCENE_ENDS; end++)
        set_end(impact, end, eps, eps > 0 ? elastic - speed * (1 + eps) : INFINITY);
    impact->max_overlap = pow(a + 1, 1 / a);
    impact->force_max = a + 1;
}

/* ---- a collision ---- */

#define MOST_SPEED 1e140 /* higher speeds overflow */
#define SLOWEST 1e-12    /* lower speeds count as this one, at which bodies stick if the damping is above WEAK */

/* Returns the units of a motion, set by the speed or by the constant force. Strong damping makes the units smaller. */
static struct scales motion_scales(const struct cor_exponents *law, double damping, double speed, int *is_forced)
{
    const double a = cor_elastic(law), b = cor_damping(law), length = cor_quiet_power(speed, 2 / (a + 1));
    const double beta =
        damping > 0 ? cor_quiet_quotient(cor_quiet_product(damping, cor_quiet_power(length, b + 1)), speed) : 0;
    const double unit = beta > 1 ? cor_quiet_power(beta, -1 / (b + 1)) : 1;
    const double strong = damping > 1 ? cor_quiet_power(damping, -1 / (b + 0.5)) : 1;
    *is_forced = cor_quiet_power(length, a) < unit; /* the constant force is length^-a if the speed sets the units */
    return *is_forced ? (struct scales){strong, sqrt(strong), cor_quiet_quotient(speed, sqrt(strong))}
                      : (struct scales){length * unit, cor_quiet_quotient(length * unit, speed), 1};
}

int cor_pressed_solve(struct cor_full_impact *impact, const struct cor_exponents *law, double damping, double speed)
{
    const double a = cor_elastic(law), b = cor_damping(law);
    struct motion m;
    int is_forced;
    *impact = cor_together;
    if (!(isless(damping, INFINITY) && isgreater(speed, 0) && isless(speed, MOST_SPEED)))
        return COR_FAULT_PRESSED;
    if (is_slow(law, damping, speed)) {
        solve_slow(impact, law, damping, speed);
        return COR_FAULT_NONE;
    }
    if (speed < SLOWEST && damping < WEAK) /* too slow for the series, and solve_slow does not apply */
        return COR_FAULT_PRESSED;
    const struct scales unit = motion_scales(law, damping, fmax(speed, SLOWEST), &is_forced);
    const double acceleration = cor_quiet_quotient(unit.length, cor_quiet_product(unit.time, unit.time));
    const double spring = cor_quiet_quotient(cor_quiet_power(unit.length, a), acceleration);
    const double damper = cor_quiet_quotient(cor_quiet_product(damping, cor_quiet_power(unit.length, b + 1)),
                                             cor_quiet_product(unit.time, acceleration));
    if (!motion_init(&m, law, spring, damper, cor_quiet_quotient(1, acceleration), unit.speed))
        return COR_FAULT_PRESSED;
    m.follows_energy = is_forced;
    if (!cor_motion_compress(&m, &impact->force_max, creeps_up))
        return COR_FAULT_PRESSED;
    impact->max_overlap = cor_quiet_product(m.v[0] > 0 ? overlap_of_rest(&m) : overlap_of(&m), unit.length);
    impact->force_max = cor_quiet_product(impact->force_max, acceleration);
    const int status = follow_rebound(impact, &m, law->elastic > law->damping && damping > 0, &unit);
    for (int end = 0; end < COR_SCENE_ENDS && damping == 0; end++)
        impact->eps[end] = 1;
    return status;
}

/* ---- the sticking speed ---- */

#define LARGEST_OVERLAP 1e15
#define START 1e-8 /* fraction of the energy that damper and spring take up to the first x; its square is neglected */

double cor_pressed_sticking_speed(const struct cor_exponents *law, double damping, int end)
{
    const double a = cor_elastic(law), b = cor_damping(law), slow = slow_sticking_speed(law, damping);
    struct motion m;
    if (!isless(damping, INFINITY))
        return NAN;
    if (damping == 0 || is_slow(law, damping, slow))
        return damping == 0 ? 0 : slow;
    if (!motion_init(&m, law, 1, damping, 1, 0))
        return NAN;
    m.damper.factor = -damping; /* backward in time */
    m.follows_energy = 1;
    double x = fmin(cor_quiet_power(START / fmax(damping, 1), 1 / (b + 0.5)), cor_quiet_power(START, 1 / a));
    m.loss[0] = -cor_quiet_product(cor_quiet_product(sqrt(2), damping), cor_quiet_power(x, b + 1.5)) / (b + 1.5);
    m.v[0] = sqrt(2 * (x - m.loss[0] - cor_quiet_power(x, a + 1) / (a + 1)));
    if (end == COR_END_ZERO_FORCE && 2 * (a - b) > 1) { /* starts at the speed from which a flight just reaches x = 0 */
        x = cor_quiet_power(cor_quiet_product(cor_quiet_product(2, damping), damping), 1 / (2 * (a - b) - 1));
        m.loss[0] = 0;
        m.v[0] = sqrt(2 * x);
        m.energy = cor_quiet_power(x, a + 1) / (a + 1);
    }
    m.power[1].c[0] = cor_quiet_power(x, 1.0 / order_of(&m));
    int turned = 0;
    for (int k = 0; k < MOTION_MOST_STEPS && cor_motion_start(&m) < LARGEST_OVERLAP; k++) {
        if (!cor_motion_expand(&m)) /* the motion has left the range of speeds */
            break;
        const double begin =
            turned || cor_motion_v(&m, m.step, 0) > 0 ? 0 : cor_motion_root(&m, cor_motion_v, 0, m.step, 0);
        turned = turned || begin > 0;
        if (turned && cor_motion_u(&m, m.step, 0) <= 0)
            return sqrt(
                fmax(2 * (m.energy - cor_motion_loss(&m, cor_motion_root(&m, cor_motion_u, begin, m.step, 0))), 0));
        cor_motion_advance(&m);
    }
    return INFINITY;
}
