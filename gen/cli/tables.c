/* SPDX-License-Identifier: MIT */
/* corgen tables writes all files of generated/, or the mode tables of another material. */
#include <string.h>

#include "cli/commands.h"
#include "disk/modes.h"
#include "support/console.h"

static int run_tables(const void *arguments)
{
    const struct tables_arguments *const given = arguments;
    struct tables_request o = given->request;
    o.directory = given->common.output;
    if ((o.all || o.seed != OPTIONS_NOT_GIVEN) && o.poisson.text)
        return usage_error("--%s applies only to generated/" DISK_LIMITS_FILE "; leave out --poisson",
                           o.all ? "all" : "seed");
    if (o.seed != OPTIONS_NOT_GIVEN && (o.all || !o.check))
        return usage_error("--seed chooses the sample of --check; give --check without --all");
    if (o.modes != 0 && !o.poisson.text)
        return usage_error("--modes needs --poisson, because the tables of generated/ always have %d modes",
                           DISK_TABLE_MODES);
    if (o.digits && (o.poisson.text || o.check || o.all || o.directory))
        return usage_error("--digits prints the digits of all tables; leave out all other options%s",
                           o.poisson.text ? ", or print the digits of modes by corgen disk-modes" : "");
    if (o.directory && strcmp(o.directory, "-") == 0)
        return usage_error(
            "--output: '-' is not a directory; give the directory for the files, or print all numbers by --digits");
    if (o.poisson.text && strlen(o.poisson.text) > DISK_TABLE_POISSON)
        return usage_error("--poisson is part of the file name; allowed: up to %d characters, for example 0.33",
                           DISK_TABLE_POISSON);
    const int wrong = o.poisson.text ? options_disk_poisson(&o.poisson) : STATUS_OK;
    return wrong ? wrong : tables_run(&o);
}

static const char help[] =
    "Usage: corgen tables [--check] [--all] [--output DIR] [OPTION]...\n"
    "       corgen tables --poisson NU [--modes N] [--check] [--output DIR] [OPTION]...\n"
    "       corgen tables --digits\n\n"
    "Writes every file of generated/, or the modes of an elastic disk of another material as a C\n"
    "header to embed and a file to load. Writes all files or none.\n\n"
    "  --poisson NU     Poisson's ratio in plane stress, between -1 and 1, such as 0.33 or 1/3\n"
    "  --modes N        number of modes, 1 to 10000000 (default 1800)\n"
    "  --check          compare every byte instead of writing, and fail at a difference; also compute\n"
    "                   disk_limits.h again at random places\n"
    "  --all            also compute disk_limits.h again, which needs 13 minutes of CPU time; with\n"
    "                   --check, compute it at all places\n"
    "  --digits         print every coefficient with 25 digits, as csv table,row,column,value,digits;\n"
    "                   write no file\n"
    "  --seed N         seed of the random places, 0 to 1000000000 (default: a new one each time)\n"
    "  --output DIR     directory for the files (default generated; with --poisson, the current one)\n"
    "  --profile        print the seconds of each step and the peak memory on standard error\n\n"
    "Example: corgen tables --poisson 0.3 --modes 10\n";

#define ARGUMENTS struct tables_arguments
static const struct option_rule options[] = {
    OPTION("poisson", REAL, request.poisson, .range.number = &option_disk_poisson),
    OPTION("modes", WHOLE, request.modes, .range.whole = {1, DISK_MODES_MAX}, .why = OPTION_COUNT_WHY),
    OPTION_PLAIN("check", FLAG, request.check),
    OPTION_PLAIN("all", FLAG, request.all),
    OPTION_PLAIN("digits", FLAG, request.digits),
    OPTION("seed", WHOLE, request.seed, .range.whole = {0, TABLES_MAX_SEED}, .why = "no test needs more samples"),
    OPTION_PLAIN("output", FOLDER, common.output),
    OPTION_LAST,
};

SUBCOMMAND(tables, "tables", "write or check the generated C tables", .request.seed = OPTIONS_NOT_GIVEN);
