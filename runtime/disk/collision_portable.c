/* SPDX-License-Identifier: MIT */
#define VECTOR 2
#define ACCUMULATORS 8
#include "runtime/disk/collision_kernel.h"

COLLISION(portable)
