/* SPDX-License-Identifier: MIT */
/* Inputs of simulators as texts, and the findings: restitutions of LAWS' own table and of closed forms here, what is
 * missing, and texts that are none. */
#include "check.h"

#include <string.h>

#include "cor/audit.h"
#include "cor/law.h"
#include "cor/sphere.h"

enum { MOST = 64 };

static struct seen {
    struct cor_audit_finding finding[MOST];
    char text[MOST][3][512]; /* model and pair; advice; instead */
    int count;
    const char *included; /* every include is this text */
} seen;

static void take(void *context, const struct cor_audit_finding *f)
{
    (void)context;
    if (seen.count == MOST)
        return;
    char(*const text)[512] = seen.text[seen.count];
    snprintf(text[0], sizeof text[0], "%s, %s", f->model ? f->model : "", f->pair);
    snprintf(text[1], sizeof text[1], "%s", f->advice);
    snprintf(text[2], sizeof text[2], "%s", f->instead);
    seen.finding[seen.count++] = *f;
}

static int open_included(void *context, struct cor_audit_text *text, const char *name, const char *from)
{
    (void)context;
    (void)from;
    text->name = "included";
    text->text = seen.included;
    text->size = seen.included ? strlen(seen.included) : 0;
    return strcmp(name, "missing") == 0;
}

static struct cor_audit_memory memory;
static long version;
static double tolerance = 0.01;

static const double pi = 3.14159265358979323846;

static int audit_bytes(const char *simulator, const char *text, size_t size, double speed)
{
    const struct cor_audit_text input = {"input", text, size};
    const struct cor_audit_options options = {.simulator = simulator,
                                              .version = version,
                                              .speed_m_s = &speed,
                                              .speeds = isnan(speed) ? 0U : 1U,
                                              .radius_m = NAN,
                                              .density_kg_m3 = NAN,
                                              .time_step_s = NAN,
                                              .tolerance = tolerance,
                                              .open = open_included,
                                              .report = take};
    seen.count = 0;
    return cor_audit(&memory, &input, &options);
}

static int audit(const char *text, double speed)
{
    return audit_bytes(NULL, text, strlen(text), speed);
}

static void audits(int status, double speed, const char *text)
{
    assert_int_equal(audit(text, speed), status);
}

static void finds(int at, long line, double asked, double realised, const char *named)
{
    const struct cor_audit_finding *const f = &seen.finding[at];
    assert_true(at < seen.count);
    check(f->line == line, "finding %d: line %ld, not %ld", at, f->line, line);
    check(fabs(f->asked - asked) < 1e-12 || (isnan(f->asked) && isnan(asked)), "line %ld asks for %g, not %g", line,
          f->asked, asked);
    check(isnan(realised) ? isnan(f->realised) : fabs(f->realised - realised) < 1e-5,
          "line %ld realises %.9g, not %.9g", line, f->realised, realised);
    check(strstr(seen.text[at][0], named) != NULL, "line %ld: %s, not %s", line, seen.text[at][0], named);
}

static void says(int at, int which, const char *part)
{
    check(strstr(seen.text[at][which], part) != NULL, "finding %d says: %s; not: %s", at, seen.text[at][which], part);
}

#define SPHERES                                                                                                        \
    "units si\natom_style sphere\nregion b block 0 1 0 1 0 1\ncreate_box 2 b\ncreate_atoms 1 single 0 0 0\n"           \
    "set type 1 diameter 0.01 density 2500\nset type 2 diameter 0.02 density 2500\ntimestep 1e-5\n"

