/* SPDX-License-Identifier: MIT */
/* cor_sphere.h: restitution coefficient, duration and largest overlap of colliding viscoelastic spheres,
 * x'' + beta sqrt(x) x' + x^(3/2) = 0, both ends of contact, for every beta, as one header to embed.
 * C99, C++11, CUDA and HIP. Needs sqrt, cbrt, log and fabs of math.h, memcpy, IEEE doubles.
 *
 *     double cor_inline_eps_zero_overlap(double beta);            also _zero_force
 *     double cor_inline_loss_zero_overlap(double beta);           1 - eps; also _zero_force
 *     double cor_inline_duration_zero_overlap(double beta);       in units of (rho/m)^(-2/5) g^(-1/5);
 *                                                                 also _zero_force
 *     double cor_inline_max_overlap(double beta);                 in units of (rho/m)^(-2/5) g^(4/5)
 *     double cor_inline_time_of_max_overlap(double beta);         units as the duration
 *     double cor_inline_beta_zero_overlap(double eps);            the inverse; also _zero_force
 *     double cor_inline_eps_zero_overlap_root(double x);          at beta = x^(1/5), the fast way from an
 *                                                                 impact speed g: x = beta_per_root^5 g,
 *                                                                 beta_per_root = (3/2) A (rho/m)^(2/5);
 *                                                                 also _zero_force
 *
 * The same evaluator and tables as libcor, where domain, special values and accuracy are documented
 * (include/cor/sphere.h): eps, loss and largest overlap within 1 unit of the last place, times and inverse
 * within 2: proved for every double, if log is within 1 unit and cbrt within 64 (docs/theory.md, 8 and 18);
 * eps at a speed within (2 + 2 kappa) 2^-53, kappa = |d ln eps/d ln beta|: proved for an x with two rounding
 * errors (18). beta = 0 -> 1, +inf -> 0 (eps); negative or NaN -> NaN. Any flags are safe: no argument leads
 * beyond a table, and -ffast-math and -march=native change a result by 4 units at most (sampled).
 * Zero overlap ends the contact when x = 0 again, zero force when x'' = 0.
 *
 * Rows of short polynomials around the nodes of uniform grids, and what follows at large beta. Each double
 * is the one nearest to its coefficient: proved; corgen tables --digits prints 25 digits of each. Errors of
 * the rows stand above each table, those of the formulas for large beta above the formulas, proved for every
 * argument (docs/theory.md, 8). The rows interpolate polynomials of high degree through collisions enclosed
 * to 76 bits or more (proved). Source: docs/theory.md, 4 to 6 and 8; form: docs/internals.md.
 *
 * Written by:  corgen tables
 * Checked by:  corgen tables --check */
#ifndef COR_SPHERE_EMBEDDED_H
#define COR_SPHERE_EMBEDDED_H

#ifndef COR_SPHERE_ROWS_ONLY /* libcor takes the rows alone */
/* The includes and the attribute with which C99, C++11, CUDA and HIP compile a function into its caller. */
#ifndef COR_INLINE

#if defined(__CUDACC__) || defined(__HIPCC__)
#define COR_INLINE __host__ __device__ static inline
#else
#define COR_INLINE static inline
#endif

#include <math.h>
#include <stdint.h>
#include <string.h>

#endif

/* Bits of doubles, and sums and products with their rounding errors.
 *
 * The functions classify arguments by their bits, as integers. Floating-point comparisons raise FE_INVALID for a NaN,
 * and -ffinite-math-only lets a compiler assume that no NaN occurs. A bit mask splits a factor. Veltkamp's
 * multiplication would give wrong results where a compiler fuses multiplications with additions. */
#ifndef COR_RUNTIME_PAIR_H
#define COR_RUNTIME_PAIR_H


/* Powers of two, in decimal because hexadecimal constants need C++17. */
#define COR_INLINE_2_M900 1.18305218616677471e-271
#define COR_INLINE_2_M574 1.61726984478087796e-173
#define COR_INLINE_2_M500 3.05493636349960468e-151
#define COR_INLINE_2_M300 4.90909346529772656e-91
#define COR_INLINE_2_M200 6.22301527786114171e-61
#define COR_INLINE_2_M60 8.67361737988403547e-19
#define COR_INLINE_2_M40 9.09494701772928238e-13
#define COR_INLINE_2_40 1.09951162777600000e+12
#define COR_INLINE_2_60 1.15292150460684698e+18
#define COR_INLINE_2_100 1.26765060022822940e+30
#define COR_INLINE_2_200 1.60693804425899028e+60
#define COR_INLINE_2_250 1.80925139433306555e+75
#define COR_INLINE_2_300 2.03703597633448609e+90
#define COR_INLINE_2_500 3.27339060789614187e+150
#define COR_INLINE_2_600 4.14951556888099296e+180
#define COR_INLINE_2_900 8.45271249817064394e+270
#define COR_INLINE_2_964 1.55925024182399985e+290
#define COR_INLINE_2_1000 1.07150860718626732e+301

/* Keeps -ffast-math from rearranging a value: otherwise (a + b) - a becomes b. */
#if defined(__has_builtin) && !defined(__CUDACC__) && !defined(__HIPCC__)
#if __has_builtin(__builtin_assoc_barrier)
#define COR_INLINE_KEEP(x) __builtin_assoc_barrier(x)
#elif __has_builtin(__arithmetic_fence) && defined(__FAST_MATH__)
#define COR_INLINE_KEEP(x) __arithmetic_fence(x)
#endif
#endif
#ifndef COR_INLINE_KEEP
#define COR_INLINE_KEEP(x) (x)
#endif

COR_INLINE uint64_t cor_inline_bits(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

COR_INLINE double cor_inline_from_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Whether 0 <= x < end; false for -0 and NaN. The bits of nonnegative doubles, read as integers, have the order of the
 * doubles. The bits of negative doubles are larger. */
COR_INLINE int cor_inline_below(double x, double end)
{
    return cor_inline_bits(x) < cor_inline_bits(end);
}

/* Whether least <= x < end; false for NaN. The unsigned difference is huge for negative numbers and for numbers below
 * `least`. */
COR_INLINE int cor_inline_between(double x, double least, double end)
{
    return cor_inline_bits(x) - cor_inline_bits(least) < cor_inline_bits(end) - cor_inline_bits(least);
}

#define COR_INLINE_INFINITY_BITS UINT64_C(0x7ff0000000000000)
#define COR_INLINE_SIGN_BIT UINT64_C(0x8000000000000000)

COR_INLINE double cor_inline_infinity(void)
{
    return cor_inline_from_bits(COR_INLINE_INFINITY_BITS);
}

COR_INLINE double cor_inline_nan(void)
{
    return cor_inline_from_bits(UINT64_C(0x7ff8000000000000));
}

/* The float nearest to x, without FE_OVERFLOW: a factor, because clang converts both x and what stands for it before it
 * chooses */
COR_INLINE float cor_inline_narrow(double x)
{
    const double beyond = 3.40282356779733662e+38; /* halfway between the largest float and 2^128 */
    const int fits = cor_inline_below(x, beyond) || cor_inline_bits(x) > COR_INLINE_INFINITY_BITS;
    return (float)(x * (fits ? 1 : cor_inline_infinity()));
}

COR_INLINE int cor_inline_is_zero(double x)
{
    return (cor_inline_bits(x) & ~COR_INLINE_SIGN_BIT) == 0;
}

COR_INLINE int cor_inline_is_finite(double x)
{
    return (cor_inline_bits(x) & ~COR_INLINE_SIGN_BIT) < COR_INLINE_INFINITY_BITS;
}

COR_INLINE int cor_inline_is_nan(double x)
{
    return (cor_inline_bits(x) & ~COR_INLINE_SIGN_BIT) > COR_INLINE_INFINITY_BITS;
}

/* Whether x is negative or NaN; -0 is neither. */
COR_INLINE int cor_inline_is_refused(double x)
{
    return cor_inline_bits(x) > COR_INLINE_INFINITY_BITS && cor_inline_bits(x) != COR_INLINE_SIGN_BIT;
}

/* if_true or if_false, selected by bits. A processor would mispredict half of the jumps for scattered arguments. */
COR_INLINE double cor_inline_choose(int choice, double if_true, double if_false)
{
    const uint64_t mask = (uint64_t)0 - (uint64_t)(choice != 0);
    return cor_inline_from_bits((cor_inline_bits(if_true) & mask) | (cor_inline_bits(if_false) & ~mask));
}

/* 2^k, -1022 <= k <= 1023 */
COR_INLINE double cor_inline_power_of_two(int k)
{
    return cor_inline_from_bits((uint64_t)(1023 + k) << 52);
}

/* The exponent e of a normal x, 2^e <= |x| < 2^(e+1), and x 2^-e without its sign */
COR_INLINE int cor_inline_exponent(double x)
{
    return (int)((cor_inline_bits(x) >> 52) & 2047) - 1023;
}

COR_INLINE double cor_inline_significand(double x)
{
    return cor_inline_from_bits((cor_inline_bits(x) & UINT64_C(0xfffffffffffff)) | UINT64_C(0x3ff0000000000000));
}

/* x times a power of two that leaves a normal number, x > 0. The bits of a subnormal x count its units of 2^-1074, also
 * where the processor flushes such numbers to 0. */
COR_INLINE double cor_inline_raised(double x, double power)
{
    if (cor_inline_bits(x) >> 52 != 0)
        return x * power;
    return (double)cor_inline_bits(x) * COR_INLINE_2_M574 * (power * COR_INLINE_2_M500);
}

/* x 2^k for 2^-60 < |x| < 2^60 and k <= 960, rounded once. Unlike ldexp, this function does not set errno. */
COR_INLINE double cor_inline_scaled(double x, int k)
{
    if (k >= -960)
        return x * cor_inline_power_of_two(k);
    /* the first product is a normal number, and exact */
    k += 900;
    return x * COR_INLINE_2_M900 * cor_inline_power_of_two(k < -1022 ? -1022 : k);
}

/* The 26 leading bits: products of two such numbers are exact. */
COR_INLINE double cor_inline_head(double x)
{
    return cor_inline_from_bits(cor_inline_bits(x) & UINT64_C(0xfffffffff8000000));
}

/* The unevaluated sum hi + lo; |lo| is of the order of hi's last place. */
struct cor_inline_pair {
    double hi, lo;
};

COR_INLINE struct cor_inline_pair cor_pair(double hi, double lo)
{
    struct cor_inline_pair x;
    x.hi = hi;
    x.lo = lo;
    return x;
}

/* hi + lo as a pair, exact where |hi| >= |lo| */
COR_INLINE struct cor_inline_pair cor_inline_sum(double hi, double lo)
{
    struct cor_inline_pair sum;
    sum.hi = COR_INLINE_KEEP(hi + lo);
    sum.lo = lo - COR_INLINE_KEEP(sum.hi - hi);
    return sum;
}

/* x + y exactly, for x and y in any order */
COR_INLINE struct cor_inline_pair cor_pair_two_sum(double x, double y)
{
    const double hi = COR_INLINE_KEEP(x + y), part = COR_INLINE_KEEP(hi - x);
    return cor_pair(hi, COR_INLINE_KEEP(x - COR_INLINE_KEEP(hi - part)) + COR_INLINE_KEEP(y - part));
}

/* x y with relative error 2^-104, if nothing underflows */
COR_INLINE struct cor_inline_pair cor_inline_product(double x, double y)
{
    const double xh = cor_inline_head(x), xl = x - xh, yh = cor_inline_head(y), yl = y - yh;
    struct cor_inline_pair product;
    product.hi = COR_INLINE_KEEP(x * y);
    product.lo = COR_INLINE_KEEP(COR_INLINE_KEEP(xh * yh - product.hi) + xh * yl + xl * yh) + xl * yl;
    return product;
}

/* The relative error of the next two functions is a few 2^-104. */
COR_INLINE struct cor_inline_pair cor_inline_pair_times(struct cor_inline_pair x, struct cor_inline_pair y)
{
    const struct cor_inline_pair p = cor_inline_product(x.hi, y.hi);
    return cor_inline_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

COR_INLINE struct cor_inline_pair cor_inline_pair_over(struct cor_inline_pair x, struct cor_inline_pair y)
{
    const double q = x.hi / y.hi;
    const struct cor_inline_pair p = cor_inline_product(q, y.hi);
    return cor_inline_sum(q, (COR_INLINE_KEEP(COR_INLINE_KEEP(x.hi - p.hi) - p.lo) + (x.lo - q * y.lo)) / y.hi);
}

/* ln(x) of a normal, finite x >= 1. The absolute error is below 2^-53, or below 2^-53 ln(x) for large x, if that of
 * log is below 1 ulp. */
COR_INLINE struct cor_inline_pair cor_inline_log(double x)
{
    /* ln(2) in two parts; the first has 42 bits, so that its products with exponents are exact */
    const double ln2_hi = 0.69314718055989033, ln2_lo = 5.4979230187083712e-14;
    /* significands above sqrt(2) are halved, so that |ln(m)| < 0.35: error 2^-54 */
    const double half = cor_inline_significand(x);
    const int up = half > 1.4142135623730951, e = cor_inline_exponent(x) + up;
    return cor_inline_sum(e * ln2_hi, e * ln2_lo + log(up ? half * 0.5 : half));
}

#endif

/* x^(1/5) without pow, branches or a table, so that compilers vectorise loops over it. */
#ifndef COR_RUNTIME_FIFTH_ROOT_H
#define COR_RUNTIME_FIFTH_ROOT_H


/* (1 + d)^(1/5) - 1 up to d^4 for |d| < 4e-4; the next term is below 2^-59. */
COR_INLINE double cor_inline_fifth_root_rest(double d)
{
    return d * ((0.2 - 0.08 * d) + (d * d) * (0.048 - 0.0336 * d));
}

/* x^(1/5) = head + tail for 2^-1000 <= x <= 2^1000; the head has 26 bits, |tail/head| < 2^-12. Relative error of the
 * sum, before it is rounded: 0.5 2^-53, measured in tests/unit/test_fifth_root.c. */
COR_INLINE struct cor_inline_pair cor_inline_fifth_root_parts(double x)
{
    /* The bits as one integer, divided by five, give a fifth of the exponent and of the fraction: the seed is within
     * 3.4 %. The double 2^52 + n holds the integer n in its low bits. */
    const double two52 = 4503599627370496.0;
    const uint64_t top = (cor_inline_bits(x) >> 32) | UINT64_C(0x4330000000000000);
    const double fifth = cor_inline_from_bits(top) * 0.2 + (0.8 * two52 + 858116000.0);
    const double seed = cor_inline_from_bits(cor_inline_bits(fifth) << 32);

    /* A step of Halley's method for r^5 = x turns the relative error e into 2 e^3, 8e-5 here. */
    const double seed2 = seed * seed, seed5 = seed2 * seed2 * seed;
    const double halley = seed + seed * COR_INLINE_KEEP((x - seed5) / (2 * x + 3 * seed5));

    /* With r cut to 26 bits, r^2 is exact, and r^5 has two rounding errors, of which a fifth reaches the root. x - r^5
     * is exact. */
    const double r = cor_inline_head(halley), r2 = r * r, r5 = COR_INLINE_KEEP(r2 * r2 * r);
    struct cor_inline_pair root;
    root.hi = r;
    root.lo = r * cor_inline_fifth_root_rest(COR_INLINE_KEEP((x - r5) / r5));
    return root;
}

/* The fifth root of a pair; relative error below 2^-58, because r^5 and the difference are pairs too. */
COR_INLINE struct cor_inline_pair cor_inline_fifth_root_of_pair(struct cor_inline_pair x)
{
    struct cor_inline_pair root = cor_inline_fifth_root_parts(x.hi), r, r5;
    r.hi = root.hi;
    r.lo = 0;
    r5 = cor_inline_pair_times(cor_inline_product(r.hi * r.hi, r.hi * r.hi), r);
    const double d = (COR_INLINE_KEEP(COR_INLINE_KEEP(x.hi - r5.hi) - r5.lo) + x.lo) / r5.hi;
    root.lo = r.hi * cor_inline_fifth_root_rest(d);
    return root;
}

/* The rounded fifth root; relative error 1.5 2^-53 */
COR_INLINE double cor_inline_fifth_root_normal(double x)
{
    const struct cor_inline_pair root = cor_inline_fifth_root_parts(x);
    return root.hi + root.lo;
}

/* The fifth root of any double. 0, +inf, NaN and negative numbers are returned unchanged. */
COR_INLINE double cor_inline_fifth_root(double x)
{
    /* the bits of a positive finite x are 1 to INFINITY_BITS - 1 */
    if (cor_inline_bits(x) - 1 >= COR_INLINE_INFINITY_BITS - 1)
        return x;
    if (x < COR_INLINE_2_M900)
        return cor_inline_fifth_root_normal(cor_inline_raised(x, COR_INLINE_2_200)) * COR_INLINE_2_M40;
    if (x > COR_INLINE_2_900)
        return cor_inline_fifth_root_normal(x * COR_INLINE_2_M200) * COR_INLINE_2_40;
    return cor_inline_fifth_root_normal(x);
}

#endif

/* Tables of short polynomials on a grid, for any function: these functions find the row of a number and evaluate it.
 *
 * Macros COR_ROWS_NAME_FIRST, _STEP, ... give the geometry of a generated table cor_rows_NAME(i); docs/internals.md
 * describes the form. The functions below take the geometry as a struct, COR_INLINE_GRID(COR_ROWS_NAME), whose fields a
 * compiler turns into constants. */
#ifndef COR_RUNTIME_ROW_H
#define COR_RUNTIME_ROW_H


/* A row of degree 10 without its first coefficient c_0,
 *
 *     c_0' + s (c_1 + c_2 t + ... + c_10 t^9),     columns c[1] to c[11]
 *
 * The first macro is for s = t, the second for an s that is known later than t. Each pair of terms has its own power of
 * t, which is ready before the coefficients are loaded. Seven dependent operations follow the load, nine in the second
 * macro; Horner's rule has twenty. They are macros because the array functions evaluate them with vectors. pN is t^N.
 *
 * Rounding error: the row is at most a few percent of c_0 + row (docs/accuracy.md) and has a relative rounding error of
 * about 3 2^-53. The row therefore contributes a tenth of a unit of the last place of the sum, and the final addition
 * half a unit. */
#define COR_INLINE_ROW(c, t, p2, p4, p6, p8, p10)                                                                      \
    ((((c)[1] + (t) * (c)[2]) + (p10) * (c)[11]) +                                                                     \
     (((p2) * ((c)[3] + (c)[4] * (t)) + (p4) * ((c)[5] + (c)[6] * (t))) +                                              \
      ((p6) * ((c)[7] + (c)[8] * (t)) + (p8) * ((c)[9] + (c)[10] * (t)))))
#define COR_INLINE_ROW_TIMES_S(c, s, t, p2, p4, p6, p8)                                                                \
    ((c)[1] +                                                                                                          \
     (s) * ((((c)[2] + (c)[3] * (t)) + (p8) * ((c)[10] + (c)[11] * (t))) +                                             \
            ((p2) * ((c)[4] + (c)[5] * (t)) + ((p4) * ((c)[6] + (c)[7] * (t)) + (p6) * ((c)[8] + (c)[9] * (t))))))
#define COR_INLINE_COLUMNS 12

/* The place of a number in a table: its row and the row's variables */
struct cor_inline_place {
    const double *row;
    double s, t;
    int has_s; /* 0 if s = t; callers pass a constant, which compilers propagate */
};

COR_INLINE double cor_inline_row(struct cor_inline_place place)
{
    const double *const c = place.row;
    const double t = place.t, p2 = t * t, p4 = p2 * p2, p6 = p4 * p2, p8 = p4 * p4;
    return place.has_s ? COR_INLINE_KEEP(COR_INLINE_ROW_TIMES_S(c, place.s, t, p2, p4, p6, p8))
                       : COR_INLINE_KEEP(COR_INLINE_ROW(c, t, p2, p4, p6, p8, p6 * p4));
}

/* c_0 + row */
COR_INLINE double cor_inline_row_value(struct cor_inline_place place)
{
    return place.row[0] + cor_inline_row(place);
}

/* m (c_0 + row) for m >= 2^-900 and rows whose c_0 has at most 26 bits. Both products of c_0 with a half of m are
 * exact, so the final addition causes nearly all of the rounding error. */
COR_INLINE double cor_inline_row_product(struct cor_inline_place place, double m)
{
    const double head = cor_inline_head(m), tail = m - head;
    return COR_INLINE_KEEP(head * place.row[0]) + (tail * place.row[0] + m * cor_inline_row(place));
}

COR_INLINE struct cor_inline_place cor_inline_place_of(const double *row, double t)
{
    struct cor_inline_place place;
    place.row = row;
    place.s = place.t = t;
    place.has_s = 0;
    return place;
}

/* ---- uniform grids: node i = first + i step ---- */

struct cor_inline_grid {
    double first, step, per_unit; /* per_unit = 1/step; all three have few bits, so that products with i are exact */
};

COR_INLINE struct cor_inline_grid cor_inline_grid_of(double first, double step, double per_unit)
{
    struct cor_inline_grid grid;
    grid.first = first;
    grid.step = step;
    grid.per_unit = per_unit;
    return grid;
}
#define COR_INLINE_GRID(table) cor_inline_grid_of(table##_FIRST, table##_STEP, table##_PER_UNIT)

/* The row whose node is nearest to y */
COR_INLINE int cor_inline_grid_row(struct cor_inline_grid grid, double y)
{
    return (int)((y - grid.first) * grid.per_unit + 0.5);
}

/* A compiler may not omit the addition of a first node of 0, because 0 + -0 is 0; the branch saves it. */
COR_INLINE double cor_inline_grid_node(struct cor_inline_grid grid, int i)
{
    return grid.first == 0 ? i * grid.step : grid.first + i * grid.step;
}

/* y - node i. The result is exact: y and its node are multiples of the last place of y, or of the difference. */
COR_INLINE double cor_inline_grid_t(struct cor_inline_grid grid, double y, int i)
{
    return (y - grid.first) - i * grid.step;
}

/* The place of y */
COR_INLINE struct cor_inline_place cor_inline_grid_place(struct cor_inline_grid grid, double y,
                                                         const double *(*rows)(int))
{
    const int i = cor_inline_grid_row(grid, y);
    return cor_inline_place_of(rows(i), cor_inline_grid_t(grid, y, i));
}

/* The place of z = sqrt(x). Rows from `plain` on have s = x - node^2, which is exact. t has the rounding error of the
 * root, and c_1 t would pass that error on. */
COR_INLINE struct cor_inline_place cor_inline_grid_place_of_root(struct cor_inline_grid grid, int plain, double x,
                                                                 const double *(*rows)(int))
{
    const double z = sqrt(x);
    const int i = cor_inline_grid_row(grid, z);
    const double node = cor_inline_grid_node(grid, i);
    struct cor_inline_place place = cor_inline_place_of(rows(i), z - node);
    place.s = cor_inline_choose(i < plain, place.t, x - node * node);
    place.has_s = 1;
    return place;
}

/* ---- grids by octaves: every octave 2^k <= x < 2^(k+1) has the same cells, with the nodes in their middle ---- */

struct cor_inline_octaves {
    double first; /* a power of two */
    int bits;     /* 2^bits cells to an octave */
};

COR_INLINE struct cor_inline_octaves cor_inline_octaves_of(double first, int bits)
{
    struct cor_inline_octaves grid;
    grid.first = first;
    grid.bits = bits;
    return grid;
}
#define COR_INLINE_OCTAVES(table) cor_inline_octaves_of(table##_FIRST, table##_OCTAVE_BITS)

/* The row of x: the number of cells between first and x. The bits of x, read as an integer, grow by the same amount
 * from cell to cell. */
COR_INLINE uint64_t cor_inline_octaves_row(struct cor_inline_octaves grid, double x)
{
    return (cor_inline_bits(x) - cor_inline_bits(grid.first)) >> (52 - grid.bits);
}

/* x 2^-k minus the node of its cell, where 1 <= x 2^-k < 2. The result is exact. */
COR_INLINE double cor_inline_octaves_t(struct cor_inline_octaves grid, double x)
{
    const uint64_t one = UINT64_C(0x3ff0000000000000), half_cell = UINT64_C(1) << (51 - grid.bits);
    const uint64_t fraction = cor_inline_bits(x) & UINT64_C(0xfffffffffffff);
    const uint64_t node = (fraction & ~(2 * half_cell - 1)) | half_cell;
    return cor_inline_from_bits(fraction | one) - cor_inline_from_bits(node | one);
}

/* The place of x */
COR_INLINE struct cor_inline_place cor_inline_octaves_place(struct cor_inline_octaves grid, double x,
                                                            const double *(*rows)(int))
{
    return cor_inline_place_of(rows((int)cor_inline_octaves_row(grid, x)), cor_inline_octaves_t(grid, x));
}

#endif
#define COR_ROWS(type, name, rows, columns) \
    COR_INLINE const type *name(int i) { static const type row[rows][columns]
#define COR_ROWS_HERE
#define COR_ROWS_FUNCTION(type, name) return row[i]; }
#endif

/* A row: value = c_0 + (c_0' + s (c_1 + c_2 t + ... + c_n t^(n-1))), t = y - node, in columns c_0,
 * c_0', c_1, ..., c_n. s = t; only in the rows of eps and of the loss at zero force from
 * node 1/4 on s = beta - node^2. c_0' is the remainder of c_0 at the node. */

/* eps at zero overlap, beta < 7: 57 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 7.0625.
 * Relative error of the approximation: 2^-56.5 at most, proved for the whole cell of each row. Bits of the rows:
 * 57.9 58.6 58.1 57.2 57.7 56.8 57.7 59.5 57.6 59.5 57.7 56.9 61.5 58.4 57.8 57.0 56.6 57.3 60.1 57.3 56.5 58.4 57.5
 * 58.3 58.0 59.8 57.0 56.5 59.1 58.6 57.1 60.8 57.5 57.6 58.2 58.1 58.0 61.0 59.5 59.3 58.0 58.4 61.3 58.7 58.1 58.9
 * 59.3 57.6 58.7 57.2 58.9 59.8 58.4 62.0 57.8 59.4 59.0 */
#define COR_ROWS_EPS_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_EPS_ZERO_OVERLAP_STEP 0.125
#define COR_ROWS_EPS_ZERO_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_EPS_ZERO_OVERLAP_ROWS 57
#define COR_ROWS_EPS_ZERO_OVERLAP_END 7.0
COR_ROWS(double, cor_rows_eps_zero_overlap, 57, 12)
#ifdef COR_ROWS_HERE
= {
    {1.0,0.0,-1.1534488580952889,0.7982665609447953,-0.5228825680883606,0.34874267524923586,-0.2330981308559544,
    0.15668208255922378,-0.10581622795185981,0.07170703548889854,-0.04804887169478757,0.027033512758574674},
    {0.8673491325801103,-1.0123923713822538e-17,-0.9759262161872851,0.6308404047023242,-0.379607932127903,
    0.23360715632682785,-0.1437403509971083,0.08890873590379562,-0.05523632067724469,0.034443179737066336,
    -0.02163856690953187,0.013583908318224395},{0.7545267762526199,-4.874157491171978e-17,-0.8343457197616536,
    0.5078742084494134,-0.28221012412055985,0.16134687125556058,-0.09198829516623476,0.05269942834841869,
    -0.030322070461857916,0.01749993037986464,-0.010169065960553678,0.005906201233214987},{0.657654675753069,
    5.438199715659725e-17,-0.719448633594998,0.41555030292633544,-0.21408342330727326,0.1143971383730018,
    -0.060771010452977614,0.032420583052912164,-0.01737818904003739,0.009334427229392294,-0.00504682188633535,
    0.002727456363485639},{0.573824628664949,-4.45699763361287e-18,-0.6247711686155708,0.3449153250329331,
    -0.16524790894731067,0.08296800747695257,-0.04127306695466347,0.020593980066099603,-0.010338959580088583,
    0.005192327787798448,-0.0026255539466916457,0.0013268121790285887},{0.5008138549475579,-4.8920211568782384e-17,
    -0.545687014408389,0.2899887997013917,-0.12948861130188696,0.061371917959745344,-0.028723600068645234,
    0.013448814120307158,-0.006356419267369083,0.0029956979626906324,-0.0014232665306033855,0.000675468118121403},
    {0.43689530094233586,-2.8874336151598736e-18,-0.4788128844876699,0.24666865462937257,-0.10281498553130436,
    0.04618344115983788,-0.020434052924352054,0.008995087123145777,-0.004024140981074906,0.0017845963940128948,
    -0.0007999140304934294,0.0003579937954920345},{0.3807077617431374,-1.2616087175866953e-17,-0.42162776305744254,
    0.21207416991753908,-0.08259628813204023,0.035272985192603704,-0.014835038145932573,0.00614003307257644,
    -0.002616221293512796,0.0010936734090282048,-0.00046402696362041684,0.00019677286218020213},{0.3311648104666409,
    1.103280363174899e-17,-0.3722224022145547,0.18413857556684582,-0.067058549513594,0.02727836799386286,
    -0.010981713850486446,0.0042623375958307725,-0.0017429880487403282,0.0006876805682175545,-0.00027649509116648883,
    0.00011196663722834284},{0.28738954179347226,1.6169032785793362e-17,-0.32913068459616923,0.16134904101440173,
    -0.054982561687887586,0.021305406450748642,-0.008289368307717484,0.0029979546672556532,-0.0011875744460324753,
    0.0004433365266749055,-0.0001680531489499008,6.60609391422729e-05},{0.24866685660804916,3.746733254822805e-18,
    -0.2912138834555233,0.14257632290928254,-0.04551740496208395,0.016752995532424503,-0.006386779989638546,
    0.002128323865562169,-0.0008249246346330832,0.0002941111434774759,-0.0001028538047753324,4.068658041255873e-05},
    {0.21440787796010005,-3.975212579159301e-18,-0.2575799759208947,0.12696044282363841,-0.03806228092266613,
    0.013208354473080133,-0.00503191668971537,0.00152024419622861,-0.0005800502307900895,0.00020330476881668118,
    -6.174096838630896e-05,2.6407030793449675e-05},{0.18412287416505,2.8315798298489183e-19,-0.22752672321997827,
    0.11383230737519912,-0.032189583493519226,0.010383319205539332,-0.004061532923176115,0.0010927807494699267,
    -0.0004058157575180042,0.00015026595293809235,-3.442397260524138e-05,1.7937024090864758e-05},{0.15740020831075774,
    2.140615988748658e-19,-0.2005011815333331,0.10265908023962962,-0.027593072561549976,0.008075689744108753,
    -0.0033595983364785404,0.0007986458604038192,-0.000271062787253253,0.000122699410914627,-1.5952769320690732e-05,
    1.1741987458018699e-05},{0.1338895880296699,-8.793968893045632e-19,-0.17607070703719138,0.09300592066243907,
    -0.0240510788161092,0.006146638150238442,-0.0028365432922577106,0.0006130745402549312,-0.00015492952193680676,
    0.0001115620551213197,-5.370467185775165e-06,4.854297016076208e-06},{0.11328840874813839,2.2205996696535974e-19,
    -0.15390195461454215,0.08450976988860685,-0.021398156095252117,0.004508786111335796,-0.0024155086170611195,
    0.0005256083312675912,-4.5730941755766704e-05,0.00010690001472181639,-5.130997302961823e-06,-5.099851431297865e-06},
    {0.09533036535415154,1.7144410207386845e-18,-0.13374517901155894,0.07686288898985753,-0.01950086476062105,
    0.0031209585377356304,-0.0020248259300225634,0.0005311461182882099,5.6404446279122724e-05,9.46785525991861e-05,
    -1.9541754250681865e-05,-1.826103843448646e-05},{0.0797758152102096,-2.4319808807446605e-18,-0.11542154991132317,
    0.06980509817491347,-0.018235380246718853,0.001985312568356683,-0.0015983588839816488,0.0006176601569703741,
    0.00013510320947014514,5.697915539248625e-05,-4.994398890111545e-05,-2.9133313040090984e-05},{0.06640364849424753,
    -1.944866887693378e-18,-0.0988113827909296,0.06312408936098676,-0.01746710605682444,0.0011410959788206519,
    -0.0010863150789810554,0.0007510885458734225,0.0001570298761715219,-2.000019886466098e-05,-8.594988747813745e-05,
    -2.4591197305443277e-05},{0.05500467247450824,1.5220635110358494e-18,-0.08384140070555064,0.05666253277662201,
    -0.017035676616002624,0.0006482298014182687,-0.000476470323716608,0.0008645844668481906,8.421564504257581e-05,
    -0.00012824603664055714,-9.903072088049736e-05,8.845781632996079e-06},{0.04537672370348066,-1.1281739922767837e-18,
    -0.07046967216878562,0.05032882433786688,-0.01675176789510489,0.0005562688918088944,0.00018265120143023765,
    0.0008668445407022347,-9.479981533888016e-05,-0.00022140814579138312,-5.4176608208139435e-05,6.394560666826647e-05},
    {0.0373218288959053,-6.796284043356389e-19,-0.058667981066928006,0.04410571831973824,-0.016412434965340422,
    0.0008631757049527898,0.0007763408357884628,0.000681868143385651,-0.0003290686318291584,-0.00022696812890978129,
    5.1920050534930086e-05,9.736479768465365e-05},{0.03064566443369914,1.2315409568674223e-19,-0.04840307789813374,
    0.03804940393155748,-0.015836085952595336,0.0014821048695781145,0.0011572792189519677,0.0003080561194870538,
    -0.0005046870430723196,-0.00010382765132818603,0.0001586775587430295,6.014233357124171e-05},{0.025159269866388514,
    7.036182852514004e-19,-0.03962000918227145,0.03227321861705611,-0.014906611279339493,0.002241981515293515,
    0.0012166187356301198,-0.00015062589957153975,-0.0005098727070168168,9.69930800822624e-05,0.00017688648995114288,
    -3.484359275560816e-05},{0.02068250696071101,4.4923176367490176e-20,-0.03223149205445409,0.026916322153687857,
    -0.01360554452425429,0.0029345122182484027,0.0009520296454607925,-0.0005279330807825821,-0.0003264705004245674,
    0.000251723484487477,8.23667768851434e-05,-0.00010492496120711458},{0.01704830799163356,1.0155318269866086e-18,
    -0.02611618778195153,0.022105833248454825,-0.01201249535494987,0.0033880120201198907,0.00047819735473440036,
    -0.0006954688753563949,-5.3663456931226225e-05,0.00026892960689169114,-4.836200940423256e-05,
    -9.013281506845737e-05},{0.014106565340199518,7.333510385377451e-19,-0.021125890392337553,0.017925559799043485,
    -0.010270957068131135,0.0035245595557435,-3.3714491982059045e-05,-0.000636763744188414,0.00017035489468442553,
    0.000165681846736063,-0.00011945454302606876,-2.0593149338031793e-05},{0.011726712570421665,-6.312668966897289e-19,
    -0.017098568568249442,0.014401512751686635,-0.00853711904803356,0.0033682536569803723,-0.0004410274147776708,
    -0.00043525075672283206,0.00026767808709799156,3.1606297614249124e-05,-0.00010648468574130982,
    3.477012021196223e-05},{0.009798548412372411,6.245282876384493e-19,-0.013872664200410226,0.011505832329816881,
    -0.006936595420786988,0.0030090589365000648,-0.0006791561048878377,-0.00020265679223136694,0.00024886583187544193,
    -5.8733144745521926e-05,-5.165330257968682e-05,4.609415970280419e-05},{0.008231409228624337,-7.682469863447874e-19,
    -0.0112987105138377,0.009172853855551609,-0.005544088172045476,0.002552934688777687,-0.0007571590555772061,
    -1.6805314063509695e-05,0.00017124601603431475,-8.729783311303456e-05,-2.9386009772599398e-06,
    2.943643104329858e-05},{0.0069521681394369836,3.901001386390727e-19,-0.009246354484056911,0.007318409058637802,
    -0.004385268662026781,0.0020859962534914792,-0.000723008368908016,9.567230831700263e-05,8.801882013762835e-05,
    -7.47433291258855e-05,2.0748633910078067e-05,9.338299160433464e-06},{0.005902646607219359,9.200230965262829e-20,
    -0.007606877825660042,0.005855773367710854,-0.0034508719110070106,0.001661364668759422,-0.0006298543473193951,
    0.00014373389230467278,2.6328368077009948e-05,-4.807032402689051e-05,2.404248523495903e-05,-2.484881379314825e-06},
    {0.0050369302968274405,-3.3950463397863977e-19,-0.00629245670743996,0.004705686008702558,-0.0027128393608862804,
    0.001302461517864477,-0.0005179586341485055,0.0001495039120537819,-9.108753873540675e-06,-2.3967628326396673e-05,
    1.8012901858211337e-05,-6.116140047116803e-06},{0.004318903779501298,-1.1717769702535855e-20,-0.005233629293890983,
    0.0038009000309605287,-0.0021368130159090393,0.0010128094116299182,-0.00041093421472675597,0.00013368757865801464,
    -2.4383986528103044e-05,-7.996012746519295e-06,1.0543887695084618e-05,-5.4309915908616065e-06},
    {0.0037201509429801694,2.1561249336997006e-19,-0.004376132648862663,0.0030869932377429097,-0.0016896135576378595,
    0.0007855413785745534,-0.00031925960518442776,0.00011032106130923616,-2.7623209519511183e-05,4.618699347429152e-07,
    4.919416850722176e-06,-3.5320695800539414e-06},{0.0032182510519961436,5.906951094214775e-20,-0.003677818187202789,
    0.002521183548300356,-0.001342651630326427,0.0006099964637713803,-0.0002454060080560258,8.69955932594115e-05,
    -2.5122343218924098e-05,3.920326645739645e-06,1.599873360933179e-06,-1.86950835409646e-06},{0.0027954366609198858,
    7.296915996939496e-20,-0.0031059777915976305,0.0020703861979900332,-0.001072807378227376,0.00047536172007433034,
    -0.00018793758403714146,6.690687662509006e-05,-2.0672058934113603e-05,4.681544573951176e-06,-9.587366673609697e-09,
    -8.025659955252237e-07},{0.0024375544597612406,-2.0795996313972716e-19,-0.002635173023704226,0.0017092102065554146,
    -0.0008620469015478537,0.0003722482917348719,-0.00014403410000826404,5.083072332506899e-05,-1.614619843360457e-05,
    4.2582206374310216e-06,-6.180398603745596e-07,-2.3815257821576693e-07},{0.0021332672277334665,-5.64592028308608e-20,
    -0.0022455376615428033,0.0014182039735227932,-0.0006965734093645621,0.00029310692133278644,-0.0001107637687144239,
    3.845517533363557e-05,-1.2273861520045896e-05,3.4654828318031357e-06,-7.362385094543488e-07,1.1376089966865619e-08},
    {0.001873442282295054,1.0548403597948956e-19,-0.001921477132150085,0.00118243768271832,-0.0005659238236042118,
    0.00023210987826536978,-8.559313521316306e-05,2.911261880955698e-05,-9.21330719715077e-06,2.670916246390926e-06,
    -6.577169661056001e-07,9.630527003370085e-08},{0.0016506820717733176,-6.096524696139283e-21,-0.0016506814215845485,
    0.0009904057923604192,-0.00046217996770213957,0.00018485081913590168,-6.650911713092507e-05,2.211678200047753e-05,
    -6.8883807753747115e-06,2.003939988228993e-06,-5.255736329700709e-07,1.0795087758182681e-07},{0.0014589624704286204,
    -8.722530944804839e-20,-0.0014233778272084898,0.0008331958474058587,-0.0003793382691432819,0.0001480276680375972,
    -5.197794728130015e-05,1.6885388968891566e-05,-5.155352580270321e-06,1.4859945435994487e-06,-3.9857578019059623e-07,
    9.314841159490585e-08},{0.001293352647452752,1.0007802710667671e-19,-0.0012317643706032922,0.0007038650804330254,
    -0.00031282803891370214,0.00011917048298399415,-4.085454110246796e-05,1.2963778152305237e-05,-3.87283308326768e-06,
    1.0984805120102821e-06,-2.949250050941239e-07,7.263818864066476e-08},{0.001149796895989673,-8.563948344150493e-20,
    -0.0010695784923264347,0.000596973963617209,-0.00025915122810369826,9.642773108950399e-05,-3.229086950952692e-05,
    1.0010792860949946e-05,-2.9242938775164146e-06,8.133615510635431e-07,-2.1608615851790168e-07,5.408955532367407e-08},
    {0.001024943741216052,7.172721206997303e-20,-0.0009317670332210562,0.0005082365416605334,-0.0002156154283930432,
    7.840542554053451e-05,-2.5659595824607066e-05,7.775057138916846e-06,-2.220669942751461e-06,6.047501491163565e-07,
    -1.5803335798671757e-07,3.9459045304257954e-08},{0.0009160113216596564,-3.4904951712592377e-20,
    -0.0008142322847913729,0.0004342572126123733,-0.00018013630468717722,6.404841149837373e-05,-2.0495386668535392e-05,
    6.072535033743946e-06,-1.6962170266370944e-06,4.520452613004076e-07,-1.1586076450651964e-07,2.8578138404727278e-08},
    {0.000820680760019531,1.5302682378915697e-20,-0.0007136354432033674,0.0003723315340158159,-0.00015109105174477568,
    5.2553394870744585e-05,-1.6451467927585275e-05,4.768491730398471e-06,-1.3031199356734825e-06,3.3985934397450386e-07,
    -8.53330618271115e-08,2.0692922821986455e-08},{0.0007370112560759969,-3.741429679419554e-20,-0.0006272436221187763,
    0.0003202946151469412,-0.0001272092074008237,4.330525822929473e-05,-1.3267985908965194e-05,3.763953712317134e-06,
    -1.0067515530747764e-06,2.5701792490848126e-07,-6.319794681432692e-08,1.5033589537813623e-08},
    {0.0006633721327487792,-1.445648609555137e-20,-0.0005528101106059138,0.00027640505520207145,-0.00010749085443026163,
    3.5830283803564106e-05,-1.0749082986006862e-05,2.9858525990005846e-06,-7.820033239404325e-07,1.9549369468411137e-07,
    -4.7079666288917335e-08,1.0977170517587077e-08},{0.0005983881854559623,2.9779511578012174e-21,
    -0.0004884801513882954,0.0002392555843288475,-9.114498441414111e-05,2.976162730871945e-05,-8.746273590537016e-06,
    2.3799373917596357e-06,-6.105946077184135e-07,1.4953140115238598e-07,-3.5278901235053204e-08,8.061284293063096e-09},
    {0.0005408955253933281,-5.223402203213639e-20,-0.000432716420313652,0.0002077038817447047,-7.754278249573044e-05,
    2.4813690335703293e-05,-7.146342676498131e-06,1.905691123549079e-06,-4.791447561191083e-07,1.1499421317454557e-07,
    -2.658850602606595e-08,5.955049732247899e-09},{0.000489905742247939,4.722703345808566e-20,-0.0003842397978412906,
    0.00018081872839454608,-6.618201823065338e-05,2.0762986096457757e-05,-5.862490157644433e-06,1.5326771012522318e-06,
    -3.77802625989235e-07,8.889459847830712e-08,-2.0150772994334402e-08,4.424996489318712e-09},{0.0004445766942456881,
    2.3029414882750454e-20,-0.00034198207249663197,0.00015783787961352378,-5.66597516549274e-05,1.743376973643851e-05,
    -4.827813149628177e-06,1.2379007920097184e-06,-2.9927267069378383e-07,6.906288972186782e-08,-1.535404088647794e-08,
    3.3069085216273423e-09},{0.0004041886020169115,1.7479829079524255e-20,-0.0003050480015221863,0.00013813494408545076,
    -4.8651301061271215e-05,1.4687185225236758e-05,-3.990480512149214e-06,1.0038944647776358e-06,
    -2.3812049682405166e-07,5.391406660611175e-08,-1.1759833231670693e-08,2.4850347192488815e-09},
    {0.0003681244059335047,-1.4026774557469803e-20,-0.00027268474513592706,0.00012119322006039748,
    -4.189395261341141e-05,1.2413022996386775e-05,-3.3101394652906083e-06,8.173183856415336e-07,-1.9027516564703925e-07,
    4.22833684056201e-08,-9.05199404756865e-09,1.877411083771209e-09},{0.0003358535652640587,-1.0682716584943705e-20,
    -0.0002442571383738604,0.00010658493310859057,-3.6174280327751405e-05,1.0523427004397824e-05,
    -2.7552245247060773e-06,6.6793321791939e-07,-1.5267044004722332e-07,3.330991394379541e-08,-7.0012074410791665e-09,
    1.42567293126163e-09},{0.0003069186472462477,7.62435991295012e-21,-0.00021922760517589112,9.395468793252414e-05,
    -3.131822931083874e-05,8.948065517374256e-06,-2.3009311330285573e-06,5.478407459170416e-07,-1.229846500999605e-07,
    2.6353853653225465e-08,-5.4401664679098346e-09,1.0880134124130911e-09}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_eps_zero_overlap)

/* eps at zero force, beta < 16: 65 rows of degree 10 in y = sqrt(beta), nodes 0 + i 0.0625, 0 <= y <= 4.03125.
 * Relative error of the approximation: 2^-57.5 at most, proved for the whole cell of each row. Bits of the rows:
 * 64.1 62.5 60.2 60.3 61.1 61.1 61.4 60.2 58.9 62.8 60.1 61.6 57.7 59.7 60.2 60.0 62.0 57.5 60.8 58.9 57.8 62.4 59.1
 * 58.2 58.4 59.3 58.5 59.1 58.6 58.3 59.8 60.0 58.5 59.3 60.3 58.6 58.1 58.3 58.6 59.4 58.3 58.5 60.4 59.4 61.4 61.2
 * 59.9 59.0 58.3 58.5 59.4 59.1 59.6 61.8 59.1 59.2 61.4 58.5 58.3 61.1 61.7 58.8 60.1 58.8 59.3 */
#define COR_ROWS_EPS_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_EPS_ZERO_FORCE_STEP 0.0625
#define COR_ROWS_EPS_ZERO_FORCE_PER_UNIT 16.0
#define COR_ROWS_EPS_ZERO_FORCE_ROWS 65
#define COR_ROWS_EPS_ZERO_FORCE_PLAIN_ROWS 4
#define COR_ROWS_EPS_ZERO_FORCE_END 16.0
COR_ROWS(double, cor_rows_eps_zero_force, 65, 12)
#ifdef COR_ROWS_HERE
= {
    {1.0,0.0,6.2748068643082865e-22,-1.1534488580952889,4.2407939853265846e-15,0.7982665609430584,0.2666666670279754,
    -0.5228826112528756,-0.4613764040737955,0.3486013915793789,0.4561927788864351,-0.20421985920652796},
    {0.9955067424949093,6.413962996050045e-18,-0.14338437816577693,-1.1342167214885723,0.2072045761495125,
    0.8474443579826785,0.03833046558309798,-0.6779473860674261,-0.22953959627211729,0.5626773906715248,
    0.2820556479250175,-0.3885302436700945},{0.9821781982462754,7.059458093619122e-18,-0.28190674067730465,
    -1.0755691002732324,0.4171613530513092,0.8183675148844995,-0.22659389204895486,-0.7123962945830228,
    0.07882342695879649,0.6430375855000572,-0.011456746059248131,-0.5229580690707941},{0.960471660370559,
    4.725650089002633e-17,-0.4106863937340271,-0.9788844754994795,0.6094995565978926,0.7071673865109007,
    -0.47863311245076257,-0.6094936945929772,0.38340850843214813,0.5452770278281895,-0.3286694821213755,
    -0.4559948034739109},{0.9311390961617443,-3.2653221628138076e-18,-1.0505072319671105,0.4023573178899322,
    0.7249869549105794,-0.39858249945631863,-0.5408781358925444,0.3013614239280507,0.5930898036090662,
    -0.6008708661252481,0.12356312719432147,-0.6437950744235634},{0.8951871490567068,-5.47378283845302e-17,
    -0.9951939770153152,0.4798170354228915,0.6220014947283004,-0.5166135920581781,-0.39481596847282907,
    0.45868026410259816,0.32952360775767214,-0.5715896106699284,0.014994567180979189,0.1820649127066177},
    {0.8538122210773743,1.2464417814117637e-17,-0.931330297063442,0.5386850317304955,0.4995544726295892,
    -0.5863239359443869,-0.21933353711938303,0.5173254574440183,0.08022276525572934,-0.5140582266025746,
    0.1533397625308146,0.2876917969145741},{0.8083194780271835,-1.1547949972708068e-17,-0.8613790114276231,
    0.5770676057917558,0.36916676172259494,-0.6051884231963635,-0.04555735448666629,0.48749855191174335,
    -0.12234925834338307,-0.38394220794831974,0.27960704623031213,0.17143966585499085},{0.7600371605443814,
    -3.714374543396762e-17,-0.7879178325638174,0.5950000426201119,0.24183646134416725,-0.5787136416130083,
    0.10131576246673257,0.394500368179482,-0.2505866238402351,-0.21434876815671366,0.3177308855558304,
    0.006607508848648811},{0.7102374510419524,2.6937382968466934e-17,-0.7134119103826898,0.594182658256243,
    0.12645320636659788,-0.517969885739678,0.20642041708639128,0.2707267426142607,-0.29904179964377886,
    -0.05391728257834174,0.2706213835034652,-0.11491493964616935},{0.6600726562176082,1.9281274151071966e-17,
    -0.6400337997087193,0.5775073119229782,0.028919646624988013,-0.4363613954136848,0.2659497022631309,
    0.14594843350302839,-0.28272012575723016,0.06278146897009444,0.1771929648668377,-0.16179681705220955},
    {0.6105316072239269,3.860737412348618e-17,-0.569548761239359,0.548507630271135,-0.04798126460345977,
    -0.3466994785897849,0.28483298428757925,0.04081755083176706,-0.22693232147360398,0.12460152298147557,
    0.07968029398837105,-0.14680837424075813},{0.5624171586006832,1.3480314507551217e-17,-0.5032672230359935,
    0.5108508310857474,-0.10414458215962148,-0.25925021483992805,0.27297686791005565,-0.03492045840531463,
    -0.15673095221700015,0.13925117489496328,0.00513208573878337,-0.10077025267847954},{0.5163424485219376,
    1.2567146039006337e-17,-0.4420539647496225,0.4679468464319751,-0.14139305106949251,-0.18091990081132117,
    0.24164248623713558,-0.08057056143605576,-0.09041499767395199,0.12327685232150665,-0.03794537544180868,
    -0.05124918727204295},{0.4727416495577401,-1.0878536700874637e-17,-0.3863771501706443,0.42270267795636113,
    -0.16266847388828215,-0.1153606772768483,0.2008911468812692,-0.1010213913249793,-0.03779433334569221,
    0.09334696926026223,-0.053859212191540363,-0.013531954163605003},{0.43189029504203147,7.234375540723697e-18,
    -0.3363793527473133,0.3774122403036157,-0.1713361074137587,-0.06361833502543908,0.1583153701792463,
    -0.10338874203632979,-0.0016504278226813502,0.06161388411115078,-0.05206607943773945,0.008513764470469738},
    {0.39393060322987317,2.6702385527715683e-17,-0.29195544070407814,0.33375068796585355,-0.17068150356846024,
    -0.024966061198850836,0.11880365875730194,-0.09465389394078927,0.019609916242194204,0.034772827495377044,
    -0.04171424586338499,0.01759157067781304},{0.35889812307987207,1.5176189794025388e-17,-0.2528265835887438,
    0.29283605445922545,-0.1636069781350901,0.002319199065563106,0.08492248141768773,-0.08043940860195434,
    0.02950297450032077,0.0151860881008597,-0.02924372922075835,0.018469027906325035},{0.326747118592367,
    -1.2706784817621422e-17,-0.2186041214697278,0.25532489820166065,-0.15249329075285414,0.020356587097176283,
    0.05754224595612828,-0.06466020784072096,0.03180391555214825,0.002588528002198675,-0.018157196374043474,
    0.015380575133730439},{0.2973731359659779,4.865808969383935e-18,-0.18884069483711674,0.2215171331319777,
    -0.1391773384662422,0.031262747260787815,0.03646149527357912,-0.04968473443731693,0.029690417755175752,
    -0.004461041933144563,-0.009772972488234747,0.011142963432259853},{0.2706320254260739,9.288615161288897e-18,
    -0.16306855773485407,0.1914543497600569,-0.12499909788513418,0.03692768401397836,0.020909712668151052,
    -0.036704969871229884,0.02546772177641208,-0.007647023989975293,-0.004140446140136252,0.00723581869974571},
    {0.2463552787932678,2.4177611114859856e-18,-0.14082646073911248,0.16500354882510596,-0.11088143571667354,
    0.0389184136716001,0.00989759438118417,-0.02612759074722513,0.02061825046453971,-0.008431336430939499,
    -0.0007485332759266066,0.004218861384179209},{0.22436191414872936,1.1148518766313507e-17,-0.1216771399045168,
    0.14192359462197515,-0.09741838561380102,0.03846424599810041,0.002431195789905108,-0.017897493435090835,
    0.015983125809171165,-0.00789943429675905,0.0010459014911558093,0.0021446705916818324},{0.2044673360715935,
    -5.132859040456317e-18,-0.10521755968718208,0.12191497526756516,-0.08495776003662243,0.03648696066237687,
    -0.002376056611015506,-0.011729216289878901,0.011962768821592855,-0.006771686075842085,0.0018124209189589859,
    0.0008488092419435337},{0.18648967473177858,6.0490067337293156e-18,-0.0910838666749446,0.10465511790889216,
    -0.0736714236204845,0.033650508991511605,-0.00525894196338711,-0.0072545856601936515,0.008685361547424195,
    -0.005480104970908153,0.0019794791112203625,0.00011454906692988408},{0.170254104307277,-1.0921309680107767e-17,
    -0.07895268499124915,0.08982208764361647,-0.06361130898699431,0.030414730658146556,-0.006795802792241986,
    -0.004106696953193034,0.006129073340046983,-0.00425542791005503,0.0018364685533912369,-0.0002515884008997879},
    {0.1555955950612251,1.1681045515771986e-17,-0.06854002905257237,0.07710945016528492,-0.05475190691326176,
    0.027084819459841626,-0.007424178816039408,-0.0019609263042000414,0.004201890147639705,-0.0032006849755631776,
    0.0015622916639223719,-0.000395825108951996},{0.14236048775812143,2.926777714747903e-18,-0.05959878224057992,
    0.06623472062242963,-0.04702118387914057,0.023853000229743272,-0.007464429607575309,-0.0005496919682694872,
    0.0027890636794280417,-0.0023449134698010745,0.001258100658977718,-0.0004177779164413174},{0.13040720896371627,
    -1.2688132155374858e-17,-0.05191541586672995,0.05694335699503649,-0.04032223371546558,0.020831646832543953,
    -0.007144384778115033,0.00033721814689363443,0.0017784764748953858,-0.0016786953620965659,0.0009749438961533064,
    -0.0003800895086239176},{0.11960637971081449,5.734089946737201e-19,-0.045306407085018235,0.0490097980604686,
    -0.03454785909557745,0.01807849551424578,-0.00662158121578576,0.0008591769305215669,0.001072219349089929,
    -0.0011758219513111029,0.0007339817426494494,-0.00031933069041655644},{0.10984051216828011,6.745257662300883e-18,
    -0.03961465260389986,0.042236646840599204,-0.02958996108781531,0.015615198819131784,-0.006001768138852026,
    0.0011336577360533699,0.0005902582593780534,-0.0008054532056871605,0.000539955946115211,-0.0002551332316295841},
    {0.10100344070910945,3.813703263977077e-18,-0.03470605841556732,0.03645277778327922,-0.025345240484601378,
    0.013440587785626719,-0.005353519598523603,0.0012452160825747655,0.0002699969896953628,-0.0005382659008157477,
    0.00038953041738778814,-0.0001968474453131836},{0.09299959494428642,6.0911769453776e-18,-0.03046640469238698,
    0.03151089833570547,-0.021718360128255003,0.011539900183292727,-0.004719347988342106,0.0012534232026496109,
    6.402116222470944e-05,-0.0003490624695218628,0.0002761134253998764,-0.0001479886044757463},{0.08574319188773225,
    -2.2904664762121533e-18,-0.02679853069349041,0.027284912955159106,-0.018623415725055496,0.009891030164839465,
    -0.004123915669956406,0.0011993851086478946,-6.270628876348217e-05,-0.00021745023447943202,0.0001924370627064991,
    -0.00010901562117105382},{0.07915740115140342,-5.253284345325947e-18,-0.023619849640898947,0.023667307309136014,
    -0.015984321861139808,0.008468635677234822,-0.003579960400382867,0.0011108540888976432,-0.00013555817591513042,
    -0.00012757134573453122,0.00013179374228997084,-7.896773150903441e-05},{0.07317351961525087,5.027356630581836e-18,
    -0.020860182302197793,0.020566680216586773,-0.013734536133234857,0.007246740538170196,-0.0030924834965509657,
    0.0010061056117838623,-0.00017259052384593026,-6.74434561942458e-05,8.851724034830272e-05,-5.6370432986358347e-05},
    {0.06773017916289853,-4.756893036086386e-18,-0.01845988612035668,0.01790549029374169,-0.011816408598033542,
    0.006200301891946654,-0.0026616533396666225,0.0008968058985466928,-0.0001864478576459756,-2.820844682841553e-05,
    5.80695107966907e-05,-3.9699117271786554e-05},{0.06277260178073016,-6.32893299156578e-18,-0.016368251005141585,
    0.015618044907348465,-0.010180346203205235,0.005306082662204922,-0.002284779392352958,0.0007900907984538635,
    -0.00018584644111229015,-3.431476643208582e-06,3.694353282686102e-05,-2.7588765305883506e-05},{0.05825190973014113,
    1.819495899097985e-18,-0.014542131110648357,0.013648734502164807,-0.008783913372009143,0.004543069040989587,
    -0.0019576260207983995,0.0006900476065533549,-0.00017669542532173848,1.149362811907999e-05,2.2497638749384645e-05,
    -1.8906192523462563e-05},{0.05412449393717092,3.387028240997091e-18,-0.01294478252773399,0.011950500932802118,
    -0.0075909428570824136,0.0038925995082359477,-0.0016752651374811825,0.000598755473467187,-0.00016292579928979485,
    1.982130267374997e-05,1.2780172310700511e-05,-1.2753499974787525e-05},{0.050351440667816605,-2.7448257796546596e-18,
    -0.011544878780370024,0.010483520698354568,-0.006570699354521711,0.0033383187458479167,-0.0014326118090658708,
    0.0005170054973466818,-0.00014709274755393779,2.3822922421962905e-05,6.371171650258858e-06,-8.441316958553488e-06},
    {0.04689801456282045,-2.6547856947676377e-19,-0.010315678650995929,0.009214080569333415,-0.005697117627034692,
    0.0028660321321239603,-0.0012247455012570352,0.00044479191392427056,-0.00013080713876190765,2.506445136944382e-05,
    2.2504961784819776e-06,-5.45224546411825e-06},{0.043733194884511516,4.134541343470334e-19,-0.009234323740354263,
    0.008113622373059069,-0.0049481236738461625,0.002463510216459907,-0.0010470890292994647,0.00038164187971625573,
    -0.00011504081714472437,2.461149981333501e-05,-3.0679152109363184e-07,-3.4045562812536916e-06},
    {0.040829261150828036,1.726356512762652e-18,-0.008281246029875655,0.007157934564010025,-0.004305039392236011,
    0.002120274518813998,-0.000895495118042739,0.0003268328275352318,-0.00010034018473493897,2.317848736983195e-05,
    -1.8107638427220492e-06,-2.02037369267841e-06},{0.03816142402899545,2.102596719619874e-18,-0.007439668410048206,
    0.006326469924660858,-0.003752066495577373,0.0018273837901349374,-0.0007662746649056817,0.0002795324409856392,
    -8.697400553231499e-05,2.12358188060683e-05,-2.6169088259223516e-06,-1.0996244502847778e-06},{0.03570749731054648,
    -2.849581442770175e-19,-0.006695183590279398,0.005601770855418386,-0.003275842999727772,0.0015772317558194512,
    -0.0006561896673102139,0.0002388860272860333,-7.50345518470911e-05,1.9086093546511232e-05,-2.9705865134753224e-06,
    -4.995858601976199e-07},{0.03344760690205022,-6.36493419243669e-19,-0.006035398984768478,0.004968985931544785,
    -0.002865064551742992,0.0013633620788411351,-0.0005624260305304329,0.00020406862209045867,-6.450598008970456e-05,
    1.6917798683528636e-05,-3.039379286950418e-06,-1.1928208805665237e-07},{0.03136393297932148,1.1445027147492225e-18,
    -0.005449637073185872,0.004415463560498371,-0.0025101627048539246,0.0011803029228166448,-0.00048255614297203404,
    0.00017431382980716205,-5.530990134266696e-05,1.4842814728747457e-05,-2.936381449752726e-06,1.1218367056284297e-07},
    {0.029440481723129873,-1.8558382245593767e-19,-0.0049286823789127234,0.003930410572040353,-0.0022030325786869614,
    0.0010234214365905697,-0.0004144974816177283,0.00014892762819637126,-4.733522604834575e-05,1.2922393848599329e-05,
    -2.7368164783304814e-06,2.4421158528652527e-07},{0.027662883351383893,-1.1631625941890693e-18,-0.004464567613939388,
    0.0035046053720168913,-0.0019368029479812465,0.0008887972829921304,-0.0003564710760696533,0.00012729271802437947,
    -4.045726808771259e-05,1.1184995919756469e-05,-2.489802542995424e-06,3.109581582981423e-07},{0.02601821346621338,
    5.321825288022741e-19,-0.004050392734377409,0.003130156875577544,-0.0017056425269433694,0.0007731136948243248,
    -0.0003069620480015815,0.00010886715703654609,-3.4549590976825606e-05,9.638416209147686e-06,-2.2266244375577128e-06,
    3.3583709172872617e-07},{0.024494835031183253,1.0049883494595305e-18,-0.0036801716604699377,0.002800301811326988,
    -0.001504596968035084,0.0006735642570965532,-0.0002646833945692346,9.317974762553078e-05,-2.9491010646524955e-05,
    8.277939230268376e-06,-1.9665108778976293e-06,3.347404129436195e-07},{0.023082258575920164,-9.65576089843369e-19,
    -0.003348702265297983,0.0025092341689826043,-0.0013294518196956468,0.0005877735494143671,-0.00022854351799341067,
    7.982377943335084e-05,-2.5169415720358392e-05,7.091745958886284e-06,-1.72064260091248e-06,3.1832674965867853e-07},
    {0.021771018488084718,-1.789410355567441e-19,-0.003051455950237914,0.002251961568705672,-0.0011766173582601815,
    0.0005137298459962252,-0.0001976175932740465,6.845014020264341e-05,-2.148353836033004e-05,6.064436954275987e-06,
    -1.494913501639032e-06,2.93637702190142e-07},{0.020552563493629758,-1.340171446420897e-18,-0.0027844837232729068,
    0.0020241841811223164,-0.0010430318118173963,0.0004497282042883613,-0.00017112262521204628,5.876041431467758e-05,
    -1.834344142058063e-05,5.179273977033439e-06,-1.2918178761747544e-06,2.6523346505414687e-07},{0.019419159645004302,
    1.4903796590597074e-18,-0.0025443361965549124,0.0018221925435666928,-0.0009260800242482274,0.00039432243923381117,
    -0.0001483959155054377,5.050032798821618e-05,-1.567023366597138e-05,4.419558596046026e-06,-1.1117286070958138e-06,
    2.359865174399833e-07},{0.018363804333789365,9.00212685969663e-19,-0.002327995337736956,0.0016427812193262315,
    -0.0008235250681479026,0.0003462846558300313,-0.00012887660066344,4.345373068872764e-05,-1.3395350371840663e-05,
    3.769436655527365e-06,-9.537532694041748e-07,2.0763337393258205e-07},{0.017380150020226304,-1.5133174249921977e-18,
    -0.002132816158860347,0.0014831757498573025,-0.0007334507107851676,0.0003045711840122945,-0.00011208990506597666,
    3.743719447861744e-05,-1.1459617684401144e-05,3.214326687731028e-06,-8.162995140637434e-07,1.8115594525838504e-07},
    {0.016462436528633557,-1.2680953261008351e-18,-0.00195647681827478,0.0013409707702544478,-0.0006542129741743701,
    0.00026829391958237234,-9.763376296149446e-05,3.229524650559103e-05,-9.812238704148638e-06,2.741107090130109e-06,
    -6.974415796773743e-07,1.570434284800218e-07},{0.015605430896398716,-2.217900740667982e-19,-0.0017969358547063866,
    0.0012140775088779628,-0.0005843993156605837,0.00023669621922154047,-8.516748698248661e-05,2.7896210635131667e-05,
    -8.40978542377e-06,2.338153016622965e-06,-5.95151859749643e-07,1.354707959868186e-07},{0.014804373886733387,
    -1.9945672634246268e-19,-0.0016523954761560402,0.001100679184277428,-0.000522794195938083,0.0002091326253609875,
    -7.440219147072179e-05,2.4128612880873368e-05,-7.215245064268829e-06,1.995283673180993e-06,-5.074418026818861e-07,
    1.1641932857768047e-07},{0.014054932383317712,4.2595094337559704e-19,-0.0015212699964889983,0.0009991930560013771,
    -0.00046835000346853544,0.00018505180805022947,-6.509271193600743e-05,2.0898095344106852e-05,-6.197146202584474e-06,
    1.7036599575827777e-06,-4.3244264860733935e-07,9.97570752932108e-08},{0.013353156979893942,8.305535333181804e-20,
    -0.001402158654943352,0.000908238088667434,-0.00042016247354883986,0.00016398220698980314,-5.703079456289393e-05,
    1.8124780529493063e-05,-5.328775349216105e-06,1.4556582471646075e-06,-3.684468910176828e-07,8.529176186922049e-08},
    {0.0126954441612448,-6.795723390494852e-19,-0.0012938221729838976,0.0008266073575958824,-0.00037744988184031233,
    0.00014551993900296505,-5.0039360274612376e-05,1.5741029298333725e-05,-4.5874855426672265e-06,1.244736585294603e-06,
    -3.1392466372932197e-07,7.280488349998378e-08},{0.012078502545143928,-6.522184732761224e-19,-0.0011951625028250056,
    0.0007532444650822319,-0.00033953541038967414,0.00012931860598458658,-4.3967675682072604e-05,1.3689539482169131e-05,
    -3.954093177177085e-06,1.065303123971765e-06,-2.675246226296649e-07,6.207305231087198e-08}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_eps_zero_force)

/* eps at zero overlap by x = beta^5, 2^-40 <= x < 2^14: 432 rows of degree 10 in y = beta^5 2^-k, 8 to each octave k = -40 ... 13.
 * Relative error of the approximation: 2^-53.8 at most, proved for the whole cell of each row. Bits of the rows:
 * 67.4 68.3 69.2 68.6 72.2 68.3 68.6 68.2 66.8 67.7 67.8 71.9 69.3 70.0 68.5 68.8 67.2 69.6 69.0 70.5 69.6 68.9 68.5
 * 70.4 66.7 67.6 67.5 67.3 68.0 68.8 71.5 68.4 66.4 67.4 67.0 67.5 68.0 67.7 68.9 68.0 66.5 66.6 67.4 67.7 67.8 67.4
 * 67.8 66.9 66.1 67.3 68.3 67.4 68.4 66.9 68.1 69.2 66.6 67.2 68.4 68.5 69.8 67.6 71.3 67.0 65.8 66.3 69.7 68.2 67.7
 * 66.9 68.0 68.4 66.2 65.9 66.7 66.7 66.8 67.4 67.0 67.1 65.3 68.0 69.3 67.1 66.7 70.3 66.8 70.1 65.2 66.3 66.9 66.9
 * 66.7 68.2 66.4 66.0 64.7 65.4 65.7 67.9 70.7 66.3 67.5 70.3 65.5 65.6 68.4 66.1 67.2 66.4 68.5 74.0 64.6 66.1 65.3
 * 66.8 65.5 65.3 67.2 67.3 64.8 65.0 65.1 65.3 65.5 67.9 65.0 66.6 64.6 65.7 65.9 66.9 65.9 65.3 65.8 64.9 63.5 64.0
 * 65.1 64.9 67.6 65.7 65.7 65.3 64.4 65.6 65.6 65.1 66.0 65.3 66.8 66.2 63.4 63.7 64.9 65.4 63.9 69.9 66.0 65.6 63.6
 * 63.7 65.1 66.6 65.2 66.3 64.7 65.7 63.5 63.6 65.6 66.8 64.1 63.9 64.0 68.6 63.7 63.7 65.7 64.9 66.7 68.6 66.0 64.4
 * 62.7 63.4 63.9 64.1 64.8 65.8 64.1 64.8 63.3 63.0 63.4 63.5 64.9 66.3 65.0 64.1 62.2 62.6 63.2 63.5 65.4 64.4 63.8
 * 65.3 62.4 63.1 64.8 63.2 64.8 66.5 64.5 62.9 62.1 62.5 62.6 62.7 64.5 63.9 63.0 62.9 61.4 62.7 62.9 62.7 63.8 63.2
 * 62.7 63.7 61.3 61.8 63.4 64.0 62.9 63.0 63.8 65.6 61.7 62.6 62.1 64.9 64.0 62.5 62.8 64.0 60.8 61.5 63.0 61.6 63.6
 * 63.6 62.6 64.7 61.4 62.2 61.5 62.3 65.3 61.8 62.5 62.4 61.0 62.2 61.4 61.9 62.3 61.2 62.0 63.6 60.3 61.3 62.1 61.4
 * 61.1 62.6 62.0 62.5 60.7 61.3 61.2 62.8 62.2 61.4 61.2 62.4 60.2 60.7 60.9 62.5 63.3 61.6 62.2 60.9 59.4 60.3 60.7
 * 60.9 62.4 61.6 62.6 61.4 59.5 60.9 61.3 61.3 62.4 60.6 61.5 61.2 59.3 61.0 61.2 61.8 61.0 61.2 61.4 60.7 58.8 60.6
 * 60.7 60.1 61.2 60.9 62.4 61.0 58.3 59.6 60.6 62.1 61.0 60.3 60.1 60.8 58.3 59.2 60.9 61.1 60.7 60.4 60.2 60.3 58.3
 * 59.5 59.3 60.0 61.2 59.9 61.2 59.5 57.8 58.6 58.9 59.5 58.8 59.2 59.7 61.1 57.6 57.9 58.3 59.0 59.1 59.1 59.8 62.2
 * 56.7 58.1 58.8 59.8 60.5 58.6 61.0 59.8 56.0 57.5 58.8 58.3 58.6 59.6 59.9 58.6 55.4 56.5 57.2 58.1 58.0 60.8 60.0
 * 59.2 54.5 56.2 57.0 57.4 59.0 59.0 59.0 60.3 54.1 55.7 56.9 57.2 58.7 60.4 58.4 60.0 53.9 55.5 56.8 57.6 58.4 59.5
 * 58.5 60.6 53.9 55.6 57.2 57.8 58.3 58.9 58.5 61.5 53.8 55.6 56.8 58.4 58.3 59.5 59.5 58.3 */
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_FIRST 9.094947017729282e-13
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_FIRST_OCTAVE (-40)
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_ROWS 432
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_END 16384.0
COR_ROWS(double, cor_rows_power_eps_zero_overlap, 432, 12)
#ifdef COR_ROWS_HERE
= {
    {0.9954518244096027,-5.633994091654501e-18,-0.0008537901944951753,0.0003218656618206098,-0.00018184223693819707,
    0.00011983313793152665,-8.573121156725896e-05,6.45591854983203e-05,-5.0349883268844155e-05,4.028338644082823e-05,
    -3.308548407141533e-05,2.740854009984985e-05},{0.9953498014899099,-4.557295210061639e-17,-0.0007810054753692087,
    0.0002634426999641212,-0.00013316989320095204,7.852104651388294e-05,-5.026262488982284e-05,3.386576347717811e-05,
    -2.363197582197213e-05,1.6917019537632916e-05,-1.2414810887557879e-05,9.201764047235716e-06},{0.9952560497553549,
    2.3062054971281566e-18,-0.0007208294207022169,0.0002199941382260219,-0.00010061654068792057,5.367672998537254e-05,
    -3.1087159362473964e-05,1.8951005162355185e-05,-1.1964872352735183e-05,7.749381802772578e-06,-5.140297575340363e-06,
    3.4470246811551183e-06},{0.9951691991924752,1.988774321340813e-17,-0.0006701627076455189,0.0001867504387307405,
    -7.798573062290912e-05,3.798616374159826e-05,-2.0086920628485068e-05,1.1180394890332649e-05,-6.4450481860046945e-06,
    3.8113373663287204e-06,-2.306578071375228e-06,1.412241523109615e-06},{0.995088203214494,-2.9299892075913576e-17,
    -0.0006268565438559823,0.00016071185440300306,-6.174371868793528e-05,2.7668965257394078e-05,-1.3460774638849944e-05,
    6.892911395552355e-06,-3.6556190312280504e-06,1.988843867269242e-06,-1.1067047587893318e-06,6.233834910276937e-07},
    {0.9950122430450268,-1.3815775245026898e-17,-0.0005893719133354356,0.00013991211447484013,-4.977138704694306e-05,
    2.06518050229736e-05,-9.302778719795812e-06,4.410852643535042e-06,-2.165998601699172e-06,1.0911258225832263e-06,
    -5.619372034761469e-07,2.9307825428176783e-07},{0.9949406652468088,4.3247067479207246e-17,-0.0005565761784941643,
    0.00012301712870635992,-4.0743552639257455e-05,1.5739999570871108e-05,-6.601252991067131e-06,2.914089710494668e-06,
    -1.3323100080347432e-06,6.248680676212016e-07,-2.9951020505115795e-07,1.4543539103878e-07},{0.9948729394417172,
    -1.6974219312148342e-17,-0.0005276163395283431,0.00010909487055707209,-3.380157171301108e-05,1.2215766069853404e-05,
    -4.792695389216115e-06,1.9792175702691676e-06,-8.465119317471898e-07,3.7140949829120764e-07,-1.664893234722182e-07,
    7.562732021999405e-08},{0.9947776379986798,3.926124771826938e-17,-0.0009799515569519556,0.0003695012265550898,
    -0.0002087686930943215,0.00013758285968098907,-9.843235022262855e-05,7.41251452161893e-05,-5.781131135120561e-05,
    4.6253644413225377e-05,-3.798938793748223e-05,3.147130980231319e-05},{0.9946605406027207,8.69405860658763e-18,
    -0.0008963953861263495,0.0003024276243442974,-0.0001528872851555432,9.015058857341153e-05,-5.770844920463008e-05,
    3.888337235131728e-05,-2.7133766207487535e-05,1.9424044056534183e-05,-1.4254790140907934e-05,
    1.0565645057685006e-05},{0.9945529383878563,-2.3367336179260387e-17,-0.0008273147525394295,0.0002525462543884483,
    -0.00011551272728787641,6.162600613512741e-05,-3.569200951694267e-05,2.1758612769331337e-05,-1.373770404218136e-05,
    8.897725831849483e-06,-5.9020818714474526e-06,3.95790760279535e-06},{0.9944532585013379,1.3197753417043623e-17,
    -0.000769151315867317,0.0002143810475576995,-8.953051806673908e-05,4.3611319347433425e-05,-2.3062127074055875e-05,
    1.283666767201258e-05,-7.399946624657824e-06,4.376085449871698e-06,-2.6483882523574734e-06,1.6215369144007829e-06},
    {0.994360299415606,1.9598061821002372e-18,-0.0007194380673381639,0.00018448792524704236,-7.088339894136476e-05,
    3.176602008413666e-05,-1.5454407313531883e-05,7.913968332195736e-06,-4.197202543834944e-06,2.283525002896628e-06,
    -1.2706970794189623e-06,7.157642355096153e-07},{0.9942731211489424,-2.8186060064608616e-17,-0.0006764080934692756,
    0.0001606093870089493,-5.713833173828949e-05,2.3709600992741256e-05,-1.0680498537043583e-05,5.064199881861039e-06,
    -2.4868750283864583e-06,1.2527857376193462e-06,-6.452009562718097e-07,3.3650794693519166e-07},{0.9941909735413631,
    2.7720128071725446e-17,-0.0006387610471445007,0.00014121375970117415,-4.677383662326952e-05,1.8070388817830442e-05,
    -7.578826140614078e-06,3.3457083159448557e-06,-1.5296710813981364e-06,7.174429356399187e-07,-3.4388717444217646e-07,
    1.6698560514738374e-07},{0.9941132477128182,-1.7747697483972393e-17,-0.0006055176330598284,0.00012523098915761795,
    -3.88040880575903e-05,1.402426875837412e-05,-5.502401831607319e-06,2.2723526611484385e-06,-9.719031489643298e-07,
    4.264314834128056e-07,-1.9115604427329197e-07,8.683303828199376e-08},{0.9940038761696559,-3.453162108184706e-17,
    -0.0011246199293394065,0.0004241483726784779,-0.00023966301347030694,0.00015794986501706457,-0.00011300716503008795,
    8.51027478826938e-05,-6.637410831539134e-05,5.310535353027555e-05,-4.361744051548963e-05,3.6134114842109126e-05},
    {0.9938694933141261,2.185773661923094e-17,-0.001028707012690658,0.0003471495030975827,-0.0001755096246542588,
    0.00010349463839417266,-6.62524866560572e-05,4.464129933330148e-05,-3.115236413136153e-05,2.2301146957329605e-05,
    -1.6366432320023122e-05,1.2130928316354064e-05},{0.9937460097583268,4.0095854502575487e-17,-0.0009494115539707327,
    0.0002898876705118333,-0.00013260314476516615,7.074701536784662e-05,-4.097593450220215e-05,2.498040051595044e-05,
    -1.5772137020738682e-05,1.021555935993338e-05,-6.776323207918281e-06,4.544221174257947e-06},{0.9936316199284838,
    1.1523308345198856e-17,-0.0008826485286046871,0.00024607607204671654,-0.0001027755741254003,5.0065495835246e-05,
    -2.6476018516011124e-05,1.4737239098589307e-05,-8.495731148775642e-06,5.02417591589762e-06,-3.0406507883615032e-06,
    1.8617302284237378e-06},{0.9935249445349738,-1.246543396682274e-17,-0.0008255858090268149,0.00021176077613686427,
    -8.136891493335222e-05,3.646679724224478e-05,-1.7741953008447397e-05,9.08560959282638e-06,-4.818680951028015e-06,
    2.6216879724658396e-06,-1.458892204865636e-06,8.217813275163715e-07},{0.9934249045414031,-4.6163685113387344e-17,
    -0.000776194999454963,0.00018435011418444793,-6.558990812242024e-05,2.7217915389814107e-05,-1.2261302694521597e-05,
    5.813889673822417e-06,-2.85508157798413e-06,1.438296602776568e-06,-7.407517492514102e-07,3.8634757478095845e-07},
    {0.993330638823427,9.56866822196351e-18,-0.0007329833318655621,0.00016208570290168092,-5.369182889703913e-05,
    2.074407872894194e-05,-8.70048137591057e-06,3.84096568654056e-06,-1.7561400387872197e-06,8.236745505169804e-07,
    -3.948120279000771e-07,1.917161450934685e-07},{0.9932414484420141,-1.803153961111213e-17,-0.0006948266088575577,
    0.0001437391154414417,-4.4542916608206174e-05,1.609915693264211e-05,-6.316697656707431e-06,2.6087032683140515e-06,
    -1.1157857022389145e-06,4.895695027694432e-07,-2.1946199404737065e-07,9.969229892497753e-08},{0.9931159467023196,
    -9.557404769869952e-18,-0.0012904671114690534,0.0004868269129971989,-0.0002751037485451089,0.00018131631932429967,
    -0.00012972950810916694,9.769846584083873e-05,-7.619945736949713e-05,6.096757358683201e-05,-5.007571273946605e-05,
    4.148487679309906e-05},{0.9929617483191948,-9.524919411642705e-18,-0.0011803816359070803,0.0003984423369411884,
    -0.0002014602896988873,0.00011880343774068821,-7.605518649653066e-05,5.124778551185873e-05,-3.576337595724498e-05,
    2.560249510399359e-05,-1.8789516062720002e-05,1.3927114863444601e-05},{0.9928200596626582,1.9366942339429177e-18,
    -0.001089370674364722,0.0003327143000672957,-0.00015220745694368183,8.121071327120382e-05,-4.7038111532273826e-05,
    2.867690429412516e-05,-1.8106429492941377e-05,1.1727681852560002e-05,-7.779483075156902e-06,5.217010937652328e-06},
    {0.9926888082018624,2.6565280442095455e-17,-0.0010127449764261933,0.0002824258413310141,-0.00011796850580675933,
    5.7469604382395464e-05,-3.0392642384916585e-05,1.691780402295476e-05,-9.752999451464968e-06,5.7677996498827845e-06,
    -3.4907487492192176e-06,2.1373446513472023e-06},{0.9925664107397028,4.21925462606825e-17,-0.0009472535513212425,
    0.00024303808677911598,-9.339618846031366e-05,4.1859319467764844e-05,-2.0366309238775047e-05,1.0429830709589292e-05,
    -5.53173160196034e-06,3.0096912912738208e-06,-1.674830946485472e-06,9.434304776438391e-07},{0.9924516287368096,
    4.73444773896007e-17,-0.0008905680385486734,0.0002115759930135879,-7.528396010710595e-05,3.124241347365147e-05,
    -1.4074823296461471e-05,6.673990624678824e-06,-3.2775340971482044e-06,1.6511453187215448e-06,-8.503866866194016e-07,
    4.4353501209443753e-07},{0.9923434737898991,-4.5778746210580817e-17,-0.0008409749353520303,0.0001860210886533619,
    -6.162667486168346e-05,2.3811092441470785e-05,-9.987235955671984e-06,4.409152337277028e-06,-2.0159690203657015e-06,
    9.455589727560628e-07,-4.532422289387072e-07,2.200922329542517e-07},{0.9922411436622711,-2.1108977587840277e-17,
    -0.0007971838239758596,0.00016496326090016525,-5.112514543790746e-05,1.847923551181886e-05,-7.250835332202986e-06,
    2.9945767723292003e-06,-1.280860192147059e-06,5.620095124282973e-07,-2.51939197144593e-07,1.1444693053112382e-07},
    {0.9920971554581212,-4.3007845812903735e-17,-0.0014805369238440789,0.0005587010856957648,-0.0003157518439235864,
    0.0002081189884435597,-0.0001489124422880382,0.00011214838264240784,-8.747168753214793e-05,6.998791688172206e-05,
    -5.748553714036924e-05,4.762417720915021e-05},{0.9919202480000252,-1.0689792311515146e-17,-0.001354199929670406,
    0.00045725810211398897,-0.00023122289347870457,0.0001363629474285549,-8.729995122928546e-05,5.8826582313827185e-05,
    -4.105325628654681e-05,2.9390035806153413e-05,-2.1569539021186853e-05,1.5987950474688502e-05},{0.9917576968934354,
    4.1318179971039117e-17,-0.0012497554321705933,0.0003818203947994219,-0.0001746907648923107,9.321243639327476e-05,
    -5.399189424687968e-05,3.2917327738485246e-05,-2.0784324980089788e-05,1.3462452361317005e-05,-8.930387983348243e-06,
    5.9889106237315625e-06},{0.9916071234408235,-9.588551906473901e-18,-0.001161821129659386,0.00032410402125259254,
    -0.00013539208482835698,6.596178628391467e-05,-3.488519419859997e-05,1.9419164545608216e-05,-1.1195300403890003e-05,
    6.620896181775451e-06,-4.0071252372374844e-06,2.4535533238271106e-06},{0.9914667105957294,-4.002759399320497e-17,
    -0.0010866656062426074,0.0002788991404552528,-0.00010718894339049394,4.8044143614850375e-05,-2.3376496403899016e-05,
    1.1971772243780735e-05,-6.349703862771466e-06,3.4548049613591513e-06,-1.9225621819561646e-06,
    1.0829939976046682e-06},{0.9913350368995804,-5.072746188087369e-17,-0.0010216164589738276,0.00024279096432774526,
    -8.640071333783375e-05,3.585810447242617e-05,-1.6154919136181538e-05,7.660581672196947e-06,-3.762138075371293e-06,
    1.8953183363615877e-06,-9.761605892558725e-07,5.091427447858988e-07},{0.991210967988579,2.5949181597927775e-17,
    -0.0009647070212713304,0.00021346269819082838,-7.072581924126883e-05,2.7328566547212393e-05,-1.146310315346625e-05,
    5.060885562677332e-06,-2.314018290552089e-06,1.085378069762951e-06,-5.202724736595672e-07,2.5264582827532487e-07},
    {0.9910935831696642,-4.348218320965357e-17,-0.0009144562393559444,0.00018929583853630758,-5.867302626372465e-05,
    2.120882415976415e-05,-8.322240288736563e-06,3.4371808050261145e-06,-1.4702132393047893e-06,6.451071910816675e-07,
    -2.891958936601393e-07,1.3137343518623024e-07},{0.9909284152188993,-5.3831551981808e-17,-0.0016982926259408795,
    0.0006410987569114313,-0.0003623617458170008,0.00023885665445254022,-0.0001709135943210801,0.00012872225130874988,
    -0.00010040145544946883,8.033510495491632e-05,-6.598561552372686e-05,5.466700916299591e-05},{0.990725491617199,
    -2.928626944800969e-17,-0.0015533250470645926,0.000524682392134313,-0.0002653493832782881,0.00015649968782910798,
    -0.00010019626372885484,6.751907298749707e-05,-4.712079639826947e-05,3.3734567070038976e-05,-2.475850625893456e-05,
    1.8352011904084973e-05},{0.9905390412753016,3.967538855421063e-17,-0.001433481135902755,0.000438111549031825,
    -0.0002004697024339368,0.00010697519945195643,-6.196674035970663e-05,3.7780725611355195e-05,-2.3855803610291736e-05,
    1.5452278334504015e-05,-1.0250554953601661e-05,6.874361144041114e-06},{0.9903663344433945,3.472113859516307e-17,
    -0.0013325838304213194,0.00037187860821529873,-0.00015536895516781514,7.569973864127871e-05,-4.003725924560463e-05,
    2.2287926103690533e-05,-1.2849537597651791e-05,7.599393433961418e-06,-4.5994290522137245e-06,
    2.8162688277602774e-06},{0.9902052859517118,9.159128582963904e-18,-0.0012463508028963588,0.00032000424863876613,
    -0.00012300242027247168,5.51360494550719e-05,-2.6828487459151506e-05,1.374014775074617e-05,-7.287847396736395e-06,
    3.965335255933261e-06,-2.2067125711287032e-06,1.2430802046783724e-06},{0.9900542646200021,1.3446164763220432e-17,
    -0.0011717151430978231,0.00027856938797005663,-9.914576008309789e-05,4.115059843023202e-05,-1.854024752144827e-05,
    8.792025234719604e-06,-4.317923565887543e-06,2.1753699510925065e-06,-1.1204213102707303e-06,5.84396353634187e-07},
    {0.9899119687420704,1.9376164306715778e-17,-0.001106419894390956,0.0002449151270800023,-8.115744226886031e-05,
    3.1361706389879316e-05,-1.3155496980455521e-05,5.808289453025712e-06,-2.655839032406076e-06,1.2457385375235976e-06,
    -5.971534720524648e-07,2.8998478025466626e-07},{0.989777341819656,-4.2502353941321926e-17,-0.0010487654162888002,
    0.00021718399500013399,-6.732598983637813e-05,2.433849676372458e-05,-9.550804042767926e-06,3.944745230155285e-06,
    -1.6873699719558737e-06,7.404110836318101e-07,-3.319269574893794e-07,1.5078773812409537e-07},{0.9895879179065036,
    -3.555944814494538e-17,-0.0019476689494703824,0.000735532769427312,-0.000415793799077169,0.0002740984137290756,
    -0.00019614115432849808,0.0001477280477394512,-0.00011522931866177461,9.220184200023835e-05,-7.573438919470179e-05,
    6.274474802201992e-05},{0.9893552013364625,-6.1305815289014e-18,-0.0017813498393554064,0.0006019517926533393,
    -0.00030446907530450344,0.00017958615161758424,-0.00011498318965256619,7.748665150881444e-05,
    -5.4078794853477464e-05,3.871693974849666e-05,-2.841581638284999e-05,2.106336616330748e-05},{0.9891413840443235,
    -8.540785270933789e-18,-0.0016438583445208066,0.0005026191332551055,-0.00023001923139415526,0.0001227533800427468,
    -7.111036939177309e-05,4.3357330049762834e-05,-2.737792491155512e-05,1.773416439053203e-05,-1.1764557178924585e-05,
    7.88985674809991e-06},{0.9889433338711916,-1.7970142960346793e-17,-0.0015281062367537403,0.0004266241222223428,
    -0.00017826687766487006,8.686331186458309e-05,-4.594420172393205e-05,2.5577277193891287e-05,-1.4746421814240538e-05,
    8.721476752004877e-06,-5.2786782583694365e-06,3.232243728659671e-06},{0.9887586583117904,3.254428559713986e-17,
    -0.0014291796104598698,0.00036710519628279124,-0.00014112751223470827,6.326592482734766e-05,-3.078613564348903e-05,
    1.5767722933530097e-05,-8.363568004288035e-06,4.5507646829330925e-06,-2.5325648061932376e-06,
    1.4266676759019645e-06},{0.9885854858021814,-2.4512325665844438e-17,-0.001343559299291407,0.0003195650973382925,
    -0.00011375338076913437,4.721750846351157e-05,-2.1274903375969675e-05,1.0089272891873127e-05,-4.955196329845302e-06,
    2.4964988725889093e-06,-1.2858493577108737e-06,6.706952642077955e-07},{0.9884223228345621,-1.2549623204329062e-17,
    -0.001268655574271881,0.00028095271419467687,-9.31131691842366e-05,3.5984851366497944e-05,-1.509568431957462e-05,
    6.665196264643129e-06,-3.047766059426739e-06,1.4296156334586661e-06,-6.853130118424824e-07,3.328030984856799e-07},
    {0.988267957261012,1.9312436528120692e-17,-0.0012025182270668723,0.00024913661522819386,-7.724288629090459e-05,
    2.7925905684359948e-05,-1.0959211516558183e-05,4.5266585381618955e-06,-1.9363527778293375e-06,8.496885292305633e-07,
    -3.8092557627743045e-07,1.7305051575710846e-07},{0.9880507667908996,-1.9269321331068957e-17,-0.0022331286990090525,
    0.000843724538678371,-0.00047702801917847267,0.0003144929202344696,-0.00022506057108334307,0.0001695170592537981,
    -0.0001322297331298054,0.0001058080322789945,-8.691269493138796e-05,7.200736121799923e-05},{0.9877839477056122,
    -4.6908604505750077e-17,-0.0020423481383053934,0.0006904730651347845,-0.00034929868179036614,0.0002060468282065887,
    -0.00013193328313963046,8.891337917285291e-05,-6.205592518196598e-05,4.44294027294708e-05,-3.260925387468346e-05,
    2.4172309295495653e-05},{0.9875388071961098,3.9700607269926115e-17,-0.0018846397811056789,0.0005765162148103264,
    -0.0002638801769202717,0.00014083681668053513,-8.159116718314565e-05,4.975003064761826e-05,-3.1415769436974865e-05,
    2.0350326015720185e-05,-1.3500433268020898e-05,9.054220704524833e-06},{0.9873117519683027,-4.6753021665130394e-18,
    -0.0017518710800176768,0.0004893350439194315,-0.00020450454132257733,9.965739653470358e-05,-5.2714711749586755e-05,
    2.9347859003610307e-05,-1.6920976258033883e-05,1.0007889594264317e-05,-6.057443146692164e-06,
    3.7091831173018072e-06},{0.9871000373465625,4.9568099080323167e-17,-0.0016384042879090128,0.00042105674294376185,
    -0.00016189534446172483,7.258285941985047e-05,-3.532220701025264e-05,1.8091849739138005e-05,-9.596713140124945e-06,
    5.22190833642823e-06,-2.906145095769749e-06,1.6371547591772466e-06},{0.9869015163275441,5.539171505278829e-17,
    -0.0015402019358492993,0.00036652136111864776,-0.0001304902192328407,5.4170007244436894e-05,-2.440913012998351e-05,
    1.157620593151592e-05,-5.68570642558823e-06,2.8646337172648976e-06,-1.4755021715856202e-06,7.696359507818941e-07},
    {0.9867144756399219,4.2265667428904045e-17,-0.0014542929396828186,0.0003222282584137049,-0.00010681106632657465,
    4.128265670322348e-05,-1.7319287573417148e-05,7.647370643337434e-06,-3.497021177435363e-06,1.640401982426397e-06,
    -7.863794858760883e-07,3.818924332839369e-07},{0.9865375248014634,1.7164686796220423e-17,-0.0013784399520083582,
    0.0002857320173396209,-8.860446093816716e-05,3.2036695615428584e-05,-1.257330473894518e-05,5.1936196459549286e-06,
    -2.2217467744510513e-06,9.74954584078451e-07,-4.370962917478936e-07,1.9857314868114554e-07},{0.986288565405395,
    -4.595708507693017e-17,-0.0025597236530301563,0.000967629947086787,-0.0005471792981919251,0.0003607786256099414,
    -0.00025820198601348793,0.0001944895439371256,-0.00015171550495094967,0.0001214043668773894,-9.972672850581546e-05,
    8.262587576808837e-05},{0.9859827313342842,2.9145841438679215e-17,-0.0023409298245456464,0.0007918441719742288,
    -0.00040065337014650383,0.00023636487134295208,-0.0001513569195069397,0.00010200893665856924,-7.119881407341716e-05,
    5.0977101369312877e-05,-3.7416095488113316e-05,2.7736190712888688e-05},{0.9857017585904777,3.280318652240817e-18,
    -0.002160070616057403,0.0006611349859128378,-0.00030266753001142663,0.00016155534023535619,-9.360085104024146e-05,
    5.7076017852958255e-05,-3.604348572733538e-05,2.3348872678593117e-05,-1.549014320980949e-05,1.0388912701524246e-05},
    {0.9854415256376827,4.0277257541048536e-17,-0.0020078169478425184,0.0005611405073514853,-0.0002345579602622356,
    0.00011431511286806543,-6.0472518707098425e-05,3.366873028466191e-05,-1.9413097912456787e-05,1.1482268006407846e-05,
    -6.950049951374872e-06,4.255870020493381e-06},{0.9851988844019175,3.501010690339413e-17,-0.001877701770646264,
    0.00048282918543474037,-0.00018568231072101104,8.325645618371624e-05,-4.0519523138143295e-05,2.0755058537803067e-05,
    -1.100988893666677e-05,5.991087704836971e-06,-3.3343205127906145e-06,1.8784147130930464e-06},{0.9849713723898299,
    -4.199021867437017e-17,-0.0017650938262785763,0.0004202817536004304,-0.0001496593213985629,6.213454397746451e-05,
    -2.8000105921892144e-05,1.3280012683697046e-05,-6.522835284590473e-06,3.286527989085027e-06,-1.6928633645582318e-06,
    8.83037763696432e-07},{0.9847570246233869,1.4992708487085113e-17,-0.0016665851531043104,0.0003694825213142561,
    -0.00012249893087797406,4.73513961581579e-05,-1.9866840195426615e-05,8.772757914835676e-06,-4.011827812720489e-06,
    1.8819617686390266e-06,-9.022080426784399e-07,4.3815484718390313e-07},{0.9845542463736899,-3.5318675974998914e-17,
    -0.001579609472952888,0.00032762633379491697,-0.00010161607065443918,3.6745510271874675e-05,-1.4422484558465205e-05,
    5.957805890683346e-06,-2.548772374721428e-06,1.1185041186030158e-06,-5.014694863899954e-07,2.2782434085318688e-07},
    {0.9842689601917436,-3.859453267327634e-17,-0.00293315918946556,0.0011094675114794743,-0.0006275140705669171,
    0.000413795048592909,-0.0002961684368659156,0.00022310098848104336,-0.00017404272059049327,0.0001392763010780846,
    -0.00011441133449884999,9.47951199820808e-05},{0.9839185178709524,-1.1403616477775702e-17,-0.002682299113435871,
    0.0009078771106608734,-0.000459458867653062,0.00027108942816243874,-0.0001736070712456309,0.00011701188489548886,
    -8.167434067989647e-05,5.8479737537990655e-05,-4.2924337338832064e-05,3.182032832045042e-05},{0.9835965799775149,
    1.87677224131462e-17,-0.0024749415598525814,0.0007579856629989034,-0.00034707952371050126,0.00018528374938660787,
    -0.000107357404560436,6.54685965256737e-05,-4.1345447605534666e-05,2.678456395615501e-05,-1.777007364846154e-05,
    1.1918369821592558e-05},{0.983298420109328,-3.167441263500665e-17,-0.002300387041901334,0.0006433202108380616,
    -0.0002689674586530713,0.00013110130907325644,-6.935827616231693e-05,3.861843117389867e-05,-2.2268177522573875e-05,
    1.3171510541326214e-05,-7.972806418518407e-06,4.8823044024984445e-06},{0.9830204283082553,-3.167553217799356e-17,
    -0.002151218752766215,0.000553521944042929,-0.0002129155668069246,9.547936412687661e-05,-4.647221713304037e-05,
    2.3805710477451407e-05,-1.2628810055025053e-05,6.8723227500844585e-06,-3.824906704543987e-06,2.154856778201736e-06},
    {0.9827597808711637,-4.11609061625336e-17,-0.0020221254341499517,0.0004818018959538542,-0.00017160453578519858,
    7.125472408550703e-05,-3.211280701013183e-05,1.5231603865734586e-05,-7.481802002149642e-06,3.76986496850368e-06,
    -1.941897165799038e-06,1.0129715155535805e-06},{0.9825142246523255,-3.215374103045974e-17,-0.0019091988428323369,
    0.0004235544790156876,-0.00014045787181055365,5.430038692410277e-05,-2.278439628492036e-05,1.0061757179679391e-05,
    -4.6015373226674226e-06,2.1586905394212844e-06,-1.034909481039575e-06,5.026169415605904e-07},{0.9822819311018408,
    -3.299897481517026e-17,-0.001809496049826297,0.00037556254298822423,-0.00011651063794418409,4.2137092589257645e-05,
    -1.6540151111370827e-05,6.833057672725954e-06,-2.9233651932367954e-06,1.2829472151823746e-06,-5.752173801206068e-07,
    2.6133743661057115e-07},{0.9819551344703704,2.799417911285878e-17,-0.003359861635220298,0.0012717486872627218,
    -0.0007194684129057887,0.00047449507662557125,-0.0003396448429824459,0.0002558689791646067,-0.00019961617057304246,
    0.00015974843663813746,-0.00013123363579667214,0.00010873675161703085},{0.9815537239953677,3.9600109737439866e-17,
    -0.0030723150906959975,0.00104062243041856,-0.0005267645858428047,0.00031084362771925607,-0.00019908453195423924,
    0.0001341932408732427,-9.367216299849467e-05,6.707339654788768e-05,-4.923404718543093e-05,3.64990181596918e-05},
    {0.9811849857823078,4.498281058202133e-17,-0.002834643828094083,0.0008687767402681312,-0.00039790745862779023,
    0.00021244722632201115,-0.0001231082836595305,7.507917230183905e-05,-4.741752433998354e-05,3.071964078061028e-05,
    -2.0381594131953244e-05,1.3670382358178664e-05},{0.9808435011528749,3.262592751741832e-17,-0.0026345795014171437,
    0.0007373214375889211,-0.0003083452213270744,0.00015031636434958997,-7.953161852295491e-05,4.4286147091401236e-05,
    -2.553777932962115e-05,1.5106184522275815e-05,-9.144249890760568e-06,5.599856226943572e-06},{0.9805251315547167,
    -2.0572549770191205e-17,-0.0024636180819462773,0.0006343780718928614,-0.0002440789607300052,0.00010947002832338966,
    -5.328710254648176e-05,2.7298710463706355e-05,-1.4482682874690094e-05,7.881542658684796e-06,-4.386786246475693e-06,
    2.4714933667818777e-06},{0.9802266399326841,-3.551886653383442e-17,-0.0023156699386908406,0.0005521619752350101,
    -0.0001967152576820584,8.169334775146888e-05,-3.682094781460088e-05,1.746606607896238e-05,-8.579889075256393e-06,
    4.323372694871523e-06,-2.2271081934949465e-06,1.1617909052370851e-06},{0.9799454433954806,3.4239875811687065e-18,
    -0.002186254206347367,0.0004853922363990732,-0.0001610061657081732,6.225353325971196e-05,-2.6124193619166255e-05,
    1.1537519213786538e-05,-5.2767670910942716e-06,2.4755807083008106e-06,-1.1868819467574382e-06,
    5.764453733962128e-07},{0.9796794458512181,2.3109952588748852e-17,-0.0020719968648950913,0.0004303800703082195,
    -0.00013355182798561042,4.830747534931816e-05,-1.896418244237993e-05,7.835079689968004e-06,-3.352263333873471e-06,
    1.4712479079529233e-06,-6.596715646367439e-07,2.99718451693915e-07},{0.9793052522684709,-8.03045068415219e-18,
    -0.003847046766661425,0.0014573100160986548,-0.0008246674770970051,0.0005439582587332584,-0.00038940775558200157,
    0.00029338068072059777,-0.00022889526706032184,0.00018318931231785552,-0.0001504970076389472,
    0.00012470257802170873},{0.9788456531514221,3.3779463409229464e-17,-0.0035175529937278424,0.001192395172277185,
    -0.0006037576820124484,0.00035633319722720274,-0.0002282435754336644,0.0001538603636556422,-0.00010740747018944124,
    7.691254143080058e-05,-5.6458843051393426e-05,4.1856639940937095e-05},{0.9784234915574345,4.851896651635552e-17,
    -0.0032452245358969376,0.000995436366589077,-0.00045604620929381464,0.00024352716787456286,-0.00014113388418117263,
    8.607940709867975e-05,-5.436846247436887e-05,3.522473162526978e-05,-2.3371664553894638e-05,1.567650481804905e-05},
    {0.9780325569206149,2.812977861225968e-17,-0.0030159979041239214,0.000844776978765191,-0.00035338335260975745,
    0.00017230027695323,-9.11733822052147e-05,5.0772970001223307e-05,-2.9280379599939946e-05,1.732096838120664e-05,
    -1.048541790022581e-05,6.421432656187003e-06},{0.9776681060848201,-1.5747491086843867e-17,-0.0028201251279606748,
    0.0007267995000086695,-0.00027971935093648294,0.00012547564151454586,-6.108514971981436e-05,3.129627877524661e-05,
    -1.6604621315563847e-05,9.036815038113598e-06,-5.0300375887419014e-06,2.8340133788822347e-06},{0.9773264292406579,
    -1.2406045739232436e-17,-0.002650626066812126,0.0006325798705752792,-0.00022543147530423667,9.363459470145738e-05,
    -4.2207993380703424e-05,2.002315199442197e-05,-9.836687078691752e-06,4.956948873475891e-06,-2.5536065076389614e-06,
    1.3321667719091459e-06},{0.9770045663908261,-3.545300522319398e-17,-0.0025023647814159397,0.0005560644476877117,
    -0.00018450335147610284,7.1350978553955e-05,-2.9945366862654986e-05,1.3226268090922775e-05,-6.04955004299675e-06,
    2.838292636803051e-06,-1.3608453944993101e-06,6.609637529335538e-07},{0.9767001154955774,2.385264607325796e-17,
    -0.0023714741185711257,0.0004930248152427127,-0.00015303741734992487,5.53652537430415e-05,-2.1737448723377305e-05,
    8.981657952082956e-06,-3.843101795220804e-06,1.6867661795775036e-06,-7.563420489679561e-07,3.436548108267504e-07},
    {0.9762718519636192,4.0014064652657207e-17,-0.004402787130184808,0.0016693466072851821,-0.0009449460508534482,
    0.0006234049861966969,-0.000446335815165988,0.0003363008887539853,-0.00026240043432684194,0.00021001658971474014,
    -0.00017254538830787573,0.00014297816365228558},{0.9757458812618474,-5.357032930491613e-17,-0.00402536402626951,
    0.0013658017913248666,-0.0006917778957840049,0.00040835563190747616,-0.00026159801212818717,0.0001763611300562456,
    -0.00012312394925720758,8.817216792203754e-05,-6.47274943513155e-05,4.798885628129081e-05},{0.975262792614582,
    -1.515618779795806e-17,-0.0037134404125043754,0.0011401344590204951,-0.0005225052811206422,0.0002790673775033075,
    -0.00016175124550606452,9.866353096849466e-05,-6.232137266761526e-05,4.0379830082820996e-05,-2.6793491871204895e-05,
    1.7972501075121726e-05},{0.9748154701901193,4.20181433423874e-17,-0.003450899926556519,0.0009675236164098577,
    -0.00040486233689437766,0.00019743699612850984,-0.0001044879734702131,5.819324878309992e-05,-3.356215996693807e-05,
    1.9855128098924665e-05,-1.2020140273343764e-05,7.361658882600698e-06},{0.9743984797298126,-4.1503731028065524e-17,
    -0.0032265721876466274,0.0008323627118841122,-0.00032045322419117393,0.00014377526555498947,-7.000305678876229e-05,
    3.586877582370784e-05,-1.9032092825550178e-05,1.0358592417769566e-05,-5.766074056786397e-06,3.248861387939568e-06},
    {0.9740075710819166,-6.972847839512074e-18,-0.0030324588670365446,0.000724424610755853,-0.00025824904363468956,
    0.00010728633032529632,-4.836823491945076e-05,2.2947803472674036e-05,-1.1274356702313307e-05,5.681795024524759e-06,
    -2.927177640800542e-06,1.5271240435589226e-06},{0.9736393532647682,-3.778388495033963e-17,-0.0028626750860438477,
    0.0006367719932840333,-0.00021135450077190015,8.175084597827874e-05,-3.431470397199253e-05,1.5157643896830737e-05,
    -6.9334945420005706e-06,3.253230873403433e-06,-1.559878639266511e-06,7.576708481461699e-07},{0.9732910746058481,
    1.789054159284019e-17,-0.0027127899375977587,0.000564559376376719,-0.00017530280015403156,6.343292383690885e-05,
    -2.4908356762249005e-05,1.0292890692610593e-05,-4.404513295237554e-06,1.93330294727305e-06,-8.669377111213858e-07,
    3.939247499675449e-07},{0.972801191765103,2.1970431986868693e-17,-0.00503607486497854,0.0019114461500224778,
    -0.0010823698947798163,0.0007142113704573102,-0.0005114208001588513,0.00038538058019498776,-0.00030071992059949504,
    0.00024070259807203542,-0.00019776790009106302,0.00016388670558684142},{0.972199594849795,-4.397687611986364e-17,
    -0.004603930574118011,0.0015637673740537597,-0.0007923328895772863,0.000467809785602149,-0.00029972757004638755,
    0.00020208835714060475,-0.00014109693971484905,0.00010105010335893217,-7.418563451908763e-05,5.500389833694287e-05},
    {0.9716470956416338,-7.194244182052706e-18,-0.004246806863887693,0.0013053049563659463,-0.00059842020334141,
    0.00031968052233217553,-0.00018531794231318736,0.0001130507846853126,-7.14153071739604e-05,4.627533550066362e-05,
    -3.0707231122910126e-05,2.059882066048234e-05},{0.971135544175428,-2.751867329982825e-18,-0.003946241331202235,
    0.0011076206420208624,-0.00046365972763663476,0.00022615892687654496,-0.0001197058503588278,6.667601270776627e-05,
    -3.845784734210545e-05,2.2753023356174403e-05,-1.3775350341884414e-05,8.437071252032476e-06},{0.9706587167948747,
    -6.296709299892266e-18,-0.003689438217305476,0.0009528343822532846,-0.0003669734707870952,0.000164683068778115,
    -8.019489249305902e-05,4.109556967754007e-05,-2.180738959281472e-05,1.1869973622107727e-05,-6.607791674503471e-06,
    3.723322061830427e-06},{0.9702117462153778,-2.1739363387534438e-17,-0.003467235826361365,0.0008292297465922944,
    -0.0002957250673751435,0.00012288249136069854,-5.5407911965079543e-05,2.6290700669435213e-05,-1.291790507546719e-05,
    6.510558467301873e-06,-3.3543569450108086e-06,1.7500810631959062e-06},{0.9697907492680398,2.191369886819285e-17,
    -0.003272893627206495,0.0007288595371361078,-0.0002420145641421507,9.363103479931345e-05,-3.930743367615258e-05,
    1.7365061755128606e-05,-7.943952695101626e-06,3.7276247051564574e-06,-1.7874586263893604e-06,8.682599300240378e-07},
    {0.9693925750324469,3.3858064927167024e-17,-0.0031013366850297904,0.0006461731331964411,-0.00020072454637228785,
    7.26482605919676e-05,-2.8531415700446398e-05,1.1791429811192887e-05,-5.046234209382434e-06,2.2151475143947597e-06,
    -9.933879399632508e-07,4.514072926280247e-07},{0.9688325519456797,6.166366240122292e-18,-0.005756875445921418,
    0.0021876222640231464,-0.0012392573094271771,0.0008179245089402986,-0.0005857790711852581,0.00044146582930840406,
    -0.0003445169372451788,0.00027578016904661497,-0.00022660372823677017,0.00018779313686416031},{0.9681448870351208,
    -3.0067840090386797e-17,-0.005262312514574847,0.0017895621376004197,-0.0009071136750218428,0.0005357056694571509,
    -0.0003432844792827833,0.00023148439799341132,-0.0001616367293310421,0.00011576941856470042,-8.499756411381953e-05,
    6.302392331644698e-05},{0.9675134092964003,-4.810007608686649e-17,-0.004853638311218509,0.0014936673384803945,
    -0.0006850639299366617,0.00036605470360700414,-0.00021223608623063977,0.00012948794982282704,-8.180690293566983e-05,
    5.3013141691415364e-05,-3.518072151359896e-05,2.3601100401041122e-05},{0.9669287883939339,-3.23749954555815e-17,
    -0.004509711412694791,0.0012673676466507522,-0.000530758801868111,0.00025895149618664754,-0.00013708606607575578,
    7.636644137739413e-05,-4.405158627810462e-05,2.6064635658616394e-05,-1.5781410896019395e-05,9.666320175971485e-06},
    {0.9663838997573405,3.4235014281211194e-17,-0.00421588020423538,0.0010901863050317958,-0.00042005610257276927,
    0.0001885515954163467,-9.183377421799512e-05,4.706592928235856e-05,-2.4978116641366332e-05,1.3596975800241325e-05,
    -7.569723618349696e-06,4.265608660115332e-06},{0.9658731718697016,-2.032973182347307e-17,-0.003961654801067883,
    0.000948706036334272,-0.00033848321531643096,0.0001406854866404678,-6.344635504239563e-05,3.0108825820907402e-05,
    -1.4795471251479665e-05,7.457479735386804e-06,-3.842507095676858e-06,2.0048907239198617e-06},{0.9653921599703881,
    3.6610362178267253e-17,-0.003739317891962454,0.0008338264238970369,-0.0002769926437482464,0.0001071910218324169,
    -4.500802495287517e-05,1.9886079457378444e-05,-9.098193804541217e-06,4.269611596204715e-06,-2.047501279143563e-06,
    9.94638965375656e-07},{0.9649372576384172,-2.921922664929925e-17,-0.0035430594141802833,0.0007391916954913955,
    -0.00022972388574468467,8.316569523479406e-05,-3.266780966933215e-05,1.3502727458859617e-05,-5.779213487102206e-06,
    2.5371266126790907e-06,-1.1378650989702637e-06,5.170926423251825e-07},{0.9642975026754201,3.3002824874349517e-17,
    -0.006576166173129585,0.0025023454858716303,-0.0014182001260414669,0.0009362776703980514,-0.0006706631078776153,
    0.0005055068795305213,-0.00039453697340428905,0.0003158486476996954,-0.0002595471700291556,0.00021510838880576288},
    {0.9635120210035854,-4.53199729256036e-17,-0.006010478837305351,0.002046825771972484,-0.0010380095129178485,
    0.0006131741392923375,-0.00039300007468470423,0.00026504579563677364,-0.00018509191618073677,0.0001325809025057689,
    -9.734810965878236e-05,7.218641946924577e-05},{0.9627908040766386,2.1600955710727714e-17,-0.005543074356213494,
    0.0017082461753686173,-0.0007838577708044216,0.00041895991448787735,-0.00024295631830756532,0.00014825189930824594,
    -9.367205082031143e-05,6.0707749694881336e-05,-4.0290242506813935e-05,2.703068182233751e-05},{0.9621231755513028,
    -5.4407352930653073e-17,-0.005149754742278846,0.0014493205066342023,-0.0006072567992396273,0.00029635761569712075,
    -0.00015691879429547754,8.742734018543073e-05,-5.043782172777155e-05,2.984610615770485e-05,-1.807244784799246e-05,
    1.1070378739097438e-05},{0.9615009836682624,1.0990566258147755e-17,-0.0048137512689387495,0.0012466086633449063,
    -0.0004805666043288832,0.00021577494347273344,-0.00010511352636760072,5.3879917329773764e-05,
    -2.8597683881568387e-05,1.5568810481489522e-05,-8.668197806044347e-06,4.884953732507624e-06},{0.960917854077747,
    1.0818044978875425e-17,-0.004523059076188534,0.0010847526024442666,-0.0003872187108008754,0.00016098851828935247,
    -7.261710986817444e-05,3.4466024561042095e-05,-1.6938612961154726e-05,8.538541670972438e-06,-4.3998969191828265e-06,
    2.2958825015175522e-06},{0.96036870187771,8.39767841030022e-18,-0.004268846834796137,0.0009533361618219253,
    -0.0003168559791788416,0.0001226535942451458,-5.151097015747288e-05,2.276276207195325e-05,-1.0415577980029767e-05,
    4.888321303165511e-06,-2.3444029178462577e-06,1.138951191025969e-06},{0.9598494014964312,-4.558611876848388e-17,
    -0.004044466159429963,0.0008450850399588554,-0.0002627699366608215,9.515763348622403e-05,-3.738595635836737e-05,
    1.5455279681188555e-05,-6.615721298744777e-06,2.904653687272829e-06,-1.3028072374091304e-06,5.920927419901252e-07},
    {0.9591191515554629,-1.4775443201101625e-17,-0.0075059512689851175,0.0028605695315987384,-0.0016220829753393882,
    0.0010712047217127157,-0.000767472692513313,0.0005785670584228937,-0.0004516150566722508,0.0003615799058828431,
    -0.0002971527181308176,0.0002462937047213922},{0.9582226760294099,-1.682506608486805e-17,-0.006859316978431011,
    0.0023395876394747043,-0.0011871214209834872,0.0007014760120249765,-0.0004496911457775234,0.0003033278247380183,
    -0.00021185272499715704,0.00015176552367111282,-0.00011144448502324921,8.26456208064361e-05},{0.9573996574671286,
    -8.423085537275699e-19,-0.00632508463432362,0.001952387006590063,-0.0008963811807149315,0.0004792540614528326,
    -0.00027798161937815543,0.00016965206990042655,-0.00010720753229921385,6.948736848063887e-05,-4.612126707098785e-05,
    3.094512962457227e-05},{0.9566378863122594,2.314542764268584e-17,-0.005875572467201544,0.0016563040903318023,
    -0.0006943722113804878,0.0003389818055170387,-0.00017952772145985132,0.0001000405614114101,-5.772215959020323e-05,
    3.4160264832222726e-05,-2.068668100593321e-05,1.2672750775534923e-05},{0.9559280409460177,1.6817025403800475e-18,
    -0.005491599099980388,0.0014245203473494071,-0.0005494654860454822,0.0002467916755234285,-0.00012025024007509477,
    6.164924486176307e-05,-3.272578310198027e-05,1.7818153811528602e-05,-9.921492381117915e-06,5.591699185134181e-06},
    {0.9552628328168593,3.9690256312921574e-17,-0.00515943346019116,0.00123946541259053,-0.0004427026425790516,
    0.0001841176894853049,-8.306898722353346e-05,3.9433539918738746e-05,-1.9382583083950235e-05,9.771614655153305e-06,
    -5.035778812050431e-06,2.6279040153168756e-06},{0.9546364481850839,-2.63003925316279e-17,-0.0048689750388490275,
    0.0010892234660795162,-0.0003622333497460795,0.0001402664096195453,-5.892151132151963e-05,2.60420267477867e-05,
    -1.1917722641802557e-05,5.593957417001969e-06,-2.6830807582531985e-06,1.303595372676701e-06},{0.9540441704754353,
    -1.301356752909854e-17,-0.0046126204847528034,0.0009654734108887868,-0.000300382429735547,0.00010881563237119628,
    -4.276202152976779e-05,1.7680855486997465e-05,-7.569452695992823e-06,3.3237764501560084e-06,-1.4909402006936028e-06,
    6.77651629592859e-07},{0.9532113917926477,-3.1653026946875987e-17,-0.008559243067898998,0.0032677496438238795,
    -0.0018540992522399638,0.0012248528460908471,-0.0008777651086198546,0.0006618310879247251,-0.0005166826283487207,
    0.00041372410476212776,-0.00034003997872455235,0.0002818648458708398},{0.9521891982595053,-1.2295976321020897e-17,
    -0.00782061008358455,0.0026722801547845194,-0.0013567730986598558,0.000802009970020688,-0.0005142656518088319,
    0.00034694867844523107,-0.00024235411691383218,0.00017363676805361495,-0.0001275180777638084,9.45738761255852e-05},
    {0.951250907755515,4.5479558858470495e-17,-0.007210443189402544,0.0022297662675057244,-0.0010243794844450253,
    0.000547888099526359,-0.0003178706954083297,0.0001940327168640273,-0.00012263253964696756,7.949495158021756e-05,
    -5.276917892548706e-05,3.54087297854859e-05},{0.9503825664607654,-2.9626547925262563e-18,-0.006697094529572531,
    0.0018914197101414394,-0.000793450391727723,0.0003874936534516984,-0.0002052721452334379,0.00011440828638904477,
    -6.602215862940535e-05,3.9077124743581586e-05,-2.3666736658020994e-05,1.4499669370730993e-05},{0.9495735221153945,
    -4.022644459257404e-17,-0.006258636548126457,0.001626574590111817,-0.0006278124469492553,0.00028208722017159324,
    -0.00013748362407513777,7.049803426675603e-05,-3.742882294284362e-05,2.038139691150939e-05,-1.1349981564741856e-05,
    6.397381618223314e-06},{0.9488154465041639,-3.722412003194893e-17,-0.00587937364809588,0.0014151415553069978,
    -0.0005057851127105025,0.00021043371449151217,-9.4966960818019e-05,4.509048414072995e-05,-2.216657951424337e-05,
    1.1176590088228991e-05,-5.760460840413849e-06,3.0063601457023338e-06},{0.948101697162725,-3.923584221191911e-17,
    -0.005547761145335618,0.001243497498309286,-0.00041381749115894866,0.0001603032403547992,-6.735625348303107e-05,
    2.977594424274225e-05,-1.3628651674185413e-05,6.397871722354005e-06,-3.069010360476746e-06,1.4912447488496438e-06},
    {0.9474268856191126,-9.040753231794871e-19,-0.005255109207499559,0.0011021297591680688,-0.0003431335874937842,
    0.00012435132290559693,-4.888034802950627e-05,2.0214695119482252e-05,-8.655619660041079e-06,3.801219910635867e-06,
    -1.7052979335796615e-06,7.751550598423561e-07},{0.9464781807041728,5.1731936361914853e-17,-0.009749995987265652,
    0.0037298487969794816,-0.00211776164261375,0.001399592255342678,-0.0010032634834696973,0.0007566121675987183,
    -0.0005907735693997278,0.000473114849869678,-0.00038889814196111115,0.0003223959631297431},{0.9453138875502973,
    1.8234075501332592e-17,-0.008906969854152638,0.0030497418127935975,-0.0015495176684590995,0.0009163183811741845,
    -0.0005877272771847997,0.000396592964554243,-0.00027707846842366,0.0001985426993951889,-0.00014582605108589698,
    0.00010816289382794086},{0.9442453492987909,2.864582317665131e-17,-0.008210660838505385,0.0025443922570554866,
    -0.0011697683031224842,0.0006259096714374049,-0.0003632406054368394,0.00022177475819205598,-0.0001401899631997539,
    9.088909704759242e-05,-6.033990726236619e-05,4.049293704613343e-05},{0.9432566306281919,1.799288887765044e-17,
    -0.007624911971173855,0.0021580447262557357,-0.0009059665105085646,0.0004426301692047125,-0.00023454855971624504,
    0.00013075405253851042,-7.546798957209931e-05,4.4674304802203076e-05,-2.7059920575991457e-05,
    1.6580273085653968e-05},{0.9423355679862315,-4.495610455689419e-17,-0.007124674152100748,0.001855657656372278,
    -0.0007167683659435629,0.0003221954374506694,-0.00015707799685964273,8.056341757302278e-05,-4.2780284678374915e-05,
    2.3298856869422147e-05,-1.2976261383865387e-05,7.31480720064299e-06},{0.9414726525854649,-1.8325692522253445e-17,
    -0.006692019157222891,0.0016142773117042621,-0.0005773965786714794,0.00024033298304366177,-0.00010849280773961606,
    5.1524200706993854e-05,-2.5333945978559442e-05,1.2775491217605802e-05,-6.585368085793739e-06,3.437246956755108e-06},
    {0.9406603010954062,-4.0318733829302536e-17,-0.006313761326679726,0.0014183395235274434,-0.000472365992910879,
    0.00018306471057609615,-7.694358904731044e-05,3.4021965178407695e-05,-1.5574913184185896e-05,7.312625018920505e-06,
    -3.5082570788548984e-06,1.7048632688235108e-06},{0.9398923623629654,-4.679179271332705e-18,-0.005979976494095049,
    0.0012569771242221528,-0.0003916487116834952,0.00014199692768872816,-5.583374329800298e-05,2.309565546096604e-05,
    -9.891022470605123e-06,4.3444210431368836e-06,-1.949239308874948e-06,8.861386560688052e-07},{0.9388128891964017,
    -3.08145445940298e-17,-0.011092976782181156,0.004253326274078236,-0.002416904393032158,0.0015980211632852074,
    -0.001145862101096403,0.0008643569868759635,-0.0006750287443648076,0.0005406732497144934,-0.000444489615563857,
    0.0003685228209576266},{0.9374883629828415,1.081770850300654e-17,-0.010131709731017513,0.0034772052925282327,
    -0.0017681381262686872,0.0010460898734747654,-0.0006711781228977441,0.00045301405720511685,-0.00031655751487429313,
    0.00022686753087924023,-0.00016665261139829282,0.0001236247543596115},{0.936273013704243,-1.36529525747826e-17,
    -0.009337861333545775,0.002900593269128272,-0.001334633060194227,0.0007144644410763332,-0.0004147681872617942,
    0.000253296948845481,-0.0001601472878977354,0.0001038447119105612,-6.895041532677727e-05,4.627673025925966e-05},
    {0.9351486587698631,4.925768595790657e-17,-0.008670156030246092,0.002459820964249377,-0.0010335245775381253,
    0.0005051964504397672,-0.00026779143458070386,0.00014932336914746702,-8.620287467143845e-05,5.1037331417672277e-05,
    -3.0918422277799585e-05,1.894674251855653e-05},{0.9341014210639368,3.5543701520774564e-17,-0.008100002080813042,
    0.002114877675810936,-0.000817594092360176,0.0003676989166701239,-0.00017932272056869685,9.19958720934107e-05,
    -4.8860948725334475e-05,2.661492197945983e-05,-1.4825241013802775e-05,8.358108255576941e-06},{0.9331204535309274,
    -1.1215303896123707e-17,-0.00760693800256753,0.0018395574627507506,-0.0006585465515816819,0.00027424765236900266,
    -0.00012384535146986943,5.883045285842612e-05,-2.893229363690529e-05,1.4592546590853516e-05,-7.523085868430604e-06,
    3.927176678743809e-06},{0.9321971065292031,4.8387390333528015e-17,-0.00717591657359486,0.0016160927100731253,
    -0.0005386999820297573,0.00020887827325034977,-8.78238324291778e-05,3.884302833435163e-05,-1.778564702792624e-05,
    8.352025841821969e-06,-4.00749752219321e-06,1.9477172355066286e-06},{0.931324364713361,2.4652170701955425e-17,
    -0.006795613635757722,0.0014320789231369766,-0.000446604895792527,0.00016200517522087406,-6.372355129263605e-05,
    2.6366273188499418e-05,-1.1294088260120396e-05,4.96154992935929e-06,-2.226459230637249e-06,1.0122935951204144e-06},
    {0.9300977762779291,-2.553924830173792e-17,-0.01260355111371515,0.00484510163280361,-0.0027556736721010985,
    0.0018229637513537398,-0.001307627137495306,0.0009866475456322742,-0.0007706982186159115,0.0006174102223426952,
    -0.0005076522977016628,0.0004209449502290897},{0.9285930635101385,2.507936299731599e-17,-0.01150864003600301,
    0.003960264838115269,-0.0020156387792598512,0.0011931571484388578,-0.0007658186073889379,0.0005170347034850443,
    -0.0003613731531582228,0.00025903242655181337,-0.00019030974017730966,0.00014119254463798803},{0.9272126955906079,
    -2.4245544979311938e-17,-0.010604584273021586,0.0033029879830395173,-0.0015212214791236888,0.0008147940675227294,
    -0.0004731896973861364,0.00028905604249790303,-0.00018279688982330672,0.00011855330942614297,-7.872895776261639e-05,
    5.284681986893782e-05},{0.9259359461137671,4.5499142927142795e-17,-0.009844308119289939,0.002800627736447628,
    -0.0011778508924236895,0.0005760639037196325,-0.0003054728050241239,0.0001703837164045564,-9.838319301382948e-05,
    5.8259753087629216e-05,-3.5299411650915695e-05,2.16343739335784e-05},{0.9247469988418034,-4.2036392309727456e-17,
    -0.009195206562197862,0.0024075399617513597,-0.0009316447223929803,0.00041922744784890677,-0.000204531816163295,
    0.00010495916479916484,-5.575892577646837e-05,3.037809625477167e-05,-1.6924180757310557e-05,9.542771108191947e-06},
    {0.9236334926989608,-2.5268320885158067e-17,-0.008633949039154033,0.002093832618307062,-0.000750318579165528,
    0.0003126443446061005,-0.00014124012510221604,6.711335519391641e-05,-3.301350373987497e-05,1.6654206661354974e-05,
    -8.587375064803492e-06,4.483388761046433e-06},{0.9225855719978395,3.1235828606294666e-17,-0.008143380479783541,
    0.0018392412242424615,-0.0006136997073778215,0.00023809710211387036,-0.0001001489340247668,4.430749515997341e-05,
    -2.02925773475542e-05,9.531135778240431e-06,-4.574025737127136e-06,2.2233798419373176e-06},{0.9215952441825063,
    2.29954833317205e-17,-0.007710591860873966,0.0016296196026507079,-0.000508727121179776,0.0001846483558303857,
    -7.265941270443197e-05,3.007270732843222e-05,-1.2884860833565687e-05,5.661510573034934e-06,-2.5409910351358612e-06,
    1.1554685022180446e-06},{0.920203658686652,5.035739003869753e-17,-0.014297362908168286,0.005512485359784055,
    -0.0031385013865936778,0.0020774582133112544,-0.0014907908144867746,0.0011251983241342778,-0.0008791400439121787,
    0.0007044261883936143,-0.0005792997981572518,0.0004804261695862553},{0.9184969566291599,2.8453584194487376e-17,
    -0.01305176352694602,0.004504815715759407,-0.0022952242269480326,0.0013594880936317478,-0.000872943381646637,
    0.0005895451054424304,-0.0004121565749093321,0.00029549516346219186,-0.0002171371255027941,0.00016112042235295402},
    {0.9169316984087303,3.209149254483648e-17,-0.012023494872355517,0.0037564320426898327,-0.0017319264379915297,
    0.0009282294748853992,-0.0005392979146844738,0.00032954549751662625,-0.00020845546052557736,0.00013522276713504166,
    -8.981499516336808e-05,6.029763421632318e-05},{0.9154842844571484,-4.5575238859583445e-18,-0.011158922196192803,
    0.003184534271831913,-0.0013407798577088526,0.0006561650568027615,-0.00034810018101369996,0.00019422366241765004,
    -0.00011217810273541583,6.644298200989655e-05,-4.0264977069832824e-05,2.4681559426304044e-05},{0.9141367090844309,
    -4.93196564960581e-19,-0.010420903519984712,0.0027371043126175575,-0.0010603577109286597,0.00047745395712571725,
    -0.00023304242651458806,0.00011962973977863366,-6.356940700380238e-05,3.4640897753863735e-05,
    -1.9302651901389498e-05,1.0885621518824686e-05},{0.9128749022701501,-3.9112512609382405e-17,-0.009782865746167935,
    0.002380080623515663,-0.0008538601716900004,0.000356020914701515,-0.00016090822186426518,7.64849411097137e-05,
    -3.7633560032204195e-05,1.8989078290794045e-05,-9.79314678343512e-06,5.1137404791784985e-06},{0.9116876473994984,
    1.3408453135674097e-17,-0.009225272226173217,0.0020903751324093667,-0.0006982959176044113,0.0002710974870388858,
    -0.0001140816066142866,5.0488838916022996e-05,-2.3129898208616874e-05,1.0866226750170385e-05,-5.215737245495962e-06,
    2.5357253281468367e-06},{0.9105658495100537,-1.857132429582265e-17,-0.00873342370888167,0.0018518725463509019,
    -0.0005787808120790097,0.0002102161973256806,-8.275859120273053e-05,3.4264512119439706e-05,-1.4684921273584864e-05,
    6.453912599567565e-06,-2.8971963294906206e-06,1.317665834504735e-06},{0.9089898642721076,-1.808907466294493e-18,
    -0.016189879708298188,0.006263065620429582,-0.0035700566873820114,0.002364731213709064,-0.0016977364305158264,
    0.001281846939808714,-0.0010018141943217642,0.000802907040564088,-0.0006604187140610118,0.0005477927481869873},
    {0.9070575469136526,-4.4583048985650676e-17,-0.014774846971137092,0.005116957015985202,-0.0026102616182222273,
    0.0015471677618516253,-0.000993931747228076,0.0006714974855746642,-0.0004695850539746152,0.0003367481805003749,
    -0.0002475009520441171,0.00018368286162927355},{0.9052858950785622,1.7578002285335885e-17,-0.013606978197580482,
    0.004265933492084992,-0.0019692559275706818,0.00105617773687033,-0.0006139357615718204,0.00037529216474352833,
    -0.00023746221195188172,0.0001540763253872325,-0.00010235862238971126,6.873099011080242e-05},{0.9036480722586329,
    2.7852339530330363e-18,-0.012625238826058713,0.0036157253012191587,-0.0015242296135629912,0.0007464837612295767,
    -0.0003962121578455062,0.0002211507625325363,-0.000127768490822182,7.569575295057767e-05,-4.588183977473339e-05,
    2.8129634344865594e-05},{0.9021236070447133,1.248656278354964e-17,-0.01178737016865183,0.0031071188942553367,
    -0.0012052327930183189,0.000543087023927072,-0.0002652117093416306,0.00013619533968294692,-7.239402476373118e-05,
    3.9459552779284954e-05,-2.199238677554722e-05,1.2404750146271328e-05},{0.9006965055192652,3.026434417114408e-17,
    -0.011063143465051729,0.002701347325070709,-0.0009703660282393981,0.0004049006253898457,-0.00018309404156049614,
    8.706423103616484e-05,-4.285214593872372e-05,2.162774502990203e-05,-1.1156380140586867e-05,5.826668749700195e-06},
    {0.8993540194699455,-7.94735309879035e-18,-0.010430337884093642,0.0023721369521895515,-0.0007934556810502149,
    0.00030827422385722695,-0.00012979365585083242,5.74649984802244e-05,-2.6334012021017607e-05,1.2374671696242491e-05,
    -5.941082184776085e-06,2.8889085744675325e-06},{0.8980858136648089,-3.18707128100159e-17,-0.009872237065055365,
    0.00210115154156831,-0.0006575597229098576,0.00023901216298961763,-9.41447133991485e-05,3.899417861650413e-05,
    -1.6717213506266136e-05,7.349002709891215e-06,-3.2997373598866394e-06,1.501030557358374e-06},{0.8963045784849581,
    7.058341460262338e-18,-0.018295774768525307,0.0071045385578240305,-0.0040551681655965855,0.0026881542490603196,
    -0.0019309711114425224,0.0014585359615392694,-0.0011402698695349744,0.0009141149872553207,-0.0007520618268316049,
    0.0006239282846470777},{0.8941212972322176,2.3020636461524986e-17,-0.016690842329435837,0.00580284751070556,
    -0.0029642210248523276,0.0017583682347169613,-0.001130230706852804,0.0007638958995863854,-0.0005343755407111102,
    0.0003833144171484575,-0.00028179111820268244,0.00020917276486239522},{0.8921202194165754,-5.250439410457715e-18,
    -0.015366593806655383,0.004836528464490563,-0.002235786194217777,0.001200100522216114,-0.0006979852755369764,
    0.0004268502583687674,-0.0002701754282483032,0.0001753505497905369,-0.0001165193298928939,7.825532808883834e-05},
    {0.8902708723796904,-3.784421164418312e-17,-0.014253668859760066,0.004098392492423666,-0.001730164443931174,
    0.0008480393225711678,-0.0004503709680932675,0.00025148782516259553,-0.0001453450146396005,8.613306197605403e-05,
    -5.222076253009212e-05,3.2022542427134336e-05},{0.8885500161189216,-3.6452291268859526e-17,-0.01330405418650152,
    0.0035211244179446507,-0.001367801291918229,0.0006168589088215795,-0.00030141164737268114,0.00015485260287264964,
    -8.233968891337577e-05,4.489341361303357e-05,-2.5026979303787508e-05,1.4119355956712099e-05},{0.8869394973836623,
    3.9543418396046994e-18,-0.01248341117699964,0.0030606612295792967,-0.0011010526047420758,0.00045982292616155313,
    -0.00020805157660766703,9.897563508732685e-05,-4.8731926018462524e-05,2.460243317678364e-05,-1.269396280352672e-05,
    6.6311126780747765e-06},{0.88542484959281,-4.632721563002606e-17,-0.011766502403837732,0.00268714505043604,
    -0.000900161040763502,0.0003500333841447319,-0.00014746326070009532,6.531728624156318e-05,-2.994307089295228e-05,
    1.4074745581715105e-05,-6.758976632254236e-06,3.28732489176136e-06},{0.8839943464995373,3.439047303962179e-17,
    -0.011134345352376819,0.0023797415532996954,-0.0007458678225256692,0.00027134769338970597,-0.00010694573719441824,
    4.4316369537477015e-05,-1.900574296675823e-05,8.357542087596286e-06,-3.7535257979792662e-06,1.7078283691764705e-06},
    {0.8819857152998316,2.5937556857264017e-17,-0.020628115817443823,0.008044467774657614,-0.004598708475826325,
    0.0030511764993346215,-0.0021930824528366404,0.0016572830343637589,-0.0012961239726825703,0.001039372537025781,
    -0.0008553358132216607,0.0007097641492460705},{0.8795245975279121,-2.4403086319419826e-17,-0.0188111307166328,
    0.006568502855974779,-0.0033605878713318465,0.0019953028086435866,-0.001283328388856205,0.0008677797913975121,
    -0.0006072740248095702,0.00043574020715880405,-0.00032041634688516406,0.00023789804935298698},{0.8772697264122151,
    -2.860739357551211e-17,-0.017312366632520657,0.005473107393892914,-0.0025340934865449487,0.0013614816581242566,
    -0.0007923505270199522,0.00048479176237331643,-0.00030696683488176793,0.00019929191815041406,
    -0.00013246387517897105,8.898436436125807e-05},{0.8751865584111346,-2.4744775402001865e-17,-0.016053124798929903,
    0.0046365835175675675,-0.001960540404264556,0.0009618628254901612,-0.0005111510640910101,0.00028556704150295415,
    -0.00016510494818072654,9.787441694832991e-05,-5.935555179753186e-05,3.6406257524264415e-05},{0.8732487554949999,
    1.6280998302048104e-17,-0.014978940437144596,0.003982521581136302,-0.0015495820053632418,0.0006995078277817323,
    -0.00034202116337594306,0.00017580332503567864,-9.351673509199112e-05,5.1004011546739376e-05,
    -2.8441387384493462e-05,1.6049480403311595e-05},{0.8714357492822155,-4.275841477355878e-17,-0.01405086942592251,
    0.003460915966564048,-0.001247121762767458,0.0005213298915625191,-0.00023603881337780133,0.0001123464902383081,
    -5.5337414290162745e-05,2.7946474951601946e-05,-1.4423429449282997e-05,7.536383983974225e-06},{0.8697311521094784,
    -2.392359538101021e-19,-0.013240295317452326,0.0030378885675351776,-0.0010193786567317528,0.0003967817445528405,
    -0.00016727090214915306,7.412871762384126e-05,-3.399626077877485e-05,1.5985308744309907e-05,-7.678658800301482e-06,
    3.7355435942423556e-06},{0.8681216832630329,-2.3699063909163015e-17,-0.01252569815813279,0.0026898041154940003,
    -0.0008444936452748559,0.0003075338327756683,-0.00012129092913499464,5.028675715808401e-05,-2.1575110027874855e-05,
    9.490613056117726e-06,-4.263640512592612e-06,1.9404101229185147e-06},{0.8658624655681915,-1.604698007436907e-17,
    -0.023197332264418512,0.009089957262292475,-0.005205431967156667,0.003457227873132207,-0.0024866745408542103,
    0.0018801359263624468,-0.0014710281337182772,0.0011800375333406708,-0.0009713817648624173,0.0008062640858925075},
    {0.8630954374550629,-4.053685271604274e-17,-0.02114456445153139,0.0074195214236320774,-0.00380274055801704,
    0.0022601603825789544,-0.0014547151966277918,0.0009841995079258607,-0.0006890394275308326,0.0004945843445984314,
    -0.0003637965459243948,0.0002701762342557838},{0.8605613805486705,-1.2794767858944003e-17,-0.01945189230811601,
    0.006180181265220785,-0.0028666592496291825,0.001541781000587732,-0.000897932844948828,0.0005496922732385933,
    -0.00034821315577969887,0.00022615162596056014,-0.00015036299645713522,0.00010103498069997562},{0.8582212113505379,
    5.2039020364609065e-17,-0.01803018044693366,0.005233999967754896,-0.002217230198367498,0.0010889636694652865,
    -0.0005791226726268872,0.00032372138896223955,-0.0001872474932988669,0.00011104119950287532,-6.736153270994817e-05,
    4.132788834001291e-05},{0.856045138855052,1.9341380082538592e-17,-0.01681775786322881,0.004494394308495367,
    -0.0017520205447783311,0.0007917530320474983,-0.00038741483158604697,0.00019924902127988094,-0.00010603619197943455,
    5.785364044474236e-05,-3.2271178997690344e-05,1.8215599779108097e-05},{0.8540099043069468,1.3818820327682377e-17,
    -0.015770538740277246,0.0039047141432170906,-0.0014097109962343628,0.0005899472471054523,-0.0002673097599458715,
    0.0001273034991288995,-6.273331497330429e-05,3.1693511210157705e-05,-1.6362568564520856e-05,8.551969931472964e-06},
    {0.8520969811110392,3.740306783149536e-18,-0.014856136002870004,0.003426588301975201,-0.0011520184001480337,
    0.0004489120618879601,-0.00018939359389697494,8.398160844938154e-05,-3.8532757984932195e-05,1.812533956006988e-05,
    -8.709474309022445e-06,4.238207707360623e-06},{0.8502913586378084,4.029382084190938e-17,-0.014050199444420531,
    0.003033252466815078,-0.000954175431944671,0.00034786961095596057,-0.0001373065999012095,5.6960359894156127e-05,
    -2.4449833434581558e-05,1.0759335345151128e-05,-4.835205534285938e-06,2.201158459558173e-06},{0.8477576947181454,
    -3.305487867771654e-17,-0.026009938479906444,0.010247221586894116,-0.005879755072042789,0.003909585205045611,
    -0.002814278217901413,0.0021291085963706657,-0.0016666212231325023,0.0013374667920738317,-0.0011013465069963316,
    0.0009144013118197492},{0.8446559573519699,-1.4833580754712624e-19,-0.023696288442822504,0.00836072584308877,
    -0.004293785876066163,0.0025550154738077204,-0.0016458296896977843,0.0011141817336774262,-0.0007804205914995264,
    0.0005604022945344771,-0.0004123516634131019,0.00030632646875237757},{0.8418167488024505,-1.9007737472522653e-17,
    -0.02178924109459147,0.006961577383171087,-0.003235743253392068,0.0017423715134662027,-0.0010155965097045805,
    0.000622111141786301,-0.00039428413516608,0.00025617814011374285,-0.00017038665594441875,0.00011452414261726254},
    {0.83919594509058,-2.2238218675859585e-17,-0.020188045400799926,0.005893735404209767,-0.00250192309148733,
    0.0012302841431133932,-0.0006548291403871469,0.0003662726403628244,-0.00021196716739521675,0.00012575290755934,
    -7.631335669204698e-05,4.683438027307496e-05},{0.8367599241442872,3.018145473663873e-17,-0.018823015103277038,
    0.00505928147940419,-0.001976408839110195,0.0008942611264767216,-0.00043794739908084167,0.00022538337884189387,
    -0.00012000594787638899,6.550335057854516e-05,-3.655145487030755e-05,2.063803783353824e-05},{0.8344824441225525,
    -3.328689572155978e-17,-0.01764434879030116,0.004394166377248854,-0.0015898276227071305,0.0006661588243365865,
    -0.00030210356046643934,0.00014396780953320268,-7.098220596509134e-05,3.5876367882893995e-05,
    -1.8528863535094938e-05,9.687250956074476e-06},{0.8323426081756522,-4.524583567657437e-17,-0.016615470185273033,
    0.0038550182225852514,-0.0012988787904651185,0.0005067833195371056,-0.00021399703469535865,9.495426863669625e-05,
    -4.359027857697472e-05,2.0513278845138797e-05,-9.860572422334966e-06,4.7998909845669165e-06},{0.8303234897278984,
    -5.5248866334078544e-17,-0.015708886259128026,0.003411591814118829,-0.0010755553351938238,0.00039262650861443104,
    -0.00015511032376912436,6.438926171459576e-05,-2.7653413466335765e-05,1.2174469695649618e-05,-5.473218166279997e-06,
    2.4924120708374407e-06},{0.827491374402117,1.4249507678619026e-17,-0.029067002113604183,0.011521038245259877,
    -0.006625469017877129,0.004411194146280966,-0.0031782300235261994,0.002406093979619447,-0.0018844639444919242,
    0.0015129655821040273,-0.0012463424325794821,0.001035126213280991},{0.8240260633128856,2.9430361882801546e-17,
    -0.02646633320972797,0.009395708474742453,-0.00483634478127248,0.0028817090688579195,-0.0018579859788911853,
    0.0012586826137445477,-0.0008821247813256928,0.0006337243977701583,-0.00046648618584971193,0.0003466583658073283},
    {0.820855784877177,1.0219770259284897e-17,-0.024323655341786904,0.007820055274699934,-0.0036432191913142228,
    0.001964456342963927,-0.001146122952750527,0.0007025646800213964,-0.00044552622827383475,0.00028960697778687233,
    -0.00019269746220512026,0.00012956460891581714},{0.8179308477709107,-4.9206113496703185e-17,-0.02252535142622017,
    0.006617945942863293,-0.0028159957383156716,0.0013866398066324523,-0.0007387568218899324,0.00041351525940315053,
    -0.00023944484300482313,0.00014212202315896737,-8.628198542898622e-05,5.297071782393071e-05},{0.8152134017174892,
    -4.4564172923395426e-17,-0.02099286359733477,0.005678890897294053,-0.002223781627014497,0.0010076020326254982,
    -0.0004939332929395231,0.00025438216208736473,-0.00013552557815177532,7.401022064571133e-05,-4.131537322047101e-05,
    2.333615628469604e-05},{0.8126739149474362,5.323361667821007e-17,-0.01967006847014056,0.0049306403195169355,
    -0.0017882644464057998,0.0007503732779724083,-0.0003406301349608947,0.0001624484573440439,-8.014142516091821e-05,
    4.0525534275287697e-05,-2.0938730474665306e-05,1.0951113189313276e-05},{0.8102888783248052,3.4066573408749994e-17,
    -0.01851575905388408,0.004324283255572405,-0.0014605772879585476,0.0005706950724232283,-0.0002412252899264379,
    0.00010711661130859756,-4.9203135494235186e-05,2.3166145184538052e-05,-1.1140493377251595e-05,
    5.424902468725208e-06},{0.8080392550336208,-4.477946127670168e-18,-0.017498970327018953,0.0038257210412276344,
    -0.0012091210836920022,0.0004420283413007217,-0.00017480336129163893,7.26195929653104e-05,-3.120708123733585e-05,
    1.3745884753294394e-05,-6.1823162771793175e-06,2.816362546015899e-06},{0.8048852345634137,1.4299536892142632e-18,
    -0.032362364664667596,0.012914070578749397,-0.00744537532569897,0.004964439468110118,-0.0035805141691120203,
    0.0027127490245670714,-0.002125951900622833,0.0017077199922385289,-0.001407393377283839,0.0011693225578038112},
    {0.8010282917640966,2.751326602651222e-17,-0.02944798925830305,0.010526272192573348,-0.005432281898024694,
    0.003241695712030951,-0.0020922794222918593,0.0014185262770411244,-0.000994776036530926,0.0007150268491785322,
    -0.0005265683644632883,0.00039145695256094574},{0.7975018887384988,3.6785438798137406e-17,-0.027048052079132506,
    0.008756836212833909,-0.004090367994423493,0.0022089628575688537,-0.0012901515315788916,0.0007914911823244738,
    -0.0005022411378202644,0.0003266471610014071,-0.00021744189851640247,0.00014625917796039944},{0.7942502215175087,
    2.500890294500068e-17,-0.025034763740485442,0.007407448392751222,-0.003160350426691374,0.0015586436145202066,
    -0.0008312962968275121,0.00046569546156528433,-0.00026983600461152624,0.00016024723998520226,-9.7330686323699e-05,
    5.977752463301362e-05},{0.7912308016874335,-4.135562370272943e-17,-0.023319802301974446,0.006353751660816744,
    -0.0024947873074168433,0.0011321931436800879,-0.0005556203227781686,0.00028639013557497174,-0.00015267959182603197,
    8.342377171053773e-05,-4.6592198669243393e-05,2.6327278400483247e-05},{0.7884104916204197,-1.4609308892847743e-17,
    -0.0218400918725973,0.005514456690471127,-0.0020054948809937675,0.0008428820189207927,-0.0003830518132815633,
    0.0001828339015137282,-9.025901916595207e-05,4.56671697368104e-05,-2.3606513824793342e-05,1.2351435088480307e-05},
    {0.7857629212888477,5.0271610136937546e-17,-0.02054933661915986,0.004834551036253099,-0.0016374638794714358,
    0.0006408551211588634,-0.00027118763575060715,0.00012052450194580947,-5.5399718642804535e-05,2.6098379807498165e-05,
    -1.255662634661209e-05,6.11702841826018e-06},{0.78326674451735,5.067949177229019e-18,-0.019412758655783072,
    0.00427569407321579,-0.0013551338762041122,0.000496225985984178,-0.0001964610262226783,8.168765616509964e-05,
    -3.512818132954695e-05,1.5481863065748307e-05,-6.966473571322813e-06,3.1749185795741537e-06},{0.7797688079449744,
    -1.0775650567721275e-18,-0.03588064768434799,0.014426056425365652,-0.0083408371009927,0.005570857628580734,
    -0.004022562441759669,0.0030503477646729813,-0.0023922036293495506,0.00192270924725245,-0.001585364034531017,
    0.0013177500921412743},{0.7754940913318351,3.404034431639667e-17,-0.032625997113337364,0.011751763788822714,
    -0.006082374174615965,0.0036358530816259548,-0.0023494677882430004,0.0015943266445208376,-0.0011188617933604195,
    0.0008046942563537158,-0.0005929032585724477,0.0004409630407057382},{0.7715884049164832,3.2139641861516136e-17,
    -0.029947365520240504,0.009771045088689697,-0.004577625784846489,0.002476411269720648,-0.0014481052202468235,
    0.0008892066285822764,-0.0005646584241368801,0.0003674638178753369,-0.0002447389908545219,0.00016469321647137621},
    {0.7679892796735643,-4.4206243378415865e-17,-0.02770145217751973,0.008261245633740484,-0.003535218632265575,
    0.0017466122117222045,-0.0009326939013629533,0.0005229848011979824,-0.0003032558220160957,0.00018020479872120509,
    -0.00010950987971228305,6.728795968204558e-05},{0.764649175206359,-3.113875778199071e-17,-0.025789258979885838,
    0.007082805282484071,-0.002789531690398779,0.0012682306128499225,-0.0006231569345175083,0.0003215046280281705,
    -0.0001715288783053783,9.378139581985656e-05,-5.240480084600562e-05,2.962530200075057e-05},{0.7615310301215807,
    4.5023777372137893e-17,-0.024140114974515358,0.006144533134914505,-0.002241546515699132,0.0009438076320401626,
    -0.0004294605420487923,0.00020518141999824652,-0.0001013686293555287,5.132057109149809e-05,-2.6543202972749238e-05,
    1.3894428169802278e-05},{0.7586053641123929,-2.848478762236057e-17,-0.02270216988487623,0.005384738750054625,
    -0.0018295172487152712,0.0007173400008934937,-0.00030394228320941016,0.00013521270159233277,-6.219932383913872e-05,
    2.9320383508678465e-05,-1.4114518991900583e-05,6.87920192185295e-06},{0.7558483224879156,1.53856224284705e-17,
    -0.021436487420879342,0.004760442243310478,-0.0015135420152150865,0.000555266582576506,-0.00022012080282485147,
    9.161510191806319e-05,-3.942814236560553e-05,1.7388224592253863e-05,-7.828612544809414e-06,3.569532633835618e-06},
    {0.7519870023936258,-2.433157190324829e-17,-0.03959511204215356,0.016052868736526473,-0.009311243939989583,
    0.006230787970366577,-0.0045050083879569,0.003419599103280352,-0.0026839206759637535,0.0021585954092547136,
    -0.0017808706576242649,0.0014809715590373665},{0.7472716490272181,5.439773470945841e-17,-0.03597461880276048,
    0.013068306763753498,-0.006785917867616403,0.004064252088000838,-0.002629825989121077,0.0017863909316246022,
    -0.0012546664976998004,0.0009029727682155477,-0.0006656987965371054,0.0004953483887160586},{0.7429666784829184,
    8.019551167389695e-18,-0.032996793562103895,0.010859071550694035,-0.0051042863859998185,0.00276675675838621,
    -0.0016201001831546802,0.0009958502586668455,-0.0006329015890135597,0.00041215649636787633,-0.0002746661024671789,
    0.0001849252469654427},{0.7390024125272394,2.504400135965353e-17,-0.03050148458960846,0.009175986099883397,
    -0.003939930207502471,0.0019504538122555974,-0.0010429929914984994,0.0005854478507562893,-0.00033976074099240875,
    0.00020203773002124597,-0.00012285070501818365,7.552382238599782e-05},{0.7353258529980459,-3.1804303329910314e-17,
    -0.028378108721213068,0.007862942254355017,-0.0031073951910409554,0.001415607463704448,-0.0006965526792287137,
    0.00035975549538915457,-0.00019210019737006052,0.00010510270141709,-5.8766542450968495e-05,3.323896522879547e-05},
    {0.7318957043861907,-5.339893005081322e-17,-0.026547762042572927,0.006817982367739405,-0.002495853778891976,
    0.001053042629795324,-0.0004798504673992088,0.00022950422758907546,-0.0001134832295563247,5.749505058378281e-05,
    -2.9754840992562533e-05,1.558381545460183e-05},{0.7286791336621602,-2.7105427438053676e-17,-0.02495257925831287,
    0.005972161279587237,-0.0020362242336422597,0.000800048231734746,-0.0003394768660496781,0.00015118632202797404,
    -6.960828211556435e-05,3.283671872772467e-05,-1.5817024067639118e-05,7.713092467944718e-06},{0.7256495847840564,
    1.5441974263012908e-17,-0.023549125031397097,0.005277463612783475,-0.0016838809938430474,0.0006190572136161047,
    -0.00024576814552759523,0.0001024031055563406,-4.4110007289633343e-05,1.946725281824075e-05,-8.770127505075562e-06,
    4.0009862344780545e-06},{0.7214092721631119,1.1080740462176655e-17,-0.04346547774687445,0.017785470371549896,
    -0.010353395994623838,0.006942963291290826,-0.005027394855178856,0.003820427800266372,-0.0030012180246176347,
    0.002415588798505269,-0.0019941714576102933,0.001659262659725728},{0.7162353188515157,8.066600164626997e-18,
    -0.03945569298578884,0.014467953717745131,-0.007540278930766442,0.0045258885482472215,-0.0029329741899153834,
    0.0019946042722288927,-0.0014021915676913248,0.0010099131737829638,-0.0007450243274193393,0.0005546852113406016},
    {0.7115157143391685,5.328731723622226e-17,-0.03616004564534792,0.01201386882592972,-0.005668162924640613,
    0.0030792061708714426,-0.0018058393075333094,0.0011113198118487414,-0.000706947377226623,0.00046073295834480704,
    -0.00030724166401789783,0.00020697544479526077},{0.7071730552802777,-4.4562282814702684e-17,-0.03340023545282426,
    0.010145374181623592,-0.00437265221908137,0.0021695386572539157,-0.001161965105303043,0.0006530039131311862,
    -0.000379326487896287,0.00022574291051571366,-0.00013735723155427552,8.449081224612798e-05},{0.7031485035187031,
    5.453283137424521e-18,-0.03105321864091699,0.008688499458766999,-0.003446827009441946,0.0015738194070070738,
    -0.0007756320826653403,0.000401081482742245,-0.0002143736722148609,0.00011738273582401224,-6.567752629229295e-05,
    3.7169743915575845e-05},{0.6993962389057936,2.0512810874450713e-17,-0.02903124701366301,0.007529678759250781,
    -0.0027670928287847427,0.00117017931247925,-0.00053408606967415,0.00025575633728143173,-0.00012658770180879687,
    6.41862075277916e-05,-3.32406125103216e-05,1.7419838921347562e-05},{0.6958798500896783,-2.6275843773474154e-17,
    -0.027270001056460567,0.006592153701670712,-0.0022564453418055697,0.0008886469970878709,-0.00037768584921734006,
    0.00016841082079477776,-7.761538704026129e-05,3.6643969864276314e-05,-1.7663277402360787e-05,8.618611737065586e-06},
    {0.6925699012756638,-1.823669616835516e-17,-0.02572122309875465,0.005822491308131236,-0.0018651624972089687,
    0.0006873236369629547,-0.00027332009680728226,0.0001140255721895728,-4.916552546960598e-05,2.1716420887896272e-05,
    -9.79031516238766e-06,4.469132249954597e-06},{0.687940364882884,1.6580749023162915e-17,-0.04743585320832909,
    0.01960880624061993,-0.011460823790282208,0.007704047170123912,-0.005587838313628323,0.004251720157324978,
    -0.003343425380209599,0.0026932890803331995,-0.002225036339829401,0.001852504446063193},{0.6822966115218397,
    2.4396711301373747e-17,-0.04301681254207026,0.015937795924131522,-0.008340400191681523,0.005018381998532963,
    -0.0032576817505748866,0.0022182965455120685,-0.0015610621372481087,0.0011253040879305432,-0.0008307616287935241,
    0.0006189099346847098},{0.6771533817248241,-1.1754491110314571e-17,-0.03938772198489925,0.013224223260301793,
    -0.006265219472988767,0.0034120135541132663,-0.0020044914708158747,0.0012351971880840407,-0.0007865786073048901,
    0.000513078566206255,-0.0003424048629672355,0.00023081203149136198},{0.672425084412338,9.024291235266524e-18,
    -0.0363509319083712,0.011159560844321445,-0.004830106507228521,0.002402555350496404,-0.0012890323232204925,
    0.0007253832961992186,-0.00042182270248908576,0.00025125601382438336,-0.0001529973404111865,9.417294706221902e-05},
    {0.66804670206333,2.6852865733578155e-17,-0.03377013406106739,0.009550744604632604,-0.0038051239054426693,
    0.001741860960767051,-0.0008599828799725958,0.0004453033585250223,-0.0002382684315610587,0.00013058414058354415,
    -7.31202210668721e-05,4.140938619910593e-05},{0.6639676344143032,1.1151833880292833e-17,-0.03154817895111234,
    0.008271816913283957,-0.0030530051186987302,0.0012944328073347324,-0.000591866576851423,0.00028381543227830623,
    -0.0001406303502843775,7.137163095453298e-05,-3.6990624103685286e-05,1.939810034625849e-05},{0.66014769526497,
    4.4535314800091785e-17,-0.029613895608073662,0.007237689450734999,-0.0024882718389084074,0.0009825139243450646,
    -0.0004183454136375189,0.0001868007299397052,-8.61866894279222e-05,4.072828678407258e-05,-1.964751609518162e-05,
    9.59333859648811e-06},{0.656554415084149,-3.1755669111689915e-17,-0.027913913725041078,0.006389160270556656,
    -0.002055757076043173,0.0007595654397639925,-0.0003026071537939422,0.0001264215129293195,-5.457185537850003e-05,
    2.4126934604524742e-05,-1.0885718594599867e-05,4.972596099864936e-06},{0.6515324977929254,4.421892003996828e-17,
    -0.05143295716357477,0.021500700721951652,-0.012623074724527788,0.008508134527745752,-0.00618265957306981,
    0.004711040328087354,-0.003708863076969406,0.00299050446826798,-0.0024725975837337705,0.002060059180481219},
    {0.6454165770192443,3.332128873195026e-18,-0.04658979219589135,0.017459087787168853,-0.00917828930388725,
    0.005537653282132821,-0.003601653185741461,0.002456094882516429,-0.0017304226075114657,0.001248596433089309,
    -0.0009225491033294904,0.0006877816406632902},{0.6398489755598268,1.7808109615222038e-17,-0.042615978359495744,
    0.014474044268432367,-0.006889191745274548,0.003762262983182702,-0.002214560671298006,0.0013666666628436794,
    -0.0008713316747651262,0.0005689218909046729,-0.0003799926447975728,0.0002563357632380011},{0.6347355355214093,
    2.833089620636866e-18,-0.039293479835364804,0.012204557743977067,-0.005307281318058248,0.0026473593898971937,
    -0.001423183671921886,0.0008020795071530438,-0.00046698487234995143,0.00027843469966269755,-0.00016969245595381048,
    0.00010452623344988354},{0.6300047867212114,1.6171866286075376e-17,-0.036472038626822925,0.010437385754880445,
    -0.004178206156691901,0.0019181166909635937,-0.000948900631128398,0.0004920947144536792,-0.00026362681279223265,
    0.00014462843495942826,-8.105456053688938e-05,4.593713079842081e-05},{0.6256011465779807,-5.0908368157755744e-17,
    -0.03404463506386481,0.009033495998254364,-0.0033502201000501124,0.0014245610285529141,-0.0006526881186018524,
    0.00031346435363403867,-0.00015551361388344416,7.900614867091555e-05,-4.098342953730802e-05,2.1508259541378936e-05},
    {0.6214805011721367,9.757871011628615e-18,-0.03193291646156603,0.007899024309368077,-0.002728883209537233,
    0.0010806769220033697,-0.0004610868997104514,0.00020620753853560947,-9.525982908073608e-05,4.506268202037773e-05,
    -2.1757766912839825e-05,1.0631876228628578e-05},{0.6176072295288693,-9.015213411911416e-18,-0.03007816147142906,
    0.006968699536142758,-0.0022532779685435155,0.0008350099792041581,-0.0003333541997697566,0.00013948689044116497,
    -6.028799120030424e-05,2.6682136653874363e-05,-1.204940235007289e-05,5.508443112790262e-06},{0.6121986748408114,
    -4.0146874186002183e-19,-0.05536483111119553,0.023430853806487413,-0.013825013877919914,0.00934624318074689,
    -0.006805998508995874,0.005194329081817,-0.004094600879282176,0.003305054989673087,-0.002735185862976566,
    0.0022806329524843703},{0.6056192681984441,-5.458518420885123e-18,-0.05008960269112045,0.019006464073580847,
    -0.010042523578636798,0.006077599955737309,-0.003961307059441746,0.002705768471240879,-0.0019088251804978236,
    0.0013788219272178408,-0.0010197209715372094,0.0007608364216031328},{0.5996368019456468,9.501598438803145e-18,
    -0.045765635059440944,0.015741740636396634,-0.0075312249107419805,0.0041256522123036266,-0.00243375209605052,
    0.0015044295647344212,-0.0009604409743474055,0.0006277978703697307,-0.0004197148329938642,0.00028336301118314227},
    {0.594148291119612,5.164538940122185e-17,-0.042153713286389345,0.013261731402841703,-0.005797159278060585,
    0.002900823781664045,-0.0015628903269157828,0.0008822997813103908,-0.0005143848434788705,0.00030704073352539213,
    -0.00018730651280657502,0.0001154718078090833},{0.5890756325860091,1.165116309035981e-18,-0.039089118518787984,
    0.011332154998902234,-0.004560408684333276,0.002100254976968222,-0.001041333014153007,0.0005409519800487874,
    -0.00029019788217783026,0.0001593868073710047,-8.941271165859497e-05,5.0716711144738386e-05},{0.5843581335574786,
    4.277666448169309e-17,-0.03645461997678239,0.009800372775853484,-0.0036540918058501617,0.0015587872186770817,
    -0.0007158059681894148,0.0003443722295771046,-0.0001710844433579512,8.701684032631271e-05,-4.518340397504361e-05,
    2.3732640593401413e-05},{0.5799476599425343,-4.2125104027227096e-17,-0.03416444930025941,0.008563404130488193,
    -0.0029744172329222345,0.001181756478717016,-0.00050537051911543,0.00022640742783522412,-0.00010473820015928108,
    4.9604211145507215e-05,-2.3974462773231934e-05,1.1725167674508035e-05},{0.575805371469485,3.711413436544893e-17,
    -0.032154369673480065,0.007549683742137093,-0.002454476352730484,0.0009125685925823786,-0.0003651617707657264,
    0.0001530664215142055,-6.625110768580251e-05,2.9355851673753517e-05,-1.3270192089623393e-05,6.071826264366285e-06},
    {0.5700267157442045,-3.011369582320742e-17,-0.059120218315458814,0.02536005025295753,-0.015046203617608642,
    0.01020583654903263,-0.007449439681341316,0.005695603944139625,-0.004496213490580762,0.0036335701826973286,
    -0.003010159604739837,0.0025121312924340925},{0.5630058362234116,1.3818939595922964e-17,-0.053413921746423634,
    0.02054734332177568,-0.010917819660283405,0.006629796515255907,-0.004331564108885863,0.0029640759871547933,
    -0.0020941181582513463,0.0015145101561463141,-0.0011212446320189907,0.0008373398689329997},{0.5566303211829695,
    2.1806994434340317e-17,-0.04874185892663656,0.016999760842009444,-0.008179565179877116,0.004496295990077925,
    -0.0026588454825888716,0.0016466213871971249,-0.0010527838069918018,0.0006890107051256534,-0.00046112874269090595,
    0.00031160830921012994},{0.5507882567713099,-3.3666047123025446e-17,-0.04484317838641054,0.014307442947266037,
    -0.006290490358735469,0.003158705294495303,-0.0017060264590794774,0.0009649175665977861,-0.000563401889781034,
    0.00033672215135424074,-0.00020563479988527952,0.00012688892201850627},{0.5453948496904362,3.935278804297519e-17,
    -0.04153842673143707,0.01221452217876282,-0.004944310158956147,0.0022851343108433765,-0.0011358284711814961,
    0.0005911659371712005,-0.00031762142774506867,0.00017467101431517006,-9.80938300267889e-05,5.569331672928883e-05},
    {0.5403842667470512,-5.124318127435052e-17,-0.03869999424102769,0.010554431536144758,-0.003958567772925041,
    0.00169473262445434,-0.0007802001554432861,0.00037607673863253825,-0.00018712504391969417,9.529815225303881e-05,
    -4.953813362896987e-05,2.6044829275018907e-05},{0.5357043401759818,-2.6810583564803517e-17,-0.036234592311732594,
    0.009214878227087907,-0.0032198678155888573,0.0012839162323018192,-0.0005504616966574105,0.00024708986209597824,
    -0.00011448539026520142,5.429123429007145e-05,-2.6269078352170613e-05,1.2859812238896874e-05},{0.5313130073533737,
    8.068423260998554e-18,-0.034072403033213426,0.008117880618880276,-0.002655160600443077,0.0009907996167143186,
    -0.00039748939196173325,0.0001669460282448502,-7.237310794184496e-05,3.211079227978878e-05,-1.453193053878666e-05,
    6.655636924136202e-06},{0.5251934629307582,3.874523321182352e-17,-0.06256870810242182,0.027239703925874,
    -0.016260439559684342,0.01107042906638523,-0.008101684986600381,0.0062066871158698005,-0.004907552666272274,
    0.003971296584517246,-0.0032937398525179017,0.0027515175063915695},{0.5177687131695857,-4.6138504348210636e-17,
    -0.056443373242633134,0.022041614726287687,-0.011784724599577558,0.007183253452387518,-0.004705666095112119,
    0.0032266297819164872,-0.0022833435824160028,0.0016536108712791075,-0.0012256609061883496,0.0009162410805643812},
    {0.5110362961326562,-1.8925332008730014e-17,-0.05143446802354426,0.0182143762972626,-0.008819347591354922,
    0.004866572369741451,-0.0028855892100739153,0.0017907393679941195,-0.0011468307171230681,0.000751599605910577,
    -0.0005036152942950689,0.0003406676754793871},{0.5048754683635478,-6.4298765066619395e-18,-0.04725948332711252,
    0.015312898353475123,-0.006775642416487783,0.003415542878575422,-0.001849804470468314,0.0010484317613188255,
    -0.0006131970485751373,0.00036699703108493463,-0.00022439360206884745,0.00013860832254369398},{0.49919484445643963,
    7.411753080035056e-19,-0.04372426422144464,0.013059592789820426,-0.00532062560932865,0.0024687341523664174,
    -0.0012304950965297905,0.000641797720244873,-0.00034541398033940436,0.00019022521495485223,-0.00010695925266633876,
    6.079075901256801e-05},{0.49392354317992937,-7.73555917006735e-18,-0.04069087646733287,0.011273916510806902,
    -0.0042561106300051796,0.00182936825431572,-0.0008445485326273816,0.0004079694307843368,-0.0002033449147250758,
    0.00010370757451648448,-5.397605297799431e-05,2.8408380015699403e-05},{0.4890054481655754,1.9460873331795482e-17,
    -0.03805857188872773,0.009834257144186556,-0.0034590270043195256,0.0013848285991199369,-0.000595412942365583,
    0.00026784831309620576,-0.00012432047099358154,5.9041025425909946e-05,-2.860291020062472e-05,
    1.4017442412365548e-05},{0.48439535192340155,1.5512239547635564e-17,-0.03575201140685495,0.008656227607527493,
    -0.0028501529689336723,0.0010678834586191443,-0.0004296430894363078,0.00018084680912748907,-7.85377437300363e-05,
    3.489718598481047e-05,-1.5812820244439018e-05,7.250190044358982e-06},{0.47797861022097443,1.9201814099858628e-17,
    -0.06556159301222915,0.029011843571997088,-0.017435524042241125,0.011919332761948764,-0.008748316496184197,
    0.00671699390950582,-0.005320561360719172,0.004311935148383819,-0.0035808669405378254,0.002994687027853627},
    {0.4702053337275258,-8.679085736483769e-18,-0.05904237903713414,0.023441689065044752,-0.01261948589402175,
    0.007724272865284773,-0.005075050533488114,0.0034877940208530044,-0.0024726562236786413,0.0017934300578132006,
    -0.001331033373530343,0.0009961327282901468},{0.4631684084603839,-5.085101458364146e-19,-0.05371876561573003,
    0.01934576959345571,-0.009432522055592115,0.005227037350672858,-0.0031086305463765983,0.0019335901363525406,
    -0.0012406073575826743,0.000814311333992488,-0.0005463592226110184,0.0003700044309597014},{0.45673860560725604,
    7.429268452633768e-18,-0.04928710741182951,0.01624425761645921,-0.007238560777036298,0.003664605835912078,
    -0.0019907344835939506,0.001130938344053341,-0.0006626940071775301,0.0003972408166852108,-0.00024321181230512956,
    0.0001504067357532813},{0.4508182338389715,1.4751234427551786e-17,-0.04553896012610953,0.013838228144789156,
    -0.005678186555990181,0.002646122887506866,-0.0013229762980828828,0.0006916627571707094,-0.0003729587227172298,
    0.00020571975827692464,-0.00011582869342209316,6.590915873067756e-05},{0.44533160405401767,1.7254170837172683e-17,
    -0.042326392795477535,0.011933456905622664,-0.004537690999775011,0.0019589948812002186,-0.0009072117475078639,
    0.000439286300750017,-0.0002193752833937113,0.00011206243796732972,-5.8404617297862334e-05,3.0775782114988465e-05},
    {0.44021885470273875,-2.0907132200247085e-17,-0.03954146064726294,0.010399238740541559,-0.003684485864451644,
    0.0014816622913263171,-0.0006390543697191385,0.0002881745551561632,-0.0001340148121965452,6.374804832267387e-05,
    -3.092615488280102e-05,1.5174235821781588e-05},{0.4354318072362424,1.3196412902176906e-17,-0.03710351643060465,
    0.00914495660831063,-0.0030332954373216907,0.001141614893264193,-0.0004607693054277048,0.0001944214964040986,
    -8.459873288430173e-05,3.765181202318577e-05,-1.7084938435663933e-05,7.842982603848211e-06},{0.4287777174431498,
    9.293949881562494e-18,-0.06793315006036735,0.030609593556712902,-0.018533345089630157,0.012727601215634852,
    -0.009371694153998826,0.00721341731348969,-0.005725158602510802,0.004647531983642358,-0.0038650983936400715,
    0.0032363739442346456},{0.4207309970065286,6.464250895525155e-18,-0.06106032407387314,0.024692946208957355,
    -0.013394146173982832,0.008236435626956643,-0.005429306615949149,0.0037406350094239967,-0.002657277168169205,
    0.0019305894909577132,-0.0014349140355403992,0.0010752225952967156},{0.4134599816069572,1.867446814505003e-17,
    -0.05545659789732165,0.02034844600545846,-0.009997949172879812,0.005566430546499128,-0.003321497152802973,
    0.0020712673750053374,-0.0013316744650471821,0.0008755839266840641,-0.0005883363514683034,0.00039893953056171426},
    {0.40682758903636124,-8.203452941054473e-18,-0.05079836033316483,0.017063011144542006,-0.007662859055318163,
    0.003897906945234146,-0.002124617482736511,0.0012101201059674927,-0.0007105700150529247,0.0004266793225533931,
    -0.00026162583225839277,0.00016200327896252506},{0.4007303281225583,2.4685590240192473e-17,-0.046863741090265844,
    0.014517389042815037,-0.006004024530974715,0.0028114733522028356,-0.0014104492901042824,0.0007393260721711269,
    -0.0003995012151200312,0.00022074801492930684,-0.00012447806547364644,7.092351299284511e-05},{0.39508811407312416,
    -1.6430954270984382e-17,-0.04349546409655534,0.01250438071968318,-0.004792863172960301,0.0020792586528090963,
    -0.0009662341458379997,0.00046910573865511173,-0.00023476705246049614,0.00012013841991436898,-6.270932325340377e-05,
    3.3087851907143574e-05},{0.38983768077757025,7.062204968283368e-18,-0.04057888960079283,0.010884695069571565,
    -0.003887702554627797,0.0015710970009202368,-0.0006799955988133397,0.00030745789243221696,-0.0001432910908782341,
    6.828323002257267e-05,-3.317744937093257e-05,1.630064396843118e-05},{0.38492816369403593,9.636927789744156e-18,
    -0.038028455053292026,0.009561856670623751,-0.003197510759511509,0.0012094164339370094,-0.0004898571230306384,
    0.00020725429592084502,-9.037928981834879e-05,4.0297640927188754e-05,-1.8314013859236788e-05,8.418567286631534e-06},
    {0.3781142996514169,-2.7516155487672635e-17,-0.06950174298638062,0.03195809794571113,-0.019510290908740343,
    0.013466210084694485,-0.009951024986793346,0.007680340655446372,-0.006109222445938403,0.004968445712252776,
    -0.00413856806064464,0.0034701068182115776},{0.369890831642809,-2.70100827970039e-17,-0.06233244571262047,
    0.025734519394499222,-0.014076877654417518,0.008700742357265031,-0.005756231928086786,0.003976939384517444,
    -0.0028314941759666015,0.002061019152925595,-0.0015343325560275287,0.0011513221653276203},{0.36247584636411984,
    1.3282508620977827e-17,-0.056497061894144364,0.021171904518998655,-0.01049167236371985,0.005871784851769902,
    -0.0035166408480211703,0.0021991676720226625,-0.0014171317800851884,0.0009335457139666533,-0.0006283108254026824,
    0.0004266484334532207},{0.35572536707449937,1.7020531709659087e-17,-0.05165393426927056,0.01772655821975281,
    -0.008030042705840824,0.004106288215150925,-0.0022465785181007758,0.0012832589661848437,-0.0007552597896766944,
    0.00045438934616080437,-0.0002790790098036647,0.00017305860074135466},{0.3495308575977685,-7.040646259036565e-18,
    -0.047569148594824855,0.015060637831976231,-0.006283556490855508,0.0029581304643669227,-0.0014896502637418273,
    0.0007831115083360298,-0.0004241525240577684,0.0002348272126497171,-0.00013263950641682353,7.568348499535968e-05},
    {0.3438084434557292,4.0969430189114764e-18,-0.0440771059778696,0.012955153158742664,-0.005009920303331832,
    0.0021852049537356573,-0.0010193629623039162,0.0004963553679524799,-0.0002489931419404056,0.0001276702590981509,
    -6.675385792211677e-05,3.527370648499413e-05},{0.3384919486466832,2.4765698238035344e-17,-0.04105724543796771,
    0.011263057292949968,-0.004059133341057609,0.001649366721666458,-0.0007166405140269435,0.0003249902347488489,
    -0.00015182500501808075,7.249450429697548e-05,-3.528401691777835e-05,1.7361412227209367e-05},{0.3335282322210396,
    1.619387564361487e-17,-0.03841968640570695,0.009882613567008338,-0.003334913938865838,0.0012683735118605753,
    -0.0005157497242159853,0.00021886467834130675,-9.567337257661404e-05,4.274423049817215e-05,-1.9459541801427244e-05,
    8.958578709391561e-06},{0.32665145050870686,-1.6841370252923606e-17,-0.07006980310284137,0.032975654903225064,
    -0.02031795922944193,0.014102475990406586,-0.010462618586688352,0.008099796779148408,-0.006458689663433671,
    0.00526340906633593,-0.004392022745717753,0.003688228473390336},{0.31837143801091705,1.131323097865016e-17,
    -0.06267956124132937,0.02650019842504996,-0.014632516490524486,0.009095904051912716,-0.006041995509937306,
    0.004187307913168047,-0.002988716341556137,0.0021799890996639423,-0.0016258146287415408,0.0012218568096183135},
    {0.3109240302820958,4.6785748895217826e-18,-0.05667603013634741,0.021761365021907356,-0.010887329142165138,
    0.006128633887011034,-0.0036855452635948405,0.002312047882953379,-0.001493649132649031,0.0009860322889156915,
    -0.0006648443770576034,0.0004521660783261556},{0.3041596754651394,-1.0411528144792432e-17,-0.05170226453811818,
    0.018188797498706565,-0.008319831393286606,0.004279572621846898,-0.0023511399338065645,0.0013472722643959223,
    -0.0007949738480192146,0.0004793080313404101,-0.0002949264514242426,0.00018317733769921012},{0.29796582054143866,
    -1.316053448592942e-18,-0.04751426599469747,0.015428620938444309,-0.006500841484744601,0.00307872459038052,
    -0.0015569255172658133,0.0008211253992143642,-0.00044590040275955764,0.00024740378795140084,-0.00014000396436325126,
    8.001465243667653e-05},{0.2922556195998876,1.4312575834068755e-17,-0.04393954639256213,0.01325177262340442,
    -0.00517610154403716,0.0022713646817494972,-0.0010640848510692618,0.0005198279084767575,-0.00026145551965494387,
    0.0001343549173603621,-7.038153694752284e-05,3.7251419488698396e-05},{0.28696064959966205,2.21020301248879e-17,
    -0.04085269821256261,0.011504641421482364,-0.004188401739050026,0.0017123264800978013,-0.0007472138978932797,
    0.0003399769866519691,-0.00015924981728249914,7.62087369415666e-05,-3.716249313104732e-05,1.8315935957886468e-05},
    {0.2820260383437095,1.7531215782883846e-17,-0.03816034549311534,0.01008107787895221,-0.0034369517762061247,
    0.0013152868325374616,-0.0005371641601188987,0.0002287150157544988,-0.00010024869270467661,4.4888930902833e-05,
    -2.0475272983097356e-05,9.441932997674395e-06},{0.27520424111494046,9.205439723505327e-18,-0.06942156251576229,
    0.03357451452808698,-0.020904008029578928,0.014600652454572337,-0.010880303821909501,0.00845176540760524,
    -0.006757772117054819,0.005519688845397365,-0.004614942590069162,0.0038819869070878827},{0.26701358133780906,
    2.6745391199356364e-17,-0.06190563731897144,0.026918957180799785,-0.015023170639110595,0.009398734814363423,
    -0.006271388137709069,0.00436131769383969,-0.003121581144099882,0.0022821812219474425,-0.0017054309163078809,
    0.0012838993373948508},{0.2596687617472343,-1.1273324290640449e-17,-0.0558136139274751,0.022058100328616707,
    -0.011156596187763108,0.006321280065173331,-0.0038188830289802656,0.0024041185016163524,-0.0015575228387958696,
    0.0010306210865283138,-0.0006963178786497629,0.00047440040031391053},{0.2530163628201757,8.849806469250029e-18,
    -0.050776928805087586,0.018400314505481845,-0.008510491373088411,0.004406752481412398,-0.0024323238180267584,
    0.001398768977350457,-0.0008277298190597613,0.00050025055936155,-0.0003084451736174207,0.00019191397989864214},
    {0.246941136187777,-5.203892592224474e-18,-0.04654408507738574,0.015579147563107016,-0.006638832900848764,
    0.0031653071889500453,-0.001608300354946189,0.0008512917245200766,-0.00046362746671868506,0.00025786290925458377,
    -0.0001462262611987776,8.372121911783719e-05},{0.24135431000261265,7.019404938179623e-18,-0.04293758336650807,
    0.013357766302248542,-0.005277786004918661,0.0023318539722933214,-0.0010976734769692505,0.0005382038870594603,
    -0.00027149616092619005,0.00013985693455460276,-7.341795724573447e-05,3.8929344941531345e-05},{0.2361860567378807,
    6.881483863828594e-18,-0.039828568538951815,0.011577579670570895,-0.004264449242350452,0.001755526971418713,
    -0.0007697950720975116,0.0003515521363027221,-0.0001651631851907106,7.923485290750196e-05,-3.872037632677644e-05,
    1.9118938168631132e-05},{0.23138046272036927,9.621889974196327e-18,-0.037121234072686284,0.010129146220108461,
    -0.003494521001640861,0.0013467291039559951,-0.0005527156143155953,0.00023622085550475377,-0.00010385109630668513,
    4.661877223446818e-05,-2.1310036692760793e-05,9.845189373611774e-06},{0.224754844857637,-7.865281954354051e-18,
    -0.0673179471626964,0.033660180101782886,-0.02121281896678444,0.014922546390481807,-0.01117592011904767,
    0.00871455751907417,-0.006989258601884294,0.005723325001953175,-0.004795733435106823,0.004041690417414689},
    {0.21682794284678233,9.276955708707532e-18,-0.059792884520222384,0.02691405551735142,-0.015208639017262975,
    0.009584534206841572,-0.006428103099376266,0.0044877220979899326,-0.0032220966657555256,0.002361791036418444,
    -0.0017688708654348437,0.0013342236664648588},{0.20974681954183463,4.571498659852649e-18,-0.053709499385026116,
    0.021998411906572216,-0.011269454451809142,0.006433040091759719,-0.003906684031030913,0.0024691539185645326,
    -0.0016047474915726967,0.0010646782986448722,-0.0007209623317344686,0.000492152855577761},{0.20335630670781374,
    -5.799124985524675e-18,-0.048692249887768387,0.018307278034807372,-0.008579000373308469,0.0044761514195884675,
    -0.0024837568068403807,0.0014341135063811287,-0.0008513907981243916,0.000515933231388291,-0.0003188481134120083,
    0.00019878139508935016},{0.1975400929364841,-8.723975572415212e-18,-0.04448539134763449,0.015466037603026991,
    -0.006679476539699776,0.003209459953624309,-0.0016395464828777761,0.0008713905178194387,-0.0004761326799987605,
    0.00026554047220110063,-0.000150931832147186,8.658980875285826e-05},{0.1922087666393657,4.599133245994314e-18,
    -0.040908762122878604,0.013233010359674,-0.005300545449837755,0.0023604489335055704,-0.0011172340247481499,
    0.0005500755578363002,-0.00027840957939487054,0.00014381495861585515,-7.567441442220965e-05,4.020790797322945e-05},
    {0.18729212869290554,-9.537956874425256e-18,-0.037831801606294714,0.011446627103858659,-0.004275556770048738,
    0.0017742663257643545,-0.0007823479565366031,0.00035879358890723937,-0.00016913472567659118,8.136753596596267e-05,
    -3.985784072131401e-05,1.9721358605414677e-05},{0.18273406693153474,-5.633094308482076e-18,-0.03515759364174103,
    0.009995564155016267,-0.0034979679949589336,0.0013590811495185638,-0.000560938088805849,0.00024076099644778777,
    -0.00010620926916056626,4.781263450264537e-05,-2.1908741443752773e-05,1.0143011423352265e-05},{0.17647192622413907,
    -4.959377964404443e-19,-0.0634910188670763,0.033126646073565975,-0.02118532744503255,0.015027855866373323,
    -0.011319706429750637,0.008865172725539463,-0.007134824786530327,0.005859394486831407,-0.004921951801307366,
    0.004156898076624247},{0.16901512931014762,-1.1663196373457467e-17,-0.05609737970586761,0.026398366179115795,
    -0.015146121762812942,0.009627248262353571,-0.006494935626589139,0.0045546235632271375,-0.003281779279163309,
    0.0024126343968729996,-0.0018115247639206688,0.0013693606051016231},{0.1623880171832601,1.2009856934517926e-17,
    -0.05013972345818018,0.02150907719636296,-0.011193844340609155,0.0064463139697632475,-0.0039384408721062775,
    0.0025005806205857105,-0.0016310814662489415,0.0010854056045867559,-0.0007368918438553304,0.0005041414465209134},
    {0.15643623054125114,5.9275443871176076e-18,-0.045241193355438615,0.017847021473452206,-0.00850068179719358,
    0.004475444347772464,-0.0024987266334362923,0.0014494726030107846,-0.0008636982730060896,0.000524995334170821,
    -0.0003252983891069357,0.00020326000638150752},{0.15104435971741045,7.476987956940193e-18,-0.041145749054985026,
    0.015034841068006859,-0.0066033420795531235,0.0032022885184827014,-0.0016462121520511518,0.0008790836151821808,
    -0.0004821486577073412,0.0002697338991442261,-0.00015372329139076566,8.839339051758219e-05},{0.14612389803358125,
    5.984354439946501e-18,-0.03767341306217337,0.012829586458372167,-0.00522878274456387,0.0023505655267462423,
    -0.0011197187016603607,0.0005539613345754889,-0.0002814522521542383,0.00014584732493993005,-7.695108884304696e-05,
    4.098138681330002e-05},{0.14160551290750223,1.665138533959678e-18,-0.034694024253891426,0.011069151596117249,
    -0.004208995104651091,0.001763563122298986,-0.0007827283156614756,0.00036073135077203716,-0.00017071129914038026,
    8.239022190627572e-05,-4.046935309071406e-05,2.007120479696145e-05},{0.1374339026456286,9.906090218509462e-18,
    -0.03211114885497628,0.00964204460313172,-0.0034367535697123115,0.0013485019956689073,-0.0005602869625371803,
    0.00024168213245892554,-0.00010703776632705017,4.834290499408172e-05,-2.2213227190806477e-05,
    1.0308591691447928e-05},{0.13173093253653126,-9.183738108903373e-18,-0.05765090425779771,0.031841600291767705,
    -0.02075652355820918,0.01487368307669711,-0.011280271494856093,0.008879422088888063,-0.007175206499917194,
    0.005912194676515371,-0.004980483311231308,0.004216584961379181},{0.12498487221743303,4.044624413942295e-18,
    -0.050559580991424595,0.02526046945426856,-0.014787956464418212,0.009499020545448223,-0.006453702247837556,
    0.004549502694434998,-0.0032917140150759434,0.0024282112525566744,-0.001828543334127732,0.0013856834588708848},
    {0.11903287476441578,-1.8316458180805057e-18,-0.04487056252342563,0.020494252741315232,-0.01089361309995626,
    0.006342190063194884,-0.0039030206708990734,0.0024914740110153874,-0.0016320669744855918,0.0010898636152748458,
    -0.0007421244821894699,0.0005090174593080168},{0.1137244386213682,6.542007842569994e-19,-0.040212437104755715,
    0.016935680335677956,-0.00824733605607379,0.004391315867398288,-0.002470100858907427,0.0014408021996045856,
    -0.0008622773299474057,0.0005260077785480968,-0.0003269171108322646,0.00020480380774598833},{0.10894739774154757,
    -4.841386326777525e-18,-0.036333576363864084,0.014211145878144071,-0.006387913055118227,0.003134128335271956,
    -0.0016235517291167106,0.0008718996905220539,-0.0004803414869046159,0.0002697051517881564,-0.00015418344058486995,
    8.88935620533784e-05},{0.10461599219090426,1.5511154365226912e-19,-0.033057572040260635,0.012080704561998846,
    -0.0050441584710896195,0.0022950060084814287,-0.0011018672204820136,0.0005482919072646081,-0.0002798406839521818,
    0.00014555289786187455,-7.703820068659982e-05,4.1138811566981124e-05},{0.10066323346678932,3.687822070209909e-18,
    -0.030257162706859003,0.010384623997388796,-0.0040495695105875465,0.001717936918216737,-0.0007686339562299776,
    0.00035633555791559496,-0.00016941470927787163,8.207512129348012e-05,-4.0444091624892075e-05,
    2.0113911910891917e-05},{0.09703583580742485,3.454504031687059e-18,-0.027838286154051588,0.00901328412595325,
    -0.0032980999936758656,0.0013107378777816867,-0.0005490974208964739,0.00023828885077267412,-0.00010603485571086144,
    4.807522223694967e-05,-2.2162389870910677e-05,1.0313794337998853e-05},{0.09211279234885184,6.36912181812764e-18,
    -0.0495493640036257,0.02960938246487855,-0.01984566713299833,0.014412025170241262,-0.011023576129301629,
    0.008731450461811587,-0.007089982486004599,0.0058651619059482945,-0.004957534969992243,0.004209174357018567},
    {0.08634621977223815,-4.3752426615441384e-18,-0.0429767171389569,0.023331064018624444,-0.014072945709838882,
    0.009168220609572099,-0.006284518521917412,0.004458897454517017,-0.0032424098380496626,0.0024016449397168613,
    -0.0018148150645688947,0.0013793357811710157},{0.08131325392399345,-5.355026569584352e-19,-0.03773892712033397,
    0.018804965387134023,-0.010320726673645135,0.006098858705724528,-0.0037881419982994653,0.002434340683865082,
    -0.0016029356623106915,0.0010749315957326885,-0.0007345663605547687,0.0005053605390941033},{0.07687093990408134,
    5.5230532231447655e-18,-0.033478040019156455,0.015440464766965223,-0.007780171657057694,0.004208155586380612,
    -0.002389940079940235,0.0014036970278971876,-0.0008445746939775496,0.0005174474406039935,-0.0003227730440647018,
    0.00020283656107860656},{0.07291320594302879,5.252454838594985e-18,-0.02995242427844333,0.012875385936547043,
    -0.006001115236317464,0.002993450323234459,-0.0015662338758139715,0.000847128377199772,-0.0004692694237692948,
    0.000264664351766214,-0.00015186880648883594,8.783809819507521e-05},{0.0693592959329501,-9.535499379176748e-19,
    -0.026993262129539695,0.010877840607234214,-0.004719624693512928,0.0021850247192166336,-0.0010599824456286534,
    0.0005313342821443147,-0.00027272336470885713,0.00014250047551757068,-7.571197978716588e-05,4.056245516023033e-05},
    {0.06614638941927062,-2.7622724518894587e-18,-0.024479167289907306,0.009293909681195802,-0.003774088294796982,
    0.0016305982059817373,-0.0007374291876889374,0.0003444610079958988,-0.00016472230547253034,8.017624701084345e-05,
    -3.966340571323586e-05,1.979142000505095e-05},{0.0632247164112824,-3.49503602718886e-18,-0.022320702431931277,
    0.008018256060609148,-0.003061839154870025,0.0012404101252506926,-0.0005254448434222334,0.0002298024596093862,
    -0.00010286885790504292,4.686380316125528e-05,-2.169055493856358e-05,1.0128586341790622e-05},{0.059302714042856246,
    1.9436771559937218e-19,-0.0392140695108431,0.026107181478909423,-0.018318992225378493,0.013580171844425951,
    -0.010509673162815942,0.008392003849850593,-0.00685650853176085,0.005700192836677819,-0.0048381928823927785,
    0.0041222471712621155},{0.054776124575668286,1.9151724425424928e-18,-0.03345133802905129,0.02033230778665882,
    -0.012893413007864004,0.008591535794806156,-0.005963551324495058,0.004267365996216121,-0.0031232196701533855,
    0.002325343924313329,-0.0017647668621974322,0.001346180942936908},{0.05088914764979137,3.3399093952140323e-18,
    -0.028912092171774532,0.01620010620942815,-0.009385964599004896,0.005684900293285778,-0.003578746314863739,
    0.0023204686096845095,-0.0015382768299553441,0.0010371295582383368,-0.0007119141554497278,0.0004916245059242704},
    {0.04751121770150566,1.3810141981061285e-18,-0.02526160058995893,0.01315104326772775,-0.00702362441340458,
    0.00390223173781528,-0.0022482646977969975,0.001332966829579729,-0.0008076607572060728,0.000497598660826195,
    -0.00031183265412003847,0.00019672610746452007},{0.044546173471343,1.6593386993459094e-18,-0.022275106194156524,
    0.010843519077637889,-0.005377871353295379,0.002761717954413225,-0.0014673706171208561,0.0008015336373348565,
    -0.00044726047225936475,0.00025371290342909446,-0.00014628276829678388,8.494810143546188e-05},{0.0419213438530714,
    -9.203949046027016e-19,-0.019796393729336847,0.009059742268603488,-0.004198409672008794,0.002005732312501076,
    -0.000989139749595976,0.0005009912057103887,-0.00025910271192450187,0.00013619475040746405,-7.271958876870911e-05,
    3.9121095604957416e-05},{0.039580614380742646,1.1420262865196678e-18,-0.01771371097908146,0.007655738942447735,
    -0.0033325290898518775,0.0014893045917174356,-0.0006854823049474871,0.0003237021549793033,-0.00015601586098472909,
    7.640841075275392e-05,-3.799204281528697e-05,1.9038491362621245e-05},{0.03747985642866864,-1.2949455906250548e-18,
    -0.01594513474480312,0.006533367517740671,-0.002683552497897035,0.0011272545941903975,-0.00048657631981870707,
    0.00021525279367950084,-9.714385177932208e-05,4.453814000473965e-05,-2.0722208193392145e-05,9.718949713672294e-06},
    {0.03470343204026086,3.0211973836962255e-18,-0.027502329745534838,0.02093256803178692,-0.0158758946393168,
    0.012248261002576762,-0.009677735094668372,0.00782370437011789,-0.006447404006078374,0.005395855729688408,
    -0.004605096473606536,0.003941569710805949},{0.03156442660940936,-2.266160134827564e-19,-0.022928215613326072,
    0.015963390134325538,-0.011005438827271067,0.007669922814959661,-0.005450926977060234,0.003954353583199885,
    -0.002921053728313357,0.002190195363762798,-0.001671811720456032,0.0012813961529773738},{0.02892805263256836,
    1.0462775943297593e-18,-0.019399327104819744,0.012461760125836786,-0.007889403510523018,0.005022135994292825,
    -0.0032469075269573057,0.0021376410662414997,-0.0014313186969695485,0.0009722328136991398,-0.000671409936872797,
    0.0004659838137988643},{0.0266835773001783,-1.8221623671609472e-19,-0.016618074360607873,0.009917647376072671,
    -0.00581292270758818,0.0034103559952063127,-0.002024478865776781,0.0012208439250923258,-0.0007477883743681658,
    0.0004643595227827888,-0.0002928455971770285,0.0001857164987212715},{0.024750703031181768,-7.218350151970873e-19,
    -0.014386765947382685,0.008022018303494055,-0.004382060488454606,0.0023870192406971486,-0.00131115897831616,
    0.0007298783670354808,-0.0004121138911897624,0.00023574087446016616,-0.00013682009734015512,7.988651467437014e-05},
    {0.023069687967689777,7.082018477337172e-19,-0.012569498933275558,0.0065793519177654155,-0.003368066758438218,
    0.001713999764139154,-0.0008768469904833472,0.0004535497298551641,-0.00023761426851208125,0.0001260183917263174,
    -6.775150663206511e-05,3.665488928824046e-05},{0.02159511804097612,5.918085267745832e-19,-0.011070141680390111,
    0.005461409503166846,-0.0026321922048320625,0.0012579482124731778,-0.000602697282330476,0.00029131338077097423,
    -0.00014240618210453515,7.041181115615075e-05,-3.526405785591868e-05,1.7775272101751756e-05},{0.020291833624733677,
    1.0743286674285183e-18,-0.009819031518870442,0.004581481158631078,-0.002087116977954252,0.0009408851477186726,
    -0.000424198081913631,0.00019253843300591202,-8.825326354943287e-05,4.0879210596917556e-05,-1.9164600778054348e-05,
    9.043174307566832e-06},{0.018599147358622208,1.1608665365194583e-18,-0.01659734274660129,0.014324673153518671,
    -0.012068407366704795,0.010038764063384524,-0.008325875207093863,0.006931914833448297,-0.005815478382227695,
    0.004923396393721393,-0.00423685850334701,0.0036497385126286587},{0.016726952145011787,4.1812033301644575e-19,
    -0.013512485885868415,0.010599660438930285,-0.008121612370347042,0.00613265604524003,-0.004602854927973319,
    0.003456702688593678,-0.002608648964375104,0.0019827081739537014,-0.0015276870523802607,0.0011791406612835702},
    {0.015189017392190194,-1.3094237222708887e-19,-0.011200408590386117,0.008050268313172659,-0.005658782994881093,
    0.003916567419813987,-0.0026885183059088247,0.001841755733776908,-0.0012647421307059859,0.0008729982056980595,
    -0.0006094133510541776,0.0004262400176113634},{0.013904580066938371,-5.992447511682721e-19,-0.009425474167953128,
    0.006248910796179468,-0.004058124635379658,0.0025943331058966537,-0.0016425644032314489,0.0010357116608589421,
    -0.0006532573790437699,0.00041340003264297916,-0.00026399396929919084,0.00016888424727582054},{0.012816695919728626,
    -4.607286054435611e-19,-0.008035034269309082,0.0049416657385343375,-0.0029821024384529293,0.0017719922664074423,
    -0.0010418782154986725,0.0006091460057565087,-0.00035561887910478423,0.0002079512944000811,-0.0001224656101000782,
    7.222031044770023e-05},{0.011884108729786735,7.85295515998584e-20,-0.006926729246248895,0.003971175562033911,
    -0.002237823742846502,0.001242413183641152,-0.0006822294043986248,0.00037210085564804866,-0.00020236043356313356,
    0.00011006880889474978,-6.0187344078849375e-05,3.2937815010509344e-05},{0.011076230275307686,-6.864021346527788e-19,
    -0.006029896670212205,0.003236386896234771,-0.0017102388714019794,0.0008910717153813528,-0.0004591365733606011,
    0.00023480499730790789,-0.00011959582235409476,6.0848693490392605e-05,-3.107447955908201e-05,1.587189003550883e-05},
    {0.010369925803650313,8.548965105743296e-19,-0.005294526347810062,0.0026704070243859664,-0.0013281980821499323,
    0.0006519004962357723,-0.0003164645425242831,0.0001524050164758086,-7.303682967689167e-05,3.492647464243995e-05,
    -1.6741224317585883e-05,8.020602000892542e-06},{0.009463066860393526,5.259169234082395e-19,-0.008835564495913398,
    0.008169813256958437,-0.007465580356186409,0.006741315008385669,-0.006023635810738094,0.005337911952770493,
    -0.004702885603443363,0.004129597386839458,-0.0036491656483767132,0.003201877173828405},{0.008473173762790928,
    8.403419860950657e-19,-0.007096880968682642,0.005901490232120329,-0.0048617354249748945,0.0039649409562714085,
    -0.0032027915345015714,0.0025660744175814445,-0.0020428927273369226,0.0016192443845302242,-0.0012880056887740604,
    0.0010173107180153742},{0.0076696580137957295,-6.837578972887897e-20,-0.00582191494643383,0.004395739541984749,
    -0.0032945124202159973,0.002448418295212812,-0.0018042684500344582,0.0013193748681284408,-0.0009585807045140699,
    0.0006930065800084328,-0.0005018213941922418,0.0003608194275237118},{0.0070047147915523,-2.6214043037480385e-19,
    -0.004860266151036783,0.0033588806646795907,-0.0023078305722174655,0.001574625865607247,-0.0010664679569717063,
    0.0007172153044758738,-0.00047932420241741903,0.00031869023989410366,-0.00021195552267500015,0.0001399842671591136},
    {0.006445510960537039,1.6173311750876182e-19,-0.004117605980485363,0.002622586014218417,-0.0016627486760884779,
    0.0010481478633312872,-0.0006565410517239514,0.0004086411061559215,-0.0002528479167398505,0.00015565084110445514,
    -9.576514015622219e-05,5.851814529727848e-05},{0.005968777869763559,1.9151347488386012e-19,-0.003532444988444392,
    0.002085845631199757,-0.00122721886608718,0.0007186352101688999,-0.00041854412239736646,0.00024239621989099295,
    -0.0001396193906580123,8.00243913854511e-05,-4.581720734135249e-05,2.6059446208099386e-05},{0.005557580209988494,
    -5.1504950968801576e-20,-0.0030633651071455725,0.001685641948526304,-0.0009248997389407274,0.0005055231214957195,
    -0.0002750353800326177,0.00014889645695875556,-8.02101725692667e-05,4.300843624448276e-05,-2.302877930932278e-05,
    1.2253155037863752e-05},{0.005199306839706237,1.5504490603223686e-19,-0.002681670357937131,0.001381323654947161,
    -0.0007099147972669935,0.0003636960480005847,-0.00018560074709281856,9.430670463555452e-05,-4.770564768855946e-05,
    2.402815649221107e-05,-1.2083587130732864e-05,6.040571068076584e-06},{0.0047407864386858995,-1.6251310221607896e-19,
    -0.004459974227659354,0.004192086360465473,-0.003934005189365651,0.0036831336360211068,-0.003437869268122384,
    0.00319773880501261,-0.002963175227769023,0.0027354970249662707,-0.0025368741230965834,0.002325477544007475},
    {0.00424191262448446,3.2804440036570224e-19,-0.003571265632458835,0.003005048150044771,-0.002526031709761445,
    0.0021200095736098813,-0.0017754448722569363,0.0014830139685229973,-0.001235105468009273,0.0010254714213305221,
    -0.0008544294441411786,0.0007050379179723975},{0.003837993163961152,-2.093508895940578e-19,-0.00292377397756882,
    0.0022265965371858695,-0.0016945483354169942,0.0012882498085662333,-0.0009778832253385114,0.0007408600477632345,
    -0.0005600139297606489,0.0004222653655381833,-0.0003193208851793364,0.00023951553704908425},{0.0035042895765513868,
    1.836132372252564e-20,-0.0024375638920217323,0.0016952094854271642,-0.0011784312017745666,0.0008185908846494905,
    -0.0005680166405733625,0.00039358303966131815,-0.00027224254834892314,0.0001879408922217368,-0.000130065386271392,
    8.939747507490429e-05},{0.0032239640135133373,-1.3506297080198816e-19,-0.002063233170605466,0.0013202315441671407,
    -0.0008445560725745645,0.0005399928944360132,-0.000344995432982194,0.00022018184119104045,-0.00014033718982624433,
    8.930806210677783e-05,-5.6958676187338855e-05,3.6116960206173976e-05},{0.0029851610452039674,
    -1.5862960041745949e-19,-0.0017689294111929003,0.0010481342037163598,-0.0006209271824556142,0.0003677161795467396,
    -0.00021764325349500887,0.00012871804740412424,-7.604906325458088e-05,4.4876589803659934e-05,
    -2.6534210351441798e-05,1.561177591529202e-05},{0.002779292807096159,-7.566119837055078e-20,-0.0015333730207689788,
    0.0008459360769077184,-0.000466628609848848,0.00025733517166030145,-0.00014185814866527513,7.815531584396048e-05,
    -4.302564498402049e-05,2.366369316142827e-05,-1.303847042057255e-05,7.153885300548306e-06},{0.0025999863224430322,
    -1.8983359113619737e-19,-0.0013419117077413001,0.0006925658150686769,-0.00035740442137707475,0.00018440984373570534,
    -9.512248551580337e-05,4.9045091871644626e-05,-2.5272713939242036e-05,1.3013214821648631e-05,-6.711924908623289e-06,
    3.449356227473783e-06},{0.0023705777797406557,1.6407491332660832e-19,-0.002231117442930936,0.0020998194181374094,
    -0.001976147867192536,0.0018595683002798984,-0.001749552111330463,0.001645587192054986,-0.0015471515058800825,
    0.0014538899414779701,-0.0013772058373562514,0.0012923544324370713},{0.002121044335269116,4.0369568217160534e-20,
    -0.0017861374260790275,0.0015040971927020518,-0.0012665607938227232,0.0010664805698229103,-0.0008979197869808894,
    0.0007558814596308407,-0.0006361531531905957,0.0005352281188135299,-0.00045325589828085016,0.00038099615258333945},
    {0.001919040501970901,1.8075860656623647e-20,-0.0014621241349500444,0.001113992717243546,-0.0008487404427405948,
    0.0006466288353757559,-0.0004926196964020849,0.0003752571985189938,-0.0002858124194615732,0.0002176469494384633,
    -0.0001666374374583007,0.00012681882357584506},{0.0017521675669906218,-7.515587150127207e-20,-0.0012188983890852351,
    0.0008479267946840416,-0.0005898563970571707,0.00041032452386335964,-0.00028542721221579007,0.00019853641339133708,
    -0.0001380845411022379,9.602845915316998e-05,-6.708653304078274e-05,4.6635873552378406e-05},{0.0016119942243629434,
    1.0668735178118427e-19,-0.0010316759710924822,0.0006602716102959955,-0.00042257165050026043,0.0002704421139046171,
    -0.0001730775060156692,0.0001107626116640435,-7.087954639194347e-05,4.5354191691711976e-05,-2.9134339236407885e-05,
    1.8637593951122915e-05},{0.0014925872718635767,6.839944303304039e-20,-0.0008844960146132729,0.0005241453611372869,
    -0.00031060378451466125,0.00018406007418796938,-0.00010907066179374578,6.463206039788206e-05,-3.829767171665504e-05,
    2.2692224922504106e-05,-1.3490920995349529e-05,7.992309740445124e-06},{0.0013896502308063897,1.2836142315946954e-20,
    -0.0007667035085738883,0.00042300864591221147,-0.00023338371420723002,0.00012876285704936216,-7.104082244302956e-05,
    3.9194061640728937e-05,-2.1623325770210862e-05,1.192922562411467e-05,-6.600455461010842e-06,3.640946919467182e-06},
    {0.001299995382878585,7.708032482503717e-20,-0.0006709653271646449,0.0003463046002403436,-0.00017873769847143856,
    9.225147665621804e-05,-4.7613364143327694e-05,2.457430547214288e-05,-1.2683148085361714e-05,6.545833221260992e-06,
    -3.3870387570069417e-06,1.7479335876343673e-06},{0.001185289911371884,-7.622586926772369e-20,-0.0011155669535379427,
    0.0010499452576339002,-0.000988183379209408,0.000930053839560707,-0.0008753421938230139,0.0008238460094968091,
    -0.000775353739833405,0.0007297270109118626,-0.0006927652354113209,0.0006519704603502653},{0.001060522553684049,
    -1.450579796854622e-20,-0.000893071618373492,0.0007520602829440863,-0.0006333138320645427,0.0005333166743499511,
    -0.00044910826361005716,0.0003781954240118109,-0.0003184732229337059,0.0002681851869719161,-0.00022741076367051495,
    0.00019149793401115688},{0.00095952040610157,5.237460891773529e-21,-0.0007310631648855306,0.0005570004991818866,
    -0.00042438130968183615,0.0003233380841763143,-0.0002463527116645561,0.0001876970937563308,-0.00014300535110519933,
    0.00010895595229227775,-8.348662388748985e-05,6.360793949919224e-05},{0.0008760838491652025,-4.53431410920322e-20,
    -0.0006094496336835262,0.0004239649603889135,-0.00029493213997016185,0.00020517016954665315,-0.00014272704652335875,
    9.928833153155789e-05,-6.906952720924131e-05,4.804826381047477e-05,-3.358345527664461e-05,2.336224048827979e-05},
    {0.0008059971412691717,4.597198671852463e-21,-0.0005158381702405464,0.00033013642827004266,-0.00021128731218660274,
    0.00013522387562141003,-8.654327300120105e-05,5.538768242756608e-05,-3.544789980702368e-05,2.268663273974756e-05,
    -1.4577727182387283e-05,9.329712955611774e-06},{0.0007462936493359708,-1.6790825000834295e-20,
    -0.00044224808843523533,0.0002620729410665346,-0.00015530248298871045,9.203109976653466e-05,-5.4536945914743114e-05,
    3.231818681938283e-05,-1.9151434452986956e-05,1.134899253038325e-05,-6.748465163570171e-06,3.999083373631272e-06},
    {0.0006948251218001044,4.3867856956779457e-20,-0.00038335179131585386,0.00021150443650765457,
    -0.00011669210269685773,6.438184935806835e-05,-3.5521019707229244e-05,1.95978029990224e-05,-1.0812546158616197e-05,
    5.965541214179434e-06,-3.3011445786859584e-06,1.8213194615594492e-06},{0.0006499976945889038,
    -1.2369738301532385e-20,-0.0003354826810696348,0.0001731523514901591,-8.936895553574875e-05,4.612591239729027e-05,
    -2.3806922330153847e-05,1.2287443481000569e-05,-6.341890878198004e-06,3.273233580747875e-06,-1.6938168272116792e-06,
    8.742276091310288e-07},{0.0005926449568318784,5.367878136078898e-22,-0.0005577834887785844,0.0005249726952923309,
    -0.00049409194837199,0.0004650277156432536,-0.0004376731570128014,0.0004119276735213455,-0.0003876863829022636,
    0.0003648812836137275,-0.0003464143055532478,0.000326036927914175},{0.0005302612771656071,2.8895311231987945e-20,
    -0.00044653581234918783,0.0003760301577628442,-0.00031665697493547107,0.0002666585051391743,-0.0002245545342049307,
    0.00018909855465375764,-0.00015923819560099392,0.00013409532065884576,-0.00011370983587022745,9.57556452096388e-05},
    {0.00047976020314988155,2.171769002331549e-20,-0.0003655315833521276,0.0002785002539816331,-0.0002121906696959774,
    0.00016166908166136902,-0.00012317644426842005,9.384871937384143e-05,-7.15029772093456e-05,5.447845857571435e-05,
    -4.174404079788817e-05,3.1804982795413006e-05},{0.00043804192461511924,-2.5865252678334004e-20,
    -0.0003047248171235245,0.00021198248147703448,-0.00014746607407004089,0.00010258509500302424,-7.13635447228985e-05,
    4.964420501313079e-05,-3.4534827879472135e-05,2.4024228053191832e-05,-1.6791863042756387e-05,
    1.1681295943440768e-05},{0.000402998570645912,1.7708254376242205e-20,-0.0002579190852133747,0.00016506821453651343,
    -0.00010564365730313478,6.761194067354386e-05,-4.3271642169023055e-05,2.769385098603674e-05,-1.772396497445332e-05,
    1.1343337577543496e-05,-7.288891606777974e-06,4.6648906156770296e-06},{0.0003731468246721413,1.1941379957769077e-20,
    -0.00022112404425015547,0.0001310364706667472,-7.765124187652448e-05,4.6015550741539476e-05,-2.726847456845195e-05,
    1.6159096040127872e-05,-9.575721064734953e-06,5.674501370575428e-06,-3.374238941388113e-06,1.999549000226126e-06},
    {0.000347412560901649,5.5514549449268776e-21,-0.00019167589566987465,0.0001057522183006174,-5.834605147618119e-05,
    3.219092495235033e-05,-1.7760510341881096e-05,9.798902257493043e-06,-5.406274129990567e-06,2.982771933563675e-06,
    -1.6505738544032941e-06,9.106614365356138e-07},{0.00032499884729509103,1.8581992564787363e-21,
    -0.00016774134053940161,8.657617576227093e-05,-4.4684477812777125e-05,2.306295629045898e-05,-1.190346132169701e-05,
    6.143721972465835e-06,-3.170945745618678e-06,1.636617158980421e-06,-8.469088271193354e-07,4.3711423327727007e-07}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_power_eps_zero_overlap)

/* eps at zero force by x = beta^5, 2^-40 <= x < 2^20: 480 rows of degree 10 in y = beta^5 2^-k, 8 to each octave k = -40 ... 19.
 * Relative error of the approximation: 2^-57.4 at most, proved for the whole cell of each row. Bits of the rows:
 * 67.1 69.6 68.6 68.9 71.1 70.5 70.1 72.6 66.5 68.4 68.6 68.7 68.5 70.5 68.6 69.4 66.6 67.0 68.2 68.3 69.6 69.7 68.6
 * 69.0 66.5 67.7 68.2 68.9 68.2 70.3 68.3 68.8 66.8 67.5 67.5 67.1 67.8 67.9 70.4 68.7 66.1 66.9 67.0 68.5 68.7 67.3
 * 67.1 69.2 66.9 66.9 68.2 69.1 68.4 68.7 67.5 67.1 66.5 67.7 69.1 68.0 69.5 68.8 67.2 69.5 66.1 68.4 68.9 65.9 67.8
 * 68.0 67.7 70.3 65.9 66.1 66.6 66.3 65.9 70.9 68.4 67.0 66.2 66.3 66.1 66.5 66.9 69.2 66.5 65.9 65.4 67.5 66.1 66.0
 * 66.4 66.0 67.0 67.8 64.3 65.2 67.3 67.2 68.4 66.4 70.7 65.9 64.3 64.8 66.2 66.3 66.9 67.6 68.4 69.8 64.3 64.7 67.5
 * 65.4 65.2 66.1 67.2 66.5 64.3 64.9 65.7 66.5 65.0 67.7 69.8 67.4 64.1 66.4 64.8 65.3 65.1 66.8 65.9 65.9 63.6 65.8
 * 67.3 65.7 65.6 69.1 67.6 64.9 64.1 64.7 64.1 65.0 65.1 64.9 65.9 65.4 63.6 64.0 66.6 64.4 64.2 66.7 67.8 65.2 63.2
 * 66.0 65.0 64.6 64.3 69.8 64.0 65.6 63.9 64.9 64.0 63.9 64.1 65.2 63.9 63.8 62.3 63.7 66.2 64.0 64.9 64.7 67.9 65.8
 * 63.0 62.6 63.9 63.9 66.1 63.9 65.0 66.2 63.1 63.1 63.0 64.2 64.1 65.9 65.1 68.8 62.4 63.2 62.7 65.7 63.6 64.1 64.4
 * 65.7 63.0 62.8 64.1 62.9 63.2 65.7 62.7 64.7 61.9 62.9 62.6 62.7 62.7 64.0 66.0 63.0 62.1 64.3 64.8 63.8 63.4 62.6
 * 62.9 63.7 61.7 62.8 62.9 65.3 63.1 65.7 63.4 65.1 61.3 61.6 62.5 63.1 64.7 62.8 62.8 62.7 61.1 62.5 62.5 62.7 62.4
 * 64.3 62.6 63.6 61.5 63.1 61.6 61.7 62.6 64.1 64.8 63.1 60.7 61.0 62.2 61.2 61.5 63.2 63.4 62.6 60.4 62.2 61.2 62.3
 * 63.1 62.5 63.1 63.5 60.9 61.0 62.2 61.6 62.8 61.3 63.7 62.7 60.1 60.7 62.3 61.1 64.0 62.3 64.1 65.1 59.9 60.8 62.1
 * 61.4 62.5 61.5 62.6 62.3 59.8 60.3 62.0 62.7 60.7 62.8 61.1 62.6 59.7 60.2 60.6 61.0 61.1 61.6 61.6 61.6 59.3 60.7
 * 60.5 60.8 61.5 63.6 60.9 63.0 59.2 60.6 61.4 60.7 61.5 62.1 62.3 61.8 59.4 60.9 61.0 60.8 60.6 61.9 62.3 62.5 59.5
 * 60.6 61.4 61.1 62.9 61.2 61.6 63.0 59.2 59.8 61.1 60.3 62.0 63.6 62.5 62.2 58.7 59.4 59.8 61.6 62.7 60.8 62.8 61.7
 * 58.4 59.8 61.0 60.5 61.2 60.7 61.9 60.8 58.4 59.6 60.9 61.0 60.1 60.6 60.0 60.3 58.6 59.8 59.9 61.3 60.6 60.2 62.0
 * 61.2 58.5 59.8 60.0 61.0 60.9 62.8 61.8 61.2 58.0 59.4 60.7 61.7 63.0 60.3 61.9 64.0 57.9 59.5 61.6 60.2 62.8 60.9
 * 61.8 60.3 58.1 59.8 60.1 60.0 60.5 61.6 60.5 63.3 58.1 59.4 59.5 59.6 59.9 60.8 61.9 61.1 58.1 58.9 60.8 59.2 61.6
 * 60.6 60.5 64.2 57.9 59.7 60.0 62.6 60.9 61.7 61.9 61.4 57.7 59.3 61.1 60.1 61.1 59.9 59.9 60.8 57.7 58.8 59.2 59.7
 * 61.0 61.4 60.2 60.2 57.4 59.2 59.2 60.3 61.2 60.0 62.3 59.9 57.8 58.8 59.3 60.1 61.7 61.7 59.6 62.1 */
#define COR_ROWS_POWER_EPS_ZERO_FORCE_FIRST 9.094947017729282e-13
#define COR_ROWS_POWER_EPS_ZERO_FORCE_FIRST_OCTAVE (-40)
#define COR_ROWS_POWER_EPS_ZERO_FORCE_OCTAVE_BITS 3
#define COR_ROWS_POWER_EPS_ZERO_FORCE_ROWS 480
#define COR_ROWS_POWER_EPS_ZERO_FORCE_END 1048576.0
COR_ROWS(double, cor_rows_power_eps_zero_force, 480, 12)
#ifdef COR_ROWS_HERE
= {
    {0.9954520847633285,3.8845378114093214e-17,-0.0008536680100103792,0.0003218368024543328,-0.00018182864562944382,
    0.00011982513985185991,-8.572594086177211e-05,6.455546428463538e-05,-5.034713106921639e-05,4.028128156165609e-05,
    -3.308382246012955e-05,2.7407210444812672e-05},{0.9953500766905095,-9.402904528737165e-18,-0.0007808899252995293,
    0.0002634182783988175,-0.00013315960236107334,7.851562807104561e-05,-5.025943000353176e-05,3.386374525735196e-05,
    -2.363064026434488e-05,1.6916105621068514e-05,-1.2414166196518807e-05,9.201302473414012e-06},{0.9952563390369931,
    -5.5186725773060725e-17,-0.0007207195324093779,0.0002199731235240471,-0.00010060852867255966,5.367291315072198e-05,
    -3.108512316018652e-05,1.8949841384685944e-05,-1.1964175564119233e-05,7.748950402450346e-06,-5.140022495842858e-06,
    3.4468464961850414e-06},{0.9951695018965698,1.3300074091854336e-18,-0.0006700577249943744,0.00018673210661871632,
    -7.797934903289549e-05,3.798338796021391e-05,-2.0085568566885943e-05,1.1179689322717875e-05,-6.44466247402923e-06,
    3.8111193268780134e-06,-2.3064512176495034e-06,1.4121664992470403e-06},{0.9950885187668058,4.189115936773685e-17,
    -0.0006267558652508009,0.00016069567920720554,-6.173853833032937e-05,2.7666892220500036e-05,-1.3459845655100114e-05,
    6.892465390683003e-06,-3.6553947186835127e-06,1.9887272093205258e-06,-1.1066423509917115e-06,6.233495350097818e-07},
    {0.9950125709390654,4.186075921465287e-17,-0.0005892750508376182,0.0001398977042091106,-4.976711374059715e-05,
    2.0650221623579467e-05,-9.302121713218168e-06,4.410560578984405e-06,-2.1658625918146e-06,1.0910603275436442e-06,
    -5.619047749331115e-07,2.930619171101597e-07},{0.9949410050314781,-5.158434693352056e-17,-0.0005564827298699225,
    0.00012300418433008813,-4.0739978724328264e-05,1.573876663874929e-05,-6.600776685146936e-06,2.913892576193451e-06,
    -1.3322245366296476e-06,6.24829747629512e-07,-2.9949254609957234e-07,1.4542710825278562e-07},{0.9948732907119017,
    -5.03393722722868e-17,-0.0005275259685557123,0.00010908315944339981,-3.379854687183304e-05,1.2214789875179019e-05,
    -4.792342595162737e-06,1.9790809751978313e-06,-8.464565290237589e-07,3.713862616800848e-07,-1.6647930894033603e-07,
    7.562292606293062e-08},{0.9947780058205117,-1.1977342935517341e-17,-0.0009797790077570618,0.00036946044819712785,
    -0.00020874948634292005,0.0001375715564084408,-9.842490111585772e-05,7.411988586094906e-05,-5.780742145907598e-05,
    4.625066937376801e-05,-3.7987039377134346e-05,3.1469430411976425e-05},{0.9946609293910026,1.2948720575857536e-17,
    -0.0008962322112875094,0.0003023931172771181,-0.00015287274275208938,9.014293108611105e-05,-5.770393392600995e-05,
    3.888051995186411e-05,-2.7131878587976042e-05,1.9422752342176755e-05,-1.4253878930983473e-05,
    1.0564992657879317e-05},{0.9945533470604815,-1.7919852128486202e-19,-0.0008271595775808971,0.00025251656166211823,
    -0.00011550140535798877,6.162061215935631e-05,-3.5689131825153715e-05,2.1756967994837152e-05,
    -1.3736719243312129e-05,8.897116105116833e-06,-5.901693077055301e-06,3.9576557546229e-06},{0.9944536861277623,
    4.47131121333662e-17,-0.0007690030722795374,0.000214355145623462,-8.952150025016623e-05,4.3607396646389214e-05,
    -2.306021627741759e-05,1.2835670500518763e-05,-7.399401488890462e-06,4.375777283628911e-06,-2.6482089605973486e-06,
    1.621430876139085e-06},{0.9943607451844712,-4.3483124951704705e-18,-0.0007192959050064961,0.00018446507122854618,
    -7.087607868207094e-05,3.176309052901853e-05,-1.5453094445413617e-05,7.913338005016105e-06,-4.196885521026294e-06,
    2.283360125980971e-06,-1.2706088747429815e-06,7.157162427541137e-07},{0.9942735843446249,2.3470622322480487e-17,
    -0.0006762713228971405,0.0001605890269624756,-5.713229329021619e-05,2.370736340468211e-05,-1.0679570045383112e-05,
    5.0637871188269834e-06,-2.486682806383799e-06,1.2526931719939817e-06,-6.451551235014766e-07,3.364848565159286e-07},
    {0.9941914535265158,1.6547634851890317e-17,-0.0006386290999502512,0.00014119547103589653,-4.67687865181898e-05,
    1.8068646513024147e-05,-7.5781530247215505e-06,3.3454297167103163e-06,-1.529550286276332e-06,7.173887776185144e-07,
    -3.4386221644435513e-07,1.669738986321653e-07},{0.9941137439150675,-4.447642632259347e-17,-0.0006053900341462858,
    0.0001252144431392311,-3.8799813866344786e-05,1.4022889273448686e-05,-5.501903267586922e-06,2.2721596205079213e-06,
    -9.718248500370758e-07,4.263986431640675e-07,-1.911418905128159e-07,8.682682782987878e-08},{0.9940043957415828,
    -1.6583310578232173e-17,-0.0011243763065162328,0.000424090760116091,-0.00023963587417973208,0.0001579338923119985,
    -0.0001129966381910191,8.509531528551198e-05,-6.636861092180826e-05,5.310114896479336e-05,-4.361412128163622e-05,
    3.6131458648757255e-05},{0.9938700424881118,-2.0616980571308874e-17,-0.0010284766340190462,0.0003471007518357769,
    -0.00017548907651927123,0.00010348381775601248,-6.624610591536252e-05,4.463726834520725e-05,-3.1149696492323555e-05,
    2.229932142967404e-05,-1.636514452048128e-05,1.2130006275070462e-05},{0.9937465870055798,5.550495016728271e-17,
    -0.0009491924773411908,0.0002898457217621552,-0.00013258714737995054,7.073939337532355e-05,-4.097186797049993e-05,
    2.497807616782798e-05,-1.5770745293843266e-05,1.021469766958582e-05,-6.775773737865696e-06,4.543865240077828e-06},
    {0.9936322239343662,-1.2385710887137255e-17,-0.0008824392442593768,0.00024603947947553554,-0.0001027628325589558,
    5.00599529205575e-05,-2.6473318364182146e-05,1.4735829943566205e-05,-8.494960767924745e-06,5.023740408483515e-06,
    -3.040397404469343e-06,1.8615803675517589e-06},{0.9935255741532504,-1.1756241635115088e-17,-0.0008253851158102987,
    0.00021172849003287396,-8.135857205888793e-05,3.646265773589639e-05,-1.774009781558315e-05,9.084718855901813e-06,
    -4.818232942774696e-06,2.621454967481267e-06,-1.4587675511351746e-06,8.217135014768331e-07},{0.993425558761105,
    2.6624247091588893e-17,-0.00077600192316942,0.00018432135181611518,-6.558137645536026e-05,2.7214753685222475e-05,
    -1.225999067416365e-05,5.813306391167456e-06,-2.854809938037982e-06,1.438165789964153e-06,-7.406869775821379e-07,
    3.8631494245632116e-07},{0.9933313167441822,-1.2579993161278663e-17,-0.000732797069449454,0.0001620598671491847,
    -5.3684693746992277e-05,2.074161688855032e-05,-8.699530229606116e-06,3.840571997499508e-06,-1.7559693381066668e-06,
    8.235980157444044e-07,-3.9477675718180745e-07,1.9169960113186692e-07},{0.9932421492552501,-5.265868676773246e-17,
    -0.0006946464890592786,0.0001437157418098053,-4.4536877801989627e-05,1.609720777210104e-05,-6.315993168705741e-06,
    2.608430485152539e-06,-1.1156750558516707e-06,4.895230942032488e-07,-2.1944199210270665e-07,9.968352222981989e-08},
    {0.9931166805038383,-2.6375865620544044e-17,-0.0012901232230629197,0.00048674552865440374,-0.0002750654053924255,
    0.00018129375086365447,-0.00012971463355777318,9.76879630931299e-05,-7.619168896158875e-05,6.096163194059181e-05,
    -5.0071022096106624e-05,4.14811230737605e-05},{0.9929625239049302,-2.4873534761646247e-17,-0.0011800564561461355,
    0.0003983734719588985,-0.00020143125935814782,0.000118788149148123,-7.604617060530714e-05,5.124208956539537e-05,
    -3.57596063631206e-05,2.5599915419098485e-05,-1.8787696212753032e-05,1.392581186046808e-05},{0.9928208748730707,
    5.00366618734271e-17,-0.0010890614594397867,0.0003326550455579225,-0.00015218485634738922,8.119994427974739e-05,
    -4.703236568500673e-05,2.8673619953089717e-05,-1.8104462899871098e-05,1.1726464202073303e-05,-7.778706605138215e-06,
    5.216507948939643e-06},{0.9926896611799653,6.528210370199911e-18,-0.0010124495933975534,0.0002823741537905937,
    -0.00011795050526658056,5.746177302244317e-05,-3.038882724025607e-05,1.6915812895447874e-05,-9.75191087375511e-06,
    5.76718424541196e-06,-3.490390691119428e-06,2.137132878253219e-06},{0.992567299866421,1.89711828543503e-17,
    -0.0009469703032654161,0.00024299248311159726,-9.338157690865622e-05,4.185347102118186e-05,-2.0363688007891772e-05,
    1.0428572122024385e-05,-5.531098557977005e-06,3.009362042317699e-06,-1.6746547999802558e-06,9.433346317806378e-07},
    {0.9924525525841633,3.898435011697862e-17,-0.0008902955491992055,0.00021153536734621424,-7.527190747706297e-05,
    3.123794656899556e-05,-1.407296954894997e-05,6.67316647306001e-06,-3.2771502699053034e-06,1.650960475323221e-06,
    -8.502951597833299e-07,4.4348889948870507e-07},{0.9923444310861487,4.2122891079024134e-17,-0.0008407120702285065,
    0.00018598459736550845,-6.161659523862125e-05,2.3807614365351575e-05,-9.985892103538285e-06,4.4085960798866515e-06,
    -2.0157278232934824e-06,9.454508275574835e-07,-4.5319238956411085e-07,2.2006885501611773e-07},{0.9922421332653615,
    -1.4208801625357015e-18,-0.0007969296348197939,0.00016493024775518072,-5.1116614713916904e-05,1.847648178451899e-05,
    -7.249839990436863e-06,2.9941913518909598e-06,-1.2807038525728866e-06,5.6194393692052e-07,-2.5191093366065905e-07,
    1.1443452849440364e-07},{0.9920981916141043,-7.41948550576281e-18,-0.0014800516398396904,0.0005585861404033766,
    -0.0003156976795616835,0.00020808710486979988,-0.00014889142703051605,0.00011213354336765177,-8.746071121769962e-05,
    6.997952144378204e-05,-5.747890919072468e-05,4.7618873041253925e-05},{0.9919213431190839,4.600533525464934e-17,
    -0.0013537410689245758,0.0004571608417216868,-0.00023118188563791374,0.00013634134898730238,-8.728721356108229e-05,
    5.8818534711672704e-05,-4.1047930174464514e-05,2.9386390830018132e-05,-2.1566967595102416e-05,
    1.5986109309544915e-05},{0.9917588479255744,5.482667412612853e-17,-0.0012493191188132052,0.0003817367098684675,
    -0.0001746588403619712,9.319722319234695e-05,-5.3983776667408604e-05,3.29126874985009e-05,-2.078154640513098e-05,
    1.3460731908253456e-05,-8.92929085988955e-06,5.9881999044335345e-06},{0.9916083277634249,-4.935176999559795e-17,
    -0.0011614043507978367,0.00032403102495031386,-0.00013536665866974946,6.595072325350695e-05,-3.487980436534277e-05,
    1.941635145655737e-05,-1.1193762392513677e-05,6.6200266738217615e-06,-4.006619322621542e-06,2.453254094791785e-06},
    {0.9914679659222352,3.804286486178137e-17,-0.0010862659649330715,0.00027883473767240807,-0.00010716830466959035,
    4.803588191561708e-05,-2.337279333329627e-05,1.1969994125769752e-05,-6.348809472641437e-06,3.454339771180443e-06,
    -1.922313301297856e-06,1.0828585722839876e-06},{0.9913363412133559,5.281589438993785e-17,-0.0010212320112474868,
    0.000242733592872298,-8.638368939952884e-05,3.585179449263627e-05,-1.6152300349250486e-05,7.6594173385522e-06,
    -3.7615957969230327e-06,1.895057178133297e-06,-9.76031271140056e-07,5.090775909314307e-07},{0.9912123194936765,
    4.789635814970663e-17,-0.0009643361647113461,0.0002134111663575933,-7.07115823638476e-05,2.7323653473999683e-05,
    -1.1461204724520737e-05,5.060099712594071e-06,-2.3136775275832007e-06,1.08522527762194e-06,-5.202020566362461e-07,
    2.5261279733380453e-07},{0.9910949802533088,4.652442123648516e-17,-0.0009140976346019476,0.00018924921933550172,
    -5.8660977319206436e-05,2.1204934350252624e-05,-8.320834212953398e-06,3.436636311684454e-06,-1.469992365897132e-06,
    6.450145444226198e-07,-2.8915596127534594e-07,1.3135591243214263e-07},{0.9909298779768994,1.857219619373912e-17,
    -0.0016976080283982674,0.0006409364424619914,-0.0003622852449400393,0.00023881161792489294,-0.0001708839075978841,
    0.00012870128789744097,-0.00010038594862730718,8.03232438957989e-05,-6.597625131542322e-05,5.46595150695393e-05},
    {0.990727037552982,-8.969962303248525e-18,-0.0015526777612301175,0.0005245450552007939,-0.000265291466154365,
    0.00015646918018734696,-0.00010017827060892698,6.750770443254057e-05,-4.7113272092423544e-05,3.3729417570894375e-05,
    -2.475487333471891e-05,1.8349410635223355e-05},{0.9905406660821046,7.299364012876965e-18,-0.0014328656877117718,
    0.0004379933850514978,-0.00020042461526882327,0.0001069537114468883,-6.195527380421968e-05,3.777417065888471e-05,
    -2.3851878345601234e-05,1.544984778702239e-05,-1.0249004963231685e-05,6.873357032357439e-06},{0.9903680344180507,
    -4.32360818110415e-17,-0.001331995964746276,0.00037177553965266557,-0.0001553330465780811,7.56841129349419e-05,
    -4.002964595538942e-05,2.228395232540636e-05,-1.2847364907716422e-05,7.59816507165495e-06,-4.598714321280518e-06,
    2.815846081580002e-06},{0.9902070578656682,-3.133652121258604e-17,-0.0012457871346030296,0.0003199133163043812,
    -0.00012297327351236148,5.5124380669583396e-05,-2.6823256873657e-05,1.3737636024051847e-05,-7.286583949363216e-06,
    3.96467808906086e-06,-2.206360971100026e-06,1.242888881134902e-06},{0.9900561056259065,2.3963135203843665e-17,
    -0.0011711729268396099,0.0002784883854287881,-9.912171877570709e-05,4.114168642275083e-05,-1.853654855598207e-05,
    8.790380554711816e-06,-4.317157537337231e-06,2.1750010231704704e-06,-1.1202386222804048e-06,5.843043083165201e-07},
    {0.9899138763042292,5.2072234307488846e-17,-0.0011058968672235062,0.00024484237120514404,-8.113733727843064e-05,
    3.1354767458242056e-05,-1.3152815548816297e-05,5.807179419012906e-06,-2.6553576747409196e-06,1.2455226975218983e-06,
    -5.970539953046375e-07,2.8993811689693834e-07},{0.9897793136610515,-3.634973122323205e-17,-0.0010482596867969832,
    0.00021711817656551265,-6.730897492513095e-05,2.4333003126900027e-05,-9.548818067680914e-06,3.9439761312932925e-06,
    -1.6870579736767842e-06,7.402802093959682e-07,-3.318705466177568e-07,1.5076298379293378e-07},{0.9895899823640475,
    1.3621690347606604e-17,-0.0019467035323521248,0.0007353036160906914,-0.0004156857713557323,0.00027403480955957984,
    -0.00019609922508416158,0.00014769843751385377,-0.00011520741472898681,9.218508722195732e-05,-7.572116102399804e-05,
    6.273416135387712e-05},{0.9893573830872647,5.413619270647812e-17,-0.001780437097390734,0.0006017579097646842,
    -0.0003043872926530903,0.00017954306762929604,-0.00011495777708224418,7.747059419336823e-05,-5.406816679126635e-05,
    3.8709665821779396e-05,-2.8410684531625076e-05,2.1059691524190527e-05},{0.9891436770083833,3.2202531610592016e-17,
    -0.0016429905479706044,0.0005024523233855762,-0.00022995556742589712,0.0001227230347719554,-7.109417504388254e-05,
    4.334807185931625e-05,-2.7372380622149797e-05,1.773073120187567e-05,-1.1762367720982203e-05,7.888438338698727e-06},
    {0.9889457328208126,5.309388660259345e-18,-0.0015272773772855449,0.000426478627083588,-0.00017821617547866274,
    8.684124588858435e-05,-4.593344965363538e-05,2.5571664777295792e-05,-1.4743353041139521e-05,8.719741708256393e-06,
    -5.277668678182302e-06,3.2316465694577438e-06},{0.988761158689432,-2.1219794988079156e-17,-0.0014283849083285749,
    0.0003669768370238785,-0.00014108635871166113,6.3249447056025e-05,-3.077874878190495e-05,1.576417554264549e-05,
    -8.36178351094853e-06,4.549836463521741e-06,-2.5320681699535096e-06,1.4263974230255707e-06},{0.9885880835885437,
    4.521034177060907e-17,-0.0013427948782240601,0.0003194507581954868,-0.0001137194366979071,4.720492389438721e-05,
    -2.126967964860802e-05,1.0086950106570907e-05,-4.9541144125772605e-06,2.495977788154854e-06,-1.285591315169113e-06,
    6.705652485634932e-07},{0.9884250144503843,4.0663031163894095e-17,-0.001267918239200506,0.00028085001843666384,
    -9.308478349392392e-05,3.597505317360243e-05,-1.5091897644280916e-05,6.6636285917399215e-06,-3.0470862161474396e-06,
    1.4293107803807542e-06,-6.851725057451224e-07,3.3273718680880334e-07},{0.9882707394922555,4.922194123401111e-17,
    -0.0012018053075517306,0.00024904371414634797,-7.721886393657434e-05,2.791814849495541e-05,-1.0956407008315624e-05,
    4.525572379427515e-06,-1.9359121363521615e-06,8.495036852524693e-07,-3.808458999885356e-07,1.7301555100609885e-07},
    {0.9880536795778675,4.5977918430325787e-17,-0.002231767845757221,0.00084340110620531,-0.00047687550597953396,
    0.00031440311172831615,-0.00022500136202965306,0.00016947524334528884,-0.00013219879853881172,
    0.00010578436876294405,-8.689401153123387e-05,7.199240820836073e-05},{0.9877870258232164,7.085387056244771e-18,
    -0.00204106163037988,0.000690199426437224,-0.00034918322576465006,0.00020598599617183336,-0.00013189739878619137,
    8.889070356909061e-05,-6.20409157942089e-05,4.4419129747267254e-05,-3.260200588566264e-05,2.4167119244153195e-05},
    {0.9875420420632638,2.5285877627541216e-17,-0.0018834167060863794,0.0005762807955780623,-0.00026379030300072815,
    0.00014079397235931715,-8.156830031855865e-05,4.973695692539872e-05,-3.140793978474011e-05,2.0345477449222122e-05,
    -1.3497341061805825e-05,9.052217398898273e-06},{0.987315136207135,3.513577997297031e-17,-0.0017507029559758463,
    0.0004891297140408533,-0.00020443296780615653,9.962624264794195e-05,-5.2699529963959156e-05,2.9339933785871128e-05,
    -1.6916642646747038e-05,1.0005439317931414e-05,-6.0560173359274875e-06,3.708339733561484e-06},{0.9871035645252418,
    -2.502223115085801e-19,-0.0016372843675296048,0.00042087560249108965,-0.00016183725205877187,7.255959590691724e-05,
    -3.531177713395301e-05,1.8086840643730736e-05,-9.59419320438273e-06,5.220597510654264e-06,-2.905443722142072e-06,
    1.636773082507784e-06},{0.9869051807740338,-1.1389433212776986e-17,-0.0015391247473706378,0.0003663600112134168,
    -0.00013044230508924343,5.4152240671422935e-05,-2.440175467440856e-05,1.1572926119394522e-05,-5.684178653374748e-06,
    2.8638978614014415e-06,-1.4751377593798864e-06,7.694523342820571e-07},{0.9867182723033371,4.602944170937294e-17,
    -0.001453253973065474,0.00032208334364322897,-0.00010677099926821472,4.1268824210501185e-05,-1.731394123812366e-05,
    7.645157112463407e-06,-3.496061193520559e-06,1.6399714893967977e-06,-7.861810647560587e-07,3.8179935040955813e-07},
    {0.9865414491464466,-3.8154586239632175e-17,-0.001377435437861551,0.0002856009278066661,-8.857055370150485e-05,
    3.2025744746188804e-05,-1.2569345194966925e-05,5.192086038576407e-06,-2.221124572140636e-06,9.746935650192774e-07,
    -4.369837759712937e-07,1.985237711168105e-07},{0.9862926736989946,-3.279254470191432e-19,-0.002557806322044839,
    0.0009671735816943367,-0.0005469640356135023,0.00036065184664024383,-0.00025811839435312925,0.00019443050351968964,
    -0.00015167182540734984,0.0001213709524482556,-9.97003452400364e-05,8.260475953643808e-05},{0.9859870725553754,
    -1.106948157639547e-17,-0.002339117392654227,0.0007914580857815359,-0.0004004904186371953,0.00023627900077700847,
    -0.0001513062597364233,0.00010197692186145829,-7.117762161742954e-05,5.096259574638682e-05,-3.740586077651767e-05,
    2.7728861703945072e-05},{0.985706320631692,3.5051623831370615e-17,-0.0021583476817319614,0.0006608028405670518,
    -0.0003025406895825277,0.0001614948634192024,-9.356856986589516e-05,5.705756020107416e-05,-3.603243103582094e-05,
    2.334202663773493e-05,-1.5485776913971133e-05,1.0386083865627164e-05},{0.9854462980898067,1.9840743375250654e-17,
    -0.002006171540386293,0.0005608508267839533,-0.00023445695129927519,0.00011427113919355161,-6.0451087269640185e-05,
    3.3657541709556416e-05,-1.9406979468450374e-05,1.1478808385731441e-05,-6.948036717588454e-06,4.254679124937173e-06},
    {0.9852038581908761,-2.3556805177276095e-17,-0.0018761243678172043,0.0004825736418884421,-0.00018560033003621777,
    8.322362082987748e-05,-4.050480020627149e-05,2.0747987060079806e-05,-1.1006331245343583e-05,5.989236960058204e-06,
    -3.3333302049914425e-06,1.8778757825633805e-06},{0.9849765395138002,-3.885320826307685e-17,-0.0017635767062517572,
    0.00042005413825520573,-0.00014959170663648405,6.210946806028226e-05,-2.7989694944144317e-05,1.3275382609799494e-05,
    -6.520678404881413e-06,3.2854890664892272e-06,-1.6923488438646287e-06,8.827785020352937e-07},{0.9847623779571097,
    4.182945888544297e-17,-0.0016651219514626176,0.0003692780983006254,-0.00012244239141571882,4.733187340197304e-05,
    -1.9859293668994224e-05,8.769633179010219e-06,-4.010472559482853e-06,1.8813539890982033e-06,-9.019278946202126e-07,
    4.380234196338797e-07},{0.9845597795193898,-2.6478625124853563e-17,-0.0015781948706249187,0.0003274414195793037,
    -0.00010156822486101283,3.67300549711292e-05,-1.4416895676395267e-05,5.9556410233806435e-06,-2.547894003949446e-06,
    1.1181356145656913e-06,-5.013106304426492e-07,2.2775462414754862e-07},{0.9842747523719848,3.958781116456126e-17,
    -0.0029304593294784687,0.0011088237958056576,-0.0006272103306908614,0.00041361612835884813,-0.0002960504517947323,
    0.00022301764885502114,-0.0001739810596799839,0.00013922912844600057,-0.00011437408630953649,9.476530665280291e-05},
    {0.9839246380285045,-2.3363313279492843e-17,-0.0026797472121256063,0.0009073325579088444,-0.0004592289515314785,
    0.00027096824671750137,-0.0001735355709120974,0.00011696669571255219,-8.164442523852421e-05,5.8459260115952124e-05,
    -4.2909888415689524e-05,3.1809981117449226e-05},{0.9836030110355864,-1.2835598614800926e-17,-0.002472515886408136,
    0.0007575172162418852,-0.000346900566872412,0.0001851984075603317,-0.0001073118453203179,6.5442544393185e-05,
    -4.132984329923192e-05,2.6774899829694963e-05,-1.7763909719189586e-05,1.1914376167400051e-05},{0.983305147387087,
    1.964990786059389e-17,-0.002298070707050519,0.0006429116755860694,-0.0002688249531733617,0.000131039258134115,
    -6.932803057360902e-05,3.86026395809673e-05,-2.2259541301793646e-05,1.31666269762588e-05,-7.969964416065982e-06,
    4.880623190553901e-06},{0.9830274390085558,6.177863066583931e-19,-0.002148998322314254,0.000553161569031484,
    -0.0002127999115118574,9.54330321256774e-05,-4.6451439802978154e-05,2.3795730105665377e-05,-1.2623788514964388e-05,
    6.869710339792828e-06,-3.823508769001762e-06,2.1540959815279412e-06},{0.9827670637095871,-1.8302429280474477e-17,
    -0.002019990014417344,0.0004814809202721349,-0.00017150915103997653,7.121934220209497e-05,-3.209811529166675e-05,
    1.5225069389950143e-05,-7.4787577446520344e-06,3.76839852529603e-06,-1.941170880374578e-06,1.0126055316794819e-06},
    {0.9825217695810554,5.5430672078080793e-17,-0.001907139455467403,0.00042326622038538713,-0.000140378113959182,
    5.427284140965451e-05,-2.2773747142284652e-05,1.0057347335818709e-05,-4.599624549530159e-06,2.1578326801063262e-06,
    -1.0345140412637275e-06,5.024314182029851e-07},{0.9822897290993113,4.4862129683656715e-17,-0.0018075051914290088,
    0.00037530180414246543,-0.00011644314618592726,4.211528670894628e-05,-1.6532264695324538e-05,6.8300025479291975e-06,
    -2.9221255146358032e-06,1.2824270984450017e-06,-5.749931545711735e-07,2.6123902684691737e-07},{0.9819632970068355,
    -3.6738460917956717e-17,-0.0033560622962677273,0.0012708410643282456,-0.0007190399749162156,0.00047424264923000563,
    -0.0003394783623299463,0.0002557513724809009,-0.00019952914947144726,0.00015968185835075747,-0.00013118106176068,
    0.00010869466958538447},{0.9815623480474285,-4.5423218157307466e-17,-0.0030687243627513013,0.0010398546770039906,
    -0.0005264402985035771,0.0003106726696380613,-0.00019898364787887833,0.00013412947419678625,-9.362994577440897e-05,
    6.704449653466174e-05,-4.9213654126600174e-05,3.6484413535308534e-05},{0.9811940472737045,9.85496240824094e-18,
    -0.0028312310606435484,0.0008681163284394902,-0.00039765506095975874,0.0002123268353786469,-0.00012304400443184454,
    7.50424116574459e-05,-4.7395504204518804e-05,3.070600226174159e-05,-2.03728947812456e-05,1.3664745714207339e-05},
    {0.980852979386671,5.116648333355597e-17,-0.002631320874062306,0.000736745521857394,-0.000308144244123333,
    0.00015022883368918968,-7.948894707882869e-05,4.426386542087458e-05,-2.5525592748325115e-05,1.5099292847763812e-05,
    -9.140239033144529e-06,5.5974834516579045e-06},{0.9805350084906354,-2.153040825221553e-17,-0.002460494648240801,
    0.0006338700755787773,-0.00024391585830694566,0.00010940467401693898,-5.3257790413333216e-05,2.7284628873313438e-05,
    -1.4475597237932245e-05,7.877856165212759e-06,-4.3848134392429215e-06,2.470419654744597e-06},{0.9802368996638213,
    -1.282028167994559e-17,-0.0023126663358392016,0.0005517095404759555,-0.00019658074763297462,8.164344131506391e-05,
    -3.680022189734117e-05,1.745684673621482e-05,-8.575593630489883e-06,4.321303398926424e-06,-2.226083272262034e-06,
    1.161274408994289e-06},{0.9799560717588113,-4.7416488127708516e-17,-0.0021833577732015756,0.00048498593776890854,
    -0.00016089369711488161,6.221468156488202e-05,-2.6109171187679555e-05,1.153129767880451e-05,-5.274068258832587e-06,
    2.4743702229150456e-06,-1.1863239264604121e-06,5.761835607514132e-07},{0.9796904301308917,2.4314376449753046e-17,
    -0.0020691970207039347,0.00043001257728628417,-0.00013345665985627805,4.8276720255358634e-05,-1.895305768542548e-05,
    7.830769571445043e-06,-3.350514260714219e-06,1.4705140176100224e-06,-6.593551606478511e-07,2.995795787234652e-07},
    {0.9793167491909747,-3.7513706796844e-17,-0.003841704118880956,0.00145603086716093,-0.0008240633827180383,
    0.0005436022522596141,-0.0003891729254258933,0.00029321477076524436,-0.000228772493638253,0.00018309537363392914,
    -0.00015042282361707685,0.00012464319547095723},{0.9788577990177395,2.2160089928866534e-17,-0.003512504338323799,
    0.0011913132318442036,-0.0006033004702958962,0.0003560921045782963,-0.0002281012812302107,0.00015377041185378725,
    -0.00010734791138121922,7.687176706961219e-05,-5.643006911597678e-05,4.183603217517773e-05},{0.9784362524385147,
    7.21760483413311e-18,-0.0032404266586611046,0.000994505762140738,-0.00045569037679759575,0.00024335739697103195,
    -0.00014104322500004194,8.602755374995604e-05,-5.4337398662671524e-05,3.520549027972296e-05,-2.335939063172922e-05,
    1.566855163015324e-05},{0.9780459036517751,-2.9766744612368636e-17,-0.0030114172227516697,0.0008439654943184818,
    -0.0003531000295241149,0.00017217685097479778,-9.111320157228356e-05,5.0741541715789835e-05,-2.9263188777223085e-05,
    1.7311245978082305e-05,-1.0479759223268565e-05,6.418084861375532e-06},{0.9776820132466638,2.6458982291094814e-18,
    -0.002815734933063168,0.0007260837609100127,-0.00027948943337030005,0.0001253834907248283,-6.104381199591757e-05,
    3.127641758426982e-05,-1.6594626494812416e-05,9.0316145480483e-06,-5.027254386859937e-06,2.8324985175982344e-06},
    {0.9773408744211907,-3.370353350038246e-17,-0.0026464047021585797,0.0006319424519647879,-0.00022524187261340582,
    9.356422896790879e-05,-4.217876573227851e-05,2.0010149239470306e-05,-9.830628276538636e-06,4.954029857570712e-06,
    -2.5521606216762657e-06,1.3314380931684866e-06},{0.9770195296362584,1.4476491662014205e-17,-0.002498294400072395,
    0.0005554920601278309,-0.00018434482554463753,7.129620188798977e-05,-2.992418313340468e-05,1.3217493722951678e-05,
    -6.04574343604813e-06,2.836585149705186e-06,-1.3600582073602484e-06,6.605943976077657e-07},{0.9767155788919846,
    9.436681573196763e-18,-0.002367539806809278,0.000492507123476437,-0.0001529032827011582,5.5321894202716614e-05,
    -2.1721761873270937e-05,8.975579523694271e-06,-3.840634878368272e-06,1.685731004198831e-06,-7.558957198487118e-07,
    3.434589006021251e-07},{0.976288035677368,1.5186862844558308e-18,-0.004395280589639728,0.0016675447874445878,
    -0.0009440946645929598,0.0006229031058991302,-0.0004460047029578183,0.0003360669233048936,-0.00026222728176252506,
    0.00020988409274423243,-0.00017244074699894317,0.00014289439563891967},{0.9757629766893512,1.5422746455258808e-17,
    -0.004018271587375602,0.001364277898685802,-0.0006911335703683046,0.0004080157758264931,-0.00026139738984445936,
    0.0001762342886325755,-0.00012303995616682437,8.811466068777264e-05,-6.468690925866342e-05,4.79597875967931e-05},
    {0.9752807519672761,-2.245932899804402e-17,-0.0037067011754239117,0.0011388238291114151,-0.0005220038603478511,
    0.00027882807586368665,-0.0001616234319981136,9.859041667801793e-05,-6.227756728483854e-05,4.035269402830677e-05,
    -2.677618067021999e-05,1.79612831423969e-05},{0.9748342523934114,5.3164445613045714e-18,-0.0034444665686892335,
    0.000966380838810827,-0.00040446311921753453,0.00019726303090947876,-0.00010440313424546618,5.814893669070829e-05,
    -3.3537919198287914e-05,1.9841417305169057e-05,-1.2012159646301575e-05,7.3569370648393576e-06},{0.974418048986619,
    -7.944916858479042e-18,-0.0032204070739051105,0.0008313548406106984,-0.0003201292779270288,0.00014364538918964524,
    -6.994478435521799e-05,3.584077411293503e-05,-1.9017999831521596e-05,1.0351258898312868e-05,-5.762148994394339e-06,
    3.2467248850575696e-06},{0.9740278958326293,2.1337939946210096e-17,-0.0030265314844349768,0.0007235270873207775,
    -0.0002579819152686039,0.0001071871629015297,-4.832703573991408e-05,2.292947215248504e-05,-1.1265814007544102e-05,
    5.677678931999781e-06,-2.9251386423567673e-06,1.5260963865962795e-06},{0.973660405413218,-2.3920753399819987e-17,
    -0.0028569602902555518,0.0006359660886479148,-0.00021113116825281726,8.167365234426624e-05,-3.428484488916996e-05,
    1.5145274329886019e-05,-6.928127596692348e-06,3.2508232547078037e-06,-1.5587685882634882e-06,7.57149966619296e-07},
    {0.9733128289297281,-3.812853323410137e-17,-0.0027072667180130993,0.0005638305256186394,-0.0001751138400834256,
    6.337182262657451e-05,-2.4886246685451118e-05,1.0284322064433687e-05,-4.401035326478842e-06,1.9318433709714543e-06,
    -8.663083452097816e-07,3.93648479062969e-07},{0.9728239572438412,-3.5036957355980895e-18,-0.005025538175862218,
    0.0019089096086469283,-0.0010811706056175208,0.0007135041805032498,-0.0005109541384275494,0.00038505078414145084,
    -0.00030047581665582296,0.00024051579057019387,-0.000197620354044831,0.0001637685829245648},{0.9722236399640111,
    -1.6317962968302306e-17,-0.004593976813443118,0.0015616223125175567,-0.0007914253544454324,0.00046733094047358753,
    -0.00029944483975247383,0.00020190957565382624,-0.000140978537906931,0.0001009690295226534,-7.412841271020663e-05,
    5.496291080914678e-05},{0.97167235312297,6.330888230554082e-18,-0.004237350253591029,0.0013034602642319317,
    -0.0005977140084604644,0.0003193433804647694,-0.0001851378318948067,0.00011294773800183598,-7.135356048649988e-05,
    4.6237081465620814e-05,-3.0682825199340245e-05,2.058300407131677e-05},{0.9711619562118443,2.6703864439259844e-17,
    -0.003937215222467074,0.0011060123421951136,-0.0004630975174714517,0.00022591385197224167,-0.00011958630576192181,
    6.661356356362367e-05,-3.842368040297397e-05,2.273369622122856e-05,-1.3764099628660562e-05,8.430414156081507e-06},
    {0.9706862330068573,2.1202953554295414e-17,-0.0036807896092350763,0.0009514160616354295,-0.0003665172964768146,
    0.00016450011642967389,-8.011278750799457e-05,4.1056109128257e-05,-2.1787526895092552e-05,1.1859636649103463e-05,
    -6.602258603074428e-06,3.7203100525096972e-06},{0.9702403221907728,3.988597316888174e-17,-0.0034589217510957756,
    0.0008279668103748591,-0.0002953489280920989,0.00012274280625345236,-5.5349866310911165e-05,2.6264869253191665e-05,
    -1.2905865625103346e-05,6.504756923245423e-06,-3.351482759967382e-06,1.7486323592542217e-06},{0.9698203454716873,
    -3.3698151332059707e-17,-0.0032648786793288394,0.0007277256039193958,-0.0002417001130146777,9.352230782359748e-05,
    -3.926536742373112e-05,1.7347632201531792e-05,-7.93638929497581e-06,3.7242313837746555e-06,-1.7858939658103316e-06,
    8.675256692971283e-07},{0.9694231559757109,3.116130555229811e-17,-0.0030935912816404446,0.0006451476882857984,
    -0.00020045850743151622,7.25622044778802e-05,-2.8500268063792597e-05,1.1779356633995095e-05,-5.041333094437507e-06,
    2.213090468206715e-06,-9.925008638077462e-07,4.5101786438543605e-07},{0.9688645507553248,2.7090622606021598e-17,
    -0.005742101789217943,0.002184053865925691,-0.0012375689595964657,0.0008169285662476976,-0.0005851217080496541,
    0.0004410011798062753,-0.0003441729717558051,0.00027551690998426156,-0.00022639577862787876,0.00018762664270832383},
    {0.9681786798684802,-4.8836632095747445e-17,-0.0052483588711538616,0.0017865448340610981,-0.0009058361867248215,
    0.0005350313713076977,-0.0003428862469291209,0.00023123253441440398,-0.0001614699037703997,0.00011565517413133147,
    -8.491692267148765e-05,6.29661556957559e-05},{0.9675489015315557,4.2338973510479804e-17,-0.00484038393530875,
    0.0014910728291746775,-0.0006840699522637844,0.00036557999015286,-0.00021198241734168022,0.0001293427912651132,
    -8.171990979870929e-05,5.295924033707382e-05,-3.514632924190566e-05,2.3578810135029103e-05},{0.9669658987195622,
    -2.4200987523250278e-17,-0.0044970624948976095,0.0012651058479980469,-0.0005299675543441095,0.00025860644586798325,
    -0.0001369177114249316,7.627847769190123e-05,-4.400345284057314e-05,2.6037404862415408e-05,-1.5765557698674326e-05,
    9.656938960244523e-06},{0.9664225573230777,-2.079240240085469e-18,-0.004203762151485625,0.0010881918699643597,
    -0.0004194141415369666,0.0001882940293305802,-9.171815401961887e-05,4.70103503147492e-05,-2.4950136457844607e-05,
    1.3582412538415161e-05,-7.5619275395786264e-06,4.261364376513656e-06},{0.9659133142232612,2.6710839257462912e-17,
    -0.003950007145739879,0.0009469302610045885,-0.0003379539262505455,0.00014048884751963311,-6.336462065278314e-05,
    3.007244539192229e-05,-1.477851256290063e-05,7.449306707357565e-06,-3.838457613778052e-06,2.0028494413469115e-06},
    {0.9654337315224976,9.419001562253278e-18,-0.0037280908127493746,0.0008322321702547898,-0.0002765501922242938,
    0.00010703797370406714,-4.4948794980226584e-05,1.9861533515524e-05,-9.08754066805557e-06,4.264831463112531e-06,
    -2.0452969262539424e-06,9.936044174814583e-07},{0.9649802084937317,3.105217837241865e-17,-0.003532211286076024,
    0.0007377500862059568,-0.00022934957891614083,8.304456713702903e-05,-3.26239559061185e-05,1.3485725841083046e-05,
    -5.772310589055916e-06,2.5342290292873983e-06,-1.1366154172953944e-06,5.165439791622222e-07},{0.9643424392002988,
    3.726566039427091e-17,-0.006555478057564342,0.0024973294610645172,-0.0014158249120500212,0.0009348759585986522,
    -0.0006697376629238633,0.000504852606096253,-0.000394052558081204,0.000315477845146653,-0.00025925423904016515,
    0.00021487383267275578},{0.9635594694903544,-4.746436444902799e-18,-0.005990943319105515,0.002042584996291745,
    -0.0010362125243941435,0.0006122252213471213,-0.00039243949560763774,0.0002646911812765916,-0.00018485699383693436,
    0.00013242000309197168,-9.723452320908619e-05,7.210504386045123e-05},{0.9628406315349946,-4.343100597438566e-17,
    -0.005524521586434934,0.001704600094614604,-0.0007824597383675275,0.00041829193307015033,-0.00024259927058994883,
    0.00014804754011491013,-9.354955852385661e-05,6.063184260571743e-05,-4.024180371709829e-05,2.6999284683803814e-05},
    {0.9621752677134907,-2.01845896328032e-17,-0.005132052777088066,0.0014461423611346479,-0.0006061440207684898,
    0.0002958721320286643,-0.00015668185019494316,8.730351231059323e-05,-5.0370052039220894e-05,2.9807761140884594e-05,
    -1.8050121581865166e-05,1.1057165735499158e-05},{0.9615552409792337,3.2762081152674227e-17,-0.0047967952032339336,
    0.0012438065097068957,-0.00047966386219843945,0.00021541258122926416,-0.0001049508146688831,5.3801684076730255e-05,
    -2.8558292034113824e-05,1.5548304740719188e-05,-8.657219268542695e-06,4.87897627340727e-06},{0.9609741887926665,
    -9.393023387421375e-18,-0.004506763878534026,0.0010822579203369819,-0.00038647447732239015,0.00016071189509354547,
    -7.250209436522553e-05,3.441481904536968e-05,-1.691473939701016e-05,8.527034462850923e-06,-4.394194768500693e-06,
    2.293007838096054e-06},{0.9604270359022998,-4.825003992065467e-17,-0.0042531424512226405,0.0009510967068820693,
    -0.0003162339003371206,0.00012243830955877737,-5.142762862165267e-05,2.272821601576912e-05,-1.0400582048288771e-05,
    4.881591554414229e-06,-2.341299123252586e-06,1.137494364768417e-06},{0.9599096647423405,4.543610357085835e-17,
    -0.004029294065771313,0.0008430601918393911,-0.00026224370994890224,9.498726147562473e-05,-3.732425468688848e-05,
    1.5431353109363518e-05,-6.606005020543781e-06,2.9005745512316423e-06,-1.3010477533271256e-06,5.913201722802606e-07},
    {0.9591821916544055,2.289656106735878e-17,-0.007477022999777286,0.0028535250636518416,-0.0016187441079322125,
    0.0010692333552741041,-0.0007661707297938109,0.0005776463771095417,-0.00045093327132846023,0.0003610579455647112,
    -0.00029674032140994004,0.00024596345424562286},{0.958289228168644,2.1141061425850925e-17,-0.006832007280959771,
    0.002333632875965769,-0.001184595720550663,0.0007001416234981581,-0.0004489025888143675,0.00030282887482901814,
    -0.00021152212218507563,0.00015153905759144175,-0.0001112845912704916,8.253105709265821e-05},{0.9574695349049038,
    -1.5078188940627245e-17,-0.00629915478115687,0.001947268046254278,-0.0008944164696025992,0.0004783148411950202,
    -0.00027747942153793663,0.00016936456227302445,-0.00010703516802661784,6.938053960113626e-05,
    -4.6053087075112414e-05,3.090093162440458e-05},{0.9567109286202552,1.2181267856711036e-17,-0.005850837031324819,
    0.0016518427005423487,-0.00069280856297931,0.00033829926126141714,-0.0001791944866610653,9.986636809407398e-05,
    -5.76268067981561e-05,3.4106304328205955e-05,-2.06552584484667e-05,1.2654152324556847e-05},{0.9560041083711941,
    -2.7322121857888066e-17,-0.005467910670668326,0.0014205872636008864,-0.0005481971146210482,0.0002462822796948445,
    -0.000120021426364522,6.153920116920478e-05,-3.267036311294019e-05,1.778929982110497e-05,-9.906042176559825e-06,
    5.583286066552567e-06},{0.9553418022007778,-4.407796609497278e-17,-0.005136672566019117,0.0012359643109717945,
    -0.000441657086760753,0.0001837288592860638,-8.29072607921598e-05,3.936151983395007e-05,-1.9348998355459076e-05,
    9.755423941054842e-06,-5.027754737531218e-06,2.6238583054948593e-06},{0.9547182099279088,-1.8044577323045828e-18,
    -0.0048470432623168675,0.001086080909956857,-0.00036135949089481927,0.00013996382571119191,-5.880433234889324e-05,
    2.599344192898435e-05,-1.1896628368821065e-05,5.5844893249946076e-06,-2.6787134114836977e-06,
    1.3015452271422026e-06},{0.9541286262241702,-4.279016188308146e-17,-0.004591435614380492,0.0009626323078999091,
    -0.000299643286111913,0.00010857619369763906,-4.267527529667075e-05,1.764720822937379e-05,-7.555786131331869e-06,
    3.3180379140094435e-06,-1.4884646023988112e-06,6.765644896333785e-07},{0.9532997244171418,4.799398304626845e-17,
    -0.00851885988172854,0.003257866896719013,-0.001849410050510418,0.0012220826416717739,-0.0008759348869980251,
    0.0006605364981327957,-0.0005157237523185338,0.00041298988307045595,-0.00033945979109129633,0.00028140016944828674},
    {0.9522824328979579,-3.02272215982364e-17,-0.0077824973998879545,0.002663927702143071,-0.0013532264965267686,
    0.0008001351338701395,-0.0005131572978196331,0.00034624718630505075,-0.00024188920948392908,0.00017331824581292955,
    -0.00012729315522697762,9.441269887564822e-05},{0.9513487824729433,1.6757531521320472e-17,-0.007174265783216044,
    0.002222587370752495,-0.0010216210302831075,0.0005465686580640606,-0.0003171649219191721,0.0001936285480274979,
    -0.00012239018198962058,7.934471474727358e-05,-5.2673280639311617e-05,3.5346555209609546e-05},{0.9504848562692857,
    -3.987691559487795e-17,-0.006662592059691972,0.0018851639813515628,-0.0007912553274301735,0.0003865349166406651,
    -0.00020480388213347535,0.00011416343850308818,-6.588809957809886e-05,3.900124629265103e-05,-2.362254388121909e-05,
    1.4473508996990142e-05},{0.9496800310534718,-2.973380280971834e-18,-0.006225602076846362,0.001621060456463279,
    -0.0006260321207054279,0.0002813717797188111,-0.00013716212915080967,7.034337188844632e-05,-3.7350914321360885e-05,
    2.0340826811338743e-05,-1.1328254410869256e-05,6.385548913587493e-06},{0.9489260019046007,-1.1011509364611201e-17,
    -0.005847639480747014,0.0014102337302033408,-0.0005043177118939215,0.00020988766661094444,-9.47397502670993e-05,
    4.4989272465965906e-05,-2.2119371039179696e-05,1.1153827243132636e-05,-5.7491778310653525e-06,
    3.000670515123521e-06},{0.9482161453885869,3.3861654969282583e-17,-0.005517189155844824,0.0012390928515831501,
    -0.00041259119841505876,0.0001598783548633455,-6.719164389083621e-05,2.9707673055471273e-05,-1.3599003081810294e-05,
    6.384561490568476e-06,-3.062869753907027e-06,1.4883617895189894e-06},{0.9475450888172035,4.007894948362437e-17,
    -0.005225584027453201,0.0010981481218978071,-0.00034209645168056514,0.0001240151380958932,-4.8758500625723876e-05,
    2.0167418265913687e-05,-8.636412536782784e-06,3.793153341247982e-06,-1.701817452169783e-06,7.73626418268438e-07},
    {0.9466017863414922,4.7321533172154844e-17,-0.009693729427551048,0.003716001107667066,-0.002111182931189295,
    0.0013957032721665036,-0.0010006930089777168,0.0007547933983733198,-0.0005894261153871177,0.00047208288450529846,
    -0.00038808253736477474,0.00032174264603506385},{0.9454443221091157,-4.18299566766885e-17,-0.008853884385153615,
    0.003038040857829535,-0.001544542880141576,0.0009136868147094938,-0.0005861708844560067,0.00039560758743829627,
    -0.00027642525562440056,0.0001980950722779387,-0.00014550990745737416,0.00010793631524999106},{0.9443822458317492,
    5.016628457683087e-17,-0.00816028623880378,0.0025343373037616467,-0.0011658996969354878,0.0006240579578829773,
    -0.0003622496761478094,0.00022120710640322142,-0.00013984948701736296,9.067799293985978e-05,-6.020513286688039e-05,
    4.04055445062634e-05},{0.9433996740094868,-3.70495826689938e-17,-0.007576883121350014,0.002149284375166275,
    -0.0009028885151782482,0.00044128486456139146,-0.00023389119180832328,0.000130410210100653,-7.527968009907334e-05,
    4.456769761910279e-05,-2.6997819811742925e-05,1.6543506286616933e-05},{0.9424844837953681,4.1514923836547806e-17,
    -0.007078700875066637,0.001847937121517309,-0.0007142722957088843,0.0003211916622624328,-0.00015662672542619764,
    8.034624975043154e-05,-4.267086103171759e-05,2.3241863369386265e-05,-1.2945733196996035e-05,7.2981788346596014e-06},
    {0.9416271990639408,3.247920449051365e-17,-0.006647866338780395,0.001607406782386624,-0.0005753395214823154,
    0.00023956696500045295,-0.0001081739178501291,5.1382101289229524e-05,-2.526764829203563e-05,1.27435169923697e-05,
    -6.569516286351617e-06,3.4292521834429286e-06},{0.9408202631640601,-3.833911095063165e-17,-0.006271235335619858,
    0.0014121743237233307,-0.0004706471524431158,0.00018246873480243697,-7.671258538463059e-05,3.392612384633759e-05,
    -1.5533280163894774e-05,7.293930428353596e-06,-3.4996308118781533e-06,1.7008126663403847e-06},{0.9400575470675661,
    -2.4727314166732025e-17,-0.00593891562291745,0.001251404802495726,-0.0003901951822352726,0.0001415254230533454,
    -5.5662767727157485e-05,2.302929336180474e-05,-9.864054145610325e-06,4.333092387772952e-06,-1.9443504085315687e-06,
    8.839910828115409e-07},{0.9389855859479641,-2.4040988434325386e-17,-0.011014750598057722,0.004233950231617383,
    -0.002407686023522898,0.0015925676648687788,-0.0011422557634650475,0.0008618043595115037,-0.000673137070817994,
    0.0005392241539398617,-0.00044334411264295315,0.0003676050964829916},{0.9376705520311059,-7.62815739414288e-18,
    -0.01005793407149202,0.0034608370363503984,-0.001761168720853818,0.0010424003615940082,-0.0006689949269741228,
    0.0004516313303932328,-0.00031564063198533544,0.0002262390709044473,-0.0001662086634744465,0.0001233065252637281},
    {0.9364641817290594,-2.7685798084182394e-17,-0.009267877437346538,0.002886530752388148,-0.0013292144129665741,
    0.0007118687643805456,-0.00041337841705082454,0.00025250052161391256,-0.00015966945205445648,0.0001035483701460491,
    -6.87611846212188e-05,4.615400510982833e-05},{0.9353483650440514,3.087795870568397e-17,-0.008603452480478677,
    0.0024475716003912458,-0.0010292140967521457,0.0005033109557343435,-0.000266869625514636,0.00014884102298160182,
    -8.593863266745456e-05,5.088770015906846e-05,-3.0831241162953705e-05,1.8895117796974677e-05},{0.9343092818705268,
    -1.0368652025062969e-17,-0.008036172505187403,0.002104084369525602,-0.0008140991405184907,0.000366292306276858,
    -0.00017869000723634676,9.169126892957471e-05,-4.87074224462247e-05,2.6534937652450015e-05,-1.4782388956745242e-05,
    8.33476303377506e-06},{0.9333361308899426,-4.838168780766467e-17,-0.00754565319639291,0.0018299542263969788,
    -0.0006556667543833048,0.0002731743719871028,-0.00012339830728159612,5.863116789735541e-05,-2.883928669940765e-05,
    1.4547679618393565e-05,-7.500837518666032e-06,3.915953796356391e-06},{0.9324202998139189,-7.262707533810069e-19,
    -0.007116905459476392,0.0016074768343276053,-0.0005362940343526493,0.00020804335640030617,-8.750003565397375e-05,
    3.8708633802584827e-05,-1.7727248293917444e-05,8.325796168791454e-06,-3.9953917180375665e-06,1.94203171041227e-06},
    {0.9315548042689578,-6.751262163711756e-18,-0.006738649862449357,0.001424292871121512,-0.0004445706053228424,
    0.00016134471877595892,-6.348392490153378e-05,2.6273227072958802e-05,-1.1256263971431158e-05,4.945656847543681e-06,
    -2.2195990423746414e-06,1.0092795193523921e-06},{0.9303386354577349,2.1883306941318908e-17,-0.012495066102674023,
    0.004818034267066509,-0.002742774653720225,0.0018153262029609169,-0.0013025736379052473,0.000983069101339829,
    -0.0007680454804984907,0.0006153775825513772,-0.0005060451449084234,0.0004196571274083845},{0.9288470838592188,
    -2.792357110389357e-17,-0.011406371315812803,0.003937405687947187,-0.0020058890673027227,0.0011879912008141134,
    -0.0007627599794865602,0.0005150966955883566,-0.00036008763658187433,0.000258151054500388,-0.0001896869906714621,
    0.00014074606049670505},{0.9274791602231928,-5.4536338109046355e-17,-0.010507610271507074,0.003283354048171755,
    -0.001513642879385206,0.0008111604282437871,-0.00047124302718451044,0.0002879399900491036,-0.0001821270593117702,
    0.00011813778229998104,-7.846355845722772e-05,5.267466142490419e-05},{0.9262142396865893,-5.12102956972755e-17,
    -0.009751913554053953,0.002783529445607498,-0.001171823451477725,0.0005734249413706707,-0.00030418184749169736,
    0.0001697079096192893,-9.801283982055449e-05,5.804997545408552e-05,-3.5177157742564696e-05,2.1561965974612198e-05},
    {0.9250365857395372,4.758525444067787e-17,-0.009106823188989262,0.0023924775145378694,-0.0009267586077692654,
    0.00041725909066050494,-0.0002036458751926851,0.00010453245921884796,-5.55437815009318e-05,3.0265977897651855e-05,
    -1.6864098159022194e-05,9.51003215137634e-06},{0.9239339012557499,2.767896165324177e-17,-0.008549116610230402,
    0.002080433798334893,-0.0007462932187684086,0.0003111426892571707,-0.00014061426168435214,6.683422750356887e-05,
    -3.288318725011287e-05,1.659132303641969e-05,-8.556185060558646e-06,4.467652074309853e-06},{0.9228963827651927,
    4.983698359017013e-17,-0.008061720082627582,0.00182722241322329,-0.0006103372716986066,0.0002369291327561835,
    -9.969568501819488e-05,4.4119282769057236e-05,-2.0210763274703534e-05,9.494378264091807e-06,-4.557056775435693e-06,
    2.215408621187174e-06},{0.9219160810008412,3.7359230623242955e-17,-0.007631787156188199,0.0016187604199260892,
    -0.0005058845607858534,0.0001837245786916947,-7.232403231982323e-05,2.9942418745207602e-05,-1.2831877526435807e-05,
    5.639241256517804e-06,-2.531376138060255e-06,1.151243210478514e-06},{0.9205389072872612,3.253974650416369e-17,
    -0.014147343185644805,0.00547474465450856,-0.0031204814481435154,0.002066777870697137,-0.0014837193580136208,
    0.0011201885287207263,-0.0008754248336611101,0.0007015785656423446,-0.0005770476758390364,0.00047862113053943645},
    {0.9188504007825612,4.036309020483044e-18,-0.012910409932049787,0.004472953084215725,-0.0022816077328053903,
    0.0013522659143129908,-0.0008686644333190348,0.0005868325417805585,-0.0004103565886008887,0.0002942606753029083,
    -0.00021626464399465784,0.00016049475020850817},{0.9173023388603898,-2.91225943163877e-17,-0.011889520315038378,
    0.003729073191748255,-0.001721344889715227,0.0009231507325743925,-0.0005365751817797711,0.00032798373216816757,
    -0.00020751775439266428,0.0001346408780425926,-8.944323910213467e-05,6.005642903659105e-05},{0.9158712637511341,
    7.424311643662594e-19,-0.011031327958527093,0.003160715372990944,-0.00133236613552136,0.0006524773939654543,
    -0.00034629494503671065,0.00019327814990116016,-0.00011165973882957416,6.614927148285961e-05,-4.009376174271133e-05,
    2.4580129024204012e-05},{0.9145392810722888,2.5537990313506946e-17,-0.010298896380332923,0.0027161269406643456,
    -0.001053538709241518,0.00047470396165258616,-0.00023180379477049919,0.00011903285244076897,-6.32683346896825e-05,
    3.448394754060371e-05,-1.921852101930566e-05,1.0839767719413152e-05},{0.9132924100616626,1.2137880954599664e-18,
    -0.009665803382949058,0.002361424748790294,-0.0008482436185299806,0.000353923357038447,-0.00016003336385152147,
    7.609455781359284e-05,-3.7451226086742614e-05,1.89010641971808e-05,-9.749479766547746e-06,5.091703257964931e-06},
    {0.9121195069713934,-2.2194044591572806e-17,-0.009112625941860018,0.0020736445846768472,-0.000693605275640144,
    0.0002694663311510236,-0.00011344814547970008,5.022565151847505e-05,-2.301544513762365e-05,1.0814787542546639e-05,
    -5.191983689559552e-06,2.5245642735222448e-06},{0.9110115372342376,5.314974985435098e-17,-0.008624752203116023,
    0.001836759545191512,-0.0005748161534230555,0.00020892629794704327,-8.228993987143977e-05,3.4082351033826535e-05,
    -1.4610811850902842e-05,6.422752987422166e-06,-2.8837390669947352e-06,1.311750527013511e-06},{0.9094554212283847,
    -2.6545205261059892e-17,-0.01598309784735195,0.006210557111981625,-0.003544930092753935,0.002349821557911833,
    -0.0016878572439159485,0.0012748441034187894,-0.0009966187090893113,0.0007989234114078203,-0.0006572672035651957,
    0.0005452662211383142},{0.9075481768694672,3.304767486990904e-17,-0.014580120007517995,0.005072643459935332,
    -0.0025912813118770485,0.001537088700914427,-0.0009879555283817038,0.000667706808793756,-0.000467068540883637,
    0.00033502164993712985,-0.00024628034266167544,0.00018280731256448878},{0.9058002082847434,-4.27285764872669e-18,
    -0.013422512001477222,0.004227896927201152,-0.0019545105430138496,0.0010490919546929853,-0.000610134029979479,
    0.00037311021472629334,-0.00023615154291146322,0.00015326269495821805,-0.00010183864941608618,
    6.839352805112357e-05},{0.9041848765959288,-2.856197496282626e-17,-0.01244964166554005,0.0035826209866317692,
    -0.0015125083741643717,0.0007413401117345304,-0.0003936921287215812,0.00021983008641298738,-0.00012704411347214505,
    7.528515819885248e-05,-4.564241189233001e-05,2.798775535775495e-05},{0.9026818654816203,9.888122178702546e-18,
    -0.011619536986165479,0.0030779726342856197,-0.0011957356555345508,0.0005392521765252119,-0.0002634830241076193,
    0.0001353617965402057,-7.197338420196866e-05,3.924018699079668e-05,-2.1874760878772657e-05,1.2340622873989066e-05},
    {0.9012753053562895,-1.9584494636252668e-17,-0.010902179660944408,0.0026754339335713553,-0.0009625455139704657,
    0.0004019762552411301,-0.000181873312100479,8.651917727623562e-05,-4.2597449083626696e-05,2.1504752809048432e-05,
    -1.1095339138736694e-05,5.795854836551443e-06},{0.8999525494815145,-4.398011741206398e-18,-0.01027550729118815,
    0.0023489040912247996,-0.000786925919968864,0.00030600058343867824,-0.00012890993482888308,5.7097605729774376e-05,
    -2.6174165193073945e-05,1.2302802503078957e-05,-5.907883420824624e-06,2.8733050661827673e-06},{0.8987033467110297,
    5.2325158142868384e-17,-0.009722925352155852,0.00208017019725791,-0.0006520417990586693,0.00023721455532197324,
    -9.349103667268803e-05,3.873993921284862e-05,-1.6613729141253043e-05,7.30547481127213e-06,-3.2809321087037135e-06,
    1.4927620859361371e-06},{0.8969494041444397,3.105560758777057e-17,-0.01801181077968528,0.007031667102731905,
    -0.004020208314234296,0.0026673819854790034,-0.0019171952490247579,0.0014487646909712095,-0.0011330168071861692,
    0.0009085514377017987,-0.0007476588893204574,0.000620397464808436},{0.8948005433697127,8.870700350865207e-18,
    -0.016423604543011863,0.005741375997312001,-0.0029378228216786384,0.001744330885007008,-0.0011218999983457815,
    0.000758608303751179,-0.0005308634632477793,0.0003809038395028571,-0.00028008630221899134,0.00020794952342530844},
    {0.8928319581524851,-2.5293906401269636e-18,-0.015113586863051356,0.004783785640647971,-0.0022152851667737736,
    0.0011902351434171451,-0.0006926873470036812,0.0004238075413304276,-0.0002683467472488605,0.00017421486470798315,
    -0.00011579327660471738,7.778397498457177e-05},{0.8910134506603397,-1.1719383163859783e-18,-0.014012957754812538,
    0.004052506068928797,-0.0017138732679801924,0.0008408800591571476,-0.00044686014545500306,0.00024964664021932825,
    -0.00014433460263222668,8.556008595931988e-05,-5.1886523154025394e-05,3.1824418350019265e-05},{0.8893219964837263,
    4.9520798399082954e-17,-0.013074102996798934,0.0034807384241967152,-0.0013546053517163612,0.0006115228005064429,
    -0.0002990039272834597,0.00015369083014285469,-8.175309047498135e-05,4.4587364296390544e-05,-2.4862811500234425e-05,
    1.4029826382362521e-05},{0.8877396151558962,-5.3146201139899125e-17,-0.012262976873420742,0.0030247665703299694,
    -0.0010901893569772992,0.000455754786616428,-0.00020635175564658558,9.821612935552196e-05,-4.837682181108959e-05,
    2.443087722609692e-05,-1.2608787270602163e-05,6.588101528887299e-06},{0.8862519810721599,-1.7889893053829888e-17,
    -0.011554562387894804,0.0026549733498545617,-0.0008910931678133801,0.0003468712619036419,-0.00014623299571504548,
    6.480545512995167e-05,-2.9720255965630287e-05,1.3974519234124789e-05,-6.712660901375869e-06,3.2655491984026103e-06},
    {0.8848474847724382,-1.883665745329285e-18,-0.010930046495454747,0.0023506961431749747,-0.000738207028881624,
    0.00026884820680003974,-0.00010603592545210218,4.3962251204690625e-05,-1.8861522166762406e-05,8.296851331592331e-06,
    -3.727295468316095e-06,1.6962913132389799e-06},{0.8828761860863755,5.129110492322433e-17,-0.020239807680761855,
    0.007943630149156994,-0.004550189391675464,0.0030223031281499937,-0.0021739145962793864,0.001643677078892266,
    -0.0012860186105775819,0.0010316174250160968,-0.0008491960308230659,0.0007048388354540868},{0.8804621194957679,
    -2.953078903476618e-17,-0.018445962077324612,0.006483483295188244,-0.00332396717138242,0.0019757988033781526,
    -0.0012717413589416356,0.0008604197654708762,-0.0006023825071564546,0.00043238119805402833,-0.00031803980389699264,
    0.00023619223494687427},{0.8782516331201119,2.132043081113096e-17,-0.016966875747519077,0.005400194263608975,
    -0.0025056650880031363,0.0013477794221844843,-0.0007849843040317341,0.00048055788499400874,-0.0003044207163704641,
    0.00019770989226520005,-0.0001314520492736773,8.832725394909229e-05},{0.8762105646007144,-4.5230643532062475e-17,
    -0.01572462838486072,0.004573176297198611,-0.0019379581951057738,0.0009519225898377062,-0.0005062712058107582,
    0.0002830058608736604,-0.0001636985433416418,9.707648204942952e-05,-5.8889886826151486e-05,3.613012923137151e-05},
    {0.8743128748173598,-5.074309917209386e-17,-0.01466530942257099,0.003926737545903845,-0.0015312966938600852,
    0.0006921013188605239,-0.0003386755697248833,0.00017418770606034365,-9.270046760567781e-05,5.0577916919943625e-05,
    -2.8212727125613633e-05,1.592473351323532e-05},{0.8725382348574174,-1.2758981267804555e-17,-0.013750381351098285,
    0.0034113544712027232,-0.0012320737535054201,0.0005156850225879365,-0.00023367753452849347,0.0001112905691838951,
    -5.484340568132464e-05,2.77076876750054e-05,-1.4304822192314295e-05,7.476468290291802e-06},{0.8708704523764244,
    -5.296252474960467e-17,-0.012951533640157706,0.0029934834139823444,-0.0010068215310963448,0.0003923952941442163,
    -0.00016556235623936362,7.341731351784078e-05,-3.368636440246246e-05,1.5845837634266953e-05,-7.614178852458206e-06,
    3.705216292072619e-06},{0.8692964084134084,-5.507488529064538e-18,-0.012247481459965192,0.002649727603861273,
    -0.0008338881450618189,0.0003040675142756916,-0.00012002773654257339,4.979467994487971e-05,-2.1374570830505486e-05,
    9.406177121045769e-06,-4.227131088640831e-06,1.924345733781648e-06},{0.8670880133075456,-1.7391579997957503e-17,
    -0.022668887592187208,0.008950888993660457,-0.0051382905490460545,0.0034172011109601407,-0.0024600711683479227,
    0.0018612357348463339,-0.0014569812109845486,0.0011692516584299788,-0.000962838535691996,0.0007994080333704471},
    {0.8643849899460568,-4.446089407868993e-17,-0.020648022949422137,0.007302337040145618,-0.003752090056164095,
    0.002233134856682383,-0.0014386404288169031,0.0009739798866447762,-0.0006822427264005842,0.0004899144253458074,
    -0.00036049094814785167,0.00026780261327528205},{0.861911262504732,-7.11416063682635e-18,-0.01898246587999155,
    0.00607973761959693,-0.002827358001550104,0.001522802786304937,-0.0008877177575453203,0.0005438156677869927,
    -0.0003446766665109555,0.00022395297566407948,-0.0001489561114559016,0.00010012093020374981},{0.8596282745959364,
    4.0227968512103073e-17,-0.017584159471222913,0.005146695128654585,-0.002186024641047054,0.0010752014761620376,
    -0.000572358077851205,0.0003201677493634336,-0.00018529470611555236,0.0001099326229409513,-6.67142621221251e-05,
    4.0943910870801105e-05},{0.8575066483664996,1.5629662500154537e-17,-0.016392200198821767,0.004417621598152135,
    -0.00172676295144263,0.0007815025788102282,-0.0003827786983354756,0.00019700809628588956,-0.00010490317141743059,
    5.726184785231448e-05,-3.1953439031690326e-05,1.804218078017767e-05},{0.8555234559149735,-3.892612951910781e-17,
    -0.015363065108262138,0.0038365350612690596,-0.001388933007114724,0.0005821375927858304,-0.00026403870808679815,
    0.00012583935480983902,-6.2047812445113e-05,3.136196189930907e-05,-1.6197801913352316e-05,8.468700135786778e-06},
    {0.8536604403948159,8.654053126150469e-18,-0.014464790444013347,0.0033655277432491715,-0.001134685990212347,
    0.0004428454221753208,-0.0001870274980499014,8.299546388897296e-05,-3.810285771904749e-05,1.793174111413341e-05,
    -8.619924093586784e-06,4.196070332443534e-06},{0.8519028144851019,3.80612766592725e-18,-0.013673351245634202,
    0.00297816567204256,-0.0009395417916394002,0.00034307704550515456,-0.0001355577686760372,5.627843579567323e-05,
    -2.4171712493729024e-05,1.064216116937703e-05,-4.784513817108126e-06,2.1788437771124344e-06},{0.8494379638738873,
    2.0868889212503547e-17,-0.025294703254151382,0.01005617181664931,-0.0057871565660151825,0.0038542681141381543,
    -0.0027774623001571947,0.002102926890960149,-0.0016471474067572718,0.0013225044095696555,-0.0010894887916769378,
    0.0009048809983662226},{0.8464228141417103,-3.5884995635032576e-17,-0.02302486665351642,0.00819984877780283,
    -0.0042239720168003895,0.0025176862995239164,-0.0016235954171586883,0.0011000317459151465,-0.0007710024411495477,
    0.0005539270098995836,-0.00040776562004387896,0.00030303187072925654},{0.8436651474820294,3.240093098763352e-17,
    -0.02115503290160411,0.006823768763977485,-0.003181601902890321,0.0017161707669568552,-0.0010014738271589298,
    0.000613978079039472,-0.00038938574349559366,0.0002531307686580891,-0.00016843559320808021,0.00011325593571771405},
    {0.8411215662848984,-3.355772835867375e-18,-0.019585940309610854,0.005774022364971657,-0.0024589559364989948,
    0.0012112932358786144,-0.0006454809294257474,0.00036135653337865647,-0.0002092634375931043,0.00012421699062877093,
    -7.541606064142782e-05,4.630182220549071e-05},{0.838759017510274,-1.1656152089710962e-17,-0.018248961974964208,
    0.0049540668873927045,-0.0019416477778131786,0.0008801222741386134,-0.00043154317181431,0.00022228447902769815,
    -0.00011843780788212515,6.468372510640312e-05,-3.611113345688326e-05,2.039759614896528e-05},{0.8365517147767298,
    -3.974639040545511e-17,-0.01709507305582581,0.004300776324243922,-0.0015612442507469625,0.0006553910144715833,
    -0.00029758673693174405,0.0001419438275938539,-7.003377737836952e-05,3.541733110135073e-05,-1.830060623666976e-05,
    9.571836148636383e-06},{0.8344791324056474,-1.482153717523244e-17,-0.016088281075215555,0.0037714188214683477,
    -0.0012750452448741518,0.000498421934580358,-0.00021073098888961018,9.359152300710955e-05,-4.299568471855792e-05,
    2.02453231607962e-05,-9.736553629026603e-06,4.741504764134264e-06},{0.8325246509592901,-1.0744866087527634e-17,
    -0.015201541372956498,0.003336205266607704,-0.001055440735269525,0.00038602350876006434,-0.000152697140369311,
    6.344722119269956e-05,-2.7268864995973537e-05,1.2012340180632791e-05,-5.403035395230168e-06,2.4615013305550908e-06},
    {0.8297851374428641,-3.178075578328017e-17,-0.02810493011268907,0.011259751824186327,-0.006498258620433547,
    0.004335019274729549,-0.003127452644969086,0.0023699418967678453,-0.001857549969060052,0.0014922714853212841,
    -0.0012299321066037243,0.001021943740512838},{0.8264362340372486,2.5750351838139822e-17,-0.025564158930807965,
    0.009175859198125717,-0.0047405008626896705,0.0028303367594420593,-0.0018273379942025164,0.0012391550686174986,
    -0.000869115362832022,0.0006247732721667266,-0.0004601426225166329,0.00034209870515161564},{0.8233754677610673,
    -9.190080046575945e-19,-0.023472317891690415,0.007631865873693178,-0.0035689378148955485,0.001928419695541097,
    -0.0011266666215099398,0.0006913465271011776,-0.0004387633750196105,0.00028539646154031073,-0.0001899999525339409,
    0.0001278102359602361},{0.8205541442134345,2.318475164189625e-17,-0.021717839061016167,0.006454576472933758,
    -0.0027570794793179703,0.0013605335521260625,-0.0007258845837864202,0.0004067375888025206,-0.00023571372002378476,
    0.00014000081168970662,-8.504193607640918e-05,5.223431589975284e-05},{0.817935193623553,-2.1764100424491482e-17,
    -0.020223621290780543,0.005535396337468526,-0.00217614334574878,0.0009881754435481782,-0.0004851189776453146,
    0.00025011172455758284,-0.00013336249007782233,7.287873039185782e-05,-4.0707102372808474e-05,
    2.3003813639856644e-05},{0.81548970859369,1.970739652680236e-17,-0.01893460849786686,0.004803346663221503,
    -0.0017491123100865753,0.0007355853756241952,-0.0003344162426031615,0.00015966048114139967,-7.883369381125456e-05,
    3.989208324129751e-05,-2.0623530157013314e-05,1.079164402175618e-05},{0.8131946885424878,-1.2478818041850201e-17,
    -0.017810395662295815,0.004210397215190685,-0.0014279469031449942,0.0005592170843914321,-0.00023673398550684463,
    0.00010524021238121856,-4.8383598041494054e-05,2.2796514201954013e-05,-1.0969297362557854e-05,
    5.344258181706768e-06},{0.8110315172651239,-3.3788069225192324e-17,-0.01682063340848903,0.0037230766714516986,
    -0.0011815948017296254,0.00043296794167323616,-0.00017148617603132688,7.132296010766142e-05,-3.067724369882439e-05,
    1.3522313591915673e-05,-6.085468624116537e-06,2.7736821190089576e-06},{0.8080012473417604,2.5039543455549043e-17,
    -0.03107730788542375,0.01255857034379203,-0.00727140275347853,0.004859976543899325,-0.003510753754100824,
    0.0026630152707435924,-0.0020888882097263384,0.0016791975654117204,-0.0013847589061448263,0.0011511290803900846},
    {0.8042996981905396,4.3963302281330186e-17,-0.028244391748069312,0.010227419700389803,-0.005301309182634214,
    0.003171296940026755,-0.0020502024313605476,0.0013916800549624371,-0.0009768717496560612,0.0007026970859812789,
    -0.000517823958873014,0.0003851676627140652},{0.8009193150919549,2.7654901606325915e-17,-0.025913531453184365,
    0.008501232398144454,-0.003988934425628912,0.0021596124134762133,-0.0012634564456422109,0.000776077832356601,
    -0.0004929390782831709,0.00032085059891633083,-0.00021372548162442188,0.00014384059339483967},{0.7978056559635823,
    -5.477132009677382e-17,-0.023959744927409078,0.007185725905204579,-0.0030799524150699276,0.0015229144426273163,
    -0.0008136451953070667,0.00045638834544214137,-0.00026470671954864394,0.00015732850478380277,-9.562310294247804e-05,
    5.876281628748267e-05},{0.7949172978811465,-1.409612566745992e-17,-0.022296704618898155,0.006159142484346982,
    -0.00242982012208995,0.0011056211292731198,-0.0005435402239290974,0.00028052899634454294,-0.0001497074126861658,
    8.186761969995722e-05,-4.575498554988214e-05,2.5869544028669352e-05},{0.7922219550054876,3.236502363055134e-17,
    -0.020862794993835147,0.005341935309214556,-0.001952132156871228,0.0008226658244091559,-0.00037453995778590957,
    0.00017900928852457722,-8.846297889227756e-05,4.4796371499681335e-05,-2.317286891555774e-05,1.2131893141226614e-05},
    {0.7896939506716342,-8.527903238504859e-18,-0.019612816912042676,0.004680298714231761,-0.0015930146881660552,
    0.0006251718412127245,-0.0002650383566073222,0.00011795159321611364,-5.4274661343695975e-05,2.559046915901324e-05,
    -1.232119692700139e-05,6.006050048502531e-06},{0.7873125118352495,2.453572427241354e-17,-0.018512833935399695,
    0.0041367512417946695,-0.0013176571893042327,0.00048385203044911377,-0.0001919213621318443,7.991049195150167e-05,
    -3.440112674531738e-05,1.5174777770902044e-05,-6.833340718852144e-06,3.116206592644575e-06},{0.7839786591643018,
    1.8858674152435318e-17,-0.03417770108933563,0.013945245111496366,-0.00810415068776497,0.005428287768363633,
    -0.003927154492628185,0.002982224409239139,-0.0023413739674223786,0.0018835547022177418,-0.0015542663185410162,
    0.001292736190785526},{0.7799097283436787,-1.0456834077452789e-17,-0.031033167284321032,0.011347986781369468,
    -0.00590435018782287,0.0035398540222150283,-0.0022919664963382963,0.0015575814083800073,-0.0010943253854694664,
    0.0007877802719177941,-0.0005808974410988093,0.00043232176229826157},{0.7761971625324429,-5.0048068553790316e-17,
    -0.028447821001103994,0.009426029773927376,-0.0044398679637526585,0.002409166510698176,-0.0014116508937283693,
    0.0008681245170253329,-0.0005519191818689502,0.00035951721557006615,-0.00023963966258314285,0.000161372196167179},
    {0.7727803431689014,-1.8043310559614714e-18,-0.0262821884868691,0.007962227493848052,-0.0034261139891372952,
    0.001697962513738109,-0.0009086060926439496,0.0005102628643294423,-0.0002962355677630205,0.00017620585037737485,
    -0.00010716825427550412,6.58954292034488e-05},{0.7696131764119266,3.765518647212252e-17,-0.024439988371856847,
    0.006820568459063237,-0.002701431297428532,0.0012320736309841937,-0.000606682021027419,0.00031349781435053897,
    -0.00016746331857635764,9.165050850384119e-05,-5.1257346675735584e-05,2.8997465365571067e-05},{0.7666597564205285,
    -4.0822882370264276e-17,-0.022852537596950787,0.005912239091620682,-0.0021692317423607993,0.000916316324602695,
    -0.00041785886376528706,0.00019995961402710172,-9.891320729783682e-05,5.0128785210164574e-05,
    -2.5949168163847178e-05,1.3593450393624899e-05},{0.7638915428523958,1.7636790492438948e-17,-0.0214694777715929,
    0.00517719436488031,-0.001769320224889489,0.000696025425630255,-0.00029556546105164784,0.00013170173191707913,
    -6.066200898902378e-05,2.8625594100900048e-05,-1.3792167770938424e-05,6.727129187031233e-06},{0.7612854574725599,
    4.6999564788939566e-17,-0.02025301656721945,0.004573625169042329,-0.0014628185038984096,0.0005384589795377261,
    -0.0002139399250809844,8.919121719705481e-05,-3.843515191967447e-05,1.6968348198361607e-05,-7.646409397146483e-06,
    3.4891158467238014e-06},{0.7576397852956394,-2.989571399906813e-17,-0.037358399781720966,0.015407014378659325,
    -0.008991169390565436,0.006037286883866152,-0.004375204114899398,0.0033267510100510114,-0.0026145462664755653,
    0.0021050948813909733,-0.0017383378978644735,0.001446731669849544},{0.7531945110288748,9.682574602988e-18,
    -0.03388573524421998,0.012526574245177537,-0.006545425613113837,0.003934084561263819,-0.002551665729799948,
    0.0017363529440525861,-0.0012212062609887177,0.0008798803545117879,-0.000649291263041958,0.00048352903079904497},
    {0.7491426265001155,1.8052824277554328e-17,-0.031032999930975434,0.010396682974002593,-0.004918368877600861,
    0.0026756589669740074,-0.0015705901538700874,0.000967164587352924,-0.000615542509250062,0.0004013152158018139,
    -0.00026770226511821935,0.00018038604738687054},{0.7454169522154568,1.5825667693998514e-17,-0.028645229310803075,
    0.00877564818860027,-0.003792814391735514,0.0018846014327916147,-0.0010103038404677142,0.0005681504213019478,
    -0.0003302014571739797,0.00019658587684416787,-0.00011965504782935826,7.362175123172408e-05},{0.7419664415104513,
    -3.2312028791380155e-17,-0.026615519365542042,0.007512179822273757,-0.0029887002773329847,0.001366702904402937,
    -0.0006742110794859664,0.0003488765457277424,-0.0001865679327303374,0.00010219949377607118,-5.720157700188035e-05,
    3.238192333384344e-05},{0.7387513564342548,-3.3711146309908735e-17,-0.024867656119815458,0.006507545505373409,
    -0.00239850246213657,0.0010158857670947126,-0.0004641281658818157,0.00022241391479392797,-0.00011014407407103633,
    5.58722979081325e-05,-2.894513983560209e-05,1.5173195958320717e-05},{0.7357401298966457,2.7431794252510193e-17,
    -0.023345791518796614,0.005695030795309545,-0.001955245707083619,0.0007712593535066576,-0.00032813209653175706,
    0.00014642195419261548,-6.751890560082114e-05,3.1891224725518295e-05,-1.5377886811415726e-05,7.50573460765991e-06},
    {0.7329072507837979,5.78285543947347e-18,-0.022008035929008924,0.005028206493558675,-0.0016156940270622639,
    0.0005963703713634831,-0.00023740244173588564,9.911581651526746e-05,-4.276118107269299e-05,1.889617966475716e-05,
    -8.522044043868124e-06,3.8913908094936725e-06},{0.7289475526645509,-2.6176736278708553e-17,-0.04055696056209679,
    0.016924706310569117,-0.009923545872770775,0.006682012998120811,-0.00485185750694065,0.0036946095380991986,
    -0.0029070576747551842,0.0023428783286199312,-0.0019363023598819333,0.0016126325146178927},{0.7241244953230218,
    1.6800186620644492e-18,-0.03674406276022845,0.01374694052146182,-0.007217694579153641,0.004350543782369547,
    -0.0028273874479122474,0.0019268660689169884,-0.0013568207096037025,0.0009785586188454207,-0.000722721027416898,
    0.0005386031880653108},{0.7197331689802271,4.6974944935753885e-17,-0.03361479986877627,0.011399226436314068,
    -0.005419058645221297,0.0029566167996947544,-0.0017390208868111906,0.0010725229064327102,-0.0006834300665894727,
    0.00044602552163435156,-0.00029778345063785784,0.00020080424453314166},{0.7156995203603602,-3.711108432498875e-18,
    -0.03099785620198021,0.009613829759391507,-0.0041757392289741525,0.0020810059248164464,-0.0011178875997987154,
    0.0006296294752124592,-0.00036638669020539746,0.00021835276581855256,-0.00013302030544952204,8.190684683528892e-05},
    {0.7119673248665229,-3.9543920544718594e-17,-0.028775137016149425,0.008223280324448681,-0.0032881071476115247,
    0.0015081297696777547,-0.0007455322512315765,0.0003863922534941474,-0.00020689076772124475,0.00011345029263506998,
    -6.355520766248706e-05,3.600627806550952e-05},{0.7084928462358442,-1.0940127061836342e-18,-0.02686250914009392,
    0.007118359672388485,-0.0026370306469929534,0.0011203109039109832,-0.0005129207512506996,0.0002461898763238305,
    -0.00012207444914002092,6.198970238793635e-05,-3.214329054446785e-05,1.6862779140572344e-05},{0.7052413652574371,
    2.3535893932392384e-17,-0.025198361689191918,0.006225313796581099,-0.0021483488399845385,0.0008500395636241387,
    -0.0003624248554652061,0.0001619871432900087,-7.479328033686905e-05,3.536502568710573e-05,-1.706853343974927e-05,
    8.337479964115129e-06},{0.7021848416336491,-5.508000296068352e-17,-0.023736510781098764,0.005492844367895479,
    -0.0017742140023998764,0.0006569219125036356,-0.0002620744282252072,0.00010959637211603826,-4.734485125237073e-05,
    2.0944428931835835e-05,-9.454528892528904e-06,4.32063322870287e-06},{0.6979164140162071,-5.3950194052958033e-17,
    -0.04369595485568616,0.018471869886416158,-0.010888130479160594,0.0073547229081981375,-0.005352103388135651,
    0.004082356055852369,-0.003216441268235139,0.0025950836994979997,-0.0021467756717007723,0.0017893740966554057},
    {0.6927234231792988,2.5548193090736393e-17,-0.039536772570180616,0.014986926456877658,-0.007911212193662283,
    0.004783955428675934,-0.003116057635308647,0.0021272197695177968,-0.0014999436216316061,0.0010830013537254596,
    -0.0008006310782627127,0.0005971596839193522},{0.6880011260695248,-3.8839358083048936e-17,-0.03612695496035291,
    0.012414789477477765,-0.005934215210615079,0.003248311160842275,-0.0019149673659712978,0.001183088760660985,
    -0.0007549312807993858,0.0004932554426192764,-0.00032963973409618245,0.0002224736549862155},{0.6836683863058234,
    -4.2259435378461823e-17,-0.033278185912951334,0.010460482613971436,-0.004568760590964801,0.002284460233405766,
    -0.0012300377213007383,0.000694019914563392,-0.00040442615466779836,0.00024130455033142265,-0.0001471493427715557,
    9.068462176366066e-05},{0.6796636574067938,-5.20013933000676e-19,-0.03086076294995948,0.008939647235358582,
    -0.003594699440315935,0.0016543257496578348,-0.0008197351879910538,0.00042561178847502524,-0.00022821718941427494,
    0.000125293329838873,-7.026084647941016e-05,3.984000690034535e-05},{0.6759391035222849,1.7043144900219606e-17,
    -0.028782356629871712,0.0077321421889400615,-0.0028807510820100034,0.0012280437039271473,-0.0005635911389198318,
    0.0002710022481826053,-0.00013457307936849363,6.841878449853063e-05,-3.551337951474333e-05,1.8647269531926603e-05},
    {0.6724567807876694,-4.611571607230595e-17,-0.02697540390384724,0.006756894933029548,-0.0023452476863219046,
    0.0009311626091924107,-0.00039797510656376146,0.0001782039558432209,-8.240209461070522e-05,3.9010262754287736e-05,
    -1.884744995451106e-05,9.214690847299174e-06},{0.6691860670532095,-7.632788220067929e-18,-0.025389294188349187,
    0.005957554254196873,-0.0019355318931706586,0.000719162842862847,-0.0002876085733464564,0.0001204985078935778,
    -5.2132050466069706e-05,2.3090654561177657e-05,-1.043432689198417e-05,4.7727245172527825e-06},{0.6646230880768793,
    2.0041862615271075e-17,-0.04668402294281885,0.020014252024078163,-0.011867003742712297,0.008044452922692328,
    -0.00586861126331361,0.004484801719771633,-0.003538875399439615,0.002858812703178767,-0.0023674959287867323,
    0.001975170324147039},{0.6590789306123845,3.9996051785604644e-19,-0.04218030581342576,0.016218097268966447,
    -0.008612569800686847,0.005226940365946071,-0.003413242805728374,0.0023345956146162737,-0.0016487113445519256,
    0.0011919399364511596,-0.0008821339603384794,0.0006585697064186929},{0.654044158859394,4.5136218551971786e-17,
    -0.03849243921815027,0.013419351109816442,-0.006453522839768394,0.0035455819502465628,-0.0020956141314600685,
    0.001297237557052809,-0.0008290713893160615,0.0005424030163895769,-0.0003628894913198665,0.0002451490392518122},
    {0.649430483032027,-3.043112882212755e-17,-0.035414751303042565,0.011295020011871059,-0.004963758929047627,
    0.0024912407919392087,-0.0013448931251320427,0.0007603384660878957,-0.0004437798228745647,0.0002651360286909099,
    -0.00016186522967420765,9.98510499149302e-05},{0.6451709988389142,-3.044098436350844e-17,-0.03280572309280955,
    0.009643422625533823,-0.0039019628614372333,0.0018025323018784525,-0.0008955477259071549,0.00046591524725951426,
    -0.0002502332771598738,0.00013756505043938848,-7.723114225368329e-05,4.383577558071683e-05},{0.6412137553167069,
    8.160435412436715e-19,-0.030564703743706092,0.008333242134343392,-0.003124351755422375,0.0013369944023659886,
    -0.0006152446188163356,0.00029644644335619595,-0.00014744988034082546,7.506767859646341e-05,-3.900991953403694e-05,
    2.05038080401386e-05},{0.6375175807111898,9.368893619742095e-18,-0.028618102350385432,0.007275935478827794,
    -0.0025415496418480722,0.0010130146761263296,-0.000434138017410273,0.0001948003578570515,-9.022614152494839e-05,
    4.2773210437424605e-05,-2.06898395803858e-05,1.0125748930846253e-05},{0.6340492752167851,-2.8727788040299004e-17,
    -0.026910835984109524,0.006410005027376425,-0.0020959709393180027,0.0007818259280589092,-0.00031353015080996924,
    0.00013163452542444266,-5.7045709158621976e-05,2.530231496230768e-05,-1.144737219522604e-05,5.241491579438434e-06},
    {0.629215927933647,-3.2709694716466096e-17,-0.04941859870578901,0.02150984431384632,-0.012837194125099491,
    0.008736709693212757,-0.0063914506759484594,0.0048947687745102,-0.0038689739983257115,0.0031299100598521897,
    -0.002595167220098477,0.0021673786957106095},{0.6233515766985557,-4.7080224649777487e-17,-0.04458162397570251,
    0.017405870849911867,-0.009304731442944848,0.005669837454545459,-0.0037129992331180087,0.002545138373280333,
    -0.0018005288454323789,0.0013035789545929844,-0.0009659544005311905,0.0007219166650900643},{0.618033946977458,
    -1.5609187259466074e-17,-0.040626129959340465,0.01438391543867316,-0.00696397856659843,0.0038417302400907583,
    -0.0022772207254654147,0.0014127685434267355,-0.0009045071030015908,0.0005926257006016741,-0.000396990775254675,
    0.0002684773881267015},{0.6131677013083796,-1.7097787215801452e-17,-0.03732911728848859,0.012092759921944462,
    -0.00535057206806082,0.0026965499113967505,-0.0014600010462291545,0.000827264467403038,-0.00048371022762727764,
    0.00028942412192720063,-0.00017691926768985552,0.00010925800630525808},{0.6086806774078566,4.058577753114289e-17,
    -0.03453731122822665,0.01031332899664979,-0.0042017967738087175,0.00194921921513909,-0.0009713052614787663,
    0.0005064763365913832,-0.0002725137794447042,0.00015004065420251794,-8.434441352284072e-05,4.792682164944246e-05},
    {0.6045169006877574,-3.5955634190781873e-17,-0.03214180961086676,0.008903118528160225,-0.0033612660334777413,
    0.0014445051493782036,-0.0006667180806191441,0.00032198686287804356,-0.00016044921210947967,8.18110778828755e-05,
    -4.2570053440727084e-05,2.240042431714224e-05},{0.6006320542128024,-4.525102535737768e-18,-0.03006306302855952,
    0.007766128674792626,-0.0027318541948879844,0.0010935548793577327,-0.00047008029086286667,0.00021141847009335365,
    -9.810615153778872e-05,4.658108925245671e-05,-2.256168368153925e-05,1.10545278209738e-05},{0.5969904348398466,
    -1.7760365096253316e-17,-0.028241580697687244,0.006835738846735677,-0.0022510336020853416,0.000843316978326047,
    -0.0003392290400273017,0.00014275890643076862,-6.198347267115332e-05,2.753560357175046e-05,-1.2474494433533108e-05,
    5.718424793371859e-06},{0.5919215884772724,4.675880406012793e-17,-0.05179054303762593,0.022909734221699146,
    -0.013770798062786456,0.009413391468988518,-0.006907954143092464,0.005302941316087219,-0.004199641870249817,
    0.0034028293090280267,-0.0028253366879111125,0.002362389627567836},{0.5857809448925028,3.7753143484764655e-17,
    -0.04664263559605023,0.018510318780916402,-0.009967176652961303,0.006100683485232144,-0.004007811957294026,
    0.002753890197636008,-0.0019520101060086518,0.0014155455424760426,-0.0010503871844930951,0.0007859618840904984},
    {0.5802217487997264,2.7032661493846727e-17,-0.04243904104540326,0.015275258232782524,-0.007450037622374211,
    0.0041285242524094715,-0.0024550949773977752,0.001526874422226256,-0.0009795003309017018,0.0006428195906152119,
    -0.0004312254234179164,0.0002919860699221205},{0.5751419321340105,-2.7294687721924842e-17,-0.038939934182048136,
    0.01282561804245701,-0.005717134466304068,0.0028945328264303274,-0.001572306351688862,0.0008931254719489447,
    -0.0005232702684581305,0.00031361876812521436,-0.00019198450992779739,0.00011870879546703616},{0.5704643362298427,
    -4.00848073840721e-17,-0.035980675465960704,0.010925311840068582,-0.004484643736708659,0.00209010565797782,
    -0.0010449476912178187,0.0005462555306954903,-0.000294516238475756,0.0001624298906873736,-9.144183348247245e-05,
    5.202514068571291e-05},{0.5661291810671396,-5.355143015984391e-17,-0.0334444190693363,0.009420936322757655,
    -0.003583791421091267,0.001547371706755164,-0.0007165805433212505,0.0003469537358091192,-0.00017324697766269028,
    8.848821010906777e-05,-4.611226576397697e-05,2.4295255242854037e-05},{0.5620891883747547,-3.9137684203923924e-17,
    -0.031245901884668196,0.00820925319951302,-0.0029098610231146943,0.0011703360560731903,-0.0005047822997444469,
    0.00022761323763973603,-0.00010584134405890762,5.034105946538927e-05,-2.441912626769222e-05,1.1980038775963569e-05},
    {0.5583063080405817,9.751917920671685e-18,-0.029321422228384814,0.007218685994432754,-0.0023954996388529607,
    0.0009017340796719899,-0.0003639624769552635,0.00015356789446655474,-6.681698313064289e-05,2.9734936988817163e-05,
    -1.3491114171480364e-05,6.192510374502668e-06},{0.5530475689887909,-3.0853639078793607e-18,-0.053690686769619286,
    0.024159959256544777,-0.014635657153626788,0.010053053066274907,-0.007402808073019495,0.00569787508535334,
    -0.004522045054414232,0.0036705841935331268,-0.003052337001468079,0.0025555663523230206},{0.5466873954586767,
    4.4258932895577664e-17,-0.04826630543412949,0.01948778967012414,-0.010576458792734191,0.0065054249950487085,
    -0.004288672567383886,0.002954812042413236,-0.0020989753545975617,0.0015248767665291404,-0.0011332811751668531,
    0.0008491284786023258},{0.5409394145595975,3.6606011104063477e-17,-0.043844050823321185,0.016057359302452823,
    -0.0078940771780135,0.004396367604280072,-0.0026236548079801663,0.001636161621871869,-0.0010519219309525032,
    0.0006916169155633554,-0.0004646945724490809,0.0003150781890448362},{0.535695385368548,-3.0715651266584485e-17,
    -0.040168328034998466,0.01346338091341197,-0.006049865735410787,0.0030784117788755657,-0.0016781995384526857,
    0.0009559136838269179,-0.0005613077829219726,0.00033704317595615213,-0.00020665463241597998,0.00012795678075849158},
    {0.5308735972952543,2.3348147486007725e-17,-0.037063907525941166,0.011453678744387635,-0.004739817879966276,
    0.0022202678107594437,-0.001114056529712183,0.0005840127448279111,-0.00031558492033956437,0.00017437790990384864,
    -9.832728255983951e-05,5.60210994702728e-05},{0.5264108252744205,-2.1583713108379238e-17,-0.03440658176763131,
    0.009864591780098736,-0.0037833694566460113,0.001641930597762249,-0.0007631619626409296,0.00037055273432994067,
    -0.0001854536874960301,9.490367129206993e-05,-4.9536494625224284e-05,2.6136458996122074e-05},{0.5222571263090946,
    3.5156173756261675e-17,-0.03210582004187345,0.008586101226577192,-0.0030686104638033736,0.0012405759687212096,
    -0.0005370606012715063,0.00024285970665955604,-0.00011319173461587251,5.3940895074724654e-05,-2.620862689891358e-05,
    1.2876432754543345e-05},{0.5183723506164108,-2.1252665110219414e-18,-0.030094057803490403,0.0075420090171501785,
    -0.002523634224131282,0.0009549262840740879,-0.0003868727989351421,0.00016370502308928186,-7.13935964080815e-05,
    3.18334651831098e-05,-1.4467376639965768e-05,6.6502533272658365e-06},{0.5129793254225206,-3.957732340461277e-17,
    -0.05501794649150841,0.025204460484561455,-0.015396715605436314,0.010631619692113261,-0.007858456744176016,
    0.006066234847155185,-0.004825751874366075,0.003924831195828054,-0.003269332199994381,0.0027412670611626083},
    {0.5064682069369574,1.5794306449366263e-17,-0.04936409041862745,0.020293413441509967,-0.011107260517199204,
    0.006868426848984388,-0.0045453436515909456,0.0031409272593042985,-0.0022365307144087557,0.0016280639286522635,
    -0.0012120635852344755,0.0009095139936449618},{0.5005946355046442,3.777388166834394e-17,-0.044762757801810014,
    0.0166935539833143,-0.008277233839805873,0.004634671491855549,-0.0027766069296977836,0.0017367401796046663,
    -0.0011192981448678607,0.0007374103128769751,-0.0004963313536836849,0.0003370390879350794},{0.49524501399631143,
    -2.457190635254563e-17,-0.040944254995188854,0.013975575043206175,-0.006334346813965941,0.0032407647769148846,
    -0.0017736409478717155,0.0010133440447454537,-0.0005964935354097924,0.0003589075405739241,-0.0002204507117724056,
    0.00013670870923036238},{0.49033371938699705,-1.0512358177676777e-17,-0.037723959474190494,0.011872738860735305,
    -0.004956059055216352,0.0023343519023900287,-0.0011759434277071224,0.0006183459732091926,-0.0003349682267744212,
    0.0001854732668125474,-0.00010477107546911963,5.9785171630703794e-05},{0.48579459242717266,-5.47190916427076e-19,
    -0.03497118344729856,0.010212162504773931,-0.00395104580274909,0.0017242248093244622,-0.0008046177107815534,
    0.00039189134680746177,-0.0001966256096985903,0.00010083224413334693,-5.2726246359710846e-05,
    2.7863147381268147e-05},{0.4815754404542335,-1.3348793694741248e-17,-0.0325907929208067,0.008877770288696138,
    -0.003200869885928154,0.0013012882012378747,-0.0005656158270552899,0.0002565714454110144,-0.00011988546480778992,
    5.725196889246174e-05,-2.78681973413594e-05,1.3713516602846183e-05},{0.47763435616178096,-2.3169188579367485e-17,
    -0.030511871276689837,0.007789261099912868,-0.00262951569468708,0.001000598437457872,-0.00040702363194225916,
    0.0001727742502605776,-7.554131608236666e-05,3.375497006053053e-05,-1.536889574028332e-05,7.075971784149758e-06},
    {0.4721710375907644,-3.8405578750735125e-18,-0.05568828638715019,0.02598905839139513,-0.01601810268307388,
    0.011123616310938222,-0.00825588481624215,0.006393318008674339,-0.005099095710939266,0.004156127202962193,
    -0.003468505004266815,0.002912982098950208},{0.4655872814315613,-1.1266390905029033e-17,-0.049863996395787986,
    0.020884397958829955,-0.011533966063842037,0.007173314243500117,-0.004766844283412445,0.003304615746530071,
    -0.002359252754472465,0.0017211713351338487,-0.0012838182077540166,0.0009649424379442251},{0.4596596907226196,
    1.845511728348683e-17,-0.045132780910071724,0.017149310577751764,-0.008580620700575987,0.004832451357335978,
    -0.0029072613377297348,0.0018243978277085234,-0.0011789103762609267,0.0007784115013476478,-0.0005249361973764612,
    0.00035705782869179024},{0.4542703895771342,1.2116942178882027e-17,-0.04121315994772987,0.014333838330297416,
    -0.006556281786640865,0.003373960568625566,-0.0018543719523529576,0.0010629618493509334,-0.0006273779846048251,
    0.00037833976722765814,-0.00023283823459547607,0.00014463424330992254},{0.4493306764762817,2.499213399505139e-17,
    -0.037912751434635995,0.01215885065702614,-0.005122306399956481,0.0024268990006617273,-0.001227796370726513,
    0.0006477603131012906,-0.00035185241990811885,0.0001952648262719717,-0.0001105186262542533,6.317243621791563e-05},
    {0.4447721174331533,2.4138697434296585e-17,-0.03509557560622036,0.010443692938216878,-0.004078101824217395,
    0.0017902513392736655,-0.0008390324590365811,0.00041002457145820166,-0.00020628556293314634,0.0001060286039598711,
    -5.55532267708317e-05,2.940762509213789e-05},{0.44054080108143967,9.094077925350683e-18,-0.032662781319539105,
    0.009067233263744619,-0.0032996561037226006,0.0013494742174591002,-0.0005891081832767758,0.00026813163314116657,
    -0.00012563204142360224,6.013503483330366e-05,-2.9329982248161764e-05,1.4457920547933495e-05},{0.43659349674505343,
    4.1228936435265186e-18,-0.030540774786009472,0.007945776783849988,-0.0027074726203992444,0.0010364625217118436,
    -0.00042345585686427977,0.00018036162320804084,-7.907746360470538e-05,3.5417423438544194e-05,-1.615824557787318e-05,
    7.452430945095468e-06},{0.4311297882161326,1.3735604310256613e-17,-0.055643443362112334,0.02646614673543931,
    -0.016465858448806898,0.011503904726367786,-0.008575797510741135,0.006663893175816888,-0.0053297906336229025,
    0.004354392829997052,-0.003641414477913672,0.003063612717890297},{0.42455830143116685,2.3062523304799135e-17,
    -0.04971824529376297,0.021223843247670075,-0.011832674668006003,0.0074041333706259555,-0.0049421617492643455,
    0.003438069839411203,-0.002461490005488413,0.001800040634249593,-0.0013454272573140676,0.0010130637887185517},
    {0.4186537014940566,1.946281236857435e-17,-0.044914559210460836,0.0173953859534717,-0.008786856089577114,
    0.004979131979990921,-0.0030089813936807538,0.0018948625331396043,-0.0012279532092407904,0.0008127486958929435,
    -0.0005492382755460873,0.00037426638454132077},{0.41329515313902027,2.2444085137049993e-17,-0.04094205320361987,
    0.01451456993677587,-0.006702685360086287,0.0034707346185206514,-0.0019162109509771306,0.0011023012930166344,
    -0.0006524788561638331,0.0003944349934498883,-0.00024325572355304872,0.00015138270219250253},{0.40839188824634076,
    1.2648398169959827e-18,-0.03760263730691473,0.012292675234046119,-0.005228638553158899,0.002492767913330472,
    -0.0012668808469631027,0.00067076760599845,-0.0003654124835374587,0.00020328833258422788,-0.000115304625040349,
    6.60302331014571e-05},{0.4038739917684657,1.6325210646061102e-17,-0.03475651888467564,0.010543131146766471,
    -0.004156811286729625,0.0018362786492790981,-0.0008645607803542443,0.0004240196985281986,-0.00021395365848117965,
    0.00011024224291824229,-5.7884736456829605e-05,3.0699099160179334e-05},{0.3996864680075742,-1.3834664617695285e-17,
    -0.03230222375331501,0.009141018634911544,-0.0033588530268160647,0.0013823662486416044,-0.0006062581229874869,
    0.0002769364282344698,-0.00013014156756778063,6.244894875981417e-05,-3.0524293478113774e-05,1.5074987594286202e-05},
    {0.39578527818287335,-2.1196942243258116e-17,-0.030164308198735817,0.008000141559354771,-0.0027525941972284494,
    0.0010604266067406397,-0.0004352612228327657,0.00018606505965381703,-8.182107397133008e-05,3.67382613250516e-05,
    -1.6797248652808333e-05,7.761848145628598e-06},{0.39039379807864516,1.7835681945541552e-17,-0.054858122269315676,
    0.0265995645452695,-0.016711062623191372,0.011749814499191377,-0.008800144415806956,0.006863330312765115,
    -0.0055057931005893365,0.004509583728887687,-0.003779531481044664,0.0031859014775508982},{0.38392213604439296,
    1.7060773554569338e-18,-0.04890938404033382,0.02128461383191536,-0.011983464277424494,0.007546745655114082,
    -0.005061150655944307,0.00353389474939739,-0.0025377747941497902,0.001860579251517085,-0.0013937778478289762,
    0.0010515030761741643},{0.37811933031203326,-2.426522520394753e-17,-0.04409658894882639,0.01741096409864156,
    -0.00888175028381013,0.005065496589389614,-0.003075741533333484,0.0019441413850749556,-0.0012637457173663169,
    0.0008386010676980153,-0.0005679828373866782,0.00038779688946960305},{0.37286310552807833,1.8832940459203704e-17,
    -0.04012403518486393,0.014501515532023614,-0.006763170522454271,0.0035248566390693203,-0.0019554138361115117,
    0.0011290864886310738,-0.0006703960777922702,0.00040632261506839224,-0.0002511545925556435,0.00015660698817935936},
    {0.3680617828888813,2.111031234887745e-17,-0.03679033869057626,0.012261334906530702,-0.005267276898781149,
    0.0025276176942086127,-0.0012907809943733294,0.0006860107398693311,-0.0003748777660180757,0.00020910174714790653,
    -0.00011887241762006011,6.820889562379679e-05},{0.36364486641274146,2.0336467709845003e-17,-0.03395362087497008,
    0.010500152128079438,-0.004181235677123913,0.0018592036373662065,-0.0008795932652940445,0.0004330359399028247,
    -0.0002191863775774699,0.00011323700882240591,-5.959361553586466e-05,3.1668791141342856e-05},{0.35955699082224024,
    -3.6200539433684135e-18,-0.03151105311854175,0.0090907660422205,-0.0033738516427908568,0.0013976967348722888,
    -0.0006159636951752592,0.00028244755445543405,-0.0001331488495560859,6.406192299223175e-05,-3.138495497301125e-05,
    1.553133743907322e-05},{0.3557538863022368,-1.3662495878349587e-17,-0.029386294915919504,0.007945530570548448,
    -0.0027612519790428296,0.0010708017993768914,-0.00044166708208091636,0.0001895300050236609,-8.360823522117585e-05,
    3.764110118134042e-05,-1.7249966325537807e-05,7.987237642672367e-06},{0.35050631817671174,-1.8128004879040534e-17,
    -0.05334440358584138,0.026368931687011706,-0.016732972144677453,0.011843435417344955,-0.008913843096519417,
    0.006978930442431359,-0.00561634960269424,0.004612530266914811,-0.0038749257650630762,0.0032729973601047847},
    {0.34422024432807485,-2.077995282288533e-17,-0.047453739396703394,0.02105268324846651,-0.011972607957285787,
    0.007590295111180151,-0.0051155285624818,0.0035858003046859615,-0.002583313468960493,0.0018991135159832793,
    -0.0014260212021038432,0.0010780517902031096},{0.3385958006156318,-2.822142403728291e-18,-0.04269813579046589,
    0.017186289856274198,-0.008855920439525409,0.005084665743590628,-0.003102733008548065,0.001968903658116747,
    -0.0012839782677390012,0.0008543602463545207,-0.0005800387420976625,0.0003968537026342836},{0.33351092633227497,
    2.504502012785821e-18,-0.038780418954577026,0.014287876626955891,-0.0067311555831277865,0.0035318061882635026,
    -0.001969058572728749,0.001141454762811796,-0.0006799437229774725,0.0004132454124128831,-0.00025604736961341954,
    0.00015999317664173435},{0.3288742814664212,1.039702483660398e-18,-0.03549859181532233,0.012060126464339816,
    -0.005233507180821245,0.0025283873826404493,-0.001297652627173836,0.0006923995187435534,-0.00037960614908829325,
    0.00021232631033765546,-0.00012099708369454264,6.957481249385943e-05},{0.32461575542476007,2.2433268680215446e-17,
    -0.03271059447495029,0.01031156595437143,-0.00414794074698755,0.001856900632772148,-0.0008829281111158933,
    0.0004364101670596182,-0.0002216200770023771,0.00011481347901754347,-6.056991411726347e-05,3.2256067857527734e-05},
    {0.32068037585222753,1.9926931330260285e-17,-0.03031363406679437,0.00891439537714849,-0.0033421158619256013,
    0.0013939575396010489,-0.0006174199746796353,0.00028424812371974275,-0.00013443986703593782,6.486423906095934e-05,
    -3.185549039253834e-05,1.5797899620962876e-05},{0.31702425395496375,1.3250248608987648e-17,-0.028231511607812638,
    0.0077806876755917515,-0.0027315528017202878,0.001066498283926279,-0.0004421214168476957,0.0001904867793005158,
    -8.430871358471964e-05,3.80632329164291e-05,-1.7486117030845716e-05,8.113981436784103e-06},{0.3119876028248073,
    -1.778290996099431e-18,-0.051152434745438555,0.025772691495133438,-0.016521673132460096,0.011773741462113557,
    -0.008906474226218609,0.0070012921932046225,-0.005653111519746345,0.004655857296951555,-0.003921037721012026,
    0.0033191044702696897},{0.3059666048014136,2.3355826197533602e-17,-0.04540145819523833,0.020529352582332457,
    -0.011794383521549413,0.0075285301379959205,-0.005099830851934855,0.003589295349737779,-0.002594496463425079,
    0.0019127670882155925,-0.0014398575802530324,0.0010908829526165365},{0.30059085270053554,-9.864595121971203e-18,
    -0.040768795974816044,0.016724316368215295,-0.008706065191262281,0.005032955738495662,-0.003086931251833738,
    0.0019668570247804566,-0.0012869640250456802,0.0008587999471949204,-0.0005845143548728366,0.0004007928259907116},
    {0.2957402080931379,1.4927868302102865e-17,-0.036959933181007154,0.013877550670785107,-0.006604785414125701,
    0.003489349969203057,-0.0019553974002605406,0.001138171485290451,-0.0006802818773297091,0.00041464111806651527,
    -0.0002575587319187535,0.0001612925476614258},{0.2913249494616567,1.6555106085094425e-17,-0.033775079547709606,
    0.011693463756725626,-0.005126359736735005,0.002493695734452224,-0.0012864500127228269,0.0006892388449275132,
    -0.00037915682482861276,0.0002126881341338662,-0.00012150944894228372,7.002433438468527e-05},{0.28727633448140383,
    -5.649305643922208e-18,-0.031073983266835914,0.009982038741536402,-0.004056507865111713,0.001828505087791411,
    -0.0008739217350823434,0.0004337362949615083,-0.00022101293931244153,0.00011483125030450763,-6.0732841987105676e-05,
    3.241486758531836e-05},{0.2835405543594686,-1.1269886314523908e-17,-0.028755330065031313,0.008616659915039213,
    -0.0032635727799742846,0.0013706055858252548,-0.0006102217873023177,0.00028209339592856903,-0.00013387687365274035,
    6.478071407353614e-05,-3.189536324211748e-05,1.585304631962954e-05},{0.28007471626084096,-2.0799547350994845e-17,
    -0.026744133794744513,0.0075103496736328235,-0.002663640490836679,0.0010471771275149557,-0.00043636453722988814,
    0.0001887839470383751,-8.384146684518238e-05,3.796285427114854e-05,-1.7484473882555803e-05,8.131429124611146e-06},
    {0.2753078694479779,2.5759254791481226e-17,-0.04836705956810804,0.02482924022327622,-0.01607975487656344,
    0.011538177155514067,-0.008773669965050907,0.006925502176649372,-0.005611151586206599,0.0046348534854793195,
    -0.003913429987024429,0.0033201298621913624},{0.2696211112889662,-2.648725117939274e-17,-0.042832921982308425,
    0.019731877563910833,-0.011452132191512223,0.007360744066795717,-0.005012163609144997,0.0035422731610995355,
    -0.0025693498293860345,0.0018998089795156145,-0.0014338066707278744,0.00108876063350369},{0.26455459567105233,
    -1.6300127748301088e-17,-0.038384797283275394,0.016041010534646592,-0.008435651145426592,0.004910460004977407,
    -0.003027526699713058,0.0019370548059605,-0.0012718553856754342,0.000851227963623471,-0.0005808648735782064,
    0.00039919749068266177},{0.2599917741986715,3.505259509618164e-18,-0.03473497485260371,0.013285226167955447,
    -0.0063873841793561596,0.00339791341876169,-0.0019141144001389263,0.0011188001334045353,-0.0006710270482197239,
    0.00041021370163326883,-0.0002554716786527994,0.00016035140728019339},{0.2558457837664193,-1.753436526187487e-17,
    -0.03168867893160432,0.011174833400551948,-0.004948910868968645,0.0024240852047207307,-0.0012570855381330993,
    0.0006763271072269991,-0.00037334961889465013,0.00021005368224627952,-0.00012031732781182808,6.949645059517547e-05},
    {0.2520501956984247,1.590726094603903e-17,-0.029109432529644003,0.009523955423684517,-0.00390973495466527,
    0.0017745773073401788,-0.0008525908005947083,0.00042492436702377376,-0.00021727827708643708,0.00011322750933891702,
    -6.004111301421295e-05,3.211944001268642e-05},{0.24855310098571948,-1.551054479782653e-18,-0.02689881696872558,
    0.00820894729200203,-0.003140745639987457,0.0013281746725345473,-0.0005944305973111997,0.00027594740928293243,
    -0.0001314178098322434,6.378084874308454e-05,-3.148526553195814e-05,1.5685335994543003e-05},{0.24531318651162284,
    -5.5832122909045036e-18,-0.024984104610472294,0.007145006720121676,-0.0025597820856501936,0.001013327705160001,
    -0.0004244738993086786,0.00018441165842939515,-8.218633357075637e-05,3.7324827355542716e-05,-1.723568506801271e-05,
    8.034272348047753e-06},{0.24086414643767845,1.1378675029715151e-17,-0.04510075007568308,0.02357582974009754,
    -0.015422640033023951,0.01114338470898445,-0.008517927851555722,0.00675192878153078,-0.005489700343013893,
    0.00454813982259832,-0.0038503928114451613,0.003274224841534348},{0.2355672866646469,-6.601914426560723e-18,
    -0.03985196382253108,0.018692302212849714,-0.010958326696029213,0.007092138809337629,-0.004854605755411854,
    0.0034453767911609267,-0.002507845483029415,0.0018599093404527388,-0.0014074167915621519,0.001071208725796867},
    {0.23085805080403185,1.474893501491508e-19,-0.035642508215077286,0.01516418852146774,-0.008054849990688374,
    0.004721229530115938,-0.002926132050695495,0.001880074668155297,-0.0012387847778991834,0.0008315928923680518,
    -0.0005689721150280183,0.00039193689387531866},{0.226625015566267,5.910058166488266e-18,-0.032195405443225196,
    0.012535255209960688,-0.006087328681302572,0.003260665409284687,-0.0018464353154365803,0.0010837939460454358,
    -0.0006523200067662323,0.00039998114316901396,-0.00024976050429112396,0.00015713344733165466},{0.222785307492262,
    -1.3578164983976604e-17,-0.02932353274074976,0.010525720899736178,-0.0047081279273238925,0.00232205556188075,
    -0.0012104886866862905,0.0006540049487964789,-0.00036229930864708896,0.00020445243072087638,-0.00011742008754588512,
    6.798195925312905e-05},{0.21927566702672743,-5.877060873504535e-18,-0.026896021801421824,0.00895640612493005,
    -0.0037134723372742773,0.0016971086247871826,-0.0008196437848015657,0.0004102272271631682,-0.00021050259620961773,
    0.00011002831321425321,-5.8499747357133634e-05,3.1368350709372115e-05},{0.21604674606187796,-2.582555864105153e-18,
    -0.02481866128218665,0.007708327484797386,-0.0029785906160746194,0.0012682671068312622,-0.0005705909457265381,
    0.0002659978459684777,-0.0001271261225473585,6.188467533838807e-05,-3.063044890884654e-05,1.5295358155738413e-05},
    {0.21305933163878496,-1.2425385491528936e-17,-0.023021943499730357,0.006700010455954462,-0.00242421086947833,
    0.0009662519593303493,-0.00040687206628038566,0.00017751001809951538,-7.938951149553185e-05,3.616381566414881e-05,
    -1.674397259288315e-05,7.823434670461843e-06},{0.20896339164763614,-7.655759215283528e-18,-0.04148386058744152,
    0.0220653383748413,-0.01457743848732021,0.010604886811487038,-0.00814866368970229,0.00648644730395568,
    -0.005292448987687241,0.0043980021192566365,-0.003733283957697078,0.0031821155973851007},{0.20409657129032327,
    -4.583785816667576e-18,-0.036576878466371844,0.01745462937412449,-0.01033358532184542,0.006733511261280698,
    -0.004633164394000367,0.0033020626585062236,-0.002412003701492133,0.001794249972930673,-0.0013613706802539426,
    0.001038605703547206},{0.19977852135682106,-3.9869585589025766e-18,-0.032650111690665944,0.01413102767738421,
    -0.0075797006013054264,0.004472996616095906,-0.002786714090764332,0.0017980275288467036,-0.0011888988673234473,
    0.0008005229294351219,-0.0005491802911141614,0.00037919624751040024},{0.19590426393261626,-9.111064127882363e-18,
    -0.02944080943390127,0.011659455051911759,-0.005717337820639791,0.003083284912436005,-0.0017550605776696353,
    0.0010344872899657395,-0.0006248357485261031,0.00038428931681935353,-0.00024060362007135314,0.00015173004432110507},
    {0.19239587792760088,1.0432815173202574e-17,-0.026771826042790277,0.009773658070554305,-0.004414265374296219,
    0.0021918699007734813,-0.001148547614870639,0.0006231423338774775,-0.00034641697790755663,0.00019608167383073057,
    -0.00011291339940742077,6.552720807203815e-05},{0.1891939937639612,-1.0452550611793816e-17,-0.024519502724101562,
    0.00830344296720124,-0.0034761071731420714,0.0015993608720774812,-0.0007764322953197824,0.0003902278871553921,
    -0.00020094410829402717,0.000105350015888636,-5.6161838166370246e-05,3.01858947331972e-05},{0.18625237612078993,
    -7.990753950529087e-18,-0.02259497083157399,0.007135988809587856,-0.002784054390505137,0.0011934207606270238,
    -0.0005396906421488903,0.0002526450971935352,-0.00012116857572646817,5.916294458368267e-05,-2.9361352246531194e-05,
    1.4696278056473435e-05},{0.18353434278750838,-9.410474932596987e-18,-0.020932768144951597,0.006194164190249118,
    -0.0022627446067136027,0.0009079539247243264,-0.00038429437821089964,0.0001683600686839913,-7.55614302017316e-05,
    3.452405327337445e-05,-1.602732117114011e-05,7.506279866954855e-06},{0.17981333667976657,8.43199183069699e-18,
    -0.03765365385840351,0.020361405297741966,-0.013580473974400464,0.009945735374147946,-0.0076814546662163,
    0.006140023036078118,-0.0050273367328680305,0.0041903049115213755,-0.0035665230188922595,0.0030471479928004825},
    {0.17540046753166663,-1.1062782438489959e-17,-0.033130558657391285,0.016070769319111805,-0.009604770510171133,
    0.006300290499787157,-0.00435726982382332,0.0031183345351411314,-0.0022857570066691264,0.0017054603143317891,
    -0.001297461754390576,0.0009921829983594445},{0.1714929102346775,-3.77521495998451e-18,-0.02951867203115008,
    0.012984646868182974,-0.007030619460750082,0.0041764736473582165,-0.002615249848342471,0.0016943863619385715,
    -0.0011242739758322783,0.0007592855863445625,-0.0005222784528237949,0.0003614707500312749},{0.16799317546442405,
    -5.730789984723606e-18,-0.026572351472706663,0.01069418743635094,-0.005293285938606367,0.002873439702000979,
    -0.0016439260157642438,0.0009729834306246428,-0.0005897306703836359,0.0003637875046489982,-0.0002283726528526006,
    0.00014435584342062285},{0.16482904456519712,-2.484182668247295e-18,-0.02412632170337351,0.00894970278452377,
    -0.004079905358000141,0.0020391598296755397,-0.0010739390753981377,0.0005850634054020078,-0.00032637648100432894,
    0.0001852916146695171,-0.00010698273317884156,6.223138623266354e-05},{0.1619455920473814,-4.156294342148063e-18,
    -0.022065422528517627,0.007591885651200855,-0.0032077775381627563,0.0014855623140380882,-0.0007248277960679548,
    0.000365788145735807,-0.00018901100901252027,9.939005893511027e-05,-5.312467535641155e-05,2.862050620062328e-05},
    {0.1593001141310331,-1.977140294263668e-18,-0.020307032248432205,0.006515311950357912,-0.0025654228381201145,
    0.0011068713501011923,-0.0005030697982462901,0.00023646642126727487,-0.00011380088799365669,5.5731329537018e-05,
    -2.773126372276434e-05,1.3912906676867042e-05},{0.15685878198842518,-1.175214539091794e-17,-0.018790384664628346,
    0.005648020539865538,-0.002082240160546418,0.0008409513523744557,-0.00035772072303962113,0.00015735832010242262,
    -7.086706348621016e-05,3.2475623476157065e-05,-1.5116043378877288e-05,7.096062500236271e-06},{0.15352138517211805,
    7.048468118568026e-18,-0.03374365236082705,0.018532705519299038,-0.012473883241272115,0.0091943372486101,
    -0.007136581823151583,0.005727703361495073,-0.004705839484685959,0.003933983076530821,-0.003357223921348548,
    0.0028750231241758593},{0.14957068583514996,1.1907884933180826e-18,-0.029631133624354898,0.014595911403471289,
    -0.008802481479528501,0.005811079387885888,-0.004038886628658639,0.0029021843844029833,-0.0021345907507265916,
    0.0015973830117946314,-0.0012184391210419275,0.0009339224765982835},{0.1460789685047281,-3.0984619596843823e-18,
    -0.026353823404864616,0.011770297197981954,-0.006430502717568805,0.0038443402948714956,-0.002419160695356409,
    0.0015736598655772367,-0.0010477236785207853,0.0007096724552610108,-0.0004894304622339361,0.0003395228847529499},
    {0.14295696217233417,-1.2328321984813091e-17,-0.023685335451571515,0.009677176063694524,-0.004832734129073902,
    0.0026400621820294643,-0.0015178293178998398,0.0009019557217886395,-0.0005485343588127208,0.00033936853027412403,
    -0.00021359882604769648,0.00013532977960946792},{0.14013866360687782,-1.274034826158372e-17,-0.021473651485942147,
    0.008085745936794193,-0.003718799678755495,0.0018703946530424483,-0.0009898741253493632,0.0005414208293633609,
    -0.00030305094257190266,0.00017255273850232984,-9.988633879421908e-05,5.823758981810037e-05},{0.13757396203197725,
    -8.193576175754492e-18,-0.01961303796730795,0.006849017467162157,-0.0029194444826381757,0.0013605101550497908,
    -0.0006670438286056916,0.00033796660783988165,-0.0001752228193160552,9.240843426514416e-05,-4.952072200609659e-05,
    2.6740333548761153e-05},{0.1352239591540711,-2.728654837200699e-18,-0.01802776030510243,0.005869879877607258,
    -0.0023315669548623704,0.0010122491970838295,-0.0004622936307948106,0.00021816095720970558,-0.00010534342932585016,
    5.1739502398811755e-05,-2.581133746608507e-05,1.2979409199149471e-05},{0.1330578859552715,1.3353592511863773e-17,
    -0.01666220134519073,0.005082147993717459,-0.0018899731237093057,0.0007680405738264015,-0.0003282826625031544,
    0.00014497896173493337,-6.551021306030741e-05,3.010781212813036e-05,-1.404992681366806e-05,6.61069320443687e-06},
    {0.13010081314942784,-3.7795276100084327e-19,-0.029874646313761993,0.01664723554515046,-0.011301837730527791,
    0.008381816315790788,-0.006537113474766611,0.005267184363713645,-0.004341874424993519,0.0036401907095068996,
    -0.003114520791589897,0.002673261162052561},{0.12660638657726817,6.9179062526674496e-18,-0.026184247093720327,
    0.013084012091890028,-0.007958343296949423,0.0052859411214598645,-0.0036913886393418506,0.002662832700385933,
    -0.001965019246877865,0.0014747067207272753,-0.0011277455297849244,0.0008663684361741062},{0.1235234369021397,
    -5.430291998818087e-18,-0.023249060898281385,0.010531725488026514,-0.005802721947229758,0.003490085573929352,
    -0.0022066185338885545,0.0014409653354250298,-0.0009625303999164665,0.000653827828521674,-0.00045206369671348877,
    0.0003143096996272475},{0.12077131886408181,5.1483126817389315e-18,-0.020863319029954225,0.00864452524554535,
    -0.004353411215391464,0.0023925407641149925,-0.0013819843115746421,0.0008243954006135787,-0.0005030039997534998,
    0.00031208338851077444,-0.00019692209066275327,0.0001250445638862371},{0.11829051679981688,-1.4637844202993077e-18,
    -0.018889110523734477,0.0072120317916101635,-0.00334469417247606,0.0016923008798882266,-0.0008998017712806087,
    0.0004940406142028845,-0.0002774299014334267,0.0001584108903105551,-9.19305145585043e-05,5.3719109537368954e-05},
    {0.11603592083604392,-6.779548166168704e-18,-0.017230678793210646,0.006100497344035987,-0.0026219657783508204,
    0.0012291438800159607,-0.0006054331034883244,0.0003079197884610177,-0.000160161260488104,8.470291370284807e-05,
    -4.5504939481371066e-05,2.4626706275210304e-05},{0.11397256794156713,5.988638924211211e-18,-0.015819543065083506,
    0.005221700873030164,-0.0020912017118736343,0.0009132591878545536,-0.00041900997111653915,0.0001984847580984871,
    -9.61510473409854e-05,4.735691332685828e-05,-2.3683795546329236e-05,1.1936030991703487e-05},{0.11207284064669656,
    -5.4659479052810166e-18,-0.014605485631507896,0.004515604426333262,-0.0016930367312547711,0.0006920521332931684,
    -0.0002971611351915789,0.00013173004122758354,-5.971439518303926e-05,2.7520650516940388e-05,-1.287444063863402e-05,
    6.071024133135377e-06},{0.10948269541583501,1.6723060854545899e-18,-0.026148237470523417,0.014767377749270038,
    -0.010106953762051141,0.007539328710038329,-0.005906841509570714,0.004777189283104888,-0.003950503590631619,
    0.0033212501152229523,-0.0028487003568138697,0.0024504832212025414},{0.10642684277790365,5.401337106217862e-18,
    -0.02287768543261711,0.011583988915421072,-0.00710249081406891,0.004744697700620999,-0.0033283790424789646,
    0.002409893261244653,-0.0017839846493034313,0.0013425276739685464,-0.0010291923209044943,0.0007923857249617895},
    {0.10373532508805458,-4.257487663202351e-18,-0.020281214220455767,0.009308172569055119,-0.005169302642641358,
    0.003126882661692617,-0.001985834681059807,0.0013015704293711915,-0.0008721454483600215,0.0005940498080592242,
    -0.0004117351779327642,0.00028689230822557117},{0.10133622459071016,-6.864179532852068e-19,-0.01817426038195598,
    0.007628308161182883,-0.0038718593588243206,0.0021399492883933994,-0.0012415733508632696,0.0007433467920789753,
    -0.000454965365466847,0.00028304457459628877,-0.00017903152961064406,0.00011392976746358562},{0.09917655932575659,
    -2.3869922530828322e-18,-0.016433349033996965,0.0063551897590920815,-0.002970298802018598,0.0015113187613454621,
    -0.000807116770975932,0.00044476229312532807,-0.00025053063946597204,0.00014343749288779414,-8.344129160804552e-05,
    4.8863243033563106e-05},{0.09721623509984592,2.460823905692662e-18,-0.014972887168297961,0.005368732066093375,
    -0.002325297647216996,0.0010961522662363873,-0.0005422907561725107,0.00027680202045970656,-0.00014441863400387539,
    7.658212296364906e-05,-4.124056892307524e-05,2.236658702699929e-05},{0.0954242211026023,6.047656821325821e-18,
    -0.013731753666244136,0.004589846761776419,-0.0018522570475732179,0.0008133904086022868,-0.00037481321262167547,
    0.0001781860767771434,-8.658188292420912e-05,4.275759829476059e-05,-2.1434440438983413e-05,1.082538737748009e-05},
    {0.09377603834451885,-1.25984311428295e-19,-0.012665188980752945,0.003964786425176959,-0.0014978390619057537,
    0.0006156321866277771,-0.00026549016481346155,0.00011811044881892733,-5.370338524272091e-05,2.481602297218462e-05,
    -1.163662619125632e-05,5.498939517161359e-06},{0.0915315330844566,2.8344570251302546e-18,-0.022643256218344072,
    0.01294626707486386,-0.008927350381412272,0.006695707813855555,-0.005268376654109254,0.004275908399503958,
    -0.003546641269518657,0.0029895701609930804,-0.002570282610033835,0.0022156298304607676},{0.08888746394631938,
    -5.908646671255289e-18,-0.019778581488117307,0.010137001912744149,-0.006261557894567619,0.00420547258794128,
    -0.002962626797306063,0.0021525884936272667,-0.001598272071968984,0.0012059096834656793,-0.0009266238663200163,
    0.0007149035347311891},{0.08656224613940801,-2.1918915679917456e-18,-0.017508247143751383,0.008132290369120073,
    -0.004549502237541489,0.0027666459646319076,-0.0017644323716710145,0.001160471793341003,-0.0007799034101422844,
    0.0005325950779802041,-0.00036999649217968886,0.00025834226018557193},{0.08449252222555208,1.0164133836923813e-18,
    -0.015668778380817552,0.006654939663641809,-0.0034023998165139875,0.0018904141561573488,-0.0011013599691976261,
    0.0006616684868580027,-0.0004061643407000048,0.00025333305793016485,-0.00016060643309437445,0.00010241441626798572},
    {0.08263169330849311,5.939376052266667e-18,-0.014150995332397177,0.005536942487677874,-0.002606517528213145,
    0.0013331643003502555,-0.0007149113036310813,0.00039529732559915925,-0.00022331684948017632,0.00012818249641372462,
    -7.473694578666391e-05,4.3855196541411265e-05},{0.08094454783454683,6.552294006738216e-18,-0.012879330698067164,
    0.004671836481310087,-0.0020379097346167464,0.0009656622616528059,-0.0004796899409117837,0.0002456782252203735,
    -0.0001285512452544009,6.834050983611918e-05,-3.688555729561248e-05,2.004519197010888e-05},{0.07940387064797805,
    -5.302802900816093e-18,-0.01179989812445735,0.003989606257175814,-0.0016214257616427746,0.0007156901359742907,
    -0.00033113241559293175,0.0001579498324844861,-7.696965956526684e-05,3.810626994079085e-05,-1.9145616316241576e-05,
    9.688892339660479e-06},{0.07798821932464249,4.9713388198463784e-18,-0.010873286775972883,0.00344273298521147,
    -0.001309748407332964,0.0005410750917343058,-0.00023427885228005993,0.00010457353750204785,-4.7684175263374695e-05,
    2.2089640698496337e-05,-1.0381288871633048e-05,4.915544107386353e-06},{0.07606249668238793,2.8415512852061175e-18,
    -0.019414896785518658,0.011225680647262676,-0.00779463058074137,0.005875702212749228,-0.00464163803580448,
    0.003779706277681495,-0.003143944106346309,0.0026566891270334405,-0.0022891853686813676,0.0019772339087293926},
    {0.07379711786484996,-6.4549366166549034e-18,-0.01693299489339447,0.00877496048161627,-0.00545734607184705,
    0.003683631908183059,-0.0026052453696360912,0.0018991154601440395,-0.001414019481602935,0.001069504017738928,
    -0.0008236198343389241,0.0006366826923451462},{0.07180776982854271,-6.591986438361668e-18,-0.014969156064130603,
    0.007029062752436764,-0.003958900986079648,0.002419364997942003,-0.0015489741610191772,0.0010220624216413625,
    -0.0006887881217463684,0.0004715138915467028,-0.00032827650131178837,0.0002296583084474328},{0.07003926918817024,
    5.757875526481546e-18,-0.013380283016875513,0.00574438373632411,-0.00295649428084395,0.0016506791887582995,
    -0.0009654039760115424,0.0005818488898688558,-0.00035814776922220754,0.00022392122496048045,-0.00014226614045290497,
    9.089438592334635e-05},{0.06845109100127364,5.842798054012895e-18,-0.012070957532228805,0.0047735169819421285,
    -0.002261989007954667,0.0011625359417621486,-0.0006257964162290527,0.0003471219796292864,-0.00019663462977865406,
    0.00011313613295808032,-6.61050264369296e-05,3.8864305026085274e-05},{0.06701265552645555,-2.1176630048590576e-18,
    -0.01097523191297561,0.004023192491992193,-0.0017664482595224286,0.0008410359652306238,-0.00041936618524267977,
    0.00021545921996007886,-0.00011304342398048186,6.0238355215668425e-05,-3.2581408250330404e-05,
    1.7739780091991208e-05},{0.06570035713014209,-5.335371078071051e-19,-0.01004614073351891,0.0034321532798647237,
    -0.001403912355889598,0.0006226200897663135,-0.000289154261912426,0.00013835720404620683,-6.76026536452152e-05,
    3.354739640868398e-05,-1.689052131135764e-05,8.56380044072942e-06},{0.06449561859713696,4.838804014438247e-19,
    -0.009249375908993253,0.0029588759056083636,-0.001132903364043768,0.0004702196148177693,-0.00020435877540326644,
    9.150113781197782e-05,-4.183425905153072e-05,1.9424840646650007e-05,-9.147968334769402e-06,4.339685151545378e-06},
    {0.06285845320357811,-2.295551143880392e-18,-0.01649606443957823,0.00963539124076664,-0.006732860429824089,
    0.00509892432535979,-0.004042865595484784,0.0033022228791267506,-0.0027540031321798423,0.0023325520511955403,
    -0.0020140738944925624,0.0017428399743443662},{0.060934980904183686,2.9459595301498826e-19,-0.014367380199697565,
    0.007520177552963712,-0.004706204319966738,0.0031911846159850665,-0.002265177051558167,0.0016562200396912348,
    -0.0012363718950139041,0.0009372706251022651,-0.0007232697187545392,0.0005601346269809825},{0.05924808509766851,
    1.1096091309735472e-18,-0.012685499642756759,0.006015644752834126,-0.0034090151672260065,0.002092746663962761,
    -0.001344676907126234,0.0008899156805668975,-0.0006012724362821719,0.00041253234961585587,-0.0002877948010685882,
    0.00020170324627796828},{0.05775020687770912,-5.230202879455357e-21,-0.011326529582211116,0.004910109105664098,
    -0.0025424996547861235,0.0014258846514240968,-0.0008368964851290728,0.0005058903944996926,-0.00031218422257691834,
    0.00019561934763304316,-0.00012453393721073778,7.970823321128693e-05},{0.05640646968314769,-3.4800839374532036e-19,
    -0.010207978875262917,0.004075674301542097,-0.0019429300094430406,0.001002974179345618,-0.0005418028329174298,
    0.0003014122712127657,-0.0001711711285289203,9.870302456144857e-05,-5.778621223146678e-05,3.403404477376928e-05},
    {0.055190589355418485,-3.3661433841596155e-19,-0.00927290982128245,0.0034315260342094246,-0.001515636355368162,
    0.0007247794188237967,-0.0003626558290246802,0.00018686371934430234,-9.828492883743102e-05,5.248857870522099e-05,
    -2.8445526108830827e-05,1.5515248300271003e-05},{0.05408229954440205,3.1455813706208126e-19,-0.008480822345425732,
    0.002924653835030642,-0.0012033706718509525,0.0005359961398253501,-0.0002497838169391146,0.00011986268793770153,
    -5.871085704770157e-05,2.919817010944466e-05,-1.4729389376259563e-05,7.481152529520718e-06},{0.05306566780056987,
    -2.4870461349401015e-18,-0.007802163845172775,0.002519165090302981,-0.000970175283956711,0.0004044085546484236,
    -0.00017635841088621947,7.918930572647773e-05,-3.629408842281425e-05,1.6888690765875474e-05,-7.968949481247825e-06,
    3.7869468598041603e-06},{0.05168539341159863,2.5252856634454642e-18,-0.01390025356935908,0.008193724717321393,
    -0.0057584517711606175,0.004379491065035428,-0.0034841741595216893,0.0028539062904590433,-0.002385884682618264,
    0.0020250733716972186,-0.0017519476360192297,0.0015186206458935327},{0.05006561442925561,2.767389092908279e-18,
    -0.01209132243784226,0.006385944582906277,-0.004019036706475612,0.002736617572564638,-0.0019489844867999714,
    0.0014289917617455988,-0.001069296229520047,0.0008123176264793986,-0.0006280357179685665,0.00048720647681749885},
    {0.04864674345426715,-2.9058197738755e-19,-0.010663992045353175,0.005101922658419651,-0.002907361293638677,
    0.001792142898830362,-0.0011553105192304426,0.0007666895270634304,-0.0005192376233614686,0.00035698800065793945,
    -0.00024951136187758194,0.00017516536638478465},{0.047388188524389856,-4.7831206403979687e-20,-0.009512075355903427,
    0.004159620136692017,-0.00216575576557634,0.0012195403084417056,-0.0007181098061868891,0.00043526254628146354,
    -0.0002692267138822108,0.0001690478137863905,-0.00010781697012369173,6.912302017567479e-05},{0.04626022054352136,
    -3.358386134738053e-18,-0.008564965961703922,0.0034492058664783443,-0.00165323032150931,0.0008568570927785895,
    -0.0004643562548947292,0.0002590202784929571,-0.00014743643610876634,8.518948133147044e-05,-4.9965736317560506e-05,
    2.947640566719914e-05},{0.04524046061961096,2.601776801179212e-18,-0.007773988520177453,0.0029013677797178755,
    -0.00128836814123761,0.0006185490800001835,-0.0003104843111824156,0.0001604060944417017,-8.456180763708802e-05,
    4.5250638983639054e-05,-2.4567340765120274e-05,1.3421749266097074e-05},{0.044311671693955466,
    -1.1100321511855671e-18,-0.0071045581527622945,0.0024706922336797136,-0.0010219933047495718,0.0004569997643631255,
    -0.0002136395624302961,0.00010278771528651829,-5.046122382301575e-05,2.514545828035368e-05,-1.2707653091312002e-05,
    6.464710949254623e-06},{0.04346031583223632,-3.271585895952012e-19,-0.006531463947223198,0.0021264623896329335,
    -0.0008232513964930231,0.0003445020883831634,-0.00015070167921409043,6.784501818576045e-05,-3.1164546532290556e-05,
    1.4530414101120522e-05,-6.868355346693521e-06,3.2691517287450805e-06},{0.042305391661434606,-7.829870357230593e-19,
    -0.011625259771047154,0.006908959809977106,-0.004880745780678467,0.0037262388235161877,-0.0029735810358506886,
    0.002441939509542704,-0.0020460021850775153,0.0017399795991659443,-0.001507967342395054,0.0013091992210008908},
    {0.040951481393550405,-3.4154071560976135e-18,-0.01010092497742743,0.005377731916462883,-0.003401784760073194,
    0.0023250827391223966,-0.0016609041457646392,0.0012208549957279703,-0.0009155445054971731,0.0006968537068608502,
    -0.0005397025879870317,0.00041933318402139196},{0.0397667699406026,2.7664046800709287e-18,-0.008899611925094796,
    0.0042915499793335825,-0.002457853335599298,0.0015207042398553787,-0.0009832499453806165,0.0006541352873647114,
    -0.0004439646075401396,0.0003058151231773512,-0.00021411089931067863,0.0001505442083265229},{0.03871691698326982,
    -2.9190765699326888e-18,-0.00793114707677806,0.003495357259795643,-0.0018289135311247838,0.0010336489531653544,
    -0.0006104411966559311,0.0003709140090085741,-0.0002299124702190071,0.00014463285159776223,-9.240119872597178e-05,
    5.932977038324533e-05},{0.037776801498910315,1.3268463910742545e-18,-0.007135645585195199,0.0028957215914448085,
    -0.0013947255278301902,0.0007254992958643775,-0.00039431240576268757,0.00022048507062885785,-0.00012576563305786566,
    7.280259840366151e-05,-4.277177701782869e-05,2.5270380438633877e-05},{0.03692753325288007,-2.9156322149498193e-18,
    -0.006471869051293736,0.002433747610532595,-0.0010859370895060227,0.0005232312780391377,-0.000263393749746514,
    0.00013640531381891078,-7.205872350293709e-05,3.863067007451442e-05,-2.1007849816166233e-05,1.1494184378882573e-05},
    {0.03615457614901799,-1.1930701367619656e-18,-0.005910546041644727,0.002070886870944325,-0.0008607042227804636,
    0.00038624220870978244,-0.00018107500842116326,8.732767064688479e-05,-4.295969623652596e-05,2.1446197198999156e-05,
    -1.0855867610054444e-05,5.530796689817513e-06},{0.035446523523525564,-2.6413301102663198e-18,-0.00543035843651437,
    0.0017810907636373772,-0.0006927984677946691,0.00029092993633460267,-0.00012762491286525304,5.7591597171023844e-05,
    -2.6508566386457965e-05,1.2381788501380785e-05,-5.862187313204193e-06,2.7943167669752137e-06},{0.034486713308085094,
    -8.957486097499952e-20,-0.009657125864874067,0.005781196455447646,-0.004103051775313524,0.003143343904815222,
    -0.0025153875048048806,0.002070474905237941,-0.0017382557193890199,0.0014808856846061011,-0.0012854883535827859,
    0.001117653376877014},{0.03336258780005402,-2.6080329314266438e-18,-0.0083823327335661,0.004494719058727365,
    -0.002856207582999426,0.001958825771737302,-0.001403090390587247,0.0010337095718636429,-0.000776734137570544,
    0.0005922324089713997,-0.0004594002536831545,0.0003574469994088877},{0.03237988667835133,2.788468463931348e-18,
    -0.007378776555084849,0.0035832210585350173,-0.0020614017952188045,0.0012796840265014225,-0.0008296358983744085,
    0.0005531841519833021,-0.000376180624122833,0.0002595695502122388,-0.0001820156524863306,0.00012815665796124997},
    {0.03150979031208684,-6.112235064660765e-19,-0.006570522559739053,0.002915771597644256,-0.0015324040284574116,
    0.0008689276178951878,-0.0005145216599189763,0.000313327283833811,-0.0001945906939524983,0.00012262057015562428,
    -7.845839696439297e-05,5.0446833192617654e-05},{0.030731238494521404,1.6376735024456e-19,-0.005907198075283056,
    0.0024135674095350015,-0.0011675705479493124,0.0006093162902046725,-0.00033203255534303155,0.00018606828501760404,
    -0.00010633576220804584,6.165837628285244e-05,-3.627932605135259e-05,2.1463771172585884e-05},{0.030028409603202466,
    -1.2452427976406966e-18,-0.0053541496740694096,0.002026986118049475,-0.0009083379331755662,0.0004390666686823711,
    -0.00022159656977454334,0.00011500867153833435,-6.086961349337868e-05,3.26863013750607e-05,-1.780180089762549e-05,
    9.753181488860883e-06},{0.02938913929745564,-1.5390554966609691e-18,-0.004886802231291967,0.0017235792107104313,
    -0.0007194059830444444,0.00032386032996336455,-0.0001522175555122641,7.356808967561494e-05,-3.625807044281484e-05,
    1.8130329140651624e-05,-9.190972876091784e-06,4.688829182104654e-06},{0.02880388954042029,1.6549037423436127e-18,
    -0.004487272670595329,0.001481438842327186,-0.0005786675878663425,0.00024376629043313294,-0.00010720553689789538,
    4.848000282802787e-05,-2.2355658326826228e-05,1.0458981557178419e-05,-4.959073942582965e-06,2.3669586914432377e-06},
    {0.028011071670602652,7.2632768896332215e-19,-0.007973876601548663,0.004804369680215397,-0.003423906088800568,
    0.0026311719752375134,-0.0021107785586630375,0.0017410701021931567,-0.0014643549381100113,0.0012495372734267728,
    -0.0010862447617338421,0.0009456548723346208},{0.02708330202582252,1.0458588018569648e-18,-0.006915016435343983,
    0.003731405817200037,-0.0023807950813675514,0.001637744252532039,-0.0011759724882620351,0.0008681659258859437,
    -0.0006535059444696853,0.0004990597920925549,-0.00038767820283284446,0.0003020289541800026},{0.026272945176278952,
    -3.1027422901672945e-19,-0.0060822621543170025,0.0029719858842314267,-0.0017165956064606484,0.0010688194001072942,
    -0.000694597520743636,0.00046408121385067537,-0.00031614157688160627,0.00021848001631776163,-0.0001534178606196714,
    0.00010815755751509335},{0.02555598833699611,-1.439622610304641e-18,-0.005412151555410921,0.0024164158779688,
    -0.001274960074716696,0.0007250759609574129,-0.00043036034680924833,0.00026259873486740945,-0.00016336784061356368,
    0.00010310296475056743,-6.60613059682788e-05,4.252875502148695e-05},{0.024914900550736013,8.135383775050041e-19,
    -0.004862627943934708,0.0019987431996784837,-0.0009706468083127902,0.0005080186548420843,-0.00027748031924258097,
    0.00015580382372182145,-8.919187932870662e-05,5.179558634163836e-05,-3.051767482118344e-05,1.8077254542065404e-05},
    {0.024336522740346804,-1.4336195083157546e-18,-0.0044047847091524634,0.0016774763226674134,-0.000754590126840273,
    0.00036579400202559726,-0.0001850422638881425,9.622371109464148e-05,-5.101327551639777e-05,2.74343859677367e-05,
    -1.4961578189270307e-05,8.207062020411247e-06},{0.023810745412807914,-1.5278725281389898e-18,-0.004018138802609204,
    0.001425506489384528,-0.000597240613993105,0.00026962517480175056,-0.00012701568738808698,6.150577771786105e-05,
    -3.0363645583521057e-05,1.5205279673835425e-05,-7.718400414905939e-06,3.942324573789824e-06},{0.023329647287051485,
    6.462726907115102e-19,-0.00368779593041921,0.0012245451275754375,-0.00048010738842094923,0.000202813255938436,
    -8.939615670450539e-05,4.050316810326111e-05,-1.8708064264387842e-05,8.76523393606591e-06,-4.161457227414127e-06,
    1.988622218409192e-06},{0.022678302766710127,-7.399755888510767e-19,-0.006548763045553796,0.003968169038926926,
    -0.0028383597994993638,0.0021872032744397153,-0.0017585164072565125,0.001453222909892318,-0.0012242402516141175,
    0.0010461474922687155,-0.000910623741308902,0.0007936936542962054},{0.02191665169139378,-9.163018323587637e-19,
    -0.0056745910422573605,0.0030791237566196446,-0.0019716836516921205,0.0013599809025263928,-0.0009786552317115982,
    0.0007238233975708664,-0.0005457214469208354,0.00041733646649159896,-0.0003246095149989745,0.0002531853736521708},
    {0.02125189285920542,-1.5696941815433077e-18,-0.004987683171594271,0.0024504668576318437,-0.0014203744137175373,
    0.000886727950166521,-0.0005774961692157478,0.000386539526301593,-0.0002637313710792108,0.00018251318607682897,
    -0.00012832303192427704,9.05686436953758e-05},{0.020664147059939155,1.3877676320469325e-18,-0.004435359528183646,
    0.0019909420278159543,-0.0010541230060225472,0.0006010508307049922,-0.00035749941137689907,0.00021852835607977141,
    -0.00013616069908792814,8.604977974622268e-05,-5.520305889859044e-05,3.5578190107689076e-05},{0.02013891335845654,
    1.4441170035376073e-18,-0.003982740049149139,0.0016457333524892723,-0.0008019528335261168,0.00042080771456972635,
    -0.00023032363691477287,0.00012955245897041697,-7.427687203036584e-05,4.31922986966392e-05,-2.547971229169363e-05,
    1.5109645271506784e-05},{0.019665315290340064,8.698746862990138e-19,-0.0036058699560802005,0.0013803843025408506,
    -0.0006230446340845623,0.00030279306489358447,-0.0001534866422895717,7.995268176336487e-05,-4.2450848514249764e-05,
    2.2860000302718606e-05,-1.2481902630181781e-05,6.854312060402373e-06},{0.019235002692582683,-1.1476620971465832e-18,
    -0.0032877873012605303,0.0011723994635473162,-0.0004928345413633957,0.00022304865893334568,-0.00010528725723550716,
    5.1071249410273765e-05,-2.5249853916165755e-05,1.266106743861833e-05,-6.43456378989752e-06,3.2901179690901327e-06},
    {0.018841436879697318,-1.0808476271250412e-18,-0.003016166289072648,0.0010066130275199223,-0.0003959623801278148,
    0.00016768196315214168,-7.405901187459465e-05,3.361101983541246e-05,-1.554743201734262e-05,7.293868179027485e-06,
    -3.4669673375255954e-06,1.6585126873351382e-06},{0.018308875766061293,5.321648107206776e-19,-0.005352883983957692,
    0.003259712843881849,-0.002339161850096116,0.0018069193027439726,-0.001455630202570808,0.0012049217478840332,
    -0.0010165303660162178,0.000869766059693417,-0.0007579755745627335,0.0006613388230606233},{0.01768653048433569,
    -1.416500393939872e-18,-0.004635067878997238,0.0025273381779720547,-0.001623485504556419,0.0011224829051949793,
    -0.0008093101289208775,0.0005995507700932371,-0.0004526677738972102,0.00034660936787958693,-0.00026990517154463285,
    0.00021073426218354106},{0.01714371722395063,-4.850631576758884e-19,-0.004071453861497962,0.002009895482263922,
    -0.0011686299220555153,0.0007312765052409134,-0.00047715976938557197,0.0003198927321886586,-0.00021856312113153217,
    0.00015144169464621762,-0.00010659640105409122,7.531040293259687e-05},{0.016664072724774354,1.0535657752193983e-18,
    -0.0036185756275619535,0.001631942854065986,-0.0008666910498354559,0.0004953184460169841,-0.0002951608729805389,
    0.00018070738721954468,-0.00011274959476973538,7.134125581571907e-05,-4.5817633490823335e-05,
    2.9558736437541774e-05},{0.016235669681745342,1.0666736207147649e-18,-0.0032476763580091468,0.0013482013746110952,
    -0.0006589464576954824,0.00034655332006601567,-0.00019003033835890323,0.00010705443788554759,-6.146092449232427e-05,
    3.5782607537359976e-05,-2.1131551376223184e-05,1.2543466182574311e-05},{0.015849567968210833,7.832553036837982e-19,
    -0.0029390205652484063,0.001130230444419161,-0.0005116503521588377,0.00024921329975241,-0.00012655604224411085,
    6.602534970801784e-05,-3.510286892336584e-05,1.892542818919593e-05,-1.0344627097550895e-05,5.686156289684885e-06},
    {0.015498908148246088,8.005088502419538e-19,-0.0026786428535460795,0.000959474665582069,-0.00040450958623565073,
    0.00018347871622110832,-8.67638324763408e-05,4.214987575416244e-05,-2.0866517309003536e-05,1.0475343598632159e-05,
    -5.329366469134839e-06,2.7276188697673205e-06},{0.015178321823629569,1.5482528332736848e-19,-0.0024564008614427714,
    0.0008234321134103262,-0.00032484255868006786,0.00013786433371688477,-6.099734317899613e-05,2.772450202164137e-05,
    -1.2841190113108583e-05,6.031223969098634e-06,-2.8697909176310285e-06,1.374137818996327e-06},{0.014744711519069855,
    -5.367599785307115e-19,-0.004357162827057489,0.0026649047896738186,-0.0019177606646163072,0.0014845788738209475,
    -0.0011980366524264683,0.00099315306975377,-0.0008389439951462859,0.0007186342067842192,-0.0006269175511259691,
    0.0005474990967093541},{0.014238288988751556,2.7680847893439954e-19,-0.0037705339425432843,0.0020646913916485053,
    -0.001329982485715716,0.0009214852570859175,-0.0006655226289646807,0.0004937411483829757,-0.00037324776313032315,
    0.00028611529967654956,-0.0002230241461961895,0.00017428992411170504},{0.013796841809775315,-4.313113987008698e-19,
    -0.003310235901651599,0.0016409348117971735,-0.0009567037508119822,0.0005998962998602611,-0.0003920883785109337,
    0.00026323199204960566,-0.0001800717950699004,0.00012490759029393472,-8.800700289384845e-05,6.2232784146336e-05},
    {0.01340696878509015,2.8117743447964374e-19,-0.002940595796231595,0.0013316137763252456,-0.0007090870612526316,
    0.0004060677828970939,-0.0002423740901360611,0.00014859604788468225,-9.28265223429618e-05,5.879828797467174e-05,
    -3.7799002873892356e-05,2.4407142124968446e-05},{0.013058908106952557,-3.5955730665381133e-19,-0.002638029334634431,
    0.0010995314925160333,-0.0005388231139652253,0.00028394294261426613,-0.00015595031785230228,8.797569368973849e-05,
    -5.056789728685467e-05,2.9471865870527516e-05,-1.7421439141619205e-05,1.0350181305433177e-05},{0.012745347106704968,
    -1.799342658691912e-21,-0.002386360997433265,0.0009213392153550729,-0.00041816909063050145,0.00020408079823921145,
    -0.00010380207088729989,5.422756468618535e-05,-2.886439873647684e-05,1.557826402335611e-05,-8.523129289409177e-06,
    4.688950277529188e-06},{0.012460678021353805,2.609465130614695e-19,-0.0021741509862033795,0.0007818126155523773,
    -0.000330452001295366,0.00015017786249702837,-7.112820861629371e-05,3.460014640284343e-05,-1.7148867021617928e-05,
    8.617896968384542e-06,-4.3884780113235085e-06,2.24796675119937e-06},{0.012200514174282773,7.086114433547179e-19,
    -0.0019930954235182464,0.0006706996370961342,-0.00026525837735865516,0.00011279193101157061,-4.998173848823716e-05,
    2.2747596029974556e-05,-1.0548110440504387e-05,4.95926095988513e-06,-2.3619025069972197e-06,1.131893241126418e-06}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_power_eps_zero_force)

/* (1 - eps)/beta at zero overlap, beta < 7: 57 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 7.0625.
 * Relative error of the approximation: 2^-58.2 at most, proved for the whole cell of each row. Bits of the rows:
 * 60.1 59.0 59.0 58.2 60.2 58.7 59.4 59.5 59.6 58.9 59.7 60.8 60.1 59.9 61.3 58.9 58.9 59.2 59.9 59.3 60.1 63.7 60.4
 * 61.0 59.6 60.5 61.0 59.5 59.9 60.2 61.6 61.3 62.4 63.2 60.1 60.4 59.8 62.6 59.7 61.9 66.1 59.6 61.9 64.6 59.6 59.5
 * 62.4 64.5 60.4 62.4 61.0 61.3 60.4 61.0 60.3 60.3 61.9 */
#define COR_ROWS_LOSS_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_LOSS_ZERO_OVERLAP_STEP 0.125
#define COR_ROWS_LOSS_ZERO_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_LOSS_ZERO_OVERLAP_ROWS 57
#define COR_ROWS_LOSS_ZERO_OVERLAP_END 7.0
COR_ROWS(double, cor_rows_loss_zero_overlap, 57, 12)
#ifdef COR_ROWS_HERE
= {
    {1.1534488499164581,8.178830669247755e-09,-0.7982665609447954,0.5228825680884149,-0.34874267526034775,
    0.2330981320115887,-0.15668215158911236,0.10581873812962693,-0.07176352828084306,0.04881717366521926,
    -0.03281837465349686,0.0185115580634816},{1.0612069368362427,2.5228753230416938e-09,-0.6822457853746628,
    0.41124304537871,-0.2530809060047671,0.15578999742351413,-0.09639717486993526,0.059907511729117124,
    -0.037367049226916735,0.023390955918805863,-0.014744451667414081,0.00928434679317972},{0.9818928986787796,
    -3.6892589254544297e-09,-0.5901887009114681,0.3292579698482187,-0.1881913829102691,0.1073780466188341,
    -0.06155900656058392,0.03543831284866091,-0.020464431813466747,0.011858005734409002,-0.006913084625457385,
    0.0040275335688963335},{0.9129208624362946,2.222187918172159e-09,-0.5159259495026254,0.26766839087010663,
    -0.14289324683410987,0.07598962256295486,-0.040582965857067915,0.021766354144415353,-0.011701608416556219,
    0.006312483165770639,-0.0034234281169273004,0.0018559246758219252},{0.8523507416248322,1.0452698795726668e-09,
    -0.4551591481090624,0.2204876461522586,-0.11047947440985487,0.05502293386580459,-0.027499733906196457,
    0.013811507680193706,-0.006945036050493517,0.003505416525390201,-0.0017773232459486346,0.0009010221338318973},
    {0.798697829246521,2.8373864041658147e-09,-0.40481730828082957,0.18372561372710064,-0.08677920388032526,
    0.04065165747292786,-0.01908489188095974,0.009017724417044128,-0.004258063791191847,0.0020197853256019695,
    -0.0009615829426099448,0.0004577837191783362},{0.7508062720298767,-6.619657855051077e-09,-0.3626578412300652,
    0.15465224880092357,-0.06911635102615162,0.030577213155084985,-0.013524213656006132,0.00603883537714714,
    -0.002686248422056019,0.0012022027040575105,-0.0005395366843503451,0.00024205718514294644},{0.7077625542879105,
    3.71993250344609e-09,-0.3270111942290291,0.13135659921313142,-0.055726069806957906,0.023374953844976232,
    -0.00975990366310442,0.004136994960603407,-0.0017380219914194344,0.0007363983798756963,-0.0003127610598745869,
    0.0001325579402214651},{0.6688351929187775,-3.385418401100033e-09,-0.29661278731880436,0.11247421175195856,
    -0.04541566223836286,0.018137294244500002,-0.0071555803974986025,0.00289324280166783,-0.0011502522548454378,
    0.00046257168662788606,-0.00018680746289959473,7.484082567091155e-05},{0.6334315240383148,-5.632512396801411e-09,
    -0.2704896300530073,0.09701385692320492,-0.037361151320281207,0.014271773217362277,-0.005317693254812103,
    0.002061989855605733,-0.0007772568555392994,0.0002968180701016848,-0.00011483404337125492,4.3353870425586544e-05},
    {0.6010665148496628,-1.361021103594216e-10,-0.2478821050064299,0.08424462567771789,-0.030981776572506683,
    0.011383024832065745,-0.003996995874896796,0.0014949376074677022,-0.000536009693696967,0.00019351884017559362,
    -7.273231415610679e-05,2.5636586994745176e-05},{0.5713397264480591,-1.3281318440336637e-09,-0.22818890850838727,
    0.073620702316181,-0.025860670104374185,0.009201684095486584,-0.0030325581138109384,0.0010998646673326027,
    -0.00037804648820891177,0.00012708488683071354,-4.763248539033641e-05,1.543669425223021e-05},{0.5439180880784988,
    -4.188532169439445e-09,-0.21092757377999227,0.06473017760319544,-0.02169372940645066,0.007540273467274219,
    -0.002319160363030037,0.0008175864090400734,-0.00027451355409830955,8.283173410681171e-05,-3.23343293049276e-05,
    9.598203476012796e-06},{0.5185229480266571,7.051842869009022e-10,-0.19570570289138972,0.05725946009339083,
    -0.01825623848113274,0.006264953068937839,-0.0017879106047793336,0.0006087783042310857,-0.00020782479805251565,
    5.238485362331625e-05,-2.2459379511874207e-05,6.595318186969548e-06},{0.4949202388525009,-3.440883720305716e-09,
    -0.1821997304996719,0.05096789133556161,-0.015381035725401303,0.005276798614378778,-0.001394431612793916,
    0.0004464897557365628,-0.00016660573799545154,3.145353307093261e-05,-1.4936759787601345e-05,5.761407297999392e-06},
    {0.47291284799575806,6.719014676785106e-10,-0.17013914349499595,0.045668999256740846,-0.01294444968612724,
    0.004499020573222104,-0.0011112063767838738,0.00031231895760868404,-0.00014218015707729206,1.8816075922920485e-05,
    -7.333244976221213e-06,6.630984750660759e-06},{0.45233481377363205,3.549292178748203e-09,-0.15929481915568264,
    0.04121596508291255,-0.010857550161145662,0.0038682958117050156,-0.0009217349410312473,0.0001952944113715187,
    -0.00012584929261812576,1.5585370009469974e-05,1.9383417869937203e-06,8.161348323727812e-06},{0.4330466762185097,
    -1.0233141904093544e-09,-0.1494706471924105,0.037489670125880954,-0.009060842296076198,0.0033296610483385955,
    -0.00081473043045879,9.273895222984278e-05,-0.00010721971667308204,2.364261707322168e-05,1.2340800166253822e-05,
    7.902358999435871e-06},{0.4149317145347595,-2.754425088383241e-09,-0.14049792399529104,0.034388370948579675,
    -0.007520562174113416,0.002835318309019006,-0.0007773347689532357,1.1664988035472506e-05,-7.49754611696029e-05,
    4.221140445967287e-05,1.9429368554597546e-05,2.2941461114823546e-06},{0.3978927731513977,-3.6669801237011893e-09,
    -0.1322321552753124,0.03181878842050121,-0.00622446812821003,0.002347889821807057,-0.0007879661042612525,
    -3.226036319450027e-05,-2.187604998980308e-05,6.320929963383574e-05,1.512420296361641e-05,-1.0092625093291196e-05},
    {0.3818493112921715,-7.735637431655423e-10,-0.12455185533992884,0.029689212400824783,-0.005174977802288167,
    0.0018474835641917092,-0.0008120539058185005,-2.1916253953493686e-05,4.668611929354017e-05,6.988881059913685e-05,
    -6.194645078915152e-06,-2.3100384635698508e-05},{0.36673454195261,-5.796215594844737e-10,-0.11735868964040398,
    0.027905893836444092,-0.004378460522325406,0.0013391561209038538,-0.0008059036021418656,4.725160333570078e-05,
    0.00010735857583817198,4.5565544027279424e-05,-3.705189188282281e-05,-2.2976345067324322e-05},{0.35249248892068863,
    -3.2602155887026993e-09,-0.11057796645903248,0.026374022737263636,-0.0038319770126066703,0.0008544989611012931,
    -0.0007315557018031793,0.00015399984811495472,0.0001275225917116297,-8.616341957615902e-06,-5.4560507257824144e-05,
    -2.0297550230575763e-06},{0.3390750363469124,2.2130030633752917e-10,-0.10415827039511,0.025003496270627437,
    -0.0035119599969695168,0.0004417316458003485,-0.000576817524392223,0.0002530237996395696,8.933904887330618e-05,
    -6.48111752888931e-05,-3.907004522039547e-05,2.570909146987364e-05},{0.32643916457891464,-2.3248497919957394e-10,
    -0.09806922409732519,0.023717633981212443,-0.003370696485652457,0.0001453947558013514,-0.0003658081342893817,
    0.00029791373835732127,9.519304416321069e-06,-8.708092963459896e-05,1.459116623316406e-06,3.448861486121378e-05},
    {0.31454454362392426,-2.1812469944623235e-09,-0.09229707317143224,0.02246119677535277,-0.0033435844545288023,
    -1.4216820989148354e-05,-0.00014847377105723042,0.0002700616468523601,-6.924723530292359e-05,-6.389835890840543e-05,
    3.586905409907448e-05,1.7364403510177256e-05},{0.30335182696580887,-9.16639489431204e-10,-0.08683874943287133,
    0.021204058348870108,-0.003364031163304345,-4.9393351519740094e-05,2.557164424886308e-05,0.00018805910767370797,
    -0.00011028129920613426,-1.704632231690123e-05,4.202007665815519e-05,-6.5929007138748965e-06},{0.2928217127919197,
    2.002029428228241e-09,-0.08169574702983695,0.019939032378711204,-0.0033783446905712726,2.989935878785299e-06,
    0.00012978888288129827,9.050722187897298e-05,-0.0001061291557607778,2.2080846858230533e-05,2.5059839401239484e-05,
    -1.772739544092477e-05},{0.2829146981239319,2.3296759975707316e-09,-0.07686915321519933,0.0186752345386807,
    -0.003353896890826868,9.852512980765797e-05,0.00016589456449887167,1.0503493637855796e-05,-7.41056579456425e-05,
    3.7953943626046836e-05,3.9540006451951906e-06,-1.4299474385124102e-05},{0.2735913321375847,3.247622393443994e-09,
    -0.07235658617141225,0.017429995121616727,-0.003278870882640381,0.00020025826037591558,0.00015362780564653702,
    -3.774413560911099e-05,-3.682815782122752e-05,3.424165267152052e-05,-8.619854497892393e-06,-5.742503874587605e-06},
    {0.26481275260448456,2.5583322461771133e-09,-0.06815104018100264,0.016222034965963958,-0.0031564710143832434,
    0.00028545993623780376,0.00011667958203841457,-5.662717076144459e-05,-8.371101500368008e-06,2.216384816700094e-05,
    -1.1444791395717802e-05,5.617312627418094e-07},{0.25654125213623047,3.522290514575029e-10,-0.06424112894523858,
    0.015067188536136186,-0.0029977591290655764,0.00034487598975642696,7.354280191642069e-05,-5.6071404960282185e-05,
    7.67564773387679e-06,1.0424432591745503e-05,-8.90209415268498e-06,2.9385743308352105e-06},{0.248740766197443,
    1.228350131547581e-09,-0.060612077679588296,0.013976597917721434,-0.0028159396392087722,0.0003783695303360738,
    3.489727592033244e-05,-4.610029699352859e-05,1.3802286210239173e-05,2.5413355290393995e-06,-5.145432865436108e-06,
    2.815393228135027e-06},{0.24137723445892334,9.884702847934953e-10,-0.05724693482509155,0.012956614495546914,
    -0.0026229821768818987,0.00039034491278835894,4.9913459035654e-06,-3.3619133227049704e-05,1.4061377342056071e-05,
    -1.4703914170998085e-06,-2.2040173535153837e-06,1.8509112592408663e-06},{0.23441878706216812,9.512483093401426e-10,
    -0.054127683615189125,0.012009574206457933,-0.0024282260350164827,0.0003865140368098657,-1.5824572157517148e-05,
    -2.223446803569859e-05,1.1731225670947849e-05,-2.868963671927231e-06,-4.846312306565168e-07,9.451060731073319e-07},
    {0.22783582657575607,1.7552162370228213e-09,-0.05123611660429018,0.011134841841369102,-0.002238214905381181,
    0.0003721642152250973,-2.897330449961416e-05,-1.326223743081082e-05,8.773621176974383e-06,-2.9014737880489177e-06,
    2.967062189860875e-07,3.594976308819972e-07},{0.22160101309418678,9.811643536443027e-10,-0.04855445250750078,
    0.01032979251322461,-0.0020571078077771627,0.00035149913060062945,-3.634701034805805e-05,-6.791081394896002e-06,
    6.102920514862193e-06,-2.3965477975140816e-06,5.34567460031922e-07,5.9555230109562435e-08},{0.21568917855620384,
    -1.1420981644013493e-09,-0.04606573067900572,0.009590599021070336,-0.0018872545123291857,0.0003275689125609327,
    -3.96832027134761e-05,-2.4102747268308953e-06,4.012209972643789e-06,-1.7882012129891486e-06,5.203971954722015e-07,
    -6.102586319052045e-08},{0.2100772075355053,-6.360807614241605e-10,-0.04375403562902773,0.00891280666431683,
    -0.0017297333168320567,0.0003024476622103727,-4.035450389299453e-05,3.9985864407557205e-07,2.4997894416126067e-06,
    -1.2558467944033148e-06,4.1957290546736683e-07,-9.072610430185682e-08},{0.2047439105808735,-1.3054468338094352e-09,
    -0.0416046014652875,0.008291725904116755,-0.0015847799139512913,0.0002774707765509583,-3.935951617106157e-05,
    2.1019276638983778e-06,1.458743950606231e-06,-8.471097839994175e-07,3.0884889374433155e-07,-8.310854641592912e-08},
    {0.19966986402869225,-4.430469090111902e-10,-0.03960383643281216,0.007722686128090348,-0.001452101232077642,
    0.00025345008258834806,-3.7388193090881055e-05,3.054282218080705e-06,7.66819278842029e-07,-5.541518534142048e-07,
    2.1607166858395192e-07,-6.48045092330968e-08},{0.1948372758924961,-2.7696998613969044e-10,-0.03773929712942783,
    0.007201190494053068,-0.0013310931170555681,0.00023084203883277482,-3.490031054620412e-05,3.515106649231718e-06,
    3.2004768184328267e-07,-3.523984830132162e-07,1.466207103105546e-07,-4.6784218908341014e-08},{0.1902298368513584,
    7.396029668557114e-10,-0.03599963299435392,0.006723003412175409,-0.0012209857853831823,0.0002098695814093692,
    -3.219334101055081e-05,3.662773877761062e-06,4.001107114822457e-08,-2.168555396492396e-07,9.754230489922516e-08,
    -3.2415332102808104e-08},{0.18583259731531143,-1.3889839291900428e-09,-0.03437451487144206,0.00628419365726974,
    -0.001120938126356473,0.0001906065851659477,-2.9454086633562475e-05,3.6173569809511685e-06,-1.28942109087492e-07,
    -1.2733384966996315e-07,6.393198825384634e-08,-2.1957496479520104e-08},{0.18163182958960533,-1.1789173408931045e-09,
    -0.032854556614084894,0.005881149104077157,-0.0010300970319425662,0.00017303483752764213,-2.679549849133658e-05,
    3.4582620640763156e-06,-2.250168384572093e-07,-6.904242011984504e-08,4.131258066102202e-08,-1.4685750175493308e-08},
    {0.17761493101716042,3.0343342322415475e-10,-0.031431235384142664,0.00551057389716094,-0.0009476333497731134,
    0.00015708176680439816,-2.4282023135183814e-05,3.2372423291448653e-06,-2.739601116112937e-07,-3.165958216695364e-08,
    2.62427594388162e-08,-9.74593739439985e-09},{0.17377031594514847,4.4441335267727924e-10,-0.030096814077627557,
    0.005169475224975955,-0.0008727624649097703,0.000142645055658961,-2.1946710909752415e-05,2.987516379018077e-06,
    -2.9293854920294174e-07,-8.160138221141282e-09,1.6270604831068206e-08,-6.428439591830509e-09},{0.170087318867445,
    -1.6344366511005143e-09,-0.028844267848662054,0.004855144380172785,-0.0008047549230250147,0.0001296084535822502,
    -1.9802632795419384e-05,2.729987929038681e-06,-2.9331685388213384e-07,6.178541101898291e-09,9.71243223697714e-09,
    -4.212088812727082e-09},{0.16655610501766205,-3.731201781980079e-10,-0.02766721575565599,0.00456513511674232,
    -0.0007429407103853431,0.00011785173776362983,-1.7850442462915936e-05,2.477431643985892e-06,-2.8257140188877306e-07,
    1.4512951200776934e-08,5.432237184748236e-09,-2.7349012837204794e-09},{0.16316761076450348,-6.723330238638215e-10,
    -0.026559857949515455,0.004297241202479446,-0.0006867095866229069,0.00010725680968394897,-1.6083352831564145e-05,
    2.2372923167027767e-06,-2.655833089731888e-07,1.8947250256457596e-08,2.669185225763759e-09,-1.7519133908275735e-09},
    {0.15991345793008804,-1.2141509757055938e-09,-0.025516918447299745,0.004049474330488806,-0.0006355090476788922,
    9.771125717491022e-05,-1.4490386319737746e-05,2.0135512313901865e-06,-2.455050419136065e-07,2.088173259824974e-08,
    9.148012111864627e-10,-1.0991761509486981e-09},{0.15678589791059494,-7.721240286647694e-10,-0.02453359330833406,
    0.003820043071363061,-0.0005888409495109658,8.911026877090323e-05,-1.3058475076584742e-05,1.80796830985608e-06,
    -2.2433971861036733e-07,2.1246293354048656e-08,-1.7082408650966705e-10,-6.673211612244723e-10},{0.15377775579690933,
    1.6347451772464479e-09,-0.023605503901408906,0.0036073332341223664,-0.0005462574588411444,8.135749063149322e-05,
    -1.1773796535668799e-05,1.6209070374860123e-06,-2.033283660904394e-07,2.0656227133626395e-08,-8.151450172424217e-10,
    -3.833482314435657e-10},{0.15088238567113876,9.549718914353761e-10,-0.022728654886730336,0.0034098898026633786,
    -0.0005073567549588087,7.4365218072992e-05,-1.0622601895974873e-05,1.451880366973168e-06,-1.8320903800335006e-07,
    1.951622209769635e-08,-1.1704831913456508e-09,-1.9842287213620054e-10},{0.14809361100196838,1.9715257848067777e-10,
    -0.02189939651170149,0.003226400487650532,-0.00047177874593142525,6.805418117556126e-05,-9.591709883002508e-06,
    1.2999098514608851e-06,-1.6439032421882748e-07,1.8089919379734425e-08,-1.3388364658296981e-09,
    -7.978883228757748e-11},{0.14540569484233856,-8.154678796396964e-10,-0.021114390820144994,0.003055680856296204,
    -0.00043920095650450217,6.235309520001518e-05,-8.668781189135832e-06,1.16375970490421e-06,-1.4706752946006e-07,
    1.6546562256911213e-08,-1.388407546479541e-09,-5.42041960466389e-12},{0.1428132988512516,-1.5151439232727511e-09,
    -0.020370581390133112,0.002896660957457227,-0.000409334675449484,5.719808713315854e-05,-7.842450857161689e-06,
    1.0420871587492353e-06,-1.3130035819002146e-07,1.4992357790970858e-08,-1.3646538944619322e-09,
    3.952006886409446e-11}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_loss_zero_overlap)

/* (1 - eps)/beta at zero force, beta < 16: 65 rows of degree 10 in y = sqrt(beta), nodes 0 + i 0.0625, 0 <= y <= 4.03125.
 * Relative error of the approximation: 2^-58.2 at most, proved for the whole cell of each row. Bits of the rows:
 * 66.2 62.2 64.4 62.2 59.2 62.4 62.0 61.1 60.6 61.0 59.2 61.1 59.9 59.5 58.8 58.5 58.2 59.6 59.7 60.6 58.8 58.6 58.9
 * 58.3 59.8 61.7 59.6 62.4 58.3 58.5 59.1 60.6 59.7 61.5 58.7 58.8 63.7 59.6 59.1 61.9 59.3 59.2 59.3 59.1 59.2 59.3
 * 60.5 59.2 61.2 59.4 59.6 59.0 58.8 58.7 59.7 62.5 61.0 60.4 60.0 59.5 62.8 61.3 59.8 60.1 61.7 */
#define COR_ROWS_LOSS_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_LOSS_ZERO_FORCE_STEP 0.0625
#define COR_ROWS_LOSS_ZERO_FORCE_PER_UNIT 16.0
#define COR_ROWS_LOSS_ZERO_FORCE_ROWS 65
#define COR_ROWS_LOSS_ZERO_FORCE_PLAIN_ROWS 4
#define COR_ROWS_LOSS_ZERO_FORCE_END 16.0
COR_ROWS(double, cor_rows_loss_zero_force, 65, 12)
#ifdef COR_ROWS_HERE
= {
    {1.1534488499164581,8.178830669247755e-09,5.095884097463012e-22,-0.7982665609447954,-0.2666666666666632,
    0.5228825680869991,0.4613795435323541,-0.34874271036297394,-0.4523485037580892,0.14631719611892938,
    0.3708176297850917,-0.002677827174839716},{1.1502739191055298,2.1976786180220323e-09,-0.10236467126377537,
    -0.8349736721060427,-0.11985814334837726,0.6429650027253425,0.2962053636911942,-0.5230814702270473,
    -0.32766595483707067,0.34866225945493096,0.32775466297802947,-0.1735047732744604},{1.1405953168869019,
    -4.64852734854976e-09,-0.2074935924664935,-0.841780086305197,0.049744703455313746,0.7024893156375446,
    0.07851901677413556,-0.6222575989573962,-0.11378616185705691,0.4906109432209999,0.1556436758746224,
    -0.36331481913582186},{1.124361664056778,-3.4860124289199713e-09,-0.31144473543139534,-0.8159405307594727,
    0.22536185936447342,0.6901318254039351,-0.15724604456080415,-0.616415681273945,0.14201978403876317,
    0.508596833931093,-0.09812425608417974,-0.42038350261388785},{1.1017744541168213,7.29527021798654e-09,
    -0.820275671119696,0.12448828271865209,0.528713197596222,0.15580188705507608,-1.0517760802018903,1.099595484129558,
    -1.457793475756762,3.6832750474544067,-8.106778937020017,15.612681554465032},{1.0732835829257965,
    1.0733526202141691e-08,-0.7996376744346367,0.20435467365126633,0.5111245688247263,-0.07366591598899783,
    -0.7195382048345785,0.66249756599105,-0.24623620773129362,0.6450723764921574,-1.7590748868383912,2.720188716461218},
    {1.039557546377182,-7.371843866026254e-09,-0.7696159426979284,0.2739692465276504,0.4592678056719475,
    -0.2282393943975076,-0.4889224738625882,0.5518634079206649,-0.03695976853804105,-0.07170560975856129,
    -0.44832254788168363,0.8405587790069655},{1.0014329254627228,5.6605634162476545e-09,-0.7317102743283623,
    0.33007743605844275,0.3851794602039269,-0.32350584445639513,-0.2954683666109242,0.4939343049427283,
    -0.07509804993810805,-0.2313431163070373,-0.014895981343114942,0.3762616249111308},{0.9598513543605804,
    3.461894031247466e-09,-0.6877341010346284,0.37093623365806616,0.299845624129688,-0.36827286469893133,
    -0.13155408847585046,0.4213063395536925,-0.15665996891638395,-0.20118918417495288,0.15750050458684714,
    0.146890208262225},{0.9157927483320236,-1.007823725863812e-09,-0.6396233858892171,0.39630585953699177,
    0.21278368408816428,-0.3720458062901695,-0.002062441054638868,0.3275513990788657,-0.21298781744010167,
    -0.10752894046405367,0.19867051075985098,-0.0033258657377875844},{0.8702140003442764,-2.613535837299077e-10,
    -0.589261312957961,0.40721748294265125,0.1313787203959405,-0.34580348934118316,0.08941040377344399,
    0.22551565102926566,-0.2267768764140026,-0.01235507744072948,0.16609820699096797,-0.08515320493899745},
    {0.8239992409944534,3.2259987656213115e-09,-0.5383415177120648,0.4056054618614567,0.06054140245901275,
    -0.3007479783729166,0.14419376353957664,0.13046268350887236,-0.20447782752696936,0.055204141894945824,
    0.10366658193389845,-0.10721441611636692},{0.777925044298172,7.078391182540326e-09,-0.48828058371656846,
    0.393902301313965,0.002794158053749651,-0.2468325752083012,0.1679605989631335,0.05299935152874128,
    -0.16129576771864473,0.0883429971824653,0.042449326085322245,-0.09071159073241077},{0.7326410263776779,
    -1.6535123441258273e-09,-0.44017921510936703,0.3746755076858642,-0.04131663346469643,-0.19179713513947128,
    0.16866384571865634,-0.0025918904417053645,-0.11215106978488731,0.09325126220951632,-0.0018156343640567786,
    -0.058937227934749134},{0.688663974404335,-6.4797506719216146e-09,-0.3948235986990238,0.3503524829608888,
    -0.07265276420474275,-0.1408646116907666,0.15448122493037933,-0.037167204038264214,-0.06745396536486639,
    0.08080276250059591,-0.02600109126464148,-0.02834246940939462},{0.646382600069046,-2.427979611280315e-09,
    -0.3527148030791147,0.3230469864899974,-0.09291342412899654,-0.0969568497467055,0.1324283986584761,
    -0.054565154926264015,-0.032390714818778574,0.061080288866875596,-0.034083263925512315,-0.006453677429631983},
    {0.6060694009065628,-4.136435998226962e-09,-0.3141139560660487,0.2944772241662438,-0.1041589886979805,
    -0.06119318557143144,0.10774170109857084,-0.05963632268912035,-0.008079015054813817,0.04102153734380028,
    -0.03219938347864861,0.005771568193118819},{0.5678964704275131,1.8615967287517619e-09,-0.2790930501982481,
    0.2659535964231323,-0.10846902837664181,-0.03346257511492264,0.08384621759384121,-0.056932299451548485,
    0.006760470507609002,0.024253770911517262,-0.025731109014814835,0.010567757640726563},{0.5319528877735138,
    6.178196247224212e-09,-0.24758421529440572,0.23841152490726103,-0.10773208888420889,-0.012935041592072162,
    0.06265180168355514,-0.05007115406467986,0.014383717367787539,0.011946101450894489,-0.018267912661104037,
    0.010863884442432742},{0.4982617124915123,-2.8164163113781726e-09,-0.21942321273829,0.21246794255704715,
    -0.10354229353552412,0.0015475287430280304,0.044963398552554164,-0.04159174976149642,0.017109174826435754,
    0.0038424964300749647,-0.011690938276454371,0.009047529201009662},{0.46679550409317017,-3.658574658277592e-10,
    -0.19438524543517352,0.18848560884984122,-0.09717099443474848,0.011209083662753395,0.030872686465596922,
    -0.03307893117462267,0.016868441850966417,-0.0009248867892614935,-0.006681600530230008,0.0066411875700509975},
    {0.43748990446329117,1.7247438514992983e-09,-0.17221279372998677,0.16663512219347842,-0.08958430697431355,
    0.01718582563555261,0.020070121531042758,-0.02539235782561715,0.015073573017064745,-0.003334632592991571,
    -0.0032461933506861937,0.004427012422547019},{0.4102548584342003,-3.1079083828313715e-09,-0.15263614699994715,
    0.14694918856350653,-0.08148402561898538,0.02045230328098015,0.012064262242266284,-0.018899322189268087,
    0.012654948050865509,-0.00423264530218208,-0.0010983196468474885,0.002698454593265574},{0.3849836736917496,
    -2.67913697699534e-09,-0.1353877589779021,0.12936702635016875,-0.07335667018148548,0.021799411301250786,
    0.006319870208588261,-0.01366615197865524,0.010166227987866315,-0.0042537929384753185,0.00011629078140496914,
    0.0014842309392362016},{0.3615601435303688,1.0332851584491323e-09,-0.1202116790616486,0.11376885301157941,
    -0.06552153615671327,0.021842331763132838,0.0023348812571804154,-0.009596617722217553,0.007897607212521177,
    -0.0038293766599342997,0.0007129682729969618,0.000699650951908413},{0.3398639187216759,1.5406347294494538e-10,
    -0.10686924139908718,0.1000015018920063,-0.05817308898362901,0.021043065046502538,-0.000323865188619919,
    -0.006522588929655031,0.005971101985902218,-0.003228334646700235,0.0009326317717473818,0.0002313764360212146},
    {0.31977444887161255,3.3597083646787375e-10,-0.09514202893444204,0.0878966698685545,-0.051415949339682174,
    0.019737882518559412,-0.002010126401979256,-0.004258100036131489,0.004410722150252704,-0.002603952483062135,
    0.0009420943655554806,-2.3468610511805243e-05},{0.3011738210916519,-6.061636970066803e-10,-0.08483293524101032,
    0.07728335743332089,-0.045292409228574235,0.018164244186205363,-0.003001586056096613,-0.0026281961801059403,
    0.003189530069883221,-0.0020337969644355866,0.0008482597466883577,-0.00014431146360757078},{0.2839486673474312,
    -8.866038383537451e-10,-0.07576595937766445,0.0679959186373189,-0.039803272534689335,0.01648453498826116,
    -0.0035096212722136146,-0.0014818216105375514,0.0022587822242606755,-0.0015494599842960097,0.0007148520808924494,
    -0.00018676793919669148},{0.26799140125513077,-1.975664072731112e-09,-0.0677852057096062,0.05987890914986276,
    -0.03492314280730753,0.014805684817086322,-0.003691113151397576,-0.0006954240224207181,0.001564554402035912,
    -0.0011567985918216044,0.0005768693639153852,-0.00018707342754836173},{0.2532009184360504,2.5471943508075114e-09,
    -0.06075342745012477,0.052789676401029315,-0.030611313199194985,0.01319468068318438,-0.0036599384814268005,
    -0.00017168188124883673,0.0010562807207341086,-0.000848758887838122,0.0004514246291536205,-0.00016740736866457985},
    {0.23948295414447784,2.555928939655851e-10,-0.0545503489823443,0.04659941215188977,-0.026819298596396007,
    0.011690431033944447,-0.0034970511214738333,0.00016394282070686327,0.0006904208877930351,-0.0006129769898254321,
    0.0003451927028162134,-0.00014050810430049735},{0.22675010189414024,-6.302118495078569e-10,-0.04907092414288535,
    0.04119319955895898,-0.0234958784911739,0.010312603555610969,-0.003258796935696794,0.0003672902461522294,
    0.0004314035963640821,-0.00043596059953035293,0.0002591993694043974,-0.00011314301138886535},{0.2149217091500759,
    1.4805398320735745e-09,-0.04422363091267593,0.03646943666415523,-0.020590340843056644,0.009068062830160855,
    -0.002983493738554852,0.00047943316399942025,0.00025118980094687775,-0.00030516446925927566,0.00019172961090175412,
    -8.850417892567258e-05},{0.20392362028360367,2.226599354829003e-10,-0.03992886275219148,0.03233890311699439,
    -0.018054456168059764,0.007955465726233861,-0.0026964844884027335,0.0005301014279594558,0.00012824609810028052,
    -0.00020984385118716435,0.00013999343612577792,-6.776361684595011e-05},{0.1936878189444542,6.298280729071514e-10,
    -0.03611744909522745,0.028723651307109004,-0.01584357652691897,0.006968477875720627,-0.0024139296773681863,
    0.0005404962170291631,4.636191277399415e-05,-0.00014124642966120224,0.00010101497631449135,-5.103262142524212e-05},
    {0.18415206298232079,3.9290913552270036e-10,-0.03272931896392558,0.02555584099633055,-0.013917147046227825,
    0.006097979026123063,-0.002145601033400018,0.0005255150075373668,-6.472858978378074e-06,-9.247975791111434e-05,
    7.205985055533635e-05,-3.792550335895882e-05},{0.17525947093963623,-1.2945426723450426e-09,-0.029712309694541784,
    0.02277659253619888,-0.012238835393014054,0.00533353999600969,-0.0018969072097932563,0.0004954628583036798,
    -3.903807985128407e-05,-5.824613736101448e-05,5.080237479740443e-05,-2.7873524999404917e-05},{0.16695810854434967,
    1.6419964996643529e-09,-0.027021115404001827,0.0203349032539557,-0.010776423123373494,0.004664383386784055,
    -0.0016703418403116628,0.0004573416506429252,-5.767724360355479e-05,-3.4547308847694584e-05,3.535570558079854e-05,
    -2.0287923603124496e-05},{0.15920061245560646,-1.3102519282719455e-09,-0.024616365631894056,0.01818665093346906,
    -0.009501557785530185,0.004079984223054036,-0.001466504695642177,0.00041580571851067066,-6.692396788910534e-05,
    -1.8408555761934195e-05,2.4236774718111006e-05,-1.463567474216505e-05},{0.15194376930594444,1.8720490090947792e-10,
    -0.02246382251404469,0.016293694699499022,-0.008389432260628594,0.0035704236572473647,-0.001284811874642583,
    0.00037386083498023746,-6.998394045920964e-05,-7.642252310814544e-06,1.6305919255917637e-05,-1.046727554210036e-05},
    {0.14514819160103798,-1.0763990948743766e-09,-0.02053368414018596,0.014623074935261526,-0.0074184348974745,
    0.003126576547433587,-0.0011239823011020248,0.00033336969240905823,-6.909872363390244e-05,-6.553357300770504e-07,
    1.0701977852746781e-05,-7.4198790794962935e-06},{0.1387779489159584,1.257451396124118e-10,-0.01879998190314366,
    0.01314630858861789,-0.006569798024599234,0.0027401898701595547,-0.0009823651358801273,0.0002954137271290554,
    -6.581640378117377e-05,3.7022595253399644e-06,6.7826271705109e-06,-5.2090744195672074e-06},{0.13280027359724045,
    1.7653274385846825e-09,-0.017240060307825426,0.011838773247799469,-0.00582726147417866,0.00240389159557425,
    -0.0008581552990257588,0.00026054961554574925,-6.119060862852025e-05,6.254127201195618e-06,4.07370232374405e-06,
    -3.6165467571179685e-06},{0.12718526646494865,-2.208488794073646e-10,-0.01583412863921343,0.010679171912861225,
    -0.005176760381612685,0.0021111572093717164,-0.0007495311874403678,0.00022898933957903733,-5.5925447733946304e-05,
    7.585427964768271e-06,2.228142466650824e-06,-2.477294413084031e-06},{0.12190561927855015,8.145363214456771e-10,
    -0.01456487493566351,0.009649069910305359,-0.004606141668829406,0.0018562522353513054,-0.0006547389614086787,
    0.00020072528849069104,-5.048019778440832e-05,8.10852845292531e-06,9.937595305912289e-07,-1.6680792485183033e-06},
    {0.11693639494478703,4.394639880664428e-10,-0.013417133779899589,0.008732495522465373,-0.0041049105085862615,
    0.001634162912431243,-0.0005721406678089677,0.00017561615792885122,-4.514435060464497e-05,8.111432235835478e-06,
    1.8848473188240315e-07,-1.097709780029597e-06},{0.1122547909617424,-3.4945796200900014e-11,-0.012377600446593187,
    0.007915596378537152,-0.003664006150542968,0.0014405228742734504,-0.0005002383231175212,0.00015344510716353346,
    -4.0091035797195055e-05,7.79321388009809e-06,-3.1833792281921703e-07,-6.992143630905434e-07},{0.10783994570374489,
    7.714629036107989e-10,-0.01143458489958834,0.007186344313943299,-0.003275605378376055,0.0012715407244136066,
    -0.000437682387387284,0.00013395844130155936,-3.5414782330067485e-05,7.289761994034146e-06,-6.199169911511968e-07,
    -4.237152412623187e-07},{0.10367276147007942,6.548875599190313e-10,-0.010577799997843841,0.006534282141350612,
    -0.002932951288424214,0.0011239313984245836,-0.00038327043207784356,0.00011689073872851648,-3.115801260843457e-05,
    6.6923680025709615e-06,-7.823410967318615e-07,-2.357323301949054e-07},{0.09973573498427868,-4.321892893464649e-11,
    -0.009798179041964271,0.005950306522797993,-0.0026302048459345734,0.0009948528711136015,-0.0003359399475735282,
    0.00010198063556449109,-2.732947834213701e-05,6.061075213926567e-06,-8.521588682806374e-07,-1.096347357148494e-07},
    {0.09601281210780144,-7.9214704027414e-10,-0.009087718474328037,0.005426481847906054,-0.0023623166561083124,
    0.0008818488965352168,-0.00029475793393765056,8.8980244244944e-05,-2.391696630003841e-05,5.434215308571296e-06,
    -8.61908109960297e-07,-2.699029616159512e-08},{0.09248925372958183,-1.0363344591476792e-10,-0.008439342140653294,
    0.004955880685942135,-0.0021249164968781004,0.000782797916624961,-0.0002589090123730413,7.766029674475155e-05,
    -2.0895952865630653e-05,4.83518589121366e-06,-8.341282285053005e-07,2.5397286562935752e-08},{0.0891515202820301,
    -4.2903960640485946e-10,-0.007846784036705112,0.004532446979232189,-0.0019142183409279734,0.0006958679383963578,
    -0.00022768316994105725,6.781246995324962e-05,-1.8235411866487026e-05,4.277241149035425e-06,-7.842589062222567e-07,
    5.6932195235903774e-08},{0.0859871543943882,5.252382696999329e-10,-0.0073044869088705455,0.004150878679067555,
    -0.0017269388082759333,0.0006194769885328183,-0.00020046382346081829,5.9249901169863234e-05,-1.5901635641317592e-05,
    3.766857884177795e-06,-7.227256514551163e-07,7.428261785842243e-08},{0.08298469334840775,-7.431585227619363e-10,
    -0.0068075144597109895,0.003806526994359758,-0.0015602272139436744,0.0005522586583606324,-0.00017671660085147878,
    5.180658413001061e-05,-1.3860680489685994e-05,3.306084353008133e-06,-6.564345284484674e-07,8.214984581192028e-08},
    {0.08013356663286686,3.602931923160837e-10,-0.0063514752371773954,0.0034953098319114723,-0.001411605593310613,
    0.00049303221758635,-0.0001559790472759506,4.533611286991963e-05,-1.2079868771267007e-05,2.8941658814936495e-06,
    -5.898393199651442e-07,8.382623105676536e-08},{0.07742403261363506,-1.1292036122238802e-10,-0.005932456566178737,
    0.0032136373606483676,-0.0012789172923729957,0.0004407767786565757,-0.0001378513394045022,3.971008493419124e-05,
    -1.0528651854559549e-05,2.5286585568122144e-06,-5.257003580865493e-07,8.159862772465363e-08},{0.07484709098935127,
    6.422390394280642e-10,-0.005546967120157187,0.00295834793633371,-0.001160282897053058,0.0003946090195647915,
    -0.00012198801288601215,3.4816367361000676e-05,-9.179046779225731e-06,2.2061823436078666e-06,-4.656217242255367e-07,
    7.703923097165011e-08},{0.07239442877471447,8.979433665872673e-10,-0.00519188693404067,0.002726652883997709,
    -0.00105406244328186,0.0003537640110577488,-0.00010809066093920666,3.0557354524513505e-05,-8.005794602717961e-06,
    1.9229216654505304e-06,-4.1042963126808343e-07,7.121464078010882e-08},{0.07005835510790348,5.268177008355109e-10,
    -0.004864423833497966,0.0025160888580947425,-0.0009588229977795213,0.00031757873777000394,-9.590153557510243e-05,
    2.684829626043333e-05,-6.986342474764507e-06,1.6749503119912754e-06,-3.604373522376269e-07,6.483571277498888e-08},
    {0.0678317490965128,-2.897751794252814e-10,-0.004562075403231294,0.0023244766903442985,-0.0008733108291956232,
    0.000285477947594963,-8.519797021652632e-05,2.361574062624204e-05,-6.100719115835659e-06,1.458435150718123e-06,
    -3.156293679531317e-07,5.836464350531311e-08},{0.06570800952613354,8.310847641888762e-10,-0.004282595742919455,
    0.002149885796892127,-0.0007964275019818149,0.0002569620070078425,-7.5787538498475e-05,2.0796113103903954e-05,
    -5.331350672429877e-06,1.269757100948764e-06,-2.757882053496181e-07,5.209124180696146e-08},{0.06368101947009563,
    4.512914595282318e-12,-0.00402396636664548,0.0019906033538958784,-0.0007272093227114458,0.00023159648062589337,
    -6.750386548183246e-05,1.8334439473611366e-05,-4.66284808535237e-06,1.1055763904401598e-06,-2.405807869103902e-07,
    4.6187047966124364e-08},{0.06174509320408106,3.8684744604454885e-10,-0.0037843706930064686,0.001845107567435595,
    -0.0006648096522555385,0.00020900319028900792,-6.0203012148408553e-05,1.6183210463503857e-05,-4.081786133734834e-06,
    9.62860972962547e-07,-2.096163150930209e-07,4.074356399240253e-08}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_loss_zero_force)

/* duration at zero overlap, beta < 8: 65 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 8.0625.
 * Relative error of the approximation: 2^-58.2 at most, proved for the whole cell of each row. Bits of the rows:
 * 62.4 60.7 60.8 61.6 61.4 59.9 60.4 61.5 61.0 59.5 59.8 59.9 61.0 61.9 60.3 60.2 58.4 60.5 60.4 59.1 59.4 59.0 60.4
 * 58.2 58.3 58.2 58.6 58.4 58.6 58.9 60.6 59.5 59.0 60.0 60.3 60.6 62.8 59.1 60.0 61.2 60.3 59.8 63.1 64.0 62.1 60.9
 * 62.6 60.2 61.0 60.6 60.2 60.9 62.1 60.2 63.2 63.4 65.1 61.2 59.9 60.1 59.5 59.6 62.1 60.9 65.6 */
#define COR_ROWS_DURATION_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_DURATION_ZERO_OVERLAP_STEP 0.125
#define COR_ROWS_DURATION_ZERO_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_DURATION_ZERO_OVERLAP_ROWS 65
#define COR_ROWS_DURATION_ZERO_OVERLAP_END 8.0
COR_ROWS(double, cor_rows_duration_zero_overlap, 65, 12)
#ifdef COR_ROWS_HERE
= {
    {3.218065459719043,7.568990114909211e-17,0.3711873929788821,0.20971797419914343,0.005800778358233057,
    0.027062321807883427,-0.007641375170811449,0.006407578914849307,-0.003539256687723842,0.0022744236128864007,
    -0.0014212086267387152,0.0007578532904085254},{3.267758453530398,2.3947196756642732e-17,0.42409198127721137,
    0.21430253075462072,0.018361502210958967,0.023580298893061753,-0.003786285973911498,0.004109894383260624,
    -0.0018983503159312593,0.0011487479235855018,-0.000673200268764217,0.0003928048161971324},{3.3241599467393343,
    -3.479676037761449e-17,0.4787086144376803,0.2233387426353032,0.029706134412483366,0.022064688535178872,
    -0.001219115293743625,0.002858517663435139,-0.0010513323907320917,0.0006073460898139841,-0.00033710253264991976,
    0.00017538305081688833},{3.3875515713108104,1.8521003158434203e-16,0.5361071648335622,0.23653315071320558,
    0.040651608524674046,0.0219100506804768,0.0006370789040769042,0.002156889741375667,-0.0005990081519961076,
    0.0003254015421905663,-0.00018520917402201545,7.971000469380176e-05},{3.458345571603711,-1.6060621152131397e-16,
    0.5973183267073097,0.25385156076858445,0.05178581348939517,0.022777705724687593,0.0020886407180416193,
    0.0017482989382077794,-0.0003621725239290084,0.0001607633644509082,-0.00011773433203007064,3.324884687030698e-05},
    {3.5370835684549418,-6.127006378812324e-17,0.6633894883474922,0.2754536300930528,0.06356645341444271,
    0.02447042442687032,0.0032952114700964615,0.0014838428655048136,-0.0002614807889819104,4.506122860216521e-05,
    -9.369661557614497e-05,7.299568156072675e-06},{3.6244414510222156,2.723277173767841e-17,0.7354280358798765,
    0.3016547816528724,0.07637231800220855,0.02686024651944559,0.004324376825061905,0.0012595876589683182,
    -0.00026845640436812935,-5.947246808900121e-05,-9.6003722441562e-05,-1.0121828643401697e-05},{3.7212391704736705,
    -1.4172525229552933e-16,0.8146370313453278,0.33290144217178436,0.09052490079032101,0.02983845143769093,
    0.005171428748606142,0.0009822668723365893,-0.0003850927709959411,-0.00017783120429752333,-0.00011741453885742908,
    -2.361442324619854e-05},{3.828454637022218,-1.10778938873478e-16,0.9023453411260943,0.3697499685573228,
    0.10628689851937266,0.0332709779820407,0.0057585144401418355,0.0005469332767892385,-0.0006351091199125999,
    -0.0003289810169704068,-0.00015341770117644905,-3.30732251837227e-05},{3.94724103981639,-2.1995546084879699e-16,
    1.0000320724330591,0.41284073871843796,0.12383747971251968,0.036948582232299076,0.0059193579909264694,
    -0.00017962393303643494,-0.0010583694132611215,-0.0005256496488066348,-0.00019627764637372445,
    -3.316560018454883e-05},{4.078946755562286,-1.5332851119704147e-16,1.10934296228713,0.4628579399751475,
    0.14321964720614036,0.04052396855303162,0.005373589001398239,-0.0013694613594108064,-0.0017014930392136335,
    -0.0007665384692616787,-0.00022706474241729604,-1.0774042415745943e-05},{4.225136558486866,-1.6415700441273357e-16,
    1.2320937220677506,0.5204631912946157,0.1642518379095843,0.04343120353925846,0.0036973335190903425,
    -0.003230989906629514,-0.002595525364564409,-0.001017501988278093,-0.00020386506793584406,5.817904394153229e-05},
    {4.3876120180100715,2.255646000231093e-16,1.3702519795117032,0.5861879117540993,0.18639495861621075,
    0.04478922906677769,0.00030544448167748456,-0.005976628369610974,-0.003707508129807661,-0.001177698600472101,
    -4.768683855752897e-05,0.00020805293905525298},{4.568427673778289,-1.997293280565372e-16,1.525885311988252,
    0.6602665880668055,0.20857014148243005,0.04330579245294831,-0.005521997011180426,-0.009731087136669129,
    -0.004851010760386364,-0.0010329187691475127,0.00036276674748787725,0.0004664486736864125},{4.769897731465498,
    -2.1673947982090267e-17,1.7010583551107308,0.7423936097065361,0.2289370329476713,0.0372263542155104,
    -0.01450992504087448,-0.014341176566122925,-0.0055524244835302985,-0.000221310612583995,0.0011559659283064256,
    0.000805705812886772},{4.99458565694743,3.2599670531741685e-16,1.8976585251619453,0.8313954918889923,
    0.24467542694916597,0.02441821399526282,-0.02706980916672596,-0.019062578392551235,-0.0049180213983505494,
    0.0017122558068295868,0.002332503307533622,0.0010279607800700566},{5.245266469277041,3.789247779558947e-17,
    2.117130667940417,0.9248365419718654,0.2518719524571015,0.0027346492107690034,-0.04271359507264345,
    -0.022182033252801058,-0.0016581956742078143,0.005027839931013493,0.0034827994157843444,0.0006621658814659418},
    {5.524849590186315,2.008148630436076e-16,2.360111440195684,1.0186289502852568,0.24569436420366428,
    -0.02917385990835812,-0.059233207869236984,-0.020837931550458343,0.00542146645425181,0.009136476006069694,
    0.003468181642560228,-0.0009287007892936338},{5.836250462849831,-6.641437689616487e-17,2.625981740009815,
    1.1068005850225546,0.22110124946577117,-0.07053938652214567,-0.07198659827462112,-0.011598844555952366,
    0.016149410693844034,0.011784699329707403,0.0005924612481970422,-0.0038119613029660004},{6.182204323641063,
    1.3550414210335154e-16,2.912405396511145,1.1816636293583032,0.17428866178807395,-0.11694517468109568,
    -0.07411210556953945,0.0075619751808874355,0.027211475309570132,0.009114003196478412,-0.005881944072557779,
    -0.006183886623709211},{6.565028129481946,-2.0165465492614148e-16,3.2149891242288016,1.234656752954275,
    0.10477730260794023,-0.15950458642196347,-0.05874376165616224,0.03407633393224628,0.03157121461765199,
    -0.0017720360348671938,-0.013057066844013409,-0.004284926550864349},{6.98635733551643,1.9486568381724828e-16,
    3.5272539787987562,1.2579919478402661,0.0174397492675824,-0.18615800395081894,-0.023449146756647714,
    0.05862050357964315,0.021799694260457192,-0.01795857401546998,-0.013918796691890592,0.0037189527340179057},
    {7.44690833756311,2.625871380798824e-16,3.8410977103486825,1.2468480499999264,-0.07686192963154438,
    -0.18594089893286214,0.02531604760353995,0.0678350754308033,-0.002583165242931433,-0.028820405378614803,
    -0.003453556287142991,0.01225284229791761},{7.946333063845376,3.129831500140977e-16,4.147797301135258,
    1.201330981186522,-0.16329865059013454,-0.15489176202539004,0.07218446236600848,0.05305853813459905,
    -0.030309752073668622,-0.02354697117247369,0.01264776967831189,0.011414178500902922},{8.483224154565224,
    6.771083850348745e-16,4.4393622698200135,1.1271553499477147,-0.2276876828281575,-0.09975822798867068,
    0.0999250580333149,0.018814682935082937,-0.044570317365898816,-0.003475377410541422,0.020467462951199444,
    7.55170208303624e-05},{9.055290283029171,-6.059073490961272e-16,4.709823117436575,1.0344121118419516,
    -0.2615988503057282,-0.03592395313506806,0.09964774462299847,-0.01845909183868374,-0.037201762498183376,
    0.01682104759341281,0.013261926093085583,-0.010339174395998301},{9.659664110149789,1.446459870517907e-16,
    4.95600038085452,0.934801472429634,-0.2649974292319934,0.019816243319985237,0.07576039954039387,
    -0.04204105694848473,-0.015535069931398311,0.023810600577613986,-0.0008418127991451367,-0.01042876439099158},
    {10.293259841255155,7.848578699476398e-16,5.177518266670655,0.8386034915757657,-0.24498686579546686,
    0.05664698792755139,0.04163657045391798,-0.04583587581283978,0.005690290142172061,0.01695993010938749,
    -0.009726055612648932,-0.0033300490093896985},{10.953089243449927,-7.81327898893384e-16,5.376170579126272,
    0.7526947140854757,-0.21187378343500315,0.07256648155262856,0.010664888885407944,-0.03513673103674285,
    0.01679212219465521,0.005268135739199296,-0.009711334103433503,0.0026717568647379483},{11.636475520873164,
    -7.625475595139322e-16,5.554986648120023,0.6801359423467817,-0.1751471341835511,0.07219987795223663,
    -0.009876408470006611,-0.019567912009431095,0.017377967273711662,-0.0031936724868211115,-0.005016150872465533,
    0.004130048222702997},{12.34115115067703,-6.126246236534604e-16,5.717359483656663,0.6209706678595366,
    -0.1412130950589492,0.0625582107840297,-0.019322940405863707,-0.006378685755969548,0.012278748039882782,
    -0.006170319200349744,-0.0006064065988591996,0.0026841799842874476},{13.065262610456793,3.5799353930406714e-16,
    5.866447071472787,0.5734870352718072,-0.11310804127970839,0.04971993010217062,-0.02075298661071398,
    0.0016859592121658419,0.006289687026258906,-0.005404656479211728,0.0015571325101292422,0.0008556845093852554},
    {13.807319829618585,-3.6618600155850474e-16,6.00488045151102,0.5353370879753399,-0.09137982347809144,
    0.03748860258751116,-0.01796285796075872,0.005111749064831362,0.0018882338642082833,-0.003344663745159505,
    0.0018677621123550329,-0.00021223909958875334},{14.566124676361783,-2.5643537141229786e-17,6.134703221305513,
    0.5042529776257302,-0.07523153868587548,0.027538764588956655,-0.013820042246168689,0.005591478278088923,
    -0.0004827328499680464,-0.0014979586374747542,0.0013469492604558206,-0.0005252506452666693},{15.34070091779823,
    -7.392052252441039e-16,6.257439269674595,0.47837301604474824,-0.06340940431435048,0.02015789896987285,
    -0.009911284281652681,0.0047077628172779926,-0.0013457648758107843,-0.0003473746399978157,0.0007168422947877703,
    -0.00044731345136474226},{16.13023619458532,-4.502005999224081e-16,6.37420641781668,0.45630706460181064,
    -0.05470708415531347,0.014971209252349444,-0.006841239838545875,0.003474491791898908,-0.0013852386535964747,
    0.00018437119274787738,0.00026877971452808847,-0.0002680875554046295},{16.934038403831728,5.465863660312987e-16,
    6.485828000883627,0.4370737007779268,-0.04816615093965415,0.011419058937950914,-0.004663350456543042,
    0.0023749416964548805,-0.0011035001797844444,0.0003349940163158896,3.1862857162581684e-05,-0.00012071734116036465},
    {17.751504760098896,1.5084187920256897e-15,6.592922563268938,0.41999887600987107,-0.043101351783821185,
    0.008991417743835429,-0.003207423070742597,0.0015559451890359464,-0.0007731848301509493,0.0003088703801737955,
    -5.917661398071871e-05,-3.451305734635738e-05},{18.582100483489747,-3.6365564196139005e-16,6.695968501946271,
    0.4046214039465928,-0.03905212327142052,0.007303626614474446,-0.0022624124319438554,0.0010035293375199158,
    -0.000502958618065826,0.00022889343384719982,-7.454746792472095e-05,3.813512131160694e-06},{19.425344199661474,
    -1.3424634688578835e-15,6.795347753658372,0.39062076085829167,-0.035718541682110694,0.006094068904187723,
    -0.0016520078774830754,0.0006517077416496986,-0.00031417623852056966,0.00015132215275778042,-6.0911419054487664e-05,
    1.5029888594402569e-05},{20.280797795219804,8.13029390395065e-16,6.891374342021275,0.377767561345693,
    -0.03290662077782558,0.005195195180322165,-0.0012515212618544234,0.00043380099769777794,-0.00019350865072179462,
    9.362991433074951e-05,-4.180009528635987e-05,1.4485911038754227e-05},{21.148059167107416,-9.913054840763172e-16,
    6.984312868835077,0.3658916582619084,-0.030489134120280377,0.004502889058677452,-0.0009806029383854578,
    0.00029929674818908095,-0.00012019181896392246,5.596109364039546e-05,-2.605483607492775e-05,1.054270234136049e-05},
    {22.02675685428215,-4.678305213094352e-16,7.074390638828034,0.35486225100262647,-0.02838015668059254,
    0.003952807917793471,-0.0007901724120657815,0.00021484028644597753,-7.663914283323479e-05,3.314377276407013e-05,
    -1.5365949129251595e-05,6.705182745955846e-06},{22.916545918525774,1.3500837271480013e-15,7.161805835890835,
    0.3445755758814713,-0.02651942775211651,0.003504576772578418,-0.0006509888369972347,0.00016007553246568653,
    -5.073711954973446e-05,1.9880314982364057e-05,-8.826912444892774e-06,3.947147401283539e-06},{23.81710468195848,
    -2.736144394992379e-16,7.246733244554516,0.334947185601498,-0.024863005603870576,0.003132066882867803,
    -0.0005456492716005475,0.00012311388803788829,-3.5006024852946175e-05,1.2283385320168565e-05,-5.060623248130959e-06,
    2.22619952770704e-06},{24.728132075211516,-4.1674350668388546e-17,7.329328412416328,0.3259069622110933,
    -0.023377700356950127,0.0028176900528766873,-0.0004635965576841746,9.713062061067148e-05,-2.5111396545390248e-05,
    7.8974951431242e-06,-2.956020277672204e-06,1.2355556653195615e-06},{25.64934543760086,7.015497216863897e-16,
    7.409730787697872,0.31739576880524706,-0.02203770008598633,0.002549115124242513,-0.00039820662944554453,
    7.81856477607098e-05,-1.8622549252885597e-05,5.2977847146386854e-06,-1.7863518990427945e-06,6.904949653699331e-07},
    {26.580478663047632,2.3479245302733066e-16,7.488066155415729,0.30936310826942576,-0.020822458792023664,
    0.0023173719061896237,-0.000345148502532583,6.394776148338983e-05,-1.4186951750830858e-05,3.6963051003712346e-06,
    -1.125894510045759e-06,3.9597747417559805e-07},{27.5212806176454,-6.812207730424978e-16,7.564448574215248,
    0.3017654241251538,-0.019715319581615598,0.002115731177129528,-0.0003014702911384456,5.298513155751283e-05,
    -1.104153977022318e-05,2.6662398045732613e-06,-7.407288252092593e-07,2.3601918111030398e-07},{28.471513775223503,
    -1.5719213421254633e-15,7.638981945202061,0.29456482822212654,-0.018702579011280963,0.001939018739356913,
    -0.00026508391461809344,4.437986581328514e-05,-8.742373025039807e-06,1.9757444823996066e-06,-5.065275360130162e-07,
    1.4698434584310485e-07},{29.43095303080887,-1.5625148133618421e-15,7.7117613017616025,0.28772812380342844,
    -0.017772826895348034,0.0017831771302929359,-0.00023446602674192954,3.7518555712897224e-05,-7.020376062491731e-06,
    1.4960062778581036e-06,-3.577432760249447e-07,9.550304220095972e-08},{30.39938466124147,9.751113439892607e-16,
    7.782873882997569,0.28122604021086395,-0.016916465619569016,0.0016449736306856848,-0.0002084773548731716,
    3.19761023620272e-05,-5.7051718761512895e-06,1.1527748420021343e-06,-2.5934145611567435e-07,6.43924420062616e-08},
    {31.37660540888454,4.174790422249693e-16,7.852400036298817,0.27503262362062664,-0.016125351184135488,
    0.0015217984339535948,-0.00018624870996581226,2.7448962776789146e-05,-4.684404261462628e-06,9.013408833504686e-07,
    -1.9200642739112487e-07,4.476001962403734e-08},{32.362421669290924,-1.6420749259284948e-15,7.920413982967407,
    0.269124745471751,-0.015392519649513854,0.00141152081792878,-0.00016710605197655672,2.3715105640782616e-05,
    -3.881368132710856e-06,7.135863360216773e-07,-1.4463552771825896e-07,3.188904637751003e-08},{33.356648767393466,
    -2.4387782801569696e-15,7.986984472737652,0.2634817013234681,-0.01471197518090882,0.0013123840990109075,
    -0.0001505194627989327,2.0608918476745343e-05,-3.242196742679003e-06,5.711296276718784e-07,-1.1055426006945469e-07,
    2.3179687974188282e-08},{34.359110309632214,-1.5898775701271109e-15,8.05217534718226,0.2580848802601078,
    -0.014078523523988142,0.0012229273688555984,-0.00013606738235309878,1.8004854293965405e-05,-2.728187689669587e-06,
    4.6156035938948755e-07,-8.557823833290924e-08,1.7133249636331455e-08},{35.36963760164902,-1.8217587241371e-15,
    8.116046027704943,0.2529174900485912,-0.013487639603249965,0.0011419262176273,-0.0001234109509894855,
    1.5806417374415415e-05,-2.311007926766457e-06,3.7627735119444595e-07,-6.698810192193481e-08,1.2846736185042547e-08},
    {36.38806912293164,-3.038373749564075e-15,8.178651940595062,0.24796432685298875,-0.012935361142427746,
    0.001068347206193674,-0.00011227524767653318,1.393854390968551e-05,-1.969586016683914e-06,3.091909218737012e-07,
    -5.296366305107031e-08,9.754335877156897e-09},{37.4142500511887,6.867127256270132e-17,8.240044889163341,
    0.24321158091359488,-0.01241820239039124,0.001001312470912596,-0.00010243534933742332,1.2342215117584207e-05,
    -1.6880363441949646e-06,2.559123274437242e-07,-4.2257011160633875e-08,7.489751406113635e-09},{38.448031830365615,
    1.9148747056416396e-15,8.300273381081025,0.2386466715142895,-0.01193308356040098,0.0009400719079836219,
    -9.3705828807815e-05,1.0970579310619701e-05,-1.4542382532270406e-06,2.1323033170284038e-07,-3.399548854035396e-08,
    5.80945708075139e-09},{39.48927177713056,2.0761129537057593e-15,8.359382917563222,0.2342581059942358,
    -0.01147727267641907,0.0008839811015693113,-8.593274675867416e-05,9.78611696435431e-06,-1.2588436838560954e-06,
    1.7876388487954266e-07,-2.755855168800578e-08,4.547980155281721e-09},{40.53783272141391,-2.8244753479492225e-15,
    8.417416249868003,0.23003535864460023,-0.011048337306913649,0.0008324836548689233,-7.898747871996186e-05,
    8.758540253018882e-06,-1.094572209917732e-06,1.5072647477456319e-07,-2.2498479650011235e-08,3.5908094422708464e-09},
    {41.5935826772079,3.1884772660508138e-15,8.474413607651254,0.22596876616193523,-0.010644104245003318,
    0.0007850969314538316,-7.276190966707341e-05,7.863218060293286e-06,-9.5570282727278e-07,1.277632445480123e-07,
    -1.8488056871805585e-08,2.857443611291568e-09},{42.65639454035257,-1.444315381048608e-15,8.530412902969095,
    0.2220494369731555,-0.01026262562453089,0.0007414004629939579,-6.716465942075046e-05,7.079982193393029e-06,
    -8.377027863992025e-07,1.0883659701298466e-07,-1.5285348867192523e-08,2.2905001790813443e-09},{43.72614581046862,
    2.1819388270974134e-15,8.585449913113663,0.21826917224978773,-0.00990215028613815,0.0007010264598605673,
    -6.211809310463697e-05,6.392213580778477e-06,-7.369533254275635e-07,9.314471791295503e-08,-1.2709574625948478e-08,
    1.8485642760687124e-09}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_duration_zero_overlap)

/* duration at zero force, beta < 8: 46 rows of degree 10 in y = sqrt(beta), nodes 0 + i 0.0625, 0 <= y <= 2.84375.
 * Relative error of the approximation: 2^-60.3 at most, proved for the whole cell of each row. Bits of the rows:
 * 65.8 63.8 63.4 64.4 62.1 62.0 67.4 64.3 64.3 60.8 61.1 60.8 60.5 61.5 62.6 61.6 64.1 61.0 60.8 61.3 61.5 60.9 60.4
 * 61.3 61.2 62.9 63.0 60.7 60.3 61.0 63.7 60.4 61.5 61.6 61.2 61.0 61.8 61.9 61.0 60.9 61.9 62.1 62.8 61.2 62.1 63.5 */
#define COR_ROWS_DURATION_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_DURATION_ZERO_FORCE_STEP 0.0625
#define COR_ROWS_DURATION_ZERO_FORCE_PER_UNIT 16.0
#define COR_ROWS_DURATION_ZERO_FORCE_ROWS 46
#define COR_ROWS_DURATION_ZERO_FORCE_END 8.0
COR_ROWS(double, cor_rows_duration_zero_force, 46, 12)
#ifdef COR_ROWS_HERE
= {
    {3.218065459719043,7.568990114770008e-17,5.391434663781079e-23,-0.628812607021118,3.386523109346309e-16,
    0.20971797419900498,2.8742549294567634e-11,0.00580077493224243,-0.11428546595030235,0.02705120248506567,
    0.06621104940362217,-0.01206811593511054},{3.215612360442455,4.5680165036025014e-17,-0.07839678671661222,
    -0.6238982492243608,0.052398553296165294,0.2091179963209424,-0.006705617595622273,-0.03992479631323652,
    -0.09185703267939248,0.06159179324001191,0.05445196312153596,-0.029761403401054046},{3.2082914331378123,
    -9.575503489736129e-17,-0.1555665819600647,-0.6091995565102842,0.1041756596753046,0.20397016057071599,
    -0.028273752096932,-0.0723679064661002,-0.054437768169556956,0.08565846906528601,0.02866231840584274,
    -0.051628138424286915},{3.19621735038611,8.470280997875383e-17,-0.23029911971864608,-0.5849726050819112,
    0.1536860190148967,0.19052340915696392,-0.05866401230555269,-0.0864015882785592,-0.009187657110417876,
    0.09194835052888499,-0.007274869751927759,-0.06028441688840277},{3.179578973213065,-1.55664427714876e-16,
    -0.3014386005217044,-0.5518541147069554,0.19860336617421903,0.1671463926071221,-0.09058950625477316,
    -0.08070394907798568,0.034035151964689876,0.07763408657444623,-0.04227560516063361,-0.048258827319202266},
    {3.1586343270873694,-1.7488122752545814e-16,-0.3679371095673924,-0.5109373223915472,0.23647934003602603,
    0.13447652416361588,-0.11709219923676674,-0.05832989134742957,0.06566521581767058,0.04683551437238439,
    -0.0639891567885543,-0.01933455984044899},{3.133702080096631,-5.2492557074206424e-18,-0.4289109464049722,
    -0.46374348838538293,0.26527698573143516,0.09507069035730038,-0.13306552228338137,-0.025833738769608178,
    0.07974835276311347,0.00934965313753493,-0.06561292483966763,0.013529767645489153},{3.105149735354859,
    6.982955569714498e-17,-0.4836875918041072,-0.41210501002602834,0.2837634132665264,0.05265777347702069,
    -0.13620544262459053,0.008792439117745611,0.07578012078018843,-0.023664393556762725,-0.04920239323550864,
    0.036504834611047726},{3.0733794282471623,-1.422198654185613e-16,-0.5318342524760862,-0.3579942519017705,
    0.2916892409907915,0.011225575934235487,-0.12710088186451723,0.03847277548766701,0.05817695275314524,
    -0.04432135844663337,-0.023554145653250848,0.04274879318894824},{3.0388126381896243,-1.8850176632949116e-16,
    -0.5731637921699186,-0.30333983051152164,0.28974721599138104,-0.02579170874468989,-0.10854236475921114,
    0.05872902595677628,0.03392404173313936,-0.05036020153961875,0.0011426531310399408,0.034419885841160146},
    {3.0018752255833854,1.5166745571219952e-16,-0.6077189154264393,-0.2498676788291944,0.27936156392572653,
    -0.05603340740576693,-0.08441467073282742,0.068188267535211,0.009814811208386332,-0.044493671265294236,
    0.017988209582969556,0.019007159876318663},{2.962984019840396,1.9271179702025893e-16,-0.63573937441976,
    -0.19899102712253777,0.2623916779019112,-0.07837886613051723,-0.05860864540736196,0.06803645994420049,
    -0.009454104157716168,-0.031926855152064136,0.025023361539568453,0.004058977869250379},{2.92253581286056,
    -5.231364618764563e-17,-0.6576189792162918,-0.15175734662759494,0.24083314293158561,-0.09281940199273257,
    -0.034258327454885336,0.060927601813687775,-0.021860793055029467,-0.017794108640661586,0.024099462841599903,
    -0.006059405170484998},{2.880899176241683,1.047175615112005e-16,-0.673859302772474,-0.10884674467870153,
    0.21657506703374635,-0.10015814656328582,-0.013402360191971054,0.049888519261914815,-0.027587893431723947,
    -0.005632012988466066,0.018649960877667324,-0.010517966718605309},{2.8384091237904743,-1.8875526130886172e-17,
    -0.6850257161759282,-0.0706082377168369,0.19124065129054846,-0.10166287340326252,0.0029990464484437756,
    0.03755082672347449,-0.028097598714112753,0.0029520689226967367,0.011857389496064527,-0.010673017139411201},
    {2.795364346455184,2.900670305928746e-17,-0.6917094925933367,-0.037117978911149985,0.16611064341655785,
    -0.09876107285424685,0.01483637171051893,0.02579092083095389,-0.02525512250738196,0.007847364776659836,
    0.005791628195951507,-0.008508970632195806},{2.7520265740390495,1.7426961214585166e-16,-0.6944978080052048,
    -0.0082453132336911,0.14211280991143652,-0.09282034779188077,0.02255272945260331,0.015693211264503924,
    -0.02074711754694256,0.009769021337609539,0.0013591627696436703,-0.005663030770039512},{2.708621554336377,
    4.930800124325154e-17,-0.6939519304683598,0.01628361491194531,0.11985476191489836,-0.08501984753395575,
    0.026870676806450684,0.0076961217183833764,-0.01581878556963764,0.009690892360069373,-0.001351916977401149,
    -0.003106669632270541},{2.6653411566973215,-2.0675717735097155e-16,-0.6905928700150928,0.036830792991004654,
    0.09967907589844383,-0.07629683404232393,0.028588306321711176,0.001798875822362943,-0.011240113199078555,
    0.008501310363752276,-0.002668709720474237,-0.0012283777070877311},{2.622346171452313,1.606309074177719e-16,
    -0.6848932283817385,0.05380240878467157,0.08172481897395684,-0.06734488502353375,0.028451694341275337,
    -0.0022467119003841607,-0.007391335975394845,0.006860257794884173,-0.0030354834104416167,-5.1805537805759104e-05},
    {2.5797694620585108,1.4962390690169534e-16,-0.6772738261001764,0.06761622752718416,0.0659854255442124,
    -0.05864156894995997,0.027090827459952452,-0.004792053613888298,-0.004384378162095134,0.005185492749999808,
    -0.0028508655206943897,0.0005654097254456036},{2.537719214274761,2.1106631932991677e-16,-0.6681037603457559,
    0.07867904641735149,0.05235779147305819,-0.050488730224216655,0.02499971321533782,-0.006199514694235101,
    -0.0021737134974238277,0.0036990729998309696,-0.002407943741860721,0.00080354383668128},{2.4962821050100623,
    1.434380400704792e-16,-0.6577027460241575,0.08737238052944248,0.040680914116574984,-0.04305447501243535,
    0.022542722150894614,-0.006792694418934316,-0.0006388063937168496,0.0024890493383511315,-0.001892883974389046,
    0.0008184765016048008},{2.4555262777413533,-3.5764837249839744e-17,-0.6463448335725255,0.0940444350018201,
    0.030764485650404357,-0.036410901041516563,0.0199736447433718,-0.006836169168672545,0.00036300602701371925,
    0.0015637635926586194,-0.0014078340489637707,0.0007223186878995406},{2.4155040606343734,-1.837317874484921e-17,
    -0.634262830455129,0.09900660437273097,0.02240887180472624,-0.030565082015977418,0.01745870126433917,
    -0.006532948573687804,0.0009671785359416075,0.0008913461515262575,-0.0009982466410308464,0.0005857052669577655},
    {2.376254399073405,2.019258998339199e-16,-0.6216529546155195,0.10253304796507777,0.015418242046205014,
    -0.025482924118003798,0.015098587581730076,-0.006030992378595821,0.001288670920140148,0.0004248362060339405,
    -0.0006758237964187051,0.0004478436814854695},{2.3378049985537848,-1.5352375927184028e-16,-0.6086794087938053,
    0.1048622201476078,0.009608559113738575,-0.02110660437396377,0.012947289019687305,-0.00543322985768676,
    0.0014183031025357929,0.00011626369039561798,-0.0004347593975904154,0.00032716844251070497},{2.300174189358983,
    -2.0298865930101783e-16,-0.5954786855866416,0.10619953350978964,0.004811893684912225,-0.017366734689496455,
    0.011027001748535626,-0.0048079335578790384,0.0014241675095764794,-7.663471683365562e-05,-0.00026193099376223766,
    0.00022983228462484904},{2.2633725334558576,5.078229277713784e-17,-0.5821634998469822,0.10672058003510526,
    0.0008782313130543543,-0.014190452666819342,0.009339354055636554,-0.0041979239016670545,0.0013551966259666589,
    -0.0001880921194653106,-0.0001426231458948032,0.00015553796776848235},{2.22740419852549,5.607254132435348e-17,
    -0.5688263043583225,0.10657452681004125,-0.0023243479502721128,-0.011506512759034115,0.007873490623088302,
    -0.0036280589292149467,0.0012452417831938804,-0.0002443174539457305,-6.333558524031674e-05,0.00010113709426344344},
    {2.1922681255023124,-1.3153367267344102e-16,-0.5555423833365768,0.10588744419244445,-0.004910481334802481,
    -0.009248255388189932,0.006611678062536088,-0.0031109873168295083,0.0011168472921286232,-0.0002645475694228052,
    -1.2870569328274344e-05,6.264173414619651e-05},{2.15795901553155,1.9029618737347456e-17,-0.5423725419271909,
    0.10476542462484058,-0.006978884580501264,-0.0073551304058568955,0.005533046634111898,-0.0026513818066771426,
    0.0009843966413492385,-0.0002624216230720202,1.7496378325514454e-05,3.623472300220765e-05},{2.1244681606637106,
    4.372183948999096e-17,-0.5293654230277284,0.10329741873802471,-0.008613966935368127,-0.005773273912000257,
    0.004615983614149406,-0.002248947189769738,0.0008565721147744035,-0.0002473136084554833,3.42705294457216e-05,
    1.866764255960215e-05},{2.091784140425214,-1.2118714252272772e-16,-0.5165594889201878,0.10155776032515426,
    -0.009887510310601033,-0.004455493766386896,0.0038395827907521892,-0.0019004916418233092,0.0007381933655848048,
    -0.00022547028536297223,4.2141326273531076e-05,7.375653386408349e-06},{2.0598934039917176,-1.2438430555527342e-16,
    -0.50398470684554,0.09960837991351901,-0.010860297383444607,-0.00336090895545278,0.003184453264692386,
    -0.0016013096582402951,0.0006315454053110911,-0.0002009148721832943,4.439528697487145e-05,4.2117224930182644e-07},
    {2.028780755268509,2.0942956885068783e-16,-0.49166397655462174,0.09750072320259144,-0.011583624037580812,
    -0.0024544068090465803,0.002633107010335609,-0.0013460745704068824,0.0005373108528609013,-0.00017613119609220874,
    4.327759127644796e-05,-3.609470932349099e-06},{1.9984297558822228,-6.132057655407706e-17,-0.4796143352232913,
    0.09527739940047521,-0.012100664863496707,-0.001706024122907469,0.002170079532210109,-0.0011293909639218268,
    0.0004552077546638044,-0.00015256386912426643,4.028361830606885e-05,-5.7201879557016214e-06},{1.9688230589803233,
    -2.6801754601489627e-17,-0.467847971716817,0.09297358821408651,-0.012447681608349748,-0.0010903179947308343,
    0.0017818893808834448,-0.0009461171402176618,0.00038441502165810054,-0.00013097407010746173,3.638212067978896e-05,
    -6.6077217372063294e-06},{1.9399426848496348,-7.685834671054624e-17,-0.4563730785323631,0.0906182348363272,
    -0.012655077281500936,-0.0005857649248912026,0.0014569071856589649,-0.0007915361050538421,0.0003238484746599289,
    -0.00011168681071771762,3.217998213995902e-05,-6.744996880494404e-06},{1.9117702477080678,-7.215538958115437e-17,
    -0.445194566144925,0.08823506101830352,-0.012748305851036834,-0.00017420874985119006,0.0011851801276125588,
    -0.0006614297107023426,0.0002723341010942913,-9.475916752484567e-05,2.80405552315006e-05,-6.448618290282742e-06},
    {1.8842871415853844,1.514291218294804e-17,-0.43431466110436406,0.08584341807020954,-0.01274865105807974,
    0.00015963354218611632,0.0009582407341860391,-0.0005520931700836815,0.00022871205492096448,-8.009237799403292e-05,
    2.4166844577527867e-05,-5.9219091043989085e-06},{1.8574746919721516,1.721295689790436e-17,-0.42373340616609106,
    0.08345900494874757,-0.012673889174890554,0.00042860617185979587,0.0007689173786092302,-0.00046031477100782684,
    0.00019189499354299664,-6.750481408111278e-05,2.0658818936171576e-05,-5.295013451476448e-06},{1.8313142788601982,
    -3.9116194318463834e-18,-0.4134490780176574,0.08109447180077914,-0.012538850448611449,0.0006434913259165371,
    0.000611156276285693,-0.0003833369806522576,0.0001608970364976733,-5.677824494958531e-05,1.755226079884708e-05,
    -4.647086277136262e-06},{1.8057874359012613,-8.618987547424262e-17,-0.4034585357872295,0.078759926641354,
    -0.012355893105859855,0.0008133327697924431,0.0004798598791095811,-0.0003188092179585656,0.0001348443890677751,
    -4.7686134349079276e-05,1.4844612106246163e-05,-4.024001722011376e-06},{1.780875929652129,5.377588695537071e-18,
    -0.39375751146807836,0.07646336035698068,-0.01213530253201118,0.000945711789112117,0.00037074351047117915,
    -0.0002647385949699081,0.0001129749881427352,-4.001009157521957e-05,1.2511853264684212e-05,-3.4501494738743803e-06},
    {1.7565618222350412,1.911543560616801e-17,-0.3843408516367248,0.07421100299139026,-0.01188562682576933,
    0.0010469811971657488,0.00028021024805685016,-0.00021944230162471018,9.463197969447758e-05,-3.3548664416030235e-05,
    1.0519278764674239e-05,-2.9363890108640313e-06}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_duration_zero_force)

/* largest overlap, beta < 8: 65 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 8.0625.
 * Relative error of the approximation: 2^-58.1 at most, proved for the whole cell of each row. Bits of the rows:
 * 58.1 58.9 61.3 59.7 60.3 59.1 58.6 62.5 60.5 59.6 61.0 61.1 61.8 61.5 63.8 59.3 61.1 60.3 62.3 63.3 60.5 61.9 63.6
 * 60.9 63.6 62.2 61.6 64.4 60.4 63.2 62.1 61.5 61.8 61.1 62.6 61.9 61.5 62.6 65.1 63.4 63.7 61.8 62.9 62.5 60.6 61.8
 * 61.5 63.2 61.3 60.5 61.3 62.3 61.7 64.8 63.3 63.1 63.6 61.3 62.0 61.8 61.8 61.6 61.8 64.1 62.6 */
#define COR_ROWS_MAX_OVERLAP_FIRST 0.0
#define COR_ROWS_MAX_OVERLAP_STEP 0.125
#define COR_ROWS_MAX_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_MAX_OVERLAP_ROWS 65
#define COR_ROWS_MAX_OVERLAP_END 8.0
COR_ROWS(double, cor_rows_max_overlap, 65, 12)
#ifdef COR_ROWS_HERE
= {
    {1.0933620739432781,-5.578485644756532e-17,-0.5044548942698284,0.2840430189018544,-0.1702207784972518,
    0.10550070905146688,-0.06684871358424503,0.043039475594734894,-0.02805046788300845,0.018446817390623246,
    -0.012051515494730856,0.006651813786872523},{1.0344347906430595,-1.0891199505058068e-16,-0.4406734205482286,
    0.22893669925358956,-0.12644595506924988,0.07216427739801341,-0.04207647437297391,0.024915386607083045,
    -0.014928915568325218,0.009029709669837018,-0.005524146873307458,0.003388851340318095},{0.9826972068301595,
    3.491272745044995e-17,-0.3888497841233495,0.1875456145935159,-0.09607873246122903,0.05082105369565738,
    -0.02744745665294962,0.015047788301548331,-0.008344892267636307,0.004670142929678531,-0.002641518807264236,
    0.0014987289761073629},{0.9368453538059688,-1.0246962480588107e-17,-0.3461009877683469,0.15579469652272135,
    -0.07443315787235935,0.03669352801645847,-0.018459842622045673,0.009423268428452283,-0.004864223445698483,
    0.002533233645918198,-0.0013325257964843383,0.0007032856541957357},{0.8958800740069703,-1.0969786215205918e-17,
    -0.3103756291506144,0.1309933779796003,-0.05864027214594094,0.02707088025334724,-0.012747468915482844,
    0.006088667430032664,-0.00293990560500768,0.0014318350660328563,-0.0007039777338577633,0.0003473453918327987},
    {0.8590216020972654,-4.660500557791393e-17,-0.28017907556205157,0.11131275195908047,-0.046881666561960134,
    0.02035179537541076,-0.009008232044558391,0.004043066297617074,-0.0018339235809686643,0.0008388952787860709,
    -0.0003872059045304306,0.00017937938733559293},{0.825651622032854,-6.712968682268944e-18,-0.2543997693261797,
    0.09547788004609971,-0.037969724280683716,0.015556860148015399,-0.006496578005235948,0.0027501317496293892,
    -0.0011762995596307998,0.0005072873704846923,-0.00022066126353937306,9.634702003404317e-05},{0.7952729428854957,
    7.951614572375164e-18,-0.2321960485861809,0.08258017086396302,-0.031108207410085412,0.012068543299884731,
    -0.004770571917695185,0.0019110672342725814,-0.0007733616513345805,0.00031548844905175894,-0.00012976876810881117,
    5.358322637266315e-05},{0.7674808015390393,4.225436897609101e-18,-0.21292041063642894,0.07195937830878983,
    -0.025750794370227478,0.009486908778062915,-0.003560134190790618,0.0013536062368500776,-0.0005197960915718488,
    0.0002011854094732676,-7.848987330254377e-05,3.074152719386588e-05},{0.7419420333956459,3.3758723949539174e-17,
    -0.1960676292372085,0.06312733840080482,-0.021514856970343218,0.007546703100984892,-0.0026956774790180865,
    0.0009753639409730604,-0.000356369695278709,0.00013121750765908877,-4.868768076459022e-05,1.8136636732923122e-05},
    {0.7183796869480137,4.7206075912349517e-17,-0.1812384660073137,0.05571747723169308,-0.01812744038262969,
    0.006068213416560387,-0.002068103922623939,0.0007138122786229565,-0.0002487470332381298,8.734294193878242e-05,
    -3.089790786874503e-05,1.0973646871960527e-05},{0.6965614801150923,-5.1574822477732915e-17,-0.16811381271285325,
    0.04945065291290281,-0.015390577175041205,0.004927326236479551,-0.0016056831456312747,0.0005298194907905577,
    -0.00017647810856314042,5.922338803639044e-05,-2.001855162614019e-05,6.79358139721964e-06},{0.6762910161559875,
    -2.5574937570538e-19,-0.1564359555998727,0.04411159546528664,-0.013158518795474436,0.004036827099458031,
    -0.0012603145918196133,0.000398348616972835,-0.0001270808634791098,4.083983529759661e-05,-1.3217201318308147e-05,
    4.294618175503496e-06},{0.6574010137061904,-3.717905149881858e-17,-0.14599479336493654,0.03953236943863208,
    -0.011322489008076118,0.003334456670654487,-0.0009991601690132247,0.0003030557692364809,-9.276512629464217e-05,
    2.8601249509693938e-05,-8.87890678042837e-06,2.7673478549507592e-06},{0.6397480282695684,-1.648339735018385e-17,
    -0.1366175587941173,0.03558057980922494,-0.009800287817354045,0.002775125661359339,-0.0007994316831785891,
    0.0002330744375678398,-6.856919710755805e-05,2.0316830338581512e-05,-6.0601921614053585e-06,1.8148671869251808e-06},
    {0.6232082927744538,-3.1341914901419648e-18,-0.12816105661218125,0.03215083767938012,-0.00852908475592062,
    0.0023257456326635667,-0.000645076190581489,0.00018105743263806124,-5.127350226369583e-05,1.462242700262744e-05,
    -4.1974427155994154e-06,1.209691956703128e-06},{0.6076744079579084,2.1564332975598794e-17,-0.12050573376196404,
    0.029158502090087253,-0.00746034695509748,0.0019617380081711883,-0.0005246282097534068,0.00014195971233620433,
    -3.8752830822170567e-05,1.0652504527450174e-05,-2.94699495067025e-06,8.185161181455179e-07},{0.5930526852959032,
    -2.130639517473704e-17,-0.11355110134216635,0.026535034401329607,-0.006556219641478503,0.0016646394123644482,
    -0.0004297937579937552,0.00011226725302956669,-2.9582006701387867e-05,7.848285001696237e-06,-2.0953011365596e-06,
    5.616074529929715e-07},{0.5792609961286203,2.9651904668787746e-17,-0.10721216539702365,0.02422451055190036,
    -0.005786909774033504,0.001420435244955442,-0.00035450185479760576,8.94998786770741e-05,-2.2791214585247516e-05,
    5.843190177519611e-06,-1.5073233861895468e-06,3.9036549919352024e-07},{0.5662270171715085,-3.256466514441127e-17,
    -0.10141661894504106,0.022180975077926008,-0.005128772201925969,0.0012183844907037258,-0.00029425972171198423,
    7.188548488178385e-05,-1.7711479700065705e-05,4.3931199222114e-06,-1.0962715701532314e-06,2.7464084810006485e-07},
    {0.5538867891488508,1.3992386854777858e-17,-0.09610261424158478,0.020366414140921132,-0.004562894182806985,
    0.001050180653755276,-0.0002457083975795468,5.814333867944899e-05,-1.387547162545263e-05,3.333259412048932e-06,
    -8.05515111991779e-07,1.954218330756001e-07},{0.5421835247956155,3.5878406698800405e-17,-0.09121698148367911,
    0.01874918864413697,-0.004074037684469154,0.0009093457501956007,-0.00020631255030268303,4.7337903707345486e-05,
    -1.0952846471433521e-05,2.5508760406416524e-06,-5.975775330730694e-07,1.4053569021756562e-07},{0.531066616965453,
    2.0265736021478895e-18,-0.08671379403702881,0.017302812734356812,-0.0036498414239687542,0.00079078790265721,
    -0.00017414137150258035,3.8778943548079573e-05,-8.707498636797929e-06,1.967921213018118e-06,-4.4732852844789025e-07,
    1.0207641755552775e-07},{0.5204908084562393,4.504421926513321e-17,-0.08255320483921914,0.016004994002731646,
    -0.0032802134388601064,0.0006904751116224745,-0.00014771207889530488,3.1952414002669774e-05,-6.96892001526661e-06,
    1.529741887596773e-06,-3.3770690579144955e-07,7.484004223319955e-08},{0.5104154933996218,-5.304047226033507e-17,
    -0.07870049664903823,0.014836873708195322,-0.0029568647928191446,0.0006051924208233211,-0.0001258769660771943,
    2.6472105265441705e-05,-5.612770646766775e-06,1.1976569704123606e-06,-2.569942761146002e-07,5.53578319897701e-08},
    {0.500804126352606,-7.142059467082941e-18,-0.07512530215002598,0.013782421136197404,-0.002672948784917722,
    0.0005323595537167541,-0.00010774108049134769,2.2045438527154832e-05,-4.547543253608939e-06,9.440132079151273e-07,
    -1.970534102884564e-07,4.1290180365782846e-08},{0.49162372007559063,1.8074657516026193e-17,-0.07180095988242359,
    0.012827947648020208,-0.002422779707880362,0.0004698928182318247,-9.260166919502256e-05,1.8449028358058624e-05,
    -3.7053091342371944e-06,7.488530091969669e-07,-1.5217525557519273e-07,3.104136447908735e-08},{0.4828444167432729,
    -1.3293579074869736e-17,-0.06870397948877711,0.011961714348119778,-0.0022016120732338716,0.000416099710143321,
    -7.990324811515933e-05,1.5511055470849286e-05,-3.0352293817351483e-06,5.976433334653454e-07,-1.1831515288475794e-07,
    2.3511503236570382e-08},{0.4744391202764317,-1.9552209157057217e-17,-0.06581359546551138,0.01117361347803112,
    -0.002005466151109333,0.0003695978742804134,-6.920398930712488e-05,1.3098437058892803e-05,-2.4989603327981822e-06,
    4.79711292143919e-07,-9.25810794617874e-08,1.7934851600783556e-08},{0.4663831797984814,7.490600726703693e-18,
    -0.06311139298252243,0.010454908247761994,-0.0018309892418659967,0.00032925235593597875,-6.015037941069408e-05,
    1.1107409193601907e-05,-2.067370016641739e-06,3.871557068892247e-07,-7.288703511316682e-08,1.3773420891101857e-08},
    {0.4586541160558145,2.718783227712085e-17,-0.06058099270295834,0.00979801927010485,-0.0016753447039666246,
    0.0002941266906016415,-5.245797305412692e-05,9.456557909736256e-06,-1.7181708556780316e-06,3.140826082856889e-07,
    -5.7715890774508177e-08,1.0645513584193985e-08},{0.45123138410407193,-2.215144920341692e-17,-0.05820778415243657,
    0.009196348375986686,-0.0015361226829340032,0.00026344453910513233,-4.58966730140759e-05,8.081622715611436e-06,
    -1.4341986867218458e-06,2.560634018103013e-07,-4.595552541465619e-08,8.278289058682657e-09},{0.44409616673579616,
    -1.8036247369742184e-17,-0.055978699232508006,0.008644132579268831,-0.0014112679119221382,0.00023655941369894802,
    -4.0279397618017964e-05,6.931593497241527e-06,-1.2021517174012585e-06,2.0974756130593883e-07,-3.678458157179373e-08,
    6.475009703137146e-09},{0.43723119407105765,-2.4343241382164105e-17,-0.05388201908193654,0.008136322485968253,
    -0.001299021020841007,0.00021293065223379923,-3.545330077374273e-05,5.965758569458552e-06,-1.0116595270991946e-06,
    1.7258351547320943e-07,-2.9592102203191803e-08,5.0927371799274825e-09},{0.4306205854995864,-1.2041558856915408e-17,
    -0.05190720876203922,0.007668480621377432,-0.0011978705943318736,0.00019210424711493617,-3.129292869576602e-05,
    5.15145734908396e-06,-8.545907937046606e-07,1.426159426691612e-07,-2.3920532057268952e-08,4.026854442186471e-09},
    {0.4242497107877546,-2.4667779257634188e-17,-0.050044775254777955,0.007236696064008831,-0.0011065138282027394,
    0.0001736974686536552,-2.769485550553536e-05,4.462358689581521e-06,-7.245350064852552e-07,1.1833746644414373e-07,
    -1.9424968073775223e-08,3.2002526295357266e-09},{0.41810506767519934,2.411809871316778e-17,-0.04828614507201921,
    0.0068375124906007575,-0.0010238240990653935,0.0001573864706969998,-2.4573455064210794e-05,3.877133997746428e-06,
    -6.164119011920696e-07,9.857938513801903e-08,-1.584380506505758e-08,2.5557155228920755e-09},{0.41217417370643,
    1.9934212343796408e-17,-0.04662355842527158,0.006467867298498438,-0.000948824119178277,0.00014289625281205227,
    -2.185755091816105e-05,3.3784287370590688e-06,-5.261753042478434e-07,8.243061798760223e-08,-1.2977436490942661e-08,
    2.0505143066591273e-09},{0.4064454703900849,1.4623703670734747e-17,-0.04504997743097305,0.006125039915769563,
    -0.000880663624528202,0.00012999249413794305,-1.9487748690586637e-05,2.952060839345724e-06,-4.5058722341150793e-07,
    6.917719317734008e-08,-1.0672692583756539e-08,1.6525426091351907e-09},{0.4009082380665358,-1.6039308213945086e-17,
    -0.043559006253060896,0.005806607762017614,-0.0008186007586525662,0.00011847488108656097,-1.741430170609502e-05,
    2.5863926791434714e-06,-3.870445371980227e-07,5.8256792444158935e-08,-8.811394755250203e-09,1.3375332392335584e-09},
    {0.3955525201043523,-6.143380185288081e-18,-0.04214482143233731,0.005510408604227322,-0.0007619864822405477,
    0.0001081716329468319,-1.5595395407046073e-05,2.271836550981904e-06,-3.33445307637032e-07,4.9224403563142295e-08,
    -7.301883849682124e-09,1.0870402174525273e-09},{0.39036905524656973,-2.3145171178354427e-17,-0.040802110936835334,
    0.005234508277563725,-0.0007102514701032586,9.893499240781531e-05,-1.3995762306826188e-05,2.0004633879437167e-06,
    -2.880851152690808e-07,4.172621880459658e-08,-6.072711248319979e-09,8.869661081582378e-10},{0.38534921709583003,
    -8.383184861062215e-18,-0.039526020701389025,0.004977172922726489,-0.0006628950609100888,9.063749669293952e-05,
    -1.2585559060761625e-05,1.7656917311980664e-06,-2.495762685437195e-07,3.547969150902233e-08,-5.067913088614204e-09,
    7.264805554772414e-10},{0.3804849598689911,3.2479918208988813e-18,-0.03831210761769984,0.0047368450384148416,
    -0.0006194759073921691,8.316888282644914e-05,-1.1339452344382642e-05,1.5620393887998892e-06,-2.1678453488880493e-07,
    3.0258218035825055e-08,-4.24345039401781e-09,5.972213148855113e-10},{0.37576876967132977,-9.512263691009425e-18,
    -0.037156298096120595,0.004512122766818391,-0.0005796040402663722,7.643351009727851e-05,-1.0235871799273117e-05,
    1.3849242983091972e-06,-1.8877936235225238e-07,2.5879313056796253e-08,-3.5645129433999146e-09,
    4.927005623908415e-10},{0.37119362064175054,1.2273867043622176e-17,-0.03605485145332343,0.0043017419273847545,
    -0.0005429341115729951,7.034820596958751e-05,-9.256397213207956e-06,1.230504185575366e-06,-1.6479453952905472e-07,
    2.2195437151332903e-08,-3.0034674343001436e-09,4.078702991856842e-10},{0.3667529354065027,-5.248557397970091e-18,
    -0.03500432749091645,0.004104560393795889,-0.0005091596252472825,6.48404599657963e-05,-8.385253991101519e-06,
    1.0955469483202392e-06,-1.441969706107481e-07,1.90868492754255e-08,-2.5382830378582217e-09,3.387440508488413e-10},
    {0.36244054935230247,1.3071884248617709e-17,-0.034001557722891575,0.003919544474555319,-0.00047800799672482693,
    5.98469045195713e-05,-7.608896328542396e-06,9.773254757098555e-07,-1.264617882095457e-07,1.6456010029530313e-08,
    -2.1513318032944697e-09,2.822354997023346e-10},{0.3582506782925118,2.3735919232217254e-17,-0.0330436197877228,
    0.0037457570115746403,-0.0004492363108964829,5.5312033303773755e-05,-6.915661681314793e-06,8.735319818465862e-07,
    -1.111524381285934e-07,1.4223183371988005e-08,-1.8284480061475548e-09,2.3587690402950237e-10},{0.3541778891538278,
    9.831101755338393e-18,-0.032127814646578365,0.0035823469558174045,-0.0004226276700935722,5.118711672652152e-05,
    -6.295483403993454e-06,7.822079841165214e-07,-9.790468081528172e-08,1.2322962731301904e-08,-1.5582085126099971e-09,
    1.9771915757694533e-10},{0.3502170733571917,-5.815426234142855e-18,-0.03125164622456808,0.0034285402161423053,
    -0.0003979880420290663,4.7429281653762314e-05,-5.739651013983922e-06,7.016868722451491e-07,-8.641369123898373e-08,
    1.0701517802598666e-08,-1.331367995771873e-09,1.662108858456588e-10},{0.3463634226064937,-2.6734590903054904e-17,
    -0.030412803198934298,0.0032836316083724153,-0.000375143532556435,4.400072834331715e-05,-5.240609580538753e-06,
    6.305466474522452e-07,-7.642361947634984e-08,9.314403472898136e-09,-1.1404176371394247e-09,1.4011267509056299e-10},
    {0.34261240683309974,2.0640626258072083e-17,-0.02960914267801735,0.003146977757418998,-0.00035393802037653746,
    4.086806236184483e-05,-4.7917913606851425e-06,5.675709056951075e-07,-6.77191130984997e-08,8.124809589394999e-09,
    -9.792383811817237e-10,1.184307317438372e-10},{0.3389597540740649,7.250852936112239e-18,-0.028838675548837716,
    0.0030179908269081786,-0.0003342311009336802,3.800172313569412e-05,-4.38747409726124e-06,5.117165267311655e-07,
    -6.011840941549203e-08,7.102157766638496e-09,-8.428274209604542e-10,1.0036539504287162e-10},{0.3354014320878048,
    -2.551699245203056e-17,-0.028099553300188873,0.0028961329689268047,-0.00031589629510075,3.537549394184827e-05,
    -4.0226614289912444e-06,4.620868359165444e-07,-5.346768845752417e-08,6.220972444305037e-09,-7.270816293504511e-10,
    8.527101545689364e-11},{0.3319336315335402,-1.4807280398134435e-17,-0.027390056153012744,0.0027809114018139953,
    -0.00029881948518492536,3.2966080719903935e-05,-3.692981693397863e-06,4.179092467943883e-07,-4.7636441966401054e-08,
    5.459969484792287e-09,-6.286254489161558e-10,7.262456666844546e-11},{0.32855275056049044,1.3182507948216828e-17,
    -0.026708582351186023,0.0026718740368616746,-0.00028289754655062176,3.0752749193845836e-05,-3.3946020728475598e-06,
    3.7851658377150045e-07,-4.251366393671372e-08,4.801317951906349e-09,-5.446736262753174e-10,6.20009970041755e-11},
    {0.32525538066997184,2.597348666517851e-17,-0.026053638484222198,0.0025686055857474643,-0.00026803714796512035,
    2.871701152335018e-05,-3.1241555753135335e-06,3.433314364077553e-07,-3.8004707636020686e-08,4.230040241302296e-09,
    -4.729213584879016e-10,5.305380132220731e-11},{0.3220382937286061,-9.242270203866362e-18,-0.02542383072924323,
    0.0024707240898323452,-0.0002541536977945838,2.684235513015554e-05,-2.878678780507481e-06,3.11853018436877e-07,
    -3.4028685016548895e-08,3.733523114200152e-09,-4.114560826152705e-10,4.549965307966614e-11},{0.318898430024046,
    -1.870264608999637e-17,-0.02481785691327464,0.002377877820381666,-0.0002411704165516258,2.511400752292978e-05,
    -2.6555586393094106e-06,2.8364610209465966e-07,-3.051630889046664e-08,3.3011179251231606e-09,-3.586864143718897e-10,
    3.910620576617283e-11},{0.3158328872662362,2.044748955393988e-17,-0.024234499308785355,0.00228974250553304,
    -0.00022901751913233354,2.351873191991573e-05,-2.4524869060450884e-06,2.5833167670105863e-07,
    -2.7408097618675092e-08,2.923812813839768e-09,-3.1328472106679686e-10,3.3682377295729725e-11},{0.3128389104474515,
    -2.5320903451646244e-17,-0.023672618085695676,0.0022060188456218825,-0.00021763149247211143,2.204464927934605e-05,
    -2.2674210219003194e-06,2.355790436663172e-07,-2.465287746758148e-08,2.5939631405439237e-09,-2.7414057098438546e-10,
    2.9070586967658307e-11},{0.3099138824833789,5.911879082871445e-18,-0.02313114535203801,0.002126430283437338,
    -0.0002069544563707885,2.068108302293526e-05,-2.098550463776031e-06,2.150991112546833e-07,-2.2206530075184687e-08,
    2.305069201970575e-09,-2.4032288668244223e-10,2.5140532133766414e-11},{0.3070553155654902,2.2386807254134323e-17,
    -0.022609079723265535,0.0020507210002450884,-0.00019693359694957716,1.9418423301761915e-05,-1.9442677342773912e-06,
    1.9663869396825193e-07,-2.0030942299514464e-08,2.051592441851568e-09,-2.1104908594240725e-10,
    2.1784185055555117e-11},{0.3042608431620117,-1.617881048446762e-17,-0.022105481367024477,0.0019786541120851123,
    -0.00018752066365628793,1.8248008126087167e-05,-1.8031433017741233e-06,1.799756552213054e-07,
    -1.8093123614473803e-08,1.8288030917421495e-09,-1.856598496320483e-10,1.8911757154787447e-11}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_max_overlap)

/* time of the largest overlap, beta < 8: 65 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 8.0625.
 * Relative error of the approximation: 2^-60.6 at most, proved for the whole cell of each row. Bits of the rows:
 * 61.0 64.4 63.5 62.0 62.1 60.9 60.7 63.9 61.3 61.5 61.2 62.3 60.6 62.1 62.2 61.6 63.3 63.8 61.7 62.6 61.6 62.0 62.1
 * 61.5 63.4 63.1 63.2 61.5 61.8 64.0 61.1 61.7 61.6 62.0 61.1 66.0 64.6 65.3 62.7 62.7 62.6 62.4 62.3 63.6 63.8 62.2
 * 66.2 62.6 62.1 63.2 62.5 62.2 64.0 62.3 63.7 62.8 63.9 62.2 62.6 66.3 62.0 61.8 62.6 63.0 63.1 */
#define COR_ROWS_TIME_OF_MAX_OVERLAP_FIRST 0.0
#define COR_ROWS_TIME_OF_MAX_OVERLAP_STEP 0.125
#define COR_ROWS_TIME_OF_MAX_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_TIME_OF_MAX_OVERLAP_ROWS 65
#define COR_ROWS_TIME_OF_MAX_OVERLAP_END 8.0
COR_ROWS(double, cor_rows_time_of_max_overlap, 65, 12)
#ifdef COR_ROWS_HERE
= {
    {1.6090327298595215,3.784495057524488e-17,-0.286747125067594,0.1048589870995717,-0.04868406782814066,
    0.02543116750978849,-0.014236583511432335,0.00833765728900391,-0.005039645724543733,0.003116052833257268,
    -0.0019351363116886981,0.0010285645119171277},{1.5747384787194234,-2.656959159290068e-19,-0.2626317385953883,
    0.08873618135649122,-0.03790556047035478,0.01818955636285338,-0.009347976775031748,0.005024363745646884,
    -0.0027867741177711246,0.0015820163125917493,-0.0009173603678785516,0.0005377131139388131},{1.5432261533884821,
    -1.8315261649009375e-17,-0.24209297044396622,0.07606105782513256,-0.030096513791626006,0.013358058635936153,
    -0.006345582918309006,0.0031516489421264185,-0.0016150835853807933,0.0008470382023779815,-0.0004535150546955774,
    0.0002455614836291354},{1.514097282750751,-2.743285429726186e-17,-0.2243913293492237,0.06591383592425175,
    -0.02429835583824598,0.010033244622405211,-0.0044313907277274776,0.002045730976185303,-0.0009742740310796005,
    0.000474817317524241,-0.0002361335521874261,0.00011880177975731249},{1.4870331341953917,-2.86328180174546e-17,
    -0.2089785302252359,0.05766293284288509,-0.019901809859164708,0.007683787845168145,-0.003171273677078433,
    0.0013676512004857193,-0.0006083791009012483,0.00027691580689632675,-0.00012857149805232457,6.040839602019429e-05},
    {1.4617747146083806,-3.6342389953407315e-17,-0.1954393007721488,0.05086281643977812,-0.016506766808815312,
    0.005984979865506126,-0.0023184009517294613,0.0009381516239317601,-0.0003915147277772148,0.0001671703252652862,
    -7.278742747375222e-05,3.20778955036699e-05},{1.4381086875660793,5.843137872452977e-17,-0.18345326185336408,
    0.04519179087318108,-0.013842961829381545,0.004731695971328776,-0.0017269803758055,0.0006582548100945634,
    -0.00025871689166325916,0.00010402863157459605,-4.264310847203922e-05,1.769597744846616e-05},{1.4158572194215084,
    5.244835926210769e-17,-0.17276923072957778,0.040412801821516714,-0.011723287081513566,0.003790553178254513,
    -0.0013079883535525257,0.00047121687063819977,-0.00017502326921438818,6.650118309182693e-05,-2.575298797934471e-05,
    1.0097593596419761e-05},{1.3948705057929498,5.205747575920854e-17,-0.16318746047555258,0.03634800704669176,
    -0.010015366374910028,0.003072582532685785,-0.0010054516386371762,0.00034341268224052636,-0.00012091045814705638,
    4.354429524976051e-05,-1.5979828336163564e-05,5.938204795046218e-06},{1.375021170294273,-3.9568479136690924e-17,
    -0.15454709200957556,0.03286184606033737,-0.008623725918484043,0.0025170844641764574,-0.0007832521595202342,
    0.00025432383181586417,-8.511377793325172e-05,2.9133577706760705e-05,-1.0159670842752502e-05,
    3.5879645658357093e-06},{1.3561999984739466,1.1927784378013968e-17,-0.14671711464165532,0.029849507377280416,
    -0.007478312872052209,0.0020818022375831175,-0.0006175374504528391,0.00019109759397780465,-6.094107237831301e-05,
    1.9875015680736662e-05,-6.602722202047189e-06,2.221538239797418e-06},{1.3383126417244915,-5.032570358846733e-17,
    -0.1395897400269783,0.02722891051204999,-0.006526925994362692,0.0017367799008696008,-0.0004922237799834019,
    0.0001454913762085296,-4.431096133875817e-05,1.380031867518535e-05,-4.377417870811427e-06,1.4063328235211804e-06},
    {1.3212770375772578,-8.828473978064862e-17,-0.13307546881364807,0.0249350284445201,-0.005730119127075129,
    0.001460430597208441,-0.0003962598436765843,0.0001121055567265379,-3.2674618937219076e-05,9.73777266856479e-06,
    -2.955274911893539e-06,9.084435437801494e-07},{1.3050213670262527,8.54025841374394e-17,-0.12709936544792702,
    0.022915800284680155,-0.005057703762967488,0.0012369650667261097,-0.000321921280009769,8.733398034582208e-05,
    -2.440568397818666e-05,6.973106886590656e-06,-2.0285867326874313e-06,5.977761803390156e-07},{1.289482419888131,
    -4.67070314991038e-17,-0.12159820905619184,0.021129144220854924,-0.004486307190741071,0.001054676638275562,
    -0.00026372427878903825,6.872549493161524e-05,-1.8445841188571673e-05,5.061378453347458e-06,-1.4138968126999427e-06,
    4.000889963026765e-07},{1.274604274010676,3.465060911786501e-17,-0.11651828880832364,0.019540744470640838,
    -0.003997640599905214,0.0009047769243941383,-0.00021771968704942127,5.458694216223999e-05,-1.4093931837151465e-05,
    3.7198698748233647e-06,-9.994287497279968e-07,2.7200373176869874e-07},{1.2603372186004456,6.816489163011619e-18,
    -0.11181367966267158,0.01812239099656663,-0.003577252915915856,0.0007805924203651044,-0.0001810259475879748,
    4.373129337341594e-05,-1.0877685997403628e-05,2.7656398169170714e-06,-7.157082843542392e-07,1.8762105941620254e-07},
    {1.246636869391474,-9.818103304490266e-17,-0.10744488051746605,0.01685071949068168,-0.0032136221978730484,
    0.0006770017900039936,-0.0001515148693353576,3.5314899051359525e-05,-8.474120359467177e-06,2.078304783854526e-06,
    -5.18752826966242e-07,1.3116580919880146e-07},{1.2334634360035457,-8.006322708058583e-17,-0.10337772881578387,
    0.01570624491914636,-0.0028974850308122525,0.0005900362649171942,-0.00012759694708382207,2.8730523789148107e-05,
    -6.659212476622891e-06,1.5774061723125783e-06,-3.8024045282304e-07,9.285040548762756e-08},{1.2207811110923703,
    2.371954963116716e-17,-0.09958252820777298,0.014672612913392896,-0.002621335958620946,0.0005165922371235482,
    -0.00010807259442562312,2.353593454128439e-05,-5.275533604767997e-06,1.208388032012642e-06,-2.8164365482642664e-07,
    6.649733639276892e-08},{1.2085575577567509,8.301965150450021e-17,-0.09603334197703654,0.01373601459292971,
    -0.0023790499109514213,0.0004542220876820751,-9.202768525630234e-05,1.940552670313911e-05,-4.2110979327277e-06,
    9.337582063072379e-07,-2.1066296068028458e-07,4.814499586320953e-08},{1.1967634768134532,5.145877446958169e-17,
    -0.09270741657754078,0.01288472524396019,-0.002165594617093162,0.0004009802716985723,-7.875930265980791e-05,
    1.6097109845068017e-05,-3.3853353944220095e-06,7.274265819848776e-07,-1.590208063955655e-07,3.521479205257031e-08},
    {1.1853722394480755,7.386868144733623e-17,-0.0895847081378184,0.012108737750272028,-0.0019768095621908142,
    0.00035530889566773695,-6.772235319701459e-05,1.342881299056185e-05,-2.739659685555776e-06,5.710237330310862e-07,
    -1.2107460222284275e-07,2.600485034136029e-08},{1.1743595737305874,-3.84821428233331e-17,-0.08664749107877133,
    0.011399469152208888,-0.0018092346406904298,0.00031595183485836183,-5.8490770996190154e-05,1.1262835952906442e-05,
    -2.2310438798927583e-06,4.5147351989239094e-07,-9.293152928883796e-08,1.9377213320572973e-08},{1.163703295783445,
    8.214707052770702e-17,-0.08388003268627321,0.01074952411120512,-0.0016599762729317274,0.00028188969071008235,
    -5.0729040863913444e-05,9.493890458522273e-06,-1.8275914721569612e-06,3.5937140552740484e-07,-7.187551239257104e-08,
    1.4561629168194056e-08},{1.153383078178704,-3.622445436620365e-18,-0.08126832101724094,0.010152502999388175,
    -0.0015266020098001942,0.00025229011427427175,-4.4171098464954704e-05,8.040891833490064e-06,-1.5054482781471949e-06,
    2.8788764290487073e-07,-5.599131838077063e-08,1.1030706169445025e-08},{1.1433802495426075,9.972065039907065e-17,
    -0.078799836206683,0.009602845238807034,-0.0014070569787286297,0.00022646956348783875,-3.86045577592436e-05,
    6.840928662586339e-06,-1.2466261874363997e-06,2.320168250310646e-07,-4.3914869212297606e-08,8.419404299482164e-09},
    {1.1336776204532852,1.051719161877352e-16,-0.07646335730391363,0.00909570067544717,-0.0012995972047700837,
    0.0002038636417781189,-3.385882209720019e-05,5.844845474332646e-06,-1.0374540440859264e-06,1.8805879362443546e-07,
    -3.466542879103301e-08,6.472458641003529e-09},{1.1242593315974796,8.97033517132052e-17,-0.07424879835767455,
    0.008626823394055952,-0.0012027360648775058,0.00018400392955564732,-2.979605199197873e-05,5.013978826709189e-06,
    -8.674644382917098e-07,1.532558671799308e-07,-2.753155677951369e-08,5.0097197677300935e-09},{1.1151107208566788,
    6.262269449392906e-17,-0.07214706870814246,0.008192483605700022,-0.0011152010337211365,0.00016649976617978492,
    -2.6304251978671257e-05,4.317725787656298e-06,-7.285865485475855e-07,1.2553684329580864e-07,-2.19927905769119e-08,
    3.902491003322128e-09},{1.1062182065602268,-4.130890524277838e-17,-0.07014995341382121,0.007789394174309481,
    -0.0010358985468426603,0.00015102383383506598,-2.3291942024669436e-05,3.7317184153898204e-06,-6.145559078408558e-07,
    1.0333466092119492e-07,-1.7665310224625418e-08,3.0587205364081033e-09},{1.0975691846023112,8.961499193895762e-17,
    -0.06825001050619911,0.007414649065776083,-0.0009638853058399687,0.00013730068134878694,-2.068402279479513e-05,
    3.2364430851212684e-06,-5.204793095869236e-07,8.545541495230658e-08,-1.4263908529144359e-08,2.4114107683255118e-09},
    {1.089151937493752,5.3021015510382765e-18,-0.06644048237191391,0.007065671557680898,-0.0008983447260177849,
    0.0001250975362646963,-1.8418546891838895e-05,2.8161889390844535e-06,-4.4251161682019666e-07,7.098345358730669e-08,
    -1.1575113264878415e-08,1.9116887281355845e-09},{1.0809555537256457,9.553247943070695e-17,-0.06471521904649348,
    0.006740170479193135,-0.0008385675119762828,0.00011421690900331116,-1.6444182319329e-05,2.4582416647754684e-06,
    -3.7761394392387785e-07,5.921208787250098e-08,-9.438040235662765e-09,1.5235858595602295e-09},{1.0729698560737515,
    -8.348033826342685e-17,-0.0630686115924272,0.0064361030885004295,-0.0007839355643248936,0.00010449060881581877,
    -1.4718208291305933e-05,2.1522614434311496e-06,-3.2337146774305165e-07,4.959261608641282e-08,-7.730639399597126e-09,
    1.2204418751966876e-09},{1.0651853376806042,-2.5412938499387926e-17,-0.0614955340479203,0.006151643461194984,
    -0.0007339085880894441,9.577487819680912e-05,-1.3204922978751068e-05,1.889800094869691e-06,-2.7785525662651107e-07,
    4.1696553410394364e-08,-6.3597388497817805e-09,9.82361036242071e-10},{1.0575931049251195,1.9743060193973392e-17,
    -0.05999129268697416,0.005885155473773345,-0.000688012902865679,8.794641812242235e-05,-1.1874371903579117e-05,
    1.6639241078842206e-06,-2.395168213415242e-07,3.518745440233036e-08,-5.253784713190807e-09,7.943989938100818e-10},
    {1.050184826233476,7.81053969846081e-17,-0.05855158153863468,0.005635169634214924,-0.0006458320555355196,
    8.089912644339922e-05,-1.0701327331262716e-05,1.4689187142938056e-06,-2.0710715369829018e-07,2.9799754441206555e-08,
    -4.357509596665579e-09,6.452605833261841e-10},{1.042952686105639,6.772716357955805e-17,-0.05717244328285447,
    0.005400363145916007,-0.0006069989152192189,7.45414099924636e-05,-9.664465202255728e-06,1.300054358949157e-06,
    -1.7961420815143297e-07,2.532278238271588e-08,-3.6279908693115007e-09,5.263578132941987e-10},{1.0358893437332064,
    7.925403683307345e-17,-0.05585023477985814,0.005179542699285542,-0.0005711889921835215,6.87939603908981e-05,
    -8.745698331360471e-06,1.1534014798691981e-06,-1.5621435887393508e-07,2.1588608275226687e-08,
    -3.0317176609255546e-09,4.3112369965735883e-10},{1.0289878956697298,-1.3291398598670653e-17,-0.05458159660502758,
    0.004971629572607255,-0.0005381147714991588,6.358790631604015e-05,-7.929633837833544e-06,1.0256828946884976e-06,
    -1.362345090982084e-07,1.8462753222910324e-08,-2.5423949395381797e-09,3.5450913653627863e-10},{1.022241842087007,
    4.729718166286873e-17,-0.053363426056761115,0.004775646694635085,-0.0005075208912456337,5.88632727175039e-05,
    -7.203129805052959e-06,9.141556128059612e-07,-1.1912236538169928e-07,1.583704825372941e-08,-2.139289684146584e-09,
    2.9261163182578547e-10},{1.0156450562123003,2.3998738811817668e-17,-0.052192853184179176,0.004590707379157856,
    -0.00047918002621036895,5.456769133689608e-05,-6.554931560244578e-06,8.165157865693393e-07,-1.0442300400412342e-07,
    1.3624116124604523e-08,-1.805978241154229e-09,2.4239967775157584e-10},{1.009191756593804,-4.728818178487139e-17,
    -0.05106721944788406,0.004416005489058254,-0.00045288936301835804,5.0655317787840587e-05,-5.975372118724644e-06,
    7.308219447367054e-07,-9.176031136820906e-08,1.1753085620202476e-08,-1.52939235982003e-09,2.0150691731760117e-10},
    {1.0028764818864597,-3.069510620264739e-17,-0.049984058682584924,0.004250806826255474,-0.00042846757276334763,
    4.708591906518334e-05,-5.456124554102482e-06,6.554327370662068e-07,-8.082221867397233e-08,1.0166246854413427e-08,
    -1.2990888774866319e-09,1.680775737411802e-10},{0.9966940678886091,-4.326408342712186e-17,-0.0489410800771667,
    0.004094441575982805,-0.00040575220350343584,4.38241021865847e-05,-4.989996559672506e-06,5.889562475359162e-07,
    -7.13489044557173e-08,8.8164282575613e-09,-1.1066875992391037e-09,1.406979878075236e-10},{0.9906396265929898,
    3.9608625675435913e-17,-0.04793615292724735,0.003946297660398658,-0.000384597428219545,4.083866011724608e-05,
    -4.570759424267888e-06,5.302085694648925e-07,-6.312332924239697e-08,7.664933383045522e-09,-9.454376803208063e-10,
    1.1806671234343353e-10},{0.9847085270440561,-3.7058885690394605e-17,-0.04696729294867637,0.003805814878588081,
    -0.00036487209462968156,3.8102015489119504e-05,-4.1930051841684635e-06,4.781798260851159e-07,-5.596361093436845e-08,
    6.679902158260173e-09,-8.098784728422662e-10,9.940957531907164e-11},{0.9788963778182269,3.923733405678905e-17,
    -0.04603264996879563,0.0036724797284028764,-0.0003464580320884357,3.558974613077857e-05,-3.852026926593336e-06,
    4.3200619983759096e-07,-4.971685918524457e-08,5.835017701388383e-09,-6.955778086021078e-10,8.394532434887479e-11},
    {0.9731990109650128,-1.0566188008549047e-17,-0.045130496836441714,0.0035458208209720463,-0.0003292485780610229,
    3.3280179252244036e-05,-3.5437181823672614e-06,3.909468294093076e-07,-4.4254171062998855e-08,5.108468709956822e-09,
    -5.98924785049222e-10,7.108693012096389e-11},{0.9676124672655249,1.3248210522973895e-17,-0.0442592194123008,
    0.0034254048116227785,-0.00031314729264642007,3.1154043419798654e-05,-3.2644881109392025e-06,3.543646645594673e-07,
    -3.9466554641601546e-08,4.482121053568841e-09,-5.169675013109843e-10,6.036254306407677e-11},{0.9621329826810395,
    -4.260592263422125e-18,-0.04341730751889547,0.0033108327818168514,-0.00029806683457514596,2.91941693181114e-05,
    -3.011189792600659e-06,3.2171055030218136e-07,-3.526159693468223e-08,3.940851597926855e-09,-4.4728469935886216e-10,
    5.1391507568193485e-11},{0.9567569758784064,1.1737481480179958e-17,-0.042603346744652784,0.0032017370158786474,
    -0.00028392797621597585,2.7385231816323546e-05,-2.7810594333253907e-06,2.925099550770436e-07,
    -3.1560731111933006e-08,3.472010848196356e-09,-3.8788393748278407e-10,4.3865656998347694e-11},{0.9514810367314467,
    4.9155831249098744e-17,-0.04181601100956217,0.0030977781240548387,-0.0002706587385463361,2.5713527098529906e-05,
    -2.571664682566702e-06,2.6635187079902704e-07,-2.829698793929627e-08,3.064987975123832e-09,-3.3712050269730365e-10,
    3.753465990195383e-11},{0.9463019157083294,-1.2012151112446078e-17,-0.04105405581120009,0.002998642470036324,
    -0.00025819362989721006,2.4166779640662812e-05,-2.3808605833985135e-06,2.4287950268031755e-07,
    -2.5413139831243752e-08,2.710857516805759e-09,-2.936326012060103e-10,3.219449629401174e-11},{0.9412165140644395,
    -2.820997808208436e-17,-0.04031631207964631,0.002904039866682315,-0.00024647297467521485,2.273397465753877e-05,
    -2.2067519330413346e-06,2.2178243850442868e-07,-2.2860164304077863e-08,2.4020914731307116e-09,
    -2.5628937504391653e-10,2.7678359539511912e-11},{0.9362218747686493,1.111163759298696e-17,-0.03960168057826743,
    0.00281370150847298,-0.00023544232027322123,2.1405212339559878e-05,-2.0476610422116014e-06,2.027900445007451e-07,
    -2.0595968115425826e-08,2.132323939448828e-09,-2.2414906251651911e-10,2.3849446801457196e-11},{0.9313151740983101,
    -1.2142438684395835e-18,-0.03890912679468681,0.0027273781133116,-0.00022505191207248176,2.0171580775329908e-05,
    -1.9021000534332305e-06,1.856658811334895e-07,-1.8584324838349778e-08,1.8961580957780416e-09,
    -1.9642521074586054e-10,2.0595225944760952e-11},{0.9264937138448334,-2.6150964637833868e-17,-0.03823767627265467,
    0.0026448382498082956,-0.0002152562278675612,1.9025044935979903e-05,-1.7687471190128885e-06,1.7020296933186526e-07,
    -1.679398771656435e-08,1.6890074542042163e-09,-1.7245930225681905e-10,1.7822860274284072e-11},{0.9217549140775345,
    3.9880490827010556e-17,-0.03758641034111246,0.002565866829195174,-0.000206013564254508,1.79583494968152e-05,
    -1.6464258548039105e-06,1.56219767782988e-07,-1.5197946893575003e-08,1.5069649035058403e-09,-1.5169850831133682e-10,
    1.5455545290115254e-11},{0.9170963064185655,-4.230419339648163e-17,-0.03695446220162531,0.002490263743622462,
    -0.0001972856685488599,1.6964933606158042e-05,-1.5340875809450593e-06,1.4355674632546346e-07,-1.377280589984624e-08,
    1.3466943784273707e-09,-1.3367755378589807e-10,1.342956592050828e-11},{0.912515527786339,5.625126526357814e-18,
    -0.0363410133396313,0.0024178426348296753,-0.00018903741067304678,1.6038855991456652e-05,-1.4307959392767304e-06,
    1.3207346035203975e-07,-1.2498256925964986e-08,1.2053409989015573e-09,-1.1800388982946358e-10,
    1.1691924929070752e-11},{0.9080103145689314,1.612474226911198e-17,-0.035745290228709654,0.0023484297791277527,
    -0.00018123649019715705,1.5174729028211693e-05,-1.3357135421692895e-06,1.216460473496335e-07,-1.135663814549279e-08,
    1.080456331408538e-09,-1.0434553622963735e-10,1.019842623630615e-11},{0.9035784971925855,-5.467340297565053e-17,
    -0.035166561300370006,0.002281863076311746,-0.00017385317435325258,1.4367660595665739e-05,-1.2480903615078234e-06,
    1.1216507998360444e-07,-1.0332559365862209e-08,9.699360667126218e-10,-9.242108503512867e-11,8.912120358847924e-12},
    {0.8992179950536894,1.6328832267213522e-17,-0.034604134154773494,0.0022179911315862565,-0.00016686006338838632,
    1.3613202710756306e-05,-1.1672536115509924e-06,1.03533721034701e-07,-9.412584725871241e-09,8.719679203574802e-10,
    -8.199145866247112e-11,7.802039584208359e-12}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_time_of_max_overlap)

/* eps beta^(5/3) at zero force, beta > exp(2): 32 rows of degree 10 in y = ln(beta), nodes 2.125 + i 0.25, 2 <= y <= 10.
 * Relative error of the approximation: 2^-59.6 at most, proved for the whole cell of each row. Bits of the rows:
 * 59.6 59.8 60.5 61.0 63.5 61.2 62.7 62.2 62.9 64.5 63.4 63.8 64.2 65.1 65.1 65.1 65.1 65.3 65.4 65.5 65.6 65.6 65.6
 * 65.6 65.6 65.6 65.6 65.6 65.6 65.6 65.6 65.6 */
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_FIRST 2.125
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_STEP 0.25
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_PER_UNIT 4.0
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_ROWS 32
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_END 10.0
COR_ROWS(double, cor_rows_tail_eps_zero_force, 32, 12)
#ifdef COR_ROWS_HERE
= {
    {1.1327453204503086,5.52439973057448e-17,0.19574850424502319,-0.0870609615323064,0.013129595675897068,
    0.004643507608544806,-0.0027718558639489898,0.0003958726166812731,0.00013830914842282872,-7.668320854159275e-05,
    1.062389622524121e-05,3.381628499151873e-06},{1.1764618221230851,4.1689870495801715e-18,0.15491842415220328,
    -0.07588001860117877,0.01617935882584716,0.0016059407939468184,-0.002057719773637206,0.0005197350952822947,
    1.3125391557803429e-05,-4.741921676788208e-05,1.3662687274776361e-05,-4.933279360378826e-07},{1.2107061202120273,
    8.92434603619766e-17,0.12007527254429783,-0.06343436257997578,0.01666111836511011,-0.0004831020656911195,
    -0.0012958521220107877,0.0004769442302192929,-5.277537938076964e-05,-1.978280345644842e-05,1.0309037546037979e-05,
    -1.8456625360646068e-06},{1.2370175810192763,5.74326849129955e-17,0.091429243544831,-0.051295414194632856,
    0.015509054264881535,-0.0016888804416965181,-0.0006624014530856778,0.0003619547533428259,-7.267774973222316e-05,
    -1.877507792248683e-06,5.671285060670902e-06,-1.7159888382752388e-06},{1.256904097348898,-4.1342980902730866e-17,
    0.06857298798746704,-0.04038073758929302,0.01350934877559092,-0.002217195764509775,-0.0002141138849035893,
    0.00023759965849793832,-6.664448888415478e-05,6.5753937185690935e-06,2.117474334398241e-06,-1.105429452374307e-06},
    {1.2717258158519622,3.0441923908022854e-17,0.05077414719288859,-0.031101025718179198,0.011223865502966295,
    -0.002296529259099574,6.135970238828906e-05,0.00013444153621773933,-5.0533104587675704e-05,8.781652127168251e-06,
    9.631473192737728e-08,-5.39675886859391e-07},{1.2826420304176624,9.467884014284764e-17,0.03718648013322775,
    -0.023527836605389096,0.009001268775360774,-0.0021190380381207823,0.00020431098013370743,6.112383101998415e-05,
    -3.357735078867997e-05,7.859883462295545e-06,-7.531889975184734e-07,-1.7414564324830118e-07},{1.290600740508168,
    4.507998688185123e-17,0.026982154789938283,-0.01753665585381746,0.007024848918966185,-0.0018226593708681104,
    0.0002583985318598429,1.50213471305554e-05,-1.97777526073723e-05,5.877532642531233e-06,-9.273647656616418e-07,
    1.0084858451538233e-08},{1.2963531366046404,-1.0440708993977545e-16,0.01942217362996576,-0.012910628946644943,
    0.005365981362200877,-0.001494900527070832,0.00025966457171536656,-1.0498665057953892e-05,-1.004897899937855e-05,
    3.900822218124476e-06,-7.99833074949373e-07,7.806479158624866e-08},{1.3004800201653048,-1.0342093699811755e-18,
    0.013884544061508314,-0.009406954308881848,0.004028913986978492,-0.0011846854932117351,0.00023376684814420458,
    -2.2240456878678845e-05,-3.891571908309753e-06,2.3374538476344624e-06,-5.862807793358669e-07,8.65539545626775e-08},
    {1.3034217682938438,-6.626127564270938e-17,0.009866875293343012,-0.006794368018541049,0.0029829670139832278,
    -0.0009148841765594853,0.00019707613364279653,-2.5660214753679166e-05,-3.784053646546088e-07,1.2509235616686618e-06,
    -3.8637283009718055e-07,7.142620455876758e-08},{1.3055070603963452,5.854361947163641e-17,0.0069755160423084165,
    -0.004870934716518466,0.0021832458650712107,-0.000692504345812626,0.0001590104333482514,-2.4584766032252774e-05,
    1.3792074337577036e-06,5.641328247316417e-07,-2.3318311160350238e-07,5.114009900234243e-08},{1.3069780634821135,
    6.035005848227843e-17,0.0049090899856848065,-0.003469752918113183,0.001582655295146274,-0.0005159071933957364,
    0.00012433426580627928,-2.1450816171459264e-05,2.070380564510371e-06,1.6623268987657252e-07,-1.2843523734830321e-07,
    3.335039992917315e-08},{1.3080113064592747,2.8762930642019465e-17,0.003441023513151667,-0.002458012963716714,
    0.001138043389075144,-0.00037943598651498365,9.496535183110977e-05,-1.7680112815035698e-05,2.1700046298709368e-06,
    -4.198870182008262e-08,-6.252002158393321e-08,2.015620149200594e-08},{1.308734324838216,8.982171571359729e-17,
    0.002403440295366586,-0.0017329224337689487,0.0008127289549660013,-0.0002761358808998924,7.123040930304891e-05,
    -1.4023095160215636e-05,1.9787520368702316e-06,-1.349037368893967e-07,-2.401064545434684e-08,
    1.1289049421078524e-08},{1.309238563750057,-6.137122888857662e-17,0.0016734196302444783,-0.001216578974812188,
    0.0005769926035390184,-0.00019920169203872692,5.266557270044132e-05,-1.0819562898868894e-05,1.6732870047264894e-06,
    -1.6284920631129346e-07,-3.290309910951454e-09,5.745189016580746e-09},{1.3095891687388788,-1.5739492096330522e-17,
    0.0011618341587036208,-0.000850906920954032,0.00040754561692338454,-0.0001426426495267845,3.848958382633736e-05,
    -8.176469849700727e-06,1.3492859466786432e-06,-1.574701461104904e-07,6.6297308245462206e-09,2.4932521169749974e-09},
    {1.309832291969664,1.9369700349625797e-17,0.0008045864065048955,-0.0005931771837757382,0.00028657982425898823,
    -0.00010150034680929613,2.7861831347323603e-05,-6.080363289335052e-06,1.053002892581412e-06,-1.3742226174328236e-07,
    1.0401486637308595e-08,7.1177810634062e-10},{1.3100004721078984,-1.0657052712860774e-16,0.0005558980431726431,
    -0.0004122871271114936,0.000200729676238857,-7.183380386524768e-05,2.0008363652958727e-05,-4.464025548836057e-06,
    8.024149596717255e-07,-1.1298169250077363e-07,1.092930213053477e-08,-1.793324577737854e-10},{1.3101165529705026,
    -5.580225459545538e-18,0.0003832676307636748,-0.0002857970962532502,0.00014010984063129325,-5.0599113387327516e-05,
    1.4271953225017668e-05,-3.243394351743869e-06,6.00488651418022e-07,-8.93276496029423e-08,9.928498164005417e-09,
    -5.602245899492751e-10},{1.310196512304086,9.389546170028567e-17,0.00026373796194174745,-0.00019763770775434297,
    9.749454961395195e-05,-3.549469545296193e-05,1.0121584019864365e-05,-2.3363164061875064e-06,4.4304908074919486e-07,
    -6.870571827239398e-08,8.35565456212727e-09,-6.665901957875503e-10},{1.3102514884790146,-8.91376197690222e-17,
    0.00018116564022359292,-0.0001363740681741674,6.765272753748805e-05,-2.48085123908059e-05,7.142442157000322e-06,
    -1.6707959124891147e-06,3.2318837599703285e-07,-5.177495620401154e-08,6.707262676739508e-09,-6.37709574995915e-10},
    {1.3102892232615186,-2.5623937076723567e-17,0.00012424319946901694,-9.391331801906178e-05,4.682760516738506e-05,
    -1.7283451409028826e-05,5.018276752588851e-06,-1.1875314403691325e-06,2.3356711381424153e-07,
    -3.8407003266471846e-08,5.213791532533947e-09,-5.519540784897887e-10},{1.3103150832712838,-5.967957391025519e-17,
    8.507793684539122e-05,-6.455484611500557e-05,3.2339408719891716e-05,-1.2006072285666536e-05,3.5123640468896936e-06,
    -8.395963727912089e-07,1.6749291570998292e-07,-2.8137501899242493e-08,3.959766825082965e-09,
    -4.5087724203423974e-10},{1.3103327797170259,8.440970485530849e-17,5.8177727785878745e-05,-4.429970393678539e-05,
    2.2287628718331715e-05,-8.318370298056706e-06,2.450025035723425e-06,-5.908825484000952e-07,1.1932536956061212e-07,
    -2.0406606649431585e-08,2.955008517368425e-09,-3.5467433990285226e-10},{1.3103448734233678,7.179514344395406e-17,
    3.9731492261093e-05,-3.035286301452605e-05,1.5331129361074393e-05,-5.749769338535639e-06,1.7038301441267997e-06,
    -4.1417437707986325e-07,8.453415519024177e-08,-1.4676738830635837e-08,2.175152065003455e-09,
    -2.7169321755537207e-10},{1.310353127899078,-8.290827149586945e-17,2.7101275644566922e-05,-2.0767086187784604e-05,
    1.0527621805199475e-05,-3.9657995582470055e-06,1.181683739629739e-06,-2.8928127162322727e-07,5.95969291210966e-08,
    -1.0482003660481349e-08,1.5835896385648652e-09,-2.040757577221979e-10},{1.3103587553646348,-2.2135890532617517e-17,
    1.8465280861718526e-05,-1.4189702767786221e-05,7.2175799892153085e-06,-2.7299854539037695e-06,8.175422405252011e-07,
    -2.014106791565239e-07,4.183838085798405e-08,-7.441642975057969e-09,1.1425687178939324e-09,-1.5098469242468063e-10},
    {1.3103625876907616,3.1725500405507233e-17,1.2567957134892787e-05,-9.68351320085777e-06,4.940953079767445e-06,
    -1.8759015205590675e-06,5.643543954260113e-07,-1.3983413548008135e-07,2.92620453886066e-08,-5.256094226546039e-09,
    8.182007596284249e-10,-1.1037343070013046e-10},{1.3103651948538189,1.1144743459667134e-17,8.545636148186412e-06,
    -6.600708599435507e-06,3.3778041098903096e-06,-1.2868923493376602e-06,3.887872485143403e-07,-9.683548057280214e-08,
    2.0398385300907305e-08,-3.6958756462543816e-09,5.822070407885883e-10,-7.990373201987627e-11},{1.3103669668270588,
    -3.860079336700316e-18,5.805248585649277e-06,-4.4944718072530806e-06,2.306240797754041e-06,-8.814790903723698e-07,
    2.6734076842144785e-07,-6.690385607081964e-08,1.417755947956196e-08,-2.588621092424595e-09,4.1203115974997894e-10,
    -5.738146929062469e-11},{1.3103681700720204,-7.583432924468092e-17,3.940192892742946e-06,-3.0572200986466707e-06,
    1.5727470472692376e-06,-6.029321058763657e-07,1.8351729357698457e-07,-4.612683145361247e-08,9.827696921550554e-09,
    -1.8068079000081612e-09,2.9018279890765355e-10,-4.1138546611411616e-11}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tail_eps_zero_force)

/* duration/beta at zero overlap, beta > exp(2): 64 rows of degree 10 in y = ln(beta), nodes 2.0625 + i 0.125, 2 <= y <= 10.
 * Relative error of the approximation: 2^-57.6 at most, proved for the whole cell of each row. Bits of the rows:
 * 57.6 58.3 57.9 58.1 59.2 59.8 60.5 58.7 60.0 60.5 59.8 60.0 59.8 59.6 59.4 59.2 61.9 60.5 60.2 60.3 59.7 61.3 60.0
 * 60.0 61.9 60.1 62.1 60.6 60.0 60.3 60.6 60.2 61.0 60.6 60.5 61.1 61.9 60.8 64.2 62.4 62.8 60.6 61.9 61.4 61.6 60.6
 * 61.9 60.9 61.4 60.9 62.2 62.0 63.3 61.1 61.3 62.0 61.4 62.2 61.1 61.0 61.9 61.3 60.8 63.5 */
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_FIRST 2.0625
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_STEP 0.125
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_ROWS 64
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_END 10.0
COR_ROWS(double, cor_rows_tail_duration_zero_overlap, 64, 12)
#ifdef COR_ROWS_HERE
= {
    {5.412970041720338,2.0767535940585467e-16,3.1132697328720558,0.19219644326552113,-0.11777451359507461,
    0.060015415448254956,-0.029507887414408303,0.015928949837646707,-0.010023029744951565,0.007249154913188448,
    -0.005869305981803235,0.0051140534659365935},{5.80491560747792,-2.335645337986837e-16,3.1562336873218344,
    0.15313371621181132,-0.09183006271627228,0.044726088254764935,-0.020204138412067984,0.009581532096514208,
    -0.0051534220424081885,0.0031615806938150317,-0.0021601075624368415,0.0015850371451213367},{6.201668514258547,
    -1.3210823509360733e-16,3.190538969327556,0.12252799191218591,-0.07228887821250243,0.03403875190411968,
    -0.014418972611053436,0.006169445219092018,-0.0029101446118849055,0.001551740851475884,-0.0009196284711703843,
    0.0005850376873951717},{6.602267088525965,3.854139215867441e-17,3.218031810021211,0.09835005460873404,
    -0.05730395150870072,0.0262973309559761,-0.010601354550265755,0.004176861259350572,-0.0017630713843197236,
    0.0008314864898676328,-0.0004352871280753426,0.00024494370496499135},{7.005951974460038,8.122240336491797e-17,
    3.2401264284207696,0.07913363805082048,-0.04566235973587384,0.02054263020384115,-0.007967969104500077,
    0.002937507539936482,-0.0011282744417206014,0.0004772034570524698,-0.00022357219234783076,0.00011284270174740868},
    {7.4121198396328545,2.40758479068571e-16,3.257920687048588,0.06379058215353806,-0.03653018447103218,
    0.016181379079419533,-0.006088948523025477,0.0021274852154263943,-0.0007542679063405568,0.00028950648492388417,
    -0.00012261183414334056,5.6081924956310275e-05},{7.820289077828014,-3.288404385842336e-17,3.2722753348711477,
    0.05149717914792477,-0.02931377490040256,0.012827372360003518,-0.004712540647510868,0.0015766162707329388,
    -0.00052236158684568,0.00018388680653723584,-7.09863582136053e-05,2.965710213185401e-05},{8.23007387828756,
    -7.942789698786228e-16,3.2838702830971718,0.04162049538428971,-0.02357900703763358,0.010218737499466819,
    -0.0036833389662759247,0.0011897266963452465,-0.00037232242744194373,0.0001213894650159484,-4.302208113563738e-05,
    1.6520748994125718e-05},{8.64116431793718,3.158588300531786e-16,3.293245686956245,0.03366856474081673,
    -0.019001673200161367,0.008171962679828521,-0.0029011407765097696,0.0009107646030913339,-0.0002717109733751479,
    8.279312693842606e-05,-2.7119433261883885e-05,9.621344897724963e-06},{9.053310897409574,3.713882044191433e-16,
    3.300832586549509,0.027255565477239313,-0.015335606784502458,0.006554954090649587,-0.0022989321913396664,
    0.0007052418993129199,-0.00020216239596577084,5.806080348456543e-05,-1.768965073650147e-05,5.823892061404348e-06},
    {9.46631241935181,-8.012190247202007e-16,3.306976149563666,0.022076797886027254,-0.012391422967897081,
    0.0052705215066348645,-0.001830487083552388,0.0005511242139269362,-0.00015282596203669975,4.169343884841596e-05,
    -1.1889985277954172e-05,3.6472321366828527e-06},{9.880006418934533,7.092281411036929e-16,3.3119535395374187,
    0.017890298557887364,-0.010021885773445193,0.004245859328640991,-0.001463069077660635,0.00043386480985489105,
    -0.00011704757570982766,3.055074660838066e-05,-8.205754111861564e-06,2.354381793045941e-06},{10.294261566834464,
    9.351950723109042e-17,3.3159877995140934,0.01450308211363471,-0.008111563259514286,0.0034256192778910274,
    -0.001172970535473123,0.0003435801663460538,-9.061046414047443e-05,2.2773229150809734e-05,-5.7966672728984e-06,
    1.5618138864824109e-06},{10.708971611340136,-3.446929854241898e-16,3.319258731892247,0.011760690613558649,
    -0.0065693462778223305,0.0027672133204415523,-0.0009426930771437268,0.00027338309044414456,-7.07629262317143e-05,
    1.7223854289590418e-05,-4.179766576373889e-06,1.0619175226056163e-06},{11.124050530693662,1.966821627019834e-16,
    3.3219114827764487,0.009539157613737621,-0.005322932892818988,0.002237546097698758,-0.0007591117971034813,
    0.00021836628534113627,-5.566130494640359e-05,1.3187016709051817e-05,-3.068625446481653e-06,7.383549478411529e-07},
    {11.539428642942,2.0553093617526156e-16,3.3240633524257333,0.0077387666906921235,-0.004314695156654298,
    0.0018106899846035058,-0.0006122476008459769,0.00017496414637581867,-4.40405101788273e-05,1.0200397169048982e-05,
    -2.288517993013612e-06,5.238989577210313e-07},{11.955049477111478,-7.608650438657798e-16,3.325809222304489,
    0.0062791637972941326,-0.0034985389096107255,0.0014661978023539368,-0.0004944261624218062,0.0001405412758505026,
    -3.501348640523603e-05,7.958067187142259e-06,-1.7301018966184699e-06,3.786066483550597e-07},{12.37086725213971,
    1.814234559959558e-16,3.3272258951935663,0.005095504048944457,-0.0028374903233228644,0.0011878569549549425,
    -0.00039968902345122664,0.00011312066642752589,-2.794596508814788e-05,6.253056305939025e-06,-1.3233361040904504e-06,
    2.781474408275203e-07},{12.78684484254154,-4.343700680817723e-16,3.328375576067656,0.004135397337445032,
    -0.0023018229979764075,0.000962755593726081,-0.00032337301986755656,9.120008862882889e-05,-2.2376370059660548e-05,
    4.942438982494224e-06,-1.0223714851692712e-06,2.0736345201157907e-07},{13.20295213490206,2.1931517093587925e-16,
    3.3293086703546497,0.003356476326100383,-0.001867592805818019,0.0007805735377207463,-0.0002618045366737356,
    7.362546616213071e-05,-1.7963465157785812e-05,3.925621241461284e-06,-7.965789564324961e-07,1.5661012617011723e-07},
    {13.619164698849382,-4.0957690896030815e-16,3.3300660376846576,0.00272445294154192,-0.0015154840351234182,
    0.0006330378466963998,-0.00021207367813354,5.9501861106007177e-05,-1.4451427321177752e-05,3.130546576917984e-06,
    -6.251036097948492e-07,1.1962862188027324e-07},{14.035462711505971,6.287024836274501e-16,3.3306808098559095,
    0.0022115606272847983,-0.0012298956624114325,0.000513500846040641,-0.0001718650951264602,4.812977904218221e-05,
    -1.1646093529384827e-05,2.504756995039874e-06,-4.934876354450189e-07,9.228325442159198e-08},{14.4518300865325,
    7.579926530144783e-16,3.3311798590937944,0.001795302770259512,-0.0009982144783455135,0.00041661043912247394,
    -0.00013932967256411662,3.895884201795075e-05,-9.398511333224483e-06,2.0094934806498658e-06,-3.915344120484238e-07,
    7.179367955301099e-08},{14.868253768491137,6.390537685954728e-16,3.3315849850616464,0.0014574451433103112,
    -0.0008102346871488437,0.00033805078839124595,-0.0001129861496930136,3.1553587930591406e-05,-7.593348995097067e-06,
    1.6157340724047686e-06,-3.1193529513044e-07,5.625812703003593e-08},{15.284723160915291,3.7197840746559583e-16,
    3.331913875276623,0.001183203490024783,-0.0006576930369264234,0.0002743371975011208,-9.164498247115506e-05,
    2.5567880437514288e-05,-6.14059569593548e-06,1.3014868332481205e-06,-2.4937249821196737e-07,4.435431375276997e-08},
    {15.701229662597441,3.9340444429579445e-16,3.3321808826985433,0.0009605876042856311,-0.0005338955454683192,
    0.00022265310610039034,-7.43489457886225e-05,2.0725529873398626e-05,-4.969527370968211e-06,1.04990960543083e-06,
    -1.999222416013624e-07,3.5149158027327576e-08},{16.11776629151781,9.481629129159155e-16,3.3323976556314796,
    0.0007798711987283243,-0.00043341715622172936,0.00018072004876856304,-6.0326478711454915e-05,1.6805460322930363e-05,
    -4.0242575052929405e-06,8.479842519976386e-07,-1.6065124520561067e-07,2.7974404375961012e-08},{16.53432737978367,
    2.555724294481929e-16,3.332573648209487,0.0006331630704818262,-0.0003518596685252469,0.0001466935796527856,
    -4.8954828022767796e-05,1.3630249987811949e-05,-3.2604132873113686e-06,6.855678672024307e-07,-1.293408063719072e-07,
    2.2344021137345722e-08},{16.950908326127276,-4.0842445423766407e-16,3.332716534250683,0.0005140599659257568,
    -0.0002856563674807311,0.00011907975853867546,-3.97307917382422e-05,1.1057206148338359e-05,-2.642622983730533e-06,
    5.547033266482129e-07,-1.0429543429935561e-07,1.7899677887535523e-08},{17.367505395073657,5.647525019904394e-16,
    3.3328325428671812,0.0004173654200857537,-0.0002319141677481344,9.666799109105298e-05,-3.224740186360123e-05,
    8.971365830842293e-06,-2.142596761545875e-06,4.4911140277498727e-07,-8.420741374141397e-08,1.4374320653903494e-08},
    {17.784115553959083,8.119032811216892e-16,3.3329267306869275,0.0003388619268388374,-0.0001882859517396068,
    7.847692490958672e-05,-2.6175278571091737e-05,7.279974025497043e-06,-1.7376470613928035e-06,3.638124160851667e-07,
    -6.805954718667625e-08,1.1566630270536627e-08},{18.20073634065412,-9.692211215338783e-16,3.333003202701336,
    0.0002751262549155116,-0.00015286725004402287,6.371080009110985e-05,-2.1247678787901987e-05,5.908105770349274e-06,
    -1.4095381614539479e-06,2.9484112795470303e-07,-5.505501727068375e-08,9.322847452099565e-09},{18.61736575619852,
    1.6428867709973816e-15,3.3330652914615007,0.00022337969330321755,-0.0001241125720600235,5.1724192376475496e-05,
    -1.7248479893731407e-05,4.795180765211608e-06,-1.1435853133860888e-06,2.390291637396945e-07,-4.456617110718272e-08,
    7.524424942539694e-09},{19.034002177650905,8.21360941416571e-16,3.333115702496366,0.00018136658981689842,
    -0.00010076761631456348,4.199350765067674e-05,-1.4002504173825096e-05,3.892178863652388e-06,-9.279452900347618e-07,
    1.938373839761047e-07,-3.60960731999734e-08,6.079568898803265e-09},{19.450644287343582,-7.39256483902956e-16,
    3.3331566323318045,0.00014725581762524913,-8.181432470944218e-05,3.409391681500315e-05,-1.1367716078091274e-05,
    3.1594088943020317e-06,-7.530547885992979e-07,1.572260781605107e-07,-2.9249292608664075e-08,4.91669294750255e-09},
    {19.867291015452103,-1.6001629782071343e-15,3.3331898642808393,0.00011956082865177301,-6.6426332722953e-05,
    2.7680680718987965e-05,-9.228921938104354e-06,2.564716558466313e-06,-6.111836690275771e-07,1.2755372376824634e-07,
    -2.3710025173764567e-08,3.979271113862988e-09},{20.28394149337206,-1.0697285185289959e-15,3.3332168461969673,
    9.707477912798141e-05,-5.3932839079092765e-05,2.2474021635531235e-05,-7.492677605284625e-06,2.0820422918636872e-06,
    -4.960782416588213e-07,1.0349712303358238e-07,-1.9225576173956867e-08,3.2224269102027764e-09},{20.7005950158684,
    -6.808066737234764e-16,3.333238753590248,7.88178801207069e-05,-4.378929741450097e-05,1.824686254171151e-05,
    -6.0831688980040176e-06,1.6902588587695373e-06,-4.0267584273083576e-07,8.398805979525804e-08,-1.559323784891994e-08,
    2.610728020600375e-09},{21.117251010346006,-1.4654966457172014e-15,3.3332565408638875,6.39946656214237e-05,
    -3.555363769657355e-05,1.4814887158931464e-05,-4.938876739156971e-06,1.3722330235025347e-06,-3.268758682360752e-07,
    6.816324122039613e-08,-1.2649773833354261e-08,2.11609345255715e-09},{21.53390901190122,-6.360600423714137e-16,
    3.3332709829087177,5.1959307571874675e-05,-2.8866971328508753e-05,1.2028479196577854e-05,-4.009876078466693e-06,
    1.1140672837351419e-06,-2.653554465227525e-07,5.532458348930617e-08,-1.0263523544706002e-08,1.7158147068950812e-09},
    {21.950568643066582,-1.0041622299923279e-15,3.333282708871067,4.218746087198556e-05,-2.3437932699313697e-05,
    9.766184001113383e-06,-3.255647147739111e-06,9.044867155798215e-07,-2.154208079073705e-07,4.4907162574662434e-08,
    -8.32846187220075e-09,1.391496078829686e-09},{22.367229597365647,-7.069521287725895e-16,3.3332922295673546,
    3.425340793153834e-05,-1.9029970652150853e-05,7.929404097098184e-06,-2.643301142691098e-06,7.343427778794411e-07,
    -1.748875584930039e-07,3.64533086228057e-08,-6.759069714084883e-09,1.128641816093283e-09},{22.783891625961097,
    -1.4504038729680601e-15,3.3332999597411743,2.781150453976293e-05,-1.5451033347206285e-05,6.438095142265422e-06,
    -2.146141445372928e-06,5.962113620177312e-07,-1.4198408249213087e-07,2.9592120910670407e-08,-5.485939908144632e-09,
    9.157604579100501e-10},{23.200554526814216,-6.818254278620713e-16,3.333306236133426,2.2581117096072008e-05,
    -1.254519524743854e-05,5.227273180897355e-06,-1.742496726091232e-06,4.840670716775045e-07,-1.1527320109526086e-07,
    2.4023169083222708e-08,-4.452793005074754e-09,7.432035426227345e-10},{23.61721813588332,-5.864506592822887e-16,
    3.3333113321533197,1.833439392281261e-05,-1.0185860230804576e-05,4.244179955225096e-06,-1.414774328947111e-06,
    3.9301935659989536e-07,-9.358868441988644e-08,1.9502911520201487e-08,-3.6143987323383992e-09,6.030149600808307e-10},
    {24.03388231997759,-1.3450604833865932e-15,3.333315469789776,1.4886337220405836e-05,-8.270243925598347e-06,
    3.445982123083068e-06,-1.1486921465759839e-06,3.190985994204709e-07,-7.598415535655289e-08,1.5833561542549088e-08,
    -2.9341826799883312e-09,4.892934243023323e-10},{24.45054697095494,1.1573437540353437e-15,3.333318829282379,
    1.2086742699061362e-05,-6.714894355004041e-06,2.797903730007627e-06,-9.326553060034623e-07,2.590824444968145e-07,
    -6.169174302141667e-08,1.2854688699859058e-08,-2.3820374662785627e-09,3.973465823028162e-10},{24.867212001011143,
    -3.055850733026305e-16,3.333321556973348,9.81365545178104e-06,-5.452055397198572e-06,2.271710239020066e-06,
    -7.572504000583143e-07,2.1035493622360438e-07,-5.008815832667416e-08,1.0436480108793209e-08,-1.933620925126529e-09,
    3.2260439711739774e-10},{25.283877338854918,1.0869882270739211e-15,3.333323771682691,7.968056791088795e-06,
    -4.426714428094624e-06,1.844477857175328e-06,-6.148349556986098e-07,1.7079246744374358e-07,-4.066727499990895e-08,
    8.473432702821088e-09,-1.5698237029962817e-09,2.6154917353673465e-10},{25.7005429266024,-1.4087589537247111e-15,
    3.333325569884321,6.469550461533355e-06,-3.594205386630878e-06,1.4975944830324126e-06,-4.992041090758425e-07,
    1.386711066208651e-07,-3.3018437604155284e-08,6.879512772880515e-09,-1.2747361559627595e-09,2.1242636593144076e-10},
    {26.117208717255632,1.4774037466731945e-15,3.3333270299086712,5.2528602258280765e-06,-2.9182627265767974e-06,
    1.2159486702683432e-06,-4.053201321606863e-07,1.1259113010262445e-07,-2.680846885054032e-08,5.5853878775941575e-09,
    -1.0347157770597397e-09,1.7289061312662245e-10},{26.533874672655337,3.3789282407770114e-16,3.3333282153549066,
    4.264986201959555e-06,-2.369441423849574e-06,9.872711336843747e-07,-3.290929493011878e-07,9.141611409524296e-08,
    -2.1766488750003908e-08,4.535076376023993e-09,-8.398691607306357e-10,1.3980518511765454e-10},{26.950540761818623,
    4.3874774265756855e-16,3.333329177861396,3.4628960368208142e-06,-1.9238341922227947e-06,8.016001322084542e-07,
    -2.6720176080091633e-07,7.422364463157533e-08,-1.7672643965829898e-08,3.6820888818735563e-09,-6.824537643342772e-10,
    1.1330705517872136e-10},{27.36720695958938,1.488383304322959e-15,3.3333299593551367,2.8116503138680057e-06,
    -1.562029971164622e-06,6.508474984938534e-07,-2.1695028051932967e-07,6.02646423692038e-08,-1.4349048231725351e-08,
    2.9892107448768185e-09,-5.537631910917519e-10,9.326744104533172e-11},{27.783873245542473,-9.313823558542355e-16,
    3.3333305938781375,2.282880527371034e-06,-1.2682682908411935e-06,5.284462356125523e-07,-1.7614947281155994e-07,
    4.8930763715270584e-08,-1.165049726210584e-08,2.4275345922178707e-09,-4.490122276119088e-10,7.427084298623682e-11},
    {28.200539603093983,-7.418925090127732e-16,3.3333311090703104,1.8535533086443784e-06,-1.0297527138953485e-06,
    4.29064359679224e-07,-1.4302196818494328e-07,3.9728605721211405e-08,-9.459075354010271e-09,1.970777418916924e-09,
    -3.6621032932212977e-10,5.999350546701652e-11},{28.61720601877884,-1.036585130027042e-15,3.3333315273734865,
    1.5049670596822431e-06,-8.360933909062917e-07,3.4837272459369045e-07,-1.1612453066466111e-07,3.225706126598671e-08,
    -7.680599704354663e-09,1.5994777326772755e-09,-2.953441992129894e-10,5.286023966913974e-11},{29.033872481664268,
    6.590201582288256e-16,3.3333318670089893,1.2219372963224844e-06,-6.788544333980107e-07,2.828563408895664e-07,
    -9.428568329669712e-08,2.6190423673465356e-08,-6.23573540513833e-09,1.3005681140509206e-09,-2.4056903669425617e-10,
    3.3425862706186943e-11},{29.450538982873553,-1.5803719947886607e-15,3.333332142771366,9.921351992836168e-07,
    -5.511864740019604e-07,2.2966122560620984e-07,-7.655387136698783e-08,2.12653131198061e-08,-5.063064744571149e-09,
    1.0523984093294272e-09,-1.9832537469308094e-10,4.3111482205411e-11},{29.867205515199363,-1.6730249805282978e-15,
    3.333332366672841,8.055505588978251e-07,-4.475282532353524e-07,1.8647026497231109e-07,-6.215684687806413e-08,
    1.7265383417393715e-08,-4.1114055489072735e-09,8.610218685127753e-10,-1.4919059107732028e-10,8.372186745617476e-12},
    {30.28387207278981,-1.6439892696318761e-15,3.3333325484665726,6.540557326168637e-07,-3.633644070849956e-07,
    1.514018950313608e-07,-5.046732601937551e-08,1.401966273015434e-08,-3.337140285081171e-09,6.834269321349876e-10,
    -1.546006533580062e-10,7.723512745317087e-11},{30.700538650893527,9.209123690599004e-16,3.3333326960715013,
    5.310515911534452e-07,-2.9502872694078933e-07,1.2292873111630938e-07,-4.0976593741729675e-08,1.1380404708685587e-08,
    -2.7061052173487195e-09,6.121400456750133e-10,-6.035492468058083e-11,-4.1236572251048246e-10},{31.117205245652723,
    -5.959381264293424e-16,3.333332815917302,4.311800678870404e-07,-2.395445369855046e-07,9.981039623935229e-08,
    -3.3269001353548265e-08,9.237725695776113e-09,-2.2652481964921504e-09,3.1819731881844524e-10,1.0568640842285874e-09,
    6.942466903377565e-09},{31.5338718539351,2.846533688750161e-16,3.333332913224459,3.500907534890428e-07,
    -1.9449490370913764e-07,8.104091718547596e-08,-2.699634392907728e-08,7.462076529093691e-09,-4.357778526248871e-09,
    -3.002172013259203e-08,-2.420507622987075e-07,-1.0738140188326988e-06}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tail_duration_zero_overlap)

/* duration beta^(2/3) at zero force, beta > exp(2): 32 rows of degree 10 in y = ln(beta), nodes 2.125 + i 0.25, 2 <= y <= 10.
 * Relative error of the approximation: 2^-57.7 at most, proved for the whole cell of each row. Bits of the rows:
 * 57.7 58.6 59.1 58.1 61.4 59.3 60.8 61.1 59.8 62.3 61.0 61.8 59.3 59.0 59.9 62.2 60.7 61.3 60.3 62.6 59.9 61.3 59.7
 * 61.2 60.2 59.7 61.5 60.5 60.0 64.8 59.9 60.1 */
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_FIRST 2.125
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_STEP 0.25
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_PER_UNIT 4.0
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_ROWS 32
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_END 10.0
COR_ROWS(double, cor_rows_tail_duration_zero_force, 32, 12)
#ifdef COR_ROWS_HERE
= {
    {7.116392257195245,1.6416536329118285e-16,2.521835045630425,0.16012942065521507,-0.030840255875556038,
    0.000692079128391557,0.000831145382970818,-7.91668752784876e-05,-2.636527115567373e-05,2.944629939027579e-06,
    1.8071607009454084e-06,-3.7886930707424623e-07},{7.756380722609651,2.761464727116771e-17,2.596176188979999,
    0.13738346933993434,-0.029656859964338818,0.0016433804358746728,0.0006811570954553583,-0.00011811772254500096,
    -1.719315779380196e-05,5.808244339535233e-06,7.052565602822163e-07,-4.5518158234361617e-07},{8.413554903102922,
    4.905080314986902e-16,2.6594225589702507,0.11585629021745793,-0.027626689941784393,0.0023763410130459716,
    0.00048673460273410905,-0.000137476603005002,-4.803637380374494e-06,6.204186582699229e-06,-2.931570099880472e-07,
    -3.2234495728405255e-07},{9.085229618099014,8.599239622579415e-16,2.712327916804351,0.0960953406960697,
    -0.024989426946298306,0.0028548928974133853,0.0002794264852415291,-0.00013564705502820354,6.424285576747449e-06,
    4.811928196845667e-06,-8.580763760313855e-07,-1.2982690781718858e-07},{9.768938488445563,1.431989532716319e-16,
    2.7558731763537976,0.07845973031785661,-0.022001159159537306,0.0030817247052141103,8.815000628846487e-05,
    -0.00011719076075399183,1.3950071599600754e-05,2.6710260514636397e-06,-9.759730792063429e-07,
    2.4669834205715618e-08},{10.462478843915612,7.366115016613655e-16,2.7911714919914075,0.06312171672735939,
    -0.018898929267231544,0.0030902869785387455,-6.746008142750357e-05,-8.934897667257933e-05,1.7188078471322565e-05,
    6.356478122065997e-07,-7.969995862584197e-07,1.0628793702514867e-07},{11.163933513235772,1.0204710495049171e-16,
    2.819380132523987,0.05009095662339203,-0.0158763572412257,0.0029316783483543133,-0.0001787328512637252,
    -5.911114363113074e-05,1.68801151019196e-05,-8.307988714367522e-07,-4.991107248195434e-07,1.2331793242066916e-07},
    {11.87167242698297,1.7252142570481848e-16,2.8416282148976957,0.03925201700394802,-0.013072606102954425,
    0.0026617945722499357,-0.0002461870823958153,-3.158061236898921e-05,1.4320760025004239e-05,-1.6207052393159027e-06,
    -2.1290763639993753e-07,1.0149884318013326e-07},{12.58433862265627,-3.02140975065684e-16,2.858964502189184,
    0.03040570044186064,-0.010572681759156771,0.0023318212140900846,-0.00027626109219052933,-9.556655324002559e-06,
    1.077564863520198e-05,-1.8456282122421968e-06,-3.056204925271184e-09,6.571466050354428e-08},{13.300823743515503,
    3.4640485125825467e-16,2.8723252792019065,0.023307104726870236,-0.008415137486910258,0.001982926541580484,
    -0.0002780545265622421,6.115549579650493e-06,7.18514875326061e-06,-1.6997163674051324e-06,1.1775946272486104e-07,
    3.2119736908165295e-08},{14.0202377470135,-3.905870504410017e-16,2.8825195427429233,0.01769639738992494,
    -0.006603191892113009,0.0016445722990650847,-0.00026087304610936514,1.5891899258509323e-05,4.098865735511349e-06,
    -1.3688985993338534e-06,1.654598596038081e-07,7.769669768604502e-09},{14.741876656124278,5.808244828125568e-16,
    2.890227433026191,0.013320962904581447,-0.005116210059759007,0.0013352675621770805,-0.00023277047920236421,
    2.089033666836705e-05,1.7404355131306884e-06,-9.89839848941442e-07,1.6515908858534125e-07,-6.4696579620746684e-09},
    {15.4651911275461,-8.411007246183173e-16,2.8960076579342786,0.009949413635424906,-0.003919708664711264,
    0.0010645902355832962,-0.00019993736371144426,2.2414099338419783e-05,1.1660817952349289e-07,-6.436223380250749e-07,
    1.3983207153407786e-07,-1.2709359864138856e-08},{16.189757603708284,-3.472459245403127e-16,2.900310182476785,
    0.007378924878293366,-0.002973091358150242,0.0008355860681406622,-0.00016666072702350355,2.1664573958088628e-05,
    -8.808449001493991e-07,-3.6662762337779877e-07,1.0591882249789875e-07,-1.379421293245065e-08},{16.9152529840636,
    1.689644516564446e-15,2.9034912845937297,0.005437659458122972,-0.002235036471292396,0.0006470010666041307,
    -0.00013559200428608708,1.9609346088609544e-05,-1.4011790041102533e-06,-1.660448321178586e-07,7.311256562251691e-08,
    -1.2166158373096126e-08},{17.641433136116802,-2.0090203858708848e-17,2.905828946702177,0.003983940521307919,
    -0.0016668517228679168,0.0004950915370572044,-0.00010812924594973555,1.6953047447121507e-05,-1.5904802948813195e-06,
    -3.345830417326378e-08,4.593135978981801e-08,-9.508182581279028e-09},{18.368115156914616,6.822086203091636e-16,
    2.907537310192295,0.0029035264520383785,-0.001234261541303207,0.00037494969902790296,-8.4796093604176e-05,
    1.4164046369287952e-05,-1.5706638775855047e-06,4.5657323562119026e-08,2.5604353082123426e-08,-6.7943752847835e-09},
    {19.09516305473088,-8.754240543141864e-16,2.908779507895581,0.002105985121110136,-0.000908094901648606,
    0.0002813897195133666,-6.556055466994341e-05,1.1523678923591215e-05,-1.4334015036959925e-06,8.636924991648093e-08,
    1.1613440813835991e-08,-4.483319661605835e-09},{19.822476404673885,-1.7486643468193604e-16,2.9096786041554594,
    0.0015208376856081219,-0.0006642704220645453,0.00020948341068137077,-5.007612255892614e-05,9.178222243069906e-06,
    -1.2420933103452924e-06,1.0161817970809133e-07,2.7273237797974126e-09,-2.7164558429847282e-09},{20.54998150040139,
    -9.350921258432308e-16,2.9103266386638453,0.001093879766611776,-0.00048338061676129145,0.00015484156173060449,
    -3.784939811285402e-05,7.183947804671721e-06,-1.0372043053228433e-06,1.0135581049429576e-07,-2.4060862000484727e-09,
    -1.469246096195475e-09},{21.2776245443103,-9.733527743066737e-16,2.910791923403044,0.000783896271498912,
    -0.00035008626701600907,0.00011372489262777284,-2.8347633679846333e-05,5.541988086189956e-06,-8.422521704270251e-07,
    9.26401823270599e-08,-4.976511378440263e-09,-6.483723451585952e-10},{22.005366466437742,9.654975473297625e-16,
    2.911124815582515,0.0005598571632572692,-0.0002524569659743245,8.305004686451398e-05,-2.106163567351871e-05,
    4.223190296570741e-06,-6.69128853682465e-07,8.013695751918792e-08,-5.91450647698801e-09,-1.4598829238668e-10},
    {22.733179021603636,1.280687389103175e-16,2.911362211390918,0.0003986015906967597,-0.00018133791654142864,
    6.0337492532507883e-05,-1.5537897061265088e-05,3.184621957547897e-06,-5.222891906166897e-07,6.671498925702582e-08,
    -5.891745247555849e-09,1.346118514388959e-10},{23.461041874912056,-1.440477042929104e-15,2.9115309967447285,
    0.00028297324772375774,-0.0001297842932822802,4.3632602735339956e-05,-1.1390953681068325e-05,2.379770149288882e-06,
    -4.0178851053732207e-07,5.398650291800468e-08,-5.362572787684191e-09,2.699959980143004e-10},{24.18894044191979,
    1.3157847953974263e-15,2.9116506666546567,0.00020034897458328933,-9.257944601106067e-05,3.141933340059143e-05,
    -8.303978180989828e-06,1.7643099109190108e-06,-3.0534564917451807e-07,4.2737689065342417e-08,-4.616097121432814e-09,
    3.1611098020266595e-10},{24.91686429887568,-1.7275466210204362e-15,2.9117352938532535,0.00014149654129892738,
    -6.583825372852002e-05,2.253754966746052e-05,-6.023077880479417e-06,1.2989478503131181e-06,-2.2966081741978514e-07,
    3.324484204664866e-08,-3.824247003202324e-09,3.1140018842164065e-10},{25.644806019609103,-1.369295795964931e-15,
    2.9117949956441986,9.969994566309667e-05,-4.6688863557104294e-05,1.6109505822697412e-05,-4.348803127957384e-06,
    9.504524415317194e-07,-1.7120280667097743e-07,2.5492434975938786e-08,-3.080462458708249e-09,2.808836440475914e-10},
    {26.37276032915611,1.4911432270925508e-15,2.9118370186501754,7.009720945480535e-05,-3.302241695898288e-05,
    1.1477530269031852e-05,-3.126970641719543e-06,6.916409101174131e-07,-1.2663945974239073e-07,1.931555137556993e-08,
    -2.428367927061448e-09,2.3996791124041636e-10},{27.10072349086082,-1.7747732635913027e-15,2.911866535668985,
    4.918393702678054e-05,-2.3299411296800276e-05,8.15296921840694e-06,-2.2399600851099784e-06,5.00827447508446e-07,
    -9.304093519944499e-08,1.4487913186684916e-08,-1.8817815829639938e-09,1.9753429368769902e-10},{27.828692864497707,
    1.4023131745654464e-15,2.9118872275915897,3.444428057730803e-05,-1.640187385793306e-05,5.7754029689581395e-06,
    -1.599037195651542e-06,3.610459168762301e-07,-6.794649397235423e-08,1.0772853246870697e-08,-1.4379947231665039e-09,
    1.5824211235815697e-10},{28.55666658896663,1.0234877133262182e-15,2.9119017061164727,2.407863392540449e-05,
    -1.1521771061264544e-05,4.080705451093074e-06,-1.1378919061274412e-06,2.5922923827210644e-07,-4.935521730849547e-08,
    7.950237266141548e-09,-1.0861742128660827e-09,1.2415148824614316e-10},{29.28464335527212,1.2206186308803115e-15,
    2.9119118193593123,1.6804003653382857e-05,-8.077573305182259e-06,2.8764232793651957e-06,-8.073754049122752e-07,
    1.854423475614303e-07,-3.567900570329081e-08,5.828507128953525e-09,-8.121584192585847e-10,9.707477793821778e-11}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tail_duration_zero_force)

/* largest overlap beta^(2/3), beta > exp(2): 32 rows of degree 10 in y = ln(beta), nodes 2.125 + i 0.25, 2 <= y <= 10.
 * Relative error of the approximation: 2^-60.3 at most, proved for the whole cell of each row. Bits of the rows:
 * 61.0 60.3 61.6 61.7 61.5 62.4 63.9 63.2 63.2 64.6 64.5 65.1 65.2 65.6 66.1 66.1 66.3 66.7 66.7 66.7 66.8 66.8 66.7
 * 66.8 66.8 66.8 66.8 66.8 66.8 66.8 66.8 66.8 */
#define COR_ROWS_TAIL_MAX_OVERLAP_FIRST 2.125
#define COR_ROWS_TAIL_MAX_OVERLAP_STEP 0.25
#define COR_ROWS_TAIL_MAX_OVERLAP_PER_UNIT 4.0
#define COR_ROWS_TAIL_MAX_OVERLAP_ROWS 32
#define COR_ROWS_TAIL_MAX_OVERLAP_END 10.0
COR_ROWS(double, cor_rows_tail_max_overlap, 32, 12)
#ifdef COR_ROWS_HERE
= {
    {1.2216815339498734,-8.305414606231744e-17,0.09964647207822826,-0.04698481679807967,0.009569647503983519,
    0.0008079794779230748,-0.000961601945759969,0.00018259446158077586,2.7319103295113793e-05,-2.011174142644828e-05,
    2.8103846852772187e-06,7.805161159060359e-07},{1.2438083897179266,4.8858415856121845e-17,0.07798119718617828,
    -0.03964371084263788,0.009836384390295286,-0.0002130198086775666,-0.000667911261596775,0.00019938931146191942,
    -5.552004209063414e-06,-1.2474602560604936e-05,3.5956938814820395e-06,-7.593153864234783e-08},{1.2609782143906214,
    -1.208129558594106e-17,0.059978458165177384,-0.032439174459344224,0.009266860756321103,-0.0008669932667013559,
    -0.00038529710185940784,0.0001724224102361162,-2.2778271407355084e-05,-5.042470906390201e-06,2.8456403277560923e-06,
    -4.4901942775069933e-07},{1.2740864529068943,-9.990682000801114e-17,0.04543566418521213,-0.02586474682807991,
    0.008209603816442623,-0.0012004778510753729,-0.0001596859309810274,0.00012708717613090664,-2.7344638478883222e-05,
    2.2909239354246768e-08,1.6510634561315522e-06,-4.6536791874346666e-07},{1.2839522813905433,-7.792729169707374e-17,
    0.033965140895483775,-0.020175784881121976,0.006945330248911679,-0.0012957089654646464,-4.2231196189245696e-06,
    8.107564488770065e-05,-2.440645235760486e-05,2.5369116053404648e-06,6.458778808867293e-07,-3.275021109802125e-07},
    {1.2912860537022723,1.822413049099841e-17,0.025098868241090342,-0.015449069371459569,0.005669130842146109,
    -0.0012375694412984227,8.781949558037842e-05,4.340645309028376e-05,-1.842340218111803e-05,3.213564168335833e-06,
    2.421539134301152e-08,-1.7410711746470156e-07},{1.2966790451236039,-1.430065413340517e-17,0.018361887138178958,
    -0.011645400553143382,0.004497669326203122,-0.0010963033157633504,0.0001315338490500896,1.6696944183075854e-05,
    -1.2212777144573498e-05,2.8910529126289004e-06,-2.6135861366587717e-07,-6.286632132200368e-08},{1.3006078048470504,
    7.643732696094851e-17,0.013316628259268957,-0.008661963109207723,0.003487275081638911,-0.0009221558911982964,
    0.00014293824982970288,6.076123765762671e-10,-7.103459805513969e-06,2.1927823953819333e-06,-3.3177114216884175e-07,
    -7.369756165961743e-10},{1.3034466149061597,-7.177825371763911e-17,0.009584656691010574,-0.006370112534378822,
    0.0026535977432436317,-0.0007468082749952055,0.00013537233455405823,-9.023905235192229e-06,-3.4505465994580606e-06,
    1.4743772518281367e-06,-2.953361483653471e-07,2.5280968057404623e-08},{1.3054833220976616,8.534300217510236e-17,
    0.00685306038336862,-0.004639405462666685,0.0019881802183478246,-0.0005875716168537785,0.00011845894376550993,
    -1.284758211275907e-05,-1.1146089186006904e-06,8.891342012474413e-07,-2.2258983734973728e-07,
    3.0593549870614094e-08},{1.3069355069570328,9.258364235088444e-17,0.004871655089259993,-0.0033508704815643836,
    0.001470522466650444,-0.0004519348052856306,9.840054525304727e-05,-1.3509522198585042e-05,2.1918085225096602e-07,
    4.719576775367119e-07,-1.5007746612579842e-07,2.6545621787415367e-08},{1.3079652956835495,-6.79395011910601e-17,
    0.0034455401993507286,-0.0024028632625817613,0.0010759191652716048,-0.00034136752749454183,7.876934453316742e-05,
    -1.2476178659473202e-05,8.723342482938241e-07,2.0295562991797922e-07,-9.209067171525008e-08,1.9724574840427334e-08},
    {1.308692053482782,-3.9990618518974014e-17,0.0024259748802266646,-0.0017123409395304091,0.0007800122872741726,
    -0.0002540800701221024,6.133689436876551e-05,-1.0700107539817218e-05,1.1050487915949857e-06,4.510022155526797e-08,
    -5.111669305036869e-08,1.3242397382008226e-08},{1.309202778440765,8.306675241507134e-17,0.0017013139042239107,
    -0.0012136319531183336,0.000561076584842917,-0.00018682929027870926,4.675447921338447e-05,-8.744389696932895e-06,
    1.102645635584954e-06,-3.761491310146102e-08,-2.465890824736502e-08,8.185349167895498e-09},{1.3095603355299241,
    8.808552450415567e-17,0.0011888867563985192,-0.0008560701705934976,0.0004008844691467012,-0.0001359939703100721,
    3.504194266295332e-05,-6.906821807893258e-06,9.855470810763326e-07,-7.360360698776771e-08,-8.899382200368512e-09,
    4.6571413864027095e-09},{1.3098098180201572,1.0512384614325108e-16,0.0008281634765008756,-0.0006013142588734265,
    0.0002847638985958918,-9.81487139245837e-05,2.5907511644415035e-05,-5.319166492103006e-06,8.259092450898076e-07,
    -8.283892030626553e-08,-3.183702154933466e-10,2.3857376000032435e-09},{1.309983366841431,-3.707997376980949e-17,
    0.0005752414935871783,-0.0004207943516984623,0.00020125353680778017,-7.032195136734017e-05,1.894065789768398e-05,
    -4.017490662183061e-06,6.632913510211534e-07,-7.825428549372176e-08,3.7888039901293816e-09,1.0223506288173396e-09},
    {1.3101037650144456,-2.443804196944289e-17,0.00039853172457083056,-0.0002934877762090691,0.00014160052019490256,
    -5.00706734584861e-05,1.3718603526319439e-05,-2.9879993434699757e-06,5.168274242699915e-07,-6.765400575090824e-08,
    5.296947417881346e-09,2.624668418443971e-10},{1.3101870845772496,-9.94310653321741e-17,0.00027545980153029665,
    -0.00020408528657971675,9.923729454117116e-05,-3.5458865178720995e-05,9.858398061433878e-06,-2.194848951886908e-06,
    3.9372254420532346e-07,-5.541292060989124e-08,5.414077855875578e-09,-1.2161632639712856e-10},{1.310244615383452,
    1.61794231064027e-17,0.0001899883048342444,-0.00014153491245942002,6.930494670329654e-05,-2.4992714796822122e-05,
    7.037026256669269e-06,-1.5958331033507281e-06,2.947564483284149e-07,-4.375985780679368e-08,4.871925315128764e-09,
    -2.854434786099259e-10},{1.3102842582894612,6.410167005868263e-17,0.00013078205579612626,-9.791668479871227e-05,
    4.824967885877418e-05,-1.75427117624841e-05,4.9941796286845125e-06,-1.1504394985163186e-06,2.1763275341215173e-07,
    -3.3659983396777254e-08,4.0869076793385156e-09,-3.286261508521309e-10},{1.3103115239946692,-9.402180699781473e-17,
    8.986526645622145e-05,-6.75907687344254e-05,3.349681212543037e-05,-1.226822420775414e-05,3.526641599659592e-06,
    -8.233922290899881e-07,1.5889411443514368e-07,-2.5382597407572538e-08,3.2785724779471586e-09,
    -3.1158898802205565e-10},{1.3103302446054614,-3.983941698194295e-17,6.164808509659132e-05,-4.6562859558168856e-05,
    2.3195829517625976e-05,-8.551510106990868e-06,2.479430267298712e-06,-5.856940997524076e-07,1.1493806187600117e-07,
    -1.8847000155769495e-08,2.5498885975205114e-09,-2.6907289466654184e-10},{1.3103430777635772,-1.0314540485824298e-16,
    4.222658610614739e-05,-3.201747703275811e-05,1.6025667767813328e-05,-5.943306978613479e-06,1.736444673477206e-06,
    -4.1440163099257617e-07,8.249813372653061e-08,-1.3822180626927423e-08,1.9385914476487673e-09,
    -2.1983186901945238e-10},{1.310351862102211,8.868614489706355e-17,2.8882824907397065e-05,-2.197832670948642e-05,
    1.1048699519417478e-05,-4.1196884587500155e-06,1.2119283321863882e-06,-2.918475918195904e-07,5.882448619268991e-08,
    -1.0035154756751321e-08,1.4484680501942653e-09,-1.7311937574146423e-10},{1.31035786682213,-2.0672197433173618e-17,
    1.9729868437184216e-05,-1.5063281057131817e-05,7.602785973514372e-06,-2.8487899094226236e-06,8.432551072931135e-07,
    -2.047009289121686e-07,4.17072019186419e-08,-7.224820769909436e-09,1.0675527515937582e-09,-1.328104109824736e-10},
    {1.3103619662755734,-1.026118380186336e-16,1.3461039206952125e-05,-1.0308915186257004e-05,5.222389458706846e-06,
    -1.9656703042823516e-06,5.851166701637659e-07,-1.4305938436676468e-07,2.9425893170786165e-08,-5.164852638040903e-09,
    7.78169230888193e-10,-9.991190500791494e-11},{1.310364761687808,5.058734939880758e-17,9.173562934304531e-06,
    -7.0456375656949725e-06,3.581466879415138e-06,-1.3536218282292686e-06,4.0498921964203435e-07,-9.965907455690342e-08,
    2.067192585664162e-08,-3.670003927598707e-09,5.62097621511764e-10,-7.403068378308747e-11},{1.3103666657714028,
    -5.4586011216933564e-17,6.245027443309857e-06,-4.809305391663267e-06,2.4524563886835747e-06,-9.30448749760763e-07,
    2.7968044512031076e-07,-6.92255204511017e-08,1.446723584904491e-08,-2.5942531190533113e-09,4.0294658129101294e-10,
    -5.419421432473623e-11},{1.3103679613888117,1.0817295267392206e-16,4.247137674766455e-06,-3.278957688406017e-06,
    1.6770188886227546e-06,-6.384978181277896e-07,1.9274599485775258e-07,-4.796099663981324e-08,1.0090850366045393e-08,
    -1.825520843847422e-09,2.8700029691426966e-10,-3.928375473085322e-11},{1.3103688421247714,-2.9217049375847494e-17,
    2.8856936989746723e-06,-2.2331287903161808e-06,1.1452848871964938e-06,-4.3747612035026997e-07,
    1.3258342208598196e-07,-3.3150427633021037e-08,7.017183663207051e-09,-1.2794670484332684e-09,2.032885028359827e-10,
    -2.8243709111046486e-11},{1.3103694402856243,-1.0960442639223035e-16,1.9589346361971536e-06,-1.5193093297558688e-06,
    7.812072748027908e-07,-2.993140830689867e-07,9.104171545545516e-08,-2.2864469572125588e-08,4.866567175366176e-09,
    -8.935921733218911e-10,1.4333946861269702e-10,-1.9969821169978242e-11}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tail_max_overlap)

/* time of the largest overlap beta^(2/3), beta > exp(2): 32 rows of degree 10 in y = ln(beta), nodes 2.125 + i 0.25, 2 <= y <= 10.
 * Relative error of the approximation: 2^-58.3 at most, proved for the whole cell of each row. Bits of the rows:
 * 60.6 59.4 58.3 58.7 58.3 58.4 59.9 61.3 58.8 59.5 59.1 60.5 61.8 60.2 59.5 60.8 62.0 59.5 62.0 59.4 60.1 59.8 59.9
 * 60.0 62.0 59.8 59.7 60.4 60.0 59.9 60.1 60.2 */
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_FIRST 2.125
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_STEP 0.25
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_PER_UNIT 4.0
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_ROWS 32
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_END 10.0
COR_ROWS(double, cor_rows_tail_time_of_max_overlap, 32, 12)
#ifdef COR_ROWS_HERE
= {
    {3.6558234040539763,2.949594506235043e-17,1.2973279442531338,0.07284687898149292,-0.017263389469386596,
    0.0013614285814057864,0.00038801828185802104,-0.00011889603617834146,4.652622438348417e-06,3.6999476884177017e-06,
    -8.11565245434787e-07,3.466728921571651e-08},{3.98444424790766,8.335638284177766e-17,1.3306064789781504,
    0.0604636528397414,-0.015695782394203134,0.0017384446549595462,0.00021862870506902184,-0.00010531011545576697,
    1.0307864425634637e-05,2.003517454645413e-06,-6.848559053982895e-07,6.1101192854277e-08},{4.320636578605483,
    -4.358218766640669e-16,1.3580076705330442,0.04937194663563133,-0.013852098954416405,0.0019191061758796167,
    7.562399132346672e-05,-8.461250245124491e-05,1.2892692051522181e-05,6.425099291314128e-07,-5.222002728897591e-07,
    6.739917774935418e-08},{4.663015354354796,7.133171793255552e-18,1.3802173229655945,0.039709663412615476,
    -0.011910381595522754,0.0019414775298879066,-3.405129556619627e-05,-6.155582118517826e-05,1.3129585206191971e-05,
    -3.422049396923349e-07,-3.534250521373272e-07,6.66624689000766e-08},{5.010372975757019,3.101279221419242e-16,
    1.397959296950515,0.0314962701771226,-0.010007652735950067,0.0018482514025002074,-0.00010960958137349447,
    -3.958779119470156e-05,1.1772770707936707e-05,-9.547695332073326e-07,-1.9423018543640066e-07,5.957619514794885e-08},
    {5.361682051036464,4.013501753198191e-16,1.4119441597207523,0.024664413327488213,-0.008238724716144908,
    0.0016802821270545134,-0.00015445625412846783,-2.0864014155260337e-05,9.532835357876377e-06,-1.235024809732426e-06,
    -6.080508730662829e-08,4.632484008316559e-08},{5.716087294960855,2.593404771458202e-16,1.4228334998411734,
    0.019090306249967614,-0.006660262893394241,0.0014725221665357548,-0.00017434014732631403,-6.3869737967030825e-06,
    7.005845299246169e-06,-1.2561177307840042e-06,3.472839289986049e-08,2.992437984781857e-08},{6.072890328089001,
    1.0816529296764587e-16,1.4312184551697935,0.014619825191476641,-0.005297809191091034,0.0012521027605168589,
    -0.00017580064398907788,3.742794338282571e-06,4.6207419428370265e-06,-1.1084722234535533e-06,8.957656564794007e-08,
    1.438387810574105e-08},{6.431530623212635,2.2065593008635388e-16,1.4376098806571922,0.011088844676981093,
    -0.004153839153808907,0.0010380963783104859,-0.0001650444749349617,1.0016687486196484e-05,2.626538911400463e-06,
    -8.782501033843448e-07,1.097729701504198e-07,2.505081482837631e-09},{6.79156513891301,-1.4743515721233432e-16,
    1.4424371784196468,0.008337598272942537,-0.003215452026043734,0.000842391255414187,-0.00014728624201021287,
    1.3221034357728377e-05,1.1179227953412426e-06,-6.318911108184577e-07,1.0595467734251543e-07,-4.824949532849153e-09},
    {7.152648442015476,3.1297948893440285e-16,1.4460529321536102,0.006219686004704815,-0.00246086267970655,
    0.000671129517308576,-0.0001264895177738807,1.4206036380098896e-05,8.156381442504022e-08,-4.108949010549429e-07,
    8.900736931903333e-08,-8.166735163064135e-09},{7.51451445599187,3.042984897244979e-16,1.4487409216891174,
    0.004606780015444523,-0.0018643592795561954,0.0005262785557015011,-0.00010539119204464239,1.3739639017010959e-05,
    -5.558095972738864e-07,-2.346049129760612e-07,6.745618269048351e-08,-8.72136373855367e-09},{7.876960435723044,
    -1.7036149252440048e-16,1.450725657770141,0.003390189837456464,-0.001399744081367015,0.00040706022554097565,
    -8.568543718127548e-05,1.2437888887613254e-05,-8.892983295694752e-07,-1.0668671307249967e-07,4.67061397822152e-08,
    -7.707779694830405e-09},{8.239833375411829,-3.4894528648008306e-16,1.452182139706503,0.0024803509245415667,
    -0.0010424769295998163,0.00031110380324160275,-6.826801499924331e-05,1.0750118542654507e-05,-1.0113564760424425e-06,
    -2.1851787020975273e-08,2.944097622528622e-08,-6.05741870469122e-09},{8.603018794713046,3.70212686512465e-16,
    1.4532450226262377,0.001805099336501404,-0.000770820129560893,0.00023529128193825152,-5.347630323818336e-05,
    8.97593067009648e-06,-9.994144903209526e-07,2.8927811453771857e-08,1.645749231598397e-08,-4.3516333269316e-09},
    {8.96643169402812,1.9758325185364012e-16,1.4540167556678518,0.001307368466309279,-0.0005662813088551969,
    0.00017632400397921445,-4.129174351993206e-05,7.295838957160604e-06,-9.120060705984176e-07,5.512022284948061e-08,
    7.478969549400489e-09,-2.8828331440588557e-09},{9.330009395496862,8.239177185236331e-18,1.4545745171447655,
    0.0009427363298638768,-0.0004136062357574118,0.0001310662718585683,-3.1493748139805394e-05,5.803922177280772e-06,
    -7.898024074214282e-07,6.494546366106913e-08,1.7584198852833532e-09,-1.7505860521797647e-09},{9.693705965798012,
    -7.039024278305857e-16,1.4549759433597007,0.0006770849299615601,-0.00030051423605731783,9.672623090915162e-05,
    -2.3767187196428116e-05,4.536426828704244e-06,-6.58845127903074e-07,6.47773124580249e-08,-1.5506151033316317e-09,
    -9.469918490917404e-10},{10.057487929606111,-6.902745875381532e-17,1.4552637460780293,0.00048451070008428976,
    -0.00021731143606317638,7.092731787459185e-05,-1.7771576057002114e-05,3.494085504707838e-06,-5.34290816107364e-07,
    5.916132387736337e-08,-3.2057539535086198e-09,-4.165763599653895e-10},{10.421331013079294,-6.092497770164364e-16,
    1.4554693609785767,0.00034554223003022155,-0.00015646933222899468,5.171212601187721e-05,-1.318160534861537e-05,
    2.6581156957074634e-06,-4.237968003560234e-07,5.111133700801731e-08,-3.805652688634128e-09,-9.18070775414851e-11},
    {10.785217694631683,-7.4042513733590655e-16,1.4556157835235106,0.00024567005107851444,-0.0001122202727920726,
    3.7508842980130816e-05,-9.707830673690061e-06,2.0008782090342e-06,-3.3021399110379834e-07,4.248168032057322e-08,
    -3.784916958396715e-09,8.919845265979294e-11},{11.14913537895658,1.9634567376946715e-16,1.4557197431243118,
    0.00017416456320285068,-8.019644966081976e-05,2.7080447776897146e-05,-7.10458476482411e-06,1.4924685454215258e-06,
    -2.535514241532243e-07,3.431242262214028e-08,-3.4382574288162214e-09,1.759815323089596e-10},{11.513075046147668,
    -6.398418053664297e-16,1.455793350666073,0.00012314477917380658,-5.712282890633944e-05,1.946921366878016e-05,
    -5.170292223699632e-06,1.1044383907685476e-06,-1.9231405761673295e-07,2.7107761736572218e-08,
    -2.9531609272127926e-09,2.049359022287699e-10},{11.877030259079488,-7.879414204384446e-16,1.4558453345243199,
    8.685670266532422e-05,-4.05647804201251e-05,1.394364707013642e-05,-3.7437304481611605e-06,8.116201075896855e-07,
    -1.4435733516379203e-07,2.1041577374742263e-08,-2.4408108038394815e-09,2.0110974572079476e-10},{12.240996438430825,
    -1.1121508778338133e-16,1.455881959856359,6.112176114464647e-05,-2.8725967832612786e-05,9.951395885319896e-06,
    -2.698510309368897e-06,5.927765329737471e-07,-1.0739631895092462e-07,1.6099487386154258e-08,-1.9612678781987206e-09,
    1.8078562225241538e-10},{12.60497033603752,-1.7379857249954566e-16,1.4559077071722861,4.2920052896307515e-05,
    -2.028973978758938e-05,7.079423636027348e-06,-1.937137824888648e-06,4.305774721793253e-07,-7.928249902644587e-08,
    1.2171537514575868e-08,-1.542222097880879e-09,1.5395300492148693e-10},{12.968949654169437,2.6132363020989583e-16,
    1.4559257698949375,3.0078537291666266e-05,-1.4296676123441497e-05,5.021456242035076e-06,-1.3854019340864473e-06,
    3.112313433300805e-07,-5.813295010208148e-08,9.109288539776182e-09,-1.1920885323720848e-09,1.2633338051822388e-10},
    {13.332932771500891,-5.935300963283604e-16,1.4559384170477556,2.1039711006166733e-05,-1.0051309534592132e-05,
    3.552042216243115e-06,-9.874403383918396e-07,2.2397509819798175e-07,-4.237120716893598e-08,6.758668174374667e-09,
    -9.086812180472924e-10,1.0089612310067965e-10},{13.696918546656118,8.057362708654777e-16,1.4559472562425368,
    1.4691256006929767e-05,-7.051866546780864e-06,2.5062879969039156e-06,-7.015992768042776e-07,1.6053989077871273e-07,
    -3.0719319136989e-08,4.977142862112414e-09,-6.846775047928664e-10,7.892472665675941e-11},{14.060906177877262,
    8.574534870738035e-16,1.4559534234759557,1.0241398429119686e-05,-4.937850577385396e-06,1.7642760459098307e-06,
    -4.970717840490723e-07,1.1465434893794959e-07,-2.216602201644761e-08,3.641250868779977e-09,-5.108782610989561e-10,
    6.073058737920576e-11},{14.424895103112712,4.783801086632663e-16,1.455957719522638,7.128233808420114e-06,
    -3.451256334946791e-06,1.2392385404575932e-06,-3.512341160129078e-07,8.161299050833135e-08,-1.592596725100617e-08,
    2.6485540853200563e-09,-3.7802338020143783e-10,4.610833132136385e-11},{14.78888492909887,4.579889141947546e-16,
    1.4559607075735739,4.9540983894399e-06,-2.408075015936778e-06,8.686785525226843e-07,-2.475751186234991e-07,
    5.7917368534932236e-08,-1.1398355057326053e-08,1.916616396975934e-09,-2.7805905025820435e-10,
    3.3008021738607676e-11}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tail_time_of_max_overlap)

/* beta/(1 - eps) at zero overlap, 1 - eps < 1/2: 9 rows of degree 10 in y = 1 - eps, nodes 0 + i 0.0625, 0 <= y <= 0.53125.
 * Relative error of the approximation: 2^-57.1 at most, proved for the whole cell of each row. Bits of the rows:
 * 59.8 60.0 59.3 61.8 60.5 59.0 59.6 58.3 57.1 */
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_STEP 0.0625
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_PER_UNIT 16.0
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_ROWS 9
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_END 0.5
COR_ROWS(double, cor_rows_near_beta_zero_overlap, 9, 12)
#ifdef COR_ROWS_HERE
= {
    {0.866965189576149,-6.870677073425355e-09,0.5201791096232832,0.3288147282840862,0.2209318209422112,
    0.15768619027803757,0.11897069548578144,0.0941674207914657,0.07752577878322844,0.06586967485939052,
    0.05678017339219531,0.0586042444627083},{0.9008172750473022,-1.5477181223552097e-09,0.56403363586658,
    0.37424889459260235,0.26550569493630116,0.20112252972538486,0.16166713793196016,0.13664839181233057,
    0.12026577057601204,0.10923429393957144,0.1018726766490425,0.09658375900170928},{0.9375993311405182,
    6.755496338676036e-09,0.6141357210680942,0.42917359879113165,0.3228392969935614,0.26080813591152846,
    0.22449072435718065,0.20365203186990344,0.1925450792432089,0.1878905641557678,0.1882771945513151,
    0.1916631816028381},{0.9777422994375229,5.193197841265559e-09,0.6718387683224539,0.49641754004677896,
    0.3979187934263234,0.34476542642277946,0.3196369168651949,0.31300493055003764,0.3196740150085442,
    0.33694766627644157,0.36472127364887935,0.4007255291366703},{1.0217740833759308,8.897676853560149e-09,
    0.7389170783110908,0.5799667760718271,0.49831504939798227,0.46613290006054076,0.46865287971245756,
    0.49868175272342846,0.5536741015941189,0.6342613851617164,0.7461887373566737,0.8901964458386642},
    {1.0703511536121368,1.7340854739658304e-09,0.8177466231856225,0.6855964060072038,0.6359237306604616,
    0.6473170864216076,0.7114255759213401,0.8289354808064868,1.0079370399073386,1.2639353716543384,1.627901971880905,
    2.1236127439276298},{1.1243042945861816,-2.8640509341963433e-10,0.9115900333684256,0.8219527445430654,
    0.8302055839977768,0.928396029358783,1.1259541866923408,1.4496484993186771,1.947312576846975,2.6958466697641397,
    3.834163634534375,5.515337517107205},{1.1847074329853058,1.256011842141841e-08,1.0250648350260807,
    1.0025003582101177,1.1145714007235645,1.3852547653522946,1.8750852364774235,2.6965773805581046,4.043686161895607,
    6.2438913860440906,9.909837925591797,15.87970496469264},{1.2529852390289307,-9.17516880767073e-09,
    1.1649519353330366,1.249237361391081,1.549848037682252,2.1718620723850175,3.326958480964333,5.415268847557768,
    9.181909723066205,16.01466359370826,28.73779317692113,51.94911452574154}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_near_beta_zero_overlap)

/* beta/(1 - eps) at zero force, 1 - eps < 1/2: 24 rows of degree 10 in y = sqrt(1 - eps), nodes 0 + i 0.03125, 0 <= y <= 0.734375.
 * Relative error of the approximation: 2^-56.4 at most, proved for the whole cell of each row. Bits of the rows:
 * 66.7 64.3 63.4 62.7 61.9 62.7 63.6 62.0 63.8 60.8 60.9 61.2 59.8 60.7 60.0 63.0 59.9 61.1 59.5 60.1 59.2 58.9 57.9
 * 56.4 */
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_STEP 0.03125
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_PER_UNIT 32.0
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_ROWS 24
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_END 0.5
COR_ROWS(double, cor_rows_near_beta_zero_force, 24, 12)
#ifdef COR_ROWS_HERE
= {
    {0.866965189576149,-6.870677073425355e-09,1.4080665842949803e-24,0.5201791096232832,0.16179851461843053,
    0.3288147282840921,0.19415821753965673,0.2964214716757319,0.14335183767531245,0.3032001007021057,0.1206663216764997,
    0.2790303156005158},{0.8674784302711487,-2.806082357709039e-09,0.03302633178291313,0.5373379596571878,
    0.2049826546261952,0.3636679261744757,0.25321185009598246,0.33643614896696283,0.22443511992104265,
    0.3498139818942784,0.21399640486311078,0.33249069100416334},{0.8690418601036072,-5.407671152057262e-09,
    0.067256151553964,0.55876818698784,0.2531273547756399,0.4084244873335285,0.3215224321456119,0.39571490654878233,
    0.32070711271613334,0.4259295001726828,0.33309802367230434,0.4375152860491308},{0.871697410941124,
    -5.153368097205668e-09,0.1029722098832624,0.5849959825235216,0.3075732516355294,0.46483129780496224,
    0.40306734192370625,0.47846258315744594,0.44062321864885473,0.540893131787546,0.49345066517413366,
    0.6002355504637741},{0.8754964172840118,-2.6385385710480448e-09,0.14049430493673815,0.6166847370136186,
    0.3699210496212907,0.5353280190277304,0.5028036972474048,0.5910317596786338,0.5955783581680041,0.7092056629298665,
    0.7172874810895177,0.8498420341741668},{0.8805009126663208,-4.626811215598409e-09,0.18018870902727177,
    0.6546638133385749,0.44212910388271126,0.623235146121777,0.6271410978371774,0.7427275406767123,0.8014943156915235,
    0.9531273234319344,1.0385542967228776,1.233585321145029},{0.886785238981247,-7.175396495386395e-09,
    0.22247970468675982,0.6999677259480918,0.5266396760177909,0.7330296089790554,0.7846028736353429,0.9470439726121573,
    1.0812461211338498,1.3069126802258975,1.5102677450537136,1.8288525133957503},{0.8944380730390549,
    6.907288686919674e-09,0.26786397637659953,0.7538889927439262,0.6265469407528765,0.8707447095135956,
    0.9867771412262784,1.2235685765547626,1.468456539857468,1.823756537293934,2.2169443888909175,2.76444375172784},
    {0.9035650342702866,-3.6483693156140276e-09,0.31692885137039467,0.8180494010250583,0.7458255741716249,
    1.0445511276669557,1.2497163145442094,1.6009434577977095,2.0135537288040766,2.5873730039817437,3.296054780837826,
    4.2587780619004105},{0.914291724562645,4.7810918394391116e-09,0.3703757426191445,0.894496581484411,
    0.8896476654494073,1.2656073084204271,1.596038732366553,2.1215316930887433,2.7936399167266828,3.7316668001294566,
    4.975879914011698,6.690043716879354},{0.9267679154872894,-5.873191469864959e-09,0.4290506706755862,
    0.9858359902680266,1.0648296642607928,1.5493185943713148,2.05814636218628,2.848893200771982,3.928908106956644,
    5.474863464488319,7.64389133751998,10.728213352241823},{0.9411725103855133,8.24595713979559e-10,0.4939845144117434,
    1.095413270233809,1.2804733163239925,1.9172287323290071,2.683248534997036,3.879990146979783,5.610562388149842,
    8.18011262295605,11.973425630476672,17.590254045142505},{0.9577202498912811,6.023821401688419e-09,
    0.5664467942875728,1.2275695098838943,1.548900590711013,2.39990952607896,3.54136768591109,5.365539783763755,
    8.149446835045008,12.46586210404468,19.16488706745763,29.548199714502193},{0.9766701906919479,
    -5.891882004072926e-09,0.6480185432471199,1.388003851186546,1.8870422453365236,3.0414598465598774,4.738380368364151,
    7.54475742836466,12.062964223863561,19.412548657599118,31.419037493487554,50.97368249891198},{0.9983368664979935,
    7.421772391438069e-09,0.74069252687796,1.5842971739333116,2.3185406149172625,3.906659868147378,6.437773940773312,
    10.806218412661858,18.234904386715243,30.961687295475144,52.89687923385095,90.56267979321987},{1.0231053531169891,
    1.1887303919809086e-08,0.847013343444754,1.8266824576092802,2.8770023776439873,5.092617757916166,8.897908719882803,
    15.797571896758448,28.218681638106773,50.71296919641906,91.73875835962858,166.26294650160855},{1.051451325416565,
    1.2762604270717738e-08,0.9702768223231749,2.1292014863308615,3.611149638707055,6.748231459768262,12.537716839828366,
    23.629712296710597,44.83298186730719,85.57726268189181,164.4872636942201,316.6721401119007},{1.0839688181877136,
    5.219367075929093e-09,1.1148195373564624,2.5114818931741416,4.593192973412212,9.107672364056016,18.056352448717732,
    36.270477758509024,73.37803558535124,149.35156874887457,306.2249360137667,628.7169384593099},{1.121408998966217,
    -1.2920369890010447e-08,1.2864486530324928,3.0015383831791973,5.93284614477515,12.549913263521507,26.65916956595929,
    57.33475606262199,124.2298192163787,270.8246158407839,595.0272737011203,1308.6502624074956},{1.164735585451126,
    -1.276269796638737e-08,1.4930964102871604,3.6403187619676363,7.801573176467088,17.708558594723918,
    40.502454102853356,93.74354904622095,218.6534356435323,513.1661772907214,1214.461327985073,2875.8349259238603},
    {1.215206116437912,-7.58037666100026e-09,1.7458456427497624,4.48933033655121,10.476151943405293,25.68324810863371,
    63.61079934578561,159.39258890753777,402.58732611558395,1023.2394728977056,2624.2744775152196,6730.701587968994},
    {1.2744941413402557,1.2673219008714358e-08,2.060590510159086,5.6439316538175195,14.420419069959651,
    38.46692306241569,103.87487084289207,283.76365980927113,781.5308802969228,2166.224986699882,6063.746524893745,
    16962.482522794242},{1.3448794186115265,-1.3076045053819711e-08,2.460830938328104,7.257550145032618,
    20.44662410848761,59.85993604588902,177.6861495446471,533.5980968334145,1615.845213119176,4924.927293622368,
    15175.784799467456,46687.57964241236},{1.4295547306537628,5.743541204728064e-09,2.9825916700933317,
    9.588179335688654,30.053536697527353,97.56182506744335,321.52573630184327,1072.1466686733374,3605.749101027536,
    12206.790931455622,41839.41522939825,142989.27514012152}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_near_beta_zero_force)

/* beta at zero overlap by eps, 2^-12 <= eps < 2^-1: 88 rows of degree 10 in y = eps 2^-k, 8 to each octave k = -12 ... -2.
 * Relative error of the approximation: 2^-57.5 at most, proved for the whole cell of each row. Bits of the rows:
 * 58.6 59.4 60.1 61.4 61.7 64.9 60.8 60.7 58.6 60.5 60.6 60.7 62.0 62.0 61.9 62.3 58.6 60.0 61.7 60.5 60.5 60.7 61.3
 * 60.9 58.6 60.5 60.1 62.7 60.0 60.0 62.2 61.3 58.4 59.6 61.2 60.2 61.3 61.6 63.9 60.9 58.2 59.8 59.9 61.9 61.1 61.2
 * 61.8 61.0 58.6 59.7 60.5 60.7 61.2 64.8 63.4 62.7 58.5 58.9 60.0 60.2 63.8 61.0 60.3 61.1 58.6 58.8 61.2 61.7 60.0
 * 64.3 60.0 60.7 58.3 58.7 59.4 58.9 61.1 61.9 60.5 59.7 57.5 59.6 58.1 60.4 60.7 57.8 57.8 59.3 */
#define COR_ROWS_BETA_ZERO_OVERLAP_FIRST 0.000244140625
#define COR_ROWS_BETA_ZERO_OVERLAP_FIRST_OCTAVE (-12)
#define COR_ROWS_BETA_ZERO_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_BETA_ZERO_OVERLAP_ROWS 88
#define COR_ROWS_BETA_ZERO_OVERLAP_END 0.5
COR_ROWS(double, cor_rows_beta_zero_overlap, 88, 12)
#ifdef COR_ROWS_HERE
= {
    {7.2395054090751,1.1552296366069447e-16,-1.3627304299435485,0.7695418898504742,-0.5311347945607625,
    0.3999132570807003,-0.31616672172278953,0.2578928557136522,-0.21497898342211444,0.18209972017296408,
    -0.15731455595355892,0.1362304819227635},{7.080239702221091,-3.3420712421855393e-16,-1.1924614235319735,
    0.6025068245214167,-0.37207438987912206,0.2506606416026707,-0.1773094238612248,0.12940477259151284,
    -0.0965173067573151,0.07314992677936821,-0.056457964494666356,0.043743813373528104},{6.939925722606871,
    2.210787414537e-16,-1.057512491063905,0.4834342816292077,-0.2701093129100577,0.16463805739271184,
    -0.10536835724939304,0.06957656608291646,-0.046951978096708785,0.03219563268937682,-0.022458179809563758,
    0.01574321872240148},{6.814799988664557,-7.788072214600493e-18,-0.9481460853794205,0.39574793128878055,
    -0.2018887997299077,0.1123555059364774,-0.06565469582995768,0.039583120972525615,-0.02438896919470855,
    0.015269612389014867,-0.00971731021495214,0.006219442125122683},{6.702096542489049,4.19295623151425e-16,
    -0.8578683574386112,0.32942144925636374,-0.1546084668511373,0.07915953502740833,-0.042556166104634814,
    0.023604486801983588,-0.013380319348773524,0.007707062822183502,-0.004509462746686772,0.0026553030401591815},
    {6.599726349731172,3.399140274828988e-16,-0.7821897895978065,0.2781119251901646,-0.12085851563862127,
    0.05729588889456259,-0.0285206202816841,0.014647627206768227,-0.007688044564125209,0.0041002899952730775,
    -0.0022203150810247083,0.0012105342338949257},{6.506075243387316,8.102325834473188e-17,-0.7179117509945628,
    0.23765354515642234,-0.09615407804124475,0.042440420651171255,-0.01966893979323236,0.00940491833712266,
    -0.004595891012045424,0.0022820974223622934,-0.001150085950663141,0.0005837892282400588},{6.419871605218213,
    3.1046868935485134e-16,-0.6626964237647027,0.20522211832625858,-0.07767546844366165,0.032072451483682596,
    -0.013904959620296893,0.006219852903770585,-0.0028433566063246294,0.0013207849227298888,-0.0006224818042003755,
    0.00029558796657934216},{6.302355511855548,4.004962630440109e-17,-1.1863257434096754,0.6699251256801846,
    -0.462379694622625,0.3481447111502294,-0.2752391177975879,0.22450877070763303,-0.1871500751743056,
    0.15852701396135044,-0.13695027529368609,0.11859552277803209},{6.163706661039615,-2.2412863045943496e-16,
    -1.03809796397067,0.5245126554467763,-0.3239095697855919,0.21821276257737424,-0.15435681902487602,
    0.11265339751307281,-0.08402319583208885,0.06368070995975032,-0.04914951278559296,0.03808120137329836},
    {6.041556247046694,-1.8169131413794982e-16,-0.9206180948076231,0.4208539861055746,-0.23514381471544565,
    0.14332575326721622,-0.09172848310355804,0.06056991857759074,-0.04087407104538123,0.028027926178916085,
    -0.019550981076616843,0.013705267925796433},{5.932627968876158,1.613939309768086e-16,-0.8254091087671063,
    0.34451858430545307,-0.17575440876931925,0.09781114837439371,-0.05715573296854666,0.0344591079878288,
    -0.02123183092683439,0.013292969679228387,-0.008459409875983898,0.005414338843662444},{5.834513920311854,
    1.2700538133943793e-16,-0.7468177819315921,0.2867780277768076,-0.13459448874689436,0.06891237680131614,
    -0.03704729512561576,0.02054889896713885,-0.011648244587073591,0.006709387898622858,-0.0039257153312277655,
    0.0023115755554748586},{5.745395491316856,1.391871713790995e-16,-0.680935762225307,0.24211049227352377,
    -0.10521345034118057,0.049878966798737254,-0.0248286430507016,0.012751499773384328,-0.006692831548152494,
    0.00356950978465569,-0.0019328965436119377,0.0010538312575941009},{5.663867467883372,2.321109517230717e-16,
    -0.624978479809174,0.20688942602641586,-0.0837069892209728,0.03694652984566038,-0.01712280787730629,
    0.008187456602920497,-0.004000955511865893,0.00198668121607087,-0.0010012079731631328,0.0005082180386611615},
    {5.588822842014106,-1.339383904166171e-16,-0.5769107461139851,0.178656227986138,-0.06762042656703496,
    0.02792068757599698,-0.01210497195455706,0.005414696101944732,-0.002475285679011389,0.0011498100762379632,
    -0.0005419018874249194,0.0002573242700621846},{5.486519140407742,2.57703345730062e-16,-1.032756549421047,
    0.5832036731069185,-0.40252495710607117,0.3030774986176871,-0.23960962973516517,0.19544621699284873,
    -0.16292359827925684,0.13800578469324223,-0.11922214085341795,0.10324339892843733},{5.365818304098963,
    1.4659159789235152e-16,-0.9037167813165675,0.4566147368150295,-0.28197976002966557,0.1899651254189284,
    -0.13437548931433616,0.09807046452200356,-0.07314643288295253,0.05543727952918197,-0.04278713757063628,
    0.03315161151737198},{5.259480189613503,8.927672956360666e-17,-0.8014446335268055,0.3663745731886561,
    -0.20470475291219736,0.12477214852879023,-0.07985436418805485,0.05272916969072393,-0.03558293719027114,
    0.024399727000815864,-0.017020118737753262,0.011931129074011195},{5.164652609663461,-2.0984756698050186e-16,
    -0.7185604319602504,0.2999206642010194,-0.15300336841469372,0.08514933155003927,-0.04975703964118979,
    0.02999839602268222,-0.0184833744732628,0.01157220128474796,-0.007364344727989219,0.004713456076617185},
    {5.079239357549668,-2.7018965714508544e-16,-0.6501427683857096,0.24965446722155302,-0.11717169930642368,
    0.05999143766706794,-0.03225162516648042,0.017888862120770954,-0.010140379257931487,0.005840859902092174,
    -0.003417534002535171,0.002012343667555092},{5.001657237411952,2.336943053660676e-16,-0.5927892361757385,
    0.21076894533696175,-0.09159416758845662,0.04342184287537023,-0.02161466380552558,0.011100836960861744,
    -0.00582644327489953,0.0031074370588612447,-0.0016826842098816742,0.0009174135696159438},{4.930682933952546,
    -2.2300828743539536e-16,-0.5440757403293799,0.1801069927129809,-0.0728718767928961,0.032163459011986174,
    -0.01490633446173016,0.007127610243319877,-0.0034830307533309413,0.001729504821775223,-0.0008716020315985549,
    0.0004424295992453903},{4.865352733415741,-3.1074010964180856e-16,-0.50223056230217,0.15552826467486727,
    -0.05886790173422587,0.024305970460428275,-0.01053804219209388,0.0047137842466253,-0.0021548595563093582,
    0.0010009663846746895,-0.0004717527745205026,0.00022401383046710073},{4.776292036097616,2.0400338009748866e-16,
    -0.8990689436703121,0.5077018475275122,-0.35042806495486145,0.26383726161053367,-0.20859330667358456,
    0.1701470031264442,-0.14183323698263878,0.12014075277808009,-0.10378877569935634,0.08987859293987183},
    {4.6712154652186975,-9.384428308881203e-17,-0.7867354228266616,0.3974954524113717,-0.24549100011260483,
    0.16536686526285868,-0.11698080176977499,0.08537638703032148,-0.06367786821192184,0.04826082453946578,
    -0.03724826586181545,0.02886012559706357},{4.578642029944608,1.7293078976445342e-16,-0.6977057218985452,
    0.3189311256971642,-0.17822287181846208,0.10861323228380415,-0.06951666586774238,0.04590428040301629,
    -0.03097702638751164,0.0212411585554327,-0.014816809506829206,0.010386623445427397},{4.4960885789268135,
    4.0896143888035367e-16,-0.6255558039608718,0.26107258675461187,-0.13321769364624844,0.07412012385467875,
    -0.043314863335315874,0.02611574005105271,-0.01609099983103571,0.010074203416283251,-0.006411000143832886,
    0.004103281659765403},{4.421730038167718,1.5435623641051024e-16,-0.5660016602421223,0.21730502265563845,
    -0.10202754893130216,0.05221975331422737,-0.028075141931388905,0.015573538825734826,-0.008827968574853958,
    0.005084807142843894,-0.002975122201976753,0.0017518342842887905},{4.354187896719134,4.1409804540901927e-16,
    -0.5160816167312351,0.1834438219861203,-0.07976367599455425,0.037796110889150046,-0.018814923185064423,
    0.009664016589325055,-0.005072420678820096,0.0027052325650114215,-0.0014648597644133523,0.0007986479399864781},
    {4.2923969038944625,-8.491500866958842e-18,-0.4736856251891648,0.1567407556830228,-0.06346709839217396,
    0.027996230715474635,-0.012974913103582906,0.006204963050586331,-0.0030323104227626616,0.0015056710908058063,
    -0.0007587779198491698,0.0003851540807468798},{4.235517777239734,3.357507598827859e-16,-0.43727151391454655,
    0.13533275286586088,-0.051277491894628095,0.02115701197307852,-0.009172126272580065,0.004103489831700814,
    -0.0018760235747236,0.0008714350093265813,-0.0004106914937480319,0.00019501430509521377},{4.157973337592123,
    3.352111595682409e-16,-0.7828470977474894,0.4416610461517659,-0.3053159422389616,0.22966806062301975,
    -0.1815399340561867,0.14810859444433422,-0.12347988527822966,0.10459651635042705,-0.0903570418925674,
    0.07824432061781605},{4.066473126905034,-2.9894208908154005e-16,-0.6851466674124738,0.34562631710250136,
    -0.2139633003449405,0.14397314098263445,-0.1017978477292125,0.07430835958826605,-0.05543567799760797,
    0.04201777288384514,-0.03242919513218497,0.025125105926894858},{3.9858446099963696,1.8314293797215102e-16,
    -0.6077568219956648,0.27713991462285403,-0.15539093431210207,0.09458737316822886,-0.060489888297327744,
    0.03994660836288184,-0.026964965386641695,0.018493369542596148,-0.012900422421559594,0.009042822586893744},
    {3.913923207650402,-2.1861826780495226e-16,-0.5450840110624665,0.22668522178483927,-0.11619084331921149,
    0.0645733690404973,-0.037690586934751025,0.022722106325031393,-0.014004822709602767,0.008770587659499554,
    -0.005581974709439366,0.00357260065801424},{3.8491174228586873,-1.9974765006467431e-16,-0.4933968636791182,
    0.18850635020045245,-0.08901201083414748,0.045515919546107,-0.024432281702044964,0.01354748375988402,
    -0.007681892922729616,0.0044263737315774964,-0.002590395015070373,0.0015253444270315621},{3.79022478997044,
    9.986618469080878e-17,-0.45011465448390026,0.15896189206569605,-0.0696012215963509,0.032962613316806284,
    -0.0163772951993845,0.008405689847389064,-0.004412873724890566,0.002354548892786984,-0.0012753697208791504,
    0.0006954145312438401},{3.7363158756475863,6.126755435095125e-17,-0.41339778048989334,0.13565999577188306,
    -0.05538457515589405,0.02443107561276738,-0.011297862315916297,0.005396737258327232,-0.0026373931590046255,
    0.0013102035755588966,-0.0006605549386372174,0.0003353679587714966},{3.686658306759395,-1.170488433454366e-16,
    -0.38190093465112473,0.11697873473528604,-0.044744009068574564,0.018474582127013518,-0.007990369364665758,
    0.003569145116955198,-0.0016313324822648273,0.0007581075176249457,-0.00035746857542770895,0.00016979770834812412},
    {3.618890596764218,8.008995363742211e-17,-0.6846214970398178,0.3809582478928507,-0.26630824412766124,
    0.20073497466940501,-0.15829365579651214,0.1288586653909328,-0.1073483781405859,0.09095515722973314,
    -0.07861984464127499,0.06811463514406702},{3.53878987105643,5.0865506130309577e-17,-0.6004690838095941,
    0.29723151984913926,-0.18642409969424253,0.12596483322866234,-0.08889375437209196,0.06470263449179342,
    -0.04819213322814867,0.036518872728399196,-0.028199629906634275,0.021862355354514706},{3.4680396346463866,
    1.14379461332335e-16,-0.534013559887537,0.23760501388981087,-0.13516116425715968,0.0828078918969956,
    -0.05290651122835894,0.03482653837827701,-0.02345120680357288,0.016068333252497912,-0.011210823749816651,
    0.007863724523165999},{3.4047552560969665,2.1218195212807865e-16,-0.4803598259247942,0.1937635399063991,
    -0.10083955439483895,0.05653787878993822,-0.03301557782269067,0.019841219326120867,-0.012190606281189727,
    0.00762096260825481,-0.004848494129394044,0.003104612126621917},{3.3475537468465313,-1.357538556291871e-16,
    -0.43624106089869125,0.16066988439602406,-0.07704678371156028,0.03983395216703532,-0.021429034476393997,
    0.011850666614323973,-0.006695474547499031,0.0038480655669074185,-0.0022495171701432904,0.0013247051169111275},
    {3.2953927125300386,-1.6531238498170657e-16,-0.3993981088238882,0.1351327209699976,-0.06006646365250127,
    0.028818694754293783,-0.014377146443780952,0.0073659140409151206,-0.0038524741211268297,0.002048823402923775,
    -0.001107701763899192,0.0006036833927748813},{3.2474687038149863,9.454036498003202e-17,-0.36822169510834096,
    0.11505345330473782,-0.04764555460196971,0.021327213144779977,-0.009922584294392968,0.004736916333129177,
    -0.002306658233970835,0.0011415801272406146,-0.0005740314350006976,0.0002910919832797363},{3.2031505654704344,
    1.8652942578951578e-16,-0.3415364010024981,0.09900797775088088,-0.03836524354572383,0.016095649739182635,
    -0.007017526568936153,0.003137121990667142,-0.0014294510414257597,0.0006616090195123547,-0.00031094085234149843,
    0.00014741401955416992},{3.142358736552707,-1.3578587773624822e-16,-0.6161394942031739,0.32164820083943163,
    -0.22721019660275849,0.17424998442787595,-0.13889037733166426,0.11342417116190194,-0.09431705626302721,
    0.0795981891784518,-0.06852672097642139,0.05919639603792843},{3.0699619778936316,-1.182164647193858e-16,
    -0.5451676168010512,0.2504300097442098,-0.15804498028761954,0.1087186496031902,-0.07778093230928528,
    0.05698156161444678,-0.042462642461617545,0.03208090254507472,-0.02466692387720882,0.019048699163748895},
    {3.0054446809119972,1.530920519747859e-16,-0.48920464554500537,0.20002086718975015,-0.11392800415373087,
    0.0710249844074846,-0.046100046027974594,0.030635962173591283,-0.02069595500361129,0.014162254863395637,
    -0.009844281966773413,0.006875367067156138},{2.947212951633182,1.2275130434103242e-16,-0.444036089520974,
    0.16315635623522742,-0.08457736046483291,0.048187158660203025,-0.028621101346227,0.017408734401423615,
    -0.010760076788698943,0.0067325839458011435,-0.004272658173551584,0.002724816682987634},{2.8941035209985637,
    6.194480051938447e-17,-0.4068671160310103,0.1354558958490336,-0.06435746192405899,0.03374421149170756,
    -0.018471575986957797,0.010358951866419297,-0.0059025856434667175,0.0034033306517806334,-0.001987958927647849,
    0.0011669327398985377},{2.8452436432154142,-9.806046339729957e-17,-0.37577706859053406,0.1141590796688145,
    -0.05001208889458496,0.024275235888824086,-0.012319991498151123,0.006409280250527458,-0.0033880358978534385,
    0.0018118265082393676,-0.000980708919000121,0.000533454153113524},{2.799963138930349,3.081203568157128e-17,
    -0.3494059145844255,0.09746120311044006,-0.03957524683176437,0.01787339998296067,-0.008453013796079422,
    0.004100650088966191,-0.002021694655101488,0.0010082412721974905,-0.0005086055032561704,0.00025782990319698904},
    {2.757737055894721,-6.006597730568173e-17,-0.32676568572686976,0.08414483987907063,-0.03181484982561308,
    0.013428621293590631,-0.005944456168952445,0.0027010843461463363,-0.0012476925045503177,0.000582997580895416,
    -0.0002754137737684535,0.00013075366294682366},{2.699232317519502,-1.6623504900350732e-16,-0.5964921860913809,
    0.27493752599254656,-0.1881954313331326,0.14457108112479175,-0.11673398210120815,0.09685947358490916,
    -0.08174351737258123,0.06979610308925129,-0.06056021827633519,0.052522758670412284},{2.6286311914022726,
    6.50335506717456e-17,-0.5355767112526229,0.21594668626277955,-0.13096189397399746,0.08972303926672566,
    -0.06479354993382362,0.04815461018859802,-0.03643073739553469,0.02789522320095266,-0.02167580216571397,
    0.016857584955659553},{2.5648225800559636,-1.0525613569773597e-16,-0.4870990703743502,0.1741376615997737,
    -0.09461301505278114,0.058428399275199494,-0.038134206340637945,0.02565152105705565,-0.017579662095847274,
    0.012199758810638298,-0.008584492155004973,0.006052418950234652},{2.506484497297698,1.9148798420702188e-16,
    -0.4475854488629707,0.14347447800856017,-0.0704870715497011,0.03958472876964572,-0.02355257180977597,
    0.014462865625532636,-0.009056104783179456,0.005745170599858331,-0.0036938091810571508,0.0023818020985884487},
    {2.452649431490282,2.8838683831255835e-17,-0.4147379793347776,0.12034060040955633,-0.053878463208623543,
    0.02772075603539172,-0.015145891694856386,0.008551702021249045,-0.004927659021809424,0.0028783184567446425,
    -0.0017034534463529402,0.0010119010022743634},{2.402588610560393,-7.447115987384747e-17,-0.38697885800713744,
    0.10246761943515882,-0.04208825915735972,0.019965411199420274,-0.01007959751325716,0.005265069654246093,
    -0.002808908876267346,0.0015198947605662403,-0.0008331607957367949,0.0004587489907231191},{2.355739691825126,
    -2.3508271672243582e-17,-0.36319027027665335,0.08837704273900612,-0.03349647066658789,0.014730758632260988,
    -0.006908666705433548,0.0033562567701784186,-0.0016665275219672853,0.0008397242748729064,-0.00042863594101519303,
    0.00021991323158444514},{2.3116597741354115,6.268911809270795e-17,-0.3425589329966163,0.0770732458139096,
    -0.02709239751199261,0.011098407917245565,-0.004858103809534694,0.0022051146399803072,-0.0010237582077984077,
    0.00048255348192889684,-0.0002304292728943815,0.0001106602027217004},{2.249973672446181,2.1421539464994418e-16,
    -0.6324969443277787,0.2555641285353634,-0.16179658104004022,0.12010418925298748,-0.0955303622612798,
    0.07891039144300956,-0.06673395020703381,0.05733923289500815,-0.05020293697207573,0.0439903361977453},
    {2.1746154142033736,1.4570193944034298e-16,-0.5753555653518873,0.2045359334356826,-0.11407471920234313,
    0.07514848821988478,-0.053227383051377294,0.039223997702791814,-0.029628224604914922,0.022757126174648666,
    -0.01779598270042353,0.013955307371661995},{2.1056858994725314,1.6897987889309895e-17,-0.5290402425079892,
    0.16789030201069374,-0.08350431762110823,0.049379622875613025,-0.03149611391445447,0.020935860231359665,
    -0.014279928255248308,0.00991172581865274,-0.007000639151887204,0.004966030520388323},{2.0420272287423002,
    -8.072201738560517e-17,-0.4906311144335872,0.14065883290713913,-0.06302503009646442,0.03377129331025998,
    -0.0195774288468056,0.011845580431620244,-0.007361728568051102,0.00465897439021152,-0.0029993974897275883,
    0.0019417676862541731},{1.9827807273633573,-3.241362807975987e-17,-0.45817877577951194,0.11984724666715581,
    -0.04879143998590115,0.023877970349859477,-0.012678209323102992,0.007036166573899386,-0.004014426805120119,
    0.002333837760543412,-0.0013800068528007315,0.0008213919970592793},{1.9272911655694132,-2.5821930285386192e-17,
    -0.43033180316349745,0.10356481728191476,-0.03858928756622572,0.01736394970070983,-0.008499833619241375,
    0.004354924874464768,-0.0022957161034572217,0.0012338593919898554,-0.0006744480830122572,0.0003714126836376534},
    {1.8750465161798147,-2.324929484134442e-17,-0.4061234511342324,0.090570290470159,-0.031083001718109144,
    0.012934073254093029,-0.005870131240378189,0.002792105146325054,-0.001367469928236538,0.0006831958506740944,
    -0.00034714292472472306,0.0001778313227986038},{1.8256385252167118,-9.995930950672104e-17,-0.38484353529543425,
    0.08002149928646544,-0.025434725495143255,0.009836634573655087,-0.004159462059077343,0.0018456105126676138,
    -0.0008438412009479769,0.00039376610789202814,-0.00018688377769493842,8.947675501144159e-05},{1.756137225291757,
    2.209448098284576e-17,-0.7145640983039984,0.2701829513704662,-0.15446591197356543,0.10792096660104498,
    -0.08273153404277389,0.06666936777454366,-0.05541620404038651,0.04704463932225471,-0.04085497886304742,
    0.03562166595999717},{1.6707606839409495,-2.258652074345132e-17,-0.6535059203868947,0.22097302255986004,
    -0.1112323315415263,0.06872330814512762,-0.04678919710287775,0.03356338306870479,-0.024865503536183404,
    0.018830034558826078,-0.014573696669022763,0.01134708489252776},{1.5923233641821881,7.769716322795666e-17,
    -0.6029913486924552,0.184898623539102,-0.08305478920074029,0.045920590243689274,-0.028088433228017136,
    0.01814143877652079,-0.012115741501321557,0.008277141945305544,-0.005776078875454758,0.004061029375001161},
    {1.5196866879747293,8.045676719790831e-17,-0.5603323920434773,0.1575689971897605,-0.06386568088631003,
    0.031911181578621495,-0.01770266364887779,0.010391261602195447,-0.006314395414179515,0.003927855524846068,
    -0.0024949345803006837,0.0015985949693172988},{1.4519897043113394,8.079807981346285e-17,-0.5237044022853152,
    0.13629967296811948,-0.050318180528682366,0.02290952129184265,-0.011617314674638663,0.00624606314129937,
    -0.0034803645975471052,0.0019865328931775966,-0.0011576366534841616,0.000681158835499548},{1.388563319609662,
    1.0482621706978678e-16,-0.491822291654665,0.1193720595636094,-0.04046131749576652,0.0169047044213175,
    -0.007888387405972138,0.003910427054833987,-0.002011177971031889,0.0010602557479772955,-0.0005706232448479212,
    0.0003103427822575322},{1.328875595980716,-3.638421225442617e-17,-0.4637527963202657,0.10564294722848037,
    -0.03310431434048877,0.012769640909037618,-0.005514911242832501,0.00253492007342451,-0.0012101645106666762,
    0.0005925590742436593,-0.00029621385030231915,0.00014973870776623314},{1.2724954690397081,-1.3594764918080465e-17,
    -0.43880035954252233,0.09432683626352922,-0.02749159338123593,0.009843316340164115,-0.003954057498604582,
    0.0016934990567898957,-0.0007541162271798743,0.0003446407176330656,-0.000160810729734136,7.59242868444003e-05},
    {1.1933666780289074,-3.0577970519058924e-17,-0.8121800977397411,0.3228263981804909,-0.17043687726230058,
    0.11009914880287894,-0.07998697472260559,0.062113138002726054,-0.050225572399816176,0.04171992877360105,
    -0.0355839222423619,0.030569182313901506},{1.0965800976654136,-3.0105024140315945e-17,-0.7386900432794321,
    0.26787131703985584,-0.1258266635053036,0.07182952195020074,-0.046211852858392015,0.03187376370188566,
    -0.02293851798923422,0.01697825542127932,-0.012894034420155562,0.009882447643849202},{1.0081998141881598,
    8.031595894869887e-17,-0.677110299402486,0.22662140211266626,-0.096058041590267,0.04909713847015823,
    -0.028306575210425997,0.017541260251752556,-0.011363803567558178,0.007580501259219986,-0.005186698606324196,
    0.0035870642514833208},{0.9269255574786394,-2.109781372023684e-17,-0.6246057172611696,0.19470731542680297,
    -0.07533278957510764,0.034852147115172497,-0.018185448227838432,0.010220558730999982,-0.0060159545761474115,
    0.0036505444555967517,-0.002271950008129677,0.0014310309508062653},{0.8517530004406927,4.446913219698307e-17,
    -0.5792083059443978,0.1694036514958459,-0.060394770760540305,0.02552513636148267,-0.012154804408486075,
    0.006244464539586071,-0.003365526293169296,0.0018721424201812446,-0.0010682311702030084,0.0006175516366365602},
    {0.7818868188232941,-4.236464416115063e-17,-0.5395027600907106,0.14893208971916103,-0.04931333433421125,
    0.019190206639594073,-0.008399589088186664,0.003971139902885202,-0.001972629809021673,0.0010125051686844353,
    -0.0005332140534770614,0.00028477631605927287},{0.7166841656463298,-2.171826440407551e-17,-0.504440952063837,
    0.1320879950133881,-0.04089082532225367,0.014751815898552376,-0.005972176773072575,0.002613477346267487,
    -0.0012032726337528339,0.0005730683057277142,-0.00028012806053760215,0.00013898927290636096},{0.6556164853564647,
    3.998905272810967e-17,-0.47322730398368107,0.11802913063733102,-0.03435536580120455,0.011558304235803661,
    -0.004351854641111404,0.001771719914683234,-0.0007597632560075434,0.00033737376527638796,-0.00015382879249476483,
    7.125018411584721e-05}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_beta_zero_overlap)

/* beta at zero force by eps, 2^-23 <= eps < 2^-1: 176 rows of degree 10 in y = eps 2^-k, 8 to each octave k = -23 ... -2.
 * Relative error of the approximation: 2^-55.1 at most, proved for the whole cell of each row. Bits of the rows:
 * 55.8 57.6 58.3 58.7 59.0 58.9 62.5 62.1 55.8 57.4 59.1 59.5 61.8 61.0 62.0 60.1 55.7 57.2 57.8 58.6 58.6 59.5 59.3
 * 61.2 55.8 57.1 58.9 58.9 59.2 59.0 58.7 59.6 55.8 57.4 58.2 58.9 61.1 60.6 59.3 59.9 55.7 57.5 58.6 59.4 60.6 59.9
 * 60.5 61.0 55.7 57.1 58.6 58.8 59.2 59.7 59.7 64.2 55.8 57.1 58.1 59.3 59.2 60.1 59.7 59.3 55.8 56.9 58.6 60.4 59.0
 * 59.8 58.9 61.9 55.8 57.3 58.6 58.7 60.9 60.9 60.0 59.9 55.6 57.2 58.9 58.4 60.1 60.6 59.5 60.8 55.8 57.4 58.1 58.7
 * 60.3 60.0 58.8 60.6 55.7 57.4 58.7 58.3 61.6 61.6 60.0 61.4 55.7 57.1 58.4 59.6 59.9 58.8 60.0 59.7 55.7 57.5 57.8
 * 58.2 61.7 59.3 60.6 59.6 55.6 57.3 59.1 58.7 58.5 59.0 61.3 61.6 55.7 57.4 58.2 59.4 59.0 59.0 59.3 59.8 55.8 57.2
 * 58.1 59.5 58.5 60.5 59.9 59.1 55.7 56.9 58.8 58.7 61.1 58.6 59.5 59.7 55.6 56.9 58.4 57.9 61.0 59.5 58.7 60.6 55.3
 * 56.7 58.3 58.1 58.7 57.8 58.2 59.0 55.1 56.3 58.3 58.2 60.4 61.1 59.9 58.1 */
#define COR_ROWS_BETA_ZERO_FORCE_FIRST 1.1920928955078125e-07
#define COR_ROWS_BETA_ZERO_FORCE_FIRST_OCTAVE (-23)
#define COR_ROWS_BETA_ZERO_FORCE_OCTAVE_BITS 3
#define COR_ROWS_BETA_ZERO_FORCE_ROWS 176
#define COR_ROWS_BETA_ZERO_FORCE_END 0.5
COR_ROWS(double, cor_rows_beta_zero_force, 176, 12)
#ifdef COR_ROWS_HERE
= {
    {16175.30250469648,7.475772000442145e-13,-9134.310385977926,6877.59500939998,-5609.959119890192,4751.965084127906,
    -4114.642662527381,3614.431121341716,-3207.3567820196813,2867.7531477840143,-2599.9105856112183,2349.2263452913344},
    {15131.06616807252,-5.002233745252904e-14,-7645.190612015213,5150.441384039001,-3758.9180813550715,
    2848.8640386322954,-2207.119869983349,1734.7187313914499,-1377.321020717332,1101.8565272537917,-892.3572213055681,
    721.4324791541604},{14249.18553914956,4.2970710539619744e-14,-6513.932405621322,3970.3945147760987,
    -2621.720407194777,1797.7510037967793,-1260.137801012303,896.0979668843073,-643.7213935311269,465.93159074836774,
    -341.00632168392616,249.4308541558323},{13492.264439615556,3.9033294584593945e-13,-5631.5717421574855,
    3134.090058586218,-1889.5380286379723,1183.0150186695657,-757.1295796165796,491.5855671729553,-322.42914591164134,
    213.0835813750452,-142.2659550373771,95.01180123490376},{12833.865074543837,7.220399164638436e-13,
    -4928.221102725421,2523.247431216683,-1399.5609814424172,806.1470554382576,-474.65936345801646,283.529850432343,
    -171.08920100085095,104.02222377738433,-63.851649121677625,39.231461380878436},{12254.712993824354,
    -7.89441561708765e-13,-4357.24734757929,2065.6564445540425,-1060.8801349153089,565.8026859569459,-308.4672258931798,
    170.6090275369893,-95.32407608238537,53.66392004215839,-30.484182735094368,17.342494864020804},{11740.39025591314,
    4.2641422367540526e-13,-3886.4893225719525,1715.4145966710616,-820.2440459255812,407.2935547144125,
    -206.7365787797134,106.45745262664573,-55.37870648341702,29.02607873191474,-15.344836226951257,8.127627042255272},
    {11279.873913635169,3.1291728994156983e-13,-3493.1368789016465,1442.3262523863266,-645.1694460797222,
    299.6915819620835,-142.3051554204899,68.55129791222541,-33.35945814952411,16.35689468808274,-8.086517419997444,
    4.006805883981747},{10671.704864152689,-3.2759262550787145e-13,-6026.402014787641,4537.522003577382,
    -3701.1935041851293,3135.1282540956963,-2714.6521129955336,2384.635478866428,-2116.066513893521,1892.0116318623593,
    -1715.3014132086998,1549.9114718768717},{9982.765256616736,5.444932501965334e-13,-5043.949014052989,
    3398.025313655986,-2479.9616554170257,1879.5496462060921,-1456.156267306974,1144.4876776382014,-908.6930820487635,
    726.9542658582182,-588.736252344032,475.96796522356004},{9400.940508282134,-2.9304901377944725e-13,
    -4297.596653184848,2619.4845326452823,-1729.6908548634938,1186.0735629242097,-831.3810257918933,591.2042535403098,
    -424.6977821276775,307.40023952057,-224.98028883198126,164.5630053648759},{8901.558336557884,-4.117878511607058e-13,
    -3715.4554729045035,2067.7292114845172,-1246.6305381480188,780.499000637856,-499.5193180823633,324.3255674118084,
    -212.723929738663,140.58275036634612,-93.86053531347342,62.68441695641051},{8467.176297003833,4.779198734397964e-13,
    -3251.416897040629,1664.7232545327743,-923.3661732503639,531.85882829037,-313.15844885297383,187.05996837494158,
    -112.87679164423758,68.62908135446571,-42.126382316047646,25.883114179723023},{8085.077991231312,
    2.7359439161459716e-13,-2874.714520568789,1362.8256963845654,-699.9200930397086,373.2906503558517,
    -203.51251172098432,112.55999889229955,-62.89044495294169,35.40498781498602,-20.1120623162316,11.441780702805609},
    {7745.751122302788,4.2799110948815245e-13,-2564.1298899043013,1131.7521742238296,-541.1594418604703,
    268.7136031962089,-136.39530373883528,70.23573755315418,-36.5363260566929,19.15007274165272,-10.123817568411594,
    5.362234650086569},{7441.923254781848,-1.0687864953690286e-13,-2304.6139154067328,951.5809943487532,
    -425.6532513599684,197.72276096691942,-93.88640978472475,45.22699823519862,-22.009037930976977,10.791527460593771,
    -5.335112510871201,2.643506324748754},{7040.680766472151,5.980877543300429e-14,-3975.9482739819705,
    2993.6499538392495,-2441.8780374468483,2068.413885814239,-1791.0028976378637,1573.27300354579,-1396.0834920415364,
    1248.2623458485589,-1131.6770439270101,1022.56034802856},{6586.149449229438,2.2093213995759487e-13,
    -3327.770596413158,2241.8621874600403,-1636.1652414747975,1240.0407250711005,-960.705111857599,755.0804393976158,
    -599.5139692123256,479.6110324196035,-388.421128988236,314.021789920742},{6202.287632548767,-4.1578466422723116e-13,
    -2835.3613189413754,1728.216588129384,-1141.1709415205123,782.5170094461623,-548.5070798195932,390.04943946926306,
    -280.1961001166866,202.80856109560452,-148.43165969636811,108.57110972619951},{5872.817672851473,
    -6.176345251554132e-14,-2451.2910701265964,1364.1936470848223,-822.4698660961016,514.9375067730714,
    -329.55995022041947,213.97513248322184,-140.34548593825906,92.75004411694077,-61.92487044066607,41.3562986721844},
    {5586.2318425897365,-1.672955058834936e-13,-2145.13952300288,1098.3087260928846,-609.1948350914502,
    350.89611574948003,-206.6075959366667,123.41358926327064,-74.47092803829324,45.27831763742683,-27.79305270028005,
    17.07648992242909},{5334.140443012883,-3.280732166281937e-13,-1896.6084118642545,899.1304995340973,
    -461.7753346207908,246.28009616342646,-134.2682338710006,74.26192725326517,-41.49223075089969,23.358586158370187,
    -13.269015403068254,7.548761483052244},{5110.267694871874,1.141463588049117e-13,-1691.6987718626385,
    746.6787322253266,-357.0323174020493,177.28494952042476,-89.9873764277229,46.33832083616518,-24.104992419740352,
    12.634339362035867,-6.67923015764548,3.5377562251119157},{4909.81557707573,1.0345359547929945e-13,
    -1520.4819018943026,627.8100029920746,-280.8266128492665,130.44844164832898,-61.94195604647889,29.838701369642553,
    -14.520554178883268,7.119754799888833,-3.5198624074361304,1.74406412360053},{4645.093576797415,
    1.752435846596939e-13,-2623.154640913036,1975.0747193277198,-1611.03992175365,1364.6450174160004,
    -1181.6217824856997,1037.9734807626892,-921.0719064466133,823.5462560422153,-746.6285966193718,674.6383899115141},
    {4345.2138963519865,-3.5724696761064184e-14,-2195.5163261317834,1479.079369791122,-1079.4674009578425,
    818.1222878246344,-633.8293164656546,498.1675159555303,-395.53185552359554,316.4253761945554,-256.26244876786916,
    207.17717098935887},{4091.958758811158,-1.444814095232601e-13,-1870.646915652909,1140.1993549557671,
    -752.8927390870989,516.2690481938758,-361.87991516688834,257.3367791362437,-184.86055865725416,133.80379699106,
    -97.92840501533034,71.63023919468868},{3874.5889150173466,9.674423710566793e-14,-1617.2546736553547,
    900.0335483794225,-542.6282930862751,339.73231160427343,-217.42861116371046,141.17101079572095,-92.59352941150787,
    61.19223165989384,-40.85519201993535,27.28498996424642},{3685.5120889231907,-8.407221060398463e-14,
    -1415.2696547811574,724.6147369926464,-401.91913835518733,231.50528769558463,-136.31026694887973,81.42264775267029,
    -49.13251222441508,29.8725613823771,-18.336583146827014,11.266285488474658},{3519.193137838951,
    -1.4365729415970986e-13,-1251.2999875794317,593.2059665719604,-304.65845837247167,162.4844087332256,
    -88.58405998352372,48.99462871792898,-27.374677047082603,15.410926382895235,-8.7542888287487,4.980327011653521},
    {3371.4915869460647,4.1595517381065685e-14,-1116.1097919190572,492.6251891395461,-235.55377650475668,
    116.96455517274742,-59.36957162389896,30.571909435825532,-15.903372589070367,8.335559280717968,-4.406650361258902,
    2.334049546384595},{3239.241919056187,8.925200880018313e-14,-1003.1485621233488,414.20097439422017,
    -185.2767134692786,86.06396021855245,-40.866482773444346,19.686214246359658,-9.579998495876678,4.697288735516057,
    -2.3222441802661913,1.1506536673393297},{3064.589695383903,-4.5832196375500405e-14,-1730.6452927174118,
    1303.066238038463,-1062.8914890876772,900.3309141733619,-779.5803147993082,684.8076016158714,-607.681209319758,
    543.338195213565,-492.5914085580573,445.09554121187455},{2866.74185195041,-2.2728854790893977e-13,
    -1448.5085679541846,975.8308502560369,-712.184021043922,539.7600567569222,-418.1717966069751,328.668250694279,
    -260.9538849546226,208.76301925049356,-169.07025500534291,136.68602440246895},{2699.654809984802,
    -3.2452306855787825e-14,-1234.1741415470094,752.2530481956122,-496.72482877017,340.6109901333779,
    -238.75195449791028,169.77910604308457,-121.96257638625202,88.27764260351466,-64.60869061712634,47.25835880651123},
    {2556.243295659032,-1.4250946282612122e-13,-1066.9971415822504,593.8024197489965,-358.0018408999435,
    224.1400535410623,-143.4495489001124,93.13822110252046,-61.08899716286426,40.37184586243486,-26.954391803173138,
    18.001390480061787},{2431.4982657705186,1.8117851931855252e-13,-933.7363243926078,478.0689376040539,
    -265.16828326134447,152.73676250022206,-89.93134785121815,53.71896891606912,-32.415397857966184,19.708555807082156,
    -12.097641629569015,7.4329810637445775},{2321.767880885984,9.268255121403328e-14,-825.5563369157378,
    391.37129820376225,-201.00006358479064,107.19990697562959,-58.443760709771354,32.32443560550221,-18.060568548186364,
    10.167428096283643,-5.775680970950666,3.2857926517899627},{2224.3204406089553,-5.115188477796822e-14,
    -736.3637611197187,325.0125823057911,-155.40789931210307,77.16796285645329,-39.16936462141805,20.169961834751533,
    -10.492323570026917,5.499423091476828,-2.907307311856165,1.5398995248337635},{2137.067477741399,
    7.35143973399462e-14,-661.836867695154,273.27177175421855,-122.23734837743422,56.781143687337924,
    -26.961863826948445,12.988073910796391,-6.320448688416688,3.0990577498312266,-1.5321110754038103,
    0.7591488872969802},{2021.838960309326,-4.2778151395609516e-14,-1141.810627778826,859.706662879606,
    -701.2487595598985,593.99808254939,-514.3320300747698,451.805136897906,-400.92055008519947,358.46989191134287,
    -324.9894282338519,293.65378742736624},{1891.3067963868477,1.2759312465562001e-14,-955.668998492581,
    643.8112089052963,-469.86762974925045,356.10962899401386,-275.89099190660835,216.84050412871485,-172.16558058188144,
    137.73238447348712,-111.54488279832016,90.17922811529643},{1781.0692853470262,-5.1240445627115295e-14,
    -814.2603366613167,496.30440889693733,-327.7172434258657,224.71999857627694,-157.51785599586702,112.0126211189228,
    -80.46540629863573,58.24159654194375,-42.62588666232848,31.17892056103965},{1686.4518752367796,
    -5.166043200631123e-14,-703.9640747983786,391.7656238846417,-236.19397022867673,147.87768042624427,
    -94.64160941490972,61.44841966616118,-40.303769625136354,26.635521109377326,-17.7832881383107,11.87650158022879},
    {1604.1498187832124,5.626820127683156e-14,-616.0442278878147,315.40971970950943,-174.9464943782225,
    100.76897245803285,-59.33269917013717,35.441370614277766,-21.386222521125706,13.002816676338742,-7.9814773473093945,
    4.903944455600785},{1531.753791625818,-1.0876607198657919e-13,-544.6716207940742,258.21038237545645,
    -132.6111319678343,70.72578035218812,-38.558597584018976,21.32621839076142,-11.915552796019503,6.708011434099503,
    -3.8105337095900276,2.167817449251728},{1467.4615364999333,-1.7116013165753654e-14,-485.82608498543283,
    214.4297714161915,-102.53142572992431,50.91203593107249,-25.84221138788572,13.307241498396044,-6.922365159399465,
    3.6282722174716695,-1.9181103703540663,1.015956178730168},{1409.8951730839651,2.668205622492621e-15,
    -436.6563334338047,180.29341289669085,-80.64694954773744,37.46171483628374,-17.788246144133524,8.56895325056032,
    -4.169949461030188,2.0446192500334863,-1.0108179507077475,0.5008522023491346},{1333.871462727918,
    2.767882179170717e-14,-753.3268747133482,567.1992473457983,-462.65398386784585,391.8940709658541,
    -339.33362514650355,298.08098719353296,-264.5095010262562,236.5023873403988,-214.41343162860932,193.73955106449483},
    {1247.7508158204455,-4.063712555851845e-14,-630.5182037794825,424.7606113708383,-309.9987611346728,
    234.94572177934546,-182.0207866329047,143.06178440430878,-113.58719947210373,90.8696803030294,-73.59231856681946,
    59.49620556859156},{1175.019760027728,1.2725044531488087e-14,-537.2224491259482,327.44184813662525,
    -216.21407088793922,148.2605886600652,-103.92341203579886,73.90099844707291,-53.087511722402496,38.42521394842461,
    -28.122656342595455,20.57045523705669},{1112.5942232938312,-5.919370468546882e-14,-464.4533484153658,
    258.471532084731,-155.83094107818627,97.56337087487482,-62.44042634982509,40.54097412711947,-26.590648488232812,
    17.572935247044164,-11.732621441116853,7.835585066363562},{1058.2938717148572,6.15892609705066e-14,
    -406.44727362145574,208.09507532786998,-115.42246784035326,66.48308541771874,-39.14515209798735,23.38266916922395,
    -14.109689005202688,8.578683347755282,-5.265824204802453,3.235403957331909},{1010.5291331082425,
    3.416597551375461e-14,-359.35838361834857,170.3573069275746,-87.49138986667712,46.66188208375199,-25.43930510329236,
    14.070111596645233,-7.861359438959683,4.42565014105186,-2.514021321159118,1.4302295535477156},{968.1109523419076,
    8.36648383138995e-15,-320.5343416424574,141.47264712280756,-67.64606680610187,33.58962339509604,-17.049585414943458,
    8.77954159923405,-4.567074127825431,2.393774486794534,-1.265484467494934,0.6702828164296675},{930.1302602506569,
    1.941617134828365e-14,-288.0939886640054,118.95085996368371,-53.20760579522479,24.715675731906323,
    -11.735927332049332,5.653425686781008,-2.751151102411113,1.3489501515225832,-0.6668931366311175,
    0.33044011680819885},{879.9718228571758,-1.8670974172306172e-14,-497.02579022476203,374.2172999175825,
    -305.2406735477259,258.5554956448644,-223.87797809526288,196.66105137836777,-174.5119103417584,156.0339532612562,
    -141.46056945972632,127.82081141564738},{823.1515382343678,9.96034543299557e-16,-416.0010675552226,
    280.2419171639595,-204.52503846542515,155.00758302288276,-120.0896909221461,94.38607747286869,-74.93994641486475,
    59.95187226755121,-48.552997892852765,39.25298481930495},{775.1652281482704,-1.1336402260649144e-14,
    -354.447809657112,216.0347802104826,-142.6497125653566,97.81634764293656,-68.56435504837044,48.75675833676792,
    -35.0248709494706,25.351298578073358,-18.554106840046835,13.571487624636855},{733.9781418642905,
    1.3300781584221609e-15,-306.4372463108261,170.53080260260904,-102.81134910095156,64.36841797697721,
    -41.19562659194399,26.747236126606136,-17.543380729469604,11.593868992743554,-7.740676513740201,5.169578270767512},
    {698.1517785102095,2.5213622821064402e-14,-268.166767466267,137.29431060514347,-76.15144231956072,
    43.862917727547554,-25.82637725105285,15.42691297448082,-9.308977597230855,5.65984945989579,-3.474164373921381,
    2.134579478372006},{666.637398179536,-5.574279681473135e-14,-237.0990399139035,112.39632635542323,-57.7236124578509,
    30.78569144060188,-16.78382721780137,9.282879165738638,-5.186595509646587,2.9198563268722513,-1.6586437136389227,
    0.9436038329612503},{638.6505062959518,-1.684898369649677e-14,-211.48415595008055,93.33927792298569,
    -44.63043727273821,22.16114022432405,-11.248635058095887,5.792382132453058,-3.0131653710657638,1.5793114974429154,
    -0.8349127875817602,0.442223853133625},{613.5913320981738,-2.7177832092268882e-14,-190.08099978742877,
    78.48020771579512,-35.10449344675464,16.306462651530815,-7.74290020754154,3.729900610366693,-1.8150957105179455,
    0.8899807702358109,-0.439987849999527,0.2180102809006869},{580.49732108265,-1.5784220061985516e-14,
    -327.9331126172338,246.89785082272783,-201.38725989611223,170.58525797947559,-147.70595061817593,129.74906485540342,
    -115.13581143641831,102.94471825476289,-93.32973802543304,84.33075086262332},{543.0077111637625,
    4.726989549214669e-14,-274.47525367905604,184.89608477878974,-134.93880422809787,102.2683532798164,
    -79.23057812756814,62.27220210639491,-49.44234757541126,39.55378227781244,-32.03324787279983,25.897469877766653},
    {511.34651947645284,2.620847867561347e-14,-233.8640167885919,142.5343200713426,-94.11569399623271,64.53574805932611,
    -45.23618470386862,32.16781112573695,-23.108012637396858,16.72575710213904,-12.241235487730638,8.953902386633539},
    {484.1712843186417,-2.5119200802522834e-14,-202.18781342634273,112.51223362889849,-67.83174196896671,
    42.468050135439945,-27.17935565335963,17.64680128046163,-11.57443192166687,7.6491691998681945,-5.106982748568573,
    3.4106744138365963},{460.5329283669754,-5.512792678748295e-15,-176.93781536993154,90.58380807484016,
    -50.24244903691712,28.939270358559906,-17.039309810804006,10.178095124266777,-6.1417017339394455,3.7341439829120175,
    -2.292113424803241,1.408308248449305},{439.7395250212316,-5.517505201951385e-15,-156.43997725984758,
    74.1568476040273,-38.084382341126435,20.311385081994892,-11.073374025566395,6.124498911336567,-3.4219168554115407,
    1.926406610212267,-1.094306847780191,0.6225515694103831},{421.27348778863734,1.3288173751550632e-14,
    -139.5397685271172,61.583543886186156,-29.44593136817115,14.621209231130589,-7.421458318792885,3.821601992921113,
    -1.9879725110937438,1.041968451961156,-0.5508424329584575,0.2917615389095796},{404.7391048460726,
    1.7300039601388473e-14,-125.41834141687413,51.77993130819707,-23.16101545999735,10.75849463500377,
    -5.108501671346997,2.460854241222648,-1.1975323902011272,0.587175178743355,-0.2902867558836988,0.14383450730543715},
    {382.9030925549915,-1.8632171380221145e-14,-216.3768734369913,162.899684937836,-132.87031507856247,
    112.54703839049911,-97.45150291695109,85.60387709279455,-75.9623962798987,67.91904491715725,-61.575361558795215,
    55.63811828681139},{358.1665759087055,-2.4662178142714614e-14,-181.10605777350563,121.99239584394249,
    -89.02956604660916,67.47376207602402,-52.27382234257146,41.08508298045196,-32.62030078494128,26.09612911914138,
    -21.134326548211643,17.086152209431496},{337.2755844026312,2.8419257240295064e-14,-154.31115051411373,
    94.04302055163275,-62.095603719779824,42.578963286538375,-29.845459697820573,21.223264721486157,-15.24586653066449,
    11.035053041721063,-8.076314090124525,5.907445883124093},{319.3443910454037,-9.828985042965968e-15,
    -133.41139392852835,74.23503399054933,-44.75413432890546,28.0193537243664,-17.932148251119298,11.642799093646875,
    -7.63642047394203,5.04665325287398,-3.369402092362751,2.250236248002309},{303.7468132587635,2.6832033986118425e-14,
    -116.75152855669191,59.76704089207271,-33.14914716383797,19.09345028633856,-11.24206296934377,6.715195064715071,
    -4.052093840766329,2.463660219322362,-1.5122550810591489,0.9291504204600856},{290.02633000207277,
    2.7669152429954842e-14,-103.22706020863492,48.92878458648382,-25.127531568731907,13.40100628600602,
    -7.305918518940272,4.040763200390394,-2.257671984832881,1.270978659151849,-0.7219856348168981,0.4107372436896022},
    {277.84144570466646,-2.8374324160834016e-14,-92.07625601033595,40.633086117281756,-19.42806477464407,
    9.646775798037702,-4.896490766685054,2.521384029323682,-1.311602928778895,0.6874567975119948,-0.36342710536272615,
    0.19249401732112936},{266.9310750071144,-1.8216490154705997e-14,-82.75885764609104,34.164773171876355,
    -15.281400783509492,7.098251990096742,-3.370466782189996,1.6236040703603871,-0.790096027377482,0.38739950960166414,
    -0.19152154314815606,0.09489705274223928},{252.52221935599934,3.877384297050273e-15,-142.7808114888688,
    107.48310069049123,-87.66686844267024,74.25667123560609,-64.29634345963879,56.47922264547862,-50.11781928202844,
    44.810908168779015,-40.62544106615701,36.70816815955826},{236.199177870994,3.52241668536132e-15,-119.50862220484716,
    80.49269381001666,-58.741408377569016,44.518272258772136,-34.48923788751522,27.106959392943736,-21.52200134316027,
    17.217469290040118,-13.943778546118098,11.272893631520889},{222.41347938845493,1.2446111824985902e-14,
    -101.8288066642626,62.05173938318416,-40.970708931495544,28.093147385820327,-19.691517905446894,14.002647904564487,
    -10.058841683072517,7.280625354331795,-5.3285150302758435,3.897550377172905},{210.58072282569657,
    1.3881514703882068e-14,-88.03861303163534,48.9823849298807,-29.52896828255528,18.48695308687942,-11.831363635167806,
    7.681688702251173,-5.038332718459493,3.3296512356541044,-2.223037328758678,1.484639250715411},{200.28775163089324,
    3.4379466366449166e-15,-77.04591681340312,39.436315855520675,-21.87207183002959,12.597765639226516,
    -7.417371563194543,4.43056629041599,-2.6734843236961714,1.62546304143153,-0.9977457234132088,0.6130271037480516},
    {191.23335055678226,-5.210734410357163e-15,-68.12198000090883,32.28512881835186,-16.57943817827518,8.84195666108605,
    -4.820369908554812,2.666031628408052,-1.4895672507109436,0.8385627065994559,-0.4763479248534199,
    0.27099329822222273},{183.19219756057333,-8.807886019276852e-15,-60.76421406320819,26.811515850923183,
    -12.818934051134006,6.364949980982013,-3.230665440995197,1.663574180580958,-0.8653718452777198,0.4535693332166026,
    -0.23978053517324288,0.1270025707742265},{175.99202506680916,8.27652473027009e-15,-54.616157033492804,
    22.543612963093928,-10.082956561964606,4.683451652000214,-2.2238146404665278,1.0712345432561055,-0.5212923632734253,
    0.2555985093519069,-0.12636160193521667,0.06261073498390485},{166.48289558679636,-4.308060465662413e-15,
    -94.22929252805923,70.9235085656734,-57.844718740044065,48.99511681016407,-42.422573694654986,37.26447613069114,
    -33.06703709323049,29.565446702943238,-26.803830862215534,24.21920955882502},{155.71023090911655,
    4.453634763305227e-15,-78.87285715683586,53.11449797663843,-38.75940886632216,29.373733514764158,-22.75606817521154,
    17.885025857996588,-14.1999859254238,11.3598322969541,-9.19985482139886,7.437624112545124},{146.61187475656635,
    4.002642190946963e-15,-67.20644147670936,40.94652326925404,-27.034027513275916,18.536371001150897,
    -12.992587936690056,9.238923119878793,-6.6367482114461795,4.80366995455167,-3.515672268601764,2.5715329565829976},
    {138.80221948342512,1.2918006456971908e-15,-58.10654429612276,32.32282609671325,-19.484530712501208,
    12.198124568120841,-7.806458768734604,5.068392844172553,-3.3242700012308624,2.19687359964619,-1.4667314702721777,
    0.9795414414671657},{132.00864757380535,2.608827677310606e-15,-50.852559723600294,26.023873890579438,
    -14.432312794944071,8.31236504385296,-4.894091217961093,2.923311884292433,-1.7639616477580986,1.0724702310856344,
    -0.6583023036818515,0.40446696103327695},{126.03240292696401,7.557043660273458e-16,-44.963647855423275,
    21.305132392004296,-10.94006961650834,5.8342196340034835,-3.1805711193437993,1.7590716433593325,-0.9828192085020828,
    0.5532806619975141,-0.3142906074318061,0.17879830922310266},{120.72480589437014,8.990151331519877e-16,
    -40.10818540660894,17.693310057522453,-8.458753997016881,4.1998391107235005,-2.1316672630815052,1.0976469892160883,
    -0.5709765625850742,0.2992646431309857,-0.15820589286958073,0.08379514052739376},{115.97218391397811,
    -3.443246994556531e-15,-36.05096607449189,14.877061344146364,-6.653444313612836,3.090344706024009,
    -1.4673329423990629,0.7068175921143278,-0.343952808979545,0.16864435283536172,-0.083373002669085,
    0.04131013106261738},{109.69529895993287,-1.5191658675269342e-15,-62.20098905597925,46.805033348657055,
    -38.170554444104084,32.329459702023904,-27.99181243070591,24.587883669303228,-21.818038718836682,19.507451598504375,
    -17.685181113951685,15.979745471084383},{102.58407523881027,5.993615218634738e-15,-52.06658563275677,
    35.05312774331655,-25.577017301758758,19.382555346475485,-15.015381449186249,11.801034705358992,-9.369408546711549,
    7.495341596075345,-6.070112043733716,4.907348924504908},{96.5778168354714,6.333610163113097e-15,-44.36719316770576,
    27.02351238215447,-17.839855330049634,12.231584019771974,-8.573138632620672,6.096157423631312,-4.379084974643828,
    3.16953848315681,-2.3196750632360805,1.6967098433942571},{91.42206253821188,4.487127390029317e-15,-38.3614540258953,
    21.332654875315388,-12.858141314374393,8.049280237325783,-5.151138196843767,3.3443315147819286,-2.193451461102672,
    1.4495434661671267,-0.9677704778371244,0.6463102274094518},{86.93690970765358,-5.839583262025995e-15,
    -33.57385983965061,17.17584517428228,-9.52427006527302,5.485225435913051,-3.22943136752136,1.9289384489565322,
    -1.1639237403576526,0.7076437484317672,-0.4343602547774786,0.26687258099555555},{82.99119517301271,
    5.069424429447057e-15,-29.68711295413812,14.061795818207399,-7.219768083287578,3.8499797331869696,
    -2.098765441684489,1.1607290385761004,-0.6485039447567011,0.3650716675509303,-0.2073762473723347,
    0.1179741794471076},{79.48680053000746,-1.046908733819068e-15,-26.482378122629946,11.678197719083332,
    -5.582346982954049,2.7714945516892775,-1.406639904665431,0.724292619280222,-0.3767565558484497,0.19746549422601117,
    -0.10438861428386464,0.055289799092594},{76.3487083841047,2.9114246165583808e-15,-23.804442733541347,
    9.819602206981576,-4.391006876553467,2.0393601316062595,-0.9682708246899453,0.46640448056372374,
    -0.22695768984381856,0.11127836586558561,-0.05501216691940199,0.027257457308728462},{72.20396589048893,
    6.142749952993847e-15,-41.073662796955055,30.894700989601,-25.19164919741666,21.335053749661068,-18.47166639808127,
    16.22491436845062,-14.396831783824686,12.871942803467672,-11.669357802176165,10.543927483853196},{67.5079860646241,
    6.764875100091185e-15,-34.38408440702684,23.13861064153821,-16.880750428306253,12.79137243058933,-9.908785064927832,
    7.787338651626514,-6.182586090725495,4.9458512122276925,-4.0053423417738205,3.238057172872079},{63.541393616960114,
    -2.221864401321551e-15,-29.301602253597856,17.839012881851065,-11.774610663854029,8.072338777954903,
    -5.657605616238937,4.022839409918072,-2.8896683783704673,2.091469716323157,-1.5306485022651264,1.1195669748553534},
    {60.13624283676873,3.5030110177693013e-15,-25.33695834046393,14.082895638187292,-8.486849225236204,
    5.312317999330392,-3.3994184896869855,2.2069538244142817,-1.4474353471506964,0.9565168412920608,-0.6385956753730148,
    0.4264698833442324},{57.173793403088126,3.0293378133734485e-15,-22.17633389363667,11.339208868795572,
    -6.286555805114597,3.6201922214292908,-2.131257551637801,1.2729447796905988,-0.7680722454910948,0.46696225902166766,
    -0.28662157701807384,0.17609866170191263},{54.56747168633368,-3.4888378263855136e-15,-19.610318647318426,
    9.283732170751094,-4.7655918235267425,2.5410050973632563,-1.385103020869306,0.7660007428063764,-0.4279533825249673,
    0.2409078073155266,-0.1368431085830326,0.07784733567957011},{52.252513198046096,3.0427196095776217e-15,
    -17.49448223614342,7.710356168513843,-3.6848745171318664,1.8292408440324783,-0.9283447031474124,0.4779906859272805,
    -0.24862847066973318,0.13030753107197834,-0.06888459284483882,0.03648433389691716},{50.179400186411954,
    -9.075783934141397e-16,-15.72638262983574,6.483491766090824,-2.8985583711241434,1.346047513791705,
    -0.6390446541887034,0.30780453621802506,-0.14977559458262152,0.07343354864011103,-0.0363021786153011,
    0.017986692497440882},{47.44105981922039,2.4463804274025028e-15,-27.137702930168214,20.399670014044226,
    -16.629999392565473,14.082323956324089,-12.191362892418843,10.707915208528906,-9.50106064098789,8.494463569390316,
    -7.700663386171744,6.957849521272994},{44.338214117939266,2.7929436620667356e-15,-22.72044479649263,
    15.279442493351445,-11.14423664843986,8.443375116846369,-6.540063640989933,5.139547336059826,-4.080252865446176,
    3.263949616539718,-2.6432024002391104,2.1368101423870485},{41.717013341059975,-8.369835888842741e-16,
    -19.364146566222058,11.780699804351055,-7.77369326416444,5.328637481125409,-3.7343002160893803,2.6551036608891616,
    -1.907112812958271,1.3802707473152127,-1.0101261873370238,0.7388225015594178},{39.4665817295932,
    2.756462546952299e-16,-16.74585196431433,9.300822055328464,-5.6033660002334775,3.506858698167738,
    -2.2438603906718786,1.4566483380662327,-0.9552978003623126,0.6312703820390906,-0.42143958049104396,
    0.28144065998848333},{37.5085243298284,3.2792965466419214e-15,-14.658402572495056,7.489285496856201,
    -4.150843752405423,2.389917086250096,-1.4068294599359945,0.8402015061512469,-0.5069354647700924,0.3081871075242838,
    -0.1891591013496077,0.11621516683425005},{35.78568050072728,3.4189503432173676e-15,-12.963556701763476,
    6.13207867443375,-3.1467413959718993,1.6775418615891105,-0.9143271568355783,0.505609538716637,-0.28246058782120725,
    0.1589985899359797,-0.09031297408973091,0.05137580562359811},{34.25528711898403,-2.1385081836395502e-15,
    -11.56596526320245,5.0931483885961795,-2.4332517754175984,1.2076886982529846,-0.6128335843718147,0.3155131417158291,
    -0.164105393209319,0.08600455635998992,-0.045462991796919934,0.02407849382184525},{32.884646733603326,
    -2.803788770620002e-15,-10.397996167430275,4.282989123203144,-1.914106501455799,0.888710813182668,
    -0.42186937275931735,0.20318178745201296,-0.09886065184017676,0.04846808376042769,-0.023959467996518716,
    0.011870857324642478},{31.073987625768492,-2.926962905712913e-16,-17.94534525409274,13.477185313138278,
    -10.982598013678775,9.298176679503221,-8.048572438886048,7.0685760314569865,-6.2714769761097715,5.606748937401519,
    -5.082589873276632,4.5921627868009365},{29.021998816890505,-5.352491560646118e-16,-15.0268953094815,
    10.095606113392801,-7.360381500750807,5.57531992619313,-4.317916468711382,3.3929250201369445,-2.693423997027602,
    2.154450697890033,-1.7446317456697156,1.4103383144499841},{27.288246168673542,-4.937282470969422e-16,
    -12.809168648499268,7.784717803894139,-5.134678423425271,3.518837120385179,-2.465621385550346,1.75288174983519,
    -1.2589642353307966,0.91111854829464,-0.6667530025375683,0.48765448904792197},{25.799497616968385,
    5.512070198663466e-16,-11.078905628690567,6.146647216377756,-3.7014299042581658,2.3159526134747175,
    -1.481621242673979,0.9617164133462445,-0.6306590894910155,0.4167187877690774,-0.27818921408025327,
    0.18576904764644434},{24.503970014350028,-1.7528596436703323e-15,-9.699302882528608,4.949951589093019,
    -2.742145931444197,1.5784174037626257,-0.9289800659744333,0.5547488582654932,-0.33467786061014093,
    0.20345052225671043,-0.12486694250316967,0.07671201907105223},{23.36390336730817,-5.558829981360836e-16,
    -8.579062343429054,4.05331620252066,-2.078968512315946,1.1079988196162283,-0.6037950689042038,0.333847703232859,
    -0.18648769714671432,0.10496727744673395,-0.059619088225959294,0.03391353428110185},{22.351046426275968,
    5.688136871326416e-16,-7.655209235123514,3.366898374453861,-1.6077025786435113,0.7977139287976068,
    -0.4047184208263869,0.20833887697551562,-0.10835097474384685,0.05678035564688874,-0.03001289256320111,
    0.015894880339277113},{21.443796164497655,-1.1204494830700879e-15,-6.883072144513808,2.831590042755697,
    -1.2647822059412113,0.5870542899119033,-0.2786187836687116,0.1341704772465766,-0.06527557842975568,
    0.03199986752333691,-0.015817629352945336,0.007836521408618326},{20.245097389159145,2.8462345147765125e-16,
    -11.881390248664012,8.911281568261186,-7.257713556512367,6.14261054507685,-5.315980431531104,4.668016660848992,
    -4.141163939642262,3.701914936747975,-3.3555994954810466,3.0316411856343253},{18.886340621459116,
    -5.284370383205745e-16,-9.95151857705808,6.676467123064561,-4.864663731693488,3.6836048798796774,
    -2.8522011112303107,2.240841954090393,-1.7786482101311072,1.4225961946165795,-1.1519037499867861,
    0.9311275072893472},{17.73803935414754,1.166936235907668e-15,-8.484768746772959,5.1490499520287765,
    -3.3940725303654964,2.325137517072561,-1.6288167090786638,1.1577768288189463,-0.8314390412044584,0.6016567610824247,
    -0.44025463408228943,0.3219753753060916},{16.751790124351682,4.0209119980043685e-16,-7.3402346982694775,
    4.066206144781658,-2.4469812079399813,1.5304662155103324,-0.9788623464514761,0.6352628020571414,-0.4165262876088073,
    0.2751978219842773,-0.18369825418921792,0.12266133262254239},{15.893362014243014,7.364253300681318e-16,
    -6.427517381619874,3.2750370075893733,-1.813021626427419,1.0431795458572666,-0.6138018974683007,0.3664679308209354,
    -0.22105717368285988,0.13436555839980738,-0.08245885989855285,0.05065485130766595},{15.137790987674824,
    -1.4220082888040524e-16,-5.686281276799566,2.68217710335588,-1.3747062564130454,0.7323493189915558,
    -0.3989768606897695,0.22055667059438816,-0.12318473649337491,0.06932815354546884,-0.0393731048229194,
    0.022395121201648223},{14.466397279047657,2.794326262218742e-16,-5.074904569286996,2.228263032534076,
    -1.0632017763945205,0.5273108559966687,-0.26745235968908626,0.13764914782566445,-0.07157607725630097,
    0.037504183861889154,-0.019821937364466056,0.010496870663803743},{13.864895320861182,5.562188019282911e-16,
    -4.563859832081021,1.8742359879802253,-0.8365121645364203,0.3880942636400842,-0.18413580554462458,
    0.08865246143401012,-0.0431234486683433,0.021137572492987443,-0.010447274921434926,0.0051754444045372895},
    {13.0699891209269,-7.387085429574648e-16,-7.880081600452703,5.89952140282112,-4.800910796891651,4.061337923667604,
    -3.5136720857169177,3.084685053235194,-2.7360595966186585,2.4455149740300253,-2.2164884318121523,2.002320206932881},
    {12.168677066210456,4.097603156863548e-16,-6.60230384966878,4.421074985084141,-3.2185643656335827,
    2.4359152424014643,-1.8854802761884182,1.4809720446035888,-1.1752900384542113,0.9398814629342228,
    -0.7609490857998924,0.615043624133749},{11.406724428631547,-4.017584409479843e-16,-5.630933321063947,
    3.410413750064818,-2.2460108039450546,1.5378269044692825,-1.076899902640181,0.765271221565022,-0.5494589777507325,
    0.3975447541226349,-0.2908612086786365,0.21269584698804173},{10.752103999130323,5.159476539076333e-16,
    -4.872785113659546,2.6937861481693144,-1.619567245625655,1.0123933822715583,-0.6472671919528498,0.41994922931414935,
    -0.2752931155569302,0.1818554914595658,-0.12137463280596197,0.08103681032413373},{10.182161945254276,
    -4.990888062210174e-16,-4.268066410799558,2.170097391559994,-1.200177953940669,0.6901583070323483,
    -0.4059259997781706,0.24228711400477035,-0.1461180969182238,0.08879983536157288,-0.054487886803363375,
    0.0334682354630379},{9.680374285377606,-6.509088123889526e-16,-3.7768632836446048,1.7776070315667456,
    -0.9101728833451769,0.4845846634454016,-0.26388885407262896,0.14583569311528097,-0.08143315882561504,
    0.04582213299674624,-0.026019614927910325,0.014797939443177581},{9.234374576970692,4.3888557148316256e-16,
    -3.3716375012160844,1.477054296910258,-0.7040415537829242,0.3489616134331062,-0.17691826281374115,
    0.09102588496017498,-0.04732121836815017,0.024790521387693776,-0.013100406896023816,0.006936537733750056},
    {8.834703904195633,-2.383199695652441e-16,-3.0328500851315066,1.2426038914560023,-0.5540143411017052,
    0.2568654810100165,-0.1218191929911721,0.05863116354928874,-0.0285130654591258,0.013973339905004744,
    -0.006905230766133782,0.003420304163050859},{8.306369436380292,5.6380092071034365e-16,-5.238422297164473,
    3.9123469213526603,-3.180295058163049,2.688565599677048,-2.32494526876863,2.0404014022282717,-1.8093286473787389,
    1.6168596004059954,-1.4651867459268237,1.3234262065174915},{7.707077999866578,3.8149171640676954e-16,
    -4.390914778314821,2.9328436618944096,-2.132680228171965,1.6129418492419905,-1.2478646608832336,0.9797990222907287,
    -0.7773477637255757,0.621509401509841,-0.50309618899173,0.40657049728449535},{7.200233047173629,
    -2.642345888788325e-16,-3.746434633951834,2.263078232339315,-1.4886349624261082,1.0185054682352295,
    -0.7128695281784407,0.5063919139311865,-0.36347985086779794,0.26292388826945906,-0.19232963085522323,
    0.1406209421969134},{6.764610501434156,1.800278627089486e-16,-3.2432740409212077,1.788048430126166,
    -1.0736979582797648,0.6706556890720347,-0.4285518003184307,0.27793661515984425,-0.18214278499541572,
    0.12029206069388143,-0.08026952013130953,0.053583613000707304},{6.385194072662489,2.854530488589549e-16,
    -2.841828714540052,1.440828224668401,-0.7958481331846345,0.45728718217769626,-0.26881151346473936,
    0.16038126320921864,-0.09669172394974855,0.058747129374868264,-0.03603982664975192,0.02213293368649369},
    {6.051028041325118,-4.326692013758046e-16,-2.5156556314762333,1.180536702453153,-0.60367764179802,
    0.32114119149903547,-0.17478330293865632,0.09655139293437852,-0.05389551800956095,0.0303187575469957,
    -0.017212400933844275,0.009787279170114566},{5.753911329423043,-3.3918204792706627e-16,-2.246506941242924,
    0.9811728467040146,-0.467059108155927,0.23130577656359141,-0.11719967504336652,0.060273770239268575,
    -0.03132355117434966,0.016405189086453314,-0.008667249366135927,0.004588347146572203},{5.48756967307077,
    3.0152040752067197e-17,-2.021432856604077,0.8256238115801089,-0.3676063764426438,0.17029182531866352,
    -0.0807126348607491,0.03882918374875039,-0.018876458852423134,0.00924811738703646,-0.004569080826940797,
    0.0022627126050580927},{5.135346978992945,2.854582807507632e-16,-3.4931095794782454,2.60033521780302,
    -2.1108415695491494,1.782879813168204,-1.5407845912666966,1.3515766286657835,-1.198071409232573,1.0703070742882865,
    -0.9696629089612805,0.8756639278778515},{4.7356086761890275,3.8654141956049015e-17,-2.929704452669414,
    1.9501028177420003,-1.4160270173800193,1.069947038838883,-0.8272308570472907,0.6492056249282849,-0.5148641096156332,
    0.4115180246945725,-0.33302598816943163,0.26907146086339967},{4.397338524123517,3.783269811042625e-16,
    -2.501099321913322,1.505329778548703,-0.9887375826440434,0.6758341185092386,-0.47270648047485236,
    0.33561809540370796,-0.24080387119410446,0.1741288354623172,-0.12734076073855016,0.0930831523540795},
    {4.106442506260587,1.4086432061527512e-16,-2.16635540582787,1.1897714781264188,-0.7133667999591657,
    0.4451452589908873,-0.2842498898053041,0.18425177582842292,-0.12069674061937392,0.07968419481155443,
    -0.05315712894917899,0.03547628970333841},{3.8529456184675,1.873997068267645e-17,-1.899190099908882,
    0.95904462801375,-0.5289211989434649,0.303605559907392,-0.17834228851409856,0.10634609094929065,
    -0.06408678978213743,0.038923517239683604,-0.02387146730164595,0.014656375156044506},{3.629567936225852,
    6.030653766535081e-17,-1.6820500106900675,0.7860311164358389,-0.4013182222333172,0.21326971804339975,
    -0.11598733488203385,0.06403592236959592,-0.03572919331420831,0.020091997264479015,-0.011403018342280722,
    0.006482277289093645},{3.4308583529399117,-6.585318747668373e-17,-1.5028185974323016,0.6534790171466235,
    -0.31057925395856695,0.15364793386368544,-0.07779226405567179,0.039984017395302815,-0.020769642584310664,
    0.010873658537163522,-0.005742993598220679,0.0030394632619304657},{3.2526453187007687,2.3290807759120933e-17,
    -1.3528950271519298,0.5500310963827508,-0.24450902137766953,0.11314522445656014,-0.05358541348021916,
    0.025763531720914074,-0.012518794425984145,0.006130943339170596,-0.003028039731340414,0.0014991402325724445},
    {3.016831229242166,-6.484596469630479e-17,-2.339473751744767,1.7330099344823957,-1.4045110241399654,
    1.1849761150030156,-1.0232513438724928,0.8970463437591455,-0.79477589615105,0.7097349706615388,-0.642777397727194,
    0.5803002452407403},{2.7489932595717863,-5.5392561269363996e-17,-1.963903748199405,1.3002663764321745,
    -0.9426194500910063,0.7114263563272128,-0.549586058251987,0.43103763243056137,-0.3416683932218221,0.272972845977913,
    -0.22082816295506177,0.17836661183672434},{2.5221393117464808,-8.614796963096026e-17,-1.6780645666315959,
    1.0041315534555435,-0.6584561559736338,0.4495467294185403,-0.3141647406926064,0.22290837782031672,
    -0.15985129436772194,0.11554073222580871,-0.08446405438699651,0.06172197787580064},{2.3268856947505774,
    -1.6838534026473475e-16,-1.4547312815822624,0.7939443878382408,-0.4752559487985017,0.2962049471591899,
    -0.18897878106212815,0.12241415824946933,-0.08014571952205822,0.05288867256776403,-0.03526849009115127,
    0.023530056107760638},{2.156588411491188,-2.0623527538334556e-16,-1.2764189339778207,0.6402036631777824,
    -0.352504113743739,0.20209069671440044,-0.118605594630281,0.0706760761200881,-0.042567488649353814,
    0.02584174141677265,-0.01584232508137849,0.00972347176492026},{2.006396712118519,5.449153323512246e-17,
    -1.1314457018934823,0.5248781640342595,-0.2675542361167556,0.14200486496362483,-0.0771599288018549,
    0.0425694872042476,-0.023738370972765654,0.013342768787640423,-0.007569520819339312,0.004301570636764285},
    {1.8726771200629189,9.476583484536325e-17,-1.0117453340933573,0.43649323881551544,-0.20712740693336099,
    0.10233648697646441,-0.051765600165078834,0.026587574373404085,-0.013802860054610453,0.007222811166119315,
    -0.003813208502842217,0.0020174195572351503},{1.7526481144199721,-4.252348325963456e-17,-0.9115902828089804,
    0.36749269194124023,-0.1631156753680818,0.07538116578048176,-0.03566719411982126,0.017136004294826604,
    -0.008321654659677135,0.004073434136937789,-0.0020110035743006066,0.0009952613265714883},{1.5936549610659525,
    7.41909103507278e-17,-1.5783908412366405,1.1582854100361868,-0.9373879277071809,0.7897849620249506,
    -0.6813510431120415,0.5968667704860399,-0.5284985675282523,0.471710625274404,-0.427022656915326,0.3853736804439189},
    {1.4127975551909608,-9.134423253339575e-17,-1.327324305778734,0.8693907393360407,-0.6294681770689472,
    0.4743950240638296,-0.36612548513384374,0.2869283308630834,-0.2272962635646648,0.1815015125269422,
    -0.1467642582664154,0.11849843041982658},{1.2593424590635376,1.4587601620139928e-18,-1.1361765704956297,
    0.6715860762170878,-0.4399425198326517,0.29989980706396413,-0.20938341092440887,0.1484448516608478,
    -0.1063844606938531,0.07685358171503749,-0.0561566043963155,0.041020107957406654},{1.1270220050532973,
    9.528327455311848e-17,-0.9867903785625094,0.5311165089654117,-0.31770368749240413,0.1976816679668834,
    -0.12600172238610177,0.08155255014380457,-0.0533587055434322,0.03519236838424357,-0.02345676959843329,
    0.015643274808781513},{1.0113960926212415,2.8863342432234135e-17,-0.86749940367642,0.42831716554182225,
    -0.23576746607812868,0.1349195314472553,-0.0791112639070569,0.04710133226618636,-0.02835020629467926,
    0.017201025999415528,-0.010540070903399885,0.006466434515973636},{0.9092213317070817,-1.491004038793196e-17,
    -0.7705062968887926,0.35116392414168646,-0.17904482622373893,0.09483454123981286,-0.05148601052980471,
    0.02837931531710144,-0.01581520234157281,0.008884150453963097,-0.005037656755551029,0.00286154997709614},
    {0.8180669669320995,-4.2329253856912705e-17,-0.6904251908744626,0.292001928819934,-0.13868509546395158,
    0.06836063922379942,-0.0345542908274267,0.017730117030353196,-0.009198853809555822,0.004810652401515599,
    -0.0025385188470651698,0.0013424355831238687},{0.7360711774971495,-2.4388710754242217e-17,-0.6234306676251686,
    0.24578844750538903,-0.10928242444933477,0.05036432401133564,-0.023817621880310214,0.011430231383500068,
    -0.00554772245629873,0.0027137792144695336,-0.0013391509356673664,0.0006624427553424174}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_beta_zero_force)

/* h*^5 as two doubles: eps = h*^5 beta^-5 at zero overlap, exact in double precision from beta = 7
 * on. Proved. */
COR_INLINE const double *cor_rows_h_star_5(int i)
{
    static const double row[1][2] = {
    {5.158381704267685,-1.6948637100160543e-16}
    };
    return row[i];
}

/* u = ln(beta) >= 10: a_0 + a_0' + (a_1 + a_1') u + mu (a_2 + a_3 u + a_4 u^2) + mu^2 (a_5 + ... + a_8 u^3),
 * mu = beta^(-5/3), through nine enclosed collisions with u = 9.5 ... 13.5.
 * Relative error, proved for every finite double: below 2^-64.9. */
COR_INLINE const double *cor_rows_far_eps_zero_force(int i)
{
    static const double row[1][11] = {
    {1.3103706971044482,1.025387009368333e-16,5.1655384079723314e-23,-2.579551276819017e-39,2.168244783014463,
    -3.815714141854205,3.708733633902359e-13,5.6806442958008745,-11.496753274695909,2.7784433269135693,
    -2.3012819495831118e-05}
    };
    return row[i];
}
COR_INLINE const double *cor_rows_far_duration_zero_overlap(int i)
{
    static const double row[1][11] = {
    {-1.5911283981302142,9.703104149737501e-17,3.3333333333333335,-1.4802973504705574e-16,3.9311120913152524,
    -2.8705663999324e-13,1.0927097501855736e-14,2.4666016663613646,-0.00016642892455404412,1.7250178397203042e-05,
    -6.053656889718994e-07}
    };
    return row[i];
}
COR_INLINE const double *cor_rows_far_duration_zero_force(int i)
{
    static const double row[1][11] = {
    {0.5292707055846506,-2.1335895173810267e-17,2.9119348824543296,-6.8190283147421e-17,-0.18278579500949746,
    1.4065532711995616,2.119841189940182,5.508094704267209,-5.662820764644574,6.727705057560739,2.0558889783401417}
    };
    return row[i];
}
COR_INLINE const double *cor_rows_far_max_overlap(int i)
{
    static const double row[1][11] = {
    {1.3103706971044482,1.0253950335682593e-16,-1.2338512679165183e-24,6.637549895192945e-41,1.178244435098297,
    -1.9078570709220557,-6.4134792979591604e-15,3.3797683541014796,-5.8578204993253475,0.694450282726933,
    -1.3515008382677975e-07}
    };
    return row[i];
}
COR_INLINE const double *cor_rows_far_time_of_max_overlap(int i)
{
    static const double row[1][11] = {
    {0.4112019063928226,1.0851349915746465e-17,1.4559674412271648,-3.409650274515061e-17,-0.24750829704283556,
    1.2532768291104721,0.5299602974818066,1.8171711928851768,-0.9911267098991473,2.3075357726100187,0.256985173894879}
    };
    return row[i];
}

/* eps < 2^-23 at zero force: beta = (a/eps)^(3/5) (1 + e (b_0 + b_1 v + b_2 v^2) + e^2 (c_0 + ... +
 * c_4 v^4)), e = eps/a, v = -(3/5) ln(e), from the coefficients of far_eps_zero_force by formal
 * inversion. Columns a, a', b_0, ..., c_4.
 * Relative error, proved for every finite double: below 2^-55.7. */
COR_INLINE const double *cor_rows_far_beta_zero_force(int i)
{
    static const double row[1][10] = {
    {1.3103706971044482,1.025387009368333e-16,0.9928082737834458,-1.7471609294770694,1.698176085025842e-13,
    -1.1048465904886993,4.726755732489128,-4.832933167605828,-1.0537239708479985e-05,-5.767604031507391e-26}
    };
    return row[i];
}

#ifndef COR_SPHERE_ROWS_ONLY
/* The only evaluator of the sphere's tables. The scalar functions, the array functions and the header for embedding use
 * it.
 *
 * For beta from 0 to 8 (eps: to 7 at zero overlap, to 16 at zero force) a row of a table gives a quantity: a short
 * polynomial around the nearest node of a uniform grid. For larger beta a quantity is a power of beta times a function
 * of ln(beta). Up to beta = exp(10) rows give this function; from there to infinity three orders in mu = beta^(-5/3),
 * with their logarithms, do. The first coefficient of a row is a double-double and dominates, so the final addition
 * causes nearly all of the rounding error.
 *
 * Errors are in units of the last place (ulp) of the exact value. "Worst known" is the largest error, and its argument,
 * that tests/accuracy/test_accuracy --points 1e9 found. tests/unit/test_sphere.c tests these arguments.
 *
 * No function raises FE_INVALID, FE_DIVBYZERO or FE_OVERFLOW or sets errno, whatever its argument; FE_UNDERFLOW and
 * FE_INEXACT may be raised. Arguments that may be NaN are compared by their bits (number/pair.h). */
#ifndef COR_RUNTIME_SPHERE_EVAL_H
#define COR_RUNTIME_SPHERE_EVAL_H


/* ---- tails ---- */

/* Arguments outside a table: beta = -0 counts as 0; negative numbers and NaN give NaN. */

/* beta^(2/3) for 1 <= beta < 8. Relative error below 2^-69. */
COR_INLINE struct cor_inline_pair cor_inline_two_thirds(double beta)
{
    /* r has 26 bits, so its square is exact; |d| < 2^-23 if the error of cbrt is below 2^-27 */
    const double r = cor_inline_head(cbrt(beta)), square = r * r;
    const struct cor_inline_pair cube = cor_inline_product(square, r);
    const double d = (COR_INLINE_KEEP(beta - cube.hi) - cube.lo) / beta; /* r^3 = beta (1 - d) */
    return cor_inline_sum(square, square * (d * (2.0 / 3 + d * (5.0 / 9))));
}

/* The logarithmic factor of a tail. Up to u = end, rows in u = ln(beta) give it, with the error of u times the slope.
 * Beyond, three orders in mu = beta^(-5/3) give it. */
COR_INLINE struct cor_inline_pair cor_inline_log_factor(double beta, struct cor_inline_grid grid, double end,
                                                        const double *(*rows)(int), const double *(*far)(int))
{
    const struct cor_inline_pair u = cor_inline_log(beta);
    if (u.hi < end) {
        const int i = cor_inline_grid_row(grid, u.hi);
        const double *c = rows(i);
        return cor_inline_sum(c[0], cor_inline_row(cor_inline_place_of(c, cor_inline_grid_t(grid, u.hi, i) + u.lo)));
    }
    const double *c = far(0);
    /* mu < 6e-8, so its error is negligible: that of cbrt may be 2^-46 */
    const double root = cbrt(beta), mu = 1 / beta / (root * root), v = u.hi;
    const double orders = mu * ((c[4] + v * (c[5] + v * c[6])) + mu * (c[7] + v * (c[8] + v * (c[9] + v * c[10]))));
    const struct cor_inline_pair slope = cor_inline_product(c[2], v);
    const double more = ((slope.lo + c[2] * u.lo) + c[3] * v) + (c[1] + orders);
    const struct cor_inline_pair sum =
        slope.hi > fabs(c[0]) ? cor_inline_sum(slope.hi, c[0]) : cor_inline_sum(c[0], slope.hi);
    return cor_inline_sum(sum.hi, sum.lo + more);
}
#define COR_INLINE_LOG_FACTOR(beta, quantity, table)                                                                   \
    cor_inline_log_factor(beta, COR_INLINE_GRID(table), table##_END, cor_rows_tail_##quantity, cor_rows_far_##quantity)

/* factor beta^(-2/3), or factor beta^(-5/3) with `fifths`, as a pair times 2^exponent, which neither overflows nor
 * underflows. The relative error is that of the factor plus 2^-65. */
COR_INLINE struct cor_inline_pair cor_inline_power_parts(double beta, struct cor_inline_pair factor, int fifths,
                                                         int *exponent)
{
    const int e = cor_inline_exponent(beta); /* beta = m 2^(e - e mod 3), 1 <= m < 8 */
    struct cor_inline_pair whole, power;
    whole.hi = cor_inline_significand(beta) * (1 << (e % 3));
    whole.lo = 0;
    power = cor_inline_two_thirds(whole.hi);
    if (fifths)
        power = cor_inline_pair_times(power, whole);
    *exponent = (fifths ? -5 : -2) * (e / 3);
    return cor_inline_pair_over(factor, power);
}

/* The same, rounded to a double; 0 for an infinite beta */
COR_INLINE double cor_inline_power_tail(double beta, struct cor_inline_pair factor, int fifths)
{
    int exponent;
    const struct cor_inline_pair value = cor_inline_power_parts(beta, factor, fifths, &exponent);
    return cor_inline_scaled(value.hi, exponent);
}

/* ---- eps ---- */

/* Below this beta, eps is 1 to the last bit. The branch is necessary: if underflowing products are rounded upward, a
 * row exceeds 1. */
#define COR_INLINE_EPS_LEAST COR_INLINE_2_M60

/* h*^5 beta^-5 for beta >= 7; the next order is below 2^-75. The power and the quotient are double-doubles, so only the
 * final rounding counts: 0.5 ulp. */
COR_INLINE double cor_inline_eps_overlap_far(double beta)
{
    const double *h = cor_rows_h_star_5(0);
    const int huge = beta > COR_INLINE_2_100;
    if (beta > COR_INLINE_2_250)
        return 0;
    struct cor_inline_pair b, power, h5;
    b.hi = huge ? beta * COR_INLINE_2_M200 : beta;
    b.lo = 0;
    power = cor_inline_product(b.hi, b.hi);
    power = cor_inline_pair_times(cor_inline_pair_times(power, power), b);
    h5.hi = h[0];
    h5.lo = h[1];
    const double eps = cor_inline_pair_over(h5, power).hi;
    return huge ? eps * COR_INLINE_2_M500 * COR_INLINE_2_M500 : eps;
}

/* The same at beta = x^(1/5), x >= 2^14. Error 0.75 ulp, because the formula omits the second half of h*^5. */
COR_INLINE double cor_inline_eps_overlap_far_root(double x)
{
    return cor_rows_h_star_5(0)[0] / x;
}

COR_INLINE double cor_inline_eps_force_far(double beta)
{
    if (!cor_inline_is_finite(beta))
        return 0;
    return cor_inline_power_tail(beta, COR_INLINE_LOG_FACTOR(beta, eps_zero_force, COR_ROWS_TAIL_EPS_ZERO_FORCE), 1);
}

COR_INLINE double cor_inline_eps_zero_overlap(double beta)
{
    if (cor_inline_between(beta, COR_INLINE_EPS_LEAST, COR_ROWS_EPS_ZERO_OVERLAP_END))
        return cor_inline_row_value(
            cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_EPS_ZERO_OVERLAP), beta, cor_rows_eps_zero_overlap));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    return beta < COR_INLINE_EPS_LEAST ? 1 : cor_inline_eps_overlap_far(beta);
}

COR_INLINE double cor_inline_eps_zero_force(double beta)
{
    if (cor_inline_between(beta, COR_INLINE_EPS_LEAST, COR_ROWS_EPS_ZERO_FORCE_END))
        return cor_inline_row_value(cor_inline_grid_place_of_root(COR_INLINE_GRID(COR_ROWS_EPS_ZERO_FORCE),
                                                                  COR_ROWS_EPS_ZERO_FORCE_PLAIN_ROWS, beta,
                                                                  cor_rows_eps_zero_force));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    return beta < COR_INLINE_EPS_LEAST ? 1 : cor_inline_eps_force_far(beta);
}

/* eps at beta = x^(1/5), where x is the product of an impact speed g and beta_per_root^5. For x from 2^-40 to 2^14 or
 * 2^20 (beta from 1/256 to 7 or 16) rows in x itself give eps without a root, and only a fifth of the product's
 * rounding error reaches beta. For larger x, eps at zero overlap is h*^5/x. */
COR_INLINE double cor_inline_eps_zero_overlap_root(double x)
{
    const struct cor_inline_octaves grid = COR_INLINE_OCTAVES(COR_ROWS_POWER_EPS_ZERO_OVERLAP);
    if (cor_inline_between(x, grid.first, COR_ROWS_POWER_EPS_ZERO_OVERLAP_END))
        return cor_inline_row_value(cor_inline_octaves_place(grid, x, cor_rows_power_eps_zero_overlap));
    if (cor_inline_between(x, COR_ROWS_POWER_EPS_ZERO_OVERLAP_END, COR_INLINE_2_900))
        return cor_inline_eps_overlap_far_root(x);
    return cor_inline_eps_zero_overlap(cor_inline_fifth_root(x));
}

COR_INLINE double cor_inline_eps_zero_force_root(double x)
{
    const struct cor_inline_octaves grid = COR_INLINE_OCTAVES(COR_ROWS_POWER_EPS_ZERO_FORCE);
    if (cor_inline_between(x, grid.first, COR_ROWS_POWER_EPS_ZERO_FORCE_END))
        return cor_inline_row_value(cor_inline_octaves_place(grid, x, cor_rows_power_eps_zero_force));
    return cor_inline_eps_zero_force(cor_inline_fifth_root(x));
}

/* ---- 1 - eps = beta (c_0 + row) ---- */

/* A tiny beta is scaled, because the halves of the products would be subnormal. */
COR_INLINE double cor_inline_loss_product(struct cor_inline_place place, double beta)
{
    if (cor_inline_below(beta, COR_INLINE_2_M900))
        return cor_inline_row_product(place, beta * COR_INLINE_2_200) * COR_INLINE_2_M200;
    return cor_inline_row_product(place, beta);
}

COR_INLINE double cor_inline_loss_zero_overlap(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_LOSS_ZERO_OVERLAP_END))
        return cor_inline_loss_product(
            cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_LOSS_ZERO_OVERLAP), beta, cor_rows_loss_zero_overlap), beta);
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    return cor_inline_is_zero(beta) ? 0 : 1 - cor_inline_eps_overlap_far(beta);
}

COR_INLINE double cor_inline_loss_zero_force(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_LOSS_ZERO_FORCE_END))
        return cor_inline_loss_product(cor_inline_grid_place_of_root(COR_INLINE_GRID(COR_ROWS_LOSS_ZERO_FORCE),
                                                                     COR_ROWS_LOSS_ZERO_FORCE_PLAIN_ROWS, beta,
                                                                     cor_rows_loss_zero_force),
                                       beta);
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    return cor_inline_is_zero(beta) ? 0 : 1 - cor_inline_eps_force_far(beta);
}

/* ---- times and the largest overlap ---- */

/* The product of beta and factor, or infinity if it exceeds the largest double */
COR_INLINE double cor_inline_linear_tail(double beta, struct cor_inline_pair factor)
{
    const int huge = beta > COR_INLINE_2_1000;
    const double b = huge ? beta * COR_INLINE_2_M60 : beta;
    const struct cor_inline_pair product = cor_inline_product(b, factor.hi);
    const double value = product.hi + (product.lo + b * factor.lo);
    if (!huge)
        return value;
    return value >= COR_INLINE_2_964 ? cor_inline_infinity() : value * COR_INLINE_2_60;
}

COR_INLINE double cor_inline_duration_zero_overlap(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_DURATION_ZERO_OVERLAP_END) || cor_inline_is_zero(beta))
        return cor_inline_row_value(cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_DURATION_ZERO_OVERLAP), beta,
                                                          cor_rows_duration_zero_overlap));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (!cor_inline_is_finite(beta))
        return beta;
    return cor_inline_linear_tail(
        beta, COR_INLINE_LOG_FACTOR(beta, duration_zero_overlap, COR_ROWS_TAIL_DURATION_ZERO_OVERLAP));
}

COR_INLINE double cor_inline_duration_zero_force(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_DURATION_ZERO_FORCE_END) || cor_inline_is_zero(beta))
        return cor_inline_row_value(cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_DURATION_ZERO_FORCE), sqrt(beta),
                                                          cor_rows_duration_zero_force));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (!cor_inline_is_finite(beta))
        return 0;
    return cor_inline_power_tail(
        beta, COR_INLINE_LOG_FACTOR(beta, duration_zero_force, COR_ROWS_TAIL_DURATION_ZERO_FORCE), 0);
}

COR_INLINE double cor_inline_max_overlap(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_MAX_OVERLAP_END) || cor_inline_is_zero(beta))
        return cor_inline_row_value(
            cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_MAX_OVERLAP), beta, cor_rows_max_overlap));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (!cor_inline_is_finite(beta))
        return 0;
    return cor_inline_power_tail(beta, COR_INLINE_LOG_FACTOR(beta, max_overlap, COR_ROWS_TAIL_MAX_OVERLAP), 0);
}

COR_INLINE double cor_inline_time_of_max_overlap(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_TIME_OF_MAX_OVERLAP_END) || cor_inline_is_zero(beta))
        return cor_inline_row_value(
            cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_TIME_OF_MAX_OVERLAP), beta, cor_rows_time_of_max_overlap));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (!cor_inline_is_finite(beta))
        return 0;
    return cor_inline_power_tail(
        beta, COR_INLINE_LOG_FACTOR(beta, time_of_max_overlap, COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP), 0);
}

/* ---- the inverse ---- */

/* beta = m (c_0 + row). From eps = 1/2 on, m = loss = 1 - eps, which is exact, and the rows hold beta/loss as a
 * function of loss or its root. Below eps = 1/2, m = 1, and the rows hold beta by octaves of eps. The function computes
 * both and selects one by bits, because eps of many collisions scatter around 1/2. The error is that of the row plus
 * one rounding; at zero force the rounded root adds up to 0.6 ulp. */
COR_INLINE double cor_inline_inverse(double eps, struct cor_inline_grid near_grid, int root,
                                     const double *(*near_rows)(int), struct cor_inline_octaves grid,
                                     const double *(*rows)(int))
{
    const int near = cor_inline_bits(eps) >= cor_inline_bits(0.5);
    const double loss = cor_inline_choose(near, 1 - eps, 0), y = root ? sqrt(loss) : loss;
    const int i = cor_inline_grid_row(near_grid, y);
    const int j = near ? 0 : (int)cor_inline_octaves_row(grid, eps);
    const double t = cor_inline_choose(near, cor_inline_grid_t(near_grid, y, i), cor_inline_octaves_t(grid, eps));
    return cor_inline_row_product(cor_inline_place_of(near ? near_rows(i) : rows(j), t),
                                  cor_inline_choose(near, loss, 1));
}

/* a/eps as a pair; if eps is tiny and the quotient might overflow, a/(2^500 eps) */
COR_INLINE struct cor_inline_pair cor_inline_over_eps(const double *a, double eps, int tiny)
{
    struct cor_inline_pair numerator, denominator;
    numerator.hi = a[0];
    numerator.lo = a[1];
    denominator.hi = tiny ? cor_inline_raised(eps, COR_INLINE_2_500) : eps;
    denominator.lo = 0;
    return cor_inline_pair_over(numerator, denominator);
}

/* beta = (h*^5/eps)^(1/5) for eps below the table. Error 0.6 ulp. */
COR_INLINE double cor_inline_beta_overlap_far(double eps)
{
    const int tiny = eps < COR_INLINE_2_M500;
    const struct cor_inline_pair root =
        cor_inline_fifth_root_of_pair(cor_inline_over_eps(cor_rows_h_star_5(0), eps, tiny));
    return (root.hi + root.lo) * (tiny ? COR_INLINE_2_100 : 1);
}

/* beta = R (1 + e r_1(v) + e^2 r_2(v)), R = (a/eps)^(3/5), e = eps/a, v = ln(R), where eps is below the table: e <
 * 1e-7. */
COR_INLINE double cor_inline_beta_force_far(double eps)
{
    const double *c = cor_rows_far_beta_zero_force(0);
    const int tiny = eps < COR_INLINE_2_M500;
    const struct cor_inline_pair root = cor_inline_fifth_root_of_pair(cor_inline_over_eps(c, eps, tiny));
    /* (hi + lo)^3; hi has 26 bits, and lo is below 2^-12 hi */
    const struct cor_inline_pair cube = cor_inline_product(root.hi * root.hi, root.hi);
    const double lo = cube.lo + root.lo * (3 * root.hi * root.hi + root.lo * (3 * root.hi + root.lo));
    /* below 2^-500 the orders in e are negligible */
    const double e = tiny ? 0 : eps / c[0], v = -0.6 * log(tiny ? 1 : e);
    const double r1 = c[2] + v * (c[3] + v * c[4]);
    const double r2 = c[5] + v * (c[6] + v * (c[7] + v * (c[8] + v * c[9])));
    const double beta = cube.hi + (lo + (cube.hi + lo) * (e * (r1 + e * r2)));
    return beta * (tiny ? COR_INLINE_2_300 : 1);
}

COR_INLINE double cor_inline_beta_zero_overlap(double eps)
{
    if (cor_inline_between(eps, COR_ROWS_BETA_ZERO_OVERLAP_FIRST, 1) || cor_inline_bits(eps) == cor_inline_bits(1))
        return cor_inline_inverse(eps, COR_INLINE_GRID(COR_ROWS_NEAR_BETA_ZERO_OVERLAP), 0,
                                  cor_rows_near_beta_zero_overlap, COR_INLINE_OCTAVES(COR_ROWS_BETA_ZERO_OVERLAP),
                                  cor_rows_beta_zero_overlap);
    if (cor_inline_is_zero(eps))
        return cor_inline_infinity();
    return cor_inline_below(eps, 1) ? cor_inline_beta_overlap_far(eps) : cor_inline_nan();
}

COR_INLINE double cor_inline_beta_zero_force(double eps)
{
    if (cor_inline_between(eps, COR_ROWS_BETA_ZERO_FORCE_FIRST, 1) || cor_inline_bits(eps) == cor_inline_bits(1))
        return cor_inline_inverse(eps, COR_INLINE_GRID(COR_ROWS_NEAR_BETA_ZERO_FORCE), 1, cor_rows_near_beta_zero_force,
                                  COR_INLINE_OCTAVES(COR_ROWS_BETA_ZERO_FORCE), cor_rows_beta_zero_force);
    if (cor_inline_is_zero(eps))
        return cor_inline_infinity();
    return cor_inline_below(eps, 1) ? cor_inline_beta_force_far(eps) : cor_inline_nan();
}

#endif
#undef COR_ROWS
#undef COR_ROWS_HERE
#undef COR_ROWS_FUNCTION
#endif

#endif
