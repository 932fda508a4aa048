/* SPDX-License-Identifier: MIT */
#include "check.h"

#include <cor/cor.h>

#include "../reference/ode.h"

typedef double sphere_function(double);

static sphere_function *const eps_function[2] = {cor_sphere_eps_zero_overlap, cor_sphere_eps_zero_force};
static sphere_function *const beta_function[2] = {cor_sphere_beta_zero_overlap, cor_sphere_beta_zero_force};
static const char *const end_name[2] = {"zero overlap", "zero force"};

static const double smallest = 4.9406564584124654e-324;

/* One collision */
struct reference {
    long double eps_zero_overlap, loss_zero_overlap, eps_zero_force, loss_zero_force;
    long double duration_zero_overlap, duration_zero_force, max_overlap, time_of_max_overlap;
};

/* A function of beta, its bound, and its place in struct reference */
struct function {
    const char *name;
    sphere_function *value;
    double max_ulp;
    size_t reference;
    double at_zero, at_infinity;
};

#define ROW(quantity, max_ulp, at_zero, at_infinity)                                                                   \
    {                                                                                                                  \
#quantity, cor_sphere_##quantity, max_ulp, offsetof(struct reference, quantity), at_zero, at_infinity          \
    }

/* The functions. Values at beta = 0: 2 tau_0, y_0 and tau_0 of (51), to the nearest double */
static const struct function functions[] = {
    ROW(eps_zero_overlap, COR_SPHERE_EPS_MAX_ULP, 1, 0),
    ROW(eps_zero_force, COR_SPHERE_EPS_MAX_ULP, 1, 0),
    ROW(loss_zero_overlap, COR_SPHERE_LOSS_MAX_ULP, 0, 1),
    ROW(loss_zero_force, COR_SPHERE_LOSS_MAX_ULP, 0, 1),
    ROW(duration_zero_overlap, COR_SPHERE_TIME_MAX_ULP, 3.21806545971904308454, INFINITY),
    ROW(duration_zero_force, COR_SPHERE_TIME_MAX_ULP, 3.21806545971904308454, 0),
    ROW(max_overlap, COR_SPHERE_MAX_OVERLAP_MAX_ULP, 1.09336207394327805637, 0),
    ROW(time_of_max_overlap, COR_SPHERE_TIME_MAX_ULP, 1.60903272985952154227, 0),
};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

static long double field(const struct reference *r, const struct function *f)
{
    long double value;
    memcpy(&value, (const char *)r + f->reference, sizeof value);
    return value;
}

/* Returns C_1 by (30), in long double from libm's Gamma, not from the digits of the library. */
static long double c1_exact(void)
{
    return -sqrtl(acosl(-1)) * tgammal(0.6L) / (powl(2, 0.2L) * powl(5, 0.4L) * tgammal(2.1L));
}

/* ---- values ---- */

/* Values from corgen collide, by integration in balls. eps at 0.5, 1 and 5 is known from another source. */
static const struct {
    double beta;
    struct reference value;
} known[] = {
    {0.0625,
     {0.930905126297783164849L, 0, 0.931139096161744280809L, 0, 3.24208570484271551976L, 3.17957897321306488502L,
      1.06290317681289516005L, 1.59150912915305135783L}},
    {0.5,
     {0.573824628664948983554L, 0, 0.595251501135126961556L, 0, 3.45834557160371087219L, 2.95044468572593269527L,
      0.895880074006970328470L, 1.48703313419539170838L}},
    {1,
     {0.331164810466640935280L, 0, 0.393930603229873193051L, 0, 3.82845463702221777715L, 2.75202657403904966334L,
      0.767480801539039307675L, 1.39487050579294985174L}},
    {5,
     {0.00165068207177331763896L, 0, 0.0688996576792389357963L, 0, 20.2807977952198052266L, 2.00513027971186146983L,
      0.395552520104352316984L, 1.02898789566972979962L}},
    {7,
     {0.000306918647246247699298L, 0, 0.0427413753447571053160L, 0, 35.3696376016490158890L, 1.82276947715998723314L,
      0.328552750560490449543L, 0.936221874768649275920L}},
    {8,
     {0.000157421316658559729505L, 0, 0.0351139186876506487182L, 0, 43.7261458104686248808L, 1.75045915494251159818L,
      0.304260843162011668714L, 0.899217995053689394766L}},
    {20,
     {1.61199428258365163013e-6L, 0, 0.00846447203313316157000L, 0, 168.428754099493200798L, 1.27768349518799061738L,
      0.173615396785815276032L, 0.655560410111662145932L}},
    {1e4,
     {5.15838170426768521641e-20L, 0, 2.82309278065484083843e-7L, 0, 291100.070220562687803L, 0.0589221160871746154673L,
      0.00282310047733060608298L, 0.0297768075227525677431L}},
    {1e6,
     {5.15838170426768521641e-30L, 0, 1.31037069204966888435e-10L, 0, 44460573.4621438107589L,
      0.00407591378606228999889L, 0.000131037069458647079699L, 0.00205261354745409253092L}},
};
enum { KNOWN = sizeof known / sizeof *known };

