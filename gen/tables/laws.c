/* SPDX-License-Identifier: MIT */
#include "tables/laws.h"

#include <math.h>

#include "approximation/function_rows.h"
#include "support/console.h"
#include "tables/law_times.h"

/* ---- functions of the tables' variables ---- */

enum { FAR_BITS = 400, FIFTH = 5 };

/* exp(s) - 1 */
static void of_log(arb_t zeta, const arb_t s, slong prec)
{
    arb_expm1(zeta, s, prec + 64);
}

static void of_root(arb_t zeta, const arb_t r, slong prec)
{
    arb_pow_ui(zeta, r, FIFTH, prec + 64);
}

/* A sample and an enclosure of TIME at zeta = PLACE(y) */
#define TIME_FUNCTIONS(name, place, time)                                                                              \
    static void name##_sample(arb_t t, const arb_t y, slong prec)                                                      \
    {                                                                                                                  \
        arb_t zeta;                                                                                                    \
        arb_init(zeta);                                                                                                \
        place(zeta, y, prec);                                                                                          \
        time(t, QUADRATURE_GAUSS, zeta, prec);                                                                         \
        arb_clear(zeta);                                                                                               \
    }                                                                                                                  \
    static void name##_enclosure(arb_t t, const arb_t y, slong prec)                                                   \
    {                                                                                                                  \
        arb_t zeta;                                                                                                    \
        arb_init(zeta);                                                                                                \
        place(zeta, y, prec);                                                                                          \
        time(t, QUADRATURE_ENCLOSED, zeta, prec);                                                                      \
        arb_clear(zeta);                                                                                               \
    }

static void linear_max(arb_t t, enum quadrature how, const arb_t beta, slong prec)
{
    crossley_time_of_max_overlap(t, how, CROSSLEY_LINEAR, beta, prec);
}

static void hertz_max(arb_t t, enum quadrature how, const arb_t beta, slong prec)
{
    crossley_time_of_max_overlap(t, how, CROSSLEY_HERTZ, beta, prec);
}

static void linear_duration(arb_t t, enum quadrature how, const arb_t beta, slong prec)
{
    crossley_duration(t, how, CROSSLEY_LINEAR, beta, prec);
}

static void hertz_duration(arb_t t, enum quadrature how, const arb_t beta, slong prec)
{
    crossley_duration(t, how, CROSSLEY_HERTZ, beta, prec);
}

TIME_FUNCTIONS(max_by_log, of_log, tsuji_time_of_max_overlap)
TIME_FUNCTIONS(force_by_root, of_root, tsuji_duration_zero_force)
TIME_FUNCTIONS(force_by_log, of_log, tsuji_duration_zero_force)
TIME_FUNCTIONS(limited_by_root, of_root, tsuji_duration_limited)
TIME_FUNCTIONS(limited_by_log, of_log, tsuji_duration_limited)
TIME_FUNCTIONS(linear_max_by_log, of_log, linear_max)
TIME_FUNCTIONS(hertz_max_by_log, of_log, hertz_max)
TIME_FUNCTIONS(linear_duration_by_log, of_log, linear_duration)
TIME_FUNCTIONS(hertz_duration_by_log, of_log, hertz_duration)

/* ---- tables: only this file defines their geometry ---- */

/* Ends of the rows in s = ln(1 + zeta) or ln(1 + beta) */
#define TSUJI_END 12.25
#define CROSSLEY_MAX_END 26.25
#define CROSSLEY_DURATION_END 4.5
/* End of the rows in r = zeta^(1/5), at zeta = 3.9; the duration at zero force is analytic in r at zeta = 0 */
#define ROOT_END 1.3125
#define TIME_BITS 56

#define LOG_ROWS(first_y, step, end) (first_y) + (step) / 2, step, end, (slong)(((end) - (first_y)) / (step) + 0.5)
#define TABLE(name, title, variable, function, grid)                                                                   \
    {                                                                                                                  \
        name, title, variable, function##_sample, function##_enclosure, grid, TIME_BITS, NULL, NULL                    \
    }

