/* SPDX-License-Identifier: MIT */
#include "report.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_COPIES = 2 }; /* an array from speed takes at most so many times its copy */

static FILE *open_csv(const char *directory, const char *name, int append, const char *header)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", directory, name);
    FILE *const file = fopen(path, append ? "a" : "w");
    if (!file) {
        fprintf(stderr, "bench: cannot write %s\n", path);
        exit(1);
    }
    if (!append)
        fprintf(file, "%s\n", header);
    return file;
}

void report_open(struct report *report, const char *directory, const char *build, int append)
{
    *report = (struct report){.build = build};
    report->speed_csv = open_csv(directory, "speed.csv", append,
                                 "build,scene,method,label,curve,end,input,form,precision,tolerance,throughput_ns,"
                                 "latency_ns,throughput_ratio,latency_ratio,max_relative_error,setting");
    report->large_csv = open_csv(directory, "large.csv", append, "build,method,end,elements,ns,gb_per_s,copies");
}

void report_close(struct report *report)
{
    const int failed = ferror(report->speed_csv) | ferror(report->large_csv);
    if (fclose(report->speed_csv) | fclose(report->large_csv) | failed) {
        fprintf(stderr, "bench: cannot write the csv files\n");
        exit(1);
    }
}

/* A number in a column, or blanks for none. */
static void cell(const char *format, int width, double value)
{
    if (isnan(value))
        printf(" %*s", width, "");
    else
        printf(format, width, value);
}

/* A number of a csv file, or nothing. */
static void field(FILE *file, const char *format, double value)
{
    fputc(',', file);
    if (!isnan(value))
        fprintf(file, format, value);
}

static void judge(struct report *report, const char *what, double least, double value)
{
    if (least > 0 && !(value >= least)) {
        printf("  missed: %s %.2f < %.2f", what, value, least);
        report->missed++;
    }
}

/* CSV text without its commas. */
static void plain(FILE *file, const char *text)
{
    for (; *text; text++)
        if (*text != ',')
            fputc(*text, file);
}

static void row(struct report *report, const struct scene *scene, const struct result *result,
                const struct result *baseline)
{
    const struct method *const m = result->method;
    const double speed_up = baseline->throughput_ns / result->throughput_ns;
    const double gain = baseline->latency_ns / result->latency_ns;
    printf("%-46s %-8s %-9s", m->name, end_name(m->end), m->precision);
    cell(" %*.2f", 11, result->throughput_ns);
    cell(" %*.2f", 8, speed_up);
    cell(" %*.2f", 11, result->latency_ns);
    cell(" %*.2f", 8, gain);
    if (m->end == NO_END)
        printf(" %10s", "");
    else if (isnan(result->error))
        printf(" %10s", "NaN");
    else
        printf(" %10.1e", result->error);
    judge(report, "throughput", m->least_speed_up, speed_up);
    judge(report, "latency", m->least_latency_gain, gain);
    printf("\n");

    FILE *const csv = report->speed_csv;
    fprintf(csv, "%s,%s,", report->build, scene->name);
    plain(csv, m->name);
    fputc(',', csv);
    plain(csv, m->label);
    fprintf(csv, ",%s,%s,%s,%s,%s", m->curve, end_name(m->end), m->input == FROM_SPEED ? "speed" : "beta",
            m->flags & ARRAY ? "array" : "scalar", m->precision);
    field(csv, "%.0e", m->tolerance > 0 ? m->tolerance : NAN);
    field(csv, "%.4g", result->throughput_ns);
    field(csv, "%.4g", result->latency_ns);
    field(csv, "%.3f", speed_up);
    field(csv, "%.3f", gain);
    field(csv, "%.2e", result->error);
    fprintf(csv, ",%s\n", m->setting);
}

void report_scene(struct report *report, const struct scene *scene, const struct result *results, size_t n)
{
    const struct result *baseline = &results[0];
    for (size_t i = 0; i < n; i++)
        if (results[i].method->flags & BASELINE)
            baseline = &results[i];
    printf("%s build, scene %s: g* = %g m/s, %g to %g m/s, %.2f <= beta <= %.2f\n", report->build, scene->name,
           scene->g_star, scene->speed_min, scene->speed_max, cor_contact_beta(&scene->contact, scene->speed_min),
           cor_contact_beta(&scene->contact, scene->speed_max));
    printf("%-46s %-8s %-9s %11s %8s %11s %8s %10s\n", "ns per eps; ratios: baseline's time over this one's", "end",
           "accuracy", "independent", "ratio", "dependent", "ratio", "max error");
    for (size_t i = 0; i < n; i++)
        row(report, scene, &results[i], baseline);
    printf("\n");
}

void report_large(struct report *report, const struct scene *scene, const struct result *results, size_t n,
                  size_t elements)
{
    double copy_ns = NAN;
    for (size_t i = 0; i < n; i++)
        if (results[i].method->flags & COPY)
            copy_ns = results[i].throughput_ns;
    const double bytes = 2.0 * sizeof(double);
    printf("%s build, scene %s, arrays larger than the cache: 2 of %.0f MiB\n", report->build, scene->name,
           (double)elements * sizeof(double) / (1 << 20));
    printf("%-46s %-8s %11s %8s %8s\n", "", "end", "ns per eps", "GB/s", "copies");
    for (size_t i = 0; i < n; i++) {
        const struct method *const m = results[i].method;
        const double ns = results[i].throughput_ns;
        printf("%-46s %-8s %11.2f %8.2f %8.2f", m->name, end_name(m->end), ns, bytes / ns, ns / copy_ns);
        if (m->end != NO_END && ns > MOST_COPIES * copy_ns) {
            printf("  missed: %.2f copies > %d", ns / copy_ns, MOST_COPIES);
            report->missed++;
        }
        printf("\n");
        fprintf(report->large_csv, "%s,", report->build);
        plain(report->large_csv, m->name);
        fprintf(report->large_csv, ",%s,%zu,%.4g,%.4g,%.3f\n", end_name(m->end), elements, ns, bytes / ns,
                ns / copy_ns);
    }
    printf("\n");
}
