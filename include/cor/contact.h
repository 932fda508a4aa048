/* SPDX-License-Identifier: MIT */
/* From materials and sizes in SI units to beta of sphere.h and to eps at an impact speed: two
 * spheres, or a sphere and a wall. Equation numbers and floating-point environment as in sphere.h. */
#ifndef COR_CONTACT_H
#define COR_CONTACT_H

#include <stddef.h>

#include "export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bound on the rounding error of the functions below, in units of the last place, against the exact
 * formula of the given inputs. Sampled in tests/unit/test_contact.c. */
#define COR_CONTACT_MAX_ULP 12.0
/* Bound on the relative error of eps at a speed, where |d ln eps/d ln beta| = kappa: (2 + 2 kappa) 2^-53. Sampled in
 * tests/accuracy. */
#define COR_CONTACT_EPS_MAX_ERROR(kappa) ((2 + 2 * (kappa)) * 1.1102230246251565e-16)

/* One of the two bodies. A wall has radius_m = mass_kg = INFINITY. */
struct cor_body {
    double young_modulus_pa;   /* Y > 0; INFINITY is a rigid body */
    double poisson_ratio;      /* -1 < nu <= 1/2 */
    double dissipation_time_s; /* A >= 0 of (3), finite; of a viscous material cor_dissipation_time_viscous_s */
    double radius_m;           /* R > 0; INFINITY is flat */
    double mass_kg;            /* > 0; INFINITY is held fast */
};

/* A pair of bodies, filled by one of the init functions. Read any field; changing one does not
 * change the others. Speeds scale as beta = beta_per_root g^(1/5). */
struct cor_sphere_contact {
    double effective_mass_kg;      /* m = m1 m2/(m1 + m2) */
    double effective_radius_m;     /* R1 R2/(R1 + R2) */
    double elastic_constant_n_m15; /* rho of (2), N/m^(3/2): the elastic force is rho xi^(3/2) */
    double dissipation_time_s;     /* A of the pair, s */
    double beta_per_root;          /* (3/2) A (rho/m)^(2/5), (m/s)^(-1/5) */
    double scale;                  /* (rho/m)^(-2/5), m^(1/5) s^(4/5): at impact speed g the unit of
                                    * time is scale g^(-1/5), of length scale g^(4/5) */
    double beta5_per_speed;        /* beta_per_root^5, s/m: beta^5 = beta5_per_speed g. NaN if it is not a normal
                                    * double; a slower path is used then. */
};

/* Fills *contact for two bodies, in either order. With c_i = (1 - nu_i^2)/Y_i,
 *
 *     1/E = c_1 + c_2,     rho = (4/3) E sqrt(R),     A = (A_1 c_1 + A_2 c_2)/(c_1 + c_2)
 *
 * rho is Hertz's law with his combined modulus, and (2) for equal materials. A: both bodies carry
 * the same force F = f_i(xi_i + A_i xi_i'), which is (13) to first order in A_i; the inverse of f_i
 * is proportional to c_i, and the overlaps xi_i add up to xi, so the dissipation times average with
 * the compliances as weights. For equal materials that is exact; for unequal ones it is a model,
 * good while A_1 and A_2 are short against the duration of the contact.
 * Accuracy of beta_per_root and scale: COR_CONTACT_MAX_ULP, sampled in tests/unit/test_contact.c.
 *
 * Returns COR_OK, or the status of the first wrong input, which cor_status_text explains;
 * COR_ERROR_RANGE where a field would overflow or lose digits to underflow. All fields are then
 * NaN, and so is every eps computed from them. */
COR_API int cor_sphere_contact_init(struct cor_sphere_contact *contact, const struct cor_body *body_1,
                                    const struct cor_body *body_2);

/* Fills *contact from the characteristic speed g* of (29)-(31) alone, m/s: for a fit to measured
 * eps, where the materials are not known. beta_per_root = (g*)^(-1/5)/|C_1|, the other fields NaN.
 * g* = INFINITY is a contact without dissipation.
 * Accuracy of beta_per_root: COR_CONTACT_MAX_ULP.
 *
 * Returns COR_OK, COR_ERROR_NULL, or COR_ERROR_G_STAR for a g* that is zero, negative or NaN; all
 * fields are then NaN. */
COR_API int cor_sphere_contact_init_g_star(struct cor_sphere_contact *contact, double g_star_m_s);

/* g* of (29)-(31), m/s, so that eps = 1 - (g/g*)^(1/5) + ...:
 *
 *     (g*)^(-1/5) = |C_1| (3/2) A (rho/m)^(2/5)
 *
 * Accuracy relative to beta_per_root: 2 COR_CONTACT_MAX_ULP (a fifth power).
 * Special values: no dissipation, or too little for a double -> INFINITY; a contact whose init
 * failed -> NaN. */
