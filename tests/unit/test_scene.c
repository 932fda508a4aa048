/* SPDX-License-Identifier: MIT */
/* Contacts of random scenes, each against its formula: unlike bodies, every way to give the damping of every law, and a
 * liquid around a damped contact. */
#include "runtime/number/si_range.h"
#include "scene.h"

#include "cor/contact.h"

/* Mass, stiffness, radius and dissipation time of two bodies whose numbers all differ, or of a body and a wall. A
 * number that the second body lacks defaults to the first body's number. */
TEST(unlike_bodies)
{
    enum { YOUNG, POISSON, RADIUS, DENSITY, MASS, TIME, VISCOSITY, BULK, NUMBERS };
    static const double range[][2] = {{1e6, 1e12}, {0.01, 0.49}, {1e-6, 1}, {100, 1e4},
                                      {1e-9, 10},  {1e-9, 1e-3}, {1, 1e6},  {1, 1e6}};
    static const int group[NUMBERS] = {0, 1, 2, 3, 3, 4, 4, 4}; /* numbers of one group are missing together */
    for (size_t i = 0; i < points(2000); i++) {
        struct cor_scene scene = scene_without_numbers(COR_LAW_VISCOELASTIC);
        struct cor_scene_contact contacts[COR_SCENE_ENDS];
        struct cor_scene_fault fault;
        double v[NUMBERS];
        long double compliance = 0, lost = 0, curvature = 0, mass = 0;
        int count;
        scene.wall = i % 4 == 0;
        for (int body = 0; body < 2; body++) {
            const unsigned lacks = body ? (unsigned)random_below(&draw, 32) | (scene.wall ? 12 : 0) : 0;
            const int without = random_below(&draw, 2) ? DENSITY : MASS;
            for (int k = 0; k < NUMBERS; k++)
                if (!(lacks >> group[k] & 1)) {
                    v[k] = k == without || (i % 2 ? k == TIME : k > TIME) ? (double)NAN
                                                                          : random_log(&draw, range[k][0], range[k][1]);
                    scene.number[COR_SCENE_YOUNG + k + body * COR_SCENE_BODY] = v[k];
                }
            const long double own = (1 - (long double)v[POISSON] * v[POISSON]) / v[YOUNG], r = v[RADIUS];
            compliance += own;
            lost +=
                own * (i % 2 ? cor_dissipation_time_viscous_s(v[VISCOSITY], v[BULK], v[YOUNG], v[POISSON]) : v[TIME]);
            if (body && scene.wall)
                break;
            curvature += 1 / r;
            mass += 1 / (isnan(v[MASS]) ? 4 * acosl(-1) / 3 * r * r * r * v[DENSITY] : v[MASS]);
        }
        assert_int_equal(cor_scene_contacts(contacts, &count, &fault, &scene), COR_FAULT_NONE);
        check_near(contacts[0].radius_m, 1 / curvature, 1e-14);
        check_near(contacts[0].mass_kg, 1 / mass, 1e-14);
        check_near(contacts[0].stiffness, 4 / (3 * compliance) * sqrtl(1 / curvature), 1e-14);
        check_near(cor_scene_damping(&contacts[0], COR_SCENE_DISSIPATION_TIME), lost / compliance, 1e-13);
        /* the largest force that is a double, and slightly more */
        scene.number[COR_SCENE_GRAVITY] = COR_SI_MOST / contacts[0].mass_kg * (i % 8 ? 1 - 1e-9 : 1 + 1e-9);
        if (scene.wall && mass < 1) {
            assert_int_equal(cor_scene_contacts(contacts, &count, &fault, &scene), i % 8 ? 0 : COR_FAULT_RANGE);
            assert_true(i % 8 || fault.number == COR_SCENE_GRAVITY);
        }
    }
}

/* All ways to give the damping give the same C = beta m (K/m)^((b+1)/(a+1)) g^-q. The ways are beta, eps at either end,
 * zeta = beta/sqrt(2 (a + 1)) if q = 0, A = C/(3 K/2), and g*, where 1 - eps = (g/g*)^q for slow impacts. A liquid
 * removes speed once before the contact and once after it. The contact itself is dry. */
