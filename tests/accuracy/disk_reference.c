/* SPDX-License-Identifier: MIT */
#include "disk_reference.h"

#include <math.h>

/* ---- the law ---- */

const struct disk_function disk_functions[DISK_KINDS] = {
    [DISK_LOAD] = {"load", cor_disk_load, cor_disk_compression_limit},
    [DISK_COMPRESSION] = {"compression", cor_disk_compression, cor_disk_load_limit},
    [DISK_ENERGY] = {"energy", cor_disk_energy, cor_disk_load_limit},
    [DISK_LOAD_OF_ENERGY] = {"load_of_energy", cor_disk_load_of_energy, cor_disk_energy_limit},
    [DISK_MAX_LOAD] = {"max_load", cor_disk_max_load, cor_disk_speed_limit},
    [DISK_MAX_COMPRESSION] = {"max_compression", cor_disk_max_compression, cor_disk_speed_limit},
};

void disk_constant(arb_t b, double nu, enum cor_disk_datum datum, slong prec)
{
    arb_set_d(b, nu);
    arb_add_ui(b, b, 1, prec);
    arb_neg(b, b); /* printed */
    if (datum == COR_DISK_DATUM_DIAMETER)
        arb_set_si(b, -1);
    if (datum == COR_DISK_DATUM_CENTRE_OF_MASS) {
        arb_t ln2;
        arb_init(ln2);
        arb_const_log2(ln2, prec);
        arb_mul_2exp_si(b, b, -2);
        arb_submul_ui(b, ln2, 2, prec);
        arb_clear(ln2);
    }
}

void disk_minus_w(arb_t w, const arb_t z, slong prec)
{
    arb_neg(w, z);
    arb_lambertw(w, w, 1, prec);
    arb_neg(w, w);
}

/* delta (energy = 0) or V (energy = 1) of a load, (57) */
static void disk_law(arb_t y, const arb_t load, const arb_t b, int energy, slong prec)
{
    arb_t factor;
    arb_init(factor);
    arb_const_pi(factor, prec);
    arb_mul_2exp_si(y, factor, 2);
    arb_div(y, y, load, prec);
    arb_log(y, y, prec);
    arb_add(y, y, b, prec);
    arb_div(factor, load, factor, prec);
    if (energy) {
        arb_mul_2exp_si(y, y, 1);
        arb_sub_ui(y, y, 1, prec);
        arb_mul_2exp_si(y, y, -2);
        arb_mul(factor, factor, load, prec);
    }
    arb_mul(y, y, factor, prec);
    arb_clear(factor);
}

/* The largest load at an energy V, (V e^(1-2b)/(4 pi) = w e^(-w)): sqrt(4 pi V/w) */
static void disk_load_of_energy(arb_t load, const arb_t energy, const arb_t b, slong prec)
{
    arb_t z, four_pi;
    arb_init(z);
    arb_init(four_pi);
    arb_const_pi(four_pi, prec);
    arb_mul_2exp_si(four_pi, four_pi, 2);
    arb_mul_2exp_si(z, b, 1);
    arb_neg(z, z);
    arb_add_ui(z, z, 1, prec);
    arb_exp(z, z, prec);
    arb_mul(z, z, energy, prec);
    arb_div(z, z, four_pi, prec);
    disk_minus_w(load, z, prec);
    arb_mul(four_pi, four_pi, energy, prec);
    arb_div(load, four_pi, load, prec);
    arb_sqrt(load, load, prec);
    arb_clear(z);
    arb_clear(four_pi);
}

