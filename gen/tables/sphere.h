/* SPDX-License-Identifier: MIT */
/* generated/sphere_tables.h, the tables of the runtime; generated/cor_sphere.h, the same tables and the same evaluator
 * as one header to embed; generated/sphere_float_tables.h, the tables of float arithmetic. */
#ifndef COR_GEN_TABLES_SPHERE_H
#define COR_GEN_TABLES_SPHERE_H

#include <stdio.h>

int sphere_tables_write(FILE *file);
int sphere_header_write(FILE *file);
int sphere_float_tables_write(FILE *file);

/* All of them share data that are computed once and kept. This function frees them. */
void sphere_tables_clear(void);

#endif
