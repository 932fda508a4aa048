/* SPDX-License-Identifier: MIT */
/* The recurrence of trajectory.h, in exact rationals and in interval (ball) arithmetic.
 *
 * With x = t X, the derivation D that multiplies u^k s^j by e = k (b+1) + j (a+1), and
 * x^b x' = (x^(b+1))'/(b+1), the equation of motion is, coefficient by coefficient,
 *
 *   e (e+1) c[k][j] = -(e/(b+1)) [X^(b+1)][k-1][j] - [X^a][k][j-1].
 *
 * A power P = X^p obeys X P_u = p P X_u; with P_k, X_k the rows in s, for k >= 1
 *
 *   P_k = p X_0^(p-1) X_k + Q_k,   k X_0 Q_k = sum_{0<i<k} ((p+1) i - k) X_i P_(k-i),
 *
 * so a new row costs k products of polynomials, and its coefficients follow one by one. In interval arithmetic,
 * row_sums.c computes the products of many rows. For spheres a = b+1 = 3/2 and the two powers are the same one. */
#include "series/trajectory.h"

#include <math.h>

#include "series/jet.h"
#include "series/row_sums.h"
#include "support/console.h"
#include "support/local.h"

/* p = a and b+1. Returns how many powers there are: 1 if they are the same. */
static int powers_of(struct ratio p[2], const struct cor_exponents *law)
{
    p[0] = law_elastic(law);
    p[1] = RATIO("law->b + 1", law);
    return law->elastic == law->damping + law->denominator ? 1 : 2;
}

/* ---- exact ---- */

struct exact_power {
    struct ratio p;
    fmpq_poly_struct *row;   /* P_k */
    fmpq_poly_t slope, rest; /* p X_0^(p-1), and Q_k of the current row */
};

static fmpq_poly_struct *exact_rows(slong rows)
{
    fmpq_poly_struct *row = flint_malloc((size_t)rows * sizeof *row);
    for (slong k = 0; k < rows; k++)
        fmpq_poly_init(row + k);
    return row;
}

void trajectory_exact_free(fmpq_poly_struct *row, slong rows)
{
    for (slong k = 0; k < rows; k++)
        fmpq_poly_clear(row + k);
    flint_free(row);
}

/* sum_i p_i q_(n-i), computed with integers over the two common denominators */
static void exact_dot(fmpq_t sum, const fmpq_poly_struct *p, const fmpq_poly_struct *q, slong n)
{
    LOCAL(fmpz, num, den);
    const slong first = FLINT_MAX(0, n - (q->length - 1)), last = FLINT_MIN(n, p->length - 1);
    for (slong i = first; i <= last; i++)
        fmpz_addmul(num, p->coeffs + i, q->coeffs + n - i);
    fmpz_mul(den, p->den, q->den);
    fmpq_set_fmpz_frac(sum, num, den);
}

/* Coefficient j >= 1 of X_0^p from lower ones: j P_j = sum_i ((p+1) i - j) x_i P_(j-i). */
static void exact_first_row(struct exact_power *power, const fmpq_poly_t x0, slong j)
{
    LOCAL(fmpq, sum, x, y);
    for (slong i = 1; i <= j; i++) {
        fmpq_poly_get_coeff_fmpq(x, x0, i);
        fmpq_poly_get_coeff_fmpq(y, power->row, j - i);
        const slong weight = row_sums_weight(power->p, i, j), den = j * power->p.den;
        EXACT(sum, "sum + weight*x*y/den", sum, weight, x, y, den);
    }
    fmpq_poly_set_coeff_fmpq(power->row, j, sum);
}

static void exact_rest(struct exact_power *power, const fmpq_poly_struct *x, const fmpq_poly_t x0_inverse, slong k,
                       slong length)
{
    LOCAL(fmpq_poly, product);
    fmpq_poly_zero(power->rest);
    for (slong i = 1; i < k; i++) {
        fmpq_poly_mullow(product, x + i, power->row + k - i, length);
        fmpq_poly_scalar_mul_si(product, product, row_sums_weight(power->p, i, k));
        fmpq_poly_add(power->rest, power->rest, product);
    }
    fmpq_poly_mullow(power->rest, power->rest, x0_inverse, length);
    fmpq_poly_scalar_div_si(power->rest, power->rest, k * power->p.den);
}

