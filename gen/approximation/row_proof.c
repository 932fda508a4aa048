/* SPDX-License-Identifier: MIT */
#include "approximation/row_proof.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "support/console.h"
#include "support/parallel.h"

enum {
    PREC = 320,     /* of the interpolants, whose coefficients in powers are large and cancel */
    ROW_PREC = 160, /* of polynomials on a cell */
    MOST_DEGREE = 44,
    NEGLIGIBLE = -100, /* terms below 2^NEGLIGIBLE of the value join the constant term's radius */
    HALVINGS = 10,     /* of a cell, at most, to bound a polynomial */
    POINTS = 16,       /* on each side of its middle, where the polynomial is evaluated first */
    LAST_COEFFICIENTS = 6
};

/* A bound of a polynomial is good enough within this factor of a value that it takes. */
#define NEAR_KNOWN 1.03

/* rho of the ellipse around each interval, near the largest for which the cover succeeds; 0: two other intervals cover
 * this one */
static const double ellipse_rho[] = {4, 3.4, 0, 4.2, 3.3, 3.4, 3.8, 5, 2.6};

struct interpolant_proof {
    const struct interpolant *f;
    struct ellipse_bound *bound;               /* of each interval */
    arb_poly_struct (*polynomial)[QUANTITIES]; /* in w, -1 <= w <= 1, for each interval */
    arb_struct (*error)[QUANTITIES];
};

/* ---- the error of the interpolant ---- */

/* w = (x - middle)/half */
static void to_unit(arb_t w, const arb_t x, const struct interval *interval)
{
    arb_t c;
    arb_init(c);
    arb_set_d(c, interval->lo);
    arb_sub(w, x, c, PREC);
    arb_mul_2exp_si(w, w, 1);
    arb_set_d(c, interval->hi);
    arb_sub(w, w, c, PREC);
    arb_set_d(c, interval->lo);
    arb_add(w, w, c, PREC);
    arb_t length;
    arb_init(length);
    arb_set_d(length, interval->hi);
    arb_sub(length, length, c, PREC);
    arb_div(w, w, length, PREC);
    arb_clear(length);
    arb_clear(c);
}

/* Exact Chebyshev point j of n in ascending order */
static void exact_point(arb_t x, slong j, slong n)
{
    fmpq_t angle;
    fmpq_init(angle);
    fmpq_set_si(angle, 2 * j + 1, (ulong)(2 * n));
    arb_cos_pi_fmpq(x, angle, PREC);
    arb_neg(x, x);
    fmpq_clear(angle);
}

/* Bound of the Lebesgue constant for the nodes w. For the n Chebyshev points it is L < 1 + (2/pi) ln(n); for nodes that
 * differ by d at most it is L/(1 - L d (n-1)^2) at most, by Markov's inequality. Not finite if d is too large. */
static void lebesgue(arb_t bound, arb_srcptr w, slong n)
{
    arb_t d, x;
    arb_init(d);
    arb_init(x);
    for (slong j = 0; j < n; j++) {
        exact_point(x, j, n);
        arb_sub(x, x, w + j, PREC);
        arb_abs(x, x);
        arb_max(d, d, x, PREC);
    }
    arb_log_ui(bound, (ulong)n, PREC);
    arb_mul_2exp_si(bound, bound, 1);
    arb_const_pi(x, PREC);
    arb_div(bound, bound, x, PREC);
    arb_add_ui(bound, bound, 1, PREC);
    arb_mul(d, d, bound, PREC);
    arb_mul_ui(d, d, (ulong)((n - 1) * (n - 1)), PREC);
    arb_sub_ui(d, d, 1, PREC);
    arb_neg(d, d);
    if (arb_is_positive(d))
        arb_div(bound, bound, d, PREC);
    else
        arb_pos_inf(bound);
    arb_clear(d);
    arb_clear(x);
}

/* f is within 2 M rho^(1-n)/(rho - 1) of a polynomial of degree n - 1, and the interpolant within 1 + L times that and
 * L times the error of the values. */
