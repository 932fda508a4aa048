/* SPDX-License-Identifier: MIT */
/* Whole collisions of the disk (runtime/disk/collision.c): known values, an integrator of another kind
 * (reference_collision.h), random tolerances, energies, moments, workspaces, hard cases and refusals. */
#include "check.h"

#include <limits.h>

#include <cor/disk.h>
#include <cor/status.h>

#include "reference_collision.h"

static const double pi = 3.14159265358979323846;

/* Error that the reference may have in eps, and in energies relative to (pi/2) v^2 */
static const double slack = 1e-13;

/* Looser bounds of disk.h, at a tolerance of 1e-11, for values interpolated between two moments of the contact. The
 * error of a depth is relative to v, the error of a time to this time, and the error of an average to (pi/2) v^2. */
static const double depth_bound = 1e-7, time_bound = 1e-6, average_bound = 1e-6, soft_average_bound = 1e-4;

enum { TABLE = 1800 };
static double after[TABLE], average[TABLE], reference_after[TABLE], reference_average[TABLE];

/* Returns count, or fewer with COR_TEST_DIVISOR. */
static size_t listed(size_t count)
{
    return points(count) < count ? points(count) : count;
}

static const struct cor_disk_modes *material(double nu)
{
    return nu < 0.5 ? &cor_disk_modes_nu033 : &cor_disk_modes_nu090;
}

static int disk_collide(const struct cor_disk_modes *modes, size_t n, double alpha, double v, double tolerance,
                        struct cor_disk_collision *out)
{
    const struct cor_disk_collision_options options = {alpha, tolerance, 0, 0};
    return cor_disk_collision(modes, n, &options, v, out);
}

static int collide_in_detail(const struct cor_disk_modes *modes, size_t n,
                             const struct cor_disk_collision_options *options, double v, struct cor_disk_collision *out,
                             const struct cor_disk_collision_detail *detail)
{
    const size_t bytes = cor_disk_collision_workspace(modes, n, options);
    assert_true(bytes > 0);
    void *const workspace = malloc(bytes + 1); /* + 1 for analysers, which do not know that bytes > 0 */
    assert_non_null(workspace);
    const int status = cor_disk_collision_in(workspace, bytes, modes, n, options, v, out, detail);
    free(workspace);
    return status;
}

static void same_results(const struct cor_disk_collision *x, const struct cor_disk_collision *y, const char *what)
{
    check(memcmp(x, y, sizeof *x) == 0, "%s: eps = %a and %a", what, x->eps, y->eps);
}

/* ---- values ---- */

/* Collisions with known eps, right to all digits given here; nu = 0.33, alpha = 500, v = 0.1 */
TEST(known_answers)
{
    static const struct {
        size_t n;
        double eps, unit;
    } known[] = {{10, 0.942107627106, 1e-12}, {940, 0.9504656552925, 1e-13}, {1600, 0.9510872406816, 1e-13}};
    for (size_t i = 0; i < listed(3); i++) {
        struct cor_disk_collision out;
        assert_int_equal(disk_collide(&cor_disk_modes_nu033, known[i].n, 500, 0.1, 1e-12, &out), COR_OK);
        assert_true(out.error_estimate <= 1e-12);
        check(fabs(out.eps - known[i].eps) <= 0.5 * known[i].unit + 1e-12, "N = %zu: %.15f", known[i].n, out.eps);
        /* round-off prevents this tolerance, and the estimate shows it; the result is as accurate as possible */
        const int status = disk_collide(&cor_disk_modes_nu033, known[i].n, 500, 0.1, 1e-13, &out);
        assert_true(status == (out.error_estimate <= 1e-13 ? COR_OK : COR_TOLERANCE_NOT_REACHED));
        assert_true(out.error_estimate < 4e-13);
        /* allows half a unit of the last digit, plus the tolerance */
        check(fabs(out.eps - known[i].eps) <= 0.5 * known[i].unit + 1e-13, "N = %zu: %.15f", known[i].n, out.eps);
        /* an extrapolation of lower order would need more steps */
        check(i > 0 || out.steps < 10000, "%zu steps", out.steps);
    }
}

/* ---- the reference ---- */

/* Calm collisions reach this tolerance; round-off may exceed smaller ones. */
static const double least_tolerance = 1e-11;

static struct reference_collision truth_of(const struct cor_disk_modes *modes, size_t n, double alpha, double v)
{
    struct reference_collision truth;
    assert_int_equal(
        reference_disk_collision(modes->mode, n, alpha, v, slack, &truth, reference_after, reference_average), 0);
    check(fabs(truth.energy_drift) <= slack, "reference, N = %zu, alpha = %g, v = %g: energy drifts by %g", n, alpha, v,
          truth.energy_drift);
    return truth;
}

/* Checks eps and 1 - eps^2 to the tolerance, the energies, and, if `in_full`, all other numbers of a complete
 * reference. Returns the number of steps. */
