/* SPDX-License-Identifier: MIT */
#define CHECK_WITHOUT_MAIN
#include "law_check.h"

#include "../accuracy/ball_value.h"
#include "../unit/check.h"
#include "enclosure/collision.h"
#include "support/formula.h"
#include "support/local.h"

enum { BITS = 72, PREC = 600, LARGEST_LOG10 = 7, STEP_BITS = 24 };

enum { CHECK_EPS, CHECK_LOSS, CHECK_BETA, CHECK_BETA_OF_LOSS, CHECK_DURATION, CHECK_MAX_OVERLAP, CHECK_TIME, CHECKS };

static const char *const check_name[CHECKS] = {"eps",      "loss",        "beta",           "beta of loss",
                                               "duration", "max overlap", "time of largest"};

static const char *const of_end[LAW_ENDS] = {" overlap", " force", " approach only"};

struct law_case {
    const struct law_functions *f;
    struct cor_exponents law;
    double threshold;               /* threshold of zero overlap, or infinity */
    double worst[LAW_ENDS][CHECKS]; /* ulp */
};

static void case_init(struct law_case *c, const struct law_functions *f)
{
    *c = (struct law_case){.f = f, .threshold = HUGE_VAL};
    assert_null(law_parse(&c->law, f->elastic, f->damping));
    LOCAL(arb, beta_c, height);
    if (law_is_linear(&c->law)) {
        c->threshold = sqrt(2 * (ratio_double(law_elastic(&c->law)) + 1));
    } else if (law_fall_power(&c->law).num < 0) {
        assert_int_equal(collision_threshold(beta_c, height, &c->law, PREC / 2), 0);
        c->threshold = arf_get_d(arb_midref(beta_c), ARF_RND_NEAR);
    }
}

static void note(struct law_case *c, int end, int what, double computed, const arb_t exact, double at)
{
    const double error = arb_is_zero(exact) && computed != 0 ? HUGE_VAL : ulp_error(computed, ball_value(exact));
    const bool first = what == CHECK_EPS || what == CHECK_LOSS || what == CHECK_MAX_OVERLAP;
    c->worst[end][what] = fmax(c->worst[end][what], error);
    const double bound = end == 2 ? c->f->approach_ulp : first ? c->f->one_ulp : c->f->two_ulp;
    check(error <= bound, "%s, %s%s: %.3f ulp at %.17g (%a): %.17g", c->f->name, check_name[what], of_end[end], error,
          at, at, computed);
}

/* Computes the loss 1 - eps for beta < 1e-100 (docs/theory.md, 2 and 5). At zero overlap it is -C_1 beta; at zero force
 * it is less by (a-b)/((a+1)(b+1)) beta^((a+1)/(a-b)).
 * C_1 = -(2/(a+1)) X^(b+1) B((b+1)/(a+1), 3/2), X = ((a+1)/2)^(1/(a+1)). */
static void first_order_loss(arb_t loss, const struct cor_exponents *law, int end, const arb_t beta)
{
    const struct ratio a = law_elastic(law), b = law_damping(law);
    LOCAL(fmpq, p);
    EXACT(p, "(b + 1)/(a + 1)", a, b);
    LET(loss, PREC, "beta*((a + 1)/2)^(p - 1)*gamma(p)*gamma(3/2)/gamma(p + 3/2)", beta, a, p);
    if (end == 1 && law_force_ends(law))
        LET(loss, PREC, "loss - (a - b)/((a + 1)*(b + 1))*beta^((a + 1)/(a - b))", loss, a, b, beta);
}

static void check_first_order(struct law_case *c, double beta)
{
    LOCAL(arb, x, loss);
    arb_set_d(x, beta);
    for (int end = 0; end < 2; end++) {
        first_order_loss(loss, &c->law, end, x);
        note(c, end, CHECK_LOSS, c->f->loss[end](beta), loss, beta);
        check(c->f->eps[end](beta) == 1, "%s: eps of %g", c->f->name, beta);
        const double given = arf_get_d(arb_midref(loss), ARF_RND_NEAR), back = c->f->beta_of_loss[end](given);
        check(fabs(back / beta - 1) < 2.5 * DBL_EPSILON, "%s: beta %g of loss %g", c->f->name, back, given);
    }
}

