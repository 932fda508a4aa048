/* SPDX-License-Identifier: MIT */
/* Tests corgen plan: its values against independent formulas and collisions, and its choice, which must be the cheapest
 * model that meets the tolerance. */
#include "support/console.h" /* must precede cmocka.h, which defines a macro fail */

#include "approximation/pade.h"
#include "ball.h"
#include "contact/contact.h"
#include "cor/cor.h"
#include "cor/disk.h"
#include "enclosure/collision.h"
#include "plan/plan.h"
#include "request.h"

#define G_STAR 400.0
#define TOLERANCE 1e-3

static double beta_of(double speed)
{
    return pow(speed / G_STAR, 0.2) / -COR_SPHERE_C1;
}

static void eps_solve(double *overlap, double *force, double beta_wanted)
{
    LOCAL(collision, c);
    LOCAL(arb, beta);
    arb_set_d(beta, beta_wanted);
    assert_int_equal(collision_solve(c, beta, &law_sphere, 60), 0);
    *overlap = middle(c->eps_zero_overlap);
    *force = middle(c->eps_zero_force);
}

static struct plan_model *named(const struct plan *plan, const char *start)
{
    for (int i = 0; i < plan->models; i++)
        if (strncmp(plan->model[i].name, start, strlen(start)) == 0)
            return &plan->model[i];
    fail_msg("no model '%s'", start);
    return NULL;
}

static void check_values(const struct plan *plan, const char *start, slong i, double expected, double tolerance)
{
    const double value = named(plan, start)->value[i];
    check(fabs(value / expected - 1) <= tolerance, "%s at point %ld: %.17g, not %.17g", start, (long)i, value,
          expected);
}

static double printed_2011(double beta)
{
    const double v = sqrt(beta);
    return (1 + 0.501086 * v) / (1 + 0.501086 * v + 1.15345 * v * v + 0.577977 * pow(v, 3) + 0.532178 * pow(v, 4));
}

/* Returns the [4/6] at zero force as corgen pade computes it. */
static double pade_46(double beta)
{
    const struct pade_request request = {PADE_ORDINARY, 4, 6, COR_END_ZERO_FORCE, law_sphere};
    LOCAL_INIT(pade, f, (&f));
    assert_int_equal(pade_compute(&f, NULL, &request, 64), 0);
    double p = 0, q = 0;
    for (slong k = 6; k >= 0; k--) {
        q = q * sqrt(beta) + middle(arb_poly_get_coeff_ptr(f.q, k));
        p = p * sqrt(beta) + (k <= 4 ? middle(arb_poly_get_coeff_ptr(f.p, k)) : 0);
    }
    return p / q;
}

/* Checks the choice at every tolerance: it meets the tolerance at every point, and no cheaper model does. A model that
 * is reported as missing the tolerance misses it. */
static void check_choice(struct plan *plan, struct random_state *r)
{
    for (int k = 0; k < 300; k++) {
        plan->tolerance = random_log(r, 1e-17, 1);
        plan_choose(plan);
        int least = -1;
        for (int i = 0; i < plan->models; i++) {
            const struct plan_model *m = &plan->model[i];
            bool meets = !m->shown && !m->outside && m->elsewhere <= 0.97 * plan->tolerance;
            for (slong j = 0; j < plan->points; j++)
                meets = meets && m->error[j] + (m->promised ? 0 : plan->uncertainty[j]) <= 0.97 * plan->tolerance;
            assert_true(meets == (m->verdict == PLAN_MEETS || m->verdict == PLAN_CHOSEN));
            assert_true((m->verdict == PLAN_CHOSEN) == (i == plan->chosen));
            const struct plan_model *const best = least < 0 ? NULL : &plan->model[least];
            if (meets && (!best || m->cost < best->cost || (m->cost == best->cost && m->worst < best->worst)))
                least = i;
        }
        assert_true((least < 0) == (plan->chosen < 0));
        assert_true(least < 0 || (plan->model[plan->chosen].cost == plan->model[least].cost &&
                                  plan->model[plan->chosen].worst == plan->model[least].worst));
    }
}

/* ---- spheres ---- */