/* eps of e by the table of the laws, and what it gets from the numbers of a line */
TEST(lammps)
{
    audits(COR_AUDIT_NOT_AS_ASKED, 1,
           SPHERES "pair_style granular\n"
                   "variable e equal 1/2\n"
                   "pair_coeff 1 1 hertz/material 1e7 ${e} 0.3 damping tsuji &\n tangential "
                   "linear_nohistory 0 0 # a comment\n"
                   "pair_coeff 2 2 hertz 1e7 0.8 limit_damping damping tsuji\n"
                   "pair_coeff 1 2 hooke 1e4 0.2 damping tsuji\r\n"
                   "fix w all wall/gran granular hertz 1e7 0.7 damping coeff_restitution zplane 0 NULL\n");
    assert_int_equal(seen.count, 5);
    finds(0, 11, 0.5, 0.616076, "granular hertz, damping tsuji, releases to July 2026, 1-1");
    says(0, 2, "pair_coeff 1 1 hertz/material 1e7 0.366651 0.3 damping tsuji tangential");
    finds(1, 13, 0.8, 0.857737, "limit_damping, releases to July 2026, 2-2");
    finds(2, 14, 0.2, 0.297340, "granular hooke, damping tsuji, releases to July 2026, 1-2");
    finds(3, 15, 0.7, 0.7, "coeff_restitution, 1-wall");
    finds(4, 15, 0.7, 0.7, "coeff_restitution, 2-wall");
    assert_int_equal(seen.finding[3].as_asked, 1);
    assert_true(seen.finding[0].as_asked == 0 && seen.finding[0].time_step_s == 1e-5);

    /* a linear dashpot of two equal spheres, in closed form; duration pi/sqrt(1 - zeta^2) sqrt(m/K) */
    const double mass = pi / 6 * 1e-6 * 2500 / 2, zeta = 0.05 / (2 * sqrt(1e3 * mass));
    audits(COR_AUDIT_AS_ASKED, NAN, SPHERES "pair_style granular\npair_coeff 1 1 hooke 1e3 0.05 damping velocity\n");
    finds(0, 10, NAN, exp(-pi * zeta / sqrt(1 - zeta * zeta)), "granular hooke, damping velocity, 1-1");
    check(fabs(seen.finding[0].duration_s / (pi / sqrt(1 - zeta * zeta) * sqrt(mass / 1e3)) - 1) < 1e-12,
          "duration %.15g", seen.finding[0].duration_s);
    assert_true(fabs(seen.finding[0].damping / zeta - 1) < 1e-12 && seen.finding[0].as_asked == -1);
    /* a model without a row for limit_damping: the end is another one */
    const double end = cor_law_eps(COR_LAW_LINEAR, COR_END_ZERO_FORCE,
                                   cor_law_damping(COR_LAW_LINEAR, COR_END_ZERO_OVERLAP, 0.297340));
    audits(COR_AUDIT_NOT_AS_ASKED, NAN,
           SPHERES "pair_style granular\npair_coeff 1 1 hooke 1e3 0.2 damping tsuji limit_damping\n");
    finds(0, 10, 0.2, end, "hooke, damping tsuji, releases to July 2026, limit_damping, 1-1");
    assert_int_equal(seen.finding[0].end, COR_END_ZERO_FORCE);

    /* the older styles, cgs, a wall with the whole mass: zeta = (gamma/2) sqrt(m/K) */
    const double wall = pi / 6 * 1e-3 * 2.5, ratio = 1000 / 2.0 * sqrt(wall / 1e6);
    audits(COR_AUDIT_AS_ASKED, 0.1,
           "units cgs\natom_style sphere\ncreate_box 1 b\nset type 1 diameter 0.1 density 2.5\n"
           "pair_style gran/hertz/history 1e9 NULL 5e4 NULL 0.5 0\npair_coeff * *\n"
           "fix w all wall/gran hooke/history 1e6 NULL 1000 NULL 0.5 0 zplane 0 NULL\n");
    const double m = wall / 2, radius = 0.025, k = 1e9 * sqrt(radius);
    const double beta = 5e4 * sqrt(radius) * pow(m / k, 0.6) * pow(10, 0.2);
    finds(0, 5, NAN, cor_sphere_eps_zero_overlap(beta), "gran/hertz/history, 1-1");
    assert_true(fabs(seen.finding[0].damping / beta - 1) < 1e-12 && seen.finding[0].speed_m_s == 0.1);
    finds(1, 7, NAN, exp(-pi * ratio / sqrt(1 - ratio * ratio)), "gran/hooke, 1-wall");
    /* microseconds */
    audits(COR_AUDIT_AS_ASKED, NAN,
           "units micro\natom_style sphere\ncreate_box 1 b\nset type 1 diameter 2 density 3\n"
           "pair_style gran/hooke 100 NULL 0 NULL 0.5 0\npair_coeff * *\n");
    check(fabs(seen.finding[0].duration_s / (1e-6 * pi * sqrt(2 * pi / 100)) - 1) < 1e-12, "duration %.15g",
          seen.finding[0].duration_s);

    /* two sizes; the speed of fix pour; a pair without a line has the geometric mean */
    audits(COR_AUDIT_AS_ASKED, NAN,
           "units si\ncreate_box 2 b\npair_style granular\n"
           "pair_coeff 1 1 hertz 1e7 0.9 damping coeff_restitution\n"
           "pair_coeff 2 2 hertz 1e7 0.4 damping coeff_restitution\n"
           "fix p all pour 100 1 4767548 vol 0.1 10 diam range 0.01 0.02 dens 2500 2500 vel 0 0 0 0 -3\n");
    assert_int_equal(seen.count, 5);
    finds(1, 4, 0.9, 0.9, "1-1, largest");
    assert_true(seen.finding[0].speed_m_s == 3);
    finds(3, 5, 0.6, 0.6, "1-2, least");
}

