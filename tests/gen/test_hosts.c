/* SPDX-License-Identifier: MIT */
/* The table of simulators: what each model makes of a restitution that a user asks for, the number that cures it, and
 * every conversion to a host's own number against its force law, integrated in SI units. */
#include "check.h"

#include "hosts/hosts.h"

static const struct host_model *model_named(const char *host, const char *part)
{
    for (size_t i = 0; i < host_model_count; i++)
        if (strcmp(host_models[i].host, host) == 0 && strstr(host_models[i].model, part) != NULL)
            return &host_models[i];
    fail_msg("no model %s %s", host, part);
    return NULL;
}

static const double asked[] = {0.1, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99};
enum { ASKED = sizeof asked / sizeof *asked };

/* ---- realised for asked: numbers found by running or reading each host, five digits ---- */

static void realised(void **state)
{
    (void)state;
    static const struct {
        const char *host, *model;
        double value[ASKED];
    } row[] = {
        {"chrono", "from material", {0.25273, 0.32486, 0.39714, 0.55028, 0.71820, 0.80810, 0.90203, 0.95051, 0.99002}},
        {"liggghts", "limitForce", {0.25273, 0.32486, 0.39714, 0.55028, 0.71820, 0.80810, 0.90203, 0.95051, 0.99002}},
        {"yade", "(2023 and later)", {0.10008, 0.20025, 0.30018, 0.50001, 0.69977, 0.79993, 0.89992, 0.94808, 0.97895}},
        {"lammps",
         "tsuji, releases",
         {0.23501, 0.34335, 0.43960, 0.61608, 0.77767, 0.85338, 0.92836, 0.96515, 0.99302}},
        {"lammps",
         "tsuji, limit_damping",
         {0.34996, 0.42921, 0.50258, 0.64584, 0.78768, 0.85774, 0.92940, 0.96540, 0.99303}},
        {"lammps",
         "hooke, damping tsuji, releases",
         {0.18941, 0.29734, 0.39579, 0.58090, 0.75476, 0.83751, 0.92024, 0.96112, 0.99220}},
        {"lammps",
         "hooke, damping tsuji, source after",
         {0.06241, 0.15576, 0.25363, 0.45845, 0.67065, 0.77789, 0.88906, 0.94545, 0.98898}},
        {"lammps",
         "hertz, damping tsuji, source after",
         {0.09948, 0.20034, 0.29991, 0.49992, 0.69994, 0.79891, 0.90018, 0.95107, 0.99014}},
        {"mfix", "HERTZIAN", {0.14128, 0.24582, 0.34597, 0.53957, 0.72716, 0.81915, 0.91008, 0.95516, 0.99105}},
        {"chrono-multicore",
         "Flores",
         {0.06944, 0.15554, 0.25621, 0.47044, 0.68318, 0.78854, 0.89392, 0.94683, 0.98934}},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const struct host_model *m = model_named(row[i].host, row[i].model);
        for (int k = 0; k < ASKED; k++)
            check(fabs(host_realised(m, asked[k]) - row[i].value[k]) <= 0.51e-5, "%s, %s at %g: %.6f, not %.5f",
                  m->host, m->model, asked[k], host_realised(m, asked[k]), row[i].value[k]);
    }
    /* the e' for one version of LAMMPS is not the one for another */
    enum host_cure_status status;
    const struct host_model *const late = model_named("lammps", "hooke, damping tsuji, source after");
    const double early = host_cure(model_named("lammps", "hooke, damping tsuji, releases"), 0.5, &status);
    assert_true(fabs(early - 0.411395) < 5e-7 && fabs(host_realised(late, early) - 0.366035) < 5e-7);
    /* exact ones */
    const struct host_model *exact[] = {
        model_named("lammps", "coeff_restitution"), model_named("liggghts", "coefficientRestitution"),
        model_named("mercurydpm", "LinearViscoelastic"), model_named("mfix", "LSD"), model_named("dem-engine", "CoR")};
    for (size_t i = 0; i < sizeof exact / sizeof *exact; i++)
        for (int k = 0; k < ASKED; k++)
            assert_true(fabs(host_realised(exact[i], asked[k]) - asked[k]) < 1e-14);
    for (int k = 0; k < ASKED; k++)
        assert_true(fabs(host_realised(model_named("esys-particle", "COR"), asked[k]) - asked[k]) < 2e-8);
    /* 0.9 and 0.99 of Kratos's bisection: gamma good to 0.0001 */
    assert_true(fabs(host_realised(model_named("kratos", "linear, COEF"), 0.99) / 0.99 - 1) < 3e-4);
    assert_true(host_realised(model_named("kratos", "Hertz, COEF"), 0.9995) == 1);
    /* Thornton's fit at e = 1 */
    assert_true(fabs(host_realised(model_named("granulars.jl", "en"), 1) - 0.98459) < 1e-5);
    assert_true(host_realised(model_named("yade", "(2023"), 1) == 1);
    /* beta = sqrt(5) zeta, 0.12 in OpenFOAM's tutorials */
    const struct host_scene scene = {1, 1, 1, 1};
    assert_true(
        fabs(host_eps(HOST_TSUJI, HOST_ZERO_OVERLAP, model_named("openfoam", "pair")->damping_of_number(0.12, &scene)) -
             0.84465) < 1e-5);
    /* MuJoCo's default */
    assert_true(fabs(host_eps(HOST_LINEAR, HOST_ZERO_FORCE, 1) - exp(-2)) < 1e-15);
    /* Simbody's e = 1 - c v at c v = 0.5 */
    assert_true(fabs(host_eps(HOST_HUNT_CROSSLEY, HOST_ZERO_FORCE, 0.75) - 0.663) < 5e-4);
}