#define OVERLAP_END 10
static struct function_rows tsuji_rows[] = {
    TABLE("cor_rows_tsuji_time_of_max_overlap", "time of the largest overlap", "ln(1 + zeta)", max_by_log,
          LOG_ROWS(0, 0.25, TSUJI_END)),
    TABLE("cor_rows_tsuji_duration_zero_force_weak", "duration at zero force, weak damping", "zeta^(1/5)",
          force_by_root, LOG_ROWS(0, 0.0625, ROOT_END)),
    TABLE("cor_rows_tsuji_duration_zero_force", "duration at zero force", "ln(1 + zeta)", force_by_log,
          LOG_ROWS(1.5, 0.25, TSUJI_END)),
    TABLE("cor_rows_tsuji_duration_limited_weak", "duration with the limited damper, weak damping", "zeta^(1/5)",
          limited_by_root, LOG_ROWS(0, 0.03125, ROOT_END)),
    TABLE("cor_rows_tsuji_duration_limited", "duration with the limited damper", "ln(1 + zeta)", limited_by_log,
          LOG_ROWS(1.5, 0.25, TSUJI_END)),
    {"cor_rows_tsuji_overlap_factor", "V of the duration at zero overlap", "zeta/(10 sqrt(1 - zeta^2))",
     tsuji_overlap_factor, tsuji_overlap_factor, LOG_ROWS(0, 0.0625, OVERLAP_END), TIME_BITS, NULL, NULL},
};
enum { TSUJI_ROWS = sizeof tsuji_rows / sizeof *tsuji_rows };

static struct function_rows crossley_rows[] = {
    TABLE("cor_rows_crossley_time_of_max_overlap_1", "time of the largest overlap, a = 1", "ln(1 + beta)",
          linear_max_by_log, LOG_ROWS(0, 0.375, CROSSLEY_MAX_END)),
    TABLE("cor_rows_crossley_time_of_max_overlap_3_2", "time of the largest overlap, a = 3/2", "ln(1 + beta)",
          hertz_max_by_log, LOG_ROWS(0, 0.375, CROSSLEY_MAX_END)),
    TABLE("cor_rows_crossley_duration_1", "duration, a = 1", "ln(1 + beta)", linear_duration_by_log,
          LOG_ROWS(0, 0.125, CROSSLEY_DURATION_END)),
    TABLE("cor_rows_crossley_duration_3_2", "duration, a = 3/2", "ln(1 + beta)", hertz_duration_by_log,
          LOG_ROWS(0, 0.125, CROSSLEY_DURATION_END)),
};
enum { CROSSLEY_ROWS = sizeof crossley_rows / sizeof *crossley_rows };

static int emit_rows_of(struct emit *e, struct function_rows *rows, int n)
{
    int status = STATUS_OK;
    for (int i = 0; i < n && status == STATUS_OK; i++) {
        progress("tables of laws", i, n);
        status = function_rows_make(&rows[i]);
        if (status == STATUS_OK)
            status = function_rows_emit(e, &rows[i]);
        function_rows_clear(&rows[i]);
    }
    progress_end();
    law_times_clear();
    return status;
}

/* ---- beyond the rows ---- */

/* Solves sum_k c_k basis_k(u_i) = value_i for n unknowns in interval (ball) arithmetic. */
static int far_solve(arb_ptr c, const arb_mat_t a, const arb_mat_t b)
{
    const slong n = arb_mat_nrows(a);
    arb_mat_t x;
    arb_mat_init(x, n, 1);
    const int solved = arb_mat_solve(x, a, b, FAR_BITS);
    for (slong k = 0; k < n; k++)
        arb_set(c + k, arb_mat_entry(x, k, 0));
    arb_mat_clear(x);
    return solved ? STATUS_OK : fail("the coefficients of a far table cannot be solved for");
}

