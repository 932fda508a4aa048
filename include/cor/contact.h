/* SPDX-License-Identifier: MIT */
/* From materials and sizes in SI units to beta of sphere.h and to eps at an impact speed: two
 * spheres, or a sphere and a wall. Equation numbers as in sphere.h. */
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
    double dissipation_time_s; /* A >= 0 of (3), finite; cor_dissipation_time_s gives it by (4) */
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
    double beta5_per_speed;        /* beta_per_root^5, s/m: beta^5 = beta5_per_speed g; NaN where it is no normal
                                    * double, and slower ways are taken */
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

/* A of (4), s, from Young's modulus Y > 0 (Pa), Poisson's ratio -1 < nu <= 1/2 and the viscous
 * constants eta_1, eta_2 >= 0 of the material, Pa s, in the notation of (4):
 *
 *     A = (1/3) (3 eta_2 - eta_1)^2/(3 eta_2 + 2 eta_1) (1 - nu^2)(1 - 2 nu)/(Y nu^2)
 *
 * Accuracy: COR_CONTACT_MAX_ULP, and what cancels in 3 eta_2 - eta_1.
 * Special values: eta_1 = eta_2 = 0 -> 0; nu = 0, where (4) is singular, and any argument outside
 * its domain, infinite or NaN -> NaN. */
COR_API double cor_dissipation_time_s(double eta1_pa_s, double eta2_pa_s, double young_modulus_pa,
                                      double poisson_ratio);

/* Mass of a homogeneous sphere, (4/3) pi R^3 times density, kg.
 * Domain: radius and density > 0; anything else -> NaN. Accuracy: 4 units of the last place. */
COR_API double cor_sphere_mass_kg(double radius_m, double density_kg_m3);

#ifdef __cplusplus
}
#endif

#endif
