/* SPDX-License-Identifier: MIT */
/* Tests the lines for a simulator: which lines are active, and their numbers against the force laws of LAMMPS and
 * LIGGGHTS given here. tests/simulators runs the lines. */
#include "scene.h"

#include <cor/sphere.h>

#define PI 3.14159265358979323846

static const double young = 1e7, poisson = 0.3, radius[] = {5e-3, 2e-2}, mass[] = {2e-3, 8e-3};

/* Returns two spheres of one material, or a sphere and a wall if `second` is -1. The second sphere has the sizes at
 * index `second` of the arrays. */
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

/* Settings of the next texts. corrected_step_s above 0: the time step for which they are corrected */
static double corrected_step_s, all_speeds[4], steps;

static long lines_for(char *text, size_t size, const char *simulator, const char *version,
                      const struct cor_scene *scene, double speed)
{
    struct cor_scene_contact contacts[COR_SCENE_ENDS];
    struct cor_scene_fault fault;
    int count;
    assert_int_equal(cor_scene_contacts(contacts, &count, &fault, scene), COR_FAULT_NONE);
    const int corrected = corrected_step_s > 0;
    const struct cor_simulator_request request = {.simulator = simulator,
                                                  .version = version,
                                                  .scene = scene,
                                                  .contacts = contacts,
                                                  .count = count,
                                                  .speed_m_s = steps > 0 ? all_speeds : &speed,
                                                  .speeds = steps > 0 ? COUNT_OF(all_speeds) : speed > 0,
                                                  .time_step_s = corrected_step_s,
                                                  .steps = steps,
                                                  .step_errors = corrected,
                                                  .step_corrected = corrected,
                                                  .integrator = COR_NO_INTEGRATOR};
    return cor_simulator_lines(text, size, &request);
}

/* Returns the text for a scene, or the refusal after "refused: "; valid until the next call. */
static const char *text_for(const char *simulator, const char *version, const struct cor_scene *scene, double speed)
{
    static char text[20000] = "refused: ";
    return lines_for(text + 9, sizeof text - 9, simulator, version, scene, speed) < 0 ? text : text + 9;
}

/* Returns the place of the words in the text; the test fails if they are absent. */
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

/* Only the line of the pair is active. */
static const char *const pairs[] = {"\n# pair_coeff 1 1 hertz ", "\n# pair_coeff 2 2 hertz ",
                                    "\npair_coeff 1 2 hertz "};

/* K follows from the duration at zero force, 2 A(zeta) sqrt(m/K). Two equal bodies in series have kn = 2 K. */
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
    /* LIGGGHTS has one matrix for walls and pairs, and accepts limitForce after the wall. */
    scene.end = COR_END_ZERO_FORCE;
    text = text_for("liggghts", NULL, &scene, 1);
    const char *number = found(text, "\nfix cor_gamman all property/global gamman peratomtypepair 2 ");
    is_near(number, 3e-4 * kn / mass[0], 1e-11);
    is_near(strchr(number, ' '), 1.5e-4 * kn / mass[0], 1e-11);
    found(text,
          "\nfix cor_wall all wall/gran model hertz/stiffness tangential off primitive type 2 zplane 0 limitForce "
          "on\n");
    found(text_for("chrono", NULL, &scene, 1), "no model of Chrono has lines for a wall");
    scene = scene_without_numbers(COR_LAW_LINEAR);
    scene.wall = 1;
    scene_give(scene, {COR_SCENE_STIFFNESS, 1e5}, {COR_SCENE_EFFECTIVE_MASS, 2e-3}, {COR_SCENE_RESTITUTION, 0.5});
    const double l = log(2) / PI, zeta = l / sqrt(1 + l * l);
    is_near(strchr(found(text_for("lammps", NULL, &scene, 0), "\nfix cor_wall all wall/gran granular hooke "), ' '),
            2 * zeta * sqrt(1e5 * 2e-3), 1e-11);
    /* The lines have kn, because tc and en would give YADE another contact at a wall. */
    text = text_for("yade", NULL, &scene, 0);
    found(text, "ViscElMat(kn=");
    assert_null(strstr(text, "tc="));
}

