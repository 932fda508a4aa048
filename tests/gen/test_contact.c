/* SPDX-License-Identifier: MIT */
/* Tests cor/scene.h and gen/contact against an integration of the force in SI units and against textbook formulas.
 * Converts every specification of the dissipation to every other one and back, and every number of corgen contact --for
 * as its simulator does. */
#include "../reference/ode.h"
#include "ball.h"
#include "scene.h"

#include "contact/contact.h"
#include "cor/law.h"
#include "cor/sphere.h"
#include "enclosure/collision.h"
#include "runtime/scene/simulators.h"

/* ---- the force in SI units, integrated ---- */

struct law_of_force {
    double mass, speed;
    double unit; /* unit of time; the unit of length is speed * unit */
    double a, b;
    long double elastic, damping; /* elastic force at a unit of length; damping force there at 1 m/s */
};

enum { ROOT = 4 /* x = w^4 units of length, so exponents of x may be multiples of 1/4 */ };

static struct law_of_force force_law(double mass, double stiffness, double coefficient, double a, double b,
                                     double speed)
{
    const double unit = pow(mass / stiffness, 1 / (a + 1)) * pow(speed, (1 - a) / (1 + a));
    return (struct law_of_force){
        mass, speed, unit, a, b, stiffness * powl(speed * unit, a), coefficient * powl(speed * unit, b)};
}

static long double force_of(long double w, long double v, const void *of)
{
    const struct law_of_force *const f = of;
    return (f->elastic * motion_power(w, (int)(ROOT * f->a)) +
            f->damping * motion_power(w, (int)(ROOT * f->b)) * v * f->speed) *
           f->unit / (f->mass * f->speed);
}

/* Integrates an impact. zero_overlap: until zero overlap, which strong damping delays; false: until zero force */
static struct cor_scene_impact integrate(const struct law_of_force *f, bool zero_overlap)
{
    const struct motion m = {.d = ROOT, .force = force_of, .of = f, .at_zero_force = !zero_overlap};
    const struct motion_course r = motion_course(&m);
    return (struct cor_scene_impact){
        .eps = {(double)r.eps[0], (double)r.eps[1]},
        .duration_s = {(double)r.duration[0] * f->unit, (double)r.duration[1] * f->unit},
        .max_overlap_m = (double)r.max_overlap * f->speed * f->unit,
    };
}

/* Compares an impact with the integration, and the largest force with an enclosed collision. Skips fields that are zero
 * and ends that the integration does not reach. */
static void against_integration(const struct cor_scene_impact *got, double force,
                                const struct cor_scene_contact *contact, double speed, double peak_error,
                                double end_error)
{
    const struct cor_exponents law = contact->law;
    const struct law_of_force f =
        force_law(contact->mass_kg, contact->stiffness, cor_scene_damping(contact, COR_SCENE_DAMPING_COEFFICIENT),
                  ratio_double(law_elastic(&law)), ratio_double(law_damping(&law)), speed);
    const struct cor_scene_impact want = integrate(&f, got->duration_s[0] > 0 && isfinite(got->duration_s[0]));
    LOCAL(arb, beta, most);
    arb_set_d(beta, cor_scene_beta(contact, speed));
    assert_int_equal(collision_force_max(most, beta, &law, 64), 0);
    check_near(force, middle(most) * f.mass * speed / f.unit, peak_error);
    check_near(got->max_overlap_m, want.max_overlap_m, peak_error);
    for (int end = 0; end < COR_SCENE_ENDS; end++)
        if (isfinite(want.duration_s[end]) && got->duration_s[end] > 0) {
            check_near(got->eps[end], want.eps[end], end_error);
            check_near(got->duration_s[end], want.duration_s[end], end_error);
        }
}

TEST(impacts_against_integration)
{
    static const struct {
        struct cor_exponents law;
        double zeta_or_beta;
    } row[] = {{{3, 1, 2}, 0.3}, {{3, 1, 2}, 2},   {{1, 0, 1}, 0.2}, {{1, 0, 1}, 0.45}, {{6, 1, 4}, 0.4},
               {{3, 3, 2}, 1.5}, {{3, 0, 2}, 0.2}, {{3, 0, 2}, 0.7}, {{4, 1, 2}, 0.3},  {{2, 1, 1}, 1.1},
               {{1, 1, 1}, 2},   {{2, 1, 2}, 1},   {{1, 0, 1}, 0.8}, {{6, 1, 4}, 1.7},  {{6, 1, 4}, 1}};
    for (size_t i = 0; i < COUNT_OF(row); i++) {
        const struct cor_exponents law = row[i].law;
        const double speed = random_log(&draw, 0.01, 10);
        struct cor_scene_contact contact = {.law = law,
                                            .mass_kg = random_log(&draw, 1e-6, 1),
                                            .stiffness = random_log(&draw, 1e3, 1e9),
                                            .solver = contact_enclosed};
        const int way = cor_scene_speed_exponent(&contact) == 0 ? COR_SCENE_ZETA : COR_SCENE_BETA;
        assert_int_equal(cor_scene_set_damping(&contact, way, row[i].zeta_or_beta, speed, 0), 0);
        const struct cor_scene_impact got = scene_impact(&contact, speed);
        against_integration(&got, cor_scene_force_max_n(&contact, speed), &contact, speed, COR_SCENE_MAX_ERROR / 10,
                            1e-9);
        for (int end = 0; end < COR_SCENE_ENDS; end++)
            check_near(got.eps[end], scene_eps(&contact, speed, end), 1e-14);
    }
}

