/* SPDX-License-Identifier: MIT */
/* The lowest modes of a disk as doubles for the runtime. */
#ifndef COR_GEN_DISK_MODES_ROUNDED_H
#define COR_GEN_DISK_MODES_ROUNDED_H

#include "cor/disk.h"
#include "support/flint.h"

/* Sets *modes to the `count` lowest modes for nu, with every double nearest to the exact value; modes->mode is
 * malloc'ed. Works on parallel_threads() threads. Returns STATUS_OK, or STATUS_FAILED after reporting the failure. */
int disk_modes_rounded(struct cor_disk_modes *modes, const fmpq_t nu, slong count);

#endif
