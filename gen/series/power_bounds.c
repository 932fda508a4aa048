/* SPDX-License-Identifier: MIT */
#include "series/power_bounds.h"

#include "series/jet.h"
#include "support/local.h"

/* Row k of the trajectory is about 2^(-ROW_BITS k) at small s. Without this factor, coefficients have similar size and
 * multiply faster. */
enum { ROW_BITS = 2 };

static void magnitudes_init(struct magnitudes *g, slong rows, slong length)
{
    g->rows = rows;
    g->length = length;
    g->m = _mag_vec_init(rows * length);
}

static void magnitudes_clear(struct magnitudes *g)
{
    _mag_vec_clear(g->m, g->rows * g->length);
}

/* column[j] = rho^j sum_k U^k |f_kj|, j < length */
static void magnitudes_columns(mag_ptr column, const struct magnitudes *g, const mag_t U, const mag_t rho)
{
    LOCAL(mag, rho_j);
    mag_one(rho_j);
    for (slong j = 0; j < g->length; j++)
        mag_zero(column + j);
    for (slong k = g->rows - 1; k >= 0; k--)
        for (slong j = 0; j < g->length; j++) {
            mag_mul(column + j, column + j, U);
            mag_add(column + j, column + j, g->m + k * g->length + j);
        }
    for (slong j = 0; j < g->length; j++) {
        mag_mul(column + j, column + j, rho_j);
        mag_mul(rho_j, rho_j, rho);
    }
}

static void magnitudes_of_rows(struct magnitudes *g, const arb_poly_struct *row)
{
    for (slong k = 0; k < g->rows; k++)
        for (slong j = 0; j < row[k].length; j++)
            arb_get_mag(g->m + k * g->length + j, row[k].coeffs + j);
}

/* Rows 0..rows-1 of f g, complete in s if both have at most `length` coefficients. One long product of the concatenated
 * rows computes them (Kronecker substitution). */
static void rows_mul(arb_poly_struct *product, const arb_poly_struct *f, const arb_poly_struct *g, slong rows,
                     slong length)
{
    const slong stride = 2 * length - 1;
    const arb_poly_struct *factor[2] = {f, g};
    arb_poly_t packed[2];
    for (int i = 0; i < 2; i++) {
        arb_poly_init2(packed[i], rows * stride);
        for (slong k = 0; k < rows; k++)
            for (slong j = 0; j < factor[i][k].length; j++)
                arb_mul_2exp_si(packed[i]->coeffs + k * stride + j, factor[i][k].coeffs + j, ROW_BITS * k);
        _arb_poly_set_length(packed[i], rows * stride);
        _arb_poly_normalise(packed[i]);
    }
    arb_poly_mullow(packed[0], packed[0], packed[1], rows * stride, NORM_BITS);
    for (slong k = 0; k < rows; k++) {
        arb_poly_zero(product + k);
        for (slong j = 0; j < stride && k * stride + j < packed[0]->length; j++)
            arb_poly_set_coeff_arb(product + k, j, packed[0]->coeffs + k * stride + j);
        arb_poly_scalar_mul_2exp_si(product + k, product + k, -ROW_BITS * k);
    }
    FOR_ALL(arb_poly, clear, packed[0], packed[1]);
}

static void row_drop_error(arb_poly_struct *row)
{
    for (slong j = 0; j < row->length; j++)
        mag_zero(arb_radref(row->coeffs + j));
}

/* V = 1/f, cut after `rows` rows and `length` coefficients, by Newton's iteration in u. The proof allows any V, so the
 * errors of V are dropped. */
