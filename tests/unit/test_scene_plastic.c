/* SPDX-License-Identifier: MIT */
/* Spheres that yield and spheres in a liquid, each by another method: Thornton's printed formula in long double, the
 * piecewise contact integrated in time, and the motion of the spheres in the liquid. */
#include "../reference/ode.h"
#include "scene.h"

static const long double pi_long = 3.14159265358979323846264338L;

/* Returns eps by eq. 31 of Thornton (1997), as printed in most papers. */
static long double printed_eps(long double x)
{
    const long double r = 1 / x;
    return sqrtl(6 * sqrtl(3) / 5 * (1 - r * r / 6)) * powl(r / (r + 2 * sqrtl(6.0L / 5 - r * r / 5)), 0.25L);
}

TEST(eps_of_the_speed)
{
    for (int i = 0; i < 60000; i += (int)few_or_all(6, 1)) {
        /* x from one ulp above 1 to the largest speeds */
        const double exponent = -52 + 400.0 * (i + 1) / 60000;
        const double x = exponent < 0 ? 1 + exp2(exponent) * (1 + (i % 17) / 17.0) : exp2(exponent);
        const double eps = cor_elastic_plastic_eps(x);
        check_ulp(eps, printed_eps(x), COR_ELASTIC_PLASTIC_EPS_MAX_ULP);
        check(eps <= 1, "x = %a: eps = %a", x, eps);
        /* nearer to x = 1 the printed formula loses digits of 1 - eps; the next test checks the limit */
        if (x > 1.125) { /* d ln x/d ln eps is 4 or more: eps determines x well */
            check_ulp(cor_elastic_plastic_loss(x), 1 - printed_eps(x), COR_ELASTIC_PLASTIC_LOSS_MAX_ULP);
            const double back = cor_elastic_plastic_speed_ratio(eps);
            long double low = back * (1 - 1e-10L), high = back * (1 + 1e-10L);
            for (int k = 0; k < 70; k++) {
                const long double middle = (low + high) / 2;
                *(printed_eps(middle) > eps ? &low : &high) = middle;
            }
            check_ulp(back, low, COR_ELASTIC_PLASTIC_SPEED_RATIO_MAX_ULP);
        }
    }
}

/* eps has a continuous slope at v_y: 1 - eps = 0.24 (x - 1)^2 to lowest order. This follows from (72/108) (1 - t)^2/4
 * with 1 - t = (6/5) (1 - 1/x); runtime/scene/plastic.c defines t. */
TEST(onset_and_limits)
{
    for (double gap = 1e-3; gap > 1e-14; gap /= 10) {
        const double x = 1 + gap, loss = cor_elastic_plastic_loss(x), expected = 0.24 * (x - 1) * (x - 1);
        check_near(loss, expected, 4 * gap + 1e-14);
        if (gap < 0.1 * sqrt(DBL_EPSILON))
            assert_true(cor_elastic_plastic_eps(x) == 1);
    }
    assert_true(cor_elastic_plastic_eps(1) == 1 && cor_elastic_plastic_eps(nextafter(1, 0)) == 1);
    assert_true(cor_elastic_plastic_eps(nextafter(1, 2)) == 1 && cor_elastic_plastic_loss(nextafter(1, 2)) > 0);
    assert_true(cor_elastic_plastic_eps(0) == 1 && cor_elastic_plastic_loss(0) == 0);
    assert_true(cor_elastic_plastic_eps(INFINITY) == 0 && cor_elastic_plastic_loss(INFINITY) == 1);
    assert_true(cor_elastic_plastic_eps(1e308) > 0 && cor_elastic_plastic_speed_ratio(1) == 1);
    assert_true(isinf(cor_elastic_plastic_speed_ratio(0)) && isinf(cor_elastic_plastic_speed_ratio(1e-90)));
    check_nan(cor_elastic_plastic_eps(-1), cor_elastic_plastic_eps(NAN), cor_elastic_plastic_loss(NAN),
              cor_elastic_plastic_speed_ratio(1.1), cor_elastic_plastic_speed_ratio(NAN),
              cor_elastic_plastic_speed_ratio(-0.5));
    for (double eps = 1; eps > 0.01; eps -= 1.0 / 512) { /* the inverse decreases where its two methods meet */
        const double x = cor_elastic_plastic_speed_ratio(eps);
        check(fabs(cor_elastic_plastic_eps(x) - eps) < 4e-15 && x < cor_elastic_plastic_speed_ratio(eps - 1.0 / 512),
              "eps %g: x %g", eps, x);
    }
}