TEST(known_answers)
{
    for (int i = 0; i < KNOWN; i++) {
        struct reference r = known[i].value;
        const double beta = known[i].beta;
        r.loss_zero_overlap = 1 - r.eps_zero_overlap;
        r.loss_zero_force = 1 - r.eps_zero_force;
        for (int k = 0; k < FUNCTIONS; k++) {
            const struct function *f = &functions[k];
            const long double error = ulp_error(f->value(beta), field(&r, f));
            check(error <= f->max_ulp, "%s(%g): %Lg ulp", f->name, beta, error);
        }
    }
}

/* Returns the force of Hertz's spring and its damper, where x = w^2. */
static long double force(long double w, long double v, const void *beta)
{
    return w * w * w + *(const double *)beta * w * v;
}

/* Agreement with the integrated motion. tests/accuracy/test_accuracy.c has many points, any beta, and the inverse. */
TEST(against_the_equation_of_motion)
{
    for (size_t i = 0; i < points(400); i++) {
        const double beta = i % 2 ? random_uniform(&draw, 0, 8) : random_log(&draw, 0.02, 3);
        const struct motion_course c = motion_course(&(struct motion){2, 0, force, &beta, 0, 0});
        const struct reference r = {c.eps[0],      1 - c.eps[0],  c.eps[1],      1 - c.eps[1],
                                    c.duration[0], c.duration[1], c.max_overlap, c.time_of_max_overlap};
        for (int k = 0; k < FUNCTIONS; k++) {
            const long double exact = field(&r, &functions[k]);
            /* 1 - eps loses digits if it is small */
            if (exact > 0.02L || functions[k].at_zero > 0)
                check_ulp(functions[k].value(beta), exact, functions[k].max_ulp + 0.06);
        }
    }
}

/* If mu = beta^(-5/3) is below the last bit, closed forms exist for everything except the duration at zero overlap
 * (docs/theory.md, 8). With X = (3/2)^(2/3): eps = X beta^(-5/3), x_max = X beta^(-2/3), t_max = beta^(-2/3) (2/3) X
 * (5/3 ln(beta) + ln(3/X) + K), K = ln(3)/2 - sqrt(3) pi/6. The duration at zero force has twice the ln(beta), and
 * ln(3/sqrt(X)) in place of ln(3/X). */