static void polynomial_error(arb_t error, const struct ellipse_bound *bound, enum quantity quantity,
                             const arb_t constant, arb_srcptr value, const struct interval *interval)
{
    const slong n = interval->count;
    arb_t rho, x;
    arb_init(rho);
    arb_init(x);
    arb_set_d(rho, bound->rho);
    arb_pow_ui(x, rho, (ulong)(n - 1), PREC);
    arb_sub_ui(rho, rho, 1, PREC);
    arb_mul(x, x, rho, PREC);
    arb_set_d(error, 2 * bound->modulus[quantity]);
    arb_div(error, error, x, PREC);
    arb_add_ui(x, constant, 1, PREC);
    arb_mul(error, error, x, PREC);
    arb_zero(rho);
    for (slong j = 0; j < n; j++) {
        arb_abs(x, value + j);
        arb_max(rho, rho, x, PREC);
    }
    arb_mul_2exp_si(rho, rho, -interval->bits);
    arb_addmul(error, rho, constant, PREC);
    arb_clear(rho);
    arb_clear(x);
}

/* Whether the last Chebyshev coefficients a_k of the interpolant agree with the proof: |a_k| <= 2 M rho^-k + 2 error. A
 * wrong sample or node would enter all coefficients alike. */
static bool coefficients_agree(const arb_poly_t p, const struct ellipse_bound *bound, enum quantity quantity,
                               const arb_t error, slong n)
{
    arb_ptr value = _arb_vec_init(n);
    arb_t x, sum, limit;
    fmpq_t angle;
    bool agree = true;
    arb_init(x);
    arb_init(sum);
    arb_init(limit);
    fmpq_init(angle);
    for (slong j = 0; j < n; j++) {
        exact_point(x, j, n);
        arb_poly_evaluate(value + j, p, x, PREC);
    }
    for (slong k = n - LAST_COEFFICIENTS; k < n; k++) {
        arb_zero(sum);
        for (slong j = 0; j < n; j++) { /* T_k(-cos(a)) = +-cos(k a) */
            fmpq_set_si(angle, k * (2 * j + 1), (ulong)(2 * n));
            arb_cos_pi_fmpq(x, angle, PREC);
            arb_addmul(sum, x, value + j, PREC);
        }
        arb_mul_2exp_si(sum, sum, 1);
        arb_div_ui(sum, sum, (ulong)n, PREC);
        arb_abs(sum, sum);
        arb_set_d(limit, bound->rho);
        arb_pow_ui(limit, limit, (ulong)k, PREC);
        arb_set_d(x, bound->modulus[quantity]);
        arb_div(limit, x, limit, PREC);
        arb_add(limit, limit, error, PREC);
        arb_mul_2exp_si(limit, limit, 1);
        agree = agree && arb_le(sum, limit);
    }
    fmpq_clear(angle);
    arb_clear(x);
    arb_clear(sum);
    arb_clear(limit);
    _arb_vec_clear(value, n);
    return agree;
}

static int prove_interval(struct interpolant_proof *proof, int i)
{
    const struct interval *const interval = &interpolant_layout_of(proof->f)->interval[i];
    const unsigned set = ellipse_bound_set(interval);
    const slong n = interval->count;
    arb_srcptr node, value;
    if (!interpolant_samples(&node, &value, proof->f, i, EPS_ZERO_OVERLAP))
        return STATUS_OK;
    arb_ptr w = _arb_vec_init(n);
    arb_t constant;
    arb_init(constant);
    int status = ellipse_bound_make(&proof->bound[i], interval, ellipse_rho[i]);
    for (slong j = 0; j < n; j++)
        to_unit(w + j, node + j, interval);
    lebesgue(constant, w, n);
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++) {
        if (!(set & 1u << q))
            continue;
        interpolant_samples(&node, &value, proof->f, i, (enum quantity)q);
        arb_poly_interpolate_newton(&proof->polynomial[i][q], w, value, n, PREC);
        polynomial_error(&proof->error[i][q], &proof->bound[i], (enum quantity)q, constant, value, interval);
        if (!coefficients_agree(&proof->polynomial[i][q], &proof->bound[i], (enum quantity)q, &proof->error[i][q], n))
            status =
                fail("the interpolant of quantity %d on [%g, %g] is not the function's: a sample or a node is wrong", q,
                     interval->lo, interval->hi);
    }
    arb_clear(constant);
    _arb_vec_clear(w, n);
    return status;
}

