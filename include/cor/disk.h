/* SPDX-License-Identifier: MIT */
/* Elastic disks: free modes, quasistatic contact law, and the energy that a slow collision leaves in the modes.
 *
 * A disk of radius R, Young's modulus E and mass per area rho meets a hard wall head on; two equal disks that meet
 * with twice the speed are the same, by symmetry. Everything is in units E = rho = R = 1: speeds in sqrt(E/rho), times
 * in R sqrt(rho/E), loads in E R, energies in E R^2, compressions in R; the mass of the disk is pi. nu is Poisson's
 * number in plane stress, -1 < nu < 1. A disk in plane strain, with three-dimensional E and nu, is the one with
 * E/(1 - nu^2) and nu/(1 - nu) in their place, (2).
 *
 * Floating-point environment: no function raises FE_INVALID, FE_DIVBYZERO or FE_OVERFLOW or sets errno for arguments in
 * its domain, so that programs may trap these. The contact law and Rayleigh's energy round to nearest whatever the
 * caller's mode is.
 *
 * Equation numbers (n) are those of Gerl and Zippelius, Phys. Rev. E 59, 2361 (1999); docs/derivation.md, 11 to 17,
 * derives them again and lists where the print is wrong. */
#ifndef COR_DISK_H
#define COR_DISK_H

#include <stddef.h>

#include "export.h"

