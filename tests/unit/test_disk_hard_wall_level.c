/* SPDX-License-Identifier: MIT */
/* Tests one level of the rigid wall (runtime/disk/hard_wall_level.c, hard_wall_contact.c) against the written-out
 * formulas (reference_hard_wall.h), which share no sum, contact solver or step with it. Also tests two cutoffs, a point
 * contact, energy, contacts in pieces and instruction sets. */
#include "check.h"

#include <cor/status.h>

#include "reference_hard_wall.h"
#include "runtime/disk/hard_wall_parts.h"
#include "runtime/disk/mode_source.h"

static const double pi = 3.14159265358979323846;

enum { MOST_MODES = 60000 };
static struct cor_disk_mode mode[MOST_MODES];

/* Returns the modes below omega, and one more. */
static struct cor_disk_modes modes_of(double nu, double omega)
{
    struct cor_disk_modes modes;
    const size_t count = cor_disk_modes_below(nu, omega) + 1;
    assert_in_range(count, 2, MOST_MODES);
    assert_int_equal(cor_disk_modes_compute(nu, count, mode, &modes), COR_OK);
    return modes;
}

static struct cor_hard_wall_result level_of(const struct cor_disk_modes *modes, double speed,
                                            const struct cor_hard_wall_settings *settings, int expected)
{
    struct cor_hard_wall_result result = {0};
    size_t below = 0;
    while (below < modes->count && modes->mode[below].omega < settings->omega)
        below++;
    const size_t bytes = cor_hard_wall_level_bytes(modes->mode, below, settings);
    char *const room = malloc(bytes + COR_ALIGNMENT);
    assert_non_null(room);
    const int status = cor_hard_wall_level(cor_store_aligned(room), modes, speed, settings, &result, NULL);
    check(status == expected, "nu = %g, v = %g, Omega = %g: %s", modes->nu, speed, settings->omega,
          cor_status_text(status));
    free(room);
    return result;
}

/* Returns settings for which steps and angles contribute errors of 1e-7. */
static struct cor_hard_wall_settings fine_settings(double omega, double speed)
{
    const double half_width = 1.1 * sqrt(speed), spacing = fmin(fmax(0.2 / omega, half_width / 400), half_width / 150);
    return (struct cor_hard_wall_settings){
        .omega = omega, .turn = 0.25, .spacing = spacing, .range = 2.6 * sqrt(speed)};
}

/* ---- against the written-out formulas ---- */

static struct reference_wall reference_settings(const struct cor_hard_wall_settings *settings, double speed, double h,
                                                int nyquist)
{
    return (struct reference_wall){.omega = settings->omega,
                                   .fade_next = settings->fade == COR_HARD_WALL_FADE,
                                   .h = h,
                                   .nyquist = nyquist,
                                   .angles = (int)(2.2 * sqrt(speed) * nyquist / pi) + 4};
}

static void as_written_out(double nu, double speed, double omega, enum cor_hard_wall_fade fade)
{
    const struct cor_disk_modes modes = modes_of(nu, omega);
    const int half = COR_HARD_WALL_PANEL / 2, nyquist = half * (int)(fmax(8 * omega, 45 / sqrt(speed)) / half + 1);
    struct cor_hard_wall_settings settings = fine_settings(omega, speed);
    settings.fade = fade;
    settings.spacing = pi / nyquist * (1 + 1e-12);
    const struct cor_hard_wall_result level = level_of(&modes, speed, &settings, COR_OK);
    struct reference_wall wall = reference_settings(&settings, speed, 0.15 / omega, nyquist);
    double l[2];
    for (int i = 0; i < 2; i++, wall.h /= 2)
        l[i] = reference_hard_wall(&modes, speed, &wall);
    /* the reference has errors of order h^2 and h^4; both results have noise from the steps, of order 1/Omega^2 */
    const double reference = l[1] + (l[1] - l[0]) / 3;
    check(fabs(level.one_minus_eps2 - reference) < 1.5e-3 / (omega * omega), "nu = %g, v = %g: %.9f, not %.9f", nu,
          speed, level.one_minus_eps2, reference);
}

