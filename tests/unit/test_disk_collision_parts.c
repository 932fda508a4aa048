/* SPDX-License-Identifier: MIT */
/* Tests the parts of a collision one by one: a drift, a kick against the gradient of its potential, the window of
 * angles. Tests the extrapolation of artificial series, and the error estimate for artificial changes from run to
 * run. */
#include "check.h"

#include <cor/disk.h>

#include "runtime/disk/collision_parts.h"

/* A disk of nu = 0.33 in a workspace that the next stage_begin() frees */
struct stage {
    struct cor_motion m;
    struct cor_collision_state now;
};

static void stage_begin(struct stage *stage, size_t n, double alpha, double speed, size_t phi, double h)
{
    const struct cor_disk_collision_options options = {alpha, 1e-8, phi, 0};
    static void *memory;
    memset(stage, 0, sizeof *stage);
    struct cor_motion *const m = &stage->m;
    m->size = cor_motion_sizes(cor_disk_modes_nu033.mode, n, &options);
    const size_t bytes = cor_motion_arrange(m, NULL);
    free(memory);
    memory = malloc(bytes + COR_ALIGNMENT);
    assert_non_null(memory);
    cor_motion_arrange(m, cor_store_aligned(memory));
    m->mode = cor_disk_modes_nu033.mode;
    m->alpha = alpha;
    m->tolerance = options.tolerance;
    m->speed = speed;
    m->work_left = INFINITY;
    m->loops = &cor_collision_portable;
    m->phi_limit = phi;
    cor_motion_set_modes(m);
    cor_motion_set_angles(m, phi, 0);
    cor_collision_approach(m, h, &stage->now);
}

/* ---- drift ---- */

TEST(drift)
{
    enum { MODES = 9 };
    struct stage stage;
    const double h = 0.37;
    stage_begin(&stage, MODES, 500, 0.1, 64, h);
    struct cor_motion *const m = &stage.m;
    double q[MODES], p[MODES];
    COR_CLEAR_DOUBLES(m->size.blocks * COR_LANES, m->force_c, m->force_s);
    for (size_t i = 0; i < MODES; i++) {
        m->q[m->place[i]] = q[i] = random_uniform(&draw, -1, 1);
        m->p[m->place[i]] = p[i] = random_uniform(&draw, -1, 1);
    }
    const struct cor_collision_state before = stage.now;
    cor_collision_drift(m, h, &stage.now);
    assert_true(stage.now.time == before.time + h && stage.now.depth == before.depth + h * before.v);
    for (size_t i = 0; i < MODES; i++) {
        const long double angle = (long double)m->mode[i].omega * h;
        const long double turned_q = cosl(angle) * q[i] + sinl(angle) * p[i],
                          turned_p = cosl(angle) * p[i] - sinl(angle) * q[i];
        check(fabsl(m->q[m->place[i]] - turned_q) < 4e-16L && fabsl(m->p[m->place[i]] - turned_p) < 4e-16L, "mode %zu",
              i);
    }
}

/* ---- kick ---- */

enum { MODES = 34 }; /* the largest number of modes; their n, at most 13, fill one or two blocks of lanes */

/* The modified potential (15.1), U = V - (h^2/24) |grad V|^2/m, where V = (1/alpha) int exp(alpha x(phi)) dphi by phi
 * angles. Central differences give its gradient. *fastest: the largest acceleration of the rim */
struct potential {
    size_t modes, phi;
    double alpha, h;
};

static long double rim(const struct potential *p, size_t j, const long double *y, long double along[1 + MODES])
{
    const long double pi = 3.14159265358979323846264338L, angle = pi * (long double)j / (2 * (long double)p->phi);
    long double x = y[0] - 1 + cosl(angle);
    along[0] = 1;
    for (size_t i = 0; i < p->modes; i++) {
        const struct cor_disk_mode *const mode = &cor_disk_modes_nu033.mode[i];
        along[1 + i] = mode->c * cosl(mode->n * angle) * cosl(angle) - mode->s * sinl(mode->n * angle) * sinl(angle);
        x += y[1 + i] * along[1 + i];
    }
    return x;
}

