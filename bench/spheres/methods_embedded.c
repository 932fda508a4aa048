/* SPDX-License-Identifier: MIT */
/* Rows for code that a user compiles. generated/cor_sphere.h accepts every beta. Truncated series, Padés and two-point
 * Padés of growing order come from approximants.sh. Headers of corgen embed have falling tolerances for the ordinary
 * scene, in double and float. This file is compiled once for each set of flags. ADD is the name of its only function,
 * SET the instruction set, and INSTRUCTIONS the name of this set in the table, NULL for plain flags. With vector
 * instructions all rows are loops over arrays. */
#include "methods.h"

#include <math.h>
#include <stdio.h>

#include "cor_sphere.h"
#include "runtime/number/sets.h"

#ifndef __AVX2__
#define ROOT_OF_SCENE const double unit = scene->contact.beta5_per_speed
SCALAR_METHOD_OF(double, full_overlap, ROOT_OF_SCENE, cor_inline_eps_zero_overlap_root(unit *g))
SCALAR_METHOD_OF(double, full_force, ROOT_OF_SCENE, cor_inline_eps_zero_force_root(unit *g))

static void add_full(struct methods *methods)
{
    for (enum end end = ZERO_OVERLAP; end <= ZERO_FORCE; end++)
        methods_add(methods, &(struct method){.curve = "cor_sphere.h",
                                              .scene = "ordinary",
                                              .end = end,
                                              .each = end == ZERO_OVERLAP ? full_overlap_each : full_force_each,
                                              .chain = end == ZERO_OVERLAP ? full_overlap_chain : full_force_chain});
}
#endif

#ifdef COR_BENCH_REPORT
#include "approximants.h"
#include "scene_headers.h"

#ifdef __AVX2__
enum { FORM = ARRAY };
#define FORM_OF(REAL, NAME, SETUP, EXPRESSION) ARRAY_METHOD_OF(REAL, NAME, SETUP, EXPRESSION)
#define CHAIN(NAME) NULL
#else
enum { FORM = 0 };
#define FORM_OF(REAL, NAME, SETUP, EXPRESSION) SCALAR_METHOD_OF(REAL, NAME, SETUP, EXPRESSION)
#define CHAIN(NAME) NAME##_chain
#endif

#define X_overlap(NAME, CURVE, SETTING) FORM_OF(double, NAME##_beta, , NAME(g))
#define X_force(NAME, CURVE, SETTING) FORM_OF(double, NAME##_beta, , NAME(sqrt(g)))
APPROXIMANTS
#undef X_overlap
#undef X_force

/* Methods that compute beta from the speed by pow, as in programs of users. None of these loops can be vectorised. */
#ifndef __AVX2__
#define X_overlap(NAME, CURVE, SETTING)                                                                                \
    FORM_OF(double, NAME##_speed, const double unit = scene->contact.beta_per_root, NAME(pow(g, 0.2) * unit))
#define X_force(NAME, CURVE, SETTING)                                                                                  \
    FORM_OF(double, NAME##_speed, const double unit = sqrt(scene->contact.beta_per_root), NAME(pow(g, 0.1) * unit))
APPROXIMANTS
#undef X_overlap
#undef X_force
#endif

#define DEFINE(REAL, FLAG, NAME, END, TOLERANCE) FORM_OF(REAL, NAME, , NAME(g))
SCENE_HEADERS(DEFINE)

static void add_generated(struct methods *methods)
{
#define ROW(CURVE, SETTING, SCENE, END, INPUT, FLAGS, NAME)                                                            \
    methods_add(methods, &(struct method){.curve = CURVE,                                                              \
                                          .setting = SETTING,                                                          \
                                          .instructions = INSTRUCTIONS,                                                \
                                          .scene = SCENE,                                                              \
                                          .end = END,                                                                  \
                                          .input = INPUT,                                                              \
                                          .flags = FLAGS,                                                              \
                                          .each = NAME##_each,                                                         \
                                          .chain = CHAIN(NAME)});
#define X_overlap(NAME, CURVE, SETTING) ROW(CURVE, SETTING, NULL, ZERO_OVERLAP, FROM_BETA, FORM, NAME##_beta)
#define X_force(NAME, CURVE, SETTING) ROW(CURVE, SETTING, NULL, ZERO_FORCE, FROM_BETA, FORM, NAME##_beta)
    APPROXIMANTS
#undef X_overlap
#undef X_force
#ifndef __AVX2__
#define X_overlap(NAME, CURVE, SETTING) ROW(CURVE, SETTING, NULL, ZERO_OVERLAP, FROM_SPEED, FORM, NAME##_speed)
#define X_force(NAME, CURVE, SETTING) ROW(CURVE, SETTING, NULL, ZERO_FORCE, FROM_SPEED, FORM, NAME##_speed)
    APPROXIMANTS
#endif
#define HEADER_ROW(REAL, FLAG, NAME, END, TOLERANCE)                                                                   \
    ROW(FLAG ? "scene header float" : "scene header", #TOLERANCE, "ordinary", END, FROM_SPEED, FORM | (FLAG), NAME)
    SCENE_HEADERS(HEADER_ROW)
}
#endif

void ADD(struct methods *methods)
{
    if (!cor_processor_has(SET))
        return;
#ifndef __AVX2__
    add_full(methods);
#endif
#ifdef COR_BENCH_REPORT
    add_generated(methods);
#endif
}
