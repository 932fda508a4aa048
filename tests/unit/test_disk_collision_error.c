/* SPDX-License-Identifier: MIT */
/* The guarantees of cor_disk_collision about its error: COR_OK means within the tolerance, error_estimate is at least
 * the error, and no call exceeds its budget. The reference is reference_collision.h: Taylor series in time, in long
 * double or, for collisions that amplify errors strongly, in quad precision. If the modes are too many for it, the
 * reference is a call with a hundredth of the tolerance.
 *     COR_TEST_LONG=1 COR_TEST_MULTIPLIER=834 test_disk_collision_error
 * judges 10^4 random scenes of each kind, in half an hour and in two hours. Another COR_SEED gives other scenes. */
#include "check.h"

#include <cor/disk.h>
#include <cor/status.h>

#include "reference_collision.h"

struct scene {
    double nu;
    size_t modes;
    double alpha, speed, tolerance;
};

static const struct cor_disk_modes *material(double nu)
{
    return nu < 0.5 ? &cor_disk_modes_nu033 : &cor_disk_modes_nu090;
}

static int scene_collide(const struct scene *s, size_t max_steps, struct cor_disk_collision *out)
{
    const struct cor_disk_collision_options options = {s->alpha, s->tolerance, 0, max_steps};
    return cor_disk_collision(material(s->nu), s->modes, &options, s->speed, out);
}

/* ---- random scenes ---- */

/* Returns a scene in the range of the guarantee. */
static struct scene random_scene(struct random_state *random)
{
    struct scene s = {random_uniform(random, 0, 1) < 0.5 ? 0.33 : 0.9, 0, 0, 0, 0};
    s.modes = 1 + (size_t)random_uniform(random, 0, 60);
    s.alpha = random_log(random, 200, 8000);
    s.speed = random_log(random, 0.003, 0.3);
    s.tolerance = random_log(random, 1e-11, 1e-3);
    return s;
}

/* Returns a scene with more modes than the Taylor series can treat in acceptable time, and a larger tolerance. In half
 * of the scenes, the wall is so hard and the disk so fast that the rim hits the wall many times. This amplifies the
 * error of the angles. */
static struct scene larger_scene(struct random_state *random)
{
    const int blows = random_uniform(random, 0, 1) < 0.5;
    struct scene s = {random_uniform(random, 0, 1) < 0.5 ? 0.33 : 0.9, 0, 0, 0, 0};
    s.modes = (size_t)(blows ? random_log(random, 20, 301) : random_log(random, 10, 1801));
    s.alpha = blows ? random_log(random, 200, 3000) : random_log(random, 100, 8000);
    s.speed = blows ? random_log(random, 0.05, 0.45) : random_log(random, 0.003, 0.45);
    s.tolerance = random_log(random, 1e-6, 1e-2);
    return s;
}

/* Allowed share of estimates that are too small, and the largest factor by which they may be too small */
static const double too_small_share = 0.005, too_small_factor = 4;

struct tally {
    size_t scenes, ok, too_small, undecided;
    double worst_of_tolerance, worst_of_estimate;
};

static void judge_numbers(const struct scene *s, int status, const struct cor_disk_collision *out,
                          const struct reference_collision *reference, struct tally *tally)
{
    const double error = fabs(out->eps - reference->eps), unsure = reference->error + DBL_EPSILON;
    const double loss_error = fabs(out->one_minus_eps2 - reference->one_minus_eps2);
    const double of_estimate = (error - unsure) / out->error_estimate;
    char what[200];
    snprintf(what, sizeof what, "off by %.3g, estimate %.3g: nu = %g, N = %zu, alpha = %a, v = %a, tolerance %.3g (%a)",
             error, out->error_estimate, s->nu, s->modes, s->alpha, s->speed, s->tolerance, s->tolerance);
    tally->worst_of_estimate = fmax(tally->worst_of_estimate, of_estimate);
    if (of_estimate > 1) {
        tally->too_small++;
        print_message("estimate too small, %s\n", what);
    }
    if (status != COR_OK)
        return;
    tally->worst_of_tolerance = fmax(tally->worst_of_tolerance, (error - unsure) / s->tolerance);
    check(error <= s->tolerance + unsure && loss_error <= 4 * (s->tolerance + unsure), "COR_OK, and wrong, %s", what);
}