static void inverse_rows(arb_poly_struct *v, const arb_poly_struct *f, slong rows, slong length)
{
    arb_poly_struct *defect = jet_new(rows);
    arb_poly_inv_series(v, f, length, 4 * NORM_BITS);
    arb_poly_set_round(v, v, NORM_BITS);
    row_drop_error(v);
    for (slong known = 1; known < rows;) {
        const slong next = FLINT_MIN(2 * known, rows);
        /* V <- V - V (f V - 1); only the rows from `known` on are new */
        rows_mul(defect, f, v, next, length);
        for (slong k = 0; k < next; k++) {
            arb_poly_truncate(defect + k, length);
            if (k < known)
                arb_poly_zero(defect + k);
            row_drop_error(defect + k);
        }
        rows_mul(defect, defect, v, next, length);
        for (slong k = known; k < next; k++) {
            arb_poly_truncate(defect + k, length);
            arb_poly_neg(v + k, defect + k);
            row_drop_error(v + k);
        }
        known = next;
    }
    jet_free(defect, rows);
}

/* 1 - B V has fewer than 2 `rows` rows. */
static void evidence_block(struct power_evidence *e, const struct trajectory *t, slong rows, slong length)
{
    const slong products = FLINT_MIN(2 * rows - 1, t->order + 1);
    arb_poly_struct *block = jet_new(products), *v = jet_new(products), *product = jet_new(products);
    magnitudes_init(&e->inverse, rows, length);
    magnitudes_init(&e->defect, products, 2 * length - 1);
    magnitudes_init(&e->outer, e->z.rows, e->z.length);
    for (slong k = 0; k < e->z.rows; k++)
        for (slong j = k < rows ? length : 0; j < e->z.length; j++)
            mag_set(e->outer.m + k * e->z.length + j, e->z.m + k * e->z.length + j);
    for (slong k = 0; k < rows; k++)
        arb_poly_set_trunc_round(block + k, t->x + k, length, NORM_BITS);
    inverse_rows(v, block, rows, length);
    rows_mul(product, block, v, products, length);
    arb_poly_add_si(product, product, -1, NORM_BITS);
    magnitudes_of_rows(&e->inverse, v);
    magnitudes_of_rows(&e->defect, product);
    jet_free(block, products);
    jet_free(v, products);
    jet_free(product, products);
}

void power_evidence_init(struct power_evidence *e, const struct trajectory *t, slong block_rows, slong block_length)
{
    const slong rows = t->order + 1, length = t->terms + 1;
    const arb_poly_struct *power[2] = {t->x_to_a, t->x_to_b1};
    const int powers = t->x_to_a == t->x_to_b1 ? 1 : 2;
    e->J = t->terms;
    e->powers = powers;
    e->exponent[0] = t->law.a;
    e->exponent[1] = RATIO("t->law.b + 1", t->law.b);
    magnitudes_init(&e->z, rows, length);
    magnitudes_of_rows(&e->z, t->x);
    for (int i = 0; i < powers; i++) {
        magnitudes_init(&e->p[i], rows, length);
        magnitudes_of_rows(&e->p[i], power[i]);
    }
    evidence_block(e, t, FLINT_MIN(block_rows, rows), FLINT_MIN(block_length, length));
}

void power_evidence_clear(struct power_evidence *e)
{
    magnitudes_clear(&e->z);
    for (int i = 0; i < e->powers; i++)
        magnitudes_clear(&e->p[i]);
    magnitudes_clear(&e->inverse);
    magnitudes_clear(&e->defect);
    magnitudes_clear(&e->outer);
}

void power_bounds_init(struct power_bounds *b)
{
    FOR_ALL(arb, init, b->inverse, b->error[0], b->error[1], b->size[0], b->size[1], b->last_column);
}

void power_bounds_clear(struct power_bounds *b)
{
    FOR_ALL(arb, clear, b->inverse, b->error[0], b->error[1], b->size[0], b->size[1], b->last_column);
}

/* |f|, or |th(f)| with theta = 1, from the norms of the columns of f */
static void columns_norm(arb_t y, mag_srcptr column, slong length, int theta)
{
    LOCAL(mag, sum, term);
    for (slong j = 0; j < length; j++) {
        mag_mul_ui(term, column + j, theta ? (ulong)j : 1);
        mag_add(sum, sum, term);
    }
    arb_set_upper(y, sum);
}

