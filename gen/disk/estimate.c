/* SPDX-License-Identifier: MIT */
#include "disk/estimate.h"

#include <math.h>

#include "support/console.h"

/* equation.c explains the letters of this arithmetic. */
enum { DOUBLE_BITS = 56 };

struct wave {
    double z, h, d, k;
    slong zeros;
};

static double first_rung(double z, slong m)
{
    return 0.75 * z / (double)(m + 1);
}

/* a_{m-1} from a_m; counts negative signs. */
static double rung(double a, double z, slong m, slong *negative)
{
    const double t = 2 * (double)m - a;
    *negative += t < 0;
    return z / t;
}

static void wave_end(struct wave *a, double r, slong n)
{
    a->k = r / (2 * (double)(n + 1));
    a->d = 1 - a->k;
    a->h = 1;
    a->zeros += a->d < 0;
    if (fabs(a->d) >= 1) {
        a->h = 1 / a->d;
        a->k *= a->h;
        a->d = 1;
    }
}

static void wave_set(struct wave *a, slong n)
{
    slong m = disk_ladder_start(n + 1, sqrt(a->z), DOUBLE_BITS);
    double r = first_rung(a->z, m);
    a->zeros = 0;
    for (; m > n + 1; m--)
        r = rung(r, a->z, m, &a->zeros);
    wave_end(a, r, n);
}

static struct wave wave_derivative(const struct wave *a, slong n)
{
    const double N = (double)(n + 1);
    const double x = a->z * a->h * a->h / (4 * N) - N * a->d * a->k;
    return fabs(a->d) < 1 ? (struct wave){.h = 0, .d = -x, .k = x} : (struct wave){.h = x, .d = 0, .k = x};
}

struct products {
    double t[3];
};

static struct products products(const struct disk *disk, const struct wave *a, const struct wave *b)
{
    const double e = disk->e_double, s = disk->s_double;
    return (struct products){{(e * a->d - s * a->k) * b->d - 2 * b->k * a->d, a->d * b->d, a->h * b->h}};
}

static double rest_of(struct products p, double s, double g, double n)
{
    return g / (n + 1) * ((n - 1) * (p.t[1] - s * p.t[2] / 2) + p.t[0] / 2);
}

static slong count_waves(const struct disk *disk, const struct wave *a, const struct wave *b, slong order)
{
    const double e = disk->e_double, s = disk->s_double;
    if (order == 0)
        return a->zeros + (a->h * a->d > 0 && (e * a->d - s * a->k) * a->d < 0);
    const double n = (double)order, g = b->z / 2;
    const struct products p = products(disk, a, b);
    const double f = rest_of(p, s, g, n) - n * (n - 1) / 2 * p.t[0];
    const double part = a->z * p.t[2] / (2 * (n + 1));
    const double det = part + n * (p.t[0] / 2 - 2 * p.t[1]);
    const double trace = n * ((n - 1) * p.t[1] + p.t[0] / 2) - g * b->h * a->d + part;
    const double y = (n * b->d - g * b->h / (n + 1)) * b->d;
    const int open = (f < 0) != (det < 0) ? 1 : (trace < 0) == (det < 0) ? 2 : 0;
    const int closed = (det < 0) != (a->d * b->d < 0) ? 1 : y > 0 ? 2 : 0;
    return a->zeros + b->zeros + open - closed + (order > 1);
}

slong disk_estimate_count(const struct disk *disk, slong n, double omega)
{
    const double g = disk->e_double * omega * omega;
    struct wave a = {.z = disk->s_double * g}, b = {.z = 2 * g};
    wave_set(&a, n);
    if (n > 0)
        wave_set(&b, n);
    return count_waves(disk, &a, &b, n);
}

