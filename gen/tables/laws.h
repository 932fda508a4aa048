/* SPDX-License-Identifier: MIT */
/* generated/tsuji_tables.h and generated/hunt_crossley_tables.h: the times of these laws that have no closed form.
 * generated/disk_law_tables.h: contact time and load of the disk. */
#ifndef COR_GEN_TABLES_LAWS_H
#define COR_GEN_TABLES_LAWS_H

#include <stdio.h>

int tsuji_tables_write(FILE *file);
int hunt_crossley_tables_write(FILE *file);
int disk_law_tables_write(FILE *file);

#endif
