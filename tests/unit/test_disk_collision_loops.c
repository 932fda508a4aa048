/* SPDX-License-Identifier: MIT */
/* The loops of a collision (runtime/disk/collision_kernel.c): every instruction set gives the same bits, and what
 * disk_collision.h says. */
#include "check.h"

#include "runtime/disk/collision_loops.h"

static const struct {
    const char *name;
    int set;
    const struct cor_collision_loops *loops;
} sets[] = {
    {"portable", COR_PORTABLE, &cor_collision_portable},
#ifdef COR_X86_SETS
    {"AVX2", COR_AVX2, &cor_collision_avx2},
    {"AVX-512", COR_AVX512, &cor_collision_avx512},
#endif
};
enum { SETS = sizeof sets / sizeof *sets };

enum { BLOCKS = 5, ROWS = 7, LANES = BLOCKS * COR_LANES, CELLS = LANES * ROWS, PANELS = 4, MOST = PANELS * COR_PANEL };

/* What goes in, and what comes out */
struct input {
    struct cor_mode_block block[BLOCKS];
    struct cor_rim rim;
    double c[CELLS], s[CELLS], cosine[CELLS], sine[CELLS], force_c[LANES], force_s[LANES];
    double by_point[MOST * MOST], by_term[MOST * MOST], weight[MOST], shape[MOST], offset, alpha, factor;
    size_t cells, points; /* points: those looked at */
};

struct output {
    double q[CELLS], p[CELLS], sum_c[LANES], sum_s[LANES];
    double d[MOST], reach[MOST], pressure[MOST], e[MOST], force_c[LANES], force_s[LANES], load;
    double softened[MOST], softened_load, greatest;
};

static void numbers_draw(struct random_state *random, double *x, size_t n, double size)
{
    for (size_t i = 0; i < n; i++)
        x[i] = random_uniform(random, -size, size);
}

static void draw_input(struct random_state *random, struct input *in, struct output *start)
{
    const size_t blocks = 1 + (size_t)random_uniform(random, 0, BLOCKS);
    in->cells = 0;
    for (size_t b = 0; b < blocks; b++) {
        in->block[b].first = in->cells / COR_LANES;
        in->block[b].rows = (size_t)random_uniform(random, 0, ROWS + 1); /* none, at times */
        in->cells += in->block[b].rows * COR_LANES;
    }
    const size_t terms = (blocks * COR_LANES + 2 + COR_PANEL - 1) / COR_PANEL * COR_PANEL +
                         COR_PANEL * (size_t)random_uniform(random, 0, 2);
    const size_t points = COR_PANEL * (1 + (size_t)random_uniform(random, 0, PANELS));
    in->points = COR_PANEL * (1 + (size_t)random_uniform(random, 0, (double)points / (double)COR_PANEL));
    const size_t used = blocks * COR_LANES + 1;
    in->rim = (struct cor_rim){blocks, in->block, in->c, in->s, used, terms, points, in->by_point, in->by_term};
    numbers_draw(random, in->shape, MOST, 0.01);
    numbers_draw(random, in->c, CELLS, 1);
    numbers_draw(random, in->s, CELLS, 1);
    numbers_draw(random, in->cosine, CELLS, 1);
    numbers_draw(random, in->sine, CELLS, 1);
    numbers_draw(random, in->force_c, LANES, 0.01);
    numbers_draw(random, in->force_s, LANES, 0.01);
    numbers_draw(random, in->by_point, MOST * MOST, 0.003); /* alpha x stays below 700 */
    numbers_draw(random, in->by_term, MOST * MOST, 1);
    in->offset = random_uniform(random, -1.1, 0);
    in->alpha = random_log(random, 1, 8000);
    in->factor = random_log(random, 1e-3, 1);
    for (size_t j = 0; j < MOST; j++)
        in->weight[j] = random_log(random, 1e-4, 1);
    memset(start, 0, sizeof *start);
    numbers_draw(random, start->q, CELLS, 0.1);
    numbers_draw(random, start->p, CELLS, 0.1);
}

