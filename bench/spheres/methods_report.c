/* SPDX-License-Identifier: MIT */
/* What the report compares beside the rest: truncated series, Padés and two-point Padés of growing order, and headers
 * that corgen embed writes for the ordinary scene as the tolerance falls, in double and float. Compiled once for each
 * set of flags like methods_embedded.c: with vectors, as loops. */
#include <math.h>
#include <stdio.h>

#include "methods.h"

#include "approximants.h"
#include "report_force_10.h"
#include "report_force_12.h"
#include "report_force_14.h"
#include "report_force_2.h"
#include "report_force_3.h"
#include "report_force_4.h"
#include "report_force_6.h"
#include "report_force_8.h"
#include "report_force_float_2.h"
#include "report_force_float_4.h"
#include "report_force_float_6.h"
#include "report_overlap_10.h"
#include "report_overlap_12.h"
#include "report_overlap_14.h"
#include "report_overlap_2.h"
#include "report_overlap_3.h"
#include "report_overlap_4.h"
#include "report_overlap_6.h"
#include "report_overlap_8.h"
#include "report_overlap_float_2.h"
#include "report_overlap_float_4.h"
#include "report_overlap_float_6.h"

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

/* From a speed by pow, as they are written today: no loop of which becomes vectors. */
#ifndef __AVX2__
#define X_overlap(NAME, CURVE, SETTING)                                                                                \
    FORM_OF(double, NAME##_speed, const double unit = scene->contact.beta_per_root, NAME(pow(g, 0.2) * unit))
#define X_force(NAME, CURVE, SETTING)                                                                                  \
    FORM_OF(double, NAME##_speed, const double unit = sqrt(scene->contact.beta_per_root), NAME(pow(g, 0.1) * unit))
APPROXIMANTS
#undef X_overlap
#undef X_force
#endif

/* CMakeLists.txt has the same list. */
#define HEADERS(X)                                                                                                     \
    X(double, 0, report_overlap_2, ZERO_OVERLAP, 1e-2)                                                                 \
    X(double, 0, report_overlap_3, ZERO_OVERLAP, 1e-3)                                                                 \
    X(double, 0, report_overlap_4, ZERO_OVERLAP, 1e-4)                                                                 \
    X(double, 0, report_overlap_6, ZERO_OVERLAP, 1e-6)                                                                 \
    X(double, 0, report_overlap_8, ZERO_OVERLAP, 1e-8)                                                                 \
    X(double, 0, report_overlap_10, ZERO_OVERLAP, 1e-10)                                                               \
    X(double, 0, report_overlap_12, ZERO_OVERLAP, 1e-12)                                                               \
    X(double, 0, report_overlap_14, ZERO_OVERLAP, 1e-14)                                                               \
    X(double, 0, report_force_2, ZERO_FORCE, 1e-2)                                                                     \
    X(double, 0, report_force_3, ZERO_FORCE, 1e-3)                                                                     \
    X(double, 0, report_force_4, ZERO_FORCE, 1e-4)                                                                     \
    X(double, 0, report_force_6, ZERO_FORCE, 1e-6)                                                                     \
    X(double, 0, report_force_8, ZERO_FORCE, 1e-8)                                                                     \
    X(double, 0, report_force_10, ZERO_FORCE, 1e-10)                                                                   \
    X(double, 0, report_force_12, ZERO_FORCE, 1e-12)                                                                   \
    X(double, 0, report_force_14, ZERO_FORCE, 1e-14)                                                                   \
    X(float, FLOAT, report_overlap_float_2, ZERO_OVERLAP, 1e-2)                                                        \
    X(float, FLOAT, report_overlap_float_4, ZERO_OVERLAP, 1e-4)                                                        \
    X(float, FLOAT, report_overlap_float_6, ZERO_OVERLAP, 1e-6)                                                        \
    X(float, FLOAT, report_force_float_2, ZERO_FORCE, 1e-2)                                                            \
    X(float, FLOAT, report_force_float_4, ZERO_FORCE, 1e-4)                                                            \
    X(float, FLOAT, report_force_float_6, ZERO_FORCE, 1e-6)
#define DEFINE(REAL, FLAG, NAME, END, TOLERANCE) FORM_OF(REAL, NAME, , NAME(g))
HEADERS(DEFINE)

static void add(struct methods *methods, struct method method, const char *curve)
{
    snprintf(method.curve, sizeof method.curve, "%s", curve);
    method.flags |= FORM;
    snprintf(method.name, sizeof method.name, "%s %s, %s%s", curve, method.setting, FLAGS, FORM ? ", loop" : "");
    methods_add(methods, &method);
}

void ADD(struct methods *methods)
{
    if (!AVAILABLE())
        return;
#define ROW(NAME, CURVE, SETTING, END, INPUT)                                                                          \
    add(methods,                                                                                                       \
        (struct method){.setting = SETTING,                                                                            \
                        .precision = "its own",                                                                        \
                        .end = END,                                                                                    \
                        .input = INPUT,                                                                                \
                        .each = NAME##_each,                                                                           \
                        .chain = CHAIN(NAME)},                                                                         \
        CURVE);
#define X_overlap(NAME, CURVE, SETTING) ROW(NAME##_beta, CURVE, SETTING, ZERO_OVERLAP, FROM_BETA)
#define X_force(NAME, CURVE, SETTING) ROW(NAME##_beta, CURVE, SETTING, ZERO_FORCE, FROM_BETA)
    APPROXIMANTS
#undef X_overlap
#undef X_force
#ifndef __AVX2__
#define X_overlap(NAME, CURVE, SETTING) ROW(NAME##_speed, CURVE, SETTING, ZERO_OVERLAP, FROM_SPEED)
#define X_force(NAME, CURVE, SETTING) ROW(NAME##_speed, CURVE, SETTING, ZERO_FORCE, FROM_SPEED)
    APPROXIMANTS
#endif

#define HEADER_ROW(REAL, FLAG, NAME, END, TOLERANCE)                                                                   \
    add(methods,                                                                                                       \
        (struct method){.setting = #TOLERANCE,                                                                         \
                        .precision = #TOLERANCE,                                                                       \
                        .scene = "ordinary",                                                                           \
                        .end = END,                                                                                    \
                        .tolerance = TOLERANCE,                                                                        \
                        .flags = FLAG,                                                                                 \
                        .each = NAME##_each,                                                                           \
                        .chain = CHAIN(NAME)},                                                                         \
        FLAG ? "scene header float" : "scene header");
    HEADERS(HEADER_ROW)
}
