/* SPDX-License-Identifier: MIT */
#include "hosts/hosts.h"

#include <math.h>

#include "cor/law.h"

/* ---- the damping that hosts compute from e ---- */

/* This formula is exact at zero overlap. LIGGGHTS, Chrono, MercuryDPM and others use it for every end of contact. */
static double exact_at_zero_overlap(double e)
{
    return cor_linear_zeta_zero_overlap(e);
}

double host_thornton_gamma(double e)
{
    static const double h[] = {-6.918798, -16.41105, 146.8049,  -796.4559, 2928.711,
                               -7206.864, 11494.29,  -11342.18, 6276.757,  -1489.915};
    double sum = 0;
    for (int k = 9; k >= 0; k--)
        sum = e * (h[k] + sum);
    return sqrt(1 / (1 - (1 + e) * (1 + e) * exp(sum)) - 1);
}

/* The damping is 2 gamma sqrt(m k), where k = (3/2) K sqrt(x) is the tangent stiffness; zeta = sqrt(6/5) gamma. */
static double thornton(double e)
{
    return sqrt(1.2) * host_thornton_gamma(e);
}

/* YADE: no damping at e = 1 exactly */
static double thornton_yade(double e)
{
    return e == 1 ? 0 : thornton(e);
}

/* Kratos raises e to at least 0.001, and has no damping above 0.999 */
static double thornton_kratos(double e)
{
    return e > 0.999 ? 0 : thornton(e < 0.001 ? 0.001 : e);
}

double host_tsuji_alpha(double e)
{
    return 1.2728 + e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
}

static double tsuji_until_2026(double e)
{
    return host_tsuji_alpha(e) / sqrt(5);
}

static double tsuji_since_2026(double e)
{
    return sqrt(0.4) * host_tsuji_alpha(e);
}

/* the same polynomial on a linear spring */
static double tsuji_on_hooke_until_2026(double e)
{
    return host_tsuji_alpha(e) / 2;
}

static double tsuji_on_hooke_since_2026(double e)
{
    return host_tsuji_alpha(e) / sqrt(2);
}

/* the formula of the linear dashpot, with Hertz's force */
static double mfix_hertz(double e)
{
    return 2 / sqrt(5) * cor_linear_zeta_zero_overlap(e);
}

/* this host has pi with 8 digits */
static double esys(double e)
{
    const double l = log(e), pi = 3.1415927;
    return e == 0 ? 1 : -l / sqrt(pi * pi + l * l);
}

/* Kratos bisects for the root of the zero-force formula between 0 and 16, until the bracket is below 0.0001 */
static double kratos_linear(double e)
{
    const double wanted = e < 0.001 ? 0.001 : e;
    double low = 0, high = 16, gamma = 8;
    if (wanted > 0.999)
        return 0;
    while (high - low > 0.0001) {
        if (cor_linear_eps_zero_force(gamma) > wanted)
            low = gamma;
        else
            high = gamma;
        gamma = 0.5 * (low + high);
    }
    return gamma;
}

double host_crossley_hunt(double e)
{
    return 1.5 * (1 - e);
}

double host_crossley_lankarani(double e)
{
    return 0.75 * (1 - e) * (1 + e);
}

double host_crossley_gonthier(double e)
{
    return (1 - e) * (1 + e) / e;
}

double host_crossley_herbert(double e)
{
    return 6 * (1 - e) / ((2 * e - 1) * (2 * e - 1) + 3);
}

double host_crossley_hu(double e)
{
    return 1.5 * (1 - e) / e;
}

double host_crossley_flores(double e)
{
    return 1.6 * (1 - e) / e;
}

double host_drake_pair_dissipation(double k1, double d1, double k2, double d2)
{
    const double share = isinf(k1) ? 0 : 1 / (1 + k1 / k2); /* k2/(k1 + k2) */
    return share * d1 + (1 - share) * d2;
}

/* ---- numbers from the damping, and back ---- */

#define SCALED(name, factor)                                                                                           \
    static double name##_of_damping(double damping, const struct host_scene *s)                                        \
    {                                                                                                                  \
        (void)s;                                                                                                       \
        return damping * (factor);                                                                                     \
    }                                                                                                                  \
    static double damping_of_##name(double number, const struct host_scene *s)                                         \
    {                                                                                                                  \
        (void)s;                                                                                                       \
        return number / (factor);                                                                                      \
    }

#define M s->mass_kg
#define K s->stiffness
#define R s->radius_m
#define G s->speed_m_s