/* LIGGGHTS: matrices of numbers for each pair of types, a mesh, and its own springs */
TEST(liggghts)
{
    static const char script[] =
        "units si\ncreate_box 2 b\ntimestep 1e-5\n"
        "fix m1 all property/global youngsModulus peratomtype 5e6 1e7\n"
        "fix m2 all property/global poissonsRatio peratomtype 0.45 0.3\n"
        "fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.7 0.7 0.9\n"
        "fix m4 all property/global characteristicVelocity scalar 2\n"
        "fix m5 all property/global kn peratomtypepair 2 2000 4000 4000 8000\n"
        "fix m6 all property/global gamman peratomtypepair 2 300 50 50 300\n"
        "fix t1 all particletemplate/sphere 1 atom_type 1 density constant 2500 radius constant 0.005\n"
        "fix cad all mesh/surface file hopper.stl type 2 scale 0.001\n";
    char text[4096];
    snprintf(text, sizeof text, "%s%s", script,
             "pair_style gran model hertz tangential history limitForce on\npair_coeff * *\n"
             "fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad\n");
    audits(COR_AUDIT_NOT_AS_ASKED, NAN, text);
    assert_int_equal(seen.count, 2); /* no sphere has type 2 */
    finds(0, 6, 0.5, 0.55028, "coefficientRestitution, limitForce on, 1-1");
    says(0, 2, "peratomtypepair 2 0.436288 0.7 0.7 0.9");
    finds(1, 6, 0.7, 0.7, "coefficientRestitution, 1-wall");

    /* zeta = (gamma/2) sqrt(m/k), with the whole mass at a wall; then the stiffness of a characteristic speed */
    const double mass = pi / 6 * 1e-6 * 2500, zeta = 25 * sqrt(mass / 4000);
    snprintf(text, sizeof text, "%s%s", script,
             "pair_style gran model hooke tangential off\nfix w all wall/gran model hooke/stiffness tangential off "
             "primitive type 2 zplane 0\n");
    audits(COR_AUDIT_AS_ASKED, NAN, text);
    assert_int_equal(seen.count, 2);
    finds(0, 6, 0.5, 0.5, "coefficientRestitution, 1-1");
    finds(1, 9, NAN, exp(-pi * zeta / sqrt(1 - zeta * zeta)), "hooke/stiffness, gamman, 1-wall");
    const double modulus = 5e6 / (2 * (1 - 0.45 * 0.45)), root = sqrt(0.0025), z = log(0.5);
    const double k = 16 * modulus * root / 15 * pow(15 * mass / 2 * 4 / (16 * modulus * root), 0.2);
    check(fabs(seen.finding[0].duration_s / sqrt(mass / 2 / k * (pi * pi + z * z)) - 1) < 1e-12, "duration %.15g",
          seen.finding[0].duration_s);

    static const char *const broken[][2] = {
        {"pair_style gran model luding\n", "luding"},
        {"pair_style gran/hertz/history 1 0\n", "gran/hertz/history"},
        {"fix w all wall/gran model hertz mesh n_meshes 1 meshes other\n", "other"},
        {"fix w all wall/gran model hertz primitive type 0 zplane 0\n", "type of the wall"},
        {"fix x all property/global coefficientRestitution peratomtypepair 2 0.5 0.7 0.7\n", "each pair of types"},
        {"fix x all property/global coefficientRestitution peratomtypepair 1e30 0.5\n", "each pair of types"},
        {"fix x all property/global youngsModulus peratomtype stiff\n", "stiff"},
        {"pair_style gran model hertz cohesion sjkr\n", "cohesion"},
        {"pair_style gran model hooke viscous on\n", "Stokes"},
        {"pair_style gran model hooke/stiffness absolute_damping on\n", "gamman_abs"}};
    for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
        snprintf(text, sizeof text, "%s%s", script, broken[i][0]);
        assert_int_equal(audit_bytes("liggghts", text, strlen(text), NAN),
                         strstr(broken[i][0], "pair_style gran model h") ? COR_AUDIT_NOT_AS_ASKED
                                                                         : COR_AUDIT_NO_CONTACT);
        says(0, 1, broken[i][1]);
        check(isnan(seen.finding[0].realised), "%s realises %g", broken[i][0], seen.finding[0].realised);
    }
}

