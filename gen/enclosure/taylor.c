/* SPDX-License-Identifier: MIT */
#include "enclosure/taylor.h"

#include <math.h>
#include <stdlib.h>

/* Norms and remainders are wanted to a few digits. */
#define NORM_BITS 40
/* A step is about the radius of convergence times 2^-STEP_BITS: every term is worth that many bits. Cost goes
 * like 2^q/q^2, least near q = 3. */
#define STEP_BITS 3

struct taylor_power {
    slong exponent;
    int left, right; /* nodes multiplied; -1: w itself */
    arb_ptr c;       /* jets x (degree + 1) */
};

static slong stride(const struct taylor *y)
{
    return y->degree + 1;
}

static arb_ptr block_new(const struct taylor *y)
{
    return _arb_vec_init(y->jets * stride(y));
}

/* Node of w^exponent, made with its factors where it is not there yet: -1 for w. */
static int power_node(struct taylor *y, slong exponent)
{
    if (exponent == 1)
        return -1;
    for (int i = 0; i < y->powers; i++)
        if (y->power[i].exponent == exponent)
            return i;
    const int left = power_node(y, exponent / 2), right = power_node(y, exponent - exponent / 2);
    y->power = flint_realloc(y->power, (size_t)(y->powers + 1) * sizeof *y->power);
    y->power[y->powers] = (struct taylor_power){exponent, left, right, block_new(y)};
    return y->powers++;
}

/* Nodes are numbered from 0, w is -1 and the number 1 is ONE. */
enum { NODE_ONE = -2 };

static int node_of(struct taylor *y, slong exponent)
{
    return exponent == 0 ? NODE_ONE : power_node(y, exponent);
}

static arb_ptr node_block(const struct taylor *y, int node)
{
    return node == -1 ? y->w : y->power[node].c;
}

void taylor_init(struct taylor *y, const struct law *law, slong jets, slong degree, slong prec)
{
    const slong m = FLINT_MIN(law->ad, law->bd);
    y->law = *law;
    y->jets = jets;
    y->degree = degree;
    y->prec = prec;
    y->power = NULL;
    y->powers = 0;
    y->c1 = _arb_vec_init(jets);
    y->c2 = _arb_vec_init(jets);
    y->w = block_new(y);
    y->v = block_new(y);
    y->t = block_new(y);
    y->force = block_new(y);
    y->product = block_new(y);
    y->damped = block_new(y);
    y->node_t = node_of(y, law->d - 1);
    y->node_outer = node_of(y, law->d - 1 + m);
    y->node_damping = node_of(y, law->bd - m);
    y->node_elastic = node_of(y, law->ad - m);
    mag_init(y->weight);
    mag_one(y->weight);
    mag_init(y->error_w);
    mag_init(y->error_v);
    mag_init(y->error_t);
    arb_init(y->step);
}

void taylor_clear(struct taylor *y)
{
    const slong size = y->jets * stride(y);
    _arb_vec_clear(y->c1, y->jets);
    _arb_vec_clear(y->c2, y->jets);
    _arb_vec_clear(y->w, size);
    _arb_vec_clear(y->v, size);
    _arb_vec_clear(y->t, size);
    _arb_vec_clear(y->force, size);
    _arb_vec_clear(y->product, size);
    _arb_vec_clear(y->damped, size);
    for (int i = 0; i < y->powers; i++)
        _arb_vec_clear(y->power[i].c, size);
    flint_free(y->power);
    mag_clear(y->weight);
    mag_clear(y->error_w);
    mag_clear(y->error_v);
    mag_clear(y->error_t);
    arb_clear(y->step);
}

/* Coefficient n of f g, all jets: sum over i + j = n and p + q = l. */
static void convolve(arb_ptr out, arb_srcptr f, arb_srcptr g, slong n, const struct taylor *y)
{
    const slong size = stride(y);
    arb_t half;
    arb_init(half);
    for (slong l = 0; l < y->jets; l++) {
        arb_ptr sum = out + l * size + n;
        arb_zero(sum);
        if (f != g) {
            for (slong p = 0; p <= l; p++)
                arb_dot(sum, sum, 0, f + p * size, 1, g + (l - p) * size + n, -1, n + 1, y->prec);
            continue;
        }
        /* A square: each pair of unlike factors once, twice its value. */
        for (slong p = 0; 2 * p < l; p++)
            arb_dot(sum, sum, 0, f + p * size, 1, f + (l - p) * size + n, -1, n + 1, y->prec);
        if (l % 2 == 0) {
            arb_srcptr own = f + l / 2 * size;
            arb_dot(sum, sum, 0, own, 1, own + n, -1, (n + 1) / 2, y->prec);
        }
        arb_mul_2exp_si(sum, sum, 1);
        if (l % 2 == 0 && n % 2 == 0) {
            arb_sqr(half, f + l / 2 * size + n / 2, y->prec);
            arb_add(sum, sum, half, y->prec);
        }
    }
    arb_clear(half);
}

