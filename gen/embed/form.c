/* SPDX-License-Identifier: MIT */
#include "embed/form.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support/emit_c.h"

const char *const embed_operation_names[OPERATIONS] = {"mul+add", "mul",  "add",     "div",    "sqrt",
                                                       "bits",    "load", "convert", "compare"};

/* Nanoseconds of an operation, for double and float, in a scalar loop (-O2) and in a vectorised loop (-O3 -mavx2
 * -mfma). Measured once (docs/embed.md, "Costs"). A square root may set errno, so compilers do not vectorise a loop
 * with a square root unless -fno-math-errno is given. */
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
    return f->knot ? f->knot[row] : embed_from_bits(f, (f->first + (uint64_t)row) << f->low_bits);
}

static const double root_coefficients[2][2][4] = {
    {{0.9999949028651255, 0.19999368411425256, 0.12170544636870924, 0.08960415657233971}, {1, 0.2, 0.12, 0.088}},
    {{(double)0.9999949028651255f, (double)0.19999368411425256f, (double)0.12170544636870924f,
      (double)0.08960415657233971f},
     {1, (double)0.2f, (double)0.12f, (double)0.088f}}};

/* ---- the program of a form ---- */

static int add_step(struct embed_program *p, enum embed_code code, const char *name, int x, int y, int z)
{
    p->step[p->count] = (struct embed_step){code, name, x, y, z, NULL, 0, 0};
    return p->count++;
}

static int add_horner(struct embed_program *p, const char *name, int x, const double *c, slong degree, slong stride)
{
    p->step[p->count] = (struct embed_step){STEP_HORNER, name, x, 0, 0, c, degree - degree % stride, stride};
    return p->count++;
}

/* Adds the steps of r = g^(-1/5), which refine the start value once or twice. Returns the step of g r^4 = g^(1/5). */
static int add_fifth_root(struct embed_program *p, const struct embed_form *f, const char *name)
{
    static const char *const names[2][5] = {{"square_1", "fourth_1", "g * guess", "off_1", "factor_1"},
                                            {"square_2", "fourth_2", "g * better", "off_2", "factor_2"}};
    int r = add_step(p, STEP_START, "guess", 0, 0, 0), square;
    for (int k = 0; k < (f->refinement > 0 ? 2 : 1); k++) {
        square = add_step(p, STEP_MUL, names[k][0], r, r, 0);
        const int fourth = add_step(p, STEP_MUL, names[k][1], square, square, 0);
        const int off = add_step(p, STEP_OFF, names[k][3], add_step(p, STEP_MUL, names[k][2], 0, r, 0), fourth, 0);
        add_horner(p, names[k][4], off, root_coefficients[f->single][k], k == 0 ? 3 : f->refinement, 1);
        r = add_step(p, STEP_MUL, k == 0 && f->refinement > 0 ? "better" : "inverse", r, off + 1, 0);
    }
    square = add_step(p, STEP_MUL, "square", r, r, 0);
    return add_step(p, STEP_MUL, name, 0, add_step(p, STEP_MUL, "(square * square)", square, square, 0), 0);
}

/* Adds a polynomial in the value of step x. If its degree is EMBED_SPLIT or more, its even and odd parts are separate,
 * and step x + 1 must be x^2. names: the polynomial and the two parts */
static int add_polynomial(struct embed_program *p, const char *const names[3], int x, const double *c, slong degree)
{
    if (degree < EMBED_SPLIT)
        return add_horner(p, names[0], x, c, degree, 1);
    const int even = add_horner(p, names[1], x + 1, c, degree, 2);
    return add_step(p, STEP_MUL_ADD, names[0], x, add_horner(p, names[2], x + 1, c + 1, degree - 1, 2), even);
}