/* Whether the law and the intervals are those for which the radii above were chosen */
static bool is_sphere(const struct interpolant_layout *layout)
{
    bool same = layout->intervals == sizeof ellipse_rho / sizeof *ellipse_rho &&
                layout->intervals == interpolant_sphere_proof.intervals &&
                layout->root == interpolant_sphere_proof.root && 2 * layout->law.a.num == 3 * layout->law.a.den &&
                2 * layout->law.b.num == layout->law.b.den;
    for (int i = 0; i < interpolant_sphere_proof.intervals && same; i++) {
        const struct interval *const x = &layout->interval[i], *const y = &interpolant_sphere_proof.interval[i];
        same = x->variable == y->variable && x->lo == y->lo && x->hi == y->hi && x->form == y->form && x->set == y->set;
    }
    return same;
}

struct interpolant_proof *interpolant_proof_new(const struct interpolant *f)
{
    const int intervals = interpolant_layout_of(f)->intervals;
    struct interpolant_proof *proof = xmalloc(sizeof *proof);
    proof->f = f;
    proof->bound = xmalloc((size_t)intervals * sizeof *proof->bound);
    for (int i = 0; i < intervals; i++)
        proof->bound[i] = (struct ellipse_bound){0};
    proof->polynomial = xmalloc((size_t)intervals * sizeof *proof->polynomial);
    proof->error = xmalloc((size_t)intervals * sizeof *proof->error);
    for (int i = 0; i < intervals; i++)
        for (int q = 0; q < QUANTITIES; q++) {
            arb_poly_init(&proof->polynomial[i][q]);
            arb_init(&proof->error[i][q]);
            arb_pos_inf(&proof->error[i][q]);
        }
    int status = STATUS_OK;
    if (!is_sphere(interpolant_layout_of(f)))
        status = fail("only the interpolant of interpolant_sphere_proof can be proved");
    for (int i = 0; i < intervals && status == STATUS_OK; i++)
        if (ellipse_rho[i] > 0)
            status = prove_interval(proof, i);
    if (status == STATUS_OK)
        return proof;
    interpolant_proof_free(proof);
    return NULL;
}

void interpolant_proof_free(struct interpolant_proof *proof)
{
    if (!proof)
        return;
    for (int i = 0; i < interpolant_layout_of(proof->f)->intervals; i++)
        for (int q = 0; q < QUANTITIES; q++) {
            arb_poly_clear(&proof->polynomial[i][q]);
            arb_clear(&proof->error[i][q]);
        }
    free(proof->polynomial);
    free(proof->error);
    free(proof->bound);
    free(proof);
}

double interpolant_proof_error(const struct interpolant_proof *proof, int i, enum quantity quantity)
{
    mag_t bound;
    mag_init(bound);
    arb_get_mag(bound, &proof->error[i][quantity]);
    const double error = mag_get_d(bound);
    mag_clear(bound);
    return error;
}

const struct ellipse_bound *interpolant_proof_bound(const struct interpolant_proof *proof, int i)
{
    return &proof->bound[i];
}

/* ---- functions on a piece of an interval ---- */

/* A function of t, -1 <= t <= 1, is represented by a polynomial with intervals as coefficients: at every t the value of
 * the function is the value of the polynomial for some numbers of the intervals, which may depend on t. Sums and products
 * of such polynomials represent sums and products. Terms of high degree, which are at most the sums of their
 * coefficients, become part of the constant term's radius. */

static void shorten(arb_poly_t p)
{
    mag_t limit, sum, term;
    slong degree = arb_poly_degree(p);
    if (degree < 1)
        return;
    mag_init(limit);
    mag_init(sum);
    mag_init(term);
    arb_get_mag(limit, arb_poly_get_coeff_ptr(p, 0));
    mag_mul_2exp_si(limit, limit, NEGLIGIBLE);
    for (; degree > 0; degree--) {
        arb_get_mag(term, arb_poly_get_coeff_ptr(p, degree));
        if (degree <= MOST_DEGREE && mag_cmp(term, limit) > 0)
            break;
        mag_add(sum, sum, term);
    }
    arb_poly_truncate(p, degree + 1);
    arb_add_error_mag(arb_poly_get_coeff_ptr(p, 0), sum);
    mag_clear(limit);
    mag_clear(sum);
    mag_clear(term);
}

static void multiply(arb_poly_t z, const arb_poly_t x, const arb_poly_t y)
{
    arb_poly_mul(z, x, y, ROW_PREC);
    shorten(z);
}

/* Adds c to the constant term. */
static void add_number(arb_poly_t p, const arb_t c)
{
    arb_t constant;
    arb_init(constant);
    arb_poly_get_coeff_arb(constant, p, 0);
    arb_add(constant, constant, c, ROW_PREC);
    arb_poly_set_coeff_arb(p, 0, constant);
    arb_clear(constant);
}

