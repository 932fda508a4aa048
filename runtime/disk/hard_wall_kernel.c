/* SPDX-License-Identifier: MIT */
/* The loops of a disk at a rigid wall over modes, angles and rows of the compliance, for one instruction set
 * (sets.h). All sets give the same bits (kernel_vector.h). */
#include "runtime/disk/hard_wall_parts.h"
#include "runtime/number/kernel_vector.h"

/* Number of vectors that are summed at once: enough for independent additions, few enough for the registers */
enum { COLUMNS = 4 };

/* Makes one pass over the modes; `steps` is a constant. From q at two successive kicks and the forces of `steps` kicks
 * it computes q after these kicks. It then predicts the sums at the next `steps` kicks. */
COR_KERNEL void kernel_advance(const struct cor_hard_wall_modes *modes, size_t steps, const double *force_c,
                               const double *force_s, double *sum_c, double *sum_s)
{
    const size_t lanes = modes->blocks * COR_LANES;
    for (size_t b = 0; b < modes->blocks; b++) {
        const size_t first = modes->block[b].first * COR_LANES, end = first + modes->block[b].rows * COR_LANES;
        for (size_t lane = 0; lane < COR_LANES; lane += VECTOR) {
            const size_t n = b * COR_LANES + lane;
            vector of_c[COR_HARD_WALL_BATCH], of_s[COR_HARD_WALL_BATCH];
            for (size_t k = 0; k < steps; k++)
                of_c[k] = of_s[k] = fill_vector(0);
            for (size_t i = first + lane; i < end; i += COR_LANES) {
                const vector turn = load_vector(modes->turn + i), c = load_vector(modes->c + i),
                             s = load_vector(modes->s + i);
                vector q = load_vector(modes->q + i), before = load_vector(modes->before + i);
                for (size_t k = 0; k < steps; k++) {
                    const vector force =
                        c * load_vector(force_c + k * lanes + n) + s * load_vector(force_s + k * lanes + n);
                    const vector next = turn * q - before + force;
                    before = q;
                    q = next;
                }
                store_vector(modes->q + i, q);
                store_vector(modes->before + i, before);
                of_c[0] += c * q;
                of_s[0] += s * q;
                for (size_t k = 1; k < steps; k++) {
                    const vector next = turn * q - before;
                    before = q;
                    q = next;
                    of_c[k] += c * q;
                    of_s[k] += s * q;
                }
            }
            for (size_t k = 0; k < steps; k++) {
                store_vector(sum_c + k * lanes + n, of_c[k]);
                store_vector(sum_s + k * lanes + n, of_s[k]);
            }
        }
    }
}

/* Sums by Clenshaw's recurrence, b_k = factor_k + 2 cos(phi) b_(k+1) - b_(k+2), to factor_0 + cos(phi) b_1 - b_2. */
static void sum_clenshaw(size_t count, const double *factor, size_t points, const double *twice_cosine, double *result)
{
    for (size_t part = 0; part < points; part += COLUMNS * VECTOR) {
        vector x[COLUMNS], one[COLUMNS], two[COLUMNS]; /* b_(k+1), b_(k+2) */
        for (size_t i = 0; i < COLUMNS; i++) {
            x[i] = load_vector(twice_cosine + part + i * VECTOR);
            one[i] = two[i] = fill_vector(0);
        }
        size_t k = count;
        for (; k > 2; k -= 2) {
            const vector f = fill_vector(factor[k - 1]), g = fill_vector(factor[k - 2]);
            for (size_t i = 0; i < COLUMNS; i++)
                two[i] = f - two[i] + x[i] * one[i];
            for (size_t i = 0; i < COLUMNS; i++)
                one[i] = g - one[i] + x[i] * two[i];
        }
        if (k == 2)
            for (size_t i = 0; i < COLUMNS; i++) {
                const vector b = fill_vector(factor[1]) - two[i] + x[i] * one[i];
                two[i] = one[i];
                one[i] = b;
            }
        for (size_t i = 0; i < COLUMNS; i++)
            store_vector(result + part + i * VECTOR,
                         count == 0 ? fill_vector(0)
                                    : fill_vector(factor[0]) - two[i] + fill_vector(0.5) * x[i] * one[i]);
    }
}

/* Sums over b, then over a, as struct cor_hard_wall_angles describes. Processes COLUMNS vectors of r at a time, so that
 * their sums stay in the nearest cache. */
