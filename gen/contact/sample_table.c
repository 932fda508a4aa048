/* SPDX-License-Identifier: MIT */
#include "contact/sample.h"

#include <math.h>
#include <string.h>

#include "support/console.h"
#include "support/output.h"

const char *const sample_format_names[] = {
    [SAMPLE_TEXT] = "text",     [SAMPLE_CSV] = "csv",           [SAMPLE_JSON] = "json",         [SAMPLE_C] = "c",
    [SAMPLE_PYTHON] = "python", [SAMPLE_MODELICA] = "modelica", [SAMPLE_OPENFOAM] = "openfoam", NULL};

enum { SPEED_DIGITS = 12, VALUE_DIGITS = 14, TEXT_DIGITS = 7, MOST_COLUMNS = 7 };

/* A column: its name and its numbers */
struct column {
    const char *name;
    const double *number;
};

static int columns_of(struct column column[MOST_COLUMNS], const struct sample_points *p,
                      const struct sample_request *request)
{
    static const char *const value[] = {"eps", "duration_s"};
    static const char *const slope[2][2] = {{"eps_slope_s_m", "duration_slope_s2_m"},
                                            {"eps_slope_per_log", "duration_slope_s_per_log"}};
    int n = 0;
    column[n++] = (struct column){"speed_m_s", p->speed_m_s};
    for (int q = 0; q < (request->duration ? 2 : 1); q++) {
        column[n++] = (struct column){value[q], p->value[q]};
        if (request->cubic)
            column[n++] = (struct column){slope[request->log][q], p->slope[q]};
    }
    return n;
}

static void print_table(FILE *file, const struct column *column, int columns, size_t rows, enum output_format format)
{
    char header[MOST_COLUMNS * 32] = "";
    struct table table;
    for (int k = 0; k < columns; k++)
        snprintf(header + strlen(header), sizeof header - strlen(header), k ? ",%s" : "%s", column[k].name);
    table_init(&table, header, "nnnnnnn");
    for (size_t i = 0; i < rows; i++)
        for (int k = 0; k < columns; k++)
            table_add_number(&table, column[k].number[i],
                             format == FORMAT_TEXT ? TEXT_DIGITS
                             : k == 0              ? SPEED_DIGITS
                                                   : VALUE_DIGITS);
    table_print(&table, format, file);
    table_clear(&table);
}

static void print_number(FILE *file, const struct column *column, int k, size_t i)
{
    fprintf(file, "%.*g", k == 0 ? SPEED_DIGITS : VALUE_DIGITS, column[k].number[i]);
}

/* Prints "before NAME after" and the numbers of each column, four on a line. */
static void print_lists(FILE *file, const struct column *column, int columns, size_t rows, const char *before,
                        const char *open, const char *close)
{
    for (int k = 0; k < columns; k++) {
        fprintf(file, "%s%s%s", before, column[k].name, open);
        for (size_t i = 0; i < rows; i++) {
            fputs(i % 4 == 0 ? "\n    " : " ", file);
            print_number(file, column, k, i);
            fputs(i + 1 < rows ? "," : "", file);
        }
        fprintf(file, "\n%s\n", close);
    }
}

void sample_print(FILE *file, const struct sample *sample, const struct sample_request *request,
                  enum sample_format format)
{
    static const char *const before[] = {/* start of a comment line */
                                         [SAMPLE_TEXT] = "",
                                         [SAMPLE_C] = "/* ",
                                         [SAMPLE_PYTHON] = "# ",
                                         [SAMPLE_MODELICA] = "# ",
                                         [SAMPLE_OPENFOAM] = "// "};
    const char *const log = request->log ? "numpy.log(" : "", *const end = request->log ? ")" : "";
    const char *const begin = before[format], *const close = format == SAMPLE_C ? " */" : "";
    const size_t rows = sample->best.count;
    char law[CONTACT_LAW_TEXT];
    struct column column[MOST_COLUMNS];
    int columns = columns_of(column, &sample->best, request);
    if (format == SAMPLE_MODELICA)
        fputs("#1\n", file);
    if (format != SAMPLE_CSV && format != SAMPLE_JSON)
        fprintf(file,
                "%s%zu points; %s interpolation in %s gives %s with a relative error of %.4g at most.%s\n"
                "%s%s%s%s.%s\n",
                begin, rows, request->cubic ? "cubic Hermite" : "linear", request->log ? "ln(speed)" : "the speed",
                request->duration ? "eps and duration" : "eps", sample->best.error, close, begin,
                request->own ? request->own->text : contact_law_text(law, request->contact),
                request->own ? "" : ", contact ends at ",
                request->own ? "" : contact_end_text(request->contact, (int)request->end), close);
    switch (format) {
    case SAMPLE_TEXT: /* text has the evenly spaced table, too */
        column[columns++] = (struct column){"even_speed_m_s", sample->even.speed_m_s};
        column[columns++] = (struct column){"even_eps", sample->even.value[0]};
        fprintf(file, "Error with this number of evenly spaced points: %.4g.", sample->even.error);
        if (isfinite(sample->error_of_fewer))
            fprintf(file, "\nError with one point fewer, placed as well as possible: %.4g.", sample->error_of_fewer);
        fputs("\n\n", file);
        /* fall through */
    case SAMPLE_CSV:
    case SAMPLE_JSON:
        print_table(file, column, columns, rows, (enum output_format)format);
        break;
    case SAMPLE_C:
        fprintf(file, "enum { cor_sample_points = %zu };\n", rows);
        print_lists(file, column, columns, rows, "static const double cor_sample_", "[cor_sample_points] = {", "};");
        break;
    case SAMPLE_PYTHON:
        if (request->cubic)
            fprintf(file, "# scipy.interpolate.CubicHermiteSpline(%sspeed_m_s%s, eps, %s)(%sspeed%s)\n", log, end,
                    column[2].name, log, end);
        else
            fprintf(file, "# numpy.interp(%sspeed%s, %sspeed_m_s%s, eps)\n", log, end, log, end);
        print_lists(file, column, columns, rows, "", " = [", "]");
        break;
    case SAMPLE_MODELICA:
        fprintf(file, "double eps(%zu,%d)  # speed_m_s, eps%s\n", rows, columns,
                request->duration ? ", duration_s" : "");
        for (size_t i = 0; i < rows; i++)
            for (int k = 0; k < columns; k++) {
                print_number(file, column, k, i);
                putc(k + 1 < columns ? ' ' : '\n', file);
            }
        break;
    case SAMPLE_OPENFOAM:
        for (int k = 1; k < columns; k++) {
            fprintf(file, "%s table\n(\n", column[k].name);
            for (size_t i = 0; i < rows; i++)
                fprintf(file, "    (%.*g %.*g)\n", SPEED_DIGITS, column[0].number[i], VALUE_DIGITS,
                        column[k].number[i]);
            fputs(");\n", file);
        }
        break;
    }
}
