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
 * within 2: proved for every double, if log is within 1 unit and cbrt within 2 (docs/derivation.md, 8 and 18);
 * eps at a speed within (2 + 2 kappa) 2^-53, kappa = |d ln eps/d ln beta|: sampled. beta = 0 -> 1, +inf -> 0
 * (eps); negative or NaN -> NaN. Any flags are safe: no argument leads beyond a table, and -ffast-math and
 * -march=native change a result by 4 units at most (sampled).
 * Zero overlap ends the contact when x = 0 again, zero force when x'' = 0.
 *
 * Written by:  corgen tables
 * Checked by:  corgen tables --check */
#ifndef COR_SPHERE_EMBEDDED_H
#define COR_SPHERE_EMBEDDED_H

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
#ifndef COR_RUNTIME_EXACT_H
#define COR_RUNTIME_EXACT_H


/* Powers of two, in decimal because hexadecimal constants need C++17. */
#define COR_INLINE_2_M900 1.18305218616677471e-271
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

/* The float nearest to x, without FE_OVERFLOW */
COR_INLINE float cor_inline_narrow(double x)
{
    const double beyond = 3.40282356779733662e+38; /* halfway between the largest float and 2^128 */
    return (float)(cor_inline_below(x, beyond) || cor_inline_bits(x) > COR_INLINE_INFINITY_BITS
                       ? x
                       : cor_inline_infinity());
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

/* hi + lo as a pair, exact where |hi| >= |lo| */
COR_INLINE struct cor_inline_pair cor_inline_sum(double hi, double lo)
{
    struct cor_inline_pair sum;
    sum.hi = COR_INLINE_KEEP(hi + lo);
    sum.lo = lo - COR_INLINE_KEEP(sum.hi - hi);
    return sum;
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
        return cor_inline_fifth_root_normal(x * COR_INLINE_2_200) * COR_INLINE_2_M40;
    if (x > COR_INLINE_2_900)
        return cor_inline_fifth_root_normal(x * COR_INLINE_2_M200) * COR_INLINE_2_40;
    return cor_inline_fifth_root_normal(x);
}

#endif

/* Tables of short polynomials on a grid, for any function: these functions find the row of a number and evaluate it.
 *
 * Macros COR_ROWS_NAME_FIRST, _STEP, ... give the geometry of a generated table cor_rows_NAME(i); docs/header-format.md
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

/* A row: value = c_0 + (c_0' + s (c_1 + c_2 t + ... + c_n t^(n-1))), t = y - node, in columns c_0,
 * c_0', c_1, ..., c_n. s = t; only in the rows of eps and of the loss at zero force from
 * node 1/4 on s = beta - node^2. c_0' is the remainder of c_0 at the node. */

/* eps at zero overlap, beta < 7: 57 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 7.0625.
 * Relative error of the approximation: 2^-56.5 at most, proved for the whole cell of each row. */
#define COR_ROWS_EPS_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_EPS_ZERO_OVERLAP_STEP 0.125
#define COR_ROWS_EPS_ZERO_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_EPS_ZERO_OVERLAP_ROWS 57
#define COR_ROWS_EPS_ZERO_OVERLAP_END 7.0
COR_INLINE const double *cor_rows_eps_zero_overlap(int i)
{
    static const double row[57][12] = {
        /* [0] 0 <= y <= 0.0625, degree 10, 57.9 bits */
        {
         1, 0, -1.1534488580952889, 0.79826656094479531,
         -0.52288256808836064, 0.34874267524923586, -0.23309813085595441, 0.15668208255922378,
         -0.10581622795185981, 0.071707035488898535, -0.048048871694787568, 0.027033512758574674
        },
        /* [1] 0.0625 <= y <= 0.1875, degree 10, 58.6 bits */
        {
         0.86734913258011026, -1.0123923713822538e-17, -0.97592621618728514, 0.63084040470232416,
         -0.379607932127903, 0.23360715632682785, -0.1437403509971083, 0.088908735903795624,
         -0.055236320677244689, 0.034443179737066336, -0.021638566909531871, 0.013583908318224395
        },
        /* [2] 0.1875 <= y <= 0.3125, degree 10, 58.1 bits */
        {
         0.75452677625261988, -4.8741574911719782e-17, -0.83434571976165361, 0.50787420844941344,
         -0.28221012412055985, 0.16134687125556058, -0.09198829516623476, 0.052699428348418689,
         -0.030322070461857916, 0.01749993037986464, -0.010169065960553678, 0.0059062012332149871
        },
        /* [3] 0.3125 <= y <= 0.4375, degree 10, 57.2 bits */
        {
         0.65765467575306902, 5.4381997156597249e-17, -0.719448633594998, 0.41555030292633544,
         -0.21408342330727326, 0.11439713837300181, -0.060771010452977614, 0.032420583052912164,
         -0.017378189040037389, 0.0093344272293922944, -0.0050468218863353497, 0.0027274563634856388
        },
        /* [4] 0.4375 <= y <= 0.5625, degree 10, 57.7 bits */
        {
         0.57382462866494899, -4.4569976336128697e-18, -0.6247711686155708, 0.3449153250329331,
         -0.16524790894731067, 0.082968007476952571, -0.04127306695466347, 0.020593980066099603,
         -0.010338959580088583, 0.0051923277877984481, -0.0026255539466916457, 0.0013268121790285887
        },
        /* [5] 0.5625 <= y <= 0.6875, degree 10, 56.8 bits */
        {
         0.50081385494755792, -4.8920211568782384e-17, -0.54568701440838896, 0.28998879970139169,
         -0.12948861130188696, 0.061371917959745344, -0.028723600068645234, 0.013448814120307158,
         -0.0063564192673690829, 0.0029956979626906324, -0.0014232665306033855, 0.00067546811812140299
        },
        /* [6] 0.6875 <= y <= 0.8125, degree 10, 57.7 bits */
        {
         0.43689530094233586, -2.8874336151598736e-18, -0.4788128844876699, 0.24666865462937257,
         -0.10281498553130436, 0.046183441159837878, -0.020434052924352054, 0.0089950871231457771,
         -0.004024140981074906, 0.0017845963940128948, -0.00079991403049342938, 0.00035799379549203452
        },
        /* [7] 0.8125 <= y <= 0.9375, degree 10, 59.5 bits */
        {
         0.38070776174313742, -1.2616087175866953e-17, -0.42162776305744254, 0.21207416991753908,
         -0.08259628813204023, 0.035272985192603704, -0.014835038145932573, 0.0061400330725764401,
         -0.0026162212935127958, 0.0010936734090282048, -0.00046402696362041684, 0.00019677286218020213
        },
        /* [8] 0.9375 <= y <= 1.0625, degree 10, 57.6 bits */
        {
         0.33116481046664092, 1.103280363174899e-17, -0.37222240221455472, 0.18413857556684582,
         -0.067058549513593996, 0.027278367993862861, -0.010981713850486446, 0.0042623375958307725,
         -0.0017429880487403282, 0.00068768056821755447, -0.00027649509116648883, 0.00011196663722834284
        },
        /* [9] 1.0625 <= y <= 1.1875, degree 10, 59.5 bits */
        {
         0.28738954179347226, 1.6169032785793362e-17, -0.32913068459616923, 0.16134904101440173,
         -0.054982561687887586, 0.021305406450748642, -0.0082893683077174835, 0.0029979546672556532,
         -0.0011875744460324753, 0.00044333652667490552, -0.00016805314894990079, 6.6060939142272902e-05
        },
        /* [10] 1.1875 <= y <= 1.3125, degree 10, 57.7 bits */
        {
         0.24866685660804916, 3.746733254822805e-18, -0.29121388345552329, 0.14257632290928254,
         -0.045517404962083952, 0.016752995532424503, -0.006386779989638546, 0.0021283238655621689,
         -0.00082492463463308316, 0.00029411114347747589, -0.00010285380477533241, 4.068658041255873e-05
        },
        /* [11] 1.3125 <= y <= 1.4375, degree 10, 56.9 bits */
        {
         0.21440787796010005, -3.9752125791593009e-18, -0.25757997592089471, 0.12696044282363841,
         -0.038062280922666128, 0.013208354473080133, -0.0050319166897153699, 0.00152024419622861,
         -0.00058005023079008955, 0.00020330476881668118, -6.1740968386308955e-05, 2.6407030793449675e-05
        },
        /* [12] 1.4375 <= y <= 1.5625, degree 10, 61.5 bits */
        {
         0.18412287416504999, 2.8315798298489183e-19, -0.22752672321997827, 0.11383230737519912,
         -0.032189583493519226, 0.010383319205539332, -0.0040615329231761151, 0.0010927807494699267,
         -0.00040581575751800418, 0.00015026595293809235, -3.442397260524138e-05, 1.7937024090864758e-05
        },
        /* [13] 1.5625 <= y <= 1.6875, degree 10, 58.4 bits */
        {
         0.15740020831075774, 2.1406159887486581e-19, -0.2005011815333331, 0.10265908023962962,
         -0.027593072561549976, 0.0080756897441087525, -0.0033595983364785404, 0.00079864586040381922,
         -0.00027106278725325301, 0.00012269941091462699, -1.5952769320690732e-05, 1.1741987458018699e-05
        },
        /* [14] 1.6875 <= y <= 1.8125, degree 10, 57.8 bits */
        {
         0.13388958802966991, -8.7939688930456319e-19, -0.17607070703719138, 0.093005920662439068,
         -0.024051078816109201, 0.0061466381502384418, -0.0028365432922577106, 0.0006130745402549312,
         -0.00015492952193680676, 0.0001115620551213197, -5.3704671857751651e-06, 4.854297016076208e-06
        },
        /* [15] 1.8125 <= y <= 1.9375, degree 10, 57.0 bits */
        {
         0.11328840874813839, 2.2205996696535974e-19, -0.15390195461454215, 0.084509769888606853,
         -0.021398156095252117, 0.0045087861113357964, -0.0024155086170611195, 0.00052560833126759116,
         -4.5730941755766704e-05, 0.00010690001472181639, -5.1309973029618231e-06, -5.0998514312978648e-06
        },
        /* [16] 1.9375 <= y <= 2.0625, degree 10, 56.6 bits */
        {
         0.095330365354151542, 1.7144410207386845e-18, -0.13374517901155894, 0.076862888989857533,
         -0.019500864760621048, 0.0031209585377356304, -0.0020248259300225634, 0.00053114611828820987,
         5.6404446279122724e-05, 9.46785525991861e-05, -1.9541754250681865e-05, -1.8261038434486459e-05
        },
        /* [17] 2.0625 <= y <= 2.1875, degree 10, 57.3 bits */
        {
         0.0797758152102096, -2.4319808807446605e-18, -0.11542154991132317, 0.069805098174913469,
         -0.018235380246718853, 0.0019853125683566828, -0.0015983588839816488, 0.00061766015697037411,
         0.00013510320947014514, 5.697915539248625e-05, -4.9943988901115447e-05, -2.9133313040090984e-05
        },
        /* [18] 2.1875 <= y <= 2.3125, degree 10, 60.1 bits */
        {
         0.066403648494247527, -1.944866887693378e-18, -0.098811382790929603, 0.063124089360986763,
         -0.017467106056824441, 0.0011410959788206519, -0.0010863150789810554, 0.00075108854587342254,
         0.00015702987617152191, -2.000019886466098e-05, -8.5949887478137447e-05, -2.4591197305443277e-05
        },
        /* [19] 2.3125 <= y <= 2.4375, degree 10, 57.3 bits */
        {
         0.055004672474508243, 1.5220635110358494e-18, -0.083841400705550642, 0.056662532776622011,
         -0.017035676616002624, 0.00064822980141826872, -0.00047647032371660799, 0.00086458446684819059,
         8.421564504257581e-05, -0.00012824603664055714, -9.9030720880497364e-05, 8.8457816329960789e-06
        },
        /* [20] 2.4375 <= y <= 2.5625, degree 10, 56.5 bits */
        {
         0.045376723703480663, -1.1281739922767837e-18, -0.070469672168785621, 0.050328824337866881,
         -0.01675176789510489, 0.00055626889180889437, 0.00018265120143023765, 0.00086684454070223469,
         -9.4799815338880163e-05, -0.00022140814579138312, -5.4176608208139435e-05, 6.394560666826647e-05
        },
        /* [21] 2.5625 <= y <= 2.6875, degree 10, 58.4 bits */
        {
         0.037321828895905303, -6.796284043356389e-19, -0.058667981066928006, 0.044105718319738238,
         -0.016412434965340422, 0.00086317570495278982, 0.00077634083578846278, 0.00068186814338565098,
         -0.0003290686318291584, -0.00022696812890978129, 5.1920050534930086e-05, 9.7364797684653653e-05
        },
        /* [22] 2.6875 <= y <= 2.8125, degree 10, 57.5 bits */
        {
         0.030645664433699139, 1.2315409568674223e-19, -0.048403077898133737, 0.038049403931557479,
         -0.015836085952595336, 0.0014821048695781145, 0.0011572792189519677, 0.00030805611948705379,
         -0.00050468704307231956, -0.00010382765132818603, 0.00015867755874302949, 6.0142333571241709e-05
        },
        /* [23] 2.8125 <= y <= 2.9375, degree 10, 58.3 bits */
        {
         0.025159269866388514, 7.0361828525140039e-19, -0.039620009182271453, 0.032273218617056107,
         -0.014906611279339493, 0.002241981515293515, 0.0012166187356301198, -0.00015062589957153975,
         -0.00050987270701681681, 9.6993080082262407e-05, 0.00017688648995114288, -3.4843592755608159e-05
        },
        /* [24] 2.9375 <= y <= 3.0625, degree 10, 58.0 bits */
        {
         0.020682506960711011, 4.4923176367490176e-20, -0.032231492054454088, 0.026916322153687857,
         -0.01360554452425429, 0.0029345122182484027, 0.00095202964546079252, -0.00052793308078258208,
         -0.00032647050042456738, 0.00025172348448747702, 8.2366776885143406e-05, -0.00010492496120711458
        },
        /* [25] 3.0625 <= y <= 3.1875, degree 10, 59.8 bits */
        {
         0.017048307991633559, 1.0155318269866086e-18, -0.02611618778195153, 0.022105833248454825,
         -0.01201249535494987, 0.0033880120201198907, 0.00047819735473440036, -0.00069546887535639488,
         -5.3663456931226225e-05, 0.00026892960689169114, -4.8362009404232562e-05, -9.0132815068457372e-05
        },
        /* [26] 3.1875 <= y <= 3.3125, degree 10, 57.0 bits */
        {
         0.014106565340199518, 7.3335103853774506e-19, -0.021125890392337553, 0.017925559799043485,
         -0.010270957068131135, 0.0035245595557434999, -3.3714491982059045e-05, -0.00063676374418841395,
         0.00017035489468442553, 0.00016568184673606301, -0.00011945454302606876, -2.0593149338031793e-05
        },
        /* [27] 3.3125 <= y <= 3.4375, degree 10, 56.5 bits */
        {
         0.011726712570421665, -6.3126689668972891e-19, -0.017098568568249442, 0.014401512751686635,
         -0.0085371190480335608, 0.0033682536569803723, -0.00044102741477767079, -0.00043525075672283206,
         0.00026767808709799156, 3.1606297614249124e-05, -0.00010648468574130982, 3.4770120211962232e-05
        },
        /* [28] 3.4375 <= y <= 3.5625, degree 10, 59.1 bits */
        {
         0.0097985484123724112, 6.245282876384493e-19, -0.013872664200410226, 0.011505832329816881,
         -0.006936595420786988, 0.0030090589365000648, -0.00067915610488783766, -0.00020265679223136694,
         0.00024886583187544193, -5.8733144745521926e-05, -5.1653302579686819e-05, 4.6094159702804193e-05
        },
        /* [29] 3.5625 <= y <= 3.6875, degree 10, 58.6 bits */
        {
         0.0082314092286243368, -7.6824698634478735e-19, -0.0112987105138377, 0.0091728538555516086,
         -0.0055440881720454759, 0.002552934688777687, -0.00075715905557720612, -1.6805314063509695e-05,
         0.00017124601603431475, -8.7297833113034561e-05, -2.9386009772599398e-06, 2.9436431043298579e-05
        },
        /* [30] 3.6875 <= y <= 3.8125, degree 10, 57.1 bits */
        {
         0.0069521681394369836, 3.9010013863907272e-19, -0.0092463544840569109, 0.0073184090586378018,
         -0.0043852686620267809, 0.0020859962534914792, -0.00072300836890801603, 9.5672308317002627e-05,
         8.8018820137628352e-05, -7.4743329125885494e-05, 2.0748633910078067e-05, 9.3382991604334635e-06
        },
        /* [31] 3.8125 <= y <= 3.9375, degree 10, 60.8 bits */
        {
         0.0059026466072193591, 9.2002309652628289e-20, -0.0076068778256600418, 0.0058557733677108538,
         -0.0034508719110070106, 0.001661364668759422, -0.00062985434731939515, 0.00014373389230467278,
         2.6328368077009948e-05, -4.807032402689051e-05, 2.404248523495903e-05, -2.4848813793148248e-06
        },
        /* [32] 3.9375 <= y <= 4.0625, degree 10, 57.5 bits */
        {
         0.0050369302968274405, -3.3950463397863977e-19, -0.00629245670743996, 0.0047056860087025584,
         -0.0027128393608862804, 0.001302461517864477, -0.00051795863414850552, 0.00014950391205378191,
         -9.1087538735406753e-06, -2.3967628326396673e-05, 1.8012901858211337e-05, -6.1161400471168032e-06
        },
        /* [33] 4.0625 <= y <= 4.1875, degree 10, 57.6 bits */
        {
         0.0043189037795012984, -1.1717769702535855e-20, -0.0052336292938909828, 0.0038009000309605287,
         -0.0021368130159090393, 0.0010128094116299182, -0.00041093421472675597, 0.00013368757865801464,
         -2.4383986528103044e-05, -7.9960127465192952e-06, 1.0543887695084618e-05, -5.4309915908616065e-06
        },
        /* [34] 4.1875 <= y <= 4.3125, degree 10, 58.2 bits */
        {
         0.0037201509429801694, 2.1561249336997006e-19, -0.0043761326488626628, 0.0030869932377429097,
         -0.0016896135576378595, 0.00078554137857455339, -0.00031925960518442776, 0.00011032106130923616,
         -2.7623209519511183e-05, 4.618699347429152e-07, 4.9194168507221758e-06, -3.5320695800539414e-06
        },
        /* [35] 4.3125 <= y <= 4.4375, degree 10, 58.1 bits */
        {
         0.0032182510519961436, 5.9069510942147747e-20, -0.0036778181872027891, 0.0025211835483003558,
         -0.0013426516303264269, 0.00060999646377138026, -0.00024540600805602578, 8.6995593259411503e-05,
         -2.5122343218924098e-05, 3.9203266457396448e-06, 1.599873360933179e-06, -1.86950835409646e-06
        },
        /* [36] 4.4375 <= y <= 4.5625, degree 10, 58.0 bits */
        {
         0.0027954366609198858, 7.296915996939496e-20, -0.0031059777915976305, 0.0020703861979900332,
         -0.0010728073782273759, 0.00047536172007433034, -0.00018793758403714146, 6.6906876625090063e-05,
         -2.0672058934113603e-05, 4.6815445739511763e-06, -9.5873666736096971e-09, -8.0256599552522369e-07
        },
        /* [37] 4.5625 <= y <= 4.6875, degree 10, 61.0 bits */
        {
         0.0024375544597612406, -2.0795996313972716e-19, -0.0026351730237042259, 0.0017092102065554146,
         -0.00086204690154785373, 0.00037224829173487187, -0.00014403410000826404, 5.0830723325068989e-05,
         -1.6146198433604571e-05, 4.2582206374310216e-06, -6.1803986037455957e-07, -2.3815257821576693e-07
        },
        /* [38] 4.6875 <= y <= 4.8125, degree 10, 59.5 bits */
        {
         0.0021332672277334665, -5.6459202830860802e-20, -0.0022455376615428033, 0.0014182039735227932,
         -0.00069657340936456213, 0.00029310692133278644, -0.0001107637687144239, 3.8455175333635567e-05,
         -1.2273861520045896e-05, 3.4654828318031357e-06, -7.3623850945434876e-07, 1.1376089966865619e-08
        },
        /* [39] 4.8125 <= y <= 4.9375, degree 10, 59.3 bits */
        {
         0.001873442282295054, 1.0548403597948956e-19, -0.0019214771321500849, 0.00118243768271832,
         -0.00056592382360421182, 0.00023210987826536978, -8.5593135213163059e-05, 2.911261880955698e-05,
         -9.2133071971507703e-06, 2.670916246390926e-06, -6.5771696610560012e-07, 9.6305270033700848e-08
        },
        /* [40] 4.9375 <= y <= 5.0625, degree 10, 58.0 bits */
        {
         0.0016506820717733176, -6.0965246961392827e-21, -0.0016506814215845485, 0.00099040579236041922,
         -0.00046217996770213957, 0.00018485081913590168, -6.6509117130925073e-05, 2.2116782000477529e-05,
         -6.8883807753747115e-06, 2.003939988228993e-06, -5.255736329700709e-07, 1.0795087758182681e-07
        },
        /* [41] 5.0625 <= y <= 5.1875, degree 10, 58.4 bits */
        {
         0.0014589624704286204, -8.722530944804839e-20, -0.0014233778272084898, 0.00083319584740585871,
         -0.00037933826914328189, 0.0001480276680375972, -5.1977947281300148e-05, 1.6885388968891566e-05,
         -5.1553525802703214e-06, 1.4859945435994487e-06, -3.9857578019059623e-07, 9.3148411594905851e-08
        },
        /* [42] 5.1875 <= y <= 5.3125, degree 10, 61.3 bits */
        {
         0.001293352647452752, 1.0007802710667671e-19, -0.0012317643706032922, 0.00070386508043302539,
         -0.00031282803891370214, 0.00011917048298399415, -4.085454110246796e-05, 1.2963778152305237e-05,
         -3.8728330832676796e-06, 1.0984805120102821e-06, -2.9492500509412388e-07, 7.2638188640664764e-08
        },
        /* [43] 5.3125 <= y <= 5.4375, degree 10, 58.7 bits */
        {
         0.0011497968959896731, -8.563948344150493e-20, -0.0010695784923264347, 0.00059697396361720902,
         -0.00025915122810369826, 9.6427731089503989e-05, -3.2290869509526918e-05, 1.0010792860949946e-05,
         -2.9242938775164146e-06, 8.1336155106354313e-07, -2.1608615851790168e-07, 5.408955532367407e-08
        },
        /* [44] 5.4375 <= y <= 5.5625, degree 10, 58.1 bits */
        {
         0.001024943741216052, 7.1727212069973026e-20, -0.00093176703322105623, 0.00050823654166053339,
         -0.00021561542839304321, 7.8405425540534511e-05, -2.5659595824607066e-05, 7.7750571389168459e-06,
         -2.2206699427514612e-06, 6.0475014911635652e-07, -1.5803335798671757e-07, 3.9459045304257954e-08
        },
        /* [45] 5.5625 <= y <= 5.6875, degree 10, 58.9 bits */
        {
         0.00091601132165965637, -3.4904951712592377e-20, -0.0008142322847913729, 0.0004342572126123733,
         -0.00018013630468717722, 6.4048411498373727e-05, -2.0495386668535392e-05, 6.0725350337439459e-06,
         -1.6962170266370944e-06, 4.5204526130040758e-07, -1.1586076450651964e-07, 2.8578138404727278e-08
        },
        /* [46] 5.6875 <= y <= 5.8125, degree 10, 59.3 bits */
        {
         0.00082068076001953099, 1.5302682378915697e-20, -0.00071363544320336735, 0.00037233153401581588,
         -0.00015109105174477568, 5.2553394870744585e-05, -1.6451467927585275e-05, 4.768491730398471e-06,
         -1.3031199356734825e-06, 3.3985934397450386e-07, -8.5333061827111497e-08, 2.0692922821986455e-08
        },
        /* [47] 5.8125 <= y <= 5.9375, degree 10, 57.6 bits */
        {
         0.00073701125607599687, -3.7414296794195542e-20, -0.00062724362211877629, 0.00032029461514694119,
         -0.00012720920740082371, 4.3305258229294731e-05, -1.3267985908965194e-05, 3.7639537123171339e-06,
         -1.0067515530747764e-06, 2.5701792490848126e-07, -6.3197946814326924e-08, 1.5033589537813623e-08
        },
        /* [48] 5.9375 <= y <= 6.0625, degree 10, 58.7 bits */
        {
         0.00066337213274877916, -1.445648609555137e-20, -0.00055281011060591379, 0.00027640505520207145,
         -0.00010749085443026163, 3.5830283803564106e-05, -1.0749082986006862e-05, 2.9858525990005846e-06,
         -7.8200332394043249e-07, 1.9549369468411137e-07, -4.7079666288917335e-08, 1.0977170517587077e-08
        },
        /* [49] 6.0625 <= y <= 6.1875, degree 10, 57.2 bits */
        {
         0.00059838818545596226, 2.9779511578012174e-21, -0.00048848015138829536, 0.0002392555843288475,
         -9.1144984414141112e-05, 2.976162730871945e-05, -8.7462735905370161e-06, 2.3799373917596357e-06,
         -6.1059460771841348e-07, 1.4953140115238598e-07, -3.5278901235053204e-08, 8.0612842930630961e-09
        },
        /* [50] 6.1875 <= y <= 6.3125, degree 10, 58.9 bits */
        {
         0.00054089552539332813, -5.223402203213639e-20, -0.00043271642031365197, 0.0002077038817447047,
         -7.754278249573044e-05, 2.4813690335703293e-05, -7.1463426764981306e-06, 1.9056911235490791e-06,
         -4.7914475611910833e-07, 1.1499421317454557e-07, -2.6588506026065949e-08, 5.9550497322478987e-09
        },
        /* [51] 6.3125 <= y <= 6.4375, degree 10, 59.8 bits */
        {
         0.00048990574224793901, 4.7227033458085661e-20, -0.00038423979784129062, 0.00018081872839454608,
         -6.618201823065338e-05, 2.0762986096457757e-05, -5.8624901576444328e-06, 1.5326771012522318e-06,
         -3.7780262598923501e-07, 8.8894598478307118e-08, -2.0150772994334402e-08, 4.4249964893187123e-09
        },
        /* [52] 6.4375 <= y <= 6.5625, degree 10, 58.4 bits */
        {
         0.00044457669424568809, 2.3029414882750454e-20, -0.00034198207249663197, 0.00015783787961352378,
         -5.6659751654927401e-05, 1.7433769736438509e-05, -4.8278131496281773e-06, 1.2379007920097184e-06,
         -2.9927267069378383e-07, 6.9062889721867824e-08, -1.5354040886477941e-08, 3.3069085216273423e-09
        },
        /* [53] 6.5625 <= y <= 6.6875, degree 10, 62.0 bits */
        {
         0.00040418860201691151, 1.7479829079524255e-20, -0.00030504800152218628, 0.00013813494408545076,
         -4.8651301061271215e-05, 1.4687185225236758e-05, -3.9904805121492139e-06, 1.0038944647776358e-06,
         -2.3812049682405166e-07, 5.3914066606111753e-08, -1.1759833231670693e-08, 2.4850347192488815e-09
        },
        /* [54] 6.6875 <= y <= 6.8125, degree 10, 57.8 bits */
        {
         0.00036812440593350469, -1.4026774557469803e-20, -0.00027268474513592706, 0.00012119322006039748,
         -4.1893952613411412e-05, 1.2413022996386775e-05, -3.3101394652906083e-06, 8.1731838564153363e-07,
         -1.9027516564703925e-07, 4.2283368405620097e-08, -9.0519940475686493e-09, 1.8774110837712089e-09
        },
        /* [55] 6.8125 <= y <= 6.9375, degree 10, 59.4 bits */
        {
         0.0003358535652640587, -1.0682716584943705e-20, -0.00024425713837386039, 0.00010658493310859057,
         -3.6174280327751405e-05, 1.0523427004397824e-05, -2.7552245247060773e-06, 6.6793321791938999e-07,
         -1.5267044004722332e-07, 3.3309913943795411e-08, -7.0012074410791665e-09, 1.4256729312616301e-09
        },
        /* [56] 6.9375 <= y <= 7.0625, degree 10, 59.0 bits */
        {
         0.00030691864724624769, 7.6243599129501203e-21, -0.00021922760517589112, 9.395468793252414e-05,
         -3.1318229310838737e-05, 8.9480655173742557e-06, -2.3009311330285573e-06, 5.4784074591704156e-07,
         -1.2298465009996049e-07, 2.6353853653225465e-08, -5.4401664679098346e-09, 1.0880134124130911e-09
        }
    };
    return row[i];
}

/* eps at zero force, beta < 16: 65 rows of degree 10 in y = sqrt(beta), nodes 0 + i 0.0625, 0 <= y <= 4.03125.
 * Relative error of the approximation: 2^-57.5 at most, proved for the whole cell of each row. */
#define COR_ROWS_EPS_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_EPS_ZERO_FORCE_STEP 0.0625
#define COR_ROWS_EPS_ZERO_FORCE_PER_UNIT 16.0
#define COR_ROWS_EPS_ZERO_FORCE_ROWS 65
#define COR_ROWS_EPS_ZERO_FORCE_PLAIN_ROWS 4
#define COR_ROWS_EPS_ZERO_FORCE_END 16.0
COR_INLINE const double *cor_rows_eps_zero_force(int i)
{
    static const double row[65][12] = {
        /* [0] 0 <= y <= 0.03125, degree 10, 64.1 bits */
        {
         1, 0, 6.2748068643082865e-22, -1.1534488580952889,
         4.2407939853265846e-15, 0.79826656094305837, 0.26666666702797542, -0.52288261125287561,
         -0.46137640407379549, 0.34860139157937892, 0.45619277888643511, -0.20421985920652796
        },
        /* [1] 0.03125 <= y <= 0.09375, degree 10, 62.5 bits */
        {
         0.99550674249490934, 6.4139629960500451e-18, -0.14338437816577693, -1.1342167214885723,
         0.20720457614951249, 0.84744435798267848, 0.038330465583097981, -0.67794738606742611,
         -0.22953959627211729, 0.56267739067152478, 0.28205564792501753, -0.38853024367009448
        },
        /* [2] 0.09375 <= y <= 0.15625, degree 10, 60.2 bits */
        {
         0.98217819824627539, 7.0594580936191223e-18, -0.28190674067730465, -1.0755691002732324,
         0.41716135305130919, 0.81836751488449955, -0.22659389204895486, -0.71239629458302278,
         0.078823426958796489, 0.64303758550005718, -0.011456746059248131, -0.52295806907079412
        },
        /* [3] 0.15625 <= y <= 0.21875, degree 10, 60.3 bits */
        {
         0.96047166037055898, 4.725650089002633e-17, -0.4106863937340271, -0.97888447549947954,
         0.60949955659789257, 0.70716738651090072, -0.47863311245076257, -0.6094936945929772,
         0.38340850843214813, 0.54527702782818954, -0.32866948212137548, -0.45599480347391091
        },
        /* [4] 0.21875 <= y <= 0.28125, degree 10, 61.1 bits */
        {
         0.93113909616174428, -3.2653221628138076e-18, -1.0505072319671105, 0.40235731788993218,
         0.72498695491057941, -0.39858249945631863, -0.54087813589254441, 0.30136142392805071,
         0.59308980360906616, -0.60087086612524809, 0.12356312719432147, -0.64379507442356343
        },
        /* [5] 0.28125 <= y <= 0.34375, degree 10, 61.1 bits */
        {
         0.89518714905670682, -5.4737828384530202e-17, -0.9951939770153152, 0.4798170354228915,
         0.62200149472830035, -0.51661359205817814, -0.39481596847282907, 0.45868026410259816,
         0.32952360775767214, -0.57158961066992842, 0.014994567180979189, 0.1820649127066177
        },
        /* [6] 0.34375 <= y <= 0.40625, degree 10, 61.4 bits */
        {
         0.85381222107737431, 1.2464417814117637e-17, -0.93133029706344195, 0.53868503173049553,
         0.49955447262958919, -0.58632393594438692, -0.21933353711938303, 0.51732545744401826,
         0.080222765255729342, -0.51405822660257461, 0.15333976253081461, 0.28769179691457408
        },
        /* [7] 0.40625 <= y <= 0.46875, degree 10, 60.2 bits */
        {
         0.80831947802718351, -1.1547949972708068e-17, -0.86137901142762308, 0.57706760579175576,
         0.36916676172259494, -0.60518842319636346, -0.045557354486666292, 0.48749855191174335,
         -0.12234925834338307, -0.38394220794831974, 0.27960704623031213, 0.17143966585499085
        },
        /* [8] 0.46875 <= y <= 0.53125, degree 10, 58.9 bits */
        {
         0.76003716054438142, -3.7143745433967621e-17, -0.78791783256381742, 0.59500004262011186,
         0.24183646134416725, -0.57871364161300831, 0.10131576246673257, 0.39450036817948197,
         -0.25058662384023511, -0.21434876815671366, 0.3177308855558304, 0.0066075088486488107
        },
        /* [9] 0.53125 <= y <= 0.59375, degree 10, 62.8 bits */
        {
         0.71023745104195235, 2.6937382968466934e-17, -0.71341191038268981, 0.59418265825624295,
         0.12645320636659788, -0.51796988573967795, 0.20642041708639128, 0.27072674261426072,
         -0.29904179964377886, -0.053917282578341739, 0.27062138350346521, -0.11491493964616935
        },
        /* [10] 0.59375 <= y <= 0.65625, degree 10, 60.1 bits */
        {
         0.66007265621760824, 1.9281274151071966e-17, -0.64003379970871932, 0.57750731192297822,
         0.028919646624988013, -0.43636139541368479, 0.26594970226313092, 0.14594843350302839,
         -0.28272012575723016, 0.062781468970094442, 0.17719296486683769, -0.16179681705220955
        },
        /* [11] 0.65625 <= y <= 0.71875, degree 10, 61.6 bits */
        {
         0.61053160722392685, 3.8607374123486182e-17, -0.56954876123935905, 0.54850763027113503,
         -0.047981264603459771, -0.34669947858978489, 0.28483298428757925, 0.040817550831767059,
         -0.22693232147360398, 0.12460152298147557, 0.079680293988371051, -0.14680837424075813
        },
        /* [12] 0.71875 <= y <= 0.78125, degree 10, 57.7 bits */
        {
         0.5624171586006832, 1.3480314507551217e-17, -0.50326722303599347, 0.51085083108574736,
         -0.10414458215962148, -0.25925021483992805, 0.27297686791005565, -0.034920458405314631,
         -0.15673095221700015, 0.13925117489496328, 0.0051320857387833702, -0.10077025267847954
        },
        /* [13] 0.78125 <= y <= 0.84375, degree 10, 59.7 bits */
        {
         0.51634244852193756, 1.2567146039006337e-17, -0.4420539647496225, 0.46794684643197509,
         -0.14139305106949251, -0.18091990081132117, 0.24164248623713558, -0.08057056143605576,
         -0.090414997673951988, 0.12327685232150665, -0.037945375441808683, -0.051249187272042952
        },
        /* [14] 0.84375 <= y <= 0.90625, degree 10, 60.2 bits */
        {
         0.47274164955774012, -1.0878536700874637e-17, -0.38637715017064428, 0.42270267795636113,
         -0.16266847388828215, -0.1153606772768483, 0.20089114688126919, -0.1010213913249793,
         -0.03779433334569221, 0.09334696926026223, -0.053859212191540363, -0.013531954163605003
        },
        /* [15] 0.90625 <= y <= 0.96875, degree 10, 60.0 bits */
        {
         0.43189029504203147, 7.2343755407236972e-18, -0.33637935274731329, 0.3774122403036157,
         -0.17133610741375871, -0.063618335025439079, 0.1583153701792463, -0.10338874203632979,
         -0.0016504278226813502, 0.061613884111150777, -0.05206607943773945, 0.0085137644704697379
        },
        /* [16] 0.96875 <= y <= 1.03125, degree 10, 62.0 bits */
        {
         0.39393060322987317, 2.6702385527715683e-17, -0.29195544070407814, 0.33375068796585355,
         -0.17068150356846024, -0.024966061198850836, 0.11880365875730194, -0.094653893940789269,
         0.019609916242194204, 0.034772827495377044, -0.041714245863384992, 0.017591570677813039
        },
        /* [17] 1.03125 <= y <= 1.09375, degree 10, 57.5 bits */
        {
         0.35889812307987207, 1.5176189794025388e-17, -0.25282658358874383, 0.29283605445922545,
         -0.16360697813509009, 0.0023191990655631058, 0.084922481417687726, -0.080439408601954338,
         0.029502974500320769, 0.015186088100859699, -0.029243729220758349, 0.018469027906325035
        },
        /* [18] 1.09375 <= y <= 1.15625, degree 10, 60.8 bits */
        {
         0.32674711859236699, -1.2706784817621422e-17, -0.2186041214697278, 0.25532489820166065,
         -0.15249329075285414, 0.020356587097176283, 0.05754224595612828, -0.064660207840720962,
         0.031803915552148253, 0.0025885280021986749, -0.018157196374043474, 0.015380575133730439
        },
        /* [19] 1.15625 <= y <= 1.21875, degree 10, 58.9 bits */
        {
         0.29737313596597792, 4.8658089693839348e-18, -0.18884069483711674, 0.22151713313197771,
         -0.1391773384662422, 0.031262747260787815, 0.036461495273579121, -0.049684734437316927,
         0.029690417755175752, -0.0044610419331445631, -0.0097729724882347473, 0.011142963432259853
        },
        /* [20] 1.21875 <= y <= 1.28125, degree 10, 57.8 bits */
        {
         0.2706320254260739, 9.2886151612888972e-18, -0.16306855773485407, 0.1914543497600569,
         -0.12499909788513418, 0.036927684013978362, 0.020909712668151052, -0.036704969871229884,
         0.025467721776412079, -0.0076470239899752929, -0.0041404461401362523, 0.0072358186997457099
        },
        /* [21] 1.28125 <= y <= 1.34375, degree 10, 62.4 bits */
        {
         0.2463552787932678, 2.4177611114859856e-18, -0.14082646073911248, 0.16500354882510596,
         -0.11088143571667354, 0.038918413671600101, 0.0098975943811841702, -0.026127590747225132,
         0.02061825046453971, -0.0084313364309394987, -0.00074853327592660655, 0.0042188613841792092
        },
        /* [22] 1.34375 <= y <= 1.40625, degree 10, 59.1 bits */
        {
         0.22436191414872936, 1.1148518766313507e-17, -0.1216771399045168, 0.14192359462197515,
         -0.09741838561380102, 0.038464245998100409, 0.002431195789905108, -0.017897493435090835,
         0.015983125809171165, -0.0078994342967590499, 0.0010459014911558093, 0.0021446705916818324
        },
        /* [23] 1.40625 <= y <= 1.46875, degree 10, 58.2 bits */
        {
         0.20446733607159351, -5.1328590404563169e-18, -0.10521755968718208, 0.12191497526756516,
         -0.084957760036622434, 0.036486960662376867, -0.0023760566110155061, -0.011729216289878901,
         0.011962768821592855, -0.0067716860758420851, 0.0018124209189589859, 0.00084880924194353374
        },
        /* [24] 1.46875 <= y <= 1.53125, degree 10, 58.4 bits */
        {
         0.18648967473177858, 6.0490067337293156e-18, -0.0910838666749446, 0.10465511790889216,
         -0.073671423620484497, 0.033650508991511605, -0.0052589419633871102, -0.0072545856601936515,
         0.0086853615474241953, -0.0054801049709081529, 0.0019794791112203625, 0.00011454906692988408
        },
        /* [25] 1.53125 <= y <= 1.59375, degree 10, 59.3 bits */
        {
         0.170254104307277, -1.0921309680107767e-17, -0.078952684991249147, 0.089822087643616474,
         -0.063611308986994311, 0.030414730658146556, -0.0067958027922419856, -0.004106696953193034,
         0.0061290733400469833, -0.0042554279100550296, 0.0018364685533912369, -0.00025158840089978789
        },
        /* [26] 1.59375 <= y <= 1.65625, degree 10, 58.5 bits */
        {
         0.15559559506122511, 1.1681045515771986e-17, -0.068540029052572365, 0.077109450165284921,
         -0.054751906913261761, 0.027084819459841626, -0.0074241788160394079, -0.0019609263042000414,
         0.0042018901476397049, -0.0032006849755631776, 0.0015622916639223719, -0.00039582510895199601
        },
        /* [27] 1.65625 <= y <= 1.71875, degree 10, 59.1 bits */
        {
         0.14236048775812143, 2.9267777147479029e-18, -0.05959878224057992, 0.066234720622429633,
         -0.047021183879140567, 0.023853000229743272, -0.0074644296075753094, -0.00054969196826948721,
         0.0027890636794280417, -0.0023449134698010745, 0.0012581006589777179, -0.0004177779164413174
        },
        /* [28] 1.71875 <= y <= 1.78125, degree 10, 58.6 bits */
        {
         0.13040720896371627, -1.2688132155374858e-17, -0.051915415866729951, 0.056943356995036491,
         -0.040322233715465582, 0.020831646832543953, -0.0071443847781150326, 0.00033721814689363443,
         0.0017784764748953858, -0.0016786953620965659, 0.00097494389615330644, -0.00038008950862391757
        },
        /* [29] 1.78125 <= y <= 1.84375, degree 10, 58.3 bits */
        {
         0.11960637971081449, 5.7340899467372008e-19, -0.045306407085018235, 0.049009798060468603,
         -0.034547859095577449, 0.018078495514245781, -0.0066215812157857596, 0.00085917693052156693,
         0.001072219349089929, -0.0011758219513111029, 0.0007339817426494494, -0.00031933069041655644
        },
        /* [30] 1.84375 <= y <= 1.90625, degree 10, 59.8 bits */
        {
         0.10984051216828011, 6.7452576623008834e-18, -0.039614652603899861, 0.042236646840599204,
         -0.029589961087815309, 0.015615198819131784, -0.0060017681388520256, 0.0011336577360533699,
         0.0005902582593780534, -0.00080545320568716047, 0.00053995594611521097, -0.00025513323162958411
        },
        /* [31] 1.90625 <= y <= 1.96875, degree 10, 60.0 bits */
        {
         0.10100344070910945, 3.8137032639770771e-18, -0.034706058415567322, 0.036452777783279218,
         -0.025345240484601378, 0.013440587785626719, -0.0053535195985236032, 0.0012452160825747655,
         0.00026999698969536282, -0.00053826590081574774, 0.00038953041738778814, -0.00019684744531318359
        },
        /* [32] 1.96875 <= y <= 2.03125, degree 10, 58.5 bits */
        {
         0.092999594944286418, 6.0911769453776e-18, -0.03046640469238698, 0.031510898335705473,
         -0.021718360128255003, 0.011539900183292727, -0.0047193479883421057, 0.0012534232026496109,
         6.4021162224709444e-05, -0.00034906246952186282, 0.00027611342539987638, -0.00014798860447574631
        },
        /* [33] 2.03125 <= y <= 2.09375, degree 10, 59.3 bits */
        {
         0.085743191887732245, -2.2904664762121533e-18, -0.026798530693490408, 0.027284912955159106,
         -0.018623415725055496, 0.0098910301648394653, -0.004123915669956406, 0.0011993851086478946,
         -6.2706288763482166e-05, -0.00021745023447943202, 0.00019243706270649909, -0.00010901562117105382
        },
        /* [34] 2.09375 <= y <= 2.15625, degree 10, 60.3 bits */
        {
         0.07915740115140342, -5.2532843453259472e-18, -0.023619849640898947, 0.023667307309136014,
         -0.015984321861139808, 0.0084686356772348224, -0.0035799604003828671, 0.0011108540888976432,
         -0.00013555817591513042, -0.00012757134573453122, 0.00013179374228997084, -7.8967731509034408e-05
        },
        /* [35] 2.15625 <= y <= 2.21875, degree 10, 58.6 bits */
        {
         0.07317351961525087, 5.0273566305818362e-18, -0.020860182302197793, 0.020566680216586773,
         -0.013734536133234857, 0.0072467405381701957, -0.0030924834965509657, 0.0010061056117838623,
         -0.00017259052384593026, -6.7443456194245802e-05, 8.8517240348302722e-05, -5.6370432986358347e-05
        },
        /* [36] 2.21875 <= y <= 2.28125, degree 10, 58.1 bits */
        {
         0.067730179162898529, -4.7568930360863859e-18, -0.018459886120356681, 0.01790549029374169,
         -0.011816408598033542, 0.0062003018919466538, -0.0026616533396666225, 0.00089680589854669276,
         -0.0001864478576459756, -2.8208446828415531e-05, 5.80695107966907e-05, -3.9699117271786554e-05
        },
        /* [37] 2.28125 <= y <= 2.34375, degree 10, 58.3 bits */
        {
         0.062772601780730158, -6.32893299156578e-18, -0.016368251005141585, 0.015618044907348465,
         -0.010180346203205235, 0.0053060826622049221, -0.0022847793923529581, 0.00079009079845386348,
         -0.00018584644111229015, -3.431476643208582e-06, 3.6943532826861017e-05, -2.7588765305883506e-05
        },
        /* [38] 2.34375 <= y <= 2.40625, degree 10, 58.6 bits */
        {
         0.058251909730141133, 1.8194958990979851e-18, -0.014542131110648357, 0.013648734502164807,
         -0.0087839133720091431, 0.004543069040989587, -0.0019576260207983995, 0.00069004760655335491,
         -0.00017669542532173848, 1.1493628119079991e-05, 2.2497638749384645e-05, -1.8906192523462563e-05
        },
        /* [39] 2.40625 <= y <= 2.46875, degree 10, 59.4 bits */
        {
         0.05412449393717092, 3.3870282409970909e-18, -0.01294478252773399, 0.011950500932802118,
         -0.0075909428570824136, 0.0038925995082359477, -0.0016752651374811825, 0.00059875547346718697,
         -0.00016292579928979485, 1.9821302673749971e-05, 1.2780172310700511e-05, -1.2753499974787525e-05
        },
        /* [40] 2.46875 <= y <= 2.53125, degree 10, 58.3 bits */
        {
         0.050351440667816605, -2.7448257796546596e-18, -0.011544878780370024, 0.010483520698354568,
         -0.0065706993545217108, 0.0033383187458479167, -0.0014326118090658708, 0.00051700549734668181,
         -0.00014709274755393779, 2.3822922421962905e-05, 6.3711716502588579e-06, -8.4413169585534885e-06
        },
        /* [41] 2.53125 <= y <= 2.59375, degree 10, 58.5 bits */
        {
         0.046898014562820452, -2.6547856947676377e-19, -0.010315678650995929, 0.009214080569333415,
         -0.0056971176270346922, 0.0028660321321239603, -0.0012247455012570352, 0.00044479191392427056,
         -0.00013080713876190765, 2.5064451369443821e-05, 2.2504961784819776e-06, -5.4522454641182499e-06
        },
        /* [42] 2.59375 <= y <= 2.65625, degree 10, 60.4 bits */
        {
         0.043733194884511516, 4.1345413434703338e-19, -0.0092343237403542631, 0.0081136223730590689,
         -0.0049481236738461625, 0.0024635102164599072, -0.0010470890292994647, 0.00038164187971625573,
         -0.00011504081714472437, 2.4611499813335009e-05, -3.0679152109363184e-07, -3.4045562812536916e-06
        },
        /* [43] 2.65625 <= y <= 2.71875, degree 10, 59.4 bits */
        {
         0.040829261150828036, 1.726356512762652e-18, -0.0082812460298756548, 0.0071579345640100248,
         -0.0043050393922360111, 0.002120274518813998, -0.00089549511804273905, 0.00032683282753523179,
         -0.00010034018473493897, 2.3178487369831948e-05, -1.8107638427220492e-06, -2.0203736926784099e-06
        },
        /* [44] 2.71875 <= y <= 2.78125, degree 10, 61.4 bits */
        {
         0.038161424028995451, 2.1025967196198741e-18, -0.0074396684100482063, 0.0063264699246608578,
         -0.0037520664955773731, 0.0018273837901349374, -0.00076627466490568168, 0.00027953244098563921,
         -8.6974005532314987e-05, 2.12358188060683e-05, -2.6169088259223516e-06, -1.0996244502847778e-06
        },
        /* [45] 2.78125 <= y <= 2.84375, degree 10, 61.2 bits */
        {
         0.035707497310546482, -2.8495814427701752e-19, -0.0066951835902793978, 0.0056017708554183861,
         -0.0032758429997277721, 0.0015772317558194512, -0.00065618966731021387, 0.0002388860272860333,
         -7.5034551847091095e-05, 1.9086093546511232e-05, -2.9705865134753224e-06, -4.9958586019761989e-07
        },
        /* [46] 2.84375 <= y <= 2.90625, degree 10, 59.9 bits */
        {
         0.033447606902050217, -6.3649341924366899e-19, -0.0060353989847684777, 0.0049689859315447853,
         -0.0028650645517429921, 0.0013633620788411351, -0.00056242603053043288, 0.00020406862209045867,
         -6.4505980089704564e-05, 1.6917798683528636e-05, -3.0393792869504181e-06, -1.1928208805665237e-07
        },
        /* [47] 2.90625 <= y <= 2.96875, degree 10, 59.0 bits */
        {
         0.031363932979321482, 1.1445027147492225e-18, -0.0054496370731858717, 0.0044154635604983714,
         -0.0025101627048539246, 0.0011803029228166448, -0.00048255614297203404, 0.00017431382980716205,
         -5.5309901342666962e-05, 1.4842814728747457e-05, -2.9363814497527259e-06, 1.1218367056284297e-07
        },
        /* [48] 2.96875 <= y <= 3.03125, degree 10, 58.3 bits */
        {
         0.029440481723129873, -1.8558382245593767e-19, -0.0049286823789127234, 0.0039304105720403531,
         -0.0022030325786869614, 0.0010234214365905697, -0.00041449748161772828, 0.00014892762819637126,
         -4.7335226048345752e-05, 1.2922393848599329e-05, -2.7368164783304814e-06, 2.4421158528652527e-07
        },
        /* [49] 3.03125 <= y <= 3.09375, degree 10, 58.5 bits */
        {
         0.027662883351383893, -1.1631625941890693e-18, -0.0044645676139393881, 0.0035046053720168913,
         -0.0019368029479812465, 0.00088879728299213036, -0.00035647107606965331, 0.00012729271802437947,
         -4.0457268087712588e-05, 1.1184995919756469e-05, -2.4898025429954242e-06, 3.1095815829814232e-07
        },
        /* [50] 3.09375 <= y <= 3.15625, degree 10, 59.4 bits */
        {
         0.026018213466213379, 5.3218252880227406e-19, -0.0040503927343774086, 0.0031301568755775439,
         -0.0017056425269433694, 0.00077311369482432478, -0.00030696204800158148, 0.00010886715703654609,
         -3.4549590976825606e-05, 9.6384162091476859e-06, -2.2266244375577128e-06, 3.3583709172872617e-07
        },
        /* [51] 3.15625 <= y <= 3.21875, degree 10, 59.1 bits */
        {
         0.024494835031183253, 1.0049883494595305e-18, -0.0036801716604699377, 0.0028003018113269881,
         -0.0015045969680350839, 0.00067356425709655323, -0.00026468339456923459, 9.3179747625530776e-05,
         -2.9491010646524955e-05, 8.2779392302683758e-06, -1.9665108778976293e-06, 3.3474041294361948e-07
        },
        /* [52] 3.21875 <= y <= 3.28125, degree 10, 59.6 bits */
        {
         0.023082258575920164, -9.6557608984336893e-19, -0.0033487022652979831, 0.0025092341689826043,
         -0.0013294518196956468, 0.00058777354941436707, -0.00022854351799341067, 7.982377943335084e-05,
         -2.5169415720358392e-05, 7.0917459588862839e-06, -1.72064260091248e-06, 3.1832674965867853e-07
        },
        /* [53] 3.28125 <= y <= 3.34375, degree 10, 61.8 bits */
        {
         0.021771018488084718, -1.7894103555674409e-19, -0.0030514559502379142, 0.0022519615687056722,
         -0.0011766173582601815, 0.00051372984599622521, -0.00019761759327404651, 6.845014020264341e-05,
         -2.1483538360330041e-05, 6.064436954275987e-06, -1.494913501639032e-06, 2.9363770219014201e-07
        },
        /* [54] 3.34375 <= y <= 3.40625, degree 10, 59.1 bits */
        {
         0.020552563493629758, -1.3401714464208971e-18, -0.0027844837232729068, 0.0020241841811223164,
         -0.0010430318118173963, 0.00044972820428836128, -0.00017112262521204628, 5.8760414314677577e-05,
         -1.834344142058063e-05, 5.1792739770334388e-06, -1.2918178761747544e-06, 2.6523346505414687e-07
        },
        /* [55] 3.40625 <= y <= 3.46875, degree 10, 59.2 bits */
        {
         0.019419159645004302, 1.4903796590597074e-18, -0.0025443361965549124, 0.0018221925435666928,
         -0.00092608002424822736, 0.00039432243923381117, -0.00014839591550543771, 5.0500327988216177e-05,
         -1.5670233665971379e-05, 4.4195585960460262e-06, -1.1117286070958138e-06, 2.359865174399833e-07
        },
        /* [56] 3.46875 <= y <= 3.53125, degree 10, 61.4 bits */
        {
         0.018363804333789365, 9.002126859696629e-19, -0.0023279953377369558, 0.0016427812193262315,
         -0.00082352506814790255, 0.00034628465583003132, -0.00012887660066344001, 4.3453730688727642e-05,
         -1.3395350371840663e-05, 3.7694366555273652e-06, -9.5375326940417477e-07, 2.0763337393258205e-07
        },
        /* [57] 3.53125 <= y <= 3.59375, degree 10, 58.5 bits */
        {
         0.017380150020226304, -1.5133174249921977e-18, -0.0021328161588603468, 0.0014831757498573025,
         -0.00073345071078516756, 0.00030457118401229451, -0.00011208990506597666, 3.7437194478617442e-05,
         -1.1459617684401144e-05, 3.2143266877310282e-06, -8.1629951406374342e-07, 1.8115594525838504e-07
        },
        /* [58] 3.59375 <= y <= 3.65625, degree 10, 58.3 bits */
        {
         0.016462436528633557, -1.2680953261008351e-18, -0.0019564768182747799, 0.0013409707702544478,
         -0.00065421297417437012, 0.00026829391958237234, -9.7633762961494457e-05, 3.2295246505591033e-05,
         -9.8122387041486378e-06, 2.7411070901301089e-06, -6.974415796773743e-07, 1.5704342848002181e-07
        },
        /* [59] 3.65625 <= y <= 3.71875, degree 10, 61.1 bits */
        {
         0.015605430896398716, -2.2179007406679819e-19, -0.0017969358547063866, 0.0012140775088779628,
         -0.0005843993156605837, 0.00023669621922154047, -8.516748698248661e-05, 2.7896210635131667e-05,
         -8.4097854237700001e-06, 2.3381530166229649e-06, -5.95151859749643e-07, 1.3547079598681859e-07
        },
        /* [60] 3.71875 <= y <= 3.78125, degree 10, 61.7 bits */
        {
         0.014804373886733387, -1.9945672634246268e-19, -0.0016523954761560402, 0.001100679184277428,
         -0.00052279419593808296, 0.0002091326253609875, -7.4402191470721788e-05, 2.4128612880873368e-05,
         -7.2152450642688287e-06, 1.9952836731809929e-06, -5.0744180268188611e-07, 1.1641932857768047e-07
        },
        /* [61] 3.78125 <= y <= 3.84375, degree 10, 58.8 bits */
        {
         0.014054932383317712, 4.2595094337559704e-19, -0.0015212699964889983, 0.00099919305600137715,
         -0.00046835000346853544, 0.00018505180805022947, -6.5092711936007427e-05, 2.0898095344106852e-05,
         -6.1971462025844739e-06, 1.7036599575827777e-06, -4.3244264860733935e-07, 9.9757075293210796e-08
        },
        /* [62] 3.84375 <= y <= 3.90625, degree 10, 60.1 bits */
        {
         0.013353156979893942, 8.305535333181804e-20, -0.0014021586549433521, 0.00090823808866743398,
         -0.00042016247354883986, 0.00016398220698980314, -5.7030794562893929e-05, 1.8124780529493063e-05,
         -5.3287753492161052e-06, 1.4556582471646075e-06, -3.6844689101768281e-07, 8.5291761869220486e-08
        },
        /* [63] 3.90625 <= y <= 3.96875, degree 10, 58.8 bits */
        {
         0.012695444161244801, -6.7957233904948524e-19, -0.0012938221729838976, 0.00082660735759588241,
         -0.00037744988184031233, 0.00014551993900296505, -5.0039360274612376e-05, 1.5741029298333725e-05,
         -4.5874855426672265e-06, 1.2447365852946031e-06, -3.1392466372932197e-07, 7.2804883499983784e-08
        },
        /* [64] 3.96875 <= y <= 4.03125, degree 10, 59.3 bits */
        {
         0.012078502545143928, -6.5221847327612245e-19, -0.0011951625028250056, 0.00075324446508223187,
         -0.00033953541038967414, 0.00012931860598458658, -4.3967675682072604e-05, 1.3689539482169131e-05,
         -3.954093177177085e-06, 1.0653031239717651e-06, -2.675246226296649e-07, 6.2073052310871977e-08
        }
    };
    return row[i];
}

/* eps at zero overlap by x = beta^5, 2^-40 <= x < 2^14: 432 rows of degree 10 in y = beta^5 2^-k, 8 to each octave k = -40 ... 13.
 * Relative error of the approximation: 2^-53.8 at most, proved for the whole cell of each row. */
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_FIRST 9.094947017729282e-13
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_FIRST_OCTAVE (-40)
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_ROWS 432
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_END 16384.0
COR_INLINE const double *cor_rows_power_eps_zero_overlap(int i)
{
    static const double row[432][12] = {
        /* [0] 1 <= y <= 1.125 2^-40, degree 10, 67.4 bits */
        {
         0.99545182440960267, -5.6339940916545008e-18, -0.00085379019449517528, 0.00032186566182060983,
         -0.00018184223693819707, 0.00011983313793152665, -8.5731211567258961e-05, 6.4559185498320294e-05,
         -5.0349883268844155e-05, 4.0283386440828231e-05, -3.308548407141533e-05, 2.7408540099849849e-05
        },
        /* [1] 1.125 <= y <= 1.25 2^-40, degree 10, 68.3 bits */
        {
         0.99534980148990992, -4.5572952100616387e-17, -0.00078100547536920871, 0.00026344269996412119,
         -0.00013316989320095204, 7.8521046513882944e-05, -5.0262624889822837e-05, 3.3865763477178107e-05,
         -2.3631975821972131e-05, 1.6917019537632916e-05, -1.2414810887557879e-05, 9.201764047235716e-06
        },
        /* [2] 1.25 <= y <= 1.375 2^-40, degree 10, 69.2 bits */
        {
         0.99525604975535487, 2.3062054971281566e-18, -0.00072082942070221686, 0.0002199941382260219,
         -0.00010061654068792057, 5.3676729985372543e-05, -3.1087159362473964e-05, 1.8951005162355185e-05,
         -1.1964872352735183e-05, 7.7493818027725776e-06, -5.1402975753403632e-06, 3.4470246811551183e-06
        },
        /* [3] 1.375 <= y <= 1.5 2^-40, degree 10, 68.6 bits */
        {
         0.99516919919247515, 1.9887743213408129e-17, -0.00067016270764551887, 0.0001867504387307405,
         -7.7985730622909117e-05, 3.7986163741598261e-05, -2.0086920628485068e-05, 1.1180394890332649e-05,
         -6.4450481860046945e-06, 3.8113373663287204e-06, -2.3065780713752278e-06, 1.4122415231096149e-06
        },
        /* [4] 1.5 <= y <= 1.625 2^-40, degree 10, 72.2 bits */
        {
         0.99508820321449398, -2.9299892075913576e-17, -0.00062685654385598235, 0.00016071185440300306,
         -6.1743718687935276e-05, 2.7668965257394078e-05, -1.3460774638849944e-05, 6.8929113955523549e-06,
         -3.6556190312280504e-06, 1.988843867269242e-06, -1.1067047587893318e-06, 6.2338349102769371e-07
        },
        /* [5] 1.625 <= y <= 1.75 2^-40, degree 10, 68.3 bits */
        {
         0.99501224304502678, -1.3815775245026898e-17, -0.00058937191333543559, 0.00013991211447484013,
         -4.9771387046943061e-05, 2.0651805022973602e-05, -9.3027787197958117e-06, 4.4108526435350417e-06,
         -2.1659986016991719e-06, 1.0911258225832263e-06, -5.619372034761469e-07, 2.9307825428176783e-07
        },
        /* [6] 1.75 <= y <= 1.875 2^-40, degree 10, 68.6 bits */
        {
         0.9949406652468088, 4.3247067479207246e-17, -0.00055657617849416425, 0.00012301712870635992,
         -4.0743552639257455e-05, 1.5739999570871108e-05, -6.6012529910671308e-06, 2.914089710494668e-06,
         -1.3323100080347432e-06, 6.2486806762120161e-07, -2.9951020505115795e-07, 1.4543539103877999e-07
        },
        /* [7] 1.875 <= y <= 2 2^-40, degree 10, 68.2 bits */
        {
         0.99487293944171717, -1.6974219312148342e-17, -0.00052761633952834312, 0.00010909487055707209,
         -3.3801571713011077e-05, 1.2215766069853404e-05, -4.7926953892161154e-06, 1.9792175702691676e-06,
         -8.4651193174718983e-07, 3.7140949829120764e-07, -1.664893234722182e-07, 7.5627320219994046e-08
        },
        /* [8] 1 <= y <= 1.125 2^-39, degree 10, 66.8 bits */
        {
         0.9947776379986798, 3.9261247718269381e-17, -0.00097995155695195565, 0.00036950122655508979,
         -0.00020876869309432151, 0.00013758285968098907, -9.8432350222628549e-05, 7.4125145216189306e-05,
         -5.7811311351205613e-05, 4.6253644413225377e-05, -3.7989387937482233e-05, 3.1471309802313188e-05
        },
        /* [9] 1.125 <= y <= 1.25 2^-39, degree 10, 67.7 bits */
        {
         0.99466054060272069, 8.69405860658763e-18, -0.00089639538612634945, 0.00030242762434429742,
         -0.00015288728515554321, 9.0150588573411535e-05, -5.770844920463008e-05, 3.888337235131728e-05,
         -2.7133766207487535e-05, 1.9424044056534183e-05, -1.4254790140907934e-05, 1.0565645057685006e-05
        },
        /* [10] 1.25 <= y <= 1.375 2^-39, degree 10, 67.8 bits */
        {
         0.9945529383878563, -2.3367336179260387e-17, -0.00082731475253942954, 0.00025254625438844833,
         -0.00011551272728787641, 6.1626006135127409e-05, -3.5692009516942671e-05, 2.1758612769331337e-05,
         -1.373770404218136e-05, 8.8977258318494832e-06, -5.9020818714474526e-06, 3.9579076027953496e-06
        },
        /* [11] 1.375 <= y <= 1.5 2^-39, degree 10, 71.9 bits */
        {
         0.99445325850133792, 1.3197753417043623e-17, -0.00076915131586731704, 0.00021438104755769951,
         -8.9530518066739076e-05, 4.3611319347433425e-05, -2.3062127074055875e-05, 1.2836667672012579e-05,
         -7.3999466246578242e-06, 4.3760854498716981e-06, -2.6483882523574734e-06, 1.6215369144007829e-06
        },
        /* [12] 1.5 <= y <= 1.625 2^-39, degree 10, 69.3 bits */
        {
         0.994360299415606, 1.9598061821002372e-18, -0.00071943806733816389, 0.00018448792524704236,
         -7.0883398941364758e-05, 3.1766020084136659e-05, -1.5454407313531883e-05, 7.9139683321957356e-06,
         -4.1972025438349439e-06, 2.2835250028966281e-06, -1.2706970794189623e-06, 7.1576423550961532e-07
        },
        /* [13] 1.625 <= y <= 1.75 2^-39, degree 10, 70.0 bits */
        {
         0.9942731211489424, -2.8186060064608616e-17, -0.00067640809346927559, 0.00016060938700894931,
         -5.7138331738289488e-05, 2.3709600992741256e-05, -1.0680498537043583e-05, 5.0641998818610391e-06,
         -2.4868750283864583e-06, 1.2527857376193462e-06, -6.4520095627180965e-07, 3.3650794693519166e-07
        },
        /* [14] 1.75 <= y <= 1.875 2^-39, degree 10, 68.5 bits */
        {
         0.9941909735413631, 2.7720128071725446e-17, -0.00063876104714450071, 0.00014121375970117415,
         -4.6773836623269517e-05, 1.8070388817830442e-05, -7.5788261406140783e-06, 3.3457083159448557e-06,
         -1.5296710813981364e-06, 7.1744293563991868e-07, -3.4388717444217646e-07, 1.6698560514738374e-07
        },
        /* [15] 1.875 <= y <= 2 2^-39, degree 10, 68.8 bits */
        {
         0.99411324771281817, -1.7747697483972393e-17, -0.00060551763305982838, 0.00012523098915761795,
         -3.8804088057590303e-05, 1.402426875837412e-05, -5.5024018316073188e-06, 2.2723526611484385e-06,
         -9.719031489643298e-07, 4.264314834128056e-07, -1.9115604427329197e-07, 8.6833038281993758e-08
        },
        /* [16] 1 <= y <= 1.125 2^-38, degree 10, 67.2 bits */
        {
         0.99400387616965591, -3.4531621081847058e-17, -0.0011246199293394065, 0.00042414837267847787,
         -0.00023966301347030694, 0.00015794986501706457, -0.00011300716503008795, 8.5102747882693803e-05,
         -6.6374108315391336e-05, 5.310535353027555e-05, -4.3617440515489632e-05, 3.6134114842109126e-05
        },
        /* [17] 1.125 <= y <= 1.25 2^-38, degree 10, 69.6 bits */
        {
         0.99386949331412611, 2.1857736619230941e-17, -0.001028707012690658, 0.00034714950309758268,
         -0.00017550962465425881, 0.00010349463839417266, -6.6252486656057197e-05, 4.4641299333301481e-05,
         -3.1152364131361527e-05, 2.2301146957329605e-05, -1.6366432320023122e-05, 1.2130928316354064e-05
        },
        /* [18] 1.25 <= y <= 1.375 2^-38, degree 10, 69.0 bits */
        {
         0.99374600975832683, 4.0095854502575487e-17, -0.00094941155397073272, 0.0002898876705118333,
         -0.00013260314476516615, 7.0747015367846622e-05, -4.097593450220215e-05, 2.498040051595044e-05,
         -1.5772137020738682e-05, 1.021555935993338e-05, -6.776323207918281e-06, 4.5442211742579474e-06
        },
        /* [19] 1.375 <= y <= 1.5 2^-38, degree 10, 70.5 bits */
        {
         0.99363161992848381, 1.1523308345198856e-17, -0.00088264852860468713, 0.00024607607204671654,
         -0.0001027755741254003, 5.0065495835245999e-05, -2.6476018516011124e-05, 1.4737239098589307e-05,
         -8.4957311487756422e-06, 5.0241759158976204e-06, -3.0406507883615032e-06, 1.8617302284237378e-06
        },
        /* [20] 1.5 <= y <= 1.625 2^-38, degree 10, 69.6 bits */
        {
         0.99352494453497375, -1.246543396682274e-17, -0.00082558580902681493, 0.00021176077613686427,
         -8.1368914933352223e-05, 3.6466797242244782e-05, -1.7741953008447397e-05, 9.0856095928263805e-06,
         -4.8186809510280149e-06, 2.6216879724658396e-06, -1.4588922048656359e-06, 8.2178132751637155e-07
        },
        /* [21] 1.625 <= y <= 1.75 2^-38, degree 10, 68.9 bits */
        {
         0.99342490454140309, -4.6163685113387344e-17, -0.00077619499945496303, 0.00018435011418444793,
         -6.5589908122420238e-05, 2.7217915389814107e-05, -1.2261302694521597e-05, 5.813889673822417e-06,
         -2.8550815779841299e-06, 1.4382966027765681e-06, -7.4075174925141024e-07, 3.8634757478095845e-07
        },
        /* [22] 1.75 <= y <= 1.875 2^-38, degree 10, 68.5 bits */
        {
         0.99333063882342698, 9.5686682219635101e-18, -0.00073298333186556214, 0.00016208570290168092,
         -5.3691828897039133e-05, 2.0744078728941941e-05, -8.7004813759105696e-06, 3.8409656865405599e-06,
         -1.7561400387872197e-06, 8.2367455051698037e-07, -3.9481202790007708e-07, 1.9171614509346849e-07
        },
        /* [23] 1.875 <= y <= 2 2^-38, degree 10, 70.4 bits */
        {
         0.99324144844201412, -1.8031539611112131e-17, -0.00069482660885755775, 0.00014373911544144171,
         -4.4542916608206174e-05, 1.6099156932642109e-05, -6.3166976567074309e-06, 2.6087032683140515e-06,
         -1.1157857022389145e-06, 4.895695027694432e-07, -2.1946199404737065e-07, 9.9692298924977527e-08
        },
        /* [24] 1 <= y <= 1.125 2^-37, degree 10, 66.7 bits */
        {
         0.99311594670231962, -9.5574047698699518e-18, -0.0012904671114690534, 0.00048682691299719888,
         -0.00027510374854510888, 0.00018131631932429967, -0.00012972950810916694, 9.7698465840838735e-05,
         -7.6199457369497127e-05, 6.096757358683201e-05, -5.007571273946605e-05, 4.148487679309906e-05
        },
        /* [25] 1.125 <= y <= 1.25 2^-37, degree 10, 67.6 bits */
        {
         0.99296174831919481, -9.524919411642705e-18, -0.0011803816359070803, 0.00039844233694118837,
         -0.00020146028969888729, 0.00011880343774068821, -7.6055186496530664e-05, 5.124778551185873e-05,
         -3.576337595724498e-05, 2.560249510399359e-05, -1.8789516062720002e-05, 1.3927114863444601e-05
        },
        /* [26] 1.25 <= y <= 1.375 2^-37, degree 10, 67.5 bits */
        {
         0.99282005966265818, 1.9366942339429177e-18, -0.0010893706743647219, 0.00033271430006729568,
         -0.00015220745694368183, 8.1210713271203823e-05, -4.7038111532273826e-05, 2.8676904294125161e-05,
         -1.8106429492941377e-05, 1.1727681852560002e-05, -7.7794830751569022e-06, 5.2170109376523284e-06
        },
        /* [27] 1.375 <= y <= 1.5 2^-37, degree 10, 67.3 bits */
        {
         0.99268880820186245, 2.6565280442095455e-17, -0.0010127449764261933, 0.00028242584133101407,
         -0.00011796850580675933, 5.7469604382395464e-05, -3.0392642384916585e-05, 1.6917804022954759e-05,
         -9.752999451464968e-06, 5.7677996498827845e-06, -3.4907487492192176e-06, 2.1373446513472023e-06
        },
        /* [28] 1.5 <= y <= 1.625 2^-37, degree 10, 68.0 bits */
        {
         0.99256641073970275, 4.2192546260682501e-17, -0.00094725355132124246, 0.00024303808677911598,
         -9.3396188460313664e-05, 4.1859319467764844e-05, -2.0366309238775047e-05, 1.0429830709589292e-05,
         -5.5317316019603402e-06, 3.0096912912738208e-06, -1.6748309464854719e-06, 9.4343047764383912e-07
        },
        /* [29] 1.625 <= y <= 1.75 2^-37, degree 10, 68.8 bits */
        {
         0.99245162873680959, 4.7344477389600701e-17, -0.00089056803854867337, 0.0002115759930135879,
         -7.5283960107105951e-05, 3.1242413473651473e-05, -1.4074823296461471e-05, 6.6739906246788239e-06,
         -3.2775340971482044e-06, 1.6511453187215448e-06, -8.5038668661940155e-07, 4.4353501209443753e-07
        },
        /* [30] 1.75 <= y <= 1.875 2^-37, degree 10, 71.5 bits */
        {
         0.99234347378989907, -4.5778746210580817e-17, -0.00084097493535203029, 0.00018602108865336189,
         -6.1626674861683459e-05, 2.3811092441470785e-05, -9.9872359556719842e-06, 4.4091523372770283e-06,
         -2.0159690203657015e-06, 9.4555897275606281e-07, -4.532422289387072e-07, 2.2009223295425171e-07
        },
        /* [31] 1.875 <= y <= 2 2^-37, degree 10, 68.4 bits */
        {
         0.99224114366227112, -2.1108977587840277e-17, -0.00079718382397585958, 0.00016496326090016525,
         -5.1125145437907461e-05, 1.8479235511818859e-05, -7.2508353322029863e-06, 2.9945767723292003e-06,
         -1.280860192147059e-06, 5.620095124282973e-07, -2.5193919714459299e-07, 1.1444693053112382e-07
        },
        /* [32] 1 <= y <= 1.125 2^-36, degree 10, 66.4 bits */
        {
         0.99209715545812116, -4.3007845812903735e-17, -0.0014805369238440789, 0.00055870108569576482,
         -0.00031575184392358642, 0.0002081189884435597, -0.00014891244228803821, 0.00011214838264240784,
         -8.747168753214793e-05, 6.9987916881722055e-05, -5.7485537140369241e-05, 4.762417720915021e-05
        },
        /* [33] 1.125 <= y <= 1.25 2^-36, degree 10, 67.4 bits */
        {
         0.99192024800002521, -1.0689792311515146e-17, -0.0013541999296704059, 0.00045725810211398897,
         -0.00023122289347870457, 0.00013636294742855489, -8.7299951229285463e-05, 5.8826582313827185e-05,
         -4.1053256286546809e-05, 2.9390035806153413e-05, -2.1569539021186853e-05, 1.5987950474688502e-05
        },
        /* [34] 1.25 <= y <= 1.375 2^-36, degree 10, 67.0 bits */
        {
         0.9917576968934354, 4.1318179971039117e-17, -0.0012497554321705933, 0.00038182039479942189,
         -0.0001746907648923107, 9.3212436393274762e-05, -5.3991894246879683e-05, 3.2917327738485246e-05,
         -2.0784324980089788e-05, 1.3462452361317005e-05, -8.9303879833482426e-06, 5.9889106237315625e-06
        },
        /* [35] 1.375 <= y <= 1.5 2^-36, degree 10, 67.5 bits */
        {
         0.99160712344082347, -9.5885519064739009e-18, -0.001161821129659386, 0.00032410402125259254,
         -0.00013539208482835698, 6.5961786283914674e-05, -3.4885194198599973e-05, 1.9419164545608216e-05,
         -1.1195300403890003e-05, 6.6208961817754511e-06, -4.0071252372374844e-06, 2.4535533238271106e-06
        },
        /* [36] 1.5 <= y <= 1.625 2^-36, degree 10, 68.0 bits */
        {
         0.99146671059572944, -4.0027593993204969e-17, -0.0010866656062426074, 0.00027889914045525278,
         -0.00010718894339049394, 4.8044143614850375e-05, -2.3376496403899016e-05, 1.1971772243780735e-05,
         -6.3497038627714659e-06, 3.4548049613591513e-06, -1.9225621819561646e-06, 1.0829939976046682e-06
        },
        /* [37] 1.625 <= y <= 1.75 2^-36, degree 10, 67.7 bits */
        {
         0.99133503689958036, -5.0727461880873687e-17, -0.0010216164589738276, 0.00024279096432774526,
         -8.6400713337833748e-05, 3.5858104472426168e-05, -1.6154919136181538e-05, 7.6605816721969466e-06,
         -3.7621380753712932e-06, 1.8953183363615877e-06, -9.761605892558725e-07, 5.0914274478589884e-07
        },
        /* [38] 1.75 <= y <= 1.875 2^-36, degree 10, 68.9 bits */
        {
         0.99121096798857899, 2.5949181597927775e-17, -0.00096470702127133038, 0.00021346269819082838,
         -7.0725819241268829e-05, 2.7328566547212393e-05, -1.146310315346625e-05, 5.0608855626773316e-06,
         -2.3140182905520891e-06, 1.0853780697629509e-06, -5.202724736595672e-07, 2.5264582827532487e-07
        },
        /* [39] 1.875 <= y <= 2 2^-36, degree 10, 68.0 bits */
        {
         0.99109358316966423, -4.3482183209653571e-17, -0.00091445623935594437, 0.00018929583853630758,
         -5.8673026263724653e-05, 2.1208824159764151e-05, -8.3222402887365631e-06, 3.4371808050261145e-06,
         -1.4702132393047893e-06, 6.4510719108166754e-07, -2.8919589366013931e-07, 1.3137343518623024e-07
        },
        /* [40] 1 <= y <= 1.125 2^-35, degree 10, 66.5 bits */
        {
         0.99092841521889929, -5.3831551981808003e-17, -0.0016982926259408795, 0.00064109875691143131,
         -0.00036236174581700078, 0.00023885665445254022, -0.00017091359432108011, 0.00012872225130874988,
         -0.00010040145544946883, 8.0335104954916322e-05, -6.5985615523726863e-05, 5.4667009162995907e-05
        },
        /* [41] 1.125 <= y <= 1.25 2^-35, degree 10, 66.6 bits */
        {
         0.99072549161719903, -2.928626944800969e-17, -0.0015533250470645926, 0.00052468239213431303,
         -0.00026534938327828808, 0.00015649968782910798, -0.00010019626372885484, 6.751907298749707e-05,
         -4.7120796398269471e-05, 3.3734567070038976e-05, -2.475850625893456e-05, 1.8352011904084973e-05
        },
        /* [42] 1.25 <= y <= 1.375 2^-35, degree 10, 67.4 bits */
        {
         0.99053904127530157, 3.967538855421063e-17, -0.0014334811359027551, 0.00043811154903182497,
         -0.0002004697024339368, 0.00010697519945195643, -6.1966740359706629e-05, 3.7780725611355195e-05,
         -2.3855803610291736e-05, 1.5452278334504015e-05, -1.0250554953601661e-05, 6.8743611440411144e-06
        },
        /* [43] 1.375 <= y <= 1.5 2^-35, degree 10, 67.7 bits */
        {
         0.9903663344433945, 3.472113859516307e-17, -0.0013325838304213194, 0.00037187860821529873,
         -0.00015536895516781514, 7.5699738641278711e-05, -4.0037259245604628e-05, 2.2287926103690533e-05,
         -1.2849537597651791e-05, 7.5993934339614178e-06, -4.5994290522137245e-06, 2.8162688277602774e-06
        },
        /* [44] 1.5 <= y <= 1.625 2^-35, degree 10, 67.8 bits */
        {
         0.99020528595171176, 9.1591285829639036e-18, -0.0012463508028963588, 0.00032000424863876613,
         -0.00012300242027247168, 5.5136049455071903e-05, -2.6828487459151506e-05, 1.374014775074617e-05,
         -7.2878473967363947e-06, 3.9653352559332614e-06, -2.2067125711287032e-06, 1.2430802046783724e-06
        },
        /* [45] 1.625 <= y <= 1.75 2^-35, degree 10, 67.4 bits */
        {
         0.99005426462000212, 1.3446164763220432e-17, -0.0011717151430978231, 0.00027856938797005663,
         -9.9145760083097889e-05, 4.1150598430232022e-05, -1.8540247521448269e-05, 8.7920252347196042e-06,
         -4.3179235658875427e-06, 2.1753699510925065e-06, -1.1204213102707303e-06, 5.8439635363418699e-07
        },
        /* [46] 1.75 <= y <= 1.875 2^-35, degree 10, 67.8 bits */
        {
         0.98991196874207044, 1.9376164306715778e-17, -0.001106419894390956, 0.00024491512708000229,
         -8.1157442268860311e-05, 3.1361706389879316e-05, -1.3155496980455521e-05, 5.8082894530257122e-06,
         -2.6558390324060758e-06, 1.2457385375235976e-06, -5.9715347205246476e-07, 2.8998478025466626e-07
        },
        /* [47] 1.875 <= y <= 2 2^-35, degree 10, 66.9 bits */
        {
         0.98977734181965604, -4.2502353941321926e-17, -0.0010487654162888002, 0.00021718399500013399,
         -6.7325989836378129e-05, 2.433849676372458e-05, -9.5508040427679262e-06, 3.9447452301552853e-06,
         -1.6873699719558737e-06, 7.4041108363181014e-07, -3.3192695748937938e-07, 1.5078773812409537e-07
        },
        /* [48] 1 <= y <= 1.125 2^-34, degree 10, 66.1 bits */
        {
         0.98958791790650358, -3.555944814494538e-17, -0.0019476689494703824, 0.00073553276942731202,
         -0.00041579379907716898, 0.00027409841372907559, -0.00019614115432849808, 0.00014772804773945119,
         -0.00011522931866177461, 9.2201842000238352e-05, -7.5734389194701793e-05, 6.2744748022019916e-05
        },
        /* [49] 1.125 <= y <= 1.25 2^-34, degree 10, 67.3 bits */
        {
         0.98935520133646249, -6.1305815289014e-18, -0.0017813498393554064, 0.00060195179265333932,
         -0.00030446907530450344, 0.00017958615161758424, -0.00011498318965256619, 7.7486651508814437e-05,
         -5.4078794853477464e-05, 3.8716939748496658e-05, -2.8415816382849988e-05, 2.1063366163307481e-05
        },
        /* [50] 1.25 <= y <= 1.375 2^-34, degree 10, 68.3 bits */
        {
         0.9891413840443235, -8.5407852709337891e-18, -0.0016438583445208066, 0.00050261913325510546,
         -0.00023001923139415526, 0.00012275338004274681, -7.1110369391773085e-05, 4.3357330049762834e-05,
         -2.7377924911555119e-05, 1.773416439053203e-05, -1.1764557178924585e-05, 7.8898567480999108e-06
        },
        /* [51] 1.375 <= y <= 1.5 2^-34, degree 10, 67.4 bits */
        {
         0.9889433338711916, -1.7970142960346793e-17, -0.0015281062367537403, 0.00042662412222234277,
         -0.00017826687766487006, 8.6863311864583093e-05, -4.5944201723932052e-05, 2.5577277193891287e-05,
         -1.4746421814240538e-05, 8.721476752004877e-06, -5.2786782583694365e-06, 3.2322437286596709e-06
        },
        /* [52] 1.5 <= y <= 1.625 2^-34, degree 10, 68.4 bits */
        {
         0.98875865831179044, 3.2544285597139861e-17, -0.0014291796104598698, 0.00036710519628279124,
         -0.00014112751223470827, 6.3265924827347664e-05, -3.0786135643489028e-05, 1.5767722933530097e-05,
         -8.3635680042880347e-06, 4.5507646829330925e-06, -2.5325648061932376e-06, 1.4266676759019645e-06
        },
        /* [53] 1.625 <= y <= 1.75 2^-34, degree 10, 66.9 bits */
        {
         0.98858548580218142, -2.4512325665844438e-17, -0.001343559299291407, 0.00031956509733829249,
         -0.00011375338076913437, 4.7217508463511569e-05, -2.1274903375969675e-05, 1.0089272891873127e-05,
         -4.9551963298453017e-06, 2.4964988725889093e-06, -1.2858493577108737e-06, 6.7069526420779546e-07
        },
        /* [54] 1.75 <= y <= 1.875 2^-34, degree 10, 68.1 bits */
        {
         0.98842232283456211, -1.2549623204329062e-17, -0.001268655574271881, 0.00028095271419467687,
         -9.3113169184236595e-05, 3.5984851366497944e-05, -1.5095684319574619e-05, 6.6651962646431294e-06,
         -3.0477660594267391e-06, 1.4296156334586661e-06, -6.8531301184248237e-07, 3.3280309848567988e-07
        },
        /* [55] 1.875 <= y <= 2 2^-34, degree 10, 69.2 bits */
        {
         0.98826795726101202, 1.9312436528120692e-17, -0.0012025182270668723, 0.00024913661522819386,
         -7.7242886290904589e-05, 2.7925905684359948e-05, -1.0959211516558183e-05, 4.5266585381618955e-06,
         -1.9363527778293375e-06, 8.4968852923056331e-07, -3.8092557627743045e-07, 1.7305051575710846e-07
        },
        /* [56] 1 <= y <= 1.125 2^-33, degree 10, 66.6 bits */
        {
         0.98805076679089965, -1.9269321331068957e-17, -0.0022331286990090525, 0.00084372453867837102,
         -0.00047702801917847267, 0.00031449292023446961, -0.00022506057108334307, 0.0001695170592537981,
         -0.00013222973312980541, 0.0001058080322789945, -8.6912694931387958e-05, 7.2007361217999227e-05
        },
        /* [57] 1.125 <= y <= 1.25 2^-33, degree 10, 67.2 bits */
        {
         0.98778394770561218, -4.6908604505750077e-17, -0.0020423481383053934, 0.00069047306513478454,
         -0.00034929868179036614, 0.00020604682820658869, -0.00013193328313963046, 8.8913379172852913e-05,
         -6.2055925181965979e-05, 4.4429402729470802e-05, -3.2609253874683461e-05, 2.4172309295495653e-05
        },
        /* [58] 1.25 <= y <= 1.375 2^-33, degree 10, 68.4 bits */
        {
         0.98753880719610976, 3.9700607269926115e-17, -0.0018846397811056789, 0.00057651621481032644,
         -0.0002638801769202717, 0.00014083681668053513, -8.1591167183145649e-05, 4.9750030647618263e-05,
         -3.1415769436974865e-05, 2.0350326015720185e-05, -1.3500433268020898e-05, 9.0542207045248328e-06
        },
        /* [59] 1.375 <= y <= 1.5 2^-33, degree 10, 68.5 bits */
        {
         0.98731175196830268, -4.6753021665130394e-18, -0.0017518710800176768, 0.00048933504391943149,
         -0.00020450454132257733, 9.9657396534703576e-05, -5.2714711749586755e-05, 2.9347859003610307e-05,
         -1.6920976258033883e-05, 1.0007889594264317e-05, -6.0574431466921642e-06, 3.7091831173018072e-06
        },
        /* [60] 1.5 <= y <= 1.625 2^-33, degree 10, 69.8 bits */
        {
         0.98710003734656249, 4.9568099080323167e-17, -0.0016384042879090128, 0.00042105674294376185,
         -0.00016189534446172483, 7.2582859419850475e-05, -3.532220701025264e-05, 1.8091849739138005e-05,
         -9.5967131401249447e-06, 5.2219083364282299e-06, -2.906145095769749e-06, 1.6371547591772466e-06
        },
        /* [61] 1.625 <= y <= 1.75 2^-33, degree 10, 67.6 bits */
        {
         0.98690151632754408, 5.539171505278829e-17, -0.0015402019358492993, 0.00036652136111864776,
         -0.00013049021923284071, 5.4170007244436894e-05, -2.440913012998351e-05, 1.157620593151592e-05,
         -5.68570642558823e-06, 2.8646337172648976e-06, -1.4755021715856202e-06, 7.6963595078189408e-07
        },
        /* [62] 1.75 <= y <= 1.875 2^-33, degree 10, 71.3 bits */
        {
         0.98671447563992187, 4.2265667428904045e-17, -0.0014542929396828186, 0.00032222825841370491,
         -0.00010681106632657465, 4.128265670322348e-05, -1.7319287573417148e-05, 7.6473706433374344e-06,
         -3.4970211774353629e-06, 1.640401982426397e-06, -7.8637948587608831e-07, 3.818924332839369e-07
        },
        /* [63] 1.875 <= y <= 2 2^-33, degree 10, 67.0 bits */
        {
         0.98653752480146339, 1.7164686796220423e-17, -0.0013784399520083582, 0.00028573201733962092,
         -8.8604460938167159e-05, 3.2036695615428584e-05, -1.257330473894518e-05, 5.1936196459549286e-06,
         -2.2217467744510513e-06, 9.7495458407845091e-07, -4.3709629174789363e-07, 1.9857314868114554e-07
        },
        /* [64] 1 <= y <= 1.125 2^-32, degree 10, 65.8 bits */
        {
         0.986288565405395, -4.5957085076930171e-17, -0.0025597236530301563, 0.00096762994708678705,
         -0.0005471792981919251, 0.00036077862560994142, -0.00025820198601348793, 0.00019448954393712559,
         -0.00015171550495094967, 0.00012140436687738939, -9.972672850581546e-05, 8.2625875768088368e-05
        },
        /* [65] 1.125 <= y <= 1.25 2^-32, degree 10, 66.3 bits */
        {
         0.98598273133428416, 2.9145841438679215e-17, -0.0023409298245456464, 0.00079184417197422879,
         -0.00040065337014650383, 0.00023636487134295208, -0.0001513569195069397, 0.00010200893665856924,
         -7.1198814073417162e-05, 5.0977101369312877e-05, -3.7416095488113316e-05, 2.7736190712888688e-05
        },
        /* [66] 1.25 <= y <= 1.375 2^-32, degree 10, 69.7 bits */
        {
         0.98570175859047771, 3.280318652240817e-18, -0.0021600706160574031, 0.00066113498591283777,
         -0.00030266753001142663, 0.00016155534023535619, -9.3600851040241464e-05, 5.7076017852958255e-05,
         -3.6043485727335381e-05, 2.3348872678593117e-05, -1.5490143209809489e-05, 1.0388912701524246e-05
        },
        /* [67] 1.375 <= y <= 1.5 2^-32, degree 10, 68.2 bits */
        {
         0.98544152563768272, 4.0277257541048536e-17, -0.0020078169478425184, 0.00056114050735148527,
         -0.0002345579602622356, 0.00011431511286806543, -6.0472518707098425e-05, 3.3668730284661909e-05,
         -1.9413097912456787e-05, 1.1482268006407846e-05, -6.9500499513748722e-06, 4.2558700204933809e-06
        },
        /* [68] 1.5 <= y <= 1.625 2^-32, degree 10, 67.7 bits */
        {
         0.9851988844019175, 3.501010690339413e-17, -0.0018777017706462641, 0.00048282918543474037,
         -0.00018568231072101104, 8.325645618371624e-05, -4.0519523138143295e-05, 2.0755058537803067e-05,
         -1.100988893666677e-05, 5.9910877048369706e-06, -3.3343205127906145e-06, 1.8784147130930464e-06
        },
        /* [69] 1.625 <= y <= 1.75 2^-32, degree 10, 66.9 bits */
        {
         0.9849713723898299, -4.199021867437017e-17, -0.0017650938262785763, 0.00042028175360043037,
         -0.00014965932139856291, 6.2134543977464512e-05, -2.8000105921892144e-05, 1.3280012683697046e-05,
         -6.5228352845904727e-06, 3.2865279890850269e-06, -1.6928633645582318e-06, 8.8303776369643201e-07
        },
        /* [70] 1.75 <= y <= 1.875 2^-32, degree 10, 68.0 bits */
        {
         0.98475702462338688, 1.4992708487085113e-17, -0.0016665851531043104, 0.00036948252131425611,
         -0.00012249893087797406, 4.7351396158157902e-05, -1.9866840195426615e-05, 8.7727579148356756e-06,
         -4.0118278127204887e-06, 1.8819617686390266e-06, -9.022080426784399e-07, 4.3815484718390313e-07
        },
        /* [71] 1.875 <= y <= 2 2^-32, degree 10, 68.4 bits */
        {
         0.98455424637368993, -3.5318675974998914e-17, -0.0015796094729528881, 0.00032762633379491697,
         -0.00010161607065443918, 3.6745510271874675e-05, -1.4422484558465205e-05, 5.9578058906833463e-06,
         -2.5487723747214281e-06, 1.1185041186030158e-06, -5.014694863899954e-07, 2.2782434085318688e-07
        },
        /* [72] 1 <= y <= 1.125 2^-31, degree 10, 66.2 bits */
        {
         0.98426896019174359, -3.8594532673276342e-17, -0.0029331591894655598, 0.0011094675114794743,
         -0.00062751407056691713, 0.000413795048592909, -0.0002961684368659156, 0.00022310098848104336,
         -0.00017404272059049327, 0.00013927630107808461, -0.00011441133449884999, 9.4795119982080806e-05
        },
        /* [73] 1.125 <= y <= 1.25 2^-31, degree 10, 65.9 bits */
        {
         0.98391851787095241, -1.1403616477775702e-17, -0.0026822991134358709, 0.00090787711066087344,
         -0.00045945886765306202, 0.00027108942816243874, -0.00017360707124563089, 0.00011701188489548886,
         -8.1674340679896475e-05, 5.8479737537990655e-05, -4.2924337338832064e-05, 3.182032832045042e-05
        },
        /* [74] 1.25 <= y <= 1.375 2^-31, degree 10, 66.7 bits */
        {
         0.98359657997751493, 1.87677224131462e-17, -0.0024749415598525814, 0.00075798566299890336,
         -0.00034707952371050126, 0.00018528374938660787, -0.000107357404560436, 6.5468596525673696e-05,
         -4.1345447605534666e-05, 2.6784563956155009e-05, -1.777007364846154e-05, 1.1918369821592558e-05
        },
        /* [75] 1.375 <= y <= 1.5 2^-31, degree 10, 66.7 bits */
        {
         0.983298420109328, -3.1674412635006653e-17, -0.0023003870419013341, 0.0006433202108380616,
         -0.00026896745865307131, 0.00013110130907325644, -6.9358276162316928e-05, 3.861843117389867e-05,
         -2.2268177522573875e-05, 1.3171510541326214e-05, -7.9728064185184074e-06, 4.8823044024984445e-06
        },
        /* [76] 1.5 <= y <= 1.625 2^-31, degree 10, 66.8 bits */
        {
         0.98302042830825531, -3.1675532177993562e-17, -0.0021512187527662151, 0.00055352194404292897,
         -0.0002129155668069246, 9.5479364126876612e-05, -4.6472217133040367e-05, 2.3805710477451407e-05,
         -1.2628810055025053e-05, 6.8723227500844585e-06, -3.8249067045439868e-06, 2.1548567782017362e-06
        },
        /* [77] 1.625 <= y <= 1.75 2^-31, degree 10, 67.4 bits */
        {
         0.98275978087116367, -4.1160906162533602e-17, -0.0020221254341499517, 0.0004818018959538542,
         -0.00017160453578519858, 7.1254724085507027e-05, -3.211280701013183e-05, 1.5231603865734586e-05,
         -7.4818020021496423e-06, 3.7698649685036802e-06, -1.9418971657990381e-06, 1.0129715155535805e-06
        },
        /* [78] 1.75 <= y <= 1.875 2^-31, degree 10, 67.0 bits */
        {
         0.98251422465232552, -3.2153741030459739e-17, -0.0019091988428323369, 0.00042355447901568761,
         -0.00014045787181055365, 5.4300386924102769e-05, -2.2784396284920359e-05, 1.0061757179679391e-05,
         -4.6015373226674226e-06, 2.1586905394212844e-06, -1.0349094810395751e-06, 5.0261694156059044e-07
        },
        /* [79] 1.875 <= y <= 2 2^-31, degree 10, 67.1 bits */
        {
         0.98228193110184081, -3.2998974815170259e-17, -0.001809496049826297, 0.00037556254298822423,
         -0.00011651063794418409, 4.2137092589257645e-05, -1.6540151111370827e-05, 6.8330576727259543e-06,
         -2.9233651932367954e-06, 1.2829472151823746e-06, -5.7521738012060676e-07, 2.6133743661057115e-07
        },
        /* [80] 1 <= y <= 1.125 2^-30, degree 10, 65.3 bits */
        {
         0.98195513447037042, 2.7994179112858778e-17, -0.0033598616352202978, 0.0012717486872627218,
         -0.00071946841290578868, 0.00047449507662557125, -0.00033964484298244589, 0.00025586897916460668,
         -0.00019961617057304246, 0.00015974843663813746, -0.00013123363579667214, 0.00010873675161703085
        },
        /* [81] 1.125 <= y <= 1.25 2^-30, degree 10, 68.0 bits */
        {
         0.98155372399536767, 3.9600109737439866e-17, -0.0030723150906959975, 0.0010406224304185599,
         -0.0005267645858428047, 0.00031084362771925607, -0.00019908453195423924, 0.00013419324087324269,
         -9.3672162998494673e-05, 6.707339654788768e-05, -4.9234047185430933e-05, 3.6499018159691799e-05
        },
        /* [82] 1.25 <= y <= 1.375 2^-30, degree 10, 69.3 bits */
        {
         0.98118498578230784, 4.4982810582021328e-17, -0.0028346438280940829, 0.00086877674026813122,
         -0.00039790745862779023, 0.00021244722632201115, -0.00012310828365953049, 7.5079172301839047e-05,
         -4.7417524339983538e-05, 3.0719640780610283e-05, -2.0381594131953244e-05, 1.3670382358178664e-05
        },
        /* [83] 1.375 <= y <= 1.5 2^-30, degree 10, 67.1 bits */
        {
         0.98084350115287489, 3.2625927517418319e-17, -0.0026345795014171437, 0.00073732143758892114,
         -0.00030834522132707441, 0.00015031636434958997, -7.9531618522954908e-05, 4.4286147091401236e-05,
         -2.5537779329621151e-05, 1.5106184522275815e-05, -9.1442498907605678e-06, 5.5998562269435716e-06
        },
        /* [84] 1.5 <= y <= 1.625 2^-30, degree 10, 66.7 bits */
        {
         0.98052513155471666, -2.0572549770191205e-17, -0.0024636180819462773, 0.00063437807189286135,
         -0.00024407896073000521, 0.00010947002832338966, -5.3287102546481763e-05, 2.7298710463706355e-05,
         -1.4482682874690094e-05, 7.8815426586847959e-06, -4.3867862464756932e-06, 2.4714933667818777e-06
        },
        /* [85] 1.625 <= y <= 1.75 2^-30, degree 10, 70.3 bits */
        {
         0.98022663993268411, -3.5518866533834418e-17, -0.0023156699386908406, 0.00055216197523501006,
         -0.00019671525768205839, 8.1693347751468875e-05, -3.6820947814600883e-05, 1.7466066078962379e-05,
         -8.5798890752563927e-06, 4.3233726948715226e-06, -2.2271081934949465e-06, 1.1617909052370851e-06
        },
        /* [86] 1.75 <= y <= 1.875 2^-30, degree 10, 66.8 bits */
        {
         0.97994544339548062, 3.4239875811687065e-18, -0.002186254206347367, 0.00048539223639907319,
         -0.0001610061657081732, 6.2253533259711957e-05, -2.6124193619166255e-05, 1.1537519213786538e-05,
         -5.2767670910942716e-06, 2.4755807083008106e-06, -1.1868819467574382e-06, 5.7644537339621284e-07
        },
        /* [87] 1.875 <= y <= 2 2^-30, degree 10, 70.1 bits */
        {
         0.97967944585121813, 2.3109952588748852e-17, -0.0020719968648950913, 0.00043038007030821949,
         -0.00013355182798561042, 4.8307475349318159e-05, -1.8964182442379929e-05, 7.8350796899680037e-06,
         -3.3522633338734709e-06, 1.4712479079529233e-06, -6.5967156463674388e-07, 2.9971845169391499e-07
        },
        /* [88] 1 <= y <= 1.125 2^-29, degree 10, 65.2 bits */
        {
         0.97930525226847087, -8.0304506841521897e-18, -0.0038470467666614251, 0.0014573100160986548,
         -0.00082466747709700509, 0.00054395825873325844, -0.00038940775558200157, 0.00029338068072059777,
         -0.00022889526706032184, 0.00018318931231785552, -0.00015049700763894721, 0.00012470257802170873
        },
        /* [89] 1.125 <= y <= 1.25 2^-29, degree 10, 66.3 bits */
        {
         0.97884565315142213, 3.3779463409229464e-17, -0.0035175529937278424, 0.0011923951722771851,
         -0.00060375768201244837, 0.00035633319722720274, -0.00022824357543366441, 0.00015386036365564219,
         -0.00010740747018944124, 7.6912541430800582e-05, -5.6458843051393426e-05, 4.1856639940937095e-05
        },
        /* [90] 1.25 <= y <= 1.375 2^-29, degree 10, 66.9 bits */
        {
         0.97842349155743447, 4.8518966516355518e-17, -0.0032452245358969376, 0.00099543636658907695,
         -0.00045604620929381464, 0.00024352716787456286, -0.00014113388418117263, 8.6079407098679745e-05,
         -5.4368462474368871e-05, 3.5224731625269781e-05, -2.3371664553894638e-05, 1.5676504818049051e-05
        },
        /* [91] 1.375 <= y <= 1.5 2^-29, degree 10, 66.9 bits */
        {
         0.97803255692061486, 2.8129778612259682e-17, -0.0030159979041239214, 0.00084477697876519096,
         -0.00035338335260975745, 0.00017230027695323, -9.1173382205214705e-05, 5.0772970001223307e-05,
         -2.9280379599939946e-05, 1.7320968381206641e-05, -1.0485417900225809e-05, 6.4214326561870028e-06
        },
        /* [92] 1.5 <= y <= 1.625 2^-29, degree 10, 66.7 bits */
        {
         0.97766810608482013, -1.5747491086843867e-17, -0.0028201251279606748, 0.00072679950000866954,
         -0.00027971935093648294, 0.00012547564151454586, -6.1085149719814361e-05, 3.1296278775246607e-05,
         -1.6604621315563847e-05, 9.0368150381135983e-06, -5.0300375887419014e-06, 2.8340133788822347e-06
        },
        /* [93] 1.625 <= y <= 1.75 2^-29, degree 10, 68.2 bits */
        {
         0.97732642924065793, -1.2406045739232436e-17, -0.0026506260668121258, 0.00063257987057527916,
         -0.00022543147530423667, 9.3634594701457382e-05, -4.2207993380703424e-05, 2.002315199442197e-05,
         -9.8366870786917524e-06, 4.9569488734758907e-06, -2.5536065076389614e-06, 1.3321667719091459e-06
        },
        /* [94] 1.75 <= y <= 1.875 2^-29, degree 10, 66.4 bits */
        {
         0.97700456639082611, -3.5453005223193978e-17, -0.0025023647814159397, 0.00055606444768771166,
         -0.00018450335147610284, 7.1350978553955002e-05, -2.9945366862654986e-05, 1.3226268090922775e-05,
         -6.0495500429967497e-06, 2.8382926368030512e-06, -1.3608453944993101e-06, 6.6096375293355378e-07
        },
        /* [95] 1.875 <= y <= 2 2^-29, degree 10, 66.0 bits */
        {
         0.97670011549557745, 2.385264607325796e-17, -0.0023714741185711257, 0.00049302481524271275,
         -0.00015303741734992487, 5.5365253743041501e-05, -2.1737448723377305e-05, 8.9816579520829557e-06,
         -3.8431017952208041e-06, 1.6867661795775036e-06, -7.5634204896795614e-07, 3.4365481082675039e-07
        },
        /* [96] 1 <= y <= 1.125 2^-28, degree 10, 64.7 bits */
        {
         0.97627185196361921, 4.0014064652657207e-17, -0.0044027871301848083, 0.0016693466072851821,
         -0.00094494605085344819, 0.00062340498619669693, -0.000446335815165988, 0.00033630088875398533,
         -0.00026240043432684194, 0.00021001658971474014, -0.00017254538830787573, 0.00014297816365228558
        },
        /* [97] 1.125 <= y <= 1.25 2^-28, degree 10, 65.4 bits */
        {
         0.97574588126184736, -5.3570329304916127e-17, -0.00402536402626951, 0.0013658017913248666,
         -0.00069177789578400489, 0.00040835563190747616, -0.00026159801212818717, 0.0001763611300562456,
         -0.00012312394925720758, 8.8172167922037544e-05, -6.4727494351315504e-05, 4.7988856281290809e-05
        },
        /* [98] 1.25 <= y <= 1.375 2^-28, degree 10, 65.7 bits */
        {
         0.97526279261458204, -1.515618779795806e-17, -0.0037134404125043754, 0.0011401344590204951,
         -0.00052250528112064221, 0.00027906737750330751, -0.00016175124550606452, 9.8663530968494663e-05,
         -6.2321372667615261e-05, 4.0379830082820996e-05, -2.6793491871204895e-05, 1.7972501075121726e-05
        },
        /* [99] 1.375 <= y <= 1.5 2^-28, degree 10, 67.9 bits */
        {
         0.97481547019011927, 4.2018143342387402e-17, -0.0034508999265565189, 0.0009675236164098577,
         -0.00040486233689437766, 0.00019743699612850984, -0.00010448797347021309, 5.8193248783099919e-05,
         -3.3562159966938067e-05, 1.9855128098924665e-05, -1.2020140273343764e-05, 7.3616588826006979e-06
        },
        /* [100] 1.5 <= y <= 1.625 2^-28, degree 10, 70.7 bits */
        {
         0.97439847972981264, -4.1503731028065524e-17, -0.0032265721876466274, 0.00083236271188411222,
         -0.00032045322419117393, 0.00014377526555498947, -7.0003056788762292e-05, 3.5868775823707838e-05,
         -1.9032092825550178e-05, 1.0358592417769566e-05, -5.7660740567863969e-06, 3.2488613879395681e-06
        },
        /* [101] 1.625 <= y <= 1.75 2^-28, degree 10, 66.3 bits */
        {
         0.9740075710819166, -6.9728478395120744e-18, -0.0030324588670365446, 0.000724424610755853,
         -0.00025824904363468956, 0.00010728633032529632, -4.8368234919450763e-05, 2.2947803472674036e-05,
         -1.1274356702313307e-05, 5.6817950245247591e-06, -2.9271776408005422e-06, 1.5271240435589226e-06
        },
        /* [102] 1.75 <= y <= 1.875 2^-28, degree 10, 67.5 bits */
        {
         0.97363935326476825, -3.7783884950339632e-17, -0.0028626750860438477, 0.00063677199328403332,
         -0.00021135450077190015, 8.1750845978278744e-05, -3.4314703971992533e-05, 1.5157643896830737e-05,
         -6.9334945420005706e-06, 3.253230873403433e-06, -1.5598786392665111e-06, 7.5767084814616992e-07
        },
        /* [103] 1.875 <= y <= 2 2^-28, degree 10, 70.3 bits */
        {
         0.97329107460584807, 1.7890541592840189e-17, -0.0027127899375977587, 0.00056455937637671903,
         -0.00017530280015403156, 6.3432923836908854e-05, -2.4908356762249005e-05, 1.0292890692610593e-05,
         -4.4045132952375542e-06, 1.9333029472730499e-06, -8.6693771112138576e-07, 3.9392474996754492e-07
        },
        /* [104] 1 <= y <= 1.125 2^-27, degree 10, 65.5 bits */
        {
         0.97280119176510305, 2.1970431986868693e-17, -0.0050360748649785399, 0.0019114461500224778,
         -0.0010823698947798163, 0.0007142113704573102, -0.00051142080015885135, 0.00038538058019498776,
         -0.00030071992059949504, 0.00024070259807203542, -0.00019776790009106302, 0.00016388670558684142
        },
        /* [105] 1.125 <= y <= 1.25 2^-27, degree 10, 65.6 bits */
        {
         0.97219959484979501, -4.3976876119863641e-17, -0.0046039305741180109, 0.0015637673740537597,
         -0.00079233288957728627, 0.000467809785602149, -0.00029972757004638755, 0.00020208835714060475,
         -0.00014109693971484905, 0.00010105010335893217, -7.4185634519087631e-05, 5.5003898336942867e-05
        },
        /* [106] 1.25 <= y <= 1.375 2^-27, degree 10, 68.4 bits */
        {
         0.97164709564163376, -7.1942441820527064e-18, -0.0042468068638876928, 0.0013053049563659463,
         -0.00059842020334141001, 0.00031968052233217553, -0.00018531794231318736, 0.0001130507846853126,
         -7.1415307173960401e-05, 4.6275335500663621e-05, -3.0707231122910126e-05, 2.0598820660482341e-05
        },
        /* [107] 1.375 <= y <= 1.5 2^-27, degree 10, 66.1 bits */
        {
         0.97113554417542802, -2.751867329982825e-18, -0.0039462413312022354, 0.0011076206420208624,
         -0.00046365972763663476, 0.00022615892687654496, -0.00011970585035882779, 6.6676012707766273e-05,
         -3.8457847342105452e-05, 2.2753023356174403e-05, -1.3775350341884414e-05, 8.4370712520324765e-06
        },
        /* [108] 1.5 <= y <= 1.625 2^-27, degree 10, 67.2 bits */
        {
         0.9706587167948747, -6.2967092998922663e-18, -0.0036894382173054759, 0.00095283438225328464,
         -0.00036697347078709522, 0.00016468306877811501, -8.0194892493059015e-05, 4.1095569677540071e-05,
         -2.1807389592814721e-05, 1.1869973622107727e-05, -6.607791674503471e-06, 3.7233220618304272e-06
        },
        /* [109] 1.625 <= y <= 1.75 2^-27, degree 10, 66.4 bits */
        {
         0.97021174621537776, -2.1739363387534438e-17, -0.0034672358263613651, 0.0008292297465922944,
         -0.00029572506737514349, 0.00012288249136069854, -5.5407911965079543e-05, 2.6290700669435213e-05,
         -1.2917905075467191e-05, 6.5105584673018734e-06, -3.3543569450108086e-06, 1.7500810631959062e-06
        },
        /* [110] 1.75 <= y <= 1.875 2^-27, degree 10, 68.5 bits */
        {
         0.96979074926803976, 2.1913698868192849e-17, -0.0032728936272064949, 0.00072885953713610783,
         -0.0002420145641421507, 9.3631034799313454e-05, -3.9307433676152581e-05, 1.7365061755128606e-05,
         -7.9439526951016259e-06, 3.7276247051564574e-06, -1.7874586263893604e-06, 8.6825993002403777e-07
        },
        /* [111] 1.875 <= y <= 2 2^-27, degree 10, 74.0 bits */
        {
         0.96939257503244691, 3.3858064927167024e-17, -0.0031013366850297904, 0.00064617313319644107,
         -0.00020072454637228785, 7.2648260591967601e-05, -2.8531415700446398e-05, 1.1791429811192887e-05,
         -5.0462342093824336e-06, 2.2151475143947597e-06, -9.9338793996325081e-07, 4.514072926280247e-07
        },
        /* [112] 1 <= y <= 1.125 2^-26, degree 10, 64.6 bits */
        {
         0.96883255194567974, 6.1663662401222917e-18, -0.0057568754459214177, 0.0021876222640231464,
         -0.0012392573094271771, 0.00081792450894029858, -0.00058577907118525813, 0.00044146582930840406,
         -0.00034451693724517883, 0.00027578016904661497, -0.00022660372823677017, 0.00018779313686416031
        },
        /* [113] 1.125 <= y <= 1.25 2^-26, degree 10, 66.1 bits */
        {
         0.9681448870351208, -3.0067840090386797e-17, -0.005262312514574847, 0.0017895621376004197,
         -0.00090711367502184276, 0.00053570566945715088, -0.00034328447928278329, 0.00023148439799341132,
         -0.00016163672933104209, 0.00011576941856470042, -8.4997564113819526e-05, 6.3023923316446977e-05
        },
        /* [114] 1.25 <= y <= 1.375 2^-26, degree 10, 65.3 bits */
        {
         0.96751340929640028, -4.8100076086866492e-17, -0.0048536383112185088, 0.0014936673384803945,
         -0.00068506392993666172, 0.00036605470360700414, -0.00021223608623063977, 0.00012948794982282704,
         -8.1806902935669832e-05, 5.3013141691415364e-05, -3.518072151359896e-05, 2.3601100401041122e-05
        },
        /* [115] 1.375 <= y <= 1.5 2^-26, degree 10, 66.8 bits */
        {
         0.96692878839393392, -3.2374995455581499e-17, -0.0045097114126947911, 0.0012673676466507522,
         -0.00053075880186811096, 0.00025895149618664754, -0.00013708606607575578, 7.6366441377394127e-05,
         -4.4051586278104618e-05, 2.6064635658616394e-05, -1.5781410896019395e-05, 9.6663201759714851e-06
        },
        /* [116] 1.5 <= y <= 1.625 2^-26, degree 10, 65.5 bits */
        {
         0.96638389975734051, 3.4235014281211194e-17, -0.0042158802042353803, 0.0010901863050317958,
         -0.00042005610257276927, 0.0001885515954163467, -9.183377421799512e-05, 4.706592928235856e-05,
         -2.4978116641366332e-05, 1.3596975800241325e-05, -7.5697236183496963e-06, 4.2656086601153319e-06
        },
        /* [117] 1.625 <= y <= 1.75 2^-26, degree 10, 65.3 bits */
        {
         0.96587317186970156, -2.032973182347307e-17, -0.0039616548010678833, 0.00094870603633427197,
         -0.00033848321531643096, 0.00014068548664046779, -6.3446355042395632e-05, 3.0108825820907402e-05,
         -1.4795471251479665e-05, 7.4574797353868044e-06, -3.8425070956768582e-06, 2.0048907239198617e-06
        },
        /* [118] 1.75 <= y <= 1.875 2^-26, degree 10, 67.2 bits */
        {
         0.96539215997038808, 3.6610362178267253e-17, -0.0037393178919624538, 0.00083382642389703691,
         -0.00027699264374824638, 0.00010719102183241689, -4.5008024952875168e-05, 1.9886079457378444e-05,
         -9.0981938045412172e-06, 4.269611596204715e-06, -2.0475012791435632e-06, 9.946389653756559e-07
        },
        /* [119] 1.875 <= y <= 2 2^-26, degree 10, 67.3 bits */
        {
         0.9649372576384172, -2.9219226649299247e-17, -0.0035430594141802833, 0.00073919169549139553,
         -0.00022972388574468467, 8.3165695234794059e-05, -3.2667809669332147e-05, 1.3502727458859617e-05,
         -5.7792134871022064e-06, 2.5371266126790907e-06, -1.1378650989702637e-06, 5.1709264232518249e-07
        },
        /* [120] 1 <= y <= 1.125 2^-25, degree 10, 64.8 bits */
        {
         0.96429750267542014, 3.3002824874349517e-17, -0.0065761661731295849, 0.0025023454858716303,
         -0.0014182001260414669, 0.00093627767039805142, -0.00067066310787761531, 0.0005055068795305213,
         -0.00039453697340428905, 0.00031584864769969539, -0.00025954717002915558, 0.00021510838880576288
        },
        /* [121] 1.125 <= y <= 1.25 2^-25, degree 10, 65.0 bits */
        {
         0.96351202100358535, -4.5319972925603599e-17, -0.0060104788373053506, 0.0020468257719724841,
         -0.0010380095129178485, 0.00061317413929233751, -0.00039300007468470423, 0.00026504579563677364,
         -0.00018509191618073677, 0.00013258090250576891, -9.7348109658782357e-05, 7.2186419469245772e-05
        },
        /* [122] 1.25 <= y <= 1.375 2^-25, degree 10, 65.1 bits */
        {
         0.96279080407663864, 2.1600955710727714e-17, -0.0055430743562134939, 0.0017082461753686173,
         -0.00078385777080442159, 0.00041895991448787735, -0.00024295631830756532, 0.00014825189930824594,
         -9.3672050820311427e-05, 6.0707749694881336e-05, -4.0290242506813935e-05, 2.7030681822337508e-05
        },
        /* [123] 1.375 <= y <= 1.5 2^-25, degree 10, 65.3 bits */
        {
         0.96212317555130278, -5.4407352930653073e-17, -0.0051497547422788463, 0.0014493205066342023,
         -0.00060725679923962731, 0.00029635761569712075, -0.00015691879429547754, 8.742734018543073e-05,
         -5.0437821727771553e-05, 2.9846106157704851e-05, -1.8072447847992461e-05, 1.1070378739097438e-05
        },
        /* [124] 1.5 <= y <= 1.625 2^-25, degree 10, 65.5 bits */
        {
         0.96150098366826242, 1.0990566258147755e-17, -0.0048137512689387495, 0.0012466086633449063,
         -0.00048056660432888319, 0.00021577494347273344, -0.00010511352636760072, 5.3879917329773764e-05,
         -2.8597683881568387e-05, 1.5568810481489522e-05, -8.6681978060443466e-06, 4.8849537325076244e-06
        },
        /* [125] 1.625 <= y <= 1.75 2^-25, degree 10, 67.9 bits */
        {
         0.96091785407774699, 1.0818044978875425e-17, -0.0045230590761885341, 0.0010847526024442666,
         -0.0003872187108008754, 0.00016098851828935247, -7.261710986817444e-05, 3.4466024561042095e-05,
         -1.6938612961154726e-05, 8.5385416709724381e-06, -4.3998969191828265e-06, 2.2958825015175522e-06
        },
        /* [126] 1.75 <= y <= 1.875 2^-25, degree 10, 65.0 bits */
        {
         0.96036870187770995, 8.3976784103002197e-18, -0.0042688468347961374, 0.00095333616182192527,
         -0.00031685597917884158, 0.00012265359424514581, -5.1510970157472878e-05, 2.2762762071953251e-05,
         -1.0415577980029767e-05, 4.8883213031655112e-06, -2.3444029178462577e-06, 1.1389511910259691e-06
        },
        /* [127] 1.875 <= y <= 2 2^-25, degree 10, 66.6 bits */
        {
         0.95984940149643116, -4.5586118768483881e-17, -0.0040444661594299632, 0.00084508503995885543,
         -0.00026276993666082149, 9.5157633486224032e-05, -3.7385956358367372e-05, 1.5455279681188555e-05,
         -6.6157212987447766e-06, 2.904653687272829e-06, -1.3028072374091304e-06, 5.9209274199012523e-07
        },
        /* [128] 1 <= y <= 1.125 2^-24, degree 10, 64.6 bits */
        {
         0.9591191515554629, -1.4775443201101625e-17, -0.0075059512689851175, 0.0028605695315987384,
         -0.0016220829753393882, 0.0010712047217127157, -0.00076747269251331302, 0.00057856705842289368,
         -0.00045161505667225081, 0.00036157990588284308, -0.00029715271813081758, 0.00024629370472139221
        },
        /* [129] 1.125 <= y <= 1.25 2^-24, degree 10, 65.7 bits */
        {
         0.95822267602940991, -1.682506608486805e-17, -0.0068593169784310114, 0.0023395876394747043,
         -0.0011871214209834872, 0.00070147601202497653, -0.00044969114577752341, 0.00030332782473801832,
         -0.00021185272499715704, 0.00015176552367111282, -0.00011144448502324921, 8.2645620806436103e-05
        },
        /* [130] 1.25 <= y <= 1.375 2^-24, degree 10, 65.9 bits */
        {
         0.95739965746712863, -8.4230855372756995e-19, -0.0063250846343236196, 0.001952387006590063,
         -0.00089638118071493154, 0.0004792540614528326, -0.00027798161937815543, 0.00016965206990042655,
         -0.00010720753229921385, 6.9487368480638872e-05, -4.6121267070987851e-05, 3.0945129624572268e-05
        },
        /* [131] 1.375 <= y <= 1.5 2^-24, degree 10, 66.9 bits */
        {
         0.95663788631225943, 2.314542764268584e-17, -0.0058755724672015439, 0.0016563040903318023,
         -0.00069437221138048783, 0.00033898180551703868, -0.00017952772145985132, 0.0001000405614114101,
         -5.7722159590203229e-05, 3.4160264832222726e-05, -2.0686681005933209e-05, 1.2672750775534923e-05
        },
        /* [132] 1.5 <= y <= 1.625 2^-24, degree 10, 65.9 bits */
        {
         0.95592804094601769, 1.6817025403800475e-18, -0.0054915990999803883, 0.0014245203473494071,
         -0.00054946548604548225, 0.00024679167552342848, -0.00012025024007509477, 6.1649244861763073e-05,
         -3.2725783101980271e-05, 1.7818153811528602e-05, -9.9214923811179155e-06, 5.5916991851341811e-06
        },
        /* [133] 1.625 <= y <= 1.75 2^-24, degree 10, 65.3 bits */
        {
         0.95526283281685931, 3.9690256312921574e-17, -0.0051594334601911601, 0.00123946541259053,
         -0.0004427026425790516, 0.0001841176894853049, -8.3068987223533457e-05, 3.9433539918738746e-05,
         -1.9382583083950235e-05, 9.7716146551533046e-06, -5.0357788120504306e-06, 2.6279040153168756e-06
        },
        /* [134] 1.75 <= y <= 1.875 2^-24, degree 10, 65.8 bits */
        {
         0.95463644818508386, -2.6300392531627899e-17, -0.0048689750388490275, 0.0010892234660795162,
         -0.00036223334974607948, 0.00014026640961954529, -5.8921511321519631e-05, 2.60420267477867e-05,
         -1.1917722641802557e-05, 5.5939574170019687e-06, -2.6830807582531985e-06, 1.303595372676701e-06
        },
        /* [135] 1.875 <= y <= 2 2^-24, degree 10, 64.9 bits */
        {
         0.95404417047543533, -1.3013567529098541e-17, -0.0046126204847528034, 0.00096547341088878676,
         -0.00030038242973554698, 0.00010881563237119628, -4.2762021529767791e-05, 1.7680855486997465e-05,
         -7.5694526959928227e-06, 3.3237764501560084e-06, -1.4909402006936028e-06, 6.7765162959285897e-07
        },
        /* [136] 1 <= y <= 1.125 2^-23, degree 10, 63.5 bits */
        {
         0.95321139179264769, -3.1653026946875987e-17, -0.0085592430678989983, 0.0032677496438238795,
         -0.0018540992522399638, 0.0012248528460908471, -0.00087776510861985462, 0.0006618310879247251,
         -0.00051668262834872068, 0.00041372410476212776, -0.00034003997872455235, 0.00028186484587083979
        },
        /* [137] 1.125 <= y <= 1.25 2^-23, degree 10, 64.0 bits */
        {
         0.95218919825950532, -1.2295976321020897e-17, -0.0078206100835845494, 0.0026722801547845194,
         -0.0013567730986598558, 0.00080200997002068803, -0.00051426565180883192, 0.00034694867844523107,
         -0.00024235411691383218, 0.00017363676805361495, -0.00012751807776380841, 9.4573876125585198e-05
        },
        /* [138] 1.25 <= y <= 1.375 2^-23, degree 10, 65.1 bits */
        {
         0.95125090775551502, 4.5479558858470495e-17, -0.0072104431894025444, 0.0022297662675057244,
         -0.0010243794844450253, 0.00054788809952635901, -0.00031787069540832971, 0.0001940327168640273,
         -0.00012263253964696756, 7.9494951580217558e-05, -5.2769178925487059e-05, 3.5408729785485898e-05
        },
        /* [139] 1.375 <= y <= 1.5 2^-23, degree 10, 64.9 bits */
        {
         0.95038256646076535, -2.9626547925262563e-18, -0.0066970945295725306, 0.0018914197101414394,
         -0.00079345039172772297, 0.00038749365345169839, -0.0002052721452334379, 0.00011440828638904477,
         -6.6022158629405346e-05, 3.9077124743581586e-05, -2.3666736658020994e-05, 1.4499669370730993e-05
        },
        /* [140] 1.5 <= y <= 1.625 2^-23, degree 10, 67.6 bits */
        {
         0.94957352211539447, -4.0226444592574039e-17, -0.0062586365481264571, 0.001626574590111817,
         -0.00062781244694925533, 0.00028208722017159324, -0.00013748362407513777, 7.0498034266756033e-05,
         -3.7428822942843619e-05, 2.038139691150939e-05, -1.1349981564741856e-05, 6.3973816182233143e-06
        },
        /* [141] 1.625 <= y <= 1.75 2^-23, degree 10, 65.7 bits */
        {
         0.94881544650416394, -3.722412003194893e-17, -0.0058793736480958802, 0.0014151415553069978,
         -0.00050578511271050252, 0.00021043371449151217, -9.4966960818019004e-05, 4.5090484140729951e-05,
         -2.216657951424337e-05, 1.1176590088228991e-05, -5.7604608404138488e-06, 3.0063601457023338e-06
        },
        /* [142] 1.75 <= y <= 1.875 2^-23, degree 10, 65.7 bits */
        {
         0.94810169716272497, -3.923584221191911e-17, -0.0055477611453356177, 0.0012434974983092861,
         -0.00041381749115894866, 0.0001603032403547992, -6.7356253483031071e-05, 2.9775944242742249e-05,
         -1.3628651674185413e-05, 6.3978717223540046e-06, -3.0690103604767462e-06, 1.4912447488496438e-06
        },
        /* [143] 1.875 <= y <= 2 2^-23, degree 10, 65.3 bits */
        {
         0.94742688561911259, -9.0407532317948712e-19, -0.0052551092074995592, 0.0011021297591680688,
         -0.00034313358749378422, 0.00012435132290559693, -4.8880348029506269e-05, 2.0214695119482252e-05,
         -8.6556196600410789e-06, 3.8012199106358669e-06, -1.7052979335796615e-06, 7.7515505984235609e-07
        },
        /* [144] 1 <= y <= 1.125 2^-22, degree 10, 64.4 bits */
        {
         0.94647818070417278, 5.1731936361914853e-17, -0.0097499959872656521, 0.0037298487969794816,
         -0.0021177616426137501, 0.0013995922553426781, -0.0010032634834696973, 0.00075661216759871826,
         -0.00059077356939972784, 0.00047311484986967801, -0.00038889814196111115, 0.00032239596312974312
        },
        /* [145] 1.125 <= y <= 1.25 2^-22, degree 10, 65.6 bits */
        {
         0.94531388755029733, 1.8234075501332592e-17, -0.0089069698541526382, 0.0030497418127935975,
         -0.0015495176684590995, 0.00091631838117418451, -0.00058772727718479965, 0.00039659296455424298,
         -0.00027707846842365999, 0.00019854269939518891, -0.00014582605108589698, 0.00010816289382794086
        },
        /* [146] 1.25 <= y <= 1.375 2^-22, degree 10, 65.6 bits */
        {
         0.94424534929879089, 2.864582317665131e-17, -0.0082106608385053848, 0.0025443922570554866,
         -0.0011697683031224842, 0.00062590967143740493, -0.00036324060543683941, 0.00022177475819205598,
         -0.00014018996319975391, 9.0889097047592418e-05, -6.0339907262366193e-05, 4.0492937046133427e-05
        },
        /* [147] 1.375 <= y <= 1.5 2^-22, degree 10, 65.1 bits */
        {
         0.94325663062819187, 1.7992888877650441e-17, -0.0076249119711738547, 0.0021580447262557357,
         -0.00090596651050856459, 0.00044263016920471248, -0.00023454855971624504, 0.00013075405253851042,
         -7.5467989572099313e-05, 4.4674304802203076e-05, -2.7059920575991457e-05, 1.6580273085653968e-05
        },
        /* [148] 1.5 <= y <= 1.625 2^-22, degree 10, 66.0 bits */
        {
         0.94233556798623153, -4.4956104556894192e-17, -0.0071246741521007479, 0.0018556576563722781,
         -0.00071676836594356289, 0.00032219543745066938, -0.00015707799685964273, 8.0563417573022785e-05,
         -4.2780284678374915e-05, 2.3298856869422147e-05, -1.2976261383865387e-05, 7.31480720064299e-06
        },
        /* [149] 1.625 <= y <= 1.75 2^-22, degree 10, 65.3 bits */
        {
         0.94147265258546486, -1.8325692522253445e-17, -0.0066920191572228914, 0.0016142773117042621,
         -0.00057739657867147943, 0.00024033298304366177, -0.00010849280773961606, 5.1524200706993854e-05,
         -2.5333945978559442e-05, 1.2775491217605802e-05, -6.5853680857937392e-06, 3.4372469567551078e-06
        },
        /* [150] 1.75 <= y <= 1.875 2^-22, degree 10, 66.8 bits */
        {
         0.94066030109540621, -4.0318733829302536e-17, -0.006313761326679726, 0.0014183395235274434,
         -0.00047236599291087899, 0.00018306471057609615, -7.6943589047310439e-05, 3.4021965178407695e-05,
         -1.5574913184185896e-05, 7.3126250189205046e-06, -3.5082570788548984e-06, 1.7048632688235108e-06
        },
        /* [151] 1.875 <= y <= 2 2^-22, degree 10, 66.2 bits */
        {
         0.93989236236296536, -4.679179271332705e-18, -0.0059799764940950493, 0.0012569771242221528,
         -0.0003916487116834952, 0.00014199692768872816, -5.583374329800298e-05, 2.309565546096604e-05,
         -9.8910224706051231e-06, 4.3444210431368836e-06, -1.949239308874948e-06, 8.8613865606880524e-07
        },
        /* [152] 1 <= y <= 1.125 2^-21, degree 10, 63.4 bits */
        {
         0.93881288919640171, -3.0814544594029797e-17, -0.011092976782181156, 0.0042533262740782358,
         -0.0024169043930321581, 0.0015980211632852074, -0.001145862101096403, 0.00086435698687596348,
         -0.00067502874436480757, 0.00054067324971449342, -0.000444489615563857, 0.00036852282095762662
        },
        /* [153] 1.125 <= y <= 1.25 2^-21, degree 10, 63.7 bits */
        {
         0.93748836298284155, 1.081770850300654e-17, -0.010131709731017513, 0.0034772052925282327,
         -0.0017681381262686872, 0.0010460898734747654, -0.0006711781228977441, 0.00045301405720511685,
         -0.00031655751487429313, 0.00022686753087924023, -0.00016665261139829282, 0.0001236247543596115
        },
        /* [154] 1.25 <= y <= 1.375 2^-21, degree 10, 64.9 bits */
        {
         0.93627301370424298, -1.36529525747826e-17, -0.0093378613335457755, 0.0029005932691282721,
         -0.001334633060194227, 0.00071446444107633317, -0.00041476818726179422, 0.000253296948845481,
         -0.00016014728789773541, 0.0001038447119105612, -6.8950415326777265e-05, 4.6276730259259661e-05
        },
        /* [155] 1.375 <= y <= 1.5 2^-21, degree 10, 65.4 bits */
        {
         0.93514865876986308, 4.925768595790657e-17, -0.0086701560302460921, 0.0024598209642493771,
         -0.0010335245775381253, 0.00050519645043976716, -0.00026779143458070386, 0.00014932336914746702,
         -8.6202874671438453e-05, 5.1037331417672277e-05, -3.0918422277799585e-05, 1.8946742518556529e-05
        },
        /* [156] 1.5 <= y <= 1.625 2^-21, degree 10, 63.9 bits */
        {
         0.93410142106393679, 3.5543701520774564e-17, -0.0081000020808130423, 0.0021148776758109361,
         -0.00081759409236017598, 0.00036769891667012388, -0.00017932272056869685, 9.19958720934107e-05,
         -4.8860948725334475e-05, 2.6614921979459829e-05, -1.4825241013802775e-05, 8.3581082555769409e-06
        },
        /* [157] 1.625 <= y <= 1.75 2^-21, degree 10, 69.9 bits */
        {
         0.93312045353092743, -1.1215303896123707e-17, -0.0076069380025675301, 0.0018395574627507506,
         -0.00065854655158168189, 0.00027424765236900266, -0.00012384535146986943, 5.8830452858426117e-05,
         -2.8932293636905291e-05, 1.4592546590853516e-05, -7.5230858684306036e-06, 3.927176678743809e-06
        },
        /* [158] 1.75 <= y <= 1.875 2^-21, degree 10, 66.0 bits */
        {
         0.93219710652920307, 4.8387390333528015e-17, -0.00717591657359486, 0.0016160927100731253,
         -0.00053869998202975733, 0.00020887827325034977, -8.7823832429177796e-05, 3.884302833435163e-05,
         -1.7785647027926239e-05, 8.3520258418219691e-06, -4.0074975221932102e-06, 1.9477172355066286e-06
        },
        /* [159] 1.875 <= y <= 2 2^-21, degree 10, 65.6 bits */
        {
         0.931324364713361, 2.4652170701955425e-17, -0.0067956136357577223, 0.0014320789231369766,
         -0.00044660489579252698, 0.00016200517522087406, -6.3723551292636053e-05, 2.6366273188499418e-05,
         -1.1294088260120396e-05, 4.9615499293592902e-06, -2.226459230637249e-06, 1.0122935951204144e-06
        },
        /* [160] 1 <= y <= 1.125 2^-20, degree 10, 63.6 bits */
        {
         0.93009777627792911, -2.553924830173792e-17, -0.012603551113715149, 0.00484510163280361,
         -0.0027556736721010985, 0.0018229637513537398, -0.0013076271374953059, 0.00098664754563227417,
         -0.00077069821861591151, 0.00061741022234269524, -0.00050765229770166284, 0.00042094495022908972
        },
        /* [161] 1.125 <= y <= 1.25 2^-20, degree 10, 63.7 bits */
        {
         0.92859306351013848, 2.507936299731599e-17, -0.01150864003600301, 0.0039602648381152688,
         -0.0020156387792598512, 0.0011931571484388578, -0.0007658186073889379, 0.00051703470348504429,
         -0.00036137315315822282, 0.00025903242655181337, -0.00019030974017730966, 0.00014119254463798803
        },
        /* [162] 1.25 <= y <= 1.375 2^-20, degree 10, 65.1 bits */
        {
         0.92721269559060793, -2.4245544979311938e-17, -0.010604584273021586, 0.0033029879830395173,
         -0.0015212214791236888, 0.00081479406752272936, -0.00047318969738613641, 0.00028905604249790303,
         -0.00018279688982330672, 0.00011855330942614297, -7.872895776261639e-05, 5.2846819868937818e-05
        },
        /* [163] 1.375 <= y <= 1.5 2^-20, degree 10, 66.6 bits */
        {
         0.92593594611376706, 4.5499142927142795e-17, -0.0098443081192899386, 0.0028006277364476281,
         -0.0011778508924236895, 0.00057606390371963247, -0.00030547280502412391, 0.00017038371640455639,
         -9.8383193013829484e-05, 5.8259753087629216e-05, -3.5299411650915695e-05, 2.16343739335784e-05
        },
        /* [164] 1.5 <= y <= 1.625 2^-20, degree 10, 65.2 bits */
        {
         0.92474699884180345, -4.2036392309727456e-17, -0.0091952065621978621, 0.0024075399617513597,
         -0.00093164472239298031, 0.00041922744784890677, -0.000204531816163295, 0.00010495916479916484,
         -5.5758925776468368e-05, 3.037809625477167e-05, -1.6924180757310557e-05, 9.5427711081919471e-06
        },
        /* [165] 1.625 <= y <= 1.75 2^-20, degree 10, 66.3 bits */
        {
         0.92363349269896078, -2.5268320885158067e-17, -0.0086339490391540326, 0.0020938326183070621,
         -0.00075031857916552796, 0.00031264434460610049, -0.00014124012510221604, 6.7113355193916413e-05,
         -3.3013503739874972e-05, 1.6654206661354974e-05, -8.5873750648034924e-06, 4.483388761046433e-06
        },
        /* [166] 1.75 <= y <= 1.875 2^-20, degree 10, 64.7 bits */
        {
         0.92258557199783953, 3.1235828606294666e-17, -0.0081433804797835414, 0.0018392412242424615,
         -0.00061369970737782146, 0.00023809710211387036, -0.0001001489340247668, 4.4307495159973409e-05,
         -2.02925773475542e-05, 9.5311357782404312e-06, -4.5740257371271357e-06, 2.2233798419373176e-06
        },
        /* [167] 1.875 <= y <= 2 2^-20, degree 10, 65.7 bits */
        {
         0.92159524418250627, 2.2995483331720499e-17, -0.007710591860873966, 0.0016296196026507079,
         -0.00050872712117977601, 0.0001846483558303857, -7.2659412704431973e-05, 3.0072707328432221e-05,
         -1.2884860833565687e-05, 5.6615105730349342e-06, -2.5409910351358612e-06, 1.1554685022180446e-06
        },
        /* [168] 1 <= y <= 1.125 2^-19, degree 10, 63.5 bits */
        {
         0.92020365868665199, 5.035739003869753e-17, -0.014297362908168286, 0.0055124853597840551,
         -0.0031385013865936778, 0.0020774582133112544, -0.0014907908144867746, 0.0011251983241342778,
         -0.00087914004391217873, 0.00070442618839361426, -0.0005792997981572518, 0.0004804261695862553
        },
        /* [169] 1.125 <= y <= 1.25 2^-19, degree 10, 63.6 bits */
        {
         0.91849695662915987, 2.8453584194487376e-17, -0.013051763526946021, 0.0045048157157594072,
         -0.0022952242269480326, 0.0013594880936317478, -0.00087294338164663698, 0.00058954510544243042,
         -0.00041215657490933211, 0.00029549516346219186, -0.00021713712550279409, 0.00016112042235295402
        },
        /* [170] 1.25 <= y <= 1.375 2^-19, degree 10, 65.6 bits */
        {
         0.91693169840873034, 3.2091492544836478e-17, -0.012023494872355517, 0.0037564320426898327,
         -0.0017319264379915297, 0.00092822947488539916, -0.00053929791468447378, 0.00032954549751662625,
         -0.00020845546052557736, 0.00013522276713504166, -8.9814995163368084e-05, 6.0297634216323178e-05
        },
        /* [171] 1.375 <= y <= 1.5 2^-19, degree 10, 66.8 bits */
        {
         0.91548428445714836, -4.5575238859583445e-18, -0.011158922196192803, 0.003184534271831913,
         -0.0013407798577088526, 0.0006561650568027615, -0.00034810018101369996, 0.00019422366241765004,
         -0.00011217810273541583, 6.6442982009896548e-05, -4.0264977069832824e-05, 2.4681559426304044e-05
        },
        /* [172] 1.5 <= y <= 1.625 2^-19, degree 10, 64.1 bits */
        {
         0.9141367090844309, -4.9319656496058104e-19, -0.010420903519984712, 0.0027371043126175575,
         -0.0010603577109286597, 0.00047745395712571725, -0.00023304242651458806, 0.00011962973977863366,
         -6.3569407003802379e-05, 3.4640897753863735e-05, -1.9302651901389498e-05, 1.0885621518824686e-05
        },
        /* [173] 1.625 <= y <= 1.75 2^-19, degree 10, 63.9 bits */
        {
         0.91287490227015011, -3.9112512609382405e-17, -0.0097828657461679347, 0.0023800806235156628,
         -0.00085386017169000045, 0.00035602091470151502, -0.00016090822186426518, 7.64849411097137e-05,
         -3.7633560032204195e-05, 1.8989078290794045e-05, -9.7931467834351203e-06, 5.1137404791784985e-06
        },
        /* [174] 1.75 <= y <= 1.875 2^-19, degree 10, 64.0 bits */
        {
         0.91168764739949837, 1.3408453135674097e-17, -0.0092252722261732169, 0.0020903751324093667,
         -0.00069829591760441133, 0.00027109748703888582, -0.0001140816066142866, 5.0488838916022996e-05,
         -2.3129898208616874e-05, 1.0866226750170385e-05, -5.2157372454959617e-06, 2.5357253281468367e-06
        },
        /* [175] 1.875 <= y <= 2 2^-19, degree 10, 68.6 bits */
        {
         0.9105658495100537, -1.8571324295822651e-17, -0.0087334237088816692, 0.0018518725463509019,
         -0.00057878081207900971, 0.00021021619732568061, -8.2758591202730525e-05, 3.4264512119439706e-05,
         -1.4684921273584864e-05, 6.4539125995675652e-06, -2.8971963294906206e-06, 1.3176658345047349e-06
        },
        /* [176] 1 <= y <= 1.125 2^-18, degree 10, 63.7 bits */
        {
         0.90898986427210759, -1.8089074662944929e-18, -0.016189879708298188, 0.0062630656204295818,
         -0.0035700566873820114, 0.002364731213709064, -0.0016977364305158264, 0.001281846939808714,
         -0.0010018141943217642, 0.00080290704056408795, -0.00066041871406101178, 0.00054779274818698726
        },
        /* [177] 1.125 <= y <= 1.25 2^-18, degree 10, 63.7 bits */
        {
         0.90705754691365259, -4.4583048985650676e-17, -0.014774846971137092, 0.005116957015985202,
         -0.0026102616182222273, 0.0015471677618516253, -0.00099393174722807605, 0.0006714974855746642,
         -0.00046958505397461521, 0.0003367481805003749, -0.0002475009520441171, 0.00018368286162927355
        },
        /* [178] 1.25 <= y <= 1.375 2^-18, degree 10, 65.7 bits */
        {
         0.90528589507856216, 1.7578002285335885e-17, -0.013606978197580482, 0.0042659334920849921,
         -0.0019692559275706818, 0.0010561777368703301, -0.00061393576157182039, 0.00037529216474352833,
         -0.00023746221195188172, 0.00015407632538723249, -0.00010235862238971126, 6.8730990110802415e-05
        },
        /* [179] 1.375 <= y <= 1.5 2^-18, degree 10, 64.9 bits */
        {
         0.90364807225863286, 2.7852339530330363e-18, -0.012625238826058713, 0.0036157253012191587,
         -0.0015242296135629912, 0.0007464837612295767, -0.0003962121578455062, 0.00022115076253253631,
         -0.000127768490822182, 7.5695752950577673e-05, -4.5881839774733391e-05, 2.8129634344865594e-05
        },
        /* [180] 1.5 <= y <= 1.625 2^-18, degree 10, 66.7 bits */
        {
         0.90212360704471328, 1.248656278354964e-17, -0.01178737016865183, 0.0031071188942553367,
         -0.0012052327930183189, 0.00054308702392707195, -0.00026521170934163058, 0.00013619533968294692,
         -7.2394024763731184e-05, 3.9459552779284954e-05, -2.199238677554722e-05, 1.2404750146271328e-05
        },
        /* [181] 1.625 <= y <= 1.75 2^-18, degree 10, 68.6 bits */
        {
         0.90069650551926517, 3.0264344171144079e-17, -0.011063143465051729, 0.0027013473250707088,
         -0.00097036602823939808, 0.00040490062538984568, -0.00018309404156049614, 8.7064231036164841e-05,
         -4.2852145938723721e-05, 2.1627745029902031e-05, -1.1156380140586867e-05, 5.8266687497001952e-06
        },
        /* [182] 1.75 <= y <= 1.875 2^-18, degree 10, 66.0 bits */
        {
         0.89935401946994553, -7.9473530987903496e-18, -0.010430337884093642, 0.0023721369521895515,
         -0.00079345568105021491, 0.00030827422385722695, -0.00012979365585083242, 5.7464998480224402e-05,
         -2.6334012021017607e-05, 1.2374671696242491e-05, -5.941082184776085e-06, 2.8889085744675325e-06
        },
        /* [183] 1.875 <= y <= 2 2^-18, degree 10, 64.4 bits */
        {
         0.89808581366480889, -3.1870712810015897e-17, -0.0098722370650553646, 0.00210115154156831,
         -0.00065755972290985757, 0.00023901216298961763, -9.4144713399148497e-05, 3.8994178616504128e-05,
         -1.6717213506266136e-05, 7.3490027098912149e-06, -3.2997373598866394e-06, 1.501030557358374e-06
        },
        /* [184] 1 <= y <= 1.125 2^-17, degree 10, 62.7 bits */
        {
         0.89630457848495815, 7.0583414602623377e-18, -0.018295774768525307, 0.0071045385578240305,
         -0.0040551681655965855, 0.0026881542490603196, -0.0019309711114425224, 0.0014585359615392694,
         -0.0011402698695349744, 0.00091411498725532073, -0.00075206182683160486, 0.00062392828464707766
        },
        /* [185] 1.125 <= y <= 1.25 2^-17, degree 10, 63.4 bits */
        {
         0.89412129723221756, 2.3020636461524986e-17, -0.016690842329435837, 0.0058028475107055602,
         -0.0029642210248523276, 0.0017583682347169613, -0.001130230706852804, 0.00076389589958638542,
         -0.00053437554071111024, 0.00038331441714845748, -0.00028179111820268244, 0.00020917276486239522
        },
        /* [186] 1.25 <= y <= 1.375 2^-17, degree 10, 63.9 bits */
        {
         0.89212021941657538, -5.2504394104577146e-18, -0.015366593806655383, 0.0048365284644905629,
         -0.0022357861942177769, 0.0012001005222161141, -0.00069798527553697641, 0.0004268502583687674,
         -0.00027017542824830319, 0.00017535054979053689, -0.0001165193298928939, 7.8255328088838339e-05
        },
        /* [187] 1.375 <= y <= 1.5 2^-17, degree 10, 64.1 bits */
        {
         0.89027087237969038, -3.7844211644183122e-17, -0.014253668859760066, 0.0040983924924236663,
         -0.0017301644439311739, 0.00084803932257116778, -0.00045037096809326751, 0.00025148782516259553,
         -0.0001453450146396005, 8.6133061976054033e-05, -5.222076253009212e-05, 3.2022542427134336e-05
        },
        /* [188] 1.5 <= y <= 1.625 2^-17, degree 10, 64.8 bits */
        {
         0.88855001611892159, -3.6452291268859526e-17, -0.01330405418650152, 0.0035211244179446507,
         -0.001367801291918229, 0.00061685890882157948, -0.00030141164737268114, 0.00015485260287264964,
         -8.2339688913375767e-05, 4.4893413613033572e-05, -2.5026979303787508e-05, 1.4119355956712099e-05
        },
        /* [189] 1.625 <= y <= 1.75 2^-17, degree 10, 65.8 bits */
        {
         0.88693949738366229, 3.9543418396046994e-18, -0.01248341117699964, 0.0030606612295792967,
         -0.0011010526047420758, 0.00045982292616155313, -0.00020805157660766703, 9.8975635087326851e-05,
         -4.8731926018462524e-05, 2.460243317678364e-05, -1.269396280352672e-05, 6.6311126780747765e-06
        },
        /* [190] 1.75 <= y <= 1.875 2^-17, degree 10, 64.1 bits */
        {
         0.88542484959280998, -4.6327215630026062e-17, -0.011766502403837732, 0.0026871450504360401,
         -0.00090016104076350197, 0.00035003338414473189, -0.00014746326070009532, 6.5317286241563179e-05,
         -2.994307089295228e-05, 1.4074745581715105e-05, -6.758976632254236e-06, 3.2873248917613598e-06
        },
        /* [191] 1.875 <= y <= 2 2^-17, degree 10, 64.8 bits */
        {
         0.88399434649953734, 3.4390473039621791e-17, -0.011134345352376819, 0.0023797415532996954,
         -0.0007458678225256692, 0.00027134769338970597, -0.00010694573719441824, 4.4316369537477015e-05,
         -1.900574296675823e-05, 8.3575420875962857e-06, -3.7535257979792662e-06, 1.7078283691764705e-06
        },
        /* [192] 1 <= y <= 1.125 2^-16, degree 10, 63.3 bits */
        {
         0.88198571529983161, 2.5937556857264017e-17, -0.020628115817443823, 0.0080444677746576137,
         -0.0045987084758263254, 0.0030511764993346215, -0.0021930824528366404, 0.0016572830343637589,
         -0.0012961239726825703, 0.001039372537025781, -0.00085533581322166073, 0.00070976414924607046
        },
        /* [193] 1.125 <= y <= 1.25 2^-16, degree 10, 63.0 bits */
        {
         0.87952459752791212, -2.4403086319419826e-17, -0.018811130716632801, 0.0065685028559747793,
         -0.0033605878713318465, 0.0019953028086435866, -0.0012833283888562051, 0.00086777979139751214,
         -0.00060727402480957018, 0.00043574020715880405, -0.00032041634688516406, 0.00023789804935298698
        },
        /* [194] 1.25 <= y <= 1.375 2^-16, degree 10, 63.4 bits */
        {
         0.87726972641221512, -2.8607393575512108e-17, -0.017312366632520657, 0.0054731073938929136,
         -0.0025340934865449487, 0.0013614816581242566, -0.00079235052701995224, 0.00048479176237331643,
         -0.00030696683488176793, 0.00019929191815041406, -0.00013246387517897105, 8.8984364361258071e-05
        },
        /* [195] 1.375 <= y <= 1.5 2^-16, degree 10, 63.5 bits */
        {
         0.87518655841113457, -2.4744775402001865e-17, -0.016053124798929903, 0.0046365835175675675,
         -0.0019605404042645561, 0.00096186282549016121, -0.00051115106409101011, 0.00028556704150295415,
         -0.00016510494818072654, 9.7874416948329912e-05, -5.9355551797531858e-05, 3.6406257524264415e-05
        },
        /* [196] 1.5 <= y <= 1.625 2^-16, degree 10, 64.9 bits */
        {
         0.87324875549499992, 1.6280998302048104e-17, -0.014978940437144596, 0.0039825215811363024,
         -0.0015495820053632418, 0.0006995078277817323, -0.00034202116337594306, 0.00017580332503567864,
         -9.351673509199112e-05, 5.1004011546739376e-05, -2.8441387384493462e-05, 1.6049480403311595e-05
        },
        /* [197] 1.625 <= y <= 1.75 2^-16, degree 10, 66.3 bits */
        {
         0.87143574928221545, -4.2758414773558783e-17, -0.01405086942592251, 0.0034609159665640482,
         -0.001247121762767458, 0.00052132989156251908, -0.00023603881337780133, 0.0001123464902383081,
         -5.5337414290162745e-05, 2.7946474951601946e-05, -1.4423429449282997e-05, 7.5363839839742247e-06
        },
        /* [198] 1.75 <= y <= 1.875 2^-16, degree 10, 65.0 bits */
        {
         0.86973115210947838, -2.392359538101021e-19, -0.013240295317452326, 0.0030378885675351776,
         -0.0010193786567317528, 0.00039678174455284052, -0.00016727090214915306, 7.4128717623841257e-05,
         -3.3996260778774847e-05, 1.5985308744309907e-05, -7.6786588003014822e-06, 3.7355435942423556e-06
        },
        /* [199] 1.875 <= y <= 2 2^-16, degree 10, 64.1 bits */
        {
         0.86812168326303285, -2.3699063909163015e-17, -0.01252569815813279, 0.0026898041154940003,
         -0.00084449364527485588, 0.00030753383277566827, -0.00012129092913499464, 5.0286757158084012e-05,
         -2.1575110027874855e-05, 9.4906130561177259e-06, -4.2636405125926119e-06, 1.9404101229185147e-06
        },
        /* [200] 1 <= y <= 1.125 2^-15, degree 10, 62.2 bits */
        {
         0.86586246556819146, -1.6046980074369071e-17, -0.023197332264418512, 0.0090899572622924751,
         -0.0052054319671566672, 0.0034572278731322069, -0.0024866745408542103, 0.0018801359263624468,
         -0.0014710281337182772, 0.0011800375333406708, -0.00097138176486241733, 0.00080626408589250752
        },
        /* [201] 1.125 <= y <= 1.25 2^-15, degree 10, 62.6 bits */
        {
         0.8630954374550629, -4.0536852716042743e-17, -0.02114456445153139, 0.0074195214236320774,
         -0.0038027405580170399, 0.0022601603825789544, -0.0014547151966277918, 0.00098419950792586071,
         -0.00068903942753083258, 0.00049458434459843145, -0.00036379654592439483, 0.00027017623425578378
        },
        /* [202] 1.25 <= y <= 1.375 2^-15, degree 10, 63.2 bits */
        {
         0.86056138054867048, -1.2794767858944003e-17, -0.01945189230811601, 0.0061801812652207853,
         -0.0028666592496291825, 0.001541781000587732, -0.00089793284494882797, 0.00054969227323859327,
         -0.00034821315577969887, 0.00022615162596056014, -0.00015036299645713522, 0.00010103498069997562
        },
        /* [203] 1.375 <= y <= 1.5 2^-15, degree 10, 63.5 bits */
        {
         0.85822121135053786, 5.2039020364609065e-17, -0.01803018044693366, 0.0052339999677548958,
         -0.0022172301983674979, 0.0010889636694652865, -0.00057912267262688719, 0.00032372138896223955,
         -0.0001872474932988669, 0.00011104119950287532, -6.7361532709948169e-05, 4.1327888340012911e-05
        },
        /* [204] 1.5 <= y <= 1.625 2^-15, degree 10, 65.4 bits */
        {
         0.85604513885505196, 1.9341380082538592e-17, -0.01681775786322881, 0.0044943943084953669,
         -0.0017520205447783311, 0.0007917530320474983, -0.00038741483158604697, 0.00019924902127988094,
         -0.00010603619197943455, 5.7853640444742361e-05, -3.2271178997690344e-05, 1.8215599779108097e-05
        },
        /* [205] 1.625 <= y <= 1.75 2^-15, degree 10, 64.4 bits */
        {
         0.85400990430694679, 1.3818820327682377e-17, -0.015770538740277246, 0.0039047141432170906,
         -0.0014097109962343628, 0.00058994724710545227, -0.0002673097599458715, 0.0001273034991288995,
         -6.2733314973304285e-05, 3.1693511210157705e-05, -1.6362568564520856e-05, 8.5519699314729645e-06
        },
        /* [206] 1.75 <= y <= 1.875 2^-15, degree 10, 63.8 bits */
        {
         0.85209698111103915, 3.7403067831495363e-18, -0.014856136002870004, 0.0034265883019752009,
         -0.0011520184001480337, 0.00044891206188796008, -0.00018939359389697494, 8.3981608449381544e-05,
         -3.8532757984932195e-05, 1.8125339560069881e-05, -8.7094743090224448e-06, 4.238207707360623e-06
        },
        /* [207] 1.875 <= y <= 2 2^-15, degree 10, 65.3 bits */
        {
         0.85029135863780836, 4.0293820841909379e-17, -0.014050199444420531, 0.0030332524668150781,
         -0.00095417543194467104, 0.00034786961095596057, -0.00013730659990120951, 5.6960359894156127e-05,
         -2.4449833434581558e-05, 1.0759335345151128e-05, -4.8352055342859378e-06, 2.2011584595581731e-06
        },
        /* [208] 1 <= y <= 1.125 2^-14, degree 10, 62.4 bits */
        {
         0.84775769471814544, -3.3054878677716539e-17, -0.026009938479906444, 0.010247221586894116,
         -0.0058797550720427888, 0.0039095852050456108, -0.002814278217901413, 0.0021291085963706657,
         -0.0016666212231325023, 0.0013374667920738317, -0.0011013465069963316, 0.00091440131181974918
        },
        /* [209] 1.125 <= y <= 1.25 2^-14, degree 10, 63.1 bits */
        {
         0.84465595735196985, -1.4833580754712624e-19, -0.023696288442822504, 0.0083607258430887701,
         -0.0042937858760661628, 0.0025550154738077204, -0.0016458296896977843, 0.0011141817336774262,
         -0.00078042059149952643, 0.00056040229453447709, -0.00041235166341310189, 0.00030632646875237757
        },
        /* [210] 1.25 <= y <= 1.375 2^-14, degree 10, 64.8 bits */
        {
         0.8418167488024505, -1.9007737472522653e-17, -0.021789241094591471, 0.0069615773831710869,
         -0.0032357432533920679, 0.0017423715134662027, -0.0010155965097045805, 0.00062211114178630097,
         -0.00039428413516608, 0.00025617814011374285, -0.00017038665594441875, 0.00011452414261726254
        },
        /* [211] 1.375 <= y <= 1.5 2^-14, degree 10, 63.2 bits */
        {
         0.83919594509058004, -2.2238218675859585e-17, -0.020188045400799926, 0.005893735404209767,
         -0.0025019230914873299, 0.0012302841431133932, -0.0006548291403871469, 0.0003662726403628244,
         -0.00021196716739521675, 0.00012575290755933999, -7.6313356692046978e-05, 4.6834380273074957e-05
        },
        /* [212] 1.5 <= y <= 1.625 2^-14, degree 10, 64.8 bits */
        {
         0.83675992414428724, 3.0181454736638732e-17, -0.018823015103277038, 0.0050592814794041896,
         -0.0019764088391101952, 0.0008942611264767216, -0.00043794739908084167, 0.00022538337884189387,
         -0.00012000594787638899, 6.5503350578545157e-05, -3.6551454870307547e-05, 2.0638037833538241e-05
        },
        /* [213] 1.625 <= y <= 1.75 2^-14, degree 10, 66.5 bits */
        {
         0.83448244412255246, -3.3286895721559778e-17, -0.017644348790301159, 0.0043941663772488542,
         -0.0015898276227071305, 0.00066615882433658654, -0.00030210356046643934, 0.00014396780953320268,
         -7.0982205965091342e-05, 3.5876367882893995e-05, -1.8528863535094938e-05, 9.6872509560744762e-06
        },
        /* [214] 1.75 <= y <= 1.875 2^-14, degree 10, 64.5 bits */
        {
         0.8323426081756522, -4.524583567657437e-17, -0.016615470185273033, 0.0038550182225852514,
         -0.0012988787904651185, 0.00050678331953710556, -0.00021399703469535865, 9.4954268636696248e-05,
         -4.3590278576974722e-05, 2.0513278845138797e-05, -9.8605724223349662e-06, 4.7998909845669165e-06
        },
        /* [215] 1.875 <= y <= 2 2^-14, degree 10, 62.9 bits */
        {
         0.83032348972789838, -5.5248866334078544e-17, -0.015708886259128026, 0.0034115918141188291,
         -0.0010755553351938238, 0.00039262650861443104, -0.00015511032376912436, 6.4389261714595765e-05,
         -2.7653413466335765e-05, 1.2174469695649618e-05, -5.4732181662799973e-06, 2.4924120708374407e-06
        },
        /* [216] 1 <= y <= 1.125 2^-13, degree 10, 62.1 bits */
        {
         0.82749137440211695, 1.4249507678619026e-17, -0.029067002113604183, 0.011521038245259877,
         -0.0066254690178771287, 0.0044111941462809659, -0.0031782300235261994, 0.002406093979619447,
         -0.0018844639444919242, 0.0015129655821040273, -0.0012463424325794821, 0.0010351262132809911
        },
        /* [217] 1.125 <= y <= 1.25 2^-13, degree 10, 62.5 bits */
        {
         0.82402606331288564, 2.9430361882801546e-17, -0.026466333209727969, 0.0093957084747424528,
         -0.0048363447812724801, 0.0028817090688579195, -0.0018579859788911853, 0.0012586826137445477,
         -0.00088212478132569281, 0.00063372439777015829, -0.00046648618584971193, 0.00034665836580732829
        },
        /* [218] 1.25 <= y <= 1.375 2^-13, degree 10, 62.6 bits */
        {
         0.82085578487717703, 1.0219770259284897e-17, -0.024323655341786904, 0.007820055274699934,
         -0.0036432191913142228, 0.0019644563429639271, -0.001146122952750527, 0.00070256468002139643,
         -0.00044552622827383475, 0.00028960697778687233, -0.00019269746220512026, 0.00012956460891581714
        },
        /* [219] 1.375 <= y <= 1.5 2^-13, degree 10, 62.7 bits */
        {
         0.81793084777091074, -4.9206113496703185e-17, -0.022525351426220169, 0.0066179459428632927,
         -0.0028159957383156716, 0.0013866398066324523, -0.00073875682188993244, 0.00041351525940315053,
         -0.00023944484300482313, 0.00014212202315896737, -8.6281985428986223e-05, 5.2970717823930711e-05
        },
        /* [220] 1.5 <= y <= 1.625 2^-13, degree 10, 64.5 bits */
        {
         0.81521340171748924, -4.4564172923395426e-17, -0.020992863597334769, 0.0056788908972940531,
         -0.0022237816270144969, 0.0010076020326254982, -0.00049393329293952312, 0.00025438216208736473,
         -0.00013552557815177532, 7.4010220645711328e-05, -4.1315373220471008e-05, 2.3336156284696039e-05
        },
        /* [221] 1.625 <= y <= 1.75 2^-13, degree 10, 63.9 bits */
        {
         0.81267391494743624, 5.3233616678210068e-17, -0.019670068470140561, 0.0049306403195169355,
         -0.0017882644464057998, 0.00075037327797240825, -0.0003406301349608947, 0.00016244845734404389,
         -8.0141425160918208e-05, 4.0525534275287697e-05, -2.0938730474665306e-05, 1.0951113189313276e-05
        },
        /* [222] 1.75 <= y <= 1.875 2^-13, degree 10, 63.0 bits */
        {
         0.81028887832480523, 3.4066573408749994e-17, -0.018515759053884081, 0.0043242832555724052,
         -0.0014605772879585476, 0.0005706950724232283, -0.00024122528992643789, 0.00010711661130859756,
         -4.9203135494235186e-05, 2.3166145184538052e-05, -1.1140493377251595e-05, 5.424902468725208e-06
        },
        /* [223] 1.875 <= y <= 2 2^-13, degree 10, 62.9 bits */
        {
         0.80803925503362084, -4.4779461276701677e-18, -0.017498970327018953, 0.0038257210412276344,
         -0.0012091210836920022, 0.0004420283413007217, -0.00017480336129163893, 7.2619592965310402e-05,
         -3.120708123733585e-05, 1.3745884753294394e-05, -6.1823162771793175e-06, 2.8163625460158989e-06
        },
        /* [224] 1 <= y <= 1.125 2^-12, degree 10, 61.4 bits */
        {
         0.80488523456341365, 1.4299536892142632e-18, -0.032362364664667596, 0.012914070578749397,
         -0.0074453753256989701, 0.0049644394681101177, -0.0035805141691120203, 0.0027127490245670714,
         -0.0021259519006228329, 0.0017077199922385289, -0.001407393377283839, 0.0011693225578038112
        },
        /* [225] 1.125 <= y <= 1.25 2^-12, degree 10, 62.7 bits */
        {
         0.80102829176409662, 2.751326602651222e-17, -0.02944798925830305, 0.010526272192573348,
         -0.0054322818980246943, 0.0032416957120309509, -0.0020922794222918593, 0.0014185262770411244,
         -0.00099477603653092602, 0.00071502684917853219, -0.00052656836446328826, 0.00039145695256094574
        },
        /* [226] 1.25 <= y <= 1.375 2^-12, degree 10, 62.9 bits */
        {
         0.79750188873849881, 3.6785438798137406e-17, -0.027048052079132506, 0.008756836212833909,
         -0.0040903679944234933, 0.0022089628575688537, -0.0012901515315788916, 0.00079149118232447384,
         -0.00050224113782026437, 0.00032664716100140709, -0.00021744189851640247, 0.00014625917796039944
        },
        /* [227] 1.375 <= y <= 1.5 2^-12, degree 10, 62.7 bits */
        {
         0.79425022151750868, 2.5008902945000679e-17, -0.025034763740485442, 0.0074074483927512218,
         -0.0031603504266913742, 0.0015586436145202066, -0.00083129629682751215, 0.00046569546156528433,
         -0.00026983600461152624, 0.00016024723998520226, -9.7330686323698995e-05, 5.9777524633013621e-05
        },
        /* [228] 1.5 <= y <= 1.625 2^-12, degree 10, 63.8 bits */
        {
         0.79123080168743354, -4.1355623702729428e-17, -0.023319802301974446, 0.0063537516608167437,
         -0.0024947873074168433, 0.0011321931436800879, -0.00055562032277816861, 0.00028639013557497174,
         -0.00015267959182603197, 8.3423771710537735e-05, -4.6592198669243393e-05, 2.6327278400483247e-05
        },
        /* [229] 1.625 <= y <= 1.75 2^-12, degree 10, 63.2 bits */
        {
         0.78841049162041965, -1.4609308892847743e-17, -0.021840091872597299, 0.0055144566904711274,
         -0.0020054948809937675, 0.00084288201892079265, -0.00038305181328156333, 0.0001828339015137282,
         -9.0259019165952074e-05, 4.5667169736810397e-05, -2.3606513824793342e-05, 1.2351435088480307e-05
        },
        /* [230] 1.75 <= y <= 1.875 2^-12, degree 10, 62.7 bits */
        {
         0.78576292128884773, 5.0271610136937546e-17, -0.02054933661915986, 0.0048345510362530989,
         -0.0016374638794714358, 0.00064085512115886339, -0.00027118763575060715, 0.00012052450194580947,
         -5.5399718642804535e-05, 2.6098379807498165e-05, -1.255662634661209e-05, 6.1170284182601802e-06
        },
        /* [231] 1.875 <= y <= 2 2^-12, degree 10, 63.7 bits */
        {
         0.78326674451735001, 5.0679491772290191e-18, -0.019412758655783072, 0.0042756940732157902,
         -0.0013551338762041122, 0.00049622598598417797, -0.00019646102622267829, 8.1687656165099637e-05,
         -3.5128181329546952e-05, 1.5481863065748307e-05, -6.9664735713228128e-06, 3.1749185795741537e-06
        },
        /* [232] 1 <= y <= 1.125 2^-11, degree 10, 61.3 bits */
        {
         0.77976880794497438, -1.0775650567721275e-18, -0.03588064768434799, 0.014426056425365652,
         -0.0083408371009927006, 0.0055708576285807337, -0.0040225624417596691, 0.0030503477646729813,
         -0.0023922036293495506, 0.0019227092472524499, -0.0015853640345310171, 0.0013177500921412743
        },
        /* [233] 1.125 <= y <= 1.25 2^-11, degree 10, 61.8 bits */
        {
         0.77549409133183511, 3.404034431639667e-17, -0.032625997113337364, 0.011751763788822714,
         -0.0060823741746159647, 0.0036358530816259548, -0.0023494677882430004, 0.0015943266445208376,
         -0.0011188617933604195, 0.00080469425635371582, -0.00059290325857244773, 0.0004409630407057382
        },
        /* [234] 1.25 <= y <= 1.375 2^-11, degree 10, 63.4 bits */
        {
         0.77158840491648317, 3.2139641861516136e-17, -0.029947365520240504, 0.009771045088689697,
         -0.0045776257848464891, 0.0024764112697206481, -0.0014481052202468235, 0.00088920662858227642,
         -0.00056465842413688013, 0.0003674638178753369, -0.0002447389908545219, 0.00016469321647137621
        },
        /* [235] 1.375 <= y <= 1.5 2^-11, degree 10, 64.0 bits */
        {
         0.76798927967356434, -4.4206243378415865e-17, -0.027701452177519729, 0.0082612456337404841,
         -0.0035352186322655751, 0.0017466122117222045, -0.00093269390136295331, 0.00052298480119798241,
         -0.0003032558220160957, 0.00018020479872120509, -0.00010950987971228305, 6.7287959682045577e-05
        },
        /* [236] 1.5 <= y <= 1.625 2^-11, degree 10, 62.9 bits */
        {
         0.764649175206359, -3.1138757781990713e-17, -0.025789258979885838, 0.007082805282484071,
         -0.002789531690398779, 0.0012682306128499225, -0.00062315693451750833, 0.0003215046280281705,
         -0.0001715288783053783, 9.3781395819856562e-05, -5.2404800846005622e-05, 2.9625302000750571e-05
        },
        /* [237] 1.625 <= y <= 1.75 2^-11, degree 10, 63.0 bits */
        {
         0.76153103012158074, 4.5023777372137893e-17, -0.024140114974515358, 0.0061445331349145047,
         -0.0022415465156991319, 0.00094380763204016257, -0.0004294605420487923, 0.00020518141999824652,
         -0.00010136862935552871, 5.132057109149809e-05, -2.6543202972749238e-05, 1.3894428169802278e-05
        },
        /* [238] 1.75 <= y <= 1.875 2^-11, degree 10, 63.8 bits */
        {
         0.75860536411239288, -2.848478762236057e-17, -0.022702169884876229, 0.0053847387500546252,
         -0.0018295172487152712, 0.00071734000089349373, -0.00030394228320941016, 0.00013521270159233277,
         -6.2199323839138724e-05, 2.9320383508678465e-05, -1.4114518991900583e-05, 6.8792019218529501e-06
        },
        /* [239] 1.875 <= y <= 2 2^-11, degree 10, 65.6 bits */
        {
         0.75584832248791556, 1.5385622428470501e-17, -0.021436487420879342, 0.0047604422433104778,
         -0.0015135420152150865, 0.00055526658257650603, -0.00022012080282485147, 9.1615101918063191e-05,
         -3.9428142365605527e-05, 1.7388224592253863e-05, -7.8286125448094142e-06, 3.5695326338356179e-06
        },
        /* [240] 1 <= y <= 1.125 2^-10, degree 10, 61.7 bits */
        {
         0.75198700239362581, -2.4331571903248289e-17, -0.03959511204215356, 0.016052868736526473,
         -0.009311243939989583, 0.0062307879703665768, -0.0045050083879568997, 0.0034195991032803519,
         -0.0026839206759637535, 0.0021585954092547136, -0.0017808706576242649, 0.0014809715590373665
        },
        /* [241] 1.125 <= y <= 1.25 2^-10, degree 10, 62.6 bits */
        {
         0.7472716490272181, 5.4397734709458413e-17, -0.035974618802760483, 0.013068306763753498,
         -0.006785917867616403, 0.0040642520880008384, -0.0026298259891210768, 0.0017863909316246022,
         -0.0012546664976998004, 0.00090297276821554775, -0.00066569879653710542, 0.00049534838871605864
        },
        /* [242] 1.25 <= y <= 1.375 2^-10, degree 10, 62.1 bits */
        {
         0.74296667848291842, 8.0195511673896952e-18, -0.032996793562103895, 0.010859071550694035,
         -0.0051042863859998185, 0.0027667567583862102, -0.0016201001831546802, 0.00099585025866684549,
         -0.00063290158901355966, 0.00041215649636787633, -0.00027466610246717891, 0.00018492524696544271
        },
        /* [243] 1.375 <= y <= 1.5 2^-10, degree 10, 64.9 bits */
        {
         0.73900241252723942, 2.504400135965353e-17, -0.030501484589608462, 0.0091759860998833973,
         -0.0039399302075024713, 0.0019504538122555974, -0.0010429929914984994, 0.00058544785075628932,
         -0.00033976074099240875, 0.00020203773002124597, -0.00012285070501818365, 7.5523822385997817e-05
        },
        /* [244] 1.5 <= y <= 1.625 2^-10, degree 10, 64.0 bits */
        {
         0.73532585299804587, -3.1804303329910314e-17, -0.028378108721213068, 0.0078629422543550175,
         -0.0031073951910409554, 0.001415607463704448, -0.00069655267922871366, 0.00035975549538915457,
         -0.00019210019737006052, 0.00010510270141709, -5.8766542450968495e-05, 3.3238965228795467e-05
        },
        /* [245] 1.625 <= y <= 1.75 2^-10, degree 10, 62.5 bits */
        {
         0.73189570438619067, -5.3398930050813222e-17, -0.026547762042572927, 0.0068179823677394051,
         -0.0024958537788919758, 0.0010530426297953241, -0.00047985046739920878, 0.00022950422758907546,
         -0.0001134832295563247, 5.7495050583782813e-05, -2.9754840992562533e-05, 1.558381545460183e-05
        },
        /* [246] 1.75 <= y <= 1.875 2^-10, degree 10, 62.8 bits */
        {
         0.72867913366216019, -2.7105427438053676e-17, -0.02495257925831287, 0.0059721612795872372,
         -0.0020362242336422597, 0.00080004823173474601, -0.00033947686604967811, 0.00015118632202797404,
         -6.960828211556435e-05, 3.283671872772467e-05, -1.5817024067639118e-05, 7.7130924679447176e-06
        },
        /* [247] 1.875 <= y <= 2 2^-10, degree 10, 64.0 bits */
        {
         0.72564958478405639, 1.5441974263012908e-17, -0.023549125031397097, 0.0052774636127834746,
         -0.0016838809938430474, 0.00061905721361610474, -0.00024576814552759523, 0.00010240310555634059,
         -4.4110007289633343e-05, 1.946725281824075e-05, -8.7701275050755615e-06, 4.0009862344780545e-06
        },
        /* [248] 1 <= y <= 1.125 2^-9, degree 10, 60.8 bits */
        {
         0.7214092721631119, 1.1080740462176655e-17, -0.043465477746874447, 0.017785470371549896,
         -0.010353395994623838, 0.0069429632912908256, -0.0050273948551788558, 0.0038204278002663722,
         -0.0030012180246176347, 0.002415588798505269, -0.0019941714576102933, 0.0016592626597257279
        },
        /* [249] 1.125 <= y <= 1.25 2^-9, degree 10, 61.5 bits */
        {
         0.7162353188515157, 8.066600164626997e-18, -0.03945569298578884, 0.014467953717745131,
         -0.0075402789307664423, 0.0045258885482472215, -0.0029329741899153834, 0.0019946042722288927,
         -0.0014021915676913248, 0.0010099131737829638, -0.00074502432741933931, 0.00055468521134060156
        },
        /* [250] 1.25 <= y <= 1.375 2^-9, degree 10, 63.0 bits */
        {
         0.71151571433916849, 5.3287317236222257e-17, -0.036160045645347923, 0.012013868825929719,
         -0.0056681629246406132, 0.0030792061708714426, -0.0018058393075333094, 0.0011113198118487414,
         -0.00070694737722662296, 0.00046073295834480704, -0.00030724166401789783, 0.00020697544479526077
        },
        /* [251] 1.375 <= y <= 1.5 2^-9, degree 10, 61.6 bits */
        {
         0.70717305528027774, -4.4562282814702684e-17, -0.033400235452824258, 0.010145374181623592,
         -0.0043726522190813697, 0.0021695386572539157, -0.001161965105303043, 0.00065300391313118621,
         -0.00037932648789628699, 0.00022574291051571366, -0.00013735723155427552, 8.4490812246127981e-05
        },
        /* [252] 1.5 <= y <= 1.625 2^-9, degree 10, 63.6 bits */
        {
         0.70314850351870306, 5.4532831374245208e-18, -0.03105321864091699, 0.0086884994587669989,
         -0.0034468270094419459, 0.0015738194070070738, -0.00077563208266534034, 0.00040108148274224501,
         -0.00021437367221486091, 0.00011738273582401224, -6.5677526292292951e-05, 3.7169743915575845e-05
        },
        /* [253] 1.625 <= y <= 1.75 2^-9, degree 10, 63.6 bits */
        {
         0.69939623890579361, 2.0512810874450713e-17, -0.029031247013663011, 0.0075296787592507809,
         -0.0027670928287847427, 0.0011701793124792501, -0.00053408606967415004, 0.00025575633728143173,
         -0.00012658770180879687, 6.4186207527791594e-05, -3.3240612510321597e-05, 1.7419838921347562e-05
        },
        /* [254] 1.75 <= y <= 1.875 2^-9, degree 10, 62.6 bits */
        {
         0.69587985008967834, -2.6275843773474154e-17, -0.027270001056460567, 0.0065921537016707119,
         -0.0022564453418055697, 0.00088864699708787092, -0.00037768584921734006, 0.00016841082079477776,
         -7.7615387040261285e-05, 3.6643969864276314e-05, -1.7663277402360787e-05, 8.6186117370655863e-06
        },
        /* [255] 1.875 <= y <= 2 2^-9, degree 10, 64.7 bits */
        {
         0.69256990127566376, -1.823669616835516e-17, -0.025721223098754652, 0.0058224913081312358,
         -0.0018651624972089687, 0.0006873236369629547, -0.00027332009680728226, 0.0001140255721895728,
         -4.916552546960598e-05, 2.1716420887896272e-05, -9.7903151623876606e-06, 4.4691322499545973e-06
        },
        /* [256] 1 <= y <= 1.125 2^-8, degree 10, 61.4 bits */
        {
         0.68794036488288401, 1.6580749023162915e-17, -0.04743585320832909, 0.01960880624061993,
         -0.011460823790282208, 0.0077040471701239118, -0.0055878383136283233, 0.0042517201573249782,
         -0.0033434253802095992, 0.0026932890803331995, -0.0022250363398294008, 0.0018525044460631929
        },
        /* [257] 1.125 <= y <= 1.25 2^-8, degree 10, 62.2 bits */
        {
         0.68229661152183974, 2.4396711301373747e-17, -0.043016812542070258, 0.015937795924131522,
         -0.0083404001916815226, 0.0050183819985329626, -0.0032576817505748866, 0.0022182965455120685,
         -0.0015610621372481087, 0.0011253040879305432, -0.00083076162879352415, 0.00061890993468470979
        },
        /* [258] 1.25 <= y <= 1.375 2^-8, degree 10, 61.5 bits */
        {
         0.67715338172482409, -1.1754491110314571e-17, -0.039387721984899253, 0.013224223260301793,
         -0.0062652194729887669, 0.0034120135541132663, -0.0020044914708158747, 0.0012351971880840407,
         -0.0007865786073048901, 0.00051307856620625499, -0.00034240486296723552, 0.00023081203149136198
        },
        /* [259] 1.375 <= y <= 1.5 2^-8, degree 10, 62.3 bits */
        {
         0.67242508441233795, 9.0242912352665241e-18, -0.036350931908371201, 0.011159560844321445,
         -0.0048301065072285211, 0.0024025553504964038, -0.0012890323232204925, 0.0007253832961992186,
         -0.00042182270248908576, 0.00025125601382438336, -0.0001529973404111865, 9.4172947062219018e-05
        },
        /* [260] 1.5 <= y <= 1.625 2^-8, degree 10, 65.3 bits */
        {
         0.66804670206332994, 2.6852865733578155e-17, -0.033770134061067388, 0.0095507446046326043,
         -0.0038051239054426693, 0.001741860960767051, -0.00085998287997259579, 0.00044530335852502231,
         -0.0002382684315610587, 0.00013058414058354415, -7.3120221066872102e-05, 4.1409386199105928e-05
        },
        /* [261] 1.625 <= y <= 1.75 2^-8, degree 10, 61.8 bits */
        {
         0.66396763441430318, 1.1151833880292833e-17, -0.031548178951112338, 0.0082718169132839567,
         -0.0030530051186987302, 0.0012944328073347324, -0.00059186657685142299, 0.00028381543227830623,
         -0.0001406303502843775, 7.1371630954532983e-05, -3.6990624103685286e-05, 1.939810034625849e-05
        },
        /* [262] 1.75 <= y <= 1.875 2^-8, degree 10, 62.5 bits */
        {
         0.66014769526496997, 4.4535314800091785e-17, -0.029613895608073662, 0.0072376894507349991,
         -0.0024882718389084074, 0.00098251392434506465, -0.00041834541363751891, 0.00018680072993970521,
         -8.61866894279222e-05, 4.0728286784072578e-05, -1.9647516095181619e-05, 9.5933385964881103e-06
        },
        /* [263] 1.875 <= y <= 2 2^-8, degree 10, 62.4 bits */
        {
         0.65655441508414902, -3.1755669111689915e-17, -0.027913913725041078, 0.0063891602705566557,
         -0.0020557570760431731, 0.0007595654397639925, -0.00030260715379394219, 0.0001264215129293195,
         -5.4571855378500029e-05, 2.4126934604524742e-05, -1.0885718594599867e-05, 4.9725960998649358e-06
        },
        /* [264] 1 <= y <= 1.125 2^-7, degree 10, 61.0 bits */
        {
         0.65153249779292544, 4.4218920039968283e-17, -0.051432957163574773, 0.021500700721951652,
         -0.012623074724527788, 0.0085081345277457521, -0.0061826595730698104, 0.0047110403280873538,
         -0.0037088630769694059, 0.0029905044682679801, -0.0024725975837337705, 0.0020600591804812189
        },
        /* [265] 1.125 <= y <= 1.25 2^-7, degree 10, 62.2 bits */
        {
         0.64541657701924426, 3.3321288731950259e-18, -0.04658979219589135, 0.017459087787168853,
         -0.0091782893038872496, 0.0055376532821328206, -0.0036016531857414611, 0.0024560948825164291,
         -0.0017304226075114657, 0.001248596433089309, -0.00092254910332949041, 0.00068778164066329015
        },
        /* [266] 1.25 <= y <= 1.375 2^-7, degree 10, 61.4 bits */
        {
         0.63984897555982678, 1.7808109615222038e-17, -0.042615978359495744, 0.014474044268432367,
         -0.006889191745274548, 0.0037622629831827021, -0.0022145606712980059, 0.0013666666628436794,
         -0.00087133167476512619, 0.00056892189090467285, -0.00037999264479757281, 0.00025633576323800113
        },
        /* [267] 1.375 <= y <= 1.5 2^-7, degree 10, 61.9 bits */
        {
         0.63473553552140927, 2.833089620636866e-18, -0.039293479835364804, 0.012204557743977067,
         -0.0053072813180582478, 0.0026473593898971937, -0.0014231836719218859, 0.00080207950715304377,
         -0.00046698487234995143, 0.00027843469966269755, -0.00016969245595381048, 0.00010452623344988354
        },
        /* [268] 1.5 <= y <= 1.625 2^-7, degree 10, 62.3 bits */
        {
         0.63000478672121141, 1.6171866286075376e-17, -0.036472038626822925, 0.010437385754880445,
         -0.0041782061566919011, 0.0019181166909635937, -0.00094890063112839805, 0.00049209471445367916,
         -0.00026362681279223265, 0.00014462843495942826, -8.1054560536889379e-05, 4.5937130798420811e-05
        },
        /* [269] 1.625 <= y <= 1.75 2^-7, degree 10, 61.2 bits */
        {
         0.62560114657798072, -5.0908368157755744e-17, -0.034044635063864813, 0.0090334959982543636,
         -0.0033502201000501124, 0.0014245610285529141, -0.00065268811860185242, 0.00031346435363403867,
         -0.00015551361388344416, 7.9006148670915553e-05, -4.0983429537308022e-05, 2.1508259541378936e-05
        },
        /* [270] 1.75 <= y <= 1.875 2^-7, degree 10, 62.0 bits */
        {
         0.62148050117213671, 9.7578710116286154e-18, -0.031932916461566027, 0.0078990243093680773,
         -0.0027288832095372331, 0.0010806769220033697, -0.00046108689971045141, 0.00020620753853560947,
         -9.5259829080736075e-05, 4.5062682020377731e-05, -2.1757766912839825e-05, 1.0631876228628578e-05
        },
        /* [271] 1.875 <= y <= 2 2^-7, degree 10, 63.6 bits */
        {
         0.61760722952886926, -9.0152134119114156e-18, -0.030078161471429062, 0.0069686995361427579,
         -0.0022532779685435155, 0.00083500997920415813, -0.00033335419976975663, 0.00013948689044116497,
         -6.0287991200304242e-05, 2.6682136653874363e-05, -1.204940235007289e-05, 5.5084431127902616e-06
        },
        /* [272] 1 <= y <= 1.125 2^-6, degree 10, 60.3 bits */
        {
         0.61219867484081136, -4.0146874186002183e-19, -0.055364831111195528, 0.023430853806487413,
         -0.013825013877919914, 0.0093462431807468903, -0.0068059985089958738, 0.0051943290818170004,
         -0.004094600879282176, 0.0033050549896730869, -0.0027351858629765659, 0.0022806329524843703
        },
        /* [273] 1.125 <= y <= 1.25 2^-6, degree 10, 61.3 bits */
        {
         0.60561926819844414, -5.458518420885123e-18, -0.050089602691120449, 0.019006464073580847,
         -0.010042523578636798, 0.0060775999557373091, -0.0039613070594417456, 0.0027057684712408791,
         -0.0019088251804978236, 0.0013788219272178408, -0.0010197209715372094, 0.00076083642160313281
        },
        /* [274] 1.25 <= y <= 1.375 2^-6, degree 10, 62.1 bits */
        {
         0.59963680194564684, 9.5015984388031449e-18, -0.045765635059440944, 0.015741740636396634,
         -0.0075312249107419805, 0.0041256522123036266, -0.0024337520960505199, 0.0015044295647344212,
         -0.00096044097434740551, 0.00062779787036973075, -0.00041971483299386422, 0.00028336301118314227
        },
        /* [275] 1.375 <= y <= 1.5 2^-6, degree 10, 61.4 bits */
        {
         0.59414829111961198, 5.164538940122185e-17, -0.042153713286389345, 0.013261731402841703,
         -0.0057971592780605846, 0.002900823781664045, -0.0015628903269157828, 0.00088229978131039075,
         -0.00051438484347887052, 0.00030704073352539213, -0.00018730651280657502, 0.0001154718078090833
        },
        /* [276] 1.5 <= y <= 1.625 2^-6, degree 10, 61.1 bits */
        {
         0.58907563258600915, 1.1651163090359811e-18, -0.039089118518787984, 0.011332154998902234,
         -0.004560408684333276, 0.0021002549769682222, -0.0010413330141530071, 0.00054095198004878737,
         -0.00029019788217783026, 0.00015938680737100471, -8.9412711658594973e-05, 5.0716711144738386e-05
        },
        /* [277] 1.625 <= y <= 1.75 2^-6, degree 10, 62.6 bits */
        {
         0.58435813355747857, 4.2776664481693091e-17, -0.036454619976782392, 0.0098003727758534838,
         -0.0036540918058501617, 0.0015587872186770817, -0.00071580596818941484, 0.00034437222957710458,
         -0.00017108444335795121, 8.7016840326312707e-05, -4.5183403975043607e-05, 2.3732640593401413e-05
        },
        /* [278] 1.75 <= y <= 1.875 2^-6, degree 10, 62.0 bits */
        {
         0.57994765994253428, -4.2125104027227096e-17, -0.034164449300259407, 0.0085634041304881933,
         -0.0029744172329222345, 0.0011817564787170161, -0.00050537051911543, 0.00022640742783522412,
         -0.00010473820015928108, 4.9604211145507215e-05, -2.3974462773231934e-05, 1.1725167674508035e-05
        },
        /* [279] 1.875 <= y <= 2 2^-6, degree 10, 62.5 bits */
        {
         0.57580537146948496, 3.711413436544893e-17, -0.032154369673480065, 0.0075496837421370928,
         -0.0024544763527304839, 0.00091256859258237856, -0.00036516177076572639, 0.0001530664215142055,
         -6.6251107685802508e-05, 2.9355851673753517e-05, -1.3270192089623393e-05, 6.0718262643662846e-06
        },
        /* [280] 1 <= y <= 1.125 2^-5, degree 10, 60.7 bits */
        {
         0.57002671574420449, -3.011369582320742e-17, -0.059120218315458814, 0.025360050252957528,
         -0.015046203617608642, 0.01020583654903263, -0.0074494396813413162, 0.0056956039441396246,
         -0.0044962134905807624, 0.0036335701826973286, -0.0030101596047398369, 0.0025121312924340925
        },
        /* [281] 1.125 <= y <= 1.25 2^-5, degree 10, 61.3 bits */
        {
         0.5630058362234116, 1.3818939595922964e-17, -0.053413921746423634, 0.020547343321775682,
         -0.010917819660283405, 0.0066297965152559068, -0.0043315641088858634, 0.0029640759871547933,
         -0.0020941181582513463, 0.0015145101561463141, -0.0011212446320189907, 0.00083733986893299965
        },
        /* [282] 1.25 <= y <= 1.375 2^-5, degree 10, 61.2 bits */
        {
         0.55663032118296951, 2.1806994434340317e-17, -0.048741858926636558, 0.016999760842009444,
         -0.0081795651798771164, 0.004496295990077925, -0.0026588454825888716, 0.0016466213871971249,
         -0.0010527838069918018, 0.00068901070512565339, -0.00046112874269090595, 0.00031160830921012994
        },
        /* [283] 1.375 <= y <= 1.5 2^-5, degree 10, 62.8 bits */
        {
         0.55078825677130994, -3.3666047123025446e-17, -0.04484317838641054, 0.014307442947266037,
         -0.0062904903587354694, 0.0031587052944953031, -0.0017060264590794774, 0.00096491756659778608,
         -0.00056340188978103395, 0.00033672215135424074, -0.00020563479988527952, 0.00012688892201850627
        },
        /* [284] 1.5 <= y <= 1.625 2^-5, degree 10, 62.2 bits */
        {
         0.54539484969043617, 3.935278804297519e-17, -0.041538426731437067, 0.012214522178762821,
         -0.0049443101589561472, 0.0022851343108433765, -0.0011358284711814961, 0.0005911659371712005,
         -0.00031762142774506867, 0.00017467101431517006, -9.8093830026788902e-05, 5.569331672928883e-05
        },
        /* [285] 1.625 <= y <= 1.75 2^-5, degree 10, 61.4 bits */
        {
         0.5403842667470512, -5.1243181274350517e-17, -0.038699994241027692, 0.010554431536144758,
         -0.0039585677729250413, 0.00169473262445434, -0.00078020015544328605, 0.00037607673863253825,
         -0.00018712504391969417, 9.5298152253038811e-05, -4.9538133628969868e-05, 2.6044829275018907e-05
        },
        /* [286] 1.75 <= y <= 1.875 2^-5, degree 10, 61.2 bits */
        {
         0.53570434017598179, -2.6810583564803517e-17, -0.036234592311732594, 0.0092148782270879068,
         -0.0032198678155888573, 0.0012839162323018192, -0.0005504616966574105, 0.00024708986209597824,
         -0.00011448539026520142, 5.4291234290071453e-05, -2.6269078352170613e-05, 1.2859812238896874e-05
        },
        /* [287] 1.875 <= y <= 2 2^-5, degree 10, 62.4 bits */
        {
         0.53131300735337372, 8.0684232609985537e-18, -0.034072403033213426, 0.0081178806188802761,
         -0.0026551606004430769, 0.00099079961671431861, -0.00039748939196173325, 0.00016694602824485021,
         -7.2373107941844963e-05, 3.2110792279788781e-05, -1.4531930538786659e-05, 6.655636924136202e-06
        },
        /* [288] 1 <= y <= 1.125 2^-4, degree 10, 60.2 bits */
        {
         0.52519346293075819, 3.8745233211823519e-17, -0.062568708102421822, 0.027239703925874,
         -0.016260439559684342, 0.01107042906638523, -0.0081016849866003809, 0.0062066871158698005,
         -0.0049075526662722743, 0.0039712965845172463, -0.0032937398525179017, 0.0027515175063915695
        },
        /* [289] 1.125 <= y <= 1.25 2^-4, degree 10, 60.7 bits */
        {
         0.51776871316958573, -4.6138504348210636e-17, -0.056443373242633134, 0.022041614726287687,
         -0.011784724599577558, 0.0071832534523875178, -0.0047056660951121194, 0.0032266297819164872,
         -0.0022833435824160028, 0.0016536108712791075, -0.0012256609061883496, 0.00091624108056438116
        },
        /* [290] 1.25 <= y <= 1.375 2^-4, degree 10, 60.9 bits */
        {
         0.51103629613265622, -1.8925332008730014e-17, -0.051434468023544261, 0.018214376297262601,
         -0.0088193475913549216, 0.0048665723697414514, -0.0028855892100739153, 0.0017907393679941195,
         -0.0011468307171230681, 0.00075159960591057696, -0.0005036152942950689, 0.00034066767547938712
        },
        /* [291] 1.375 <= y <= 1.5 2^-4, degree 10, 62.5 bits */
        {
         0.5048754683635478, -6.4298765066619395e-18, -0.047259483327112523, 0.015312898353475123,
         -0.0067756424164877828, 0.0034155428785754222, -0.0018498044704683141, 0.0010484317613188255,
         -0.0006131970485751373, 0.00036699703108493463, -0.00022439360206884745, 0.00013860832254369398
        },
        /* [292] 1.5 <= y <= 1.625 2^-4, degree 10, 63.3 bits */
        {
         0.49919484445643963, 7.4117530800350562e-19, -0.043724264221444639, 0.013059592789820426,
         -0.0053206256093286499, 0.0024687341523664174, -0.0012304950965297905, 0.00064179772024487301,
         -0.00034541398033940436, 0.00019022521495485223, -0.00010695925266633876, 6.0790759012568013e-05
        },
        /* [293] 1.625 <= y <= 1.75 2^-4, degree 10, 61.6 bits */
        {
         0.49392354317992937, -7.7355591700673493e-18, -0.040690876467332868, 0.011273916510806902,
         -0.0042561106300051796, 0.00182936825431572, -0.00084454853262738163, 0.0004079694307843368,
         -0.00020334491472507579, 0.00010370757451648448, -5.3976052977994312e-05, 2.8408380015699403e-05
        },
        /* [294] 1.75 <= y <= 1.875 2^-4, degree 10, 62.2 bits */
        {
         0.4890054481655754, 1.9460873331795482e-17, -0.03805857188872773, 0.0098342571441865558,
         -0.0034590270043195256, 0.0013848285991199369, -0.00059541294236558305, 0.00026784831309620576,
         -0.00012432047099358154, 5.9041025425909946e-05, -2.8602910200624721e-05, 1.4017442412365548e-05
        },
        /* [295] 1.875 <= y <= 2 2^-4, degree 10, 60.9 bits */
        {
         0.48439535192340155, 1.5512239547635564e-17, -0.035752011406854953, 0.0086562276075274926,
         -0.0028501529689336723, 0.0010678834586191443, -0.00042964308943630781, 0.00018084680912748907,
         -7.8537743730036294e-05, 3.4897185984810467e-05, -1.5812820244439018e-05, 7.2501900443589822e-06
        },
        /* [296] 1 <= y <= 1.125 2^-3, degree 10, 59.4 bits */
        {
         0.47797861022097443, 1.9201814099858628e-17, -0.06556159301222915, 0.029011843571997088,
         -0.017435524042241125, 0.011919332761948764, -0.0087483164961841969, 0.0067169939095058197,
         -0.0053205613607191721, 0.0043119351483838194, -0.0035808669405378254, 0.0029946870278536272
        },
        /* [297] 1.125 <= y <= 1.25 2^-3, degree 10, 60.3 bits */
        {
         0.47020533372752582, -8.6790857364837689e-18, -0.059042379037134142, 0.023441689065044752,
         -0.01261948589402175, 0.0077242728652847734, -0.0050750505334881141, 0.0034877940208530044,
         -0.0024726562236786413, 0.0017934300578132006, -0.0013310333735303431, 0.00099613272829014677
        },
        /* [298] 1.25 <= y <= 1.375 2^-3, degree 10, 60.7 bits */
        {
         0.46316840846038387, -5.0851014583641458e-19, -0.053718765615730031, 0.01934576959345571,
         -0.0094325220555921147, 0.0052270373506728583, -0.0031086305463765983, 0.0019335901363525406,
         -0.0012406073575826743, 0.00081431133399248803, -0.00054635922261101844, 0.00037000443095970141
        },
        /* [299] 1.375 <= y <= 1.5 2^-3, degree 10, 60.9 bits */
        {
         0.45673860560725604, 7.4292684526337685e-18, -0.049287107411829512, 0.016244257616459212,
         -0.0072385607770362979, 0.0036646058359120779, -0.0019907344835939506, 0.0011309383440533411,
         -0.00066269400717753008, 0.00039724081668521082, -0.00024321181230512956, 0.00015040673575328131
        },
        /* [300] 1.5 <= y <= 1.625 2^-3, degree 10, 62.4 bits */
        {
         0.45081823383897152, 1.4751234427551786e-17, -0.045538960126109529, 0.013838228144789156,
         -0.005678186555990181, 0.0026461228875068661, -0.0013229762980828828, 0.00069166275717070938,
         -0.00037295872271722981, 0.00020571975827692464, -0.00011582869342209316, 6.5909158730677564e-05
        },
        /* [301] 1.625 <= y <= 1.75 2^-3, degree 10, 61.6 bits */
        {
         0.44533160405401767, 1.7254170837172683e-17, -0.042326392795477535, 0.011933456905622664,
         -0.0045376909997750106, 0.0019589948812002186, -0.00090721174750786387, 0.00043928630075001701,
         -0.00021937528339371131, 0.00011206243796732972, -5.8404617297862334e-05, 3.0775782114988465e-05
        },
        /* [302] 1.75 <= y <= 1.875 2^-3, degree 10, 62.6 bits */
        {
         0.44021885470273875, -2.0907132200247085e-17, -0.039541460647262938, 0.010399238740541559,
         -0.0036844858644516439, 0.0014816622913263171, -0.00063905436971913845, 0.00028817455515616321,
         -0.00013401481219654519, 6.3748048322673865e-05, -3.0926154882801017e-05, 1.5174235821781588e-05
        },
        /* [303] 1.875 <= y <= 2 2^-3, degree 10, 61.4 bits */
        {
         0.43543180723624242, 1.3196412902176906e-17, -0.037103516430604652, 0.0091449566083106303,
         -0.0030332954373216907, 0.0011416148932641931, -0.00046076930542770481, 0.00019442149640409859,
         -8.4598732884301727e-05, 3.7651812023185769e-05, -1.7084938435663933e-05, 7.842982603848211e-06
        },
        /* [304] 1 <= y <= 1.125 2^-2, degree 10, 59.5 bits */
        {
         0.4287777174431498, 9.2939498815624942e-18, -0.067933150060367348, 0.030609593556712902,
         -0.018533345089630157, 0.012727601215634852, -0.0093716941539988257, 0.0072134173134896897,
         -0.0057251586025108018, 0.0046475319836423584, -0.0038650983936400715, 0.0032363739442346456
        },
        /* [305] 1.125 <= y <= 1.25 2^-2, degree 10, 60.9 bits */
        {
         0.42073099700652861, 6.4642508955251549e-18, -0.061060324073873143, 0.024692946208957355,
         -0.013394146173982832, 0.0082364356269566431, -0.0054293066159491494, 0.0037406350094239967,
         -0.0026572771681692051, 0.0019305894909577132, -0.0014349140355403992, 0.0010752225952967156
        },
        /* [306] 1.25 <= y <= 1.375 2^-2, degree 10, 61.3 bits */
        {
         0.41345998160695718, 1.8674468145050031e-17, -0.055456597897321651, 0.020348446005458459,
         -0.0099979491728798119, 0.0055664305464991279, -0.003321497152802973, 0.0020712673750053374,
         -0.0013316744650471821, 0.0008755839266840641, -0.00058833635146830342, 0.00039893953056171426
        },
        /* [307] 1.375 <= y <= 1.5 2^-2, degree 10, 61.3 bits */
        {
         0.40682758903636124, -8.2034529410544729e-18, -0.05079836033316483, 0.017063011144542006,
         -0.0076628590553181634, 0.0038979069452341462, -0.002124617482736511, 0.0012101201059674927,
         -0.00071057001505292472, 0.00042667932255339308, -0.00026162583225839277, 0.00016200327896252506
        },
        /* [308] 1.5 <= y <= 1.625 2^-2, degree 10, 62.4 bits */
        {
         0.40073032812255832, 2.4685590240192473e-17, -0.046863741090265844, 0.014517389042815037,
         -0.0060040245309747149, 0.0028114733522028356, -0.0014104492901042824, 0.00073932607217112693,
         -0.00039950121512003119, 0.00022074801492930684, -0.00012447806547364644, 7.0923512992845114e-05
        },
        /* [309] 1.625 <= y <= 1.75 2^-2, degree 10, 60.6 bits */
        {
         0.39508811407312416, -1.6430954270984382e-17, -0.043495464096555338, 0.01250438071968318,
         -0.0047928631729603011, 0.0020792586528090963, -0.00096623414583799972, 0.00046910573865511173,
         -0.00023476705246049614, 0.00012013841991436898, -6.2709323253403766e-05, 3.3087851907143574e-05
        },
        /* [310] 1.75 <= y <= 1.875 2^-2, degree 10, 61.5 bits */
        {
         0.38983768077757025, 7.0622049682833681e-18, -0.040578889600792832, 0.010884695069571565,
         -0.0038877025546277971, 0.0015710970009202368, -0.0006799955988133397, 0.00030745789243221696,
         -0.00014329109087823409, 6.8283230022572668e-05, -3.3177449370932573e-05, 1.6300643968431178e-05
        },
        /* [311] 1.875 <= y <= 2 2^-2, degree 10, 61.2 bits */
        {
         0.38492816369403593, 9.6369277897441558e-18, -0.038028455053292026, 0.0095618566706237515,
         -0.003197510759511509, 0.0012094164339370094, -0.00048985712303063842, 0.00020725429592084502,
         -9.0379289818348787e-05, 4.0297640927188754e-05, -1.8314013859236788e-05, 8.4185672866315337e-06
        },
        /* [312] 1 <= y <= 1.125 2^-1, degree 10, 59.3 bits */
        {
         0.37811429965141691, -2.7516155487672635e-17, -0.069501742986380621, 0.031958097945711132,
         -0.019510290908740343, 0.013466210084694485, -0.009951024986793346, 0.0076803406554463716,
         -0.0061092224459384026, 0.004968445712252776, -0.0041385680606446399, 0.0034701068182115776
        },
        /* [313] 1.125 <= y <= 1.25 2^-1, degree 10, 61.0 bits */
        {
         0.369890831642809, -2.7010082797003901e-17, -0.06233244571262047, 0.025734519394499222,
         -0.014076877654417518, 0.008700742357265031, -0.0057562319280867859, 0.0039769393845174436,
         -0.0028314941759666015, 0.0020610191529255948, -0.0015343325560275287, 0.0011513221653276203
        },
        /* [314] 1.25 <= y <= 1.375 2^-1, degree 10, 61.2 bits */
        {
         0.36247584636411984, 1.3282508620977827e-17, -0.056497061894144364, 0.021171904518998655,
         -0.01049167236371985, 0.0058717848517699017, -0.0035166408480211703, 0.0021991676720226625,
         -0.0014171317800851884, 0.0009335457139666533, -0.00062831082540268238, 0.0004266484334532207
        },
        /* [315] 1.375 <= y <= 1.5 2^-1, degree 10, 61.8 bits */
        {
         0.35572536707449937, 1.7020531709659087e-17, -0.051653934269270563, 0.01772655821975281,
         -0.0080300427058408244, 0.0041062882151509253, -0.0022465785181007758, 0.0012832589661848437,
         -0.00075525978967669436, 0.00045438934616080437, -0.00027907900980366472, 0.00017305860074135466
        },
        /* [316] 1.5 <= y <= 1.625 2^-1, degree 10, 61.0 bits */
        {
         0.34953085759776847, -7.0406462590365653e-18, -0.047569148594824855, 0.015060637831976231,
         -0.0062835564908555082, 0.0029581304643669227, -0.0014896502637418273, 0.00078311150833602981,
         -0.00042415252405776839, 0.0002348272126497171, -0.00013263950641682353, 7.5683484995359683e-05
        },
        /* [317] 1.625 <= y <= 1.75 2^-1, degree 10, 61.2 bits */
        {
         0.3438084434557292, 4.0969430189114764e-18, -0.044077105977869603, 0.012955153158742664,
         -0.005009920303331832, 0.0021852049537356573, -0.0010193629623039162, 0.00049635536795247987,
         -0.00024899314194040559, 0.0001276702590981509, -6.6753857922116774e-05, 3.5273706484994129e-05
        },
        /* [318] 1.75 <= y <= 1.875 2^-1, degree 10, 61.4 bits */
        {
         0.33849194864668319, 2.4765698238035344e-17, -0.04105724543796771, 0.011263057292949968,
         -0.0040591333410576087, 0.0016493667216664579, -0.00071664051402694346, 0.00032499023474884888,
         -0.00015182500501808075, 7.2494504296975477e-05, -3.5284016917778352e-05, 1.7361412227209367e-05
        },
        /* [319] 1.875 <= y <= 2 2^-1, degree 10, 60.7 bits */
        {
         0.33352823222103961, 1.6193875643614871e-17, -0.038419686405706949, 0.009882613567008338,
         -0.0033349139388658381, 0.0012683735118605753, -0.00051574972421598528, 0.00021886467834130675,
         -9.5673372576614041e-05, 4.2744230498172147e-05, -1.9459541801427244e-05, 8.9585787093915611e-06
        },
        /* [320] 1 <= y <= 1.125 2^0, degree 10, 58.8 bits */
        {
         0.32665145050870686, -1.6841370252923606e-17, -0.070069803102841374, 0.032975654903225064,
         -0.020317959229441931, 0.014102475990406586, -0.010462618586688352, 0.0080997967791484084,
         -0.0064586896634336709, 0.0052634090663359299, -0.0043920227457177529, 0.003688228473390336
        },
        /* [321] 1.125 <= y <= 1.25 2^0, degree 10, 60.6 bits */
        {
         0.31837143801091705, 1.131323097865016e-17, -0.062679561241329368, 0.02650019842504996,
         -0.014632516490524486, 0.0090959040519127156, -0.0060419955099373056, 0.0041873079131680467,
         -0.0029887163415561369, 0.0021799890996639423, -0.0016258146287415408, 0.0012218568096183135
        },
        /* [322] 1.25 <= y <= 1.375 2^0, degree 10, 60.7 bits */
        {
         0.31092403028209581, 4.6785748895217826e-18, -0.056676030136347408, 0.021761365021907356,
         -0.010887329142165138, 0.0061286338870110337, -0.0036855452635948405, 0.002312047882953379,
         -0.001493649132649031, 0.00098603228891569147, -0.00066484437705760339, 0.00045216607832615561
        },
        /* [323] 1.375 <= y <= 1.5 2^0, degree 10, 60.1 bits */
        {
         0.30415967546513939, -1.0411528144792432e-17, -0.05170226453811818, 0.018188797498706565,
         -0.0083198313932866062, 0.0042795726218468983, -0.0023511399338065645, 0.0013472722643959223,
         -0.00079497384801921456, 0.0004793080313404101, -0.00029492645142424259, 0.00018317733769921012
        },
        /* [324] 1.5 <= y <= 1.625 2^0, degree 10, 61.2 bits */
        {
         0.29796582054143866, -1.316053448592942e-18, -0.04751426599469747, 0.015428620938444309,
         -0.0065008414847446006, 0.0030787245903805202, -0.0015569255172658133, 0.00082112539921436417,
         -0.00044590040275955764, 0.00024740378795140084, -0.00014000396436325126, 8.0014652436676527e-05
        },
        /* [325] 1.625 <= y <= 1.75 2^0, degree 10, 60.9 bits */
        {
         0.29225561959988761, 1.4312575834068755e-17, -0.043939546392562132, 0.01325177262340442,
         -0.0051761015440371597, 0.0022713646817494972, -0.0010640848510692618, 0.00051982790847675752,
         -0.00026145551965494387, 0.00013435491736036209, -7.0381536947522838e-05, 3.7251419488698396e-05
        },
        /* [326] 1.75 <= y <= 1.875 2^0, degree 10, 62.4 bits */
        {
         0.28696064959966205, 2.21020301248879e-17, -0.040852698212562613, 0.011504641421482364,
         -0.0041884017390500256, 0.0017123264800978013, -0.00074721389789327974, 0.00033997698665196908,
         -0.00015924981728249914, 7.6208736941566594e-05, -3.7162493131047323e-05, 1.8315935957886468e-05
        },
        /* [327] 1.875 <= y <= 2 2^0, degree 10, 61.0 bits */
        {
         0.28202603834370948, 1.7531215782883846e-17, -0.038160345493115339, 0.01008107787895221,
         -0.0034369517762061247, 0.0013152868325374616, -0.00053716416011889874, 0.0002287150157544988,
         -0.00010024869270467661, 4.4888930902833003e-05, -2.0475272983097356e-05, 9.4419329976743953e-06
        },
        /* [328] 1 <= y <= 1.125 2^1, degree 10, 58.3 bits */
        {
         0.27520424111494046, 9.2054397235053275e-18, -0.069421562515762286, 0.033574514528086977,
         -0.020904008029578928, 0.014600652454572337, -0.010880303821909501, 0.0084517654076052395,
         -0.0067577721170548194, 0.005519688845397365, -0.0046149425900691623, 0.0038819869070878827
        },
        /* [329] 1.125 <= y <= 1.25 2^1, degree 10, 59.6 bits */
        {
         0.26701358133780906, 2.6745391199356364e-17, -0.061905637318971439, 0.026918957180799785,
         -0.015023170639110595, 0.0093987348143634228, -0.0062713881377090691, 0.0043613176938396897,
         -0.0031215811440998822, 0.0022821812219474425, -0.0017054309163078809, 0.0012838993373948508
        },
        /* [330] 1.25 <= y <= 1.375 2^1, degree 10, 60.6 bits */
        {
         0.2596687617472343, -1.1273324290640449e-17, -0.055813613927475102, 0.022058100328616707,
         -0.011156596187763108, 0.0063212800651733306, -0.0038188830289802656, 0.0024041185016163524,
         -0.0015575228387958696, 0.0010306210865283138, -0.00069631787864976287, 0.00047440040031391053
        },
        /* [331] 1.375 <= y <= 1.5 2^1, degree 10, 62.1 bits */
        {
         0.2530163628201757, 8.849806469250029e-18, -0.050776928805087586, 0.018400314505481845,
         -0.0085104913730884111, 0.0044067524814123977, -0.0024323238180267584, 0.001398768977350457,
         -0.00082772981905976134, 0.00050025055936154996, -0.0003084451736174207, 0.00019191397989864214
        },
        /* [332] 1.5 <= y <= 1.625 2^1, degree 10, 61.0 bits */
        {
         0.24694113618777699, -5.2038925922244738e-18, -0.046544085077385743, 0.015579147563107016,
         -0.0066388329008487644, 0.0031653071889500453, -0.001608300354946189, 0.00085129172452007664,
         -0.00046362746671868506, 0.00025786290925458377, -0.00014622626119877759, 8.372121911783719e-05
        },
        /* [333] 1.625 <= y <= 1.75 2^1, degree 10, 60.3 bits */
        {
         0.24135431000261265, 7.0194049381796229e-18, -0.042937583366508068, 0.013357766302248542,
         -0.0052777860049186614, 0.0023318539722933214, -0.0010976734769692505, 0.00053820388705946029,
         -0.00027149616092619005, 0.00013985693455460276, -7.3417957245734466e-05, 3.8929344941531345e-05
        },
        /* [334] 1.75 <= y <= 1.875 2^1, degree 10, 60.1 bits */
        {
         0.23618605673788071, 6.881483863828594e-18, -0.039828568538951815, 0.011577579670570895,
         -0.0042644492423504522, 0.0017555269714187129, -0.00076979507209751165, 0.00035155213630272208,
         -0.0001651631851907106, 7.9234852907501956e-05, -3.8720376326776438e-05, 1.9118938168631132e-05
        },
        /* [335] 1.875 <= y <= 2 2^1, degree 10, 60.8 bits */
        {
         0.23138046272036927, 9.6218899741963273e-18, -0.037121234072686284, 0.010129146220108461,
         -0.0034945210016408611, 0.0013467291039559951, -0.00055271561431559531, 0.00023622085550475377,
         -0.00010385109630668513, 4.6618772234468178e-05, -2.1310036692760793e-05, 9.8451893736117743e-06
        },
        /* [336] 1 <= y <= 1.125 2^2, degree 10, 58.3 bits */
        {
         0.224754844857637, -7.8652819543540509e-18, -0.067317947162696401, 0.033660180101782886,
         -0.021212818966784439, 0.014922546390481807, -0.01117592011904767, 0.0087145575190741703,
         -0.0069892586018842941, 0.0057233250019531751, -0.0047957334351068229, 0.0040416904174146893
        },
        /* [337] 1.125 <= y <= 1.25 2^2, degree 10, 59.2 bits */
        {
         0.21682794284678233, 9.2769557087075324e-18, -0.059792884520222384, 0.026914055517351421,
         -0.015208639017262975, 0.0095845342068415721, -0.006428103099376266, 0.0044877220979899326,
         -0.0032220966657555256, 0.002361791036418444, -0.0017688708654348437, 0.0013342236664648588
        },
        /* [338] 1.25 <= y <= 1.375 2^2, degree 10, 60.9 bits */
        {
         0.20974681954183463, 4.571498659852649e-18, -0.053709499385026116, 0.021998411906572216,
         -0.011269454451809142, 0.0064330400917597189, -0.0039066840310309128, 0.0024691539185645326,
         -0.0016047474915726967, 0.0010646782986448722, -0.00072096233173446858, 0.00049215285557776102
        },
        /* [339] 1.375 <= y <= 1.5 2^2, degree 10, 61.1 bits */
        {
         0.20335630670781374, -5.7991249855246747e-18, -0.048692249887768387, 0.018307278034807372,
         -0.008579000373308469, 0.0044761514195884675, -0.0024837568068403807, 0.0014341135063811287,
         -0.0008513907981243916, 0.00051593323138829101, -0.00031884811341200829, 0.00019878139508935016
        },
        /* [340] 1.5 <= y <= 1.625 2^2, degree 10, 60.7 bits */
        {
         0.19754009293648411, -8.723975572415212e-18, -0.04448539134763449, 0.015466037603026991,
         -0.0066794765396997764, 0.0032094599536243089, -0.0016395464828777761, 0.00087139051781943869,
         -0.00047613267999876052, 0.00026554047220110063, -0.00015093183214718599, 8.6589808752858256e-05
        },
        /* [341] 1.625 <= y <= 1.75 2^2, degree 10, 60.4 bits */
        {
         0.1922087666393657, 4.5991332459943138e-18, -0.040908762122878604, 0.013233010359674001,
         -0.005300545449837755, 0.0023604489335055704, -0.0011172340247481499, 0.00055007555783630018,
         -0.00027840957939487054, 0.00014381495861585515, -7.5674414422209651e-05, 4.0207907973229449e-05
        },
        /* [342] 1.75 <= y <= 1.875 2^2, degree 10, 60.2 bits */
        {
         0.18729212869290554, -9.537956874425256e-18, -0.037831801606294714, 0.011446627103858659,
         -0.0042755567700487381, 0.0017742663257643545, -0.00078234795653660315, 0.00035879358890723937,
         -0.00016913472567659118, 8.1367535965962674e-05, -3.9857840721314012e-05, 1.9721358605414677e-05
        },
        /* [343] 1.875 <= y <= 2 2^2, degree 10, 60.3 bits */
        {
         0.18273406693153474, -5.6330943084820759e-18, -0.035157593641741029, 0.0099955641550162674,
         -0.0034979679949589336, 0.0013590811495185638, -0.00056093808880584904, 0.00024076099644778777,
         -0.00010620926916056626, 4.7812634502645373e-05, -2.1908741443752773e-05, 1.0143011423352265e-05
        },
        /* [344] 1 <= y <= 1.125 2^3, degree 10, 58.3 bits */
        {
         0.17647192622413907, -4.9593779644044435e-19, -0.063491018867076296, 0.033126646073565975,
         -0.021185327445032549, 0.015027855866373323, -0.011319706429750637, 0.0088651727255394629,
         -0.0071348247865303267, 0.0058593944868314072, -0.0049219518013073659, 0.0041568980766242469
        },
        /* [345] 1.125 <= y <= 1.25 2^3, degree 10, 59.5 bits */
        {
         0.16901512931014762, -1.1663196373457467e-17, -0.05609737970586761, 0.026398366179115795,
         -0.015146121762812942, 0.0096272482623535709, -0.0064949356265891394, 0.0045546235632271375,
         -0.0032817792791633091, 0.0024126343968729996, -0.0018115247639206688, 0.0013693606051016231
        },
        /* [346] 1.25 <= y <= 1.375 2^3, degree 10, 59.3 bits */
        {
         0.1623880171832601, 1.2009856934517926e-17, -0.050139723458180178, 0.021509077196362959,
         -0.011193844340609155, 0.0064463139697632475, -0.0039384408721062775, 0.0025005806205857105,
         -0.0016310814662489415, 0.0010854056045867559, -0.00073689184385533038, 0.00050414144652091339
        },
        /* [347] 1.375 <= y <= 1.5 2^3, degree 10, 60.0 bits */
        {
         0.15643623054125114, 5.9275443871176076e-18, -0.045241193355438615, 0.017847021473452206,
         -0.0085006817971935798, 0.0044754443477724639, -0.0024987266334362923, 0.0014494726030107846,
         -0.00086369827300608961, 0.000524995334170821, -0.00032529838910693571, 0.00020326000638150752
        },
        /* [348] 1.5 <= y <= 1.625 2^3, degree 10, 61.2 bits */
        {
         0.15104435971741045, 7.4769879569401932e-18, -0.041145749054985026, 0.015034841068006859,
         -0.0066033420795531235, 0.0032022885184827014, -0.0016462121520511518, 0.00087908361518218082,
         -0.00048214865770734118, 0.00026973389914422612, -0.00015372329139076566, 8.8393390517582185e-05
        },
        /* [349] 1.625 <= y <= 1.75 2^3, degree 10, 59.9 bits */
        {
         0.14612389803358125, 5.9843544399465008e-18, -0.037673413062173373, 0.012829586458372167,
         -0.0052287827445638702, 0.0023505655267462423, -0.0011197187016603607, 0.0005539613345754889,
         -0.00028145225215423831, 0.00014584732493993005, -7.6951088843046962e-05, 4.0981386813300018e-05
        },
        /* [350] 1.75 <= y <= 1.875 2^3, degree 10, 61.2 bits */
        {
         0.14160551290750223, 1.6651385339596779e-18, -0.034694024253891426, 0.011069151596117249,
         -0.0042089951046510908, 0.0017635631222989859, -0.00078272831566147559, 0.00036073135077203716,
         -0.00017071129914038026, 8.2390221906275719e-05, -4.0469353090714058e-05, 2.0071204796961451e-05
        },
        /* [351] 1.875 <= y <= 2 2^3, degree 10, 59.5 bits */
        {
         0.1374339026456286, 9.9060902185094621e-18, -0.032111148854976283, 0.0096420446031317206,
         -0.0034367535697123115, 0.0013485019956689073, -0.00056028696253718029, 0.00024168213245892554,
         -0.00010703776632705017, 4.8342904994081721e-05, -2.2213227190806477e-05, 1.0308591691447928e-05
        },
        /* [352] 1 <= y <= 1.125 2^4, degree 10, 57.8 bits */
        {
         0.13173093253653126, -9.1837381089033726e-18, -0.05765090425779771, 0.031841600291767705,
         -0.020756523558209179, 0.014873683076697111, -0.011280271494856093, 0.0088794220888880632,
         -0.0071752064999171944, 0.0059121946765153706, -0.004980483311231308, 0.0042165849613791809
        },
        /* [353] 1.125 <= y <= 1.25 2^4, degree 10, 58.6 bits */
        {
         0.12498487221743303, 4.0446244139422953e-18, -0.050559580991424595, 0.025260469454268561,
         -0.014787956464418212, 0.0094990205454482234, -0.0064537022478375564, 0.0045495026944349978,
         -0.0032917140150759434, 0.0024282112525566744, -0.001828543334127732, 0.0013856834588708848
        },
        /* [354] 1.25 <= y <= 1.375 2^4, degree 10, 58.9 bits */
        {
         0.11903287476441578, -1.8316458180805057e-18, -0.044870562523425632, 0.020494252741315232,
         -0.01089361309995626, 0.0063421900631948844, -0.0039030206708990734, 0.0024914740110153874,
         -0.0016320669744855918, 0.0010898636152748458, -0.00074212448218946992, 0.00050901745930801681
        },
        /* [355] 1.375 <= y <= 1.5 2^4, degree 10, 59.5 bits */
        {
         0.1137244386213682, 6.542007842569994e-19, -0.040212437104755715, 0.016935680335677956,
         -0.0082473360560737907, 0.0043913158673982884, -0.0024701008589074272, 0.0014408021996045856,
         -0.00086227732994740571, 0.00052600777854809675, -0.00032691711083226462, 0.00020480380774598833
        },
        /* [356] 1.5 <= y <= 1.625 2^4, degree 10, 58.8 bits */
        {
         0.10894739774154757, -4.8413863267775251e-18, -0.036333576363864084, 0.014211145878144071,
         -0.0063879130551182271, 0.0031341283352719559, -0.0016235517291167106, 0.00087189969052205391,
         -0.00048034148690461592, 0.00026970515178815639, -0.00015418344058486995, 8.8893562053378398e-05
        },
        /* [357] 1.625 <= y <= 1.75 2^4, degree 10, 59.2 bits */
        {
         0.10461599219090426, 1.5511154365226912e-19, -0.033057572040260635, 0.012080704561998846,
         -0.0050441584710896195, 0.0022950060084814287, -0.0011018672204820136, 0.00054829190726460807,
         -0.00027984068395218179, 0.00014555289786187455, -7.7038200686599815e-05, 4.1138811566981124e-05
        },
        /* [358] 1.75 <= y <= 1.875 2^4, degree 10, 59.7 bits */
        {
         0.10066323346678932, 3.6878220702099092e-18, -0.030257162706859003, 0.010384623997388796,
         -0.0040495695105875465, 0.001717936918216737, -0.00076863395622997759, 0.00035633555791559496,
         -0.00016941470927787163, 8.2075121293480118e-05, -4.0444091624892075e-05, 2.0113911910891917e-05
        },
        /* [359] 1.875 <= y <= 2 2^4, degree 10, 61.1 bits */
        {
         0.09703583580742485, 3.4545040316870592e-18, -0.027838286154051588, 0.0090132841259532494,
         -0.0032980999936758656, 0.0013107378777816867, -0.00054909742089647394, 0.00023828885077267412,
         -0.00010603485571086144, 4.8075222236949671e-05, -2.2162389870910677e-05, 1.0313794337998853e-05
        },
        /* [360] 1 <= y <= 1.125 2^5, degree 10, 57.6 bits */
        {
         0.092112792348851835, 6.3691218181276402e-18, -0.049549364003625702, 0.029609382464878549,
         -0.019845667132998328, 0.014412025170241262, -0.011023576129301629, 0.0087314504618115872,
         -0.0070899824860045993, 0.0058651619059482945, -0.0049575349699922432, 0.004209174357018567
        },
        /* [361] 1.125 <= y <= 1.25 2^5, degree 10, 57.9 bits */
        {
         0.08634621977223815, -4.3752426615441384e-18, -0.042976717138956899, 0.023331064018624444,
         -0.014072945709838882, 0.0091682206095720989, -0.0062845185219174123, 0.0044588974545170168,
         -0.0032424098380496626, 0.0024016449397168613, -0.0018148150645688947, 0.0013793357811710157
        },
        /* [362] 1.25 <= y <= 1.375 2^5, degree 10, 58.3 bits */
        {
         0.081313253923993453, -5.3550265695843519e-19, -0.03773892712033397, 0.018804965387134023,
         -0.010320726673645135, 0.0060988587057245278, -0.0037881419982994653, 0.0024343406838650819,
         -0.0016029356623106915, 0.0010749315957326885, -0.00073456636055476874, 0.00050536053909410329
        },
        /* [363] 1.375 <= y <= 1.5 2^5, degree 10, 59.0 bits */
        {
         0.076870939904081337, 5.5230532231447655e-18, -0.033478040019156455, 0.015440464766965223,
         -0.0077801716570576936, 0.0042081555863806124, -0.0023899400799402351, 0.0014036970278971876,
         -0.00084457469397754964, 0.00051744744060399348, -0.00032277304406470181, 0.00020283656107860656
        },
        /* [364] 1.5 <= y <= 1.625 2^5, degree 10, 59.1 bits */
        {
         0.072913205943028789, 5.2524548385949851e-18, -0.029952424278443329, 0.012875385936547043,
         -0.0060011152363174643, 0.0029934503232344591, -0.0015662338758139715, 0.00084712837719977201,
         -0.0004692694237692948, 0.00026466435176621399, -0.00015186880648883594, 8.7838098195075208e-05
        },
        /* [365] 1.625 <= y <= 1.75 2^5, degree 10, 59.1 bits */
        {
         0.069359295932950094, -9.5354993791767484e-19, -0.026993262129539695, 0.010877840607234214,
         -0.004719624693512928, 0.0021850247192166336, -0.0010599824456286534, 0.0005313342821443147,
         -0.00027272336470885713, 0.00014250047551757068, -7.5711979787165877e-05, 4.0562455160230329e-05
        },
        /* [366] 1.75 <= y <= 1.875 2^5, degree 10, 59.8 bits */
        {
         0.066146389419270618, -2.7622724518894587e-18, -0.024479167289907306, 0.0092939096811958024,
         -0.0037740882947969821, 0.0016305982059817373, -0.00073742918768893737, 0.00034446100799589882,
         -0.00016472230547253034, 8.0176247010843447e-05, -3.9663405713235857e-05, 1.9791420005050949e-05
        },
        /* [367] 1.875 <= y <= 2 2^5, degree 10, 62.2 bits */
        {
         0.063224716411282397, -3.4950360271888604e-18, -0.022320702431931277, 0.0080182560606091476,
         -0.003061839154870025, 0.0012404101252506926, -0.00052544484342223344, 0.0002298024596093862,
         -0.00010286885790504292, 4.6863803161255278e-05, -2.1690554938563581e-05, 1.0128586341790622e-05
        },
        /* [368] 1 <= y <= 1.125 2^6, degree 10, 56.7 bits */
        {
         0.059302714042856246, 1.9436771559937218e-19, -0.039214069510843101, 0.026107181478909423,
         -0.018318992225378493, 0.013580171844425951, -0.010509673162815942, 0.008392003849850593,
         -0.0068565085317608496, 0.0057001928366778188, -0.0048381928823927785, 0.0041222471712621155
        },
        /* [369] 1.125 <= y <= 1.25 2^6, degree 10, 58.1 bits */
        {
         0.054776124575668286, 1.9151724425424928e-18, -0.033451338029051293, 0.020332307786658819,
         -0.012893413007864004, 0.0085915357948061558, -0.0059635513244950577, 0.0042673659962161213,
         -0.0031232196701533855, 0.0023253439243133291, -0.0017647668621974322, 0.001346180942936908
        },
        /* [370] 1.25 <= y <= 1.375 2^6, degree 10, 58.8 bits */
        {
         0.050889147649791369, 3.3399093952140323e-18, -0.028912092171774532, 0.016200106209428151,
         -0.0093859645990048961, 0.0056849002932857782, -0.0035787463148637391, 0.0023204686096845095,
         -0.0015382768299553441, 0.0010371295582383368, -0.00071191415544972776, 0.00049162450592427044
        },
        /* [371] 1.375 <= y <= 1.5 2^6, degree 10, 59.8 bits */
        {
         0.047511217701505661, 1.3810141981061285e-18, -0.025261600589958931, 0.013151043267727751,
         -0.0070236244134045797, 0.0039022317378152802, -0.0022482646977969975, 0.001332966829579729,
         -0.00080766075720607278, 0.00049759866082619501, -0.00031183265412003847, 0.00019672610746452007
        },
        /* [372] 1.5 <= y <= 1.625 2^6, degree 10, 60.5 bits */
        {
         0.044546173471343001, 1.6593386993459094e-18, -0.022275106194156524, 0.010843519077637889,
         -0.0053778713532953793, 0.002761717954413225, -0.0014673706171208561, 0.00080153363733485655,
         -0.00044726047225936475, 0.00025371290342909446, -0.00014628276829678388, 8.4948101435461878e-05
        },
        /* [373] 1.625 <= y <= 1.75 2^6, degree 10, 58.6 bits */
        {
         0.041921343853071398, -9.2039490460270162e-19, -0.019796393729336847, 0.0090597422686034875,
         -0.0041984096720087943, 0.0020057323125010759, -0.00098913974959597599, 0.00050099120571038872,
         -0.00025910271192450187, 0.00013619475040746405, -7.2719588768709113e-05, 3.9121095604957416e-05
        },
        /* [374] 1.75 <= y <= 1.875 2^6, degree 10, 61.0 bits */
        {
         0.039580614380742646, 1.1420262865196678e-18, -0.017713710979081459, 0.0076557389424477349,
         -0.0033325290898518775, 0.0014893045917174356, -0.00068548230494748714, 0.0003237021549793033,
         -0.00015601586098472909, 7.6408410752753917e-05, -3.7992042815286972e-05, 1.9038491362621245e-05
        },
        /* [375] 1.875 <= y <= 2 2^6, degree 10, 59.8 bits */
        {
         0.037479856428668641, -1.2949455906250548e-18, -0.015945134744803122, 0.0065333675177406706,
         -0.0026835524978970349, 0.0011272545941903975, -0.00048657631981870707, 0.00021525279367950084,
         -9.7143851779322085e-05, 4.4538140004739653e-05, -2.0722208193392145e-05, 9.7189497136722939e-06
        },
        /* [376] 1 <= y <= 1.125 2^7, degree 10, 56.0 bits */
        {
         0.034703432040260863, 3.0211973836962255e-18, -0.027502329745534838, 0.020932568031786919,
         -0.015875894639316799, 0.012248261002576762, -0.0096777350946683719, 0.0078237043701178902,
         -0.0064474040060783742, 0.0053958557296884084, -0.0046050964736065363, 0.0039415697108059486
        },
        /* [377] 1.125 <= y <= 1.25 2^7, degree 10, 57.5 bits */
        {
         0.031564426609409363, -2.2661601348275641e-19, -0.022928215613326072, 0.015963390134325538,
         -0.011005438827271067, 0.0076699228149596614, -0.005450926977060234, 0.0039543535831998849,
         -0.002921053728313357, 0.0021901953637627979, -0.0016718117204560319, 0.0012813961529773738
        },
        /* [378] 1.25 <= y <= 1.375 2^7, degree 10, 58.8 bits */
        {
         0.028928052632568362, 1.0462775943297593e-18, -0.019399327104819744, 0.012461760125836786,
         -0.0078894035105230177, 0.0050221359942928248, -0.0032469075269573057, 0.0021376410662414997,
         -0.0014313186969695485, 0.00097223281369913982, -0.00067140993687279699, 0.00046598381379886429
        },
        /* [379] 1.375 <= y <= 1.5 2^7, degree 10, 58.3 bits */
        {
         0.026683577300178299, -1.8221623671609472e-19, -0.016618074360607873, 0.0099176473760726712,
         -0.0058129227075881798, 0.0034103559952063127, -0.0020244788657767811, 0.0012208439250923258,
         -0.0007477883743681658, 0.00046435952278278881, -0.0002928455971770285, 0.0001857164987212715
        },
        /* [380] 1.5 <= y <= 1.625 2^7, degree 10, 58.6 bits */
        {
         0.024750703031181768, -7.2183501519708731e-19, -0.014386765947382685, 0.0080220183034940551,
         -0.0043820604884546059, 0.0023870192406971486, -0.0013111589783161601, 0.00072987836703548078,
         -0.00041211389118976242, 0.00023574087446016616, -0.00013682009734015512, 7.9886514674370139e-05
        },
        /* [381] 1.625 <= y <= 1.75 2^7, degree 10, 59.6 bits */
        {
         0.023069687967689777, 7.0820184773371717e-19, -0.012569498933275558, 0.0065793519177654155,
         -0.0033680667584382179, 0.001713999764139154, -0.00087684699048334717, 0.00045354972985516408,
         -0.00023761426851208125, 0.00012601839172631741, -6.7751506632065113e-05, 3.6654889288240457e-05
        },
        /* [382] 1.75 <= y <= 1.875 2^7, degree 10, 59.9 bits */
        {
         0.021595118040976118, 5.9180852677458324e-19, -0.011070141680390111, 0.0054614095031668463,
         -0.0026321922048320625, 0.0012579482124731778, -0.00060269728233047597, 0.00029131338077097423,
         -0.00014240618210453515, 7.0411811156150753e-05, -3.5264057855918678e-05, 1.7775272101751756e-05
        },
        /* [383] 1.875 <= y <= 2 2^7, degree 10, 58.6 bits */
        {
         0.020291833624733677, 1.0743286674285183e-18, -0.009819031518870442, 0.004581481158631078,
         -0.0020871169779542518, 0.00094088514771867261, -0.00042419808191363102, 0.00019253843300591202,
         -8.8253263549432871e-05, 4.0879210596917556e-05, -1.9164600778054348e-05, 9.0431743075668321e-06
        },
        /* [384] 1 <= y <= 1.125 2^8, degree 10, 55.4 bits */
        {
         0.018599147358622208, 1.1608665365194583e-18, -0.016597342746601289, 0.014324673153518671,
         -0.012068407366704795, 0.010038764063384524, -0.0083258752070938628, 0.0069319148334482973,
         -0.0058154783822276946, 0.0049233963937213932, -0.0042368585033470104, 0.0036497385126286587
        },
        /* [385] 1.125 <= y <= 1.25 2^8, degree 10, 56.5 bits */
        {
         0.016726952145011787, 4.1812033301644575e-19, -0.013512485885868415, 0.010599660438930285,
         -0.0081216123703470415, 0.0061326560452400298, -0.0046028549279733188, 0.003456702688593678,
         -0.0026086489643751039, 0.0019827081739537014, -0.0015276870523802607, 0.0011791406612835702
        },
        /* [386] 1.25 <= y <= 1.375 2^8, degree 10, 57.2 bits */
        {
         0.015189017392190194, -1.3094237222708887e-19, -0.011200408590386117, 0.008050268313172659,
         -0.0056587829948810927, 0.0039165674198139867, -0.0026885183059088247, 0.001841755733776908,
         -0.0012647421307059859, 0.00087299820569805954, -0.00060941335105417764, 0.00042624001761136342
        },
        /* [387] 1.375 <= y <= 1.5 2^8, degree 10, 58.1 bits */
        {
         0.013904580066938371, -5.9924475116827206e-19, -0.0094254741679531285, 0.0062489107961794677,
         -0.0040581246353796584, 0.0025943331058966537, -0.0016425644032314489, 0.0010357116608589421,
         -0.00065325737904376987, 0.00041340003264297916, -0.00026399396929919084, 0.00016888424727582054
        },
        /* [388] 1.5 <= y <= 1.625 2^8, degree 10, 58.0 bits */
        {
         0.012816695919728626, -4.6072860544356112e-19, -0.0080350342693090819, 0.0049416657385343375,
         -0.0029821024384529293, 0.0017719922664074423, -0.0010418782154986725, 0.00060914600575650874,
         -0.00035561887910478423, 0.00020795129440008111, -0.00012246561010007819, 7.2220310447700231e-05
        },
        /* [389] 1.625 <= y <= 1.75 2^8, degree 10, 60.8 bits */
        {
         0.011884108729786735, 7.8529551599858404e-20, -0.0069267292462488949, 0.0039711755620339111,
         -0.0022378237428465021, 0.0012424131836411519, -0.00068222940439862485, 0.00037210085564804866,
         -0.00020236043356313356, 0.00011006880889474978, -6.0187344078849375e-05, 3.2937815010509344e-05
        },
        /* [390] 1.75 <= y <= 1.875 2^8, degree 10, 60.0 bits */
        {
         0.011076230275307686, -6.8640213465277878e-19, -0.006029896670212205, 0.0032363868962347708,
         -0.0017102388714019794, 0.0008910717153813528, -0.00045913657336060109, 0.00023480499730790789,
         -0.00011959582235409476, 6.0848693490392605e-05, -3.1074479559082008e-05, 1.587189003550883e-05
        },
        /* [391] 1.875 <= y <= 2 2^8, degree 10, 59.2 bits */
        {
         0.010369925803650313, 8.5489651057432957e-19, -0.0052945263478100619, 0.0026704070243859664,
         -0.0013281980821499323, 0.00065190049623577227, -0.00031646454252428312, 0.00015240501647580861,
         -7.3036829676891666e-05, 3.4926474642439953e-05, -1.6741224317585883e-05, 8.0206020008925419e-06
        },
        /* [392] 1 <= y <= 1.125 2^9, degree 10, 54.5 bits */
        {
         0.0094630668603935264, 5.259169234082395e-19, -0.0088355644959133978, 0.0081698132569584369,
         -0.0074655803561864088, 0.0067413150083856692, -0.0060236358107380941, 0.0053379119527704926,
         -0.0047028856034433634, 0.0041295973868394576, -0.0036491656483767132, 0.0032018771738284049
        },
        /* [393] 1.125 <= y <= 1.25 2^9, degree 10, 56.2 bits */
        {
         0.0084731737627909282, 8.4034198609506571e-19, -0.0070968809686826418, 0.0059014902321203287,
         -0.0048617354249748945, 0.0039649409562714085, -0.0032027915345015714, 0.0025660744175814445,
         -0.0020428927273369226, 0.0016192443845302242, -0.0012880056887740604, 0.0010173107180153742
        },
        /* [394] 1.25 <= y <= 1.375 2^9, degree 10, 57.0 bits */
        {
         0.0076696580137957295, -6.8375789728878966e-20, -0.0058219149464338298, 0.0043957395419847488,
         -0.0032945124202159973, 0.002448418295212812, -0.0018042684500344582, 0.0013193748681284408,
         -0.00095858070451406991, 0.0006930065800084328, -0.00050182139419224184, 0.00036081942752371182
        },
        /* [395] 1.375 <= y <= 1.5 2^9, degree 10, 57.4 bits */
        {
         0.0070047147915522998, -2.6214043037480385e-19, -0.0048602661510367831, 0.0033588806646795907,
         -0.0023078305722174655, 0.001574625865607247, -0.0010664679569717063, 0.00071721530447587376,
         -0.00047932420241741903, 0.00031869023989410366, -0.00021195552267500015, 0.0001399842671591136
        },
        /* [396] 1.5 <= y <= 1.625 2^9, degree 10, 59.0 bits */
        {
         0.0064455109605370386, 1.6173311750876182e-19, -0.0041176059804853629, 0.0026225860142184169,
         -0.0016627486760884779, 0.0010481478633312872, -0.00065654105172395136, 0.00040864110615592152,
         -0.00025284791673985048, 0.00015565084110445514, -9.5765140156222188e-05, 5.8518145297278479e-05
        },
        /* [397] 1.625 <= y <= 1.75 2^9, degree 10, 59.0 bits */
        {
         0.0059687778697635587, 1.9151347488386012e-19, -0.0035324449884443919, 0.0020858456311997572,
         -0.00122721886608718, 0.00071863521016889988, -0.00041854412239736646, 0.00024239621989099295,
         -0.00013961939065801229, 8.0024391385451099e-05, -4.5817207341352487e-05, 2.6059446208099386e-05
        },
        /* [398] 1.75 <= y <= 1.875 2^9, degree 10, 59.0 bits */
        {
         0.0055575802099884939, -5.1504950968801576e-20, -0.0030633651071455725, 0.001685641948526304,
         -0.00092489973894072737, 0.00050552312149571954, -0.00027503538003261771, 0.00014889645695875556,
         -8.0210172569266703e-05, 4.3008436244482757e-05, -2.302877930932278e-05, 1.2253155037863752e-05
        },
        /* [399] 1.875 <= y <= 2 2^9, degree 10, 60.3 bits */
        {
         0.0051993068397062367, 1.5504490603223686e-19, -0.002681670357937131, 0.001381323654947161,
         -0.00070991479726699349, 0.00036369604800058468, -0.00018560074709281856, 9.4306704635554523e-05,
         -4.7705647688559461e-05, 2.402815649221107e-05, -1.2083587130732864e-05, 6.0405710680765844e-06
        },
        /* [400] 1 <= y <= 1.125 2^10, degree 10, 54.1 bits */
        {
         0.0047407864386858995, -1.6251310221607896e-19, -0.0044599742276593543, 0.0041920863604654728,
         -0.0039340051893656507, 0.0036831336360211068, -0.0034378692681223842, 0.0031977388050126098,
         -0.002963175227769023, 0.0027354970249662707, -0.0025368741230965834, 0.0023254775440074752
        },
        /* [401] 1.125 <= y <= 1.25 2^10, degree 10, 55.7 bits */
        {
         0.0042419126244844603, 3.2804440036570224e-19, -0.003571265632458835, 0.0030050481500447711,
         -0.0025260317097614451, 0.0021200095736098813, -0.0017754448722569363, 0.0014830139685229973,
         -0.0012351054680092731, 0.0010254714213305221, -0.00085442944414117856, 0.00070503791797239747
        },
        /* [402] 1.25 <= y <= 1.375 2^10, degree 10, 56.9 bits */
        {
         0.003837993163961152, -2.093508895940578e-19, -0.0029237739775688199, 0.0022265965371858695,
         -0.0016945483354169942, 0.0012882498085662333, -0.00097788322533851144, 0.00074086004776323453,
         -0.00056001392976064894, 0.00042226536553818328, -0.0003193208851793364, 0.00023951553704908425
        },
        /* [403] 1.375 <= y <= 1.5 2^10, degree 10, 57.2 bits */
        {
         0.0035042895765513868, 1.8361323722525641e-20, -0.0024375638920217323, 0.0016952094854271642,
         -0.0011784312017745666, 0.0008185908846494905, -0.00056801664057336255, 0.00039358303966131815,
         -0.00027224254834892314, 0.00018794089222173681, -0.000130065386271392, 8.9397475074904286e-05
        },
        /* [404] 1.5 <= y <= 1.625 2^10, degree 10, 58.7 bits */
        {
         0.0032239640135133373, -1.3506297080198816e-19, -0.0020632331706054662, 0.0013202315441671407,
         -0.00084455607257456452, 0.0005399928944360132, -0.000344995432982194, 0.00022018184119104045,
         -0.00014033718982624433, 8.930806210677783e-05, -5.6958676187338855e-05, 3.6116960206173976e-05
        },
        /* [405] 1.625 <= y <= 1.75 2^10, degree 10, 60.4 bits */
        {
         0.0029851610452039674, -1.5862960041745949e-19, -0.0017689294111929003, 0.0010481342037163598,
         -0.00062092718245561416, 0.00036771617954673959, -0.00021764325349500887, 0.00012871804740412424,
         -7.6049063254580884e-05, 4.4876589803659934e-05, -2.6534210351441798e-05, 1.5611775915292019e-05
        },
        /* [406] 1.75 <= y <= 1.875 2^10, degree 10, 58.4 bits */
        {
         0.0027792928070961591, -7.5661198370550783e-20, -0.0015333730207689788, 0.00084593607690771841,
         -0.00046662860984884798, 0.00025733517166030145, -0.00014185814866527513, 7.8155315843960482e-05,
         -4.3025644984020493e-05, 2.366369316142827e-05, -1.303847042057255e-05, 7.1538853005483063e-06
        },
        /* [407] 1.875 <= y <= 2 2^10, degree 10, 60.0 bits */
        {
         0.0025999863224430322, -1.8983359113619737e-19, -0.0013419117077413001, 0.00069256581506867685,
         -0.00035740442137707475, 0.00018440984373570534, -9.5122485515803371e-05, 4.9045091871644626e-05,
         -2.5272713939242036e-05, 1.3013214821648631e-05, -6.7119249086232894e-06, 3.4493562274737829e-06
        },
        /* [408] 1 <= y <= 1.125 2^11, degree 10, 53.9 bits */
        {
         0.0023705777797406557, 1.6407491332660832e-19, -0.0022311174429309362, 0.0020998194181374094,
         -0.0019761478671925358, 0.0018595683002798984, -0.001749552111330463, 0.0016455871920549861,
         -0.0015471515058800825, 0.0014538899414779701, -0.0013772058373562514, 0.0012923544324370713
        },
        /* [409] 1.125 <= y <= 1.25 2^11, degree 10, 55.5 bits */
        {
         0.0021210443352691162, 4.0369568217160534e-20, -0.0017861374260790275, 0.0015040971927020518,
         -0.0012665607938227232, 0.0010664805698229103, -0.00089791978698088937, 0.00075588145963084068,
         -0.00063615315319059571, 0.00053522811881352988, -0.00045325589828085016, 0.00038099615258333945
        },
        /* [410] 1.25 <= y <= 1.375 2^11, degree 10, 56.8 bits */
        {
         0.0019190405019709009, 1.8075860656623647e-20, -0.0014621241349500444, 0.0011139927172435461,
         -0.00084874044274059479, 0.00064662883537575588, -0.00049261969640208489, 0.00037525719851899382,
         -0.0002858124194615732, 0.00021764694943846331, -0.0001666374374583007, 0.00012681882357584506
        },
        /* [411] 1.375 <= y <= 1.5 2^11, degree 10, 57.6 bits */
        {
         0.0017521675669906218, -7.5155871501272065e-20, -0.0012188983890852351, 0.00084792679468404159,
         -0.00058985639705717071, 0.00041032452386335964, -0.00028542721221579007, 0.00019853641339133708,
         -0.0001380845411022379, 9.6028459153169976e-05, -6.7086533040782738e-05, 4.6635873552378406e-05
        },
        /* [412] 1.5 <= y <= 1.625 2^11, degree 10, 58.4 bits */
        {
         0.0016119942243629434, 1.0668735178118427e-19, -0.0010316759710924822, 0.00066027161029599552,
         -0.00042257165050026043, 0.0002704421139046171, -0.0001730775060156692, 0.00011076261166404351,
         -7.0879546391943473e-05, 4.5354191691711976e-05, -2.9134339236407885e-05, 1.8637593951122915e-05
        },
        /* [413] 1.625 <= y <= 1.75 2^11, degree 10, 59.5 bits */
        {
         0.0014925872718635767, 6.8399443033040386e-20, -0.00088449601461327285, 0.00052414536113728691,
         -0.00031060378451466125, 0.00018406007418796938, -0.00010907066179374578, 6.4632060397882063e-05,
         -3.8297671716655039e-05, 2.2692224922504106e-05, -1.3490920995349529e-05, 7.9923097404451242e-06
        },
        /* [414] 1.75 <= y <= 1.875 2^11, degree 10, 58.5 bits */
        {
         0.0013896502308063897, 1.2836142315946954e-20, -0.00076670350857388828, 0.00042300864591221147,
         -0.00023338371420723002, 0.00012876285704936216, -7.1040822443029557e-05, 3.9194061640728937e-05,
         -2.1623325770210862e-05, 1.1929225624114669e-05, -6.6004554610108419e-06, 3.6409469194671821e-06
        },
        /* [415] 1.875 <= y <= 2 2^11, degree 10, 60.6 bits */
        {
         0.0012999953828785849, 7.7080324825037166e-20, -0.00067096532716464491, 0.00034630460024034362,
         -0.00017873769847143856, 9.2251476656218044e-05, -4.7613364143327694e-05, 2.457430547214288e-05,
         -1.2683148085361714e-05, 6.5458332212609922e-06, -3.3870387570069417e-06, 1.7479335876343673e-06
        },
        /* [416] 1 <= y <= 1.125 2^12, degree 10, 53.9 bits */
        {
         0.001185289911371884, -7.6225869267723692e-20, -0.0011155669535379427, 0.0010499452576339002,
         -0.00098818337920940792, 0.000930053839560707, -0.00087534219382301394, 0.00082384600949680909,
         -0.00077535373983340504, 0.00072972701091186256, -0.00069276523541132089, 0.00065197046035026527
        },
        /* [417] 1.125 <= y <= 1.25 2^12, degree 10, 55.6 bits */
        {
         0.0010605225536840491, -1.450579796854622e-20, -0.00089307161837349201, 0.00075206028294408627,
         -0.00063331383206454274, 0.00053331667434995114, -0.00044910826361005716, 0.00037819542401181091,
         -0.00031847322293370589, 0.00026818518697191608, -0.00022741076367051495, 0.00019149793401115688
        },
        /* [418] 1.25 <= y <= 1.375 2^12, degree 10, 57.2 bits */
        {
         0.00095952040610156996, 5.2374608917735289e-21, -0.00073106316488553058, 0.00055700049918188657,
         -0.00042438130968183615, 0.0003233380841763143, -0.00024635271166455609, 0.00018769709375633081,
         -0.00014300535110519933, 0.00010895595229227775, -8.3486623887489854e-05, 6.3607939499192245e-05
        },
        /* [419] 1.375 <= y <= 1.5 2^12, degree 10, 57.8 bits */
        {
         0.0008760838491652025, -4.5343141092032201e-20, -0.0006094496336835262, 0.00042396496038891351,
         -0.00029493213997016185, 0.00020517016954665315, -0.00014272704652335875, 9.9288331531557892e-05,
         -6.9069527209241309e-05, 4.8048263810474772e-05, -3.3583455276644611e-05, 2.336224048827979e-05
        },
        /* [420] 1.5 <= y <= 1.625 2^12, degree 10, 58.3 bits */
        {
         0.00080599714126917174, 4.5971986718524633e-21, -0.00051583817024054639, 0.00033013642827004266,
         -0.00021128731218660274, 0.00013522387562141003, -8.6543273001201047e-05, 5.538768242756608e-05,
         -3.5447899807023679e-05, 2.2686632739747559e-05, -1.4577727182387283e-05, 9.3297129556117741e-06
        },
        /* [421] 1.625 <= y <= 1.75 2^12, degree 10, 58.9 bits */
        {
         0.00074629364933597082, -1.6790825000834295e-20, -0.00044224808843523533, 0.00026207294106653462,
         -0.00015530248298871045, 9.2031099766534661e-05, -5.4536945914743114e-05, 3.2318186819382831e-05,
         -1.9151434452986956e-05, 1.134899253038325e-05, -6.7484651635701707e-06, 3.9990833736312717e-06
        },
        /* [422] 1.75 <= y <= 1.875 2^12, degree 10, 58.5 bits */
        {
         0.00069482512180010444, 4.3867856956779457e-20, -0.00038335179131585386, 0.00021150443650765457,
         -0.00011669210269685773, 6.4381849358068354e-05, -3.5521019707229244e-05, 1.9597802999022401e-05,
         -1.0812546158616197e-05, 5.9655412141794343e-06, -3.3011445786859584e-06, 1.8213194615594492e-06
        },
        /* [423] 1.875 <= y <= 2 2^12, degree 10, 61.5 bits */
        {
         0.00064999769458890379, -1.2369738301532385e-20, -0.00033548268106963478, 0.00017315235149015909,
         -8.9368955535748754e-05, 4.6125912397290271e-05, -2.3806922330153847e-05, 1.2287443481000569e-05,
         -6.3418908781980036e-06, 3.2732335807478751e-06, -1.6938168272116792e-06, 8.7422760913102882e-07
        },
        /* [424] 1 <= y <= 1.125 2^13, degree 10, 53.8 bits */
        {
         0.0005926449568318784, 5.3678781360788982e-22, -0.0005577834887785844, 0.00052497269529233094,
         -0.00049409194837198999, 0.00046502771564325361, -0.00043767315701280138, 0.0004119276735213455,
         -0.00038768638290226359, 0.00036488128361372751, -0.00034641430555324782, 0.000326036927914175
        },
        /* [425] 1.125 <= y <= 1.25 2^13, degree 10, 55.6 bits */
        {
         0.00053026127716560706, 2.8895311231987945e-20, -0.00044653581234918783, 0.0003760301577628442,
         -0.00031665697493547107, 0.00026665850513917433, -0.00022455453420493069, 0.00018909855465375764,
         -0.00015923819560099392, 0.00013409532065884576, -0.00011370983587022745, 9.5755645209638803e-05
        },
        /* [426] 1.25 <= y <= 1.375 2^13, degree 10, 56.8 bits */
        {
         0.00047976020314988155, 2.171769002331549e-20, -0.00036553158335212761, 0.00027850025398163308,
         -0.0002121906696959774, 0.00016166908166136902, -0.00012317644426842005, 9.3848719373841434e-05,
         -7.1502977209345596e-05, 5.4478458575714351e-05, -4.1744040797888172e-05, 3.1804982795413006e-05
        },
        /* [427] 1.375 <= y <= 1.5 2^13, degree 10, 58.4 bits */
        {
         0.00043804192461511924, -2.5865252678334004e-20, -0.00030472481712352447, 0.00021198248147703448,
         -0.00014746607407004089, 0.00010258509500302424, -7.1363544722898503e-05, 4.9644205013130788e-05,
         -3.4534827879472135e-05, 2.4024228053191832e-05, -1.6791863042756387e-05, 1.1681295943440768e-05
        },
        /* [428] 1.5 <= y <= 1.625 2^13, degree 10, 58.3 bits */
        {
         0.00040299857064591199, 1.7708254376242205e-20, -0.00025791908521337472, 0.00016506821453651343,
         -0.00010564365730313478, 6.7611940673543861e-05, -4.3271642169023055e-05, 2.7693850986036738e-05,
         -1.772396497445332e-05, 1.1343337577543496e-05, -7.2888916067779744e-06, 4.6648906156770296e-06
        },
        /* [429] 1.625 <= y <= 1.75 2^13, degree 10, 59.5 bits */
        {
         0.00037314682467214132, 1.1941379957769077e-20, -0.00022112404425015547, 0.0001310364706667472,
         -7.7651241876524485e-05, 4.6015550741539476e-05, -2.726847456845195e-05, 1.6159096040127872e-05,
         -9.5757210647349534e-06, 5.6745013705754277e-06, -3.374238941388113e-06, 1.999549000226126e-06
        },
        /* [430] 1.75 <= y <= 1.875 2^13, degree 10, 59.5 bits */
        {
         0.00034741256090164898, 5.5514549449268776e-21, -0.00019167589566987465, 0.0001057522183006174,
         -5.8346051476181187e-05, 3.219092495235033e-05, -1.7760510341881096e-05, 9.798902257493043e-06,
         -5.4062741299905668e-06, 2.9827719335636748e-06, -1.6505738544032941e-06, 9.1066143653561376e-07
        },
        /* [431] 1.875 <= y <= 2 2^13, degree 10, 58.3 bits */
        {
         0.00032499884729509103, 1.8581992564787363e-21, -0.00016774134053940161, 8.6576175762270927e-05,
         -4.4684477812777125e-05, 2.3062956290458981e-05, -1.190346132169701e-05, 6.1437219724658349e-06,
         -3.1709457456186782e-06, 1.6366171589804211e-06, -8.4690882711933544e-07, 4.3711423327727007e-07
        }
    };
    return row[i];
}

/* eps at zero force by x = beta^5, 2^-40 <= x < 2^20: 480 rows of degree 10 in y = beta^5 2^-k, 8 to each octave k = -40 ... 19.
 * Relative error of the approximation: 2^-57.4 at most, proved for the whole cell of each row. */
#define COR_ROWS_POWER_EPS_ZERO_FORCE_FIRST 9.094947017729282e-13
#define COR_ROWS_POWER_EPS_ZERO_FORCE_FIRST_OCTAVE (-40)
#define COR_ROWS_POWER_EPS_ZERO_FORCE_OCTAVE_BITS 3
#define COR_ROWS_POWER_EPS_ZERO_FORCE_ROWS 480
#define COR_ROWS_POWER_EPS_ZERO_FORCE_END 1048576.0
COR_INLINE const double *cor_rows_power_eps_zero_force(int i)
{
    static const double row[480][12] = {
        /* [0] 1 <= y <= 1.125 2^-40, degree 10, 67.1 bits */
        {
         0.99545208476332847, 3.8845378114093214e-17, -0.00085366801001037916, 0.00032183680245433279,
         -0.00018182864562944382, 0.00011982513985185991, -8.5725940861772115e-05, 6.4555464284635376e-05,
         -5.0347131069216391e-05, 4.0281281561656087e-05, -3.3083822460129551e-05, 2.7407210444812672e-05
        },
        /* [1] 1.125 <= y <= 1.25 2^-40, degree 10, 69.6 bits */
        {
         0.99535007669050946, -9.4029045287371654e-18, -0.00078088992529952927, 0.00026341827839881753,
         -0.00013315960236107334, 7.8515628071045614e-05, -5.0259430003531759e-05, 3.3863745257351963e-05,
         -2.3630640264344881e-05, 1.6916105621068514e-05, -1.2414166196518807e-05, 9.2013024734140122e-06
        },
        /* [2] 1.25 <= y <= 1.375 2^-40, degree 10, 68.6 bits */
        {
         0.99525633903699307, -5.5186725773060725e-17, -0.00072071953240937785, 0.0002199731235240471,
         -0.00010060852867255966, 5.3672913150721979e-05, -3.1085123160186522e-05, 1.8949841384685944e-05,
         -1.1964175564119233e-05, 7.7489504024503455e-06, -5.1400224958428578e-06, 3.4468464961850414e-06
        },
        /* [3] 1.375 <= y <= 1.5 2^-40, degree 10, 68.9 bits */
        {
         0.99516950189656983, 1.3300074091854336e-18, -0.00067005772499437437, 0.00018673210661871632,
         -7.7979349032895488e-05, 3.7983387960213907e-05, -2.0085568566885943e-05, 1.1179689322717875e-05,
         -6.4446624740292298e-06, 3.8111193268780134e-06, -2.3064512176495034e-06, 1.4121664992470403e-06
        },
        /* [4] 1.5 <= y <= 1.625 2^-40, degree 10, 71.1 bits */
        {
         0.99508851876680582, 4.1891159367736849e-17, -0.00062675586525080091, 0.00016069567920720554,
         -6.1738538330329367e-05, 2.7666892220500036e-05, -1.3459845655100114e-05, 6.892465390683003e-06,
         -3.6553947186835127e-06, 1.9887272093205258e-06, -1.1066423509917115e-06, 6.2334953500978179e-07
        },
        /* [5] 1.625 <= y <= 1.75 2^-40, degree 10, 70.5 bits */
        {
         0.99501257093906537, 4.1860759214652869e-17, -0.00058927505083761818, 0.00013989770420911061,
         -4.9767113740597147e-05, 2.0650221623579467e-05, -9.3021217132181683e-06, 4.4105605789844053e-06,
         -2.1658625918145999e-06, 1.0910603275436442e-06, -5.6190477493311153e-07, 2.9306191711015968e-07
        },
        /* [6] 1.75 <= y <= 1.875 2^-40, degree 10, 70.1 bits */
        {
         0.99494100503147809, -5.158434693352056e-17, -0.00055648272986992249, 0.00012300418433008813,
         -4.0739978724328264e-05, 1.573876663874929e-05, -6.6007766851469361e-06, 2.9138925761934508e-06,
         -1.3322245366296476e-06, 6.2482974762951197e-07, -2.9949254609957234e-07, 1.4542710825278562e-07
        },
        /* [7] 1.875 <= y <= 2 2^-40, degree 10, 72.6 bits */
        {
         0.99487329071190167, -5.0339372272286799e-17, -0.00052752596855571235, 0.00010908315944339981,
         -3.3798546871833039e-05, 1.2214789875179019e-05, -4.7923425951627374e-06, 1.9790809751978313e-06,
         -8.4645652902375888e-07, 3.713862616800848e-07, -1.6647930894033603e-07, 7.5622926062930615e-08
        },
        /* [8] 1 <= y <= 1.125 2^-39, degree 10, 66.5 bits */
        {
         0.99477800582051168, -1.1977342935517341e-17, -0.00097977900775706177, 0.00036946044819712785,
         -0.00020874948634292005, 0.00013757155640844079, -9.8424901115857718e-05, 7.4119885860949062e-05,
         -5.7807421459075983e-05, 4.6250669373768009e-05, -3.7987039377134346e-05, 3.1469430411976425e-05
        },
        /* [9] 1.125 <= y <= 1.25 2^-39, degree 10, 68.4 bits */
        {
         0.99466092939100259, 1.2948720575857536e-17, -0.00089623221128750936, 0.00030239311727711811,
         -0.00015287274275208938, 9.0142931086111049e-05, -5.7703933926009952e-05, 3.888051995186411e-05,
         -2.7131878587976042e-05, 1.9422752342176755e-05, -1.4253878930983473e-05, 1.0564992657879317e-05
        },
        /* [10] 1.25 <= y <= 1.375 2^-39, degree 10, 68.6 bits */
        {
         0.99455334706048149, -1.7919852128486202e-19, -0.00082715957758089712, 0.00025251656166211823,
         -0.00011550140535798877, 6.162061215935631e-05, -3.5689131825153715e-05, 2.1756967994837152e-05,
         -1.3736719243312129e-05, 8.8971161051168332e-06, -5.901693077055301e-06, 3.9576557546229e-06
        },
        /* [11] 1.375 <= y <= 1.5 2^-39, degree 10, 68.7 bits */
        {
         0.9944536861277623, 4.4713112133366199e-17, -0.00076900307227953737, 0.000214355145623462,
         -8.9521500250166228e-05, 4.3607396646389214e-05, -2.3060216277417588e-05, 1.2835670500518763e-05,
         -7.3994014888904622e-06, 4.3757772836289113e-06, -2.6482089605973486e-06, 1.621430876139085e-06
        },
        /* [12] 1.5 <= y <= 1.625 2^-39, degree 10, 68.5 bits */
        {
         0.99436074518447115, -4.3483124951704705e-18, -0.00071929590500649607, 0.00018446507122854618,
         -7.087607868207094e-05, 3.1763090529018527e-05, -1.5453094445413617e-05, 7.9133380050161053e-06,
         -4.1968855210262943e-06, 2.283360125980971e-06, -1.2706088747429815e-06, 7.1571624275411368e-07
        },
        /* [13] 1.625 <= y <= 1.75 2^-39, degree 10, 70.5 bits */
        {
         0.99427358434462487, 2.3470622322480487e-17, -0.00067627132289714055, 0.00016058902696247559,
         -5.7132293290216191e-05, 2.3707363404682111e-05, -1.0679570045383112e-05, 5.0637871188269834e-06,
         -2.486682806383799e-06, 1.2526931719939817e-06, -6.4515512350147657e-07, 3.3648485651592861e-07
        },
        /* [14] 1.75 <= y <= 1.875 2^-39, degree 10, 68.6 bits */
        {
         0.99419145352651583, 1.6547634851890317e-17, -0.00063862909995025124, 0.00014119547103589653,
         -4.67687865181898e-05, 1.8068646513024147e-05, -7.5781530247215505e-06, 3.3454297167103163e-06,
         -1.529550286276332e-06, 7.1738877761851442e-07, -3.4386221644435513e-07, 1.669738986321653e-07
        },
        /* [15] 1.875 <= y <= 2 2^-39, degree 10, 69.4 bits */
        {
         0.99411374391506746, -4.447642632259347e-17, -0.00060539003414628576, 0.0001252144431392311,
         -3.8799813866344786e-05, 1.4022889273448686e-05, -5.5019032675869217e-06, 2.2721596205079213e-06,
         -9.7182485003707579e-07, 4.2639864316406748e-07, -1.911418905128159e-07, 8.6826827829878778e-08
        },
        /* [16] 1 <= y <= 1.125 2^-38, degree 10, 66.6 bits */
        {
         0.99400439574158284, -1.6583310578232173e-17, -0.0011243763065162328, 0.00042409076011609101,
         -0.00023963587417973208, 0.00015793389231199851, -0.0001129966381910191, 8.5095315285511983e-05,
         -6.6368610921808258e-05, 5.310114896479336e-05, -4.3614121281636223e-05, 3.6131458648757255e-05
        },
        /* [17] 1.125 <= y <= 1.25 2^-38, degree 10, 67.0 bits */
        {
         0.99387004248811184, -2.0616980571308874e-17, -0.0010284766340190462, 0.00034710075183577688,
         -0.00017548907651927123, 0.00010348381775601248, -6.6246105915362515e-05, 4.4637268345207247e-05,
         -3.1149696492323555e-05, 2.229932142967404e-05, -1.6365144520481279e-05, 1.2130006275070462e-05
        },
        /* [18] 1.25 <= y <= 1.375 2^-38, degree 10, 68.2 bits */
        {
         0.99374658700557983, 5.5504950167282711e-17, -0.00094919247734119084, 0.0002898457217621552,
         -0.00013258714737995054, 7.0739393375323555e-05, -4.0971867970499928e-05, 2.4978076167827979e-05,
         -1.5770745293843266e-05, 1.021469766958582e-05, -6.775773737865696e-06, 4.5438652400778279e-06
        },
        /* [19] 1.375 <= y <= 1.5 2^-38, degree 10, 68.3 bits */
        {
         0.99363222393436623, -1.2385710887137255e-17, -0.00088243924425937678, 0.00024603947947553554,
         -0.00010276283255895579, 5.0059952920557501e-05, -2.6473318364182146e-05, 1.4735829943566205e-05,
         -8.4949607679247453e-06, 5.0237404084835151e-06, -3.0403974044693431e-06, 1.8615803675517589e-06
        },
        /* [20] 1.5 <= y <= 1.625 2^-38, degree 10, 69.6 bits */
        {
         0.99352557415325038, -1.1756241635115088e-17, -0.00082538511581029873, 0.00021172849003287396,
         -8.1358572058887933e-05, 3.6462657735896392e-05, -1.7740097815583151e-05, 9.084718855901813e-06,
         -4.8182329427746956e-06, 2.6214549674812672e-06, -1.4587675511351746e-06, 8.2171350147683313e-07
        },
        /* [21] 1.625 <= y <= 1.75 2^-38, degree 10, 69.7 bits */
        {
         0.99342555876110505, 2.6624247091588893e-17, -0.00077600192316942004, 0.00018432135181611518,
         -6.558137645536026e-05, 2.7214753685222475e-05, -1.225999067416365e-05, 5.8133063911674558e-06,
         -2.8548099380379818e-06, 1.438165789964153e-06, -7.4068697758213794e-07, 3.8631494245632116e-07
        },
        /* [22] 1.75 <= y <= 1.875 2^-38, degree 10, 68.6 bits */
        {
         0.99333131674418218, -1.2579993161278663e-17, -0.00073279706944945398, 0.00016205986714918469,
         -5.3684693746992277e-05, 2.074161688855032e-05, -8.6995302296061162e-06, 3.8405719974995081e-06,
         -1.7559693381066668e-06, 8.2359801574440436e-07, -3.9477675718180745e-07, 1.9169960113186692e-07
        },
        /* [23] 1.875 <= y <= 2 2^-38, degree 10, 69.0 bits */
        {
         0.99324214925525012, -5.2658686767732461e-17, -0.00069464648905927858, 0.0001437157418098053,
         -4.4536877801989627e-05, 1.609720777210104e-05, -6.315993168705741e-06, 2.608430485152539e-06,
         -1.1156750558516707e-06, 4.8952309420324879e-07, -2.1944199210270665e-07, 9.9683522229819885e-08
        },
        /* [24] 1 <= y <= 1.125 2^-37, degree 10, 66.5 bits */
        {
         0.99311668050383828, -2.6375865620544044e-17, -0.0012901232230629197, 0.00048674552865440374,
         -0.00027506540539242548, 0.00018129375086365447, -0.00012971463355777318, 9.7687963093129906e-05,
         -7.6191688961588751e-05, 6.096163194059181e-05, -5.0071022096106624e-05, 4.1481123073760498e-05
        },
        /* [25] 1.125 <= y <= 1.25 2^-37, degree 10, 67.7 bits */
        {
         0.99296252390493023, -2.4873534761646247e-17, -0.0011800564561461355, 0.00039837347195889849,
         -0.00020143125935814782, 0.000118788149148123, -7.6046170605307141e-05, 5.1242089565395372e-05,
         -3.5759606363120597e-05, 2.5599915419098485e-05, -1.8787696212753032e-05, 1.3925811860468081e-05
        },
        /* [26] 1.25 <= y <= 1.375 2^-37, degree 10, 68.2 bits */
        {
         0.99282087487307069, 5.0036661873427103e-17, -0.0010890614594397867, 0.00033265504555792251,
         -0.00015218485634738922, 8.1199944279747392e-05, -4.703236568500673e-05, 2.8673619953089717e-05,
         -1.8104462899871098e-05, 1.1726464202073303e-05, -7.7787066051382153e-06, 5.2165079489396428e-06
        },
        /* [27] 1.375 <= y <= 1.5 2^-37, degree 10, 68.9 bits */
        {
         0.99268966117996527, 6.5282103701999106e-18, -0.0010124495933975534, 0.00028237415379059371,
         -0.00011795050526658056, 5.7461773022443167e-05, -3.0388827240256071e-05, 1.6915812895447874e-05,
         -9.7519108737551101e-06, 5.7671842454119603e-06, -3.4903906911194281e-06, 2.1371328782532191e-06
        },
        /* [28] 1.5 <= y <= 1.625 2^-37, degree 10, 68.2 bits */
        {
         0.992567299866421, 1.89711828543503e-17, -0.00094697030326541614, 0.00024299248311159726,
         -9.3381576908656215e-05, 4.1853471021181857e-05, -2.0363688007891772e-05, 1.0428572122024385e-05,
         -5.5310985579770051e-06, 3.0093620423176989e-06, -1.6746547999802558e-06, 9.4333463178063783e-07
        },
        /* [29] 1.625 <= y <= 1.75 2^-37, degree 10, 70.3 bits */
        {
         0.99245255258416332, 3.8984350116978618e-17, -0.00089029554919920547, 0.00021153536734621424,
         -7.5271907477062968e-05, 3.1237946568995562e-05, -1.407296954894997e-05, 6.6731664730600103e-06,
         -3.2771502699053034e-06, 1.650960475323221e-06, -8.5029515978332988e-07, 4.4348889948870507e-07
        },
        /* [30] 1.75 <= y <= 1.875 2^-37, degree 10, 68.3 bits */
        {
         0.99234443108614867, 4.2122891079024134e-17, -0.00084071207022850647, 0.00018598459736550845,
         -6.1616595238621252e-05, 2.3807614365351575e-05, -9.9858921035382854e-06, 4.4085960798866515e-06,
         -2.0157278232934824e-06, 9.4545082755748354e-07, -4.5319238956411085e-07, 2.2006885501611773e-07
        },
        /* [31] 1.875 <= y <= 2 2^-37, degree 10, 68.8 bits */
        {
         0.99224213326536148, -1.4208801625357015e-18, -0.00079692963481979389, 0.00016493024775518072,
         -5.1116614713916904e-05, 1.8476481784518992e-05, -7.2498399904368632e-06, 2.9941913518909598e-06,
         -1.2807038525728866e-06, 5.6194393692052004e-07, -2.5191093366065905e-07, 1.1443452849440364e-07
        },
        /* [32] 1 <= y <= 1.125 2^-36, degree 10, 66.8 bits */
        {
         0.99209819161410429, -7.4194855057628106e-18, -0.0014800516398396904, 0.00055858614040337656,
         -0.00031569767956168349, 0.00020808710486979988, -0.00014889142703051605, 0.00011213354336765177,
         -8.7460711217699622e-05, 6.9979521443782036e-05, -5.7478909190724682e-05, 4.7618873041253925e-05
        },
        /* [33] 1.125 <= y <= 1.25 2^-36, degree 10, 67.5 bits */
        {
         0.99192134311908386, 4.6005335254649338e-17, -0.0013537410689245758, 0.00045716084172168678,
         -0.00023118188563791374, 0.00013634134898730238, -8.7287213561082291e-05, 5.8818534711672704e-05,
         -4.1047930174464514e-05, 2.9386390830018132e-05, -2.1566967595102416e-05, 1.5986109309544915e-05
        },
        /* [34] 1.25 <= y <= 1.375 2^-36, degree 10, 67.5 bits */
        {
         0.99175884792557445, 5.4826674126128531e-17, -0.0012493191188132052, 0.00038173670986846748,
         -0.00017465884036197121, 9.3197223192346951e-05, -5.3983776667408604e-05, 3.2912687498500897e-05,
         -2.078154640513098e-05, 1.3460731908253456e-05, -8.9292908598895508e-06, 5.9881999044335345e-06
        },
        /* [35] 1.375 <= y <= 1.5 2^-36, degree 10, 67.1 bits */
        {
         0.99160832776342489, -4.9351769995597952e-17, -0.0011614043507978367, 0.00032403102495031386,
         -0.00013536665866974946, 6.5950723253506947e-05, -3.4879804365342768e-05, 1.9416351456557371e-05,
         -1.1193762392513677e-05, 6.6200266738217615e-06, -4.0066193226215421e-06, 2.4532540947917848e-06
        },
        /* [36] 1.5 <= y <= 1.625 2^-36, degree 10, 67.8 bits */
        {
         0.99146796592223518, 3.8042864861781369e-17, -0.0010862659649330715, 0.00027883473767240807,
         -0.00010716830466959035, 4.8035881915617083e-05, -2.3372793333296269e-05, 1.1969994125769752e-05,
         -6.3488094726414366e-06, 3.4543397711804431e-06, -1.9223133012978558e-06, 1.0828585722839876e-06
        },
        /* [37] 1.625 <= y <= 1.75 2^-36, degree 10, 67.9 bits */
        {
         0.9913363412133559, 5.2815894389937852e-17, -0.0010212320112474868, 0.00024273359287229799,
         -8.638368939952884e-05, 3.5851794492636271e-05, -1.6152300349250486e-05, 7.6594173385521993e-06,
         -3.7615957969230327e-06, 1.8950571781332969e-06, -9.7603127114005594e-07, 5.0907759093143072e-07
        },
        /* [38] 1.75 <= y <= 1.875 2^-36, degree 10, 70.4 bits */
        {
         0.9912123194936765, 4.7896358149706632e-17, -0.00096433616471134612, 0.0002134111663575933,
         -7.0711582363847597e-05, 2.7323653473999683e-05, -1.1461204724520737e-05, 5.0600997125940706e-06,
         -2.3136775275832007e-06, 1.08522527762194e-06, -5.202020566362461e-07, 2.5261279733380453e-07
        },
        /* [39] 1.875 <= y <= 2 2^-36, degree 10, 68.7 bits */
        {
         0.99109498025330878, 4.6524421236485162e-17, -0.0009140976346019476, 0.00018924921933550172,
         -5.8660977319206436e-05, 2.1204934350252624e-05, -8.3208342129533983e-06, 3.4366363116844538e-06,
         -1.469992365897132e-06, 6.4501454442261978e-07, -2.8915596127534594e-07, 1.3135591243214263e-07
        },
        /* [40] 1 <= y <= 1.125 2^-35, degree 10, 66.1 bits */
        {
         0.99092987797689935, 1.8572196193739119e-17, -0.0016976080283982674, 0.00064093644246199135,
         -0.00036228524494003928, 0.00023881161792489294, -0.00017088390759788409, 0.00012870128789744097,
         -0.00010038594862730718, 8.0323243895798899e-05, -6.5976251315423218e-05, 5.4659515069539299e-05
        },
        /* [41] 1.125 <= y <= 1.25 2^-35, degree 10, 66.9 bits */
        {
         0.99072703755298197, -8.9699623032485252e-18, -0.0015526777612301175, 0.00052454505520079387,
         -0.00026529146615436502, 0.00015646918018734696, -0.00010017827060892698, 6.7507704432540568e-05,
         -4.7113272092423544e-05, 3.3729417570894375e-05, -2.4754873334718912e-05, 1.8349410635223355e-05
        },
        /* [42] 1.25 <= y <= 1.375 2^-35, degree 10, 67.0 bits */
        {
         0.99054066608210456, 7.2993640128769653e-18, -0.0014328656877117718, 0.00043799338505149781,
         -0.00020042461526882327, 0.0001069537114468883, -6.195527380421968e-05, 3.777417065888471e-05,
         -2.3851878345601234e-05, 1.5449847787022388e-05, -1.0249004963231685e-05, 6.8733570323574387e-06
        },
        /* [43] 1.375 <= y <= 1.5 2^-35, degree 10, 68.5 bits */
        {
         0.99036803441805066, -4.3236081811041497e-17, -0.001331995964746276, 0.00037177553965266557,
         -0.00015533304657808111, 7.5684112934941905e-05, -4.0029645955389417e-05, 2.2283952325406359e-05,
         -1.2847364907716422e-05, 7.59816507165495e-06, -4.5987143212805181e-06, 2.815846081580002e-06
        },
        /* [44] 1.5 <= y <= 1.625 2^-35, degree 10, 68.7 bits */
        {
         0.99020705786566821, -3.1336521212586039e-17, -0.0012457871346030296, 0.00031991331630438119,
         -0.00012297327351236148, 5.5124380669583396e-05, -2.6823256873656999e-05, 1.3737636024051847e-05,
         -7.2865839493632161e-06, 3.9646780890608601e-06, -2.2063609711000258e-06, 1.2428888811349021e-06
        },
        /* [45] 1.625 <= y <= 1.75 2^-35, degree 10, 67.3 bits */
        {
         0.99005610562590651, 2.3963135203843665e-17, -0.0011711729268396099, 0.00027848838542878808,
         -9.9121718775707087e-05, 4.1141686422750832e-05, -1.8536548555982072e-05, 8.7903805547118161e-06,
         -4.3171575373372313e-06, 2.1750010231704704e-06, -1.1202386222804048e-06, 5.8430430831652014e-07
        },
        /* [46] 1.75 <= y <= 1.875 2^-35, degree 10, 67.1 bits */
        {
         0.98991387630422922, 5.2072234307488846e-17, -0.0011058968672235062, 0.00024484237120514404,
         -8.1137337278430641e-05, 3.1354767458242056e-05, -1.3152815548816297e-05, 5.8071794190129063e-06,
         -2.6553576747409196e-06, 1.2455226975218983e-06, -5.9705399530463747e-07, 2.8993811689693834e-07
        },
        /* [47] 1.875 <= y <= 2 2^-35, degree 10, 69.2 bits */
        {
         0.98977931366105154, -3.6349731223232052e-17, -0.0010482596867969832, 0.00021711817656551265,
         -6.7308974925130955e-05, 2.4333003126900027e-05, -9.5488180676809141e-06, 3.9439761312932925e-06,
         -1.6870579736767842e-06, 7.4028020939596824e-07, -3.3187054661775679e-07, 1.5076298379293378e-07
        },
        /* [48] 1 <= y <= 1.125 2^-34, degree 10, 66.9 bits */
        {
         0.98958998236404749, 1.3621690347606604e-17, -0.0019467035323521248, 0.00073530361609069135,
         -0.00041568577135573227, 0.00027403480955957984, -0.00019609922508416158, 0.00014769843751385377,
         -0.00011520741472898681, 9.2185087221957317e-05, -7.5721161023998039e-05, 6.2734161353877118e-05
        },
        /* [49] 1.125 <= y <= 1.25 2^-34, degree 10, 66.9 bits */
        {
         0.98935738308726473, 5.4136192706478122e-17, -0.0017804370973907341, 0.00060175790976468423,
         -0.00030438729265309028, 0.00017954306762929604, -0.00011495777708224418, 7.747059419336823e-05,
         -5.406816679126635e-05, 3.8709665821779396e-05, -2.8410684531625076e-05, 2.1059691524190527e-05
        },
        /* [50] 1.25 <= y <= 1.375 2^-34, degree 10, 68.2 bits */
        {
         0.98914367700838335, 3.2202531610592016e-17, -0.0016429905479706044, 0.00050245232338557615,
         -0.00022995556742589712, 0.0001227230347719554, -7.109417504388254e-05, 4.3348071859316253e-05,
         -2.7372380622149797e-05, 1.7730731201875671e-05, -1.1762367720982203e-05, 7.8884383386987273e-06
        },
        /* [51] 1.375 <= y <= 1.5 2^-34, degree 10, 69.1 bits */
        {
         0.98894573282081255, 5.3093886602593453e-18, -0.0015272773772855449, 0.00042647862708358801,
         -0.00017821617547866274, 8.6841245888584346e-05, -4.593344965363538e-05, 2.5571664777295792e-05,
         -1.4743353041139521e-05, 8.7197417082563933e-06, -5.2776686781823022e-06, 3.2316465694577438e-06
        },
        /* [52] 1.5 <= y <= 1.625 2^-34, degree 10, 68.4 bits */
        {
         0.98876115868943204, -2.1219794988079156e-17, -0.0014283849083285749, 0.00036697683702387852,
         -0.00014108635871166113, 6.3249447056025002e-05, -3.0778748781904952e-05, 1.576417554264549e-05,
         -8.3617835109485293e-06, 4.5498364635217408e-06, -2.5320681699535096e-06, 1.4263974230255707e-06
        },
        /* [53] 1.625 <= y <= 1.75 2^-34, degree 10, 68.7 bits */
        {
         0.98858808358854366, 4.5210341770609068e-17, -0.0013427948782240601, 0.00031945075819548679,
         -0.0001137194366979071, 4.7204923894387207e-05, -2.1269679648608019e-05, 1.0086950106570907e-05,
         -4.9541144125772605e-06, 2.4959777881548539e-06, -1.2855913151691131e-06, 6.7056524856349324e-07
        },
        /* [54] 1.75 <= y <= 1.875 2^-34, degree 10, 67.5 bits */
        {
         0.98842501445038433, 4.0663031163894095e-17, -0.001267918239200506, 0.00028085001843666384,
         -9.3084783493923919e-05, 3.597505317360243e-05, -1.5091897644280916e-05, 6.6636285917399215e-06,
         -3.0470862161474396e-06, 1.4293107803807542e-06, -6.8517250574512241e-07, 3.3273718680880334e-07
        },
        /* [55] 1.875 <= y <= 2 2^-34, degree 10, 67.1 bits */
        {
         0.98827073949225552, 4.9221941234011112e-17, -0.0012018053075517306, 0.00024904371414634797,
         -7.7218863936574344e-05, 2.7918148494955409e-05, -1.0956407008315624e-05, 4.5255723794275147e-06,
         -1.9359121363521615e-06, 8.4950368525246929e-07, -3.808458999885356e-07, 1.7301555100609885e-07
        },
        /* [56] 1 <= y <= 1.125 2^-33, degree 10, 66.5 bits */
        {
         0.98805367957786749, 4.5977918430325787e-17, -0.0022317678457572212, 0.00084340110620530998,
         -0.00047687550597953396, 0.00031440311172831615, -0.00022500136202965306, 0.00016947524334528884,
         -0.00013219879853881172, 0.00010578436876294405, -8.6894011531233866e-05, 7.1992408208360734e-05
        },
        /* [57] 1.125 <= y <= 1.25 2^-33, degree 10, 67.7 bits */
        {
         0.98778702582321642, 7.0853870562447713e-18, -0.0020410616303798801, 0.00069019942643722403,
         -0.00034918322576465006, 0.00020598599617183336, -0.00013189739878619137, 8.8890703569090613e-05,
         -6.2040915794208895e-05, 4.4419129747267254e-05, -3.2602005885662641e-05, 2.4167119244153195e-05
        },
        /* [58] 1.25 <= y <= 1.375 2^-33, degree 10, 69.1 bits */
        {
         0.98754204206326379, 2.5285877627541216e-17, -0.0018834167060863794, 0.00057628079557806228,
         -0.00026379030300072815, 0.00014079397235931715, -8.1568300318558652e-05, 4.9736956925398722e-05,
         -3.1407939784740113e-05, 2.0345477449222122e-05, -1.3497341061805825e-05, 9.0522173988982735e-06
        },
        /* [59] 1.375 <= y <= 1.5 2^-33, degree 10, 68.0 bits */
        {
         0.98731513620713496, 3.5135779972970308e-17, -0.0017507029559758463, 0.00048912971404085329,
         -0.00020443296780615653, 9.9626242647941953e-05, -5.2699529963959156e-05, 2.9339933785871128e-05,
         -1.6916642646747038e-05, 1.0005439317931414e-05, -6.0560173359274875e-06, 3.7083397335614839e-06
        },
        /* [60] 1.5 <= y <= 1.625 2^-33, degree 10, 69.5 bits */
        {
         0.98710356452524184, -2.502223115085801e-19, -0.0016372843675296048, 0.00042087560249108965,
         -0.00016183725205877187, 7.2559595906917244e-05, -3.5311777133953009e-05, 1.8086840643730736e-05,
         -9.5941932043827292e-06, 5.2205975106542636e-06, -2.9054437221420722e-06, 1.6367730825077841e-06
        },
        /* [61] 1.625 <= y <= 1.75 2^-33, degree 10, 68.8 bits */
        {
         0.98690518077403377, -1.1389433212776986e-17, -0.0015391247473706378, 0.00036636001121341679,
         -0.00013044230508924343, 5.4152240671422935e-05, -2.4401754674408559e-05, 1.1572926119394522e-05,
         -5.6841786533747478e-06, 2.8638978614014415e-06, -1.4751377593798864e-06, 7.694523342820571e-07
        },
        /* [62] 1.75 <= y <= 1.875 2^-33, degree 10, 67.2 bits */
        {
         0.98671827230333709, 4.6029441709372941e-17, -0.001453253973065474, 0.00032208334364322897,
         -0.00010677099926821472, 4.1268824210501185e-05, -1.7313941238123661e-05, 7.645157112463407e-06,
         -3.4960611935205589e-06, 1.6399714893967977e-06, -7.8618106475605866e-07, 3.8179935040955813e-07
        },
        /* [63] 1.875 <= y <= 2 2^-33, degree 10, 69.5 bits */
        {
         0.98654144914644659, -3.8154586239632175e-17, -0.001377435437861551, 0.00028560092780666608,
         -8.8570553701504854e-05, 3.2025744746188804e-05, -1.2569345194966925e-05, 5.192086038576407e-06,
         -2.2211245721406358e-06, 9.7469356501927743e-07, -4.3698377597129371e-07, 1.985237711168105e-07
        },
        /* [64] 1 <= y <= 1.125 2^-32, degree 10, 66.1 bits */
        {
         0.98629267369899465, -3.2792544701914319e-19, -0.0025578063220448389, 0.00096717358169433668,
         -0.00054696403561350232, 0.00036065184664024383, -0.00025811839435312925, 0.00019443050351968964,
         -0.00015167182540734984, 0.0001213709524482556, -9.9700345240036399e-05, 8.2604759536438082e-05
        },
        /* [65] 1.125 <= y <= 1.25 2^-32, degree 10, 68.4 bits */
        {
         0.98598707255537543, -1.106948157639547e-17, -0.0023391173926542272, 0.00079145808578153594,
         -0.00040049041863719531, 0.00023627900077700847, -0.00015130625973642329, 0.00010197692186145829,
         -7.1177621617429541e-05, 5.0962595746386817e-05, -3.7405860776517669e-05, 2.7728861703945072e-05
        },
        /* [66] 1.25 <= y <= 1.375 2^-32, degree 10, 68.9 bits */
        {
         0.98570632063169195, 3.5051623831370615e-17, -0.0021583476817319614, 0.00066080284056705177,
         -0.0003025406895825277, 0.00016149486341920241, -9.3568569865895164e-05, 5.7057560201074161e-05,
         -3.6032431035820938e-05, 2.334202663773493e-05, -1.5485776913971133e-05, 1.0386083865627164e-05
        },
        /* [67] 1.375 <= y <= 1.5 2^-32, degree 10, 65.9 bits */
        {
         0.98544629808980666, 1.9840743375250654e-17, -0.0020061715403862932, 0.00056085082678395326,
         -0.00023445695129927519, 0.00011427113919355161, -6.0451087269640185e-05, 3.3657541709556416e-05,
         -1.9406979468450374e-05, 1.1478808385731441e-05, -6.9480367175884536e-06, 4.2546791249371727e-06
        },
        /* [68] 1.5 <= y <= 1.625 2^-32, degree 10, 67.8 bits */
        {
         0.98520385819087608, -2.3556805177276095e-17, -0.0018761243678172043, 0.00048257364188844211,
         -0.00018560033003621777, 8.3223620829877483e-05, -4.0504800206271488e-05, 2.0747987060079806e-05,
         -1.1006331245343583e-05, 5.9892369600582043e-06, -3.3333302049914425e-06, 1.8778757825633805e-06
        },
        /* [69] 1.625 <= y <= 1.75 2^-32, degree 10, 68.0 bits */
        {
         0.98497653951380015, -3.8853208263076852e-17, -0.0017635767062517572, 0.00042005413825520573,
         -0.00014959170663648405, 6.2109468060282262e-05, -2.7989694944144317e-05, 1.3275382609799494e-05,
         -6.5206784048814133e-06, 3.2854890664892272e-06, -1.6923488438646287e-06, 8.8277850203529373e-07
        },
        /* [70] 1.75 <= y <= 1.875 2^-32, degree 10, 67.7 bits */
        {
         0.98476237795710975, 4.1829458885442973e-17, -0.0016651219514626176, 0.00036927809830062541,
         -0.00012244239141571882, 4.7331873401973037e-05, -1.9859293668994224e-05, 8.7696331790102186e-06,
         -4.0104725594828529e-06, 1.8813539890982033e-06, -9.0192789462021263e-07, 4.3802341963387972e-07
        },
        /* [71] 1.875 <= y <= 2 2^-32, degree 10, 70.3 bits */
        {
         0.98455977951938978, -2.6478625124853563e-17, -0.0015781948706249187, 0.00032744141957930369,
         -0.00010156822486101283, 3.67300549711292e-05, -1.4416895676395267e-05, 5.9556410233806435e-06,
         -2.5478940039494462e-06, 1.1181356145656913e-06, -5.0131063044264924e-07, 2.2775462414754862e-07
        },
        /* [72] 1 <= y <= 1.125 2^-31, degree 10, 65.9 bits */
        {
         0.98427475237198481, 3.958781116456126e-17, -0.0029304593294784687, 0.0011088237958056576,
         -0.00062721033069086142, 0.00041361612835884813, -0.00029605045179473228, 0.00022301764885502114,
         -0.00017398105967998391, 0.00013922912844600057, -0.00011437408630953649, 9.4765306652802914e-05
        },
        /* [73] 1.125 <= y <= 1.25 2^-31, degree 10, 66.1 bits */
        {
         0.98392463802850449, -2.3363313279492843e-17, -0.0026797472121256063, 0.0009073325579088444,
         -0.0004592289515314785, 0.00027096824671750137, -0.00017353557091209741, 0.00011696669571255219,
         -8.1644425238524209e-05, 5.8459260115952124e-05, -4.2909888415689524e-05, 3.1809981117449226e-05
        },
        /* [74] 1.25 <= y <= 1.375 2^-31, degree 10, 66.6 bits */
        {
         0.98360301103558645, -1.2835598614800926e-17, -0.0024725158864081359, 0.00075751721624188516,
         -0.000346900566872412, 0.0001851984075603317, -0.0001073118453203179, 6.5442544393185006e-05,
         -4.1329843299231922e-05, 2.6774899829694963e-05, -1.7763909719189586e-05, 1.1914376167400051e-05
        },
        /* [75] 1.375 <= y <= 1.5 2^-31, degree 10, 66.3 bits */
        {
         0.98330514738708696, 1.9649907860593889e-17, -0.002298070707050519, 0.00064291167558606943,
         -0.00026882495317336172, 0.000131039258134115, -6.9328030573609018e-05, 3.8602639580967297e-05,
         -2.2259541301793646e-05, 1.3166626976258801e-05, -7.9699644160659818e-06, 4.8806231905539011e-06
        },
        /* [76] 1.5 <= y <= 1.625 2^-31, degree 10, 65.9 bits */
        {
         0.98302743900855583, 6.1778630665839307e-19, -0.0021489983223142539, 0.00055316156903148397,
         -0.0002127999115118574, 9.5433032125677396e-05, -4.6451439802978154e-05, 2.3795730105665377e-05,
         -1.2623788514964388e-05, 6.8697103397928279e-06, -3.8235087690017617e-06, 2.1540959815279412e-06
        },
        /* [77] 1.625 <= y <= 1.75 2^-31, degree 10, 70.9 bits */
        {
         0.98276706370958711, -1.8302429280474477e-17, -0.0020199900144173442, 0.00048148092027213492,
         -0.00017150915103997653, 7.1219342202094972e-05, -3.2098115291666747e-05, 1.5225069389950143e-05,
         -7.4787577446520344e-06, 3.7683985252960298e-06, -1.9411708803745778e-06, 1.0126055316794819e-06
        },
        /* [78] 1.75 <= y <= 1.875 2^-31, degree 10, 68.4 bits */
        {
         0.98252176958105542, 5.5430672078080793e-17, -0.0019071394554674029, 0.00042326622038538713,
         -0.00014037811395918199, 5.4272841409654507e-05, -2.2773747142284652e-05, 1.0057347335818709e-05,
         -4.5996245495301587e-06, 2.1578326801063262e-06, -1.0345140412637275e-06, 5.0243141820298508e-07
        },
        /* [79] 1.875 <= y <= 2 2^-31, degree 10, 67.0 bits */
        {
         0.98228972909931134, 4.4862129683656715e-17, -0.0018075051914290088, 0.00037530180414246543,
         -0.00011644314618592726, 4.2115286708946277e-05, -1.6532264695324538e-05, 6.8300025479291975e-06,
         -2.9221255146358032e-06, 1.2824270984450017e-06, -5.7499315457117353e-07, 2.6123902684691737e-07
        },
        /* [80] 1 <= y <= 1.125 2^-30, degree 10, 66.2 bits */
        {
         0.98196329700683549, -3.6738460917956717e-17, -0.0033560622962677273, 0.0012708410643282456,
         -0.00071903997491621556, 0.00047424264923000563, -0.00033947836232994631, 0.00025575137248090091,
         -0.00019952914947144726, 0.00015968185835075747, -0.00013118106176068, 0.00010869466958538447
        },
        /* [81] 1.125 <= y <= 1.25 2^-30, degree 10, 66.3 bits */
        {
         0.98156234804742848, -4.5423218157307466e-17, -0.0030687243627513013, 0.0010398546770039906,
         -0.00052644029850357709, 0.00031067266963806132, -0.00019898364787887833, 0.00013412947419678625,
         -9.3629945774408965e-05, 6.7044496534661739e-05, -4.9213654126600174e-05, 3.6484413535308534e-05
        },
        /* [82] 1.25 <= y <= 1.375 2^-30, degree 10, 66.1 bits */
        {
         0.98119404727370452, 9.8549624082409407e-18, -0.0028312310606435484, 0.00086811632843949017,
         -0.00039765506095975874, 0.00021232683537864691, -0.00012304400443184454, 7.5042411657445901e-05,
         -4.7395504204518804e-05, 3.0706002261741589e-05, -2.0372894781245599e-05, 1.3664745714207339e-05
        },
        /* [83] 1.375 <= y <= 1.5 2^-30, degree 10, 66.5 bits */
        {
         0.98085297938667104, 5.116648333355597e-17, -0.002631320874062306, 0.00073674552185739402,
         -0.00030814424412333298, 0.00015022883368918968, -7.9488947078828687e-05, 4.4263865420874577e-05,
         -2.5525592748325115e-05, 1.5099292847763812e-05, -9.140239033144529e-06, 5.5974834516579045e-06
        },
        /* [84] 1.5 <= y <= 1.625 2^-30, degree 10, 66.9 bits */
        {
         0.98053500849063535, -2.153040825221553e-17, -0.002460494648240801, 0.00063387007557877731,
         -0.00024391585830694566, 0.00010940467401693898, -5.3257790413333216e-05, 2.7284628873313438e-05,
         -1.4475597237932245e-05, 7.8778561652127591e-06, -4.3848134392429215e-06, 2.470419654744597e-06
        },
        /* [85] 1.625 <= y <= 1.75 2^-30, degree 10, 69.2 bits */
        {
         0.98023689966382133, -1.282028167994559e-17, -0.0023126663358392016, 0.00055170954047595549,
         -0.00019658074763297462, 8.164344131506391e-05, -3.6800221897341173e-05, 1.7456846736214822e-05,
         -8.5755936304898829e-06, 4.3213033989264239e-06, -2.2260832722620339e-06, 1.1612744089942889e-06
        },
        /* [86] 1.75 <= y <= 1.875 2^-30, degree 10, 66.5 bits */
        {
         0.97995607175881128, -4.7416488127708516e-17, -0.0021833577732015756, 0.00048498593776890854,
         -0.00016089369711488161, 6.2214681564882018e-05, -2.6109171187679555e-05, 1.153129767880451e-05,
         -5.2740682588325867e-06, 2.4743702229150456e-06, -1.1863239264604121e-06, 5.7618356075141316e-07
        },
        /* [87] 1.875 <= y <= 2 2^-30, degree 10, 65.9 bits */
        {
         0.97969043013089174, 2.4314376449753046e-17, -0.0020691970207039347, 0.00043001257728628417,
         -0.00013345665985627805, 4.8276720255358634e-05, -1.895305768542548e-05, 7.8307695714450433e-06,
         -3.350514260714219e-06, 1.4705140176100224e-06, -6.593551606478511e-07, 2.9957957872346518e-07
        },
        /* [88] 1 <= y <= 1.125 2^-29, degree 10, 65.4 bits */
        {
         0.97931674919097467, -3.7513706796844003e-17, -0.0038417041188809559, 0.00145603086716093,
         -0.00082406338271803835, 0.00054360225225961415, -0.00038917292542589333, 0.00029321477076524436,
         -0.00022877249363825299, 0.00018309537363392914, -0.00015042282361707685, 0.00012464319547095723
        },
        /* [89] 1.125 <= y <= 1.25 2^-29, degree 10, 67.5 bits */
        {
         0.9788577990177395, 2.2160089928866534e-17, -0.0035125043383237992, 0.0011913132318442036,
         -0.00060330047029589617, 0.00035609210457829629, -0.0002281012812302107, 0.00015377041185378725,
         -0.00010734791138121922, 7.6871767069612191e-05, -5.6430069115976783e-05, 4.1836032175177728e-05
        },
        /* [90] 1.25 <= y <= 1.375 2^-29, degree 10, 66.1 bits */
        {
         0.97843625243851473, 7.2176048341331106e-18, -0.0032404266586611046, 0.00099450576214073802,
         -0.00045569037679759575, 0.00024335739697103195, -0.00014104322500004194, 8.602755374995604e-05,
         -5.4337398662671524e-05, 3.5205490279722961e-05, -2.3359390631729222e-05, 1.5668551630153241e-05
        },
        /* [91] 1.375 <= y <= 1.5 2^-29, degree 10, 66.0 bits */
        {
         0.97804590365177513, -2.9766744612368636e-17, -0.0030114172227516697, 0.00084396549431848178,
         -0.00035310002952411489, 0.00017217685097479778, -9.1113201572283557e-05, 5.0741541715789835e-05,
         -2.9263188777223085e-05, 1.7311245978082305e-05, -1.0479759223268565e-05, 6.4180848613755317e-06
        },
        /* [92] 1.5 <= y <= 1.625 2^-29, degree 10, 66.4 bits */
        {
         0.97768201324666382, 2.6458982291094814e-18, -0.0028157349330631678, 0.00072608376091001271,
         -0.00027948943337030005, 0.0001253834907248283, -6.1043811995917572e-05, 3.1276417584269819e-05,
         -1.6594626494812416e-05, 9.0316145480482994e-06, -5.0272543868599371e-06, 2.8324985175982344e-06
        },
        /* [93] 1.625 <= y <= 1.75 2^-29, degree 10, 66.0 bits */
        {
         0.97734087442119066, -3.370353350038246e-17, -0.0026464047021585797, 0.00063194245196478789,
         -0.00022524187261340582, 9.3564228967908788e-05, -4.217876573227851e-05, 2.0010149239470306e-05,
         -9.8306282765386359e-06, 4.9540298575707119e-06, -2.5521606216762657e-06, 1.3314380931684866e-06
        },
        /* [94] 1.75 <= y <= 1.875 2^-29, degree 10, 67.0 bits */
        {
         0.97701952963625838, 1.4476491662014205e-17, -0.0024982944000723952, 0.00055549206012783087,
         -0.00018434482554463753, 7.1296201887989768e-05, -2.9924183133404681e-05, 1.3217493722951678e-05,
         -6.0457434360481301e-06, 2.8365851497051862e-06, -1.3600582073602484e-06, 6.605943976077657e-07
        },
        /* [95] 1.875 <= y <= 2 2^-29, degree 10, 67.8 bits */
        {
         0.97671557889198457, 9.4366815731967631e-18, -0.0023675398068092779, 0.00049250712347643697,
         -0.00015290328270115819, 5.5321894202716614e-05, -2.1721761873270937e-05, 8.975579523694271e-06,
         -3.8406348783682719e-06, 1.6857310041988311e-06, -7.5589571984871184e-07, 3.4345890060212508e-07
        },
        /* [96] 1 <= y <= 1.125 2^-28, degree 10, 64.3 bits */
        {
         0.97628803567736799, 1.5186862844558308e-18, -0.0043952805896397282, 0.0016675447874445878,
         -0.0009440946645929598, 0.00062290310589913024, -0.00044600470295781832, 0.00033606692330489358,
         -0.00026222728176252506, 0.00020988409274423243, -0.00017244074699894317, 0.00014289439563891967
        },
        /* [97] 1.125 <= y <= 1.25 2^-28, degree 10, 65.2 bits */
        {
         0.97576297668935119, 1.5422746455258808e-17, -0.0040182715873756016, 0.0013642778986858021,
         -0.00069113357036830459, 0.00040801577582649313, -0.00026139738984445936, 0.00017623428863257549,
         -0.00012303995616682437, 8.8114660687772643e-05, -6.4686909258663422e-05, 4.7959787596793101e-05
        },
        /* [98] 1.25 <= y <= 1.375 2^-28, degree 10, 67.3 bits */
        {
         0.97528075196727615, -2.2459328998044021e-17, -0.0037067011754239117, 0.0011388238291114151,
         -0.00052200386034785106, 0.00027882807586368665, -0.00016162343199811361, 9.8590416678017925e-05,
         -6.2277567284838543e-05, 4.0352694028306771e-05, -2.6776180670219991e-05, 1.7961283142396901e-05
        },
        /* [99] 1.375 <= y <= 1.5 2^-28, degree 10, 67.2 bits */
        {
         0.97483425239341137, 5.3164445613045714e-18, -0.0034444665686892335, 0.00096638083881082698,
         -0.00040446311921753453, 0.00019726303090947876, -0.00010440313424546618, 5.8148936690708287e-05,
         -3.3537919198287914e-05, 1.9841417305169057e-05, -1.2012159646301575e-05, 7.3569370648393576e-06
        },
        /* [100] 1.5 <= y <= 1.625 2^-28, degree 10, 68.4 bits */
        {
         0.97441804898661899, -7.9449168584790417e-18, -0.0032204070739051105, 0.00083135484061069842,
         -0.00032012927792702877, 0.00014364538918964524, -6.9944784355217989e-05, 3.5840774112935031e-05,
         -1.9017999831521596e-05, 1.0351258898312868e-05, -5.7621489943943386e-06, 3.2467248850575696e-06
        },
        /* [101] 1.625 <= y <= 1.75 2^-28, degree 10, 66.4 bits */
        {
         0.97402789583262928, 2.1337939946210096e-17, -0.0030265314844349768, 0.00072352708732077752,
         -0.00025798191526860392, 0.0001071871629015297, -4.832703573991408e-05, 2.2929472152485041e-05,
         -1.1265814007544102e-05, 5.6776789319997807e-06, -2.9251386423567673e-06, 1.5260963865962795e-06
        },
        /* [102] 1.75 <= y <= 1.875 2^-28, degree 10, 70.7 bits */
        {
         0.97366040541321797, -2.3920753399819987e-17, -0.0028569602902555518, 0.00063596608864791482,
         -0.00021113116825281726, 8.1673652344266241e-05, -3.4284844889169958e-05, 1.5145274329886019e-05,
         -6.9281275966923482e-06, 3.2508232547078037e-06, -1.5587685882634882e-06, 7.5714996661929597e-07
        },
        /* [103] 1.875 <= y <= 2 2^-28, degree 10, 65.9 bits */
        {
         0.97331282892972815, -3.8128533234101369e-17, -0.0027072667180130993, 0.00056383052561863941,
         -0.00017511384008342561, 6.3371822626574512e-05, -2.4886246685451118e-05, 1.0284322064433687e-05,
         -4.4010353264788416e-06, 1.9318433709714543e-06, -8.6630834520978164e-07, 3.9364847906296898e-07
        },
        /* [104] 1 <= y <= 1.125 2^-27, degree 10, 64.3 bits */
        {
         0.97282395724384119, -3.5036957355980895e-18, -0.0050255381758622184, 0.0019089096086469283,
         -0.0010811706056175208, 0.00071350418050324983, -0.00051095413842754936, 0.00038505078414145084,
         -0.00030047581665582296, 0.00024051579057019387, -0.00019762035404483099, 0.0001637685829245648
        },
        /* [105] 1.125 <= y <= 1.25 2^-27, degree 10, 64.8 bits */
        {
         0.97222363996401107, -1.6317962968302306e-17, -0.004593976813443118, 0.0015616223125175567,
         -0.00079142535444543243, 0.00046733094047358753, -0.00029944483975247383, 0.00020190957565382624,
         -0.00014097853790693101, 0.00010096902952265339, -7.4128412710206633e-05, 5.4962910809146779e-05
        },
        /* [106] 1.25 <= y <= 1.375 2^-27, degree 10, 66.2 bits */
        {
         0.97167235312296996, 6.3308882305540817e-18, -0.0042373502535910292, 0.0013034602642319317,
         -0.00059771400846046437, 0.00031934338046476943, -0.00018513783189480669, 0.00011294773800183598,
         -7.1353560486499883e-05, 4.6237081465620814e-05, -3.0682825199340245e-05, 2.0583004071316769e-05
        },
        /* [107] 1.375 <= y <= 1.5 2^-27, degree 10, 66.3 bits */
        {
         0.97116195621184431, 2.6703864439259844e-17, -0.0039372152224670743, 0.0011060123421951136,
         -0.00046309751747145169, 0.00022591385197224167, -0.00011958630576192181, 6.6613563563623672e-05,
         -3.8423680402973968e-05, 2.2733696221228561e-05, -1.3764099628660562e-05, 8.4304141560815073e-06
        },
        /* [108] 1.5 <= y <= 1.625 2^-27, degree 10, 66.9 bits */
        {
         0.9706862330068573, 2.1202953554295414e-17, -0.0036807896092350763, 0.00095141606163542947,
         -0.00036651729647681458, 0.00016450011642967389, -8.0112787507994574e-05, 4.1056109128257003e-05,
         -2.1787526895092552e-05, 1.1859636649103463e-05, -6.6022586030744281e-06, 3.7203100525096972e-06
        },
        /* [109] 1.625 <= y <= 1.75 2^-27, degree 10, 67.6 bits */
        {
         0.97024032219077283, 3.9885973168881741e-17, -0.0034589217510957756, 0.00082796681037485909,
         -0.00029534892809209891, 0.00012274280625345236, -5.5349866310911165e-05, 2.6264869253191665e-05,
         -1.2905865625103346e-05, 6.5047569232454232e-06, -3.3514827599673822e-06, 1.7486323592542217e-06
        },
        /* [110] 1.75 <= y <= 1.875 2^-27, degree 10, 68.4 bits */
        {
         0.96982034547168727, -3.3698151332059707e-17, -0.0032648786793288394, 0.00072772560391939575,
         -0.00024170011301467769, 9.352230782359748e-05, -3.926536742373112e-05, 1.7347632201531792e-05,
         -7.9363892949758093e-06, 3.7242313837746555e-06, -1.7858939658103316e-06, 8.6752566929712825e-07
        },
        /* [111] 1.875 <= y <= 2 2^-27, degree 10, 69.8 bits */
        {
         0.96942315597571094, 3.1161305552298107e-17, -0.0030935912816404446, 0.00064514768828579836,
         -0.00020045850743151622, 7.2562204477880199e-05, -2.8500268063792597e-05, 1.1779356633995095e-05,
         -5.0413330944375072e-06, 2.2130904682067152e-06, -9.9250086380774616e-07, 4.5101786438543605e-07
        },
        /* [112] 1 <= y <= 1.125 2^-26, degree 10, 64.3 bits */
        {
         0.96886455075532485, 2.7090622606021598e-17, -0.0057421017892179431, 0.002184053865925691,
         -0.0012375689595964657, 0.00081692856624769757, -0.00058512170804965414, 0.00044100117980627528,
         -0.00034417297175580512, 0.00027551690998426156, -0.00022639577862787876, 0.00018762664270832383
        },
        /* [113] 1.125 <= y <= 1.25 2^-26, degree 10, 64.7 bits */
        {
         0.96817867986848016, -4.8836632095747445e-17, -0.0052483588711538616, 0.0017865448340610981,
         -0.00090583618672482151, 0.00053503137130769774, -0.00034288624692912091, 0.00023123253441440398,
         -0.00016146990377039969, 0.00011565517413133147, -8.4916922671487646e-05, 6.2966155695755896e-05
        },
        /* [114] 1.25 <= y <= 1.375 2^-26, degree 10, 67.5 bits */
        {
         0.96754890153155571, 4.2338973510479804e-17, -0.0048403839353087499, 0.0014910728291746775,
         -0.00068406995226378436, 0.00036557999015285998, -0.00021198241734168022, 0.0001293427912651132,
         -8.1719909798709292e-05, 5.2959240337073823e-05, -3.5146329241905663e-05, 2.3578810135029103e-05
        },
        /* [115] 1.375 <= y <= 1.5 2^-26, degree 10, 65.4 bits */
        {
         0.96696589871956218, -2.4200987523250278e-17, -0.0044970624948976095, 0.0012651058479980469,
         -0.00052996755434410946, 0.00025860644586798325, -0.0001369177114249316, 7.627847769190123e-05,
         -4.4003452840573137e-05, 2.6037404862415408e-05, -1.5765557698674326e-05, 9.6569389602445229e-06
        },
        /* [116] 1.5 <= y <= 1.625 2^-26, degree 10, 65.2 bits */
        {
         0.96642255732307769, -2.0792402400854691e-18, -0.004203762151485625, 0.0010881918699643597,
         -0.00041941414153696662, 0.00018829402933058021, -9.1718154019618868e-05, 4.7010350314749199e-05,
         -2.4950136457844607e-05, 1.3582412538415161e-05, -7.5619275395786264e-06, 4.2613643765136559e-06
        },
        /* [117] 1.625 <= y <= 1.75 2^-26, degree 10, 66.1 bits */
        {
         0.96591331422326121, 2.6710839257462912e-17, -0.0039500071457398787, 0.00094693026100458851,
         -0.0003379539262505455, 0.00014048884751963311, -6.336462065278314e-05, 3.007244539192229e-05,
         -1.4778512562900629e-05, 7.4493067073575646e-06, -3.8384576137780523e-06, 2.0028494413469115e-06
        },
        /* [118] 1.75 <= y <= 1.875 2^-26, degree 10, 67.2 bits */
        {
         0.96543373152249756, 9.4190015622532778e-18, -0.0037280908127493746, 0.00083223217025478978,
         -0.0002765501922242938, 0.00010703797370406714, -4.4948794980226584e-05, 1.9861533515524001e-05,
         -9.08754066805557e-06, 4.2648314631125314e-06, -2.0452969262539424e-06, 9.9360441748145833e-07
        },
        /* [119] 1.875 <= y <= 2 2^-26, degree 10, 66.5 bits */
        {
         0.96498020849373167, 3.1052178372418651e-17, -0.0035322112860760239, 0.00073775008620595678,
         -0.00022934957891614083, 8.304456713702903e-05, -3.2623955906118498e-05, 1.3485725841083046e-05,
         -5.772310589055916e-06, 2.5342290292873983e-06, -1.1366154172953944e-06, 5.1654397916222219e-07
        },
        /* [120] 1 <= y <= 1.125 2^-25, degree 10, 64.3 bits */
        {
         0.96434243920029883, 3.726566039427091e-17, -0.0065554780575643422, 0.0024973294610645172,
         -0.0014158249120500212, 0.00093487595859865222, -0.00066973766292386327, 0.00050485260609625302,
         -0.00039405255808120401, 0.00031547784514665301, -0.00025925423904016515, 0.00021487383267275578
        },
        /* [121] 1.125 <= y <= 1.25 2^-25, degree 10, 64.9 bits */
        {
         0.96355946949035443, -4.7464364449027992e-18, -0.0059909433191055149, 0.0020425849962917449,
         -0.0010362125243941435, 0.00061222522134712128, -0.00039243949560763774, 0.00026469118127659161,
         -0.00018485699383693436, 0.00013242000309197168, -9.7234523209086188e-05, 7.2105043860451229e-05
        },
        /* [122] 1.25 <= y <= 1.375 2^-25, degree 10, 65.7 bits */
        {
         0.96284063153499455, -4.3431005974385658e-17, -0.0055245215864349337, 0.001704600094614604,
         -0.00078245973836752749, 0.00041829193307015033, -0.00024259927058994883, 0.00014804754011491013,
         -9.3549558523856608e-05, 6.0631842605717427e-05, -4.0241803717098289e-05, 2.6999284683803814e-05
        },
        /* [123] 1.375 <= y <= 1.5 2^-25, degree 10, 66.5 bits */
        {
         0.96217526771349071, -2.01845896328032e-17, -0.0051320527770880664, 0.0014461423611346479,
         -0.00060614402076848977, 0.00029587213202866429, -0.00015668185019494316, 8.7303512310593227e-05,
         -5.0370052039220894e-05, 2.9807761140884594e-05, -1.8050121581865166e-05, 1.1057165735499158e-05
        },
        /* [124] 1.5 <= y <= 1.625 2^-25, degree 10, 65.0 bits */
        {
         0.96155524097923373, 3.2762081152674227e-17, -0.0047967952032339336, 0.0012438065097068957,
         -0.00047966386219843945, 0.00021541258122926416, -0.0001049508146688831, 5.3801684076730255e-05,
         -2.8558292034113824e-05, 1.5548304740719188e-05, -8.6572192685426948e-06, 4.8789762734072704e-06
        },
        /* [125] 1.625 <= y <= 1.75 2^-25, degree 10, 67.7 bits */
        {
         0.96097418879266649, -9.3930233874213745e-18, -0.0045067638785340263, 0.0010822579203369819,
         -0.00038647447732239015, 0.00016071189509354547, -7.2502094365225532e-05, 3.441481904536968e-05,
         -1.6914739397010159e-05, 8.5270344628509231e-06, -4.3941947685006929e-06, 2.2930078380960541e-06
        },
        /* [126] 1.75 <= y <= 1.875 2^-25, degree 10, 69.8 bits */
        {
         0.96042703590229983, -4.8250039920654669e-17, -0.0042531424512226405, 0.00095109670688206928,
         -0.00031623390033712058, 0.00012243830955877737, -5.1427628621652671e-05, 2.2728216015769122e-05,
         -1.0400582048288771e-05, 4.8815915544142292e-06, -2.3412991232525859e-06, 1.1374943647684171e-06
        },
        /* [127] 1.875 <= y <= 2 2^-25, degree 10, 67.4 bits */
        {
         0.95990966474234052, 4.5436103570858351e-17, -0.004029294065771313, 0.00084306019183939113,
         -0.00026224370994890224, 9.4987261475624725e-05, -3.7324254686888479e-05, 1.5431353109363518e-05,
         -6.6060050205437807e-06, 2.9005745512316423e-06, -1.3010477533271256e-06, 5.9132017228026062e-07
        },
        /* [128] 1 <= y <= 1.125 2^-24, degree 10, 64.1 bits */
        {
         0.95918219165440555, 2.2896561067358781e-17, -0.007477022999777286, 0.0028535250636518416,
         -0.0016187441079322125, 0.0010692333552741041, -0.00076617072979381093, 0.00057764637710954175,
         -0.00045093327132846023, 0.00036105794556471119, -0.00029674032140994004, 0.00024596345424562286
        },
        /* [129] 1.125 <= y <= 1.25 2^-24, degree 10, 66.4 bits */
        {
         0.95828922816864404, 2.1141061425850925e-17, -0.0068320072809597713, 0.0023336328759657691,
         -0.0011845957205506631, 0.0007001416234981581, -0.00044890258881436748, 0.00030282887482901814,
         -0.00021152212218507563, 0.00015153905759144175, -0.00011128459127049159, 8.253105709265821e-05
        },
        /* [130] 1.25 <= y <= 1.375 2^-24, degree 10, 64.8 bits */
        {
         0.95746953490490383, -1.5078188940627245e-17, -0.0062991547811568696, 0.001947268046254278,
         -0.00089441646960259919, 0.00047831484119502019, -0.00027747942153793663, 0.00016936456227302445,
         -0.00010703516802661784, 6.9380539601136265e-05, -4.6053087075112414e-05, 3.090093162440458e-05
        },
        /* [131] 1.375 <= y <= 1.5 2^-24, degree 10, 65.3 bits */
        {
         0.9567109286202552, 1.2181267856711036e-17, -0.0058508370313248188, 0.0016518427005423487,
         -0.00069280856297931003, 0.00033829926126141714, -0.00017919448666106529, 9.9866368094073975e-05,
         -5.7626806798156102e-05, 3.4106304328205955e-05, -2.06552584484667e-05, 1.2654152324556847e-05
        },
        /* [132] 1.5 <= y <= 1.625 2^-24, degree 10, 65.1 bits */
        {
         0.95600410837119409, -2.7322121857888066e-17, -0.0054679106706683259, 0.0014205872636008864,
         -0.00054819711462104816, 0.0002462822796948445, -0.000120021426364522, 6.1539201169204784e-05,
         -3.2670363112940192e-05, 1.778929982110497e-05, -9.9060421765598246e-06, 5.5832860665525666e-06
        },
        /* [133] 1.625 <= y <= 1.75 2^-24, degree 10, 66.8 bits */
        {
         0.9553418022007778, -4.407796609497278e-17, -0.0051366725660191171, 0.0012359643109717945,
         -0.00044165708676075302, 0.0001837288592860638, -8.2907260792159797e-05, 3.9361519833950067e-05,
         -1.9348998355459076e-05, 9.7554239410548421e-06, -5.0277547375312184e-06, 2.6238583054948593e-06
        },
        /* [134] 1.75 <= y <= 1.875 2^-24, degree 10, 65.9 bits */
        {
         0.95471820992790879, -1.8044577323045828e-18, -0.0048470432623168675, 0.0010860809099568569,
         -0.00036135949089481927, 0.00013996382571119191, -5.880433234889324e-05, 2.599344192898435e-05,
         -1.1896628368821065e-05, 5.5844893249946076e-06, -2.6787134114836977e-06, 1.3015452271422026e-06
        },
        /* [135] 1.875 <= y <= 2 2^-24, degree 10, 65.9 bits */
        {
         0.95412862622417016, -4.2790161883081458e-17, -0.0045914356143804923, 0.00096263230789990907,
         -0.00029964328611191301, 0.00010857619369763906, -4.2675275296670748e-05, 1.7647208229373789e-05,
         -7.5557861313318687e-06, 3.3180379140094435e-06, -1.4884646023988112e-06, 6.7656448963337846e-07
        },
        /* [136] 1 <= y <= 1.125 2^-23, degree 10, 63.6 bits */
        {
         0.95329972441714184, 4.7993983046268448e-17, -0.0085188598817285393, 0.0032578668967190132,
         -0.001849410050510418, 0.0012220826416717739, -0.00087593488699802514, 0.00066053649813279573,
         -0.0005157237523185338, 0.00041298988307045595, -0.00033945979109129633, 0.00028140016944828674
        },
        /* [137] 1.125 <= y <= 1.25 2^-23, degree 10, 65.8 bits */
        {
         0.95228243289795789, -3.0227221598236399e-17, -0.0077824973998879545, 0.0026639277021430711,
         -0.0013532264965267686, 0.00080013513387013947, -0.00051315729781963308, 0.00034624718630505075,
         -0.00024188920948392908, 0.00017331824581292955, -0.00012729315522697762, 9.441269887564822e-05
        },
        /* [138] 1.25 <= y <= 1.375 2^-23, degree 10, 67.3 bits */
        {
         0.9513487824729433, 1.6757531521320472e-17, -0.0071742657832160441, 0.0022225873707524949,
         -0.0010216210302831075, 0.00054656865806406059, -0.00031716492191917212, 0.00019362854802749789,
         -0.00012239018198962058, 7.9344714747273579e-05, -5.2673280639311617e-05, 3.5346555209609546e-05
        },
        /* [139] 1.375 <= y <= 1.5 2^-23, degree 10, 65.7 bits */
        {
         0.95048485626928569, -3.9876915594877951e-17, -0.006662592059691972, 0.0018851639813515628,
         -0.00079125532743017351, 0.00038653491664066507, -0.00020480388213347535, 0.00011416343850308818,
         -6.5888099578098863e-05, 3.900124629265103e-05, -2.3622543881219089e-05, 1.4473508996990142e-05
        },
        /* [140] 1.5 <= y <= 1.625 2^-23, degree 10, 65.6 bits */
        {
         0.94968003105347176, -2.9733802809718338e-18, -0.006225602076846362, 0.001621060456463279,
         -0.00062603212070542786, 0.0002813717797188111, -0.00013716212915080967, 7.0343371888446321e-05,
         -3.7350914321360885e-05, 2.0340826811338743e-05, -1.1328254410869256e-05, 6.3855489135874927e-06
        },
        /* [141] 1.625 <= y <= 1.75 2^-23, degree 10, 69.1 bits */
        {
         0.94892600190460075, -1.1011509364611201e-17, -0.0058476394807470142, 0.0014102337302033408,
         -0.00050431771189392153, 0.00020988766661094444, -9.4739750267099304e-05, 4.4989272465965906e-05,
         -2.2119371039179696e-05, 1.1153827243132636e-05, -5.7491778310653525e-06, 3.0006705151235209e-06
        },
        /* [142] 1.75 <= y <= 1.875 2^-23, degree 10, 67.6 bits */
        {
         0.9482161453885869, 3.3861654969282583e-17, -0.0055171891558448236, 0.0012390928515831501,
         -0.00041259119841505876, 0.00015987835486334551, -6.7191643890836212e-05, 2.9707673055471273e-05,
         -1.3599003081810294e-05, 6.3845614905684757e-06, -3.0628697539070268e-06, 1.4883617895189894e-06
        },
        /* [143] 1.875 <= y <= 2 2^-23, degree 10, 64.9 bits */
        {
         0.94754508881720345, 4.0078949483624372e-17, -0.0052255840274532013, 0.0010981481218978071,
         -0.00034209645168056514, 0.0001240151380958932, -4.8758500625723876e-05, 2.0167418265913687e-05,
         -8.6364125367827836e-06, 3.793153341247982e-06, -1.701817452169783e-06, 7.7362641826843798e-07
        },
        /* [144] 1 <= y <= 1.125 2^-22, degree 10, 64.1 bits */
        {
         0.94660178634149217, 4.7321533172154844e-17, -0.0096937294275510483, 0.0037160011076670658,
         -0.002111182931189295, 0.0013957032721665036, -0.0010006930089777168, 0.00075479339837331981,
         -0.00058942611538711771, 0.00047208288450529846, -0.00038808253736477474, 0.00032174264603506385
        },
        /* [145] 1.125 <= y <= 1.25 2^-22, degree 10, 64.7 bits */
        {
         0.94544432210911566, -4.1829956676688499e-17, -0.008853884385153615, 0.0030380408578295349,
         -0.001544542880141576, 0.0009136868147094938, -0.0005861708844560067, 0.00039560758743829627,
         -0.00027642525562440056, 0.0001980950722779387, -0.00014550990745737416, 0.00010793631524999106
        },
        /* [146] 1.25 <= y <= 1.375 2^-22, degree 10, 64.1 bits */
        {
         0.94438224583174923, 5.0166284576830871e-17, -0.0081602862388037798, 0.0025343373037616467,
         -0.0011658996969354878, 0.00062405795788297727, -0.00036224967614780938, 0.00022120710640322142,
         -0.00013984948701736296, 9.0677992939859782e-05, -6.0205132866880391e-05, 4.0405544506263398e-05
        },
        /* [147] 1.375 <= y <= 1.5 2^-22, degree 10, 65.0 bits */
        {
         0.94339967400948677, -3.7049582668993802e-17, -0.0075768831213500138, 0.0021492843751662748,
         -0.00090288851517824817, 0.00044128486456139146, -0.00023389119180832328, 0.00013041021010065299,
         -7.527968009907334e-05, 4.4567697619102787e-05, -2.6997819811742925e-05, 1.6543506286616933e-05
        },
        /* [148] 1.5 <= y <= 1.625 2^-22, degree 10, 65.1 bits */
        {
         0.94248448379536809, 4.1514923836547806e-17, -0.0070787008750666366, 0.001847937121517309,
         -0.00071427229570888431, 0.0003211916622624328, -0.00015662672542619764, 8.0346249750431537e-05,
         -4.2670861031717587e-05, 2.3241863369386265e-05, -1.2945733196996035e-05, 7.2981788346596014e-06
        },
        /* [149] 1.625 <= y <= 1.75 2^-22, degree 10, 64.9 bits */
        {
         0.94162719906394077, 3.2479204490513649e-17, -0.0066478663387803949, 0.001607406782386624,
         -0.00057533952148231535, 0.00023956696500045295, -0.00010817391785012909, 5.1382101289229524e-05,
         -2.5267648292035632e-05, 1.2743516992369699e-05, -6.5695162863516173e-06, 3.4292521834429286e-06
        },
        /* [150] 1.75 <= y <= 1.875 2^-22, degree 10, 65.9 bits */
        {
         0.94082026316406009, -3.8339110950631647e-17, -0.0062712353356198583, 0.0014121743237233307,
         -0.00047064715244311578, 0.00018246873480243697, -7.6712585384630587e-05, 3.3926123846337591e-05,
         -1.5533280163894774e-05, 7.293930428353596e-06, -3.4996308118781533e-06, 1.7008126663403847e-06
        },
        /* [151] 1.875 <= y <= 2 2^-22, degree 10, 65.4 bits */
        {
         0.94005754706756606, -2.4727314166732025e-17, -0.0059389156229174497, 0.0012514048024957259,
         -0.00039019518223527258, 0.0001415254230533454, -5.5662767727157485e-05, 2.302929336180474e-05,
         -9.8640541456103255e-06, 4.333092387772952e-06, -1.9443504085315687e-06, 8.8399108281154086e-07
        },
        /* [152] 1 <= y <= 1.125 2^-21, degree 10, 63.6 bits */
        {
         0.93898558594796411, -2.4040988434325386e-17, -0.011014750598057722, 0.0042339502316173826,
         -0.0024076860235228981, 0.0015925676648687788, -0.0011422557634650475, 0.00086180435951150366,
         -0.00067313707081799402, 0.00053922415393986166, -0.00044334411264295315, 0.00036760509648299159
        },
        /* [153] 1.125 <= y <= 1.25 2^-21, degree 10, 64.0 bits */
        {
         0.93767055203110594, -7.6281573941428806e-18, -0.01005793407149202, 0.0034608370363503984,
         -0.0017611687208538181, 0.0010424003615940082, -0.0006689949269741228, 0.00045163133039323282,
         -0.00031564063198533544, 0.00022623907090444731, -0.00016620866347444649, 0.0001233065252637281
        },
        /* [154] 1.25 <= y <= 1.375 2^-21, degree 10, 66.6 bits */
        {
         0.93646418172905943, -2.7685798084182394e-17, -0.0092678774373465382, 0.0028865307523881479,
         -0.0013292144129665741, 0.00071186876438054556, -0.00041337841705082454, 0.00025250052161391256,
         -0.00015966945205445648, 0.0001035483701460491, -6.87611846212188e-05, 4.6154005109828331e-05
        },
        /* [155] 1.375 <= y <= 1.5 2^-21, degree 10, 64.4 bits */
        {
         0.93534836504405139, 3.087795870568397e-17, -0.008603452480478677, 0.0024475716003912458,
         -0.0010292140967521457, 0.00050331095573434353, -0.000266869625514636, 0.00014884102298160182,
         -8.5938632667454561e-05, 5.0887700159068462e-05, -3.0831241162953705e-05, 1.8895117796974677e-05
        },
        /* [156] 1.5 <= y <= 1.625 2^-21, degree 10, 64.2 bits */
        {
         0.93430928187052675, -1.0368652025062969e-17, -0.0080361725051874035, 0.0021040843695256019,
         -0.00081409914051849071, 0.00036629230627685798, -0.00017869000723634676, 9.1691268929574709e-05,
         -4.8707422446224703e-05, 2.6534937652450015e-05, -1.4782388956745242e-05, 8.33476303377506e-06
        },
        /* [157] 1.625 <= y <= 1.75 2^-21, degree 10, 66.7 bits */
        {
         0.93333613088994261, -4.8381687807664672e-17, -0.00754565319639291, 0.0018299542263969788,
         -0.0006556667543833048, 0.00027317437198710279, -0.00012339830728159612, 5.863116789735541e-05,
         -2.8839286699407649e-05, 1.4547679618393565e-05, -7.5008375186660324e-06, 3.9159537963563908e-06
        },
        /* [158] 1.75 <= y <= 1.875 2^-21, degree 10, 67.8 bits */
        {
         0.93242029981391894, -7.2627075338100687e-19, -0.0071169054594763916, 0.0016074768343276053,
         -0.00053629403435264929, 0.00020804335640030617, -8.750003565397375e-05, 3.8708633802584827e-05,
         -1.7727248293917444e-05, 8.3257961687914537e-06, -3.9953917180375665e-06, 1.9420317104122698e-06
        },
        /* [159] 1.875 <= y <= 2 2^-21, degree 10, 65.2 bits */
        {
         0.93155480426895776, -6.7512621637117556e-18, -0.0067386498624493569, 0.0014242928711215119,
         -0.0004445706053228424, 0.00016134471877595892, -6.3483924901533781e-05, 2.6273227072958802e-05,
         -1.1256263971431158e-05, 4.9456568475436806e-06, -2.2195990423746414e-06, 1.0092795193523921e-06
        },
        /* [160] 1 <= y <= 1.125 2^-20, degree 10, 63.2 bits */
        {
         0.93033863545773487, 2.1883306941318908e-17, -0.012495066102674023, 0.0048180342670665092,
         -0.002742774653720225, 0.0018153262029609169, -0.0013025736379052473, 0.00098306910133982893,
         -0.00076804548049849068, 0.00061537758255137721, -0.00050604514490842337, 0.0004196571274083845
        },
        /* [161] 1.125 <= y <= 1.25 2^-20, degree 10, 66.0 bits */
        {
         0.92884708385921877, -2.7923571103893571e-17, -0.011406371315812803, 0.0039374056879471868,
         -0.0020058890673027227, 0.0011879912008141134, -0.00076275997948656023, 0.0005150966955883566,
         -0.00036008763658187433, 0.00025815105450038801, -0.0001896869906714621, 0.00014074606049670505
        },
        /* [162] 1.25 <= y <= 1.375 2^-20, degree 10, 65.0 bits */
        {
         0.92747916022319277, -5.4536338109046355e-17, -0.010507610271507074, 0.0032833540481717548,
         -0.0015136428793852061, 0.00081116042824378712, -0.00047124302718451044, 0.00028793999004910359,
         -0.0001821270593117702, 0.00011813778229998104, -7.8463558457227725e-05, 5.267466142490419e-05
        },
        /* [163] 1.375 <= y <= 1.5 2^-20, degree 10, 64.6 bits */
        {
         0.92621423968658934, -5.1210295697275498e-17, -0.009751913554053953, 0.0027835294456074978,
         -0.001171823451477725, 0.00057342494137067066, -0.00030418184749169736, 0.00016970790961928929,
         -9.8012839820554485e-05, 5.804997545408552e-05, -3.5177157742564696e-05, 2.1561965974612198e-05
        },
        /* [164] 1.5 <= y <= 1.625 2^-20, degree 10, 64.3 bits */
        {
         0.92503658573953718, 4.758525444067787e-17, -0.0091068231889892617, 0.0023924775145378694,
         -0.00092675860776926544, 0.00041725909066050494, -0.00020364587519268511, 0.00010453245921884796,
         -5.5543781500931798e-05, 3.0265977897651855e-05, -1.6864098159022194e-05, 9.5100321513763408e-06
        },
        /* [165] 1.625 <= y <= 1.75 2^-20, degree 10, 69.8 bits */
        {
         0.92393390125574992, 2.767896165324177e-17, -0.0085491166102304016, 0.002080433798334893,
         -0.00074629321876840864, 0.00031114268925717069, -0.00014061426168435214, 6.6834227503568871e-05,
         -3.2883187250112873e-05, 1.659132303641969e-05, -8.5561850605586461e-06, 4.4676520743098531e-06
        },
        /* [166] 1.75 <= y <= 1.875 2^-20, degree 10, 64.0 bits */
        {
         0.9228963827651927, 4.9836983590170131e-17, -0.0080617200826275815, 0.0018272224132232901,
         -0.00061033727169860661, 0.0002369291327561835, -9.9695685018194878e-05, 4.4119282769057236e-05,
         -2.0210763274703534e-05, 9.4943782640918065e-06, -4.557056775435693e-06, 2.2154086211871742e-06
        },
        /* [167] 1.875 <= y <= 2 2^-20, degree 10, 65.6 bits */
        {
         0.92191608100084121, 3.7359230623242955e-17, -0.0076317871561881988, 0.0016187604199260892,
         -0.00050588456078585337, 0.00018372457869169471, -7.232403231982323e-05, 2.9942418745207602e-05,
         -1.2831877526435807e-05, 5.6392412565178038e-06, -2.531376138060255e-06, 1.151243210478514e-06
        },
        /* [168] 1 <= y <= 1.125 2^-19, degree 10, 63.9 bits */
        {
         0.92053890728726118, 3.253974650416369e-17, -0.014147343185644805, 0.0054747446545085603,
         -0.0031204814481435154, 0.0020667778706971369, -0.0014837193580136208, 0.0011201885287207263,
         -0.00087542483366111006, 0.00070157856564234461, -0.00057704767583903645, 0.00047862113053943645
        },
        /* [169] 1.125 <= y <= 1.25 2^-19, degree 10, 64.9 bits */
        {
         0.91885040078256119, 4.0363090204830439e-18, -0.012910409932049787, 0.0044729530842157247,
         -0.0022816077328053903, 0.0013522659143129908, -0.00086866443331903485, 0.00058683254178055848,
         -0.00041035658860088869, 0.00029426067530290828, -0.00021626464399465784, 0.00016049475020850817
        },
        /* [170] 1.25 <= y <= 1.375 2^-19, degree 10, 64.0 bits */
        {
         0.91730233886038981, -2.9122594316387703e-17, -0.011889520315038378, 0.0037290731917482551,
         -0.0017213448897152269, 0.0009231507325743925, -0.0005365751817797711, 0.00032798373216816757,
         -0.00020751775439266428, 0.0001346408780425926, -8.9443239102134675e-05, 6.0056429036591053e-05
        },
        /* [171] 1.375 <= y <= 1.5 2^-19, degree 10, 63.9 bits */
        {
         0.91587126375113415, 7.4243116436625941e-19, -0.011031327958527093, 0.0031607153729909438,
         -0.00133236613552136, 0.00065247739396545427, -0.00034629494503671065, 0.00019327814990116016,
         -0.00011165973882957416, 6.614927148285961e-05, -4.0093761742711332e-05, 2.4580129024204012e-05
        },
        /* [172] 1.5 <= y <= 1.625 2^-19, degree 10, 64.1 bits */
        {
         0.91453928107228877, 2.5537990313506946e-17, -0.010298896380332923, 0.0027161269406643456,
         -0.0010535387092415181, 0.00047470396165258616, -0.00023180379477049919, 0.00011903285244076897,
         -6.3268334689682495e-05, 3.4483947540603707e-05, -1.9218521019305659e-05, 1.0839767719413152e-05
        },
        /* [173] 1.625 <= y <= 1.75 2^-19, degree 10, 65.2 bits */
        {
         0.91329241006166262, 1.2137880954599664e-18, -0.0096658033829490585, 0.0023614247487902941,
         -0.00084824361852998064, 0.000353923357038447, -0.00016003336385152147, 7.6094557813592836e-05,
         -3.7451226086742614e-05, 1.8901064197180799e-05, -9.7494797665477458e-06, 5.0917032579649308e-06
        },
        /* [174] 1.75 <= y <= 1.875 2^-19, degree 10, 63.9 bits */
        {
         0.91211950697139343, -2.2194044591572806e-17, -0.009112625941860018, 0.0020736445846768472,
         -0.00069360527564014398, 0.00026946633115102359, -0.00011344814547970008, 5.0225651518475049e-05,
         -2.301544513762365e-05, 1.0814787542546639e-05, -5.1919836895595517e-06, 2.5245642735222448e-06
        },
        /* [175] 1.875 <= y <= 2 2^-19, degree 10, 63.8 bits */
        {
         0.91101153723423756, 5.3149749854350978e-17, -0.0086247522031160234, 0.001836759545191512,
         -0.00057481615342305553, 0.00020892629794704327, -8.2289939871439774e-05, 3.4082351033826535e-05,
         -1.4610811850902842e-05, 6.4227529874221659e-06, -2.8837390669947352e-06, 1.3117505270135109e-06
        },
        /* [176] 1 <= y <= 1.125 2^-18, degree 10, 62.3 bits */
        {
         0.90945542122838474, -2.6545205261059892e-17, -0.015983097847351951, 0.0062105571119816247,
         -0.0035449300927539351, 0.0023498215579118328, -0.0016878572439159485, 0.0012748441034187894,
         -0.00099661870908931125, 0.00079892341140782035, -0.00065726720356519574, 0.00054526622113831424
        },
        /* [177] 1.125 <= y <= 1.25 2^-18, degree 10, 63.7 bits */
        {
         0.9075481768694672, 3.3047674869909042e-17, -0.014580120007517995, 0.005072643459935332,
         -0.0025912813118770485, 0.001537088700914427, -0.00098795552838170384, 0.00066770680879375604,
         -0.00046706854088363699, 0.00033502164993712985, -0.00024628034266167544, 0.00018280731256448878
        },
        /* [178] 1.25 <= y <= 1.375 2^-18, degree 10, 66.2 bits */
        {
         0.90580020828474339, -4.2728576487266903e-18, -0.013422512001477222, 0.0042278969272011519,
         -0.0019545105430138496, 0.0010490919546929853, -0.00061013402997947899, 0.00037311021472629334,
         -0.00023615154291146322, 0.00015326269495821805, -0.00010183864941608618, 6.8393528051123573e-05
        },
        /* [179] 1.375 <= y <= 1.5 2^-18, degree 10, 64.0 bits */
        {
         0.90418487659592883, -2.8561974962826259e-17, -0.012449641665540049, 0.0035826209866317692,
         -0.0015125083741643717, 0.00074134011173453043, -0.0003936921287215812, 0.00021983008641298738,
         -0.00012704411347214505, 7.5285158198852477e-05, -4.5642411892330011e-05, 2.798775535775495e-05
        },
        /* [180] 1.5 <= y <= 1.625 2^-18, degree 10, 64.9 bits */
        {
         0.90268186548162033, 9.8881221787025458e-18, -0.011619536986165479, 0.0030779726342856197,
         -0.0011957356555345508, 0.00053925217652521192, -0.00026348302410761929, 0.0001353617965402057,
         -7.1973384201968658e-05, 3.9240186990796677e-05, -2.1874760878772657e-05, 1.2340622873989066e-05
        },
        /* [181] 1.625 <= y <= 1.75 2^-18, degree 10, 64.7 bits */
        {
         0.90127530535628952, -1.9584494636252668e-17, -0.010902179660944408, 0.0026754339335713553,
         -0.00096254551397046567, 0.00040197625524113011, -0.00018187331210047899, 8.6519177276235618e-05,
         -4.2597449083626696e-05, 2.1504752809048432e-05, -1.1095339138736694e-05, 5.7958548365514429e-06
        },
        /* [182] 1.75 <= y <= 1.875 2^-18, degree 10, 67.9 bits */
        {
         0.89995254948151449, -4.3980117412063981e-18, -0.01027550729118815, 0.0023489040912247996,
         -0.00078692591996886395, 0.00030600058343867824, -0.00012890993482888308, 5.7097605729774376e-05,
         -2.6174165193073945e-05, 1.2302802503078957e-05, -5.9078834208246241e-06, 2.8733050661827673e-06
        },
        /* [183] 1.875 <= y <= 2 2^-18, degree 10, 65.8 bits */
        {
         0.89870334671102969, 5.2325158142868384e-17, -0.0097229253521558517, 0.0020801701972579102,
         -0.00065204179905866929, 0.00023721455532197324, -9.3491036672688029e-05, 3.8739939212848617e-05,
         -1.6613729141253043e-05, 7.3054748112721296e-06, -3.2809321087037135e-06, 1.4927620859361371e-06
        },
        /* [184] 1 <= y <= 1.125 2^-17, degree 10, 63.0 bits */
        {
         0.89694940414443969, 3.105560758777057e-17, -0.018011810779685281, 0.0070316671027319047,
         -0.0040202083142342956, 0.0026673819854790034, -0.0019171952490247579, 0.0014487646909712095,
         -0.0011330168071861692, 0.0009085514377017987, -0.00074765888932045745, 0.00062039746480843595
        },
        /* [185] 1.125 <= y <= 1.25 2^-17, degree 10, 62.6 bits */
        {
         0.89480054336971271, 8.8707003508652071e-18, -0.016423604543011863, 0.0057413759973120012,
         -0.0029378228216786384, 0.0017443308850070081, -0.0011218999983457815, 0.00075860830375117897,
         -0.00053086346324777935, 0.00038090383950285708, -0.00028008630221899134, 0.00020794952342530844
        },
        /* [186] 1.25 <= y <= 1.375 2^-17, degree 10, 63.9 bits */
        {
         0.89283195815248506, -2.5293906401269636e-18, -0.015113586863051356, 0.0047837856406479709,
         -0.0022152851667737736, 0.0011902351434171451, -0.0006926873470036812, 0.00042380754133042759,
         -0.00026834674724886048, 0.00017421486470798315, -0.00011579327660471738, 7.7783974984571767e-05
        },
        /* [187] 1.375 <= y <= 1.5 2^-17, degree 10, 63.9 bits */
        {
         0.89101345066033966, -1.1719383163859783e-18, -0.014012957754812538, 0.0040525060689287967,
         -0.0017138732679801924, 0.00084088005915714762, -0.00044686014545500306, 0.00024964664021932825,
         -0.00014433460263222668, 8.5560085959319877e-05, -5.1886523154025394e-05, 3.1824418350019265e-05
        },
        /* [188] 1.5 <= y <= 1.625 2^-17, degree 10, 66.1 bits */
        {
         0.88932199648372634, 4.9520798399082954e-17, -0.013074102996798934, 0.0034807384241967152,
         -0.0013546053517163612, 0.0006115228005064429, -0.0002990039272834597, 0.00015369083014285469,
         -8.1753090474981349e-05, 4.4587364296390544e-05, -2.4862811500234425e-05, 1.4029826382362521e-05
        },
        /* [189] 1.625 <= y <= 1.75 2^-17, degree 10, 63.9 bits */
        {
         0.88773961515589617, -5.3146201139899125e-17, -0.012262976873420742, 0.0030247665703299694,
         -0.0010901893569772992, 0.00045575478661642797, -0.00020635175564658558, 9.8216129355521963e-05,
         -4.837682181108959e-05, 2.443087722609692e-05, -1.2608787270602163e-05, 6.5881015288872993e-06
        },
        /* [190] 1.75 <= y <= 1.875 2^-17, degree 10, 65.0 bits */
        {
         0.88625198107215986, -1.7889893053829888e-17, -0.011554562387894804, 0.0026549733498545617,
         -0.00089109316781338008, 0.0003468712619036419, -0.00014623299571504548, 6.4805455129951671e-05,
         -2.9720255965630287e-05, 1.3974519234124789e-05, -6.7126609013758688e-06, 3.2655491984026103e-06
        },
        /* [191] 1.875 <= y <= 2 2^-17, degree 10, 66.2 bits */
        {
         0.88484748477243824, -1.8836657453292852e-18, -0.010930046495454747, 0.0023506961431749747,
         -0.00073820702888162404, 0.00026884820680003974, -0.00010603592545210218, 4.3962251204690625e-05,
         -1.8861522166762406e-05, 8.2968513315923309e-06, -3.7272954683160949e-06, 1.6962913132389799e-06
        },
        /* [192] 1 <= y <= 1.125 2^-16, degree 10, 63.1 bits */
        {
         0.88287618608637553, 5.129110492322433e-17, -0.020239807680761855, 0.0079436301491569942,
         -0.0045501893916754643, 0.0030223031281499937, -0.0021739145962793864, 0.0016436770788922661,
         -0.0012860186105775819, 0.0010316174250160968, -0.00084919603082306587, 0.00070483883545408683
        },
        /* [193] 1.125 <= y <= 1.25 2^-16, degree 10, 63.1 bits */
        {
         0.88046211949576791, -2.9530789034766179e-17, -0.018445962077324612, 0.0064834832951882436,
         -0.0033239671713824201, 0.0019757988033781526, -0.0012717413589416356, 0.00086041976547087621,
         -0.00060238250715645458, 0.00043238119805402833, -0.00031803980389699264, 0.00023619223494687427
        },
        /* [194] 1.25 <= y <= 1.375 2^-16, degree 10, 63.0 bits */
        {
         0.8782516331201119, 2.132043081113096e-17, -0.016966875747519077, 0.0054001942636089746,
         -0.0025056650880031363, 0.0013477794221844843, -0.00078498430403173411, 0.00048055788499400874,
         -0.0003044207163704641, 0.00019770989226520005, -0.00013145204927367729, 8.8327253949092288e-05
        },
        /* [195] 1.375 <= y <= 1.5 2^-16, degree 10, 64.2 bits */
        {
         0.87621056460071445, -4.5230643532062475e-17, -0.015724628384860721, 0.0045731762971986112,
         -0.0019379581951057738, 0.00095192258983770625, -0.00050627120581075817, 0.00028300586087366041,
         -0.0001636985433416418, 9.7076482049429525e-05, -5.8889886826151486e-05, 3.6130129231371509e-05
        },
        /* [196] 1.5 <= y <= 1.625 2^-16, degree 10, 64.1 bits */
        {
         0.87431287481735975, -5.074309917209386e-17, -0.01466530942257099, 0.0039267375459038452,
         -0.0015312966938600852, 0.0006921013188605239, -0.0003386755697248833, 0.00017418770606034365,
         -9.2700467605677815e-05, 5.0577916919943625e-05, -2.8212727125613633e-05, 1.5924733513235319e-05
        },
        /* [197] 1.625 <= y <= 1.75 2^-16, degree 10, 65.9 bits */
        {
         0.87253823485741744, -1.2758981267804555e-17, -0.013750381351098285, 0.0034113544712027232,
         -0.0012320737535054201, 0.00051568502258793651, -0.00023367753452849347, 0.0001112905691838951,
         -5.4843405681324637e-05, 2.7707687675005401e-05, -1.4304822192314295e-05, 7.4764682902918023e-06
        },
        /* [198] 1.75 <= y <= 1.875 2^-16, degree 10, 65.1 bits */
        {
         0.87087045237642435, -5.2962524749604668e-17, -0.012951533640157706, 0.0029934834139823444,
         -0.0010068215310963448, 0.00039239529414421628, -0.00016556235623936362, 7.3417313517840777e-05,
         -3.3686364402462458e-05, 1.5845837634266953e-05, -7.6141788524582057e-06, 3.705216292072619e-06
        },
        /* [199] 1.875 <= y <= 2 2^-16, degree 10, 68.8 bits */
        {
         0.86929640841340838, -5.5074885290645381e-18, -0.012247481459965192, 0.0026497276038612732,
         -0.00083388814506181886, 0.00030406751427569163, -0.00012002773654257339, 4.9794679944879708e-05,
         -2.1374570830505486e-05, 9.4061771210457687e-06, -4.2271310886408311e-06, 1.9243457337816481e-06
        },
        /* [200] 1 <= y <= 1.125 2^-15, degree 10, 62.4 bits */
        {
         0.86708801330754559, -1.7391579997957503e-17, -0.022668887592187208, 0.0089508889936604566,
         -0.0051382905490460545, 0.0034172011109601407, -0.0024600711683479227, 0.0018612357348463339,
         -0.0014569812109845486, 0.0011692516584299788, -0.00096283853569199601, 0.00079940803337044707
        },
        /* [201] 1.125 <= y <= 1.25 2^-15, degree 10, 63.2 bits */
        {
         0.86438498994605684, -4.4460894078689933e-17, -0.020648022949422137, 0.0073023370401456176,
         -0.0037520900561640951, 0.0022331348566823829, -0.0014386404288169031, 0.00097397988664477619,
         -0.00068224272640058422, 0.00048991442534580744, -0.00036049094814785167, 0.00026780261327528205
        },
        /* [202] 1.25 <= y <= 1.375 2^-15, degree 10, 62.7 bits */
        {
         0.86191126250473205, -7.1141606368263496e-18, -0.018982465879991549, 0.0060797376195969302,
         -0.0028273580015501041, 0.0015228027863049369, -0.00088771775754532031, 0.00054381566778699271,
         -0.00034467666651095551, 0.00022395297566407948, -0.00014895611145590161, 0.00010012093020374981
        },
        /* [203] 1.375 <= y <= 1.5 2^-15, degree 10, 65.7 bits */
        {
         0.85962827459593638, 4.0227968512103073e-17, -0.017584159471222913, 0.005146695128654585,
         -0.0021860246410470539, 0.0010752014761620376, -0.000572358077851205, 0.00032016774936343361,
         -0.00018529470611555236, 0.00010993262294095129, -6.6714262122125097e-05, 4.0943910870801105e-05
        },
        /* [204] 1.5 <= y <= 1.625 2^-15, degree 10, 63.6 bits */
        {
         0.85750664836649959, 1.5629662500154537e-17, -0.016392200198821767, 0.0044176215981521346,
         -0.0017267629514426299, 0.00078150257881022815, -0.00038277869833547561, 0.00019700809628588956,
         -0.00010490317141743059, 5.7261847852314479e-05, -3.1953439031690326e-05, 1.804218078017767e-05
        },
        /* [205] 1.625 <= y <= 1.75 2^-15, degree 10, 64.1 bits */
        {
         0.85552345591497347, -3.8926129519107809e-17, -0.015363065108262138, 0.0038365350612690596,
         -0.0013889330071147239, 0.00058213759278583045, -0.00026403870808679815, 0.00012583935480983902,
         -6.2047812445113e-05, 3.1361961899309072e-05, -1.6197801913352316e-05, 8.4687001357867785e-06
        },
        /* [206] 1.75 <= y <= 1.875 2^-15, degree 10, 64.4 bits */
        {
         0.85366044039481592, 8.6540531261504689e-18, -0.014464790444013347, 0.0033655277432491715,
         -0.0011346859902123471, 0.00044284542217532078, -0.00018702749804990141, 8.2995463888972958e-05,
         -3.8102857719047488e-05, 1.7931741114133409e-05, -8.6199240935867841e-06, 4.1960703324435343e-06
        },
        /* [207] 1.875 <= y <= 2 2^-15, degree 10, 65.7 bits */
        {
         0.85190281448510186, 3.80612766592725e-18, -0.013673351245634202, 0.0029781656720425601,
         -0.0009395417916394002, 0.00034307704550515456, -0.0001355577686760372, 5.6278435795673229e-05,
         -2.4171712493729024e-05, 1.0642161169377029e-05, -4.7845138171081256e-06, 2.1788437771124344e-06
        },
        /* [208] 1 <= y <= 1.125 2^-14, degree 10, 63.0 bits */
        {
         0.84943796387388726, 2.0868889212503547e-17, -0.025294703254151382, 0.01005617181664931,
         -0.0057871565660151825, 0.0038542681141381543, -0.0027774623001571947, 0.0021029268909601492,
         -0.0016471474067572718, 0.0013225044095696555, -0.0010894887916769378, 0.00090488099836622264
        },
        /* [209] 1.125 <= y <= 1.25 2^-14, degree 10, 62.8 bits */
        {
         0.84642281414171028, -3.5884995635032576e-17, -0.02302486665351642, 0.00819984877780283,
         -0.0042239720168003895, 0.0025176862995239164, -0.0016235954171586883, 0.0011000317459151465,
         -0.00077100244114954768, 0.00055392700989958361, -0.00040776562004387896, 0.00030303187072925654
        },
        /* [210] 1.25 <= y <= 1.375 2^-14, degree 10, 64.1 bits */
        {
         0.84366514748202937, 3.2400930987633521e-17, -0.021155032901604112, 0.0068237687639774846,
         -0.0031816019028903211, 0.0017161707669568552, -0.0010014738271589298, 0.00061397807903947196,
         -0.00038938574349559366, 0.00025313076865808912, -0.00016843559320808021, 0.00011325593571771405
        },
        /* [211] 1.375 <= y <= 1.5 2^-14, degree 10, 62.9 bits */
        {
         0.84112156628489843, -3.3557728358673748e-18, -0.019585940309610854, 0.0057740223649716572,
         -0.0024589559364989948, 0.0012112932358786144, -0.00064548092942574744, 0.00036135653337865647,
         -0.00020926343759310431, 0.00012421699062877093, -7.5416060641427817e-05, 4.6301822205490713e-05
        },
        /* [212] 1.5 <= y <= 1.625 2^-14, degree 10, 63.2 bits */
        {
         0.83875901751027404, -1.1656152089710962e-17, -0.018248961974964208, 0.0049540668873927045,
         -0.0019416477778131786, 0.00088012227413861339, -0.00043154317181431001, 0.00022228447902769815,
         -0.00011843780788212515, 6.4683725106403121e-05, -3.6111133456883261e-05, 2.0397596148965281e-05
        },
        /* [213] 1.625 <= y <= 1.75 2^-14, degree 10, 65.7 bits */
        {
         0.83655171477672985, -3.9746390405455112e-17, -0.017095073055825812, 0.0043007763242439217,
         -0.0015612442507469625, 0.00065539101447158329, -0.00029758673693174405, 0.00014194382759385391,
         -7.003377737836952e-05, 3.5417331101350733e-05, -1.8300606236669759e-05, 9.5718361486363833e-06
        },
        /* [214] 1.75 <= y <= 1.875 2^-14, degree 10, 62.7 bits */
        {
         0.83447913240564742, -1.482153717523244e-17, -0.016088281075215555, 0.0037714188214683477,
         -0.0012750452448741518, 0.00049842193458035796, -0.00021073098888961018, 9.359152300710955e-05,
         -4.2995684718557919e-05, 2.0245323160796198e-05, -9.7365536290266031e-06, 4.7415047641342642e-06
        },
        /* [215] 1.875 <= y <= 2 2^-14, degree 10, 64.7 bits */
        {
         0.83252465095929007, -1.0744866087527634e-17, -0.015201541372956498, 0.0033362052666077039,
         -0.0010554407352695251, 0.00038602350876006434, -0.00015269714036931099, 6.3447221192699564e-05,
         -2.7268864995973537e-05, 1.2012340180632791e-05, -5.403035395230168e-06, 2.4615013305550908e-06
        },
        /* [216] 1 <= y <= 1.125 2^-13, degree 10, 61.9 bits */
        {
         0.82978513744286408, -3.1780755783280172e-17, -0.02810493011268907, 0.011259751824186327,
         -0.0064982586204335472, 0.0043350192747295489, -0.0031274526449690861, 0.0023699418967678453,
         -0.001857549969060052, 0.0014922714853212841, -0.0012299321066037243, 0.0010219437405128381
        },
        /* [217] 1.125 <= y <= 1.25 2^-13, degree 10, 62.9 bits */
        {
         0.82643623403724864, 2.5750351838139822e-17, -0.025564158930807965, 0.009175859198125717,
         -0.0047405008626896705, 0.0028303367594420593, -0.0018273379942025164, 0.0012391550686174986,
         -0.00086911536283202197, 0.00062477327216672656, -0.00046014262251663289, 0.00034209870515161564
        },
        /* [218] 1.25 <= y <= 1.375 2^-13, degree 10, 62.6 bits */
        {
         0.82337546776106729, -9.1900800465759447e-19, -0.023472317891690415, 0.0076318658736931784,
         -0.0035689378148955485, 0.0019284196955410969, -0.0011266666215099398, 0.00069134652710117761,
         -0.00043876337501961053, 0.00028539646154031073, -0.00018999995253394091, 0.00012781023596023609
        },
        /* [219] 1.375 <= y <= 1.5 2^-13, degree 10, 62.7 bits */
        {
         0.82055414421343453, 2.3184751641896249e-17, -0.021717839061016167, 0.0064545764729337582,
         -0.0027570794793179703, 0.0013605335521260625, -0.00072588458378642024, 0.00040673758880252058,
         -0.00023571372002378476, 0.00014000081168970662, -8.5041936076409177e-05, 5.2234315899752837e-05
        },
        /* [220] 1.5 <= y <= 1.625 2^-13, degree 10, 62.7 bits */
        {
         0.81793519362355305, -2.1764100424491482e-17, -0.020223621290780543, 0.0055353963374685259,
         -0.00217614334574878, 0.00098817544354817821, -0.00048511897764531462, 0.00025011172455758284,
         -0.00013336249007782233, 7.2878730391857824e-05, -4.0707102372808474e-05, 2.3003813639856644e-05
        },
        /* [221] 1.625 <= y <= 1.75 2^-13, degree 10, 64.0 bits */
        {
         0.81548970859368997, 1.9707396526802359e-17, -0.018934608497866861, 0.0048033466632215029,
         -0.0017491123100865753, 0.00073558537562419524, -0.0003344162426031615, 0.00015966048114139967,
         -7.8833693811254565e-05, 3.9892083241297512e-05, -2.0623530157013314e-05, 1.0791644021756181e-05
        },
        /* [222] 1.75 <= y <= 1.875 2^-13, degree 10, 66.0 bits */
        {
         0.81319468854248778, -1.2478818041850201e-17, -0.017810395662295815, 0.004210397215190685,
         -0.0014279469031449942, 0.00055921708439143208, -0.00023673398550684463, 0.00010524021238121856,
         -4.8383598041494054e-05, 2.2796514201954013e-05, -1.0969297362557854e-05, 5.3442581817067681e-06
        },
        /* [223] 1.875 <= y <= 2 2^-13, degree 10, 63.0 bits */
        {
         0.8110315172651239, -3.3788069225192324e-17, -0.016820633408489029, 0.0037230766714516986,
         -0.0011815948017296254, 0.00043296794167323616, -0.00017148617603132688, 7.1322960107661417e-05,
         -3.067724369882439e-05, 1.3522313591915673e-05, -6.0854686241165366e-06, 2.7736821190089576e-06
        },
        /* [224] 1 <= y <= 1.125 2^-12, degree 10, 62.1 bits */
        {
         0.80800124734176038, 2.5039543455549043e-17, -0.03107730788542375, 0.012558570343792029,
         -0.0072714027534785302, 0.0048599765438993251, -0.003510753754100824, 0.0026630152707435924,
         -0.0020888882097263384, 0.0016791975654117204, -0.0013847589061448263, 0.0011511290803900846
        },
        /* [225] 1.125 <= y <= 1.25 2^-12, degree 10, 64.3 bits */
        {
         0.80429969819053959, 4.3963302281330186e-17, -0.028244391748069312, 0.010227419700389803,
         -0.0053013091826342139, 0.0031712969400267549, -0.0020502024313605476, 0.0013916800549624371,
         -0.00097687174965606122, 0.00070269708598127891, -0.00051782395887301402, 0.00038516766271406522
        },
        /* [226] 1.25 <= y <= 1.375 2^-12, degree 10, 64.8 bits */
        {
         0.80091931509195491, 2.7654901606325915e-17, -0.025913531453184365, 0.0085012323981444541,
         -0.0039889344256289119, 0.0021596124134762133, -0.0012634564456422109, 0.00077607783235660098,
         -0.00049293907828317093, 0.00032085059891633083, -0.00021372548162442188, 0.00014384059339483967
        },
        /* [227] 1.375 <= y <= 1.5 2^-12, degree 10, 63.8 bits */
        {
         0.79780565596358233, -5.4771320096773823e-17, -0.023959744927409078, 0.0071857259052045793,
         -0.0030799524150699276, 0.0015229144426273163, -0.00081364519530706674, 0.00045638834544214137,
         -0.00026470671954864394, 0.00015732850478380277, -9.5623102942478044e-05, 5.8762816287482667e-05
        },
        /* [228] 1.5 <= y <= 1.625 2^-12, degree 10, 63.4 bits */
        {
         0.79491729788114651, -1.4096125667459919e-17, -0.022296704618898155, 0.0061591424843469821,
         -0.0024298201220899502, 0.0011056211292731198, -0.0005435402239290974, 0.00028052899634454294,
         -0.00014970741268616579, 8.1867619699957223e-05, -4.5754985549882138e-05, 2.5869544028669352e-05
        },
        /* [229] 1.625 <= y <= 1.75 2^-12, degree 10, 62.6 bits */
        {
         0.79222195500548764, 3.236502363055134e-17, -0.020862794993835147, 0.0053419353092145558,
         -0.0019521321568712279, 0.00082266582440915594, -0.00037453995778590957, 0.00017900928852457722,
         -8.8462978892277561e-05, 4.4796371499681335e-05, -2.3172868915557739e-05, 1.2131893141226614e-05
        },
        /* [230] 1.75 <= y <= 1.875 2^-12, degree 10, 62.9 bits */
        {
         0.78969395067163417, -8.5279032385048586e-18, -0.019612816912042676, 0.0046802987142317608,
         -0.0015930146881660552, 0.00062517184121272447, -0.00026503835660732222, 0.00011795159321611364,
         -5.4274661343695975e-05, 2.5590469159013241e-05, -1.2321196927001389e-05, 6.0060500485025311e-06
        },
        /* [231] 1.875 <= y <= 2 2^-12, degree 10, 63.7 bits */
        {
         0.78731251183524953, 2.4535724272413539e-17, -0.018512833935399695, 0.0041367512417946695,
         -0.0013176571893042327, 0.00048385203044911377, -0.00019192136213184429, 7.991049195150167e-05,
         -3.4401126745317378e-05, 1.5174777770902044e-05, -6.8333407188521439e-06, 3.1162065926445748e-06
        },
        /* [232] 1 <= y <= 1.125 2^-11, degree 10, 61.7 bits */
        {
         0.78397865916430176, 1.8858674152435318e-17, -0.034177701089335627, 0.013945245111496366,
         -0.0081041506877649692, 0.0054282877683636327, -0.0039271544926281852, 0.002982224409239139,
         -0.0023413739674223786, 0.0018835547022177418, -0.0015542663185410162, 0.0012927361907855261
        },
        /* [233] 1.125 <= y <= 1.25 2^-11, degree 10, 62.8 bits */
        {
         0.77990972834367867, -1.0456834077452789e-17, -0.031033167284321032, 0.011347986781369468,
         -0.0059043501878228702, 0.0035398540222150283, -0.0022919664963382963, 0.0015575814083800073,
         -0.0010943253854694664, 0.00078778027191779413, -0.00058089744109880931, 0.00043232176229826157
        },
        /* [234] 1.25 <= y <= 1.375 2^-11, degree 10, 62.9 bits */
        {
         0.77619716253244286, -5.0048068553790316e-17, -0.028447821001103994, 0.009426029773927376,
         -0.0044398679637526585, 0.0024091665106981759, -0.0014116508937283693, 0.00086812451702533288,
         -0.00055191918186895024, 0.00035951721557006615, -0.00023963966258314285, 0.000161372196167179
        },
        /* [235] 1.375 <= y <= 1.5 2^-11, degree 10, 65.3 bits */
        {
         0.77278034316890143, -1.8043310559614714e-18, -0.026282188486869099, 0.0079622274938480515,
         -0.0034261139891372952, 0.001697962513738109, -0.00090860609264394965, 0.00051026286432944226,
         -0.00029623556776302052, 0.00017620585037737485, -0.00010716825427550412, 6.5895429203448802e-05
        },
        /* [236] 1.5 <= y <= 1.625 2^-11, degree 10, 63.1 bits */
        {
         0.76961317641192661, 3.7655186472122519e-17, -0.024439988371856847, 0.006820568459063237,
         -0.0027014312974285321, 0.0012320736309841937, -0.00060668202102741905, 0.00031349781435053897,
         -0.00016746331857635764, 9.1650508503841185e-05, -5.1257346675735584e-05, 2.8997465365571067e-05
        },
        /* [237] 1.625 <= y <= 1.75 2^-11, degree 10, 65.7 bits */
        {
         0.76665975642052853, -4.0822882370264276e-17, -0.022852537596950787, 0.0059122390916206821,
         -0.0021692317423607993, 0.00091631632460269501, -0.00041785886376528706, 0.00019995961402710172,
         -9.8913207297836821e-05, 5.0128785210164574e-05, -2.5949168163847178e-05, 1.3593450393624899e-05
        },
        /* [238] 1.75 <= y <= 1.875 2^-11, degree 10, 63.4 bits */
        {
         0.7638915428523958, 1.7636790492438948e-17, -0.021469477771592901, 0.0051771943648803104,
         -0.001769320224889489, 0.00069602542563025496, -0.00029556546105164784, 0.00013170173191707913,
         -6.0662008989023782e-05, 2.8625594100900048e-05, -1.3792167770938424e-05, 6.7271291870312331e-06
        },
        /* [239] 1.875 <= y <= 2 2^-11, degree 10, 65.1 bits */
        {
         0.76128545747255993, 4.6999564788939566e-17, -0.020253016567219451, 0.0045736251690423292,
         -0.0014628185038984096, 0.00053845897953772612, -0.0002139399250809844, 8.9191217197054809e-05,
         -3.8435151919674473e-05, 1.6968348198361607e-05, -7.6464093971464828e-06, 3.4891158467238014e-06
        },
        /* [240] 1 <= y <= 1.125 2^-10, degree 10, 61.3 bits */
        {
         0.75763978529563936, -2.989571399906813e-17, -0.037358399781720966, 0.015407014378659325,
         -0.0089911693905654361, 0.0060372868838661524, -0.0043752041148993979, 0.0033267510100510114,
         -0.0026145462664755653, 0.0021050948813909733, -0.0017383378978644735, 0.001446731669849544
        },
        /* [241] 1.125 <= y <= 1.25 2^-10, degree 10, 61.6 bits */
        {
         0.7531945110288748, 9.6825746029879996e-18, -0.033885735244219978, 0.012526574245177537,
         -0.0065454256131138372, 0.0039340845612638193, -0.0025516657297999482, 0.0017363529440525861,
         -0.0012212062609887177, 0.00087988035451178786, -0.00064929126304195798, 0.00048352903079904497
        },
        /* [242] 1.25 <= y <= 1.375 2^-10, degree 10, 62.5 bits */
        {
         0.74914262650011554, 1.8052824277554328e-17, -0.031032999930975434, 0.010396682974002593,
         -0.0049183688776008611, 0.0026756589669740074, -0.0015705901538700874, 0.00096716458735292396,
         -0.000615542509250062, 0.00040131521580181388, -0.00026770226511821935, 0.00018038604738687054
        },
        /* [243] 1.375 <= y <= 1.5 2^-10, degree 10, 63.1 bits */
        {
         0.74541695221545679, 1.5825667693998514e-17, -0.028645229310803075, 0.0087756481886002696,
         -0.0037928143917355141, 0.0018846014327916147, -0.0010103038404677142, 0.00056815042130194777,
         -0.00033020145717397968, 0.00019658587684416787, -0.00011965504782935826, 7.3621751231724077e-05
        },
        /* [244] 1.5 <= y <= 1.625 2^-10, degree 10, 64.7 bits */
        {
         0.74196644151045132, -3.2312028791380155e-17, -0.026615519365542042, 0.0075121798222737568,
         -0.0029887002773329847, 0.0013667029044029369, -0.00067421107948596639, 0.00034887654572774243,
         -0.00018656793273033739, 0.00010219949377607118, -5.7201577001880347e-05, 3.2381923333843439e-05
        },
        /* [245] 1.625 <= y <= 1.75 2^-10, degree 10, 62.8 bits */
        {
         0.73875135643425482, -3.3711146309908735e-17, -0.024867656119815458, 0.0065075455053734089,
         -0.0023985024621365702, 0.0010158857670947126, -0.00046412816588181567, 0.00022241391479392797,
         -0.00011014407407103633, 5.5872297908132499e-05, -2.894513983560209e-05, 1.5173195958320717e-05
        },
        /* [246] 1.75 <= y <= 1.875 2^-10, degree 10, 62.8 bits */
        {
         0.73574012989664572, 2.7431794252510193e-17, -0.023345791518796614, 0.005695030795309545,
         -0.0019552457070836191, 0.00077125935350665759, -0.00032813209653175706, 0.00014642195419261548,
         -6.7518905600821139e-05, 3.1891224725518295e-05, -1.5377886811415726e-05, 7.5057346076599097e-06
        },
        /* [247] 1.875 <= y <= 2 2^-10, degree 10, 62.7 bits */
        {
         0.73290725078379793, 5.7828554394734703e-18, -0.022008035929008924, 0.0050282064935586752,
         -0.0016156940270622639, 0.00059637037136348308, -0.00023740244173588564, 9.9115816515267456e-05,
         -4.2761181072692992e-05, 1.8896179664757159e-05, -8.5220440438681237e-06, 3.8913908094936725e-06
        },
        /* [248] 1 <= y <= 1.125 2^-9, degree 10, 61.1 bits */
        {
         0.72894755266455091, -2.6176736278708553e-17, -0.040556960562096789, 0.016924706310569117,
         -0.0099235458727707747, 0.006682012998120811, -0.0048518575069406503, 0.0036946095380991986,
         -0.0029070576747551842, 0.0023428783286199312, -0.0019363023598819333, 0.0016126325146178927
        },
        /* [249] 1.125 <= y <= 1.25 2^-9, degree 10, 62.5 bits */
        {
         0.72412449532302181, 1.6800186620644492e-18, -0.036744062760228451, 0.013746940521461821,
         -0.007217694579153641, 0.0043505437823695469, -0.0028273874479122474, 0.0019268660689169884,
         -0.0013568207096037025, 0.00097855861884542069, -0.00072272102741689802, 0.00053860318806531085
        },
        /* [250] 1.25 <= y <= 1.375 2^-9, degree 10, 62.5 bits */
        {
         0.7197331689802271, 4.6974944935753885e-17, -0.033614799868776267, 0.011399226436314068,
         -0.0054190586452212974, 0.0029566167996947544, -0.0017390208868111906, 0.0010725229064327102,
         -0.00068343006658947271, 0.00044602552163435156, -0.00029778345063785784, 0.00020080424453314166
        },
        /* [251] 1.375 <= y <= 1.5 2^-9, degree 10, 62.7 bits */
        {
         0.71569952036036022, -3.7111084324988748e-18, -0.030997856201980211, 0.0096138297593915071,
         -0.0041757392289741525, 0.0020810059248164464, -0.0011178875997987154, 0.00062962947521245916,
         -0.00036638669020539746, 0.00021835276581855256, -0.00013302030544952204, 8.1906846835288916e-05
        },
        /* [252] 1.5 <= y <= 1.625 2^-9, degree 10, 62.4 bits */
        {
         0.71196732486652292, -3.9543920544718594e-17, -0.028775137016149425, 0.0082232803244486809,
         -0.0032881071476115247, 0.0015081297696777547, -0.00074553225123157648, 0.00038639225349414738,
         -0.00020689076772124475, 0.00011345029263506998, -6.3555207662487057e-05, 3.6006278065509522e-05
        },
        /* [253] 1.625 <= y <= 1.75 2^-9, degree 10, 64.3 bits */
        {
         0.70849284623584419, -1.0940127061836342e-18, -0.026862509140093919, 0.0071183596723884846,
         -0.0026370306469929534, 0.0011203109039109832, -0.0005129207512506996, 0.00024618987632383051,
         -0.00012207444914002092, 6.1989702387936352e-05, -3.2143290544467853e-05, 1.6862779140572344e-05
        },
        /* [254] 1.75 <= y <= 1.875 2^-9, degree 10, 62.6 bits */
        {
         0.70524136525743708, 2.3535893932392384e-17, -0.025198361689191918, 0.0062253137965810994,
         -0.0021483488399845385, 0.0008500395636241387, -0.00036242485546520608, 0.0001619871432900087,
         -7.4793280336869048e-05, 3.5365025687105733e-05, -1.7068533439749268e-05, 8.3374799641151287e-06
        },
        /* [255] 1.875 <= y <= 2 2^-9, degree 10, 63.6 bits */
        {
         0.70218484163364914, -5.508000296068352e-17, -0.023736510781098764, 0.005492844367895479,
         -0.0017742140023998764, 0.00065692191250363557, -0.00026207442822520719, 0.00010959637211603826,
         -4.734485125237073e-05, 2.0944428931835835e-05, -9.4545288925289035e-06, 4.3206332287028701e-06
        },
        /* [256] 1 <= y <= 1.125 2^-8, degree 10, 61.5 bits */
        {
         0.69791641401620708, -5.3950194052958033e-17, -0.043695954855686163, 0.018471869886416158,
         -0.010888130479160594, 0.0073547229081981375, -0.0053521033881356508, 0.0040823560558523693,
         -0.003216441268235139, 0.0025950836994979997, -0.0021467756717007723, 0.0017893740966554057
        },
        /* [257] 1.125 <= y <= 1.25 2^-8, degree 10, 63.1 bits */
        {
         0.6927234231792988, 2.5548193090736393e-17, -0.039536772570180616, 0.014986926456877658,
         -0.0079112121936622832, 0.0047839554286759336, -0.003116057635308647, 0.0021272197695177968,
         -0.0014999436216316061, 0.0010830013537254596, -0.00080063107826271272, 0.00059715968391935224
        },
        /* [258] 1.25 <= y <= 1.375 2^-8, degree 10, 61.6 bits */
        {
         0.68800112606952479, -3.8839358083048936e-17, -0.036126954960352911, 0.012414789477477765,
         -0.0059342152106150788, 0.0032483111608422751, -0.0019149673659712978, 0.001183088760660985,
         -0.00075493128079938583, 0.00049325544261927636, -0.00032963973409618245, 0.00022247365498621549
        },
        /* [259] 1.375 <= y <= 1.5 2^-8, degree 10, 61.7 bits */
        {
         0.68366838630582338, -4.2259435378461823e-17, -0.033278185912951334, 0.010460482613971436,
         -0.0045687605909648012, 0.0022844602334057659, -0.0012300377213007383, 0.00069401991456339196,
         -0.00040442615466779836, 0.00024130455033142265, -0.0001471493427715557, 9.068462176366066e-05
        },
        /* [260] 1.5 <= y <= 1.625 2^-8, degree 10, 62.6 bits */
        {
         0.6796636574067938, -5.2001393300067603e-19, -0.030860762949959479, 0.0089396472353585818,
         -0.003594699440315935, 0.0016543257496578348, -0.00081973518799105375, 0.00042561178847502524,
         -0.00022821718941427494, 0.00012529332983887299, -7.0260846479410161e-05, 3.9840006900345351e-05
        },
        /* [261] 1.625 <= y <= 1.75 2^-8, degree 10, 64.1 bits */
        {
         0.67593910352228492, 1.7043144900219606e-17, -0.028782356629871712, 0.0077321421889400615,
         -0.0028807510820100034, 0.0012280437039271473, -0.00056359113891983181, 0.00027100224818260528,
         -0.00013457307936849363, 6.8418784498530625e-05, -3.5513379514743332e-05, 1.8647269531926603e-05
        },
        /* [262] 1.75 <= y <= 1.875 2^-8, degree 10, 64.8 bits */
        {
         0.67245678078766935, -4.6115716072305949e-17, -0.026975403903847239, 0.006756894933029548,
         -0.0023452476863219046, 0.00093116260919241074, -0.00039797510656376146, 0.00017820395584322091,
         -8.2402094610705217e-05, 3.9010262754287736e-05, -1.884744995451106e-05, 9.2146908472991741e-06
        },
        /* [263] 1.875 <= y <= 2 2^-8, degree 10, 63.1 bits */
        {
         0.66918606705320949, -7.6327882200679286e-18, -0.025389294188349187, 0.0059575542541968731,
         -0.0019355318931706586, 0.00071916284286284698, -0.00028760857334645643, 0.0001204985078935778,
         -5.2132050466069706e-05, 2.3090654561177657e-05, -1.043432689198417e-05, 4.7727245172527825e-06
        },
        /* [264] 1 <= y <= 1.125 2^-7, degree 10, 60.7 bits */
        {
         0.66462308807687931, 2.0041862615271075e-17, -0.046684022942818849, 0.020014252024078163,
         -0.011867003742712297, 0.0080444529226923276, -0.0058686112633136098, 0.004484801719771633,
         -0.003538875399439615, 0.002858812703178767, -0.0023674959287867323, 0.0019751703241470391
        },
        /* [265] 1.125 <= y <= 1.25 2^-7, degree 10, 61.0 bits */
        {
         0.65907893061238454, 3.9996051785604644e-19, -0.042180305813425759, 0.016218097268966447,
         -0.0086125698006868472, 0.0052269403659460714, -0.0034132428057283741, 0.0023345956146162737,
         -0.0016487113445519256, 0.0011919399364511596, -0.00088213396033847943, 0.00065856970641869287
        },
        /* [266] 1.25 <= y <= 1.375 2^-7, degree 10, 62.2 bits */
        {
         0.65404415885939404, 4.5136218551971786e-17, -0.038492439218150272, 0.013419351109816442,
         -0.0064535228397683943, 0.0035455819502465628, -0.0020956141314600685, 0.001297237557052809,
         -0.0008290713893160615, 0.00054240301638957687, -0.00036288949131986649, 0.0002451490392518122
        },
        /* [267] 1.375 <= y <= 1.5 2^-7, degree 10, 61.2 bits */
        {
         0.649430483032027, -3.0431128822127552e-17, -0.035414751303042565, 0.011295020011871059,
         -0.0049637589290476274, 0.0024912407919392087, -0.0013448931251320427, 0.00076033846608789565,
         -0.00044377982287456471, 0.00026513602869090991, -0.00016186522967420765, 9.9851049914930198e-05
        },
        /* [268] 1.5 <= y <= 1.625 2^-7, degree 10, 61.5 bits */
        {
         0.64517099883891416, -3.0440984363508438e-17, -0.032805723092809547, 0.0096434226255338231,
         -0.0039019628614372333, 0.0018025323018784525, -0.00089554772590715493, 0.00046591524725951426,
         -0.00025023327715987382, 0.00013756505043938848, -7.7231142253683286e-05, 4.3835775580716827e-05
        },
        /* [269] 1.625 <= y <= 1.75 2^-7, degree 10, 63.2 bits */
        {
         0.64121375531670688, 8.1604354124367149e-19, -0.030564703743706092, 0.0083332421343433917,
         -0.0031243517554223749, 0.0013369944023659886, -0.00061524461881633556, 0.00029644644335619595,
         -0.00014744988034082546, 7.5067678596463409e-05, -3.9009919534036939e-05, 2.0503808040138601e-05
        },
        /* [270] 1.75 <= y <= 1.875 2^-7, degree 10, 63.4 bits */
        {
         0.6375175807111898, 9.3688936197420954e-18, -0.028618102350385432, 0.0072759354788277941,
         -0.0025415496418480722, 0.0010130146761263296, -0.00043413801741027302, 0.00019480035785705149,
         -9.022614152494839e-05, 4.2773210437424605e-05, -2.0689839580385799e-05, 1.0125748930846253e-05
        },
        /* [271] 1.875 <= y <= 2 2^-7, degree 10, 62.6 bits */
        {
         0.63404927521678511, -2.8727788040299004e-17, -0.026910835984109524, 0.0064100050273764248,
         -0.0020959709393180027, 0.00078182592805890923, -0.00031353015080996924, 0.00013163452542444266,
         -5.7045709158621976e-05, 2.5302314962307679e-05, -1.1447372195226041e-05, 5.2414915794384342e-06
        },
        /* [272] 1 <= y <= 1.125 2^-6, degree 10, 60.4 bits */
        {
         0.629215927933647, -3.2709694716466096e-17, -0.049418598705789012, 0.021509844313846321,
         -0.012837194125099491, 0.0087367096932127568, -0.0063914506759484594, 0.0048947687745101998,
         -0.0038689739983257115, 0.0031299100598521897, -0.002595167220098477, 0.0021673786957106095
        },
        /* [273] 1.125 <= y <= 1.25 2^-6, degree 10, 62.2 bits */
        {
         0.62335157669855568, -4.7080224649777487e-17, -0.044581623975702513, 0.017405870849911867,
         -0.0093047314429448476, 0.0056698374545454591, -0.0037129992331180087, 0.002545138373280333,
         -0.0018005288454323789, 0.0013035789545929844, -0.00096595440053119045, 0.00072191666509006426
        },
        /* [274] 1.25 <= y <= 1.375 2^-6, degree 10, 61.2 bits */
        {
         0.61803394697745795, -1.5609187259466074e-17, -0.040626129959340465, 0.014383915438673159,
         -0.0069639785665984296, 0.0038417302400907583, -0.0022772207254654147, 0.0014127685434267355,
         -0.0009045071030015908, 0.00059262570060167406, -0.00039699077525467502, 0.0002684773881267015
        },
        /* [275] 1.375 <= y <= 1.5 2^-6, degree 10, 62.3 bits */
        {
         0.61316770130837961, -1.7097787215801452e-17, -0.037329117288488589, 0.012092759921944462,
         -0.0053505720680608196, 0.0026965499113967505, -0.0014600010462291545, 0.00082726446740303801,
         -0.00048371022762727764, 0.00028942412192720063, -0.00017691926768985552, 0.00010925800630525808
        },
        /* [276] 1.5 <= y <= 1.625 2^-6, degree 10, 63.1 bits */
        {
         0.60868067740785659, 4.0585777531142891e-17, -0.034537311228226647, 0.010313328996649791,
         -0.0042017967738087175, 0.00194921921513909, -0.00097130526147876626, 0.00050647633659138319,
         -0.0002725137794447042, 0.00015004065420251794, -8.4344413522840716e-05, 4.7926821649442462e-05
        },
        /* [277] 1.625 <= y <= 1.75 2^-6, degree 10, 62.5 bits */
        {
         0.60451690068775743, -3.5955634190781873e-17, -0.03214180961086676, 0.0089031185281602254,
         -0.0033612660334777413, 0.0014445051493782036, -0.00066671808061914413, 0.00032198686287804356,
         -0.00016044921210947967, 8.1811077882875503e-05, -4.2570053440727084e-05, 2.240042431714224e-05
        },
        /* [278] 1.75 <= y <= 1.875 2^-6, degree 10, 63.1 bits */
        {
         0.60063205421280241, -4.5251025357377681e-18, -0.03006306302855952, 0.007766128674792626,
         -0.0027318541948879844, 0.0010935548793577327, -0.00047008029086286667, 0.00021141847009335365,
         -9.8106151537788718e-05, 4.658108925245671e-05, -2.2561683681539252e-05, 1.10545278209738e-05
        },
        /* [279] 1.875 <= y <= 2 2^-6, degree 10, 63.5 bits */
        {
         0.5969904348398466, -1.7760365096253316e-17, -0.028241580697687244, 0.0068357388467356773,
         -0.0022510336020853416, 0.00084331697832604701, -0.00033922904002730171, 0.00014275890643076862,
         -6.1983472671153322e-05, 2.7535603571750461e-05, -1.2474494433533108e-05, 5.7184247933718591e-06
        },
        /* [280] 1 <= y <= 1.125 2^-5, degree 10, 60.9 bits */
        {
         0.59192158847727239, 4.6758804060127933e-17, -0.051790543037625932, 0.022909734221699146,
         -0.013770798062786456, 0.0094133914689885183, -0.0069079541430924641, 0.0053029413160872192,
         -0.0041996418702498171, 0.0034028293090280267, -0.0028253366879111125, 0.0023623896275678361
        },
        /* [281] 1.125 <= y <= 1.25 2^-5, degree 10, 61.0 bits */
        {
         0.58578094489250276, 3.7753143484764655e-17, -0.046642635596050232, 0.018510318780916402,
         -0.0099671766529613025, 0.0061006834852321444, -0.0040078119572940262, 0.002753890197636008,
         -0.0019520101060086518, 0.0014155455424760426, -0.0010503871844930951, 0.00078596188409049835
        },
        /* [282] 1.25 <= y <= 1.375 2^-5, degree 10, 62.2 bits */
        {
         0.58022174879972643, 2.7032661493846727e-17, -0.042439041045403261, 0.015275258232782524,
         -0.0074500376223742108, 0.0041285242524094715, -0.0024550949773977752, 0.001526874422226256,
         -0.00097950033090170177, 0.00064281959061521189, -0.00043122542341791638, 0.00029198606992212049
        },
        /* [283] 1.375 <= y <= 1.5 2^-5, degree 10, 61.6 bits */
        {
         0.57514193213401055, -2.7294687721924842e-17, -0.038939934182048136, 0.012825618042457011,
         -0.0057171344663040679, 0.0028945328264303274, -0.0015723063516888619, 0.0008931254719489447,
         -0.00052327026845813045, 0.00031361876812521436, -0.00019198450992779739, 0.00011870879546703616
        },
        /* [284] 1.5 <= y <= 1.625 2^-5, degree 10, 62.8 bits */
        {
         0.57046433622984272, -4.0084807384072101e-17, -0.035980675465960704, 0.010925311840068582,
         -0.0044846437367086593, 0.0020901056579778199, -0.0010449476912178187, 0.00054625553069549031,
         -0.000294516238475756, 0.00016242989068737359, -9.1441833482472446e-05, 5.2025140685712907e-05
        },
        /* [285] 1.625 <= y <= 1.75 2^-5, degree 10, 61.3 bits */
        {
         0.56612918106713961, -5.3551430159843912e-17, -0.033444419069336297, 0.0094209363227576552,
         -0.0035837914210912671, 0.001547371706755164, -0.00071658054332125048, 0.0003469537358091192,
         -0.00017324697766269028, 8.8488210109067769e-05, -4.6112265763976969e-05, 2.4295255242854037e-05
        },
        /* [286] 1.75 <= y <= 1.875 2^-5, degree 10, 63.7 bits */
        {
         0.56208918837475474, -3.9137684203923924e-17, -0.031245901884668196, 0.0082092531995130204,
         -0.0029098610231146943, 0.0011703360560731903, -0.00050478229974444688, 0.00022761323763973603,
         -0.00010584134405890762, 5.0341059465389269e-05, -2.4419126267692219e-05, 1.1980038775963569e-05
        },
        /* [287] 1.875 <= y <= 2 2^-5, degree 10, 62.7 bits */
        {
         0.55830630804058168, 9.7519179206716853e-18, -0.029321422228384814, 0.0072186859944327539,
         -0.0023954996388529607, 0.00090173407967198988, -0.00036396247695526349, 0.00015356789446655474,
         -6.6816983130642887e-05, 2.9734936988817163e-05, -1.3491114171480364e-05, 6.1925103745026676e-06
        },
        /* [288] 1 <= y <= 1.125 2^-4, degree 10, 60.1 bits */
        {
         0.55304756898879093, -3.0853639078793607e-18, -0.053690686769619286, 0.024159959256544777,
         -0.014635657153626788, 0.010053053066274907, -0.0074028080730194953, 0.0056978750853533397,
         -0.0045220450544142324, 0.0036705841935331268, -0.0030523370014680791, 0.0025555663523230206
        },
        /* [289] 1.125 <= y <= 1.25 2^-4, degree 10, 60.7 bits */
        {
         0.54668739545867673, 4.4258932895577664e-17, -0.048266305434129492, 0.019487789670124139,
         -0.010576458792734191, 0.0065054249950487085, -0.0042886725673838859, 0.0029548120424132359,
         -0.0020989753545975617, 0.0015248767665291404, -0.0011332811751668531, 0.00084912847860232584
        },
        /* [290] 1.25 <= y <= 1.375 2^-4, degree 10, 62.3 bits */
        {
         0.54093941455959749, 3.6606011104063477e-17, -0.043844050823321185, 0.016057359302452823,
         -0.0078940771780135009, 0.0043963676042800721, -0.0026236548079801663, 0.001636161621871869,
         -0.0010519219309525032, 0.00069161691556335542, -0.0004646945724490809, 0.0003150781890448362
        },
        /* [291] 1.375 <= y <= 1.5 2^-4, degree 10, 61.1 bits */
        {
         0.53569538536854799, -3.0715651266584485e-17, -0.040168328034998466, 0.01346338091341197,
         -0.0060498657354107867, 0.0030784117788755657, -0.0016781995384526857, 0.00095591368382691791,
         -0.00056130778292197263, 0.00033704317595615213, -0.00020665463241597998, 0.00012795678075849158
        },
        /* [292] 1.5 <= y <= 1.625 2^-4, degree 10, 64.0 bits */
        {
         0.5308735972952543, 2.3348147486007725e-17, -0.037063907525941166, 0.011453678744387635,
         -0.0047398178799662764, 0.0022202678107594437, -0.001114056529712183, 0.00058401274482791112,
         -0.00031558492033956437, 0.00017437790990384864, -9.8327282559839508e-05, 5.6021099470272803e-05
        },
        /* [293] 1.625 <= y <= 1.75 2^-4, degree 10, 62.3 bits */
        {
         0.52641082527442051, -2.1583713108379238e-17, -0.034406581767631311, 0.0098645917800987363,
         -0.0037833694566460113, 0.001641930597762249, -0.00076316196264092958, 0.00037055273432994067,
         -0.0001854536874960301, 9.4903671292069928e-05, -4.9536494625224284e-05, 2.6136458996122074e-05
        },
        /* [294] 1.75 <= y <= 1.875 2^-4, degree 10, 64.1 bits */
        {
         0.5222571263090946, 3.5156173756261675e-17, -0.032105820041873449, 0.0085861012265771915,
         -0.0030686104638033736, 0.0012405759687212096, -0.00053706060127150634, 0.00024285970665955604,
         -0.00011319173461587251, 5.3940895074724654e-05, -2.6208626898913579e-05, 1.2876432754543345e-05
        },
        /* [295] 1.875 <= y <= 2 2^-4, degree 10, 65.1 bits */
        {
         0.51837235061641085, -2.1252665110219414e-18, -0.030094057803490403, 0.0075420090171501785,
         -0.002523634224131282, 0.00095492628407408786, -0.00038687279893514207, 0.00016370502308928186,
         -7.1393596408081503e-05, 3.1833465183109797e-05, -1.4467376639965768e-05, 6.6502533272658365e-06
        },
        /* [296] 1 <= y <= 1.125 2^-3, degree 10, 59.9 bits */
        {
         0.51297932542252056, -3.9577323404612773e-17, -0.055017946491508408, 0.025204460484561455,
         -0.015396715605436314, 0.010631619692113261, -0.0078584567441760157, 0.0060662348471551848,
         -0.0048257518743660749, 0.0039248311958280536, -0.0032693321999943811, 0.0027412670611626083
        },
        /* [297] 1.125 <= y <= 1.25 2^-3, degree 10, 60.8 bits */
        {
         0.50646820693695738, 1.5794306449366263e-17, -0.049364090418627452, 0.020293413441509967,
         -0.011107260517199204, 0.0068684268489843884, -0.0045453436515909456, 0.0031409272593042985,
         -0.0022365307144087557, 0.0016280639286522635, -0.0012120635852344755, 0.00090951399364496181
        },
        /* [298] 1.25 <= y <= 1.375 2^-3, degree 10, 62.1 bits */
        {
         0.50059463550464423, 3.7773881668343938e-17, -0.044762757801810014, 0.016693553983314301,
         -0.0082772338398058726, 0.0046346714918555493, -0.0027766069296977836, 0.0017367401796046663,
         -0.0011192981448678607, 0.00073741031287697506, -0.00049633135368368491, 0.00033703908793507938
        },
        /* [299] 1.375 <= y <= 1.5 2^-3, degree 10, 61.4 bits */
        {
         0.49524501399631143, -2.4571906352545631e-17, -0.040944254995188854, 0.013975575043206175,
         -0.0063343468139659409, 0.0032407647769148846, -0.0017736409478717155, 0.0010133440447454537,
         -0.00059649353540979237, 0.00035890754057392411, -0.0002204507117724056, 0.00013670870923036238
        },
        /* [300] 1.5 <= y <= 1.625 2^-3, degree 10, 62.5 bits */
        {
         0.49033371938699705, -1.0512358177676777e-17, -0.037723959474190494, 0.011872738860735305,
         -0.004956059055216352, 0.0023343519023900287, -0.0011759434277071224, 0.00061834597320919256,
         -0.00033496822677442118, 0.00018547326681254739, -0.00010477107546911963, 5.9785171630703794e-05
        },
        /* [301] 1.625 <= y <= 1.75 2^-3, degree 10, 61.5 bits */
        {
         0.48579459242717266, -5.4719091642707598e-19, -0.034971183447298562, 0.010212162504773931,
         -0.0039510458027490897, 0.0017242248093244622, -0.00080461771078155339, 0.00039189134680746177,
         -0.0001966256096985903, 0.00010083224413334693, -5.2726246359710846e-05, 2.7863147381268147e-05
        },
        /* [302] 1.75 <= y <= 1.875 2^-3, degree 10, 62.6 bits */
        {
         0.48157544045423351, -1.3348793694741248e-17, -0.032590792920806702, 0.0088777702886961383,
         -0.003200869885928154, 0.0013012882012378747, -0.00056561582705528992, 0.00025657144541101442,
         -0.00011988546480778992, 5.7251968892461743e-05, -2.7868197341359401e-05, 1.3713516602846183e-05
        },
        /* [303] 1.875 <= y <= 2 2^-3, degree 10, 62.3 bits */
        {
         0.47763435616178096, -2.3169188579367485e-17, -0.030511871276689837, 0.0077892610999128684,
         -0.0026295156946870798, 0.0010005984374578719, -0.00040702363194225916, 0.00017277425026057761,
         -7.5541316082366661e-05, 3.3754970060530529e-05, -1.536889574028332e-05, 7.0759717841497578e-06
        },
        /* [304] 1 <= y <= 1.125 2^-2, degree 10, 59.8 bits */
        {
         0.4721710375907644, -3.8405578750735125e-18, -0.05568828638715019, 0.02598905839139513,
         -0.016018102683073882, 0.011123616310938222, -0.0082558848162421501, 0.0063933180086743393,
         -0.0050990957109392663, 0.004156127202962193, -0.003468505004266815, 0.002912982098950208
        },
        /* [305] 1.125 <= y <= 1.25 2^-2, degree 10, 60.3 bits */
        {
         0.46558728143156131, -1.1266390905029033e-17, -0.049863996395787986, 0.020884397958829955,
         -0.011533966063842037, 0.0071733142435001169, -0.0047668442834124447, 0.0033046157465300712,
         -0.002359252754472465, 0.0017211713351338487, -0.0012838182077540166, 0.00096494243794422515
        },
        /* [306] 1.25 <= y <= 1.375 2^-2, degree 10, 62.0 bits */
        {
         0.45965969072261958, 1.8455117283486829e-17, -0.045132780910071724, 0.017149310577751764,
         -0.0085806207005759867, 0.0048324513573359783, -0.0029072613377297348, 0.0018243978277085234,
         -0.0011789103762609267, 0.00077841150134764776, -0.00052493619737646125, 0.00035705782869179024
        },
        /* [307] 1.375 <= y <= 1.5 2^-2, degree 10, 62.7 bits */
        {
         0.45427038957713423, 1.2116942178882027e-17, -0.041213159947729873, 0.014333838330297416,
         -0.006556281786640865, 0.003373960568625566, -0.0018543719523529576, 0.0010629618493509334,
         -0.00062737798460482511, 0.00037833976722765814, -0.00023283823459547607, 0.00014463424330992254
        },
        /* [308] 1.5 <= y <= 1.625 2^-2, degree 10, 60.7 bits */
        {
         0.44933067647628172, 2.4992133995051389e-17, -0.037912751434635995, 0.012158850657026141,
         -0.0051223063999564812, 0.0024268990006617273, -0.001227796370726513, 0.0006477603131012906,
         -0.00035185241990811885, 0.00019526482627197169, -0.0001105186262542533, 6.3172436217915628e-05
        },
        /* [309] 1.625 <= y <= 1.75 2^-2, degree 10, 62.8 bits */
        {
         0.44477211743315331, 2.4138697434296585e-17, -0.035095575606220362, 0.010443692938216878,
         -0.0040781018242173946, 0.0017902513392736655, -0.00083903245903658107, 0.00041002457145820166,
         -0.00020628556293314634, 0.0001060286039598711, -5.5553226770831701e-05, 2.940762509213789e-05
        },
        /* [310] 1.75 <= y <= 1.875 2^-2, degree 10, 61.1 bits */
        {
         0.44054080108143967, 9.0940779253506826e-18, -0.032662781319539105, 0.0090672332637446191,
         -0.0032996561037226006, 0.0013494742174591002, -0.00058910818327677578, 0.00026813163314116657,
         -0.00012563204142360224, 6.013503483330366e-05, -2.9329982248161764e-05, 1.4457920547933495e-05
        },
        /* [311] 1.875 <= y <= 2 2^-2, degree 10, 62.6 bits */
        {
         0.43659349674505343, 4.1228936435265186e-18, -0.030540774786009472, 0.0079457767838499883,
         -0.0027074726203992444, 0.0010364625217118436, -0.00042345585686427977, 0.00018036162320804084,
         -7.9077463604705381e-05, 3.5417423438544194e-05, -1.6158245577873179e-05, 7.4524309450954682e-06
        },
        /* [312] 1 <= y <= 1.125 2^-1, degree 10, 59.7 bits */
        {
         0.43112978821613263, 1.3735604310256613e-17, -0.055643443362112334, 0.02646614673543931,
         -0.016465858448806898, 0.011503904726367786, -0.0085757975107411347, 0.0066638931758168877,
         -0.0053297906336229025, 0.0043543928299970523, -0.0036414144779136721, 0.003063612717890297
        },
        /* [313] 1.125 <= y <= 1.25 2^-1, degree 10, 60.2 bits */
        {
         0.42455830143116685, 2.3062523304799135e-17, -0.049718245293762973, 0.021223843247670075,
         -0.011832674668006003, 0.0074041333706259555, -0.0049421617492643455, 0.0034380698394112031,
         -0.0024614900054884129, 0.0018000406342495931, -0.0013454272573140676, 0.0010130637887185517
        },
        /* [314] 1.25 <= y <= 1.375 2^-1, degree 10, 60.6 bits */
        {
         0.41865370149405662, 1.9462812368574351e-17, -0.044914559210460836, 0.0173953859534717,
         -0.008786856089577114, 0.0049791319799909212, -0.0030089813936807538, 0.0018948625331396043,
         -0.0012279532092407904, 0.00081274869589294349, -0.00054923827554608732, 0.00037426638454132077
        },
        /* [315] 1.375 <= y <= 1.5 2^-1, degree 10, 61.0 bits */
        {
         0.41329515313902027, 2.2444085137049993e-17, -0.04094205320361987, 0.01451456993677587,
         -0.0067026853600862871, 0.0034707346185206514, -0.0019162109509771306, 0.0011023012930166344,
         -0.00065247885616383314, 0.00039443499344988831, -0.00024325572355304872, 0.00015138270219250253
        },
        /* [316] 1.5 <= y <= 1.625 2^-1, degree 10, 61.1 bits */
        {
         0.40839188824634076, 1.2648398169959827e-18, -0.037602637306914731, 0.012292675234046119,
         -0.0052286385531588988, 0.0024927679133304719, -0.0012668808469631027, 0.00067076760599845005,
         -0.00036541248353745868, 0.00020328833258422788, -0.00011530462504034901, 6.6030233101457099e-05
        },
        /* [317] 1.625 <= y <= 1.75 2^-1, degree 10, 61.6 bits */
        {
         0.40387399176846572, 1.6325210646061102e-17, -0.034756518884675638, 0.010543131146766471,
         -0.0041568112867296251, 0.0018362786492790981, -0.00086456078035424433, 0.00042401969852819859,
         -0.00021395365848117965, 0.00011024224291824229, -5.7884736456829605e-05, 3.0699099160179334e-05
        },
        /* [318] 1.75 <= y <= 1.875 2^-1, degree 10, 61.6 bits */
        {
         0.39968646800757418, -1.3834664617695285e-17, -0.032302223753315012, 0.0091410186349115442,
         -0.0033588530268160647, 0.0013823662486416044, -0.00060625812298748688, 0.00027693642823446978,
         -0.00013014156756778063, 6.244894875981417e-05, -3.0524293478113774e-05, 1.5074987594286202e-05
        },
        /* [319] 1.875 <= y <= 2 2^-1, degree 10, 61.6 bits */
        {
         0.39578527818287335, -2.1196942243258116e-17, -0.030164308198735817, 0.0080001415593547714,
         -0.0027525941972284494, 0.0010604266067406397, -0.00043526122283276569, 0.00018606505965381703,
         -8.182107397133008e-05, 3.6738261325051597e-05, -1.6797248652808333e-05, 7.761848145628598e-06
        },
        /* [320] 1 <= y <= 1.125 2^0, degree 10, 59.3 bits */
        {
         0.39039379807864516, 1.7835681945541552e-17, -0.054858122269315676, 0.026599564545269499,
         -0.016711062623191372, 0.011749814499191377, -0.0088001444158069559, 0.006863330312765115,
         -0.0055057931005893365, 0.0045095837288876874, -0.0037795314810446642, 0.0031859014775508982
        },
        /* [321] 1.125 <= y <= 1.25 2^0, degree 10, 60.7 bits */
        {
         0.38392213604439296, 1.7060773554569338e-18, -0.04890938404033382, 0.02128461383191536,
         -0.011983464277424494, 0.0075467456551140816, -0.0050611506559443071, 0.0035338947493973902,
         -0.0025377747941497902, 0.0018605792515170849, -0.0013937778478289762, 0.0010515030761741643
        },
        /* [322] 1.25 <= y <= 1.375 2^0, degree 10, 60.5 bits */
        {
         0.37811933031203326, -2.426522520394753e-17, -0.044096588948826392, 0.017410964098641561,
         -0.0088817502838101307, 0.0050654965893896144, -0.003075741533333484, 0.0019441413850749556,
         -0.0012637457173663169, 0.00083860106769801529, -0.0005679828373866782, 0.00038779688946960305
        },
        /* [323] 1.375 <= y <= 1.5 2^0, degree 10, 60.8 bits */
        {
         0.37286310552807833, 1.8832940459203704e-17, -0.040124035184863932, 0.014501515532023614,
         -0.0067631705224542706, 0.0035248566390693203, -0.0019554138361115117, 0.0011290864886310738,
         -0.00067039607779227021, 0.00040632261506839224, -0.00025115459255564351, 0.00015660698817935936
        },
        /* [324] 1.5 <= y <= 1.625 2^0, degree 10, 61.5 bits */
        {
         0.36806178288888131, 2.111031234887745e-17, -0.036790338690576262, 0.012261334906530702,
         -0.0052672768987811489, 0.0025276176942086127, -0.0012907809943733294, 0.00068601073986933108,
         -0.00037487776601807571, 0.00020910174714790653, -0.00011887241762006011, 6.8208895623796787e-05
        },
        /* [325] 1.625 <= y <= 1.75 2^0, degree 10, 63.6 bits */
        {
         0.36364486641274146, 2.0336467709845003e-17, -0.033953620874970079, 0.010500152128079438,
         -0.0041812356771239127, 0.0018592036373662065, -0.00087959326529404446, 0.0004330359399028247,
         -0.0002191863775774699, 0.00011323700882240591, -5.959361553586466e-05, 3.1668791141342856e-05
        },
        /* [326] 1.75 <= y <= 1.875 2^0, degree 10, 60.9 bits */
        {
         0.35955699082224024, -3.6200539433684135e-18, -0.03151105311854175, 0.0090907660422204998,
         -0.0033738516427908568, 0.0013976967348722888, -0.00061596369517525923, 0.00028244755445543405,
         -0.00013314884955608589, 6.4061922992231753e-05, -3.1384954973011249e-05, 1.5531337439073219e-05
        },
        /* [327] 1.875 <= y <= 2 2^0, degree 10, 63.0 bits */
        {
         0.35575388630223681, -1.3662495878349587e-17, -0.029386294915919504, 0.007945530570548448,
         -0.0027612519790428296, 0.0010708017993768914, -0.00044166708208091636, 0.00018953000502366091,
         -8.3608235221175847e-05, 3.764110118134042e-05, -1.7249966325537807e-05, 7.9872376426723675e-06
        },
        /* [328] 1 <= y <= 1.125 2^1, degree 10, 59.2 bits */
        {
         0.35050631817671174, -1.8128004879040534e-17, -0.053344403585841381, 0.026368931687011706,
         -0.016732972144677453, 0.011843435417344955, -0.0089138430965194169, 0.0069789304424313593,
         -0.0056163496026942396, 0.0046125302669148107, -0.0038749257650630762, 0.0032729973601047847
        },
        /* [329] 1.125 <= y <= 1.25 2^1, degree 10, 60.6 bits */
        {
         0.34422024432807485, -2.077995282288533e-17, -0.047453739396703394, 0.02105268324846651,
         -0.011972607957285787, 0.0075902951111801514, -0.0051155285624818001, 0.0035858003046859615,
         -0.0025833134689604931, 0.0018991135159832793, -0.0014260212021038432, 0.0010780517902031096
        },
        /* [330] 1.25 <= y <= 1.375 2^1, degree 10, 61.4 bits */
        {
         0.33859580061563183, -2.8221424037282909e-18, -0.042698135790465892, 0.017186289856274198,
         -0.0088559204395254089, 0.0050846657435906278, -0.0031027330085480649, 0.001968903658116747,
         -0.0012839782677390012, 0.00085436024635452074, -0.00058003874209766246, 0.00039685370263428362
        },
        /* [331] 1.375 <= y <= 1.5 2^1, degree 10, 60.7 bits */
        {
         0.33351092633227497, 2.5045020127858212e-18, -0.038780418954577026, 0.014287876626955891,
         -0.0067311555831277865, 0.0035318061882635026, -0.0019690585727287491, 0.001141454762811796,
         -0.0006799437229774725, 0.00041324541241288311, -0.00025604736961341954, 0.00015999317664173435
        },
        /* [332] 1.5 <= y <= 1.625 2^1, degree 10, 61.5 bits */
        {
         0.32887428146642123, 1.0397024836603979e-18, -0.035498591815322333, 0.012060126464339816,
         -0.0052335071808212452, 0.0025283873826404493, -0.0012976526271738359, 0.00069239951874355344,
         -0.00037960614908829325, 0.00021232631033765546, -0.00012099708369454264, 6.9574812493859432e-05
        },
        /* [333] 1.625 <= y <= 1.75 2^1, degree 10, 62.1 bits */
        {
         0.32461575542476007, 2.2433268680215446e-17, -0.03271059447495029, 0.010311565954371431,
         -0.0041479407469875501, 0.0018569006327721479, -0.00088292811111589334, 0.00043641016705961818,
         -0.00022162007700237711, 0.00011481347901754347, -6.0569914117263467e-05, 3.2256067857527734e-05
        },
        /* [334] 1.75 <= y <= 1.875 2^1, degree 10, 62.3 bits */
        {
         0.32068037585222753, 1.9926931330260285e-17, -0.030313634066794371, 0.0089143953771484898,
         -0.0033421158619256013, 0.0013939575396010489, -0.00061741997467963531, 0.00028424812371974275,
         -0.00013443986703593782, 6.4864239060959336e-05, -3.1855490392538337e-05, 1.5797899620962876e-05
        },
        /* [335] 1.875 <= y <= 2 2^1, degree 10, 61.8 bits */
        {
         0.31702425395496375, 1.3250248608987648e-17, -0.028231511607812638, 0.0077806876755917515,
         -0.0027315528017202878, 0.0010664982839262789, -0.0004421214168476957, 0.00019048677930051579,
         -8.4308713584719641e-05, 3.8063232916429102e-05, -1.7486117030845716e-05, 8.1139814367841032e-06
        },
        /* [336] 1 <= y <= 1.125 2^2, degree 10, 59.4 bits */
        {
         0.31198760282480731, -1.7782909960994308e-18, -0.051152434745438555, 0.025772691495133438,
         -0.016521673132460096, 0.011773741462113557, -0.0089064742262186091, 0.0070012921932046225,
         -0.0056531115197463446, 0.0046558572969515547, -0.0039210377210120257, 0.0033191044702696897
        },
        /* [337] 1.125 <= y <= 1.25 2^2, degree 10, 60.9 bits */
        {
         0.30596660480141358, 2.3355826197533602e-17, -0.045401458195238331, 0.020529352582332457,
         -0.011794383521549413, 0.0075285301379959205, -0.0050998308519348548, 0.0035892953497377788,
         -0.0025944964634250791, 0.0019127670882155925, -0.0014398575802530324, 0.0010908829526165365
        },
        /* [338] 1.25 <= y <= 1.375 2^2, degree 10, 61.0 bits */
        {
         0.30059085270053554, -9.8645951219712034e-18, -0.040768795974816044, 0.016724316368215295,
         -0.008706065191262281, 0.0050329557384956617, -0.0030869312518337381, 0.0019668570247804566,
         -0.0012869640250456802, 0.00085879994719492041, -0.00058451435487283658, 0.00040079282599071161
        },
        /* [339] 1.375 <= y <= 1.5 2^2, degree 10, 60.8 bits */
        {
         0.29574020809313789, 1.4927868302102865e-17, -0.036959933181007154, 0.013877550670785107,
         -0.0066047854141257009, 0.0034893499692030569, -0.0019553974002605406, 0.0011381714852904509,
         -0.00068028187732970913, 0.00041464111806651527, -0.00025755873191875349, 0.00016129254766142581
        },
        /* [340] 1.5 <= y <= 1.625 2^2, degree 10, 60.6 bits */
        {
         0.29132494946165671, 1.6555106085094425e-17, -0.033775079547709606, 0.011693463756725626,
         -0.0051263597367350051, 0.0024936957344522241, -0.0012864500127228269, 0.00068923884492751316,
         -0.00037915682482861276, 0.0002126881341338662, -0.00012150944894228372, 7.0024334384685271e-05
        },
        /* [341] 1.625 <= y <= 1.75 2^2, degree 10, 61.9 bits */
        {
         0.28727633448140383, -5.649305643922208e-18, -0.031073983266835914, 0.0099820387415364021,
         -0.0040565078651117132, 0.0018285050877914111, -0.00087392173508234335, 0.00043373629496150828,
         -0.00022101293931244153, 0.00011483125030450763, -6.0732841987105676e-05, 3.2414867585318357e-05
        },
        /* [342] 1.75 <= y <= 1.875 2^2, degree 10, 62.3 bits */
        {
         0.28354055435946862, -1.1269886314523908e-17, -0.028755330065031313, 0.0086166599150392133,
         -0.0032635727799742846, 0.0013706055858252548, -0.00061022178730231772, 0.00028209339592856903,
         -0.00013387687365274035, 6.4780714073536141e-05, -3.1895363242117482e-05, 1.5853046319629541e-05
        },
        /* [343] 1.875 <= y <= 2 2^2, degree 10, 62.5 bits */
        {
         0.28007471626084096, -2.0799547350994845e-17, -0.026744133794744513, 0.0075103496736328235,
         -0.0026636404908366791, 0.0010471771275149557, -0.00043636453722988814, 0.00018878394703837509,
         -8.3841466845182384e-05, 3.7962854271148538e-05, -1.7484473882555803e-05, 8.1314291246111461e-06
        },
        /* [344] 1 <= y <= 1.125 2^3, degree 10, 59.5 bits */
        {
         0.27530786944797792, 2.5759254791481226e-17, -0.048367059568108037, 0.024829240223276219,
         -0.016079754876563442, 0.011538177155514067, -0.0087736699650509068, 0.0069255021766493723,
         -0.0056111515862065989, 0.0046348534854793195, -0.0039134299870244287, 0.0033201298621913624
        },
        /* [345] 1.125 <= y <= 1.25 2^3, degree 10, 60.6 bits */
        {
         0.26962111128896621, -2.6487251179392738e-17, -0.042832921982308425, 0.019731877563910833,
         -0.011452132191512223, 0.0073607440667957172, -0.0050121636091449966, 0.0035422731610995355,
         -0.0025693498293860345, 0.0018998089795156145, -0.0014338066707278744, 0.0010887606335036901
        },
        /* [346] 1.25 <= y <= 1.375 2^3, degree 10, 61.4 bits */
        {
         0.26455459567105233, -1.6300127748301088e-17, -0.038384797283275394, 0.016041010534646592,
         -0.0084356511454265915, 0.0049104600049774067, -0.0030275266997130579, 0.0019370548059605001,
         -0.0012718553856754342, 0.00085122796362347103, -0.00058086487357820636, 0.00039919749068266177
        },
        /* [347] 1.375 <= y <= 1.5 2^3, degree 10, 61.1 bits */
        {
         0.25999177419867148, 3.5052595096181641e-18, -0.034734974852603712, 0.013285226167955447,
         -0.0063873841793561596, 0.0033979134187616901, -0.0019141144001389263, 0.0011188001334045353,
         -0.00067102704821972393, 0.00041021370163326883, -0.00025547167865279938, 0.00016035140728019339
        },
        /* [348] 1.5 <= y <= 1.625 2^3, degree 10, 62.9 bits */
        {
         0.25584578376641931, -1.7534365261874871e-17, -0.031688678931604319, 0.011174833400551948,
         -0.0049489108689686452, 0.0024240852047207307, -0.0012570855381330993, 0.00067632710722699909,
         -0.00037334961889465013, 0.00021005368224627952, -0.00012031732781182808, 6.949645059517547e-05
        },
        /* [349] 1.625 <= y <= 1.75 2^3, degree 10, 61.2 bits */
        {
         0.25205019569842468, 1.590726094603903e-17, -0.029109432529644003, 0.0095239554236845169,
         -0.0039097349546652702, 0.0017745773073401788, -0.00085259080059470833, 0.00042492436702377376,
         -0.00021727827708643708, 0.00011322750933891702, -6.0041113014212948e-05, 3.2119440012686418e-05
        },
        /* [350] 1.75 <= y <= 1.875 2^3, degree 10, 61.6 bits */
        {
         0.24855310098571948, -1.5510544797826529e-18, -0.026898816968725581, 0.0082089472920020296,
         -0.003140745639987457, 0.0013281746725345473, -0.0005944305973111997, 0.00027594740928293243,
         -0.00013141780983224341, 6.3780848743084538e-05, -3.1485265531958137e-05, 1.5685335994543003e-05
        },
        /* [351] 1.875 <= y <= 2 2^3, degree 10, 63.0 bits */
        {
         0.24531318651162284, -5.5832122909045036e-18, -0.024984104610472294, 0.0071450067201216756,
         -0.0025597820856501936, 0.001013327705160001, -0.00042447389930867861, 0.00018441165842939515,
         -8.2186333570756373e-05, 3.7324827355542716e-05, -1.7235685068012711e-05, 8.0342723480477527e-06
        },
        /* [352] 1 <= y <= 1.125 2^4, degree 10, 59.2 bits */
        {
         0.24086414643767845, 1.1378675029715151e-17, -0.04510075007568308, 0.023575829740097538,
         -0.015422640033023951, 0.01114338470898445, -0.0085179278515557216, 0.0067519287815307801,
         -0.0054897003430138926, 0.0045481398225983198, -0.0038503928114451613, 0.0032742248415343479
        },
        /* [353] 1.125 <= y <= 1.25 2^4, degree 10, 59.8 bits */
        {
         0.23556728666464691, -6.601914426560723e-18, -0.039851963822531082, 0.018692302212849714,
         -0.010958326696029213, 0.0070921388093376286, -0.0048546057554118543, 0.0034453767911609267,
         -0.0025078454830294149, 0.0018599093404527388, -0.0014074167915621519, 0.001071208725796867
        },
        /* [354] 1.25 <= y <= 1.375 2^4, degree 10, 61.1 bits */
        {
         0.23085805080403185, 1.4748935014915079e-19, -0.035642508215077286, 0.015164188521467741,
         -0.0080548499906883744, 0.0047212295301159377, -0.0029261320506954948, 0.001880074668155297,
         -0.0012387847778991834, 0.00083159289236805177, -0.00056897211502801831, 0.00039193689387531866
        },
        /* [355] 1.375 <= y <= 1.5 2^4, degree 10, 60.3 bits */
        {
         0.22662501556626699, 5.9100581664882662e-18, -0.032195405443225196, 0.012535255209960688,
         -0.006087328681302572, 0.0032606654092846871, -0.0018464353154365803, 0.0010837939460454358,
         -0.00065232000676623228, 0.00039998114316901396, -0.00024976050429112396, 0.00015713344733165466
        },
        /* [356] 1.5 <= y <= 1.625 2^4, degree 10, 62.0 bits */
        {
         0.222785307492262, -1.3578164983976604e-17, -0.02932353274074976, 0.010525720899736178,
         -0.0047081279273238925, 0.0023220555618807502, -0.0012104886866862905, 0.00065400494879647891,
         -0.00036229930864708896, 0.00020445243072087638, -0.00011742008754588512, 6.7981959253129049e-05
        },
        /* [357] 1.625 <= y <= 1.75 2^4, degree 10, 63.6 bits */
        {
         0.21927566702672743, -5.8770608735045352e-18, -0.026896021801421824, 0.0089564061249300508,
         -0.0037134723372742773, 0.0016971086247871826, -0.00081964378480156575, 0.0004102272271631682,
         -0.00021050259620961773, 0.00011002831321425321, -5.8499747357133634e-05, 3.1368350709372115e-05
        },
        /* [358] 1.75 <= y <= 1.875 2^4, degree 10, 62.5 bits */
        {
         0.21604674606187796, -2.5825558641051532e-18, -0.024818661282186651, 0.0077083274847973863,
         -0.0029785906160746194, 0.0012682671068312622, -0.00057059094572653815, 0.00026599784596847769,
         -0.00012712612254735849, 6.1884675338388069e-05, -3.0630448908846541e-05, 1.5295358155738413e-05
        },
        /* [359] 1.875 <= y <= 2 2^4, degree 10, 62.2 bits */
        {
         0.21305933163878496, -1.2425385491528936e-17, -0.023021943499730357, 0.0067000104559544619,
         -0.00242421086947833, 0.00096625195933034932, -0.00040687206628038566, 0.00017751001809951538,
         -7.9389511495531851e-05, 3.6163815664148812e-05, -1.6743972592883149e-05, 7.8234346704618431e-06
        },
        /* [360] 1 <= y <= 1.125 2^5, degree 10, 58.7 bits */
        {
         0.20896339164763614, -7.6557592152835281e-18, -0.041483860587441523, 0.022065338374841301,
         -0.01457743848732021, 0.010604886811487038, -0.0081486636897022905, 0.0064864473039556803,
         -0.005292448987687241, 0.0043980021192566365, -0.0037332839576970779, 0.0031821155973851007
        },
        /* [361] 1.125 <= y <= 1.25 2^5, degree 10, 59.4 bits */
        {
         0.20409657129032327, -4.5837858166675763e-18, -0.036576878466371844, 0.017454629374124491,
         -0.010333585321845419, 0.0067335112612806978, -0.0046331643940003674, 0.0033020626585062236,
         -0.0024120037014921328, 0.001794249972930673, -0.0013613706802539426, 0.0010386057035472059
        },
        /* [362] 1.25 <= y <= 1.375 2^5, degree 10, 59.8 bits */
        {
         0.19977852135682106, -3.9869585589025766e-18, -0.032650111690665944, 0.01413102767738421,
         -0.0075797006013054264, 0.004472996616095906, -0.0027867140907643318, 0.0017980275288467036,
         -0.0011888988673234473, 0.00080052292943512187, -0.00054918029111416145, 0.00037919624751040024
        },
        /* [363] 1.375 <= y <= 1.5 2^5, degree 10, 61.6 bits */
        {
         0.19590426393261626, -9.1110641278823629e-18, -0.029440809433901271, 0.011659455051911759,
         -0.0057173378206397908, 0.0030832849124360052, -0.0017550605776696353, 0.0010344872899657395,
         -0.0006248357485261031, 0.00038428931681935353, -0.00024060362007135314, 0.00015173004432110507
        },
        /* [364] 1.5 <= y <= 1.625 2^5, degree 10, 62.7 bits */
        {
         0.19239587792760088, 1.0432815173202574e-17, -0.026771826042790277, 0.0097736580705543048,
         -0.0044142653742962187, 0.0021918699007734813, -0.001148547614870639, 0.00062314233387747745,
         -0.00034641697790755663, 0.00019608167383073057, -0.00011291339940742077, 6.5527208072038153e-05
        },
        /* [365] 1.625 <= y <= 1.75 2^5, degree 10, 60.8 bits */
        {
         0.1891939937639612, -1.0452550611793816e-17, -0.024519502724101562, 0.0083034429672012404,
         -0.0034761071731420714, 0.0015993608720774812, -0.00077643229531978238, 0.00039022788715539211,
         -0.00020094410829402717, 0.000105350015888636, -5.6161838166370246e-05, 3.01858947331972e-05
        },
        /* [366] 1.75 <= y <= 1.875 2^5, degree 10, 62.8 bits */
        {
         0.18625237612078993, -7.9907539505290874e-18, -0.022594970831573989, 0.0071359888095878562,
         -0.0027840543905051371, 0.0011934207606270238, -0.00053969064214889027, 0.00025264509719353519,
         -0.00012116857572646817, 5.9162944583682668e-05, -2.9361352246531194e-05, 1.4696278056473435e-05
        },
        /* [367] 1.875 <= y <= 2 2^5, degree 10, 61.7 bits */
        {
         0.18353434278750838, -9.4104749325969871e-18, -0.020932768144951597, 0.0061941641902491179,
         -0.0022627446067136027, 0.00090795392472432638, -0.00038429437821089964, 0.0001683600686839913,
         -7.5561430201731596e-05, 3.4524053273374451e-05, -1.6027321171140109e-05, 7.5062798669548552e-06
        },
        /* [368] 1 <= y <= 1.125 2^6, degree 10, 58.4 bits */
        {
         0.17981333667976657, 8.4319918306969901e-18, -0.03765365385840351, 0.020361405297741966,
         -0.013580473974400464, 0.009945735374147946, -0.0076814546662162999, 0.0061400230360781176,
         -0.0050273367328680305, 0.0041903049115213755, -0.0035665230188922595, 0.0030471479928004825
        },
        /* [369] 1.125 <= y <= 1.25 2^6, degree 10, 59.8 bits */
        {
         0.17540046753166663, -1.1062782438489959e-17, -0.033130558657391285, 0.016070769319111805,
         -0.0096047705101711331, 0.006300290499787157, -0.0043572698238233199, 0.0031183345351411314,
         -0.0022857570066691264, 0.0017054603143317891, -0.001297461754390576, 0.00099218299835944447
        },
        /* [370] 1.25 <= y <= 1.375 2^6, degree 10, 61.0 bits */
        {
         0.1714929102346775, -3.7752149599845099e-18, -0.029518672031150078, 0.012984646868182974,
         -0.0070306194607500823, 0.0041764736473582165, -0.002615249848342471, 0.0016943863619385715,
         -0.0011242739758322783, 0.00075928558634456248, -0.00052227845282379489, 0.0003614707500312749
        },
        /* [371] 1.375 <= y <= 1.5 2^6, degree 10, 60.5 bits */
        {
         0.16799317546442405, -5.730789984723606e-18, -0.026572351472706663, 0.010694187436350941,
         -0.0052932859386063671, 0.0028734397020009788, -0.0016439260157642438, 0.00097298343062464279,
         -0.00058973067038363587, 0.00036378750464899823, -0.00022837265285260061, 0.00014435584342062285
        },
        /* [372] 1.5 <= y <= 1.625 2^6, degree 10, 61.2 bits */
        {
         0.16482904456519712, -2.4841826682472951e-18, -0.024126321703373511, 0.0089497027845237692,
         -0.0040799053580001408, 0.0020391598296755397, -0.0010739390753981377, 0.00058506340540200779,
         -0.00032637648100432894, 0.00018529161466951711, -0.00010698273317884156, 6.2231386232663535e-05
        },
        /* [373] 1.625 <= y <= 1.75 2^6, degree 10, 60.7 bits */
        {
         0.1619455920473814, -4.1562943421480627e-18, -0.022065422528517627, 0.007591885651200855,
         -0.0032077775381627563, 0.0014855623140380882, -0.00072482779606795476, 0.00036578814573580702,
         -0.00018901100901252027, 9.9390058935110273e-05, -5.312467535641155e-05, 2.8620506200623278e-05
        },
        /* [374] 1.75 <= y <= 1.875 2^6, degree 10, 61.9 bits */
        {
         0.15930011413103309, -1.977140294263668e-18, -0.020307032248432205, 0.0065153119503579124,
         -0.0025654228381201145, 0.0011068713501011923, -0.00050306979824629012, 0.00023646642126727487,
         -0.00011380088799365669, 5.5731329537018e-05, -2.7731263722764339e-05, 1.3912906676867042e-05
        },
        /* [375] 1.875 <= y <= 2 2^6, degree 10, 60.8 bits */
        {
         0.15685878198842518, -1.175214539091794e-17, -0.018790384664628346, 0.0056480205398655378,
         -0.0020822401605464181, 0.00084095135237445572, -0.00035772072303962113, 0.00015735832010242262,
         -7.0867063486210156e-05, 3.2475623476157065e-05, -1.5116043378877288e-05, 7.096062500236271e-06
        },
        /* [376] 1 <= y <= 1.125 2^7, degree 10, 58.4 bits */
        {
         0.15352138517211805, 7.0484681185680259e-18, -0.033743652360827048, 0.018532705519299038,
         -0.012473883241272115, 0.0091943372486100999, -0.0071365818231515828, 0.0057277033614950732,
         -0.0047058394846859588, 0.003933983076530821, -0.0033572239213485481, 0.0028750231241758593
        },
        /* [377] 1.125 <= y <= 1.25 2^7, degree 10, 59.6 bits */
        {
         0.14957068583514996, 1.1907884933180826e-18, -0.029631133624354898, 0.014595911403471289,
         -0.0088024814795285011, 0.0058110793878858877, -0.0040388866286586392, 0.0029021843844029833,
         -0.0021345907507265916, 0.0015973830117946314, -0.0012184391210419275, 0.00093392247659828352
        },
        /* [378] 1.25 <= y <= 1.375 2^7, degree 10, 60.9 bits */
        {
         0.1460789685047281, -3.0984619596843823e-18, -0.026353823404864616, 0.011770297197981954,
         -0.006430502717568805, 0.0038443402948714956, -0.0024191606953564088, 0.0015736598655772367,
         -0.0010477236785207853, 0.00070967245526101081, -0.00048943046223393614, 0.00033952288475294992
        },
        /* [379] 1.375 <= y <= 1.5 2^7, degree 10, 61.0 bits */
        {
         0.14295696217233417, -1.2328321984813091e-17, -0.023685335451571515, 0.0096771760636945245,
         -0.0048327341290739017, 0.0026400621820294643, -0.0015178293178998398, 0.00090195572178863946,
         -0.00054853435881272079, 0.00033936853027412403, -0.00021359882604769648, 0.00013532977960946792
        },
        /* [380] 1.5 <= y <= 1.625 2^7, degree 10, 60.1 bits */
        {
         0.14013866360687782, -1.274034826158372e-17, -0.021473651485942147, 0.0080857459367941927,
         -0.003718799678755495, 0.0018703946530424483, -0.00098987412534936323, 0.0005414208293633609,
         -0.00030305094257190266, 0.00017255273850232984, -9.9886338794219078e-05, 5.8237589818100371e-05
        },
        /* [381] 1.625 <= y <= 1.75 2^7, degree 10, 60.6 bits */
        {
         0.13757396203197725, -8.1935761757544921e-18, -0.019613037967307949, 0.0068490174671621568,
         -0.0029194444826381757, 0.0013605101550497908, -0.00066704382860569163, 0.00033796660783988165,
         -0.00017522281931605521, 9.2408434265144163e-05, -4.9520722006096593e-05, 2.6740333548761153e-05
        },
        /* [382] 1.75 <= y <= 1.875 2^7, degree 10, 60.0 bits */
        {
         0.13522395915407109, -2.7286548372006988e-18, -0.01802776030510243, 0.0058698798776072583,
         -0.0023315669548623704, 0.0010122491970838295, -0.00046229363079481061, 0.00021816095720970558,
         -0.00010534342932585016, 5.1739502398811755e-05, -2.5811337466085069e-05, 1.2979409199149471e-05
        },
        /* [383] 1.875 <= y <= 2 2^7, degree 10, 60.3 bits */
        {
         0.13305788595527149, 1.3353592511863773e-17, -0.016662201345190732, 0.0050821479937174594,
         -0.0018899731237093057, 0.00076804057382640154, -0.00032828266250315439, 0.00014497896173493337,
         -6.5510213060307408e-05, 3.0107812128130362e-05, -1.4049926813668061e-05, 6.6106932044368704e-06
        },
        /* [384] 1 <= y <= 1.125 2^8, degree 10, 58.6 bits */
        {
         0.13010081314942784, -3.7795276100084327e-19, -0.029874646313761993, 0.016647235545150459,
         -0.011301837730527791, 0.0083818163157907879, -0.0065371134747666112, 0.0052671843637136454,
         -0.0043418744249935186, 0.0036401907095068996, -0.0031145207915898969, 0.0026732611620525612
        },
        /* [385] 1.125 <= y <= 1.25 2^8, degree 10, 59.8 bits */
        {
         0.12660638657726817, 6.9179062526674496e-18, -0.026184247093720327, 0.013084012091890028,
         -0.0079583432969494231, 0.0052859411214598645, -0.0036913886393418506, 0.0026628327003859328,
         -0.0019650192468778651, 0.0014747067207272753, -0.0011277455297849244, 0.00086636843617410623
        },
        /* [386] 1.25 <= y <= 1.375 2^8, degree 10, 59.9 bits */
        {
         0.1235234369021397, -5.4302919988180872e-18, -0.023249060898281385, 0.010531725488026514,
         -0.0058027219472297576, 0.0034900855739293519, -0.0022066185338885545, 0.0014409653354250298,
         -0.00096253039991646655, 0.00065382782852167396, -0.00045206369671348877, 0.0003143096996272475
        },
        /* [387] 1.375 <= y <= 1.5 2^8, degree 10, 61.3 bits */
        {
         0.12077131886408181, 5.1483126817389315e-18, -0.020863319029954225, 0.0086445252455453498,
         -0.004353411215391464, 0.0023925407641149925, -0.0013819843115746421, 0.00082439540061357867,
         -0.00050300399975349984, 0.00031208338851077444, -0.00019692209066275327, 0.00012504456388623709
        },
        /* [388] 1.5 <= y <= 1.625 2^8, degree 10, 60.6 bits */
        {
         0.11829051679981688, -1.4637844202993077e-18, -0.018889110523734477, 0.0072120317916101635,
         -0.00334469417247606, 0.0016923008798882266, -0.0008998017712806087, 0.00049404061420288447,
         -0.0002774299014334267, 0.00015841089031055509, -9.1930514558504294e-05, 5.3719109537368954e-05
        },
        /* [389] 1.625 <= y <= 1.75 2^8, degree 10, 60.2 bits */
        {
         0.11603592083604392, -6.7795481661687037e-18, -0.017230678793210646, 0.0061004973440359871,
         -0.0026219657783508204, 0.0012291438800159607, -0.00060543310348832441, 0.0003079197884610177,
         -0.00016016126048810399, 8.4702913702848072e-05, -4.5504939481371066e-05, 2.4626706275210304e-05
        },
        /* [390] 1.75 <= y <= 1.875 2^8, degree 10, 62.0 bits */
        {
         0.11397256794156713, 5.9886389242112109e-18, -0.015819543065083506, 0.0052217008730301639,
         -0.0020912017118736343, 0.00091325918785455356, -0.00041900997111653915, 0.00019848475809848711,
         -9.6151047340985402e-05, 4.7356913326858281e-05, -2.3683795546329236e-05, 1.1936030991703487e-05
        },
        /* [391] 1.875 <= y <= 2 2^8, degree 10, 61.2 bits */
        {
         0.11207284064669656, -5.4659479052810166e-18, -0.014605485631507896, 0.0045156044263332624,
         -0.0016930367312547711, 0.00069205213329316835, -0.0002971611351915789, 0.00013173004122758354,
         -5.9714395183039258e-05, 2.7520650516940388e-05, -1.287444063863402e-05, 6.0710241331353772e-06
        },
        /* [392] 1 <= y <= 1.125 2^9, degree 10, 58.5 bits */
        {
         0.10948269541583501, 1.6723060854545899e-18, -0.026148237470523417, 0.014767377749270038,
         -0.010106953762051141, 0.007539328710038329, -0.0059068415095707141, 0.0047771892831048879,
         -0.0039505035906316193, 0.0033212501152229523, -0.0028487003568138697, 0.0024504832212025414
        },
        /* [393] 1.125 <= y <= 1.25 2^9, degree 10, 59.8 bits */
        {
         0.10642684277790365, 5.4013371062178617e-18, -0.022877685432617111, 0.011583988915421072,
         -0.0071024908140689099, 0.0047446977006209987, -0.0033283790424789646, 0.0024098932612446528,
         -0.0017839846493034313, 0.0013425276739685464, -0.0010291923209044943, 0.00079238572496178954
        },
        /* [394] 1.25 <= y <= 1.375 2^9, degree 10, 60.0 bits */
        {
         0.10373532508805458, -4.2574876632023511e-18, -0.020281214220455767, 0.009308172569055119,
         -0.0051693026426413583, 0.003126882661692617, -0.0019858346810598072, 0.0013015704293711915,
         -0.00087214544836002148, 0.00059404980805922417, -0.00041173517793276421, 0.00028689230822557117
        },
        /* [395] 1.375 <= y <= 1.5 2^9, degree 10, 61.0 bits */
        {
         0.10133622459071016, -6.8641795328520683e-19, -0.018174260381955978, 0.0076283081611828833,
         -0.0038718593588243206, 0.0021399492883933994, -0.0012415733508632696, 0.00074334679207897531,
         -0.00045496536546684699, 0.00028304457459628877, -0.00017903152961064406, 0.00011392976746358562
        },
        /* [396] 1.5 <= y <= 1.625 2^9, degree 10, 60.9 bits */
        {
         0.099176559325756586, -2.3869922530828322e-18, -0.016433349033996965, 0.0063551897590920815,
         -0.0029702988020185979, 0.0015113187613454621, -0.00080711677097593205, 0.00044476229312532807,
         -0.00025053063946597204, 0.00014343749288779414, -8.3441291608045521e-05, 4.8863243033563106e-05
        },
        /* [397] 1.625 <= y <= 1.75 2^9, degree 10, 62.8 bits */
        {
         0.097216235099845921, 2.460823905692662e-18, -0.014972887168297961, 0.0053687320660933749,
         -0.0023252976472169962, 0.0010961522662363873, -0.00054229075617251074, 0.00027680202045970656,
         -0.00014441863400387539, 7.6582122963649062e-05, -4.1240568923075241e-05, 2.2366587026999288e-05
        },
        /* [398] 1.75 <= y <= 1.875 2^9, degree 10, 61.8 bits */
        {
         0.095424221102602305, 6.0476568213258207e-18, -0.013731753666244136, 0.0045898467617764187,
         -0.0018522570475732179, 0.00081339040860228676, -0.00037481321262167547, 0.00017818607677714339,
         -8.6581882924209117e-05, 4.2757598294760588e-05, -2.1434440438983413e-05, 1.082538737748009e-05
        },
        /* [399] 1.875 <= y <= 2 2^9, degree 10, 61.2 bits */
        {
         0.09377603834451885, -1.25984311428295e-19, -0.012665188980752945, 0.0039647864251769593,
         -0.0014978390619057537, 0.00061563218662777711, -0.00026549016481346155, 0.00011811044881892733,
         -5.3703385242720907e-05, 2.4816022972184621e-05, -1.163662619125632e-05, 5.498939517161359e-06
        },
        /* [400] 1 <= y <= 1.125 2^10, degree 10, 58.0 bits */
        {
         0.091531533084456607, 2.8344570251302546e-18, -0.022643256218344072, 0.012946267074863861,
         -0.0089273503814122721, 0.0066957078138555554, -0.0052683766541092537, 0.0042759083995039578,
         -0.0035466412695186571, 0.0029895701609930804, -0.0025702826100338352, 0.0022156298304607676
        },
        /* [401] 1.125 <= y <= 1.25 2^10, degree 10, 59.4 bits */
        {
         0.088887463946319384, -5.9086466712552891e-18, -0.019778581488117307, 0.010137001912744149,
         -0.0062615578945676188, 0.0042054725879412799, -0.0029626267973060631, 0.0021525884936272667,
         -0.0015982720719689839, 0.0012059096834656793, -0.00092662386632001627, 0.00071490353473118915
        },
        /* [402] 1.25 <= y <= 1.375 2^10, degree 10, 60.7 bits */
        {
         0.086562246139408008, -2.1918915679917456e-18, -0.017508247143751383, 0.0081322903691200734,
         -0.0045495022375414886, 0.0027666459646319076, -0.0017644323716710145, 0.0011604717933410031,
         -0.00077990341014228437, 0.00053259507798020407, -0.00036999649217968886, 0.00025834226018557193
        },
        /* [403] 1.375 <= y <= 1.5 2^10, degree 10, 61.7 bits */
        {
         0.084492522225552077, 1.0164133836923813e-18, -0.015668778380817552, 0.0066549396636418094,
         -0.0034023998165139875, 0.0018904141561573488, -0.0011013599691976261, 0.00066166848685800272,
         -0.00040616434070000481, 0.00025333305793016485, -0.00016060643309437445, 0.00010241441626798572
        },
        /* [404] 1.5 <= y <= 1.625 2^10, degree 10, 63.0 bits */
        {
         0.082631693308493112, 5.9393760522666668e-18, -0.014150995332397177, 0.0055369424876778742,
         -0.0026065175282131451, 0.0013331643003502555, -0.00071491130363108126, 0.00039529732559915925,
         -0.00022331684948017632, 0.00012818249641372462, -7.4736945786663909e-05, 4.3855196541411265e-05
        },
        /* [405] 1.625 <= y <= 1.75 2^10, degree 10, 60.3 bits */
        {
         0.080944547834546826, 6.5522940067382157e-18, -0.012879330698067164, 0.0046718364813100868,
         -0.0020379097346167464, 0.00096566226165280592, -0.0004796899409117837, 0.00024567822522037348,
         -0.0001285512452544009, 6.8340509836119177e-05, -3.688555729561248e-05, 2.0045191970108879e-05
        },
        /* [406] 1.75 <= y <= 1.875 2^10, degree 10, 61.9 bits */
        {
         0.079403870647978048, -5.3028029008160932e-18, -0.01179989812445735, 0.0039896062571758142,
         -0.0016214257616427746, 0.00071569013597429069, -0.00033113241559293175, 0.00015794983248448611,
         -7.6969659565266838e-05, 3.8106269940790848e-05, -1.9145616316241576e-05, 9.688892339660479e-06
        },
        /* [407] 1.875 <= y <= 2 2^10, degree 10, 64.0 bits */
        {
         0.077988219324642491, 4.9713388198463784e-18, -0.010873286775972883, 0.0034427329852114701,
         -0.0013097484073329639, 0.00054107509173430583, -0.00023427885228005993, 0.00010457353750204785,
         -4.7684175263374695e-05, 2.2089640698496337e-05, -1.0381288871633048e-05, 4.9155441073863527e-06
        },
        /* [408] 1 <= y <= 1.125 2^11, degree 10, 57.9 bits */
        {
         0.076062496682387931, 2.8415512852061175e-18, -0.019414896785518658, 0.011225680647262676,
         -0.0077946305807413702, 0.005875702212749228, -0.0046416380358044801, 0.0037797062776814948,
         -0.003143944106346309, 0.0026566891270334405, -0.0022891853686813676, 0.0019772339087293926
        },
        /* [409] 1.125 <= y <= 1.25 2^11, degree 10, 59.5 bits */
        {
         0.073797117864849965, -6.4549366166549034e-18, -0.016932994893394469, 0.0087749604816162695,
         -0.0054573460718470501, 0.0036836319081830588, -0.0026052453696360912, 0.0018991154601440395,
         -0.0014140194816029349, 0.0010695040177389279, -0.00082361983433892406, 0.00063668269234514623
        },
        /* [410] 1.25 <= y <= 1.375 2^11, degree 10, 61.6 bits */
        {
         0.071807769828542714, -6.591986438361668e-18, -0.014969156064130603, 0.0070290627524367639,
         -0.0039589009860796481, 0.0024193649979420031, -0.0015489741610191772, 0.0010220624216413625,
         -0.00068878812174636838, 0.00047151389154670279, -0.00032827650131178837, 0.00022965830844743281
        },
        /* [411] 1.375 <= y <= 1.5 2^11, degree 10, 60.2 bits */
        {
         0.070039269188170244, 5.7578755264815464e-18, -0.013380283016875513, 0.0057443837363241098,
         -0.0029564942808439501, 0.0016506791887582995, -0.00096540397601154241, 0.00058184888986885584,
         -0.00035814776922220754, 0.00022392122496048045, -0.00014226614045290497, 9.0894385923346354e-05
        },
        /* [412] 1.5 <= y <= 1.625 2^11, degree 10, 62.8 bits */
        {
         0.06845109100127364, 5.8427980540128952e-18, -0.012070957532228805, 0.0047735169819421285,
         -0.0022619890079546671, 0.0011625359417621486, -0.00062579641622905271, 0.00034712197962928642,
         -0.00019663462977865406, 0.00011313613295808032, -6.6105026436929595e-05, 3.8864305026085274e-05
        },
        /* [413] 1.625 <= y <= 1.75 2^11, degree 10, 60.9 bits */
        {
         0.06701265552645555, -2.1176630048590576e-18, -0.01097523191297561, 0.0040231924919921927,
         -0.0017664482595224286, 0.0008410359652306238, -0.00041936618524267977, 0.00021545921996007886,
         -0.00011304342398048186, 6.0238355215668425e-05, -3.2581408250330404e-05, 1.7739780091991208e-05
        },
        /* [414] 1.75 <= y <= 1.875 2^11, degree 10, 61.8 bits */
        {
         0.065700357130142092, -5.3353710780710511e-19, -0.010046140733518911, 0.0034321532798647237,
         -0.001403912355889598, 0.00062262008976631347, -0.00028915426191242601, 0.00013835720404620683,
         -6.7602653645215205e-05, 3.3547396408683977e-05, -1.689052131135764e-05, 8.5638004407294207e-06
        },
        /* [415] 1.875 <= y <= 2 2^11, degree 10, 60.3 bits */
        {
         0.064495618597136956, 4.8388040144382475e-19, -0.0092493759089932528, 0.0029588759056083636,
         -0.001132903364043768, 0.00047021961481776931, -0.00020435877540326644, 9.1501137811977816e-05,
         -4.1834259051530721e-05, 1.9424840646650007e-05, -9.1479683347694016e-06, 4.3396851515453776e-06
        },
        /* [416] 1 <= y <= 1.125 2^12, degree 10, 58.1 bits */
        {
         0.062858453203578107, -2.2955511438803921e-18, -0.016496064439578229, 0.0096353912407666394,
         -0.0067328604298240889, 0.0050989243253597898, -0.0040428655954847844, 0.0033022228791267506,
         -0.0027540031321798423, 0.0023325520511955403, -0.0020140738944925624, 0.0017428399743443662
        },
        /* [417] 1.125 <= y <= 1.25 2^12, degree 10, 59.8 bits */
        {
         0.060934980904183686, 2.9459595301498826e-19, -0.014367380199697565, 0.0075201775529637124,
         -0.0047062043199667383, 0.0031911846159850665, -0.0022651770515581672, 0.0016562200396912348,
         -0.0012363718950139041, 0.00093727062510226512, -0.00072326971875453919, 0.00056013462698098254
        },
        /* [418] 1.25 <= y <= 1.375 2^12, degree 10, 60.1 bits */
        {
         0.059248085097668511, 1.1096091309735472e-18, -0.012685499642756759, 0.0060156447528341263,
         -0.0034090151672260065, 0.002092746663962761, -0.0013446769071262341, 0.00088991568056689745,
         -0.00060127243628217187, 0.00041253234961585587, -0.00028779480106858822, 0.00020170324627796828
        },
        /* [419] 1.375 <= y <= 1.5 2^12, degree 10, 60.0 bits */
        {
         0.057750206877709119, -5.2302028794553569e-21, -0.011326529582211116, 0.0049101091056640983,
         -0.0025424996547861235, 0.0014258846514240968, -0.00083689648512907282, 0.00050589039449969262,
         -0.00031218422257691834, 0.00019561934763304316, -0.00012453393721073778, 7.9708233211286928e-05
        },
        /* [420] 1.5 <= y <= 1.625 2^12, degree 10, 60.5 bits */
        {
         0.056406469683147692, -3.4800839374532036e-19, -0.010207978875262917, 0.0040756743015420973,
         -0.0019429300094430406, 0.001002974179345618, -0.00054180283291742977, 0.00030141227121276571,
         -0.0001711711285289203, 9.8703024561448571e-05, -5.7786212231466781e-05, 3.403404477376928e-05
        },
        /* [421] 1.625 <= y <= 1.75 2^12, degree 10, 61.6 bits */
        {
         0.055190589355418485, -3.3661433841596155e-19, -0.0092729098212824494, 0.0034315260342094246,
         -0.0015156363553681621, 0.00072477941882379666, -0.00036265582902468021, 0.00018686371934430234,
         -9.8284928837431024e-05, 5.2488578705220988e-05, -2.8445526108830827e-05, 1.5515248300271003e-05
        },
        /* [422] 1.75 <= y <= 1.875 2^12, degree 10, 60.5 bits */
        {
         0.054082299544402052, 3.1455813706208126e-19, -0.0084808223454257321, 0.002924653835030642,
         -0.0012033706718509525, 0.00053599613982535015, -0.00024978381693911461, 0.00011986268793770153,
         -5.8710857047701571e-05, 2.9198170109444659e-05, -1.4729389376259563e-05, 7.4811525295207183e-06
        },
        /* [423] 1.875 <= y <= 2 2^12, degree 10, 63.3 bits */
        {
         0.053065667800569871, -2.4870461349401015e-18, -0.0078021638451727746, 0.0025191650903029811,
         -0.000970175283956711, 0.00040440855464842358, -0.00017635841088621947, 7.9189305726477734e-05,
         -3.6294088422814252e-05, 1.6888690765875474e-05, -7.9689494812478252e-06, 3.7869468598041603e-06
        },
        /* [424] 1 <= y <= 1.125 2^13, degree 10, 58.1 bits */
        {
         0.051685393411598633, 2.5252856634454642e-18, -0.01390025356935908, 0.0081937247173213927,
         -0.0057584517711606175, 0.0043794910650354277, -0.0034841741595216893, 0.0028539062904590433,
         -0.002385884682618264, 0.0020250733716972186, -0.0017519476360192297, 0.0015186206458935327
        },
        /* [425] 1.125 <= y <= 1.25 2^13, degree 10, 59.4 bits */
        {
         0.050065614429255612, 2.7673890929082791e-18, -0.012091322437842261, 0.0063859445829062772,
         -0.0040190367064756117, 0.0027366175725646378, -0.0019489844867999714, 0.0014289917617455988,
         -0.001069296229520047, 0.00081231762647939864, -0.00062803571796856653, 0.00048720647681749885
        },
        /* [426] 1.25 <= y <= 1.375 2^13, degree 10, 59.5 bits */
        {
         0.048646743454267151, -2.9058197738755001e-19, -0.010663992045353175, 0.0051019226584196513,
         -0.002907361293638677, 0.001792142898830362, -0.0011553105192304426, 0.00076668952706343042,
         -0.00051923762336146865, 0.00035698800065793945, -0.00024951136187758194, 0.00017516536638478465
        },
        /* [427] 1.375 <= y <= 1.5 2^13, degree 10, 59.6 bits */
        {
         0.047388188524389856, -4.7831206403979687e-20, -0.0095120753559034266, 0.0041596201366920172,
         -0.0021657557655763398, 0.0012195403084417056, -0.00071810980618688914, 0.00043526254628146354,
         -0.00026922671388221079, 0.00016904781378639051, -0.00010781697012369173, 6.9123020175674793e-05
        },
        /* [428] 1.5 <= y <= 1.625 2^13, degree 10, 59.9 bits */
        {
         0.046260220543521358, -3.3583861347380528e-18, -0.0085649659617039221, 0.0034492058664783443,
         -0.00165323032150931, 0.00085685709277858954, -0.00046435625489472921, 0.0002590202784929571,
         -0.00014743643610876634, 8.5189481331470436e-05, -4.9965736317560506e-05, 2.947640566719914e-05
        },
        /* [429] 1.625 <= y <= 1.75 2^13, degree 10, 60.8 bits */
        {
         0.045240460619610963, 2.6017768011792121e-18, -0.0077739885201774531, 0.0029013677797178755,
         -0.00128836814123761, 0.00061854908000018348, -0.00031048431118241559, 0.0001604060944417017,
         -8.4561807637088018e-05, 4.5250638983639054e-05, -2.4567340765120274e-05, 1.3421749266097074e-05
        },
        /* [430] 1.75 <= y <= 1.875 2^13, degree 10, 61.9 bits */
        {
         0.044311671693955466, -1.1100321511855671e-18, -0.0071045581527622945, 0.0024706922336797136,
         -0.0010219933047495718, 0.00045699976436312551, -0.00021363956243029611, 0.00010278771528651829,
         -5.0461223823015748e-05, 2.5145458280353679e-05, -1.2707653091312002e-05, 6.4647109492546231e-06
        },
        /* [431] 1.875 <= y <= 2 2^13, degree 10, 61.1 bits */
        {
         0.043460315832236321, -3.2715858959520122e-19, -0.0065314639472231978, 0.0021264623896329335,
         -0.00082325139649302309, 0.00034450208838316342, -0.00015070167921409043, 6.7845018185760445e-05,
         -3.1164546532290556e-05, 1.4530414101120522e-05, -6.8683553466935207e-06, 3.2691517287450805e-06
        },
        /* [432] 1 <= y <= 1.125 2^14, degree 10, 58.1 bits */
        {
         0.042305391661434606, -7.8298703572305927e-19, -0.011625259771047154, 0.0069089598099771063,
         -0.0048807457806784669, 0.0037262388235161877, -0.0029735810358506886, 0.0024419395095427042,
         -0.0020460021850775153, 0.0017399795991659443, -0.001507967342395054, 0.0013091992210008908
        },
        /* [433] 1.125 <= y <= 1.25 2^14, degree 10, 58.9 bits */
        {
         0.040951481393550405, -3.4154071560976135e-18, -0.01010092497742743, 0.0053777319164628832,
         -0.0034017847600731942, 0.0023250827391223966, -0.0016609041457646392, 0.0012208549957279703,
         -0.00091554450549717311, 0.00069685370686085023, -0.00053970258798703165, 0.00041933318402139196
        },
        /* [434] 1.25 <= y <= 1.375 2^14, degree 10, 60.8 bits */
        {
         0.039766769940602603, 2.7664046800709287e-18, -0.0088996119250947959, 0.0042915499793335825,
         -0.0024578533355992982, 0.0015207042398553787, -0.00098324994538061651, 0.00065413528736471137,
         -0.0004439646075401396, 0.00030581512317735121, -0.00021411089931067863, 0.0001505442083265229
        },
        /* [435] 1.375 <= y <= 1.5 2^14, degree 10, 59.2 bits */
        {
         0.038716916983269817, -2.9190765699326888e-18, -0.0079311470767780608, 0.003495357259795643,
         -0.0018289135311247838, 0.0010336489531653544, -0.0006104411966559311, 0.00037091400900857413,
         -0.0002299124702190071, 0.00014463285159776223, -9.240119872597178e-05, 5.9329770383245329e-05
        },
        /* [436] 1.5 <= y <= 1.625 2^14, degree 10, 61.6 bits */
        {
         0.037776801498910315, 1.3268463910742545e-18, -0.0071356455851951991, 0.0028957215914448085,
         -0.0013947255278301902, 0.00072549929586437749, -0.00039431240576268757, 0.00022048507062885785,
         -0.00012576563305786566, 7.2802598403661514e-05, -4.2771777017828688e-05, 2.5270380438633877e-05
        },
        /* [437] 1.625 <= y <= 1.75 2^14, degree 10, 60.6 bits */
        {
         0.03692753325288007, -2.9156322149498193e-18, -0.0064718690512937356, 0.002433747610532595,
         -0.0010859370895060227, 0.0005232312780391377, -0.00026339374974651401, 0.00013640531381891078,
         -7.2058723502937093e-05, 3.8630670074514417e-05, -2.1007849816166233e-05, 1.1494184378882573e-05
        },
        /* [438] 1.75 <= y <= 1.875 2^14, degree 10, 60.5 bits */
        {
         0.036154576149017993, -1.1930701367619656e-18, -0.0059105460416447268, 0.002070886870944325,
         -0.00086070422278046357, 0.00038624220870978244, -0.00018107500842116326, 8.7327670646884786e-05,
         -4.2959696236525958e-05, 2.1446197198999156e-05, -1.0855867610054444e-05, 5.5307966898175128e-06
        },
        /* [439] 1.875 <= y <= 2 2^14, degree 10, 64.2 bits */
        {
         0.035446523523525564, -2.6413301102663198e-18, -0.0054303584365143704, 0.0017810907636373772,
         -0.00069279846779466911, 0.00029092993633460267, -0.00012762491286525304, 5.7591597171023844e-05,
         -2.6508566386457965e-05, 1.2381788501380785e-05, -5.862187313204193e-06, 2.7943167669752137e-06
        },
        /* [440] 1 <= y <= 1.125 2^15, degree 10, 57.9 bits */
        {
         0.034486713308085094, -8.9574860974999521e-20, -0.0096571258648740672, 0.0057811964554476463,
         -0.0041030517753135242, 0.0031433439048152221, -0.0025153875048048806, 0.0020704749052379411,
         -0.0017382557193890199, 0.0014808856846061011, -0.0012854883535827859, 0.0011176533768770141
        },
        /* [441] 1.125 <= y <= 1.25 2^15, degree 10, 59.7 bits */
        {
         0.033362587800054022, -2.6080329314266438e-18, -0.0083823327335660995, 0.0044947190587273653,
         -0.002856207582999426, 0.0019588257717373021, -0.0014030903905872471, 0.0010337095718636429,
         -0.00077673413757054399, 0.00059223240897139965, -0.00045940025368315451, 0.00035744699940888771
        },
        /* [442] 1.25 <= y <= 1.375 2^15, degree 10, 60.0 bits */
        {
         0.03237988667835133, 2.7884684639313479e-18, -0.0073787765550848488, 0.0035832210585350173,
         -0.0020614017952188045, 0.0012796840265014225, -0.00082963589837440851, 0.0005531841519833021,
         -0.000376180624122833, 0.0002595695502122388, -0.00018201565248633059, 0.00012815665796124997
        },
        /* [443] 1.375 <= y <= 1.5 2^15, degree 10, 62.6 bits */
        {
         0.031509790312086838, -6.1122350646607652e-19, -0.0065705225597390534, 0.0029157715976442559,
         -0.0015324040284574116, 0.00086892761789518784, -0.00051452165991897633, 0.00031332728383381102,
         -0.00019459069395249829, 0.00012262057015562428, -7.845839696439297e-05, 5.0446833192617654e-05
        },
        /* [444] 1.5 <= y <= 1.625 2^15, degree 10, 60.9 bits */
        {
         0.030731238494521404, 1.6376735024456001e-19, -0.0059071980752830556, 0.0024135674095350015,
         -0.0011675705479493124, 0.00060931629020467251, -0.00033203255534303155, 0.00018606828501760404,
         -0.00010633576220804584, 6.1658376282852436e-05, -3.6279326051352593e-05, 2.1463771172585884e-05
        },
        /* [445] 1.625 <= y <= 1.75 2^15, degree 10, 61.7 bits */
        {
         0.030028409603202466, -1.2452427976406966e-18, -0.0053541496740694096, 0.0020269861180494749,
         -0.00090833793317556617, 0.00043906666868237109, -0.00022159656977454334, 0.00011500867153833435,
         -6.086961349337868e-05, 3.2686301375060702e-05, -1.780180089762549e-05, 9.7531814888608826e-06
        },
        /* [446] 1.75 <= y <= 1.875 2^15, degree 10, 61.9 bits */
        {
         0.029389139297455642, -1.5390554966609691e-18, -0.0048868022312919673, 0.0017235792107104313,
         -0.00071940598304444435, 0.00032386032996336455, -0.0001522175555122641, 7.356808967561494e-05,
         -3.6258070442814841e-05, 1.8130329140651624e-05, -9.1909728760917837e-06, 4.6888291821046544e-06
        },
        /* [447] 1.875 <= y <= 2 2^15, degree 10, 61.4 bits */
        {
         0.028803889540420291, 1.6549037423436127e-18, -0.0044872726705953289, 0.0014814388423271859,
         -0.00057866758786634246, 0.00024376629043313294, -0.00010720553689789538, 4.8480002828027868e-05,
         -2.2355658326826228e-05, 1.0458981557178419e-05, -4.9590739425829647e-06, 2.3669586914432377e-06
        },
        /* [448] 1 <= y <= 1.125 2^16, degree 10, 57.7 bits */
        {
         0.028011071670602652, 7.2632768896332215e-19, -0.0079738766015486628, 0.0048043696802153972,
         -0.003423906088800568, 0.0026311719752375134, -0.0021107785586630375, 0.0017410701021931567,
         -0.0014643549381100113, 0.0012495372734267728, -0.0010862447617338421, 0.00094565487233462075
        },
        /* [449] 1.125 <= y <= 1.25 2^16, degree 10, 59.3 bits */
        {
         0.027083302025822521, 1.0458588018569648e-18, -0.0069150164353439826, 0.0037314058172000369,
         -0.0023807950813675514, 0.0016377442525320389, -0.0011759724882620351, 0.00086816592588594371,
         -0.00065350594446968527, 0.0004990597920925549, -0.00038767820283284446, 0.00030202895418000262
        },
        /* [450] 1.25 <= y <= 1.375 2^16, degree 10, 61.1 bits */
        {
         0.026272945176278952, -3.1027422901672945e-19, -0.0060822621543170025, 0.0029719858842314267,
         -0.0017165956064606484, 0.0010688194001072942, -0.00069459752074363596, 0.00046408121385067537,
         -0.00031614157688160627, 0.00021848001631776163, -0.00015341786061967141, 0.00010815755751509335
        },
        /* [451] 1.375 <= y <= 1.5 2^16, degree 10, 60.1 bits */
        {
         0.02555598833699611, -1.439622610304641e-18, -0.0054121515554109208, 0.0024164158779688,
         -0.0012749600747166961, 0.00072507596095741287, -0.00043036034680924833, 0.00026259873486740945,
         -0.00016336784061356368, 0.00010310296475056743, -6.6061305968278806e-05, 4.2528755021486951e-05
        },
        /* [452] 1.5 <= y <= 1.625 2^16, degree 10, 61.1 bits */
        {
         0.024914900550736013, 8.1353837750500411e-19, -0.0048626279439347077, 0.0019987431996784837,
         -0.00097064680831279021, 0.00050801865484208426, -0.00027748031924258097, 0.00015580382372182145,
         -8.9191879328706617e-05, 5.1795586341638357e-05, -3.0517674821183443e-05, 1.8077254542065404e-05
        },
        /* [453] 1.625 <= y <= 1.75 2^16, degree 10, 59.9 bits */
        {
         0.024336522740346804, -1.4336195083157546e-18, -0.0044047847091524634, 0.0016774763226674134,
         -0.00075459012684027296, 0.00036579400202559726, -0.00018504226388814249, 9.622371109464148e-05,
         -5.101327551639777e-05, 2.7434385967736699e-05, -1.4961578189270307e-05, 8.2070620204112468e-06
        },
        /* [454] 1.75 <= y <= 1.875 2^16, degree 10, 59.9 bits */
        {
         0.023810745412807914, -1.5278725281389898e-18, -0.004018138802609204, 0.0014255064893845279,
         -0.00059724061399310502, 0.00026962517480175056, -0.00012701568738808698, 6.1505777717861047e-05,
         -3.0363645583521057e-05, 1.5205279673835425e-05, -7.7184004149059387e-06, 3.9423245737898239e-06
        },
        /* [455] 1.875 <= y <= 2 2^16, degree 10, 60.8 bits */
        {
         0.023329647287051485, 6.4627269071151016e-19, -0.0036877959304192102, 0.0012245451275754375,
         -0.00048010738842094923, 0.00020281325593843601, -8.9396156704505393e-05, 4.050316810326111e-05,
         -1.8708064264387842e-05, 8.7652339360659108e-06, -4.1614572274141269e-06, 1.9886222184091921e-06
        },
        /* [456] 1 <= y <= 1.125 2^17, degree 10, 57.7 bits */
        {
         0.022678302766710127, -7.3997558885107674e-19, -0.006548763045553796, 0.0039681690389269256,
         -0.0028383597994993638, 0.0021872032744397153, -0.0017585164072565125, 0.0014532229098923181,
         -0.0012242402516141175, 0.0010461474922687155, -0.00091062374130890201, 0.00079369365429620537
        },
        /* [457] 1.125 <= y <= 1.25 2^17, degree 10, 58.8 bits */
        {
         0.021916651691393781, -9.163018323587637e-19, -0.0056745910422573605, 0.0030791237566196446,
         -0.0019716836516921205, 0.0013599809025263928, -0.00097865523171159819, 0.00072382339757086638,
         -0.0005457214469208354, 0.00041733646649159896, -0.00032460951499897452, 0.00025318537365217079
        },
        /* [458] 1.25 <= y <= 1.375 2^17, degree 10, 59.2 bits */
        {
         0.02125189285920542, -1.5696941815433077e-18, -0.0049876831715942706, 0.0024504668576318437,
         -0.0014203744137175373, 0.00088672795016652101, -0.00057749616921574779, 0.000386539526301593,
         -0.00026373137107921078, 0.00018251318607682897, -0.00012832303192427704, 9.0568643695375801e-05
        },
        /* [459] 1.375 <= y <= 1.5 2^17, degree 10, 59.7 bits */
        {
         0.020664147059939155, 1.3877676320469325e-18, -0.004435359528183646, 0.0019909420278159543,
         -0.0010541230060225472, 0.00060105083070499221, -0.00035749941137689907, 0.00021852835607977141,
         -0.00013616069908792814, 8.6049779746222684e-05, -5.5203058898590439e-05, 3.5578190107689076e-05
        },
        /* [460] 1.5 <= y <= 1.625 2^17, degree 10, 61.0 bits */
        {
         0.02013891335845654, 1.4441170035376073e-18, -0.003982740049149139, 0.0016457333524892723,
         -0.00080195283352611682, 0.00042080771456972635, -0.00023032363691477287, 0.00012955245897041697,
         -7.4276872030365837e-05, 4.3192298696639203e-05, -2.5479712291693629e-05, 1.5109645271506784e-05
        },
        /* [461] 1.625 <= y <= 1.75 2^17, degree 10, 61.4 bits */
        {
         0.019665315290340064, 8.698746862990138e-19, -0.0036058699560802005, 0.0013803843025408506,
         -0.00062304463408456232, 0.00030279306489358447, -0.00015348664228957169, 7.9952681763364875e-05,
         -4.2450848514249764e-05, 2.2860000302718606e-05, -1.2481902630181781e-05, 6.8543120604023727e-06
        },
        /* [462] 1.75 <= y <= 1.875 2^17, degree 10, 60.2 bits */
        {
         0.019235002692582683, -1.1476620971465832e-18, -0.0032877873012605303, 0.0011723994635473162,
         -0.00049283454136339567, 0.00022304865893334568, -0.00010528725723550716, 5.1071249410273765e-05,
         -2.5249853916165755e-05, 1.266106743861833e-05, -6.4345637898975204e-06, 3.2901179690901327e-06
        },
        /* [463] 1.875 <= y <= 2 2^17, degree 10, 60.2 bits */
        {
         0.018841436879697318, -1.0808476271250412e-18, -0.003016166289072648, 0.0010066130275199223,
         -0.00039596238012781478, 0.00016768196315214168, -7.4059011874594654e-05, 3.3611019835412461e-05,
         -1.5547432017342621e-05, 7.293868179027485e-06, -3.4669673375255954e-06, 1.6585126873351382e-06
        },
        /* [464] 1 <= y <= 1.125 2^18, degree 10, 57.4 bits */
        {
         0.018308875766061293, 5.3216481072067761e-19, -0.0053528839839576924, 0.0032597128438818491,
         -0.0023391618500961161, 0.0018069193027439726, -0.0014556302025708081, 0.0012049217478840332,
         -0.0010165303660162178, 0.00086976605969341699, -0.00075797557456273347, 0.00066133882306062327
        },
        /* [465] 1.125 <= y <= 1.25 2^18, degree 10, 59.2 bits */
        {
         0.017686530484335689, -1.416500393939872e-18, -0.0046350678789972384, 0.0025273381779720547,
         -0.001623485504556419, 0.0011224829051949793, -0.00080931012892087749, 0.00059955077009323714,
         -0.00045266777389721023, 0.00034660936787958693, -0.00026990517154463285, 0.00021073426218354106
        },
        /* [466] 1.25 <= y <= 1.375 2^18, degree 10, 59.2 bits */
        {
         0.017143717223950632, -4.8506315767588838e-19, -0.0040714538614979624, 0.0020098954822639222,
         -0.0011686299220555153, 0.00073127650524091345, -0.00047715976938557197, 0.00031989273218865861,
         -0.00021856312113153217, 0.00015144169464621762, -0.00010659640105409122, 7.531040293259687e-05
        },
        /* [467] 1.375 <= y <= 1.5 2^18, degree 10, 60.3 bits */
        {
         0.016664072724774354, 1.0535657752193983e-18, -0.0036185756275619535, 0.0016319428540659861,
         -0.00086669104983545591, 0.0004953184460169841, -0.00029516087298053892, 0.00018070738721954468,
         -0.00011274959476973538, 7.1341255815719065e-05, -4.5817633490823335e-05, 2.9558736437541774e-05
        },
        /* [468] 1.5 <= y <= 1.625 2^18, degree 10, 61.2 bits */
        {
         0.016235669681745342, 1.0666736207147649e-18, -0.0032476763580091468, 0.0013482013746110952,
         -0.00065894645769548241, 0.00034655332006601567, -0.00019003033835890323, 0.00010705443788554759,
         -6.1460924492324272e-05, 3.5782607537359976e-05, -2.1131551376223184e-05, 1.2543466182574311e-05
        },
        /* [469] 1.625 <= y <= 1.75 2^18, degree 10, 60.0 bits */
        {
         0.015849567968210833, 7.8325530368379824e-19, -0.0029390205652484063, 0.0011302304444191611,
         -0.00051165035215883768, 0.00024921329975240999, -0.00012655604224411085, 6.6025349708017839e-05,
         -3.510286892336584e-05, 1.8925428189195929e-05, -1.0344627097550895e-05, 5.6861562896848846e-06
        },
        /* [470] 1.75 <= y <= 1.875 2^18, degree 10, 62.3 bits */
        {
         0.015498908148246088, 8.005088502419538e-19, -0.0026786428535460795, 0.00095947466558206904,
         -0.00040450958623565073, 0.00018347871622110832, -8.6763832476340801e-05, 4.2149875754162438e-05,
         -2.0866517309003536e-05, 1.0475343598632159e-05, -5.3293664691348387e-06, 2.7276188697673205e-06
        },
        /* [471] 1.875 <= y <= 2 2^18, degree 10, 59.9 bits */
        {
         0.015178321823629569, 1.5482528332736848e-19, -0.0024564008614427714, 0.00082343211341032619,
         -0.00032484255868006786, 0.00013786433371688477, -6.0997343178996131e-05, 2.7724502021641371e-05,
         -1.2841190113108583e-05, 6.0312239690986344e-06, -2.8697909176310285e-06, 1.374137818996327e-06
        },
        /* [472] 1 <= y <= 1.125 2^19, degree 10, 57.8 bits */
        {
         0.014744711519069855, -5.3675997853071153e-19, -0.0043571628270574888, 0.0026649047896738186,
         -0.0019177606646163072, 0.0014845788738209475, -0.0011980366524264683, 0.00099315306975376991,
         -0.00083894399514628589, 0.0007186342067842192, -0.00062691755112596914, 0.00054749909670935408
        },
        /* [473] 1.125 <= y <= 1.25 2^19, degree 10, 58.8 bits */
        {
         0.014238288988751556, 2.7680847893439954e-19, -0.0037705339425432843, 0.0020646913916485053,
         -0.0013299824857157161, 0.00092148525708591754, -0.00066552262896468067, 0.00049374114838297573,
         -0.00037324776313032315, 0.00028611529967654956, -0.00022302414619618951, 0.00017428992411170504
        },
        /* [474] 1.25 <= y <= 1.375 2^19, degree 10, 59.3 bits */
        {
         0.013796841809775315, -4.3131139870086979e-19, -0.0033102359016515988, 0.0016409348117971735,
         -0.00095670375081198218, 0.00059989629986026112, -0.00039208837851093371, 0.00026323199204960566,
         -0.0001800717950699004, 0.00012490759029393472, -8.800700289384845e-05, 6.2232784146335995e-05
        },
        /* [475] 1.375 <= y <= 1.5 2^19, degree 10, 60.1 bits */
        {
         0.013406968785090149, 2.8117743447964374e-19, -0.0029405957962315948, 0.0013316137763252456,
         -0.00070908706125263161, 0.00040606778289709392, -0.00024237409013606111, 0.00014859604788468225,
         -9.2826522342961794e-05, 5.8798287974671739e-05, -3.7799002873892356e-05, 2.4407142124968446e-05
        },
        /* [476] 1.5 <= y <= 1.625 2^19, degree 10, 61.7 bits */
        {
         0.013058908106952557, -3.5955730665381133e-19, -0.0026380293346344309, 0.0010995314925160333,
         -0.00053882311396522529, 0.00028394294261426613, -0.00015595031785230228, 8.7975693689738488e-05,
         -5.0567897286854673e-05, 2.9471865870527516e-05, -1.7421439141619205e-05, 1.0350181305433177e-05
        },
        /* [477] 1.625 <= y <= 1.75 2^19, degree 10, 61.7 bits */
        {
         0.012745347106704968, -1.7993426586919119e-21, -0.002386360997433265, 0.00092133921535507294,
         -0.00041816909063050145, 0.00020408079823921145, -0.00010380207088729989, 5.4227564686185352e-05,
         -2.886439873647684e-05, 1.5578264023356111e-05, -8.5231292894091767e-06, 4.6889502775291883e-06
        },
        /* [478] 1.75 <= y <= 1.875 2^19, degree 10, 59.6 bits */
        {
         0.012460678021353805, 2.6094651306146951e-19, -0.0021741509862033795, 0.0007818126155523773,
         -0.00033045200129536601, 0.00015017786249702837, -7.1128208616293715e-05, 3.4600146402843429e-05,
         -1.7148867021617928e-05, 8.6178969683845421e-06, -4.3884780113235085e-06, 2.2479667511993701e-06
        },
        /* [479] 1.875 <= y <= 2 2^19, degree 10, 62.1 bits */
        {
         0.012200514174282773, 7.0861144335471786e-19, -0.0019930954235182464, 0.00067069963709613417,
         -0.00026525837735865516, 0.00011279193101157061, -4.9981738488237157e-05, 2.2747596029974556e-05,
         -1.0548110440504387e-05, 4.9592609598851304e-06, -2.3619025069972197e-06, 1.131893241126418e-06
        }
    };
    return row[i];
}

/* (1 - eps)/beta at zero overlap, beta < 7: 57 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 7.0625.
 * Relative error of the approximation: 2^-58.2 at most, proved for the whole cell of each row. */
#define COR_ROWS_LOSS_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_LOSS_ZERO_OVERLAP_STEP 0.125
#define COR_ROWS_LOSS_ZERO_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_LOSS_ZERO_OVERLAP_ROWS 57
#define COR_ROWS_LOSS_ZERO_OVERLAP_END 7.0
COR_INLINE const double *cor_rows_loss_zero_overlap(int i)
{
    static const double row[57][12] = {
        /* [0] 0 <= y <= 0.0625, degree 10, 60.1 bits */
        {
         1.1534488499164581, 8.1788306692477548e-09, -0.79826656094479542, 0.52288256808841493,
         -0.34874267526034775, 0.23309813201158869, -0.15668215158911236, 0.10581873812962693,
         -0.071763528280843064, 0.04881717366521926, -0.032818374653496858, 0.018511558063481599
        },
        /* [1] 0.0625 <= y <= 0.1875, degree 10, 59.0 bits */
        {
         1.0612069368362427, 2.5228753230416938e-09, -0.68224578537466285, 0.41124304537870998,
         -0.25308090600476713, 0.15578999742351413, -0.096397174869935265, 0.059907511729117124,
         -0.037367049226916735, 0.023390955918805863, -0.014744451667414081, 0.0092843467931797204
        },
        /* [2] 0.1875 <= y <= 0.3125, degree 10, 59.0 bits */
        {
         0.9818928986787796, -3.6892589254544297e-09, -0.59018870091146813, 0.3292579698482187,
         -0.1881913829102691, 0.1073780466188341, -0.061559006560583919, 0.035438312848660912,
         -0.020464431813466747, 0.011858005734409002, -0.0069130846254573854, 0.0040275335688963335
        },
        /* [3] 0.3125 <= y <= 0.4375, degree 10, 58.2 bits */
        {
         0.91292086243629456, 2.2221879181721591e-09, -0.51592594950262538, 0.26766839087010663,
         -0.14289324683410987, 0.075989622562954856, -0.040582965857067915, 0.021766354144415353,
         -0.011701608416556219, 0.0063124831657706392, -0.0034234281169273004, 0.0018559246758219252
        },
        /* [4] 0.4375 <= y <= 0.5625, degree 10, 60.2 bits */
        {
         0.85235074162483215, 1.0452698795726668e-09, -0.45515914810906238, 0.2204876461522586,
         -0.11047947440985487, 0.055022933865804591, -0.027499733906196457, 0.013811507680193706,
         -0.0069450360504935173, 0.0035054165253902009, -0.0017773232459486346, 0.0009010221338318973
        },
        /* [5] 0.5625 <= y <= 0.6875, degree 10, 58.7 bits */
        {
         0.798697829246521, 2.8373864041658147e-09, -0.40481730828082957, 0.18372561372710064,
         -0.086779203880325256, 0.040651657472927857, -0.019084891880959739, 0.0090177244170441279,
         -0.0042580637911918467, 0.0020197853256019695, -0.00096158294260994485, 0.00045778371917833621
        },
        /* [6] 0.6875 <= y <= 0.8125, degree 10, 59.4 bits */
        {
         0.75080627202987671, -6.6196578550510767e-09, -0.36265784123006523, 0.15465224880092357,
         -0.069116351026151615, 0.030577213155084985, -0.013524213656006132, 0.0060388353771471401,
         -0.0026862484220560191, 0.0012022027040575105, -0.00053953668435034513, 0.00024205718514294644
        },
        /* [7] 0.8125 <= y <= 0.9375, degree 10, 59.5 bits */
        {
         0.70776255428791046, 3.7199325034460898e-09, -0.32701119422902908, 0.13135659921313142,
         -0.055726069806957906, 0.023374953844976232, -0.0097599036631044207, 0.0041369949606034073,
         -0.0017380219914194344, 0.00073639837987569631, -0.00031276105987458689, 0.00013255794022146511
        },
        /* [8] 0.9375 <= y <= 1.0625, degree 10, 59.6 bits */
        {
         0.66883519291877747, -3.3854184011000332e-09, -0.29661278731880436, 0.11247421175195856,
         -0.04541566223836286, 0.018137294244500002, -0.0071555803974986025, 0.0028932428016678301,
         -0.0011502522548454378, 0.00046257168662788606, -0.00018680746289959473, 7.4840825670911547e-05
        },
        /* [9] 1.0625 <= y <= 1.1875, degree 10, 58.9 bits */
        {
         0.63343152403831482, -5.6325123968014108e-09, -0.2704896300530073, 0.097013856923204925,
         -0.037361151320281207, 0.014271773217362277, -0.0053176932548121029, 0.0020619898556057331,
         -0.00077725685553929938, 0.00029681807010168478, -0.00011483404337125492, 4.3353870425586544e-05
        },
        /* [10] 1.1875 <= y <= 1.3125, degree 10, 59.7 bits */
        {
         0.60106651484966278, -1.361021103594216e-10, -0.2478821050064299, 0.084244625677717885,
         -0.030981776572506683, 0.011383024832065745, -0.0039969958748967962, 0.0014949376074677022,
         -0.000536009693696967, 0.00019351884017559362, -7.273231415610679e-05, 2.5636586994745176e-05
        },
        /* [11] 1.3125 <= y <= 1.4375, degree 10, 60.8 bits */
        {
         0.57133972644805908, -1.3281318440336637e-09, -0.22818890850838727, 0.073620702316180994,
         -0.025860670104374185, 0.0092016840954865838, -0.0030325581138109384, 0.0010998646673326027,
         -0.00037804648820891177, 0.00012708488683071354, -4.7632485390336412e-05, 1.5436694252230211e-05
        },
        /* [12] 1.4375 <= y <= 1.5625, degree 10, 60.1 bits */
        {
         0.54391808807849884, -4.1885321694394451e-09, -0.21092757377999227, 0.064730177603195438,
         -0.02169372940645066, 0.0075402734672742194, -0.0023191603630300368, 0.00081758640904007343,
         -0.00027451355409830955, 8.283173410681171e-05, -3.2334329304927598e-05, 9.5982034760127963e-06
        },
        /* [13] 1.5625 <= y <= 1.6875, degree 10, 59.9 bits */
        {
         0.5185229480266571, 7.051842869009022e-10, -0.19570570289138972, 0.057259460093390828,
         -0.018256238481132739, 0.0062649530689378391, -0.0017879106047793336, 0.00060877830423108567,
         -0.00020782479805251565, 5.238485362331625e-05, -2.2459379511874207e-05, 6.5953181869695477e-06
        },
        /* [14] 1.6875 <= y <= 1.8125, degree 10, 61.3 bits */
        {
         0.49492023885250092, -3.4408837203057159e-09, -0.18219973049967189, 0.050967891335561608,
         -0.015381035725401303, 0.005276798614378778, -0.0013944316127939161, 0.00044648975573656279,
         -0.00016660573799545154, 3.1453533070932609e-05, -1.4936759787601345e-05, 5.7614072979993923e-06
        },
        /* [15] 1.8125 <= y <= 1.9375, degree 10, 58.9 bits */
        {
         0.47291284799575806, 6.7190146767851064e-10, -0.17013914349499595, 0.045668999256740846,
         -0.01294444968612724, 0.0044990205732221037, -0.0011112063767838738, 0.00031231895760868404,
         -0.00014218015707729206, 1.8816075922920485e-05, -7.3332449762212129e-06, 6.630984750660759e-06
        },
        /* [16] 1.9375 <= y <= 2.0625, degree 10, 58.9 bits */
        {
         0.45233481377363205, 3.5492921787482028e-09, -0.15929481915568264, 0.041215965082912552,
         -0.010857550161145662, 0.0038682958117050156, -0.00092173494103124729, 0.00019529441137151871,
         -0.00012584929261812576, 1.5585370009469974e-05, 1.9383417869937203e-06, 8.1613483237278124e-06
        },
        /* [17] 2.0625 <= y <= 2.1875, degree 10, 59.2 bits */
        {
         0.43304667621850967, -1.0233141904093544e-09, -0.14947064719241049, 0.037489670125880954,
         -0.0090608422960761978, 0.0033296610483385955, -0.00081473043045878998, 9.273895222984278e-05,
         -0.00010721971667308204, 2.3642617073221681e-05, 1.2340800166253822e-05, 7.9023589994358713e-06
        },
        /* [18] 2.1875 <= y <= 2.3125, degree 10, 59.9 bits */
        {
         0.41493171453475952, -2.754425088383241e-09, -0.14049792399529104, 0.034388370948579675,
         -0.0075205621741134161, 0.002835318309019006, -0.00077733476895323569, 1.1664988035472506e-05,
         -7.4975461169602905e-05, 4.2211404459672873e-05, 1.9429368554597546e-05, 2.2941461114823546e-06
        },
        /* [19] 2.3125 <= y <= 2.4375, degree 10, 59.3 bits */
        {
         0.39789277315139771, -3.6669801237011893e-09, -0.1322321552753124, 0.031818788420501211,
         -0.0062244681282100298, 0.002347889821807057, -0.00078796610426125249, -3.2260363194500272e-05,
         -2.1876049989803081e-05, 6.3209299633835739e-05, 1.5124202963616409e-05, -1.0092625093291196e-05
        },
        /* [20] 2.4375 <= y <= 2.5625, degree 10, 60.1 bits */
        {
         0.38184931129217148, -7.7356374316554232e-10, -0.12455185533992884, 0.029689212400824783,
         -0.0051749778022881672, 0.0018474835641917092, -0.00081205390581850047, -2.1916253953493686e-05,
         4.6686119293540168e-05, 6.9888810599136851e-05, -6.1946450789151524e-06, -2.3100384635698508e-05
        },
        /* [21] 2.5625 <= y <= 2.6875, degree 10, 63.7 bits */
        {
         0.36673454195261002, -5.7962155948447367e-10, -0.11735868964040398, 0.027905893836444092,
         -0.0043784605223254058, 0.0013391561209038538, -0.00080590360214186562, 4.7251603335700782e-05,
         0.00010735857583817198, 4.5565544027279424e-05, -3.7051891882822812e-05, -2.2976345067324322e-05
        },
        /* [22] 2.6875 <= y <= 2.8125, degree 10, 60.4 bits */
        {
         0.35249248892068863, -3.2602155887026993e-09, -0.11057796645903248, 0.026374022737263636,
         -0.0038319770126066703, 0.00085449896110129315, -0.00073155570180317932, 0.00015399984811495472,
         0.0001275225917116297, -8.6163419576159018e-06, -5.4560507257824144e-05, -2.0297550230575763e-06
        },
        /* [23] 2.8125 <= y <= 2.9375, degree 10, 61.0 bits */
        {
         0.33907503634691238, 2.2130030633752917e-10, -0.10415827039511, 0.025003496270627437,
         -0.0035119599969695168, 0.00044173164580034848, -0.00057681752439222298, 0.00025302379963956963,
         8.9339048873306179e-05, -6.4811175288893101e-05, -3.9070045220395473e-05, 2.5709091469873641e-05
        },
        /* [24] 2.9375 <= y <= 3.0625, degree 10, 59.6 bits */
        {
         0.32643916457891464, -2.3248497919957394e-10, -0.098069224097325186, 0.023717633981212443,
         -0.0033706964856524569, 0.00014539475580135141, -0.00036580813428938172, 0.00029791373835732127,
         9.5193044163210691e-06, -8.7080929634598955e-05, 1.459116623316406e-06, 3.4488614861213782e-05
        },
        /* [25] 3.0625 <= y <= 3.1875, degree 10, 60.5 bits */
        {
         0.31454454362392426, -2.1812469944623235e-09, -0.092297073171432237, 0.022461196775352771,
         -0.0033435844545288023, -1.4216820989148354e-05, -0.00014847377105723042, 0.00027006164685236008,
         -6.9247235302923586e-05, -6.3898358908405427e-05, 3.5869054099074482e-05, 1.7364403510177256e-05
        },
        /* [26] 3.1875 <= y <= 3.3125, degree 10, 61.0 bits */
        {
         0.30335182696580887, -9.1663948943120399e-10, -0.086838749432871329, 0.021204058348870108,
         -0.0033640311633043448, -4.9393351519740094e-05, 2.5571644248863079e-05, 0.00018805910767370797,
         -0.00011028129920613426, -1.7046322316901229e-05, 4.2020076658155187e-05, -6.5929007138748965e-06
        },
        /* [27] 3.3125 <= y <= 3.4375, degree 10, 59.5 bits */
        {
         0.29282171279191971, 2.0020294282282409e-09, -0.081695747029836951, 0.019939032378711204,
         -0.0033783446905712726, 2.9899358787852989e-06, 0.00012978888288129827, 9.0507221878972978e-05,
         -0.0001061291557607778, 2.2080846858230533e-05, 2.5059839401239484e-05, -1.7727395440924771e-05
        },
        /* [28] 3.4375 <= y <= 3.5625, degree 10, 59.9 bits */
        {
         0.28291469812393188, 2.3296759975707316e-09, -0.076869153215199326, 0.0186752345386807,
         -0.0033538968908268679, 9.8525129807657973e-05, 0.00016589456449887167, 1.0503493637855796e-05,
         -7.4105657945642504e-05, 3.7953943626046836e-05, 3.9540006451951906e-06, -1.4299474385124102e-05
        },
        /* [29] 3.5625 <= y <= 3.6875, degree 10, 60.2 bits */
        {
         0.27359133213758469, 3.2476223934439939e-09, -0.072356586171412246, 0.017429995121616727,
         -0.0032788708826403811, 0.00020025826037591558, 0.00015362780564653702, -3.7744135609110987e-05,
         -3.6828157821227523e-05, 3.4241652671520521e-05, -8.6198544978923931e-06, -5.7425038745876053e-06
        },
        /* [30] 3.6875 <= y <= 3.8125, degree 10, 61.6 bits */
        {
         0.26481275260448456, 2.5583322461771133e-09, -0.068151040181002639, 0.016222034965963958,
         -0.0031564710143832434, 0.00028545993623780376, 0.00011667958203841457, -5.6627170761444588e-05,
         -8.371101500368008e-06, 2.2163848167000939e-05, -1.1444791395717802e-05, 5.6173126274180939e-07
        },
        /* [31] 3.8125 <= y <= 3.9375, degree 10, 61.3 bits */
        {
         0.25654125213623047, 3.5222905145750288e-10, -0.064241128945238576, 0.015067188536136186,
         -0.0029977591290655764, 0.00034487598975642696, 7.3542801916420686e-05, -5.6071404960282185e-05,
         7.6756477338767893e-06, 1.0424432591745503e-05, -8.9020941526849793e-06, 2.9385743308352105e-06
        },
        /* [32] 3.9375 <= y <= 4.0625, degree 10, 62.4 bits */
        {
         0.24874076619744301, 1.2283501315475811e-09, -0.060612077679588296, 0.013976597917721434,
         -0.0028159396392087722, 0.00037836953033607381, 3.4897275920332441e-05, -4.6100296993528589e-05,
         1.3802286210239173e-05, 2.5413355290393995e-06, -5.1454328654361076e-06, 2.815393228135027e-06
        },
        /* [33] 4.0625 <= y <= 4.1875, degree 10, 63.2 bits */
        {
         0.24137723445892334, 9.8847028479349532e-10, -0.05724693482509155, 0.012956614495546914,
         -0.0026229821768818987, 0.00039034491278835894, 4.9913459035653997e-06, -3.3619133227049704e-05,
         1.4061377342056071e-05, -1.4703914170998085e-06, -2.2040173535153837e-06, 1.8509112592408663e-06
        },
        /* [34] 4.1875 <= y <= 4.3125, degree 10, 60.1 bits */
        {
         0.23441878706216812, 9.5124830934014264e-10, -0.054127683615189125, 0.012009574206457933,
         -0.0024282260350164827, 0.00038651403680986572, -1.5824572157517148e-05, -2.2234468035698591e-05,
         1.1731225670947849e-05, -2.8689636719272309e-06, -4.846312306565168e-07, 9.4510607310733185e-07
        },
        /* [35] 4.3125 <= y <= 4.4375, degree 10, 60.4 bits */
        {
         0.22783582657575607, 1.7552162370228213e-09, -0.051236116604290179, 0.011134841841369102,
         -0.0022382149053811811, 0.00037216421522509732, -2.8973304499614161e-05, -1.3262237430810819e-05,
         8.7736211769743826e-06, -2.9014737880489177e-06, 2.9670621898608749e-07, 3.5949763088199719e-07
        },
        /* [36] 4.4375 <= y <= 4.5625, degree 10, 59.8 bits */
        {
         0.22160101309418678, 9.8116435364430269e-10, -0.048554452507500782, 0.010329792513224609,
         -0.0020571078077771627, 0.00035149913060062945, -3.6347010348058052e-05, -6.7910813948960018e-06,
         6.1029205148621933e-06, -2.3965477975140816e-06, 5.3456746003192197e-07, 5.9555230109562435e-08
        },
        /* [37] 4.5625 <= y <= 4.6875, degree 10, 62.6 bits */
        {
         0.21568917855620384, -1.1420981644013493e-09, -0.046065730679005719, 0.0095905990210703364,
         -0.0018872545123291857, 0.00032756891256093272, -3.9683202713476098e-05, -2.4102747268308953e-06,
         4.0122099726437887e-06, -1.7882012129891486e-06, 5.2039719547220151e-07, -6.1025863190520447e-08
        },
        /* [38] 4.6875 <= y <= 4.8125, degree 10, 59.7 bits */
        {
         0.21007720753550529, -6.3608076142416049e-10, -0.043754035629027729, 0.0089128066643168295,
         -0.0017297333168320567, 0.0003024476622103727, -4.035450389299453e-05, 3.9985864407557205e-07,
         2.4997894416126067e-06, -1.2558467944033148e-06, 4.1957290546736683e-07, -9.0726104301856822e-08
        },
        /* [39] 4.8125 <= y <= 4.9375, degree 10, 61.9 bits */
        {
         0.20474391058087349, -1.3054468338094352e-09, -0.041604601465287501, 0.0082917259041167552,
         -0.0015847799139512913, 0.00027747077655095829, -3.9359516171061568e-05, 2.1019276638983778e-06,
         1.4587439506062311e-06, -8.4710978399941748e-07, 3.0884889374433155e-07, -8.3108546415929124e-08
        },
        /* [40] 4.9375 <= y <= 5.0625, degree 10, 66.1 bits */
        {
         0.19966986402869225, -4.4304690901119018e-10, -0.039603836432812158, 0.0077226861280903477,
         -0.001452101232077642, 0.00025345008258834806, -3.7388193090881055e-05, 3.0542822180807051e-06,
         7.6681927884202895e-07, -5.541518534142048e-07, 2.1607166858395192e-07, -6.4804509233096806e-08
        },
        /* [41] 5.0625 <= y <= 5.1875, degree 10, 59.6 bits */
        {
         0.19483727589249611, -2.7696998613969044e-10, -0.037739297129427828, 0.0072011904940530681,
         -0.0013310931170555681, 0.00023084203883277482, -3.4900310546204123e-05, 3.515106649231718e-06,
         3.2004768184328267e-07, -3.5239848301321621e-07, 1.466207103105546e-07, -4.6784218908341014e-08
        },
        /* [42] 5.1875 <= y <= 5.3125, degree 10, 61.9 bits */
        {
         0.19022983685135841, 7.3960296685571145e-10, -0.035999632994353922, 0.0067230034121754092,
         -0.0012209857853831823, 0.0002098695814093692, -3.2193341010550813e-05, 3.662773877761062e-06,
         4.0011071148224571e-08, -2.168555396492396e-07, 9.7542304899225164e-08, -3.2415332102808104e-08
        },
        /* [43] 5.3125 <= y <= 5.4375, degree 10, 64.6 bits */
        {
         0.18583259731531143, -1.3889839291900428e-09, -0.034374514871442059, 0.0062841936572697399,
         -0.001120938126356473, 0.00019060658516594769, -2.9454086633562475e-05, 3.6173569809511685e-06,
         -1.2894210908749201e-07, -1.2733384966996315e-07, 6.393198825384634e-08, -2.1957496479520104e-08
        },
        /* [44] 5.4375 <= y <= 5.5625, degree 10, 59.6 bits */
        {
         0.18163182958960533, -1.1789173408931045e-09, -0.032854556614084894, 0.0058811491040771571,
         -0.0010300970319425662, 0.00017303483752764213, -2.6795498491336581e-05, 3.4582620640763156e-06,
         -2.250168384572093e-07, -6.9042420119845043e-08, 4.1312580661022023e-08, -1.4685750175493308e-08
        },
        /* [45] 5.5625 <= y <= 5.6875, degree 10, 59.5 bits */
        {
         0.17761493101716042, 3.0343342322415475e-10, -0.031431235384142664, 0.0055105738971609397,
         -0.00094763334977311338, 0.00015708176680439816, -2.4282023135183814e-05, 3.2372423291448653e-06,
         -2.739601116112937e-07, -3.1659582166953641e-08, 2.62427594388162e-08, -9.7459373943998499e-09
        },
        /* [46] 5.6875 <= y <= 5.8125, degree 10, 62.4 bits */
        {
         0.17377031594514847, 4.4441335267727924e-10, -0.030096814077627557, 0.0051694752249759552,
         -0.00087276246490977031, 0.000142645055658961, -2.1946710909752415e-05, 2.987516379018077e-06,
         -2.9293854920294174e-07, -8.1601382211412816e-09, 1.6270604831068206e-08, -6.4284395918305087e-09
        },
        /* [47] 5.8125 <= y <= 5.9375, degree 10, 64.5 bits */
        {
         0.17008731886744499, -1.6344366511005143e-09, -0.028844267848662054, 0.0048551443801727852,
         -0.00080475492302501468, 0.00012960845358225021, -1.9802632795419384e-05, 2.7299879290386809e-06,
         -2.9331685388213384e-07, 6.1785411018982914e-09, 9.7124322369771406e-09, -4.2120888127270821e-09
        },
        /* [48] 5.9375 <= y <= 6.0625, degree 10, 60.4 bits */
        {
         0.16655610501766205, -3.731201781980079e-10, -0.027667215755655991, 0.0045651351167423204,
         -0.00074294071038534309, 0.00011785173776362983, -1.7850442462915936e-05, 2.477431643985892e-06,
         -2.8257140188877306e-07, 1.4512951200776934e-08, 5.432237184748236e-09, -2.7349012837204794e-09
        },
        /* [49] 6.0625 <= y <= 6.1875, degree 10, 62.4 bits */
        {
         0.16316761076450348, -6.7233302386382155e-10, -0.026559857949515455, 0.0042972412024794458,
         -0.00068670958662290691, 0.00010725680968394897, -1.6083352831564145e-05, 2.2372923167027767e-06,
         -2.6558330897318883e-07, 1.8947250256457596e-08, 2.6691852257637591e-09, -1.7519133908275735e-09
        },
        /* [50] 6.1875 <= y <= 6.3125, degree 10, 61.0 bits */
        {
         0.15991345793008804, -1.2141509757055938e-09, -0.025516918447299745, 0.0040494743304888064,
         -0.00063550904767889222, 9.771125717491022e-05, -1.4490386319737746e-05, 2.0135512313901865e-06,
         -2.455050419136065e-07, 2.0881732598249741e-08, 9.1480121118646268e-10, -1.0991761509486981e-09
        },
        /* [51] 6.3125 <= y <= 6.4375, degree 10, 61.3 bits */
        {
         0.15678589791059494, -7.7212402866476938e-10, -0.024533593308334059, 0.0038200430713630608,
         -0.00058884094951096582, 8.9110268770903231e-05, -1.3058475076584742e-05, 1.8079683098560799e-06,
         -2.2433971861036733e-07, 2.1246293354048656e-08, -1.7082408650966705e-10, -6.6732116122447228e-10
        },
        /* [52] 6.4375 <= y <= 6.5625, degree 10, 60.4 bits */
        {
         0.15377775579690933, 1.6347451772464479e-09, -0.023605503901408906, 0.0036073332341223664,
         -0.00054625745884114441, 8.1357490631493224e-05, -1.1773796535668799e-05, 1.6209070374860123e-06,
         -2.0332836609043941e-07, 2.0656227133626395e-08, -8.1514501724242165e-10, -3.8334823144356572e-10
        },
        /* [53] 6.5625 <= y <= 6.6875, degree 10, 61.0 bits */
        {
         0.15088238567113876, 9.5497189143537612e-10, -0.022728654886730336, 0.0034098898026633786,
         -0.00050735675495880872, 7.4365218072991994e-05, -1.0622601895974873e-05, 1.451880366973168e-06,
         -1.8320903800335006e-07, 1.9516222097696349e-08, -1.1704831913456508e-09, -1.9842287213620054e-10
        },
        /* [54] 6.6875 <= y <= 6.8125, degree 10, 60.3 bits */
        {
         0.14809361100196838, 1.9715257848067777e-10, -0.021899396511701488, 0.0032264004876505319,
         -0.00047177874593142525, 6.8054181175561257e-05, -9.5917098830025076e-06, 1.2999098514608851e-06,
         -1.6439032421882748e-07, 1.8089919379734425e-08, -1.3388364658296981e-09, -7.9788832287577483e-11
        },
        /* [55] 6.8125 <= y <= 6.9375, degree 10, 60.3 bits */
        {
         0.14540569484233856, -8.154678796396964e-10, -0.021114390820144994, 0.0030556808562962039,
         -0.00043920095650450217, 6.2353095200015179e-05, -8.6687811891358321e-06, 1.1637597049042099e-06,
         -1.4706752946006001e-07, 1.6546562256911213e-08, -1.388407546479541e-09, -5.4204196046638897e-12
        },
        /* [56] 6.9375 <= y <= 7.0625, degree 10, 61.9 bits */
        {
         0.1428132988512516, -1.5151439232727511e-09, -0.020370581390133112, 0.0028966609574572269,
         -0.00040933467544948402, 5.7198087133158541e-05, -7.8424508571616891e-06, 1.0420871587492353e-06,
         -1.3130035819002146e-07, 1.4992357790970858e-08, -1.3646538944619322e-09, 3.9520068864094462e-11
        }
    };
    return row[i];
}

/* (1 - eps)/beta at zero force, beta < 16: 65 rows of degree 10 in y = sqrt(beta), nodes 0 + i 0.0625, 0 <= y <= 4.03125.
 * Relative error of the approximation: 2^-58.2 at most, proved for the whole cell of each row. */
#define COR_ROWS_LOSS_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_LOSS_ZERO_FORCE_STEP 0.0625
#define COR_ROWS_LOSS_ZERO_FORCE_PER_UNIT 16.0
#define COR_ROWS_LOSS_ZERO_FORCE_ROWS 65
#define COR_ROWS_LOSS_ZERO_FORCE_PLAIN_ROWS 4
#define COR_ROWS_LOSS_ZERO_FORCE_END 16.0
COR_INLINE const double *cor_rows_loss_zero_force(int i)
{
    static const double row[65][12] = {
        /* [0] 0 <= y <= 0.03125, degree 10, 66.2 bits */
        {
         1.1534488499164581, 8.1788306692477548e-09, 5.0958840974630116e-22, -0.79826656094479542,
         -0.26666666666666322, 0.52288256808699907, 0.46137954353235411, -0.34874271036297394,
         -0.45234850375808922, 0.14631719611892938, 0.3708176297850917, -0.0026778271748397159
        },
        /* [1] 0.03125 <= y <= 0.09375, degree 10, 62.2 bits */
        {
         1.1502739191055298, 2.1976786180220323e-09, -0.10236467126377537, -0.83497367210604267,
         -0.11985814334837726, 0.64296500272534252, 0.29620536369119421, -0.52308147022704732,
         -0.32766595483707067, 0.34866225945493096, 0.32775466297802947, -0.1735047732744604
        },
        /* [2] 0.09375 <= y <= 0.15625, degree 10, 64.4 bits */
        {
         1.1405953168869019, -4.6485273485497603e-09, -0.20749359246649349, -0.84178008630519696,
         0.049744703455313746, 0.70248931563754458, 0.078519016774135558, -0.62225759895739619,
         -0.11378616185705691, 0.49061094322099991, 0.15564367587462241, -0.36331481913582186
        },
        /* [3] 0.15625 <= y <= 0.21875, degree 10, 62.2 bits */
        {
         1.124361664056778, -3.4860124289199713e-09, -0.31144473543139534, -0.8159405307594727,
         0.22536185936447342, 0.69013182540393514, -0.15724604456080415, -0.61641568127394497,
         0.14201978403876317, 0.50859683393109301, -0.09812425608417974, -0.42038350261388785
        },
        /* [4] 0.21875 <= y <= 0.28125, degree 10, 59.2 bits */
        {
         1.1017744541168213, 7.2952702179865397e-09, -0.82027567111969601, 0.12448828271865209,
         0.52871319759622204, 0.15580188705507608, -1.0517760802018903, 1.0995954841295581,
         -1.4577934757567621, 3.6832750474544067, -8.1067789370200174, 15.612681554465032
        },
        /* [5] 0.28125 <= y <= 0.34375, degree 10, 62.4 bits */
        {
         1.0732835829257965, 1.0733526202141691e-08, -0.79963767443463674, 0.20435467365126633,
         0.51112456882472634, -0.073665915988997827, -0.71953820483457853, 0.66249756599105003,
         -0.24623620773129362, 0.64507237649215743, -1.7590748868383912, 2.7201887164612182
        },
        /* [6] 0.34375 <= y <= 0.40625, degree 10, 62.0 bits */
        {
         1.039557546377182, -7.3718438660262542e-09, -0.76961594269792843, 0.27396924652765042,
         0.45926780567194753, -0.22823939439750759, -0.48892247386258819, 0.55186340792066491,
         -0.036959768538041053, -0.071705609758561287, -0.44832254788168363, 0.84055877900696552
        },
        /* [7] 0.40625 <= y <= 0.46875, degree 10, 61.1 bits */
        {
         1.0014329254627228, 5.6605634162476545e-09, -0.73171027432836233, 0.33007743605844275,
         0.3851794602039269, -0.32350584445639513, -0.29546836661092418, 0.49393430494272828,
         -0.07509804993810805, -0.2313431163070373, -0.014895981343114942, 0.3762616249111308
        },
        /* [8] 0.46875 <= y <= 0.53125, degree 10, 60.6 bits */
        {
         0.95985135436058044, 3.461894031247466e-09, -0.6877341010346284, 0.37093623365806616,
         0.29984562412968802, -0.36827286469893133, -0.13155408847585046, 0.42130633955369251,
         -0.15665996891638395, -0.20118918417495288, 0.15750050458684714, 0.14689020826222501
        },
        /* [9] 0.53125 <= y <= 0.59375, degree 10, 61.0 bits */
        {
         0.91579274833202362, -1.007823725863812e-09, -0.63962338588921708, 0.39630585953699177,
         0.21278368408816428, -0.37204580629016948, -0.002062441054638868, 0.32755139907886571,
         -0.21298781744010167, -0.10752894046405367, 0.19867051075985098, -0.0033258657377875844
        },
        /* [10] 0.59375 <= y <= 0.65625, degree 10, 59.2 bits */
        {
         0.87021400034427643, -2.6135358372990768e-10, -0.58926131295796103, 0.40721748294265125,
         0.13137872039594051, -0.34580348934118316, 0.089410403773443989, 0.22551565102926566,
         -0.2267768764140026, -0.01235507744072948, 0.16609820699096797, -0.085153204938997445
        },
        /* [11] 0.65625 <= y <= 0.71875, degree 10, 61.1 bits */
        {
         0.82399924099445343, 3.2259987656213115e-09, -0.53834151771206484, 0.40560546186145668,
         0.060541402459012753, -0.30074797837291661, 0.14419376353957664, 0.13046268350887236,
         -0.20447782752696936, 0.055204141894945824, 0.10366658193389845, -0.10721441611636692
        },
        /* [12] 0.71875 <= y <= 0.78125, degree 10, 59.9 bits */
        {
         0.777925044298172, 7.0783911825403261e-09, -0.48828058371656846, 0.39390230131396498,
         0.0027941580537496511, -0.24683257520830121, 0.16796059896313351, 0.05299935152874128,
         -0.16129576771864473, 0.088342997182465299, 0.042449326085322245, -0.090711590732410766
        },
        /* [13] 0.78125 <= y <= 0.84375, degree 10, 59.5 bits */
        {
         0.73264102637767792, -1.6535123441258273e-09, -0.44017921510936703, 0.37467550768586422,
         -0.041316633464696433, -0.19179713513947128, 0.16866384571865634, -0.0025918904417053645,
         -0.11215106978488731, 0.093251262209516322, -0.0018156343640567786, -0.058937227934749134
        },
        /* [14] 0.84375 <= y <= 0.90625, degree 10, 58.8 bits */
        {
         0.68866397440433502, -6.4797506719216146e-09, -0.39482359869902378, 0.35035248296088878,
         -0.072652764204742745, -0.14086461169076661, 0.15448122493037933, -0.037167204038264214,
         -0.067453965364866392, 0.080802762500595912, -0.026001091264641479, -0.028342469409394621
        },
        /* [15] 0.90625 <= y <= 0.96875, degree 10, 58.5 bits */
        {
         0.64638260006904602, -2.427979611280315e-09, -0.35271480307911468, 0.32304698648999741,
         -0.092913424128996544, -0.096956849746705501, 0.13242839865847611, -0.054565154926264015,
         -0.032390714818778574, 0.061080288866875596, -0.034083263925512315, -0.0064536774296319833
        },
        /* [16] 0.96875 <= y <= 1.03125, degree 10, 58.2 bits */
        {
         0.60606940090656281, -4.1364359982269621e-09, -0.31411395606604869, 0.29447722416624378,
         -0.1041589886979805, -0.061193185571431441, 0.10774170109857084, -0.05963632268912035,
         -0.0080790150548138168, 0.041021537343800277, -0.032199383478648612, 0.005771568193118819
        },
        /* [17] 1.03125 <= y <= 1.09375, degree 10, 59.6 bits */
        {
         0.56789647042751312, 1.8615967287517619e-09, -0.27909305019824809, 0.26595359642313232,
         -0.10846902837664181, -0.033462575114922642, 0.083846217593841213, -0.056932299451548485,
         0.0067604705076090019, 0.024253770911517262, -0.025731109014814835, 0.010567757640726563
        },
        /* [18] 1.09375 <= y <= 1.15625, degree 10, 59.7 bits */
        {
         0.53195288777351379, 6.1781962472242123e-09, -0.24758421529440572, 0.23841152490726103,
         -0.10773208888420889, -0.012935041592072162, 0.062651801683555136, -0.050071154064679858,
         0.014383717367787539, 0.011946101450894489, -0.018267912661104037, 0.010863884442432742
        },
        /* [19] 1.15625 <= y <= 1.21875, degree 10, 60.6 bits */
        {
         0.4982617124915123, -2.8164163113781726e-09, -0.21942321273828999, 0.21246794255704715,
         -0.10354229353552412, 0.0015475287430280304, 0.044963398552554164, -0.041591749761496419,
         0.017109174826435754, 0.0038424964300749647, -0.011690938276454371, 0.0090475292010096624
        },
        /* [20] 1.21875 <= y <= 1.28125, degree 10, 58.8 bits */
        {
         0.46679550409317017, -3.6585746582775922e-10, -0.19438524543517352, 0.18848560884984122,
         -0.097170994434748484, 0.011209083662753395, 0.030872686465596922, -0.033078931174622669,
         0.016868441850966417, -0.00092488678926149349, -0.0066816005302300077, 0.0066411875700509975
        },
        /* [21] 1.28125 <= y <= 1.34375, degree 10, 58.6 bits */
        {
         0.43748990446329117, 1.7247438514992983e-09, -0.17221279372998677, 0.16663512219347842,
         -0.089584306974313549, 0.017185825635552609, 0.020070121531042758, -0.025392357825617148,
         0.015073573017064745, -0.0033346325929915709, -0.0032461933506861937, 0.0044270124225470192
        },
        /* [22] 1.34375 <= y <= 1.40625, degree 10, 58.9 bits */
        {
         0.41025485843420029, -3.1079083828313715e-09, -0.15263614699994715, 0.14694918856350653,
         -0.081484025618985378, 0.02045230328098015, 0.012064262242266284, -0.018899322189268087,
         0.012654948050865509, -0.0042326453021820799, -0.0010983196468474885, 0.0026984545932655741
        },
        /* [23] 1.40625 <= y <= 1.46875, degree 10, 58.3 bits */
        {
         0.38498367369174957, -2.6791369769953402e-09, -0.13538775897790209, 0.12936702635016875,
         -0.073356670181485478, 0.021799411301250786, 0.0063198702085882612, -0.01366615197865524,
         0.010166227987866315, -0.0042537929384753185, 0.00011629078140496914, 0.0014842309392362016
        },
        /* [24] 1.46875 <= y <= 1.53125, degree 10, 59.8 bits */
        {
         0.3615601435303688, 1.0332851584491323e-09, -0.1202116790616486, 0.11376885301157941,
         -0.065521536156713273, 0.021842331763132838, 0.0023348812571804154, -0.0095966177222175531,
         0.0078976072125211769, -0.0038293766599342997, 0.00071296827299696176, 0.000699650951908413
        },
        /* [25] 1.53125 <= y <= 1.59375, degree 10, 61.7 bits */
        {
         0.33986391872167587, 1.5406347294494538e-10, -0.10686924139908718, 0.10000150189200629,
         -0.058173088983629009, 0.021043065046502538, -0.000323865188619919, -0.0065225889296550311,
         0.0059711019859022179, -0.0032283346467002348, 0.00093263177174738178, 0.00023137643602121459
        },
        /* [26] 1.59375 <= y <= 1.65625, degree 10, 59.6 bits */
        {
         0.31977444887161255, 3.3597083646787375e-10, -0.095142028934442041, 0.087896669868554503,
         -0.051415949339682174, 0.019737882518559412, -0.002010126401979256, -0.0042581000361314892,
         0.0044107221502527041, -0.0026039524830621351, 0.00094209436555548062, -2.3468610511805243e-05
        },
        /* [27] 1.65625 <= y <= 1.71875, degree 10, 62.4 bits */
        {
         0.30117382109165192, -6.0616369700668032e-10, -0.084832935241010321, 0.07728335743332089,
         -0.045292409228574235, 0.018164244186205363, -0.0030015860560966131, -0.0026281961801059403,
         0.0031895300698832211, -0.0020337969644355866, 0.00084825974668835771, -0.00014431146360757078
        },
        /* [28] 1.71875 <= y <= 1.78125, degree 10, 58.3 bits */
        {
         0.28394866734743118, -8.8660383835374511e-10, -0.075765959377664449, 0.067995918637318895,
         -0.039803272534689335, 0.016484534988261159, -0.0035096212722136146, -0.0014818216105375514,
         0.0022587822242606755, -0.0015494599842960097, 0.0007148520808924494, -0.00018676793919669148
        },
        /* [29] 1.78125 <= y <= 1.84375, degree 10, 58.5 bits */
        {
         0.26799140125513077, -1.9756640727311121e-09, -0.067785205709606194, 0.059878909149862762,
         -0.034923142807307531, 0.014805684817086322, -0.0036911131513975761, -0.0006954240224207181,
         0.0015645544020359121, -0.0011567985918216044, 0.00057686936391538517, -0.00018707342754836173
        },
        /* [30] 1.84375 <= y <= 1.90625, degree 10, 59.1 bits */
        {
         0.25320091843605042, 2.5471943508075114e-09, -0.06075342745012477, 0.052789676401029315,
         -0.030611313199194985, 0.013194680683184379, -0.0036599384814268005, -0.00017168188124883673,
         0.0010562807207341086, -0.00084875888783812205, 0.0004514246291536205, -0.00016740736866457985
        },
        /* [31] 1.90625 <= y <= 1.96875, degree 10, 60.6 bits */
        {
         0.23948295414447784, 2.5559289396558512e-10, -0.054550348982344302, 0.046599412151889771,
         -0.026819298596396007, 0.011690431033944447, -0.0034970511214738333, 0.00016394282070686327,
         0.00069042088779303513, -0.00061297698982543212, 0.0003451927028162134, -0.00014050810430049735
        },
        /* [32] 1.96875 <= y <= 2.03125, degree 10, 59.7 bits */
        {
         0.22675010189414024, -6.3021184950785691e-10, -0.049070924142885351, 0.041193199558958983,
         -0.023495878491173901, 0.010312603555610969, -0.0032587969356967939, 0.00036729024615222939,
         0.0004314035963640821, -0.00043596059953035293, 0.00025919936940439742, -0.00011314301138886535
        },
        /* [33] 2.03125 <= y <= 2.09375, degree 10, 61.5 bits */
        {
         0.21492170915007591, 1.4805398320735745e-09, -0.044223630912675928, 0.036469436664155232,
         -0.020590340843056644, 0.009068062830160855, -0.0029834937385548521, 0.00047943316399942025,
         0.00025118980094687775, -0.00030516446925927566, 0.00019172961090175412, -8.8504178925672582e-05
        },
        /* [34] 2.09375 <= y <= 2.15625, degree 10, 58.7 bits */
        {
         0.20392362028360367, 2.2265993548290029e-10, -0.039928862752191478, 0.032338903116994389,
         -0.018054456168059764, 0.0079554657262338613, -0.0026964844884027335, 0.0005301014279594558,
         0.00012824609810028052, -0.00020984385118716435, 0.00013999343612577792, -6.7763616845950114e-05
        },
        /* [35] 2.15625 <= y <= 2.21875, degree 10, 58.8 bits */
        {
         0.19368781894445419, 6.2982807290715136e-10, -0.036117449095227447, 0.028723651307109004,
         -0.015843576526918968, 0.0069684778757206269, -0.0024139296773681863, 0.0005404962170291631,
         4.636191277399415e-05, -0.00014124642966120224, 0.00010101497631449135, -5.1032621425242118e-05
        },
        /* [36] 2.21875 <= y <= 2.28125, degree 10, 63.7 bits */
        {
         0.18415206298232079, 3.9290913552270036e-10, -0.032729318963925579, 0.025555840996330549,
         -0.013917147046227825, 0.0060979790261230628, -0.002145601033400018, 0.00052551500753736683,
         -6.4728589783780744e-06, -9.2479757911114341e-05, 7.205985055533635e-05, -3.7925503358958817e-05
        },
        /* [37] 2.28125 <= y <= 2.34375, degree 10, 59.6 bits */
        {
         0.17525947093963623, -1.2945426723450426e-09, -0.029712309694541784, 0.022776592536198879,
         -0.012238835393014054, 0.0053335399960096896, -0.0018969072097932563, 0.00049546285830367976,
         -3.9038079851284067e-05, -5.8246137361014481e-05, 5.0802374797404429e-05, -2.7873524999404917e-05
        },
        /* [38] 2.34375 <= y <= 2.40625, degree 10, 59.1 bits */
        {
         0.16695810854434967, 1.6419964996643529e-09, -0.027021115404001827, 0.020334903253955702,
         -0.010776423123373494, 0.0046643833867840547, -0.0016703418403116628, 0.00045734165064292522,
         -5.7677243603554792e-05, -3.4547308847694584e-05, 3.5355705580798543e-05, -2.0287923603124496e-05
        },
        /* [39] 2.40625 <= y <= 2.46875, degree 10, 61.9 bits */
        {
         0.15920061245560646, -1.3102519282719455e-09, -0.024616365631894056, 0.018186650933469061,
         -0.0095015577855301851, 0.0040799842230540362, -0.0014665046956421771, 0.00041580571851067066,
         -6.6923967889105339e-05, -1.8408555761934195e-05, 2.4236774718111006e-05, -1.4635674742165051e-05
        },
        /* [40] 2.46875 <= y <= 2.53125, degree 10, 59.3 bits */
        {
         0.15194376930594444, 1.8720490090947792e-10, -0.02246382251404469, 0.016293694699499022,
         -0.0083894322606285938, 0.0035704236572473647, -0.001284811874642583, 0.00037386083498023746,
         -6.9983940459209638e-05, -7.6422523108145438e-06, 1.6305919255917637e-05, -1.046727554210036e-05
        },
        /* [41] 2.53125 <= y <= 2.59375, degree 10, 59.2 bits */
        {
         0.14514819160103798, -1.0763990948743766e-09, -0.02053368414018596, 0.014623074935261526,
         -0.0074184348974744999, 0.003126576547433587, -0.0011239823011020248, 0.00033336969240905823,
         -6.9098723633902442e-05, -6.5533573007705036e-07, 1.0701977852746781e-05, -7.4198790794962935e-06
        },
        /* [42] 2.59375 <= y <= 2.65625, degree 10, 59.3 bits */
        {
         0.1387779489159584, 1.257451396124118e-10, -0.018799981903143661, 0.013146308588617889,
         -0.0065697980245992341, 0.0027401898701595547, -0.00098236513588012726, 0.00029541372712905538,
         -6.5816403781173775e-05, 3.7022595253399644e-06, 6.7826271705109e-06, -5.2090744195672074e-06
        },
        /* [43] 2.65625 <= y <= 2.71875, degree 10, 59.1 bits */
        {
         0.13280027359724045, 1.7653274385846825e-09, -0.017240060307825426, 0.011838773247799469,
         -0.0058272614741786601, 0.0024038915955742501, -0.00085815529902575878, 0.00026054961554574925,
         -6.1190608628520251e-05, 6.2541272011956179e-06, 4.0737023237440504e-06, -3.6165467571179685e-06
        },
        /* [44] 2.71875 <= y <= 2.78125, degree 10, 59.2 bits */
        {
         0.12718526646494865, -2.2084887940736461e-10, -0.015834128639213432, 0.010679171912861225,
         -0.0051767603816126849, 0.0021111572093717164, -0.00074953118744036781, 0.00022898933957903733,
         -5.5925447733946304e-05, 7.5854279647682712e-06, 2.2281424666508241e-06, -2.4772944130840311e-06
        },
        /* [45] 2.78125 <= y <= 2.84375, degree 10, 59.3 bits */
        {
         0.12190561927855015, 8.1453632144567711e-10, -0.01456487493566351, 0.0096490699103053586,
         -0.0046061416688294061, 0.0018562522353513054, -0.00065473896140867867, 0.00020072528849069104,
         -5.0480197784408322e-05, 8.1085284529253105e-06, 9.9375953059122885e-07, -1.6680792485183033e-06
        },
        /* [46] 2.84375 <= y <= 2.90625, degree 10, 60.5 bits */
        {
         0.11693639494478703, 4.3946398806644282e-10, -0.013417133779899589, 0.0087324955224653729,
         -0.0041049105085862615, 0.001634162912431243, -0.00057214066780896769, 0.00017561615792885122,
         -4.5144350604644973e-05, 8.1114322358354778e-06, 1.8848473188240315e-07, -1.097709780029597e-06
        },
        /* [47] 2.90625 <= y <= 2.96875, degree 10, 59.2 bits */
        {
         0.1122547909617424, -3.4945796200900014e-11, -0.012377600446593187, 0.0079155963785371517,
         -0.0036640061505429679, 0.0014405228742734504, -0.0005002383231175212, 0.00015344510716353346,
         -4.0091035797195055e-05, 7.7932138800980904e-06, -3.1833792281921703e-07, -6.992143630905434e-07
        },
        /* [48] 2.96875 <= y <= 3.03125, degree 10, 61.2 bits */
        {
         0.10783994570374489, 7.7146290361079892e-10, -0.011434584899588341, 0.0071863443139432992,
         -0.0032756053783760549, 0.0012715407244136066, -0.00043768238738728398, 0.00013395844130155936,
         -3.5414782330067485e-05, 7.2897619940341456e-06, -6.1991699115119676e-07, -4.2371524126231873e-07
        },
        /* [49] 3.03125 <= y <= 3.09375, degree 10, 59.4 bits */
        {
         0.10367276147007942, 6.5488755991903131e-10, -0.010577799997843841, 0.0065342821413506124,
         -0.0029329512884242138, 0.0011239313984245836, -0.00038327043207784356, 0.00011689073872851648,
         -3.1158012608434569e-05, 6.6923680025709615e-06, -7.8234109673186146e-07, -2.3573233019490539e-07
        },
        /* [50] 3.09375 <= y <= 3.15625, degree 10, 59.6 bits */
        {
         0.099735734984278679, -4.3218928934646492e-11, -0.0097981790419642712, 0.0059503065227979931,
         -0.0026302048459345734, 0.00099485287111360145, -0.00033593994757352821, 0.00010198063556449109,
         -2.732947834213701e-05, 6.0610752139265669e-06, -8.5215886828063742e-07, -1.096347357148494e-07
        },
        /* [51] 3.15625 <= y <= 3.21875, degree 10, 59.0 bits */
        {
         0.096012812107801437, -7.9214704027414001e-10, -0.0090877184743280368, 0.0054264818479060539,
         -0.0023623166561083124, 0.0008818488965352168, -0.00029475793393765056, 8.8980244244944004e-05,
         -2.3916966300038411e-05, 5.4342153085712962e-06, -8.6190810996029696e-07, -2.699029616159512e-08
        },
        /* [52] 3.21875 <= y <= 3.28125, degree 10, 58.8 bits */
        {
         0.092489253729581833, -1.0363344591476792e-10, -0.0084393421406532936, 0.0049558806859421349,
         -0.0021249164968781004, 0.00078279791662496105, -0.00025890901237304132, 7.7660296744751545e-05,
         -2.0895952865630653e-05, 4.8351858912136603e-06, -8.3412822850530047e-07, 2.5397286562935752e-08
        },
        /* [53] 3.28125 <= y <= 3.34375, degree 10, 58.7 bits */
        {
         0.089151520282030106, -4.2903960640485946e-10, -0.0078467840367051119, 0.0045324469792321891,
         -0.0019142183409279734, 0.00069586793839635777, -0.00022768316994105725, 6.7812469953249622e-05,
         -1.8235411866487026e-05, 4.277241149035425e-06, -7.8425890622225675e-07, 5.6932195235903774e-08
        },
        /* [54] 3.34375 <= y <= 3.40625, degree 10, 59.7 bits */
        {
         0.085987154394388199, 5.2523826969993288e-10, -0.0073044869088705455, 0.004150878679067555,
         -0.0017269388082759333, 0.00061947698853281831, -0.00020046382346081829, 5.9249901169863234e-05,
         -1.5901635641317592e-05, 3.7668578841777952e-06, -7.2272565145511627e-07, 7.4282617858422435e-08
        },
        /* [55] 3.40625 <= y <= 3.46875, degree 10, 62.5 bits */
        {
         0.082984693348407745, -7.4315852276193629e-10, -0.0068075144597109895, 0.0038065269943597579,
         -0.0015602272139436744, 0.00055225865836063242, -0.00017671660085147878, 5.1806584130010609e-05,
         -1.3860680489685994e-05, 3.3060843530081331e-06, -6.5643452844846739e-07, 8.214984581192028e-08
        },
        /* [56] 3.46875 <= y <= 3.53125, degree 10, 61.0 bits */
        {
         0.080133566632866859, 3.6029319231608369e-10, -0.0063514752371773954, 0.0034953098319114723,
         -0.0014116055933106129, 0.00049303221758635, -0.00015597904727595059, 4.5336112869919629e-05,
         -1.2079868771267007e-05, 2.8941658814936495e-06, -5.8983931996514424e-07, 8.3826231056765359e-08
        },
        /* [57] 3.53125 <= y <= 3.59375, degree 10, 60.4 bits */
        {
         0.077424032613635063, -1.1292036122238802e-10, -0.0059324565661787367, 0.0032136373606483676,
         -0.0012789172923729957, 0.00044077677865657572, -0.0001378513394045022, 3.9710084934191242e-05,
         -1.0528651854559549e-05, 2.5286585568122144e-06, -5.2570035808654933e-07, 8.1598627724653626e-08
        },
        /* [58] 3.59375 <= y <= 3.65625, degree 10, 60.0 bits */
        {
         0.074847090989351273, 6.4223903942806417e-10, -0.005546967120157187, 0.0029583479363337098,
         -0.001160282897053058, 0.00039460901956479149, -0.00012198801288601215, 3.4816367361000676e-05,
         -9.179046779225731e-06, 2.2061823436078666e-06, -4.6562172422553667e-07, 7.7039230971650108e-08
        },
        /* [59] 3.65625 <= y <= 3.71875, degree 10, 59.5 bits */
        {
         0.07239442877471447, 8.9794336658726726e-10, -0.0051918869340406701, 0.0027266528839977092,
         -0.0010540624432818599, 0.0003537640110577488, -0.00010809066093920666, 3.0557354524513505e-05,
         -8.0057946027179614e-06, 1.9229216654505304e-06, -4.1042963126808343e-07, 7.1214640780108818e-08
        },
        /* [60] 3.71875 <= y <= 3.78125, degree 10, 62.8 bits */
        {
         0.070058355107903481, 5.2681770083551088e-10, -0.0048644238334979656, 0.0025160888580947425,
         -0.00095882299777952135, 0.00031757873777000394, -9.5901535575102431e-05, 2.6848296260433332e-05,
         -6.9863424747645066e-06, 1.6749503119912754e-06, -3.6043735223762688e-07, 6.4835712774988877e-08
        },
        /* [61] 3.78125 <= y <= 3.84375, degree 10, 61.3 bits */
        {
         0.067831749096512794, -2.8977517942528141e-10, -0.0045620754032312943, 0.0023244766903442985,
         -0.00087331082919562316, 0.00028547794759496302, -8.5197970216526319e-05, 2.361574062624204e-05,
         -6.1007191158356589e-06, 1.4584351507181229e-06, -3.1562936795313172e-07, 5.8364643505313111e-08
        },
        /* [62] 3.84375 <= y <= 3.90625, degree 10, 59.8 bits */
        {
         0.065708009526133537, 8.3108476418887622e-10, -0.0042825957429194553, 0.0021498857968921272,
         -0.00079642750198181489, 0.0002569620070078425, -7.5787538498475003e-05, 2.0796113103903954e-05,
         -5.331350672429877e-06, 1.2697571009487641e-06, -2.757882053496181e-07, 5.209124180696146e-08
        },
        /* [63] 3.90625 <= y <= 3.96875, degree 10, 60.1 bits */
        {
         0.063681019470095634, 4.5129145952823182e-12, -0.00402396636664548, 0.0019906033538958784,
         -0.00072720932271144582, 0.00023159648062589337, -6.7503865481832463e-05, 1.8334439473611366e-05,
         -4.6628480853523703e-06, 1.1055763904401598e-06, -2.4058078691039021e-07, 4.6187047966124364e-08
        },
        /* [64] 3.96875 <= y <= 4.03125, degree 10, 61.7 bits */
        {
         0.061745093204081059, 3.8684744604454885e-10, -0.0037843706930064686, 0.0018451075674355949,
         -0.00066480965225553846, 0.00020900319028900792, -6.0203012148408553e-05, 1.6183210463503857e-05,
         -4.0817861337348341e-06, 9.6286097296254708e-07, -2.0961631509302089e-07, 4.0743563992402529e-08
        }
    };
    return row[i];
}

/* duration at zero overlap, beta < 8: 65 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 8.0625.
 * Relative error of the approximation: 2^-58.2 at most, proved for the whole cell of each row. */
#define COR_ROWS_DURATION_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_DURATION_ZERO_OVERLAP_STEP 0.125
#define COR_ROWS_DURATION_ZERO_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_DURATION_ZERO_OVERLAP_ROWS 65
#define COR_ROWS_DURATION_ZERO_OVERLAP_END 8.0
COR_INLINE const double *cor_rows_duration_zero_overlap(int i)
{
    static const double row[65][12] = {
        /* [0] 0 <= y <= 0.0625, degree 10, 62.4 bits */
        {
         3.218065459719043, 7.5689901149092114e-17, 0.37118739297888209, 0.20971797419914343,
         0.0058007783582330573, 0.027062321807883427, -0.0076413751708114489, 0.0064075789148493071,
         -0.003539256687723842, 0.0022744236128864007, -0.0014212086267387152, 0.00075785329040852542
        },
        /* [1] 0.0625 <= y <= 0.1875, degree 10, 60.7 bits */
        {
         3.2677584535303978, 2.3947196756642732e-17, 0.42409198127721137, 0.21430253075462072,
         0.018361502210958967, 0.023580298893061753, -0.0037862859739114978, 0.004109894383260624,
         -0.0018983503159312593, 0.0011487479235855018, -0.00067320026876421704, 0.00039280481619713241
        },
        /* [2] 0.1875 <= y <= 0.3125, degree 10, 60.8 bits */
        {
         3.3241599467393343, -3.4796760377614487e-17, 0.47870861443768031, 0.22333874263530321,
         0.029706134412483366, 0.022064688535178872, -0.0012191152937436249, 0.0028585176634351389,
         -0.0010513323907320917, 0.00060734608981398409, -0.00033710253264991976, 0.00017538305081688833
        },
        /* [3] 0.3125 <= y <= 0.4375, degree 10, 61.6 bits */
        {
         3.3875515713108104, 1.8521003158434203e-16, 0.53610716483356224, 0.23653315071320558,
         0.040651608524674046, 0.0219100506804768, 0.00063707890407690418, 0.002156889741375667,
         -0.00059900815199610759, 0.00032540154219056633, -0.00018520917402201545, 7.9710004693801765e-05
        },
        /* [4] 0.4375 <= y <= 0.5625, degree 10, 61.4 bits */
        {
         3.458345571603711, -1.6060621152131397e-16, 0.59731832670730967, 0.25385156076858445,
         0.05178581348939517, 0.022777705724687593, 0.0020886407180416193, 0.0017482989382077794,
         -0.00036217252392900837, 0.00016076336445090819, -0.00011773433203007064, 3.3248846870306978e-05
        },
        /* [5] 0.5625 <= y <= 0.6875, degree 10, 59.9 bits */
        {
         3.5370835684549418, -6.127006378812324e-17, 0.66338948834749223, 0.27545363009305279,
         0.063566453414442711, 0.024470424426870321, 0.0032952114700964615, 0.0014838428655048136,
         -0.00026148078898191037, 4.5061228602165207e-05, -9.3696615576144968e-05, 7.2995681560726751e-06
        },
        /* [6] 0.6875 <= y <= 0.8125, degree 10, 60.4 bits */
        {
         3.6244414510222156, 2.723277173767841e-17, 0.73542803587987648, 0.30165478165287241,
         0.076372318002208547, 0.026860246519445592, 0.0043243768250619046, 0.0012595876589683182,
         -0.00026845640436812935, -5.947246808900121e-05, -9.6003722441562e-05, -1.0121828643401697e-05
        },
        /* [7] 0.8125 <= y <= 0.9375, degree 10, 61.5 bits */
        {
         3.7212391704736705, -1.4172525229552933e-16, 0.81463703134532783, 0.33290144217178436,
         0.090524900790321008, 0.029838451437690931, 0.005171428748606142, 0.00098226687233658933,
         -0.0003850927709959411, -0.00017783120429752333, -0.00011741453885742908, -2.3614423246198541e-05
        },
        /* [8] 0.9375 <= y <= 1.0625, degree 10, 61.0 bits */
        {
         3.8284546370222179, -1.10778938873478e-16, 0.90234534112609432, 0.36974996855732278,
         0.10628689851937266, 0.033270977982040699, 0.0057585144401418355, 0.00054693327678923855,
         -0.00063510911991259994, -0.0003289810169704068, -0.00015341770117644905, -3.3073225183722702e-05
        },
        /* [9] 1.0625 <= y <= 1.1875, degree 10, 59.5 bits */
        {
         3.9472410398163902, -2.1995546084879699e-16, 1.0000320724330591, 0.41284073871843796,
         0.12383747971251968, 0.036948582232299076, 0.0059193579909264694, -0.00017962393303643494,
         -0.0010583694132611215, -0.00052564964880663482, -0.00019627764637372445, -3.3165600184548828e-05
        },
        /* [10] 1.1875 <= y <= 1.3125, degree 10, 59.8 bits */
        {
         4.0789467555622858, -1.5332851119704147e-16, 1.10934296228713, 0.46285793997514751,
         0.14321964720614036, 0.040523968553031621, 0.005373589001398239, -0.0013694613594108064,
         -0.0017014930392136335, -0.00076653846926167865, -0.00022706474241729604, -1.0774042415745943e-05
        },
        /* [11] 1.3125 <= y <= 1.4375, degree 10, 59.9 bits */
        {
         4.2251365584868656, -1.6415700441273357e-16, 1.2320937220677506, 0.52046319129461571,
         0.16425183790958431, 0.043431203539258459, 0.0036973335190903425, -0.0032309899066295142,
         -0.002595525364564409, -0.0010175019882780929, -0.00020386506793584406, 5.8179043941532291e-05
        },
        /* [12] 1.4375 <= y <= 1.5625, degree 10, 61.0 bits */
        {
         4.3876120180100715, 2.2556460002310931e-16, 1.3702519795117032, 0.58618791175409934,
         0.18639495861621075, 0.044789229066777687, 0.00030544448167748456, -0.0059766283696109741,
         -0.0037075081298076611, -0.0011776986004721011, -4.7686838557528968e-05, 0.00020805293905525298
        },
        /* [13] 1.5625 <= y <= 1.6875, degree 10, 61.9 bits */
        {
         4.568427673778289, -1.9972932805653719e-16, 1.5258853119882521, 0.66026658806680549,
         0.20857014148243005, 0.043305792452948307, -0.0055219970111804262, -0.0097310871366691285,
         -0.0048510107603863643, -0.0010329187691475127, 0.00036276674748787725, 0.00046644867368641249
        },
        /* [14] 1.6875 <= y <= 1.8125, degree 10, 60.3 bits */
        {
         4.7698977314654982, -2.1673947982090267e-17, 1.7010583551107308, 0.74239360970653612,
         0.22893703294767129, 0.037226354215510397, -0.014509925040874481, -0.014341176566122925,
         -0.0055524244835302985, -0.00022131061258399501, 0.0011559659283064256, 0.00080570581288677199
        },
        /* [15] 1.8125 <= y <= 1.9375, degree 10, 60.2 bits */
        {
         4.9945856569474296, 3.2599670531741685e-16, 1.8976585251619453, 0.83139549188899231,
         0.24467542694916597, 0.024418213995262821, -0.02706980916672596, -0.019062578392551235,
         -0.0049180213983505494, 0.0017122558068295868, 0.0023325033075336219, 0.0010279607800700566
        },
        /* [16] 1.9375 <= y <= 2.0625, degree 10, 58.4 bits */
        {
         5.2452664692770412, 3.7892477795589468e-17, 2.1171306679404172, 0.92483654197186538,
         0.25187195245710148, 0.0027346492107690034, -0.042713595072643447, -0.022182033252801058,
         -0.0016581956742078143, 0.005027839931013493, 0.0034827994157843444, 0.00066216588146594184
        },
        /* [17] 2.0625 <= y <= 2.1875, degree 10, 60.5 bits */
        {
         5.5248495901863146, 2.0081486304360759e-16, 2.3601114401956842, 1.0186289502852568,
         0.24569436420366428, -0.029173859908358121, -0.059233207869236984, -0.020837931550458343,
         0.0054214664542518104, 0.0091364760060696944, 0.003468181642560228, -0.00092870078929363378
        },
        /* [18] 2.1875 <= y <= 2.3125, degree 10, 60.4 bits */
        {
         5.8362504628498311, -6.6414376896164871e-17, 2.6259817400098151, 1.1068005850225546,
         0.22110124946577117, -0.07053938652214567, -0.071986598274621116, -0.011598844555952366,
         0.016149410693844034, 0.011784699329707403, 0.0005924612481970422, -0.0038119613029660004
        },
        /* [19] 2.3125 <= y <= 2.4375, degree 10, 59.1 bits */
        {
         6.1822043236410629, 1.3550414210335154e-16, 2.9124053965111449, 1.1816636293583032,
         0.17428866178807395, -0.11694517468109568, -0.074112105569539455, 0.0075619751808874355,
         0.027211475309570132, 0.0091140031964784124, -0.0058819440725577793, -0.0061838866237092114
        },
        /* [20] 2.4375 <= y <= 2.5625, degree 10, 59.4 bits */
        {
         6.5650281294819459, -2.0165465492614148e-16, 3.2149891242288016, 1.2346567529542749,
         0.10477730260794023, -0.15950458642196347, -0.058743761656162241, 0.03407633393224628,
         0.031571214617651992, -0.0017720360348671938, -0.013057066844013409, -0.0042849265508643486
        },
        /* [21] 2.5625 <= y <= 2.6875, degree 10, 59.0 bits */
        {
         6.9863573355164297, 1.9486568381724828e-16, 3.5272539787987562, 1.2579919478402661,
         0.017439749267582402, -0.18615800395081894, -0.023449146756647714, 0.05862050357964315,
         0.021799694260457192, -0.017958574015469981, -0.013918796691890592, 0.0037189527340179057
        },
        /* [22] 2.6875 <= y <= 2.8125, degree 10, 60.4 bits */
        {
         7.4469083375631104, 2.625871380798824e-16, 3.8410977103486825, 1.2468480499999264,
         -0.076861929631544382, -0.18594089893286214, 0.025316047603539948, 0.067835075430803304,
         -0.0025831652429314329, -0.028820405378614803, -0.0034535562871429908, 0.012252842297917611
        },
        /* [23] 2.8125 <= y <= 2.9375, degree 10, 58.2 bits */
        {
         7.9463330638453762, 3.1298315001409772e-16, 4.1477973011352578, 1.201330981186522,
         -0.16329865059013454, -0.15489176202539004, 0.072184462366008478, 0.053058538134599049,
         -0.030309752073668622, -0.023546971172473691, 0.012647769678311891, 0.011414178500902922
        },
        /* [24] 2.9375 <= y <= 3.0625, degree 10, 58.3 bits */
        {
         8.4832241545652245, 6.7710838503487452e-16, 4.4393622698200135, 1.1271553499477147,
         -0.22768768282815749, -0.099758227988670678, 0.099925058033314904, 0.018814682935082937,
         -0.044570317365898816, -0.003475377410541422, 0.020467462951199444, 7.5517020830362394e-05
        },
        /* [25] 3.0625 <= y <= 3.1875, degree 10, 58.2 bits */
        {
         9.0552902830291711, -6.0590734909612722e-16, 4.7098231174365752, 1.0344121118419516,
         -0.26159885030572821, -0.035923953135068062, 0.099647744622998469, -0.018459091838683741,
         -0.037201762498183376, 0.016821047593412811, 0.013261926093085583, -0.010339174395998301
        },
        /* [26] 3.1875 <= y <= 3.3125, degree 10, 58.6 bits */
        {
         9.6596641101497891, 1.4464598705179071e-16, 4.9560003808545199, 0.93480147242963396,
         -0.26499742923199338, 0.019816243319985237, 0.075760399540393875, -0.042041056948484729,
         -0.015535069931398311, 0.023810600577613986, -0.00084181279914513673, -0.010428764390991579
        },
        /* [27] 3.3125 <= y <= 3.4375, degree 10, 58.4 bits */
        {
         10.293259841255155, 7.8485786994763984e-16, 5.1775182666706554, 0.83860349157576575,
         -0.24498686579546686, 0.056646987927551393, 0.041636570453917977, -0.04583587581283978,
         0.0056902901421720612, 0.01695993010938749, -0.0097260556126489324, -0.0033300490093896985
        },
        /* [28] 3.4375 <= y <= 3.5625, degree 10, 58.6 bits */
        {
         10.953089243449927, -7.8132789889338395e-16, 5.3761705791262724, 0.75269471408547572,
         -0.21187378343500315, 0.072566481552628556, 0.010664888885407944, -0.035136731036742849,
         0.016792122194655212, 0.0052681357391992957, -0.0097113341034335034, 0.0026717568647379483
        },
        /* [29] 3.5625 <= y <= 3.6875, degree 10, 58.9 bits */
        {
         11.636475520873164, -7.6254755951393219e-16, 5.554986648120023, 0.68013594234678165,
         -0.1751471341835511, 0.072199877952236632, -0.0098764084700066115, -0.019567912009431095,
         0.017377967273711662, -0.0031936724868211115, -0.0050161508724655326, 0.0041300482227029974
        },
        /* [30] 3.6875 <= y <= 3.8125, degree 10, 60.6 bits */
        {
         12.34115115067703, -6.1262462365346042e-16, 5.7173594836566632, 0.62097066785953658,
         -0.14121309505894919, 0.062558210784029705, -0.019322940405863707, -0.0063786857559695476,
         0.012278748039882782, -0.0061703192003497442, -0.00060640659885919962, 0.0026841799842874476
        },
        /* [31] 3.8125 <= y <= 3.9375, degree 10, 59.5 bits */
        {
         13.065262610456793, 3.5799353930406714e-16, 5.8664470714727868, 0.57348703527180722,
         -0.11310804127970839, 0.049719930102170622, -0.02075298661071398, 0.0016859592121658419,
         0.006289687026258906, -0.0054046564792117283, 0.0015571325101292422, 0.00085568450938525544
        },
        /* [32] 3.9375 <= y <= 4.0625, degree 10, 59.0 bits */
        {
         13.807319829618585, -3.6618600155850474e-16, 6.0048804515110197, 0.53533708797533985,
         -0.09137982347809144, 0.037488602587511161, -0.017962857960758721, 0.0051117490648313621,
         0.0018882338642082833, -0.0033446637451595052, 0.0018677621123550329, -0.00021223909958875334
        },
        /* [33] 4.0625 <= y <= 4.1875, degree 10, 60.0 bits */
        {
         14.566124676361783, -2.5643537141229786e-17, 6.1347032213055126, 0.50425297762573018,
         -0.075231538685875482, 0.027538764588956655, -0.013820042246168689, 0.005591478278088923,
         -0.0004827328499680464, -0.0014979586374747542, 0.0013469492604558206, -0.00052525064526666931
        },
        /* [34] 4.1875 <= y <= 4.3125, degree 10, 60.3 bits */
        {
         15.34070091779823, -7.3920522524410394e-16, 6.2574392696745953, 0.47837301604474824,
         -0.063409404314350479, 0.020157898969872849, -0.0099112842816526815, 0.0047077628172779926,
         -0.0013457648758107843, -0.00034737463999781571, 0.00071684229478777034, -0.00044731345136474226
        },
        /* [35] 4.3125 <= y <= 4.4375, degree 10, 60.6 bits */
        {
         16.130236194585319, -4.5020059992240812e-16, 6.37420641781668, 0.45630706460181064,
         -0.054707084155313473, 0.014971209252349444, -0.0068412398385458749, 0.0034744917918989081,
         -0.0013852386535964747, 0.00018437119274787738, 0.00026877971452808847, -0.00026808755540462948
        },
        /* [36] 4.4375 <= y <= 4.5625, degree 10, 62.8 bits */
        {
         16.934038403831728, 5.465863660312987e-16, 6.4858280008836271, 0.43707370077792679,
         -0.048166150939654151, 0.011419058937950914, -0.0046633504565430422, 0.0023749416964548805,
         -0.0011035001797844444, 0.00033499401631588958, 3.1862857162581684e-05, -0.00012071734116036465
        },
        /* [37] 4.5625 <= y <= 4.6875, degree 10, 59.1 bits */
        {
         17.751504760098896, 1.5084187920256897e-15, 6.5929225632689379, 0.41999887600987107,
         -0.043101351783821185, 0.0089914177438354288, -0.0032074230707425972, 0.0015559451890359464,
         -0.00077318483015094929, 0.00030887038017379548, -5.9176613980718708e-05, -3.4513057346357378e-05
        },
        /* [38] 4.6875 <= y <= 4.8125, degree 10, 60.0 bits */
        {
         18.582100483489747, -3.6365564196139005e-16, 6.6959685019462709, 0.40462140394659279,
         -0.039052123271420519, 0.0073036266144744458, -0.0022624124319438554, 0.0010035293375199158,
         -0.00050295861806582602, 0.00022889343384719982, -7.4547467924720946e-05, 3.8135121311606941e-06
        },
        /* [39] 4.8125 <= y <= 4.9375, degree 10, 61.2 bits */
        {
         19.425344199661474, -1.3424634688578835e-15, 6.7953477536583717, 0.39062076085829167,
         -0.035718541682110694, 0.0060940689041877232, -0.0016520078774830754, 0.00065170774164969864,
         -0.00031417623852056966, 0.00015132215275778042, -6.0911419054487664e-05, 1.5029888594402569e-05
        },
        /* [40] 4.9375 <= y <= 5.0625, degree 10, 60.3 bits */
        {
         20.280797795219804, 8.1302939039506502e-16, 6.8913743420212752, 0.377767561345693,
         -0.032906620777825579, 0.0051951951803221649, -0.0012515212618544234, 0.00043380099769777794,
         -0.00019350865072179462, 9.3629914330749508e-05, -4.180009528635987e-05, 1.4485911038754227e-05
        },
        /* [41] 5.0625 <= y <= 5.1875, degree 10, 59.8 bits */
        {
         21.148059167107416, -9.913054840763172e-16, 6.9843128688350768, 0.36589165826190839,
         -0.030489134120280377, 0.0045028890586774522, -0.00098060293838545779, 0.00029929674818908095,
         -0.00012019181896392246, 5.5961093640395461e-05, -2.605483607492775e-05, 1.054270234136049e-05
        },
        /* [42] 5.1875 <= y <= 5.3125, degree 10, 63.1 bits */
        {
         22.026756854282151, -4.678305213094352e-16, 7.0743906388280342, 0.35486225100262647,
         -0.028380156680592541, 0.0039528079177934706, -0.00079017241206578146, 0.00021484028644597753,
         -7.6639142833234792e-05, 3.3143772764070132e-05, -1.5365949129251595e-05, 6.7051827459558464e-06
        },
        /* [43] 5.3125 <= y <= 5.4375, degree 10, 64.0 bits */
        {
         22.916545918525774, 1.3500837271480013e-15, 7.161805835890835, 0.34457557588147131,
         -0.02651942775211651, 0.003504576772578418, -0.00065098883699723467, 0.00016007553246568653,
         -5.0737119549734457e-05, 1.9880314982364057e-05, -8.8269124448927744e-06, 3.9471474012835394e-06
        },
        /* [44] 5.4375 <= y <= 5.5625, degree 10, 62.1 bits */
        {
         23.81710468195848, -2.7361443949923791e-16, 7.2467332445545161, 0.334947185601498,
         -0.024863005603870576, 0.0031320668828678029, -0.00054564927160054755, 0.00012311388803788829,
         -3.5006024852946175e-05, 1.2283385320168565e-05, -5.0606232481309588e-06, 2.22619952770704e-06
        },
        /* [45] 5.5625 <= y <= 5.6875, degree 10, 60.9 bits */
        {
         24.728132075211516, -4.1674350668388546e-17, 7.329328412416328, 0.32590696221109328,
         -0.023377700356950127, 0.0028176900528766873, -0.00046359655768417459, 9.7130620610671483e-05,
         -2.5111396545390248e-05, 7.8974951431242005e-06, -2.956020277672204e-06, 1.2355556653195615e-06
        },
        /* [46] 5.6875 <= y <= 5.8125, degree 10, 62.6 bits */
        {
         25.649345437600861, 7.0154972168638975e-16, 7.409730787697872, 0.31739576880524706,
         -0.02203770008598633, 0.0025491151242425132, -0.00039820662944554453, 7.8185647760709801e-05,
         -1.8622549252885597e-05, 5.2977847146386854e-06, -1.7863518990427945e-06, 6.9049496536993311e-07
        },
        /* [47] 5.8125 <= y <= 5.9375, degree 10, 60.2 bits */
        {
         26.580478663047632, 2.3479245302733066e-16, 7.4880661554157291, 0.30936310826942576,
         -0.020822458792023664, 0.0023173719061896237, -0.00034514850253258302, 6.3947761483389829e-05,
         -1.4186951750830858e-05, 3.6963051003712346e-06, -1.1258945100457589e-06, 3.9597747417559805e-07
        },
        /* [48] 5.9375 <= y <= 6.0625, degree 10, 61.0 bits */
        {
         27.521280617645399, -6.8122077304249778e-16, 7.5644485742152483, 0.30176542412515378,
         -0.019715319581615598, 0.0021157311771295281, -0.00030147029113844563, 5.298513155751283e-05,
         -1.1041539770223181e-05, 2.6662398045732613e-06, -7.4072882520925929e-07, 2.3601918111030398e-07
        },
        /* [49] 6.0625 <= y <= 6.1875, degree 10, 60.6 bits */
        {
         28.471513775223503, -1.5719213421254633e-15, 7.6389819452020609, 0.29456482822212654,
         -0.018702579011280963, 0.001939018739356913, -0.00026508391461809344, 4.4379865813285138e-05,
         -8.7423730250398074e-06, 1.9757444823996066e-06, -5.0652753601301623e-07, 1.4698434584310485e-07
        },
        /* [50] 6.1875 <= y <= 6.3125, degree 10, 60.2 bits */
        {
         29.430953030808869, -1.5625148133618421e-15, 7.7117613017616025, 0.28772812380342844,
         -0.017772826895348034, 0.0017831771302929359, -0.00023446602674192954, 3.7518555712897224e-05,
         -7.0203760624917309e-06, 1.4960062778581036e-06, -3.5774327602494469e-07, 9.5503042200959717e-08
        },
        /* [51] 6.3125 <= y <= 6.4375, degree 10, 60.9 bits */
        {
         30.39938466124147, 9.7511134398926066e-16, 7.7828738829975688, 0.28122604021086395,
         -0.016916465619569016, 0.0016449736306856848, -0.00020847735487317161, 3.19761023620272e-05,
         -5.7051718761512895e-06, 1.1527748420021343e-06, -2.5934145611567435e-07, 6.4392442006261599e-08
        },
        /* [52] 6.4375 <= y <= 6.5625, degree 10, 62.1 bits */
        {
         31.37660540888454, 4.1747904222496932e-16, 7.8524000362988167, 0.27503262362062664,
         -0.016125351184135488, 0.0015217984339535948, -0.00018624870996581226, 2.7448962776789146e-05,
         -4.6844042614626279e-06, 9.0134088335046859e-07, -1.9200642739112487e-07, 4.4760019624037337e-08
        },
        /* [53] 6.5625 <= y <= 6.6875, degree 10, 60.2 bits */
        {
         32.362421669290924, -1.6420749259284948e-15, 7.920413982967407, 0.26912474547175103,
         -0.015392519649513854, 0.0014115208179287799, -0.00016710605197655672, 2.3715105640782616e-05,
         -3.8813681327108561e-06, 7.1358633602167729e-07, -1.4463552771825896e-07, 3.1889046377510028e-08
        },
        /* [54] 6.6875 <= y <= 6.8125, degree 10, 63.2 bits */
        {
         33.356648767393466, -2.4387782801569696e-15, 7.9869844727376522, 0.2634817013234681,
         -0.01471197518090882, 0.0013123840990109075, -0.00015051946279893269, 2.0608918476745343e-05,
         -3.2421967426790031e-06, 5.7112962767187842e-07, -1.1055426006945469e-07, 2.3179687974188282e-08
        },
        /* [55] 6.8125 <= y <= 6.9375, degree 10, 63.4 bits */
        {
         34.359110309632214, -1.5898775701271109e-15, 8.0521753471822599, 0.25808488026010779,
         -0.014078523523988142, 0.0012229273688555984, -0.00013606738235309878, 1.8004854293965405e-05,
         -2.7281876896695869e-06, 4.6156035938948755e-07, -8.5578238332909244e-08, 1.7133249636331455e-08
        },
        /* [56] 6.9375 <= y <= 7.0625, degree 10, 65.1 bits */
        {
         35.369637601649018, -1.8217587241370998e-15, 8.1160460277049431, 0.25291749004859121,
         -0.013487639603249965, 0.0011419262176273, -0.0001234109509894855, 1.5806417374415415e-05,
         -2.311007926766457e-06, 3.7627735119444595e-07, -6.6988101921934813e-08, 1.2846736185042547e-08
        },
        /* [57] 7.0625 <= y <= 7.1875, degree 10, 61.2 bits */
        {
         36.38806912293164, -3.0383737495640749e-15, 8.1786519405950617, 0.24796432685298875,
         -0.012935361142427746, 0.001068347206193674, -0.00011227524767653318, 1.3938543909685509e-05,
         -1.9695860166839141e-06, 3.0919092187370118e-07, -5.2963663051070308e-08, 9.7543358771568966e-09
        },
        /* [58] 7.1875 <= y <= 7.3125, degree 10, 59.9 bits */
        {
         37.414250051188702, 6.8671272562701322e-17, 8.2400448891633413, 0.24321158091359488,
         -0.01241820239039124, 0.0010013124709125961, -0.00010243534933742332, 1.2342215117584207e-05,
         -1.6880363441949646e-06, 2.5591232744372418e-07, -4.2257011160633875e-08, 7.4897514061136354e-09
        },
        /* [59] 7.3125 <= y <= 7.4375, degree 10, 60.1 bits */
        {
         38.448031830365615, 1.9148747056416396e-15, 8.3002733810810252, 0.2386466715142895,
         -0.01193308356040098, 0.00094007190798362189, -9.3705828807815007e-05, 1.0970579310619701e-05,
         -1.4542382532270406e-06, 2.1323033170284038e-07, -3.3995488540353959e-08, 5.8094570807513899e-09
        },
        /* [60] 7.4375 <= y <= 7.5625, degree 10, 59.5 bits */
        {
         39.489271777130561, 2.0761129537057593e-15, 8.3593829175632219, 0.2342581059942358,
         -0.01147727267641907, 0.00088398110156931128, -8.593274675867416e-05, 9.78611696435431e-06,
         -1.2588436838560954e-06, 1.7876388487954266e-07, -2.7558551688005778e-08, 4.547980155281721e-09
        },
        /* [61] 7.5625 <= y <= 7.6875, degree 10, 59.6 bits */
        {
         40.537832721413913, -2.8244753479492225e-15, 8.417416249868003, 0.23003535864460023,
         -0.011048337306913649, 0.00083248365486892327, -7.8987478719961859e-05, 8.7585402530188824e-06,
         -1.094572209917732e-06, 1.5072647477456319e-07, -2.2498479650011235e-08, 3.5908094422708464e-09
        },
        /* [62] 7.6875 <= y <= 7.8125, degree 10, 62.1 bits */
        {
         41.593582677207898, 3.1884772660508138e-15, 8.474413607651254, 0.22596876616193523,
         -0.010644104245003318, 0.00078509693145383159, -7.2761909667073415e-05, 7.8632180602932862e-06,
         -9.5570282727277997e-07, 1.2776324454801231e-07, -1.8488056871805585e-08, 2.8574436112915678e-09
        },
        /* [63] 7.8125 <= y <= 7.9375, degree 10, 60.9 bits */
        {
         42.656394540352572, -1.444315381048608e-15, 8.5304129029690952, 0.22204943697315549,
         -0.01026262562453089, 0.00074140046299395787, -6.7164659420750463e-05, 7.0799821933930293e-06,
         -8.3770278639920248e-07, 1.0883659701298466e-07, -1.5285348867192523e-08, 2.2905001790813443e-09
        },
        /* [64] 7.9375 <= y <= 8.0625, degree 10, 65.6 bits */
        {
         43.726145810468623, 2.1819388270974134e-15, 8.5854499131136635, 0.21826917224978773,
         -0.0099021502861381498, 0.00070102645986056726, -6.2118093104636973e-05, 6.3922135807784767e-06,
         -7.3695332542756347e-07, 9.314471791295503e-08, -1.2709574625948478e-08, 1.8485642760687124e-09
        }
    };
    return row[i];
}

/* duration at zero force, beta < 8: 46 rows of degree 10 in y = sqrt(beta), nodes 0 + i 0.0625, 0 <= y <= 2.84375.
 * Relative error of the approximation: 2^-60.3 at most, proved for the whole cell of each row. */
#define COR_ROWS_DURATION_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_DURATION_ZERO_FORCE_STEP 0.0625
#define COR_ROWS_DURATION_ZERO_FORCE_PER_UNIT 16.0
#define COR_ROWS_DURATION_ZERO_FORCE_ROWS 46
#define COR_ROWS_DURATION_ZERO_FORCE_END 8.0
COR_INLINE const double *cor_rows_duration_zero_force(int i)
{
    static const double row[46][12] = {
        /* [0] 0 <= y <= 0.03125, degree 10, 65.8 bits */
        {
         3.218065459719043, 7.5689901147700083e-17, 5.3914346637810789e-23, -0.62881260702111796,
         3.3865231093463088e-16, 0.20971797419900498, 2.8742549294567634e-11, 0.0058007749322424298,
         -0.11428546595030235, 0.027051202485065672, 0.066211049403622171, -0.01206811593511054
        },
        /* [1] 0.03125 <= y <= 0.09375, degree 10, 63.8 bits */
        {
         3.2156123604424551, 4.5680165036025014e-17, -0.078396786716612224, -0.62389824922436077,
         0.052398553296165294, 0.20911799632094241, -0.0067056175956222734, -0.039924796313236519,
         -0.091857032679392478, 0.061591793240011912, 0.054451963121535961, -0.029761403401054046
        },
        /* [2] 0.09375 <= y <= 0.15625, degree 10, 63.4 bits */
        {
         3.2082914331378123, -9.5755034897361291e-17, -0.1555665819600647, -0.60919955651028423,
         0.10417565967530459, 0.20397016057071599, -0.028273752096932, -0.072367906466100196,
         -0.054437768169556956, 0.085658469065286014, 0.02866231840584274, -0.051628138424286915
        },
        /* [3] 0.15625 <= y <= 0.21875, degree 10, 64.4 bits */
        {
         3.1962173503861102, 8.4702809978753831e-17, -0.23029911971864608, -0.58497260508191118,
         0.1536860190148967, 0.19052340915696392, -0.058664012305552689, -0.086401588278559205,
         -0.0091876571104178763, 0.091948350528884989, -0.0072748697519277594, -0.060284416888402768
        },
        /* [4] 0.21875 <= y <= 0.28125, degree 10, 62.1 bits */
        {
         3.179578973213065, -1.5566442771487599e-16, -0.3014386005217044, -0.55185411470695545,
         0.19860336617421903, 0.16714639260712211, -0.090589506254773161, -0.080703949077985684,
         0.034035151964689876, 0.077634086574446232, -0.042275605160633611, -0.048258827319202266
        },
        /* [5] 0.28125 <= y <= 0.34375, degree 10, 62.0 bits */
        {
         3.1586343270873694, -1.7488122752545814e-16, -0.3679371095673924, -0.51093732239154721,
         0.23647934003602603, 0.13447652416361588, -0.11709219923676674, -0.058329891347429573,
         0.065665215817670583, 0.046835514372384389, -0.063989156788554297, -0.019334559840448989
        },
        /* [6] 0.34375 <= y <= 0.40625, degree 10, 67.4 bits */
        {
         3.1337020800966311, -5.2492557074206424e-18, -0.42891094640497218, -0.46374348838538293,
         0.26527698573143516, 0.095070690357300383, -0.13306552228338137, -0.025833738769608178,
         0.07974835276311347, 0.0093496531375349308, -0.06561292483966763, 0.013529767645489153
        },
        /* [7] 0.40625 <= y <= 0.46875, degree 10, 64.3 bits */
        {
         3.1051497353548592, 6.9829555697144977e-17, -0.4836875918041072, -0.41210501002602834,
         0.28376341326652638, 0.052657773477020692, -0.13620544262459053, 0.008792439117745611,
         0.075780120780188434, -0.023664393556762725, -0.049202393235508637, 0.036504834611047726
        },
        /* [8] 0.46875 <= y <= 0.53125, degree 10, 64.3 bits */
        {
         3.0733794282471623, -1.4221986541856131e-16, -0.53183425247608618, -0.35799425190177048,
         0.29168924099079152, 0.011225575934235487, -0.12710088186451723, 0.038472775487667012,
         0.058176952753145238, -0.044321358446633367, -0.023554145653250848, 0.042748793188948239
        },
        /* [9] 0.53125 <= y <= 0.59375, degree 10, 60.8 bits */
        {
         3.0388126381896243, -1.8850176632949116e-16, -0.57316379216991864, -0.30333983051152164,
         0.28974721599138104, -0.02579170874468989, -0.10854236475921114, 0.05872902595677628,
         0.033924041733139357, -0.050360201539618753, 0.0011426531310399408, 0.034419885841160146
        },
        /* [10] 0.59375 <= y <= 0.65625, degree 10, 61.1 bits */
        {
         3.0018752255833854, 1.5166745571219952e-16, -0.6077189154264393, -0.24986767882919439,
         0.27936156392572653, -0.056033407405766927, -0.084414670732827421, 0.068188267535210997,
         0.0098148112083863322, -0.044493671265294236, 0.017988209582969556, 0.019007159876318663
        },
        /* [11] 0.65625 <= y <= 0.71875, degree 10, 60.8 bits */
        {
         2.9629840198403961, 1.9271179702025893e-16, -0.63573937441976003, -0.19899102712253777,
         0.2623916779019112, -0.078378866130517227, -0.058608645407361958, 0.068036459944200489,
         -0.0094541041577161679, -0.031926855152064136, 0.025023361539568453, 0.0040589778692503792
        },
        /* [12] 0.71875 <= y <= 0.78125, degree 10, 60.5 bits */
        {
         2.9225358128605601, -5.2313646187645633e-17, -0.65761897921629175, -0.15175734662759494,
         0.24083314293158561, -0.092819401992732573, -0.034258327454885336, 0.060927601813687775,
         -0.021860793055029467, -0.017794108640661586, 0.024099462841599903, -0.006059405170484998
        },
        /* [13] 0.78125 <= y <= 0.84375, degree 10, 61.5 bits */
        {
         2.8808991762416829, 1.047175615112005e-16, -0.67385930277247397, -0.10884674467870153,
         0.21657506703374635, -0.10015814656328582, -0.013402360191971054, 0.049888519261914815,
         -0.027587893431723947, -0.0056320129884660664, 0.018649960877667324, -0.010517966718605309
        },
        /* [14] 0.84375 <= y <= 0.90625, degree 10, 62.6 bits */
        {
         2.8384091237904743, -1.8875526130886172e-17, -0.68502571617592822, -0.0706082377168369,
         0.19124065129054846, -0.10166287340326252, 0.0029990464484437756, 0.037550826723474491,
         -0.028097598714112753, 0.0029520689226967367, 0.011857389496064527, -0.010673017139411201
        },
        /* [15] 0.90625 <= y <= 0.96875, degree 10, 61.6 bits */
        {
         2.7953643464551838, 2.9006703059287459e-17, -0.69170949259333669, -0.037117978911149985,
         0.16611064341655785, -0.098761072854246845, 0.014836371710518929, 0.025790920830953891,
         -0.025255122507381961, 0.0078473647766598362, 0.0057916281959515068, -0.0085089706321958055
        },
        /* [16] 0.96875 <= y <= 1.03125, degree 10, 64.1 bits */
        {
         2.7520265740390495, 1.7426961214585166e-16, -0.69449780800520478, -0.0082453132336911001,
         0.14211280991143652, -0.092820347791880767, 0.02255272945260331, 0.015693211264503924,
         -0.02074711754694256, 0.0097690213376095385, 0.0013591627696436703, -0.0056630307700395116
        },
        /* [17] 1.03125 <= y <= 1.09375, degree 10, 61.0 bits */
        {
         2.7086215543363772, 4.9308001243251538e-17, -0.69395193046835979, 0.016283614911945309,
         0.11985476191489836, -0.08501984753395575, 0.026870676806450684, 0.0076961217183833764,
         -0.015818785569637641, 0.0096908923600693732, -0.001351916977401149, -0.0031066696322705409
        },
        /* [18] 1.09375 <= y <= 1.15625, degree 10, 60.8 bits */
        {
         2.6653411566973215, -2.0675717735097155e-16, -0.69059287001509284, 0.036830792991004654,
         0.099679075898443825, -0.07629683404232393, 0.028588306321711176, 0.0017988758223629431,
         -0.011240113199078555, 0.0085013103637522763, -0.0026687097204742371, -0.0012283777070877311
        },
        /* [19] 1.15625 <= y <= 1.21875, degree 10, 61.3 bits */
        {
         2.6223461714523131, 1.6063090741777189e-16, -0.68489322838173849, 0.053802408784671567,
         0.081724818973956836, -0.067344885023533752, 0.028451694341275337, -0.0022467119003841607,
         -0.0073913359753948454, 0.0068602577948841731, -0.0030354834104416167, -5.1805537805759104e-05
        },
        /* [20] 1.21875 <= y <= 1.28125, degree 10, 61.5 bits */
        {
         2.5797694620585108, 1.4962390690169534e-16, -0.67727382610017639, 0.067616227527184158,
         0.065985425544212398, -0.05864156894995997, 0.027090827459952452, -0.0047920536138882979,
         -0.0043843781620951337, 0.0051854927499998078, -0.0028508655206943897, 0.00056540972544560355
        },
        /* [21] 1.28125 <= y <= 1.34375, degree 10, 60.9 bits */
        {
         2.5377192142747611, 2.1106631932991677e-16, -0.66810376034575591, 0.078679046417351489,
         0.052357791473058191, -0.050488730224216655, 0.02499971321533782, -0.0061995146942351014,
         -0.0021737134974238277, 0.0036990729998309696, -0.0024079437418607209, 0.00080354383668128002
        },
        /* [22] 1.34375 <= y <= 1.40625, degree 10, 60.4 bits */
        {
         2.4962821050100623, 1.434380400704792e-16, -0.65770274602415746, 0.087372380529442475,
         0.040680914116574984, -0.043054475012435353, 0.022542722150894614, -0.0067926944189343162,
         -0.0006388063937168496, 0.0024890493383511315, -0.0018928839743890459, 0.00081847650160480083
        },
        /* [23] 1.40625 <= y <= 1.46875, degree 10, 61.3 bits */
        {
         2.4555262777413533, -3.5764837249839744e-17, -0.64634483357252548, 0.094044435001820095,
         0.030764485650404357, -0.036410901041516563, 0.0199736447433718, -0.0068361691686725451,
         0.00036300602701371925, 0.0015637635926586194, -0.0014078340489637707, 0.00072231868789954061
        },
        /* [24] 1.46875 <= y <= 1.53125, degree 10, 61.2 bits */
        {
         2.4155040606343734, -1.8373178744849211e-17, -0.63426283045512899, 0.099006604372730969,
         0.022408871804726241, -0.030565082015977418, 0.017458701264339169, -0.0065329485736878041,
         0.00096717853594160746, 0.00089134615152625747, -0.0009982466410308464, 0.00058570526695776552
        },
        /* [25] 1.53125 <= y <= 1.59375, degree 10, 62.9 bits */
        {
         2.3762543990734049, 2.0192589983391989e-16, -0.6216529546155195, 0.10253304796507777,
         0.015418242046205014, -0.025482924118003798, 0.015098587581730076, -0.0060309923785958211,
         0.0012886709201401479, 0.0004248362060339405, -0.00067582379641870506, 0.00044784368148546952
        },
        /* [26] 1.59375 <= y <= 1.65625, degree 10, 63.0 bits */
        {
         2.3378049985537848, -1.5352375927184028e-16, -0.60867940879380533, 0.10486222014760779,
         0.009608559113738575, -0.021106604373963771, 0.012947289019687305, -0.0054332298576867596,
         0.0014183031025357929, 0.00011626369039561798, -0.0004347593975904154, 0.00032716844251070497
        },
        /* [27] 1.65625 <= y <= 1.71875, degree 10, 60.7 bits */
        {
         2.3001741893589829, -2.0298865930101783e-16, -0.59547868558664163, 0.10619953350978964,
         0.0048118936849122253, -0.017366734689496455, 0.011027001748535626, -0.0048079335578790384,
         0.0014241675095764794, -7.6634716833655624e-05, -0.00026193099376223766, 0.00022983228462484904
        },
        /* [28] 1.71875 <= y <= 1.78125, degree 10, 60.3 bits */
        {
         2.2633725334558576, 5.078229277713784e-17, -0.58216349984698224, 0.10672058003510526,
         0.00087823131305435429, -0.014190452666819342, 0.0093393540556365538, -0.0041979239016670545,
         0.0013551966259666589, -0.00018809211946531061, -0.00014262314589480319, 0.00015553796776848235
        },
        /* [29] 1.78125 <= y <= 1.84375, degree 10, 61.0 bits */
        {
         2.2274041985254902, 5.6072541324353484e-17, -0.56882630435832249, 0.10657452681004125,
         -0.0023243479502721128, -0.011506512759034115, 0.0078734906230883018, -0.0036280589292149467,
         0.0012452417831938804, -0.00024431745394573048, -6.3335585240316742e-05, 0.00010113709426344344
        },
        /* [30] 1.84375 <= y <= 1.90625, degree 10, 63.7 bits */
        {
         2.1922681255023124, -1.3153367267344102e-16, -0.55554238333657679, 0.10588744419244445,
         -0.0049104813348024813, -0.009248255388189932, 0.0066116780625360876, -0.0031109873168295083,
         0.0011168472921286232, -0.0002645475694228052, -1.2870569328274344e-05, 6.2641734146196511e-05
        },
        /* [31] 1.90625 <= y <= 1.96875, degree 10, 60.4 bits */
        {
         2.1579590155315498, 1.9029618737347456e-17, -0.54237254192719087, 0.10476542462484058,
         -0.0069788845805012637, -0.0073551304058568955, 0.0055330466341118982, -0.0026513818066771426,
         0.00098439664134923849, -0.00026242162307202018, 1.7496378325514454e-05, 3.6234723002207649e-05
        },
        /* [32] 1.96875 <= y <= 2.03125, degree 10, 61.5 bits */
        {
         2.1244681606637106, 4.372183948999096e-17, -0.52936542302772838, 0.10329741873802471,
         -0.0086139669353681274, -0.0057732739120002572, 0.0046159836141494064, -0.002248947189769738,
         0.00085657211477440352, -0.0002473136084554833, 3.4270529445721601e-05, 1.8667642559602151e-05
        },
        /* [33] 2.03125 <= y <= 2.09375, degree 10, 61.6 bits */
        {
         2.0917841404252142, -1.2118714252272772e-16, -0.51655948892018777, 0.10155776032515426,
         -0.0098875103106010331, -0.0044554937663868963, 0.0038395827907521892, -0.0019004916418233092,
         0.00073819336558480478, -0.00022547028536297223, 4.2141326273531076e-05, 7.3756533864083491e-06
        },
        /* [34] 2.09375 <= y <= 2.15625, degree 10, 61.2 bits */
        {
         2.0598934039917176, -1.2438430555527342e-16, -0.50398470684553998, 0.099608379913519007,
         -0.010860297383444607, -0.00336090895545278, 0.0031844532646923859, -0.0016013096582402951,
         0.00063154540531109107, -0.00020091487218329429, 4.4395286974871449e-05, 4.2117224930182644e-07
        },
        /* [35] 2.15625 <= y <= 2.21875, degree 10, 61.0 bits */
        {
         2.0287807552685089, 2.0942956885068783e-16, -0.49166397655462174, 0.097500723202591441,
         -0.011583624037580812, -0.0024544068090465803, 0.0026331070103356091, -0.0013460745704068824,
         0.0005373108528609013, -0.00017613119609220874, 4.3277591276447962e-05, -3.6094709323490991e-06
        },
        /* [36] 2.21875 <= y <= 2.28125, degree 10, 61.8 bits */
        {
         1.9984297558822228, -6.1320576554077059e-17, -0.47961433522329128, 0.095277399400475207,
         -0.012100664863496707, -0.0017060241229074689, 0.002170079532210109, -0.0011293909639218268,
         0.00045520775466380438, -0.00015256386912426643, 4.0283618306068848e-05, -5.7201879557016214e-06
        },
        /* [37] 2.28125 <= y <= 2.34375, degree 10, 61.9 bits */
        {
         1.9688230589803233, -2.6801754601489627e-17, -0.46784797171681702, 0.092973588214086508,
         -0.012447681608349748, -0.0010903179947308343, 0.0017818893808834448, -0.00094611714021766182,
         0.00038441502165810054, -0.00013097407010746173, 3.6382120679788962e-05, -6.6077217372063294e-06
        },
        /* [38] 2.34375 <= y <= 2.40625, degree 10, 61.0 bits */
        {
         1.9399426848496348, -7.6858346710546236e-17, -0.45637307853236309, 0.090618234836327194,
         -0.012655077281500936, -0.00058576492489120259, 0.0014569071856589649, -0.00079153610505384206,
         0.00032384847465992888, -0.00011168681071771762, 3.2179982139959019e-05, -6.7449968804944041e-06
        },
        /* [39] 2.40625 <= y <= 2.46875, degree 10, 60.9 bits */
        {
         1.9117702477080678, -7.2155389581154366e-17, -0.44519456614492497, 0.088235061018303515,
         -0.012748305851036834, -0.00017420874985119006, 0.0011851801276125588, -0.00066142971070234262,
         0.0002723341010942913, -9.4759167524845672e-05, 2.80405552315006e-05, -6.4486182902827418e-06
        },
        /* [40] 2.46875 <= y <= 2.53125, degree 10, 61.9 bits */
        {
         1.8842871415853844, 1.5142912182948039e-17, -0.43431466110436406, 0.085843418070209537,
         -0.01274865105807974, 0.00015963354218611632, 0.00095824073418603907, -0.00055209317008368154,
         0.00022871205492096448, -8.0092377994032916e-05, 2.4166844577527867e-05, -5.9219091043989085e-06
        },
        /* [41] 2.53125 <= y <= 2.59375, degree 10, 62.1 bits */
        {
         1.8574746919721516, 1.7212956897904362e-17, -0.42373340616609106, 0.08345900494874757,
         -0.012673889174890554, 0.00042860617185979587, 0.00076891737860923016, -0.00046031477100782684,
         0.00019189499354299664, -6.7504814081112779e-05, 2.0658818936171576e-05, -5.2950134514764483e-06
        },
        /* [42] 2.59375 <= y <= 2.65625, degree 10, 62.8 bits */
        {
         1.8313142788601982, -3.9116194318463834e-18, -0.4134490780176574, 0.081094471800779139,
         -0.012538850448611449, 0.00064349132591653708, 0.00061115627628569296, -0.0003833369806522576,
         0.00016089703649767331, -5.6778244949585312e-05, 1.7552260798847081e-05, -4.6470862771362622e-06
        },
        /* [43] 2.65625 <= y <= 2.71875, degree 10, 61.2 bits */
        {
         1.8057874359012613, -8.6189875474242616e-17, -0.40345853578722951, 0.078759926641354006,
         -0.012355893105859855, 0.00081333276979244306, 0.0004798598791095811, -0.00031880921795856561,
         0.00013484438906777511, -4.7686134349079276e-05, 1.4844612106246163e-05, -4.0240017220113757e-06
        },
        /* [44] 2.71875 <= y <= 2.78125, degree 10, 62.1 bits */
        {
         1.780875929652129, 5.3775886955370711e-18, -0.39375751146807836, 0.076463360356980675,
         -0.01213530253201118, 0.00094571178911211703, 0.00037074351047117915, -0.00026473859496990812,
         0.0001129749881427352, -4.0010091575219567e-05, 1.2511853264684212e-05, -3.4501494738743803e-06
        },
        /* [45] 2.78125 <= y <= 2.84375, degree 10, 63.5 bits */
        {
         1.7565618222350412, 1.9115435606168009e-17, -0.38434085163672482, 0.07421100299139026,
         -0.011885626825769329, 0.0010469811971657488, 0.00028021024805685016, -0.00021944230162471018,
         9.4631979694477584e-05, -3.3548664416030235e-05, 1.0519278764674239e-05, -2.9363890108640313e-06
        }
    };
    return row[i];
}

/* largest overlap, beta < 8: 65 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 8.0625.
 * Relative error of the approximation: 2^-58.1 at most, proved for the whole cell of each row. */
#define COR_ROWS_MAX_OVERLAP_FIRST 0.0
#define COR_ROWS_MAX_OVERLAP_STEP 0.125
#define COR_ROWS_MAX_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_MAX_OVERLAP_ROWS 65
#define COR_ROWS_MAX_OVERLAP_END 8.0
COR_INLINE const double *cor_rows_max_overlap(int i)
{
    static const double row[65][12] = {
        /* [0] 0 <= y <= 0.0625, degree 10, 58.1 bits */
        {
         1.0933620739432781, -5.5784856447565325e-17, -0.50445489426982837, 0.2840430189018544,
         -0.17022077849725181, 0.10550070905146688, -0.066848713584245031, 0.043039475594734894,
         -0.02805046788300845, 0.018446817390623246, -0.012051515494730856, 0.0066518137868725232
        },
        /* [1] 0.0625 <= y <= 0.1875, degree 10, 58.9 bits */
        {
         1.0344347906430595, -1.0891199505058068e-16, -0.44067342054822861, 0.22893669925358956,
         -0.12644595506924988, 0.072164277398013413, -0.042076474372973911, 0.024915386607083045,
         -0.014928915568325218, 0.0090297096698370178, -0.0055241468733074582, 0.0033888513403180949
        },
        /* [2] 0.1875 <= y <= 0.3125, degree 10, 61.3 bits */
        {
         0.98269720683015949, 3.4912727450449951e-17, -0.38884978412334947, 0.1875456145935159,
         -0.096078732461229027, 0.050821053695657377, -0.02744745665294962, 0.015047788301548331,
         -0.0083448922676363068, 0.0046701429296785307, -0.0026415188072642362, 0.0014987289761073629
        },
        /* [3] 0.3125 <= y <= 0.4375, degree 10, 59.7 bits */
        {
         0.93684535380596878, -1.0246962480588107e-17, -0.34610098776834691, 0.15579469652272135,
         -0.074433157872359351, 0.03669352801645847, -0.018459842622045673, 0.0094232684284522826,
         -0.0048642234456984833, 0.002533233645918198, -0.0013325257964843383, 0.00070328565419573567
        },
        /* [4] 0.4375 <= y <= 0.5625, degree 10, 60.3 bits */
        {
         0.89588007400697034, -1.0969786215205918e-17, -0.3103756291506144, 0.13099337797960031,
         -0.05864027214594094, 0.027070880253347241, -0.012747468915482844, 0.0060886674300326639,
         -0.0029399056050076798, 0.0014318350660328563, -0.00070397773385776335, 0.00034734539183279873
        },
        /* [5] 0.5625 <= y <= 0.6875, degree 10, 59.1 bits */
        {
         0.85902160209726541, -4.6605005577913928e-17, -0.28017907556205157, 0.11131275195908047,
         -0.046881666561960134, 0.02035179537541076, -0.0090082320445583914, 0.0040430662976170739,
         -0.0018339235809686643, 0.00083889527878607093, -0.00038720590453043059, 0.00017937938733559293
        },
        /* [6] 0.6875 <= y <= 0.8125, degree 10, 58.6 bits */
        {
         0.82565162203285403, -6.7129686822689441e-18, -0.25439976932617969, 0.095477880046099708,
         -0.037969724280683716, 0.015556860148015399, -0.0064965780052359482, 0.0027501317496293892,
         -0.0011762995596307998, 0.00050728737048469233, -0.00022066126353937306, 9.6347020034043168e-05
        },
        /* [7] 0.8125 <= y <= 0.9375, degree 10, 62.5 bits */
        {
         0.79527294288549566, 7.9516145723751638e-18, -0.2321960485861809, 0.082580170863963021,
         -0.031108207410085412, 0.012068543299884731, -0.004770571917695185, 0.0019110672342725814,
         -0.00077336165133458053, 0.00031548844905175894, -0.00012976876810881117, 5.3583226372663153e-05
        },
        /* [8] 0.9375 <= y <= 1.0625, degree 10, 60.5 bits */
        {
         0.7674808015390393, 4.2254368976091011e-18, -0.21292041063642894, 0.071959378308789831,
         -0.025750794370227478, 0.0094869087780629149, -0.0035601341907906181, 0.0013536062368500776,
         -0.00051979609157184884, 0.0002011854094732676, -7.8489873302543765e-05, 3.0741527193865883e-05
        },
        /* [9] 1.0625 <= y <= 1.1875, degree 10, 59.6 bits */
        {
         0.74194203339564591, 3.3758723949539174e-17, -0.1960676292372085, 0.063127338400804825,
         -0.021514856970343218, 0.0075467031009848924, -0.0026956774790180865, 0.00097536394097306035,
         -0.000356369695278709, 0.00013121750765908877, -4.8687680764590217e-05, 1.8136636732923122e-05
        },
        /* [10] 1.1875 <= y <= 1.3125, degree 10, 61.0 bits */
        {
         0.71837968694801368, 4.7206075912349517e-17, -0.18123846600731369, 0.055717477231693083,
         -0.01812744038262969, 0.0060682134165603871, -0.002068103922623939, 0.0007138122786229565,
         -0.00024874703323812981, 8.7342941938782417e-05, -3.0897907868745031e-05, 1.0973646871960527e-05
        },
        /* [11] 1.3125 <= y <= 1.4375, degree 10, 61.1 bits */
        {
         0.69656148011509234, -5.1574822477732915e-17, -0.16811381271285325, 0.049450652912902807,
         -0.015390577175041205, 0.0049273262364795513, -0.0016056831456312747, 0.00052981949079055767,
         -0.00017647810856314042, 5.922338803639044e-05, -2.001855162614019e-05, 6.7935813972196397e-06
        },
        /* [12] 1.4375 <= y <= 1.5625, degree 10, 61.8 bits */
        {
         0.67629101615598752, -2.5574937570538001e-19, -0.15643595559987269, 0.044111595465286639,
         -0.013158518795474436, 0.004036827099458031, -0.0012603145918196133, 0.00039834861697283499,
         -0.00012708086347910981, 4.0839835297596607e-05, -1.3217201318308147e-05, 4.2946181755034958e-06
        },
        /* [13] 1.5625 <= y <= 1.6875, degree 10, 61.5 bits */
        {
         0.65740101370619042, -3.717905149881858e-17, -0.14599479336493654, 0.03953236943863208,
         -0.011322489008076118, 0.0033344566706544872, -0.00099916016901322466, 0.00030305576923648087,
         -9.2765126294642167e-05, 2.8601249509693938e-05, -8.8789067804283702e-06, 2.7673478549507592e-06
        },
        /* [14] 1.6875 <= y <= 1.8125, degree 10, 63.8 bits */
        {
         0.63974802826956845, -1.6483397350183851e-17, -0.1366175587941173, 0.035580579809224938,
         -0.0098002878173540451, 0.0027751256613593391, -0.00079943168317858908, 0.00023307443756783979,
         -6.8569197107558045e-05, 2.0316830338581512e-05, -6.0601921614053585e-06, 1.8148671869251808e-06
        },
        /* [15] 1.8125 <= y <= 1.9375, degree 10, 59.3 bits */
        {
         0.62320829277445378, -3.1341914901419648e-18, -0.12816105661218125, 0.032150837679380123,
         -0.0085290847559206205, 0.0023257456326635667, -0.00064507619058148903, 0.00018105743263806124,
         -5.1273502263695832e-05, 1.462242700262744e-05, -4.1974427155994154e-06, 1.2096919567031281e-06
        },
        /* [16] 1.9375 <= y <= 2.0625, degree 10, 61.1 bits */
        {
         0.60767440795790839, 2.1564332975598794e-17, -0.12050573376196404, 0.029158502090087253,
         -0.0074603469550974799, 0.0019617380081711883, -0.00052462820975340677, 0.00014195971233620433,
         -3.8752830822170567e-05, 1.0652504527450174e-05, -2.94699495067025e-06, 8.1851611814551793e-07
        },
        /* [17] 2.0625 <= y <= 2.1875, degree 10, 60.3 bits */
        {
         0.59305268529590316, -2.1306395174737039e-17, -0.11355110134216635, 0.026535034401329607,
         -0.0065562196414785034, 0.0016646394123644482, -0.0004297937579937552, 0.00011226725302956669,
         -2.9582006701387867e-05, 7.8482850016962374e-06, -2.0953011365595999e-06, 5.6160745299297152e-07
        },
        /* [18] 2.1875 <= y <= 2.3125, degree 10, 62.3 bits */
        {
         0.57926099612862025, 2.9651904668787746e-17, -0.10721216539702365, 0.02422451055190036,
         -0.0057869097740335038, 0.0014204352449554421, -0.00035450185479760576, 8.9499878677074099e-05,
         -2.2791214585247516e-05, 5.8431901775196112e-06, -1.5073233861895468e-06, 3.9036549919352024e-07
        },
        /* [19] 2.3125 <= y <= 2.4375, degree 10, 63.3 bits */
        {
         0.56622701717150847, -3.2564665144411272e-17, -0.10141661894504106, 0.022180975077926008,
         -0.0051287722019259692, 0.0012183844907037258, -0.00029425972171198423, 7.1885484881783847e-05,
         -1.7711479700065705e-05, 4.3931199222114003e-06, -1.0962715701532314e-06, 2.7464084810006485e-07
        },
        /* [20] 2.4375 <= y <= 2.5625, degree 10, 60.5 bits */
        {
         0.55388678914885081, 1.3992386854777858e-17, -0.096102614241584783, 0.020366414140921132,
         -0.0045628941828069853, 0.001050180653755276, -0.00024570839757954679, 5.814333867944899e-05,
         -1.387547162545263e-05, 3.3332594120489319e-06, -8.0551511199177905e-07, 1.9542183307560009e-07
        },
        /* [21] 2.5625 <= y <= 2.6875, degree 10, 61.9 bits */
        {
         0.54218352479561549, 3.5878406698800405e-17, -0.091216981483679113, 0.018749188644136969,
         -0.0040740376844691541, 0.00090934575019560072, -0.00020631255030268303, 4.7337903707345486e-05,
         -1.0952846471433521e-05, 2.5508760406416524e-06, -5.9757753307306944e-07, 1.4053569021756562e-07
        },
        /* [22] 2.6875 <= y <= 2.8125, degree 10, 63.6 bits */
        {
         0.53106661696545299, 2.0265736021478895e-18, -0.086713794037028807, 0.017302812734356812,
         -0.0036498414239687542, 0.00079078790265720998, -0.00017414137150258035, 3.8778943548079573e-05,
         -8.7074986367979285e-06, 1.967921213018118e-06, -4.4732852844789025e-07, 1.0207641755552775e-07
        },
        /* [23] 2.8125 <= y <= 2.9375, degree 10, 60.9 bits */
        {
         0.5204908084562393, 4.5044219265133208e-17, -0.082553204839219144, 0.016004994002731646,
         -0.0032802134388601064, 0.00069047511162247447, -0.00014771207889530488, 3.1952414002669774e-05,
         -6.9689200152666101e-06, 1.529741887596773e-06, -3.3770690579144955e-07, 7.4840042233199546e-08
        },
        /* [24] 2.9375 <= y <= 3.0625, degree 10, 63.6 bits */
        {
         0.51041549339962178, -5.3040472260335068e-17, -0.078700496649038235, 0.014836873708195322,
         -0.0029568647928191446, 0.00060519242082332112, -0.00012587696607719429, 2.6472105265441705e-05,
         -5.6127706467667752e-06, 1.1976569704123606e-06, -2.569942761146002e-07, 5.5357831989770103e-08
        },
        /* [25] 3.0625 <= y <= 3.1875, degree 10, 62.2 bits */
        {
         0.50080412635260596, -7.1420594670829411e-18, -0.075125302150025983, 0.013782421136197404,
         -0.002672948784917722, 0.00053235955371675413, -0.00010774108049134769, 2.2045438527154832e-05,
         -4.5475432536089389e-06, 9.4401320791512734e-07, -1.970534102884564e-07, 4.1290180365782846e-08
        },
        /* [26] 3.1875 <= y <= 3.3125, degree 10, 61.6 bits */
        {
         0.49162372007559063, 1.8074657516026193e-17, -0.07180095988242359, 0.012827947648020208,
         -0.0024227797078803619, 0.00046989281823182471, -9.260166919502256e-05, 1.8449028358058624e-05,
         -3.7053091342371944e-06, 7.4885300919696687e-07, -1.5217525557519273e-07, 3.1041364479087351e-08
        },
        /* [27] 3.3125 <= y <= 3.4375, degree 10, 64.4 bits */
        {
         0.48284441674327289, -1.3293579074869736e-17, -0.068703979488777114, 0.011961714348119778,
         -0.0022016120732338716, 0.00041609971014332101, -7.9903248115159329e-05, 1.5511055470849286e-05,
         -3.0352293817351483e-06, 5.9764333346534536e-07, -1.1831515288475794e-07, 2.3511503236570382e-08
        },
        /* [28] 3.4375 <= y <= 3.5625, degree 10, 60.4 bits */
        {
         0.4744391202764317, -1.9552209157057217e-17, -0.065813595465511382, 0.011173613478031121,
         -0.002005466151109333, 0.00036959787428041341, -6.9203989307124877e-05, 1.3098437058892803e-05,
         -2.4989603327981822e-06, 4.7971129214391897e-07, -9.2581079461787403e-08, 1.7934851600783556e-08
        },
        /* [29] 3.5625 <= y <= 3.6875, degree 10, 63.2 bits */
        {
         0.46638317979848137, 7.4906007267036926e-18, -0.063111392982522427, 0.010454908247761994,
         -0.0018309892418659967, 0.00032925235593597875, -6.0150379410694077e-05, 1.1107409193601907e-05,
         -2.0673700166417388e-06, 3.8715570688922469e-07, -7.2887035113166822e-08, 1.3773420891101857e-08
        },
        /* [30] 3.6875 <= y <= 3.8125, degree 10, 62.1 bits */
        {
         0.45865411605581452, 2.7187832277120851e-17, -0.060580992702958338, 0.0097980192701048498,
         -0.0016753447039666246, 0.00029412669060164149, -5.2457973054126921e-05, 9.4565579097362562e-06,
         -1.7181708556780316e-06, 3.1408260828568892e-07, -5.7715890774508177e-08, 1.0645513584193985e-08
        },
        /* [31] 3.8125 <= y <= 3.9375, degree 10, 61.5 bits */
        {
         0.45123138410407193, -2.2151449203416921e-17, -0.058207784152436569, 0.0091963483759866863,
         -0.0015361226829340032, 0.00026344453910513233, -4.5896673014075902e-05, 8.081622715611436e-06,
         -1.4341986867218458e-06, 2.5606340181030129e-07, -4.5955525414656187e-08, 8.2782890586826569e-09
        },
        /* [32] 3.9375 <= y <= 4.0625, degree 10, 61.8 bits */
        {
         0.44409616673579616, -1.8036247369742184e-17, -0.055978699232508006, 0.0086441325792688314,
         -0.0014112679119221382, 0.00023655941369894802, -4.0279397618017964e-05, 6.9315934972415266e-06,
         -1.2021517174012585e-06, 2.0974756130593883e-07, -3.6784581571793731e-08, 6.475009703137146e-09
        },
        /* [33] 4.0625 <= y <= 4.1875, degree 10, 61.1 bits */
        {
         0.43723119407105765, -2.4343241382164105e-17, -0.053882019081936537, 0.0081363224859682531,
         -0.0012990210208410069, 0.00021293065223379923, -3.5453300773742732e-05, 5.9657585694585519e-06,
         -1.0116595270991946e-06, 1.7258351547320943e-07, -2.9592102203191803e-08, 5.0927371799274825e-09
        },
        /* [34] 4.1875 <= y <= 4.3125, degree 10, 62.6 bits */
        {
         0.43062058549958637, -1.2041558856915408e-17, -0.05190720876203922, 0.0076684806213774322,
         -0.0011978705943318736, 0.00019210424711493617, -3.1292928695766019e-05, 5.1514573490839604e-06,
         -8.5459079370466058e-07, 1.426159426691612e-07, -2.3920532057268952e-08, 4.0268544421864711e-09
        },
        /* [35] 4.3125 <= y <= 4.4375, degree 10, 61.9 bits */
        {
         0.42424971078775459, -2.4667779257634188e-17, -0.050044775254777955, 0.0072366960640088311,
         -0.0011065138282027394, 0.00017369746865365519, -2.769485550553536e-05, 4.4623586895815214e-06,
         -7.2453500648525516e-07, 1.1833746644414373e-07, -1.9424968073775223e-08, 3.2002526295357266e-09
        },
        /* [36] 4.4375 <= y <= 4.5625, degree 10, 61.5 bits */
        {
         0.41810506767519934, 2.4118098713167781e-17, -0.048286145072019213, 0.0068375124906007575,
         -0.0010238240990653935, 0.0001573864706969998, -2.4573455064210794e-05, 3.8771339977464284e-06,
         -6.164119011920696e-07, 9.8579385138019035e-08, -1.584380506505758e-08, 2.5557155228920755e-09
        },
        /* [37] 4.5625 <= y <= 4.6875, degree 10, 62.6 bits */
        {
         0.41217417370643, 1.9934212343796408e-17, -0.046623558425271577, 0.0064678672984984382,
         -0.00094882411917827697, 0.00014289625281205227, -2.185755091816105e-05, 3.3784287370590688e-06,
         -5.2617530424784335e-07, 8.2430617987602226e-08, -1.2977436490942661e-08, 2.0505143066591273e-09
        },
        /* [38] 4.6875 <= y <= 4.8125, degree 10, 65.1 bits */
        {
         0.40644547039008488, 1.4623703670734747e-17, -0.045049977430973047, 0.0061250399157695631,
         -0.000880663624528202, 0.00012999249413794305, -1.9487748690586637e-05, 2.9520608393457241e-06,
         -4.5058722341150793e-07, 6.9177193177340082e-08, -1.0672692583756539e-08, 1.6525426091351907e-09
        },
        /* [39] 4.8125 <= y <= 4.9375, degree 10, 63.4 bits */
        {
         0.4009082380665358, -1.6039308213945086e-17, -0.043559006253060896, 0.005806607762017614,
         -0.00081860075865256617, 0.00011847488108656097, -1.741430170609502e-05, 2.5863926791434714e-06,
         -3.8704453719802269e-07, 5.8256792444158935e-08, -8.8113947552502026e-09, 1.3375332392335584e-09
        },
        /* [40] 4.9375 <= y <= 5.0625, degree 10, 63.7 bits */
        {
         0.39555252010435232, -6.1433801852880813e-18, -0.042144821432337311, 0.0055104086042273223,
         -0.00076198648224054771, 0.0001081716329468319, -1.5595395407046073e-05, 2.2718365509819041e-06,
         -3.3344530763703202e-07, 4.9224403563142295e-08, -7.3018838496821236e-09, 1.0870402174525273e-09
        },
        /* [41] 5.0625 <= y <= 5.1875, degree 10, 61.8 bits */
        {
         0.39036905524656973, -2.3145171178354427e-17, -0.040802110936835334, 0.0052345082775637252,
         -0.00071025147010325858, 9.8934992407815307e-05, -1.3995762306826188e-05, 2.0004633879437167e-06,
         -2.8808511526908082e-07, 4.1726218804596579e-08, -6.0727112483199786e-09, 8.8696610815823783e-10
        },
        /* [42] 5.1875 <= y <= 5.3125, degree 10, 62.9 bits */
        {
         0.38534921709583003, -8.3831848610622149e-18, -0.039526020701389025, 0.0049771729227264892,
         -0.00066289506091008876, 9.0637496692939524e-05, -1.2585559060761625e-05, 1.7656917311980664e-06,
         -2.4957626854371951e-07, 3.5479691509022327e-08, -5.0679130886142037e-09, 7.2648055547724139e-10
        },
        /* [43] 5.3125 <= y <= 5.4375, degree 10, 62.5 bits */
        {
         0.38048495986899111, 3.2479918208988813e-18, -0.038312107617699841, 0.0047368450384148416,
         -0.00061947590739216908, 8.3168882826449139e-05, -1.1339452344382642e-05, 1.5620393887998892e-06,
         -2.1678453488880493e-07, 3.0258218035825055e-08, -4.2434503940178099e-09, 5.9722131488551127e-10
        },
        /* [44] 5.4375 <= y <= 5.5625, degree 10, 60.6 bits */
        {
         0.37576876967132977, -9.5122636910094254e-18, -0.037156298096120595, 0.0045121227668183913,
         -0.00057960404026637222, 7.6433510097278508e-05, -1.0235871799273117e-05, 1.3849242983091972e-06,
         -1.8877936235225238e-07, 2.5879313056796253e-08, -3.5645129433999146e-09, 4.9270056239084146e-10
        },
        /* [45] 5.5625 <= y <= 5.6875, degree 10, 61.8 bits */
        {
         0.37119362064175054, 1.2273867043622176e-17, -0.036054851453323433, 0.0043017419273847545,
         -0.00054293411157299511, 7.0348205969587507e-05, -9.2563972132079559e-06, 1.2305041855753659e-06,
         -1.6479453952905472e-07, 2.2195437151332903e-08, -3.0034674343001436e-09, 4.0787029918568422e-10
        },
        /* [46] 5.6875 <= y <= 5.8125, degree 10, 61.5 bits */
        {
         0.36675293540650272, -5.2485573979700909e-18, -0.035004327490916448, 0.0041045603937958893,
         -0.00050915962524728246, 6.4840459965796296e-05, -8.3852539911015191e-06, 1.0955469483202392e-06,
         -1.441969706107481e-07, 1.90868492754255e-08, -2.5382830378582217e-09, 3.3874405084884128e-10
        },
        /* [47] 5.8125 <= y <= 5.9375, degree 10, 63.2 bits */
        {
         0.36244054935230247, 1.3071884248617709e-17, -0.034001557722891575, 0.0039195444745553192,
         -0.00047800799672482693, 5.98469045195713e-05, -7.6088963285423962e-06, 9.7732547570985546e-07,
         -1.2646178820954569e-07, 1.6456010029530313e-08, -2.1513318032944697e-09, 2.8223549970233462e-10
        },
        /* [48] 5.9375 <= y <= 6.0625, degree 10, 61.3 bits */
        {
         0.35825067829251178, 2.3735919232217254e-17, -0.0330436197877228, 0.0037457570115746403,
         -0.00044923631089648292, 5.5312033303773755e-05, -6.915661681314793e-06, 8.7353198184658619e-07,
         -1.1115243812859339e-07, 1.4223183371988005e-08, -1.8284480061475548e-09, 2.3587690402950237e-10
        },
        /* [49] 6.0625 <= y <= 6.1875, degree 10, 60.5 bits */
        {
         0.35417788915382781, 9.8311017553383931e-18, -0.032127814646578365, 0.0035823469558174045,
         -0.00042262767009357217, 5.1187116726521518e-05, -6.2954834039934538e-06, 7.8220798411652141e-07,
         -9.7904680815281725e-08, 1.2322962731301904e-08, -1.5582085126099971e-09, 1.9771915757694533e-10
        },
        /* [50] 6.1875 <= y <= 6.3125, degree 10, 61.3 bits */
        {
         0.35021707335719171, -5.8154262341428548e-18, -0.03125164622456808, 0.0034285402161423053,
         -0.00039798804202906632, 4.7429281653762314e-05, -5.7396510139839223e-06, 7.0168687224514914e-07,
         -8.6413691238983728e-08, 1.0701517802598666e-08, -1.331367995771873e-09, 1.6621088584565879e-10
        },
        /* [51] 6.3125 <= y <= 6.4375, degree 10, 62.3 bits */
        {
         0.34636342260649372, -2.6734590903054904e-17, -0.030412803198934298, 0.0032836316083724153,
         -0.00037514353255643502, 4.4000728343317148e-05, -5.2406095805387526e-06, 6.3054664745224524e-07,
         -7.642361947634984e-08, 9.3144034728981364e-09, -1.1404176371394247e-09, 1.4011267509056299e-10
        },
        /* [52] 6.4375 <= y <= 6.5625, degree 10, 61.7 bits */
        {
         0.34261240683309974, 2.0640626258072083e-17, -0.029609142678017349, 0.0031469777574189982,
         -0.00035393802037653746, 4.086806236184483e-05, -4.7917913606851425e-06, 5.6757090569510752e-07,
         -6.77191130984997e-08, 8.1248095893949991e-09, -9.7923838118172371e-10, 1.1843073174383719e-10
        },
        /* [53] 6.5625 <= y <= 6.6875, degree 10, 64.8 bits */
        {
         0.33895975407406492, 7.2508529361122387e-18, -0.028838675548837716, 0.0030179908269081786,
         -0.00033423110093368019, 3.8001723135694118e-05, -4.3874740972612397e-06, 5.1171652673116554e-07,
         -6.0118409415492025e-08, 7.102157766638496e-09, -8.4282742096045415e-10, 1.0036539504287162e-10
        },
        /* [54] 6.6875 <= y <= 6.8125, degree 10, 63.3 bits */
        {
         0.33540143208780482, -2.551699245203056e-17, -0.028099553300188873, 0.0028961329689268047,
         -0.00031589629510075001, 3.5375493941848272e-05, -4.0226614289912444e-06, 4.6208683591654443e-07,
         -5.3467688457524171e-08, 6.2209724443050371e-09, -7.2708162935045111e-10, 8.5271015456893642e-11
        },
        /* [55] 6.8125 <= y <= 6.9375, degree 10, 63.1 bits */
        {
         0.33193363153354022, -1.4807280398134435e-17, -0.027390056153012744, 0.0027809114018139953,
         -0.00029881948518492536, 3.2966080719903935e-05, -3.6929816933978628e-06, 4.1790924679438829e-07,
         -4.7636441966401054e-08, 5.4599694847922869e-09, -6.2862544891615582e-10, 7.2624566668445457e-11
        },
        /* [56] 6.9375 <= y <= 7.0625, degree 10, 63.6 bits */
        {
         0.32855275056049044, 1.3182507948216828e-17, -0.026708582351186023, 0.0026718740368616746,
         -0.00028289754655062176, 3.0752749193845836e-05, -3.3946020728475598e-06, 3.7851658377150045e-07,
         -4.251366393671372e-08, 4.8013179519063493e-09, -5.4467362627531735e-10, 6.2000997004175497e-11
        },
        /* [57] 7.0625 <= y <= 7.1875, degree 10, 61.3 bits */
        {
         0.32525538066997184, 2.5973486665178509e-17, -0.026053638484222198, 0.0025686055857474643,
         -0.00026803714796512035, 2.8717011523350179e-05, -3.1241555753135335e-06, 3.4333143640775532e-07,
         -3.8004707636020686e-08, 4.230040241302296e-09, -4.7292135848790155e-10, 5.3053801322207312e-11
        },
        /* [58] 7.1875 <= y <= 7.3125, degree 10, 62.0 bits */
        {
         0.3220382937286061, -9.2422702038663619e-18, -0.02542383072924323, 0.0024707240898323452,
         -0.0002541536977945838, 2.6842355130155539e-05, -2.8786787805074809e-06, 3.1185301843687701e-07,
         -3.4028685016548895e-08, 3.7335231142001524e-09, -4.1145608261527048e-10, 4.5499653079666138e-11
        },
        /* [59] 7.3125 <= y <= 7.4375, degree 10, 61.8 bits */
        {
         0.318898430024046, -1.8702646089996371e-17, -0.024817856913274639, 0.0023778778203816658,
         -0.00024117041655162579, 2.5114007522929779e-05, -2.6555586393094106e-06, 2.8364610209465966e-07,
         -3.0516308890466639e-08, 3.3011179251231606e-09, -3.5868641437188969e-10, 3.9106205766172832e-11
        },
        /* [60] 7.4375 <= y <= 7.5625, degree 10, 61.8 bits */
        {
         0.31583288726623621, 2.044748955393988e-17, -0.024234499308785355, 0.0022897425055330399,
         -0.00022901751913233354, 2.3518731919915732e-05, -2.4524869060450884e-06, 2.5833167670105863e-07,
         -2.7408097618675092e-08, 2.9238128138397678e-09, -3.1328472106679686e-10, 3.3682377295729725e-11
        },
        /* [61] 7.5625 <= y <= 7.6875, degree 10, 61.6 bits */
        {
         0.31283891044745149, -2.5320903451646244e-17, -0.023672618085695676, 0.0022060188456218825,
         -0.00021763149247211143, 2.2044649279346051e-05, -2.2674210219003194e-06, 2.3557904366631719e-07,
         -2.465287746758148e-08, 2.5939631405439237e-09, -2.7414057098438546e-10, 2.9070586967658307e-11
        },
        /* [62] 7.6875 <= y <= 7.8125, degree 10, 61.8 bits */
        {
         0.30991388248337892, 5.9118790828714447e-18, -0.023131145352038009, 0.0021264302834373382,
         -0.00020695445637078849, 2.0681083022935261e-05, -2.0985504637760309e-06, 2.1509911125468329e-07,
         -2.2206530075184687e-08, 2.3050692019705749e-09, -2.4032288668244223e-10, 2.5140532133766414e-11
        },
        /* [63] 7.8125 <= y <= 7.9375, degree 10, 64.1 bits */
        {
         0.30705531556549021, 2.2386807254134323e-17, -0.022609079723265535, 0.0020507210002450884,
         -0.00019693359694957716, 1.9418423301761915e-05, -1.9442677342773912e-06, 1.9663869396825193e-07,
         -2.0030942299514464e-08, 2.0515924418515682e-09, -2.1104908594240725e-10, 2.1784185055555117e-11
        },
        /* [64] 7.9375 <= y <= 8.0625, degree 10, 62.6 bits */
        {
         0.30426084316201168, -1.6178810484467619e-17, -0.022105481367024477, 0.0019786541120851123,
         -0.00018752066365628793, 1.8248008126087167e-05, -1.8031433017741233e-06, 1.799756552213054e-07,
         -1.8093123614473803e-08, 1.8288030917421495e-09, -1.8565984963204831e-10, 1.8911757154787447e-11
        }
    };
    return row[i];
}

/* time of the largest overlap, beta < 8: 65 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 8.0625.
 * Relative error of the approximation: 2^-60.6 at most, proved for the whole cell of each row. */
#define COR_ROWS_TIME_OF_MAX_OVERLAP_FIRST 0.0
#define COR_ROWS_TIME_OF_MAX_OVERLAP_STEP 0.125
#define COR_ROWS_TIME_OF_MAX_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_TIME_OF_MAX_OVERLAP_ROWS 65
#define COR_ROWS_TIME_OF_MAX_OVERLAP_END 8.0
COR_INLINE const double *cor_rows_time_of_max_overlap(int i)
{
    static const double row[65][12] = {
        /* [0] 0 <= y <= 0.0625, degree 10, 61.0 bits */
        {
         1.6090327298595215, 3.7844950575244883e-17, -0.28674712506759398, 0.1048589870995717,
         -0.048684067828140658, 0.02543116750978849, -0.014236583511432335, 0.0083376572890039094,
         -0.0050396457245437329, 0.0031160528332572681, -0.0019351363116886981, 0.0010285645119171277
        },
        /* [1] 0.0625 <= y <= 0.1875, degree 10, 64.4 bits */
        {
         1.5747384787194234, -2.6569591592900681e-19, -0.2626317385953883, 0.088736181356491223,
         -0.037905560470354781, 0.018189556362853378, -0.009347976775031748, 0.0050243637456468841,
         -0.0027867741177711246, 0.0015820163125917493, -0.00091736036787855161, 0.00053771311393881313
        },
        /* [2] 0.1875 <= y <= 0.3125, degree 10, 63.5 bits */
        {
         1.5432261533884821, -1.8315261649009375e-17, -0.24209297044396622, 0.076061057825132561,
         -0.030096513791626006, 0.013358058635936153, -0.0063455829183090059, 0.0031516489421264185,
         -0.0016150835853807933, 0.0008470382023779815, -0.00045351505469557742, 0.00024556148362913543
        },
        /* [3] 0.3125 <= y <= 0.4375, degree 10, 62.0 bits */
        {
         1.5140972827507511, -2.743285429726186e-17, -0.22439132934922371, 0.065913835924251749,
         -0.02429835583824598, 0.010033244622405211, -0.0044313907277274776, 0.0020457309761853031,
         -0.0009742740310796005, 0.00047481731752424099, -0.0002361335521874261, 0.00011880177975731249
        },
        /* [4] 0.4375 <= y <= 0.5625, degree 10, 62.1 bits */
        {
         1.4870331341953917, -2.8632818017454599e-17, -0.20897853022523591, 0.057662932842885088,
         -0.019901809859164708, 0.0076837878451681448, -0.0031712736770784329, 0.0013676512004857193,
         -0.00060837910090124833, 0.00027691580689632675, -0.00012857149805232457, 6.0408396020194287e-05
        },
        /* [5] 0.5625 <= y <= 0.6875, degree 10, 60.9 bits */
        {
         1.4617747146083806, -3.6342389953407315e-17, -0.1954393007721488, 0.050862816439778122,
         -0.016506766808815312, 0.0059849798655061256, -0.0023184009517294613, 0.00093815162393176012,
         -0.00039151472777721477, 0.00016717032526528621, -7.2787427473752217e-05, 3.20778955036699e-05
        },
        /* [6] 0.6875 <= y <= 0.8125, degree 10, 60.7 bits */
        {
         1.4381086875660793, 5.843137872452977e-17, -0.18345326185336408, 0.045191790873181079,
         -0.013842961829381545, 0.0047316959713287763, -0.0017269803758054999, 0.00065825481009456341,
         -0.00025871689166325916, 0.00010402863157459605, -4.2643108472039217e-05, 1.7695977448466159e-05
        },
        /* [7] 0.8125 <= y <= 0.9375, degree 10, 63.9 bits */
        {
         1.4158572194215084, 5.2448359262107688e-17, -0.17276923072957778, 0.040412801821516714,
         -0.011723287081513566, 0.003790553178254513, -0.0013079883535525257, 0.00047121687063819977,
         -0.00017502326921438818, 6.650118309182693e-05, -2.5752987979344711e-05, 1.0097593596419761e-05
        },
        /* [8] 0.9375 <= y <= 1.0625, degree 10, 61.3 bits */
        {
         1.3948705057929498, 5.2057475759208542e-17, -0.16318746047555258, 0.036348007046691763,
         -0.010015366374910028, 0.0030725825326857852, -0.0010054516386371762, 0.00034341268224052636,
         -0.00012091045814705638, 4.3544295249760508e-05, -1.5979828336163564e-05, 5.9382047950462182e-06
        },
        /* [9] 1.0625 <= y <= 1.1875, degree 10, 61.5 bits */
        {
         1.375021170294273, -3.9568479136690924e-17, -0.15454709200957556, 0.032861846060337367,
         -0.0086237259184840428, 0.0025170844641764574, -0.00078325215952023417, 0.00025432383181586417,
         -8.5113777933251721e-05, 2.9133577706760705e-05, -1.0159670842752502e-05, 3.5879645658357093e-06
        },
        /* [10] 1.1875 <= y <= 1.3125, degree 10, 61.2 bits */
        {
         1.3561999984739466, 1.1927784378013968e-17, -0.14671711464165532, 0.029849507377280416,
         -0.0074783128720522091, 0.0020818022375831175, -0.00061753745045283913, 0.00019109759397780465,
         -6.094107237831301e-05, 1.9875015680736662e-05, -6.6027222020471892e-06, 2.2215382397974181e-06
        },
        /* [11] 1.3125 <= y <= 1.4375, degree 10, 62.3 bits */
        {
         1.3383126417244915, -5.0325703588467331e-17, -0.1395897400269783, 0.027228910512049991,
         -0.0065269259943626923, 0.0017367799008696008, -0.00049222377998340194, 0.00014549137620852961,
         -4.4310961338758172e-05, 1.3800318675185349e-05, -4.3774178708114267e-06, 1.4063328235211804e-06
        },
        /* [12] 1.4375 <= y <= 1.5625, degree 10, 60.6 bits */
        {
         1.3212770375772578, -8.8284739780648621e-17, -0.13307546881364807, 0.024935028444520099,
         -0.0057301191270751287, 0.0014604305972084411, -0.00039625984367658431, 0.0001121055567265379,
         -3.2674618937219076e-05, 9.7377726685647894e-06, -2.9552749118935389e-06, 9.0844354378014936e-07
        },
        /* [13] 1.5625 <= y <= 1.6875, degree 10, 62.1 bits */
        {
         1.3050213670262527, 8.5402584137439403e-17, -0.12709936544792702, 0.022915800284680155,
         -0.005057703762967488, 0.0012369650667261097, -0.00032192128000976898, 8.7333980345822085e-05,
         -2.4405683978186661e-05, 6.9731068865906564e-06, -2.0285867326874313e-06, 5.9777618033901563e-07
        },
        /* [14] 1.6875 <= y <= 1.8125, degree 10, 62.2 bits */
        {
         1.2894824198881309, -4.67070314991038e-17, -0.12159820905619184, 0.021129144220854924,
         -0.0044863071907410706, 0.001054676638275562, -0.00026372427878903825, 6.872549493161524e-05,
         -1.8445841188571673e-05, 5.061378453347458e-06, -1.4138968126999427e-06, 4.0008899630267652e-07
        },
        /* [15] 1.8125 <= y <= 1.9375, degree 10, 61.6 bits */
        {
         1.274604274010676, 3.4650609117865008e-17, -0.11651828880832364, 0.019540744470640838,
         -0.0039976405999052143, 0.00090477692439413831, -0.00021771968704942127, 5.4586942162239992e-05,
         -1.4093931837151465e-05, 3.7198698748233647e-06, -9.9942874972799677e-07, 2.7200373176869874e-07
        },
        /* [16] 1.9375 <= y <= 2.0625, degree 10, 63.3 bits */
        {
         1.2603372186004456, 6.8164891630116186e-18, -0.11181367966267158, 0.01812239099656663,
         -0.0035772529159158561, 0.00078059242036510436, -0.0001810259475879748, 4.3731293373415939e-05,
         -1.0877685997403628e-05, 2.7656398169170714e-06, -7.157082843542392e-07, 1.8762105941620254e-07
        },
        /* [17] 2.0625 <= y <= 2.1875, degree 10, 63.8 bits */
        {
         1.246636869391474, -9.8181033044902662e-17, -0.10744488051746605, 0.016850719490681679,
         -0.0032136221978730484, 0.00067700179000399364, -0.00015151486933535761, 3.5314899051359525e-05,
         -8.4741203594671765e-06, 2.078304783854526e-06, -5.1875282696624203e-07, 1.3116580919880146e-07
        },
        /* [18] 2.1875 <= y <= 2.3125, degree 10, 61.7 bits */
        {
         1.2334634360035457, -8.0063227080585829e-17, -0.10337772881578387, 0.015706244919146361,
         -0.0028974850308122525, 0.00059003626491719425, -0.00012759694708382207, 2.8730523789148107e-05,
         -6.6592124766228907e-06, 1.5774061723125783e-06, -3.8024045282304002e-07, 9.2850405487627565e-08
        },
        /* [19] 2.3125 <= y <= 2.4375, degree 10, 62.6 bits */
        {
         1.2207811110923703, 2.371954963116716e-17, -0.099582528207772983, 0.014672612913392896,
         -0.0026213359586209459, 0.00051659223712354819, -0.00010807259442562312, 2.353593454128439e-05,
         -5.2755336047679972e-06, 1.2083880320126419e-06, -2.8164365482642664e-07, 6.6497336392768917e-08
        },
        /* [20] 2.4375 <= y <= 2.5625, degree 10, 61.6 bits */
        {
         1.2085575577567509, 8.3019651504500215e-17, -0.096033341977036543, 0.01373601459292971,
         -0.0023790499109514213, 0.00045422208768207509, -9.2027685256302336e-05, 1.9405526703139109e-05,
         -4.2110979327277003e-06, 9.3375820630723788e-07, -2.1066296068028458e-07, 4.814499586320953e-08
        },
        /* [21] 2.5625 <= y <= 2.6875, degree 10, 62.0 bits */
        {
         1.1967634768134532, 5.1458774469581687e-17, -0.09270741657754078, 0.01288472524396019,
         -0.002165594617093162, 0.00040098027169857228, -7.8759302659807911e-05, 1.6097109845068017e-05,
         -3.3853353944220095e-06, 7.2742658198487759e-07, -1.5902080639556549e-07, 3.5214792052570307e-08
        },
        /* [22] 2.6875 <= y <= 2.8125, degree 10, 62.1 bits */
        {
         1.1853722394480755, 7.3868681447336226e-17, -0.089584708137818395, 0.012108737750272028,
         -0.0019768095621908142, 0.00035530889566773695, -6.772235319701459e-05, 1.342881299056185e-05,
         -2.739659685555776e-06, 5.7102373303108624e-07, -1.2107460222284275e-07, 2.6004850341360288e-08
        },
        /* [23] 2.8125 <= y <= 2.9375, degree 10, 61.5 bits */
        {
         1.1743595737305874, -3.8482142823333101e-17, -0.08664749107877133, 0.011399469152208888,
         -0.0018092346406904298, 0.00031595183485836183, -5.8490770996190154e-05, 1.1262835952906442e-05,
         -2.2310438798927583e-06, 4.5147351989239094e-07, -9.2931529288837957e-08, 1.9377213320572973e-08
        },
        /* [24] 2.9375 <= y <= 3.0625, degree 10, 63.4 bits */
        {
         1.163703295783445, 8.2147070527707022e-17, -0.083880032686273212, 0.01074952411120512,
         -0.0016599762729317274, 0.00028188969071008235, -5.0729040863913444e-05, 9.4938904585222735e-06,
         -1.8275914721569612e-06, 3.5937140552740484e-07, -7.1875512392571043e-08, 1.4561629168194056e-08
        },
        /* [25] 3.0625 <= y <= 3.1875, degree 10, 63.1 bits */
        {
         1.153383078178704, -3.6224454366203651e-18, -0.081268321017240935, 0.010152502999388175,
         -0.0015266020098001942, 0.00025229011427427175, -4.4171098464954704e-05, 8.0408918334900643e-06,
         -1.5054482781471949e-06, 2.8788764290487073e-07, -5.5991318380770629e-08, 1.1030706169445025e-08
        },
        /* [26] 3.1875 <= y <= 3.3125, degree 10, 63.2 bits */
        {
         1.1433802495426075, 9.9720650399070646e-17, -0.078799836206683002, 0.0096028452388070337,
         -0.0014070569787286297, 0.00022646956348783875, -3.8604557759243602e-05, 6.8409286625863391e-06,
         -1.2466261874363997e-06, 2.320168250310646e-07, -4.3914869212297606e-08, 8.4194042994821641e-09
        },
        /* [27] 3.3125 <= y <= 3.4375, degree 10, 61.5 bits */
        {
         1.1336776204532852, 1.051719161877352e-16, -0.076463357303913626, 0.0090957006754471704,
         -0.0012995972047700837, 0.00020386364177811891, -3.385882209720019e-05, 5.8448454743326459e-06,
         -1.0374540440859264e-06, 1.8805879362443546e-07, -3.4665428791033009e-08, 6.4724586410035288e-09
        },
        /* [28] 3.4375 <= y <= 3.5625, degree 10, 61.8 bits */
        {
         1.1242593315974796, 8.9703351713205204e-17, -0.074248798357674547, 0.0086268233940559515,
         -0.0012027360648775058, 0.00018400392955564732, -2.979605199197873e-05, 5.0139788267091892e-06,
         -8.674644382917098e-07, 1.5325586717993079e-07, -2.753155677951369e-08, 5.0097197677300935e-09
        },
        /* [29] 3.5625 <= y <= 3.6875, degree 10, 64.0 bits */
        {
         1.1151107208566788, 6.2622694493929055e-17, -0.072147068708142456, 0.0081924836057000218,
         -0.0011152010337211365, 0.00016649976617978492, -2.6304251978671257e-05, 4.3177257876562979e-06,
         -7.2858654854758553e-07, 1.2553684329580864e-07, -2.19927905769119e-08, 3.9024910033221279e-09
        },
        /* [30] 3.6875 <= y <= 3.8125, degree 10, 61.1 bits */
        {
         1.1062182065602268, -4.1308905242778377e-17, -0.070149953413821214, 0.0077893941743094807,
         -0.0010358985468426603, 0.00015102383383506598, -2.3291942024669436e-05, 3.7317184153898204e-06,
         -6.1455590784085579e-07, 1.0333466092119492e-07, -1.7665310224625418e-08, 3.0587205364081033e-09
        },
        /* [31] 3.8125 <= y <= 3.9375, degree 10, 61.7 bits */
        {
         1.0975691846023112, 8.9614991938957617e-17, -0.06825001050619911, 0.0074146490657760831,
         -0.00096388530583996874, 0.00013730068134878694, -2.0684022794795128e-05, 3.2364430851212684e-06,
         -5.2047930958692358e-07, 8.5455414952306582e-08, -1.4263908529144359e-08, 2.4114107683255118e-09
        },
        /* [32] 3.9375 <= y <= 4.0625, degree 10, 61.6 bits */
        {
         1.0891519374937519, 5.3021015510382765e-18, -0.066440482371913911, 0.0070656715576808979,
         -0.00089834472601778488, 0.00012509753626469629, -1.8418546891838895e-05, 2.8161889390844535e-06,
         -4.4251161682019666e-07, 7.0983453587306689e-08, -1.1575113264878415e-08, 1.9116887281355845e-09
        },
        /* [33] 4.0625 <= y <= 4.1875, degree 10, 62.0 bits */
        {
         1.0809555537256457, 9.5532479430706947e-17, -0.06471521904649348, 0.006740170479193135,
         -0.00083856751197628279, 0.00011421690900331116, -1.6444182319329e-05, 2.4582416647754684e-06,
         -3.7761394392387785e-07, 5.9212087872500977e-08, -9.4380402356627649e-09, 1.5235858595602295e-09
        },
        /* [34] 4.1875 <= y <= 4.3125, degree 10, 61.1 bits */
        {
         1.0729698560737515, -8.348033826342685e-17, -0.063068611592427201, 0.0064361030885004295,
         -0.0007839355643248936, 0.00010449060881581877, -1.4718208291305933e-05, 2.1522614434311496e-06,
         -3.2337146774305165e-07, 4.9592616086412822e-08, -7.7306393995971257e-09, 1.2204418751966876e-09
        },
        /* [35] 4.3125 <= y <= 4.4375, degree 10, 66.0 bits */
        {
         1.0651853376806042, -2.5412938499387926e-17, -0.061495534047920297, 0.0061516434611949842,
         -0.00073390858808944413, 9.5774878196809118e-05, -1.3204922978751068e-05, 1.8898000948696911e-06,
         -2.7785525662651107e-07, 4.1696553410394364e-08, -6.3597388497817805e-09, 9.823610362420709e-10
        },
        /* [36] 4.4375 <= y <= 4.5625, degree 10, 64.6 bits */
        {
         1.0575931049251195, 1.9743060193973392e-17, -0.05999129268697416, 0.0058851554737733448,
         -0.00068801290286567903, 8.7946418122422347e-05, -1.1874371903579117e-05, 1.6639241078842206e-06,
         -2.3951682134152419e-07, 3.5187454402330362e-08, -5.2537847131908072e-09, 7.9439899381008181e-10
        },
        /* [37] 4.5625 <= y <= 4.6875, degree 10, 65.3 bits */
        {
         1.0501848262334761, 7.8105396984608098e-17, -0.058551581538634677, 0.0056351696342149243,
         -0.00064583205553551959, 8.0899126443399221e-05, -1.0701327331262716e-05, 1.4689187142938056e-06,
         -2.0710715369829018e-07, 2.9799754441206555e-08, -4.3575095966655788e-09, 6.4526058332618413e-10
        },
        /* [38] 4.6875 <= y <= 4.8125, degree 10, 62.7 bits */
        {
         1.0429526861056391, 6.7727163579558046e-17, -0.057172443282854472, 0.0054003631459160067,
         -0.00060699891521921886, 7.4541409992463594e-05, -9.6644652022557279e-06, 1.300054358949157e-06,
         -1.7961420815143297e-07, 2.532278238271588e-08, -3.6279908693115007e-09, 5.263578132941987e-10
        },
        /* [39] 4.8125 <= y <= 4.9375, degree 10, 62.7 bits */
        {
         1.0358893437332064, 7.9254036833073454e-17, -0.055850234779858142, 0.0051795426992855423,
         -0.00057118899218352147, 6.8793960390898105e-05, -8.7456983313604709e-06, 1.1534014798691981e-06,
         -1.5621435887393508e-07, 2.1588608275226687e-08, -3.0317176609255546e-09, 4.3112369965735883e-10
        },
        /* [40] 4.9375 <= y <= 5.0625, degree 10, 62.6 bits */
        {
         1.0289878956697298, -1.3291398598670653e-17, -0.05458159660502758, 0.004971629572607255,
         -0.00053811477149915885, 6.3587906316040147e-05, -7.929633837833544e-06, 1.0256828946884976e-06,
         -1.3623450909820841e-07, 1.8462753222910324e-08, -2.5423949395381797e-09, 3.5450913653627863e-10
        },
        /* [41] 5.0625 <= y <= 5.1875, degree 10, 62.4 bits */
        {
         1.022241842087007, 4.7297181662868728e-17, -0.053363426056761115, 0.0047756466946350853,
         -0.00050752089124563374, 5.8863272717503903e-05, -7.2031298050529592e-06, 9.1415561280596116e-07,
         -1.1912236538169928e-07, 1.5837048253729411e-08, -2.1392896841465838e-09, 2.9261163182578547e-10
        },
        /* [42] 5.1875 <= y <= 5.3125, degree 10, 62.3 bits */
        {
         1.0156450562123003, 2.3998738811817668e-17, -0.052192853184179176, 0.0045907073791578556,
         -0.00047918002621036895, 5.4567691336896077e-05, -6.5549315602445781e-06, 8.1651578656933925e-07,
         -1.0442300400412342e-07, 1.3624116124604523e-08, -1.805978241154229e-09, 2.4239967775157584e-10
        },
        /* [43] 5.3125 <= y <= 5.4375, degree 10, 63.6 bits */
        {
         1.009191756593804, -4.7288181784871391e-17, -0.05106721944788406, 0.0044160054890582537,
         -0.00045288936301835804, 5.0655317787840587e-05, -5.9753721187246438e-06, 7.3082194473670536e-07,
         -9.1760311368209059e-08, 1.1753085620202476e-08, -1.5293923598200299e-09, 2.0150691731760117e-10
        },
        /* [44] 5.4375 <= y <= 5.5625, degree 10, 63.8 bits */
        {
         1.0028764818864597, -3.069510620264739e-17, -0.049984058682584924, 0.004250806826255474,
         -0.00042846757276334763, 4.708591906518334e-05, -5.4561245541024817e-06, 6.5543273706620681e-07,
         -8.0822218673972328e-08, 1.0166246854413427e-08, -1.2990888774866319e-09, 1.6807757374118021e-10
        },
        /* [45] 5.5625 <= y <= 5.6875, degree 10, 62.2 bits */
        {
         0.99669406788860915, -4.3264083427121861e-17, -0.048941080077166702, 0.0040944415759828047,
         -0.00040575220350343584, 4.38241021865847e-05, -4.9899965596725056e-06, 5.8895624753591615e-07,
         -7.13489044557173e-08, 8.8164282575613004e-09, -1.1066875992391037e-09, 1.4069798780752359e-10
        },
        /* [46] 5.6875 <= y <= 5.8125, degree 10, 66.2 bits */
        {
         0.99063962659298976, 3.9608625675435913e-17, -0.047936152927247351, 0.0039462976603986582,
         -0.00038459742821954498, 4.083866011724608e-05, -4.5707594242678883e-06, 5.3020856946489253e-07,
         -6.3123329242396971e-08, 7.6649333830455219e-09, -9.4543768032080628e-10, 1.1806671234343353e-10
        },
        /* [47] 5.8125 <= y <= 5.9375, degree 10, 62.6 bits */
        {
         0.98470852704405609, -3.7058885690394605e-17, -0.046967292948676367, 0.003805814878588081,
         -0.00036487209462968156, 3.8102015489119504e-05, -4.1930051841684635e-06, 4.7817982608511592e-07,
         -5.5963610934368449e-08, 6.679902158260173e-09, -8.0987847284226621e-10, 9.9409575319071637e-11
        },
        /* [48] 5.9375 <= y <= 6.0625, degree 10, 62.1 bits */
        {
         0.97889637781822691, 3.9237334056789051e-17, -0.046032649968795629, 0.0036724797284028764,
         -0.0003464580320884357, 3.5589746130778568e-05, -3.8520269265933358e-06, 4.3200619983759096e-07,
         -4.9716859185244569e-08, 5.8350177013883826e-09, -6.9557780860210784e-10, 8.3945324348874791e-11
        },
        /* [49] 6.0625 <= y <= 6.1875, degree 10, 63.2 bits */
        {
         0.97319901096501282, -1.0566188008549047e-17, -0.045130496836441714, 0.0035458208209720463,
         -0.00032924857806102291, 3.3280179252244036e-05, -3.5437181823672614e-06, 3.9094682940930758e-07,
         -4.4254171062998855e-08, 5.1084687099568217e-09, -5.9892478504922195e-10, 7.108693012096389e-11
        },
        /* [50] 6.1875 <= y <= 6.3125, degree 10, 62.5 bits */
        {
         0.96761246726552486, 1.3248210522973895e-17, -0.0442592194123008, 0.0034254048116227785,
         -0.00031314729264642007, 3.1154043419798654e-05, -3.2644881109392025e-06, 3.5436466455946731e-07,
         -3.9466554641601546e-08, 4.4821210535688407e-09, -5.1696750131098434e-10, 6.0362543064076771e-11
        },
        /* [51] 6.3125 <= y <= 6.4375, degree 10, 62.2 bits */
        {
         0.96213298268103953, -4.2605922634221253e-18, -0.04341730751889547, 0.0033108327818168514,
         -0.00029806683457514596, 2.91941693181114e-05, -3.0111897926006589e-06, 3.2171055030218136e-07,
         -3.5261596934682228e-08, 3.9408515979268548e-09, -4.4728469935886216e-10, 5.1391507568193485e-11
        },
        /* [52] 6.4375 <= y <= 6.5625, degree 10, 64.0 bits */
        {
         0.95675697587840636, 1.1737481480179958e-17, -0.042603346744652784, 0.0032017370158786474,
         -0.00028392797621597585, 2.7385231816323546e-05, -2.7810594333253907e-06, 2.9250995507704359e-07,
         -3.1560731111933006e-08, 3.472010848196356e-09, -3.8788393748278407e-10, 4.3865656998347694e-11
        },
        /* [53] 6.5625 <= y <= 6.6875, degree 10, 62.3 bits */
        {
         0.95148103673144668, 4.9155831249098744e-17, -0.041816011009562171, 0.0030977781240548387,
         -0.00027065873854633608, 2.5713527098529906e-05, -2.5716646825667022e-06, 2.6635187079902704e-07,
         -2.829698793929627e-08, 3.0649879751238322e-09, -3.3712050269730365e-10, 3.753465990195383e-11
        },
        /* [54] 6.6875 <= y <= 6.8125, degree 10, 63.7 bits */
        {
         0.94630191570832944, -1.2012151112446078e-17, -0.041054055811200092, 0.0029986424700363238,
         -0.00025819362989721006, 2.4166779640662812e-05, -2.3808605833985135e-06, 2.4287950268031755e-07,
         -2.5413139831243752e-08, 2.7108575168057589e-09, -2.9363260120601031e-10, 3.2194496294011738e-11
        },
        /* [55] 6.8125 <= y <= 6.9375, degree 10, 62.8 bits */
        {
         0.94121651406443951, -2.8209978082084362e-17, -0.04031631207964631, 0.0029040398666823151,
         -0.00024647297467521485, 2.273397465753877e-05, -2.2067519330413346e-06, 2.2178243850442868e-07,
         -2.2860164304077863e-08, 2.4020914731307116e-09, -2.5628937504391653e-10, 2.7678359539511912e-11
        },
        /* [56] 6.9375 <= y <= 7.0625, degree 10, 63.9 bits */
        {
         0.93622187476864926, 1.111163759298696e-17, -0.039601680578267427, 0.0028137015084729799,
         -0.00023544232027322123, 2.1405212339559878e-05, -2.0476610422116014e-06, 2.0279004450074511e-07,
         -2.0595968115425826e-08, 2.1323239394488282e-09, -2.2414906251651911e-10, 2.3849446801457196e-11
        },
        /* [57] 7.0625 <= y <= 7.1875, degree 10, 62.2 bits */
        {
         0.93131517409831011, -1.2142438684395835e-18, -0.038909126794686812, 0.0027273781133116,
         -0.00022505191207248176, 2.0171580775329908e-05, -1.9021000534332305e-06, 1.8566588113348949e-07,
         -1.8584324838349778e-08, 1.8961580957780416e-09, -1.9642521074586054e-10, 2.0595225944760952e-11
        },
        /* [58] 7.1875 <= y <= 7.3125, degree 10, 62.6 bits */
        {
         0.92649371384483337, -2.6150964637833868e-17, -0.038237676272654668, 0.0026448382498082956,
         -0.00021525622786756121, 1.9025044935979903e-05, -1.7687471190128885e-06, 1.7020296933186526e-07,
         -1.679398771656435e-08, 1.6890074542042163e-09, -1.7245930225681905e-10, 1.7822860274284072e-11
        },
        /* [59] 7.3125 <= y <= 7.4375, degree 10, 66.3 bits */
        {
         0.92175491407753452, 3.9880490827010556e-17, -0.037586410341112458, 0.0025658668291951739,
         -0.00020601356425450801, 1.7958349496815199e-05, -1.6464258548039105e-06, 1.56219767782988e-07,
         -1.5197946893575003e-08, 1.5069649035058403e-09, -1.5169850831133682e-10, 1.5455545290115254e-11
        },
        /* [60] 7.4375 <= y <= 7.5625, degree 10, 62.0 bits */
        {
         0.91709630641856554, -4.2304193396481632e-17, -0.036954462201625307, 0.0024902637436224622,
         -0.00019728566854885989, 1.6964933606158042e-05, -1.5340875809450593e-06, 1.4355674632546346e-07,
         -1.377280589984624e-08, 1.3466943784273707e-09, -1.3367755378589807e-10, 1.342956592050828e-11
        },
        /* [61] 7.5625 <= y <= 7.6875, degree 10, 61.8 bits */
        {
         0.91251552778633904, 5.6251265263578138e-18, -0.036341013339631301, 0.0024178426348296753,
         -0.00018903741067304678, 1.6038855991456652e-05, -1.4307959392767304e-06, 1.3207346035203975e-07,
         -1.2498256925964986e-08, 1.2053409989015573e-09, -1.1800388982946358e-10, 1.1691924929070752e-11
        },
        /* [62] 7.6875 <= y <= 7.8125, degree 10, 62.6 bits */
        {
         0.90801031456893144, 1.6124742269111981e-17, -0.035745290228709654, 0.0023484297791277527,
         -0.00018123649019715705, 1.5174729028211693e-05, -1.3357135421692895e-06, 1.2164604734963351e-07,
         -1.135663814549279e-08, 1.080456331408538e-09, -1.0434553622963735e-10, 1.019842623630615e-11
        },
        /* [63] 7.8125 <= y <= 7.9375, degree 10, 63.0 bits */
        {
         0.90357849719258554, -5.467340297565053e-17, -0.035166561300370006, 0.0022818630763117458,
         -0.00017385317435325258, 1.4367660595665739e-05, -1.2480903615078234e-06, 1.1216507998360444e-07,
         -1.0332559365862209e-08, 9.6993606671262184e-10, -9.2421085035128669e-11, 8.9121203588479237e-12
        },
        /* [64] 7.9375 <= y <= 8.0625, degree 10, 63.1 bits */
        {
         0.89921799505368938, 1.6328832267213522e-17, -0.034604134154773494, 0.0022179911315862565,
         -0.00016686006338838632, 1.3613202710756306e-05, -1.1672536115509924e-06, 1.0353372103470099e-07,
         -9.4125847258712413e-09, 8.7196792035748024e-10, -8.1991458662471124e-11, 7.8020395842083591e-12
        }
    };
    return row[i];
}

/* eps beta^(5/3) at zero force, beta > exp(2): 32 rows of degree 10 in y = ln(beta), nodes 2.125 + i 0.25, 2 <= y <= 10.
 * Relative error of the approximation: 2^-59.6 at most, proved for the whole cell of each row. */
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_FIRST 2.125
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_STEP 0.25
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_PER_UNIT 4.0
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_ROWS 32
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_END 10.0
COR_INLINE const double *cor_rows_tail_eps_zero_force(int i)
{
    static const double row[32][12] = {
        /* [0] 2 <= y <= 2.25, degree 10, 59.6 bits */
        {
         1.1327453204503086, 5.5243997305744802e-17, 0.19574850424502319, -0.0870609615323064,
         0.013129595675897068, 0.0046435076085448064, -0.0027718558639489898, 0.00039587261668127312,
         0.00013830914842282872, -7.6683208541592751e-05, 1.062389622524121e-05, 3.3816284991518731e-06
        },
        /* [1] 2.25 <= y <= 2.5, degree 10, 59.8 bits */
        {
         1.1764618221230851, 4.1689870495801715e-18, 0.15491842415220328, -0.075880018601178767,
         0.016179358825847159, 0.0016059407939468184, -0.0020577197736372059, 0.00051973509528229465,
         1.3125391557803429e-05, -4.7419216767882081e-05, 1.3662687274776361e-05, -4.9332793603788261e-07
        },
        /* [2] 2.5 <= y <= 2.75, degree 10, 60.5 bits */
        {
         1.2107061202120273, 8.9243460361976594e-17, 0.12007527254429783, -0.063434362579975784,
         0.016661118365110111, -0.00048310206569111949, -0.0012958521220107877, 0.00047694423021929288,
         -5.277537938076964e-05, -1.9782803456448421e-05, 1.0309037546037979e-05, -1.8456625360646068e-06
        },
        /* [3] 2.75 <= y <= 3, degree 10, 61.0 bits */
        {
         1.2370175810192763, 5.7432684912995496e-17, 0.091429243544830993, -0.051295414194632856,
         0.015509054264881535, -0.0016888804416965181, -0.00066240145308567777, 0.00036195475334282589,
         -7.2677749732223158e-05, -1.8775077922486831e-06, 5.6712850606709016e-06, -1.7159888382752388e-06
        },
        /* [4] 3 <= y <= 3.25, degree 10, 63.5 bits */
        {
         1.2569040973488981, -4.1342980902730866e-17, 0.068572987987467041, -0.040380737589293017,
         0.01350934877559092, -0.0022171957645097749, -0.0002141138849035893, 0.00023759965849793832,
         -6.6644488884154779e-05, 6.5753937185690935e-06, 2.1174743343982409e-06, -1.105429452374307e-06
        },
        /* [5] 3.25 <= y <= 3.5, degree 10, 61.2 bits */
        {
         1.2717258158519622, 3.0441923908022854e-17, 0.050774147192888593, -0.031101025718179198,
         0.011223865502966295, -0.0022965292590995741, 6.1359702388289058e-05, 0.00013444153621773933,
         -5.0533104587675704e-05, 8.781652127168251e-06, 9.6314731927377281e-08, -5.3967588685939103e-07
        },
        /* [6] 3.5 <= y <= 3.75, degree 10, 62.7 bits */
        {
         1.2826420304176624, 9.4678840142847639e-17, 0.037186480133227749, -0.023527836605389096,
         0.0090012687753607736, -0.0021190380381207823, 0.00020431098013370743, 6.1123831019984154e-05,
         -3.3577350788679971e-05, 7.8598834622955453e-06, -7.5318899751847336e-07, -1.7414564324830118e-07
        },
        /* [7] 3.75 <= y <= 4, degree 10, 62.2 bits */
        {
         1.2906007405081681, 4.5079986881851232e-17, 0.026982154789938283, -0.017536655853817459,
         0.0070248489189661846, -0.0018226593708681104, 0.00025839853185984291, 1.50213471305554e-05,
         -1.9777752607372301e-05, 5.8775326425312333e-06, -9.2736476566164177e-07, 1.0084858451538233e-08
        },
        /* [8] 4 <= y <= 4.25, degree 10, 62.9 bits */
        {
         1.2963531366046404, -1.0440708993977545e-16, 0.019422173629965761, -0.012910628946644943,
         0.0053659813622008766, -0.001494900527070832, 0.00025966457171536656, -1.0498665057953892e-05,
         -1.004897899937855e-05, 3.9008222181244756e-06, -7.9983307494937302e-07, 7.8064791586248656e-08
        },
        /* [9] 4.25 <= y <= 4.5, degree 10, 64.5 bits */
        {
         1.3004800201653048, -1.0342093699811755e-18, 0.013884544061508314, -0.0094069543088818475,
         0.0040289139869784923, -0.0011846854932117351, 0.00023376684814420458, -2.2240456878678845e-05,
         -3.8915719083097526e-06, 2.3374538476344624e-06, -5.8628077933586693e-07, 8.6553954562677502e-08
        },
        /* [10] 4.5 <= y <= 4.75, degree 10, 63.4 bits */
        {
         1.3034217682938438, -6.6261275642709381e-17, 0.009866875293343012, -0.0067943680185410492,
         0.0029829670139832278, -0.00091488417655948527, 0.00019707613364279653, -2.5660214753679166e-05,
         -3.784053646546088e-07, 1.2509235616686618e-06, -3.8637283009718055e-07, 7.1426204558767577e-08
        },
        /* [11] 4.75 <= y <= 5, degree 10, 63.8 bits */
        {
         1.3055070603963452, 5.854361947163641e-17, 0.0069755160423084165, -0.0048709347165184656,
         0.0021832458650712107, -0.00069250434581262597, 0.00015901043334825139, -2.4584766032252774e-05,
         1.3792074337577036e-06, 5.6413282473164174e-07, -2.3318311160350238e-07, 5.1140099002342432e-08
        },
        /* [12] 5 <= y <= 5.25, degree 10, 64.2 bits */
        {
         1.3069780634821135, 6.0350058482278431e-17, 0.0049090899856848065, -0.0034697529181131831,
         0.001582655295146274, -0.0005159071933957364, 0.00012433426580627928, -2.1450816171459264e-05,
         2.0703805645103711e-06, 1.6623268987657252e-07, -1.2843523734830321e-07, 3.3350399929173149e-08
        },
        /* [13] 5.25 <= y <= 5.5, degree 10, 65.1 bits */
        {
         1.3080113064592747, 2.8762930642019465e-17, 0.0034410235131516671, -0.0024580129637167139,
         0.0011380433890751441, -0.00037943598651498365, 9.4965351831109775e-05, -1.7680112815035698e-05,
         2.1700046298709368e-06, -4.1988701820082622e-08, -6.2520021583933215e-08, 2.015620149200594e-08
        },
        /* [14] 5.5 <= y <= 5.75, degree 10, 65.1 bits */
        {
         1.3087343248382159, 8.9821715713597286e-17, 0.002403440295366586, -0.0017329224337689487,
         0.00081272895496600132, -0.00027613588089989242, 7.1230409303048913e-05, -1.4023095160215636e-05,
         1.9787520368702316e-06, -1.3490373688939669e-07, -2.401064545434684e-08, 1.1289049421078524e-08
        },
        /* [15] 5.75 <= y <= 6, degree 10, 65.1 bits */
        {
         1.309238563750057, -6.1371228888576619e-17, 0.0016734196302444783, -0.0012165789748121881,
         0.00057699260353901837, -0.00019920169203872692, 5.2665572700441322e-05, -1.0819562898868894e-05,
         1.6732870047264894e-06, -1.6284920631129346e-07, -3.2903099109514539e-09, 5.7451890165807462e-09
        },
        /* [16] 6 <= y <= 6.25, degree 10, 65.1 bits */
        {
         1.3095891687388788, -1.5739492096330522e-17, 0.0011618341587036208, -0.00085090692095403202,
         0.00040754561692338454, -0.0001426426495267845, 3.8489583826337363e-05, -8.1764698497007273e-06,
         1.3492859466786432e-06, -1.5747014611049041e-07, 6.6297308245462206e-09, 2.4932521169749974e-09
        },
        /* [17] 6.25 <= y <= 6.5, degree 10, 65.3 bits */
        {
         1.3098322919696641, 1.9369700349625797e-17, 0.00080458640650489554, -0.00059317718377573819,
         0.00028657982425898823, -0.00010150034680929613, 2.7861831347323603e-05, -6.0803632893350519e-06,
         1.0530028925814119e-06, -1.3742226174328236e-07, 1.0401486637308595e-08, 7.1177810634062003e-10
        },
        /* [18] 6.5 <= y <= 6.75, degree 10, 65.4 bits */
        {
         1.3100004721078984, -1.0657052712860774e-16, 0.00055589804317264307, -0.00041228712711149359,
         0.00020072967623885701, -7.1833803865247684e-05, 2.0008363652958727e-05, -4.464025548836057e-06,
         8.0241495967172549e-07, -1.1298169250077363e-07, 1.092930213053477e-08, -1.7933245777378541e-10
        },
        /* [19] 6.75 <= y <= 7, degree 10, 65.5 bits */
        {
         1.3101165529705026, -5.5802254595455377e-18, 0.00038326763076367481, -0.00028579709625325018,
         0.00014010984063129325, -5.0599113387327516e-05, 1.4271953225017668e-05, -3.2433943517438691e-06,
         6.0048865141802201e-07, -8.93276496029423e-08, 9.9284981640054172e-09, -5.6022458994927514e-10
        },
        /* [20] 7 <= y <= 7.25, degree 10, 65.6 bits */
        {
         1.310196512304086, 9.3895461700285674e-17, 0.00026373796194174745, -0.00019763770775434297,
         9.7494549613951951e-05, -3.5494695452961931e-05, 1.0121584019864365e-05, -2.3363164061875064e-06,
         4.4304908074919486e-07, -6.870571827239398e-08, 8.3556545621272706e-09, -6.665901957875503e-10
        },
        /* [21] 7.25 <= y <= 7.5, degree 10, 65.6 bits */
        {
         1.3102514884790146, -8.9137619769022194e-17, 0.00018116564022359292, -0.00013637406817416741,
         6.7652727537488054e-05, -2.4808512390805898e-05, 7.1424421570003218e-06, -1.6707959124891147e-06,
         3.2318837599703285e-07, -5.1774956204011543e-08, 6.7072626767395078e-09, -6.37709574995915e-10
        },
        /* [22] 7.5 <= y <= 7.75, degree 10, 65.6 bits */
        {
         1.3102892232615186, -2.5623937076723567e-17, 0.00012424319946901694, -9.3913318019061775e-05,
         4.682760516738506e-05, -1.7283451409028826e-05, 5.0182767525888508e-06, -1.1875314403691325e-06,
         2.3356711381424153e-07, -3.8407003266471846e-08, 5.2137915325339467e-09, -5.5195407848978867e-10
        },
        /* [23] 7.75 <= y <= 8, degree 10, 65.6 bits */
        {
         1.3103150832712838, -5.9679573910255188e-17, 8.507793684539122e-05, -6.4554846115005566e-05,
         3.2339408719891716e-05, -1.2006072285666536e-05, 3.5123640468896936e-06, -8.3959637279120887e-07,
         1.6749291570998292e-07, -2.8137501899242493e-08, 3.9597668250829647e-09, -4.5087724203423974e-10
        },
        /* [24] 8 <= y <= 8.25, degree 10, 65.6 bits */
        {
         1.3103327797170259, 8.4409704855308492e-17, 5.8177727785878745e-05, -4.4299703936785392e-05,
         2.2287628718331715e-05, -8.3183702980567058e-06, 2.4500250357234251e-06, -5.908825484000952e-07,
         1.1932536956061212e-07, -2.0406606649431585e-08, 2.9550085173684251e-09, -3.5467433990285226e-10
        },
        /* [25] 8.25 <= y <= 8.5, degree 10, 65.6 bits */
        {
         1.3103448734233678, 7.1795143443954056e-17, 3.9731492261093002e-05, -3.035286301452605e-05,
         1.5331129361074393e-05, -5.749769338535639e-06, 1.7038301441267997e-06, -4.1417437707986325e-07,
         8.4534155190241774e-08, -1.4676738830635837e-08, 2.175152065003455e-09, -2.7169321755537207e-10
        },
        /* [26] 8.5 <= y <= 8.75, degree 10, 65.6 bits */
        {
         1.3103531278990781, -8.2908271495869446e-17, 2.7101275644566922e-05, -2.0767086187784604e-05,
         1.0527621805199475e-05, -3.9657995582470055e-06, 1.181683739629739e-06, -2.8928127162322727e-07,
         5.9596929121096603e-08, -1.0482003660481349e-08, 1.5835896385648652e-09, -2.0407575772219791e-10
        },
        /* [27] 8.75 <= y <= 9, degree 10, 65.6 bits */
        {
         1.3103587553646348, -2.2135890532617517e-17, 1.8465280861718526e-05, -1.4189702767786221e-05,
         7.2175799892153085e-06, -2.7299854539037695e-06, 8.1754224052520111e-07, -2.0141067915652391e-07,
         4.1838380857984047e-08, -7.4416429750579693e-09, 1.1425687178939324e-09, -1.5098469242468063e-10
        },
        /* [28] 9 <= y <= 9.25, degree 10, 65.6 bits */
        {
         1.3103625876907616, 3.1725500405507233e-17, 1.2567957134892787e-05, -9.6835132008577701e-06,
         4.9409530797674452e-06, -1.8759015205590675e-06, 5.6435439542601131e-07, -1.3983413548008135e-07,
         2.9262045388606598e-08, -5.2560942265460393e-09, 8.1820075962842489e-10, -1.1037343070013046e-10
        },
        /* [29] 9.25 <= y <= 9.5, degree 10, 65.6 bits */
        {
         1.3103651948538189, 1.1144743459667134e-17, 8.5456361481864119e-06, -6.6007085994355068e-06,
         3.3778041098903096e-06, -1.2868923493376602e-06, 3.8878724851434032e-07, -9.683548057280214e-08,
         2.0398385300907305e-08, -3.6958756462543816e-09, 5.8220704078858834e-10, -7.990373201987627e-11
        },
        /* [30] 9.5 <= y <= 9.75, degree 10, 65.6 bits */
        {
         1.3103669668270588, -3.860079336700316e-18, 5.8052485856492773e-06, -4.4944718072530806e-06,
         2.3062407977540411e-06, -8.8147909037236978e-07, 2.6734076842144785e-07, -6.6903856070819639e-08,
         1.417755947956196e-08, -2.5886210924245952e-09, 4.1203115974997894e-10, -5.7381469290624688e-11
        },
        /* [31] 9.75 <= y <= 10, degree 10, 65.6 bits */
        {
         1.3103681700720204, -7.5834329244680919e-17, 3.9401928927429462e-06, -3.0572200986466707e-06,
         1.5727470472692376e-06, -6.0293210587636567e-07, 1.8351729357698457e-07, -4.612683145361247e-08,
         9.8276969215505544e-09, -1.8068079000081612e-09, 2.9018279890765355e-10, -4.1138546611411616e-11
        }
    };
    return row[i];
}

/* duration/beta at zero overlap, beta > exp(2): 64 rows of degree 10 in y = ln(beta), nodes 2.0625 + i 0.125, 2 <= y <= 10.
 * Relative error of the approximation: 2^-57.6 at most, proved for the whole cell of each row. */
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_FIRST 2.0625
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_STEP 0.125
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_ROWS 64
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_END 10.0
COR_INLINE const double *cor_rows_tail_duration_zero_overlap(int i)
{
    static const double row[64][12] = {
        /* [0] 2 <= y <= 2.125, degree 10, 57.6 bits */
        {
         5.4129700417203379, 2.0767535940585467e-16, 3.1132697328720558, 0.19219644326552113,
         -0.11777451359507461, 0.060015415448254956, -0.029507887414408303, 0.015928949837646707,
         -0.010023029744951565, 0.0072491549131884483, -0.0058693059818032351, 0.0051140534659365935
        },
        /* [1] 2.125 <= y <= 2.25, degree 10, 58.3 bits */
        {
         5.8049156074779198, -2.3356453379868368e-16, 3.1562336873218344, 0.15313371621181132,
         -0.091830062716272282, 0.044726088254764935, -0.020204138412067984, 0.0095815320965142083,
         -0.0051534220424081885, 0.0031615806938150317, -0.0021601075624368415, 0.0015850371451213367
        },
        /* [2] 2.25 <= y <= 2.375, degree 10, 57.9 bits */
        {
         6.2016685142585466, -1.3210823509360733e-16, 3.1905389693275561, 0.12252799191218591,
         -0.072288878212502433, 0.034038751904119681, -0.014418972611053436, 0.0061694452190920179,
         -0.0029101446118849055, 0.001551740851475884, -0.00091962847117038431, 0.00058503768739517166
        },
        /* [3] 2.375 <= y <= 2.5, degree 10, 58.1 bits */
        {
         6.6022670885259647, 3.8541392158674408e-17, 3.2180318100212109, 0.098350054608734042,
         -0.057303951508700719, 0.026297330955976101, -0.010601354550265755, 0.0041768612593505719,
         -0.0017630713843197236, 0.00083148648986763277, -0.00043528712807534262, 0.00024494370496499135
        },
        /* [4] 2.5 <= y <= 2.625, degree 10, 59.2 bits */
        {
         7.0059519744600376, 8.1222403364917971e-17, 3.2401264284207696, 0.079133638050820479,
         -0.045662359735873841, 0.020542630203841152, -0.0079679691045000771, 0.002937507539936482,
         -0.0011282744417206014, 0.00047720345705246981, -0.00022357219234783076, 0.00011284270174740868
        },
        /* [5] 2.625 <= y <= 2.75, degree 10, 59.8 bits */
        {
         7.4121198396328545, 2.4075847906857099e-16, 3.2579206870485882, 0.063790582153538056,
         -0.036530184471032179, 0.016181379079419533, -0.0060889485230254774, 0.0021274852154263943,
         -0.00075426790634055684, 0.00028950648492388417, -0.00012261183414334056, 5.6081924956310275e-05
        },
        /* [6] 2.75 <= y <= 2.875, degree 10, 60.5 bits */
        {
         7.8202890778280141, -3.2884043858423363e-17, 3.2722753348711477, 0.051497179147924767,
         -0.029313774900402559, 0.012827372360003518, -0.0047125406475108681, 0.0015766162707329388,
         -0.00052236158684567996, 0.00018388680653723584, -7.0986358213605304e-05, 2.965710213185401e-05
        },
        /* [7] 2.875 <= y <= 3, degree 10, 58.7 bits */
        {
         8.2300738782875609, -7.9427896987862275e-16, 3.2838702830971718, 0.041620495384289712,
         -0.023579007037633579, 0.010218737499466819, -0.0036833389662759247, 0.0011897266963452465,
         -0.00037232242744194373, 0.0001213894650159484, -4.3022081135637382e-05, 1.6520748994125718e-05
        },
        /* [8] 3 <= y <= 3.125, degree 10, 60.0 bits */
        {
         8.6411643179371804, 3.1585883005317858e-16, 3.293245686956245, 0.033668564740816732,
         -0.019001673200161367, 0.0081719626798285212, -0.0029011407765097696, 0.00091076460309133392,
         -0.00027171097337514788, 8.2793126938426057e-05, -2.7119433261883885e-05, 9.621344897724963e-06
        },
        /* [9] 3.125 <= y <= 3.25, degree 10, 60.5 bits */
        {
         9.053310897409574, 3.7138820441914331e-16, 3.3008325865495092, 0.027255565477239313,
         -0.015335606784502458, 0.0065549540906495868, -0.0022989321913396664, 0.00070524189931291993,
         -0.00020216239596577084, 5.8060803484565431e-05, -1.7689650736501471e-05, 5.8238920614043483e-06
        },
        /* [10] 3.25 <= y <= 3.375, degree 10, 59.8 bits */
        {
         9.4663124193518104, -8.0121902472020071e-16, 3.306976149563666, 0.022076797886027254,
         -0.012391422967897081, 0.0052705215066348645, -0.0018304870835523881, 0.00055112421392693623,
         -0.00015282596203669975, 4.1693438848415963e-05, -1.1889985277954172e-05, 3.6472321366828527e-06
        },
        /* [11] 3.375 <= y <= 3.5, degree 10, 60.0 bits */
        {
         9.8800064189345331, 7.0922814110369286e-16, 3.3119535395374187, 0.017890298557887364,
         -0.010021885773445193, 0.0042458593286409914, -0.0014630690776606351, 0.00043386480985489105,
         -0.00011704757570982766, 3.055074660838066e-05, -8.2057541118615642e-06, 2.3543817930459411e-06
        },
        /* [12] 3.5 <= y <= 3.625, degree 10, 59.8 bits */
        {
         10.294261566834464, 9.3519507231090424e-17, 3.3159877995140934, 0.01450308211363471,
         -0.0081115632595142855, 0.0034256192778910274, -0.001172970535473123, 0.00034358016634605381,
         -9.0610464140474428e-05, 2.2773229150809734e-05, -5.7966672728984002e-06, 1.5618138864824109e-06
        },
        /* [13] 3.625 <= y <= 3.75, degree 10, 59.6 bits */
        {
         10.708971611340136, -3.4469298542418978e-16, 3.3192587318922468, 0.011760690613558649,
         -0.0065693462778223305, 0.0027672133204415523, -0.00094269307714372683, 0.00027338309044414456,
         -7.0762926231714303e-05, 1.7223854289590418e-05, -4.1797665763738889e-06, 1.0619175226056163e-06
        },
        /* [14] 3.75 <= y <= 3.875, degree 10, 59.4 bits */
        {
         11.124050530693662, 1.966821627019834e-16, 3.3219114827764487, 0.009539157613737621,
         -0.0053229328928189878, 0.0022375460976987579, -0.00075911179710348134, 0.00021836628534113627,
         -5.5661304946403593e-05, 1.3187016709051817e-05, -3.0686254464816529e-06, 7.3835494784115289e-07
        },
        /* [15] 3.875 <= y <= 4, degree 10, 59.2 bits */
        {
         11.539428642941999, 2.0553093617526156e-16, 3.3240633524257333, 0.0077387666906921235,
         -0.0043146951566542984, 0.0018106899846035058, -0.00061224760084597693, 0.00017496414637581867,
         -4.4040510178827297e-05, 1.0200397169048982e-05, -2.288517993013612e-06, 5.2389895772103129e-07
        },
        /* [16] 4 <= y <= 4.125, degree 10, 61.9 bits */
        {
         11.955049477111478, -7.6086504386577981e-16, 3.3258092223044891, 0.0062791637972941326,
         -0.0034985389096107255, 0.0014661978023539368, -0.00049442616242180621, 0.00014054127585050259,
         -3.5013486405236033e-05, 7.9580671871422589e-06, -1.7301018966184699e-06, 3.7860664835505968e-07
        },
        /* [17] 4.125 <= y <= 4.25, degree 10, 60.5 bits */
        {
         12.370867252139711, 1.8142345599595579e-16, 3.3272258951935663, 0.0050955040489444568,
         -0.0028374903233228644, 0.0011878569549549425, -0.00039968902345122664, 0.00011312066642752589,
         -2.794596508814788e-05, 6.2530563059390246e-06, -1.3233361040904504e-06, 2.7814744082752029e-07
        },
        /* [18] 4.25 <= y <= 4.375, degree 10, 60.2 bits */
        {
         12.786844842541541, -4.3437006808177228e-16, 3.3283755760676561, 0.0041353973374450318,
         -0.0023018229979764075, 0.00096275559372608103, -0.00032337301986755656, 9.1200088628828893e-05,
         -2.2376370059660548e-05, 4.9424389824942239e-06, -1.0223714851692712e-06, 2.0736345201157907e-07
        },
        /* [19] 4.375 <= y <= 4.5, degree 10, 60.3 bits */
        {
         13.202952134902061, 2.1931517093587925e-16, 3.3293086703546497, 0.003356476326100383,
         -0.001867592805818019, 0.0007805735377207463, -0.00026180453667373559, 7.3625466162130707e-05,
         -1.7963465157785812e-05, 3.9256212414612836e-06, -7.9657895643249611e-07, 1.5661012617011723e-07
        },
        /* [20] 4.5 <= y <= 4.625, degree 10, 59.7 bits */
        {
         13.619164698849382, -4.0957690896030815e-16, 3.3300660376846576, 0.00272445294154192,
         -0.0015154840351234182, 0.00063303784669639976, -0.00021207367813354, 5.9501861106007177e-05,
         -1.4451427321177752e-05, 3.1305465769179841e-06, -6.2510360979484917e-07, 1.1962862188027324e-07
        },
        /* [21] 4.625 <= y <= 4.75, degree 10, 61.3 bits */
        {
         14.035462711505971, 6.2870248362745005e-16, 3.3306808098559095, 0.0022115606272847983,
         -0.0012298956624114325, 0.00051350084604064104, -0.0001718650951264602, 4.8129779042182211e-05,
         -1.1646093529384827e-05, 2.5047569950398742e-06, -4.9348763544501889e-07, 9.2283254421591977e-08
        },
        /* [22] 4.75 <= y <= 4.875, degree 10, 60.0 bits */
        {
         14.4518300865325, 7.5799265301447825e-16, 3.3311798590937944, 0.0017953027702595119,
         -0.00099821447834551346, 0.00041661043912247394, -0.00013932967256411662, 3.8958842017950748e-05,
         -9.3985113332244826e-06, 2.0094934806498658e-06, -3.9153441204842379e-07, 7.1793679553010991e-08
        },
        /* [23] 4.875 <= y <= 5, degree 10, 60.0 bits */
        {
         14.868253768491137, 6.3905376859547281e-16, 3.3315849850616464, 0.0014574451433103112,
         -0.00081023468714884375, 0.00033805078839124595, -0.00011298614969301361, 3.1553587930591406e-05,
         -7.5933489950970672e-06, 1.6157340724047686e-06, -3.1193529513044001e-07, 5.6258127030035931e-08
        },
        /* [24] 5 <= y <= 5.125, degree 10, 61.9 bits */
        {
         15.284723160915291, 3.7197840746559583e-16, 3.3319138752766229, 0.001183203490024783,
         -0.00065769303692642339, 0.0002743371975011208, -9.1644982471155055e-05, 2.5567880437514288e-05,
         -6.1405956959354804e-06, 1.3014868332481205e-06, -2.4937249821196737e-07, 4.4354313752769971e-08
        },
        /* [25] 5.125 <= y <= 5.25, degree 10, 60.1 bits */
        {
         15.701229662597441, 3.9340444429579445e-16, 3.3321808826985433, 0.00096058760428563113,
         -0.00053389554546831922, 0.00022265310610039034, -7.4348945788622496e-05, 2.0725529873398626e-05,
         -4.9695273709682107e-06, 1.0499096054308301e-06, -1.9992224160136241e-07, 3.5149158027327576e-08
        },
        /* [26] 5.25 <= y <= 5.375, degree 10, 62.1 bits */
        {
         16.11776629151781, 9.4816291291591555e-16, 3.3323976556314796, 0.00077987119872832428,
         -0.00043341715622172936, 0.00018072004876856304, -6.0326478711454915e-05, 1.6805460322930363e-05,
         -4.0242575052929405e-06, 8.479842519976386e-07, -1.6065124520561067e-07, 2.7974404375961012e-08
        },
        /* [27] 5.375 <= y <= 5.5, degree 10, 60.6 bits */
        {
         16.534327379783669, 2.5557242944819292e-16, 3.332573648209487, 0.00063316307048182617,
         -0.00035185966852524687, 0.00014669357965278561, -4.8954828022767796e-05, 1.3630249987811949e-05,
         -3.2604132873113686e-06, 6.8556786720243067e-07, -1.2934080637190721e-07, 2.2344021137345722e-08
        },
        /* [28] 5.5 <= y <= 5.625, degree 10, 60.0 bits */
        {
         16.950908326127276, -4.0842445423766407e-16, 3.3327165342506828, 0.00051405996592575678,
         -0.00028565636748073108, 0.00011907975853867546, -3.9730791738242202e-05, 1.1057206148338359e-05,
         -2.6426229837305328e-06, 5.5470332664821288e-07, -1.0429543429935561e-07, 1.7899677887535523e-08
        },
        /* [29] 5.625 <= y <= 5.75, degree 10, 60.3 bits */
        {
         17.367505395073657, 5.6475250199043944e-16, 3.3328325428671812, 0.00041736542008575373,
         -0.0002319141677481344, 9.6667991091052978e-05, -3.2247401863601232e-05, 8.9713658308422931e-06,
         -2.1425967615458751e-06, 4.4911140277498727e-07, -8.4207413741413971e-08, 1.4374320653903494e-08
        },
        /* [30] 5.75 <= y <= 5.875, degree 10, 60.6 bits */
        {
         17.784115553959083, 8.1190328112168915e-16, 3.3329267306869275, 0.00033886192683883737,
         -0.00018828595173960681, 7.8476924909586716e-05, -2.6175278571091737e-05, 7.279974025497043e-06,
         -1.7376470613928035e-06, 3.6381241608516668e-07, -6.8059547186676254e-08, 1.1566630270536627e-08
        },
        /* [31] 5.875 <= y <= 6, degree 10, 60.2 bits */
        {
         18.200736340654121, -9.692211215338783e-16, 3.3330032027013359, 0.0002751262549155116,
         -0.00015286725004402287, 6.3710800091109845e-05, -2.1247678787901987e-05, 5.9081057703492738e-06,
         -1.4095381614539479e-06, 2.9484112795470303e-07, -5.5055017270683752e-08, 9.3228474520995651e-09
        },
        /* [32] 6 <= y <= 6.125, degree 10, 61.0 bits */
        {
         18.61736575619852, 1.6428867709973816e-15, 3.3330652914615007, 0.00022337969330321755,
         -0.00012411257206002349, 5.1724192376475496e-05, -1.7248479893731407e-05, 4.7951807652116082e-06,
         -1.1435853133860888e-06, 2.3902916373969452e-07, -4.4566171107182717e-08, 7.5244249425396935e-09
        },
        /* [33] 6.125 <= y <= 6.25, degree 10, 60.6 bits */
        {
         19.034002177650905, 8.2136094141657097e-16, 3.3331157024963658, 0.00018136658981689842,
         -0.00010076761631456348, 4.199350765067674e-05, -1.4002504173825096e-05, 3.892178863652388e-06,
         -9.2794529003476182e-07, 1.938373839761047e-07, -3.6096073199973402e-08, 6.0795688988032653e-09
        },
        /* [34] 6.25 <= y <= 6.375, degree 10, 60.5 bits */
        {
         19.450644287343582, -7.3925648390295604e-16, 3.3331566323318045, 0.00014725581762524913,
         -8.1814324709442182e-05, 3.4093916815003148e-05, -1.1367716078091274e-05, 3.1594088943020317e-06,
         -7.5305478859929787e-07, 1.572260781605107e-07, -2.9249292608664075e-08, 4.9166929475025498e-09
        },
        /* [35] 6.375 <= y <= 6.5, degree 10, 61.1 bits */
        {
         19.867291015452103, -1.6001629782071343e-15, 3.3331898642808393, 0.00011956082865177301,
         -6.6426332722952994e-05, 2.7680680718987965e-05, -9.2289219381043541e-06, 2.5647165584663131e-06,
         -6.1118366902757708e-07, 1.2755372376824634e-07, -2.3710025173764567e-08, 3.9792711138629879e-09
        },
        /* [36] 6.5 <= y <= 6.625, degree 10, 61.9 bits */
        {
         20.283941493372058, -1.0697285185289959e-15, 3.3332168461969673, 9.707477912798141e-05,
         -5.3932839079092765e-05, 2.2474021635531235e-05, -7.4926776052846253e-06, 2.0820422918636872e-06,
         -4.9607824165882133e-07, 1.0349712303358238e-07, -1.9225576173956867e-08, 3.2224269102027764e-09
        },
        /* [37] 6.625 <= y <= 6.75, degree 10, 60.8 bits */
        {
         20.700595015868402, -6.8080667372347645e-16, 3.3332387535902481, 7.8817880120706906e-05,
         -4.3789297414500969e-05, 1.8246862541711511e-05, -6.0831688980040176e-06, 1.6902588587695373e-06,
         -4.0267584273083576e-07, 8.3988059795258045e-08, -1.559323784891994e-08, 2.6107280206003751e-09
        },
        /* [38] 6.75 <= y <= 6.875, degree 10, 64.2 bits */
        {
         21.117251010346006, -1.4654966457172014e-15, 3.3332565408638875, 6.3994665621423699e-05,
         -3.5553637696573549e-05, 1.4814887158931464e-05, -4.9388767391569711e-06, 1.3722330235025347e-06,
         -3.268758682360752e-07, 6.8163241220396134e-08, -1.2649773833354261e-08, 2.11609345255715e-09
        },
        /* [39] 6.875 <= y <= 7, degree 10, 62.4 bits */
        {
         21.533909011901219, -6.3606004237141372e-16, 3.3332709829087177, 5.1959307571874675e-05,
         -2.8866971328508753e-05, 1.2028479196577854e-05, -4.0098760784666933e-06, 1.1140672837351419e-06,
         -2.6535544652275251e-07, 5.5324583489306168e-08, -1.0263523544706002e-08, 1.7158147068950812e-09
        },
        /* [40] 7 <= y <= 7.125, degree 10, 62.8 bits */
        {
         21.950568643066582, -1.0041622299923279e-15, 3.3332827088710668, 4.2187460871985562e-05,
         -2.3437932699313697e-05, 9.7661840011133835e-06, -3.255647147739111e-06, 9.0448671557982154e-07,
         -2.1542080790737049e-07, 4.4907162574662434e-08, -8.3284618722007494e-09, 1.391496078829686e-09
        },
        /* [41] 7.125 <= y <= 7.25, degree 10, 60.6 bits */
        {
         22.367229597365647, -7.0695212877258952e-16, 3.3332922295673546, 3.425340793153834e-05,
         -1.9029970652150853e-05, 7.9294040970981836e-06, -2.6433011426910979e-06, 7.3434277787944113e-07,
         -1.7488755849300389e-07, 3.6453308622805698e-08, -6.7590697140848826e-09, 1.128641816093283e-09
        },
        /* [42] 7.25 <= y <= 7.375, degree 10, 61.9 bits */
        {
         22.783891625961097, -1.4504038729680601e-15, 3.3332999597411743, 2.781150453976293e-05,
         -1.5451033347206285e-05, 6.4380951422654218e-06, -2.1461414453729278e-06, 5.9621136201773119e-07,
         -1.4198408249213087e-07, 2.9592120910670407e-08, -5.4859399081446322e-09, 9.1576045791005015e-10
        },
        /* [43] 7.375 <= y <= 7.5, degree 10, 61.4 bits */
        {
         23.200554526814216, -6.8182542786207129e-16, 3.333306236133426, 2.2581117096072008e-05,
         -1.254519524743854e-05, 5.2272731808973548e-06, -1.742496726091232e-06, 4.8406707167750453e-07,
         -1.1527320109526086e-07, 2.4023169083222708e-08, -4.4527930050747543e-09, 7.4320354262273446e-10
        },
        /* [44] 7.5 <= y <= 7.625, degree 10, 61.6 bits */
        {
         23.61721813588332, -5.864506592822887e-16, 3.3333113321533197, 1.833439392281261e-05,
         -1.0185860230804576e-05, 4.2441799552250958e-06, -1.414774328947111e-06, 3.9301935659989536e-07,
         -9.3588684419886445e-08, 1.9502911520201487e-08, -3.6143987323383992e-09, 6.0301496008083068e-10
        },
        /* [45] 7.625 <= y <= 7.75, degree 10, 60.6 bits */
        {
         24.03388231997759, -1.3450604833865932e-15, 3.3333154697897762, 1.4886337220405836e-05,
         -8.2702439255983466e-06, 3.4459821230830679e-06, -1.1486921465759839e-06, 3.1909859942047091e-07,
         -7.5984155356552888e-08, 1.5833561542549088e-08, -2.9341826799883312e-09, 4.8929342430233233e-10
        },
        /* [46] 7.75 <= y <= 7.875, degree 10, 61.9 bits */
        {
         24.450546970954939, 1.1573437540353437e-15, 3.333318829282379, 1.2086742699061362e-05,
         -6.714894355004041e-06, 2.7979037300076268e-06, -9.3265530600346231e-07, 2.5908244449681451e-07,
         -6.1691743021416674e-08, 1.2854688699859058e-08, -2.3820374662785627e-09, 3.9734658230281622e-10
        },
        /* [47] 7.875 <= y <= 8, degree 10, 60.9 bits */
        {
         24.867212001011143, -3.0558507330263052e-16, 3.3333215569733481, 9.8136554517810406e-06,
         -5.4520553971985722e-06, 2.271710239020066e-06, -7.572504000583143e-07, 2.1035493622360438e-07,
         -5.008815832667416e-08, 1.0436480108793209e-08, -1.9336209251265289e-09, 3.2260439711739774e-10
        },
        /* [48] 8 <= y <= 8.125, degree 10, 61.4 bits */
        {
         25.283877338854918, 1.0869882270739211e-15, 3.3333237716826911, 7.9680567910887949e-06,
         -4.4267144280946243e-06, 1.8444778571753279e-06, -6.1483495569860978e-07, 1.7079246744374358e-07,
         -4.0667274999908952e-08, 8.4734327028210877e-09, -1.5698237029962817e-09, 2.6154917353673465e-10
        },
        /* [49] 8.125 <= y <= 8.25, degree 10, 60.9 bits */
        {
         25.700542926602399, -1.4087589537247111e-15, 3.3333255698843209, 6.4695504615333551e-06,
         -3.5942053866308779e-06, 1.4975944830324126e-06, -4.9920410907584248e-07, 1.3867110662086509e-07,
         -3.3018437604155284e-08, 6.8795127728805151e-09, -1.2747361559627595e-09, 2.1242636593144076e-10
        },
        /* [50] 8.25 <= y <= 8.375, degree 10, 62.2 bits */
        {
         26.117208717255632, 1.4774037466731945e-15, 3.3333270299086712, 5.2528602258280765e-06,
         -2.9182627265767974e-06, 1.2159486702683432e-06, -4.0532013216068631e-07, 1.1259113010262445e-07,
         -2.680846885054032e-08, 5.5853878775941575e-09, -1.0347157770597397e-09, 1.7289061312662245e-10
        },
        /* [51] 8.375 <= y <= 8.5, degree 10, 62.0 bits */
        {
         26.533874672655337, 3.3789282407770114e-16, 3.3333282153549066, 4.2649862019595554e-06,
         -2.3694414238495742e-06, 9.8727113368437473e-07, -3.2909294930118781e-07, 9.1416114095242958e-08,
         -2.1766488750003908e-08, 4.535076376023993e-09, -8.3986916073063571e-10, 1.3980518511765454e-10
        },
        /* [52] 8.5 <= y <= 8.625, degree 10, 63.3 bits */
        {
         26.950540761818623, 4.3874774265756855e-16, 3.3333291778613958, 3.4628960368208142e-06,
         -1.9238341922227947e-06, 8.0160013220845421e-07, -2.6720176080091633e-07, 7.422364463157533e-08,
         -1.7672643965829898e-08, 3.6820888818735563e-09, -6.8245376433427716e-10, 1.1330705517872136e-10
        },
        /* [53] 8.625 <= y <= 8.75, degree 10, 61.1 bits */
        {
         27.367206959589382, 1.4883833043229591e-15, 3.3333299593551367, 2.8116503138680057e-06,
         -1.5620299711646219e-06, 6.5084749849385336e-07, -2.1695028051932967e-07, 6.0264642369203797e-08,
         -1.4349048231725351e-08, 2.9892107448768185e-09, -5.5376319109175185e-10, 9.3267441045331715e-11
        },
        /* [54] 8.75 <= y <= 8.875, degree 10, 61.3 bits */
        {
         27.783873245542473, -9.3138235585423551e-16, 3.3333305938781375, 2.2828805273710339e-06,
         -1.2682682908411935e-06, 5.2844623561255231e-07, -1.7614947281155994e-07, 4.8930763715270584e-08,
         -1.165049726210584e-08, 2.4275345922178707e-09, -4.4901222761190878e-10, 7.4270842986236821e-11
        },
        /* [55] 8.875 <= y <= 9, degree 10, 62.0 bits */
        {
         28.200539603093983, -7.4189250901277317e-16, 3.3333311090703104, 1.8535533086443784e-06,
         -1.0297527138953485e-06, 4.2906435967922401e-07, -1.4302196818494328e-07, 3.9728605721211405e-08,
         -9.4590753540102714e-09, 1.9707774189169238e-09, -3.6621032932212977e-10, 5.9993505467016524e-11
        },
        /* [56] 9 <= y <= 9.125, degree 10, 61.4 bits */
        {
         28.617206018778841, -1.036585130027042e-15, 3.3333315273734865, 1.5049670596822431e-06,
         -8.3609339090629167e-07, 3.4837272459369045e-07, -1.1612453066466111e-07, 3.2257061265986707e-08,
         -7.6805997043546634e-09, 1.5994777326772755e-09, -2.9534419921298938e-10, 5.2860239669139738e-11
        },
        /* [57] 9.125 <= y <= 9.25, degree 10, 62.2 bits */
        {
         29.033872481664268, 6.5902015822882561e-16, 3.3333318670089893, 1.2219372963224844e-06,
         -6.7885443339801068e-07, 2.8285634088956638e-07, -9.4285683296697115e-08, 2.6190423673465356e-08,
         -6.2357354051383297e-09, 1.3005681140509206e-09, -2.4056903669425617e-10, 3.3425862706186943e-11
        },
        /* [58] 9.25 <= y <= 9.375, degree 10, 61.1 bits */
        {
         29.450538982873553, -1.5803719947886607e-15, 3.3333321427713658, 9.921351992836168e-07,
         -5.5118647400196043e-07, 2.2966122560620984e-07, -7.6553871366987831e-08, 2.12653131198061e-08,
         -5.0630647445711487e-09, 1.0523984093294272e-09, -1.9832537469308094e-10, 4.3111482205410998e-11
        },
        /* [59] 9.375 <= y <= 9.5, degree 10, 61.0 bits */
        {
         29.867205515199363, -1.6730249805282978e-15, 3.3333323666728409, 8.0555055889782514e-07,
         -4.4752825323535239e-07, 1.8647026497231109e-07, -6.2156846878064134e-08, 1.7265383417393715e-08,
         -4.1114055489072735e-09, 8.6102186851277532e-10, -1.4919059107732028e-10, 8.3721867456174758e-12
        },
        /* [60] 9.5 <= y <= 9.625, degree 10, 61.9 bits */
        {
         30.283872072789809, -1.6439892696318761e-15, 3.3333325484665726, 6.5405573261686365e-07,
         -3.6336440708499562e-07, 1.514018950313608e-07, -5.0467326019375511e-08, 1.4019662730154341e-08,
         -3.3371402850811711e-09, 6.8342693213498755e-10, -1.546006533580062e-10, 7.7235127453170867e-11
        },
        /* [61] 9.625 <= y <= 9.75, degree 10, 61.3 bits */
        {
         30.700538650893527, 9.2091236905990043e-16, 3.3333326960715013, 5.3105159115344524e-07,
         -2.9502872694078933e-07, 1.2292873111630938e-07, -4.0976593741729675e-08, 1.1380404708685587e-08,
         -2.7061052173487195e-09, 6.1214004567501331e-10, -6.035492468058083e-11, -4.1236572251048246e-10
        },
        /* [62] 9.75 <= y <= 9.875, degree 10, 60.8 bits */
        {
         31.117205245652723, -5.9593812642934242e-16, 3.3333328159173021, 4.3118006788704038e-07,
         -2.395445369855046e-07, 9.9810396239352293e-08, -3.3269001353548265e-08, 9.237725695776113e-09,
         -2.2652481964921504e-09, 3.1819731881844524e-10, 1.0568640842285874e-09, 6.9424669033775647e-09
        },
        /* [63] 9.875 <= y <= 10, degree 10, 63.5 bits */
        {
         31.5338718539351, 2.846533688750161e-16, 3.3333329132244591, 3.500907534890428e-07,
         -1.9449490370913764e-07, 8.1040917185475963e-08, -2.6996343929077279e-08, 7.4620765290936913e-09,
         -4.3577785262488708e-09, -3.0021720132592029e-08, -2.4205076229870748e-07, -1.0738140188326988e-06
        }
    };
    return row[i];
}

/* duration beta^(2/3) at zero force, beta > exp(2): 32 rows of degree 10 in y = ln(beta), nodes 2.125 + i 0.25, 2 <= y <= 10.
 * Relative error of the approximation: 2^-57.7 at most, proved for the whole cell of each row. */
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_FIRST 2.125
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_STEP 0.25
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_PER_UNIT 4.0
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_ROWS 32
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_END 10.0
COR_INLINE const double *cor_rows_tail_duration_zero_force(int i)
{
    static const double row[32][12] = {
        /* [0] 2 <= y <= 2.25, degree 10, 57.7 bits */
        {
         7.1163922571952449, 1.6416536329118285e-16, 2.521835045630425, 0.16012942065521507,
         -0.030840255875556038, 0.000692079128391557, 0.00083114538297081797, -7.9166875278487595e-05,
         -2.6365271155673729e-05, 2.944629939027579e-06, 1.8071607009454084e-06, -3.7886930707424623e-07
        },
        /* [1] 2.25 <= y <= 2.5, degree 10, 58.6 bits */
        {
         7.7563807226096513, 2.7614647271167711e-17, 2.596176188979999, 0.13738346933993434,
         -0.029656859964338818, 0.0016433804358746728, 0.0006811570954553583, -0.00011811772254500096,
         -1.719315779380196e-05, 5.8082443395352331e-06, 7.0525656028221626e-07, -4.5518158234361617e-07
        },
        /* [2] 2.5 <= y <= 2.75, degree 10, 59.1 bits */
        {
         8.4135549031029218, 4.9050803149869019e-16, 2.6594225589702507, 0.11585629021745793,
         -0.027626689941784393, 0.0023763410130459716, 0.00048673460273410905, -0.00013747660300500201,
         -4.8036373803744941e-06, 6.2041865826992287e-06, -2.9315700998804722e-07, -3.2234495728405255e-07
        },
        /* [3] 2.75 <= y <= 3, degree 10, 58.1 bits */
        {
         9.0852296180990137, 8.5992396225794154e-16, 2.7123279168043508, 0.096095340696069703,
         -0.024989426946298306, 0.0028548928974133853, 0.00027942648524152908, -0.00013564705502820354,
         6.4242855767474488e-06, 4.8119281968456674e-06, -8.5807637603138548e-07, -1.2982690781718858e-07
        },
        /* [4] 3 <= y <= 3.25, degree 10, 61.4 bits */
        {
         9.7689384884455635, 1.4319895327163189e-16, 2.7558731763537976, 0.078459730317856607,
         -0.022001159159537306, 0.0030817247052141103, 8.8150006288464867e-05, -0.00011719076075399183,
         1.3950071599600754e-05, 2.6710260514636397e-06, -9.7597307920634286e-07, 2.4669834205715618e-08
        },
        /* [5] 3.25 <= y <= 3.5, degree 10, 59.3 bits */
        {
         10.462478843915612, 7.366115016613655e-16, 2.7911714919914075, 0.063121716727359389,
         -0.018898929267231544, 0.0030902869785387455, -6.7460081427503569e-05, -8.9348976672579331e-05,
         1.7188078471322565e-05, 6.3564781220659971e-07, -7.9699958625841973e-07, 1.0628793702514867e-07
        },
        /* [6] 3.5 <= y <= 3.75, degree 10, 60.8 bits */
        {
         11.163933513235772, 1.0204710495049171e-16, 2.8193801325239871, 0.050090956623392031,
         -0.0158763572412257, 0.0029316783483543133, -0.0001787328512637252, -5.9111143631130742e-05,
         1.6880115101919601e-05, -8.3079887143675219e-07, -4.991107248195434e-07, 1.2331793242066916e-07
        },
        /* [7] 3.75 <= y <= 4, degree 10, 61.1 bits */
        {
         11.87167242698297, 1.7252142570481848e-16, 2.8416282148976957, 0.039252017003948023,
         -0.013072606102954425, 0.0026617945722499357, -0.0002461870823958153, -3.1580612368989209e-05,
         1.4320760025004239e-05, -1.6207052393159027e-06, -2.1290763639993753e-07, 1.0149884318013326e-07
        },
        /* [8] 4 <= y <= 4.25, degree 10, 59.8 bits */
        {
         12.58433862265627, -3.02140975065684e-16, 2.8589645021891839, 0.030405700441860639,
         -0.010572681759156771, 0.0023318212140900846, -0.00027626109219052933, -9.5566553240025585e-06,
         1.0775648635201979e-05, -1.8456282122421968e-06, -3.0562049252711839e-09, 6.5714660503544279e-08
        },
        /* [9] 4.25 <= y <= 4.5, degree 10, 62.3 bits */
        {
         13.300823743515503, 3.4640485125825467e-16, 2.8723252792019065, 0.023307104726870236,
         -0.0084151374869102583, 0.0019829265415804839, -0.00027805452656224212, 6.115549579650493e-06,
         7.1851487532606102e-06, -1.6997163674051324e-06, 1.1775946272486104e-07, 3.2119736908165295e-08
        },
        /* [10] 4.5 <= y <= 4.75, degree 10, 61.0 bits */
        {
         14.0202377470135, -3.9058705044100169e-16, 2.8825195427429233, 0.017696397389924939,
         -0.0066031918921130089, 0.0016445722990650847, -0.00026087304610936514, 1.5891899258509323e-05,
         4.0988657355113493e-06, -1.3688985993338534e-06, 1.6545985960380809e-07, 7.7696697686045022e-09
        },
        /* [11] 4.75 <= y <= 5, degree 10, 61.8 bits */
        {
         14.741876656124278, 5.8082448281255677e-16, 2.8902274330261908, 0.013320962904581447,
         -0.0051162100597590071, 0.0013352675621770805, -0.00023277047920236421, 2.0890336668367048e-05,
         1.7404355131306884e-06, -9.8983984894144192e-07, 1.6515908858534125e-07, -6.4696579620746684e-09
        },
        /* [12] 5 <= y <= 5.25, degree 10, 59.3 bits */
        {
         15.465191127546101, -8.4110072461831731e-16, 2.8960076579342786, 0.0099494136354249061,
         -0.0039197086647112644, 0.0010645902355832962, -0.00019993736371144426, 2.2414099338419783e-05,
         1.1660817952349289e-07, -6.4362233802507493e-07, 1.3983207153407786e-07, -1.2709359864138856e-08
        },
        /* [13] 5.25 <= y <= 5.5, degree 10, 59.0 bits */
        {
         16.189757603708284, -3.4724592454031272e-16, 2.900310182476785, 0.0073789248782933662,
         -0.0029730913581502419, 0.0008355860681406622, -0.00016666072702350355, 2.1664573958088628e-05,
         -8.8084490014939907e-07, -3.6662762337779877e-07, 1.0591882249789875e-07, -1.379421293245065e-08
        },
        /* [14] 5.5 <= y <= 5.75, degree 10, 59.9 bits */
        {
         16.915252984063599, 1.689644516564446e-15, 2.9034912845937297, 0.0054376594581229719,
         -0.0022350364712923959, 0.00064700106660413065, -0.00013559200428608708, 1.9609346088609544e-05,
         -1.4011790041102533e-06, -1.660448321178586e-07, 7.311256562251691e-08, -1.2166158373096126e-08
        },
        /* [15] 5.75 <= y <= 6, degree 10, 62.2 bits */
        {
         17.641433136116802, -2.0090203858708848e-17, 2.9058289467021772, 0.0039839405213079188,
         -0.0016668517228679168, 0.00049509153705720439, -0.00010812924594973555, 1.6953047447121507e-05,
         -1.5904802948813195e-06, -3.3458304173263778e-08, 4.5931359789818011e-08, -9.5081825812790285e-09
        },
        /* [16] 6 <= y <= 6.25, degree 10, 60.7 bits */
        {
         18.368115156914616, 6.8220862030916361e-16, 2.907537310192295, 0.0029035264520383785,
         -0.0012342615413032071, 0.00037494969902790296, -8.4796093604175998e-05, 1.4164046369287952e-05,
         -1.5706638775855047e-06, 4.5657323562119026e-08, 2.5604353082123426e-08, -6.7943752847834998e-09
        },
        /* [17] 6.25 <= y <= 6.5, degree 10, 61.3 bits */
        {
         19.095163054730879, -8.7542405431418641e-16, 2.9087795078955812, 0.0021059851211101361,
         -0.00090809490164860595, 0.00028138971951336658, -6.5560554669943414e-05, 1.1523678923591215e-05,
         -1.4334015036959925e-06, 8.6369249916480928e-08, 1.1613440813835991e-08, -4.483319661605835e-09
        },
        /* [18] 6.5 <= y <= 6.75, degree 10, 60.3 bits */
        {
         19.822476404673885, -1.7486643468193604e-16, 2.9096786041554594, 0.0015208376856081219,
         -0.00066427042206454532, 0.00020948341068137077, -5.0076122558926142e-05, 9.1782222430699056e-06,
         -1.2420933103452924e-06, 1.0161817970809133e-07, 2.7273237797974126e-09, -2.7164558429847282e-09
        },
        /* [19] 6.75 <= y <= 7, degree 10, 62.6 bits */
        {
         20.54998150040139, -9.3509212584323076e-16, 2.9103266386638453, 0.0010938797666117761,
         -0.00048338061676129145, 0.00015484156173060449, -3.784939811285402e-05, 7.183947804671721e-06,
         -1.0372043053228433e-06, 1.0135581049429576e-07, -2.4060862000484727e-09, -1.4692460961954751e-09
        },
        /* [20] 7 <= y <= 7.25, degree 10, 59.9 bits */
        {
         21.277624544310299, -9.7335277430667372e-16, 2.9107919234030439, 0.00078389627149891197,
         -0.00035008626701600907, 0.00011372489262777284, -2.8347633679846333e-05, 5.5419880861899563e-06,
         -8.4225217042702509e-07, 9.2640182327059895e-08, -4.976511378440263e-09, -6.4837234515859524e-10
        },
        /* [21] 7.25 <= y <= 7.5, degree 10, 61.3 bits */
        {
         22.005366466437742, 9.6549754732976249e-16, 2.9111248155825149, 0.00055985716325726922,
         -0.00025245696597432448, 8.3050046864513978e-05, -2.106163567351871e-05, 4.223190296570741e-06,
         -6.6912885368246496e-07, 8.013695751918792e-08, -5.9145064769880101e-09, -1.4598829238668e-10
        },
        /* [22] 7.5 <= y <= 7.75, degree 10, 59.7 bits */
        {
         22.733179021603636, 1.280687389103175e-16, 2.9113622113909181, 0.00039860159069675968,
         -0.00018133791654142864, 6.0337492532507883e-05, -1.5537897061265088e-05, 3.1846219575478968e-06,
         -5.2228919061668967e-07, 6.671498925702582e-08, -5.891745247555849e-09, 1.3461185143889591e-10
        },
        /* [23] 7.75 <= y <= 8, degree 10, 61.2 bits */
        {
         23.461041874912056, -1.4404770429291041e-15, 2.9115309967447285, 0.00028297324772375774,
         -0.00012978429328228019, 4.3632602735339956e-05, -1.1390953681068325e-05, 2.379770149288882e-06,
         -4.0178851053732207e-07, 5.3986502918004679e-08, -5.3625727876841907e-09, 2.6999599801430038e-10
        },
        /* [24] 8 <= y <= 8.25, degree 10, 60.2 bits */
        {
         24.18894044191979, 1.3157847953974263e-15, 2.9116506666546567, 0.00020034897458328933,
         -9.2579446011060667e-05, 3.1419333400591428e-05, -8.303978180989828e-06, 1.7643099109190108e-06,
         -3.0534564917451807e-07, 4.2737689065342417e-08, -4.6160971214328139e-09, 3.1611098020266595e-10
        },
        /* [25] 8.25 <= y <= 8.5, degree 10, 59.7 bits */
        {
         24.91686429887568, -1.7275466210204362e-15, 2.9117352938532535, 0.00014149654129892738,
         -6.5838253728520022e-05, 2.2537549667460519e-05, -6.0230778804794166e-06, 1.2989478503131181e-06,
         -2.2966081741978514e-07, 3.3244842046648659e-08, -3.824247003202324e-09, 3.1140018842164065e-10
        },
        /* [26] 8.5 <= y <= 8.75, degree 10, 61.5 bits */
        {
         25.644806019609103, -1.3692957959649311e-15, 2.9117949956441986, 9.9699945663096667e-05,
         -4.6688863557104294e-05, 1.6109505822697412e-05, -4.3488031279573842e-06, 9.5045244153171943e-07,
         -1.7120280667097743e-07, 2.5492434975938786e-08, -3.0804624587082488e-09, 2.808836440475914e-10
        },
        /* [27] 8.75 <= y <= 9, degree 10, 60.5 bits */
        {
         26.372760329156112, 1.4911432270925508e-15, 2.9118370186501754, 7.0097209454805351e-05,
         -3.3022416958982881e-05, 1.1477530269031852e-05, -3.1269706417195431e-06, 6.916409101174131e-07,
         -1.2663945974239073e-07, 1.931555137556993e-08, -2.4283679270614479e-09, 2.3996791124041636e-10
        },
        /* [28] 9 <= y <= 9.25, degree 10, 60.0 bits */
        {
         27.100723490860819, -1.7747732635913027e-15, 2.911866535668985, 4.9183937026780542e-05,
         -2.3299411296800276e-05, 8.1529692184069405e-06, -2.2399600851099784e-06, 5.00827447508446e-07,
         -9.3040935199444993e-08, 1.4487913186684916e-08, -1.8817815829639938e-09, 1.9753429368769902e-10
        },
        /* [29] 9.25 <= y <= 9.5, degree 10, 64.8 bits */
        {
         27.828692864497707, 1.4023131745654464e-15, 2.9118872275915897, 3.4444280577308028e-05,
         -1.6401873857933061e-05, 5.7754029689581395e-06, -1.599037195651542e-06, 3.610459168762301e-07,
         -6.7946493972354231e-08, 1.0772853246870697e-08, -1.4379947231665039e-09, 1.5824211235815697e-10
        },
        /* [30] 9.5 <= y <= 9.75, degree 10, 59.9 bits */
        {
         28.556666588966628, 1.0234877133262182e-15, 2.9119017061164727, 2.4078633925404492e-05,
         -1.1521771061264544e-05, 4.0807054510930738e-06, -1.1378919061274412e-06, 2.5922923827210644e-07,
         -4.9355217308495468e-08, 7.9502372661415483e-09, -1.0861742128660827e-09, 1.2415148824614316e-10
        },
        /* [31] 9.75 <= y <= 10, degree 10, 60.1 bits */
        {
         29.28464335527212, 1.2206186308803115e-15, 2.9119118193593123, 1.6804003653382857e-05,
         -8.077573305182259e-06, 2.8764232793651957e-06, -8.0737540491227516e-07, 1.8544234756143029e-07,
         -3.5679005703290811e-08, 5.8285071289535247e-09, -8.1215841925858469e-10, 9.7074777938217776e-11
        }
    };
    return row[i];
}

/* largest overlap beta^(2/3), beta > exp(2): 32 rows of degree 10 in y = ln(beta), nodes 2.125 + i 0.25, 2 <= y <= 10.
 * Relative error of the approximation: 2^-60.3 at most, proved for the whole cell of each row. */
#define COR_ROWS_TAIL_MAX_OVERLAP_FIRST 2.125
#define COR_ROWS_TAIL_MAX_OVERLAP_STEP 0.25
#define COR_ROWS_TAIL_MAX_OVERLAP_PER_UNIT 4.0
#define COR_ROWS_TAIL_MAX_OVERLAP_ROWS 32
#define COR_ROWS_TAIL_MAX_OVERLAP_END 10.0
COR_INLINE const double *cor_rows_tail_max_overlap(int i)
{
    static const double row[32][12] = {
        /* [0] 2 <= y <= 2.25, degree 10, 61.0 bits */
        {
         1.2216815339498734, -8.3054146062317437e-17, 0.099646472078228257, -0.04698481679807967,
         0.0095696475039835187, 0.00080797947792307482, -0.00096160194575996901, 0.00018259446158077586,
         2.7319103295113793e-05, -2.011174142644828e-05, 2.8103846852772187e-06, 7.8051611590603588e-07
        },
        /* [1] 2.25 <= y <= 2.5, degree 10, 60.3 bits */
        {
         1.2438083897179266, 4.8858415856121845e-17, 0.077981197186178283, -0.039643710842637882,
         0.0098363843902952858, -0.00021301980867756659, -0.00066791126159677504, 0.00019938931146191942,
         -5.5520042090634138e-06, -1.2474602560604936e-05, 3.5956938814820395e-06, -7.5931538642347832e-08
        },
        /* [2] 2.5 <= y <= 2.75, degree 10, 61.6 bits */
        {
         1.2609782143906214, -1.208129558594106e-17, 0.059978458165177384, -0.032439174459344224,
         0.009266860756321103, -0.00086699326670135592, -0.00038529710185940784, 0.00017242241023611619,
         -2.2778271407355084e-05, -5.0424709063902007e-06, 2.8456403277560923e-06, -4.4901942775069933e-07
        },
        /* [3] 2.75 <= y <= 3, degree 10, 61.7 bits */
        {
         1.2740864529068943, -9.990682000801114e-17, 0.045435664185212131, -0.025864746828079911,
         0.0082096038164426229, -0.0012004778510753729, -0.00015968593098102739, 0.00012708717613090664,
         -2.7344638478883222e-05, 2.2909239354246768e-08, 1.6510634561315522e-06, -4.6536791874346666e-07
        },
        /* [4] 3 <= y <= 3.25, degree 10, 61.5 bits */
        {
         1.2839522813905433, -7.792729169707374e-17, 0.033965140895483775, -0.020175784881121976,
         0.006945330248911679, -0.0012957089654646464, -4.2231196189245696e-06, 8.1075644887700646e-05,
         -2.4406452357604858e-05, 2.5369116053404648e-06, 6.458778808867293e-07, -3.2750211098021249e-07
        },
        /* [5] 3.25 <= y <= 3.5, degree 10, 62.4 bits */
        {
         1.2912860537022723, 1.822413049099841e-17, 0.025098868241090342, -0.015449069371459569,
         0.0056691308421461086, -0.0012375694412984227, 8.7819495580378418e-05, 4.3406453090283761e-05,
         -1.8423402181118029e-05, 3.213564168335833e-06, 2.4215391343011519e-08, -1.7410711746470156e-07
        },
        /* [6] 3.5 <= y <= 3.75, degree 10, 63.9 bits */
        {
         1.2966790451236039, -1.4300654133405171e-17, 0.018361887138178958, -0.011645400553143382,
         0.004497669326203122, -0.0010963033157633504, 0.0001315338490500896, 1.6696944183075854e-05,
         -1.2212777144573498e-05, 2.8910529126289004e-06, -2.6135861366587717e-07, -6.2866321322003679e-08
        },
        /* [7] 3.75 <= y <= 4, degree 10, 63.2 bits */
        {
         1.3006078048470504, 7.6437326960948507e-17, 0.013316628259268957, -0.0086619631092077227,
         0.0034872750816389111, -0.00092215589119829639, 0.00014293824982970288, 6.0761237657626707e-10,
         -7.103459805513969e-06, 2.1927823953819333e-06, -3.3177114216884175e-07, -7.3697561659617432e-10
        },
        /* [8] 4 <= y <= 4.25, degree 10, 63.2 bits */
        {
         1.3034466149061597, -7.1778253717639112e-17, 0.0095846566910105738, -0.0063701125343788223,
         0.0026535977432436317, -0.00074680827499520549, 0.00013537233455405823, -9.0239052351922288e-06,
         -3.4505465994580606e-06, 1.4743772518281367e-06, -2.9533614836534712e-07, 2.5280968057404623e-08
        },
        /* [9] 4.25 <= y <= 4.5, degree 10, 64.6 bits */
        {
         1.3054833220976616, 8.534300217510236e-17, 0.0068530603833686201, -0.0046394054626666846,
         0.0019881802183478246, -0.00058757161685377851, 0.00011845894376550993, -1.284758211275907e-05,
         -1.1146089186006904e-06, 8.8913420124744126e-07, -2.2258983734973728e-07, 3.0593549870614094e-08
        },
        /* [10] 4.5 <= y <= 4.75, degree 10, 64.5 bits */
        {
         1.3069355069570328, 9.2583642350884436e-17, 0.0048716550892599934, -0.0033508704815643836,
         0.0014705224666504439, -0.00045193480528563058, 9.8400545253047268e-05, -1.3509522198585042e-05,
         2.1918085225096602e-07, 4.7195767753671188e-07, -1.5007746612579842e-07, 2.6545621787415367e-08
        },
        /* [11] 4.75 <= y <= 5, degree 10, 65.1 bits */
        {
         1.3079652956835495, -6.7939501191060101e-17, 0.0034455401993507286, -0.0024028632625817613,
         0.0010759191652716048, -0.00034136752749454183, 7.8769344533167421e-05, -1.2476178659473202e-05,
         8.7233424829382412e-07, 2.0295562991797922e-07, -9.2090671715250077e-08, 1.9724574840427334e-08
        },
        /* [12] 5 <= y <= 5.25, degree 10, 65.2 bits */
        {
         1.3086920534827819, -3.9990618518974014e-17, 0.0024259748802266646, -0.0017123409395304091,
         0.00078001228727417262, -0.00025408007012210241, 6.1336894368765513e-05, -1.0700107539817218e-05,
         1.1050487915949857e-06, 4.510022155526797e-08, -5.1116693050368687e-08, 1.3242397382008226e-08
        },
        /* [13] 5.25 <= y <= 5.5, degree 10, 65.6 bits */
        {
         1.3092027784407649, 8.3066752415071338e-17, 0.0017013139042239107, -0.0012136319531183336,
         0.00056107658484291702, -0.00018682929027870926, 4.6754479213384469e-05, -8.7443896969328954e-06,
         1.1026456355849541e-06, -3.7614913101461019e-08, -2.465890824736502e-08, 8.1853491678954981e-09
        },
        /* [14] 5.5 <= y <= 5.75, degree 10, 66.1 bits */
        {
         1.3095603355299241, 8.808552450415567e-17, 0.0011888867563985192, -0.00085607017059349756,
         0.0004008844691467012, -0.00013599397031007209, 3.5041942662953317e-05, -6.9068218078932578e-06,
         9.8554708107633263e-07, -7.3603606987767712e-08, -8.8993822003685125e-09, 4.6571413864027095e-09
        },
        /* [15] 5.75 <= y <= 6, degree 10, 66.1 bits */
        {
         1.3098098180201572, 1.0512384614325108e-16, 0.00082816347650087557, -0.00060131425887342653,
         0.00028476389859589181, -9.8148713924583699e-05, 2.5907511644415035e-05, -5.3191664921030058e-06,
         8.259092450898076e-07, -8.2838920306265533e-08, -3.1837021549334658e-10, 2.3857376000032435e-09
        },
        /* [16] 6 <= y <= 6.25, degree 10, 66.3 bits */
        {
         1.3099833668414309, -3.7079973769809488e-17, 0.00057524149358717828, -0.00042079435169846229,
         0.00020125353680778017, -7.0321951367340166e-05, 1.8940657897683981e-05, -4.0174906621830611e-06,
         6.6329135102115341e-07, -7.8254285493721763e-08, 3.7888039901293816e-09, 1.0223506288173396e-09
        },
        /* [17] 6.25 <= y <= 6.5, degree 10, 66.7 bits */
        {
         1.3101037650144456, -2.443804196944289e-17, 0.00039853172457083056, -0.00029348777620906912,
         0.00014160052019490256, -5.0070673458486101e-05, 1.3718603526319439e-05, -2.9879993434699757e-06,
         5.1682742426999146e-07, -6.7654005750908244e-08, 5.2969474178813461e-09, 2.6246684184439709e-10
        },
        /* [18] 6.5 <= y <= 6.75, degree 10, 66.7 bits */
        {
         1.3101870845772496, -9.9431065332174106e-17, 0.00027545980153029665, -0.00020408528657971675,
         9.9237294541171156e-05, -3.5458865178720995e-05, 9.8583980614338782e-06, -2.1948489518869078e-06,
         3.9372254420532346e-07, -5.541292060989124e-08, 5.4140778558755778e-09, -1.2161632639712856e-10
        },
        /* [19] 6.75 <= y <= 7, degree 10, 66.7 bits */
        {
         1.3102446153834519, 1.6179423106402701e-17, 0.00018998830483424439, -0.00014153491245942002,
         6.9304946703296539e-05, -2.4992714796822122e-05, 7.0370262566692688e-06, -1.5958331033507281e-06,
         2.947564483284149e-07, -4.3759857806793681e-08, 4.8719253151287644e-09, -2.8544347860992592e-10
        },
        /* [20] 7 <= y <= 7.25, degree 10, 66.8 bits */
        {
         1.3102842582894612, 6.4101670058682627e-17, 0.00013078205579612626, -9.7916684798712272e-05,
         4.8249678858774179e-05, -1.7542711762484101e-05, 4.9941796286845125e-06, -1.1504394985163186e-06,
         2.1763275341215173e-07, -3.3659983396777254e-08, 4.0869076793385156e-09, -3.2862615085213091e-10
        },
        /* [21] 7.25 <= y <= 7.5, degree 10, 66.8 bits */
        {
         1.3103115239946692, -9.4021806997814727e-17, 8.9865266456221448e-05, -6.7590768734425395e-05,
         3.3496812125430367e-05, -1.226822420775414e-05, 3.5266415996595918e-06, -8.2339222908998815e-07,
         1.5889411443514368e-07, -2.5382597407572538e-08, 3.2785724779471586e-09, -3.1158898802205565e-10
        },
        /* [22] 7.5 <= y <= 7.75, degree 10, 66.7 bits */
        {
         1.3103302446054614, -3.9839416981942949e-17, 6.1648085096591317e-05, -4.6562859558168856e-05,
         2.3195829517625976e-05, -8.5515101069908678e-06, 2.4794302672987118e-06, -5.8569409975240755e-07,
         1.1493806187600117e-07, -1.8847000155769495e-08, 2.5498885975205114e-09, -2.6907289466654184e-10
        },
        /* [23] 7.75 <= y <= 8, degree 10, 66.8 bits */
        {
         1.3103430777635772, -1.0314540485824298e-16, 4.2226586106147392e-05, -3.2017477032758112e-05,
         1.6025667767813328e-05, -5.9433069786134789e-06, 1.736444673477206e-06, -4.1440163099257617e-07,
         8.2498133726530607e-08, -1.3822180626927423e-08, 1.9385914476487673e-09, -2.1983186901945238e-10
        },
        /* [24] 8 <= y <= 8.25, degree 10, 66.8 bits */
        {
         1.310351862102211, 8.8686144897063546e-17, 2.8882824907397065e-05, -2.1978326709486418e-05,
         1.1048699519417478e-05, -4.1196884587500155e-06, 1.2119283321863882e-06, -2.9184759181959041e-07,
         5.8824486192689911e-08, -1.0035154756751321e-08, 1.4484680501942653e-09, -1.7311937574146423e-10
        },
        /* [25] 8.25 <= y <= 8.5, degree 10, 66.8 bits */
        {
         1.3103578668221301, -2.0672197433173618e-17, 1.9729868437184216e-05, -1.5063281057131817e-05,
         7.6027859735143719e-06, -2.8487899094226236e-06, 8.4325510729311346e-07, -2.0470092891216859e-07,
         4.1707201918641899e-08, -7.2248207699094359e-09, 1.0675527515937582e-09, -1.3281041098247361e-10
        },
        /* [26] 8.5 <= y <= 8.75, degree 10, 66.8 bits */
        {
         1.3103619662755734, -1.026118380186336e-16, 1.3461039206952125e-05, -1.0308915186257004e-05,
         5.2223894587068463e-06, -1.9656703042823516e-06, 5.8511667016376591e-07, -1.4305938436676468e-07,
         2.9425893170786165e-08, -5.1648526380409027e-09, 7.7816923088819304e-10, -9.9911905007914944e-11
        },
        /* [27] 8.75 <= y <= 9, degree 10, 66.8 bits */
        {
         1.310364761687808, 5.0587349398807578e-17, 9.1735629343045314e-06, -7.0456375656949725e-06,
         3.5814668794151378e-06, -1.3536218282292686e-06, 4.0498921964203435e-07, -9.965907455690342e-08,
         2.067192585664162e-08, -3.670003927598707e-09, 5.6209762151176397e-10, -7.4030683783087468e-11
        },
        /* [28] 9 <= y <= 9.25, degree 10, 66.8 bits */
        {
         1.3103666657714028, -5.4586011216933564e-17, 6.2450274433098574e-06, -4.8093053916632671e-06,
         2.4524563886835747e-06, -9.30448749760763e-07, 2.7968044512031076e-07, -6.9225520451101696e-08,
         1.446723584904491e-08, -2.5942531190533113e-09, 4.0294658129101294e-10, -5.4194214324736231e-11
        },
        /* [29] 9.25 <= y <= 9.5, degree 10, 66.8 bits */
        {
         1.3103679613888117, 1.0817295267392206e-16, 4.2471376747664552e-06, -3.2789576884060169e-06,
         1.6770188886227546e-06, -6.3849781812778956e-07, 1.9274599485775258e-07, -4.7960996639813239e-08,
         1.0090850366045393e-08, -1.8255208438474219e-09, 2.8700029691426966e-10, -3.9283754730853221e-11
        },
        /* [30] 9.5 <= y <= 9.75, degree 10, 66.8 bits */
        {
         1.3103688421247714, -2.9217049375847494e-17, 2.8856936989746723e-06, -2.2331287903161808e-06,
         1.1452848871964938e-06, -4.3747612035026997e-07, 1.3258342208598196e-07, -3.3150427633021037e-08,
         7.0171836632070509e-09, -1.2794670484332684e-09, 2.032885028359827e-10, -2.8243709111046486e-11
        },
        /* [31] 9.75 <= y <= 10, degree 10, 66.8 bits */
        {
         1.3103694402856243, -1.0960442639223035e-16, 1.9589346361971536e-06, -1.5193093297558688e-06,
         7.8120727480279078e-07, -2.9931408306898669e-07, 9.1041715455455162e-08, -2.2864469572125588e-08,
         4.8665671753661759e-09, -8.9359217332189113e-10, 1.4333946861269702e-10, -1.9969821169978242e-11
        }
    };
    return row[i];
}

/* time of the largest overlap beta^(2/3), beta > exp(2): 32 rows of degree 10 in y = ln(beta), nodes 2.125 + i 0.25, 2 <= y <= 10.
 * Relative error of the approximation: 2^-58.3 at most, proved for the whole cell of each row. */
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_FIRST 2.125
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_STEP 0.25
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_PER_UNIT 4.0
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_ROWS 32
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_END 10.0
COR_INLINE const double *cor_rows_tail_time_of_max_overlap(int i)
{
    static const double row[32][12] = {
        /* [0] 2 <= y <= 2.25, degree 10, 60.6 bits */
        {
         3.6558234040539763, 2.9495945062350427e-17, 1.2973279442531338, 0.072846878981492919,
         -0.017263389469386596, 0.0013614285814057864, 0.00038801828185802104, -0.00011889603617834146,
         4.6526224383484173e-06, 3.6999476884177017e-06, -8.11565245434787e-07, 3.4667289215716513e-08
        },
        /* [1] 2.25 <= y <= 2.5, degree 10, 59.4 bits */
        {
         3.9844442479076601, 8.3356382841777659e-17, 1.3306064789781504, 0.060463652839741401,
         -0.015695782394203134, 0.0017384446549595462, 0.00021862870506902184, -0.00010531011545576697,
         1.0307864425634637e-05, 2.0035174546454128e-06, -6.8485590539828953e-07, 6.1101192854277005e-08
        },
        /* [2] 2.5 <= y <= 2.75, degree 10, 58.3 bits */
        {
         4.320636578605483, -4.3582187666406688e-16, 1.3580076705330442, 0.049371946635631332,
         -0.013852098954416405, 0.0019191061758796167, 7.5623991323466719e-05, -8.4612502451244913e-05,
         1.2892692051522181e-05, 6.4250992913141283e-07, -5.2220027288975907e-07, 6.739917774935418e-08
        },
        /* [3] 2.75 <= y <= 3, degree 10, 58.7 bits */
        {
         4.6630153543547959, 7.1331717932555525e-18, 1.3802173229655945, 0.039709663412615476,
         -0.011910381595522754, 0.0019414775298879066, -3.405129556619627e-05, -6.1555821185178263e-05,
         1.3129585206191971e-05, -3.4220493969233488e-07, -3.5342505213732718e-07, 6.6662468900076594e-08
        },
        /* [4] 3 <= y <= 3.25, degree 10, 58.3 bits */
        {
         5.0103729757570186, 3.101279221419242e-16, 1.397959296950515, 0.031496270177122601,
         -0.010007652735950067, 0.0018482514025002074, -0.00010960958137349447, -3.9587791194701557e-05,
         1.1772770707936707e-05, -9.5476953320733256e-07, -1.9423018543640066e-07, 5.9576195147948852e-08
        },
        /* [5] 3.25 <= y <= 3.5, degree 10, 58.4 bits */
        {
         5.361682051036464, 4.0135017531981912e-16, 1.4119441597207523, 0.024664413327488213,
         -0.0082387247161449084, 0.0016802821270545134, -0.00015445625412846783, -2.0864014155260337e-05,
         9.5328353578763774e-06, -1.2350248097324259e-06, -6.0805087306628288e-08, 4.6324840083165587e-08
        },
        /* [6] 3.5 <= y <= 3.75, degree 10, 59.9 bits */
        {
         5.7160872949608548, 2.5934047714582019e-16, 1.4228334998411734, 0.019090306249967614,
         -0.0066602628933942407, 0.0014725221665357548, -0.00017434014732631403, -6.3869737967030825e-06,
         7.005845299246169e-06, -1.2561177307840042e-06, 3.4728392899860491e-08, 2.9924379847818572e-08
        },
        /* [7] 3.75 <= y <= 4, degree 10, 61.3 bits */
        {
         6.0728903280890014, 1.0816529296764587e-16, 1.4312184551697935, 0.014619825191476641,
         -0.0052978091910910342, 0.0012521027605168589, -0.00017580064398907788, 3.742794338282571e-06,
         4.6207419428370265e-06, -1.1084722234535533e-06, 8.9576565647940069e-08, 1.438387810574105e-08
        },
        /* [8] 4 <= y <= 4.25, degree 10, 58.8 bits */
        {
         6.4315306232126348, 2.2065593008635388e-16, 1.4376098806571922, 0.011088844676981093,
         -0.0041538391538089069, 0.0010380963783104859, -0.00016504447493496171, 1.0016687486196484e-05,
         2.6265389114004632e-06, -8.7825010338434477e-07, 1.097729701504198e-07, 2.5050814828376309e-09
        },
        /* [9] 4.25 <= y <= 4.5, degree 10, 59.5 bits */
        {
         6.7915651389130103, -1.4743515721233432e-16, 1.4424371784196468, 0.0083375982729425365,
         -0.0032154520260437342, 0.00084239125541418704, -0.00014728624201021287, 1.3221034357728377e-05,
         1.1179227953412426e-06, -6.3189111081845774e-07, 1.0595467734251543e-07, -4.8249495328491526e-09
        },
        /* [10] 4.5 <= y <= 4.75, degree 10, 59.1 bits */
        {
         7.1526484420154759, 3.1297948893440285e-16, 1.4460529321536102, 0.006219686004704815,
         -0.00246086267970655, 0.00067112951730857599, -0.00012648951777388071, 1.4206036380098896e-05,
         8.1563814425040222e-08, -4.1089490105494288e-07, 8.9007369319033331e-08, -8.1667351630641353e-09
        },
        /* [11] 4.75 <= y <= 5, degree 10, 60.5 bits */
        {
         7.5145144559918702, 3.0429848972449788e-16, 1.4487409216891174, 0.0046067800154445228,
         -0.0018643592795561954, 0.00052627855570150112, -0.00010539119204464239, 1.3739639017010959e-05,
         -5.5580959727388643e-07, -2.3460491297606121e-07, 6.7456182690483514e-08, -8.72136373855367e-09
        },
        /* [12] 5 <= y <= 5.25, degree 10, 61.8 bits */
        {
         7.8769604357230438, -1.7036149252440048e-16, 1.4507256577701411, 0.003390189837456464,
         -0.001399744081367015, 0.00040706022554097565, -8.5685437181275478e-05, 1.2437888887613254e-05,
         -8.8929832956947516e-07, -1.0668671307249967e-07, 4.6706139782215203e-08, -7.7077796948304052e-09
        },
        /* [13] 5.25 <= y <= 5.5, degree 10, 60.2 bits */
        {
         8.2398333754118287, -3.4894528648008306e-16, 1.4521821397065029, 0.0024803509245415667,
         -0.0010424769295998163, 0.00031110380324160275, -6.8268014999243307e-05, 1.0750118542654507e-05,
         -1.0113564760424425e-06, -2.1851787020975273e-08, 2.9440976225286221e-08, -6.0574187046912204e-09
        },
        /* [14] 5.5 <= y <= 5.75, degree 10, 59.5 bits */
        {
         8.6030187947130461, 3.7021268651246498e-16, 1.4532450226262377, 0.0018050993365014039,
         -0.00077082012956089302, 0.00023529128193825152, -5.3476303238183357e-05, 8.9759306700964808e-06,
         -9.994144903209526e-07, 2.8927811453771857e-08, 1.6457492315983971e-08, -4.3516333269315999e-09
        },
        /* [15] 5.75 <= y <= 6, degree 10, 60.8 bits */
        {
         8.9664316940281203, 1.9758325185364012e-16, 1.4540167556678518, 0.0013073684663092789,
         -0.00056628130885519692, 0.00017632400397921445, -4.129174351993206e-05, 7.2958389571606037e-06,
         -9.1200607059841756e-07, 5.5120222849480612e-08, 7.478969549400489e-09, -2.8828331440588557e-09
        },
        /* [16] 6 <= y <= 6.25, degree 10, 62.0 bits */
        {
         9.3300093954968624, 8.2391771852363308e-18, 1.4545745171447655, 0.00094273632986387678,
         -0.00041360623575741181, 0.00013106627185856831, -3.1493748139805394e-05, 5.8039221772807718e-06,
         -7.8980240742142821e-07, 6.4945463661069129e-08, 1.7584198852833532e-09, -1.7505860521797647e-09
        },
        /* [17] 6.25 <= y <= 6.5, degree 10, 59.5 bits */
        {
         9.6937059657980118, -7.0390242783058569e-16, 1.4549759433597007, 0.00067708492996156012,
         -0.00030051423605731783, 9.6726230909151617e-05, -2.3767187196428116e-05, 4.5364268287042442e-06,
         -6.5884512790307398e-07, 6.4777312458024905e-08, -1.5506151033316317e-09, -9.4699184909174041e-10
        },
        /* [18] 6.5 <= y <= 6.75, degree 10, 62.0 bits */
        {
         10.057487929606111, -6.9027458753815324e-17, 1.4552637460780293, 0.00048451070008428976,
         -0.00021731143606317638, 7.0927317874591849e-05, -1.7771576057002114e-05, 3.494085504707838e-06,
         -5.3429081610736402e-07, 5.9161323877363367e-08, -3.2057539535086198e-09, -4.1657635996538951e-10
        },
        /* [19] 6.75 <= y <= 7, degree 10, 59.4 bits */
        {
         10.421331013079294, -6.0924977701643638e-16, 1.4554693609785767, 0.00034554223003022155,
         -0.00015646933222899468, 5.1712126011877211e-05, -1.3181605348615371e-05, 2.6581156957074634e-06,
         -4.2379680035602341e-07, 5.1111337008017311e-08, -3.8056526886341277e-09, -9.1807077541485099e-11
        },
        /* [20] 7 <= y <= 7.25, degree 10, 60.1 bits */
        {
         10.785217694631683, -7.4042513733590655e-16, 1.4556157835235106, 0.00024567005107851444,
         -0.0001122202727920726, 3.7508842980130816e-05, -9.707830673690061e-06, 2.0008782090342e-06,
         -3.3021399110379834e-07, 4.2481680320573218e-08, -3.784916958396715e-09, 8.9198452659792936e-11
        },
        /* [21] 7.25 <= y <= 7.5, degree 10, 59.8 bits */
        {
         11.149135378956579, 1.9634567376946715e-16, 1.4557197431243118, 0.00017416456320285068,
         -8.0196449660819758e-05, 2.7080447776897146e-05, -7.1045847648241096e-06, 1.4924685454215258e-06,
         -2.5355142415322431e-07, 3.4312422622140279e-08, -3.4382574288162214e-09, 1.7598153230895961e-10
        },
        /* [22] 7.5 <= y <= 7.75, degree 10, 59.9 bits */
        {
         11.513075046147668, -6.3984180536642967e-16, 1.455793350666073, 0.00012314477917380658,
         -5.7122828906339441e-05, 1.9469213668780161e-05, -5.170292223699632e-06, 1.1044383907685476e-06,
         -1.9231405761673295e-07, 2.7107761736572218e-08, -2.9531609272127926e-09, 2.049359022287699e-10
        },
        /* [23] 7.75 <= y <= 8, degree 10, 60.0 bits */
        {
         11.877030259079488, -7.8794142043844463e-16, 1.4558453345243199, 8.6856702665324224e-05,
         -4.0564780420125103e-05, 1.394364707013642e-05, -3.7437304481611605e-06, 8.1162010758968547e-07,
         -1.4435733516379203e-07, 2.1041577374742263e-08, -2.4408108038394815e-09, 2.0110974572079476e-10
        },
        /* [24] 8 <= y <= 8.25, degree 10, 62.0 bits */
        {
         12.240996438430825, -1.1121508778338133e-16, 1.455881959856359, 6.1121761144646469e-05,
         -2.8725967832612786e-05, 9.9513958853198959e-06, -2.6985103093688969e-06, 5.9277653297374713e-07,
         -1.0739631895092462e-07, 1.6099487386154258e-08, -1.9612678781987206e-09, 1.8078562225241538e-10
        },
        /* [25] 8.25 <= y <= 8.5, degree 10, 59.8 bits */
        {
         12.604970336037519, -1.7379857249954566e-16, 1.4559077071722861, 4.2920052896307515e-05,
         -2.0289739787589381e-05, 7.0794236360273483e-06, -1.9371378248886481e-06, 4.3057747217932532e-07,
         -7.9282499026445869e-08, 1.2171537514575868e-08, -1.542222097880879e-09, 1.5395300492148693e-10
        },
        /* [26] 8.5 <= y <= 8.75, degree 10, 59.7 bits */
        {
         12.968949654169437, 2.6132363020989583e-16, 1.4559257698949375, 3.0078537291666266e-05,
         -1.4296676123441497e-05, 5.0214562420350761e-06, -1.3854019340864473e-06, 3.112313433300805e-07,
         -5.8132950102081478e-08, 9.1092885397761825e-09, -1.1920885323720848e-09, 1.2633338051822388e-10
        },
        /* [27] 8.75 <= y <= 9, degree 10, 60.4 bits */
        {
         13.332932771500891, -5.935300963283604e-16, 1.4559384170477556, 2.1039711006166733e-05,
         -1.0051309534592132e-05, 3.5520422162431148e-06, -9.8744033839183963e-07, 2.2397509819798175e-07,
         -4.2371207168935982e-08, 6.7586681743746672e-09, -9.0868121804729237e-10, 1.0089612310067965e-10
        },
        /* [28] 9 <= y <= 9.25, degree 10, 60.0 bits */
        {
         13.696918546656118, 8.0573627086547767e-16, 1.4559472562425368, 1.4691256006929767e-05,
         -7.0518665467808642e-06, 2.5062879969039156e-06, -7.0159927680427759e-07, 1.6053989077871273e-07,
         -3.0719319136989002e-08, 4.9771428621124137e-09, -6.8467750479286643e-10, 7.8924726656759407e-11
        },
        /* [29] 9.25 <= y <= 9.5, degree 10, 59.9 bits */
        {
         14.060906177877262, 8.5745348707380352e-16, 1.4559534234759557, 1.0241398429119686e-05,
         -4.9378505773853961e-06, 1.7642760459098307e-06, -4.9707178404907233e-07, 1.1465434893794959e-07,
         -2.2166022016447611e-08, 3.6412508687799768e-09, -5.1087826109895608e-10, 6.0730587379205755e-11
        },
        /* [30] 9.5 <= y <= 9.75, degree 10, 60.1 bits */
        {
         14.424895103112712, 4.783801086632663e-16, 1.4559577195226381, 7.1282338084201144e-06,
         -3.4512563349467911e-06, 1.2392385404575932e-06, -3.5123411601290778e-07, 8.1612990508331346e-08,
         -1.5925967251006169e-08, 2.6485540853200563e-09, -3.7802338020143783e-10, 4.6108331321363851e-11
        },
        /* [31] 9.75 <= y <= 10, degree 10, 60.2 bits */
        {
         14.78888492909887, 4.5798891419475462e-16, 1.4559607075735739, 4.9540983894399003e-06,
         -2.4080750159367782e-06, 8.6867855252268429e-07, -2.4757511862349912e-07, 5.7917368534932236e-08,
         -1.1398355057326053e-08, 1.916616396975934e-09, -2.7805905025820435e-10, 3.3008021738607676e-11
        }
    };
    return row[i];
}

/* beta/(1 - eps) at zero overlap, 1 - eps < 1/2: 9 rows of degree 10 in y = 1 - eps, nodes 0 + i 0.0625, 0 <= y <= 0.53125.
 * Relative error of the approximation: 2^-57.1 at most, proved for the whole cell of each row. */
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_STEP 0.0625
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_PER_UNIT 16.0
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_ROWS 9
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_END 0.5
COR_INLINE const double *cor_rows_near_beta_zero_overlap(int i)
{
    static const double row[9][12] = {
        /* [0] 0 <= y <= 0.03125, degree 10, 59.8 bits */
        {
         0.86696518957614899, -6.870677073425355e-09, 0.52017910962328318, 0.3288147282840862,
         0.2209318209422112, 0.15768619027803757, 0.11897069548578144, 0.0941674207914657,
         0.077525778783228444, 0.06586967485939052, 0.056780173392195307, 0.058604244462708302
        },
        /* [1] 0.03125 <= y <= 0.09375, degree 10, 60.0 bits */
        {
         0.90081727504730225, -1.5477181223552097e-09, 0.56403363586657995, 0.37424889459260235,
         0.26550569493630116, 0.20112252972538486, 0.16166713793196016, 0.13664839181233057,
         0.12026577057601204, 0.10923429393957144, 0.1018726766490425, 0.096583759001709277
        },
        /* [2] 0.09375 <= y <= 0.15625, degree 10, 59.3 bits */
        {
         0.93759933114051819, 6.7554963386760357e-09, 0.61413572106809422, 0.42917359879113165,
         0.3228392969935614, 0.26080813591152846, 0.22449072435718065, 0.20365203186990344,
         0.19254507924320891, 0.1878905641557678, 0.18827719455131511, 0.1916631816028381
        },
        /* [3] 0.15625 <= y <= 0.21875, degree 10, 61.8 bits */
        {
         0.97774229943752289, 5.1931978412655592e-09, 0.67183876832245393, 0.49641754004677896,
         0.39791879342632341, 0.34476542642277946, 0.31963691686519491, 0.31300493055003764,
         0.3196740150085442, 0.33694766627644157, 0.36472127364887935, 0.40072552913667031
        },
        /* [4] 0.21875 <= y <= 0.28125, degree 10, 60.5 bits */
        {
         1.0217740833759308, 8.897676853560149e-09, 0.73891707831109077, 0.57996677607182712,
         0.49831504939798227, 0.46613290006054076, 0.46865287971245756, 0.49868175272342846,
         0.55367410159411889, 0.63426138516171637, 0.74618873735667368, 0.8901964458386642
        },
        /* [5] 0.28125 <= y <= 0.34375, degree 10, 59.0 bits */
        {
         1.0703511536121368, 1.7340854739658304e-09, 0.81774662318562252, 0.68559640600720384,
         0.63592373066046159, 0.64731708642160757, 0.71142557592134015, 0.82893548080648682,
         1.0079370399073386, 1.2639353716543384, 1.6279019718809049, 2.1236127439276298
        },
        /* [6] 0.34375 <= y <= 0.40625, degree 10, 59.6 bits */
        {
         1.1243042945861816, -2.8640509341963433e-10, 0.91159003336842559, 0.82195274454306544,
         0.83020558399777677, 0.92839602935878296, 1.1259541866923408, 1.4496484993186771,
         1.947312576846975, 2.6958466697641397, 3.834163634534375, 5.5153375171072048
        },
        /* [7] 0.40625 <= y <= 0.46875, degree 10, 58.3 bits */
        {
         1.1847074329853058, 1.256011842141841e-08, 1.0250648350260807, 1.0025003582101177,
         1.1145714007235645, 1.3852547653522946, 1.8750852364774235, 2.6965773805581046,
         4.0436861618956073, 6.2438913860440906, 9.9098379255917965, 15.879704964692641
        },
        /* [8] 0.46875 <= y <= 0.53125, degree 10, 57.1 bits */
        {
         1.2529852390289307, -9.1751688076707307e-09, 1.1649519353330366, 1.249237361391081,
         1.5498480376822521, 2.1718620723850175, 3.3269584809643331, 5.4152688475577682,
         9.1819097230662052, 16.01466359370826, 28.73779317692113, 51.949114525741543
        }
    };
    return row[i];
}

/* beta/(1 - eps) at zero force, 1 - eps < 1/2: 24 rows of degree 10 in y = sqrt(1 - eps), nodes 0 + i 0.03125, 0 <= y <= 0.734375.
 * Relative error of the approximation: 2^-56.4 at most, proved for the whole cell of each row. */
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_STEP 0.03125
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_PER_UNIT 32.0
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_ROWS 24
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_END 0.5
COR_INLINE const double *cor_rows_near_beta_zero_force(int i)
{
    static const double row[24][12] = {
        /* [0] 0 <= y <= 0.015625, degree 10, 66.7 bits */
        {
         0.86696518957614899, -6.870677073425355e-09, 1.4080665842949803e-24, 0.52017910962328318,
         0.16179851461843053, 0.32881472828409208, 0.19415821753965673, 0.29642147167573191,
         0.14335183767531245, 0.30320010070210568, 0.1206663216764997, 0.27903031560051578
        },
        /* [1] 0.015625 <= y <= 0.046875, degree 10, 64.3 bits */
        {
         0.86747843027114868, -2.806082357709039e-09, 0.033026331782913129, 0.53733795965718778,
         0.20498265462619519, 0.36366792617447569, 0.25321185009598246, 0.33643614896696283,
         0.22443511992104265, 0.34981398189427843, 0.21399640486311078, 0.33249069100416334
        },
        /* [2] 0.046875 <= y <= 0.078125, degree 10, 63.4 bits */
        {
         0.86904186010360718, -5.4076711520572616e-09, 0.067256151553964, 0.55876818698784003,
         0.25312735477563991, 0.40842448733352849, 0.32152243214561188, 0.39571490654878233,
         0.32070711271613334, 0.42592950017268277, 0.33309802367230434, 0.43751528604913081
        },
        /* [3] 0.078125 <= y <= 0.109375, degree 10, 62.7 bits */
        {
         0.87169741094112396, -5.1533680972056679e-09, 0.1029722098832624, 0.58499598252352158,
         0.3075732516355294, 0.46483129780496224, 0.40306734192370625, 0.47846258315744594,
         0.44062321864885473, 0.54089313178754606, 0.49345066517413366, 0.60023555046377408
        },
        /* [4] 0.109375 <= y <= 0.140625, degree 10, 61.9 bits */
        {
         0.87549641728401184, -2.6385385710480448e-09, 0.14049430493673815, 0.61668473701361859,
         0.36992104962129069, 0.53532801902773042, 0.50280369724740481, 0.59103175967863375,
         0.59557835816800409, 0.70920566292986653, 0.71728748108951768, 0.84984203417416682
        },
        /* [5] 0.140625 <= y <= 0.171875, degree 10, 62.7 bits */
        {
         0.8805009126663208, -4.6268112155984087e-09, 0.18018870902727177, 0.65466381333857493,
         0.44212910388271126, 0.623235146121777, 0.62714109783717742, 0.74272754067671232,
         0.80149431569152352, 0.9531273234319344, 1.0385542967228776, 1.2335853211450289
        },
        /* [6] 0.171875 <= y <= 0.203125, degree 10, 63.6 bits */
        {
         0.88678523898124695, -7.1753964953863947e-09, 0.22247970468675982, 0.69996772594809176,
         0.52663967601779094, 0.73302960897905545, 0.78460287363534287, 0.94704397261215734,
         1.0812461211338498, 1.3069126802258975, 1.5102677450537136, 1.8288525133957503
        },
        /* [7] 0.203125 <= y <= 0.234375, degree 10, 62.0 bits */
        {
         0.89443807303905487, 6.9072886869196743e-09, 0.26786397637659953, 0.75388899274392618,
         0.62654694075287654, 0.87074470951359562, 0.98677714122627835, 1.2235685765547626,
         1.468456539857468, 1.8237565372939339, 2.2169443888909175, 2.76444375172784
        },
        /* [8] 0.234375 <= y <= 0.265625, degree 10, 63.8 bits */
        {
         0.90356503427028656, -3.6483693156140276e-09, 0.31692885137039467, 0.8180494010250583,
         0.74582557417162487, 1.0445511276669557, 1.2497163145442094, 1.6009434577977095,
         2.0135537288040766, 2.5873730039817437, 3.2960547808378262, 4.2587780619004105
        },
        /* [9] 0.265625 <= y <= 0.296875, degree 10, 60.8 bits */
        {
         0.91429172456264496, 4.7810918394391116e-09, 0.37037574261914452, 0.89449658148441102,
         0.88964766544940732, 1.2656073084204271, 1.596038732366553, 2.1215316930887433,
         2.7936399167266828, 3.7316668001294566, 4.9758799140116983, 6.6900437168793543
        },
        /* [10] 0.296875 <= y <= 0.328125, degree 10, 60.9 bits */
        {
         0.92676791548728943, -5.8731914698649588e-09, 0.42905067067558622, 0.9858359902680266,
         1.0648296642607928, 1.5493185943713148, 2.0581463621862799, 2.848893200771982,
         3.9289081069566438, 5.474863464488319, 7.64389133751998, 10.728213352241823
        },
        /* [11] 0.328125 <= y <= 0.359375, degree 10, 61.2 bits */
        {
         0.94117251038551331, 8.2459571397955904e-10, 0.4939845144117434, 1.0954132702338091,
         1.2804733163239925, 1.9172287323290071, 2.6832485349970359, 3.8799901469797828,
         5.6105623881498419, 8.1801126229560506, 11.973425630476672, 17.590254045142505
        },
        /* [12] 0.359375 <= y <= 0.390625, degree 10, 59.8 bits */
        {
         0.95772024989128113, 6.0238214016884188e-09, 0.56644679428757283, 1.2275695098838943,
         1.5489005907110129, 2.39990952607896, 3.5413676859110899, 5.3655397837637553,
         8.1494468350450084, 12.46586210404468, 19.164887067457631, 29.548199714502193
        },
        /* [13] 0.390625 <= y <= 0.421875, degree 10, 60.7 bits */
        {
         0.97667019069194794, -5.891882004072926e-09, 0.64801854324711994, 1.388003851186546,
         1.8870422453365236, 3.0414598465598774, 4.738380368364151, 7.5447574283646599,
         12.062964223863561, 19.412548657599118, 31.419037493487554, 50.973682498911977
        },
        /* [14] 0.421875 <= y <= 0.453125, degree 10, 60.0 bits */
        {
         0.99833686649799347, 7.421772391438069e-09, 0.74069252687795994, 1.5842971739333116,
         2.3185406149172625, 3.9066598681473779, 6.4377739407733117, 10.806218412661858,
         18.234904386715243, 30.961687295475144, 52.896879233850953, 90.562679793219871
        },
        /* [15] 0.453125 <= y <= 0.484375, degree 10, 63.0 bits */
        {
         1.0231053531169891, 1.1887303919809086e-08, 0.84701334344475399, 1.8266824576092802,
         2.8770023776439873, 5.092617757916166, 8.8979087198828033, 15.797571896758448,
         28.218681638106773, 50.71296919641906, 91.738758359628576, 166.26294650160855
        },
        /* [16] 0.484375 <= y <= 0.515625, degree 10, 59.9 bits */
        {
         1.0514513254165649, 1.2762604270717738e-08, 0.97027682232317491, 2.1292014863308615,
         3.611149638707055, 6.7482314597682622, 12.537716839828366, 23.629712296710597,
         44.83298186730719, 85.57726268189181, 164.4872636942201, 316.67214011190072
        },
        /* [17] 0.515625 <= y <= 0.546875, degree 10, 61.1 bits */
        {
         1.0839688181877136, 5.2193670759290928e-09, 1.1148195373564624, 2.5114818931741416,
         4.5931929734122123, 9.1076723640560164, 18.056352448717732, 36.270477758509024,
         73.378035585351242, 149.35156874887457, 306.22493601376669, 628.71693845930986
        },
        /* [18] 0.546875 <= y <= 0.578125, degree 10, 59.5 bits */
        {
         1.121408998966217, -1.2920369890010447e-08, 1.2864486530324928, 3.0015383831791973,
         5.9328461447751497, 12.549913263521507, 26.659169565959289, 57.334756062621992,
         124.2298192163787, 270.82461584078391, 595.02727370112029, 1308.6502624074956
        },
        /* [19] 0.578125 <= y <= 0.609375, degree 10, 60.1 bits */
        {
         1.1647355854511261, -1.276269796638737e-08, 1.4930964102871604, 3.6403187619676363,
         7.8015731764670884, 17.708558594723918, 40.502454102853356, 93.743549046220949,
         218.6534356435323, 513.16617729072141, 1214.461327985073, 2875.8349259238603
        },
        /* [20] 0.609375 <= y <= 0.640625, degree 10, 59.2 bits */
        {
         1.215206116437912, -7.5803766610002606e-09, 1.7458456427497624, 4.4893303365512098,
         10.476151943405293, 25.683248108633709, 63.610799345785608, 159.39258890753777,
         402.58732611558395, 1023.2394728977056, 2624.2744775152196, 6730.7015879689943
        },
        /* [21] 0.640625 <= y <= 0.671875, degree 10, 58.9 bits */
        {
         1.2744941413402557, 1.2673219008714358e-08, 2.060590510159086, 5.6439316538175195,
         14.420419069959651, 38.466923062415688, 103.87487084289207, 283.76365980927113,
         781.53088029692276, 2166.2249866998818, 6063.7465248937451, 16962.482522794242
        },
        /* [22] 0.671875 <= y <= 0.703125, degree 10, 57.9 bits */
        {
         1.3448794186115265, -1.3076045053819711e-08, 2.4608309383281042, 7.2575501450326181,
         20.446624108487612, 59.859936045889022, 177.68614954464709, 533.5980968334145,
         1615.8452131191759, 4924.9272936223679, 15175.784799467456, 46687.579642412362
        },
        /* [23] 0.703125 <= y <= 0.734375, degree 10, 56.4 bits */
        {
         1.4295547306537628, 5.7435412047280636e-09, 2.9825916700933317, 9.588179335688654,
         30.053536697527353, 97.561825067443351, 321.52573630184327, 1072.1466686733374,
         3605.7491010275362, 12206.790931455622, 41839.415229398248, 142989.27514012152
        }
    };
    return row[i];
}

/* beta at zero overlap by eps, 2^-12 <= eps < 2^-1: 88 rows of degree 10 in y = eps 2^-k, 8 to each octave k = -12 ... -2.
 * Relative error of the approximation: 2^-57.5 at most, proved for the whole cell of each row. */
#define COR_ROWS_BETA_ZERO_OVERLAP_FIRST 0.000244140625
#define COR_ROWS_BETA_ZERO_OVERLAP_FIRST_OCTAVE (-12)
#define COR_ROWS_BETA_ZERO_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_BETA_ZERO_OVERLAP_ROWS 88
#define COR_ROWS_BETA_ZERO_OVERLAP_END 0.5
COR_INLINE const double *cor_rows_beta_zero_overlap(int i)
{
    static const double row[88][12] = {
        /* [0] 1 <= y <= 1.125 2^-12, degree 10, 58.6 bits */
        {
         7.2395054090751003, 1.1552296366069447e-16, -1.3627304299435485, 0.76954188985047423,
         -0.53113479456076251, 0.3999132570807003, -0.31616672172278953, 0.25789285571365222,
         -0.21497898342211444, 0.18209972017296408, -0.15731455595355892, 0.13623048192276349
        },
        /* [1] 1.125 <= y <= 1.25 2^-12, degree 10, 59.4 bits */
        {
         7.0802397022210908, -3.3420712421855393e-16, -1.1924614235319735, 0.60250682452141668,
         -0.37207438987912206, 0.25066064160267071, -0.17730942386122481, 0.12940477259151284,
         -0.096517306757315097, 0.073149926779368213, -0.056457964494666356, 0.043743813373528104
        },
        /* [2] 1.25 <= y <= 1.375 2^-12, degree 10, 60.1 bits */
        {
         6.9399257226068709, 2.210787414537e-16, -1.0575124910639051, 0.48343428162920771,
         -0.27010931291005769, 0.16463805739271184, -0.10536835724939304, 0.069576566082916458,
         -0.046951978096708785, 0.032195632689376821, -0.022458179809563758, 0.015743218722401479
        },
        /* [3] 1.375 <= y <= 1.5 2^-12, degree 10, 61.4 bits */
        {
         6.8147999886645572, -7.7880722146004934e-18, -0.94814608537942047, 0.39574793128878055,
         -0.2018887997299077, 0.1123555059364774, -0.065654695829957685, 0.039583120972525615,
         -0.024388969194708551, 0.015269612389014867, -0.0097173102149521393, 0.0062194421251226834
        },
        /* [4] 1.5 <= y <= 1.625 2^-12, degree 10, 61.7 bits */
        {
         6.7020965424890493, 4.19295623151425e-16, -0.85786835743861123, 0.32942144925636374,
         -0.1546084668511373, 0.079159535027408329, -0.042556166104634814, 0.023604486801983588,
         -0.013380319348773524, 0.0077070628221835016, -0.004509462746686772, 0.0026553030401591815
        },
        /* [5] 1.625 <= y <= 1.75 2^-12, degree 10, 64.9 bits */
        {
         6.5997263497311716, 3.3991402748289878e-16, -0.7821897895978065, 0.27811192519016459,
         -0.12085851563862127, 0.057295888894562587, -0.0285206202816841, 0.014647627206768227,
         -0.007688044564125209, 0.0041002899952730775, -0.0022203150810247083, 0.0012105342338949257
        },
        /* [6] 1.75 <= y <= 1.875 2^-12, degree 10, 60.8 bits */
        {
         6.5060752433873157, 8.1023258344731881e-17, -0.71791175099456284, 0.23765354515642234,
         -0.096154078041244748, 0.042440420651171255, -0.019668939793232362, 0.0094049183371226596,
         -0.0045958910120454241, 0.0022820974223622934, -0.001150085950663141, 0.00058378922824005883
        },
        /* [7] 1.875 <= y <= 2 2^-12, degree 10, 60.7 bits */
        {
         6.419871605218213, 3.1046868935485134e-16, -0.66269642376470272, 0.20522211832625858,
         -0.077675468443661647, 0.032072451483682596, -0.013904959620296893, 0.006219852903770585,
         -0.0028433566063246294, 0.0013207849227298888, -0.00062248180420037549, 0.00029558796657934216
        },
        /* [8] 1 <= y <= 1.125 2^-11, degree 10, 58.6 bits */
        {
         6.3023555118555477, 4.0049626304401091e-17, -1.1863257434096754, 0.66992512568018459,
         -0.46237969462262501, 0.34814471115022938, -0.27523911779758792, 0.22450877070763303,
         -0.1871500751743056, 0.15852701396135044, -0.13695027529368609, 0.11859552277803209
        },
        /* [9] 1.125 <= y <= 1.25 2^-11, degree 10, 60.5 bits */
        {
         6.1637066610396154, -2.2412863045943496e-16, -1.03809796397067, 0.52451265544677628,
         -0.32390956978559188, 0.21821276257737424, -0.15435681902487602, 0.11265339751307281,
         -0.084023195832088851, 0.063680709959750323, -0.049149512785592958, 0.03808120137329836
        },
        /* [10] 1.25 <= y <= 1.375 2^-11, degree 10, 60.6 bits */
        {
         6.0415562470466941, -1.8169131413794982e-16, -0.92061809480762313, 0.42085398610557462,
         -0.23514381471544565, 0.14332575326721622, -0.091728483103558037, 0.060569918577590739,
         -0.040874071045381231, 0.028027926178916085, -0.019550981076616843, 0.013705267925796433
        },
        /* [11] 1.375 <= y <= 1.5 2^-11, degree 10, 60.7 bits */
        {
         5.9326279688761581, 1.613939309768086e-16, -0.82540910876710627, 0.34451858430545307,
         -0.17575440876931925, 0.097811148374393711, -0.05715573296854666, 0.034459107987828801,
         -0.021231830926834391, 0.013292969679228387, -0.0084594098759838976, 0.005414338843662444
        },
        /* [12] 1.5 <= y <= 1.625 2^-11, degree 10, 62.0 bits */
        {
         5.8345139203118537, 1.2700538133943793e-16, -0.7468177819315921, 0.28677802777680761,
         -0.13459448874689436, 0.068912376801316136, -0.037047295125615762, 0.020548898967138851,
         -0.011648244587073591, 0.0067093878986228582, -0.0039257153312277655, 0.0023115755554748586
        },
        /* [13] 1.625 <= y <= 1.75 2^-11, degree 10, 62.0 bits */
        {
         5.7453954913168559, 1.3918717137909949e-16, -0.68093576222530705, 0.24211049227352377,
         -0.10521345034118057, 0.049878966798737254, -0.0248286430507016, 0.012751499773384328,
         -0.0066928315481524937, 0.00356950978465569, -0.0019328965436119377, 0.0010538312575941009
        },
        /* [14] 1.75 <= y <= 1.875 2^-11, degree 10, 61.9 bits */
        {
         5.6638674678833718, 2.3211095172307172e-16, -0.62497847980917398, 0.20688942602641586,
         -0.083706989220972805, 0.036946529845660381, -0.01712280787730629, 0.0081874566029204975,
         -0.004000955511865893, 0.0019866812160708701, -0.0010012079731631328, 0.00050821803866116146
        },
        /* [15] 1.875 <= y <= 2 2^-11, degree 10, 62.3 bits */
        {
         5.588822842014106, -1.339383904166171e-16, -0.57691074611398507, 0.17865622798613801,
         -0.067620426567034958, 0.027920687575996979, -0.012104971954557059, 0.0054146961019447323,
         -0.002475285679011389, 0.0011498100762379632, -0.00054190188742491937, 0.0002573242700621846
        },
        /* [16] 1 <= y <= 1.125 2^-10, degree 10, 58.6 bits */
        {
         5.4865191404077418, 2.5770334573006199e-16, -1.0327565494210471, 0.58320367310691845,
         -0.40252495710607117, 0.30307749861768712, -0.23960962973516517, 0.19544621699284873,
         -0.16292359827925684, 0.13800578469324223, -0.11922214085341795, 0.10324339892843733
        },
        /* [17] 1.125 <= y <= 1.25 2^-10, degree 10, 60.0 bits */
        {
         5.3658183040989629, 1.4659159789235152e-16, -0.90371678131656752, 0.45661473681502951,
         -0.28197976002966557, 0.1899651254189284, -0.13437548931433616, 0.098070464522003561,
         -0.073146432882952528, 0.055437279529181968, -0.042787137570636277, 0.033151611517371983
        },
        /* [18] 1.25 <= y <= 1.375 2^-10, degree 10, 61.7 bits */
        {
         5.2594801896135026, 8.9276729563606661e-17, -0.80144463352680551, 0.36637457318865613,
         -0.20470475291219736, 0.12477214852879023, -0.079854364188054847, 0.052729169690723929,
         -0.035582937190271141, 0.024399727000815864, -0.017020118737753262, 0.011931129074011195
        },
        /* [19] 1.375 <= y <= 1.5 2^-10, degree 10, 60.5 bits */
        {
         5.1646526096634613, -2.0984756698050186e-16, -0.71856043196025043, 0.29992066420101943,
         -0.15300336841469372, 0.085149331550039273, -0.049757039641189792, 0.029998396022682221,
         -0.018483374473262801, 0.01157220128474796, -0.0073643447279892194, 0.0047134560766171852
        },
        /* [20] 1.5 <= y <= 1.625 2^-10, degree 10, 60.5 bits */
        {
         5.0792393575496684, -2.7018965714508544e-16, -0.65014276838570961, 0.24965446722155302,
         -0.11717169930642368, 0.059991437667067937, -0.032251625166480419, 0.017888862120770954,
         -0.010140379257931487, 0.0058408599020921739, -0.0034175340025351711, 0.0020123436675550921
        },
        /* [21] 1.625 <= y <= 1.75 2^-10, degree 10, 60.7 bits */
        {
         5.0016572374119521, 2.3369430536606762e-16, -0.59278923617573853, 0.21076894533696175,
         -0.091594167588456621, 0.04342184287537023, -0.02161466380552558, 0.011100836960861744,
         -0.0058264432748995299, 0.0031074370588612447, -0.0016826842098816742, 0.00091741356961594378
        },
        /* [22] 1.75 <= y <= 1.875 2^-10, degree 10, 61.3 bits */
        {
         4.9306829339525464, -2.2300828743539536e-16, -0.54407574032937989, 0.18010699271298089,
         -0.072871876792896098, 0.032163459011986174, -0.01490633446173016, 0.0071276102433198768,
         -0.0034830307533309413, 0.0017295048217752229, -0.0008716020315985549, 0.00044242959924539028
        },
        /* [23] 1.875 <= y <= 2 2^-10, degree 10, 60.9 bits */
        {
         4.8653527334157411, -3.1074010964180856e-16, -0.50223056230217, 0.15552826467486727,
         -0.058867901734225868, 0.024305970460428275, -0.01053804219209388, 0.0047137842466253004,
         -0.0021548595563093582, 0.0010009663846746895, -0.00047175277452050262, 0.00022401383046710073
        },
        /* [24] 1 <= y <= 1.125 2^-9, degree 10, 58.6 bits */
        {
         4.7762920360976162, 2.0400338009748866e-16, -0.89906894367031209, 0.50770184752751224,
         -0.35042806495486145, 0.26383726161053367, -0.20859330667358456, 0.17014700312644421,
         -0.14183323698263878, 0.12014075277808009, -0.10378877569935634, 0.089878592939871826
        },
        /* [25] 1.125 <= y <= 1.25 2^-9, degree 10, 60.5 bits */
        {
         4.6712154652186975, -9.3844283088812034e-17, -0.78673542282666165, 0.39749545241137169,
         -0.24549100011260483, 0.16536686526285868, -0.11698080176977499, 0.085376387030321479,
         -0.06367786821192184, 0.048260824539465778, -0.037248265861815448, 0.028860125597063569
        },
        /* [26] 1.25 <= y <= 1.375 2^-9, degree 10, 60.1 bits */
        {
         4.578642029944608, 1.7293078976445342e-16, -0.69770572189854518, 0.3189311256971642,
         -0.17822287181846208, 0.10861323228380415, -0.069516665867742383, 0.045904280403016293,
         -0.030977026387511639, 0.021241158555432699, -0.014816809506829206, 0.010386623445427397
        },
        /* [27] 1.375 <= y <= 1.5 2^-9, degree 10, 62.7 bits */
        {
         4.4960885789268135, 4.0896143888035367e-16, -0.62555580396087185, 0.26107258675461187,
         -0.13321769364624844, 0.074120123854678754, -0.043314863335315874, 0.026115740051052709,
         -0.016090999831035711, 0.010074203416283251, -0.0064110001438328857, 0.0041032816597654032
        },
        /* [28] 1.5 <= y <= 1.625 2^-9, degree 10, 60.0 bits */
        {
         4.421730038167718, 1.5435623641051024e-16, -0.56600166024212228, 0.21730502265563845,
         -0.10202754893130216, 0.052219753314227367, -0.028075141931388905, 0.015573538825734826,
         -0.0088279685748539581, 0.005084807142843894, -0.0029751222019767532, 0.0017518342842887905
        },
        /* [29] 1.625 <= y <= 1.75 2^-9, degree 10, 60.0 bits */
        {
         4.3541878967191341, 4.1409804540901927e-16, -0.51608161673123509, 0.1834438219861203,
         -0.079763675994554251, 0.037796110889150046, -0.018814923185064423, 0.009664016589325055,
         -0.0050724206788200958, 0.0027052325650114215, -0.0014648597644133523, 0.00079864793998647807
        },
        /* [30] 1.75 <= y <= 1.875 2^-9, degree 10, 62.2 bits */
        {
         4.2923969038944625, -8.4915008669588419e-18, -0.47368562518916479, 0.15674075568302279,
         -0.06346709839217396, 0.027996230715474635, -0.012974913103582906, 0.0062049630505863311,
         -0.0030323104227626616, 0.0015056710908058063, -0.00075877791984916979, 0.0003851540807468798
        },
        /* [31] 1.875 <= y <= 2 2^-9, degree 10, 61.3 bits */
        {
         4.2355177772397337, 3.3575075988278591e-16, -0.43727151391454655, 0.13533275286586088,
         -0.051277491894628095, 0.02115701197307852, -0.0091721262725800654, 0.0041034898317008142,
         -0.0018760235747236, 0.00087143500932658133, -0.00041069149374803191, 0.00019501430509521377
        },
        /* [32] 1 <= y <= 1.125 2^-8, degree 10, 58.4 bits */
        {
         4.1579733375921233, 3.3521115956824091e-16, -0.7828470977474894, 0.44166104615176588,
         -0.30531594223896158, 0.22966806062301975, -0.18153993405618671, 0.14810859444433422,
         -0.12347988527822966, 0.10459651635042705, -0.090357041892567394, 0.078244320617816054
        },
        /* [33] 1.125 <= y <= 1.25 2^-8, degree 10, 59.6 bits */
        {
         4.0664731269050343, -2.9894208908154005e-16, -0.68514666741247376, 0.34562631710250136,
         -0.21396330034494049, 0.14397314098263445, -0.10179784772921251, 0.074308359588266051,
         -0.055435677997607971, 0.042017772883845138, -0.032429195132184972, 0.025125105926894858
        },
        /* [34] 1.25 <= y <= 1.375 2^-8, degree 10, 61.2 bits */
        {
         3.9858446099963696, 1.8314293797215102e-16, -0.60775682199566483, 0.27713991462285403,
         -0.15539093431210207, 0.094587373168228864, -0.060489888297327744, 0.039946608362881837,
         -0.026964965386641695, 0.018493369542596148, -0.012900422421559594, 0.0090428225868937444
        },
        /* [35] 1.375 <= y <= 1.5 2^-8, degree 10, 60.2 bits */
        {
         3.9139232076504018, -2.1861826780495226e-16, -0.54508401106246651, 0.22668522178483927,
         -0.11619084331921149, 0.064573369040497305, -0.037690586934751025, 0.022722106325031393,
         -0.014004822709602767, 0.0087705876594995538, -0.0055819747094393657, 0.0035726006580142399
        },
        /* [36] 1.5 <= y <= 1.625 2^-8, degree 10, 61.3 bits */
        {
         3.8491174228586873, -1.9974765006467431e-16, -0.49339686367911822, 0.18850635020045245,
         -0.089012010834147476, 0.045515919546107002, -0.024432281702044964, 0.013547483759884019,
         -0.0076818929227296159, 0.0044263737315774964, -0.002590395015070373, 0.0015253444270315621
        },
        /* [37] 1.625 <= y <= 1.75 2^-8, degree 10, 61.6 bits */
        {
         3.79022478997044, 9.9866184690808784e-17, -0.45011465448390026, 0.15896189206569605,
         -0.069601221596350904, 0.032962613316806284, -0.016377295199384499, 0.0084056898473890643,
         -0.0044128737248905663, 0.0023545488927869838, -0.0012753697208791504, 0.00069541453124384014
        },
        /* [38] 1.75 <= y <= 1.875 2^-8, degree 10, 63.9 bits */
        {
         3.7363158756475863, 6.1267554350951247e-17, -0.41339778048989334, 0.13565999577188306,
         -0.055384575155894053, 0.024431075612767379, -0.011297862315916297, 0.0053967372583272324,
         -0.0026373931590046255, 0.0013102035755588966, -0.00066055493863721737, 0.00033536795877149659
        },
        /* [39] 1.875 <= y <= 2 2^-8, degree 10, 60.9 bits */
        {
         3.6866583067593952, -1.1704884334543659e-16, -0.38190093465112473, 0.11697873473528604,
         -0.044744009068574564, 0.018474582127013518, -0.0079903693646657583, 0.0035691451169551978,
         -0.0016313324822648273, 0.00075810751762494567, -0.00035746857542770895, 0.00016979770834812412
        },
        /* [40] 1 <= y <= 1.125 2^-7, degree 10, 58.2 bits */
        {
         3.618890596764218, 8.0089953637422111e-17, -0.68462149703981778, 0.38095824789285071,
         -0.26630824412766124, 0.20073497466940501, -0.15829365579651214, 0.1288586653909328,
         -0.1073483781405859, 0.090955157229733144, -0.078619844641274986, 0.068114635144067015
        },
        /* [41] 1.125 <= y <= 1.25 2^-7, degree 10, 59.8 bits */
        {
         3.5387898710564301, 5.0865506130309577e-17, -0.60046908380959407, 0.29723151984913926,
         -0.18642409969424253, 0.12596483322866234, -0.08889375437209196, 0.06470263449179342,
         -0.048192133228148672, 0.036518872728399196, -0.028199629906634275, 0.021862355354514706
        },
        /* [42] 1.25 <= y <= 1.375 2^-7, degree 10, 59.9 bits */
        {
         3.4680396346463866, 1.1437946133233501e-16, -0.53401355988753696, 0.23760501388981087,
         -0.13516116425715968, 0.082807891896995597, -0.052906511228358939, 0.034826538378277011,
         -0.023451206803572881, 0.016068333252497912, -0.011210823749816651, 0.0078637245231659991
        },
        /* [43] 1.375 <= y <= 1.5 2^-7, degree 10, 61.9 bits */
        {
         3.4047552560969665, 2.1218195212807865e-16, -0.4803598259247942, 0.19376353990639911,
         -0.10083955439483895, 0.056537878789938219, -0.03301557782269067, 0.019841219326120867,
         -0.012190606281189727, 0.0076209626082548096, -0.0048484941293940442, 0.003104612126621917
        },
        /* [44] 1.5 <= y <= 1.625 2^-7, degree 10, 61.1 bits */
        {
         3.3475537468465313, -1.3575385562918711e-16, -0.43624106089869125, 0.16066988439602406,
         -0.077046783711560277, 0.039833952167035322, -0.021429034476393997, 0.011850666614323973,
         -0.0066954745474990312, 0.0038480655669074185, -0.0022495171701432904, 0.0013247051169111275
        },
        /* [45] 1.625 <= y <= 1.75 2^-7, degree 10, 61.2 bits */
        {
         3.2953927125300386, -1.6531238498170657e-16, -0.39939810882388821, 0.13513272096999759,
         -0.060066463652501269, 0.028818694754293783, -0.014377146443780952, 0.0073659140409151206,
         -0.0038524741211268297, 0.002048823402923775, -0.0011077017638991919, 0.00060368339277488134
        },
        /* [46] 1.75 <= y <= 1.875 2^-7, degree 10, 61.8 bits */
        {
         3.2474687038149863, 9.454036498003202e-17, -0.36822169510834096, 0.11505345330473782,
         -0.04764555460196971, 0.021327213144779977, -0.0099225842943929683, 0.0047369163331291769,
         -0.002306658233970835, 0.0011415801272406146, -0.00057403143500069759, 0.00029109198327973627
        },
        /* [47] 1.875 <= y <= 2 2^-7, degree 10, 61.0 bits */
        {
         3.2031505654704344, 1.8652942578951578e-16, -0.3415364010024981, 0.099007977750880882,
         -0.038365243545723828, 0.016095649739182635, -0.007017526568936153, 0.0031371219906671422,
         -0.0014294510414257597, 0.00066160901951235469, -0.00031094085234149843, 0.00014741401955416992
        },
        /* [48] 1 <= y <= 1.125 2^-6, degree 10, 58.6 bits */
        {
         3.142358736552707, -1.3578587773624822e-16, -0.61613949420317393, 0.32164820083943163,
         -0.22721019660275849, 0.17424998442787595, -0.13889037733166426, 0.11342417116190194,
         -0.094317056263027207, 0.079598189178451795, -0.068526720976421387, 0.05919639603792843
        },
        /* [49] 1.125 <= y <= 1.25 2^-6, degree 10, 59.7 bits */
        {
         3.0699619778936316, -1.182164647193858e-16, -0.54516761680105119, 0.25043000974420981,
         -0.15804498028761954, 0.10871864960319021, -0.077780932309285275, 0.056981561614446778,
         -0.042462642461617545, 0.032080902545074723, -0.02466692387720882, 0.019048699163748895
        },
        /* [50] 1.25 <= y <= 1.375 2^-6, degree 10, 60.5 bits */
        {
         3.0054446809119972, 1.5309205197478589e-16, -0.48920464554500537, 0.20002086718975015,
         -0.11392800415373087, 0.071024984407484601, -0.046100046027974594, 0.030635962173591283,
         -0.02069595500361129, 0.014162254863395637, -0.0098442819667734129, 0.0068753670671561377
        },
        /* [51] 1.375 <= y <= 1.5 2^-6, degree 10, 60.7 bits */
        {
         2.947212951633182, 1.2275130434103242e-16, -0.44403608952097401, 0.16315635623522742,
         -0.084577360464832912, 0.048187158660203025, -0.028621101346227001, 0.017408734401423615,
         -0.010760076788698943, 0.0067325839458011435, -0.0042726581735515841, 0.002724816682987634
        },
        /* [52] 1.5 <= y <= 1.625 2^-6, degree 10, 61.2 bits */
        {
         2.8941035209985637, 6.1944800519384467e-17, -0.40686711603101028, 0.13545589584903359,
         -0.064357461924058987, 0.03374421149170756, -0.018471575986957797, 0.010358951866419297,
         -0.0059025856434667175, 0.0034033306517806334, -0.0019879589276478489, 0.0011669327398985377
        },
        /* [53] 1.625 <= y <= 1.75 2^-6, degree 10, 64.8 bits */
        {
         2.8452436432154142, -9.8060463397299575e-17, -0.37577706859053406, 0.1141590796688145,
         -0.050012088894584958, 0.024275235888824086, -0.012319991498151123, 0.006409280250527458,
         -0.0033880358978534385, 0.0018118265082393676, -0.00098070891900012107, 0.00053345415311352397
        },
        /* [54] 1.75 <= y <= 1.875 2^-6, degree 10, 63.4 bits */
        {
         2.799963138930349, 3.0812035681571279e-17, -0.34940591458442549, 0.097461203110440056,
         -0.039575246831764367, 0.017873399982960669, -0.0084530137960794217, 0.0041006500889661911,
         -0.0020216946551014879, 0.0010082412721974905, -0.00050860550325617043, 0.00025782990319698904
        },
        /* [55] 1.875 <= y <= 2 2^-6, degree 10, 62.7 bits */
        {
         2.757737055894721, -6.0065977305681735e-17, -0.32676568572686976, 0.084144839879070635,
         -0.031814849825613077, 0.013428621293590631, -0.0059444561689524448, 0.0027010843461463363,
         -0.0012476925045503177, 0.000582997580895416, -0.00027541377376845351, 0.00013075366294682366
        },
        /* [56] 1 <= y <= 1.125 2^-5, degree 10, 58.5 bits */
        {
         2.6992323175195021, -1.6623504900350732e-16, -0.59649218609138088, 0.27493752599254656,
         -0.1881954313331326, 0.14457108112479175, -0.11673398210120815, 0.096859473584909164,
         -0.081743517372581231, 0.069796103089251285, -0.06056021827633519, 0.052522758670412284
        },
        /* [57] 1.125 <= y <= 1.25 2^-5, degree 10, 58.9 bits */
        {
         2.6286311914022726, 6.50335506717456e-17, -0.53557671125262285, 0.21594668626277955,
         -0.13096189397399746, 0.08972303926672566, -0.064793549933823621, 0.04815461018859802,
         -0.036430737395534693, 0.027895223200952661, -0.021675802165713971, 0.016857584955659553
        },
        /* [58] 1.25 <= y <= 1.375 2^-5, degree 10, 60.0 bits */
        {
         2.5648225800559636, -1.0525613569773597e-16, -0.48709907037435018, 0.1741376615997737,
         -0.094613015052781135, 0.058428399275199494, -0.038134206340637945, 0.025651521057055648,
         -0.017579662095847274, 0.012199758810638298, -0.0085844921550049733, 0.0060524189502346518
        },
        /* [59] 1.375 <= y <= 1.5 2^-5, degree 10, 60.2 bits */
        {
         2.5064844972976981, 1.9148798420702188e-16, -0.44758544886297069, 0.14347447800856017,
         -0.070487071549701102, 0.039584728769645722, -0.02355257180977597, 0.014462865625532636,
         -0.0090561047831794559, 0.0057451705998583314, -0.0036938091810571508, 0.0023818020985884487
        },
        /* [60] 1.5 <= y <= 1.625 2^-5, degree 10, 63.8 bits */
        {
         2.4526494314902818, 2.8838683831255835e-17, -0.41473797933477757, 0.12034060040955633,
         -0.053878463208623543, 0.02772075603539172, -0.015145891694856386, 0.0085517020212490455,
         -0.0049276590218094241, 0.0028783184567446425, -0.0017034534463529402, 0.0010119010022743634
        },
        /* [61] 1.625 <= y <= 1.75 2^-5, degree 10, 61.0 bits */
        {
         2.4025886105603931, -7.4471159873847465e-17, -0.38697885800713744, 0.10246761943515882,
         -0.042088259157359718, 0.019965411199420274, -0.01007959751325716, 0.0052650696542460929,
         -0.0028089088762673462, 0.0015198947605662403, -0.00083316079573679492, 0.00045874899072311908
        },
        /* [62] 1.75 <= y <= 1.875 2^-5, degree 10, 60.3 bits */
        {
         2.3557396918251259, -2.3508271672243582e-17, -0.36319027027665335, 0.088377042739006123,
         -0.033496470666587889, 0.014730758632260988, -0.0069086667054335483, 0.0033562567701784186,
         -0.0016665275219672853, 0.00083972427487290636, -0.00042863594101519303, 0.00021991323158444514
        },
        /* [63] 1.875 <= y <= 2 2^-5, degree 10, 61.1 bits */
        {
         2.3116597741354115, 6.2689118092707954e-17, -0.34255893299661633, 0.077073245813909605,
         -0.027092397511992609, 0.011098407917245565, -0.0048581038095346944, 0.0022051146399803072,
         -0.0010237582077984077, 0.00048255348192889684, -0.0002304292728943815, 0.0001106602027217004
        },
        /* [64] 1 <= y <= 1.125 2^-4, degree 10, 58.6 bits */
        {
         2.2499736724461812, 2.1421539464994418e-16, -0.6324969443277787, 0.25556412853536342,
         -0.16179658104004022, 0.12010418925298748, -0.095530362261279797, 0.078910391443009556,
         -0.066733950207033807, 0.057339232895008148, -0.050202936972075729, 0.043990336197745297
        },
        /* [65] 1.125 <= y <= 1.25 2^-4, degree 10, 58.8 bits */
        {
         2.1746154142033736, 1.4570193944034298e-16, -0.57535556535188725, 0.2045359334356826,
         -0.11407471920234313, 0.075148488219884776, -0.053227383051377294, 0.039223997702791814,
         -0.029628224604914922, 0.022757126174648666, -0.01779598270042353, 0.013955307371661995
        },
        /* [66] 1.25 <= y <= 1.375 2^-4, degree 10, 61.2 bits */
        {
         2.1056858994725314, 1.6897987889309895e-17, -0.5290402425079892, 0.16789030201069374,
         -0.083504317621108229, 0.049379622875613025, -0.03149611391445447, 0.020935860231359665,
         -0.014279928255248308, 0.0099117258186527408, -0.0070006391518872037, 0.0049660305203883233
        },
        /* [67] 1.375 <= y <= 1.5 2^-4, degree 10, 61.7 bits */
        {
         2.0420272287423002, -8.0722017385605175e-17, -0.4906311144335872, 0.14065883290713913,
         -0.063025030096464416, 0.033771293310259978, -0.019577428846805599, 0.011845580431620244,
         -0.0073617285680511024, 0.00465897439021152, -0.0029993974897275883, 0.0019417676862541731
        },
        /* [68] 1.5 <= y <= 1.625 2^-4, degree 10, 60.0 bits */
        {
         1.9827807273633573, -3.2413628079759868e-17, -0.45817877577951194, 0.11984724666715581,
         -0.048791439985901151, 0.023877970349859477, -0.012678209323102992, 0.0070361665738993863,
         -0.0040144268051201188, 0.0023338377605434122, -0.0013800068528007315, 0.00082139199705927931
        },
        /* [69] 1.625 <= y <= 1.75 2^-4, degree 10, 64.3 bits */
        {
         1.9272911655694132, -2.5821930285386192e-17, -0.43033180316349745, 0.10356481728191476,
         -0.038589287566225719, 0.01736394970070983, -0.0084998336192413752, 0.0043549248744647684,
         -0.0022957161034572217, 0.0012338593919898554, -0.00067444808301225724, 0.00037141268363765338
        },
        /* [70] 1.75 <= y <= 1.875 2^-4, degree 10, 60.0 bits */
        {
         1.8750465161798147, -2.324929484134442e-17, -0.40612345113423243, 0.090570290470159007,
         -0.031083001718109144, 0.012934073254093029, -0.0058701312403781894, 0.0027921051463250541,
         -0.001367469928236538, 0.00068319585067409436, -0.00034714292472472306, 0.0001778313227986038
        },
        /* [71] 1.875 <= y <= 2 2^-4, degree 10, 60.7 bits */
        {
         1.8256385252167118, -9.9959309506721038e-17, -0.38484353529543425, 0.080021499286465445,
         -0.025434725495143255, 0.0098366345736550873, -0.0041594620590773429, 0.0018456105126676138,
         -0.00084384120094797691, 0.00039376610789202814, -0.00018688377769493842, 8.9476755011441586e-05
        },
        /* [72] 1 <= y <= 1.125 2^-3, degree 10, 58.3 bits */
        {
         1.7561372252917571, 2.2094480982845761e-17, -0.71456409830399836, 0.27018295137046622,
         -0.15446591197356543, 0.10792096660104498, -0.082731534042773891, 0.066669367774543659,
         -0.05541620404038651, 0.047044639322254708, -0.040854978863047418, 0.035621665959997169
        },
        /* [73] 1.125 <= y <= 1.25 2^-3, degree 10, 58.7 bits */
        {
         1.6707606839409495, -2.2586520743451321e-17, -0.6535059203868947, 0.22097302255986004,
         -0.1112323315415263, 0.068723308145127615, -0.046789197102877753, 0.033563383068704787,
         -0.024865503536183404, 0.018830034558826078, -0.014573696669022763, 0.01134708489252776
        },
        /* [74] 1.25 <= y <= 1.375 2^-3, degree 10, 59.4 bits */
        {
         1.5923233641821881, 7.7697163227956656e-17, -0.60299134869245519, 0.184898623539102,
         -0.083054789200740289, 0.045920590243689274, -0.028088433228017136, 0.018141438776520791,
         -0.012115741501321557, 0.0082771419453055439, -0.0057760788754547578, 0.0040610293750011611
        },
        /* [75] 1.375 <= y <= 1.5 2^-3, degree 10, 58.9 bits */
        {
         1.5196866879747293, 8.0456767197908312e-17, -0.56033239204347729, 0.1575689971897605,
         -0.063865680886310033, 0.031911181578621495, -0.017702663648877789, 0.010391261602195447,
         -0.0063143954141795149, 0.0039278555248460677, -0.0024949345803006837, 0.0015985949693172988
        },
        /* [76] 1.5 <= y <= 1.625 2^-3, degree 10, 61.1 bits */
        {
         1.4519897043113394, 8.0798079813462846e-17, -0.52370440228531523, 0.13629967296811948,
         -0.050318180528682366, 0.022909521291842649, -0.011617314674638663, 0.0062460631412993703,
         -0.0034803645975471052, 0.0019865328931775966, -0.0011576366534841616, 0.00068115883549954798
        },
        /* [77] 1.625 <= y <= 1.75 2^-3, degree 10, 61.9 bits */
        {
         1.3885633196096621, 1.0482621706978678e-16, -0.49182229165466501, 0.1193720595636094,
         -0.040461317495766522, 0.016904704421317501, -0.007888387405972138, 0.0039104270548339874,
         -0.0020111779710318889, 0.0010602557479772955, -0.00057062324484792116, 0.00031034278225753221
        },
        /* [78] 1.75 <= y <= 1.875 2^-3, degree 10, 60.5 bits */
        {
         1.3288755959807159, -3.6384212254426169e-17, -0.46375279632026573, 0.10564294722848037,
         -0.033104314340488772, 0.012769640909037618, -0.0055149112428325006, 0.0025349200734245099,
         -0.0012101645106666762, 0.00059255907424365928, -0.00029621385030231915, 0.00014973870776623314
        },
        /* [79] 1.875 <= y <= 2 2^-3, degree 10, 59.7 bits */
        {
         1.2724954690397081, -1.3594764918080465e-17, -0.43880035954252233, 0.094326836263529223,
         -0.02749159338123593, 0.0098433163401641151, -0.0039540574986045816, 0.0016934990567898957,
         -0.00075411622717987429, 0.00034464071763306561, -0.00016081072973413599, 7.5924286844400297e-05
        },
        /* [80] 1 <= y <= 1.125 2^-2, degree 10, 57.5 bits */
        {
         1.1933666780289074, -3.0577970519058924e-17, -0.81218009773974109, 0.32282639818049091,
         -0.17043687726230058, 0.11009914880287894, -0.079986974722605589, 0.062113138002726054,
         -0.050225572399816176, 0.041719928773601048, -0.035583922242361898, 0.030569182313901506
        },
        /* [81] 1.125 <= y <= 1.25 2^-2, degree 10, 59.6 bits */
        {
         1.0965800976654136, -3.0105024140315945e-17, -0.73869004327943211, 0.26787131703985584,
         -0.12582666350530361, 0.071829521950200745, -0.046211852858392015, 0.03187376370188566,
         -0.022938517989234221, 0.016978255421279322, -0.012894034420155562, 0.0098824476438492022
        },
        /* [82] 1.25 <= y <= 1.375 2^-2, degree 10, 58.1 bits */
        {
         1.0081998141881598, 8.0315958948698869e-17, -0.67711029940248602, 0.22662140211266626,
         -0.096058041590266999, 0.04909713847015823, -0.028306575210425997, 0.017541260251752556,
         -0.011363803567558178, 0.0075805012592199857, -0.0051866986063241957, 0.0035870642514833208
        },
        /* [83] 1.375 <= y <= 1.5 2^-2, degree 10, 60.4 bits */
        {
         0.92692555747863936, -2.1097813720236841e-17, -0.62460571726116965, 0.19470731542680297,
         -0.075332789575107639, 0.034852147115172497, -0.018185448227838432, 0.010220558730999982,
         -0.0060159545761474115, 0.0036505444555967517, -0.0022719500081296771, 0.0014310309508062653
        },
        /* [84] 1.5 <= y <= 1.625 2^-2, degree 10, 60.7 bits */
        {
         0.85175300044069269, 4.446913219698307e-17, -0.57920830594439776, 0.16940365149584591,
         -0.060394770760540305, 0.025525136361482671, -0.012154804408486075, 0.0062444645395860711,
         -0.0033655262931692959, 0.0018721424201812446, -0.0010682311702030084, 0.00061755163663656024
        },
        /* [85] 1.625 <= y <= 1.75 2^-2, degree 10, 57.8 bits */
        {
         0.78188681882329414, -4.2364644161150632e-17, -0.53950276009071063, 0.14893208971916103,
         -0.049313334334211249, 0.019190206639594073, -0.0083995890881866635, 0.0039711399028852018,
         -0.0019726298090216731, 0.0010125051686844353, -0.00053321405347706138, 0.00028477631605927287
        },
        /* [86] 1.75 <= y <= 1.875 2^-2, degree 10, 57.8 bits */
        {
         0.71668416564632975, -2.1718264404075511e-17, -0.50444095206383699, 0.13208799501338811,
         -0.040890825322253667, 0.014751815898552376, -0.0059721767730725748, 0.0026134773462674868,
         -0.0012032726337528339, 0.00057306830572771423, -0.00028012806053760215, 0.00013898927290636096
        },
        /* [87] 1.875 <= y <= 2 2^-2, degree 10, 59.3 bits */
        {
         0.65561648535646466, 3.9989052728109671e-17, -0.47322730398368107, 0.11802913063733102,
         -0.034355365801204553, 0.011558304235803661, -0.004351854641111404, 0.001771719914683234,
         -0.00075976325600754339, 0.00033737376527638796, -0.00015382879249476483, 7.1250184115847213e-05
        }
    };
    return row[i];
}

/* beta at zero force by eps, 2^-23 <= eps < 2^-1: 176 rows of degree 10 in y = eps 2^-k, 8 to each octave k = -23 ... -2.
 * Relative error of the approximation: 2^-55.1 at most, proved for the whole cell of each row. */
#define COR_ROWS_BETA_ZERO_FORCE_FIRST 1.1920928955078125e-07
#define COR_ROWS_BETA_ZERO_FORCE_FIRST_OCTAVE (-23)
#define COR_ROWS_BETA_ZERO_FORCE_OCTAVE_BITS 3
#define COR_ROWS_BETA_ZERO_FORCE_ROWS 176
#define COR_ROWS_BETA_ZERO_FORCE_END 0.5
COR_INLINE const double *cor_rows_beta_zero_force(int i)
{
    static const double row[176][12] = {
        /* [0] 1 <= y <= 1.125 2^-23, degree 10, 55.8 bits */
        {
         16175.302504696479, 7.4757720004421451e-13, -9134.3103859779258, 6877.59500939998,
         -5609.9591198901917, 4751.9650841279063, -4114.6426625273807, 3614.4311213417159,
         -3207.3567820196813, 2867.7531477840143, -2599.9105856112183, 2349.2263452913344
        },
        /* [1] 1.125 <= y <= 1.25 2^-23, degree 10, 57.6 bits */
        {
         15131.066168072521, -5.0022337452529042e-14, -7645.1906120152134, 5150.4413840390007,
         -3758.9180813550715, 2848.8640386322954, -2207.119869983349, 1734.7187313914499,
         -1377.321020717332, 1101.8565272537917, -892.35722130556815, 721.43247915416043
        },
        /* [2] 1.25 <= y <= 1.375 2^-23, degree 10, 58.3 bits */
        {
         14249.185539149559, 4.2970710539619744e-14, -6513.9324056213218, 3970.3945147760987,
         -2621.7204071947772, 1797.7510037967793, -1260.137801012303, 896.09796688430731,
         -643.72139353112686, 465.93159074836774, -341.00632168392616, 249.43085415583229
        },
        /* [3] 1.375 <= y <= 1.5 2^-23, degree 10, 58.7 bits */
        {
         13492.264439615556, 3.9033294584593945e-13, -5631.5717421574855, 3134.0900585862182,
         -1889.5380286379723, 1183.0150186695657, -757.12957961657958, 491.58556717295528,
         -322.42914591164134, 213.08358137504521, -142.2659550373771, 95.011801234903757
        },
        /* [4] 1.5 <= y <= 1.625 2^-23, degree 10, 59.0 bits */
        {
         12833.865074543837, 7.2203991646384361e-13, -4928.2211027254207, 2523.2474312166828,
         -1399.5609814424172, 806.14705543825755, -474.65936345801646, 283.52985043234298,
         -171.08920100085095, 104.02222377738433, -63.851649121677625, 39.231461380878436
        },
        /* [5] 1.625 <= y <= 1.75 2^-23, degree 10, 58.9 bits */
        {
         12254.712993824354, -7.89441561708765e-13, -4357.2473475792904, 2065.6564445540425,
         -1060.8801349153089, 565.80268595694588, -308.46722589317977, 170.60902753698929,
         -95.324076082385375, 53.663920042158388, -30.484182735094368, 17.342494864020804
        },
        /* [6] 1.75 <= y <= 1.875 2^-23, degree 10, 62.5 bits */
        {
         11740.39025591314, 4.2641422367540526e-13, -3886.4893225719525, 1715.4145966710616,
         -820.24404592558119, 407.29355471441249, -206.7365787797134, 106.45745262664573,
         -55.37870648341702, 29.02607873191474, -15.344836226951257, 8.1276270422552717
        },
        /* [7] 1.875 <= y <= 2 2^-23, degree 10, 62.1 bits */
        {
         11279.873913635169, 3.1291728994156983e-13, -3493.1368789016465, 1442.3262523863266,
         -645.16944607972221, 299.69158196208349, -142.30515542048991, 68.551297912225408,
         -33.359458149524109, 16.35689468808274, -8.0865174199974437, 4.0068058839817473
        },
        /* [8] 1 <= y <= 1.125 2^-22, degree 10, 55.8 bits */
        {
         10671.704864152689, -3.2759262550787145e-13, -6026.4020147876408, 4537.5220035773818,
         -3701.1935041851293, 3135.1282540956963, -2714.6521129955336, 2384.635478866428,
         -2116.066513893521, 1892.0116318623593, -1715.3014132086998, 1549.9114718768717
        },
        /* [9] 1.125 <= y <= 1.25 2^-22, degree 10, 57.4 bits */
        {
         9982.7652566167362, 5.4449325019653344e-13, -5043.9490140529888, 3398.0253136559859,
         -2479.9616554170257, 1879.5496462060921, -1456.1562673069741, 1144.4876776382014,
         -908.69308204876347, 726.95426585821815, -588.73625234403198, 475.96796522356004
        },
        /* [10] 1.25 <= y <= 1.375 2^-22, degree 10, 59.1 bits */
        {
         9400.940508282134, -2.9304901377944725e-13, -4297.596653184848, 2619.4845326452823,
         -1729.6908548634938, 1186.0735629242097, -831.38102579189331, 591.20425354030976,
         -424.6977821276775, 307.40023952056998, -224.98028883198126, 164.56300536487589
        },
        /* [11] 1.375 <= y <= 1.5 2^-22, degree 10, 59.5 bits */
        {
         8901.5583365578841, -4.1178785116070578e-13, -3715.4554729045035, 2067.7292114845172,
         -1246.6305381480188, 780.49900063785606, -499.51931808236333, 324.32556741180838,
         -212.723929738663, 140.58275036634612, -93.86053531347342, 62.684416956410509
        },
        /* [12] 1.5 <= y <= 1.625 2^-22, degree 10, 61.8 bits */
        {
         8467.1762970038326, 4.7791987343979638e-13, -3251.416897040629, 1664.7232545327743,
         -923.36617325036389, 531.85882829036996, -313.15844885297383, 187.05996837494158,
         -112.87679164423758, 68.629081354465711, -42.126382316047646, 25.883114179723023
        },
        /* [13] 1.625 <= y <= 1.75 2^-22, degree 10, 61.0 bits */
        {
         8085.0779912313119, 2.7359439161459716e-13, -2874.7145205687889, 1362.8256963845654,
         -699.9200930397086, 373.29065035585171, -203.51251172098432, 112.55999889229955,
         -62.890444952941692, 35.404987814986022, -20.112062316231601, 11.441780702805609
        },
        /* [14] 1.75 <= y <= 1.875 2^-22, degree 10, 62.0 bits */
        {
         7745.7511223027877, 4.2799110948815245e-13, -2564.1298899043013, 1131.7521742238296,
         -541.15944186047034, 268.71360319620891, -136.39530373883528, 70.235737553154181,
         -36.5363260566929, 19.150072741652721, -10.123817568411594, 5.3622346500865694
        },
        /* [15] 1.875 <= y <= 2 2^-22, degree 10, 60.1 bits */
        {
         7441.9232547818483, -1.0687864953690286e-13, -2304.6139154067328, 951.58099434875317,
         -425.65325135996841, 197.72276096691942, -93.886409784724748, 45.226998235198622,
         -22.009037930976977, 10.791527460593771, -5.335112510871201, 2.643506324748754
        },
        /* [16] 1 <= y <= 1.125 2^-21, degree 10, 55.7 bits */
        {
         7040.6807664721509, 5.9808775433004286e-14, -3975.9482739819705, 2993.6499538392495,
         -2441.8780374468483, 2068.4138858142392, -1791.0028976378637, 1573.2730035457901,
         -1396.0834920415364, 1248.2623458485589, -1131.6770439270101, 1022.56034802856
        },
        /* [17] 1.125 <= y <= 1.25 2^-21, degree 10, 57.2 bits */
        {
         6586.1494492294378, 2.2093213995759487e-13, -3327.7705964131578, 2241.8621874600403,
         -1636.1652414747975, 1240.0407250711005, -960.70511185759904, 755.08043939761581,
         -599.51396921232561, 479.61103241960348, -388.42112898823598, 314.02178992074198
        },
        /* [18] 1.25 <= y <= 1.375 2^-21, degree 10, 57.8 bits */
        {
         6202.2876325487669, -4.1578466422723116e-13, -2835.3613189413754, 1728.216588129384,
         -1141.1709415205123, 782.51700944616232, -548.50707981959317, 390.04943946926306,
         -280.19610011668658, 202.80856109560452, -148.43165969636811, 108.57110972619951
        },
        /* [19] 1.375 <= y <= 1.5 2^-21, degree 10, 58.6 bits */
        {
         5872.8176728514727, -6.1763452515541317e-14, -2451.2910701265964, 1364.1936470848223,
         -822.46986609610155, 514.93750677307139, -329.55995022041947, 213.97513248322184,
         -140.34548593825906, 92.750044116940771, -61.924870440666069, 41.356298672184401
        },
        /* [20] 1.5 <= y <= 1.625 2^-21, degree 10, 58.6 bits */
        {
         5586.2318425897365, -1.6729550588349359e-13, -2145.1395230028802, 1098.3087260928846,
         -609.19483509145016, 350.89611574948003, -206.60759593666671, 123.41358926327064,
         -74.470928038293238, 45.278317637426831, -27.79305270028005, 17.07648992242909
        },
        /* [21] 1.625 <= y <= 1.75 2^-21, degree 10, 59.5 bits */
        {
         5334.1404430128832, -3.280732166281937e-13, -1896.6084118642545, 899.13049953409734,
         -461.77533462079077, 246.28009616342646, -134.2682338710006, 74.261927253265171,
         -41.492230750899687, 23.358586158370187, -13.269015403068254, 7.5487614830522443
        },
        /* [22] 1.75 <= y <= 1.875 2^-21, degree 10, 59.3 bits */
        {
         5110.2676948718736, 1.141463588049117e-13, -1691.6987718626385, 746.6787322253266,
         -357.03231740204927, 177.28494952042476, -89.987376427722893, 46.338320836165181,
         -24.104992419740352, 12.634339362035867, -6.6792301576454802, 3.5377562251119157
        },
        /* [23] 1.875 <= y <= 2 2^-21, degree 10, 61.2 bits */
        {
         4909.8155770757303, 1.0345359547929945e-13, -1520.4819018943026, 627.8100029920746,
         -280.8266128492665, 130.44844164832898, -61.941956046478893, 29.838701369642553,
         -14.520554178883268, 7.1197547998888329, -3.5198624074361304, 1.7440641236005301
        },
        /* [24] 1 <= y <= 1.125 2^-20, degree 10, 55.8 bits */
        {
         4645.0935767974152, 1.7524358465969391e-13, -2623.154640913036, 1975.0747193277198,
         -1611.0399217536501, 1364.6450174160004, -1181.6217824856997, 1037.9734807626892,
         -921.0719064466133, 823.5462560422153, -746.62859661937182, 674.63838991151408
        },
        /* [25] 1.125 <= y <= 1.25 2^-20, degree 10, 57.1 bits */
        {
         4345.2138963519865, -3.5724696761064184e-14, -2195.5163261317834, 1479.079369791122,
         -1079.4674009578425, 818.12228782463444, -633.82931646565464, 498.16751595553029,
         -395.53185552359554, 316.42537619455538, -256.26244876786916, 207.17717098935887
        },
        /* [26] 1.25 <= y <= 1.375 2^-20, degree 10, 58.9 bits */
        {
         4091.9587588111581, -1.444814095232601e-13, -1870.646915652909, 1140.1993549557671,
         -752.8927390870989, 516.26904819387585, -361.87991516688834, 257.33677913624371,
         -184.86055865725416, 133.80379699106001, -97.928405015330341, 71.630239194688684
        },
        /* [27] 1.375 <= y <= 1.5 2^-20, degree 10, 58.9 bits */
        {
         3874.5889150173466, 9.6744237105667931e-14, -1617.2546736553547, 900.03354837942254,
         -542.62829308627511, 339.73231160427343, -217.42861116371046, 141.17101079572095,
         -92.593529411507873, 61.192231659893842, -40.855192019935352, 27.284989964246421
        },
        /* [28] 1.5 <= y <= 1.625 2^-20, degree 10, 59.2 bits */
        {
         3685.5120889231907, -8.4072210603984632e-14, -1415.2696547811574, 724.61473699264639,
         -401.91913835518733, 231.50528769558463, -136.31026694887973, 81.422647752670287,
         -49.13251222441508, 29.8725613823771, -18.336583146827014, 11.266285488474658
        },
        /* [29] 1.625 <= y <= 1.75 2^-20, degree 10, 59.0 bits */
        {
         3519.1931378389509, -1.4365729415970986e-13, -1251.2999875794317, 593.2059665719604,
         -304.65845837247167, 162.48440873322559, -88.584059983523716, 48.994628717928983,
         -27.374677047082603, 15.410926382895235, -8.7542888287487006, 4.9803270116535208
        },
        /* [30] 1.75 <= y <= 1.875 2^-20, degree 10, 58.7 bits */
        {
         3371.4915869460647, 4.1595517381065685e-14, -1116.1097919190572, 492.62518913954608,
         -235.55377650475668, 116.96455517274742, -59.369571623898963, 30.571909435825532,
         -15.903372589070367, 8.3355592807179679, -4.4066503612589019, 2.3340495463845952
        },
        /* [31] 1.875 <= y <= 2 2^-20, degree 10, 59.6 bits */
        {
         3239.2419190561868, 8.9252008800183132e-14, -1003.1485621233488, 414.20097439422017,
         -185.2767134692786, 86.063960218552452, -40.866482773444346, 19.686214246359658,
         -9.5799984958766782, 4.6972887355160573, -2.3222441802661913, 1.1506536673393297
        },
        /* [32] 1 <= y <= 1.125 2^-19, degree 10, 55.8 bits */
        {
         3064.5896953839028, -4.5832196375500405e-14, -1730.6452927174118, 1303.0662380384631,
         -1062.8914890876772, 900.33091417336186, -779.58031479930821, 684.80760161587136,
         -607.68120931975795, 543.33819521356497, -492.59140855805731, 445.09554121187455
        },
        /* [33] 1.125 <= y <= 1.25 2^-19, degree 10, 57.4 bits */
        {
         2866.7418519504099, -2.2728854790893977e-13, -1448.5085679541846, 975.83085025603691,
         -712.18402104392203, 539.76005675692215, -418.17179660697508, 328.66825069427898,
         -260.95388495462259, 208.76301925049356, -169.07025500534291, 136.68602440246895
        },
        /* [34] 1.25 <= y <= 1.375 2^-19, degree 10, 58.2 bits */
        {
         2699.6548099848019, -3.2452306855787825e-14, -1234.1741415470094, 752.25304819561222,
         -496.72482877017001, 340.61099013337792, -238.75195449791028, 169.77910604308457,
         -121.96257638625202, 88.277642603514664, -64.608690617126342, 47.258358806511232
        },
        /* [35] 1.375 <= y <= 1.5 2^-19, degree 10, 58.9 bits */
        {
         2556.2432956590319, -1.4250946282612122e-13, -1066.9971415822504, 593.8024197489965,
         -358.00184089994349, 224.14005354106229, -143.4495489001124, 93.138221102520461,
         -61.08899716286426, 40.37184586243486, -26.954391803173138, 18.001390480061787
        },
        /* [36] 1.5 <= y <= 1.625 2^-19, degree 10, 61.1 bits */
        {
         2431.4982657705186, 1.8117851931855252e-13, -933.7363243926078, 478.06893760405387,
         -265.16828326134447, 152.73676250022206, -89.931347851218149, 53.718968916069123,
         -32.415397857966184, 19.708555807082156, -12.097641629569015, 7.4329810637445775
        },
        /* [37] 1.625 <= y <= 1.75 2^-19, degree 10, 60.6 bits */
        {
         2321.7678808859841, 9.2682551214033278e-14, -825.5563369157378, 391.37129820376225,
         -201.00006358479064, 107.19990697562959, -58.443760709771354, 32.32443560550221,
         -18.060568548186364, 10.167428096283643, -5.775680970950666, 3.2857926517899627
        },
        /* [38] 1.75 <= y <= 1.875 2^-19, degree 10, 59.3 bits */
        {
         2224.3204406089553, -5.1151884777968222e-14, -736.36376111971867, 325.01258230579111,
         -155.40789931210307, 77.167962856453286, -39.169364621418048, 20.169961834751533,
         -10.492323570026917, 5.4994230914768281, -2.9073073118561652, 1.5398995248337635
        },
        /* [39] 1.875 <= y <= 2 2^-19, degree 10, 59.9 bits */
        {
         2137.0674777413992, 7.3514397339946194e-14, -661.83686769515396, 273.27177175421855,
         -122.23734837743422, 56.781143687337924, -26.961863826948445, 12.988073910796391,
         -6.3204486884166879, 3.0990577498312266, -1.5321110754038103, 0.75914888729698016
        },
        /* [40] 1 <= y <= 1.125 2^-18, degree 10, 55.7 bits */
        {
         2021.838960309326, -4.2778151395609516e-14, -1141.8106277788261, 859.70666287960603,
         -701.24875955989853, 593.99808254939001, -514.33203007476982, 451.80513689790598,
         -400.92055008519947, 358.46989191134287, -324.98942823385192, 293.65378742736624
        },
        /* [41] 1.125 <= y <= 1.25 2^-18, degree 10, 57.5 bits */
        {
         1891.3067963868477, 1.2759312465562001e-14, -955.66899849258095, 643.81120890529633,
         -469.86762974925045, 356.10962899401386, -275.89099190660835, 216.84050412871485,
         -172.16558058188144, 137.73238447348712, -111.54488279832016, 90.179228115296425
        },
        /* [42] 1.25 <= y <= 1.375 2^-18, degree 10, 58.6 bits */
        {
         1781.0692853470262, -5.1240445627115295e-14, -814.26033666131673, 496.30440889693733,
         -327.71724342586572, 224.71999857627694, -157.51785599586702, 112.01262111892279,
         -80.465406298635727, 58.24159654194375, -42.625886662328483, 31.17892056103965
        },
        /* [43] 1.375 <= y <= 1.5 2^-18, degree 10, 59.4 bits */
        {
         1686.4518752367796, -5.166043200631123e-14, -703.96407479837865, 391.76562388464168,
         -236.19397022867673, 147.87768042624427, -94.641609414909723, 61.448419666161179,
         -40.303769625136354, 26.635521109377326, -17.783288138310699, 11.876501580228791
        },
        /* [44] 1.5 <= y <= 1.625 2^-18, degree 10, 60.6 bits */
        {
         1604.1498187832124, 5.6268201276831561e-14, -616.04422788781471, 315.40971970950943,
         -174.9464943782225, 100.76897245803285, -59.332699170137168, 35.441370614277766,
         -21.386222521125706, 13.002816676338742, -7.9814773473093945, 4.9039444556007847
        },
        /* [45] 1.625 <= y <= 1.75 2^-18, degree 10, 59.9 bits */
        {
         1531.7537916258179, -1.0876607198657919e-13, -544.67162079407422, 258.21038237545645,
         -132.6111319678343, 70.725780352188124, -38.558597584018976, 21.326218390761419,
         -11.915552796019503, 6.708011434099503, -3.8105337095900276, 2.1678174492517281
        },
        /* [46] 1.75 <= y <= 1.875 2^-18, degree 10, 60.5 bits */
        {
         1467.4615364999333, -1.7116013165753654e-14, -485.82608498543283, 214.4297714161915,
         -102.53142572992431, 50.912035931072488, -25.842211387885719, 13.307241498396044,
         -6.9223651593994653, 3.6282722174716695, -1.9181103703540663, 1.0159561787301681
        },
        /* [47] 1.875 <= y <= 2 2^-18, degree 10, 61.0 bits */
        {
         1409.8951730839651, 2.668205622492621e-15, -436.65633343380472, 180.29341289669085,
         -80.646949547737435, 37.46171483628374, -17.788246144133524, 8.5689532505603196,
         -4.1699494610301882, 2.0446192500334863, -1.0108179507077475, 0.50085220234913463
        },
        /* [48] 1 <= y <= 1.125 2^-17, degree 10, 55.7 bits */
        {
         1333.871462727918, 2.7678821791707172e-14, -753.32687471334816, 567.19924734579831,
         -462.65398386784585, 391.8940709658541, -339.33362514650355, 298.08098719353296,
         -264.5095010262562, 236.5023873403988, -214.41343162860932, 193.73955106449483
        },
        /* [49] 1.125 <= y <= 1.25 2^-17, degree 10, 57.1 bits */
        {
         1247.7508158204455, -4.0637125558518448e-14, -630.51820377948252, 424.76061137083832,
         -309.9987611346728, 234.94572177934546, -182.0207866329047, 143.06178440430878,
         -113.58719947210373, 90.869680303029398, -73.592318566819458, 59.496205568591563
        },
        /* [50] 1.25 <= y <= 1.375 2^-17, degree 10, 58.6 bits */
        {
         1175.0197600277279, 1.2725044531488087e-14, -537.22244912594817, 327.44184813662525,
         -216.21407088793922, 148.2605886600652, -103.92341203579886, 73.900998447072908,
         -53.087511722402496, 38.425213948424613, -28.122656342595455, 20.570455237056692
        },
        /* [51] 1.375 <= y <= 1.5 2^-17, degree 10, 58.8 bits */
        {
         1112.5942232938312, -5.9193704685468819e-14, -464.45334841536578, 258.471532084731,
         -155.83094107818627, 97.563370874874821, -62.440426349825088, 40.540974127119469,
         -26.590648488232812, 17.572935247044164, -11.732621441116853, 7.8355850663635618
        },
        /* [52] 1.5 <= y <= 1.625 2^-17, degree 10, 59.2 bits */
        {
         1058.2938717148572, 6.1589260970506605e-14, -406.44727362145574, 208.09507532786998,
         -115.42246784035326, 66.48308541771874, -39.145152097987349, 23.382669169223949,
         -14.109689005202688, 8.5786833477552822, -5.2658242048024526, 3.2354039573319091
        },
        /* [53] 1.625 <= y <= 1.75 2^-17, degree 10, 59.7 bits */
        {
         1010.5291331082425, 3.4165975513754607e-14, -359.35838361834857, 170.3573069275746,
         -87.491389866677125, 46.661882083751991, -25.439305103292359, 14.070111596645233,
         -7.861359438959683, 4.4256501410518601, -2.514021321159118, 1.4302295535477156
        },
        /* [54] 1.75 <= y <= 1.875 2^-17, degree 10, 59.7 bits */
        {
         968.11095234190759, 8.3664838313899496e-15, -320.53434164245738, 141.47264712280756,
         -67.646066806101871, 33.589623395096041, -17.049585414943458, 8.7795415992340509,
         -4.567074127825431, 2.3937744867945341, -1.2654844674949339, 0.67028281642966747
        },
        /* [55] 1.875 <= y <= 2 2^-17, degree 10, 64.2 bits */
        {
         930.13026025065687, 1.9416171348283651e-14, -288.09398866400539, 118.95085996368371,
         -53.207605795224787, 24.715675731906323, -11.735927332049332, 5.6534256867810084,
         -2.751151102411113, 1.3489501515225832, -0.66689313663111749, 0.33044011680819885
        },
        /* [56] 1 <= y <= 1.125 2^-16, degree 10, 55.8 bits */
        {
         879.97182285717577, -1.8670974172306172e-14, -497.02579022476203, 374.21729991758252,
         -305.24067354772592, 258.55549564486438, -223.87797809526288, 196.66105137836777,
         -174.51191034175841, 156.03395326125619, -141.46056945972632, 127.82081141564738
        },
        /* [57] 1.125 <= y <= 1.25 2^-16, degree 10, 57.1 bits */
        {
         823.15153823436776, 9.9603454329955698e-16, -416.00106755522262, 280.2419171639595,
         -204.52503846542515, 155.00758302288276, -120.0896909221461, 94.386077472868692,
         -74.93994641486475, 59.951872267551209, -48.552997892852765, 39.252984819304949
        },
        /* [58] 1.25 <= y <= 1.375 2^-16, degree 10, 58.1 bits */
        {
         775.16522814827044, -1.1336402260649144e-14, -354.44780965711197, 216.03478021048261,
         -142.64971256535659, 97.816347642936563, -68.564355048370444, 48.756758336767923,
         -35.024870949470603, 25.351298578073358, -18.554106840046835, 13.571487624636855
        },
        /* [59] 1.375 <= y <= 1.5 2^-16, degree 10, 59.3 bits */
        {
         733.97814186429048, 1.3300781584221609e-15, -306.43724631082608, 170.53080260260904,
         -102.81134910095156, 64.368417976977213, -41.195626591943991, 26.747236126606136,
         -17.543380729469604, 11.593868992743554, -7.7406765137402012, 5.169578270767512
        },
        /* [60] 1.5 <= y <= 1.625 2^-16, degree 10, 59.2 bits */
        {
         698.15177851020951, 2.5213622821064402e-14, -268.166767466267, 137.29431060514347,
         -76.151442319560715, 43.862917727547554, -25.82637725105285, 15.426912974480819,
         -9.3089775972308555, 5.6598494598957902, -3.474164373921381, 2.134579478372006
        },
        /* [61] 1.625 <= y <= 1.75 2^-16, degree 10, 60.1 bits */
        {
         666.63739817953604, -5.5742796814731352e-14, -237.09903991390351, 112.39632635542323,
         -57.723612457850898, 30.78569144060188, -16.78382721780137, 9.2828791657386382,
         -5.1865955096465868, 2.9198563268722513, -1.6586437136389227, 0.94360383296125028
        },
        /* [62] 1.75 <= y <= 1.875 2^-16, degree 10, 59.7 bits */
        {
         638.6505062959518, -1.6848983696496769e-14, -211.48415595008055, 93.339277922985687,
         -44.630437272738213, 22.161140224324051, -11.248635058095887, 5.7923821324530582,
         -3.0131653710657638, 1.5793114974429154, -0.83491278758176024, 0.442223853133625
        },
        /* [63] 1.875 <= y <= 2 2^-16, degree 10, 59.3 bits */
        {
         613.59133209817378, -2.7177832092268882e-14, -190.08099978742877, 78.480207715795117,
         -35.104493446754638, 16.306462651530815, -7.7429002075415401, 3.729900610366693,
         -1.8150957105179455, 0.8899807702358109, -0.439987849999527, 0.21801028090068689
        },
        /* [64] 1 <= y <= 1.125 2^-15, degree 10, 55.8 bits */
        {
         580.49732108265005, -1.5784220061985516e-14, -327.9331126172338, 246.89785082272783,
         -201.38725989611223, 170.58525797947559, -147.70595061817593, 129.74906485540342,
         -115.13581143641831, 102.94471825476289, -93.329738025433045, 84.330750862623319
        },
        /* [65] 1.125 <= y <= 1.25 2^-15, degree 10, 56.9 bits */
        {
         543.00771116376245, 4.7269895492146688e-14, -274.47525367905604, 184.89608477878974,
         -134.93880422809787, 102.2683532798164, -79.230578127568137, 62.272202106394907,
         -49.442347575411262, 39.553782277812438, -32.033247872799834, 25.897469877766653
        },
        /* [66] 1.25 <= y <= 1.375 2^-15, degree 10, 58.6 bits */
        {
         511.34651947645284, 2.6208478675613472e-14, -233.8640167885919, 142.53432007134259,
         -94.115693996232707, 64.53574805932611, -45.236184703868616, 32.167811125736947,
         -23.108012637396858, 16.725757102139038, -12.241235487730638, 8.9539023866335388
        },
        /* [67] 1.375 <= y <= 1.5 2^-15, degree 10, 60.4 bits */
        {
         484.17128431864171, -2.5119200802522834e-14, -202.18781342634273, 112.51223362889849,
         -67.83174196896671, 42.468050135439945, -27.179355653359629, 17.646801280461631,
         -11.57443192166687, 7.6491691998681945, -5.1069827485685728, 3.4106744138365963
        },
        /* [68] 1.5 <= y <= 1.625 2^-15, degree 10, 59.0 bits */
        {
         460.5329283669754, -5.5127926787482952e-15, -176.93781536993154, 90.583808074840164,
         -50.242449036917122, 28.939270358559906, -17.039309810804006, 10.178095124266777,
         -6.1417017339394455, 3.7341439829120175, -2.2921134248032411, 1.408308248449305
        },
        /* [69] 1.625 <= y <= 1.75 2^-15, degree 10, 59.8 bits */
        {
         439.7395250212316, -5.5175052019513848e-15, -156.43997725984758, 74.156847604027305,
         -38.084382341126435, 20.311385081994892, -11.073374025566395, 6.1244989113365671,
         -3.4219168554115407, 1.926406610212267, -1.0943068477801909, 0.62255156941038314
        },
        /* [70] 1.75 <= y <= 1.875 2^-15, degree 10, 58.9 bits */
        {
         421.27348778863734, 1.3288173751550632e-14, -139.53976852711719, 61.583543886186156,
         -29.445931368171149, 14.621209231130589, -7.4214583187928849, 3.8216019929211131,
         -1.9879725110937438, 1.0419684519611561, -0.55084243295845747, 0.29176153890957962
        },
        /* [71] 1.875 <= y <= 2 2^-15, degree 10, 61.9 bits */
        {
         404.73910484607262, 1.7300039601388473e-14, -125.41834141687413, 51.779931308197071,
         -23.161015459997351, 10.758494635003769, -5.1085016713469971, 2.460854241222648,
         -1.1975323902011272, 0.58717517874335501, -0.29028675588369879, 0.14383450730543715
        },
        /* [72] 1 <= y <= 1.125 2^-14, degree 10, 55.8 bits */
        {
         382.90309255499147, -1.8632171380221145e-14, -216.3768734369913, 162.89968493783601,
         -132.87031507856247, 112.54703839049911, -97.451502916951085, 85.603877092794548,
         -75.962396279898698, 67.919044917157251, -61.575361558795215, 55.638118286811391
        },
        /* [73] 1.125 <= y <= 1.25 2^-14, degree 10, 57.3 bits */
        {
         358.16657590870551, -2.4662178142714614e-14, -181.10605777350563, 121.99239584394249,
         -89.029566046609162, 67.473762076024016, -52.273822342571457, 41.085082980451958,
         -32.620300784941278, 26.096129119141381, -21.134326548211643, 17.086152209431496
        },
        /* [74] 1.25 <= y <= 1.375 2^-14, degree 10, 58.6 bits */
        {
         337.27558440263118, 2.8419257240295064e-14, -154.31115051411373, 94.04302055163275,
         -62.095603719779824, 42.578963286538375, -29.845459697820573, 21.223264721486157,
         -15.24586653066449, 11.035053041721063, -8.0763140901245247, 5.907445883124093
        },
        /* [75] 1.375 <= y <= 1.5 2^-14, degree 10, 58.7 bits */
        {
         319.34439104540371, -9.8289850429659676e-15, -133.41139392852835, 74.235033990549326,
         -44.754134328905458, 28.0193537243664, -17.932148251119298, 11.642799093646875,
         -7.6364204739420298, 5.0466532528739796, -3.3694020923627508, 2.250236248002309
        },
        /* [76] 1.5 <= y <= 1.625 2^-14, degree 10, 60.9 bits */
        {
         303.7468132587635, 2.6832033986118425e-14, -116.75152855669191, 59.767040892072707,
         -33.149147163837974, 19.093450286338559, -11.24206296934377, 6.7151950647150711,
         -4.0520938407663287, 2.463660219322362, -1.5122550810591489, 0.92915042046008556
        },
        /* [77] 1.625 <= y <= 1.75 2^-14, degree 10, 60.9 bits */
        {
         290.02633000207277, 2.7669152429954842e-14, -103.22706020863492, 48.928784586483822,
         -25.127531568731907, 13.40100628600602, -7.3059185189402722, 4.0407632003903942,
         -2.2576719848328808, 1.270978659151849, -0.72198563481689815, 0.41073724368960218
        },
        /* [78] 1.75 <= y <= 1.875 2^-14, degree 10, 60.0 bits */
        {
         277.84144570466646, -2.8374324160834016e-14, -92.076256010335953, 40.633086117281756,
         -19.428064774644071, 9.6467757980377016, -4.8964907666850541, 2.521384029323682,
         -1.3116029287788951, 0.68745679751199484, -0.36342710536272615, 0.19249401732112936
        },
        /* [79] 1.875 <= y <= 2 2^-14, degree 10, 59.9 bits */
        {
         266.93107500711437, -1.8216490154705997e-14, -82.758857646091045, 34.164773171876355,
         -15.281400783509492, 7.0982519900967418, -3.3704667821899958, 1.6236040703603871,
         -0.79009602737748197, 0.38739950960166414, -0.19152154314815606, 0.09489705274223928
        },
        /* [80] 1 <= y <= 1.125 2^-13, degree 10, 55.6 bits */
        {
         252.52221935599934, 3.8773842970502731e-15, -142.78081148886881, 107.48310069049123,
         -87.666868442670236, 74.256671235606092, -64.296343459638791, 56.479222645478622,
         -50.117819282028442, 44.810908168779015, -40.625441066157009, 36.708168159558262
        },
        /* [81] 1.125 <= y <= 1.25 2^-13, degree 10, 57.2 bits */
        {
         236.19917787099399, 3.5224166853613199e-15, -119.50862220484716, 80.492693810016661,
         -58.741408377569016, 44.518272258772136, -34.489237887515223, 27.106959392943736,
         -21.522001343160269, 17.217469290040118, -13.943778546118098, 11.272893631520889
        },
        /* [82] 1.25 <= y <= 1.375 2^-13, degree 10, 58.9 bits */
        {
         222.41347938845493, 1.2446111824985902e-14, -101.8288066642626, 62.051739383184163,
         -40.970708931495544, 28.093147385820327, -19.691517905446894, 14.002647904564487,
         -10.058841683072517, 7.2806253543317947, -5.3285150302758435, 3.8975503771729052
        },
        /* [83] 1.375 <= y <= 1.5 2^-13, degree 10, 58.4 bits */
        {
         210.58072282569657, 1.3881514703882068e-14, -88.038613031635336, 48.982384929880702,
         -29.52896828255528, 18.486953086879421, -11.831363635167806, 7.6816887022511731,
         -5.0383327184594933, 3.3296512356541044, -2.2230373287586782, 1.4846392507154109
        },
        /* [84] 1.5 <= y <= 1.625 2^-13, degree 10, 60.1 bits */
        {
         200.28775163089324, 3.4379466366449166e-15, -77.045916813403124, 39.436315855520675,
         -21.87207183002959, 12.597765639226516, -7.4173715631945427, 4.4305662904159897,
         -2.6734843236961714, 1.6254630414315301, -0.99774572341320877, 0.61302710374805158
        },
        /* [85] 1.625 <= y <= 1.75 2^-13, degree 10, 60.6 bits */
        {
         191.23335055678226, -5.2107344103571632e-15, -68.121980000908835, 32.285128818351858,
         -16.579438178275179, 8.8419566610860496, -4.8203699085548122, 2.6660316284080521,
         -1.4895672507109436, 0.83856270659945586, -0.47634792485341992, 0.27099329822222273
        },
        /* [86] 1.75 <= y <= 1.875 2^-13, degree 10, 59.5 bits */
        {
         183.19219756057333, -8.8078860192768523e-15, -60.764214063208193, 26.811515850923183,
         -12.818934051134006, 6.3649499809820131, -3.2306654409951969, 1.6635741805809581,
         -0.86537184527771982, 0.45356933321660259, -0.23978053517324288, 0.1270025707742265
        },
        /* [87] 1.875 <= y <= 2 2^-13, degree 10, 60.8 bits */
        {
         175.99202506680916, 8.27652473027009e-15, -54.616157033492804, 22.543612963093928,
         -10.082956561964606, 4.6834516520002136, -2.2238146404665278, 1.0712345432561055,
         -0.52129236327342532, 0.25559850935190692, -0.12636160193521667, 0.062610734983904848
        },
        /* [88] 1 <= y <= 1.125 2^-12, degree 10, 55.8 bits */
        {
         166.48289558679636, -4.3080604656624128e-15, -94.229292528059233, 70.923508565673401,
         -57.844718740044065, 48.99511681016407, -42.422573694654986, 37.264476130691143,
         -33.067037093230489, 29.565446702943238, -26.803830862215534, 24.219209558825021
        },
        /* [89] 1.125 <= y <= 1.25 2^-12, degree 10, 57.4 bits */
        {
         155.71023090911655, 4.4536347633052267e-15, -78.872857156835863, 53.114497976638432,
         -38.759408866322161, 29.373733514764158, -22.756068175211539, 17.885025857996588,
         -14.1999859254238, 11.359832296954099, -9.1998548213988602, 7.4376241125451239
        },
        /* [90] 1.25 <= y <= 1.375 2^-12, degree 10, 58.1 bits */
        {
         146.61187475656635, 4.0026421909469631e-15, -67.206441476709358, 40.946523269254037,
         -27.034027513275916, 18.536371001150897, -12.992587936690056, 9.2389231198787929,
         -6.6367482114461795, 4.8036699545516699, -3.5156722686017639, 2.5715329565829976
        },
        /* [91] 1.375 <= y <= 1.5 2^-12, degree 10, 58.7 bits */
        {
         138.80221948342512, 1.2918006456971908e-15, -58.106544296122763, 32.32282609671325,
         -19.484530712501208, 12.198124568120841, -7.8064587687346041, 5.0683928441725534,
         -3.3242700012308624, 2.1968735996461901, -1.4667314702721777, 0.97954144146716571
        },
        /* [92] 1.5 <= y <= 1.625 2^-12, degree 10, 60.3 bits */
        {
         132.00864757380535, 2.6088276773106062e-15, -50.852559723600294, 26.023873890579438,
         -14.432312794944071, 8.3123650438529602, -4.8940912179610931, 2.923311884292433,
         -1.7639616477580986, 1.0724702310856344, -0.6583023036818515, 0.40446696103327695
        },
        /* [93] 1.625 <= y <= 1.75 2^-12, degree 10, 60.0 bits */
        {
         126.03240292696401, 7.5570436602734582e-16, -44.963647855423275, 21.305132392004296,
         -10.940069616508341, 5.8342196340034835, -3.1805711193437993, 1.7590716433593325,
         -0.98281920850208282, 0.55328066199751413, -0.31429060743180609, 0.17879830922310266
        },
        /* [94] 1.75 <= y <= 1.875 2^-12, degree 10, 58.8 bits */
        {
         120.72480589437014, 8.9901513315198767e-16, -40.108185406608939, 17.693310057522453,
         -8.4587539970168812, 4.1998391107235005, -2.1316672630815052, 1.0976469892160883,
         -0.57097656258507423, 0.29926464313098572, -0.15820589286958073, 0.083795140527393758
        },
        /* [95] 1.875 <= y <= 2 2^-12, degree 10, 60.6 bits */
        {
         115.97218391397811, -3.443246994556531e-15, -36.050966074491889, 14.877061344146364,
         -6.6534443136128356, 3.090344706024009, -1.4673329423990629, 0.70681759211432782,
         -0.343952808979545, 0.16864435283536172, -0.083373002669084997, 0.041310131062617383
        },
        /* [96] 1 <= y <= 1.125 2^-11, degree 10, 55.7 bits */
        {
         109.69529895993287, -1.5191658675269342e-15, -62.20098905597925, 46.805033348657055,
         -38.170554444104084, 32.329459702023904, -27.99181243070591, 24.587883669303228,
         -21.818038718836682, 19.507451598504375, -17.685181113951685, 15.979745471084383
        },
        /* [97] 1.125 <= y <= 1.25 2^-11, degree 10, 57.4 bits */
        {
         102.58407523881027, 5.993615218634738e-15, -52.06658563275677, 35.053127743316551,
         -25.577017301758758, 19.382555346475485, -15.015381449186249, 11.801034705358992,
         -9.3694085467115489, 7.4953415960753453, -6.0701120437337162, 4.907348924504908
        },
        /* [98] 1.25 <= y <= 1.375 2^-11, degree 10, 58.7 bits */
        {
         96.577816835471396, 6.3336101631130967e-15, -44.367193167705757, 27.023512382154468,
         -17.839855330049634, 12.231584019771974, -8.5731386326206724, 6.0961574236313121,
         -4.3790849746438276, 3.1695384831568099, -2.3196750632360805, 1.6967098433942571
        },
        /* [99] 1.375 <= y <= 1.5 2^-11, degree 10, 58.3 bits */
        {
         91.422062538211875, 4.4871273900293169e-15, -38.361454025895299, 21.332654875315388,
         -12.858141314374393, 8.0492802373257835, -5.1511381968437666, 3.3443315147819286,
         -2.1934514611026721, 1.4495434661671267, -0.96777047783712444, 0.64631022740945177
        },
        /* [100] 1.5 <= y <= 1.625 2^-11, degree 10, 61.6 bits */
        {
         86.936909707653584, -5.8395832620259947e-15, -33.573859839650609, 17.17584517428228,
         -9.5242700652730203, 5.4852254359130512, -3.22943136752136, 1.9289384489565322,
         -1.1639237403576526, 0.70764374843176725, -0.43436025477747858, 0.26687258099555555
        },
        /* [101] 1.625 <= y <= 1.75 2^-11, degree 10, 61.6 bits */
        {
         82.991195173012713, 5.0694244294470569e-15, -29.687112954138119, 14.061795818207399,
         -7.2197680832875779, 3.8499797331869696, -2.0987654416844892, 1.1607290385761004,
         -0.64850394475670115, 0.36507166755093029, -0.2073762473723347, 0.1179741794471076
        },
        /* [102] 1.75 <= y <= 1.875 2^-11, degree 10, 60.0 bits */
        {
         79.486800530007457, -1.046908733819068e-15, -26.482378122629946, 11.678197719083332,
         -5.5823469829540491, 2.7714945516892775, -1.406639904665431, 0.72429261928022204,
         -0.37675655584844969, 0.19746549422601117, -0.10438861428386464, 0.055289799092594002
        },
        /* [103] 1.875 <= y <= 2 2^-11, degree 10, 61.4 bits */
        {
         76.348708384104697, 2.9114246165583808e-15, -23.804442733541347, 9.8196022069815765,
         -4.3910068765534671, 2.0393601316062595, -0.9682708246899453, 0.46640448056372374,
         -0.22695768984381856, 0.11127836586558561, -0.055012166919401993, 0.027257457308728462
        },
        /* [104] 1 <= y <= 1.125 2^-10, degree 10, 55.7 bits */
        {
         72.203965890488931, 6.1427499529938469e-15, -41.073662796955055, 30.894700989600999,
         -25.191649197416659, 21.335053749661068, -18.471666398081268, 16.224914368450619,
         -14.396831783824686, 12.871942803467672, -11.669357802176165, 10.543927483853196
        },
        /* [105] 1.125 <= y <= 1.25 2^-10, degree 10, 57.1 bits */
        {
         67.507986064624106, 6.7648751000911849e-15, -34.38408440702684, 23.138610641538211,
         -16.880750428306253, 12.79137243058933, -9.908785064927832, 7.7873386516265137,
         -6.1825860907254953, 4.9458512122276925, -4.0053423417738205, 3.2380571728720788
        },
        /* [106] 1.25 <= y <= 1.375 2^-10, degree 10, 58.4 bits */
        {
         63.541393616960114, -2.2218644013215508e-15, -29.301602253597856, 17.839012881851065,
         -11.774610663854029, 8.0723387779549025, -5.6576056162389374, 4.0228394099180722,
         -2.8896683783704673, 2.0914697163231568, -1.5306485022651264, 1.1195669748553534
        },
        /* [107] 1.375 <= y <= 1.5 2^-10, degree 10, 59.6 bits */
        {
         60.13624283676873, 3.5030110177693013e-15, -25.33695834046393, 14.082895638187292,
         -8.4868492252362042, 5.3123179993303919, -3.3994184896869855, 2.2069538244142817,
         -1.4474353471506964, 0.95651684129206083, -0.63859567537301476, 0.42646988334423241
        },
        /* [108] 1.5 <= y <= 1.625 2^-10, degree 10, 59.9 bits */
        {
         57.173793403088126, 3.0293378133734485e-15, -22.17633389363667, 11.339208868795572,
         -6.2865558051145971, 3.6201922214292908, -2.131257551637801, 1.2729447796905988,
         -0.76807224549109476, 0.46696225902166766, -0.28662157701807384, 0.17609866170191263
        },
        /* [109] 1.625 <= y <= 1.75 2^-10, degree 10, 58.8 bits */
        {
         54.567471686333683, -3.4888378263855136e-15, -19.610318647318426, 9.2837321707510938,
         -4.7655918235267425, 2.5410050973632563, -1.385103020869306, 0.76600074280637642,
         -0.42795338252496729, 0.24090780731552661, -0.13684310858303261, 0.077847335679570112
        },
        /* [110] 1.75 <= y <= 1.875 2^-10, degree 10, 60.0 bits */
        {
         52.252513198046096, 3.0427196095776217e-15, -17.494482236143419, 7.7103561685138429,
         -3.6848745171318664, 1.8292408440324783, -0.92834470314741235, 0.4779906859272805,
         -0.24862847066973318, 0.13030753107197834, -0.068884592844838818, 0.036484333896917159
        },
        /* [111] 1.875 <= y <= 2 2^-10, degree 10, 59.7 bits */
        {
         50.179400186411954, -9.0757839341413965e-16, -15.72638262983574, 6.4834917660908236,
         -2.8985583711241434, 1.346047513791705, -0.63904465418870338, 0.30780453621802506,
         -0.14977559458262152, 0.073433548640111035, -0.036302178615301099, 0.017986692497440882
        },
        /* [112] 1 <= y <= 1.125 2^-9, degree 10, 55.7 bits */
        {
         47.441059819220392, 2.4463804274025028e-15, -27.137702930168214, 20.399670014044226,
         -16.629999392565473, 14.082323956324089, -12.191362892418843, 10.707915208528906,
         -9.5010606409878893, 8.4944635693903159, -7.700663386171744, 6.9578495212729941
        },
        /* [113] 1.125 <= y <= 1.25 2^-9, degree 10, 57.5 bits */
        {
         44.338214117939266, 2.7929436620667356e-15, -22.720444796492629, 15.279442493351445,
         -11.144236648439859, 8.4433751168463687, -6.5400636409899331, 5.1395473360598256,
         -4.0802528654461758, 3.2639496165397182, -2.6432024002391104, 2.1368101423870485
        },
        /* [114] 1.25 <= y <= 1.375 2^-9, degree 10, 57.8 bits */
        {
         41.717013341059975, -8.3698358888427407e-16, -19.364146566222058, 11.780699804351055,
         -7.7736932641644403, 5.3286374811254094, -3.7343002160893803, 2.6551036608891616,
         -1.9071128129582711, 1.3802707473152127, -1.0101261873370238, 0.73882250155941775
        },
        /* [115] 1.375 <= y <= 1.5 2^-9, degree 10, 58.2 bits */
        {
         39.466581729593202, 2.7564625469522989e-16, -16.74585196431433, 9.3008220553284637,
         -5.6033660002334775, 3.5068586981677381, -2.2438603906718786, 1.4566483380662327,
         -0.9552978003623126, 0.63127038203909058, -0.42143958049104396, 0.28144065998848333
        },
        /* [116] 1.5 <= y <= 1.625 2^-9, degree 10, 61.7 bits */
        {
         37.508524329828397, 3.2792965466419214e-15, -14.658402572495056, 7.4892854968562013,
         -4.1508437524054234, 2.389917086250096, -1.4068294599359945, 0.84020150615124689,
         -0.50693546477009244, 0.3081871075242838, -0.1891591013496077, 0.11621516683425005
        },
        /* [117] 1.625 <= y <= 1.75 2^-9, degree 10, 59.3 bits */
        {
         35.785680500727281, 3.4189503432173676e-15, -12.963556701763476, 6.1320786744337497,
         -3.1467413959718993, 1.6775418615891105, -0.9143271568355783, 0.50560953871663705,
         -0.28246058782120725, 0.15899858993597971, -0.090312974089730907, 0.051375805623598107
        },
        /* [118] 1.75 <= y <= 1.875 2^-9, degree 10, 60.6 bits */
        {
         34.255287118984029, -2.1385081836395502e-15, -11.56596526320245, 5.0931483885961795,
         -2.4332517754175984, 1.2076886982529846, -0.61283358437181468, 0.31551314171582912,
         -0.16410539320931899, 0.086004556359989923, -0.045462991796919934, 0.024078493821845251
        },
        /* [119] 1.875 <= y <= 2 2^-9, degree 10, 59.6 bits */
        {
         32.884646733603326, -2.803788770620002e-15, -10.397996167430275, 4.2829891232031443,
         -1.914106501455799, 0.88871081318266798, -0.42186937275931735, 0.20318178745201296,
         -0.098860651840176755, 0.048468083760427688, -0.023959467996518716, 0.011870857324642478
        },
        /* [120] 1 <= y <= 1.125 2^-8, degree 10, 55.6 bits */
        {
         31.073987625768492, -2.9269629057129132e-16, -17.945345254092739, 13.477185313138278,
         -10.982598013678775, 9.2981766795032215, -8.0485724388860476, 7.0685760314569865,
         -6.2714769761097715, 5.6067489374015187, -5.0825898732766319, 4.5921627868009365
        },
        /* [121] 1.125 <= y <= 1.25 2^-8, degree 10, 57.3 bits */
        {
         29.021998816890505, -5.3524915606461179e-16, -15.0268953094815, 10.095606113392801,
         -7.3603815007508073, 5.5753199261931297, -4.317916468711382, 3.3929250201369445,
         -2.6934239970276019, 2.1544506978900331, -1.7446317456697156, 1.4103383144499841
        },
        /* [122] 1.25 <= y <= 1.375 2^-8, degree 10, 59.1 bits */
        {
         27.288246168673542, -4.9372824709694223e-16, -12.809168648499268, 7.7847178038941394,
         -5.1346784234252709, 3.5188371203851792, -2.4656213855503459, 1.7528817498351901,
         -1.2589642353307966, 0.91111854829464001, -0.66675300253756831, 0.48765448904792197
        },
        /* [123] 1.375 <= y <= 1.5 2^-8, degree 10, 58.7 bits */
        {
         25.799497616968385, 5.5120701986634663e-16, -11.078905628690567, 6.1466472163777564,
         -3.7014299042581658, 2.3159526134747175, -1.481621242673979, 0.96171641334624447,
         -0.63065908949101546, 0.41671878776907739, -0.27818921408025327, 0.18576904764644434
        },
        /* [124] 1.5 <= y <= 1.625 2^-8, degree 10, 58.5 bits */
        {
         24.503970014350028, -1.7528596436703323e-15, -9.6993028825286078, 4.9499515890930192,
         -2.7421459314441972, 1.5784174037626257, -0.92898006597443328, 0.55474885826549325,
         -0.33467786061014093, 0.20345052225671043, -0.12486694250316967, 0.076712019071052226
        },
        /* [125] 1.625 <= y <= 1.75 2^-8, degree 10, 59.0 bits */
        {
         23.363903367308168, -5.5588299813608362e-16, -8.5790623434290545, 4.0533162025206604,
         -2.0789685123159458, 1.1079988196162283, -0.60379506890420376, 0.33384770323285901,
         -0.18648769714671432, 0.10496727744673395, -0.059619088225959294, 0.033913534281101852
        },
        /* [126] 1.75 <= y <= 1.875 2^-8, degree 10, 61.3 bits */
        {
         22.351046426275968, 5.6881368713264157e-16, -7.6552092351235137, 3.3668983744538612,
         -1.6077025786435113, 0.79771392879760683, -0.40471842082638693, 0.20833887697551562,
         -0.10835097474384685, 0.056780355646888742, -0.03001289256320111, 0.015894880339277113
        },
        /* [127] 1.875 <= y <= 2 2^-8, degree 10, 61.6 bits */
        {
         21.443796164497655, -1.1204494830700879e-15, -6.8830721445138083, 2.831590042755697,
         -1.2647822059412113, 0.58705428991190334, -0.27861878366871162, 0.1341704772465766,
         -0.065275578429755676, 0.03199986752333691, -0.015817629352945336, 0.0078365214086183257
        },
        /* [128] 1 <= y <= 1.125 2^-7, degree 10, 55.7 bits */
        {
         20.245097389159145, 2.8462345147765125e-16, -11.881390248664012, 8.9112815682611863,
         -7.2577135565123667, 6.1426105450768498, -5.3159804315311039, 4.6680166608489921,
         -4.1411639396422624, 3.7019149367479751, -3.3555994954810466, 3.0316411856343253
        },
        /* [129] 1.125 <= y <= 1.25 2^-7, degree 10, 57.4 bits */
        {
         18.886340621459116, -5.284370383205745e-16, -9.9515185770580796, 6.6764671230645609,
         -4.8646637316934882, 3.6836048798796774, -2.8522011112303107, 2.240841954090393,
         -1.7786482101311072, 1.4225961946165795, -1.1519037499867861, 0.93112750728934723
        },
        /* [130] 1.25 <= y <= 1.375 2^-7, degree 10, 58.2 bits */
        {
         17.738039354147539, 1.166936235907668e-15, -8.4847687467729589, 5.1490499520287765,
         -3.3940725303654964, 2.325137517072561, -1.6288167090786638, 1.1577768288189463,
         -0.83143904120445844, 0.60165676108242472, -0.44025463408228943, 0.3219753753060916
        },
        /* [131] 1.375 <= y <= 1.5 2^-7, degree 10, 59.4 bits */
        {
         16.751790124351682, 4.0209119980043685e-16, -7.3402346982694775, 4.066206144781658,
         -2.4469812079399813, 1.5304662155103324, -0.97886234645147607, 0.63526280205714136,
         -0.41652628760880728, 0.27519782198427728, -0.18369825418921792, 0.12266133262254239
        },
        /* [132] 1.5 <= y <= 1.625 2^-7, degree 10, 59.0 bits */
        {
         15.893362014243014, 7.3642533006813182e-16, -6.4275173816198743, 3.2750370075893733,
         -1.813021626427419, 1.0431795458572666, -0.61380189746830072, 0.36646793082093537,
         -0.22105717368285988, 0.13436555839980738, -0.082458859898552853, 0.050654851307665949
        },
        /* [133] 1.625 <= y <= 1.75 2^-7, degree 10, 59.0 bits */
        {
         15.137790987674824, -1.4220082888040524e-16, -5.6862812767995656, 2.6821771033558801,
         -1.3747062564130454, 0.73234931899155575, -0.39897686068976951, 0.22055667059438816,
         -0.12318473649337491, 0.06932815354546884, -0.039373104822919398, 0.022395121201648223
        },
        /* [134] 1.75 <= y <= 1.875 2^-7, degree 10, 59.3 bits */
        {
         14.466397279047657, 2.7943262622187421e-16, -5.0749045692869963, 2.228263032534076,
         -1.0632017763945205, 0.52731085599666871, -0.26745235968908626, 0.13764914782566445,
         -0.071576077256300968, 0.037504183861889154, -0.019821937364466056, 0.010496870663803743
        },
        /* [135] 1.875 <= y <= 2 2^-7, degree 10, 59.8 bits */
        {
         13.864895320861182, 5.5621880192829112e-16, -4.5638598320810209, 1.8742359879802253,
         -0.8365121645364203, 0.3880942636400842, -0.18413580554462458, 0.088652461434010121,
         -0.043123448668343299, 0.021137572492987443, -0.010447274921434926, 0.0051754444045372895
        },
        /* [136] 1 <= y <= 1.125 2^-6, degree 10, 55.8 bits */
        {
         13.0699891209269, -7.3870854295746477e-16, -7.8800816004527032, 5.8995214028211196,
         -4.8009107968916513, 4.0613379236676037, -3.5136720857169177, 3.0846850532351939,
         -2.7360595966186585, 2.4455149740300253, -2.2164884318121523, 2.0023202069328812
        },
        /* [137] 1.125 <= y <= 1.25 2^-6, degree 10, 57.2 bits */
        {
         12.168677066210456, 4.0976031568635481e-16, -6.6023038496687798, 4.4210749850841413,
         -3.2185643656335827, 2.4359152424014643, -1.8854802761884182, 1.4809720446035888,
         -1.1752900384542113, 0.93988146293422281, -0.7609490857998924, 0.61504362413374902
        },
        /* [138] 1.25 <= y <= 1.375 2^-6, degree 10, 58.1 bits */
        {
         11.406724428631547, -4.0175844094798429e-16, -5.6309333210639467, 3.410413750064818,
         -2.2460108039450546, 1.5378269044692825, -1.0768999026401811, 0.76527122156502203,
         -0.54945897775073249, 0.3975447541226349, -0.29086120867863652, 0.21269584698804173
        },
        /* [139] 1.375 <= y <= 1.5 2^-6, degree 10, 59.5 bits */
        {
         10.752103999130323, 5.159476539076333e-16, -4.8727851136595461, 2.6937861481693144,
         -1.6195672456256549, 1.0123933822715583, -0.64726719195284976, 0.41994922931414935,
         -0.2752931155569302, 0.18185549145956581, -0.12137463280596197, 0.081036810324133735
        },
        /* [140] 1.5 <= y <= 1.625 2^-6, degree 10, 58.5 bits */
        {
         10.182161945254276, -4.9908880622101736e-16, -4.2680664107995581, 2.1700973915599939,
         -1.200177953940669, 0.69015830703234826, -0.40592599977817062, 0.24228711400477035,
         -0.14611809691822381, 0.088799835361572876, -0.054487886803363375, 0.033468235463037899
        },
        /* [141] 1.625 <= y <= 1.75 2^-6, degree 10, 60.5 bits */
        {
         9.6803742853776065, -6.5090881238895262e-16, -3.7768632836446048, 1.7776070315667456,
         -0.91017288334517688, 0.48458466344540158, -0.26388885407262896, 0.14583569311528097,
         -0.08143315882561504, 0.045822132996746243, -0.026019614927910325, 0.014797939443177581
        },
        /* [142] 1.75 <= y <= 1.875 2^-6, degree 10, 59.9 bits */
        {
         9.2343745769706924, 4.3888557148316256e-16, -3.3716375012160844, 1.477054296910258,
         -0.70404155378292421, 0.34896161343310622, -0.17691826281374115, 0.091025884960174983,
         -0.047321218368150168, 0.024790521387693776, -0.013100406896023816, 0.0069365377337500559
        },
        /* [143] 1.875 <= y <= 2 2^-6, degree 10, 59.1 bits */
        {
         8.8347039041956332, -2.3831996956524411e-16, -3.0328500851315066, 1.2426038914560023,
         -0.55401434110170522, 0.25686548101001649, -0.1218191929911721, 0.05863116354928874,
         -0.028513065459125801, 0.013973339905004744, -0.0069052307661337823, 0.0034203041630508592
        },
        /* [144] 1 <= y <= 1.125 2^-5, degree 10, 55.7 bits */
        {
         8.306369436380292, 5.6380092071034365e-16, -5.2384222971644734, 3.9123469213526603,
         -3.1802950581630491, 2.6885655996770481, -2.3249452687686301, 2.0404014022282717,
         -1.8093286473787389, 1.6168596004059954, -1.4651867459268237, 1.3234262065174915
        },
        /* [145] 1.125 <= y <= 1.25 2^-5, degree 10, 56.9 bits */
        {
         7.7070779998665779, 3.8149171640676954e-16, -4.390914778314821, 2.9328436618944096,
         -2.132680228171965, 1.6129418492419905, -1.2478646608832336, 0.97979902229072868,
         -0.77734776372557568, 0.62150940150984102, -0.50309618899173003, 0.40657049728449535
        },
        /* [146] 1.25 <= y <= 1.375 2^-5, degree 10, 58.8 bits */
        {
         7.2002330471736293, -2.6423458887883249e-16, -3.746434633951834, 2.263078232339315,
         -1.4886349624261082, 1.0185054682352295, -0.71286952817844074, 0.50639191393118654,
         -0.36347985086779794, 0.26292388826945906, -0.19232963085522323, 0.1406209421969134
        },
        /* [147] 1.375 <= y <= 1.5 2^-5, degree 10, 58.7 bits */
        {
         6.7646105014341558, 1.800278627089486e-16, -3.2432740409212077, 1.7880484301261661,
         -1.0736979582797648, 0.67065568907203466, -0.42855180031843071, 0.27793661515984425,
         -0.18214278499541572, 0.12029206069388143, -0.08026952013130953, 0.053583613000707304
        },
        /* [148] 1.5 <= y <= 1.625 2^-5, degree 10, 61.1 bits */
        {
         6.3851940726624887, 2.8545304885895488e-16, -2.841828714540052, 1.440828224668401,
         -0.79584813318463454, 0.45728718217769626, -0.26881151346473936, 0.16038126320921864,
         -0.096691723949748551, 0.058747129374868264, -0.036039826649751923, 0.022132933686493689
        },
        /* [149] 1.625 <= y <= 1.75 2^-5, degree 10, 58.6 bits */
        {
         6.0510280413251181, -4.3266920137580461e-16, -2.5156556314762333, 1.180536702453153,
         -0.60367764179801997, 0.32114119149903547, -0.17478330293865632, 0.096551392934378519,
         -0.053895518009560953, 0.0303187575469957, -0.017212400933844275, 0.009787279170114566
        },
        /* [150] 1.75 <= y <= 1.875 2^-5, degree 10, 59.5 bits */
        {
         5.7539113294230431, -3.3918204792706627e-16, -2.2465069412429242, 0.98117284670401461,
         -0.46705910815592699, 0.23130577656359141, -0.11719967504336652, 0.060273770239268575,
         -0.031323551174349658, 0.016405189086453314, -0.0086672493661359273, 0.0045883471465722027
        },
        /* [151] 1.875 <= y <= 2 2^-5, degree 10, 59.7 bits */
        {
         5.4875696730707704, 3.0152040752067197e-17, -2.0214328566040769, 0.82562381158010889,
         -0.36760637644264382, 0.17029182531866352, -0.080712634860749102, 0.038829183748750391,
         -0.018876458852423134, 0.0092481173870364603, -0.0045690808269407968, 0.0022627126050580927
        },
        /* [152] 1 <= y <= 1.125 2^-4, degree 10, 55.6 bits */
        {
         5.1353469789929447, 2.8545828075076319e-16, -3.4931095794782454, 2.6003352178030199,
         -2.1108415695491494, 1.782879813168204, -1.5407845912666966, 1.3515766286657835,
         -1.198071409232573, 1.0703070742882865, -0.96966290896128049, 0.87566392787785152
        },
        /* [153] 1.125 <= y <= 1.25 2^-4, degree 10, 56.9 bits */
        {
         4.7356086761890275, 3.8654141956049015e-17, -2.929704452669414, 1.9501028177420003,
         -1.4160270173800193, 1.069947038838883, -0.82723085704729071, 0.64920562492828493,
         -0.51486410961563323, 0.41151802469457249, -0.33302598816943163, 0.26907146086339967
        },
        /* [154] 1.25 <= y <= 1.375 2^-4, degree 10, 58.4 bits */
        {
         4.3973385241235166, 3.7832698110426251e-16, -2.5010993219133222, 1.505329778548703,
         -0.98873758264404343, 0.67583411850923858, -0.47270648047485236, 0.33561809540370796,
         -0.24080387119410446, 0.17412883546231719, -0.12734076073855016, 0.093083152354079504
        },
        /* [155] 1.375 <= y <= 1.5 2^-4, degree 10, 57.9 bits */
        {
         4.1064425062605867, 1.4086432061527512e-16, -2.1663554058278698, 1.1897714781264188,
         -0.71336679995916574, 0.4451452589908873, -0.28424988980530408, 0.18425177582842292,
         -0.12069674061937392, 0.079684194811554435, -0.05315712894917899, 0.035476289703338409
        },
        /* [156] 1.5 <= y <= 1.625 2^-4, degree 10, 61.0 bits */
        {
         3.8529456184674999, 1.8739970682676449e-17, -1.899190099908882, 0.95904462801375001,
         -0.5289211989434649, 0.30360555990739202, -0.17834228851409856, 0.10634609094929065,
         -0.064086789782137429, 0.038923517239683604, -0.023871467301645952, 0.014656375156044506
        },
        /* [157] 1.625 <= y <= 1.75 2^-4, degree 10, 59.5 bits */
        {
         3.6295679362258522, 6.0306537665350812e-17, -1.6820500106900675, 0.78603111643583889,
         -0.4013182222333172, 0.21326971804339975, -0.11598733488203385, 0.064035922369595918,
         -0.035729193314208312, 0.020091997264479015, -0.011403018342280722, 0.0064822772890936447
        },
        /* [158] 1.75 <= y <= 1.875 2^-4, degree 10, 58.7 bits */
        {
         3.4308583529399117, -6.585318747668373e-17, -1.5028185974323016, 0.65347901714662349,
         -0.31057925395856695, 0.15364793386368544, -0.077792264055671786, 0.039984017395302815,
         -0.020769642584310664, 0.010873658537163522, -0.0057429935982206788, 0.0030394632619304657
        },
        /* [159] 1.875 <= y <= 2 2^-4, degree 10, 60.6 bits */
        {
         3.2526453187007687, 2.3290807759120933e-17, -1.3528950271519298, 0.55003109638275083,
         -0.24450902137766953, 0.11314522445656014, -0.053585413480219161, 0.025763531720914074,
         -0.012518794425984145, 0.0061309433391705959, -0.0030280397313404142, 0.0014991402325724445
        },
        /* [160] 1 <= y <= 1.125 2^-3, degree 10, 55.3 bits */
        {
         3.016831229242166, -6.4845964696304793e-17, -2.3394737517447668, 1.7330099344823957,
         -1.4045110241399654, 1.1849761150030156, -1.0232513438724928, 0.89704634375914549,
         -0.79477589615105004, 0.70973497066153879, -0.642777397727194, 0.58030024524074031
        },
        /* [161] 1.125 <= y <= 1.25 2^-3, degree 10, 56.7 bits */
        {
         2.7489932595717863, -5.5392561269363996e-17, -1.9639037481994051, 1.3002663764321745,
         -0.94261945009100634, 0.71142635632721285, -0.54958605825198703, 0.43103763243056137,
         -0.34166839322182208, 0.27297284597791299, -0.22082816295506177, 0.17836661183672434
        },
        /* [162] 1.25 <= y <= 1.375 2^-3, degree 10, 58.3 bits */
        {
         2.5221393117464808, -8.6147969630960256e-17, -1.6780645666315959, 1.0041315534555435,
         -0.65845615597363383, 0.44954672941854029, -0.31416474069260641, 0.22290837782031672,
         -0.15985129436772194, 0.11554073222580871, -0.084464054386996515, 0.061721977875800638
        },
        /* [163] 1.375 <= y <= 1.5 2^-3, degree 10, 58.1 bits */
        {
         2.3268856947505774, -1.6838534026473475e-16, -1.4547312815822624, 0.79394438783824084,
         -0.47525594879850169, 0.29620494715918988, -0.18897878106212815, 0.12241415824946933,
         -0.08014571952205822, 0.052888672567764028, -0.035268490091151267, 0.023530056107760638
        },
        /* [164] 1.5 <= y <= 1.625 2^-3, degree 10, 58.7 bits */
        {
         2.156588411491188, -2.0623527538334556e-16, -1.2764189339778207, 0.64020366317778243,
         -0.35250411374373902, 0.20209069671440044, -0.118605594630281, 0.070676076120088097,
         -0.042567488649353814, 0.025841741416772649, -0.015842325081378492, 0.00972347176492026
        },
        /* [165] 1.625 <= y <= 1.75 2^-3, degree 10, 57.8 bits */
        {
         2.0063967121185189, 5.4491533235122462e-17, -1.1314457018934823, 0.52487816403425946,
         -0.26755423611675561, 0.14200486496362483, -0.077159928801854905, 0.042569487204247601,
         -0.023738370972765654, 0.013342768787640423, -0.0075695208193393123, 0.0043015706367642847
        },
        /* [166] 1.75 <= y <= 1.875 2^-3, degree 10, 58.2 bits */
        {
         1.8726771200629189, 9.4765834845363253e-17, -1.0117453340933573, 0.43649323881551544,
         -0.20712740693336099, 0.10233648697646441, -0.051765600165078834, 0.026587574373404085,
         -0.013802860054610453, 0.0072228111661193153, -0.0038132085028422169, 0.0020174195572351503
        },
        /* [167] 1.875 <= y <= 2 2^-3, degree 10, 59.0 bits */
        {
         1.7526481144199721, -4.2523483259634558e-17, -0.91159028280898036, 0.36749269194124023,
         -0.1631156753680818, 0.075381165780481763, -0.035667194119821263, 0.017136004294826604,
         -0.0083216546596771353, 0.0040734341369377891, -0.0020110035743006066, 0.00099526132657148827
        },
        /* [168] 1 <= y <= 1.125 2^-2, degree 10, 55.1 bits */
        {
         1.5936549610659525, 7.4190910350727805e-17, -1.5783908412366405, 1.1582854100361868,
         -0.93738792770718093, 0.78978496202495063, -0.68135104311204153, 0.59686677048603987,
         -0.52849856752825231, 0.47171062527440399, -0.42702265691532598, 0.3853736804439189
        },
        /* [169] 1.125 <= y <= 1.25 2^-2, degree 10, 56.3 bits */
        {
         1.4127975551909608, -9.1344232533395747e-17, -1.3273243057787341, 0.86939073933604072,
         -0.6294681770689472, 0.47439502406382961, -0.36612548513384374, 0.28692833086308339,
         -0.22729626356466481, 0.18150151252694219, -0.1467642582664154, 0.11849843041982658
        },
        /* [170] 1.25 <= y <= 1.375 2^-2, degree 10, 58.3 bits */
        {
         1.2593424590635376, 1.4587601620139928e-18, -1.1361765704956297, 0.67158607621708777,
         -0.4399425198326517, 0.29989980706396413, -0.20938341092440887, 0.14844485166084781,
         -0.1063844606938531, 0.076853581715037492, -0.0561566043963155, 0.041020107957406654
        },
        /* [171] 1.375 <= y <= 1.5 2^-2, degree 10, 58.2 bits */
        {
         1.1270220050532973, 9.5283274553118476e-17, -0.9867903785625094, 0.53111650896541174,
         -0.31770368749240413, 0.19768166796688341, -0.12600172238610177, 0.081552550143804567,
         -0.053358705543432201, 0.035192368384243569, -0.023456769598433291, 0.015643274808781513
        },
        /* [172] 1.5 <= y <= 1.625 2^-2, degree 10, 60.4 bits */
        {
         1.0113960926212415, 2.8863342432234135e-17, -0.86749940367641998, 0.42831716554182225,
         -0.23576746607812868, 0.1349195314472553, -0.079111263907056903, 0.04710133226618636,
         -0.028350206294679259, 0.017201025999415528, -0.010540070903399885, 0.0064664345159736363
        },
        /* [173] 1.625 <= y <= 1.75 2^-2, degree 10, 61.1 bits */
        {
         0.90922133170708175, -1.4910040387931959e-17, -0.77050629688879257, 0.35116392414168646,
         -0.17904482622373893, 0.094834541239812858, -0.051486010529804713, 0.028379315317101441,
         -0.015815202341572809, 0.0088841504539630967, -0.0050376567555510286, 0.0028615499770961398
        },
        /* [174] 1.75 <= y <= 1.875 2^-2, degree 10, 59.9 bits */
        {
         0.81806696693209946, -4.2329253856912705e-17, -0.69042519087446264, 0.29200192881993398,
         -0.13868509546395158, 0.068360639223799424, -0.034554290827426698, 0.017730117030353196,
         -0.0091988538095558216, 0.0048106524015155989, -0.0025385188470651698, 0.0013424355831238687
        },
        /* [175] 1.875 <= y <= 2 2^-2, degree 10, 58.1 bits */
        {
         0.73607117749714945, -2.4388710754242217e-17, -0.62343066762516863, 0.24578844750538903,
         -0.10928242444933477, 0.050364324011335643, -0.023817621880310214, 0.011430231383500068,
         -0.0055477224562987303, 0.0027137792144695336, -0.0013391509356673664, 0.00066244275534241737
        }
    };
    return row[i];
}

/* h*^5 as two doubles: eps = h*^5 beta^-5 at zero overlap, exact in double precision from beta = 7
 * on. Proved. */
COR_INLINE const double *cor_rows_h_star_5(int i)
{
    static const double row[1][2] = {
        /* h*^5, and what that double lacks */
        {
         5.1583817042676854, -1.6948637100160543e-16
        }
    };
    return row[i];
}

/* u = ln(beta) >= 10: a_0 + a_0' + (a_1 + a_1') u + mu (a_2 + a_3 u + a_4 u^2) + mu^2 (a_5 + ... + a_8 u^3),
 * mu = beta^(-5/3), through nine enclosed collisions with u = 9.5 ... 13.5.
 * Relative error, proved for every finite double: below 2^-64.9. */
COR_INLINE const double *cor_rows_far_eps_zero_force(int i)
{
    static const double row[1][11] = {
        /* eps beta^(5/3) at zero force */
        {
         1.3103706971044482, 1.025387009368333e-16, 5.1655384079723314e-23, -2.5795512768190169e-39,
         2.1682447830144631, -3.8157141418542051, 3.708733633902359e-13, 5.6806442958008745,
         -11.496753274695909, 2.7784433269135693, -2.3012819495831118e-05
        }
    };
    return row[i];
}
COR_INLINE const double *cor_rows_far_duration_zero_overlap(int i)
{
    static const double row[1][11] = {
        /* duration/beta at zero overlap */
        {
         -1.5911283981302142, 9.7031041497375014e-17, 3.3333333333333335, -1.4802973504705574e-16,
         3.9311120913152524, -2.8705663999324002e-13, 1.0927097501855736e-14, 2.4666016663613646,
         -0.00016642892455404412, 1.7250178397203042e-05, -6.0536568897189937e-07
        }
    };
    return row[i];
}
COR_INLINE const double *cor_rows_far_duration_zero_force(int i)
{
    static const double row[1][11] = {
        /* duration beta^(2/3) at zero force */
        {
         0.52927070558465061, -2.1335895173810267e-17, 2.9119348824543296, -6.8190283147420995e-17,
         -0.18278579500949746, 1.4065532711995616, 2.1198411899401819, 5.5080947042672088,
         -5.6628207646445743, 6.7277050575607387, 2.0558889783401417
        }
    };
    return row[i];
}
COR_INLINE const double *cor_rows_far_max_overlap(int i)
{
    static const double row[1][11] = {
        /* largest overlap beta^(2/3) */
        {
         1.3103706971044482, 1.0253950335682593e-16, -1.2338512679165183e-24, 6.6375498951929449e-41,
         1.178244435098297, -1.9078570709220557, -6.4134792979591604e-15, 3.3797683541014796,
         -5.8578204993253475, 0.69445028272693299, -1.3515008382677975e-07
        }
    };
    return row[i];
}
COR_INLINE const double *cor_rows_far_time_of_max_overlap(int i)
{
    static const double row[1][11] = {
        /* time of the largest overlap beta^(2/3) */
        {
         0.41120190639282261, 1.0851349915746465e-17, 1.4559674412271648, -3.4096502745150609e-17,
         -0.24750829704283556, 1.2532768291104721, 0.52996029748180662, 1.8171711928851768,
         -0.99112670989914731, 2.3075357726100187, 0.25698517389487902
        }
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
        /* beta at zero force */
        {
         1.3103706971044482, 1.025387009368333e-16, 0.99280827378344583, -1.7471609294770694,
         1.698176085025842e-13, -1.1048465904886993, 4.7267557324891278, -4.8329331676058276,
         -1.0537239708479985e-05, -5.7676040315073912e-26
        }
    };
    return row[i];
}

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
 * FE_INEXACT may be raised. Arguments that may be NaN are compared by their bits (core/exact.h). */
#ifndef COR_RUNTIME_SPHERE_EVAL_H
#define COR_RUNTIME_SPHERE_EVAL_H


/* ---- tails ---- */

/* Arguments outside a table: beta = -0 counts as 0; negative numbers and NaN give NaN. */

/* beta^(2/3) for 1 <= beta < 8. Relative error below 2^-100. */
COR_INLINE struct cor_inline_pair cor_inline_two_thirds(double beta)
{
    /* r has 26 bits, so its square is exact; |d| < 2^-24 whatever the error of cbrt */
    const double r = cor_inline_head(cbrt(beta)), square = r * r;
    const struct cor_inline_pair cube = cor_inline_product(square, r);
    const double d = (COR_INLINE_KEEP(beta - cube.hi) - cube.lo) / beta; /* r^3 = beta (1 - d) */
    return cor_inline_sum(square, square * (d * (2.0 / 3 + d * (5.0 / 9))));
}

/* The exponent e of a normal beta = m 2^e, 1 <= m < 2 */
COR_INLINE int cor_inline_exponent(double beta)
{
    return (int)(cor_inline_bits(beta) >> 52) - 1023;
}

COR_INLINE double cor_inline_significand(double beta)
{
    return cor_inline_from_bits((cor_inline_bits(beta) & UINT64_C(0xfffffffffffff)) | UINT64_C(0x3ff0000000000000));
}

/* ln(beta) for 7 <= beta < infinity. The absolute error is below 2^-53 if that of log is below 1 ulp. */
COR_INLINE struct cor_inline_pair cor_inline_log(double beta)
{
    /* ln(2) in two parts; the first has 42 bits, so that its products with exponents are exact */
    const double ln2_hi = 0.69314718055989033, ln2_lo = 5.4979230187083712e-14;
    /* significands above sqrt(2) are halved, so that |ln(m)| < 0.35: error 2^-54 */
    const double half = cor_inline_significand(beta);
    const int up = half > 1.4142135623730951, e = cor_inline_exponent(beta) + up;
    return cor_inline_sum(e * ln2_hi, e * ln2_lo + log(up ? half * 0.5 : half));
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
    /* mu < 6e-8, so its rounding errors are negligible */
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
 * underflows. The relative error is that of the factor plus 2^-100. */
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
    denominator.hi = tiny ? eps * COR_INLINE_2_500 : eps;
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

#endif
