/* SPDX-License-Identifier: MIT */
/* Lists of exact numbers on a command line or in a file, the LIST of corgen disk-collide --help. A repeated value is
 * omitted. Values are equal if their nearest doubles are equal. */
#ifndef COR_GEN_SWEEP_VALUES_H
#define COR_GEN_SWEEP_VALUES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "support/decimal.h"

#define VALUES_MAX 1000000 /* values of a list */

struct values_rule {
    const char *option; /* without its dashes */
    struct decimal_range range;
    bool whole; /* values of a range are rounded to whole numbers; other fractions are refused */
};

struct values {
    const char *text; /* text of the list as the user wrote it; not copied */
    size_t count;
    fmpq *exact;     /* the values; values inside a log range are rounded to doubles */
    double *nearest; /* the double nearest to each */
    double least, largest;
    uint32_t check; /* checksum of the file of a list @FILE; 0: the list is on the command line */
};

/* Returns STATUS_OK, or STATUS_USAGE after a message about the first error. */
int values_parse(struct values *values, const struct values_rule *rule, const char *text);
void values_clear(struct values *values);

#endif
