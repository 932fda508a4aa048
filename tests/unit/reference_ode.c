/* SPDX-License-Identifier: MIT */
#include "reference_ode.h"

#include <float.h>
#include <math.h>

enum { ORDER = 40 };

struct jet {
    long double w[ORDER + 1], v[ORDER + 1];
};

/* Taylor coefficients of w and v in sigma from their values w[0], v[0]. */
static void jet_expand(struct jet *jet, long double beta)
{
    long double square[ORDER], force[ORDER]; /* w^2 and beta v + w^2 */
    for (int k = 0; k < ORDER; k++) {
        square[k] = 0;
        for (int i = 0; i <= k; i++)
            square[k] += jet->w[i] * jet->w[k - i];
        force[k] = beta * jet->v[k] + square[k];
        long double product = 0;
        for (int i = 0; i <= k; i++)
            product += square[i] * force[k - i];
        jet->w[k + 1] = jet->v[k] / (2 * (k + 1));
        jet->v[k + 1] = -product / (k + 1);
    }
}

static long double horner(const long double *c, long double h)
{
    long double y = c[ORDER];
    for (int i = ORDER - 1; i >= 0; i--)
        y = y * h + c[i];
    return y;
}

/* The last two terms at the step's end stay below a tenth of the rounding error of v. */
static long double step_length(const struct jet *jet)
{
    long double h = 1;
    for (int k = ORDER - 1; k <= ORDER; k++) {
        const long double size = fmaxl(fabsl(jet->w[k]), fabsl(jet->v[k]));
        if (size > 0)
            h = fminl(h, powl(0.01L * LDBL_EPSILON / size, 1.0L / k));
    }
    return h;
}

static long double overlap_root(const struct jet *jet, long double beta, long double h)
{
    (void)beta;
    return horner(jet->w, h);
}

static long double force(const struct jet *jet, long double beta, long double h)
{
    const long double w = horner(jet->w, h);
    return beta * horner(jet->v, h) + w * w;
}

/* The sign change of f in [0, h] by bisection; f(0) > 0 >= f(h). */
static long double crossing(long double (*f)(const struct jet *, long double, long double), const struct jet *jet,
                            long double beta, long double h)
{
    long double low = 0, high = h;
    for (int i = 0; i < 2 * LDBL_MANT_DIG; i++) {
        const long double middle = low + (high - low) / 2;
        if (f(jet, beta, middle) > 0)
            low = middle;
        else
            high = middle;
    }
    return low + (high - low) / 2;
}

struct reference reference_collision(long double beta)
{
    struct reference result = {1, 0, 1, 0};
    if (beta == 0)
        return result;
    struct jet jet;
    jet.w[0] = 0;
    jet.v[0] = 1;
    int force_found = 0;
    for (;;) {
        jet_expand(&jet, beta);
        const long double h = step_length(&jet);
        const long double w = horner(jet.w, h), v = horner(jet.v, h);
        const int ends = v < 0 && w <= 0;
        const long double end = ends ? crossing(overlap_root, &jet, beta, h) : h;
        /* the force vanishes before the overlap, and may turn positive again within the step */
        if (!force_found && v < 0 && (ends || beta * v + w * w <= 0)) {
            result.eps_zero_force = -horner(jet.v, crossing(force, &jet, beta, end));
            force_found = 1;
        }
        if (ends) {
            result.eps_zero_overlap = -horner(jet.v, end);
            break;
        }
        jet.w[0] = w;
        jet.v[0] = v;
    }
    result.loss_zero_overlap = 1 - result.eps_zero_overlap;
    result.loss_zero_force = 1 - result.eps_zero_force;
    return result;
}
