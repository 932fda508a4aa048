/* SPDX-License-Identifier: MIT */
/* Included before a source file of the runtime, this file hides __GNUC__, so that gcc compiles the file without the
 * parts that need it, such as vectors and attributes. The C library's headers need __GNUC__ and come first. */
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
