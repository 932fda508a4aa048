/* SPDX-License-Identifier: MIT */
/* corgen pade prints the coefficients and the analysis, and writes a C header on request. */
#include <stdlib.h>
#include <string.h>

#include "approximation/pade.h"
#include "cli/commands.h"
#include "support/console.h"
#include "support/digits.h"
#include "support/local.h"

enum {
    HEADER_BITS = 256,                /* precision of every coefficient that is rounded to double */
    HEADER_BETA_MAX_TWO_POINT = 1000, /* the bounds in the header hold up to this beta */
    HEADER_BETA_MAX = PADE_NEAR,
    HEADER_EVEN = 64, /* numbers of sample points, see references_init */
    HEADER_SMALL = 4,
    TEXT_MAX = 128,
    PUBLISHED_NUMERATOR = 1,
    PUBLISHED_DENOMINATOR = 4,
    MAX_DEGREE = 2000
};

struct problem {
    const struct pade_arguments *given;
    struct pade_request request;
    struct pade *f;
    struct pade_analysis *analysis;
};

static const char *header_title(const struct pade_request *r, slong root)
{
    if (r->kind == PADE_AS_PUBLISHED)
        return "Table I of the paper of 1999, from its printed a_k: wrong from the third order on";
    if (r->kind == PADE_TWO_POINT)
        return "eps at zero overlap, z = beta, series at 0 and tail at infinity";
    if (r->end == COR_END_ZERO_OVERLAP)
        return "eps at zero overlap, z = beta";
    return root == 2 ? "eps at zero force, z = sqrt(beta)" : "eps at zero force, z a root of beta";
}

static int write_header(const struct problem *problem)
{
    const struct pade_arguments *const o = problem->given;
    const struct pade_request *const r = &problem->request;
    const struct pade *const f = problem->f;
    const struct cor_exponents *const law = &r->law;
    const long A = (long)law_elastic(law).num, a_den = (long)law_elastic(law).den, B = (long)law_damping(law).num,
               b_den = (long)law_damping(law).den;
    const bool sphere = law_is_sphere(law), two_point = r->kind == PADE_TWO_POINT,
               printed = r->kind == PADE_AS_PUBLISHED;
    const slong beta_max = two_point ? HEADER_BETA_MAX_TWO_POINT : HEADER_BETA_MAX;
    char exponents[TEXT_MAX] = "sphere", options[TEXT_MAX] = "", z[32] = "";
    struct references references;
    /* the reference values are eps as a function of the sphere's beta; published coefficients have another variable */
    const bool assessed = sphere && !printed;
    if (assessed && references_init(&references, law, beta_max, HEADER_EVEN, HEADER_SMALL))
        return STATUS_FAILED;
    if (!sphere) {
        snprintf(exponents, sizeof exponents, "law_%ld_%ld_%ld_%ld", A, a_den, B, b_den);
        snprintf(options, sizeof options, " --elastic %ld/%ld --damping %ld/%ld", A, a_den, B, b_den);
    }
    if (f->root > 1)
        snprintf(z, sizeof z, "^(1/%ld)", (long)f->root);
    char *const name = xprintf("cor_%s_pade%s_%s_%ld_%ld", exponents,
                               two_point ? "_two_point"
                               : printed ? "_as_published"
                                         : "",
                               contact_end_names[r->end], (long)r->numerator, (long)r->denominator);
    char *const guard = xprintf("%s_h", name);
    char *const banner =
        xprintf("Restitution coefficient of x'' + beta x^(%ld/%ld) x' + x^(%ld/%ld) = 0:\n"
                "    eps = P(z)/Q(z),    1 - eps = %s L(z)/Q(z),    z = %s%s%s.\n"
                "Arrays hold ascending powers of z; q[0] = 1. Source: docs/theory.md, 7.\n"
                "\n"
                "Written by:  corgen pade --numerator %ld --denominator %ld --end %s%s%s%s%s --header FILE\n"
                "Checked by:  the same command, whose output is the same to the byte\n"
                "\n"
                "Each double is the one nearest to the exact coefficient in its comment: "
                "proved.\n",
                B, b_den, A, a_den, f->variable, f->variable, z, printed ? " = (g/g*)^(1/5)" : "", (long)r->numerator,
                (long)r->denominator, contact_end_options[r->end], options, two_point ? " --two-point" : "",
                printed ? " --as-published" : "", o->force ? " --force" : "");
    struct output out;
    int status = output_open(&out, o->header);
    if (status == STATUS_OK) {
        const struct pade_header header = {.name = name,
                                           .title = header_title(r, f->root),
                                           .end = r->end,
                                           .beta_max = beta_max,
                                           .references = assessed ? &references : NULL};
        struct emit e;
        emit_open(&e, out.file, guard, banner);
        emit_lines(&e, "#include <math.h>\n");
        status = pade_emit(&e, &header, f, problem->analysis);
        emit_close(&e);
        status = output_finish(&out, status);
    }
    free(banner);
    free(guard);
    free(name);
    if (assessed)
        references_clear(&references);
    return status;
}