/* The active block has the requested end. If no block has it, the text states the realised e and an alternative. */
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
    /* Every simulator realises the requested eps at its own end. In YADE, at zero force, eps is exp(-2 zeta/root
     * atan2(root, zeta)) with root = sqrt(1 - zeta^2); in Newton, eps is the square root of this number. */
    for (size_t i = 0; i < 3 * cor_simulator_count; i++) {
        scene.end = i % 3 < 2 ? (int)(i % 3) : (int)COR_END_APPROACH_ONLY;
        const char *const text = text_for(cor_simulators[i / 3].name, NULL, &scene, 0), *at = strstr(text, "realises ");
        check(strncmp(text, "refused: ", 9) == 0 || strncmp(at, "realises eps = 0.5 at every speed", 33) == 0, "%s",
              text);
        const char *const instant = strstr(text, "contacts end at an instant");
        check(!(instant && instant < strchr(text, '\n') && strstr(text, "has no contacts of this law")), "%s", text);
        const int newton = strcmp(cor_simulators[i / 3].name, "newton") == 0;
        if (!newton && strcmp(cor_simulators[i / 3].name, "yade") != 0)
            continue;
        at = found(text, newton ? ", kd=" : ", cn=");
        const double zeta = strtod(at, NULL) / ((newton ? 2 : 4) * sqrt(1e5 * 2e-3)), root = sqrt(1 - zeta * zeta);
        assert_float_equal(exp(-(newton ? 1 : 2) * zeta / root * atan2(root, zeta)), 0.5, 1e-10);
    }
    struct cor_scene hunt_crossley = bodies(COR_LAW_HUNT_CROSSLEY, 0);
    hunt_crossley.end = COR_END_APPROACH_ONLY;
    scene_give(hunt_crossley, {COR_SCENE_RESTITUTION, 0.5}, {COR_SCENE_AT, 1});
    found(text_for("simbody", NULL, &hunt_crossley, 1), "\n// realises eps = 0.5 at 1 m/s\n");
    /* If the damping is given, the active lines have it. */
    const double l = log(2) / PI, zeta = l / sqrt(1 + l * l), root = sqrt(1 - zeta * zeta);
    scene.end = COR_END_ZERO_OVERLAP;
    scene_give(scene, {COR_SCENE_RESTITUTION, NAN}, {COR_SCENE_ZETA, zeta});
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
        if (!s->comment)
            continue;
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
    /* a refusal is shortened to the size, too */
    for (size_t size = 0; size < 60; size++) {
        memset(part, 'x', sizeof part);
        assert_true(lines_for(part, size, "mujoco-2", NULL, &scene, 0) < 0);
        assert_true(part[size] == 'x' && (size == 0 || strlen(part) == size - 1));
    }
}

