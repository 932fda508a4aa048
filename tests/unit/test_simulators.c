/* SPDX-License-Identifier: MIT */
/* Tests the table of simulators of cor/scene.h: the realised e of each model for the e that a user sets, and the number
 * that corrects it. Compares each conversion to a simulator's own number with its force law, integrated in SI units. */
#include "../reference/ode.h"
#include "scene.h"

static const double asked[] = {0.1, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99};
enum { ASKED = sizeof asked / sizeof *asked };

/* ---- realised e for the e that was set: found by running or reading each simulator, five digits ---- */

TEST(realised)
{
    static const struct {
        enum cor_simulator_model_id id;
        int value[ASKED]; /* realised e in units of 1e-5 */
    } row[] = {{COR_CHRONO_MATERIAL, {25273, 32486, 39714, 55028, 71820, 80810, 90203, 95051, 99002}},
               {COR_LIGGGHTS_RESTITUTION_LIMIT, {25273, 32486, 39714, 55028, 71820, 80810, 90203, 95051, 99002}},
               {COR_YADE_EN, {10008, 20025, 30018, 50001, 69977, 79993, 89992, 94808, 97895}},
               {COR_LAMMPS_HERTZ_TSUJI, {23501, 34335, 43960, 61608, 77767, 85338, 92836, 96515, 99302}},
               {COR_LAMMPS_HERTZ_TSUJI_LIMIT, {34996, 42921, 50258, 64584, 78768, 85774, 92940, 96540, 99303}},
               {COR_LAMMPS_HOOKE_TSUJI, {18941, 29734, 39579, 58090, 75476, 83751, 92024, 96112, 99220}},
               {COR_LAMMPS_HOOKE_TSUJI_2026, {6241, 15576, 25363, 45845, 67065, 77789, 88906, 94545, 98898}},
               {COR_LAMMPS_HERTZ_TSUJI_2026, {9948, 20034, 29991, 49992, 69994, 79891, 90018, 95107, 99014}},
               {COR_MFIX_HERTZIAN, {14128, 24582, 34597, 53957, 72716, 81915, 91008, 95516, 99105}},
               {COR_CHRONO_MULTICORE_FLORES, {6944, 15554, 25621, 47044, 68318, 78854, 89392, 94683, 98934}}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const struct cor_simulator_model *const m = cor_simulator_model(row[i].id);
        for (int k = 0; k < ASKED; k++)
            check(fabs(1e5 * cor_simulator_realised(m, asked[k]) - row[i].value[k]) <= 0.51, "%s at %g: %.6f", m->model,
                  asked[k], cor_simulator_realised(m, asked[k]));
    }
    /* each version of LAMMPS needs its own e' */
    enum cor_simulator_status status;
    const struct cor_simulator_model *const late = cor_simulator_model(COR_LAMMPS_HOOKE_TSUJI_2026);
    const double early = cor_simulator_e(cor_simulator_model(COR_LAMMPS_HOOKE_TSUJI), 0.5, &status);
    assert_true(fabs(early - 0.411395) < 5e-7 && fabs(cor_simulator_realised(late, early) - 0.366035) < 5e-7);
    /* exact models */
    const struct cor_simulator_model *exact[] = {
        cor_simulator_model(COR_LAMMPS_COEFF_RESTITUTION), cor_simulator_model(COR_LIGGGHTS_RESTITUTION),
        cor_simulator_model(COR_MERCURYDPM_LINEAR),        cor_simulator_model(COR_MFIX_LSD),
        cor_simulator_model(COR_DEM_ENGINE_HERTZ),         cor_simulator_model(COR_YADE_YOUNG_EN),
        cor_simulator_model(COR_LETHE_RESTITUTION),        cor_simulator_model(COR_GAZEBO_BOUNCE)};
    const struct cor_simulator_model *const esys = cor_simulator_model(COR_ESYS_HERTZ_MINDLIN);
    for (int k = 0; k < ASKED; k++) {
        for (size_t i = 0; i < COUNT_OF(exact); i++)
            assert_true(fabs(cor_simulator_realised(exact[i], asked[k]) - asked[k]) < 1e-14);
        assert_true(fabs(cor_simulator_realised(esys, asked[k]) - asked[k]) < 2e-8);
    }
    /* Kratos's bisection finds gamma to 0.0001 */
    check_near(cor_simulator_realised(cor_simulator_model(COR_KRATOS_LINEAR), 0.99), 0.99, 3e-4);
    assert_true(cor_simulator_realised(cor_simulator_model(COR_KRATOS_HERTZ), 0.9995) == 1);
    /* Thornton's fit at e = 1 */
    check_near(cor_simulator_realised(cor_simulator_model(COR_GRANULARS_EN), 1), 0.98459, 1e-5);
    assert_true(cor_simulator_realised(cor_simulator_model(COR_YADE_EN), 1) == 1);
    /* OpenFOAM's number is beta = sqrt(5) zeta; it is 0.12 in the tutorials */
    const struct cor_scene_contact contact = {.mass_kg = 1, .stiffness = 1, .radius_m = 1};
    const struct cor_simulator_model *const openfoam = cor_simulator_model(COR_OPENFOAM_PAIR);
    const double zeta = openfoam->damping_of_number(openfoam, 0.12, &contact, 1);
    check_near(cor_law_eps(COR_LAW_TSUJI, COR_END_ZERO_OVERLAP, zeta), 0.84465, 1e-5);
    /* MuJoCo's default */
    check_near(cor_law_eps(COR_LAW_LINEAR, COR_END_ZERO_FORCE, 1), exp(-2), 1e-15);
}

