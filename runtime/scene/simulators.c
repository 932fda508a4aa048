/* SPDX-License-Identifier: MIT */
/* The table of the contact models of simulators; docs/simulators.md explains it. It has, for each model, the damping
 * law, the end of contact, the damping that the model computes from e, and the number to set for a damping. */
#include "cor/scene.h"

#include "runtime/scene/simulators.h"

#include <math.h>
#include <string.h>

#include "cor/law.h"
#include "runtime/number/root.h"
#include "runtime/scene/exponents.h"

/* ---- the damping that simulators compute from e ---- */

double cor_thornton_gamma(double e)
{
    static const double h[] = {-6.918798, -16.41105, 146.8049,  -796.4559, 2928.711,
                               -7206.864, 11494.29,  -11342.18, 6276.757,  -1489.915};
    double sum = 0;
    for (int k = 9; k >= 0; k--)
        sum = e * (h[k] + sum);
    const double loss = 1 - (1 + e) * (1 + e) * exp(sum);
    if (!isgreater(loss, 0))
        return loss == 0 ? INFINITY : NAN;
    return loss <= 1 ? sqrt(1 / loss - 1) : NAN;
}

double cor_tsuji_alpha(double e)
{
    return 1.2728 + e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
}

double cor_flores_beta(double e)
{
    return 1.6 * (1 - e) / e;
}

/* Returns zeta, exact at zero overlap. LIGGGHTS, Chrono, MercuryDPM and others use this formula for every end. */
static double exact_at_zero_overlap(double e)
{
    return cor_law_damping(COR_LAW_LINEAR, COR_END_ZERO_OVERLAP, e);
}

static double exact_at_zero_force(double e)
{
    return cor_law_damping(COR_LAW_LINEAR, COR_END_ZERO_FORCE, e);
}

/* Returns zeta = sqrt(6/5) gamma of the damping 2 gamma sqrt(m k), with the tangent stiffness k = (3/2) K sqrt(x). */
static double thornton(double e)
{
    return sqrt(1.2) * cor_thornton_gamma(e);
}

/* Returns zeta as YADE computes it: no damping at e = 1 exactly. */
static double thornton_yade(double e)
{
    return e == 1 ? 0 : thornton(e);
}

/* Returns zeta as Kratos computes it: e below 0.001 counts as 0.001, and above 0.999 there is no damping. */
static double thornton_kratos(double e)
{
    return e > 0.999 ? 0 : thornton(e < 0.001 ? 0.001 : e);
}

static double tsuji_until_2026(double e)
{
    return cor_tsuji_alpha(e) / sqrt(5);
}

static double tsuji_since_2026(double e)
{
    return sqrt(0.4) * cor_tsuji_alpha(e);
}

/* Applies the polynomial for Hertz's force to a linear spring, as LAMMPS did. */
static double tsuji_on_hooke_until_2026(double e)
{
    return cor_tsuji_alpha(e) / 2;
}

static double tsuji_on_hooke_since_2026(double e)
{
    return cor_tsuji_alpha(e) / sqrt(2);
}

/* Applies the formula of the linear dashpot to Hertz's force. */
static double mfix_hertz(double e)
{
    return 2 / sqrt(5) * cor_law_damping(COR_LAW_LINEAR, COR_END_ZERO_OVERLAP, e);
}

/* pi with 8 digits */
#define ESYS_PI 3.1415927
static double esys(double e)
{
    return e == 0 ? 1 : -log(e) / sqrt(ESYS_PI * ESYS_PI + log(e) * log(e));
}

/* Returns the damping of an impulse, 1 - e. */
static double loss_of_impulse(double e)
{
    return 1 - e;
}

/* Bisects the zero-force formula between 0 and 16, like Kratos, until the bracket is below 0.0001. */
static double kratos_linear(double e)
{
    const double wanted = e < 0.001 ? 0.001 : e;
    double low = 0, high = 16, gamma = 8;
    if (wanted > 0.999)
        return 0;
    while (high - low > 0.0001) {
        *(cor_law_eps(COR_LAW_LINEAR, COR_END_ZERO_FORCE, gamma) > wanted ? &low : &high) = gamma;
        gamma = 0.5 * (low + high);
    }
    return gamma;
}

/* ---- numbers from the damping, and back ---- */

/* Numbers that are the damping times a factor */
/* clang-format off */
enum number {
    DAMPING, DASHPOT, DASHPOT_PER_MASS, PAIR_DASHPOT, RELAXATION_TIME, TANGENT_RATIO, TSUJI_BETA, CROSSLEY_PER_SPEED,
    SIMBODY, AREA_ROOT, AREA_HERTZ, DISSIPATION_TIME, DISSIPATION_TIME_ESYS, HERTZ_VELOCITY, HERTZ_MASS_VELOCITY,
    CHRONO_HERTZ
};
/* clang-format on */

/* Returns the factor at the speed g. */
static double factor_of(int number, const struct cor_scene_contact *c, double g)
{
    const double m = c->mass_kg, k = c->stiffness, r = c->radius_m;
    return number == DASHPOT              ? 2 * sqrt(k * m) /* C = 2 zeta sqrt(K m), kg/s */
           : number == DASHPOT_PER_MASS   ? 2 * sqrt(k / m) /* C/m, 1/s; per unit of mass */
           : number == PAIR_DASHPOT       ? 4 * sqrt(k * m) /* two equal dashpots in series: each has twice C */
           : number == RELAXATION_TIME    ? 2 * sqrt(m / k) /* tau in F = k x + k tau x' */
           : number == TANGENT_RATIO      ? sqrt(5.0 / 6)   /* gamma in 2 gamma sqrt(m k_tangent) */
           : number == TSUJI_BETA         ? sqrt(5)         /* alpha in alpha sqrt(m K) x^(1/4) x' */
           : number == CROSSLEY_PER_SPEED ? 1 / g           /* d = beta/g, s/m */
           : number == SIMBODY            ? 2 / (3 * g)     /* c in (3/2) c x' */
           : number == AREA_ROOT          ? pow(k / m, 0.75) / sqrt(r * g) /* eta in eta m sqrt(R x) x', linear law */
           : number == AREA_HERTZ         ? pow(k / m, 0.6) / (sqrt(r) * pow(g, 0.2)) /* the same with Hertz's force */
           : number == DISSIPATION_TIME   ? 2.0 / 3 * pow(m / k, 0.4) / pow(g, 0.2)
           : number == DISSIPATION_TIME_ESYS ? pow(m / k, 0.4) / pow(g, 0.2)
           : number == HERTZ_VELOCITY        ? pow(m, 0.6) * pow(k, 0.4) * pow(g, 0.2)
           : number == HERTZ_MASS_VELOCITY   ? pow(k / m, 0.4) * pow(g, 0.2)
           : number == CHRONO_HERTZ          ? pow(k / m, 0.6) / (r * pow(g, 0.2))
                                             : 1;
}

static double scale_damping(const struct cor_simulator_model *model, double damping, const struct cor_scene_contact *c,
                            double g)
{
    return damping * factor_of(model->number, c, g);
}

static double unscale_number(const struct cor_simulator_model *model, double number, const struct cor_scene_contact *c,
                             double g)
{
    return number / factor_of(model->number, c, g);
}

/* Returns P, the Padé approximant of order [3/6] of eps at zero force in v = sqrt(beta) (Müller and Pöschel, Phys.
 * Rev. E 84, 021302 (2011)). In YADE since 2025 en = P, with beta at the speed vn = 1 m/s. */
static double yade_pade(double v)
{
    static const double above[] = {1, 1.07232, 0.574198, 0.141552};
    static const double below[] = {1, 1.07232, 1.72765, 1.37842, 1.19449, 0.467273, 0.235585};
    double p = 0, q = 0;
    if (v > 1e50)
        return 0;
    for (int k = 3; k >= 0; k--)
        p = p * v + above[k];
    for (int k = 6; k >= 0; k--)
        q = q * v + below[k];
    return p / q;
}

static double yade_en_of_damping(const struct cor_simulator_model *model, double damping,
                                 const struct cor_scene_contact *c, double g)
{
    (void)model, (void)c;
    return yade_pade(sqrt(damping * pow(g, -0.2)));
}

static double damping_of_yade_en(const struct cor_simulator_model *model, double en, const struct cor_scene_contact *c,
                                 double g)
{
    (void)model, (void)c;
    double low = 0, high = 1, middle;
    if (!(isgreater(en, 1e-60) && en <= 1))
        return NAN;
    while (yade_pade(high) > en)
        high *= 2;
    for (int k = 0; k < 200 && cor_halve(&middle, low, high); k++)
        *(yade_pade(middle) > en ? &low : &high) = middle;
    return high * high * pow(g, 0.2);
}

/* ---- the table ---- */

#define SPHERE(parameter) "The viscoelastic sphere: " parameter " = (3/2) A k_n/m for every speed."
#define NOT_SLOW "Slow impacts lose more, and below a threshold speed the bodies never part: use limit_damping."
#define ASKED(map, from, to) .damping_of_e = map, .least = from, .most = to
#define NUMBER(of_damping, to_damping) .most = 1, .number_of_damping = of_damping, .damping_of_number = to_damping
#define SCALED(name) NUMBER(scale_damping, unscale_number), .number = name
#define OPEN 0x1p-1022 /* e > 0 */
#define IMPLICIT "This eps is the limit of short time steps: the method is implicit, and longer steps damp more."
#define PFC(mode) EVERYWHERE("contact cmat default model linear property kn {K} dp_nratio {n} dp_mode " mode "\n")
/* Lines for the input, for two bodies and for a body and a wall */
#define EVERYWHERE(text) .lines = text, .wall_lines = text
#define PAIRS(text) .lines = text
#define BOTH(text, at_wall) .lines = text, .wall_lines = at_wall
#define NO_LINES .lines = NULL
#define LAMMPS(spring, damping)                                                                                        \
    .lines = "pair_style granular\n"                                                                                   \
             "pair_coeff {pair} " spring " {n} tangential {tangential} damping " damping "\n",                         \
    .wall_lines = "fix cor_wall all wall/gran granular " spring " {n} tangential {tangential} damping " damping        \
                  " zplane 0 NULL\n",                                                                                  \
    .many = "-# Put these lines after create_atoms or read_data: a group contains only atoms that already exist. "     \
            "Count only the types of balls in create_box.\n"                                                           \
            "-pair_style granular\n"                                                                                   \
            "ppair_coeff {i} {j} " spring " {n} tangential {tangential} damping " damping "\n"                         \
            "ggroup cor_{i} type {i}\n" WALL_PLANE(                                                                    \
                "zplane 0 NULL") "wfix cor_wall_{i}_{j} cor_{i} wall/gran granular " spring                            \
                                 " {n} tangential {tangential} damping " damping " {plane}\n",                         \
    .pairs = COR_PAIRS_LINES
