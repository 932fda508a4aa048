/* SPDX-License-Identifier: MIT */
/* Tests spheres with JKR adhesion against its limit without adhesion. Integrates the motion in long double over
 * the contact radius, and the force for the energy of the tail. */
#include "../reference/ode.h"
#include "scene.h"

static const long double pi = 3.141592653589793238463L;

/* Two spheres of 20 um, E = 1 GPa, nu = 1/4, w = 0.1 J/m^2, with the dissipation time A */
static struct cor_scene_contact spheres(double dissipation_time_s, double adhesion_j_m2)
{
    struct cor_scene_contact contact = {.law = {3, 1, 2},
                                        .mass_kg = 5.2359877559829887e-12,
                                        .stiffness = 1590092.6,
                                        .radius_m = 5e-6,
                                        .adhesion_j_m2 = adhesion_j_m2};
    assert_int_equal(cor_scene_set_damping(&contact, COR_SCENE_DISSIPATION_TIME, dissipation_time_s, 1, COR_JKR_TAIL),
                     COR_OK);
    return contact;
}

/* Returns the overlap, its derivative by the contact radius, and the force, by the theory. */
static long double overlap_of(const struct cor_scene_contact *s, long double c, long double *slope, long double *force)
{
    const long double modulus = 0.75L * (long double)s->stiffness / sqrtl(s->radius_m), w = s->adhesion_j_m2,
                      R = s->radius_m, part = sqrtl(2 * pi * w * c / modulus);
    *slope = 2 * c / R - part / (2 * c);
    *force = 4 * modulus * c * c * c / (3 * R) - sqrtl(8 * pi * w * modulus * c * c * c);
    return c * c / R - part;
}

static long double first_radius(const struct cor_scene_contact *s)
{
    const long double modulus = 0.75L * (long double)s->stiffness / sqrtl(s->radius_m), R = s->radius_m;
    return cbrtl(2 * pi * (long double)s->adhesion_j_m2 * R * R / modulus);
}

/* Returns the contact radius of the end, where d overlap/d radius = 0 (COR_JKR_TAIL) or d force/d radius = 0. */
static long double last_radius(const struct cor_scene_contact *s, int end)
{
    return first_radius(s) * powl(end == COR_JKR_TAIL ? 0.25L : 0.75L, 2 / 3.0L);
}

/* The energy from the first touch to the end is the integral of the force over the overlap, by Simpson's rule. */
TEST(elastic)
{
    struct cor_scene_contact s = spheres(0, 0.1);
    for (int end = 0; end < COR_SCENE_ENDS; end++) {
        enum { N = 20000 };
        const long double from = first_radius(&s), to = last_radius(&s, end), h = (to - from) / N;
        long double sum = 0, slope, force;
        for (int i = 0; i <= N; i++) {
            overlap_of(&s, from + i * h, &slope, &force);
            sum += force * slope * (i == 0 || i == N ? 1 : i % 2 ? 4 : 2);
        }
        const long double lost = sum * h / 3, speed = sqrtl(2 * lost / (long double)s.mass_kg);
        check_near(cor_scene_sticking_speed(&s, end), speed, end == COR_JKR_TAIL ? 1e-12 : 1e-9);
        for (double g = 1.001; g < 1e4; g *= 3) {
            const double v = cor_scene_sticking_speed(&s, end);
            check_near(scene_eps(&s, g * v, end), sqrtl(1 - 1 / ((long double)g * g)), 1e-12 / (g - 1));
            assert_true(scene_eps(&s, v * (1 - 1e-15), end) == 0);
        }
    }
    /* Johnson and Pollock's coefficient, and the coefficient of the largest pull */
    static const double k[] = {7.09219597186395882715, 3.50260197183529038835};
    const double modulus = 0.75 * s.stiffness / sqrt(s.radius_m), w = s.adhesion_j_m2, R = s.radius_m;
    for (int end = 0; end < COR_SCENE_ENDS; end++) {
        const double lost = k[end] * cbrt(pow(w, 5) * pow(R, 4) / (modulus * modulus));
        check_near(cor_scene_sticking_speed(&s, end), sqrt(2 * lost / s.mass_kg), 1e-14);
    }
}

