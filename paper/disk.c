/* SPDX-License-Identifier: MIT */
/* cor_paper: the figures of the paper on disks as csv files, and what is to be said of each. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "collisions.h"
#include "report.h"
#include "rigid.h"

/* Collisions computed again, of those taken from a file */
enum { SAMPLE = 60 };

/* Written beside the target and renamed over it, so that no reader sees half a file. */
static int figure_make(const struct figure *figure, const char *directory, char verdict[VERDICT_SIZE])
{
    char path[FILENAME_MAX], temporary[FILENAME_MAX];
    const int length = snprintf(path, sizeof path, "%s/%s.csv", directory, figure->stem);
    if (length < 0 || snprintf(temporary, sizeof temporary, "%s.tmp", path) >= (int)sizeof temporary) {
        fprintf(stderr, "cor_paper: the name of the directory is too long\n");
        return 0;
    }
    errno = 0;
    FILE *file = fopen(temporary, "w");
    if (file == NULL) {
        fprintf(stderr, "cor_paper: cannot write %s: %s\n", temporary, strerror(errno));
        return 0;
    }
    const int computed = figure->write(file, verdict);
    errno = 0;
    const int failed = ferror(file), closed = fclose(file) == 0;
    const int written = !failed && closed;
    if (computed && written && rename(temporary, path) == 0)
        return 1;
    if (computed)
        fprintf(stderr, "cor_paper: cannot write %s: %s\n", path, strerror(errno));
    remove(temporary);
    return 0;
}

enum { FIGURES = 16 };
static const struct figure *const figure[FIGURES] = {
    &collisions_figure, &restitution_figure, &shapes_figure,       &spectrum_figure,
    &sequence_figure,   &energies_figure,    &ranking_figure,      &wall_limit_figure,
    &mode_limit_figure, &load_figure,        &load_dynamic_figure, &contact_figure,
    &rayleigh_figure,   &oscillation_figure, &rigid_wall_figure,   &approach_figure};

static const char usage[] = "usage: cor_paper [--collisions FILE [--all]] DIRECTORY\n";

static int help(void)
{
    printf("%sWrites the figures of the paper on disks to DIRECTORY as csv files, and prints what is to be said of "
           "each.\n"
           "  --collisions FILE  takes the collisions of the full dynamics from a file of an earlier run,\n"
           "                     docs/paper/collisions.csv, and computes %d of them again, which COR_SEED=<number>\n"
           "                     draws; without it they are computed, half a minute\n"
           "  --all              ... each of them again\n",
           usage, SAMPLE);
    return 0;
}

static unsigned long long sample_seed(void)
{
    const char *const text = getenv("COR_SEED");
    return text != NULL ? strtoull(text, NULL, 10) : 19990101;
}

int main(int argc, char **argv)
{
    const char *file = NULL, *directory = NULL;
    int sample = SAMPLE, wrong = 0;
    if (argc == 2 && strcmp(argv[1], "--help") == 0)
        return help();
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], "--all") == 0)
            sample = -1;
        else if (strcmp(argv[i], "--collisions") == 0 && i + 1 < argc)
            file = argv[++i];
        else if (directory == NULL && argv[i][0] != '-' && argv[i][0] != '\0')
            directory = argv[i];
        else
            wrong = 1;
    if (wrong || directory == NULL || (file == NULL && sample < 0)) {
        fputs(usage, stderr);
        return 2;
    }
    static char verdict[FIGURES][VERDICT_SIZE];
    if (!(file != NULL ? collisions_read(file, sample, sample_seed()) : collisions_compute()))
        return 1;
    for (size_t i = 0; i < FIGURES; i++)
        if (!figure_make(figure[i], directory, verdict[i]))
            return 1;
    rigid_wall_clear();
    printf("%-16s %-13s %s\n", "paper", "file", "shows");
    for (size_t i = 0; i < FIGURES; i++)
        printf("%-16s %-13s %s\n", figure[i]->paper, figure[i]->stem, figure[i]->subject);
    for (size_t i = 0; i < FIGURES; i++)
        printf("\n%s: %s\n", figure[i]->paper, verdict[i]);
    errno = 0;
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "cor_paper: cannot write to standard output: %s\n", strerror(errno));
        return 1;
    }
    return 0;
}
