/* SPDX-License-Identifier: MIT */
/* Completion of corgen's command lines by a shell, from the tables of subcommands and options. */
#ifndef COR_GEN_CLI_COMPLETION_H
#define COR_GEN_CLI_COMPLETION_H

#include <stdio.h>

#include "cli/subcommand.h"

enum completion_shell { COMPLETION_BASH, COMPLETION_ZSH };
extern const char *const completion_shells[]; /* in this order; ends with NULL */

/* Writes a script that bash or zsh reads from its folder of completions. */
void completion_print(enum completion_shell shell, const struct subcommand *const *table, FILE *file);

#endif