static long double modified_potential(const struct potential *p, const long double *y, long double *fastest)
{
    const long double pi = 3.14159265358979323846264338L;
    long double v = 0, gradient[1 + MODES] = {0}, square = 0, along[1 + MODES];
    for (size_t j = 0; j < p->phi; j++) {
        const long double weight = pi / (long double)p->phi / (j == 0 ? 2 : 1);
        const long double pressure = weight * expl(p->alpha * rim(p, j, y, along));
        v += pressure / p->alpha;
        for (size_t i = 0; i <= p->modes; i++)
            gradient[i] += pressure * along[i];
    }
    for (size_t i = 0; i <= p->modes; i++)
        square += gradient[i] * gradient[i];
    for (size_t j = 0; fastest && j < p->phi; j++) {
        long double acceleration = 0;
        rim(p, j, y, along);
        for (size_t i = 0; i <= p->modes; i++)
            acceleration += along[i] * gradient[i] / pi;
        *fastest = fmaxl(*fastest, acceleration);
    }
    return v - (long double)p->h * p->h / 24 * square / pi;
}

/* A kick changes v by -h/m times the gradient, and p of the modes by -h/sqrt(m omega) times the gradient. */
TEST(kick)
{
    for (size_t k = 0; k < points(20); k++) {
        const struct potential p = {1 + random_below(&draw, MODES), 48, random_log(&draw, 50, 500),
                                    random_log(&draw, 0.001, 0.02)};
        const double mass = COR_PI;
        struct stage stage;
        stage_begin(&stage, p.modes, p.alpha, 0.1, p.phi, p.h);
        struct cor_motion *const m = &stage.m;
        long double y[1 + MODES];
        COR_CLEAR_DOUBLES(m->size.blocks * COR_LANES, m->force_c, m->force_s);
        for (size_t i = 0; i < p.modes; i++)
            m->q[m->place[i]] = random_uniform(&draw, -0.02, 0.02);
        COR_CLEAR_DOUBLES(m->size.cells, m->p);
        stage.now.depth = random_uniform(&draw, -1, 0.5) / p.alpha;
        stage.now.v = 0;
        cor_collision_drift(m, 0, &stage.now); /* turns each mode by omega h, and sums the modes */
        y[0] = stage.now.depth;
        for (size_t i = 0; i < p.modes; i++)
            y[1 + i] = m->q[m->place[i]] / sqrtl(mass * (long double)m->mode[i].omega);
        if (cor_collision_kick(m, p.h, COR_ALL_ANGLES, &stage.now) != COR_RUN_ENDED)
            continue; /* too stiff */
        for (size_t i = 0; i <= p.modes; i++) {
            const long double step = 1e-6L / p.alpha, at = y[i];
            y[i] = at + step;
            const long double above = modified_potential(&p, y, NULL);
            y[i] = at - step;
            const long double gradient = (above - modified_potential(&p, y, NULL)) / (2 * step);
            y[i] = at;
            const size_t n = i > 0 ? (size_t)m->mode[i - 1].n : 0, cell = i > 0 ? m->place[i - 1] : 0;
            const double kicked =
                i == 0 ? stage.now.v * mass
                       : (m->c[cell] * m->force_c[n] + m->s[cell] * m->force_s[n]) * sqrt(mass * m->mode[i - 1].omega);
            check(fabsl(kicked + p.h * gradient) <= 1e-9L * p.h * stage.now.load, "coordinate %zu: %g, not %Lg", i,
                  kicked, -p.h * gradient);
        }
        assert_true(stage.now.force > 0 && stage.now.force < stage.now.load);
        long double fastest = 0;
        modified_potential(&p, y, &fastest);
        check(relative_error(stage.now.stiffness, p.h * p.h * p.alpha * fastest) < 1e-9, "stiffness %g, not %Lg",
              stage.now.stiffness, p.h * p.h * p.alpha * fastest);
    }
}

