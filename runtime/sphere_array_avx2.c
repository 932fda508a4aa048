/* SPDX-License-Identifier: MIT */
#include "sphere_array_kernel.h"

ARRAYS(avx2)
