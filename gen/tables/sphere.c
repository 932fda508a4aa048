/* SPDX-License-Identifier: MIT */
#include "tables/files.h"

#include <math.h>

#include "approximation/law_layout.h"
#include "approximation/row_proof.h"
#include "support/console.h"
#include "support/digits.h"
#include "support/local.h"

/* The layout of the sphere's tables, one instance of law_layout.h. Only this file defines its geometry; macros of the
 * headers pass it to the evaluators (approximation/pieces.h). 57 bits limit the error of a row to a sixteenth of a unit
 * of the last place. Rows in x = beta^5 at zero overlap need fewer bits where eps falls steeply, because there the
 * rounding of x changes eps more. If a row is multiplied by beta, its c_0 has HEAD_BITS bits, so that its products with
 * the two parts of a split double are exact. */
enum { FORCE_PLAIN = 4 /* rows of eps at zero force, see pieces.h */, HEAD_BITS = 26 };
#define TABLE(name, words, of, ...)                                                                                    \
    {                                                                                                                  \
        .stem = name, .title = words, .rows = {.quantity = of, PROVED, __VA_ARGS__ }                                   \
    }
#define PROVED .root = 2, .degree = 10, .to_prove = true
#define ROWS(n) .rows = (n), .plain = (n)
#define IN_BETA(n) .variable = VARIABLE_BETA, .step = 0.125, ROWS(n)
#define IN_ROOT(n, plain_rows) .variable = VARIABLE_ROOT_BETA, .step = 0.0625, .rows = (n), .plain = (plain_rows)
#define IN_LOG(width, n) .variable = VARIABLE_LOG_BETA, .first = 2 + (width) / 2, .step = (width), .end = 10, ROWS(n)
#define IN_LOSS(of, width, n) .variable = (of), .step = (width), .end = 0.5, ROWS(n), .head_bits = HEAD_BITS
#define BY_OCTAVES(of, from, to)                                                                                       \
    .variable = (of), .first = (from), .octave_bits = PIECES_OCTAVE_BITS, ROWS(((to) - (from) + 1) * PIECES_PER_OCTAVE)
/* Floats: 27 bits limit the approximation to an eighth of a unit of the last place. In a row that is multiplied by
 * beta, c_0 has 19 bits, so that its product with the first 5 bits of beta is exact. */
#define FLOATS(name, words, of, from, to, bits, head)                                                                  \
    {                                                                                                                  \
        .stem = "float_" name, .title = words, .rows = {                                                               \
            .quantity = of,                                                                                            \
            .variable = VARIABLE_BETA,                                                                                 \
            .floats = true,                                                                                            \
            .first = (from),                                                                                           \
            .end = 1 << (to),                                                                                          \
            .octave_bits = (bits),                                                                                     \
            ROWS(1 + (((to) - (from)) << (bits))),                                                                     \
            .least_bits = 27,                                                                                          \
            .head_bits = (head)                                                                                        \
        }                                                                                                              \
    }
