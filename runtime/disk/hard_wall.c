/* SPDX-License-Identifier: MIT */
/* Restitution of a disk with infinitely many modes at a rigid wall: the sequence of levels Omega, its extrapolation to
 * Omega -> infinity, and the error estimate. docs/theory-disks.md, 17. */
#include "runtime/disk/hard_wall_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cor/status.h"

/* ---- constants, and the origin of their values ---- */

enum { MAX_LEVELS = COR_DISK_HARD_WALL_MAX_LEVELS, LEAST_LEVELS = 2 };

/* Steps and spacings for COARSE_TOLERANCE. For smaller tolerances a fineness from FINEST to 1 multiplies both. Fitted:
 * at fineness 1 the noise in 1 - eps^2 is at most 5e-7 in nine of ten levels, sampled at 200 random scenes. */
#define COARSE_TOLERANCE 4e-6
#define FINEST 0.4
#define TURN 0.8         /* Omega h */
#define WAVE_SPACING 0.4 /* Omega d, where d is the spacing of angles; MOST_ANGLES may require a larger d */
#define COARSEST_SPACING                                                                                               \
    0.8 /* largest Omega d: the Nyquist number pi/d must exceed 1.75 Omega, the largest n of the rim's waves */
#define LEAST_ANGLES 60
#define MOST_ANGLES 120 /* in the half-width of the contact, at fineness 1 */
#define HALF_WIDTH 1.1  /* assumed half-width of the contact divided by sqrt(v); the true one is at most 1.45 */
#define RANGE 2.6       /* range of the angles divided by sqrt(v) */

/* The error estimate is the sum of three parts. The first is the largest of the last changes of the extrapolated value,
 * after multiplication by the weights below. It is at least EXTRAPOLATED times the distance of this value from the
 * highest level. The second bounds the effect of waves that no level has shown yet and that return while contact ends
 * or splits. The third is the noise of steps and angles. Fitted: with these factors the estimate is at least the error,
 * as two more levels show, in 200 random scenes at six tolerances. */
static const double calm_weight[] = {3, 1, 0.3, 0.1};
#define EXTRAPOLATED 0.25
#define UNSEEN 0.07 /* waves that no level has shown yet add UNSEEN/Omega^2 */
#define NOISE 8e-7  /* the noise adds NOISE fineness^NOISE_POWER */
#define NOISE_POWER 2.5
/* Number of levels that an accepted estimate needs */
enum { ENOUGH_LEVELS = 5 };
/* A collision is wild above WILD_SPEED, or above CALM_SPEED if nu is outside LEAST_CALM to LARGEST_CALM. Up to
 * WILD_LEVELS of its levels may agree by chance, so the weights are larger. Above WILD_SPEED the second part is at
 * least UNSEEN_WILD (60/Omega)^4. Fitted. No collision in the domain of cor_disk_eps is wild. */
#define WILD_SPEED 0.31
#define CALM_SPEED 0.05
#define LEAST_CALM (-0.21)
#define LARGEST_CALM 0.5
enum { WILD_LEVELS = 8 };
static const double wild_weight[] = {3, 2, 0.6, 0.2};
#define UNSEEN_WILD 1.5e-3
/* In the domain of cor_disk_eps, and slightly beyond it, a second estimate limits the first if Omega is above
 * USUAL_FROM. The second estimate is the usual error at Omega plus a fraction of the last changes. Fitted at
 * USUAL_TOLERANCE to random scenes of the domain: docs/theory-disks.md, 17. */
#define USUAL_SPEED 9e-6
#define USUAL 6.8e-7
#define USUAL_OMEGA 680
#define USUAL_POWER 3.5
#define USUAL_FROM 160
#define USUAL_TOLERANCE 1e-6
static const double usual_weight[] = {0.23, 0.23, 0.092, 0.028};
#define POINT_ERROR 3e-8 /* error of 1 - eps^2 in a point contact, against the full method at v = 1e-7 to 1e-5 */

/* ---- levels ---- */

