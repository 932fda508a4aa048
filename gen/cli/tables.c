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
        return usage_error("--%s is about the collisions of generated/" DISK_LIMITS_FILE ", not about --poisson",
                           o.all ? "all" : "seed");
    if (o.seed != OPTIONS_NOT_GIVEN && (o.all || !o.check))
        return usage_error("--seed chooses the sample of --check without --all");
    if (o.modes != 0 && !o.poisson.text)
        return usage_error("--modes needs --poisson: the tables of generated/ have %d modes", DISK_TABLE_MODES);
    if (o.digits && (o.poisson.text || o.check || o.all || o.directory))
        return usage_error("--digits prints the digits of all tables and goes with no other option%s",
                           o.poisson.text ? "; corgen disk-modes prints those of modes" : "");
    if (o.directory && strcmp(o.directory, "-") == 0)
        return usage_error("--output: '-' is no directory; files go to one, and --digits prints all numbers");
    if (o.poisson.text && strlen(o.poisson.text) > DISK_TABLE_POISSON)
        return usage_error("--poisson: a name of a file is made of it; %d characters at most, as 0.33",
                           DISK_TABLE_POISSON);
    const int wrong = o.poisson.text ? options_disk_poisson(&o.poisson) : STATUS_OK;
    return wrong ? wrong : tables_run(&o);
}

static const char help[] =
    "Usage: corgen tables [--check] [--all] [--output DIR] [OPTION]...\n"
    "       corgen tables --poisson NU [--modes N] [--check] [--output DIR] [OPTION]...\n"
    "       corgen tables --digits\n\n"
    "Writes every file of generated/, or the modes of an elastic disk of another material as a C\n"
    "header to embed and a file to load; all of them or none.\n\n"
    "  --poisson NU     Poisson's ratio in plane stress, between -1 and 1, as 0.33 or 1/3\n"
    "  --modes N        number of modes, 1 to 10000000 (default 1800)\n"
    "  --check          write nothing; compare every byte and fail at a difference; also collide disks\n"
    "                   again at random places of disk_limits.h\n"
    "  --all            also compute disk_limits.h again, which takes 13 minutes of CPU time; with\n"
    "                   --check, collide at all places of disk_limits.h\n"
    "  --digits         write no file; print every coefficient with 25 digits, as csv:\n"
    "                   table,row,column,value,digits\n"
    "  --seed N         seed of these random places, 0 to 1000000000 (default: a new one each time)\n"
    "  --output DIR     the directory (default: generated; with --poisson, the current one)\n"
    "  --profile        seconds per step and peak memory on standard error\n"
    "\nExample: corgen tables --poisson 0.3 --modes 10\n";

#define ARGUMENTS struct tables_arguments
static const struct option_rule options[] = {
    OPTION("poisson", REAL, request.poisson, .range.number = &option_disk_poisson),
    OPTION("modes", WHOLE, request.modes, .range.whole = {1, DISK_MODES_MAX}, .why = OPTION_COUNT_WHY),
    OPTION_PLAIN("check", FLAG, request.check),
    OPTION_PLAIN("all", FLAG, request.all),
    OPTION_PLAIN("digits", FLAG, request.digits),
    OPTION("seed", WHOLE, request.seed, .range.whole = {0, TABLES_MAX_SEED},
           .why = "there are no more samples than that"),
    OPTION_PLAIN("output", FOLDER, common.output),
    OPTION_LAST,
};

SUBCOMMAND(tables, "tables", "write or check the generated C tables", .request.seed = OPTIONS_NOT_GIVEN);
