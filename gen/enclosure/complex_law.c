/* SPDX-License-Identifier: MIT */
#include "enclosure/complex_law.h"

#include "enclosure/complex_path.h"

/* The approach ends before the damping has consumed this fraction of the speed, and at this x or below. */
#define APPROACH_LOSS 0.3
#define APPROACH_MOST 0.3
/* The approach ends at x = s^POWER, so that the equation is smooth at s = 0 for every exponent of the law. */
#define POWER 4.0
/* Value of F = beta^2 x^n at the end of the creep */
#define CREEP_END 2.0

static const struct complex_ball zero = {0, 0, 0}, one = {1, 0, 0};
static const struct complex_law_pressing free_contact = {{0, 0, 0}, {0, 0, 0}};

/* Returns s^power for all real s >= 0 of a ball. 2^-40 exceeds the rounding errors of s, of the power and of pow. */
static struct complex_ball real_power(struct complex_ball s, double power)
{
    const double radius = raise_bound(s.radius);
    const double low = pow(fmax(s.re - radius, 0), power), high = pow(s.re + radius, power);
    return (struct complex_ball){(low + high) / 2, 0, raise_bound((high - low) / 2 + 0x1p-40 * high)};
}

static struct complex_ball power_or_one(struct complex_ball s, double power)
{
    return power == 0 ? one : real_power(s, power);
}

/* Returns exp(power x), widened by more than the rounding error of the power. */
static struct complex_ball exp_of_power(struct complex_ball x, double power)
{
    return ball_exp(ball_widened(ball_times(x, power), 0x1p-48 * ball_size(x)));
}

/* Computes ln(x), real for x > 0, of a ball in the right half plane. Returns false for other balls. */
static bool set_log(struct complex_ball *log_x, struct complex_ball x)
{
    const double size = ball_size(x);
    if (!(x.re > raise_bound(x.radius)))
        return false;
    *log_x = (struct complex_ball){log(size), atan2(x.im, x.re),
                                   raise_bound(-log1p(-raise_bound(x.radius / size)) + 0x1p-46)};
    return true;
}

/* ---- the equation along a path; the comment above each function defines its slopes and its c1, c2 and c3 ---- */

/* Returns dv/ds. c1 = beta, c3 = f */
static struct slopes approach_slopes(const struct path *p, struct complex_ball s, struct complex_ball v)
{
    const struct complex_ball damping = ball_mul(p->c1, real_power(s, POWER * p->b + POWER - 1));
    const struct complex_ball inverse = ball_inv(v);
    struct complex_ball elastic = real_power(s, POWER * p->a + POWER - 1);
    if (p->pressed)
        elastic = ball_sub(elastic, ball_mul(p->c3, real_power(s, POWER - 1)));
    elastic = ball_mul(elastic, inverse);
    return (struct slopes){ball_times(ball_add(damping, elastic), -POWER),
                           ball_times(ball_mul(elastic, inverse), POWER), zero};
}

/* Returns dL/dkappa = -kappa/D and its derivative by L, kappa D_L/D^2. c1 = beta, c3 = f */
static struct slopes turning_slopes(const struct path *p, struct complex_ball kappa, struct complex_ball L)
{
    const struct complex_ball elastic = exp_of_power(L, p->a - 1);
    const struct complex_ball damping = ball_mul(ball_mul(p->c1, kappa), exp_of_power(L, p->b));
    struct complex_ball rest = ball_sub(elastic, damping);
    struct complex_ball derivative = ball_sub(ball_times(damping, p->b), ball_times(elastic, p->a - 1));
    if (p->pressed) {
        const struct complex_ball pressing = ball_mul(p->c3, ball_exp(ball_neg(L)));
        rest = ball_sub(rest, pressing);
        derivative = ball_sub(derivative, pressing);
    }
    const struct complex_ball inverse = ball_inv(ball_add(rest, ball_sqr(kappa)));
    const struct complex_ball part = ball_neg(ball_mul(kappa, inverse));
    return (struct slopes){part, ball_mul(ball_mul(part, inverse), derivative), zero};
}

/* Returns dl/ds, which is often a small difference. c1 = beta X^(b+1)/W, c2 = X^(a+1)/W^2 and c3 = f X/W^2 */
static struct slopes departure_slopes(const struct path *p, struct complex_ball s, struct complex_ball l)
{
    const double common = fmin(p->a, p->b);
    const struct complex_ball inverse = ball_exp(ball_neg(l));
    const struct complex_ball factor = ball_mul(real_power(s, POWER * common + POWER - 1), inverse);
    const struct complex_ball damping = ball_mul(p->c1, power_or_one(s, POWER * (p->b - common)));
    const struct complex_ball elastic = ball_mul(ball_mul(p->c2, power_or_one(s, POWER * (p->a - common))), inverse);
    struct complex_ball slope = ball_mul(factor, ball_sub(damping, elastic));
    struct complex_ball derivative = ball_mul(factor, ball_sub(ball_times(elastic, 2), damping));
    if (p->pressed) {
        const struct complex_ball pressing = ball_mul(ball_mul(p->c3, real_power(s, POWER - 1)), ball_sqr(inverse));
        slope = ball_add(slope, pressing);
        derivative = ball_sub(derivative, ball_times(pressing, 2));
    }
    return (struct slopes){ball_times(slope, POWER), ball_times(derivative, POWER), zero};
}

