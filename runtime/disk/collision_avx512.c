/* SPDX-License-Identifier: MIT */
#define VECTOR 8
#define ACCUMULATORS 4
#include "runtime/disk/collision_kernel.h"

COLLISION(avx512)
