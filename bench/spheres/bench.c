/* SPDX-License-Identifier: MIT */
/* Speed of eps, with the error next to every time: one row per method, all in one run.
 *
 *   ns                   time per eps, at independent random speeds
 *   ns_dependent         time per eps, if each speed waits for the previous eps
 *   max_relative_error   largest over the speeds of the scene, against the collision integrated in long double */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "methods.h"
#include "support/table.h"
#include "support/timing.h"

enum {
    IN_CACHE = 2048, /* an array and its eps fit the first-level cache */
    SCALARS = 16384, /* more than a branch predictor memorises */
    COLLISIONS = 64, /* speeds for methods that need microseconds each, evenly spaced in their logarithm */
    ROWS = METHODS_MAX
};

struct task {
    const struct method *method;
    const struct scene *scene;
    const double *in;
    double *out;
    size_t n;
};

static void run_each(void *closure)
{
    const struct task *const t = closure;
    t->method->each(t->method, t->scene, t->in, t->out, t->n);
}

static void run_chain(void *closure)
{
    const struct task *const t = closure;
    t->out[0] = t->method->chain(t->method, t->scene, t->in, t->n);
}

static double *doubles(size_t n)
{
    double *const p = aligned_alloc(64, (n * sizeof *p + 63) / 64 * 64);
    if (!p) {
        fprintf(stderr, "bench: no memory for %zu numbers\n", n);
        exit(1);
    }
    memset(p, 0, n * sizeof *p);
    return p;
}

/* Returns the largest |eps/truth - 1|; NaN if an eps is not a number. For floats the truth is the library's double
 * function, whose error is negligible here. */
static double worst_error(const struct truth *truth, const struct scene *scene, const struct method *method)
{
    static double eps[CHECKED];
    static float in[CHECKED], eps_of_float[CHECKED];
    const int is_float = (method->flags & FLOAT) != 0;
    double worst = 0;
    if (method->end == NO_END)
        return NAN;
    for (int i = 0; i < CHECKED; i++)
        in[i] = (float)truth->in[method->input][i];
    method->each(method, scene, is_float ? (const void *)in : truth->in[method->input],
                 is_float ? (void *)eps_of_float : eps, CHECKED);
    for (int i = 0; i < CHECKED && !isnan(worst); i++) {
        long double value = eps[i], exact = truth->eps[method->input][method->end][i];
        if (is_float) {
            const double x = in[i], beta = method->input == FROM_BETA ? x : cor_contact_beta(&scene->contact, x);
            value = eps_of_float[i];
            exact = method->end == ZERO_FORCE ? cor_sphere_eps_zero_force(beta) : cor_sphere_eps_zero_overlap(beta);
        }
        const double error = fabs((double)((value - exact) / exact));
        if (!(error <= worst)) /* also true for NaN */
            worst = error;
    }
    return worst;
}

/* Arguments of the methods: the speeds of a scene and the beta of each speed. Index: enum input */
struct inputs {
    double *random[2]; /* SCALARS numbers; array methods use only IN_CACHE of them */
    double *even[2];   /* COLLISIONS numbers */
    float *single[2];  /* the random numbers in float */
    double *out;
};

static struct inputs inputs_new(const struct scene *scene)
{
    struct inputs in = {.out = doubles(SCALARS)};
    for (int i = 0; i < 2; i++) {
        in.random[i] = doubles(SCALARS);
        in.even[i] = doubles(COLLISIONS);
    }
    scene_speeds(scene, in.random[FROM_SPEED], SCALARS);
    scene_even_speeds(scene, in.even[FROM_SPEED], COLLISIONS);
    for (size_t i = 0; i < SCALARS; i++)
        in.random[FROM_BETA][i] = cor_contact_beta(&scene->contact, in.random[FROM_SPEED][i]);
    for (size_t i = 0; i < COLLISIONS; i++)
        in.even[FROM_BETA][i] = cor_contact_beta(&scene->contact, in.even[FROM_SPEED][i]);
    for (int k = 0; k < 2; k++) {
        in.single[k] = (float *)(void *)doubles(SCALARS);
        for (size_t i = 0; i < SCALARS; i++)
            in.single[k][i] = (float)in.random[k][i];
    }
    return in;
}

static void inputs_free(struct inputs *in)
{
    for (int i = 0; i < 2; i++) {
        free(in->random[i]);
        free(in->even[i]);
        free(in->single[i]);
    }
    free(in->out);
}

static struct task task_of(const struct method *method, const struct scene *scene, const struct inputs *in)
{
    if (method->flags & INTEGRATES)
        return (struct task){method, scene, in->even[method->input], in->out, COLLISIONS};
    const void *const random =
        method->flags & FLOAT ? (const void *)in->single[method->input] : (const void *)in->random[method->input];
    return (struct task){method, scene, random, in->out, method->flags & ARRAY ? IN_CACHE : SCALARS};
}

/* Prints a row and writes it to the table of its input. A time of NaN leaves its cell empty. The cell of the error is
 * empty if `error` is NULL, and for a plain copy of an array. */