static double fineness_of(double tolerance)
{
    return fmin(fmax(cbrt(tolerance / COARSE_TOLERANCE), FINEST), 1);
}

static double omega_of(size_t level)
{
    return COR_DISK_HARD_WALL_FIRST_OMEGA * ldexp(level % 2 == 0 ? 1 : COR_ROOT_2, (int)(level / 2));
}

static struct cor_hard_wall_settings settings_of(size_t level, double speed, double tolerance)
{
    const double fine = fineness_of(tolerance), omega = omega_of(level), half_width = HALF_WIDTH * sqrt(speed);
    const double wave = fmax(WAVE_SPACING * fine / omega, half_width * fine / MOST_ANGLES);
    const struct cor_hard_wall_settings settings = {
        omega,
        TURN * fine,
        COR_HARD_WALL_FADE,
        speed < COR_DISK_HARD_WALL_POINT_SPEED,
        fmin(fmin(wave, half_width * fine / LEAST_ANGLES), COARSEST_SPACING / omega),
        RANGE * sqrt(speed),
        0,
        0,
        NULL};
    return settings;
}

/* Returns the number of levels for which the lowest n_modes modes suffice. */
static size_t levels_of(const struct cor_disk_modes *modes, size_t n_modes)
{
    size_t levels = 0;
    while (levels < MAX_LEVELS && omega_of(levels) <= modes->mode[n_modes - 1].omega)
        levels++;
    return levels;
}

/* ---- the sequence ---- */

struct level_sequence {
    double nu, speed, tolerance;
    size_t levels;
    double l[MAX_LEVELS], extrapolated[MAX_LEVELS]; /* extrapolated[k]: from levels k - 1 and k */
    double max_compression[MAX_LEVELS], contact_time, error_estimate;
    double work_left, work_per_step; /* the budget, see struct cor_hard_wall_settings */
    double last_work;                /* work of the highest level */
    int exhausted;                   /* the budget has ended */
};

static struct level_sequence begin_sequence(double nu, double speed, const struct cor_disk_hard_wall_options *options,
                                            double most_work)
{
    const int counted = options->max_steps > 0;
    const struct level_sequence sequence = {.nu = nu,
                                            .speed = speed,
                                            .tolerance = options->tolerance,
                                            .work_per_step = counted,
                                            .work_left = counted ? (double)options->max_steps : most_work};
    return sequence;
}

/* Returns the limit extrapolated from two levels; the second has twice the Omega^2 of the first. */
static double limit_of(double before, double last)
{
    return last + (last - before);
}

static int is_calm_nu(double nu)
{
    return nu >= LEAST_CALM && nu <= LARGEST_CALM;
}

/* True if the collision is not wild (see WILD_SPEED). */
static int is_calm(const struct level_sequence *sequence)
{
    return sequence->speed <= (is_calm_nu(sequence->nu) ? WILD_SPEED : CALM_SPEED);
}

static int is_usual(const struct level_sequence *sequence)
{
    return is_calm_nu(sequence->nu) && sequence->speed >= USUAL_SPEED && sequence->speed <= WILD_SPEED &&
           omega_of(sequence->levels - 1) > USUAL_FROM;
}

/* Returns a bound on the effect of waves that no level up to Omega shows. */
static double unseen_part(double speed, double omega)
{
    const double wild = speed > WILD_SPEED ? UNSEEN_WILD * pow(60 / omega, 4) : 0;
    return fmax(UNSEEN / (omega * omega), wild);
}

static double noise_of(double tolerance)
{
    return NOISE * pow(fineness_of(tolerance), NOISE_POWER);
}

/* Multiplies the last changes of the extrapolated value by weights. Returns the largest product. */
static double changes_of(const struct level_sequence *sequence, const double *weight)
{
    const size_t last = sequence->levels - 1, changes = sizeof calm_weight / sizeof *calm_weight;
    double most = 0;
    for (size_t i = 0; i < changes && i + 2 <= last; i++)
        most = fmax(most, weight[i] * fabs(sequence->extrapolated[last - i] - sequence->extrapolated[last - i - 1]));
    return most;
}

