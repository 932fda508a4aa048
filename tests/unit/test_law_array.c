/* SPDX-License-Identifier: MIT */
/* Loops of the laws are their scalars to the last bit: every function, any length, any place, every instruction set,
 * numbers inside and outside the kernels' intervals and at their ends. (Public array functions:
 * test_environment.c.) */
#include "check.h"

#include <cor/cor.h>

#include "runtime/law/array.h"
#include "runtime/law/dashpot_array.h"

enum { COUNT = 700 };

static const char *const set_name[COR_INSTRUCTION_SETS] = {"portable", "AVX2", "AVX-512"};

static const struct {
    const char *name;
    double (*value)(double);
    double least, largest, seam; /* of the rows */
} loops[] = {
#define LOOP_ROW(name, public, least, largest, ...) {#name, cor_##public, least, largest, least},
#define FORM_ROWS(law, public, x, end, LAW, X, END)                                                                    \
    {#law "_eps" #end, cor_##public##_eps##end, 0, COR_ROWS_##LAW##_EPS##END##_END, COR_ROWS_##LAW##_LOSS##END##_END}, \
        {#law "_loss" #end, cor_##public##_loss##end, COR_INLINE_2_M900, COR_ROWS_##LAW##_EPS##END##_END,              \
         COR_ROWS_##LAW##_LOSS##END##_END},                                                                            \
        {#law "_" #x #end, cor_##public##_##x##end, COR_ROWS_##LAW##_##X##END##_FIRST, 1, 0.5},                        \
        {#law "_" #x "_of_loss" #end, cor_##public##_##x##_of_loss##end, COR_INLINE_2_M900, 1, 0.5},
    COR_LAW_LOOPS(LOOP_ROW) COR_CLOSED_FORMS(FORM_ROWS)};

static void fill(struct random_state *r, double *x, size_t n, double least, double largest, double seam)
{
    static const double specials[] = {0.0, -0.0,   INFINITY, -INFINITY, NAN,
                                      -1,  5e-324, 1,        1e300,     2.2250738585072014e-308};
    enum { SPECIALS = sizeof specials / sizeof *specials };
    for (size_t i = 0; i < n; i++) {
        const double kind = random_uniform(r, 0, 1);
        const double low = least > 1e-30 ? least : 1e-30, high = largest < 1e6 ? largest : 1e6;
        x[i] = kind < 0.6 ? random_uniform(r, low, high < 3 ? high : 3) : random_log(r, low, high);
        if (kind > 0.9)
            x[i] = specials[(size_t)random_uniform(r, 0, SPECIALS)];
        else if (kind > 0.85)
            x[i] = kind > 0.89   ? nextafter(seam, random_uniform(r, -1, 9))
                   : kind > 0.87 ? nextafter(largest, random_uniform(r, -1, 9))
                                 : nextafter(least, random_uniform(r, -1, 1));
        else if (kind > 0.8)
            x[i] = random_log(r, 1e-300, 1e300);
    }
}

static void loop_is_its_scalar(int number, int k, const char *set, struct random_state *random)
{
    const enum cor_law_loop loop = (enum cor_law_loop)k;
    double x[COUNT], y[COUNT + 1];
    float xf[COUNT], yf[COUNT];
    fill(random, x, COUNT, loops[k].least, loops[k].largest, loops[k].seam);
    for (size_t n = 0; n <= COUNT; n += n < 20 ? 1 : 97) {
        const size_t place = n % 5, m = n > place ? n - place : 0;
        y[m] = -7; /* a guard */
        cor_law_array_of_set(number, loop, x + place, y, m);
        assert_true(y[m] == -7);
        for (size_t i = 0; i < m; i++) {
            const double one = loops[k].value(x[place + i]);
            check(same_bits(one, y[i]) || (isnan(one) && isnan(y[i])), "%s, %s at %a: %a, not %a", set, loops[k].name,
                  x[place + i], y[i], one);
        }
    }
    /* in place */
    memcpy(y, x, sizeof x);
    cor_law_array_of_set(number, loop, y, y, COUNT);
    for (size_t i = 0; i < COUNT; i++) {
        const double one = loops[k].value(x[i]);
        assert_true(same_bits(one, y[i]) || (isnan(one) && isnan(y[i])));
    }
    /* floats, and in place */
    for (size_t i = 0; i < COUNT; i++)
        xf[i] = (float)x[i];
    cor_law_arrayf_of_set(number, loop, xf, yf, COUNT);
    for (size_t i = 0; i < COUNT; i++) {
        const float one = (float)loops[k].value((double)xf[i]);
        check(memcmp(&one, &yf[i], sizeof one) == 0 || (isnan(one) && isnan(yf[i])), "%s, %s of the float %a", set,
              loops[k].name, (double)xf[i]);
    }
    cor_law_arrayf_of_set(number, loop, xf, xf, COUNT);
    assert_memory_equal(xf, yf, sizeof xf);
}

TEST(every_set)
{
    struct random_state random = random_start();
    assert_int_equal(sizeof loops / sizeof *loops, COR_LAW_LOOP_COUNT);
    for (int set = 0; set < COR_INSTRUCTION_SETS; set++) {
        if (!cor_processor_has(set)) {
            assert_false(cor_law_array_of_set(set, COR_LAW_crossley_eps, NULL, NULL, 0));
            print_message("this processor has no %s\n", set_name[set]);
            continue;
        }
        for (int k = 0; k < COR_LAW_LOOP_COUNT; k++)
            loop_is_its_scalar(set, k, set_name[set], &random);
    }
}

/* ---- Hertz with a constant dashpot: loops over rows ---- */

static const struct {
    const char *name;
    double (*value)(double);
    double seam[4]; /* where the rows change */
} dashpots[] = {
#define OF_BETA(function) {#function, cor_hertz_dashpot_##function, {0.125, COR_HERTZ_DASHPOT_BETA_C, 0.628, 8}},
#define OF_EPS(function) {#function, cor_hertz_dashpot_##function, {0.5, 0x1p-60, 1, 0x1p-24}},
    COR_DASHPOT_LOOPS(OF_BETA, OF_EPS)};

/* Numbers of every kind of row: near 0, by octaves, next to the threshold or eps = 1, at the seams, and beyond */
static double dashpot_argument(struct random_state *r, const double seam[4])
{
    static const double specials[] = {0.0, -0.0, INFINITY, -INFINITY, NAN, -1, 5e-324, 1e300, 0x1p-900, 2.2e-308};
    enum { SPECIALS = sizeof specials / sizeof *specials };
    const double kind = random_uniform(r, 0, 1);
    if (kind < 0.3)
        return random_uniform(r, 0, 1.3);
    if (kind < 0.5)
        return random_log(r, 1e-6, 9);
    if (kind < 0.7)
        return seam[1] * (1 - random_log(r, 1e-16, 0.5));
    if (kind < 0.9) {
        double x = seam[(size_t)random_uniform(r, 0, 4)];
        for (int k = (int)random_uniform(r, 0, 4); k > 0; k--)
            x = nextafter(x, random_uniform(r, 0, 1) < 0.5 ? 0 : 9);
        return x;
    }
    return specials[(size_t)random_uniform(r, 0, SPECIALS)];
}

TEST(dashpot_every_set)
{
    struct random_state r = random_start();
    for (int set = 0; set < COR_INSTRUCTION_SETS; set++)
        for (int k = 0; k < COR_DASHPOT_LOOP_COUNT; k++)
            for (size_t n = 0; n <= COUNT; n += n < 20 ? 1 : 97) {
                double x[COUNT], y[COUNT + 1];
                /* some blocks are within the rows near 0 alone, or above them alone */
                const double from = n % 3 == 0 ? 0 : 0.2, to = n % 3 == 0 ? 0.1 : 1.1;
                for (size_t i = 0; i < n; i++)
                    x[i] = n % 3 == 2 ? dashpot_argument(&r, dashpots[k].seam) : random_uniform(&r, from, to);
                y[n] = -7; /* a guard */
                if (!cor_dashpot_array_of_set(set, (enum cor_dashpot_number)k, x, y, n))
                    continue;
                assert_true(y[n] == -7);
                for (size_t i = 0; i < n; i++) {
                    const double one = dashpots[k].value(x[i]);
                    check(same_bits(one, y[i]) || (isnan(one) && isnan(y[i])), "%s, %s at %a: %a, not %a",
                          set_name[set], dashpots[k].name, x[i], y[i], one);
                }
                assert_true(cor_dashpot_array_of_set(set, (enum cor_dashpot_number)k, x, x, n)); /* in place */
                check(n == 0 || memcmp(x, y, n * sizeof *x) == 0, "%s, %s in place", set_name[set], dashpots[k].name);
            }
}

RUN_TESTS(every_set, dashpot_every_set)
