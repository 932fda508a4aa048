/* SPDX-License-Identifier: MIT */
#include "tables/law_times.h"

#include "enclosure/closed_form.h"
#include "support/formula.h"

enum { GUARD_BITS = 40 };

/* Nodes and weights of the Gauss-Legendre rule on [0, 1] with GAUSS_BITS bits, computed once */
enum { GAUSS_POINTS = 56, GAUSS_BITS = 320 };
static arb_ptr gauss_node, gauss_weight;

static void gauss_make(void)
{
    if (gauss_node)
        return;
    gauss_node = _arb_vec_init(GAUSS_POINTS);
    gauss_weight = _arb_vec_init(GAUSS_POINTS);
    for (slong j = 0; j < GAUSS_POINTS; j++) {
        arb_hypgeom_legendre_p_ui_root(gauss_node + j, gauss_weight + j, GAUSS_POINTS, (ulong)j, GAUSS_BITS);
        arb_add_ui(gauss_node + j, gauss_node + j, 1, GAUSS_BITS);
        arb_mul_2exp_si(gauss_node + j, gauss_node + j, -1);
        arb_mul_2exp_si(gauss_weight + j, gauss_weight + j, -1);
    }
}

void law_times_clear(void)
{
    if (!gauss_node)
        return;
    _arb_vec_clear(gauss_node, GAUSS_POINTS);
    _arb_vec_clear(gauss_weight, GAUSS_POINTS);
    gauss_node = gauss_weight = NULL;
}

/* Integrates from 0 to 1 in two parts, because singularities lie near 1 or around the middle. */
static void integrate_gauss(arb_t y, acb_calc_func_t f, void *parameters, slong prec)
{
    static const double from[] = {0, 0.75}, length[] = {0.75, 0.25};
    LOCAL(acb, x, value);
    LOCAL(arb, part);
    gauss_make();
    arb_zero(y);
    for (slong j = 0; j < 2 * GAUSS_POINTS; j++) {
        const slong i = j / 2, half = j % 2;
        arb_set_d(part, length[half]);
        arb_mul(acb_realref(x), gauss_node + i, part, prec + GUARD_BITS);
        arb_mul(part, gauss_weight + i, part, prec + GUARD_BITS);
        arb_set_d(acb_realref(value), from[half]);
        arb_add(acb_realref(x), acb_realref(x), acb_realref(value), prec + GUARD_BITS);
        arb_zero(acb_imagref(x));
        f(value, x, parameters, 0, prec + GUARD_BITS);
        arb_addmul(y, part, acb_realref(value), prec + GUARD_BITS);
    }
}

/* The integral of a real function f from 0 to 1, with a relative accuracy of at best `prec` bits */
static void quadrature_integrate(arb_t y, enum quadrature how, acb_calc_func_t f, void *parameters, slong prec)
{
    if (how == QUADRATURE_GAUSS) {
        integrate_gauss(y, f, parameters, prec);
        return;
    }
    LOCAL(acb, from, to, sum);
    LOCAL(mag, tolerance);
    acb_one(to);
    mag_set_ui_2exp_si(tolerance, 1, -prec);
    acb_calc_integrate(sum, f, parameters, from, to, prec - 16, tolerance, NULL, prec + GUARD_BITS);
    arb_set(y, acb_realref(sum));
}

/* ---- Tsuji: G(end) = integral from 0 to end of exp(zeta s/5) (sin(om s)/om)^(-1/5) ds, om^2 = 1 - zeta^2 of any sign
 * ---- */

struct tsuji_integrand {
    arb_srcptr zeta, end;
    acb_t om, power; /* -1/5 */
};

/* With s = end x^5, the integrand s^(-1/5) ... ds becomes 5 x^3 end^(4/5) exp(zeta s/5) sinc(om s)^(-1/5) dx. */
static int tsuji_integrand(acb_ptr y, const acb_t x, void *parameters, slong order, slong prec)
{
    const struct tsuji_integrand *const p = parameters;
    LOCAL(acb, s, cube, sinc);
    acb_pow_ui(cube, x, 3, prec);
    acb_mul(s, x, x, prec);
    acb_mul(s, s, cube, prec);
    acb_mul_arb(s, s, p->end, prec);
    acb_mul(sinc, s, p->om, prec);
    acb_sinc(sinc, sinc, prec);
    acb_pow_analytic(y, sinc, p->power, order > 0, prec);
    acb_mul_arb(s, s, p->zeta, prec);
    acb_div_ui(s, s, 5, prec);
    acb_exp(s, s, prec);
    acb_mul(y, y, s, prec);
    acb_mul(y, y, cube, prec);
    return 0;
}

