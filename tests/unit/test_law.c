/* SPDX-License-Identifier: MIT */
/* Tests law.h: special values, hard cases, a function after its inverse, and the equation of motion.
 * tests/accuracy/test_laws.c tests errors in units of the last place at very many points. */
#include "check.h"

#include <cor/cor.h>

#include "../reference/laws.h"
#include "../reference/ode.h"
#include "runtime/number/elementary.h"

typedef double law_function(double);

enum { ENDS = COR_END_APPROACH_ONLY + 1 };

/* Returns a function of the table, or NULL if absent. */
static law_function *of(enum cor_law law, int end, enum cor_quantity quantity)
{
    const struct cor_law_function *const f = cor_law_function(law, (enum cor_end)end, quantity);
    return f ? f->value : NULL;
}

static double crossley_eps(double beta)
{
    return cor_law_value(COR_LAW_HUNT_CROSSLEY, COR_END_ZERO_FORCE, COR_EPS, beta);
}

/* ---- special values; for functions of one number, see tests/accuracy/test_laws.c ---- */

TEST(special_crossley)
{
    check_ulp(cor_hunt_crossley_max_overlap(0, 1.5), 1.09336207394327805637L, COR_HUNT_CROSSLEY_MAX_ULP);
    assert_true(cor_hunt_crossley_max_overlap(0, 1) == 1 && cor_hunt_crossley_max_overlap(INFINITY, 1) == 0);
    /* a constant force (a = 0) gives the largest overlap 1/2 */
    check_ulp(cor_hunt_crossley_max_overlap(0, 0), 0.5L, COR_HUNT_CROSSLEY_MAX_ULP);
    assert_true(cor_hunt_crossley_duration(INFINITY, 1) == INFINITY &&
                cor_hunt_crossley_duration(INFINITY, 2) == INFINITY);
    assert_true(cor_hunt_crossley_duration(INFINITY, 0) == 1 &&
                cor_hunt_crossley_time_of_max_overlap(INFINITY, 2) == 0);
    check_nan(cor_hunt_crossley_max_overlap(-1, 1), cor_hunt_crossley_max_overlap(1, -1),
              cor_hunt_crossley_max_overlap(1, INFINITY), cor_hunt_crossley_max_overlap(NAN, 1),
              cor_hunt_crossley_duration(1, 101), cor_hunt_crossley_duration(-1, 1),
              cor_hunt_crossley_duration(1, -0.5), cor_hunt_crossley_duration(1, NAN));
    check_ulp(cor_hunt_crossley_duration_approach_only(INFINITY, 1), acosl(0), COR_HUNT_CROSSLEY_MAX_ULP);
    assert_true(cor_hunt_crossley_duration_approach_only(INFINITY, 1.5) == INFINITY);
}

/* Spheres, and Hertz's spring with a dashpot, damped during approach only. With the largest overlap Y, eps is sqrt(4/5)
 * Y^(5/4). The rebound lasts half an elastic collision, divided by eps^(1/5). `first`: limit of loss/beta at beta = 0
 * */
static const struct {
    enum cor_law law;
    long double first;
} approaches[] = {{COR_LAW_VISCOELASTIC, -0.5L * COR_SPHERE_C1}, {COR_LAW_HERTZ_DASHPOT, 0.893907072144178638L}};