/* The plane of a material's wall. Users may define the variable before these lines. */
#define WALL_PLANE(plane)                                                                                              \
    "v# the plane of wall {j}: to choose another plane, define this variable before these lines\n"                     \
    "vvariable cor_wall_{j} index \"" plane "\"\n"
/* The wall has atom type 2, because a contact with it has other numbers than a contact of two spheres. */
#define LIGGGHTS(model, limit, properties)                                                                             \
    .lines = LIGGGHTS_PAIR(model, limit, properties),                                                                  \
    .wall_lines =                                                                                                      \
        LIGGGHTS_PAIR(model, limit, properties) "fix cor_wall all wall/gran model " model                              \
                                                " tangential {tangential} primitive type 2 zplane 0{undamped}" limit   \
                                                "\n",                                                                  \
    .many = LIGGGHTS_PAIR(model, limit, properties)                                                                    \
        WALL_PLANE("zplane 0") "vfix cor_wall_{j} all wall/gran model " model                                          \
                               " tangential {tangential} primitive type {j} {plane}{undamped}" limit "\n",             \
    .pairs = COR_PAIRS_MATRIX
#define LIGGGHTS_PAIR(model, limit, properties)                                                                        \
    "-pair_style gran model " model " tangential {tangential}{undamped}" limit "\n"                                    \
    "-pair_coeff * *\n" properties                                                                                     \
    "?fix cor_friction all property/global coefficientFriction peratomtypepair {types} {mu[]}\n"
#define LIGGGHTS_E                                                                                                     \
    "?fix cor_young all property/global youngsModulus peratomtype {young[i]}\n"                                        \
    "?fix cor_poisson all property/global poissonsRatio peratomtype {poisson[i]}\n"                                    \
    "-fix cor_e all property/global coefficientRestitution peratomtypepair {types} {n[]}\n"
/* LIGGGHTS requires kt and gammat even with tangential off. */
#define LIGGGHTS_STIFFNESS(stiffness)                                                                                  \
    "-fix cor_kn all property/global kn peratomtypepair {types} " stiffness "\n"                                       \
    "-fix cor_gamman all property/global gamman peratomtypepair {types} {n[]}\n"                                       \
    "-fix cor_kt all property/global kt peratomtypepair {types} {kt[]}\n"                                              \
    "-fix cor_gammat all property/global gammat peratomtypepair {types} {0[]}\n"
#define YADE(where, material, physics, law)                                                                            \
    where(material "cor_contact = InteractionLoop(\n"                                                                  \
                   "    [Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],\n"          \
                   "    [" physics "],\n"                                                                              \
                   "    [" law "])\n"),                                                                                \
        .pairs = COR_PAIRS_ONE_LAW
#define YADE_MINDLIN(number, others)                                                                                   \
    YADE(EVERYWHERE, YADE_FRICTION, "Ip2_FrictMat_FrictMat_MindlinPhys(" number "={n}, " others ")",                   \
         "Law2_ScGeom_MindlinPhys_Mindlin()"),                                                                         \
        .many = "mcor_material_{i} = FrictMat(young={young}, poisson={poisson}, {density}frictionAngle=0)\n"           \
                "mO.materials.append(cor_material_{i})\n-cor_contact = InteractionLoop(\n"                             \
                "-    [Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],\n"            \
                "-    [Ip2_FrictMat_FrictMat_MindlinPhys(" number "=MatchMaker(matches=(\n"                            \
                "c        (cor_material_{i}.id, cor_material_{j}.id, {n}),\n-    )),\n"                                \
                "F    frictAngle=MatchMaker(matches=(\nf        (cor_material_{i}.id, cor_material_{j}.id, {phi}),\n"  \
                "F    )),\n-    " others ")],\n-    [Law2_ScGeom_MindlinPhys_Mindlin()])\n"
#define YADE_FRICTION                                                                                                  \
    "?cor_material = FrictMat(young={young}, poisson={poisson}, {density}frictionAngle={phi})\n"                       \
    "?cor_material_2 = FrictMat(young={young2}, poisson={poisson2}, {density2}frictionAngle={phi})\n"

#define OPENFOAM_NUMBERS                                                                                               \
    "    alpha {n};\n    b 1.5;\n    mu 0;\n    cohesionEnergyDensity 0;\n    collisionResolutionSteps 12;\n}\n"

#define LUDING(number, property, value)                                                                                \
    "fix cor_luding_" number " all property/global " property " peratomtypepair {types} " value "\n"
#define YADE_LUDING "k1={k1}, kp={kp}, kc=0, ks=0, PhiF={depth}, G0=0)\n"

/* Defines the species of several materials and of their pairs. Walls have no density. */
#define MERCURYDPM_MANY(name, numbers)                                                                                 \
    .many = "mauto cor_{i} = speciesHandler.copyAndAddObject(" name "Species());\n"                                    \
            "bcor_{i}->setDensity({rho});\n"                                                                           \
            "uauto cor_{i}_{j} = speciesHandler.getMixedObject(cor_{i}, cor_{j});\n" numbers
#define MERCURYDPM_DISSIPATION                                                                                         \
    "ccor_{contact}->setEffectiveElasticModulus({E});\nccor_{contact}->setDissipation({n});\n"
#define MERCURYDPM_FRICTION                                                                                            \
    "?species->setSlidingFrictionCoefficient({mu});\n?species->setSlidingFrictionCoefficientStatic({mu});\n"           \
    "?species->setSlidingStiffness({kt0});\n?species->setSlidingDissipation({ct});\n"
/* The density of a material. The mixed species of two materials has no density. */
#define MERCURYDPM_DENSITY "?species->setDensity({rho});\n"

/* Source of a model: its file, how it is known ("run" or "source"), its version */
#define OF(of_file, how, of_version) .file = of_file, .known = how, .version = of_version
#define OF_LAMMPS_RUN OF("src/GRANULAR/gran_sub_mod_damping.cpp", "run", "29 Sep 2021 to 4 Feb 2025")
#define OF_LAMMPS_SOURCE OF("src/GRANULAR/gran_sub_mod_damping.cpp", "source", "source 07b704ca, 2026")
#define OF_LIGGGHTS(in) OF("src/" in, "run", "3.8, source 3d5c00f2")
#define OF_YADE(in) OF("pkg/dem/" in, "run", "2023.02a")
#define OF_MERCURYDPM(in) OF("Kernel/Species/NormalForceSpecies/" in, "run", "source fb0ebf1d")
#define OF_CHRONO OF("src/chrono/physics/ChContactSMC.cpp", "run", "source 7689fbc0")
#define OF_MFIX OF("model/check_data/check_solids_dem.f", "source", "21.3.2")
#define OF_KRATOS(in) OF("applications/DEMApplication/" in, "source", "source 03f57bf0")
#define OF_ESYS_PARTICLE OF("Model", "run", "2.3.5")
#define OF_DRAKE(in) OF("multibody/" in, "source", "source be259df7")
#define OF_MUJOCO OF("src/engine/engine_core_constraint.c", "run", "2.2.2, source a7255075")
#define OF_MODELICA OF("Mechanics/Translational/Components/ElastoGap", "source", "Modelica Standard Library 4")
#define OF_BULLET(in) OF("src/" in, "run", "3.24")
#define SIMULATOR(rows, of_name, of_title, moves)                                                                      \
    .name = of_name, .title = of_title, .integrator = COR_##moves, .models = rows,                                     \
    .model_count = sizeof(rows) / sizeof *(rows)
/* The last arguments are the lines, .since and .until. */
#define ROW(of_id, of, of_model, number, of_law, of_end, map, sentence, ...)                                           \
    {                                                                                                                  \
        .id = COR_##of_id, of, .model = of_model, .parameter = number, .law = COR_LAW_##of_law,                        \
        .end = COR_END_##of_end, map, .advice = sentence, __VA_ARGS__                                                  \
    }