TEST(versions)
{
    char version[] =
        "29 Sep 2021|29Sep2021|29 Sept 2021|4 february 2025|20250204|20230802-1~deb12|3.8.1|3.8|2023.02a|2022|"
        "31 Foo 2021|32 Jan 2021|1 Ja 2021|1 Jan 21|-1|202308021|3.8.1\nx|3.8 1|latest|Sep 2021";
    const long number[20] = {20210929, 20210929, 20210929, 20250204, 20250204,
                             20230802, 30801,    30800,    20230200, 20220000}; /* the last ten are no versions */
    size_t i = 0;
    for (const char *text = strtok(version, "|"); text; text = strtok(NULL, "|"), i++)
        check(cor_simulator_version(text) == number[i], "%s: %ld", text, cor_simulator_version(text));
    assert_true(i == COUNT_OF(number) && cor_simulator_version("") == 0);
    /* the model belongs to the named version, otherwise to Debian's version */
    struct cor_scene scene = bodies(COR_LAW_TSUJI, 0);
    scene.number[COR_SCENE_RESTITUTION] = 0.5;
    const char *text = text_for("lammps", NULL, &scene, 1);
    assert_true(strstr(found(text, "\npair_coeff * *"), "damping tsuji") < strchr(found(text, "\npair_coeff"), '\n'));
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

/* Each pair of types has the damping that gives the right mean eps for the number of steps in its contact. */
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
        struct cor_scene_contact corrected, exact = {.law = scene.law, .mass_kg = m, .stiffness = kn * sqrt(r)};
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
    /* Simbody's integrator is implicit, so its damping has no correction; Bullet's impulse needs none */
    scene = bodies(COR_LAW_HUNT_CROSSLEY, 0);
    scene_give(scene, {COR_SCENE_RESTITUTION, 0.7}, {COR_SCENE_AT, speed});
    scene.end = COR_END_ZERO_FORCE;
    found(text_for("simbody", NULL, &scene, speed),
          "refused: simbody, HuntCrossleyForce; OpenSim: cor has no correction "
          "of its damping for the time step: its integrator is implicit");
    found(text_for("bullet", NULL, &scene, speed), "realises eps = 0.7 at 0.7 m/s\n");
    /* the text names missing numbers, instead of a step */
    scene = scene_without_numbers(COR_LAW_TSUJI);
    scene_give(scene, {COR_SCENE_STIFFNESS, 1e9}, {COR_SCENE_EFFECTIVE_MASS, 1e-3}, {COR_SCENE_RESTITUTION, 0.7});
    corrected_step_s = 1e-7;
    found(text_for("esys-particle", NULL, &scene, speed), "COR: it needs bodies");
    corrected_step_s = 1;
    scene = bodies(COR_LAW_VISCOELASTIC, 0);
    scene.number[COR_SCENE_DISSIPATION_TIME] = 1e-4;
    found(text_for("lammps", NULL, &scene, speed), "or it is so long that no damping gives the requested mean eps");
    corrected_step_s = 0;
}

enum { CONTACTS = 7 };
/* Indices of two bodies; 1: the second is a wall of that body's material. The pair of both bodies comes first. */
static const int between[CONTACTS][3] = {{0, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}};
static const int of_body[] = {COR_SCENE_YOUNG, COR_SCENE_POISSON, COR_SCENE_RADIUS, COR_SCENE_DENSITY,
                              COR_SCENE_DISSIPATION_TIME};
enum { OF_BODY = COUNT_OF(of_body) };

/* Returns two bodies. effect: index of the only number in which they differ; OF_BODY: they differ in all numbers.
 * damped: the bodies have dissipation times */
static struct cor_scene unlike(double number[2][OF_BODY], size_t effect, int damped)
{
    struct cor_scene scene = scene_without_numbers(damped ? COR_LAW_VISCOELASTIC : COR_LAW_TSUJI);
    for (size_t k = 0; k < OF_BODY; k++) {
        const double low[] = {1e6, 0.05, 1e-4, 500, 1e-7}, high[] = {1e11, 0.45, 1e-2, 9000, 1e-6};
        for (int body = 0; body < 2; body++)
            number[body][k] = random_log(&draw, low[k], high[k]);
        if (k != effect && effect < OF_BODY)
            number[1][k] = number[0][k];
        if (damped || of_body[k] != COR_SCENE_DISSIPATION_TIME)
            scene_give(scene, {of_body[k], number[0][k]},
                       {of_body[k] + COR_SCENE_BODY, k == effect || effect == OF_BODY ? number[1][k] : (double)NAN});
    }
    return scene;
}

static struct cor_sphere_contact pair_of(const double *n, const double *other, int wall)
{
    struct cor_body body[2];
    struct cor_sphere_contact contact;
    for (int i = 0; i < 2; i++, n = other)
        body[i] = (struct cor_body){n[0], n[1], n[4], i && wall ? INFINITY : n[2],
                                    i && wall ? INFINITY : 4 * PI / 3 * pow(n[2], 3) * n[3]};
    assert_int_equal(cor_sphere_contact_init(&contact, &body[0], &body[1]), COR_OK);
    return contact;
}