/* ---- the piecewise contact ---- */

struct spheres {
    long double modulus, radius, mass, yield_pressure; /* E*, R, m, p_y */
    long double yield_overlap, yield_force;
    long double larger, rest; /* radius and remaining overlap of the unloading; 0 while loading */
};

static long double hertz(long double modulus, long double radius, long double overlap)
{
    return overlap > 0 ? 4 * modulus / 3 * sqrtl(radius * overlap) * overlap : 0;
}

static long double contact_force(const struct spheres *s, long double overlap)
{
    if (s->larger > 0)
        return hertz(s->modulus, s->larger, overlap - s->rest);
    if (overlap <= s->yield_overlap)
        return hertz(s->modulus, s->radius, overlap);
    return s->yield_force + pi_long * s->radius * s->yield_pressure * (overlap - s->yield_overlap);
}

static void spheres_slopes(long double *slope, const long double *y, const void *of)
{
    const struct spheres *const s = of;
    slope[0] = y[1];
    slope[1] = -contact_force(s, y[0]) / s->mass;
    slope[2] = 1;
}

static long double short_of_yield(const long double *y, const void *of)
{
    return ((const struct spheres *)of)->yield_overlap - y[0];
}

static long double above_rest(const long double *y, const void *of)
{
    return y[0] - ((const struct spheres *)of)->rest;
}

static void run(ode_value *value, const struct spheres *s, long double y[3], long double longest)
{
    struct ode o = {.slopes = spheres_slopes, .of = s, .n = 3, .longest = longest, .error = 1e-14L};
    while (ode_until(&o, y, &value, 1) < 0) {
    }
}

static struct cor_scene scene_of_steel(void)
{
    struct cor_scene scene = scene_without_numbers(COR_LAW_ELASTIC_PLASTIC);
    scene.plastic = 1;
    scene_give(scene, {COR_SCENE_YOUNG, 2.1e11}, {COR_SCENE_POISSON, 0.3}, {COR_SCENE_RADIUS, 5e-3},
               {COR_SCENE_DENSITY, 7850}, {COR_SCENE_YIELD_STRESS, 1e9});
    return scene;
}

TEST(piecewise_contact)
{
    const struct cor_scene scene = scene_of_steel();
    const struct cor_scene_contact contact = scene_contact(&scene, COR_BOTH_ENDS);
    struct spheres s = {.modulus = 2.1e11L / (2 * (1 - 0.09L)), .radius = 2.5e-3L, .yield_pressure = 1.6e9L};
    s.mass = 4 * pi_long / 3 * 1.25e-7L * 7850 / 2;
    s.yield_overlap = s.radius * powl(pi_long * s.yield_pressure / (2 * s.modulus), 2);
    s.yield_force = hertz(s.modulus, s.radius, s.yield_overlap);
    const long double onset = sqrtl(4.0L / 5 * s.yield_force * s.yield_overlap / s.mass); /* from the energy at yield */
    check_near(contact.yield_speed_m_s, onset, 1e-14);
    check_near(COR_YIELD_FACTOR, sqrtl(powl(pi_long, 5) / 30), 1e-15);
    check_near(cor_scene_yield_stress(&contact, (double)onset), 1e9L, 1e-14);
    draw_begin();
    for (int i = 0; i < 100; i++) { /* yield speeds below and above the contact's own one */
        const double speed = (double)onset * random_log(&draw, 1e-6, 1e6);
        check_near(cor_scene_yield_speed(&contact, cor_scene_yield_stress(&contact, speed)), speed, 2e-14);
    }
    EACH (ratios, 0.5, 0.99, 1.0001, 1.2, 2, 10, 100, 3e3) {
        const double speed = contact.yield_speed_m_s * *ratios;
        const struct cor_scene_impact impact = scene_impact(&contact, speed);
        struct spheres t = s;
        const long double h = s.yield_overlap / speed / 8, later = s.yield_overlap / onset / 8;
        long double y[3] = {0, speed, 0};
        if (*ratios > 1)
            run(short_of_yield, &t, y, h);
        run(motion_speed, &t, y, later);
        const long double overlap = y[0], force = contact_force(&t, overlap), radius = sqrtl(s.radius * overlap);
        if (*ratios > 1) { /* the unloading follows Hertz's law with equal force and radius */
            t.larger = 4 * s.modulus * radius * radius * radius / (3 * force);
            t.rest = overlap - radius * radius / t.larger;
        }
        run(above_rest, &t, y, later);
        for (int end = 0; end < COR_SCENE_ENDS; end++) {
            check_near(impact.eps[end], -y[1] / speed, 1e-9);
            check_near(impact.duration_s[end], y[2], 1e-9);
        }
        check_near(impact.max_overlap_m, overlap, 1e-9);
        check_near(cor_scene_force_max_n(&contact, speed), force, 1e-9);
        check_near(cor_scene_contact_radius(&contact, impact.max_overlap_m), radius, 1e-9);
        check_near(cor_scene_pressure(&contact, impact.max_overlap_m),
                   fminl(3 * force / (2 * pi_long * radius * radius), s.yield_pressure), 1e-9);
    }
}

