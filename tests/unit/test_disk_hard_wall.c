/* SPDX-License-Identifier: MIT */
/* Tests the public functions of the rigid wall (runtime/disk/hard_wall.c) against values from another program, and the
 * error estimate against results with two more levels. Speeds go down to the smallest double. */
#include "check.h"

#include <cor/disk.h>
#include <cor/status.h>

#include "runtime/disk/hard_wall_parts.h"

static const double pi = 3.14159265358979323846;

static double first_omega(size_t level)
{
    return 15 * pow(2, 0.5 * (double)level);
}

/* Terms of every error estimate: NOISE for the coarsest steps, UNSEEN/Omega^2 for waves that a level does not resolve
 * */
#define NOISE 8e-7
#define UNSEEN 0.07

/* Returns the modes for this number of levels. They are stored until another nu or more levels are requested. */
static struct cor_disk_modes modes_of(double nu, size_t levels)
{
    static struct cor_disk_modes made;
    const size_t count = cor_disk_modes_below(nu, first_omega(levels - 1) * (1 + 1e-9)) + 1;
    if (made.nu != nu || made.count < count) {
        free((void *)made.mode);
        struct cor_disk_mode *const mode = malloc(count * sizeof *mode);
        assert_non_null(mode);
        assert_int_equal(cor_disk_modes_compute(nu, count, mode, &made), COR_OK);
    }
    return (struct cor_disk_modes){nu, count, made.mode};
}

/* Computes a collision, whose status must agree with its estimate. */
static struct cor_disk_hard_wall wall_collide(double nu, size_t levels, double speed, double tolerance)
{
    const struct cor_disk_modes modes = modes_of(nu, levels);
    const struct cor_disk_hard_wall_options options = {tolerance, tolerance > 1e-6 ? 0 : SIZE_MAX};
    struct cor_disk_hard_wall out;
    const int status = cor_disk_hard_wall(&modes, modes.count, &options, speed, &out);
    check(status == (out.error_estimate <= tolerance ? COR_OK : COR_TOLERANCE_NOT_REACHED),
          "nu = %g, v = %g, tolerance %g: %s", nu, speed, tolerance, cor_status_text(status));
    return out;
}

static void same_results(const struct cor_disk_hard_wall *x, const struct cor_disk_hard_wall *y, const char *what)
{
    check(memcmp(x, y, sizeof *x) == 0, "%s: 1 - eps^2 = %a and %a", what, x->one_minus_eps2, y->one_minus_eps2);
}

/* True for sanitizers, for which one scene is enough, because the other scenes run the same code. */
static int for_memory_only(void)
{
    return points(10) < 2;
}

/* ---- values ---- */

/* Results of another author's prototype of the method, with the errors that it states */
TEST(known_answers)
{
    static const struct {
        double speed, one_minus_eps2, error;
    } known[] = {{0.03, 0.0332486, 5e-7}, {0.1, 0.1030896, 5e-7}, {0.3, 0.293641, 3e-6}};
    for (size_t i = 0; i < 3 && i < points(3); i++) {
        const struct cor_disk_hard_wall out = wall_collide(0.33, 10, known[i].speed, 1e-5);
        check(fabs(out.one_minus_eps2 - known[i].one_minus_eps2) < 1e-6 + known[i].error, "v = %g: %.8f, not %.7f",
              known[i].speed, out.one_minus_eps2, known[i].one_minus_eps2);
        check(out.error_estimate <= 1e-5, "%g", out.error_estimate);
        check(fabs(out.eps * out.eps + out.one_minus_eps2 - 1) < 1e-15, "eps = %.17g", out.eps);
    }
    if (for_memory_only())
        return;
    /* where levels agree well, the estimate is little more than its terms NOISE and UNSEEN/Omega^2 */
    const struct cor_disk_hard_wall out = wall_collide(0.33, 10, 1e-7, 4e-6);
    const double omega = first_omega(out.omega_levels - 1), least = NOISE + UNSEEN / (omega * omega);
    check(out.error_estimate >= least && out.error_estimate < least + 2 * NOISE, "%g, at least %g", out.error_estimate,
          least);
}

