/* SPDX-License-Identifier: MIT */
/* Tests the error of a time step against another integrator with other phases, by limits, and by refusals. */
#include "runtime/scene/simulators.h"
#include "scene.h"

static struct cor_scene_contact contact_with(enum cor_law law, double eps, int end)
{
    struct cor_scene_contact contact = {
        .law = cor_law_exponents[law], .mass_kg = 2e-3, .stiffness = 3e8, .radius_m = 1e-2};
    cor_scene_set_damping(&contact, COR_SCENE_RESTITUTION, eps, 1, end);
    return contact;
}

static struct cor_step_error error_of(const struct cor_scene_contact *contact, double speed, int end, double steps,
                                      int integrator)
{
    struct cor_step_error e;
    assert_int_equal(cor_scene_step_error(&e, contact, speed, end, steps, integrator), COR_OK);
    return e;
}

/* ---- another method: integration in SI units with pow, step by step until the surfaces part ---- */

struct mean {
    double eps, scatter;
    double jump, missed; /* largest difference of eps of adjacent phases, and its product with the weight */
};

static double push(const struct cor_scene_contact *c, double damping, int end, double x, double v)
{
    const double a = (double)c->law.elastic / c->law.denominator, b = (double)c->law.damping / c->law.denominator;
    const double force = x > 0 ? c->stiffness * pow(x, a) + damping * pow(x, b) * v : 0;
    return ((end == COR_END_ZERO_FORCE && force < 0 ? 0 : force) - c->force_n) / c->mass_kg;
}

/* Returns eps if the bodies part within 40 elastic durations, otherwise 0. */
static double rebound(const struct cor_scene_contact *c, double speed, int end, double h, int integrator, double phase)
{
    const double g = c->force_n / c->mass_kg, start = (phase - 1) * h,
                 damping = cor_scene_damping(c, COR_SCENE_DAMPING_COEFFICIENT);
    double x = (speed + g / 2 * start) * start, v = speed + g * start, a = -g;
    const long most = lround(40 * cor_scene_elastic_duration_s(c, speed) / h);
    if (integrator == COR_IMPLICIT_EULER) { /* constraint force mixing and error reduction parameter of engines */
        const double mixing = 1 / (h * c->stiffness + damping), reduction = h * c->stiffness * mixing;
        v -= g * h / 2;
        for (long k = -1000; k < most && (k == -1000 || x > 0); k++) {
            const double free = v + g * h, force = (free + reduction * x / h) / (mixing + h / c->mass_kg);
            v = !(x > 0) || (end == COR_END_ZERO_FORCE && force < 0) ? free : free - h / c->mass_kg * force;
            x += h * v;
        }
        v += g * h / 2;
        return x > 0 ? 0 : sqrt(v * v - 2 * g * x) / speed;
    }
    for (long k = 0; k < most && (k == 0 || x > 0); k++) {
        const double half = v - a * h / 2;
        x += half * h;
        a = push(c, damping, end, x, integrator == COR_VERLET_FULL_STEP ? half - a * h / 2 : half);
        v = half - a * h / 2;
    }
    return x > 0 ? 0 : sqrt(v * v - 2 * g * x) / speed;
}

/* Averages over phases that are denser at both ends. */
static struct mean simulated(const struct cor_scene_contact *c, double speed, int end, double step_s, int integrator,
                             int phases, double first)
{
    struct mean mean = {0, 0, 0, 0};
    double weights = 0, squares = 0, last = 0;
    for (int k = 0; k < phases; k++) {
        const double t = (k + first) / phases, weight = 6 * t * (1 - t) / phases;
        const double eps = rebound(c, speed, end, step_s, integrator, t * t * (3 - 2 * t));
        const double away = eps - mean.eps, jump = k > 0 ? fabs(eps - last) : 0;
        weights += weight;
        mean.eps += away * weight / weights;
        squares += weight * away * (eps - mean.eps);
        mean.jump = fmax(mean.jump, jump);
        mean.missed = fmax(mean.missed, jump * weight);
        last = eps;
    }
    mean.scatter = sqrt(squares / weights);
    return mean;
}

