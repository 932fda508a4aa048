/* SPDX-License-Identifier: MIT */
/* cor/scene.h, the table of simulators: what each model makes of a restitution that a user asks for, the number
 * that cures it, and every conversion to a simulator's own number against its force law, integrated in SI units. */
#include <stdbool.h>

#include "motion.h"
#include "scene.h"

/* The first model of a simulator whose name has this part, of those that have a number of their own or of all */
static const struct cor_simulator_model *model_named(const char *simulator, const char *part, bool number)
{
    for (size_t i = 0; i < cor_simulator_model_count; i++)
        if (strcmp(cor_simulator_models[i].simulator, simulator) == 0 && strstr(cor_simulator_models[i].model, part) &&
            (!number || cor_simulator_models[i].number_of_damping))
            return &cor_simulator_models[i];
    fail_msg("no model %s %s", simulator, part);
    return NULL;
}

static const double asked[] = {0.1, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99};
enum { ASKED = sizeof asked / sizeof *asked };

/* ---- realised for asked: numbers found by running or reading each simulator, five digits ---- */

TEST(realised)
{
    static const struct {
        const char *simulator, *model;
        int value[ASKED]; /* in units of 1e-5 */
    } row[] = {
        {"chrono", "from material", {25273, 32486, 39714, 55028, 71820, 80810, 90203, 95051, 99002}},
        {"liggghts", "Restitution, limitForce", {25273, 32486, 39714, 55028, 71820, 80810, 90203, 95051, 99002}},
        {"yade", "(2023 and later)", {10008, 20025, 30018, 50001, 69977, 79993, 89992, 94808, 97895}},
        {"lammps", "tsuji, releases", {23501, 34335, 43960, 61608, 77767, 85338, 92836, 96515, 99302}},
        {"lammps", "tsuji, limit_damping", {34996, 42921, 50258, 64584, 78768, 85774, 92940, 96540, 99303}},
        {"lammps", "hooke, damping tsuji, releases", {18941, 29734, 39579, 58090, 75476, 83751, 92024, 96112, 99220}},
        {"lammps", "hooke, damping tsuji, source", {6241, 15576, 25363, 45845, 67065, 77789, 88906, 94545, 98898}},
        {"lammps", "hertz, damping tsuji, source", {9948, 20034, 29991, 49992, 69994, 79891, 90018, 95107, 99014}},
        {"mfix", "HERTZIAN", {14128, 24582, 34597, 53957, 72716, 81915, 91008, 95516, 99105}},
        {"chrono-multicore", "Flores", {6944, 15554, 25621, 47044, 68318, 78854, 89392, 94683, 98934}}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const struct cor_simulator_model *m = model_named(row[i].simulator, row[i].model, false);
        for (int k = 0; k < ASKED; k++)
            check(fabs(1e5 * cor_simulator_realised(m, asked[k]) - row[i].value[k]) <= 0.51, "%s, %s at %g: %.6f",
                  m->simulator, m->model, asked[k], cor_simulator_realised(m, asked[k]));
    }
    /* the e' for one version of LAMMPS is not the one for another */
    enum cor_simulator_status status;
    const struct cor_simulator_model *const late = model_named("lammps", "hooke, damping tsuji, source after", false);
    const double early = cor_simulator_e(model_named("lammps", "hooke, damping tsuji, releases", false), 0.5, &status);
    assert_true(fabs(early - 0.411395) < 5e-7 && fabs(cor_simulator_realised(late, early) - 0.366035) < 5e-7);
    /* exact ones */
    const struct cor_simulator_model *exact[] = {
        model_named("lammps", "coeff_restitution", false), model_named("liggghts", "coefficientRestitution", false),
        model_named("mercurydpm", "LinearViscoelastic", false), model_named("mfix", "LSD", false),
        model_named("dem-engine", "CoR", false)};
    const struct cor_simulator_model *const esys = model_named("esys-particle", "COR", false);
    for (int k = 0; k < ASKED; k++) {
        for (size_t i = 0; i < COUNT_OF(exact); i++)
            assert_true(fabs(cor_simulator_realised(exact[i], asked[k]) - asked[k]) < 1e-14);
        assert_true(fabs(cor_simulator_realised(esys, asked[k]) - asked[k]) < 2e-8);
    }
    /* 0.9 and 0.99 of Kratos's bisection: gamma good to 0.0001 */
    check_near(cor_simulator_realised(model_named("kratos", "linear, COEF", false), 0.99), 0.99, 3e-4);
    assert_true(cor_simulator_realised(model_named("kratos", "Hertz, COEF", false), 0.9995) == 1);
    /* Thornton's fit at e = 1 */
    check_near(cor_simulator_realised(model_named("granulars.jl", "en", false), 1), 0.98459, 1e-5);
    assert_true(cor_simulator_realised(model_named("yade", "(2023", false), 1) == 1);
    /* beta = sqrt(5) zeta, 0.12 in OpenFOAM's tutorials */
    const struct cor_scene_contact contact = {.mass_kg = 1, .stiffness = 1, .radius_m = 1};
    const double zeta = model_named("openfoam", "pair", false)->damping_of_number(0.12, &contact, 1);
    check_near(cor_law_eps(COR_LAW_TSUJI, COR_END_ZERO_OVERLAP, zeta), 0.84465, 1e-5);
    /* MuJoCo's default */
    check_near(cor_law_eps(COR_LAW_LINEAR, COR_END_ZERO_FORCE, 1), exp(-2), 1e-15);
}

