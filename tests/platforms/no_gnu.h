/* SPDX-License-Identifier: MIT */
/* If included before a source file of the runtime, hides from gcc all parts that the runtime uses only where __GNUC__
 * is defined, such as vectors and attributes. The C library's headers need __GNUC__ and come first. */
#ifndef COR_TESTS_PLATFORMS_NO_GNU_H
#define COR_TESTS_PLATFORMS_NO_GNU_H

#include <errno.h>
#include <fenv.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#undef __GNUC__

#endif