struct embed_program embed_program_of(const struct embed_form *f)
{
    static const char *const eps[] = {"eps", "eps_even", "eps_odd"}, *const above[] = {"p", "p_even", "p_odd"},
                             *const below[] = {"q", "q_even", "q_odd"};
    const struct embed_root *const root = &embed_roots[f->variable];
    const slong m = f->numerator, n = f->denominator;
    struct embed_program program = {.count = 0}, *const p = &program;
    int x = add_step(p, STEP_CLAMP, "g", 0, 0, 0);
    if (root->fifth)
        x = add_fifth_root(p, f, root->square_roots > 0 ? "y" : "x");
    for (int left = root->square_roots; left > 0; left--)
        x = add_step(p, STEP_SQRT, left > 1 ? "half" : "x", x, 0, 0);
    p->x = x;
    if (f->rows > 0)
        x = add_step(p,
                     f->knot                            ? STEP_ROW_OF_SEARCH
                     : f->family == FAMILY_PIECES_SPEED ? STEP_ROW_OF_BITS
                                                        : STEP_ROW_OF_PLACE,
                     "t", x, 0, 0);
    p->argument = x;
    if (f->rows > 0) {
        p->p = add_horner(p, "eps", x, NULL, m, 1);
        return program;
    }
    if (FLINT_MAX(m, n) >= EMBED_SPLIT)
        add_step(p, STEP_MUL, "xx", x, x, 0);
    p->p = add_polynomial(p, n > 0 ? above : eps, x, f->number, m);
    if (n > 0) {
        p->q = add_polynomial(p, below, x, f->number + m + 1, n);
        add_step(p, STEP_DIV, "p / q", p->p, p->q, 0);
    }
    return program;
}

/* ---- its values ---- */

/* Counts the operations. */
struct arithmetic {
    bool single, fused;
    int count[OPERATIONS];
};

/* Counts an operation and rounds its result. For floats, + - * / and sqrt may be rounded to double first, which gives
 * the same float. */
static double round_result(struct arithmetic *a, enum embed_operation operation, double x)
{
    a->count[operation]++;
    return a->single ? (double)(float)x : x;
}

/* Returns x y + z */
static double mul_add(struct arithmetic *a, double x, double y, double z)
{
    if (!a->fused)
        return round_result(a, OP_MUL_ADD, (a->single ? (double)(float)(x * y) : x * y) + z);
    a->count[OP_MUL_ADD]++;
    return a->single ? (double)fmaf((float)x, (float)y, (float)z) : fma(x, y, z);
}

static double evaluate_horner(struct arithmetic *a, const struct embed_step *s, const double *c, double x)
{
    double y = c[s->degree];
    for (slong k = s->degree - s->stride; k >= 0; k -= s->stride)
        y = mul_add(a, x, y, c[k]);
    if (s->degree >= s->stride && c[s->degree] == 1) { /* a leading coefficient of 1 needs no product */
        a->count[OP_MUL_ADD]--;
        a->count[OP_ADD]++;
    }
    return y;
}