static double usual_estimate(const struct level_sequence *sequence)
{
    const double omega = omega_of(sequence->levels - 1);
    return USUAL * pow(USUAL_OMEGA / omega, USUAL_POWER) + changes_of(sequence, usual_weight) +
           fmax(noise_of(sequence->tolerance) - noise_of(USUAL_TOLERANCE), 0);
}

static double estimate_of(const struct level_sequence *sequence)
{
    const size_t last = sequence->levels - 1;
    /* a single extrapolated value cannot be compared with another */
    const double extrapolation = (last < 2 ? 1 : EXTRAPOLATED) * fabs(sequence->extrapolated[last] - sequence->l[last]);
    const double *const weight = is_calm(sequence) || sequence->levels > WILD_LEVELS ? calm_weight : wild_weight;
    const double estimate = fmax(extrapolation, changes_of(sequence, weight)) +
                            unseen_part(sequence->speed, omega_of(last)) + noise_of(sequence->tolerance);
    const double point = sequence->speed < COR_DISK_HARD_WALL_POINT_SPEED ? POINT_ERROR : 0;
    return point + (is_usual(sequence) ? fmin(estimate, usual_estimate(sequence)) : estimate);
}

static int is_settled(const struct level_sequence *sequence)
{
    return sequence->levels >= ENOUGH_LEVELS && sequence->error_estimate <= sequence->tolerance;
}

static void conclude_sequence(const struct level_sequence *sequence, struct cor_disk_hard_wall *out)
{
    const size_t last = sequence->levels - 1;
    out->one_minus_eps2 = fmax(sequence->extrapolated[last], 0);
    out->eps = sqrt(1 - out->one_minus_eps2);
    out->contact_time = sequence->contact_time;
    out->max_compression = limit_of(sequence->max_compression[last - 1], sequence->max_compression[last]);
    out->error_estimate = sequence->error_estimate;
    out->omega_levels = sequence->levels;
}

/* Computes one level. Returns COR_TOLERANCE_NOT_REACHED if the budget ends, or if the range of angles does not suffice,
 * which occurs in no known scene. With detail the budget is unlimited, because the level is known to end. */
static int compute_level(struct level_sequence *sequence, void *workspace, const struct cor_disk_modes *modes,
                         size_t level, struct cor_hard_wall_result *result,
                         const struct cor_disk_hard_wall_detail *detail)
{
    struct cor_hard_wall_settings settings = settings_of(level, sequence->speed, sequence->tolerance);
    settings.work_per_step = sequence->work_per_step;
    settings.most_work = detail == NULL ? fmax(sequence->work_left, 1) : 0;
    const int status =
        cor_hard_wall_level(cor_store_aligned(workspace), modes, sequence->speed, &settings, result, detail);
    sequence->work_left -= result->work;
    sequence->last_work = result->work;
    return status == COR_ERROR_WORKSPACE ? COR_TOLERANCE_NOT_REACHED : status;
}

/* True if the budget suffices for the work `before` and for the next level. */
static int is_affordable(const struct level_sequence *sequence, double before)
{
    const double growth = sequence->work_per_step > 0 ? sqrt(2) : COR_HARD_WALL_GROWTH;
    return before + growth * sequence->last_work <= sequence->work_left;
}

/* Adds levels to the sequence until the error is small enough, the modes do not suffice, or the budget ends. */
static int sequence_climb(struct level_sequence *sequence, void *workspace, const struct cor_disk_modes *modes,
                          size_t levels)
{
    while (sequence->levels < levels && !is_settled(sequence) && !sequence->exhausted) {
        struct cor_hard_wall_result result = {0};
        const size_t k = sequence->levels;
        const int status = is_affordable(sequence, 0) ? compute_level(sequence, workspace, modes, k, &result, NULL)
                                                      : COR_TOLERANCE_NOT_REACHED;
        sequence->exhausted = status == COR_TOLERANCE_NOT_REACHED;
        if (sequence->exhausted)
            break;
        if (status != COR_OK)
            return status;
        sequence->l[k] = result.one_minus_eps2;
        sequence->max_compression[k] = result.max_compression;
        sequence->contact_time = result.contact_time;
        sequence->extrapolated[k] = k > 0 ? limit_of(sequence->l[k - 1], sequence->l[k]) : sequence->l[k];
        sequence->levels++;
        if (k > 0)
            sequence->error_estimate = estimate_of(sequence);
    }
    if (sequence->exhausted && sequence->levels < LEAST_LEVELS)
        return COR_CONTACT_NOT_ENDED;
    return is_settled(sequence) ? COR_OK : COR_TOLERANCE_NOT_REACHED;
}

