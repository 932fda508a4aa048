/* SPDX-License-Identifier: MIT */
/* One level of the sequence: the modes below Omega, with a smooth cutoff, and a rigid wall. docs/theory-disks.md, 17.
 *
 * Lengths, forces and amplitudes are in units of the speed v, so that nothing underflows for slow disks. Under kicks at
 * intervals h a mode has the static compliance (h/(2 omega)) cot(omega h/2) instead of 1/omega^2. The compliance that
 * acts at once is the static compliance of all modes, minus this compliance of the moving modes, plus h^2/12 for the
 * centre of mass. The error of the kicks is then of order h^4, not h^2. */
#include <math.h>
#include <string.h>

#include "cor/status.h"
#include "runtime/disk/collision_parts.h"
#include "runtime/disk/hard_wall_parts.h"

/* Time of the first kick after the first touch, in steps: a kick is the middle of the step that it represents. */
#define FIRST_KICK 0.5
/* Smaller reaches, in units of the speed, are rounding errors. */
#define NEGLIGIBLE_REACH 1e-12
/* Number of batches of kicks without contact between two checks that the contact has ended for good */
enum { BATCHES_A_LOOK = 8 };
enum { MAX_STEPS = 2000000 };

struct sizes {
    size_t modes, blocks, cells, lanes;
    size_t terms;   /* terms of the rim's cosine series, in whole panels */
    size_t points;  /* number of angles, in whole panels; 0 in a point contact */
    size_t nyquist; /* N = pi/d, a multiple of half a panel */
    size_t bins;    /* as in struct cor_hard_wall_angles */
};

struct level {
    struct sizes size;
    const struct cor_hard_wall_loops *loops;
    const struct cor_collision_loops *rim; /* only gather and split are used */
    const struct cor_disk_mode *mode;
    double speed, h, spacing;
    struct cor_hard_wall_modes modes;
    struct cor_mode_block *block;
    size_t *place;                       /* cell of each mode */
    double *turn, *c, *s;                /* [cell] */
    double *sine, *unit;                 /* [mode]: sin(omega h); sqrt(g), so that Q = unit q */
    double *force_c, *force_s;           /* [batch][lanes] */
    double *sum_c, *sum_s;               /* likewise */
    double *echo_cc, *echo_cs, *echo_ss; /* [1 to batch - 1][lanes]: effect of a force on sums 1 to batch - 1 kicks
                                          * later */
    struct cor_hard_wall_angles angles;
    double *twice_cosine, *shape, *reach, *force, *series;
    double *t, *q; /* T_k and Q_n of the compliance that acts at once, k up to nyquist */
    struct cor_hard_wall_contact contact;
    double work, work_per_step, most_work; /* work: without contact.work. The others: the budget */
    double point_constant;                 /* constant of the contact law, (57), less the part of the moving modes */
};

/* ---- workspace ---- */

static struct sizes sizes_of(const struct cor_disk_mode *mode, size_t modes,
                             const struct cor_hard_wall_settings *settings)
{
    struct sizes size = {.modes = modes};
    for (size_t i = 0; i < modes; i++)
        size.blocks = (size_t)mode[i].n / COR_LANES > size.blocks ? (size_t)mode[i].n / COR_LANES : size.blocks;
    size.lanes = ++size.blocks * COR_LANES;
    size.cells = cor_mode_blocks(mode, modes, size.blocks, NULL);
    size.terms = cor_whole(size.lanes + 2, COR_HARD_WALL_PANEL);
    if (!settings->point) {
        const double least = (double)size.lanes + 2, half = 0.5 * COR_HARD_WALL_PANEL;
        const size_t bins = (size_t)ceil(fmax(COR_PI / settings->spacing, least) / half);
        size.nyquist = bins * COR_HARD_WALL_PANEL / 2;
        size.bins = 2 * bins < size.lanes ? bins : 0;
        size.points = cor_whole((size_t)(fmin(settings->range, COR_PI / 2) * (double)size.nyquist / COR_PI) + 1,
                                COR_HARD_WALL_PANEL);
    }
    return size;
}