SCALED(damping_ratio, 1.0)
SCALED(dashpot, 2 * sqrt(K * M))          /* C = 2 zeta sqrt(K m), kg/s */
SCALED(dashpot_per_mass, 2 * sqrt(K / M)) /* C/m, 1/s; per unit of mass */
SCALED(pair_dashpot, 4 * sqrt(K * M))     /* two equal dashpots in series: each has twice C */
SCALED(relaxation_time, 2 * sqrt(M / K))  /* tau of F = k x + k tau x' */
SCALED(tangent_ratio, sqrt(5.0 / 6))      /* gamma of 2 gamma sqrt(m k_tangent) */
SCALED(tsuji_beta, sqrt(5))               /* alpha of alpha sqrt(m K) x^(1/4) x' */
SCALED(crossley_per_speed, 1 / G)         /* d = beta/g, s/m */
SCALED(simbody, 2 / (3 * G))              /* c of (3/2) c x' */
SCALED(crossley_beta, 1.0)
SCALED(area_root, pow(K / M, 0.75) / sqrt(R * G))             /* eta m sqrt(R x) x' on a linear spring */
SCALED(area_hertz, pow(K / M, 0.6) / (sqrt(R) * pow(G, 0.2))) /* the same on Hertz's force */
SCALED(dissipation_time, 2.0 / 3 * pow(M / K, 0.4) / pow(G, 0.2))
SCALED(dissipation_time_esys, pow(M / K, 0.4) / pow(G, 0.2))
SCALED(hertz_velocity, pow(M, 0.6) * pow(K, 0.4) * pow(G, 0.2))
SCALED(hertz_mass_velocity, pow(K / M, 0.4) * pow(G, 0.2))
SCALED(chrono_hertz, pow(K / M, 0.6) / (R * pow(G, 0.2)))

#undef M
#undef K
#undef R
#undef G

/* YADE from 2025 on takes P(sqrt(beta)) as en, where beta is that of the speed vn = 1 m/s, and P the Padé approximant
 * of order [3/6] of eps at zero force (Müller and Pöschel, Phys. Rev. E 84, 021302 (2011)), in v = sqrt(beta). */
static double yade_pade(double v)
{
    static const double above[] = {1, 1.07232, 0.574198, 0.141552};
    static const double below[] = {1, 1.07232, 1.72765, 1.37842, 1.19449, 0.467273, 0.235585};
    double p = 0, q = 0;
    for (int k = 3; k >= 0; k--)
        p = p * v + above[k];
    for (int k = 6; k >= 0; k--)
        q = q * v + below[k];
    return p / q;
}

static double yade_en_of_damping(double damping, const struct host_scene *s)
{
    return yade_pade(sqrt(damping * pow(s->speed_m_s, -0.2)));
}

static double damping_of_yade_en(double en, const struct host_scene *s)
{
    double low = 0, high = 1;
    while (yade_pade(high) > en)
        high *= 2;
    for (int k = 0; k < 200 && nextafter(low, high) < high; k++) {
        const double middle = (low + high) / 2;
        if (yade_pade(middle) > en)
            low = middle;
        else
            high = middle;
    }
    return high * high * pow(s->speed_m_s, 0.2);
}

/* The damping of an impulse is 1 - e. */
static double loss_of_impulse(double e)
{
    return 1 - e;
}

/* ---- the table ---- */

#define ASKED(map, least, most) map, least, most, NULL, NULL
#define NUMBER(name) NULL, 0, 1, name##_of_damping, damping_of_##name
#define NOT_PASTED(version) version, NULL
#define OPEN 0x1p-1022 /* e > 0 */
/* LIGGGHTS asks for these numbers even with tangential off. */
#define LIGGGHTS_TANGENTIAL                                                                                            \
    "fix cor_kt all property/global kt peratomtypepair 1 0\n"                                                          \
    "fix cor_gammat all property/global gammat peratomtypepair 1 0\n"
#define LAMMPS_FILE "src/GRANULAR/gran_sub_mod_damping.cpp"

