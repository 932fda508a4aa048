/* SPDX-License-Identifier: MIT */
#include "reference_ode.h"

#include <float.h>
#include <math.h>

enum { ORDER = 40 };

struct jet {
    long double c1, c2;
    long double w[ORDER + 1], v[ORDER + 1], s[ORDER + 1];
};

/* Taylor coefficients of w, v and s in sigma from their values w[0], v[0], s[0]. */
static void jet_expand(struct jet *jet)
{
    long double square[ORDER], force[ORDER]; /* w^2 and c1 v + c2 w^2 */
    for (int k = 0; k < ORDER; k++) {
        square[k] = 0;
        for (int i = 0; i <= k; i++)
            square[k] += jet->w[i] * jet->w[k - i];
        force[k] = jet->c1 * jet->v[k] + jet->c2 * square[k];
        long double product = 0;
        for (int i = 0; i <= k; i++)
            product += square[i] * force[k - i];
        jet->w[k + 1] = jet->v[k] / (2 * (k + 1));
        jet->v[k + 1] = -product / (k + 1);
        jet->s[k + 1] = jet->w[k] / (k + 1);
    }
}

static long double horner(const long double *c, long double h)
{
    long double y = c[ORDER];
    for (int i = ORDER - 1; i >= 0; i--)
        y = y * h + c[i];
    return y;
}

/* The last two terms at the step's end stay below a hundredth of the rounding errors. v passes zero where the elastic
 * force takes over, and w where the speed does. */
static long double step_length(const struct jet *jet)
{
    const long double size_v = fmaxl(fabsl(jet->v[0]), jet->c2 / jet->c1 * jet->w[0] * jet->w[0]);
    const long double size_w = fmaxl(jet->w[0], fabsl(jet->v[0]));
    long double h = 2;
    for (int k = ORDER - 1; k <= ORDER; k++) {
        const long double size = fmaxl(fabsl(jet->w[k]) / size_w, fabsl(jet->v[k]) / size_v);
        if (size > 0)
            h = fminl(h, powl(0.01L * LDBL_EPSILON / size, 1.0L / k));
    }
    return h;
}

static long double overlap_root(const struct jet *jet, long double h)
{
    return horner(jet->w, h);
}

static long double speed(const struct jet *jet, long double h)
{
    return horner(jet->v, h);
}

static long double force(const struct jet *jet, long double h)
{
    const long double w = horner(jet->w, h);
    return jet->c1 * horner(jet->v, h) + jet->c2 * w * w;
}

/* The sign change of f in [0, h] by bisection; f(0) > 0 >= f(h). */
static long double crossing(long double (*f)(const struct jet *, long double), const struct jet *jet, long double h)
{
    long double low = 0, high = h;
    for (int i = 0; i < 2 * LDBL_MANT_DIG; i++) {
        const long double middle = low + (high - low) / 2;
        if (f(jet, middle) > 0)
            low = middle;
        else
            high = middle;
    }
    return low + (high - low) / 2;
}

struct reference reference_collision(long double beta)
{
    struct reference result = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
    struct jet jet = {beta, 1, {0}, {1}, {0}};
    long double length = 1;
    if (beta > 1) {
        length = 1 / powl(beta, 2.0L / 3);
        jet.c1 = 1;
        jet.c2 = length / beta;
    }
    int turned = 0, released = 0;
    for (;;) {
        jet_expand(&jet);
        const long double h = step_length(&jet);
        const long double w = horner(jet.w, h), v = horner(jet.v, h);
        if (!turned && v <= 0) {
            const long double top = crossing(speed, &jet, h), root = horner(jet.w, top);
            result.max_overlap = root * root * length;
            result.time_of_max_overlap = horner(jet.s, top) * length;
            turned = 1;
        }
        const int ends = v < 0 && w <= 0;
        const long double end = ends ? crossing(overlap_root, &jet, h) : h;
        /* the force vanishes before the overlap, and may turn positive again within the step */
        if (!released && v < 0 && (ends || jet.c1 * v + jet.c2 * w * w <= 0)) {
            const long double place = jet.c1 > 0 ? crossing(force, &jet, end) : end;
            result.eps_zero_force = -horner(jet.v, place);
            result.duration_zero_force = horner(jet.s, place) * length;
            released = 1;
        }
        if (ends) {
            result.eps_zero_overlap = -horner(jet.v, end);
            result.duration_zero_overlap = horner(jet.s, end) * length;
            break;
        }
        jet.w[0] = w;
        jet.v[0] = v;
        jet.s[0] = horner(jet.s, h);
    }
    if (beta == 0)
        result.eps_zero_overlap = result.eps_zero_force = 1;
    result.loss_zero_overlap = 1 - result.eps_zero_overlap;
    result.loss_zero_force = 1 - result.eps_zero_force;
    return result;
}