static void arrange_level(struct level *level, struct cor_store *store)
{
    const struct sizes *const size = &level->size;
    const size_t both = size->terms > 2 * size->points ? size->terms : 2 * size->points;
    level->block = cor_store_take(store, size->blocks, sizeof *level->block);
    level->place = cor_store_take(store, size->modes, sizeof *level->place);
    COR_STORE_TAKE_DOUBLES(store, size->cells, &level->turn, &level->c, &level->s, &level->modes.q,
                           &level->modes.before);
    COR_STORE_TAKE_DOUBLES(store, size->modes, &level->sine, &level->unit);
    COR_STORE_TAKE_DOUBLES(store, COR_HARD_WALL_BATCH * size->lanes, &level->force_c, &level->force_s, &level->sum_c,
                           &level->sum_s, &level->echo_cc, &level->echo_cs, &level->echo_ss);
    COR_STORE_TAKE_DOUBLES(store, size->terms, &level->series);
    /* reach is also scratch for sums and differences of angles */
    COR_STORE_TAKE_DOUBLES(store, both, &level->twice_cosine, &level->reach);
    struct cor_hard_wall_angles *const angles = &level->angles;
    const size_t circle = 2 * COR_HARD_WALL_PANEL, pays = size->bins > 0;
    COR_STORE_TAKE_DOUBLES(store, pays * circle * (COR_HARD_WALL_PANEL / 2 + 1), &angles->part);
    COR_STORE_TAKE_DOUBLES(store, size->bins * circle, &angles->turn, &angles->sums);
    COR_STORE_TAKE_DOUBLES(store, size->bins * 2, &angles->whole);
    COR_STORE_TAKE_DOUBLES(store, size->points, &level->shape, &level->force);
    COR_STORE_TAKE_DOUBLES(store, size->nyquist + 1, &level->t);
    COR_STORE_TAKE_DOUBLES(store, size->lanes, &level->q);
    if (size->points > 0)
        cor_hard_wall_contact_arrange(&level->contact, store, size->points);
}

size_t cor_hard_wall_level_bytes(const struct cor_disk_mode *mode, size_t modes,
                                 const struct cor_hard_wall_settings *settings)
{
    struct level level;
    struct cor_store store = {NULL, 0};
    level.size = sizes_of(mode, modes, settings);
    arrange_level(&level, &store);
    return store.used;
}

/* ---- modes and compliance ---- */

static double fade_of(enum cor_hard_wall_fade fade, double r)
{
    const double left = 1 - r * r;
    return left * left * (fade == COR_HARD_WALL_FADE ? 1 + r * r : 1);
}

static void place_modes(struct level *level)
{
    const struct sizes *const size = &level->size;
    cor_mode_blocks(level->mode, size->modes, size->blocks, level->block);
    cor_mode_places(level->mode, size->modes, size->blocks, level->block, level->q, level->place);
    COR_CLEAR_DOUBLES(size->cells, level->turn, level->c, level->s, level->modes.q, level->modes.before);
    const struct cor_hard_wall_modes modes = {size->blocks, level->block,   level->turn,        level->c,
                                              level->s,     level->modes.q, level->modes.before};
    level->modes = modes;
}

/* Adds the compliances A, B, D of one n, or subtracts the part of one mode. Between phi and phi', cos((n + 1) phi)
 * cos((n + 1) phi') has the factor (C + S)^2, cos((n - 1) phi) cos((n - 1) phi') has (C - S)^2, and the mixed products
 * have C^2 - S^2. */
static void add_compliance(struct level *level, size_t n, double sum_square, double difference_square, double across)
{
    if (n + 1 <= level->size.nyquist)
        level->t[n + 1] += sum_square;
    level->t[n > 0 ? n - 1 : 1] += difference_square;
    if (n < level->size.lanes) /* 0 beyond */
        level->q[n] += across;
}

/* Adds the static compliance of all modes up to the Nyquist number, docs/theory-disks.md, 14. */
static void add_static_compliance(struct level *level, double nu)
{
    COR_CLEAR_DOUBLES(level->size.nyquist + 1, level->t);
    COR_CLEAR_DOUBLES(level->size.lanes, level->q);
    const double one = 0.5 * (1 - nu); /* A_0 = A_1 = B_1 */
    add_compliance(level, 0, one, one, one);
    add_compliance(level, 1, 3 * one + 0.5 * (3 + nu), 0.5 * (3 + nu) - one, one - 0.5 * (3 + nu));
    for (size_t k = 2; k <= level->size.nyquist; k++) {
        const double n = (double)k, square = (n - 1) * (n + 1);
        const double a = (2 * n - 1 + nu) / square, b = (n * (1 - nu) - 2) / square;
        add_compliance(level, k, 2 * (a + b), 2 * (a - b), 0);
    }
}