static size_t judge(const struct cor_disk_modes *modes, size_t n, double alpha, double v, double tolerance,
                    const struct reference_collision *truth, int in_full)
{
    struct cor_disk_collision out;
    const struct cor_disk_collision_options options = {alpha, tolerance, 0, 0};
    const struct cor_disk_collision_detail detail = {.energy_after = after, .energy_average = average};
    const int status = collide_in_detail(modes, n, &options, v, &out, &detail);
    char what[160];
    snprintf(what, sizeof what, "nu = %g, N = %zu, alpha = %a, v = %a, tolerance %g", modes->nu, n, alpha, v,
             tolerance);
    check(status == COR_OK || (status == COR_TOLERANCE_NOT_REACHED && tolerance < least_tolerance), "%s: %s", what,
          cor_status_text(status));
    check((status == COR_OK) == (out.error_estimate <= tolerance), "%s: estimate %g", what, out.error_estimate);
    check(fabs(out.eps - truth->eps) <= out.error_estimate + slack, "%s: eps %.15f, not %.15f, estimate %g", what,
          out.eps, truth->eps, out.error_estimate);
    tolerance = fmax(tolerance, out.error_estimate);
    /* 1 - eps^2 changes by 2 eps times the change of eps */
    check(fabs(out.one_minus_eps2 - truth->one_minus_eps2) <= (in_full ? 2 * (tolerance + slack) : 4 * tolerance),
          "%s: 1 - eps^2 = %.15f, not %.15f", what, out.one_minus_eps2, truth->one_minus_eps2);
    check(fabs(out.energy_drift) <= 4 * tolerance &&
              fabs(out.energy_drift - (out.eps * out.eps + out.one_minus_eps2 - 1)) <= 1e-15,
          "%s: drift %g", what, out.energy_drift);
    long double sum = 0;
    double off_after = 0, off_average = 0;
    for (size_t i = 0; i < n; i++) {
        check(after[i] >= 0, "%s: mode %zu has the energy %g", what, i, after[i]);
        sum += after[i];
        off_after = fmax(off_after, fabs(after[i] - reference_after[i]));
        off_average = fmax(off_average, fabs(average[i] - reference_average[i]));
    }
    check(fabsl(sum - out.one_minus_eps2) <= 1e-14L * out.one_minus_eps2, "%s: %.17Lg and %.17g", what, sum,
          out.one_minus_eps2);
    if (!in_full)
        return out.steps;
    check(off_after <= 4 * (tolerance + slack), "%s: a mode's energy is off %g", what, off_after);
    check(fabs(out.max_compression - truth->max_compression) <= depth_bound * v, "%s: %.15f, not %.15f", what,
          out.max_compression, truth->max_compression);
    check(fabs(out.contact_time / truth->contact_time - 1) <= time_bound, "%s: %.15f, not %.15f", what,
          out.contact_time, truth->contact_time);
    check(off_average <= (alpha * v < 10 ? soft_average_bound : average_bound), "%s: a mode's mean energy is off %g",
          what, off_average);
    return out.steps;
}

static void as_reference(const struct cor_disk_modes *modes, size_t n, double alpha, double v)
{
    const struct reference_collision truth = truth_of(modes, n, alpha, v);
    judge(modes, n, alpha, v, least_tolerance, &truth, 1);
}

/* ---- mode tables of other kinds ---- */

static struct cor_disk_mode some[TABLE];

/* Returns the lowest `count` modes whose n is in the list, which ends with -1, or whose omega is less than `below`. */
static struct cor_disk_modes modes_cut(const struct cor_disk_modes *modes, const int *of_n, double below, size_t count)
{
    size_t kept = 0;
    for (size_t i = 0; i < modes->count && kept < count; i++) {
        const int *n = of_n;
        while (*n >= 0 && *n != modes->mode[i].n)
            n++;
        if (*n >= 0 || modes->mode[i].omega < below)
            some[kept++] = modes->mode[i];
    }
    assert_int_equal(kept, count);
    return (struct cor_disk_modes){modes->nu, count, some};
}

/* Each scene has the modes with n in of_n and the modes below a frequency, or all modes if of_n is NULL. The tolerance
 * decreases from `from` by the factor `ratio`. If `from` is 0, the only tolerance is 1e-11, and all numbers are
 * compared with a reference. */
