/* SPDX-License-Identifier: MIT */
/* Computes times of Tsuji's damping, Hunt and Crossley's law and the disk's contact law, and writes their tables. The
 * times are integrals of docs/laws.md and docs/theory-disks.md, in interval (ball) arithmetic. Times of the laws of
 * damping are in units of (m/K)^(1/(a+1)) g^((1-a)/(a+1)). */
#include <math.h>

#include "approximation/pieces.h"
#include "enclosure/closed_form.h"
#include "support/console.h"
#include "support/formula.h"
#include "support/local.h"
#include "tables/files.h"

/* ---- quadrature ---- */

enum { GUARD_BITS = 40, GAUSS_POINTS = 56, GAUSS_BITS = 320 };

/* Integrates from 0 to 1 by Gauss's rule of GAUSS_POINTS points on each half, because singularities are near 1 or near
 * the middle. Nodes and weights on [0, 1] are computed once. */
static void integrate_gauss(arb_t y, acb_calc_func_t f, void *parameters, slong prec)
{
    static const double from[] = {0, 0.75}, length[] = {0.75, 0.25};
    static arb_ptr nodes, weights;
    LOCAL(acb, x, value);
    if (!nodes) {
        nodes = _arb_vec_init(GAUSS_POINTS);
        weights = _arb_vec_init(GAUSS_POINTS);
        for (slong i = 0; i < GAUSS_POINTS; i++) {
            arb_hypgeom_legendre_p_ui_root(nodes + i, weights + i, GAUSS_POINTS, (ulong)i, GAUSS_BITS);
            arb_add_ui(nodes + i, nodes + i, 1, GAUSS_BITS);
            arb_mul_2exp_si(nodes + i, nodes + i, -1);
            arb_mul_2exp_si(weights + i, weights + i, -1);
        }
    }
    arb_zero(y);
    for (slong j = 0; j < 2 * GAUSS_POINTS; j++) {
        const arb_srcptr node = nodes + j / 2, weight = weights + j / 2, part = acb_realref(value);
        const double lo = from[j % 2], width = length[j % 2];
        LET(acb_realref(x), prec + GUARD_BITS, "lo + width*node", lo, width, node);
        f(value, x, parameters, 0, prec + GUARD_BITS);
        LET(y, prec + GUARD_BITS, "y + width*weight*part", y, width, weight, part);
    }
}

/* Integrates a real function f from 0 to 1. If `proved`, encloses the integral, to `prec` bits at best, by an adaptive
 * rule that takes 5 to 10 ms. Otherwise uses Gauss's rule, which is 20 times faster but gives no error bound. It
 * suffices for samples, which are compared with enclosures. */
