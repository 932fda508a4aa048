/* SPDX-License-Identifier: MIT */
/* cor_sphere.h: restitution coefficient, duration and largest overlap of colliding viscoelastic spheres,
 * x'' + beta sqrt(x) x' + x^(3/2) = 0, both ends of contact, for every beta, to embed with sphere_rows.h.
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
 * Written by:  corgen tables
 * Checked by:  corgen tables --check */
#ifndef COR_SPHERE_EMBEDDED_H
#define COR_SPHERE_EMBEDDED_H

/* The includes and the attributes with which C99, C++11, CUDA and HIP compile a function into its caller. A compiler
 * may call a COR_INLINE function, but must inline every COR_KERNEL function. A call prevents the vectorisation of a
 * loop, and arguments that are constants of the caller are then no longer constants. */
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
#ifndef COR_KERNEL
#ifdef __GNUC__
#define COR_KERNEL COR_INLINE __attribute__((always_inline))
#else
#define COR_KERNEL COR_INLINE
#endif
#endif

/* Bits of doubles, and sums and products with their rounding errors.
 *
 * The functions classify arguments by their bits, as integers. Floating-point comparisons raise FE_INVALID for a NaN,
 * and -ffinite-math-only lets a compiler assume that no NaN occurs. Products split their factors by a bit mask.
 * Veltkamp's multiplication would give wrong results where a compiler fuses multiplications with additions. */
#ifndef COR_RUNTIME_PAIR_H
#define COR_RUNTIME_PAIR_H


/* Powers of two, in decimal because hexadecimal constants need C++17 */
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

/* True if 0 <= x < end; false for -0 and NaN. The bits of nonnegative doubles, read as integers, have the order of the
 * doubles. The bits of negative doubles are larger. */
COR_INLINE int cor_inline_below(double x, double end)
{
    return cor_inline_bits(x) < cor_inline_bits(end);
}

/* True if least <= x < end; false for NaN. The unsigned difference is huge for negative numbers and for numbers below
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

/* Returns the float nearest to x, without FE_OVERFLOW. A conditional is not used: clang would convert both sides. */
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

/* True if x is negative or NaN; -0 is neither. */
COR_INLINE int cor_inline_is_refused(double x)
{
    return cor_inline_bits(x) > COR_INLINE_INFINITY_BITS && cor_inline_bits(x) != COR_INLINE_SIGN_BIT;
}

/* Returns if_true or if_false, selected by bits. A processor would mispredict half of the jumps for scattered
 * arguments. */
COR_INLINE double cor_inline_choose(int choice, double if_true, double if_false)
{
    const uint64_t mask = (uint64_t)0 - (uint64_t)(choice != 0);
    return cor_inline_from_bits((cor_inline_bits(if_true) & mask) | (cor_inline_bits(if_false) & ~mask));
}

/* Returns 2^k, -1022 <= k <= 1023. */
COR_INLINE double cor_inline_power_of_two(int k)
{
    return cor_inline_from_bits((uint64_t)(1023 + k) << 52);
}

/* Return the exponent e of a normal x, 2^e <= |x| < 2^(e+1), and |x| 2^-e. */
COR_INLINE int cor_inline_exponent(double x)
{
    return (int)((cor_inline_bits(x) >> 52) & 2047) - 1023;
}

COR_INLINE double cor_inline_significand(double x)
{
    return cor_inline_from_bits((cor_inline_bits(x) & UINT64_C(0xfffffffffffff)) | UINT64_C(0x3ff0000000000000));
}

/* Returns x > 0 times a power of two, which must give a normal number. The bits of a subnormal x count its units of
 * 2^-1074, even if the processor flushes such numbers to 0. */
COR_INLINE double cor_inline_raised(double x, double power)
{
    if (cor_inline_bits(x) >> 52 != 0)
        return x * power;
    return (double)cor_inline_bits(x) * COR_INLINE_2_M574 * (power * COR_INLINE_2_M500);
}

/* Returns x 2^k for 2^-60 < |x| < 2^60 and k <= 960, rounded once. Unlike ldexp, this function does not set errno. */
COR_INLINE double cor_inline_scaled(double x, int k)
{
    if (k >= -960)
        return x * cor_inline_power_of_two(k);
    /* the first product is a normal number, and exact */
    k += 900;
    return x * COR_INLINE_2_M900 * cor_inline_power_of_two(k < -1022 ? -1022 : k);
}