TEST(reference)
{
    const struct {
        double nu;
        const int *of_n;
        size_t n;
        double alpha, v, from, ratio, below;
    } scene[] = {
        {0.33, NULL, 20, 1400, 0.06, 0, 0, 0}, /* seven runs, one more than COR_COLLISION_LEVELS */
        {0.33, NULL, 1, 500, 0.1, 0, 0, 0},
        {0.9, NULL, 10, 50, 0.3, 0, 0, 0},
        {0.33, NULL, 100, 200, 0.3, 0, 0, 0},
        {0.33, NULL, 100, 500, 0.1, 0, 0, 0},
        {0.9, NULL, 1, 8000, 0.1, 0, 0, 0},
        {0.33, NULL, 10, 8000, 0.001, 0, 0, 0},
        {0.9, NULL, 10, 2000, 0.03, 0, 0, 0},
        {0.9, NULL, 100, 500, 0.03, 0, 0, 0},
        {0.33, NULL, 10, 500, 0.1, 0.1, 10, 0},
        {0.9, NULL, 100, 4000, 0.005, 0, 0, 0},
        {0.33, NULL, 1, 100, 0.02, 0, 0, 0},
        {0.9, NULL, 1, 50, 0.001, 0.1, 10, 0},
        {0.33, NULL, 940, 500, 0.1, 0.1, 10, 0},
        {0.9, NULL, 30, 2000, 0.03, 0.1, 10, 0},
        {0.33, NULL, 200, 8000, 0.001, 0.1, 10, 0},
        {0.33, NULL, 1, 8000, 0.1, 0.1, 10, 0},
        {0.33, (int[]){0, -1}, 4, 300, 0.1, 0, 0, 0},
        {0.33, (int[]){5, -1}, 6, 300, 0.1, 0, 0, 0},
        {0.33, (int[]){1, 8, 9, 31, -1}, 12, 300, 0.1, 0, 0, 0},
        {0.33, (int[]){1, -1}, 5, 300, 0.1, 0, 0, 0},
        {0.33, (int[]){109, -1}, 1, 300, 0.1, 0, 0, 0},
        /* modes must not gain energy if their omega h is a multiple of pi */
        {0.33, (int[]){0, -1}, 22, 200, 0.1, 1e-2, 100, 2.3},
        {0.9, (int[]){0, -1}, 11, 200, 0.1, 1e-2, 100, 2.3},
        {0.33, (int[]){0, -1}, 22, 2000, 0.1, 1e-2, 100, 2.3},
        {0.9, (int[]){0, -1}, 11, 2000, 0.1, 1e-2, 100, 2.3},
    };
    for (size_t i = 0; i < sizeof scene / sizeof *scene; i++) {
        if (left_to_turn(i, points(10) < 10 ? 9 : 5))
            continue;
        const double nu = scene[i].nu, alpha = scene[i].alpha, v = scene[i].v;
        const size_t n = scene[i].n;
        const struct cor_disk_modes modes =
            scene[i].of_n ? modes_cut(material(nu), scene[i].of_n, scene[i].below, n) : *material(nu);
        /* for 940 modes eps is stored, because the reference would take a second */
        struct reference_collision truth = {.eps = 0.9504656552925,
                                            .one_minus_eps2 = 1 - 0.9504656552925 * 0.9504656552925};
        if (n < 940)
            truth = truth_of(&modes, n, alpha, v);
        if (scene[i].from == 0)
            judge(&modes, n, alpha, v, least_tolerance, &truth, 1);
        size_t most = 0, least = SIZE_MAX;
        for (double tolerance = scene[i].from; tolerance > 2e-12; tolerance /= scene[i].ratio) {
            const size_t steps = judge(&modes, n, alpha, v, tolerance, &truth, 0);
            most = steps > most ? steps : most;
            least = steps < least ? steps : least;
        }
        check(most == 0 || (least > 10 && 2 * least <= most), "%zu to %zu steps", least, most);
    }
}

TEST(other_modes)
{
    leave_to_turn(1, 3);
    for (size_t i = 0; points(8) > 1 && i < points(8); i++) {
        const double v = random_log(&draw, 0.003, 0.3), alpha = random_log(&draw, 50, fmin(8000, 50 / v));
        as_reference(material(random_uniform(&draw, 0, 1)), (size_t)random_log(&draw, 1, 60), alpha, v);
    }
    /* only tangential modes, then only radial modes */
    for (int k = 0; k < 2; k++) {
        const struct cor_disk_modes modes = modes_cut(&cor_disk_modes_nu090, (int[]){1, 2, 3, 4, 5, -1}, 0, 12);
        for (size_t i = 0; i < modes.count; i++)
            *(k == 0 ? &some[i].c : &some[i].s) = 0;
        as_reference(&modes, modes.count, 300, 0.1);
    }
}

/* One strong mode absorbs nearly all of the speed. The disk is 0.07 away from the wall when its rim returns to it,
 * after a time of 3.5. */
TEST(second_contact)
{
    some[0] = (struct cor_disk_mode){2, 0, 1.2, 0.84, 0};
    const struct cor_disk_modes modes = {0.33, 1, some};
    const struct reference_collision truth = truth_of(&modes, 1, 800, 0.1);
    judge(&modes, 1, 800, 0.1, least_tolerance, &truth, 1);
    /* a larger tolerance ends the first contact when the disk is closer to the wall */
    for (double tolerance = 1e-8; tolerance < 1e-3; tolerance *= 10)
        judge(&modes, 1, 800, 0.1, tolerance, &truth, 0);
}

/* Records the time step of the last run. */
static void note_step(void *context, const struct cor_disk_moment *moment)
{
    double *const time = context;
    time[1] = moment->time - time[0];
    time[0] = moment->time;
}

/* omega_max h is at most 1. So no two modes together turn by 2 pi between kicks, which would be a resonance. Here the
 * fastest mode limits the step, not the stiffness of the wall. */
TEST(no_resonance)
{
    const struct cor_disk_modes modes = modes_cut(&cor_disk_modes_nu033, (int[]){0, -1}, 0, 18);
    const struct reference_collision truth = truth_of(&modes, modes.count, 100, 0.02);
    judge(&modes, modes.count, 100, 0.02, 1e-5, &truth, 0);
    double time[2] = {0, 0};
    const struct cor_disk_collision_options options = {100, 1e-5, 0, 0};
    const struct cor_disk_collision_detail detail = {.observe = note_step, .context = time};
    struct cor_disk_collision out;
    assert_int_equal(collide_in_detail(&modes, modes.count, &options, 0.02, &out, &detail), COR_OK);
    const double turn = modes.mode[modes.count - 1].omega * time[1];
    check(turn > 0.2 && turn <= 1 + 1e-9, "omega_max h = %g", turn);
}