static void set_modes(struct level *level, const struct cor_hard_wall_settings *settings)
{
    const struct sizes *const size = &level->size;
    const size_t lanes = size->lanes;
    COR_CLEAR_DOUBLES(COR_HARD_WALL_BATCH * lanes, level->echo_cc, level->echo_cs, level->echo_ss);
    double moving = 0; /* sum of w C^2/omega^2 */
    for (size_t i = 0; i < size->modes; i++) {
        const struct cor_disk_mode *const mode = &level->mode[i];
        const size_t n = (size_t)mode->n, cell = level->place[i];
        const double half_sine = sin(0.5 * mode->omega * level->h), half_cosine = cos(0.5 * mode->omega * level->h);
        const double w = fade_of(settings->fade, mode->omega / settings->omega);
        level->sine[i] = 2 * half_sine * half_cosine;
        level->unit[i] = sqrt(level->h * level->sine[i] / (COR_DISK_MASS * mode->omega));
        const double turn = 2 - 4 * half_sine * half_sine, c = sqrt(w) * level->unit[i] * mode->c,
                     s = sqrt(w) * level->unit[i] * mode->s;
        level->turn[cell] = turn;
        level->c[cell] = c;
        level->s[cell] = s;
        double now = 1, next = turn; /* q after a unit force: at the next two kicks */
        for (size_t k = 1; k < COR_HARD_WALL_BATCH; k++) {
            level->echo_cc[k * lanes + n] += now * (c * c);
            level->echo_cs[k * lanes + n] += now * (c * s);
            level->echo_ss[k * lanes + n] += now * (s * s);
            const double after = turn * next - now;
            now = next;
            next = after;
        }
        const double under_kicks = w * (0.5 * level->h / mode->omega) * (half_cosine / half_sine);
        moving += under_kicks * mode->c * mode->c;
        if (size->points > 0)
            add_compliance(level, n, -under_kicks * (mode->c + mode->s) * (mode->c + mode->s),
                           -under_kicks * (mode->c - mode->s) * (mode->c - mode->s),
                           -under_kicks * (mode->c * mode->c - mode->s * mode->s));
    }
    level->point_constant = level->h * level->h / 12 - moving;
}

/* Sets the cosines and sines of x r, r < n. */
static void set_circle(double *cosine, double *sine, size_t stride, size_t n, double x)
{
    for (size_t r = 0; r < n; r++) {
        cosine[r * stride] = cos(x * (double)r);
        sine[r * stride] = sin(x * (double)r);
    }
}

static void set_angles(struct level *level)
{
    const struct sizes *const size = &level->size;
    const size_t both = size->terms > 2 * size->points ? size->terms : 2 * size->points;
    level->spacing = COR_PI / (double)size->nyquist;
    for (size_t j = 0; j < both; j++)
        level->twice_cosine[j] = 2 * cos((double)j * level->spacing);
    struct cor_hard_wall_angles *const angles = &level->angles;
    const size_t panel = COR_HARD_WALL_PANEL;
    angles->twice_cosine = level->twice_cosine;
    angles->bins = size->bins;
    for (size_t a = 0; a < size->bins; a++)
        set_circle(angles->turn + 2 * panel * a, angles->turn + 2 * panel * a + panel, 1, panel,
                   (double)a * level->spacing);
    if (size->bins > 0) {
        for (size_t b = 0; b <= panel / 2; b++)
            set_circle(angles->part + 2 * panel * b, angles->part + 2 * panel * b + panel, 1, panel,
                       2 * COR_PI * (double)b / (double)panel);
        set_circle(angles->whole, angles->whole + 1, 2, size->bins, 2 * COR_PI / (double)size->bins);
    }
    for (size_t j = 0; j < size->points; j++) {
        const double half_sine = sin(0.5 * (double)j * level->spacing);
        level->shape[j] = -2 * half_sine * half_sine / level->speed;
    }
    memset(level->force, 0, size->points * sizeof *level->force);
    cor_hard_wall_contact_begin(&level->contact, size->nyquist + 1, level->t, size->lanes, level->q, angles,
                                level->h * level->h / (12 * COR_DISK_MASS), level->reach);
}

/* ---- wall ---- */

/* The results of one kick */
struct kick {
    double load;
    size_t end; /* 1 more than the last angle in contact */
};

/* Returns the load p of a point contact whose point would be at `depth` in the wall without the load:
 * depth = (p/pi)(a - ln(p)). */