/* The digits of docs/data/reference_collisions.csv were proved by corgen collide. The functions of cor/scene.h and the
 * integration must agree with them. */
TEST(reference_collisions)
{
    enum { ROWS = 200, NUMBERS = 9, RESULTS = 4 };
    char line[1024], law[32], end_name[32];
    FILE *const file = fopen("docs/data/reference_collisions.csv", "r");
    assert_true(file && fgets(line, sizeof line, file));
    size_t rows = 0;
    for (; fgets(line, sizeof line, file); rows++) {
        double n[NUMBERS], r[RESULTS];
        assert_int_equal(sscanf(line, "%31[^,],%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%31[^,],%lf,%lf,%lf,%lf", law, &n[0],
                                &n[1], &n[2], &n[3], &n[4], &n[5], &n[6], &n[7], &n[8], end_name, &r[0], &r[1], &r[2],
                                &r[3]),
                         2 + NUMBERS + RESULTS);
        int i = 0;
        while (strcmp(cor_law_name((enum cor_law)i), law) != 0)
            assert_true(++i < COR_LAW_PLATE);
        struct cor_scene_contact contact = {
            .law = cor_law_exponents[i], .mass_kg = 1 / (1 / n[2] + 1 / n[3]), .stiffness = n[0]};
        if (i != COR_LAW_LINEAR)
            check_near(4.0 / 3 * n[6] / (2 * (1 - n[7] * n[7])) * sqrt(1 / (1 / n[4] + 1 / n[5])), n[0], 1e-15);
        assert_int_equal(cor_scene_set_damping(&contact, COR_SCENE_DAMPING_COEFFICIENT, n[1], 1, 0), 0);
        const int end = strcmp(end_name, "zero-force") == 0 ? COR_END_ZERO_FORCE : COR_END_ZERO_OVERLAP;
        assert_true(end == COR_END_ZERO_FORCE ||
                    strcmp(end_name, cor_scene_ends_differ(&contact) ? "zero-overlap" : "both") == 0);
        const struct cor_scene_impact got = scene_impact(&contact, n[8]);
        struct cor_scene_impact proved = {.max_overlap_m = r[2]};
        proved.eps[end] = r[0];
        proved.duration_s[end] = r[1];
        if (r[0] == 0) { /* the bodies never part */
            assert_true(got.eps[end] == 0 && isinf(got.duration_s[end]) && isinf(r[1]));
        } else {
            check_near(got.eps[end], r[0], COR_SCENE_MAX_ERROR);
            check_near(got.duration_s[end], r[1], COR_SCENE_MAX_ERROR);
        }
        check_near(got.max_overlap_m, r[2], COR_SCENE_MAX_ERROR);
        check_near(cor_scene_force_max_n(&contact, n[8]), r[3], COR_SCENE_MAX_ERROR);
        if (in_turn(rows, 10))
            /* the last argument is larger because zero force and zero overlap nearly coincide for weak damping */
            against_integration(&proved, r[3], &contact, n[8], COR_SCENE_MAX_ERROR, 1e-5);
    }
    assert_int_equal(rows, ROWS);
    fclose(file);
}

/* ---- ways to give a contact ---- */

struct given {
    int number; /* COR_SCENE_NUMBERS ends the list */
    double value;
};
#define GIVEN(...) ((const struct given[]){__VA_ARGS__, {COR_SCENE_NUMBERS, 0}})
#define GLASS                                                                                                          \
    GIVEN({COR_SCENE_YOUNG, 7e10}, {COR_SCENE_POISSON, 0.2}, {COR_SCENE_RADIUS, 5e-3}, {COR_SCENE_DENSITY, 2500})
#define SPRING GIVEN({COR_SCENE_STIFFNESS, 1e5}, {COR_SCENE_EFFECTIVE_MASS, 1e-3})

/* Returns the contacts of a scene with the numbers of two lists. */
static struct contacts contacts_of(int law, int end, const struct given *bodies, const struct given *given)
{
    struct cor_scene_fault fault;
    struct contacts c = {.scene = scene_without_numbers((enum cor_law)law)};
    c.scene.plate = law == COR_LAW_PLATE;
    c.scene.end = end;
    c.scene.solver = contact_enclosed;
    for (; bodies->number < COR_SCENE_NUMBERS; bodies++)
        c.scene.number[bodies->number] = bodies->value;
    for (; given->number < COR_SCENE_NUMBERS; given++)
        c.scene.number[given->number] = given->value;
    assert_int_equal(cor_scene_contacts(c.contact, &c.count, &fault, &c.scene), 0);
    return c;
}