static void scene_judge(const struct scene *s, struct tally *tally)
{
    struct cor_disk_collision out;
    struct reference_collision reference;
    const double start = processor_seconds();
    const int status = scene_collide(s, 0, &out);
    const double seconds = processor_seconds() - start;
    check((status == COR_OK || status == COR_TOLERANCE_NOT_REACHED) &&
              (status == COR_OK) == (out.error_estimate <= s->tolerance) && seconds < 10,
          "nu = %g, N = %zu, alpha = %a, v = %a, tolerance %a: %s, estimate %g, %g s", s->nu, s->modes, s->alpha,
          s->speed, s->tolerance, cor_status_text(status), out.error_estimate, seconds);
    const int known = reference_disk_collision(material(s->nu)->mode, s->modes, s->alpha, s->speed,
                                               0.1 * out.error_estimate, &reference, NULL, NULL);
    tally->ok += status == COR_OK;
    tally->undecided += known != 0;
    if (known == 0)
        judge_numbers(s, status, &out, &reference, tally);
}

/* Judges a call that returned COR_OK, and a call with another tolerance, by a call with a much smaller tolerance. */
static void scene_judge_by_tighter(const struct scene *s, struct tally *tally)
{
    struct scene other = *s, tighter = *s;
    struct cor_disk_collision out, of_other, truth;
    other.tolerance = 1e-8 / s->tolerance; /* this tolerance is from 1e-6 to 1e-2, too */
    tighter.tolerance = 0.01 * s->tolerance;
    const int status = scene_collide(s, 0, &out);
    if (status != COR_OK)
        return;
    tally->ok++;
    const int tight = scene_collide(&tighter, 0, &truth), second = scene_collide(&other, 0, &of_other);
    const struct reference_collision reference = {
        .eps = truth.eps, .one_minus_eps2 = truth.one_minus_eps2, .error = truth.error_estimate};
    if (tight == COR_OK || truth.error_estimate <= 0.5 * s->tolerance)
        judge_numbers(s, status, &out, &reference, tally);
    else
        tally->undecided++;
    if (second == COR_OK && (tight == COR_OK || truth.error_estimate <= 0.5 * other.tolerance))
        judge_numbers(&other, second, &of_other, &reference, tally);
}

/* Judges `count` scenes. At least the share `ok` of the calls, less two standard deviations, must reach the tolerance.
 * At most the share `undecided`, plus `slack` standard deviations, may lack a reference. */
static void judge_all(int larger, size_t count, double ok, double undecided, double slack)
{
    struct random_state random = random_start();
    struct tally t = {0};
    const double scenes = (double)count;
    for (size_t i = 0; i < count; i++) {
        const struct scene s = larger ? larger_scene(&random) : random_scene(&random);
        (larger ? scene_judge_by_tighter : scene_judge)(&s, &t);
    }
    print_message(
        "%zu scenes: %zu COR_OK, off by at most %.2g of the tolerance; estimate too small in %zu, error at most "
        "%.2g of it; %zu undecided\n",
        count, t.ok, t.worst_of_tolerance, t.too_small, t.worst_of_estimate, t.undecided);
    check((double)t.too_small <= fmax(1, too_small_share * scenes) && t.worst_of_estimate <= too_small_factor,
          "%zu estimates are too small, one by %.2g", t.too_small, t.worst_of_estimate);
    check((double)t.ok >= ok * scenes - 2 * sqrt(scenes), "COR_OK in only %zu of %zu scenes", t.ok, count);
    check((double)t.undecided <= undecided * scenes + slack * sqrt(scenes), "%zu of %zu scenes without a reference",
          t.undecided, count);
}

TEST(random_scenes)
{
    judge_all(0, points(few_or_all(2, 12)), 0.93, 0.002, 0);
}

TEST(larger_scenes)
{
    judge_all(1, points(few_or_all(1, 12)), 0.7, 0.1, 2);
}

/* ---- known scenes ---- */

/* Hard scenes with eps from reference_disk_collision, whose error is `known`. With COR_TEST_MULTIPLIER, the test
 * computes eps again. The scenes have extreme speeds and walls, or few modes at hard walls, where the round-off of the
 * speed grows 10^4 to 10^6 times. */