bool disk_value(arb_t y, enum disk_kind kind, double argument, double nu, enum cor_disk_datum datum, slong prec)
{
    bool consistent = true;
    arb_t b, x, back;
    arb_init(b);
    arb_init(x);
    arb_init(back);
    disk_constant(b, nu, datum, prec);
    arb_set_d(x, argument);
    switch (kind) {
    case DISK_LOAD:
        arb_neg(back, b);
        arb_exp(back, back, prec);
        arb_mul(back, back, x, prec);
        arb_mul_2exp_si(back, back, -2);
        disk_minus_w(y, back, prec);
        arb_div(y, x, y, prec);
        arb_const_pi(back, prec);
        arb_mul(y, y, back, prec);
        disk_law(back, y, b, 0, prec);
        consistent = arb_overlaps(back, x);
        break;
    case DISK_COMPRESSION:
    case DISK_ENERGY:
        disk_law(y, x, b, kind == DISK_ENERGY, prec);
        break;
    case DISK_MAX_LOAD:
    case DISK_MAX_COMPRESSION:
        arb_mul(x, x, x, prec);
        arb_const_pi(back, prec);
        arb_mul(x, x, back, prec);
        arb_mul_2exp_si(x, x, -1); /* fall through */
    case DISK_LOAD_OF_ENERGY:
        disk_load_of_energy(y, x, b, prec);
        disk_law(back, y, b, 1, prec);
        consistent = arb_overlaps(back, x);
        if (kind == DISK_MAX_COMPRESSION) {
            arb_set(x, y);
            disk_law(y, x, b, 0, prec);
        }
        break;
    case DISK_KINDS:
        break;
    }
    arb_clear(b);
    arb_clear(x);
    arb_clear(back);
    return consistent;
}

/* ---- a collision in time ---- */

/* z = (v^2/8) exp(1 - 2 b) */
static void indefinite_argument(arb_t z, double v, double nu, enum cor_disk_datum datum, slong prec)
{
    arb_t x;
    arb_init(x);
    disk_constant(z, nu, datum, prec);
    arb_mul_2exp_si(z, z, 1);
    arb_sub_ui(z, z, 1, prec);
    arb_neg(z, z);
    arb_exp(z, z, prec);
    arb_set_d(x, v);
    arb_mul(z, z, x, prec);
    arb_mul(z, z, x, prec);
    arb_mul_2exp_si(z, z, -3);
    arb_clear(x);
}

/* sqrt(-w/2) dtheta/dy at y, and sin(theta) dtheta/dy */
static void indefinite_node(arb_t rate, arb_t weight, const arb_t y, const arb_t z, const arb_t pi, slong prec)
{
    arb_t e, one, sine;
    arb_init(e);
    arb_init(one);
    arb_init(sine);
    const int late = arf_sgn(arb_midref(y)) > 0;
    arb_sinh_cosh(e, weight, y, prec);
    arb_mul(e, e, pi, prec);
    arb_neg(e, e);
    arb_exp(e, e, prec);
    arb_add_ui(one, e, 1, prec);
    /* (pi/2) pi cosh(y) e/(1 + e)^2 */
    arb_mul(weight, weight, e, prec);
    arb_div(weight, weight, one, prec);
    arb_div(weight, weight, one, prec);
    arb_mul(weight, weight, pi, prec);
    arb_mul(weight, weight, pi, prec);
    arb_mul_2exp_si(weight, weight, -1);
    /* sine from the nearer end */
    arb_div(sine, pi, one, prec);
    arb_mul_2exp_si(sine, sine, -1);
    if (late) {
        arb_mul(sine, sine, e, prec); /* pi/2 - theta */
        arb_cos(sine, sine, prec);
    } else {
        arb_sin(sine, sine, prec);
    }
    arb_sqr(rate, sine, prec);
    arb_mul(rate, rate, z, prec);
    disk_minus_w(rate, rate, prec);
    if (!arb_is_finite(rate)) { /* the ball reaches over the branch point, where -w = 1 to half of the digits */
        arb_one(rate);
        arb_add_error_2exp_si(rate, -prec / 2 + 20);
    }
    arb_mul_2exp_si(rate, rate, -1);
    arb_sqrt(rate, rate, prec);
    arb_mul(rate, rate, weight, prec);
    arb_mul(weight, weight, sine, prec);
    arb_clear(e);
    arb_clear(one);
    arb_clear(sine);
}

