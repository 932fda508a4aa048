/* SPDX-License-Identifier: MIT */
#include "cli/commands.h"
#include "support/console.h"

/* The subcommands in the order of corgen --help. A new subcommand needs a file beside this one and a line here. */
static const struct subcommand *const subcommands[] = {&command_trajectory, &command_series,
                                                       &command_pade,       &command_collide,
                                                       &command_disk_modes, &command_disk_collide,
#ifndef COR_BOOTSTRAP
                                                       &command_contact,    &command_sample,
                                                       &command_fit,        &command_audit,
                                                       &command_embed,
#endif
                                                       &command_law,
#ifndef COR_BOOTSTRAP
                                                       &command_plan,
#endif
                                                       &command_tables,     NULL};

int main(int argc, char **argv)
{
    console_start();
    return subcommand_run(subcommands, COR_VERSION, argc, argv);
}
