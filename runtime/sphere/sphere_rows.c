/* SPDX-License-Identifier: MIT */
/* The rows of the sphere's tables, which all sources of the library share */
#define COR_ROWS_DEFINE
#include "generated/sphere_rows.h"
#include "generated/sphere_float_tables.h"
