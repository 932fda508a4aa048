/* SPDX-License-Identifier: MIT */
#include "disk/modes.h"

#include <math.h>

#include "runtime/disk/mode_source.h"
#include "support/formula.h"
#include "support/local.h"

/* disk/modes.h defines a_n(z), e, s and g. Let N = n + 1, u = a_{n+1}/(2N) and A = 1/(1 - u). Then a_n = (z/(2N)) A,
 * and x = n - a_n. A = h/d and A - 1 = k/d are stored, because computing 1 - A from A cancels for n > kappa. If |A| >
 * 1, h = 1, so that nothing overflows where J_n vanishes; otherwise d = 1. For kappa', B, H, D and K correspond to A,
 * h, d and k; b_n = (g/N) B and y = n - b_n. In these variables
 *
 *     -n(n-1)/2 T0 + (g/N) ((n-1)(T1 - s T2/2) + T0/2) = 0        n >= 1
 *     e d - s k = 0                                              n = 0
 *     T0 = e d D - s k D - 2 K d,   T1 = d D,   T2 = h H
 *
 * is the frequency equation (25) divided by g. This form has no cancellation for nu close to -1 or 1. */

/* ---- Bessel functions ---- */

struct wave {
    arb_t z, h, d, k;
    int tall;    /* true if |A| > 1; then h = 1 */
    slong zeros; /* number of zeros of J_n below kappa */
};

/* Computes the wave from a->z. The zeros of J_m and J_{m+1} interlace: j_{m,k} < j_{m+1,k} < j_{m,k+1}. Below kappa,
 * J_m therefore has one zero more than J_{m+1} if J_{m+1}/J_m < 0, otherwise the same number. Returns 0 if a sign is
 * undecided. */
static int wave_set(struct wave *a, slong n, slong prec)
{
    int decided = 1;
    LOCAL(arb, r, t);
    slong m = cor_mode_recurrence_start(n + 1, sqrt(ball_magnitude(a->z)), prec);
    arb_div_si(t, a->z, 4 * (m + 1), prec);
    arb_mul_si(r, t, 3, prec);
    arb_add_error(r, t);
    a->zeros = 0;
    for (; m > n + 1 && decided; m--) {
        arb_sub_si(t, r, 2 * m, prec);
        arb_neg(t, t);
        decided = !arb_contains_zero(t);
        a->zeros += arb_is_negative(t);
        arb_div(r, a->z, t, prec);
    }
    if (decided) {
        arb_div_si(a->k, r, 2 * (n + 1), prec); /* u */
        arb_sub_si(a->d, a->k, 1, prec);
        arb_neg(a->d, a->d);
        decided = !arb_contains_zero(a->d);
        a->zeros += arb_is_negative(a->d);
        a->tall = arf_cmpabs_2exp_si(arb_midref(a->d), 0) < 0;
        if (a->tall) {
            arb_one(a->h);
        } else if (decided) {
            arb_inv(a->h, a->d, prec);
            arb_div(a->k, a->k, a->d, prec);
            arb_one(a->d);
        }
    }
    return decided;
}

/* Computes z d/dz of h, d and k. z dA/dz is N (1 - A) + z A^2/(4N), Riccati's equation for a_n. */
static void wave_derivative(struct wave *x, const struct wave *a, slong n, slong prec)
{
    arb_zero(x->d);
    LET(x->k, prec, "a->z*a->h^2/(4*(n + 1)) - (n + 1)*a->d*a->k", a->z, a->h, n, a->d, a->k); /* d^2 times z dA/dz */
    arb_set(x->h, x->k);
    if (a->tall) {
        arb_neg(x->d, x->h);
        arb_zero(x->h);
    }
}

/* ---- the equation in interval (ball) arithmetic ---- */

void disk_init(struct disk *d, const fmpq_t nu, slong prec)
{
    FOR_ALL(arb, init, d->e, d->s);
    LET(d->e, prec, "1 + nu", nu);
    LET(d->s, prec, "1 - nu", nu);
    d->e_double = ball_middle(d->e);
    d->s_double = ball_middle(d->s);
    d->prec = prec;
}

void disk_clear(struct disk *d)
{
    FOR_ALL(arb, clear, d->e, d->s);
}

struct waves {
    arb_t g;
    struct wave a, b; /* waves of kappa and kappa' */
};

#define OF_WAVES(w) w->g, w->a.z, w->a.h, w->a.d, w->a.k, w->b.z, w->b.h, w->b.d, w->b.k
static void waves_init(struct waves *w)
{
    FOR_ALL(arb, init, OF_WAVES(w));
}