static void formulas_for_hunt_and_crossley(void **state)
{
    (void)state;
    static const struct {
        host_map *map;
        double value[3]; /* at 0.1, 0.5, 0.9 */
        double digits;
    } row[] = {
        {host_crossley_hunt, {0.516, 0.663, 0.9090}, 6e-4},
        {host_crossley_lankarani, {0.665, 0.725, 0.9132}, 6e-4},
        {host_crossley_gonthier, {0.1010, 0.4877, 0.8764}, 6e-5},
        {host_crossley_herbert, {0.491, 0.594, 0.9009}, 6e-4},
        {host_crossley_hu, {0.0741, 0.4877, 0.8999}, 6e-5},
        {host_crossley_flores, {0.0694, 0.4704, 0.8939}, 6e-5},
    };
    static const double at[] = {0.1, 0.5, 0.9};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        for (int k = 0; k < 3; k++)
            check(fabs(host_eps(HOST_HUNT_CROSSLEY, HOST_ZERO_FORCE, row[i].map(at[k])) - row[i].value[k]) <
                      row[i].digits,
                  "formula %zu at %g: %g", i, at[k], host_eps(HOST_HUNT_CROSSLEY, HOST_ZERO_FORCE, row[i].map(at[k])));
}

/* ---- the cure ---- */