/* eps that formulas for d g give at e = 0.1, 0.5 and 0.9 (docs/errata.md): Hunt and Crossley (1975); Lankarani and
 * Nikravesh (1990); Gonthier et al. (2004); Herbert and McWhannell (1977); Hu and Guo (2015); Flores et al. (2011) */
TEST(formulas_for_hunt_and_crossley)
{
    static const double at[3] = {0.1, 0.5, 0.9};
    static const double value[6][3] = {{0.516, 0.663, 0.9090}, {0.665, 0.725, 0.9132},   {0.1010, 0.4877, 0.8764},
                                       {0.491, 0.594, 0.9009}, {0.0741, 0.4877, 0.8999}, {0.0694, 0.4704, 0.8939}};
    static const double digits[6] = {6e-4, 6e-4, 6e-5, 6e-4, 6e-5, 6e-5};
    for (int k = 0; k < 3; k++) {
        const double e = at[k], lost = 1 - e;
        const double damping[6] = {1.5 * lost,         0.75 * lost * (1 + e),
                                   lost * (1 + e) / e, 6 * lost / ((2 * e - 1) * (2 * e - 1) + 3),
                                   1.5 * lost / e,     1.6 * lost / e};
        for (int i = 0; i < 6; i++) {
            const double eps = cor_law_eps(COR_LAW_HUNT_CROSSLEY, COR_END_ZERO_FORCE, damping[i]);
            check(fabs(eps - value[i][k]) < digits[i], "formula %d at %g: %g", i, e, eps);
        }
    }
}

/* ---- the cure ---- */

TEST(cures)
{
    enum cor_simulator_status status;
    /* whatever takes an e realises what its cure says, or tells why not */
    for (size_t i = 0; i < cor_simulator_model_count; i++) {
        double least, most;
        cor_simulator_reach(&cor_simulator_models[i], &least, &most);
        for (double e = 0.005; e < 1; e += 0.005) {
            const double cure = cor_simulator_e(&cor_simulator_models[i], e, &status);
            if (!cor_simulator_models[i].damping_of_e) {
                assert_true(status == COR_SIMULATOR_NOT_ASKED && isnan(cure) &&
                            isnan(cor_simulator_realised(&cor_simulator_models[i], e)) && isnan(least));
                continue;
            }
            if (status != COR_SIMULATOR_OK) {
                check(isnan(cure) && (status == COR_SIMULATOR_TOO_SMALL ? e < least + 1e-6 : e > most - 1e-4),
                      "%s, %s: %g refused", cor_simulator_models[i].simulator, cor_simulator_models[i].model, e);
                continue;
            }
            const double back = cor_simulator_realised(&cor_simulator_models[i], cure);
            const int bisected = strstr(cor_simulator_models[i].model, "linear, COEF") != NULL;
            check(fabs(back - e) < (bisected ? 3e-4 : 1e-9), "%s, %s: %g by %g gives %g",
                  cor_simulator_models[i].simulator, cor_simulator_models[i].model, e, cure, back);
        }
    }
}

