/* SPDX-License-Identifier: MIT */
/* Collisions under a constant force: a Runge-Kutta method in long doubles, limits and thresholds */
#include "check.h"

#include "cor/scene.h"
#include "cor/status.h"

/* x'' + beta x^b x' + x^a = f with x = w^d, dt = d w^(d-1) ds, by the classical method with steps of 1/4000 */
struct reference {
    long double eps[COR_SCENE_ENDS], duration[COR_SCENE_ENDS], max_overlap, force_max; /* the last of the steps */
};

static long double power(long double x, int n)
{
    long double y = 1;
    for (int i = 0; i < n; i++)
        y *= x;
    return y;
}

static long double force(const struct cor_exponents *law, long double beta, const long double y[3])
{
    return power(y[0], law->elastic) + beta * power(y[0], law->damping) * y[1];
}

static void slopes(long double slope[3], const struct cor_exponents *law, long double beta, long double f,
                   const long double y[3])
{
    const long double rate = law->denominator * power(y[0], law->denominator - 1);
    slope[0] = y[1];
    slope[1] = rate * (f - force(law, beta, y));
    slope[2] = rate;
}

static void step(long double next[3], const struct cor_exponents *law, long double beta, long double f,
                 const long double y[3], long double h)
{
    long double k[4][3], at[3];
    for (int i = 0; i < 4; i++) {
        for (int c = 0; c < 3; c++)
            at[c] = i == 0 ? y[c] : y[c] + (i == 3 ? h : h / 2) * k[i - 1][c];
        slopes(k[i], law, beta, f, at);
    }
    for (int c = 0; c < 3; c++)
        next[c] = y[c] + h / 6 * (k[0][c] + 2 * k[1][c] + 2 * k[2][c] + k[3][c]);
}

/* The place between y and the end of a step of h at which a function falls to zero: 0 velocity, 1 overlap, 2 force */
static void event(long double at[3], const struct cor_exponents *law, long double beta, long double f,
                  const long double y[3], long double h, int which)
{
    long double low = 0, high = h;
    for (int i = 0; i < 60; i++) {
        const long double middle = (low + high) / 2;
        step(at, law, beta, f, y, middle);
        const long double value = which == 0 ? at[1] : which == 1 ? at[0] : force(law, beta, at);
        *(value > 0 ? &low : &high) = middle;
    }
}

/* Bodies that have turned twice stay together. */
static struct reference reference(const struct cor_exponents *law, double beta, double f)
{
    const long double h = 1.0L / 4000;
    struct reference r = {{0, 0}, {HUGE_VALL, HUGE_VALL}, 0, 0};
    long double y[3] = {0, 1, 0}, next[3], at[3];
    for (int k = 0; k < 1000000; k++, memcpy(y, next, sizeof y)) {
        step(next, law, beta, f, y, h);
        r.force_max = fmaxl(r.force_max, force(law, beta, y));
        if (y[1] > 0 && next[1] <= 0) {
            if (r.max_overlap > 0)
                return r;
            event(at, law, beta, f, y, h, 0);
            r.max_overlap = power(at[0], law->denominator);
        }
        if (k > 0 && !(r.eps[1] > 0) && force(law, beta, y) > 0 && force(law, beta, next) <= 0) {
            event(at, law, beta, f, y, h, 2);
            r.eps[1] = -at[1];
            r.duration[1] = at[2];
        }
        if (k > 0 && next[0] <= 0) {
            event(at, law, beta, f, y, h, 1);
            r.eps[0] = -at[1];
            r.duration[0] = at[2];
            return r;
        }
    }
    return r;
}

/* A contact whose impacts at 1 m/s are those of beta and f */
static struct cor_scene_contact contact_of(const struct cor_exponents *law, double beta, double f)
{
    struct cor_scene_contact c = {.law = *law, .mass_kg = 1, .stiffness = 1, .radius_m = 1, .force_n = f};
    cor_scene_set_damping(&c, COR_SCENE_DAMPING_COEFFICIENT, beta, 1, 0);
    return c;
}

static void close_to(const char *what, double computed, double expected, double error)
{
    check(fabs(computed - expected) <= error * fabs(expected), "%s: %.15g, not %.15g", what, computed, expected);
}

TEST(impacts)
{
    static const int laws[] = {COR_LAW_VISCOELASTIC, COR_LAW_LINEAR, COR_LAW_TSUJI, COR_LAW_HUNT_CROSSLEY,
                               COR_LAW_HERTZ_DASHPOT};
    static const double betas[] = {0.05, 0.3, 0.9, 2}, forces[] = {1e-3, 0.05, 0.2, 0.7, 2};
    int stuck = 0;
    for (size_t l = 0; l < sizeof laws / sizeof *laws; l++)
        for (size_t i = 0; i < sizeof betas / sizeof *betas; i++)
            for (size_t k = 0; k < sizeof forces / sizeof *forces; k++) {
                if (!in_turn(l + i + k, 3))
                    continue;
                const struct cor_exponents *const law = &cor_law_exponents[laws[l]];
                const struct reference r = reference(law, betas[i], forces[k]);
                const struct cor_scene_contact c = contact_of(law, betas[i], forces[k]);
                struct cor_scene_impact impact;
                assert_int_equal(cor_scene_impact(&impact, &c, 1), COR_OK);
                /* a motion that never turns creeps up to its rest */
                close_to(cor_law_names[laws[l]], impact.max_overlap_m,
                         r.max_overlap > 0 ? (double)r.max_overlap
                                           : pow(forces[k], (double)law->denominator / law->elastic), /* x^a = f */
                         1e-11);
                close_to("largest force", cor_scene_force_max_n(&c, 1), (double)r.force_max, 1e-6);
                for (int end = 0; end < COR_SCENE_ENDS; end++) {
                    const int at = cor_scene_ends_differ(&c) ? end : 0;
                    double eps;
                    cor_scene_eps(&eps, &c, 1, end);
                    assert_true(eps == impact.eps[end]);
                    stuck += eps == 0;
                    close_to(cor_law_names[laws[l]], impact.eps[end] * impact.eps[end], (double)(r.eps[at] * r.eps[at]),
                             1e-10);
                    if (eps > 0)
                        close_to("duration", impact.duration_s[end], (double)r.duration[at], 1e-9);
                    else
                        assert_true(isinf(impact.duration_s[end]));
                }
            }
    assert_in_range(stuck, 10, 100);
}

