/* SPDX-License-Identifier: MIT */
/* The error of a time step: another integrator with other phases, limits, and what is refused */
#include "scene.h"

static struct cor_scene_contact contact_with(enum cor_law law, double eps, int end)
{
    struct cor_scene_contact contact = {
        .law = cor_law_exponents[law], .mass_kg = 2e-3, .stiffness = 3e8, .radius_m = 1e-2};
    cor_scene_set_damping(&contact, COR_SCENE_RESTITUTION, eps, 1, end);
    return contact;
}

/* ---- another route: SI units, the three parts of velocity Verlet, pow, any phases ---- */

struct mean {
    double eps, scatter;
};

static long double push(const struct cor_scene_contact *c, int end, long double x, long double v)
{
    const long double a = (long double)c->law.elastic / c->law.denominator,
                      b = (long double)c->law.damping / c->law.denominator;
    const long double force =
        c->stiffness * powl(x, a) + cor_scene_damping(c, COR_SCENE_DAMPING_COEFFICIENT) * powl(x, b) * v;
    return end == COR_END_ZERO_FORCE && force < 0 ? 0 : force / c->mass_kg;
}

static struct mean simulated(const struct cor_scene_contact *c, double speed, int end, long double step_s,
                             int integrator, int phases, double first)
{
    long double sum = 0, squares = 0;
    for (int k = 0; k < phases; k++) {
        /* the overlap before the first step in contact is negative */
        long double x = ((k + first) / phases - 1) * step_s * speed, v = speed, a = 0;
        int met = 0;
        while (!met || x > 0) {
            const long double half = v - a * step_s / 2;
            x += half * step_s;
            const long double seen = integrator == COR_VERLET_FULL_STEP ? half - a * step_s / 2 : half;
            a = x > 0 ? push(c, end, x, seen) : 0;
            v = half - a * step_s / 2;
            met = met || x > 0;
        }
        sum += -v / speed;
        squares += v / speed * v / speed;
    }
    const long double mean = sum / phases;
    return (struct mean){(double)mean, (double)sqrtl(squares / phases - mean * mean)};
}

TEST(another_route)
{
    enum { TRIES = 40, OTHER_PHASES = 1201 };
    static const enum cor_law laws[] = {COR_LAW_VISCOELASTIC, COR_LAW_LINEAR, COR_LAW_TSUJI, COR_LAW_HUNT_CROSSLEY,
                                        COR_LAW_HERTZ_DASHPOT};
    struct random_state r = random_seeded(32);
    for (int k = 0; k < TRIES; k++) {
        const enum cor_law law = laws[k % 5];
        const int end = k / 5 % 2, integrator = (int)random_below(&r, COR_INTEGRATORS);
        const double eps = random_uniform(&r, 0.3, 0.99), speed = exp(random_uniform(&r, -3, 3)),
                     steps = exp(random_uniform(&r, 1, 4));
        struct cor_scene_contact contact = contact_with(law, eps, end), corrected;
        cor_scene_set_damping(&contact, COR_SCENE_RESTITUTION, eps, speed, end);
        const long double step_s = cor_scene_elastic_duration_s(&contact, speed) / steps;
        struct mean other = simulated(&contact, speed, end, step_s, integrator, OTHER_PHASES, random_uniform(&r, 0, 1));
        struct cor_step_error e, after;
        assert_int_equal(cor_scene_step_error(&e, &contact, speed, end, steps, integrator), COR_OK);
        check(e.least <= e.bias && e.bias <= e.largest, "least %g, bias %g, largest %g", e.least, e.bias, e.largest);
        check(fabs(e.bias - (other.eps - eps)) <= COR_SCENE_STEP_ERROR * other.scatter &&
                  fabs(e.scatter - other.scatter) <= COR_SCENE_STEP_ERROR * other.scatter,
              "law %d end %d integrator %d eps %g, %g steps: bias %g, not %g; scatter %g, not %g", (int)law, end,
              integrator, eps, steps, e.bias, other.eps - eps, e.scatter, other.scatter);
        assert_int_equal(cor_scene_step_corrected(&corrected, &contact, speed, end, steps, integrator), COR_OK);
        other = simulated(&corrected, speed, end, step_s, integrator, OTHER_PHASES, random_uniform(&r, 0, 1));
        check(fabs(other.eps - eps) <= COR_SCENE_STEP_ERROR * other.scatter, "law %d end %d: corrected to %g, not %g",
              (int)law, end, other.eps, eps);
        const double exact = scene_eps(&corrected, speed, end);
        cor_scene_step_error(&after, &corrected, speed, end, steps, integrator);
        check(fabs(after.bias + exact - eps) < 1e-9, "law %d end %d: corrected, and off by %g", (int)law, end,
              after.bias + exact - eps);
    }
}

/* ---- limits ---- */

static double bias_at(const struct cor_scene_contact *contact, double steps, int integrator)
{
    struct cor_step_error e;
    assert_int_equal(cor_scene_step_error(&e, contact, 1, COR_END_ZERO_OVERLAP, steps, integrator), COR_OK);
    return e.bias;
}