COR_API double cor_contact_g_star_m_s(const struct cor_sphere_contact *contact);

/* beta = beta_per_root g^(1/5) at impact speed g >= 0, m/s.
 * Accuracy: COR_CONTACT_MAX_ULP in all, 1.5 units of the last place relative to beta_per_root;
 * subnormal speeds included.
 * Special values: 0 -> 0; negative or NaN speed, or a contact whose init failed -> NaN. Without
 * dissipation beta = 0 at every speed, +inf too. */
COR_API double cor_contact_beta(const struct cor_sphere_contact *contact, double speed_m_s);

/* eps at impact speed g >= 0, m/s: cor_sphere_eps_... at beta = beta_per_root g^(1/5), at either end.
 * Accuracy: relative error of the whole at most COR_CONTACT_EPS_MAX_ERROR(|d ln eps/d ln beta|), for beta_per_root as
 * it is; |d ln eps/d ln beta| is below |C_1| beta at small beta, and 5 (zero overlap) or 5/3 (zero force)
 * at large. Sampled in tests/accuracy.
 * Special values: speed 0 -> exactly 1, +inf -> 0; negative or NaN speed, or a contact whose init failed
 * -> NaN, whatever the contact. Without dissipation eps = 1 at every speed >= 0. */
COR_API double cor_contact_eps_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s);
COR_API double cor_contact_eps_zero_force(const struct cor_sphere_contact *contact, double speed_m_s);

/* Duration of a contact at impact speed g > 0, s: scale g^(-1/5) cor_sphere_duration_...(beta).
 * Accuracy: COR_CONTACT_MAX_ULP in all. Special values: speed 0 -> +inf, +inf -> 0 (where it has a limit:
 * at zero overlap with dissipation it grows with ln(g), -> +inf); negative or NaN speed, or a contact whose
 * scale is not known (init failed, or from g* alone) -> NaN. */
COR_API double cor_contact_duration_s_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s);
COR_API double cor_contact_duration_s_zero_force(const struct cor_sphere_contact *contact, double speed_m_s);

/* Largest overlap at impact speed g >= 0, m: scale g^(4/5) cor_sphere_max_overlap(beta).
 * Accuracy: COR_CONTACT_MAX_ULP in all. Special values: speed 0 -> 0, +inf -> +inf; negative or NaN speed,
 * or a contact whose scale is not known (init failed, or from g* alone) -> NaN. */
COR_API double cor_contact_max_overlap_m(const struct cor_sphere_contact *contact, double speed_m_s);

/* Dissipation time A of the pair, s, from eps measured at impact speed g > 0, m/s, for a contact filled with
 * any A: A = (2/3) beta(eps) scale g^(-1/5), by cor_sphere_beta_....
 * Accuracy: COR_CONTACT_MAX_ULP in all, for the eps as given (sphere.h, the inverse).
 * Special values: eps 1 -> 0, 0 -> +inf; eps outside [0, 1], speed not positive, infinite or NaN, or a
 * contact whose scale is not known (init failed, or from g* alone) -> NaN. */
COR_API double cor_contact_dissipation_time_s_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s,
                                                           double eps);
COR_API double cor_contact_dissipation_time_s_zero_force(const struct cor_sphere_contact *contact, double speed_m_s,
                                                         double eps);

/* Arrays: y[i] = cor_contact_...(contact, speed_m_s[i]) for i < n, or of speed_m_s[i] and eps[i], the same to the last
 * bit. n may be 0, the array pointers then NULL. The results may overwrite an array of arguments, but arrays must not
 * overlap otherwise. */
#define COR_CONTACT_DECLARE_(quantity)                                                                                 \
    COR_API void cor_contact_##quantity##_array(const struct cor_sphere_contact *contact, const double *speed_m_s,     \
                                                double *y, size_t n);
COR_CONTACT_DECLARE_(beta)
COR_CONTACT_DECLARE_(eps_zero_overlap)
COR_CONTACT_DECLARE_(eps_zero_force)
COR_CONTACT_DECLARE_(duration_s_zero_overlap)
COR_CONTACT_DECLARE_(duration_s_zero_force)
COR_CONTACT_DECLARE_(max_overlap_m)
#undef COR_CONTACT_DECLARE_
COR_API void cor_contact_dissipation_time_s_zero_overlap_array(const struct cor_sphere_contact *contact,
                                                               const double *speed_m_s, const double *eps, double *y,
                                                               size_t n);