/* out_l += sum_p c_p f_(l-p), at coefficient n. */
static void add_scaled(arb_ptr out, arb_srcptr c, arb_srcptr f, slong n, const struct taylor *y)
{
    const slong size = stride(y);
    for (slong l = 0; l < y->jets; l++)
        for (slong p = 0; p <= l; p++)
            if (!arb_is_zero(c + p))
                arb_addmul(out + l * size + n, c + p, f + (l - p) * size + n, y->prec);
}

static void make_force(struct taylor *y, slong n)
{
    const slong size = stride(y);
    for (slong l = 0; l < y->jets; l++)
        arb_zero(y->force + l * size + n);
    if (y->node_damping == NODE_ONE) {
        add_scaled(y->force, y->c1, y->v, n, y);
    } else {
        convolve(y->damped, node_block(y, y->node_damping), y->v, n, y);
        add_scaled(y->force, y->c1, y->damped, n, y);
    }
    if (y->node_elastic != NODE_ONE)
        add_scaled(y->force, y->c2, node_block(y, y->node_elastic), n, y);
    else if (n == 0)
        for (slong l = 0; l < y->jets; l++)
            arb_add(y->force + l * size, y->force + l * size, y->c2 + l, y->prec);
}

void taylor_expand(struct taylor *y)
{
    const slong size = stride(y);
    for (slong n = 0; n < y->degree; n++) {
        for (int i = 0; i < y->powers; i++)
            convolve(y->power[i].c, node_block(y, y->power[i].left), node_block(y, y->power[i].right), n, y);
        make_force(y, n);
        if (y->node_outer != NODE_ONE)
            convolve(y->product, node_block(y, y->node_outer), y->force, n, y);
        for (slong l = 0; l < y->jets; l++) {
            const slong at = l * size + n;
            arb_srcptr g = y->node_outer == NODE_ONE ? y->force : y->product;
            arb_div_si(y->w + at + 1, y->v + at, y->law.d * (n + 1), y->prec);
            arb_div_si(y->v + at + 1, g + at, -(n + 1), y->prec);
            if (y->node_t == NODE_ONE)
                arb_set_si(y->t + at + 1, n == 0 && l == 0 ? 1 : 0);
            else
                arb_div_si(y->t + at + 1, node_block(y, y->node_t) + at, n + 1, y->prec);
        }
    }
}

/* Norms of the coefficients of a component times h^n, as a polynomial with upper bounds for coefficients. */
static void norm_poly(arb_poly_t p, arb_srcptr f, const struct taylor *y, const arb_t h)
{
    const slong size = stride(y);
    mag_t norm, term, power, mh;
    mag_init(norm);
    mag_init(term);
    mag_init(power);
    mag_init(mh);
    arb_get_mag(mh, h);
    mag_one(power);
    arb_poly_fit_length(p, size);
    for (slong n = 0; n < size; n++) {
        mag_zero(norm);
        for (slong l = y->jets - 1; l >= 0; l--) {
            mag_mul(norm, norm, y->weight);
            arb_get_mag(term, f + l * size + n);
            mag_add(norm, norm, term);
        }
        mag_mul(norm, norm, power);
        arf_set_mag(arb_midref(p->coeffs + n), norm);
        mag_zero(arb_radref(p->coeffs + n));
        mag_mul(power, power, mh);
    }
    _arb_poly_set_length(p, size);
    _arb_poly_normalise(p);
    mag_clear(norm);
    mag_clear(term);
    mag_clear(power);
    mag_clear(mh);
}

/* Upper bound of the sum of coefficients from `first` on. */
static void tail_sum(arb_t sum, const arb_poly_t p, slong first)
{
    mag_t m, term;
    mag_init(m);
    mag_init(term);
    for (slong n = p->length - 1; n >= first; n--) {
        arb_get_mag(term, p->coeffs + n);
        mag_add(m, m, term);
    }
    arf_set_mag(arb_midref(sum), m);
    mag_zero(arb_radref(sum));
    mag_clear(m);
    mag_clear(term);
}

