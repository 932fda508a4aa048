/* SPDX-License-Identifier: MIT */
#define VECTOR 2
#include "runtime/core/mode_source_kernel.h"

MODE_SOURCE(portable)