TEST(infinitely_strong_damping)
{
    const long double x = cbrtl(2.25L), constant = logl(3) / 2 - sqrtl(3) * acosl(-1) / 6;
    for (size_t i = 0; i < points(20000); i++) {
        const double beta = i == 0 ? DBL_MAX : random_log(&draw, 1e14, DBL_MAX);
        const long double u = logl(beta), root = cbrtl(beta), scale = 1 / (root * root), far = (long double)beta * beta;
        const long double exact[FUNCTIONS] = {5.158381704267685216414L / far / far / beta,
                                              x * scale / beta,
                                              1,
                                              1 - x * scale / beta,
                                              cor_sphere_duration_zero_overlap(beta),
                                              scale * x * 2 / 3 * (10 * u / 3 + logl(3 / sqrtl(x)) + constant),
                                              x * scale,
                                              scale * x * 2 / 3 * (5 * u / 3 + logl(3 / x) + constant)};
        for (int k = 0; k < FUNCTIONS; k++)
            check(ulp_error(functions[k].value(beta), exact[k]) <= functions[k].max_ulp + 0.06, "%s(%a)",
                  functions[k].name, beta);
    }
    /* this duration is (10/3) beta ln(beta) + constant beta, with the constant from beta = 1e6; corrections are below
     * mu ln(beta)^2 */
    const long double offset = 44460573.4621438107589L / 1e6L - 10 * logl(1e6L) / 3;
    for (double beta = 1e8; beta < 1e300; beta *= 1e7)
        check(fabsl(cor_sphere_duration_zero_overlap(beta) / (beta * (10 * logl(beta) / 3 + offset)) - 1) < 1e-9L, "%g",
              beta);
}

/* ---- special values ---- */

TEST(special_values)
{
    for (int k = 0; k < FUNCTIONS; k++) {
        const struct function *f = &functions[k];
        EACH (outside, -INFINITY, NAN, -1, -smallest, -DBL_MIN, -DBL_MAX, -1e-30)
            check(isnan(f->value(*outside)), "%s(%a)", f->name, *outside);
        check(f->value(0.0) == f->at_zero && f->value(-0.0) == f->at_zero, "%s(0) = %a", f->name, f->value(0.0));
        check(!signbit(f->value(-0.0)), "%s(-0)", f->name);
        check(f->value(INFINITY) == f->at_infinity, "%s(inf) = %a", f->name, f->value(INFINITY));
        /* subnormal arguments; the losses are tested elsewhere */
        EACH (small, smallest, 3 * smallest, DBL_MIN, nextafter(DBL_MIN, 0), 0x1p-1000)
            check(f->value(*small) == f->at_zero || f->at_zero == 0, "%s(%a)", f->name, *small);
        const double last = f->value(DBL_MAX);
        check(last >= 0 && (last <= DBL_MAX || f->at_infinity > 1), "%s(DBL_MAX) = %a", f->name, last);
    }
    for (int end = 0; end < 2; end++) {
        sphere_function *const f = beta_function[end];
        EACH (bad, -smallest, -1, nextafter(1, 2), 2, INFINITY, -INFINITY, NAN)
            check(isnan(f(*bad)), "%s, %a", end_name[end], *bad);
        assert_true(f(1) == 0 && !signbit(f(1)));
        assert_true(f(0.0) == INFINITY && f(-0.0) == INFINITY);
        assert_true(f(smallest) < DBL_MAX && f(smallest) > 1e60);
        assert_true(f(DBL_MIN) > f(nextafter(DBL_MIN, 1)) || f(DBL_MIN) == f(nextafter(DBL_MIN, 1)));
    }
    /* underflow of the power law: from 5e64 onward, h*^5 beta^-5 is below half of the smallest number */
    assert_true(cor_sphere_eps_zero_overlap(1.1e65) == 0 && cor_sphere_eps_zero_overlap(1e64) > 0);
    assert_true(cor_sphere_eps_zero_force(1e200) == 0 && cor_sphere_eps_zero_force(1e190) > 0);
}

/* ---- order ---- */

static void never_rises(int end, double beta, int count)
{
    double eps = eps_function[end](beta);
    for (int k = 0; k < count; k++) {
        beta = nextafter(beta, INFINITY);
        const double next = eps_function[end](beta);
        check(next <= eps + (double)ulp(eps) && next >= 0 && next <= 1, "%s at beta = %a: %a after %a", end_name[end],
              beta, next, eps);
        eps = next;
    }
}

/* Around every power of two 2^-k, tests every double whose eps is from 2^-k to 2^-k + u/2, where u is one ulp. Only for
 * these doubles does the order not follow from a decreasing eps and errors below an ulp (docs/theory.md, 18). The walk
 * begins with a result of 2^-k + 2 u and ends with 2^-k - u, so eps itself is outside at both ends. */