/* ---- tolerances ---- */

TEST(extreme_tolerances)
{
    struct cor_disk_collision finest, coarsest;
    disk_collide(&cor_disk_modes_nu033, 3, 500, 0.1, COR_DISK_COLLISION_MIN_TOLERANCE, &finest);
    assert_true(finest.error_estimate < 1e-12);
    assert_int_equal(disk_collide(&cor_disk_modes_nu033, 3, 500, 0.1, nextafter(1, 0), &coarsest), COR_OK);
    assert_true(finest.eps > 0 && finest.eps < 1 && coarsest.steps < finest.steps);
    assert_true(fabs(coarsest.eps - finest.eps) < 1);
    assert_true(fabs(finest.energy_drift) < 1e-12);
}

TEST(phi_points)
{
    struct cor_disk_collision truth, out;
    assert_int_equal(disk_collide(&cor_disk_modes_nu033, 10, 500, 0.1, 1e-12, &truth), COR_OK);
    size_t kept_from = 0;
    const size_t finer = listed(4); /* fewer angles if few points are tested */
    for (size_t n = 1; n <= 512; n = n * (finer + 1) / finer + 1) {
        const struct cor_disk_collision_options options = {500, 1e-10, n, 0};
        const int status = cor_disk_collision(&cor_disk_modes_nu033, 10, &options, 0.1, &out);
        const double off = fabs(out.eps - truth.eps);
        assert_true(status == COR_OK || status == COR_TOLERANCE_NOT_REACHED);
        check(status != COR_OK || off <= 1e-10, "%zu angles: eps %.14f, not %.14f", n, out.eps, truth.eps);
        if (status == COR_OK && kept_from == 0)
            kept_from = n;
        check(kept_from == 0 || status == COR_OK, "enough with %zu angles, and not with %zu", kept_from, n);
    }
    assert_true(kept_from > 30 && kept_from < 256);
}

/* ---- moments ---- */

struct diary {
    const struct cor_disk_modes *modes;
    size_t n, count;
    double alpha, speed, q[TABLE], q_dot[TABLE], energy[TABLE], first_q[TABLE];
    struct cor_disk_moment first, last;
    double wander, drift, max_position, impulse, astray;
};

static void write_down(void *context, const struct cor_disk_moment *moment)
{
    struct diary *const d = context;
    double energy = pi / 2 * moment->velocity * moment->velocity + moment->wall_energy;
    for (size_t i = 0; i < d->n; i++) {
        d->energy[i] = pi / 2 * (d->q_dot[i] * d->q_dot[i] + pow(d->modes->mode[i].omega * d->q[i], 2));
        energy += d->energy[i];
    }
    energy /= pi / 2 * d->speed * d->speed;
    check(moment->load >= 0 && fabs(moment->wall_energy * d->alpha - moment->load) <= 4 * DBL_EPSILON * moment->load,
          "load %g, energy %g", moment->load, moment->wall_energy);
    d->drift = energy - 1;
    d->wander = fmax(d->wander, fabs(d->drift));
    if (d->count == 0) {
        d->first = *moment;
        d->max_position = moment->position;
        for (size_t i = 0; i < d->n; i++)
            assert_true(fabs(d->q_dot[i]) < 1e-6 * d->speed &&
                        d->modes->mode[i].omega * fabs(d->q[i]) < 1e-6 * d->speed);
        memcpy(d->first_q, d->q, sizeof d->q);
    } else {
        const double dt = moment->time - d->last.time;
        /* at first each mode follows the force, which grows like exp(alpha v t), without oscillating */
        for (size_t i = 0; d->count == 1 && i < d->n; i++)
            d->astray = fmax(d->astray, fabs(d->q[i] / d->first_q[i] / exp(d->alpha * d->speed * dt) - 1));
        check(dt > 0, "time %g after %g", moment->time, d->last.time);
        d->impulse += dt * (moment->load + d->last.load) / 2;
        d->max_position = fmax(d->max_position, moment->position);
    }
    d->last = *moment;
    d->count++;
}

