/* SPDX-License-Identifier: MIT */
/* Computes the damping of a contact, the numbers of an impact, and the settings of simulators, all in SI units.
 *
 * At the overlap x the force K x^a + C x^b x' acts between two bodies of effective mass m. At impact speed g,
 *
 *     beta = (C/m) (m/K)^((b+1)/(a+1)) g^q,     q = (2 b - a + 1)/(a + 1)
 *
 * is the only parameter of the dimensionless law x'' + beta x^b x' + x^a = 0. For the linear dashpot and Tsuji's
 * damping q = 0. Their parameter is zeta = beta/sqrt(2 (a + 1)), and eps is the same at every speed.
 *
 * These functions form a separate library, libcor_scene (in CMake cor::scene), which needs libcor and libm. They are
 * thread-safe. The only memory they use is at most COR_SCENE_MAX_STACK bytes of stack. They assume rounding to nearest.
 * They never set errno, and raise only underflow and inexact. A solver of the caller runs in the caller's
 * floating-point environment. The functions in struct cor_simulator_model do not check their arguments. Every number
 * with a unit must be from COR_SI_LEAST to COR_SI_MOST (contact.h), or 0 where 0 is meaningful. Other numbers give NaN
 * or COR_FAULT_RANGE. The lines for simulators need numbers from 1e-48 to 1e48. Source: docs/theory.md, 9, and
 * docs/laws.md. */
#ifndef COR_SCENE_H
#define COR_SCENE_H

#include <stddef.h>

#include "contact.h"
#include "law.h"

