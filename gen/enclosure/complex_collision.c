/* SPDX-License-Identifier: MIT */
#include "enclosure/complex_collision.h"

#include "enclosure/complex_path.h"

/* Ranges of |sqrt(beta)|. The path to zero force uses the variable zeta up to NEAR_TO, and k from NEAR_FROM upward. The
 * path from there to zero overlap uses k up to CREEP_TO, and 1/Y from CREEP_FROM upward, where unloading is slow. */
#define NEAR_FROM 1.05
#define NEAR_TO 1.1
#define CREEP_FROM 1.65
#define CREEP_TO 1.7
#define LAST_Y 2.0
#define LAST_ZETA 0.5

/* ---- the equation along a path; each function returns the slopes in the comment above it ----
 *
 * The dependent variable is g for loading and unloading in zeta, k for paths in 1/Y, and y for all others.
 * before_turn_slopes and the functions below it have c1 = 1 and c2 = mu. */

static struct complex_ball add_number(struct complex_ball x, double number)
{
    return ball_add(x, ball_of(number, 0));
}

/* With q = g zeta^3 C, returns dg/dzeta = -zeta^2 C g^2/(1 + q), its derivative by g, -zeta^2 C g (2 + q)/(1 + q)^2,
 * and dt/dzeta = +-2 zeta/(1 + q). */
static struct slopes zeta_slopes(const struct path *p, struct complex_ball zeta, struct complex_ball g, double sign)
{
    const struct complex_ball square = ball_sqr(zeta);
    const struct complex_ball c = ball_add(ball_mul(p->c2, square), ball_times(p->c1, sign));
    const struct complex_ball force = ball_mul(ball_mul(square, c), g), q = ball_mul(force, zeta);
    const struct complex_ball inverse = ball_inv(add_number(q, 1)), part = ball_neg(ball_mul(force, inverse));
    return (struct slopes){ball_mul(part, g), ball_mul(part, ball_mul(add_number(q, 2), inverse)),
                           ball_times(ball_mul(zeta, inverse), 2 * sign)};
}

static struct slopes loading_slopes(const struct path *p, struct complex_ball zeta, struct complex_ball g)
{
    return zeta_slopes(p, zeta, g, 1);
}

static struct slopes unloading_slopes(const struct path *p, struct complex_ball zeta, struct complex_ball g)
{
    return zeta_slopes(p, zeta, g, -1);
}

/* Returns dy/dkappa = -kappa y/(2 N), its derivative by y, -kappa^3/(2 N^2), and dt/dkappa = 1/N. */
static struct slopes turning_slopes(const struct path *p, struct complex_ball kappa, struct complex_ball y)
{
    const struct complex_ball square = ball_sqr(kappa);
    const struct complex_ball force = ball_sub(p->c2, ball_mul(p->c1, kappa));
    const struct complex_ball inverse = ball_inv(ball_add(ball_mul(force, y), square));
    const struct complex_ball part = ball_times(ball_mul(kappa, inverse), -0.5);
    return (struct slopes){ball_mul(part, y), ball_mul(part, ball_mul(square, inverse)), inverse};
}

/* Like turning_slopes, in k = c1 kappa with c2 = 1. With M = c1^2 y (1 - k) + k^2, returns dy/dk = -k y/(2 M), its
 * derivative by y, -k^3/(2 M^2), and dt/dk = c1/M. */
static struct slopes force_slopes(const struct path *p, struct complex_ball k, struct complex_ball y)
{
    const struct complex_ball square = ball_sqr(k);
    const struct complex_ball product = ball_mul(ball_sqr(p->c1), ball_mul(y, add_number(ball_neg(k), 1)));
    const struct complex_ball inverse = ball_inv(ball_add(product, square));
    const struct complex_ball part = ball_times(ball_mul(k, inverse), -0.5);
    return (struct slopes){ball_mul(part, y), ball_mul(part, ball_mul(square, inverse)), ball_mul(p->c1, inverse)};
}

/* With r = 1/Y, returns dk/dr = 2 (1/k - 1 + k r)/r^2, its derivative by k, 2 (r - 1/k^2)/r^2, and dt/dr = 2/(k r). */
static struct slopes falling_force_slopes(const struct path *p, struct complex_ball r, struct complex_ball k)
{
    (void)p;
    const struct complex_ball a = ball_inv(k), b = ball_inv(r), square = ball_times(ball_sqr(b), 2);
    return (struct slopes){ball_mul(add_number(ball_add(a, ball_mul(k, r)), -1), square),
                           ball_mul(ball_sub(r, ball_sqr(a)), square), ball_times(ball_mul(a, b), 2)};
}

