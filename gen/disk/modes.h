/* SPDX-License-Identifier: MIT */
/* The lowest free modes of an elastic disk, without gaps and with every number enclosed; docs/theory-disks.md, 11. */
#ifndef COR_GEN_DISK_MODES_H
#define COR_GEN_DISK_MODES_H

#include "cor/disk.h"
#include "support/flint.h"

#define DISK_MODES_MAX 10000000 /* largest number of modes of one disk */

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

/* Computes the `count` lowest modes for -1 < nu < 1, at least DISK_MARGIN from the ends, and proves that no mode is
 * missing. The intervals of omega, c and s are so narrow that digits_of_ball gives `digits` decimal digits and
 * digits_to_double a double; s of n = 0 is exactly 0. The result does not depend on the number of threads,
 * parallel_threads(). Returns 0, or 1 after reporting the failure. */
int disk_modes_solve(struct disk_modes *modes, const fmpq_t nu, slong count, slong digits);

/* Sets *modes to these modes, with every double nearest to the exact value; modes->mode is malloc'ed. Returns 0 or 1
 * likewise. */
int disk_modes_rounded(struct cor_disk_modes *modes, const fmpq_t nu, slong count);

/* Computes the mode (n, l) to about `bits` relative bits from an approximation to its omega, which may be wrong; from 0
 * by the count alone, which is slower. Returns 0 or 1 likewise. */
int disk_mode_solve(struct disk_mode *mode, const fmpq_t nu, slong n, slong l, double omega, slong bits);
void disk_mode_init(struct disk_mode *mode);
void disk_mode_clear(struct disk_mode *mode);

#endif
