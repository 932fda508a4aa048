/* SPDX-License-Identifier: MIT */
/* The recurrence of trajectory.h, for exact rationals and for interval (ball) arithmetic.
 *
 * Let x = t X, and let the derivation D multiply u^k s^j by e = k (b+1) + j (a+1). With x^b x' = (x^(b+1))'/(b+1), the
 * equation of motion gives for each coefficient
 *
 *   e (e+1) c[k][j] = -(e/(b+1)) [X^(b+1)][k-1][j] - [X^a][k][j-1].
 *
 * A power P = X^p obeys X P_u = p P X_u. With the rows P_k and X_k in s, for k >= 1,
 *
 *   P_k = p X_0^(p-1) X_k + Q_k,   k X_0 Q_k = sum_{0<i<k} ((p+1) i - k) X_i P_(k-i).
 *
 * A new row costs k products of polynomials. Its coefficients then follow one by one. In interval arithmetic,
 * row_sums.c computes the products of many rows. For spheres a = b+1 = 3/2, and the two powers are the same. */
#include "series/trajectory.h"

#include <math.h>

#include "series/jet.h"
#include "series/row_sums.h"
#include "support/console.h"
#include "support/formula.h"
#include "support/local.h"

/* ---- the ring: numbers are fmpq_t or arb_t, rows are fmpq_poly_t or arb_poly_t ---- */

struct ring {
    slong prec;  /* bits of a ball; 0: rationals */
    slong shift; /* the elastic constant is 2^shift; 0 for rationals */
    slong length;
};

