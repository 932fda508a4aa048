/* SPDX-License-Identifier: MIT */
#include "approximation/ellipse_bound.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>

#include "enclosure/complex_collision.h"
#include "enclosure/complex_law.h"
#include "support/console.h"
#include "support/parallel.h"

enum { MOST_BALLS = 6000, DEEPEST = 24 /* largest number of times that a square is split */ };

/* Half the side of the first squares, in units of the ellipse's minor semi-axis */
#define FIRST_HALF (1.0 / 8)
/* Laws other than the sphere's (complex_law.h) use the path for strong damping if ln(beta) at the middle of the
 * interval is above these numbers. If that path fails within STRONG_ABOUT of them, the other path is tried. */
#define STRONG_OVERLAP 1.4
#define STRONG_FORCE (-1.5)
#define STRONG_ABOUT 0.7
/* If the impact speed nearest to the sticking speed v_s is (1 + e) v_s, the resolution of the paths is at most
 * NEAR_STICKING e. The value was chosen by experiment. With 2 instead, proofs took twice as long. */
#define NEAR_STICKING 5
/* Width of a strip in ln(speed) */
#define STRIP 0.25

const struct ellipse_bound ellipse_stated[ELLIPSES] = {
    {4, {31.8, 46.7, 4.79, 4.08, 1.37, 1.84}},
    {3.4, {2.17, 1.59, 6.93, 3.9, 1.16, 1.75}},
    {0, {0}},
    {4.2, {1.41, 0.456, 9.64, 3.42, 0.791, 1.49}},
    {3.3, {0.12, 0.223, 16.1, 2.66, 0.622, 1.31}},
    {3.4, {0.0369, 0.153, 41.7, 2.4, 0.542, 1.22}},
    {3.8, {0.00377, 0.0853, 71.9, 2.21, 0.434, 1.11}},
    {5, {0, 0.153, 0, 6.38, 0.538, 1.35}},
    {2.6, {0, 5.7, 0, 58.8, 2.55, 22.4}},
};

unsigned ellipse_bound_set(const struct interval *interval)
{
    return interval->variable == INTERVAL_LOG ? interval->set & ~(1u << DURATION_ZERO_OVERLAP) : interval->set;
}

struct cover {
    const struct interval *interval;
    struct ellipse_bound *bound;
    double a, b;  /* semi-axes of the ellipse; the unit of all lengths below is half the interval */
    unsigned set; /* set of quantities to bound */
    bool (*stored)(struct complex_ball y[QUANTITIES], const struct cover *work, struct complex_ball x);
    const struct interpolant *f; /* this and the next two fields: only for laws other than the sphere's */
    enum quantity quantity;
    struct complex_law_path path;
    atomic_int balls;
};

/* Covers the square |Re - re| <= half, |Im - im| <= half about the middle of the interval. `stored` encloses the stored
 * numbers for a ball around the square. If it fails, the square is split into quarters. Only squares that reach the
 * boundary of the ellipse raise the bounds: the largest modulus is there, and (1 - eps)/beta is 0/0 only inside. */
static void cover_square(struct cover *work, double re, double im, double half, int depth)
{
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    /* smallest and largest (Re/a)^2 + (Im/b)^2 in the square; below 1 inside the ellipse */
    const double least = pow(fmax(fabs(re) - half, 0) / work->a, 2) + pow(fmax(fabs(im) - half, 0) / work->b, 2);
    const double most = pow((fabs(re) + half) / work->a, 2) + pow((fabs(im) + half) / work->b, 2);
    if (least > 1 + 1e-9)
        return;
    if (atomic_fetch_add(&work->balls, 1) >= MOST_BALLS || depth > DEEPEST) {
        atomic_store(&work->balls, MOST_BALLS + 1);
        return;
    }
    struct complex_ball y[QUANTITIES] = {{0, 0, 0}};
    const struct interval *const interval = work->interval;
    const struct complex_ball square = ball_widened(ball_of(re, im), half * (1.4142135623730952 * (1 + 1e-9)));
    const struct complex_ball x =
        ball_add(ball_of((interval->lo + interval->hi) / 2, 0), ball_times(square, (interval->hi - interval->lo) / 2));
    bool known = work->stored(y, work, x);
    for (int q = 0; q < QUANTITIES && most >= 1 - 1e-9; q++)
        known = known && (!(work->set & 1u << q) || isfinite(ball_above(y[q])));
    for (int k = 0; k < 4 && !known; k++)
        cover_square(work, re + (k & 1 ? half : -half) / 2, im + (k & 2 ? half : -half) / 2, half / 2 * (1 + 1e-9),
                     depth + 1);
    pthread_mutex_lock(&lock);
    for (int q = 0; q < QUANTITIES && known && most >= 1 - 1e-9; q++)
        if (work->set & 1u << q)
            work->bound->modulus[q] = fmax(work->bound->modulus[q], ball_above(y[q]));
    pthread_mutex_unlock(&lock);
}

