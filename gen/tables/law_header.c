/* SPDX-License-Identifier: MIT */
#include "tables/files.h"

#include <math.h>
#include <stdlib.h>

#include "approximation/law_layout.h"
#include "series/series.h"
#include "support/console.h"
#include "support/local.h"

enum { TEXT_MAX = LAW_TABLE_NAME_MAX };

static const char *const quantity_stem[QUANTITIES] = {"eps_zero_overlap",    "eps_zero_force", "duration_zero_overlap",
                                                      "duration_zero_force", "max_overlap",    "time_of_max_overlap"};

static int emit_far(struct emit *e, const struct law_tables *t, const char *name)
{
    int status = STATUS_OK;
    char text[TEXT_MAX];
    emit_comment(
        e, "Beyond the rows in ln(beta), columns a_0, a_0', a_1, a_1', a_2, ..., a_8: a power of beta times\n"
           "a_0 + a_0' + (a_1 + a_1') u + mu (a_2 + a_3 u + a_4 u^2) + mu^2 (a_5 + ... + a_8 u^3), u = ln(beta),\n"
           "fitted to enclosed collisions. For eps at zero overlap: v_f as two doubles, proved.");
    for (int i = 0; i < QUANTITIES && status == STATUS_OK; i++) {
        const enum quantity q = (enum quantity)i;
        if (!law_tables_have_far(t, q))
            continue;
        snprintf(text, sizeof text, "cor_rows_%s_far_%s", name, quantity_stem[q]);
        status = law_tables_emit_far(e, t, q, text);
        if (status == STATUS_OK && law_tables_have_fall(t, q)) {
            snprintf(text, sizeof text, "cor_rows_%s_fall_%s", name, quantity_stem[q]);
            status = law_tables_emit_fall(e, t, text);
        }
    }
    return status;
}

/* ---- the evaluators ---- */

static void emit_table_field(struct emit *e, const char *field, const struct pieces *p)
{
    const char *const rows = p->name;
    if (p->variable >= VARIABLE_POWER_OCTAVES)
        emit_lines(e, "    x.$s = cor_inline_law_octaves($s, COR_INLINE_OCTAVES($S), $S_END);\n", field, rows, rows,
                   rows);
    else
        emit_lines(e, "    x.$s = cor_inline_law_grid($s, COR_INLINE_GRID($S), $d, $S_END);\n", field, rows, rows,
                   (int)p->root, rows);
}

static void emit_power_field(struct emit *e, const char *field, struct ratio power)
{
    emit_lines(e, "    x.$s.num = $d;\n    x.$s.den = $d;\n", field, (int)power.num, field, (int)power.den);
}

static void emit_far_fields(struct emit *e, const struct law_tables *t, const char *name, enum quantity quantity)
{
    const struct cor_exponents *law = &t->layout.interpolant.law;
    const struct ratio power = interpolant_tail_power(law, quantity);
    const bool fall = law_tables_have_fall(t, quantity);
    emit_lines(e, "    x.far = cor_rows_$s_far_$s;\n    x.far_kind = $d;\n", name, quantity_stem[quantity],
               quantity == EPS_ZERO_OVERLAP ? 2 : 1);
    emit_power_field(e, "power", power);
    emit_power_field(e, "far_power", fall ? RATIO("law->a/(law->b + 1)", law) : power);
    emit_power_field(e, "mu", law_mu_power(law));
    if (fall) {
        emit_lines(e, "    x.fall = cor_rows_$s_fall_$s;\n    x.has_fall = 1;\n", name, quantity_stem[quantity]);
        emit_power_field(e, "fall_power", RATIO("(law->a - 1)/(2*law->b - law->a + 1)", law));
    }
    if (quantity == DURATION_ZERO_OVERLAP)
        emit_lines(e, "    x.infinite = cor_inline_infinity();\n");
}

static int emit_threshold_fields(struct emit *e, const struct law_tables *t, enum quantity quantity)
{
    const struct cor_exponents *law = &t->layout.interpolant.law;
    int status = emit_pair_field(e, "threshold", t->f->threshold);
    if (quantity == DURATION_ZERO_OVERLAP)
        emit_lines(e, "    x.beyond = cor_inline_infinity();\n");
    if (law_is_linear(law) && status == STATUS_OK) {
        LOCAL(arb, critical);
        LET(critical, 128, "2*(law->a + 1)", law);
        status = emit_pair_field(e, "critical", critical);
        emit_lines(e, "    x.linear = 1;\n");
        emit_power_field(e, "fading", RATIO("(law->a - 1)/(law->a + 1)", law));
    }
    return status;
}