/* The error of the step: a viscoelastic sphere with 12 steps in an elastic duration (another integration of the same
 * scheme gave -5.6e-3 and 5.6e-3), an e that only the step spoils, a step that jumps over the contact; and versions. */
TEST(steps)
{
    char text[2048];
    const double mass = pi / 6 * 1e-6 * 2500 / 2, radius = 0.0025, k = 1e7 * sqrt(radius);
    const double eta = cor_sphere_beta_zero_overlap(0.5) * pow(k / mass, 0.6) / sqrt(radius);
    const double elastic = 3.218065459719043 * pow(mass / k, 0.4);
    snprintf(text, sizeof text, SPHERES "timestep %.17g\npair_style granular\npair_coeff 1 1 hertz 1e7 %.17g\n",
             elastic / 12, eta);
    audits(COR_AUDIT_AS_ASKED, 1, text);
    finds(0, 11, NAN, 0.5, "viscoelastic");
    check(fabs(seen.finding[0].step_bias + 5.6e-3) < 2e-4 && fabs(seen.finding[0].step_scatter - 5.6e-3) < 2e-4,
          "%g, %g", seen.finding[0].step_bias, seen.finding[0].step_scatter);
    says(0, 1, "The time step makes eps 0.494");
    says(0, 1, "A time step of ");

    static const char coarse[] = SPHERES "timestep %.17g\npair_style granular\n"
                                         "pair_coeff 1 1 hertz 1e7 0.5 damping coeff_restitution\n";
    snprintf(text, sizeof text, coarse, elastic / 6);
    audits(COR_AUDIT_NOT_AS_ASKED, 1, text);
    finds(0, 11, 0.5, 0.5, "coeff_restitution");
    assert_true(seen.finding[0].step_scatter > 5e-3);
    snprintf(text, sizeof text, coarse, elastic / 200);
    audits(COR_AUDIT_AS_ASKED, 1, text);
    assert_true(fabs(seen.finding[0].step_bias) < 1e-3 && seen.finding[0].step_scatter > 0);
    snprintf(text, sizeof text, coarse, elastic);
    audits(COR_AUDIT_NOT_AS_ASKED, 1, text);
    says(0, 1, "less than two time steps");

    static const char tsuji[] = "pair_style granular\npair_coeff * * hertz 1 0.5 damping tsuji\n";
    audits(COR_AUDIT_NOT_AS_ASKED, NAN, tsuji);
    says(0, 1, "source after July 2026 realises 0.4999");
    version = 20260901;
    audits(COR_AUDIT_AS_ASKED, NAN, tsuji);
    finds(0, 2, 0.5, 0.499918, "source after July 2026");
    version = 20210929;
    audit(tsuji, NAN);
    finds(0, 2, 0.5, 0.616076, "releases to July 2026");
    audit("pair_style granular\npair_coeff * * hertz 1 0.5 damping coeff_restitution\n", NAN);
    says(0, 1, "This version does not have the model.");
    version = 0;
}

static const char yade_text[] =
    "# a comment: tc = 1\n\"\"\"en = 1\ntc = 1\"\"\"\n"
    "tc, rho = 0.001, 2000\nen = 0.3\ntc = 1e-3\nk = 2*1.e4\n"
    "if fast:\n\tk = 1\n"
    "m = O.materials.append(ViscElMat(density=2500, tc=tc, en=en, et=1, label='grain'))\n"
    "n = ViscElMat(kn=2e4, cn=4.0, ks=0,\n   cs=0, label='soft')\n"
    "O.materials.append(FrictMat(young=1e7, poisson=0.3, density=2500, label='glass'))\n"
    "O.bodies.append([sphere((0, 0, 0), .005, material='glass'), "
    "utils.sphere(center=(0,0,1), radius=.005)])\n"
    "O.engines = [ForceResetter(), InteractionLoop([Ig2_Sphere_Sphere_ScGeom()],\n"
    "  [Ip2_FrictMat_FrictMat_MindlinPhys(frictAngle=0, en=MatchMaker(val=0.5), es=1)], # no\n"
    "  [Law2_ScGeom_MindlinPhys_Mindlin()]), NewtonIntegrator(damping=0)]\n"
    "O.dt = .02 * tc\n";