/* Returns dL/dk = -k/N and its derivative by L, k N_L/N^2. F = c1 x^n, c1 = beta^2, c3 = f beta^2 */
static struct slopes force_slopes(const struct path *p, struct complex_ball k, struct complex_ball L)
{
    const struct complex_ball damping = ball_mul(ball_mul(p->c1, exp_of_power(L, p->n)), ball_add(one, ball_neg(k)));
    struct complex_ball N = damping, N_L = ball_times(damping, p->n);
    if (p->pressed) {
        const struct complex_ball pressing = ball_mul(p->c3, exp_of_power(L, p->n - p->a));
        N = ball_sub(N, pressing);
        N_L = ball_sub(N_L, ball_times(pressing, p->n - p->a));
    }
    N = ball_add(N, ball_times(ball_sqr(k), p->difference));
    const struct complex_ball inverse = ball_inv(N), part = ball_neg(ball_mul(k, inverse));
    return (struct slopes){part, ball_neg(ball_mul(ball_mul(part, inverse), N_L)), zero};
}

/* Returns dL/dq = -k^2/N, q = ln(k), from force_slopes. */
static struct slopes force_by_log(const struct path *p, struct complex_ball q, struct complex_ball L)
{
    const struct complex_ball k = ball_exp(q);
    const struct slopes f = force_slopes(p, k, L);
    return (struct slopes){ball_mul(k, f.slope), ball_mul(k, f.derivative), zero};
}

/* Returns dk/dln(F) = -N/(n k), where N/k = F (1/k - 1) + (a-b) k, and its derivative by k, (F/k^2 - (a-b))/n. */
static struct slopes slow_slopes(const struct path *p, struct complex_ball log_F, struct complex_ball k)
{
    const struct complex_ball inverse = ball_inv(k), F = ball_exp(log_F);
    const struct complex_ball N_by_k =
        ball_add(ball_mul(F, ball_add(inverse, ball_of(-1, 0))), ball_times(k, p->difference));
    const struct complex_ball derivative = ball_add(ball_mul(F, ball_sqr(inverse)), ball_of(-p->difference, 0));
    return (struct slopes){ball_times(N_by_k, -1 / p->n), ball_times(derivative, 1 / p->n), zero};
}

/* ---- a collision ---- */

struct complex_law_path complex_law_path(const struct cor_exponents *law, double largest_beta, bool strong)
{
    const double end = pow(APPROACH_LOSS / largest_beta, 1 / (ratio_double(law_damping(law)) + 1));
    return (struct complex_law_path){fmin(APPROACH_MOST, end), strong, 1};
}

/* Computes ln(x) at the turning point. Sets the exponents of p from the law. */
static bool turning_point(struct path *p, struct path_state *y, const struct cor_exponents *law,
                          struct complex_ball beta, const struct complex_law_pressing *pressing,
                          const struct complex_law_path *path)
{
    const double s = pow(path->approach_end, 1.0 / POWER); /* x = s^4 equals the end exactly */
    const struct complex_ball end = ball_sqr(ball_sqr(ball_of(s, 0)));
    *p = (struct path){.c1 = beta,
                       .c3 = pressing->force,
                       .pressed = ball_size(pressing->force) > 0,
                       .resolution = path->resolution,
                       .a = ratio_double(law_elastic(law)),
                       .b = ratio_double(law_damping(law)),
                       .difference = ratio_double(RATIO("law->a - law->b", law)),
                       .n = ratio_double(law_fall_power(law))};
    *y = (struct path_state){p->pressed ? ball_exp(pressing->log_speed) : one, zero};
    if (!ball_is_finite(beta) || !path_follow(p, approach_slopes, zero, ball_of(s, 0), y))
        return false;
    struct complex_ball kappa = ball_neg(ball_mul(y->value, ball_inv(end)));
    const double logarithm = POWER * log(s);
    *y = (struct path_state){ball_widened(ball_of(logarithm, 0), 0x1p-46 * (1 + fabs(logarithm))), zero};
    p->logarithm = true;
    /* Start the path about the turning point at an exact kappa, so that only y is uncertain. The effect of an uncertain
     * kappa changes sign along the path and cancels, but the radii would grow as if it had one sign. */
    if (p->pressed) {
        if (!path_follow(p, turning_slopes, kappa, ball_centre(kappa), y))
            return false;
        kappa = ball_centre(kappa);
    }
    return path_follow(p, turning_slopes, kappa, zero, y);
}