static const struct law_table layout_tables[] = {
    TABLE("eps_zero_overlap", "eps at zero overlap", EPS_ZERO_OVERLAP, IN_BETA(57), .end = 7, .least_bits = 55.5),
    TABLE("eps_zero_force", "eps at zero force", EPS_ZERO_FORCE, IN_ROOT(65, FORCE_PLAIN), .end = 16,
          .least_bits = 55.5),
    TABLE("power_eps_zero_overlap", "eps at zero overlap", EPS_ZERO_OVERLAP,
          BY_OCTAVES(VARIABLE_POWER_OCTAVES, -40, 13), .end = 16384, .least_bits = 53.5),
    TABLE("power_eps_zero_force", "eps at zero force", EPS_ZERO_FORCE, BY_OCTAVES(VARIABLE_POWER_OCTAVES, -40, 19),
          .end = 1048576, .least_bits = 57),
    TABLE("loss_zero_overlap", "(1 - eps)/beta at zero overlap", LOSS_QUOTIENT_ZERO_OVERLAP, IN_BETA(57), .end = 7,
          .least_bits = 57, .head_bits = HEAD_BITS),
    TABLE("loss_zero_force", "(1 - eps)/beta at zero force", LOSS_QUOTIENT_ZERO_FORCE, IN_ROOT(65, FORCE_PLAIN),
          .end = 16, .least_bits = 57, .head_bits = HEAD_BITS),
    TABLE("duration_zero_overlap", "duration at zero overlap", DURATION_ZERO_OVERLAP, IN_BETA(65), .end = 8,
          .least_bits = 56),
    TABLE("duration_zero_force", "duration at zero force", DURATION_ZERO_FORCE, IN_ROOT(46, 46), .end = 8,
          .least_bits = 56),
    TABLE("max_overlap", "largest overlap", MAX_OVERLAP, IN_BETA(65), .end = 8, .least_bits = 57),
    TABLE("time_of_max_overlap", "time of the largest overlap", TIME_OF_MAX_OVERLAP, IN_BETA(65), .end = 8,
          .least_bits = 56),
    TABLE("tail_eps_zero_force", "eps times beta^(5/3), at zero force", EPS_ZERO_FORCE, IN_LOG(0.25, 32),
          .least_bits = 57),
    TABLE("tail_duration_zero_overlap", "duration/beta at zero overlap", DURATION_ZERO_OVERLAP, IN_LOG(0.125, 64),
          .least_bits = 56),
    TABLE("tail_duration_zero_force", "duration times beta^(2/3), at zero force", DURATION_ZERO_FORCE, IN_LOG(0.25, 32),
          .least_bits = 56),
    TABLE("tail_max_overlap", "largest overlap times beta^(2/3)", MAX_OVERLAP, IN_LOG(0.25, 32), .least_bits = 57),
    TABLE("tail_time_of_max_overlap", "time of the largest overlap, times beta^(2/3)", TIME_OF_MAX_OVERLAP,
          IN_LOG(0.25, 32), .least_bits = 56),
    TABLE("near_beta_zero_overlap", "beta/(1 - eps) at zero overlap", BETA_QUOTIENT_ZERO_OVERLAP,
          IN_LOSS(VARIABLE_LOSS, 0.0625, 9), .least_bits = 56),
    TABLE("near_beta_zero_force", "beta/(1 - eps) at zero force", BETA_QUOTIENT_ZERO_FORCE,
          IN_LOSS(VARIABLE_ROOT_LOSS, 0.03125, 24), .least_bits = 56),
    TABLE("beta_zero_overlap", "beta at zero overlap", BETA_ZERO_OVERLAP, BY_OCTAVES(VARIABLE_EPS_OCTAVES, -12, -2),
          .end = 0.5, .least_bits = 55),
    TABLE("beta_zero_force", "beta at zero force", BETA_ZERO_FORCE, BY_OCTAVES(VARIABLE_EPS_OCTAVES, -23, -2),
          .end = 0.5, .least_bits = 55),
    FLOATS("eps_zero_overlap", "eps at zero overlap", EPS_ZERO_OVERLAP, -6, 3, 7, 0),
    FLOATS("eps_zero_force", "eps at zero force", EPS_ZERO_FORCE, -9, 4, 6, 0),
    FLOATS("loss_zero_overlap", "(1 - eps)/beta at zero overlap", LOSS_QUOTIENT_ZERO_OVERLAP, -6, 3, 6, 19),
    FLOATS("loss_zero_force", "(1 - eps)/beta at zero force", LOSS_QUOTIENT_ZERO_FORCE, -17, 4, 5, 19),
};
enum { TABLES = sizeof layout_tables / sizeof *layout_tables };