/* Makes the plan of a contact with g*. */
static void plan_of(struct plan *plan, const char *min, const char *max, const char *tolerance, const char *g_star,
                    int end, slong count)
{
    struct contacts contacts;
    struct embed_request request = request_of(min, max, tolerance, end, GIVEN({COR_SCENE_G_STAR, g_star}));
    assert_int_equal(contacts_of_request(&contacts, &request), STATUS_OK);
    assert_int_equal(plan_spheres(plan, &request, contacts.contact, &request, contacts.contact, count), STATUS_OK);
    request_clear(&request);
}

TEST(test_spheres)
{
    struct plan plan;
    plan_of(&plan, "0.01", "1", "1e-3", "400", COR_END_ZERO_FORCE, 9);
    const slong last = plan.points - 1;
    assert_int_equal(last, 8);
    assert_true(plan.speed[0] == 0.01 && plan.speed[last] == 1);

    /* other formulas, at another precision, give the same values */
    double low = 1, high = 0;
    for (slong i = 0; i <= last; i++) {
        const double beta = beta_of(plan.speed[i]);
        double overlap, force;
        eps_solve(&overlap, &force, beta);
        assert_true(fabs(plan.speed[i] / (0.01 * pow(100, (double)i / 8)) - 1) < 1e-14);
        assert_true(fabs(plan.at[i] / beta - 1) < 1e-14 && fabs(plan.truth[i] / force - 1) < 1e-14);
        check_values(&plan, "simple theory (27)", i, cor_sphere_eps_simple(beta), 1e-14);
        check_values(&plan, "Pade [1/4] as printed in 1999", i, cor_sphere_eps_published_pade(beta), 1e-14);
        check_values(&plan, "Pade [1/4] as printed in 2011", i, printed_2011(beta), 1e-14);
        check_values(&plan, "Pade [4/6]", i, pade_46(beta), 1e-14);
        check_values(&plan, "the other end", i, overlap, 1e-14);
        for (int k = 0; k < plan.models; k++)
            if (!plan.model[k].promised)
                assert_true(fabs(plan.model[k].error[i] - fabs(plan.model[k].value[i] / force - 1)) < 1e-14);
        low = fmin(low, force);
        high = fmax(high, force);
    }
    /* no constant is better than the first model, and no power law better than the plan's power law */
    double c, a, b;
    assert_int_equal(sscanf(named(&plan, "constant eps")->use, "double eps = %lf", &c), 1);
    assert_true(fabs((c / low - 1) - (1 - c / high)) < 1e-9);
    assert_int_equal(sscanf(named(&plan, "power law")->use, "double eps = fmin(1, %lf * pow(speed, %lf", &a, &b), 2);
    double above = 0, below = 0;
    for (slong i = 0; i <= last; i++) {
        const double law = fmin(1, a * pow(plan.speed[i], b));
        check_values(&plan, "power law", i, law, 1e-14);
        above = fmax(above, law / plan.truth[i] - 1);
        below = fmax(below, 1 - law / plan.truth[i]);
    }
    assert_true(fabs(above - below) < 1e-8);
    for (int k = 0; k < 1000; k++) {
        const double other_a = a * random_uniform(&draw, 0.98, 1.02), other_b = b + random_uniform(&draw, -0.01, 0.01);
        double off = 0;
        for (slong i = 0; i <= last; i++)
            off = fmax(off, fabs(fmin(1, other_a * pow(plan.speed[i], other_b)) / plan.truth[i] - 1));
        check(off >= above - 1e-9, "%.17g speed^%.17g is off by %.9g, the law taken by %.9g", other_a, other_b, off,
              above);
    }

    /* The choice is a header, with its command and the error that corgen embed finds between the points. */
    const struct plan_model *m = &plan.model[plan.chosen];
    assert_true(strncmp(m->name, "header: ", 8) == 0);
    assert_true(m->elsewhere > 0 && m->elsewhere <= plan.tolerance && m->worst >= m->elsewhere);
    assert_string_equal(m->use, "corgen embed --speed-min 0.01 --speed-max 1 --tolerance 1e-3 --g-star 400 "
                                "--end zero-force --for balanced --output cor_scene_eps.h\n"
                                "#include \"cor_scene_eps.h\"\ndouble eps = cor_scene_eps(speed);\n");
    /* the error stated for the library is not below its actual error */
    struct cor_sphere_contact contact;
    assert_int_equal(cor_sphere_contact_init_g_star(&contact, G_STAR), COR_OK);
    m = named(&plan, "library");
    for (slong i = 0; i <= last; i++)
        assert_true(fabs(cor_contact_eps_zero_force(&contact, plan.speed[i]) / plan.truth[i] - 1) <= m->error[i]);
    assert_true(m->worst < 1e-14 && m->cost == (4.4 + 4 * 2.2) / 5); /* a call costs 4.4, a number in a loop 2.2 */
    /* `elsewhere`, the error that corgen embed found between the points, decides too */
    struct plan_model *written = &plan.model[plan.chosen];
    const double found = written->elsewhere;
    plan.tolerance = 2 * found;
    for (int k = 0; k < 2; k++) {
        written->elsewhere = k == 0 ? 3 * found : found;
        plan_choose(&plan);
        assert_true((written->verdict == PLAN_MISSES) == (k == 0));
    }
    /* a cheaper model has a larger error; if a constant is good enough, it is chosen */
    plan.tolerance = 0.2;
    plan_choose(&plan);
    assert_true(plan.model[plan.chosen].cost == 0);
    check_choice(&plan, &draw);
    plan_clear(&plan);
}

