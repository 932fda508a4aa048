/* SPDX-License-Identifier: MIT */
/* Tests the reference of the accuracy test against balls of collision_solve with 30 digits, at random beta. */
#include "enclosure/collision.h"
#include "reference.h"
#include "search.h"
#include "support/formula.h"
#include "support/local.h"

#include <math.h>
#include <stdio.h>

/* Largest allowed relative difference: 2^-61, or 1/256 unit of the last place of a double. */
static const double MAX_DIFFERENCE = 0x1p-61;
enum { BITS = 100 };

static double difference(enum quantity quantity, double beta, const arb_t exact)
{
    const long double value = reference_value(quantity, beta);
    const double high = (double)value, low = (double)(value - high);
    LOCAL(arb, x);
    LET(x, 2 * BITS, "abs((high + low)/exact - 1)", high, low, exact);
    return arf_get_d(arb_midref(x), ARF_RND_UP);
}

/* Compares all quantities at random beta between the limits. */
static bool compare(struct random_state *state, double low, double high, uint64_t count)
{
    struct worst worst = {0};
    LOCAL(collision, c);
    LOCAL(arb, beta, loss);
    for (uint64_t i = 0; i < count; i++) {
        const double b = random_log(state, low, high);
        arb_set_d(beta, b);
        /* 1 - eps loses digits for small beta; between beta = 8 and 16 the motion needs twice the bits */
        const slong bits = b < 1 ? BITS - (slong)logb(b) : b > 8 && b < 16 ? 2 * BITS : BITS;
        if (collision_solve(c, beta, &law_sphere, bits) != 0)
            return false;
        const arb_srcptr exact[QUANTITIES] = {
            [EPS_ZERO_OVERLAP] = c->eps_zero_overlap,
            [EPS_ZERO_FORCE] = c->eps_zero_force,
            [DURATION_ZERO_OVERLAP] = c->t_zero_overlap,
            [DURATION_ZERO_FORCE] = c->t_zero_force,
            [MAX_OVERLAP] = c->x_max,
            [TIME_OF_MAX_OVERLAP] = c->t_max,
        };
        for (int q = 0; q < QUANTITIES; q++) {
            const arb_srcptr eps = q == LOSS_ZERO_OVERLAP ? c->eps_zero_overlap : c->eps_zero_force;
            LET(loss, 4 * BITS, "1 - eps", eps);
            worst_take(&worst, difference((enum quantity)q, b, exact[q] != NULL ? exact[q] : loss), b);
        }
    }
    const bool good = worst.error <= MAX_DIFFERENCE;
    printf("%s  reference, %g <= beta <= %g: %llu points, worst relative difference %.3g = 2^%.2f at %a\n",
           good ? "ok  " : "FAIL", low, high, (unsigned long long)count, worst.error, log2(worst.error), worst.at);
    return good;
}

/* Tests the series, the interpolation and the asymptotics at a few points each. */
bool reference_is_good(const struct search_options *o)
{
    static const struct {
        double low, high;
        uint64_t points;
    } part[] = {{1e-6, 0.125, 7}, {1e-60, 1e-6, 2}, {0.125, 1, 6},   {1, 4, 6},        {4, 8, 4},
                {8, 16, 2},       {16, 64, 2},      {64, 0x1p48, 2}, {0x1p48, 1e17, 1}};
    const uint64_t times = o->points < 10000000 ? 1 : 12;
    struct random_state state = random_seeded(o->seed);
    bool good = true;
    for (size_t i = 0; i < COUNT_OF(part); i++)
        good = compare(&state, part[i].low, part[i].high, times * part[i].points) && good;
    return good;
}
