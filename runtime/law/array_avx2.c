/* SPDX-License-Identifier: MIT */
#include "runtime/law/array_kernel.h"

LAW_LOOPS_OF(avx2)