#define FRICTION "{nofriction}"
#define COMMENT(before, after) .comment = before, .comment_end = after
#define XML COMMENT("<!-- ", " -->")
#define SCRIPT COMMENT("# ", "")
#define CPP COMMENT("// ", "")
static const struct cor_simulator_model lammps[] = {
    ROW(LAMMPS_HOOKE_VELOCITY, OF_LAMMPS_RUN, "granular hooke, damping velocity", "eta_n, kg/s", LINEAR, ZERO_OVERLAP,
        SCALED(DASHPOT), "eta_n is the damping coefficient itself.", LAMMPS("hooke {K}", "velocity")),
    ROW(LAMMPS_HOOKE_VELOCITY_LIMIT, OF_LAMMPS_RUN, "granular hooke, damping velocity, limit_damping", "eta_n, kg/s",
        LINEAR, ZERO_FORCE, SCALED(DASHPOT), "Exact.", LAMMPS("hooke {K}", "velocity limit_damping")),
    ROW(LAMMPS_HOOKE_MASS_VELOCITY, OF_LAMMPS_RUN, "granular hooke, damping mass_velocity; gran/hooke",
        "eta_n or gamma_n, 1/s", LINEAR, ZERO_OVERLAP, SCALED(DASHPOT_PER_MASS), "Exact.",
        LAMMPS("hooke {K}", "mass_velocity")),
    ROW(LAMMPS_HOOKE_MASS_VELOCITY_LIMIT, OF_LAMMPS_RUN, "granular hooke, damping mass_velocity, limit_damping",
        "eta_n, 1/s", LINEAR, ZERO_FORCE, SCALED(DASHPOT_PER_MASS), "Exact.",
        LAMMPS("hooke {K}", "mass_velocity limit_damping")),
    ROW(LAMMPS_HOOKE_VISCOELASTIC, OF_LAMMPS_RUN, "granular hooke, damping viscoelastic (the default)",
        "eta_n, 1/(m s)", LINEAR_ROOT, ZERO_OVERLAP, SCALED(AREA_ROOT),
        "The restitution depends on the impact speed: the number holds at one speed.",
        LAMMPS("hooke {K}", "viscoelastic")),
    ROW(LAMMPS_HERTZ_VISCOELASTIC, OF_LAMMPS_RUN,
        "granular hertz, damping viscoelastic (the default); gran/hertz/history", "eta_n, 1/(m s)", VISCOELASTIC,
        ZERO_OVERLAP, SCALED(AREA_HERTZ), SPHERE("eta_n"), LAMMPS("hertz {kn}", "viscoelastic")),
    ROW(LAMMPS_HERTZ_VISCOELASTIC_LIMIT, OF_LAMMPS_RUN, "granular hertz, damping viscoelastic, limit_damping",
        "eta_n, 1/(m s)", VISCOELASTIC, ZERO_FORCE, SCALED(AREA_HERTZ), SPHERE("eta_n"),
        LAMMPS("hertz {kn}", "viscoelastic limit_damping")),
    ROW(LAMMPS_HERTZ_VELOCITY, OF_LAMMPS_RUN, "granular hertz, damping velocity", "eta_n, kg/s", HERTZ_DASHPOT,
        ZERO_OVERLAP, SCALED(HERTZ_VELOCITY), NOT_SLOW, LAMMPS("hertz {kn}", "velocity")),
    ROW(LAMMPS_HERTZ_MASS_VELOCITY, OF_LAMMPS_RUN, "granular hertz, damping mass_velocity", "eta_n, 1/s", HERTZ_DASHPOT,
        ZERO_OVERLAP, SCALED(HERTZ_MASS_VELOCITY), NOT_SLOW, LAMMPS("hertz {kn}", "mass_velocity")),
    ROW(LAMMPS_COEFF_RESTITUTION, OF_LAMMPS_SOURCE, "granular hertz or hooke, damping coeff_restitution", "e", TSUJI,
        ZERO_OVERLAP, ASKED(exact_at_zero_overlap, OPEN, 1), "Exact.",
        LAMMPS("{model} {stiffness}", "coeff_restitution"), .any_spring = 1, .since = 20250205),
    ROW(LAMMPS_COEFF_RESTITUTION_LIMIT, OF_LAMMPS_SOURCE,
        "granular hertz or hooke, damping coeff_restitution, limit_damping", "e", TSUJI, ZERO_FORCE,
        ASKED(exact_at_zero_overlap, OPEN, 1),
        "LAMMPS computes its damping for contacts that end at zero overlap. These end at zero force: eps is above e.",
        LAMMPS("{model} {stiffness}", "coeff_restitution limit_damping"), .any_spring = 1, .since = 20250205),
    ROW(LAMMPS_HERTZ_TSUJI, OF_LAMMPS_RUN, "granular hertz, damping tsuji, releases to July 2026", "e", TSUJI,
        ZERO_OVERLAP, ASKED(tsuji_until_2026, 0, 1),
        "LAMMPS realises up to 0.143 more than its e; coeff_restitution of later versions is exact.",
        LAMMPS("hertz {kn}", "tsuji"), .until = 20260731),
    ROW(LAMMPS_HERTZ_TSUJI_LIMIT, OF_LAMMPS_RUN, "granular hertz, damping tsuji, limit_damping, releases to July 2026",
        "e", TSUJI, ZERO_FORCE, ASKED(tsuji_until_2026, 0, 1), "LAMMPS realises up to 0.263 more than its e.",
        LAMMPS("hertz {kn}", "tsuji limit_damping"), .until = 20260731),
    ROW(LAMMPS_HERTZ_TSUJI_2026, OF_LAMMPS_SOURCE, "granular hertz, damping tsuji, source after July 2026", "e", TSUJI,
        ZERO_OVERLAP, ASKED(tsuji_since_2026, 0, 1),
        "Within 0.002 for e of 0.05 and above; coeff_restitution is exact.", NO_LINES, .since = 20260801),
    ROW(LAMMPS_HOOKE_TSUJI, OF_LAMMPS_RUN, "granular hooke, damping tsuji, releases to July 2026", "e", LINEAR,
        ZERO_OVERLAP, ASKED(tsuji_on_hooke_until_2026, 0, 1),
        "LAMMPS uses a formula for Hertz's force on a linear spring; damping velocity is exact.",
        LAMMPS("hooke {K}", "tsuji"), .until = 20260731),
    ROW(LAMMPS_HOOKE_TSUJI_2026, OF_LAMMPS_SOURCE, "granular hooke, damping tsuji, source after July 2026", "e", LINEAR,
        ZERO_OVERLAP, ASKED(tsuji_on_hooke_since_2026, 0, 1),
        "LAMMPS uses a formula for Hertz's force on a linear spring, which differs from that in older releases; "
        "coeff_restitution is exact.",
        LAMMPS("hooke {K}", "tsuji"), .since = 20260801),
};

static const struct cor_simulator_model liggghts[] = {
    ROW(LIGGGHTS_HOOKE_GAMMAN, OF_LIGGGHTS("normal_model_hooke_stiffness.h"), "hooke/stiffness, gamman", "gamman, 1/s",
        LINEAR, ZERO_OVERLAP, SCALED(DASHPOT_PER_MASS), "Exact.",
        LIGGGHTS("hooke/stiffness", "", LIGGGHTS_STIFFNESS("{K[]}"))),
    ROW(LIGGGHTS_HOOKE_GAMMAN_LIMIT, OF_LIGGGHTS("normal_model_hooke_stiffness.h"),
        "hooke/stiffness, gamman, limitForce on", "gamman, 1/s", LINEAR, ZERO_FORCE, SCALED(DASHPOT_PER_MASS), "Exact.",
        LIGGGHTS("hooke/stiffness", " limitForce on", LIGGGHTS_STIFFNESS("{K[]}"))),
    ROW(LIGGGHTS_RESTITUTION, OF_LIGGGHTS("normal_model_hertz.h"), "hertz or hooke, coefficientRestitution", "e", TSUJI,
        ZERO_OVERLAP, ASKED(exact_at_zero_overlap, 0.05, 1), "Exact; LIGGGHTS refuses e <= 0.05.",
        LIGGGHTS("{model}", "", LIGGGHTS_E), .any_spring = 1),
    ROW(LIGGGHTS_RESTITUTION_LIMIT, OF_LIGGGHTS("normal_model_hertz.h"),
        "hertz or hooke, coefficientRestitution, limitForce on", "e", TSUJI, ZERO_FORCE,
        ASKED(exact_at_zero_overlap, 0.05, 1),
        "LIGGGHTS computes its damping for contacts that end at zero overlap. These end at zero force: eps is above e.",
        LIGGGHTS("{model}", " limitForce on", LIGGGHTS_E), .any_spring = 1),
    ROW(LIGGGHTS_HERTZ_GAMMAN, OF_LIGGGHTS("normal_model_hertz_stiffness.h"), "hertz/stiffness, gamman",
        "gamman, 1/(m s)", VISCOELASTIC, ZERO_OVERLAP, SCALED(AREA_HERTZ), SPHERE("gamman"),
        LIGGGHTS("hertz/stiffness", "", LIGGGHTS_STIFFNESS("{kn[]}"))),
    ROW(LIGGGHTS_HERTZ_GAMMAN_LIMIT, OF_LIGGGHTS("normal_model_hertz_stiffness.h"),
        "hertz/stiffness, gamman, limitForce on", "gamman, 1/(m s)", VISCOELASTIC, ZERO_FORCE, SCALED(AREA_HERTZ),
        SPHERE("gamman"), LIGGGHTS("hertz/stiffness", " limitForce on", LIGGGHTS_STIFFNESS("{kn[]}"))),
};