static void print_text(FILE *file, const struct table *table, const void *arguments)
{
    const struct problem *const problem = arguments;
    const struct pade *const f = problem->f;
    fprintf(file, "[%ld/%ld]: %s\n\n", (long)f->numerator, (long)f->denominator,
            header_title(&problem->request, f->root));
    table_print(table, FORMAT_TEXT, file);
    fprintf(file, "\n");
    pade_print_analysis(file, problem->analysis, "");
    if (problem->request.kind != PADE_AS_PUBLISHED)
        return;
    fprintf(file, "\nTable I prints     from the printed a_k\n");
    for (int k = 1; k <= 5; k++) {
        arb_srcptr x = k == 1 ? arb_poly_get_coeff_ptr(f->p, 1) : arb_poly_get_coeff_ptr(f->q, k - 1);
        char *text = digits_of_ball(x, 5);
        fprintf(file, "d_%d = %-12s  %-7s (%s of x^%d)\n", k, published_d[k - 1], text ? text : "?",
                k == 1 ? "numerator" : "denominator", k == 1 ? 1 : k - 1);
        free(text);
    }
    fprintf(
        file,
        "d_0 is close to zero, so a_3 and a_4, rounded to six decimals, give d_1, d_2 and d_3 only to about 2e-4.\n"
        "x = (g/g*)^(1/5). The values of C_3 and C_4 used here are wrong; corgen series prints the correct ones.\n");
}

/* Adds the coefficients as rows, up to the first one whose digits are undecided. */
static void add_polynomial(struct table *t, char undecided[PROVED_TABLE_NAME], const char *name, const arb_poly_t p,
                           slong degree, slong digits)
{
    LOCAL(arb, x);
    for (slong i = 0; i <= degree && !*undecided; i++) {
        arb_poly_get_coeff_arb(x, p, i);
        char *const text = digits_of_ball(x, digits);
        table_add_text(t, name);
        table_add_integer(t, (long)i);
        if (text)
            table_add(t, text);
        else
            snprintf(undecided, PROVED_TABLE_NAME, "coefficient %ld of the %s", (long)i, name);
    }
}

/* Fills the table. Once all digits are decided, also writes the header. */
static int fill_table(struct table *table, char undecided[PROVED_TABLE_NAME], const void *arguments, slong bits)
{
    const struct problem *const problem = arguments;
    const struct pade_arguments *const o = problem->given;
    const struct pade *const f = problem->f;
    profile_step("Padé");
    const int status =
        pade_compute(problem->f, problem->analysis, &problem->request, o->header ? FLINT_MAX(bits, HEADER_BITS) : bits);
    if (status != STATUS_OK)
        return status;
    table_init(table, "polynomial,power,coefficient", "tnd");
    add_polynomial(table, undecided, "numerator", f->p, f->numerator, o->digits);
    add_polynomial(table, undecided, "denominator", f->q, f->denominator, o->digits);
    if (!o->header || *undecided)
        return STATUS_OK;
    char *const defects = pade_defects(problem->analysis);
    const bool refused = defects && !o->force;
    if (refused)
        fail("--header: the Padé approximant has %s; give other degrees, or --force to write the header", defects);
    free(defects);
    return refused ? STATUS_FAILED : write_header(problem);
}