static void parameter_norm(arb_t norm, arb_srcptr c, const struct taylor *y)
{
    mag_t m, term;
    mag_init(m);
    mag_init(term);
    for (slong l = y->jets - 1; l >= 0; l--) {
        mag_mul(m, m, y->weight);
        arb_get_mag(term, c + l);
        mag_add(m, m, term);
    }
    arf_set_mag(arb_midref(norm), m);
    mag_zero(arb_radref(norm));
    mag_clear(m);
    mag_clear(term);
}

/* k c M^e, zero if k is. */
static void monomial(arb_t y, slong k, const arb_t c, const arb_t M, slong e)
{
    if (k == 0) {
        arb_zero(y);
        return;
    }
    arb_pow_ui(y, M, (ulong)e, NORM_BITS);
    arb_mul(y, y, c, NORM_BITS);
    arb_mul_si(y, y, k, NORM_BITS);
}

/* The polynomials p of degree N solve the equations up to residuals whose norms on [0, h] are the tails of the
 * products from sigma^N on. By Gronwall's inequality the exact solution is within
 * max(kappa r_w, r_v) h exp(L h) of them, in the norm max(kappa |e_w|, |e_v|), as long as that stays inside the
 * tube on which L bounds the derivatives. */
static bool prove_step(struct taylor *y, const arb_t h)
{
    enum { C1, C2, MW, MV, RW, RV, RT, LW, LV, KAPPA, L, E, X, COUNT };
    const slong d = y->law.d, ad = y->law.ad, bd = y->law.bd, N = y->degree;
    arb_ptr a = _arb_vec_init(COUNT);
    arb_poly_t W, V, P, Q;
    bool inside = false;
    arb_poly_init(W);
    arb_poly_init(V);
    arb_poly_init(P);
    arb_poly_init(Q);

    parameter_norm(a + C1, y->c1, y);
    parameter_norm(a + C2, y->c2, y);
    norm_poly(W, y->w, y, h);
    norm_poly(V, y->v, y, h);

    arb_poly_pow_ui(P, W, (ulong)(d - 1), NORM_BITS);
    tail_sum(a + RT, P, N);
    arb_poly_pow_ui(Q, W, (ulong)bd, NORM_BITS);
    arb_poly_mul(Q, Q, V, NORM_BITS);
    arb_poly_scalar_mul(Q, Q, a + C1, NORM_BITS);
    {
        arb_poly_t R;
        arb_poly_init(R);
        arb_poly_pow_ui(R, W, (ulong)ad, NORM_BITS);
        arb_poly_scalar_mul(R, R, a + C2, NORM_BITS);
        arb_poly_add(Q, Q, R, NORM_BITS);
        arb_poly_clear(R);
    }
    arb_poly_mul(Q, Q, P, NORM_BITS);
    tail_sum(a + RV, Q, N);
    tail_sum(a + RW, V, N);
    arb_div_si(a + RW, a + RW, d, NORM_BITS);

    tail_sum(a + MW, W, 0);
    tail_sum(a + MV, V, 0);
    arb_set_d(a + X, 1.0 + 0x1p-10);
    arb_mul(a + MW, a + MW, a + X, NORM_BITS);
    arb_mul(a + MV, a + MV, a + X, NORM_BITS);

    monomial(a + LW, d - 1 + bd, a + C1, a + MW, d - 2 + bd);
    arb_mul(a + LW, a + LW, a + MV, NORM_BITS);
    monomial(a + X, d - 1 + ad, a + C2, a + MW, d - 2 + ad);
    arb_add(a + LW, a + LW, a + X, NORM_BITS);
    monomial(a + LV, 1, a + C1, a + MW, d - 1 + bd);

    /* kappa > 0 is free; this one balances the two rows. */
    arb_mul_si(a + KAPPA, a + LW, d, NORM_BITS);
    arb_sqrt(a + KAPPA, a + KAPPA, NORM_BITS);
    arb_get_mid_arb(a + KAPPA, a + KAPPA);
    if (!arb_is_positive(a + KAPPA))
        arb_one(a + KAPPA);
    arb_div(a + L, a + LW, a + KAPPA, NORM_BITS);
    arb_add(a + L, a + L, a + LV, NORM_BITS);
    arb_div_si(a + X, a + KAPPA, d, NORM_BITS);
    arb_max(a + L, a + L, a + X, NORM_BITS);

    arb_mul(a + E, a + RW, a + KAPPA, NORM_BITS);
    arb_max(a + E, a + E, a + RV, NORM_BITS);
    arb_mul(a + E, a + E, h, NORM_BITS);
    arb_mul(a + X, a + L, h, NORM_BITS);
    arb_exp(a + X, a + X, NORM_BITS);
    arb_mul(a + E, a + E, a + X, NORM_BITS);
    arb_get_mag(y->error_v, a + E);
    arb_div(a + X, a + E, a + KAPPA, NORM_BITS);
    arb_get_mag(y->error_w, a + X);

    arb_mul_2exp_si(a + MW, a + MW, -11);
    arb_mul_2exp_si(a + MV, a + MV, -11);
    inside = arb_lt(a + X, a + MW) && arb_lt(a + E, a + MV);
    arb_mul_2exp_si(a + MW, a + MW, 11);

    /* A zero of w must not hide inside the step: either w cannot fall that far, or (kappa w, v), which turns
     * at 2 L at most, turns by less than pi and cannot come back from w = 0. */
    arb_mul(a + X, a + L, h, NORM_BITS);
    arb_mul_2exp_si(a + X, a + X, 1);
    arb_sub_si(a + X, a + X, 3, NORM_BITS);
    if (!arb_is_negative(a + X)) {
        arb_mul(a + X, a + MV, h, NORM_BITS);
        arb_mul_2exp_si(a + X, a + X, 11);
        arb_div_si(a + X, a + X, d, NORM_BITS);
        inside = inside && arb_gt(y->w, a + X);
    }
    arf_set_mag(arb_midref(a + X), y->error_w);
    mag_zero(arb_radref(a + X));

    /* t' = w^(d-1) */
    monomial(a + LW, d - 1, a + X, a + MW, d - 2);
    arb_add(a + RT, a + RT, a + LW, NORM_BITS);
    arb_mul(a + RT, a + RT, h, NORM_BITS);
    arb_get_mag(y->error_t, a + RT);

    _arb_vec_clear(a, COUNT);
    arb_poly_clear(W);
    arb_poly_clear(V);
    arb_poly_clear(P);
    arb_poly_clear(Q);
    return inside;
}