static void add_double(arb_poly_t p, double c)
{
    arb_t number;
    arb_init(number);
    arb_set_d(number, c);
    add_number(p, number);
    arb_clear(number);
}

static void add_radius(arb_poly_t p, const arb_t radius)
{
    arb_t constant;
    arb_init(constant);
    arb_poly_get_coeff_arb(constant, p, 0);
    arb_add_error(constant, radius);
    arb_poly_set_coeff_arb(p, 0, constant);
    arb_clear(constant);
}

/* The interval of all values, by the sum of the coefficients */
static void range_of(arb_t range, const arb_poly_t p)
{
    arb_t radius, c;
    arb_init(radius);
    arb_init(c);
    for (slong k = arb_poly_degree(p); k >= 1; k--) {
        arb_abs(c, arb_poly_get_coeff_ptr(p, k));
        arb_add(radius, radius, c, ROW_PREC);
    }
    arb_poly_get_coeff_arb(range, p, 0);
    arb_add_error(range, radius);
    arb_clear(radius);
    arb_clear(c);
}

/* p(middle + half t) */
static void rescale(arb_poly_t y, const arb_poly_t p, const arb_t middle, const arb_t half, slong prec)
{
    arb_poly_t line;
    arb_poly_init(line);
    arb_poly_set_coeff_arb(line, 1, half);
    arb_poly_set_coeff_arb(line, 0, middle);
    arb_poly_compose(y, p, line, prec);
    arb_poly_clear(line);
}

/* exp(c x), x = middle + half t */
static void exponential(arb_poly_t y, double numerator, slong denominator, const arb_poly_t x)
{
    enum { TERMS = 30 };
    arb_t middle, step, term;
    arb_init(middle);
    arb_init(step);
    arb_init(term);
    arb_set_d(term, numerator);
    arb_div_si(term, term, denominator, ROW_PREC);
    arb_poly_get_coeff_arb(middle, x, 0);
    arb_poly_get_coeff_arb(step, x, 1);
    arb_mul(middle, middle, term, ROW_PREC);
    arb_mul(step, step, term, ROW_PREC);
    arb_exp(middle, middle, ROW_PREC);
    arb_set(term, middle);
    arb_poly_zero(y);
    for (ulong k = 0; k < TERMS; k++) {
        arb_poly_set_coeff_arb(y, (slong)k, term);
        arb_mul(term, term, step, ROW_PREC);
        arb_div_ui(term, term, k + 1, ROW_PREC);
    }
    arb_abs(step, step);
    arb_exp(step, step, ROW_PREC);
    arb_mul(term, term, step, ROW_PREC); /* bounds the terms left out */
    add_radius(y, term);
    shorten(y);
    arb_clear(middle);
    arb_clear(step);
    arb_clear(term);
}

/* The root of a positive function: the root s of its polynomial's middle, and the rest, |p - s^2|/s at most. */
static bool square_root(arb_poly_t y, const arb_poly_t p)
{
    arb_poly_t s, rest;
    arb_t least, most;
    arb_poly_init(s);
    arb_poly_init(rest);
    arb_init(least);
    arb_init(most);
    arb_poly_set(s, p);
    for (slong k = 0; k < arb_poly_length(s); k++)
        arb_get_mid_arb(arb_poly_get_coeff_ptr(s, k), arb_poly_get_coeff_ptr(s, k));
    const bool positive = arb_poly_length(s) > 0 && arb_is_positive(arb_poly_get_coeff_ptr(s, 0));
    if (positive)
        arb_poly_sqrt_series(s, s, MOST_DEGREE / 2, ROW_PREC);
    arb_poly_mul(rest, s, s, ROW_PREC);
    arb_poly_sub(rest, p, rest, ROW_PREC);
    range_of(most, rest);
    range_of(least, s);
    const bool done = positive && arb_is_positive(least);
    arb_div(most, most, least, ROW_PREC);
    arb_abs(most, most);
    arb_poly_set(y, s);
    if (done)
        add_radius(y, most);
    shorten(y);
    arb_poly_clear(s);
    arb_poly_clear(rest);
    arb_clear(least);
    arb_clear(most);
    return done;
}

/* ---- a row on a piece of its cell ---- */

