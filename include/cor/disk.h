/* SPDX-License-Identifier: MIT */
/* Elastic disks: free modes, quasistatic contact law, the energy that a slow collision leaves in the modes, and full
 * dynamics.
 *
 * A disk of radius R, Young's modulus E and mass per area rho meets a hard wall head on. By symmetry, two equal disks
 * that meet with twice the speed behave in the same way. All quantities are in units E = rho = R = 1: speeds in
 * sqrt(E/rho), times in R sqrt(rho/E), loads in E R, energies in E R^2, compressions in R. The mass of the disk is pi.
 * nu is Poisson's ratio in plane stress, -1 < nu < 1. For plane strain, replace the three-dimensional E and nu by E/(1
 * - nu^2) and nu/(1 - nu), (2).
 *
 * The model: the wall has no friction. The depth of the rim is evaluated at the original angle of the material, not at
 * its displaced angle. Elasticity is linear. At v = 0.3 compressions reach a third of the radius, far outside the
 * linear range. Digits of eps beyond 1e-3 then describe the model, not a disk.
 *
 *     one rigid collision from a table    cor_disk_eps, cor_disk_one_minus_eps2, each with _uncertainty
 *     collisions with a rigid wall        cor_disk_hard_wall, cor_disk_hard_wall_nu, _in, _workspace
 *     collisions with a soft wall         cor_disk_collision, cor_disk_collision_array, _in, _workspace
 *     Rayleigh's energy                   cor_disk_rayleigh, _array, _tolerance
 *     contact law, contact time           cor_disk_load, _compression, _energy, _load_of_energy, _max_load,
 *                                         _max_compression, _contact_time, and the limits cor_disk_load_limit, ...
 *     modes                               cor_disk_modes_nu033, _nu090, _read, _compute, _below
 *
 * cor.h describes threads, memory and the floating-point environment. A callback runs in the environment of the caller.
 * The numbers of a mode must be below 1e9; larger numbers give COR_ERROR_MODES. Six functions allocate memory and free
 * it: cor_disk_modes_compute, cor_disk_rayleigh_array, cor_disk_collision, cor_disk_collision_array, cor_disk_hard_wall
 * and cor_disk_hard_wall_nu. (cor_disk_modes_read opens a file, for which the C library may allocate a buffer.)
 *
 * Equation numbers (n) refer to Gerl and Zippelius, Phys. Rev. E 59, 2361 (1999); docs/theory-disks.md, 11 to 17,
 * derives them again, and docs/errata.md lists where the print is wrong. */
#ifndef COR_DISK_H
#define COR_DISK_H

#include <stddef.h>

#include "export.h"