static const char kratos_text[] =
    "{ \"materials\":[{\n \"material_name\": \"a, b\", \"Variables\":{ \"PARTICLE_DENSITY\": 4000.0,\n"
    "\"YOUNG_MODULUS\": 3.8e11, \"POISSON_RATIO\": 0.23 } }, { \"material_name\": \"c\", \"Variables\": {} }],\n"
    "\"material_relations\":[{ \"material_names_list\":[\"a, b\", \"c\"], \"Variables\":{\n"
    "\"COEFFICIENT_OF_RESTITUTION\": 0.99,\n"
    "\"DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME\": \"DEM_D_Hertz_viscous_Coulomb\" } },\n"
    "{ \"material_names_list\":[\"c\", \"c\"], \"Variables\":{\n"
    "\"DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME\": \"DEM_D_Linear_viscous_Coulomb\", \"DAMPING_GAMMA\": 0.25 } },\n"
    "{ \"material_names_list\":[\"c\", \"a, b\"], \"Variables\":{ \"COEFFICIENT_OF_RESTITUTION\": 0.5,\n"
    "\"DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME\": \"DEM_D_JKR_Cohesive_Law\" } }] }";
static const char mfix_text[] = " units = 'SI' ! a comment\n mmax = 2\n d_p0(1) = 2e-3\n D_P0(2) = 4d-3\n"
                                " ro_s0(1:2) = 2500. 1000. # both\n des_coll_model = 'HERTZIAN'\n"
                                " e_young(1) = 1e7\n e_young(2) = 2e7\n v_poisson(1) = 0.3\n v_poisson(2) = 0.2\n"
                                " ew_young = 1e9\n vw_poisson = 0.3\n des_en_input(1) = 0.9\n"
                                " DES_EN_INPUT(2:3) = 2*0.5\n des_en_wall_input = 0.7, 0.1\n";
static const char mujoco_text[] = "<mujoco>\n<!-- <geom solref=\"1 1\"/>\n -->\n<option timestep=\"1e-5\"/>\n"
                                  "<default><geom solref=\"0.01 0.25\" solimp=\"0.99 0.99 0.001\"/>\n"
                                  "<default class=\"stiff\"><geom solref=\"-1e4 -50\"/></default>\n"
                                  "<default class=\"soft\"><geom solimp=\"0.9 0.95\"/></default></default>\n"
                                  "<worldbody><geom name=\"floor\" type='plane'/>\n"
                                  "<body childclass=\"stiff\"><body><geom size=\"0.1\"/></body>\n"
                                  "<geom class=\"main\" solref=\"9 9\" contype=\"0\" conaffinity=\"0\"/></body>\n"
                                  "<geom name=\"cushion\" class=\"soft\" solref=\"0.01 0.3\"/></worldbody>\n"
                                  "<contact><pair geom1=\"a\" geom2=\"b\" solref=\"1e-5 1\"/></contact></mujoco>\n";

