/* SPDX-License-Identifier: MIT */
/* Arithmetic shared by contact.c and the array functions. For an ordinary contact and an ordinary speed it neither
 * overflows nor underflows. */
#ifndef COR_RUNTIME_SPHERE_CONTACT_PARTS_H
#define COR_RUNTIME_SPHERE_CONTACT_PARTS_H

#include "cor/contact.h"
#include "runtime/number/fifth_root.h"

/* True if beta and the duration are doubles at every speed in range. beta_per_root may be 0. */
COR_INLINE int cor_contact_is_ordinary(const struct cor_sphere_contact *contact, int needs_scale)
{
    const uint64_t factor = cor_inline_bits(contact->beta_per_root);
    return ((factor == 0) | cor_inline_between(contact->beta_per_root, COR_INLINE_2_M500, COR_INLINE_2_500)) &&
           (!needs_scale || cor_inline_between(contact->scale, COR_INLINE_2_M500, COR_INLINE_2_500));
}

/* Returns a limit for the bits of a speed, read as an integer. Speeds with smaller bits do not exceed COR_SI_MOST, and
 * their product with `scale` is below 2^902. This holds because the bits of a double are nearly linear in its
 * logarithm. If scale is NaN, the limit is 0. */
COR_INLINE uint64_t cor_contact_speed_limit(double scale)
{
    const uint64_t bits = cor_inline_bits(scale), most = (uint64_t)(2 * 1023 + 900) << 52;
    const uint64_t limit = most - bits, end = cor_inline_bits(COR_SI_MOST);
    return bits >= COR_INLINE_INFINITY_BITS ? 0 : limit < end ? limit : end;
}

/* Returns factor g^(1/5). The factor is split into head and tail, so that the first product is exact. */
COR_INLINE double cor_contact_beta_of_root(double factor, struct cor_inline_pair root)
{
    const double head = cor_inline_head(factor), tail = factor - head;
    return root.hi * head + (root.hi * tail + root.lo * factor);
}

COR_INLINE double cor_contact_duration_of(double scale, double root, double duration)
{
    return scale / root * duration;
}

COR_INLINE double cor_contact_overlap_of(double scale, double root, double overlap)
{
    return scale * overlap * root * root * root * root;
}

COR_INLINE double cor_contact_dissipation_of(double scale, double root, double beta)
{
    return beta * scale / (1.5 * root);
}

#endif
