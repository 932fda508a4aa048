/* SPDX-License-Identifier: MIT */
/* Functions that can fail return COR_OK = 0 or a positive status. */
#ifndef COR_STATUS_H
#define COR_STATUS_H

#include "export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The numbers are part of the interface: a new status gets the next number, and no number is used again. */
enum cor_status {
    COR_OK = 0,
    COR_ERROR_NULL = 1,             /* a pointer is NULL */
    COR_ERROR_YOUNG_MODULUS = 2,    /* not positive, or NaN; +inf is a rigid body */
    COR_ERROR_POISSON_RATIO = 3,    /* outside (-1, 1/2], or NaN */
    COR_ERROR_DISSIPATION_TIME = 4, /* negative, infinite or NaN */
    COR_ERROR_RADIUS = 5,           /* not positive, or NaN; +inf is a flat wall */
    COR_ERROR_MASS = 6,             /* not positive, or NaN; +inf is a fixed body */
    COR_ERROR_BOTH_FLAT = 7,        /* two infinite radii: two walls */
    COR_ERROR_BOTH_FIXED = 8,       /* two infinite masses */
    COR_ERROR_BOTH_RIGID = 9,       /* two infinite moduli */
    COR_ERROR_G_STAR = 10,          /* characteristic speed not positive, out of range, or NaN */
    COR_ERROR_RANGE = 11,           /* an input, field or result out of range */
    /* disk.h */
    COR_ERROR_DISK_POISSON_RATIO = 12, /* outside (-1, 1), or NaN */
    COR_ERROR_DATUM = 13,              /* not a value of enum cor_disk_datum */
    COR_ERROR_SPEED = 14,              /* negative, NaN, or above the domain of the function */
    COR_ERROR_MODES = 15,              /* zero modes, more than the table has, or a table out of order */
    COR_ERROR_TOLERANCE = 16,          /* outside the range of the function, or NaN */
    COR_ERROR_FILE = 17,               /* cannot be opened or read */
    COR_ERROR_FILE_VERSION = 18,       /* not a mode file, or a mode file of another version */
    COR_ERROR_FILE_DAMAGED = 19,       /* the checks of a mode file fail */
    COR_ERROR_CAPACITY = 20,           /* an array is too small for its results */
    /* The functions return these statuses together with results that do not fully meet the request. */
    COR_BEYOND_THEORY = 21,         /* a collision too violent for perturbation theory */
    COR_TOLERANCE_NOT_REACHED = 22, /* too few modes, an exhausted budget, or no convergence */
    COR_WALL_NOT_TOUCHED = 23,      /* a disk that does not move towards the wall */
    COR_CONTACT_NOT_ENDED = 24,     /* a contact longer than the steps allowed */
    /* disk.h, full dynamics */
    COR_ERROR_ALPHA = 25,      /* hardness of the wall out of range, or NaN */
    COR_ERROR_PHI_POINTS = 26, /* more angles than COR_DISK_COLLISION_MAX_PHI_POINTS */
    COR_ERROR_WORKSPACE = 27,  /* a workspace is smaller than the size function requires */
    COR_ERROR_MEMORY = 28,     /* the allocation of a workspace failed */
    /* contact.h, plates */
    COR_ERROR_DENSITY = 29,  /* not positive, infinite or NaN */
    COR_ERROR_THICKNESS = 30 /* not positive, infinite or NaN */
};

/* Returns one English sentence for a status, without a newline. The result is never NULL: a number that is not a status
 * also gives a sentence. The string is constant and lives as long as the program. */
COR_API const char *cor_status_text(int status);

#ifdef __cplusplus
}
#endif

#endif
