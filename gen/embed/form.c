/* SPDX-License-Identifier: MIT */
#include "embed/form.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support/emit_c.h"

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

double embed_from_bits(const struct embed_form *f, uint64_t bits)
{
    const uint32_t low = (uint32_t)bits;
    float narrow;
    double wide;
    memcpy(&narrow, &low, sizeof narrow);
    memcpy(&wide, &bits, sizeof wide);
    return f->single ? (double)narrow : wide;
}

double embed_row_start(const struct embed_form *f, slong row)
{
    return embed_from_bits(f, (f->first + (uint64_t)row) << f->low_bits);
}

/* It counts its operations. */
struct arithmetic {
    bool single, fused;
    int count[OPERATIONS];
};

/* For +, -, *, / and sqrt of floats, an intermediate rounding to double does not change the result. */
static double rounded(struct arithmetic *a, enum embed_operation operation, double x)
{
    a->count[operation]++;
    return a->single ? (double)(float)x : x;
}

static double product(struct arithmetic *a, double x, double y)
{
    return rounded(a, OP_MUL, x * y);
}

/* x y + z */
static double mul_add(struct arithmetic *a, double x, double y, double z)
{
    if (!a->fused)
        return rounded(a, OP_MUL_ADD, (a->single ? (double)(float)(x * y) : x * y) + z);
    a->count[OP_MUL_ADD]++;
    return a->single ? (double)fmaf((float)x, (float)y, (float)z) : fma(x, y, z);
}

/* c[0] + c[step] x + ... + c[degree] x^(degree/step) */
static double horner(struct arithmetic *a, const double *c, slong degree, slong step, double x)
{
    double y = c[degree];
    for (slong k = degree - step; k >= 0; k -= step)
        y = mul_add(a, x, y, c[k]);
    if (degree >= step && c[degree] == 1) { /* a leading coefficient of 1 needs no product */
        a->count[OP_MUL_ADD]--;
        a->count[OP_ADD]++;
    }
    return y;
}

/* c_0 + c_2 x^2 + ... + x (c_1 + c_3 x^2 + ...) */
static double polynomial(struct arithmetic *a, const double *c, slong degree, double x, double square)
{
    if (degree < EMBED_SPLIT)
        return horner(a, c, degree, 1, x);
    const double even = horner(a, c, degree - degree % 2, 2, square);
    return mul_add(a, x, horner(a, c + 1, degree - 1 - (degree - 1) % 2, 2, square), even);
}

const double embed_root_coefficients[2][2][4] = {
    {{0.9999949028651255, 0.19999368411425256, 0.12170544636870924, 0.08960415657233971}, {1, 0.2, 0.12, 0.088}},
    {{(double)0.9999949028651255f, (double)0.19999368411425256f, (double)0.12170544636870924f,
      (double)0.08960415657233971f},
     {1, (double)0.2f, (double)0.12f, (double)0.088f}}};

static double root_start(struct arithmetic *a, const struct embed_form *f, double g)
{
    a->count[OP_BITS] += f->single ? 4 : 3; /* a division by 5 is a product and a shift */
    if (f->single)
        return embed_from_bits(f, EMBED_ROOT_SINGLE - (uint32_t)emit_bits_of(f->single, g) / 5);
    /* 2^52 + n holds the integer n in its low bits */
    const double top = embed_from_bits(f, (emit_bits_of(f->single, g) >> 32) | UINT64_C(0x4330000000000000));
    return embed_from_bits(f, emit_bits_of(f->single, mul_add(a, -EMBED_ROOT_FIFTH, top, EMBED_ROOT_CONSTANT)) << 32);
}

double embed_root_start(const struct embed_form *f, double g)
{
    return root_start(&(struct arithmetic){f->single, false, {0}}, f, g);
}

static double fifth_root(struct arithmetic *a, const struct embed_form *f, double g)
{
    double r = root_start(a, f, g), square;
    for (int k = 0; k < (f->refinement > 0 ? 2 : 1); k++) {
        square = product(a, r, r);
        const double off = mul_add(a, -product(a, g, r), product(a, square, square), 1);
        r = product(a, r, horner(a, embed_root_coefficients[f->single][k], k == 0 ? 3 : f->refinement, 1, off));
    }
    square = product(a, r, r);
    return product(a, g, product(a, square, square));
}

static double form_value(struct arithmetic *a, const struct embed_form *f, double speed)
{
    const slong m = f->numerator, n = f->denominator;
    const double above = speed > f->speed_min ? speed : f->speed_min;
    const double g = above < f->speed_max ? above : f->speed_max;
    const double *number = f->number;
    double x = embed_roots[f->variable].fifth ? fifth_root(a, f, g) : g, value;
    for (int k = 0; k < embed_roots[f->variable].square_roots; k++)
        x = rounded(a, OP_SQRT, sqrt(x));
    if (f->family == FAMILY_PIECES_SPEED) {
        const uint64_t row = emit_bits_of(f->single, g) >> f->low_bits;
        number += (slong)(row - f->first) * (m + 1);
        x = rounded(a, OP_ADD, g - embed_from_bits(f, row << f->low_bits));
        a->count[OP_BITS] += 3; /* shift, subtraction of the first row, and shift back */
    } else if (f->family == FAMILY_PIECES_BETA) {
        const double place = mul_add(a, x, f->slope, f->shift);
        const int row = (int)place;
        number += row * (m + 1);
        x = rounded(a, OP_ADD, place - row);
        a->count[OP_CONVERT] += 2;
    }
    if (f->rows > 0) {
        a->count[OP_LOAD] += (int)m + 1;
        value = horner(a, number, m, 1, x);
    } else {
        const double square = FLINT_MAX(m, n) >= EMBED_SPLIT ? product(a, x, x) : 0;
        value = polynomial(a, number, m, x, square);
        if (n > 0)
            value = rounded(a, OP_DIV, value / polynomial(a, number + m + 1, n, x, square));
    }
    const double whole = speed + f->origin;
    a->count[OP_ADD] += f->origin > 0;
    a->count[OP_COMPARE] += f->onset > 0 ? 4 : 3;
    return !(whole >= 0) ? (double)NAN : f->onset > 0 && whole <= f->onset ? f->before : value;
}

double embed_form_value(const struct embed_form *f, double speed, bool fused)
{
    return form_value(&(struct arithmetic){f->single, fused, {0}}, f, speed);
}

void embed_form_assess(struct embed_form *f, const struct embed_samples *samples, slong stride)
{
    f->error = 0;
    f->error_at = f->speed_min;
    for (slong i = 0; i < EMBED_SAMPLES; i += stride) {
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

void embed_form_price(struct embed_form *f)
{
    struct arithmetic a = {.single = f->single};
    const int *const n = a.count;
    form_value(&a, f, f->speed_min);
    memcpy(f->operations, n, sizeof f->operations);
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