/* The eps of formulas for d g at e = 0.1, 0.5 and 0.9 (docs/errata.md): Hunt and Crossley (1975); Lankarani and
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

/* ---- the correction ---- */

TEST(cures)
{
    enum cor_simulator_status status;
    /* each model with an e realises the request with the corrected e, or gives the reason */
    for (int i = 0; i < COR_SIMULATOR_MODELS; i++) {
        const struct cor_simulator_model *const m = cor_simulator_model((enum cor_simulator_model_id)i);
        const double tolerance = m->id == COR_KRATOS_LINEAR ? 3e-4 : 1e-9; /* Kratos bisects */
        double least, most;
        cor_simulator_reach(m, &least, &most);
        for (double e = 0.005; e < 1; e += 0.005) {
            const double cure = cor_simulator_e(m, e, &status), back = cor_simulator_realised(m, cure);
            if (!m->damping_of_e)
                assert_true(status == COR_SIMULATOR_NOT_ASKED && isnan(cure) && isnan(cor_simulator_realised(m, e)) &&
                            isnan(least));
            else if (status != COR_SIMULATOR_OK)
                check(isnan(cure) && (status == COR_SIMULATOR_TOO_SMALL ? e < least + 1e-6 : e > most - 1e-4),
                      "%s: %g refused", m->model, e);
            else
                check(fabs(back - e) < tolerance, "%s: %g by %g gives %g", m->model, e, cure, back);
        }
    }
}

TEST(limits)
{
    enum cor_simulator_status status;
    double least, most;
    /* LIGGGHTS refuses e up to 0.05: with the force limit it cannot realise less than 0.2137 */
    const struct cor_simulator_model *m = cor_simulator_model(COR_LIGGGHTS_RESTITUTION_LIMIT);
    cor_simulator_reach(m, &least, &most);
    assert_true(fabs(least - 0.2137) < 5e-5 && most > 1 - 1e-15 && isnan(cor_simulator_realised(m, 0.04)));
    assert_true(isnan(cor_simulator_e(m, 0.2, &status)) && status == COR_SIMULATOR_TOO_SMALL);
    assert_true(cor_simulator_e(m, 1, &status) == 1 && status == COR_SIMULATOR_OK);
    /* Chrono's clamp: 0.1360 */
    cor_simulator_reach(cor_simulator_model(COR_CHRONO_MATERIAL), &least, &most);
    assert_true(fabs(least - 0.1360) < 5e-5);
    /* Thornton's fit reaches at most 0.9846 */
    m = cor_simulator_model(COR_GRANULARS_EN);
    cor_simulator_reach(m, &least, &most);
    assert_true(most < 0.9847 && most > 0.9845);
    assert_true(isnan(cor_simulator_e(m, 0.99, &status)) && status == COR_SIMULATOR_TOO_LARGE);
    assert_true(cor_simulator_e(m, 0.98, &status) < 1 && status == COR_SIMULATOR_OK);
    /* e is clamped at both ends; outside the range the result is NaN */
    assert_true(isnan(cor_simulator_realised(m, 1.01)) && isnan(cor_simulator_realised(m, -0.1)) &&
                isnan(cor_simulator_realised(m, NAN)));
    assert_true(cor_simulator_realised(cor_simulator_model(COR_MFIX_LSD), 0) == 0 &&
                fabs(cor_simulator_realised(cor_simulator_model(COR_MFIX_HERTZIAN), 0) - 0.00187) < 5e-6);
}

