/* SPDX-License-Identifier: MIT */
#include "runtime/disk/rim.h"

#include <math.h>
#include <stdint.h>

#include "cor/status.h"

int cor_disk_table_check(const struct cor_disk_modes *modes, size_t n_modes)
{
    if (modes == NULL || modes->mode == NULL)
        return COR_ERROR_NULL;
    if (!isless(fabs(modes->nu), 1))
        return COR_ERROR_DISK_POISSON_RATIO;
    if (n_modes < 1 || n_modes > modes->count)
        return COR_ERROR_MODES;
    for (size_t i = 0; i < n_modes; i++) {
        const struct cor_disk_mode *const mode = &modes->mode[i];
        if (mode->n < 0 || mode->n > COR_DISK_MODES_MAX_N || !isgreater(mode->omega, 0) ||
            !(isless(mode->omega, 1e9) && isless(fabs(mode->c), 1e9) && isless(fabs(mode->s), 1e9)) ||
            (i > 0 && !(mode->omega > mode[-1].omega)))
            return COR_ERROR_MODES;
    }
    return COR_OK;
}

/* Returns the largest number of modes with the same n in a block. */
static size_t rows_of_block(const struct cor_disk_mode *mode, size_t modes, size_t block)
{
    size_t count[COR_LANES] = {0}, most = 0;
    for (size_t i = 0; i < modes; i++)
        if ((size_t)mode[i].n / COR_LANES == block)
            count[(size_t)mode[i].n % COR_LANES]++;
    for (size_t i = 0; i < COR_LANES; i++)
        most = count[i] > most ? count[i] : most;
    return most;
}

size_t cor_mode_blocks(const struct cor_disk_mode *mode, size_t modes, size_t blocks, struct cor_mode_block *block)
{
    size_t first = 0;
    for (size_t b = 0; b < blocks; b++) {
        const size_t rows = rows_of_block(mode, modes, b);
        if (block != NULL) {
            block[b].first = first;
            block[b].rows = rows;
        }
        first += rows;
    }
    return first * COR_LANES;
}

void cor_mode_places(const struct cor_disk_mode *mode, size_t modes, size_t blocks, const struct cor_mode_block *block,
                     double *filled, size_t *place)
{
    memset(filled, 0, blocks * COR_LANES * sizeof *filled);
    for (size_t i = 0; i < modes; i++) {
        const size_t n = (size_t)mode[i].n, row = (size_t)filled[n]++;
        place[i] = (block[n / COR_LANES].first + row) * COR_LANES + n % COR_LANES;
    }
}

void *cor_store_take(struct cor_store *store, size_t n, size_t bytes)
{
    void *const here = store->base == NULL ? NULL : store->base + store->used;
    store->used += cor_whole(n * bytes, COR_ALIGNMENT);
    return here;
}

void *cor_store_aligned(void *workspace)
{
    const size_t address = (size_t)(uintptr_t)workspace;
    return (char *)workspace + (cor_whole(address, COR_ALIGNMENT) - address);
}
