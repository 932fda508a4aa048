/* SPDX-License-Identifier: MIT */
/* corgen trajectory prints the exact x_k(t) of (48), (49). */
#include <stdlib.h>

#include "cli/commands.h"
#include "series/trajectory.h"
#include "support/console.h"
#include "support/local.h"

#define COEFFICIENTS_MAX 10000000
enum { MAX_ORDER = 100000, MAX_TERMS = 100000 };

/* Exponent of t in the term j of row k: 1 + k (b+1) + j (a+1). */
static struct ratio term_exponent(const struct law *law, slong k, slong j)
{
    struct ratio one = {1, 1};
    struct ratio u = ratio_mul(ratio_make(k, 1), ratio_add(law->b, one));
    struct ratio s = ratio_mul(ratio_make(j, 1), ratio_add(law->a, one));
    return ratio_add(one, ratio_add(u, s));
}

static void print_power(FILE *file, struct ratio e, bool latex)
{
    const char *const open = latex ? "{" : e.den != 1 ? "(" : "", *const close = latex ? "}" : e.den != 1 ? ")" : "";
    fputs("t", file);
    if (e.den != 1)
        fprintf(file, "^%s%ld/%ld%s", open, (long)e.num, (long)e.den, close);
    else if (e.num != 1)
        fprintf(file, "^%s%ld%s", open, (long)e.num, close);
}

static void print_size(FILE *file, const fmpq_t size, bool latex)
{
    const bool whole = fmpz_is_one(fmpq_denref(size));
    char *numerator = fmpz_get_str(NULL, 10, fmpq_numref(size));
    char *denominator = fmpz_get_str(NULL, 10, fmpq_denref(size));
    if (whole)
        fprintf(file, latex ? "%s\\," : "%s ", numerator);
    else
        fprintf(file, latex ? "\\frac{%s}{%s}" : "%s/%s ", numerator, denominator);
    flint_free(numerator);
    flint_free(denominator);
}

/* Prints a row without its vanishing terms; dots stand for the terms beyond the requested ones. */
static void print_row(FILE *file, const fmpq_poly_t row, slong k, const struct trajectory_arguments *o,
                      const struct law *law)
{
    bool latex = o->common.format == FORMAT_LATEX;
    bool first = true;
    LOCAL(fmpq, c);
    for (slong j = 0; j <= o->terms; j++) {
        fmpq_poly_get_coeff_fmpq(c, row, j);
        int sign = fmpq_sgn(c);
        if (sign == 0)
            continue;
        if (first)
            fputs(sign < 0 ? "-" : "", file);
        else
            fputs(sign < 0 ? " - " : " + ", file);
        first = false;
        fmpq_abs(c, c);
        if (!fmpq_is_one(c))
            print_size(file, c, latex);
        print_power(file, term_exponent(law, k, j), latex);
    }
    fprintf(file, "%s%s", first ? "" : " + ", latex ? "\\cdots" : "...");
}

static void print_rows(FILE *file, const fmpq_poly_struct *row, const struct trajectory_arguments *o,
                       const struct law *law)
{
    bool latex = o->common.format == FORMAT_LATEX;
    fputs(latex ? "\\begin{aligned}\n" : "", file);
    for (slong k = 0; k <= o->order; k++) {
        fprintf(file, latex ? "x_{%ld}(t) &= " : "x_%ld = ", (long)k);
        print_row(file, &row[k], k, o, law);
        fputs(latex && k < o->order ? " \\\\\n" : "\n", file);
    }
    fputs(latex ? "\\end{aligned}\n" : "", file);
}

static void print_table(FILE *file, const fmpq_poly_struct *row, const struct trajectory_arguments *o)
{
    struct table table;
    table_init(&table, "k,j,numerator,denominator", "nndd");
    table.json_strings = o->common.json_strings;
    LOCAL(fmpq, c);
    for (slong k = 0; k <= o->order; k++) {
        for (slong j = 0; j <= o->terms; j++) {
            fmpq_poly_get_coeff_fmpq(c, &row[k], j);
            table_add_integer(&table, k);
            table_add_integer(&table, j);
            table_add(&table, fmpz_get_str(NULL, 10, fmpq_numref(c)));
            table_add(&table, fmpz_get_str(NULL, 10, fmpq_denref(c)));
        }
    }
    table_print(&table, (enum output_format)o->common.format, file);
    table_clear(&table);
}

static int run_trajectory(const void *arguments)
{
    const struct trajectory_arguments *const o = arguments;
    struct law law;
    const int wrong = options_law(&law, &o->law);
    if (wrong)
        return wrong;
    if ((o->order + 1) * (o->terms + 1) > COEFFICIENTS_MAX)
        return usage_error("--order %ld with --terms %ld is more than %d coefficients, (order + 1) "
                           "(terms + 1), which no memory holds as exact rationals",
                           (long)o->order, (long)o->terms, COEFFICIENTS_MAX);
    struct output out;
    if (output_open(&out, o->common.output) != STATUS_OK)
        return STATUS_FAILED;

    profile_step("exact rationals");
    fmpq_poly_struct *row = xmalloc((size_t)(o->order + 1) * sizeof *row);
    for (slong k = 0; k <= o->order; k++)
        fmpq_poly_init(&row[k]);
    trajectory_exact(row, o->order, o->terms, &law);

    profile_step("printing");
    if (o->common.format == FORMAT_TEXT || o->common.format == FORMAT_LATEX)
        print_rows(out.file, row, o, &law);
    else
        print_table(out.file, row, o);
    for (slong k = 0; k <= o->order; k++)
        fmpq_poly_clear(&row[k]);
    free(row);
    return output_commit(&out);
}

static const char help[] =
    "Usage: corgen trajectory --order K --terms J [OPTION]...\n\n"
    "Prints x_0 .. x_K of x(t) = sum x_k(t) beta^k exactly; for spheres\n"
    "x_k(t) = t sum_j c[k][j] t^(3k/2 + 5j/2), j = 0 .. J.\n\n"
    "  --order K        highest power of beta, 0 to 100000\n"
    "  --terms J        highest j, 0 to 100000\n"
    "  --format F       text (default), csv, json or latex\n" HELP_JSON_STRINGS HELP_LAW HELP_COMMON
    "\nColumns of csv and json: k,j,numerator,denominator.\n"
    "\nExample: corgen trajectory --order 3 --terms 4\n";

#define ARGUMENTS struct trajectory_arguments
static const struct option_rule options[] = {
    OPTION("order", WHOLE, order, .range.whole = {0, MAX_ORDER},
           .why = "an order needs all below it, and their cost grows faster than its cube", .required = true),
    OPTION("terms", WHOLE, terms, .range.whole = {0, MAX_TERMS},
           .why = "the exact rationals of more terms outgrow any memory", .required = true),
    OPTION_FORMAT(option_formats_latex),
    OPTION_JSON_STRINGS,
    OPTION_LAW,
    OPTION_COMMON,
    {.name = NULL},
};

static const struct trajectory_arguments defaults = {0};

SUBCOMMAND(trajectory, "trajectory", "exact rational coefficients of x(t), any order");