/* (5/4)^(-3/5) G(end); the first factor is w0^(-6/5). */
static void tsuji_integral(arb_t g, enum quadrature how, const arb_t zeta, const arb_t end, slong prec)
{
    struct tsuji_integrand p = {.zeta = zeta, .end = end};
    FOR_ALL(acb, init, p.om, p.power);
    LET(acb_realref(p.power), prec + GUARD_BITS, "-1/5");
    LET(acb_realref(p.om), prec + GUARD_BITS, "1 - zeta^2", zeta);
    acb_sqrt(p.om, p.om, prec + GUARD_BITS);
    quadrature_integrate(g, how, tsuji_integrand, &p, prec);
    LET(g, prec + GUARD_BITS, "g*5*end^(4/5)*(5/4)^(-3/5)", g, end);
    FOR_ALL(acb, clear, p.om, p.power);
}

void tsuji_time_of_max_overlap(arb_t t, enum quadrature how, const arb_t zeta, slong prec)
{
    LOCAL(arb, end);
    closed_form_angle(end, zeta, prec + GUARD_BITS);
    tsuji_integral(t, how, zeta, end, prec);
}

void tsuji_overlap_factor(arb_t v, enum quadrature how, const arb_t y, slong prec)
{
    (void)how;
    LOCAL(acb, z);
    arb_srcptr ln_gamma = acb_realref(z);
    LET(acb_realref(z), prec, "9/10");
    arb_set(acb_imagref(z), y);
    acb_lgamma(z, z, prec);
    LET(v, prec, "(5/4)^(-3/5)*pi*2^(1/5)*gamma(4/5)*exp(-pi*y - 2*ln_gamma)", y, ln_gamma);
}

void tsuji_duration_zero_overlap(arb_t t, enum quadrature how, const arb_t zeta, slong prec)
{
    LOCAL(arb, y);
    LET(y, prec, "zeta/sqrt(1 - zeta^2)/10", zeta);
    tsuji_overlap_factor(t, how, y, prec);
    LET(t, prec, "t*exp(2*pi*y)*(1 - zeta^2)^(-2/5)", t, y, zeta);
}

/* For zeta < 0.7 the integrand has a singularity at om s = pi, which is near. The integral therefore starts from the
 * other end: t_0 - exp(pi zeta/(5 om)) times the integral with -zeta up to 2 asin(zeta)/om. */
static void tsuji_duration_zero_force_weak(arb_t t, enum quadrature how, const arb_t zeta, slong prec)
{
    LOCAL(arb, end, minus, part);
    const slong more = prec + GUARD_BITS;
    LET(end, more, "2*asin(zeta)/sqrt(1 - zeta^2)", zeta);
    arb_neg(minus, zeta);
    tsuji_integral(part, how, minus, end, prec);
    tsuji_duration_zero_overlap(t, how, zeta, more);
    LET(t, more, "t - part*exp(pi*zeta/(5*sqrt(1 - zeta^2)))", t, part, zeta);
}

void tsuji_duration_zero_force(arb_t t, enum quadrature how, const arb_t zeta, slong prec)
{
    LOCAL(arb, end);
    if (HOLDS(prec, "zeta < 7/10", zeta)) {
        tsuji_duration_zero_force_weak(t, how, zeta, prec);
    } else {
        closed_form_angle(end, zeta, prec + GUARD_BITS);
        arb_mul_2exp_si(end, end, 1);
        tsuji_integral(t, how, zeta, end, prec);
    }
}

/* phi/om, phi = atan2(2 zeta om, 1 + 2 zeta^2): k 2F1(1/2, 1; 3/2; -(k om)^2), k = 2 zeta/(1 + 2 zeta^2) */
static void limited_phase(arb_t phase, const arb_t zeta, slong prec)
{
    LOCAL(arb, k, square, half, one, half_3);
    LET(k, prec, "2*zeta/(1 + 2*zeta^2)", zeta);
    LET(square, prec, "(zeta^2 - 1)*k^2", zeta, k);
    LET(half, prec, "1/2");
    LET(one, prec, "1");
    LET(half_3, prec, "3/2");
    arb_hypgeom_2f1(phase, half, one, half_3, square, 0, prec);
    arb_mul(phase, phase, k, prec);
}

/* The time during which the force is twice the elastic force: (5/8)^(2/5) (2/5) B(m; 2/5, 1/2), m = 8 zeta^2/(1 + 8
 * zeta^2) */
static void limited_first_part(arb_t t, const arb_t zeta, slong prec)
{
    LOCAL(arb, m, a, b);
    LET(m, prec, "8*zeta^2/(1 + 8*zeta^2)", zeta);
    LET(a, prec, "2/5");
    LET(b, prec, "1/2");
    arb_hypgeom_beta_lower(t, a, b, m, 0, prec);
    LET(t, prec, "(5/8)^(2/5)*2/5*t", t);
}