static void integrate_function(arb_t y, bool proved, acb_calc_func_t f, void *parameters, slong prec)
{
    if (!proved) {
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

/* Computes a time at zeta > 0 or beta > 0, or for the disk at q >= 1/4. Encloses closed forms even if not `proved`. */
typedef void law_time(arb_t t, bool proved, const arb_t x, slong prec);

/* ---- Tsuji's damping, (a, b) = (3/2, 1/4) ----
 *
 * G(end) = integral from 0 to end of exp(zeta s/5) (sin(om s)/om)^(-1/5) ds, om^2 = 1 - zeta^2 of any sign */

struct tsuji_integrand {
    arb_srcptr zeta, end;
    acb_srcptr om;
};

/* With s = end x^5, the integrand s^(-1/5) ... ds becomes 5 x^3 end^(4/5) exp(zeta s/5) sinc(om s)^(-1/5) dx. */
static int tsuji_integrand(acb_ptr y, const acb_t x, void *parameters, slong order, slong prec)
{
    const struct tsuji_integrand *const p = parameters;
    LOCAL(acb, s);
    LET_COMPLEX(s, false, prec, "x^5*p->end", x, p->end);
    LET_COMPLEX(y, order > 0, prec, "sinc(s*p->om)^(-1/5)*exp(s*p->zeta/5)*x^3", s, p->om, p->zeta, x);
    return 0;
}

/* Computes (5/4)^(-3/5) G(end). */
static void tsuji_integral(arb_t g, bool proved, const arb_t zeta, const arb_t end, slong prec)
{
    LOCAL(acb, om);
    LET_COMPLEX(om, false, prec + GUARD_BITS, "sqrt(1 - zeta^2)", zeta);
    struct tsuji_integrand p = {zeta, end, om};
    integrate_function(g, proved, tsuji_integrand, &p, prec);
    LET(g, prec + GUARD_BITS, "g*5*end^(4/5)*(5/4)^(-3/5)", g, end);
}

static void tsuji_time_of_max_overlap(arb_t t, bool proved, const arb_t zeta, slong prec)
{
    LOCAL(arb, end);
    closed_form_angle(end, zeta, prec + GUARD_BITS);
    tsuji_integral(t, proved, zeta, end, prec);
}

/* Computes V(y), y = zeta/(10 sqrt(1 - zeta^2)), zeta < 1, in closed form. The duration at zero overlap is exp(2 pi y)
 * (1 - zeta^2)^(-2/5) V(y). */
static void tsuji_overlap_factor(arb_t v, bool proved, const arb_t y, slong prec)
{
    (void)proved;
    LOCAL(acb, z);
    arb_srcptr ln_gamma = acb_realref(z);
    LET(acb_realref(z), prec, "9/10");
    arb_set(acb_imagref(z), y);
    acb_lgamma(z, z, prec);
    LET(v, prec, "(5/4)^(-3/5)*pi*2^(1/5)*gamma(4/5)*exp(-pi*y - 2*ln_gamma)", y, ln_gamma);
}

static void tsuji_duration_zero_overlap(arb_t t, bool proved, const arb_t zeta, slong prec)
{
    LOCAL(arb, y);
    LET(y, prec, "zeta/sqrt(1 - zeta^2)/10", zeta);
    tsuji_overlap_factor(t, proved, y, prec);
    LET(t, prec, "t*exp(2*pi*y)*(1 - zeta^2)^(-2/5)", t, y, zeta);
}

/* For zeta < 0.7 the singularity of the integrand at om s = pi is near the end of the integral. There the time from
 * zero force to zero overlap is integrated backwards: it is exp(pi zeta/(5 om)) (5/4)^(-3/5) G(2 asin(zeta)/om) for
 * -zeta. */
static void tsuji_duration_zero_force(arb_t t, bool proved, const arb_t zeta, slong prec)
{
    LOCAL(arb, end, minus, part);
    const slong more = prec + GUARD_BITS;
    if (!HOLDS(prec, "zeta < 7/10", zeta)) {
        closed_form_angle(end, zeta, more);
        arb_mul_2exp_si(end, end, 1);
        tsuji_integral(t, proved, zeta, end, prec);
        return;
    }
    LET(end, more, "2*asin(zeta)/sqrt(1 - zeta^2)", zeta);
    arb_neg(minus, zeta);
    tsuji_integral(part, proved, minus, end, prec);
    tsuji_duration_zero_overlap(t, proved, zeta, more);
    LET(t, more, "t - part*exp(pi*zeta/(5*sqrt(1 - zeta^2)))", t, part, zeta);
}

/* At first the limit holds, and the force is twice the elastic force, for a time (5/8)^(2/5) (2/5) B(m; 2/5, 1/2), m =
 * 8 zeta^2/(1 + 8 zeta^2). Then the law without limit holds from its phase phi = atan2(2 zeta om, 1 + 2 zeta^2) on, for
 * a time exp(-zeta phi/(5 om)) (t_F - (5/4)^(-3/5) G(phi/om)). Here t_F is the duration at zero force, and phi/om = k
 * 2F1(1/2, 1; 3/2; -(k om)^2), k = 2 zeta/(1 + 2 zeta^2). */
static void tsuji_duration_limited(arb_t t, bool proved, const arb_t zeta, slong prec)
{
    const slong more = prec + 2 * GUARD_BITS;
    LOCAL(arb, k, x, half, one, other, phase, part);
    LET(k, more, "2*zeta/(1 + 2*zeta^2)", zeta);
    LET(x, more, "(zeta^2 - 1)*k^2", zeta, k);
    LET(half, more, "1/2");
    LET(one, more, "1");
    LET(other, more, "3/2");
    arb_hypgeom_2f1(phase, half, one, other, x, 0, more);
    arb_mul(phase, phase, k, more);
    tsuji_integral(part, proved, zeta, phase, prec);
    tsuji_duration_zero_force(t, proved, zeta, prec);
    LET(x, more, "8*zeta^2/(1 + 8*zeta^2)", zeta);
    LET(other, more, "2/5");
    arb_hypgeom_beta_lower(x, other, half, x, 0, more);
    LET(t, more, "(5/8)^(2/5)*2/5*x + (t - part)*exp(-zeta*phase/5)", x, t, part, zeta, phase);
}

/* ---- Hunt and Crossley's law ----
 *
 * With tau = ln((1 + beta)/(1 + beta v)) during loading, tau = ln((1 + beta v)/(1 - h)) from the end backwards, and
 * k = a/(a + 1),
 *
 *     t = beta^(2k - 1) int ((a + 1) tau B(tau))^-k d tau,   B = sign (p E(-sign tau) - 1), E(x) = (exp(x) - 1)/x
 *
 * Loading: p = 1 + beta, sign +, up to ln(1 + beta). Rebound: p = 1 - h, sign -, up to -ln(1 - h). */

struct crossley_integrand {
    struct ratio k;
    slong sign;
    arb_srcptr p, end;
};

/* With k = l/m and tau = end x^m, the integrand tau^-k ... d tau becomes x^(m - 1 - l) ((a + 1) B)^-k dx times m
 * end^(1 - k); a + 1 = m/(m - l). E(2 z) = exp(z) sinc(i z). */
static int crossley_integrand(acb_ptr y, const acb_t x, void *parameters, slong order, slong prec)
{
    const struct crossley_integrand *const p = parameters;
    const slong l = p->k.num, m = p->k.den, sign = p->sign;
    LOCAL(acb, z, iz);
    LET_COMPLEX(z, false, prec, "-sign*x^m*p->end/2", sign, x, m, p->end);
    acb_mul_onei(iz, z);
    LET_COMPLEX(z, false, prec, "sign*m/(m - l)*(exp(z)*sinc(iz)*p->p - 1)", sign, m, l, z, iz, p->p);
    LET_COMPLEX(y, order > 0, prec, "z^(-l/m)*x^(m - 1 - l)", z, l, m, x);
    return 0;
}

/* Computes the integral times m end^(1 - k) beta^(2k - 1). */
static void crossley_part(arb_t t, bool proved, struct ratio k, slong sign, const arb_t p, const arb_t end,
                          const arb_t beta, slong prec)
{
    struct crossley_integrand integrand = {k, sign, p, end};
    const slong m = k.den;
    integrate_function(t, proved, crossley_integrand, &integrand, prec);
    LET(t, prec, "t*m*end^(1 - k)*beta^(2*k - 1)", t, m, end, k, beta);
}

static void time_of_max_overlap(arb_t t, bool proved, struct ratio k, const arb_t beta, slong prec)
{
    LOCAL(arb, p, end);
    LET(p, prec + 2 * GUARD_BITS, "1 + beta", beta);
    LET(end, prec + 2 * GUARD_BITS, "log1p(beta)", beta);
    crossley_part(t, proved, k, 1, p, end, beta, prec);
}

static void duration(arb_t t, bool proved, struct ratio k, const arb_t beta, slong prec)
{
    LOCAL(arb, p, end, loading);
    /* near beta = 0 the branch point of W costs half of the bits, and logarithms some more */
    LET(p, 3 * prec, "-(1 + beta)*exp(-1 - beta)", beta);
    arb_lambertw(p, p, 0, 3 * prec);
    arb_neg(p, p); /* 1 - h = -W_0(-(1 + beta) exp(-1 - beta)) */
    LET(end, 2 * prec, "-log(p)", p);
    crossley_part(t, proved, k, -1, p, end, beta, prec);
    time_of_max_overlap(loading, proved, k, beta, prec);
    arb_add(t, t, loading, prec);
}

#define CROSSLEY_TIME(of, end, l, m)                                                                                   \
    static void crossley_##of##_##end(arb_t t, bool proved, const arb_t beta, slong prec)                              \
    {                                                                                                                  \
        of(t, proved, (struct ratio){l, m}, beta, prec);                                                               \
    }

CROSSLEY_TIME(time_of_max_overlap, 1, 1, 2)
CROSSLEY_TIME(time_of_max_overlap, 3_2, 3, 5)
CROSSLEY_TIME(duration, 1, 1, 2)
CROSSLEY_TIME(duration, 3_2, 3, 5)

/* ---- the disk's contact law, runtime/disk/quasistatic.c ---- */

/* Computes 1 + t = -W_-1(-exp(-1 - q)). */
static void disk_one_plus_t(arb_t y, const arb_t q, slong prec)
{
    LET(y, prec, "-exp(-1 - q)", q);
    arb_lambertw(y, y, 1, prec);
    arb_neg(y, y);
}

/* Computes the load divided by the compression, which is pi/(1 + t) at q = ln(delta_limit/delta). */
static void disk_load_factor(arb_t factor, bool proved, const arb_t q, slong prec)
{
    (void)proved;
    disk_one_plus_t(factor, q, prec + GUARD_BITS);
    LET(factor, prec, "pi/factor", factor);
}

struct disk_integrand {
    arb_srcptr y, t, c, end; /* y = 1 + t */
};

/* Computes (exp(u) - 1 - u)/u^2. For |u| < 1 it uses the series 1/2 (1 + u/3 (1 + u/4 (1 + ...))), whose 50th and later
 * terms are below 2^-214. */
static void exp_less_two_terms(acb_t y, const acb_t u, slong prec)
{
    enum { TERMS = 50 };
    LOCAL(mag, size);
    LOCAL(acb, part);
    acb_get_mag(size, u);
    if (mag_cmp_2exp_si(size, 0) >= 0) {
        LET_COMPLEX(y, false, prec, "(exp(u) - 1 - u)/u^2", u);
        return;
    }
    acb_one(part);
    for (slong k = TERMS; k > 2; k--)
        LET_COMPLEX(part, false, prec, "part*u/k + 1", part, u, k);
    acb_mul_2exp_si(y, part, -1);
    mag_set_ui_2exp_si(size, 1, -214);
    acb_add_error_mag(y, size);
}

/* The integrand f(end x) of runtime/disk/quasistatic.c, u = c sinh^2(end x/2), with the zeros at u = 0 divided out:
 * (t + u) sqrt((u + c)/(t + (1 + t) (exp(u) - 1 - u)/u)) */
static int disk_integrand(acb_ptr f, const acb_t x, void *parameters, slong order, slong prec)
{
    const struct disk_integrand *const p = parameters;
    LOCAL(acb, u, low);
    LET_COMPLEX(u, false, prec, "sinh(x*p->end/2)^2*p->c", x, p->end, p->c);
    exp_less_two_terms(low, u, prec);
    LET_COMPLEX(f, order > 0, prec, "sqrt((u + p->c)/(low*u*p->y + p->t))*(u + p->t)", u, p->c, low, p->y, p->t);
    return 0;
}

/* Computes the contact time, q = 2 ln(v_limit/v). The integral ends at u = U = 192. Beyond, the integrand in u is below
 * sqrt(2) (t + u) exp(-u/2), and the rest of tau is below 2 (t + U + 2) exp(-U/2) < (t + U + 2) 2^-137. */
static void disk_contact_time(arb_t tau, bool proved, const arb_t q, slong prec)
{
    enum { U = 192, REST_BITS = 137 };
    const slong more = prec + GUARD_BITS;
    LOCAL(arb, y, t, c, x, end);
    disk_one_plus_t(y, q, more + GUARD_BITS);
    LET(t, more, "y - 1", y);
    LET(c, more, "t + t/y", t, y);
    LET(x, more, "sqrt(U/c)", U, c);
    LET(end, more, "2*log(x + sqrt(1 + x^2))", x);
    struct disk_integrand p = {y, t, c, end};
    integrate_function(tau, proved, disk_integrand, &p, prec);
    LET(tau, more, "tau*end/sqrt(2)", tau, end);
    LET(x, more, "(t + U + 2)/2^REST_BITS", t, U, REST_BITS);
    arb_add_error(tau, x);
}

/* ---- rows: only this file defines their geometry ---- */

enum { FAR_BITS = 400 };

/* Ends of the rows in s = ln(1 + zeta) or ln(1 + beta) */
#define TSUJI_END 12.25
#define CROSSLEY_MAX_END 26.25
#define CROSSLEY_DURATION_END 4.5
/* End of the rows in r = zeta^(1/5), at zeta = 3.9; the duration at zero force is analytic in r at zeta = 0 */
#define ROOT_END 1.3125
#define OVERLAP_END 10
/* Rows of the disk's contact law in q, by octaves; the law is singular at q = 0 */
#define DISK_FROM 0.25
#define DISK_END 128
#define LEAST_BITS 56

struct time_rows {
    const char *name, *title, *variable;
    law_time *time;
    const char *damping; /* zeta or beta as a function of y; NULL: y itself, with 1/step cells in each octave */
    double from, step, end;
    double least_bits;
};

static void time_at(arb_t t, const void *what, const arb_t y, bool proved, slong prec)
{
    const struct time_rows *const rows = what;
    LOCAL(arb, zeta);
    LET(zeta, prec + 64, rows->damping ? rows->damping : "y", y);
    rows->time(t, proved, zeta, prec);
}

static const struct time_rows tsuji_rows[] = {
    {"cor_rows_tsuji_time_of_max_overlap", "time of the largest overlap", "ln(1 + zeta)", tsuji_time_of_max_overlap,
     "expm1(y)", 0, 0.25, TSUJI_END, LEAST_BITS},
    {"cor_rows_tsuji_duration_zero_force_weak", "duration at zero force, weak damping", "zeta^(1/5)",
     tsuji_duration_zero_force, "y^5", 0, 0.0625, ROOT_END, LEAST_BITS},
    {"cor_rows_tsuji_duration_zero_force", "duration at zero force", "ln(1 + zeta)", tsuji_duration_zero_force,
     "expm1(y)", 1.5, 0.25, TSUJI_END, LEAST_BITS},
    {"cor_rows_tsuji_duration_limited_weak", "duration with the limited damper, weak damping", "zeta^(1/5)",
     tsuji_duration_limited, "y^5", 0, 0.03125, ROOT_END, LEAST_BITS},
    {"cor_rows_tsuji_duration_limited", "duration with the limited damper", "ln(1 + zeta)", tsuji_duration_limited,
     "expm1(y)", 1.5, 0.25, TSUJI_END, LEAST_BITS},
    {"cor_rows_tsuji_duration_zero_overlap", "duration at zero overlap", "zeta", tsuji_duration_zero_overlap, "y", 0,
     0.03125, 0.6875, LEAST_BITS},
    {"cor_rows_tsuji_overlap_factor", "V of the duration at zero overlap", "zeta/(10 sqrt(1 - zeta^2)) 2^-k",
     tsuji_overlap_factor, NULL, 0.0625, 0.125, OVERLAP_END, 53.5},
};

static const struct time_rows crossley_rows[] = {
    {"cor_rows_crossley_time_of_max_overlap_1", "time of the largest overlap, a = 1", "ln(1 + beta)",
     crossley_time_of_max_overlap_1, "expm1(y)", 0, 0.375, CROSSLEY_MAX_END, LEAST_BITS},
    {"cor_rows_crossley_time_of_max_overlap_3_2", "time of the largest overlap, a = 3/2", "ln(1 + beta)",
     crossley_time_of_max_overlap_3_2, "expm1(y)", 0, 0.375, CROSSLEY_MAX_END, LEAST_BITS},
    {"cor_rows_crossley_duration_1", "duration, a = 1", "ln(1 + beta)", crossley_duration_1, "expm1(y)", 0, 0.125,
     CROSSLEY_DURATION_END, LEAST_BITS},
    {"cor_rows_crossley_duration_3_2", "duration, a = 3/2", "ln(1 + beta)", crossley_duration_3_2, "expm1(y)", 0, 0.125,
     CROSSLEY_DURATION_END, LEAST_BITS},
};

static const struct time_rows disk_rows[] = {
    {"cor_rows_disk_contact_time", "contact time", "q 2^-k", disk_contact_time, NULL, DISK_FROM, 0.125, DISK_END,
     LEAST_BITS},
    {"cor_rows_disk_load_factor", "load over compression", "q 2^-k", disk_load_factor, NULL, DISK_FROM, 0.0625,
     DISK_END, LEAST_BITS},
};

/* ---- beyond the rows ---- */

/* A formula for strong damping with `known` constants (see constants()), followed by `terms` coefficients c_k, the
 * solution of `terms` equations. Its row in the file contains these numbers as doubles. Each of the first `split`
 * doubles is followed by its rounding error. */
struct far_form {
    const char *name;
    const char *comment; /* comment above this form and the following ones */
    /* sets equation i: sum_k c_k basis_k = value. value encloses the function */
    void (*equation)(arb_ptr basis, arb_t value, const struct far_form *f, slong i);
    slong known, terms, split;
    /* for tsuji_equation */
    law_time *time;
    struct ratio power; /* the expansion is of t zeta^power */
    slong mu_power;     /* mu = zeta^-mu_power */
    struct {
        int mu, log;
    } term[6];
    struct ratio k; /* for crossley_equation: a/(a + 1) */
    void (*constants)(arb_ptr c, const struct far_form *f);
    int (*check)(const struct far_form *f); /* checks the row; NULL: no check */
};

enum { FAR_MOST = 16 };

static int far_solve(arb_ptr c, const struct far_form *f)
{
    const slong n = f->terms;
    LOCAL_VECTOR(basis, n);
    LOCAL_MATRIX(n, n, a);
    LOCAL_MATRIX(n, 1, b);
    for (slong i = 0; i < n; i++) {
        f->equation(basis, arb_mat_entry(b, i, 0), f, i);
        for (slong k = 0; k < n; k++)
            arb_set(arb_mat_entry(a, i, k), basis + k);
    }
    const int solved = arb_mat_solve(b, a, b, FAR_BITS);
    for (slong k = 0; k < n; k++)
        arb_set(c + k, arb_mat_entry(b, k, 0));
    return solved ? STATUS_OK : fail("cannot solve for the coefficients of %s", f->name);
}

/* Computes the row, as exact doubles. Returns the number of its columns, or 0 after reporting the failure. */
static slong far_row(arb_ptr row, const struct far_form *f)
{
    const slong known = f->known, all = known + f->terms;
    LOCAL_VECTOR(c, all);
    slong columns = 0;
    if (known > 0)
        f->constants(c, f);
    const int status = f->terms > 0 ? far_solve(c + known, f) : STATUS_OK;
    for (slong k = 0; k < all && status == STATUS_OK; k++)
        for (int part = 0; part < (k < f->split ? 2 : 1); part++, columns++) {
            arb_set_d(row + columns, ball_middle(c + k));
            arb_sub(c + k, c + k, row + columns, FAR_BITS);
        }
    return columns;
}

/* Sets an equation of the expansion of t zeta^power in mu^j u^k, at u = ln(zeta) = 13, 13.75, ... */
static void tsuji_equation(arb_ptr basis, arb_t value, const struct far_form *f, slong i)
{
    LOCAL(arb, u, zeta);
    LET(u, FAR_BITS, "13 + 3/4*i", i);
    arb_exp(zeta, u, FAR_BITS);
    f->time(value, true, zeta, 256);
    LET(value, FAR_BITS, "value*exp(f->power*u)", value, f->power, u);
    for (slong k = 0; k < f->terms; k++)
        LET(basis + k, FAR_BITS, "u^f->term[k].log*exp(-f->mu_power*f->term[k].mu*u)", u, f->mu_power, f->term[k].log,
            f->term[k].mu);
}

/* Computes y^(4/5) V(y). */
static void scaled_overlap_factor(arb_t v, const arb_t y)
{
    tsuji_overlap_factor(v, true, y, FAR_BITS);
    LET(v, FAR_BITS, "v*y^(4/5)", v, y);
}

/* Sets an equation of y^(4/5) V(y) = v_0 (1 + v_1/y^2 + ...), Stirling's series of |Gamma(9/10 + i y)|^2. At y = 10 its
 * eighth and later terms are below 2^-57. */
static void overlap_equation(arb_ptr basis, arb_t value, const struct far_form *f, slong i)
{
    LOCAL(arb, y);
    arb_set_ui(y, OVERLAP_END + 6 * (ulong)i);
    scaled_overlap_factor(value, y);
    arb_inv(y, y, FAR_BITS);
    for (slong k = 0; k < f->terms; k++)
        arb_pow_ui(basis + k, y, 2 * (ulong)k, FAR_BITS);
}

/* Checks that the row gives y^(4/5) V(y) with relative errors below 2^-57, at samples of y from OVERLAP_END to 115. */
static int overlap_far_check(const struct far_form *f)
{
    LOCAL_VECTOR(row, FAR_MOST);
    LOCAL(arb, y, v, sum);
    double worst = far_row(row, f) ? 0 : HUGE_VAL;
    for (double at = OVERLAP_END; at < 115; at *= 1.03125) {
        arb_set_d(y, at);
        scaled_overlap_factor(v, y);
        LET(y, FAR_BITS, "1/y^2", y);
        _arb_poly_evaluate(sum, row + 1, f->terms, y, FAR_BITS);
        LET(sum, FAR_BITS, "(row + sum)/v - 1", row, sum, v);
        worst = fmax(worst, fabs(ball_middle(sum)));
    }
    return worst < 0x1p-57 ? STATUS_OK
                           : fail("Tsuji's duration at zero overlap has an error of %.3g at large zeta", worst);
}

#define TSUJI_FAR(title, of, p, q, mu, ...)                                                                            \
    {                                                                                                                  \
        .name = "cor_rows_tsuji_far_" title, .equation = tsuji_equation, .split = 2, .time = of, .power = {p, q},      \
        .mu_power = mu, __VA_ARGS__                                                                                    \
    }
#define QUADRATIC .terms = 5, .term = {{0, 0}, {0, 1}, {1, 0}, {1, 1}, {1, 2}}
static const struct far_form tsuji_far[] = {
    TSUJI_FAR(
        "time_of_max_overlap", tsuji_time_of_max_overlap, 4, 5, 2, QUADRATIC,
        .comment =
            "ln(1 + zeta) >= 12.25, with u = ln(zeta), mu = 1/zeta^2: t zeta^(4/5) = a_0 + a_0' + (a_1 + a_1') u\n"
            "+ mu (a_2 + a_3 u + a_4 u^2). With the limited damper mu = 1/zeta, and t = a_0 + a_0' + (a_1 + a_1') "
            "mu\n+ a_2 mu u + mu^3 (a_3 + a_4 u + a_5 u^2). The formulas fit enclosed values at u = 13, 13.75, ..."),
    TSUJI_FAR("duration_zero_force", tsuji_duration_zero_force, 4, 5, 2, QUADRATIC),
    TSUJI_FAR("duration_limited", tsuji_duration_limited, 0, 1, 1, .terms = 6,
              .term = {{0, 0}, {1, 0}, {1, 1}, {3, 0}, {3, 1}, {3, 2}}),
    {.name = "cor_rows_tsuji_far_overlap_factor",
     .comment = "y >= 10: V = y^(-4/5) (v_0 + v_0' + v_1/y^2 + ... + v_7/y^14), through values at y = 10 ... 52; "
                "relative error below 2^-57, sampled.",
     .equation = overlap_equation,
     .terms = 8,
     .split = 1,
     .check = overlap_far_check},
    {.name = NULL},
};

/* ---- Hunt and Crossley beyond the rows ---- */

/* Sets an equation of the time of the largest overlap, s = ln(1 + beta) >= 26.25. In units of
 * beta^(2k - 1) ((a + 1)(1 + beta))^-k this time is s + K + (k_0 + k_1 s + k_2 s^2)/(1 + beta), K = -psi(1 - k) -
 * gamma. The equation, multiplied by 1 + beta, gives k_j. */
static void crossley_equation(arb_ptr basis, arb_t t, const struct far_form *f, slong i)
{
    LOCAL(arb, s, beta, K);
    f->constants(K, f);
    LET(s, FAR_BITS, "27 + 3*i", i);
    arb_expm1(beta, s, FAR_BITS);
    f->time(t, true, beta, 300);
    LET(t, FAR_BITS, "(t*beta^(1 - 2*f->k)*(exp(s)/(1 - f->k))^f->k - s - K)*exp(s)", t, beta, f->k, s, K);
    for (slong j = 0; j < f->terms; j++)
        arb_pow_ui(basis + j, s, (ulong)j, FAR_BITS);
}

/* Computes K. */
static void loading_constant(arb_ptr K, const struct far_form *f)
{
    LET(K, FAR_BITS, "digamma(1) - digamma(1 - f->k)", f->k);
}

/* Computes the c_p of the time of the rebound, ln(1 + beta) >= 4.5. With U = beta + 1 - ln(1 + beta), in units of
 * beta^(2k - 1) (a + 1)^-k, this time is
 *
 *     (a + 1) U^(1 - k) + U^-k sum_p c_p U^-p,   c_p = sum_(j=1..p) binom(k+j-1, j) binom(k+p-1, p-j) (p-j)!/j^(p-j+1)
 *
 * for k = a/(a + 1), from (U - x - exp(-x))^-k by the binomial series in exp(-x), then in x/U. */
static void rebound_coefficients(arb_ptr c, const struct far_form *f)
{
    LOCAL(arb, n, first, second);
    for (slong p = 1; p <= f->known; p++) {
        arb_struct *const sum = c + p - 1;
        arb_zero(sum);
        for (slong j = 1; j <= p; j++) {
            LET(n, FAR_BITS, "f->k + j - 1", f->k, j);
            arb_bin_ui(first, n, (ulong)j, FAR_BITS);
            LET(n, FAR_BITS, "f->k + p - 1", f->k, p);
            arb_bin_ui(second, n, (ulong)(p - j), FAR_BITS);
            arb_fac_ui(n, (ulong)(p - j), FAR_BITS);
            LET(sum, FAR_BITS, "sum + first*second*n/j^(p - j + 1)", sum, first, second, n, j, p);
        }
    }
}

#define LOADING_FAR(end, ...)                                                                                          \
    {                                                                                                                  \
        .name = "cor_rows_crossley_far_time_of_max_overlap_" #end, .equation = crossley_equation, .known = 1,          \
        .constants = loading_constant, .terms = 3, .split = 1, .time = crossley_time_of_max_overlap_##end,             \
        .k = __VA_ARGS__                                                                                               \
    }
#define REBOUND_FAR(end, ...)                                                                                          \
    {                                                                                                                  \
        .name = "cor_rows_crossley_far_rebound_" #end, .known = 11, .constants = rebound_coefficients,                 \
        .k = __VA_ARGS__                                                                                               \
    }
static const struct far_form crossley_far[] = {
    LOADING_FAR(
        1, {1, 2},
        .comment = "s = ln(1 + beta) >= 26.25: the time of the largest overlap is beta^(2k-1) ((a+1) (1+beta))^-k\n"
                   "(s + K + K' + (k_0 + k_1 s + k_2 s^2)/(1 + beta)), k = a/(a+1): columns K, K', k_0, k_1, k_2. K is "
                   "exact. The k_j\nfit three enclosed values."),
    LOADING_FAR(3_2, {3, 5}),
    REBOUND_FAR(
        1, {1, 2},
        .comment =
            "s >= 4.5: the rebound takes beta^(2k-1) (a+1)^-k ((a+1) U^(1-k) + U^-k (c_1/U + ... + c_11/U^11)),\n"
            "U = 1 + beta - ln(1 + beta). Exact coefficients."),
    REBOUND_FAR(3_2, {3, 5}),
    {.name = NULL},
};

/* ---- the files ---- */

#define COUNT(rows) ((int)(sizeof(rows) / sizeof *(rows)))

static int rows_write(struct emit *e, const struct time_rows *rows, slong head_bits)
{
    const bool octaves = !rows->damping;
    const double cells = octaves ? log2(rows->end / rows->from) : rows->end - rows->from;
    struct pieces p = {.variable = octaves ? VARIABLE_BETA_OCTAVES : VARIABLE_OTHER,
                       .words = rows->variable,
                       .first = octaves ? log2(rows->from) : rows->from + rows->step / 2,
                       .step = rows->step,
                       .end = rows->end,
                       .octave_bits = octaves ? (slong)-log2(rows->step) : 0,
                       .rows = (slong)(cells / rows->step + (octaves ? 0 : 0.5)),
                       .degree = 10,
                       .name = rows->name,
                       .title = rows->title,
                       .head_bits = head_bits,
                       .least_bits = rows->least_bits};
    p.plain = p.rows;
    return sampled_function_write(e, &p, time_at, rows);
}

/* Writes n tables, and the forms for strong damping. far: the forms, ended by a form without a name. head_bits: bits
 * of c_0 in each row; 0: all bits */
static int file_write(FILE *file, const char *name, const char *what, const char *how, const struct time_rows *rows,
                      int n, slong head_bits, const struct far_form *far)
{
    struct emit e;
    LOCAL_VECTOR(row, FAR_MOST);
    int status = STATUS_OK;
    emit_open_tables(&e, file, name, what, how, EMIT_INCLUDE_ROWS);
    for (int i = 0; i < n && status == STATUS_OK; i++) {
        progress("tables of laws", i, n);
        status = rows_write(&e, &rows[i], head_bits);
    }
    progress_end();
    for (const struct far_form *f = far; f && f->name && status == STATUS_OK; f++) {
        if (f->comment)
            emit_comment(&e, "%s", f->comment);
        const slong columns = far_row(row, f);
        status = columns == 0 || (f->check && f->check(f)) ? STATUS_FAILED : emit_one_row(&e, f->name, row, columns);
    }
    emit_close(&e);
    return status;
}

/* The last lines of two banners: how the times and their errors are computed */
static const char how_times[] =
    "The rows interpolate polynomials of high degree through samples. Two Gauss rules of 56 points compute the "
    "samples.\n"
    "The polynomials agree with enclosures by adaptive quadrature to 1e-20 at two places of each block of rows. "
    "Errors\n"
    "of the rows are above each table (sampled); errors of evaluation: include/cor/law.h (sampled).\n";

int tsuji_tables_write(FILE *file)
{
    static const char what[] =
        "Times of Tsuji's damping, x'' + sqrt(5) zeta x^(1/4) x' + x^(3/2) = 0, for every damping ratio zeta, in the\n"
        "sphere's unit: rows of short polynomials around the nodes of uniform grids, and formulas for large\n"
        "zeta. Evaluated by runtime/law/linear_tsuji.c. Source: docs/laws.md; form: docs/internals.md.\n";
    return file_write(file, "tsuji", what, how_times, tsuji_rows, COUNT(tsuji_rows), 0, tsuji_far);
}

int hunt_crossley_tables_write(FILE *file)
{
    static const char what[] =
        "Times of Hunt and Crossley's law F = K x^a (1 + d x') with a = 1 and 3/2, for every beta = d g >= 0, in units "
        "of\n(m/K)^(1/(a+1)) g^((1-a)/(a+1)): rows of short polynomials around the nodes of uniform grids in "
        "ln(1 + beta), and\nformulas for large beta. Evaluated by runtime/law/hunt_crossley_functions.c. Source: "
        "docs/laws.md; form:\ndocs/internals.md.\n";
    return file_write(file, "hunt_crossley", what, how_times, crossley_rows, COUNT(crossley_rows), 0, crossley_far);
}

int disk_law_tables_write(FILE *file)
{
    static const char what[] =
        "Contact time and load of the disk's quasistatic law by q, which is ln(limit/compression) or 2 "
        "ln(limit/speed):\nrows of short polynomials by octaves of q. Evaluated by\nruntime/disk/quasistatic_rows.c. "
        "Source: docs/theory-disks.md, 12; form: docs/internals.md.\n";
    static const char how[] =
        "The rows interpolate polynomials of high degree through samples. Two Gauss rules of 56 points compute the\n"
        "samples of the time, and Lambert's W the samples of the load. The polynomials agree with enclosures to 1e-20\n"
        "at two places of each block of rows. Errors of the rows are above each table (sampled); errors of "
        "evaluation:\n"
        "include/cor/disk.h.\n";
    return file_write(file, "disk_law", what, how, disk_rows, COUNT(disk_rows), 26, NULL);
}
