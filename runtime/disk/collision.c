/* SPDX-License-Identifier: MIT */
/* Full dynamics of a disk at a wall, (41) to (45).
 *
 * The Hamiltonian is free motion, which is exact (every mode turns, the centre drifts), plus the wall. One step is a kick
 * of the wall between two halves of free motion, with the potential V of the wall replaced by
 *
 *     V - (h^2/24) |grad V|^2/m                                                       (Takahashi and Imada, 1984)
 *
 * which costs one more passage from rim to modes and back, and no second exponential. As an integrator it is of order 2;
 * but it is conjugate, by a change of variables, to one of order 4, and that change does nothing where the wall does
 * nothing. So whatever is measured long before and long after the contact, eps among it, has an error c_4 h^4 + c_6 h^6 +
 * ...: even powers, for the step is symmetric. Runs with steps h, h/sqrt(2), h/2 ... are therefore extrapolated to h = 0
 * (Neville), and what the last extrapolation changes is the estimate of the error.
 *
 * Resonance: kicks at intervals h feed a pair of modes where (omega_i + omega_j) h is a multiple of 2 pi. All steps have
 * omega_max h < MAX_TURN < pi, and no pair comes near. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "cor/disk.h"
#include "cor/status.h"
#include "runtime/disk/collision.h"

#define PI 3.14159265358979323846
#define MASS PI

/* omega_max h, at most */
#define MAX_TURN 1.0
/* alpha v h, at most: the pressure's growth by exp(alpha v h) in a step at first contact */
#define MAX_RISE 0.8
/* h^2 alpha (acceleration of the rim), at most, else the step is cut: the frequency of rim and wall, times h, squared */
#define MAX_STIFFNESS 3.0
/* The wall's energy at the first and the last moment, relative to the disk's, over the tolerance: a collision near chaos
 * makes ten thousand times as much of it. */
#define WALL_LEFT 1e-6
/* What the angles may be off by, relative to the largest load, over the tolerance; eps is off by less than a tenth */
#define ANGLES_OFF 1.0
/* A run that moves eps by more than this is of a collision near chaos, which amplifies what angles are off by too; else
 * the first ones move it by 1e-5 to 1e-4. */
#define CALM 1e-4
enum { LEAST_PHI = 16 };
/* The estimate of the error, at most, over the tolerance */
#define STEP_SHARE 0.5

/* Largest n of a mode; a table with a larger one, by frequency, would have 10^9 modes. */
enum { MAX_N = 100000 };
/* Workspaces are cut in pieces of so many bytes. */
enum { ALIGNMENT = 64 };
/* Load at the ends of what counts as contact, over the largest */
#define CONTACT_LOAD 1e-3
/* Angles are looked at between two looks at all where their pressure is more than this part of the greatest, and the
 * run is repeated with a look at every step where one was missed with a pressure of that part of the load. */
#define WINDOW_EDGE 1e-26
#define WINDOW_MISSED 1e-14
/* ln of what stands for no load */
#define LOG_NO_LOAD (-1e3)
/* Steps of successive runs, and the tolerance that the largest safe step reaches within a few runs */
#define RATIO 1.4142135623730951
#define EASY_TOLERANCE 1e-8
/* Runs that one extrapolation uses, runs that it may take, and times that the first step may be cut */
enum { MAX_LEVELS = 6, MAX_RUNS = 12, MAX_CUTS = 12 };
/* After so many runs, the last one of which changed the answer by more than that part of what a run changed it some runs
 * before, no more are tried: where the collision is not chaotic, each run should do better by 4 at least. */
enum { PATIENCE = 9, RUNS_BEFORE = 4 };
#define HOPELESS 0.25
/* Steps between two looks at the whole quadrant; in between only the angles near the contact are looked at. */
enum { STEPS_A_LOOK = 8 };

/* ---- workspace ---- */

struct sizes {
    size_t modes, n_max, blocks, cells; /* cells: places for modes */
    size_t terms, points;               /* points: places for angles, at most */
    double omega_max;
};

struct motion {
    struct sizes size;
    struct cor_rim rim;
    const struct cor_collision_loops *loops;
    const struct cor_disk_mode *mode;
    double alpha, tolerance, speed;
    size_t phi, phi_limit; /* angles in use, and at most */
    size_t *place;         /* cell of each mode */
    struct cor_mode_block *block;
    double *c, *s, *q, *p, *cosine, *sine;
    double *force_c, *force_s, *sum_c, *sum_s; /* of each n */
    double *cc, *cs, *ss;                      /* of each n, the sums of C^2, C S, S^2 over the mass */
    double *d, *e, *shape, *flat, *weight, *reach, *pressure, *response, *by_point, *by_term, *table;
    double *after[MAX_LEVELS], *average[MAX_LEVELS];
};

static size_t panels(size_t n)
{
    return (n + COR_PANEL - 1) / COR_PANEL * COR_PANEL;
}

/* Modes of the n that share the block, as many as the fullest of them has */
static size_t rows_of_block(const struct cor_disk_mode *mode, size_t modes, size_t block)
{
    size_t count[COR_LANES] = {0}, most = 0;
    for (size_t i = 0; i < modes; i++)
        if ((size_t)mode[i].n / COR_LANES == block)
            count[(size_t)mode[i].n % COR_LANES]++;
    for (size_t i = 0; i < COR_LANES; i++)
        most = count[i] > most ? count[i] : most;
    return most;
}

