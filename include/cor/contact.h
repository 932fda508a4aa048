/* SPDX-License-Identifier: MIT */
/* The functions of this header are for two spheres, or a sphere and a wall, in SI units. From materials and sizes they
 * compute eps at an impact speed, and beta of sphere.h.
 *
 *     bodies, filling a contact   cor_sphere_mass_kg, cor_sphere_contact_init, _init_g_star, cor_contact_g_star_m_s
 *     eps at a speed              cor_contact_beta, cor_contact_eps_zero_overlap, _zero_force
 *     duration and overlap        cor_contact_duration_s_zero_overlap, _zero_force, cor_contact_max_overlap_m
 *     A from one measured eps     cor_contact_dissipation_time_s_zero_overlap, _zero_force
 *     arrays                      the functions of a speed, with the suffix _array: cor_contact_eps_zero_force_array
 *     A from viscosities          cor_dissipation_time_viscous_s; as published in 1999: cor_dissipation_time_s
 *     oblique impacts             cor_tangential_kappa, cor_tangential_stick_angle
 *     thin plates                 cor_plate_contact_init, cor_plate_lambda, cor_plate_contact_radius_ratio,
 *                                 _shear_crossings, _sphere_crossings, _least_half_width_m
 *     elastic waves               cor_contact_wave_loss, cor_half_space_wave_factor, _wave_coefficient
 *
 * Equation numbers are the same as in sphere.h. cor.h describes threads, memory and the floating-point environment. No
 * function uses more than COR_CONTACT_MAX_STACK bytes of stack. */
#ifndef COR_CONTACT_H
#define COR_CONTACT_H

#include <stddef.h>

#include "export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Range of every number in SI units. A body, a plate, a speed, a result or a field outside this range gives NaN or a
 * status. 0 and INFINITY are in range only where a function mentions them. */
#define COR_SI_LEAST 1e-250
#define COR_SI_MOST 1e250

/* Bound on the rounding error of the functions below, in units of the last place, relative to the exact formula for the
 * given inputs. tests/unit/test_contact.c samples it, starting from materials. For durations, largest overlap and A it
 * is proved at speeds from 2^-300 to 2^300 m/s, with the filled contact treated as exact (docs/theory.md, 18). */
#define COR_CONTACT_MAX_ULP 12.0
/* Bound on the relative error of eps at a speed: (2 + 2 kappa) 2^-53, where kappa = |d ln eps/d ln beta|. Proved
 * (docs/theory.md, 18). A subnormal eps may be off by another 2^-1075. */
#define COR_CONTACT_EPS_MAX_ERROR(kappa) ((2 + 2 * (kappa)) * 1.1102230246251565e-16)

/* Bound on the stack of every function, in bytes. Measured in an optimised build, libm included: 20.5 kB. */
#define COR_CONTACT_MAX_STACK 24576

/* ---- bodies, and filling a contact ---- */

/* One of the two bodies. A wall has radius_m = mass_kg = INFINITY. */
struct cor_body {
    double young_modulus_pa;   /* Y > 0; INFINITY is a rigid body */
    double poisson_ratio;      /* -1 < nu <= 1/2 */
    double dissipation_time_s; /* A >= 0 of (3), finite; from cor_dissipation_time_viscous_s */
    double radius_m;           /* R > 0; INFINITY is a flat wall */
    double mass_kg;            /* > 0; INFINITY is a fixed body */
};

/* Returns the mass of a homogeneous sphere, (4/3) pi R^3 times density, kg. Domain: radius and density in range or
 * infinite; all other arguments -> NaN. Accuracy: 4 units of the last place. */
COR_API double cor_sphere_mass_kg(double radius_m, double density_kg_m3);

/* A pair of bodies, filled by one of the init functions. Callers may read every field, but a changed field does not
 * update the others. At impact speed g, beta = beta_per_root g^(1/5). */