TEST(written_out)
{
    as_written_out(0.33, 0.1, 20, COR_HARD_WALL_FADE);
    as_written_out(0.33, 0.1, 20, COR_HARD_WALL_PLAIN_FADE);
    for (size_t i = 0; i < points(4); i++) {
        const double speed = random_log(&draw, 3e-3, 0.4), nu = random_uniform(&draw, -0.5, 0.95);
        as_written_out(nu, speed, random_uniform(&draw, 12, 24),
                       i % 2 == 0 ? COR_HARD_WALL_FADE : COR_HARD_WALL_PLAIN_FADE);
    }
}

/* nu close to 1, and speeds at which the contact splits into pieces, so that the solver changes the touching angles */
TEST(in_pieces)
{
    leave_to_turn(1, 3);
    const double nu = 0.9, speed = 0.25, omega = 60;
    const struct cor_disk_modes modes = modes_of(nu, omega);
    struct cor_hard_wall_settings settings = fine_settings(omega, speed);
    const int nyquist = 10 * COR_HARD_WALL_PANEL / 2;
    settings.spacing = pi / nyquist * (1 + 1e-12);
    const struct cor_hard_wall_result level = level_of(&modes, speed, &settings, COR_OK);
    check(level.pivotings > 0, "the contact was one piece always");
    const struct reference_wall wall = reference_settings(&settings, speed, 0.25 / omega, nyquist);
    const double reference = reference_hard_wall(&modes, speed, &wall);
    check(fabs(level.one_minus_eps2 - reference) < 2e-5, "%.9f, not %.9f", level.one_minus_eps2, reference);
}

/* In successive contacts of one or more pieces, all forces push, no angle is inside the wall, and every angle with a
 * force touches the wall. */
TEST(contacts)
{
    enum { POINTS = COR_HARD_WALL_PANEL, NYQUIST = 2 * POINTS };
    double twice_cosine[2 * POINTS], scratch[2 * POINTS], t[NYQUIST + 1], q, reach[POINTS], y[POINTS];
    struct cor_hard_wall_contact contact = {.loops = cor_hard_wall_set(cor_widest_set())};
    struct cor_store store = {NULL, 0};
    cor_hard_wall_contact_arrange(&contact, &store, POINTS);
    char *const room = malloc(store.used + COR_ALIGNMENT);
    assert_non_null(room);
    store.base = cor_store_aligned(room);
    store.used = 0;
    cor_hard_wall_contact_arrange(&contact, &store, POINTS);
    for (int i = 0; i < 2 * POINTS; i++)
        twice_cosine[i] = 2 * cos(i * pi / NYQUIST);
    const struct cor_hard_wall_angles angles = {.twice_cosine = twice_cosine};
    for (size_t draws = 0; draws < points(200); draws++) {
        for (int k = 0; k <= NYQUIST; k++)
            t[k] = random_uniform(&draw, 0.1, 1) / (k + 1);
        q = random_uniform(&draw, 0, 1);
        cor_hard_wall_contact_begin(&contact, NYQUIST + 1, t, 1, &q, &angles, -0.999 * t[0] / (4 * pi), scratch);
        for (int step = 0; step < 10; step++) {
            const double waves = random_uniform(&draw, 0, 40), other = random_uniform(&draw, 0, 40);
            const double level = random_uniform(&draw, -1.5, 0.5);
            for (int j = 0; j < POINTS; j++)
                reach[j] = j < POINTS - 8 ? level + cos(waves * j / POINTS) + cos(other * j / POINTS) : -9;
            const size_t end = cor_hard_wall_contact_solve(&contact, reach, 1e-12, y);
            assert_true(end < POINTS && (end == 0 || y[end - 1] > 0) && !contact.indefinite);
            for (int i = 0; i < POINTS; i++) {
                double left = reach[i];
                for (int j = 0; j < POINTS; j++) {
                    const int minus = POINTS + i - j, plus = POINTS + i + j;
                    left -= y[j] * (contact.same[minus] + contact.same[plus] + contact.constant +
                                    contact.across[plus] * contact.cosine[minus] +
                                    contact.across[minus] * contact.cosine[plus]);
                }
                check(y[i] >= 0 && left < 1e-9 && (y[i] <= 0 || left > -1e-9), "angle %d: force %g, %g in the wall", i,
                      y[i], left);
            }
        }
        assert_true(contact.pivotings > 0);
    }
    free(room);
}

