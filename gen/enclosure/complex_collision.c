/* SPDX-License-Identifier: MIT */
#include "enclosure/complex_collision.h"

enum { MAX_STEPS = 20000 };

/* A step may add this much to the residual that the ball causes, relative to that residual, the slope and the value. */
#define MORE_OF_RESIDUAL 0.25
#define MORE_OF_SLOPE 0.004
#define MORE_OF_VALUE 0.002
/* Largest product of a step and the derivative of the slope */
#define LARGEST_RATE_STEP 0.4
/* Largest radius relative to the value */
#define LARGEST_RADIUS 0.5
#define FIRST_STEP 0.01
#define LARGEST_STEP 0.02
#define SMALLEST_STEP 1e-7

/* Zero force is reached in zeta up to |sqrt(beta)| = NEAR_TO, and in k from NEAR_FROM on. Up to CREEP_TO zero overlap
 * follows in k, and from CREEP_FROM on, where unloading creeps, in Y. */
#define NEAR_FROM 1.05
#define NEAR_TO 1.1
#define CREEP_FROM 1.65
#define CREEP_TO 1.7
#define LAST_Y 2.0
#define LAST_ZETA 0.5

/* ---- the equation along a path ---- */

/* Loading and unloading are in zeta, with g as the dependent variable; the others have y, the fall k. The last four
 * have c1 = 1 and c2 = mu. */
enum path_kind {
    PATH_LOADING,
    PATH_UNLOADING,
    PATH_TURNING, /* in kappa */
    PATH_FORCE,   /* in k = c1 kappa, c2 = 1 */
    PATH_FALL,    /* in r = 1/Y, c1 = c2 = 1 */
    PATH_BEFORE,  /* in L, kappa = -exp(L) */
    PATH_LAST,    /* in delta, kappa = -mu delta */
    PATH_AFTER,   /* in L, kappa = mu - exp(L) */
    PATH_END      /* in delta, kappa = mu - mu^2 delta */
};

/* A straight path, begin + s length, 0 <= s <= 1, length = end - begin */
struct path {
    enum path_kind kind;
    struct complex_ball begin, end, length, c1, c2;
    struct complex_ball beyond; /* PATH_BEFORE: ln(mu) - L at its end */
};

/* The slope with respect to s, its derivative by the dependent variable, and the slope of the time */
struct slopes {
    struct complex_ball slope, derivative, time;
};

static struct complex_ball plus(struct complex_ball x, double number)
{
    return ball_add(x, ball_of(number, 0));
}

/* dg/dzeta = -zeta^2 C g^2/(1 + q), its derivative by g = -zeta^2 C g (2 + q)/(1 + q)^2, q = g zeta^3 C;
 * dt/dzeta = +-2 zeta/(1 + q) */
static struct slopes zeta_slopes(const struct path *p, struct complex_ball zeta, struct complex_ball g)
{
    const double sign = p->kind == PATH_LOADING ? 1 : -1;
    const struct complex_ball square = ball_sqr(zeta);
    const struct complex_ball c = ball_add(ball_mul(p->c2, square), ball_times(p->c1, sign));
    const struct complex_ball force = ball_mul(ball_mul(square, c), g), q = ball_mul(force, zeta);
    const struct complex_ball inverse = ball_inv(plus(q, 1)), part = ball_neg(ball_mul(force, inverse));
    return (struct slopes){ball_mul(part, g), ball_mul(part, ball_mul(plus(q, 2), inverse)),
                           ball_times(ball_mul(zeta, inverse), 2 * sign)};
}

/* dy/dkappa = -kappa y/(2 N), its derivative by y = -kappa^3/(2 N^2), dt/dkappa = 1/N */
static struct slopes turning_slopes(const struct path *p, struct complex_ball kappa, struct complex_ball y)
{
    const struct complex_ball square = ball_sqr(kappa);
    const struct complex_ball force = ball_sub(p->c2, ball_mul(p->c1, kappa));
    const struct complex_ball inverse = ball_inv(ball_add(ball_mul(force, y), square));
    const struct complex_ball part = ball_times(ball_mul(kappa, inverse), -0.5);
    return (struct slopes){ball_mul(part, y), ball_mul(part, ball_mul(square, inverse)), inverse};
}