struct cor_sphere_contact {
    double effective_mass_kg;      /* m = m1 m2/(m1 + m2) */
    double effective_radius_m;     /* R1 R2/(R1 + R2) */
    double elastic_constant_n_m15; /* rho of (2), N/m^(3/2): the elastic force is rho xi^(3/2) */
    double dissipation_time_s;     /* A of the pair, s */
    double beta_per_root;          /* (3/2) A (rho/m)^(2/5), (m/s)^(-1/5) */
    double scale;                  /* (rho/m)^(-2/5), m^(1/5) s^(4/5). At impact speed g the unit of time is scale
                                    * g^(-1/5), the unit of length scale g^(4/5). */
    double beta5_per_speed;        /* beta_per_root^5, s/m: beta^5 = beta5_per_speed g. NaN if the value is not a normal
                                    * double; the functions then take a slower path. */
};

/* Fills *contact for two bodies, in either order. With c_i = (1 - nu_i^2)/Y_i,
 *
 *     1/E* = c_1 + c_2,     rho = (4/3) E* sqrt(R),     A = (A_1 c_1 + A_2 c_2)/(c_1 + c_2)
 *
 * rho is the constant of Hertz's law with his combined modulus E*; for equal materials it equals (2). The formula for A
 * follows from three facts. Both bodies carry the same force F = f_i(xi_i + A_i xi_i'), which is (13) to first order in
 * A_i. The inverse of f_i is proportional to c_i. The overlaps xi_i add up to xi. The compliances c_i are therefore the
 * weights of the mean. For equal materials the mean is exact. For unequal materials the mean is a model that holds
 * while A_1 and A_2 are short compared with the duration of the contact.
 * Accuracy of beta_per_root and scale: COR_CONTACT_MAX_ULP, sampled in tests/unit/test_contact.c.
 *
 * Returns COR_OK, the status of the first wrong input, or COR_ERROR_RANGE. COR_ERROR_RANGE means that an input or a
 * field is out of range, or that beta_per_root or scale is outside 2^-500 to 2^500. After an error all fields are NaN,
 * and so is every eps computed from them. */
COR_API int cor_sphere_contact_init(struct cor_sphere_contact *contact, const struct cor_body *body_1,
                                    const struct cor_body *body_2);

/* Fills *contact from the characteristic speed g* of (29)-(31), m/s, without materials. Use this function for a fit to
 * measured eps if the materials are unknown. beta_per_root becomes (g*)^(-1/5)/|C_1|; the other fields become NaN. g* =
 * INFINITY is a contact without dissipation.
 * Accuracy of beta_per_root: COR_CONTACT_MAX_ULP.
 *
 * Returns COR_OK, COR_ERROR_NULL, or COR_ERROR_G_STAR if g* is zero, negative, NaN or out of range. On error all fields
 * are NaN. */
COR_API int cor_sphere_contact_init_g_star(struct cor_sphere_contact *contact, double g_star_m_s);

/* Returns g* of (29)-(31), m/s, defined by eps = 1 - (g/g*)^(1/5) + ...:
 *
 *     (g*)^(-1/5) = |C_1| (3/2) A (rho/m)^(2/5)
 *
 * Accuracy: 2 COR_CONTACT_MAX_ULP, with the stored beta_per_root treated as exact.
 * Special values: no dissipation, or g* above the range -> INFINITY; a contact whose init failed, or g* below the range
 * -> NaN. */
COR_API double cor_contact_g_star_m_s(const struct cor_sphere_contact *contact);

/* ---- eps at a speed ---- */

/* Returns beta = beta_per_root g^(1/5) at impact speed g >= 0, m/s.
 * Accuracy: COR_CONTACT_MAX_ULP, of which 1.5 units of the last place come from this function.
 * Special values: 0 -> 0; negative or NaN speed, or a contact whose init failed -> NaN. Without dissipation beta = 0 at
 * every speed, +inf included. */
COR_API double cor_contact_beta(const struct cor_sphere_contact *contact, double speed_m_s);