TEST(limits)
{
    enum cor_simulator_status status;
    double least, most;
    /* LIGGGHTS takes nothing up to 0.05: with the force limit it cannot realise less than 0.2137 */
    const struct cor_simulator_model *m = model_named("liggghts", "coefficientRestitution, limit", false);
    cor_simulator_reach(m, &least, &most);
    assert_true(fabs(least - 0.2137) < 5e-5 && most > 1 - 1e-15 && isnan(cor_simulator_realised(m, 0.04)));
    assert_true(isnan(cor_simulator_e(m, 0.2, &status)) && status == COR_SIMULATOR_TOO_SMALL);
    assert_true(cor_simulator_e(m, 1, &status) == 1 && status == COR_SIMULATOR_OK);
    /* Chrono's clamp: 0.1360 */
    cor_simulator_reach(model_named("chrono", "from material", false), &least, &most);
    assert_true(fabs(least - 0.1360) < 5e-5);
    /* Thornton's fit reaches no more than 0.9846 */
    m = model_named("granulars.jl", "en", false);
    cor_simulator_reach(m, &least, &most);
    assert_true(most < 0.9847 && most > 0.9845);
    assert_true(isnan(cor_simulator_e(m, 0.99, &status)) && status == COR_SIMULATOR_TOO_LARGE);
    assert_true(cor_simulator_e(m, 0.98, &status) < 1 && status == COR_SIMULATOR_OK);
    /* clamps at both ends, nothing outside */
    assert_true(isnan(cor_simulator_realised(m, 1.01)) && isnan(cor_simulator_realised(m, -0.1)) &&
                isnan(cor_simulator_realised(m, NAN)));
    assert_true(cor_simulator_realised(model_named("mfix", "LSD", false), 0) == 0 &&
                fabs(cor_simulator_realised(model_named("mfix", "HERTZIAN", false), 0) - 0.00187) < 5e-6);
}

/* ---- units: the simulator's own force law in SI units against the scaled law ---- */

struct pair {
    double mass, stiffness, radius, speed; /* of the contact and the impact */
    double a, b;                           /* of the scaled law */
};
typedef double force_law(double x, double v, double n, const struct pair *s);

#define M s->mass
#define K s->stiffness
#define HOOKE (K * x)
#define HERTZ (K * x * sqrt(x))
#define FORCE(name, expression)                                                                                        \
    static double name(double x, double v, double n, const struct pair *s)                                             \
    {                                                                                                                  \
        return expression;                                                                                             \
    }
