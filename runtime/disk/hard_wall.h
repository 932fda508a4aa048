/* SPDX-License-Identifier: MIT */
/* An elastic disk at a rigid wall: what the parts of the solver share. docs/derivation.md, 17, has the formulas.
 *
 * Modes below the frequency Omega of a level move, mode i with sqrt(w_i) times its rim functions, w(omega/Omega) a
 * fade; what is left of the static compliance of all modes acts at once. The wall is rigid: contact forces y_j >= 0
 * stand on the angles phi_j = j d, y_j on the pair +-phi_j, y_0 on one, and no angle reaches into the wall. Kicks of
 * these forces follow each other at intervals h.
 *
 * Between kicks a mode turns freely, so its amplitude Q at successive kicks obeys
 *
 *     Q_(k+1) = 2 cos(omega h) Q_k - Q_(k-1) + g F_k,     g = h sin(omega h)/(m omega)
 *
 * with F_k the force on the mode. It is held as q = Q/sqrt(g), and c = sqrt(w g) C, s = sqrt(w g) S then stand in both
 * directions, from modes to the rim and from forces to modes. Modes of one n stand in one lane of a block of COR_LANES
 * different n, one mode a row; empty places have c = s = 0. */
#ifndef COR_RUNTIME_DISK_HARD_WALL_H
#define COR_RUNTIME_DISK_HARD_WALL_H

#include <stddef.h>

#include "cor/disk.h"
#include "runtime/core/instruction_set.h"

/* Kicks for which one pass over the modes suffices: the pass also foretells what the sums over the modes of each n
 * would be at the next kicks without forces; what the forces add is known from sums over products, cor_hard_wall_echo.
 * */
enum { COR_HARD_WALL_BATCH = 4 };
/* Angles and terms are summed in panels of so many. */
enum { COR_HARD_WALL_PANEL = 32 };
enum { COR_HARD_WALL_LANES = 8 };
/* Largest n of a mode; Omega = 1100 has it. */
enum { COR_HARD_WALL_MAX_N = 2047 };

struct cor_hard_wall_block {
    size_t first, rows; /* in COR_HARD_WALL_LANES doubles */
};

struct cor_hard_wall_modes {
    size_t blocks;
    const struct cor_hard_wall_block *block;
    const double *turn, *c, *s; /* 2 cos(omega h), and as above */
    double *q, *before;         /* at a kick, and at the one before it */
};

/* Loops that are built for every instruction set; all give the same bits. Arrays of each n have `lanes` elements, lanes
 * = blocks COR_HARD_WALL_LANES; [b] of an array is at b lanes. */
struct cor_hard_wall_loops {
    /* Takes the modes through `steps` kicks with the forces [0..steps-1] of each n, and sets [0..steps-1] of sum_c and
     * sum_s: what sum c q and sum s q will be at that and the next kicks if nothing pushes. steps: BATCH or 1. */
    void (*advance)(const struct cor_hard_wall_modes *modes, size_t steps, const double *force_c, const double *force_s,
                    double *sum_c, double *sum_s);
    /* result[i] = sum_(k < count) factor[k] cos(k i d), i < points, from twice_cosine[i] = 2 cos(i d); points is a
     * multiple of COR_HARD_WALL_PANEL */
    void (*cosines)(size_t count, const double *factor, size_t points, const double *twice_cosine, double *result);
    /* sum x_i y_i and y_i -= factor x_i, i < n: n is a multiple of COR_HARD_WALL_LANES */
    double (*dot)(size_t n, const double *x, const double *y);
    void (*subtract)(size_t n, double factor, const double *x, double *y);
};

extern const struct cor_hard_wall_loops cor_hard_wall_portable;
#ifdef COR_X86_SETS
extern const struct cor_hard_wall_loops cor_hard_wall_avx2, cor_hard_wall_avx512;
#endif
const struct cor_hard_wall_loops *cor_hard_wall_widest_loops(void);

/* ---- workspaces ---- */

/* Cuts arrays from a workspace, or only counts their bytes while base is NULL. */
struct cor_hard_wall_store {
    char *base;
    size_t used;
};
void *cor_hard_wall_take(struct cor_hard_wall_store *store, size_t n, size_t bytes);

/* ---- contact: hard_wall_contact.c ---- */

