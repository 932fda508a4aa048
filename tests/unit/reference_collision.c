/* SPDX-License-Identifier: MIT */
#include "reference_collision.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* GAUSS: points of a panel; GROUP: rows that are summed side by side */
enum { GAUSS = 16, GROUP = 8, MOST_STEPS = 1000000 };

/* A run. The coefficients of t^k from wide_orders on count for so little that double holds them. */
struct effort {
    int wide, order, wide_orders; /* wide: quad precision instead of long double */
    double tolerance;             /* error of a step in the velocities, relative to the speed */
    double panels;                /* relative to the first guess */
};

/* ln of how far below the tolerance a pressure is nothing */
#define MARGIN 12.0

struct disk {
    const struct cor_disk_mode *mode;
    size_t n, n_max, rows; /* rows: two for each n that occurs, cos(n phi) cos(phi) and -sin(n phi) sin(phi) */
    size_t *row, *row_of;  /* of each mode and of each n */
    double alpha, speed;
    size_t panels, points, active, *panel; /* panel: the active ones */
};

/* What a run finds out */
struct course {
    long double eps;
    double one_minus_eps2, max_compression, max_load;
    double level, start, end;           /* of the load: where contact begins and ends, 0 if that is not known */
    double *after, *integral, *average; /* of each mode; average may be NULL */
    size_t steps;
};

/* Memory, freed together */
struct pool {
    void *piece[40];
    int count;
};

static void *pool_take(struct pool *pool, size_t count, size_t bytes)
{
    void *const piece = calloc(count > 0 ? count : 1, bytes);
    if (piece == NULL)
        abort();
    pool->piece[pool->count++] = piece;
    return piece;
}

static void pool_free(struct pool *pool)
{
    for (int i = 0; i < pool->count; i++)
        free(pool->piece[i]);
}

/* ---- bounds ---- */

/* The position of the rim where the wall's force changes no velocity by more than a small part of the tolerance */
static double negligible_position(const struct disk *disk, const struct effort *effort)
{
    return fmin(0, (log(effort->tolerance * disk->alpha * disk->speed * disk->speed) - MARGIN) / disk->alpha);
}

/* How far from the centre the modes can move the rim at most while nothing pushes, or how fast, all amplitudes of one
 * sign */
static double swing(const struct disk *disk, const double *position, int speed)
{
    double sum = 0;
    for (size_t i = 0; i < disk->n; i++) {
        const struct cor_disk_mode *const m = &disk->mode[i];
        const double q = position[1 + i], p = position[2 + disk->n + i];
        sum += (fabs(m->c) + fabs(m->s)) * (speed ? hypot(m->omega * q, p) : hypot(q, p / m->omega));
    }
    return sum;
}

/* The longest step that the coefficients of t^k allow: the last two may change a velocity by the tolerance, one that
 * double has to hold by 2^50 times as much. */
static double step_allowed(const struct disk *disk, const struct effort *effort, const double *position, int k)
{
    double most = 0;
    if (k <= effort->wide_orders)
        return HUGE_VAL;
    for (size_t i = (size_t)k * (1 + disk->n); i < (size_t)(k + 1) * (1 + disk->n); i++)
        most = fmax(most, fabs(position[i]));
    const double limit = effort->tolerance * disk->speed * (k < effort->order ? 0x1p50 : 1);
    return most > 0 ? pow(limit / (k * most), 1.0 / (k - 1)) : HUGE_VAL;
}

/* ---- the series in double ---- */

#define REAL double
#define NAME(x) double_##x
#include "reference_collision_series.h"
#undef REAL
#undef NAME

/* ---- moments within a step, from its series ---- */

/* sum c_k t^k, k < count, of coefficients so far apart, or its slope */
struct track {
    const double *c;
    size_t apart;
    int count, slope;
};

static double track_at(const struct track *f, double t)
{
    double value = 0;
    for (int k = f->count - 1; k >= f->slope; k--)
        value = value * t + (f->slope ? k : 1) * f->c[(size_t)k * f->apart];
    return value;
}