/* A restitution at a speed gives v_y, with and without bodies. */
TEST(yield_speed_of_a_restitution)
{
    struct cor_scene scene = scene_of_steel();
    scene_give(scene, {COR_SCENE_YIELD_STRESS, NAN}, {COR_SCENE_RESTITUTION, 0.6}, {COR_SCENE_AT, 2});
    for (int bodies = 1; bodies >= 0; bodies--) {
        const struct cor_scene_contact contact = scene_contact(&scene, COR_BOTH_ENDS);
        check_near(scene_eps(&contact, 2, COR_END_ZERO_OVERLAP), 0.6, 1e-15);
        if (bodies)
            check_near(cor_scene_yield_speed(&contact, cor_scene_yield_stress(&contact, contact.yield_speed_m_s)),
                       contact.yield_speed_m_s, 1e-14);
        for (int i = COR_SCENE_YOUNG; i < COR_SCENE_DISSIPATION_TIME; i++)
            scene.number[i] = NAN;
    }
}

/* ---- Luding's contact ---- */

/* Returns LIGGGHTS's force without adhesion. number: stiffness k, ratio of the largest unloading stiffness to k, and
 * plasticity depth. radius: effective radius */
static double luding_force(const double number[3], double radius, double x, double largest)
{
    const double k = number[0], most = k * number[1], limit = most / (most - k) * number[2] * 2 * radius;
    const double back = k + (most - k) * largest / limit;
    return x >= largest ? k * x : fmax(back * (x - largest) + k * largest, 0);
}

/* The lines for LIGGGHTS are integrated: eps and overlap of the spheres at the speed of the lines, and the stated eps
 * at other speeds. The text for a simulator without such a model states that it is missing. */
TEST(lines_of_luding)
{
    static const char *const names[] = {"LoadingStiffness", "UnloadingStiffness", "coefficientPlasticityDepth"};
    const struct cor_scene scene = scene_of_steel();
    const struct cor_scene_contact contact = scene_contact(&scene, COR_BOTH_ENDS);
    const double speed = 0.5;
    struct cor_simulator_request request = {
        .simulator = "liggghts", .scene = &scene, .contacts = &contact, .count = 1, .speed_m_s = &speed, .speeds = 1};
    char text[8000];
    double number[3];
    const struct cor_scene_impact impact = scene_impact(&contact, speed);
    assert_true(cor_simulator_lines(text, sizeof text, &request) > 0);
    for (int i = 0; i < 3; i++)
        assert_int_equal(sscanf(strstr(text, names[i]) + strlen(names[i]), " peratomtypepair 1 %lf", &number[i]), 1);
    for (double factor = 0.25; factor <= 1; factor *= 2) {
        const double g = factor * speed, h = 1e-5 * impact.max_overlap_m / speed;
        double x = 0, v = g, largest = 0;
        while (x > 0 || v > 0) {
            v -= h * luding_force(number, contact.radius_m, x, largest) / contact.mass_kg;
            x += h * v;
            largest = fmax(largest, x);
        }
        const double wanted = 1 / sqrt(1 + (1 / (impact.eps[0] * impact.eps[0]) - 1) * factor);
        check(fabs(-v / g - wanted) < 2e-5, "at %g m/s: %.12g, not %.12g", g, -v / g, wanted);
        if (factor == 1)
            check_near(largest, impact.max_overlap_m, 2e-5);
    }
    static const char *const others[][2] = {{"lammps", "mdr"},
                                            {"lammps", "Right only at 0.5 m/s"},
                                            {"chrono", "knows no model of Chrono"},
                                            {"rebound", "embed --law elastic-plastic"},
                                            {"lammps", "hold at one impact speed"}};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        request.simulator = others[i][0];
        request.speeds = i < 4;
        assert_true((cor_simulator_lines(text, sizeof text, &request) > 0) == (i < 4) && strstr(text, others[i][1]));
    }
}

