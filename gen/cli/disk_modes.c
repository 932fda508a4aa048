/* SPDX-License-Identifier: MIT */
/* corgen disk-modes: the lowest free modes of an elastic disk in proved digits. */
#include <stdlib.h>

#include "cli/commands.h"
#include "disk/modes.h"
#include "support/console.h"
#include "support/digits.h"
#include "support/parallel.h"

enum { NUMBERS = 3 }; /* omega, C and S of a mode */

struct spelling {
    const struct disk_modes *modes;
    slong digits;
    char **text; /* NUMBERS texts for each mode */
};

static void spell_mode(void *context, slong i)
{
    const struct spelling *const work = context;
    const struct disk_mode *const mode = &work->modes->mode[i];
    char **const text = work->text + NUMBERS * i;
    text[0] = digits_of_ball(mode->omega, work->digits);
    text[1] = digits_of_ball(mode->c, work->digits);
    text[2] = digits_of_ball(mode->s, work->digits);
}

/* Fills the table. Its digits are always decided. */
static int fill_table(struct table *table, char undecided[PROVED_TABLE_NAME], const void *arguments, slong bits)
{
    (void)undecided;
    (void)bits;
    const struct disk_modes_arguments *const o = arguments;
    struct disk_modes modes = {0};
    table_init(table, "n,l,omega,C,S", "nnddd");
    const int status = disk_modes_solve(&modes, o->poisson.value, o->count, o->digits);
    profile_step("printing");
    if (status == STATUS_OK) {
        struct spelling work = {&modes, o->digits, xmalloc((size_t)(NUMBERS * modes.count) * sizeof *work.text)};
        parallel_for(spell_mode, &work, modes.count, "digits of modes");
        for (slong i = 0; i < modes.count; i++) {
            table_add_integer(table, modes.mode[i].n);
            table_add_integer(table, modes.mode[i].l);
            for (int k = 0; k < NUMBERS; k++)
                table_add(table, work.text[NUMBERS * i + k]);
        }
        free(work.text);
    }
    disk_modes_clear(&modes);
    return status;
}

static int run_disk_modes(const void *arguments)
{
    const struct disk_modes_arguments *const o = arguments;
    const int status = options_disk_poisson(&o->poisson);
    const struct proved_table table = {o->digits, o, fill_table, NULL};
    return status == STATUS_OK ? proved_table_write(&table, &o->common) : status;
}

static const char help[] =
    "Usage: corgen disk-modes --poisson NU --count N [OPTION]...\n\n"
    "Prints the N lowest free modes of an elastic disk by increasing frequency, without gaps (proved):\n"
    "n nodal diameters, l = 0, 1, ... among the modes of that n, frequency omega in sqrt(E/rho)/R, and\n"
    "the displacements C (radial, positive) and S (tangential) at the rim, normalised to the area.\n\n"
    "  --poisson NU     Poisson's ratio in plane stress, between -1 and 1, such as 0.33 or 1/3\n"
    "  --count N        number of modes, 1 to 10000000\n" HELP_DIGITS
    "  --format F       output format, text, csv or json (default text)\n" HELP_JSON_STRINGS HELP_COMMON "\n"
    "Columns: n,l,omega,C,S.\n\n"
    "Example: corgen disk-modes --poisson 0.33 --count 10\n";

#define ARGUMENTS struct disk_modes_arguments
static const struct option_rule options[] = {
    OPTION("poisson", REAL, poisson, .range.number = &option_disk_poisson, .required = true),
    OPTION("count", WHOLE, count, .range.whole = {1, DISK_MODES_MAX}, .why = OPTION_COUNT_WHY, .required = true),
    OPTION_DIGITS,
    OPTION_FORMAT(option_formats),
    OPTION_JSON_STRINGS,
    OPTION_COMMON,
};

SUBCOMMAND(disk_modes, "disk-modes", "the free modes of an elastic disk", .digits = OPTIONS_DEFAULT_DIGITS);
