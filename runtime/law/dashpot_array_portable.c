/* SPDX-License-Identifier: MIT */
#include "runtime/law/dashpot_array_kernel.h"

DASHPOT_LOOPS_OF(portable)