/* log2 of the radius of convergence, guessed from the last coefficients. */
static double radius_guess(const struct taylor *y)
{
    arb_srcptr component[2] = {y->w, y->v};
    mag_t m;
    double radius = HUGE_VAL;
    mag_init(m);
    for (int i = 0; i < 2; i++) {
        double scale = -HUGE_VAL;
        for (slong l = 0; l < y->jets; l++) {
            arb_get_mag(m, component[i] + l * stride(y));
            if (!mag_is_zero(m))
                scale = fmax(scale, mag_get_d_log2_approx(m) + (double)l * mag_get_d_log2_approx(y->weight));
        }
        if (scale == -HUGE_VAL)
            scale = 0.0;
        for (slong n = y->degree - y->degree / 4; n <= y->degree; n++)
            for (slong l = 0; l < y->jets; l++) {
                arb_get_mag(m, component[i] + l * stride(y) + n);
                if (!mag_is_zero(m))
                    radius =
                        fmin(radius, (scale - mag_get_d_log2_approx(m) - (double)l * mag_get_d_log2_approx(y->weight)) /
                                         (double)n);
            }
    }
    mag_clear(m);
    return radius == HUGE_VAL ? 0.0 : radius;
}

bool taylor_choose_step(struct taylor *y)
{
    mag_t goal, scale;
    bool proved = false;
    mag_init(goal);
    mag_init(scale);
    /* As good as the rounding errors, relative to the velocity in hand. */
    arb_get_mag(goal, y->v);
    arb_get_mag(scale, y->w);
    mag_max(goal, goal, scale);
    mag_mul_2exp_si(goal, goal, -y->prec);
    double exponent = radius_guess(y) - STEP_BITS;
    for (int attempt = 0; attempt < 60 && !proved; attempt++) {
        arb_set_d(y->step, exp2(exponent - floor(exponent)));
        arb_mul_2exp_si(y->step, y->step, (slong)floor(exponent));
        proved = prove_step(y, y->step) && mag_cmp(y->error_v, goal) <= 0 && mag_cmp(y->error_w, goal) <= 0;
        /* A little shorter, and after many refusals much shorter. */
        exponent -= attempt < 20 ? 0.25 : 1.0;
    }
    mag_clear(goal);
    mag_clear(scale);
    return proved;
}

static arb_srcptr component_block(const struct taylor *y, enum taylor_component component)
{
    return component == TAYLOR_W ? y->w : component == TAYLOR_V ? y->v : y->t;
}

static void add_remainder(arb_t value, const struct taylor *y, const mag_t error, slong l)
{
    mag_t m, w;
    mag_init(m);
    mag_init(w);
    mag_pow_ui_lower(w, y->weight, (ulong)l);
    mag_div(m, error, w);
    arb_add_error_mag(value, m);
    mag_clear(m);
    mag_clear(w);
}

