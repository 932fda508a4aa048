/* SPDX-License-Identifier: MIT */
#include "collisions.h"

#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cor/status.h"
#include "gen/support/clock.h"

const double wall[WALLS] = {25, 50, 100};
const double other_wall[OTHER_WALLS] = {10, 15, 200};
const int size[SIZES] = {300, 400, 600, 940, 1300, 1800};

static const double material[] = {0.33, 0.9};
static const double slowest = 1e-3, slow_up_to = 0.1;

/* A double as the csv file has it, so that what is read back is what was computed */
static double rounded(double x)
{
    char text[32];
    snprintf(text, sizeof text, "%.5g", x);
    return strtod(text, NULL);
}

double paper_speed(int i)
{
    return rounded(i < 2 ? 0.005 * (i + 1) : 0.02 * (i - 1));
}

double slow_speed(int i)
{
    return rounded(log_point(slowest, slow_up_to, i, SLOW_SPEEDS));
}

enum { CAPACITY = PAPER_SPEEDS * (2 * SIZES * WALLS + OTHER_WALLS) + SLOW_SPEEDS * ((SIZES - LARGE_FROM) * WALLS + 1) };
static struct collision table[CAPACITY];
static int count;

static void plan_one(double nu, int modes, double rate, double speed)
{
    const double alpha = rounded(rate / speed);
    if (alpha >= COR_DISK_COLLISION_MIN_ALPHA && alpha <= COR_DISK_COLLISION_MAX_ALPHA &&
        collision_find(nu, modes, rate, speed) == NULL)
        table[count++] =
            (struct collision){.nu = nu, .modes = modes, .alpha = alpha, .speed = speed, .one_minus_eps2 = NAN};
}

static void plan(void)
{
    count = 0;
    for (int i = 0; i < PAPER_SPEEDS; i++) {
        for (int n = 0; n < SIZES; n++)
            for (int k = 0; k < WALLS; k++)
                for (int m = 0; m < 2; m++)
                    plan_one(material[m], size[n], wall[k], paper_speed(i));
        for (int k = 0; k < OTHER_WALLS; k++)
            plan_one(0.33, size[WALL_SIZE], other_wall[k], paper_speed(i));
    }
    for (int i = 0; i < SLOW_SPEEDS; i++) {
        for (int n = LARGE_FROM; n < SIZES; n++)
            for (int k = 0; k < WALLS; k++)
                plan_one(0.33, size[n], wall[k], slow_speed(i));
        plan_one(0.33, size[WALL_SIZE], other_wall[OTHER_WALLS - 1], slow_speed(i));
    }
}

const struct collision *collision_find(double nu, int modes, double rate, double speed)
{
    for (int i = 0; i < count; i++) {
        const struct collision *c = &table[i];
        if (c->nu == nu && c->modes == modes && c->speed == speed && fabs(c->alpha * c->speed / rate - 1) < 1e-3)
            return c;
    }
    return NULL;
}

static const struct cor_disk_modes *modes_of(double nu)
{
    return nu == cor_disk_modes_nu090.nu ? &cor_disk_modes_nu090 : &cor_disk_modes_nu033;
}

struct watcher {
    collision_visit *visit;
    void *context;
    double *q, *q_dot;
};

static void pass_on(void *context, const struct cor_disk_moment *moment)
{
    const struct watcher *watcher = context;
    watcher->visit(watcher->context, moment, watcher->q, watcher->q_dot);
}

static int collision_of(const struct cor_disk_modes *modes, size_t n_modes, double alpha, double speed,
                        double tolerance, struct cor_disk_collision *out,
                        const struct cor_disk_collision_detail *detail)
{
    const struct cor_disk_collision_options options = {.alpha = alpha, .tolerance = tolerance};
    const size_t bytes = cor_disk_collision_workspace(modes, n_modes, &options);
    void *workspace = malloc(bytes + (bytes == 0));
    const int status = workspace == NULL
                           ? COR_ERROR_MEMORY
                           : cor_disk_collision_in(workspace, bytes, modes, n_modes, &options, speed, out, detail);
    free(workspace);
    return status;
}

static int complain(int status, double nu, size_t n_modes, double alpha, double speed)
{
    fprintf(stderr, "cor_paper: nu = %g, %zu modes, alpha = %g, v = %g: %s\n", nu, n_modes, alpha, speed,
            cor_status_text(status));
    return 0;
}