static void cures(void **state)
{
    (void)state;
    enum host_cure_status status;
    /* the cure e' of the exact zero-overlap formula where the force is cut off */
    static const double wanted[ASKED] = {NAN, 0.03446, 0.16522, 0.43629, 0.67919, 0.79117, 0.89789, 0.94948, 0.98998};
    const struct host_model *m = model_named("chrono", "from material");
    for (int k = 0; k < ASKED; k++) {
        const double cure = host_cure(m, asked[k], &status);
        if (k == 0)
            assert_true(status == HOST_CURE_TOO_SMALL && isnan(cure)); /* below exp(-2) */
        else
            check(status == HOST_CURE_OK && fabs(cure - wanted[k]) < 0.51e-5, "%g: %g", asked[k], cure);
    }
    /* MFiX Hertz: z0(e') = sqrt(5)/2 z0(e) */
    m = model_named("mfix", "HERTZIAN");
    static const double mfix[][2] = {{0.1, 0.06286}, {0.5, 0.45853}, {0.9, 0.88886}};
    for (int k = 0; k < 3; k++)
        assert_true(fabs(host_cure(m, mfix[k][0], &status) - mfix[k][1]) < 0.51e-5 && status == HOST_CURE_OK);
    /* Flores: 8/(8 + 5 beta) */
    m = model_named("chrono-multicore", "Flores");
    for (int k = 0; k < ASKED; k++) {
        const double beta = host_damping(HOST_HUNT_CROSSLEY, HOST_ZERO_FORCE, asked[k]);
        assert_true(fabs(host_cure(m, asked[k], &status) - 8 / (8 + 5 * beta)) < 1e-14);
    }
    /* whatever takes an e realises what its cure says, or tells why not */
    for (size_t i = 0; i < host_model_count; i++) {
        double least, most;
        host_reach(&host_models[i], &least, &most);
        for (double e = 0.005; e < 1; e += 0.005) {
            const double cure = host_cure(&host_models[i], e, &status);
            if (!host_models[i].damping_of_e) {
                assert_true(status == HOST_CURE_NOT_ASKED && isnan(cure) && isnan(host_realised(&host_models[i], e)) &&
                            isnan(least));
                continue;
            }
            if (status != HOST_CURE_OK) {
                check(isnan(cure) && (status == HOST_CURE_TOO_SMALL ? e < least + 1e-6 : e > most - 1e-4),
                      "%s, %s: %g refused", host_models[i].host, host_models[i].model, e);
                continue;
            }
            const double back = host_realised(&host_models[i], cure);
            const int bisected = strstr(host_models[i].model, "linear, COEF") != NULL;
            check(fabs(back - e) < (bisected ? 3e-4 : 1e-9), "%s, %s: %g by %g gives %g", host_models[i].host,
                  host_models[i].model, e, cure, back);
        }
    }
}

static void limits(void **state)
{
    (void)state;
    enum host_cure_status status;
    double least, most;
    /* LIGGGHTS takes nothing up to 0.05: with the force limit it cannot realise less than 0.2137 */
    const struct host_model *m = model_named("liggghts", "limitForce");
    host_reach(m, &least, &most);
    assert_true(fabs(least - 0.2137) < 5e-5 && most > 1 - 1e-15 && isnan(host_realised(m, 0.04)));
    assert_true(isnan(host_cure(m, 0.2, &status)) && status == HOST_CURE_TOO_SMALL);
    assert_true(host_cure(m, 1, &status) == 1 && status == HOST_CURE_OK);
    /* Chrono's clamp: 0.1360 */
    host_reach(model_named("chrono", "from material"), &least, &most);
    assert_true(fabs(least - 0.1360) < 5e-5);
    /* Thornton's fit reaches no more than 0.9846 */
    m = model_named("granulars.jl", "en");
    host_reach(m, &least, &most);
    assert_true(most < 0.9847 && most > 0.9845);
    assert_true(isnan(host_cure(m, 0.99, &status)) && status == HOST_CURE_TOO_LARGE);
    assert_true(host_cure(m, 0.98, &status) < 1 && status == HOST_CURE_OK);
    /* clamps at both ends, nothing outside */
    assert_true(isnan(host_realised(m, 1.01)) && isnan(host_realised(m, -0.1)) && isnan(host_realised(m, NAN)));
    assert_true(host_realised(model_named("mfix", "LSD"), 0) == 0 &&
                fabs(host_realised(model_named("mfix", "HERTZIAN"), 0) - 0.00187) < 5e-6);
}

/* ---- units: the host's own force law in SI units against the scaled law ---- */

typedef double force_law(double x, double v, double number, const struct host_scene *s);

static double hooke(const struct host_scene *s, double x)
{
    return s->stiffness * x;
}
static double hertz(const struct host_scene *s, double x)
{
    return s->stiffness * x * sqrt(x);
}
static double tangent(const struct host_scene *s, double x)
{
    return 1.5 * s->stiffness * sqrt(x);
}