static void check_mean(const char *what, double eps, double scatter, const struct mean *other)
{
    const double s = other->scatter, error = COR_SCENE_STEP_ERROR;
    check(fabs(eps - other->eps) <= error * s + other->missed &&
              fabs(scatter * scatter - s * s) <= 2 * error * s * s + other->jump * other->missed,
          "%s: mean %.9g, not %.9g; scatter %.6g, not %.6g", what, eps, other->eps, scatter, s);
}

/* About half of the cases test the correction, the others weak damping. Up to a third have a constant force. */
TEST(another_route)
{
    enum { TRIES = 120, OTHER_PHASES = 601 };
    struct random_state r = random_start();
    for (int k = 0; k < (int)points(TRIES); k++) {
        const enum cor_law law = (enum cor_law)(k % SCENE_LAWS);
        /* again: strong damping and a predicted velocity, so that the force pushes again after it was zero */
        const int again = k % 8 == 7, end = again || k / 5 % 2, weak = !again && k / 10 % 2,
                  integrator = again                   ? COR_VERLET_FULL_STEP
                               : law == COR_LAW_LINEAR ? COR_IMPLICIT_EULER - (int)random_below(&r, 2)
                                                       : (int)random_below(&r, COR_IMPLICIT_EULER);
        const double low = again ? 0.2 : 0.3, high = again ? 0.5 : 0.99, most = weak ? 200 : (again ? 6 : 20);
        const double eps = weak ? 1 - random_log(&r, 1e-4, 0.3) : random_uniform(&r, low, high),
                     speed = random_log(&r, 0.05, 20),
                     steps = random_log(&r, integrator == COR_IMPLICIT_EULER ? 0.02 : 2.2, most);
        struct cor_scene_contact contact = contact_with(law, eps, end), corrected;
        cor_scene_set_damping(&contact, COR_SCENE_RESTITUTION, eps, speed, end);
        const double duration = cor_scene_elastic_duration_s(&contact, speed), step_s = duration / steps;
        if (k % 3 == 0 && steps > 4)
            contact.force_n = random_log(&r, 1e-3, 0.1 * steps) * contact.mass_kg * speed / duration;
        char what[99];
        snprintf(what, sizeof what, "draw %d, law %d end %d integrator %d eps %g, %g steps", k, (int)law, end,
                 integrator, eps, steps);
        const double exact = scene_eps(&contact, speed, end), first = random_uniform(&r, 0, 1);
        struct mean other = simulated(&contact, speed, end, step_s, integrator, OTHER_PHASES, first);
        const struct cor_step_error e = error_of(&contact, speed, end, steps, integrator);
        check(e.least <= e.bias && e.bias <= e.largest, "%s: %g, %g, %g", what, e.least, e.bias, e.largest);
        check_mean(what, e.bias + exact, e.scatter, &other);
        if (weak)
            continue;
        const int status = cor_scene_step_corrected(&corrected, &contact, speed, end, steps, integrator);
        check(status == COR_OK || (status == COR_FAULT_NO_DAMPING && (steps < 6 || integrator == COR_IMPLICIT_EULER)),
              "%s: status %d", what, status);
        if (status != COR_OK)
            continue;
        const struct cor_step_error after = error_of(&corrected, speed, end, steps, integrator);
        const double off = after.bias + scene_eps(&corrected, speed, end) - exact;
        check(fabs(off) < 1e-9, "%s: corrected, and off by %g", what, off);
        other = simulated(&corrected, speed, end, step_s, integrator, OTHER_PHASES, first);
        check_mean(what, exact, after.scatter, &other);
    }
}

/* Weak damping with b = 0: only a narrow range of phases needs one more step. The scatter comes from 100000 phases. */
TEST(narrow_windows)
{
    const double many[][3] = {{5e-3, 0.005961276382523327, 2.655e-6}, {3e-4, 0.0628198558985, 1.466e-6}};
    for (size_t k = 0; k < COUNT_OF(many); k++) { /* zeta, the step in units of sqrt(m/K), scatter */
        struct cor_scene_contact contact = contact_with(COR_LAW_LINEAR, 1, COR_END_ZERO_OVERLAP);
        contact.damping = many[k][0];
        const double steps = 3.14159265358979324 / many[k][1];
        check_near(error_of(&contact, 1, COR_END_ZERO_OVERLAP, steps, COR_LEAPFROG).scatter, many[k][2],
                   COR_SCENE_STEP_ERROR);
    }
}

/* ---- limits ---- */