const struct host_model host_models[] = {
    {"lammps", "granular hooke, damping velocity", "eta_n, kg/s", HOST_LINEAR, HOST_ZERO_OVERLAP, NUMBER(dashpot),
     LAMMPS_FILE, "run", "With limit_damping the contact ends at zero force: use the row below.",
     "29 Sep 2021 to 4 Feb 2025",
     "#|pair_style granular\npair_coeff * * hooke {K} {n} tangential linear_nohistory 0 0 damping velocity\n"},
    {"lammps", "granular hooke, damping velocity, limit_damping", "eta_n, kg/s", HOST_LINEAR, HOST_ZERO_FORCE,
     NUMBER(dashpot), LAMMPS_FILE, "run", "Exact.", "29 Sep 2021 to 4 Feb 2025",
     "#|pair_style granular\npair_coeff * * hooke {K} {n} tangential linear_nohistory 0 0 damping velocity "
     "limit_damping\n"},
    {"lammps", "granular hooke, damping mass_velocity; gran/hooke", "eta_n or gamma_n, 1/s", HOST_LINEAR,
     HOST_ZERO_OVERLAP, NUMBER(dashpot_per_mass), LAMMPS_FILE, "run", "Exact.", "29 Sep 2021 to 4 Feb 2025",
     "#|pair_style granular\npair_coeff * * hooke {K} {n} tangential linear_nohistory 0 0 damping mass_velocity\n"},
    {"lammps", "granular hooke, damping mass_velocity, limit_damping", "eta_n, 1/s", HOST_LINEAR, HOST_ZERO_FORCE,
     NUMBER(dashpot_per_mass), LAMMPS_FILE, "run", "Exact.", "29 Sep 2021 to 4 Feb 2025",
     "#|pair_style granular\npair_coeff * * hooke {K} {n} tangential linear_nohistory 0 0 damping mass_velocity "
     "limit_damping\n"},
    {"lammps", "granular hooke, damping viscoelastic (the default)", "eta_n, 1/(m s)", HOST_LINEAR_ROOT,
     HOST_ZERO_OVERLAP, NUMBER(area_root), LAMMPS_FILE, "run",
     "The restitution depends on the impact speed: the number holds at one speed.", "29 Sep 2021 to 4 Feb 2025",
     "#|pair_style granular\npair_coeff * * hooke {K} {n} tangential linear_nohistory 0 0 damping viscoelastic\n"},
    {"lammps", "granular hertz, damping viscoelastic (the default); gran/hertz/history", "eta_n, 1/(m s)", HOST_SPHERE,
     HOST_ZERO_OVERLAP, NUMBER(area_hertz), LAMMPS_FILE, "run",
     "The viscoelastic sphere: eta_n = (3/2) A k_n/m for every speed.", "29 Sep 2021 to 4 Feb 2025",
     "#|pair_style granular\npair_coeff * * hertz {kn} {n} tangential linear_nohistory 0 0 damping viscoelastic\n"},
    {"lammps", "granular hertz, damping viscoelastic, limit_damping", "eta_n, 1/(m s)", HOST_SPHERE, HOST_ZERO_FORCE,
     NUMBER(area_hertz), LAMMPS_FILE, "run", "The viscoelastic sphere: eta_n = (3/2) A k_n/m for every speed.",
     "29 Sep 2021 to 4 Feb 2025",
     "#|pair_style granular\npair_coeff * * hertz {kn} {n} tangential linear_nohistory 0 0 damping viscoelastic "
     "limit_damping\n"},
    {"lammps", "granular hertz, damping velocity", "eta_n, kg/s", HOST_HERTZ_DASHPOT, HOST_ZERO_OVERLAP,
     NUMBER(hertz_velocity), LAMMPS_FILE, "run",
     "Slow impacts lose more, and below a threshold speed the bodies never part: use limit_damping.",
     "29 Sep 2021 to 4 Feb 2025",
     "#|pair_style granular\npair_coeff * * hertz {kn} {n} tangential linear_nohistory 0 0 damping velocity\n"},
    {"lammps", "granular hertz, damping mass_velocity", "eta_n, 1/s", HOST_HERTZ_DASHPOT, HOST_ZERO_OVERLAP,
     NUMBER(hertz_mass_velocity), LAMMPS_FILE, "run",
     "Slow impacts lose more, and below a threshold speed the bodies never part: use limit_damping.",
     "29 Sep 2021 to 4 Feb 2025",
     "#|pair_style granular\npair_coeff * * hertz {kn} {n} tangential linear_nohistory 0 0 damping mass_velocity\n"},
    {"lammps", "granular hertz or hooke, damping coeff_restitution", "e", HOST_TSUJI, HOST_ZERO_OVERLAP,
     ASKED(exact_at_zero_overlap, OPEN, 1), LAMMPS_FILE, "source", "Exact.", "source 07b704ca, 2026",
     "#|pair_style granular\npair_coeff * * {spring} {n} tangential linear_nohistory 0 0 damping coeff_restitution\n"},
    {"lammps", "granular hertz or hooke, damping coeff_restitution, limit_damping", "e", HOST_TSUJI, HOST_ZERO_FORCE,
     ASKED(exact_at_zero_overlap, OPEN, 1), LAMMPS_FILE, "source", "Realises more than asked: give it e'.",
     "source 07b704ca, 2026",
     "#|pair_style granular\npair_coeff * * {spring} {n} tangential linear_nohistory 0 0 damping coeff_restitution "
     "limit_damping\n"},
    {"lammps", "granular hertz, damping tsuji, releases to July 2026", "e", HOST_TSUJI, HOST_ZERO_OVERLAP,
     ASKED(tsuji_until_2026, 0, 1), LAMMPS_FILE, "run",
     "Realises up to 0.143 more than asked: give it e', or use coeff_restitution.", "29 Sep 2021 to 4 Feb 2025",
     "#|pair_style granular\npair_coeff * * hertz {kn} {n} tangential linear_nohistory 0 0 damping tsuji\n"},
    {"lammps", "granular hertz, damping tsuji, limit_damping, releases to July 2026", "e", HOST_TSUJI, HOST_ZERO_FORCE,
     ASKED(tsuji_until_2026, 0, 1), LAMMPS_FILE, "run",
     "Realises up to 0.25 more than asked: give it e', or use coeff_restitution with its own e'.",
     "29 Sep 2021 to 4 Feb 2025",
     "#|pair_style granular\npair_coeff * * hertz {kn} {n} tangential linear_nohistory 0 0 damping tsuji "
     "limit_damping\n"},
    {"lammps", "granular hertz, damping tsuji, source after July 2026", "e", HOST_TSUJI, HOST_ZERO_OVERLAP,
     ASKED(tsuji_since_2026, 0, 1), LAMMPS_FILE, "source", "Within 0.002 from e = 0.05 on; coeff_restitution is exact.",
     NOT_PASTED("source 07b704ca, 2026")},
    {"lammps", "granular hooke, damping tsuji, releases to July 2026", "e", HOST_LINEAR, HOST_ZERO_OVERLAP,
     ASKED(tsuji_on_hooke_until_2026, 0, 1), LAMMPS_FILE, "run",
     "A formula for Hertz's force on a linear spring: give it e', or use damping velocity.",
     "29 Sep 2021 to 4 Feb 2025",
     "#|pair_style granular\npair_coeff * * hooke {K} {n} tangential linear_nohistory 0 0 damping tsuji\n"},
    {"lammps", "granular hooke, damping tsuji, source after July 2026", "e", HOST_LINEAR, HOST_ZERO_OVERLAP,
     ASKED(tsuji_on_hooke_since_2026, 0, 1), LAMMPS_FILE, "source",
     "A formula for Hertz's force on a linear spring: give it e', which differs from that of older releases, or use "
     "coeff_restitution.",
     "source 07b704ca, 2026",
     "#|pair_style granular\npair_coeff * * hooke {K} {n} tangential linear_nohistory 0 0 damping tsuji\n"},
    {"liggghts", "hertz or hooke, coefficientRestitution", "e", HOST_TSUJI, HOST_ZERO_OVERLAP,
     ASKED(exact_at_zero_overlap, 0.05, 1), "src/normal_model_hertz.h", "run", "Exact; it refuses e <= 0.05.",
     "3.8, source 3d5c00f2",
     "#|pair_style gran model {model} tangential off\nfix cor_e all property/global coefficientRestitution "
     "peratomtypepair 1 {n}\n"},
    {"liggghts", "hertz or hooke, coefficientRestitution, limitForce on", "e", HOST_TSUJI, HOST_ZERO_FORCE,
     ASKED(exact_at_zero_overlap, 0.05, 1), "src/normal_model_hertz.h", "run",
     "Realises more than asked: give it e'; it refuses e' <= 0.05.", "3.8, source 3d5c00f2",
     "#|pair_style gran model {model} tangential off limitForce on\nfix cor_e all property/global "
     "coefficientRestitution peratomtypepair 1 {n}\n"},
    {"liggghts", "hertz/stiffness, gamman", "gamman, 1/(m s)", HOST_SPHERE, HOST_ZERO_OVERLAP, NUMBER(area_hertz),
     "src/normal_model_hertz_stiffness.h", "run", "The viscoelastic sphere: gamman = (3/2) A k_n/m for every speed.",
     "3.8, source 3d5c00f2",
     "#|pair_style gran model hertz/stiffness tangential off\nfix cor_kn all property/global kn peratomtypepair 1 "
     "{kn}\nfix cor_gamman all property/global gamman peratomtypepair 1 {n}\n" LIGGGHTS_TANGENTIAL},
    {"liggghts", "hertz/stiffness, gamman, limitForce on", "gamman, 1/(m s)", HOST_SPHERE, HOST_ZERO_FORCE,
     NUMBER(area_hertz), "src/normal_model_hertz_stiffness.h", "run",
     "The viscoelastic sphere: gamman = (3/2) A k_n/m for every speed.", "3.8, source 3d5c00f2",
     "#|pair_style gran model hertz/stiffness tangential off limitForce on\nfix cor_kn all property/global kn "
     "peratomtypepair 1 {kn}\nfix cor_gamman all property/global gamman peratomtypepair 1 {n}\n" LIGGGHTS_TANGENTIAL},
    {"liggghts", "hooke/stiffness, gamman", "gamman, 1/s", HOST_LINEAR, HOST_ZERO_OVERLAP, NUMBER(dashpot_per_mass),
     "src/normal_model_hooke_stiffness.h", "run", "Exact.", "3.8, source 3d5c00f2",
     "#|pair_style gran model hooke/stiffness tangential off\nfix cor_kn all property/global kn peratomtypepair 1 "
     "{K}\nfix cor_gamman all property/global gamman peratomtypepair 1 {n}\n" LIGGGHTS_TANGENTIAL},
    {"liggghts", "hooke/stiffness, gamman, limitForce on", "gamman, 1/s", HOST_LINEAR, HOST_ZERO_FORCE,
     NUMBER(dashpot_per_mass), "src/normal_model_hooke_stiffness.h", "run", "Exact.", "3.8, source 3d5c00f2",
     "#|pair_style gran model hooke/stiffness tangential off limitForce on\nfix cor_kn all property/global kn "
     "peratomtypepair 1 {K}\nfix cor_gamman all property/global gamman peratomtypepair 1 {n}\n" LIGGGHTS_TANGENTIAL},
    {"yade", "Mindlin, en (2023 and later)", "e", HOST_TSUJI, HOST_ZERO_FORCE, ASKED(thornton_yade, 0.001, 1),
     "pkg/dem/HertzMindlin.cpp", "run", "Within 0.0003 for 0.02 < e < 0.9; above, set betan instead.", "2023.02a",
     "#|Ip2_FrictMat_FrictMat_MindlinPhys(en={n}, es=1)\n"},
    {"yade", "Mindlin, en (before 2023); SudoDEM", "e", HOST_TSUJI, HOST_ZERO_FORCE,
     ASKED(exact_at_zero_overlap, OPEN, 1), "pkg/dem/HertzMindlin.cpp", "source",
     "Realises more than asked: give it e', or set betan.", NOT_PASTED("before 2023.02a; SudoDEM 6666937")},
    {"yade", "Mindlin, betan", "betan", HOST_TSUJI, HOST_ZERO_FORCE, NUMBER(tangent_ratio), "pkg/dem/HertzMindlin.cpp",
     "run", "Exact.", "2023.02a", "#|Ip2_FrictMat_FrictMat_MindlinPhys(betan={n}, betas=0)\n"},
    {"yade", "Mindlin, en at vn = 1 m/s (2025)", "en", HOST_SPHERE, HOST_ZERO_FORCE, NUMBER(yade_en),
     "pkg/dem/HertzMindlin.cpp", "run",
     "The viscoelastic sphere: en is the Padé approximant of eps at vn, and A holds at every speed.", "2025.2.0",
     "#|Ip2_FrictMat_FrictMat_MindlinPhys(en={n}, vn=1.0)\n"},
    {"yade", "ViscElMat, tc and en", "e", HOST_LINEAR, HOST_ZERO_FORCE, ASKED(exact_at_zero_overlap, OPEN, 1),
     "pkg/dem/ViscoelasticPM.cpp", "run", "Realises more than asked: give it e'. The contact is shorter than tc.",
     "2023.02a", "#|ViscElMat(tc={tc}, en={n}, et=1)\n"},
    {"yade", "ViscElMat, kn and cn", "cn of each of two equal bodies, kg/s", HOST_LINEAR, HOST_ZERO_FORCE,
     NUMBER(pair_dashpot), "pkg/dem/ViscoelasticPM.cpp", "run",
     "K is kn/2 of two equal bodies: the numbers of two bodies are in series.", "2023.02a",
     "#|ViscElMat(kn={2K}, cn={n}, ks=0, cs=0)\n"},
    {"mercurydpm", "LinearViscoelastic, setStiffnessAndRestitutionCoefficient", "e", HOST_LINEAR, HOST_ZERO_OVERLAP,
     ASKED(exact_at_zero_overlap, 0, 1), "Kernel/Species/NormalForceSpecies/LinearViscoelasticNormalSpecies.cc",
     "source", "Exact, with the mass of one particle; e = 0 sticks for ever.", "source fb0ebf1d",
     "//|species->setStiffnessAndRestitutionCoefficient({K}, {n}, {2m});\n"},
    {"mercurydpm", "HertzianViscoelastic, setEffectiveElasticModulusAndRestitutionCoefficient", "e", HOST_TSUJI,
     HOST_ZERO_OVERLAP, ASKED(exact_at_zero_overlap, OPEN, 1),
     "Kernel/Species/NormalForceSpecies/HertzianViscoelasticNormalSpecies.cc", "source", "Exact.", "source fb0ebf1d",
     "//|species->setEffectiveElasticModulusAndRestitutionCoefficient({E}, {n});\n"},
    {"mercurydpm", "HertzianViscoelastic, dissipation", "dissipation", HOST_TSUJI, HOST_ZERO_OVERLAP,
     NUMBER(tsuji_beta), "Kernel/Species/NormalForceSpecies/HertzianViscoelasticNormalSpecies.cc", "source", "Exact.",
     "source fb0ebf1d", "//|species->setEffectiveElasticModulus({E});\nspecies->setDissipation({n});\n"},
    {"mercurydpm", "HertzianBSHPViscoelastic", "dissipation A, s", HOST_SPHERE, HOST_ZERO_FORCE,
     NUMBER(dissipation_time), "Kernel/Species/NormalForceSpecies/HertzianBSHPViscoelasticNormalSpecies.cc", "source",
     "The viscoelastic sphere: A holds at every speed.", "source fb0ebf1d",
     "//|species->setEffectiveElasticModulus({E});\nspecies->setDissipation({n});\n"},
    {"chrono", "SMC, Hooke or Hertz from material, cr", "e", HOST_TSUJI, HOST_ZERO_FORCE,
     ASKED(exact_at_zero_overlap, 2.220446049250313e-16, 1 - 2.220446049250313e-16),
     "src/chrono/physics/ChContactSMC.cpp", "source", "Realises more than asked: give it e'.", "source 7689fbc0",
     "//"
     "|system.UseMaterialProperties(true);\nsystem.SetContactForceModel(ChSystemSMC::ContactForceModel::{Model});"
     "\nmaterial->SetRestitution({n});\n"},
    {"chrono", "SMC Hooke, kn and gn", "gn, 1/s", HOST_LINEAR, HOST_ZERO_FORCE, NUMBER(dashpot_per_mass),
     "src/chrono/physics/ChContactSMC.cpp", "source", "Exact.", "source 7689fbc0",
     "//"
     "|system.UseMaterialProperties(false);\nsystem.SetContactForceModel(ChSystemSMC::ContactForceModel::Hooke);"
     "\nmaterial->SetKn({K});\nmaterial->SetGn({n});\n"},
    {"chrono", "SMC Hertz, kn and gn", "gn, 1/s per m", HOST_SPHERE, HOST_ZERO_FORCE, NUMBER(chrono_hertz),
     "src/chrono/physics/ChContactSMC.cpp", "source", "K is kn R. The viscoelastic sphere: one gn for every speed.",
     "source 7689fbc0",
     "//"
     "|// Type::BULLET finds no R and takes this one for every contact; Type::MULTICORE finds that of each pair of "
     "spheres"
     "\nChCollisionInfo::SetDefaultEffectiveCurvatureRadius({R});\n"
     "system.UseMaterialProperties(false);\nsystem.SetContactForceModel(ChSystemSMC::ContactForceModel::Hertz);"
     "\nmaterial->SetKn({K/R});\nmaterial->SetGn({n});\n"},
    {"chrono-multicore", "Flores, cr, at the characteristic speed", "e", HOST_HUNT_CROSSLEY, HOST_ZERO_FORCE,
     ASKED(host_crossley_flores, 0.01, 1), "src/chrono_multicore/physics", "source",
     "Realises less than asked, at that speed: give it e'.", NOT_PASTED("source 7689fbc0")},
    {"mfix", "DEM, LSD", "e", HOST_LINEAR, HOST_ZERO_OVERLAP, ASKED(exact_at_zero_overlap, 0, 1),
     "model/check_data/check_solids_dem.f", "source", "Exact; e = 0 sticks for ever.", "21.3.2",
     "!|DES_COLL_MODEL = 'LSD'\nKN = {K}\nDES_EN_INPUT(1) = {n}\n"},
    {"mfix", "DEM, HERTZIAN", "e", HOST_TSUJI, HOST_ZERO_OVERLAP, ASKED(mfix_hertz, 0, 1),
     "model/check_data/check_solids_dem.f", "source", "The linear formula on Hertz's force: give it e'.", "21.3.2",
     "!|DES_COLL_MODEL = 'HERTZIAN'\nDES_EN_INPUT(1) = {n}\n"},
    {"openfoam", "pairSpringSliderDashpot, b = 1.5", "alpha", HOST_TSUJI, HOST_ZERO_OVERLAP, NUMBER(tsuji_beta),
     "src/lagrangian/intermediate/submodels/Kinematic/CollisionModel/PairCollision", "source",
     "The usual alpha = 0.12 is e = 0.84465.", "source 446e5777",
     "//|pairModel pairSpringSliderDashpot;\npairSpringSliderDashpotCoeffs\n{\n    useEquivalentSize no;\n    alpha "
     "{n};\n    b 1.5;\n    mu 0;\n    cohesionEnergyDensity 0;\n    collisionResolutionSteps 12;\n}\n"},
    {"kratos", "DEM Hertz, COEFFICIENT_OF_RESTITUTION", "e", HOST_TSUJI, HOST_ZERO_FORCE, ASKED(thornton_kratos, 0, 1),
     "applications/DEMApplication/python_scripts", "source",
     "Above 0.9 set DAMPING_GAMMA instead; above 0.999 nothing is damped.", NOT_PASTED("source 03f57bf0")},
    {"kratos", "DEM Hertz, DAMPING_GAMMA", "DAMPING_GAMMA", HOST_TSUJI, HOST_ZERO_FORCE, NUMBER(tangent_ratio),
     "applications/DEMApplication/custom_constitutive", "source", "Exact.", NOT_PASTED("source 03f57bf0")},
    {"kratos", "DEM linear, COEFFICIENT_OF_RESTITUTION", "e", HOST_LINEAR, HOST_ZERO_FORCE, ASKED(kratos_linear, 0, 1),
     "applications/DEMApplication/python_scripts", "source",
     "The exact formula, bisected to 0.0001 in gamma: at e = 0.99 the loss is off by some percent.",
     NOT_PASTED("source 03f57bf0")},
    {"kratos", "DEM linear, DAMPING_GAMMA", "DAMPING_GAMMA", HOST_LINEAR, HOST_ZERO_FORCE, NUMBER(damping_ratio),
     "applications/DEMApplication/custom_constitutive", "source", "Exact.", NOT_PASTED("source 03f57bf0")},
    {"granulars.jl", "en", "e", HOST_TSUJI, HOST_ZERO_FORCE, ASKED(thornton, 0, 1), "src", "source",
     "Within 0.0003 for 0.02 < e < 0.9; above, set gamma.", NOT_PASTED("source 32b1cfd")},
    {"esys-particle", "HertzianViscoElastic", "A, s", HOST_SPHERE, HOST_ZERO_FORCE, NUMBER(dissipation_time_esys),
     "Model", "source", "Its A is (3/2) of the dissipation time.", "2.3.5",
     "#|HertzianViscoElasticPrms(name=\"contact\", A={n}, E={young}, nu={poisson})\n"},
    {"esys-particle", "HertzMindlinVisco, COR", "e", HOST_TSUJI, HOST_ZERO_OVERLAP, ASKED(esys, OPEN, 1), "Model",
     "source", "Right to 1e-8.", "2.3.5",
     "#|HertzMindlinViscoPrms(name=\"contact\", E={E}, nu={poisson}, dynamicMu=0, COR={n})\n"},
    {"dem-engine", "full Hertz model, CoR", "e", HOST_TSUJI, HOST_ZERO_OVERLAP, ASKED(exact_at_zero_overlap, OPEN, 1),
     "src/DEM/DEMModelSnippets", "source", "Exact.", NOT_PASTED("source a1dc2312")},
    {"exadem", "damp_rate", "damp_rate", HOST_LINEAR, HOST_ZERO_FORCE, NUMBER(damping_ratio), "src/contact", "source",
     "Exact.", NOT_PASTED("source 0d0dc656")},
    {"drake", "point contact or hydroelastic, hunt_crossley_dissipation", "d of the pair, s/m", HOST_HUNT_CROSSLEY,
     HOST_ZERO_FORCE, NUMBER(crossley_per_speed), "multibody/plant", "source",
     "One d holds at one speed; the rebound is never faster than 1/d.", "source be259df7",
     "<!--|<drake:proximity_properties>\n  "
     "<drake:hunt_crossley_dissipation>{n}</drake:hunt_crossley_dissipation>\n</drake:proximity_properties>\n"},
    {"drake", "SAP, relaxation_time", "tau of the pair, s", HOST_LINEAR, HOST_ZERO_FORCE, NUMBER(relaxation_time),
     "multibody/contact_solvers", "source", "As the step goes to zero; 0.1 s each if nothing is set.",
     "source be259df7",
     "<!--|<drake:proximity_properties>\n  <drake:point_contact_stiffness>{2K}</drake:point_contact_stiffness>\n  "
     "<drake:relaxation_time>{n/2}</drake:relaxation_time>\n</drake:proximity_properties>\n"},
    {"simbody", "HuntCrossleyForce; OpenSim", "c, s/m", HOST_HUNT_CROSSLEY, HOST_ZERO_FORCE, NUMBER(simbody),
     "Simbody/src/HuntCrossleyForce.cpp", "run", "e = 1 - c v is first order only: c v = 0.5 gives 0.663.",
     "3.7, source f312d0dd",
     "//|const double dissipation = {n}; // s/m, of both bodies\nforce.setBodyParameters(surface, stiffness, "
     "dissipation, 0, 0, 0);\n"},
    {"mujoco", "solref (timeconst, dampratio), dmin = dmax", "dampratio", HOST_LINEAR, HOST_ZERO_FORCE,
     NUMBER(damping_ratio), "src/engine/engine_core_constraint.c", "run",
     "The default 1 realises exp(-2) = 0.1353; step at most timeconst/2.", "2.2.2, source a7255075",
     "<!--|<geom solref=\"{timeconst} {n}\" solimp=\"0.99 0.99 0.001\" condim=\"1\"/>\n"},
    {"mujoco", "solref (-stiffness, -damping), dmin = dmax", "damping, 1/s", HOST_LINEAR, HOST_ZERO_FORCE,
     NUMBER(dashpot_per_mass), "src/engine/engine_core_constraint.c", "run",
     "Stiffness and damping are per unit of mass.", "2.2.2, source a7255075",
     "<!--|<geom solref=\"-{K/m} -{n}\" solimp=\"0.99 0.99 0.001\" condim=\"1\"/>\n"},
    {"newton", "SolverSemiImplicit, Featherstone; warp example_dem", "kd, kg/s", HOST_LINEAR, HOST_APPROACH_ONLY,
     NUMBER(dashpot), "newton/_src/solvers/semi_implicit/kernels_contact.py", "source",
     "The damper works while the bodies approach only.", NOT_PASTED("source 41a5392c")},
    {"modelica", "ElastoGap, n = 1", "d, kg/s", HOST_LINEAR, HOST_LIMITED, NUMBER(dashpot),
     "Mechanics/Translational/Components/ElastoGap", "source", "The damping force is limited to the spring's.",
     "Modelica Standard Library 4",
     "//|Modelica.Mechanics.Translational.Components.ElastoGap gap(c={K}, d={n}, n=1, s_rel0=0);\n"},
    {"modelica", "ElastoGap, n = 1.5", "d, kg/s", HOST_HERTZ_DASHPOT, HOST_LIMITED, NUMBER(hertz_velocity),
     "Mechanics/Translational/Components/ElastoGap", "source",
     "The damping force is limited to the spring's; slow impacts lose more.", "Modelica Standard Library 4",
     "//|Modelica.Mechanics.Translational.Components.ElastoGap gap(c={K}, d={n}, n=1.5, s_rel0=0);\n"},
    {"opensees", "HertzDamp, xi", "xi", HOST_HUNT_CROSSLEY, HOST_ZERO_FORCE, NUMBER(crossley_beta),
     "HertzDamp material", "documentation", "The recommended 8 (1 - e)/(5 e) realises less than e.",
     NOT_PASTED("its documentation of 2026")},
    {"bullet", "setRestitution of both bodies, product e", "e", HOST_IMPULSE, HOST_INSTANT,
     ASKED(loss_of_impulse, 0, 1), "src/BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.cpp", "run",
     "Exact for spheres with these lines; Bullet's defaults add up to 0.2 to e, and treat impacts below 0.2 m/s as e = "
     "0.",
     "3.24",
     "//|body->setRestitution({root}); // each of two equal "
     "bodies\nworld->getSolverInfo().m_restitutionVelocityThreshold = 0;\n"
     "world->getSolverInfo().m_splitImpulsePenetrationThreshold = 0;\n"},
    {"bullet", "contact callback, e of the impact speed", "e", HOST_IMPULSE, HOST_INSTANT, ASKED(loss_of_impulse, 0, 1),
     "src/BulletCollision/CollisionDispatch/btManifoldResult.cpp", "run",
     "Any law: eps of each impact is computed from its speed.", "3.24",
     "//|// cor_eps.h: {embed}\n#include \"cor_eps.h\"\nstatic bool cor_contact_added(btManifoldPoint &p, const "
     "btCollisionObjectWrapper *a, int, int,\n                              const btCollisionObjectWrapper *b, int, "
     "int)\n{\n    const btRigidBody *first = btRigidBody::upcast(a->getCollisionObject());\n    const btRigidBody "
     "*second = btRigidBody::upcast(b->getCollisionObject());\n    btVector3 v(0, 0, 0);\n    if (first)\n        v += "
     "first->getVelocityInLocalPoint(p.getPositionWorldOnA() - first->getCenterOfMassPosition());\n    if (second)\n   "
     "     v -= second->getVelocityInLocalPoint(p.getPositionWorldOnB() - second->getCenterOfMassPosition());\n    "
     "p.m_combinedRestitution = cor_eps(btFabs(v.dot(p.m_normalWorldOnB)));\n    return true;\n}\n// once: "
     "gContactAddedCallback = cor_contact_added;\n// world->getSolverInfo().m_restitutionVelocityThreshold = 0;\n// "
     "world->getSolverInfo().m_splitImpulsePenetrationThreshold = 0;\n// "
     "each body: body->setCollisionFlags(body->getCollisionFlags() | "
     "btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);\n"},
    {"rebound", "coefficient_of_restitution, constant", "e", HOST_IMPULSE, HOST_INSTANT, ASKED(loss_of_impulse, 0, 1),
     "src/collision.c", "source", "Exact for hard spheres.", "5.0.0",
     "//|static double cor_restitution(const struct reb_simulation *const r, double v)\n{\n    return {n};\n}\n// "
     "once: r->coefficient_of_restitution = cor_restitution;\n"},
    {"rebound", "coefficient_of_restitution, e of the impact speed", "e", HOST_IMPULSE, HOST_INSTANT,
     ASKED(loss_of_impulse, 0, 1), "src/collision.c", "run", "Any law: eps of each impact is computed from its speed.",
     "5.0.0",
     "//|// cor_eps.h: {embed}\n#include \"cor_eps.h\"\nstatic double cor_restitution(const struct reb_simulation "
     "*const r, double v)\n{\n    return cor_eps(v < 0 ? -v : v); // cor_eps takes m/s: convert v from the units of "
     "the "
     "simulation\n}\n// once: r->coefficient_of_restitution = cor_restitution;\n"},
};
const size_t host_model_count = sizeof host_models / sizeof *host_models;