/* From K and C follow eps and duration of a collision. Any two of these numbers that determine the collision must give
 * K and C again. Weak damping hardly affects the duration at zero overlap, so the damping from it is less accurate. */
TEST(any_two_give_the_rest)
{
    enum {
        K = COR_SCENE_STIFFNESS,
        C = COR_SCENE_DAMPING_COEFFICIENT,
        T = COR_SCENE_DURATION,
        E = COR_SCENE_RESTITUTION,
        A = COR_SCENE_DISSIPATION_TIME,
        RATIO = COR_SCENE_NUMBERS
    };
    static const struct cor_exponents laws[] = {{3, 1, 2}, {1, 0, 1}, {6, 1, 4}, {3, 3, 2}, {3, 0, 2},
                                                {1, 1, 1}, {2, 1, 1}, {4, 1, 2}, {2, 1, 2}, {5, 1, 4}};
    static const int pair[][2] = {{K, T}, {C, T}, {A, T}, {E, T},     {RATIO, T}, {K, C},
                                  {K, E}, {C, E}, {A, E}, {C, RATIO}, {A, RATIO}};
    for (size_t i = 0; i < COUNT_OF(laws) * COUNT_OF(pair); i++)
        for (int k = 0; k < 6; k++) {
            const int end = k % COR_SCENE_ENDS, *const two = pair[i / COUNT_OF(laws)];
            const double speed = pow(10, k - 3), eps = 0.95 - 0.15 * k;
            struct cor_scene_fault fault;
            struct cor_scene scene = scene_without_numbers(COR_LAW_VISCOELASTIC);
            struct cor_scene_contact got[COR_SCENE_ENDS], want = {.law = laws[i % COUNT_OF(laws)],
                                                                  .mass_kg = 2e-3,
                                                                  .stiffness = 4e6,
                                                                  .radius_m = NAN,
                                                                  .damping = NAN,
                                                                  .solver = contact_enclosed};
            int count;
            const bool sphere = i % COUNT_OF(laws) == 0, enclosed = i % COUNT_OF(laws) > 5 && two[0] != E;
            if ((two[0] == A && (!sphere || (two[1] == T && end == 0))) || (enclosed && !in_turn(i + (size_t)k, 9)))
                continue;
            assert_int_equal(cor_scene_set_damping(&want, E, eps, speed, end), 0);
            const struct cor_scene_impact impact = scene_impact(&want, speed);
            const double
                zeta = cor_scene_damping(&want, COR_SCENE_ZETA),
                value[] = {
                    [K] = want.stiffness,          [C] = cor_scene_damping(&want, C), [T] = impact.duration_s[end],
                    [E] = impact.eps[end],         [A] = cor_scene_damping(&want, A), [COR_SCENE_ZETA] = zeta,
                    [COR_SCENE_BETA] = impact.beta};
            scene.law = want.law;
            scene.end = end;
            scene.solver = contact_enclosed;
            scene_give(scene, {COR_SCENE_EFFECTIVE_MASS, want.mass_kg});
            for (int n = 0; n < 2; n++) {
                const int number = two[n] != RATIO ? two[n] : isnan(zeta) ? COR_SCENE_BETA : COR_SCENE_ZETA;
                scene.number[number] = value[number];
                if (number == T || number == E || number == COR_SCENE_BETA)
                    scene.number[COR_SCENE_AT] = speed;
            }
            const double error = two[0] == K && two[1] == T ? 1e-12 / ((1 - eps) * (1 - eps)) : 1e-11;
            assert_int_equal(cor_scene_contacts(got, &count, &fault, &scene), 0);
            check_near(got[0].stiffness, value[K], error);
            check_near(cor_scene_damping(&got[0], C), value[C], error);
        }
    /* without damping and without --end: one contact for each end, with the given duration at that end */
    const double a = 1.5, elastic = cor_hunt_crossley_duration(0, a);
    const struct contacts tsuji =
        contacts_of(COR_LAW_TSUJI, COR_BOTH_ENDS, GIVEN({COR_SCENE_EFFECTIVE_MASS, 2e-3}, {T, 1e-3}),
                    GIVEN({COR_SCENE_ZETA, 0}, {COR_SCENE_AT, 3}));
    assert_int_equal(tsuji.count, COR_SCENE_ENDS);
    check_near(tsuji.contact[1].stiffness, 2e-3 * pow(elastic / 1e-3, 2.5) / sqrt(3), 1e-13);
}

