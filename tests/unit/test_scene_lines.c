/* SPDX-License-Identifier: MIT */
/* The lines for a simulator: which of them are active, and their numbers against the force laws of LAMMPS and LIGGGHTS
 * written down here; tests/simulators pastes them. */
#include "scene.h"

#define PI 3.14159265358979323846

static const double young = 1e7, poisson = 0.3, radius[] = {5e-3, 2e-2}, mass[] = {2e-3, 8e-3};

/* Spheres of the material, the second one at the number `second` of the arrays; -1: a wall */
static struct cor_scene bodies(enum cor_law law, int second)
{
    struct cor_scene scene = scene_without_numbers(law);
    scene_give(scene, {COR_SCENE_YOUNG, young}, {COR_SCENE_POISSON, poisson}, {COR_SCENE_RADIUS, radius[0]},
               {COR_SCENE_MASS, mass[0]});
    scene.wall = second < 0;
    if (second > 0) {
        scene_give(scene, {COR_SCENE_RADIUS_2, radius[second]}, {COR_SCENE_MASS_2, mass[second]});
    }
    return scene;
}

/* Above 0: the next texts are corrected for this time step. */
static double corrected_step_s;

static long lines_for(char *text, size_t size, const char *simulator, const char *version,
                      const struct cor_scene *scene, double speed)
{
    struct cor_scene_contact contacts[COR_SCENE_ENDS];
    struct cor_scene_fault fault;
    int count;
    assert_int_equal(cor_scene_contacts(contacts, &count, &fault, scene), COR_FAULT_NONE);
    const struct cor_simulator_request request = {.simulator = simulator,
                                                  .version = version,
                                                  .scene = scene,
                                                  .contacts = contacts,
                                                  .count = count,
                                                  .speed_m_s = &speed,
                                                  .speeds = speed > 0,
                                                  .time_step_s = corrected_step_s,
                                                  .step_errors = corrected_step_s > 0,
                                                  .step_corrected = corrected_step_s > 0,
                                                  .integrator = COR_NO_INTEGRATOR};
    return cor_simulator_lines(text, size, &request);
}

/* The text for a scene, or the refusal after "refused: "; valid until the next call */
static const char *text_for(const char *simulator, const char *version, const struct cor_scene *scene, double speed)
{
    static char text[20000] = "refused: ";
    return lines_for(text + 9, sizeof text - 9, simulator, version, scene, speed) < 0 ? text : text + 9;
}

/* Where the words begin in the text; the test fails if they do not. */
static const char *found(const char *text, const char *words)
{
    const char *const at = strstr(text, words);
    check(at != NULL, "no \"%s\" in\n%s", words, text);
    return at + strlen(words);
}

static void is_near(const char *number, double wanted, double tolerance)
{
    check(fabs(strtod(number, NULL) / wanted - 1) < tolerance, "%.20s is not %.12g", number, wanted);
}

static const char *const pairs[] = {"\npair_coeff 1 1 hertz ", "\npair_coeff 2 2 hertz ", "\npair_coeff 1 2 hertz "};

/* LAMMPS: F = kn sqrt(R x) x + eta_n m sqrt(R x) x', so eta_n = (3/2) A kn/m */
TEST(pairs_of_two_sizes)
{
    struct cor_scene scene = bodies(COR_LAW_VISCOELASTIC, 1);
    scene.number[COR_SCENE_DISSIPATION_TIME] = 1e-4;
    const double kn = 4.0 / 3 * young / (2 * (1 - poisson * poisson));
    const double masses[] = {mass[0] / 2, mass[1] / 2, mass[0] * mass[1] / (mass[0] + mass[1])};
    const char *const text = text_for("LAMMPS", NULL, &scene, 1);
    for (int i = 0; i < 3; i++) {
        const char *const at = found(text, pairs[i]);
        is_near(at, kn, 1e-11);
        is_near(strchr(at, ' '), 1.5e-4 * kn / masses[i], 1e-11);
    }
    found(text, "eta_n is proportional to m^-1. ");
    /* one size needs one line */
    scene = bodies(COR_LAW_VISCOELASTIC, 0);
    scene.number[COR_SCENE_DISSIPATION_TIME] = 1e-4;
    is_near(strchr(found(text_for("lammps", NULL, &scene, 1), "\npair_coeff * * hertz "), ' '), 3e-4 * kn / mass[0],
            1e-11);
}

