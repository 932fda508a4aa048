/* SPDX-License-Identifier: MIT */
#define VECTOR 2
#define ACCUMULATORS 8
#include "disk_collision_kernel.h"

COLLISION(portable)
