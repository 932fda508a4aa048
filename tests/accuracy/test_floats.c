/* SPDX-License-Identifier: MIT */
/* Every float function of sphere.h at every float from 0 to infinity (inverse: to 1): how many results are not the
 * floats nearest to the exact values. The function of doubles, whose error its bound limits, decides all arguments but
 * those where its result lies within AMBIGUOUS_ULP units of its last place of the middle of two floats. The reference
 * decides these. A hash of all results stands in float_hashes.txt: correctly rounded results are the same with every
 * compiler, processor and C library. The array functions compute, because they are several times as fast;
 * tests/unit/test_loops.c holds their bits to those of the scalar functions.
 *
 * And the arrays in float arithmetic, "..._fast": the largest error in units of the last place of a float, and how many
 * results are not correctly rounded, by the double functions, whose bound counts as part of the error. From 16 on they
 * return cor_sphere_..f; 1 in FAR_STRIDE floats are taken there.
 *
 * test_accuracy --stride N takes every Nth float, of the arrays in float arithmetic FAST_SHARE times as many. With
 * --stride 1 it also prints the lines of float_hashes.txt. It fails if a result is wrong or the reference cannot
 * decide. Negative numbers and NaN give NaN, and -0 counts as 0: tests/unit tests that. */
#include "cor/sphere.h"

#include "reference.h"
#include "search.h"
#include "ulp.h"

#include <inttypes.h>
#include <stdio.h>

struct function {
    const char *name;
    void (*array)(const double *, double *, size_t);
    void (*arrayf)(const float *, float *, size_t);
    enum quantity quantity, other; /* of an inverse: what it inverts, and one less that */
    enum { DIRECT_FLOAT, INVERSE_FLOAT, FAST_FLOAT } kind;
};

#define IS_LOSS(shape) ((shape) == LOSS || (shape) == INVERSE_OF_LOSS)
#define PLAIN(name, shape, of, bound)                                                                                  \
    {#name,                                                                                                            \
     cor_sphere_##name##_array,                                                                                        \
     cor_sphere_##name##_arrayf,                                                                                       \
     IS_LOSS(shape) ? (of) + LOSS_OF_EPS : (of),                                                                       \
     IS_LOSS(shape) ? (of) : (of) + LOSS_OF_EPS,                                                                       \
     (shape) >= INVERSE ? INVERSE_FLOAT : DIRECT_FLOAT},
#define FAST(name, shape, of, bound)                                                                                   \
    PLAIN(name, shape, of, bound){#name "_fast", cor_sphere_##name##_array, cor_sphere_##name##_fast_arrayf, of, of,   \
                                  FAST_FLOAT},
static const struct function functions[] = {SPHERE_FUNCTIONS(FAST, PLAIN)};

enum {
    CHUNK_BITS = 24,
    MAX_CHUNKS = 128,
    BLOCK = 4096,
    AMBIGUOUS_ULP = 4, /* the largest bound of a sphere function is COR_SPHERE_TIME_MAX_ULP = 2 */
    FAST_SHARE = 16,
    FAR_STRIDE = 64,
    FAR_BITS = 0x41800000 /* of 16 */
};

/* The reference is good to a few 2^-64. It decides where the exact value is farther from the middle than 2^-60. */
static const double undecided_ulp = 0x1p-7;

/* ---- one argument ---- */

struct count {
    uint64_t taken, ambiguous, wrong, undecided, unrounded;
    double worst; /* of arrays in float arithmetic, in ulp of a float */
    float worst_at;
};

/* exact value minus middle, in units of the last place of the middle */
static double distance_from(const struct function *f, double x, double middle)
{
    long double off;
    if (f->kind == DIRECT_FLOAT) {
        off = reference_value(f->quantity, x) - middle;
    } else {
        const enum quantity quantity = x < 0.5 ? f->quantity : f->other;
        const long double wanted = x < 0.5 ? (long double)x : 1 - (long double)x;
        off = (wanted - reference_value(quantity, middle)) / reference_slope(quantity, middle);
    }
    return (double)(off / ulp(middle));
}

static void judge(struct count *count, const struct function *f, float x, float result, float below, float above)
{
    const double top = isinf(above) ? 0x1p128 : (double)above, middle = ((double)below + top) / 2;
    const double distance = distance_from(f, (double)x, middle);
    count->ambiguous++;
    if (!(fabs(distance) >= undecided_ulp)) {
        count->undecided++;
        printf("%s(%a): the reference is within %.3g ulp of the middle of two floats\n", f->name, (double)x, distance);
    } else if (result != (distance > 0 ? above : below)) {
        count->wrong++;
        printf("%s(%a) = %a is not the nearest float: off the middle by %.4f ulp of a double\n", f->name, (double)x,
               (double)result, distance);
    }
}

/* |result - exact| in units of the last place of a float, subnormals included; 2^29 units of a double are one. */
static void judge_fast(float x, float result, double y, struct count *count)
{
    const int exponent = (int)(bits_of(y) >> 52) - 1023;
    const int last = exponent < FLT_MIN_EXP - 1 ? FLT_MIN_EXP - FLT_MANT_DIG : exponent - (FLT_MANT_DIG - 1);
    double error = fabs((double)result - y) * double_of((uint64_t)(1023 - last) << 52);
    if (!(y < (double)FLT_MAX && y > 0)) /* 0, infinity and what rounds to it */
        error = result == (float)y ? 0 : HUGE_VAL;
    count->unrounded += result != (float)y;
    if (!(error <= count->worst)) {
        count->worst = isnan(error) ? HUGE_VAL : error;
        count->worst_at = x;
    }
}