static double point_load(double depth, double a)
{
    if (!(depth > 0))
        return 0;
    double p = COR_PI * depth / a;
    p = COR_PI * depth / (a - log(p));
    for (int i = 0; i < 20; i++) {
        const double step = (p * (a - log(p)) - COR_PI * depth) / (a - 1 - log(p));
        p -= step;
        if (fabs(step) < 1e-15 * p)
            break;
    }
    return p;
}

static struct kick push_at_point(const struct level *level, double depth, const double *sum_c, double *force_c,
                                 double *force_s)
{
    const size_t lanes = level->size.lanes;
    double reach = depth;
    for (size_t n = 0; n < lanes; n++)
        reach += sum_c[n];
    const double a = log(4 * COR_PI) - log(level->speed) + level->point_constant;
    const struct kick kick = {point_load(reach, a), 0};
    for (size_t n = 0; n < lanes; n++) {
        force_c[n] = -kick.load;
        force_s[n] = 0;
    }
    return kick;
}

static struct kick push_on_rim(struct level *level, double depth, const double *sum_c, const double *sum_s,
                               double *force_c, double *force_s)
{
    const struct sizes *const size = &level->size;
    const struct cor_rim rim = {.blocks = size->blocks, .terms = size->terms};
    struct kick kick = {0, 0};
    level->rim->gather(&rim, sum_c, sum_s, level->series);
    level->loops->cosines(&level->angles, size->lanes + 2, level->series, size->points, level->reach);
    for (size_t j = 0; j < size->points; j++)
        level->reach[j] += depth + level->shape[j];
    kick.end = cor_hard_wall_contact_solve(&level->contact, level->reach, NEGLIGIBLE_REACH, level->force);
    for (size_t j = 0; j < kick.end; j++)
        kick.load += level->force[j];
    level->loops->cosines(&level->angles, kick.end, level->force, size->terms, level->series);
    level->rim->split(&rim, -1, level->series, force_c, force_s); /* the wall pushes inwards */
    return kick;
}

/* ---- a collision ---- */

struct motion {
    double time, depth, velocity; /* velocity before the kick, positive towards the wall */
    double last, last_but_one;    /* depths at the two previous kicks */
    double load;                  /* at the previous kick */
    double max_depth, end;        /* end of the last contact */
    size_t steps;
};

/* Returns the largest displacement of any part of the rim from its round shape in free motion. */
static double greatest_swing(const struct level *level)
{
    double swing = 0;
    for (size_t i = 0; i < level->size.modes; i++) {
        const size_t cell = level->place[i];
        const double q = level->modes.q[cell], before = level->modes.before[cell];
        const double p = (0.5 * level->turn[cell] * q - before) / level->sine[i];
        swing += fmax(fabs(level->c[cell]), fabs(level->s[cell])) * sqrt(q * q + p * p);
    }
    return swing;
}

/* Returns the true depth. Under kicks at intervals h the depth of the centre of mass exceeds it by (h^2/12) load/m. */
static double true_depth(const struct level *level, const struct motion *motion, double load)
{
    return motion->depth - level->h * level->h / (12 * COR_DISK_MASS) * load;
}

/* Updates the largest depth, from a parabola through three depths, and the end of the contact, from a linear
 * extrapolation of the decreasing load. */
static void follow_load(struct motion *motion, const struct level *level, double load)
{
    const double depth = true_depth(level, motion, load), last = motion->last, last_but_one = motion->last_but_one;
    const double bend = depth - 2 * last + last_but_one, slope = 0.5 * (depth - last_but_one);
    if (last >= depth && last >= last_but_one && bend < 0)
        motion->max_depth = fmax(motion->max_depth, last - 0.5 * slope * slope / bend);
    motion->last_but_one = last;
    motion->last = depth;
    if (load > 0) {
        const double fall = motion->load - load;
        motion->end = motion->time + level->h * (load < fall ? load / fall : 1);
    }
    motion->load = load;
}

/* Returns the energy of a mode at a kick, relative to (pi/2) v^2. before, q, next: its amplitudes at three kicks. */
static double energy_of(const struct level *level, size_t i, double before, double q, double next)
{
    const double sine = level->sine[i], p = 0.5 * (next - before);
    return level->mode[i].omega * level->h / (COR_PI * sine) * (sine * sine * q * q + p * p);
}

/* Returns the amplitude at the next kick, including the forces of this one. */
static double next_amplitude(const struct level *level, size_t i)
{
    const size_t cell = level->place[i], n = (size_t)level->mode[i].n;
    return level->turn[cell] * level->modes.q[cell] - level->modes.before[cell] +
           (level->c[cell] * level->force_c[n] + level->s[cell] * level->force_s[n]);
}