/* The length of the table does not matter: the proved table of 1800 modes, 1800 computed modes, and fewer. */
TEST(proved_modes)
{
    const struct cor_disk_hard_wall_options options = {1e-3, 0};
    struct cor_disk_mode mode[2000];
    struct cor_disk_modes computed;
    struct cor_disk_hard_wall by_table, by_computed, by_part;
    assert_int_equal(cor_disk_modes_compute(0.33, 2000, mode, &computed), COR_OK);
    assert_int_equal(cor_disk_hard_wall(&cor_disk_modes_nu033, 1800, &options, 0.1, &by_table), COR_OK);
    assert_int_equal(cor_disk_hard_wall(&computed, 2000, &options, 0.1, &by_computed), COR_OK);
    assert_int_equal(cor_disk_hard_wall(&computed, 1700, &options, 0.1, &by_part), COR_OK);
    check(fabs(by_table.one_minus_eps2 - by_computed.one_minus_eps2) < 1e-10, "%.12f and %.12f",
          by_table.one_minus_eps2, by_computed.one_minus_eps2);
    assert_int_equal(by_table.omega_levels, 5);
    same_results(&by_part, &by_computed, "1700 modes and 2000");
    check(fabs(by_table.one_minus_eps2 - 0.1030893) <= by_table.error_estimate, "%.8f +- %.1e", by_table.one_minus_eps2,
          by_table.error_estimate);
}

/* ---- the error ---- */

/* At random scenes the estimate is at least the error. The error is judged by two more levels, or by the last level,
 * with finer steps and angles. */
TEST(errors)
{
    static const double tolerances[] = {1e-3, 1e-4, 1e-5, 3e-6, 1e-6};
    double worst = 0;
    int judged = 0, reached = 0;
    const size_t scenes = points(6);
    for (size_t i = 0; i < scenes; i++) {
        const double speed = random_log(&draw, 1e-5, 0.5), nu = random_uniform(&draw, -0.5, 0.95);
        const double tolerance = tolerances[scenes < 20 ? i % 3 : i % 5];
        const size_t most = scenes < 20 ? 9 : tolerance < 2e-6 ? COR_DISK_HARD_WALL_MAX_LEVELS : 11;
        const size_t more = tolerance < 2e-6 ? 1 : 2;
        const struct cor_disk_hard_wall out = wall_collide(nu, most, speed, tolerance);
        reached += out.error_estimate <= tolerance;
        if (out.omega_levels + more > most)
            continue;
        const double finest = fmax(COR_DISK_HARD_WALL_MIN_TOLERANCE, fmin(1e-6, 0.01 * tolerance));
        const struct cor_disk_hard_wall judge = wall_collide(nu, out.omega_levels + more, speed, finest);
        const double off = fabs(out.one_minus_eps2 - judge.one_minus_eps2) / out.error_estimate;
        check(off <= 1, "nu = %.17g, v = %.17g, tolerance %g: %.9f +- %.1e, more levels %.9f", nu, speed, tolerance,
              out.one_minus_eps2, out.error_estimate, judge.one_minus_eps2);
        worst = fmax(worst, off);
        judged++;
    }
    print_message("%zu scenes, %d with the tolerance reached, %d judged: error at most %.2f of the estimate\n", scenes,
                  reached, judged, worst);
    assert_true(judged > 0);
}

/* At random scenes, the operations exceed a budget by at most one batch of steps. If a budget of operations or of steps
 * ends the sequence, the result and its estimate are the same as with a table that ends at the finished levels. */
