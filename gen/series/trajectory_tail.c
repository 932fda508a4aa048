/* SPDX-License-Identifier: MIT */
/* The proof of the truncation error of a trajectory.
 *
 * Work in the Banach algebra A of power series in s whose coefficients are polynomials in u cut after
 * u^order, with the norm |f| = sum |f_kj| U^k rho^j. Let Z be the truncated X (s-degree J), and X = Z + R.
 * The tail R is the fixed point of
 *
 *   G(R)_kj = -([X^(b+1)]_(k-1),j / (b+1) + 2^shift [X^a]_k,(j-1) / e) / (e + 1),
 *                                                              e = k(b+1) + j(a+1), j > J,
 *
 * and the iteration of G from 0 makes one coefficient after the other right. If G maps the ball |R| <= delta of A into
 * itself, delta therefore bounds R. With nu >= |1/Z| and, for p = a and b+1, E = Z^p - P (P the truncated row
 * polynomial of X^p, which agrees with Z^p up to s^J):
 *
 *   |(Z+R)^p - Z^p| <= |Z^p| ((1 - nu |R|)^(-p) - 1),
 *   Z th(E) - p E th(Z) = -N,  N = Z th(P) - p P th(Z) = O(s^(J+1)),  th = s d/ds,
 *   so |E| <= nu |N| / (J + 1 - p nu |th(Z)|),
 *   nu = |V|/(1 - |1 - Z V|) for any V; here the truncated series of 1/X.
 *
 * The radius rho may come close to the nearest singularity, for spheres the pole of 1/X at s = 2^(a+1) s_0. The bound
 * is therefore about as small as the remainder of the series. */
#include "series/trajectory.h"

#include "series/jet.h"

#include <math.h>

/* Norms are needed to a few digits only. The products below use midpoints rounded to this number of bits. */
static const slong NORM_BITS = 64;

/* Magnitudes of the coefficients of a family of row polynomials, which are summed with many weights */
struct magnitudes {
    slong rows, length;
    mag_ptr m; /* rows * length */
};

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

/* sum_k U^k sum_j j^theta |f_kj| rho^j. */
static void magnitudes_norm(mag_t norm, const struct magnitudes *g, const mag_t U, const mag_t rho, int theta)
{
    mag_t row, term;
    mag_init(row);
    mag_init(term);
    mag_zero(norm);
    for (slong k = g->rows - 1; k >= 0; k--) {
        mag_zero(row);
        for (slong j = g->length - 1; j >= 0; j--) {
            mag_mul(row, row, rho);
            mag_set(term, g->m + k * g->length + j);
            if (theta)
                mag_mul_ui(term, term, (ulong)j);
            mag_add(row, row, term);
        }
        mag_mul(norm, norm, U);
        mag_add(norm, norm, row);
    }
    mag_clear(row);
    mag_clear(term);
}

static void magnitudes_of_rows(struct magnitudes *g, const arb_poly_struct *row)
{
    for (slong k = 0; k < g->rows; k++)
        for (slong j = 0; j < row[k].length; j++)
            arb_get_mag(g->m + k * g->length + j, row[k].coeffs + j);
}

/* All data of one trajectory that the bound needs, except the weights */
struct evidence {
    slong J;
    struct magnitudes z, inverse, defect; /* Z, V, 1 - Z V */
    struct magnitudes p[2], n[2];         /* P and N for p = a, b + 1 */
    struct ratio exponent[2];
    int powers; /* 1 if both powers are the same */
};

/* Row k of the trajectory is about 2^(-ROW_BITS k) at small s. Without this factor, coefficients have similar size and
 * multiply faster. */
static const slong ROW_BITS = 2;

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
    arb_poly_clear(packed[0]);
    arb_poly_clear(packed[1]);
}

static void row_drop_error(arb_poly_struct *row)
{
    for (slong j = 0; j < row->length; j++)
        mag_zero(arb_radref(row->coeffs + j));
}

/* V, the truncated series of 1/X, by Newton's iteration in u. The proof allows any V, so the errors of V are
 * dropped. */
