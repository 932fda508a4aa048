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

enum {
    /* Norms are needed to a few digits only. The products below use midpoints rounded to this number of bits. */
    NORM_BITS = 64,
    /* Row k of the trajectory is about 2^(-ROW_BITS k) at small s. Without this factor, coefficients have similar size
     * and multiply faster. */
    ROW_BITS = 2,
    /* number of circles for Cauchy's estimate in trajectory_tail_jet */
    CIRCLES = 16
};

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

/* The proof for one choice of the weights U and rho: docs/derivation.md, 3, equations (3.1) to (3.4). All numbers are
 * upper bounds. */
struct tail_proof {
    const struct evidence *e;
    const struct law *law;
    slong shift;
    arb_t U, rho;
    mag_t U_mag, rho_mag;
    arb_t inverse;                      /* nu of (3.1): |1/Z| */
    arb_t error[2], size[2];            /* |E| and |Z^p| of (3.2), p = a and b + 1 */
    arb_t last_column;                  /* norm of the part of X^a from s^J on */
    arb_t first_exponent, last_divisor; /* e and e + 1 of the tail's first coefficient */
    arb_t delta, image;                 /* radius of the ball, and of its image by G */
};

static void tail_proof_init(struct tail_proof *p, const struct evidence *e, const struct trajectory *t, const arb_t U,
                            const arb_t rho)
{
    p->e = e;
    p->law = &t->law;
    p->shift = t->shift;
    arb_init(p->U);
    arb_init(p->rho);
    arb_set(p->U, U);
    arb_set(p->rho, rho);
    mag_init(p->U_mag);
    mag_init(p->rho_mag);
    arb_get_mag(p->U_mag, U);
    arb_get_mag(p->rho_mag, rho);
    arb_init(p->inverse);
    for (int i = 0; i < 2; i++) {
        arb_init(p->error[i]);
        arb_init(p->size[i]);
    }
    arb_init(p->last_column);
    arb_init(p->first_exponent);
    arb_init(p->last_divisor);
    arb_init(p->delta);
    arb_init(p->image);
    arb_set_ratio(p->first_exponent, ratio_add(t->law.a, (struct ratio){1, 1}), NORM_BITS);
    arb_mul_si(p->first_exponent, p->first_exponent, e->J + 1, NORM_BITS);
    arb_add_si(p->last_divisor, p->first_exponent, 1, NORM_BITS);
}

static void tail_proof_clear(struct tail_proof *p)
{
    arb_clear(p->U);
    arb_clear(p->rho);
    mag_clear(p->U_mag);
    mag_clear(p->rho_mag);
    arb_clear(p->inverse);
    for (int i = 0; i < 2; i++) {
        arb_clear(p->error[i]);
        arb_clear(p->size[i]);
    }
    arb_clear(p->last_column);
    arb_clear(p->first_exponent);
    arb_clear(p->last_divisor);
    arb_clear(p->delta);
    arb_clear(p->image);
}

/* |f| or, with theta = 1, |th(f)| in the weights of the proof. */
static void tail_norm(arb_t y, const struct tail_proof *p, const struct magnitudes *f, int theta)
{
    mag_t norm;
    mag_init(norm);
    magnitudes_norm(norm, f, p->U_mag, p->rho_mag, theta);
    arb_set_upper(y, norm);
    mag_clear(norm);
}

/* (3.1): nu = |V|/(1 - |1 - Z V|) needs |1 - Z V| < 1. Above 1/2 the bound would be useless. */
static bool bound_inverse(struct tail_proof *p)
{
    arb_t rest;
    arb_init(rest);
    tail_norm(rest, p, &p->e->defect, 0);
    arb_sub_si(rest, rest, 1, NORM_BITS);
    arb_neg(rest, rest); /* 1 - |1 - Z V| */
    tail_norm(p->inverse, p, &p->e->inverse, 0);
    arb_div(p->inverse, p->inverse, rest, NORM_BITS);
    arb_mul_2exp_si(rest, rest, 1);
    arb_sub_si(rest, rest, 1, NORM_BITS);
    const bool useful = arb_is_positive(rest);
    arb_clear(rest);
    return useful;
}