/* From phase phi on the law without limit holds: exp(-zeta phi/(5 om)) (t_F - (5/4)^(-3/5) G(phi/om)). */
void tsuji_duration_limited(arb_t t, enum quadrature how, const arb_t zeta, slong prec)
{
    const slong more = prec + 2 * GUARD_BITS;
    LOCAL(arb, phase, part, first);
    limited_phase(phase, zeta, more);
    tsuji_integral(part, how, zeta, phase, prec);
    tsuji_duration_zero_force(t, how, zeta, prec);
    limited_first_part(first, zeta, more);
    LET(t, more, "first + (t - part)*exp(-zeta*phase/5)", t, first, part, zeta, phase);
}

/* ---- Hunt and Crossley ----
 *
 * With tau = ln((1 + beta)/(1 + beta v)) during loading, tau = ln((1 + beta v)/(1 - h)) from the end backwards, and k =
 * a/(a + 1),
 *
 *     t = beta^(2k - 1) int ((a + 1) tau B(tau))^-k d tau,   B = sign (p E(-sign tau) - 1), E(x) = (exp(x) - 1)/x
 *
 * loading: p = 1 + beta, sign +, up to ln(1 + beta); rebound: p = 1 - h, sign -, up to -ln(1 - h). */

struct crossley_integrand {
    struct ratio k;
    int sign;
    arb_srcptr p, end;
    acb_t power; /* -k */
};

/* (exp(x) - 1)/x = exp(x/2) sinc(i x/2) */
static void mean_exponential(acb_t y, const acb_t x, slong prec)
{
    LOCAL(acb, half);
    acb_mul_2exp_si(half, x, -1);
    acb_mul_onei(y, half);
    acb_sinc(y, y, prec);
    acb_exp(half, half, prec);
    acb_mul(y, y, half, prec);
}

/* With k = l/m and tau = end x^m, the integrand tau^-k ... d tau becomes x^(m - 1 - l) ((a + 1) B)^-k dx, times m
 * end^(1 - k); a + 1 = m/(m - l). */
static int crossley_integrand(acb_ptr y, const acb_t x, void *parameters, slong order, slong prec)
{
    const struct crossley_integrand *const p = parameters;
    const ulong l = (ulong)p->k.num, m = (ulong)p->k.den;
    LOCAL(acb, tau, b);
    acb_pow_ui(tau, x, m, prec);
    acb_mul_arb(tau, tau, p->end, prec);
    if (p->sign > 0)
        acb_neg(tau, tau);
    mean_exponential(b, tau, prec);
    acb_mul_arb(b, b, p->p, prec);
    acb_sub_ui(b, b, 1, prec);
    if (p->sign < 0)
        acb_neg(b, b);
    acb_mul_ui(b, b, m, prec);
    acb_div_ui(b, b, m - l, prec);
    acb_pow_analytic(y, b, p->power, order > 0, prec);
    acb_pow_ui(tau, x, m - 1 - l, prec);
    acb_mul(y, y, tau, prec);
    return 0;
}

/* the integral times m end^(1 - k) beta^(2k - 1) */
static void crossley_part(arb_t t, enum quadrature how, struct ratio k, int sign, const arb_t p, const arb_t end,
                          const arb_t beta, slong prec)
{
    struct crossley_integrand integrand = {.k = k, .sign = sign, .p = p, .end = end};
    const slong m = k.den;
    acb_init(integrand.power);
    LET(acb_realref(integrand.power), prec + GUARD_BITS, "-k", k);
    quadrature_integrate(t, how, crossley_integrand, &integrand, prec);
    acb_clear(integrand.power);
    LET(t, prec, "t*m*end^(1 - k)*beta^(2*k - 1)", t, m, end, k, beta);
}

static void time_of_max_overlap(arb_t t, enum quadrature how, struct ratio k, const arb_t beta, slong prec)
{
    LOCAL(arb, p, end);
    arb_add_ui(p, beta, 1, prec + 2 * GUARD_BITS);
    arb_log1p(end, beta, prec + 2 * GUARD_BITS);
    crossley_part(t, how, k, 1, p, end, beta, prec);
}

static void duration(arb_t t, enum quadrature how, struct ratio k, const arb_t beta, slong prec)
{
    LOCAL(arb, p, end, loading);
    /* near beta = 0 the branch point of W costs half of the bits, and logarithms some more */
    LET(p, 3 * prec, "-(1 + beta)*exp(-1 - beta)", beta);
    arb_lambertw(p, p, 0, 3 * prec);
    arb_neg(p, p); /* 1 - h = -W_0(-(1 + beta) exp(-1 - beta)) */
    LET(end, 2 * prec, "-log(p)", p);
    crossley_part(t, how, k, -1, p, end, beta, prec);
    time_of_max_overlap(loading, how, k, beta, prec);
    arb_add(t, t, loading, prec);
}