TEST(falls_at_powers_of_two)
{
    enum { FARTHEST = 64 };
    for (int end = 0; end < 2; end++)
        for (int k = 1; k <= 1022; k++) {
            const double power = ldexp(1, -k), u = ldexp(1, -k - 52);
            double beta = beta_function[end](power);
            int back = 0, count = 1;
            for (; back < FARTHEST && eps_function[end](beta) < power + 2 * u; back++)
                beta = nextafter(beta, 0);
            for (double last = beta; count < 2 * FARTHEST && eps_function[end](last) > power - u; count++)
                last = nextafter(last, INFINITY);
            check(back < FARTHEST && count < 2 * FARTHEST, "%s: the doubles around eps = 2^-%d", end_name[end], k);
            never_rises(end, beta, count);
        }
}

/* Returns d ln(f)/d ln(beta), as the difference quotient between beta and beta (1 + 2^-10). */
static double slope(sphere_function *f, double beta)
{
    const double next = beta * (1 + 0x1p-10);
    return log(f(next) / f(beta)) / log(next / beta);
}

/* Returns the time from zero force to zero overlap, divided by beta. */
static double creep(double beta)
{
    return (cor_sphere_duration_zero_overlap(beta) - cor_sphere_duration_zero_force(beta)) / beta;
}

/* The bounds of derivatives by ln(beta) in docs/theory.md, 4. They also bound a difference quotient. */
TEST(derivatives)
{
    const double slack = 1e-9; /* rounding errors of a quotient */
    for (size_t i = 0; i < points(2000); i++) {
        const double beta = i % 2 ? random_log(&draw, 0.01, 20) : random_log(&draw, 20, 1e50);
        const double overlap = -slope(cor_sphere_eps_zero_overlap, beta),
                     force = -slope(cor_sphere_eps_zero_force, beta);
        const double time[2] = {slope(cor_sphere_duration_zero_overlap, beta),
                                slope(cor_sphere_duration_zero_force, beta)};
        const double most = slope(cor_sphere_max_overlap, beta);
        check(force >= (beta >= 2 ? 0.5 : 0) - slack && force <= 5 / 3.0 + slack, "beta = %a: kappa = %g", beta, force);
        check(overlap >= force - slack && overlap <= 5 + slack, "beta = %a: kappa = %g", beta, overlap);
        check(beta < 7 || overlap >= 5 - 2 * slack, "beta = %a: kappa = 5 - %g", beta, 5 - overlap);
        check(time[0] >= -1.5 && time[0] <= 1 + 5 / 1.74 + slack, "beta = %a: duration, %g", beta, time[0]);
        check(time[1] >= -1.5 && time[1] <= 1 + slack, "beta = %a: duration until zero force, %g", beta, time[1]);
        check(slope(creep, beta) >= -slack, "beta = %a: creep, %g", beta, slope(creep, beta));
        check(most >= -2 / 3.0 - slack && most <= slack, "beta = %a: largest overlap, %g", beta, most);
    }
    /* numbers that the proofs use */
    check(cor_sphere_duration_zero_force(2.6) / 2.6 > 0.89, "%a", cor_sphere_duration_zero_force(2.6));
    check(creep(2.6) > 1.74, "%a", creep(2.6));
    check(sqrt(cor_sphere_eps_zero_force(7) * 16807) > 26.8, "%a", cor_sphere_eps_zero_force(7));
}

/* ---- constants, and functions of 1999 ---- */

TEST(constants)
{
    const long double c1 = c1_exact(), d = sqrtl(acosl(-1)) * tgammal(0.6L) / (5 * tgammal(2.1L));
    check_ulp(COR_SPHERE_C1, c1, 0.5L + 1e-3L);
    check_ulp(COR_SPHERE_SIMPLE_D, d, 0.5L + 1e-3L);
    /* with the delta of (14), 2 delta d is |C_1| beta */
    check(fabsl(2 * powl(1.25L, 0.6L) * d + c1) < 1e-17L, "2 (5/4)^(3/5) d = |C_1|");
}