#define FORCE(name, expression)                                                                                        \
    static double name(double x, double v, double number, const struct host_scene *s)                                  \
    {                                                                                                                  \
        return expression;                                                                                             \
    }
FORCE(hooke_velocity, hooke(s, x) + number * v)
FORCE(hooke_mass_velocity, hooke(s, x) + number * s->mass_kg * v)
FORCE(hooke_area, hooke(s, x) + number * s->mass_kg * sqrt(s->radius_m * x) * v)
FORCE(hertz_area, hertz(s, x) + number * s->mass_kg * sqrt(s->radius_m * x) * v)
FORCE(hertz_velocity, hertz(s, x) + number * v)
FORCE(hertz_mass_velocity, hertz(s, x) + number * s->mass_kg * v)
FORCE(hertz_tangent, hertz(s, x) + 2 * number * sqrt(s->mass_kg * tangent(s, x)) * v)
FORCE(hertz_alpha, hertz(s, x) + number * sqrt(s->mass_kg * s->stiffness * sqrt(x)) * v)
FORCE(hertz_time, hertz(s, x) + 1.5 * number * s->stiffness * sqrt(x) * v)
FORCE(hertz_time_esys, hertz(s, x) + number * s->stiffness * sqrt(x) * v)
FORCE(hertz_chrono, hertz(s, x) + number * s->mass_kg * s->radius_m * sqrt(x) * v)
FORCE(hooke_series, hooke(s, x) + number / 2 * v)
FORCE(hooke_ratio, hooke(s, x) + 2 * number * sqrt(s->mass_kg * s->stiffness) * v)
FORCE(hooke_relaxation, hooke(s, x) + s->stiffness * number * v)
FORCE(hooke_per_mass, s->mass_kg *(s->stiffness *x + number * v)) /* mass 1 in the scene */
FORCE(crossley_d, hertz(s, x) * (1 + number * v))
FORCE(crossley_simbody, hertz(s, x) * (1 + 1.5 * number * v))
/* en at vn = 1 m/s: YADE solves P(v) = en and sets A = (2/3) v^2 vn^(-1/5) (K/m)^(-2/5). */
static double yade_damping(double en)
{
    static double last, v;
    if (en == last)
        return v * v;
    last = en;
    v = 0.5;
    for (int k = 0; k < 60; k++) {
        const double p = 1 + v * (1.07232 + v * (0.574198 + v * 0.141552)),
                     dp = 1.07232 + v * (2 * 0.574198 + v * 3 * 0.141552);
        const double q =
            1 + v * (1.07232 + v * (1.72765 + v * (1.37842 + v * (1.19449 + v * (0.467273 + v * 0.235585)))));
        const double dq = 1.07232 + v * (3.4553 + v * (4.13526 + v * (4.77796 + v * (2.336365 + v * 1.41351))));
        v -= (p - en * q) / (dp - en * dq);
    }
    return v * v;
}
FORCE(hertz_yade,
      hertz(s, x) + yade_damping(number) * pow(s->stiffness / s->mass_kg, -0.4) * s->stiffness * sqrt(x) * v)
FORCE(crossley_xi, hertz(s, x) * (1 + number * v / s->speed_m_s))