/* Integrates the tangential motion of the contact point, of mass (2/7) m, over the contact by Runge-Kutta. */
TEST(tangential_restitution)
{
    for (int k = 0; k < 6; k++) {
        const int end = k % COR_SCENE_ENDS;
        const double e = 1 - 0.19 * k, mass = 2.0 / 7 * 1e-3;
        const struct contacts c = contacts_of(COR_LAW_LINEAR, end, SPRING, GIVEN({COR_SCENE_RESTITUTION, 0.6}));
        double spring, dashpot, s = 0, u = 1;
        assert_int_equal(cor_scene_tangential(&spring, &dashpot, c.contact, e, end), 0);
        const double h = scene_impact(c.contact, 1).duration_s[end] / 1000;
        for (int i = 0; i < 1000; i++) {
            double ds[4], du[4];
            for (int r = 0; r < 4; r++) {
                const double at = r == 0 ? 0 : r == 3 ? h : h / 2;
                ds[r] = u + (r ? at * du[r - 1] : 0);
                du[r] = -(spring * (s + (r ? at * ds[r - 1] : 0)) + dashpot * ds[r]) / mass;
            }
            s += h / 6 * (ds[0] + 2 * ds[1] + 2 * ds[2] + ds[3]);
            u += h / 6 * (du[0] + 2 * du[1] + 2 * du[2] + du[3]);
        }
        check_near(u, -e, 1e-10);
        assert_true(cor_scene_tangential(&spring, &dashpot, c.contact, k % 2 ? 1.1 : 0, end) && isnan(spring));
    }
}

/* The linear spring with the energy or the duration of Hertz's elastic contact, which is integrated here */
TEST(equivalent_springs)
{
    for (int k = 0; k < 6; k++) {
        const double speed = random_log(&draw, 0.01, 10), young = random_log(&draw, 1e6, 1e11);
        struct cor_scene spring, scene = scene_without_numbers(COR_LAW_LINEAR);
        struct cor_scene_contact hertz;
        struct cor_scene_fault fault;
        scene.wall = k > 3;
        scene_give(scene, {COR_SCENE_YOUNG, young}, {COR_SCENE_POISSON, 0.3}, {COR_SCENE_RADIUS, 2e-3},
                   {COR_SCENE_MASS, 1e-4}, {COR_SCENE_RESTITUTION, 0.7}, {COR_SCENE_AT, speed});
        assert_int_equal(cor_scene_equivalent(&spring, &hertz, &fault, &scene, 1 + k % 2), 0);
        const double m = k > 3 ? 1e-4 : 5e-5, radius = k > 3 ? 2e-3 : 1e-3;
        const struct law_of_force f =
            force_law(m, 4.0 / 3 * young / (2 * (1 - 0.09)) * sqrt(radius), 0, 1.5, 0.5, speed);
        const struct cor_scene_impact elastic = integrate(&f, true);
        const double time = sqrt(m / spring.number[COR_SCENE_STIFFNESS]), pi = 3.14159265358979323846;
        check_near(k % 2 ? pi * time : speed * time, k % 2 ? elastic.duration_s[0] : elastic.max_overlap_m, 1e-9);
        assert_true(spring.number[COR_SCENE_EFFECTIVE_MASS] == m && isnan(spring.number[COR_SCENE_YOUNG]));
    }
}

TEST(other_laws)
{
    const struct cor_scene_contact linear =
        contacts_of(COR_LAW_LINEAR, COR_END_ZERO_OVERLAP, SPRING, GIVEN({COR_SCENE_RESTITUTION, 0.7})).contact[0];
    const double l = -log(0.7), pi = 3.14159265358979323846, zeta = l / sqrt(pi * pi + l * l);
    check_near(cor_scene_damping(&linear, COR_SCENE_ZETA), zeta, 1e-14);
    check_near(cor_scene_damping(&linear, COR_SCENE_DAMPING_COEFFICIENT), 2 * zeta * sqrt(1e5 * 1e-3), 1e-14);
    check_near(scene_impact(&linear, 2).duration_s[0], pi / sqrt(1 - zeta * zeta) * sqrt(1e-3 / 1e5), 1e-14);
    assert_true(isnan(cor_scene_damping(&linear, COR_SCENE_G_STAR)) &&
                isnan(cor_scene_damping(&linear, COR_SCENE_DISSIPATION_TIME)));
    /* Zener's plate: A = m/(8 sqrt(B rho h)), the force is K x^(3/2), and zero overlap is the only end */
    const struct cor_scene_contact plate =
        contacts_of(COR_LAW_PLATE, COR_BOTH_ENDS, GLASS,
                    GIVEN({COR_SCENE_PLATE_THICKNESS, 2e-3}, {COR_SCENE_DENSITY_2, 2700}))
            .contact[0];
    const double bending = 7e10 * 8e-9 / (12 * (1 - 0.04)), mass = 4 * pi / 3 * 125e-9 * 2500;
    check_near(cor_scene_damping(&plate, COR_SCENE_DISSIPATION_TIME), mass / (8 * sqrt(bending * 2700 * 2e-3)), 1e-13);
    const struct cor_scene_impact impact = scene_impact(&plate, 1);
    assert_true(isnan(impact.eps[COR_END_ZERO_FORCE]) && isnan(impact.duration_s[COR_END_ZERO_FORCE]));
    check_near(cor_scene_force_max_n(&plate, 1), plate.stiffness * pow(impact.max_overlap_m, 1.5), 1e-13);
    /* for a law that needs enclosed collisions, a restitution is refused without a solver */
    struct cor_scene_contact power = {.law = {2, 1, 1}, .mass_kg = 1e-3, .stiffness = 1e5, .solver = contact_enclosed};
    assert_int_equal(cor_scene_set_damping(&power, COR_SCENE_RESTITUTION, 0.3, 0.5, COR_END_ZERO_FORCE), 0);
    check_near(scene_eps(&power, 0.5, COR_END_ZERO_FORCE), 0.3, 1e-14);
    assert_int_equal(cor_scene_set_damping(&power, COR_SCENE_RESTITUTION, 1, 0.5, COR_END_ZERO_FORCE), 0);
    assert_true(power.damping == 0);
    power.solver = NULL;
    assert_int_equal(cor_scene_set_damping(&power, COR_SCENE_RESTITUTION, 0.3, 0.5, COR_END_ZERO_FORCE),
                     COR_FAULT_SOLVER);
}