static const struct cor_simulator_model yade[] = {
    ROW(YADE_BETAN, OF_YADE("HertzMindlin.cpp"), "Mindlin, betan", "betan", TSUJI, ZERO_FORCE, SCALED(TANGENT_RATIO),
        "Exact.", YADE_MINDLIN("betan", "betas=0")),
    ROW(YADE_EN, OF_YADE("HertzMindlin.cpp"), "Mindlin, en (2023 and later)", "e", TSUJI, ZERO_FORCE,
        ASKED(thornton_yade, 0.001, 1), "Within 0.0003 for 0.02 < e < 0.9; for larger e set betan.",
        YADE_MINDLIN("en", "es=1"), .since = 20230200),
    ROW(YADE_EN_UNTIL_2023, OF("pkg/dem/HertzMindlin.cpp", "source", "before 2023.02a; SudoDEM 6666937"),
        "Mindlin, en (before 2023); SudoDEM", "e", TSUJI, ZERO_FORCE, ASKED(exact_at_zero_overlap, OPEN, 1),
        "YADE realises more than its e; betan is exact.", NO_LINES),
    ROW(YADE_EN_VN, OF("pkg/dem/HertzMindlin.cpp", "run", "2025.2.0"), "Mindlin, en at vn = 1 m/s (2025)", "en",
        VISCOELASTIC, ZERO_FORCE, NUMBER(yade_en_of_damping, damping_of_yade_en),
        "The viscoelastic sphere: en is the Padé approximant of eps at vn, and A holds at every speed.",
        YADE_MINDLIN("en", "vn=1.0"), .since = 20250200),
    ROW(YADE_KN_CN, OF_YADE("ViscoelasticPM.cpp"), "ViscElMat, kn and cn", "cn of each of two equal bodies, kg/s",
        LINEAR, ZERO_FORCE, SCALED(PAIR_DASHPOT), "For two equal bodies K = kn/2, because their springs act in series.",
        YADE(EVERYWHERE,
             "cor_material = ViscElMat({density}kn={2K}, cn={n}, ks={2kt}, cs={2ct}, frictionAngle={phi})\n",
             "Ip2_ViscElMat_ViscElMat_ViscElPhys()", "Law2_ScGeom_ViscElPhys_Basic()")),
    ROW(YADE_TC_EN, OF_YADE("ViscoelasticPM.cpp"), "ViscElMat, tc and en", "e", LINEAR, ZERO_FORCE,
        ASKED(exact_at_zero_overlap, OPEN, 1),
        "YADE realises more than its en, and its contacts are shorter than tc; kn and cn are exact.",
        /* at a wall YADE uses half of these kn and cn */
        YADE(PAIRS, "cor_material = ViscElMat({density}tc={tc}, en={n}, et={et}, frictionAngle={phi})\n",
             "Ip2_ViscElMat_ViscElMat_ViscElPhys()", "Law2_ScGeom_ViscElPhys_Basic()")),
    ROW(YADE_YOUNG_EN, OF_YADE("ViscoelasticPM.cpp"), "ViscElMat, young and en", "e", LINEAR, ZERO_FORCE,
        ASKED(exact_at_zero_force, OPEN, 1), "Exact between spheres; YADE solves for cn.", NO_LINES),
};

static const struct cor_simulator_model mercurydpm[] = {
    ROW(MERCURYDPM_LINEAR, OF_MERCURYDPM("LinearViscoelasticNormalSpecies.cc"),
        "LinearViscoelastic, setStiffnessAndRestitutionCoefficient", "e", LINEAR, ZERO_OVERLAP,
        ASKED(exact_at_zero_overlap, 0, 1),
        "Exact if the mass is the mass of one particle. With e = 0 the particles never part.",
        EVERYWHERE(MERCURYDPM_DENSITY
                   "species->setStiffnessAndRestitutionCoefficient({K}, {n}, {2m});\n" MERCURYDPM_FRICTION),
        .mass = COR_MASS_IN_LINES),
    ROW(MERCURYDPM_HERTZIAN, OF_MERCURYDPM("HertzianViscoelasticNormalSpecies.cc"),
        "HertzianViscoelastic, setEffectiveElasticModulusAndRestitutionCoefficient", "e", TSUJI, ZERO_OVERLAP,
        ASKED(exact_at_zero_overlap, OPEN, 1), "Exact.",
        EVERYWHERE(MERCURYDPM_DENSITY "species->setEffectiveElasticModulusAndRestitutionCoefficient({E}, {n});\n"),
        MERCURYDPM_MANY("HertzianViscoelastic",
                        "ccor_{contact}->setEffectiveElasticModulusAndRestitutionCoefficient({E}, {n});\n")),
    ROW(MERCURYDPM_HERTZIAN_DISSIPATION, OF_MERCURYDPM("HertzianViscoelasticNormalSpecies.cc"),
        "HertzianViscoelastic, dissipation", "dissipation", TSUJI, ZERO_OVERLAP, SCALED(TSUJI_BETA), "Exact.",
        EVERYWHERE(MERCURYDPM_DENSITY "species->setEffectiveElasticModulus({E});\n"
                                      "species->setDissipation({n});\n"),
        MERCURYDPM_MANY("HertzianViscoelastic", MERCURYDPM_DISSIPATION)),
    ROW(MERCURYDPM_BSHP, OF_MERCURYDPM("HertzianBSHPViscoelasticNormalSpecies.cc"), "HertzianBSHPViscoelastic",
        "dissipation A, s", VISCOELASTIC, ZERO_FORCE, SCALED(DISSIPATION_TIME),
        "The viscoelastic sphere: A holds at every speed.",
        EVERYWHERE(MERCURYDPM_DENSITY "species->setEffectiveElasticModulus({E});\n"
                                      "species->setDissipation({n});\n"),
        MERCURYDPM_MANY("HertzianBSHPViscoelastic", MERCURYDPM_DISSIPATION)),
};

/* Chrono combines two materials' numbers by a strategy. Here the numbers are types; the strategy looks up the pair. */
#define CHRONO_PAIRS(what, number, numbers)                                                                            \
    "-    float Combine" what "(float i, float j) const override\n-    {\n"                                            \
    "-        static const float pair[] = {\n-            " numbers "\n-        };\n"                                  \
    "-        return i < 1 || j < 1 ? 0 : pair[((int)i - 1) * {types} + (int)j - 1]; // Set" number "(type)\n-    }\n"
#define CHRONO_MANY(properties, law, pairs, numbers)                                                                   \
    .many = "-system.UseMaterialProperties(" properties ");\n"                                                         \
            "-system.SetContactForceModel(ChSystemSMC::ContactForceModel::" law ");\n"                                 \
            "-struct cor_pairs : ChContactMaterialCompositionStrategy {\n" pairs                                       \
            "-};\n-system.SetMaterialCompositionStrategy(std::make_unique<cor_pairs>());\n"                            \
            "mauto cor_{i} = chrono_types::make_shared<ChContactMaterialSMC>();\n" numbers                             \
            "-// the body of a wall needs a mass far above the masses of the balls, even if the body is fixed\n"
static const struct cor_simulator_model chrono[] = {
    ROW(CHRONO_MATERIAL, OF_CHRONO, "SMC, Hooke or Hertz from material, cr", "e", TSUJI, ZERO_FORCE,
        ASKED(exact_at_zero_overlap, 2.220446049250313e-16, 1 - 2.220446049250313e-16),
        "Chrono computes its damping for contacts that end at zero overlap. These end at zero force: eps is above cr.",
        PAIRS("system.UseMaterialProperties(true);\n"
              "system.SetContactForceModel(ChSystemSMC::ContactForceModel::{Model});\n"
              "material->SetRestitution({n});\n"),
        CHRONO_MANY("true", "Hertz", CHRONO_PAIRS("Restitution", "Restitution", "{n[,]}"),
                    "mcor_{i}->SetYoungModulus({young});\nmcor_{i}->SetPoissonRatio({poisson});\n"
                    "mcor_{i}->SetRestitution({i});\n"),
        .any_spring = 1),
    ROW(CHRONO_HOOKE, OF_CHRONO, "SMC Hooke, kn and gn", "gn, 1/s", LINEAR, ZERO_FORCE, SCALED(DASHPOT_PER_MASS),
        "Exact.",
        PAIRS("system.UseMaterialProperties(false);\n"
              "system.SetContactForceModel(ChSystemSMC::ContactForceModel::Hooke);\n"
              "material->SetKn({K});\n"
              "material->SetGn({n});\n")),
    ROW(CHRONO_HERTZ, OF_CHRONO, "SMC Hertz, kn and gn", "gn, 1/s per m", VISCOELASTIC, ZERO_FORCE,
        SCALED(CHRONO_HERTZ), "K is kn R. The viscoelastic sphere: one gn for every speed.",
        PAIRS("// Type::BULLET uses this R for every contact; Type::MULTICORE computes R of each pair of spheres\n"
              "ChCollisionInfo::SetDefaultEffectiveCurvatureRadius({R});\n"
              "system.UseMaterialProperties(false);\n"
              "system.SetContactForceModel(ChSystemSMC::ContactForceModel::Hertz);\n"
              "material->SetKn({K/R});\n"
              "material->SetGn({n});\n"),
        CHRONO_MANY("false", "Hertz",
                    CHRONO_PAIRS("StiffnessCoefficient", "Kn", "{K[,]}")
                        CHRONO_PAIRS("DampingCoefficient", "Gn", "{nR[,]}"),
                    "mcor_{i}->SetKn({i});\nmcor_{i}->SetGn({i});\nmcor_{i}->SetKt(0);\nmcor_{i}->SetGt(0);\n"
                    "-// the collision system Type::BULLET uses this radius for every contact; K = kn R\n"
                    "-ChCollisionInfo::SetDefaultEffectiveCurvatureRadius(1);\n")),
};

static const struct cor_simulator_model chrono_multicore[] = {
    ROW(CHRONO_MULTICORE_FLORES, OF("src/chrono_multicore/physics", "source", "source 7689fbc0"),
        "Flores, cr, at the characteristic speed", "e", HUNT_CROSSLEY, ZERO_FORCE, ASKED(cor_flores_beta, 0.01, 1),
        "Realises less than its cr at that speed.", NO_LINES),
};

static const struct cor_simulator_model mfix[] = {
    ROW(MFIX_LSD, OF_MFIX, "DEM, LSD", "e", LINEAR, ZERO_OVERLAP, ASKED(exact_at_zero_overlap, 0, 1),
        "Exact. With e = 0 the particles never part.",
        BOTH("DES_COLL_MODEL = 'LSD'\n"
             "KN = {K}\n"
             "DES_EN_INPUT(1) = {n}\n",
             "DES_COLL_MODEL = 'LSD'\n"
             "KN_W = {K}\n"
             "DES_EN_WALL_INPUT(1) = {n}\n")),
    ROW(MFIX_HERTZIAN, OF_MFIX, "DEM, HERTZIAN", "e", TSUJI, ZERO_OVERLAP, ASKED(mfix_hertz, 0, 1),
        "MFiX uses the formula of a linear spring for Hertz's force: eps is above e.",
        BOTH("DES_COLL_MODEL = 'HERTZIAN'\n"
             "DES_EN_INPUT(1) = {n}\n",
             "DES_COLL_MODEL = 'HERTZIAN'\n"
             "DES_EN_WALL_INPUT(1) = {n}\n"),
        .many = "-DES_COLL_MODEL = 'HERTZIAN'\n"
                "bE_YOUNG({i}) = {young}\nbV_POISSON({i}) = {poisson}\nvEW_YOUNG = {young}\nvVW_POISSON = {poisson}\n"
                "pDES_EN_INPUT({k}) = {n}\nwDES_EN_WALL_INPUT({i}) = {n}\n"),
};