/* Emits a quantity of beta, or the inverse of eps. */
static int emit_quantity(struct emit *e, const struct law_tables *t, const char *name, enum quantity quantity,
                         bool inverse)
{
    static const char *const field[] = {"near", "middle", "tail", "below", "near", "rows"};
    const char *const kind = inverse ? "inverse" : "quantity";
    int status = STATUS_OK;
    emit_lines(e,
               "\nCOR_KERNEL struct cor_inline_law_$s cor_law_$s_$s$s(void)\n{\n"
               "    struct cor_inline_law_$s x = cor_inline_law_$s_of();\n",
               kind, name, inverse ? "inverse_" : "", quantity_stem[quantity], kind, kind);
    for (int i = 0; i < t->layout.tables; i++) {
        const struct law_table *const table = &t->layout.table[i];
        if (table->serves == quantity && (table->part > PART_BELOW) == inverse)
            emit_table_field(e, field[table->part], &table->rows);
    }
    if (!inverse && law_tables_have_far(t, quantity))
        emit_far_fields(e, t, name, quantity);
    if (!inverse && is_of_overlap(quantity) && t->layout.threshold < HUGE_VAL)
        status = emit_threshold_fields(e, t, quantity);
    emit_lines(e, "    return x;\n}\n");
    return status;
}

/* Writes the public functions PREFIX_eps_zero_overlap, ... */
static void emit_functions(struct emit *e, const struct law_tables *t, const char *name, const char *prefix)
{
    /* Functions for each end. value: a text for emit_lines; each pair of $s is the law's name and the end */
    static const struct {
        const char *name, *argument, *value;
    } functions[] = {
        {"eps", "beta", "cor_inline_law_eps(cor_law_$s_eps_$s(), beta)"},
        {"loss", "beta", "cor_inline_law_loss(cor_law_$s_eps_$s(), beta)"},
        {"beta", "eps", "cor_inline_law_beta(cor_law_$s_eps_$s(), cor_law_$s_inverse_eps_$s(), eps)"},
        {"beta_of_loss", "loss", "cor_inline_law_beta_of_loss(cor_law_$s_eps_$s(), cor_law_$s_inverse_eps_$s(), loss)"},
        {"duration", "beta", "cor_inline_law_value(cor_law_$s_duration_$s(), beta)"}};
    const bool both = law_force_ends(&t->layout.interpolant.law);
    for (int end = 0; end < 2; end++)
        for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
            /* both ends coincide if the force is never attractive */
            const char *const source = contact_end_names[both ? end : COR_END_ZERO_OVERLAP];
            emit_lines(e, "\nCOR_INLINE double $s_$s_$s(double $s)\n{\n    return ", prefix, functions[i].name,
                       contact_end_names[end], functions[i].argument);
            emit_lines(e, functions[i].value, name, source, name, source);
            emit_lines(e, ";\n}\n");
        }
    for (int q = MAX_OVERLAP; q <= TIME_OF_MAX_OVERLAP; q++)
        emit_lines(e,
                   "\nCOR_INLINE double $s_$s(double beta)\n{\n"
                   "    return cor_inline_law_value(cor_law_$s_$s(), beta);\n}\n",
                   prefix, quantity_stem[q], name, quantity_stem[q]);
}

static int emit_law(struct emit *e, const struct law_tables *t, const char *name, const char *prefix)
{
    const bool both = law_force_ends(&t->layout.interpolant.law);
    emit_comment(e, "A row: value = c_0 + (c_0' + t (c_1 + c_2 t + ... + c_n t^(n-1))), t = y - node, in columns c_0,\n"
                    "c_0', c_1, ..., c_n. c_0' is the remainder of c_0 at the node.");
    int status = law_tables_emit(e, t, false);
    if (status == STATUS_OK)
        status = emit_far(e, t, name);
    emit_comment(e, "Data of each quantity for runtime/table/law.h");
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++) {
        if (!both && is_of_force((enum quantity)q))
            continue;
        status = emit_quantity(e, t, name, (enum quantity)q, false);
        if (is_eps((enum quantity)q))
            emit_quantity(e, t, name, (enum quantity)q, true);
    }
    emit_functions(e, t, name, prefix);
    return status;
}

/* ---- files ---- */

static const char accuracy_text[] =
    "eps, loss and largest overlap are within 1 unit of the last place, times and inverse within 2: sampled against\n"
    "enclosed collisions (tests/law/run, tests/table). The rows approximate interpolants through\n"
    "collisions enclosed to 80 bits (proved). Between these collisions the error of the interpolants is at most\n"
    "%.1e (sampled). Errors of the rows are above each table (sampled).\n";

/* Without this attribute gcc 12 at -O2 copies the law's constants in each function and is five times slower. */
static const char always_inline[] =
    "/* Where a compiler leaves a call between these functions, it copies the law's constants for each result. */\n"
    "#if !defined(COR_INLINE) && defined(__GNUC__) && !defined(__CUDACC__) && !defined(__HIPCC__)\n"
    "#include <math.h>\n"
    "#include <stdint.h>\n"
    "#include <string.h>\n"
    "#define COR_INLINE static inline __attribute__((always_inline))\n"
    "#endif\n";

