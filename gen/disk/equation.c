/* SPDX-License-Identifier: MIT */
#include "disk/equation.h"

#include <math.h>

#include "runtime/disk/mode_source.h"
#include "support/formula.h"
#include "support/local.h"

/* Let N = n + 1, u = a_{n+1}/(2N) and A = 1/(1 - u). Then a_n = (z/(2N)) A, and x = n - a_n. A is stored as h/d, and A
 * - 1 as k/d, because 1 - A cancels for n > kappa. d = 1 unless |A| > 1; then h = 1, so that nothing overflows where
 * J_n vanishes. In these variables, with capital letters for kappa', b_n = (g/N) B and y = n - b_n,
 *
 *     -n(n-1)/2 T0 + (g/N) ((n-1)(T1 - s T2/2) + T0/2) = 0        n >= 1
 *     e d - s k = 0                                              n = 0
 *     T0 = e d D - s k D - 2 K d,   T1 = d D,   T2 = h H
 *
 * is the frequency equation (25) divided by g. Nothing cancels in it where nu is close to -1 or 1. */

/* ---- Bessel functions ---- */

struct wave {
    arb_t z, h, d, k;
    int tall;    /* |A| > 1: h = 1 */
    slong zeros; /* number of zeros of J_n below kappa */
};

static void wave_init(struct wave *a)
{
    FOR_ALL(arb, init, a->z, a->h, a->d, a->k);
}

static void wave_clear(struct wave *a)
{
    FOR_ALL(arb, clear, a->z, a->h, a->d, a->k);
}

/* Computes the wave from a->z. The zeros of J_m and J_{m+1} interlace, j_{m,k} < j_{m+1,k} < j_{m,k+1}: below kappa,
 * J_m has one zero more than J_{m+1} if J_{m+1}/J_m < 0, and otherwise the same number. Returns 0 if a sign is
 * undecided. */