TEST(budgets)
{
    leave_to_turn(2, 3);
    int ended = 0;
    for (size_t i = 0; i < points(6); i++) {
        const double speed = random_log(&draw, 1e-8, 0.5), nu = random_uniform(&draw, -0.9, 0.95);
        const double most = random_log(&draw, 4e8, few_or_all(0, 1) ? 1e10 : 1.5e9);
        const struct cor_disk_hard_wall_options free_steps = {COR_DISK_HARD_WALL_MIN_TOLERANCE, 0};
        struct cor_disk_hard_wall out, again;
        double work;
        const int status = cor_hard_wall_within(most, nu, &free_steps, speed, &out, &work);
        check(work <= 1.01 * most, "nu = %.17g, v = %.17g: %.3g operations of %.3g", nu, speed, work, most);
        check(status == COR_TOLERANCE_NOT_REACHED && out.omega_levels >= 2, "nu = %.17g, v = %.17g: %s", nu, speed,
              cor_status_text(status));
        ended += out.omega_levels < COR_DISK_HARD_WALL_MAX_LEVELS;
        const struct cor_disk_modes modes = modes_of(nu, out.omega_levels);
        const struct cor_disk_hard_wall_options any = {COR_DISK_HARD_WALL_MIN_TOLERANCE, SIZE_MAX};
        assert_int_equal(cor_disk_hard_wall(&modes, modes.count, &any, speed, &again), COR_TOLERANCE_NOT_REACHED);
        /* modes computed for more levels differ in their last digits */
        check(fabs(out.one_minus_eps2 - again.one_minus_eps2) <= 1e-9 && out.omega_levels == again.omega_levels &&
                  fabs(out.error_estimate - again.error_estimate) <= 1e-9,
              "%zu levels: %.12f +- %.1e, not %.12f", again.omega_levels, again.one_minus_eps2, again.error_estimate,
              out.one_minus_eps2);
        const struct cor_disk_hard_wall whole = again;
        /* a budget that hardly exceeds the work of computing the modes for seven levels */
        const double for_modes = COR_HARD_WALL_MODE_WORK * (double)cor_disk_modes_below(nu, first_omega(6));
        cor_hard_wall_within(1.05 * for_modes, nu, &free_steps, speed, &again, &work);
        check(work >= for_modes && work <= 1.1 * for_modes, "%.3g operations, %.3g for the modes", work, for_modes);
        /* the levels use the budget of steps, except a rest that is too small for another level */
        const struct cor_disk_hard_wall_options some = {COR_DISK_HARD_WALL_MIN_TOLERANCE,
                                                        1000 + random_below(&draw, 3000)};
        const int stopped = cor_hard_wall_within(most, nu, &some, speed, &again, &work);
        assert_int_equal(stopped, again.omega_levels < 2 ? COR_CONTACT_NOT_ENDED : COR_TOLERANCE_NOT_REACHED);
        check(work <= (double)(some.max_steps + COR_HARD_WALL_BATCH) && work > 0.2 * (double)some.max_steps,
              "nu = %.17g, v = %.17g: %g of %zu steps", nu, speed, work, some.max_steps);
        /* enough steps give the same levels; each level needs 2^(1/2) times the steps of the previous level */
        struct cor_disk_hard_wall_options steps = {COR_DISK_HARD_WALL_MIN_TOLERANCE, 1};
        assert_int_equal(cor_disk_hard_wall(&modes, modes.count, &steps, speed, &again), COR_CONTACT_NOT_ENDED);
        assert_true(isnan(again.one_minus_eps2) && isnan(again.error_estimate) && again.omega_levels == 0);
        for (size_t levels = 1; levels < out.omega_levels; steps.max_steps *= 2) {
            const int sequence = cor_disk_hard_wall(&modes, modes.count, &steps, speed, &again);
            assert_int_equal(sequence, again.omega_levels < 2 ? COR_CONTACT_NOT_ENDED : COR_TOLERANCE_NOT_REACHED);
            /* twice the steps allow at most two more levels */
            check(again.omega_levels == 0 || levels < 2 ||
                      (again.omega_levels >= levels && again.omega_levels <= levels + 2),
                  "%zu steps: %zu levels after %zu", steps.max_steps, again.omega_levels, levels);
            levels = again.omega_levels > levels ? again.omega_levels : levels;
            assert_true(steps.max_steps < 1000000);
        }
        same_results(&whole, &again, "enough steps");
    }
    assert_true(ended > 0);
}

/* The budget of cor_disk_hard_wall_nu, at a scene whose last level exceeds it */
TEST(whole_budget)
{
    if (!few_or_all(0, 1))
        skip();
    const struct cor_disk_hard_wall_options options = {1e-6, 0};
    struct cor_disk_hard_wall within, out;
    double work;
    assert_int_equal(cor_hard_wall_within(COR_HARD_WALL_WORK, 0.9, &options, 0.3, &within, &work),
                     COR_TOLERANCE_NOT_REACHED);
    assert_true(work <= 1.01 * COR_HARD_WALL_WORK && within.omega_levels < COR_DISK_HARD_WALL_MAX_LEVELS);
    assert_int_equal(cor_disk_hard_wall_nu(0.9, &options, 0.3, &out), COR_TOLERANCE_NOT_REACHED);
    same_results(&within, &out, "the default");
}

/* In the first scene, the fourth and fifth of six levels agreed by chance. In the second, five levels converged
 * regularly before the sixth moved. The exact values come from ten and eleven levels. */