/* ---- a liquid ---- */

/* Returns the speed that remains of v after the gap has changed from `from` to `to`. Uses second-order steps in the
 * logarithm of the gap: each step is the same fraction of the gap. */
static double through_liquid(double v, double drag_over_mass, double from, double to)
{
    const int steps = 200000;
    const double factor = pow(to / from, 1.0 / steps);
    double h = from;
    for (int i = 0; i < steps && v > 0; i++, h *= factor) {
        const double width = fabs(h * factor - h);
        const double half = v - drag_over_mass / h * width / 2; /* dv/d(distance) = -(drag/m)/h for every v */
        v = half - drag_over_mass / (h * factor) * width / 2;
    }
    return v;
}

TEST(wet_contact)
{
    struct cor_scene scene = scene_of_steel();
    struct cor_scene_impact dry_impact, wet_impact;
    scene_give(scene, {COR_SCENE_LIQUID_VISCOSITY, 0.1}, {COR_SCENE_GAP_OUTER, 5e-4}, {COR_SCENE_GAP_INNER, 2e-6});
    const struct cor_scene_contact wet = scene_contact(&scene, COR_BOTH_ENDS);
    struct cor_scene_contact dry = wet;
    dry.liquid_speed_m_s = 0;
    const double drag = 6 * (double)pi_long * 0.1 * 2.5e-3 * 2.5e-3 / wet.mass_kg;
    const double sticking = cor_scene_sticking_speed(&wet, 0);
    for (double speed = 1.01 * sticking; speed < 100; speed *= 2) {
        const double at = through_liquid(speed, drag, 5e-4, 2e-6);
        const double eps = scene_eps(&wet, speed, 0),
                     away = through_liquid(scene_eps(&dry, at, 0) * at, drag, 2e-6, 5e-4);
        check(fabs(eps - away / speed) < 1e-7, "%g m/s: %.12g", speed, eps);
        wet_impact = scene_impact(&wet, speed);
        dry_impact = scene_impact(&dry, speed - wet.liquid_speed_m_s);
        assert_true(wet_impact.eps[0] == eps && wet_impact.max_overlap_m == dry_impact.max_overlap_m &&
                    wet_impact.duration_s[1] == dry_impact.duration_s[1]);
    }
    /* 0 below the sticking speed, and where the bodies do not touch */
    for (int i = 1; i <= 9; i++) {
        const double speed = sticking * i / 10;
        wet_impact = scene_impact(&wet, speed);
        assert_true(wet_impact.eps[0] == 0 && wet_impact.eps[1] == 0);
        assert_true(speed > wet.liquid_speed_m_s || (wet_impact.max_overlap_m == 0 && isnan(wet_impact.duration_s[0]) &&
                                                     cor_scene_force_max_n(&wet, speed) == 0));
    }
    const double least = scene_eps(&wet, sticking * (1 + 1e-12), 0);
    assert_true(least > 0 && least < 1e-10);
    /* at constant eps, the sticking speed is s (1 + 1/eps), where s is the speed lost in the liquid. Hunt and
     * Crossley's rebound is slower than m/C, so bodies with a larger s stick at every speed. */
    struct cor_scene_contact tsuji = wet, crossley = wet;
    tsuji.plastic = crossley.plastic = 0;
    tsuji.law = cor_law_exponents[COR_LAW_TSUJI];
    tsuji.damping = cor_law_damping(COR_LAW_TSUJI, COR_END_ZERO_OVERLAP, 0.5);
    check_near(cor_scene_sticking_speed(&tsuji, 0), 3 * (long double)wet.liquid_speed_m_s, 1e-14);
    crossley.law = cor_law_exponents[COR_LAW_HUNT_CROSSLEY];
    crossley.damping = 1.01 / wet.liquid_speed_m_s;
    assert_true(isinf(cor_scene_sticking_speed(&crossley, 0)));
    crossley.damping = 0.9 / wet.liquid_speed_m_s;
    assert_true(isfinite(cor_scene_sticking_speed(&crossley, 0)));
    /* nearly equal gaps, and special values */
    for (int i = 0; i < 200; i++) {
        const double inner = random_log(&draw, 1e-9, 1e-3), outer = inner * (1 + random_log(&draw, 1e-9, 1e3));
        check_near(cor_scene_liquid_speed(&wet, 0.1, outer, inner), drag * log1pl((outer - (long double)inner) / inner),
                   1e-14);
    }
    assert_true(cor_wet_eps(0.7, 1, 0) == 0.7 && cor_wet_eps(0.7, 1, 2) == 0 && cor_wet_eps(1, 0, 0) == 1);
    check_nan(cor_wet_eps(-0.1, 1, 0), cor_wet_eps(NAN, 1, 0), cor_wet_eps(1, NAN, 0), cor_wet_eps(1, 1, -1),
              cor_scene_liquid_speed(&wet, 0.1, 1e-6, 1e-5));
}