/* 1 or -1 if it rises or falls through a level between low and high, at *t; otherwise 0 */
static int passes(const struct track *f, double level, double low, double high, double *t)
{
    const int rises = track_at(f, high) >= level;
    if ((track_at(f, low) >= level) == rises)
        return 0;
    for (int i = 0; i < 60; i++) {
        *t = 0.5 * (low + high);
        *((track_at(f, *t) < level) == rises ? &low : &high) = *t;
    }
    *t = 0.5 * (low + high);
    return rises ? 1 : -1;
}

/* Adds the modes' energies, integrated over the step until t. */
static void integrate_energies(const struct disk *disk, int count, const double *position, double t, const double *from,
                               double *to)
{
    static const double node[] = {0.18343464249564980, 0.52553240991632899, 0.79666647741362674, 0.96028985649753623},
                        weight[] = {0.36268378337836198, 0.31370664587788729, 0.22238103445337447, 0.10122853629037626};
    for (size_t i = 0; i < disk->n; i++) {
        double sum = 0;
        for (int j = 0; j < 8; j++) {
            const double at = t / 2 * (1 + (j % 2 ? node[j / 2] : -node[j / 2]));
            const struct track f = {position + 1 + i, 1 + disk->n, count, 0}, slope = {f.c, f.apart, count, 1};
            const double q = disk->mode[i].omega * track_at(&f, at), p = track_at(&slope, at);
            sum += weight[j / 2] * (p * p + q * q);
        }
        to[i] = from[i] + t / 2 * sum / (disk->speed * disk->speed);
    }
}

enum { SAMPLES = 8 };

/* Notes what a step of length h from `time` passes: turning points of the centre, maxima of the load, and its
 * crossings of the level. */
static void follow(const struct disk *disk, const struct effort *effort, const struct double_series *s,
                   struct course *course, double time, double h)
{
    const int count = effort->order;
    const struct track depth = {s->position, 1 + disk->n, count + 2, 0}, speed = {depth.c, depth.apart, count + 2, 1};
    const struct track load = {s->load, 1, disk->active > 0 ? count : 0, 0}, change = {load.c, 1, load.count, 1};
    for (int j = 0; j < SAMPLES; j++) {
        const double low = h * j / (double)SAMPLES, high = h * (j + 1) / (double)SAMPLES;
        double t;
        if (passes(&speed, 0, low, high, &t) < 0)
            course->max_compression = fmax(course->max_compression, track_at(&depth, t));
        if (passes(&change, 0, low, high, &t) < 0)
            course->max_load = fmax(course->max_load, track_at(&load, t));
        const int level = course->level > 0 ? passes(&load, course->level, low, high, &t) : 0;
        if (level < 0) {
            course->end = time + t;
            if (course->average != NULL)
                integrate_energies(disk, count + 2, s->position, t, course->integral, course->average);
        } else if (level > 0 && isnan(course->start)) {
            course->start = time + t;
            if (course->average != NULL) /* so that the integral is 0 here */
                integrate_energies(disk, count + 2, s->position, t, course->integral, course->integral);
            for (size_t i = 0; course->average != NULL && i < disk->n; i++)
                course->integral[i] = -course->integral[i];
        }
    }
    if (course->average != NULL && !isnan(course->start))
        integrate_energies(disk, count + 2, s->position, h, course->integral, course->integral);
}

/* ---- whole collisions in the wider types ---- */

#define REAL long double
#define NAME(x) long_##x
static long double long_pi(void)
{
    return 3.141592653589793238462643383279502884L;
}
static long double long_exp(long double x)
{
    return expl(x);
}
#include "reference_collision_series.h"

#include "reference_collision_run.h"
#undef REAL
#undef NAME

#if LDBL_MANT_DIG < 113 && defined __SIZEOF_FLOAT128__
#define HAVE_QUAD
__extension__ typedef __float128 quad;
#define REAL quad
#define NAME(x) quad_##x
/* The nearest long double and what is left of it */
static quad quad_pi(void)
{
    return (quad)3.141592653589793238462643383279502884L + (quad)-5.0165576126683320235e-20L;
}
/* exp(x) = 2^k exp(r/16)^16, |r| < 0.35, by Taylor's series */
static quad quad_exp(quad x)
{
    const quad ln2 = (quad)0.693147180559945309417232121458176568L + (quad)-1.14583527267987328109e-20L;
    const int k = (int)rintl((long double)(x / ln2));
    const quad r = (x - k * ln2) / 16;
    quad sum = 1, term = 1;
    for (int i = 1; i < 22; i++) {
        term *= r / i;
        sum += term;
    }
    for (int i = 0; i < 4; i++)
        sum *= sum;
    return sum * (quad)ldexpl(1, k);
}
#include "reference_collision_series.h"