static void report_row(FILE *const csv[2], const struct task *t, const char *form, double ns, double ns_chained,
                       const double *error)
{
    static const char *const end[] = {[ZERO_OVERLAP] = "overlap", [ZERO_FORCE] = "force"};
    const struct method *const m = t->method;
    FILE *const files[2] = {csv[m->input], stdout};
    for (int i = 0; i < 2; i++) {
        fprintf(files[i], "%s,%s,%s,%s,%s,%s", t->scene->name, m->curve, m->setting,
                m->instructions ? m->instructions : "", m->end == NO_END ? "" : end[m->end], form);
        table_number(files[i], "%.4g", ns);
        table_number(files[i], "%.4g", ns_chained);
        /* an eps that is not a number makes the error nan */
        fprintf(files[i], m->end == NO_END || !error ? ",\n" : ",%.2e\n", error ? *error : NAN);
    }
}

/* Measures every method of the scene, in the cache. */
static void measure_scene(FILE *const csv[2], const struct methods *methods, const struct scene *scene,
                          struct timing timing)
{
    static struct truth truth;
    static struct task tasks[METHODS_MAX];
    static struct job jobs[2 * METHODS_MAX];
    struct inputs in = inputs_new(scene);
    size_t n = 0, n_jobs = 0;
    for (size_t i = 0; i < methods->n; i++) {
        const struct method *const m = &methods->row[i];
        if ((m->scene && strcmp(m->scene, scene->name) != 0) || m->end == NO_END)
            continue;
        tasks[n] = task_of(m, scene, &in);
        jobs[n_jobs++] = (struct job){run_each, &tasks[n], (double)tasks[n].n, NAN};
        if (m->chain)
            jobs[n_jobs++] = (struct job){run_chain, &tasks[n], (double)tasks[n].n, NAN};
        n++;
    }
    timing_measure(jobs, n_jobs, timing);
    truth_compute(&truth, scene);
    for (size_t i = 0, k = 0; i < n; i++) {
        const struct method *const m = tasks[i].method;
        const double ns = jobs[k++].best_ns, ns_chained = m->chain ? jobs[k++].best_ns : NAN;
        const double error = worst_error(&truth, scene, m);
        report_row(csv, &tasks[i], m->flags & ARRAY ? "array" : "scalar", ns, ns_chained, &error);
    }
    inputs_free(&in);
}

/* Returns the number of elements of an array with the size of the last-level cache, or 512 MiB if the cache is unknown.
 * The size of the array is at least 64 MiB, and at most 512 MiB and an eighth of the memory. */
static size_t large_elements(void)
{
    const double mib = 1 << 20;
    double bytes = 0;
#ifdef _SC_LEVEL3_CACHE_SIZE
    bytes = (double)sysconf(_SC_LEVEL3_CACHE_SIZE);
#endif
    if (bytes <= 0)
        bytes = 512 * mib;
    bytes = fmin(fmax(bytes, 64 * mib), 512 * mib);
#ifdef _SC_PHYS_PAGES
    bytes = fmin(bytes, (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE) / 8);
#endif
    return (size_t)bytes / sizeof(double);
}

/* Measures the methods with the flag LARGE on arrays larger than the cache. */
static void measure_large(FILE *const csv[2], const struct methods *methods, const struct scene *scene)
{
    static struct task tasks[METHODS_MAX];
    static struct job jobs[METHODS_MAX];
    const size_t elements = large_elements();
    double *const in = doubles(elements), *const out = doubles(elements);
    scene_speeds(scene, in, SCALARS);
    for (size_t i = SCALARS; i < elements; i += SCALARS)
        memcpy(in + i, in, sizeof *in * (elements - i < SCALARS ? elements - i : SCALARS));
    size_t n = 0;
    for (size_t i = 0; i < methods->n; i++)
        if (methods->row[i].flags & LARGE) {
            tasks[n] = (struct task){&methods->row[i], scene, in, out, elements};
            jobs[n] = (struct job){run_each, &tasks[n], (double)elements, NAN};
            n++;
        }
    timing_measure(jobs, n, (struct timing){.sample_ns = 1, .rounds = 6, .slow_share = 1});
    for (size_t i = 0; i < n; i++)
        report_row(csv, &tasks[i], "large", jobs[i].best_ns, NAN, NULL);
    free(in);
    free(out);
}

int main(int argc, char **argv)
{
    const int quick = argc == 3 && strcmp(argv[2], "--quick") == 0;
    if (argc != 2 + quick) {
        fprintf(stderr, "usage: cor_bench DIRECTORY [--quick]\n"
                        "DIRECTORY receives spheres_speed.csv and spheres_beta.csv\n");
        return 2;
    }
    static struct methods methods;
    add_published(&methods);
    add_library(&methods);
    add_embedded_plain(&methods);
#ifdef COR_BENCH_HAS_AVX2
    add_embedded_avx2(&methods);
#endif
#ifdef COR_BENCH_HAS_AVX512
    add_embedded_avx512(&methods);
#endif

    struct scene scenes[SCENES];
    scenes_init(scenes);
    static const char heading[] = "scene,curve,setting,instructions,end,form,ns,ns_dependent,max_relative_error";
    FILE *const csv[2] = {table_open(argv[1], "spheres_speed.csv", heading),
                          table_open(argv[1], "spheres_beta.csv", heading)};
    const struct timing timing = {.sample_ns = 4e5, .rounds = quick ? 8 : 64, .slow_share = 4};
    for (int i = 0; i < SCENES; i++)
        measure_scene(csv, &methods, &scenes[i], timing);
    if (!quick)
        measure_large(csv, &methods, &scenes[0]);
    table_close(csv[FROM_SPEED]);
    table_close(csv[FROM_BETA]);
    return 0;
}
