/* SPDX-License-Identifier: MIT */
#include "report.h"

#include <math.h>

double log_point(double a, double b, int i, int n)
{
    return a * pow(b / a, (double)i / (n - 1));
}

void write_cell(FILE *csv, double value)
{
    if (isnan(value))
        fputs(",", csv);
    else
        fprintf(csv, ",%.6g", value);
}