const char *host_law_name(enum host_law law)
{
    static const char *const name[HOST_LAWS] = {"linear",        "tsuji",        "linear spring, dashpot x^(1/2)",
                                                "hertz-dashpot", "viscoelastic", "hunt-crossley",
                                                "impulse"};
    return name[law];
}

const char *host_end_name(enum host_end end)
{
    static const char *const name[HOST_ENDS] = {"zero overlap", "zero force", "limited", "approach only", "an instant"};
    return name[end];
}

/* ---- results from the table ---- */

double host_eps(enum host_law law, enum host_end end, double damping)
{
    static host_map *const ratio[HOST_ENDS] = {cor_linear_eps_zero_overlap, cor_linear_eps_zero_force,
                                               cor_linear_eps_limited, cor_linear_eps_approach_only};
    if (law == HOST_IMPULSE)
        return 1 - damping;
    if (end == HOST_INSTANT)
        return (double)NAN;
    if (law == HOST_LINEAR || law == HOST_TSUJI)
        return ratio[end](damping);
    if (law != HOST_HUNT_CROSSLEY || end == HOST_LIMITED)
        return (double)NAN;
    return end == HOST_APPROACH_ONLY ? cor_hunt_crossley_eps_approach_only(damping) : cor_hunt_crossley_eps(damping);
}

