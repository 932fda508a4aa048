/* SPDX-License-Identifier: MIT */
/* Hertz's dashpot of law.h without a reference: known values, the asymptote at the threshold, the inverse of the
 * function, order. Rows that join: test_row.c. Against enclosed collisions: tests/table/test_hertz_dashpot.c. */
#include "check.h"
#include "cor/law.h"

static double at(enum cor_end end, enum cor_quantity quantity, double x)
{
    return cor_law_value(COR_LAW_HERTZ_DASHPOT, end, quantity, x);
}

/* Integrations of another program, 18 digits */
TEST(test_known_values)
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
        {COR_END_ZERO_FORCE, COR_DAMPING_OF_LOSS, 0.463, 0.400583306380001424L}, /* of a rounded cube root */
        {COR_END_ZERO_OVERLAP, COR_EPS, 1, 0.041320343494337112L},
        {COR_END_ZERO_FORCE, COR_EPS, 1, 0.251843353467950750L},
        {COR_END_ZERO_FORCE, COR_EPS, 5, 0.015357698164110697L},
        {COR_END_ZERO_FORCE, COR_EPS, COR_HERTZ_DASHPOT_BETA_C, 0.218449655319366605L},
        {COR_END_ZERO_FORCE, COR_MAX_OVERLAP, COR_HERTZ_DASHPOT_BETA_C, 0.570733527712282338L},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        check(relative_error(at(known[i].end, known[i].quantity, known[i].beta), known[i].value) < 3e-16,
              "known value %zu", i);
}

/* Just below beta_c: eps = s d (1 + pi sqrt(s d/beta_c^5) + O(d ln d)), s = 0.206987698804278902 */
TEST(test_threshold)
{
    const double s = 0.206987698804278902, beta_c = COR_HERTZ_DASHPOT_BETA_C, pi = 3.141592653589793;
    for (int k = 16; k <= 30; k++) {
        const double d = ldexp(1, -k), first = s * d * (1 + pi * sqrt(s * d / pow(beta_c, 5)));
        const double eps = at(COR_END_ZERO_OVERLAP, COR_EPS, beta_c - d);
        check(fabs(eps / first - 1) < 20 * d * k + 1e-6, "d = 2^-%d: %.17g and %.17g", k, eps, first);
        /* beta t + ln(eps) -> 3.06410 */
        check(fabs(beta_c * at(COR_END_ZERO_OVERLAP, COR_DURATION, beta_c - d) + log(eps) - 3.06410) <
                  2 * sqrt(d) + 1e-5,
              "d = 2^-%d: duration %.17g", k, at(COR_END_ZERO_OVERLAP, COR_DURATION, beta_c - d));
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
            const double eps = at(COR_END_ZERO_OVERLAP, COR_EPS, beta);
            if (k != 0)
                check((eps > 0) == (k > 0) && (at(COR_END_ZERO_OVERLAP, COR_DURATION, beta) == INFINITY) == (k < 0),
                      "at g_c (1 + %d 1e-12): eps %g", k, eps);
            check(at(COR_END_ZERO_FORCE, COR_EPS, beta) > 0.2, "zero force parts at every speed");
        }
    }
    /* eps = 1e-6: beta_c - beta = d with s d (1 + pi sqrt(s d/beta_c^5)) = 1e-6 to a relative d ln(d) */
    const double d = COR_HERTZ_DASHPOT_BETA_C - at(COR_END_ZERO_OVERLAP, COR_DAMPING_OF_EPS, 1e-6),
                 x = 0.206987698804278902 * d;
    const double eps = x * (1 + 3.141592653589793 * sqrt(x / pow(COR_HERTZ_DASHPOT_BETA_C, 5)));
    check(fabs(eps / 1e-6 - 1) < 5e-5, "beta of 1e-6: %.9g", eps);
}

/* Zero force comes before zero overlap. */
TEST(test_ends)
{
    for (size_t i = 0; i < points(20000); i++) {
        const double beta = random_log(&draw, 1e-9, 1e9);
        check(at(COR_END_ZERO_FORCE, COR_EPS, beta) >= at(COR_END_ZERO_OVERLAP, COR_EPS, beta), "the ends at %.17g",
              beta);
        check(at(COR_END_ZERO_FORCE, COR_DURATION, beta) <= at(COR_END_ZERO_OVERLAP, COR_DURATION, beta),
              "the durations at %.17g", beta);
    }
}

/* The inverse has rows of its own: eps and loss come back as near as beta's last place lets them. */
TEST(test_round_trip)
{
    for (size_t i = 0; i < points(20000); i++)
        for (enum cor_end end = COR_END_ZERO_OVERLAP; end <= COR_END_ZERO_FORCE; end++) {
            const double given =
                end == COR_END_ZERO_OVERLAP ? random_log(&draw, 1e-9, 1) : random_log(&draw, 1e-200, 1);
            const double beta = at(end, COR_DAMPING_OF_EPS, given), back = at(end, COR_EPS, beta);
            const double slope = fabs((at(end, COR_EPS, beta * (1 - 0x1p-30)) / back - 1) * 0x1p30);
            check_near(back, given, (2 * slope + 2) * DBL_EPSILON);
            const double lost = random_log(&draw, 1e-300, 0.9);
            check_near(at(end, COR_LOSS, at(end, COR_DAMPING_OF_LOSS, lost)), lost, 4 * DBL_EPSILON);
        }
}

RUN_TESTS(test_known_values, test_threshold, test_ends, test_round_trip, test_slowest_speed)