static void kernel_cosines(const struct cor_hard_wall_angles *angles, size_t count, const double *factor, size_t points,
                           double *result)
{
    enum { Q = COR_HARD_WALL_PANEL, WIDTH = COLUMNS * VECTOR };
    const size_t bins = angles->bins;
    if (!cor_hard_wall_sums_by_parts(angles, count)) {
        sum_clenshaw(count, factor, points, angles->twice_cosine, result);
        return;
    }
    for (size_t first = 0; first < Q; first += WIDTH) {
        for (size_t a = 0; a < bins; a++) {
            const double *const turn = angles->turn + 2 * Q * a + first, *part = angles->part + first;
            double *const sum = angles->sums + 2 * WIDTH * a;
            vector re[COLUMNS], im[COLUMNS];
            for (size_t i = 0; i < COLUMNS; i++)
                re[i] = im[i] = fill_vector(0);
            for (size_t k = a; k < count; k += bins, part += 2 * Q) {
                const vector f = fill_vector(factor[k]);
                for (size_t i = 0; i < COLUMNS; i++) {
                    re[i] += f * load_vector(part + i * VECTOR);
                    im[i] += f * load_vector(part + Q + i * VECTOR);
                }
            }
            for (size_t i = 0; i < COLUMNS; i++) {
                const vector c = load_vector(turn + i * VECTOR), s = load_vector(turn + Q + i * VECTOR);
                store_vector(sum + i * VECTOR, c * re[i] - s * im[i]);
                store_vector(sum + WIDTH + i * VECTOR, s * re[i] + c * im[i]);
            }
        }
        for (size_t s = 0; s < points / Q; s++) {
            const double *sum = angles->sums;
            vector total[COLUMNS];
            for (size_t i = 0; i < COLUMNS; i++)
                total[i] = fill_vector(0);
            for (size_t a = 0, x = 0; a < bins; a++, sum += 2 * WIDTH) {
                const vector c = fill_vector(angles->whole[2 * x]), d = fill_vector(angles->whole[2 * x + 1]);
                for (size_t i = 0; i < COLUMNS; i++)
                    total[i] += c * load_vector(sum + i * VECTOR) - d * load_vector(sum + WIDTH + i * VECTOR);
                x = x + s < bins ? x + s : (x + s) % bins;
            }
            for (size_t i = 0; i < COLUMNS; i++)
                store_vector(result + s * Q + first + i * VECTOR, total[i]);
        }
    }
}

enum { DOT_PARTS = 4 * COR_LANES / VECTOR };

static double kernel_dot(size_t n, const double *x, const double *y)
{
    vector sum[DOT_PARTS];
    double part[4 * COR_LANES];
    for (size_t i = 0; i < DOT_PARTS; i++)
        sum[i] = fill_vector(0);
    size_t at = 0;
    for (; at + 4 * COR_LANES <= n; at += 4 * COR_LANES)
        for (size_t i = 0; i < DOT_PARTS; i++)
            sum[i] += load_vector(x + at + i * VECTOR) * load_vector(y + at + i * VECTOR);
    for (size_t i = 0; at < n; at += VECTOR, i++)
        sum[i] += load_vector(x + at) * load_vector(y + at);
    for (size_t i = 0; i < DOT_PARTS; i++)
        store_vector(part + i * VECTOR, sum[i]);
    for (size_t i = 0; i < COR_LANES; i++)
        part[i] = (part[i] + part[i + 2 * COR_LANES]) + (part[i + COR_LANES] + part[i + 3 * COR_LANES]);
    return sum_of_lanes(part);
}

static void kernel_subtract(size_t n, double factor, const double *x, double *y)
{
    const vector f = fill_vector(factor);
    for (size_t i = 0; i < n; i += VECTOR)
        store_vector(y + i, load_vector(y + i) - f * load_vector(x + i));
}

static void advance_modes(const struct cor_hard_wall_modes *modes, size_t steps, const double *force_c,
                          const double *force_s, double *sum_c, double *sum_s)
{
    if (steps == COR_HARD_WALL_BATCH)
        kernel_advance(modes, COR_HARD_WALL_BATCH, force_c, force_s, sum_c, sum_s);
    else
        kernel_advance(modes, 1, force_c, force_s, sum_c, sum_s);
}

const struct cor_hard_wall_loops COR_OF_SET(cor_hard_wall) = {advance_modes, kernel_cosines, kernel_dot,
                                                              kernel_subtract};
