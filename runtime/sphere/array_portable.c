/* SPDX-License-Identifier: MIT */
#include "runtime/sphere/array_kernel.h"

ARRAYS(portable)