/* The same with k = c1 kappa, c2 = 1, M = c1^2 y (1 - k) + k^2: dy/dk = -k y/(2 M), its derivative by y = -k^3/(2 M^2),
 * dt/dk = c1/M */
static struct slopes force_slopes(const struct path *p, struct complex_ball k, struct complex_ball y)
{
    const struct complex_ball square = ball_sqr(k);
    const struct complex_ball force = ball_mul(ball_sqr(p->c1), ball_mul(y, plus(ball_neg(k), 1)));
    const struct complex_ball inverse = ball_inv(ball_add(force, square));
    const struct complex_ball part = ball_times(ball_mul(k, inverse), -0.5);
    return (struct slopes){ball_mul(part, y), ball_mul(part, ball_mul(square, inverse)), ball_mul(p->c1, inverse)};
}

/* r = 1/Y: dk/dr = 2 (1/k - 1 + k r)/r^2, its derivative by k = 2 (r - 1/k^2)/r^2, dt/dr = 2/(k r) */
static struct slopes fall_slopes(struct complex_ball r, struct complex_ball k)
{
    const struct complex_ball a = ball_inv(k), b = ball_inv(r), square = ball_times(ball_sqr(b), 2);
    return (struct slopes){ball_mul(plus(ball_add(a, ball_mul(k, r)), -1), square),
                           ball_mul(ball_sub(r, ball_sqr(a)), square), ball_times(ball_mul(a, b), 2)};
}

/* kappa = -q, q = exp(L), r = mu/q = exp(rest), M = y (1 + r) + q: dy/dL = -q y/(2 M), its derivative by y =
 * -q^2/(2 M^2), dt/dL = -1/M */
static struct slopes before_slopes(struct complex_ball L, struct complex_ball rest, struct complex_ball y)
{
    const struct complex_ball q = ball_exp(L), r = ball_exp(rest);
    const struct complex_ball inverse = ball_inv(ball_add(ball_mul(plus(r, 1), y), q));
    const struct complex_ball part = ball_mul(q, inverse);
    return (struct slopes){ball_times(ball_mul(part, y), -0.5), ball_times(ball_sqr(part), -0.5), ball_neg(inverse)};
}

/* kappa = -mu delta, M = y (1 + delta) + mu delta^2: dy/ddelta = -mu delta y/(2 M), its derivative by y =
 * -mu^2 delta^3/(2 M^2), dt/ddelta = -1/M */
static struct slopes last_slopes(const struct path *p, struct complex_ball delta, struct complex_ball y)
{
    const struct complex_ball size = ball_mul(p->c2, delta);
    const struct complex_ball inverse = ball_inv(ball_add(ball_mul(plus(delta, 1), y), ball_mul(size, delta)));
    const struct complex_ball part = ball_mul(size, inverse);
    return (struct slopes){ball_times(ball_mul(part, y), -0.5), ball_times(ball_mul(ball_sqr(part), delta), -0.5),
                           ball_neg(inverse)};
}

/* kappa = mu - q, q = exp(L), r = mu^2/q = exp(rest), M = y - 2 mu + q + r: dy/dL = kappa y/(2 M), its derivative by y
 * = kappa (M - y)/(2 M^2), dt/dL = -1/M */
static struct slopes after_slopes(const struct path *p, struct complex_ball L, struct complex_ball rest,
                                  struct complex_ball y)
{
    const struct complex_ball q = ball_exp(L), r = ball_exp(rest), kappa = ball_sub(p->c2, q);
    const struct complex_ball others = ball_sub(ball_add(q, r), ball_times(p->c2, 2));
    const struct complex_ball inverse = ball_inv(ball_add(others, y));
    const struct complex_ball part = ball_times(ball_mul(kappa, inverse), 0.5);
    return (struct slopes){ball_mul(part, y), ball_mul(part, ball_mul(others, inverse)), ball_neg(inverse)};
}