/* Angles on the quadrant that the tolerance needs at a speed. At the contact's edge the pressure falls off over
 * alpha^(-2/3); the rest is fitted to where angles_off is about the tolerance. */
static double phi_needed(double alpha, double tolerance, double speed, size_t n_max)
{
    const double fast = speed / 0.1, digits = fmax(-log10(tolerance), 3);
    return pow(alpha, 2.0 / 3) * (0.2 * digits - 0.05) * pow(fast, fast < 1 ? 0.25 : 0.6) + 0.25 * (double)n_max;
}

/* Most angles that are tried; the fit may be wrong by some. */
static size_t phi_limit(const struct cor_disk_collision_options *options, size_t n_max)
{
    if (options->phi_points > 0)
        return options->phi_points;
    const double limit = 2.5 * phi_needed(options->alpha, options->tolerance, COR_DISK_COLLISION_MAX_SPEED, n_max);
    return (size_t)fmin(fmax(limit, LEAST_PHI), COR_DISK_COLLISION_MAX_PHI_POINTS);
}

static struct sizes sizes_of(const struct cor_disk_mode *mode, size_t modes,
                             const struct cor_disk_collision_options *options)
{
    struct sizes size = {modes, 0, 0, 0, 0, 0, 0};
    for (size_t i = 0; i < modes; i++) {
        size.n_max = (size_t)mode[i].n > size.n_max ? (size_t)mode[i].n : size.n_max;
        size.omega_max = fmax(size.omega_max, mode[i].omega);
    }
    size.blocks = size.n_max / COR_LANES + 1;
    for (size_t b = 0; b < size.blocks; b++)
        size.cells += rows_of_block(mode, modes, b) * COR_LANES;
    size.terms = panels(size.n_max + 2);
    size.points = panels(phi_limit(options, size.n_max));
    return size;
}