COR_API void cor_contact_dissipation_time_s_zero_force_array(const struct cor_sphere_contact *contact,
                                                             const double *speed_m_s, const double *eps, double *y,
                                                             size_t n);

/* A of a Kelvin-Voigt solid, s: the one to use for a material whose viscous constants are known. Young's modulus Y > 0 (Pa),
 * Poisson's ratio -1 < nu <= 1/2, viscous constants eta_1, eta_2 >= 0 (Pa s) in the notation of (4), where the viscous stress is
 * the elastic one with 2 mu -> eta_1 and the bulk modulus -> eta_2: eta_1 is twice the shear viscosity, eta_2 the bulk viscosity.
 *
 *     A = (1 + nu)/((1 - nu) Y) ((2/3) (1 - nu + nu^2) eta_1 + (1 - 2 nu)^2 eta_2)
 *
 * It is the derivative of ln(Y/(1 - nu^2)) along (eta_1/2, eta_2) in the space of shear and bulk modulus: docs/laws.md derives it
 * from the contact of a rigid body with a Kelvin-Voigt half-space, exact where the constants are proportional to the moduli
 * and to first order in A over the duration otherwise. Unlike (4) it is finite and positive for every nu. It agrees with the
 * correction of (4) by Goldobin, Susloparov, Pimenova and Brilliantov, Eur. Phys. J. E 38, 55 (2015), whose eta_1 is the shear
 * viscosity. Where eta_1 : eta_2 is 2 mu : K both formulas give the same A.
 * Accuracy: COR_CONTACT_MAX_ULP.
 * Special values: eta_1 = eta_2 = 0 -> 0; any argument outside its domain, infinite or NaN -> NaN. */
COR_API double cor_dissipation_time_viscous_s(double eta1_pa_s, double eta2_pa_s, double young_modulus_pa,
                                              double poisson_ratio);

/* A of (4), s, as it was published in 1999: from a quasi-static displacement field that leaves out what the viscous stress does
 * to it. It vanishes at nu = 1/2, is singular at nu = 0, and is right only where eta_1/eta_2 is near 2 mu/K: use the function
 * above, and this one to reproduce results that were computed with (4). Arguments as above.
 *
 *     A = (1/3) (3 eta_2 - eta_1)^2/(3 eta_2 + 2 eta_1) (1 - nu^2)(1 - 2 nu)/(Y nu^2)
 *
 * Accuracy: COR_CONTACT_MAX_ULP, and what cancels in 3 eta_2 - eta_1.
 * Special values: eta_1 = eta_2 = 0 -> 0; nu = 0, where (4) is singular, and any argument outside
 * its domain, infinite or NaN -> NaN. */
COR_API double cor_dissipation_time_s(double eta1_pa_s, double eta2_pa_s, double young_modulus_pa,
                                      double poisson_ratio);

/* ---- A sphere on a thin plate (Zener) ----
 *
 * A large thin plate answers a force F at a point with the velocity F/Z, Z = 8 sqrt(B rho_p h), B = E_p h^3/(12 (1 - nu_p^2)): it
 * carries energy away in bending waves. A sphere that hits it obeys the sphere's equation with the dissipation time A = m/Z, and
 * beta = (3/2) lambda with Zener's inelasticity parameter lambda. The plate is at rest when the contact force vanishes, at zero
 * overlap: cor_contact_eps_zero_overlap is its restitution; functions of the zero-force end have no meaning here.
 * Source: Zener, Phys. Rev. 59, 669 (1941); docs/laws.md. */

struct cor_plate {
    double young_modulus_pa; /* E_p > 0, finite */
    double poisson_ratio;    /* -1 < nu_p <= 1/2 */
    double density_kg_m3;    /* rho_p > 0, finite */
    double thickness_m;      /* h > 0, finite */
};

/* Fills *contact for a sphere and a plate. Effective mass and radius are the sphere's; a dissipation time of the sphere's material
 * is added to m/Z, weighted by its compliance as in cor_sphere_contact_init, which is right to first order.
 * Accuracy of beta_per_root and scale: COR_CONTACT_MAX_ULP, sampled in tests/unit/test_plate.c.
 * Returns COR_OK or the status of the first wrong input; COR_ERROR_RANGE where a field would overflow or lose digits to underflow.
 * All fields are then NaN. */
COR_API int cor_plate_contact_init(struct cor_sphere_contact *contact, const struct cor_body *sphere,
                                   const struct cor_plate *plate);

/* Zener's lambda = (2/3) beta of a filled contact at impact speed g, m/s. Special values: as cor_contact_beta. */
COR_API double cor_plate_lambda(const struct cor_sphere_contact *contact, double speed_m_s);