/* kappa = mu e, e = 1 - mu delta, M = y delta + e^2: dy/ddelta = y mu e/(2 M), its derivative by y = mu e^3/(2 M^2),
 * dt/ddelta = -1/M */
static struct slopes end_slopes(const struct path *p, struct complex_ball delta, struct complex_ball y)
{
    const struct complex_ball e = plus(ball_neg(ball_mul(p->c2, delta)), 1), square = ball_sqr(e);
    const struct complex_ball inverse = ball_inv(ball_add(ball_mul(y, delta), square));
    const struct complex_ball part = ball_times(ball_mul(p->c2, ball_mul(e, inverse)), 0.5);
    return (struct slopes){ball_mul(part, y), ball_mul(part, ball_mul(square, inverse)), ball_neg(inverse)};
}

/* The slopes for every s and every value of the dependent variable in balls */
static struct slopes path_slopes(const struct path *p, struct complex_ball s, struct complex_ball y)
{
    const struct complex_ball at = ball_widened(
        ball_add(ball_centre(p->begin), ball_mul(ball_centre(p->length), s)),
        COMPLEX_BALL_ROUNDING * ball_size(p->length) +
            raised(p->begin.radius * raised(1 - s.re + s.radius) + p->end.radius * raised(s.re + s.radius)));
    const struct complex_ball rest = ball_sub(p->beyond, ball_mul(p->length, plus(s, -1)));
    struct slopes f;
    switch (p->kind) {
    case PATH_LOADING:
    case PATH_UNLOADING:
        f = zeta_slopes(p, at, y);
        break;
    case PATH_TURNING:
        f = turning_slopes(p, at, y);
        break;
    case PATH_FORCE:
        f = force_slopes(p, at, y);
        break;
    case PATH_FALL:
        f = fall_slopes(at, y);
        break;
    case PATH_BEFORE:
        f = before_slopes(at, rest, y);
        break;
    case PATH_LAST:
        f = last_slopes(p, at, y);
        break;
    case PATH_AFTER:
        f = after_slopes(p, at, rest, y);
        break;
    case PATH_END:
        f = end_slopes(p, at, y);
        break;
    }
    f.slope = ball_mul(f.slope, p->length);
    f.derivative = ball_mul(f.derivative, p->length);
    f.time = ball_mul(f.time, p->length);
    return f;
}

/* ---- steps ---- */

/* The dependent variable of every solution, and its time */
struct state {
    struct complex_ball value, time;
};

static double distance(struct complex_ball x, struct complex_ball centre)
{
    return ball_above(ball_sub(x, centre));
}

enum step_outcome { STEP_DONE, STEP_TOO_LONG, STEP_IMPOSSIBLE };

/* One step from s to end. The line has the slope `mean`, that of the ball's centre in the middle of the step. The
 * distance e of a solution from the line obeys |e|' <= rate |e| + residual, where `rate` bounds the real part of the
 * slope's derivative between them. */
static enum step_outcome step(const struct path *p, struct state *y, double s, double end)
{
    const double h = end - s, longest = raised(h), radius = y->value.radius; /* h is exact, or right to 2^-53 */
    const struct complex_ball centre = ball_centre(y->value), middle = ball_of((s + end) / 2, 0);
    const struct complex_ball first = ball_centre(path_slopes(p, ball_of(s, 0), centre).slope);
    const struct complex_ball at_middle =
        path_slopes(p, middle, ball_centre(ball_add(centre, ball_times(first, h / 2)))).slope;
    const struct complex_ball mean = ball_centre(at_middle);
    if (!ball_is_finite(at_middle))
        return STEP_IMPOSSIBLE;

    const struct complex_ball places = ball_widened(middle, longest / 2 + 0x1p-50);
    const struct complex_ball line =
        ball_add(centre, ball_mul(mean, ball_widened(ball_of(h / 2, 0), longest / 2 + 0x1p-50)));
    const struct slopes along = path_slopes(p, places, line);
    const double residual = distance(along.slope, mean);
    if (!(residual <= at_middle.radius * (1 + MORE_OF_RESIDUAL) + MORE_OF_SLOPE * ball_size(mean) +
                          MORE_OF_VALUE * ball_size(centre)) ||
        !(ball_above(along.derivative) * h <= LARGEST_RATE_STEP))
        return STEP_TOO_LONG;

