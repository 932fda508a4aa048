/* SPDX-License-Identifier: MIT */
/* A row of generated/disk_limits.h. */
#ifndef COR_RUNTIME_DISK_LIMIT_H
#define COR_RUNTIME_DISK_LIMIT_H

/* The limit of 1 - eps^2, and its uncertainty, which is the spread of the fits. */
struct cor_disk_limit {
    double nu, speed, one_minus_eps2, uncertainty;
};

#endif
