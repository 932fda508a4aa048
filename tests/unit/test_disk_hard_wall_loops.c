/* SPDX-License-Identifier: MIT */
/* The loops of the rigid wall and of the modes (runtime/disk/hard_wall_kernel.c, mode_source_kernel.c): every
 * instruction set gives the same bits, and what the headers say. */
#define _XOPEN_SOURCE 600 /* j0, j1 */
#include "check.h"

#include "runtime/disk/hard_wall.h"
#include "runtime/disk/mode_source.h"

enum { SETS = COR_INSTRUCTION_SETS };

enum {
    BLOCKS = 4,
    ROWS = 6,
    LANES = BLOCKS * COR_HARD_WALL_LANES,
    CELLS = LANES * ROWS,
    BATCH = COR_HARD_WALL_BATCH,
    MOST = 8 * COR_HARD_WALL_PANEL,
    LENGTHS = MOST / COR_HARD_WALL_LANES + 1,
    TERMS = 301
};

static void numbers_draw(struct random_state *random, double *x, size_t n, double size)
{
    for (size_t i = 0; i < n; i++)
        x[i] = random_uniform(random, -size, size);
}

/* What goes in, and what comes out */
struct input {
    struct cor_hard_wall_block block[BLOCKS];
    size_t blocks, steps, terms, points, length;
    double turn[CELLS], c[CELLS], s[CELLS], force_c[BATCH * LANES], force_s[BATCH * LANES];
    double factor[TERMS], angle, twice_cosine[MOST], x[MOST], y[MOST], by;
};

struct output {
    double q[CELLS], before[CELLS], sum_c[BATCH * LANES], sum_s[BATCH * LANES];
    double series[MOST], dot, rest[MOST];
};

static void draw_input(struct random_state *random, struct input *in, struct output *start)
{
    memset(in, 0, sizeof *in);
    memset(start, 0, sizeof *start);
    in->blocks = 1 + (size_t)random_uniform(random, 0, BLOCKS);
    for (size_t b = 0, first = 0; b < in->blocks; first += in->block[b++].rows) {
        in->block[b].first = first;
        in->block[b].rows = (size_t)random_uniform(random, 0, ROWS + 1); /* none, at times */
    }
    in->steps = random_uniform(random, 0, 1) < 0.5 ? BATCH : 1;
    in->terms = (size_t)random_uniform(random, 0, TERMS + 1);
    in->points = COR_HARD_WALL_PANEL * (1 + (size_t)random_uniform(random, 0, 8));
    in->length = COR_HARD_WALL_LANES * (size_t)random_uniform(random, 0, LENGTHS);
    numbers_draw(random, in->turn, CELLS, 2);
    numbers_draw(random, in->c, CELLS, 1);
    numbers_draw(random, in->s, CELLS, 1);
    numbers_draw(random, in->force_c, BATCH * LANES, 1);
    numbers_draw(random, in->force_s, BATCH * LANES, 1);
    numbers_draw(random, in->factor, TERMS, 1);
    numbers_draw(random, in->x, MOST, 1);
    numbers_draw(random, in->y, MOST, 1);
    in->by = random_uniform(random, -2, 2);
    in->angle = random_log(random, 1e-3, 0.1);
    for (int i = 0; i < MOST; i++)
        in->twice_cosine[i] = 2 * cos(i * in->angle);
    numbers_draw(random, start->q, CELLS, 1);
    numbers_draw(random, start->before, CELLS, 1);
}

static void pass_through(const struct cor_hard_wall_loops *loops, const struct input *in, struct output *out)
{
    const struct cor_hard_wall_modes modes = {in->blocks, in->block, in->turn, in->c, in->s, out->q, out->before};
    loops->advance(&modes, in->steps, in->force_c, in->force_s, out->sum_c, out->sum_s);
    loops->cosines(in->terms, in->factor, in->points, in->twice_cosine, out->series);
    out->dot = loops->dot(in->length, in->x, in->y);
    memcpy(out->rest, in->y, sizeof out->rest);
    loops->subtract(in->length, in->by, in->x, out->rest);
}

static struct input in;
static struct output start, out[SETS];

TEST(same_on_every_set)
{
    struct random_state random = random_start();
    int tried = 0;
    for (size_t i = 0; i < points(300); i++) {
        draw_input(&random, &in, &start);
        tried = 0;
        for (int set = 0; set < SETS; set++) {
            if (!cor_hard_wall_set(set))
                continue;
            out[set] = start;
            pass_through(cor_hard_wall_set(set), &in, &out[set]);
            check(memcmp(&out[set], &out[0], sizeof *out) == 0, "set %d, draw %zu", set, i);
            tried++;
        }
    }
    print_message("%d sets\n", tried);
}