#ifdef __cplusplus
extern "C" {
#endif

#define COR_SCENE_MAX_STACK 32768

/* ---- laws and ends of contact ---- */

extern const struct cor_exponents cor_law_exponents[COR_LAW_IMPULSE]; /* indexed by enum cor_law */

enum { COR_SCENE_ENDS = 2 };                      /* 0: zero overlap. 1: zero force or the surface */
extern const char *const cor_end_names[COR_ENDS]; /* "zero overlap" */

/* Return eps for a damping parameter, and the damping parameter for an eps, of the laws with closed forms: linear and
 * Tsuji (zeta), Hunt and Crossley (beta), an impulse. They return NaN for other laws, for ends that the law does not
 * have, and if the functions of law.h give NaN. Accuracy: as the functions of law.h. */
double cor_law_eps(enum cor_law law, enum cor_end end, double damping);
double cor_law_damping(enum cor_law law, enum cor_end end, double eps);

/* Returns the largest value of x^a + beta x^b x' during the collision x'' + beta x^b x' + x^a = 0, x(0) = 0, x'(0) = 1.
 * The argument is zeta if q = 0, otherwise beta. In SI units the largest force is m g/T times this number, where T is
 * the unit of time. For q = 0 and for a = b the result is a closed form. Otherwise Taylor series integrate the motion
 * up to the largest overlap. If the damping is so strong that the spring is negligible, the result is the limit for
 * beta -> infinity.
 * Accuracy: COR_LAW_FORCE_MAX_ERROR, relative; sampled in tests/unit/test_scene_force.c and tests/gen/test_contact.c.
 * Special values: damping negative, infinite or NaN, or above 1e100 (q = 0) or 1e280 (a = b) -> NaN. */
#define COR_LAW_FORCE_MAX_ERROR 1e-12
double cor_law_force_max(const struct cor_exponents *exponents, double damping);

/* ---- spheres that yield, spheres in a liquid ---- */

/* Return three numbers of elastic-plastic spheres (Thornton 1997): eps at x = v/v_y, 1 - eps at x, and x for a given
 * eps. v is the impact speed and v_y the yield speed. With r = 1/x and t = r sqrt(5/(6 - r^2)): eps^4 = 108 t/((t + 2)
 * (t^2 + 5)^2). eps = 1 for x <= 1. The bounds below are in units in the last place. The bound for eps counts roundings
 * (docs/theory.md, 21); the others are sampled in tests/unit/test_scene_plastic.c. Special values: x = +inf -> eps 0; x
 * negative or NaN, eps not in [0, 1] -> NaN; eps = 0 -> x = +inf. An x too large for a double is +inf, too. */
#define COR_ELASTIC_PLASTIC_EPS_MAX_ULP 4.5
#define COR_ELASTIC_PLASTIC_LOSS_MAX_ULP 12.0
#define COR_ELASTIC_PLASTIC_SPEED_RATIO_MAX_ULP 16.0
double cor_elastic_plastic_eps(double speed_ratio);
double cor_elastic_plastic_loss(double speed_ratio);
double cor_elastic_plastic_speed_ratio(double eps);

/* The bodies yield at the pressure p_y = COR_YIELD_PRESSURE times the yield stress. They yield at impact speeds above
 * v_y = COR_YIELD_FACTOR (p_y/E*)^2 (R^3 p_y/m)^(1/2), where COR_YIELD_FACTOR = (pi^5/30)^(1/2). */
#define COR_YIELD_PRESSURE 1.6
#define COR_YIELD_FACTOR 3.1938466086381453

/* Returns eps of a contact in a liquid, which reduces the speed by s on the way in and again on the way out. eps: the
 * value for the dry contact at the speed v - s. The result is (eps (v - s) - s)/v, or 0 where that is negative.
 * Accuracy: 4 units in the last place of 1. Special values: s = 0 -> eps; eps outside [0, 1], speeds neither 0 nor in
 * range -> NaN. */
double cor_wet_eps(double eps, double speed_m_s, double liquid_speed_m_s);

/* ---- a contact ---- */

/* Bound on the relative error of eps, durations, overlap and force of the functions below, for an exact damping
 * parameter. Sampled in tests/gen/test_contact.c. */
#define COR_SCENE_MAX_ERROR 1e-12

/* One collision of x'' + beta x^b x' + x^a = 0, x(0) = 0, x'(0) = 1. Arrays have an element for each end. */
struct cor_scaled_impact {
    double eps[COR_SCENE_ENDS], duration[COR_SCENE_ENDS], max_overlap;
};
/* Solves the collision of a law that libcor has no functions for, with beta > 0. Sets all members of *impact if `end`
 * is COR_BOTH_ENDS, otherwise at least eps of that end. Returns 0, or a negative number, which the functions below then
 * return. */
typedef int cor_scene_solver(struct cor_scaled_impact *impact, const struct cor_exponents *law, double beta, int end);

/* A contact, filled by cor_scene_contacts or by the caller. libcor has functions for the named laws, for a = b, and for
 * eps where q = 0. */
struct cor_scene_contact {
    struct cor_exponents law;
    int plate;                /* true for Zener's plate */
    double mass_kg;           /* m; NaN if not known, like the next two fields */
    double stiffness;         /* K, N/m^a */
    double radius_m;          /* effective radius; only simulators need it */
    double damping;           /* beta g^-q, (m/s)^-q; zeta if q = 0 */
    cor_scene_solver *solver; /* solver for all other laws; NULL: the functions below return COR_FAULT_SOLVER */
    double force_n;           /* constant force that presses the bodies together, N: gravity, adhesion; 0: none */
    int plastic;              /* elastic-plastic spheres; `damping` is 0 */
    double yield_speed_m_s;   /* v_y; 0: not known */
    double liquid_speed_m_s;  /* speed s lost to a liquid on the way in and again on the way out; 0: a dry contact */
    double adhesion_j_m2;     /* work of adhesion w of JKR, J/m^2; the ends are then enum cor_jkr_end; 0: none */
};

double cor_scene_speed_exponent(const struct cor_scene_contact *contact); /* q */
/* cor_scene_has_end: 1 if the contact can have this end. cor_scene_ends_differ: 1 if eps depends on the end. */
int cor_scene_has_end(const struct cor_scene_contact *contact, int end);
int cor_scene_ends_differ(const struct cor_scene_contact *contact);
/* Returns the name of end 0 or 1 of a contact, as in the columns of corgen: "zero_overlap" and "zero_force". Under a
 * constant force it is "surface" instead of "zero_force"; with JKR adhesion, "tail" and "largest_pull". */
const char *cor_scene_end_name(const struct cor_scene_contact *contact, int end);
/* Returns 1 if an impact needs the solver. Where q = 0, eps does not need it. */
int cor_scene_needs_solver(const struct cor_scene_contact *contact);
/* Returns beta at the impact speed g > 0, m/s. Accuracy: 4 units in the last place, for an exact `damping`. */
double cor_scene_beta(const struct cor_scene_contact *contact, double speed_m_s);

/* One impact. Arrays have an element for each end of contact. Durations are infinite if the bodies never part. NaN: not
 * defined, or mass and stiffness are not known. */
struct cor_scene_impact {
    double beta, eps[COR_SCENE_ENDS], duration_s[COR_SCENE_ENDS], max_overlap_m;
};

/* Compute the impact at a speed above 0, its eps at one end, and the largest force between the damped bodies. Accuracy:
 * COR_SCENE_MAX_ERROR. cor_scene_impact and cor_scene_eps return COR_OK, COR_FAULT_RANGE, COR_FAULT_SOLVER,
 * COR_FAULT_PRESSED, or the result of the solver. */
int cor_scene_impact(struct cor_scene_impact *impact, const struct cor_scene_contact *contact, double speed_m_s);
int cor_scene_eps(double *eps_at_end, const struct cor_scene_contact *contact, double speed_m_s, int end);
double cor_scene_force_max_n(const struct cor_scene_contact *contact, double speed_m_s);
/* In a liquid, eps describes the whole impact, with the error of cor_wet_eps. The other numbers describe the dry
 * contact at the speed left by the liquid. If no speed is left, the bodies do not touch: beta and durations are NaN,
 * overlap and force 0. */

/* Computes, for spheres of known effective radius (otherwise NaN):
 * - v_y for a yield stress, and the yield stress for v_y;
 * - Hertz's contact radius and central pressure at an overlap; the pressure of elastic-plastic spheres is at most p_y;
 * - the largest overlap of a contact without damping;
 * - the speed s lost to a liquid that acts between two distances of the surfaces, 6 pi eta R^2 ln(outer/inner)/m.
 * Accuracy: 1e-14, relative. */
double cor_scene_yield_speed(const struct cor_scene_contact *contact, double yield_stress_pa);
double cor_scene_yield_stress(const struct cor_scene_contact *contact, double yield_speed_m_s);
double cor_scene_contact_radius(const struct cor_scene_contact *contact, double overlap_m);
double cor_scene_pressure(const struct cor_scene_contact *contact, double overlap_m);
double cor_scene_elastic_overlap(const struct cor_scene_contact *contact, double speed_m_s);
double cor_scene_liquid_speed(const struct cor_scene_contact *contact, double viscosity_pa_s, double gap_outer_m,
                              double gap_inner_m);

/* Returns Tabor's number (R w^2/(E*^2 z^3))^(1/3) for adhering spheres, where z is the equilibrium distance of the
 * surfaces, about COR_TABOR_DISTANCE_M. JKR holds above about COR_TABOR_JKR, DMT below about COR_TABOR_DMT. Accuracy:
 * 1e-14, relative. Special values: unknown effective radius, numbers out of range -> NaN. */
#define COR_TABOR_DISTANCE_M 3e-10
#define COR_TABOR_JKR 5.0
#define COR_TABOR_DMT 0.1
double cor_scene_tabor_number(const struct cor_scene_contact *contact, double adhesion_j_m2, double distance_m);

/* Computes a tangential spring and dashpot for solid spheres with the linear dashpot (a = 1, b = 0). With them the
 * contact point, of mass (2/7) m, reverses its tangential velocity within the duration of the contact, with the
 * restitution tangential_eps, 0 < tangential_eps <= 1. At zero overlap k_t/K = (2/7) (pi^2 + ln^2 e_t)/(pi^2 + ln^2
 * eps), where e_t is tangential_eps. The contact must not slip. Accuracy: COR_SCENE_MAX_ERROR. Returns COR_OK. Returns
 * COR_FAULT_RANGE, and sets both results to NaN, for another law, unknown mass or stiffness, a constant force, bodies
 * that never part, or a tangential_eps outside its range. */
int cor_scene_tangential(double *stiffness_n_m, double *damping_n_s_m, const struct cor_scene_contact *contact,
                         double tangential_eps, int end);

/* With force_n > 0 the equation is m x'' + C x^b x' + K x^a = force_n: gravity on a ball above a wall, or DMT adhesion.
 * For every law eps is then a function of the speed, and no solver is needed. The two ends are:
 *
 * - COR_END_ZERO_OVERLAP: the contact ends at x = 0.
 * - COR_END_ZERO_FORCE, the surface: the contact ends where the force of spring and damper vanishes, at an overlap x_f
 *   with the outward speed v_f. The bodies then fly against force_n to x = 0 and arrive with (v_f^2 - 2 force_n
 *   x_f/m)^(1/2). eps is this speed divided by the impact speed. The duration includes the flight. For b >= a the
 *   two ends are the same.
 *
 * Each end has a sticking speed. Up to this speed the bodies come to rest in contact: eps is 0 and the duration
 * infinite (docs/theory.md, 24). The largest force does not include force_n. Accuracy: COR_SCENE_PRESSED_ERROR bounds
 * the absolute error of eps^2 and the relative errors of overlap, of force, and, while eps > 0.01, of durations.
 * Sampled against proved enclosures in tests/gen/test_contact.c, with force_n up to 1e12 in units of m g/T.
 * cor_scene_sticking_speed returns the sticking speed in m/s. It is 0 without force or damping, and infinite if the
 * bodies stick at every speed up to 1e9 times sqrt(m) (force_n^(a+1)/K)^(1/(2 a))/m. In a liquid, eps is 0 below this
 * speed. */
#define COR_SCENE_PRESSED_ERROR 1e-12
double cor_scene_sticking_speed(const struct cor_scene_contact *contact, int end);

/* ---- time step ---- */

/* The integrator of a simulator. The first three are the same integrator under three names:
 *
 *     v += h F(x, v)/m,  x += h v
 *
 * Velocity Verlet computes the damping force at the velocity of the last half step, leapfrog at the velocity of the
 * last step. COR_VERLET_FULL_STEP uses the velocity predicted for the full step, v + (h/2) F/m with the last force F.
 * COR_IMPLICIT_EULER, for the linear law only, uses force and velocity at the end of the step, as engines for robots
 * and games do. v' = (v - (h K/m) x)/(1 + h C/m + h^2 K/m) and x' = x + h v'; if the force would pull and the end is
 * COR_END_ZERO_FORCE, v' = v. The input of such engines is K and C, or ERP = h K/(h K + C) and CFM = 1/(h K + C). */
enum cor_integrator {
    COR_VERLET_HALF_STEP, /* LAMMPS, LIGGGHTS, MercuryDPM, OpenFOAM, PFC */
    COR_LEAPFROG,         /* YADE */
    COR_SYMPLECTIC_EULER, /* MFiX, Kratos, Chrono, MuJoCo, ESyS-Particle, Newton, Lethe */
    COR_VERLET_FULL_STEP,
    COR_IMPLICIT_EULER, /* ODE */
    COR_INTEGRATORS,
    COR_NO_INTEGRATOR = -1 /* the simulator uses impulses or implicit methods, or chooses its own steps */
};
extern const char *const cor_integrator_names[COR_INTEGRATORS + 1]; /* "verlet-half-step"; ends with NULL */

/* Returns the elastic duration (without damping) at this speed, s. Time steps are counted per elastic duration. */
double cor_scene_elastic_duration_s(const struct cor_scene_contact *contact, double speed_m_s);
#define COR_SCENE_STEPS_MIN 2.0
#define COR_SCENE_STEPS_MIN_IMPLICIT 1e-6 /* the minimum for COR_IMPLICIT_EULER, whose contacts may last for one step */
#define COR_SCENE_STEPS_MAX 1e6

/* The realised eps of a simulator minus the exact eps, over all phases of the first step. The phase is the time from
 * first touch to the end of the step in which the bodies touch. It is uniformly distributed from 0 to the step h. Under
 * a constant force eps is the ratio of the speeds at x = 0. Before the first step and after the last one only force_n
 * acts, and v^2/2 - force_n x/m is constant. */
struct cor_step_error {
    double bias;           /* mean */
    double scatter;        /* standard deviation */
    double least, largest; /* errors over the phases that were tried */
};

/* Computes the error of eps at an impact speed, with `steps` time steps in an elastic duration. The simulator damps the
 * bodies until they are apart (end: COR_END_ZERO_OVERLAP), or removes a contact force that would pull
 * (COR_END_ZERO_FORCE; under a constant force this is the surface). The number of steps with contact force jumps at
 * some phases. The function finds these phases and integrates between them. A call takes 9 to 22 microseconds at 12
 * steps without a constant force. eps = 0 for bodies that would part with less than 1e-8 of the impact speed, and for
 * bodies that stick under the constant force. Accuracy: bias and scatter are off by at most COR_SCENE_STEP_ERROR of the
 * scatter where eps is above 1e-6; sampled in tests/unit/test_scene_step.c. Below 5 steps, a small range of phases in
 * which the bodies part can be missed. Returns COR_OK, the result of cor_scene_eps, or COR_FAULT_STEP if
 *   - steps, end or integrator are outside their range,
 *   - the constant force changes the speed in a step by more than twice the impact speed,
 *   - the bodies yield, adhere as in JKR, or are in a liquid,
 *   - a collision takes over 4194304 steps, or the motion overflows.
 * *error is NaN then. */
#define COR_SCENE_STEP_ERROR 0.02
int cor_scene_step_error(struct cor_step_error *error, const struct cor_scene_contact *contact, double speed_m_s,
                         int end, double steps, int integrator);

/* Finds the least number of steps in an elastic duration above which |bias| and scatter stay within the tolerance, to
 * within 0.1 % or one step. The function scans numbers n of steps from the least allowed one upwards by factors of 1.2,
 * up to four times the last n that failed. For each n it tests eight values from n to n + 1. Between tested values the
 * scatter may exceed the tolerance by a tenth. Returns COR_FAULT_STEP also if the scan would need more than 1e6
 * steps. */
int cor_scene_step_for(double *least_steps, const struct cor_scene_contact *contact, double speed_m_s, int end,
                       double tolerance, int integrator);

/* Finds the damping with which the mean eps over the phases is the exact eps of `contact`, within 1e-9. Returns
 * COR_FAULT_NO_DAMPING if no damping gives it. A contact without damping is not changed. */
int cor_scene_step_corrected(struct cor_scene_contact *corrected, const struct cor_scene_contact *contact,
                             double speed_m_s, int end, double steps, int integrator);

/* ---- oblique impacts ---- */

/* The rule of a tangential spring k x^p. s is the displacement of the contact point since the first touch. */
enum cor_tangential_memory {
    COR_REMEMBERS_DISPLACEMENT,          /* the force is k x^p s */
    COR_REMEMBERS_FORCE,                 /* the force is the integral of k x^p ds */
    COR_REMEMBERS_DISPLACEMENT_RESCALED, /* k x^(a-1) s; s shrinks like the contact radius x^(1/2) on the way back */
    COR_REMEMBERS_FORCE_RESCALED,        /* integral of k x^(a-1) ds; the force shrinks like x^(1/2) on the way back */
    COR_REMEMBERS_NOTHING,               /* no spring: only a damper acts */
    COR_TANGENTIAL_MEMORIES
};

/* A tangential force in the units of the collision at its speed (mass m, stiffness K, speed g, length L). The contact
 * point of solid spheres has 2/7 of the effective mass. The stiffness k x^p has kappa = (7/2) (k/K) L^(p-a+1). p is a -
 * 1. If constant_stiffness is true, p is 0 and kappa depends on the speed. A damper C_t x^b next to the normal damper C
 * x^b has damping = (7/2) C_t/C beta. damper_in_cap: friction limits the sum of spring and damper (LAMMPS, MercuryDPM);
 * otherwise it limits the spring, and the damper acts only while the contact sticks (LIGGGHTS, YADE). */
struct cor_tangential {
    int memory; /* enum cor_tangential_memory */
    int constant_stiffness, damper_in_cap;
    double kappa, damping;
};

/* Tangential models: first the general models of cor, then the models of simulators. name: as in the simulator. from:
 * the simulator, "" for a general model. The other members are as in struct cor_tangential. */
enum cor_tangential_id {
    COR_TANGENTIAL_DISPLACEMENT,
    COR_TANGENTIAL_FORCE,
    COR_TANGENTIAL_RESCALED,
    COR_TANGENTIAL_RESCALED_FORCE,
    COR_TANGENTIAL_VISCOUS,
    COR_LAMMPS_MINDLIN,
    COR_LAMMPS_MINDLIN_FORCE,
    COR_LAMMPS_MINDLIN_RESCALE,
    COR_LAMMPS_MINDLIN_RESCALE_FORCE,
    COR_LAMMPS_LINEAR_HISTORY,
    COR_LAMMPS_LINEAR_NOHISTORY,
    COR_LIGGGHTS_HISTORY,
    COR_YADE_HERTZ_MINDLIN,
    COR_YADE_VISCEL,
    COR_YADE_CUNDALL_STRACK,
    COR_MERCURYDPM_SLIDING_FRICTION,
    COR_TANGENTIAL_MODELS
};
struct cor_tangential_model {
    const char *name, *from;
    int memory, constant_stiffness, damper_in_cap;
};
extern const struct cor_tangential_model cor_tangential_models[COR_TANGENTIAL_MODELS];

/* Fills *tangential for a model with the spring k x^p, N/m^(1+p), and the damper C_t x^b, N s/m^(b+1), at an impact
 * speed. The contact must have known mass and stiffness. Returns COR_OK, or COR_FAULT_RANGE. */
int cor_scene_tangential_scaled(struct cor_tangential *tangential, const struct cor_scene_contact *contact,
                                enum cor_tangential_id model_id, double stiffness, double damping_coefficient,
                                double speed_m_s);

/* An oblique impact. restitution: u'/u, where u and u' are the velocities of the contact point along the surface before
 * and after the impact. (The tangential restitution coefficient of the literature is -u'/u.) rebound_tangent: tangent
 * of the rebound angle, u'/(eps g). impulse: tangential impulse divided by m g. regime: a sum of enum
 * cor_oblique_regime. time_step_s: an estimate of the time step with which a simulation gives u'/u within
 * COR_OBLIQUE_STEP_ERROR. It is infinite unless damper_in_cap is true and the damping force exceeds the friction limit
 * at the first touch. */
enum cor_oblique_regime { COR_OBLIQUE_STICKS = 1, COR_OBLIQUE_SLIPS = 2 };
struct cor_oblique_impact {
    double restitution, eps, rebound_tangent, impulse, time_step_s;
    int regime;
};

/* Computes the impact of two solid spheres, or of a sphere on a wall. friction: the coefficient. The normal speed is
 * speed_m_s, the tangential speed `tangent` times as high. Friction limits the tangential force to `friction` times the
 * absolute value of the normal force of spring and damper. With the end zero overlap this normal force is negative just
 * before the end. For tangent = 0 the result is the limit of small angles. The contact may have any power law and a
 * constant force; if the bodies do not part, eps is 0 and the other results are NaN. Taylor series follow the motion
 * between slip and stick, in 20 to 80 microseconds. Accuracy: COR_OBLIQUE_ERROR, absolute, of u'/u while 1e-6 <=
 * tangent/friction and eps >= 1e-3; sampled in tests/unit/test_scene_oblique.c. Returns COR_OK; COR_FAULT_RANGE for
 * numbers that are out of range and for plates, yield, liquids and JKR; COR_FAULT_PRESSED if the motion takes too many
 * steps. */
#define COR_OBLIQUE_ERROR 1e-10
#define COR_OBLIQUE_STEP_ERROR 1e-2 /* sampled in tests/unit/test_scene_oblique.c */
#define COR_OBLIQUE_MOST 1e9        /* the largest kappa, damping, beta, tangent and finite friction */
int cor_scene_oblique(struct cor_oblique_impact *oblique, const struct cor_scene_contact *contact,
                      const struct cor_tangential *tangential, double friction, double speed_m_s, double tangent,
                      int end);

/* ---- the known numbers of a contact ---- */

/* The index of a number of body 2 is the index for body 1 plus COR_SCENE_BODY. */
enum cor_scene_number {
    COR_SCENE_G_STAR, /* g*, m/s, with eps = 1 - (g/g*)^q + ... */
    COR_SCENE_YOUNG,  /* Young's modulus, Pa */
    COR_SCENE_POISSON,
    COR_SCENE_RADIUS,           /* m */
    COR_SCENE_DENSITY,          /* kg/m^3 */
    COR_SCENE_MASS,             /* kg, instead of the density */
    COR_SCENE_DISSIPATION_TIME, /* A of contact.h, s: C = (3/2) A K */
    COR_SCENE_VISCOSITY,        /* eta_1 of cor_dissipation_time_viscous_s, Pa s, instead of A */
    COR_SCENE_BULK_VISCOSITY,   /* eta_2 */
    COR_SCENE_YOUNG_2,
    COR_SCENE_POISSON_2,
    COR_SCENE_RADIUS_2,
    COR_SCENE_DENSITY_2,
    COR_SCENE_MASS_2,
    COR_SCENE_DISSIPATION_TIME_2,
    COR_SCENE_VISCOSITY_2,
    COR_SCENE_BULK_VISCOSITY_2,
    COR_SCENE_BETA, /* beta at the speed COR_SCENE_AT; if q = 0, it is the same at every speed */
    COR_SCENE_AT,   /* m/s */
    COR_SCENE_STIFFNESS,
    COR_SCENE_DAMPING_COEFFICIENT, /* C, N s/m^(b+1) */
    COR_SCENE_EFFECTIVE_MASS,
    COR_SCENE_RESTITUTION, /* eps at the speed COR_SCENE_AT, 0 < eps <= 1 */
    COR_SCENE_ZETA,
    COR_SCENE_PLATE_THICKNESS,  /* m */
    COR_SCENE_GRAVITY,          /* m/s^2, presses body 1 to a wall or a plate */
    COR_SCENE_ADHESION,         /* work of adhesion w, J/m^2, with an adhesion model */
    COR_SCENE_YIELD_STRESS,     /* Pa, of the body that yields first */
    COR_SCENE_LIQUID_VISCOSITY, /* Pa s, of a liquid between the bodies; needs both gaps */
    COR_SCENE_GAP_OUTER,        /* m, distance of the surfaces at which the liquid begins to act */
    COR_SCENE_GAP_INNER,        /* m, distance at which the bodies touch: their roughness */
    COR_SCENE_DURATION,         /* s, duration at the speed COR_SCENE_AT, instead of the stiffness or the damping */
    COR_SCENE_NUMBERS,
    COR_SCENE_BODY = COR_SCENE_YOUNG_2 - COR_SCENE_YOUNG
};
/* The numbers as corgen, the calculator and Python accept them: the name of the option, the unit, and the range. A
 * number must be finite, at most `largest`, and above `least`, or equal to it if least_allowed is true. */
struct cor_scene_option {
    const char *name, *unit; /* "young-2", "Pa"; unit "": none */
    double least, largest;
    int least_allowed;
    const char *allowed; /* "a finite number above 0" */
};
extern const struct cor_scene_option cor_scene_options[COR_SCENE_NUMBERS];
int cor_option_allows(const struct cor_scene_option *option, double value); /* True if the value is in the range */

/* The force between spheres that adhere. DMT: 2 pi w R, constant during the contact. JKR: depends on the overlap. */
enum cor_adhesion { COR_ADHESION_NONE, COR_ADHESION_DMT, COR_ADHESION_JKR };

/* Spheres with JKR adhesion attract each other beyond zero overlap, in the tail of the force, and part at the end of
 * the tail. In LAMMPS they part earlier, at the largest pull, and lose about half as much energy to adhesion. In arrays
 * the tail has the index of zero overlap, and the largest pull the index of zero force. The damping force is C
 * (c^2/R)^b x' with the radius c of the contact; for w -> 0 it becomes the damping force of the law.
 * Accuracy: eps^2 within COR_JKR_EPS2_MAX_ERROR, absolute. While eps > 0.01, this number also bounds the relative error
 * of durations. Down to eps = 1e-3 the bound is 0.01/eps times this number, because the rounding error of eps^2 moves
 * the end. Sampled in tests/unit/test_scene_jkr.c. Without damping eps is a closed form. The sticking speed is infinite
 * if bodies always stick. */
enum cor_jkr_end { COR_JKR_TAIL = COR_END_ZERO_OVERLAP, COR_JKR_LARGEST_PULL = COR_END_ZERO_FORCE };
#define COR_JKR_EPS2_MAX_ERROR 1e-12

struct cor_scene {
    double number[COR_SCENE_NUMBERS]; /* NaN: not known */
    struct cor_exponents law;
    int plate;                /* body 2 is a large plate of density COR_SCENE_DENSITY_2; default: COR_SCENE_DENSITY */
    int wall;                 /* body 2 is flat and held fast */
    int end;                  /* the end at which restitution and duration were measured, or COR_BOTH_ENDS */
    cor_scene_solver *solver; /* the solver for the contact; may be NULL */
    int adhesion_model;       /* enum cor_adhesion; goes with COR_SCENE_ADHESION */
    int plastic;              /* elastic-plastic spheres; a yield stress or a restitution then gives v_y */
};

/* The faults of a scene. `number` and `other` are the numbers that caused the fault. */
enum cor_fault {
    COR_FAULT_NONE,           /* COR_OK */
    COR_FAULT_SOLVER,         /* the law needs a solver */
    COR_FAULT_NO_DAMPING,     /* no damping gives this restitution */
    COR_FAULT_MISSING,        /* `number` is missing */
    COR_FAULT_ONE_OF,         /* give one of `number` and `other` */
    COR_FAULT_EXCLUDED,       /* `number` and `other` exclude each other */
    COR_FAULT_WALL,           /* a wall has no radius, density or mass */
    COR_FAULT_MATERIAL,       /* `status` of cor_sphere_contact_init or cor_plate_contact_init */
    COR_FAULT_VISCOSITY,      /* `number` is negative or infinite */
    COR_FAULT_PLATE_LAW,      /* a thickness is given, but the law is not the plate's */
    COR_FAULT_PLATE_END,      /* a plate has only the end zero overlap */
    COR_FAULT_PLATE_BODIES,   /* a plate needs a sphere and a plate */
    COR_FAULT_PLATE_NUMBERS,  /* a plate has only thickness, modulus, Poisson's ratio and density */
    COR_FAULT_PLATE_DENSITY,  /* the density of the plate is missing */
    COR_FAULT_PLATE_DAMPING,  /* a plate has no damping except the dissipation of its sphere */
    COR_FAULT_TWO_CONTACTS,   /* bodies are given, and also a stiffness or an effective mass */
    COR_FAULT_SPRING,         /* `number` is missing: stiffness and effective mass go together */
    COR_FAULT_NOT_HERTZ,      /* bodies are given, but the law does not have Hertz's force */
    COR_FAULT_NO_WAY,         /* nothing gives the damping */
    COR_FAULT_TWO_WAYS,       /* `number` and `other` both give the damping */
    COR_FAULT_NOT_SPHERE,     /* `number` is only for viscoelastic spheres. `other`: COR_SCENE_AT, or 0 if q = 0 */
    COR_FAULT_CONSTANT,       /* g* is given, but q = 0 */
    COR_FAULT_NOT_CONSTANT,   /* zeta is given, but q is not 0 */
    COR_FAULT_NO_BODIES,      /* `number` needs bodies */
    COR_FAULT_NO_SCALES,      /* `number` needs bodies, or stiffness and effective mass */
    COR_FAULT_NO_SPEED,       /* `number` needs COR_SCENE_AT */
    COR_FAULT_SPEED_ALONE,    /* COR_SCENE_AT is given, but no number that needs it */
    COR_FAULT_FIRST_MISSING,  /* `number`, of body 2, needs `other`, the same quantity of body 1 */
    COR_FAULT_NO_SECOND_BODY, /* `number` belongs to a second viscoelastic body, which is absent */
    COR_FAULT_RANGE,          /* out of range: `number`, the speed, or a number of the contact */
    COR_FAULT_STEP,           /* cor_scene_step_error lists the causes */
    COR_FAULT_NO_STIFFNESS,   /* no stiffness fits the given damping and the given duration, C or A */
    COR_FAULT_PRESSED,        /* under a constant force the damping is too strong to be integrated */
    COR_FAULT_GRAVITY,        /* gravity needs a wall or a plate: it does not press free bodies together */
    COR_FAULT_ADHESION,       /* adhesion and an adhesion model go together */
    COR_FAULT_ADHESION_MODEL, /* no adhesion model is given, or the model does not have this law */
    COR_FAULT_PRESSED_LAW,    /* gravity or adhesion, with elastic-plastic spheres or a liquid (`number`) */
    COR_FAULT_NO_YIELD,       /* elastic-plastic spheres need a yield stress or a restitution */
    COR_FAULT_YIELD_DAMPING,  /* elastic-plastic spheres do not accept `number` */
    COR_FAULT_LIQUID,         /* `number` is missing: viscosity and both gaps go together */
    COR_FAULT_GAPS,           /* the outer gap is not larger than the inner one */
    COR_FAULT_NO_DURATION,    /* no damping fits the given duration and the given stiffness, C or A */
    COR_FAULT_TWO_DURATIONS,  /* two contacts may have this dissipation time and this duration at zero overlap */
    COR_FAULT_EQUIVALENT      /* the scene does not meet the conditions of cor_scene_equivalent */
};
struct cor_scene_fault {
    int fault;         /* enum cor_fault */
    int number, other; /* enum cor_scene_number */
    int status;        /* enum cor_status */
};
/* Writes the fault as a sentence, with the names of corgen's options for the numbers, "--young". Works like snprintf.
 * The text is shorter than COR_SCENE_FAULT_TEXT if law_name and rule are short. law_name: the law in the sentence.
 * rule: a sentence about the numbers that bodies need; NULL: the rule of corgen contact. */
enum { COR_SCENE_FAULT_TEXT = 600 };
long cor_scene_fault_text(char *text, size_t size, const struct cor_scene_fault *fault, const char *law_name,
                          const char *rule);

int cor_scene_given(const struct cor_scene *scene, int number);
/* Returns a number of a body. Body 2 has the number of body 1 unless its own is given. */
double cor_scene_of_body(const struct cor_scene *scene, int number, int body);
/* True if the mass of a body is given, false if its density gives the mass. Body 2 has mass or density of body 1 if
 * neither of its own is given. */
int cor_scene_mass_is_given(const struct cor_scene *scene, int body);

/* Checks that the numbers of two bodies are complete and do not contradict one another. options: a sum of
 * COR_SCENE_DISSIPATES (a dissipation time is needed) and COR_SCENE_DENSE_WALL (a wall may have a density). Returns
 * COR_OK, or the fault. */
enum { COR_SCENE_DISSIPATES = 1, COR_SCENE_DENSE_WALL = 2 };
int cor_scene_check_bodies(struct cor_scene_fault *fault, const struct cor_scene *scene, int options);
/* Returns body 1 or 2 of a scene in which cor_scene_check_bodies finds no fault. Walls have infinite radius and mass.
 * Unknown dissipation times are 0. */
struct cor_body cor_scene_body(const struct cor_scene *scene, int body);

/* Replaces the bodies of a scene with the linear law by a linear spring. At the speed V (COR_SCENE_AT) the spring has
 * the energy or the duration of Hertz's elastic contact. For the energy, K = ((4/5) K_H)^(4/5) (m V^2)^(1/5) with
 * Hertz's stiffness K_H. For the duration, K = m pi^2/T^2 with Hertz's duration T. Restitution, beta, zeta or damping
 * coefficient are unchanged. A damping of viscoelastic spheres becomes the restitution of Hertz's contact at V and at
 * the scene's end of contact. *hertz receives Hertz's contact without damping, for a comparison at other speeds, where
 * the spring differs. Accuracy: COR_SCENE_MAX_ERROR. Returns COR_OK, or the fault. */
enum cor_equivalence { COR_EQUIVALENT_NONE, COR_EQUIVALENT_ENERGY, COR_EQUIVALENT_DURATION };
int cor_scene_equivalent(struct cor_scene *spring, struct cor_scene_contact *hertz, struct cor_scene_fault *fault,
                         const struct cor_scene *scene, int equivalence);

/* Returns Rayleigh's time step, s: the time pi R sqrt(rho/G)/(0.1631 nu + 0.8766) in which a surface wave travels half
 * around a sphere, or the smaller time of two spheres. Particle codes commonly limit their step to 0.1 to 0.3 of it.
 * NaN: a scene without bodies. Accuracy: 1e-14, relative. Source: [LIGGGHTS], fix check/timestep/gran. */
double cor_scene_rayleigh_step_s(const struct cor_scene *scene);

/* Fills *contacts, and sets *count to 1. If a restitution or a duration is given without the end of contact, and the
 * end matters, makes one contact for each end and sets *count to 2. Returns COR_OK, the fault, or the result of the
 * solver. After a failure *fault has the details, and *count is 0.
 * Accuracy of `damping`: 1e-14 relative; of a stiffness from a duration: 1e-11. Sampled in tests/gen/test_contact.c. */
int cor_scene_contacts(struct cor_scene_contact contacts[COR_SCENE_ENDS], int *count, struct cor_scene_fault *fault,
                       const struct cor_scene *scene);

/* cor_scene_set_damping sets `damping` from one of DISSIPATION_TIME, G_STAR, DAMPING_COEFFICIENT, BETA, ZETA and
 * RESTITUTION. It needs the speed for BETA and RESTITUTION where q is not 0, and the end for RESTITUTION. It returns
 * COR_OK, COR_FAULT_SOLVER, COR_FAULT_NO_DAMPING or the result of the solver. cor_scene_damping returns one of these
 * numbers, except RESTITUTION; BETA is at 1 m/s. NaN: the law has no such quantity, or a needed number is not known. */
int cor_scene_set_damping(struct cor_scene_contact *contact, int number, double value, double speed_m_s, int end);
double cor_scene_damping(const struct cor_scene_contact *contact, int number);

/* The quantities that corgen contact prints for a contact: name, number and unit. number: a constant of the next enum
 * or of enum cor_scene_number. Here COR_SCENE_NUMBERS means q, COR_SCENE_YIELD_STRESS means v_y, and
 * COR_SCENE_LIQUID_VISCOSITY means s. The function returns the value, or NaN if it is not known. It also returns NaN
 * for a pressing force of 0, for sticking speeds without pressing force, liquid or JKR, and for an eps that depends on
 * the speed. Under a constant force corgen prints sticking_speed_surface instead of sticking_speed_zero_force. */
enum {
    COR_SCENE_PRESSING_FORCE = COR_SCENE_NUMBERS + 1,
    COR_SCENE_STICKING_ZERO_OVERLAP,
    COR_SCENE_STICKING_ZERO_FORCE,
    COR_SCENE_EPS_ZERO_OVERLAP,
    COR_SCENE_EPS_ZERO_FORCE
};
struct cor_scene_quantity {
    const char *name;
    int number;
    const char *unit;
};
enum { COR_SCENE_QUANTITIES = 16 };
extern const struct cor_scene_quantity cor_scene_quantities[COR_SCENE_QUANTITIES];
double cor_scene_quantity(const struct cor_scene_contact *contact, int number);

/* ---- simulators ---- */

/* How the lines of a model define the contacts of several types of particles. NONE: only one pair. LINES: a line for
 * each pair. MATRIX: matrices. ONE_LAW: one law, also for walls */
enum cor_simulator_pairs { COR_PAIRS_NONE, COR_PAIRS_LINES, COR_PAIRS_MATRIX, COR_PAIRS_ONE_LAW };
/* How the numbers in the lines depend on the mass. OF_NUMBER: like the number of the model. IN_LINES: they contain
 * twice the effective mass. PER_UNIT: they are per unit of mass, and do not depend on it */
enum cor_simulator_mass { COR_MASS_OF_NUMBER, COR_MASS_IN_LINES, COR_MASS_PER_UNIT };

/* The contact models, each with a row in cor_simulators */
/* clang-format off */
enum cor_simulator_model_id {
    COR_LAMMPS_HOOKE_VELOCITY, COR_LAMMPS_HOOKE_VELOCITY_LIMIT, COR_LAMMPS_HOOKE_MASS_VELOCITY,
    COR_LAMMPS_HOOKE_MASS_VELOCITY_LIMIT, COR_LAMMPS_HOOKE_VISCOELASTIC, COR_LAMMPS_HERTZ_VISCOELASTIC,
    COR_LAMMPS_HERTZ_VISCOELASTIC_LIMIT, COR_LAMMPS_HERTZ_VELOCITY, COR_LAMMPS_HERTZ_MASS_VELOCITY,
    COR_LAMMPS_COEFF_RESTITUTION, COR_LAMMPS_COEFF_RESTITUTION_LIMIT, COR_LAMMPS_HERTZ_TSUJI,
    COR_LAMMPS_HERTZ_TSUJI_LIMIT, COR_LAMMPS_HERTZ_TSUJI_2026, COR_LAMMPS_HOOKE_TSUJI, COR_LAMMPS_HOOKE_TSUJI_2026,
    COR_LIGGGHTS_HOOKE_GAMMAN, COR_LIGGGHTS_HOOKE_GAMMAN_LIMIT, COR_LIGGGHTS_RESTITUTION,
    COR_LIGGGHTS_RESTITUTION_LIMIT, COR_LIGGGHTS_HERTZ_GAMMAN, COR_LIGGGHTS_HERTZ_GAMMAN_LIMIT,
    COR_YADE_BETAN, COR_YADE_EN, COR_YADE_EN_UNTIL_2023, COR_YADE_EN_VN, COR_YADE_KN_CN, COR_YADE_TC_EN,
    COR_YADE_YOUNG_EN,
    COR_MERCURYDPM_LINEAR, COR_MERCURYDPM_HERTZIAN, COR_MERCURYDPM_HERTZIAN_DISSIPATION, COR_MERCURYDPM_BSHP,
    COR_CHRONO_MATERIAL, COR_CHRONO_HOOKE, COR_CHRONO_HERTZ, COR_CHRONO_MULTICORE_FLORES,
    COR_MFIX_LSD, COR_MFIX_HERTZIAN, COR_OPENFOAM_PAIR,
    COR_KRATOS_HERTZ, COR_KRATOS_HERTZ_GAMMA, COR_KRATOS_LINEAR, COR_KRATOS_LINEAR_GAMMA, COR_GRANULARS_EN,
    COR_ESYS_HERTZIAN, COR_ESYS_HERTZ_MINDLIN, COR_DEM_ENGINE_HERTZ, COR_EXADEM_DAMP_RATE,
    COR_DRAKE_HUNT_CROSSLEY, COR_DRAKE_SAP, COR_SIMBODY_HUNT_CROSSLEY,
    COR_MUJOCO_TIME_CONSTANT, COR_MUJOCO_STIFFNESS, COR_NEWTON_SEMI_IMPLICIT,
    COR_MODELICA_LINEAR, COR_MODELICA_HERTZ, COR_OPENSEES_HERTZ_DAMP,
    COR_BULLET_RESTITUTION, COR_BULLET_CALLBACK, COR_GAZEBO_BOUNCE, COR_LETHE_RESTITUTION, COR_PFC_LINEAR,
    COR_REBOUND_CONSTANT, COR_REBOUND_CALLBACK,
    COR_BULLET_STIFFNESS, COR_GAZEBO_KP_KD, COR_PHYSX_COMPLIANT, COR_ISAAC_COMPLIANT, COR_PFC_LINEAR_PUSHES,
    COR_EDEM_HERTZ, COR_SIMSCAPE_DAMPED, COR_SIMSCAPE_UNDAMPED,
    COR_SIMULATOR_MODELS
};
/* clang-format on */

/* A contact model of a simulator. Its damping is the parameter of its law: zeta where q = 0, otherwise beta at the
 * speed. The texts affect no number. */
struct cor_simulator_model {
    enum cor_simulator_model_id id;
    const char *model;     /* its name in the simulator's input or documentation */
    const char *parameter; /* the number that the user sets, with its unit; "e" for a restitution coefficient */
    enum cor_law law;
    enum cor_end end;

    /* The damping that the simulator computes from e, for least <= e <= most; NULL if the user does not set e. */
    double (*damping_of_e)(double e);
    double least, most;

    /* Convert the damping at a speed to the number that the user sets, and back; NULL if the user sets e. Of the
     * contact, both functions use only mass, stiffness and radius. */
    double (*number_of_damping)(const struct cor_simulator_model *model, double damping,
                                const struct cor_scene_contact *contact, double speed_m_s);
    double (*damping_of_number)(const struct cor_simulator_model *model, double number,
                                const struct cor_scene_contact *contact, double speed_m_s);
    int number; /* selects the factor that converts damping to number (runtime/scene/simulators.c) */

    const char *file;    /* the source file in the simulator */
    const char *known;   /* how the model is known: "run", "source" or "documentation" */
    const char *version; /* the version that was run or read */
    const char *advice;  /* a sentence for the user */

    /* Templates of lines for the input, of lines for a sphere and a wall, and of lines for several materials; NULL:
     * none. Words in braces are replaced by numbers and texts of the contact (runtime/scene/lines.c). A line that
     * starts with a question mark is left out if its numbers are not known. {pair} repeats a line for the pairs of two
     * types; pairs of one type become comments. In `many` the first letter of a line controls its repetition
     * (repeats_line). */
    const char *lines, *wall_lines, *many;
    enum cor_simulator_pairs pairs;
    enum cor_simulator_mass mass;
    int any_spring;    /* the model's e also holds for a linear spring */
    int has_function;  /* the lines call a function of the speed and contain no number */
    long since, until; /* versions with the model, by cor_simulator_version; 0: no known limit */
};

struct cor_simulator {
    const char *name, *title; /* "lammps", "LAMMPS" */
    int integrator;           /* enum cor_integrator */
    const struct cor_simulator_model *models;
    int model_count;

    /* A comment is one line between these two texts. NULL: no model has lines, and all members below are absent. */
    const char *comment, *comment_end;
    const char *setup;     /* a sentence about the rest of the input */
    const char *time_step; /* template of lines that set the time step; NULL: none */
    const char *version;   /* the version in Debian 12; its models have priority; NULL: none */
    long packaged;         /* cor_simulator_version of `version`; 0: none */

    /* For a wall the simulator divides Hertz's stiffness of two bodies by this number; 0: it does not. */
    double wall_divides;
    const char *wall;    /* a sentence about this division */
    const char *density; /* a sentence, if the density of the bodies is not known; NULL: none */
    int one_wall;        /* all walls are of one material */

    /* For spheres that yield. yielding: a sentence. luding: the name of Luding's model. luding_lines: a template of its
     * lines. NULL: none. */
    const char *yielding, *luding, *luding_lines;
    unsigned tangential; /* the tangential models, bits 1 << id of enum cor_tangential_id; 0: not known */
};
extern const struct cor_simulator cor_simulators[];
extern const size_t cor_simulator_count;

/* Return the model that has an id, and the simulator of this model. */
const struct cor_simulator_model *cor_simulator_model(enum cor_simulator_model_id id);
const struct cor_simulator *cor_simulator_of(enum cor_simulator_model_id id);

/* Returns the simulator with this name, in upper or lower case, with or without the part after a hyphen. Returns NULL
 * if no simulator has the name or if its models have no lines. */
const struct cor_simulator *cor_simulator_named(const char *name);

/* Returns the realised e of the model for the e that a user sets; NaN if the model has no e or refuses this one. */
double cor_simulator_realised(const struct cor_simulator_model *model, double e);

/* Returns the e' that a user must set so that the model realises `requested`, or NaN with the reason in *status. */
enum cor_simulator_status {
    COR_SIMULATOR_OK,
    COR_SIMULATOR_NOT_ASKED,      /* the model has no e, or its law has no closed form */
    COR_SIMULATOR_TOO_SMALL,      /* the model's smallest e realises more than `requested` */
    COR_SIMULATOR_TOO_LARGE,      /* the model's largest e realises less than `requested` */
    COR_SIMULATOR_NO_CLOSED_FORM, /* the model's end has no closed form of the damping */
    COR_SIMULATOR_NO_SCALES       /* mass, stiffness or radius is not known */
};
double cor_simulator_e(const struct cor_simulator_model *model, double requested, enum cor_simulator_status *status);

/* Computes the smallest and the largest restitution that the model can realise by its e. */
void cor_simulator_reach(const struct cor_simulator_model *model, double *least, double *most);

/* Returns eps of MuJoCo's contact, whose impedance d depends on the overlap x. d changes from solimp[0] at x = 0 to
 * solimp[1] at x = solimp[2], with the midpoint solimp[3] and the power solimp[4]. softness is mu^2 (1 +
 * mu^2)/(impratio (condim - 1)) for pyramidal cones of friction mu and condim >= 3, otherwise 1. With c = d/solimp[1],
 * D = d/(d + softness (1 - d)), frequency w in 1/s and the damping ratio zeta,
 *     x'' = -(D/solimp[1]) (2 zeta w x' + c w^2 x) + (1 - D) gravity
 * until the force of the contact vanishes. Only gravity acts on the way back to x = 0. The result is 0 if the ball does
 * not leave. Uses the Runge-Kutta method. Accuracy: 1e-6; sampled in tests/unit/test_simulators.c. Returns NaN if it
 * needs over 200000 steps, or outside these ranges. gravity and zeta: [0, 1e48]; frequency, speed, width and
 * softness: [1e-48, 1e48]; d: [0, 1]; midpoint: (0, 1); power: [1, 100]. */
double cor_mujoco_eps(const double solimp[5], double softness, double frequency, double zeta, double speed_m_s,
                      double gravity_m_s2);

/* Returns a version as an increasing number: "29 Sep 2021" is 20210929, "3.8.1" is 30801. 0: neither form. */
long cor_simulator_version(const char *text);

/* One of several materials, of balls or of a wall. name: letters, digits, blanks, and _ - . */
struct cor_material {
    const char *name;
    struct cor_body body; /* smallest ball, or wall with infinite radius and mass; unknown dissipation time: NaN */
    double radius_max_m;  /* radius of the largest ball, of the same density; NaN: all balls have one radius */
    const char *made_of;  /* gives the elasticity, and the dissipation time if `body` has none; NULL: no material */
};

/* A restitution measured between the smallest balls of materials a and b (indices from 0), or between a ball and a
 * wall. restitution: NaN means not measured. at_m_s: NaN means every speed, and is allowed only if q = 0. end:
 * COR_BOTH_ENDS means the end of the scene. friction: NaN means the friction of the request. */
struct cor_material_pair {
    size_t a, b;
    double restitution, at_m_s;
    int end;
    double friction;
};

/* The contact of two materials, filled by cor_simulator_lines */
struct cor_material_contact {
    struct cor_scene scene;
    struct cor_scene_contact contact[COR_SCENE_ENDS];
    int count;
    const struct cor_material_pair *measured; /* NULL: the damping follows from the dissipation times */
    double number;                            /* the number of the model in the lines */
    double friction, tangential_stiffness;    /* the stiffness is Mindlin's */
};

/* The input of cor_simulator_lines. The end of the scene is the requested end of contacts. With a wall the lines define
 * the contact of a sphere and a wall. */
struct cor_simulator_request {
    const char *simulator, *version;          /* a name of cor_simulator_named; NULL: any version */
    const struct cor_scene *scene;            /* the scene of `contacts` */
    const struct cor_scene_contact *contacts; /* from cor_scene_contacts: one, or one for each end */
    int count;
    const double *speed_m_s; /* impact speeds, for which the text states the realised e */
    size_t speeds;
    double time_step_s; /* 0: the duration of the shortest contact at these speeds, divided by `steps` */
    double steps;       /* 0: 50 */
    /* step_tolerance not 0: use the largest time step at which bias and scatter of eps stay below step_tolerance.
     * step_errors: the text states bias and scatter. step_corrected: the damping is corrected by
     * cor_scene_step_corrected. */
    double step_tolerance;
    int step_errors, step_corrected;
    int integrator; /* enum cor_integrator; COR_NO_INTEGRATOR: the simulator's integrator */
    /* Several materials, which replace `contacts`. The scene then has no numbers, only law, end and solver. NULL: two
     * bodies. memory: the caller's array of material_count^2 elements, in which the function works */
    const struct cor_material *materials;
    const struct cor_material_pair *pairs; /* the measured pairs */
    size_t material_count, pair_count;
    struct cor_material_contact *memory;
    /* friction: between equal bodies or at a wall. With materials: of pairs that have no friction of their own. 0:
     * none. tangential: a model that the simulator must have; with materials COR_TANGENTIAL_DISPLACEMENT selects its
     * first model. Spring and damper are as in cor_scene_tangential_scaled; with materials the spring is Mindlin's.
     * oblique: angles in degrees, or tangential speeds in m/s, for which the text states the tangential restitution */
    double friction, tangential_stiffness, tangential_damping;
    enum cor_tangential_id tangential;
    const double *oblique;
    size_t obliques;
    int in_degrees;
};

/* Writes the input lines for a contact in a simulator, as a text that can be included whole. One block is active: the
 * first model of this version that has the law of the contact and the requested end. Other models follow as comments.
 * If the simulator does not have the law, the lines hold at one speed: the speed of the restitution, or the only speed
 * of the request. Under gravity the numbers describe the contact, and eps includes gravity. Adhering contacts have no
 * lines.
 * With materials the block has the lines of all their contacts, and one time step. A contact that was not measured has
 * the dissipation times of both materials. If the time of a material is unknown, the measured contact of two balls of
 * this material gives it.
 * Works like snprintf: writes at most `size` characters, the last of which is 0, and returns the length of the whole
 * text.
 * A negative result means that the simulator cannot realise the contact, or that the request is incomplete; the text
 * then gives the reason, in less than COR_SIMULATOR_REASON characters. */
enum { COR_SIMULATOR_REASON = 1200 };
long cor_simulator_lines(char *text, size_t size, const struct cor_simulator_request *request);

/* Writes a list in the same way: a line for each simulator or, if named is not NULL, for each of its models. */
long cor_simulator_list(char *text, size_t size, const struct cor_simulator *named);

#ifdef __cplusplus
}
#endif

#endif