/* What the theory takes for granted, of a filled contact at impact speed g > 0 (m/s), for the caller to judge. NaN for a speed
 * that is not positive and finite, or a contact or plate that is not valid. Accuracy: COR_CONTACT_MAX_ULP + 8.
 *
 * _contact_radius_ratio   largest contact radius sqrt(R x_max) over h: must be well below 1
 * _shear_crossings        duration times shear wave speed sqrt(E_p/(2 (1 + nu_p) rho_p)) over h: how often a wave crosses the plate's
 *                         thickness during contact: must be well above 1. Else the plate is a half-space (cor_contact_wave_loss).
 * _sphere_crossings       duration times sqrt(E/rho) of the sphere over its diameter: must be well above 1; the sphere is taken to be
 *                         homogeneous
 * _least_half_width_m     distance to the nearest edge below which echoes return during contact, by the group velocity of bending
 *                         waves of frequency 4 pi/duration: 2 sqrt(pi duration) (B/(rho_p h))^(1/4), m. On a square plate of that
 *                         half width, simply supported, eps is off by 0.5 % at lambda = 1 and by 0.01 % at 0.2 (tests/unit/test_plate.c). */
COR_API double cor_plate_contact_radius_ratio(const struct cor_sphere_contact *contact, const struct cor_plate *plate,
                                              double speed_m_s);
COR_API double cor_plate_shear_crossings(const struct cor_sphere_contact *contact, const struct cor_plate *plate,
                                         double speed_m_s);
COR_API double cor_plate_sphere_crossings(const struct cor_sphere_contact *contact, const struct cor_body *sphere,
                                          double speed_m_s);
COR_API double cor_plate_least_half_width_m(const struct cor_sphere_contact *contact, const struct cor_plate *plate,
                                            double speed_m_s);

/* ---- What elastic waves take on a massive block ----
 *
 * An ideally elastic sphere that hits a half-space loses energy to the waves it excites, the least that any contact with a large
 * body loses. A slow force history radiates J(nu)/(2 pi rho c_s^3) int F'^2 dt, c_s the shear wave speed, and to first order
 *
 *     1 - eps^2 = 2 |C_1| beta_w,   beta_w = (9/4) J/(2 pi rho c_s^3) K^(6/5) m^(-1/5) g^(3/5),   C_1 = -0.8457421741960...
 *
 * with K and m of the contact: C_1 is that of the law x'' + beta x x' + x^(3/2) = 0. Good while the result is well below 1, the
 * block is deeper than half the duration times the pressure wave speed, and nothing yields; other losses add to it at first order
 * only. Source: docs/laws.md; Hunter, J. Mech. Phys. Solids 5, 162 (1957), with a constant 6 to 8 % smaller. */

struct cor_half_space {
    double young_modulus_pa; /* E > 0, finite */
    double poisson_ratio;    /* -1 < nu <= 1/2 */
    double density_kg_m3;    /* rho > 0, finite */
};

/* J(nu), dimensionless, -1 < nu <= 1/2: 0.9307526... at 1/4. Outside, NaN -> NaN.
 * Relative error of the table: COR_WAVE_MAX_ERROR, proved (generated/wave_tables.h); with rounding: 8 ulp, sampled. */
#define COR_WAVE_MAX_ERROR 1e-15
COR_API double cor_half_space_wave_factor(double poisson_ratio);

/* Lam of 1 - eps^2 = Lam (g/c)^(3/5), c = sqrt(E/rho), for a sphere and a half-space of the same material: 1.1115324... at nu = 1/4.
 * Domain and accuracy as J; 16 ulp. */
COR_API double cor_half_space_wave_coefficient(double poisson_ratio);

/* 1 - eps^2 to first order for a contact of any sphere with a half-space, which the contact was filled with as a wall, at impact
 * speed g >= 0, m/s: not above 1. Accuracy as the formula above: COR_CONTACT_MAX_ULP + 16 units of the last place.
 * Special values: 0 -> 0; a negative or NaN speed, a contact without materials, a half-space outside its domain -> NaN. */
COR_API double cor_contact_wave_loss(const struct cor_sphere_contact *contact, const struct cor_half_space *half_space,
                                     double speed_m_s);

/* Mass of a homogeneous sphere, (4/3) pi R^3 times density, kg.
 * Domain: radius and density > 0; anything else -> NaN. Accuracy: 4 units of the last place. */
COR_API double cor_sphere_mass_kg(double radius_m, double density_kg_m3);

#ifdef __cplusplus
}
#endif

#endif