static const struct cor_simulator_model openfoam[] = {
    ROW(OPENFOAM_PAIR,
        OF("src/lagrangian/intermediate/submodels/Kinematic/CollisionModel/PairCollision", "source", "source 446e5777"),
        "pairSpringSliderDashpot, b = 1.5", "alpha", TSUJI, ZERO_OVERLAP, SCALED(TSUJI_BETA),
        "The usual alpha, 0.12, gives e = 0.84465.",
        BOTH("pairModel pairSpringSliderDashpot;\n"
             "pairSpringSliderDashpotCoeffs\n"
             "{\n"
             "    useEquivalentSize no;\n" OPENFOAM_NUMBERS,
             "wallModel wallSpringSliderDashpot;\n"
             "wallSpringSliderDashpotCoeffs\n"
             "{\n"
             "    useEquivalentSize no;\n"
             "?    youngsModulus {young2};\n"
             "?    poissonsRatio {poisson2};\n" OPENFOAM_NUMBERS)),
};

static const struct cor_simulator_model kratos[] = {
    ROW(KRATOS_HERTZ, OF_KRATOS("python_scripts"), "DEM Hertz, COEFFICIENT_OF_RESTITUTION", "e", TSUJI, ZERO_FORCE,
        ASKED(thornton_kratos, 0, 1),
        "For e above 0.9 set DAMPING_GAMMA instead; with e above 0.999 nothing is damped.", NO_LINES),
    ROW(KRATOS_HERTZ_GAMMA, OF_KRATOS("custom_constitutive"), "DEM Hertz, DAMPING_GAMMA", "DAMPING_GAMMA", TSUJI,
        ZERO_FORCE, SCALED(TANGENT_RATIO), "Exact.", NO_LINES),
    ROW(KRATOS_LINEAR, OF_KRATOS("python_scripts"), "DEM linear, COEFFICIENT_OF_RESTITUTION", "e", LINEAR, ZERO_FORCE,
        ASKED(kratos_linear, 0, 1),
        "Kratos solves the exact formula for gamma to 0.0001: at e = 0.99 the loss is wrong by some percent.",
        NO_LINES),
    ROW(KRATOS_LINEAR_GAMMA, OF_KRATOS("custom_constitutive"), "DEM linear, DAMPING_GAMMA", "DAMPING_GAMMA", LINEAR,
        ZERO_FORCE, SCALED(DAMPING), "Exact.", NO_LINES),
};

static const struct cor_simulator_model granulars_jl[] = {
    ROW(GRANULARS_EN, OF("src", "source", "source 32b1cfd"), "en", "e", TSUJI, ZERO_FORCE, ASKED(thornton, 0, 1),
        "Within 0.0003 for 0.02 < e < 0.9; for larger e set gamma.", NO_LINES),
};

static const struct cor_simulator_model esys_particle[] = {
    ROW(ESYS_HERTZIAN, OF_ESYS_PARTICLE, "HertzianViscoElastic", "A, s", VISCOELASTIC, ZERO_FORCE,
        SCALED(DISSIPATION_TIME_ESYS), "The parameter A is 3/2 times the dissipation time.",
        PAIRS("HertzianViscoElasticPrms(name=\"contact\", A={n}, E={youngpair}, nu={poisson})\n")),
    ROW(ESYS_HERTZ_MINDLIN, OF_ESYS_PARTICLE, "HertzMindlinVisco, COR", "e", TSUJI, ZERO_OVERLAP, ASKED(esys, OPEN, 1),
        "Correct to 1e-8.",
        PAIRS("HertzMindlinViscoPrms(name=\"contact\", youngsModulus={E}, poissonsRatio={poisson}, dynamicMu=0, "
              "restitution={n})\n")),
};

static const struct cor_simulator_model dem_engine[] = {
    ROW(DEM_ENGINE_HERTZ, OF("src/DEM/DEMModelSnippets", "source", "source a1dc2312"), "full Hertz model, CoR", "e",
        TSUJI, ZERO_OVERLAP, ASKED(exact_at_zero_overlap, OPEN, 1),
        "Exact; for two materials use SetMaterialPropertyPair.",
        PAIRS("auto cor_material = DEMSim.LoadMaterial({\n"
              "    {\n        \"E\", {youngpair}}, {\n        \"nu\", {poisson}}, {\n        \"CoR\", {n}}, {\n"
              "        \"mu\", 0.0f}, {\n        \"Crr\", 0.0f}});\n")),
};

static const struct cor_simulator_model exadem[] = {
    ROW(EXADEM_DAMP_RATE, OF("src/contact", "source", "source 0d0dc656"), "damp_rate", "damp_rate", LINEAR, ZERO_FORCE,
        SCALED(DAMPING), "Exact.",
        PAIRS("-- contact_sphere:\n    symetric: true\n    config: {\n"
              "      kn: {K}, kt: 0, kr: 0, mu: 0, damp_rate: {n} }\n")),
};

static const struct cor_simulator_model mujoco[] = {
    ROW(MUJOCO_TIME_CONSTANT, OF_MUJOCO, "solref (timeconst, dampratio), dmin = dmax", "dampratio", LINEAR, ZERO_FORCE,
        SCALED(DAMPING), "The default, 1, realises exp(-2) = 0.1353. Use time steps up to timeconst/2.",
        EVERYWHERE("<default><geom solref=\"{timeconst} {n}\" solimp=\"0.99 0.99 0.001\" condim=\"1\"/></default>\n")),
    ROW(MUJOCO_STIFFNESS, OF_MUJOCO, "solref (-stiffness, -damping), dmin = dmax", "damping, 1/s", LINEAR, ZERO_FORCE,
        SCALED(DASHPOT_PER_MASS), "Stiffness and damping are per unit of mass.",
        EVERYWHERE("<default><geom solref=\"-{K/m} -{n}\" solimp=\"0.99 0.99 0.001\" condim=\"1\"/></default>\n"),
        .mass = COR_MASS_PER_UNIT),
};

static const struct cor_simulator_model newton[] = {
    ROW(NEWTON_SEMI_IMPLICIT, OF("newton/_src/solvers/semi_implicit/kernels_contact.py", "source", "source 41a5392c"),
        "SolverSemiImplicit, Featherstone; warp example_dem", "kd, kg/s", LINEAR, APPROACH_ONLY, SCALED(DASHPOT),
        "The damper acts only while the bodies approach.",
        EVERYWHERE("cor_shape = newton.ModelBuilder.ShapeConfig(ke={K}, kd={n}, kf=0.0, mu=0.0) # of both shapes\n"
                   "# particles: model.particle_ke = {K}; model.particle_kd = {n}; model.particle_kf = 0.0\n")),
};

static const struct cor_simulator_model drake[] = {
    ROW(DRAKE_HUNT_CROSSLEY, OF_DRAKE("plant"), "point contact or hydroelastic, hunt_crossley_dissipation",
        "d of the pair, s/m", HUNT_CROSSLEY, ZERO_FORCE, SCALED(CROSSLEY_PER_SPEED),
        "d holds at one speed. The rebound speed is at most 1/d.",
        EVERYWHERE("<drake:proximity_properties>\n"
                   "  <drake:hunt_crossley_dissipation>{n}</drake:hunt_crossley_dissipation>\n"
                   "</drake:proximity_properties>\n")),
    ROW(DRAKE_SAP, OF_DRAKE("contact_solvers"), "SAP, relaxation_time", "tau of the pair, s", LINEAR, ZERO_FORCE,
        SCALED(RELAXATION_TIME), "This eps is the limit of short time steps. The default of each body is 0.1 s.",
        EVERYWHERE("<drake:proximity_properties>\n"
                   "  <drake:point_contact_stiffness>{2K}</drake:point_contact_stiffness>\n"
                   "  <drake:relaxation_time>{n/2}</drake:relaxation_time>\n"
                   "</drake:proximity_properties>\n")),
};

static const struct cor_simulator_model simbody[] = {
    ROW(SIMBODY_HUNT_CROSSLEY, OF("Simbody/src/HuntCrossleyForce.cpp", "run", "3.7, source f312d0dd"),
        "HuntCrossleyForce; OpenSim", "c, s/m", HUNT_CROSSLEY, ZERO_FORCE, SCALED(SIMBODY),
        "e = 1 - c v holds only to first order: at c v = 0.5, eps is 0.663.",
        EVERYWHERE("?const double stiffness = {simbody}; // Pa, of both bodies\n"
                   "const double dissipation = {n}; // s/m, of both bodies\n"
                   "force.setBodyParameters(surface, stiffness, dissipation, 0, 0, 0);\n")),
};

static const struct cor_simulator_model opensees[] = {
    ROW(OPENSEES_HERTZ_DAMP, OF("HertzDamp material", "documentation", "its documentation of 2026"), "HertzDamp, xi",
        "xi", HUNT_CROSSLEY, ZERO_FORCE, SCALED(DAMPING), "The recommended 8 (1 - e)/(5 e) realises less than e.",
        NO_LINES),
};