static const struct known_scene {
    struct scene scene;
    double exact, known;
    double other[2]; /* tolerances */
    double reached;  /* below this tolerance COR_TOLERANCE_NOT_REACHED is expected */
} known_scenes[] = {
    {{0.33, 300, 50, 0.3, 1e-2}, 0.870767028481, 1e-11, {1e-4}, 0},
    {{0.9, 10, 8000, 0.3, 1e-2}, 0.709986840267, 1e-11, {1e-4}, 0},
    {{0.33, 300, 8000, 0.001, 1e-2}, 0.985360360194, 1e-11, {1e-4}, 0},
    {{0.33, 300, 50, 0.5, 1e-2}, 0.803059813792, 1e-11, {1e-4}, 0},
    {{0.33, 1, 8000, 0.3, 1e-2}, 0.618906212807, 1e-11, {1e-4}, 0},
    {{0.33, 30, 8000, 0.3, 1e-3}, 0.799369796954, 1e-11, {1e-5}, 0},
    {{0.33, 60, 2000, 0.1, 1e-3}, 0.928625468805, 1e-11, {1e-5}, 0},
    {{0.33, 100, 4000, 0.05, 1e-3}, 0.967425680918, 1e-11, {1e-5}, 0},
    {{0.33, 20, 4767.2836646688293, 0.10233708232535071, 5.5257690548836654e-10}, 0.93508420077908161, 1e-14, {0}, 1},
    {{0.9, 6, 4000, 0.1, 1e-11}, 0.84866222836689342, 1e-14, {0}, 0},
    {{0.9, 7, 4000, 0.1, 1e-11}, 0.94613165857209169, 1e-14, {0}, 0},
    /* Runs with different steps agreed by chance: the first two for six modes, the fifth and sixth for 48. */
    {{0.9, 6, 0x1.8bdeb3d65fedbp+11, 0x1.87f15e3cb249fp-5, 0x1.2dd0dd9825526p-15}, 0.87073496665805972, 1e-14, {0}, 0},
    {{0.33, 48, 0x1.95b6e78a562f8p+12, 0x1.e81c11e886a5bp-4, 0x1.3aace989748acp-22},
     0.91298043088108116,
     1e-14,
     {0},
     0},
    /* repeated impacts amplify the error of the angles, which the estimate from the load does not contain */
    {{0.9, 80, 2018.0773948944377, 0.15687429682060067, 3e-3}, 0.80948591625, 1e-9, {8.65e-3}, 0},
    /* the next two run only in one turn of three */
    {{0.33, 24, 4000, 0.1, 1e-4}, 0.92397154646327462, 1e-14, {1e-8, 1e-9}, 1e-4},
    {{0.33, 1, 1e5, 0.5, 1e-3}, 0.64017708980255905, 1e-14, {0}, 0}, /* a million steps */
    /* runs only with COR_TEST_LONG */
    {{0.33, 88, 1946.4152313318912, 0.16442487641337461, 7.65e-4}, 0.89870605479, 1e-9, {0}, 0},
    {{0.33, 102, 1370.0253151840241, 0.29538227585475529, 4.02e-3}, 0.83262076629, 1e-9, {0}, 0},
    {{0.9, 217, 2222.3460280325576, 0.11609046550177622, 5.34e-5}, 0.85338185490, 1e-9, {0}, 0},
    {{0.33, 30, 8000, 0.3, 1e-7}, 0.799369796954, 1e-11, {0}, 0},
    {{0.33, 60, 2000, 0.1, 1e-7}, 0.928625468805, 1e-11, {0}, 0},
    {{0.33, 100, 4000, 0.05, 1e-7}, 0.967425680918, 1e-11, {0}, 1},
};
enum { KNOWN = sizeof known_scenes / sizeof *known_scenes, LONG_ONLY = 6, IN_TURN = 2 };

static void scenes_known(size_t first, size_t end)
{
    for (const struct known_scene *k = known_scenes + first; k < known_scenes + end; k++) {
        struct scene s = k->scene;
        const double tolerance[] = {s.tolerance, k->other[0], k->other[1]};
        for (int i = 0; i < 3 && tolerance[i] > 0; i++) {
            struct cor_disk_collision out;
            s.tolerance = tolerance[i];
            assert_int_equal(scene_collide(&s, 0, &out),
                             s.tolerance >= k->reached ? COR_OK : COR_TOLERANCE_NOT_REACHED);
            const double error = fabs(out.eps - k->exact);
            check(s.tolerance < k->reached || error <= s.tolerance, "off by %g tolerances", error / s.tolerance);
            check(error <= out.error_estimate, "off by %g, estimate %g", error, out.error_estimate);
        }
        if (points(1) > 1) {
            struct reference_collision again;
            assert_int_equal(
                reference_disk_collision(material(s.nu)->mode, s.modes, s.alpha, s.speed, k->known, &again, NULL, NULL),
                0);
            check(fabs(again.eps - k->exact) <= 2 * k->known, "reference %.17g, not %.17g", again.eps, k->exact);
        }
    }
}

