/* SPDX-License-Identifier: MIT */
/* A sphere on a thin plate, and the assumptions of the theory of bending waves. */
#include <float.h>
#include <math.h>

#include "cor/contact.h"
#include "cor/status.h"
#include "runtime/number/environment.h"

static int is_positive(double x)
{
    return x > 0 && x <= DBL_MAX;
}

static int in_range(double x)
{
    return x >= DBL_MIN && x <= DBL_MAX;
}

static int plate_status(const struct cor_plate *plate)
{
    if (!is_positive(plate->young_modulus_pa))
        return COR_ERROR_YOUNG_MODULUS;
    if (!(plate->poisson_ratio > -1 && plate->poisson_ratio <= 0.5))
        return COR_ERROR_POISSON_RATIO;
    if (!is_positive(plate->density_kg_m3))
        return COR_ERROR_DENSITY;
    return is_positive(plate->thickness_m) ? COR_OK : COR_ERROR_THICKNESS;
}

/* E/(1 - nu^2) */
static double plane_modulus(double young_modulus, double nu)
{
    return young_modulus / ((1 - nu) * (1 + nu));
}

/* Z = 8 sqrt(B rho h) = 4 h^2 sqrt(E/(3 (1 - nu^2))) sqrt(rho). No product overflows before Z does. */
static double plate_impedance(const struct cor_plate *plate)
{
    const double modulus = plane_modulus(plate->young_modulus_pa, plate->poisson_ratio);
    return 4 * plate->thickness_m * (plate->thickness_m * sqrt(modulus / 3) * sqrt(plate->density_kg_m3));
}

static int plate_contact(struct cor_sphere_contact *contact, const struct cor_body *sphere,
                         const struct cor_plate *plate)
{
    if (contact == NULL)
        return COR_ERROR_NULL;
    /* A sphere and a wall of the plate's material have the elastic constant of the sphere and the plate. The contact of
     * two bodies of NaN has NaN in all fields. */
    const struct cor_body none = {NAN, NAN, NAN, NAN, NAN};
    struct cor_body wall = {0, 0, 0, INFINITY, INFINITY}, body = none;
    int status = sphere == NULL || plate == NULL ? COR_ERROR_NULL : COR_OK;
    if (status == COR_OK) {
        body = *sphere;
        wall.young_modulus_pa = plate->young_modulus_pa;
        wall.poisson_ratio = plate->poisson_ratio;
        status = cor_sphere_contact_init(contact, &body, &wall);
        if (status == COR_OK)
            status = plate_status(plate);
    }
    double time = NAN, beta_per_root = NAN;
    if (status == COR_OK) {
        time = contact->effective_mass_kg / plate_impedance(plate) + contact->dissipation_time_s;
        /* scale is (rho/m)^(-2/5) */
        beta_per_root = 1.5 * time / contact->scale;
        if (!in_range(plate_impedance(plate)) || !in_range(time) || !in_range(beta_per_root))
            status = COR_ERROR_RANGE;
    }
    if (status != COR_OK) {
        cor_sphere_contact_init(contact, &none, &none); /* fails and sets all fields to NaN */
        return status;
    }
    /* the wall's contact with this time; only A and the fields that depend on A change */
    struct cor_sphere_contact plain;
    body.dissipation_time_s = time;
    wall.dissipation_time_s = time;
    status = cor_sphere_contact_init(&plain, &body, &wall);
    if (status == COR_OK)
        *contact = plain;
    else
        cor_sphere_contact_init(contact, &none, &none);
    return status;
}

static double plate_lambda(const struct cor_sphere_contact *contact, double speed_m_s)
{
    return cor_contact_beta(contact, speed_m_s) / 1.5;
}

/* ---- assumptions ---- */

/* NaN if the speed is not positive and finite */
static double plate_duration(const struct cor_sphere_contact *contact, double speed)
{
    return is_positive(speed) ? cor_contact_duration_s_zero_overlap(contact, speed) : (double)NAN;
}

static double contact_radius_ratio(const struct cor_sphere_contact *contact, const struct cor_plate *plate,
                                   double speed_m_s)
{
    if (!is_positive(speed_m_s) || plate_status(plate) != COR_OK)
        return NAN;
    const double overlap = cor_contact_max_overlap_m(contact, speed_m_s);
    return sqrt(contact->effective_radius_m) * sqrt(overlap) / plate->thickness_m;
}

static double shear_crossings(const struct cor_sphere_contact *contact, const struct cor_plate *plate, double speed_m_s)
{
    if (plate_status(plate) != COR_OK)
        return NAN;
    const double speed = sqrt(plate->young_modulus_pa / (2 * (1 + plate->poisson_ratio)) / plate->density_kg_m3);
    return plate_duration(contact, speed_m_s) * (speed / plate->thickness_m);
}

static double sphere_crossings(const struct cor_sphere_contact *contact, const struct cor_body *sphere,
                               double speed_m_s)
{
    const double r = sphere->radius_m;
    if (!is_positive(r) || !is_positive(sphere->mass_kg) || !(sphere->young_modulus_pa > 0))
        return NAN;
    /* c/(2 R) = sqrt(E (4 pi/3) R/m)/2 */
    const double volume_of_unit_sphere = 4.18879020478639098462;
    return plate_duration(contact, speed_m_s) *
           (0.5 * sqrt(volume_of_unit_sphere * r * (sphere->young_modulus_pa / sphere->mass_kg)));
}

/* 2 sqrt(pi t) (B/(rho h))^(1/4), B/(rho h) = h^2 E/(12 (1 - nu^2) rho) */
static double least_half_width(const struct cor_sphere_contact *contact, const struct cor_plate *plate,
                               double speed_m_s)
{
    if (plate_status(plate) != COR_OK)
        return NAN;
    const double pi = 3.14159265358979311600;
    const double square = plane_modulus(plate->young_modulus_pa, plate->poisson_ratio) / (12 * plate->density_kg_m3);
    return 2 * sqrt(pi * plate_duration(contact, speed_m_s)) * sqrt(plate->thickness_m * sqrt(square));
}

/* ---- the public functions ---- */

COR_IN_ENVIRONMENT(int, cor_plate_contact_init, plate_contact,
                   (struct cor_sphere_contact * contact, const struct cor_body *sphere, const struct cor_plate *plate),
                   (contact, sphere, plate))
COR_IN_ENVIRONMENT(double, cor_plate_lambda, plate_lambda, (const struct cor_sphere_contact *contact, double speed_m_s),
                   (contact, speed_m_s))

#define OF_A_BODY(name, formula, body)                                                                                 \
    COR_IN_ENVIRONMENT(double, name, formula,                                                                          \
                       (const struct cor_sphere_contact *contact, const struct body *other, double speed_m_s),         \
                       (contact, other, speed_m_s))
OF_A_BODY(cor_plate_contact_radius_ratio, contact_radius_ratio, cor_plate)
OF_A_BODY(cor_plate_shear_crossings, shear_crossings, cor_plate)
OF_A_BODY(cor_plate_sphere_crossings, sphere_crossings, cor_body)
OF_A_BODY(cor_plate_least_half_width_m, least_half_width, cor_plate)