fmpq_poly_struct *trajectory_exact(slong order, slong terms, const struct cor_exponents *law)
{
    /* e = e_num/d with e_num = k (b+1) d + j (a+1) d */
    const slong length = terms + 1, d = law->denominator, du = law->damping + d, ds = law->elastic + d;
    struct ratio p[2];
    const int powers = powers_of(p, law);
    struct exact_power power[2], *const elastic = power, *const damping = power + powers - 1;
    LOCAL(fmpq_poly, x0_inverse);
    fmpq_poly_struct *const row = exact_rows(order + 1);
    LOCAL(fmpq, sum, x);
    fmpq_poly_one(row);
    for (int i = 0; i < powers; i++) {
        power[i].p = p[i];
        power[i].row = exact_rows(order + 1);
        FOR_ALL(fmpq_poly, init, power[i].slope, power[i].rest);
        fmpq_poly_one(power[i].row);
    }

    for (slong j = 1; j <= terms; j++) {
        progress("elastic trajectory", j, terms);
        fmpq_poly_get_coeff_fmpq(x, elastic->row, j - 1);
        const slong e = j * ds;
        EXACT(x, "-x*d^2/(e*(e + d))", x, d, e);
        fmpq_poly_set_coeff_fmpq(row, j, x);
        for (int i = 0; i < powers; i++)
            exact_first_row(&power[i], row, j);
    }
    fmpq_poly_inv_series(x0_inverse, row, length);
    for (int i = 0; i < powers; i++) {
        fmpq_poly_mullow(power[i].slope, power[i].row, x0_inverse, length);
        fmpq_poly_scalar_mul_si(power[i].slope, power[i].slope, p[i].num);
        fmpq_poly_scalar_div_si(power[i].slope, power[i].slope, p[i].den);
    }

    for (slong k = 1; k <= order; k++) {
        progress("trajectory rows", k, order);
        for (int i = 0; i < powers; i++)
            exact_rest(&power[i], row, x0_inverse, k, length);
        for (slong j = 0; j <= terms; j++) {
            const slong e = k * du + j * ds;
            fmpq_zero(sum);
            if (j > 0) { /* [X^a][k][j-1] */
                exact_dot(sum, elastic->slope, row + k, j - 1);
                fmpq_poly_get_coeff_fmpq(x, elastic->rest, j - 1);
                fmpq_add(sum, sum, x);
            }
            fmpq_poly_get_coeff_fmpq(x, damping->row + k - 1, j);
            EXACT(sum, "-(sum/e + x/du)*d^2/(e + d)", sum, e, x, du, d);
            fmpq_poly_set_coeff_fmpq(row + k, j, sum);
        }
        for (int i = 0; i < powers; i++) {
            fmpq_poly_mullow(power[i].row + k, power[i].slope, row + k, length);
            fmpq_poly_add(power[i].row + k, power[i].row + k, power[i].rest);
        }
    }
    for (int i = 0; i < powers; i++) {
        trajectory_exact_free(power[i].row, order + 1);
        FOR_ALL(fmpq_poly, clear, power[i].slope, power[i].rest);
    }
    return row;
}

/* ---- in balls; the elastic constant is 2^shift ---- */

struct ball_power {
    struct ratio p;
    arb_poly_struct *row;   /* P_k */
    arb_poly_t slope, rest; /* p X_0^(p-1), and Q_k of the current row */
    struct row_sums *sums;  /* NULL with few rows */
};

static void ball_first_row(struct ball_power *power, const arb_poly_t x0, slong j, slong prec)
{
    LOCAL(arb, sum, x);
    for (slong i = 1; i <= j; i++) {
        arb_poly_get_coeff_arb(x, x0, i);
        if (j - i < power->row->length)
            arb_mul(x, x, power->row->coeffs + j - i, prec);
        else
            arb_zero(x);
        arb_mul_si(x, x, row_sums_weight(power->p, i, j), prec);
        arb_add(sum, sum, x, prec);
    }
    arb_div_si(sum, sum, j * power->p.den, prec);
    arb_poly_set_coeff_arb(power->row, j, sum);
}

static void ball_divide(arb_poly_t p, slong n, slong prec)
{
    for (slong i = 0; i < p->length; i++)
        arb_div_si(p->coeffs + i, p->coeffs + i, n, prec);
}

static void ball_rest(struct ball_power *power, const arb_poly_struct *x, const arb_poly_t x0_inverse, slong k,
                      slong length, slong prec)
{
    LOCAL(arb_poly, product);
    LOCAL(arb, weight);
    if (power->sums)
        row_sums_next(power->rest, power->sums, x, power->row, k);
    else
        arb_poly_zero(power->rest);
    for (slong i = 1; i < k && !power->sums; i++) {
        arb_set_si(weight, row_sums_weight(power->p, i, k));
        arb_poly_mullow(product, x + i, power->row + k - i, length, prec);
        arb_poly_scalar_mul(product, product, weight, prec);
        arb_poly_add(power->rest, power->rest, product, prec);
    }
    arb_poly_mullow(power->rest, power->rest, x0_inverse, length, prec);
    ball_divide(power->rest, k * power->p.den, prec);
}

static void ball_dot(arb_t sum, const arb_poly_t p, const arb_poly_t q, slong n, slong prec)
{
    const slong first = FLINT_MAX(0, n - (q->length - 1)), last = FLINT_MIN(n, p->length - 1);
    if (last < first)
        arb_zero(sum);
    else
        arb_dot(sum, NULL, 0, p->coeffs + first, 1, q->coeffs + n - first, -1, last - first + 1, prec);
}

