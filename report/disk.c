/* SPDX-License-Identifier: MIT */
/* cor_report DIRECTORY: the figures of the paper on disks as csv files, and what is to be said of each. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "report.h"

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

/* Written beside the target and renamed over it, so that no reader sees half a file. */
static int make(const struct figure *figure, const char *directory, char verdict[VERDICT_SIZE])
{
    char path[FILENAME_MAX], temporary[FILENAME_MAX];
    const int length = snprintf(path, sizeof path, "%s/%s.csv", directory, figure->stem);
    if (length < 0 || snprintf(temporary, sizeof temporary, "%s.tmp", path) >= (int)sizeof temporary) {
        fprintf(stderr, "cor_report: the name of the directory is too long\n");
        return 0;
    }
    errno = 0;
    FILE *file = fopen(temporary, "w");
    if (file == NULL) {
        fprintf(stderr, "cor_report: cannot write %s: %s\n", temporary, strerror(errno));
        return 0;
    }
    const int computed = figure->write(file, verdict);
    errno = 0;
    const int failed = ferror(file), closed = fclose(file) == 0;
    const int written = !failed && closed;
    if (computed && written && rename(temporary, path) == 0)
        return 1;
    if (computed)
        fprintf(stderr, "cor_report: cannot write %s: %s\n", path, strerror(errno));
    remove(temporary);
    return 0;
}

int main(int argc, char **argv)
{
    static const char usage[] = "usage: cor_report DIRECTORY\n";
    if (argc == 2 && strcmp(argv[1], "--help") == 0) {
        printf("%sWrites the figures of the paper on disks to DIRECTORY as csv files, and prints what is to be said of "
               "each.\n",
               usage);
        return 0;
    }
    if (argc != 2 || argv[1][0] == '\0' || argv[1][0] == '-') {
        fputs(usage, stderr);
        return 2;
    }
    enum { FIGURES = 5 };
    const struct figure *const figure[FIGURES] = {&shapes_figure, &spectrum_figure, &load_figure, &contact_figure,
                                                  &rayleigh_figure};
    static char verdict[FIGURES][VERDICT_SIZE];
    for (size_t i = 0; i < FIGURES; i++)
        if (!make(figure[i], argv[1], verdict[i]))
            return 1;
    printf("%-8s %-13s %s\n", "paper", "file", "shows");
    for (size_t i = 0; i < FIGURES; i++)
        printf("%-8s %-13s %s\n", figure[i]->paper, figure[i]->stem, figure[i]->subject);
    for (size_t i = 0; i < FIGURES; i++)
        printf("\n%s: %s\n", figure[i]->paper, verdict[i]);
    errno = 0;
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "cor_report: cannot write to standard output: %s\n", strerror(errno));
        return 1;
    }
    return 0;
}
