/* SPDX-License-Identifier: MIT */
/* Included before a source file of the runtime, makes gcc a compiler without vectors, attributes and the rest that the
 * runtime uses only where __GNUC__ is defined. The C library's headers need the name and come first. */
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