TEST(levels_that_agree_by_chance)
{
    if (for_memory_only())
        skip();
    static const struct {
        double nu, speed, tolerance, one_minus_eps2, error;
    } scene[] = {{-0.39751903436160374, 0.1787946778185473, 1e-4, 0.141706, 5e-6},
                 {-0.085263505348613433, 0.45762461782887021, 1e-3, 0.196300, 3e-5}};
    for (size_t i = 0; i < 2; i++) {
        const struct cor_disk_hard_wall_options options = {scene[i].tolerance, 0};
        struct cor_disk_hard_wall out;
        assert_int_equal(cor_disk_hard_wall_nu(scene[i].nu, &options, scene[i].speed, &out), COR_OK);
        check(fabs(out.one_minus_eps2 - scene[i].one_minus_eps2) + scene[i].error <= out.error_estimate,
              "%.6f +- %.1e, not %.6f", out.one_minus_eps2, out.error_estimate, scene[i].one_minus_eps2);
    }
    /* the estimate also holds for a table of few levels */
    for (size_t levels = 2; levels <= 6; levels++)
        for (size_t i = 0; i < 2; i++) {
            const struct cor_disk_hard_wall out = wall_collide(scene[i].nu, levels, scene[i].speed, 1e-6);
            assert_true(out.omega_levels == levels && out.error_estimate > 1e-6);
            /* two levels show no earlier change, so the error may be 1.5 times the estimate */
            check(fabs(out.one_minus_eps2 - scene[i].one_minus_eps2) <= (levels > 2 ? 1 : 1.5) * out.error_estimate,
                  "%zu levels: %.6f +- %.1e", levels, out.one_minus_eps2, out.error_estimate);
        }
}

/* ---- any speed ---- */

/* For slow disks the results approach Rayleigh's theory slowly. At first the ratio of the results to Rayleigh's
 * fraction oscillates. */
TEST(slower_and_slower)
{
    double apart = INFINITY;
    EACH (exponents, -3, -8, -30, -128, -300) {
        const double speed = pow(10, *exponents);
        const struct cor_disk_hard_wall out = wall_collide(0.33, 8, speed, 1e-5);
        struct cor_disk_rayleigh rayleigh;
        assert_true(out.error_estimate <= 1e-5);
        assert_int_equal(
            cor_disk_rayleigh(&cor_disk_modes_nu033, 1800, COR_DISK_DATUM_CENTRE_OF_MASS, speed, &rayleigh, NULL),
            COR_OK);
        const double theory = rayleigh.fraction + rayleigh.tail;
        if (*exponents <= -30) {
            check(fabs(out.contact_time / rayleigh.contact_time - 1) < 0.02, "contact time %g", out.contact_time);
            check(fabs(out.max_compression / cor_disk_max_compression(speed, 0.33, COR_DISK_DATUM_CENTRE_OF_MASS) - 1) <
                      0.02,
                  "largest compression %g", out.max_compression);
            check(fabs(out.one_minus_eps2 / theory - 1) < apart, "v = 1e%g is farther from Rayleigh", *exponents);
            apart = fabs(out.one_minus_eps2 / theory - 1);
        }
    }
    check(apart < 0.1, "%g from Rayleigh at v = 1e-300", apart);
}

/* The point contact and the full method agree where they meet. Even the smallest double is a valid speed. */
TEST(joins)
{
    if (for_memory_only())
        skip();
    const double speed = COR_DISK_HARD_WALL_POINT_SPEED;
    const struct cor_disk_hard_wall full = wall_collide(0.33, 8, speed, 1e-5),
                                    point = wall_collide(0.33, 8, nextafter(speed, 0), 1e-5),
                                    slow = wall_collide(0.33, 8, DBL_MIN, 1e-5),
                                    slowest = wall_collide(0.33, 8, ldexp(1, -1074), 1e-5);
    check(fabs(full.one_minus_eps2 - point.one_minus_eps2) < 2e-6 &&
              fabs(full.contact_time / point.contact_time - 1) < 1e-3 &&
              fabs(full.max_compression / point.max_compression - 1) < 1e-4,
          "%.9f, %g, %g and %.9f, %g, %g", full.one_minus_eps2, full.contact_time, full.max_compression,
          point.one_minus_eps2, point.contact_time, point.max_compression);
    check(slow.one_minus_eps2 > 0 && slow.one_minus_eps2 < 1e-4 && fabs(slowest.one_minus_eps2) < 1e-4, "%g, %g",
          slow.one_minus_eps2, slowest.one_minus_eps2);
    assert_true(fmax(fmax(full.error_estimate, point.error_estimate),
                     fmax(slow.error_estimate, slowest.error_estimate)) <= 1e-5);
}

/* ---- details ---- */