#ifdef __cplusplus
extern "C" {
#if defined(__GNUC__)
/* A function and a struct may have one name; g++ -Wshadow minds. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#endif
#endif

/* Bounds on the error of the functions below, asserted by the tests; docs/accuracy.md records the worst found. All
 * sampled. Unless said otherwise they hold for every nu and datum in the whole domain. */
#define COR_DISK_LAW_MAX_ULP 4.0              /* contact law, largest compression and load, limits: ulp */
#define COR_DISK_CONTACT_TIME_MAX_ERROR 1e-15 /* relative */
#define COR_DISK_RAYLEIGH_MAX_ERROR 1e-10     /* of a mode's fraction, relative, or ... */
#define COR_DISK_RAYLEIGH_MAX_ABSOLUTE 1e-14  /* ... relative to the sum, where a zero of (68) makes it small */
/* Sum plus tail, relative, of any number of modes of the two tables below: for v >= 1e-9, and for all v. With tables of
 * 1800 modes for other nu 1e-5 holds too but, barely, at nu = 0.2; docs/accuracy.md. */
#define COR_DISK_RAYLEIGH_TAIL_MAX_ERROR 1e-5
#define COR_DISK_RAYLEIGH_TAIL_MAX_ERROR_ANY_SPEED 4e-5
/* Speed beyond which a collision is too violent for perturbation theory, and cor_disk_rayleigh says so. */
#define COR_DISK_RAYLEIGH_MAX_SPEED 0.03

/* Bytes of stack that a function takes at most, asserted by tests/unit/test_stack.c. Measured, built with optimisation and
 * with what libm takes: 58 kB by cor_disk_rayleigh, 6 kB by cor_disk_collision, 4 kB by the others; 20 kB by the functions
 * of arrays in cor/sphere.h and cor/contact.h. */
#define COR_DISK_MAX_STACK 65536

/* ---- free modes ---- */

/* One free vibration of the disk: displacements u_r(r) cos(n phi), u_phi(r) sin(n phi), frequency omega; l = 0, 1, ...
 * counts the modes of one n upwards. c = u_r(1) and s = u_phi(1), (28), normalised by (26); the overall sign is that
 * of c > 0. The torsional modes of n = 0 have c = s = 0 and are left out, as is the translation n = 1, omega = 0. */
struct cor_disk_mode {
    int n, l;
    double omega, c, s;
};

/* The lowest `count` modes of a disk, by increasing omega, none missing. mode has count elements. */
struct cor_disk_modes {
    double nu;
    size_t count;
    const struct cor_disk_mode *mode;
};

/* The 1800 lowest modes for nu = 0.33 and nu = 0.9, every double the one nearest to the exact value (proved). Other
 * materials: corgen tables --poisson NU --modes N writes a header to embed and a file to read. */
COR_API extern const struct cor_disk_modes cor_disk_modes_nu033;
COR_API extern const struct cor_disk_modes cor_disk_modes_nu090;

/* Reads a mode file that corgen wrote (docs/mode-file.md) into mode[0..capacity-1], and sets *modes, whose mode is then
 * that array. Fails without touching *modes but for modes->count, which becomes what the file promises where `capacity`
 * is too small for it, so that 0 asks how many there are (mode may then be NULL). *line, if line is not NULL, becomes
 * the line of the file that is wrong, or 0. COR_OK, or one of
 *     COR_ERROR_NULL, COR_ERROR_FILE (cannot be read), COR_ERROR_FILE_VERSION (no mode file, or one of another
 *     version), COR_ERROR_FILE_DAMAGED (a line is not as it was written, ends early, or a number cannot be),
 *     COR_ERROR_CAPACITY. */
COR_API int cor_disk_modes_read(const char *path, struct cor_disk_mode *mode, size_t capacity,
                                struct cor_disk_modes *modes, size_t *line);

/* Computes the `count` lowest modes of a disk in double arithmetic into mode[0..count-1], for any nu, and sets *modes,
 * whose mode is then that array. 13,000 modes take 0.1 s; the time grows like omega^3, the number like omega^2.
 * Allocates, and frees, as much memory again as the modes take.
 * Domain: -1 < nu < 1 and 1 <= count <= COR_DISK_MODES_MAX_COUNT.
 * Accuracy, sampled against proved tables: omega to COR_DISK_MODES_OMEGA_MAX_ERROR, relative; c and s to
 * COR_DISK_MODES_AMPLITUDE_MAX_ERROR, relative to the length of (c, s). Nothing proves that no mode is missing; `corgen
 * tables --poisson NU --modes N` proves a table.
 * COR_OK, or without touching anything COR_ERROR_NULL, COR_ERROR_DISK_POISSON_RATIO, COR_ERROR_MODES (count), or
 * COR_ERROR_MEMORY. */
#define COR_DISK_MODES_MAX_COUNT 1000000
#define COR_DISK_MODES_OMEGA_MAX_ERROR 2e-14
#define COR_DISK_MODES_AMPLITUDE_MAX_ERROR 1e-10
COR_API int cor_disk_modes_compute(double nu, size_t count, struct cor_disk_mode *mode, struct cor_disk_modes *modes);

/* Number of modes below omega, about ((1 - nu^2) + 2 (1 + nu)) omega^2/8. Domain: -1 < nu < 1, 0 < omega <=
 * COR_DISK_MODES_MAX_OMEGA; 0 outside. May be off by one where omega is the frequency of a mode to rounding. */
#define COR_DISK_MODES_MAX_OMEGA 2000.0
COR_API size_t cor_disk_modes_below(double nu, double omega);

/* ---- quasistatic contact law ---- */

/* Between which points the compression delta is measured; it decides the constant b of the contact law
 *
 *     delta = (P/pi) (ln(4 pi/P) + b),     V = P^2/(2 pi) (ln(4 pi/P) + b - 1/2)                               (57)
 */
enum cor_disk_datum {
    COR_DISK_DATUM_CENTRE_OF_MASS, /* centre of mass to wall: b = -2 ln 2 - (1 + nu)/4, what (62) to (67) need */
    COR_DISK_DATUM_DIAMETER,       /* far rim to wall: b = -1, what (54) and (55) give */
    COR_DISK_DATUM_PRINTED         /* b = -1 - nu, as (56) and (57) are printed; follows from neither */
};

/* Where the law ends: the load at which delta no longer grows, P = 4 pi exp(b - 1), its delta = 4 exp(b - 1) and its
 * V = 4 pi exp(2 b - 2); and the impact speed sqrt(8) exp(b - 1) that reaches it. Each is the largest double inside,
 * which the functions below accept. NaN: nu outside -1 < nu < 1, or no such datum, here and below. */
COR_API double cor_disk_load_limit(double nu, enum cor_disk_datum datum);
COR_API double cor_disk_compression_limit(double nu, enum cor_disk_datum datum);
COR_API double cor_disk_energy_limit(double nu, enum cor_disk_datum datum);
COR_API double cor_disk_speed_limit(double nu, enum cor_disk_datum datum);

/* The law and its inverses, (57): load P of a compression, compression delta of a load, stored energy V of a load,
 * load of an energy.
 * Domain: 0 up to the limit above. Accuracy: COR_DISK_LAW_MAX_ULP, the arguments being taken as they are; results below
 * the smallest normal double are rounded there. 0 -> 0; negative, beyond the limit or NaN -> NaN. */
COR_API double cor_disk_load(double compression, double nu, enum cor_disk_datum datum);
COR_API double cor_disk_compression(double load, double nu, enum cor_disk_datum datum);
COR_API double cor_disk_energy(double load, double nu, enum cor_disk_datum datum);
COR_API double cor_disk_load_of_energy(double energy, double nu, enum cor_disk_datum datum);

/* A quasistatic collision at an impact speed v, where (pi/2) v^2 becomes V: largest load, largest compression
 * (accuracy: COR_DISK_LAW_MAX_ULP) and contact time
 *
 *     tau = sqrt(2) int_0^(pi/2) sqrt(-w) dtheta,   w = W_-1(-(v^2/8) exp(1 - 2 b) sin^2 theta)
 *
 * (accuracy: COR_DISK_CONTACT_TIME_MAX_ERROR; Fig. 11).
 * Domain: 0 <= v <= cor_disk_speed_limit. v = 0 -> 0 and, for the time, +inf; negative, beyond, NaN -> NaN. */
COR_API double cor_disk_max_load(double speed, double nu, enum cor_disk_datum datum);
COR_API double cor_disk_max_compression(double speed, double nu, enum cor_disk_datum datum);
COR_API double cor_disk_contact_time(double speed, double nu, enum cor_disk_datum datum);

/* The same to leading logarithm, as the paper simplifies them, without nu and datum. What they leave out beside the
 * logarithm nearly cancels in (61), which for v <= 1e-2 is within 7 % of the law at nu = 0.33, but not in (59), which
 * misses it by up to 35 % between delta = 0.001 and 0.2.
 *     compression  (P/pi) ln(4 pi/P)                    0 <= P <= 4 pi/e        (58)
 *     load         pi delta/ln(4/delta)                 0 <= delta < 4          (59)
 *     energy       (pi/2) delta^2/ln(4/delta)           0 <= delta < 4          (60)
 *     max_compression  v sqrt(ln(4/v))                  0 <= v <= 4             (61)
 *     contact_time     pi sqrt(ln(4/v))                 0 <= v <= 4             (61), pi in place of its "proportional"
 * Accuracy: COR_DISK_LAW_MAX_ULP. 0 -> 0, contact_time +inf; outside and NaN -> NaN. */
COR_API double cor_disk_compression_leading_log(double load);
COR_API double cor_disk_load_leading_log(double compression);
COR_API double cor_disk_energy_leading_log(double compression);
COR_API double cor_disk_max_compression_leading_log(double speed);
COR_API double cor_disk_contact_time_leading_log(double speed);

/* ---- Rayleigh's energy ---- */

/* Energy left in the modes by a collision at the impact speed v, as a fraction of (pi/2) v^2, to first order
 * (Rayleigh): the quasistatic load drives each mode at the point of contact, (65) to (68), which is one integral a
 * mode,
 *
 *     fraction of a mode = C^2 (2 I(omega))^2,     I(omega) = int_0^(pi/2) sin(theta) cos(omega s(theta)) dtheta,
 *     s(theta) = int_theta^(pi/2) sqrt(-w/2) dtheta',     w as in the contact time above
 *
 * First order leaves out that the vibrations push back on the contact. At nu = 0.33 the energy that all modes keep
 * (cor_disk_hard_wall) is 3.3 times this at v = 1e-2, 0.75 times at 1e-3, 0.59 times at 1e-4, and still differs by a
 * tenth at 1e-30: docs/rigid-wall.md. */
struct cor_disk_rayleigh {
    double fraction; /* sum over the modes taken */
    double tail;     /* what all higher modes together add */
    double
        error_estimate; /* of fraction + tail, absolute, typically 20 times the error; of the sums, not of the theory */
    double contact_time; /* cor_disk_contact_time */
};

/* Takes the lowest n_modes of *modes, 1 <= n_modes <= modes->count. mode_fraction is NULL, or gets the n_modes
 * fractions. The tail has the modes n_modes + 1 to 1800 one by one, as far as the table goes, so that sum plus tail is
 * as good from few modes as from 1800, and takes as long; a table cut to n_modes gives what these modes alone tell.
 * 0 <= v <= cor_disk_speed_limit(modes->nu, datum); v = 0 is its limit: no energy in any mode, infinite contact time.
 * Accuracy: COR_DISK_RAYLEIGH_MAX_ERROR, _MAX_ABSOLUTE for each mode, COR_DISK_RAYLEIGH_TAIL_MAX_ERROR and
 * _TAIL_MAX_ERROR_ANY_SPEED for sum plus tail.
 * COR_OK, or with every number given nevertheless
 *     COR_BEYOND_THEORY  v > COR_DISK_RAYLEIGH_MAX_SPEED, or fraction + tail > 1, which perturbation theory cannot have
 * or without touching anything
 *     COR_ERROR_NULL, COR_ERROR_MODES (no such number of modes; omega does not grow, or begins below 1.17, which no
 *     disk has), COR_ERROR_DATUM, COR_ERROR_DISK_POISSON_RATIO, COR_ERROR_SPEED. */
COR_API int cor_disk_rayleigh(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum,
                              double speed, struct cor_disk_rayleigh *out, double *mode_fraction);

/* The same at n speeds of one table: out[i] at speed[i], and mode_fraction[i n_modes + k] if mode_fraction is not NULL.
 * Many speeds share most of the work. Where at least 28 of them have 2 ln(limit/v) between two powers of 4, what varies
 * slowly with v is interpolated. Results differ from those of cor_disk_rayleigh by less than its bounds, and from list
 * to list by less than 1e-12. status is NULL, or gets the status of each speed; out[i] of a speed out of range is NaN.
 * n may be 0, speed and out then NULL. Allocates its workspace, once, and frees it; threads are left to the caller.
 * COR_OK, the first status of a speed that is not, or without touching anything
 *     COR_ERROR_NULL, COR_ERROR_MODES, COR_ERROR_DATUM, COR_ERROR_DISK_POISSON_RATIO as above, COR_ERROR_MEMORY. */
COR_API int cor_disk_rayleigh_array(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum,
                                    const double *speed, size_t n, struct cor_disk_rayleigh *out, double *mode_fraction,
                                    int *status);

/* The same with as few modes as bring error_estimate below tolerance (fraction + tail), 0 < tolerance < 1; *n_modes, if
 * n_modes is not NULL, becomes their number; the tail is computed from these modes alone. Statuses as above,
 * COR_ERROR_TOLERANCE for a tolerance that is none, and
 *     COR_TOLERANCE_NOT_REACHED  the table has too few modes: the best that all of them give */
COR_API int cor_disk_rayleigh_tolerance(const struct cor_disk_modes *modes, enum cor_disk_datum datum, double speed,
                                        double tolerance, struct cor_disk_rayleigh *out, size_t *n_modes);

/* ---- full dynamics ---- */

/* A collision of the disk of n_modes modes with a wall of potential exp(alpha x)/alpha, (41) to (45): head on, with no
 * mode excited before. x(phi) = x_0 + cos(phi) + sum Q (C cos(n phi) cos(phi) - S sin(n phi) sin(phi)) is how far the
 * rim reaches into the wall at the angle phi, (40), x_0 the position of the centre of mass; the wall pushes with
 * exp(alpha x) on a unit of the rim. Time 0 is when the rim of a disk that keeps its shape and speed would be at x = 0.
 * */

/* Speeds above this one take the disk out of linear elasticity by far. */
#define COR_DISK_COLLISION_MAX_SPEED 0.5
/* Softer walls than the first would still push where (41) cuts the rim off, at phi = pi/2. */
#define COR_DISK_COLLISION_MIN_ALPHA 40
#define COR_DISK_COLLISION_MAX_ALPHA 1e5
#define COR_DISK_COLLISION_MIN_TOLERANCE 1e-13
#define COR_DISK_COLLISION_MAX_PHI_POINTS 16384
/* Steps of one run, at most: a contact that lasts longer has not ended. */
#define COR_DISK_COLLISION_MAX_STEPS 1000000

struct cor_disk_collision_options {
    double alpha;      /* hardness of the wall, in 1/R, COR_DISK_COLLISION_MIN_ALPHA to _MAX_ALPHA */
    double tolerance;  /* absolute error allowed in eps, from COR_DISK_COLLISION_MIN_TOLERANCE to below 1 */
    size_t phi_points; /* angles between 0 and pi/2 for the wall's force; 0: as many as the tolerance needs */
    size_t
        max_steps; /* of all runs together; 0: a number of operations, the same on every machine, that takes 5 to 10 s
                          on a processor of 2.6 GHz */
};

struct cor_disk_collision {
    double eps;             /* speed after over speed before */
    double one_minus_eps2;  /* energy left in the modes, as a fraction of (pi/2) v^2; good where eps is nearly 1 */
    double contact_time;    /* from the first to the last moment with a load of a thousandth of the largest one */
    double max_compression; /* largest x_0 + 1 */
    double energy_drift;    /* energy after less energy before, relative to (pi/2) v^2 */
    size_t steps;           /* of the integration that gave these numbers */
    double error_estimate;  /* absolute error of eps; 1 after a single run, whose error nothing shows */
};

/* 0 < v <= COR_DISK_COLLISION_MAX_SPEED, 1 <= n_modes <= modes->count. Allocates its workspace, once, and frees it.
 * Several runs with smaller and smaller steps are extrapolated, docs/derivation.md, 15.
 *
 * Accuracy. error_estimate adds up what is left of the extrapolation, the quadrature over the rim, and round-off and the
 * wall's force before and after the contact times the amplification of errors, which is bounded from the runs or measured
 * by a run with v changed by 2^-40. Sampled: in 10^4 random scenes (1 to 60 modes of nu = 0.33 and 0.9, alpha 200 to
 * 8000, v 0.003 to 0.3, tolerances 1e-3 to 1e-11) the error never exceeds the tolerance where the status is COR_OK, and
 * exceeds error_estimate in less than 1 of 200, by a factor below 3. Near chaos round-off alone may exceed a small
 * tolerance, and below 1e-12 it does mostly.
 * one_minus_eps2 is as good as eps; contact_time and max_compression, taken in the midst of the contact, are not.
 * energy_drift is eps^2 + one_minus_eps2 - 1. The same arguments give the same bits, on every instruction set.
 *
 * COR_OK: error_estimate is at most the tolerance. Or with the best numbers and their error_estimate
 *     COR_TOLERANCE_NOT_REACHED  a chaotic collision, too few phi_points, or no budget left; all NaN where no step was
 *                                small enough
 * or with NaN for what is not known
 *     COR_WALL_NOT_TOUCHED       v <= 0: the disk does not come
 *     COR_CONTACT_NOT_ENDED      the first run takes more than COR_DISK_COLLISION_MAX_STEPS steps or more than the budget:
 *                                a very slow disk, a very hard or soft wall, or a disk that leaves its vibrations all its
 *                                energy
 * or without touching anything
 *     COR_ERROR_NULL, COR_ERROR_MODES (no such number of modes; omega does not grow; a number that is none),
 *     COR_ERROR_DISK_POISSON_RATIO, COR_ERROR_SPEED (too high or NaN), COR_ERROR_TOLERANCE, COR_ERROR_ALPHA,
 *     COR_ERROR_PHI_POINTS, COR_ERROR_MEMORY. */
COR_API int cor_disk_collision(const struct cor_disk_modes *modes, size_t n_modes,
                               const struct cor_disk_collision_options *options, double speed,
                               struct cor_disk_collision *out);

/* A moment of a collision */
struct cor_disk_moment {
    double time;
    double position;    /* x_0; the compression is x_0 + 1 */
    double velocity;    /* of the centre of mass, positive towards the wall */
    double load;        /* force of the wall, int exp(alpha x) dphi */
    double wall_energy; /* load/alpha, the energy in the wall */
};

/* Further results. Every pointer may be NULL; arrays have n_modes elements in the order of the table. */
struct cor_disk_collision_detail {
    double *energy_after;   /* energy left in each mode, as a fraction of (pi/2) v^2 */
    double *energy_average; /* its mean over the contact time, likewise; NaN where the budget ended before three runs */
    /* Called at every step of the last run, which is repeated for it, from before the contact until after it; q and q_dot
     * then hold the amplitudes Q and dQ/dt. */
    void (*observe)(void *context, const struct cor_disk_moment *moment);
    void *context;
    double *q, *q_dot;
};

/* The same with a workspace of the caller, for many collisions, and with detail, which may be NULL. The first function
 * returns the bytes that the second one needs, at any address: more for harder walls, more modes and smaller tolerances,
 * and 0 if an argument is not allowed. */
COR_API size_t cor_disk_collision_workspace(const struct cor_disk_modes *modes, size_t n_modes,
                                            const struct cor_disk_collision_options *options);
/* Statuses as above, COR_ERROR_WORKSPACE for a workspace that is too small; allocates nothing. */
COR_API int cor_disk_collision_in(void *workspace, size_t bytes, const struct cor_disk_modes *modes, size_t n_modes,
                                  const struct cor_disk_collision_options *options, double speed,
                                  struct cor_disk_collision *out, const struct cor_disk_collision_detail *detail);

/* ---- the hard wall ---- */

/* A collision of the disk of all its modes with a rigid wall: the limit of cor_disk_collision for alpha -> infinity and
 * n_modes -> infinity, computed directly. docs/derivation.md, 17.
 *
 * Modes below a frequency Omega move, under a weight that fades smoothly to 0 at Omega; all that is left of the static
 * compliance, which is known for all modes, acts at once; the wall is rigid. L = 1 - eps^2 then tends to its limit like
 * Omega^-2, and a ladder of levels Omega, each sqrt(2) times the one before, is extrapolated. Below
 * COR_DISK_HARD_WALL_POINT_SPEED the contact is a point with one equation for the load, which allows any speed. */
#define COR_DISK_HARD_WALL_MAX_SPEED 0.5
#define COR_DISK_HARD_WALL_POINT_SPEED 1e-7
#define COR_DISK_HARD_WALL_MIN_TOLERANCE 1e-7
/* Level k = 0, 1, ... has Omega = COR_DISK_HARD_WALL_FIRST_OMEGA 2^(k/2), which is 15 to 960. */
#define COR_DISK_HARD_WALL_FIRST_OMEGA 15.0
#define COR_DISK_HARD_WALL_MAX_LEVELS 13

struct cor_disk_hard_wall_options {
    double tolerance; /* absolute error allowed in 1 - eps^2, from COR_DISK_HARD_WALL_MIN_TOLERANCE to below 1 */
};

struct cor_disk_hard_wall {
    double one_minus_eps2;  /* energy left in the modes, as a fraction of (pi/2) v^2 */
    double eps;             /* speed after over speed before */
    double contact_time;    /* from the first to the last touch, at the highest level */
    double max_compression; /* largest x_0 + 1 */
    double error_estimate;  /* of one_minus_eps2, absolute */
    size_t omega_levels;    /* levels of Omega that were computed */
};

/* Takes levels until error_estimate is below the tolerance, as far as the lowest n_modes modes go: all modes below the
 * Omega of a level must be among them, and cor_disk_modes_below tells how many these are. Two levels are the least, and
 * 1800 modes suffice for five (Omega = 60), which is good to 1e-4 or so.
 * 0 < v <= COR_DISK_HARD_WALL_MAX_SPEED, however small. Allocates its workspace, once, and frees it. The same arguments
 * give the same bits, on every instruction set.
 * COR_OK, or with the best numbers given nevertheless
 *     COR_TOLERANCE_NOT_REACHED  the modes end before error_estimate is below the tolerance
 * or with NaN for what is not known
 *     COR_WALL_NOT_TOUCHED       v <= 0: the disk does not come
 *     COR_CONTACT_NOT_ENDED      a disk that leaves its vibrations nearly all its energy
 *     COR_ERROR_MODES            the modes leave a compliance that no disk has: numbers in the table are wrong
 * or without touching anything
 *     COR_ERROR_NULL, COR_ERROR_MODES (no such number of modes; omega does not grow; a number that is none; too few for
 *     two levels), COR_ERROR_DISK_POISSON_RATIO, COR_ERROR_SPEED (too high or NaN), COR_ERROR_TOLERANCE,
 *     COR_ERROR_MEMORY. */
COR_API int cor_disk_hard_wall(const struct cor_disk_modes *modes, size_t n_modes,
                               const struct cor_disk_hard_wall_options *options, double speed,
                               struct cor_disk_hard_wall *out);

/* The same for any nu, -1 < nu < 1, without a table: computes as many modes as the tolerance needs, by
 * cor_disk_modes_compute, up to COR_DISK_HARD_WALL_MAX_LEVELS. For many speeds a table is faster. */
COR_API int cor_disk_hard_wall_nu(double nu, const struct cor_disk_hard_wall_options *options, double speed,
                                  struct cor_disk_hard_wall *out);

/* A moment of a collision with a rigid wall */
struct cor_disk_hard_wall_moment {
    double time;          /* from the first touch */
    double position;      /* x_0; the compression is x_0 + 1 */
    double velocity;      /* of the centre of mass, positive towards the wall */
    double load;          /* force of the wall */
    double contact_angle; /* largest angle in contact; 0 in a point contact too */
};

/* What else a collision can tell, all of the highest level. Every pointer may be NULL; arrays have n_modes elements in
 * the order of the table, 0 for modes above Omega. */
struct cor_disk_hard_wall_detail {
    double *energy_after;   /* energy left in each mode, as a fraction of (pi/2) v^2 */
    double *energy_average; /* its mean over the contact time, likewise */
    /* Told of every step, from the first touch till after the last; q and q_dot then hold the amplitudes Q and dQ/dt.
     * */
    void (*observe)(void *context, const struct cor_disk_hard_wall_moment *moment);
    void *context;
    double *q, *q_dot;
};

/* The same with a workspace of the caller's, and with detail, which may be NULL. Bytes needed at these arguments,
 * anywhere in memory; 0 if an argument is not allowed. */
COR_API size_t cor_disk_hard_wall_workspace(const struct cor_disk_modes *modes, size_t n_modes,
                                            const struct cor_disk_hard_wall_options *options, double speed);
/* Statuses as above, COR_ERROR_WORKSPACE for one that is too small; allocates nothing. */
COR_API int cor_disk_hard_wall_in(void *workspace, size_t bytes, const struct cor_disk_modes *modes, size_t n_modes,
                                  const struct cor_disk_hard_wall_options *options, double speed,
                                  struct cor_disk_hard_wall *out, const struct cor_disk_hard_wall_detail *detail);

/* ---- its limits ---- */

/* Restitution of a disk of all its modes at a rigid wall, as cor_disk_hard_wall computes it, from a table of
 * collisions, generated/disk_limits.h, between which polynomials of degree 3 in v^(1/8) and nu interpolate. Fractions
 * of a microsecond.
 *     one_minus_eps2               energy left in the modes, as a fraction of (pi/2) v^2
 *     one_minus_eps2_uncertainty   from 1.5 times what the polynomial misses at most at places between those of the
 *                                  table around, and from the estimate of the errors of the collisions: an estimate, no
 *                                  bound, but not exceeded at 1000 random places off the grid
 *                                  (tests/unit/test_disk_eps.c). At most COR_DISK_EPS_MAX_UNCERTAINTY for
 *                                  v <= COR_DISK_EPS_CALM_SPEED, and COR_DISK_EPS_MAX_UNCERTAINTY_FAST beyond
 *     eps, eps_uncertainty         the same for eps
 * Between cells of the table the functions jump by no more than the uncertainty.
 * Domain: the speeds and Poisson's ratios below, ends included; elsewhere, and for NaN, the result is NaN. Beyond nu =
 * COR_DISK_EPS_MAX_NU, 1 - eps^2 has so many kinks that no table of this size is good there. At other speeds and nu,
 * and for smaller errors: cor_disk_hard_wall_nu. Softer walls: cor_disk_collision. */
#define COR_DISK_EPS_MIN_SPEED 1e-5
#define COR_DISK_EPS_MAX_SPEED 0.3
#define COR_DISK_EPS_CALM_SPEED 0.15
#define COR_DISK_EPS_MIN_NU (-0.2)
#define COR_DISK_EPS_MAX_NU 0.4875
#define COR_DISK_EPS_MAX_UNCERTAINTY 1.4e-4
#define COR_DISK_EPS_MAX_UNCERTAINTY_FAST 1e-4
COR_API double cor_disk_eps(double speed, double nu);
COR_API double cor_disk_eps_uncertainty(double speed, double nu);
COR_API double cor_disk_one_minus_eps2(double speed, double nu);
COR_API double cor_disk_one_minus_eps2_uncertainty(double speed, double nu);

#ifdef __cplusplus
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
}
#endif

#endif