/* The part of a cell that lies in one interval, lo <= x <= hi, and functions of x on it */
struct piece {
    const struct interpolant_proof *proof;
    const struct pieces *p;
    struct cell cell;
    const double *c;
    int i;
    const struct interval *interval;
    arb_poly_t x, stored; /* the interval's variable; the number that it stores, its error included */
    arb_poly_t beta;
};

/* The sampled quantity from which a table's function follows */
static enum quantity stored_quantity(enum quantity quantity)
{
    switch (quantity) {
    case LOSS_QUOTIENT_ZERO_OVERLAP:
    case BETA_ZERO_OVERLAP:
    case BETA_QUOTIENT_ZERO_OVERLAP:
        return EPS_ZERO_OVERLAP;
    case LOSS_QUOTIENT_ZERO_FORCE:
    case BETA_ZERO_FORCE:
    case BETA_QUOTIENT_ZERO_FORCE:
        return EPS_ZERO_FORCE;
    default:
        return quantity;
    }
}

static void piece_init(struct piece *w, double lo, double hi)
{
    const enum quantity stored = stored_quantity(w->p->quantity);
    arb_t a, b, middle, half;
    arb_init(a);
    arb_init(b);
    arb_init(middle);
    arb_init(half);
    arb_poly_init(w->x);
    arb_poly_init(w->stored);
    arb_poly_init(w->beta);
    arb_set_d(a, lo);
    arb_set_d(b, hi);
    arb_add(middle, a, b, PREC);
    arb_sub(half, b, a, PREC);
    arb_mul_2exp_si(middle, middle, -1);
    arb_mul_2exp_si(half, half, -1);
    arb_poly_set_coeff_arb(w->x, 1, half);
    arb_poly_set_coeff_arb(w->x, 0, middle);
    to_unit(a, a, w->interval);
    to_unit(b, b, w->interval);
    arb_add(middle, a, b, PREC);
    arb_sub(half, b, a, PREC);
    arb_mul_2exp_si(middle, middle, -1);
    arb_mul_2exp_si(half, half, -1);
    rescale(w->stored, &w->proof->polynomial[w->i][stored], middle, half, PREC);
    arb_poly_set_round(w->stored, w->stored, ROW_PREC);
    add_radius(w->stored, &w->proof->error[w->i][stored]);
    shorten(w->stored);
    if (w->interval->variable == INTERVAL_ROOT)
        multiply(w->beta, w->x, w->x);
    else
        exponential(w->beta, 1, 1, w->x);
    arb_clear(a);
    arb_clear(b);
    arb_clear(middle);
    arb_clear(half);
}

static void piece_clear(struct piece *w)
{
    arb_poly_clear(w->x);
    arb_poly_clear(w->stored);
    arb_poly_clear(w->beta);
}

/* 1 - eps, from what the interval stores for eps */
static void loss_of(arb_poly_t y, const struct piece *w)
{
    if (w->interval->form == FORM_QUOTIENT) {
        multiply(y, w->stored, w->beta);
        return;
    }
    if (w->interval->form == FORM_POWER) {
        exponential(y, -5, 3, w->x);
        multiply(y, y, w->stored);
    } else {
        arb_poly_set(y, w->stored);
    }
    arb_poly_neg(y, y);
    add_double(y, 1);
}

/* The variable y of the table */
static bool variable_of(arb_poly_t y, const struct piece *w)
{
    bool done = true;
    switch (w->p->variable) {
    case VARIABLE_BETA:
        arb_poly_set(y, w->beta);
        break;
    case VARIABLE_ROOT_BETA:
    case VARIABLE_LOG_BETA:
        arb_poly_set(y, w->x);
        break;
    case VARIABLE_POWER_OCTAVES:
        multiply(y, w->beta, w->beta);
        multiply(y, y, y);
        multiply(y, y, w->beta);
        break;
    case VARIABLE_LOSS:
        loss_of(y, w);
        break;
    case VARIABLE_ROOT_LOSS:
        if (w->interval->form == FORM_QUOTIENT) {
            done = square_root(y, w->stored);
            multiply(y, y, w->x);
        } else {
            loss_of(y, w);
            done = square_root(y, y);
        }
        break;
    case VARIABLE_EPS_OCTAVES:
        loss_of(y, w);
        arb_poly_neg(y, y);
        add_double(y, 1);
        break;
    default:
        done = false;
    }
    for (slong k = 0; k < arb_poly_length(y); k++)
        arb_mul_2exp_si(arb_poly_get_coeff_ptr(y, k), arb_poly_get_coeff_ptr(y, k), -w->cell.octave);
    return done;
}

