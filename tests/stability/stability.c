/* SPDX-License-Identifier: MIT */
/* Runs every hard case, prints what was found, and holds docs/stability.md to it.
 *     stability                        the short form, as a test
 *     stability --full                 every point of every case
 *     stability --csv | --markdown     what was found, as a table; the rows of docs/stability.md */
#include "stability.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "random.h"
#include "support/clock.h"

/* The hard cases of the spheres and of the disks, as their theory lists them, none left out; then those that the suite
 * found by itself. A name without a case fails, and so does a case without a name. */
static const char *const stability_names[] = {
    /* spheres */
    "beta -> 0",
    "beta = 0",
    "beta tiny",
    "beta huge",
    "beta infinite",
    "beta NaN",
    "beta negative",
    "beta at a border of pieces",
    "eps near 0 in the inverse",
    "eps near 1 in the inverse",
    "beta = -h*",
    "exact rationals grow",
    "alternating sums cancel",
    "Padé systems are ill-conditioned",
    "spurious pole-zero pairs",
    /* disks */
    "near pairs of modes",
    "n >> kappa",
    "W_-1 at -1e-60",
    "W_-1 at the branch point",
    "v at the edge of the domain",
    "the zero of the quadrupole",
    "omega tau >> 1",
    "v = 1e-12",
    "resonance of fast n = 0 modes with the step",
    "nu -> 1",
    "nu -> -1",
    "the chaotic case",
};

enum { NAMES = sizeof stability_names / sizeof *stability_names, LISTS = 6, MOST = 100 };

static const struct case_list *const lists[LISTS] = {&stability_sphere, &stability_generator, &stability_law,
                                                     &stability_modes,  &stability_rayleigh,  &stability_collision};

static const struct hard_case *cases[MOST];
static struct outcome outcomes[MOST];
static double seconds[MOST];
static size_t count;
static bool full;
static const char *docs = "docs/stability.md";

/* ---- what the cases call ---- */

static struct random_state random_state;

double drawn(double low, double high)
{
    return random_uniform(&random_state, low, high);
}

double moved(double x, long steps)
{
    int64_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits += steps;
    memcpy(&x, &bits, sizeof x);
    return x;
}

double upper(const arb_t x)
{
    arf_t bound;
    arf_init(bound);
    arb_get_abs_ubound_arf(bound, x, 53);
    const double value = arf_get_d(bound, ARF_RND_UP);
    arf_clear(bound);
    return value;
}

double ball_absolute(const arb_t computed, const arb_t exact)
{
    arb_t off;
    arb_init(off);
    arb_sub(off, computed, exact, 2000);
    const double error = arb_is_finite(off) ? upper(off) : HUGE_VAL;
    arb_clear(off);
    return error;
}

double ball_relative(const arb_t computed, const arb_t exact)
{
    arb_t off;
    arb_init(off);
    arb_sub(off, computed, exact, 4000);
    arb_div(off, off, exact, 64);
    const double error = arb_is_finite(off) ? upper(off) : HUGE_VAL;
    arb_clear(off);
    return error;
}

double ball_ulp(double computed, const arb_t exact)
{
    if (!(fabs(computed) <= DBL_MAX) || !arb_is_finite(exact))
        return HUGE_VAL;
    arb_t off;
    arb_init(off);
    arb_set_d(off, computed);
    arb_sub(off, off, exact, 4000);
    slong exponent = DBL_MIN_EXP;
    if (!arf_is_zero(arb_midref(exact)) && fmpz_cmp_si(ARF_EXPREF(arb_midref(exact)), exponent) > 0)
        exponent = fmpz_get_si(ARF_EXPREF(arb_midref(exact)));
    arb_mul_2exp_si(off, off, DBL_MANT_DIG - exponent);
    const double error = upper(off);
    arb_clear(off);
    return error;
}

void outcome_take(struct outcome *out, double error, const char *input, const char *reference, const char *value)
{
    const bool first = out->points++ == 0;
    if (first || isnan(error) || error > out->error) {
        out->error = isnan(error) ? HUGE_VAL : error;
        snprintf(out->input, sizeof out->input, "%s", input);
        snprintf(out->reference, sizeof out->reference, "%s", reference);
        snprintf(out->value, sizeof out->value, "%s", value);
    }
}

