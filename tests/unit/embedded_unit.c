/* SPDX-License-Identifier: MIT */
/* Uses generated/cor_sphere.h as a user does: compiled into another unit, in C99, C++11 or CUDA (tests/header/run). The
 * file includes it twice, which must be harmless. */
#include "cor_sphere.h"

#include "embedded.h"

const struct embedded_function embedded_functions[EMBEDDED_FUNCTIONS] = {
#define EMBEDDED_ROW(quantity) {#quantity, cor_inline_##quantity},
    EMBEDDED_LIST(EMBEDDED_ROW)
#undef EMBEDDED_ROW
};

#if defined(__CUDACC__) || defined(__HIPCC__)
/* Calls every function in a kernel. nvcc always compiles it; it runs only if a device exists. */
__global__ void embedded_kernel(const double *x, double *y, int n)
{
    const int i = (int)(blockIdx.x * blockDim.x + threadIdx.x);
    if (i >= n)
        return;
    int k = 0;
#define EMBEDDED_ROW(quantity) y[k++ * n + i] = cor_inline_##quantity(x[i]);
    EMBEDDED_LIST(EMBEDDED_ROW)
#undef EMBEDDED_ROW
}
#endif