int collision_watch(size_t n_modes, double alpha, double speed, collision_visit *visit, void *context,
                    struct cor_disk_collision *out, double *energy_average, double *energy_after)
{
    struct watcher watcher = {visit, context, calloc(n_modes, sizeof(double)), calloc(n_modes, sizeof(double))};
    struct cor_disk_collision_detail detail = {.energy_after = energy_after,
                                               .energy_average = energy_average,
                                               .observe = visit != NULL ? pass_on : NULL,
                                               .context = &watcher,
                                               .q = watcher.q,
                                               .q_dot = watcher.q_dot};
    const int status =
        watcher.q == NULL || watcher.q_dot == NULL
            ? COR_ERROR_MEMORY
            : collision_of(&cor_disk_modes_nu033, n_modes, alpha, speed, WATCHED_TOLERANCE, out, &detail);
    free(watcher.q);
    free(watcher.q_dot);
    return status == COR_OK || complain(status, cor_disk_modes_nu033.nu, n_modes, alpha, speed);
}

/* Collisions to compute, shared by the threads */
struct work {
    pthread_mutex_t lock;
    struct collision **job;
    int jobs, next, done, failed, terminal;
    double start; /* clock_seconds */
};

static int collision_compute(struct collision *c)
{
    struct cor_disk_collision out;
    const int status =
        collision_of(modes_of(c->nu), (size_t)c->modes, c->alpha, c->speed, COLLISION_TOLERANCE, &out, NULL);
    if (status != COR_OK && status != COR_TOLERANCE_NOT_REACHED)
        return complain(status, c->nu, (size_t)c->modes, c->alpha, c->speed);
    c->converged = status == COR_OK;
    c->one_minus_eps2 = out.one_minus_eps2;
    c->contact_time = out.contact_time;
    c->max_compression = out.max_compression;
    return 1;
}

static void *work_labour(void *argument)
{
    struct work *work = argument;
    pthread_mutex_lock(&work->lock);
    while (work->next < work->jobs && !work->failed) {
        struct collision *job = work->job[work->next++];
        pthread_mutex_unlock(&work->lock);
        const int computed = collision_compute(job);
        pthread_mutex_lock(&work->lock);
        work->done++;
        work->failed |= !computed;
        const double spent = clock_seconds() - work->start;
        if (work->terminal)
            fprintf(stderr, "\rcollisions: %d of %d, %.0f s left   ", work->done, work->jobs,
                    spent / work->done * (work->jobs - work->done));
    }
    pthread_mutex_unlock(&work->lock);
    return NULL;
}

static int compute_jobs(struct collision **job, int jobs)
{
    enum { MOST_THREADS = 64 };
    struct work work = {.job = job, .jobs = jobs, .terminal = isatty(STDERR_FILENO), .start = clock_seconds()};
    pthread_mutex_init(&work.lock, NULL);
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    pthread_t thread[MOST_THREADS];
    int threads = 0;
    while (threads < MOST_THREADS && threads < cores - 1 &&
           pthread_create(&thread[threads], NULL, work_labour, &work) == 0)
        threads++;
    work_labour(&work);
    for (int i = 0; i < threads; i++)
        pthread_join(thread[i], NULL);
    pthread_mutex_destroy(&work.lock);
    if (work.terminal)
        fprintf(stderr, "\r%60s\r", "");
    return !work.failed;
}

static const char header[] = "nu,modes,alpha,speed,converged,one_minus_eps2,contact_time,max_compression\n";

static void write_row(char *line, size_t length, const struct collision *c)
{
    snprintf(line, length, "%g,%d,%.5g,%.5g,%d,%.6f,%.3f,%.5g\n", c->nu, c->modes, c->alpha, c->speed, c->converged,
             c->one_minus_eps2, c->contact_time, c->max_compression);
}

/* 1 if eight numbers stand at the beginning of the line */
static int read_row(const char *line, struct collision *c)
{
    double number[8];
    for (int i = 0; i < 8; i++) {
        char *end;
        number[i] = strtod(line, &end);
        if (end == line || (i < 7 && *end != ','))
            return 0;
        line = end + 1;
    }
    *c = (struct collision){.nu = number[0],
                            .modes = (int)number[1],
                            .alpha = number[2],
                            .speed = number[3],
                            .converged = (int)number[4],
                            .one_minus_eps2 = number[5],
                            .contact_time = number[6],
                            .max_compression = number[7]};
    return 1;
}

