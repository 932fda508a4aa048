/* SPDX-License-Identifier: MIT */
#include "disk_rayleigh_kernel.h"

RAYLEIGH(avx2)
