/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "cli/commands.h"
#include "support/console.h"

/* The subcommands in the order of corgen --help. A new subcommand needs a file in this folder and a line here. */
static const struct subcommand *const subcommands[] = {&command_trajectory, &command_series,
                                                       &command_pade,       &command_collide,
                                                       &command_disk_modes, &command_disk_collide,
#ifndef COR_BOOTSTRAP
                                                       &command_contact,    &command_sample,
                                                       &command_embed,
#endif
                                                       &command_law,
#ifndef COR_BOOTSTRAP
                                                       &command_plan,
#endif
                                                       &command_tables,     NULL};

/* Refuses subcommands of another program, the command cor of the Python package. */
static int refuse_moved(const char *name)
{
    if (strcmp(name, "audit") == 0)
        return usage_error("audit is a subcommand of cor, with the same options; type: cor audit FILE. Install cor by "
                           "apt-get install python3-cor on Debian, or by pip install ./python in the source of cor");
    if (strcmp(name, "fit") != 0)
        return STATUS_OK;
    return usage_error(
        "fit is a subcommand of cor, with the same options; type: cor fit DATA.csv. Install cor by "
        "apt-get install python3-cor python3-scipy on Debian, or by pip install './python[fit]' in the source of cor");
}

int main(int argc, char **argv)
{
    console_start();
    if (argc > 1 && refuse_moved(argc > 2 && strcmp(argv[1], "help") == 0 ? argv[2] : argv[1]) != STATUS_OK)
        return STATUS_USAGE;
    return subcommand_run(subcommands, COR_VERSION, argc, argv);
}