static const struct {
    enum quantity quantity;
    const char *name;
} far_tables[] = {
    {EPS_ZERO_FORCE, "cor_rows_far_eps_zero_force"},
    {DURATION_ZERO_OVERLAP, "cor_rows_far_duration_zero_overlap"},
    {DURATION_ZERO_FORCE, "cor_rows_far_duration_zero_force"},
    {MAX_OVERLAP, "cor_rows_far_max_overlap"},
    {TIME_OF_MAX_OVERLAP, "cor_rows_far_time_of_max_overlap"},
    {BETA_ZERO_FORCE, "cor_rows_far_beta_zero_force"}, /* the inverse of eps_zero_force */
};
enum { FAR_TABLES = sizeof far_tables / sizeof *far_tables };

/* Bits that the proofs of the formulas for large beta, and of their inverse, must reach */
#define FAR_BITS 64.5
#define INVERSE_BITS 55.5

static struct {
    bool made;
    struct law_tables tables;
    double far_bits, inverse_bits; /* proved bits of all formulas for large beta, and of the inverse */
} data;

/* Proves the formulas for large beta and the inverse of the formula for eps. */
static int prove_far(const struct law_tables *t, const struct interpolant_proof *rows)
{
    struct far_proof proof;
    double c[FAR_COLUMNS];
    LOCAL_VECTOR(row, FAR_COLUMNS);
    int status = far_proof_init(&proof, rows, INFINITY);
    data.far_bits = data.inverse_bits = INFINITY;
    for (int i = 0; i < FAR_TABLES && status == STATUS_OK; i++) {
        const enum quantity quantity = far_tables[i].quantity;
        const bool inverse = quantity == BETA_ZERO_FORCE;
        const slong columns = law_tables_far_row(row, t, quantity);
        for (slong k = 0; k < columns && status == STATUS_OK; k++)
            if (!digits_to_double(&c[k], row + k))
                status = fail("cannot round a coefficient for large beta: its enclosure is too wide");
        const double bits = status == STATUS_OK ? far_proof_bits(&proof, quantity, c) : 0;
        const double least = inverse ? INVERSE_BITS : FAR_BITS;
        double *const of_all = inverse ? &data.inverse_bits : &data.far_bits;
        *of_all = fmin(*of_all, bits);
        if (status == STATUS_OK && !(bits >= least))
            status = fail("%s: %.2f bits proved, %.1f required", far_tables[i].name, bits, least);
    }
    far_proof_clear(&proof);
    return status;
}

/* Proves the rows of every table and the formulas beyond them. */
static int prove_tables(struct law_tables *t)
{
    struct interpolant_proof *proof = interpolant_proof_new(t->f, SET_ALL, ELLIPSES_PROVED);
    int status = proof ? STATUS_OK : STATUS_FAILED;
    for (int i = 0; i < t->layout.tables && status == STATUS_OK; i++)
        if (t->layout.table[i].rows.to_prove)
            status = row_proof_table(&t->layout.table[i].rows, proof);
    if (status == STATUS_OK)
        status = prove_far(t, proof);
    interpolant_proof_free(proof);
    return status;
}

static int sphere_data_make(void)
{
    if (data.made)
        return STATUS_OK;
    law_layout_init_given(&data.tables.layout, &interpolant_sphere_proof, layout_tables, TABLES);
    int status = law_tables_make(&data.tables, "cor_rows");
    if (status == STATUS_OK)
        status = prove_tables(&data.tables);
    data.made = status == STATUS_OK;
    if (!data.made)
        law_tables_clear(&data.tables);
    return status;
}

void sphere_tables_clear(void)
{
    if (data.made)
        law_tables_clear(&data.tables);
    data.made = false;
}

/* Emits a comment with the proved relative error, rounded up. */
static void emit_far_comment(struct emit *e, const char *form, double bits)
{
    emit_comment(e, "%s\nRelative error, proved for every finite double: below 2^-%.1f.", form, floor(10 * bits) / 10);
}

