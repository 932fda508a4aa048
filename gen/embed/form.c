/* SPDX-License-Identifier: MIT */
#include "embed/form.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const embed_operation_names[OPERATIONS] = {"mul+add", "mul",  "add",     "div",    "sqrt",
                                                       "bits",    "load", "convert", "compare"};

/* Nanoseconds of an operation, for double and float, measured once (docs/embed.md, "Costs"): in a scalar loop (-O2),
 * and in a vectorised loop (-O3 -mavx2 -mfma). A square root may set errno, so that a loop with a square root stays
 * scalar without -fno-math-errno. */
static const double nanoseconds[2][USES][OPERATIONS] = {
    {{0.27, 0.14, 0.14, 1.11, 1.67, 0.10, 0, 0.51, 0.15}, {0.03, 0.03, 0.03, 0.56, 1.67, 0.07, 0.18, 0.11, 0.14}},
    {{0.27, 0.14, 0.14, 0.84, 0.90, 0.10, 0, 0.51, 0.15}, {0.02, 0.02, 0.01, 0.17, 0.90, 0.02, 0.23, 0.03, 0.02}},
};

void embed_form_clear(struct embed_form *f)
{
    free(f->number);
    f->number = NULL;
}

const char *embed_family_name(enum embed_family family, const struct embed_scene *s)
{
    static const char *const names[FAMILIES] = {
        "series in beta",          "Pade in beta",           "two-point Pade in beta", "polynomial in beta",
        "rational in beta",        "pieces in beta",         "pieces in speed",        "rational in speed",
        "rational in sqrt(speed)", "rational in speed^(1/4)"};
    static const char *const of_other_laws[FAMILIES] = {[FAMILY_POLYNOMIAL_BETA] = "polyn. in speed^(1/5)",
                                                        [FAMILY_RATIONAL_BETA] = "rational in speed^(1/5)",
                                                        [FAMILY_PIECES_BETA] = "pieces in speed^(1/5)"};
    return (law_is_sphere(&s->law) && !s->pressed) || !of_other_laws[family] ? names[family] : of_other_laws[family];
}

void embed_form_size(char *text, size_t size, const struct embed_form *f)
{
    if (f->rows > 0)
        snprintf(text, size, "%ld rows, degree %ld", (long)f->rows, (long)f->numerator);
    else if (f->denominator == 0)
        snprintf(text, size, "degree %ld", (long)f->numerator);
    else
        snprintf(text, size, "[%ld/%ld]", (long)f->numerator, (long)f->denominator);
}

const struct embed_root embed_roots[] = {[SPEED] = {1, false, 0},
                                         [SQRT_OF_SPEED] = {2, false, 1},
                                         [FOURTH_ROOT_OF_SPEED] = {4, false, 2},
                                         [FIFTH_ROOT_OF_SPEED] = {5, true, 0},
                                         [TENTH_ROOT_OF_SPEED] = {10, true, 1}};

double embed_root_error(int refinement, bool single)
{
    static const double error[EMBED_REFINEMENTS] = {2.33e-5, 3.9e-10, 8.6e-15, 1.3e-15};
    return fmax(error[refinement], single ? 7e-7 : 0);
}

/* ---- the arithmetic of the header ---- */

/* For +, -, *, / and sqrt of floats, an intermediate rounding to double does not change the result. */
static double form_rounded(const struct embed_form *f, double x)
{
    return f->single ? (double)(float)x : x;
}

static double form_product(const struct embed_form *f, double x, double y)
{
    return form_rounded(f, x * y);
}

/* x y + z */
static double mul_add(const struct embed_form *f, double x, double y, double z, bool fused)
{
    if (!fused)
        return form_rounded(f, form_rounded(f, x * y) + z);
    return f->single ? (double)fmaf((float)x, (float)y, (float)z) : fma(x, y, z);
}

