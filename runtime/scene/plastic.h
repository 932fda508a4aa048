/* SPDX-License-Identifier: MIT */
/* Contacts that yield, and contacts in a liquid, for the functions of a contact (contact.c) */
#ifndef COR_RUNTIME_SCENE_PLASTIC_H
#define COR_RUNTIME_SCENE_PLASTIC_H

#include "runtime/scene/motion.h"

/* The collision above the yield speed, in SI units */
void cor_plastic_impact(struct cor_full_impact *impact, const struct cor_scene_contact *contact, double speed_m_s);

/* wet.c: the contact without its liquid, and the speed below which the liquid holds the bodies */
struct cor_scene_contact cor_dry_contact(const struct cor_scene_contact *contact);
double cor_wet_sticking_speed(const struct cor_scene_contact *contact, int end);

#endif