/* Covers a column of the first squares in the upper half of the ellipse. The lower half has the conjugate values. */
static void cover_column(void *context, slong i)
{
    struct cover *const work = context;
    const double half = work->b * FIRST_HALF, column = i % 2 ? -(double)(i + 1) : (double)i;
    for (int j = 0; (2 * j - 1) * half <= work->b; j++)
        cover_square(work, column * half, 2 * j * half, half * (1 + 1e-9), 0);
}

/* Computes the bound. True if the ellipse is covered, so that the bound holds. */
static bool cover_ellipse(struct cover *work, double rho)
{
    *work->bound = (struct ellipse_bound){.rho = rho};
    work->a = (rho + 1 / rho) / 2;
    work->b = (rho - 1 / rho) / 2;
    atomic_store(&work->balls, 0);
    parallel_for(cover_column, work, 2 * (slong)((work->a / work->b / FIRST_HALF + 1) / 2) + 1,
                 "collisions at complex damping");
    return atomic_load(&work->balls) <= MOST_BALLS;
}

static bool stored_of_sphere(struct complex_ball y[QUANTITIES], const struct cover *work, struct complex_ball x)
{
    const struct interval *const interval = work->interval;
    struct complex_collision c;
    if (interval->variable == INTERVAL_LOG ? !complex_collision_log(&c, x)
                                           : !complex_collision_root(&c, x, (work->set & SET_ZERO_OVERLAP) != 0))
        return false;
    for (int q = 0; q < QUANTITIES; q++)
        if (work->set & 1u << q)
            y[q] = interval->form == FORM_QUOTIENT && is_eps((enum quantity)q)
                       ? ball_mul(ball_sub(ball_of(1, 0), c.field[q]), ball_inv(ball_sqr(x)))
                       : c.field[q];
    return true;
}

/* ---- another law ---- */

/* Computes beta from x. Also sets *log_beta = x, which has a meaning only in intervals of ln(beta). */
static void damping_of(struct complex_ball *beta, struct complex_ball *log_beta, const struct cover *work,
                       struct complex_ball x)
{
    const double threshold = ball_middle(work->f->threshold);
    *log_beta = x;
    switch (work->interval->variable) {
    case INTERVAL_ROOT: /* z = beta, because these laws have root = 1 */
        *beta = x;
        break;
    case INTERVAL_LOG:
        *beta = ball_exp(x);
        break;
    case INTERVAL_BELOW:
        *beta = ball_sub(ball_widened(ball_of(threshold, 0), 0x1p-50 * threshold), ball_exp(x));
        break;
    }
}

/* Converts ln(eps) to the number that the interval stores. */
static struct complex_ball stored_of_law(const struct cover *work, struct complex_ball log_eps, struct complex_ball x)
{
    const struct ratio power = interpolant_tail_power(&work->f->layout->law, work->quantity);
    switch (work->interval->form) {
    case FORM_QUOTIENT:
        return ball_mul(ball_sub(ball_of(1, 0), ball_exp(log_eps)), ball_inv(x));
    case FORM_POWER:
        x = ball_widened(ball_times(x, -(double)power.num / (double)power.den), 0x1p-48 * ball_size(x));
        return ball_exp(ball_add(log_eps, x));
    case FORM_VALUE:
        return ball_exp(log_eps);
    case FORM_LOG:
        break;
    }
    return log_eps;
}

/* Returns the constant force of the layout and the impact speed, in units of the impact speed at the middle of a strip
 * of ln(beta). Sets *log_beta to this middle. All squares of a strip use one path and therefore define one function.
 * The functions of neighbouring strips agree at real arguments, hence on the border. */