/* Takes n elements of so many bytes from *at, which only counts while base is NULL. */
static void *take(char *base, size_t *at, size_t n, size_t bytes)
{
    void *const here = base == NULL ? NULL : base + *at;
    *at += (n * bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    return here;
}

/* Sets the arrays of *m, whose sizes are known; their bytes. */
static size_t arrange(struct motion *m, char *base)
{
    const struct sizes *size = &m->size;
    const size_t lanes = size->blocks * COR_LANES, real = sizeof(double);
    size_t at = 0;
    m->place = take(base, &at, size->modes, sizeof *m->place);
    m->block = take(base, &at, size->blocks, sizeof *m->block);
    double **const of_cells[] = {&m->c, &m->s, &m->q, &m->p, &m->cosine, &m->sine};
    for (size_t i = 0; i < sizeof of_cells / sizeof *of_cells; i++)
        *of_cells[i] = take(base, &at, size->cells, real);
    double **const of_n[] = {&m->force_c, &m->force_s, &m->sum_c, &m->sum_s, &m->cc, &m->cs, &m->ss};
    for (size_t i = 0; i < sizeof of_n / sizeof *of_n; i++)
        *of_n[i] = take(base, &at, lanes, real);
    double **const of_terms[] = {&m->d, &m->e};
    for (size_t i = 0; i < sizeof of_terms / sizeof *of_terms; i++)
        *of_terms[i] = take(base, &at, size->terms + lanes, real);
    double **const of_points[] = {&m->shape, &m->flat, &m->weight, &m->reach, &m->pressure, &m->response};
    for (size_t i = 0; i < sizeof of_points / sizeof *of_points; i++)
        *of_points[i] = take(base, &at, size->points, real);
    m->by_point = take(base, &at, size->points * size->terms, real);
    m->by_term = take(base, &at, size->points * size->terms, real);
    m->table = take(base, &at, 4 * size->points, real);
    for (size_t i = 0; i < MAX_LEVELS; i++) {
        m->after[i] = take(base, &at, size->modes, real);
        m->average[i] = take(base, &at, size->modes, real);
    }
    return at;
}

static const struct cor_collision_loops *widest_loops(void)
{
#define COLLISION_ROW(set) &cor_collision_##set,
    static const struct cor_collision_loops *const loops[] = {COR_EACH_SET(COLLISION_ROW)};
    return loops[cor_widest_set()];
}

/* Sets the angles phi_j = j pi/(2 phi) of the trapezoidal rule, to which the angle pi/2 adds nothing, and cos(k phi_j). */
static void set_angles(struct motion *m, size_t phi)
{
    const size_t terms = m->size.terms, points = panels(phi);
    m->phi = phi;
    for (size_t i = 0; i < phi; i++) { /* a quarter of a turn each */
        m->table[i] = cos((double)i * (PI / (2 * (double)phi)));
        m->table[phi + i] = -sin((double)i * (PI / (2 * (double)phi)));
        m->table[2 * phi + i] = -m->table[i];
        m->table[3 * phi + i] = -m->table[phi + i];
    }
    for (size_t j = 0; j < points; j++) {
        const double half_sine = sin((double)j * (PI / (4 * (double)phi)));
        m->shape[j] = -2 * half_sine * half_sine;
        m->flat[j] = 0;
        m->weight[j] = j == 0 ? PI / (2 * (double)phi) : j < phi ? PI / (double)phi : 0;
        for (size_t k = 0; k < terms; k++) {
            const double value = j < phi && k < m->size.n_max + 2 ? m->table[k * j % (4 * phi)] : 0;
            m->by_point[(j / COR_PANEL * terms + k) * COR_PANEL + j % COR_PANEL] = value;
            m->by_term[(k / COR_PANEL * points + j) * COR_PANEL + k % COR_PANEL] = value;
        }
    }
    const struct cor_rim rim = {m->size.blocks, m->block, m->c,        m->s,      m->size.n_max + 2,
                                terms,          points,   m->by_point, m->by_term};
    m->rim = rim;
}

static void fill_modes(struct motion *m)
{
    const struct sizes *size = &m->size;
    const size_t lanes = size->blocks * COR_LANES;
    size_t first = 0;
    for (size_t b = 0; b < size->blocks; b++) {
        m->block[b].first = first;
        m->block[b].rows = rows_of_block(m->mode, size->modes, b);
        first += m->block[b].rows;
    }
    memset(m->c, 0, size->cells * sizeof *m->c);
    memset(m->s, 0, size->cells * sizeof *m->s);
    memset(m->cc, 0, lanes * sizeof *m->cc);
    memset(m->cs, 0, lanes * sizeof *m->cs);
    memset(m->ss, 0, lanes * sizeof *m->ss);
    double *const filled = m->sum_c; /* rows of each lane so far */
    memset(filled, 0, lanes * sizeof *filled);
    for (size_t i = 0; i < size->modes; i++) {
        const struct cor_disk_mode *mode = &m->mode[i];
        const size_t n = (size_t)mode->n, row = (size_t)filled[n]++;
        const size_t cell = (m->block[n / COR_LANES].first + row) * COR_LANES + n % COR_LANES;
        const double unit = 1 / sqrt(MASS * mode->omega);
        m->place[i] = cell;
        m->c[cell] = unit * mode->c;
        m->s[cell] = unit * mode->s;
        m->cc[n] += mode->c * mode->c / MASS;
        m->cs[n] += mode->c * mode->s / MASS;
        m->ss[n] += mode->s * mode->s / MASS;
    }
}

/* ---- one run with steps of one size ---- */

/* How a run ends */
enum outcome { ENDED, TOO_STIFF, TOO_NARROW, TOO_LONG };

/* What is looked for between steps is found on the polynomial through five moments, h apart. */
enum { MOMENTS = 5 };

struct course {
    double depth[MOMENTS], log_load[MOMENTS]; /* the last one last */
};

struct run {
    double h;
    int number; /* 0 for the first one */
    int wide;   /* look at the whole quadrant at every step */
    size_t steps;
    double eps, max_compression, contact_time;
    double max_load, ripple; /* of the pressure: what the rule with half the angles gets wrong of the load, at most */
    double start, end;       /* of the contact, NaN if that is not known */
};

struct state {
    double time, v;     /* v before the kick */
    double depth;       /* x_0 + 1, which keeps digits that x_0 near -1 would lose times alpha */
    double load, force; /* the wall's force and what it is with the modified potential */
    size_t window;
};

/* Reach and pressure on the rim, the first `points` places of it */
static double touch(struct motion *m, double depth, size_t points)
{
    m->loops->gather(&m->rim, m->sum_c, m->sum_s, m->d);
    m->loops->reach(&m->rim, points, depth, m->shape, m->d, m->reach);
    return m->loops->press(points, m->alpha, m->weight, m->reach, m->pressure);
}

/* Angles that matter until the next look, in whole panels: where the pressure is a `negligible` part of the greatest. */
static size_t window_of(const struct motion *m, double negligible)
{
    double greatest = 0;
    size_t last = 0;
    for (size_t j = 0; j < m->phi; j++)
        greatest = fmax(greatest, m->pressure[j]);
    for (size_t j = 0; j < m->phi; j++)
        if (m->pressure[j] > negligible * greatest)
            last = j;
    return panels(last + 1);
}

/* Puts what the modified potential pushes with in place of the pressure, and its moments in e; returns the force, and
 * the largest h^2 alpha (acceleration of the rim) in *stiffness. */
static double modify(struct motion *m, double h, double load, size_t points, double *stiffness)
{
    double greatest, *const sum_c = m->force_c, *const sum_s = m->force_s;
    m->loops->transform(&m->rim, points, m->pressure, m->e);
    m->loops->split(&m->rim, 1, m->e, m->force_c, m->force_s);
    for (size_t n = 0; n < m->rim.blocks * COR_LANES; n++) {
        const double force_c = m->force_c[n], force_s = m->force_s[n];
        sum_c[n] = m->cc[n] * force_c + m->cs[n] * force_s;
        sum_s[n] = m->cs[n] * force_c + m->ss[n] * force_s;
    }
    m->loops->gather(&m->rim, sum_c, sum_s, m->d);
    m->loops->reach(&m->rim, points, load / MASS, m->flat, m->d, m->response);
    const double force = m->loops->soften(points, h * h * m->alpha / 12, m->response, m->pressure, &greatest);
    *stiffness = h * h * m->alpha * greatest;
    m->loops->transform(&m->rim, points, m->pressure, m->e);
    return force;
}

/* What the load would change by with half the angles */
static double ripple_of(const struct motion *m)
{
    double even = 0, odd = 0;
    for (size_t j = 0; j < m->rim.points; j += 2) {
        even += m->pressure[j];
        odd += m->pressure[j + 1];
    }
    return fabs(even - odd);
}

/* The polynomial through five values at -2 ... 2 */
static void interpolate(const double f[MOMENTS], double c[MOMENTS])
{
    c[0] = f[2];
    c[1] = (8 * (f[3] - f[1]) - (f[4] - f[0])) / 12;
    c[2] = (16 * (f[1] + f[3]) - (f[0] + f[4]) - 30 * f[2]) / 24;
    c[3] = ((f[4] - f[0]) - 2 * (f[3] - f[1])) / 12;
    c[4] = ((f[0] + f[4]) - 4 * (f[1] + f[3]) + 6 * f[2]) / 24;
}

/* The largest of values whose middle one is the largest */
static double top(const double f[MOMENTS])
{
    double c[MOMENTS], low = -1, high = 1;
    interpolate(f, c);
    for (int i = 0; i < 50; i++) {
        const double t = 0.5 * (low + high);
        if (c[1] + t * (2 * c[2] + t * (3 * c[3] + t * 4 * c[4])) > 0)
            low = t;
        else
            high = t;
    }
    return c[0] + low * (c[1] + low * (c[2] + low * (c[3] + low * c[4])));
}

/* Where, from 0 at the middle one to 1 at the next, values pass `level` between these two */
static double crossing(const double f[MOMENTS], double level)
{
    double c[MOMENTS], low = 0, high = 1;
    const int rises = f[3] > f[2];
    interpolate(f, c);
    for (int i = 0; i < 50; i++) {
        const double t = 0.5 * (low + high);
        if ((c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4]))) < level) == rises)
            low = t;
        else
            high = t;
    }
    return 0.5 * (low + high);
}