static void pass_through(const struct cor_collision_loops *loops, const struct input *in, struct output *out)
{
    loops->turn(&in->rim, out->q, out->p, in->cosine, in->sine, in->force_c, in->force_s, out->sum_c, out->sum_s);
    loops->gather(&in->rim, out->sum_c, out->sum_s, out->d);
    loops->reach(&in->rim, in->points, in->offset, in->shape, out->d, out->reach);
    out->load = loops->press(in->points, in->alpha, in->weight, out->reach, out->pressure);
    loops->transform(&in->rim, in->points, out->pressure, out->e);
    loops->split(&in->rim, in->factor, out->e, out->force_c, out->force_s);
    memcpy(out->softened, out->pressure, sizeof out->softened);
    out->softened_load = loops->soften(in->points, in->factor, out->reach, out->softened, &out->greatest);
}

TEST(test_every_set)
{
    struct random_state random = random_start();
    static struct input in;
    static struct output start, by_portable, by_set;
    for (size_t k = 0; k < points(2000); k++) {
        draw_input(&random, &in, &start);
        by_portable = start;
        pass_through(sets[0].loops, &in, &by_portable);
        for (int i = 1; i < SETS; i++) {
            if (!cor_processor_has(sets[i].set)) {
                if (k == 0)
                    print_message("%s: not on this processor\n", sets[i].name);
                continue;
            }
            by_set = start;
            pass_through(sets[i].loops, &in, &by_set);
            check(memcmp(&by_set, &by_portable, sizeof by_set) == 0, "%s, draw %zu", sets[i].name, k);
        }
    }
}

/* Off by the roundings of a sum of so many terms, each no larger than `size` */
static int near(double computed, long double exact, size_t terms, double size)
{
    return fabsl(computed - exact) <= ((long double)terms + 4) * size * DBL_EPSILON;
}