static arb_poly_struct *inverse_rows(const arb_poly_struct *x, slong rows, slong length)
{
    arb_poly_struct *v = jet_new(rows), *defect = jet_new(rows);
    arb_poly_inv_series(v, x, length, 4 * NORM_BITS);
    arb_poly_set_round(v, v, NORM_BITS);
    row_drop_error(v);
    for (slong known = 1; known < rows;) {
        const slong next = FLINT_MIN(2 * known, rows);
        /* V <- V - V (X V - 1); only the rows from `known` on are new */
        rows_mul(defect, x, v, next, length);
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
    return v;
}

/* th(f) = s f'. */
static arb_poly_struct *theta_rows(const arb_poly_struct *f, slong rows)
{
    arb_poly_struct *g = jet_new(rows);
    for (slong k = 0; k < rows; k++) {
        arb_poly_set(g + k, f + k);
        for (slong j = 0; j < g[k].length; j++)
            arb_mul_si(g[k].coeffs + j, g[k].coeffs + j, j, NORM_BITS);
    }
    return g;
}

static arb_poly_struct *rounded_rows(const arb_poly_struct *f, slong rows)
{
    arb_poly_struct *g = jet_new(rows);
    for (slong k = 0; k < rows; k++)
        arb_poly_set_round(g + k, f + k, NORM_BITS);
    return g;
}

static void evidence_init(struct evidence *e, const struct trajectory *t)
{
    const slong rows = t->order + 1, length = t->terms + 1;
    const arb_poly_struct *power[2] = {t->x_to_a, t->x_to_b1};
    const struct ratio one = {1, 1};
    arb_poly_struct *x = rounded_rows(t->x, rows), *theta_x = theta_rows(x, rows);
    arb_poly_struct *v = inverse_rows(x, rows, length);
    arb_poly_struct *product = jet_new(rows), *other = jet_new(rows);
    arb_t scale;
    arb_init(scale);

    e->J = t->terms;
    e->powers = t->x_to_a == t->x_to_b1 ? 1 : 2;
    e->exponent[0] = t->law.a;
    e->exponent[1] = ratio_add(t->law.b, one);

    magnitudes_init(&e->z, rows, length);
    magnitudes_of_rows(&e->z, x);
    magnitudes_init(&e->inverse, rows, length);
    magnitudes_of_rows(&e->inverse, v);
    magnitudes_init(&e->defect, rows, 2 * length);
    rows_mul(product, x, v, rows, length);
    arb_poly_add_si(product, product, -1, NORM_BITS);
    magnitudes_of_rows(&e->defect, product);
    for (int i = 0; i < e->powers; i++) {
        arb_poly_struct *p = rounded_rows(power[i], rows), *theta_p = theta_rows(p, rows);
        magnitudes_init(&e->p[i], rows, length);
        magnitudes_of_rows(&e->p[i], p);
        magnitudes_init(&e->n[i], rows, 2 * length);
        arb_set_ratio(scale, e->exponent[i], NORM_BITS);
        rows_mul(product, x, theta_p, rows, length);
        rows_mul(other, p, theta_x, rows, length);
        for (slong k = 0; k < rows; k++) {
            arb_poly_scalar_mul(other + k, other + k, scale, NORM_BITS);
            arb_poly_sub(product + k, product + k, other + k, NORM_BITS);
            /* Up to s^J the two agree exactly; nonzero intervals there are rounding errors. */
            for (slong j = 0; j < FLINT_MIN(length, product[k].length); j++)
                arb_zero(product[k].coeffs + j);
        }
        magnitudes_of_rows(&e->n[i], product);
        jet_free(p, rows);
        jet_free(theta_p, rows);
    }
    jet_free(x, rows);
    jet_free(theta_x, rows);
    jet_free(v, rows);
    jet_free(product, rows);
    jet_free(other, rows);
    arb_clear(scale);
}

static void evidence_clear(struct evidence *e)
{
    magnitudes_clear(&e->z);
    magnitudes_clear(&e->inverse);
    magnitudes_clear(&e->defect);
    for (int i = 0; i < e->powers; i++) {
        magnitudes_clear(&e->p[i]);
        magnitudes_clear(&e->n[i]);
    }
}

static void arb_set_upper(arb_t y, const mag_t m)
{
    arf_set_mag(arb_midref(y), m);
    mag_zero(arb_radref(y));
}

/* y = (1 - eta)^(-p) - 1, computed by expm1 so that a tiny eta does not cancel */
static void power_growth(arb_t y, const arb_t eta, struct ratio p)
{
    arb_t q;
    arb_init(q);
    arb_neg(y, eta);
    arb_log1p(y, y, NORM_BITS);
    arb_set_ratio(q, p, NORM_BITS);
    arb_mul(y, y, q, NORM_BITS);
    arb_neg(y, y);
    arb_expm1(y, y, NORM_BITS);
    arb_clear(q);
}

/* The proof for one choice of weights: delta with G(ball) inside ball, or false. */
static bool prove_at(arb_t delta, const struct evidence *e, const struct trajectory *t, const arb_t U, const arb_t rho)
{
    enum { NU, THETA, DEFECT, INVERSE, GROWTH, IMAGE, TERM, ETA, LAST, FIRST, COUNT };
    const struct ratio one = {1, 1};
    const struct ratio a1 = ratio_add(t->law.a, one);
    arb_ptr v = _arb_vec_init(COUNT);
    arb_t error[2], size[2];
    mag_t norm, mU, mrho;
    bool proved = false;

    for (int i = 0; i < 2; i++) {
        arb_init(error[i]);
        arb_init(size[i]);
    }
    mag_init(norm);
    mag_init(mU);
    mag_init(mrho);
    arb_get_mag(mU, U);
    arb_get_mag(mrho, rho);

    magnitudes_norm(norm, &e->defect, mU, mrho, 0);
    if (mag_cmp_2exp_si(norm, -1) >= 0)
        goto done;
    arb_set_upper(v + DEFECT, norm);
    magnitudes_norm(norm, &e->inverse, mU, mrho, 0);
    arb_set_upper(v + INVERSE, norm);
    arb_sub_si(v + NU, v + DEFECT, 1, NORM_BITS);
    arb_neg(v + NU, v + NU);
    arb_div(v + NU, v + INVERSE, v + NU, NORM_BITS);
    magnitudes_norm(norm, &e->z, mU, mrho, 1);
    arb_set_upper(v + THETA, norm);

    for (int i = 0; i < e->powers; i++) {
        /* |E| <= nu |N| / (J + 1 - p nu |th(Z)|) */
        arb_set_ratio(v + TERM, e->exponent[i], NORM_BITS);
        arb_mul(v + TERM, v + TERM, v + NU, NORM_BITS);
        arb_mul(v + TERM, v + TERM, v + THETA, NORM_BITS);
        arb_sub_si(v + TERM, v + TERM, e->J + 1, NORM_BITS);
        arb_neg(v + TERM, v + TERM);
        if (!arb_is_positive(v + TERM))
            goto done;
        magnitudes_norm(norm, &e->n[i], mU, mrho, 0);
        arb_set_upper(error[i], norm);
        arb_mul(error[i], error[i], v + NU, NORM_BITS);
        arb_div(error[i], error[i], v + TERM, NORM_BITS);
        magnitudes_norm(norm, &e->p[i], mU, mrho, 0);
        arb_set_upper(size[i], norm);
        arb_add(size[i], size[i], error[i], NORM_BITS);
    }
    const int damping = e->powers - 1;

    /* Smallest e of the tail; the part of X^a from s^J on is |P's last column| rho^J + |E|. */
    arb_set_ratio(v + FIRST, a1, NORM_BITS);
    arb_mul_si(v + FIRST, v + FIRST, e->J + 1, NORM_BITS);
    struct magnitudes last = {e->p[0].rows, 1, NULL};
    last.m = _mag_vec_init(last.rows);
    for (slong k = 0; k < last.rows; k++)
        mag_set(last.m + k, e->p[0].m + k * e->p[0].length + e->J);
    magnitudes_norm(norm, &last, mU, mrho, 0);
    magnitudes_clear(&last);
    arb_set_upper(v + LAST, norm);
    arb_pow_ui(v + TERM, rho, (ulong)e->J, NORM_BITS);
    arb_mul(v + LAST, v + LAST, v + TERM, NORM_BITS);
    arb_add(v + LAST, v + LAST, error[0], NORM_BITS);

    arb_zero(delta);
    for (int attempt = 0; attempt < 3 && !proved; attempt++) {
        arb_mul(v + ETA, v + NU, delta, NORM_BITS);
        arb_sub_si(v + TERM, v + ETA, 1, NORM_BITS);
        if (!arb_is_negative(v + TERM))
            break;
        /* U/((b+1)(e+1)) |[X^(b+1)] beyond J| + 2^shift rho/(e (e+1)) |[X^a] from J on| */
        power_growth(v + GROWTH, v + ETA, e->exponent[1]);
        arb_mul(v + GROWTH, v + GROWTH, size[damping], NORM_BITS);
        arb_add(v + IMAGE, error[damping], v + GROWTH, NORM_BITS);
        arb_mul(v + IMAGE, v + IMAGE, U, NORM_BITS);
        arb_set_ratio(v + TERM, e->exponent[1], NORM_BITS);
        arb_div(v + IMAGE, v + IMAGE, v + TERM, NORM_BITS);
        power_growth(v + GROWTH, v + ETA, e->exponent[0]);
        arb_mul(v + GROWTH, v + GROWTH, size[0], NORM_BITS);
        arb_add(v + GROWTH, v + GROWTH, v + LAST, NORM_BITS);
        arb_mul(v + GROWTH, v + GROWTH, rho, NORM_BITS);
        arb_mul_2exp_si(v + GROWTH, v + GROWTH, t->shift);
        arb_div(v + GROWTH, v + GROWTH, v + FIRST, NORM_BITS);
        arb_add(v + IMAGE, v + IMAGE, v + GROWTH, NORM_BITS);
        arb_add_si(v + TERM, v + FIRST, 1, NORM_BITS);
        arb_div(v + IMAGE, v + IMAGE, v + TERM, NORM_BITS);
        proved = arb_le(v + IMAGE, delta);
        if (!proved) {
            arb_get_mag(norm, v + IMAGE);
            arb_set_upper(delta, norm);
            arb_mul_2exp_si(delta, delta, 1);
        }
    }
done:
    for (int i = 0; i < 2; i++) {
        arb_clear(error[i]);
        arb_clear(size[i]);
    }
    _arb_vec_clear(v, COUNT);
    mag_clear(norm);
    mag_clear(mU);
    mag_clear(mrho);
    return proved;
}

void trajectory_tail_init(struct trajectory_tail *tail)
{
    arb_init(tail->delta);
    arb_init(tail->U);
    arb_init(tail->rho);
}

void trajectory_tail_clear(struct trajectory_tail *tail)
{
    arb_clear(tail->delta);
    arb_clear(tail->U);
    arb_clear(tail->rho);
}

/* log2 of the largest error that the tail causes in x_k^(m)(t0) t0^m/m!, k + m = order. */
static double tail_quality(const struct trajectory_tail *tail, const struct trajectory *t, const arb_t t0)
{
    double worst = -HUGE_VAL;
    mag_t bound, power;
    mag_init(bound);
    mag_init(power);
    arb_get_mag(power, t0);
    for (int i = 0; i <= 2; i++) {
        const slong m = t->order * i / 2;
        trajectory_tail_jet(bound, tail, t, t->order - m, m, t0);
        worst = fmax(worst, mag_get_d_log2_approx(bound) + (double)m * mag_get_d_log2_approx(power));
    }
    mag_clear(bound);
    mag_clear(power);
    return worst;
}

bool trajectory_tail_prove(struct trajectory_tail *tail, const struct trajectory *t, const arb_t t0)
{
    const struct ratio one = {1, 1};
    const struct ratio a1 = ratio_add(t->law.a, one);
    struct evidence e;
    struct trajectory_tail trial;
    double best = HUGE_VAL;
    arb_t s0, U, rho;
    bool proved = false;
    trajectory_tail_init(&trial);
    arb_init(s0);
    arb_init(U);
    arb_init(rho);

    evidence_init(&e, t);
    arb_pow_ratio(s0, t0, a1, NORM_BITS);
    arb_mul_2exp_si(s0, s0, -t->shift);
    /* Radii between t0 and the nearest singularity, and a few weights of u. The best pair causes the smallest errors in
     * two coefficients of x at t0: in the last row, and in the last derivative of the first row (which itself grows
     * like t0^-m). */
    for (int i = 0; i < 5; i++) {
        static const double part[5] = {0.9, 0.8, 0.7, 0.5, 0.25};
        double best_here = HUGE_VAL;
        arb_set_d(rho, 1 + part[i] * (law_elastic_radius(&t->law) - 1));
        arb_pow_ratio(rho, rho, a1, NORM_BITS);
        arb_mul(rho, rho, s0, NORM_BITS);
        arb_get_mid_arb(rho, rho);
        for (int half_powers = 6; half_powers >= -14; half_powers -= 2) {
            arb_set_si(U, 1);
            arb_mul_2exp_si(U, U, half_powers / 2);
            if (!prove_at(trial.delta, &e, t, U, rho))
                continue;
            arb_set(trial.U, U);
            arb_set(trial.rho, rho);
            const double quality = tail_quality(&trial, t, t0);
            if (quality < best) {
                arb_set(tail->delta, trial.delta);
                arb_set(tail->U, U);
                arb_set(tail->rho, rho);
                best = quality;
                proved = true;
            }
            if (quality >= best_here)
                break; /* a smaller U only makes the bound worse */
            best_here = quality;
        }
    }
    evidence_clear(&e);
    trajectory_tail_clear(&trial);
    arb_clear(s0);
    arb_clear(U);
    arb_clear(rho);
    return proved;
}

void trajectory_tail_jet(mag_t bound, const struct trajectory_tail *tail, const struct trajectory *t, slong k, slong m,
                         const arb_t t0)
{
    /* For any r > 0 with s = (t0 + r)^(a+1)/2^shift <= rho, the sum over m of the jets times r^m is x_k's tail at
     * t0 + r: at most (t0 + r)^(k(b+1)+1) delta U^-k (s/rho)^(terms+1). */
    const struct ratio one = {1, 1};
    const struct ratio a1 = ratio_add(t->law.a, one), b1 = ratio_add(t->law.b, one);
    arb_t r, room, reach, value, factor;
    mag_t candidate;
    arb_init(r);
    arb_init(room);
    arb_init(reach);
    arb_init(value);
    arb_init(factor);
    mag_init(candidate);
    mag_inf(bound);
    /* Sixteen circles between t0 and the radius that corresponds to rho. */
    arb_mul_2exp_si(room, tail->rho, t->shift);
    arb_pow_ratio(room, room, ratio_div(one, a1), NORM_BITS);
    arb_sub(room, room, t0, NORM_BITS);
    for (int i = 1; i <= 16; i++) {
        arb_mul_si(r, room, i, NORM_BITS);
        arb_div_si(r, r, 17, NORM_BITS);
        arb_add(reach, t0, r, NORM_BITS);
        arb_pow_ratio(value, reach, a1, NORM_BITS);
        arb_mul_2exp_si(value, value, -t->shift);
        arb_div(value, value, tail->rho, NORM_BITS);
        arb_sub_si(factor, value, 1, NORM_BITS);
        if (!arb_is_negative(factor))
            break;
        arb_pow_ui(value, value, (ulong)(t->terms + 1), NORM_BITS);
        arb_pow_ratio(factor, reach, b1, NORM_BITS);
        arb_div(factor, factor, tail->U, NORM_BITS);
        arb_pow_ui(factor, factor, (ulong)k, NORM_BITS);
        arb_mul(value, value, factor, NORM_BITS);
        arb_mul(value, value, reach, NORM_BITS);
        arb_mul(value, value, tail->delta, NORM_BITS);
        arb_pow_ui(factor, r, (ulong)m, NORM_BITS);
        arb_div(value, value, factor, NORM_BITS);
        arb_get_mag(candidate, value);
        mag_min(bound, bound, candidate);
    }
    arb_clear(r);
    arb_clear(room);
    arb_clear(reach);
    arb_clear(value);
    arb_clear(factor);
    mag_clear(candidate);
}
