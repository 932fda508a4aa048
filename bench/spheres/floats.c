/* SPDX-License-Identifier: MIT */
/* The functions of beta in double and in float, in one run: one at a time, the double arrays, the float arrays that are
 * correctly rounded, and those in float arithmetic, by instruction set. Every time stands beside its share of the
 * double time and beside the error: of floats the largest of all arguments, in units of the last place of a float,
 * against the double function; of doubles their bound, in units of a double.
 *
 *     cor_bench_floats DIRECTORY [--quick]        writes DIRECTORY/floats.csv */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cor/sphere.h>

#include "runtime/sphere/array.h"
#include "runtime/sphere/fast_float.h"
#include "support/table.h"
#include "support/timing.h"

enum { COUNT = 4096, MAX_JOBS = 128 };

/* As "ordinary dissipation" of docs/speed */
static const double least_beta = 0.3, most_beta = 1.9;

struct quantity {
    const char *name;
    double bound;
    enum cor_sphere_number number;
    struct float_table (*table)(void);
    double (*value)(double);
    float (*valuef)(float), (*fastf)(float);
    void (*array)(const double *, double *, size_t);
    void (*arrayf)(const float *, float *, size_t);
    void (*fast)(const float *, float *, size_t);
};
#define QUANTITY(name, bound)                                                                                          \
    {                                                                                                                  \
#name, bound, COR_SPHERE_##name, float_table_##name, cor_sphere_##name, cor_sphere_##name##f,                  \
            cor_sphere_##name##_fastf, cor_sphere_##name##_array, cor_sphere_##name##_arrayf,                          \
            cor_sphere_##name##_fast_arrayf                                                                            \
    }
static const struct quantity quantities[] = {
    QUANTITY(eps_zero_overlap, COR_SPHERE_EPS_MAX_ULP),       QUANTITY(eps_zero_force, COR_SPHERE_EPS_MAX_ULP),
    QUANTITY(loss_zero_overlap, COR_SPHERE_LOSS_MAX_ULP),     QUANTITY(loss_zero_force, COR_SPHERE_LOSS_MAX_ULP),
    QUANTITY(duration_zero_overlap, COR_SPHERE_TIME_MAX_ULP), QUANTITY(duration_zero_force, COR_SPHERE_TIME_MAX_ULP),
    QUANTITY(max_overlap, COR_SPHERE_MAX_OVERLAP_MAX_ULP),    QUANTITY(time_of_max_overlap, COR_SPHERE_TIME_MAX_ULP),
};
enum { QUANTITIES = sizeof quantities / sizeof *quantities };

static double x[COUNT], y[COUNT];
static float xf[COUNT], yf[COUNT];

enum form { SCALAR, FLOAT_SCALAR, FAST_SCALAR, ARRAY, FLOAT_ARRAY, FAST_ARRAY };
static const char *const form_name[] = {"double",       "float",       "fast float",
                                        "double array", "float array", "fast float array"};

struct line {
    const struct quantity *quantity;
    enum form form;
    const char *set;
    const struct cor_row_loops *loops; /* NULL: as shipped */
};

static void run_line(void *closure)
{
    const struct line *const line = closure;
    if (line->form == SCALAR) {
        double (*const value)(double) = line->quantity->value;
        for (int i = 0; i < COUNT; i++)
            y[i] = value(x[i]);
    } else if (line->form == FLOAT_SCALAR || line->form == FAST_SCALAR) {
        float (*const value)(float) = line->form == FAST_SCALAR ? line->quantity->fastf : line->quantity->valuef;
        for (int i = 0; i < COUNT; i++)
            yf[i] = value(xf[i]);
    } else if (line->form == ARRAY && line->loops) {
        const struct cor_sphere_rows *const rows = &cor_sphere_rows[line->quantity->number];
        const struct cor_row_call call = {&rows->table, rows->one, NULL, NULL, NULL, 0};
        line->loops->doubles(&call, x, y, COUNT);
    } else if (line->form == FAST_ARRAY && line->loops) {
        const struct float_table table = line->quantity->table();
        line->loops->fast_floats(&table, line->quantity->valuef, xf, yf, COUNT);
    } else if (line->form == ARRAY) {
        line->quantity->array(x, y, COUNT);
    } else {
        (line->form == FAST_ARRAY ? line->quantity->fast : line->quantity->arrayf)(xf, yf, COUNT);
    }
}

static double worst_error(struct line *line)
{
    double worst = 0;
    if (line->form == SCALAR || line->form == ARRAY)
        return line->quantity->bound;
    run_line(line);
    for (int i = 0; i < COUNT; i++) {
        const double exact = line->quantity->value((double)xf[i]);
        int exponent;
        frexp(exact, &exponent);
        worst = fmax(worst, ldexp(fabs((double)yf[i] - exact), 24 - exponent));
    }
    return worst;
}

static int add_lines(struct line *line)
{
    static const char *const set_name[COR_INSTRUCTION_SETS] = {"portable", "AVX2", "AVX-512"};
    int n = 0;
    for (int k = 0; k < QUANTITIES; k++)
        for (enum form form = SCALAR; form <= FAST_ARRAY; form++)
            line[n++] = (struct line){&quantities[k], form, form < ARRAY ? "" : "as shipped", NULL};
    for (int s = 0; s < COR_INSTRUCTION_SETS; s++)
        for (int k = 0; cor_row_loops(s) && k < QUANTITIES; k++) {
            line[n++] = (struct line){&quantities[k], ARRAY, set_name[s], cor_row_loops(s)};
            line[n++] = (struct line){&quantities[k], FAST_ARRAY, set_name[s], cor_row_loops(s)};
        }
    return n;
}

/* The job of the double function of the same form: by instruction set for arrays */
static const struct job *double_job(const struct line *lines, const struct job *jobs, int n, const struct line *of)
{
    const enum form wanted = of->form < ARRAY ? SCALAR : ARRAY;
    for (int i = 0; i < n; i++)
        if (lines[i].quantity == of->quantity && lines[i].form == wanted && strcmp(lines[i].set, of->set) == 0)
            return &jobs[i];
    return NULL;
}

int main(int argc, char **argv)
{
    static struct line lines[MAX_JOBS];
    static struct job jobs[MAX_JOBS];
    const int quick = argc == 3 && strcmp(argv[2], "--quick") == 0;
    if (argc != 2 + quick) {
        fprintf(stderr, "usage: cor_bench_floats DIRECTORY [--quick]\nDIRECTORY receives floats.csv\n");
        return 2;
    }
    for (int i = 0; i < COUNT; i++) { /* multiples of the golden ratio */
        xf[i] = (float)(least_beta + (most_beta - least_beta) * fmod(0.61803398874989485 * (i + 1), 1));
        x[i] = (double)xf[i];
    }
    const int n = add_lines(lines);
    for (int i = 0; i < n; i++)
        jobs[i] = (struct job){run_line, &lines[i], COUNT, NAN};
    timing_measure(jobs, (size_t)n, (struct timing){2e5, quick ? 20 : 200, 4});
    FILE *const file = table_open(argv[1], "floats.csv", "quantity,form,instructions,ns,share_of_double,error_ulp");
    for (int i = 0; i < n; i++)
        fprintf(file, "%s,%s,%s,%.3f,%.3f,%.3f\n", lines[i].quantity->name, form_name[lines[i].form], lines[i].set,
                jobs[i].best_ns, jobs[i].best_ns / double_job(lines, jobs, n, &lines[i])->best_ns,
                worst_error(&lines[i]));
    table_close(file);
    return 0;
}