double host_damping(enum host_law law, enum host_end end, double eps)
{
    static host_map *const ratio[HOST_ENDS] = {cor_linear_zeta_zero_overlap, cor_linear_zeta_zero_force,
                                               cor_linear_zeta_limited, cor_linear_zeta_approach_only};
    if (law == HOST_IMPULSE)
        return 1 - eps;
    if (end == HOST_INSTANT)
        return (double)NAN;
    if (law == HOST_LINEAR || law == HOST_TSUJI)
        return ratio[end](eps);
    if (law != HOST_HUNT_CROSSLEY || end == HOST_LIMITED)
        return (double)NAN;
    return end == HOST_APPROACH_ONLY ? cor_hunt_crossley_beta_approach_only(eps) : cor_hunt_crossley_beta(eps);
}

double host_realised(const struct host_model *model, double e)
{
    if (!model->damping_of_e || !(e >= model->least && e <= model->most))
        return (double)NAN;
    return host_eps(model->law, model->end, model->damping_of_e(e));
}

/* The smallest positive damping and its e. Near e = 1 the fits are not monotonic, and some hosts have no damping from
 * some e on. */
static double weakest(const struct host_model *model, double *at)
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

void host_reach(const struct host_model *model, double *least, double *most)
{
    double at;
    *least = *most = (double)NAN;
    if (!model->damping_of_e)
        return;
    *least = host_realised(model, model->least);
    *most = host_eps(model->law, model->end, weakest(model, &at));
}

double host_cure(const struct host_model *model, double wished, enum host_cure_status *status)
{
    const double damping = host_damping(model->law, model->end, wished);
    *status = HOST_CURE_NOT_ASKED;
    if (!model->damping_of_e || isnan(damping))
        return (double)NAN;
    *status = HOST_CURE_OK;
    if (damping == model->damping_of_e(model->most))
        return model->most;
    double high;
    *status = HOST_CURE_TOO_LARGE;
    if (damping < weakest(model, &high))
        return (double)NAN;
    *status = HOST_CURE_TOO_SMALL;
    double low = model->least;
    if (damping > model->damping_of_e(low))
        return (double)NAN;
    *status = HOST_CURE_OK;
    for (int k = 0; k < 1100 && nextafter(low, 2) < high; k++) {
        const double middle = low + (high - low) / 2;
        if (model->damping_of_e(middle) > damping)
            low = middle;
        else
            high = middle;
    }
    return high;
}
