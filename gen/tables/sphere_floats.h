/* SPDX-License-Identifier: MIT */
/* generated/sphere_float_tables.h, the tables of the sphere's functions in float arithmetic. */
#ifndef COR_GEN_TABLES_SPHERE_FLOATS_H
#define COR_GEN_TABLES_SPHERE_FLOATS_H

#include <stdio.h>

#include "tables/disk.h"

int sphere_float_tables_write(FILE *file, const struct disk_table *none);

#endif