/* Return eps at impact speed g >= 0, m/s, for the two ends of contact: cor_sphere_eps_... at beta = beta_per_root
 * g^(1/5).
 * Accuracy: the relative error is at most COR_CONTACT_EPS_MAX_ERROR(kappa), proved with beta_per_root treated as exact.
 * kappa = |d ln eps/d ln beta| is near |C_1| beta at small beta. It is below 5 (zero overlap) or 5/3 (zero force), and
 * near these values at large beta.
 * Special values: speed 0 -> exactly 1, +inf -> 0; negative or NaN speed, or a contact whose init failed -> NaN.
 * Without dissipation eps = 1 at every speed >= 0. */
COR_API double cor_contact_eps_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s);
COR_API double cor_contact_eps_zero_force(const struct cor_sphere_contact *contact, double speed_m_s);

/* ---- duration and overlap ---- */

/* Return the duration of a contact at impact speed g > 0, s: scale g^(-1/5) cor_sphere_duration_...(beta).
 * Accuracy: COR_CONTACT_MAX_ULP. Special values: speed 0 -> +inf. Speed +inf -> 0; at zero overlap with dissipation the
 * duration grows like ln(g), so +inf -> +inf. A negative or NaN speed, or a contact of unknown scale (init failed, or
 * filled from only g*) -> NaN. */
COR_API double cor_contact_duration_s_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s);
COR_API double cor_contact_duration_s_zero_force(const struct cor_sphere_contact *contact, double speed_m_s);

/* Returns the largest overlap at impact speed g >= 0, m: scale g^(4/5) cor_sphere_max_overlap(beta).
 * Accuracy: COR_CONTACT_MAX_ULP. Special values: speed 0 -> 0, +inf -> +inf; negative or NaN speed, or a contact of
 * unknown scale (init failed, or filled from only g*) -> NaN. */
COR_API double cor_contact_max_overlap_m(const struct cor_sphere_contact *contact, double speed_m_s);

/* ---- A from one measured eps ---- */

/* Return the dissipation time A of the pair, s, from eps measured at impact speed g > 0, m/s: A = (2/3) beta(eps) scale
 * g^(-1/5), where beta(eps) is cor_sphere_beta_.... The contact may have been filled with any A.
 * Accuracy: COR_CONTACT_MAX_ULP, with the given eps treated as exact (sphere.h, the inverse).
 * Special values: eps 1 -> 0, 0 -> +inf. eps outside [0, 1] or NaN, a speed that is infinite, NaN or not positive, or a
 * contact of unknown scale (init failed, or filled from only g*) -> NaN. */
COR_API double cor_contact_dissipation_time_s_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s,
                                                           double eps);
COR_API double cor_contact_dissipation_time_s_zero_force(const struct cor_sphere_contact *contact, double speed_m_s,
                                                         double eps);

/* ---- arrays ---- */

/* For i < n, set y[i] to the same bits that the function without _array returns for speed_m_s[i] (and eps[i]). If n
 * is 0, the array pointers may be NULL. y may be the same array as speed_m_s or eps; other overlaps are not allowed. */
COR_API void cor_contact_beta_array(const struct cor_sphere_contact *contact, const double *speed_m_s, double *y,
                                    size_t n);
COR_API void cor_contact_eps_zero_overlap_array(const struct cor_sphere_contact *contact, const double *speed_m_s,
                                                double *y, size_t n);
COR_API void cor_contact_eps_zero_force_array(const struct cor_sphere_contact *contact, const double *speed_m_s,
                                              double *y, size_t n);
COR_API void cor_contact_duration_s_zero_overlap_array(const struct cor_sphere_contact *contact,
                                                       const double *speed_m_s, double *y, size_t n);
COR_API void cor_contact_duration_s_zero_force_array(const struct cor_sphere_contact *contact, const double *speed_m_s,
                                                     double *y, size_t n);
COR_API void cor_contact_max_overlap_m_array(const struct cor_sphere_contact *contact, const double *speed_m_s,
                                             double *y, size_t n);