/* A far value: t divided by its power, as mu^j u^k for j < orders, k <= j + logs(j = 0). */
struct far_form {
    const char *name, *title;
    void (*time)(arb_t t, enum quadrature how, const arb_t zeta, slong prec);
    slong power_numerator, power_denominator; /* t zeta^(p/q) is expanded */
    slong mu_power;                           /* mu = zeta^-mu_power */
    slong terms;
    struct {
        int mu, log;
    } term[12];
};

/* Fits the first `terms` coefficients to as many enclosed values with u = ln(zeta) from 13 on. Each coefficient is
 * rounded to a double; c_0 and c_1 also get the remainders of their doubles. */
static int far_make(arb_ptr c, const struct far_form *f)
{
    const slong n = f->terms;
    arb_mat_t a, b;
    arb_t u, zeta, t, power;
    arb_mat_init(a, n, n);
    arb_mat_init(b, n, 1);
    arb_init(u);
    arb_init(zeta);
    arb_init(t);
    arb_init(power);
    for (slong i = 0; i < n; i++) {
        arb_set_d(u, 13 + 0.75 * (double)i);
        arb_exp(zeta, u, FAR_BITS);
        f->time(t, QUADRATURE_ENCLOSED, zeta, 256);
        arb_mul_si(power, u, f->power_numerator, FAR_BITS);
        arb_div_si(power, power, f->power_denominator, FAR_BITS);
        arb_exp(power, power, FAR_BITS);
        arb_mul(arb_mat_entry(b, i, 0), t, power, FAR_BITS);
        for (slong k = 0; k < n; k++) {
            arb_pow_ui(t, u, (ulong)f->term[k].log, FAR_BITS);
            arb_mul_si(power, u, -f->mu_power * f->term[k].mu, FAR_BITS);
            arb_exp(power, power, FAR_BITS);
            arb_mul(arb_mat_entry(a, i, k), t, power, FAR_BITS);
        }
    }
    const int status = far_solve(c, a, b);
    arb_mat_clear(a);
    arb_mat_clear(b);
    arb_clear(u);
    arb_clear(zeta);
    arb_clear(t);
    arb_clear(power);
    return status;
}

/* Intervals that round to the doubles of a row: a coefficient to double precision, its remainder, and so on */
static void exact_double(arb_t x)
{
    arb_set_d(x, arf_get_d(arb_midref(x), ARF_RND_NEAR));
}

static void exact_split(arb_t value, arb_t rest)
{
    arb_set(rest, value);
    exact_double(value);
    arb_sub(rest, rest, value, FAR_BITS);
    exact_double(rest);
}

static int far_emit(struct emit *e, const struct far_form *f)
{
    arb_ptr c = _arb_vec_init(f->terms), row = _arb_vec_init(f->terms + 2);
    int status = far_make(c, f);
    if (status == STATUS_OK) {
        arb_set(row, c);
        exact_split(row, row + 1);
        arb_set(row + 2, c + 1);
        exact_split(row + 2, row + 3);
        for (slong k = 2; k < f->terms; k++) {
            arb_set(row + k + 2, c + k);
            exact_double(row + k + 2);
        }
        emit_rows_open(e, f->name, 1, f->terms + 2);
        status = emit_row(e, f->title, row, f->terms + 2, true) ? STATUS_FAILED : STATUS_OK;
        emit_rows_close(e);
    }
    _arb_vec_clear(c, f->terms);
    _arb_vec_clear(row, f->terms + 2);
    return status;
}

#define QUADRATIC                                                                                                      \
    5,                                                                                                                 \
    {                                                                                                                  \
        {0, 0}, {0, 1}, {1, 0}, {1, 1}, {1, 2},                                                                        \
    }

