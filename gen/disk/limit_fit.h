/* SPDX-License-Identifier: MIT */
/* The limit of a disk of infinitely many modes and a hard wall, from collisions of disks of N modes with walls of
 * hardness alpha. */
#ifndef COR_GEN_DISK_LIMIT_FIT_H
#define COR_GEN_DISK_LIMIT_FIT_H

#include <stddef.h>

/* The range of the laws. 1 - eps^2 is linear in 1/alpha if alpha v exceeds the first number. It is linear in 1/sqrt(N),
 * with modes ordered by frequency, from the second number of modes on. */
#define DISK_LIMIT_HARDNESS 20.0
#define DISK_LIMIT_MODES 1800
/* Largest residual of the central fit. Collisions with a larger one do not follow the laws. */
#define DISK_LIMIT_MAX_RESIDUAL 2e-4
#define DISK_LIMIT_ERRORS 2.0

struct disk_limit_row {
    double alpha;
    size_t modes;
    double one_minus_eps2; /* NaN if unknown; the row is then ignored */
};

struct disk_limit {
    double one_minus_eps2;
    double uncertainty;
    double residual; /* root mean square, of the central fit */
    double straight; /* limit of straight lines through the three hardest walls; not part of the uncertainty */
};

enum disk_limit_status {
    DISK_LIMIT_OK,
    DISK_LIMIT_SOFT_WALL, /* of a row: alpha v <= DISK_LIMIT_HARDNESS */
    DISK_LIMIT_FEW_MODES, /* of a row: N < DISK_LIMIT_MODES */
    DISK_LIMIT_FEW_ROWS,  /* fewer than 4 different alpha or 3 different N, or too few results */
    DISK_LIMIT_NO_LAW     /* residual > DISK_LIMIT_MAX_RESIDUAL */
};

/* Fits L + a u + c u^(5/3) + b w + d u w, u = 1/(alpha v), w = 1/sqrt(N), to the rows by least squares; L is the limit.
 * Its uncertainty is the largest difference from fits of another form (4/3 or 2 instead of 5/3, or an additional term
 * in w^2) plus DISK_LIMIT_ERRORS standard errors of the jackknife, from fits without each alpha and without each N.
 * Sets *limit only if the result is DISK_LIMIT_OK or DISK_LIMIT_NO_LAW; in the latter case the residual shows the
 * failure. */
enum disk_limit_status disk_limit_fit(struct disk_limit *limit, double speed, const struct disk_limit_row *row,
                                      size_t rows);
const char *disk_limit_text(enum disk_limit_status status);

#endif
