/* SPDX-License-Identifier: MIT */
/* The arrays in float arithmetic against those in double, at every float from 0 to 16: the largest error in units of
 * the last place of a float, where it is, and how many results are not correctly rounded. The double functions are off
 * by COR_SPHERE_TIME_MAX_ULP units of a double at most, which counts as part of the error. From 16 on the arrays return
 * cor_sphere_..f, which test_floats takes at every float; 1 in 64 floats are taken here.
 *
 *     test_fast_floats [--only TEXT] [--threads N] [--stride N]
 *
 * --stride N takes every Nth float, and 1 in 64 N from 16 on. The exit status is 1 if an error exceeds
 * COR_SPHERE_FAST_FLOAT_MAX_ULP. */
#include <cor/sphere.h>

#include <inttypes.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include "ulp.h"

struct function {
    const char *name;
    void (*array)(const double *, double *, size_t);
    void (*fast)(const float *, float *, size_t);
};

#define FUNCTION(name)                                                                                                 \
    {                                                                                                                  \
#name, cor_sphere_##name##_array, cor_sphere_##name##_fast_arrayf                                              \
    }
static const struct function functions[] = {
    FUNCTION(eps_zero_overlap), FUNCTION(eps_zero_force),        FUNCTION(loss_zero_overlap),
    FUNCTION(loss_zero_force),  FUNCTION(duration_zero_overlap), FUNCTION(duration_zero_force),
    FUNCTION(max_overlap),      FUNCTION(time_of_max_overlap),
};

enum {
    FUNCTIONS = sizeof functions / sizeof *functions,
    MAX_THREADS = 64,
    CHUNK_BITS = 22,
    BLOCK = 4096,
    FAR_STRIDE = 64
};
static const uint32_t infinity_bits = UINT32_C(0x7f800000), far_bits = UINT32_C(0x41800000) /* 16 */;

struct job {
    const struct function *f;
    uint64_t count, unrounded;
    double worst;
    float worst_at;
    uint32_t thread, threads, stride;
};

/* |result - exact| in units of the last place of a float, subnormals included */
static double error_of(float result, double exact)
{
    if (!(exact < (double)FLT_MAX && exact > 0)) /* 0, infinity and what rounds to it */
        return (double)result == (double)(float)exact ? 0 : HUGE_VAL;
    const int exponent = (int)(bits_of(exact) >> 52) - 1023;
    const int last = exponent < FLT_MIN_EXP - 1 ? FLT_MIN_EXP - FLT_MANT_DIG : exponent - (FLT_MANT_DIG - 1);
    const double error = fabs((double)result - exact) * double_of((uint64_t)(1023 - last) << 52);
    return isnan(error) ? HUGE_VAL : error;
}

static void scan_block(struct job *job, const float *xf, const double *x, size_t n)
{
    static const double of_double = COR_SPHERE_TIME_MAX_ULP / 536870912; /* 2^29 units of a double in one of a float */
    float yf[BLOCK];
    double y[BLOCK];
    job->f->array(x, y, n);
    job->f->fast(xf, yf, n);
    for (size_t i = 0; i < n; i++) {
        const double error = error_of(yf[i], y[i]);
        job->unrounded += yf[i] != (float)y[i];
        if (error > 0 && error + of_double > job->worst) {
            job->worst = error + of_double;
            job->worst_at = xf[i];
        }
    }
    job->count += n;
}

static void *scan_chunks(void *argument)
{
    struct job *const job = argument;
    for (uint64_t chunk = job->thread; chunk << CHUNK_BITS <= infinity_bits; chunk += job->threads) {
        const uint64_t end = (chunk + 1) << CHUNK_BITS;
        for (uint64_t bits = chunk << CHUNK_BITS; bits < end && bits <= infinity_bits;) {
            const uint64_t step = (uint64_t)job->stride * (bits >= far_bits ? FAR_STRIDE : 1);
            float xf[BLOCK];
            double x[BLOCK];
            size_t n = 0;
            for (; n < BLOCK && bits < end && bits <= infinity_bits; n++, bits += step)
                x[n] = (double)(xf[n] = float_of((uint32_t)bits));
            scan_block(job, xf, x, n);
        }
    }
    return NULL;
}

static int report(const struct function *f, uint32_t stride, uint32_t threads)
{
    struct job jobs[MAX_THREADS], all = {.f = f, .threads = threads, .stride = stride};
    pthread_t started[MAX_THREADS];
    for (uint32_t i = 0; i < threads; i++) {
        jobs[i] = all;
        jobs[i].thread = i;
        if (pthread_create(&started[i], NULL, scan_chunks, &jobs[i]) != 0)
            abort();
    }
    for (uint32_t i = 0; i < threads; i++) {
        pthread_join(started[i], NULL);
        all.count += jobs[i].count;
        all.unrounded += jobs[i].unrounded;
        if (jobs[i].worst > all.worst) {
            all.worst = jobs[i].worst;
            all.worst_at = jobs[i].worst_at;
        }
    }
    const int good = all.worst <= COR_SPHERE_FAST_FLOAT_MAX_ULP;
    printf("%s_fast_arrayf: %.4f ulp of a float at %a, %" PRIu64 " of %" PRIu64 " floats not correctly rounded%s\n",
           f->name, all.worst, (double)all.worst_at, all.unrounded, all.count, good ? "" : ": beyond the bound");
    fflush(stdout);
    return !good;
}

static int usage(void)
{
    fputs("usage: test_fast_floats [--only TEXT] [--threads 1..64] [--stride 1..1000000]\n", stderr);
    return 2;
}

int main(int argc, char **argv)
{
    const char *only = "";
    unsigned long threads = 1, stride = 1;
    for (int i = 1; i < argc; i += 2) {
        if (i + 1 == argc)
            return usage();
        if (strcmp(argv[i], "--only") == 0)
            only = argv[i + 1];
        else if (strcmp(argv[i], "--threads") == 0)
            threads = strtoul(argv[i + 1], NULL, 10);
        else if (strcmp(argv[i], "--stride") == 0)
            stride = strtoul(argv[i + 1], NULL, 10);
        else
            return usage();
    }
    if (threads < 1 || threads > MAX_THREADS || stride < 1 || stride > 1000000)
        return usage();
    int status = 0;
    for (int i = 0; i < FUNCTIONS; i++)
        if (strstr(functions[i].name, only) != NULL)
            status |= report(&functions[i], (uint32_t)stride, (uint32_t)threads);
    return status;
}