/* Reports a kick whose forces are known. Under kicks an amplitude is smaller than the true one by (h^2/12) force/m. */
static void level_tell(const struct level *level, const struct motion *motion, const struct kick *kick,
                       double contact_time, const struct cor_disk_hard_wall_detail *detail)
{
    const double v = level->speed, h = level->h;
    for (size_t i = 0; i < level->size.modes; i++) {
        const size_t cell = level->place[i], n = (size_t)level->mode[i].n;
        const double q = level->modes.q[cell], next = next_amplitude(level, i), before = level->modes.before[cell];
        const double force = (level->c[cell] * level->force_c[n] + level->s[cell] * level->force_s[n]) / level->unit[i];
        if (detail->energy_average != NULL && motion->time <= contact_time)
            detail->energy_average[i] += h / contact_time * energy_of(level, i, before, q, next);
        if (detail->q != NULL)
            detail->q[i] = v * (level->unit[i] * q + h * h / (12 * COR_DISK_MASS) * force);
        if (detail->q_dot != NULL)
            detail->q_dot[i] = v * level->unit[i] * level->mode[i].omega * (next - before) / (2 * level->sine[i]);
    }
    if (detail->observe != NULL) {
        const double angle = kick->end > 0 ? (double)(kick->end - 1) * level->spacing : 0;
        const struct cor_disk_hard_wall_moment moment = {motion->time, v * true_depth(level, motion, kick->load) - 1,
                                                         v * (motion->velocity - 0.5 * h * kick->load / COR_DISK_MASS),
                                                         v * kick->load, angle};
        detail->observe(detail->context, &moment);
    }
}

static void clear_detail(const struct cor_disk_modes *modes, const struct cor_disk_hard_wall_detail *detail)
{
    double *const cleared[] = {detail->energy_after, detail->energy_average, detail->q, detail->q_dot};
    for (size_t i = 0; i < sizeof cleared / sizeof *cleared; i++)
        if (cleared[i] != NULL)
            memset(cleared[i], 0, modes->count * sizeof(double));
}

/* Adds the effect of the forces of earlier kicks to the sums of kick `at` of a batch. */
static void add_echoes(struct level *level, size_t at)
{
    const size_t lanes = level->size.lanes;
    double *const sum_c = level->sum_c + at * lanes, *const sum_s = level->sum_s + at * lanes;
    for (size_t k = 0; k < at; k++) {
        const double *const force_c = level->force_c + k * lanes, *const force_s = level->force_s + k * lanes;
        const double *const cc = level->echo_cc + (at - k) * lanes, *const cs = level->echo_cs + (at - k) * lanes,
                            *const ss = level->echo_ss + (at - k) * lanes;
        for (size_t n = 0; n < lanes; n++) {
            sum_c[n] += cc[n] * force_c[n] + cs[n] * force_s[n];
            sum_s[n] += cs[n] * force_c[n] + ss[n] * force_s[n];
        }
    }
}

/* Makes a kick at the present positions. */
static struct kick take_step(struct level *level, struct motion *motion, size_t at)
{
    const size_t lanes = level->size.lanes;
    double *const force_c = level->force_c + at * lanes, *const force_s = level->force_s + at * lanes;
    const double *const sum_c = level->sum_c + at * lanes, *const sum_s = level->sum_s + at * lanes;
    add_echoes(level, at);
    const struct kick kick = level->size.points > 0 ? push_on_rim(level, motion->depth, sum_c, sum_s, force_c, force_s)
                                                    : push_at_point(level, motion->depth, sum_c, force_c, force_s);
    follow_load(motion, level, kick.load);
    return kick;
}

static void drift_modes(const struct level *level, struct motion *motion, double load)
{
    motion->velocity -= level->h * load / COR_DISK_MASS;
    motion->depth += level->h * motion->velocity;
    motion->time += level->h;
    motion->steps++;
}

/* Returns the multiplications of a sum of `count` cosines at `points` angles. */
static double cosines_work(const struct cor_hard_wall_angles *angles, size_t count, size_t points)
{
    const double k = (double)count, bins = (double)angles->bins, panel = COR_HARD_WALL_PANEL;
    return cor_hard_wall_sums_by_parts(angles, count) ? 2 * (panel * k + (2 * panel + (double)points) * bins)
                                                      : k * (double)points;
}

/* Returns the number of multiplications in a kick for the modes, the reach of the rim and the series of the forces,
 * without the search for contact forces. */