/* The row, c_0 + (c_0' + s (c_1 + c_2 t + ...)) */
static bool row_of(arb_poly_t row, const struct piece *w)
{
    arb_poly_t t, s;
    arb_poly_init(t);
    arb_poly_init(s);
    const bool done = variable_of(t, w);
    if (!w->cell.plain) {
        arb_t square;
        arb_init(square);
        arb_set_d(square, w->cell.node);
        arb_sqr(square, square, ROW_PREC);
        arb_neg(square, square);
        multiply(s, t, t);
        add_number(s, square);
        arb_clear(square);
    }
    add_double(t, -w->cell.node);
    if (w->cell.plain)
        arb_poly_set(s, t);
    arb_poly_zero(row);
    for (slong k = w->p->degree + 1; k >= 2; k--) {
        multiply(row, row, t);
        add_double(row, w->c[k]);
    }
    multiply(row, row, s);
    add_double(row, w->c[1]);
    add_double(row, w->c[0]);
    arb_poly_clear(t);
    arb_poly_clear(s);
    return done;
}

/* Makes difference/scale the relative error of the row. */
static bool relative_error(arb_poly_t difference, arb_poly_t scale, const struct piece *w)
{
    const bool quotient = w->interval->form == FORM_QUOTIENT;
    const bool done = row_of(difference, w);
    switch (w->p->quantity) {
    case LOSS_QUOTIENT_ZERO_OVERLAP:
    case LOSS_QUOTIENT_ZERO_FORCE:
        if (quotient) {
            arb_poly_set(scale, w->stored);
        } else {
            loss_of(scale, w);
            multiply(difference, difference, w->beta);
        }
        break;
    case BETA_QUOTIENT_ZERO_OVERLAP:
    case BETA_QUOTIENT_ZERO_FORCE:
        if (quotient) {
            multiply(difference, difference, w->stored);
            arb_poly_one(scale);
        } else {
            loss_of(scale, w);
            multiply(difference, difference, scale);
            arb_poly_set(scale, w->beta);
        }
        break;
    case BETA_ZERO_OVERLAP:
    case BETA_ZERO_FORCE:
        arb_poly_set(scale, w->beta);
        break;
    case EPS_ZERO_OVERLAP:
    case EPS_ZERO_FORCE:
        if (quotient) {
            loss_of(scale, w);
            arb_poly_neg(scale, scale);
            add_double(scale, 1);
        } else {
            arb_poly_set(scale, w->stored);
        }
        break;
    default:
        arb_poly_set(scale, w->stored);
    }
    arb_poly_sub(difference, difference, scale, ROW_PREC);
    return done;
}

/* An approximate |f/g| at t */
static double ratio_at(const arb_poly_t f, const arb_poly_t g, double t)
{
    arb_t at, x, y;
    arb_init(at);
    arb_init(x);
    arb_init(y);
    arb_set_d(at, t);
    arb_poly_evaluate(x, f, at, ROW_PREC);
    arb_poly_evaluate(y, g, at, ROW_PREC);
    const double ratio = fabs(arf_get_d(arb_midref(x), ARF_RND_NEAR) / arf_get_d(arb_midref(y), ARF_RND_NEAR));
    arb_clear(at);
    arb_clear(x);
    arb_clear(y);
    return ratio;
}

/* Upper bound of |f/g|, infinite where g may vanish. Halves the range until the bound is near `known`, a value that the
 * ratio reaches. */
static double largest_ratio(const arb_poly_t f, const arb_poly_t g, double known, int halvings)
{
    arb_t x, y;
    mag_t mag;
    arb_init(x);
    arb_init(y);
    mag_init(mag);
    range_of(x, f);
    range_of(y, g);
    arb_div(x, x, y, ROW_PREC);
    arb_get_mag(mag, x);
    double bound = mag_get_d(mag);
    if (bound > known * NEAR_KNOWN && halvings > 0) {
        arb_poly_t part, scale;
        arb_poly_init(part);
        arb_poly_init(scale);
        bound = 0;
        for (int side = -1; side <= 1; side += 2) {
            arb_set_d(x, side * 0.5);
            arb_set_d(y, 0.5);
            rescale(part, f, x, y, ROW_PREC);
            rescale(scale, g, x, y, ROW_PREC);
            bound = fmax(bound, largest_ratio(part, scale, known, halvings - 1));
        }
        arb_poly_clear(part);
        arb_poly_clear(scale);
    }
    arb_clear(x);
    arb_clear(y);
    mag_clear(mag);
    return bound;
}