/* Simulators whose inputs give values to keywords. The restitutions are LAWS' table and exp(-2 zeta A(zeta)). */
TEST(keywords)
{
    audits(COR_AUDIT_NOT_AS_ASKED, NAN, yade_text);
    assert_int_equal(seen.count, 3);
    finds(0, 10, 0.3, 0.397140, "ViscElMat, tc and en, grain-grain");
    says(0, 2, "ViscElMat(density=2500, tc=tc, en= 0.165219 , et=1, label='grain')");
    const double l = log(0.3),
                 steps = 2 * acos(0.35785663) / sqrt(1 - 0.35785663 * 0.35785663) / sqrt(pi * pi + l * l) * 50;
    check(fabs(seen.finding[0].duration_s / seen.finding[0].time_step_s - steps) < 1e-4, "%g steps, not %g",
          seen.finding[0].duration_s / seen.finding[0].time_step_s, steps);
    /* the density of YADE's class: springs in series */
    const double mass = pi / 6 * 1e-6 * 1000 / 2, zeta = 2.0 / (2 * sqrt(1e4 * mass));
    finds(1, 11, NAN, exp(-2 * zeta * acos(zeta) / sqrt(1 - zeta * zeta)), "ViscElMat, kn and cn, soft-soft");
    finds(2, 16, 0.5, 0.50001, "Mindlin, en (2023 and later), glass-glass");
    version = 20220000;
    audit(yade_text, NAN);
    finds(2, 16, 0.5, 0.550283, "before 2023");
    version = 0;

    audits(COR_AUDIT_NOT_AS_ASKED, NAN,
           "e = 0.5\nIp2_FrictMat_FrictMat_MindlinPhys(frictAngle=MatchMaker(matches=((0, 0, 1),)),\n"
           " en=MatchMaker(matches=((1, 1, e), (0,1,0.99),)), es=1)\nO.engines=[]\n");
    assert_int_equal(seen.count, 2);
    finds(0, 2, 0.5, 0.50001, "Mindlin, en (2023 and later), 1-1");
    finds(1, 2, 0.99, 0.97895, "0-1");

    audits(COR_AUDIT_NOT_AS_ASKED, NAN, kratos_text);
    assert_int_equal(seen.count, 4);
    says(0, 1, "DEM_D_JKR_Cohesive_Law");
    finds(1, 5, 0.99, 0.97895, "DEM Hertz, COEFFICIENT_OF_RESTITUTION, a, b-c");
    finds(2, 8, NAN, 0.506277, "DEM linear, DAMPING_GAMMA, c-c");
    finds(3, 9, NAN, NAN, "c-a, b");

    audits(COR_AUDIT_NOT_AS_ASKED, 1, mfix_text);
    assert_int_equal(seen.count, 5);
    finds(0, 13, 0.9, 0.910079, "DEM, HERTZIAN, 1-1");
    says(0, 2, "des_en_input(1) = 0.88886");
    finds(1, 14, 0.5, 0.539574, "1-2");
    finds(2, 14, 0.5, 0.539574, "2-2");
    finds(3, 15, 0.7, 0.72716, "1-wall");
    says(3, 2, "des_en_wall_input = 0.670");
    finds(4, 15, 0.1, 0.141277, "2-wall");
    assert_true(seen.finding[1].duration_s > seen.finding[0].duration_s);
    assert_true(seen.finding[3].duration_s < seen.finding[0].duration_s); /* the wall is stiffer */

    audits(COR_AUDIT_AS_ASKED, NAN,
           " des_en_input(1) = 0.9\n kn = 1e4\n d_p0(1) = 0.005\n ro_s0(1) = 2000\n"
           " dtsolid_factor = 60\n");
    check(fabs(seen.finding[0].duration_s / seen.finding[0].time_step_s - 60) < 1e-9, "%g steps",
          seen.finding[0].duration_s / seen.finding[0].time_step_s);
    assert_true(seen.finding[0].step_scatter > 1e-4 && seen.finding[0].step_scatter < 9e-3);

    audits(COR_AUDIT_NOT_AS_ASKED, NAN, mujoco_text);
    assert_int_equal(seen.count, 4);
    finds(0, 8, NAN, 0.506277, "timeconst, dampratio), dmin = dmax, floor-floor");
    check(fabs(seen.finding[0].duration_s / (2 * acos(0.25) / sqrt(1 - 0.0625) * 0.0025) - 1) < 1e-9, "duration %g",
          seen.finding[0].duration_s);
    finds(1, 9, NAN, 0.506277, "solref (-stiffness, -damping), dmin = dmax, geom-geom");
    finds(2, 11, NAN, NAN, "cushion-cushion");
    says(2, 1, "dmin and dmax differ");
    says(2, 1, "give --speed");
    finds(3, 12, NAN, exp(-2), "a-b");
    says(3, 1, "raises timeconst");
    /* MuJoCo 2.2.2 realised 0.509960 at 1 m/s, with 2000 steps in the contact, which add 1.2e-4 without solimp, too */
    static const char soft[] = "<mujoco><geom name='a' solref='0.01 0.25'/>";
    audit(soft, 1);
    finds(0, 1, NAN, 0.509846, "dmin < dmax, a-a");
    audit(soft, 0.1);
    finds(0, 1, NAN, 0.506471, "dmin < dmax, a-a");
    audit("<mujoco><geom solimp='0.9 0.9' condim='6'/>", 1);
    says(0, 1, "pyramidal");
    audit("<mujoco><option cone='elliptic'/><geom solimp='0.9 0.9' condim='6'/>", 1);
    finds(0, 1, NAN, exp(-2), "geom-geom");
    seen.included = "<geom solref='0.01 0.25' solimp='1 1'/>";
    audits(COR_AUDIT_AS_ASKED, NAN, "<mujoco><include file='geoms.xml'/>");
    finds(0, 1, NAN, 0.506277, "geom-geom");
    seen.included = "<include file='again.xml'/>\n<include file='again.xml'/>";
    audits(COR_AUDIT_NO_CONTACT, NAN, "<mujoco><include file='geoms.xml'/>");
    says(0, 1, "does a file include itself");

    static const char *const broken[][3] = {
        {"yade", "ViscElMat(tc=1e-3, en=en)\n", "could not be read"},
        {"yade", "en = 0.5\nif 1:\n  en = 0.6\nViscElMat(tc=1e-3, en=en)\n", "could not be read"},
        {"yade", "ViscElMat(young=1e7, en=0.5)\n", "young and en"},
        {"yade", "ViscElMat(tc=1e-3, kn=1, cn=1, en=0.5)\n", "tc and kn"},
        {"yade", "Ip2_FrictMat_FrictMat_MindlinPhys(en=0.5, betan=0.5)\n", "en and betan"},
        {"yade", "Ip2_FrictMat_FrictMat_MindlinPhys(en=0.5, vn=1)\n", "viscoelastic sphere"},
        {"yade", "Ip2_FrictMat_FrictMat_MindlinPhys(en=MatchMaker(matches=((0,0,e),)))\n", "could not be read"},
        {"yade", "Ip2_FrictMat_FrictMat_MindlinPhys(en=MatchMaker(matches=pairs))\n", "could not be read"},
        {"yade", "ViscElMat(tc=1e-3, en=0.5)\nO.engines=[NewtonIntegrator()]\n", "damps all motions"},
        {"yade", "ip.betan = 0.5\nIp2_FrictMat_FrictMat_MindlinPhys(label='ip')\n", "outside of its constructor"},
        {"mfix", "des_en_input(1) = ${e}\n", "could not be read"},
        {"mfix", "mmax = 1\ndes_en_input(2) = 0.5\n", "could not be made out"},
        {"mfix", "use_cohesion = .True.\ndes_en_input(1) = 0.5\n", "cohesion"},
        {"mfix", "d_p0(1) = wide\ndes_en_input(1) = 0.5\n", "D_P0"},
        {"mujoco", "<geom solref=\"0.02\" solimp=\"1 x\"/>", "solimp could not be read"},
        {"mujoco", "<geom solref=\"-1 x\" solimp=\"1 1\"/>", "could not be read"},
        {"mujoco", "<flag override=\"enable\"/><geom/>", "o_solref"},
        {"kratos", "{\"material_name\": \"a\", \"COEFFICIENT_OF_RESTITUTION\": 0.5}", "is not read"}};
    for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
        assert_int_equal(audit_bytes(broken[i][0], broken[i][1], strlen(broken[i][1]), NAN), COR_AUDIT_NOT_AS_ASKED);
        says(0, 1, broken[i][2]);
    }
}