/* eps on both sides of the sticking speed, which another integration finds, backwards in time */
TEST(sticking)
{
    const struct cor_scene_contact strong = contact_of(&cor_law_exponents[COR_LAW_LINEAR], 1.975, 1);
    check(cor_scene_sticking_speed(&strong, 0) > 1e8 && cor_scene_sticking_speed(&strong, 0) < 1e9, "%g",
          cor_scene_sticking_speed(&strong, 0)); /* below the end of the search, scene.h */
    static const int laws[] = {COR_LAW_VISCOELASTIC, COR_LAW_LINEAR, COR_LAW_TSUJI, COR_LAW_HUNT_CROSSLEY,
                               COR_LAW_HERTZ_DASHPOT};
    for (size_t l = 0; l < sizeof laws / sizeof *laws; l++)
        for (double beta = 0.01; beta < 1; beta *= 3)
            for (int end = 0; end < COR_SCENE_ENDS; end++) {
                const struct cor_scene_contact c = contact_of(&cor_law_exponents[laws[l]], beta, 0.3);
                const double speed = cor_scene_sticking_speed(&c, end);
                double below, above;
                assert_true(speed > 0 && isfinite(speed));
                assert_int_equal(cor_scene_eps(&below, &c, speed * (1 - 1e-9), end), COR_OK);
                assert_int_equal(cor_scene_eps(&above, &c, speed * (1 + 1e-9), end), COR_OK);
                check(below == 0 && above > 0, "%s, beta %g, end %d: %g %g", cor_law_names[laws[l]], beta, end, below,
                      above);
            }
    /* strong damping keeps the bodies together at every speed */
    const struct cor_scene_contact sphere = contact_of(&cor_law_exponents[COR_LAW_VISCOELASTIC], 5, 1);
    assert_true(isinf(cor_scene_sticking_speed(&sphere, COR_END_ZERO_OVERLAP)));
    assert_true(isfinite(cor_scene_sticking_speed(&sphere, COR_END_ZERO_FORCE)));
}

TEST(limits)
{
    /* a sphere that creeps up to its rest has stopped before the constant force matters */
    const struct cor_scene_contact creeping = contact_of(&cor_law_exponents[COR_LAW_VISCOELASTIC], 1e3, 0.1);
    close_to("creeping", cor_scene_force_max_n(&creeping, 1),
             cor_law_force_max(&cor_law_exponents[COR_LAW_VISCOELASTIC], 1e3), 1e-2);
    /* damping nearly strong enough that the body never turns */
    static const struct {
        int law;
        double beta, force;
    } turns[] = {{COR_LAW_TSUJI, 2.31727, 7.19012}, {COR_LAW_HERTZ_DASHPOT, 3.06276, 0.203421}};
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
        const struct cor_exponents *const law = &cor_law_exponents[turns[i].law];
        const struct cor_scene_contact c = contact_of(law, turns[i].beta, turns[i].force);
        struct cor_scene_impact impact;
        assert_int_equal(cor_scene_impact(&impact, &c, 1), COR_OK);
        close_to("turns", impact.max_overlap_m, (double)reference(law, turns[i].beta, turns[i].force).max_overlap,
                 COR_SCENE_PRESSED_ERROR);
    }
    for (int law = 0; law < COR_LAW_PLATE; law++) {
        /* without damping nothing is lost */
        struct cor_scene_contact c = contact_of(&cor_law_exponents[law], 0, 0.7);
        struct cor_scene_impact impact;
        assert_int_equal(cor_scene_impact(&impact, &c, 1), COR_OK);
        close_to("elastic", impact.eps[0], 1, 1e-14);
        close_to("elastic", impact.eps[1], 1, 1e-14);
        assert_true(cor_scene_sticking_speed(&c, 0) == 0);
        /* a small force changes little, in proportion */
        c = contact_of(&cor_law_exponents[law], 0.5, 0);
        struct cor_scene_contact pressed = c;
        double eps[3];
        cor_scene_eps(&eps[0], &c, 1, 0);
        pressed.force_n = 1e-7;
        cor_scene_eps(&eps[1], &pressed, 1, 0);
        pressed.force_n = 2e-7;
        cor_scene_eps(&eps[2], &pressed, 1, 0);
        check(fabs((eps[2] - eps[0]) / (eps[1] - eps[0]) - 2) < 1e-4 && eps[1] < eps[0], "%g %g", eps[1] - eps[0],
              eps[2] - eps[0]);
        /* a restitution that was measured under the force */
        pressed.force_n = 0.02;
        for (int end = 0; end < COR_SCENE_ENDS; end++) {
            assert_int_equal(cor_scene_set_damping(&pressed, COR_SCENE_RESTITUTION, 0.8, 0.5, end), COR_OK);
            cor_scene_eps(&eps[0], &pressed, 0.5, end);
            close_to("restitution", eps[0], 0.8, 1e-12);
        }
    }
}

RUN_TESTS(impacts, sticking, limits)
