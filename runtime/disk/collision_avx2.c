/* SPDX-License-Identifier: MIT */
#define VECTOR 4
#define ACCUMULATORS 8
#include "runtime/disk/collision_kernel.h"

COLLISION(avx2)