TEST(missing)
{
    /* nothing says the radius; then the speed */
    audits(COR_AUDIT_NOT_AS_ASKED, 1,
           "units si\npair_style granular\npair_coeff * * hertz 1e7 5e4 damping viscoelastic\n");
    finds(0, 3, NAN, NAN, "*-*");
    says(0, 1, "give --radius");
    audits(COR_AUDIT_NOT_AS_ASKED, NAN, SPHERES "pair_style granular\npair_coeff * * hertz 1e7 5e4\n");
    says(0, 1, "give --speed");
    says(0, 1, "takes viscoelastic");
    /* values that are not there, a division by zero, variables in a circle and in a tower */
    static const char *const broken[][2] = {
        {"pair_coeff * * hertz 1e7 ${e}\n", "${e}"},
        {"variable e equal 1/0\npair_coeff * * hertz 1e7 ${e}\n", "${e}"},
        {"variable a equal v_b\nvariable b equal v_a\npair_coeff * * hertz 1e7 $a\n", "$a"},
        {"variable a equal v_a+v_a\npair_coeff * * hertz 1e7 $(v_a*v_a)\n", "$(v_a*v_a)"},
        {"pair_coeff * * hertz 1e7\n", "missing or no numbers"},
        {"pair_coeff * * hertz 1e7 much\n", "missing or no numbers"},
        {"pair_coeff 1 x hertz 1e7 0.5\n", "types"},
        {"pair_coeff 4294967297* * hertz 1e7 0.5\n", "types"},
        {"pair_coeff * * mdr 1 2 3 4 5 6\n", "mdr"},
        {"pair_coeff * * hertz 1e7 0.5 damping magic\n", "magic"},
        {"include missing\n", "cannot include missing"},
        {"if \"$x > 1\" then \"pair_coeff * * hertz 1 1\"\n", "$x"},
        {"timestep -1\n", "timestep"},
        {"units metal\n", "metal"},
        {"fix w all wall/gran cone 1 2\n", "cone"},
        {"pair_style lj/cut 2.5\n", "lj/cut"}};
    for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
        char text[512];
        snprintf(text, sizeof text, "pair_style granular\npair_coeff * * hertz 1e7 0.5 damping coeff_restitution\n%s",
                 broken[i][0]);
        audits(COR_AUDIT_NOT_AS_ASKED, NAN, text);
        says(0, 1, broken[i][1]);
        assert_true(seen.finding[0].line > 2 && !seen.finding[0].model);
    }
}

