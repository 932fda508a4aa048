/* SPDX-License-Identifier: MIT */
/* An elastic disk at a rigid wall: declarations that the parts of the solver share. docs/theory-disks.md, 17, has the
 * formulas.
 *
 * Modes below the frequency Omega of a level move. A smooth cutoff w(omega/Omega) ("fade") multiplies the rim functions
 * of each mode by sqrt(w). The static compliance of all modes, less the part of the moving ones, acts at once. The wall
 * is rigid: contact forces y_j >= 0 act at the angles phi_j = j d, and no angle reaches into the wall. y_j acts on the
 * pair +-phi_j, and y_0 at one angle. These forces act as kicks at intervals h.
 *
 * Between kicks a mode turns freely, so its amplitude Q at successive kicks obeys
 *
 *     Q_(k+1) = 2 cos(omega h) Q_k - Q_(k-1) + g F_k,     g = h sin(omega h)/(m omega)
 *
 * where F_k is the force on the mode. The code stores q = Q/sqrt(g). The coefficients c = sqrt(w g) C and s = sqrt(w g)
 * S then convert modes to the shape of the rim, and the wall's forces to forces on modes. */
#ifndef COR_RUNTIME_DISK_HARD_WALL_PARTS_H
#define COR_RUNTIME_DISK_HARD_WALL_PARTS_H

#include "runtime/disk/rim.h"

/* Number of kicks in one pass over the modes. The pass also predicts, without forces, the sums over the modes of each n
 * at the next kicks. The echo sums of hard_wall_level.c add the effect of the forces. */
enum { COR_HARD_WALL_BATCH = 4 };
/* The numbers of angles and of terms are multiples of this size. */
enum { COR_HARD_WALL_PANEL = 64 };
/* Largest n of a mode, which occurs at Omega = 1100 */
enum { COR_HARD_WALL_MAX_N = 2047 };

struct cor_hard_wall_modes {
    size_t blocks;
    const struct cor_mode_block *block;
    const double *turn, *c, *s; /* turn: 2 cos(omega h); c, s: as above */
    double *q, *before;         /* amplitudes at a kick and at the previous kick */
};

/* The angles j d, d = pi/N, and tables for sums of cosines over them. With k = a + M b and j = r + Q s, where Q =
 * COR_HARD_WALL_PANEL and M = 2N/Q are integers, exp(i k j d) = exp(2 pi i b r/Q) exp(i a r d) exp(2 pi i a s/M). */
struct cor_hard_wall_angles {
    const double *twice_cosine; /* 2 cos(j d) */
    size_t bins;                /* M; 0 if the tables are not worthwhile, and the pointers below are then unused */
    double *part;               /* [b][2][Q]: cosines and sines of 2 pi b r/Q, b <= Q/2 */
    double *turn;               /* [a][2][Q]: cosines and sines of a r d */
    double *whole;              /* [M][2]: cosines and sines of 2 pi x/M */
    double *sums;               /* scratch, [M][2][Q] */
};
/* True if `count` cosines are summed in parts, over b and then over a, which is faster for many cosines. */
COR_INLINE int cor_hard_wall_sums_by_parts(const struct cor_hard_wall_angles *angles, size_t count)
{
    return angles->bins > 0 && count > 2 * angles->bins;
}

/* Loops that are compiled for every instruction set. All sets give the same bits. Let lanes be blocks*COR_LANES.
 * Arrays over n have `lanes` elements, and part [b] of such an array begins at element b*lanes. */
struct cor_hard_wall_loops {
    /* Advances the modes by `steps` kicks with the forces [0..steps-1] of each n. Sets [0..steps-1] of sum_c and sum_s
     * to sum c q and sum s q at the next kicks without forces. steps is BATCH or 1. */
    void (*advance)(const struct cor_hard_wall_modes *modes, size_t steps, const double *force_c, const double *force_s,
                    double *sum_c, double *sum_s);
    /* Sets result[j] = sum_(k < count) factor[k] cos(k j d), j < points. count <= N + 1; points is a multiple of
     * COR_HARD_WALL_PANEL. */
    void (*cosines)(const struct cor_hard_wall_angles *angles, size_t count, const double *factor, size_t points,
                    double *result);
    /* dot returns sum x_i y_i. subtract sets y_i to y_i - factor x_i, i < n. n is a multiple of COR_LANES. */
    double (*dot)(size_t n, const double *x, const double *y);
    void (*subtract)(size_t n, double factor, const double *x, double *y);
};

COR_TABLES(struct cor_hard_wall_loops, cor_hard_wall, cor_hard_wall_set)

/* ---- contact: hard_wall_contact.c ---- */

/* Cholesky factor of the compliance between some angles. Row i below the diagonal is padded with zeros to whole
 * vectors; pivot holds the inverse of the diagonal. */
struct cor_hard_wall_factor {
    double *below, *pivot;
    size_t rows;
    size_t *angle; /* angle of each row */
};