static int case_solve(struct collision *s, const struct law_case *c, const arb_t beta)
{
    /* well above the threshold only zero force exists */
    if (law_force_ends(&c->law) && arf_cmp_d(arb_midref(beta), 2 * c->threshold) > 0) {
        const int status = collision_solve_force(s, beta, &c->law, BITS);
        arb_zero(s->eps_zero_overlap);
        arb_pos_inf(s->t_zero_overlap);
        return status;
    }
    const double b = arf_get_d(arb_midref(beta), ARF_RND_NEAR);
    return collision_solve(s, beta, &c->law, BITS + (b < 1 ? (slong)-log2(b) : 0)); /* so that 1 - eps has BITS bits */
}

/* Computes eps and the duration at an end. With damping during approach only, the rebound is elastic, so both follow
 * from the largest overlap. */
static void end_values(arb_t eps, arb_t duration, const struct law_case *c, const struct collision *s, int end)
{
    const struct ratio a = law_elastic(&c->law);
    if (end < 2) {
        arb_set(eps, end ? s->eps_zero_force : s->eps_zero_overlap);
        arb_set(duration, end ? s->t_zero_force : s->t_zero_overlap);
        return;
    }
    LET(eps, PREC, "(2/(a + 1))^(1/2)*s->x_max^((a + 1)/2)", a, s->x_max);
    LET(duration, PREC, "((a + 1)/2)^(1/(a + 1))*sqrt(pi)*gamma(1 + 1/(a + 1))/gamma(1/2 + 1/(a + 1))", a);
    LET(duration, PREC, "s->t_max + duration*eps^((1 - a)/(1 + a))", s->t_max, duration, eps, a);
}

/* Checks the inverse at the double x near eps or the loss. The exact inverse is beta + (x - eps)/(d eps/d beta); the
 * slope comes from the difference to another collision, at beta - step. */
static void check_inverse(struct law_case *c, double beta, const struct collision *s)
{
    const double room = beta < c->threshold ? fmin(beta, c->threshold - beta) : beta, step = ldexp(room, -STEP_BITS);
    if (!(step > 0) || beta - step == beta)
        return;
    LOCAL(collision, other);
    LOCAL(arb, x, eps, before, slope, wanted, exact);
    arb_set_d(x, beta - step);
    assert_int_equal(case_solve(other, c, x), 0);
    for (int k = 0; k < 2 * LAW_ENDS; k++) {
        const int end = k / 2, of_loss = k % 2, sign = of_loss ? -1 : 1;
        law_function *const inverse = of_loss ? c->f->beta_of_loss[end] : c->f->beta[end];
        end_values(before, slope, c, other, end);
        end_values(eps, slope, c, s, end);
        if (!inverse || arb_is_zero(eps))
            continue;
        LET(slope, PREC, "(eps - before)/step", eps, before, step);
        LET(wanted, PREC, "of_loss + sign*eps", of_loss, sign, eps);
        const double given = arf_get_d(arb_midref(wanted), ARF_RND_NEAR);
        LET(exact, PREC, "beta + sign*(given - wanted)/slope", beta, sign, given, wanted, slope);
        /* The slope has about 24 bits. For a relative shift of 2^-38 the exact inverse is wrong by only 2^-62. */
        LET(x, PREC, "1 - beta/exact", beta, exact);
        if (fabs(arf_get_d(arb_midref(x), ARF_RND_UP)) < 0x1p-38 && given > 0 && given < 1)
            note(c, end, of_loss ? CHECK_BETA_OF_LOSS : CHECK_BETA, inverse(given), exact, given);
    }
}

static void check_beta(struct law_case *c, double beta, bool inverse)
{
    const struct law_functions *f = c->f;
    LOCAL(collision, s);
    LOCAL(arb, x, eps, loss, duration);
    if (beta < 1e-100) {
        check_first_order(c, beta);
        return;
    }
    arb_set_d(x, beta);
    check(case_solve(s, c, x) == 0, "%s: no collision at beta = %.17g", f->name, beta);
    for (int end = 0; end < LAW_ENDS && f->eps[end]; end++) {
        end_values(eps, duration, c, s, end);
        note(c, end, CHECK_EPS, f->eps[end](beta), eps, beta);
        LET(loss, PREC, "1 - eps", eps);
        note(c, end, CHECK_LOSS, f->loss[end](beta), loss, beta);
        note(c, end, CHECK_DURATION, f->duration[end](beta), duration, beta);
    }
    if (inverse)
        check_inverse(c, beta, s);
    note(c, 0, CHECK_MAX_OVERLAP, f->max_overlap(beta), s->x_max, beta);
    note(c, 0, CHECK_TIME, f->time_of_max_overlap(beta), s->t_max, beta);
}

