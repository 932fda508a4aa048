/* SPDX-License-Identifier: MIT */
/* hertz_dashpot.h without a reference: known values, the asymptote at the threshold, the inverse of the function,
 * order. Rows that join: test_row.c. Against enclosed collisions: tests/table/test_hertz_dashpot.c. */
#include "check.h"
#include "cor/hertz_dashpot.h"

typedef double dashpot_function(double x);

static dashpot_function *const eps[] = {cor_hertz_dashpot_eps_zero_overlap, cor_hertz_dashpot_eps_zero_force},
                               *const loss[] = {cor_hertz_dashpot_loss_zero_overlap, cor_hertz_dashpot_loss_zero_force},
                               *const beta_of_eps[] = {cor_hertz_dashpot_beta_zero_overlap,
                                                       cor_hertz_dashpot_beta_zero_force},
                               *const beta_of_loss[] = {cor_hertz_dashpot_beta_of_loss_zero_overlap,
                                                        cor_hertz_dashpot_beta_of_loss_zero_force},
                               *const duration[] = {cor_hertz_dashpot_duration_zero_overlap,
                                                    cor_hertz_dashpot_duration_zero_force};

/* Integrations of another program, 18 digits */
TEST(test_known_values)
{
    const struct {
        dashpot_function *function;
        double beta;
        long double value;
    } known[] = {
        {cor_hertz_dashpot_eps_zero_overlap, 0.5, 0.356912974176213893L},
        {cor_hertz_dashpot_eps_zero_force, 0.5, 0.468038544824803370L},
        {cor_hertz_dashpot_duration_zero_overlap, 0.5, 3.674312264397680617L},
        {cor_hertz_dashpot_duration_zero_force, 0.5, 2.782528143330340519L},
        {cor_hertz_dashpot_max_overlap, 0.5, 0.791261564952323956L},
        {cor_hertz_dashpot_eps_approach_only, 0.5, 0.667490488913183823L},
        {cor_hertz_dashpot_beta_approach_only, 0.667490488913183823, 0.5},
        {cor_hertz_dashpot_beta_of_loss_zero_force, 0.463, 0.400583306380001424L}, /* of a rounded cube root */
        {cor_hertz_dashpot_eps_zero_overlap, 1, 0.041320343494337112L},
        {cor_hertz_dashpot_eps_zero_force, 1, 0.251843353467950750L},
        {cor_hertz_dashpot_eps_zero_force, 5, 0.015357698164110697L},
        {cor_hertz_dashpot_eps_zero_force, COR_HERTZ_DASHPOT_BETA_C, 0.218449655319366605L},
        {cor_hertz_dashpot_max_overlap, COR_HERTZ_DASHPOT_BETA_C, 0.570733527712282338L},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        check(relative_error(known[i].function(known[i].beta), known[i].value) < 3e-16, "known value %zu", i);
}

/* Just below beta_c: eps = s d (1 + pi sqrt(s d/beta_c^5) + O(d ln d)), s = 0.206987698804278902 */
TEST(test_threshold)
{
    const double s = 0.206987698804278902, beta_c = COR_HERTZ_DASHPOT_BETA_C, pi = 3.141592653589793;
    for (int k = 16; k <= 30; k++) {
        const double d = ldexp(1, -k), first = s * d * (1 + pi * sqrt(s * d / pow(beta_c, 5)));
        const double eps = cor_hertz_dashpot_eps_zero_overlap(beta_c - d);
        check(fabs(eps / first - 1) < 20 * d * k + 1e-6, "d = 2^-%d: %.17g and %.17g", k, eps, first);
        /* beta t + ln(eps) -> 3.06410 */
        check(fabs(beta_c * cor_hertz_dashpot_duration_zero_overlap(beta_c - d) + log(eps) - 3.06410) <
                  2 * sqrt(d) + 1e-5,
              "d = 2^-%d: duration %.17g", k, cor_hertz_dashpot_duration_zero_overlap(beta_c - d));
    }
}

/* Impacts at and around the slowest speed that parts, g_c = C^5/(beta_c^5 m^3 K^2), in SI units */
TEST(test_slowest_speed)
{
    static const double scene[][3] = {{0.01, 3e6, 2.5}, {1e-9, 40, 1e-7}, {7, 1e9, 4e4}}; /* m, K, C */
    for (size_t i = 0; i < sizeof scene / sizeof *scene; i++) {
        const double m = scene[i][0], K = scene[i][1], C = scene[i][2];
        const double slowest = pow(C / COR_HERTZ_DASHPOT_BETA_C, 5) / (m * m * m * K * K);
        for (int k = -3; k <= 3; k++) {
            const double g = slowest * (1 + k * 1e-12);
            const double beta = C * pow(m, -0.6) * pow(K, -0.4) * pow(g, -0.2);
            const double eps = cor_hertz_dashpot_eps_zero_overlap(beta);
            if (k != 0)
                check((eps > 0) == (k > 0) && (cor_hertz_dashpot_duration_zero_overlap(beta) == INFINITY) == (k < 0),
                      "at g_c (1 + %d 1e-12): eps %g", k, eps);
            check(cor_hertz_dashpot_eps_zero_force(beta) > 0.2, "zero force parts at every speed");
        }
    }
    /* eps = 1e-6: beta_c - beta = d with s d (1 + pi sqrt(s d/beta_c^5)) = 1e-6 to a relative d ln(d) */
    const double d = COR_HERTZ_DASHPOT_BETA_C - cor_hertz_dashpot_beta_zero_overlap(1e-6), x = 0.206987698804278902 * d;
    const double eps = x * (1 + 3.141592653589793 * sqrt(x / pow(COR_HERTZ_DASHPOT_BETA_C, 5)));
    check(fabs(eps / 1e-6 - 1) < 5e-5, "beta of 1e-6: %.9g", eps);
}

/* Zero force comes before zero overlap. */
TEST(test_ends)
{
    for (size_t i = 0; i < points(20000); i++) {
        const double beta = random_log(&draw, 1e-9, 1e9);
        check(eps[1](beta) >= eps[0](beta), "the ends at %.17g", beta);
        check(duration[1](beta) <= duration[0](beta), "the durations at %.17g", beta);
    }
}

/* The inverse has rows of its own: eps and loss come back as near as beta's last place lets them. */
TEST(test_round_trip)
{
    for (size_t i = 0; i < points(20000); i++)
        for (int end = 0; end < 2; end++) {
            const double given = end == 0 ? random_log(&draw, 1e-9, 1) : random_log(&draw, 1e-200, 1);
            const double beta = beta_of_eps[end](given), back = eps[end](beta);
            const double slope = fabs((eps[end](beta * (1 - 0x1p-30)) / back - 1) * 0x1p30);
            check_near(back, given, (2 * slope + 2) * DBL_EPSILON);
            const double lost = random_log(&draw, 1e-300, 0.9);
            check_near(loss[end](beta_of_loss[end](lost)), lost, 4 * DBL_EPSILON);
        }
}

RUN_TESTS(test_known_values, test_threshold, test_ends, test_round_trip, test_slowest_speed)