/* ---- a constant force: enclosed collisions against the integration in doubles ---- */

static int stuck, held, parted; /* numbers of scenes; check_pressed counts them */

static void check_pressed(const struct cor_exponents *exponents, double damping, double force_n, double speed)
{
    const struct cor_exponents law = *exponents;
    const struct cor_scene_contact contact = scaled_contact(exponents, damping, force_n);
    LOCAL(arb, beta, force, newton);
    LOCAL(collision, c);
    const struct cor_scene_impact impact = scene_impact(&contact, speed);
    const struct ratio a = law_elastic(&law), q = law_speed_exponent(&law);
    arb_set_d(beta, damping);
    arb_set_d(force, speed);
    arb_set_d(newton, force_n);
    LET(beta, 300, "beta*force^q", beta, force, q);
    LET(force, 300, "newton*force^(-2*a/(a + 1))", newton, force, a);
    assert_int_equal(collision_solve_pressed(c, beta, force, &law, COR_BOTH_ENDS, 60), 0);
    const double eps[] = {middle(c->eps_zero_overlap), middle(c->eps_zero_force)};
    const double unit = pow(speed, (1 - ratio_double(a)) / (1 + ratio_double(a)));
    const double time[] = {middle(c->t_zero_overlap) * unit, middle(c->t_zero_force) * unit};
    check_near(impact.max_overlap_m, middle(c->x_max) * unit * speed, 1e-12);
    for (int end = 0; end < COR_SCENE_ENDS; end++) {
        check(fabs(impact.eps[end] * impact.eps[end] - eps[end] * eps[end]) < COR_SCENE_PRESSED_ERROR,
              "law %d/%d, damping %g, force %g, speed %.17g, end %d: %.17g, not %.17g", exponents->elastic,
              exponents->damping, damping, force_n, speed, end, impact.eps[end], eps[end]);
        if (eps[end] > 0.01)
            check_near(impact.duration_s[end], time[end], COR_SCENE_PRESSED_ERROR);
        assert_true((impact.eps[end] == 0) == (isinf(impact.duration_s[end]) != 0));
        assert_true(damping > 0 || (impact.eps[end] == 1 && eps[end] == 1));
    }
    stuck += isinf(time[0]) != 0; /* never ends at zero overlap */
    held += isinf(time[1]) != 0;  /* never ends at zero force */
    parted += !isinf(time[0]);
}

/* Checks the sticking speed in units in which the force is 1. */
static void check_sticking_speed(const struct cor_exponents *exponents, double damping)
{
    const struct cor_exponents law = *exponents;
    const struct cor_scene_contact contact = scaled_contact(exponents, damping, 1);
    LOCAL(arb, speed, exact);
    arb_set_d(exact, damping);
    for (int end = 0; end < COR_SCENE_ENDS; end++) {
        assert_int_equal(collision_sticking_speed(speed, exact, &law, end, 50), 0);
        assert_bits(speed, 50);
        check_near(cor_scene_sticking_speed(&contact, end), middle(speed), 1e-12);
    }
}

