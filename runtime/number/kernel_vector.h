/* SPDX-License-Identifier: MIT */
/* Vectors of VECTOR doubles, for loops that are compiled once for every instruction set. Without GNU's vectors a vector
 * is one double. No set may fuse a multiplication with an addition, and sums must be split into the same parts for all
 * widths. All sets then give the same bits. */
#ifndef COR_RUNTIME_KERNEL_VECTOR_H
#define COR_RUNTIME_KERNEL_VECTOR_H

#include <string.h>

#include "runtime/number/kernel.h"
#include "runtime/number/sets.h" /* COR_LANES */

#if defined(__AVX512F__)
#define VECTOR 8
#elif defined(__AVX2__)
#define VECTOR 4
#elif defined(__GNUC__)
#define VECTOR 2
#else
#define VECTOR 1
#endif

#ifdef __GNUC__
typedef double vector __attribute__((vector_size(VECTOR * sizeof(double))));
#else
typedef double vector;
#endif

COR_KERNEL vector load_vector(const double *from)
{
    vector x;
    memcpy(&x, from, sizeof x);
    return x;
}

COR_KERNEL void store_vector(double *to, vector x)
{
    memcpy(to, &x, sizeof x);
}

COR_KERNEL vector fill_vector(double x)
{
#if VECTOR == 8 /* gcc 12 compiles this to one instruction */
    const vector result = {x, x, x, x, x, x, x, x};
#elif VECTOR == 4
    const vector result = {x, x, x, x};
#elif VECTOR == 2
    const vector result = {x, x};
#else
    const vector result = x;
#endif
    return result;
}

COR_KERNEL double sum_of_lanes(const double sum[COR_LANES])
{
    return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

#endif