void take_number(struct outcome *out, double error, const char *name, double x, const arb_t reference, double value)
{
    if (out->points > 0 && error <= out->error) {
        out->points++;
        return;
    }
    char input[160], computed[40];
    char *const exact = arb_get_str(reference, 30, ARB_STR_NO_RADIUS);
    snprintf(input, sizeof input, "%s = %.17g (%a)", name, x, x);
    snprintf(computed, sizeof computed, "%.17g", value);
    outcome_take(out, error, input, exact, computed);
    flint_free(exact);
}

/* ---- the table ---- */

/* The next of 1, 2, 5, 10, 20 ... upwards, so that another C library's last bit does not show */
static double rounded_up(double x)
{
    if (!(x > 0 && x < HUGE_VAL))
        return x;
    const double power = pow(10, floor(log10(x)));
    static const double step[] = {1, 2, 5, 10};
    for (size_t i = 0; i < sizeof step / sizeof *step; i++)
        if (x <= step[i] * power * (1 + 1e-9))
            return step[i] * power;
    return 20 * power;
}

static void print_row(FILE *file, size_t i)
{
    const struct hard_case *const c = cases[i];
    fprintf(file, "| %s | %s | %s | %s | ", c->name, c->wrong, c->input, c->reference);
    if (outcomes[i].condition > 0)
        fprintf(file, "%.0e", rounded_up(outcomes[i].condition));
    fprintf(file, " | %.4g | %.4g %s |\n", rounded_up(outcomes[i].error), c->bound, c->unit);
}

static void print_quoted(const char *text)
{
    putchar('"');
    for (; *text != '\0'; text++)
        printf(*text == '"' ? "\"\"" : "%c", *text);
    putchar('"');
}

static void print_csv(void)
{
    puts("name,what_could_go_wrong,inputs,reference_route,points,worst_input,reference,value,condition,error,bound,"
         "unit,seconds");
    for (size_t i = 0; i < count; i++) {
        const struct outcome *const o = &outcomes[i];
        const char *const text[] = {cases[i]->name, cases[i]->wrong, cases[i]->input, cases[i]->reference};
        for (size_t k = 0; k < sizeof text / sizeof *text; k++) {
            print_quoted(text[k]);
            putchar(',');
        }
        printf("%zu,", o->points);
        print_quoted(o->input);
        printf(",%s,%s,%.3g,%.6g,%.6g,", o->reference, o->value, o->condition, o->error, cases[i]->bound);
        print_quoted(cases[i]->unit);
        printf(",%.3f\n", seconds[i]);
    }
}

static void run_case(size_t i)
{
    const double start = clock_processor_seconds();
    random_state = random_seeded(19990101);
    outcomes[i] = (struct outcome){0};
    cases[i]->run(&outcomes[i], false);
    if (full)
        cases[i]->run(&outcomes[i], true);
    seconds[i] = clock_processor_seconds() - start;
}

/* ---- tests ---- */

static void test_case(void **state)
{
    const size_t i = *(const size_t *)*state;
    const struct hard_case *const c = cases[i];
    const struct outcome *const o = &outcomes[i];
    run_case(i);
    print_message("%s: %s\n    %zu points, error %.3g %s, bound %.3g", c->name, c->wrong, o->points, o->error, c->unit,
                  c->bound);
    if (o->condition > 0)
        print_message(", condition %.2g", o->condition);
    print_message("; %.2f s\n    worst: %s, %s for %s\n", seconds[i], o->input, o->value, o->reference);
    if (o->points == 0 || !(o->error <= c->bound))
        fail_msg("%s, %s: error %g %s, bound %g", c->name, o->input, o->error, c->unit, c->bound);
}

static void test_names(void **state)
{
    (void)state;
    for (size_t k = 0; k < NAMES; k++) {
        size_t found = 0;
        for (size_t i = 0; i < count; i++)
            found += strcmp(cases[i]->name, stability_names[k]) == 0;
        if (found == 0)
            fail_msg("\"%s\" has no case", stability_names[k]);
    }
    for (size_t i = 0; i < count; i++) {
        size_t found = 0;
        for (size_t k = 0; k < NAMES; k++)
            found += strcmp(cases[i]->name, stability_names[k]) == 0;
        if (found != 1)
            fail_msg("\"%s\" is not in the list of names", cases[i]->name);
        if (!(cases[i]->bound >= 0 && cases[i]->bound < HUGE_VAL))
            fail_msg("\"%s\" has no bound", cases[i]->name);
    }
}