TEST(every_law)
{
    for (int i = 0; i < 40 * COR_LAW_PLATE; i++) {
        struct cor_scene_contact c = {.law = cor_law_exponents[i % COR_LAW_PLATE],
                                      .mass_kg = random_log(&draw, 1e-9, 1),
                                      .stiffness = random_log(&draw, 1e2, 1e12)};
        if (!law_is_complete(i % COR_LAW_PLATE))
            continue;
        const double n = c.law.denominator, a1 = c.law.elastic / n + 1, b1 = c.law.damping / n + 1, q = 2 * b1 / a1 - 1;
        const double speed = random_log(&draw, 1e-3, 10), beta = random_log(&draw, 0.1, 1);
        const double C = beta * c.mass_kg * pow(c.stiffness / c.mass_kg, b1 / a1) * pow(speed, -q);
        assert_int_equal(cor_scene_set_damping(&c, COR_SCENE_DAMPING_COEFFICIENT, C, NAN, 0), 0);
        check_near(cor_scene_beta(&c, speed), beta, 1e-13);
        const struct {
            int number, end;
            double value;
        } ways[] = {{COR_SCENE_BETA, 0, beta},
                    {COR_SCENE_RESTITUTION, 0, scene_eps(&c, speed, 0)},
                    {COR_SCENE_RESTITUTION, 1, scene_eps(&c, speed, 1)},
                    {COR_SCENE_ZETA, 0, q == 0 ? beta / sqrt(2 * a1) : (double)NAN},
                    {COR_SCENE_G_STAR, 0, cor_scene_damping(&c, COR_SCENE_G_STAR)},
                    {COR_SCENE_DISSIPATION_TIME, 0, C / (1.5 * c.stiffness)}};
        for (size_t k = 0; k < COUNT_OF(ways); k++) {
            struct cor_scene_contact other = c;
            if (isnan(ways[k].value))
                continue;
            assert_int_equal(cor_scene_set_damping(&other, ways[k].number, ways[k].value, speed, ways[k].end), 0);
            const double got = cor_scene_damping(&other, COR_SCENE_DAMPING_COEFFICIENT);
            check(relative_error(got, C) < 1e-12, "law %d, way %zu: %.17g, not %.17g", i % COR_LAW_PLATE, k, got, C);
        }
        if (q > 0)
            check_near(1 - scene_eps(&c, cor_scene_damping(&c, COR_SCENE_G_STAR) * pow(1e-7, 1 / q), 0), 1e-7, 1e-5);
        /* if the end of the restitution is not given and the ends of the law differ, each end gives a contact */
        struct cor_scene scene = scene_without_numbers((enum cor_law)(i % COR_LAW_PLATE));
        struct cor_scene_contact both[COR_SCENE_ENDS], wet = c;
        struct cor_scene_fault fault;
        int count;
        scene_give(scene, {COR_SCENE_STIFFNESS, c.stiffness}, {COR_SCENE_EFFECTIVE_MASS, c.mass_kg},
                   {COR_SCENE_RESTITUTION, 0.7}, {COR_SCENE_AT, speed});
        assert_int_equal(cor_scene_contacts(both, &count, &fault, &scene), COR_FAULT_NONE);
        assert_int_equal(count, a1 > b1 ? COR_SCENE_ENDS : 1);
        for (int end = 0; end < count; end++)
            check_near(scene_eps(&both[end], speed, end), 0.7, 1e-13);
        const double s = wet.liquid_speed_m_s = speed * random_log(&draw, 0.01, 10), at = speed + s - s;
        const struct cor_scene_impact got = scene_impact(&wet, speed + s), dry = scene_impact(&c, at);
        assert_true(got.beta == dry.beta && got.max_overlap_m == dry.max_overlap_m &&
                    cor_scene_force_max_n(&wet, speed + s) == cor_scene_force_max_n(&c, at));
        for (int end = 0; end < COR_SCENE_ENDS; end++) {
            assert_true(got.duration_s[end] == dry.duration_s[end]);
            check(fabs(got.eps[end] - fmax(0, (dry.eps[end] * at - s) / (speed + s))) < 1e-14, "eps %g", got.eps[end]);
            assert_true(scene_eps(&wet, speed + s, end) == got.eps[end]);
        }
    }
}

