/* SPDX-License-Identifier: MIT */
/* scene.h for the files that define its functions: here each has a name of its own, and functions.c defines the public
 * one, which calls it in the default floating-point environment. Included before all else. */
#define COR_SCENE_INSIDE
#include "generated/scene_functions.inc"

#include "cor/scene.h"