FORCE(scaled, pow(x, s->a) + n * pow(x, s->b) * v)
FORCE(hooke_velocity, HOOKE + n * v)
FORCE(hooke_mass_velocity, HOOKE + n * M * v)
FORCE(hooke_area, HOOKE + n * M * sqrt(s->radius * x) * v)
FORCE(hertz_area, HERTZ + n * M * sqrt(s->radius * x) * v)
FORCE(hertz_velocity, HERTZ + n * v)
FORCE(hertz_mass_velocity, HERTZ + n * M * v)
FORCE(hertz_tangent, HERTZ + 2 * n * sqrt(M * 1.5 * K * sqrt(x)) * v)
FORCE(hertz_alpha, HERTZ + n * sqrt(M * K * sqrt(x)) * v)
FORCE(hertz_time, HERTZ + 1.5 * n * K * sqrt(x) * v)
FORCE(hertz_time_esys, HERTZ + n * K * sqrt(x) * v)
FORCE(hertz_chrono, HERTZ + n * M * s->radius * sqrt(x) * v)
FORCE(hooke_series, HOOKE + n / 2 * v)
FORCE(hooke_ratio, HOOKE + 2 * n * sqrt(M * K) * v)
FORCE(hooke_relaxation, HOOKE + K * n * v)
FORCE(hooke_per_mass, M *(HOOKE + n * v)) /* with the mass 1 */
FORCE(crossley_d, HERTZ *(1 + n * v))
FORCE(crossley_simbody, HERTZ *(1 + 1.5 * n * v))
FORCE(crossley_xi, HERTZ *(1 + n * v / s->speed))
/* en at vn = 1 m/s: YADE solves P(v) = en and sets A = (2/3) v^2 vn^(-1/5) (K/m)^(-2/5). */
static double yade_damping(double en)
{
    static double last, v;
    for (double low = 0, high = 8; en != last && high - low > 1e-12;) {
        v = (low + high) / 2;
        const double p = 1 + v * (1.07232 + v * (0.574198 + v * 0.141552));
        const double q =
            1 + v * (1.07232 + v * (1.72765 + v * (1.37842 + v * (1.19449 + v * (0.467273 + v * 0.235585)))));
        *(p / q > en ? &low : &high) = v;
    }
    last = en;
    return v * v;
}
FORCE(hertz_yade, HERTZ + yade_damping(n) * pow(K / M, -0.4) * K * sqrt(x) * v)