static double root_start(struct arithmetic *a, const struct embed_form *f, double g)
{
    a->count[OP_BITS] += f->single ? 4 : 3; /* compilers replace a division by 5 by a product and a shift */
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

/* Computes a step from the values of the earlier steps. A step that finds a row of a table sets *row. */
static double step_value(struct arithmetic *a, const struct embed_form *f, const struct embed_step *s,
                         const double *value, slong *row)
{
    const double x = value[s->x], y = value[s->y];
    const uint64_t upper = emit_bits_of(f->single, x) >> f->low_bits;
    double place;
    switch (s->code) {
    case STEP_CLAMP:
        a->count[OP_COMPARE] += 2;
        place = x > f->speed_min ? x : f->speed_min;
        return place < f->speed_max ? place : f->speed_max;
    case STEP_START:
        return root_start(a, f, x);
    case STEP_ROW_OF_BITS:
        a->count[OP_BITS] += 3; /* counts a shift, the subtraction of the first row, and a shift back */
        *row = (slong)(upper - f->first);
        return round_result(a, OP_ADD, x - embed_from_bits(f, upper << f->low_bits));
    case STEP_ROW_OF_SEARCH:
        for (*row = 0; *row + 1 < f->rows && x >= f->knot[*row + 1];)
            ++*row;
        for (slong left = f->rows; left > 1; left /= 2)
            a->count[OP_COMPARE]++;
        return round_result(a, OP_ADD, x - f->knot[*row]);
    case STEP_ROW_OF_PLACE:
        a->count[OP_CONVERT] += 2;
        place = mul_add(a, x, f->slope, f->shift);
        *row = (int)place;
        return round_result(a, OP_ADD, place - (double)*row);
    case STEP_SQRT:
        return round_result(a, OP_SQRT, sqrt(x));
    case STEP_HORNER:
        a->count[OP_LOAD] += s->c ? 0 : (int)s->degree + 1;
        return evaluate_horner(a, s, s->c ? s->c : f->number + *row * (s->degree + 1), x);
    case STEP_DIV:
        return round_result(a, OP_DIV, x / y);
    case STEP_MUL:
        return round_result(a, OP_MUL, x * y);
    case STEP_MUL_ADD:
        return mul_add(a, x, y, value[s->z]);
    default: /* STEP_OFF */
        return mul_add(a, -x, y, 1);
    }
}

static double form_value(struct arithmetic *a, const struct embed_form *f, const struct embed_program *p, double speed)
{
    double value[EMBED_STEPS] = {speed};
    slong row = 0;
    for (int i = 0; i < p->count; i++)
        value[i] = step_value(a, f, &p->step[i], value, &row);
    const double whole = speed + f->origin;
    a->count[OP_ADD] += f->origin > 0;
    a->count[OP_COMPARE] += f->onset > 0 ? 2 : 1;
    return !(whole >= 0) ? (double)NAN : f->onset > 0 && whole <= f->onset ? f->before : value[p->count - 1];
}

double embed_form_value(const struct embed_form *f, double speed, bool fused)
{
    const struct embed_program p = embed_program_of(f);
    return form_value(&(struct arithmetic){f->single, fused, {0}}, f, &p, speed);
}

void embed_form_assess(struct embed_form *f, const struct embed_samples *samples, slong stride)
{
    const struct embed_program p = embed_program_of(f);
    f->error = 0;
    f->error_at = f->speed_min;
    for (slong i = 0; i < EMBED_SAMPLES; i += stride) {
        for (int fused = 0; fused < 2; fused++) {
            struct arithmetic a = {f->single, fused, {0}};
            const double value = form_value(&a, f, &p, samples->speed[i]);
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
    return purpose == PURPOSE_BALANCED ? (cost[USE_SCALAR] + 4 * cost[USE_ARRAY]) / 5
                                       : cost[purpose == PURPOSE_ARRAY ? USE_ARRAY : USE_SCALAR];
}

void embed_form_price(struct embed_form *f)
{
    struct arithmetic a = {.single = f->single};
    const struct embed_program p = embed_program_of(f);
    const int *const n = a.count;
    form_value(&a, f, &p, f->speed_min);
    memcpy(f->operations, n, sizeof f->operations);
    for (int use = 0; use < USES; use++) {
        /* one operation that prevents vectorisation makes all operations of the loop scalar */
        const int as = use == USE_ARRAY && (n[OP_SQRT] > 0 || f->knot) ? USE_SCALAR : use;
        const double *ns = nanoseconds[f->single][as];
        /* division and square root have a separate unit, which works in parallel with the others */
        const double beside = n[OP_DIV] * ns[OP_DIV] + n[OP_SQRT] * ns[OP_SQRT];
        double sum = 0;
        for (int op = 0; op < OPERATIONS; op++)
            sum += op == OP_DIV || op == OP_SQRT ? 0 : n[op] * ns[op];
        f->cost[use] = fmax(sum, beside);
    }
}