TEST(damped_approach)
{
    const long double half = 1.60903272985952150442L, part = 4.5L * DBL_EPSILON;
    for (size_t k = 0; k < COUNT_OF(approaches); k++) {
        law_function *f[COR_QUANTITIES];
        for (int q = 0; q < COR_QUANTITIES; q++)
            f[q] = of(approaches[k].law, COR_END_APPROACH_ONLY, (enum cor_quantity)q);
        law_function *const eps = f[COR_EPS], *const loss = f[COR_LOSS], *const beta_of = f[COR_DAMPING_OF_EPS],
                            *const beta_of_loss = f[COR_DAMPING_OF_LOSS], *const duration = f[COR_DURATION];
        assert_true(eps(0) == 1 && eps(-0.0) == 1 && eps(INFINITY) == 0 && loss(0) == 0 && loss(INFINITY) == 1);
        assert_true(beta_of(1) == 0 && beta_of(0) == INFINITY && beta_of_loss(0) == 0);
        assert_true(beta_of_loss(1) == INFINITY && duration(INFINITY) == INFINITY);
        EACH (bad, -1e-300, -INFINITY, NAN)
            check_nan(eps(*bad), loss(*bad), duration(*bad), beta_of(*bad), beta_of_loss(*bad));
        check_nan(beta_of(1.5), beta_of_loss(1.5));
        check_ulp(duration(0), 2 * half, 1);
        check_ulp(loss(0x1p-1000), 0x1p-1000L * approaches[k].first, COR_SPHERE_APPROACH_MAX_ULP);
        check_ulp(loss(0x1p-1050), 0x1p-1050L * approaches[k].first, COR_SPHERE_APPROACH_MAX_ULP);
        for (double beta = 0x1p-10; beta < 1e6; beta *= beta < 12.5 ? 1.002 : 1.37)
            for (int side = -1; side <= 1; side++) { /* beta, or a neighbour of a multiple of 1/16, where rows end */
                const double at = side == 0 ? beta : nextafter(floor(16 * beta) / 16 + 0.0625, side * DBL_MAX);
                const long double e = sqrtl(0.8L) * powl(f[COR_MAX_OVERLAP](at), 1.25L);
                check_near(eps(at), e, part);
                check(fabsl(loss(at) - (1 - e)) < part * fmaxl(e, 0.25L), "loss at %a", at);
                check_near(duration(at), f[COR_TIME_OF_MAX_OVERLAP](at) + half * powl(e, -0.2L), part);
                /* |d ln(beta)/d ln(eps)| is at most 6/5 for strong damping, and eps/(1 - eps) for weak */
                check_near(beta_of(eps(at)), at, part * fmaxl(2, 1 / (1 - e)));
            }
        for (int i = -53; i <= -1; i++) /* both arguments are exact */
            assert_true(same_bits(beta_of(1 - ldexp(1, i)), beta_of_loss(ldexp(1, i))));
    }
    const double least = cor_sphere_eps_approach_only(DBL_MAX);
    check(isfinite(cor_sphere_beta_approach_only(least * (1 + 0x1p-48))), "beta is finite up to the largest double");
    check(isinf(cor_sphere_beta_approach_only(least * (1 - 0x1p-48))), "beta is infinite beyond the largest double");
    /* eps = sqrt(4/5) beta^(-5/4), because the factor 1 + (5/4) ln(beta) beta^-5/2... rounds to 1; at 1e256 eps is
     * subnormal */
    check_ulp(of(COR_LAW_HERTZ_DASHPOT, COR_END_APPROACH_ONLY, COR_EPS)(1e200), 8.94427190999915878564e-251L, 2);
    check_ulp(of(COR_LAW_HERTZ_DASHPOT, COR_END_APPROACH_ONLY, COR_EPS)(1e256), 8.9442719099991588e-321L, 2);
    check_ulp(of(COR_LAW_HERTZ_DASHPOT, COR_END_APPROACH_ONLY, COR_DURATION)(1e200), half * powl(0.8L, -0.1L) * 1e50L,
              2);
    assert_true(of(COR_LAW_HERTZ_DASHPOT, COR_END_APPROACH_ONLY, COR_EPS)(DBL_MAX) == 0);
}

/* ---- exponentials and logarithms ---- */

/* Returns x with a second part of up to half of its last place. */
static struct cor_inline_pair pair_at(double x)
{
    int exponent;
    frexp(x, &exponent);
    return cor_pair(x, ldexp(random_uniform(&draw, -1, 1), exponent - 54));
}

/* The stated errors of exp(-x) and 1 - exp(-x) of pairs */
TEST(exponentials_of_pairs)
{
    for (size_t i = 0; i < points(20000); i++) {
        const double drawn = i % 3 == 0   ? random_log(&draw, 1e-17, 1)
                             : i % 3 == 1 ? random_uniform(&draw, 0, 1)
                                          : random_uniform(&draw, 0, 745);
        const struct cor_inline_pair x = pair_at(drawn);
        const struct cor_inline_pair pair = cor_kernel_exp_minus_pair(x.hi <= 700 ? x : cor_pair(0, 0));
        const long double power = expl(-(long double)x.hi) * (1.0L - x.lo + 0.5L * x.lo * x.lo),
                          lost = -expm1l(-(long double)x.hi) + x.lo * expl(-(long double)x.hi);
        const long double error[3] = {ulp_error(cor_kernel_exp_minus(x), power),
                                      ulp_error(cor_kernel_one_minus_exp_minus(x), lost),
                                      x.hi <= 700 ? fabsl(((long double)pair.hi + pair.lo) / power - 1) : 0};
        check(error[0] <= (power < DBL_MIN ? 1.1L : 0.75L) && error[1] <= 1.2L && error[2] <= 0x1p-54L * sqrtl(0.5L),
              "%a + %a: %Lg, %Lg, %Lg", x.hi, x.lo, error[0], error[1], error[2]);
    }
}

/* The stated error of -ln(x 2^k), where x is a pair */
TEST(logarithms_of_pairs)
{
    for (size_t i = 0; i < points(20000); i++) {
        const struct cor_inline_pair x = pair_at(random_uniform(&draw, 0.7, 1.42));
        const int k = i % 2 == 0 ? 0 : (int)random_uniform(&draw, -900, 1000);
        const struct cor_inline_pair computed = cor_kernel_minus_log(cor_pair(ldexp(x.hi, k), ldexp(x.lo, k)));
        const long double exact = -(log1pl(((long double)x.hi - 1) + x.lo) + k * 0.693147180559945309417L);
        const long double error = fabsl(((long double)computed.hi + computed.lo) / exact - 1);
        check(error <= 0x1p-54L * powl(2, -0.2L), "(%a + %a) 2^%d: %Lg", x.hi, x.lo, k, error);
    }
}

