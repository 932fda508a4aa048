/* SPDX-License-Identifier: MIT */
#include "collision_stage.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "disk.h"

#define PI 3.14159265358979323846

size_t stage_panels(size_t n)
{
    return (n + COR_PANEL - 1) / COR_PANEL * COR_PANEL;
}

static void stage_modes(struct stage *st, const struct cor_disk_mode *mode, size_t n_modes)
{
    size_t *const filled = disk_memory(st->lanes, sizeof *filled);
    for (size_t i = 0; i < n_modes; i++) {
        size_t *const rows = &st->block[mode[i].n / COR_LANES].rows;
        const size_t in_lane = ++filled[mode[i].n];
        *rows = in_lane > *rows ? in_lane : *rows;
    }
    for (size_t b = 0; b < st->rim.blocks; b++) {
        st->block[b].first = st->cells / COR_LANES;
        st->cells += st->block[b].rows * COR_LANES;
    }
    double **const arrays[] = {&st->omega, &st->c, &st->s, &st->q, &st->p, &st->cosine, &st->sine};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        *arrays[i] = disk_memory(st->cells, sizeof(double));
    memset(filled, 0, st->lanes * sizeof *filled);
    for (size_t i = 0; i < n_modes; i++) {
        const size_t n = (size_t)mode[i].n,
                     cell = (st->block[n / COR_LANES].first + filled[n]++) * COR_LANES + n % COR_LANES;
        const double unit = 1 / sqrt(STAGE_MASS * mode[i].omega), omega = mode[i].omega;
        st->omega[cell] = omega;
        st->c[cell] = unit * mode[i].c;
        st->s[cell] = unit * mode[i].s;
        st->cosine[cell] = cos(0.01 * omega);
        st->sine[cell] = sin(0.01 * omega);
        st->q[cell] = 1e-3 * cos(omega) / (omega * omega);
        st->p[cell] = 1e-3 * sin(omega) / (omega * omega);
    }
    free(filled);
}

void stage_init(struct stage *st, const struct cor_disk_modes *modes, size_t n_modes, size_t angles)
{
    const size_t points = angles;
    memset(st, 0, sizeof *st);
    size_t n_max = 0;
    for (size_t i = 0; i < n_modes; i++)
        n_max = (size_t)modes->mode[i].n > n_max ? (size_t)modes->mode[i].n : n_max;
    st->rim.blocks = n_max / COR_LANES + 1;
    st->lanes = st->rim.blocks * COR_LANES;
    st->block = disk_memory(st->rim.blocks, sizeof *st->block);
    stage_modes(st, modes->mode, n_modes);
    const size_t terms = stage_panels(n_max + 2), room = terms + st->lanes + 2;
    double **const of_n[] = {&st->force_c, &st->force_s, &st->sum_c, &st->sum_s};
    for (size_t i = 0; i < sizeof of_n / sizeof *of_n; i++)
        *of_n[i] = disk_memory(st->lanes, sizeof(double));
    st->d = disk_memory(room, sizeof(double));
    st->e = disk_memory(room, sizeof(double));
    double **const of_angles[] = {&st->reach, &st->pressure, &st->weight, &st->response, &st->shape, &st->flat};
    for (size_t i = 0; i < sizeof of_angles / sizeof *of_angles; i++)
        *of_angles[i] = disk_memory(points, sizeof(double));
    st->by_point = disk_memory(points * terms, sizeof(double));
    st->by_term = disk_memory(points * terms, sizeof(double));
    for (size_t j = 0; j < points; j++) {
        st->weight[j] = PI / (double)points;
        st->shape[j] = cos(((double)j + 0.5) * PI / (2 * (double)points)) - 1;
        for (size_t k = 0; k < n_max + 2; k++) {
            const double value = cos((double)k * ((double)j + 0.5) * PI / (2 * (double)points));
            st->by_point[(j / COR_PANEL * terms + k) * COR_PANEL + j % COR_PANEL] = value;
            st->by_term[(k / COR_PANEL * points + j) * COR_PANEL + k % COR_PANEL] = value;
        }
    }
    st->rim.block = st->block;
    st->rim.c = st->c;
    st->rim.s = st->s;
    st->rim.used_terms = n_max + 2;
    st->rim.terms = terms;
    st->rim.points = points;
    st->rim.by_point = st->by_point;
    st->rim.by_term = st->by_term;
}

void stage_free(struct stage *st)
{
    free(st->block);
    double *const arrays[] = {st->omega,  st->c,     st->s,        st->by_point, st->by_term,  st->q,     st->p,
                              st->cosine, st->sine,  st->force_c,  st->force_s,  st->sum_c,    st->sum_s, st->d,
                              st->e,      st->reach, st->pressure, st->weight,   st->response, st->shape, st->flat};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        free(arrays[i]);
}

const struct stage_set stage_sets[COR_INSTRUCTION_SETS] = {
    {"portable", COR_PORTABLE, &cor_collision_portable},
#ifdef COR_X86_SETS
    {"AVX2", COR_AVX2, &cor_collision_avx2},
    {"AVX-512", COR_AVX512, &cor_collision_avx512},
#endif
};

size_t stage_sets_here(void)
{
    size_t n = 0;
    while (n < COR_INSTRUCTION_SETS && stage_sets[n].loops && cor_processor_has(stage_sets[n].set))
        n++;
    return n;
}
