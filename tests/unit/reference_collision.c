/* SPDX-License-Identifier: MIT */
#include "reference_collision.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { GAUSS = 16, MOST_ORDER = 34, MOST_STEPS = 1000000 }; /* GAUSS: number of points of a panel */

struct effort {
    int wide, order;  /* wide: quad precision instead of long double */
    double tolerance; /* error of a step in the velocities, relative to the speed */
    double panels;    /* number of panels relative to the first guess */
};

/* A pressure below exp(-MARGIN) times the tolerance is negligible. */
#define MARGIN 12.0

/* A disk and the results of a run */
struct disk {
    const struct cor_disk_mode *mode;
    size_t n, rows; /* rows: the functions cos(n phi) cos(phi) and -sin(n phi) sin(phi) for each n >= 0 */
    double alpha, speed;
    const struct effort *effort;
    size_t points, active; /* active: number of points that have a pressure */
    double *path, *load;   /* Taylor series of a step: path[k][1 + n] of x_0 + 1 and Q, load[k] of the load */
    long double eps;
    double one_minus_eps2, max_compression, max_load;
    double level, start, end;           /* level: the load that defines contact, 0 if unknown; start, end: its times */
    double *after, *integral, *average; /* energies of each mode; average may be NULL */
};

static void *take(size_t count, size_t bytes)
{
    void *const memory = calloc(count > 0 ? count : 1, bytes);
    if (memory == NULL)
        abort();
    return memory;
}

/* ---- bounds ---- */

/* Returns the rim position where the wall's force is negligible for the tolerance. */
static double negligible_position(const struct disk *disk)
{
    return fmin(0, (log(disk->effort->tolerance * disk->alpha * disk->speed * disk->speed) - MARGIN) / disk->alpha);
}

/* Bounds the displacement of the rim by free modes, as if all amplitudes had one sign. speed: bounds its velocity */
static double swing(const struct disk *disk, int speed)
{
    double sum = 0;
    for (size_t i = 0; i < disk->n; i++) {
        const struct cor_disk_mode *const m = &disk->mode[i];
        const double q = disk->path[1 + i], p = disk->path[2 + disk->n + i];
        sum += (fabs(m->c) + fabs(m->s)) * (speed ? hypot(m->omega * q, p) : hypot(q, p / m->omega));
    }
    return sum;
}

/* Returns the longest step in which the last two orders of the series change no velocity by more than the tolerance. */
static double step_allowed(const struct disk *disk)
{
    const size_t width = 1 + disk->n;
    double h = HUGE_VAL;
    for (int k = disk->effort->order; k <= disk->effort->order + 1; k++)
        for (size_t i = (size_t)k * width; i < (size_t)(k + 1) * width; i++)
            if (disk->path[i] != 0)
                h = fmin(h, pow(disk->effort->tolerance * disk->speed / (k * fabs(disk->path[i])), 1.0 / (k - 1)));
    return h;
}

/* ---- moments within a step, from its series ---- */

/* A polynomial: sum c_k t^k, k < count, or its slope. The coefficients are `apart` elements apart. */
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

/* Returns 1 or -1 if f rises or falls through a level between low and high, and sets *t to that time; otherwise 0. */
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

/* Adds the energies of the modes, integrated over the step up to t. */
static void integrate_energies(const struct disk *disk, double t, const double *from, double *to)
{
    static const double node[] = {0.18343464249564980, 0.52553240991632899, 0.79666647741362674, 0.96028985649753623},
                        weight[] = {0.36268378337836198, 0.31370664587788729, 0.22238103445337447, 0.10122853629037626};
    for (size_t i = 0; i < disk->n; i++) {
        double sum = 0;
        for (int j = 0; j < 8; j++) {
            const double at = t / 2 * (1 + (j % 2 ? node[j / 2] : -node[j / 2]));
            const struct track f = {disk->path + 1 + i, 1 + disk->n, disk->effort->order + 2, 0},
                               slope = {f.c, f.apart, f.count, 1};
            const double q = disk->mode[i].omega * track_at(&f, at), p = track_at(&slope, at);
            sum += weight[j / 2] * (p * p + q * q);
        }
        to[i] = from[i] + t / 2 * sum / (disk->speed * disk->speed);
    }
}

enum { SAMPLES = 8 };

/* Records the events in a step of length h from `time`: turning points of the centre, maxima of the load, and the times
 * at which the load crosses `level`. */
