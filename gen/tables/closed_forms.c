/* SPDX-License-Identifier: MIT */
#include "tables/files.h"

#include "approximation/pieces.h"
#include "enclosure/closed_form.h"
#include "support/console.h"
#include "support/formula.h"
#include "support/local.h"
#include "support/root.h"

enum { WORKING_BITS = 320, EXPONENT_BITS = 480, HEAD_BITS = 26 };

/* Bits that each row must reach. They limit its error to 0.7 units of the last place; the evaluation adds 0.6. */
#define LEAST_BITS 53.5

/* ---- L = -ln(eps), x > 0 ---- */

typedef void exponent_function(arb_t L, const arb_t x);

static void approach_only(arb_t L, const arb_t zeta)
{
    closed_form_angle(L, zeta, EXPONENT_BITS);
    LET(L, EXPONENT_BITS, "zeta*L", zeta, L);
}

static void zero_force(arb_t L, const arb_t zeta)
{
    closed_form_angle(L, zeta, EXPONENT_BITS);
    LET(L, EXPONENT_BITS, "2*zeta*L", zeta, L);
}

static void zero_overlap(arb_t L, const arb_t zeta)
{
    LET(L, EXPONENT_BITS, "pi*zeta/sqrt((1 - zeta)*(1 + zeta))", zeta);
}

static void inverse_zero_overlap(arb_t zeta, const arb_t L)
{
    LET(zeta, EXPONENT_BITS, "L/sqrt(pi^2 + L^2)", L);
}

static void set_limited_log(arb_t L, const arb_t zeta)
{
    LOCAL(arb, R, C);
    LET(R, EXPONENT_BITS, "sqrt(1 + 8*zeta^2)", zeta);
    LET(C, EXPONENT_BITS, "zeta*sqrt(2*(R + 3)/(R*(R + 1)))", zeta, R);
    zero_force(L, C);
    LET(L, EXPONENT_BITS, "(R + 1)/(R + 3)*L", R, L);
}

/* eps = (1 + W_0(-x))/beta, x = (1 + beta) exp(-1 - beta) */
static void set_crossley_log(arb_t L, const arb_t beta)
{
    LOCAL(arb, w);
    LET(w, EXPONENT_BITS, "-(1 + beta)*exp(-1 - beta)", beta);
    arb_lambertw(w, w, 0, EXPONENT_BITS);
    LET(L, EXPONENT_BITS, "-log((1 + w)/beta)", w, beta);
}

static void crossley_approach_only(arb_t L, const arb_t beta)
{
    LET(L, EXPONENT_BITS, "-log(2*(beta - log1p(beta))/beta^2)/2", beta);
}

/* ---- laws ---- */

/* A law with its tables. The tables of eps have rows of (1 - eps)/x on a grid up to x = near_end, and rows of eps by
 * octaves up to `end`. The tables of the inverse have rows of x/(1 - eps) up to 1 - eps = 1/2, and rows of x by octaves
 * of eps from 2^least_octave to 1/2. */
struct closed_form {
    const char *stem, *title;
    bool is_crossley;
    exponent_function *exponent;
    slong slope, over; /* dL/dx at x = 0 is slope/over, or pi slope/over if x is a damping ratio */
    double near_end, end;
    int least_octave;
    exponent_function *inverse; /* NULL: x is found by iteration, which requires a concave L */
};
static const struct closed_form laws[] = {
    {"ratio%s_zero_overlap", "linear and Tsuji, zero overlap", false, zero_overlap, 1, 1, 0.25, 0.75, -6,
     inverse_zero_overlap},
    {"ratio%s_zero_force", "linear and Tsuji, zero force", false, zero_force, 1, 1, 0.25, 4, -6, NULL},
    {"ratio%s_approach_only", "linear and Tsuji, damped approach", false, approach_only, 1, 2, 0.5, 4, -3, NULL},
    {"ratio%s_limited", "linear and Tsuji, limited damper", false, set_limited_log, 1, 1, 0.25, 16, -5, NULL},
    {"crossley%s", "Hunt and Crossley", true, set_crossley_log, 2, 3, 1, 64, -6, NULL},
    {"crossley%s_approach_only", "Hunt and Crossley, damped approach", true, crossley_approach_only, 1, 3, 1, 16, -2,
     NULL},
};
enum { LAWS = sizeof laws / sizeof *laws };

/* Computes dL/dx at x = 0, or dx/dL. */
static void slope_at_0(arb_t slope, const struct closed_form *law, bool of_inverse)
{
    const slong sign = of_inverse ? -1 : 1, power = law->is_crossley ? 0 : sign, p = law->slope, q = law->over;
    LET(slope, WORKING_BITS, "(p/q)^sign*pi^power", p, q, sign, power);
}

struct exponent_of {
    const struct closed_form *law;
    arb_srcptr wanted;
};

static bool exponent_below(arb_t f, const arb_t x, const void *context, slong prec)
{
    const struct exponent_of *const of = context;
    of->law->exponent(f, x);
    arb_sub(f, of->wanted, f, prec);
    return true;
}

