/* SPDX-License-Identifier: MIT */
#include "check.h"

#include <cor/cor.h>

#include "reference_ode.h"
#include "sphere_pade.h"

typedef double sphere_function(double);

static sphere_function *const eps_function[2] = {cor_sphere_eps_zero_overlap, cor_sphere_eps_zero_force};
static sphere_function *const loss_function[2] = {cor_sphere_loss_zero_overlap, cor_sphere_loss_zero_force};
static const char *const end_name[2] = {"zero overlap", "zero force"};

/* C_1 by (30), in long double from libm's Gamma: not the library's digits */
static long double c1_exact(void)
{
    return -sqrtl(acosl(-1)) * tgammal(0.6L) / (powl(2, 0.2L) * powl(5, 0.4L) * tgammal(2.1L));
}

/* Known to 18 digits from two independent routes. */
static void known_answers(void **state)
{
    (void)state;
    static const struct {
        double beta;
        long double eps[2]; /* 0: not tabulated */
    } known[] = {
        {0.1, {0.892147587290229345L, 0}},
        {0.5, {0.573824628664948983L, 0.595251501135126961L}},
        {1, {0.331164810466640935L, 0.393930603229873193L}},
        {2, {0.095330365354151543L, 0.211646054603642811L}},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        for (int end = 0; end < 2; end++) {
            /* 0.1 is not a double: its rounding moves eps by less than the bound */
            const long double exact = known[i].eps[end];
            if (exact == 0)
                continue;
            const double beta = known[i].beta, eps = eps_function[end](beta);
            check(relative_error(eps, exact) <= COR_SPHERE_EPS_MAX_REL, "%s, beta = %g: %a", end_name[end], beta, eps);
            const double loss = loss_function[end](beta);
            check(relative_error(loss, 1 - exact) <= COR_SPHERE_LOSS_MAX_REL, "%s, beta = %g: %a", end_name[end], beta,
                  loss);
        }
}

/* The reference itself, so that a failure of the next test points at the right side. */
static void reference_is_right(void **state)
{
    (void)state;
    const long double tolerance = 1e-15L;
    const struct reference half = reference_collision(0.5L), five = reference_collision(5);
    check(fabsl(half.eps_zero_overlap - 0.573824628664948983L) < tolerance, "beta = 1/2");
    check(fabsl(half.eps_zero_force - 0.595251501135126961L) < tolerance, "beta = 1/2");
    check(fabsl(five.eps_zero_overlap - 0.001650682071773317L) < tolerance, "beta = 5");
    check(reference_collision(0).loss_zero_force == 0, "beta = 0");
}

static void against_the_equation_of_motion(void **state)
{
    (void)state;
    struct random_state random = random_start();
    long double worst[4] = {0};
    double where[4] = {0};
    const size_t n = points(4000);
    for (size_t i = 0; i < n; i++) {
        /* half of the points crowd towards 0 */
        const double beta =
            i % 2 ? random_uniform(&random, 0, COR_SPHERE_BETA_MAX) : random_log(&random, 1e-4, COR_SPHERE_BETA_MAX);
        const struct reference r = reference_collision(beta);
        const long double error[4] = {relative_error(cor_sphere_eps_zero_overlap(beta), r.eps_zero_overlap),
                                      relative_error(cor_sphere_eps_zero_force(beta), r.eps_zero_force),
                                      relative_error(cor_sphere_loss_zero_overlap(beta), r.loss_zero_overlap),
                                      relative_error(cor_sphere_loss_zero_force(beta), r.loss_zero_force)};
        for (int k = 0; k < 4; k++)
            if (error[k] > worst[k]) {
                worst[k] = error[k];
                where[k] = beta;
            }
    }
    for (int k = 0; k < 4; k++) {
        print_message("%s, %s: worst relative error %.2Lg at beta = %a of %zu points\n", k < 2 ? "eps" : "loss",
                      end_name[k % 2], worst[k], where[k], n);
        check(worst[k] <= (k < 2 ? COR_SPHERE_EPS_MAX_REL : COR_SPHERE_LOSS_MAX_REL), "%Lg at beta = %a", worst[k],
              where[k]);
    }
}

/* 1 - eps = -C_1 beta - C_2 beta^2 - ..., where subtracting eps from 1 would leave nothing. Zero
 * force adds (4/15) beta^(5/2). */
static void loss_of_tiny_beta(void **state)
{
    (void)state;
    const long double c1 = c1_exact(), c2 = 0.6L * c1 * c1, c3 = -0.52288256809L;
    const long double c4 = 0.34874267526L;
    const double smallest = 4.9406564584124654e-324;
    for (int end = 0; end < 2; end++) {
        for (double beta = 1e-4; beta >= 1e-300; beta *= 0.37) {
            long double loss = -(long double)beta * (c1 + beta * (c2 + beta * (c3 + beta * c4)));
            if (end == 1) {
                const long double root = sqrtl(beta);
                /* powers 5 and 7 of sqrt(beta); 6 and 8 are c3 and c4 */
                loss -= beta * beta * root * (4.0L / 15 - 0.46137954324L * beta);
            }
            check(relative_error(loss_function[end](beta), loss) <= COR_SPHERE_LOSS_MAX_REL, "%s, beta = %a: %a",
                  end_name[end], beta, loss_function[end](beta));
        }
        /* subnormal: the nearest multiple of the smallest number, or a neighbour */
        for (int k = 1; k < 2000; k++) {
            const double beta = k * smallest;
            const long double loss = -c1 * beta;
            check(fabsl(loss_function[end](beta) - loss) <= 0.5L * smallest + loss * COR_SPHERE_LOSS_MAX_REL,
                  "%s, beta = %a", end_name[end], beta);
        }
    }
}

static void loss_and_eps_add_up(void **state)
{
    (void)state;
    struct random_state random = random_start();
    for (size_t i = 0; i < points(20000); i++) {
        const double beta = random_uniform(&random, 0, COR_SPHERE_BETA_MAX);
        for (int end = 0; end < 2; end++) {
            /* same table: only rounding is left, each side a few dozen half units at the worst */
            const double sum = eps_function[end](beta) + loss_function[end](beta);
            check(fabs(sum - 1) <= 16 * DBL_EPSILON, "%s, beta = %a: 1 + %g", end_name[end], beta, sum - 1);
        }
    }
}

static void special_values(void **state)
{
    (void)state;
    const double beyond = nextafter(COR_SPHERE_BETA_MAX, INFINITY);
    const double outside[] = {beyond, INFINITY, -INFINITY, NAN, -1, -4.9406564584124654e-324, 2.5, DBL_MAX};
    for (int end = 0; end < 2; end++) {
        assert_true(eps_function[end](0.0) == 1);
        assert_true(eps_function[end](-0.0) == 1);
        assert_true(loss_function[end](0.0) == 0);
        assert_true(loss_function[end](-0.0) == 0);
        for (size_t i = 0; i < sizeof outside / sizeof *outside; i++) {
            check(isnan(eps_function[end](outside[i])), "eps, %s, %a", end_name[end], outside[i]);
            check(isnan(loss_function[end](outside[i])), "loss, %s, %a", end_name[end], outside[i]);
        }
    }
}

/* One unit to each side of where the domain and the formats end. */
static void edges(void **state)
{
    (void)state;
    assert_true(COR_SPHERE_PADE_BETA_MAX == COR_SPHERE_BETA_MAX);
    /* what the tables state of themselves keeps the public promise */
    assert_true(COR_SPHERE_PADE_ZERO_OVERLAP_EPS_MAX_REL <= COR_SPHERE_EPS_MAX_REL);
    assert_true(COR_SPHERE_PADE_ZERO_OVERLAP_LOSS_MAX_REL <= COR_SPHERE_LOSS_MAX_REL);
    assert_true(COR_SPHERE_PADE_ZERO_FORCE_EPS_MAX_REL <= COR_SPHERE_EPS_MAX_REL);
    assert_true(COR_SPHERE_PADE_ZERO_FORCE_LOSS_MAX_REL <= COR_SPHERE_LOSS_MAX_REL);
    const double last = COR_SPHERE_BETA_MAX, before = nextafter(last, 0);
    const struct reference r[2] = {reference_collision(last), reference_collision(before)};
    for (int i = 0; i < 2; i++) {
        const double beta = i ? before : last;
        const long double exact[2] = {r[i].eps_zero_overlap, r[i].eps_zero_force};
        for (int end = 0; end < 2; end++)
            check(relative_error(eps_function[end](beta), exact[end]) <= COR_SPHERE_EPS_MAX_REL, "%s, %a",
                  end_name[end], beta);
    }
    const double small[] = {4.9406564584124654e-324, DBL_MIN, nextafter(DBL_MIN, 0), 0x1p-1000};
    for (int end = 0; end < 2; end++)
        for (size_t i = 0; i < sizeof small / sizeof *small; i++)
            check(eps_function[end](small[i]) == 1, "%s, %a", end_name[end], small[i]);
}

static void falls_and_keeps_order(void **state)
{
    (void)state;
    const int n = 20000;
    double eps[2] = {1, 1}, loss[2] = {0, 0};
    for (int i = 1; i <= n; i++) {
        const double beta = COR_SPHERE_BETA_MAX * i / n;
        for (int end = 0; end < 2; end++) {
            const double e = eps_function[end](beta), l = loss_function[end](beta);
            check(e < eps[end] && e > 0, "eps, %s, beta = %a", end_name[end], beta);
            check(l > loss[end] && l < 1, "loss, %s, beta = %a", end_name[end], beta);
            eps[end] = e;
            loss[end] = l;
        }
        /* they differ by (4/15) beta^(5/2), which is 8e-12 at the first point */
        check(eps[1] > eps[0], "beta = %a", beta);
    }
}

static void array_is_scalar(void **state)
{
    (void)state;
    enum { COUNT = 1003 };
    static double beta[COUNT], eps[COUNT + 1];
    struct random_state random = random_start();
    for (int i = 0; i < COUNT; i++)
        beta[i] = random_uniform(&random, -0.1, COR_SPHERE_BETA_MAX + 0.1);
    beta[0] = 0;
    beta[1] = -0.0;
    beta[2] = NAN;
    beta[3] = INFINITY;
    beta[4] = COR_SPHERE_BETA_MAX;
    beta[5] = 4.9406564584124654e-324;
    void (*const array[2])(const double *, double *, size_t) = {cor_sphere_eps_zero_overlap_array,
                                                                cor_sphere_eps_zero_force_array};
    for (int end = 0; end < 2; end++) {
        array[end](NULL, NULL, 0);
        for (size_t n = 0; n <= COUNT; n = n < 20 ? n + 1 : n + 983) {
            for (size_t i = 0; i <= COUNT; i++)
                eps[i] = 7;
            array[end](beta, eps, n);
            for (size_t i = 0; i < n; i++) {
                const double one = eps_function[end](beta[i]);
                check(same_bits(eps[i], one) || (isnan(eps[i]) && isnan(one)), "%s, %a", end_name[end], beta[i]);
            }
            check(eps[n] == 7, "%s: wrote past %zu elements", end_name[end], n);
        }
        memcpy(eps, beta, sizeof beta);
        array[end](eps, eps, COUNT);
        for (size_t i = 0; i < COUNT; i++) {
            const double one = eps_function[end](beta[i]);
            check(same_bits(eps[i], one) || (isnan(eps[i]) && isnan(one)), "in place: %a", beta[i]);
        }
    }
}

static void constants(void **state)
{
    (void)state;
    const long double c1 = c1_exact();
    const long double d = sqrtl(acosl(-1)) * tgammal(0.6L) / (5 * tgammal(2.1L));
    check(ulp_error(COR_SPHERE_C1, c1) <= 0.5L + 1e-3L, "C_1 = %.20Lg", c1);
    check(ulp_error(COR_SPHERE_SIMPLE_D, d) <= 0.5L + 1e-3L, "d = %.20Lg", d);
    /* 2 delta d = |C_1| beta with (14) */
    check(fabsl(2 * powl(1.25L, 0.6L) * d + c1) < 1e-17L, "2 (5/4)^(3/5) d = |C_1|");
}

/* The root of (27) in long double by bisection in ln eps. */
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

static void simple_theory(void **state)
{
    (void)state;
    const long double c1 = -c1_exact();
    struct random_state random = random_start();
    long double worst[3] = {0};
    for (size_t i = 0; i < points(2000); i++) {
        const double beta = i % 2 ? random_uniform(&random, 0, 20) : random_log(&random, 1e-20, 1e150);
        const long double c = c1 * beta;
        const long double exact = simple_exact(c);
        /* bisection in the logarithm loses |ln eps| 1e-19: below a tenth of a unit */
        worst[0] = fmaxl(worst[0], ulp_error(cor_sphere_eps_simple(beta), exact));
        const int depth = (int)(i % 7);
        long double t = 1;
        for (int k = 0; k < depth; k++)
            t = 1 + c * powl(t, 0.4L);
        worst[1] = fmaxl(worst[1], ulp_error(cor_sphere_eps_simple_fraction(beta, depth), 1 / t));
        const long double s = c, published = (1 + 2.5839L * s) /
                                             (1 + s * (3.5839L + s * (2.9839L + s * (1.1487L + s * 0.3265L))));
        worst[2] = fmaxl(worst[2], ulp_error(cor_sphere_eps_published_pade(beta), published));
    }
    print_message("simple %.2Lf, fraction %.2Lf, published %.2Lf ulp at the worst\n", worst[0], worst[1], worst[2]);
    for (int k = 0; k < 3; k++)
        check(worst[k] <= COR_SPHERE_EPS_SIMPLE_MAX_ULP, "%d: %Lg ulp", k, worst[k]);
}

static void simple_theory_special_values(void **state)
{
    (void)state;
    const double bad[] = {-1, -4.9406564584124654e-324, -INFINITY, NAN};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_true(isnan(cor_sphere_eps_simple(bad[i])));
        assert_true(isnan(cor_sphere_eps_simple_fraction(bad[i], 3)));
        assert_true(isnan(cor_sphere_eps_published_pade(bad[i])));
    }
    const double zero[] = {0.0, -0.0};
    for (int i = 0; i < 2; i++) {
        assert_true(cor_sphere_eps_simple(zero[i]) == 1);
        assert_true(cor_sphere_eps_simple_fraction(zero[i], 5) == 1);
        assert_true(cor_sphere_eps_published_pade(zero[i]) == 1);
    }
    const double large[] = {INFINITY, DBL_MAX};
    for (int i = 0; i < 2; i++) {
        assert_true(cor_sphere_eps_simple(large[i]) == 0);
        assert_true(cor_sphere_eps_simple_fraction(large[i], 0) == 1);
        assert_true(cor_sphere_eps_simple_fraction(large[i], 4) == 0);
        assert_true(cor_sphere_eps_published_pade(large[i]) == 0);
    }
    assert_true(cor_sphere_eps_simple_fraction(1, 0) == 1);
    assert_true(isnan(cor_sphere_eps_simple_fraction(1, -1)));
    /* the limit of (28) is the root of (27), from above */
    assert_true(relative_error(cor_sphere_eps_simple_fraction(1, 200), cor_sphere_eps_simple(1)) < 8 * DBL_EPSILON);
    for (int depth = 0; depth < 20; depth++)
        assert_true(cor_sphere_eps_simple_fraction(1.5, depth) > cor_sphere_eps_simple_fraction(1.5, depth + 1));
    assert_true(cor_sphere_eps_simple_fraction(1, 2147483647) > 0.36);
}