static double newton(const struct disk *disk, slong n, double omega)
{
    const double e = disk->e_double, s = disk->s_double, g = e * omega * omega;
    struct wave a = {.z = s * g}, b = {.z = 2 * g};
    wave_set(&a, n);
    const struct wave da = wave_derivative(&a, n);
    double step;
    if (n == 0) {
        step = (e * a.d - s * a.k) / (e * da.d - s * da.k);
    } else {
        wave_set(&b, n);
        const struct wave db = wave_derivative(&b, n);
        const double half = (double)n * (double)(n - 1) / 2;
        const struct products p = products(disk, &a, &b), pa = products(disk, &da, &b), pb = products(disk, &a, &db);
        const double rest = rest_of(p, s, g, (double)n);
        const double df =
            rest + rest_of(pa, s, g, (double)n) + rest_of(pb, s, g, (double)n) - half * (pa.t[0] + pb.t[0]);
        step = (rest - half * p.t[0]) / df;
    }
    return omega * sqrt(1 - step);
}

double disk_estimate_total(const struct disk *disk, double omega)
{
    const double g = disk->e_double * omega * omega;
    const double z[2] = {disk->s_double * g, 2 * g};
    const slong orders = disk_orders(omega);
    slong m = disk_ladder_start(orders, sqrt(z[1]), DOUBLE_BITS);
    double r[2] = {first_rung(z[0], m), first_rung(z[1], m)};
    slong zeros[2] = {0, 0};
    double total = 0;
    for (; m > 0; m--) {
        const slong n = m - 1;
        if (n < orders) {
            struct wave a = {.z = z[0], .zeros = zeros[0]}, b = {.z = z[1], .zeros = zeros[1]};
            wave_end(&a, r[0], n);
            wave_end(&b, r[1], n);
            total += (double)count_waves(disk, &a, &b, n);
        }
        for (int i = 0; i < 2; i++)
            r[i] = rung(r[i], z[i], m, &zeros[i]);
    }
    return total;
}

/* ---- roots ---- */

static double refine(const struct disk *disk, slong n, slong l, double low, double high)
{
    enum { HALVINGS = 5, STEPS = 8, HALVINGS_MAX = 60 };
    for (int i = 0; i < HALVINGS_MAX && high - low > 4 * 0x1p-53 * high; i++) {
        const double middle = low + (high - low) / 2;
        if (i >= HALVINGS) {
            double x = middle;
            for (int step = 0; step < STEPS; step++) {
                const double next = newton(disk, n, x);
                if (!(next > low && next < high))
                    break;
                if (fabs(next - x) < 0x1p-46 * x)
                    return next;
                x = next;
            }
        }
        if (disk_estimate_count(disk, n, middle) > l)
            high = middle;
        else
            low = middle;
    }
    return low + (high - low) / 2;
}

static void isolate(double *omega, const struct disk *disk, slong n, double low, slong below_low, double high,
                    slong below_high)
{
    const double middle = low + (high - low) / 2;
    if (below_high - below_low == 1) {
        omega[below_low] = refine(disk, n, below_low, low, high);
    } else if (high - low < 0x1p-46 * high) {
        /* doubles cannot separate these roots, interval (ball) arithmetic does */
        for (slong l = below_low; l < below_high; l++)
            omega[l] = middle;
    } else if (below_high > below_low) {
        slong below = disk_estimate_count(disk, n, middle);
        below = below < below_low ? below_low : below > below_high ? below_high : below;
        isolate(omega, disk, n, low, below_low, middle, below);
        isolate(omega, disk, n, middle, below, high, below_high);
    }
}

double *disk_estimate_roots(slong *count, const struct disk *disk, slong n, double omega)
{
    const slong below = disk_estimate_count(disk, n, omega);
    *count = below > 0 ? below : 0;
    double *root = xmalloc((size_t)*count * sizeof *root);
    const double low = n > 1 ? sqrt((double)n * (double)(n - 1) / 10.5) : 0;
    isolate(root, disk, n, low, 0, omega, *count);
    return root;
}