TEST(collisions_under_a_constant_force)
{
    enum { DRAWS = 4 };
    static const struct cor_exponents laws[] = {{3, 1, 2}, {1, 0, 1}, {6, 1, 4}, {3, 3, 2}, {3, 0, 2},
                                                {2, 1, 1}, {2, 1, 2}, {8, 7, 4}, {1, 0, 2}};
    const size_t draws = points(DRAWS);
    size_t cases = 0;
    for (size_t l = 0; l < COUNT_OF(laws); l++) {
        const double a1 = (double)laws[l].elastic / laws[l].denominator + 1;
        EACH (damping, 0, 0.05, 0.5, 2.6) {
            EACH (force, 1e-4, 0.1, 0.5, 2) {
                if (in_turn(cases++, 9))
                    check_pressed(&laws[l], *damping, *force, 1);
            }
        }
        /* large forces, at speeds near the sticking speed */
        for (size_t i = 0; i < draws; i++) {
            const double speed = pow(random_log(&draw, 1, 1e12), -a1 / (2 * a1 - 2));
            check_pressed(&laws[l], i > 0 ? speed * speed * random_log(&draw, 1e-3, 0.5) : 0, 1, speed);
        }
        if (left_to_turn(l, 3))
            continue;
        check_sticking_speed(&laws[l], random_log(&draw, 1e-30, 1e-16));
        check_sticking_speed(&laws[l], random_log(&draw, 1e-16, 0.1));
    }
    check(stuck >= held && held > 5 && parted > 15, "%d %d %d", stuck, held, parted);
}

/* Bodies part at (1 - 2^-60) and stay together at (1 + 2^-60) times the threshold. The backward integration in doubles
 * finds the same threshold. */
TEST(thresholds_of_a_constant_force)
{
    leave_to_turn(1, 3);
    static const struct cor_exponents laws[] = {{3, 1, 2}, {1, 0, 1}, {6, 1, 4}, {3, 0, 2}, {2, 1, 2}};
    LOCAL(arb, beta, force, nearby);
    for (size_t l = 0; l < COUNT_OF(laws); l++)
        for (int end = 0; end < COR_SCENE_ENDS; end++)
            for (double b = 0.05; b < 1; b *= 10) {
                const struct cor_exponents law = laws[l];
                LOCAL(collision, c);
                arb_set_d(beta, b);
                assert_int_equal(collision_sticking_force(force, beta, &law, end, 70), 0);
                assert_bits(force, 70);
                for (int sign = -1; sign <= 1; sign += 2) {
                    LET(nearby, 200, "force*(1 + sign/2^60)", force, sign);
                    arb_get_mid_arb(nearby, nearby);
                    assert_int_equal(collision_solve_pressed(c, beta, nearby, &law, end, 10), 0);
                    const arb_srcptr eps = end == COR_END_ZERO_OVERLAP ? c->eps_zero_overlap : c->eps_zero_force;
                    check(sign > 0 ? arb_is_zero(eps) : arb_is_positive(eps), "law %zu, end %d, beta %g", l, end, b);
                }
                const struct cor_scene_contact contact = scaled_contact(&law, b, middle(force));
                check_near(cor_scene_sticking_speed(&contact, end), 1, 1e-12);
            }
}

/* The time step is the shortest duration of all impacts, divided by the number of steps, in any order of the speeds. */
TEST(the_time_step_is_for_all_speeds)
{
    enum { SPEEDS = 5, STEP_COLUMN = 8 };
    for (int ends = 1; ends <= 2; ends++) {
        const struct contacts contacts = contacts_of(0, ends == 2 ? COR_BOTH_ENDS : COR_END_ZERO_FORCE, GLASS,
                                                     GIVEN({COR_SCENE_RESTITUTION, 0.7}, {COR_SCENE_AT, 0.4}));
        assert_int_equal(contacts.count, ends);
        double speed[SPEEDS], least = INFINITY;
        for (int i = 0; i < SPEEDS; i++)
            speed[i] = random_log(&draw, 1e-3, 10);
        speed[2] = 20; /* the fastest impact, with the shortest contact, is in the middle of the list */
        for (int i = 0; i < SPEEDS * ends; i++) {
            const struct cor_scene_impact impact = scene_impact(&contacts.contact[i / SPEEDS], speed[i % SPEEDS]);
            for (int end = 0; end < COR_SCENE_ENDS; end++)
                least = fmin(least, impact.duration_s[end]);
        }
        struct table table;
        const struct cor_simulator_request request = {.speed_m_s = speed, .speeds = SPEEDS, .steps = 40};
        assert_int_equal(contact_rows(&table, &contacts, &request, 17), 0);
        for (int i = 0; i < SPEEDS * ends; i++)
            check_near(strtod(table.cell[i * table.columns + STEP_COLUMN], NULL), least / 40, 1e-15);
        table_clear(&table);
    }
}