static int emit_tables(struct emit *e)
{
    emit_comment(e, "A row: value = c_0 + (c_0' + s (c_1 + c_2 t + ... + c_n t^(n-1))), t = y - node, in columns c_0,\n"
                    "c_0', c_1, ..., c_n. s = t, except in the rows of eps and of the loss at zero force for\n"
                    "nodes of 1/4 and above, where s = beta - node^2. c_0' is the remainder of c_0 at the node.");
    if (law_tables_emit(e, &data.tables, false))
        return STATUS_FAILED;
    emit_comment(e, "h*^5 as two doubles: eps = h*^5 beta^-5 at zero overlap, exact in double precision for\n"
                    "beta >= 7. Proved.");
    if (law_tables_emit_far(e, &data.tables, EPS_ZERO_OVERLAP, "cor_rows_h_star_5"))
        return STATUS_FAILED;
    emit_far_comment(
        e,
        "u = ln(beta) >= 10: a_0 + a_0' + (a_1 + a_1') u + mu (a_2 + a_3 u + a_4 u^2) + mu^2 (a_5 + ... + a_8 u^3),\n"
        "mu = beta^(-5/3), through nine enclosed collisions with u = 9.5 ... 13.5.",
        data.far_bits);
    int status = STATUS_OK;
    for (int i = 0; i < FAR_TABLES && status == STATUS_OK; i++) {
        if (far_tables[i].quantity == BETA_ZERO_FORCE)
            emit_far_comment(
                e,
                "eps < 2^-23 at zero force: beta = (a/eps)^(3/5) (1 + e (b_0 + b_1 v + b_2 v^2) + e^2 (c_0 + ... +\n"
                "c_4 v^4)), e = eps/a, v = -(3/5) ln(e), from the coefficients of far_eps_zero_force by formal\n"
                "inversion. Columns a, a', b_0, ..., c_4.",
                data.inverse_bits);
        status = law_tables_emit_far(e, &data.tables, far_tables[i].quantity, far_tables[i].name);
    }
    return status == STATUS_OK ? law_tables_emit_approach(e, &data.tables, "cor_rows") : status;
}

static const char header_banner[] =
    "cor_sphere.h: restitution coefficient, duration and largest overlap of colliding viscoelastic spheres,\n"
    "x'' + beta sqrt(x) x' + x^(3/2) = 0, both ends of contact, for every beta, to embed with sphere_rows.h.\n"
    "C99, C++11, CUDA and HIP. Needs sqrt, cbrt, log and fabs of math.h, memcpy, IEEE doubles.\n"
    "\n"
    "    double cor_inline_eps_zero_overlap(double beta);            also _zero_force\n"
    "    double cor_inline_loss_zero_overlap(double beta);           1 - eps; also _zero_force\n"
    "    double cor_inline_duration_zero_overlap(double beta);       in units of (rho/m)^(-2/5) g^(-1/5);\n"
    "                                                                also _zero_force\n"
    "    double cor_inline_max_overlap(double beta);                 in units of (rho/m)^(-2/5) g^(4/5)\n"
    "    double cor_inline_time_of_max_overlap(double beta);         units as the duration\n"
    "    double cor_inline_beta_zero_overlap(double eps);            the inverse; also _zero_force\n"
    "    double cor_inline_eps_zero_overlap_root(double x);          at beta = x^(1/5), the fast way from an\n"
    "                                                                impact speed g: x = beta_per_root^5 g,\n"
    "                                                                beta_per_root = (3/2) A (rho/m)^(2/5);\n"
    "                                                                also _zero_force\n"
    "\n"
    "The same evaluator and tables as libcor, where domain, special values and accuracy are documented\n"
    "(include/cor/sphere.h): eps, loss and largest overlap within 1 unit of the last place, times and inverse\n"
    "within 2: proved for every double, if log is within 1 unit and cbrt within 64 (docs/theory.md, 8 and 18);\n"
    "eps at a speed within (2 + 2 kappa) 2^-53, kappa = |d ln eps/d ln beta|: proved for an x with two rounding\n"
    "errors (18). beta = 0 -> 1, +inf -> 0 (eps); negative or NaN -> NaN. Any flags are safe: no argument leads\n"
    "beyond a table, and -ffast-math and -march=native change a result by 4 units at most (sampled).\n"
    "Zero overlap ends the contact when x = 0 again, zero force when x'' = 0.\n"
    "\n"
    "Written by:  corgen tables\n"
    "Checked by:  corgen tables --check\n";