/* Cholesky's factor of the compliance between some angles: row i of it, below the diagonal, is padded with zeros to
 * whole vectors, and 1 over the diagonal stands in pivot. */
struct cor_hard_wall_factor {
    double *below, *pivot;
    size_t rows;
    size_t *angle; /* of each row */
};

/* The compliance at once, and the contact forces, on angles j d, j < points */
struct cor_hard_wall_contact {
    const struct cor_hard_wall_loops *loops;
    size_t points; /* a multiple of COR_HARD_WALL_PANEL */
    double constant;
    /* Of the sums and differences of angles, from -points to 2 points, 0 at [points]: the compliance between angles i
     * and j is same[i - j] + same[i + j] + across[i + j] cosine[i - j] + across[i - j] cosine[i + j] + constant. */
    double *same, *across, *cosine;
    double *far;                       /* far[k]: no |compliance| between angles k or more apart is greater */
    struct cor_hard_wall_factor whole; /* of angles 0, 1, 2, ..., as many as were needed yet */
    struct cor_hard_wall_factor part;  /* of the angles of the last contact that was not one piece */
    size_t *wanted;
    double *z, *row;
    unsigned char *touches, *faulty;
    size_t pivotings; /* contacts that were not one piece from 0 on */
    int indefinite;   /* the compliance is not positive definite: wrong modes */
};

/* Cuts the arrays from the store. */
void cor_hard_wall_contact_arrange(struct cor_hard_wall_contact *contact, struct cor_hard_wall_store *store,
                                   size_t points);
/* From T_k, k < t_terms, and Q_n, n < q_terms, of derivation 17; the others are 0. twice_cosine[i] = 2 cos(i d), i < 2
 * points; scratch has 2 points elements. */
void cor_hard_wall_contact_begin(struct cor_hard_wall_contact *contact, size_t t_terms, const double *t, size_t q_terms,
                                 const double *q, const double *twice_cosine, double constant, double *scratch);
/* Sets the forces y >= 0, `points` of them, at which no angle reaches into the wall, if reach[j] is how far it would
 * without forces; up to `negligible` counts as nothing. Returns 1 more than the last angle with a force, which is
 * `points` where the contact does not fit. */
size_t cor_hard_wall_contact_solve(struct cor_hard_wall_contact *contact, const double *reach, double negligible,
                                   double *y);

/* ---- one level: hard_wall_level.c ---- */

/* Fades w(r), r = omega/Omega, 0 from r = 1 on. The second one is for tests: two fades have one limit. */
enum cor_hard_wall_fade {
    COR_HARD_WALL_FADE,       /* (1 - r^2)^2 (1 + r^2) */
    COR_HARD_WALL_PLAIN_FADE, /* (1 - r^2)^2 */
    COR_HARD_WALL_FADES
};

/* How one level is computed */
struct cor_hard_wall_settings {
    double omega; /* Omega, at most the frequency of the last mode */
    double turn;  /* Omega h */
    enum cor_hard_wall_fade fade;
    int point;      /* a point contact: its width is neglected beside every wavelength; the next two are not used */
    double spacing; /* at most d; d divides pi */
    double range;   /* the angles reach so far, at most pi/2 */
};

/* What it found */
struct cor_hard_wall_result {
    double one_minus_eps2, contact_time, max_compression;
    double energy_drift; /* energy after less energy before, relative to (pi/2) v^2 */
    size_t steps, pivotings;
};

/* Bytes of workspace for a level of the lowest `modes` modes, a multiple of what the workspace must be aligned to */
enum { COR_HARD_WALL_ALIGNMENT = 64 };
size_t cor_hard_wall_level_bytes(const struct cor_disk_mode *mode, size_t modes,
                                 const struct cor_hard_wall_settings *settings);
/* COR_OK, COR_ERROR_MODES (no disk has such modes), COR_CONTACT_NOT_ENDED, or COR_ERROR_WORKSPACE where the contact is
 * wider than settings->range. Takes the modes below settings->omega. detail may be NULL. */
int cor_hard_wall_level(void *workspace, const struct cor_disk_modes *modes, double speed,
                        const struct cor_hard_wall_settings *settings, struct cor_hard_wall_result *result,
                        const struct cor_disk_hard_wall_detail *detail);

#endif