void taylor_value(arb_t value, const struct taylor *y, enum taylor_component component, slong l, const arb_t s)
{
    if (component == TAYLOR_FORCE) {
        /* c1 w^(bd-m) v + c2 w^(ad-m) from the enclosed w and v: used for numbers only. */
        const slong m = FLINT_MIN(y->law.ad, y->law.bd);
        arb_t w, v, x;
        arb_init(w);
        arb_init(v);
        arb_init(x);
        taylor_value(w, y, TAYLOR_W, 0, s);
        taylor_value(v, y, TAYLOR_V, 0, s);
        arb_pow_ui(x, w, (ulong)(y->law.bd - m), y->prec);
        arb_mul(v, v, x, y->prec);
        arb_mul(v, v, y->c1, y->prec);
        arb_pow_ui(x, w, (ulong)(y->law.ad - m), y->prec);
        arb_mul(x, x, y->c2, y->prec);
        arb_add(value, v, x, y->prec);
        arb_clear(w);
        arb_clear(v);
        arb_clear(x);
        return;
    }
    _arb_poly_evaluate(value, component_block(y, component) + l * stride(y), stride(y), s, y->prec);
    add_remainder(value, y, component == TAYLOR_W ? y->error_w : component == TAYLOR_V ? y->error_v : y->error_t, l);
}

void taylor_advance(struct taylor *y, const arb_t s)
{
    const slong size = stride(y);
    arb_ptr next = _arb_vec_init(3);
    for (slong l = 0; l < y->jets; l++) {
        taylor_value(next, y, TAYLOR_W, l, s);
        taylor_value(next + 1, y, TAYLOR_V, l, s);
        taylor_value(next + 2, y, TAYLOR_T, l, s);
        arb_swap(y->w + l * size, next);
        arb_swap(y->v + l * size, next + 1);
        arb_swap(y->t + l * size, next + 2);
    }
    _arb_vec_clear(next, 3);
}

bool taylor_root(arb_t root, const struct taylor *y, enum taylor_component component, const arb_t end)
{
    /* A secant-bisection hybrid (Illinois) on midpoints finds it; signs on both sides prove it. */
    arb_t low, high, flow, fhigh, x, fx, width;
    bool proved = false;
    arb_init(low);
    arb_init(high);
    arb_init(flow);
    arb_init(fhigh);
    arb_init(x);
    arb_init(fx);
    arb_init(width);
    arb_get_mid_arb(high, end);
    taylor_value(flow, y, component, 0, low);
    taylor_value(fhigh, y, component, 0, high);
    arb_get_mid_arb(flow, flow);
    arb_get_mid_arb(fhigh, fhigh);
    int side = 0;
    for (slong i = 0; i < 200; i++) {
        arb_sub(width, fhigh, flow, y->prec);
        arb_sub(x, high, low, y->prec);
        arb_mul(x, x, flow, y->prec);
        arb_div(x, x, width, y->prec);
        arb_sub(x, low, x, y->prec);
        arb_get_mid_arb(x, x);
        taylor_value(fx, y, component, 0, x);
        if (arb_contains_zero(fx))
            break;
        arb_get_mid_arb(fx, fx);
        if (arb_is_positive(fx)) {
            arb_set(low, x);
            arb_set(flow, fx);
            if (side == 1)
                arb_mul_2exp_si(fhigh, fhigh, -1);
            side = 1;
        } else {
            arb_set(high, x);
            arb_set(fhigh, fx);
            if (side == -1)
                arb_mul_2exp_si(flow, flow, -1);
            side = -1;
        }
    }
    arb_get_mid_arb(width, end);
    arb_mul_2exp_si(width, width, -y->prec);
    for (slong i = 0; i < y->prec && !proved; i++) {
        arb_sub(low, x, width, y->prec);
        arb_get_mid_arb(low, low);
        arb_add(high, x, width, y->prec);
        arb_get_mid_arb(high, high);
        if (arb_is_negative(low))
            arb_zero(low);
        if (arb_gt(high, end))
            arb_get_mid_arb(high, end);
        taylor_value(flow, y, component, 0, low);
        taylor_value(fhigh, y, component, 0, high);
        proved = arb_is_positive(flow) && arb_is_negative(fhigh);
        arb_mul_2exp_si(width, width, 1);
    }
    if (proved)
        arb_union(root, low, high, y->prec);
    arb_clear(low);
    arb_clear(high);
    arb_clear(flow);
    arb_clear(fhigh);
    arb_clear(x);
    arb_clear(fx);
    arb_clear(width);
    return proved;
}