/* Returns the 26 leading bits of x. Products of two such numbers are exact. */
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

/* Returns hi + lo as a pair, exact if |hi| >= |lo|. */
COR_INLINE struct cor_inline_pair cor_inline_sum(double hi, double lo)
{
    struct cor_inline_pair sum;
    sum.hi = COR_INLINE_KEEP(hi + lo);
    sum.lo = lo - COR_INLINE_KEEP(sum.hi - hi);
    return sum;
}

/* Returns x + y exactly, for x and y in any order. */
COR_INLINE struct cor_inline_pair cor_pair_two_sum(double x, double y)
{
    const double hi = COR_INLINE_KEEP(x + y), part = COR_INLINE_KEEP(hi - x);
    return cor_pair(hi, COR_INLINE_KEEP(x - COR_INLINE_KEEP(hi - part)) + COR_INLINE_KEEP(y - part));
}

/* Returns x y with relative error 2^-104, if nothing underflows. */
COR_INLINE struct cor_inline_pair cor_inline_product(double x, double y)
{
    const double xh = cor_inline_head(x), xl = x - xh, yh = cor_inline_head(y), yl = y - yh;
    struct cor_inline_pair product;
    product.hi = COR_INLINE_KEEP(x * y);
    product.lo = COR_INLINE_KEEP(COR_INLINE_KEEP(xh * yh - product.hi) + xh * yl + xl * yh) + xl * yl;
    return product;
}