static void write_embedded(FILE *file, struct emit *e, const struct law_tables *t, const char *name,
                           const char *accuracy)
{
    const struct cor_exponents *const law = &t->layout.interpolant.law;
    char guard[TEXT_MAX], threshold[TEXT_MAX] = "beta = +inf -> eps 0; eps = 0 -> beta +inf.\n";
    if (t->layout.threshold < HUGE_VAL)
        snprintf(threshold, TEXT_MAX,
                 "At zero overlap eps is 0 and the duration infinite for beta_c = %.17g and above.\n"
                 "The inverse returns beta_c for eps = 0, and for eps below the smallest eps of a double.\n",
                 t->layout.threshold);
    snprintf(guard, sizeof guard, "COR_LAW_%s_EMBEDDED_H", name);
    char *const banner =
        xprintf("%s: restitution coefficient, duration and largest overlap of collisions\n"
                "%s, x(0) = 0, x'(0) = 1,\n"
                "both ends of contact, for every beta, as one header to embed.\n"
                "C99, C++11, CUDA and HIP. Needs sqrt, cbrt, pow, exp, expm1, log and log1p of math.h, memcpy, IEEE "
                "doubles.\n"
                "\n"
                "    double %s_eps_zero_overlap(double beta);      also _zero_force; restitution coefficient\n"
                "    double %s_loss_zero_overlap(double beta);     also _zero_force; 1 - eps, relative accuracy\n"
                "    double %s_beta_zero_overlap(double eps);      also _zero_force; the inverse\n"
                "    double %s_beta_of_loss_zero_overlap(double loss);   the same from 1 - eps\n"
                "    double %s_duration_zero_overlap(double beta); also _zero_force\n"
                "    double %s_max_overlap(double beta);\n"
                "    double %s_time_of_max_overlap(double beta);\n"
                "\n"
                "Force K x^a + C x^b x', effective mass m, impact speed g: times are in units of\n"
                "T = (m/K)^(1/(a+1)) g^((1-a)/(a+1)), lengths in units of g T, and beta = (C/m) g^b T^(b+1).\n"
                "Zero overlap ends the contact when x = 0 again, zero force when x'' = 0%s.\n"
                "%s"
                "Negative or NaN -> NaN.\n"
                "\n%s"
                "\n"
                "Written by:  corgen law --elastic %s --damping %s --name %s\n"
                "Checked by:  the same command, whose output is the same to the byte\n",
                name, law_equation(law).text, name, name, name, name, name, name, name,
                law_force_ends(law) ? "" : "; they coincide in this law", threshold, accuracy,
                ratio_text(law_elastic(law)).text, ratio_text(law_damping(law)).text, name);
    emit_open(e, file, guard, banner);
    e->decimal = true;
    fprintf(file, "\n%s\n%s\n%s\n%s\n%s\n%s", always_inline, evaluator_inline, evaluator_pair, evaluator_elementary,
            evaluator_row, evaluator_law);
    free(banner);
}

static void write_included(FILE *file, struct emit *e, const struct law_tables *t, const char *accuracy)
{
    char *const what =
        xprintf("Hertz's contact with a constant dashpot, %s, x(0) = 0, x'(0) = 1,\n"
                "both ends of contact, for every beta. Evaluated by runtime/table/law.h. Source: docs/theory.md, 9;\n"
                "form: docs/internals.md.\n",
                law_equation(&t->layout.interpolant.law).text);
    char *const how =
        xprintf("Each double is the one nearest to its coefficient: proved; corgen tables --digits prints "
                "25 digits of\neach. In the functions\n%s",
                accuracy);
    emit_open_tables(e, file, "hertz_dashpot", what, how, "\n#include \"runtime/table/law.h\"\n" EMIT_INCLUDE_ROWS);
    free(what);
    free(how);
}

/* prefix: prefix of the library's functions; NULL: an embedded header */
static int write_law(FILE *file, const struct cor_exponents *law, const char *name, const char *prefix)
{
    struct law_tables t = {.f = NULL};
    struct emit e;
    char rows[TEXT_MAX], accuracy[512];
    snprintf(rows, sizeof rows, "cor_rows_%s", name);
    int status = law_layout_init(&t.layout, law);
    if (status == STATUS_OK)
        status = law_tables_make(&t, rows);
    if (status == STATUS_OK) {
        snprintf(accuracy, sizeof accuracy, accuracy_text, t.error);
        if (prefix)
            write_included(file, &e, &t, accuracy);
        else
            write_embedded(file, &e, &t, name, accuracy);
        status = emit_law(&e, &t, name, prefix ? prefix : name);
        if (status == STATUS_OK && prefix)
            status = law_tables_emit_approach(&e, &t, rows);
        emit_close(&e);
    }
    law_tables_clear(&t);
    return status;
}

int law_header_write(FILE *file, const struct cor_exponents *law, const char *name)
{
    return write_law(file, law, name, NULL);
}

int hertz_dashpot_tables_write(FILE *file)
{
    struct cor_exponents law;
    law_parse(&law, "3/2", "0");
    return write_law(file, &law, "hertz_dashpot", "cor_inline_hertz_dashpot");
}