static void magnitudes_norm(arb_t y, const struct magnitudes *f, const mag_t U, const mag_t rho)
{
    mag_ptr column = _mag_vec_init(f->length);
    magnitudes_columns(column, f, U, rho);
    columns_norm(y, column, f->length, 0);
    _mag_vec_clear(column, f->length);
}

/* (3.1): nu = |V|/(1 - |1 - B V| - |Z - B| |V|). With a divisor below 1/2 the bound would be useless. */
static bool bound_inverse(arb_t nu, const struct power_evidence *e, const mag_t U, const mag_t rho)
{
    LOCAL(arb, defect, outer, divisor);
    magnitudes_norm(nu, &e->inverse, U, rho);
    magnitudes_norm(outer, &e->outer, U, rho);
    magnitudes_norm(defect, &e->defect, U, rho);
    LET(divisor, NORM_BITS, "1 - (defect + outer*nu)", defect, outer, nu);
    arb_div(nu, nu, divisor, NORM_BITS);
    return HOLDS(NORM_BITS, "2*divisor > 1", divisor);
}

/* (3.2): |N| <= sum over i + j > J of (j + p i) |Z^(i)| |P^(j)|. The coefficients of N up to s^J vanish, and the factor
 * of Z^(i) P^(j) in N is j - p i. */
static void bound_defect(arb_t y, mag_srcptr z, mag_srcptr power, slong J, struct ratio p)
{
    LOCAL(mag, exponent, sum, theta_sum, term, norm); /* sum of |P^(j)|, and of j |P^(j)|, j > J - i */
    LOCAL(arb, ratio);
    LET(ratio, NORM_BITS, "p", p);
    arb_get_mag(exponent, ratio);
    for (slong i = 1; i <= J; i++) {
        const slong j = J + 1 - i;
        mag_add(sum, sum, power + j);
        mag_mul_ui(term, power + j, (ulong)j);
        mag_add(theta_sum, theta_sum, term);
        mag_mul_ui(term, exponent, (ulong)i);
        mag_mul(term, term, sum);
        mag_add(term, term, theta_sum);
        mag_mul(term, term, z + i);
        mag_add(norm, norm, term);
    }
    arb_set_upper(y, norm);
}

/* (3.2): |E| <= nu |N|/(J + 1 - p nu |th(Z)|) and |Z^p| <= |P| + |E| for power i. */
static bool bound_power(struct power_bounds *b, int i, const struct power_evidence *e, mag_srcptr z, mag_srcptr power)
{
    const struct ratio p = e->exponent[i];
    LOCAL(arb, divisor, size);
    columns_norm(divisor, z, e->J + 1, 1);
    LET(divisor, NORM_BITS, "e->J + 1 - divisor*b->inverse*p", e->J, divisor, b->inverse, p);
    bound_defect(b->error[i], z, power, e->J, p);
    LET(b->error[i], NORM_BITS, "b->error[i]*b->inverse/divisor", b->error[i], b->inverse, divisor);
    columns_norm(size, power, e->J + 1, 0);
    arb_add(b->size[i], size, b->error[i], NORM_BITS);
    return arb_is_positive(divisor);
}

bool power_bounds_prove(struct power_bounds *b, const struct power_evidence *e, const arb_t U, const arb_t rho)
{
    LOCAL(mag, U_mag, rho_mag);
    mag_ptr z = _mag_vec_init(e->J + 1), power = _mag_vec_init(e->J + 1);
    arb_get_mag(U_mag, U);
    arb_get_mag(rho_mag, rho);
    bool bounded = bound_inverse(b->inverse, e, U_mag, rho_mag);
    if (bounded)
        magnitudes_columns(z, &e->z, U_mag, rho_mag);
    for (int i = 0; i < e->powers && bounded; i++) {
        magnitudes_columns(power, &e->p[i], U_mag, rho_mag);
        bounded = bound_power(b, i, e, z, power);
        if (i == 0) {
            arb_set_upper(b->last_column, power + e->J);
            arb_add(b->last_column, b->last_column, b->error[0], NORM_BITS);
        }
    }
    _mag_vec_clear(z, e->J + 1);
    _mag_vec_clear(power, e->J + 1);
    return bounded;
}