/* ---- both directions ---- */

/* Checks eps or loss -> damping -> eps or loss: off by at most `most` units, for any magnitude. */
static void check_back(enum cor_law law, int end, int of_loss, double e, double most)
{
    law_function *const inverse = of(law, end, of_loss ? COR_DAMPING_OF_LOSS : COR_DAMPING_OF_EPS);
    const double damping = inverse ? inverse(e) : INFINITY;
    if (damping < DBL_MAX) {
        const double back = of(law, end, of_loss ? COR_LOSS : COR_EPS)(damping);
        check(ulp_error(back, e) <= most, "%s, %s, %d: %a -> %a -> %a", cor_law_name(law),
              cor_end_name((enum cor_end)end), of_loss, e, damping, back);
    }
}

/* Returns the allowed error of eps -> damping -> eps, in units of eps; L = -ln(eps). A small eps is a power of the
 * damping, so rounding the damping costs no more than two roundings of eps. At zero overlap, rounding a damping ratio
 * costs L (1 + L^2/pi^2) = |d ln(eps)/d ln(zeta)|. Close to the dashpot's beta_c the rounding of beta matters. */
static double cost_of(enum cor_law law, int end, double e)
{
    const double l = -log(e);
    if (law == COR_LAW_VISCOELASTIC)
        return end == COR_END_APPROACH_ONLY ? 5 : 20;
    if (law == COR_LAW_HERTZ_DASHPOT)
        return end == COR_END_APPROACH_ONLY ? 5 : end == COR_END_ZERO_FORCE ? 8 : 8 + 0x1p-51 / (double)ulp(e);
    return law != COR_LAW_HUNT_CROSSLEY && end == COR_END_ZERO_OVERLAP ? 4 + 2 * l * (1 + l * l / 9.869604401089358)
                                                                       : 8;
}

TEST(back_at_random)
{
    for (size_t i = 0; i < points(20000); i++) {
        const enum cor_law law = (enum cor_law)random_below(&draw, COR_LAW_HERTZ_DASHPOT + 1);
        const int end = (int)random_below(&draw, ENDS);
        const double e = random_log(&draw, i % 4 ? 1e-12 : 1e-200, 1);
        check_back(law, end, 0, e, cost_of(law, end, e));
    }
}

/* All magnitudes of e and of 1 - e, subnormal numbers included */
TEST(every_size)
{
    for (int k = -1074; k < 0; k++) {
        const double e = ldexp(k > -1050 ? 1.375 : 1, k);
        for (int l = 0; l <= COR_LAW_HERTZ_DASHPOT; l++)
            for (int end = 0; end < ENDS; end++) {
                const enum cor_law law = (enum cor_law)l;
                const int is_ratio = law == COR_LAW_LINEAR || law == COR_LAW_TSUJI,
                          of_approach = l % 4 == 0 && end == COR_END_APPROACH_ONLY; /* rows of spheres and dashpots */
                check_back(law, end, 0, e, cost_of(law, end, e));
                if (!is_ratio || (k > -1073 && k < (end == COR_END_ZERO_OVERLAP ? -1 : 0)))
                    check_back(law, end, 1, e, of_approach ? 5 : 8);
            }
    }
}

/* Near critical damping, the code changes from Taylor series to quotients. */
TEST(near_critical_damping)
{
    for (int i = -64; i <= 64; i++)
        for (int end = COR_END_ZERO_FORCE; end < ENDS; end++)
            for (int of_loss = 0; of_loss < 2; of_loss++)
                check_back(COR_LAW_LINEAR, end, of_loss,
                           of(COR_LAW_LINEAR, end, of_loss ? COR_LOSS : COR_EPS)(1 + i * 0x1p-21), 8);
}

/* Both laws with a damping ratio have the same functions of eps. For every law eps is larger, and the contact shorter,
 * at zero force than at zero overlap. Limited damping has a larger eps, and damped approach the largest. */