/* The stiffness h^2 alpha a may be at most 3, and grows with the square of the step. */
TEST(stiffness)
{
    static const struct {
        double stiffness;
        enum cor_collision_outcome kick;
    } step[] = {{0.01, COR_RUN_ENDED}, {2.99, COR_RUN_ENDED}, {3.01, COR_RUN_TOO_STIFF}, {7, COR_RUN_TOO_STIFF}};
    double square = 1e-6, found = 0;
    for (size_t i = 0; i < sizeof step / sizeof *step; i++) {
        struct stage stage;
        const double h = i == 0 ? sqrt(square) : sqrt(square * step[i].stiffness / found);
        stage_begin(&stage, 5, 500, 0.1, 96, h);
        cor_collision_drift(&stage.m, h, &stage.now);
        stage.now.depth = 0.001;
        const enum cor_collision_outcome result = cor_collision_kick(&stage.m, h, COR_ALL_ANGLES, &stage.now);
        if (i == 0)
            found = stage.now.stiffness;
        else
            check(fabs(stage.now.stiffness / step[i].stiffness - 1) < 1e-6, "%g, not %g", stage.now.stiffness,
                  step[i].stiffness);
        check(result == step[i].kick, "stiffness %g: %d", stage.now.stiffness, (int)result);
    }
}

/* A scan reports an angle outside the window whose pressure exceeds 1e-14 of the load, unless the load is 0. */
TEST(window)
{
    enum { PHI = 256 };
    static const struct {
        double alpha, depth;
        enum cor_collision_angles angles;
        enum cor_collision_outcome kick;
    } scan[] = {
        {1400, 0, COR_SCAN, COR_RUN_TOO_NARROW}, {1400, 0, COR_ALL_ANGLES, COR_RUN_ENDED},
        {1400, 0, COR_WINDOW, COR_RUN_ENDED},    {1800, 0, COR_SCAN, COR_RUN_ENDED},
        {1400, -0.2, COR_SCAN, COR_RUN_ENDED},   {1300, 0.001, COR_SCAN, COR_RUN_TOO_NARROW},
    };
    for (size_t i = 0; i < sizeof scan / sizeof *scan; i++) {
        struct stage stage;
        const double h = 1e-4;
        stage_begin(&stage, 3, scan[i].alpha, 0.1, PHI, h);
        COR_CLEAR_DOUBLES(stage.m.size.cells, stage.m.q, stage.m.p);
        COR_CLEAR_DOUBLES(stage.m.size.blocks * COR_LANES, stage.m.sum_c, stage.m.sum_s);
        stage.now.depth = scan[i].depth;
        stage.now.window = COR_PANEL;
        const enum cor_collision_outcome result = cor_collision_kick(&stage.m, h, scan[i].angles, &stage.now);
        check(result == scan[i].kick, "scan %zu: %d", i, (int)result);
        /* the next window ends where the pressure is below 1e-26 of the peak, which is at angle 0 */
        if (scan[i].angles != COR_WINDOW && result == COR_RUN_ENDED) {
            size_t last = 0;
            for (size_t j = 0; j < PHI; j++)
                if (stage.m.shape[j] * scan[i].alpha > log(1e-26) - log(2))
                    last = j;
            check(stage.now.window == (last / COR_PANEL + 1) * COR_PANEL, "window %zu, last %zu", stage.now.window,
                  last);
        }
    }
}

/* ---- extrapolation ---- */

