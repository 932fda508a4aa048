/* SPDX-License-Identifier: MIT */
#define VECTOR 4
#define COLUMNS 4
#include "runtime/disk/hard_wall_kernel.h"

HARD_WALL(avx2)
