/* SPDX-License-Identifier: MIT */
#include "isa.h"

#include "runtime/core/instruction_set.h"

#ifndef COR_BENCH_SHARED
#include "runtime/sphere/array.h"
#endif

int isa_always(void)
{
    return 1;
}

int isa_has_avx2(void)
{
#ifdef COR_X86_SETS
    return cor_processor_has(COR_AVX2) && __builtin_cpu_supports("fma");
#else
    return 0;
#endif
}

int isa_has_avx512(void)
{
    return cor_processor_has(COR_AVX512);
}

/* One set of sphere_array.h; a shared libcor shows none of them. */
#ifndef COR_BENCH_SHARED
#define SET(i, set)                                                                                                    \
    static int set##_available(void)                                                                                   \
    {                                                                                                                  \
        return cor_array_set(i) != NULL;                                                                               \
    }                                                                                                                  \
    static void set##_speed_overlap(const struct cor_sphere_contact *contact, const double *in, double *out, size_t n) \
    {                                                                                                                  \
        cor_array_set(i)->contact_eps_zero_overlap(contact, in, out, n);                                               \
    }                                                                                                                  \
    static void set##_speed_force(const struct cor_sphere_contact *contact, const double *in, double *out, size_t n)   \
    {                                                                                                                  \
        cor_array_set(i)->contact_eps_zero_force(contact, in, out, n);                                                 \
    }                                                                                                                  \
    static void set##_beta_overlap(const double *in, double *out, size_t n)                                            \
    {                                                                                                                  \
        cor_array_set(i)->sphere_eps_zero_overlap(in, out, n);                                                         \
    }                                                                                                                  \
    static void set##_beta_force(const double *in, double *out, size_t n)                                              \
    {                                                                                                                  \
        cor_array_set(i)->sphere_eps_zero_force(in, out, n);                                                           \
    }
SET(COR_PORTABLE, portable)
SET(COR_AVX2, avx2)
SET(COR_AVX512, avx512)
#define SET_ROW(name, set)                                                                                             \
    {                                                                                                                  \
        name, set##_available, set##_speed_overlap, set##_speed_force, set##_beta_overlap, set##_beta_force            \
    }
#endif

const struct isa_row isa_rows[] = {
#ifndef COR_BENCH_SHARED
    SET_ROW("portable", portable),
    SET_ROW("AVX2", avx2),
    SET_ROW("AVX-512", avx512),
#else
    {"as shipped", isa_always, cor_contact_eps_zero_overlap_array, cor_contact_eps_zero_force_array,
     cor_sphere_eps_zero_overlap_array, cor_sphere_eps_zero_force_array},
#endif
};

const size_t isa_row_count = sizeof isa_rows / sizeof *isa_rows;
