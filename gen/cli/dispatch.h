/* SPDX-License-Identifier: MIT */
/* From a command line to the subcommand, the overview or the completion that it asks for. */
#ifndef COR_GEN_CLI_DISPATCH_H
#define COR_GEN_CLI_DISPATCH_H

#include <stdio.h>

#include "cli/subcommand.h"

/* Chooses a subcommand from a table that ends with NULL, and runs it. Returns the exit status. */
int subcommand_run(const struct subcommand *const *table, const char *version, int argc, char **argv);

/* corgen --help: the subcommands by the task of a user, and the terms of all help texts. Lines of subcommands that are
 * not in the table, and their examples, are left out. */
void overview_print(const struct subcommand *const *table, FILE *file);

/* Writes a script that a shell, bash or zsh, reads from its folder of completions, from the tables of subcommands and
 * options. Returns false for another shell. */
bool completion_print(const char *shell, const struct subcommand *const *table, FILE *file);

#endif