enum { OBSERVED = 500 };
struct watched {
    struct cor_disk_hard_wall_moment last;
    double highest, widest, impulse, kicks, moved, swung; /* kicks, moved, swung: integrals of load, velocity, q */
    size_t moments, n;
    const struct cor_disk_mode *mode;
    const double *q, *q_dot;
    double largest_energy, left;         /* left: energy of the modes at the last moment */
    double contact_time, contact_energy; /* integral of the modes' energy over the contact */
    double reach;                        /* lower bound of the depth that the rim can still reach */
    size_t not_to_return;                /* moments since the rim cannot return to the wall */
};

/* *most: bound on the rim's motion, the sum of the amplitudes of the modes. *least: the same sum, with amplitudes near
 * Omega reduced by the cutoff */
static void swing_of(const struct watched *w, double *most, double *least)
{
    double omega = 0;
    *most = *least = 0;
    for (size_t i = w->n; i-- > 0;) {
        const struct cor_disk_mode *const mode = &w->mode[i];
        const double amplitude = hypot(w->q[i], w->q_dot[i] / mode->omega) * fmax(fabs(mode->c), fabs(mode->s));
        if (amplitude > 0)
            omega = fmax(omega, mode->omega);
        *most += amplitude;
        *least += amplitude > 0 ? amplitude * (1 - pow(mode->omega / omega, 2)) : 0;
    }
}

static void watch(void *context, const struct cor_disk_hard_wall_moment *moment)
{
    struct watched *const w = context;
    double energy = 0;
    for (size_t i = 0; i < w->n; i++)
        energy += pi / 2 * (pow(w->mode[i].omega * w->q[i], 2) + w->q_dot[i] * w->q_dot[i]);
    w->left = energy;
    /* the first kick is in the middle of its step, which begins at the touch */
    const double passed = moment->time - w->last.time, h = w->moments > 0 ? passed : 2 * passed;
    w->kicks += h * moment->load;
    w->swung += h * w->q[OBSERVED];
    w->moved += 0.5 * passed * (moment->velocity + w->last.velocity);
    if (moment->time <= w->contact_time)
        w->contact_energy += energy * (moment->time - w->last.time);
    w->largest_energy = fmax(w->largest_energy, energy + pi / 2 * moment->velocity * moment->velocity);
    double most, least;
    swing_of(w, &most, &least);
    w->reach = moment->position + 1 + least;
    if (moment->load > 0 || moment->velocity >= 0 || moment->position + 1 + most >= 0)
        w->not_to_return = 0;
    else
        w->not_to_return++;
    if (w->moments > 0)
        w->impulse += 0.5 * (moment->load + w->last.load) * (moment->time - w->last.time);
    else
        w->impulse += moment->load * moment->time;
    w->highest = fmax(w->highest, moment->position + 1);
    w->widest = fmax(w->widest, moment->contact_angle);
    w->last = *moment;
    w->moments++;
}

