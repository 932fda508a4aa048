/* SPDX-License-Identifier: MIT */
/* Recurrences of Bessel functions for one instruction set (sets.h). All sets give the same bits
 * (kernel_vector.h). */
#include <math.h>
#include <stdint.h>

#include "runtime/disk/mode_source.h"
#include "runtime/number/kernel_vector.h"

#ifdef __GNUC__
typedef __typeof__(fill_vector(0) < fill_vector(1)) changes; /* -1 for true */
#else
typedef int64_t changes; /* 1 for true */
#endif

/* Computes J_m(kappa) up to a factor by J_(m-1) = (2m/kappa) J_m - J_(m+1), from `start` down to `end`, and counts the
 * changes of sign. The values grow by a factor of at most 2^64 before they oscillate, so they cannot overflow. */
static void kernel_recurrence(const double *two_over_kappa, const double *first_quotient, long start, long end,
                              double *quotient, double *zeros)
{
    enum { VECTORS = COR_MODE_LANES / VECTOR };
    vector step[VECTORS], above[VECTORS], here[VECTORS];
    changes count[VECTORS];
    memset(count, 0, sizeof count);
    for (size_t i = 0; i < VECTORS; i++) {
        step[i] = load_vector(two_over_kappa + i * VECTOR);
        above[i] = load_vector(first_quotient + i * VECTOR);
        here[i] = fill_vector(1);
    }
    for (long m = start; m > end; m--) {
        const vector order = fill_vector((double)m);
        for (size_t i = 0; i < VECTORS; i++) {
            const vector below = order * step[i] * here[i] - above[i];
            count[i] -= below * here[i] < fill_vector(0);
            above[i] = here[i];
            here[i] = below;
        }
    }
    for (size_t i = 0; i < VECTORS; i++) {
        double over[VECTOR], under[VECTOR];
        int64_t signs[VECTOR];
        store_vector(over, above[i]);
        store_vector(under, here[i]);
        memcpy(signs, &count[i], sizeof signs);
        for (size_t k = 0; k < VECTOR; k++) {
            quotient[i * VECTOR + k] = over[k] / under[k];
            zeros[i * VECTOR + k] = fabs((double)signs[k]);
        }
    }
}

static void kernel_order_step(size_t count, double m, const double *restrict two_over_kappa, double *restrict above,
                              double *restrict here, double *restrict zeros)
{
    for (size_t i = 0; i < count; i++) {
        const double below = m * two_over_kappa[i] * here[i] - above[i], scale = fabs(below) > 0x1p64 ? 0x1p-64 : 1;
        zeros[i] += below * here[i] < 0 ? 1 : 0;
        above[i] = here[i] * scale;
        here[i] = below * scale;
    }
}

/* Applies J_N' = (N/kappa) J_N - J_(N+1) and J_(N+1)' = J_N - ((N+1)/kappa) J_(N+1), times kappa, term by term. */
static void kernel_series(struct cor_mode_series *restrict series, double N)
{
    double over[COR_MODE_LANES], low[2][COR_MODE_LANES];
    memset(low, 0, sizeof low);
    for (size_t i = 0; i < COR_MODE_LANES; i++) {
        over[i] = 1 / series->kappa[i];
        series->term[0][0][i] = series->here[i];
        series->term[0][1][i] = series->above[i];
    }
    for (size_t k = 0; k + 1 < COR_MODE_TERMS; k++) {
        const double order = N - (double)k, next = N + 1 + (double)k, share = 1 / (double)(k + 1);
        for (size_t i = 0; i < COR_MODE_LANES; i++) {
            const double p = series->term[k][0][i], q = series->term[k][1][i];
            series->term[k + 1][0][i] = ((order * p - low[1][i]) * over[i] - q) * share;
            series->term[k + 1][1][i] = (p + (low[0][i] - next * q) * over[i]) * share;
            low[0][i] = p;
            low[1][i] = q;
        }
    }
}

static void kernel_move(struct cor_mode_wave *restrict wave, const struct cor_mode_series *restrict series, double N,
                        const double *restrict t)
{
    enum { VECTORS = COR_MODE_LANES / VECTOR };
    vector here[VECTORS], above[VECTORS], at[VECTORS];
    double h[COR_MODE_LANES], q[COR_MODE_LANES];
    for (size_t i = 0; i < VECTORS; i++) {
        at[i] = load_vector(t + i * VECTOR);
        here[i] = load_vector(series->term[COR_MODE_TERMS - 1][0] + i * VECTOR);
        above[i] = load_vector(series->term[COR_MODE_TERMS - 1][1] + i * VECTOR);
    }
    for (size_t k = COR_MODE_TERMS - 1; k-- > 0;)
        for (size_t i = 0; i < VECTORS; i++) {
            here[i] = here[i] * at[i] + load_vector(series->term[k][0] + i * VECTOR);
            above[i] = above[i] * at[i] + load_vector(series->term[k][1] + i * VECTOR);
        }
    for (size_t i = 0; i < VECTORS; i++) {
        store_vector(h + i * VECTOR, here[i]);
        store_vector(q + i * VECTOR, above[i]);
    }
    for (size_t i = 0; i < COR_MODE_LANES; i++) {
        const double kappa = series->kappa[i] + t[i], crossed = h[i] * series->here[i] < 0 ? 1 : 0;
        wave->z[i] = kappa * kappa;
        wave->h[i] = h[i];
        wave->k[i] = kappa * q[i] / (2 * N);
        wave->zeros[i] = series->zeros[i] + (t[i] < 0 ? -crossed : crossed);
    }
}