TEST(order_of_the_ends)
{
    for (int end = 0; end < ENDS; end++)
        for (int q = 0; q <= COR_DAMPING_OF_LOSS; q++)
            assert_ptr_equal(of(COR_LAW_LINEAR, end, (enum cor_quantity)q),
                             of(COR_LAW_TSUJI, end, (enum cor_quantity)q));
    assert_ptr_equal(of(COR_LAW_LINEAR, COR_END_ZERO_FORCE, COR_MAX_OVERLAP),
                     of(COR_LAW_LINEAR, COR_END_APPROACH_ONLY, COR_EPS));
    for (size_t i = 0; i < points(20000); i++) {
        const enum cor_law law = (enum cor_law)(i % (COR_LAW_HERTZ_DASHPOT + 1));
        const double damping = random_log(&draw, 1e-9, 1e9);
        for (int end = 1, last = 0; end < ENDS; end++) {
            if (!of(law, end, COR_EPS))
                continue;
            check(of(law, last, COR_EPS)(damping) <= of(law, end, COR_EPS)(damping), "%s, end %d: eps at %.17g",
                  cor_law_name(law), end, damping);
            check(end > COR_END_ZERO_FORCE || of(law, 1, COR_DURATION)(damping) <= of(law, 0, COR_DURATION)(damping),
                  "%s: the durations at %.17g", cor_law_name(law), damping);
            last = end;
        }
    }
}

/* ---- the equation of motion ---- */

/* x'' = -x^(a4/4) - beta x^(b4/4) x', where the end of contact may modify the damping */
struct law {
    int a4, b4;
    long double beta;
    enum cor_end end;
};

static long double law_force(long double w, long double v, const void *of)
{
    const struct law *const law = of;
    const long double elastic = motion_power(w, law->a4), damping = law->beta * motion_power(w, law->b4) * v;
    if (law->end == COR_END_APPROACH_ONLY && v < 0)
        return elastic;
    return elastic + (law->end == COR_END_LIMITED ? fminl(damping, elastic) : damping);
}

static struct motion_course course(const struct law *law)
{
    const int free = law->end == COR_END_ZERO_FORCE || law->end == COR_END_LIMITED;
    return motion_course(&(struct motion){4, 0, law_force, law, free, 0});
}

/* Every function of a damping agrees with the integrated motion, at each end. `beta`: the beta of damping 1. If the
 * damping is above `overlaps_until`, the bodies part too late at zero overlap to be integrated. */
TEST(against_the_equation_of_motion)
{
    static const struct {
        enum cor_law law;
        int a4, b4;
        double beta, overlaps_until, damping[6];
    } motions[] = {
        {COR_LAW_VISCOELASTIC, 6, 2, 1, 3, {0.0625, 0.5, 1, 2.5, 5, 8}},
        {COR_LAW_LINEAR, 4, 0, 2, 0.9, {0.05, 0.3, 0.8, 1, 1.6, 4.5}},
        {COR_LAW_TSUJI, 6, 1, 2.23606797749978969640917366873, 0.9, {0.05, 0.3, 0.8, 1, 1.6, 4.5}},
        {COR_LAW_HUNT_CROSSLEY, 6, 6, 1, 9, {-0.6, 0.2, 1, 4}},
        {COR_LAW_HERTZ_DASHPOT, 6, 0, 1, 0.9, {0.02, 0.5, 0.7, 0.99, 2, 8}},
    };
    for (size_t i = 0; i < COUNT_OF(motions); i++)
        for (int c = 0; c < ENDS * 6; c++) {
            const double damping = motions[i].damping[c % 6];
            const enum cor_end end = (enum cor_end)(c / 6);
            const enum cor_law name = motions[i].law;
            const int at = end == COR_END_ZERO_FORCE || end == COR_END_LIMITED;
            const struct law law = {motions[i].a4, motions[i].b4, (long double)motions[i].beta * damping, end};
            if (!of(name, end, COR_EPS) || damping == 0 ||
                (end == COR_END_ZERO_OVERLAP && damping > motions[i].overlaps_until))
                continue;
            const struct motion_course r = course(&law);
            const long double exact[COR_QUANTITIES] = {[COR_EPS] = r.eps[at],
                                                       [COR_LOSS] = 1 - r.eps[at],
                                                       [COR_DURATION] = r.duration[at],
                                                       [COR_MAX_OVERLAP] = r.max_overlap,
                                                       [COR_TIME_OF_MAX_OVERLAP] = r.time_of_max_overlap};
            for (int q = 0; q < COR_QUANTITIES; q++) {
                law_function *const f = of(name, end, (enum cor_quantity)q);
                const long double off = f ? fabsl(f(damping) - exact[q]) / fmaxl(fabsl(exact[q]), q == COR_LOSS) : 0;
                if (q != COR_DAMPING_OF_EPS && q != COR_DAMPING_OF_LOSS && (damping > 0 || q == COR_EPS))
                    check(off < 4e-15L, "%s, end %d, %d, damping %g: %.17g, not %.19Lg, off by %Lg", cor_law_name(name),
                          end, q, damping, f(damping), exact[q], off);
            }
        }
    EACH (a, 0.5, 1, 1.5, 2.25)
        EACH (beta, -0.6, 0.2, 1, 4)
            for (int end = COR_END_ZERO_OVERLAP; end < ENDS; end += COR_END_APPROACH_ONLY) {
                const struct law law = {(int)(4 * *a), (int)(4 * *a), *beta, (enum cor_end)end};
                const struct motion_course r = course(&law);
                check_near((end == COR_END_APPROACH_ONLY ? cor_hunt_crossley_duration_approach_only
                                                         : cor_hunt_crossley_duration)(*beta, *a),
                           r.duration[0], COR_HUNT_CROSSLEY_TIME_MAX_ERROR);
                check_near(cor_hunt_crossley_max_overlap(*beta, *a), r.max_overlap, 1e-15);
                check_near(cor_hunt_crossley_time_of_max_overlap(*beta, *a), r.time_of_max_overlap,
                           COR_HUNT_CROSSLEY_TIME_MAX_ERROR);
            }
}