/* Returns the damping in units of the contact: C l^b/(pi w R T), l = c_0^2/R, T^2 = m l/(pi w R). */
static double kappa_of(const struct cor_scene_contact *s)
{
    const double c = (double)first_radius(s), R = s->radius_m, l = c * c / R, force = (double)pi * s->adhesion_j_m2 * R;
    const double b = (double)s->law.damping / s->law.denominator;
    return cor_scene_damping(s, COR_SCENE_DAMPING_COEFFICIENT) * pow(l, b) * sqrt(l / (force * s->mass_kg));
}

/* Solves m x'' = -F - d c x' for the contact radius c in units of the first radius, the speed x', and the time t. The
 * variable of the integration is s with dt/ds = dx/dc, which is 0 at the end of the tail. */
struct moved {
    const struct cor_scene_contact *contact;
    long double damper, unit, last;
};

static void moved_slopes(long double *dy, const long double *y, const void *of)
{
    const struct moved *const m = of;
    long double slope, force;
    overlap_of(m->contact, y[0] * m->unit, &slope, &force);
    dy[0] = y[1] / m->unit;
    dy[1] = -slope * (force + m->damper * y[0] * m->unit * y[1]) / (long double)m->contact->mass_kg;
    dy[2] = slope; /* the time */
}

static long double above_last(const long double *y, const void *of)
{
    return y[0] - ((const struct moved *)of)->last;
}

static long double falling(const long double *y, const void *of)
{
    (void)of;
    return -y[1];
}

static long double moved_eps(const struct cor_scene_contact *s, double speed, int end, long double *duration)
{
    static ode_value *const values[] = {above_last, falling};
    const struct moved m = {s, (long double)cor_scene_damping(s, COR_SCENE_DAMPING_COEFFICIENT) / sqrtl(s->radius_m),
                            first_radius(s), last_radius(s, end) / first_radius(s)};
    struct ode o = {.slopes = moved_slopes, .of = &m, .n = 3, .longest = 0.05L * m.unit / (long double)speed};
    long double y[3] = {1, speed, 0};
    int ends = -1;
    while (ends < 0)
        ends = ode_until(&o, y, values, 2);
    *duration = y[2];
    return ends > 0 ? 0 : -y[1] / (long double)speed;
}

TEST(damped)
{
    static const double times[] = {1e-9, 5e-9, 5e-8}, over[] = {1.02, 1.5, 6};
    for (int i = 0; i < 3; i++)
        for (int end = 0; end < COR_SCENE_ENDS; end++) {
            const struct cor_scene_contact s = spheres(times[i], 0.1), elastic = spheres(0, 0.1);
            const double stick = cor_scene_sticking_speed(&s, end);
            assert_true(stick > cor_scene_sticking_speed(&elastic, end));
            for (int k = 0; k < 3; k++) {
                const double eps = scene_eps(&s, over[k] * stick, end);
                long double duration;
                const double moved = (double)moved_eps(&s, over[k] * stick, end, &duration);
                check(fabs(eps * eps - moved * moved) < 2e-7, "A = %g, %g v_s, end %d: %.12g, moved %.12g", times[i],
                      over[k], end, eps, moved);
            }
            const double eps = scene_eps(&s, stick * (1 + 1e-9), end);
            assert_true(scene_eps(&s, stick * (1 - 1e-12), end) == 0 && eps > 0 && eps < 1e-3);
        }
}

/* Near the sticking speed, where eps is small, rounding errors of eps^2 change the duration. */
TEST(durations)
{
    draw_begin();
    for (int i = 0; i < 4; i++) {
        const int end = i % COR_SCENE_ENDS;
        const struct cor_scene_contact s = spheres(random_log(&draw, 1e-10, 2e-8), 0.1);
        const double speed = cor_scene_sticking_speed(&s, end) * (1 + random_log(&draw, 1e-6, 1e-3));
        const struct cor_scene_impact impact = scene_impact(&s, speed);
        long double duration;
        const double eps = (double)moved_eps(&s, speed, end, &duration);
        check(fabs(impact.eps[end] * impact.eps[end] - eps * eps) < COR_JKR_EPS2_MAX_ERROR, "eps = %g", eps);
        check_near(impact.duration_s[end], duration, COR_JKR_EPS2_MAX_ERROR * fmax(1, 0.01 / eps));
    }
}