static const struct {
    const char *host, *model;
    force_law *force;
} forces[] = {
    {"lammps", "hooke, damping velocity", hooke_velocity},
    {"lammps", "hooke, damping velocity, limit_damping", hooke_velocity},
    {"lammps", "hooke, damping mass_velocity; gran", hooke_mass_velocity},
    {"lammps", "hooke, damping mass_velocity, limit", hooke_mass_velocity},
    {"lammps", "hooke, damping viscoelastic", hooke_area},
    {"lammps", "hertz, damping viscoelastic (the", hertz_area},
    {"lammps", "hertz, damping viscoelastic, limit", hertz_area},
    {"lammps", "hertz, damping velocity", hertz_velocity},
    {"lammps", "hertz, damping mass_velocity", hertz_mass_velocity},
    {"liggghts", "hertz/stiffness, gamman", hertz_area},
    {"liggghts", "hertz/stiffness, gamman, limit", hertz_area},
    {"liggghts", "hooke/stiffness, gamman", hooke_mass_velocity},
    {"liggghts", "hooke/stiffness, gamman, limit", hooke_mass_velocity},
    {"yade", "betan", hertz_tangent},
    {"yade", "vn", hertz_yade},
    {"yade", "kn and cn", hooke_series},
    {"mercurydpm", "HertzianViscoelastic, dissipation", hertz_alpha},
    {"mercurydpm", "BSHP", hertz_time},
    {"chrono", "Hooke, kn and gn", hooke_mass_velocity},
    {"chrono", "Hertz, kn and gn", hertz_chrono},
    {"openfoam", "pair", hertz_alpha},
    {"kratos", "Hertz, DAMPING", hertz_tangent},
    {"kratos", "linear, DAMPING", hooke_ratio},
    {"esys-particle", "ViscoElastic", hertz_time_esys},
    {"exadem", "damp_rate", hooke_ratio},
    {"drake", "point contact", crossley_d},
    {"drake", "SAP", hooke_relaxation},
    {"simbody", "Hunt", crossley_simbody},
    {"mujoco", "timeconst", hooke_ratio},
    {"mujoco", "-stiffness", hooke_per_mass},
    {"newton", "Solver", hooke_velocity},
    {"modelica", "n = 1", hooke_velocity},
    {"modelica", "n = 1.5", hertz_velocity},
    {"opensees", "xi", crossley_xi},
};

/* The force as the end of contact wants it: damped while approaching only, or damping no larger than the spring's force
 */
static double ended_force(force_law *force, enum host_end end, double x, double v, double number,
                          const struct host_scene *s)
{
    const double whole = force(x, v, number, s), elastic = force(x, 0, number, s);
    if (end == HOST_APPROACH_ONLY && v < 0)
        return elastic;
    return end == HOST_LIMITED && whole > 2 * elastic ? 2 * elastic : whole;
}

/* eps by velocity Verlet's cousin: the classical Runge-Kutta method with steps that are small where x is; accuracy 1e-6
 */
static double integrated_eps(force_law *force, enum host_end end, double number, const struct host_scene *s,
                             double time)
{
    double x = 0, v = s->speed_m_s;
    const double length = s->speed_m_s * time;
    for (long step = 0; step < 4000000; step++) {
        const double h = 2e-4 * time * fmin(1, 1e-3 + sqrt(fmax(x, 0) / length));
        double dx[4] = {0}, dv[4] = {0};
        for (int k = 0; k < 4; k++) {
            const double part = k == 0 ? 0 : k == 3 ? h : h / 2;
            const double at = k == 0 ? x : x + part * dx[k - 1], speed = k == 0 ? v : v + part * dv[k - 1];
            dx[k] = speed;
            dv[k] = at > 0 ? -ended_force(force, end, at, speed, number, s) / s->mass_kg : 0;
        }
        const double nx = x + h * (dx[0] + 2 * dx[1] + 2 * dx[2] + dx[3]) / 6;
        const double nv = v + h * (dv[0] + 2 * dv[1] + 2 * dv[2] + dv[3]) / 6;
        if (nx <= 0)
            return -v / s->speed_m_s;
        if (nv < 0 && (end == HOST_ZERO_FORCE || end == HOST_LIMITED) &&
            ended_force(force, end, nx, nv, number, s) <= 0)
            return -nv / s->speed_m_s;
        x = nx;
        v = nv;
    }
    return NAN;
}

/* The scaled law: stiffness, mass, speed and radius 1 */
static double scaled_law_force(double x, double v, double beta, double a, double b)
{
    return pow(x, a) + beta * pow(x, b) * v;
}
#define SCALED_LAW(name, a, b, factor)                                                                                 \
    static double name(double x, double v, double damping, const struct host_scene *s)                                 \
    {                                                                                                                  \
        (void)s;                                                                                                       \
        return scaled_law_force(x, v, (factor)*damping, a, b);                                                         \
    }