TEST(details)
{
    enum { N = 1800 };
    static double after[N], average[N], q[N], q_dot[N];
    EACH (speeds, 0.1, 0.01, 1e-9) {
        const double speed = *speeds, energy = pi / 2 * speed * speed;
        const struct cor_disk_modes *const modes = &cor_disk_modes_nu033;
        /* a budget that ends the sequence after four levels gives the details of the fourth */
        const struct cor_disk_hard_wall_options some = {1e-6, 2000}, enough = {1e-3, 0},
                                                options = speed > 0.001 && speed < 0.1 ? some : enough;
        struct cor_disk_hard_wall out, silent;
        const int status = cor_disk_hard_wall(modes, N, &options, speed, &silent);
        assert_true(status == COR_OK || status == COR_TOLERANCE_NOT_REACHED);
        struct watched w = {.n = N,
                            .mode = modes->mode,
                            .q = q,
                            .q_dot = q_dot,
                            .contact_time = silent.contact_time,
                            .last.velocity = speed};
        const struct cor_disk_hard_wall_detail detail = {after, average, watch, &w, q, q_dot};
        const size_t bytes = cor_disk_hard_wall_workspace(modes, N, &options, speed);
        assert_true(bytes > 0);
        char *const room = malloc(bytes + 1);
        assert_non_null(room);
        assert_int_equal(cor_disk_hard_wall_in(room + 1, bytes, modes, N, &options, speed, &out, &detail), status);
        same_results(&out, &silent, "observed and not");
        double left = 0, mean = 0;
        for (size_t i = 0; i < N; i++) {
            assert_true(after[i] >= 0 && average[i] >= 0);
            left += after[i];
            mean += average[i];
        }
        const double watched = w.contact_energy / w.contact_time / energy;
        check(fabs(mean / watched - 1) < 1e-2, "mean energy %g, watched %g", mean, watched);
        /* `left` is from the highest level, without extrapolation */
        check(fabs(left - out.one_minus_eps2) < 3e-3 * out.one_minus_eps2 + 3e-4, "%g left, 1 - eps^2 = %g", left,
              out.one_minus_eps2);
        check(fabs(w.last.velocity / (speed * sqrt(1 - left)) + 1) < 1e-4, "velocity %g", w.last.velocity);
        check(fabs(w.impulse / (pi * (speed - w.last.velocity)) - 1) < 1e-3, "impulse %g", w.impulse);
        check(fabs(w.kicks / w.impulse - 1) < 1e-3 && fabs(w.moved - (w.last.position + 1)) < 1e-4 * speed,
              "the centre of mass moved by %g, not %g", w.moved, w.last.position + 1);
        check(relative_error(w.left / energy, left) < 1e-9, "%.12g left at the last moment, not %.12g", w.left / energy,
              left);
        /* in a point contact, Newton's law for one mode holds, integrated over the collision */
        const struct cor_disk_mode *const mode = &modes->mode[OBSERVED];
        const double r = mode->omega / first_omega(out.omega_levels - 1), fade = (1 - r * r) * sqrt(1 + r * r);
        const double pushed = pow(mode->omega, 2) * w.swung + q_dot[OBSERVED], push = -fade * mode->c * w.kicks / pi;
        check(speed > 1e-7 || fabs(pushed / push - 1) < 1e-3, "mode %d: %g, not %g", OBSERVED, pushed, push);
        check(fabs(w.highest / out.max_compression - 1) < 1e-3, "largest compression %g, not %g", w.highest,
              out.max_compression);
        check(w.last.load <= 0 && w.last.time >= out.contact_time, "ends at %g", w.last.time);
        check(w.reach < 0, "ends where the rim may come %g into the wall", w.reach);
        /* the method looks for the end after every eighth kick */
        check(w.not_to_return <= 9, "ends %zu kicks after the last that could matter", w.not_to_return);
        check(w.largest_energy < energy * 1.01, "energy %g of %g", w.largest_energy, energy);
        check(speed < 1e-7 ? w.widest <= 0 : fabs(w.widest / (1.42 * sqrt(speed)) - 1) < 0.1, "widest %g", w.widest);
        check(after[N - 1] <= 0 && after[0] > 0, "modes above Omega do not move");
        free(room);
    }
}

/* ---- refused input ---- */