/* Planes, boxes and other shapes have contact points before they touch; Bullet's solver then acts across the gap. */
#define BULLET_TOUCH "body->setContactProcessingThreshold(0); // of one of two bodies: no force before they touch\n"
static const struct cor_simulator_model bullet[] = {
    ROW(BULLET_RESTITUTION, OF_BULLET("BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.cpp"),
        "setRestitution of both bodies, product e", "e", IMPULSE, INSTANT, ASKED(loss_of_impulse, 0, 1),
        "Exact for spheres with these lines. With Bullet's defaults eps is up to 0.2 above e, and 0 below 0.2 m/s.",
        EVERYWHERE("body->setRestitution({root}); // each of two equal bodies\n" BULLET_TOUCH
                   "world->getSolverInfo().m_restitutionVelocityThreshold = 0;\n"
                   "world->getSolverInfo().m_splitImpulsePenetrationThreshold = 0;\n")),
    ROW(BULLET_CALLBACK, OF_BULLET("BulletCollision/CollisionDispatch/btManifoldResult.cpp"),
        "contact callback, e of the impact speed", "e", IMPULSE, INSTANT, ASKED(loss_of_impulse, 0, 1),
        "Any law: eps of each impact is computed from its speed.",
        EVERYWHERE(
            "// cor_eps.h: {embed}\n"
            "#include \"cor_eps.h\"\n"
            "static bool cor_contact_added(btManifoldPoint &p, const btCollisionObjectWrapper *a, int, int,\n"
            "                              const btCollisionObjectWrapper *b, int, int)\n"
            "{\n"
            "    const btRigidBody *first = btRigidBody::upcast(a->getCollisionObject());\n"
            "    const btRigidBody *second = btRigidBody::upcast(b->getCollisionObject());\n"
            "    btVector3 v(0, 0, 0);\n"
            "    if (first)\n"
            "        v += first->getVelocityInLocalPoint(p.getPositionWorldOnA() - first->getCenterOfMassPosition());\n"
            "    if (second)\n"
            "        v -= second->getVelocityInLocalPoint(p.getPositionWorldOnB() - "
            "second->getCenterOfMassPosition());\n"
            "    p.m_combinedRestitution = cor_eps(btFabs(v.dot(p.m_normalWorldOnB)));\n"
            "    return true;\n"
            "}\n"
            "// once: gContactAddedCallback = cor_contact_added;\n"
            "// world->getSolverInfo().m_restitutionVelocityThreshold = 0;\n"
            "// world->getSolverInfo().m_splitImpulsePenetrationThreshold = 0;\n"
            "// each body: body->setCollisionFlags(body->getCollisionFlags() | "
            "btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);\n"
            "// each body: body->setContactProcessingThreshold(0);\n"),
        .has_function = 1),
    ROW(BULLET_STIFFNESS, OF_BULLET("BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.cpp"),
        "setContactStiffnessAndDamping", "damping of the pair, kg/s", LINEAR, ZERO_FORCE, SCALED(DASHPOT),
        IMPLICIT " If a face touches at four points, K and damping act four times.",
        EVERYWHERE("body->setContactStiffnessAndDamping({2K}, {n/2}); // each of two bodies, or of a body and a "
                   "wall\n" BULLET_TOUCH)),
};

static const struct cor_simulator_model gazebo[] = {
    ROW(GAZEBO_BOUNCE, OF("gazebo/physics/ode/ODEPhysics.cc", "source", "gazebo 11"), "ODE, restitution_coefficient",
        "e", IMPULSE, INSTANT, ASKED(loss_of_impulse, 0, 1),
        "Gazebo uses the smaller e of both bodies. eps is 0 up to the smaller threshold, by default 100000 m/s.",
        NO_LINES),
    ROW(GAZEBO_KP_KD, OF("gazebo/physics/ode/ODEPhysics.cc", "source", "gazebo 11"),
        "ODE, kp and kd; soft_erp, soft_cfm", "kd of the pair, kg/s", LINEAR, ZERO_FORCE, SCALED(DASHPOT), IMPLICIT,
        EVERYWHERE("<surface><contact><ode> <!-- of both collisions; ODE puts kp in series and adds kd -->\n"
                   "  <kp>{2K}</kp><kd>{n/2}</kd><min_depth>0</min_depth><max_vel>1e6</max_vel>\n"
                   "</ode></contact></surface>\n"
                   "?<!-- ODE without Gazebo, at the step {dt} s: soft_erp = {erp}, soft_cfm = {cfm} -->\n")),
};

#define PHYSX_TGS                                                                                                      \
    " This holds for ePGS. eTGS divides the step: with 50 steps in a contact, eps was within 0.02 of the limit."
static const struct cor_simulator_model physx[] = {
    ROW(PHYSX_COMPLIANT, OF("lowleveldynamics/src/DyContactPrepShared.h", "run", "5.6.1"), "compliant contact",
        "damping, kg/s", LINEAR, ZERO_FORCE, SCALED(DASHPOT), IMPLICIT PHYSX_TGS,
        EVERYWHERE("material->setRestitution(-{K}); // of both bodies; up to PhysX 5.3 with eCOMPLIANT_CONTACT\n"
                   "material->setDamping({n});\n"
                   "shape->setContactOffset(1e-9f); // of both bodies: no force before they touch\n"
                   "body->setSolverIterationCounts(4, 0); // of both: eTGS damps more with velocity iterations\n")),
};

static const struct cor_simulator_model isaac[] = {
    ROW(ISAAC_COMPLIANT, OF("PhysxMaterialAPI", "documentation", "its USD schema of 2026"), "compliant contact",
        "compliantContactDamping, kg/s", LINEAR, ZERO_FORCE, SCALED(DASHPOT), IMPLICIT PHYSX_TGS,
        EVERYWHERE(
            "cor_material = PhysxSchema.PhysxMaterialAPI.Apply(material.GetPrim()) # of both bodies\n"
            "cor_material.CreateCompliantContactAccelerationSpringAttr().Set(False)\n"
            "cor_material.CreateCompliantContactStiffnessAttr().Set({K})\n"
            "cor_material.CreateCompliantContactDampingAttr().Set({n})\n"
            "# of both bodies: no force before they touch; TGS damps more with velocity iterations\n"
            "PhysxSchema.PhysxCollisionAPI.Apply(collider.GetPrim()).CreateContactOffsetAttr().Set(1e-9)\n"
            "PhysxSchema.PhysxRigidBodyAPI.Apply(body.GetPrim()).CreateSolverVelocityIterationCountAttr().Set(0)\n")),
};

static const struct cor_simulator_model lethe[] = {
    ROW(LETHE_RESTITUTION, OF("particle_particle_contact_force.h", "source", "source of 2023"),
        "hertz_mindlin_limit_overlap or linear, restitution coefficient", "e", TSUJI, ZERO_OVERLAP,
        ASKED(exact_at_zero_overlap, OPEN, 1), "Exact; Lethe uses the harmonic mean of the e of two materials.",
        NO_LINES, .any_spring = 1),
};

static const struct cor_simulator_model pfc[] = {
    ROW(PFC_LINEAR, OF("linear model", "documentation", "its documentation of PFC 5 and later"), "linear, dp_nratio",
        "dp_nratio", LINEAR, ZERO_OVERLAP, SCALED(DAMPING), "Exact; with dp_mode 1 and 3 contacts end at zero force.",
        PFC("0")),
    ROW(PFC_LINEAR_PUSHES, OF("linear model", "documentation", "its documentation of PFC 5 and later"),
        "linear, dp_nratio, dp_mode 1", "dp_nratio", LINEAR, ZERO_FORCE, SCALED(DAMPING), "Exact.", PFC("1")),
};

static const struct cor_simulator_model edem[] = {
    ROW(EDEM_HERTZ, OF("Hertz-Mindlin (no slip)", "documentation", "its documentation of 2025"),
        "Hertz-Mindlin (no slip), coefficient of restitution", "e", TSUJI, ZERO_OVERLAP,
        ASKED(exact_at_zero_overlap, OPEN, 1), "Exact, if the force may be attractive, as in the documented formula.",
        EVERYWHERE("Coefficient of Restitution: {n}\n")),
};

/* MATLAB's variables for the block Translational Hard Stop */
#define SIMSCAPE(rebound)                                                                                              \
    EVERYWHERE("% Hard stop model: Full stiffness and damping applied at bounds, " rebound "\n"                        \
               "cor_stiffness = {K}; % contact stiffness at the bound, N/m\n"                                          \
               "cor_damping = {n}; % contact damping at the bound, N/(m/s)\n")
static const struct cor_simulator_model simscape[] = {
    ROW(SIMSCAPE_DAMPED, OF("Translational Hard Stop", "documentation", "its documentation of 2026"),
        "hard stop, damped rebound", "damping, kg/s", LINEAR, ZERO_OVERLAP, SCALED(DASHPOT),
        "The force is attractive before the bodies part.", SIMSCAPE("damped rebound")),
    ROW(SIMSCAPE_UNDAMPED, OF("Translational Hard Stop", "documentation", "its documentation of 2026"),
        "hard stop, undamped rebound", "damping, kg/s", LINEAR, APPROACH_ONLY, SCALED(DASHPOT),
        "The damper acts only while the bodies approach.", SIMSCAPE("undamped rebound")),
};

static const struct cor_simulator_model rebound[] = {
    ROW(REBOUND_CONSTANT, OF("src/collision.c", "source", "5.0.0"), "coefficient_of_restitution, constant", "e",
        IMPULSE, INSTANT, ASKED(loss_of_impulse, 0, 1), "Exact for hard spheres.",
        PAIRS("static double cor_restitution(const struct reb_simulation *const r, double v)\n"
              "{\n"
              "    return {n};\n"
              "}\n"
              "// once: r->coefficient_of_restitution = cor_restitution;\n")),
    ROW(REBOUND_CALLBACK, OF("src/collision.c", "run", "5.0.0"), "coefficient_of_restitution, e of the impact speed",
        "e", IMPULSE, INSTANT, ASKED(loss_of_impulse, 0, 1), "Any law: eps of each impact is computed from its speed.",
        PAIRS("// cor_eps.h: {embed}\n"
              "#include \"cor_eps.h\"\n"
              "static double cor_restitution(const struct reb_simulation *const r, double v)\n"
              "{\n"
              "    return cor_eps(v < 0 ? -v : v); // cor_eps takes m/s: convert v from the units of the simulation\n"
              "}\n"
              "// once: r->coefficient_of_restitution = cor_restitution;\n"),
        .has_function = 1),
};