uint64_t embed_bits_of(const struct embed_form *f, double x)
{
    if (f->single) {
        const float y = (float)x;
        uint32_t bits;
        memcpy(&bits, &y, sizeof bits);
        return bits;
    }
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

double embed_from_bits(const struct embed_form *f, uint64_t bits)
{
    if (f->single) {
        const uint32_t low = (uint32_t)bits;
        float y;
        memcpy(&y, &low, sizeof y);
        return (double)y;
    }
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* c[0] + c[step] x + ... + c[degree] x^(degree/step) */
static double form_horner(const struct embed_form *f, const double *c, slong degree, slong step, double x, bool fused)
{
    double y = c[degree];
    for (slong k = degree - step; k >= 0; k -= step)
        y = mul_add(f, x, y, c[k], fused);
    return y;
}

/* c_0 + c_2 x^2 + ... + x (c_1 + c_3 x^2 + ...) */
static double form_split_polynomial(const struct embed_form *f, const double *c, slong degree, double x, bool fused)
{
    if (degree < EMBED_SPLIT)
        return form_horner(f, c, degree, 1, x, fused);
    const double square = form_product(f, x, x);
    const double even = form_horner(f, c, degree - degree % 2, 2, square, fused);
    return mul_add(f, x, form_horner(f, c + 1, degree - 1 - (degree - 1) % 2, 2, square, fused), even, fused);
}

struct embed_root_coefficients embed_root_coefficients(const struct embed_form *f, int step)
{
    static const struct embed_root_coefficients known[] = {
        {{0.9999949028651255, 0.19999368411425256, 0.12170544636870924, 0.08960415657233971}}, {{1, 0.2, 0.12, 0.088}}};
    struct embed_root_coefficients rounded = known[step];
    for (int i = 0; i < 4; i++)
        rounded.c[i] = form_rounded(f, rounded.c[i]);
    return rounded;
}

double embed_root_start(const struct embed_form *f, double g, bool fused)
{
    if (f->single)
        return embed_from_bits(f, EMBED_ROOT_SINGLE - (uint32_t)embed_bits_of(f, g) / 5);
    /* 2^52 + n holds the integer n in its low bits */
    const double top = embed_from_bits(f, (embed_bits_of(f, g) >> 32) | UINT64_C(0x4330000000000000));
    return embed_from_bits(f, embed_bits_of(f, mul_add(f, -EMBED_ROOT_FIFTH, top, EMBED_ROOT_CONSTANT, fused)) << 32);
}

static double fifth_root(const struct embed_form *f, double g, bool fused)
{
    double r = embed_root_start(f, g, fused);
    for (int k = 0; k < (f->refinement > 0 ? 2 : 1); k++) {
        const double square = form_product(f, r, r), fourth = form_product(f, square, square);
        const double e = mul_add(f, -form_product(f, g, r), fourth, 1, fused);
        const double series = form_horner(f, embed_root_coefficients(f, k).c, k == 0 ? 3 : f->refinement, 1, e, fused);
        r = form_product(f, r, series);
    }
    const double square = form_product(f, r, r);
    return form_product(f, g, form_product(f, square, square));
}

double embed_form_value(const struct embed_form *f, double speed, bool fused)
{
    const double above = speed > f->speed_min ? speed : f->speed_min;
    const double g = above < f->speed_max ? above : f->speed_max;
    double x = embed_roots[f->variable].fifth ? fifth_root(f, g, fused) : g;
    for (int k = 0; k < embed_roots[f->variable].square_roots; k++)
        x = form_rounded(f, sqrt(x));
    double value;
    const double *number = f->number;
    if (f->family == FAMILY_PIECES_SPEED) {
        const uint64_t row = embed_bits_of(f, g) >> f->low_bits;
        number += (slong)(row - f->first) * (f->numerator + 1);
        x = form_rounded(f, g - embed_from_bits(f, row << f->low_bits));
    } else if (f->family == FAMILY_PIECES_BETA) {
        const double place = mul_add(f, x, f->slope, f->shift, fused);
        const int row = (int)place;
        number += row * (f->numerator + 1);
        x = form_rounded(f, place - row);
    }
    if (f->rows > 0)
        value = form_horner(f, number, f->numerator, 1, x, fused);
    else
        value = form_split_polynomial(f, number, f->numerator, x, fused);
    if (f->denominator > 0)
        value = form_rounded(f, value / form_split_polynomial(f, number + f->numerator + 1, f->denominator, x, fused));
    const double whole = speed + f->origin;
    return !(whole >= 0) ? (double)NAN : f->onset > 0 && whole <= f->onset ? f->before : value;
}

void embed_form_assess(struct embed_form *f, const struct embed_samples *samples, slong stride)
{
    f->error = 0;
    f->error_at = f->speed_min;
    for (slong i = 0; i < samples->count; i += stride) {
        for (int fused = 0; fused < 2; fused++) {
            const double value = embed_form_value(f, samples->speed[i], fused);
            const double error = fabs(((value - samples->eps[i]) - samples->rest[i]) / samples->eps[i]);
            if (!(error <= f->error)) { /* true for NaN, too */
                f->error = isnan(error) ? INFINITY : error;
                f->error_at = samples->speed[i];
            }
        }
    }
}

/* ---- costs ---- */

double embed_cost(const double cost[USES], enum embed_purpose purpose)
{
    return purpose == PURPOSE_SCALAR  ? cost[USE_SCALAR]
           : purpose == PURPOSE_ARRAY ? cost[USE_ARRAY]
                                      : (cost[USE_SCALAR] + 4 * cost[USE_ARRAY]) / 5;
}

static void count_root(int *n, const struct embed_form *f)
{
    const int steps = f->refinement > 0 ? 2 : 1;
    n[OP_BITS] += f->single ? 4 : 3; /* a division by 5 is a product and a shift */
    n[OP_MUL_ADD] += f->single ? 0 : 1;
    n[OP_MUL] += 4 * steps + 3; /* each step has r^2, r^4, g r and a last product; the end has r^2, r^4, g r^4 */
    n[OP_MUL_ADD] += steps + 3 + f->refinement;
}

void embed_form_price(struct embed_form *f)
{
    int *n = f->operations;
    memset(n, 0, sizeof f->operations);
    n[OP_COMPARE] = f->onset > 0 ? 4 : 3;
    n[OP_ADD] = f->origin > 0 ? 1 : 0;
    n[OP_SQRT] = embed_roots[f->variable].square_roots;
    if (embed_roots[f->variable].fifth)
        count_root(n, f);
    if (f->rows > 0) {
        n[OP_LOAD] += (int)f->numerator + 1;
        n[OP_BITS] += f->family == FAMILY_PIECES_SPEED ? 3 : 0; /* shift, subtraction of the first row, and shift
                                                                 * back */
        n[OP_CONVERT] += f->family == FAMILY_PIECES_BETA ? 2 : 0;
        n[OP_MUL_ADD] += f->family == FAMILY_PIECES_BETA ? 1 : 0;
        n[OP_ADD] += 1;
    }
    n[OP_MUL_ADD] += (int)(f->numerator + f->denominator);
    if (f->rows == 0 && FLINT_MAX(f->numerator, f->denominator) >= EMBED_SPLIT)
        n[OP_MUL]++;
    /* a leading coefficient of 1 needs no product */
    if (f->denominator > 0 && f->number && f->number[f->numerator + f->denominator + 1] == 1) {
        n[OP_MUL_ADD]--;
        n[OP_ADD]++;
    }
    if (f->denominator > 0)
        n[OP_DIV] += 1;
    for (int use = 0; use < USES; use++) {
        /* an operation that prevents vectorisation makes all other operations scalar */
        const int as = use == USE_ARRAY && n[OP_SQRT] > 0 ? USE_SCALAR : use;
        const double *ns = nanoseconds[f->single][as];
        /* division and square root have a separate unit, which works in parallel to the others */
        const double beside = n[OP_DIV] * ns[OP_DIV] + n[OP_SQRT] * ns[OP_SQRT];
        double sum = 0;
        for (int op = 0; op < OPERATIONS; op++)
            sum += op == OP_DIV || op == OP_SQRT ? 0 : n[op] * ns[op];
        f->cost[use] = fmax(sum, beside);
    }
}