/* A ball on a floor: every model is compared with collisions under gravity. Formulas and the library's functions of
 * beta ignore gravity; the header and cor_scene_eps include it. Tsuji's law has no header. Without damping eps is 1. */
TEST(test_gravity)
{
    static const struct {
        int law, end;
        const char *damping, *chosen;
    } scenes[] = {{COR_LAW_VISCOELASTIC, END_SURFACE, "1e-3", "header: "},
                  {COR_LAW_HERTZ_DASHPOT, COR_END_ZERO_OVERLAP, "0.4", "header: "},
                  {COR_LAW_TSUJI, END_SURFACE, "0.1", "library: cor_scene_eps"},
                  {COR_LAW_VISCOELASTIC, END_SURFACE, "0", "constant eps"}};
    for (size_t k = 0; k < COUNT_OF(scenes); k++) {
        if (!in_turn(k, 4))
            continue;
        const int number[] = {[COR_LAW_VISCOELASTIC] = COR_SCENE_DISSIPATION_TIME,
                              [COR_LAW_HERTZ_DASHPOT] = COR_SCENE_DAMPING_COEFFICIENT,
                              [COR_LAW_TSUJI] = COR_SCENE_ZETA};
        struct embed_request request =
            request_of("0.1", "2", "1e-3", scenes[k].end,
                       GIVEN({COR_SCENE_YOUNG, "1e6"}, {COR_SCENE_POISSON, "0.3"}, {COR_SCENE_RADIUS, "0.01"},
                             {COR_SCENE_DENSITY, "1000"}, {number[scenes[k].law], scenes[k].damping},
                             {COR_SCENE_GRAVITY, "9.81"}));
        request.wall = true;
        request.law = scenes[k].law;
        struct embed_request bare = request;
        struct contacts contacts, pressed;
        struct plan plan;
        const int end = scenes[k].end == COR_END_ZERO_OVERLAP ? COR_END_ZERO_OVERLAP : COR_END_ZERO_FORCE;
        bare.number[COR_SCENE_GRAVITY].text = NULL;
        bare.end = end;
        assert_int_equal(contacts_of_request(&contacts, &bare), STATUS_OK);
        assert_int_equal(contacts_of_request(&pressed, &request), STATUS_OK);
        assert_int_equal(plan_spheres(&plan, &bare, contacts.contact, &request, pressed.contact, 3), STATUS_OK);
        const struct plan_model *const chosen = &plan.model[plan.chosen];
        check(strncmp(chosen->name, scenes[k].chosen, strlen(scenes[k].chosen)) == 0, "%s", chosen->name);
        for (slong i = 0; i < 3; i++) {
            double eps[2], without;
            for (int at = 0; at < 2; at++)
                assert_int_equal(cor_scene_eps(&eps[at], pressed.contact, plan.speed[i], at), 0);
            assert_int_equal(cor_scene_eps(&without, contacts.contact, plan.speed[i], end), 0);
            check_near(plan.truth[i], eps[end], 1e-11);
            check_values(&plan, "the other end", i, eps[1 - end], 1e-11);
            check(fabs(chosen->value[i] / eps[end] - 1) <= 1e-3, "%s: %g", chosen->name, chosen->value[i]);
            for (int m = 0; m < plan.models; m++)
                if (strstr(plan.model[m].name, "library: cor_") && plan.model[m].value[i] != plan.truth[i]) {
                    check_near(plan.model[m].value[i], without, 1e-11);
                    check_near(plan.model[m].error[i], fabs(without / eps[end] - 1), 1e-6);
                    assert_true(m != plan.chosen && !strcmp(plan.model[m].leaves_out, "the constant force"));
                }
        }
        assert_true(
            !strstr(chosen->name, "header") ||
            (strstr(chosen->use, "--gravity 9.81") && strstr(chosen->use, contact_end_options_pressed[scenes[k].end])));
        plan_clear(&plan);
        request_clear(&request);
    }
}