static void waves_clear(struct waves *w)
{
    FOR_ALL(arb, clear, OF_WAVES(w));
}

static int waves_set(struct waves *v, const struct disk *d, slong n, const arb_t w)
{
    arb_mul(v->g, d->e, w, d->prec);
    arb_mul(v->a.z, d->s, v->g, d->prec);
    arb_mul_2exp_si(v->b.z, v->g, 1);
    return wave_set(&v->a, n, d->prec) && (n == 0 || wave_set(&v->b, n, d->prec));
}

/* Computes T0, T1, T2, which are bilinear in a and b. If a or b is the derivative of its wave, the result is one term
 * of the product rule. */
static void set_products(arb_ptr t, const struct disk *disk, const struct wave *a, const struct wave *b)
{
    LET(t + 0, disk->prec, "(disk->e*a->d - disk->s*a->k)*b->d - 2*b->k*a->d", disk->e, a->d, disk->s, a->k, b->d,
        b->k);
    LET(t + 1, disk->prec, "a->d*b->d", a->d, b->d);
    LET(t + 2, disk->prec, "a->h*b->h", a->h, b->h);
}

/* Computes f = rest - n(n-1)/2 T0, the left side of the equation. rest contains the terms with the factor g. */
static void combine_products(arb_t f, arb_t rest, arb_srcptr t0, const struct disk *disk, const arb_t g, slong n)
{
    const arb_srcptr t1 = t0 + 1, t2 = t0 + 2;
    LET(rest, disk->prec, "((n - 1)*(t1 - disk->s*t2/2) + t0/2)*g/(n + 1)", n, t1, disk->s, t2, t0, g);
    LET(f, disk->prec, "rest - n*(n - 1)/2*t0", rest, n, t0);
}

enum { UNDECIDED_SIGN = 3 };

/* Counts the negative eigenvalues of the rim's 2 x 2 stiffness matrix, for n >= 1. Returns the count for the free disk
 * minus the count for the clamped disk, or UNDECIDED_SIGN. Up to positive factors, the clamped matrix has the
 * determinant D = x y - n^2 and a diagonal element -y/D. The free matrix has the determinant F/D and a diagonal element
 * -P/D. F is the left side of the equation, and P = y + D/g. */
static int count_eigenvalues(arb_srcptr t0, const struct disk *disk, const struct waves *v, slong n)
{
    const slong prec = disk->prec;
    const arb_srcptr t1 = t0 + 1, t2 = t0 + 2;
    LOCAL(arb, f, part, det, p, y);

    /* F, D and P, each times the product a.d b.d of the two waves */
    combine_products(f, p, t0, disk, v->g, n);
    LET(part, prec, "v->a.z*t2/(2*(n + 1))", v->a.z, t2, n);
    LET(det, prec, "n*(t0/2 - 2*t1) + part", n, t0, t1, part);
    LET(p, prec, "n*((n - 1)*t1 + t0/2) - v->b.h*v->a.d*v->g + part", n, t1, t0, v->b.h, v->a.d, v->g, part);
    LET(y, prec, "n*v->b.d - v->g*v->b.h/(n + 1)", n, v->b.d, v->g, v->b.h);
    const int sign_f = arb_sgn_nonzero(f), sign_det = arb_sgn_nonzero(det), sign_p = arb_sgn_nonzero(p);
    const int sign_poles = arb_sgn_nonzero(v->a.d) * arb_sgn_nonzero(v->b.d);
    const int sign_y = arb_sgn_nonzero(y) * arb_sgn_nonzero(v->b.d);

    if (!sign_f || !sign_det || !sign_poles)
        return UNDECIDED_SIGN;
    const int open = sign_f * sign_det < 0 ? 1 : sign_p == sign_det ? 2 : 0;
    const int closed = sign_det * sign_poles < 0 ? 1 : sign_y > 0 ? 2 : 0;
    return (sign_p || open == 1) && (sign_y || closed == 1) ? open - closed : UNDECIDED_SIGN;
}