/* ---- units: the simulator's own force law in SI units against the scaled law ---- */

struct pair {
    double mass, stiffness, radius, speed, a; /* numbers of the contact, the impact and the spring */
};

/* Returns the damping for en at vn = 1 m/s: YADE solves P(v) = en and sets A = (2/3) v^2 vn^(-1/5) (K/m)^(-2/5). */
static double yade_damping(double en)
{
    double low = 0, high = 8;
    while (high - low > 1e-12) {
        const double v = (low + high) / 2;
        const double p = 1 + v * (1.07232 + v * (0.574198 + v * 0.141552));
        const double q =
            1 + v * (1.07232 + v * (1.72765 + v * (1.37842 + v * (1.19449 + v * (0.467273 + v * 0.235585)))));
        *(p / q > en ? &low : &high) = v;
    }
    return low * low;
}

/* The damping force in the simulator's source for the number n: factor n m^mass K^stiffness R^radius g^speed x^b v */
static const struct damper {
    enum cor_simulator_model_id id;
    double factor, mass, stiffness, radius, speed, b;
} dampers[] = {
    {COR_LAMMPS_HOOKE_VELOCITY, 1, 0, 0, 0, 0, 0},
    {COR_LAMMPS_HOOKE_VELOCITY_LIMIT, 1, 0, 0, 0, 0, 0},
    {COR_LAMMPS_HOOKE_MASS_VELOCITY, 1, 1, 0, 0, 0, 0},
    {COR_LAMMPS_HOOKE_MASS_VELOCITY_LIMIT, 1, 1, 0, 0, 0, 0},
    {COR_LAMMPS_HOOKE_VISCOELASTIC, 1, 1, 0, 0.5, 0, 0.5},
    {COR_LAMMPS_HERTZ_VISCOELASTIC, 1, 1, 0, 0.5, 0, 0.5},
    {COR_LAMMPS_HERTZ_VISCOELASTIC_LIMIT, 1, 1, 0, 0.5, 0, 0.5},
    {COR_LAMMPS_HERTZ_VELOCITY, 1, 0, 0, 0, 0, 0},
    {COR_LAMMPS_HERTZ_MASS_VELOCITY, 1, 1, 0, 0, 0, 0},
    {COR_LIGGGHTS_HERTZ_GAMMAN, 1, 1, 0, 0.5, 0, 0.5},
    {COR_LIGGGHTS_HERTZ_GAMMAN_LIMIT, 1, 1, 0, 0.5, 0, 0.5},
    {COR_LIGGGHTS_HOOKE_GAMMAN, 1, 1, 0, 0, 0, 0},
    {COR_LIGGGHTS_HOOKE_GAMMAN_LIMIT, 1, 1, 0, 0, 0, 0},
    {COR_YADE_BETAN, 2.449489742783178, 0.5, 0.5, 0, 0, 0.25},
    {COR_YADE_EN_VN, 1, 0.4, 0.6, 0, 0, 0.5},
    {COR_YADE_KN_CN, 0.5, 0, 0, 0, 0, 0},
    {COR_MERCURYDPM_HERTZIAN_DISSIPATION, 1, 0.5, 0.5, 0, 0, 0.25},
    {COR_MERCURYDPM_BSHP, 1.5, 0, 1, 0, 0, 0.5},
    {COR_CHRONO_HOOKE, 1, 1, 0, 0, 0, 0},
    {COR_CHRONO_HERTZ, 1, 1, 0, 1, 0, 0.5},
    {COR_OPENFOAM_PAIR, 1, 0.5, 0.5, 0, 0, 0.25},
    {COR_KRATOS_HERTZ_GAMMA, 2.449489742783178, 0.5, 0.5, 0, 0, 0.25},
    {COR_KRATOS_LINEAR_GAMMA, 2, 0.5, 0.5, 0, 0, 0},
    {COR_ESYS_HERTZIAN, 1, 0, 1, 0, 0, 0.5},
    {COR_EXADEM_DAMP_RATE, 2, 0.5, 0.5, 0, 0, 0},
    {COR_PFC_LINEAR, 2, 0.5, 0.5, 0, 0, 0},
    {COR_PFC_LINEAR_PUSHES, 2, 0.5, 0.5, 0, 0, 0},
    {COR_BULLET_STIFFNESS, 1, 0, 0, 0, 0, 0},
    {COR_GAZEBO_KP_KD, 1, 0, 0, 0, 0, 0},
    {COR_PHYSX_COMPLIANT, 1, 0, 0, 0, 0, 0},
    {COR_ISAAC_COMPLIANT, 1, 0, 0, 0, 0, 0},
    {COR_SIMSCAPE_DAMPED, 1, 0, 0, 0, 0, 0},
    {COR_SIMSCAPE_UNDAMPED, 1, 0, 0, 0, 0, 0},
    {COR_DRAKE_HUNT_CROSSLEY, 1, 0, 1, 0, 0, 1.5},
    {COR_DRAKE_SAP, 1, 0, 1, 0, 0, 0},
    {COR_SIMBODY_HUNT_CROSSLEY, 1.5, 0, 1, 0, 0, 1.5},
    {COR_MUJOCO_TIME_CONSTANT, 2, 0.5, 0.5, 0, 0, 0},
    {COR_MUJOCO_STIFFNESS, 1, 1, 0, 0, 0, 0},
    {COR_NEWTON_SEMI_IMPLICIT, 1, 0, 0, 0, 0, 0},
    {COR_MODELICA_LINEAR, 1, 0, 0, 0, 0, 0},
    {COR_MODELICA_HERTZ, 1, 0, 0, 0, 0, 0},
    {COR_OPENSEES_HERTZ_DAMP, 1, 0, 1, 0, -1, 1.5},
};

