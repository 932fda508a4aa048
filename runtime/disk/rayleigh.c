/* SPDX-License-Identifier: MIT */
/* Rayleigh's energy: the sum over the modes of a table and its tail (rayleigh_parts.h), at one speed, at one speed to a
 * tolerance, and at many speeds. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "cor/disk.h"
#include "cor/status.h"
#include "runtime/disk/quasistatic.h"
#include "runtime/disk/rayleigh_parts.h"
#include "runtime/number/environment.h"

/* The tail uses this number of modes if the table has them, even if the caller requests fewer. */
enum { TAIL_MODES = 1800 };

/* ---- statuses ---- */

/* Returns the number of modes in the sums and the tail for n_modes modes. */
static size_t modes_taken(const struct cor_disk_modes *modes, size_t n_modes)
{
    const size_t least = modes->count < TAIL_MODES ? modes->count : TAIL_MODES;
    return n_modes > least ? n_modes : least;
}

/* Returns COR_OK, or the status of the first wrong argument. *limit receives the largest speed of the contact law. */
static int arguments_status(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum,
                            double *limit)
{
    if (!isless(fabs(modes->nu), 1))
        return COR_ERROR_DISK_POISSON_RATIO;
    if (n_modes == 0 || n_modes > modes->count)
        return COR_ERROR_MODES;
    if (!modes->mode)
        return COR_ERROR_NULL;
    const struct cor_disk_mode *const end = modes->mode + modes_taken(modes, n_modes);
    double below = COR_RAYLEIGH_LEAST_OMEGA;
    for (const struct cor_disk_mode *mode = modes->mode; mode < end; mode++) {
        if (!(isgreaterequal(mode->omega, below) && mode->omega < 1e9 && isless(fabs(mode->c), 1e9)) || mode->n < 0 ||
            mode->n > COR_DISK_MODES_MAX_N)
            return COR_ERROR_MODES;
        below = mode->omega;
    }
    *limit = cor_disk_speed_limit(modes->nu, datum);
    return isnan(*limit) ? COR_ERROR_DATUM : COR_OK;
}

static int speed_status(double speed, double limit)
{
    return isgreaterequal(speed, 0) && speed <= limit ? COR_OK : COR_ERROR_SPEED;
}

static int result_status(const struct cor_disk_rayleigh *out, double speed)
{
    return speed > COR_DISK_RAYLEIGH_MAX_SPEED || out->fraction + out->tail > 1 ? COR_BEYOND_THEORY : COR_OK;
}

/* Sets the results at v = 0. */
static int at_rest(struct cor_disk_rayleigh *out)
{
    out->fraction = out->tail = out->error_estimate = 0;
    out->contact_time = INFINITY;
    return COR_OK;
}

/* ---- one speed ---- */

static double first_omega(void)
{
    return COR_RAYLEIGH_LEAST_OMEGA - 0.1;
}

static double last_omega(const struct cor_disk_modes *modes, size_t n_modes)
{
    return COR_RAYLEIGH_FAR * modes->mode[n_modes - 1].omega;
}

/* Adds modes from..to-1; mode_fraction is NULL or the fractions of all modes. */
static void add_modes(struct cor_mode_sums *sums, struct cor_rayleigh_table *table, size_t from, size_t to,
                      const struct cor_spectrum *spectrum, double *mode_fraction)
{
    struct cor_mode_chunk chunk;
    for (size_t i = from; i < to; i += COR_LINES) {
        cor_rayleigh_weigh_modes(table, i, to, &chunk);
        cor_rayleigh_add(spectrum, &chunk, sums, mode_fraction ? mode_fraction + i : NULL);
    }
}

/* Sets the tail from sums over all modes of the table. */
static void rayleigh_finish(struct cor_disk_rayleigh *out, struct cor_rayleigh_table *table,
                            const struct cor_spectrum *spectrum, const struct cor_mode_sums *sums)
{
    struct cor_mode_chunk chunk;
    struct cor_mode_sums beyond = {0, 0, {0}, {0}};
    while (cor_surface_modes_next(&table->surface, table->set, &chunk))
        cor_rayleigh_add(spectrum, &chunk, &beyond, NULL);
    cor_rayleigh_finish(out, table, spectrum, sums, beyond.faded);
}