TEST(moments)
{
    static const struct {
        double nu;
        size_t n;
        double alpha, v, tolerance, wander;
    } scene[] = {{0.33, 10, 500, 0.1, 1e-9, 3e-4},
                 {0.9, 100, 2000, 0.02, 1e-10, 1.2e-5},
                 {0.33, 1, 50, 0.3, 1e-7, 1.5e-3},
                 {0.9, 30, 300, 0.1, 1e-3, 5e-4}};
    for (size_t k = 0; k < listed(sizeof scene / sizeof *scene); k++) {
        struct diary diary = {
            .modes = material(scene[k].nu), .n = scene[k].n, .alpha = scene[k].alpha, .speed = scene[k].v};
        const struct cor_disk_collision_options options = {scene[k].alpha, scene[k].tolerance, 0, 0};
        const struct cor_disk_collision_detail detail = {after, NULL, write_down, &diary, diary.q, diary.q_dot};
        struct cor_disk_collision out, silent;
        assert_int_equal(collide_in_detail(diary.modes, diary.n, &options, diary.speed, &out, &detail), COR_OK);
        assert_int_equal(cor_disk_collision(diary.modes, diary.n, &options, diary.speed, &silent), COR_OK);
        same_results(&out, &silent, "observed and not");
        const double energy = pi / 2 * diary.speed * diary.speed;
        assert_int_equal(diary.count, out.steps);
        assert_true(diary.first.time < 0 && fabs(diary.first.velocity / diary.speed - 1) < 1e-6);
        assert_true(fabs((diary.first.position + 1) / (diary.speed * diary.first.time) - 1) < 1e-6);
        assert_true(diary.first.wall_energy < scene[k].tolerance * energy);
        /* the last moment is after the contact. It is from the last run; the results are extrapolated from several. */
        assert_true(diary.last.wall_energy < scene[k].tolerance * energy);
        double off = fabs(diary.last.velocity / -diary.speed - out.eps);
        for (size_t i = 0; i < diary.n; i++)
            off = fmax(off, fabs(diary.energy[i] / energy - after[i]));
        assert_true(diary.astray < 0.01);
        assert_true(off < 1e-4);
        /* the conserved energy has a modified potential, which differs from the wall's potential by order h^2 */
        assert_true(diary.wander <= scene[k].wander);
        /* the disk may be deeper between moments; a moment may be deeper than the result by an error of order h^4 */
        assert_true(fabs(diary.max_position + 1 - out.max_compression) < 1e-3 * out.max_compression &&
                    diary.max_position + 1 < (1 + 2e-6) * out.max_compression);
        assert_true(out.contact_time < diary.last.time - diary.first.time);
        assert_true(fabs(diary.impulse / (pi * diary.speed * (1 + out.eps)) - 1) < 0.02);
    }
}

/* For any budget, the last run is observed to its end. */
TEST(moments_within_a_budget)
{
    size_t observed = 0;
    for (int i = 0; i < 12; i++) {
        struct diary diary = {.modes = material(0.33), .n = 1, .alpha = 50, .speed = 0.3};
        const struct cor_disk_collision_options options = {50, 1e-13, 0, (size_t)random_log(&draw, 300, 3000)};
        const struct cor_disk_collision_detail detail = {NULL, NULL, write_down, &diary, diary.q, diary.q_dot};
        struct cor_disk_collision out;
        collide_in_detail(diary.modes, diary.n, &options, diary.speed, &out, &detail);
        assert_true(isnan(out.eps) || (diary.count == out.steps && diary.last.velocity < 0));
        observed += isnan(out.eps) ? 0 : 1;
    }
    assert_true(observed > 3);
}

/* ---- hard cases ---- */

/* In a chaotic collision, the steps change the third digit of eps. The estimate includes this change, and energy
 * is conserved. */
TEST(chaotic)
{
    if (points(2) < 2)
        return;
    struct cor_disk_collision out;
    static struct diary diary;
    diary = (struct diary){.modes = &cor_disk_modes_nu033, .n = 940, .alpha = 2000, .speed = 0.3};
    const struct cor_disk_collision_options options = {diary.alpha, 1e-3, 0, 30000};
    const struct cor_disk_collision_detail detail = {NULL, NULL, write_down, &diary, diary.q, diary.q_dot};
    const int status = collide_in_detail(diary.modes, diary.n, &options, diary.speed, &out, &detail);
    assert_true(status == COR_OK || status == COR_TOLERANCE_NOT_REACHED);
    assert_true(fabs(out.eps - 0.838) < 2e-3);
    static const double tolerance[] = {1e-2, 1e-3, 1e-8};
    for (size_t i = 0; i < 3; i++) {
        const struct cor_disk_collision_options short_options = {diary.alpha, tolerance[i], 0, 20000};
        struct cor_disk_collision other;
        const int found =
            cor_disk_collision(diary.modes, diary.n, &short_options, diary.speed, &other); /* a smaller budget */
        check(fabs(other.eps - 0.838427764576) <= (found == COR_OK ? tolerance[i] : other.error_estimate),
              "tolerance %g: %.12f +- %.1e, %s", tolerance[i], other.eps, other.error_estimate, cor_status_text(found));
    }
    assert_true(fabs(out.energy_drift) < 4e-3);
    assert_true(fabs(diary.drift) < 1e-4);
}

