/* SPDX-License-Identifier: MIT */
#include "runtime/disk/collision_parts.h"

#include <math.h>

#include "cor/status.h"

/* ---- extrapolation ----
 *
 * The step is of order 2, but a change of variables makes it conjugate to a step of order 4. This change is the
 * identity where the wall exerts no force. Quantities measured long before and long after the contact, such as eps,
 * therefore have an error c_4 h^4 + c_6 h^6 + .... The powers are even because the step is symmetric. */

enum { LEVELS = COR_COLLISION_LEVELS };

/* Lowest power of h in the error of a quantity. AFTER: a quantity after the contact. AMIDST: one during it */
enum { AFTER = 4, AMIDST = 2 };

/* Computes the weights of the last `levels` runs in the extrapolation of a series in h^first, h^(first + 2), ... by
 * Neville's scheme. h^2 halves from run to run. */
static void extrapolation_weights(int levels, int first, double weight[LEVELS])
{
    double row[LEVELS][LEVELS] = {{0}};
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

/* Computes the weights of the runs in a movement: extrapolation of all runs minus extrapolation without the last
 * run. */
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
    /* the load that defines the contact is unknown in the first run */
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

/* Returns the larger of a weighted eps and half the norm of weighted energies. */
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

/* ---- error ---- */

/* Estimates the error from the movements. The next run would move the result by about the last movement times the ratio
 * of the last two. Later runs would move it less and less, so the error is a geometric series. Movements include all
 * energies, because the movement of eps may be small by chance. */
static double series_error(const struct cor_collision_evidence *evidence)
{
    const int runs = evidence->runs;
    const double *const movement = evidence->movement + runs - 1; /* the last one */
    if (runs == 2)
        return COR_TUNING_TWO_RUNS * movement[0];
    double ratio = runs == 3 ? COR_TUNING_THIRD_RATIO : COR_TUNING_LATER_RATIO;
    if (movement[-1] > 0)
        ratio = fmax(ratio, movement[0] / movement[-1]);
    if (runs > 3 && movement[-2] > 0)
        ratio = fmax(ratio, movement[-1] / movement[-2]);
    const double last = fmax(movement[0], COR_TUNING_LEAST_MOVEMENT * movement[-1]);
    return ratio < COR_TUNING_NO_CONVERGENCE ? last * ratio / (1 - ratio)
                                             : COR_TUNING_SCATTER * fmax(movement[0], movement[-1]);
}

/* Returns a lower bound on the error at a hard wall. There the rim hits the wall many times, which amplifies the error
 * of each run. The errors of eps and of all energies then grow along one direction, so all of them may be small by
 * chance in the same run. The last two movements give the bound. Round-off is part of another term. */
static double blows_error(const struct cor_collision_evidence *evidence, double round_off)
{
    const double *const movement = evidence->movement + evidence->runs - 1;
    if (evidence->runs == 2)
        return COR_TUNING_HARD_TWO_RUNS * movement[0];
    return fmax(COR_TUNING_HARD_MOVEMENT * fmax(movement[0] - round_off, 0), COR_TUNING_HARD_BEFORE * movement[-1]);
}

double cor_collision_step_error(const struct cor_motion *m, const struct cor_collision_evidence *evidence,
                                double round_off)
{
    if (evidence->runs < 2)
        return 1; /* one run gives no estimate; eps is from 0 to 1 */
    const double error = series_error(evidence);
    return m->alpha * m->speed < COR_TUNING_HARD ? error : fmax(error, blows_error(evidence, round_off));
}

/* The harmonics of the pressure decrease exponentially. If the number of angles is phi, the harmonic 4 phi - k
 * aliases k; the worst case is the largest k. With half the angles the harmonic 2 phi aliases the load. The change of
 * the load measures the decay. */
double cor_collision_quadrature_error(const struct cor_motion *m, const struct cor_collision_run *run)
{
    const double power = 2 - 0.5 * (double)m->size.n_max / (double)m->phi;
    return power > 0 && run->ripple < run->max_load ? pow(run->ripple / run->max_load, power) : 1;
}

/* Returns the error due to the angles. The collision amplifies the error of the quadrature like any other error. In
 * calm collisions the bound on the amplification may be far too large; a run with other angles measures the error. */
static double angles_error(const struct cor_motion *m, const struct cor_collision_run *run,
                           const struct cor_collision_evidence *evidence)
{
    if (evidence->angles_measured)
        return COR_TUNING_ANGLES_IN_EPS * evidence->by_angles;
    const double quadrature = cor_collision_quadrature_error(m, run);
    const double amplification = evidence->amplification * (evidence->measured ? 1 : COR_TUNING_BOUND_AMPLIFIES);
    return quadrature < 1 ? fmin(1, quadrature * fmax(COR_TUNING_QUADRATURE_IN_EPS, amplification)) : 1;
}

void cor_collision_other_errors(const struct cor_motion *m, const struct cor_collision_run *run, double left,
                                const struct cor_collision_evidence *evidence, struct cor_collision_error *error)
{
    const double steps = (double)run->steps, amplification = evidence->amplification, half_ulp = 0x1p-53;
    const double wall = COR_TUNING_WALL_LEFT * fmin(m->tolerance, COR_TUNING_WALL_TOLERANCE);
    error->angles = angles_error(m, run, evidence);
    error->round_off = half_ulp * (sqrt(steps) * (1 + COR_TUNING_RANDOM_WALK * amplification) +
                                   COR_TUNING_STEADY_DRIFT * steps * sqrt(left) * (1 + 0.5 * amplification));
    error->wall = COR_TUNING_WALL_IN_EPS * wall * (1 + amplification);
}

double cor_collision_lasting_error(const struct cor_collision_error *error)
{
    return error->round_off + error->wall;
}

double cor_collision_total_error(const struct cor_collision_error *error)
{
    return fmin(1, error->step + error->angles + cor_collision_lasting_error(error));
}

/* ---- a call ---- */

/* The runs stored for the extrapolation. All have the same angles. Their steps decrease by COR_COLLISION_RATIO. */
struct runs {
    struct cor_collision_run run[COR_COLLISION_LEVELS + 1]; /* the last place is for the current run */
    int levels;
    double h; /* step of the next run */
    int cuts;
    enum cor_collision_outcome outcome; /* outcome of the last run */
    struct cor_collision_evidence evidence;
    struct cor_collision_error error;
    double left, less_than_none; /* energy in the modes; sum of the negative extrapolated energies */
};

/* ---- steps and angles ---- */

/* Returns the largest safe step, or a smaller one for small tolerances, so that few runs suffice. The comparison avoids
 * a division by a speed that may be tiny. */
static double first_step(const struct cor_motion *m)
{
    const double sigma = m->alpha * m->speed;
    const int turns = COR_TUNING_MAX_TURN * sigma < COR_TUNING_MAX_RISE * m->size.omega_max;
    const double safe = turns ? COR_TUNING_MAX_TURN / m->size.omega_max : COR_TUNING_MAX_RISE / sigma;
    return safe * fmin(1, pow(m->tolerance / COR_TUNING_EASY_TOLERANCE, 1.0 / 8));
}

static int too_few_angles(const struct cor_motion *m, const struct cor_collision_run *run)
{
    return cor_collision_quadrature_error(m, run) > COR_TUNING_QUADRATURE_ALLOWED * m->tolerance;
}

/* Discards all runs and starts again with the step h, after a change of the angles or of the largest step. */
static void runs_restart(struct runs *runs, double h)
{
    runs->levels = runs->evidence.runs = runs->evidence.angles_measured = 0;
    runs->h = h;
}

/* Multiplies the number of angles by 1 + growth, up to phi_limit, and starts again. Returns 0 if the number is
 * phi_limit already. */
static int runs_restart_finer(struct cor_motion *m, struct runs *runs, double growth, double h)
{
    if (m->phi >= m->phi_limit)
        return 0;
    const size_t phi = m->phi + (size_t)(growth * (double)m->phi) + 1;
    cor_motion_set_angles(m, phi < m->phi_limit ? phi : m->phi_limit, 0);
    runs_restart(runs, h);
    return 1;
}

/* ---- runs ---- */

/* Moves the array of the first level to the end. */
static void rotate_levels(double **level)
{
    double *const first = level[0];
    memmove(level, level + 1, (COR_COLLISION_LEVELS - 1) * sizeof *level);
    level[COR_COLLISION_LEVELS - 1] = first;
}

static void runs_forget_first(struct cor_motion *m, struct runs *runs)
{
    memmove(runs->run, runs->run + 1, (COR_COLLISION_LEVELS - 1) * sizeof *runs->run);
    rotate_levels(m->after);
    rotate_levels(m->average);
    runs->levels--;
}

/* Repeats the run with all angles if the window was too narrow. */
static enum cor_collision_outcome run_widely(struct cor_motion *m, struct cor_collision_run *run,
                                             const struct cor_collision_run *before, double *average,
                                             const struct cor_disk_collision_detail *detail)
{
    enum cor_collision_outcome outcome = cor_collision_run(m, run, before, average, detail);
    if (outcome == COR_RUN_TOO_NARROW) {
        run->all_angles = 1;
        outcome = cor_collision_run(m, run, before, average, detail);
    }
    return outcome;
}

static enum cor_collision_outcome runs_make(struct cor_motion *m, struct runs *runs, int averages)
{
    if (runs->levels == COR_COLLISION_LEVELS)
        runs_forget_first(m, runs);
    struct cor_collision_run *const run = &runs->run[runs->levels];
    const struct cor_collision_run *const before = runs->levels > 0 ? run - 1 : NULL;
    memset(run, 0, sizeof *run);
    run->h = runs->h;
    run->number = before == NULL ? 0 : before->number + 1;
    run->all_angles = before != NULL && before->all_angles;
    return run_widely(m, run, before, averages && run->number >= 2 ? m->average[runs->levels] : NULL, NULL);
}

/* Stores the last run and the energies that it left in the modes. */
static void runs_keep(struct cor_motion *m, struct runs *runs)
{
    for (size_t i = 0; i < m->size.modes; i++)
        m->after[runs->levels][i] = cor_collision_mode_energy(m, i) / (0.5 * COR_DISK_MASS * m->speed * m->speed);
    runs->levels++;
    runs->evidence.runs++;
    runs->h /= COR_COLLISION_RATIO;
}

/* True if the budget suffices for a run that takes `times` the work of the last one. */
static int runs_affordable(const struct cor_motion *m, const struct runs *runs, double times)
{
    const struct cor_collision_run *const last = &runs->run[runs->levels - 1];
    return times * last->work <= m->work_left && times * (double)last->steps <= COR_DISK_COLLISION_MAX_STEPS;
}

/* ---- error ---- */

/* Bounds the amplification: the last two runs differ by the error due to the step times the amplification. */
static void bound_amplification(const struct cor_motion *m, struct runs *runs)
{
    struct cor_collision_evidence *const evidence = &runs->evidence;
    const double stiffness = runs->run[runs->levels - 2].stiffness;
    if (evidence->measured || !(stiffness > 0))
        return;
    const double bound =
        cor_collision_difference(m, runs->run, runs->levels) / (COR_TUNING_LEAST_SENSITIVITY * stiffness * stiffness);
    evidence->amplification = fmax(evidence->amplification, bound);
}

/* Repeats a run after a change of speed or angles. Sets *eps to the change of eps and *energies to the norm of the
 * changes of the mode energies. Returns 0 if the run failed. */
static int runs_repeat(struct cor_motion *m, const struct runs *runs, int level, double *eps, double *energies)
{
    const struct cor_collision_run *const run = &runs->run[level];
    struct cor_collision_run twin = *run;
    if (run_widely(m, &twin, level > 0 ? run - 1 : NULL, NULL, NULL) != COR_RUN_ENDED)
        return 0;
    double sum = 0;
    for (size_t i = 0; i < m->size.modes; i++) {
        const double after = cor_collision_mode_energy(m, i) / (0.5 * COR_DISK_MASS * m->speed * m->speed);
        sum += (after - m->after[level][i]) * (after - m->after[level][i]);
    }
    *eps = fabs(twin.eps - run->eps);
    *energies = sqrt(sum);
    return 1;
}

/* Measures the amplification: the change of the result divided by the relative change of v. An early run measures it as
 * well as a later one, and costs less. */
static void measure_amplification(struct cor_motion *m, struct runs *runs)
{
    const double speed = m->speed, change = COR_TUNING_PERTURBATION;
    double eps, energies;
    if (runs->evidence.measured || !runs_affordable(m, runs, 1))
        return;
    m->speed = speed * (1 + change);
    if (runs_repeat(m, runs, runs->levels < 4 ? runs->levels - 2 : 2, &eps, &energies)) {
        runs->evidence.amplification = fmax(eps, energies) / change;
        runs->evidence.measured = 1;
    }
    m->speed = speed;
}

/* Measures the error due to the angles. With shifted angles the quadrature has the opposite error, which the collision
 * amplifies equally. Runs with much larger steps are unsuitable, because they may not converge yet. */
static void measure_angles(struct cor_motion *m, struct runs *runs)
{
    double eps, energies;
    if (runs->evidence.angles_measured || !runs_affordable(m, runs, 1))
        return;
    cor_motion_set_angles(m, m->phi, 1);
    if (runs_repeat(m, runs, runs->levels - 2, &eps, &energies)) {
        runs->evidence.by_angles = fmax(eps, 0.5 * energies);
        runs->evidence.angles_measured = 1;
    }
    cor_motion_set_angles(m, m->phi, 0);
}

/* Sets the parts of the error after the last run. Returns their sum. */
static double runs_estimate(const struct cor_motion *m, struct runs *runs)
{
    cor_collision_other_errors(m, &runs->run[runs->levels - 1], runs->left, &runs->evidence, &runs->error);
    const double step = cor_collision_step_error(m, &runs->evidence, runs->error.round_off);
    /* negative mode energies show that the steps are still too large to extrapolate */
    runs->error.step = fmax(step, 0.5 * runs->less_than_none);
    return cor_collision_total_error(&runs->error);
}

/* Sets the results of two or more stored runs, and their error estimate. */
static void runs_conclude(struct cor_motion *m, struct runs *runs, struct cor_disk_collision *out, double *energy_after)
{
    struct cor_collision_evidence *const evidence = &runs->evidence;
    runs->less_than_none = cor_collision_results(m, runs->run, runs->levels, out, energy_after);
    runs->left = out->one_minus_eps2;
    evidence->movement[evidence->runs - 1] = cor_collision_movement(m, runs->run, runs->levels);
    bound_amplification(m, runs);
    out->error_estimate = runs_estimate(m, runs);
    if (runs->error.angles > COR_TUNING_ANGLES_SHARE * m->tolerance && runs->error.step <= m->tolerance) {
        measure_angles(m, runs);
        out->error_estimate = runs_estimate(m, runs);
    }
    if (out->error_estimate > m->tolerance &&
        runs->error.step <= fmax(m->tolerance, cor_collision_lasting_error(&runs->error))) {
        measure_amplification(m, runs);
        out->error_estimate = runs_estimate(m, runs);
    }
}

/* ---- a call ---- */

enum verdict { GO_ON, SETTLED, GIVEN_UP };

static enum verdict runs_judge(const struct cor_motion *m, const struct runs *runs)
{
    const struct cor_collision_evidence *const evidence = &runs->evidence;
    const double *const movement = &evidence->movement[evidence->runs - 1];
    const double angles = evidence->angles_measured ? runs->error.angles : 0;
    if (cor_collision_total_error(&runs->error) <= m->tolerance)
        return SETTLED;
    if (runs->error.step <= angles + cor_collision_lasting_error(&runs->error))
        return GIVEN_UP;
    if (evidence->runs < COR_TUNING_PATIENCE)
        return GO_ON;
    const int converging = movement[0] <= COR_TUNING_HOPELESS * movement[-COR_TUNING_RUNS_BEFORE];
    return converging && evidence->runs < COR_COLLISION_RUNS ? GO_ON : GIVEN_UP;
}

/* Makes one more run, and stores it or starts again. Returns 0 if no further run is possible. */
static int runs_advance(struct cor_motion *m, struct runs *runs, int averages)
{
    if (runs->levels > 0 && !runs_affordable(m, runs, COR_COLLISION_RATIO))
        return 0;
    runs->outcome = runs_make(m, runs, averages);
    if (runs->outcome == COR_RUN_TOO_LONG)
        return 0;
    if (runs->outcome != COR_RUN_ENDED) {
        runs_restart(runs, runs->h / COR_COLLISION_RATIO);
        return runs->cuts++ < COR_TUNING_MAX_CUTS;
    }
    if (!too_few_angles(m, &runs->run[runs->levels]) || !runs_restart_finer(m, runs, COR_TUNING_LEAST_GROWTH, runs->h))
        runs_keep(m, runs);
    return 1;
}

/* Starts again with more angles if their measured error exceeds its share of the tolerance. If this error decreases
 * like the quadrature error, the new number reduces it to half the share. The last three runs are repeated. */
static int runs_improve_angles(struct cor_motion *m, struct runs *runs)
{
    const struct cor_collision_run *const last = &runs->run[runs->levels - 1];
    const double share = COR_TUNING_ANGLES_WANTED * m->tolerance, quadrature = cor_collision_quadrature_error(m, last);
    if (!runs->evidence.angles_measured || runs->error.angles <= share || !runs_affordable(m, runs, 3))
        return 0;
    const double growth = quadrature < 1 ? log(0.5 * share / runs->error.angles) / log(quadrature) : 1;
    return runs_restart_finer(m, runs, fmin(fmax(growth, COR_TUNING_LEAST_GROWTH), 1),
                              runs->run[runs->levels > 3 ? runs->levels - 3 : 0].h);
}

/* Makes runs until the error is small enough, or cannot be made small enough. */
static void runs_settle(struct cor_motion *m, struct runs *runs, struct cor_disk_collision *out,
                        const struct cor_disk_collision_detail *detail)
{
    enum verdict verdict = GO_ON;
    while (verdict == GO_ON) {
        if (!runs_advance(m, runs, detail->energy_average != NULL))
            verdict = GIVEN_UP;
        else if (runs->levels > 1) {
            runs_conclude(m, runs, out, detail->energy_after);
            verdict = runs_judge(m, runs);
            if (verdict != GO_ON && runs_improve_angles(m, runs))
                verdict = GO_ON;
        }
    }
    /* the bound on the amplification may be far too large, so the error due to the angles is measured */
    if (verdict == GIVEN_UP && runs->levels > 1 && runs->error.angles > runs->error.step) {
        measure_angles(m, runs);
        out->error_estimate = runs_estimate(m, runs);
    }
}

static void runs_add_details(struct cor_motion *m, struct runs *runs, const struct cor_disk_collision_detail *detail)
{
    if (detail->energy_average != NULL) {
        /* a further run, which only the averages need */
        if (runs->evidence.runs == 2 && runs_affordable(m, runs, COR_COLLISION_RATIO) &&
            runs_make(m, runs, 1) == COR_RUN_ENDED)
            runs_keep(m, runs);
        cor_collision_averages(m, runs->run, runs->levels, detail->energy_average);
    }
    if (detail->observe != NULL && runs->levels > 0) {
        struct cor_collision_run *const last = &runs->run[runs->levels - 1];
        m->work_left = INFINITY;
        cor_collision_run(m, last, runs->levels > 1 ? last - 1 : NULL, NULL, detail);
    }
}

int cor_collision_runs(struct cor_motion *m, struct cor_disk_collision *out,
                       const struct cor_disk_collision_detail *detail)
{
    static const struct cor_disk_collision_detail no_detail;
    struct runs runs = {.h = first_step(m)};
    detail = detail != NULL ? detail : &no_detail;
    runs_settle(m, &runs, out, detail);
    if (isnan(out->eps) && runs.levels == 1) {
        cor_collision_results(m, runs.run, 1, out, detail->energy_after);
        out->error_estimate = cor_collision_step_error(m, &runs.evidence, 0);
    }
    if (isnan(out->eps)) {
        out->steps = runs.run[runs.levels].steps;
        return runs.outcome == COR_RUN_TOO_LONG ? COR_CONTACT_NOT_ENDED : COR_TOLERANCE_NOT_REACHED;
    }
    runs_add_details(m, &runs, detail);
    return out->error_estimate <= m->tolerance ? COR_OK : COR_TOLERANCE_NOT_REACHED;
}
