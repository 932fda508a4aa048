/* SPDX-License-Identifier: MIT */
/* The lowest modes of a disk as the doubles that the runtime takes. */
#ifndef COR_GEN_DISK_MODES_ROUNDED_H
#define COR_GEN_DISK_MODES_ROUNDED_H

#include "cor/disk.h"
#include "support/flint.h"

/* Sets *modes to the `count` lowest for nu, every double the one nearest to the exact value; modes->mode is malloc'ed.
 * Works on all threads of parallel_threads(). STATUS_OK, or STATUS_FAILED after saying what failed. */
int disk_modes_rounded(struct cor_disk_modes *modes, const fmpq_t nu, slong count);

#endif
