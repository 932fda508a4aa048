/* SPDX-License-Identifier: MIT */
/* The library's arrays, one instruction set at a time; as shipped where a shared library hides the sets. To add a row:
 * one entry in isa.c. */
#ifndef COR_BENCH_SUPPORT_ISA_H
#define COR_BENCH_SUPPORT_ISA_H

#include <stddef.h>

#include <cor/cor.h>

typedef void isa_speed(const struct cor_sphere_contact *, const double *, double *, size_t);
typedef void isa_beta(const double *, double *, size_t);

struct isa_row {
    const char *name;
    int (*available)(void); /* whether this machine can run it */
    isa_speed *speed_zero_overlap, *speed_zero_force;
    isa_beta *beta_zero_overlap, *beta_zero_force;
};

extern const struct isa_row isa_rows[];
extern const size_t isa_row_count;

int isa_always(void);
int isa_has_avx2(void); /* with FMA */
int isa_has_avx512(void);

#endif