/* Returns x y with a relative error of a few 2^-104. */
COR_INLINE struct cor_inline_pair cor_inline_pair_times(struct cor_inline_pair x, struct cor_inline_pair y)
{
    const struct cor_inline_pair p = cor_inline_product(x.hi, y.hi);
    return cor_inline_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

/* Returns x/d with relative error 2^-100. inverse: 1/d within a few units of the last place. */
COR_KERNEL struct cor_inline_pair cor_pair_over_with(struct cor_inline_pair x, struct cor_inline_pair d, double inverse)
{
    const double q = x.hi * inverse;
    const struct cor_inline_pair p = cor_inline_product(q, d.hi);
    return cor_inline_sum(q, (COR_INLINE_KEEP(COR_INLINE_KEEP(x.hi - p.hi) - p.lo) + (x.lo - q * d.lo)) * inverse);
}

COR_KERNEL struct cor_inline_pair cor_pair_over(struct cor_inline_pair x, struct cor_inline_pair d)
{
    return cor_pair_over_with(x, d, 1 / d.hi);
}

/* Returns ln(x) of a normal, finite x >= 1. If log is within 1 ulp, the error is below 2^-53, or 2^-53 ln(x) for large
 * x. */
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

/* x^(1/5) without pow, branches or a table, so that compilers vectorise loops */
#ifndef COR_RUNTIME_FIFTH_ROOT_H
#define COR_RUNTIME_FIFTH_ROOT_H


/* Returns (1 + d)^(1/5) - 1 up to d^4 for |d| < 4e-4. The next term is below 2^-59. */
COR_INLINE double cor_inline_fifth_root_rest(double d)
{
    return d * ((0.2 - 0.08 * d) + (d * d) * (0.048 - 0.0336 * d));
}

/* Returns x^(1/5) = head + tail for 2^-1000 <= x <= 2^1000. The head has 26 bits, |tail/head| < 2^-12. Relative error
 * of the sum, before it is rounded: 0.5 2^-53, measured in tests/unit/test_fifth_root.c. */
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

/* Returns the fifth root of a pair. The relative error is below 2^-58, because r^5 and the difference are pairs too. */
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

/* Returns the rounded fifth root, with relative error 1.5 2^-53. */
COR_INLINE double cor_inline_fifth_root_normal(double x)
{
    const struct cor_inline_pair root = cor_inline_fifth_root_parts(x);
    return root.hi + root.lo;
}

/* Returns the fifth root of any double. It returns 0, +inf, NaN and negative numbers unchanged. */
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

/* Tables of short polynomials on a grid, for any function. These functions find the row of a number and evaluate it.
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
 * macro; Horner's rule has twenty. Both are macros because the array functions pass vectors. pN is t^N.
 *
 * Rounding error: the row is at most a few percent of c_0 + row (docs/accuracy.md) and has a relative rounding error of
 * about 3 2^-53. The row therefore contributes a tenth of a unit of the last place of the sum. The final addition
 * contributes half a unit. */
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

/* Returns c_0 + row. */
COR_INLINE double cor_inline_row_value(struct cor_inline_place place)
{
    return place.row[0] + cor_inline_row(place);
}

/* Returns m (c_0 + row) for m >= 2^-900 and rows whose c_0 has at most 26 bits. m is split into two parts. Their
 * products with c_0 are exact, so the final addition causes nearly all of the rounding error. */
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

/* Returns the row whose node is nearest to y. */
COR_INLINE int cor_inline_grid_row(struct cor_inline_grid grid, double y)
{
    return (int)((y - grid.first) * grid.per_unit + 0.5);
}

/* Returns node i. The branch avoids the addition of a first node of 0, which compilers may not omit: 0 + -0 is 0. */
COR_INLINE double cor_inline_grid_node(struct cor_inline_grid grid, int i)
{
    return grid.first == 0 ? i * grid.step : grid.first + i * grid.step;
}

/* Returns y - node i. The result is exact: y and its node are multiples of the last place of y or of the result. */
COR_INLINE double cor_inline_grid_t(struct cor_inline_grid grid, double y, int i)
{
    return (y - grid.first) - i * grid.step;
}

COR_INLINE struct cor_inline_place cor_inline_grid_place(struct cor_inline_grid grid, double y,
                                                         const double *(*rows)(int))
{
    const int i = cor_inline_grid_row(grid, y);
    return cor_inline_place_of(rows(i), cor_inline_grid_t(grid, y, i));
}

/* Returns the place of z = sqrt(x). From row `plain` onward, s is x - node^2, which is exact. t has the rounding error
 * of the root; c_1 t would add this error to the row. */
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

/* Returns the row of x: the number of cells between first and x. The bits of x, read as an integer, increase by the
 * same amount from cell to cell. */
COR_INLINE uint64_t cor_inline_octaves_row(struct cor_inline_octaves grid, double x)
{
    return (cor_inline_bits(x) - cor_inline_bits(grid.first)) >> (52 - grid.bits);
}

/* Returns x 2^-k minus the node of its cell, where 1 <= x 2^-k < 2. The result is exact. */
COR_INLINE double cor_inline_octaves_t(struct cor_inline_octaves grid, double x)
{
    const uint64_t one = UINT64_C(0x3ff0000000000000), half_cell = UINT64_C(1) << (51 - grid.bits);
    const uint64_t fraction = cor_inline_bits(x) & UINT64_C(0xfffffffffffff);
    const uint64_t node = (fraction & ~(2 * half_cell - 1)) | half_cell;
    return cor_inline_from_bits(fraction | one) - cor_inline_from_bits(node | one);
}

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
#include "sphere_rows.h"
#undef COR_ROWS
#undef COR_ROWS_HERE
#undef COR_ROWS_FUNCTION
/* The only evaluator of the sphere's tables, for scalar functions, array functions and the header for embedding.
 *
 * For beta from 0 to 8 (eps: to 7 at zero overlap, to 16 at zero force) a row of a table gives a quantity. A row is a
 * short polynomial around the nearest node of a uniform grid. For larger beta a quantity is a power of beta times a
 * function of ln(beta). Rows give this function up to beta = exp(10). Beyond exp(10) it is a series to second order in
 * mu = beta^(-5/3), whose coefficients are polynomials in ln(beta). The first coefficient of a row is a double-double
 * and dominates, so the final addition causes nearly all of the rounding error.
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

/* Returns beta^(2/3) for 1 <= beta < 8. Relative error below 2^-69. */
COR_INLINE struct cor_inline_pair cor_inline_two_thirds(double beta)
{
    /* r has 26 bits, so its square is exact; |d| < 2^-23 if the error of cbrt is below 2^-27 */
    const double r = cor_inline_head(cbrt(beta)), square = r * r;
    const struct cor_inline_pair cube = cor_inline_product(square, r);
    const double d = (COR_INLINE_KEEP(beta - cube.hi) - cube.lo) / beta; /* r^3 = beta (1 - d) */
    return cor_inline_sum(square, square * (d * (2.0 / 3 + d * (5.0 / 9))));
}

/* Returns the logarithmic factor of a tail. Up to u = end, rows in u = ln(beta) give this factor; its error is the
 * error of u times the slope. For larger u, a series to second order in mu = beta^(-5/3) gives it. */
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
    /* mu < 6e-8, so its error is negligible, even if cbrt has an error of 2^-46 */
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

/* Returns factor beta^(-2/3) as a pair times 2^exponent, without overflow or underflow. fifths: true for beta^(-5/3).
 * The relative error is the error of the factor plus 2^-65. */
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
    return cor_pair_over(factor, power);
}