void law_check_at(const struct law_functions *f, const double *beta, size_t n)
{
    struct law_case c;
    case_init(&c, f);
    for (size_t i = 0; i < n; i++)
        check_beta(&c, beta[i], false);
}

static void print_worst(const struct law_case *c, const char *what)
{
    print_message("%s, %s, ulp:", c->f->name, what);
    for (int end = 0; end < LAW_ENDS; end++)
        for (int k = 0; k < CHECKS && c->f->eps[end]; k++)
            print_message(" %s%s %.3f;", check_name[k], k >= CHECK_MAX_OVERLAP ? "" : of_end[end], c->worst[end][k]);
    print_message("\n");
}

void law_check_random(const struct law_functions *f, size_t count)
{
    struct law_case c;
    struct random_state r = random_start();
    case_init(&c, f);
    for (size_t i = 0; i < count; i++) {
        double beta;
        switch (i % 4) {
        case 0: /* near 0 */
            beta = pow(10, i % 16 == 0 ? random_uniform(&r, -300, -100) : random_uniform(&r, -12, -1));
            break;
        case 1:
            beta = random_uniform(&r, 0.02, 8);
            break;
        case 2:
            beta = pow(10, random_uniform(&r, 0, LARGEST_LOG10));
            break;
        default: /* a beta below the threshold, or below 8 without a threshold */
            beta = c.threshold < HUGE_VAL ? c.threshold * (1 - pow(2, random_uniform(&r, -45, -0.2)))
                                          : random_log(&r, 0.02, 8);
        }
        check_beta(&c, beta, true);
    }
    print_worst(&c, "random");
}

/* Returns a random border between tables. Rows for eps near 1 end at powers of two, the middle rows at 8, and rows at
 * zero overlap at beta_c and beta_c - 2^k. Rows of tails end at exp(u), where u is a whole eighth of an octave. */
static double border(struct law_case *c, struct random_state *r, size_t i)
{
    switch ((i + 3) % 4) { /* starts with a border in beta_c - beta, so that short runs test it */
    case 0:
        return ldexp(1, -(int)random_uniform(r, 1, 9));
    case 1:
        return i % 8 == 2 ? 8 : c->threshold < HUGE_VAL ? c->threshold : 4;
    case 2: {
        const double u = ldexp(8 + floor(random_uniform(r, 0, 8)), (int)random_uniform(r, -2, 2));
        return exp(fmin(u, (double)LARGEST_LOG10 * log(10)));
    }
    default:
        return c->threshold < HUGE_VAL ? c->threshold - exp2(floor(log2(c->threshold / 2)) - (double)(i / 4 % 3))
                                       : ldexp(1, -(int)random_uniform(r, 0, 4));
    }
}

void law_check_borders(const struct law_functions *f, size_t count)
{
    struct law_case c;
    struct random_state r = random_start();
    case_init(&c, f);
    for (size_t i = 0; i < count; i++) {
        const double at = border(&c, &r, i);
        double beta = nextafter(nextafter(at, 0), 0), before[LAW_ENDS] = {2, 2, 2};
        for (int k = 0; k < 5; k++, beta = nextafter(beta, HUGE_VAL)) {
            check_beta(&c, beta, k == 2);
            for (int end = 0; end < LAW_ENDS && f->eps[end]; end++) {
                const double eps = f->eps[end](beta);
                check(eps <= before[end] * (1 + 2 * DBL_EPSILON), "%s: eps rises at beta = %.17g", f->name, beta);
                before[end] = eps;
            }
        }
    }
    print_worst(&c, "borders");
}

