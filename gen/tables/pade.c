/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L /* open_memstream */

#include "tables/pade.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "approximation/published.h"
#include "support/console.h"
#include "support/local.h"

enum { NAME_MAX_LENGTH = 128 };

/* Writes the prefix in capitals and the suffix. */
static void macro_name(char name[NAME_MAX_LENGTH], const char *prefix, const char *suffix)
{
    snprintf(name, NAME_MAX_LENGTH, "%s%s", prefix, suffix);
    emit_capitals(name);
}

static int emit_polynomial(struct emit *e, const char *prefix, const char *suffix, const arb_poly_t p)
{
    char name[NAME_MAX_LENGTH];
    snprintf(name, sizeof name, "%s%s", prefix, suffix);
    return emit_doubles(e, name, p->coeffs, arb_poly_length(p));
}

static void emit_lengths(struct emit *e, const char *prefix, const struct pade_rounded *r)
{
    char text[3][NAME_MAX_LENGTH];
    macro_name(text[0], prefix, "_p");
    macro_name(text[1], prefix, "_q");
    macro_name(text[2], prefix, "_l");
    const char *const name[] = {text[0], text[1], text[2]};
    const slong value[] = {arb_poly_length(r->p), arb_poly_length(r->q), arb_poly_length(r->l)};
    emit_constants(e, name, value, 3);
}

/* name_eps and name_loss of the variable */
static void emit_functions(struct emit *e, const char *prefix, const struct pade *f)
{
    char text[8][NAME_MAX_LENGTH];
    static const char *const suffix[] = {"_p", "_q", "_l"};
    for (int i = 0; i < 3; i++) {
        snprintf(text[i], NAME_MAX_LENGTH, "%s%s", prefix, suffix[i]);
        macro_name(text[3 + i], prefix, suffix[i]);
    }
    const char *const array[3][2] = {{text[0], text[3]}, {text[1], text[4]}, {text[2], text[5]}};
    char z[NAME_MAX_LENGTH];
    if (f->root <= 1)
        snprintf(z, sizeof z, "%s", f->variable);
    else if (f->root == 2)
        snprintf(z, sizeof z, "sqrt(%s)", f->variable);
    else
        snprintf(z, sizeof z, "pow(%s, 1.0 / %ld)", f->variable, (long)f->root);
    snprintf(text[6], NAME_MAX_LENGTH, "%s_eps", prefix);
    snprintf(text[7], NAME_MAX_LENGTH, "%s_loss", prefix);
    emit_comment(e, "eps, and 1 - eps without cancellation near 0; NaN below 0%s",
                 f->root > 2 ? ". The rounding of pow is not part of the bounds." : "");
    emit_inline_quotient(e, text[6], f->variable, z, NULL, array[0], array[1]);
    emit_inline_quotient(e, text[7], f->variable, z, f->variable, array[2], array[1]);
}

static void emit_error(struct emit *e, const char *prefix, const char *suffix, double x)
{
    char name[NAME_MAX_LENGTH];
    macro_name(name, prefix, suffix);
    if (isfinite(x))
        emit_define(e, name, emit_bound(x).text);
}

static void print_error(FILE *text, const char *what, double error, const fmpq_t beta)
{
    char *place = fmpq_get_str(NULL, 10, beta);
    fprintf(text, "  %s %s, worst at beta = %s\n", what, emit_bound(error).text, place);
    flint_free(place);
}

/* The comment above the arrays. */
static char *pade_comment(const struct pade_header *h, const struct pade *f, const struct pade_analysis *a,
                          const struct pade_error *approximation, double eps, double loss)
{
    char *text;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    if (!file)
        return NULL;
    fprintf(file, "%s, [%ld/%ld].\n", h->title, (long)f->numerator, (long)f->denominator);
    pade_print_analysis(file, a, "");
    if (approximation) {
        fprintf(file,
                "Relative error of the approximation, coefficients rounded: sampled at %ld values of "
                "beta up to %ld\n(%ld steps%s and powers of 2 near 0):\n",
                (long)h->references->count, (long)h->beta_max, (long)h->references->even,
                h->references->far > 0 ? " up to 2, factors of 5/4 beyond," : ",");
        print_error(file, "eps ", approximation->eps, approximation->eps_at_beta);
        print_error(file, "loss", approximation->loss, approximation->loss_at_beta);
    } else {
        fprintf(file, "Error of the approximation: not assessed.\n");
    }
    fprintf(file,
            "Relative error of the evaluation in double, Horner's rule: proved by interval "
            "arithmetic over\n0 <= %s <= %ld:\n",
            f->variable, (long)h->beta_max);
    if (isfinite(eps))
        fprintf(file, "  eps  %s, loss ", emit_bound(eps).text);
    else
        fprintf(file, "  eps  without bound (P or Q may vanish), loss ");
    fprintf(file, isfinite(loss) ? "%s\n" : "without bound\n", emit_bound(loss).text);
    fclose(file);
    return text;
}

int pade_emit(struct emit *e, const struct pade_header *h, const struct pade *f, const struct pade_analysis *a)
{
    double eps, loss;
    LOCAL_INIT(pade_rounded, r, (&r));
    LOCAL_INIT(pade_error, approximation, (&approximation));
    int status = pade_round(&r, f);
    if (status == 0) {
        pade_evaluation_error(&eps, &loss, &r, h->beta_max);
        if (h->references)
            pade_approximation_error(&approximation, &r, h->end, h->references);
        const double worst = fmax(approximation.eps + eps, approximation.loss + loss);
        if (!(worst <= h->limit))
            status = fail("%s: relative error %.1e, above %.1e", h->name, worst, h->limit);
    }
    if (status == 0) {
        char *text = pade_comment(h, f, a, h->references ? &approximation : NULL, eps, loss);
        emit_comment(e, "%s", text ? text : h->title);
        free(text);
        emit_lengths(e, h->name, &r);
        if (h->references) {
            emit_error(e, h->name, "_eps_approximation_rel", approximation.eps);
            emit_error(e, h->name, "_loss_approximation_rel", approximation.loss);
            emit_error(e, h->name, "_eps_evaluation_rel", eps);
            emit_error(e, h->name, "_loss_evaluation_rel", loss);
            emit_error(e, h->name, "_eps_max_rel", approximation.eps + eps);
            emit_error(e, h->name, "_loss_max_rel", approximation.loss + loss);
            emit_error(e, h->name, "_beta_max", (double)h->beta_max);
        }
        status = emit_polynomial(e, h->name, "_p", r.p) || emit_polynomial(e, h->name, "_q", r.q) ||
                 emit_polynomial(e, h->name, "_l", r.l);
        if (status == 0)
            emit_functions(e, h->name, f);
    }
    return status;
}