/* No contact, or a contact of too many steps. If this is foreseeable, the run ends before the contact begins. */
TEST(without_results)
{
    static const struct {
        double alpha, v;
        size_t n;
        int status;
    } scene[] = {{500, 0, 10, COR_WALL_NOT_TOUCHED},
                 {500, -0.0, 10, COR_WALL_NOT_TOUCHED},
                 {500, -1e-300, 10, COR_WALL_NOT_TOUCHED},
                 {500, -1, 10, COR_WALL_NOT_TOUCHED},
                 {500, -INFINITY, 10, COR_WALL_NOT_TOUCHED},
                 {500, 1e-9, 1, COR_CONTACT_NOT_ENDED},
                 {40, 1e-6, 1, COR_CONTACT_NOT_ENDED},
                 {500, 4.9406564584124654e-324, 1, COR_CONTACT_NOT_ENDED},
                 {COR_DISK_COLLISION_MAX_ALPHA, 1e-300, 10, COR_CONTACT_NOT_ENDED},
                 {500, 1e-7, 940, COR_CONTACT_NOT_ENDED}};
    for (size_t i = 0; i < sizeof scene / sizeof *scene; i++) {
        struct cor_disk_collision out;
        memset(&out, 0, sizeof out);
        const int status = disk_collide(&cor_disk_modes_nu033, scene[i].n, scene[i].alpha, scene[i].v, 1e-8, &out);
        check(status == scene[i].status && isnan(out.eps) && isnan(out.one_minus_eps2), "alpha = %g, v = %g: %s, %g",
              scene[i].alpha, scene[i].v, cor_status_text(status), out.eps);
    }
}

/* ---- refused input ---- */

enum { CANARIES = 64 };

/* Any workspace of sufficient size gives the same bits, with any content. A refused workspace is not touched. */
TEST(workspaces)
{
    static const struct {
        double nu;
        size_t n;
        double alpha, v, tolerance;
        size_t phi_points;
    } scene[] = {{0.33, 20, 500, 0.1, 1e-7, 0},    {0.33, 1, 500, 0.1, 1e-6, 0}, {0.9, 9, 100, 0.3, 1e-3, 0},
                 {0.33, 137, 1000, 0.05, 1e-9, 0}, {0.9, 33, 500, 0.1, 0.5, 1},  {0.9, 2, 500, 0.1, 0.5, 999}};
    static double after_first[TABLE], average_first[TABLE];
    const double nan = NAN;
    for (size_t i = 0; i < sizeof scene / sizeof *scene; i++) {
        const struct cor_disk_modes *const modes = material(scene[i].nu);
        const struct cor_disk_collision_options options = {scene[i].alpha, scene[i].tolerance, scene[i].phi_points, 0};
        const struct cor_disk_collision_detail detail = {.energy_after = after, .energy_average = average};
        const size_t n = scene[i].n, bytes = cor_disk_collision_workspace(modes, n, &options);
        assert_true(bytes > 0);
        unsigned char *const memory = malloc(bytes + 2 * CANARIES);
        assert_non_null(memory);
        struct cor_disk_collision first, out, untouched;
        memset(memory, 0xa5, bytes + 2 * CANARIES);
        memset(&out, 0x5a, sizeof out);
        memset(&untouched, 0x5a, sizeof untouched);
        for (int k = 0; k < 2; k++)
            assert_int_equal(
                cor_disk_collision_in(memory, k ? bytes - 1 : 0, modes, n, &options, scene[i].v, &out, NULL),
                COR_ERROR_WORKSPACE);
        assert_memory_equal(&out, &untouched, sizeof out);
        for (size_t j = 0; j < bytes + 2 * CANARIES; j++)
            assert_int_equal(memory[j], 0xa5);
        assert_int_equal(cor_disk_collision(modes, n, &options, scene[i].v, &first), COR_OK);
        for (size_t k = 0; k < 4; k++) { /* zeros, ones, NaN, and NaN aligned like malloc */
            unsigned char *const workspace = memory + (k == 3 ? 16 : 0);
            memset(workspace, k == 0 ? 0 : 0xff, bytes);
            for (size_t j = 0; k > 1 && j + sizeof nan <= bytes; j += sizeof nan)
                memcpy(workspace + j, &nan, sizeof nan);
            memset(workspace + bytes, 0xa5, CANARIES);
            for (size_t j = 0; j < TABLE; j++)
                after[j] = average[j] = -1;
            assert_int_equal(cor_disk_collision_in(workspace, bytes, modes, n, &options, scene[i].v, &out, &detail),
                             COR_OK);
            same_results(&out, &first, "another workspace");
            for (size_t j = 0; j < CANARIES; j++)
                assert_int_equal(workspace[bytes + j], 0xa5);
            for (size_t j = 0; j < TABLE; j++)
                check(j < n ? after[j] >= 0 && average[j] >= 0 : after[j] == -1 && average[j] == -1, "%zu of %zu", j,
                      n);
            if (k == 0) {
                memcpy(after_first, after, sizeof after);
                memcpy(average_first, average, sizeof average);
            }
            assert_memory_equal(after, after_first, sizeof after);
            assert_memory_equal(average, average_first, sizeof average);
            /* the workspace has the contents that another collision left */
            cor_disk_collision_in(workspace, bytes, material(1.2 - scene[i].nu), (n + 1) / 2, &options, 0.05, &out,
                                  NULL);
            assert_int_equal(cor_disk_collision_in(workspace, bytes, modes, n, &options, scene[i].v, &out, NULL),
                             COR_OK);
            same_results(&out, &first, "a workspace used before");
        }
        free(memory);
    }
    /* more modes, a harder wall or a finer tolerance need more memory */
    const struct cor_disk_collision_options plain = {500, 1e-6, 0, 0}, harder = {8000, 1e-6, 0, 0},
                                            finer = {500, 1e-12, 0, 0};
    const size_t bytes = cor_disk_collision_workspace(&cor_disk_modes_nu033, 100, &plain);
    assert_true(cor_disk_collision_workspace(&cor_disk_modes_nu033, 100, &harder) > bytes);
    assert_true(cor_disk_collision_workspace(&cor_disk_modes_nu033, 100, &finer) >= bytes);
    assert_true(cor_disk_collision_workspace(&cor_disk_modes_nu033, 1000, &plain) > bytes);
}