static double kick_work(const struct level *level, size_t end)
{
    const struct sizes *const size = &level->size;
    return 4 * (double)size->cells + cosines_work(&level->angles, size->lanes + 2, size->points) +
           cosines_work(&level->angles, end, size->terms);
}

/* Returns the work that the level has spent. */
static double work_of(const struct level *level, const struct motion *motion)
{
    return level->work_per_step > 0 ? level->work_per_step * (double)motion->steps : level->work + level->contact.work;
}

/* Makes kicks until no part of the rim can reach the wall again. */
static int level_collide(struct level *level, struct motion *motion, double contact_time,
                         const struct cor_disk_hard_wall_detail *detail)
{
    const size_t batch = detail == NULL ? COR_HARD_WALL_BATCH : 1;
    size_t free_batches = 0;
    do {
        double load = 0;
        for (size_t at = 0; at < batch; at++) {
            const struct kick kick = take_step(level, motion, at);
            if (level->contact.indefinite || !(kick.load < INFINITY))
                return COR_ERROR_MODES;
            if (level->size.points > 0 && kick.end == level->size.points)
                return COR_ERROR_WORKSPACE;
            if (detail != NULL)
                level_tell(level, motion, &kick, contact_time, detail);
            drift_modes(level, motion, kick.load);
            load += kick.load;
            level->work += kick_work(level, kick.end);
        }
        level->loops->advance(&level->modes, batch, level->force_c, level->force_s, level->sum_c, level->sum_s);
        free_batches = load > 0 ? 0 : free_batches + 1;
        if (motion->steps > MAX_STEPS)
            return COR_CONTACT_NOT_ENDED;
        if (level->most_work > 0 && work_of(level, motion) > level->most_work)
            return COR_TOLERANCE_NOT_REACHED;
    } while (free_batches % BATCHES_A_LOOK != 1 || motion->velocity >= 0 || motion->depth + greatest_swing(level) >= 0);
    return COR_OK;
}

/* Returns the energy left in the modes, relative to (pi/2) v^2. */
static double energy_after(const struct level *level, double *of_mode)
{
    double sum = 0;
    for (size_t i = 0; i < level->size.modes; i++) {
        const size_t cell = level->place[i];
        const double q = level->modes.q[cell], before = level->modes.before[cell];
        const double energy = energy_of(level, i, before, q, level->turn[cell] * q - before);
        sum += energy;
        if (of_mode != NULL)
            of_mode[i] = energy;
    }
    return sum;
}

int cor_hard_wall_level(void *workspace, const struct cor_disk_modes *modes, double speed,
                        const struct cor_hard_wall_settings *settings, struct cor_hard_wall_result *result,
                        const struct cor_disk_hard_wall_detail *detail)
{
    struct cor_store store = {workspace, 0};
    size_t count = 0;
    while (count < modes->count && modes->mode[count].omega < settings->omega)
        count++;
    struct level level = {.loops = settings->loops ? settings->loops : cor_hard_wall_set(cor_widest_set()),
                          .rim = cor_collision_set(cor_widest_set()),
                          .mode = modes->mode,
                          .size = sizes_of(modes->mode, count, settings),
                          .speed = speed,
                          .h = settings->turn / settings->omega,
                          .work_per_step = settings->work_per_step,
                          .most_work = settings->most_work};
    level.contact.loops = level.loops;
    arrange_level(&level, &store);
    place_modes(&level);
    if (level.size.points > 0)
        add_static_compliance(&level, modes->nu);
    set_modes(&level, settings);
    if (level.size.points > 0)
        set_angles(&level);
    level.point_constant += -2 * COR_LN2 - 0.25 * (1 + modes->nu);
    COR_CLEAR_DOUBLES(COR_HARD_WALL_BATCH * level.size.lanes, level.sum_c, level.sum_s);
    if (detail != NULL)
        clear_detail(modes, detail);

    struct motion motion = {.velocity = 1, .time = FIRST_KICK * level.h, .depth = FIRST_KICK * level.h};
    const int status = level_collide(&level, &motion, result->contact_time, detail);
    result->work = work_of(&level, &motion);
    if (status != COR_OK)
        return status;
    const double energy = energy_after(&level, detail == NULL ? NULL : detail->energy_after);
    result->one_minus_eps2 = 1 - motion.velocity * motion.velocity;
    result->contact_time = motion.end;
    result->max_compression = speed * motion.max_depth;
    result->energy_drift = energy - result->one_minus_eps2;
    result->steps = motion.steps;
    result->pivotings = level.contact.pivotings;
    return COR_OK;
}