#ifdef __cplusplus
extern "C" {
#if defined(__GNUC__)
/* A function and a struct may share a name, but g++ -Wshadow warns. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#endif
#endif

/* Bounds on the error of the functions below. COR_DISK_LAW_MAX_ULP is proved (tests/proof/run; docs/theory.md, 18) if
 * log and log1p of the C library are within 1 ulp. The proof excludes arguments that are within one part in 2^92 of the
 * limit of the law, which exist for about one nu in 2^39; there the bound is sampled. The other bounds are sampled. The
 * tests assert all of them; docs/accuracy.md records the worst cases found. Each bound holds for every nu and datum in
 * the whole domain unless it states otherwise. */
#define COR_DISK_LAW_MAX_ULP 4.0              /* contact law, largest compression and load, limits: ulp */
#define COR_DISK_CONTACT_TIME_MAX_ERROR 1e-15 /* relative */
#define COR_DISK_RAYLEIGH_MAX_ERROR 1e-10     /* relative error of the fraction of one mode */
#define COR_DISK_RAYLEIGH_MAX_ABSOLUTE 1e-14  /* near a zero of (68): error relative to the sum of all modes */
/* Bounds on the relative error of fraction + tail of cor_disk_rayleigh, for any number of modes of the two tables
 * below. The first holds for v >= 1e-9, the second for all v. For tables of 1800 modes of other nu the first bound is
 * 1e-5, too; the worst case found, at nu = 0.2, reaches 1.0e-5 (docs/accuracy.md). */
#define COR_DISK_RAYLEIGH_TAIL_MAX_ERROR 1e-5
#define COR_DISK_RAYLEIGH_TAIL_MAX_ERROR_ANY_SPEED 4e-5
/* Beyond this speed a collision is too violent for perturbation theory, and cor_disk_rayleigh returns
 * COR_BEYOND_THEORY. */
#define COR_DISK_RAYLEIGH_MAX_SPEED 0.03

/* Bound on the stack of every function, in bytes, for any number of modes and speeds. Measured in an optimised build,
 * libm included: cor_disk_rayleigh and its variants use 60 kB, the others less than half of it. */
#define COR_DISK_MAX_STACK 65536

/* ---- free modes ---- */

/* One free vibration of the disk: displacements u_r(r) cos(n phi), u_phi(r) sin(n phi), frequency omega; l = 0, 1, ...
 * counts the modes of one n upwards. c = u_r(1) and s = u_phi(1), (28), normalised by (26); the overall sign makes
 * c > 0. The table omits the torsional modes of n = 0, which have c = s = 0, and the translation n = 1, omega = 0. */
struct cor_disk_mode {
    int n, l;
    double omega, c, s;
};

/* Largest n of a mode that any function accepts, in a table or a file: the memory of a collision grows with n^2. The
 * 10^6 lowest modes of a disk, COR_DISK_MODES_MAX_COUNT, have n below 3900 where nu is -0.7 or more. For nu closer to
 * -1 a table may have larger n, which collisions reject. */
#define COR_DISK_MODES_MAX_N 4095

/* The lowest `count` modes of a disk, by increasing omega, without gaps. mode has count elements. */
struct cor_disk_modes {
    double nu;
    size_t count;
    const struct cor_disk_mode *mode;
};

/* The 1800 lowest modes for nu = 0.33 and nu = 0.9. Every double is the one nearest to the exact value (proved). Other
 * materials: corgen tables --poisson NU --modes N writes a header to embed and a file to read. */
COR_API extern const struct cor_disk_modes cor_disk_modes_nu033;
COR_API extern const struct cor_disk_modes cor_disk_modes_nu090;

/* Reads a mode file that corgen wrote (docs/disks.md) into mode[0..capacity-1], and sets *modes, whose member `mode`
 * points to that array. On failure *modes is unchanged, except that COR_ERROR_CAPACITY sets modes->count to the number
 * of modes in the file. To query that number, pass capacity 0; mode may then be NULL. *line, if line is not NULL,
 * becomes the number of the wrong line of the file, or 0. Returns COR_OK or
 *     COR_ERROR_NULL
 *     COR_ERROR_FILE          the file cannot be read
 *     COR_ERROR_FILE_VERSION  the file is not a mode file, or has another version
 *     COR_ERROR_FILE_DAMAGED  the check of a line fails, a line ends early, a number is impossible, or n is above
 *                             COR_DISK_MODES_MAX_N
 *     COR_ERROR_CAPACITY      the file has more modes than the array */
COR_API int cor_disk_modes_read(const char *path, struct cor_disk_mode *mode, size_t capacity,
                                struct cor_disk_modes *modes, size_t *line);

/* Computes the `count` lowest modes of a disk in double arithmetic into mode[0..count-1], for any nu, and sets *modes,
 * whose member `mode` points to that array. 100,000 modes take 0.03 s; time and memory grow like their number.
 * Domain: -1 < nu < 1 and 1 <= count <= COR_DISK_MODES_MAX_COUNT.
 * Accuracy, sampled against proved tables: the relative error of omega is at most COR_DISK_MODES_OMEGA_MAX_ERROR, the
 * error of c and s at most COR_DISK_MODES_AMPLITUDE_MAX_ERROR times the length of (c, s). The function does not prove
 * that no mode is missing; `corgen tables --poisson NU --modes N` proves a table.
 * Returns COR_OK, or, with nothing changed, COR_ERROR_NULL, COR_ERROR_DISK_POISSON_RATIO, COR_ERROR_MODES (count), or
 * COR_ERROR_MEMORY. */
#define COR_DISK_MODES_MAX_COUNT 1000000
#define COR_DISK_MODES_OMEGA_MAX_ERROR 2e-14
#define COR_DISK_MODES_AMPLITUDE_MAX_ERROR 1e-10
COR_API int cor_disk_modes_compute(double nu, size_t count, struct cor_disk_mode *mode, struct cor_disk_modes *modes);

/* Returns the number of modes below omega, which is about ((1 - nu^2) + 2 (1 + nu)) omega^2/8. Domain: -1 < nu < 1,
 * 0 < omega <= COR_DISK_MODES_MAX_OMEGA; 0 outside. The number may be off by one if omega is nearly a mode's
 * frequency. */
#define COR_DISK_MODES_MAX_OMEGA 2000.0
COR_API size_t cor_disk_modes_below(double nu, double omega);

/* ---- quasistatic contact law ---- */

/* The points between which the compression delta is measured. They determine the constant b of the contact law
 *
 *     delta = (P/pi) (ln(4 pi/P) + b),     V = P^2/(2 pi) (ln(4 pi/P) + b - 1/2)                               (57) */
enum cor_disk_datum {
    COR_DISK_DATUM_CENTRE_OF_MASS, /* centre of mass to wall: b = -2 ln 2 - (1 + nu)/4, which (62) to (67) require */
    COR_DISK_DATUM_DIAMETER,       /* far rim to wall: b = -1, which (54) and (55) give */
    COR_DISK_DATUM_PRINTED         /* b = -1 - nu, as printed in (56) and (57); no such points exist */
};

/* Return the limits of the law. At the load P = 4 pi exp(b - 1), delta stops growing: delta = 4 exp(b - 1) and V = 4 pi
 * exp(2 b - 2). The impact speed sqrt(8) exp(b - 1) leads to this load. Each result is the largest double that does not
 * exceed the limit; the functions below accept it. Here and below the result is NaN if nu is outside -1 < nu < 1 or the
 * datum does not exist. */
COR_API double cor_disk_load_limit(double nu, enum cor_disk_datum datum);
COR_API double cor_disk_compression_limit(double nu, enum cor_disk_datum datum);
COR_API double cor_disk_energy_limit(double nu, enum cor_disk_datum datum);
COR_API double cor_disk_speed_limit(double nu, enum cor_disk_datum datum);

/* Evaluate the law and its inverses, (57): load P of a compression, compression delta of a load, stored energy V of a
 * load, load of an energy.
 * Domain: 0 up to the limit above. Accuracy: COR_DISK_LAW_MAX_ULP (proved), with the arguments treated as exact.
 * Results below the smallest normal double are rounded to subnormal numbers. 0 -> 0; negative, beyond the limit or
 * NaN -> NaN.
 * Array functions, here and below, give the same numbers as the function of one number. load and compression may be the
 * same array. */
COR_API double cor_disk_load(double compression, double nu, enum cor_disk_datum datum);
COR_API void cor_disk_load_array(const double *compression, double nu, enum cor_disk_datum datum, double *load,
                                 size_t n);
COR_API double cor_disk_compression(double load, double nu, enum cor_disk_datum datum);
COR_API double cor_disk_energy(double load, double nu, enum cor_disk_datum datum);
COR_API double cor_disk_load_of_energy(double energy, double nu, enum cor_disk_datum datum);

/* Return the largest load, the largest compression (accuracy: COR_DISK_LAW_MAX_ULP, proved) and the contact time of a
 * quasistatic collision at impact speed v. The energy (pi/2) v^2 becomes V. The contact time is
 *
 *     tau = sqrt(2) int_0^(pi/2) sqrt(-w) dtheta,   w = W_-1(-(v^2/8) exp(1 - 2 b) sin^2 theta)
 *
 * (accuracy: COR_DISK_CONTACT_TIME_MAX_ERROR; Fig. 11).
 * Domain: 0 <= v <= cor_disk_speed_limit. v = 0 -> 0 and, for the time, +inf; negative, beyond, NaN -> NaN. */
COR_API double cor_disk_max_load(double speed, double nu, enum cor_disk_datum datum);
COR_API double cor_disk_max_compression(double speed, double nu, enum cor_disk_datum datum);
COR_API double cor_disk_contact_time(double speed, double nu, enum cor_disk_datum datum);
COR_API void cor_disk_contact_time_array(const double *speed, double nu, enum cor_disk_datum datum, double *time,
                                         size_t n);

/* Approximate the functions above to leading logarithm, as in the paper, without nu and datum. At nu = 0.33 the
 * neglected constants nearly cancel in (61), which is within 7 % of the law for v <= 1e-2. They do not cancel in (59),
 * which is off by up to 35 % between delta = 0.001 and 0.2.
 *     compression  (P/pi) ln(4 pi/P)                    0 <= P <= 4 pi/e        (58)
 *     load         pi delta/ln(4/delta)                 0 <= delta < 4          (59)
 *     energy       (pi/2) delta^2/ln(4/delta)           0 <= delta < 4          (60)
 *     max_compression  v sqrt(ln(4/v))                  0 <= v <= 4             (61)
 *     contact_time     pi sqrt(ln(4/v))                 0 <= v <= 4             (61), which omits the factor pi
 * Accuracy: COR_DISK_LAW_MAX_ULP (proved). 0 -> 0, contact_time +inf; outside and NaN -> NaN. */
COR_API double cor_disk_compression_leading_log(double load);
COR_API double cor_disk_load_leading_log(double compression);
COR_API double cor_disk_energy_leading_log(double compression);
COR_API double cor_disk_max_compression_leading_log(double speed);
COR_API double cor_disk_contact_time_leading_log(double speed);

/* ---- Rayleigh's energy ---- */

/* Energy that a collision at impact speed v leaves in the modes, as a fraction of (pi/2) v^2, to first order
 * (Rayleigh). The quasistatic load drives each mode at the point of contact, (65) to (68). Each mode needs one
 * integral,
 *
 *     fraction of a mode = C^2 (2 I(omega))^2,     I(omega) = int_0^(pi/2) sin(theta) cos(omega s(theta)) dtheta,
 *     s(theta) = int_theta^(pi/2) sqrt(-w/2) dtheta',     w as in the contact time above
 *
 * First order neglects the force of the vibrations on the contact. At nu = 0.33 the energy that all modes keep
 * (cor_disk_hard_wall) is 3.3, 0.75 and 0.59 times this energy at v = 1e-2, 1e-3 and 1e-4. At v = 1e-30 the two
 * energies still differ by a tenth (docs/disks.md). */
struct cor_disk_rayleigh {
    double fraction;       /* sum over the n_modes modes */
    double tail;           /* sum over all higher modes */
    double error_estimate; /* estimated numerical error of fraction + tail; typically 20 times the true one */
    double contact_time;   /* as from cor_disk_contact_time; the last place may differ */
};

/* Sums the lowest n_modes of *modes, 1 <= n_modes <= modes->count. mode_fraction is NULL, or receives the n_modes
 * fractions. For the tail, the function also sums modes n_modes + 1 to 1800 of the table one by one. Accuracy and cost
 * are therefore the same as for n_modes = 1800. To use only n_modes modes, pass a table cut to them.
 * Domain: 0 <= v <= cor_disk_speed_limit(modes->nu, datum). At v = 0 no mode has energy and the contact time is
 * infinite.
 * Accuracy: COR_DISK_RAYLEIGH_MAX_ERROR or _MAX_ABSOLUTE for each mode; COR_DISK_RAYLEIGH_TAIL_MAX_ERROR and
 * _TAIL_MAX_ERROR_ANY_SPEED for sum plus tail.
 * Returns COR_OK, or, with every number set,
 *     COR_BEYOND_THEORY  v > COR_DISK_RAYLEIGH_MAX_SPEED, or fraction + tail > 1, which perturbation theory excludes
 * or, with nothing changed,
 *     COR_ERROR_MODES    the table has fewer than n_modes modes; omega does not grow; omega begins below 1.17, lower
 *                        than in any disk; or an n is not from 0 to COR_DISK_MODES_MAX_N
 *     COR_ERROR_NULL, COR_ERROR_DATUM, COR_ERROR_DISK_POISSON_RATIO, COR_ERROR_SPEED */
COR_API int cor_disk_rayleigh(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum,
                              double speed, struct cor_disk_rayleigh *out, double *mode_fraction);

/* Does the same at n speeds with one table: out[i] belongs to speed[i]. mode_fraction is NULL, or mode_fraction[i
 * n_modes + k] receives the fraction of mode k at speed[i]. The speeds share most of the work. If at least 28 speeds
 * have 2 ln(limit/v) between the same two powers of 4, the function interpolates the terms that vary slowly with v. Its
 * results are within the bounds of cor_disk_rayleigh. The other speeds of the list change the result at a speed by less
 * than 1e-12. status is NULL, or receives the status of each speed. out[i] is NaN if the speed is out of range.
 * If n is 0, speed and out may be NULL. Callers may divide the speeds among threads.
 * Returns COR_OK, the first status of a speed that is not COR_OK, or, with nothing changed,
 *     COR_ERROR_NULL, COR_ERROR_MODES, COR_ERROR_DATUM, COR_ERROR_DISK_POISSON_RATIO as above, COR_ERROR_MEMORY */
COR_API int cor_disk_rayleigh_array(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum,
                                    const double *speed, size_t n, struct cor_disk_rayleigh *out, double *mode_fraction,
                                    int *status);

/* Sums the lowest modes until error_estimate is below tolerance times (fraction + tail). 0 < tolerance < 1. *n_modes,
 * if n_modes is not NULL, becomes the number of summed modes. The tail is computed from only these modes. Returns a
 * status as above, COR_ERROR_TOLERANCE for a tolerance outside its range, or
 *     COR_TOLERANCE_NOT_REACHED  the table has too few modes; the results use all of them */
COR_API int cor_disk_rayleigh_tolerance(const struct cor_disk_modes *modes, enum cor_disk_datum datum, double speed,
                                        double tolerance, struct cor_disk_rayleigh *out, size_t *n_modes);

/* ---- full dynamics ---- */

/* A head-on collision of a disk of n_modes modes with a wall of potential exp(alpha x)/alpha, (41) to (45). Before the
 * collision all amplitudes Q are 0. x(phi) = x_0 + cos(phi) + sum Q (C cos(n phi) cos(phi) - S sin(n phi) sin(phi)) is
 * the depth of the rim in the wall at the angle phi, (40). x_0 is the position of the centre of mass. The wall pushes
 * with the force exp(alpha x) per unit length of the rim. At time 0 a disk that kept its shape and speed would touch x
 * = 0. */

/* Above this speed the disk is far outside linear elasticity. */
#define COR_DISK_COLLISION_MAX_SPEED 0.5
/* A softer wall would still push at phi = pi/2, where (41) cuts off the rim. */
#define COR_DISK_COLLISION_MIN_ALPHA 40
#define COR_DISK_COLLISION_MAX_ALPHA 1e5
#define COR_DISK_COLLISION_MIN_TOLERANCE 1e-13
#define COR_DISK_COLLISION_MAX_PHI_POINTS 16384
/* Bound on a workspace in bytes, for n up to COR_DISK_MODES_MAX_N: this number plus 200 for each mode */
#define COR_DISK_COLLISION_MAX_WORKSPACE 1.3e9
/* Largest number of steps of one run. A contact that lasts longer returns COR_CONTACT_NOT_ENDED. */
#define COR_DISK_COLLISION_MAX_STEPS 1000000

struct cor_disk_collision_options {
    double alpha;      /* hardness of the wall, in 1/R, COR_DISK_COLLISION_MIN_ALPHA to _MAX_ALPHA */
    double tolerance;  /* absolute error allowed in eps, from COR_DISK_COLLISION_MIN_TOLERANCE to below 1 */
    size_t phi_points; /* angles between 0 and pi/2 at which the wall's force is computed; 0: as the tolerance needs */
    /* budget of steps for all runs together; 0: a fixed number of operations, which take 5 to 10 s at 2.6 GHz */
    size_t max_steps;
};

struct cor_disk_collision {
    double eps;             /* speed after/speed before */
    double one_minus_eps2;  /* energy left in the modes, as a fraction of (pi/2) v^2; accurate near eps = 1, too */
    double contact_time;    /* from the first to the last moment at which the load is 1/1000 of its largest value */
    double max_compression; /* largest x_0 + 1 */
    double energy_drift;    /* energy after minus energy before, relative to (pi/2) v^2 */
    size_t steps;           /* number of steps in the run that gave these results */
    double error_estimate;  /* estimated absolute error of eps; 1 after a single run, which gives no estimate */
};

/* Computes one collision. Domain: 0 < v <= COR_DISK_COLLISION_MAX_SPEED, 1 <= n_modes <= modes->count. The function
 * extrapolates several runs with smaller and smaller steps (docs/theory-disks.md, 15).
 *
 * error_estimate is the sum of four parts: the remainder of the extrapolation, the quadrature over the rim, round-off,
 * and the wall's force before and after the contact. The last three are multiplied by a factor for the amplification of
 * errors by the collision. The amplification is estimated from the runs, or measured by a run with v changed by a
 * relative 2^-40. If the error of the quadrature may exceed a tenth of the tolerance, another run measures the effect
 * of this error on eps. Its angles are shifted by half the distance of neighbours. Accuracy is sampled in 8640 random
 * scenes of 1 to 60 modes of nu = 0.33 and 0.9 (alpha 200 to 8000, v 0.003 to 0.3, tolerances 1e-3 to 1e-11). Another
 * 8640 scenes have 10 to 1800 modes (alpha 100 to 8000, v 0.003 to 0.45, tolerances 1e-2 to 1e-6). Where the status is
 * COR_OK the error is at most 0.86 of the tolerance. In 6 scenes the error exceeds error_estimate, by a factor of at
 * most 3.7: docs/theory-disks.md, 15. Near chaos, round-off may prevent small tolerances; it usually prevents
 * tolerances below 1e-12. one_minus_eps2 is as accurate as eps. contact_time and max_compression are less accurate.
 * energy_drift is eps^2 + one_minus_eps2 - 1. Equal arguments give equal bits on every instruction set.
 *
 * Returns COR_OK if error_estimate is at most the tolerance. It returns, with the best numbers and their
 * error_estimate,
 *     COR_TOLERANCE_NOT_REACHED  a chaotic collision, too few phi_points, or an exhausted budget; all results are NaN
 *                                if no step was small enough
 * or, with NaN for unknown results,
 *     COR_WALL_NOT_TOUCHED       v <= 0: the disk does not reach the wall
 *     COR_CONTACT_NOT_ENDED      the first run takes more than COR_DISK_COLLISION_MAX_STEPS steps or more than the
 *                                budget: a very slow disk, a very hard or soft wall, or a disk whose vibrations take
 *                                all its energy
 * or, with nothing changed,
 *     COR_ERROR_MODES            the table has fewer than n_modes modes, omega does not grow, an entry is not a number,
 *                                or an n is not from 0 to COR_DISK_MODES_MAX_N
 *     COR_ERROR_SPEED            the speed is too high or NaN
 *     COR_ERROR_NULL, COR_ERROR_DISK_POISSON_RATIO, COR_ERROR_TOLERANCE, COR_ERROR_ALPHA, COR_ERROR_PHI_POINTS,
 *     COR_ERROR_MEMORY */
COR_API int cor_disk_collision(const struct cor_disk_modes *modes, size_t n_modes,
                               const struct cor_disk_collision_options *options, double speed,
                               struct cor_disk_collision *out);

/* Does the same at n speeds with one table, wall and tolerance: out[i] has the bits of cor_disk_collision at speed[i].
 * The speeds share the workspace and all data that depend only on the modes. Speeds with equal numbers of angles share
 * the tables of angles. status is NULL, or receives the status of each speed. The numbers of out[i] are NaN, and steps
 * is 0, if the speed is too high or NaN. If n is 0, speed and out may be NULL. max_steps is the budget of each speed.
 * Callers may divide the speeds among threads.
 * Returns COR_OK, the first status of a speed that is not COR_OK, or, with nothing changed,
 *     COR_ERROR_NULL, COR_ERROR_DISK_POISSON_RATIO, COR_ERROR_MODES, COR_ERROR_TOLERANCE, COR_ERROR_ALPHA,
 *     COR_ERROR_PHI_POINTS as above, COR_ERROR_MEMORY */
COR_API int cor_disk_collision_array(const struct cor_disk_modes *modes, size_t n_modes,
                                     const struct cor_disk_collision_options *options, const double *speed, size_t n,
                                     struct cor_disk_collision *out, int *status);

struct cor_disk_moment {
    double time;
    double position;    /* x_0; the compression is x_0 + 1 */
    double velocity;    /* of the centre of mass, positive towards the wall */
    double load;        /* force of the wall, int exp(alpha x) dphi */
    double wall_energy; /* load/alpha, the energy in the wall */
};

/* Optional results. Every pointer may be NULL. Arrays have n_modes elements in the order of the table. */
struct cor_disk_collision_detail {
    double *energy_after;   /* energy left in each mode, as a fraction of (pi/2) v^2 */
    double *energy_average; /* mean of this energy over the contact time; NaN if the budget ended before three runs */
    /* The function repeats its last run and calls observe at every step, from before the contact until after it. q and
     * q_dot then hold the amplitudes Q and dQ/dt. */
    void (*observe)(void *context, const struct cor_disk_moment *moment);
    void *context;
    double *q, *q_dot;
};

/* cor_disk_collision_in computes the same as cor_disk_collision in a workspace of the caller, which many calls may
 * reuse, and sets *detail, which may be NULL. cor_disk_collision_workspace returns the number of bytes that suffice for
 * a workspace at any address, or 0 if an argument is outside its domain. The number grows with alpha, with n_modes and
 * with a smaller tolerance. */
COR_API size_t cor_disk_collision_workspace(const struct cor_disk_modes *modes, size_t n_modes,
                                            const struct cor_disk_collision_options *options);
/* Returns a status as above, or COR_ERROR_WORKSPACE if the workspace is too small. It allocates nothing. */
COR_API int cor_disk_collision_in(void *workspace, size_t bytes, const struct cor_disk_modes *modes, size_t n_modes,
                                  const struct cor_disk_collision_options *options, double speed,
                                  struct cor_disk_collision *out, const struct cor_disk_collision_detail *detail);

/* ---- the hard wall ---- */

/* A collision of a disk with all its modes at a rigid wall: the limit of cor_disk_collision for alpha -> infinity and
 * n_modes -> infinity, computed directly. docs/theory-disks.md, 17.
 *
 * Modes below a frequency Omega vibrate, with a weight that decreases smoothly to 0 at Omega. All other compliance
 * follows the load without inertia; it is the known static compliance of all modes less the part of the vibrating
 * modes. For Omega -> infinity, 1 - eps^2 tends to its limit like Omega^-2. The function extrapolates from a sequence
 * of Omega, called levels, each sqrt(2) times the previous one. Below COR_DISK_HARD_WALL_POINT_SPEED the contact is a
 * point with one equation for the load, however small v is. */
#define COR_DISK_HARD_WALL_MAX_SPEED 0.5
#define COR_DISK_HARD_WALL_POINT_SPEED 1e-7
#define COR_DISK_HARD_WALL_MIN_TOLERANCE 1e-7
/* Level k = 0, 1, ... has Omega = COR_DISK_HARD_WALL_FIRST_OMEGA 2^(k/2), which is 15 to 960. */
#define COR_DISK_HARD_WALL_FIRST_OMEGA 15.0
#define COR_DISK_HARD_WALL_MAX_LEVELS 13

struct cor_disk_hard_wall_options {
    double tolerance; /* allowed absolute error of 1 - eps^2, from COR_DISK_HARD_WALL_MIN_TOLERANCE to below 1 */
    size_t max_steps; /* budget of steps for all levels together; 0: a fixed number of operations */
};

struct cor_disk_hard_wall {
    double one_minus_eps2;  /* energy left in the modes, as a fraction of (pi/2) v^2 */
    double eps;             /* speed after/speed before */
    double contact_time;    /* from the first to the last touch, computed with the largest Omega */
    double max_compression; /* largest x_0 + 1 */
    double error_estimate;  /* estimated absolute error of one_minus_eps2 */
    size_t omega_levels;    /* number of computed levels of Omega */
};

/* Computes levels until error_estimate is at most the tolerance. Stops earlier if the lowest n_modes modes, or the
 * budget, do not suffice for one more level. A level needs all modes below its Omega, whose number cor_disk_modes_below
 * returns. A result needs two levels, and COR_OK needs five. 1800 modes suffice for five levels (Omega = 60), with an
 * error of about 1e-4.
 * Domain: 0 < v <= COR_DISK_HARD_WALL_MAX_SPEED. Equal arguments give equal bits on every instruction set.
 * Returns COR_OK, or, with the best numbers,
 *     COR_TOLERANCE_NOT_REACHED  the modes or the budget do not suffice for five levels and the tolerance
 * or, with NaN for unknown results,
 *     COR_WALL_NOT_TOUCHED       v <= 0: the disk does not reach the wall
 *     COR_CONTACT_NOT_ENDED      the vibrations of the disk keep nearly all its energy, or the budget does not suffice
 *                                for two levels
 *     COR_ERROR_MODES            numbers in the table are wrong: the compliance computed from them is not positive
 * or, with nothing changed,
 *     COR_ERROR_MODES            the table has fewer than n_modes modes, or n_modes is too small for two levels; omega
 *                                does not grow; an entry is not a number; or an n is not from 0 to
 *                                COR_DISK_MODES_MAX_N (for omega < 960: to 2047)
 *     COR_ERROR_SPEED            the speed is too high or NaN
 *     COR_ERROR_NULL, COR_ERROR_DISK_POISSON_RATIO, COR_ERROR_TOLERANCE, COR_ERROR_MEMORY */
COR_API int cor_disk_hard_wall(const struct cor_disk_modes *modes, size_t n_modes,
                               const struct cor_disk_hard_wall_options *options, double speed,
                               struct cor_disk_hard_wall *out);

/* Does the same as cor_disk_hard_wall for any nu, -1 < nu < 1, without a table. The function computes the modes that
 * the tolerance needs by cor_disk_modes_compute, up to COR_DISK_HARD_WALL_MAX_LEVELS. For many speeds a table is
 * faster. */
COR_API int cor_disk_hard_wall_nu(double nu, const struct cor_disk_hard_wall_options *options, double speed,
                                  struct cor_disk_hard_wall *out);

struct cor_disk_hard_wall_moment {
    double time;          /* since the first touch */
    double position;      /* x_0; the compression is x_0 + 1 */
    double velocity;      /* of the centre of mass, positive towards the wall */
    double load;          /* force of the wall */
    double contact_angle; /* largest angle in contact; 0 in a point contact, and without contact */
};

/* Optional results, all from the level with the largest Omega. Every pointer may be NULL. Arrays have n_modes elements
 * in the order of the table, 0 for modes above Omega. */
struct cor_disk_hard_wall_detail {
    double *energy_after;   /* energy left in each mode, as a fraction of (pi/2) v^2 */
    double *energy_average; /* mean of this energy over the contact time, in the same unit */
    /* The function calls observe at every step, from the first touch until after the last. q and q_dot then hold the
     * amplitudes Q and dQ/dt. */
    void (*observe)(void *context, const struct cor_disk_hard_wall_moment *moment);
    void *context;
    double *q, *q_dot;
};

/* cor_disk_hard_wall_in computes the same as cor_disk_hard_wall in a workspace of the caller, and sets *detail, which
 * may be NULL. cor_disk_hard_wall_workspace returns the number of bytes that suffice for a workspace at any address, or
 * 0 if cor_disk_hard_wall_in would return COR_ERROR_... for these arguments. */
COR_API size_t cor_disk_hard_wall_workspace(const struct cor_disk_modes *modes, size_t n_modes,
                                            const struct cor_disk_hard_wall_options *options, double speed);
/* Returns a status as above, or COR_ERROR_WORKSPACE if the workspace is too small. It allocates nothing. */
COR_API int cor_disk_hard_wall_in(void *workspace, size_t bytes, const struct cor_disk_modes *modes, size_t n_modes,
                                  const struct cor_disk_hard_wall_options *options, double speed,
                                  struct cor_disk_hard_wall *out, const struct cor_disk_hard_wall_detail *detail);

/* ---- restitution at a rigid wall from a table ---- */

/* Return the restitution of a disk with all its modes at a rigid wall, as cor_disk_hard_wall computes it. The functions
 * interpolate a table of collisions, generated/disk_limits.h, by polynomials of degree 3 in v^(1/8) and nu. The
 * polynomials are continuous across the borders of the table's cells. A call takes 14 ns (measured; docs/speed).
 *     one_minus_eps2               energy left in the modes, as a fraction of (pi/2) v^2
 *     one_minus_eps2_uncertainty   1.5 times the largest error of the polynomial observed between the grid points of
 *                                  the cell, combined with the error estimates of the collisions: an estimate, not a
 *                                  bound. Near smaller cells it approaches their uncertainty. At 600 random points off
 *                                  the grid and 400 on and near borders of cells, the error did not exceed it
 *                                  (tests/unit/test_disk_eps.c). For v <= COR_DISK_EPS_CALM_SPEED it is at most
 *                                  COR_DISK_EPS_MAX_UNCERTAINTY, beyond at most COR_DISK_EPS_MAX_UNCERTAINTY_FAST
 *     eps, eps_uncertainty         the same for eps; eps_array gives the same numbers for many speeds
 * The functions are continuous: where v differs by 2e-13 v, or nu by 2e-13, 1 - eps^2 and eps differ by at most
 * COR_DISK_EPS_MAX_JUMP (sampled at 24 million places on borders). The uncertainty may jump.
 * Domain: the speeds and Poisson's ratios below, ends included. Outside the domain, and for NaN, the result is NaN.
 * Beyond nu = COR_DISK_EPS_MAX_NU, 1 - eps^2 has too many kinks for a table of this size. For other speeds and nu, and
 * for smaller errors, call cor_disk_hard_wall_nu; for softer walls call cor_disk_collision. */
#define COR_DISK_EPS_MIN_SPEED 1e-5
#define COR_DISK_EPS_MAX_SPEED 0.3
#define COR_DISK_EPS_CALM_SPEED 0.15
#define COR_DISK_EPS_MIN_NU (-0.2)
#define COR_DISK_EPS_MAX_NU 0.4875
#define COR_DISK_EPS_MAX_UNCERTAINTY 3.4e-5
#define COR_DISK_EPS_MAX_UNCERTAINTY_FAST 1e-4
#define COR_DISK_EPS_MAX_JUMP 1e-12
COR_API double cor_disk_eps(double speed, double nu);
COR_API void cor_disk_eps_array(const double *speed, double nu, double *eps, size_t n);
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