/* Bound of the row's relative error for lo <= x <= hi in interval i; infinite without a proof */
static double piece_error(const struct interpolant_proof *proof, const struct pieces *p, slong row, const double *c,
                          int i, double lo, double hi)
{
    struct piece w = {.proof = proof,
                      .p = p,
                      .cell = pieces_cell(p, row),
                      .c = c,
                      .i = i,
                      .interval = &interpolant_layout_of(proof->f)->interval[i]};
    arb_poly_t difference, scale;
    arb_poly_init(difference);
    arb_poly_init(scale);
    piece_init(&w, lo, hi);
    const bool done = relative_error(difference, scale, &w);
    shorten(difference);
    double known = 0;
    for (int k = -POINTS; k <= POINTS && done; k++)
        known = fmax(known, ratio_at(difference, scale, k / (double)POINTS));
    const double error = done ? largest_ratio(difference, scale, known, HALVINGS) : HUGE_VAL;
    piece_clear(&w);
    arb_poly_clear(difference);
    arb_poly_clear(scale);
    return error;
}

/* ---- cells ---- */

/* More than the rounding of a few functions of libm */
#define SLACK 1e-13

/* A range of sqrt(beta), or of ln(beta) for tables in that variable */
struct range {
    enum interval_variable variable;
    double lo, hi;
};

/* sqrt(beta) where an inverse function has the argument x, nearly */
static bool inverse_place(double *z, const struct interpolant_proof *proof, enum quantity quantity, double x)
{
    arb_t place, value;
    arb_init(place);
    arb_init(value);
    arb_set_d(place, x);
    const bool found = interpolant_inverse(value, proof->f, quantity, place, PREC) == STATUS_OK;
    if (quantity == BETA_QUOTIENT_ZERO_OVERLAP || quantity == BETA_QUOTIENT_ZERO_FORCE)
        arb_mul(value, value, place, PREC);
    *z = sqrt(arf_get_d(arb_midref(value), ARF_RND_NEAR));
    arb_clear(place);
    arb_clear(value);
    return found;
}

/* A range that should contain every place of the cell */
static bool cell_range(struct range *range, const struct interpolant_proof *proof, const struct pieces *p,
                       const struct cell *cell)
{
    double lo = ldexp(cell->lo, (int)cell->octave), hi = ldexp(cell->hi, (int)cell->octave);
    range->variable = INTERVAL_ROOT;
    switch (p->variable) {
    case VARIABLE_LOG_BETA:
        *range = (struct range){INTERVAL_LOG, lo, hi};
        return true;
    case VARIABLE_ROOT_BETA:
        *range = (struct range){INTERVAL_ROOT, lo, hi};
        return true;
    case VARIABLE_BETA:
        lo = sqrt(lo);
        hi = sqrt(hi);
        break;
    case VARIABLE_POWER_OCTAVES:
        lo = pow(lo, 0.1);
        hi = pow(hi, 0.1);
        break;
    case VARIABLE_ROOT_LOSS:
        lo *= lo;
        hi *= hi;
        /* fall through */
    case VARIABLE_LOSS:
    case VARIABLE_EPS_OCTAVES:
        if (!inverse_place(&range->lo, proof, p->quantity, p->variable == VARIABLE_EPS_OCTAVES ? hi : lo) ||
            !inverse_place(&range->hi, proof, p->quantity, p->variable == VARIABLE_EPS_OCTAVES ? lo : hi))
            return false;
        lo = range->lo;
        hi = range->hi;
        break;
    default:
        return false;
    }
    range->lo = lo * (1 - SLACK);
    range->hi = hi * (1 + SLACK);
    return true;
}

/* Sign of y - limit, y the table's variable at x in interval i: 1 or -1 if proved, otherwise 0 */
static int side_of(const struct interpolant_proof *proof, const struct pieces *p, slong row, int i, double x,
                   double limit)
{
    struct piece w = {.proof = proof,
                      .p = p,
                      .cell = pieces_cell(p, row),
                      .i = i,
                      .interval = &interpolant_layout_of(proof->f)->interval[i]};
    arb_poly_t y;
    arb_t range;
    arb_poly_init(y);
    arb_init(range);
    piece_init(&w, x, x);
    const bool done = variable_of(y, &w);
    add_double(y, -limit);
    range_of(range, y);
    const int side = !done ? 0 : arb_is_nonnegative(range) ? 1 : arb_is_nonpositive(range) ? -1 : 0;
    piece_clear(&w);
    arb_poly_clear(y);
    arb_clear(range);
    return side;
}