/* Rounding errors grow from row to row. Digits below them are dropped, which makes products cheaper. */
static void ball_trim(arb_poly_t p)
{
    for (slong i = 0; i < p->length; i++)
        arb_trim(p->coeffs + i, p->coeffs + i);
}

void trajectory_init(struct trajectory *t, slong order, slong terms, const struct cor_exponents *law, slong prec)
{
    const slong length = terms + 1, d = law->denominator, du = law->damping + d, ds = law->elastic + d;
    const double farthest = law_elastic_radius(law) * law_elastic_time(law);
    struct ratio p[2];
    const int powers = powers_of(p, law);
    struct row_sums sums[2];
    struct ball_power power[2], *const elastic = power, *const damping = power + powers - 1;
    LOCAL(arb_poly, x0_inverse);
    LOCAL(arb, sum, x);
    t->law = *law;
    t->order = order;
    t->terms = terms;
    t->prec = prec;
    t->shift = (slong)floor(log2(farthest) * (double)(law->elastic + law->denominator) / (double)law->denominator);
    t->x = jet_new(order + 1);
    arb_poly_one(t->x);
    for (int i = 0; i < powers; i++) {
        power[i].p = p[i];
        power[i].row = jet_new(order + 1);
        FOR_ALL(arb_poly, init, power[i].slope, power[i].rest);
        power[i].sums = order + 1 < ROW_SUMS_MIN_ROWS ? NULL : &sums[i];
        if (power[i].sums)
            row_sums_init(power[i].sums, p[i], order + 1, length, prec);
        arb_poly_one(power[i].row);
    }

    for (slong j = 1; j <= terms; j++) {
        progress("elastic trajectory", j, terms);
        arb_poly_get_coeff_arb(x, elastic->row, j - 1);
        arb_mul_2exp_si(x, x, t->shift);
        arb_mul_si(x, x, -d * d, prec);
        arb_div_si(x, x, j * ds, prec);
        arb_div_si(x, x, j * ds + d, prec);
        arb_poly_set_coeff_arb(t->x, j, x);
        for (int i = 0; i < powers; i++)
            ball_first_row(&power[i], t->x, j, prec);
    }
    arb_poly_inv_series(x0_inverse, t->x, length, prec);
    for (int i = 0; i < powers; i++) {
        arb_poly_mullow(power[i].slope, power[i].row, x0_inverse, length, prec);
        arb_set_si(x, p[i].num);
        arb_poly_scalar_mul(power[i].slope, power[i].slope, x, prec);
        ball_divide(power[i].slope, p[i].den, prec);
    }

    for (slong k = 1; k <= order; k++) {
        arb_poly_struct *const row = t->x + k;
        progress("trajectory rows", k, order);
        for (int i = 0; i < powers; i++)
            ball_rest(&power[i], t->x, x0_inverse, k, length, prec);
        for (slong j = 0; j <= terms; j++) {
            const slong e = k * du + j * ds;
            arb_zero(sum);
            if (j > 0) { /* 2^shift [X^a][k][j-1] d/e */
                ball_dot(sum, elastic->slope, row, j - 1, prec);
                arb_poly_get_coeff_arb(x, elastic->rest, j - 1);
                arb_add(sum, sum, x, prec);
                arb_mul_2exp_si(sum, sum, t->shift);
                arb_mul_si(sum, sum, d, prec);
                arb_div_si(sum, sum, e, prec);
            }
            arb_poly_get_coeff_arb(x, damping->row + k - 1, j);
            arb_mul_si(x, x, d, prec);
            arb_div_si(x, x, du, prec);
            arb_add(sum, sum, x, prec);
            arb_mul_si(sum, sum, -d, prec);
            arb_div_si(sum, sum, e + d, prec);
            arb_poly_set_coeff_arb(row, j, sum);
        }
        ball_trim(row);
        for (int i = 0; i < powers; i++) {
            arb_poly_mullow(power[i].row + k, power[i].slope, row, length, prec);
            arb_poly_add(power[i].row + k, power[i].row + k, power[i].rest, prec);
            ball_trim(power[i].row + k);
        }
    }
    t->x_to_a = elastic->row;
    t->x_to_b1 = damping->row;
    for (int i = 0; i < powers; i++) {
        FOR_ALL(arb_poly, clear, power[i].slope, power[i].rest);
        if (power[i].sums)
            row_sums_clear(power[i].sums);
    }
}

void trajectory_clear(struct trajectory *t)
{
    jet_free(t->x, t->order + 1);
    jet_free(t->x_to_a, t->order + 1);
    if (t->x_to_b1 != t->x_to_a)
        jet_free(t->x_to_b1, t->order + 1);
}