/* Each number of two bodies is given or not. The refusal names the first missing number. If none is missing, it reports
 * density and mass that are both given or both missing, then numbers that a wall cannot have. */
TEST(incomplete_bodies)
{
    static const int number[] = {COR_SCENE_YOUNG,   COR_SCENE_POISSON, COR_SCENE_RADIUS,    COR_SCENE_DISSIPATION_TIME,
                                 COR_SCENE_MASS,    COR_SCENE_DENSITY, COR_SCENE_DENSITY_2, COR_SCENE_MASS_2,
                                 COR_SCENE_RADIUS_2};
    for (size_t i = 0; i < points(4000); i++) {
        const int dissipates = random_below(&draw, 2) != 0, dense_wall = random_below(&draw, 2) != 0;
        struct cor_scene scene = scene_without_numbers(COR_LAW_VISCOELASTIC);
        struct cor_scene_fault fault;
        int given[COUNT_OF(number)], missing = 0;
        scene.wall = random_below(&draw, 2) != 0;
        for (size_t k = 0; k < COUNT_OF(number); k++)
            if ((given[k] = random_below(&draw, k < 4 ? 8 : 2) != 0))
                scene.number[number[k]] = 0.3;
        while (missing < 3 + dissipates && given[missing])
            missing++;
        const int expected = missing < 3 + dissipates                                            ? COR_FAULT_MISSING
                             : given[4] == given[5]                                              ? COR_FAULT_ONE_OF
                             : given[6] && given[7]                                              ? COR_FAULT_EXCLUDED
                             : scene.wall && ((given[6] && !dense_wall) || given[7] || given[8]) ? COR_FAULT_WALL
                                                                                                 : COR_FAULT_NONE;
        const int options = dissipates * COR_SCENE_DISSIPATES + dense_wall * COR_SCENE_DENSE_WALL;
        assert_int_equal(cor_scene_check_bodies(&fault, &scene, options), expected);
        assert_int_equal(fault.fault, expected);
        if (expected == COR_FAULT_MISSING)
            assert_int_equal(fault.number, number[missing]);
        if (expected == COR_FAULT_WALL)
            assert_int_equal(fault.number, dense_wall ? COR_SCENE_RADIUS_2 : COR_SCENE_DENSITY_2);
    }
}

/* Checks that `quiet` obeys IEEE 754, except that results above 2^1022 may be infinite, powers below 2^-1019 may be 0,
 * and x^NaN is NaN. */
static void check_quiet(double quiet, double exact, char operation, double x, double y)
{
    const int is_power = operation == '^', is_edge = (isinf(quiet) && exact > 0x1p1022) ||
                                                     (is_power && quiet == 0 && exact < 0x1p-1019) ||
                                                     (is_power && isnan(quiet) && isnan(y));
    check(same_number(quiet, exact) || is_edge, "%g %c %g is %g", x, operation, y, quiet);
}

TEST(quiet_arithmetic)
{
    static const double numbers[] = {0, DBL_MIN / 4, 1e-200, 0.5, 1, 3, 1e200, DBL_MAX, INFINITY, NAN};
    for (size_t i = 0; i < COUNT_OF(numbers); i++)
        for (size_t k = 0; k < COUNT_OF(numbers); k++) {
            const double x = numbers[i], y = numbers[k];
            check_quiet(cor_quiet_product(x, y), x * y, '*', x, y);
            check_quiet(cor_quiet_quotient(x, y), x / y, '/', x, y);
            check_quiet(cor_quiet_power(x, y), pow(x, y), '^', x, y);
        }
}

/* A plate has no end at zero force. */
TEST(plate)
{
    const struct cor_scene_contact c = {
        .law = cor_law_exponents[COR_LAW_PLATE], .plate = 1, .mass_kg = 1, .stiffness = 1, .damping = 0.5};
    double eps = 0;
    assert_true(cor_scene_eps(&eps, &c, 1, COR_END_ZERO_FORCE) == COR_OK && isnan(eps));
    assert_true(scene_eps(&c, 1, COR_END_ZERO_OVERLAP) > 0);
}