/* Above beta = 7, eps at zero overlap is h*^5/beta^5. */
TEST(test_strong_damping)
{
    leave_to_turn(1, 3);
    struct plan plan;
    struct cor_sphere_contact contact;
    plan_of(&plan, "0.2", "0.8", "1e-6", "1e-5", COR_END_ZERO_OVERLAP, 3);
    assert_int_equal(cor_sphere_contact_init_g_star(&contact, 1e-5), COR_OK);
    assert_true(plan.at[0] < 7 && plan.at[1] > 7);
    for (slong i = 0; i < plan.points; i++)
        assert_true(fabs(cor_contact_eps_zero_overlap(&contact, plan.speed[i]) / plan.truth[i] - 1) < 1e-14);
    plan_clear(&plan);
}

/* ---- disks ---- */

static void plan_of_disks(struct plan *plan, enum plan_quantity quantity, const char *min, const char *max, slong count)
{
    struct embed_request request = request_of(min, max, "0.01", 0, GIVEN({COR_SCENE_POISSON, "0.33"}));
    assert_int_equal(plan_disks(plan, &request, quantity, count), STATUS_OK);
    request_clear(&request);
}

static double collided(size_t modes, double alpha, double speed, enum plan_quantity quantity)
{
    const struct cor_disk_collision_options options = {alpha, 1e-7, 0, 0};
    struct cor_disk_collision out;
    assert_int_equal(cor_disk_collision(&cor_disk_modes_nu033, modes, &options, speed, &out), COR_OK);
    return quantity == PLAN_EPS ? out.eps : quantity == PLAN_CONTACT_TIME ? out.contact_time : out.max_compression;
}

static struct cor_disk_hard_wall at_rigid_wall(double tolerance, double speed)
{
    const struct cor_disk_hard_wall_options options = {tolerance, 0};
    struct cor_disk_hard_wall out;
    assert_int_equal(cor_disk_hard_wall_nu(0.33, &options, speed, &out), COR_OK);
    return out;
}

/* Returns the error of a disk model between the points, relative to the library's own table. */
static double disk_error(const struct plan_model *m, double speed)
{
    size_t modes;
    double hard, tolerance, value = 1;
    if (sscanf(m->name, "rigid wall: tolerance %lf", &tolerance) == 1)
        value = at_rigid_wall(tolerance, speed).eps;
    else if (sscanf(m->name, "dynamics: %zu modes; alpha = %lf/v", &modes, &hard) == 2)
        value = collided(modes, fmax(40, hard / speed), speed, PLAN_EPS);
    else
        assert_int_equal(sscanf(m->use, "double eps = %lf;", &value), 1);
    return fabs(value - cor_disk_eps(speed, 0.33));
}

