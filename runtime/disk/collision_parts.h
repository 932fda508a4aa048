/* SPDX-License-Identifier: MIT */
/* Full dynamics of a disk at a soft wall: declarations that the parts of the integrator share.
 *     collision_workspace.c      sizes and places of arrays, tables of modes and angles
 *     collision_run.c            a step, and one collision with steps of one size
 *     collision_runs.c           the runs of a call, their extrapolation to h = 0 and their error
 *     collision_kernel.c         the loops over modes and angles
 *     collision_tuning.h         every constant
 *
 * A mode is stored as the canonical pair q = sqrt(m omega) Q and p = sqrt(m omega) dQ/dt / omega. Free motion turns the
 * pair by the angle omega t. The coefficients c = C/sqrt(m omega) and s = S/sqrt(m omega) convert modes to the shape of
 * the rim, and the wall's force to forces on modes. */
#ifndef COR_RUNTIME_DISK_COLLISION_PARTS_H
#define COR_RUNTIME_DISK_COLLISION_PARTS_H

#include "runtime/disk/collision_tuning.h"
#include "runtime/disk/rim.h"

/* ---- loops: collision_kernel.c ---- */

/* Tables and loops process points and terms in panels of this size. */
enum { COR_PANEL = 4 * COR_LANES };

struct cor_rim {
    size_t blocks; /* number of blocks of modes */
    const struct cor_mode_block *block;
    const double *c, *s;    /* coefficients of the modes, one for each cell */
    size_t used_terms;      /* number of cosines in use: k < used_terms */
    size_t terms, points;   /* table sizes for k and j in cos(k phi_j), multiples of COR_PANEL */
    const double *by_point; /* [(j / COR_PANEL) terms + k][j % COR_PANEL] = cos(k phi_j) */
    const double *by_term;  /* [(k / COR_PANEL) points + j][k % COR_PANEL] = cos(k phi_j) */
};

/* Arrays over n have rim->blocks * COR_LANES elements. Arrays over terms have rim->terms elements, at least two more.
 * Arrays over angles have `points` elements. */
struct cor_collision_loops {
    /* For each mode of n: adds c force_c[n] + s force_s[n] to p, and turns (q, p) by the angle with the given cosine
     * and sine. Sets sum_c[n] and sum_s[n] to the sums of c q and s q. */
    void (*turn)(const struct cor_rim *rim, double *q, double *p, const double *cosine, const double *sine,
                 const double *force_c, const double *force_s, double *sum_c, double *sum_s);
    /* Sets d: sum_n sum_c cos(n phi) cos(phi) - sum_s sin(n phi) sin(phi) = sum_k d_k cos(k phi) */
    void (*gather)(const struct cor_rim *rim, const double *sum_c, const double *sum_s, double *d);
    /* Applies the transpose of gather: sets force_c and force_s of each n from e_k, times a factor */
    void (*split)(const struct cor_rim *rim, double factor, const double *e, double *force_c, double *force_s);
    /* Sets reach[j] = offset + shape[j] + sum_k d_k cos(k phi_j), j < points */
    void (*reach)(const struct cor_rim *rim, size_t points, double offset, const double *shape, const double *d,
                  double *reach);
    /* Sets pressure[j] = weight[j] exp(alpha reach[j]), or 0 where alpha reach is below -700. Returns their sum. */
    double (*press)(size_t points, double alpha, const double *weight, const double *reach, double *pressure);
    /* Sets e_k = sum_j pressure[j] cos(k phi_j) */
    void (*transform)(const struct cor_rim *rim, size_t points, const double *pressure, double *e);
    /* Subtracts factor response[j] pressure[j] from pressure[j]. Returns the sum of the new pressures. Sets *greatest
     * to the greatest response. */
    double (*soften)(size_t points, double factor, const double *response, double *pressure, double *greatest);
};

COR_TABLES(struct cor_collision_loops, cor_collision, cor_collision_set)

/* ---- the workspace and its constant tables: collision_workspace.c ---- */

struct cor_motion_sizes {
    size_t modes, n_max, blocks, cells; /* cells: array elements for modes, some of them empty */
    size_t terms, points;               /* points: array elements for the largest number of angles */
    double omega_max;
};