static void *new_rows(const struct ring *ring, slong rows)
{
    if (ring->prec)
        return jet_new(rows);
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

static void free_rows(const struct ring *ring, void *row, slong rows)
{
    if (ring->prec)
        jet_free(row, rows);
    else
        trajectory_exact_free(row, rows);
}

static void *row_at(const struct ring *ring, void *rows, slong k)
{
    return ring->prec ? (void *)((arb_poly_struct *)rows + k) : (void *)((fmpq_poly_struct *)rows + k);
}

static void set_zero(void *x, const struct ring *ring)
{
    if (ring->prec)
        arb_zero(x);
    else
        fmpq_zero(x);
}

/* Computes x *= num/den. */
static void scale_number(void *x, slong num, slong den, const struct ring *ring)
{
    fmpq *const q = x;
    if (ring->prec) {
        arb_mul_si(x, x, num, ring->prec);
        arb_div_si(x, x, den, ring->prec);
    } else {
        EXACT(q, "q*num/den", q, num, den);
    }
}

/* Computes sum += x row[i] with x = num/den. */
static void add_coefficient(void *sum, const void *row, slong i, slong num, slong den, const struct ring *ring)
{
    LOCAL(fmpq, q);
    LOCAL(arb, ball);
    if (ring->prec) {
        arb_poly_get_coeff_arb(ball, row, i);
        scale_number(ball, num, den, ring);
        arb_add(sum, sum, ball, ring->prec);
    } else {
        fmpq_poly_get_coeff_fmpq(q, row, i);
        scale_number(q, num, den, ring);
        fmpq_add(sum, sum, q);
    }
}

static void set_coefficient(void *row, slong i, const void *x, const struct ring *ring)
{
    if (ring->prec)
        arb_poly_set_coeff_arb(row, i, x);
    else
        fmpq_poly_set_coeff_fmpq(row, i, x);
}

/* Computes sum = sum_i p_i q_(n-i) over all i. If `power` is not NULL, computes sum_(i>0) ((p+1) i - n) p_i q_(n-i)
 * times the denominator of its exponent. Rationals are added as integers over the product of the two common
 * denominators. */
static void set_convolution(void *sum, const void *p, const void *q, slong n, const struct ratio *power,
                            const struct ring *ring)
{
    const slong of_p = ring->prec ? ((const arb_poly_struct *)p)->length : ((const fmpq_poly_struct *)p)->length,
                of_q = ring->prec ? ((const arb_poly_struct *)q)->length : ((const fmpq_poly_struct *)q)->length;
    const slong first = FLINT_MAX(power != NULL, n - (of_q - 1)), last = FLINT_MIN(n, of_p - 1);
    if (ring->prec) {
        const arb_poly_struct *const x = p, *const y = q;
        LOCAL(arb, product);
        arb_zero(sum);
        if (!power && first <= last)
            arb_dot(sum, NULL, 0, x->coeffs + first, 1, y->coeffs + n - first, -1, last - first + 1, ring->prec);
        for (slong i = first; i <= last && power; i++) {
            arb_mul(product, x->coeffs + i, y->coeffs + n - i, ring->prec);
            arb_mul_si(product, product, row_sums_weight(*power, i, n), ring->prec);
            arb_add(sum, sum, product, ring->prec);
        }
    } else {
        const fmpq_poly_struct *const x = p, *const y = q;
        LOCAL(fmpz, num, product);
        for (slong i = first; i <= last; i++) {
            fmpz_mul(product, x->coeffs + i, y->coeffs + n - i);
            fmpz_mul_si(product, product, power ? row_sums_weight(*power, i, n) : 1);
            fmpz_add(num, num, product);
        }
        fmpz_mul(product, x->den, y->den);
        fmpq_set_fmpz_frac(sum, num, product);
    }
}

static void multiply_rows(void *z, const void *x, const void *y, const struct ring *ring)
{
    if (ring->prec)
        arb_poly_mullow(z, x, y, ring->length, ring->prec);
    else
        fmpq_poly_mullow(z, x, y, ring->length);
}

static void add_row(void *z, const void *x, const struct ring *ring)
{
    if (ring->prec)
        arb_poly_add(z, z, x, ring->prec);
    else
        fmpq_poly_add(z, z, x);
}

static void scale_row(void *row, slong num, slong den, const struct ring *ring)
{
    arb_poly_struct *const balls = row;
    for (slong i = 0; ring->prec && i < balls->length; i++)
        scale_number(balls->coeffs + i, num, den, ring);
    if (!ring->prec) {
        fmpq_poly_scalar_mul_si(row, row, num);
        fmpq_poly_scalar_div_si(row, row, den);
    }
}

static void invert_row(void *y, const void *x, const struct ring *ring)
{
    if (ring->prec)
        arb_poly_inv_series(y, x, ring->length, ring->prec);
    else
        fmpq_poly_inv_series(y, x, ring->length);
}

/* Drops the digits of each ball below its error, which grows from row to row. Products become cheaper. */
static void trim_row(void *row, const struct ring *ring)
{
    arb_poly_struct *const balls = row;
    for (slong i = 0; ring->prec && i < balls->length; i++)
        arb_trim(balls->coeffs + i, balls->coeffs + i);
}

/* ---- the recurrence ---- */

struct power {
    struct ratio p;
    void *row;             /* P_k */
    void *slope, *rest;    /* p X_0^(p-1), and Q_k of the current row */
    struct row_sums *sums; /* sums for balls with many rows; otherwise NULL */
};

static void set_rest(struct power *power, void *x, const void *x0_inverse, void *product, slong k,
                     const struct ring *ring)
{
    if (power->sums)
        row_sums_next(power->rest, power->sums, x, power->row, k);
    else if (ring->prec)
        arb_poly_zero(power->rest);
    else
        fmpq_poly_zero(power->rest);
    for (slong i = 1; i < k && !power->sums; i++) {
        multiply_rows(product, row_at(ring, x, i), row_at(ring, power->row, k - i), ring);
        scale_row(product, row_sums_weight(power->p, i, k), 1, ring);
        add_row(power->rest, product, ring);
    }
    multiply_rows(power->rest, power->rest, x0_inverse, ring);
    scale_row(power->rest, 1, k * power->p.den, ring);
}

/* Fills the rows 0..order of X and of its powers X^a and X^(b+1). If a = b+1 the two powers are the same. */
static void fill_rows(void *row, void *powers_row[2], slong order, const struct cor_exponents *law,
                      const struct ring *ring)
{
    /* e = e_num/d with e_num = k (b+1) d + j (a+1) d */
    const slong terms = ring->length - 1, d = law->denominator, du = law->damping + d, ds = law->elastic + d;
    const int powers = law->elastic == law->damping + d ? 1 : 2;
    struct row_sums sums[2];
    struct power power[2], *const elastic = power, *const damping = power + powers - 1;
    enum { INVERSE, PRODUCT, SLOPE, REST = SLOPE + 2, WORK = REST + 2 };
    void *const work = new_rows(ring, WORK), *const x0_inverse = row_at(ring, work, INVERSE);
    LOCAL(fmpq, exact);
    LOCAL(arb, ball);
    void *const x = ring->prec ? (void *)ball : (void *)exact;
    EXACT(exact, "1");
    arb_one(ball);
    set_coefficient(row, 0, x, ring);
    for (int i = 0; i < powers; i++) {
        powers_row[i] = new_rows(ring, order + 1);
        power[i] = (struct power){i == 0 ? law_elastic(law) : RATIO("law->b + 1", law), powers_row[i],
                                  row_at(ring, work, SLOPE + i), row_at(ring, work, REST + i), NULL};
        set_coefficient(power[i].row, 0, x, ring);
        if (ring->prec && order + 1 >= ROW_SUMS_MIN_ROWS) {
            power[i].sums = &sums[i];
            row_sums_init(power[i].sums, power[i].p, order + 1, ring->length, ring->prec);
        }
    }
    powers_row[1] = damping->row;

    for (slong j = 1; j <= terms; j++) {
        progress("elastic trajectory", j, terms);
        set_zero(x, ring);
        add_coefficient(x, elastic->row, j - 1, -d * d, j * ds * (j * ds + d), ring);
        if (ring->prec)
            arb_mul_2exp_si(x, x, ring->shift);
        set_coefficient(row, j, x, ring);
        for (int i = 0; i < powers; i++) { /* j P_j = sum_i ((p+1) i - j) x_i P_(j-i) */
            set_convolution(x, row, power[i].row, j, &power[i].p, ring);
            scale_number(x, 1, j * power[i].p.den, ring);
            set_coefficient(power[i].row, j, x, ring);
        }
    }
    invert_row(x0_inverse, row, ring);
    for (int i = 0; i < powers; i++) {
        multiply_rows(power[i].slope, power[i].row, x0_inverse, ring);
        scale_row(power[i].slope, power[i].p.num, power[i].p.den, ring);
    }

    for (slong k = 1; k <= order; k++) {
        void *const next = row_at(ring, row, k);
        progress("trajectory rows", k, order);
        for (int i = 0; i < powers; i++)
            set_rest(&power[i], row, x0_inverse, row_at(ring, work, PRODUCT), k, ring);
        for (slong j = 0; j <= terms; j++) {
            const slong e = k * du + j * ds;
            set_zero(x, ring);
            if (j > 0) { /* 2^shift [X^a][k][j-1] d/e */
                set_convolution(x, elastic->slope, next, j - 1, NULL, ring);
                add_coefficient(x, elastic->rest, j - 1, 1, 1, ring);
                if (ring->prec)
                    arb_mul_2exp_si(x, x, ring->shift);
                scale_number(x, d, e, ring);
            }
            add_coefficient(x, row_at(ring, damping->row, k - 1), j, d, du, ring);
            scale_number(x, -d, e + d, ring);
            set_coefficient(next, j, x, ring);
        }
        trim_row(next, ring);
        for (int i = 0; i < powers; i++) {
            void *const p = row_at(ring, power[i].row, k);
            multiply_rows(p, power[i].slope, next, ring);
            add_row(p, power[i].rest, ring);
            trim_row(p, ring);
        }
    }
    free_rows(ring, work, WORK);
    for (int i = 0; i < powers; i++)
        if (power[i].sums)
            row_sums_clear(power[i].sums);
}

fmpq_poly_struct *trajectory_exact(slong order, slong terms, const struct cor_exponents *law)
{
    const struct ring ring = {0, 0, terms + 1};
    fmpq_poly_struct *const row = new_rows(&ring, order + 1);
    void *power[2];
    fill_rows(row, power, order, law, &ring);
    free_rows(&ring, power[0], order + 1);
    if (power[1] != power[0])
        free_rows(&ring, power[1], order + 1);
    return row;
}

void trajectory_init(struct trajectory *t, slong order, slong terms, const struct cor_exponents *law, slong prec)
{
    const double farthest = law_elastic_radius(law) * law_elastic_time(law);
    const slong shift =
        (slong)floor(log2(farthest) * (double)(law->elastic + law->denominator) / (double)law->denominator);
    const struct ring ring = {prec, shift, terms + 1};
    void *power[2];
    *t = (struct trajectory){*law, order, terms, prec, shift, jet_new(order + 1), NULL, NULL};
    fill_rows(t->x, power, order, law, &ring);
    t->x_to_a = power[0];
    t->x_to_b1 = power[1];
}

void trajectory_clear(struct trajectory *t)
{
    jet_free(t->x, t->order + 1);
    jet_free(t->x_to_a, t->order + 1);
    if (t->x_to_b1 != t->x_to_a)
        jet_free(t->x_to_b1, t->order + 1);
}