/* ---- invariances ---- */

/* Returns the result R, extrapolated from two levels. */
static double extrapolated(const struct cor_disk_modes *modes, double speed, double omega, enum cor_hard_wall_fade fade)
{
    double l[2];
    for (int i = 0; i < 2; i++) {
        struct cor_hard_wall_settings settings = fine_settings(i == 0 ? omega / sqrt(2) : omega, speed);
        settings.fade = fade;
        l[i] = level_of(modes, speed, &settings, COR_OK).one_minus_eps2;
    }
    return 2 * l[1] - l[0];
}

/* Both cutoffs have the same limit. At Omega = 170 they are within 2e-5 of it in hard scenes, and closer in others. */
TEST(two_fades)
{
    leave_to_turn(0, 3);
    const double omega = 120 * sqrt(2);
    for (size_t i = 0; i < points(2); i++) {
        const double speed = i == 0 ? 0.1 : random_log(&draw, 1e-3, 0.15);
        const double nu = i == 0 ? 0.33 : random_uniform(&draw, -0.2, 0.6);
        const struct cor_disk_modes modes = modes_of(nu, omega);
        const double one = extrapolated(&modes, speed, omega, COR_HARD_WALL_FADE);
        const double other = extrapolated(&modes, speed, omega, COR_HARD_WALL_PLAIN_FADE);
        check(fabs(one - other) < (i == 0 ? 1e-6 : 4e-5), "nu = %g, v = %g: %.9f and %.9f", nu, speed, one, other);
    }
}

/* A compliance in the kicks removes the error of order h^2. From Omega h = 0.8 to 0.2 the result is the same, while
 * plain kicks would change it by 1e-4. true_depth corrects the largest depth in the same way. The modes have the energy
 * that the centre of mass loses. */
TEST(steps_and_energy)
{
    const double speed = 0.1, omega = 120;
    const struct cor_disk_modes modes = modes_of(0.33, omega);
    double l[3], depth[3];
    for (int i = 0; i < 3; i++) {
        struct cor_hard_wall_settings settings = fine_settings(omega, speed);
        settings.turn = ldexp(0.8, -i);
        const struct cor_hard_wall_result level = level_of(&modes, speed, &settings, COR_OK);
        check(fabs(level.energy_drift) < 2e-5 * settings.turn * settings.turn, "drift %g", level.energy_drift);
        l[i] = level.one_minus_eps2;
        depth[i] = level.max_compression;
    }
    check(fabs(l[0] - l[2]) < 1e-6 && fabs(l[1] - l[2]) < 2e-7, "%.9f %.9f %.9f", l[0], l[1], l[2]);
    check(fabs(depth[0] - depth[2]) < 3e-8 && fabs(depth[1] - depth[2]) < 3e-8, "%.10f %.10f %.10f", depth[0], depth[1],
          depth[2]);
}

/* With half of the work that it needs, counted in multiplications or in steps, a level stops within a few steps. From
 * level to level the work grows by at most 1.2 COR_HARD_WALL_GROWTH. */
TEST(budget)
{
    EACH (speeds, 0.3, 0.01, 1e-9) {
        const struct cor_disk_modes modes = modes_of(0.33, 120);
        struct cor_hard_wall_settings settings = fine_settings(60, *speeds);
        settings.point = *speeds < COR_DISK_HARD_WALL_POINT_SPEED;
        const double before = level_of(&modes, *speeds, &settings, COR_OK).work;
        settings = fine_settings(60 * sqrt(2), *speeds);
        settings.point = *speeds < COR_DISK_HARD_WALL_POINT_SPEED;
        struct cor_hard_wall_result whole = level_of(&modes, *speeds, &settings, COR_OK);
        assert_true(whole.work > 1.2 * before && whole.work < 1.2 * COR_HARD_WALL_GROWTH * before);
        for (int of_steps = 0; of_steps < 2; of_steps++) {
            settings.work_per_step = of_steps;
            whole = level_of(&modes, *speeds, &settings, COR_OK);
            settings.most_work = 0.5 * whole.work;
            const double half = level_of(&modes, *speeds, &settings, COR_TOLERANCE_NOT_REACHED).work / whole.work;
            check(half > 0.5 && half < 0.52, "%.4f of the work", half);
            assert_true(!of_steps || whole.work == (double)whole.steps);
            settings.most_work = 1.01 * whole.work;
            level_of(&modes, *speeds, &settings, COR_OK);
            settings.most_work = 0;
        }
    }
}