/* How wrong the approximations of 1999 are is documented: sphere.h says these numbers. */
static void documented_errors_of_1999(void **state)
{
    (void)state;
    static const struct {
        double beta, published, simple;
    } claim[] = {{0.5, 1.006, 1.016}, {1, 1.05, 1.11}, {2, 1.51, 1.88}};
    for (size_t i = 0; i < sizeof claim / sizeof *claim; i++) {
        const double eps = cor_sphere_eps_zero_overlap(claim[i].beta);
        const double published = cor_sphere_eps_published_pade(claim[i].beta) / eps;
        const double simple = cor_sphere_eps_simple(claim[i].beta) / eps;
        check(fabs(published - claim[i].published) < 0.005, "%g", published);
        check(fabs(simple - claim[i].simple) < 0.005, "%g", simple);
    }
    const struct reference three = reference_collision(3);
    check(fabsl(cor_sphere_eps_published_pade(3) / three.eps_zero_overlap - 3.3L) < 0.05L, "beta = 3");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_answers),
        cmocka_unit_test(reference_is_right),
        cmocka_unit_test(against_the_equation_of_motion),
        cmocka_unit_test(loss_of_tiny_beta),
        cmocka_unit_test(loss_and_eps_add_up),
        cmocka_unit_test(special_values),
        cmocka_unit_test(edges),
        cmocka_unit_test(falls_and_keeps_order),
        cmocka_unit_test(array_is_scalar),
        cmocka_unit_test(constants),
        cmocka_unit_test(simple_theory),
        cmocka_unit_test(simple_theory_special_values),
        cmocka_unit_test(documented_errors_of_1999),
    };
    return cmocka_run_group_tests_name("sphere", tests, NULL, NULL);
}