slong disk_count(const struct disk *disk, slong n, const arb_t w)
{
    LOCAL_VECTOR(t, 3);
    LOCAL_INIT(waves, v, (&v));
    if (!waves_set(&v, disk, n, w))
        return DISK_UNDECIDED;
    if (n == 0) {
        LET(t, disk->prec, "disk->e*v.a.d - disk->s*v.a.k", disk->e, v.a.d, disk->s, v.a.k);
        const int sign = arb_sgn_nonzero(t) * arb_sgn_nonzero(v.a.d);
        const int positive = arb_sgn_nonzero(v.a.h) * arb_sgn_nonzero(v.a.d) > 0; /* A */
        return positive && sign == 0 ? DISK_UNDECIDED : v.a.zeros + (positive && sign < 0);
    }
    set_products(t, disk, &v.a, &v.b);
    const int rim = count_eigenvalues(t, disk, &v, n);
    return rim == UNDECIDED_SIGN ? DISK_UNDECIDED : v.a.zeros + v.b.zeros + rim + (n > 1);
}

int disk_newton(arb_t step, const struct disk *disk, slong n, const arb_t w)
{
    const slong prec = disk->prec;
    LOCAL_VECTOR(t, 3);
    LOCAL(arb, f, df, part, rest);
    LOCAL_INIT(waves, v, (&v));
    LOCAL_INIT(waves, derivative, (&derivative));
    struct wave *const x = &derivative.a;
    if (!waves_set(&v, disk, n, w))
        return 0;
    wave_derivative(x, &v.a, n, prec);
    if (n == 0) {
        LET(step, prec, "(disk->e*v.a.d - disk->s*v.a.k)/(disk->e*x->d - disk->s*x->k)", disk->e, v.a.d, disk->s, v.a.k,
            x->d, x->k);
    } else {
        set_products(t, disk, &v.a, &v.b);
        combine_products(f, df, t, disk, v.g, n); /* rest is proportional to g: rest = g d(rest)/dg */
        set_products(t, disk, x, &v.b);
        combine_products(part, rest, t, disk, v.g, n);
        arb_add(df, df, part, prec);
        wave_derivative(x, &v.b, n, prec);
        set_products(t, disk, &v.a, x);
        combine_products(part, rest, t, disk, v.g, n);
        LET(step, prec, "f/(df + part)", f, df, part);
    }
    return arb_is_finite(step);
}

static slong accuracy_bits(const arb_t x, const arb_t y)
{
    const slong a = arb_rel_accuracy_bits(x), b = arb_rel_accuracy_bits(y);
    return a < b ? a : b;
}

int disk_amplitudes(arb_t c, arb_t s, const struct disk *disk, slong n, const arb_t w)
{
    const slong prec = disk->prec;
    if (n == 0) {
        LET(c, prec, "sqrt(w/(w - 1))", w);
        arb_zero(s);
        return arb_is_positive(c);
    }

    LOCAL(arb, x, y);
    LOCAL_INIT(waves, v, (&v));
    if (!waves_set(&v, disk, n, w))
        return 0;
    /* C and S satisfy (g + x - n^2) C + n (x - 1) S = 0 and n (y - 1) C + (g + y - n^2) S = 0. Each equation
     * degenerates for some modes, so the code uses the one with the smaller relative error. */
    LET(s, prec, "(v.g - n*(n - 1))*v.a.d - v.a.z*v.a.h/(2*(n + 1))", v.g, n, v.a.d, v.a.z, v.a.h);
    LET(c, prec, "n*((n - 1)*v.a.d - v.a.z*v.a.h/(2*(n + 1)))", n, v.a.d, v.a.z, v.a.h);
    LET(x, prec, "n*((n - 1)*v.b.d - v.g*v.b.h/(n + 1))", n, v.b.d, v.g, v.b.h);
    LET(y, prec, "(v.g - n*(n - 1))*v.b.d - v.g*v.b.h/(n + 1)", v.g, n, v.b.d, v.b.h);
    if (accuracy_bits(x, y) > accuracy_bits(c, s)) {
        arb_swap(c, y);
        arb_swap(s, x);
    }
    arb_neg(s, s);

    /* omega^2 (C^2 + S^2) - (C + n S)^2 = 2 omega^2 */
    LET(x, prec, "2*w/((c^2 + s^2)*w - (c + n*s)^2)", w, c, s, n);
    if (!arb_is_positive(x) || !(arb_sgn_nonzero(c) || arb_sgn_nonzero(s)))
        return 0;
    arb_sqrt(x, x, prec);
    if (arb_sgn_nonzero(c) < 0 || (arb_is_zero(c) && arb_sgn_nonzero(s) < 0))
        arb_neg(x, x);
    arb_mul(c, c, x, prec);
    arb_mul(s, s, x, prec);
    return 1;
}