SHARED int rayleigh_of_speed(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum,
                             double speed, struct cor_disk_rayleigh *out, double *mode_fraction)
{
    struct cor_spectrum spectrum;
    struct cor_rayleigh_table table;
    struct cor_mode_sums sums = {0, 0, {0}, {0}};
    double limit = 0;
    if (!modes || !out)
        return COR_ERROR_NULL;
    int status = arguments_status(modes, n_modes, datum, &limit);
    if (status == COR_OK)
        status = speed_status(speed, limit);
    if (status)
        return status;
    if (speed == 0) {
        for (size_t i = 0; mode_fraction && i < n_modes; i++)
            mode_fraction[i] = 0;
        return at_rest(out);
    }
    const size_t all = modes_taken(modes, n_modes);
    out->contact_time = cor_disk_contact_time_by_quadrature(speed, modes->nu, datum);
    cor_spectrum_init(cor_rayleigh_set(cor_widest_set()), &spectrum, cor_disk_depth(speed, modes->nu, datum),
                      out->contact_time, first_omega(), last_omega(modes, all));
    cor_rayleigh_table_init(&table, spectrum.set, modes, all);
    add_modes(&sums, &table, 0, n_modes, &spectrum, mode_fraction);
    out->fraction = sums.fraction;
    add_modes(&sums, &table, n_modes, all, &spectrum, NULL);
    rayleigh_finish(out, &table, &spectrum, &sums);
    return result_status(out, speed);
}

/* ---- one speed to a tolerance ---- */

/* Returns the sum and the tail of the n lowest modes. sum_few: the sum of the `few` lowest. */
static struct cor_disk_rayleigh trial_of(const struct cor_disk_modes *modes, size_t n, size_t few, double sum_few,
                                         const struct cor_spectrum *spectrum, double contact_time)
{
    struct cor_disk_rayleigh trial = {0, 0, 0, contact_time};
    struct cor_rayleigh_table table;
    struct cor_mode_sums below = {0, 0, {0}, {0}}, sums = {0, 0, {0}, {0}};
    size_t first = few;
    cor_rayleigh_table_init(&table, spectrum->set, modes, n);
    add_modes(&sums, &table, few, n, spectrum, NULL);
    trial.fraction = sums.fraction = sum_few + sums.fraction;
    while (first > 0 && modes->mode[first - 1].omega > table.fading.echo_from)
        first--;
    add_modes(&below, &table, first, few, spectrum, NULL);
    sums.faded += below.faded;
    for (int k = 0; k < 4; k++) {
        sums.low[k] += below.low[k];
        sums.high[k] += below.high[k];
    }
    rayleigh_finish(&trial, &table, spectrum, &sums);
    return trial;
}

SHARED int rayleigh_to_tolerance(const struct cor_disk_modes *modes, enum cor_disk_datum datum, double speed,
                                 double tolerance, struct cor_disk_rayleigh *out, size_t *n_modes)
{
    struct cor_spectrum spectrum;
    double limit = 0;
    if (!modes || !out)
        return COR_ERROR_NULL;
    int status = arguments_status(modes, modes->count, datum, &limit);
    if (status == COR_OK)
        status = speed_status(speed, limit);
    if (status)
        return status;
    if (!(isgreater(tolerance, 0) && tolerance < 1))
        return COR_ERROR_TOLERANCE;
    if (speed == 0) {
        if (n_modes)
            *n_modes = 1;
        return at_rest(out);
    }
    const double contact_time = cor_disk_contact_time_by_quadrature(speed, modes->nu, datum);
    cor_spectrum_init(cor_rayleigh_set(cor_widest_set()), &spectrum, cor_disk_depth(speed, modes->nu, datum),
                      contact_time, first_omega(), last_omega(modes, modes->count));
    /* increases the number of modes by a quarter until they suffice, then bisects between the last two numbers */
    size_t few = 0, enough = 0, n = 1;
    double sum_few = 0;
    struct cor_disk_rayleigh best = {0, 0, 0, contact_time};
    for (;;) {
        const struct cor_disk_rayleigh trial = trial_of(modes, n, few, sum_few, &spectrum, contact_time);
        if (trial.error_estimate <= tolerance * (trial.fraction + trial.tail)) {
            enough = n;
            best = trial;
        } else {
            few = n;
            sum_few = trial.fraction;
            if (enough == 0)
                best = trial;
        }
        if (enough == 0 && few == modes->count)
            break;
        if (enough != 0 && enough - few == 1)
            break;
        n = enough == 0 ? few + 1 + few / 4 : few + (enough - few) / 2;
        if (n > modes->count)
            n = modes->count;
    }
    *out = best;
    if (n_modes)
        *n_modes = enough ? enough : modes->count;
    return enough ? result_status(out, speed) : COR_TOLERANCE_NOT_REACHED;
}

/* ---- many speeds ---- */

