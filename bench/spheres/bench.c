/* SPDX-License-Identifier: MIT */
/* Speed of eps, error beside every time: one row a method, all in one run.
 *
 *   ns                   random speeds one after the other, each
 *   ns_dependent         each speed waits for the eps before it
 *   max_relative_error   largest over the speeds of the scene, against the collision integrated in long double */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "methods.h"
#include "report.h"
#include "support/timing.h"
#include "truth.h"

enum {
    IN_CACHE = 2048, /* an array and its eps in the first-level cache */
    SCALARS = 16384, /* more than a branch predictor learns by heart */
    COLLISIONS = 64, /* for what takes microseconds each: few, even in their logarithm */
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

static int belongs(const struct method *method, const struct scene *scene)
{
    return !method->scene || strcmp(method->scene, scene->name) == 0;
}

/* The speeds of a scene and their beta, by enum input. */
struct inputs {
    double *random[2]; /* SCALARS of them, of which arrays take the first */
    double *even[2];   /* COLLISIONS */
    float *single[2];  /* the random ones in float */
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

/* Every method of the scene, in the cache. */
static void measure_scene(struct report *report, const struct methods *methods, const struct scene *scene,
                          struct timing timing)
{
    static struct truth truth;
    static struct task tasks[2 * ROWS];
    static struct job jobs[2 * ROWS];
    static struct result results[ROWS];
    struct inputs in = inputs_new(scene);
    size_t n = 0, n_jobs = 0;
    for (size_t i = 0; i < methods->n; i++) {
        const struct method *const m = &methods->row[i];
        if (!belongs(m, scene) || m->end == NO_END)
            continue;
        results[n++] = (struct result){m, m->flags & ARRAY ? "array" : "scalar", NAN, NAN, NAN};
        for (int chained = 0; chained < (m->chain ? 2 : 1); chained++, n_jobs++) {
            tasks[n_jobs] = task_of(m, scene, &in);
            jobs[n_jobs] = (struct job){chained ? run_chain : run_each, &tasks[n_jobs], (double)tasks[n_jobs].n, NAN};
        }
    }
    timing_measure(jobs, n_jobs, timing);
    truth_compute(&truth, scene);
    for (size_t i = 0, k = 0; i < n; i++) {
        results[i].ns = jobs[k++].best_ns;
        if (results[i].method->chain)
            results[i].ns_chained = jobs[k++].best_ns;
        results[i].error = truth_worst_error(&truth, scene, results[i].method);
        report_row(report, scene, &results[i]);
    }
    inputs_free(&in);
}

/* Numbers in an array that, with its eps, is twice the last-level cache: 64 MiB at least, and no more than an eighth
 * of the memory and 512 MiB, which is also taken where the cache is not known. */
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

/* The library from a speed, and copies, on arrays larger than the cache */
static void measure_large(struct report *report, const struct methods *methods, const struct scene *scene)
{
    static struct task tasks[ROWS];
    static struct job jobs[ROWS];
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
        report_row(report, scene, &(struct result){tasks[i].method, "large", jobs[i].best_ns, NAN, NAN});
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
    add_integrators(&methods);
    add_copies(&methods);

    struct scene scenes[SCENES];
    scenes_init(scenes);
    struct report report;
    report_open(&report, argv[1]);
    const struct timing timing = {.sample_ns = 4e5, .rounds = quick ? 8 : 64, .slow_share = 4};
    for (int i = 0; i < SCENES; i++)
        measure_scene(&report, &methods, &scenes[i], timing);
    if (!quick)
        measure_large(&report, &methods, &scenes[0]);
    report_close(&report);
    truth_print_formulas();
    return 0;
}