/* Computes the frequency equation and its first two derivatives with respect to ln omega^2 (of x: x1 and x2). If h, d
 * and k have the factor kappa^-N, then h1 = -N k and d1 = -z h/(4N). The number of roots is neg(free) - neg(clamped)
 * plus the zeros of both Bessel functions, (11.3). neg: negative eigenvalues of the rim's 2 x 2 stiffness matrix. Up to
 * positive factors, the clamped matrix has the determinant D = x y - n^2 and a diagonal element -y/D. The free matrix
 * has F/D and -P/D, where F is the left side of the equation and P = y + D/g. */
static void kernel_equation(struct cor_mode_point *restrict point, const struct cor_mode_material *restrict material)
{
    const double e = material->e, s = material->s;
    for (size_t i = 0; i < COR_MODE_LANES; i++) {
        const double n = point->n[i], N = n + 1, g = point->g[i], round = n > 0 ? 0 : 1;
        const double za = point->a.z[i] / (4 * N), zb = point->b.z[i] / (4 * N);
        const double h = point->a.h[i], k = point->a.k[i], d = h - k;
        const double H = point->b.h[i], K = point->b.k[i], D = H - K;
        const double h1 = -N * k, d1 = -za * h, k1 = h1 - d1, h2 = -N * k1, d2 = -za * (h + h1), k2 = h2 - d2;
        const double H1 = -N * K, D1 = -zb * H, K1 = H1 - D1, H2 = -N * K1, D2 = -zb * (H + H1), K2 = H2 - D2;
        const double x = e * d - s * k, x1 = e * d1 - s * k1, x2 = e * d2 - s * k2;
        const double t0 = x * D - 2 * K * d, t1 = d * D, t2 = h * H;
        const double t0_1 = x1 * D + x * D1 - 2 * (K1 * d + K * d1);
        const double t0_2 = x2 * D + 2 * x1 * D1 + x * D2 - 2 * (K2 * d + 2 * K1 * d1 + K * d2);
        const double t1_1 = d1 * D + d * D1, t1_2 = d2 * D + 2 * d1 * D1 + d * D2;
        const double t2_1 = h1 * H + h * H1, t2_2 = h2 * H + 2 * h1 * H1 + h * H2;
        const double half = n * (n - 1) / 2, c = g / N;
        const double r = c * ((n - 1) * (t1 - s * t2 / 2) + t0 / 2);
        const double r1 = c * ((n - 1) * (t1_1 - s * t2_1 / 2) + t0_1 / 2);
        const double r2 = c * ((n - 1) * (t1_2 - s * t2_2 / 2) + t0_2 / 2);
        const double f = round > 0 ? x : r - half * t0;
        const double f1 = round > 0 ? x1 : r + r1 - half * t0_1;
        const double f2 = round > 0 ? x2 : r + 2 * r1 + r2 - half * t0_2;
        /* f1 is 0 between two roots. Then step = 2 marks an invalid step, because 1 - step is negative. */
        const double slope = f1 == 0 ? 1 : f1, newton = f / slope, bend = newton * (f2 - f1) / (2 * slope);
        const double rest = 1 - (bend > -0.5 ? bend : -0.5), divisor = rest == 0 ? 1 : rest;
        point->step[i] = f1 == 0 || rest == 0 ? 2 : newton / divisor;
        const double part = 2 * za * t2;
        const double det = part + n * (t0 / 2 - 2 * t1);
        const double trace = n * ((n - 1) * t1 + t0 / 2) - g * H * d + part;
        const double y = (n * D - g * H / N) * D;
        const double open = f * det < 0 ? 1 : trace * det > 0 ? 2 : 0;
        const double closed = det * t1 < 0 ? 1 : y > 0 ? 2 : 0;
        const double zeros = point->a.zeros[i] + (d * h < 0 ? 1 : 0);
        const double rim = point->b.zeros[i] + (D * H < 0 ? 1 : 0) + open - closed + (n > 1 ? 1 : 0);
        const double breathing = h * d > 0 && x * d < 0 ? 1 : 0;
        point->below[i] = zeros + (round > 0 ? breathing : rim);
    }
}

const struct cor_mode_loops COR_OF_SET(cor_mode) = {kernel_recurrence, kernel_order_step, kernel_series, kernel_move,
                                                    kernel_equation};
