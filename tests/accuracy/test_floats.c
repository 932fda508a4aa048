/* SPDX-License-Identifier: MIT */
/* Tests the arrays in float arithmetic, cor_sphere_..._arrayf, at every float from 0 to infinity. Finds the largest
 * error in units of the last place of a float, and counts the results that are not correctly rounded. The reference is
 * the double function, whose bound is added to the error. Above 16 the arrays return the rounded double function, so
 * only one float in FAR_STRIDE is tested.
 *
 * test_accuracy --stride N tests one float in N/FAST_SHARE. It fails if the error exceeds its bound. Negative numbers
 * and NaN give NaN, and -0 counts as 0: tests/unit tests these cases. */
#include "cor/law.h"
#include "cor/sphere.h"

#include "search.h"
#include "ulp.h"

#include <inttypes.h>
#include <stdio.h>

enum {
    CHUNK_BITS = 24,
    CHUNKS = 0x7f800000 / (1 << CHUNK_BITS) + 1,
    BLOCK = 4096,
    FAST_SHARE = 16,
    FAR_STRIDE = 64,
    FAR_BITS = 0x41800000 /* the bits of 16 */
};

struct count {
    uint64_t taken, unrounded;
    double worst; /* largest error in ulp of a float */
    float worst_at;
};

/* Adds one result to *count. The error is in units of the last place of a float, subnormal floats included. */
static void judge(float x, float result, double y, struct count *count)
{
    const int exponent = (int)(bits_of(y) >> 52) - 1023;
    const int last = exponent < FLT_MIN_EXP - 1 ? FLT_MIN_EXP - FLT_MANT_DIG : exponent - (FLT_MANT_DIG - 1);
    double error = fabs((double)result - y) * double_of((uint64_t)(1023 - last) << 52);
    if (!(y < (double)FLT_MAX && y > 0)) /* the rounded reference is 0 or infinity */
        error = result == (float)y ? 0 : HUGE_VAL;
    count->taken++;
    count->unrounded += result != (float)y;
    if (!(error <= count->worst)) {
        count->worst = isnan(error) ? HUGE_VAL : error;
        count->worst_at = x;
    }
}

struct job {
    const struct cor_law_function *f;
    uint32_t thread, threads;
    uint64_t stride;
    struct count count;
};

static void *run_job(void *argument)
{
    struct job *const job = argument;
    for (uint32_t chunk = job->thread; chunk < CHUNKS; chunk += job->threads) {
        const uint64_t first = (uint64_t)chunk << CHUNK_BITS, end = first + (UINT64_C(1) << CHUNK_BITS);
        uint64_t bits = first;
        while (bits < end && bits <= UINT32_C(0x7f800000)) {
            const uint64_t step = job->stride * (bits >= FAR_BITS ? FAR_STRIDE : 1);
            float xf[BLOCK], yf[BLOCK];
            double x[BLOCK], y[BLOCK];
            size_t n = 0;
            for (; n < BLOCK && bits < end && bits <= UINT32_C(0x7f800000); n++, bits += step)
                x[n] = (double)(xf[n] = float_of((uint32_t)bits));
            job->f->array(x, y, n);
            job->f->arrayf(xf, yf, n);
            for (size_t i = 0; i < n; i++)
                judge(xf[i], yf[i], y[i], &job->count);
        }
    }
    return NULL;
}

static bool function_is_good(const struct cor_law_function *f, const struct search_options *o)
{
    struct job jobs[SEARCH_MAX_THREADS];
    struct count all = {0};
    for (int i = 0; i < o->threads; i++)
        jobs[i] = (struct job){f, (uint32_t)i, (uint32_t)o->threads, (o->stride + FAST_SHARE - 1) / FAST_SHARE, all};
    search_on_threads(run_job, jobs, sizeof *jobs, o->threads);
    for (int i = 0; i < o->threads; i++) {
        const struct count *const part = &jobs[i].count;
        all.taken += part->taken;
        all.unrounded += part->unrounded;
        all.worst_at = part->worst > all.worst ? part->worst_at : all.worst_at;
        all.worst = fmax(all.worst, part->worst);
    }
    const double worst = all.worst + COR_SPHERE_LOSS_MAX_ULP / 0x1p29;
    printf("# %s, %" PRIu64 " floats: %.4f ulp of a float at %a, %" PRIu64 " not correctly rounded\n", f->name,
           all.taken, worst, (double)all.worst_at, all.unrounded);
    fflush(stdout);
    return worst <= COR_SPHERE_FLOAT_MAX_ULP;
}

bool floats_are_good(const struct search_options *o)
{
    bool good = true;
    for (int k = 0; k < 4; k++) {
        const struct cor_law_function *const f =
            cor_law_function(COR_LAW_VISCOELASTIC, (enum cor_end)(k / 2), (enum cor_quantity)(k % 2));
        if (search_wants(o, f->name))
            good = function_is_good(f, o) && good;
    }
    return good;
}