/* The force on a pair in units of its mass and impact speed and of `time` */
struct scaled_pair {
    const struct pair *s;
    enum cor_end end;
    double damping, b, time; /* the damping force is damping x^b v */
};

/* Returns the force. COR_END_APPROACH_ONLY: it is damped only during the approach. COR_END_LIMITED: the damping force
 * is at most the spring's force. */
static long double scaled_force(long double w, long double v, const void *of)
{
    const struct scaled_pair *const p = of;
    const struct pair *const s = p->s;
    const double unit = s->speed / p->time, length = s->speed * p->time; /* x = w^4 length */
    const long double elastic = s->stiffness * pow(length, s->a) * motion_power(w, (int)(4 * s->a));
    const long double whole =
        elastic + p->damping * pow(length, p->b) * motion_power(w, (int)(4 * p->b)) * v * s->speed;
    return (p->end == COR_END_APPROACH_ONLY && v < 0 ? elastic
            : p->end == COR_END_LIMITED              ? fminl(whole, 2 * elastic)
                                                     : whole) /
           (s->mass * unit);
}

static double integrated_eps(const struct pair *s, enum cor_end end, double damping, double b)
{
    const double time = pow(s->mass / s->stiffness, 1 / (s->a + 1)) * pow(s->speed, (1 - s->a) / (s->a + 1));
    const struct scaled_pair p = {s, end, damping, b, time};
    const int free = end == COR_END_ZERO_FORCE || end == COR_END_LIMITED;
    return (double)motion_course(&(struct motion){4, 0, scaled_force, &p, free, 0}).eps[free];
}

