/* SPDX-License-Identifier: MIT */
/* The exponents of a law as doubles, and tests for particular laws */
#ifndef COR_RUNTIME_SCENE_EXPONENTS_H
#define COR_RUNTIME_SCENE_EXPONENTS_H

#include "cor/scene.h"
#include "runtime/number/elementary.h"
#include "runtime/number/si_range.h"

COR_INLINE double cor_elastic(const struct cor_exponents *law)
{
    return (double)law->elastic / (double)law->denominator;
}

COR_INLINE double cor_damping(const struct cor_exponents *law)
{
    return (double)law->damping / (double)law->denominator;
}

/* True if a = a2/2 and b = b2/2 */
COR_INLINE int cor_law_is(const struct cor_exponents *law, int a2, int b2)
{
    return 2 * law->elastic == a2 * law->denominator && 2 * law->damping == b2 * law->denominator;
}

COR_INLINE int cor_law_has_spring_of(const struct cor_exponents *law, const struct cor_exponents *other)
{
    return law->elastic * other->denominator == other->elastic * law->denominator;
}

COR_INLINE int cor_law_is_same(const struct cor_exponents *law, const struct cor_exponents *other)
{
    return cor_law_has_spring_of(law, other) && law->damping * other->denominator == other->damping * law->denominator;
}

COR_INLINE int cor_law_is_hertz(const struct cor_exponents *law)
{
    return 2 * law->elastic == 3 * law->denominator;
}

/* True if q = 0: eps is then the same at every speed */
COR_INLINE int cor_law_is_constant(const struct cor_exponents *law)
{
    return 2 * law->damping - law->elastic + law->denominator == 0;
}

COR_INLINE int cor_law_is_hunt_crossley(const struct cor_exponents *law)
{
    return law->elastic == law->damping;
}

/* True if every number of a contact is in range, or is an allowed 0 or NaN (contact.c) */
int cor_contact_is_sound(const struct cor_scene_contact *contact);
int cor_law_is_sound(const struct cor_exponents *law);

#endif