/* result: of the float function at x; y: of the double function */
static void judge_at(const struct function *f, float x, float result, double y, struct count *count)
{
    const uint64_t y_bits = bits_of(y);
    if (y == 0 || isinf(y)) {
        count->wrong += (double)result != y;
        return;
    }
    const float below = (float)double_of(y_bits > AMBIGUOUS_ULP ? y_bits - AMBIGUOUS_ULP : 0);
    const float above = (float)double_of(y_bits + AMBIGUOUS_ULP);
    if (below != above) {
        judge(count, f, x, result, below, above);
    } else if (result != below) {
        count->wrong++;
        printf("%s(%a) = %a is not the double function rounded\n", f->name, (double)x, (double)result);
    }
}

/* ---- all arguments ---- */

struct job {
    const struct function *f;
    uint32_t thread, threads;
    uint64_t stride;
    struct count count;
    uint64_t *hash; /* of each chunk */
};

static uint64_t hash_with(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * UINT64_C(0x9e3779b97f4a7c15);
    return hash ^ hash >> 32;
}

static uint32_t last_bits(const struct function *f)
{
    return f->kind == INVERSE_FLOAT ? UINT32_C(0x3f800000) : UINT32_C(0x7f800000);
}

static void scan_chunk(struct job *job, uint32_t chunk)
{
    const struct function *const f = job->f;
    const uint64_t first = (uint64_t)chunk << CHUNK_BITS, end = first + (UINT64_C(1) << CHUNK_BITS);
    uint64_t hash = 0;
    uint64_t bits = first;
    while (bits < end && bits <= last_bits(f)) {
        const uint64_t step = job->stride * (f->kind == FAST_FLOAT && bits >= FAR_BITS ? FAR_STRIDE : 1);
        float xf[BLOCK], yf[BLOCK];
        double x[BLOCK], y[BLOCK];
        size_t n = 0;
        for (; n < BLOCK && bits < end && bits <= last_bits(f); n++, bits += step)
            x[n] = (double)(xf[n] = float_of((uint32_t)bits));
        f->array(x, y, n);
        f->arrayf(xf, yf, n);
        job->count.taken += n;
        for (size_t i = 0; i < n && f->kind == FAST_FLOAT; i++)
            judge_fast(xf[i], yf[i], y[i], &job->count);
        for (size_t i = 0; i < n && f->kind != FAST_FLOAT; i++) {
            uint32_t word;
            memcpy(&word, &yf[i], sizeof word);
            hash = hash_with(hash, word);
            judge_at(f, xf[i], yf[i], y[i], &job->count);
        }
    }
    job->hash[chunk] = hash;
}

static void *run_job(void *argument)
{
    struct job *const job = argument;
    const uint32_t chunks = (last_bits(job->f) >> CHUNK_BITS) + 1;
    for (uint32_t chunk = job->thread; chunk < chunks; chunk += job->threads)
        scan_chunk(job, chunk);
    return NULL;
}

static struct count scan(const struct function *f, uint64_t stride, int threads, uint64_t *hash)
{
    uint64_t hashes[MAX_CHUNKS] = {0};
    struct job jobs[SEARCH_MAX_THREADS];
    struct count all = {0};
    for (int i = 0; i < threads; i++)
        jobs[i] = (struct job){f, (uint32_t)i, (uint32_t)threads, stride, all, hashes};
    search_on_threads(run_job, jobs, sizeof *jobs, threads);
    for (int i = 0; i < threads; i++) {
        const struct count *const part = &jobs[i].count;
        all.taken += part->taken;
        all.ambiguous += part->ambiguous;
        all.wrong += part->wrong;
        all.undecided += part->undecided;
        all.unrounded += part->unrounded;
        all.worst_at = part->worst > all.worst ? part->worst_at : all.worst_at;
        all.worst = fmax(all.worst, part->worst);
    }
    *hash = 0;
    for (int i = 0; i < MAX_CHUNKS; i++)
        *hash = hash_with(*hash, hashes[i]);
    return all;
}

static bool function_is_good(const struct function *f, const struct search_options *o)
{
    const uint64_t stride = f->kind == FAST_FLOAT ? (o->stride + FAST_SHARE - 1) / FAST_SHARE : o->stride;
    uint64_t hash;
    const struct count count = scan(f, stride, o->threads, &hash);
    const double worst = count.worst + COR_SPHERE_TIME_MAX_ULP / 0x1p29;
    printf("# %s, %" PRIu64 " floats: ", f->name, count.taken);
    if (f->kind == FAST_FLOAT)
        printf("%.4f ulp of a float at %a, %" PRIu64 " not correctly rounded\n", worst, (double)count.worst_at,
               count.unrounded);
    else
        printf("%" PRIu64 " ambiguous, %" PRIu64 " wrong, %" PRIu64 " undecided\n", count.ambiguous, count.wrong,
               count.undecided);
    if (o->stride == 1 && f->kind != FAST_FLOAT)
        printf("%016" PRIx64 " %s\n", hash, f->name);
    fflush(stdout);
    return count.wrong == 0 && count.undecided == 0 && worst <= COR_SPHERE_FAST_FLOAT_MAX_ULP;
}

bool floats_are_good(const struct search_options *o)
{
    bool good = true;
    for (size_t i = 0; i < COUNT_OF(functions); i++)
        if (search_wants(o, functions[i].name))
            good = function_is_good(&functions[i], o) && good;
    return good;
}
