/* SPDX-License-Identifier: MIT */
#include "isa.h"

#ifndef COR_BENCH_SHARED
#include "runtime/sphere/array.h"
#endif

#if defined __GNUC__ && (defined __x86_64__ || defined __i386__)
#define SUPPORTS(FEATURE) (__builtin_cpu_supports(FEATURE) != 0)
#else
#define SUPPORTS(FEATURE) 0
#endif

int isa_always(void)
{
    return 1;
}

int isa_has_avx2(void)
{
    return SUPPORTS("avx2") && SUPPORTS("fma");
}

int isa_has_avx512(void)
{
    return SUPPORTS("avx512f") && SUPPORTS("avx512dq") && SUPPORTS("avx512vl");
}

/* What the library owes on this machine. */
static int shipped_target(void)
{
    return isa_has_avx512() ? 6 : isa_has_avx2() ? 4 : 0;
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
SET(0, portable)
SET(1, avx2)
SET(2, avx512)
#define SET_ROW(name, label, set, target)                                                                              \
    {                                                                                                                  \
        name, label, set##_available, set##_speed_overlap, set##_speed_force, set##_beta_overlap, set##_beta_force,    \
            target                                                                                                     \
    }

static int no_target(void)
{
    return 0;
}

static int avx2_target(void)
{
    return 4;
}

static int avx512_target(void)
{
    return 6;
}
#endif

const struct isa_row isa_rows[] = {
#ifndef COR_BENCH_SHARED
    SET_ROW("portable", "", portable, no_target),
    SET_ROW("AVX2", "AVX2", avx2, avx2_target),
    SET_ROW("AVX-512", "", avx512, avx512_target),
#endif
    {"as shipped", "cor array", isa_always, cor_contact_eps_zero_overlap_array, cor_contact_eps_zero_force_array,
     cor_sphere_eps_zero_overlap_array, cor_sphere_eps_zero_force_array, shipped_target},
};

const size_t isa_row_count = sizeof isa_rows / sizeof *isa_rows;