/* The compliance that acts at once, and the contact forces, at the angles j d, j < points */
struct cor_hard_wall_contact {
    const struct cor_hard_wall_loops *loops;
    size_t points; /* a multiple of COR_HARD_WALL_PANEL */
    double constant;
    /* Functions of the sums and differences of angles, from -points to 2 points, with 0 at [points]. The compliance
     * between angles i and j is same[i - j] + same[i + j] + across[i + j] cosine[i - j] + across[i - j] cosine[i + j] +
     * constant. */
    double *same, *across, *cosine;
    double *far;                       /* far[k]: upper bound on |compliance| between angles at distance k or more */
    struct cor_hard_wall_factor whole; /* factor of the first angles 0, 1, 2, ... It grows when needed */
    struct cor_hard_wall_factor part;  /* factor of the angles of the last contact in several pieces */
    size_t *wanted;
    double *z, *row;
    unsigned char *touches, *faulty;
    size_t pivotings; /* number of contacts that were not one piece from angle 0 */
    double work;      /* multiplications so far */
    int indefinite;   /* the compliance is not positive definite, so the modes are wrong */
};

/* Takes the arrays from the store. */
void cor_hard_wall_contact_arrange(struct cor_hard_wall_contact *contact, struct cor_store *store, size_t points);
/* Sets the compliance from T_k, k < t_terms, and Q_n, n < q_terms, of docs/theory-disks.md, 17; further ones are 0.
 * angles->twice_cosine and scratch have 2 points elements. */
void cor_hard_wall_contact_begin(struct cor_hard_wall_contact *contact, size_t t_terms, const double *t, size_t q_terms,
                                 const double *q, const struct cor_hard_wall_angles *angles, double constant,
                                 double *scratch);
/* Sets `points` forces y >= 0 under which no angle reaches into the wall. reach[j] is the reach of angle j without
 * forces; a reach up to `negligible` counts as 0. Returns 1 plus the last angle with a force; if this is `points`, the
 * contact may be wider. */
size_t cor_hard_wall_contact_solve(struct cor_hard_wall_contact *contact, const double *reach, double negligible,
                                   double *y);

/* ---- one level: hard_wall_level.c ---- */

/* Smooth cutoffs w(r), r = omega/Omega, which are 0 for r >= 1. The second is for tests: both have the same limit. */
enum cor_hard_wall_fade {
    COR_HARD_WALL_FADE,       /* (1 - r^2)^2 (1 + r^2) */
    COR_HARD_WALL_PLAIN_FADE, /* (1 - r^2)^2 */
    COR_HARD_WALL_FADES
};

/* Parameters of one level */
struct cor_hard_wall_settings {
    double omega; /* Omega, at most the frequency of the last mode */
    double turn;  /* Omega h */
    enum cor_hard_wall_fade fade;
    int point;      /* a point contact, far narrower than every wavelength; the next two fields are then unused */
    double spacing; /* upper limit of d; d divides pi */
    double range;   /* largest angle, at most pi/2 */
    /* The budget. The level gives up when its work exceeds most_work; 0: without limit. The work is work_per_step times
     * the steps, or the number of multiplications if work_per_step is 0. */
    double most_work, work_per_step;
    const struct cor_hard_wall_loops *loops; /* NULL: the loops of the widest set */
};

/* Multiplications of a call without max_steps; it takes 5 to 10 s at 0.06 to 0.12 ns each, like cor_disk_collision. */
#define COR_HARD_WALL_WORK 8e10
/* Ratio of the multiplications of two successive levels: sqrt(2) for the steps times 2 for modes or angles */
#define COR_HARD_WALL_GROWTH 2.8284271247461903
/* Number of multiplications that cor_disk_modes_compute needs for each mode */
#define COR_HARD_WALL_MODE_WORK 2e3

/* Results of one level */
struct cor_hard_wall_result {
    double one_minus_eps2, contact_time, max_compression;
    double energy_drift; /* energy after minus energy before, relative to (pi/2) v^2 */
    size_t steps, pivotings;
    double work; /* also set if the level gave up */
};

/* Returns the bytes of workspace for a level of the lowest `modes` modes, a multiple of COR_ALIGNMENT. */
size_t cor_hard_wall_level_bytes(const struct cor_disk_mode *mode, size_t modes,
                                 const struct cor_hard_wall_settings *settings);
/* Computes a level with the modes below settings->omega. Returns COR_OK, COR_ERROR_MODES (no disk has such modes),
 * COR_CONTACT_NOT_ENDED, COR_ERROR_WORKSPACE if the contact is wider than settings->range, or COR_TOLERANCE_NOT_REACHED
 * if the budget ended. detail may be NULL. */
int cor_hard_wall_level(void *workspace, const struct cor_disk_modes *modes, double speed,
                        const struct cor_hard_wall_settings *settings, struct cor_hard_wall_result *result,
                        const struct cor_disk_hard_wall_detail *detail);

/* ---- the sequence: hard_wall.c ---- */

/* Does the same as cor_disk_hard_wall_nu, with a budget of most_work multiplications if options->max_steps is 0. Sets
 * *work to the work done. */
int cor_hard_wall_within(double most_work, double nu, const struct cor_disk_hard_wall_options *options, double speed,
                         struct cor_disk_hard_wall *out, double *work);

#endif