/* The stiffness of a contact of which the duration at zero force is known, 2 A(zeta) sqrt(m/K): kn of two equal bodies
 * in series is twice as large. */
TEST(stiffness_of_a_duration)
{
    const double zeta = 0.1, mass_kg = 2e-3, duration_s = 5e-4;
    const double phase = 2 * acos(zeta) / sqrt(1 - zeta * zeta);
    struct cor_scene scene = scene_without_numbers(COR_LAW_LINEAR);
    scene.end = COR_END_ZERO_FORCE;
    scene_give(scene, {COR_SCENE_EFFECTIVE_MASS, mass_kg}, {COR_SCENE_ZETA, zeta}, {COR_SCENE_DURATION, duration_s});
    is_near(found(text_for("yade", NULL, &scene, 0), "kn="), 2 * mass_kg * phase * phase / (duration_s * duration_s),
            1e-11);
}

TEST(walls)
{
    /* The wall has the sphere's mass, and here its elasticity. */
    struct cor_scene scene = bodies(COR_LAW_VISCOELASTIC, -1);
    scene.number[COR_SCENE_DISSIPATION_TIME] = 1e-4;
    const double kn = 4.0 / 3 * young / (2 * (1 - poisson * poisson));
    const char *text = text_for("lammps", NULL, &scene, 1);
    is_near(strchr(found(text, "\nfix cor_wall all wall/gran granular hertz "), ' '), 1.5e-4 * kn / mass[0], 1e-11);
    assert_null(strstr(text, "pair_coeff"));
    /* LIGGGHTS has one matrix for walls and pairs, and takes limitForce after the wall. */
    scene.end = COR_END_ZERO_FORCE;
    text = text_for("liggghts", NULL, &scene, 1);
    const char *number = found(text, "\nfix cor_gamman all property/global gamman peratomtypepair 2 ");
    is_near(number, 3e-4 * kn / mass[0], 1e-11);
    is_near(strchr(number, ' '), 1.5e-4 * kn / mass[0], 1e-11);
    found(text,
          "\nfix cor_wall all wall/gran model hertz/stiffness tangential off primitive type 2 zplane 0 limitForce "
          "on\n");
    found(text_for("chrono", NULL, &scene, 1), "no model of Chrono has lines for a wall");
    /* a spring at a wall */
    scene = scene_without_numbers(COR_LAW_LINEAR);
    scene.wall = 1;
    scene_give(scene, {COR_SCENE_STIFFNESS, 1e5}, {COR_SCENE_EFFECTIVE_MASS, 2e-3}, {COR_SCENE_RESTITUTION, 0.5});
    const double l = log(2) / PI, zeta = l / sqrt(1 + l * l);
    is_near(strchr(found(text_for("lammps", NULL, &scene, 0), "\nfix cor_wall all wall/gran granular hooke "), ' '),
            2 * zeta * sqrt(1e5 * 2e-3), 1e-11);
    /* YADE makes other contacts of tc and en at a wall. */
    text = text_for("yade", NULL, &scene, 0);
    found(text, "ViscElMat(kn=");
    assert_null(strstr(text, "tc="));
}

/* The active block ends as asked; if none does, it says what it realises, and what else would do. */
TEST(ends)
{
    struct cor_scene scene = scene_without_numbers(COR_LAW_LINEAR);
    scene_give(scene, {COR_SCENE_STIFFNESS, 1e5}, {COR_SCENE_EFFECTIVE_MASS, 2e-3}, {COR_SCENE_RESTITUTION, 0.5});
    for (int end = COR_END_ZERO_OVERLAP; end <= COR_END_ZERO_FORCE; end++) {
        scene.end = end;
        const char *const text = text_for("lammps", NULL, &scene, 0);
        assert_true((strstr(found(text, "\npair_coeff"), "limit_damping") <
                     strchr(found(text, "\npair_coeff"), '\n')) == (end == COR_END_ZERO_FORCE));
        found(text, "\n# realises eps = 0.5 at every speed\n");
    }
    scene.end = COR_END_ZERO_OVERLAP;
    /* zeta of 0.5 at zero overlap gives exp(-2 zeta/sqrt(1 - zeta^2) atan2(sqrt(1 - zeta^2), zeta)) at zero force */
    const double l = log(2) / PI, zeta = l / sqrt(1 + l * l), root = sqrt(1 - zeta * zeta);
    const char *const text = text_for("YADE", NULL, &scene, 0);
    is_near(found(text, "\n# realises eps = "), exp(-2 * zeta / root * atan2(root, zeta)), 1e-6);
    const char *const cure = found(text, "\n# For eps = 0.5: YADE, ViscElMat, kn and cn");
    is_near(found(cure, "realises eps = "), 0.5, 1e-6);
}