/* Smallest number of speeds in a piece of q0 for which spectra at the nodes of the piece save time */
enum { WORTH_A_PIECE = COR_PIECE_NODES + 4 };
/* Pieces begin at q0 = 4^FIRST_PIECE. For smaller q0, near the limit of the law, spectra are computed one by one. */
enum { FIRST_PIECE = -5, LAST_PIECE = 5 };

/* Data that all speeds share: the modes with their weights, and the surface modes beyond them */
struct list {
    struct cor_rayleigh_table table;
    struct cor_mode_chunk *chunk;      /* chunks of the n_modes modes, of the other modes of the table, and of the
                                        * surface modes */
    size_t asked, taken, with_surface; /* ends of the three groups */
    enum cor_disk_datum datum;
    size_t n_modes;
    double *room;                  /* memory of a piece */
    struct cor_spectrum *spectrum; /* of one speed; on the heap, because a piece has another one on the stack */
    double *q0;                    /* q0 of every speed; NaN if the speed is finished or invalid */
};

static size_t chunks_of(size_t modes)
{
    return (modes + COR_LINES - 1) / COR_LINES;
}

static void list_weigh(struct list *list, struct cor_surface_modes surface)
{
    const size_t asked = list->n_modes, all = list->table.n_modes;
    struct cor_mode_chunk *chunk = list->chunk;
    for (size_t i = 0; i < all; i += (size_t)chunk++->count)
        cor_rayleigh_weigh_modes(&list->table, i, i < asked ? asked : all, chunk);
    for (; chunk < list->chunk + list->with_surface; chunk++)
        cor_surface_modes_next(&surface, list->table.set, chunk);
}

/* Returns 0 if memory is short. The caller calls list_free in either case. */
static int list_init(struct list *list, const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum,
                     size_t speeds)
{
    const size_t all = modes_taken(modes, n_modes);
    list->datum = datum;
    list->n_modes = n_modes;
    cor_rayleigh_table_init(&list->table, cor_rayleigh_set(cor_widest_set()), modes, all);
    const struct cor_surface_modes first = list->table.surface;
    list->asked = chunks_of(n_modes);
    list->taken = list->asked + chunks_of(all - n_modes);
    list->with_surface = list->taken;
    for (struct cor_mode_chunk chunk; cor_surface_modes_next(&list->table.surface, list->table.set, &chunk);)
        list->with_surface++; /* counts the chunks of surface modes */
    list->chunk = malloc(list->with_surface * sizeof *list->chunk);
    list->room = malloc(cor_spectrum_piece_size(first_omega(), last_omega(modes, all)) * sizeof *list->room);
    list->spectrum = malloc(sizeof *list->spectrum);
    list->q0 = speeds < SIZE_MAX / sizeof *list->q0 ? malloc(speeds * sizeof *list->q0) : NULL;
    if (!list->chunk || !list->room || !list->spectrum || !list->q0)
        return 0;
    list_weigh(list, first);
    return 1;
}

static void list_free(struct list *list)
{
    free(list->chunk);
    free(list->room);
    free(list->spectrum);
    free(list->q0);
}

static void list_evaluate(const struct list *list, const struct cor_spectrum *spectrum, double contact_time,
                          struct cor_disk_rayleigh *out, double *mode_fraction)
{
    struct cor_mode_sums sums = {0, 0, {0}, {0}}, beyond = {0, 0, {0}, {0}};
    for (size_t k = 0; k < list->asked; k++)
        cor_rayleigh_add(spectrum, &list->chunk[k], &sums, mode_fraction ? mode_fraction + k * COR_LINES : NULL);
    out->contact_time = contact_time;
    out->fraction = sums.fraction;
    for (size_t k = list->asked; k < list->taken; k++)
        cor_rayleigh_add(spectrum, &list->chunk[k], &sums, NULL);
    for (size_t k = list->taken; k < list->with_surface; k++)
        cor_rayleigh_add(spectrum, &list->chunk[k], &beyond, NULL);
    cor_rayleigh_finish(out, &list->table, spectrum, &sums, beyond.faded);
}

/* Returns the piece that contains q0, or FIRST_PIECE - 1. */
static int piece_of(double q0)
{
    int exponent;
    frexp(q0, &exponent); /* 2^(exponent - 1) <= q0 < 2^exponent */
    const int piece = (exponent - 1 - 2 * FIRST_PIECE) / 2 + FIRST_PIECE;
    return q0 > 0 && exponent - 1 >= 2 * FIRST_PIECE && piece <= LAST_PIECE ? piece : FIRST_PIECE - 1;
}