static double bias_at(const struct cor_scene_contact *contact, double steps, int integrator)
{
    return error_of(contact, 1, COR_END_ZERO_OVERLAP, steps, integrator).bias;
}

TEST(small_steps)
{
    const struct cor_scene_contact contact = contact_with(COR_LAW_VISCOELASTIC, 0.6, COR_END_ZERO_OVERLAP);
    /* the velocity of half a step before causes a first-order error; the velocity of the full step does not */
    const double half = bias_at(&contact, 1000, COR_VERLET_HALF_STEP),
                 full = bias_at(&contact, 1000, COR_VERLET_FULL_STEP);
    check(fabs(bias_at(&contact, 1e4, COR_VERLET_HALF_STEP) * 10 / half - 1) < 0.01, "bias %g", half);
    check(fabs(full) < 0.1 * fabs(half) && fabs(bias_at(&contact, 1e4, COR_VERLET_FULL_STEP)) < fabs(full) / 20,
          "half %g, full %g, %g", half, full, bias_at(&contact, 1e4, COR_VERLET_FULL_STEP));
    check(left_to_turn(0, 3) || fabs(bias_at(&contact, COR_SCENE_STEPS_MAX, COR_VERLET_HALF_STEP)) < 1e-7,
          "at 1e6 steps");
    for (int k = 0; k < COR_INTEGRATORS; k++)
        check(k == COR_IMPLICIT_EULER || (bias_at(&contact, 12, k) == bias_at(&contact, 12, COR_VERLET_HALF_STEP)) ==
                                             (k != COR_VERLET_FULL_STEP),
              "%s", cor_integrator_names[k]);
    struct cor_scene_contact elastic = contact;
    elastic.damping = 0;
    check_near(cor_scene_elastic_duration_s(&contact, 0.3), scene_impact(&elastic, 0.3).duration_s[0], 1e-13);
}

