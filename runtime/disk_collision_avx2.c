/* SPDX-License-Identifier: MIT */
#define VECTOR 4
#define ACCUMULATORS 8
#include "disk_collision_kernel.h"

COLLISION(avx2)