static const struct cor_simulator_model modelica[] = {
    ROW(MODELICA_LINEAR, OF_MODELICA, "ElastoGap, n = 1", "d, kg/s", LINEAR, LIMITED, SCALED(DASHPOT),
        "The damping force is at most the spring force.",
        EVERYWHERE("Modelica.Mechanics.Translational.Components.ElastoGap gap(c={K}, d={n}, n=1, s_rel0=0);\n")),
    ROW(MODELICA_HERTZ, OF_MODELICA, "ElastoGap, n = 1.5", "d, kg/s", HERTZ_DASHPOT, LIMITED, SCALED(HERTZ_VELOCITY),
        "The damping force is at most the spring force; slow impacts lose more.",
        EVERYWHERE("Modelica.Mechanics.Translational.Components.ElastoGap gap(c={K}, d={n}, n=1.5, s_rel0=0);\n")),
};

#define BIT(id) 1U << COR_##id
const struct cor_simulator cor_simulators[] = {
    {SIMULATOR(lammps, "lammps", "LAMMPS", VERLET_HALF_STEP), SCRIPT,
     .setup = "Use with: units si, atom_style sphere, newton off, comm_modify vel yes." FRICTION,
     .time_step = "timestep {dt}\n", .version = "29 Sep 2021", .packaged = 20210929,
     .tangential = BIT(LAMMPS_MINDLIN) | BIT(LAMMPS_MINDLIN_FORCE) | BIT(LAMMPS_MINDLIN_RESCALE) |
                   BIT(LAMMPS_MINDLIN_RESCALE_FORCE) | BIT(LAMMPS_LINEAR_HISTORY) | BIT(LAMMPS_LINEAR_NOHISTORY),
     .yielding = "LAMMPS of 2025 and later has the model mdr, with E, nu and the yield stress. It has another yield "
                 "criterion, and therefore another eps. cor has not run it."},
    {SIMULATOR(liggghts, "liggghts", "LIGGGHTS", VERLET_HALF_STEP), SCRIPT,
     .setup = "Use with: units si, atom_style granular, newton off, communicate single vel yes, {types} type{s} in "
              "create_box." FRICTION,
     .time_step = "timestep {dt}\n", .version = "3.8.0", .packaged = 30800, .tangential = BIT(LIGGGHTS_HISTORY),
     .luding = "LIGGGHTS, luding",
     .luding_lines = "pair_style gran model luding tangential history\n" LUDING("0", "LoadingStiffness", "{k1[]}")
         LUDING("1", "UnloadingStiffness", "{kp/k1[]}") LUDING("2", "coefficientAdhesionStiffness", "{0[]}")
             LUDING("3", "coefficientPlasticityDepth", "{depth[]}") LUDING("4", "pullOffForce", "{0[]}")
                 LUDING("5", "coefficientRestitution", "{1[]}")},
    {SIMULATOR(yade, "yade", "YADE", LEAPFROG), SCRIPT,
     .setup = "SI units. cor_contact is one of O.engines; NewtonIntegrator has damping=0." FRICTION,
     .time_step = "O.dt = {dt}\n", .version = "2023.02", .packaged = 20230200,
     .tangential = BIT(YADE_HERTZ_MINDLIN) | BIT(YADE_VISCEL) | BIT(YADE_CUNDALL_STRACK),
     .wall_divides = 1.4142135623730951,
     .wall = "In YADE walls have the stiffness K/sqrt(2) and facets K sqrt(2/3), with Hertz's K: contacts last longer.",
     .density = "cor_material has YADE's default density, 1000 kg/m^3: add the density of your bodies.",
     .luding = "YADE, LudingMat",
     .luding_lines = "cor_material = LudingMat(frictionAngle=0, {density}" YADE_LUDING
                     "?cor_material_2 = LudingMat(frictionAngle=0, {density2}" YADE_LUDING
                     "cor_contact = InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], "
                     "[Ip2_LudingMat_LudingMat_LudingPhys()], [Law2_ScGeom_LudingPhys_Basic()])\n"},
    {SIMULATOR(mercurydpm, "mercurydpm", "MercuryDPM", VERLET_HALF_STEP), CPP, .setup = "SI units.",
     .tangential = BIT(MERCURYDPM_SLIDING_FRICTION), .time_step = "setTimeStep({dt});\n"},
    {SIMULATOR(chrono, "chrono", "Chrono", SYMPLECTIC_EULER), CPP, .setup = "SI units.",
     .time_step = "const double time_step = {dt}; // s, for DoStepDynamics\n"},
    {SIMULATOR(chrono_multicore, "chrono-multicore", "chrono-multicore", NO_INTEGRATOR)},
    {SIMULATOR(mfix, "mfix", "MFiX", SYMPLECTIC_EULER), COMMENT("! ", ""),
     .setup = "UNITS = 'SI'; MFiX chooses its time step.", .one_wall = 1},
    {SIMULATOR(openfoam, "openfoam", "OpenFOAM", VERLET_HALF_STEP), CPP, .setup = "SI units." FRICTION},
    {SIMULATOR(kratos, "kratos", "kratos", SYMPLECTIC_EULER)},
    {SIMULATOR(granulars_jl, "granulars.jl", "granulars.jl", NO_INTEGRATOR)},
    {SIMULATOR(esys_particle, "esys-particle", "ESyS-Particle", SYMPLECTIC_EULER), SCRIPT,
     .setup = "SI units." FRICTION, .time_step = "sim.setTimeStepSize({dt})\n"},
    {SIMULATOR(dem_engine, "dem-engine", "DEM-Engine", NO_INTEGRATOR), CPP, .setup = "SI units." FRICTION},
    {SIMULATOR(exadem, "exadem", "exaDEM", NO_INTEGRATOR), SCRIPT, .setup = "SI units." FRICTION},
    {SIMULATOR(mujoco, "mujoco", "MuJoCo", SYMPLECTIC_EULER), XML,
     .setup = "Units of the model: m, kg, s. Put these lines into <mujoco>." FRICTION,
     .time_step = "<option timestep=\"{dt}\"/>\n", .version = "2.2.2", .packaged = 20202},
    {SIMULATOR(newton, "newton", "Newton", SYMPLECTIC_EULER), SCRIPT, .setup = "SI units." FRICTION,
     .time_step = "cor_dt = {dt} # s, of a substep\n"},
    {SIMULATOR(drake, "drake", "Drake", NO_INTEGRATOR), XML, .setup = "SI units."},
    {SIMULATOR(simbody, "simbody", "Simbody", NO_INTEGRATOR), CPP,
     .setup = "SI units." FRICTION " The integrator chooses the time step.", .version = "3.7", .packaged = 30700},
    {SIMULATOR(opensees, "opensees", "opensees", NO_INTEGRATOR)},
    {SIMULATOR(bullet, "bullet", "Bullet", IMPLICIT_EULER), CPP, .setup = "SI units.", .version = "3.24",
     .packaged = 32400},
    {SIMULATOR(gazebo, "gazebo", "Gazebo", IMPLICIT_EULER), XML,
     .setup = "SI units. Put these lines into <collision>."},
    {SIMULATOR(physx, "physx", "PhysX", IMPLICIT_EULER), CPP, .setup = "SI units."},
    {SIMULATOR(isaac, "isaac", "Isaac Sim", IMPLICIT_EULER), SCRIPT, .setup = "Units of the stage: m, kg, s."},
    {SIMULATOR(lethe, "lethe", "lethe", SYMPLECTIC_EULER)},
    {SIMULATOR(pfc, "pfc", "PFC", VERLET_HALF_STEP), COMMENT("; ", ""), .setup = "SI units.",
     .time_step = "model mechanical timestep fix {dt}\n"},
    {SIMULATOR(edem, "edem", "EDEM", NO_INTEGRATOR), SCRIPT, .setup = "Set this number in the interaction in Physics."},
    {SIMULATOR(simscape, "simscape", "Simscape", NO_INTEGRATOR), COMMENT("% ", ""),
     .setup = "SI units. The solver chooses the time step."},
    {SIMULATOR(rebound, "rebound", "REBOUND", NO_INTEGRATOR), CPP, .setup = "cor_eps takes m/s."},
    {SIMULATOR(modelica, "modelica", "Modelica", NO_INTEGRATOR), CPP,
     .setup = "SI units. The integrator chooses the time step."},
};
const size_t cor_simulator_count = sizeof cor_simulators / sizeof *cor_simulators;

/* ---- results from the table ---- */

const struct cor_simulator *cor_simulator_of(enum cor_simulator_model_id id)
{
    for (size_t i = 0; i < cor_simulator_count; i++)
        for (int k = 0; k < cor_simulators[i].model_count; k++)
            if (cor_simulators[i].models[k].id == id)
                return &cor_simulators[i];
    return NULL;
}

const struct cor_simulator_model *cor_simulator_model(enum cor_simulator_model_id id)
{
    const struct cor_simulator *const simulator = cor_simulator_of(id);
    for (int k = 0; simulator && k < simulator->model_count; k++)
        if (simulator->models[k].id == id)
            return &simulator->models[k];
    return NULL;
}