    const double start = raised(radius + longest * residual), tube = 2 * start;
    const struct slopes within = path_slopes(p, places, ball_widened(line, tube));
    const double rate = within.derivative.re + 0x1p-40 * fabs(within.derivative.re) + raised(within.derivative.radius);
    /* |e| <= start if rate <= 0, and exp(rate h) start otherwise */
    const double growth = raised(exp(rate * h) * (1 + 0x1p-40));
    if (!ball_is_finite(within.derivative) || !ball_is_finite(within.time) || (rate > 0 && !(growth * start <= tube)))
        return STEP_TOO_LONG;
    struct complex_ball next = ball_add(centre, ball_times(mean, h));
    next.radius += 0x1p-45 * longest * ball_size(mean); /* h */
    next.radius +=
        rate > 0 ? raised(growth * start) : raised(growth * radius + fmin(longest, raised(1 / -rate)) * residual);
    next.radius = raised(next.radius);
    y->value = next;
    y->time = ball_add(y->time, ball_mul(within.time, ball_widened(ball_of(h, 0), 0x1p-50)));
    return next.radius <= LARGEST_RADIUS * ball_size(next) ? STEP_DONE : STEP_IMPOSSIBLE;
}

/* Follows the solution along a straight path between two numbers, which may be balls. */
static bool follow(struct path *p, enum path_kind kind, struct complex_ball begin, struct complex_ball end,
                   struct state *y)
{
    p->kind = kind;
    p->begin = begin;
    p->end = end;
    p->length = ball_sub(end, begin);
    double s = 0, h = FIRST_STEP;
    for (int k = 0; k < MAX_STEPS && s < 1; k++) {
        const double next = s + h < 1 ? s + h : 1;
        const enum step_outcome outcome = step(p, y, s, next);
        if (outcome == STEP_IMPOSSIBLE)
            return false;
        if (outcome == STEP_DONE) {
            s = next;
            h = fmin(1.5 * h, LARGEST_STEP);
        } else {
            h = (next - s) / 2;
            if (!(h > SMALLEST_STEP))
                return false;
        }
    }
    return s == 1;
}

/* ---- a collision ---- */

static const struct complex_ball zero = {0, 0, 0}, one = {1, 0, 0};

/* kappa = 1/zeta^2, where a path in zeta meets one in kappa, for an exact zeta */
static struct complex_ball kappa_at(double zeta)
{
    return ball_inv(ball_sqr(ball_of(zeta, 0)));
}

/* From zero force, k = 1, at Y to zero overlap, with c1 = c2 = 1: the square of the end speed's root, and the time.
 * While it creeps, k and Y determine each other: down to LAST_Y the path is in 1/Y, where k hardly depends on the
 * beginning. Otherwise it is in k from the beginning, and at last in zeta = k^(-1/2). */
static bool fall(struct complex_ball *speed, struct complex_ball *time, struct complex_ball Y, bool creeps)
{
    struct path p = {.c1 = one, .c2 = one};
    struct state k = {one, zero}, y = {Y, zero};
    if (creeps) {
        if (!follow(&p, PATH_FALL, ball_inv(Y), ball_of(1 / LAST_Y, 0), &k))
            return false;
        y = (struct state){ball_of(LAST_Y, 0), k.time};
    }
    if (!follow(&p, PATH_FORCE, k.value, kappa_at(LAST_ZETA), &y))
        return false;
    y.value = ball_mul(y.value, ball_inv(ball_of(LAST_ZETA, 0)));
    if (!follow(&p, PATH_UNLOADING, ball_of(LAST_ZETA, 0), zero, &y))
        return false;
    *speed = ball_sqr(y.value);
    *time = y.time;
    return true;
}

