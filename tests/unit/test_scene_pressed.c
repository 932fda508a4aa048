/* SPDX-License-Identifier: MIT */
/* Tests collisions under a constant force by integration, by limits and by thresholds. */
#include "../reference/ode.h"
#include "scene.h"

/* x'' + beta x^b x' + x^a = f */
struct pressed {
    const struct cor_exponents *law;
    double beta;
};

static long double pressed_force(long double w, long double v, const void *of)
{
    const struct pressed *const p = of;
    return motion_power(w, p->law->elastic) + p->beta * motion_power(w, p->law->damping) * v;
}

static struct motion_course reference(const struct cor_exponents *law, double beta, double f)
{
    const struct pressed p = {law, beta};
    return motion_course(&(struct motion){law->denominator, f, pressed_force, &p, 0, 0});
}

TEST(impacts)
{
    static const double betas[] = {0.05, 0.3, 0.9, 2}, forces[] = {1e-3, 0.05, 0.2, 0.7, 2};
    int stuck = 0;
    for (size_t l = 0; l < SCENE_LAWS; l++)
        for (size_t i = 0; i < sizeof betas / sizeof *betas; i++)
            for (size_t k = 0; k < sizeof forces / sizeof *forces; k++) {
                if (!in_turn(l + i + k, 3))
                    continue;
                const struct cor_exponents *const law = &cor_law_exponents[l];
                const struct motion_course r = reference(law, betas[i], forces[k]);
                const struct cor_scene_contact c = scaled_contact(law, betas[i], forces[k]);
                const struct cor_scene_impact impact = scene_impact(&c, 1);
                /* a motion that never turns creeps up to its place of rest */
                const double rest = pow(forces[k], (double)law->denominator / law->elastic); /* x^a = f */
                check_near(impact.max_overlap_m, r.max_overlap > 0 ? r.max_overlap : rest, 1e-11);
                check_near(cor_scene_force_max_n(&c, 1), r.force_max, 1e-6);
                for (int end = 0; end < COR_SCENE_ENDS; end++) {
                    const double eps = scene_eps(&c, 1, end);
                    assert_true(eps == impact.eps[end]);
                    stuck += eps == 0;
                    check_near(impact.eps[end] * impact.eps[end], r.eps[end] * r.eps[end], 1e-10);
                    if (eps > 0)
                        check_near(impact.duration_s[end], r.duration[end], 1e-9);
                    else
                        assert_true(isinf(impact.duration_s[end]));
                }
            }
    assert_in_range(stuck, 10, 100);
}

/* eps is 0 below and positive above the sticking speed, which another integration finds backward in time. */
TEST(sticking)
{
    const struct cor_scene_contact strong = scaled_contact(&cor_law_exponents[COR_LAW_LINEAR], 1.975, 1);
    check(cor_scene_sticking_speed(&strong, 0) > 1e8 && cor_scene_sticking_speed(&strong, 0) < 1e9, "%g",
          cor_scene_sticking_speed(&strong, 0)); /* a large sticking speed, still found by the search */
    for (size_t l = 0; l < SCENE_LAWS; l++)
        for (double beta = 0.01; beta < 1; beta *= 3)
            for (int end = 0; end < COR_SCENE_ENDS; end++) {
                const struct cor_scene_contact c = scaled_contact(&cor_law_exponents[l], beta, 0.3);
                const double speed = cor_scene_sticking_speed(&c, end);
                assert_true(speed > 0 && isfinite(speed));
                check(scene_eps(&c, speed * (1 - 1e-9), end) == 0 && scene_eps(&c, speed * (1 + 1e-9), end) > 0,
                      "%s, beta %g, end %d", cor_law_name((enum cor_law)l), beta, end);
            }
    /* strong damping keeps the bodies together at every speed */
    const struct cor_scene_contact sphere = scaled_contact(&cor_law_exponents[COR_LAW_VISCOELASTIC], 5, 1);
    assert_true(isinf(cor_scene_sticking_speed(&sphere, COR_END_ZERO_OVERLAP)));
    assert_true(isfinite(cor_scene_sticking_speed(&sphere, COR_END_ZERO_FORCE)));
}

TEST(limits)
{
    /* a strongly damped sphere stops before the constant force matters, and then creeps to its place of rest */
    const struct cor_scene_contact creeping = scaled_contact(&cor_law_exponents[COR_LAW_VISCOELASTIC], 1e3, 0.1);
    check_near(cor_scene_force_max_n(&creeping, 1), cor_law_force_max(&cor_law_exponents[COR_LAW_VISCOELASTIC], 1e3),
               1e-2);
    /* damping nearly strong enough that the body never turns */
    static const struct {
        int law;
        double beta, force;
    } turns[] = {{COR_LAW_TSUJI, 2.31727, 7.19012}, {COR_LAW_HERTZ_DASHPOT, 3.06276, 0.203421}};
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
        const struct cor_exponents *const law = &cor_law_exponents[turns[i].law];
        const struct cor_scene_contact c = scaled_contact(law, turns[i].beta, turns[i].force);
        check_near(scene_impact(&c, 1).max_overlap_m, reference(law, turns[i].beta, turns[i].force).max_overlap,
                   COR_SCENE_PRESSED_ERROR);
    }
    for (int law = 0; law < COR_LAW_PLATE; law++) {
        if (!law_is_complete(law))
            continue;
        struct cor_scene_contact c = scaled_contact(&cor_law_exponents[law], 0, 0.7);
        for (int end = 0; end < COR_SCENE_ENDS; end++)
            check_near(scene_impact(&c, 1).eps[end], 1, 1e-14);
        assert_true(cor_scene_sticking_speed(&c, 0) == 0);
        /* a small force changes eps in proportion to the force */
        c = scaled_contact(&cor_law_exponents[law], 0.5, 0);
        struct cor_scene_contact pressed = c;
        double less[2];
        for (int i = 0; i < 2; i++) {
            pressed.force_n = (i + 1) * 1e-7;
            less[i] = scene_eps(&c, 1, 0) - scene_eps(&pressed, 1, 0);
        }
        check(fabs(less[1] / less[0] - 2) < 1e-4 && less[0] > 0, "%g %g", less[0], less[1]);
        /* a restitution measured under the force */
        pressed.force_n = 0.02;
        for (int end = 0; end < COR_SCENE_ENDS; end++) {
            assert_int_equal(cor_scene_set_damping(&pressed, COR_SCENE_RESTITUTION, 0.8, 0.5, end), COR_OK);
            check_near(scene_eps(&pressed, 0.5, end), 0.8, 1e-12);
        }
    }
}