TEST(small_steps)
{
    const struct cor_scene_contact contact = contact_with(COR_LAW_VISCOELASTIC, 0.6, COR_END_ZERO_OVERLAP);
    /* the velocity of half a step ago is an error of first order, that of the full step leaves none of it */
    const double half = bias_at(&contact, 1000, COR_VERLET_HALF_STEP),
                 full = bias_at(&contact, 1000, COR_VERLET_FULL_STEP);
    check(fabs(bias_at(&contact, 1e4, COR_VERLET_HALF_STEP) * 10 / half - 1) < 0.01, "bias %g", half);
    check(fabs(full) < 0.1 * fabs(half) && fabs(bias_at(&contact, 1e4, COR_VERLET_FULL_STEP)) < fabs(full) / 20,
          "half %g, full %g, %g", half, full, bias_at(&contact, 1e4, COR_VERLET_FULL_STEP));
    check(fabs(bias_at(&contact, COR_SCENE_STEPS_MAX, COR_VERLET_HALF_STEP)) < 1e-7, "at 1e6 steps");
    for (int k = 0; k < COR_INTEGRATORS; k++)
        check((bias_at(&contact, 12, k) == bias_at(&contact, 12, COR_VERLET_HALF_STEP)) == (k != COR_VERLET_FULL_STEP),
              "%s", cor_integrator_names[k]);
    struct cor_scene_contact elastic = contact;
    elastic.damping = 0;
    check_near(cor_scene_elastic_duration_s(&contact, 0.3), scene_impact(&elastic, 0.3).duration_s[0], 1e-13);
}

TEST(step_for)
{
    static const enum cor_law laws[] = {COR_LAW_VISCOELASTIC, COR_LAW_LINEAR, COR_LAW_TSUJI};
    for (int k = 0; k < 3; k++)
        for (double tolerance = 1e-2; tolerance > 5e-4; tolerance /= 3) {
            const struct cor_scene_contact contact = contact_with(laws[k], 0.7, k % 2);
            struct cor_step_error e;
            double steps;
            assert_int_equal(cor_scene_step_for(&steps, &contact, 1, k % 2, tolerance, COR_LEAPFROG), COR_OK);
            double worst = 0;
            for (double less = steps / 1.002; less < steps + 1;
                 less += 0.125 * (double)check_number("COR_TEST_DIVISOR", 1)) {
                cor_scene_step_error(&e, &contact, 1, k % 2, less, COR_LEAPFROG);
                worst = fmax(worst, fmax(fabs(e.bias), e.scatter));
            }
            check(worst > 0.9 * tolerance, "%g steps are not the least", steps);
            for (double more = steps; more < 8 * steps; more *= 1.037) {
                cor_scene_step_error(&e, &contact, 1, k % 2, more, COR_LEAPFROG);
                check(fabs(e.bias) <= tolerance && e.scatter <= 1.1 * tolerance, "%g steps of at least %g: %g, %g",
                      more, steps, e.bias, e.scatter);
            }
        }
}

/* ---- special values ---- */

static void refused(const struct cor_scene_contact *contact, double speed, int end, double steps, int integrator)
{
    struct cor_step_error e;
    struct cor_scene_contact corrected;
    check(cor_scene_step_error(&e, contact, speed, end, steps, integrator) == COR_FAULT_STEP && isnan(e.bias) &&
              isnan(e.scatter) && isnan(e.least) && isnan(e.largest),
          "end %d, %g steps, integrator %d", end, steps, integrator);
    check(cor_scene_step_corrected(&corrected, contact, speed, end, steps, integrator) == COR_FAULT_STEP &&
              isnan(corrected.damping),
          "end %d, %g steps, integrator %d", end, steps, integrator);
}