COR_API void cor_contact_dissipation_time_s_zero_overlap_array(const struct cor_sphere_contact *contact,
                                                               const double *speed_m_s, const double *eps, double *y,
                                                               size_t n);
COR_API void cor_contact_dissipation_time_s_zero_force_array(const struct cor_sphere_contact *contact,
                                                             const double *speed_m_s, const double *eps, double *y,
                                                             size_t n);

/* ---- A from viscosities ---- */

/* Returns the dissipation time A of a Kelvin-Voigt solid, s, for a material whose viscous constants are known. The
 * arguments are Young's modulus Y > 0 (Pa), Poisson's ratio -1 < nu <= 1/2 and the viscous constants eta_1, eta_2 >= 0
 * (Pa s) in the notation of (4). eta_1 is twice the shear viscosity, eta_2 the bulk viscosity.
 *
 *     A = (1 + nu)/((1 - nu) Y) ((2/3) (1 - nu + nu^2) eta_1 + (1 - 2 nu)^2 eta_2)
 *
 * A is the derivative of ln(Y/(1 - nu^2)) along (eta_1/2, eta_2) in the space of shear modulus mu and bulk modulus k.
 * docs/laws.md derives the formula from the contact of a rigid body with a Kelvin-Voigt half-space. The formula is
 * exact where eta_1 : eta_2 is 2 mu : k, and agrees with (4) there. Otherwise it holds to first order in A over the
 * duration. The derivation holds while the contact grows. To first order in the rate, A is also valid while the contact
 * shrinks. Unlike (4), this A is finite and positive for every nu. It agrees with the correction of (4) by Goldobin,
 * Susloparov, Pimenova and Brilliantov, Eur. Phys. J. E 38, 55 (2015), whose eta_1 is the shear viscosity.
 * Accuracy: COR_CONTACT_MAX_ULP.
 * Special values: eta_1 = eta_2 = 0 -> 0; any argument outside its domain, infinite or NaN -> NaN. */
COR_API double cor_dissipation_time_viscous_s(double eta1_pa_s, double eta2_pa_s, double young_modulus_pa,
                                              double poisson_ratio);

/* Returns A of (4), s, as published in 1999. The derivation of (4) neglects the change that the viscous stress makes to
 * the quasi-static displacement field. This A vanishes at nu = 1/2, is singular at nu = 0, and is right only where
 * eta_1/eta_2 is near 2 mu/k. Call this function only to reproduce results that were computed with (4). The arguments
 * are the same as for cor_dissipation_time_viscous_s.
 *
 *     A = (1/3) (3 eta_2 - eta_1)^2/(3 eta_2 + 2 eta_1) (1 - nu^2)(1 - 2 nu)/(Y nu^2)
 *
 * Accuracy: COR_CONTACT_MAX_ULP, plus the cancellation in 3 eta_2 - eta_1.
 * Special values: eta_1 = eta_2 = 0 -> 0; nu = 0, where (4) is singular, and any argument outside
 * its domain, infinite or NaN -> NaN. */
COR_API double cor_dissipation_time_s(double eta1_pa_s, double eta2_pa_s, double young_modulus_pa,
                                      double poisson_ratio);

/* ---- oblique impacts ---- */

/* Returns kappa of cor_tangential_no_slip (law.h) for two homogeneous spheres, or for such a sphere and a wall, from
 * Mindlin's stiffness without slip:
 *
 *     kappa = 21 G* /E*,   1/E* = (1 - nu_1^2)/Y_1 + (1 - nu_2^2)/Y_2,
 *                          1/G* = 2 (2 - nu_1)(1 + nu_1)/Y_1 + 2 (2 - nu_2)(1 + nu_2)/Y_2
 *
 * For equal Poisson's ratios this is 21 (1 - nu)/(2 (2 - nu)), from 7 at nu = -1 to 7/2 at nu = 1/2; 9/2 at nu = 1/4.
 * Domain: Y in range (one of the two may be infinite), -1 < nu <= 1/2. Accuracy: COR_CONTACT_MAX_ULP.
 * Special values: any argument outside its domain, NaN, or two rigid bodies -> NaN.
 * Source: Mindlin, J. Appl. Mech. 16, 259 (1949); docs/theory.md, 20. */
