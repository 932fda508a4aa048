/* SPDX-License-Identifier: MIT */
#include "tables/closed_forms.h"

#include "approximation/pieces.h"
#include "support/console.h"
#include "support/local.h"

enum { EXTRA_BITS = 160, WORKING_BITS = 320, ROOT_BITS = 220, HEAD_BITS = 26 };

/* Bits that each row must reach: half a unit of the last place and a fifth, beside the three fifths of the evaluation */
#define LEAST_BITS 53.5

/* ---- L = -ln(eps), x > 0 ---- */

typedef void exponent_function(arb_t L, const arb_t x, slong prec);

/* A = acos(zeta)/sqrt(1 - zeta^2), which is the hypergeometric function F(1, 1; 3/2; (1 - zeta)/2) */
static void phase_time(arb_t A, const arb_t zeta, slong prec)
{
    LOCAL(arb, less, product, one, half);
    arb_sub_ui(less, zeta, 1, prec);
    arb_neg(less, less);
    arb_add_ui(product, zeta, 1, prec);
    arb_mul(product, product, less, prec);
    arb_one(one);
    arb_mul_2exp_si(half, one, -20);
    arb_abs(A, less);
    if (arb_lt(A, half)) {
        arb_mul_2exp_si(less, less, -1);
        arb_set_d(half, 1.5);
        arb_hypgeom_2f1(A, one, one, half, less, 0, prec);
        return;
    }
    if (arb_is_negative(less)) {
        arb_neg(product, product);
        arb_acosh(A, zeta, prec);
    } else {
        arb_acos(A, zeta, prec);
    }
    arb_rsqrt(product, product, prec);
    arb_mul(A, A, product, prec);
}

static void approach_only(arb_t L, const arb_t zeta, slong prec)
{
    phase_time(L, zeta, prec);
    arb_mul(L, L, zeta, prec);
}

static void zero_force(arb_t L, const arb_t zeta, slong prec)
{
    approach_only(L, zeta, prec);
    arb_mul_2exp_si(L, L, 1);
}

static void zero_overlap(arb_t L, const arb_t zeta, slong prec)
{
    LOCAL(arb, pi);
    arb_mul(L, zeta, zeta, prec);
    arb_sub_ui(L, L, 1, prec);
    arb_neg(L, L);
    arb_rsqrt(L, L, prec);
    arb_mul(L, L, zeta, prec);
    arb_const_pi(pi, prec);
    arb_mul(L, L, pi, prec);
}

/* L/sqrt(pi^2 + L^2) */
static void inverse_zero_overlap(arb_t zeta, const arb_t L, slong prec)
{
    LOCAL(arb, square);
    arb_const_pi(square, prec);
    arb_mul(square, square, square, prec);
    arb_addmul(square, L, L, prec);
    arb_rsqrt(square, square, prec);
    arb_mul(zeta, L, square, prec);
}

/* (R + 1)/(R + 3) 2 C A(C), R = sqrt(1 + 8 zeta^2), C = zeta sqrt(2 (R + 3)/(R (R + 1))) */
static void limited(arb_t L, const arb_t zeta, slong prec)
{
    LOCAL(arb, R, C, share);
    arb_mul(R, zeta, zeta, prec);
    arb_mul_2exp_si(R, R, 3);
    arb_add_ui(R, R, 1, prec);
    arb_sqrt(R, R, prec);
    arb_add_ui(share, R, 1, prec);
    arb_add_ui(C, R, 3, prec);
    arb_div(share, share, C, prec);
    arb_mul(R, R, share, prec);
    arb_mul_2exp_si(R, R, -1);
    arb_rsqrt(R, R, prec);
    arb_mul(C, zeta, R, prec);
    zero_force(L, C, prec);
    arb_mul(L, L, share, prec);
}

/* eps = (1 + W_0(-x))/beta, x = (1 + beta) exp(-1 - beta) */
static void crossley(arb_t L, const arb_t beta, slong prec)
{
    LOCAL(arb, minus, x);
    arb_add_ui(minus, beta, 1, prec);
    arb_neg(minus, minus);
    arb_exp(x, minus, prec);
    arb_mul(x, x, minus, prec);
    arb_lambertw(x, x, 0, prec);
    arb_add_ui(x, x, 1, prec);
    arb_div(x, x, beta, prec);
    arb_log(L, x, prec);
    arb_neg(L, L);
}

/* eps^2 = 2 (beta - ln(1 + beta))/beta^2 */
static void crossley_approach_only(arb_t L, const arb_t beta, slong prec)
{
    LOCAL(arb, x);
    arb_log1p(x, beta, prec);
    arb_sub(x, beta, x, prec);
    arb_mul_2exp_si(x, x, 1);
    arb_div(x, x, beta, prec);
    arb_div(x, x, beta, prec);
    arb_log(L, x, prec);
    arb_mul_2exp_si(L, L, -1);
    arb_neg(L, L);
}

