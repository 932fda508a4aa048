/* SPDX-License-Identifier: MIT */
/* The loops of a collision over modes and over the rim, for one instruction set (sets.h). All
 * sets give the same bits (kernel_vector.h). */
#include <math.h>

#include "runtime/disk/collision_parts.h"
#include "runtime/number/elementary.h"
#include "runtime/number/kernel_vector.h"

/* Number of vectors that accumulate a sum: enough for independent additions, few enough for the registers */
enum { ACCUMULATORS = VECTOR == 8 ? 4 : 8 };

static void kernel_turn(const struct cor_rim *rim, double *q, double *p, const double *cosine, const double *sine,
                        const double *force_c, const double *force_s, double *sum_c, double *sum_s)
{
    for (size_t b = 0; b < rim->blocks; b++) {
        const size_t first = rim->block[b].first * COR_LANES, end = first + rim->block[b].rows * COR_LANES;
        for (size_t lane = 0; lane < COR_LANES; lane += VECTOR) {
            const size_t n = b * COR_LANES + lane;
            const vector fc = load_vector(force_c + n), fs = load_vector(force_s + n);
            vector sc = fill_vector(0), ss = sc;
            for (size_t i = first + lane; i < end; i += COR_LANES) {
                const vector c = load_vector(rim->c + i), s = load_vector(rim->s + i), cos_i = load_vector(cosine + i),
                             sin_i = load_vector(sine + i), q_i = load_vector(q + i);
                const vector p_i = load_vector(p + i) + (c * fc + s * fs);
                const vector q_new = cos_i * q_i + sin_i * p_i;
                store_vector(p + i, cos_i * p_i - sin_i * q_i);
                store_vector(q + i, q_new);
                sc += c * q_new;
                ss += s * q_new;
            }
            store_vector(sum_c + n, sc);
            store_vector(sum_s + n, ss);
        }
    }
}

/* Sets result[i] = offset + shape[i] + sum_k factor[k] table[k][i], i < COR_PANEL, k < count */
COR_KERNEL void kernel_sum(size_t count, double offset, const double *shape, const double *factor, const double *table,
                           double *result)
{
    for (size_t part = 0; part < COR_PANEL; part += ACCUMULATORS * VECTOR) {
        vector sum[ACCUMULATORS];
        for (size_t i = 0; i < ACCUMULATORS; i++)
            sum[i] = fill_vector(offset) + load_vector(shape + part + i * VECTOR);
        const double *row = table + part;
        for (size_t k = 0; k < count; k++, row += COR_PANEL) {
            const vector f = fill_vector(factor[k]);
            for (size_t i = 0; i < ACCUMULATORS; i++)
                sum[i] += f * load_vector(row + i * VECTOR);
        }
        for (size_t i = 0; i < ACCUMULATORS; i++)
            store_vector(result + part + i * VECTOR, sum[i]);
    }
}

static void kernel_reach(const struct cor_rim *rim, size_t points, double offset, const double *shape, const double *d,
                         double *reach)
{
    for (size_t j = 0; j < points; j += COR_PANEL)
        kernel_sum(rim->used_terms, offset, shape + j, d, rim->by_point + j * rim->terms, reach + j);
}

static void kernel_transform(const struct cor_rim *rim, size_t points, const double *pressure, double *e)
{
    static const double nothing[COR_PANEL] = {0};
    for (size_t k = 0; k < rim->terms; k += COR_PANEL)
        kernel_sum(points, 0, nothing, pressure, rim->by_term + k * rim->points, e + k);
}

/* Returns exp(x); 0 for x <= -700, infinity for x >= 700. */
COR_KERNEL double kernel_push(double x)
{
    const double e = cor_kernel_exp(x > -700 ? x < 700 ? x : 700 : -700);
    return x < 700 ? x > -700 ? e : 0 : (double)INFINITY;
}

static double kernel_press(size_t points, double alpha, const double *weight, const double *reach, double *pressure)
{
    double sum[COR_LANES] = {0};
    for (size_t j = 0; j < points; j++)
        pressure[j] = weight[j] * kernel_push(alpha * reach[j]);
    for (size_t j = 0; j < points; j += COR_LANES)
        for (size_t i = 0; i < COR_LANES; i++)
            sum[i] += pressure[j + i];
    return sum_of_lanes(sum);
}

static double kernel_soften(size_t points, double factor, const double *response, double *pressure, double *greatest)
{
    double sum[COR_LANES] = {0}, most[COR_LANES] = {0};
    for (size_t j = 0; j < points; j += COR_LANES)
        for (size_t i = 0; i < COR_LANES; i++) {
            const double r = response[j + i], softened = pressure[j + i] - factor * r * pressure[j + i];
            pressure[j + i] = softened;
            sum[i] += softened;
            most[i] = most[i] > r ? most[i] : r;
        }
    for (size_t i = 1; i < COR_LANES; i++)
        most[0] = most[0] > most[i] ? most[0] : most[i];
    *greatest = most[0];
    return sum_of_lanes(sum);
}

static void kernel_gather(const struct cor_rim *rim, const double *sum_c, const double *sum_s, double *d)
{
    const size_t lanes = rim->blocks * COR_LANES;
    for (size_t k = lanes + 2; k < rim->terms; k++)
        d[k] = 0;
    d[0] = 0.5 * (sum_c[1] - sum_s[1]);
    d[1] = sum_c[0] + 0.5 * (sum_c[2] - sum_s[2]);
    for (size_t k = 2; k < lanes - 1; k++)
        d[k] = 0.5 * ((sum_c[k - 1] + sum_s[k - 1]) + (sum_c[k + 1] - sum_s[k + 1]));
    for (size_t k = lanes - 1; k < lanes + 1; k++)
        d[k] = 0.5 * (sum_c[k - 1] + sum_s[k - 1]);
    d[lanes + 1] = 0;
}

static void kernel_split(const struct cor_rim *rim, double factor, const double *e, double *force_c, double *force_s)
{
    const size_t lanes = rim->blocks * COR_LANES;
    const double half = 0.5 * factor;
    force_c[0] = factor * e[1];
    force_s[0] = 0;
    for (size_t n = 1; n < lanes; n++) {
        force_c[n] = half * (e[n + 1] + e[n - 1]);
        force_s[n] = half * (e[n + 1] - e[n - 1]);
    }
}

const struct cor_collision_loops COR_OF_SET(cor_collision) = {
    kernel_turn, kernel_gather, kernel_split, kernel_reach, kernel_press, kernel_transform, kernel_soften};