/* Kick by kick, as hard_wall.h defines it */
TEST(as_defined)
{
    struct random_state random = random_start();
    for (size_t draws = 0; draws < points(30); draws++) {
        draw_input(&random, &in, &start);
        out[0] = start;
        pass_through(cor_hard_wall_set(COR_PORTABLE), &in, &out[0]);
        const size_t lanes = in.blocks * COR_HARD_WALL_LANES;
        for (size_t n = 0; n < lanes; n++) {
            double sum_c[BATCH] = {0}, sum_s[BATCH] = {0};
            const struct cor_hard_wall_block *const block = &in.block[n / COR_HARD_WALL_LANES];
            for (size_t row = block->first; row < block->first + block->rows; row++) {
                const size_t cell = row * COR_HARD_WALL_LANES + n % COR_HARD_WALL_LANES;
                double q = start.q[cell], before = start.before[cell];
                for (size_t k = 0; k < 2 * in.steps - 1; k++) {
                    const double force =
                        k < in.steps ? in.c[cell] * in.force_c[k * lanes + n] + in.s[cell] * in.force_s[k * lanes + n]
                                     : 0;
                    const double next = in.turn[cell] * q - before + force;
                    before = q;
                    q = next;
                    if (k + 1 >= in.steps) {
                        sum_c[k + 1 - in.steps] += in.c[cell] * q;
                        sum_s[k + 1 - in.steps] += in.s[cell] * q;
                    }
                    if (k + 1 == in.steps)
                        check(fabs(out[0].q[cell] - q) < 1e-12 && fabs(out[0].before[cell] - before) < 1e-12,
                              "cell %zu: %g %g", cell, out[0].q[cell], q);
                }
            }
            for (size_t k = 0; k < in.steps; k++)
                check(fabs(out[0].sum_c[k * lanes + n] - sum_c[k]) < 1e-10 &&
                          fabs(out[0].sum_s[k * lanes + n] - sum_s[k]) < 1e-10,
                      "sums of n = %zu at kick %zu", n, k);
        }
        double dot = 0;
        for (size_t i = 0; i < in.length; i++) {
            dot += in.x[i] * in.y[i];
            check(fabs(out[0].rest[i] - (in.y[i] - in.by * in.x[i])) < 1e-15, "element %zu", i);
        }
        check(fabs(out[0].dot - dot) < 1e-12, "%g, not %g", out[0].dot, dot);
        for (size_t i = 0; i < in.points; i++) {
            double sum = 0;
            for (size_t k = 0; k < in.terms; k++)
                sum += in.factor[k] * cos((double)k * (double)i * in.angle);
            check(fabs(out[0].series[i] - sum) < 1e-9, "angle %zu, %zu terms: %g, not %g", i, in.terms,
                  out[0].series[i], sum);
        }
    }
}

/* Quotients of Bessel functions and the number of their zeros, from J_0 and J_1 of the C library upwards */
TEST(ladders)
{
    struct random_state random = random_start();
    for (size_t draws = 0; draws < points(200); draws++) {
        double kappa[COR_MODE_LANES], step[COR_MODE_LANES], first[COR_MODE_LANES];
        double quotient[SETS][COR_MODE_LANES], zeros[SETS][COR_MODE_LANES];
        const double size = random_log(&random, 0.5, 300);
        const long end = (long)random_uniform(&random, 0, fmin(0.7 * size, 25)), start_at = (long)(1.2 * size) + 60;
        for (int i = 0; i < COR_MODE_LANES; i++) {
            kappa[i] = size * random_uniform(&random, 0.9, 1);
            step[i] = 2 / kappa[i];
            first[i] = 0.75 * kappa[i] / (double)(start_at + 1);
        }
        for (int set = 0; set < SETS; set++) {
            if (!cor_mode_set(set))
                continue;
            cor_mode_set(set)->ladder(step, first, start_at, end, quotient[set], zeros[set]);
            check(memcmp(quotient[set], quotient[0], sizeof *quotient) == 0 &&
                      memcmp(zeros[set], zeros[0], sizeof *zeros) == 0,
                  "set %d, draw %zu", set, draws);
        }
        for (int i = 0; i < COR_MODE_LANES; i++) {
            /* upwards is stable below m = kappa */
            double below = j0(kappa[i]), here = j1(kappa[i]);
            for (long m = 1; m <= end; m++) {
                const double above = 2 * (double)m / kappa[i] * here - below;
                below = here;
                here = above;
            }
            if (fabs(below) > 1e-3)
                check(fabs(quotient[0][i] - here / below) < 1e-9 * (1 + fabs(here / below)),
                      "J_%ld/J_%ld(%g) = %.12g, not %.12g", end + 1, end, kappa[i], quotient[0][i], here / below);
            /* zeros of J_end below kappa, by its sign at the points between: z is near (k + end/2 - 1/4) pi */
            if (end == 0)
                check(fabs(zeros[0][i] - (kappa[i] / 3.14159265358979 + 0.25)) < 1.01, "%g zeros of J_0 below %g",
                      zeros[0][i], kappa[i]);
        }
    }
}

RUN_TESTS(same_on_every_set, as_defined, ladders)