COR_API double cor_tangential_kappa(double young_modulus_1_pa, double poisson_ratio_1, double young_modulus_2_pa,
                                    double poisson_ratio_2);

/* Returns the largest angle of impact, rad, at which spheres stick when they touch: atan((7/2) friction/kappa). The
 * angle is between the velocity of the contact point and the normal. Above this angle they slide from the first
 * instant. Up to this angle they stick during the approach, and slip during the rebound once the normal force is too
 * small. docs/theory.md, 20, has the effect of this slip on the result of cor_tangential_no_slip. With Hertz's force,
 * kappa = 9/2 is the only value without any slip. If the tangential force is accumulated in increments, not computed
 * from the displacement, use kappa/a instead of kappa, where a is the exponent of the elastic force.
 * Domain: kappa > 0 and friction >= 0, either may be infinite. Accuracy: COR_CONTACT_MAX_ULP if the error of atan is
 * below 2 ulp and friction/kappa is a normal double.
 * Special values: friction 0 -> 0, +inf -> pi/2; outside the domain, NaN, or both infinite -> NaN. */
COR_API double cor_tangential_stick_angle(double kappa, double friction);

/* ---- A sphere on a thin plate (Zener) ----
 *
 * A force F at a point of a large thin plate moves that point with the velocity F/Z, where Z = 8 sqrt(B d_p h) and B =
 * Y_p h^3/(12 (1 - nu_p^2)). Bending waves carry the energy away. A sphere that hits the plate obeys the equation of
 * sphere.h with the dissipation time A = m/Z, and beta = (3/2) lambda with Zener's inelasticity parameter lambda. The
 * contact force vanishes, and the plate is at rest, at zero overlap. cor_contact_eps_zero_overlap therefore gives the
 * restitution; functions of the zero-force end have no meaning here.
 * Source: Zener, Phys. Rev. 59, 669 (1941); docs/laws.md. */

struct cor_plate {
    double young_modulus_pa; /* Y_p > 0, finite */
    double poisson_ratio;    /* -1 < nu_p <= 1/2 */
    double density_kg_m3;    /* d_p > 0, finite */
    double thickness_m;      /* h > 0, finite */
};

/* Fills *contact for a sphere and a plate. Effective mass and radius are the mass and the radius of the sphere. The
 * dissipation time of the sphere's material, weighted by its compliance as in cor_sphere_contact_init, is added to m/Z;
 * the sum is right to first order.
 * Accuracy of beta_per_root and scale: COR_CONTACT_MAX_ULP, sampled in tests/unit/test_plate.c.
 * Returns COR_OK, the status of the first wrong input, or COR_ERROR_RANGE like cor_sphere_contact_init. On error all
 * fields are NaN. */
COR_API int cor_plate_contact_init(struct cor_sphere_contact *contact, const struct cor_body *sphere,
                                   const struct cor_plate *plate);

/* Returns Zener's lambda = (2/3) beta of a contact at impact speed g, m/s. Special values: as for cor_contact_beta. */
COR_API double cor_plate_lambda(const struct cor_sphere_contact *contact, double speed_m_s);