TEST(refusals)
{
    const struct cor_disk_modes *const modes = &cor_disk_modes_nu033;
    const struct cor_disk_hard_wall_options good = {1e-3, 0};
    struct cor_disk_hard_wall out = {7, 7, 7, 7, 7, 7};
    const struct cor_disk_hard_wall untouched = out;
    EACH (tolerances, 0, -1, 1, NAN, 0.99e-7, INFINITY) {
        const struct cor_disk_hard_wall_options options = {*tolerances, 0};
        assert_int_equal(cor_disk_hard_wall(modes, 1800, &options, 0.1, &out), COR_ERROR_TOLERANCE);
        assert_int_equal(cor_disk_hard_wall_nu(0.3, &options, 0.1, &out), COR_ERROR_TOLERANCE);
        assert_int_equal(cor_disk_hard_wall_workspace(modes, 1800, &options, 0.1), 0);
    }
    EACH (speeds, NAN, INFINITY, 0.5000000001) {
        assert_int_equal(cor_disk_hard_wall(modes, 1800, &good, *speeds, &out), COR_ERROR_SPEED);
        assert_int_equal(cor_disk_hard_wall_nu(0.3, &good, *speeds, &out), COR_ERROR_SPEED);
        assert_int_equal(cor_disk_hard_wall_workspace(modes, 1800, &good, *speeds), 0);
    }
    assert_int_equal(cor_disk_hard_wall(NULL, 1800, &good, 0.1, &out), COR_ERROR_NULL);
    assert_int_equal(cor_disk_hard_wall(modes, 1800, NULL, 0.1, &out), COR_ERROR_NULL);
    assert_int_equal(cor_disk_hard_wall(modes, 1800, &good, 0.1, NULL), COR_ERROR_NULL);
    assert_int_equal(cor_disk_hard_wall_nu(0.3, NULL, 0.1, &out), COR_ERROR_NULL);
    assert_int_equal(cor_disk_hard_wall_nu(0.3, &good, 0.1, NULL), COR_ERROR_NULL);
    EACH (nus, -1, 1, NAN)
        assert_int_equal(cor_disk_hard_wall_nu(*nus, &good, 0.1, &out), COR_ERROR_DISK_POISSON_RATIO);
    assert_int_equal(cor_disk_hard_wall(modes, 0, &good, 0.1, &out), COR_ERROR_MODES);
    assert_int_equal(cor_disk_hard_wall(modes, 1801, &good, 0.1, &out), COR_ERROR_MODES);
    assert_int_equal(cor_disk_hard_wall(modes, 100, &good, 0.1, &out), COR_ERROR_MODES); /* one level */
    /* tables that no disk has */
    static struct cor_disk_mode mode[1800];
    const struct cor_disk_modes wrong = {0.33, 1800, mode};
    const struct cor_disk_modes other_nu = {1.5, 1800, mode};
    memcpy(mode, modes->mode, sizeof mode);
    assert_int_equal(cor_disk_hard_wall(&other_nu, 1800, &good, 0.1, &out), COR_ERROR_DISK_POISSON_RATIO);
    mode[7].omega = mode[6].omega; /* test_disk_collision.c tests other entries that both walls refuse */
    assert_int_equal(cor_disk_hard_wall(&wrong, 1800, &good, 0.1, &out), COR_ERROR_MODES);
    mode[7] = modes->mode[7];
    mode[1700].n = COR_HARD_WALL_MAX_N + 1;
    assert_int_equal(cor_disk_hard_wall(&wrong, 1800, &good, 0.1, &out), COR_ERROR_MODES);
    mode[1700] = modes->mode[1700];
    mode[1799].omega = 1000; /* omega is above Omega at every level */
    for (int i = 0; i < 2; i++) {
        mode[1799].n = COR_DISK_MODES_MAX_N + i;
        struct cor_disk_hard_wall high;
        assert_int_equal(cor_disk_hard_wall(&wrong, 1800, &good, 0.1, &high), i ? COR_ERROR_MODES : COR_OK);
    }
    mode[1799] = modes->mode[1799];
    same_results(&out, &untouched, "refused");
    mode[9] = modes->mode[9];
    for (size_t i = 0; i < 1800; i++)
        mode[i].c *= 2;
    assert_int_equal(cor_disk_hard_wall(&wrong, 1800, &good, 0.1, &out), COR_ERROR_MODES);
    assert_true(isnan(out.one_minus_eps2) && isnan(out.error_estimate) && out.omega_levels == 0);
    /* two levels are the minimum */
    const size_t two = cor_disk_modes_below(0.33, first_omega(1) * (1 + 1e-12)) + 1;
    assert_int_equal(cor_disk_hard_wall(modes, two, &good, 0.1, &out), COR_TOLERANCE_NOT_REACHED);
    assert_true(out.omega_levels == 2 && fabs(out.one_minus_eps2 - 0.1030893) <= out.error_estimate);
    EACH (still, 0, -0.0, -1, -INFINITY) {
        assert_int_equal(cor_disk_hard_wall(modes, 1800, &good, *still, &out), COR_WALL_NOT_TOUCHED);
        assert_true(isnan(out.one_minus_eps2) && isnan(out.eps));
        assert_int_equal(cor_disk_hard_wall_nu(0.3, &good, *still, &out), COR_WALL_NOT_TOUCHED);
    }
    char small[64];
    assert_int_equal(cor_disk_hard_wall_in(small, sizeof small, modes, 1800, &good, 0.1, &out, NULL),
                     COR_ERROR_WORKSPACE);
    assert_int_equal(cor_disk_hard_wall_in(NULL, 0, modes, 1800, &good, 0.1, &out, NULL), COR_ERROR_NULL);
}

/* Returns the estimate after `levels` levels. Runs with fewer levels give the last four changes of the result. */
static double estimate_and_changes(double nu, double speed, double tolerance, size_t levels, double change[4])
{
    double value[5] = {0}, estimate = NAN;
    for (size_t i = 0; i < 5 && i + 2 <= levels; i++) {
        const struct cor_disk_hard_wall out = wall_collide(nu, levels - i, speed, tolerance);
        assert_true(out.omega_levels == levels - i && out.error_estimate > tolerance);
        value[i] = out.one_minus_eps2;
        estimate = i == 0 ? out.error_estimate : estimate;
    }
    for (size_t i = 0; i < 4; i++)
        change[i] = i + 3 <= levels ? fabs(value[i] - value[i + 1]) : 0;
    return estimate;
}

