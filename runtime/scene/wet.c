/* SPDX-License-Identifier: MIT */
/* A liquid film around a dry contact: lubrication takes the same speed s from the bodies on the way in and on the way
 * out (docs/theory.md, 22). */
#include <math.h>

#include "runtime/scene/plastic.h"

/* m dv/dt = -6 pi eta R^2 v/h with dh/dt = -v is dv/dh = 6 pi eta R^2/(m h). */
double cor_scene_liquid_speed(const struct cor_scene_contact *contact, double viscosity_pa_s, double gap_outer_m,
                              double gap_inner_m)
{
    static const double pi = 3.14159265358979323846;
    const double radius = contact->radius_m, gap = gap_outer_m - gap_inner_m;
    /* ln(1 + z) keeps its accuracy where the gaps are nearly equal */
    const double logarithm = gap < gap_inner_m ? log1p(gap / gap_inner_m) : log(gap_outer_m / gap_inner_m);
    return 6 * pi * viscosity_pa_s * radius * radius / contact->mass_kg * logarithm;
}

double cor_wet_eps(double eps, double speed_m_s, double liquid_speed_m_s)
{
    if (!(eps >= 0 && speed_m_s >= 0 && liquid_speed_m_s >= 0))
        return NAN;
    const double rest = (eps * (speed_m_s - liquid_speed_m_s) - liquid_speed_m_s) / speed_m_s;
    return liquid_speed_m_s == 0 ? eps : speed_m_s > liquid_speed_m_s ? fmax(rest, 0) : 0;
}

struct cor_scene_contact cor_dry_contact(const struct cor_scene_contact *contact)
{
    struct cor_scene_contact dry = *contact;
    dry.liquid_speed_m_s = 0;
    return dry;
}

double cor_wet_sticking_speed(const struct cor_scene_contact *contact, int end)
{
    /* The speed at contact whose dry rebound has the speed s; the dry rebound grows with the impact speed. */
    const double s = contact->liquid_speed_m_s;
    const struct cor_scene_contact dry = cor_dry_contact(contact);
    double low = s, high = s, eps = 0, rebound = 0, last;
    do { /* eps <= 1: the rebound from `low` is not faster than s */
        low = high;
        high *= 2;
        last = rebound;
        if (cor_scene_eps(&eps, &dry, high, end) != COR_FAULT_NONE)
            return NAN;
        rebound = eps * high;
    } while (rebound < s && (rebound == 0 || rebound > last * (1 + 1e-9)) && high < 1e30 * s);
    if (!(rebound >= s))
        return INFINITY;
    for (int i = 0; i < 60 && high - low > 0x1p-52 * high; i++) {
        const double middle = low + (high - low) / 2;
        if (cor_scene_eps(&eps, &dry, middle, end) != COR_FAULT_NONE)
            return NAN;
        if (eps * middle < s)
            low = middle;
        else
            high = middle;
    }
    return s + high;
}