/* Computes ln(eps) after the departure with the first speed W = exp(M). p contains the coefficients. */
static bool follow_departure(struct complex_ball *log_eps, struct path *p, struct complex_ball M)
{
    struct path_state y = {zero, zero};
    p->logarithm = true;
    if (!path_follow(p, departure_slopes, one, zero, &y))
        return false;
    *log_eps = ball_add(M, y.value);
    return true;
}

bool complex_law_zero_overlap(struct complex_ball *log_eps, const struct cor_exponents *law, struct complex_ball beta,
                              const struct complex_law_pressing *pressing, const struct complex_law_path *path)
{
    struct path p;
    struct path_state y;
    if (!turning_point(&p, &y, law, beta, pressing, path) || !path_follow(&p, turning_slopes, zero, one, &y))
        return false;
    p.c1 = ball_mul(beta, exp_of_power(y.value, p.b)); /* W = X at kappa = 1 */
    p.c2 = exp_of_power(y.value, p.a - 1);
    p.c3 = ball_mul(pressing->force, ball_exp(ball_neg(y.value)));
    if (!follow_departure(log_eps, &p, y.value))
        return false;
    if (p.pressed)
        *log_eps = ball_sub(*log_eps, pressing->log_speed);
    return true;
}

bool complex_law_zero_force(struct complex_ball *log_eps, const struct cor_exponents *law, struct complex_ball log_beta,
                            const struct complex_law_pressing *pressing, const struct complex_law_path *path)
{
    const struct complex_ball beta = ball_exp(log_beta);
    struct path p;
    struct path_state y;
    bool done = turning_point(&p, &y, law, beta, pressing, path) &&
                (path->strong || path_follow(&p, turning_slopes, zero, one, &y));
    p.c1 = ball_sqr(beta);
    p.c3 = ball_mul(pressing->force, p.c1);
    if (path->strong) {
        done = done && path_follow(&p, force_slopes, zero, one, &y);
    } else {
        const struct ratio power = RATIO("1 - (law->a - law->b)", law); /* k = beta x^power */
        const struct complex_ball q = ball_add(log_beta, ball_times(y.value, ratio_double(power)));
        done = done && path_follow(&p, force_by_log, q, zero, &y);
    }
    *log_eps = ball_sub(ball_times(y.value, p.difference), log_beta);
    if (!p.pressed || !done)
        return done;
    /* the flight to the surface gives (eps/v_f)^2 = 1 - 2 f x_f/v_f^2 */
    const struct complex_ball lost = ball_times(ball_mul(p.c3, exp_of_power(y.value, 1 - 2 * p.difference)), 2);
    struct complex_ball flight;
    *log_eps = ball_sub(*log_eps, pressing->log_speed);
    done = set_log(&flight, ball_sub(one, lost));
    *log_eps = ball_add(*log_eps, ball_times(flight, 0.5));
    return done;
}

bool complex_law_creep(struct complex_ball *log_eps, const struct cor_exponents *law, struct complex_ball log_beta,
                       const struct complex_law_path *path)
{
    const struct complex_ball beta = ball_exp(log_beta), half = ball_of(0.5, 0);
    struct path p;
    struct path_state y, k = {half, zero};
    if (!turning_point(&p, &y, law, beta, &free_contact, path))
        return false;
    p.c1 = ball_sqr(beta);
    if (!path_follow(&p, force_slopes, zero, half, &y))
        return false;
    const struct complex_ball log_end = ball_widened(ball_of(log(CREEP_END), 0), 0x1p-48);
    p.logarithm = false;
    if (!path_follow(&p, slow_slopes, ball_add(ball_times(log_beta, 2), ball_times(y.value, p.n)), log_end, &k))
        return false;
    /* W = k X^(a-b)/beta, so the coefficients are F/k and F/k^2. If k is in the right half plane, ln(k) is the
     * continuation from real beta. */
    struct complex_ball log_k;
    if (!set_log(&log_k, k.value))
        return false;
    const struct complex_ball inverse = ball_inv(k.value);
    p.c1 = ball_times(inverse, CREEP_END);
    p.c2 = ball_mul(p.c1, inverse);
    const struct complex_ball log_X = ball_times(ball_sub(log_end, ball_times(log_beta, 2)), 1 / p.n);
    return follow_departure(log_eps, &p, ball_add(log_k, ball_sub(ball_times(log_X, p.difference), log_beta)));
}
