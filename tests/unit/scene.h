/* SPDX-License-Identifier: MIT */
/* Shared by the tests of cor/scene.h: a scene without numbers, and results without a status. */
#ifndef COR_TESTS_SCENE_H
#define COR_TESTS_SCENE_H

#include <math.h>

#include "cor/scene.h"
#include "cor/status.h"
#include "random.h"

static inline struct cor_scene scene_without_numbers(enum cor_law law)
{
    struct cor_scene scene = {.law = cor_law_exponents[law], .end = COR_BOTH_ENDS};
    for (int i = 0; i < COR_SCENE_NUMBERS; i++)
        scene.number[i] = (double)NAN;
    return scene;
}

/* The laws whose impacts the library computes */
enum { SCENE_LAWS = COR_LAW_HERTZ_DASHPOT + 1 };

/* True if the library computes all numbers of an impact of the law without a solver. */
static inline int law_is_complete(int law)
{
    const struct cor_scene_contact contact = {.law = cor_law_exponents[law]};
    return !cor_scene_needs_solver(&contact);
}

/* scene_give(scene, {COR_SCENE_MASS, 1}, ...) */
#define scene_give(scene, ...)                                                                                         \
    do {                                                                                                               \
        const double given_[][2] = {__VA_ARGS__};                                                                      \
        for (size_t i_ = 0; i_ < COUNT_OF(given_); i_++)                                                               \
            (scene).number[(int)given_[i_][0]] = given_[i_][1];                                                        \
    } while (0)

#ifndef COR_FUZZ_H /* fuzz targets do not use cmocka */
#include "check.h"

/* Returns the only contact of a scene for COR_BOTH_ENDS, otherwise the one whose restitution was measured at `end`. */
static inline struct cor_scene_contact scene_contact(const struct cor_scene *scene, int end)
{
    struct cor_scene_contact contacts[COR_SCENE_ENDS];
    struct cor_scene_fault fault;
    int count;
    assert_int_equal(cor_scene_contacts(contacts, &count, &fault, scene), COR_FAULT_NONE);
    assert_true(count == 1 || end != COR_BOTH_ENDS);
    return contacts[count > 1 ? end : 0];
}

/* Returns a contact of the law with mass, stiffness and radius 1, whose impacts at 1 m/s have the beta. */
static inline struct cor_scene_contact scaled_contact(const struct cor_exponents *law, double beta, double force_n)
{
    struct cor_scene_contact c = {.law = *law, .mass_kg = 1, .stiffness = 1, .radius_m = 1, .force_n = force_n};
    cor_scene_set_damping(&c, COR_SCENE_DAMPING_COEFFICIENT, beta, 1, 0);
    return c;
}

static inline double scene_eps(const struct cor_scene_contact *contact, double speed_m_s, int end)
{
    double eps;
    assert_int_equal(cor_scene_eps(&eps, contact, speed_m_s, end), COR_FAULT_NONE);
    return eps;
}

static inline struct cor_scene_impact scene_impact(const struct cor_scene_contact *contact, double speed_m_s)
{
    struct cor_scene_impact impact;
    assert_int_equal(cor_scene_impact(&impact, contact, speed_m_s), COR_FAULT_NONE);
    return impact;
}
#endif

#endif
