/* SPDX-License-Identifier: MIT */
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