/* ---- laws ---- */

/* Rows of (1 - eps)/x on a grid up to x = near_end and of eps by octaves up to `end`; of x/(1 - eps) up to 1 - eps =
 * 1/2, and of x by octaves of eps from 2^least_octave to there */
struct closed_form {
    const char *stem, *title;
    bool is_crossley;
    exponent_function *exponent;
    ulong slope, over; /* dL/dx at x = 0 is slope/over, times pi for a damping ratio */
    double near_end, end;
    int least_octave;
    exponent_function *inverse; /* NULL: x is solved for; L is concave */
};
static const struct closed_form laws[] = {
    {"ratio%s_zero_overlap", "linear and Tsuji, zero overlap", false, zero_overlap, 1, 1, 0.25, 0.75, -6,
     inverse_zero_overlap},
    {"ratio%s_zero_force", "linear and Tsuji, zero force", false, zero_force, 1, 1, 0.25, 4, -6, NULL},
    {"ratio%s_approach_only", "linear and Tsuji, damped approach", false, approach_only, 1, 2, 0.5, 4, -3, NULL},
    {"ratio%s_limited", "linear and Tsuji, limited damper", false, limited, 1, 1, 0.25, 16, -5, NULL},
    {"crossley%s", "Hunt and Crossley", true, crossley, 2, 3, 1, 64, -6, NULL},
    {"crossley%s_approach_only", "Hunt and Crossley, damped approach", true, crossley_approach_only, 1, 3, 1, 16, -2,
     NULL},
};
enum { LAWS = sizeof laws / sizeof *laws };

static const char *variable_of(const struct closed_form *law)
{
    return law->is_crossley ? "beta" : "zeta";
}

/* dL/dx at x = 0, or dx/dL */
static void slope_at_0(arb_t slope, const struct closed_form *law, bool of_inverse)
{
    arb_set_ui(slope, of_inverse ? law->over : law->slope);
    arb_div_ui(slope, slope, of_inverse ? law->slope : law->over, WORKING_BITS); /* Hunt and Crossley's 3/2 is exact */
    if (!law->is_crossley) {
        LOCAL(arb, pi);
        arb_const_pi(pi, WORKING_BITS);
        (of_inverse ? arb_div : arb_mul)(slope, slope, pi, WORKING_BITS);
    }
}

static void exponent_of(arb_t L, const struct closed_form *law, const arb_t x)
{
    law->exponent(L, x, WORKING_BITS + EXTRA_BITS);
}

/* x where L is `wanted` > 0. Where L is concave, the secant method from two values on the left stays there. Both sides of
 * the result are compared. */
static int damping_of(arb_t x, const struct closed_form *law, const arb_t wanted)
{
    enum { STEPS = 60 };
    LOCAL(arb, slope, off, last, last_off, step, margin);
    if (law->inverse) {
        law->inverse(x, wanted, WORKING_BITS + EXTRA_BITS);
        return STATUS_OK;
    }
    slope_at_0(slope, law, false);
    arb_div(x, wanted, slope, WORKING_BITS);
    for (int k = 0; k < STEPS; k++) {
        arb_get_mid_arb(x, x);
        exponent_of(off, law, x);
        arb_sub(off, wanted, off, WORKING_BITS);
        arb_mul_2exp_si(margin, wanted, -ROOT_BITS);
        arb_abs(step, off);
        if (arb_lt(step, margin))
            break;
        if (k > 0) {
            arb_sub(slope, last_off, off, WORKING_BITS);
            arb_sub(step, x, last, WORKING_BITS);
            arb_div(slope, slope, step, WORKING_BITS);
        }
        arb_set(last, x);
        arb_set(last_off, off);
        arb_div(step, off, slope, WORKING_BITS);
        arb_add(x, x, step, WORKING_BITS);
    }
    arb_mul_2exp_si(margin, x, 20 - ROOT_BITS);
    arb_sub(last, x, margin, WORKING_BITS);
    arb_add(last_off, x, margin, WORKING_BITS);
    exponent_of(off, law, last);
    exponent_of(step, law, last_off);
    if (!arb_lt(off, wanted) || !arb_gt(step, wanted))
        return fail("%s: the inverse is not known well enough", law->title);
    arb_union(x, last, last_off, WORKING_BITS);
    return STATUS_OK;
}

enum form { LOSS_QUOTIENT, EPS, DAMPING_QUOTIENT, DAMPING };