/* Computes all speeds of one piece, or those outside all pieces. Many speeds of a piece share interpolated spectra. */
static void list_of_piece(struct list *list, int number, const double *speed, size_t n, struct cor_disk_rayleigh *out,
                          double *mode_fraction)
{
    const struct cor_disk_modes *const modes = list->table.modes;
    const double high = last_omega(modes, list->table.n_modes);
    struct cor_spectrum_piece piece;
    size_t count = 0;
    for (size_t i = 0; i < n; i++)
        count += !isnan(list->q0[i]) && piece_of(list->q0[i]) == number;
    const int whole = number >= FIRST_PIECE && count >= WORTH_A_PIECE;
    if (whole)
        cor_spectrum_piece_init(&piece, list->table.set, ldexp(1, 2 * number), first_omega(), high, list->room);
    for (size_t i = 0; i < n && count > 0; i++) {
        const double q0 = list->q0[i];
        if (isnan(q0) || piece_of(q0) != number)
            continue;
        const double contact_time = cor_disk_contact_time_by_quadrature(speed[i], modes->nu, list->datum);
        if (whole)
            cor_spectrum_of_piece(list->spectrum, &piece, q0, contact_time);
        else
            cor_spectrum_init(list->table.set, list->spectrum, q0, contact_time, first_omega(), high);
        list_evaluate(list, list->spectrum, contact_time, &out[i],
                      mode_fraction ? mode_fraction + i * list->n_modes : NULL);
        list->q0[i] = NAN;
        count--;
    }
}

static void list_of_speeds(struct list *list, double limit, const double *speed, size_t n,
                           struct cor_disk_rayleigh *out, double *mode_fraction)
{
    static const struct cor_disk_rayleigh unknown = {NAN, NAN, NAN, NAN};
    for (size_t i = 0; i < n; i++) {
        const int good = speed_status(speed[i], limit) == COR_OK, moves = good && speed[i] > 0;
        list->q0[i] = moves ? cor_disk_depth(speed[i], list->table.modes->nu, list->datum) : NAN;
        if (good)
            at_rest(&out[i]);
        else
            out[i] = unknown;
        for (size_t k = 0; mode_fraction && k < list->n_modes; k++)
            mode_fraction[i * list->n_modes + k] = good ? 0 : NAN;
    }
    for (int number = FIRST_PIECE - 1; number <= LAST_PIECE; number++)
        list_of_piece(list, number, speed, n, out, mode_fraction);
}

SHARED int rayleigh_of_speeds(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum,
                              const double *speed, size_t n, struct cor_disk_rayleigh *out, double *mode_fraction,
                              int *status)
{
    struct list list;
    double limit = 0;
    if (!modes || (n > 0 && (!speed || !out)))
        return COR_ERROR_NULL;
    int first = arguments_status(modes, n_modes, datum, &limit);
    if (first || n == 0)
        return first;
    const int enough = list_init(&list, modes, n_modes, datum, n);
    if (enough)
        list_of_speeds(&list, limit, speed, n, out, mode_fraction);
    list_free(&list);
    if (!enough)
        return COR_ERROR_MEMORY;
    for (size_t i = 0; i < n; i++) {
        const int of_speed = speed_status(speed[i], limit);
        const int here = of_speed ? of_speed : result_status(&out[i], speed[i]);
        if (status)
            status[i] = here;
        if (!first)
            first = here;
    }
    return first;
}

/* ---- the public functions ----
 *
 * The loops compute both sides of a condition. cor_environment_leave discards exceptions of the unused side. */

int cor_disk_rayleigh(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum, double speed,
                      struct cor_disk_rayleigh *out, double *mode_fraction)
{
    const struct cor_environment caller = cor_environment_enter();
    const volatile int status = rayleigh_of_speed(modes, n_modes, datum, speed, out, mode_fraction);
    cor_environment_leave(&caller);
    return status;
}

int cor_disk_rayleigh_tolerance(const struct cor_disk_modes *modes, enum cor_disk_datum datum, double speed,
                                double tolerance, struct cor_disk_rayleigh *out, size_t *n_modes)
{
    const struct cor_environment caller = cor_environment_enter();
    const volatile int status = rayleigh_to_tolerance(modes, datum, speed, tolerance, out, n_modes);
    cor_environment_leave(&caller);
    return status;
}

int cor_disk_rayleigh_array(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum,
                            const double *speed, size_t n, struct cor_disk_rayleigh *out, double *mode_fraction,
                            int *status)
{
    const struct cor_environment caller = cor_environment_enter();
    const volatile int result = rayleigh_of_speeds(modes, n_modes, datum, speed, n, out, mode_fraction, status);
    cor_environment_leave(&caller);
    return result;
}
