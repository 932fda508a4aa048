/* SPDX-License-Identifier: MIT */
/* From a command line to the subcommand that it names. */
#ifndef COR_GEN_CLI_SUBCOMMAND_H
#define COR_GEN_CLI_SUBCOMMAND_H

#include "cli/options.h"

/* Chooses and runs one out of a table that ends with a NULL name; returns the exit status. */
int subcommand_run(const struct subcommand *table, const char *version, int argc, char **argv);

#endif