/* The estimate at a calm scene is at least three times the last change, plus noise and unseen waves. */
TEST(parts_of_the_estimate)
{
    leave_to_turn(1, 2);
    const double tolerance = 1e-6, noise = NOISE * pow(tolerance / 4e-6, 2.5 / 3);
    double change[4];
    for (size_t levels = 3; levels <= 6; levels++) {
        const double speed = random_uniform(&draw, 0.02, 0.3), unseen = UNSEEN / pow(first_omega(levels - 1), 2);
        const double estimate = estimate_and_changes(0.33, speed, tolerance, levels, change);
        check(estimate >= (3 * change[0] + noise + unseen) * (1 - 1e-9), "v = %g, %zu levels: %g, changed by %g", speed,
              levels, estimate, change[0]);
    }
    /* here the second last change decides, in the loop the usual error at Omega = 240 */
    double estimate = estimate_and_changes(0.1285, 0.06194, tolerance, 8, change);
    check(relative_error(estimate, change[1] + noise + UNSEEN / pow(first_omega(7), 2)) < 1e-9, "%.17g", estimate);
    EACH (tolerances, tolerance, 3e-6) { /* a tolerance above 1e-6 adds noise */
        estimate = estimate_and_changes(0.3305, 0.06118, *tolerances, 9, change);
        const double usual = 6.8e-7 * pow(680 / 240.0, 3.5) + 0.23 * fmax(change[0], change[1]),
                     more = NOISE * pow(*tolerances / 4e-6, 2.5 / 3) - noise;
        check(relative_error(estimate, usual + more) < 1e-9, "%.17g, not %.17g", estimate, usual + more);
    }
    /* a point contact adds an error of 3e-8 */
    for (size_t levels = 5; levels <= 7; levels++) { /* the largest weighted change is used */
        estimate = estimate_and_changes(0.33, 1e-8, tolerance, levels, change);
        const double most = fmax(fmax(3 * change[0], change[1]), 0.3 * change[2]),
                     expected = most + noise + UNSEEN / pow(first_omega(levels - 1), 2) + 3e-8;
        check(relative_error(estimate, expected) < 1e-9, "%zu levels: %.17g, not %.17g", levels, estimate, expected);
    }
    /* a chaotic scene, a calm one at another nu, and a fast one */
    static const double elsewhere[][2] = {{0.693, 0.09426}, {0.55, 0.05}, {0.2, 0.4}};
    for (size_t i = 0; i < 3; i++) {
        estimate = estimate_and_changes(elsewhere[i][0], elsewhere[i][1], tolerance, 9, change);
        check(estimate >= 3 * change[0] && 3 * change[0] > 3e-5, "%g, changed by %g", estimate, change[0]);
    }
}

/* At random calm scenes, the estimate after each level from Omega = 170 onward is at least the error. The error is
 * judged by the last level with finer steps and angles. */
TEST(usual_errors)
{
    leave_to_turn(1, 3);
    if (points(10) < 10) /* tests of memory use need only the scenes of the test `errors` */
        skip();
    const size_t scenes = points(1), most = scenes < 20 ? 10 : COR_DISK_HARD_WALL_MAX_LEVELS;
    double worst = 0;
    int settled = 0;
    for (size_t i = 0; i < scenes; i++) {
        const double nu = random_uniform(&draw, -0.2, 0.4875), speed = random_log(&draw, 0.01, 0.3);
        const struct cor_disk_hard_wall judge = wall_collide(nu, most, speed, COR_DISK_HARD_WALL_MIN_TOLERANCE);
        struct cor_disk_hard_wall out = {.error_estimate = 1};
        for (size_t levels = 8; levels < most && out.error_estimate > 1e-6; levels++) {
            out = wall_collide(nu, levels, speed, 1e-6);
            const double off = fabs(out.one_minus_eps2 - judge.one_minus_eps2) / out.error_estimate;
            check(off <= 1, "nu = %.17g, v = %.17g, %zu levels: %.9f +- %.1e, not %.9f", nu, speed, levels,
                  out.one_minus_eps2, out.error_estimate, judge.one_minus_eps2);
            worst = fmax(worst, off);
        }
        settled += out.error_estimate <= 1e-6;
    }
    print_message("%zu scenes: error at most %.2f of the estimate; %d with 1e-6 reached before Omega = %.0f\n", scenes,
                  worst, settled, first_omega(most - 1));
}