/* ---- a point ---- */

/* In their common range, a point contact and the full method have the same loss L at each Omega. */
TEST(point_contact)
{
    static const double speeds[] = {1e-4, 1e-5, 1e-6, 1e-7};
    for (size_t i = 0; i < 4; i++) {
        const double omega = 60;
        const struct cor_disk_modes modes = modes_of(0.33, omega);
        struct cor_hard_wall_settings settings = fine_settings(omega, speeds[i]);
        settings.turn = 0.4;
        settings.spacing = 1.1 * sqrt(speeds[i]) / 120;
        const struct cor_hard_wall_result full = level_of(&modes, speeds[i], &settings, COR_OK);
        settings.point = 1;
        const struct cor_hard_wall_result point = level_of(&modes, speeds[i], &settings, COR_OK);
        check(fabs(full.one_minus_eps2 - point.one_minus_eps2) < (i == 0 ? 3e-7 : 6e-8), "v = %g: %.9f and %.9f",
              speeds[i], full.one_minus_eps2, point.one_minus_eps2);
        check(fabs(full.max_compression / point.max_compression - 1) < 1e-4, "v = %g: %g and %g", speeds[i],
              full.max_compression, point.max_compression);
    }
}

/* Angles are never so coarse that they alias cosines of the rim's series. The series ends at the largest n, rounded up
 * to whole blocks of lanes. */
TEST(coarse_angles)
{
    const double speed = 0.1, omega = 20;
    const struct cor_disk_modes modes = modes_of(0.33, omega);
    int n_max = 0;
    for (size_t i = 0; i + 1 < modes.count; i++)
        n_max = modes.mode[i].n > n_max ? modes.mode[i].n : n_max;
    const int lanes = (n_max / COR_LANES + 1) * COR_LANES;
    struct cor_hard_wall_settings settings = fine_settings(omega, speed);
    settings.spacing = 1;
    const double coarse = level_of(&modes, speed, &settings, COR_OK).one_minus_eps2;
    settings.spacing = pi / (lanes + 2) * (1 + 1e-12);
    const double least = level_of(&modes, speed, &settings, COR_OK).one_minus_eps2;
    check(same_bits(coarse, least), "%.17g with the spacing 1, %.17g with pi/%d", coarse, least, lanes + 2);
}

/* Sums of cosines by Clenshaw's recurrence and in parts agree with cosines of the C library. */
TEST(cosines)
{
    enum { Q = COR_HARD_WALL_PANEL, M = 5, N = M * Q / 2, POINTS = 3 * Q };
    static double part[(Q / 2 + 1) * 2 * Q], turn[M * 2 * Q], whole[2 * M], sums[M * 2 * Q], twice_cosine[POINTS];
    for (int i = 0; i < POINTS; i++)
        twice_cosine[i] = 2 * cos(i * pi / N);
    for (int i = 0; i < (int)(sizeof part / sizeof *part); i++)
        part[i] = cos(2 * pi * (i / (2 * Q)) * (i % Q) / Q - (i / Q % 2) * pi / 2);
    for (int i = 0; i < (int)(sizeof turn / sizeof *turn); i++)
        turn[i] = cos(i / (2 * Q) * (i % Q) * pi / N - (i / Q % 2) * pi / 2);
    for (int i = 0; i < 2 * M; i++)
        whole[i] = cos(2 * pi * (i / 2) / M - (i % 2) * pi / 2);
    const struct cor_hard_wall_angles angles = {twice_cosine, M, part, turn, whole, sums};
    static const size_t counts[] = {1, 2, 3, 2 * M, 2 * M + 1, 3 * M, 77, N + 1};
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
        double factor[N + 1], result[POINTS], size = 0;
        for (size_t k = 0; k < counts[c]; k++)
            size += fabs(factor[k] = random_uniform(&draw, -1, 1));
        cor_hard_wall_set(cor_widest_set())->cosines(&angles, counts[c], factor, POINTS, result);
        for (size_t i = 0; i < POINTS; i++) {
            double sum = 0;
            for (size_t k = 0; k < counts[c]; k++)
                sum += factor[k] * cos((double)(k * i % (2 * N)) * pi / N);
            check(fabs(result[i] - sum) < 1e-12 * size, "%zu cosines, angle %zu: %g, not %g", counts[c], i, result[i],
                  sum);
        }
    }
}