/* Damping of any strength has a result. Bodies part above the sticking speed, which may be infinite. Bodies that creep
 * to rest never part. */
TEST(creeping)
{
    draw_begin();
    for (size_t i = 0; i < points(400); i++) {
        static const struct cor_exponents laws[] = {{3, 1, 2}, {6, 1, 4}, {3, 0, 2}, {3, 3, 2}};
        struct cor_scene_contact s = spheres(0, 0.1);
        s.law = laws[random_below(&draw, 4)];
        cor_scene_set_damping(&s, COR_SCENE_DAMPING_COEFFICIENT, 1, 1, 0);
        s.damping *= random_log(&draw, 1e-3, 30) / kappa_of(&s); /* kappa (docs/theory.md, 23) becomes 1e-3 to 30 */
        const int end = (int)random_below(&draw, COR_SCENE_ENDS);
        const double stick = cor_scene_sticking_speed(&s, end), v = random_log(&draw, 1e-4, 1e2);
        const double speed = random_below(&draw, 2) && isfinite(stick) ? stick * (1 + (v > 0.1 ? 1e-9 : -1e-9)) : v;
        const struct cor_scene_impact impact = scene_impact(&s, speed);
        check((impact.eps[end] > 0) == (speed > stick) && isinf(impact.duration_s[end]) == !(speed > stick),
              "eps = %g at %g m/s, sticking %g", impact.eps[end], speed, stick);
    }
}

/* With little adhesion the sphere is nearly a viscoelastic one at zero overlap: eps, duration, overlap and force. */
TEST(little_adhesion)
{
    for (double time = 1e-9; time < 1e-6; time *= 7) {
        const struct cor_scene_contact s = spheres(time, 1e-11), free = spheres(time, 0);
        const struct cor_scene_impact impact = scene_impact(&s, 2), without = scene_impact(&free, 2);
        for (int end = 0; end < COR_SCENE_ENDS; end++) {
            check(fabs(impact.eps[end] - without.eps[COR_END_ZERO_OVERLAP]) < 1e-5, "eps at A = %g", time);
            check_near(impact.duration_s[end], without.duration_s[COR_END_ZERO_OVERLAP], 1e-3);
        }
        check_near(impact.max_overlap_m, without.max_overlap_m, 1e-5);
        check_near(cor_scene_force_max_n(&s, 2), cor_scene_force_max_n(&free, 2), 1e-5);
    }
}

TEST(round_trip)
{
    static const struct cor_exponents laws[] = {{3, 1, 2}, {6, 1, 4}, {3, 0, 2}, {3, 3, 2}};
    for (int i = 0; i < 4; i++)
        for (int end = 0; end < COR_SCENE_ENDS; end++) {
            struct cor_scene_contact s = spheres(0, 0.1);
            s.law = laws[i];
            assert_int_equal(cor_scene_set_damping(&s, COR_SCENE_RESTITUTION, 0.4, 0.3, end), COR_OK);
            check_near(scene_eps(&s, 0.3, end), 0.4, 2e-12);
        }
}

/* With Hertz's force the damper follows a contact radius only if b is 0, 1/4, 1/2 or 3/2. */
TEST(laws)
{
    static const struct cor_exponents has[] = {{3, 0, 2}, {6, 1, 4}, {3, 1, 2}, {3, 3, 2}},
                                      lacks[] = {{6, 3, 4}, {3, 2, 2}, {6, 5, 4}, {6, 7, 4}, {12, 1, 8}, {1, 0, 1}};
    for (int k = 0; k < 10; k++) {
        struct cor_scene scene = scene_without_numbers(COR_LAW_VISCOELASTIC);
        struct cor_scene_contact contacts[COR_SCENE_ENDS];
        struct cor_scene_fault fault;
        int count;
        scene.law = k < 4 ? has[k] : lacks[k - 4];
        scene.adhesion_model = COR_ADHESION_JKR;
        scene.number[COR_SCENE_STIFFNESS] = scene.number[COR_SCENE_EFFECTIVE_MASS] = 1;
        scene.number[COR_SCENE_ADHESION] = 0.1;
        assert_int_equal(cor_scene_contacts(contacts, &count, &fault, &scene),
                         k < 4 ? COR_FAULT_NO_BODIES : COR_FAULT_ADHESION_MODEL);
    }
}