TEST(test_disks)
{
    leave_to_turn(0, 3);
    struct plan plan;
    plan_of_disks(&plan, PLAN_EPS, "0.01", "0.1", 3);
    assert_string_equal(plan.model[plan.chosen].name, "table: cor_disk_eps");
    for (slong i = 0; i < plan.points; i++) {
        const double eps = cor_disk_eps(plan.speed[i], 0.33), speed = plan.speed[i];
        check(fabs(plan.truth[i] - eps) <= plan.uncertainty[i] + cor_disk_eps_uncertainty(speed, 0.33),
              "eps(%g) = %.6g, uncertain by %.2g; the table has %.6g", speed, plan.truth[i], plan.uncertainty[i], eps);
        const struct cor_disk_hard_wall truth = at_rigid_wall(1e-4, speed);
        check_near(plan.uncertainty[i], truth.error_estimate / (2 * truth.eps), 1e-6);
        assert_true(same_bits(named(&plan, "table")->value[i], eps));
        assert_true(cor_disk_eps_uncertainty(speed, 0.33) <= named(&plan, "table")->error[i] * 1.01);
        assert_true(named(&plan, "eps = 1")->error[i] == 1 - plan.truth[i]);
        check_values(&plan, "dynamics: 300 modes; alpha = 56/v", i, collided(300, 56 / speed, speed, PLAN_EPS), 2e-6);
        check_values(&plan, "dynamics: 940 modes; alpha = 500", i, collided(940, 500, speed, PLAN_EPS), 2e-6);
        /* the reference values, within the error that the tolerance allows */
        check_values(&plan, "rigid wall: tolerance 1e-05", i, plan.truth[i], 0);
        check(fabs(at_rigid_wall(1e-5, speed).eps - plan.truth[i]) <=
                  plan.uncertainty[i] + named(&plan, "rigid wall: tolerance 1e-05")->error[i],
              "eps(%g) = %.9f, uncertain by %.2g", speed, plan.truth[i], plan.uncertainty[i]);
        struct cor_disk_rayleigh out;
        const int status =
            cor_disk_rayleigh(&cor_disk_modes_nu033, 1800, COR_DISK_DATUM_CENTRE_OF_MASS, speed, &out, NULL);
        assert_true(status == (speed > COR_DISK_RAYLEIGH_MAX_SPEED ? COR_BEYOND_THEORY : COR_OK));
        check_values(&plan, "Rayleigh: 1000", i, sqrt(1 - out.fraction - out.tail), 1e-6);
    }
    assert_true(named(&plan, "Rayleigh: 1000")->verdict == PLAN_OUTSIDE);

    /* without the table, the plan chooses the cheapest collision that meets the tolerance; rejected models miss it */
    named(&plan, "table")->outside = true;
    plan_choose(&plan);
    const struct plan_model *m = &plan.model[plan.chosen];
    assert_true(strncmp(m->name, "dynamics: ", 10) == 0 || strncmp(m->name, "rigid wall: ", 12) == 0);
    for (int i = 0; i < 3; i++) {
        const double speed = random_log(&draw, 0.01, 0.1), error = disk_error(m, speed);
        check(error <= plan.tolerance + cor_disk_eps_uncertainty(speed, 0.33), "%s is off by %.3g at %.17g", m->name,
              error, speed);
    }
    for (int i = 0; i < plan.models; i++) {
        const struct plan_model *other = &plan.model[i];
        if (other->verdict == PLAN_MISSES && other->cost < m->cost)
            assert_true(disk_error(other, plan.speed[other->worst_at]) + 2 * plan.uncertainty[other->worst_at] +
                            cor_disk_eps_uncertainty(plan.speed[other->worst_at], 0.33) >
                        0.97 * plan.tolerance);
    }
    /* for a large tolerance the choice is a constant, or no vibrations at all */
    static const char *const constants[] = {"constant eps", "eps = 1"};
    for (int k = 0; k < 2; k++) {
        named(&plan, "constant eps")->outside = k == 1;
        plan.tolerance = k == 0 ? 0.03 : 0.08;
        plan_choose(&plan);
        m = &plan.model[plan.chosen];
        assert_string_equal(m->name, constants[k]);
        for (int i = 0; i < 20; i++)
            assert_true(disk_error(m, random_log(&draw, 0.01, 0.1)) <= plan.tolerance);
    }
    check_choice(&plan, &draw);
    plan_clear(&plan);
}

/* A model that has no value at one of the speeds, the first and the last included */
TEST(test_missing_value)
{
    for (slong missing = 0; missing < 4; missing++) {
        struct plan plan;
        plan_init(&plan, 4, 0.1, 1);
        plan.tolerance = 1e-3;
        struct plan_model *const model = plan_add(&plan, "model %d", 1);
        for (slong i = 0; i < 4; i++) {
            plan.truth[i] = 0.5;
            if (i != missing)
                model->value[i] = 0.5;
        }
        plan_model_is(&plan, model, 1, "", NULL);
        plan_choose(&plan);
        assert_true(model->verdict == PLAN_OUTSIDE && model->worst_at == missing && plan.chosen == -1);
        plan_clear(&plan);
    }
}

