/* SPDX-License-Identifier: MIT */
#include "quadrature.h"

#include <tgmath.h>

typedef long double real;
#define NEAR 1e-11L /* a step so small, relative, was the last: its square is rounding */

static const real pi = 3.14159265358979323846264338327950288L;

/* ---- Gauss and Legendre's rule on [-1, 1], and its integrals from every point to 1 ---- */

struct rule {
    int n;
    real x[DISK_GRID_POINTS], w[DISK_GRID_POINTS], from[DISK_GRID_POINTS][DISK_GRID_POINTS];
};

/* P_0 to P_(n+1) */
static void legendre(real *p, int n, real x)
{
    p[0] = 1;
    p[1] = x;
    for (int k = 2; k <= n + 1; k++)
        p[k] = ((2 * k - 1) * x * p[k - 1] - (k - 1) * p[k - 2]) / k;
}

static void rule_init(struct rule *rule, int n)
{
    real p[DISK_GRID_POINTS][DISK_GRID_POINTS + 2];
    rule->n = n;
    for (int i = 0; i < n; i++) {
        real x = -cos(pi * (real)(i + 0.75) / (real)(n + 0.5)), slope = 1;
        for (int k = 0; k < 6; k++) {
            legendre(p[i], n, x);
            slope = n * (x * p[i][n] - p[i][n - 1]) / (x * x - 1);
            x -= p[i][n] / slope;
        }
        legendre(p[i], n, x);
        rule->x[i] = x;
        rule->w[i] = 2 / ((1 - x * x) * slope * slope);
    }
    /* the interpolant's Legendre coefficients are (2 k + 1)/2 sum_j w_j P_k(x_j) f_j, the integral of P_k from x to 1
     * is (P_(k-1)(x) - P_(k+1)(x))/(2 k + 1) */
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            real sum = (1 - rule->x[i]) / 2;
            for (int k = 1; k < n; k++)
                sum += p[j][k] * (p[i][k - 1] - p[i][k + 1]) / 2;
            rule->from[i][j] = sum * rule->w[j];
        }
}

/* ---- the contact law ---- */

/* Newton's method from above, where it falls to the root without overshooting. */
static real lambert(real q)
{
    if (!(q > 0))
        return 0;
    const real root = sqrt(2 * q);
    real t = q < 1 ? root * (1 + root / 3 + q / 18) : q + log1p(q) + log1p(q) / q;
    for (int i = 0; i < 20; i++) {
        const real step = (t - log1p(t) - q) * (1 + t) / t;
        t -= step;
        if (!(fabs(step) > NEAR * t))
            break;
    }
    return t;
}

struct nodes {
    size_t n;
    real half_time;
    real w[DISK_GRID_NODES], s[DISK_GRID_NODES]; /* I = sum w cos(omega s) */
};

/* at_end: x is the distance from theta = pi/2, else from 0; q0 = 2 ln(v_limit/v) */
static real rate(int at_end, real x, real q0)
{
    const real sine = sin(x);
    return sqrt((1 + lambert(at_end ? q0 - log1p(-sine * sine) : q0 - 2 * log(sine))) / 2);
}

/* Of x from low to high, counted from one end. Towards theta = 0, where s grows. */
static int add_panel(struct nodes *nodes, const struct rule *rule, int at_end, real low, real high, real q0)
{
    real slope[DISK_GRID_POINTS];
    const real half = (high - low) / 2, middle = (high + low) / 2;
    if (nodes->n + (size_t)rule->n > DISK_GRID_NODES)
        return 0;
    /* the rule's x grows with theta */
    const real sign = at_end ? -1 : 1;
    for (int i = 0; i < rule->n; i++)
        slope[i] = half * rate(at_end, middle + sign * half * rule->x[i], q0);
    for (int i = 0; i < rule->n; i++) {
        const real x = middle + sign * half * rule->x[i];
        real s = nodes->half_time;
        for (int j = 0; j < rule->n; j++)
            s += rule->from[i][j] * slope[j];
        nodes->w[nodes->n] = half * rule->w[i] * (at_end ? cos(x) : sin(x));
        nodes->s[nodes->n++] = s;
    }
    for (int i = 0; i < rule->n; i++)
        nodes->half_time += rule->w[i] * slope[i];
    return 1;
}

static int add_split(struct nodes *nodes, const struct rule *rule, int at_end, real low, real high, real q0,
                     real most_time)
{
    const real time = (high - low) * rate(at_end, at_end || low == 0 ? high : low, q0);
    const int parts = 1 + (int)(time / most_time);
    for (int i = 0; i < parts; i++) {
        const int k = at_end ? i : parts - 1 - i;
        const real from = low + (high - low) * k / parts,
                   to = k == parts - 1 ? high : low + (high - low) * (k + 1) / parts;
        if (!add_panel(nodes, rule, at_end, from, to, q0))
            return 0;
    }
    return 1;
}

static int make_nodes(struct nodes *nodes, struct disk_grid grid, real q0, real omega)
{
    struct rule rule;
    if (grid.points < 2 || grid.points > DISK_GRID_POINTS)
        return 0;
    rule_init(&rule, grid.points);
    nodes->n = 0;
    nodes->half_time = 0;
    const real most_time = (real)grid.phase / omega;
    for (int at_end = 1; at_end >= 0; at_end--)
        for (int i = 0; i <= grid.halvings; i++) {
            const int k = at_end ? grid.halvings - i : i;
            const real high = ldexp(pi / 4, -k), low = k == grid.halvings ? 0 : high / 2;
            if (!add_split(nodes, &rule, at_end, low, high, q0, most_time))
                return 0;
        }
    return 1;
}

size_t disk_quadrature(struct disk_grid grid, const struct cor_disk_mode *mode, size_t n, long double b, double speed,
                       long double *fraction)
{
    static struct nodes nodes;
    const real log_limit = (real)1.5 * log((real)2) + (real)b - 1;
    const real q0 = 2 * (log_limit - log((real)speed));
    if (!make_nodes(&nodes, grid, q0 > 0 ? q0 : 0, n > 0 ? (real)mode[n - 1].omega : 1))
        return 0;
    for (size_t i = 0; i < n; i++) {
        const real omega = (real)mode[i].omega;
        real sum = 0;
        for (size_t k = 0; k < nodes.n; k++)
            sum += nodes.w[k] * cos(omega * nodes.s[k]);
        const real amplitude = 2 * (real)mode[i].c * sum;
        fraction[i] = amplitude * amplitude;
    }
    return nodes.n;
}
