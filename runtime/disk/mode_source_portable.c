/* SPDX-License-Identifier: MIT */
#define VECTOR 2
#include "runtime/disk/mode_source_kernel.h"

MODE_SOURCE(portable)