#define CROSSLEY_TIME(of, end, l, m)                                                                                   \
    void crossley_##of##_##end(arb_t t, enum quadrature how, const arb_t beta, slong prec)                             \
    {                                                                                                                  \
        of(t, how, (struct ratio){l, m}, beta, prec);                                                                  \
    }

CROSSLEY_TIME(time_of_max_overlap, 1, 1, 2)
CROSSLEY_TIME(time_of_max_overlap, 3_2, 3, 5)
CROSSLEY_TIME(duration, 1, 1, 2)
CROSSLEY_TIME(duration, 3_2, 3, 5)

/* ---- the disk ---- */

/* 1 + t = -W_-1(-exp(-1 - q)) */
static void disk_one_plus_t(arb_t y, const arb_t q, slong prec)
{
    LET(y, prec, "-exp(-1 - q)", q);
    arb_lambertw(y, y, 1, prec);
    arb_neg(y, y);
}

void disk_load_factor(arb_t factor, enum quadrature how, const arb_t q, slong prec)
{
    (void)how;
    disk_one_plus_t(factor, q, prec + GUARD_BITS);
    LET(factor, prec, "pi/factor", factor);
}

struct disk_integrand {
    arb_srcptr y, t, c, end; /* y = 1 + t */
};

/* (exp(u) - 1 - u)/u^2; for |u| < 1 the series, whose terms from the 50th on are below 2^-214 */
static void exp_less_two_terms(acb_t y, const acb_t u, slong prec)
{
    enum { TERMS = 50 };
    LOCAL(mag, size);
    LOCAL(acb, part);
    acb_get_mag(size, u);
    if (mag_cmp_2exp_si(size, 0) >= 0) {
        acb_exp(part, u, prec);
        acb_sub_ui(part, part, 1, prec);
        acb_sub(part, part, u, prec);
        acb_div(part, part, u, prec);
        acb_div(y, part, u, prec);
        return;
    }
    /* 1/2 (1 + u/3 (1 + u/4 (1 + ...))) */
    acb_one(part);
    for (ulong k = TERMS; k > 2; k--) {
        acb_mul(part, part, u, prec);
        acb_div_ui(part, part, k, prec);
        acb_add_ui(part, part, 1, prec);
    }
    acb_mul_2exp_si(y, part, -1);
    mag_set_ui_2exp_si(size, 1, -214);
    acb_add_error_mag(y, size);
}

/* The integrand f(end x) of runtime/disk/quasistatic.c, u = c sinh^2(end x/2), with the zeros at u = 0 divided out:
 * (t + u) sqrt((u + c)/(t + (1 + t) (exp(u) - 1 - u)/u)) */
static int disk_integrand(acb_ptr f, const acb_t x, void *parameters, slong order, slong prec)
{
    const struct disk_integrand *const p = parameters;
    LOCAL(acb, u, low, root);
    acb_mul_arb(u, x, p->end, prec);
    acb_mul_2exp_si(u, u, -1);
    acb_sinh(u, u, prec);
    acb_mul(u, u, u, prec);
    acb_mul_arb(u, u, p->c, prec);
    exp_less_two_terms(low, u, prec);
    acb_mul(low, low, u, prec);
    acb_mul_arb(low, low, p->y, prec);
    acb_add_arb(low, low, p->t, prec);
    acb_add_arb(root, u, p->c, prec);
    acb_div(root, root, low, prec);
    acb_sqrt_analytic(root, root, order > 0, prec);
    acb_add_arb(u, u, p->t, prec);
    acb_mul(f, u, root, prec);
    return 0;
}

/* The integral ends at u = U = 192. From there on the integrand in u is below sqrt(2) (t + u) exp(-u/2), and the rest
 * of tau is below 2 (t + U + 2) exp(-U/2) < (t + U + 2) 2^-137. */
void disk_contact_time(arb_t tau, enum quadrature how, const arb_t q, slong prec)
{
    enum { U = 192, REST_BITS = 137 };
    const slong more = prec + GUARD_BITS;
    LOCAL(arb, y, t, c, x, end);
    LOCAL(mag, rest);
    disk_one_plus_t(y, q, more + GUARD_BITS);
    LET(t, more, "y - 1", y);
    LET(c, more, "t + t/y", t, y);
    LET(x, more, "sqrt(U/c)", U, c);
    LET(end, more, "2*log(x + sqrt(1 + x^2))", x);
    struct disk_integrand p = {y, t, c, end};
    quadrature_integrate(tau, how, disk_integrand, &p, prec);
    LET(tau, more, "tau*end/sqrt(2)", tau, end);
    LET(x, more, "t + U + 2", t, U);
    arb_get_mag(rest, x);
    mag_mul_2exp_si(rest, rest, -REST_BITS);
    arb_add_error_mag(tau, rest);
}