#include "reference_collision_run.h"
#undef REAL
#undef NAME
#endif

/* ---- runs until they agree ---- */

static int disk_collide(struct disk *disk, const struct effort *effort, struct course *course)
{
#ifdef HAVE_QUAD
    if (effort->wide)
        return quad_collide(disk, effort, course);
#endif
    return long_collide(disk, effort, course);
}

/* Panels for 16 digits or so: the pressure falls off over alpha^(-2/3) at the contact's edge, and over alpha^(-1/2)
 * where the contact is small; a mode has n_max waves. */
static double panels_needed(const struct disk *disk)
{
    const double contact = sqrt(disk->speed) * pow(disk->alpha, 2.0 / 3);
    return 4 + 0.25 * contact + 0.06 * sqrt(disk->alpha) + 0.1 * (double)disk->n_max;
}

static const struct effort efforts[] = {{0, 16, 1, 0x1p-46, 0.8}, {0, 20, 2, 0x1p-54, 1},   {0, 24, 6, 0x1p-61, 1.3},
                                        {0, 26, 8, 0x1p-63, 1.6}, {1, 28, 9, 0x1p-73, 1.8}, {1, 34, 17, 0x1p-92, 2.2}};

/* Each n that occurs gets two rows; the last rows, up to a whole group, are of no mode. */
static void number_rows(struct disk *disk)
{
    for (size_t i = 0; i <= disk->n_max; i++)
        disk->row_of[i] = SIZE_MAX;
    for (size_t i = 0; i < disk->n; i++) {
        size_t *const row = &disk->row_of[disk->mode[i].n];
        if (*row == SIZE_MAX) {
            *row = disk->rows;
            disk->rows += 2;
        }
        disk->row[i] = *row;
    }
    disk->rows = (disk->rows + GROUP - 1) / GROUP * GROUP;
}

int reference_disk_collision(const struct cor_disk_mode *mode, size_t n, double alpha, double speed, double needed,
                             struct reference_collision *out, double *energy_after, double *energy_average)
{
    struct pool pool = {{0}, 0};
    struct disk disk = {.mode = mode, .n = n, .alpha = alpha, .speed = speed};
    for (size_t i = 0; i < n; i++)
        if ((size_t)mode[i].n > disk.n_max)
            disk.n_max = (size_t)mode[i].n;
    disk.row = pool_take(&pool, n, sizeof *disk.row);
    disk.row_of = pool_take(&pool, disk.n_max + 1, sizeof *disk.row_of);
    struct course course = {.after = pool_take(&pool, n, sizeof(double)),
                            .integral = pool_take(&pool, n, sizeof(double)),
                            .average = energy_average};
    int status = 1;
    long double before = 0;
    number_rows(&disk);
    for (size_t i = 0; status == 1 && i < sizeof efforts / sizeof *efforts; i++) {
        disk.panels = (size_t)ceil(efforts[i].panels * panels_needed(&disk));
        disk.points = disk.panels * GAUSS;
        course.level = course.max_load / 1000;
        course.max_compression = -HUGE_VAL;
        course.max_load = 0;
        course.start = course.end = NAN;
        memset(course.integral, 0, n * sizeof(double));
        if (disk_collide(&disk, &efforts[i], &course) != 0)
            status = 2;
        out->error = i == 0 ? HUGE_VAL : 4 * (double)fabsl(course.eps - before);
        if (out->error <= needed)
            status = 0;
        before = course.eps;
    }
    out->eps = (double)course.eps;
    out->one_minus_eps2 = course.one_minus_eps2;
    out->energy_drift = (double)(course.eps * course.eps + course.one_minus_eps2 - 1);
    out->contact_time = course.end - course.start;
    out->max_compression = course.max_compression;
    for (size_t i = 0; status != 2 && i < n; i++) {
        if (energy_after != NULL)
            energy_after[i] = course.after[i];
        if (energy_average != NULL)
            energy_average[i] /= out->contact_time;
    }
    pool_free(&pool);
    return status;
}