static const struct far_form tsuji_far[] = {
    {"cor_rows_tsuji_far_time_of_max_overlap", "time of the largest overlap", tsuji_time_of_max_overlap, 4, 5, 2,
     QUADRATIC},
    {"cor_rows_tsuji_far_duration_zero_force", "duration at zero force", tsuji_duration_zero_force, 4, 5, 2, QUADRATIC},
    {"cor_rows_tsuji_far_duration_limited",
     "duration with the limited damper",
     tsuji_duration_limited,
     0,
     1,
     1,
     6,
     {{0, 0}, {1, 0}, {1, 1}, {3, 0}, {3, 1}, {3, 2}}},
};
enum { TSUJI_FAR = sizeof tsuji_far / sizeof *tsuji_far };

/* Checks that the relative error of y^(4/5) V(y) from the row is below 2^-57, sampled from y = OVERLAP_END to 115. */
static int overlap_far_check(arb_srcptr row, slong terms)
{
    arb_t y, v, sum;
    arb_init(y);
    arb_init(v);
    arb_init(sum);
    double worst = 0;
    for (double at = OVERLAP_END; at < 115; at *= 1.03125) {
        arb_set_d(y, at);
        tsuji_overlap_factor(v, y, FAR_BITS);
        arb_root_ui(sum, y, FIFTH, FAR_BITS);
        arb_pow_ui(sum, sum, 4, FAR_BITS);
        arb_mul(v, v, sum, FAR_BITS);
        arb_zero(sum);
        for (slong k = terms; k > 0; k--) {
            arb_add(sum, sum, row + k, FAR_BITS);
            if (k > 1) {
                arb_div(sum, sum, y, FAR_BITS);
                arb_div(sum, sum, y, FAR_BITS);
            }
        }
        arb_add(sum, sum, row, FAR_BITS);
        arb_div(sum, sum, v, FAR_BITS);
        arb_sub_ui(sum, sum, 1, FAR_BITS);
        worst = fmax(worst, fabs(arf_get_d(arb_midref(sum), ARF_RND_NEAR)));
    }
    arb_clear(y);
    arb_clear(v);
    arb_clear(sum);
    return worst < 0x1p-57 ? STATUS_OK : fail("Tsuji's duration at zero overlap is off by %.3g far out", worst);
}

/* y^(4/5) V(y) = v_0 (1 + v_1/y^2 + ...): Stirling's series of |Gamma(9/10 + i y)|^2, whose terms at y = 10 are below
 * 2^-57 from the eighth on. The row is v_0, the remainder of its double, v_1, ..., fitted to values as above. */
static int overlap_far_emit(struct emit *e)
{
    enum { TERMS = 8 };
    arb_mat_t a, b;
    arb_t y, v;
    arb_ptr c = _arb_vec_init(TERMS), row = _arb_vec_init(TERMS + 1);
    arb_mat_init(a, TERMS, TERMS);
    arb_mat_init(b, TERMS, 1);
    arb_init(y);
    arb_init(v);
    for (slong i = 0; i < TERMS; i++) {
        arb_set_ui(y, OVERLAP_END + 6 * (ulong)i);
        tsuji_overlap_factor(v, y, FAR_BITS);
        arb_root_ui(arb_mat_entry(b, i, 0), y, FIFTH, FAR_BITS);
        arb_pow_ui(arb_mat_entry(b, i, 0), arb_mat_entry(b, i, 0), 4, FAR_BITS);
        arb_mul(arb_mat_entry(b, i, 0), arb_mat_entry(b, i, 0), v, FAR_BITS);
        arb_inv(v, y, FAR_BITS);
        for (slong k = 0; k < TERMS; k++)
            arb_pow_ui(arb_mat_entry(a, i, k), v, 2 * (ulong)k, FAR_BITS);
    }
    int status = far_solve(c, a, b);
    if (status == STATUS_OK) {
        arb_set(row, c);
        exact_split(row, row + 1);
        for (slong k = 1; k < TERMS; k++) {
            arb_set(row + k + 1, c + k);
            exact_double(row + k + 1);
        }
        status = overlap_far_check(row, TERMS);
        emit_comment(
            e,
            "y >= 10: V = y^(-4/5) (v_0 + v_0' + v_1/y^2 + ... + v_7/y^14), through values at y = 10 ... 52; relative "
            "error below 2^-57, sampled.");
        emit_rows_open(e, "cor_rows_tsuji_far_overlap_factor", 1, TERMS + 1);
        if (emit_row(e, "V of the duration at zero overlap", row, TERMS + 1, true))
            status = STATUS_FAILED;
        emit_rows_close(e);
    }
    arb_mat_clear(a);
    arb_mat_clear(b);
    arb_clear(y);
    arb_clear(v);
    _arb_vec_clear(c, TERMS);
    _arb_vec_clear(row, TERMS + 1);
    return status;
}

