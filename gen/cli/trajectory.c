/* SPDX-License-Identifier: MIT */
/* corgen trajectory prints the exact rows x_k(t) of the trajectory (docs/theory.md, 2). */
#include <stdlib.h>
#include <string.h>

#include "cli/commands.h"
#include "series/trajectory.h"
#include "support/console.h"
#include "support/local.h"

#define COEFFICIENTS_MAX 10000000
enum { MAX_ORDER = 100000, MAX_TERMS = 100000 };

static int fill_table(struct table *table, char undecided[PROVED_TABLE_NAME], const void *arguments, slong bits)
{
    (void)undecided;
    (void)bits;
    const struct trajectory_arguments *const o = arguments;
    const slong order = o->order, terms = o->terms;
    profile_step("exact rationals");
    table_init(table, "k,j,numerator,denominator", "nndd");
    fmpq_poly_struct *const row = trajectory_exact(order, terms, &o->law.exponents);
    LOCAL(fmpq, c);
    for (slong k = 0; k <= order; k++)
        for (slong j = 0; j <= terms; j++) {
            fmpq_poly_get_coeff_fmpq(c, &row[k], j);
            table_add_integer(table, k);
            table_add_integer(table, j);
            table_add(table, fmpz_get_str(NULL, 10, fmpq_numref(c)));
            table_add(table, fmpz_get_str(NULL, 10, fmpq_denref(c)));
        }
    trajectory_exact_free(row, order + 1);
    return STATUS_OK;
}

/* Prints the rows without the terms that vanish. Dots replace the terms after the requested ones. */
static void print_rows(FILE *file, const struct table *table, const void *arguments)
{
    const struct trajectory_arguments *const o = arguments;
    const struct cor_exponents *const law = &o->law.exponents;
    const bool latex = o->common.format == FORMAT_LATEX;
    char *const *cell = table->cell;
    fputs(latex ? "\\begin{aligned}\n" : "", file);
    for (slong k = 0; k <= o->order; k++) {
        const char *minus = "-", *plus = "";
        fprintf(file, latex ? "x_{%ld}(t) &= " : "x_%ld = ", (long)k);
        for (slong j = 0; j <= o->terms; j++, cell += table->columns) {
            const bool negative = *cell[2] == '-', whole = strcmp(cell[3], "1") == 0;
            const char *const numerator = cell[2] + negative;
            if (strcmp(numerator, "0") == 0)
                continue;
            fputs(negative ? minus : plus, file);
            minus = " - ";
            plus = " + ";
            if (!whole)
                fprintf(file, latex ? "\\frac{%s}{%s}" : "%s/%s ", numerator, cell[3]);
            else if (strcmp(numerator, "1") != 0)
                fprintf(file, latex ? "%s\\," : "%s ", numerator);
            /* the power of t in term j of row k */
            const struct ratio e = RATIO("1 + k*(law->b + 1) + j*(law->a + 1)", k, law, j);
            const char *const open = latex ? "{" : e.den != 1 ? "(" : "";
            const char *const close = latex ? "}" : e.den != 1 ? ")" : "";
            fputs("t", file);
            if (e.den != 1)
                fprintf(file, "^%s%ld/%ld%s", open, (long)e.num, (long)e.den, close);
            else if (e.num != 1)
                fprintf(file, "^%s%ld%s", open, (long)e.num, close);
        }
        fprintf(file, "%s%s", plus, latex ? "\\cdots" : "...");
        fputs(latex && k < o->order ? " \\\\\n" : "\n", file);
    }
    fputs(latex ? "\\end{aligned}\n" : "", file);
}

static int run_trajectory(const void *arguments)
{
    const struct trajectory_arguments *const o = arguments;
    if ((o->order + 1) * (o->terms + 1) > COEFFICIENTS_MAX)
        return usage_error("--order %ld with --terms %ld needs (order + 1) (terms + 1) coefficients, more than %d, "
                           "which do not fit into memory",
                           (long)o->order, (long)o->terms, COEFFICIENTS_MAX);
    const struct proved_table table = {1, o, fill_table, print_rows};
    return proved_table_write(&table, &o->common);
}

static const char help[] =
    "Usage: corgen trajectory --order K --terms J [OPTION]...\n\n"
    "Prints x_0 .. x_K of x(t) = sum x_k(t) beta^k exactly; for spheres\n"
    "x_k(t) = t sum_j c[k][j] t^(3k/2 + 5j/2), j = 0 .. J.\n\n"
    "  --order K        highest power of beta, 0 to 100000\n"
    "  --terms J        highest j of the terms, 0 to 100000\n"
    "  --format F       format of the output, text, csv, json or latex (default text)\n" HELP_JSON_STRINGS HELP_LAW
        HELP_COMMON "\n"
    "Columns of csv and json: k,j,numerator,denominator.\n\n"
    "Example: corgen trajectory --order 3 --terms 4\n";

#define ARGUMENTS struct trajectory_arguments
static const struct option_rule options[] = {
    OPTION("order", WHOLE, order, .range.whole = {0, MAX_ORDER},
           .why = "the time grows faster than the cube of the order", .required = true),
    OPTION("terms", WHOLE, terms, .range.whole = {0, MAX_TERMS}, .why = "more terms do not fit into memory",
           .required = true),
    OPTION_FORMAT(option_formats_latex),
    OPTION_JSON_STRINGS,
    OPTION_LAW,
    OPTION_COMMON,
};

SUBCOMMAND(trajectory, "trajectory", "exact rational coefficients of x(t), any order", .common.format = FORMAT_TEXT);