/* ---- instruction sets ---- */

/* All sets agree for a point, one piece and several, and for few and many modes. A sum of no cosines is 0. */
TEST(every_set)
{
    double factor = 7, twice_cosine[COR_HARD_WALL_PANEL] = {0}, none[COR_HARD_WALL_PANEL];
    const struct cor_hard_wall_angles angles = {.twice_cosine = twice_cosine};
    cor_hard_wall_portable.cosines(&angles, 0, &factor, COR_HARD_WALL_PANEL, none);
    assert_memory_equal(none, twice_cosine, sizeof none);
    for (size_t i = 0; i < points(8); i++) {
        const double speed = i % 4 == 0 ? 0.25 : random_log(&draw, i % 4 == 1 ? 1e-9 : 1e-3, 0.4);
        const double omega = i % 4 == 0 ? 60 : random_uniform(&draw, 5, 60);
        const struct cor_disk_modes modes = modes_of(i % 4 == 0 ? 0.9 : random_uniform(&draw, -0.5, 0.95), omega);
        struct cor_hard_wall_settings settings = fine_settings(omega, speed);
        settings.point = speed < COR_DISK_HARD_WALL_POINT_SPEED;
        settings.loops = cor_hard_wall_set(COR_PORTABLE);
        const struct cor_hard_wall_result portable = level_of(&modes, speed, &settings, COR_OK);
        for (int set = 1; set < COR_INSTRUCTION_SETS; set++) {
            settings.loops = cor_hard_wall_set(set);
            const struct cor_hard_wall_result result = level_of(&modes, speed, &settings, COR_OK);
            check(memcmp(&result, &portable, sizeof result) == 0, "set %d, v = %g: %a, not %a", set, speed,
                  result.one_minus_eps2, portable.one_minus_eps2);
        }
    }
}

TEST(modes_of_every_set)
{
    for (size_t draws = 0; draws < points(8); draws++) {
        const double e = random_log(&draw, 1e-9, 2), omega = random_log(&draw, 1, 150);
        const struct cor_mode_material material = {e, 2 - e};
        struct cor_disk_mode *portable, *found;
        size_t count, other;
        assert_int_equal(cor_mode_find(&material, cor_mode_set(COR_PORTABLE), omega, &portable, &count), COR_OK);
        for (int set = 1; set < COR_INSTRUCTION_SETS; set++) {
            if (!cor_mode_set(set))
                continue;
            assert_int_equal(cor_mode_find(&material, cor_mode_set(set), omega, &found, &other), COR_OK);
            check(other == count && memcmp(found, portable, count * sizeof *found) == 0,
                  "set %d, e = %.17g, omega = %g", set, e, omega);
            free(found);
        }
        free(portable);
    }
}

/* ---- hard inputs ---- */

/* The functions report a contact that outgrows its range, and modes that no disk has. */
TEST(refusals)
{
    struct cor_disk_modes modes = modes_of(0.33, 30);
    struct cor_hard_wall_settings settings = fine_settings(30, 0.1);
    settings.range = 0.3;
    level_of(&modes, 0.1, &settings, COR_ERROR_WORKSPACE);
    settings = fine_settings(30, 0.1);
    for (size_t i = 0; i < modes.count; i++)
        mode[i].c *= 1.5;
    level_of(&modes, 0.1, &settings, COR_ERROR_MODES);
}