/* A call with many speeds gives the bits of single calls, in any order. From speed to speed the number of angles stays,
 * grows or shrinks. Some speeds are refused, or do not reach the tolerance. Each speed has its own budget. */
TEST(many_speeds)
{
    static const double speed[] = {0.1, 0.1, 0.002, 0.3, NAN, 0.05, 0.500001, 0, -1, INFINITY, 0.5, 1e-9, 0.1, -0.0};
    enum { SPEEDS = sizeof speed / sizeof *speed, SCENES = 4, SLOW = 2 };
    static const struct {
        size_t modes;
        struct cor_disk_collision_options options;
    } scene[SCENES] = {
        {1, {500, 1e-3, 0, 0}}, {40, {500, 1e-6, 0, 0}}, {40, {2000, 1e-9, 24, 0}}, {40, {500, 1e-4, 0, 900}}};
    for (int k = 0; k < SCENES; k++) {
        if (k == SLOW && (points(10) < 10 || left_to_turn(1, 3)))
            continue;
        struct cor_disk_collision out[SPEEDS + 1], one;
        int status[SPEEDS + 1], first = COR_OK;
        memset(out, 0x5a, sizeof out);
        status[SPEEDS] = -7;
        const int result = cor_disk_collision_array(&cor_disk_modes_nu033, scene[k].modes, &scene[k].options, speed,
                                                    SPEEDS, out, status);
        for (int i = 0; i < SPEEDS; i++) {
            memset(&one, 0, sizeof one);
            const int alone =
                cor_disk_collision(&cor_disk_modes_nu033, scene[k].modes, &scene[k].options, speed[i], &one);
            check(status[i] == alone, "scene %d, speed %g: status %d, alone %d", k, speed[i], status[i], alone);
            if (first == COR_OK)
                first = alone;
            if (alone == COR_ERROR_SPEED)
                check(isnan(out[i].eps) && isnan(out[i].one_minus_eps2) && isnan(out[i].contact_time) &&
                          isnan(out[i].max_compression) && isnan(out[i].energy_drift) && out[i].steps == 0 &&
                          isnan(out[i].error_estimate),
                      "scene %d, speed %g", k, speed[i]);
            else
                check(memcmp(&out[i], &one, sizeof one) == 0, "scene %d, speed %g: eps %a, alone %a", k, speed[i],
                      out[i].eps, one.eps);
        }
        assert_int_equal(result, first);
        assert_int_equal(status[SPEEDS], -7);
        for (size_t i = 0; i < sizeof *out; i++)
            assert_int_equal(((unsigned char *)&out[SPEEDS])[i], 0x5a);
        assert_int_equal(
            cor_disk_collision_array(&cor_disk_modes_nu033, scene[k].modes, &scene[k].options, speed, 1, &one, NULL),
            status[0]);
        assert_memory_equal(&one, &out[0], sizeof one);
    }
    assert_int_equal(cor_disk_collision_array(&cor_disk_modes_nu033, 40, &scene[0].options, NULL, 0, NULL, NULL),
                     COR_OK);
}

static void refused(const struct cor_disk_modes *modes, size_t n, const struct cor_disk_collision_options *options,
                    double v, int expected)
{
    static double workspace[1 << 17];
    struct cor_disk_collision out, untouched;
    memset(&out, 0x5a, sizeof out);
    memset(&untouched, 0x5a, sizeof untouched);
    memset(after, 0x5a, sizeof after);
    const struct cor_disk_collision_detail detail = {.energy_after = after};
    const int status = cor_disk_collision(modes, n, options, v, &out);
    check(status == expected, "status %d (%s), not %d", status, cor_status_text(status), expected);
    assert_int_equal(cor_disk_collision_in(workspace, sizeof workspace, modes, n, options, v, &out, &detail), expected);
    assert_memory_equal(&out, &untouched, sizeof out);
    for (size_t i = 0; i < sizeof after; i++)
        assert_int_equal(((unsigned char *)after)[i], 0x5a);
    if (expected == COR_ERROR_SPEED)
        return;
    int of_speed = -7; /* no error in the speed, so the whole list is refused */
    assert_int_equal(cor_disk_collision_workspace(modes, n, options), 0);
    assert_int_equal(cor_disk_collision_array(modes, n, options, &v, 1, &out, &of_speed), expected);
    assert_int_equal(of_speed, -7);
    assert_memory_equal(&out, &untouched, sizeof out);
}