/* The columns of a row up to the condition, and the error after it */
static bool split_row(char *line, double *error)
{
    char *column = line;
    for (int i = 0; i < 5 && column != NULL; i++)
        column = strstr(column + 1, " | ");
    if (column == NULL)
        return false;
    *error = strtod(column + 3, NULL);
    char *before = line; /* without the condition */
    for (int i = 0; i < 4; i++)
        before = strstr(before + 1, " | ");
    *before = '\0';
    return true;
}

/* Every row is there as --markdown writes it; the error of the page, found by the full form, is no smaller than what
 * was found here, and in the full form no more than a step of 1, 2, 5 larger. */
static void test_docs(void **state)
{
    (void)state;
    FILE *const file = fopen(docs, "r");
    if (file == NULL)
        fail_msg("%s cannot be read; tests run where the sources are", docs);
    static char line[4096], row[4096];
    size_t rows = 0;
    while (fgets(line, sizeof line, file) != NULL) {
        if (strncmp(line, "| ", 2) != 0 || strncmp(line, "| hard case", 11) == 0)
            continue;
        if (rows >= count)
            fail_msg("%s has more rows than there are cases", docs);
        double told = 0, found = 0;
        FILE *const memory = tmpfile();
        if (memory == NULL)
            fail_msg("no temporary file");
        print_row(memory, rows);
        rewind(memory);
        if (fgets(row, sizeof row, memory) == NULL || !split_row(row, &found) || !split_row(line, &told))
            fail_msg("row %zu of %s is no row", rows + 1, docs);
        fclose(memory);
        if (strcmp(row, line) != 0)
            fail_msg("%s has\n%s\nin place of\n%s", docs, line, row);
        if (outcomes[rows].error > told * (1 + 1e-9) || (full && told > 2.6 * found))
            fail_msg("%s: an error of %g was found, the page says %g", line, found, told);
        rows++;
    }
    fclose(file);
    if (rows != count)
        fail_msg("%s has %zu rows for %zu cases", docs, rows, count);
}

static const char usage[] = "usage: stability [--full] [--csv | --markdown] [--only NAME] [--docs FILE]\n"
                            "  --full        every point; minutes\n"
                            "  --csv         what was found, with the worst input, its reference and value\n"
                            "  --markdown    the rows of docs/stability.md\n"
                            "  --only NAME   the cases whose name contains NAME; without the checks of list and page\n"
                            "  --docs FILE   the page that is checked (docs/stability.md)\n";

int main(int argc, char **argv)
{
    bool csv = false, markdown = false;
    const char *only = NULL;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--full") == 0) {
            full = true;
        } else if (strcmp(argv[i], "--csv") == 0) {
            csv = true;
        } else if (strcmp(argv[i], "--markdown") == 0) {
            markdown = true;
        } else if (strcmp(argv[i], "--only") == 0 && i + 1 < argc) {
            only = argv[++i];
        } else if (strcmp(argv[i], "--docs") == 0 && i + 1 < argc) {
            docs = argv[++i];
        } else {
            const bool help = strcmp(argv[i], "--help") == 0;
            fputs(usage, help ? stdout : stderr);
            return help ? 0 : 2;
        }
    }
    for (size_t k = 0; k < LISTS; k++)
        for (size_t i = 0; i < lists[k]->count && count < MOST; i++)
            if (only == NULL || strstr(lists[k]->cases[i].name, only) != NULL)
                cases[count++] = &lists[k]->cases[i];
    if (count == 0) {
        fprintf(stderr, "stability: no case has a name with '%s' in it; the names are in tests/stability/stability.c\n",
                only);
        return 2;
    }
    int failed = 0;
    if (csv || markdown) {
        for (size_t i = 0; i < count; i++) {
            run_case(i);
            failed |= !(outcomes[i].error <= cases[i]->bound);
        }
        if (csv)
            print_csv();
        for (size_t i = 0; markdown && i < count; i++)
            print_row(stdout, i);
    } else {
        static size_t number[MOST];
        static struct CMUnitTest tests[MOST + 2];
        for (size_t i = 0; i < count; i++) {
            number[i] = i;
            tests[i] = (struct CMUnitTest){cases[i]->name, test_case, NULL, NULL, &number[i]};
        }
        tests[count] = (struct CMUnitTest)cmocka_unit_test(test_names);
        tests[count + 1] = (struct CMUnitTest)cmocka_unit_test(test_docs);
        failed = _cmocka_run_group_tests("stability", tests, only == NULL ? count + 2 : count, NULL, NULL);
    }
    flint_cleanup();
    return failed != 0;
}
