/* SPDX-License-Identifier: MIT */
/* The models that corgen fit compares. Several models are one curve eps(g) with different parameters: on a thin plate
 * eps is that of the viscoelastic sphere at zero overlap, and in the linear and Tsuji's law eps is constant. A curve is
 * fitted once, in internal coordinates theta; a model converts them to its parameter. */
#ifndef COR_GEN_FIT_MODELS_H
#define COR_GEN_FIT_MODELS_H

#include <stdbool.h>
#include <stddef.h>

#include <cor/contact.h>

/* eps is a function of beta = exp(theta_0) (g/(m/s))^q, or constant, theta_0, or min(1, exp(theta_0)
 * (g/(m/s))^theta_1), or that of elastic-plastic spheres with the yield speed exp(theta_0). Of such a dry eps, with
 * x = exp(theta_1) in m/s, the rest is
 *
 *     adhesive: (eps(g)^2 - (x/g)^2)^(1/2), the work of parting taken from the rebound
 *     wet:      (eps(g - x) (g - x) - x)/g, the speed x taken by a liquid on both ways
 *
 * and 0 where that is negative. */
enum fit_curve {
    FIT_SPHERE_ZERO_OVERLAP, /* q = 1/5 */
    FIT_SPHERE_ZERO_FORCE,   /* q = 1/5 */
    FIT_CONSTANT,
    FIT_HUNT_CROSSLEY,              /* q = 1 */
    FIT_HERTZ_DASHPOT_ZERO_OVERLAP, /* q = -1/5 */
    FIT_HERTZ_DASHPOT_ZERO_FORCE,   /* q = -1/5 */
    FIT_POWER_LAW,
    FIT_ELASTIC_PLASTIC,
    FIT_ADHESIVE, /* of a constant */
    FIT_ADHESIVE_SPHERE_ZERO_OVERLAP,
    FIT_ADHESIVE_SPHERE_ZERO_FORCE,
    FIT_WET,
    FIT_WET_SPHERE_ZERO_OVERLAP,
    FIT_WET_SPHERE_ZERO_FORCE,
    FIT_CURVES
};

enum { FIT_MAX_PARAMETERS = 2 };

int fit_curve_parameters(enum fit_curve curve);

/* The dry curve of a curve with a loss, which has theta_0 alone; other curves themselves */
enum fit_curve fit_curve_dry(enum fit_curve curve);

/* Whether a coordinate is a logarithm: at an end of its range it stands for 0 or infinity. */
bool fit_coordinate_is_logarithm(enum fit_curve curve, int parameter);

/* eps[i] at the speeds exp(log_speed[i]), for i < n */
void fit_curve_eps(enum fit_curve curve, const double *theta, const double *log_speed, double *eps, size_t n);

/* The range of theta that is searched, for speeds between the two given. At the ends of the range of a beta, eps is 1
 * or 0 within 1e-8 at all of these speeds. */
void fit_curve_range(enum fit_curve curve, int parameter, double least_log_speed, double most_log_speed, double *low,
                     double *high);

/* The bodies of the contact, if the user gives them */
struct fit_bodies {
    struct cor_body body_1, body_2;
    double density_2_kg_m3; /* of the plate; NAN: not known */
};

struct fit_model {
    const char *name, *end, *title; /* "viscoelastic", "zero-overlap", and both; end and title "both" and the name */
    enum fit_curve curve;
    const char *parameter[FIT_MAX_PARAMETERS];
    const char *parameter_with_bodies; /* replaces the first; NULL: bodies do not matter */
    /* The parameter as a monotonic function of theta; with bodies where they matter */
    double (*value)(double theta);
    double (*value_with_bodies)(double theta, const struct fit_bodies *bodies);
};

extern const struct fit_model fit_models[];
extern const size_t fit_model_count;

/* The model's parameter with that index, for one coordinate theta. bodies may be NULL. */
const char *fit_parameter_name(const struct fit_model *model, int parameter, const struct fit_bodies *bodies);
double fit_parameter_value(const struct fit_model *model, int parameter, double theta, const struct fit_bodies *bodies);

#endif
