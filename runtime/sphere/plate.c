/* SPDX-License-Identifier: MIT */
/* A sphere on a thin plate, and the assumptions of the theory of bending waves. */
#include <math.h>

#include "cor/contact.h"
#include "cor/status.h"
#include "runtime/number/elementary.h"
#include "runtime/number/si_range.h"
#include "runtime/sphere/contact_parts.h"

static int is_positive(double x)
{
    return !cor_inline_is_refused(x) && x != 0 && !cor_is_infinity(x);
}

static int plate_status(const struct cor_plate *plate)
{
    if (!is_positive(plate->young_modulus_pa))
        return COR_ERROR_YOUNG_MODULUS;
    if (!(isgreater(plate->poisson_ratio, -1) && islessequal(plate->poisson_ratio, 0.5)))
        return COR_ERROR_POISSON_RATIO;
    if (!is_positive(plate->density_kg_m3))
        return COR_ERROR_DENSITY;
    if (!is_positive(plate->thickness_m))
        return COR_ERROR_THICKNESS;
    return cor_si_in_range(plate->young_modulus_pa) && cor_si_in_range(plate->density_kg_m3) &&
                   cor_si_in_range(plate->thickness_m)
               ? COR_OK
               : COR_ERROR_RANGE;
}

static double plane_modulus(double young_modulus, double nu)
{
    return young_modulus / ((1 - nu) * (1 + nu));
}

/* Returns Z = 8 sqrt(B rho h) = 4 h^2 sqrt(E/(3 (1 - nu^2))) sqrt(rho), or NaN. */
static double plate_impedance(const struct cor_plate *plate)
{
    const double modulus = plane_modulus(plate->young_modulus_pa, plate->poisson_ratio);
    const double product = cor_si_product(plate->thickness_m, sqrt(modulus / 3));
    return cor_si_product(4 * plate->thickness_m, cor_si_product(product, sqrt(plate->density_kg_m3)));
}

int cor_plate_contact_init(struct cor_sphere_contact *contact, const struct cor_body *sphere,
                           const struct cor_plate *plate)
{
    if (contact == NULL)
        return COR_ERROR_NULL;
    /* A wall of the plate's material has the elastic constant of the plate. */
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
    double time = NAN;
    if (status == COR_OK) {
        time = cor_si_quotient(contact->effective_mass_kg, plate_impedance(plate)) + contact->dissipation_time_s;
        if (!cor_si_in_range(time))
            status = COR_ERROR_RANGE;
    }
    if (status != COR_OK) {
        cor_sphere_contact_init(contact, &none, &none); /* fails and sets all fields to NaN */
        return status;
    }
    /* fills the contact again, with this dissipation time: only A and the fields that depend on A change */
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

double cor_plate_lambda(const struct cor_sphere_contact *contact, double speed_m_s)
{
    return cor_contact_beta(contact, speed_m_s) / 1.5;
}

/* ---- assumptions ---- */

/* Returns the duration, or NaN if the speed is not positive and finite. */
static double plate_duration(const struct cor_sphere_contact *contact, double speed)
{
    return cor_si_in_range(speed) ? cor_contact_duration_s_zero_overlap(contact, speed) : (double)NAN;
}

double cor_plate_contact_radius_ratio(const struct cor_sphere_contact *contact, const struct cor_plate *plate,
                                      double speed_m_s)
{
    if (!cor_si_in_range(speed_m_s) || !cor_si_in_range(contact->effective_radius_m) || plate_status(plate) != COR_OK)
        return NAN;
    const double overlap = cor_contact_max_overlap_m(contact, speed_m_s);
    return cor_si_quotient(sqrt(contact->effective_radius_m) * sqrt(overlap), plate->thickness_m);
}

double cor_plate_shear_crossings(const struct cor_sphere_contact *contact, const struct cor_plate *plate,
                                 double speed_m_s)
{
    if (plate_status(plate) != COR_OK)
        return NAN;
    const double shear_modulus = plate->young_modulus_pa / (2 * (1 + plate->poisson_ratio));
    const double speed = sqrt(cor_si_quotient(shear_modulus, plate->density_kg_m3));
    return cor_si_product(plate_duration(contact, speed_m_s), cor_si_quotient(speed, plate->thickness_m));
}

double cor_plate_sphere_crossings(const struct cor_sphere_contact *contact, const struct cor_body *sphere,
                                  double speed_m_s)
{
    const double r = sphere->radius_m, duration = plate_duration(contact, speed_m_s);
    if (!cor_si_in_range(r) || !cor_si_in_range(sphere->mass_kg))
        return NAN;
    if (!cor_si_in_range(sphere->young_modulus_pa))
        return cor_is_infinity(sphere->young_modulus_pa) ? duration * INFINITY : NAN;
    /* c/(2 R) = sqrt(E (4 pi/3) R/m)/2 */
    const double volume_of_unit_sphere = 4.18879020478639098462;
    const double quotient = cor_si_quotient(sphere->young_modulus_pa, sphere->mass_kg);
    return cor_si_product(duration, 0.5 * sqrt(cor_si_product(volume_of_unit_sphere * r, quotient)));
}

/* Returns 2 sqrt(pi t) (B/(rho h))^(1/4), where B/(rho h) = h^2 E/(12 (1 - nu^2) rho). */
double cor_plate_least_half_width_m(const struct cor_sphere_contact *contact, const struct cor_plate *plate,
                                    double speed_m_s)
{
    if (plate_status(plate) != COR_OK)
        return NAN;
    const double modulus = plane_modulus(plate->young_modulus_pa, plate->poisson_ratio),
                 square = cor_si_quotient(modulus, 12 * plate->density_kg_m3);
    return 2 * sqrt(COR_PI * plate_duration(contact, speed_m_s)) *
           sqrt(cor_si_product(plate->thickness_m, sqrt(square)));
}