static int has_top(const double f[MOMENTS])
{
    return f[2] >= f[1] && f[2] > f[3];
}

/* Follows depth and load of one more moment.
 *
 * With the wall's force F the integrator's x is y - (h^2/12) F(y)/m, y the true position as far as order 4 (Numerov's
 * method, in other words), and the force of its modified potential at x is that of the true one at y. */
static void follow(struct run *run, struct course *course, const struct state *now, double log_threshold)
{
    const double h = run->h, *const load = course->log_load;
    memmove(course->depth, course->depth + 1, (MOMENTS - 1) * sizeof *course->depth);
    memmove(course->log_load, course->log_load + 1, (MOMENTS - 1) * sizeof *course->log_load);
    course->depth[MOMENTS - 1] = now->depth - h * h / 12 * now->force / MASS;
    course->log_load[MOMENTS - 1] = now->force > 0 ? log(now->force) : LOG_NO_LOAD;
    if (run->steps < MOMENTS)
        return;
    if (has_top(course->depth))
        run->max_compression = fmax(run->max_compression, top(course->depth));
    if (has_top(load))
        run->max_load = fmax(run->max_load, exp(top(load)));
    const int above = load[3] >= log_threshold;
    if (above != (load[2] >= log_threshold)) {
        const double t = now->time + h * (crossing(load, log_threshold) - 2);
        if (!above)
            run->end = t;
        else if (isnan(run->start))
            run->start = t;
    }
}

/* Part of the interval from `time` to `time` + h, h < 0 too, between start and end, under a weight that falls from 1 at
 * `time` to 0: what a value at `time` counts in an integral over straight pieces. */
static double hat(double time, double h, double start, double end)
{
    const double a = fmin(fmax((start - time) / h, 0), 1), b = fmin(fmax((end - time) / h, 0), 1);
    const double from = fmin(a, b), to = fmax(a, b);
    return fabs(h) * ((to - from) - 0.5 * (to * to - from * from));
}

/* Energy of a mode with half of the kick that is to come, not so at the end, where there is none */
static double energy_of_mode(const struct motion *m, size_t i)
{
    const size_t cell = m->place[i], n = (size_t)m->mode[i].n;
    const double q = m->q[cell];
    const double p = m->p[cell] + 0.5 * (m->c[cell] * m->force_c[n] + m->s[cell] * m->force_s[n]);
    return 0.5 * m->mode[i].omega * (q * q + p * p);
}

/* Tells of positions as far as order 4, see follow, and of velocities as far as order 2. */
static void tell(const struct motion *m, const struct cor_disk_collision_detail *detail, const struct state *now,
                 double h)
{
    for (size_t i = 0; i < m->size.modes; i++) {
        const size_t cell = m->place[i], n = (size_t)m->mode[i].n;
        const double omega = m->mode[i].omega, unit = 1 / sqrt(MASS * omega);
        const double kick = m->c[cell] * m->force_c[n] + m->s[cell] * m->force_s[n];
        if (detail->q != NULL)
            detail->q[i] = unit * (m->q[cell] + h * omega / 12 * kick);
        if (detail->q_dot != NULL)
            detail->q_dot[i] = omega * unit * (m->p[cell] + 0.5 * kick);
    }
    const double acceleration = -now->force / MASS;
    const struct cor_disk_moment moment = {now->time, now->depth + h * h / 12 * acceleration - 1,
                                           now->v + 0.5 * h * acceleration, now->force, now->force / m->alpha};
    detail->observe(detail->context, &moment);
}

