/* SPDX-License-Identifier: MIT */
/* One contact in SI units. At the overlap x the force K x^a + C x^b x' acts between two bodies of effective mass m. At
 * impact speed g,
 *
 *     beta = (C/m) (m/K)^((b+1)/(a+1)) g^q,     q = (2 b - a + 1)/(a + 1)
 *
 * is the one parameter of the dimensionless law (series/law.h). Where q = 0, that is for the linear dashpot and Tsuji's
 * damping, zeta = beta/sqrt(2 (a + 1)) is the parameter, and eps is the same at every speed.
 *
 * Laws of the library (viscoelastic spheres, linear, Tsuji, Hunt and Crossley, Hertz's force with a dashpot) are
 * evaluated by cor/sphere.h and cor/law.h. All other exponents are enclosed, some milliseconds for each speed. */
#ifndef COR_GEN_CONTACT_CONTACT_MODEL_H
#define COR_GEN_CONTACT_CONTACT_MODEL_H

#include "series/law.h"
#include "series/series.h"

/* Bound on the relative error of eps, durations, overlap and force, with the damping parameter of the speed taken as
 * exact. Sampled in tests/gen/test_contact.c. */
#define CONTACT_MODEL_MAX_ERROR 1e-12

enum { CONTACT_ENDS = 2 }; /* END_ZERO_OVERLAP and END_ZERO_FORCE */

struct contact_model {
    struct law law;
    bool plate;       /* Zener's plate: the sphere's law, and only the end zero overlap */
    double mass_kg;   /* m; NaN if not known, like the next two */
    double stiffness; /* K, N/m^a */
    double radius_m;  /* effective radius; only hosts need it */
    double damping;   /* beta g^-q, (m/s)^-q; where q = 0 zeta */
};

/* A contact whose damping, mass, stiffness and radius are not known yet: NaN. */
struct contact_model contact_model_of_law(const struct law *law);

double contact_model_speed_exponent(const struct contact_model *model); /* q */
bool contact_model_is_constant(const struct contact_model *model);      /* q = 0 */
/* Mass and stiffness are known, so that times, lengths and forces can be computed. */
bool contact_model_has_scales(const struct contact_model *model);
/* The contact can end in this way, and the result may differ from that of the other end. */
bool contact_model_has_end(const struct contact_model *model, enum contact_end end);
bool contact_model_ends_differ(const struct contact_model *model);

/* Whether an impact takes an enclosed collision: milliseconds instead of a fraction of a microsecond. */
bool contact_model_is_enclosed(const struct contact_model *model);

double contact_model_beta(const struct contact_model *model, double speed_m_s);

/* ---- ways to give the damping, and back ----
 * Each setter sets `damping`; each getter computes the quantity from `damping`, and gives NaN where the law has no such
 * quantity or a number that it needs is not known. */

void contact_model_set_beta(struct contact_model *model, double beta, double speed_m_s);
double contact_model_zeta(const struct contact_model *model);
void contact_model_set_coefficient(struct contact_model *model, double coefficient); /* C, N s/m^(b+1) */
double contact_model_coefficient(const struct contact_model *model);
/* A of viscoelastic spheres and of the plate, C = (3/2) A K */
void contact_model_set_dissipation_time(struct contact_model *model, double dissipation_time_s);
double contact_model_dissipation_time_s(const struct contact_model *model);
/* g* with eps = 1 - (g/g*)^q + ..., for q != 0 */
void contact_model_set_g_star(struct contact_model *model, double g_star_m_s);
double contact_model_g_star_m_s(const struct contact_model *model);
/* Sets the damping so that the impact at `speed_m_s` has this eps, 0 < eps <= 1. Returns STATUS_OK, or STATUS_FAILED
 * after a message. */
int contact_model_set_eps(struct contact_model *model, double eps, double speed_m_s, enum contact_end end);

/* ---- one impact ---- */

/* Arrays have an element for each end of contact. Durations are infinite where the bodies never part. NaN: not defined,
 * or mass and stiffness are not known. */
struct contact_impact {
    double beta, eps[CONTACT_ENDS], duration_s[CONTACT_ENDS];
    double max_overlap_m;
    double max_force_n; /* the largest force between the bodies, damping included (contact_force.h) */
};

/* Solves the impact at a speed above 0. All return STATUS_OK, or STATUS_FAILED after a
 * message. The third computes neither overlap nor force, which takes a fraction of the time. */
int contact_model_impact(struct contact_impact *impact, const struct contact_model *model, double speed_m_s);
int contact_model_eps(double *eps, const struct contact_model *model, double speed_m_s, enum contact_end end);
int contact_model_eps_duration(double *eps, double *duration_s, const struct contact_model *model, double speed_m_s,
                               enum contact_end end);

#endif