void disk_contact_time(arb_t tau, arb_t halved, double v, double nu, enum cor_disk_datum datum, int level, slong prec)
{
    const slong last = (slong)ldexp(3.25, level);
    arb_t z, pi, y, rate, weight;
    arb_init(z);
    arb_init(pi);
    arb_init(y);
    arb_init(rate);
    arb_init(weight);
    arb_const_pi(pi, prec);
    indefinite_argument(z, v, nu, datum, prec);
    arb_zero(tau);
    arb_zero(halved);
    for (slong k = -last; k <= last; k++) {
        arb_set_si(y, k);
        arb_mul_2exp_si(y, y, -level);
        indefinite_node(rate, weight, y, z, pi, prec);
        arb_add(tau, tau, rate, prec);
        if (k % 2 == 0)
            arb_add(halved, halved, rate, prec);
    }
    arb_mul_2exp_si(tau, tau, 1 - level); /* 2 s(0) */
    arb_mul_2exp_si(halved, halved, 2 - level);
    arb_clear(z);
    arb_clear(pi);
    arb_clear(y);
    arb_clear(rate);
    arb_clear(weight);
}

void indefinite_init(struct indefinite *f, double v, double nu, enum cor_disk_datum datum, int level, slong prec)
{
    const slong last = (slong)ldexp(3.25, level);
    const slong n = f->nodes = 2 * last + 1;
    arb_poly_t rate, kernel, product;
    arb_t z, pi, y, x;
    f->prec = prec;
    f->sin_weight = _arb_vec_init(n);
    f->s = _arb_vec_init(n);
    arb_poly_init2(rate, n);
    arb_poly_init2(kernel, 2 * n - 1);
    arb_poly_init(product);
    arb_init(z);
    arb_init(pi);
    arb_init(y);
    arb_init(x);
    arb_const_pi(pi, prec);
    indefinite_argument(z, v, nu, datum, prec);
    for (slong k = 0; k < n; k++) {
        arb_set_si(y, k - last);
        arb_mul_2exp_si(y, y, -level);
        indefinite_node(x, f->sin_weight + k, y, z, pi, prec);
        arb_mul_2exp_si(f->sin_weight + k, f->sin_weight + k, -level);
        arb_mul_2exp_si(x, x, -level);
        arb_poly_set_coeff_arb(rate, n - 1 - k, x); /* from the last node on */
    }
    /* s_k = sum over j of rate_j (1/2 + Si(pi (j - k))/pi): with j' = n - 1 - j a product of polynomials */
    for (slong m = 0; m < n; m++) {
        arb_mul_si(x, pi, m, prec);
        arb_hypgeom_si(x, x, prec);
        arb_div(x, x, pi, prec);
        arb_set_d(y, 0.5);
        arb_add(z, y, x, prec);
        arb_poly_set_coeff_arb(kernel, n - 1 + m, z); /* j - k = m */
        arb_sub(z, y, x, prec);
        arb_poly_set_coeff_arb(kernel, n - 1 - m, z);
    }
    arb_poly_mul(product, rate, kernel, prec);
    for (slong k = 0; k < n; k++) /* j' + (n - 1 + j - k) = 2 (n - 1) - k */
        arb_poly_get_coeff_arb(f->s + k, product, 2 * (n - 1) - k);
    arb_poly_clear(rate);
    arb_poly_clear(kernel);
    arb_poly_clear(product);
    arb_clear(z);
    arb_clear(pi);
    arb_clear(y);
    arb_clear(x);
}

void indefinite_clear(struct indefinite *f)
{
    _arb_vec_clear(f->sin_weight, f->nodes);
    _arb_vec_clear(f->s, f->nodes);
}

void indefinite_integral(arb_t integral, const struct indefinite *f, double omega)
{
    arb_t x, w;
    arb_init(x);
    arb_init(w);
    arb_set_d(w, omega);
    arb_zero(integral);
    for (slong k = 0; k < f->nodes; k++) {
        arb_mul(x, f->s + k, w, f->prec);
        arb_cos(x, x, f->prec);
        arb_addmul(integral, x, f->sin_weight + k, f->prec);
    }
    arb_clear(x);
    arb_clear(w);
}