TEST(test_contact_time)
{
    leave_to_turn(2, 3);
    static const char *const law[] = {"quasistatic law: centre of mass", "quasistatic law: diameter",
                                      "quasistatic law: as printed"};
    struct plan plan;
    plan_of_disks(&plan, PLAN_CONTACT_TIME, "0.01", "0.02", 2);
    for (slong i = 0; i < plan.points; i++) {
        const double speed = plan.speed[i];
        for (int k = 0; k < 3; k++)
            check_values(&plan, law[k], i, cor_disk_contact_time(speed, 0.33, (enum cor_disk_datum)k), 1e-15);
        check_values(&plan, "leading logarithm", i, acos(-1) * sqrt(log(4 / speed)), 1e-14);
        check_values(&plan, "dynamics: 1800 modes; alpha = 22/v", i,
                     collided(1800, 22 / speed, speed, PLAN_CONTACT_TIME), 1e-4);
        for (int k = 0; k < plan.models; k++)
            assert_true(fabs(plan.model[k].error[i] - fabs(plan.model[k].value[i] / plan.truth[i] - 1)) < 1e-15);
        const double hard = collided(1800, 60 / speed, speed, PLAN_CONTACT_TIME);
        const double harder = collided(1800, 100 / speed, speed, PLAN_CONTACT_TIME);
        const double limit = harder + (harder - hard) * 60 / (100 - 60);
        /* the contact ends at 1/1000 of the largest load for `limit`, at a rigid wall with the last touch */
        check(fabs(limit / plan.truth[i] - 1) <= 0.015, "tau(%g) = %g, from two walls %g", speed, plan.truth[i], limit);
        check(fabs(at_rigid_wall(3e-6, speed).contact_time / plan.truth[i] - 1) <= plan.uncertainty[i],
              "tau(%g) = %g, uncertain by %.2g", speed, plan.truth[i], plan.uncertainty[i]);
        check_near(plan.uncertainty[i], 2 * fabs(at_rigid_wall(1e-3, speed).contact_time / plan.truth[i] - 1), 1e-6);
    }
    plan.tolerance = 0.1; /* a contact law without modes meets it */
    plan_choose(&plan);
    assert_true(strncmp(plan.model[plan.chosen].name, "leading", 7) == 0 ||
                strncmp(plan.model[plan.chosen].name, "quasistatic", 11) == 0);
    plan_clear(&plan);
}

/* The plan states the energy that a glass sphere loses to elastic waves at a wall. */
TEST(test_waves)
{
    static const struct {
        const char *young, *poisson, *compared;
        double speed, eps;
    } walls[] = {{"7e10", "0.25", "gives 0.19. A measured dissipation time includes the waves.", 2, 0.9},
                 {"7e10", "0.25", "gives 0.0002. This is less", 2, 0.9999},
                 {"2e11", "0.3", "", 0.01, 0.9},
                 {"1e6", "0.49", "", 0.01, 0.9},
                 {"3e9", "0.5", "", 0.01, 0.9},
                 {"4e10", "0", "", 0.01, 0.9},
                 {"1e10", "-0.5", "", 0.01, 0.9}};
    for (size_t i = 0; i < COUNT_OF(walls); i++) {
        const double young = strtod(walls[i].young, NULL), nu = strtod(walls[i].poisson, NULL);
        const struct cor_body sphere = {7e10, 0.25, 0, 0.005, cor_sphere_mass_kg(0.005, 2500)},
                              wall = {young, nu, 0, INFINITY, INFINITY};
        const struct cor_half_space half_space = {young, nu, 2500};
        struct cor_sphere_contact contact;
        struct embed_request request = {.wall = true};
        char expected[100];
        request_give(&request, GIVEN({COR_SCENE_YOUNG, "7e10"}, {COR_SCENE_POISSON, "0.25"},
                                     {COR_SCENE_RADIUS, "0.005"}, {COR_SCENE_DENSITY, "2500"},
                                     {COR_SCENE_YOUNG_2, walls[i].young}, {COR_SCENE_POISSON_2, walls[i].poisson}));
        assert_int_equal(cor_sphere_contact_init(&contact, &sphere, &wall), COR_OK);
        snprintf(expected, sizeof expected, "1 - eps^2 = %.2g at %g m/s",
                 cor_contact_wave_loss(&contact, &half_space, walls[i].speed), walls[i].speed);
        char *const remark = plan_wave_remark(&request, walls[i].speed, walls[i].eps);
        assert_true(strstr(remark, expected) && strstr(remark, walls[i].compared));
        free(remark);
        request.wall = false;
        assert_null(plan_wave_remark(&request, 1, 0.5));
        request.wall = true;
        decimal_set(&request.number[COR_SCENE_G_STAR], "1");
        assert_null(plan_wave_remark(&request, 1, 0.5));
        request_clear(&request);
    }
}