/* With a constant impedance d the contact is a linear dashpot, which is compared with the closed form. Small d under
 * gravity is compared with cor_scene_eps under a constant force, and d from 0.9 to 0.95 with eps of MuJoCo's own step.
 * */
TEST(mujoco)
{
    const double solimp[5] = {0.9, 0.9, 0.001, 0.5, 2}, grown[5] = {0.9, 0.95, 0.001, 0.5, 2};
    for (double zeta = 0; zeta < 3; zeta += 0.25)
        check_near(cor_mujoco_eps(solimp, 1, 100, zeta, 0.5, 0), cor_law_eps(COR_LAW_LINEAR, COR_END_ZERO_FORCE, zeta),
                   1e-5);
    check_near(cor_mujoco_eps(grown, 1, 50, 1, 1, 0), 0.13569664, 1e-8);
    struct cor_scene_contact pressed = {
        .law = cor_law_exponents[COR_LAW_LINEAR], .mass_kg = 1, .stiffness = 1e4, .damping = 0.2, .force_n = 9.8};
    double eps;
    assert_int_equal(cor_scene_eps(&eps, &pressed, 0.5, COR_END_ZERO_FORCE), COR_OK);
    check_near(cor_mujoco_eps((const double[]){1e-4, 1e-4, 0.001, 0.5, 2}, 1, 100, 0.2, 0.5, 9.8), eps, 1e-3);
    /* two balls that libmujoco 2.2.2 dropped on a plane at 0.5 m/s, with a step of 2e-6 s */
    check_near(cor_mujoco_eps((const double[]){0.95, 0.95, 0.001, 0.5, 2}, 1, 100, 0.5, 0.5, 9.81), 0.151317, 2.5e-3);
    check_near(cor_mujoco_eps((const double[]){0.5, 0.9, 0.01, 0.5, 2}, 1, 1 / 0.006, 0.3, 0.5, 9.81), 0.307851, 3e-4);
    /* the same with pyramidal cones, without gravity: friction 2 with condim 3, and 0.5 with condim 4 */
    const double wide[5] = {0.5, 0.9, 0.01, 0.5, 2};
    check_near(cor_mujoco_eps(wide, 4 * 5 / 2.0, 1 / 0.006, 0.3, 0.5, 0), 0.696060, 3e-4);
    check_near(cor_mujoco_eps(wide, 0.25 * 1.25 / 3, 1 / 0.006, 0.3, 0.5, 0), 0.367681, 3e-4);
    assert_true(isnan(cor_mujoco_eps(solimp, 1, 0, 1, 1, 0)) && isnan(cor_mujoco_eps(solimp, 1, 1e200, 1, 1, 0)));
    assert_true(isnan(cor_mujoco_eps((const double[]){0.9, 0.9, 0, 0.5, 2}, 1, 1, 1, 1, 0)));
}

