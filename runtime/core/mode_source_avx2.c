/* SPDX-License-Identifier: MIT */
#define VECTOR 4
#include "runtime/core/mode_source_kernel.h"

MODE_SOURCE(avx2)