/* Returns the root of (27) in long double by bisection in ln eps. */
static long double simple_exact(long double c)
{
    long double low = -1e3L, high = 0;
    for (int i = 0; i < 200; i++) {
        const long double middle = (low + high) / 2;
        if (expl(middle) + c * expl(0.6L * middle) < 1)
            low = middle;
        else
            high = middle;
    }
    return expl((low + high) / 2);
}

TEST(simple_theory)
{
    const long double c1 = -c1_exact();
    for (size_t i = 0; i < points(2000); i++) {
        const double beta = i % 2 ? random_uniform(&draw, 0, 20) : random_log(&draw, 1e-20, 1e195);
        const long double c = c1 * beta;
        const long double exact = simple_exact(c);
        /* bisection in ln(eps) has an error of 1e-19 |ln(eps)|, below a tenth of a unit */
        check_ulp(cor_sphere_eps_simple(beta), exact, COR_SPHERE_EPS_SIMPLE_MAX_ULP);
        const int depth = (int)(i % 7);
        long double t = 1;
        for (int k = 0; k < depth; k++)
            t = 1 + c * powl(t, 0.4L);
        check_ulp(cor_sphere_eps_simple_fraction(beta, depth), 1 / t, COR_SPHERE_EPS_SIMPLE_MAX_ULP);
        const long double s = c, published = (1 + 2.5839L * s) /
                                             (1 + s * (3.5839L + s * (2.9839L + s * (1.1487L + s * 0.3265L))));
        check_ulp(cor_sphere_eps_published_pade(beta), published, COR_SPHERE_EPS_SIMPLE_MAX_ULP);
    }
}

TEST(simple_theory_special_values)
{
    EACH (bad, -1, -smallest, -INFINITY, NAN)
        check_nan(cor_sphere_eps_simple(*bad), cor_sphere_eps_simple_fraction(*bad, 3),
                  cor_sphere_eps_published_pade(*bad));
    EACH (zero, 0.0, -0.0)
        assert_true(cor_sphere_eps_simple(*zero) == 1 && cor_sphere_eps_simple_fraction(*zero, 5) == 1 &&
                    cor_sphere_eps_published_pade(*zero) == 1);
    EACH (large, INFINITY, DBL_MAX)
        assert_true(cor_sphere_eps_simple(*large) == 0 && cor_sphere_eps_simple_fraction(*large, 0) == 1 &&
                    cor_sphere_eps_simple_fraction(*large, 4) == 0 && cor_sphere_eps_published_pade(*large) == 0);
    assert_true(cor_sphere_eps_simple_fraction(1, 0) == 1);
    check_nan(cor_sphere_eps_simple_fraction(1, -1));
    /* (28) converges to the root of (27) from above */
    check_near(cor_sphere_eps_simple_fraction(1, 200), cor_sphere_eps_simple(1), 8 * DBL_EPSILON);
    for (int depth = 0; depth < 20; depth++)
        assert_true(cor_sphere_eps_simple_fraction(1.5, depth) > cor_sphere_eps_simple_fraction(1.5, depth + 1));
    assert_true(cor_sphere_eps_simple_fraction(1, 2147483647) > 0.36);
}

/* The documented errors of the approximations of 1999: sphere.h states these numbers. */
TEST(documented_errors_of_1999)
{
    static const double claim[][3] = {{0.5, 1.006, 1.016}, {1, 1.05, 1.11}, {2, 1.51, 1.88}};
    for (size_t i = 0; i < COUNT_OF(claim); i++) {
        const double eps = cor_sphere_eps_zero_overlap(claim[i][0]);
        check(fabs(cor_sphere_eps_published_pade(claim[i][0]) / eps - claim[i][1]) < 0.005, "published, %zu", i);
        check(fabs(cor_sphere_eps_simple(claim[i][0]) / eps - claim[i][2]) < 0.005, "simple, %zu", i);
    }
    check(fabs(cor_sphere_eps_published_pade(3) / cor_sphere_eps_zero_overlap(3) - 3.3) < 0.05, "beta = 3");
}