TEST(refusals)
{
    static const struct {
        int number;
        double value;
        int other;
        double other_value;
        int fault;
    } cases[] = {{COR_SCENE_RESTITUTION, 0.5, COR_SCENE_YIELD_STRESS, NAN, COR_FAULT_NO_SPEED},
                 {COR_SCENE_RESTITUTION, 0.5, COR_SCENE_AT, 1, COR_FAULT_EXCLUDED},
                 {COR_SCENE_YIELD_STRESS, NAN, COR_SCENE_YIELD_STRESS, NAN, COR_FAULT_NO_YIELD},
                 {COR_SCENE_GAP_OUTER, 1e-3, COR_SCENE_GAP_INNER, 1e-6, COR_FAULT_LIQUID},
                 {COR_SCENE_DISSIPATION_TIME, 1e-6, COR_SCENE_AT, 1, COR_FAULT_YIELD_DAMPING},
                 {COR_SCENE_AT, 1, COR_SCENE_YIELD_STRESS, 1e9, COR_FAULT_SPEED_ALONE},
                 {COR_SCENE_YIELD_STRESS, 1e308, COR_SCENE_YIELD_STRESS, 1e308, COR_FAULT_RANGE},
                 {COR_SCENE_ADHESION, 0.1, COR_SCENE_ADHESION, 0.1, COR_FAULT_PRESSED_LAW}};
    struct cor_scene_contact contacts[COR_SCENE_ENDS];
    struct cor_scene_fault fault;
    int count;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct cor_scene scene = scene_of_steel();
        scene.adhesion_model = cases[i].number == COR_SCENE_ADHESION ? COR_ADHESION_DMT : COR_ADHESION_NONE;
        scene_give(scene, {cases[i].number, cases[i].value}, {cases[i].other, cases[i].other_value});
        check(cor_scene_contacts(contacts, &count, &fault, &scene) == cases[i].fault, "case %zu: %d", i, fault.fault);
        assert_int_equal(count, 0);
    }
    struct cor_scene steel = scene_of_steel();
    scene_give(steel, {COR_SCENE_LIQUID_VISCOSITY, 1}, {COR_SCENE_GAP_OUTER, 0.1}, {COR_SCENE_GAP_INNER, 0.1});
    assert_int_equal(cor_scene_contacts(contacts, &count, &fault, &steel), COR_FAULT_GAPS);
    struct cor_scene scene = scene_without_numbers(COR_LAW_VISCOELASTIC);
    scene_give(scene, {COR_SCENE_LIQUID_VISCOSITY, 1}, {COR_SCENE_GAP_OUTER, 0.2}, {COR_SCENE_GAP_INNER, 0.1},
               {COR_SCENE_G_STAR, 1});
    assert_int_equal(cor_scene_contacts(contacts, &count, &fault, &scene), COR_FAULT_NO_BODIES);
}
