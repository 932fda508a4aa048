/* SPDX-License-Identifier: MIT */
/* corgen series prints the coefficients of x_max, t_max and eps in proved digits. */
#include <stdlib.h>

#include "cli/commands.h"
#include "series/restitution.h"
#include "support/console.h"
#include "support/digits.h"
#include "support/local.h"

enum { MAX_ORDER = 100000 };

/* Adds the coefficients as rows, up to the first one whose digits are undecided. */
static int fill_series(struct table *table, char undecided[PROVED_TABLE_NAME], const void *arguments, slong bits)
{
    const struct series_arguments *const o = arguments;
    const struct cor_exponents *const law = &o->law.exponents;
    const bool force = o->end == COR_END_ZERO_FORCE;
    char header[64];
    slong root = 1;
    LOCAL(series, s);
    LOCAL(arb_poly, eps);
    LOCAL(arb, c);
    profile_step("series");
    const int status = force ? series_eps(eps, &root, COR_END_ZERO_FORCE, o->order, law, bits)
                             : series_compute(s, o->order, law, bits);
    snprintf(header, sizeof header,
             !force      ? "k,y_k,tau_k,C_k"
             : root == 1 ? "power_of_beta,coefficient"
             : root == 2 ? "power_of_sqrt_beta,coefficient"
                         : "power_of_beta_root_%ld,coefficient",
             (long)root);
    table_init(table, header, force ? "nd" : "nddd");
    const arb_poly_struct *const poly[] = {force ? eps : s->y, s->tau, s->c};
    profile_step("digits");
    for (slong k = 0; k <= o->order && status == STATUS_OK && !*undecided; k++) {
        table_add_integer(table, k);
        for (int i = 0; i < (force ? 1 : 3) && !*undecided; i++) {
            arb_poly_get_coeff_arb(c, poly[i], k);
            char *const text = digits_of_ball(c, o->digits);
            if (text)
                table_add(table, text);
            else
                snprintf(undecided, PROVED_TABLE_NAME, "coefficient %ld", (long)k);
        }
    }
    return status;
}

/* Fills in the coefficients of G and T (docs/theory.md, 5), exact rational numbers: every digit is decided. */
static int fill_exact(struct table *table, char undecided[PROVED_TABLE_NAME], const void *arguments, slong bits)
{
    (void)undecided;
    (void)bits;
    const struct series_arguments *const o = arguments;
    LOCAL(fmpq, c);
    LOCAL(fmpq_poly, g, t);
    const fmpq_poly_struct *const f[] = {g, t};
    table_init(table, "power_of_w,G,T", "ntt"); /* fractions */
    profile_step("exact rationals");
    restitution_zero_force_exact(g, t, o->order, &o->law.exponents);
    for (slong k = 0; k <= o->order; k++) {
        table_add_integer(table, k);
        for (int i = 0; i < 2; i++) {
            fmpq_poly_get_coeff_fmpq(c, f[i], k);
            char *text = fmpq_get_str(NULL, 10, c);
            table_add_text(table, text);
            flint_free(text);
        }
    }
    return STATUS_OK;
}

static int run_series(const void *arguments)
{
    const struct series_arguments *const o = arguments;
    if (o->exact && o->end != COR_END_ZERO_FORCE)
        return usage_error("--exact needs --end zero-force, because the coefficients at zero overlap are irrational");
    const struct proved_table table = {o->digits, o, o->exact ? fill_exact : fill_series, NULL};
    return proved_table_write(&table, &o->common);
}

static const char help[] =
    "Usage: corgen series --order K [OPTION]...\n\n"
    "Prints x_max = sum y_k beta^k, t_max = sum tau_k beta^k and eps = sum C_k beta^k. With\n"
    "--end zero-force, prints eps in powers of sqrt(beta) up to the power K.\n\n"
    "  --order K        highest power of beta, 0 to 100000\n" HELP_DIGITS HELP_END
    "  --exact          print the rational coefficients of G and T in powers of w, with --end zero-force:\n"
    "                   eps_zero_force = eps_zero_overlap G(w), w = h^(5/2), h = beta eps^(1/5);\n"
    "                   the force vanishes earlier than the overlap by the time h T(w), in the same units\n"
    "  --format F       output format, text, csv or json (default text)\n" HELP_JSON_STRINGS HELP_LAW HELP_COMMON "\n"
    "Columns: k,y_k,tau_k,C_k; with --end zero-force power_of_sqrt_beta,coefficient\n"
    "(or power_of_beta, or power_of_beta_root_R for powers of beta^(1/R), by the law);\n"
    "with --exact power_of_w,G,T.\n\n"
    "Example: corgen series --order 5 --digits 30\n";

#define ARGUMENTS struct series_arguments
static const struct option_rule options[] = {
    OPTION("order", WHOLE, order, .range.whole = {0, MAX_ORDER},
           .why = "the time grows faster than the cube of the order", .required = true),
    OPTION_DIGITS,
    OPTION_END(end),
    OPTION("exact", FLAG, exact, .excludes = "digits"),
    OPTION_FORMAT(option_formats),
    OPTION_JSON_STRINGS,
    OPTION_LAW,
    OPTION_COMMON,
};

SUBCOMMAND(series, "series", "coefficients of x_max, t_max and eps in powers of beta",
           .digits = OPTIONS_DEFAULT_DIGITS);