TEST(units)
{
    size_t numbers = 0;
    for (int i = 0; i < COR_SIMULATOR_MODELS; i++)
        numbers += cor_simulator_model((enum cor_simulator_model_id)i)->number_of_damping != NULL;
    assert_int_equal(numbers, COUNT_OF(dampers));
    for (size_t i = 0; i < COUNT_OF(dampers); i++) {
        const struct damper *const d = &dampers[i];
        const struct cor_simulator_model *const m = cor_simulator_model(d->id);
        const struct cor_exponents *const law = &cor_law_exponents[m->law];
        const double a = (double)law->elastic / law->denominator, b = (double)law->damping / law->denominator;
        const int ratio = m->law == COR_LAW_LINEAR || m->law == COR_LAW_TSUJI; /* the number `damping` is zeta */
        const double damping = 0.35, beta = damping * (ratio ? sqrt(2 * (a + 1)) : 1);
        const double eps = integrated_eps(&(struct pair){1, 1, 1, 1, a}, m->end, beta, b);
        const double closed = cor_law_eps(m->law, m->end, damping);
        check(isnan(closed) || fabs(closed - eps) < 2e-5, "%s: %g, not %g", m->model, eps, closed);
        for (int turn = 0; turn < 2; turn++) {
            const struct pair s = {m->mass == COR_MASS_PER_UNIT ? 1 : random_log(&draw, 1e-6, 10),
                                   random_log(&draw, 1e2, 1e7), random_log(&draw, 1e-4, 1), random_log(&draw, 1e-3, 10),
                                   a};
            const struct cor_scene_contact contact = {
                .mass_kg = s.mass, .stiffness = s.stiffness, .radius_m = s.radius};
            const double number = m->number_of_damping(m, damping, &contact, s.speed);
            check_near(m->damping_of_number(m, number, &contact, s.speed), damping, 1e-14);
            const double of_number = m->id == COR_YADE_EN_VN ? yade_damping(number) : number;
            const double coefficient = d->factor * of_number * pow(s.mass, d->mass) * pow(s.stiffness, d->stiffness) *
                                       pow(s.radius, d->radius) * pow(s.speed, d->speed);
            const double si = integrated_eps(&s, m->end, coefficient, d->b);
            check(fabs(si - eps) < 2e-5, "%s: %g, not %g", m->model, si, eps);
            /* at another speed, an equal number gives an equal eps only if the law has a damping ratio */
            const double other = m->damping_of_number(m, number, &contact, 3 * s.speed);
            const int constant = ratio || m->id == COR_OPENSEES_HERTZ_DAMP;
            assert_true(constant ? fabs(other / damping - 1) < 1e-14 : fabs(other / damping - 1) > 0.1);
        }
    }
    /* MercuryDPM computes its dashpot from the mass of one particle, sqrt(2 mass k/(pi^2 + ln(e)^2)) (-ln(e)); two such
     * particles have half of this mass as effective mass, and their collision realises e. */
    const struct cor_simulator_model *const m = cor_simulator_model(COR_MERCURYDPM_LINEAR);
    for (int k = 0; k < ASKED; k++) {
        const double mass = 0.3, stiffness = 2e4, l = log(asked[k]), pi = 3.14159265358979323846;
        const struct pair pair = {.mass = mass / 2, .stiffness = stiffness, .speed = 0.7, .a = 1};
        const double dashpot = sqrt(2 * mass * stiffness / (pi * pi + l * l)) * -l;
        const double eps = integrated_eps(&pair, m->end, dashpot, 0);
        check(fabs(eps - asked[k]) < 2e-5, "MercuryDPM realises %g, not %g", eps, asked[k]);
    }
}

/* Every id has one row, in which no text is missing. A simulator with lines has comments. */
TEST(rows_are_whole)
{
    int rows = 0, found[COR_SIMULATOR_MODELS] = {0};
    for (const struct cor_simulator *s = cor_simulators; s < cor_simulators + cor_simulator_count; s++) {
        assert_int_equal(s->packaged, s->version ? cor_simulator_version(s->version) : 0);
        for (const struct cor_simulator_model *m = s->models; m < s->models + s->model_count; m++, rows++) {
            const char *const words[] = {s->name, s->title, m->model, m->parameter, m->file, m->advice, m->version};
            for (size_t k = 0; k < COUNT_OF(words); k++)
                check(words[k] && strlen(words[k]) > 0, "model %d has no text %zu", m->id, k);
            assert_true((m->lines || !m->wall_lines) && (s->comment || !m->lines));
            assert_true((m->damping_of_e != NULL) != (m->number_of_damping != NULL));
            assert_true((m->number_of_damping != NULL) == (m->damping_of_number != NULL));
            assert_true((strcmp(m->parameter, "e") == 0) == (m->damping_of_e != NULL));
            assert_true(strcmp(m->known, "run") == 0 || strcmp(m->known, "source") == 0 ||
                        strcmp(m->known, "documentation") == 0);
            assert_true(m->advice[strlen(m->advice) - 1] == '.');
            assert_true(found[m->id]++ == 0 && cor_simulator_model(m->id) == m && cor_simulator_of(m->id) == s);
            for (const struct cor_simulator_model *other = s->models; other < m; other++)
                assert_string_not_equal(other->model, m->model);
        }
    }
    assert_int_equal(rows, COR_SIMULATOR_MODELS);
    assert_null(cor_simulator_model(COR_SIMULATOR_MODELS));
}
