/* SPDX-License-Identifier: MIT */
/* From a command line to the subcommand, the overview or the completion that it asks for. */
#ifndef COR_GEN_CLI_DISPATCH_H
#define COR_GEN_CLI_DISPATCH_H

#include "cli/subcommand.h"

/* Chooses a subcommand from a table that ends with NULL, and runs it. Returns the exit status. */
int subcommand_run(const struct subcommand *const *table, const char *version, int argc, char **argv);

#endif