/* Returns beta for Hunt and Crossley's law: all magnitudes and both signs, down to the doubles next to -1. The next
 * function returns exponents a of all magnitudes, up to the largest. */
static double random_crossley_beta(void)
{
    switch (random_below(&draw, 6)) {
    case 0:
        return random_log(&draw, 1e-3, 1e3);
    case 1:
        return random_log(&draw, 1e2, 1e12);
    case 2:
        return random_log(&draw, 0x1p-1074, DBL_MAX);
    case 3:
        return -random_log(&draw, 1e-18, 0.5);
    case 4:
        return -1 + random_log(&draw, 1.2e-16, 0.9);
    default:
        return random_uniform(&draw, 0, 4); /* at 2 the method for the end of the rebound changes */
    }
}

static double random_crossley_exponent(void)
{
    const double most = COR_HUNT_CROSSLEY_MAX_EXPONENT;
    switch (random_below(&draw, 4)) {
    case 0:
        return random_uniform(&draw, 0, most);
    case 1:
        return random_uniform(&draw, 0, 4);
    case 2:
        return random_log(&draw, 1e-3, most);
    default:
        return random_below(&draw, 8) == 0 ? 0 : most - random_log(&draw, 1e-13, 1);
    }
}

/* Quadrature at run time, for any exponent, and for collisions that gain energy (beta < 0) */
TEST(crossley_times)
{
    static const struct {
        const char *name;
        double (*time)(double beta, double a);
        long double (*reference)(long double a, long double beta);
    } times[] = {
        {"time of the largest overlap", cor_hunt_crossley_time_of_max_overlap, reference_crossley_time_of_max_overlap},
        {"duration", cor_hunt_crossley_duration, reference_crossley_duration},
        {"duration, approach only", cor_hunt_crossley_duration_approach_only,
         reference_crossley_duration_approach_only},
    };
    for (size_t i = 0; i < points(200); i++) {
        const double a = random_crossley_exponent(), beta = random_crossley_beta();
        for (size_t k = 0; k < 3; k++) {
            const long double off = relative_error(times[k].time(beta, a), times[k].reference(a, beta));
            check(off <= COR_HUNT_CROSSLEY_TIME_MAX_ERROR, "%s at beta = %.17g, a = %.17g: off by %.1Le", times[k].name,
                  beta, a, off);
        }
    }
    /* a collision that gains energy lasts as long as the time-reversed damped one */
    for (double beta = 0.1; beta < 30; beta *= 1.7) {
        const double eps = crossley_eps(beta), back = -beta * eps, unit = pow(eps, (1 - 1.5) / (1 + 1.5));
        if (back < -0.999)
            break;
        check_near(cor_hunt_crossley_duration(back, 1.5) * unit, cor_hunt_crossley_duration(beta, 1.5),
                   1e-12 / (1 + back));
    }
    /* the elastic limit; a constant force, a = 0, with a closed form */
    check_near(cor_hunt_crossley_duration(1e-20, 2), cor_hunt_crossley_duration(0, 2), 1e-13);
    check_near(cor_hunt_crossley_duration(1, 0), log(2) - log1p(-crossley_eps(1)), COR_HUNT_CROSSLEY_TIME_MAX_ERROR);
}

/* ---- Hertz's dashpot ---- */

static double dashpot(enum cor_end end, enum cor_quantity quantity, double x)
{
    return cor_law_value(COR_LAW_HERTZ_DASHPOT, end, quantity, x);
}