static int wave_set(struct wave *a, slong n, slong prec)
{
    int decided = 1;
    LOCAL(arb, r, t);
    LOCAL(mag, half);

    arb_get_mag(half, a->z);
    slong m = cor_mode_ladder_start(n + 1, sqrt(mag_get_d(half)), prec);
    arb_div_si(r, a->z, 2 * (m + 1), prec);
    arb_get_mag(half, r);
    mag_mul_2exp_si(half, half, -1);
    arb_mul_si(r, r, 3, prec);
    arb_mul_2exp_si(r, r, -1);
    arb_add_error_mag(r, half);

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

/* z d/dz of h, d and k. z dA/dz is N (1 - A) + z A^2/(4N), Riccati's equation for a_n. */
static void wave_derivative(arb_t h, arb_t d, arb_t k, const struct wave *a, slong n, slong prec)
{
    arb_mul(h, a->z, a->h, prec);
    arb_mul(h, h, a->h, prec);
    arb_div_si(h, h, 4 * (n + 1), prec);
    arb_mul(d, a->d, a->k, prec);
    arb_mul_si(d, d, n + 1, prec);
    arb_sub(h, h, d, prec); /* d^2 times z dA/dz */
    if (a->tall) {
        arb_neg(d, h);
        arb_set(k, h);
        arb_zero(h);
    } else {
        arb_zero(d);
        arb_set(k, h);
    }
}

/* ---- the equation in interval (ball) arithmetic ---- */

void disk_init(struct disk *d, const fmpq_t nu, slong prec)
{
    LOCAL(fmpq, x);
    FOR_ALL(arb, init, d->e, d->s);
    fmpq_add_si(x, nu, 1);
    arb_set_fmpq(d->e, x, prec);
    fmpq_sub_si(x, x, 2);
    fmpq_neg(x, x);
    arb_set_fmpq(d->s, x, prec);
    d->e_double = arf_get_d(arb_midref(d->e), ARF_RND_NEAR);
    d->s_double = arf_get_d(arb_midref(d->s), ARF_RND_NEAR);
    d->prec = prec;
}

void disk_init_round(struct disk *d, const struct disk *wide, slong prec)
{
    FOR_ALL(arb, init, d->e, d->s);
    arb_set_round(d->e, wide->e, prec);
    arb_set_round(d->s, wide->s, prec);
    d->e_double = wide->e_double;
    d->s_double = wide->s_double;
    d->prec = prec;
}

void disk_clear(struct disk *d)
{
    FOR_ALL(arb, clear, d->e, d->s);
}

struct waves {
    arb_t g;
    struct wave a, b; /* of kappa and kappa' */
};

static void waves_init(struct waves *w)
{
    arb_init(w->g);
    wave_init(&w->a);
    wave_init(&w->b);
}

static void waves_clear(struct waves *w)
{
    arb_clear(w->g);
    wave_clear(&w->a);
    wave_clear(&w->b);
}

static int waves_set(struct waves *v, const struct disk *d, slong n, const arb_t w)
{
    arb_mul(v->g, d->e, w, d->prec);
    arb_mul(v->a.z, d->s, v->g, d->prec);
    arb_mul_2exp_si(v->b.z, v->g, 1);
    return wave_set(&v->a, n, d->prec) && (n == 0 || wave_set(&v->b, n, d->prec));
}

/* T0, T1, T2 are bilinear. With the derivatives of one wave they are one half of the product rule. */
static void products(arb_ptr t, const struct disk *disk, const arb_t h, const arb_t d, const arb_t k,
                     const struct wave *b)
{
    const slong prec = disk->prec;
    arb_mul(t + 0, disk->e, d, prec);
    arb_submul(t + 0, disk->s, k, prec);
    arb_mul(t + 0, t + 0, b->d, prec);
    arb_mul(t + 1, b->k, d, prec);
    arb_mul_2exp_si(t + 1, t + 1, 1);
    arb_sub(t + 0, t + 0, t + 1, prec);
    arb_mul(t + 1, d, b->d, prec);
    arb_mul(t + 2, h, b->h, prec);
}

/* f = rest - n(n-1)/2 T0 is the left side of the equation; rest contains the terms with the factor g */
static void combine(arb_t f, arb_t rest, arb_srcptr t, const struct disk *disk, const arb_t g, slong n)
{
    const slong prec = disk->prec;
    arb_mul(rest, disk->s, t + 2, prec);
    arb_mul_2exp_si(rest, rest, -1);
    arb_sub(rest, t + 1, rest, prec);
    arb_mul_si(rest, rest, n - 1, prec);
    arb_mul_2exp_si(f, t + 0, -1);
    arb_add(rest, rest, f, prec);
    arb_mul(rest, rest, g, prec);
    arb_div_si(rest, rest, n + 1, prec);
    arb_mul_si(f, t + 0, n * (n - 1) / 2, prec);
    arb_sub(f, rest, f, prec);
}

enum { UNDECIDED_SIGN = 3 };

/* Negative eigenvalues of the stiffness at the rim, free minus clamped, n >= 1. Up to positive factors, the 2 x 2
 * matrices have det(clamped) = D = x y - n^2, det(free) = F/D, where F is the left side of the equation, and diagonals
 * -y/D and -P/D, where P = y + D/g. Returns UNDECIDED_SIGN if a sign is undecided. */
static int eigenvalues(arb_srcptr t, const struct disk *disk, const struct waves *v, slong n)
{
    const slong prec = disk->prec;
    LOCAL(arb, f, x, y);
    int result = UNDECIDED_SIGN;

    /* F, D and P times d D of the waves */
    combine(f, x, t, disk, v->g, n);
    const int sign_f = arb_sgn_nonzero(f);

    arb_mul(f, v->a.z, t + 2, prec);
    arb_div_si(f, f, 2 * (n + 1), prec);
    arb_mul_2exp_si(y, t + 0, -1);
    arb_mul_2exp_si(x, t + 1, 1);
    arb_sub(x, y, x, prec);
    arb_mul_si(x, x, n, prec);
    arb_add(x, x, f, prec);
    const int sign_det = arb_sgn_nonzero(x);

    arb_mul_si(x, t + 1, n - 1, prec);
    arb_add(x, x, y, prec);
    arb_mul_si(x, x, n, prec);
    arb_mul(y, v->b.h, v->a.d, prec);
    arb_submul(x, y, v->g, prec);
    arb_add(x, x, f, prec);
    const int sign_p = arb_sgn_nonzero(x);

    arb_mul(y, v->g, v->b.h, prec);
    arb_div_si(y, y, n + 1, prec);
    arb_mul_si(x, v->b.d, n, prec);
    arb_sub(y, x, y, prec);
    const int sign_poles = arb_sgn_nonzero(v->a.d) * arb_sgn_nonzero(v->b.d);
    const int sign_y = arb_sgn_nonzero(y) * arb_sgn_nonzero(v->b.d);

    if (sign_f && sign_det && sign_poles) {
        const int open = sign_f * sign_det < 0 ? 1 : sign_p == sign_det ? 2 : 0;
        const int closed = sign_det * sign_poles < 0 ? 1 : sign_y > 0 ? 2 : 0;
        if ((sign_p || open == 1) && (sign_y || closed == 1))
            result = open - closed;
    }
    return result;
}

slong disk_count(const struct disk *disk, slong n, const arb_t w)
{
    LOCAL_VECTOR(t, 3);
    LOCAL_INIT(waves, v, (&v));
    slong count = DISK_UNDECIDED;
    if (!waves_set(&v, disk, n, w)) {
        /* undecided */
    } else if (n == 0) {
        arb_mul(t + 0, disk->e, v.a.d, disk->prec);
        arb_submul(t + 0, disk->s, v.a.k, disk->prec);
        const int positive = arb_sgn_nonzero(v.a.h) * arb_sgn_nonzero(v.a.d) > 0; /* A */
        if (!positive)
            count = v.a.zeros;
        else if (arb_sgn_nonzero(t + 0))
            count = v.a.zeros + (arb_sgn_nonzero(t + 0) * arb_sgn_nonzero(v.a.d) < 0);
    } else {
        products(t, disk, v.a.h, v.a.d, v.a.k, &v.b);
        const int rim = eigenvalues(t, disk, &v, n);
        if (rim != UNDECIDED_SIGN)
            count = v.a.zeros + v.b.zeros + rim + (n > 1);
    }
    return count;
}

int disk_newton(arb_t step, const struct disk *disk, slong n, const arb_t w)
{
    const slong prec = disk->prec;
    LOCAL_VECTOR(t, 3);
    LOCAL(arb, f, df, rest);
    LOCAL_INIT(waves, v, (&v));
    LOCAL_INIT(wave, derivative, (&derivative));
    int done = waves_set(&v, disk, n, w);
    if (done) {
        wave_derivative(derivative.h, derivative.d, derivative.k, &v.a, n, prec);
        if (n == 0) {
            arb_mul(f, disk->e, v.a.d, prec);
            arb_submul(f, disk->s, v.a.k, prec);
            arb_mul(df, disk->e, derivative.d, prec);
            arb_submul(df, disk->s, derivative.k, prec);
        } else {
            LOCAL(arb, part);
            products(t, disk, v.a.h, v.a.d, v.a.k, &v.b);
            combine(f, df, t, disk, v.g, n); /* rest is proportional to g, so it equals g times its derivative by g */
            products(t, disk, derivative.h, derivative.d, derivative.k, &v.b);
            combine(part, rest, t, disk, v.g, n);
            arb_add(df, df, part, prec);
            wave_derivative(derivative.h, derivative.d, derivative.k, &v.b, n, prec);
            products(t, disk, v.a.h, v.a.d, v.a.k, &derivative);
            combine(part, rest, t, disk, v.g, n);
            arb_add(df, df, part, prec);
        }
        arb_div(step, f, df, prec);
        done = arb_is_finite(step);
    }
    return done;
}

static slong accuracy(const arb_t x, const arb_t y)
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
    /* (g + x - n^2) C + n (x - 1) S = 0 = n (y - 1) C + (g + y - n^2) S. Each row degenerates for some modes, so the
     * code uses the row with the smaller relative error. */
    LET(s, prec, "(v.g - n*(n - 1))*v.a.d - v.a.z*v.a.h/(2*(n + 1))", v.g, n, v.a.d, v.a.z, v.a.h);
    LET(c, prec, "n*((n - 1)*v.a.d - v.a.z*v.a.h/(2*(n + 1)))", n, v.a.d, v.a.z, v.a.h);
    LET(x, prec, "n*((n - 1)*v.b.d - v.g*v.b.h/(n + 1))", n, v.b.d, v.g, v.b.h);
    LET(y, prec, "(v.g - n*(n - 1))*v.b.d - v.g*v.b.h/(n + 1)", v.g, n, v.b.d, v.b.h);
    if (accuracy(x, y) > accuracy(c, s)) {
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