/* The step for a tolerance is the largest allowed step, rounded down to three digits, for all speeds and ends. */
TEST(the_step_for_a_tolerance_is_rounded_down)
{
    enum { TRIES = 6, SPEEDS = 2, STEP_COLUMN = 8 };
    for (int k = 0; k < TRIES; k++) {
        struct contacts contacts =
            contacts_of(0, COR_END_ZERO_OVERLAP, GLASS, GIVEN({COR_SCENE_RESTITUTION, 0.7}, {COR_SCENE_AT, 0.4}));
        const double speed[SPEEDS] = {random_log(&draw, 1e-2, 10), random_log(&draw, 1e-2, 10)};
        const struct cor_scene_contact *const c = &contacts.contact[0];
        const struct cor_simulator_request request = {
            .speed_m_s = speed, .speeds = SPEEDS, .step_errors = 1, .step_tolerance = random_log(&draw, 5e-4, 1e-2)};
        struct table table;
        double longest = INFINITY, steps;
        for (int i = 0; i < SPEEDS; i++) {
            assert_int_equal(cor_scene_step_for(&steps, c, speed[i], 0, request.step_tolerance, 0), 0);
            longest = fmin(longest, cor_scene_elastic_duration_s(c, speed[i]) / steps);
        }
        assert_int_equal(contact_rows(&table, &contacts, &request, 17), 0);
        const double step = strtod(table.cell[STEP_COLUMN], NULL);
        check(step <= longest && step > 0.99 * longest, "tolerance %g: step %.17g, not %.17g", request.step_tolerance,
              step, longest);
        table_clear(&table);
    }
}

/* ---- --for: the numbers in the lines, converted as the simulator does ---- */

#define REQUEST(NAME, CONTACTS, SPEED_M_S)                                                                             \
    (&(const struct cor_simulator_request){.simulator = (NAME),                                                        \
                                           .scene = &(CONTACTS).scene,                                                 \
                                           .contacts = (CONTACTS).contact,                                             \
                                           .count = (CONTACTS).count,                                                  \
                                           .speed_m_s = (SPEED_M_S),                                                   \
                                           .speeds = 1})

/* Counts the models in the text for a host. Checks that the lines of each model contain the number that the host needs
 * for eps, and that this number gives eps. */
static size_t host_realises(const char *host, int law, const struct given *bodies, const struct given *given)
{
    struct contacts contacts = contacts_of(law, COR_BOTH_ENDS, bodies, given);
    const double eps = 0.7, speed = 0.4, pi = 3.14159265358979323846;
    char *const text = contact_simulator_text(REQUEST(host, contacts, &speed)), title[200], form[32];
    if (text && strstr(text, "These lines contain a linear spring instead")) {
        const double m = contacts.contact->mass_kg, t = cor_scene_elastic_duration_s(contacts.contact, speed);
        contacts = contacts_of(COR_LAW_LINEAR, COR_BOTH_ENDS,
                               GIVEN({COR_SCENE_STIFFNESS, m * pi * pi / (t * t)}, {COR_SCENE_EFFECTIVE_MASS, m}),
                               GIVEN({COR_SCENE_RESTITUTION, eps}));
    }
    const struct cor_simulator_target target = {&contacts.scene, contacts.contact, contacts.count, speed, eps, 0};
    const bool same_law = text && !strstr(text, "does not have the law of the contact");
    const struct cor_simulator *const simulator = cor_simulator_named(host);
    enum cor_simulator_status status;
    size_t found = 0;
    for (const struct cor_simulator_model *m = simulator->models; m < simulator->models + simulator->model_count; m++) {
        snprintf(title, sizeof title, ", %s (%s): contacts end at", m->model, m->version);
        const char *const heading = text && !m->has_function ? strstr(text, title) : NULL;
        if (!heading)
            continue;
        const double number = cor_simulator_number(m, &target, same_law, &status);
        const char *const lines = strstr(heading, m->advice) + strlen(m->advice);
        bool is_printed = false; /* the lines contain the number as {n}, {n/2} or {root} */
        for (int k = 0; k < 3; k++) {
            snprintf(form, sizeof form, "%.12g", k == 0 ? number : k == 1 ? number / 2 : sqrt(number));
            const char *const at = strstr(lines, form);
            is_printed = is_printed || (at && at < strstr(lines, "\n\n"));
        }
        const double damping =
            m->damping_of_e ? m->damping_of_e(number) : m->damping_of_number(m, number, contacts.contact, speed);
        const double got = m->law == COR_LAW_IMPULSE ? 1 - damping : cor_law_value(m->law, m->end, COR_EPS, damping);
        check(is_printed && fabs(got - eps) < 1e-9, "%s, %s: %.12g gives eps %.12g, not %g, in %s", host, m->model,
              number, got, eps, heading);
        found++;
    }
    free(text);
    return found;
}

