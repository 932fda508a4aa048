/* SPDX-License-Identifier: MIT */
#include "series/trajectory.h"

#include "series/jet.h"
#include "series/row_sums.h"
#include "support/console.h"

#include <math.h>

#define TRAJECTORY_PROGRESS progress

/* The recurrence in exact rationals */
#define ROWS exact_rows
#define POWER exact_power
#define POWER_INIT exact_power_init
#define POWER_CLEAR exact_power_clear
#define POWER_FIRST_ROW exact_power_first_row
#define POWER_SUM exact_power_sum
#define POWER_REST exact_power_rest
#define POWER_FINISH_ROW exact_power_finish_row
#define POLY fmpq_poly_struct
#define NUMBER fmpq_t
#define PREC_PARAMETER
#define number_strengthen(x) (void)(x)
#define SHIFT_PARAMETER
#define PREC
#define poly_init fmpq_poly_init
#define poly_clear fmpq_poly_clear
#define poly_zero fmpq_poly_zero
#define poly_get(x, p, i) fmpq_poly_get_coeff_fmpq(x, p, i)
#define poly_set(p, i, x) fmpq_poly_set_coeff_fmpq(p, i, x)
#define poly_mul fmpq_poly_mullow
#define poly_add fmpq_poly_add
#define poly_scale_si fmpq_poly_scalar_mul_si
#define poly_unscale_si fmpq_poly_scalar_div_si
#define poly_inverse fmpq_poly_inv_series
#define poly_dot exact_dot
#define poly_trim(p) (void)(p)
#define number_init fmpq_init
#define number_clear fmpq_clear
#define number_zero fmpq_zero
#define number_one fmpq_one
#define number_mul fmpq_mul
#define number_add fmpq_add
#define number_mul_si(y, x, n) exact_mul_si(y, x, n)
#define number_div_si(y, x, n) exact_div_si(y, x, n)

static void exact_mul_si(fmpq_t y, const fmpq_t x, slong n)
{
    fmpz_t z;
    fmpz_init_set_si(z, n);
    fmpq_mul_fmpz(y, x, z);
    fmpz_clear(z);
}

static void exact_div_si(fmpq_t y, const fmpq_t x, slong n)
{
    fmpz_t z;
    fmpz_init_set_si(z, n);
    fmpq_div_fmpz(y, x, z);
    fmpz_clear(z);
}

/* sum_i p_i q_(n-i), computed with integers over the two common denominators */
static void exact_dot(fmpq_t sum, const fmpq_poly_struct *p, const fmpq_poly_struct *q, slong n)
{
    fmpz_t num, den;
    fmpz_init(num);
    fmpz_init(den);
    const slong first = FLINT_MAX(0, n - (q->length - 1)), last = FLINT_MIN(n, p->length - 1);
    for (slong i = first; i <= last; i++)
        fmpz_addmul(num, p->coeffs + i, q->coeffs + n - i);
    fmpz_mul(den, p->den, q->den);
    fmpq_set_fmpz_frac(sum, num, den);
    fmpz_clear(num);
    fmpz_clear(den);
}

#define ROW_SUMS
#define row_sums_begin(power, rows, length) (void)(length)
#define row_sums_end(power) (void)(power)
#define row_sum(sum, power, x, k, length) exact_power_sum(sum, power, x, k, length)

#include "series/trajectory_rows.inc"

#undef ROWS
#undef ROW_SUMS
#undef row_sums_begin
#undef row_sums_end
#undef row_sum
#undef POWER
#undef POWER_INIT
#undef POWER_CLEAR
#undef POWER_FIRST_ROW
#undef POWER_SUM
#undef POWER_REST
#undef POWER_FINISH_ROW
#undef POLY
#undef NUMBER
#undef PREC_PARAMETER
#undef PREC
#undef poly_init
#undef poly_clear
#undef poly_zero
#undef poly_get
#undef poly_set
#undef poly_mul
#undef poly_add
#undef poly_scale_si
#undef poly_unscale_si
#undef poly_inverse
#undef poly_dot
#undef poly_trim
#undef number_strengthen
#undef SHIFT_PARAMETER
#undef number_init
#undef number_clear
#undef number_zero
#undef number_one
#undef number_mul
#undef number_add
#undef number_mul_si
#undef number_div_si