/* How both files are made and known: the end of their banners */
#define SOURCE_OF_ROWS                                                                                                 \
    "Written by:  corgen tables\n"                                                                                     \
    "Checked by:  corgen tables --check\n"                                                                             \
    "\n"                                                                                                               \
    "The rows interpolate polynomials through samples by two Gauss rules of 56 points, which agree with enclosures "   \
    "by\n"                                                                                                             \
    "adaptive quadrature to 1e-20 at two places of each block of rows. Errors of the rows stand above each table "     \
    "and\n"                                                                                                            \
    "beside each row (sampled); errors of evaluation: include/cor/law.h (sampled).\n"

static const char tsuji_banner[] =
    "Times of Tsuji's damping, x'' + sqrt(5) zeta x^(1/4) x' + x^(3/2) = 0, for every damping ratio zeta, in the\n"
    "sphere's unit: rows of short polynomials around the nodes of uniform grids, and what follows at large\n"
    "zeta. Evaluated by runtime/law/tsuji.c. Source: docs/laws.md; form: docs/header-format.md.\n"
    "\n" SOURCE_OF_ROWS;

int tsuji_tables_write(FILE *file, const struct disk_table *none)
{
    (void)none;
    struct emit e;
    emit_open(&e, file, "COR_GENERATED_TSUJI_TABLES_H", tsuji_banner);
    emit_include(&e, "\"runtime/core/rows.h\"");
    int status = emit_rows_of(&e, tsuji_rows, TSUJI_ROWS);
    if (status == STATUS_OK)
        emit_comment(
            &e,
            "ln(1 + zeta) >= 12.25, with u = ln(zeta), mu = 1/zeta^2: t zeta^(4/5) = a_0 + a_0' + (a_1 + a_1') u\n"
            "+ mu (a_2 + a_3 u + a_4 u^2); with the limited damper and mu = 1/zeta: t = a_0 + a_0' + (a_1 + a_1') mu\n"
            "+ a_2 mu u + mu^3 (a_3 + a_4 u + a_5 u^2). Through enclosed values with u = 13, "
            "13.75, ...");
    for (int i = 0; i < TSUJI_FAR && status == STATUS_OK; i++)
        status = far_emit(&e, &tsuji_far[i]);
    if (status == STATUS_OK)
        status = overlap_far_emit(&e);
    emit_close(&e);
    return status;
}

/* ---- Hunt and Crossley beyond the rows ---- */

/* The rebound, beta > 64: with U = beta + 1 - ln(1 + beta) and k = a/(a + 1), in units of beta^(2k - 1) ((a + 1))^-k,
 *
 *     (a + 1) U^(1 - k) + U^-k sum_p c_p U^-p,   c_p = sum_(j=1..p) binom(k+j-1, j) binom(k+p-1, p-j) (p-j)!/j^(p-j+1)
 *
 * from (U - x - exp(-x))^-k by the binomial series in exp(-x), then in x/U. */
static void binomial(arb_t y, const arb_t n, slong m)
{
    arb_t factor;
    arb_init(factor);
    arb_one(y);
    for (slong i = 0; i < m; i++) {
        arb_sub_si(factor, n, i, FAR_BITS);
        arb_mul(y, y, factor, FAR_BITS);
        arb_div_ui(y, y, (ulong)i + 1, FAR_BITS);
    }
    arb_clear(factor);
}