static double closed_form(enum cor_law law, enum cor_end end, enum cor_quantity quantity, double x)
{
    const int has_one = law == COR_LAW_LINEAR || law == COR_LAW_TSUJI || law == COR_LAW_HUNT_CROSSLEY;
    return law == COR_LAW_IMPULSE ? 1 - x : has_one ? cor_law_value(law, end, quantity, x) : (double)NAN;
}

double cor_law_eps(enum cor_law law, enum cor_end end, double damping)
{
    return closed_form(law, end, COR_EPS, damping);
}

double cor_law_damping(enum cor_law law, enum cor_end end, double eps)
{
    return closed_form(law, end, COR_DAMPING_OF_EPS, eps);
}

double cor_simulator_realised(const struct cor_simulator_model *model, double e)
{
    if (!model->damping_of_e || !(isgreaterequal(e, model->least) && e <= model->most))
        return NAN;
    return cor_law_eps(model->law, model->end, model->damping_of_e(e));
}

static double mujoco_impedance(const double solimp[5], double overlap)
{
    const double y = fmin(fabs(overlap) / solimp[2], 1), middle = solimp[3], power = solimp[4];
    const double rise =
        y < middle ? pow(y / middle, power) * middle : 1 - pow((1 - y) / (1 - middle), power) * (1 - middle);
    return solimp[0] + (solimp[1] - solimp[0]) * rise;
}

double cor_mujoco_eps(const double solimp[5], double softness, double frequency, double zeta, double speed_m_s,
                      double gravity_m_s2)
{
    enum { MOST = 200000 };
    static const double weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}, part[4] = {0.5, 0.5, 1, 0};
    const double positive[] = {frequency, speed_m_s, solimp[2], softness}, others[] = {zeta, gravity_m_s2};
    int sound = cor_inline_between(solimp[0], 0, 2) && isgreaterequal(1, solimp[0]) && isgreater(solimp[1], 0) &&
                isgreaterequal(1, solimp[1]) && isgreater(solimp[3], 0) && isless(solimp[3], 1) &&
                isgreaterequal(solimp[4], 1) && isgreaterequal(100, solimp[4]);
    for (int i = 0; i < 4; i++)
        sound = sound && isgreaterequal(positive[i], 1e-48) && isgreaterequal(1e48, positive[i]);
    for (int i = 0; i < 2; i++)
        sound = sound && isgreaterequal(others[i], 0) && isgreaterequal(1e48, others[i]);
    if (!sound)
        return NAN;
    const double h = fmin(fmin(2e-3, 0.1 / fmax(zeta, 1e-9)) / frequency, 0.02 * solimp[2] / speed_m_s);
    double x = 0, v = speed_m_s;
    for (int n = 0; n < MOST; n++) {
        double at = x, rate = v, moved = 0, gained = 0;
        for (int k = 0; k < 4; k++) {
            const double d = mujoco_impedance(solimp, at), hard = d / (d + softness * (1 - d)), top = solimp[1];
            const double reference = hard / top * frequency * (2 * zeta * rate + d / top * frequency * at);
            if (k == 0 && n > 0 && !(reference + hard * gravity_m_s2 > 0 && x > 0)) {
                const double square = v < 0 ? v * v - 2 * gravity_m_s2 * fmax(x, 0) : 0;
                return square > 0 ? fmin(sqrt(square) / speed_m_s, 1) : 0;
            }
            const double change = reference - (1 - hard) * gravity_m_s2;
            moved += weight[k] * h * rate;
            gained -= weight[k] * h * change;
            at = x + part[k] * h * rate;
            rate = v - part[k] * h * change;
        }
        x += moved;
        v += gained;
    }
    return NAN;
}

/* Returns the smallest positive damping, and sets *at to its e. Near e = 1 some fits are not monotonic, or give 0. */
static double weakest_damping(const struct cor_simulator_model *model, double *at)
{
    const double most = nextafter(model->most, 0);
    double least = INFINITY;
    *at = most;
    for (int k = 0; k <= 2000; k++) {
        const double e = most - (most - model->least) * 0.1 * k / 2000, damping = model->damping_of_e(e);
        if (damping > 0 && damping < least) {
            least = damping;
            *at = e;
        }
    }
    return least;
}

void cor_simulator_reach(const struct cor_simulator_model *model, double *least, double *most)
{
    double at;
    *least = *most = NAN;
    if (!model->damping_of_e)
        return;
    *least = cor_simulator_realised(model, model->least);
    *most = cor_law_eps(model->law, model->end, weakest_damping(model, &at));
}

double cor_simulator_e(const struct cor_simulator_model *model, double requested, enum cor_simulator_status *status)
{
    const double damping = cor_law_damping(model->law, model->end, requested);
    double low = model->least, high;
    *status = COR_SIMULATOR_NOT_ASKED;
    if (!model->damping_of_e || isnan(damping))
        return NAN;
    const int none = damping == model->damping_of_e(model->most);
    *status = none                                      ? COR_SIMULATOR_OK
              : damping < weakest_damping(model, &high) ? COR_SIMULATOR_TOO_LARGE
              : damping > model->damping_of_e(low)      ? COR_SIMULATOR_TOO_SMALL
                                                        : COR_SIMULATOR_OK;
    if (none || *status != COR_SIMULATOR_OK)
        return none ? model->most : (double)NAN;
    for (double middle; cor_halve(&middle, low, high);)
        *(model->damping_of_e(middle) > damping ? &low : &high) = middle;
    return high;
}

/* ---- the numbers of a model for a contact ---- */

int cor_simulator_has_law(const struct cor_simulator_model *model, const struct cor_scene_contact *contact)
{
    const struct cor_exponents *const law = &contact->law;
    if (contact->plastic)
        return model->law == COR_LAW_IMPULSE && model->has_function;
    if (model->law == COR_LAW_IMPULSE)
        return !(cor_law_is_constant(law) && contact->force_n > 0) && cor_law_is_constant(law) != model->has_function;
    if (model->law == COR_LAW_HUNT_CROSSLEY)
        return cor_law_is_hunt_crossley(law);
    return (cor_law_is_same(law, &cor_law_exponents[model->law]) &&
            (model->law != COR_LAW_VISCOELASTIC || cor_scene_has_end(contact, (int)model->end))) ||
           (cor_law_is(law, 2, 0) && model->any_spring);
}

/* True if the law of the model has a closed form and the same spring as the contact. */
int cor_simulator_has_one_eps(const struct cor_simulator_model *model, const struct cor_scene_contact *contact)
{
    return model->law == COR_LAW_IMPULSE ? !model->has_function
           : model->law == COR_LAW_TSUJI ? model->damping_of_e || cor_law_is_hertz(&contact->law)
                                         : model->law == COR_LAW_HUNT_CROSSLEY ||
                                               (model->law == COR_LAW_LINEAR && cor_law_is(&contact->law, 2, 0));
}

/* Returns the speed at which numbers are converted. If the model has the contact's law, the speed has no effect. */
static double speed_of(const struct cor_simulator_target *target)
{
    return isnan(target->speed_m_s) ? 1 : target->speed_m_s;
}

static double exact_damping(const struct cor_simulator_model *model, const struct cor_simulator_target *target,
                            int same_law)
{
    const struct cor_scene_contact *contact = target->contacts;
    const int constant = cor_law_is_constant(&contact->law),
              given = cor_scene_given(target->scene, COR_SCENE_RESTITUTION);
    const int end = (int)model->end, has_end = end == COR_END_ZERO_OVERLAP || end == COR_END_ZERO_FORCE;
    const int pressed = cor_scene_given(target->scene, COR_SCENE_GRAVITY) &&
                        (!same_law || cor_scene_given(target->scene, COR_SCENE_AT));
    /* If eps was given without an end, the model has this eps at its own end. */
    const int own_end = given && target->scene->end == COR_BOTH_ENDS && !pressed;
    if (model->law == COR_LAW_IMPULSE || (!same_law && !pressed) || (constant && own_end))
        return cor_law_damping(model->law, model->end, target->eps);
    if (!same_law) { /* target->eps holds at target->speed_m_s, under gravity */
        struct cor_scene_contact c = cor_model_contact(*contact, &cor_law_exponents[model->law], 0, 1);
        return has_end && cor_law_has_spring_of(&c.law, &contact->law) &&
                       cor_scene_set_damping(&c, COR_SCENE_RESTITUTION, target->eps, target->speed_m_s, end) == 0
                   ? (cor_law_is_constant(&c.law) ? c.damping : cor_scene_beta(&c, target->speed_m_s))
                   : (double)NAN;
    }
    if (target->count > 1 && !has_end)
        return NAN;
    contact += target->count > 1 ? end : 0;
    return constant ? contact->damping : cor_scene_beta(contact, speed_of(target));
}

double cor_simulator_damping(const struct cor_simulator_model *model, const struct cor_simulator_target *target,
                             int same_law)
{
    if (!cor_is_moderate(target->contacts, target->speed_m_s))
        return NAN;
    const double damping = exact_damping(model, target, same_law);
    return isgreater(target->steps, 0) ? cor_simulator_step_damping(model, target, same_law, damping) : damping;
}

double cor_simulator_number(const struct cor_simulator_model *model, const struct cor_simulator_target *target,
                            int same_law, enum cor_simulator_status *status)
{
    const double damping = cor_simulator_damping(model, target, same_law);
    *status = COR_SIMULATOR_OK;
    if (model->has_function)
        return 1; /* the lines of such a model have no number */
    if (isnan(damping)) {
        *status = COR_SIMULATOR_NO_CLOSED_FORM;
        return NAN;
    }
    if (!model->number_of_damping)
        return cor_simulator_e(model, cor_law_eps(model->law, model->end, damping), status);
    const double number = isless(damping, 1e100) || cor_is_infinity(damping)
                              ? model->number_of_damping(model, damping, target->contacts, speed_of(target))
                              : (double)NAN;
    if (isnan(number))
        *status = COR_SIMULATOR_NO_SCALES;
    return number;
}