TEST(step_for)
{
    for (int k = 0; k < 3; k++)
        for (double tolerance = 1e-2; tolerance > 5e-4; tolerance /= 3) {
            const struct cor_scene_contact contact = contact_with((enum cor_law)k, 0.7, k % 2);
            double steps;
            assert_int_equal(cor_scene_step_for(&steps, &contact, 1, k % 2, tolerance, COR_LEAPFROG), COR_OK);
            double worst = 0;
            for (double less = steps / 1.002; less < steps + 1;
                 less += 0.125 * (double)check_number("COR_TEST_DIVISOR", 1)) {
                const struct cor_step_error e = error_of(&contact, 1, k % 2, less, COR_LEAPFROG);
                worst = fmax(worst, fmax(fabs(e.bias), e.scatter));
            }
            check(worst > 0.9 * tolerance, "%g steps are not the least", steps);
            for (double more = steps; more < 8 * steps; more *= 1.037) {
                const struct cor_step_error e = error_of(&contact, 1, k % 2, more, COR_LEAPFROG);
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

/* Under a constant force, small steps have no error, and bodies below the sticking speed stick at any step. */
TEST(pressed)
{
    /* LAMMPS, wall/gran hooke with limit_damping and fix gravity: mean and standard deviation of 40 phases */
    struct cor_scene_contact ball = {
        .law = {1, 0, 1}, .mass_kg = 0.00418879, .stiffness = 1000, .force_n = 0.00418879 * 9.81};
    cor_scene_set_damping(&ball, COR_SCENE_DAMPING_COEFFICIENT, 0.4, 0.1, COR_END_ZERO_FORCE);
    struct cor_step_error lammps = error_of(&ball, 0.1, COR_END_ZERO_FORCE, 12, COR_VERLET_HALF_STEP);
    check(fabs(lammps.bias + scene_eps(&ball, 0.1, COR_END_ZERO_FORCE) - 0.662257) < 5e-6 &&
              fabs(lammps.scatter - 0.010791) < 1e-5,
          "bias %g, scatter %g", lammps.bias, lammps.scatter);
    /* for bodies that creep to rest, the force determines the least number of steps */
    double steps_for;
    ball.force_n *= 100;
    assert_int_equal(cor_scene_step_for(&steps_for, &ball, 0.1, COR_END_ZERO_FORCE, 0.1, COR_LEAPFROG), COR_OK);
    ball.damping = 100;
    lammps = error_of(&ball, 0.1, COR_END_ZERO_OVERLAP, 1e4, COR_LEAPFROG);
    check(lammps.bias == 0 && lammps.scatter == 0, "bias %g, scatter %g", lammps.bias, lammps.scatter);
    struct random_state r = random_start();
    for (int k = 0; k < (int)points(100); k++) {
        const int end = k / 5 % 2, integrator = (int)random_below(&r, COR_IMPLICIT_EULER);
        struct cor_scene_contact contact = contact_with((enum cor_law)(k % 5), random_uniform(&r, 0.3, 0.95), end);
        contact.force_n = random_log(&r, 1e-4, 1e2);
        const double stays = cor_scene_sticking_speed(&contact, end), speed = stays * random_uniform(&r, 1.2, 10),
                     steps = random_log(&r, 1e3, 1e4);
        if (!(stays < 1e3)) /* they stick at every speed */
            continue;
        struct cor_step_error e = error_of(&contact, speed, end, steps, integrator);
        check(fabs(e.bias) < (integrator == COR_VERLET_FULL_STEP ? 1e3 / steps : 2) / steps,
              "law %d end %d integrator %d, %g steps: bias %g", k % 5, end, integrator, steps, e.bias);
        const double slow = stays * random_uniform(&r, 0.3, 0.8);
        /* with enough steps, no step changes the speed by more than half of the allowed change */
        const double many =
            fmax(steps, contact.force_n * cor_scene_elastic_duration_s(&contact, slow) / (contact.mass_kg * slow));
        e = error_of(&contact, slow, end, many, integrator);
        check(e.bias == 0 && e.scatter == 0, "law %d end %d, %g steps: %g, %g", k % 5, end, many, e.bias, e.scatter);
        if (many > steps)
            refused(&contact, slow, end, many / 2.001, integrator);
    }
}

/* Compares implicit steps with 100000 phases of simulated(), down to contacts of one step. Other laws are refused. */
TEST(implicit_steps)
{
    const double many[][2] = {{0.35, 0.7}, {0.05, 3}, {2, 0.01}};
    for (size_t k = 0; k < COUNT_OF(many); k++) {
        struct cor_scene_contact contact = contact_with(COR_LAW_LINEAR, 1, COR_END_ZERO_FORCE);
        contact.damping = many[k][0];
        const double step_s = cor_scene_elastic_duration_s(&contact, 1) / many[k][1];
        const struct mean other = simulated(&contact, 1, COR_END_ZERO_FORCE, step_s, COR_IMPLICIT_EULER, 100000, 0.5);
        const struct cor_step_error e = error_of(&contact, 1, COR_END_ZERO_FORCE, many[k][1], COR_IMPLICIT_EULER);
        check_mean("implicit", e.bias + scene_eps(&contact, 1, COR_END_ZERO_FORCE), e.scatter, &other);
        refused(&contact, 1, COR_END_ZERO_FORCE, 1.9, COR_LEAPFROG);
        contact.law = cor_law_exponents[COR_LAW_TSUJI];
        refused(&contact, 1, COR_END_ZERO_FORCE, 12, COR_IMPLICIT_EULER);
    }
}

TEST(special)
{
    struct cor_scene_contact contact = contact_with(COR_LAW_VISCOELASTIC, 0.6, COR_END_ZERO_OVERLAP), corrected;
    struct cor_step_error e;
    double steps;
    EACH (no_steps, 1.9, 1.1e6, NAN)
        refused(&contact, 1, COR_END_ZERO_OVERLAP, *no_steps, COR_LEAPFROG);
    EACH (integrators, COR_NO_INTEGRATOR, COR_INTEGRATORS)
        refused(&contact, 1, COR_END_ZERO_OVERLAP, 12, (int)*integrators);
    EACH (ends, COR_END_LIMITED, COR_BOTH_ENDS)
        refused(&contact, 1, (int)*ends, 12, COR_LEAPFROG);
    refused(&contact, NAN, COR_END_ZERO_OVERLAP, 12, COR_LEAPFROG);
    struct cor_scene_contact others[4] = {contact, contact, contact, contact};
    others[0].plate = others[1].plastic = 1;
    others[1].yield_speed_m_s = others[2].adhesion_j_m2 = others[3].liquid_speed_m_s = 0.1;
    for (int i = 0; i < 4; i++)
        refused(&others[i], 1, COR_END_ZERO_FORCE, 12, COR_LEAPFROG);
    assert_int_equal(cor_scene_step_for(&steps, &contact, 1, COR_END_ZERO_OVERLAP, 0, COR_LEAPFROG), COR_FAULT_STEP);
    check(isnan(steps), "steps %g", steps);
    /* damping so strong that the contact has only a few steps */
    contact.law = cor_law_exponents[COR_LAW_LINEAR];
    contact.damping = 30;
    assert_int_equal(cor_scene_step_for(&steps, &contact, 1, COR_END_ZERO_FORCE, 1e-9, COR_LEAPFROG), COR_FAULT_STEP);
    contact.law = cor_law_exponents[COR_LAW_VISCOELASTIC];
    /* without damping the integrator is symmetric: errors come only from the ends of the contact, and the correction is
     * 0 */
    contact.damping = 0;
    check(fabs(bias_at(&contact, 50, COR_LEAPFROG)) < 1e-5, "elastic: %g", bias_at(&contact, 50, COR_LEAPFROG));
    assert_int_equal(cor_scene_step_corrected(&corrected, &contact, 1, COR_END_ZERO_OVERLAP, 50, COR_LEAPFROG), COR_OK);
    check(corrected.damping == 0, "elastic: %g", corrected.damping);
    /* bodies that never part, and damping from weak to huge: results are finite, or refused */
    contact = contact_with(COR_LAW_HERTZ_DASHPOT, 0.5, COR_END_ZERO_OVERLAP);
    contact.damping *= 10;
    e = error_of(&contact, 1, COR_END_ZERO_OVERLAP, 40, COR_LEAPFROG);
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
    assert_int_equal(cor_simulator_named("yade")->integrator, COR_LEAPFROG);
    assert_int_equal(cor_simulator_named("lammps")->integrator, COR_VERLET_HALF_STEP);
    assert_int_equal(cor_simulator_of(COR_KRATOS_HERTZ)->integrator, COR_SYMPLECTIC_EULER);
    assert_int_equal(cor_simulator_named("rebound")->integrator, COR_NO_INTEGRATOR);
}

/* ---- simulators ---- */

/* The number of every model, corrected for a coarse step, gives a damping with the requested mean eps. */
TEST(models)
{
    static const double eps = 0.7, speed = 0.5;
    const struct cor_scene scene = scene_without_numbers(COR_LAW_VISCOELASTIC);
    int judged = 0;
    for (int i = 0; i < COR_SIMULATOR_MODELS; i++) {
        const struct cor_simulator_model *const model = cor_simulator_model((enum cor_simulator_model_id)i);
        const int integrator = cor_simulator_of(model->id)->integrator;
        if (integrator < 0 || model->law >= COR_LAW_LINEAR_ROOT || model->end > COR_END_ZERO_FORCE)
            continue;
        const double steps = integrator == COR_IMPLICIT_EULER ? 120 : 12; /* 12 implicit steps lose more than 1 - eps */
        struct cor_scene_contact contact = contact_with(model->law, eps, (int)model->end);
        cor_scene_set_damping(&contact, COR_SCENE_RESTITUTION, eps, speed, (int)model->end);
        const struct cor_simulator_target target = {&scene, &contact, 1, speed, eps, steps};
        struct cor_scene_contact given = contact;
        const double damping = cor_simulator_damping(model, &target, 1);
        cor_scene_set_damping(&given, cor_scene_speed_exponent(&given) == 0 ? COR_SCENE_ZETA : COR_SCENE_BETA, damping,
                              speed, 0);
        const struct mean mean = simulated(&given, speed, (int)model->end,
                                           cor_scene_elastic_duration_s(&contact, speed) / steps, integrator, 401, 0.3);
        check(fabs(mean.eps - eps) < COR_SCENE_STEP_ERROR * mean.scatter, "%s: %g", model->model, mean.eps);
        /* the damping from only eps is the same, or NaN if the law has no closed form */
        const double by_eps = cor_simulator_damping(model, &target, 0);
        check(isnan(by_eps) || fabs(by_eps / damping - 1) < 1e-9, "%s: %g, %g", model->model, by_eps, damping);
        judged++;
    }
    check(judged > 25, "%d models", judged);
}
