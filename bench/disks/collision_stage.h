/* SPDX-License-Identifier: MIT */
/* The library's inner loops of a collision, from outside. */
#ifndef COR_BENCH_DISKS_COLLISION_STAGE_H
#define COR_BENCH_DISKS_COLLISION_STAGE_H

#include <cor/disk.h>

#include "runtime/disk/collision_loops.h"

#define STAGE_MASS 3.14159265358979323846

/* A disk as the library's inner loops want it (runtime/disk/collision_loops.h) */
struct stage {
    size_t cells, lanes;
    struct cor_mode_block *block;
    struct cor_rim rim;
    double *omega, *c, *s, *by_point, *by_term;
    double *q, *p, *cosine, *sine;                               /* of modes */
    double *force_c, *force_s, *sum_c, *sum_s;                   /* of each n */
    double *d, *e;                                               /* of terms */
    double *reach, *pressure, *weight, *response, *shape, *flat; /* of angles */
};

/* angles: a multiple of COR_PANEL. The modes get a shape, as good as any. */
void stage_init(struct stage *stage, const struct cor_disk_modes *modes, size_t n_modes, size_t angles);
void stage_free(struct stage *stage);

size_t stage_panels(size_t n); /* the next multiple of COR_PANEL */

/* The loops of each instruction set; those of this processor come first. */
struct stage_set {
    const char *name;
    int set;
    const struct cor_collision_loops *loops;
};
extern const struct stage_set stage_sets[COR_INSTRUCTION_SETS];
size_t stage_sets_here(void);

#endif