static struct complex_law_pressing pressing_of(struct complex_ball *log_beta, const struct cover *work)
{
    struct complex_law_pressing pressing = {{0, 0, 0}, {0, 0, 0}};
    const arb_srcptr press = work->f->layout->press;
    if (!press)
        return pressing;
    const struct cor_exponents *const law = &work->f->layout->law;
    const struct ratio power = interpolant_press_power(law), q = law_speed_exponent(law);
    const double strip = STRIP * fabs(ratio_double(q)), p = ratio_double(power);
    const double middle = (floor(log_beta->re / strip) + 0.5) * strip;
    const double log_press = log(ball_middle(press));
    const struct complex_ball log_force =
        ball_widened(ball_of(log_press + p * middle, 0), 0x1p-48 * (1 + fabs(log_press) + fabs(p * middle)));
    pressing.force = ball_exp(log_force);
    pressing.log_speed = ball_times(ball_sub(*log_beta, ball_of(middle, 0)), (double)q.den / (double)q.num);
    pressing.log_speed = ball_widened(pressing.log_speed, 0x1p-48 * ball_size(pressing.log_speed));
    *log_beta = ball_of(middle, 0);
    return pressing;
}

static bool stored_by_law(struct complex_ball y[QUANTITIES], const struct cover *work, struct complex_ball x)
{
    const struct cor_exponents *const law = &work->f->layout->law;
    struct complex_ball beta, log_beta, log_eps;
    damping_of(&beta, &log_beta, work, x);
    const struct complex_law_pressing pressing = pressing_of(&log_beta, work);
    if (work->f->layout->press)
        beta = ball_exp(log_beta);
    const bool known = work->quantity == EPS_ZERO_FORCE
                           ? complex_law_zero_force(&log_eps, law, log_beta, &pressing, &work->path)
                       : work->path.strong ? complex_law_creep(&log_eps, law, log_beta, &work->path)
                                           : complex_law_zero_overlap(&log_eps, law, beta, &pressing, &work->path);
    if (known)
        y[work->quantity] = stored_of_law(work, log_eps, x);
    return known;
}

int ellipse_bound_make(struct ellipse_bound *bound, const struct interval *interval, double rho)
{
    struct cover work = {
        .interval = interval, .bound = bound, .set = ellipse_bound_set(interval), .stored = stored_of_sphere};
    return cover_ellipse(&work, rho) ? STATUS_OK
                                     : fail("cannot bound the collision in the ellipse rho = %g around [%g, %g]", rho,
                                            interval->lo, interval->hi);
}

bool ellipse_bound_of_law(struct ellipse_bound *bound, const struct interpolant *f, const struct interval *interval,
                          enum quantity eps, double rho)
{
    const struct cor_exponents *const law = &f->layout->law;
    struct cover work = {
        .interval = interval, .bound = bound, .set = 1u << eps, .stored = stored_by_law, .f = f, .quantity = eps};
    const bool log = interval->variable == INTERVAL_LOG, force = eps == EPS_ZERO_FORCE;
    if (force && !log)
        return false;
    /* at zero overlap, the path for strong damping needs ln(beta), n > 0 and no force */
    const bool pressed = f->layout->press != NULL;
    const bool may_be_strong = force || (log && !pressed && law_fall_power(law).num > 0);
    const double lo = interval->lo, hi = interval->hi, log_sticking = f->layout->press_log;
    const double above = (lo + hi) / 2 - (force ? STRONG_FORCE : STRONG_OVERLAP);
    const bool strong = may_be_strong && above > 0;
    struct complex_ball beta, log_beta; /* one ball for beta in the whole ellipse */
    damping_of(&beta, &log_beta, &work, (struct complex_ball){(lo + hi) / 2, 0, (hi - lo) / 2 * (rho + 1 / rho) / 2});
    work.path = complex_law_path(law, ball_above(beta), strong);
    if (pressed) /* near the sticking speed v_s the energy left at the end is of order v/v_s - 1 */
        work.path.resolution = fmin(1, NEAR_STICKING * fmin(fabs(lo - log_sticking), fabs(hi - log_sticking)) /
                                           fabs(ratio_double(law_speed_exponent(law))));
    if (cover_ellipse(&work, rho))
        return true;
    work.path.strong = !strong;
    return may_be_strong && fabs(above) < STRONG_ABOUT && cover_ellipse(&work, rho);
}