TEST(active_lines_are_one_block)
{
    for (size_t i = 0; i < cor_simulator_count; i++) {
        const struct cor_simulator *const s = &cor_simulators[i];
        struct cor_scene scene = bodies(COR_LAW_TSUJI, 1);
        scene.number[COR_SCENE_RESTITUTION] = 0.7;
        char text[20000];
        snprintf(text, sizeof text, "%s", text_for(s->name, NULL, &scene, 0.4));
        int blocks = 0, in_block = 0, instead = 0;
        for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
            const int comment = strncmp(line, s->comment, strlen(s->comment)) == 0;
            instead += comment && strstr(line, "Instead, ") != NULL;
            blocks += !comment && !in_block;
            in_block = in_block || !comment;
            check(!instead || comment, "%s: active after the first block: %s", s->name, line);
        }
        check(blocks == 1 || strcmp(s->name, "rebound") == 0, "%s: %d blocks", s->name, blocks);
    }
}

TEST(buffer_of_any_size)
{
    struct cor_scene scene = bodies(COR_LAW_TSUJI, 1);
    scene.number[COR_SCENE_RESTITUTION] = 0.7;
    static char whole[20000], part[20000];
    const long length = lines_for(whole, sizeof whole, "lammps", NULL, &scene, 0);
    check(length > 500 && (size_t)length == strlen(whole), "length %ld of %zu", length, strlen(whole));
    assert_int_equal(lines_for(NULL, 0, "lammps", NULL, &scene, 0), length);
    for (size_t size = 1; size < (size_t)length + 3; size += size < 40 || size + 40 > (size_t)length ? 1 : 37) {
        memset(part, 'x', sizeof part);
        assert_int_equal(lines_for(part, size, "lammps", NULL, &scene, 0), length);
        const size_t kept = size <= (size_t)length ? size - 1 : (size_t)length;
        check(memcmp(part, whole, kept) == 0 && part[kept] == '\0' && part[kept + 1] == 'x', "size %zu", size);
    }
    /* a refusal is shortened likewise */
    for (size_t size = 0; size < 60; size++) {
        memset(part, 'x', sizeof part);
        assert_true(lines_for(part, size, "mujoco-2", NULL, &scene, 0) < 0);
        assert_true(part[size] == 'x' && (size == 0 || strlen(part) == size - 1));
    }
}

