/* SPDX-License-Identifier: MIT */
/* The laws that have a name. Besides enum cor_law this is the only list of laws:
 * row(ENUMERATOR, name, numerators of a and b, their denominator, label in texts for users). */
#ifndef COR_RUNTIME_CORE_LAWS_H
#define COR_RUNTIME_CORE_LAWS_H

/* clang-format off */
/* Laws of a contact, in the order of enum cor_law */
#define COR_CONTACT_LAWS(row)                                                                                          \
    row(VISCOELASTIC, "viscoelastic", 3, 1, 2, "viscoelastic spheres")                                                 \
    row(LINEAR, "linear", 1, 0, 1, "linear spring and dashpot")                                                        \
    row(TSUJI, "tsuji", 6, 1, 4, "Tsuji")                                                                              \
    row(HUNT_CROSSLEY, "hunt-crossley", 3, 3, 2, "Hunt and Crossley")                                                  \
    row(HERTZ_DASHPOT, "hertz-dashpot", 3, 0, 2, "Hertz with a constant dashpot")                                      \
    row(PLATE, "plate", 3, 1, 2, "sphere on a plate (Zener)")                                                          \
    row(ELASTIC_PLASTIC, "elastic-plastic", 3, 1, 2, "elastic-plastic spheres")
/* Laws of simulators only. COR_LAW_IMPULSE has no exponents. */
#define COR_SIMULATOR_LAWS(row) row(LINEAR_ROOT, "linear-root", 2, 1, 2, "")
/* clang-format on */

#define COR_LAW_NAME(law, name, a, b, denominator, label) [COR_LAW_##law] = name,
#define COR_LAW_EXPONENTS(law, name, a, b, denominator, label) [COR_LAW_##law] = {a, b, denominator},
#define COR_LAW_LABEL(law, name, a, b, denominator, label) [COR_LAW_##law] = label,

#endif