TEST(control)
{
    /* branches, an index variable of the command line's kind, quotes, a commentary in quotes */
    audits(COR_AUDIT_AS_ASKED, NAN,
           "variable e index 0.4 0.5\nvariable e index 0.9\npair_style granular\n"
           "if \"${e} == 0.4 && 2^3 > 7\" then \"pair_coeff * * hertz 1e7 ${e} damping "
           "coeff_restitution\" else \"pair_coeff * * hertz 1e7 0.1 damping tsuji\"\n"
           "print \"${unknown} # 'quoted\"\n");
    finds(0, 4, 0.4, 0.4, "*-*");
    /* a cycle of includes ends */
    seen.included = "include again\ninclude again\n";
    audits(COR_AUDIT_NOT_AS_ASKED, NAN,
           "pair_style granular\ninclude first\npair_coeff * * hertz 1 0.5 damping coeff_restitution\n");
    says(0, 1, "does a file include itself");
    assert_string_equal(seen.finding[0].file, "included");
    seen.included = "pair_coeff * * hertz 1 0.5 damping coeff_restitution";
    audits(COR_AUDIT_AS_ASKED, NAN, "pair_style granular\ninclude first\n");
    finds(0, 1, 0.5, 0.5, "*-*");
    /* clear forgets the bodies */
    audits(COR_AUDIT_NOT_AS_ASKED, NAN,
           SPHERES "pair_style granular\npair_coeff 1 1 hooke 1e3 0.05 damping velocity\nclear\n"
                   "units si\npair_style granular\npair_coeff 1 1 hooke 1e3 0.05 damping velocity\n");
    assert_true(!isnan(seen.finding[0].realised) && isnan(seen.finding[1].realised));
}

TEST(texts)
{
    static char longest[1 << 20];
    audits(COR_AUDIT_UNKNOWN, NAN, "");
    audits(COR_AUDIT_UNKNOWN, NAN, "hello\n");
    assert_int_equal(audit_bytes("lammps", "hello", 5, NAN), COR_AUDIT_NO_CONTACT);
    assert_int_equal(audit_bytes("lammps", "pair_style\0granular", 19, NAN), COR_AUDIT_NOT_TEXT);
    /* a line without an end, then every prefix and many damages of a text */
    memset(longest, 'x', sizeof longest);
    memcpy(longest, "pair_style granular &", 21);
    assert_int_equal(audit_bytes(NULL, longest, sizeof longest, NAN), COR_AUDIT_NO_CONTACT);
    says(0, 1, "longer than");
    static const char text[] =
        SPHERES "variable a loop 3\nvariable \"b\" equal (1+$a)*sqrt(v_a)^2 % 7\npair_style "
                "granular\npair_coeff 1* *2 hertz 1e7 $(v_b/9:%g) damping tsuji &\nlimit_damping\n"
                "if '$a<=2' then 'timestep 1e-6' elif 1 'clear' else \"include x\"\n";
    static const char *const inputs[][2] = {{"lammps", text},        {"liggghts", text},  {"yade", yade_text},
                                            {"kratos", kratos_text}, {"mfix", mfix_text}, {"mujoco", mujoco_text}};
    tolerance = 1e-9; /* too small to look for a time step, which takes long */
    for (size_t k = 0; k < sizeof inputs / sizeof *inputs; k++) {
        const size_t size = strlen(inputs[k][1]);
        for (size_t i = k; i <= size; i += few_or_all(6, 2) * (size_t)check_number("COR_TEST_DIVISOR", 1))
            audit_bytes(inputs[k][0], inputs[k][1], i, NAN);
        for (size_t i = k; i < size; i += few_or_all(15, 5) * (size_t)check_number("COR_TEST_DIVISOR", 1))
            for (const char *with = "\"$({&*\n-/"; *with; with++) {
                memcpy(longest, inputs[k][1], size);
                longest[i] = *with;
                audit_bytes(inputs[k][0], longest, size, NAN);
            }
    }
}

RUN_TESTS(lammps, liggghts, steps, keywords, missing, control, texts)
