/* SPDX-License-Identifier: MIT */
/* generated/sphere_tables.h, the tables of the runtime, and generated/cor_sphere.h, the same tables and the same
 * evaluator as one header to embed. */
#ifndef COR_GEN_TABLES_SPHERE_H
#define COR_GEN_TABLES_SPHERE_H

#include <stdio.h>

#include "approximation/interpolant.h"
#include "tables/disk.h"

int sphere_tables_write(FILE *file, const struct disk_table *none);
int sphere_header_write(FILE *file, const struct disk_table *none);

/* The interpolant from which the tables are cut; NULL after reporting a failure. */
const struct interpolant *sphere_tables_interpolant(void);

/* All of them share data that are computed once and kept. This function frees them. */
void sphere_tables_clear(void);

#endif