static bool is_inverse(const struct pieces *p)
{
    return p->variable == VARIABLE_LOSS || p->variable == VARIABLE_ROOT_LOSS || p->variable == VARIABLE_EPS_OCTAVES;
}

/* Whether an end of an inverse's range is not inside the cell. 1 - eps = 0 at beta = 0. */
static bool end_reached(const struct interpolant_proof *proof, const struct pieces *p, slong row, int i, double x,
                        bool first)
{
    const struct cell cell = pieces_cell(p, row);
    const bool falls = p->variable == VARIABLE_EPS_OCTAVES, high = falls == first;
    if (!is_inverse(p) || (first && x == 0 && cell.lo == 0))
        return true;
    return side_of(proof, p, row, i, x, high ? cell.hi : cell.lo) == (high ? 1 : -1);
}

/* Bound of the row's relative error in its whole cell; infinite without a proof. A range in sqrt(beta) that goes beyond
 * the last such interval ends with ln(beta). */
static double row_error(const struct interpolant_proof *proof, const struct pieces *p, slong row, const double *c)
{
    const struct interpolant_layout *const layout = interpolant_layout_of(proof->f);
    const enum quantity stored = stored_quantity(p->quantity);
    const struct cell cell = pieces_cell(p, row);
    struct range range;
    double error = 0, reached;
    bool first = true;
    if (!cell_range(&range, proof, p, &cell))
        return HUGE_VAL;
    reached = range.lo;
    for (int i = 0; i < layout->intervals && reached < range.hi; i++) {
        const struct interval *const interval = &layout->interval[i];
        if (!arb_is_finite(&proof->error[i][stored]))
            continue;
        double lo = reached, hi = range.hi;
        const bool by_log = interval->variable == INTERVAL_LOG && range.variable == INTERVAL_ROOT;
        if (by_log) {
            lo = 2 * log(lo) - SLACK;
            hi = 2 * log(hi) + SLACK;
        } else if (interval->variable != range.variable) {
            continue;
        }
        if (lo >= interval->hi)
            continue;
        if (lo < interval->lo)
            return HUGE_VAL;
        const bool last = hi <= interval->hi;
        hi = fmin(hi, interval->hi);
        error = fmax(error, piece_error(proof, p, row, c, i, lo, hi));
        if ((first && !end_reached(proof, p, row, i, lo, true)) || (last && !end_reached(proof, p, row, i, hi, false)))
            return HUGE_VAL;
        first = false;
        reached = last ? range.hi : hi;
    }
    return reached < range.hi ? HUGE_VAL : error;
}

double row_proof_bits(const struct interpolant_proof *proof, const struct pieces *p, slong row, const double *c)
{
    const double error = row_error(proof, p, row, c);
    return isfinite(error) ? -log2(error) : NAN;
}

bool row_proof_covers(const struct interpolant_proof *proof, const struct pieces *p)
{
    const struct interpolant_layout *const layout = interpolant_layout_of(proof->f);
    const enum quantity stored = stored_quantity(p->quantity);
    for (int i = 0; i < layout->intervals; i++)
        if (p->variable == VARIABLE_LOG_BETA && layout->interval[i].variable == INTERVAL_LOG &&
            !(ellipse_bound_set(&layout->interval[i]) & 1u << stored))
            return false;
    return true;
}

struct proving {
    struct pieces *p;
    const struct interpolant_proof *proof;
    double *bits;
};

static void prove_row(void *context, slong row)
{
    struct proving *const work = context;
    work->bits[row] = row_proof_bits(work->proof, work->p, row, work->p->value + row * (work->p->degree + 2));
}

int row_proof_table(struct pieces *p, const struct interpolant_proof *proof)
{
    struct proving work = {.p = p, .proof = proof, .bits = p->bits};
    parallel_for(prove_row, &work, p->rows, p->name);
    for (slong row = 0; row < p->rows; row++)
        if (!(p->bits[row] >= p->least_bits))
            return fail("%s, row %ld: %.2f bits are proved, not the %.1f it must reach", p->name, (long)row,
                        p->bits[row], p->least_bits);
    p->proved = true;
    return STATUS_OK;
}