static void follow(struct disk *disk, double time, double h)
{
    const int count = disk->effort->order;
    const struct track depth = {disk->path, 1 + disk->n, count + 2, 0}, speed = {depth.c, depth.apart, count + 2, 1};
    const struct track load = {disk->load, 1, disk->active > 0 ? count : 0, 0}, change = {load.c, 1, load.count, 1};
    for (int j = 0; j < SAMPLES; j++) {
        const double low = h * j / (double)SAMPLES, high = h * (j + 1) / (double)SAMPLES;
        double t;
        if (passes(&speed, 0, low, high, &t) < 0)
            disk->max_compression = fmax(disk->max_compression, track_at(&depth, t));
        if (passes(&change, 0, low, high, &t) < 0)
            disk->max_load = fmax(disk->max_load, track_at(&load, t));
        const int level = disk->level > 0 ? passes(&load, disk->level, low, high, &t) : 0;
        if (level < 0) {
            disk->end = time + t;
            if (disk->average != NULL)
                integrate_energies(disk, t, disk->integral, disk->average);
        } else if (level > 0 && isnan(disk->start)) {
            disk->start = time + t;
            if (disk->average != NULL) /* subtracts the energies before the contact */
                integrate_energies(disk, t, disk->integral, disk->integral);
            for (size_t i = 0; disk->average != NULL && i < disk->n; i++)
                disk->integral[i] = -disk->integral[i];
        }
    }
    if (disk->average != NULL && !isnan(disk->start))
        integrate_energies(disk, h, disk->integral, disk->integral);
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
#include "reference_collision_run.h"
#undef REAL
#undef NAME

#if LDBL_MANT_DIG < 113 && defined __SIZEOF_FLOAT128__
#define HAVE_QUAD
__extension__ typedef __float128 quad;
#define REAL quad
#define NAME(x) quad_##x
/* Returns pi: the nearest long double plus the remainder. */
static quad quad_pi(void)
{
    return (quad)3.141592653589793238462643383279502884L + (quad)-5.0165576126683320235e-20L;
}
/* Computes exp(x) = 2^k exp(r/16)^16, |r| < 0.35, by Taylor's series. */
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
#include "reference_collision_run.h"
#undef REAL
#undef NAME
#endif

/* ---- runs until they agree ---- */

static int disk_collide(struct disk *disk)
{
#ifdef HAVE_QUAD
    if (disk->effort->wide)
        return quad_collide(disk);
#endif
    return long_collide(disk);
}

/* Returns the number of panels for about 16 digits. The pressure decays over the length alpha^(-2/3) at the edge of the
 * contact, and over alpha^(-1/2) in a small contact. A mode has up to n_max waves. */
static double panels_needed(const struct disk *disk)
{
    const double contact = sqrt(disk->speed) * pow(disk->alpha, 2.0 / 3);
    return 4 + 0.25 * contact + 0.06 * sqrt(disk->alpha) + 0.05 * (double)(disk->rows - 2);
}

static const struct effort efforts[] = {{0, 16, 0x1p-46, 0.8}, {0, 20, 0x1p-54, 1},   {0, 24, 0x1p-61, 1.3},
                                        {0, 26, 0x1p-63, 1.6}, {1, 28, 0x1p-73, 1.8}, {1, MOST_ORDER, 0x1p-92, 2.2}};

int reference_disk_collision(const struct cor_disk_mode *mode, size_t n, double alpha, double speed, double needed,
                             struct reference_collision *out, double *energy_after, double *energy_average)
{
    double *const memory = take(2 * n + (MOST_ORDER + 2) * (2 + n), sizeof(double));
    struct disk disk = {.mode = mode, .n = n, .rows = 2, .alpha = alpha, .speed = speed, .average = energy_average};
    for (size_t i = 0; i < n; i++)
        if (2 * (size_t)mode[i].n + 2 > disk.rows)
            disk.rows = 2 * (size_t)mode[i].n + 2;
    disk.after = memory;
    disk.integral = disk.after + n;
    disk.load = disk.integral + n;
    disk.path = disk.load + MOST_ORDER + 2;
    int status = 1;
    long double before = 0;
    for (size_t i = 0; status == 1 && i < sizeof efforts / sizeof *efforts; i++) {
        disk.effort = &efforts[i];
        disk.points = GAUSS * (size_t)ceil(efforts[i].panels * panels_needed(&disk));
        disk.level = disk.max_load / 1000;
        disk.max_compression = -HUGE_VAL;
        disk.max_load = 0;
        disk.start = disk.end = NAN;
        memset(disk.integral, 0, n * sizeof(double));
        if (disk_collide(&disk) != 0)
            status = 2;
        out->error = i == 0 ? HUGE_VAL : 4 * (double)fabsl(disk.eps - before);
        if (out->error <= needed)
            status = 0;
        before = disk.eps;
    }
    out->eps = (double)disk.eps;
    out->one_minus_eps2 = disk.one_minus_eps2;
    out->energy_drift = (double)(disk.eps * disk.eps + disk.one_minus_eps2 - 1);
    out->contact_time = disk.end - disk.start;
    out->max_compression = disk.max_compression;
    for (size_t i = 0; status != 2 && i < n; i++) {
        if (energy_after != NULL)
            energy_after[i] = disk.after[i];
        if (energy_average != NULL)
            energy_average[i] /= out->contact_time;
    }
    free(memory);
    return status;
}