/* Every simulator of the list has lines, a version and a comment. */
TEST(hosts_realise_what_is_wished)
{
    static const struct {
        const char *host;
        size_t linear, tsuji, viscoelastic; /* models with lines for each law */
    } row[] = {{"lammps", 8, 4, 2},     {"liggghts", 4, 2, 2}, {"yade", 2, 2, 1},     {"mercurydpm", 1, 2, 1},
               {"chrono", 2, 1, 1},     {"mfix", 1, 1, 1},     {"openfoam", 0, 1, 1}, {"esys", 0, 1, 1},
               {"dem-engine", 0, 1, 1}, {"exadem", 1, 1, 1},   {"mujoco", 2, 2, 2},   {"newton", 1, 1, 1},
               {"drake", 1, 1, 1},      {"simbody", 1, 1, 1},  {"bullet", 2, 1, 0},   {"gazebo", 1, 1, 1},
               {"physx", 1, 1, 1},      {"isaac", 1, 1, 1},    {"pfc", 2, 2, 2},      {"edem", 1, 1, 1},
               {"simscape", 2, 2, 2},   {"rebound", 1, 1, 0},  {"modelica", 1, 1, 1}};
    const struct given *const requested = GIVEN({COR_SCENE_RESTITUTION, 0.7});
    const struct given *const measured = GIVEN({COR_SCENE_RESTITUTION, 0.7}, {COR_SCENE_AT, 0.4});
    char *const list = contact_simulator_text(&(struct cor_simulator_request){.simulator = CONTACT_SIMULATOR_LIST});
    for (size_t i = 0; i < COUNT_OF(row); i++) {
        char line[40];
        const size_t linear = host_realises(row[i].host, COR_LAW_LINEAR, SPRING, requested);
        const size_t tsuji = host_realises(row[i].host, COR_LAW_TSUJI, GLASS, requested);
        const size_t sphere = host_realises(row[i].host, COR_LAW_VISCOELASTIC, GLASS, measured);
        check(linear == row[i].linear && tsuji == row[i].tsuji && sphere == row[i].viscoelastic,
              "%s: %zu linear, %zu Tsuji, %zu viscoelastic", row[i].host, linear, tsuji, sphere);
        snprintf(line, sizeof line, "\n%s ", cor_simulator_named(row[i].host)->name);
        assert_true(i == 0 || strstr(list, line));
    }
    free(list);
    size_t hosts = 0;
    for (size_t i = 0; i < cor_simulator_count; i++)
        if (cor_simulators[i].comment)
            assert_string_equal(cor_simulators[i].name, contact_simulator_names[hosts++]);
    assert_int_equal(COUNT_OF(row), hosts);
    assert_int_equal(host_realises("drake", COR_LAW_HUNT_CROSSLEY, GLASS, measured), 1);
    assert_int_equal(host_realises("lammps", COR_LAW_HERTZ_DASHPOT, GLASS, measured), 2);
    assert_null(cor_simulator_named("kratos")); /* simulators in the table that have no lines */
}

static double number_after(const char *text, const char *name, double otherwise)
{
    const char *const at = strstr(text, name);
    return at ? strtod(at + strlen(name), NULL) : otherwise;
}

/* Integrates the force that ChContactSMC computes from the lines for Chrono's Hertz contact: kn R sqrt(x) x +
 * gn m R sqrt(x) x', never attractive. Type::BULLET: R is 0.1 m unless set. Type::MULTICORE: R is R1 R2/(R1 + R2). */
TEST(chrono_finds_the_radius)
{
    for (int i = 0; i < 8; i++) {
        const double r1 = random_log(&draw, 1e-4, 0.3), r2 = random_log(&draw, 1e-4, 0.3);
        const double e = random_uniform(&draw, 0.2, 0.97), speed = random_log(&draw, 0.01, 5);
        const struct contacts contacts =
            contacts_of(0, COR_END_ZERO_FORCE,
                        GIVEN({COR_SCENE_YOUNG, random_log(&draw, 1e6, 1e11)}, {COR_SCENE_POISSON, 0.3},
                              {COR_SCENE_DENSITY, 2500}, {COR_SCENE_RADIUS, r1}, {COR_SCENE_RADIUS_2, r2}),
                        GIVEN({COR_SCENE_RESTITUTION, e}, {COR_SCENE_AT, speed}));
        char *const lines = contact_simulator_text(REQUEST("chrono", contacts, &speed));
        assert_non_null(lines);
        const double kn = number_after(lines, "SetKn(", NAN), gn = number_after(lines, "SetGn(", NAN);
        const double found[] = {number_after(lines, "SetDefaultEffectiveCurvatureRadius(", 0.1), r1 * r2 / (r1 + r2)};
        const double mass = contacts.contact[0].mass_kg;
        for (int k = 0; k < 2; k++) {
            const struct law_of_force f = force_law(mass, kn * found[k], gn * mass * found[k], 1.5, 0.5, speed);
            const double eps = integrate(&f, false).eps[COR_END_ZERO_FORCE];
            check(fabs(eps - e) < 1e-8, "Chrono with R = %g realises %.9g, not %.9g", found[k], eps, e);
        }
        free(lines);
    }
}
