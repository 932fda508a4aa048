/* SPDX-License-Identifier: MIT */
#include "runtime/disk/rayleigh_kernel.h"

RAYLEIGH(avx512)