/* (3.2): |E| <= nu |N|/(J + 1 - p nu |th(Z)|) and |Z^p| <= |P| + |E| for both powers p. */
static bool bound_powers(struct tail_proof *p)
{
    bool bounded = true;
    arb_t slope, divisor;
    arb_init(slope);
    arb_init(divisor);
    tail_norm(slope, p, &p->e->z, 1);
    arb_mul(slope, slope, p->inverse, NORM_BITS);
    for (int i = 0; i < p->e->powers && bounded; i++) {
        arb_set_ratio(divisor, p->e->exponent[i], NORM_BITS);
        arb_mul(divisor, divisor, slope, NORM_BITS);
        arb_sub_si(divisor, divisor, p->e->J + 1, NORM_BITS);
        arb_neg(divisor, divisor);
        bounded = arb_is_positive(divisor);
        tail_norm(p->error[i], p, &p->e->n[i], 0);
        arb_mul(p->error[i], p->error[i], p->inverse, NORM_BITS);
        arb_div(p->error[i], p->error[i], divisor, NORM_BITS);
        tail_norm(p->size[i], p, &p->e->p[i], 0);
        arb_add(p->size[i], p->size[i], p->error[i], NORM_BITS);
    }
    arb_clear(slope);
    arb_clear(divisor);
    return bounded;
}

/* The part of X^a from s^J on: the last column of P times rho^J, and E. */
static void bound_last_column(struct tail_proof *p)
{
    const struct magnitudes *power = &p->e->p[0];
    struct magnitudes last;
    arb_t rho_J;
    arb_init(rho_J);
    magnitudes_init(&last, power->rows, 1);
    for (slong k = 0; k < last.rows; k++)
        mag_set(last.m + k, power->m + k * power->length + p->e->J);
    tail_norm(p->last_column, p, &last, 0);
    magnitudes_clear(&last);
    arb_pow_ui(rho_J, p->rho, (ulong)p->e->J, NORM_BITS);
    arb_mul(p->last_column, p->last_column, rho_J, NORM_BITS);
    arb_add(p->last_column, p->last_column, p->error[0], NORM_BITS);
    arb_clear(rho_J);
}

/* (3.3): the radius of G's image of the ball |R| <= delta,
 *
 *   (U/(b+1) |[X^(b+1)] beyond s^J| + 2^shift rho/e |[X^a] from s^J on|)/(e + 1),
 *
 * with |(Z+R)^p - Z^p| <= |Z^p| ((1 - nu delta)^(-p) - 1). Returns false if nu delta is not below 1. */
static bool image_of_ball(struct tail_proof *p)
{
    const int damping = p->e->powers - 1;
    arb_t eta, term;
    arb_init(eta);
    arb_init(term);
    arb_mul(eta, p->inverse, p->delta, NORM_BITS);
    arb_sub_si(term, eta, 1, NORM_BITS);
    const bool converges = arb_is_negative(term);
    if (converges) {
        power_growth(p->image, eta, p->e->exponent[1]);
        arb_mul(p->image, p->image, p->size[damping], NORM_BITS);
        arb_add(p->image, p->image, p->error[damping], NORM_BITS);
        arb_mul(p->image, p->image, p->U, NORM_BITS);
        arb_set_ratio(term, p->e->exponent[1], NORM_BITS);
        arb_div(p->image, p->image, term, NORM_BITS);

        power_growth(term, eta, p->e->exponent[0]);
        arb_mul(term, term, p->size[0], NORM_BITS);
        arb_add(term, term, p->last_column, NORM_BITS);
        arb_mul(term, term, p->rho, NORM_BITS);
        arb_mul_2exp_si(term, term, p->shift);
        arb_div(term, term, p->first_exponent, NORM_BITS);
        arb_add(p->image, p->image, term, NORM_BITS);
        arb_div(p->image, p->image, p->last_divisor, NORM_BITS);
    }
    arb_clear(eta);
    arb_clear(term);
    return converges;
}

