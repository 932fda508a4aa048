/* SPDX-License-Identifier: MIT */
/* corgen --help: the subcommands by the task of a user, and the terms of all help texts. */
#ifndef COR_GEN_CLI_OVERVIEW_H
#define COR_GEN_CLI_OVERVIEW_H

#include <stdio.h>

#include "cli/subcommand.h"

/* Writes the overview. Lines of subcommands that are not in the table, and their examples, are left out. */
void overview_print(const struct subcommand *const *table, FILE *file);

#endif