TEST(versions)
{
    static const struct {
        const char *text;
        long number;
    } row[] = {{"29 Sep 2021", 20210929},
               {"29Sep2021", 20210929},
               {"4 february 2025", 20250204},
               {"20250204", 20250204},
               {"3.8.1", 30801},
               {"3.8", 30800},
               {"2023.02a", 20230200},
               {"2022", 20220000},
               {"", 0},
               {"latest", 0},
               {"Sep 2021", 0}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        check(cor_simulator_version(row[i].text) == row[i].number, "%s: %ld", row[i].text,
              cor_simulator_version(row[i].text));
    /* the model of the version that is named, else of Debian's */
    struct cor_scene scene = bodies(COR_LAW_TSUJI, 0);
    scene.number[COR_SCENE_RESTITUTION] = 0.5;
    const char *text = text_for("lammps", NULL, &scene, 1);
    assert_true(strstr(found(text, "\npair_coeff"), "damping tsuji") < strchr(found(text, "\npair_coeff"), '\n'));
    text = text_for("lammps", "1 Oct 2026", &scene, 1);
    is_near(strstr(found(text, "\npair_coeff"), "hertz ") + strlen("hertz 7326007.32601 "), 0.5, 1e-6);
    found(text, "damping coeff_restitution");
    assert_null(strstr(text, "releases to July 2026"));
    assert_true(cor_simulator_named("Yade") && cor_simulator_named("ESYS") == cor_simulator_named("esys-particle"));
    assert_null(cor_simulator_named(""));
    assert_null(cor_simulator_named("lammp"));
    found(text_for("lamps", NULL, &scene, 1),
          "refused: 'lamps' is not a simulator that cor has lines for; allowed: lammps");
    found(text_for("lammps", "new", &scene, 1), "refused: 'new' is not a version of LAMMPS");
}

/* Each pair of types has the damping whose mean eps at this step is right: each makes its own number of steps. */
TEST(corrected_for_a_step)
{
    const double step = 5e-5, speed = 0.7, kn = 4.0 / 3 * young / (2 * (1 - poisson * poisson));
    struct cor_scene scene = bodies(COR_LAW_VISCOELASTIC, 1);
    scene.number[COR_SCENE_DISSIPATION_TIME] = 1e-4;
    corrected_step_s = step;
    const char *text = text_for("lammps", NULL, &scene, speed);
    found(text, " at 0.7 m/s with this time step, in the mean; standard deviation 0.00");
    is_near(found(text, "\ntimestep "), step, 1e-5);
    for (int i = 0; i < 3; i++) {
        const int second = i == 0 ? 0 : 1, first = i == 1 ? 1 : 0;
        const double m = mass[first] * mass[second] / (mass[first] + mass[second]);
        const double r = radius[first] * radius[second] / (radius[first] + radius[second]);
        struct cor_scene_contact exact = {.law = cor_law_exponents[COR_LAW_VISCOELASTIC],
                                          .mass_kg = m,
                                          .stiffness = kn * sqrt(r)},
                                 corrected;
        assert_int_equal(cor_scene_set_damping(&exact, COR_SCENE_DISSIPATION_TIME, 1e-4, 0, 0), 0);
        assert_int_equal(cor_scene_step_corrected(&corrected, &exact, speed, COR_END_ZERO_OVERLAP,
                                                  cor_scene_elastic_duration_s(&exact, speed) / step, COR_LEAPFROG),
                         COR_FAULT_NONE);
        char *eta;
        strtod(found(text, pairs[i]), &eta);
        const double factor = corrected.damping / exact.damping;
        check(fabs(factor - 1) > 2e-4, "pair %d: nothing to correct, %g", i, factor);
        is_near(eta, 1.5e-4 * kn / m * factor, 1e-9);
    }
    /* an impulse needs no correction; a method without steps of ours has none */
    scene = bodies(COR_LAW_HUNT_CROSSLEY, 0);
    scene_give(scene, {COR_SCENE_RESTITUTION, 0.7}, {COR_SCENE_AT, speed});
    scene.end = COR_END_ZERO_FORCE;
    found(text_for("simbody", NULL, &scene, speed), "refused: simbody, HuntCrossleyForce; OpenSim: its damping has no "
                                                    "correction for the time step: its method is implicit");
    found(text_for("bullet", NULL, &scene, speed), "realises eps = 0.7 at 0.7 m/s\n");
    /* what is missing is said, not a step that is right */
    scene = scene_without_numbers(COR_LAW_TSUJI);
    scene_give(scene, {COR_SCENE_STIFFNESS, 1e9}, {COR_SCENE_EFFECTIVE_MASS, 1e-3}, {COR_SCENE_RESTITUTION, 0.7});
    corrected_step_s = 1e-7;
    found(text_for("esys-particle", NULL, &scene, speed), "COR: it needs numbers that are not given: bodies");
    corrected_step_s = 1;
    scene = bodies(COR_LAW_VISCOELASTIC, 0);
    scene.number[COR_SCENE_DISSIPATION_TIME] = 1e-4;
    found(text_for("lammps", NULL, &scene, speed), "or so long that no damping makes the mean right");
    corrected_step_s = 0;
}

RUN_TESTS(corrected_for_a_step, stiffness_of_a_duration, pairs_of_two_sizes, walls, ends, active_lines_are_one_block,
          buffer_of_any_size, versions)