/* Bodies that differ in a single number are two types. In LAMMPS F = kn sqrt(R x) x + eta_n m sqrt(R x) x', so
 * eta_n = (3/2) A kn/m. The time step is the smallest of all contacts and speeds. */
TEST(bodies_that_differ_in_one_number)
{
    for (size_t effect = 0; effect <= OF_BODY; effect++) {
        double n[2][OF_BODY], least = INFINITY;
        struct cor_scene scene = unlike(n, effect, 1);
        scene.end = COR_END_ZERO_OVERLAP;
        steps = random_uniform(&draw, 20, 90);
        for (size_t i = 0; i < COUNT_OF(all_speeds); i++)
            all_speeds[i] = random_log(&draw, 1e-3, 10);
        const char *const text = text_for("lammps", NULL, &scene, 0);
        for (int k = 0; k < CONTACTS; k++) {
            const struct cor_sphere_contact c = pair_of(n[between[k][0]], n[between[k][1]], between[k][2]);
            const double kn = c.elastic_constant_n_m15 / sqrt(c.effective_radius_m);
            if (k < 3) {
                const char *const at = found(text, pairs[(k + 2) % 3]);
                is_near(at, kn, 1e-10);
                is_near(strchr(at, ' '), 1.5 * c.dissipation_time_s * kn / c.effective_mass_kg, 1e-10);
            }
            const struct cor_scene_contact contact = {.law = scene.law,
                                                      .mass_kg = c.effective_mass_kg,
                                                      .stiffness = c.elastic_constant_n_m15,
                                                      .damping = c.beta_per_root};
            for (size_t i = 0; i < COUNT_OF(all_speeds); i++) {
                const struct cor_scene_impact impact = scene_impact(&contact, all_speeds[i]);
                const double elastic = cor_scene_elastic_duration_s(&contact, all_speeds[i]);
                least = fmin(least, impact.duration_s[0]);
                least = fmin(least, k > 0 ? fmin(impact.duration_s[1], elastic) : least);
            }
        }
        is_near(found(text, "\ntimestep "), least / steps, 1e-5);
        found(text, "eta_n is proportional to m^-1. ");
        found(text, "the given damping of their materials.\n");
        steps = 0;
    }
}

/* Without dissipation times, contacts of equal bodies have the zeta of the pair, so by LIGGGHTS's exact formula all
 * contacts have the same eps. The lines for YADE have the moduli and densities of both materials. */
TEST(unlike_bodies_of_a_constant_law)
{
    for (size_t effect = 0; effect <= OF_BODY; effect += effect + 2 == OF_BODY ? 2 : 1) { /* no dissipation times */
        double n[2][OF_BODY];
        struct cor_scene scene = unlike(n, effect, 0);
        const double e = random_uniform(&draw, 0.2, 0.9), log_e = log(e);
        scene_give(scene, {COR_SCENE_ZETA, -log_e / sqrt(PI * PI + log_e * log_e)});
        const char *at = found(text_for("liggghts", NULL, &scene, 0), " coefficientRestitution peratomtypepair 2 ");
        for (int i = 0; i < 4; i++) {
            is_near(at, e, 1e-10);
            at += strcspn(at, " \n") + 1;
        }
        found(text_for("liggghts", NULL, &scene, 0), "with the damping of the pair 1 2, which is right only");
        at = found(text_for("yade", NULL, &scene, 0), "1 1 and 2 2 and walls also use the betan of the pair 1 2.");
        for (int body = 0; body < (effect == 2 ? 1 : 2); body++) {
            at = found(at, body ? "\ncor_material_2 = FrictMat(young=" : "\ncor_material = FrictMat(young=");
            is_near(at, n[body][0], 1e-11);
            is_near(found(at, "poisson="), n[body][1], 1e-11);
            is_near(found(at, "density="), n[body][3], 1e-11);
        }
        check(effect != 2 || !strstr(at, "cor_material_2"), "one material for two radii");
        /* if a simulator has only one E, its E gives the stiffness of the pair */
        const struct cor_sphere_contact c = pair_of(n[0], n[1], 0);
        scene.law = cor_law_exponents[COR_LAW_VISCOELASTIC];
        scene_give(scene, {COR_SCENE_ZETA, NAN}, {COR_SCENE_G_STAR, 1});
        /* if bodies have no A, contacts of equal bodies have the A of the pair, from C/K */
        at = text_for("lammps", NULL, &scene, 1);
        const double mass_kg[] = {pair_of(n[0], n[0], 0).effective_mass_kg, pair_of(n[1], n[1], 0).effective_mass_kg,
                                  c.effective_mass_kg};
        double a[3];
        for (int k = 0; k < 3; k++) {
            char *eta;
            const double kn = strtod(found(at, pairs[k]), &eta);
            a[k] = strtod(eta, NULL) * mass_kg[k] / kn;
        }
        check(fabs(a[0] / a[2] - 1) < 1e-9 && fabs(a[1] / a[2] - 1) < 1e-9, "A %g %g %g", a[0], a[1], a[2]);
        at = found(text_for("esys", NULL, &scene, 0), "HertzianViscoElasticPrms(");
        is_near(found(at, "E="), 1.5 * (1 - n[0][1] * n[0][1]) * c.elastic_constant_n_m15 / sqrt(c.effective_radius_m),
                1e-10);
    }
}