/* How far any part of the rim can swing out of its round shape while nothing pushes */
static double greatest_swing(const struct motion *m)
{
    double swing = 0;
    for (size_t i = 0; i < m->size.cells; i++)
        swing += fmax(fabs(m->c[i]), fabs(m->s[i])) * sqrt(m->q[i] * m->q[i] + m->p[i] * m->p[i]);
    return swing;
}

/* Load of the wall that moves nothing that counts, well below that of a contact too */
static double negligible_load(const struct motion *m)
{
    return WALL_LEFT * fmin(m->tolerance, 1e-4) * 0.5 * MASS * m->speed * m->speed * m->alpha;
}

/* When a disk that keeps its shape comes to a load of that size: sqrt(2 pi/alpha) exp(alpha (x_0 + 1)) */
static double first_moment(const struct motion *m)
{
    return log(negligible_load(m) * sqrt(m->alpha / (2 * PI))) / (m->alpha * m->speed);
}

static void begin(struct motion *m, struct run *run)
{
    const size_t cells = m->size.cells, lanes = m->size.blocks * COR_LANES;
    memset(m->q, 0, cells * sizeof *m->q);
    memset(m->p, 0, cells * sizeof *m->p);
    memset(m->cosine, 0, cells * sizeof *m->cosine);
    memset(m->sine, 0, cells * sizeof *m->sine);
    for (size_t i = 0; i < m->size.modes; i++) {
        m->cosine[m->place[i]] = cos(m->mode[i].omega * run->h);
        m->sine[m->place[i]] = sin(m->mode[i].omega * run->h);
    }
    memset(m->force_c, 0, lanes * sizeof *m->force_c);
    memset(m->force_s, 0, lanes * sizeof *m->force_s);
    memset(m->e, 0, (m->size.terms + lanes) * sizeof *m->e);
    memset(m->sum_c, 0, lanes * sizeof *m->sum_c);
    memset(m->sum_s, 0, lanes * sizeof *m->sum_s);
    run->steps = 0;
    run->max_load = run->ripple = 0;
    run->max_compression = -INFINITY;
    run->start = run->end = NAN;
}

/* The state at the first moment, to first order in the wall's force, which grows like exp(sigma t) then, sigma = alpha v:
 * Q'' + omega^2 Q = F/m gives Q = F/(m (omega^2 + sigma^2)), and the centre has given the wall its energy. The kick of
 * that moment is half done before it. */
static void approach(struct motion *m, struct run *run, struct state *now)
{
    const double sigma = m->alpha * m->speed, energy = 0.5 * MASS * m->speed * m->speed;
    now->depth = m->speed * now->time;
    now->load = touch(m, now->depth, m->rim.points);
    m->loops->transform(&m->rim, m->rim.points, m->pressure, m->e);
    m->loops->split(&m->rim, -1, m->e, m->force_c, m->force_s);
    for (size_t i = 0; i < m->size.modes; i++) {
        const size_t cell = m->place[i], n = (size_t)m->mode[i].n;
        const double omega = m->mode[i].omega;
        const double force = m->c[cell] * m->force_c[n] + m->s[cell] * m->force_s[n];
        m->q[cell] = omega * force / (omega * omega + sigma * sigma);
        m->p[cell] = sigma / omega * m->q[cell];
    }
    m->loops->split(&m->rim, -0.5 * run->h, m->e, m->force_c, m->force_s);
    now->v = m->speed * sqrt(1 - now->load / (m->alpha * energy)) - 0.5 * run->h * now->load / MASS;
}

/* One collision with steps h. average, if not NULL, gets the mean energy of each mode over the contact of `before`, a
 * run with larger steps, whose largest load also says what a contact is; before is NULL in the first run. */
