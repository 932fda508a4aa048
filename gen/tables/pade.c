/* SPDX-License-Identifier: MIT */
#include "tables/files.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/local.h"

enum { NAME_MAX_LENGTH = 128 };

/* Emits a function NAME_WHAT of the variable: factor P(z)/Q(z) by Horner's rule. P is the array NAME_p or NAME_l. */
static void emit_quotient(struct emit *e, const char *name, const char *what, const char *p, const struct pade *f,
                          const char *factor)
{
    const char *const z = f->root > 1 ? "z" : f->variable;
    emit_lines(e, "static inline double $s_$s(double $s)\n{\n", name, what, f->variable);
    if (f->root == 2)
        emit_lines(e, "    const double z = sqrt($s);\n", f->variable);
    else if (f->root > 2)
        emit_lines(e, "    const double z = pow($s, 1.0 / $d);\n", f->variable, (int)f->root);
    emit_lines(e,
               "    double above = 0;\n    for (int k = $S_$S; k-- > 0;)\n        above = above * $s + $s_$s[k];\n"
               "    double below = 0;\n    for (int k = $S_Q; k-- > 0;)\n        below = below * $s + $s_q[k];\n"
               "    return $s >= 0 ? $s$sabove / below : (double)NAN;\n}\n",
               name, p, z, name, p, name, z, name, f->variable, factor, *factor ? " * " : "");
}

static void emit_error(struct emit *e, const char *name, const char *what, double x)
{
    if (isfinite(x))
        emit_lines(e, "#define $S_$S $s\n", name, what, emit_bound(x).text);
}

static void print_error(FILE *text, const char *what, double error, const fmpq_t beta)
{
    char *place = fmpq_get_str(NULL, 10, beta);
    fprintf(text, "  %s %s, worst at beta = %s\n", what, emit_bound(error).text, place);
    flint_free(place);
}

/* Returns the comment above the arrays. */
static char *pade_comment(const struct pade_header *h, const struct pade *f, const struct pade_analysis *a,
                          const struct pade_error *approximation, double eps, double loss)
{
    char *text;
    size_t size;
    FILE *file = open_memstream(&text, &size);
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
    if (status != STATUS_OK)
        return status;
    pade_evaluation_error(&eps, &loss, &r, h->beta_max);
    if (h->references)
        pade_approximation_error(&approximation, &r, h->end, h->references);
    char *text = pade_comment(h, f, a, h->references ? &approximation : NULL, eps, loss);
    emit_comment(e, "%s", text);
    free(text);
    emit_lines(e, "enum {\n    $S_P = $d,\n    $S_Q = $d,\n    $S_L = $d\n};\n", h->name, (int)arb_poly_length(r.p),
               h->name, (int)arb_poly_length(r.q), h->name, (int)arb_poly_length(r.l));
    if (h->references) {
        emit_error(e, h->name, "eps_approximation_rel", approximation.eps);
        emit_error(e, h->name, "loss_approximation_rel", approximation.loss);
        emit_error(e, h->name, "eps_evaluation_rel", eps);
        emit_error(e, h->name, "loss_evaluation_rel", loss);
        emit_error(e, h->name, "eps_max_rel", approximation.eps + eps);
        emit_error(e, h->name, "loss_max_rel", approximation.loss + loss);
        emit_error(e, h->name, "beta_max", (double)h->beta_max);
    }
    const arb_poly_struct *const array[] = {r.p, r.q, r.l};
    for (int i = 0; i < 3 && status == STATUS_OK; i++) {
        char name[NAME_MAX_LENGTH];
        snprintf(name, sizeof name, "%s_%c", h->name, "pql"[i]);
        status = emit_doubles(e, name, array[i]->coeffs, array[i]->length);
    }
    if (status == 0) {
        emit_comment(e, "eps, and 1 - eps without cancellation near 0; NaN below 0%s",
                     f->root > 2 ? ". The rounding of pow is not part of the bounds." : "");
        emit_quotient(e, h->name, "eps", "p", f, "");
        emit_quotient(e, h->name, "loss", "l", f, f->variable);
    }
    return status;
}