struct closed_rows {
    const struct closed_form *law;
    enum form form;
};

/* The value of the form at the place y of a cell */
static int closed_form_at(arb_t f, const void *context, const struct pieces *p, const struct cell *cell, const arb_t y)
{
    (void)p;
    const struct closed_rows *const rows = context;
    const int is_quotient = rows->form == LOSS_QUOTIENT || rows->form == DAMPING_QUOTIENT;
    int status = STATUS_OK;
    LOCAL(arb, x, L);
    arb_mul_2exp_si(x, y, cell->octave);
    if (arb_is_zero(x)) {
        slope_at_0(f, rows->law, rows->form == DAMPING_QUOTIENT);
        return STATUS_OK;
    }
    if (rows->form == LOSS_QUOTIENT || rows->form == EPS) {
        exponent_of(L, rows->law, x);
        arb_neg(L, L);
        (is_quotient ? arb_expm1 : arb_exp)(f, L, WORKING_BITS);
        if (is_quotient)
            arb_neg(f, f);
    } else {
        arb_neg(L, x);
        (is_quotient ? arb_log1p : arb_log)(L, is_quotient ? L : x, WORKING_BITS);
        arb_neg(L, L);
        status = damping_of(f, rows->law, L);
    }
    if (is_quotient)
        arb_div(f, f, x, WORKING_BITS);
    return status;
}

/* ---- rows ---- */

static void set_grid(struct pieces *p, enum variable variable, const char *words, double end)
{
    p->variable = variable;
    p->words = words;
    p->step = 0.125;
    p->end = end;
    p->head_bits = HEAD_BITS;
}

static void set_octaves(struct pieces *p, enum variable variable, const char *words, int first, double end)
{
    p->variable = variable;
    p->words = words;
    p->first = first;
    p->octave_bits = PIECES_OCTAVE_BITS;
    p->end = end;
}

static int emit_form(struct emit *e, const struct closed_form *law, enum form form)
{
    static const char *const quantity[] = {"_loss", "_eps", "_near_%s", "_%s"}, *const words[] = {"(1 - eps)/%s", "eps",
                                                                                                  "%s/(1 - eps)", "%s"};
    const char *const x = variable_of(law);
    char part[16], stem[48], name[64], what[24], title[80];
    snprintf(part, sizeof part, quantity[form], x);
    snprintf(stem, sizeof stem, law->stem, part);
    snprintf(name, sizeof name, "cor_rows_%s", stem);
    snprintf(what, sizeof what, words[form], x);
    snprintf(title, sizeof title, "%s: %s", law->title, what);
    struct pieces p = {.root = 1, .degree = 10, .name = name, .title = title, .least_bits = LEAST_BITS};
    if (form == LOSS_QUOTIENT)
        set_grid(&p, VARIABLE_OTHER, x, law->near_end);
    else if (form == EPS)
        set_octaves(&p, VARIABLE_BETA_OCTAVES, law->is_crossley ? "beta 2^-k" : "zeta 2^-k", ilogb(law->near_end),
                    law->end);
    else if (form == DAMPING_QUOTIENT)
        set_grid(&p, VARIABLE_LOSS, NULL, 0.5);
    else
        set_octaves(&p, VARIABLE_EPS_OCTAVES, NULL, law->least_octave, 0.5);
    const struct closed_rows rows = {law, form};
    int status = pieces_fit(&p, (struct pieces_function){closed_form_at, &rows});
    if (status == STATUS_OK)
        status = pieces_emit(e, &p);
    pieces_clear(&p);
    return status;
}

static const char banner[] =
    "eps and beta or zeta of eps for the linear dashpot, Tsuji's damping and Hunt and Crossley's law: rows of short\n"
    "polynomials around the nodes of uniform grids and by octaves. Evaluated by runtime/law/closed_form.h. Source:\n"
    "docs/laws.md; form: docs/internals.md.\n"
    "\n"
    "Written by:  corgen tables\n"
    "Checked by:  corgen tables --check\n"
    "\n"
    "The rows interpolate enclosures to 200 bits. Errors of the rows stand above each table (sampled); errors of\n"
    "evaluation: include/cor/law.h (sampled).\n";

int closed_form_tables_write(FILE *file)
{
    struct emit e;
    emit_open(&e, file, "COR_GENERATED_CLOSED_FORM_TABLES_H", banner);
    emit_include(&e, "\"runtime/table/rows.h\"");
    int status = STATUS_OK;
    for (int i = 0; i < LAWS; i++)
        for (int form = LOSS_QUOTIENT; form <= DAMPING && status == STATUS_OK; form++)
            status = emit_form(&e, &laws[i], (enum form)form);
    emit_close(&e);
    return status;
}