/* Values from another program's integration, 18 digits */
TEST(hertz_dashpot_known)
{
    const struct {
        enum cor_end end;
        enum cor_quantity quantity;
        double beta;
        long double value;
    } known[] = {
        {COR_END_ZERO_OVERLAP, COR_EPS, 0.5, 0.356912974176213893L},
        {COR_END_ZERO_FORCE, COR_EPS, 0.5, 0.468038544824803370L},
        {COR_END_ZERO_OVERLAP, COR_DURATION, 0.5, 3.674312264397680617L},
        {COR_END_ZERO_FORCE, COR_DURATION, 0.5, 2.782528143330340519L},
        {COR_END_ZERO_FORCE, COR_MAX_OVERLAP, 0.5, 0.791261564952323956L},
        {COR_END_APPROACH_ONLY, COR_EPS, 0.5, 0.667490488913183823L},
        {COR_END_APPROACH_ONLY, COR_DAMPING_OF_EPS, 0.667490488913183823, 0.5},
        {COR_END_ZERO_FORCE, COR_DAMPING_OF_LOSS, 0.463, 0.400583306380001424L}, /* the cube root is rounded */
        {COR_END_ZERO_OVERLAP, COR_EPS, 1, 0.041320343494337112L},
        {COR_END_ZERO_FORCE, COR_EPS, 1, 0.251843353467950750L},
        {COR_END_ZERO_FORCE, COR_EPS, 5, 0.015357698164110697L},
        {COR_END_ZERO_FORCE, COR_EPS, COR_HERTZ_DASHPOT_BETA_C, 0.218449655319366605L},
        {COR_END_ZERO_FORCE, COR_MAX_OVERLAP, COR_HERTZ_DASHPOT_BETA_C, 0.570733527712282338L},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        check(relative_error(dashpot(known[i].end, known[i].quantity, known[i].beta), known[i].value) < 3e-16,
              "known value %zu", i);
}

/* Just below beta_c, at beta_c - d, eps is s d (1 + pi sqrt(s d/beta_c^5) + O(d ln d)),
 * with s = 0.206987698804278902. */
TEST(hertz_dashpot_threshold)
{
    const double s = 0.206987698804278902, beta_c = COR_HERTZ_DASHPOT_BETA_C, pi = 3.141592653589793;
    for (int k = 16; k <= 30; k++) {
        const double d = ldexp(1, -k), first = s * d * (1 + pi * sqrt(s * d / pow(beta_c, 5)));
        const double eps = dashpot(COR_END_ZERO_OVERLAP, COR_EPS, beta_c - d);
        check(fabs(eps / first - 1) < 20 * d * k + 1e-6, "d = 2^-%d: %.17g and %.17g", k, eps, first);
        /* beta_c t + ln(eps) tends to 3.06410, where t is the duration */
        check(fabs(beta_c * dashpot(COR_END_ZERO_OVERLAP, COR_DURATION, beta_c - d) + log(eps) - 3.06410) <
                  2 * sqrt(d) + 1e-5,
              "d = 2^-%d: duration %.17g", k, dashpot(COR_END_ZERO_OVERLAP, COR_DURATION, beta_c - d));
    }
}

/* Impacts at and around the slowest speed at which the bodies separate, g_c = C^5/(beta_c^5 m^3 K^2), in SI units */
TEST(hertz_dashpot_slowest_speed)
{
    static const double scene[][3] = {{0.01, 3e6, 2.5}, {1e-9, 40, 1e-7}, {7, 1e9, 4e4}}; /* m, K, C */
    for (size_t i = 0; i < sizeof scene / sizeof *scene; i++) {
        const double m = scene[i][0], K = scene[i][1], C = scene[i][2];
        const double slowest = pow(C / COR_HERTZ_DASHPOT_BETA_C, 5) / (m * m * m * K * K);
        for (int k = -3; k <= 3; k++) {
            const double g = slowest * (1 + k * 1e-12);
            const double beta = C * pow(m, -0.6) * pow(K, -0.4) * pow(g, -0.2);
            const double eps = dashpot(COR_END_ZERO_OVERLAP, COR_EPS, beta);
            if (k != 0)
                check((eps > 0) == (k > 0) &&
                          (dashpot(COR_END_ZERO_OVERLAP, COR_DURATION, beta) == INFINITY) == (k < 0),
                      "at g_c (1 + %d 1e-12): eps %g", k, eps);
            check(dashpot(COR_END_ZERO_FORCE, COR_EPS, beta) > 0.2, "zero force parts at every speed");
        }
    }
    /* eps is 1e-6 at beta_c - d, where s d (1 + pi sqrt(s d/beta_c^5)) is 1e-6 up to a relative error d ln(d) */
    const double d = COR_HERTZ_DASHPOT_BETA_C - dashpot(COR_END_ZERO_OVERLAP, COR_DAMPING_OF_EPS, 1e-6),
                 x = 0.206987698804278902 * d;
    const double eps = x * (1 + 3.141592653589793 * sqrt(x / pow(COR_HERTZ_DASHPOT_BETA_C, 5)));
    check(fabs(eps / 1e-6 - 1) < 5e-5, "beta of 1e-6: %.9g", eps);
}

/* ---- oblique impacts ---- */

/* x'' = -x^a, and two linear systems that start at the turning point. Displacements: s'' = -kappa x^(a-1) s. Velocities
 * u and forces f: u' = -f, f' = kappa x^(a-1) u. Each system has an even and an odd solution. State: x, x'; s, s' of
 * the even, then of the odd solution; f, u of the even, then of the odd solution. */
enum { OBLIQUE = 10 }; /* the next element is r; the time is -r^4, so x^(a-1) is smooth in r if 4 a is an integer */

static void oblique_slopes(long double *dy, const long double *y, const void *of)
{
    const long double *const a_kappa = of, x = fmaxl(y[0], 0), k = a_kappa[1] * powl(x, a_kappa[0] - 1);
    const long double rate = 4 * y[OBLIQUE] * y[OBLIQUE] * y[OBLIQUE];
    dy[0] = rate * y[1];
    dy[1] = -rate * x * k / a_kappa[1];
    for (int i = 2; i < OBLIQUE; i += 2) {
        dy[i] = rate * (i < 6 ? 1 : k) * y[i + 1];
        dy[i + 1] = -rate * (i < 6 ? k : 1) * y[i];
    }
    dy[OBLIQUE] = -1;
}

static void oblique_ratios(long double ratio[2], long double a, long double kappa)
{
    const long double a_kappa[2] = {a, kappa}, first = powl(reference_crossley_elastic_half(a), 0.25L);
    /* even solutions start with s = 1 and u = 1, odd ones with s' = 1 and f = 1 */
    long double y[OBLIQUE + 1] = {powl((a + 1) / 2, 1 / (a + 1)), 0, 1, 0, 0, 1, 0, 1, 1, 0, first};
    struct ode o = {.slopes = oblique_slopes, .of = a_kappa, .n = OBLIQUE + 1, .longest = 0.1L};
    ode_advance(&o, y, first);
    /* s or f must be 0 at first contact. From first contact to the end, only the odd solution changes its sign. */
    ratio[0] = (y[2] * y[5] + y[4] * y[3]) / (y[2] * y[5] - y[4] * y[3]);
    ratio[1] = (y[8] * y[7] + y[6] * y[9]) / (y[8] * y[7] - y[6] * y[9]);
}

TEST(oblique_impacts)
{
    static const double exponents[] = {1, 1.25, 1.5, 2, 3}, kappas[] = {0.2, 1, 3.5, 4.5, 7, 30};
    for (size_t i = 0; i < sizeof exponents / sizeof *exponents; i++)
        for (size_t j = 0; j < sizeof kappas / sizeof *kappas; j++) {
            const double a = exponents[i], y = cor_tangential_no_slip(kappas[j], a);
            long double ratio[2];
            oblique_ratios(ratio, a, kappas[j]);
            for (int k = 0; k < 2; k++)
                check(fabsl(ratio[k] - y) < 1e-9L, "kappa = %g, a = %g: %.12g, integrated %.12Lg", kappas[j], a, y,
                      ratio[k]);
        }
    for (double a = 1.0 / 1024; a < 100; a *= 1.7) {
        assert_true(cor_tangential_no_slip(0, a) == 1 && cor_tangential_no_slip(1, a) == -1);
        assert_true(cor_tangential_no_slip(a, a) == -1);
    }
    assert_true(cor_tangential_no_slip(4.5, 1.5) == 1);
    /* a = 1 gives cos(pi sqrt(kappa)): its zeros, and its value pi^2 d/(-pi) at the double next to the first zero */
    for (double n = 0.5; n < 900; n++)
        assert_true(cor_tangential_no_slip(n * n, 1) == 0);
    check_ulp(cor_tangential_no_slip(0.25 * (1 + DBL_EPSILON), 1),
              -acosl(-1) * (DBL_EPSILON / 4) * (1 - 0.25L * DBL_EPSILON), COR_NO_SLIP_MAX_ULP);
    /* near zeros of the function; digits computed by MPFR */
    check_ulp(cor_tangential_no_slip(0.00031801765149485283, 0.0006364401013624106), 1.4691851383330200549e-16L,
              COR_NO_SLIP_MAX_ULP);
    check_ulp(cor_tangential_no_slip(543421.90086554212, 0.03145269842658744), 6.9979058592045206601e-12L,
              COR_NO_SLIP_MAX_ULP);
    const double wrong[][2] = {{-1e-9, 1}, {NAN, 1}, {1, NAN}, {1, 0}, {1, -1}, {1, 101}, {1.1e6, 1}, {1, INFINITY}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_true(isnan(cor_tangential_no_slip(wrong[i][0], wrong[i][1])));
}

/* x'' = -x^(3/2), and a displacement s that friction limits to |s| <= x/u. u is u/v in units of L (docs/theory.md, 20).
 * During slip, s equals the limit. y = {x, x', s, s' in units of its first value} */
struct friction {
    double kappa, u;
    int slips;
};

static void friction_slopes(long double *dy, const long double *y, const void *of)
{
    const struct friction *const f = of;
    const long double root = sqrtl(fmaxl(y[0], 0));
    dy[0] = y[1];
    dy[1] = -root * root * root;
    dy[2] = f->slips ? (y[2] < 0 ? -y[1] : y[1]) / f->u : y[3];
    dy[3] = -f->kappa * root * y[2];
}

/* Returns a value that falls to 0 when slip begins, or when sticking resumes. */
static long double friction_room(const long double *y, const void *of)
{
    const struct friction *const f = of;
    return f->slips ? (y[2] < 0 ? -y[3] : y[3]) - y[1] / f->u : y[0] / f->u - fabsl(y[2]);
}

/* Returns u'/u. *first: the overlap at which slip begins first, with a minus sign during the rebound. */
static double slipping_ratio(double kappa, double u, double *first)
{
    static ode_value *const values[] = {motion_overlap, friction_room};
    struct friction f = {kappa, u, u > 1};
    struct ode o = {.slopes = friction_slopes, .of = &f, .n = 4, .longest = 0.1L, .error = 1e-12L};
    long double y[4] = {0, 1, 0, 1};
    *first = u > 1 ? DBL_MIN : 0;
    for (int ends = -1; ends != 0;) {
        ends = ode_until(&o, y, values, 2);
        if (ends == 1 && *first == 0)
            *first = (double)(y[1] < 0 ? -y[0] : y[0]);
        f.slips = ends == 1 ? !f.slips : f.slips;
    }
    return (double)y[3];
}

/* u'/u agrees with the table of docs/theory.md, 20. At the angle of sticking there is no slip during the approach. */
TEST(slip_in_oblique_impacts)
{
    static const double nus[] = {0, 0.2, 0.25, 0.3, 0.4, 0.5}, parts[] = {1, 0.5, 0.25, 0.1};
    static const double changes[][4] = {
        {0.0249, 0.0138, 0.0065, 0.0020},     {0.0007, 0.0004, 0.0002, 0.0001},    {0, 0, 0, 0},
        {-0.0578, -0.0023, -0.0005, -0.0001}, {-0.210, -0.0328, -0.0077, -0.0016}, {-0.329, -0.0929, -0.0266, -0.0059}};
    for (size_t i = 0; i < sizeof nus / sizeof *nus; i++) {
        const double kappa = 10.5 * (1 - nus[i]) / (2 - nus[i]), stuck = cor_tangential_no_slip(kappa, 1.5);
        double first;
        for (size_t k = 0; k < sizeof parts / sizeof *parts; k++) {
            const double change = slipping_ratio(kappa, parts[k], &first) - stuck;
            check(fabs(change - changes[i][k]) < 7e-4, "nu = %g, L %g: %.5f", nus[i], parts[k], change);
            assert_true(first <= 0);
        }
    }
}

/* Each function of the table has the name, domain and values that its law, end and quantity require. */
TEST(table)
{
    size_t count = 0;
    for (int l = -1; l <= COR_LAWS; l++)
        for (int e = -1; e <= COR_ENDS; e++)
            for (int q = -1; q <= COR_QUANTITIES; q++) {
                const enum cor_law law = (enum cor_law)l;
                const enum cor_end end = (enum cor_end)e;
                const enum cor_quantity quantity = (enum cor_quantity)q;
                const struct cor_law_function *const f = cor_law_function(law, end, quantity);
                char name[80], *dash;
                double x[3] = {NAN, 0.25, 0.5}, y[3] = {1, 2, 3};
                float xf[3] = {NAN, 0.25F, 0.5F}, yf[3] = {1, 2, 3};
                cor_law_array(law, end, quantity, x, y, 3);
                cor_law_arrayf(law, end, quantity, xf, yf, 3);
                count += f != NULL && l <= COR_LAW_HERTZ_DASHPOT;
                for (size_t i = 0; i < 3; i++) {
                    const double value = f ? f->value(x[i]) : NAN;
                    check(same_number(y[i], value), "%d %d %d", l, e, q);
                    check(same_number(cor_law_value(law, end, quantity, x[i]), value), "%d %d %d", l, e, q);
                    check(f && f->arrayf ? i == 0 || fabsf(yf[i] - (float)value) <= FLT_EPSILON
                                         : same_number((double)yf[i], (double)(float)value),
                          "%d %d %d", l, e, q);
                }
                if (f == NULL)
                    continue;
                snprintf(name, sizeof name, "%s_%s%s%s", cor_law_name(law), cor_quantity_name(quantity),
                         q >= COR_MAX_OVERLAP ? "" : "_", q >= COR_MAX_OVERLAP ? "" : cor_end_name(end));
                while ((dash = strchr(name, '-')) != NULL)
                    *dash = '_';
                assert_string_equal(f->name, name);
                assert_true(f->max_ulp >= 1 && f->max_ulp <= 2);
                check(!isnan(f->value(f->least)) && !isnan(f->value(f->largest)), "%s", name);
                check(isnan(f->value(nextafter(f->least, -2))) &&
                          isnan(f->value(nextafter(f->largest, 2))) == !isinf(f->largest),
                      "%s", name);
            }
    assert_int_equal(count, 19 + 26 + 26 + 21 + 21);
    assert_true(!cor_law_name(COR_LAWS) && !cor_end_name(COR_BOTH_ENDS) && !cor_quantity_name(COR_QUANTITIES));
}