SCALED_LAW(scaled_linear, 1, 0, 2)
SCALED_LAW(scaled_tsuji, 1.5, 0.25, sqrt(5))
SCALED_LAW(scaled_root, 1, 0.5, 1)
SCALED_LAW(scaled_dashpot, 1.5, 0, 1)
SCALED_LAW(scaled_sphere, 1.5, 0.5, 1)
SCALED_LAW(scaled_crossley, 1.5, 1.5, 1)

static void units(void **state)
{
    (void)state;
    static force_law *const scaled[HOST_LAWS] = {scaled_linear,  scaled_tsuji,  scaled_root,
                                                 scaled_dashpot, scaled_sphere, scaled_crossley};
    static const struct host_scene unit = {1, 1, 1, 1};
    struct random_state random = random_start();
    size_t numbers = 0;
    for (size_t i = 0; i < host_model_count; i++)
        numbers += host_models[i].number_of_damping != NULL;
    assert_int_equal(numbers, sizeof forces / sizeof *forces);
    for (size_t i = 0; i < sizeof forces / sizeof *forces; i++) {
        const struct host_model *m = NULL;
        for (size_t k = 0; k < host_model_count && !m; k++)
            if (strcmp(host_models[k].host, forces[i].host) == 0 && strstr(host_models[k].model, forces[i].model) &&
                (host_models[k].number_of_damping != NULL) && strlen(host_models[k].model) >= strlen(forces[i].model))
                m = &host_models[k];
        if (m == NULL) {
            fail_msg("%s has no model %s", forces[i].host, forces[i].model);
            return;
        }
        const double damping = 0.35, a = m->law == HOST_LINEAR || m->law == HOST_LINEAR_ROOT ? 1 : 1.5;
        const double eps = integrated_eps(scaled[m->law], m->end, damping, &unit, 1);
        const double closed = host_eps(m->law, m->end, damping);
        assert_true(isnan(closed) || fabs(closed - eps) < 2e-5);
        for (int turn = 0; turn < 2; turn++) {
            const int per_mass = strstr(m->model, "-stiffness") != NULL;
            const struct host_scene s = {per_mass ? 1 : random_log(&random, 1e-6, 10), random_log(&random, 1e2, 1e7),
                                         random_log(&random, 1e-4, 1), random_log(&random, 1e-3, 10)};
            const double time = pow(s.mass_kg / s.stiffness, 1 / (a + 1)) * pow(s.speed_m_s, (1 - a) / (a + 1));
            const double number = m->number_of_damping(damping, &s);
            assert_true(fabs(m->damping_of_number(number, &s) / damping - 1) < 1e-14);
            const double si = integrated_eps(forces[i].force, m->end, number, &s, time);
            check(fabs(si - eps) < 2e-5, "%s, %s: %g, not %g", m->host, m->model, si, eps);
            /* the same number at another speed: the same eps where the law has a damping ratio, another one elsewhere
             */
            struct host_scene fast = s;
            fast.speed_m_s *= 3;
            const double other = m->damping_of_number(number, &fast);
            const int constant = m->law == HOST_LINEAR || m->law == HOST_TSUJI || strstr(m->model, "HertzDamp") != NULL;
            assert_true(constant ? fabs(other / damping - 1) < 1e-14 : fabs(other / damping - 1) > 0.1);
        }
    }
}

/* MercuryDPM computes its dashpot from the mass of one particle, sqrt(2 mass k/(pi^2 + ln(e)^2)) (-ln(e)); two such
 * particles have half of it as effective mass, and their collision realises e. */