static int run_pade(const void *arguments)
{
    const struct pade_arguments *const o = arguments;
    LOCAL(pade, f);
    LOCAL(pade_analysis, a);
    struct problem problem = {.given = o, .request = o->request, .f = f, .analysis = a};
    struct pade_request *const r = &problem.request;
    r->kind = o->as_published ? PADE_AS_PUBLISHED : o->two_point ? PADE_TWO_POINT : PADE_ORDINARY;
    r->law = o->law.exponents;
    if (o->as_published && !law_is_sphere(&r->law))
        return usage_error("--as-published needs the law of viscoelastic spheres; leave out --elastic and --damping");
    if (o->as_published && r->end != COR_END_ZERO_OVERLAP)
        return usage_error("--as-published needs --end zero-overlap, the end of contact in the paper");
    if (o->as_published && r->numerator <= 0 && r->denominator <= 0) { /* not given */
        r->numerator = PUBLISHED_NUMERATOR;
        r->denominator = PUBLISHED_DENOMINATOR;
    }
    if (r->numerator < 0 || r->denominator < 0)
        return usage_error(
            "corgen pade needs --numerator and --denominator, for example --numerator 4 --denominator 7");
    const char *const why = pade_refusal(r);
    const struct proved_table table = {o->digits, &problem, fill_table, print_text};
    return why ? usage_error("%s", why) : proved_table_write(&table, &o->common);
}

static const char help[] =
    "Usage: corgen pade --numerator M --denominator N [OPTION]...\n\n"
    "Prints the coefficients of the [M/N] Pade approximant of eps, in powers of beta at zero overlap\n"
    "and of sqrt(beta) at zero force.\n\n"
    "  --numerator M    degree of the numerator, 0 to 2000\n"
    "  --denominator N  degree of the denominator, 0 to 2000\n"
    "  --two-point      also match the limit of large beta; needs zero overlap and N = M + 5\n"
    "  --as-published   reproduce the published [1/4] from its printed coefficients\n" HELP_DIGITS HELP_END
    "  --header FILE    also write C functions of eps and 1 - eps, with their errors up to beta = 2\n"
    "                   (two-point: 1000), unless the approximant has a pole or a zero at beta > 0\n"
    "  --force          write the header also if the approximant has a pole or a zero at beta > 0\n"
    "  --format F       text (default), csv or json\n" HELP_JSON_STRINGS HELP_LAW HELP_COMMON "\n"
    "Example: corgen pade --numerator 4 --denominator 7 --digits 20\n";

#define ARGUMENTS struct pade_arguments
static const struct option_rule options[] = {
    OPTION("numerator", WHOLE, request.numerator, .range.whole = {0, MAX_DEGREE},
           .why = "larger linear systems take too long"),
    OPTION("denominator", WHOLE, request.denominator, .range.whole = {0, MAX_DEGREE},
           .why = "larger linear systems take too long"),
    OPTION("two-point", FLAG, two_point, .excludes = "as-published"),
    OPTION_PLAIN("as-published", FLAG, as_published),
    OPTION_DIGITS,
    OPTION_END(request.end),
    OPTION_PLAIN("header", FILE, header),
    OPTION("force", FLAG, force, .needs = "header"),
    OPTION_FORMAT(option_formats),
    OPTION_JSON_STRINGS,
    OPTION_LAW,
    OPTION_COMMON,
};

SUBCOMMAND(pade, "pade", "Pade approximants of eps(beta)", .request.numerator = OPTIONS_NOT_GIVEN,
           .request.denominator = OPTIONS_NOT_GIVEN, .digits = OPTIONS_DEFAULT_DIGITS);
