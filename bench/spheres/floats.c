/* SPDX-License-Identifier: MIT */
/* Measures arrays in float arithmetic next to arrays in double, by instruction set. Every row has a time, its fraction
 * of the double time, and an error. For floats this is the largest error of all arguments against the double function,
 * in ulp of a float. For doubles it is the stated bound, in ulp of a double.
 *
 *     cor_bench_floats DIRECTORY [--quick]        writes DIRECTORY/floats.csv */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cor/law.h>

#include "runtime/number/sets.h"
#include "support/table.h"
#include "support/timing.h"

enum { COUNT = 4096, QUANTITIES = 4, LINES = 2 * QUANTITIES * COR_INSTRUCTION_SETS };

/* The range of "ordinary dissipation" in docs/speed */
static const double least_beta = 0.3, most_beta = 1.9;

static double x[COUNT], y[COUNT];
static float xf[COUNT], yf[COUNT];

/* Replaces the library's function. Array functions then use the instruction set `array_set`. */
static int array_set;
int cor_array_set(void)
{
    return array_set;
}

struct line {
    const struct cor_law_function *f;
    int floats, set;
};

static void run_line(void *closure)
{
    const struct line *const line = closure;
    array_set = line->set;
    if (line->floats)
        line->f->arrayf(xf, yf, COUNT);
    else
        line->f->array(x, y, COUNT);
}

static double worst_error(struct line *line)
{
    double worst = 0;
    if (!line->floats)
        return line->f->max_ulp;
    run_line(line);
    for (int i = 0; i < COUNT; i++) {
        const double exact = line->f->value((double)xf[i]);
        int exponent;
        frexp(exact, &exponent);
        worst = fmax(worst, ldexp(fabs((double)yf[i] - exact), 24 - exponent));
    }
    return worst;
}

int main(int argc, char **argv)
{
    static const char *const set_name[COR_INSTRUCTION_SETS] = {"portable", "AVX2", "AVX-512"};
    struct line lines[LINES];
    struct job jobs[LINES];
    const int quick = argc == 3 && strcmp(argv[2], "--quick") == 0;
    int n = 0;
    if (argc != 2 + quick) {
        fprintf(stderr, "usage: cor_bench_floats DIRECTORY [--quick]\nDIRECTORY receives floats.csv\n");
        return 2;
    }
    for (int i = 0; i < COUNT; i++) { /* multiples of the golden ratio */
        xf[i] = (float)(least_beta + (most_beta - least_beta) * fmod(0.61803398874989485 * (i + 1), 1));
        x[i] = (double)xf[i];
    }
    for (int set = 0; set < COR_INSTRUCTION_SETS && cor_processor_has(set); set++)
        for (int k = 0; k < 2 * QUANTITIES; k++, n++) { /* a double array, then the float array */
            lines[n] = (struct line){
                cor_law_function(COR_LAW_VISCOELASTIC, (enum cor_end)(k / 4), (enum cor_quantity)(k / 2 % 2)), k % 2,
                set};
            jobs[n] = (struct job){run_line, &lines[n], COUNT, NAN};
        }
    timing_measure(jobs, (size_t)n, (struct timing){2e5, quick ? 20 : 200, 4});
    FILE *const file = table_open(argv[1], "floats.csv", "quantity,form,instructions,ns,share_of_double,error_ulp");
    for (int i = 0; i < n; i++)
        fprintf(file, "%s,%s,%s,%.3f,%.3f,%.3f\n", lines[i].f->name + strlen("viscoelastic_"),
                lines[i].floats ? "float array" : "double array", set_name[lines[i].set], jobs[i].best_ns,
                jobs[i].best_ns / jobs[i - lines[i].floats].best_ns, worst_error(&lines[i]));
    table_close(file);
    return 0;
}