/* Zero overlap from zero force: Y = beta^2 y; eps = speed/beta^5, and times have the unit beta. */
static bool fall_from_force(struct complex_collision *c, struct complex_ball beta, struct complex_ball y, bool creeps)
{
    const struct complex_ball square = ball_sqr(beta);
    struct complex_ball speed, time;
    if (!fall(&speed, &time, ball_mul(square, y), creeps))
        return false;
    c->eps_zero_overlap = ball_mul(speed, ball_inv(ball_mul(ball_sqr(square), beta)));
    c->t_zero_overlap = ball_add(c->t_zero_force, ball_mul(time, beta));
    return true;
}

/* From the turning point near beta = 0: to kappa = 1, then in zeta from 1 to z, zero force, and to 0, zero overlap */
static bool unload_near(struct complex_collision *c, struct path *p, struct state y, struct complex_ball z,
                        bool overlap)
{
    if (!follow(p, PATH_TURNING, zero, one, &y))
        return false;
    struct state end = y;
    if (!follow(p, PATH_UNLOADING, one, z, &end))
        return false;
    c->eps_zero_force = ball_sqr(end.value);
    c->t_zero_force = end.time;
    if (!overlap)
        return true;
    if (!follow(p, PATH_UNLOADING, one, zero, &y))
        return false;
    c->eps_zero_overlap = ball_sqr(y.value);
    c->t_zero_overlap = y.time;
    return true;
}

/* From the turning point far from beta = 0: zero force at k = 1, eps = y^2/beta, and zero overlap from there. The two
 * ways to zero overlap are both taken for modulus between CREEP_FROM and CREEP_TO. */
static bool unload_far(struct complex_collision *c, struct path *p, struct state y, const double modulus[2],
                       bool overlap)
{
    if (!follow(p, PATH_FORCE, zero, one, &y))
        return false;
    c->eps_zero_force = ball_mul(ball_sqr(y.value), ball_inv(p->c1));
    c->t_zero_force = y.time;
    return !overlap || ((modulus[0] > CREEP_TO || fall_from_force(c, p->c1, y.value, false)) &&
                        (modulus[1] < CREEP_FROM || fall_from_force(c, p->c1, y.value, true)));
}

/* Where two ways meet, both are taken. Each then gives a function that is analytic in its part of the ellipse, and both
 * are the same function: in the ring where both are defined, which meets the real axis, and therefore everywhere. */
bool complex_collision_root(struct complex_collision *c, struct complex_ball z, bool overlap)
{
    const double modulus[2] = {ball_below(z), ball_above(z)}, size = ball_size(z);
    if (!ball_is_finite(z))
        return false;
    struct path p = {.c1 = ball_sqr(z), .c2 = one};
    struct state y = {one, zero};
    /* a place on the real axis, where a path in zeta becomes one in kappa; any place gives the same collision */
    const double first = size > 1 ? 1 / cbrt(size * size) : 1;
    if (!follow(&p, PATH_LOADING, zero, ball_of(first, 0), &y))
        return false;
    y.value = ball_times(y.value, first);
    if (!follow(&p, PATH_TURNING, ball_neg(kappa_at(first)), zero, &y))
        return false;
    c->x_max = ball_sqr(y.value);
    c->t_max = y.time;
    return (modulus[0] > NEAR_TO || unload_near(c, &p, y, z, overlap)) &&
           (modulus[1] < NEAR_FROM || unload_far(c, &p, y, modulus, overlap));
}

bool complex_collision_log(struct complex_collision *c, struct complex_ball u)
{
    const struct complex_ball third = ball_inv(ball_of(-3, 0)), log_mu = ball_times(ball_mul(u, third), 5);
    struct path p = {.c1 = one, .c2 = ball_exp(log_mu)};
    struct state y = {one, zero};
    if (!ball_is_finite(p.c2) || !follow(&p, PATH_LOADING, zero, one, &y))
        return false;
    if (!follow(&p, PATH_BEFORE, zero, log_mu, &y) || !follow(&p, PATH_LAST, one, zero, &y))
        return false;
    c->x_max = ball_sqr(y.value);
    c->t_max = y.time;
    if (!follow(&p, PATH_AFTER, log_mu, ball_times(log_mu, 2), &y) || !follow(&p, PATH_END, one, zero, &y))
        return false;
    c->eps_zero_force = ball_sqr(y.value);
    c->t_zero_force = y.time;
    return true;
}
