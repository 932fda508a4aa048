/* SPDX-License-Identifier: MIT */
/* corgen collide: one collision in proved digits. */
#include <stdlib.h>

#include "cli/options.h"
#include "enclosure/collision.h"
#include "support/console.h"
#include "support/digits.h"

static const char *const column[] = {"beta",           "x_max",          "t_max",       "eps_zero_overlap",
                                     "t_zero_overlap", "eps_zero_force", "t_zero_force"};
enum { COLUMNS = sizeof column / sizeof *column };

static const char *const meaning[COLUMNS] = {
    "damping, the one parameter",  "largest overlap",
    "time of the largest overlap", "coefficient of restitution, contact ends at zero overlap",
    "duration of that contact",    "coefficient of restitution, contact ends at zero force",
    "duration of that contact"};

/* Fills the one row; *undecided is -1, or the column whose digits are not proved yet. */
static int fill(struct table *table, slong *undecided, const struct options *o, slong bits)
{
    table_init(table, column, COLUMNS);
    *undecided = -1;
    arb_t beta;
    arb_init(beta);
    /* beta is rounded with bits to spare, so that this never costs the result its own. */
    options_beta(beta, o, 3 * bits + 256);
    struct collision collision;
    collision_init(&collision);
    int status = collision_solve(&collision, beta, &o->law, bits);
    profile_step("digits");
    const arb_struct *const value[COLUMNS] = {NULL,
                                              collision.x_max,
                                              collision.t_max,
                                              collision.eps_zero_overlap,
                                              collision.t_zero_overlap,
                                              collision.eps_zero_force,
                                              collision.t_zero_force};
    table_add(table, xstrdup(o->beta));
    for (int i = 1; i < COLUMNS && status == STATUS_OK && *undecided < 0; i++) {
        char *text = digits_of_ball(value[i], o->digits);
        if (text)
            table_add(table, text);
        else
            *undecided = i;
    }
    collision_clear(&collision);
    arb_clear(beta);
    return status;
}

static void print_text(FILE *file, const struct table *table)
{
    for (int i = 0; i < COLUMNS; i++)
        fprintf(file, "%-16s  %s  (%s)\n", column[i], table->cell[i], meaning[i]);
}

int command_collide(const struct options *o)
{
    struct output out;
    if (output_open(&out, o->output) != STATUS_OK)
        return STATUS_FAILED;

    struct precision precision = precision_start(o->digits);
    for (;;) {
        struct table table = {0};
        slong undecided = -1;
        profile_step("collision");
        int status = fill(&table, &undecided, o, precision.bits);
        if (status == STATUS_OK && undecided < 0) {
            profile_step("printing");
            if (o->format == FORMAT_TEXT)
                print_text(out.file, &table);
            else
                table_print(&table, o->format, out.file);
            table_clear(&table);
            return output_commit(&out);
        }
        table_clear(&table);
        if (status == STATUS_OK && !precision_raise(&precision))
            status = precision_spent(&precision, column[undecided], o->digits);
        if (status != STATUS_OK) {
            output_discard(&out);
            return STATUS_FAILED;
        }
    }
}