/* ---- calls ---- */

static int check_options(const struct cor_disk_hard_wall_options *options)
{
    if (options == NULL)
        return COR_ERROR_NULL;
    return isgreaterequal(options->tolerance, COR_DISK_HARD_WALL_MIN_TOLERANCE) && options->tolerance < 1
               ? COR_OK
               : COR_ERROR_TOLERANCE;
}

/* Returns COR_OK, or the status of the first error in the table and the options. */
static int hard_wall_check(const struct cor_disk_modes *modes, size_t n_modes,
                           const struct cor_disk_hard_wall_options *options)
{
    const int status = options == NULL ? COR_ERROR_NULL : cor_disk_table_check(modes, n_modes);
    if (status != COR_OK)
        return status;
    for (size_t i = 0; i < n_modes; i++)
        if (modes->mode[i].n > COR_HARD_WALL_MAX_N && modes->mode[i].omega < omega_of(MAX_LEVELS - 1))
            return COR_ERROR_MODES;
    return levels_of(modes, n_modes) < LEAST_LEVELS ? COR_ERROR_MODES : check_options(options);
}

static int check_speed(double speed)
{
    return islessequal(speed, COR_DISK_HARD_WALL_MAX_SPEED) ? COR_OK : COR_ERROR_SPEED;
}

static const struct cor_disk_hard_wall unknown = {NAN, NAN, NAN, NAN, NAN, 0};

/* Returns the bytes for the levels from..to-1 and for the alignment of a workspace. */
static size_t bytes_of_levels(const struct cor_disk_modes *modes, size_t from, size_t to, double speed,
                              double tolerance)
{
    size_t most = 0;
    for (size_t level = from, below = 0; level < to; level++) {
        const struct cor_hard_wall_settings settings = settings_of(level, speed, tolerance);
        while (below < modes->count && modes->mode[below].omega < settings.omega)
            below++;
        const size_t bytes = cor_hard_wall_level_bytes(modes->mode, below, &settings);
        most = bytes > most ? bytes : most;
    }
    return most + COR_ALIGNMENT;
}

size_t cor_disk_hard_wall_workspace(const struct cor_disk_modes *modes, size_t n_modes,
                                    const struct cor_disk_hard_wall_options *options, double speed)
{
    if (hard_wall_check(modes, n_modes, options) != COR_OK || check_speed(speed) != COR_OK)
        return 0;
    return bytes_of_levels(modes, 0, speed > 0 ? levels_of(modes, n_modes) : 0, speed, options->tolerance);
}

int cor_disk_hard_wall_in(void *workspace, size_t bytes, const struct cor_disk_modes *modes, size_t n_modes,
                          const struct cor_disk_hard_wall_options *options, double speed,
                          struct cor_disk_hard_wall *out, const struct cor_disk_hard_wall_detail *detail)
{
    int status = hard_wall_check(modes, n_modes, options);
    if (status == COR_OK)
        status = check_speed(speed);
    if (status != COR_OK)
        return status;
    if (workspace == NULL || out == NULL)
        return COR_ERROR_NULL;
    if (bytes < cor_disk_hard_wall_workspace(modes, n_modes, options, speed))
        return COR_ERROR_WORKSPACE;
    *out = unknown;
    if (speed <= 0)
        return COR_WALL_NOT_TOUCHED;
    struct level_sequence sequence = begin_sequence(modes->nu, speed, options, COR_HARD_WALL_WORK);
    const struct cor_disk_modes lowest = {modes->nu, n_modes, modes->mode};
    status = sequence_climb(&sequence, workspace, &lowest, levels_of(modes, n_modes));
    if (sequence.levels >= LEAST_LEVELS)
        conclude_sequence(&sequence, out);
    if (detail != NULL && (status == COR_OK || status == COR_TOLERANCE_NOT_REACHED) && sequence.levels > 0) {
        /* computes the highest level again, for the optional results */
        struct cor_hard_wall_result result = {.contact_time = sequence.contact_time};
        const int told = compute_level(&sequence, workspace, &lowest, sequence.levels - 1, &result, detail);
        status = told == COR_OK ? status : told;
    }
    return status;
}

