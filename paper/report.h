/* SPDX-License-Identifier: MIT */
/* The figures of Gerl and Zippelius, Phys. Rev. E 59, 2361 (1999), one file each: stem.c writes docs/paper/stem.csv,
 * which stem.gp, where there is one, draws as docs/paper/stem.svg. */
#ifndef COR_PAPER_REPORT_H
#define COR_PAPER_REPORT_H

#include <stddef.h>
#include <stdio.h>

enum { VERDICT_SIZE = 3000 };

struct figure {
    const char *stem, *paper, *subject;
    /* Writes the csv file, and one sentence on where the figure agrees with the paper, where not and why. 1, or 0 after
     * saying on stderr what is wrong; whether the file could be written is for the caller to find out. */
    int (*write)(FILE *csv, char verdict[VERDICT_SIZE]);
};

extern const struct figure restitution_figure, shapes_figure, spectrum_figure, sequence_figure, energies_figure,
    ranking_figure, wall_limit_figure, mode_limit_figure, load_figure, load_dynamic_figure, contact_figure,
    rayleigh_figure, oscillation_figure;

/* The i-th of n points from a to b, equal steps in the logarithm. */
double log_point(double a, double b, int i, int n);

/* One more column: a comma and six digits, or nothing after the comma where value is NaN. */
void write_cell(FILE *csv, double value);

#endif
