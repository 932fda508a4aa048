/* SPDX-License-Identifier: MIT */
#define VECTOR 8
#define ACCUMULATORS 4
#include "disk_collision_kernel.h"

COLLISION(avx512)