/* Series in h^4, h^6, ... and h^2, h^4, ... are extrapolated exactly if they have fewer terms than runs. */
TEST(extrapolation)
{
    enum { LEVELS = COR_COLLISION_LEVELS };
    for (int levels = 2; levels <= LEVELS; levels++) {
        struct cor_motion m = {.size.modes = 2};
        struct cor_collision_run run[LEVELS] = {{0}};
        double after[LEVELS][2], average[LEVELS][2], c[4][LEVELS], limit[2] = {0.3, 0.01}, found[2], mean[2];
        for (int i = 0; i < 4; i++)
            for (int k = 0; k < LEVELS; k++)
                c[i][k] = random_uniform(&draw, -0.1, 0.1);
        for (int k = 0; k < levels; k++) {
            const double h = ldexp(1, -k / 2) * (k % 2 ? sqrt(0.5) : 1);
            run[k].number = k + 2;
            run[k].eps = 0.9;
            after[k][0] = limit[0];
            after[k][1] = limit[1];
            average[k][0] = average[k][1] = 0.2;
            for (int j = 0; j < levels - 1; j++) {
                run[k].eps += c[0][j] * pow(h, 4 + 2 * j);
                after[k][0] += c[1][j] * pow(h, 4 + 2 * j);
                after[k][1] += 0.01 * c[2][j] * pow(h, 4 + 2 * j);
                average[k][0] += c[3][j] * pow(h, 2 + 2 * j);
            }
            m.after[k] = after[k];
            m.average[k] = average[k];
        }
        struct cor_disk_collision out = {0, 0, 0, 0, 0, 0, 0.125};
        assert_true(cor_collision_results(&m, run, levels, &out, found) == 0);
        cor_collision_averages(&m, run, levels, mean);
        check(fabs(out.eps - 0.9) < 1e-14 && fabs(found[0] - limit[0]) < 1e-14 && fabs(found[1] - limit[1]) < 1e-15,
              "%d runs: %.16f, %.16f, %.16f", levels, out.eps, found[0], found[1]);
        check(fabs(mean[0] - 0.2) < 1e-14 && fabs(mean[1] - 0.2) < 1e-14, "%d runs: %.16f", levels, mean[0]);
        assert_true(out.error_estimate == 0.125);
        /* the change of the result by the last run */
        struct cor_disk_collision less = out;
        double found_before[2];
        cor_collision_results(&m, run, levels - 1, &less, found_before);
        const double norm = 0.5 * hypot(found[0] - found_before[0], found[1] - found_before[1]);
        const double moved = fabs(out.eps - less.eps);
        check(fabs(cor_collision_movement(&m, run, levels) - fmax(moved, norm)) < 1e-15, "%d runs: moved by %g and %g",
              levels, moved, norm);
        const double raw =
            0.5 * hypot(after[levels - 1][0] - after[levels - 2][0], after[levels - 1][1] - after[levels - 2][1]);
        assert_true(fabs(cor_collision_difference(&m, run, levels) -
                         fmax(raw, fabs(run[levels - 1].eps - run[levels - 2].eps))) < 1e-15);
    }
}

TEST(energies)
{
    double after[2][2] = {{0.2, 0.04}, {0.21, 0.03}}, found[2];
    const struct cor_motion m = {.size.modes = 2, .after = {after[0], after[1]}};
    struct cor_collision_run run[2] = {{.number = 1, .eps = 0.8}, {.eps = 0.8}};
    struct cor_disk_collision out = {0};
    /* the movement is 4/3 of the difference of the energies, even if eps does not change */
    assert_true(fabs(cor_collision_movement(&m, run, 2) - 0.5 * 4 / 3 * 0.01 * sqrt(2)) < 1e-15);
    /* the weights 4/3 and -1/3 give a negative energy, which counts as 0; the result states how negative it is */
    after[1][0] = 0.25;
    after[1][1] = 0.0025;
    const double less = cor_collision_results(&m, run, 2, &out, found);
    assert_true(fabs(less - 0.01) < 1e-16 && found[1] == 0 && fabs(found[0] - 0.8 / 3) < 1e-15);
    assert_true(out.one_minus_eps2 == found[0]);
    /* run 0 cannot contain the load that defines the contact, so its contact time is NaN */
    assert_true(!isnan(out.contact_time));
    run[0].number = 0;
    cor_collision_results(&m, run, 1, &out, NULL);
    assert_true(isnan(out.contact_time));
}

/* ---- the error of the step ---- */

/* Sets movements of runs that converge like ratio^k. Returns the remaining error. */
static double remainder_of(struct cor_collision_evidence *evidence, int runs, double first, double ratio)
{
    memset(evidence, 0, sizeof *evidence);
    evidence->runs = runs;
    for (int i = 1; i < runs; i++)
        evidence->movement[i] = first * pow(ratio, i - 1);
    return first * pow(ratio, runs - 1) / (1 - ratio);
}

