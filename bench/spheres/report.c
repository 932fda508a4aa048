/* SPDX-License-Identifier: MIT */
#include "report.h"

#include <math.h>
#include <stdlib.h>

void report_open(struct report *report, const char *directory)
{
    static const char *const name[2] = {[FROM_SPEED] = "speed", [FROM_BETA] = "beta"};
    for (int i = 0; i < 2; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/spheres_%s.csv", directory, name[i]);
        report->csv[i] = fopen(path, "w");
        if (!report->csv[i]) {
            fprintf(stderr, "bench: cannot write %s\n", path);
            exit(1);
        }
        fputs("scene,curve,setting,instructions,end,form,ns,ns_dependent,max_relative_error\n", report->csv[i]);
    }
}

void report_close(struct report *report)
{
    for (int i = 0; i < 2; i++) {
        const int failed = ferror(report->csv[i]);
        if (fclose(report->csv[i]) != 0 || failed) {
            fprintf(stderr, "bench: cannot write the csv files\n");
            exit(1);
        }
    }
}

/* A number, or nothing. */
static void field(FILE *file, const char *format, double value)
{
    fputc(',', file);
    if (!isnan(value))
        fprintf(file, format, value);
}

void report_row(struct report *report, const struct scene *scene, const struct result *result)
{
    static const char *const end[] = {[ZERO_OVERLAP] = "overlap", [ZERO_FORCE] = "force"};
    const struct method *const m = result->method;
    FILE *const files[2] = {report->csv[m->input], stdout};
    for (int i = 0; i < 2; i++) {
        fprintf(files[i], "%s,%s,%s,%s,%s,%s", scene->name, m->curve, m->setting,
                m->instructions ? m->instructions : "", m->end == NO_END ? "" : end[m->end], result->form);
        field(files[i], "%.4g", result->ns);
        field(files[i], "%.4g", result->ns_chained);
        /* an eps that is none somewhere in the scene is an error of nan; a copy has no error */
        fprintf(files[i], m->end == NO_END || result->form[0] == 'l' ? ",\n" : ",%.2e\n", result->error);
    }
}