/* A disk, its wall, and the arrays of one call */
struct cor_motion {
    struct cor_motion_sizes size;
    struct cor_rim rim;
    const struct cor_collision_loops *loops;
    const struct cor_disk_mode *mode;
    double alpha, tolerance, speed;
    double work_left, work_per_step; /* the budget. A step costs work_per_step, or if this is 0, cor_motion_work */
    size_t phi, phi_limit;           /* number of angles in use, and the largest allowed number */
    size_t *place;                   /* cell of each mode */
    struct cor_mode_block *block;
    double *c, *s, *q, *p, *cosine, *sine;
    double *force_c, *force_s, *sum_c, *sum_s; /* one number for each n */
    double *cc, *cs, *ss;                      /* for each n, sums of C^2, C S and S^2, divided by the mass */
    double *d, *e, *shape, *flat, *weight, *reach, *pressure, *response, *by_point, *by_term, *table;
    double *after[COR_COLLISION_LEVELS], *average[COR_COLLISION_LEVELS]; /* [run][mode] */
};

/* Returns the largest number of angles that a call with these options may use. */
size_t cor_motion_phi_limit(const struct cor_disk_collision_options *options, size_t n_max);
/* Returns the number of angles that the tolerance is expected to need. */
size_t cor_motion_first_phi(const struct cor_motion *m, const struct cor_disk_collision_options *options);

struct cor_motion_sizes cor_motion_sizes(const struct cor_disk_mode *mode, size_t modes,
                                         const struct cor_disk_collision_options *options);
/* Sets the pointers of *m, whose size is set, to places in memory that starts at an aligned base. Returns the number of
 * bytes used. If base is NULL, the function only counts them. */
size_t cor_motion_arrange(struct cor_motion *m, char *base);
/* Fills the arrays of modes from m->mode. */
void cor_motion_set_modes(struct cor_motion *m);
/* Sets the angles phi_j = (j + shift/2) pi/(2 phi), j < phi, and the tables of cos(k phi_j). shift 0: the trapezoidal
 * rule without its last angle, pi/2, where the disk never touches the wall. shift 1: the midpoint rule, which to first
 * order has the opposite error. */
void cor_motion_set_angles(struct cor_motion *m, size_t phi, size_t shift);
/* Returns the multiplications of a step that computes the reach at `reached` angles and a pressure at `pressed` of
 * them. Fitted to measured times. */
double cor_motion_work(const struct cor_motion *m, size_t reached, size_t pressed);

/* ---- a step and a run: collision_run.c ---- */

/* State of the centre of mass and of the wall. struct cor_motion holds the modes; its force_c and force_s hold the part
 * of the last kick that the modes have not received yet. */
struct cor_collision_state {
    double time;
    double depth;     /* x_0 + 1; alpha x_0 would lose digits near x_0 = -1 */
    double v;         /* towards the wall, after the last kick */
    double load;      /* of the wall */
    double force;     /* force of the modified potential (15.1), which replaces the wall in the kick */
    double stiffness; /* h^2 alpha (largest acceleration of the rim) at the last kick */
    double ripple;    /* change of the load if only every second angle is used, at the last scan */
    size_t window;    /* angles near the contact that are evaluated between two scans */
};

enum cor_collision_outcome {
    COR_RUN_ENDED,      /* the run or the kick is complete */
    COR_RUN_TOO_STIFF,  /* the step is too large */
    COR_RUN_TOO_NARROW, /* the window omitted a significant pressure */
    COR_RUN_TOO_LONG    /* more than COR_DISK_COLLISION_MAX_STEPS or the call's budget */
};

/* The angles that a kick evaluates. COR_WINDOW: the angles in the window. COR_SCAN: all angles, to find the next window
 * and to check the last one. COR_ALL_ANGLES: all angles, because a window was too narrow in an earlier run. */
enum cor_collision_angles { COR_WINDOW, COR_SCAN, COR_ALL_ANGLES };

/* Sets the state of the disk and of its modes at the first moment, to first order in the wall's force. */
void cor_collision_approach(struct cor_motion *m, double h, struct cor_collision_state *now);
/* Computes free motion over h: the modes receive their part of the last kick and turn, and the centre drifts. */
void cor_collision_drift(struct cor_motion *m, double h, struct cor_collision_state *now);
/* Computes the wall's kick over h at the positions of *now. */
enum cor_collision_outcome cor_collision_kick(struct cor_motion *m, double h, enum cor_collision_angles angles,
                                              struct cor_collision_state *now);
/* Returns the energy of a mode halfway through the kick. */
double cor_collision_mode_energy(const struct cor_motion *m, size_t i);