static enum outcome collide(struct motion *m, struct run *run, const struct run *before, double *average,
                            const struct cor_disk_collision_detail *detail)
{
    const double h = run->h, energy = 0.5 * MASS * m->speed * m->speed, negligible = negligible_load(m);
    /* the farthest that a rim with that load can reach */
    const double clear = log(negligible / PI) / m->alpha;
    const double log_threshold = before == NULL ? INFINITY : log(CONTACT_LOAD * before->max_load);
    struct state now = {first_moment(m), m->speed, 0, 0, 0, m->rim.points};
    const double contact = before == NULL ? 0 : before->end - before->start;
    struct course course;
    memset(&course, 0, sizeof course);
    begin(m, run);
    if (average != NULL)
        memset(average, 0, m->size.modes * sizeof *average);
    /* there and back takes twice as long at least */
    if (-2 * now.time > h * COR_DISK_COLLISION_MAX_STEPS)
        return TOO_LONG;
    approach(m, run, &now);
    for (;;) {
        if (run->steps == COR_DISK_COLLISION_MAX_STEPS)
            return TOO_LONG;
        const int look = run->wide || run->steps % STEPS_A_LOOK == 0;
        m->loops->turn(&m->rim, m->q, m->p, m->cosine, m->sine, m->force_c, m->force_s, m->sum_c, m->sum_s);
        now.depth += h * now.v;
        now.time += h;
        run->steps++;
        now.load = touch(m, now.depth, look ? m->rim.points : now.window);
        if (!(now.load < INFINITY))
            return TOO_STIFF;
        now.force = 0;
        memset(m->force_c, 0, m->size.blocks * COR_LANES * sizeof *m->force_c);
        memset(m->force_s, 0, m->size.blocks * COR_LANES * sizeof *m->force_s);
        if (look) {
            run->ripple = fmax(run->ripple, ripple_of(m));
            const size_t had = now.window;
            now.window = window_of(m, WINDOW_EDGE);
            if (!run->wide && run->steps > 1)
                for (size_t j = had; j < m->rim.points; j++)
                    if (m->pressure[j] > WINDOW_MISSED * now.load)
                        return TOO_NARROW;
        }
        if (now.load > 1e-3 * negligible) {
            double stiffness;
            now.force = modify(m, h, now.load, now.window, &stiffness);
            if (!(stiffness < MAX_STIFFNESS))
                return TOO_STIFF;
            m->loops->split(&m->rim, -h, m->e, m->force_c, m->force_s);
        }
        follow(run, &course, &now, log_threshold);
        if (average != NULL) {
            const double weight =
                hat(now.time, h, before->start, before->end) + hat(now.time, -h, before->start, before->end);
            if (weight > 0)
                for (size_t i = 0; i < m->size.modes; i++)
                    average[i] += weight / (contact * energy) * energy_of_mode(m, i);
        }
        if (detail != NULL && detail->observe != NULL)
            tell(m, detail, &now, h);
        now.v -= h * now.force / MASS;
        if (look && now.v < 0 && now.load < negligible && now.depth + greatest_swing(m) < clear)
            break;
    }
    run->eps = -now.v / m->speed;
    run->contact_time = run->end - run->start;
    return ENDED;
}

/* ---- extrapolation ---- */

/* What the last `levels` runs count in the extrapolation to h = 0 of a series in h^first, h^(first + 2), ...: Neville's
 * scheme, of which each run is RATIO^2 = 2 in h^2 ahead of the next. */
static void weights_of(int levels, int first, double weight[MAX_LEVELS])
{
    double row[MAX_LEVELS][MAX_LEVELS];
    memset(row, 0, sizeof row);
    for (int i = 0; i < levels; i++)
        row[i][i] = 1;
    for (int j = 1; j < levels; j++) {
        const double ratio = ldexp(1, first / 2 + j - 1);
        for (int i = levels - 1; i >= j; i--)
            for (int k = 0; k < levels; k++)
                row[i][k] += (row[i][k] - row[i - 1][k]) / (ratio - 1);
    }
    memcpy(weight, row[levels - 1], MAX_LEVELS * sizeof *weight);
}

/* eps of the runs, extrapolated */
static double extrapolated_eps(const struct run *run, int levels)
{
    double weight[MAX_LEVELS], eps = 0;
    weights_of(levels, 4, weight);
    for (int k = 0; k < levels; k++)
        eps += weight[k] * run[k].eps;
    return eps;
}

/* The first step tried: as large as stays safe and, for small tolerances, so that three or four runs suffice. */
static double first_step(const struct motion *m)
{
    const double safe = fmin(MAX_TURN / m->size.omega_max, MAX_RISE / (m->alpha * m->speed));
    return safe * fmin(1, pow(m->tolerance / EASY_TOLERANCE, 1.0 / 8));
}

/* The pressure's harmonics fall off exponentially. With phi angles the harmonic 4 phi - k stands in for k, the worst is
 * that for the largest k; with half the angles, 2 phi stands in for the load, which says how fast they fall off. shaken:
 * by how much a run has moved eps, at most. */
static double angles_off(const struct motion *m, const struct run *run, double shaken)
{
    const double room = 2 - 0.5 * (double)m->size.n_max / (double)m->phi;
    return room > 0 ? pow(run->ripple / run->max_load, room) * fmax(1, shaken / CALM) : 1;
}

static int too_coarse(const struct motion *m, const struct run *run, double shaken)
{
    return m->phi < m->phi_limit && angles_off(m, run, shaken) > ANGLES_OFF * m->tolerance;
}

static void more_angles(struct motion *m)
{
    const size_t phi = m->phi + m->phi / 4 + 1;
    set_angles(m, phi < m->phi_limit ? phi : m->phi_limit);
}

/* Results of the first `levels` runs; returns by how much extrapolation leaves modes with less energy than none, which
 * is counted as none. */
static double conclude(const struct motion *m, const struct run *run, int levels, struct cor_disk_collision *out,
                       double *energy_after)
{
    double less_than_none = 0;
    double weight[MAX_LEVELS];
    const struct cor_disk_collision none = {0, 0, 0, 0, 0, run[levels - 1].steps};
    *out = none;
    weights_of(levels, 4, weight);
    for (int k = 0; k < levels; k++) {
        out->eps += weight[k] * run[k].eps;
        out->max_compression += weight[k] * run[k].max_compression;
    }
    for (size_t i = 0; i < m->size.modes; i++) {
        double after = 0;
        for (int k = 0; k < levels; k++)
            after += weight[k] * m->after[k][i];
        less_than_none += fmax(-after, 0);
        after = fmax(after, 0);
        out->one_minus_eps2 += after;
        if (energy_after != NULL)
            energy_after[i] = after;
    }
    out->energy_drift = out->eps * out->eps + out->one_minus_eps2 - 1;
    const int first = run[0].number < 1; /* that run does not know what a contact is */
    weights_of(levels - first, 4, weight);
    for (int k = first; k < levels; k++)
        out->contact_time += weight[k - first] * run[k].contact_time;
    return less_than_none;
}

