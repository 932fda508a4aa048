/* SPDX-License-Identifier: MIT */
#include "series/power_bounds.h"

#include "series/jet.h"
#include "support/local.h"

/* Row k of the trajectory is about 2^(-ROW_BITS k) at small s. Divided by this factor, rows have similar size and
 * multiply faster. */
enum { ROW_BITS = 2 };

/* Computes rows 0..rows-1 of f g. The rows of f and g have at most `length` coefficients, and no power of s is cut off.
 * It concatenates the rows and computes one long product (Kronecker substitution). */
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

/* Computes V = 1/f, cut after `rows` rows and `length` coefficients, by Newton's iteration in u. Drops the errors of V,
 * because the proof allows any V. */
static void inverse_rows(arb_poly_struct *v, const arb_poly_struct *f, slong rows, slong length)
{
    arb_poly_struct *defect = jet_new(rows);
    arb_poly_inv_series(v, f, length, 4 * NORM_BITS);
    arb_poly_set_round(v, v, NORM_BITS);
    row_drop_error(v);
    for (slong known = 1; known < rows;) {
        const slong next = FLINT_MIN(2 * known, rows);
        /* V <- V - V (f V - 1); only rows `known` and above are new */
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

void power_evidence_init(struct power_evidence *e, const struct trajectory *t, slong block_rows, slong block_length)
{
    const slong rows = FLINT_MIN(block_rows, t->order + 1), length = FLINT_MIN(block_length, t->terms + 1);
    const slong products = FLINT_MIN(2 * rows - 1, t->order + 1); /* 1 - B V has no more rows than this */
    arb_poly_struct *block = jet_new(products);
    *e = (struct power_evidence){.t = t,
                                 .J = t->terms,
                                 .powers = t->x_to_a == t->x_to_b1 ? 1 : 2,
                                 .exponent = {law_elastic(&t->law), RATIO("t->law.b + 1", &t->law)},
                                 .rows = rows,
                                 .length = length,
                                 .products = products,
                                 .inverse = jet_new(products),
                                 .defect = jet_new(products)};
    for (slong k = 0; k < rows; k++)
        arb_poly_set_trunc_round(block + k, t->x + k, length, NORM_BITS);
    inverse_rows(e->inverse, block, rows, length);
    rows_mul(e->defect, block, e->inverse, products, length);
    arb_poly_add_si(e->defect, e->defect, -1, NORM_BITS);
    jet_free(block, products);
}

void power_evidence_clear(struct power_evidence *e)
{
    jet_free(e->inverse, e->products);
    jet_free(e->defect, e->products);
}

void power_bounds_init(struct power_bounds *b)
{
    FOR_ALL(arb, init, b->inverse, b->error[0], b->error[1], b->size[0], b->size[1], b->last_column);
}

void power_bounds_clear(struct power_bounds *b)
{
    FOR_ALL(arb, clear, b->inverse, b->error[0], b->error[1], b->size[0], b->size[1], b->last_column);
}

/* Computes column[j] = rho^j sum_k U^k |f_kj|, j < length, without the block_rows x block_length block. */
static void columns_of(mag_ptr column, slong length, const arb_poly_struct *f, slong rows, slong block_rows,
                       slong block_length, const mag_t U, const mag_t rho)
{
    LOCAL(mag, rho_j, x);
    mag_one(rho_j);
    for (slong j = 0; j < length; j++)
        mag_zero(column + j);
    for (slong k = rows - 1; k >= 0; k--)
        for (slong j = 0; j < length; j++) {
            mag_mul(column + j, column + j, U);
            if (j >= f[k].length || (k < block_rows && j < block_length))
                continue;
            arb_get_mag(x, f[k].coeffs + j);
            mag_add(column + j, column + j, x);
        }
    for (slong j = 0; j < length; j++) {
        mag_mul(column + j, column + j, rho_j);
        mag_mul(rho_j, rho_j, rho);
    }
}

/* Computes |f|, or |th(f)| if `theta` is 1, from the norms of the columns of f. */
static void columns_norm(arb_t y, mag_srcptr column, slong length, int theta)
{
    LOCAL(mag, sum, term);
    for (slong j = 0; j < length; j++) {
        mag_mul_ui(term, column + j, theta ? (ulong)j : 1);
        mag_add(sum, sum, term);
    }
    arb_set_upper(y, sum);
}

/* Computes nu = |V|/(1 - |1 - B V| - |Z - B| |V|) of (3.1). `column` is work space. Returns false if the divisor is not
 * above 1/2, because the bound would be useless. */
static bool bound_inverse(arb_t nu, mag_ptr column, const struct power_evidence *e, const mag_t U, const mag_t rho)
{
    LOCAL(arb, defect, outer, divisor);
    columns_of(column, e->length, e->inverse, e->rows, 0, 0, U, rho);
    columns_norm(nu, column, e->length, 0);
    columns_of(column, 2 * e->length - 1, e->defect, e->products, 0, 0, U, rho);
    columns_norm(defect, column, 2 * e->length - 1, 0);
    columns_of(column, e->J + 1, e->t->x, e->t->order + 1, e->rows, e->length, U, rho);
    columns_norm(outer, column, e->J + 1, 0);
    LET(divisor, NORM_BITS, "1 - (defect + outer*nu)", defect, outer, nu);
    arb_div(nu, nu, divisor, NORM_BITS);
    return HOLDS(NORM_BITS, "2*divisor > 1", divisor);
}

/* Computes the bound of |N| in (3.2), the sum of (j + p i) |Z^(i)| |P^(j)| over i + j > J. The coefficients of N up to
 * s^J vanish, and the factor of Z^(i) P^(j) in N is j - p i. */
static void bound_defect(arb_t y, mag_srcptr z, mag_srcptr power, slong J, struct ratio p)
{
    LOCAL(mag, exponent, sum, theta_sum, term, norm); /* sums of |P^(j)|, of j |P^(j)| for j > J - i */
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

/* Computes the bounds of (3.2), |E| <= nu |N|/(J + 1 - p nu |th(Z)|) and |Z^p| <= |P| + |E| for power i. */
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

bool power_bounds_prove(struct power_bounds *b, const struct power_evidence *e, double U, double rho)
{
    const slong rows = e->t->order + 1, columns = 2 * e->J + 1;
    LOCAL(mag, U_mag, rho_mag);
    mag_ptr z = _mag_vec_init(columns), power = _mag_vec_init(columns);
    mag_set_d(U_mag, U);
    mag_set_d(rho_mag, rho);
    bool bounded = bound_inverse(b->inverse, power, e, U_mag, rho_mag);
    if (bounded)
        columns_of(z, e->J + 1, e->t->x, rows, 0, 0, U_mag, rho_mag);
    for (int i = 0; i < e->powers && bounded; i++) {
        columns_of(power, e->J + 1, i == 0 ? e->t->x_to_a : e->t->x_to_b1, rows, 0, 0, U_mag, rho_mag);
        bounded = bound_power(b, i, e, z, power);
        if (i == 0) {
            arb_set_upper(b->last_column, power + e->J);
            arb_add(b->last_column, b->last_column, b->error[0], NORM_BITS);
        }
    }
    _mag_vec_clear(z, columns);
    _mag_vec_clear(power, columns);
    return bounded;
}