/* Returns the rest of the path, its end minus the current place. */
static struct complex_ball rest_of(const struct path *p)
{
    return ball_neg(ball_mul(p->length, add_number(p->s, -1)));
}

/* With q = exp(L), kappa = -q, r = mu/q = exp(rest) and M = y (1 + r) + q, returns dy/dL = -q y/(2 M), its derivative
 * by y, -q^2/(2 M^2), and dt/dL = -1/M. */
static struct slopes before_turn_slopes(const struct path *p, struct complex_ball L, struct complex_ball y)
{
    (void)p;
    const struct complex_ball q = ball_exp(L), r = ball_exp(rest_of(p));
    const struct complex_ball inverse = ball_inv(ball_add(ball_mul(add_number(r, 1), y), q));
    const struct complex_ball part = ball_mul(q, inverse);
    return (struct slopes){ball_times(ball_mul(part, y), -0.5), ball_times(ball_sqr(part), -0.5), ball_neg(inverse)};
}

/* With kappa = -mu delta and M = y (1 + delta) + mu delta^2, returns dy/ddelta = -mu delta y/(2 M), its derivative by
 * y, -mu^2 delta^3/(2 M^2), and dt/ddelta = -1/M. */
static struct slopes last_force_slopes(const struct path *p, struct complex_ball delta, struct complex_ball y)
{
    const struct complex_ball size = ball_mul(p->c2, delta);
    const struct complex_ball inverse = ball_inv(ball_add(ball_mul(add_number(delta, 1), y), ball_mul(size, delta)));
    const struct complex_ball part = ball_mul(size, inverse);
    return (struct slopes){ball_times(ball_mul(part, y), -0.5), ball_times(ball_mul(ball_sqr(part), delta), -0.5),
                           ball_neg(inverse)};
}

/* With q = exp(L), kappa = mu - q, r = mu^2/q = exp(rest) and M = y - 2 mu + q + r, returns dy/dL = kappa y/(2 M), its
 * derivative by y, kappa (M - y)/(2 M^2), and dt/dL = -1/M. */
static struct slopes after_turn_slopes(const struct path *p, struct complex_ball L, struct complex_ball y)
{
    const struct complex_ball q = ball_exp(L), r = ball_exp(rest_of(p)), kappa = ball_sub(p->c2, q);
    const struct complex_ball others = ball_sub(ball_add(q, r), ball_times(p->c2, 2));
    const struct complex_ball inverse = ball_inv(ball_add(others, y));
    const struct complex_ball part = ball_times(ball_mul(kappa, inverse), 0.5);
    return (struct slopes){ball_mul(part, y), ball_mul(part, ball_mul(others, inverse)), ball_neg(inverse)};
}

/* With e = 1 - mu delta, kappa = mu e and M = y delta + e^2, returns dy/ddelta = y mu e/(2 M), its derivative by y, mu
 * e^3/(2 M^2), and dt/ddelta = -1/M. */
static struct slopes last_of_fall(const struct path *p, struct complex_ball delta, struct complex_ball y)
{
    const struct complex_ball e = add_number(ball_neg(ball_mul(p->c2, delta)), 1), square = ball_sqr(e);
    const struct complex_ball inverse = ball_inv(ball_add(ball_mul(y, delta), square));
    const struct complex_ball part = ball_times(ball_mul(p->c2, ball_mul(e, inverse)), 0.5);
    return (struct slopes){ball_mul(part, y), ball_mul(part, ball_mul(square, inverse)), ball_neg(inverse)};
}

/* ---- a collision ---- */

static const struct complex_ball zero = {0, 0, 0}, one = {1, 0, 0};

/* Returns kappa = 1/zeta^2 for an exact zeta, the place where a path in zeta continues as a path in kappa. */
static struct complex_ball kappa_at(double zeta)
{
    return ball_inv(ball_sqr(ball_of(zeta, 0)));
}

/* Follows the motion with c1 = c2 = 1 from zero force, where k = 1 and Y = beta^2 y, to zero overlap. eps is g^2/beta^5
 * with the g of zero overlap, and beta is the unit of time. A creeping path has the variable 1/Y until Y =
 * LAST_Y, where k hardly depends on its first value. Other paths start in k. Both end in zeta = k^(-1/2). */
