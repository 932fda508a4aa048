/* SPDX-License-Identifier: MIT */
/* A subcommand of corgen, as a row of the table in main.c, and what chooses and runs it */
#ifndef COR_GEN_CLI_SUBCOMMAND_H
#define COR_GEN_CLI_SUBCOMMAND_H

#include <stdio.h>

#include "cli/options.h"

struct subcommand {
    const char *name;
    const char *summary;
    const char *help; /* full text of --help: usage, options, output columns, example */
    const struct option_rule *options;
    size_t size;                       /* size of its struct of arguments, which begins with struct option_common */
    const void *defaults;              /* values of that struct for options that are not given */
    int (*run)(const void *arguments); /* exit status */
};

/* The subcommand of a file that defines ARGUMENTS, help, options and run_NAME; then the defaults of its options */
#define SUBCOMMAND(NAME, WORD, SUMMARY, ...)                                                                           \
    const struct subcommand command_##NAME = {                                                                         \
        WORD, SUMMARY, help, options, sizeof(ARGUMENTS), &(const ARGUMENTS){__VA_ARGS__}, run_##NAME}

/* Parts of help texts */
#define HELP_LAW                                                                                                       \
    "  --elastic A, --damping B   exponents of x'' + beta x^B x' + x^A = 0, from 0 to 24, such as 3/2\n"               \
    "                             (default 3/2 and 1/2: viscoelastic spheres)\n"
#define HELP_DIGITS "  --digits D       significant digits, all of them proved; 1 to 10000000 (default 20)\n"
#define HELP_JSON_STRINGS "  --json-strings   in json, numbers with more digits than a double holds as strings\n"
#define HELP_END "  --end E          the contact ends at zero-overlap (default) or zero-force\n"
#define HELP_COMMON                                                                                                    \
    "  --output FILE    write to FILE, which changes only if everything succeeds (default: standard output)\n"         \
    "  --profile        print the seconds of each step and the peak memory on standard error\n"

/* Chooses a subcommand from a table that ends with NULL, and runs it. Returns the exit status. */
int subcommand_run(const struct subcommand *const *table, const char *version, int argc, char **argv);

/* corgen --help: the subcommands by the task of a user, and the terms of all help texts. Lines of subcommands that are
 * not in the table, and their examples, are left out. */
void overview_print(const struct subcommand *const *table, FILE *file);

/* Writes a script that a shell, bash or zsh, reads from its folder of completions, from the tables of subcommands and
 * options. Returns false for another shell. */
bool completion_print(const char *shell, const struct subcommand *const *table, FILE *file);

/* A table of proved digits, filled with more and more bits until every digit is decided, and then printed. A table of
 * exact numbers is filled once. */
enum { PROVED_TABLE_NAME = 64 };

struct proved_table {
    slong digits;
    const void *arguments; /* for `fill` */
    /* Initialises a table and fills it, computing with `bits` bits. Returns STATUS_OK or STATUS_FAILED. `undecided`
     * stays empty, or becomes the name of the first number whose digits are undecided. */
    int (*fill)(struct table *table, char undecided[PROVED_TABLE_NAME], const void *arguments, slong bits);
    /* prints FORMAT_TEXT and FORMAT_LATEX; NULL: the common text format */
    void (*print_text)(FILE *file, const struct table *table, const void *arguments);
};

/* Returns the exit status. */
int proved_table_write(const struct proved_table *proved, const struct option_common *common);

#endif
