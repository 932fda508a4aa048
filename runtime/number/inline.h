/* SPDX-License-Identifier: MIT */
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
