/* SPDX-License-Identifier: MIT */
/* The step is of order 2, but a change of variables makes it conjugate to a step of order 4. The change is the identity
 * where the wall exerts no force. Quantities measured long before and long after the contact, such as eps, therefore
 * have an error c_4 h^4 + c_6 h^6 + .... The powers are even because the step is symmetric. */
#include "runtime/disk/collision_extrapolation.h"

#include <math.h>
#include <string.h>

enum { LEVELS = COR_COLLISION_LEVELS };

/* First powers of h in the errors of quantities measured after the contact and during it */
enum { AFTER = 4, AMIDST = 2 };

/* Weights of the last `levels` runs in the extrapolation of a series in h^first, h^(first + 2), ... by Neville's
 * scheme; h^2 halves from run to run. */
static void extrapolation_weights(int levels, int first, double weight[LEVELS])
{
    double row[LEVELS][LEVELS];
    memset(row, 0, sizeof row);
    memset(weight, 0, LEVELS * sizeof *weight);
    if (levels < 1)
        return;
    for (int i = 0; i < levels; i++)
        row[i][i] = 1;
    for (int j = 1; j < levels; j++) {
        const double ratio = ldexp(1, first / 2 + j - 1);
        for (int i = levels - 1; i >= j; i--)
            for (int k = 0; k < levels; k++)
                row[i][k] += (row[i][k] - row[i - 1][k]) / (ratio - 1);
    }
    memcpy(weight, row[levels - 1], LEVELS * sizeof *weight);
}

/* Weights of the runs in the change of the result by the last run */
static void movement_weights(int levels, double weight[LEVELS])
{
    double before[LEVELS];
    extrapolation_weights(levels, AFTER, weight);
    extrapolation_weights(levels - 1, AFTER, before);
    for (int k = 0; k < levels - 1; k++)
        weight[k] -= before[k];
}

static double weighted_eps(const struct cor_collision_run *run, int levels, const double weight[LEVELS])
{
    double eps = 0;
    for (int k = 0; k < levels; k++)
        eps += weight[k] * run[k].eps;
    return eps;
}

static double weighted_after(const struct cor_motion *m, size_t mode, int levels, const double weight[LEVELS])
{
    double after = 0;
    for (int k = 0; k < levels; k++)
        after += weight[k] * m->after[k][mode];
    return after;
}

double cor_collision_results(const struct cor_motion *m, const struct cor_collision_run *run, int levels,
                             struct cor_disk_collision *out, double *energy_after)
{
    double less_than_none = 0;
    double weight[LEVELS];
    const struct cor_disk_collision none = {0, 0, 0, 0, 0, run[levels - 1].steps, out->error_estimate};
    *out = none;
    extrapolation_weights(levels, AFTER, weight);
    for (int k = 0; k < levels; k++) {
        out->eps += weight[k] * run[k].eps;
        out->max_compression += weight[k] * run[k].max_compression;
    }
    for (size_t i = 0; i < m->size.modes; i++) {
        const double after = weighted_after(m, i, levels, weight);
        less_than_none += fmax(-after, 0);
        out->one_minus_eps2 += fmax(after, 0);
        if (energy_after != NULL)
            energy_after[i] = fmax(after, 0);
    }
    out->energy_drift = out->eps * out->eps + out->one_minus_eps2 - 1;
    /* the first run does not know the load that defines the contact */
    const int first = run[0].number < 1;
    if (levels == first)
        out->contact_time = NAN;
    extrapolation_weights(levels - first, AFTER, weight);
    for (int k = first; k < levels; k++)
        out->contact_time += weight[k - first] * run[k].contact_time;
    return less_than_none;
}

void cor_collision_averages(const struct cor_motion *m, const struct cor_collision_run *run, int levels,
                            double *energy_average)
{
    double weight[LEVELS];
    /* Run number 2 is the first that averages. It averages over the contact of run 1, and the contact of run 1 is
     * defined by the largest load of run 0. */
    const int first = run[0].number < 2 ? 2 - run[0].number : 0;
    extrapolation_weights(levels - first, AMIDST, weight);
    for (size_t i = 0; i < m->size.modes; i++) {
        double average = levels > first ? 0 : NAN;
        for (int k = first; k < levels; k++)
            average += weight[k - first] * m->average[k][i];
        energy_average[i] = levels > first ? fmax(average, 0) : NAN;
    }
}

/* The larger of a weighted eps and half the norm of weighted energies */
static double weighted_norm(const struct cor_motion *m, const struct cor_collision_run *run, int levels,
                            const double weight[LEVELS])
{
    double sum = 0;
    for (size_t i = 0; i < m->size.modes; i++) {
        const double after = weighted_after(m, i, levels, weight);
        sum += after * after;
    }
    return fmax(fabs(weighted_eps(run, levels, weight)), 0.5 * sqrt(sum));
}

double cor_collision_movement(const struct cor_motion *m, const struct cor_collision_run *run, int levels)
{
    double weight[LEVELS];
    movement_weights(levels, weight);
    return weighted_norm(m, run, levels, weight);
}

double cor_collision_difference(const struct cor_motion *m, const struct cor_collision_run *run, int levels)
{
    double weight[LEVELS] = {0};
    weight[levels - 1] = 1;
    weight[levels - 2] = -1;
    return weighted_norm(m, run, levels, weight);
}