/* A wall, two balls and a wall: types 3, 1, 2 and 4. The first ball has a dissipation time. The second has the time of
 * a measured contact of two such balls; the contact of the first ball and the first wall was measured. In LAMMPS and
 * LIGGGHTS F = kn sqrt(R x) (x + (3/2) A x'), eta_n = gamman = (3/2) A kn/m. In Chrono, with R = 1 m,
 * kn = K and gn = (3/2) A K/m. */
TEST(several_materials)
{
    enum { TYPES = 4 };
    static const char *const names[] = {"base", "a", "b b", "side"};
    static const size_t place[TYPES] = {1, 2, 0, 3}; /* of a type */
    static char text[20000];
    struct cor_material material[TYPES];
    struct cor_material_contact memory[TYPES * TYPES];
    struct cor_material_pair pair[] = {{2, 2, 0, 0.3, COR_END_ZERO_OVERLAP, NAN},
                                       {0, 1, 0, 2, COR_END_ZERO_FORCE, 0},
                                       {2, 3, NAN, NAN, COR_BOTH_ENDS, 0.25}};
    struct cor_scene scene = scene_without_numbers(COR_LAW_VISCOELASTIC);
    double n[TYPES][OF_BODY], kn[TYPES][TYPES], eta[TYPES][TYPES], gn[TYPES][TYPES], least = INFINITY;
    char words[100];
    for (int k = 0; k < TYPES; k++) {
        const double low[] = {1e6, 0.05, 1e-4, 500, 1e-7}, high[] = {1e9, 0.45, 1e-2, 9000, 1e-6};
        for (int i = 0; i < OF_BODY; i++)
            n[k][i] = random_log(&draw, low[i], high[i]);
        const double radius = k % 3 ? n[k][2] : INFINITY;
        const double mass_kg = k % 3 ? 4 * PI / 3 * pow(radius, 3) * n[k][3] : INFINITY;
        material[k] = (struct cor_material){
            names[k], {n[k][0], n[k][1], k != 2 ? n[k][4] : (double)NAN, radius, mass_kg}, (double)NAN, NULL};
        all_speeds[k] = random_log(&draw, 1e-2, 10);
    }
    for (int i = 0; i < 2; i++)
        for (int j = i; j < TYPES; j++) {
            double other[OF_BODY];
            memcpy(other, n[place[j]], sizeof other);
            other[4] *= i == 0 && j == 2 ? 2 : 1; /* this pair was measured */
            const struct cor_sphere_contact c = pair_of(n[place[i]], other, j > 1);
            if (i == 1 && j == 1)
                pair[0].restitution = cor_contact_eps_zero_overlap(&c, 0.3);
            if (i == 0 && j == 2)
                pair[1].restitution = cor_contact_eps_zero_force(&c, 2);
            kn[i][j] = c.elastic_constant_n_m15 / sqrt(c.effective_radius_m);
            eta[i][j] = 1.5 * c.dissipation_time_s * kn[i][j] / c.effective_mass_kg;
            gn[i][j] = eta[i][j] * sqrt(c.effective_radius_m);
            for (size_t k = 0; k < COUNT_OF(all_speeds); k++)
                least = fmin(least, cor_contact_duration_s_zero_overlap(&c, all_speeds[k]));
        }
    scene.end = COR_END_ZERO_OVERLAP;
    struct cor_simulator_request request = {.simulator = "lammps",
                                            .scene = &scene,
                                            .speed_m_s = all_speeds,
                                            .speeds = COUNT_OF(all_speeds),
                                            .steps = 40,
                                            .integrator = COR_NO_INTEGRATOR,
                                            .materials = material,
                                            .pairs = pair,
                                            .material_count = TYPES,
                                            .pair_count = 3,
                                            .memory = memory,
                                            .friction = 0.5};
    assert_true(cor_simulator_lines(text, sizeof text, &request) > 0);
    is_near(found(text, "\ntimestep "), least / 40, 1e-5);
    for (int i = 0; i < 2; i++)
        for (int j = i; j < TYPES; j++) {
            const char *const form =
                j < 2 ? "\npair_coeff %d %d hertz " : "\nfix cor_wall_%d_%d cor_%d wall/gran granular hertz ";
            snprintf(words, sizeof words, form, i + 1, j + 1, i + 1);
            const char *const at = found(text, words);
            is_near(at, kn[i][j], 1e-10);
            is_near(strchr(at, ' '), eta[i][j], 1e-9);
            /* the stiffness is 8 G*, 1/G* = (2 - nu_1)/G_1 + (2 - nu_2)/G_2, G = Y/(2 (1 + nu)); the first wall has no
             * friction */
            const double *const one = n[place[i]], *const two = n[place[j]];
            const int slips = i == 0 && j == 2;
            const char *const slide = found(at, slips ? " linear_nohistory 0 0 damping " : " tangential mindlin ");
            assert_true(slide < strchr(at, '\n'));
            if (slips)
                continue;
            is_near(slide, 4 / ((2 - one[1]) * (1 + one[1]) / one[0] + (2 - two[1]) * (1 + two[1]) / two[0]), 1e-10);
            is_near(found(slide, " 0 "), i == 1 && j == 3 ? 0.25 : 0.5, 1e-10);
        }
    found(found(text, "\n# type 2: b b, radius "), "\n# 1 3, a and base: measured at zero force, eps = ");
    assert_null(strstr(text, "cor_wall_1_2"));
    request.simulator = "liggghts";
    assert_true(cor_simulator_lines(text, sizeof text, &request) > 0);
    assert_null(strstr(text, "nan"));
    assert_null(strstr(found(text, "\npair_coeff * *\n"), "pair_coeff")); /* a line without types: once */
    const char *at = found(text, "\nfix cor_gamman all property/global gamman peratomtypepair 4 ");
    for (int k = 0; k < TYPES * TYPES; k++, at += strcspn(at, " \n") + 1) {
        const int low = k / TYPES < k % TYPES ? k / TYPES : k % TYPES, high = k / TYPES + k % TYPES - low;
        is_near(at, eta[low < 2 ? low : 0][high], 1e-9);
    }
    scene.end = pair[0].end = COR_BOTH_ENDS;
    request.simulator = "lammps";
    assert_true(cor_simulator_lines(text, sizeof text, &request) > 0);
    /* for a model that ends at zero force, the same eps needs more damping */
    is_near(found(text, "\n# 2 4, b b and side: not measured; the damping follows from the dissipation times "),
            n[2][4] * cor_sphere_beta_zero_force(pair[0].restitution) /
                cor_sphere_beta_zero_overlap(pair[0].restitution),
            1e-5);
    pair[0].end = COR_END_ZERO_OVERLAP;
    scene.end = COR_END_ZERO_FORCE;
    assert_true(cor_simulator_lines(text, sizeof text, &request) > 0);
    found(text, " damping viscoelastic limit_damping\n");
    request.friction = 0;
    request.pair_count = 2;
    request.simulator = "yade";
    assert_true(cor_simulator_lines(text, sizeof text, &request) > 0);
    found(text, "),\n    )),\n    vn=1.0)],\n");
    request.simulator = "chrono";
    assert_true(cor_simulator_lines(text, sizeof text, &request) > 0);
    at = found(found(text, "CombineDampingCoefficient"), "pair[] = {\n            ");
    is_near(at, gn[0][0], 1e-9);
    is_near(found(at, ", "), gn[0][1], 1e-9);
    request.simulator = "mercurydpm";
    assert_true(cor_simulator_lines(text, sizeof text, &request) > 0);
    is_near(found(text, "\ncor_2_4->setDissipation("), pair_of(n[2], n[3], 1).dissipation_time_s, 1e-9);
    for (at = text; (at = strstr(at, "\ncor_")) != NULL; at++) { /* every object is declared */
        snprintf(words, sizeof words, "\nauto %.*s = ", (int)strcspn(at + 1, "-"), at + 1);
        found(text, words);
    }
    /* MFiX has e at one speed, from the formula for a linear spring, and one material for all walls. */
    request.simulator = "mfix";
    request.speeds = 1;
    assert_true(cor_simulator_lines(text, sizeof text, &request) < 0);
    found(text, "MFiX has one material for all walls; leave out the wall side");
    request.material_count = 3;
    assert_true(cor_simulator_lines(text, sizeof text, &request) > 0);
    const struct cor_sphere_contact c = pair_of(n[2], n[2], 0);
    const double log_e = log(strtod(found(text, "\nDES_EN_INPUT(3) = "), NULL)),
                 zeta = 2 / sqrt(5) * -log_e / sqrt(PI * PI + log_e * log_e);
    is_near(found(found(text, "\n! 2 2,"), "\n! realises eps = "), cor_contact_eps_zero_force(&c, *all_speeds), 1e-5);
    check(fabs(cor_law_eps(COR_LAW_TSUJI, COR_END_ZERO_OVERLAP, zeta) - cor_contact_eps_zero_force(&c, *all_speeds)) <
              1e-6,
          "MFiX, e = %g", exp(log_e));
}

