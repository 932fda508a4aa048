/* SPDX-License-Identifier: MIT */
/* corgen disk-modes: the lowest free modes of an elastic disk in proved digits. */
#include "cli/commands.h"
#include "disk/modes.h"
#include "support/console.h"
#include "support/digits.h"

/* What one mode takes: three numbers, their texts, and its place in the table. */
static double bytes_needed(double digits)
{
    return 600 + 3 * (digits + digits * 3.33 / 8);
}

static int run_disk_modes(const void *arguments)
{
    const struct disk_modes_arguments *const o = arguments;
    const int wrong = options_disk_poisson(&o->poisson);
    if (wrong)
        return wrong;
    static const char *const column[] = {"n", "l", "omega", "C", "S"};
    const double needed = (double)o->count * bytes_needed((double)o->digits), memory = console_memory();
    if (memory > 0 && needed > memory)
        return fail("%ld modes to %ld digits need about %.3g GB of memory, and this machine has %.3g GB",
                    (long)o->count, (long)o->digits, needed / 1e9, memory / 1e9);
    struct output out;
    if (output_open(&out, o->common.output) != STATUS_OK)
        return STATUS_FAILED;

    struct disk_modes modes;
    disk_modes_init(&modes);
    const int status = disk_modes_solve(&modes, o->poisson.value, o->count, o->digits);
    if (status != STATUS_OK) {
        output_discard(&out);
        return status;
    }

    profile_step("printing");
    struct table table;
    table_init(&table, column, sizeof column / sizeof *column);
    for (slong i = 0; i < modes.count; i++) {
        const struct disk_mode *mode = &modes.mode[i];
        table_add_integer(&table, mode->n);
        table_add_integer(&table, mode->l);
        table_add(&table, digits_of_ball(mode->omega, o->digits));
        table_add(&table, digits_of_ball(mode->c, o->digits));
        table_add(&table, digits_of_ball(mode->s, o->digits));
    }
    disk_modes_clear(&modes);
    table_print(&table, (enum output_format)o->common.format, out.file);
    table_clear(&table);
    return output_commit(&out);
}

static const char help[] =
    "Usage: corgen disk-modes --poisson NU --count N [OPTION]...\n\n"
    "Prints the N lowest free modes of an elastic disk, by increasing frequency, none missing: n\n"
    "nodal diameters, l = 0, 1, ... among the modes of that n, frequency omega in sqrt(E/rho)/R, and\n"
    "the displacements C (radial, positive) and S (tangential) at the rim, normalised to the area.\n\n"
    "  --poisson NU     Poisson's ratio in plane stress, between -1 and 1, as 0.33 or 1/3\n"
    "  --count N        number of modes, 1 to 10000000\n" HELP_DIGITS
    "  --format F       text (default), csv or json\n" HELP_COMMON "\nColumns: n,l,omega,C,S.\n"
    "Example: corgen disk-modes --poisson 0.33 --count 10\n";

#define AT(FIELD) offsetof(struct disk_modes_arguments, FIELD)
static const struct option_rule options[] = {
    {.name = "poisson",
     .kind = OPTION_REAL,
     .offset = AT(poisson),
     .range.number = &option_disk_poisson,
     .required = true},
    {.name = "count",
     .kind = OPTION_WHOLE,
     .offset = AT(count),
     .range.whole = {1, DISK_MODES_MAX},
     .why = OPTION_COUNT_WHY,
     .required = true},
    OPTION_DIGITS(struct disk_modes_arguments),
    OPTION_FORMAT(struct disk_modes_arguments, option_formats),
    OPTION_COMMON(struct disk_modes_arguments),
    {.name = NULL},
};

static const struct disk_modes_arguments defaults = {.digits = OPTIONS_DEFAULT_DIGITS};

const struct subcommand command_disk_modes = {
    "disk-modes", "the free modes of an elastic disk", help, options, sizeof defaults, &defaults, run_disk_modes};