TEST(step_error)
{
    struct cor_collision_evidence evidence;
    const struct cor_motion soft = {.alpha = 23.9, .speed = 1};
    remainder_of(&evidence, 1, 0, 0.1);
    assert_true(cor_collision_step_error(&soft, &evidence, 0) == 1);
    for (int runs = 2; runs <= 8; runs++)
        for (double ratio = 0.01; ratio < 0.8; ratio += 0.02) {
            const double left = remainder_of(&evidence, runs, 1e-3, ratio);
            const double error = cor_collision_step_error(&soft, &evidence, 0), last = evidence.movement[runs - 1];
            /* two runs show no ratio, so the error assumes a ratio up to 2/3 */
            if (runs > 2 || ratio < 0.6)
                check(error >= left * (1 - 1e-12), "%d runs, ratio %g: %g, not %g", runs, ratio, error, left);
            /* however fast the runs converge, the error is at least this multiple of the last movement */
            check(error >= (runs == 2   ? 1.9
                            : runs == 3 ? 0.6
                                        : 0.33) *
                               last,
                  "%d runs, ratio %g: %g", runs, ratio, error);
            /* a ratio above one half does not count as convergence */
            if (runs > 2 && ratio > 0.5)
                assert_true(error >= 3.9 * evidence.movement[runs - 2]);
        }
    /* a single movement that is small by chance has little effect */
    remainder_of(&evidence, 6, 1e-3, 0.1);
    evidence.movement[5] = 1e-15;
    assert_true(cor_collision_step_error(&soft, &evidence, 0) > 3e-10);
    /* slow convergence of earlier runs also raises the error */
    remainder_of(&evidence, 5, 1e-3, 0.4);
    evidence.movement[4] = 0.1 * evidence.movement[3];
    assert_true(cor_collision_step_error(&soft, &evidence, 0) > 0.6 * evidence.movement[4]);
}

/* At a hard wall, which begins at alpha v = 24, movements that are small by chance have less effect. */
TEST(hard_wall_step_error)
{
    struct cor_collision_evidence evidence;
    const struct cor_motion soft = {.alpha = nextafter(24, 0), .speed = 1}, hard = {.alpha = 24, .speed = 1};
    remainder_of(&evidence, 1, 0, 0.1);
    assert_true(cor_collision_step_error(&hard, &evidence, 0) == 1);
    remainder_of(&evidence, 2, 1e-3, 0.1);
    check(cor_collision_step_error(&hard, &evidence, 1e-3) == 20e-3, "%g",
          cor_collision_step_error(&hard, &evidence, 1e-3));
    for (int runs = 3; runs <= 8; runs++)
        for (double ratio = 0.01; ratio < 0.8; ratio += 0.02) {
            remainder_of(&evidence, runs, 1e-3, ratio);
            const double last = evidence.movement[runs - 1], before = evidence.movement[runs - 2];
            const double by_series = cor_collision_step_error(&soft, &evidence, 0);
            const double error = cor_collision_step_error(&hard, &evidence, 0);
            const double noisy = cor_collision_step_error(&hard, &evidence, 0.5 * last);
            const double least = fmax(by_series, 0.02 * before);
            check(fabs(error - fmax(least, 1.5 * last)) <= 1e-15 * error, "%d runs, ratio %g: %g", runs, ratio, error);
            check(fabs(noisy - fmax(least, 0.75 * last)) <= 1e-15 * noisy, "%d runs, ratio %g: %g", runs, ratio, noisy);
            /* if round-off exceeds the movement, the movement counts as 0, not as negative */
            assert_true(fabs(cor_collision_step_error(&hard, &evidence, 2 * last) - least) <= 1e-15 * least);
        }
}

/* ---- the other errors ---- */