/* Speeds may be given in any order, and may differ from --at. */
TEST(speeds_in_any_order)
{
    for (int round = 0; round < 5; round++) {
        double low = INFINITY, high = 0;
        struct cor_scene scene = bodies(COR_LAW_VISCOELASTIC, 0);
        scene.end = COR_END_ZERO_FORCE;
        scene_give(scene, {COR_SCENE_RESTITUTION, random_uniform(&draw, 0.3, 0.9)},
                   {COR_SCENE_AT, random_log(&draw, 0.1, 10)});
        for (size_t i = 0; i < COUNT_OF(all_speeds); i++) {
            all_speeds[i] = random_log(&draw, 1e-3, 10);
            low = fmin(low, all_speeds[i]);
            high = fmax(high, all_speeds[i]);
        }
        steps = 50;
        const char *const text = text_for("rebound", NULL, &scene, 0);
        steps = 0;
        is_near(found(text, " --speed-min "), low, 1e-5);
        is_near(found(text, " --speed-max "), high, 1e-5);
        /* a simulator without the law realises eps at one speed only */
        const struct cor_scene_contact contact = scene_contact(&scene, COR_END_ZERO_FORCE);
        const double eps = scene_eps(&contact, low, COR_END_ZERO_FORCE);
        const char *const at = found(text_for("mfix", NULL, &scene, low), "realises eps = ");
        is_near(at, eps, 1e-5);
        is_near(found(at, " at "), low, 1e-5);
        /* a simulator with only linear springs has a spring of equal duration, 2.943275 (5m/(4K))^(2/5) g^(-1/5) */
        const char *const spring = found(text_for("mujoco", NULL, &scene, low), " solref=\"-");
        const double duration = 2.9432750 * pow(1.25 * contact.mass_kg / contact.stiffness, 0.4) * pow(low, -0.2);
        is_near(spring, PI * PI / (duration * duration), 1e-6);
        const double l_mujoco = strtod(strstr(spring, "-"), NULL) / -2 * duration / PI; /* zeta */
        check(fabs(cor_law_eps(COR_LAW_LINEAR, COR_END_ZERO_FORCE, l_mujoco) - eps) < 1e-6, "zeta %g", l_mujoco);
    }
}

