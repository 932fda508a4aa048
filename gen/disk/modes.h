/* SPDX-License-Identifier: MIT */
/* The lowest free modes of an elastic disk, none missing, every number enclosed. docs/derivation.md, 11. */
#ifndef COR_GEN_DISK_MODES_H
#define COR_GEN_DISK_MODES_H

#include "support/flint.h"

#define DISK_MODES_MAX 10000000 /* modes that corgen computes of one disk, at most */

/* omega: frequency; c = u_r(1) > 0 and s = u_phi(1), (28), normalised by (26). l counts the modes of one n from 0. */
struct disk_mode {
    slong n, l;
    arb_t omega, c, s;
};

struct disk_modes {
    slong count;
    struct disk_mode *mode; /* by increasing omega */
};

void disk_modes_init(struct disk_modes *modes);
void disk_modes_clear(struct disk_modes *modes);

/* The `count` lowest modes for -1 < nu < 1, no nearer to the ends than DISK_MARGIN, proved to be these. omega, c and s of each are so narrow that
 * digits_of_ball gives `digits` decimal digits and digits_to_double its double; s of n = 0 is exactly 0. Works on all
 * threads of parallel_threads(), with the same result. Returns 0, or 1 after saying what failed. */
int disk_modes_solve(struct disk_modes *modes, const fmpq_t nu, slong count, slong digits);

/* One mode by its numbers, to about `bits` relative bits, by the count alone: slower. Returns 0 or 1 likewise. */
int disk_mode_solve(struct disk_mode *mode, const fmpq_t nu, slong n, slong l, slong bits);
void disk_mode_init(struct disk_mode *mode);
void disk_mode_clear(struct disk_mode *mode);

#endif