/* Return four numbers that show whether the plate theory holds for a filled contact at impact speed g > 0, m/s. The
 * numbers are NaN if the speed is not positive and finite, or if the contact or the plate is not valid. Accuracy:
 * COR_CONTACT_MAX_ULP + 8.
 *
 * _contact_radius_ratio   the largest contact radius sqrt(R x_max), divided by h. It must be well below 1.
 * _shear_crossings        how often a shear wave crosses the thickness of the plate during contact: the duration times
 *                         sqrt(Y_p/(2 (1 + nu_p) d_p))/h. It must be well above 1; otherwise the plate is a
 *                         half-space (cor_contact_wave_loss).
 * _sphere_crossings       the duration times sqrt(Y/density) of the sphere, divided by its diameter. It must be well
 *                         above 1. The sphere is assumed to be homogeneous.
 * _least_half_width_m the least distance, m, to an edge whose echo does not return during contact:
 *                         2 sqrt(pi duration) (B/(d_p h))^(1/4), from the group velocity of bending waves of
 *                         frequency 4 pi/duration. On a simply supported square plate of that half width, eps is off
 *                         by 0.5 % at lambda = 1 and by 0.01 % at 0.2 (tests/unit/test_plate.c). */
COR_API double cor_plate_contact_radius_ratio(const struct cor_sphere_contact *contact, const struct cor_plate *plate,
                                              double speed_m_s);
COR_API double cor_plate_shear_crossings(const struct cor_sphere_contact *contact, const struct cor_plate *plate,
                                         double speed_m_s);
COR_API double cor_plate_sphere_crossings(const struct cor_sphere_contact *contact, const struct cor_body *sphere,
                                          double speed_m_s);
COR_API double cor_plate_least_half_width_m(const struct cor_sphere_contact *contact, const struct cor_plate *plate,
                                            double speed_m_s);

/* ---- Energy lost to elastic waves in a massive block ----
 *
 * An ideally elastic sphere that hits a half-space loses energy to the waves it excites. Any contact with a large body
 * loses at least that energy. A slow force history F(t) radiates J(nu)/(2 pi d c_s^3) int F'^2 dt, where c_s is the
 * shear wave speed. To first order
 *
 *     1 - eps^2 = 2 c_w beta_w,   beta_w = (9/4) J/(2 pi d c_s^3) rho^(6/5) m^(-1/5) g^(3/5),
 *     c_w = 0.8457421741960...
 *
 * with the density d of the block, rho and m of the contact, and c_w = |C_1| of the law x'' + beta x x' + x^(3/2) = 0.
 * The formula holds while the result is well below 1, the block is deeper than the distance that a pressure wave
 * travels in half the duration, and no material yields. To first order, other losses add to this loss.
 * Source: docs/laws.md; Hunter, J. Mech. Phys. Solids 5, 162 (1957), whose constant is 6 to 8 % smaller. */

struct cor_half_space {
    double young_modulus_pa; /* Y > 0, finite */
    double poisson_ratio;    /* -1 < nu <= 1/2 */
    double density_kg_m3;    /* d > 0, finite */
};

/* Returns the dimensionless factor J(nu), which is 0.9307526... at nu = 1/4. Domain: -1 < nu <= 1/2; outside and
 * NaN -> NaN. Accuracy: the relative error of the table is at most COR_WAVE_MAX_ERROR, proved
 * (generated/wave_tables.h). Rounding adds at most 8 ulp, sampled. */
#define COR_WAVE_MAX_ERROR 1e-15
COR_API double cor_half_space_wave_factor(double poisson_ratio);

/* Returns the coefficient Lam of 1 - eps^2 = Lam (g/c)^(3/5), c = sqrt(Y/d), for a sphere and a half-space of the same
 * material: 1.1115324... at nu = 1/4. Domain: as for J. Accuracy: as for J, with 16 ulp of rounding. */
COR_API double cor_half_space_wave_coefficient(double poisson_ratio);

/* Returns 1 - eps^2 to first order, but at most 1, for any sphere and a half-space at impact speed g >= 0, m/s. The
 * contact must have been filled with the half-space as its wall. Accuracy, relative to the formula above:
 * COR_CONTACT_MAX_ULP + 16 units of the last place.
 * Special values: 0 -> 0; a negative or NaN speed, a contact without materials, a half-space outside its domain ->
 * NaN. */
COR_API double cor_contact_wave_loss(const struct cor_sphere_contact *contact, const struct cor_half_space *half_space,
                                     double speed_m_s);

#ifdef __cplusplus
}
#endif

#endif
