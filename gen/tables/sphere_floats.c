/* SPDX-License-Identifier: MIT */
#include "tables/sphere_floats.h"

#include "approximation/float_rows.h"
#include "support/console.h"
#include "tables/sphere.h"

/* 27 bits limit the approximation to an eighth of a unit of the last place. c_0 of a row that is multiplied by beta has
 * 19 bits, so that its product with the first 5 bits of beta is exact. */
#define LEAST_BITS 27
enum { PRODUCT_HEAD_BITS = 19 };
#define FLOATS(quantity, title, number, first_octave, end_octave, octave_bits, head_bits)                              \
    {                                                                                                                  \
        "cor_rows_float_" quantity, title, number, first_octave, end_octave, octave_bits, head_bits, LEAST_BITS, 0,    \
            NULL, NULL                                                                                                 \
    }
static const struct float_rows float_tables[] = {
    FLOATS("eps_zero_overlap", "eps at zero overlap", EPS_ZERO_OVERLAP, -6, 3, 7, 0),
    FLOATS("eps_zero_force", "eps at zero force", EPS_ZERO_FORCE, -9, 4, 6, 0),
    FLOATS("loss_zero_overlap", "(1 - eps)/beta at zero overlap", LOSS_QUOTIENT_ZERO_OVERLAP, -6, 3, 6,
           PRODUCT_HEAD_BITS),
    FLOATS("loss_zero_force", "(1 - eps)/beta at zero force", LOSS_QUOTIENT_ZERO_FORCE, -17, 4, 5, PRODUCT_HEAD_BITS),
    FLOATS("duration_zero_overlap", "duration at zero overlap", DURATION_ZERO_OVERLAP, -6, 3, 6, 0),
    FLOATS("duration_zero_force", "duration at zero force", DURATION_ZERO_FORCE, -11, 4, 5, 0),
    FLOATS("max_overlap", "largest overlap", MAX_OVERLAP, -6, 4, 5, 0),
    FLOATS("time_of_max_overlap", "time of the largest overlap", TIME_OF_MAX_OVERLAP, -6, 4, 5, 0),
};
enum { FLOAT_TABLES = sizeof float_tables / sizeof *float_tables };

static const char floats_banner[] =
    "Collisions of viscoelastic spheres, x'' + beta sqrt(x) x' + x^(3/2) = 0, both ends of contact, for float\n"
    "arithmetic: rows of cubics by octaves of beta. Evaluated by runtime/core/float_lanes.h. Source:\n"
    "docs/derivation.md, 4 to 6 and 8; form: docs/header-format.md.\n"
    "\n"
    "Written by:  corgen tables\n"
    "Checked by:  corgen tables --check\n"
    "\n"
    "Errors of the rows, evaluated exactly, stand above each table and beside each row: sampled. Errors of\n"
    "evaluation in float arithmetic: include/cor/sphere.h, measured at every float.\n";

int sphere_float_tables_write(FILE *file, const struct disk_table *none)
{
    (void)none;
    const struct interpolant *const f = sphere_tables_interpolant();
    if (f == NULL)
        return STATUS_FAILED;
    struct emit e;
    int status = STATUS_OK;
    emit_open(&e, file, "COR_GENERATED_SPHERE_FLOAT_TABLES_H", floats_banner);
    emit_include(&e, "\"runtime/core/rows.h\"");
    emit_comment(&e,
                 "A row: value = c_0 + (c_0' + t (c_1 + t (c_2 + t c_3))), t = beta - node, in columns c_0, c_1, c_2,\n"
                 "c_3. The node is 0 in row 0, and the middle of the cell in the other rows. The lower 16 bits of\n"
                 "c_3, moved up by 16, are the bits of c_0'.");
    for (int i = 0; i < FLOAT_TABLES && status == STATUS_OK; i++) {
        struct float_rows rows = float_tables[i];
        status = float_rows_make(&rows, f);
        if (status == STATUS_OK)
            float_rows_emit(&e, &rows);
        float_rows_clear(&rows);
    }
    emit_close(&e);
    return status;
}