TEST(refusals)
{
    const struct cor_disk_modes *const modes = &cor_disk_modes_nu033;
    const struct cor_disk_collision_options good = {500, 1e-3, 0, 0};
    struct cor_disk_collision out;
    static double workspace[1 << 17];
    assert_int_equal(cor_disk_collision_in(workspace, sizeof workspace, modes, 5, &good, 0.1, &out, NULL), COR_OK);

    refused(NULL, 5, &good, 0.1, COR_ERROR_NULL);
    refused(modes, 5, NULL, 0.1, COR_ERROR_NULL);
    refused(&(struct cor_disk_modes){0.33, 5, NULL}, 5, &good, 0.1, COR_ERROR_NULL);
    assert_int_equal(cor_disk_collision(modes, 5, &good, 0.1, NULL), COR_ERROR_NULL);
    assert_int_equal(cor_disk_collision_array(modes, 5, &good, &(double){0.1}, 1, NULL, NULL), COR_ERROR_NULL);
    assert_int_equal(cor_disk_collision_array(modes, 5, &good, NULL, 1, &out, NULL), COR_ERROR_NULL);
    assert_int_equal(cor_disk_collision_in(workspace, sizeof workspace, modes, 5, &good, 0.1, NULL, NULL),
                     COR_ERROR_NULL);
    assert_int_equal(cor_disk_collision_in(NULL, sizeof workspace, modes, 5, &good, 0.1, &out, NULL), COR_ERROR_NULL);

    refused(modes, 0, &good, 0.1, COR_ERROR_MODES);
    refused(&(struct cor_disk_modes){0.33, 5, modes->mode}, 6, &good, 0.1, COR_ERROR_MODES);
    refused(modes, SIZE_MAX, &good, 0.1, COR_ERROR_MODES);
    const struct cor_disk_modes mine = {0.33, 5, some};
    memcpy(some, modes->mode, 4 * sizeof *some);
    const struct cor_disk_mode bad[] = {{2, 0, NAN, 1, 1},
                                        {2, 0, INFINITY, 1, 1},
                                        {2, 0, 0, 1, 1},
                                        {2, 0, -1, 1, 1},
                                        {2, 0, 9, NAN, 1},
                                        {2, 0, 9, 1, INFINITY},
                                        {-1, 0, 9, 1, 1},
                                        {INT_MIN, 0, 9, 1, 1},
                                        {INT_MAX, 0, 9, 1, 1},
                                        {COR_DISK_MODES_MAX_N + 1, 0, 9, 1, 1},
                                        {2, 0, some[3].omega, 1, 1}};
    for (size_t i = 0; i + 1 < 2 * COUNT_OF(bad); i++) { /* as mode 5 and as mode 1; the last only as mode 5 */
        some[i % 2 ? 0 : 4] = bad[i / 2];
        refused(&mine, i % 2 ? 1 : 5, &good, 0.1, COR_ERROR_MODES);
        some[0] = modes->mode[0];
    }
    some[0].n = COR_DISK_MODES_MAX_N; /* the largest memory for a table of few modes */
    const struct cor_disk_collision_options most = {COR_DISK_COLLISION_MAX_ALPHA, COR_DISK_COLLISION_MIN_TOLERANCE,
                                                    COR_DISK_COLLISION_MAX_PHI_POINTS, 0};
    const size_t bytes = cor_disk_collision_workspace(&mine, 1, &most);
    check(bytes > 0 && (double)bytes <= COR_DISK_COLLISION_MAX_WORKSPACE, "%zu bytes for the largest n", bytes);

    EACH (bad_nu, 1, -1, nextafter(1, 2), nextafter(-1, -2), INFINITY, NAN)
        refused(&(struct cor_disk_modes){*bad_nu, 5, modes->mode}, 5, &good, 0.1, COR_ERROR_DISK_POISSON_RATIO);
    EACH (bad_speed, nextafter(COR_DISK_COLLISION_MAX_SPEED, 1), 1, INFINITY, NAN)
        refused(modes, 5, &good, *bad_speed, COR_ERROR_SPEED);
    assert_int_equal(cor_disk_collision(modes, 5, &good, COR_DISK_COLLISION_MAX_SPEED, &out), COR_OK);
    EACH (bad_alpha, 0, -0.0, -1, -INFINITY, INFINITY, NAN, nextafter(COR_DISK_COLLISION_MIN_ALPHA, 0),
          nextafter(COR_DISK_COLLISION_MAX_ALPHA, INFINITY))
        refused(modes, 5, &(struct cor_disk_collision_options){*bad_alpha, 1e-3, 0, 0}, 0.1, COR_ERROR_ALPHA);
    EACH (bad_tolerance, nextafter(COR_DISK_COLLISION_MIN_TOLERANCE, 0), 1, nextafter(1, 2), 0, -1e-8, INFINITY, NAN)
        refused(modes, 5, &(struct cor_disk_collision_options){500, *bad_tolerance, 0, 0}, 0.1, COR_ERROR_TOLERANCE);
    const size_t bad_points[] = {COR_DISK_COLLISION_MAX_PHI_POINTS + 1, SIZE_MAX};
    for (size_t i = 0; i < 2; i++)
        refused(modes, 5, &(struct cor_disk_collision_options){500, 1e-3, bad_points[i], 0}, 0.1, COR_ERROR_PHI_POINTS);
    assert_true(cor_disk_collision_workspace(
                    modes, 5, &(struct cor_disk_collision_options){500, 1e-3, COR_DISK_COLLISION_MAX_PHI_POINTS, 0}) >
                0);
}