static void mass_of_one_particle(void **state)
{
    (void)state;
    static const double pi = 3.14159265358979323846;
    const struct host_model *m = model_named("mercurydpm", "setStiffness");
    for (int k = 0; k < ASKED; k++) {
        const double mass = 0.3, stiffness = 2e4, l = -log(asked[k]);
        const struct host_scene pair = {mass / 2, stiffness, 1, 0.7};
        const double dashpot = sqrt(2 * mass * stiffness / (pi * pi + l * l)) * l;
        const double eps = integrated_eps(hooke_velocity, m->end, dashpot, &pair, sqrt(mass / 2 / stiffness));
        check(fabs(eps - asked[k]) < 2e-5, "MercuryDPM realises %g, not %g", eps, asked[k]);
        check(fabs(host_realised(m, asked[k]) - asked[k]) < 1e-15, "%g", host_realised(m, asked[k]));
    }
}

/* Drake's pair: two equal bodies keep their d, a rigid one has no say, and a pair with the d of the law realises e. */
static void pair_of_drake(void **state)
{
    (void)state;
    assert_true(fabs(host_drake_pair_dissipation(1e5, 2, 3e5, 6) - 3) < 1e-15); /* (3 2 + 1 6)/4 */
    assert_true(host_drake_pair_dissipation(3e5, 6, 1e5, 2) == host_drake_pair_dissipation(1e5, 2, 3e5, 6));
    assert_true(host_drake_pair_dissipation(1e5, 2, INFINITY, 6) == 2);
    assert_true(host_drake_pair_dissipation(INFINITY, 6, 1e5, 2) == 2);
    const struct host_model *m = model_named("drake", "point contact");
    const struct host_scene pair = {0.2, 4e5, 1, 0.7};
    const double e = 0.5, beta = host_damping(HOST_HUNT_CROSSLEY, HOST_ZERO_FORCE, e);
    const double d = m->number_of_damping(beta, &pair);
    /* body 1 given, body 2 by the rule */
    const double k1 = 2e6, k2 = 5e5, d1 = 0.5 * d, d2 = ((k1 + k2) * d - k2 * d1) / k1;
    const double of_pair = host_drake_pair_dissipation(k1, d1, k2, d2);
    const double time = pow(pair.mass_kg / pair.stiffness, 0.4) * pow(pair.speed_m_s, -0.2);
    check(fabs(integrated_eps(crossley_d, m->end, of_pair, &pair, time) - e) < 2e-5, "the pair does not realise e");
}

/* Every row says what a reader needs. */
static void rows_are_whole(void **state)
{
    (void)state;
    for (size_t i = 0; i < host_model_count; i++) {
        const struct host_model *m = &host_models[i];
        const char *const words[] = {m->host, m->model, m->parameter, m->file, m->known, m->advice, m->version};
        for (size_t k = 0; k < sizeof words / sizeof *words; k++)
            assert_non_null(words[k]);
        assert_true(m->version[0] != '\0' && (!m->paste || strchr(m->paste, '|') != NULL));
        assert_true((m->damping_of_e != NULL) != (m->number_of_damping != NULL));
        assert_true((m->number_of_damping != NULL) == (m->damping_of_number != NULL));
        assert_true((strcmp(m->parameter, "e") == 0) == (m->damping_of_e != NULL));
        assert_true(strlen(host_law_name(m->law)) > 0 && strlen(host_end_name(m->end)) > 0);
        assert_true(strcmp(m->known, "run") == 0 || strcmp(m->known, "source") == 0 ||
                    strcmp(m->known, "documentation") == 0);
        assert_true(m->advice[strlen(m->advice) - 1] == '.');
        for (size_t k = 0; k < i; k++)
            assert_true(strcmp(host_models[k].host, m->host) != 0 || strcmp(host_models[k].model, m->model) != 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(realised),
        cmocka_unit_test(formulas_for_hunt_and_crossley),
        cmocka_unit_test(cures),
        cmocka_unit_test(limits),
        cmocka_unit_test(units),
        cmocka_unit_test(rows_are_whole),
        cmocka_unit_test(mass_of_one_particle),
        cmocka_unit_test(pair_of_drake),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