TEST(known)
{
    scenes_known(0, KNOWN - LONG_ONLY - IN_TURN);
    scenes_known(KNOWN - LONG_ONLY, few_or_all(KNOWN - LONG_ONLY, KNOWN));
}

TEST(known_in_turn)
{
    leave_to_turn(2, 3);
    scenes_known(KNOWN - LONG_ONLY - IN_TURN, KNOWN - LONG_ONLY - (points(2) < 2)); /* a small run omits the last */
}

/* ---- the amplification of errors ---- */

/* eps can be no more accurate than one ulp of v times d eps/d v. */
TEST(amplification)
{
    leave_to_turn(1, 4);
    static const struct scene scene[] = {{0.33, 24, 4000, 0.1, 1e-9},
                                         {0.33, 52, 1313, 0.104, 1e-11},
                                         {0.9, 40, 2312, 0.27, 1e-10},
                                         {0.33, 10, 500, 0.1, 1e-13}};
    for (size_t i = 0; i < sizeof scene / sizeof *scene; i++) {
        struct scene near = scene[i];
        struct cor_disk_collision out, moved;
        scene_collide(&scene[i], 0, &out);
        near.speed *= 1 + 0x1p-26;
        scene_collide(&near, 0, &moved);
        const double amplified = fabs(moved.eps - out.eps) * 0x1p26;
        check(out.error_estimate >= amplified * 0x1p-53, "estimate %g, amplification %g", out.error_estimate,
              amplified);
    }
}

/* ---- budgets ---- */

TEST(budgets)
{
    const struct scene s = {0.33, 20, 500, 0.1, 1e-9};
    struct reference_collision truth;
    struct cor_disk_collision out, free_of_budget;
    assert_int_equal(
        reference_disk_collision(material(s.nu)->mode, s.modes, s.alpha, s.speed, 1e-13, &truth, NULL, NULL), 0);
    assert_int_equal(scene_collide(&s, 0, &free_of_budget), COR_OK);
    double before = INFINITY;
    int reached = 0;
    for (size_t most = 1; most < 100000; most += most / 2 + 1) {
        const int status = scene_collide(&s, most, &out);
        if (status == COR_CONTACT_NOT_ENDED) {
            assert_true(isinf(before) && isnan(out.eps) && isnan(out.error_estimate));
            assert_true(out.steps <= most);
            continue;
        }
        assert_true(status == (out.error_estimate <= s.tolerance ? COR_OK : COR_TOLERANCE_NOT_REACHED));
        check(out.steps <= most, "%zu steps of %zu", out.steps, most);
        check(fabs(out.eps - truth.eps) <= out.error_estimate + truth.error, "%zu steps: off by %g, estimate %g", most,
              out.eps - truth.eps, out.error_estimate);
        check(out.error_estimate <= before, "%zu steps: estimate %g after %g", most, out.error_estimate, before);
        before = out.error_estimate;
        check(status != COR_OK || same_bits(out.eps, free_of_budget.eps), "eps %a, not %a", out.eps,
              free_of_budget.eps);
        reached += status == COR_OK;
    }
    assert_true(reached > 0);
    /* a single run has no other run for comparison */
    assert_int_equal(scene_collide(&s, 1000, &out), COR_TOLERANCE_NOT_REACHED);
    assert_true(out.error_estimate == 1 && isnan(out.contact_time) && out.max_compression > 0);
    /* averages need a third run */
    double average[20] = {0};
    const struct cor_disk_collision_options options = {s.alpha, s.tolerance, 0, 1200};
    const struct cor_disk_collision_detail detail = {.energy_average = average};
    const size_t bytes = cor_disk_collision_workspace(material(s.nu), s.modes, &options);
    void *const workspace = malloc(bytes + 1);
    assert_non_null(workspace);
    assert_int_equal(cor_disk_collision_in(workspace, bytes, material(s.nu), s.modes, &options, s.speed, &out, &detail),
                     COR_TOLERANCE_NOT_REACHED);
    free(workspace);
    assert_true(isnan(average[0]) && isnan(average[19]));
}