struct cor_collision_run {
    double h;
    int number;     /* 0 for the first run with the same angles */
    int all_angles; /* evaluate all angles at every step */
    size_t steps;
    double work; /* part of the call's budget that the run has used */
    double eps, max_compression, contact_time;
    double max_load;
    double ripple;     /* largest change of the load if only every second angle is used */
    double stiffness;  /* largest h^2 alpha (acceleration of the rim) */
    double start, end; /* times at which the contact begins and ends; NaN if unknown */
};

/* Computes a collision with steps run->h. `before` is a run with larger steps, or NULL. The largest load of `before`
 * defines the start and the end of this run's contact. `average`, if not NULL, receives the mean energy of each mode
 * during the contact of `before`. The function calls detail->observe, if not NULL, at every step. On return the modes
 * are in their final state. */
enum cor_collision_outcome cor_collision_run(struct cor_motion *m, struct cor_collision_run *run,
                                             const struct cor_collision_run *before, double *average,
                                             const struct cor_disk_collision_detail *detail);

/* ---- the runs of a call: collision_runs.c ---- */

/* Ratio of the step of a run to the step of the next run */
#define COR_COLLISION_RATIO COR_ROOT_2

/* Extrapolates runs with steps h, h/sqrt(2), h/2, ... to h = 0. Sets all fields of *out except error_estimate. Also
 * sets energy_after, if it is not NULL, from the mode energies in m->after. Returns the sum of negative extrapolated
 * mode energies, which are set to 0. */
double cor_collision_results(const struct cor_motion *m, const struct cor_collision_run *run, int levels,
                             struct cor_disk_collision *out, double *energy_after);
/* Sets the mean energies from m->average, or NaN if no run has them. */
void cor_collision_averages(const struct cor_motion *m, const struct cor_collision_run *run, int levels,
                            double *energy_average);
/* _movement: how much the last run changes the extrapolated result. _difference: the difference of the last two runs.
 * Each is the larger of the change of eps and half the norm of the changes of mode energies/((pi/2) v^2). */
double cor_collision_movement(const struct cor_motion *m, const struct cor_collision_run *run, int levels);
double cor_collision_difference(const struct cor_motion *m, const struct cor_collision_run *run, int levels);

/* The parts of the error of eps; docs/theory-disks.md, 15 */
struct cor_collision_error {
    double step;      /* error of the extrapolation to h = 0 */
    double angles;    /* error of the quadrature over the rim */
    double round_off; /* effect of the rounding of all operations */
    double wall;      /* effect of the wall's force before the first and after the last moment */
};

/* Evidence of errors from the runs of a call */
struct cor_collision_evidence {
    int runs;                            /* number of runs with the same angles */
    double movement[COR_COLLISION_RUNS]; /* change of the extrapolated result by each run except the first */
    double amplification;                /* factor by which the collision amplifies errors: measured, or a bound */
    int measured;
    double by_angles; /* change of the result by shifted angles, if measured */
    int angles_measured;
};

/* Returns the error of the extrapolation to h = 0 after the last run. round_off: the part due to rounding. */
double cor_collision_step_error(const struct cor_motion *m, const struct cor_collision_evidence *evidence,
                                double round_off);
/* Returns the error of the quadrature relative to the peak load; 1 if it is unknown. */
double cor_collision_quadrature_error(const struct cor_motion *m, const struct cor_collision_run *run);
/* Sets all parts except `step`, for the last run. left: fraction of the energy that this run leaves in the modes. */
void cor_collision_other_errors(const struct cor_motion *m, const struct cor_collision_run *run, double left,
                                const struct cor_collision_evidence *evidence, struct cor_collision_error *error);
/* Returns the sum of the parts that smaller steps do not reduce. */
double cor_collision_lasting_error(const struct cor_collision_error *error);
/* Returns the sum of all parts, at most 1. */
double cor_collision_total_error(const struct cor_collision_error *error);

/* Makes runs. The estimated error determines the steps, the angles and the number of runs. m contains the modes and the
 * first angles; all results in *out are NaN at first. Returns a status as in cor/disk.h: COR_OK,
 * COR_TOLERANCE_NOT_REACHED or COR_CONTACT_NOT_ENDED. */
int cor_collision_runs(struct cor_motion *m, struct cor_disk_collision *out,
                       const struct cor_disk_collision_detail *detail);

#endif