int cor_disk_hard_wall(const struct cor_disk_modes *modes, size_t n_modes,
                       const struct cor_disk_hard_wall_options *options, double speed, struct cor_disk_hard_wall *out)
{
    const size_t bytes = cor_disk_hard_wall_workspace(modes, n_modes, options, speed);
    void *const workspace = malloc(bytes > 0 ? bytes : 1); /* a size of 0 is refused below */
    const int status = workspace == NULL
                           ? COR_ERROR_MEMORY
                           : cor_disk_hard_wall_in(workspace, bytes, modes, n_modes, options, speed, out, NULL);
    free(workspace);
    return status;
}

/* ---- without a table ---- */

/* Computes the sequence up to `levels` levels, with its own modes and workspace. Returns COR_TOLERANCE_NOT_REACHED if
 * the budget ends. */
static int climb_alone(struct level_sequence *sequence, size_t levels)
{
    const size_t count = cor_disk_modes_below(sequence->nu, omega_of(levels - 1)) + 1;
    const double work = sequence->work_per_step > 0 ? 0 : COR_HARD_WALL_MODE_WORK * (double)count;
    sequence->exhausted = !is_affordable(sequence, work);
    if (sequence->exhausted)
        return COR_TOLERANCE_NOT_REACHED;
    struct cor_disk_modes modes;
    struct cor_disk_mode *const mode = malloc(count * sizeof *mode);
    int status = mode == NULL ? COR_ERROR_MEMORY : cor_disk_modes_compute(sequence->nu, count, mode, &modes);
    sequence->work_left -= work;
    void *workspace = NULL;
    if (status == COR_OK) {
        workspace = malloc(bytes_of_levels(&modes, sequence->levels, levels, sequence->speed, sequence->tolerance));
        status = workspace == NULL ? COR_ERROR_MEMORY : sequence_climb(sequence, workspace, &modes, levels);
    }
    free(workspace);
    free(mode);
    return status;
}

int cor_hard_wall_within(double most_work, double nu, const struct cor_disk_hard_wall_options *options, double speed,
                         struct cor_disk_hard_wall *out, double *work)
{
    *work = 0;
    if (out == NULL)
        return COR_ERROR_NULL;
    if (!isless(fabs(nu), 1))
        return COR_ERROR_DISK_POISSON_RATIO;
    int status = check_options(options);
    if (status == COR_OK)
        status = check_speed(speed);
    if (status != COR_OK)
        return status;
    *out = unknown;
    if (speed <= 0)
        return COR_WALL_NOT_TOUCHED;
    struct level_sequence sequence = begin_sequence(nu, speed, options, most_work);
    const double whole = sequence.work_left;
    size_t levels = 7;
    while ((status = climb_alone(&sequence, levels)) == COR_TOLERANCE_NOT_REACHED && !sequence.exhausted &&
           levels < MAX_LEVELS)
        levels += levels < 11 ? 2 : 1; /* two more levels need modes that take eight times as long to compute */
    if (sequence.levels >= LEAST_LEVELS)
        conclude_sequence(&sequence, out);
    *work = whole - sequence.work_left;
    return status;
}

int cor_disk_hard_wall_nu(double nu, const struct cor_disk_hard_wall_options *options, double speed,
                          struct cor_disk_hard_wall *out)
{
    double work;
    return cor_hard_wall_within(COR_HARD_WALL_WORK, nu, options, speed, out, &work);
}