static const struct {
    const char *simulator, *model;
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

/* The force as the end of contact has it: damped while approaching only, or damping no larger than the spring's force
 */
static double ended_force(force_law *force, enum cor_end end, double x, double v, double n, const struct pair *s)
{
    const double whole = force(x, v, n, s), elastic = force(x, 0, n, s);
    if (end == COR_END_APPROACH_ONLY && v < 0)
        return elastic;
    return end == COR_END_LIMITED && whole > 2 * elastic ? 2 * elastic : whole;
}

/* The force on a pair in units of its mass and impact speed and of `time` */
struct scaled_pair {
    force_law *force;
    enum cor_end end;
    double number, time;
    const struct pair *s;
};

static long double scaled_force(long double w, long double v, const void *of)
{
    const struct scaled_pair *const p = of;
    const struct pair *const s = p->s;
    const double unit = s->speed / p->time, x = (double)motion_power(w, 4) * s->speed * p->time;
    return ended_force(p->force, p->end, x, (double)v * s->speed, p->number, s) / (M * unit);
}

static double integrated_eps(force_law *force, enum cor_end end, double n, const struct pair *s, double time)
{
    const struct scaled_pair p = {force, end, n, time, s};
    const int free = end == COR_END_ZERO_FORCE || end == COR_END_LIMITED;
    return (double)motion_course(&(struct motion){4, 0, scaled_force, &p, free, NULL}, 5e-4L).eps[free];
}

TEST(units)
{
    size_t numbers = 0;
    for (size_t i = 0; i < cor_simulator_model_count; i++)
        numbers += cor_simulator_models[i].number_of_damping != NULL;
    assert_int_equal(numbers, sizeof forces / sizeof *forces);
    for (size_t i = 0; i < sizeof forces / sizeof *forces; i++) {
        const struct cor_simulator_model *const m = model_named(forces[i].simulator, forces[i].model, true);
        const struct cor_exponents *const law = &cor_law_exponents[m->law];
        const double a = (double)law->elastic / law->denominator, b = (double)law->damping / law->denominator;
        const bool ratio = m->law == COR_LAW_LINEAR || m->law == COR_LAW_TSUJI; /* the damping is zeta */
        const struct pair unit = {1, 1, 1, 1, a, b};
        const double damping = 0.35, beta = damping * (ratio ? sqrt(2 * (a + 1)) : 1);
        const double eps = integrated_eps(scaled, m->end, beta, &unit, 1);
        const double closed = cor_law_eps(m->law, m->end, damping);
        check(isnan(closed) || fabs(closed - eps) < 2e-5, "%s, %s: %g, not %g", m->simulator, m->model, eps, closed);
        for (int turn = 0; turn < 2; turn++) {
            const bool per_mass = strstr(m->model, "-stiffness") != NULL;
            const struct pair s = {per_mass ? 1 : random_log(&draw, 1e-6, 10),
                                   random_log(&draw, 1e2, 1e7),
                                   random_log(&draw, 1e-4, 1),
                                   random_log(&draw, 1e-3, 10),
                                   a,
                                   b};
            const struct cor_scene_contact contact = {
                .mass_kg = s.mass, .stiffness = s.stiffness, .radius_m = s.radius};
            const double time = pow(s.mass / s.stiffness, 1 / (a + 1)) * pow(s.speed, (1 - a) / (a + 1));
            const double number = m->number_of_damping(damping, &contact, s.speed);
            check_near(m->damping_of_number(number, &contact, s.speed), damping, 1e-14);
            const double si = integrated_eps(forces[i].force, m->end, number, &s, time);
            check(fabs(si - eps) < 2e-5, "%s, %s: %g, not %g", m->simulator, m->model, si, eps);
            /* the same number at another speed: the same eps where the law has a damping ratio, and nowhere else */
            const double other = m->damping_of_number(number, &contact, 3 * s.speed);
            const bool constant = ratio || strstr(m->model, "HertzDamp") != NULL;
            assert_true(constant ? fabs(other / damping - 1) < 1e-14 : fabs(other / damping - 1) > 0.1);
        }
    }
    /* MercuryDPM computes its dashpot from the mass of one particle, sqrt(2 mass k/(pi^2 + ln(e)^2)) (-ln(e)); two such
     * particles have half of it as effective mass, and their collision realises e. */
    const struct cor_simulator_model *const m = model_named("mercurydpm", "setStiffness", false);
    for (int k = 0; k < ASKED; k++) {
        const double mass = 0.3, stiffness = 2e4, l = log(asked[k]), pi = 3.14159265358979323846;
        const struct pair pair = {.mass = mass / 2, .stiffness = stiffness, .speed = 0.7};
        const double dashpot = sqrt(2 * mass * stiffness / (pi * pi + l * l)) * -l;
        const double eps = integrated_eps(hooke_velocity, m->end, dashpot, &pair, sqrt(mass / 2 / stiffness));
        check(fabs(eps - asked[k]) < 2e-5, "MercuryDPM realises %g, not %g", eps, asked[k]);
    }
}

/* Every row says what a reader needs. */
TEST(rows_are_whole)
{
    for (size_t i = 0; i < cor_simulator_model_count; i++) {
        const struct cor_simulator_model *m = &cor_simulator_models[i];
        const char *const words[] = {m->simulator, m->model, m->parameter, m->file, m->known, m->advice, m->version};
        for (size_t k = 0; k < sizeof words / sizeof *words; k++)
            assert_non_null(words[k]);
        assert_true(m->version[0] != '\0' && (m->lines || !m->wall_lines));
        assert_true((m->damping_of_e != NULL) != (m->number_of_damping != NULL));
        assert_true((m->number_of_damping != NULL) == (m->damping_of_number != NULL));
        assert_true((strcmp(m->parameter, "e") == 0) == (m->damping_of_e != NULL));
        assert_true(strlen(cor_law_name(m->law)) > 0 && strlen(cor_end_names[m->end]) > 0);
        assert_true(strcmp(m->known, "run") == 0 || strcmp(m->known, "source") == 0 ||
                    strcmp(m->known, "documentation") == 0);
        assert_true(m->advice[strlen(m->advice) - 1] == '.');
        for (size_t k = 0; k < i; k++)
            assert_true(strcmp(cor_simulator_models[k].simulator, m->simulator) != 0 ||
                        strcmp(cor_simulator_models[k].model, m->model) != 0);
    }
}

RUN_TESTS(realised, formulas_for_hunt_and_crossley, cures, limits, units, rows_are_whole)