int sphere_header_write(FILE *file)
{
    struct emit e;
    emit_open(&e, file, "COR_SPHERE_EMBEDDED_H", header_banner);
    /* COR_ROWS differs from runtime/table/rows.h: each table is local to its function, for GPUs. */
    fprintf(file,
            "\n%s\n%s\n%s\n%s"
            "#define COR_ROWS(type, name, rows, columns) \\\n"
            "    COR_INLINE const type *name(int i) { static const type row[rows][columns]\n"
            "#define COR_ROWS_HERE\n"
            "#define COR_ROWS_FUNCTION(type, name) return row[i]; }\n"
            "#include \"sphere_rows.h\"\n"
            "#undef COR_ROWS\n#undef COR_ROWS_HERE\n#undef COR_ROWS_FUNCTION\n%s",
            evaluator_inline, evaluator_pair, evaluator_fifth_root, evaluator_row, evaluator_sphere);
    emit_close(&e);
    return STATUS_OK;
}

static const char rows_banner[] =
    "The rows of the sphere's tables, for libcor (runtime/sphere/eval.h, approach_only.c) and for cor_sphere.h,\n"
    "which defines COR_ROWS. Rows of short polynomials around the nodes of uniform grids, and the formulas at large\n"
    "beta. Each double is the one nearest to its coefficient: proved; corgen tables --digits prints 25 digits of\n"
    "each. Errors of the rows are above each table, and errors of the formulas for large beta above the formulas. All\n"
    "are proved for every argument (docs/theory.md, 8). The rows interpolate polynomials of high degree through "
    "collisions\n"
    "enclosed to 76 bits or more (proved). Source: docs/theory.md, 4 to 6 and 8; form: docs/internals.md.\n"
    "\n"
    "Written by:  corgen tables\n"
    "Checked by:  corgen tables --check\n";

int sphere_rows_write(FILE *file)
{
    if (sphere_data_make())
        return STATUS_FAILED;
    struct emit e;
    emit_open(&e, file, "COR_GENERATED_SPHERE_ROWS_H", rows_banner);
    e.decimal = true;
    e.shared = true;
    fputs("\n#ifndef COR_ROWS\n" EMIT_INCLUDE_ROWS "#endif\n", file);
    const int status = emit_tables(&e);
    emit_close(&e);
    return status;
}

static const char
    floats_of_sphere[] =
        "Collisions of viscoelastic spheres, x'' + beta sqrt(x) x' + x^(3/2) = 0, both ends of contact, for float\n"
        "arithmetic: rows of cubics by octaves of beta. Evaluated by runtime/table/float_lanes.h. Source:\n"
        "docs/theory.md, 4 to 6 and 8; form: docs/internals.md.\n",
    how_floats[] =
        "Errors of the rows, evaluated exactly, are above each table: sampled. Errors of evaluation in float\n"
        "arithmetic: include/cor/sphere.h, measured at every float.\n";

int sphere_float_tables_write(FILE *file)
{
    if (sphere_data_make())
        return STATUS_FAILED;
    struct emit e;
    emit_open_tables(&e, file, "sphere_float", floats_of_sphere, how_floats, EMIT_INCLUDE_ROWS);
    emit_comment(&e,
                 "A row: value = c_0 + (c_0' + t (c_1 + t (c_2 + t c_3))), t = beta - node, in columns c_0, c_1, c_2,\n"
                 "c_3. The node is 0 in row 0, and the middle of the cell in the other rows. The lower 16 bits of\n"
                 "c_3, moved up by 16, are the bits of c_0'.");
    const int status = law_tables_emit(&e, &data.tables, true);
    emit_close(&e);
    return status;
}
