/* SPDX-License-Identifier: MIT */
/* Parts common to the disk at a soft wall (collision_parts.h) and at a rigid wall (hard_wall_parts.h): the table, its
 * modes in blocks, the rim's cosine series, and workspaces.
 *
 * A block has COR_LANES lanes, one for each n, and one row for each mode of that n. Therefore sums over the modes of
 * each n need no sum across lanes. Each lane of a row is a cell; empty cells have c = s = 0.
 *
 * On the rim, cos(n phi) cos(phi) and sin(n phi) sin(phi) are half sums or differences of cos((n +- 1) phi), so one
 * cosine series represents them all. */
#ifndef COR_RUNTIME_DISK_RIM_H
#define COR_RUNTIME_DISK_RIM_H

#include <stddef.h>
#include <string.h>

#include "cor/disk.h"
#include "runtime/number/elementary.h"
#include "runtime/number/sets.h"

#define COR_DISK_MASS COR_PI

/* Returns COR_OK, or the status of the first error in the lowest n_modes modes of a table. */
int cor_disk_table_check(const struct cor_disk_modes *modes, size_t n_modes);

/* Returns n, rounded up to a multiple of `of`. */
COR_INLINE size_t cor_whole(size_t n, size_t of)
{
    return (n + of - 1) / of * of;
}

/* ---- modes in blocks ---- */

struct cor_mode_block {
    size_t first, rows; /* first row and number of rows, of COR_LANES doubles each */
};

/* Sets the blocks, unless block is NULL, and returns the number of their cells. */
size_t cor_mode_blocks(const struct cor_disk_mode *mode, size_t modes, size_t blocks, struct cor_mode_block *block);
/* Sets place[i] to the cell of mode i. filled: scratch, one number for each n. */
void cor_mode_places(const struct cor_disk_mode *mode, size_t modes, size_t blocks, const struct cor_mode_block *block,
                     double *filled, size_t *place);

/* ---- workspaces ---- */

/* Alignment of arrays: the bytes of the widest vector */
enum { COR_ALIGNMENT = 64 };

/* Takes arrays from an aligned workspace, or only counts their bytes if base is NULL. */
struct cor_store {
    char *base;
    size_t used;
};
void *cor_store_take(struct cor_store *store, size_t n, size_t bytes);
/* Returns the first aligned address. A workspace needs COR_ALIGNMENT more bytes than its arrays. */
void *cor_store_aligned(void *workspace);

/* Take, or clear, arrays of n doubles each. */
#define COR_STORE_TAKE_DOUBLES(store, n, ...)                                                                          \
    do {                                                                                                               \
        double **const taken_[] = {__VA_ARGS__};                                                                       \
        for (size_t i_ = 0; i_ < sizeof taken_ / sizeof *taken_; i_++)                                                 \
            *taken_[i_] = cor_store_take(store, n, sizeof(double));                                                    \
    } while (0)
#define COR_CLEAR_DOUBLES(n, ...)                                                                                      \
    do {                                                                                                               \
        double *const cleared_[] = {__VA_ARGS__};                                                                      \
        for (size_t i_ = 0; i_ < sizeof cleared_ / sizeof *cleared_; i_++)                                             \
            memset(cleared_[i_], 0, (n) * sizeof(double));                                                             \
    } while (0)

#endif