static bool fall_from_force(struct complex_collision *c, struct complex_ball beta, struct complex_ball at_force,
                            bool creeps)
{
    const struct complex_ball square = ball_sqr(beta), Y = ball_mul(square, at_force);
    struct path p = {.c1 = one, .c2 = one, .resolution = 1};
    struct path_state k = {one, zero}, y = {Y, zero};
    if (creeps) {
        if (!path_follow(&p, falling_force_slopes, ball_inv(Y), ball_of(1 / LAST_Y, 0), &k))
            return false;
        y = (struct path_state){ball_of(LAST_Y, 0), k.time};
    }
    if (!path_follow(&p, force_slopes, k.value, kappa_at(LAST_ZETA), &y))
        return false;
    y.value = ball_mul(y.value, ball_inv(ball_of(LAST_ZETA, 0)));
    if (!path_follow(&p, unloading_slopes, ball_of(LAST_ZETA, 0), zero, &y))
        return false;
    c->eps_zero_overlap = ball_mul(ball_sqr(y.value), ball_inv(ball_mul(ball_sqr(square), beta)));
    c->t_zero_overlap = ball_add(c->t_zero_force, ball_mul(y.time, beta));
    return true;
}

/* For beta near 0, follows the motion from the turning point to kappa = 1. Then follows it in zeta from 1 to z, where
 * the force is zero, and from 1 to 0, where the overlap is zero. */
static bool unload_near(struct complex_collision *c, struct path *p, struct path_state y, struct complex_ball z,
                        bool overlap)
{
    if (!path_follow(p, turning_slopes, zero, one, &y))
        return false;
    struct path_state end = y;
    if (!path_follow(p, unloading_slopes, one, z, &end))
        return false;
    c->eps_zero_force = ball_sqr(end.value);
    c->t_zero_force = end.time;
    if (!overlap)
        return true;
    if (!path_follow(p, unloading_slopes, one, zero, &y))
        return false;
    c->eps_zero_overlap = ball_sqr(y.value);
    c->t_zero_overlap = y.time;
    return true;
}

/* For beta far from 0, follows the motion from the turning point to zero force at k = 1, where eps = y^2/beta, and from
 * there to zero overlap. If the modulus is between CREEP_FROM and CREEP_TO, follows both paths to zero overlap. */
static bool unload_far(struct complex_collision *c, struct path *p, struct path_state y, const double modulus[2],
                       bool overlap)
{
    if (!path_follow(p, force_slopes, zero, one, &y))
        return false;
    c->eps_zero_force = ball_mul(ball_sqr(y.value), ball_inv(p->c1));
    c->t_zero_force = y.time;
    return !overlap || ((modulus[0] > CREEP_TO || fall_from_force(c, p->c1, y.value, false)) &&
                        (modulus[1] < CREEP_FROM || fall_from_force(c, p->c1, y.value, true)));
}

/* Where the domains of two paths overlap, in a ring, both paths are followed. Each gives a function that is analytic
 * in its part of the ellipse. The two functions agree where the ring meets the real axis, and therefore in the whole
 * ring. */
bool complex_collision_root(struct complex_collision *c, struct complex_ball z, bool overlap)
{
    const double modulus[2] = {ball_below(z), ball_above(z)}, size = ball_size(z);
    if (!ball_is_finite(z))
        return false;
    struct path p = {.c1 = ball_sqr(z), .c2 = one, .resolution = 1};
    struct path_state y = {one, zero};
    /* At this real zeta the path continues in kappa. Every real zeta gives the same collision. */
    const double first = size > 1 ? 1 / cbrt(size * size) : 1;
    if (!path_follow(&p, loading_slopes, zero, ball_of(first, 0), &y))
        return false;
    y.value = ball_times(y.value, first);
    if (!path_follow(&p, turning_slopes, ball_neg(kappa_at(first)), zero, &y))
        return false;
    c->x_max = ball_sqr(y.value);
    c->t_max = y.time;
    return (modulus[0] > NEAR_TO || unload_near(c, &p, y, z, overlap)) &&
           (modulus[1] < NEAR_FROM || unload_far(c, &p, y, modulus, overlap));
}

bool complex_collision_log(struct complex_collision *c, struct complex_ball u)
{
    const struct complex_ball third = ball_inv(ball_of(-3, 0)), log_mu = ball_times(ball_mul(u, third), 5);
    struct path p = {.c1 = one, .c2 = ball_exp(log_mu), .resolution = 1};
    struct path_state y = {one, zero};
    if (!ball_is_finite(p.c2) || !path_follow(&p, loading_slopes, zero, one, &y))
        return false;
    if (!path_follow(&p, before_turn_slopes, zero, log_mu, &y) || !path_follow(&p, last_force_slopes, one, zero, &y))
        return false;
    c->x_max = ball_sqr(y.value);
    c->t_max = y.time;
    if (!path_follow(&p, after_turn_slopes, log_mu, ball_times(log_mu, 2), &y) ||
        !path_follow(&p, last_of_fall, one, zero, &y))
        return false;
    c->eps_zero_force = ball_sqr(y.value);
    c->t_zero_force = y.time;
    return true;
}
