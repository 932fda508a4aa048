/* SPDX-License-Identifier: MIT */
/* Definitions that the writer (gen/tables/disk.c) and the reader (runtime/disk/modes.c) of mode files share;
 * docs/disks.md. */
#ifndef COR_RUNTIME_DISK_MODE_FILE_H
#define COR_RUNTIME_DISK_MODE_FILE_H

#include <stddef.h>

#include "runtime/number/inline.h"

#define COR_MODE_FILE_NAME "cor-disk-modes"
#define COR_MODE_FILE_VERSION "1"
#define COR_MODE_FILE_CHECK_START UINT32_C(2166136261)

/* Returns the check at the end of a line: FNV-1a, 32 bits, of every byte of the file before the check. One wrong byte
 * always changes the check, because every step is a bijection. */
COR_INLINE uint32_t cor_mode_file_check(uint32_t check, const char *bytes, size_t n)
{
    for (size_t i = 0; i < n; i++)
        check = (check ^ (unsigned char)bytes[i]) * UINT32_C(16777619);
    return check;
}

#endif
