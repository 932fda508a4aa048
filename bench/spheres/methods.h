/* SPDX-License-Identifier: MIT */
/* The compared methods: every method is a row of the table. Each file methods_*.c adds its own rows. Each file also
 * contains the timed loops, written as a user would write them, so that inline functions are inlined. */
#ifndef COR_BENCH_SPHERES_METHODS_H
#define COR_BENCH_SPHERES_METHODS_H

#include <stdio.h>
#include <stdlib.h>

#include "scene.h"

enum {
    ARRAY = 1,      /* one call computes all eps; the arrays fit the first-level cache */
    LARGE = 2,      /* also timed on arrays larger than the last-level cache */
    INTEGRATES = 4, /* takes microseconds for each eps, so it is timed at fewer speeds */
    FLOAT = 8       /* `in` and `out` are arrays of float; errors compare with eps of the rounded argument */
};

struct method {
    const char *curve;        /* methods of one curve differ by their setting and instructions */
    char setting[32];         /* degrees, a tolerance, steps; empty: none */
    const char *instructions; /* instruction set of loops and arrays; NULL: not selected */
    const char *scene;        /* the only scene that it supports, or NULL */
    enum end end;
    enum input input;
    unsigned flags;
    int number; /* number of steps; for array functions of the library, the instruction set */

    /* computes out[i] = eps(in[i]), independently for each i */
    void (*each)(const struct method *method, const struct scene *scene, const double *in, double *out, size_t n);
    /* computes the same, but each eps waits for the previous one; returns the last eps; NULL for arrays */
    double (*chain)(const struct method *method, const struct scene *scene, const double *in, size_t n);
};

enum { METHODS_MAX = 512 };

struct methods {
    struct method row[METHODS_MAX];
    size_t n;
};

static inline void methods_add(struct methods *methods, const struct method *method)
{
    if (methods->n == METHODS_MAX) {
        fprintf(stderr, "bench: more methods than methods.h has rows for\n");
        exit(1);
    }
    methods->row[methods->n++] = *method;
}

/* Each of these adds its rows. */
void add_published(struct methods *methods);
void add_library(struct methods *methods);

/* Defined by methods_embedded.c, which is compiled once for each of these sets of flags */
void add_embedded_plain(struct methods *methods);
void add_embedded_avx2(struct methods *methods);
void add_embedded_avx512(struct methods *methods);

/* Keeps a scalar loop scalar; otherwise compilers vectorise inlined functions. */
#if defined __GNUC__
#define ONE_BY_ONE __asm__ volatile("")
#else
#define ONE_BY_ONE ((void)0)
#endif

/* Makes G wait for LAST without changing G, at the least cost that the machine allows. */
#if defined __GNUC__ && defined __AVX__
#define WAIT_FOR(LAST, G) __asm__ volatile("vunpcklpd %1, %0, %0" : "+x"(G) : "x"(LAST))
#elif defined __GNUC__ && defined __SSE2__
#define WAIT_FOR(LAST, G) __asm__ volatile("unpcklpd %1, %0" : "+x"(G) : "x"(LAST))
#else
static volatile float methods_zero;
#define WAIT_FOR(LAST, G) ((G) += methods_zero * (LAST))
#endif

/* Defines NAME_each and NAME_chain, which run SETUP and then evaluate EXPRESSION in g, a speed or beta. Both may use
 * `scene` and `method`. */
#define SCALAR_METHOD_OF(REAL, NAME, SETUP, EXPRESSION)                                                                \
    static void NAME##_each(const struct method *method, const struct scene *scene, const double *in, double *out,     \
                            size_t n)                                                                                  \
    {                                                                                                                  \
        (void)method;                                                                                                  \
        (void)scene;                                                                                                   \
        SETUP;                                                                                                         \
        const REAL *const from = (const REAL *)(const void *)in;                                                       \
        REAL *const to = (REAL *)(void *)out;                                                                          \
        for (size_t i = 0; i < n; i++) {                                                                               \
            const REAL g = from[i];                                                                                    \
            ONE_BY_ONE;                                                                                                \
            to[i] = (EXPRESSION);                                                                                      \
        }                                                                                                              \
    }                                                                                                                  \
    static double NAME##_chain(const struct method *method, const struct scene *scene, const double *in, size_t n)     \
    {                                                                                                                  \
        (void)method;                                                                                                  \
        (void)scene;                                                                                                   \
        SETUP;                                                                                                         \
        const REAL *const from = (const REAL *)(const void *)in;                                                       \
        REAL last = 0;                                                                                                 \
        for (size_t i = 0; i < n; i++) {                                                                               \
            REAL g = from[i];                                                                                          \
            WAIT_FOR(last, g);                                                                                         \
            last = (EXPRESSION);                                                                                       \
        }                                                                                                              \
        return last;                                                                                                   \
    }

/* A row of NAME_each and NAME_chain */
#define METHOD(CURVE, SETTING, END, INPUT, FLAGS, NAME)                                                                \
    {                                                                                                                  \
        .curve = CURVE, .setting = SETTING, .end = END, .input = INPUT, .flags = FLAGS, .each = NAME##_each,           \
        .chain = NAME##_chain                                                                                          \
    }

/* Defines NAME_each as a loop that the compiler may vectorise. */
#define ARRAY_METHOD_OF(REAL, NAME, SETUP, EXPRESSION)                                                                 \
    static void NAME##_each(const struct method *method, const struct scene *scene, const double *restrict in,         \
                            double *restrict out, size_t n)                                                            \
    {                                                                                                                  \
        (void)method;                                                                                                  \
        (void)scene;                                                                                                   \
        SETUP;                                                                                                         \
        const REAL *const restrict from = (const REAL *)(const void *)in;                                              \
        REAL *const restrict to = (REAL *)(void *)out;                                                                 \
        for (size_t i = 0; i < n; i++) {                                                                               \
            const REAL g = from[i];                                                                                    \
            to[i] = (EXPRESSION);                                                                                      \
        }                                                                                                              \
    }

#endif