enum { REBOUND_TERMS = 11 };

static void rebound_coefficients(arb_ptr c, slong numerator, ulong denominator)
{
    arb_t k, n, first, second;
    arb_init(k);
    arb_init(n);
    arb_init(first);
    arb_init(second);
    arb_set_si(k, numerator);
    arb_div_ui(k, k, denominator, FAR_BITS);
    for (slong p = 1; p <= REBOUND_TERMS; p++) {
        arb_zero(c + p - 1);
        for (slong j = 1; j <= p; j++) {
            arb_add_si(n, k, j - 1, FAR_BITS);
            binomial(first, n, j);
            arb_add_si(n, k, p - 1, FAR_BITS);
            binomial(second, n, p - j);
            arb_mul(first, first, second, FAR_BITS);
            arb_fac_ui(second, (ulong)(p - j), FAR_BITS);
            arb_mul(first, first, second, FAR_BITS);
            arb_set_ui(second, (ulong)j);
            arb_pow_ui(second, second, (ulong)(p - j + 1), FAR_BITS);
            arb_div(first, first, second, FAR_BITS);
            arb_add(c + p - 1, c + p - 1, first, FAR_BITS);
        }
        exact_double(c + p - 1);
    }
    arb_clear(k);
    arb_clear(n);
    arb_clear(first);
    arb_clear(second);
}

static int rebound_emit(struct emit *e, const char *name, const char *title, slong numerator, ulong denominator)
{
    arb_ptr c = _arb_vec_init(REBOUND_TERMS);
    rebound_coefficients(c, numerator, denominator);
    emit_rows_open(e, name, 1, REBOUND_TERMS);
    const int status = emit_row(e, title, c, REBOUND_TERMS, true) ? STATUS_FAILED : STATUS_OK;
    emit_rows_close(e);
    _arb_vec_clear(c, REBOUND_TERMS);
    return status;
}

/* The time of the largest overlap, s = ln(1 + beta) >= 26.25, in units of beta^(2k - 1) ((a + 1)(1 + beta))^-k: s + K +
 * (k_0 + k_1 s + k_2 s^2)/(1 + beta), K = -psi(1 - k) - gamma; k_j are fitted to enclosed values. */
static int loading_emit(struct emit *e, const char *name, const char *title, enum crossley_exponent a, slong numerator,
                        ulong denominator)
{
    enum { TERMS = 3 };
    arb_mat_t m, b;
    arb_t k, s, beta, t, x;
    arb_ptr c = _arb_vec_init(TERMS), row = _arb_vec_init(TERMS + 2);
    arb_mat_init(m, TERMS, TERMS);
    arb_mat_init(b, TERMS, 1);
    arb_init(k);
    arb_init(s);
    arb_init(beta);
    arb_init(t);
    arb_init(x);
    arb_set_si(k, numerator);
    arb_div_ui(k, k, denominator, FAR_BITS);
    arb_sub_ui(x, k, 1, FAR_BITS);
    arb_neg(x, x);
    arb_digamma(row, x, FAR_BITS);
    arb_const_euler(x, FAR_BITS);
    arb_add(row, row, x, FAR_BITS);
    arb_neg(row, row);
    for (slong i = 0; i < TERMS; i++) {
        arb_set_si(s, 27 + 3 * i);
        arb_expm1(beta, s, FAR_BITS);
        crossley_time_of_max_overlap(t, QUADRATURE_ENCLOSED, a, beta, 300);
        /* (a + 1) = 1/(1 - k) */
        arb_sub_ui(x, k, 1, FAR_BITS);
        arb_neg(x, x);
        arb_inv(x, x, FAR_BITS);
        arb_log(x, x, FAR_BITS);
        arb_add(x, x, s, FAR_BITS);
        arb_mul(x, x, k, FAR_BITS);
        arb_exp(x, x, FAR_BITS);
        arb_mul(t, t, x, FAR_BITS);
        arb_log(x, beta, FAR_BITS);
        arb_mul(x, x, k, FAR_BITS);
        arb_mul_2exp_si(x, x, 1);
        arb_log(beta, beta, FAR_BITS);
        arb_sub(x, beta, x, FAR_BITS);
        arb_exp(x, x, FAR_BITS);
        arb_mul(t, t, x, FAR_BITS);
        arb_sub(t, t, s, FAR_BITS);
        arb_sub(t, t, row, FAR_BITS);
        arb_exp(x, s, FAR_BITS);
        arb_mul(arb_mat_entry(b, i, 0), t, x, FAR_BITS);
        for (slong j = 0; j < TERMS; j++)
            arb_pow_ui(arb_mat_entry(m, i, j), s, (ulong)j, FAR_BITS);
    }
    int status = far_solve(c, m, b);
    if (status == STATUS_OK) {
        exact_split(row, row + 1);
        for (slong j = 0; j < TERMS; j++) {
            arb_set(row + 2 + j, c + j);
            exact_double(row + 2 + j);
        }
        emit_rows_open(e, name, 1, TERMS + 2);
        status = emit_row(e, title, row, TERMS + 2, true) ? STATUS_FAILED : STATUS_OK;
        emit_rows_close(e);
    }
    arb_mat_clear(m);
    arb_mat_clear(b);
    arb_clear(k);
    arb_clear(s);
    arb_clear(beta);
    arb_clear(t);
    arb_clear(x);
    _arb_vec_clear(c, TERMS);
    _arb_vec_clear(row, TERMS + 2);
    return status;
}