/* The recurrence in interval (ball) arithmetic */
#define ROWS ball_rows
#define POWER ball_power
#define POWER_INIT ball_power_init
#define POWER_CLEAR ball_power_clear
#define POWER_FIRST_ROW ball_power_first_row
#define POWER_SUM ball_power_sum
#define POWER_REST ball_power_rest
#define POWER_FINISH_ROW ball_power_finish_row
#define POLY arb_poly_struct
#define NUMBER arb_t
#define PREC_PARAMETER , slong prec
#define PREC , prec
#define number_strengthen(x) arb_mul_2exp_si(x, x, shift)
#define SHIFT_PARAMETER slong shift,
#define poly_init arb_poly_init
#define poly_clear arb_poly_clear
#define poly_zero arb_poly_zero
#define poly_get(x, p, i) arb_poly_get_coeff_arb(x, p, i)
#define poly_set(p, i, x) arb_poly_set_coeff_arb(p, i, x)
#define poly_mul(y, p, q, n) arb_poly_mullow(y, p, q, n, prec)
#define poly_add(y, p, q) arb_poly_add(y, p, q, prec)
#define poly_scale_si(y, p, n) ball_scale_si(y, p, n, prec)
#define poly_unscale_si(y, p, n) ball_unscale_si(y, p, n, prec)
#define poly_inverse(y, p, n) arb_poly_inv_series(y, p, n, prec)
#define poly_dot(y, p, q, n) ball_dot(y, p, q, n, prec)
#define poly_trim ball_trim
#define number_init arb_init
#define number_clear arb_clear
#define number_zero arb_zero
#define number_one arb_one
#define number_mul(y, x, z) arb_mul(y, x, z, prec)
#define number_add(y, x, z) arb_add(y, x, z, prec)
#define number_mul_si(y, x, n) arb_mul_si(y, x, n, prec)
#define number_div_si(y, x, n) arb_div_si(y, x, n, prec)

static void ball_scale_si(arb_poly_struct *y, const arb_poly_struct *p, slong n, slong prec)
{
    arb_poly_set(y, p);
    for (slong i = 0; i < y->length; i++)
        arb_mul_si(y->coeffs + i, y->coeffs + i, n, prec);
}

static void ball_unscale_si(arb_poly_struct *y, const arb_poly_struct *p, slong n, slong prec)
{
    arb_poly_set(y, p);
    for (slong i = 0; i < y->length; i++)
        arb_div_si(y->coeffs + i, y->coeffs + i, n, prec);
}

static void ball_dot(arb_t sum, const arb_poly_struct *p, const arb_poly_struct *q, slong n, slong prec)
{
    const slong first = FLINT_MAX(0, n - (q->length - 1)), last = FLINT_MIN(n, p->length - 1);
    if (last < first)
        arb_zero(sum);
    else
        arb_dot(sum, NULL, 0, p->coeffs + first, 1, q->coeffs + n - first, -1, last - first + 1, prec);
}

/* Rounding errors grow from row to row. Digits below them are dropped, which makes products cheaper. */
static void ball_trim(arb_poly_struct *p)
{
    for (slong i = 0; i < p->length; i++)
        arb_trim(p->coeffs + i, p->coeffs + i);
}

#define ROW_SUMS struct row_sums sums[1];
#define row_sums_begin(power, rows, length) row_sums_init((power)->sums, (power)->p, rows, length, prec)
#define row_sums_end(power) row_sums_clear((power)->sums)
#define row_sum(sum, power, x, k, length) ball_row_sum(sum, power, x, k, length, prec)

struct ball_power;
static void ball_row_sum(arb_poly_struct *sum, struct ball_power *power, const arb_poly_struct *x, slong k,
                         slong length, slong prec);

#include "series/trajectory_rows.inc"

static void ball_row_sum(arb_poly_struct *sum, struct ball_power *power, const arb_poly_struct *x, slong k,
                         slong length, slong prec)
{
    if (power->sums->rows < ROW_SUMS_MIN_ROWS)
        ball_power_sum(sum, power, x, k, length, prec);
    else
        row_sums_next(sum, power->sums, x, power->row, k);
}

void trajectory_exact(fmpq_poly_struct *row, slong order, slong terms, const struct law *law)
{
    exact_rows(row, NULL, NULL, order, terms, law);
}

void trajectory_init(struct trajectory *t, slong order, slong terms, const struct law *law, slong prec)
{
    t->law = *law;
    t->order = order;
    t->terms = terms;
    t->prec = prec;
    t->x = jet_new(order + 1);
    const double farthest = law_elastic_radius(law) * law_elastic_time(law);
    t->shift = (slong)floor(log2(farthest) * (double)(law->ad + law->d) / (double)law->d);
    ball_rows(t->shift, t->x, &t->x_to_a, &t->x_to_b1, order, terms, law, prec);
}

void trajectory_clear(struct trajectory *t)
{
    jet_free(t->x, t->order + 1);
    jet_free(t->x_to_a, t->order + 1);
    if (t->x_to_b1 != t->x_to_a)
        jet_free(t->x_to_b1, t->order + 1);
}