/* Computes the x at which L is `wanted` > 0. The first guess is not above the root if L is concave. */
static int damping_of(arb_t x, const struct closed_form *law, const arb_t wanted)
{
    enum { ROOT_BITS = 200 };
    const struct exponent_of of = {law, wanted};
    LOCAL(arb, slope);
    if (law->inverse) {
        law->inverse(x, wanted);
        return STATUS_OK;
    }
    slope_at_0(slope, law, false);
    LET(x, WORKING_BITS, "wanted/slope", wanted, slope);
    return root_near(x, exponent_below, &of, ROOT_BITS, WORKING_BITS)
               ? STATUS_OK
               : fail("%s: cannot round the inverse: its enclosure is too wide", law->title);
}

enum form { LOSS_QUOTIENT, EPS, DAMPING_QUOTIENT, DAMPING };

struct closed_rows {
    const struct closed_form *law;
    enum form form;
};

/* Computes the quantity of a table (enum form) at the variable y of a cell; x = y 2^octave. */
static int closed_form_at(arb_t f, const void *context, const struct pieces *p, const struct cell *cell, const arb_t y)
{
    (void)p;
    const struct closed_rows *const rows = context;
    LOCAL(arb, x, L);
    arb_mul_2exp_si(x, y, cell->octave);
    if (arb_is_zero(x)) {
        slope_at_0(f, rows->law, rows->form == DAMPING_QUOTIENT);
        return STATUS_OK;
    }
    if (rows->form == LOSS_QUOTIENT || rows->form == EPS) {
        rows->law->exponent(L, x);
        if (rows->form == EPS)
            LET(f, WORKING_BITS, "exp(-L)", L);
        else
            LET(f, WORKING_BITS, "-expm1(-L)/x", L, x);
        return STATUS_OK;
    }
    if (rows->form == DAMPING)
        LET(L, WORKING_BITS, "-log(x)", x);
    else
        LET(L, WORKING_BITS, "-log1p(-x)", x);
    const int status = damping_of(f, rows->law, L);
    if (rows->form == DAMPING_QUOTIENT)
        LET(f, WORKING_BITS, "f/x", f, x);
    return status;
}

/* ---- rows ---- */

static int emit_form(struct emit *e, const struct closed_form *law, enum form form)
{
    static const struct {
        const char *part, *words; /* part of the name; words of the title */
        enum variable variable;
    } of[] = {{"_loss", "(1 - eps)/%s", VARIABLE_OTHER},
              {"_eps", "eps", VARIABLE_BETA_OCTAVES},
              {"_near_%s", "%s/(1 - eps)", VARIABLE_LOSS},
              {"_%s", "%s", VARIABLE_EPS_OCTAVES}};
    const bool grid = form == LOSS_QUOTIENT || form == DAMPING_QUOTIENT, inverse = form >= DAMPING_QUOTIENT;
    const char *const x = law->is_crossley ? "beta" : "zeta";
    char part[16], stem[48], name[64], what[24], title[80], y[16];
    snprintf(part, sizeof part, of[form].part, x);
    snprintf(stem, sizeof stem, law->stem, part);
    snprintf(name, sizeof name, "cor_rows_%s", stem);
    snprintf(what, sizeof what, of[form].words, x);
    snprintf(title, sizeof title, "%s: %s", law->title, what);
    snprintf(y, sizeof y, grid ? "%s" : "%s 2^-k", x);
    struct pieces p = {.root = 1,
                       .degree = 10,
                       .name = name,
                       .title = title,
                       .least_bits = LEAST_BITS,
                       .variable = of[form].variable,
                       .words = inverse ? NULL : y,
                       .end = inverse ? 0.5
                              : grid  ? law->near_end
                                      : law->end};
    if (grid) {
        p.step = 0.125;
        p.head_bits = HEAD_BITS;
    } else {
        p.first = inverse ? law->least_octave : ilogb(law->near_end);
        p.octave_bits = PIECES_OCTAVE_BITS;
    }
    const struct closed_rows rows = {law, form};
    return pieces_write(e, &p, (struct pieces_function){closed_form_at, &rows});
}

static const char what[] =
    "eps and beta or zeta of eps for the linear dashpot, Tsuji's damping and Hunt and Crossley's law: rows of short\n"
    "polynomials around the nodes of uniform grids and by octaves. Evaluated by runtime/law/closed_form.h. Source:\n"
    "docs/laws.md; form: docs/internals.md.\n",
                  how[] = "The rows interpolate enclosures to 200 bits. Errors of the rows are above each table "
                          "(sampled); errors of\n"
                          "evaluation: include/cor/law.h (sampled).\n";

int closed_form_tables_write(FILE *file)
{
    struct emit e;
    emit_open_tables(&e, file, "closed_form", what, how, EMIT_INCLUDE_ROWS);
    int status = STATUS_OK;
    for (int i = 0; i < LAWS; i++)
        for (int form = LOSS_QUOTIENT; form <= DAMPING && status == STATUS_OK; form++)
            status = emit_form(&e, &laws[i], (enum form)form);
    emit_close(&e);
    return status;
}
