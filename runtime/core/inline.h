/* SPDX-License-Identifier: MIT */
/* What a function needs to be compiled into its caller by C99, C++11, CUDA and HIP. */
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