/* The first run that averages is number 2: they are over the contact of the run before, which needs the largest load of
 * the one before it. */
static void conclude_averages(const struct motion *m, const struct run *run, int levels, double *energy_average)
{
    double weight[MAX_LEVELS];
    const int first = run[0].number < 2 ? 2 - run[0].number : 0;
    weights_of(levels - first, 2, weight);
    for (size_t i = 0; i < m->size.modes; i++) {
        double average = 0;
        for (int k = first; k < levels; k++)
            average += weight[k - first] * m->average[k][i];
        energy_average[i] = fmax(average, 0);
    }
}

/* The run after those before it, as wide as need be */
static enum outcome next_run(struct motion *m, struct run *run, int level, double h, int averages)
{
    struct run *const this_run = &run[level];
    const struct run *const before = level > 0 ? &run[level - 1] : NULL;
    const int number = before == NULL ? 0 : before->number + 1;
    double *const average = averages && number >= 2 ? m->average[level] : NULL;
    memset(this_run, 0, sizeof *this_run);
    this_run->h = h;
    this_run->number = number;
    this_run->wide = before != NULL && before->wide;
    enum outcome outcome = collide(m, this_run, before, average, NULL);
    if (outcome == TOO_NARROW) {
        this_run->wide = 1;
        outcome = collide(m, this_run, before, average, NULL);
    }
    return outcome;
}

/* Forgets the first run. */
static void forget(struct motion *m, struct run *run)
{
    double *const after = m->after[0], *const average = m->average[0];
    memmove(run, run + 1, (MAX_LEVELS - 1) * sizeof *run);
    memmove(m->after, m->after + 1, (MAX_LEVELS - 1) * sizeof *m->after);
    memmove(m->average, m->average + 1, (MAX_LEVELS - 1) * sizeof *m->average);
    m->after[MAX_LEVELS - 1] = after;
    m->average[MAX_LEVELS - 1] = average;
}

/* Runs with smaller and smaller steps until their extrapolation to h = 0 settles. */
static int extrapolate(struct motion *m, struct cor_disk_collision *out, const struct cor_disk_collision_detail *detail)
{
    const struct cor_disk_collision unknown = {NAN, NAN, NAN, NAN, NAN, 0};
    const int averages = detail != NULL && detail->energy_average != NULL, least_runs = averages ? 3 : 2;
    struct run run[MAX_LEVELS + 1]; /* the kept ones, and what the next one is before it is kept */
    double moved[MAX_RUNS] = {0};   /* by how much each run moved the answer */
    int levels = 0, runs = 0, cuts = 0, settled = 0, hopeless = 0;
    double h = first_step(m), change = 0, shaken = 0;
    while (runs < MAX_RUNS && !hopeless && (!settled || runs < least_runs)) {
        if (levels == MAX_LEVELS) {
            forget(m, run);
            levels--;
        }
        const enum outcome outcome = next_run(m, run, levels, h, averages);
        if (outcome == TOO_LONG || (outcome != ENDED && cuts == MAX_CUTS)) {
            *out = unknown;
            out->steps = run[levels].steps;
            return outcome == TOO_LONG ? COR_CONTACT_NOT_ENDED : COR_TOLERANCE_NOT_REACHED;
        }
        const int coarse = outcome == ENDED && too_coarse(m, &run[levels], shaken);
        if (coarse)
            more_angles(m);
        else
            h /= RATIO;
        if (coarse || outcome != ENDED) { /* what was done so far is worth as little */
            levels = runs = settled = 0;
            cuts += !coarse;
            continue;
        }
        for (size_t i = 0; i < m->size.modes; i++)
            m->after[levels][i] = energy_of_mode(m, i) / (0.5 * MASS * m->speed * m->speed);
        levels++;
        runs++;
        if (settled || levels < 2) /* a run that only averages need, or the first one */
            continue;
        const double answer_before = extrapolated_eps(run, levels - 1);
        const double less_than_none = conclude(m, run, levels, out, detail == NULL ? NULL : detail->energy_after);
        const double change_before = change;
        change = fabs(out->eps - extrapolated_eps(run + 1, levels - 1));
        moved[runs - 1] = fabs(out->eps - answer_before);
        shaken = fmax(shaken, moved[runs - 1]);
        /* The change is what the last of ever higher orders does, which is little anyway where steps are still too large
         * to extrapolate: the answer then moves as much as before, and modes are left with less energy than none. */
        const double motion = moved[runs - 1] < 0.5 * moved[runs - 2] ? 0.1 * moved[runs - 1] : moved[runs - 1];
        /* one change may be small by chance */
        const double estimate =
            fmax(runs > 2 ? fmax(fmax(change, 0.1 * change_before), motion) : 5 * change, 0.5 * less_than_none);
        settled = estimate <= STEP_SHARE * m->tolerance;
        if (settled && too_coarse(m, &run[levels - 1], shaken)) { /* as this run has shown */
            more_angles(m);
            h = run[levels - 1].h;
            levels = runs = settled = 0;
            continue;
        }
        hopeless = runs >= PATIENCE && moved[runs - 1] > HOPELESS * moved[runs - 1 - RUNS_BEFORE];
    }
    if (averages)
        conclude_averages(m, run, levels, detail->energy_average);
    const int enough = angles_off(m, &run[levels - 1], shaken) <= ANGLES_OFF * m->tolerance;
    if (detail != NULL && detail->observe != NULL)
        collide(m, &run[levels - 1], &run[levels - 2], NULL, detail);
    return settled && enough ? COR_OK : COR_TOLERANCE_NOT_REACHED;
}

