/* SPDX-License-Identifier: MIT */
#include "runtime/disk/collision_error.h"

#include <math.h>

/* The next run would move the result by about the last movement times the ratio of the last two. The runs after it
 * would move the result by less and less: the sum is a geometric series. Movements are those of all energies, because
 * that of eps alone may be small by chance. */
static double series_error(const struct cor_collision_evidence *evidence)
{
    const int runs = evidence->runs;
    const double *const movement = evidence->movement + runs - 1; /* the last one */
    if (runs == 2)
        return cor_tuning.two_runs * movement[0];
    double ratio = runs == 3 ? cor_tuning.third_ratio : cor_tuning.later_ratio;
    if (movement[-1] > 0)
        ratio = fmax(ratio, movement[0] / movement[-1]);
    if (runs > 3 && movement[-2] > 0)
        ratio = fmax(ratio, movement[-1] / movement[-2]);
    const double last = fmax(movement[0], cor_tuning.least_movement * movement[-1]);
    return ratio < cor_tuning.no_convergence ? last * ratio / (1 - ratio)
                                             : cor_tuning.scatter * fmax(movement[0], movement[-1]);
}

/* At a hard wall the rim strikes in many blows, which amplify the error of each run. The errors of eps and of all
 * energies then grow along one direction, so all of them may be small by chance in the same run. The series therefore
 * counts no more than a bound by the last two movements. Round-off moves the result, too, and counts elsewhere. */
static double blows_error(const struct cor_collision_evidence *evidence, double round_off)
{
    const double *const movement = evidence->movement + evidence->runs - 1;
    if (evidence->runs == 2)
        return cor_tuning.hard_two_runs * movement[0];
    return fmax(cor_tuning.hard_movement * fmax(movement[0] - round_off, 0), cor_tuning.hard_before * movement[-1]);
}

double cor_collision_step_error(const struct cor_motion *m, const struct cor_collision_evidence *evidence,
                                double round_off)
{
    if (evidence->runs < 2)
        return 1; /* eps lies between 0 and 1, and one run shows no error */
    const double error = series_error(evidence);
    return m->alpha * m->speed < cor_tuning.hard ? error : fmax(error, blows_error(evidence, round_off));
}

/* The pressure's harmonics fall off exponentially. With phi angles the harmonic 4 phi - k aliases k; the worst case is
 * the largest k. With half the angles the harmonic 2 phi aliases the load. The change of the load therefore measures
 * the decay of the harmonics. */
double cor_collision_quadrature_error(const struct cor_motion *m, const struct cor_collision_run *run)
{
    const double power = 2 - 0.5 * (double)m->size.n_max / (double)m->phi;
    return power > 0 && run->ripple < run->max_load ? pow(run->ripple / run->max_load, power) : 1;
}

/* The collision amplifies the error of the quadrature as any other. The runs bound the amplification without regard to
 * what calm collisions show, so that this estimate may be far too large; a run with other angles measures the error. */
static double angles_error(const struct cor_motion *m, const struct cor_collision_run *run,
                           const struct cor_collision_evidence *evidence)
{
    if (evidence->angles_measured)
        return cor_tuning.angles_in_eps * evidence->by_angles;
    const double quadrature = cor_collision_quadrature_error(m, run);
    const double amplification = evidence->amplification * (evidence->measured ? 1 : cor_tuning.bound_amplifies);
    return quadrature < 1 ? fmin(1, quadrature * fmax(cor_tuning.quadrature_in_eps, amplification)) : 1;
}

void cor_collision_other_errors(const struct cor_motion *m, const struct cor_collision_run *run, double left,
                                const struct cor_collision_evidence *evidence, struct cor_collision_error *error)
{
    const double steps = (double)run->steps, amplification = evidence->amplification, half_ulp = 0x1p-53;
    const double wall = cor_tuning.wall_left * fmin(m->tolerance, cor_tuning.wall_tolerance);
    error->angles = angles_error(m, run, evidence);
    error->round_off = half_ulp * (sqrt(steps) * (1 + cor_tuning.random_walk * amplification) +
                                   cor_tuning.steady_drift * steps * sqrt(left) * (1 + 0.5 * amplification));
    error->wall = cor_tuning.wall_in_eps * wall * (1 + amplification);
}

double cor_collision_lasting_error(const struct cor_collision_error *error)
{
    return error->round_off + error->wall;
}

double cor_collision_total_error(const struct cor_collision_error *error)
{
    return fmin(1, error->step + error->angles + cor_collision_lasting_error(error));
}