/* Returns the same power, rounded to a double; 0 for an infinite beta. */
COR_INLINE double cor_inline_power_tail(double beta, struct cor_inline_pair factor, int fifths)
{
    int exponent;
    const struct cor_inline_pair value = cor_inline_power_parts(beta, factor, fifths, &exponent);
    return cor_inline_scaled(value.hi, exponent);
}

/* ---- eps ---- */

/* Below this beta, eps is 1 to the last bit. The branch is necessary: if products that underflow are rounded upward, a
 * row exceeds 1. */
#define COR_INLINE_EPS_LEAST COR_INLINE_2_M60

/* Returns h*^5 beta^-5 for beta >= 7. The next order is below 2^-75. The power and the quotient are double-doubles, so
 * only the final rounding counts: 0.5 ulp. */
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
    const double eps = cor_pair_over(h5, power).hi;
    return huge ? eps * COR_INLINE_2_M500 * COR_INLINE_2_M500 : eps;
}

/* Returns the same eps at beta = x^(1/5), x >= 2^14. Error 0.75 ulp, because h*^5 is rounded to one double. */
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

/* Return eps at beta = x^(1/5), where x is the product of an impact speed g and beta_per_root^5. From x = 2^-40 (beta =
 * 1/256), rows in x give eps without a root, up to x = 2^14 (beta = 7) at zero overlap and 2^20 (beta = 16) at zero
 * force. Only a fifth of the relative rounding error of x reaches beta. For larger x, eps at zero overlap is h*^5/x. */
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

/* Returns beta (c_0 + row). A tiny beta is scaled, because parts of the products would be subnormal. */
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

/* Returns the product of beta and factor, or infinity if it exceeds the largest double. */
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

/* Returns beta = m (c_0 + row). For eps >= 1/2, m = loss = 1 - eps, which is exact, and the rows contain beta/loss as a
 * function of loss or of its root. For eps < 1/2, m = 1, and the rows contain beta by octaves of eps. The function
 * computes both and selects one by bits, because the eps of many collisions scatter around 1/2. The error is the error
 * of the row plus one rounding; at zero force the rounded root adds up to 0.6 ulp. */
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

/* Returns a/eps as a pair; if eps is tiny and the quotient might overflow, a/(2^500 eps). */
COR_INLINE struct cor_inline_pair cor_inline_over_eps(const double *a, double eps, int tiny)
{
    struct cor_inline_pair numerator, denominator;
    numerator.hi = a[0];
    numerator.lo = a[1];
    denominator.hi = tiny ? cor_inline_raised(eps, COR_INLINE_2_500) : eps;
    denominator.lo = 0;
    return cor_pair_over(numerator, denominator);
}

/* Returns beta = (h*^5/eps)^(1/5) for eps below the table. Error 0.6 ulp. */
COR_INLINE double cor_inline_beta_overlap_far(double eps)
{
    const int tiny = eps < COR_INLINE_2_M500;
    const struct cor_inline_pair root =
        cor_inline_fifth_root_of_pair(cor_inline_over_eps(cor_rows_h_star_5(0), eps, tiny));
    return (root.hi + root.lo) * (tiny ? COR_INLINE_2_100 : 1);
}

/* Returns beta = R (1 + e r_1(v) + e^2 r_2(v)), R = (a/eps)^(3/5), e = eps/a, v = ln(R), for eps below the table
 * (e < 1e-7). */
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

#endif