/* Under gravity the lines have the same numbers as without gravity, and the stated eps includes gravity. */
TEST(a_ball_that_falls)
{
    static const char *const number[] = {"granular hertz ", "coefficientRestitution peratomtypepair 2 ", "betan="};
    static const char *const host[] = {"lammps", "liggghts", "yade"};
    char words[100];
    for (int i = 0; i < 18; i++) {
        const int kind = i % 3, end = i / 3 % 3 - 1, way = kind > 0 ? COR_SCENE_ZETA : COR_SCENE_DAMPING_COEFFICIENT;
        const int own = kind == 2 ? COR_END_ZERO_FORCE : end == COR_BOTH_ENDS ? COR_END_ZERO_OVERLAP : end;
        const double e = random_uniform(&draw, 0.5, 0.9), at = random_log(&draw, 0.3, 3),
                     other = random_log(&draw, 0.5, 5);
        struct cor_scene scene = bodies(kind == 0 ? COR_LAW_VISCOELASTIC : COR_LAW_TSUJI, -1);
        scene.end = end;
        scene_give(scene, {COR_SCENE_GRAVITY, random_log(&draw, 10, 300)}, {COR_SCENE_RESTITUTION, e},
                   {COR_SCENE_AT, at});
        struct cor_scene_contact contact = scene_contact(&scene, own);
        if (kind == 2) { /* YADE's wall has K/sqrt(2) */
            contact.stiffness /= sqrt(2);
            assert_int_equal(cor_scene_set_damping(&contact, COR_SCENE_RESTITUTION, e, at, own), 0);
        }
        const char *at_number, *const text = text_for(host[kind], NULL, &scene, other);
        snprintf(words, sizeof words, " at %.6g m/s under gravity\n", other);
        is_near(found(text, "\n# realises eps = "), scene_eps(&contact, other, own), 1e-5);
        found(text, words);
        at_number = found(text, number[kind]);
        const double value = strtod(kind < 2 ? strchr(at_number, ' ') : at_number, NULL);
        scene_give(scene, {COR_SCENE_GRAVITY, NAN}, {COR_SCENE_RESTITUTION, NAN}, {COR_SCENE_AT, NAN},
                   {way, cor_scene_damping(&contact, way)});
        at_number = found(text_for(host[kind], NULL, &scene, other), number[kind]);
        is_near(kind < 2 ? strchr(at_number, ' ') : at_number, value, 1e-9);
    }
    /* The damping for a simulator without the law: its own law has this eps under gravity. */
    struct cor_scene scene = bodies(COR_LAW_VISCOELASTIC, -1);
    scene.end = COR_END_ZERO_OVERLAP;
    scene_give(scene, {COR_SCENE_GRAVITY, 200}, {COR_SCENE_RESTITUTION, 0.7}, {COR_SCENE_AT, 0.5});
    const double e = strtod(found(text_for("mfix", NULL, &scene, 0), "\nDES_EN_WALL_INPUT(1) = "), NULL);
    scene.law = cor_law_exponents[COR_LAW_TSUJI];
    scene_give(scene, {COR_SCENE_RESTITUTION, NAN}, {COR_SCENE_AT, NAN},
               {COR_SCENE_ZETA, 2 / sqrt(5) * cor_law_damping(COR_LAW_LINEAR, COR_END_ZERO_OVERLAP, e)});
    const struct cor_scene_contact contact = scene_contact(&scene, COR_END_ZERO_OVERLAP);
    check(fabs(scene_eps(&contact, 0.5, COR_END_ZERO_OVERLAP) - 0.7) < 1e-8, "MFiX with e = %.9g", e);
}