TEST(special)
{
    struct cor_scene_contact contact = contact_with(COR_LAW_VISCOELASTIC, 0.6, COR_END_ZERO_OVERLAP), corrected;
    struct cor_step_error e;
    double steps;
    EACH (no_steps, 1.9, 1.1e6, NAN)
        refused(&contact, 1, COR_END_ZERO_OVERLAP, *no_steps, COR_LEAPFROG);
    refused(&contact, 1, COR_END_ZERO_OVERLAP, 12, COR_NO_INTEGRATOR);
    refused(&contact, 1, COR_END_ZERO_OVERLAP, 12, COR_INTEGRATORS);
    refused(&contact, 1, COR_END_LIMITED, 12, COR_LEAPFROG);
    refused(&contact, 1, COR_BOTH_ENDS, 12, COR_LEAPFROG);
    refused(&contact, NAN, COR_END_ZERO_OVERLAP, 12, COR_LEAPFROG);
    contact.plate = 1;
    refused(&contact, 1, COR_END_ZERO_FORCE, 12, COR_LEAPFROG);
    contact.plate = 0;
    assert_int_equal(cor_scene_step_for(&steps, &contact, 1, COR_END_ZERO_OVERLAP, 0, COR_LEAPFROG), COR_FAULT_STEP);
    check(isnan(steps), "steps %g", steps);
    /* so much damping that few of the steps are in contact */
    contact.law = cor_law_exponents[COR_LAW_LINEAR];
    contact.damping = 30;
    assert_int_equal(cor_scene_step_for(&steps, &contact, 1, COR_END_ZERO_FORCE, 1e-9, COR_LEAPFROG), COR_FAULT_STEP);
    contact.law = cor_law_exponents[COR_LAW_VISCOELASTIC];
    /* no damping: a symmetric integrator, whose error is that of the contact's ends alone; nothing to correct */
    contact.damping = 0;
    assert_int_equal(cor_scene_step_error(&e, &contact, 1, COR_END_ZERO_OVERLAP, 50, COR_LEAPFROG), COR_OK);
    check(fabs(e.bias) < 1e-5, "elastic: %g", e.bias);
    assert_int_equal(cor_scene_step_corrected(&corrected, &contact, 1, COR_END_ZERO_OVERLAP, 50, COR_LEAPFROG), COR_OK);
    check(corrected.damping == 0, "elastic: %g", corrected.damping);
    /* bodies that never part, and damping from weak to absurd: results are finite, or refused */
    contact = contact_with(COR_LAW_HERTZ_DASHPOT, 0.5, COR_END_ZERO_OVERLAP);
    contact.damping *= 10;
    assert_int_equal(cor_scene_step_error(&e, &contact, 1, COR_END_ZERO_OVERLAP, 40, COR_LEAPFROG), COR_OK);
    check(e.bias == 0 && e.scatter == 0, "stuck: %g, %g", e.bias, e.scatter);
    for (int law = 0; law < COR_LAW_PLATE; law++)
        for (double factor = 1e-300; factor < 1e300; factor *= 1e20)
            for (int end = 0; end < COR_SCENE_ENDS; end++) {
                contact = contact_with((enum cor_law)law, 0.5, end);
                contact.damping *= factor;
                const int status = cor_scene_step_error(&e, &contact, 1, end, 12, law % COR_INTEGRATORS);
                check(status == COR_OK ? isfinite(e.bias) && isfinite(e.scatter) : isnan(e.bias),
                      "law %d end %d, damping times %g: status %d, %g, %g", law, end, factor, status, e.bias,
                      e.scatter);
            }
    assert_int_equal(cor_simulator_integrator("yade"), COR_LEAPFROG);
    assert_int_equal(cor_simulator_integrator("lammps"), COR_VERLET_HALF_STEP);
    assert_int_equal(cor_simulator_integrator("rebound"), COR_NO_INTEGRATOR);
    assert_int_equal(cor_simulator_integrator("unknown"), COR_NO_INTEGRATOR);
}

/* ---- simulators ---- */

/* The number of every model for a coarse step gives a damping whose mean is the eps that was asked for. */
TEST(models)
{
    static const double eps = 0.7, speed = 0.5, steps = 12;
    const struct cor_scene scene = scene_without_numbers(COR_LAW_VISCOELASTIC);
    int judged = 0;
    for (size_t i = 0; i < cor_simulator_model_count; i++) {
        const struct cor_simulator_model *const model = &cor_simulator_models[i];
        const int integrator = cor_simulator_integrator(model->simulator);
        if (integrator < 0 || model->law >= COR_LAW_LINEAR_ROOT || model->end > COR_END_ZERO_FORCE)
            continue;
        struct cor_scene_contact contact = contact_with(model->law, eps, (int)model->end);
        cor_scene_set_damping(&contact, COR_SCENE_RESTITUTION, eps, speed, (int)model->end);
        const struct cor_simulator_wish wish = {&scene, &contact, 1, speed, eps, steps};
        struct cor_scene_contact given = contact;
        const double damping = cor_simulator_damping(model, &wish, 1);
        cor_scene_set_damping(&given, cor_scene_speed_exponent(&given) == 0 ? COR_SCENE_ZETA : COR_SCENE_BETA, damping,
                              speed, 0);
        const struct mean mean =
            simulated(&given, speed, (int)model->end,
                      cor_scene_elastic_duration_s(&contact, speed) / (long double)steps, integrator, 401, 0.3);
        check(fabs(mean.eps - eps) < COR_SCENE_STEP_ERROR * mean.scatter, "%s, %s: %g", model->simulator, model->model,
              mean.eps);
        /* by eps alone the same, where the law has a closed form */
        const double by_eps = cor_simulator_damping(model, &wish, 0);
        check(isnan(by_eps) || fabs(by_eps / damping - 1) < 1e-9, "%s, %s: %g, %g", model->simulator, model->model,
              by_eps, damping);
        judged++;
    }
    check(judged > 25, "%d models", judged);
}

RUN_TESTS(another_route, small_steps, step_for, special, models)