/* ---- calls ---- */

/* COR_OK, or what is wrong with the table and the options */
static int check(const struct cor_disk_modes *modes, size_t n_modes, const struct cor_disk_collision_options *options)
{
    if (modes == NULL || modes->mode == NULL || options == NULL)
        return COR_ERROR_NULL;
    if (!(modes->nu > -1 && modes->nu < 1))
        return COR_ERROR_DISK_POISSON_RATIO;
    if (n_modes < 1 || n_modes > modes->count)
        return COR_ERROR_MODES;
    for (size_t i = 0; i < n_modes; i++) {
        const struct cor_disk_mode *mode = &modes->mode[i];
        if (mode->n < 0 || mode->n > MAX_N || !(mode->omega > 0 && mode->omega < INFINITY) || !isfinite(mode->c) ||
            !isfinite(mode->s) || (i > 0 && !(mode->omega > mode[-1].omega)))
            return COR_ERROR_MODES;
    }
    if (!(options->tolerance >= COR_DISK_COLLISION_MIN_TOLERANCE && options->tolerance < 1))
        return COR_ERROR_TOLERANCE;
    if (!(options->alpha >= COR_DISK_COLLISION_MIN_ALPHA && options->alpha <= COR_DISK_COLLISION_MAX_ALPHA))
        return COR_ERROR_ALPHA;
    if (options->phi_points > COR_DISK_COLLISION_MAX_PHI_POINTS)
        return COR_ERROR_PHI_POINTS;
    return COR_OK;
}

size_t cor_disk_collision_workspace(const struct cor_disk_modes *modes, size_t n_modes,
                                    const struct cor_disk_collision_options *options)
{
    if (check(modes, n_modes, options) != COR_OK)
        return 0;
    struct motion m;
    m.size = sizes_of(modes->mode, n_modes, options);
    return arrange(&m, NULL) + ALIGNMENT; /* the workspace may begin anywhere */
}

int cor_disk_collision_in(void *workspace, size_t bytes, const struct cor_disk_modes *modes, size_t n_modes,
                          const struct cor_disk_collision_options *options, double speed,
                          struct cor_disk_collision *out, const struct cor_disk_collision_detail *detail)
{
    const int status = check(modes, n_modes, options);
    if (status != COR_OK)
        return status;
    if (workspace == NULL || out == NULL)
        return COR_ERROR_NULL;
    if (!(speed <= COR_DISK_COLLISION_MAX_SPEED))
        return COR_ERROR_SPEED;
    struct motion m;
    memset(&m, 0, sizeof m);
    m.size = sizes_of(modes->mode, n_modes, options);
    const size_t misfit = (size_t)((uintptr_t)workspace % ALIGNMENT), skip = misfit > 0 ? ALIGNMENT - misfit : 0;
    if (bytes < arrange(&m, NULL) + ALIGNMENT)
        return COR_ERROR_WORKSPACE;
    if (speed <= 0) {
        const struct cor_disk_collision none = {NAN, NAN, 0, NAN, 0, 0};
        *out = none;
        return COR_WALL_NOT_TOUCHED;
    }
    arrange(&m, (char *)workspace + skip);
    m.mode = modes->mode;
    m.alpha = options->alpha;
    m.tolerance = options->tolerance;
    m.speed = speed;
    m.loops = widest_loops();
    m.phi_limit = phi_limit(options, m.size.n_max);
    fill_modes(&m);
    const double phi = fmax(phi_needed(m.alpha, m.tolerance, speed, m.size.n_max), LEAST_PHI);
    set_angles(&m, options->phi_points > 0 || phi > (double)m.phi_limit ? m.phi_limit : (size_t)phi);
    return extrapolate(&m, out, detail);
}

int cor_disk_collision(const struct cor_disk_modes *modes, size_t n_modes,
                       const struct cor_disk_collision_options *options, double speed, struct cor_disk_collision *out)
{
    const int status = check(modes, n_modes, options);
    if (status != COR_OK)
        return status;
    const size_t bytes = cor_disk_collision_workspace(modes, n_modes, options);
    void *const workspace = malloc(bytes);
    if (workspace == NULL)
        return COR_ERROR_MEMORY;
    const int result = cor_disk_collision_in(workspace, bytes, modes, n_modes, options, speed, out, NULL);
    free(workspace);
    return result;
}