int collisions_compute(void)
{
    static struct collision *job[CAPACITY];
    plan();
    for (int i = 0; i < count; i++)
        job[i] = &table[i];
    if (!compute_jobs(job, count))
        return 0;
    /* What figures are made of is what the file has. */
    for (int i = 0; i < count; i++) {
        char line[200];
        write_row(line, sizeof line, &table[i]);
        if (!read_row(line, &table[i]))
            return complain(COR_ERROR_RANGE, table[i].nu, (size_t)table[i].modes, table[i].alpha, table[i].speed);
    }
    return 1;
}

static int write_collisions(FILE *csv, char verdict[VERDICT_SIZE])
{
    int off = 0;
    fputs(header, csv);
    for (int i = 0; i < count; i++) {
        char line[200];
        write_row(line, sizeof line, &table[i]);
        fputs(line, csv);
        off += !table[i].converged;
    }
    char reached[80] = "which all reach";
    if (off > 0)
        snprintf(reached, sizeof reached, "which %d of them, mostly chaotic, do not reach", off);
    snprintf(verdict, VERDICT_SIZE,
             "%d collisions, each with the tolerance %g on eps, %s. They have at most %d modes, as the tables in the "
             "library.",
             count, COLLISION_TOLERANCE, reached, size[SIZES - 1]);
    return 1;
}

/* The rows of the file are those planned, with results as they are printed. */
static int read_table(const char *path)
{
    plan();
    errno = 0;
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        fprintf(stderr, "cor_paper: cannot read %s: %s\n", path, strerror(errno));
        return 0;
    }
    char line[200], again[200];
    int good = fgets(line, sizeof line, file) != NULL && strcmp(line, header) == 0, row = 0;
    for (; good && row < count; row++) {
        struct collision *c = &table[row], r = *c;
        good = fgets(line, sizeof line, file) != NULL && read_row(line, &r) && r.nu == c->nu && r.modes == c->modes &&
               r.alpha == c->alpha && r.speed == c->speed;
        write_row(again, sizeof again, &r);
        good = good && strcmp(line, again) == 0;
        *c = r;
    }
    good = good && fgets(line, sizeof line, file) == NULL;
    fclose(file);
    if (!good)
        fprintf(stderr, "cor_paper: %s:%d is not what is computed; paper/run computes it again\n", path, row + 1);
    return good;
}

/* A collision that did not converge, chaotic, has but its size to be compared; the others the digits printed. The
 * contact time ends where a load that trembles falls below its threshold, and knows fewer. */
static int collisions_agree(const struct collision *old, const struct collision *new)
{
    const double off = fabs(old->one_minus_eps2 - new->one_minus_eps2);
    if (!old->converged && !new->converged)
        return off <= 5e-3;
    return old->converged == new->converged &&off <= 2 * COLLISION_TOLERANCE + 1e-6 &&
           fabs(old->contact_time - new->contact_time) <= 2e-3 &&
           fabs(old->max_compression / new->max_compression - 1) <= 1e-4;
}

static int check_rows(const char *path, const int *row, int rows)
{
    static struct collision again[CAPACITY], *job[CAPACITY];
    for (int i = 0; i < rows; i++) {
        again[i] = table[row[i]];
        job[i] = &again[i];
    }
    if (!compute_jobs(job, rows))
        return 0;
    int good = 1;
    for (int i = 0; i < rows; i++)
        if (!collisions_agree(&table[row[i]], &again[i])) {
            char line[200];
            write_row(line, sizeof line, &again[i]);
            fprintf(stderr, "cor_paper: %s:%d should be %s", path, row[i] + 2, line);
            good = 0;
        }
    return good;
}

int collisions_read(const char *path, int sample, unsigned long long seed)
{
    static int row[CAPACITY];
    if (!read_table(path))
        return 0;
    if (sample < 0)
        sample = count;
    for (int i = 0; i < count; i++)
        row[i] = i;
    /* the first `sample` of a random permutation */
    unsigned long long state = seed;
    for (int i = 0; i < sample; i++) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        const int j = i + (int)((state >> 33) % (unsigned long long)(count - i)), kept = row[i];
        row[i] = row[j];
        row[j] = kept;
    }
    return check_rows(path, row, sample);
}

const struct figure collisions_figure = {"collisions", "Data", "collisions of the full dynamics", write_collisions};