TEST(other_errors)
{
    struct stage stage;
    stage_begin(&stage, 5, 500, 0.1, 96, 0.01);
    const struct cor_collision_evidence calm = {.amplification = 0.1}, wild = {.amplification = 1e6};
    const struct cor_collision_run run = {.steps = 1000, .max_load = 1, .ripple = 1e-6};
    struct cor_collision_error error, more;
    /* the round-off of 1000 steps is a random walk; the amplification 10^6 multiplies it */
    cor_collision_other_errors(&stage.m, &run, 0, &calm, &error);
    cor_collision_other_errors(&stage.m, &run, 0, &wild, &more);
    assert_true(error.round_off > sqrt(1000) * 0x1p-53 && error.round_off < 10 * sqrt(1000) * 0x1p-53);
    assert_true(more.round_off > 1e6 * sqrt(1000) * 0x1p-53 && more.round_off < 1e7 * sqrt(1000) * 0x1p-53);
    /* modes with a tenth of the energy add round-off, because their phases drift */
    const double walk = more.round_off;
    cor_collision_other_errors(&stage.m, &run, 0.1, &calm, &error);
    cor_collision_other_errors(&stage.m, &run, 0.1, &wild, &more);
    assert_true(error.round_off > 100 * 0x1p-53 && error.round_off < 1000 * 0x1p-53);
    assert_true(more.round_off - walk > 1e6 * 50 * 0x1p-53 && more.round_off - walk < 1e6 * 1000 * 0x1p-53);
    /* at both ends the energy of the wall is 1e-6 of the tolerance, 1e-14 of the energy of the disk */
    assert_true(error.wall > 2e-14 && error.wall < 1e-13 && more.wall > 1e6 * 2e-14 && more.wall < 1e6 * 1e-13);
    const struct cor_collision_error parts = {0.25, 0.125, 0.0625, 0.03125}, large = {0.75, 0, 0.5, 0};
    assert_true(cor_collision_lasting_error(&parts) == 0.09375 && cor_collision_total_error(&parts) == 0.46875);
    assert_true(cor_collision_lasting_error(&large) == 0.5 && cor_collision_total_error(&large) == 1);
}

/* The error of the angles is the error of the quadrature times an amplification. The amplification is measured, or is a
 * thousandth of its bound, but at least 0.1. A run with other angles can replace this error. */
TEST(angles_error)
{
    struct stage stage;
    stage_begin(&stage, 5, 500, 0.1, 96, 0.01);
    struct cor_collision_evidence evidence = {.amplification = 0.05};
    struct cor_collision_run run = {.max_load = 1, .ripple = 1e-6};
    struct cor_collision_error error;
    const double quadrature = cor_collision_quadrature_error(&stage.m, &run);
    assert_true(quadrature > 1e-12 && quadrature < 2e-12);
    static const double amplification[] = {0.05, 1e6};
    for (int measured = 0; measured < 2; measured++)
        for (size_t i = 0; i < 2; i++) {
            evidence.measured = measured;
            evidence.amplification = amplification[i];
            const double expected = i == 0 ? 0.1 : measured ? 1e6 : 1e3;
            cor_collision_other_errors(&stage.m, &run, 0.1, &evidence, &error);
            check(fabs(error.angles / quadrature - expected) <= 1e-14 * expected, "%g of %g", error.angles, quadrature);
            assert_true(cor_collision_total_error(&error) >= error.angles + error.round_off + error.wall);
        }
    evidence.by_angles = 1e-9;
    evidence.angles_measured = 1;
    cor_collision_other_errors(&stage.m, &run, 0.1, &evidence, &error);
    assert_true(fabs(error.angles - 3e-9) < 1e-20);
    evidence.angles_measured = 0;
    /* if the load changes by 100 % with half of the angles, the error is unknown */
    run.ripple = 1;
    cor_collision_other_errors(&stage.m, &run, 0.1, &evidence, &error);
    assert_true(error.angles == 1);
    run.ripple = 1e-6;
    stage.m.size.n_max = 4 * stage.m.phi;
    cor_collision_other_errors(&stage.m, &run, 0.1, &evidence, &error);
    assert_true(error.angles == 1);
}

/* The mean of the moments at PHI angles and at PHI shifted angles equals the moment at all 2 PHI angles. */
TEST(shifted_angles)
{
    enum { PHI = 19, TERMS = 8 };
    struct stage stage;
    double sum[TERMS] = {0};
    stage_begin(&stage, 9, 1000, 0.1, 2 * PHI, 0.01);
    struct cor_motion *const m = &stage.m;
    for (size_t shift = 0; shift < 2; shift++) {
        cor_motion_set_angles(m, PHI, shift);
        cor_collision_approach(m, 0.01, &stage.now);
        for (size_t k = 0; k < TERMS; k++)
            sum[k] += 0.5 * m->e[k];
    }
    cor_motion_set_angles(m, 2 * PHI, 0);
    cor_collision_approach(m, 0.01, &stage.now);
    for (size_t k = 0; k < TERMS; k++)
        check(fabs(sum[k] - m->e[k]) <= 1e-14 * m->e[0], "moment %zu: %.17g, not %.17g", k, sum[k], m->e[k]);
}

/* ---- the loops ---- */