void law_check_special(const struct law_functions *f)
{
    struct law_case c;
    case_init(&c, f);
    static const double refused[] = {-1, -5e-324, -HUGE_VAL, NAN};
    for (int end = 0; end < LAW_ENDS && f->eps[end]; end++) {
        law_function *const of_beta[] = {f->eps[end], f->loss[end], f->duration[end], f->max_overlap,
                                         f->time_of_max_overlap};
        law_function *const of_eps[] = {f->beta[end], f->beta_of_loss[end]};
        for (int k = 0; k < 4; k++) {
            for (int j = 0; j < 5; j++)
                check(isnan(of_beta[j](refused[k])), "%s, function %d of %g", f->name, j, refused[k]);
            for (int j = 0; j < 2; j++)
                check(isnan(of_eps[j](refused[k])) && isnan(of_eps[j](1.0000000000000002)) &&
                          isnan(of_eps[j](HUGE_VAL)),
                      "%s, inverse %d of %g", f->name, j, refused[k]);
        }
        for (double zero = 0, k = 0; k < 2; k++, zero = -0.0) {
            check(f->eps[end](zero) == 1 && f->loss[end](zero) == 0, "%s: elastic", f->name);
            check(same_bits(f->duration[end](zero), f->duration[0](0)), "%s: durations differ", f->name);
            check(relative_error(2 * f->time_of_max_overlap(zero), f->duration[0](0)) < 3e-16, "%s: half time",
                  f->name);
        }
        check(f->eps[end](HUGE_VAL) == 0 && f->loss[end](HUGE_VAL) == 1, "%s: infinite damping", f->name);
        check(f->beta[end](1) == 0 && f->beta_of_loss[end](0) == 0, "%s: beta of 1", f->name);
        const bool ends = end == 0 && c.threshold < HUGE_VAL;
        const double last = ends ? c.threshold : HUGE_VAL;
        check(f->beta[end](0) == last && f->beta_of_loss[end](1) == last, "%s: beta of 0 is %g", f->name,
              f->beta[end](0));
        const double tiny = 5e-324, slope = f->loss[end](1e-200) * 1e200;
        check(fabs(f->loss[end](tiny) - slope * tiny) <= tiny && f->eps[end](tiny) == 1, "%s: tiny", f->name);
        check(isfinite(f->beta_of_loss[end](tiny)), "%s: tiny loss", f->name);
    }
    check(f->max_overlap(HUGE_VAL) == 0 && f->time_of_max_overlap(HUGE_VAL) == 0, "%s: overlap", f->name);
    check(isinf(f->duration[0](HUGE_VAL)), "%s: duration", f->name);
    check(f->duration[1](HUGE_VAL) == (law_force_ends(&c.law) ? 0 : HUGE_VAL), "%s: duration", f->name);
    check(f->duration[0](0.0) * f->duration[0](0.0) > 0, "%s", f->name);
    if (c.threshold < HUGE_VAL) {
        const double above = nextafter(c.threshold, HUGE_VAL);
        check(f->eps[0](above) == 0 && f->loss[0](above) == 1 && isinf(f->duration[0](above)), "%s: beta_c", f->name);
    }
}

void law_check_round_trip(const struct law_functions *f, size_t count)
{
    struct law_case c;
    struct random_state r = random_start();
    case_init(&c, f);
    for (size_t i = 0; i < count; i++)
        for (int end = 0; end < 2; end++) {
            const bool falls = !(end == 0 && c.threshold < HUGE_VAL);
            const double loss = pow(10, random_uniform(&r, -300, -0.5));
            const double eps = falls ? pow(10, random_uniform(&r, -200, -0.01)) : random_uniform(&r, 1e-3, 1);
            const double loss_back = f->loss[end](f->beta_of_loss[end](loss));
            check(relative_error(loss_back, loss) < 8e-16, "%s: loss %.17g comes back as %.17g", f->name, loss,
                  loss_back);
            const double beta = f->beta[end](eps), back = f->eps[end](beta);
            /* an error of beta changes eps by `slope`; a huge beta may overflow */
            const double step = 0x1p-20, slope = fabs((f->eps[end](beta * (1 - step)) / back - 1) / step);
            if (beta < 0x1p1000)
                check(fabs(back / eps - 1) <= (2.5 * slope + 2) * DBL_EPSILON, "%s: eps %.17g comes back as %.17g, %g",
                      f->name, eps, back, slope);
        }
}
