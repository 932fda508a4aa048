/* SPDX-License-Identifier: MIT */
/* Tables of corgen sample as text, csv, json, arrays of C, lists of Python, and tables that simulators read */
#ifndef COR_GEN_CONTACT_SAMPLE_TABLE_H
#define COR_GEN_CONTACT_SAMPLE_TABLE_H

#include <stdio.h>

#include "contact/sample.h"

/* The first three are those of enum output_format. */
enum sample_format {
    SAMPLE_TEXT,
    SAMPLE_CSV,
    SAMPLE_JSON,
    SAMPLE_C,
    SAMPLE_PYTHON,
    SAMPLE_MODELICA, /* CombiTable1Ds, CombiTable1Dv: linear interpolation alone */
    SAMPLE_OPENFOAM  /* Function1 of type table: linear interpolation alone */
};
extern const char *const sample_format_names[]; /* ends with NULL */

void sample_print(FILE *file, const struct sample *sample, const struct sample_request *request,
                  enum sample_format format);

#endif