static const char crossley_banner[] =
    "Times of Hunt and Crossley's law F = K x^a (1 + d x') with a = 1 and 3/2, for every beta = d g >= 0, in units of\n"
    "(m/K)^(1/(a+1)) g^((1-a)/(a+1)): rows of short polynomials around the nodes of uniform grids in ln(1 + beta), "
    "and\n"
    "what follows at large beta. Evaluated by runtime/law/hunt_crossley_times.c. Source: docs/laws.md; form:\n"
    "docs/header-format.md.\n"
    "\n" SOURCE_OF_ROWS;

int hunt_crossley_tables_write(FILE *file, const struct disk_table *none)
{
    (void)none;
    struct emit e;
    emit_open(&e, file, "COR_GENERATED_HUNT_CROSSLEY_TABLES_H", crossley_banner);
    emit_include(&e, "\"runtime/core/rows.h\"");
    int status = emit_rows_of(&e, crossley_rows, CROSSLEY_ROWS);
    if (status == STATUS_OK) {
        emit_comment(&e,
                     "s = ln(1 + beta) >= 26.25: the time of the largest overlap is beta^(2k-1) ((a+1) (1+beta))^-k\n"
                     "(s + K + K' + (k_0 + k_1 s + k_2 s^2)/(1 + beta)), k = a/(a+1): columns K, K', k_0, k_1, k_2. K "
                     "exact, k_j through\n"
                     "three enclosed values.");
        status = loading_emit(&e, "cor_rows_crossley_far_time_of_max_overlap_1", "a = 1", CROSSLEY_LINEAR, 1, 2);
    }
    if (status == STATUS_OK)
        status = loading_emit(&e, "cor_rows_crossley_far_time_of_max_overlap_3_2", "a = 3/2", CROSSLEY_HERTZ, 3, 5);
    if (status == STATUS_OK) {
        emit_comment(
            &e, "s >= 4.5: the rebound takes beta^(2k-1) (a+1)^-k ((a+1) U^(1-k) + U^-k (c_1/U + ... + c_11/U^11)),\n"
                "U = 1 + beta - ln(1 + beta). Exact coefficients.");
        status = rebound_emit(&e, "cor_rows_crossley_far_rebound_1", "a = 1", 1, 2);
    }
    if (status == STATUS_OK)
        status = rebound_emit(&e, "cor_rows_crossley_far_rebound_3_2", "a = 3/2", 3, 5);
    emit_close(&e);
    return status;
}