TEST(test_meaning)
{
    struct random_state random = random_start();
    static struct input in;
    static struct output start, out;
    for (size_t k = 0; k < points(100); k++) {
        draw_input(&random, &in, &start);
        out = start;
        pass_through(sets[0].loops, &in, &out);
        for (size_t i = in.cells; i < CELLS; i++)
            assert_true(same_bits(out.q[i], start.q[i]) && same_bits(out.p[i], start.p[i]));
        for (size_t b = 0; b < in.rim.blocks; b++)
            for (size_t lane = 0; lane < COR_LANES; lane++) {
                const size_t n = b * COR_LANES + lane;
                long double sum_c = 0, sum_s = 0;
                for (size_t row = 0; row < in.block[b].rows; row++) {
                    const size_t i = (in.block[b].first + row) * COR_LANES + lane;
                    const long double p =
                        start.p[i] + (long double)in.c[i] * in.force_c[n] + (long double)in.s[i] * in.force_s[n];
                    const long double q = in.cosine[i] * (long double)start.q[i] + in.sine[i] * p;
                    check(near(out.q[i], q, 2, 1) && near(out.p[i], in.cosine[i] * p - in.sine[i] * start.q[i], 2, 1),
                          "q = %g, not %Lg", out.q[i], q);
                    sum_c += in.c[i] * q;
                    sum_s += in.s[i] * q;
                }
                check(near(out.sum_c[n], sum_c, ROWS, 1) && near(out.sum_s[n], sum_s, ROWS, 1), "n = %zu: %g, not %Lg",
                      n, out.sum_c[n], sum_c);
            }
        /* one cosine series, at any angle */
        const size_t lanes = in.rim.blocks * COR_LANES;
        const long double phi = random_uniform(&random, 0, 7);
        long double series = 0, rim = 0;
        for (size_t n = 0; n < lanes; n++)
            rim += out.sum_c[n] * cosl(n * phi) * cosl(phi) - out.sum_s[n] * sinl(n * phi) * sinl(phi);
        for (size_t i = 0; i < in.rim.terms; i++)
            series += out.d[i] * cosl(i * phi);
        check(near((double)series, rim, lanes, ROWS), "the rim at %Lg: %Lg, not %Lg", phi, series, rim);

        long double load = 0;
        for (size_t j = 0; j < in.points; j++) {
            long double reach = in.offset + (long double)in.shape[j];
            for (size_t i = 0; i < in.rim.used_terms; i++)
                reach +=
                    (long double)out.d[i] * in.by_point[(j / COR_PANEL * in.rim.terms + i) * COR_PANEL + j % COR_PANEL];
            check(near(out.reach[j], reach, in.rim.terms, ROWS), "angle %zu: %g, not %Lg", j, out.reach[j], reach);
            const double x = in.alpha * out.reach[j];
            const long double pressure = x > -700 ? in.weight[j] * expl(in.alpha * (long double)out.reach[j]) : 0;
            /* alpha x is rounded before */
            check(fabsl(out.pressure[j] - pressure) <= (fabs(x) + 8) * DBL_EPSILON * pressure, "exp(%g): %g, not %Lg",
                  x, out.pressure[j], pressure);
            load += out.pressure[j];
        }
        check(fabsl(out.load - load) <= (double)in.points * DBL_EPSILON * load, "load %g, not %Lg", out.load, load);
        for (size_t i = 0; i < in.rim.terms; i++) {
            long double e = 0;
            for (size_t j = 0; j < in.points; j++)
                e += (long double)out.pressure[j] *
                     in.by_term[(i / COR_PANEL * in.rim.points + j) * COR_PANEL + i % COR_PANEL];
            check(near(out.e[i], e, in.points, (double)load), "term %zu: %g, not %Lg", i, out.e[i], e);
        }
        for (size_t n = 0; n < lanes; n++) {
            const long double below = out.e[n == 0 ? 1 : n - 1], above = out.e[n + 1];
            check(near(out.force_c[n], in.factor * (above + below) / 2, 1, (double)load) &&
                      near(out.force_s[n], in.factor * (above - below) / 2, 1, (double)load),
                  "force on n = %zu: %g and %g", n, out.force_c[n], out.force_s[n]);
        }
        long double softened_load = 0;
        double greatest = 0;
        for (size_t j = 0; j < in.points; j++) {
            const long double softened = out.pressure[j] * (1 - (long double)in.factor * out.reach[j]);
            check(near(out.softened[j], softened, 1, out.pressure[j]), "softened %zu: %g, not %Lg", j, out.softened[j],
                  softened);
            softened_load += softened;
            greatest = fmax(greatest, out.reach[j]);
        }
        check(near(out.softened_load, softened_load, in.points, (double)load) && out.greatest == greatest, "%g and %g",
              out.softened_load, out.greatest);
    }
}

/* The exponential where it begins, where it ends, and where its pieces meet; NaN stays NaN or is 0, never a number */
TEST(test_exponential)
{
    static double reach[COR_PANEL], pressure[COR_PANEL], weight[COR_PANEL];
    for (size_t j = 0; j < COR_PANEL; j++)
        weight[j] = 1;
    const double ln2 = 0.69314718055994530942;
    const double x[] = {0, -0.0, 1,  -1, 0.5 * ln2, -0.5 * ln2, 1.5 * ln2, -1.5 * ln2, -699.99, nextafter(-700, 0),
                        5, 300,  690};
    enum { COUNT = sizeof x / sizeof *x };
    for (int i = 0; i < SETS; i++) {
        if (!cor_processor_has(sets[i].set))
            continue;
        for (size_t j = 0; j < COR_PANEL; j++)
            reach[j] = x[j % COUNT];
        sets[i].loops->press(COR_PANEL, 1, weight, reach, pressure);
        for (size_t j = 0; j < COR_PANEL; j++)
            check(relative_error(pressure[j], expl(reach[j])) <= 2 * DBL_EPSILON, "exp(%g) = %g", reach[j],
                  pressure[j]);
        const double none[] = {-700.0000001, -800, -1e10, -INFINITY, -1e300};
        for (size_t j = 0; j < COR_PANEL; j++)
            reach[j] = none[j % 5];
        assert_true(sets[i].loops->press(COR_PANEL, 1, weight, reach, pressure) == 0);
    }
}

RUN_TESTS(test_every_set, test_meaning, test_exponential)