/* (3.4): finds a delta such that G maps the ball |R| <= delta into itself. The image of the point 0 is a lower bound on
 * delta. The first trial is twice that bound, and the second twice the image of the first ball. */
static bool fixed_point(struct tail_proof *p)
{
    enum { BALLS = 3 };
    mag_t radius;
    bool proved = false;
    mag_init(radius);
    arb_zero(p->delta);
    for (int ball = 0; ball < BALLS && !proved && image_of_ball(p); ball++) {
        proved = arb_le(p->image, p->delta);
        if (!proved) {
            arb_get_mag(radius, p->image);
            arb_set_upper(p->delta, radius);
            arb_mul_2exp_si(p->delta, p->delta, 1);
        }
    }
    mag_clear(radius);
    return proved;
}

/* Sets delta. Returns false if the proof does not succeed with these weights. */
static bool prove_at(arb_t delta, const struct evidence *e, const struct trajectory *t, const arb_t U, const arb_t rho)
{
    struct tail_proof p;
    tail_proof_init(&p, e, t, U, rho);
    bool proved = bound_inverse(&p) && bound_powers(&p);
    if (proved) {
        bound_last_column(&p);
        proved = fixed_point(&p);
    }
    arb_set(delta, p.delta);
    tail_proof_clear(&p);
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

/* Trial radii for rho, as parts of the way from t0 to the nearest singularity, and trial weights U = 2^k */
static const double trial_part[] = {0.9, 0.8, 0.7, 0.5, 0.25};
enum { TRIAL_PARTS = sizeof trial_part / sizeof *trial_part, TRIAL_U_MAX = 3, TRIAL_U_MIN = -7 };

bool trajectory_tail_prove(struct trajectory_tail *tail, const struct trajectory *t, const arb_t t0)
{
    const struct ratio a1 = ratio_add(t->law.a, (struct ratio){1, 1});
    struct evidence e;
    struct trajectory_tail trial;
    double best = HUGE_VAL;
    arb_t s0;
    trajectory_tail_init(&trial);
    arb_init(s0);

    evidence_init(&e, t);
    arb_pow_ratio(s0, t0, a1, NORM_BITS);
    arb_mul_2exp_si(s0, s0, -t->shift);
    /* The best pair of weights causes the smallest errors in two coefficients of x at t0: in the last row, and in the
     * last derivative of the first row (which itself grows like t0^-m). */
    for (int i = 0; i < TRIAL_PARTS; i++) {
        double best_here = HUGE_VAL;
        arb_set_d(trial.rho, 1 + trial_part[i] * (law_elastic_radius(&t->law) - 1));
        arb_pow_ratio(trial.rho, trial.rho, a1, NORM_BITS);
        arb_mul(trial.rho, trial.rho, s0, NORM_BITS);
        arb_get_mid_arb(trial.rho, trial.rho);
        for (int k = TRIAL_U_MAX; k >= TRIAL_U_MIN; k--) {
            arb_one(trial.U);
            arb_mul_2exp_si(trial.U, trial.U, k);
            if (!prove_at(trial.delta, &e, t, trial.U, trial.rho))
                continue;
            const double quality = tail_quality(&trial, t, t0);
            if (quality < best) {
                arb_set(tail->delta, trial.delta);
                arb_set(tail->U, trial.U);
                arb_set(tail->rho, trial.rho);
                best = quality;
            }
            if (quality >= best_here)
                break; /* a smaller U only makes the bound worse */
            best_here = quality;
        }
    }
    evidence_clear(&e);
    trajectory_tail_clear(&trial);
    arb_clear(s0);
    return best < HUGE_VAL;
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
    /* Circles between t0 and the radius that corresponds to rho */
    arb_mul_2exp_si(room, tail->rho, t->shift);
    arb_pow_ratio(room, room, ratio_div(one, a1), NORM_BITS);
    arb_sub(room, room, t0, NORM_BITS);
    for (int i = 1; i <= CIRCLES; i++) {
        arb_mul_si(r, room, i, NORM_BITS);
        arb_div_si(r, r, CIRCLES + 1, NORM_BITS);
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