/* Every instruction set gives the bits of the portable one in a collision of few or many modes, at any angles. */
TEST(every_set)
{
    for (size_t k = 0; k < points(24); k++) {
        const size_t n = 1 + random_below(&draw, k % 4 ? 40 : 400), phi = 40 + random_below(&draw, 200);
        const double alpha = random_log(&draw, 40, 2000), speed = random_uniform(&draw, 0.02, 0.3);
        struct cor_collision_run run[COR_INSTRUCTION_SETS] = {{0}};
        for (int set = 0; set < COR_INSTRUCTION_SETS; set++) {
            struct stage stage;
            if (cor_collision_set(set) == NULL)
                continue;
            run[set].h = 0.5 / fmax(alpha * speed, cor_disk_modes_nu033.mode[n - 1].omega);
            stage_begin(&stage, n, alpha, speed, phi, run[set].h);
            stage.m.loops = cor_collision_set(set);
            const enum cor_collision_outcome end = cor_collision_run(&stage.m, &run[set], NULL, NULL, NULL);
            check(end == COR_RUN_ENDED, "%zu modes, alpha = %g, v = %g: %d", n, alpha, speed, (int)end);
            check(memcmp(&run[set], &run[0], sizeof *run) == 0, "set %d, %zu modes: eps %a, not %a", set, n,
                  run[set].eps, run[0].eps);
        }
    }
}

/* The exponential at its limits and where its pieces meet. NaN stays NaN or becomes 0, never another number. */
TEST(exponential)
{
    static double reach[COR_PANEL], pressure[COR_PANEL], weight[COR_PANEL];
    for (size_t j = 0; j < COR_PANEL; j++)
        weight[j] = 1;
    const double ln2 = 0.69314718055994530942;
    const double x[] = {0, -0.0, 1,  -1, 0.5 * ln2, -0.5 * ln2, 1.5 * ln2, -1.5 * ln2, -699.99, nextafter(-700, 0),
                        5, 300,  690};
    enum { COUNT = sizeof x / sizeof *x };
    for (int i = 0; i < COR_INSTRUCTION_SETS; i++) {
        const struct cor_collision_loops *const loops = cor_collision_set(i);
        if (loops == NULL)
            continue;
        for (size_t j = 0; j < COR_PANEL; j++)
            reach[j] = x[j % COUNT];
        loops->press(COR_PANEL, 1, weight, reach, pressure);
        for (size_t j = 0; j < COR_PANEL; j++)
            check(relative_error(pressure[j], expl(reach[j])) <= 2 * DBL_EPSILON, "exp(%g) = %g", reach[j],
                  pressure[j]);
        const double none[] = {-700.0000001, -800, -1e10, -INFINITY, -1e300};
        for (size_t j = 0; j < COR_PANEL; j++)
            reach[j] = none[j % 5];
        assert_true(loops->press(COR_PANEL, 1, weight, reach, pressure) == 0);
    }
}

/* ---- the budget ---- */

TEST(work)
{
    struct stage stage;
    stage_begin(&stage, 5, 500, 0.1, 96, 0.01);
    struct cor_motion *const m = &stage.m;
    assert_true(cor_motion_work(m, 96, 96) > cor_motion_work(m, 96, 32) &&
                cor_motion_work(m, 96, 32) > cor_motion_work(m, 32, 32));
    struct cor_collision_run run = {.h = 0.01};
    for (int by_steps = 0; by_steps < 2; by_steps++) {
        m->work_per_step = by_steps;
        m->work_left = 1e9;
        assert_int_equal(cor_collision_run(m, &run, NULL, NULL, NULL), COR_RUN_ENDED);
        assert_true(run.work == 1e9 - m->work_left && run.work >= (double)run.steps);
        assert_true(!by_steps || run.work == (double)run.steps);
        const size_t steps = run.steps;
        m->work_left = run.work;
        assert_int_equal(cor_collision_run(m, &run, NULL, NULL, NULL), COR_RUN_ENDED);
        assert_true(run.steps == steps && m->work_left == 0);
        m->work_left = run.work / 2;
        assert_int_equal(cor_collision_run(m, &run, NULL, NULL, NULL), COR_RUN_TOO_LONG);
        assert_true(run.steps < steps && run.steps > steps / 4);
    }
}
