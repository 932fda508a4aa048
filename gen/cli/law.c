/* SPDX-License-Identifier: MIT */
/* corgen law writes one header with every quantity of one law. */
#include <string.h>

#include "cli/commands.h"
#include "support/console.h"
#include "tables/files.h"

static int run_law(const void *arguments)
{
    const struct law_arguments *const o = arguments;
    if (!o->law.elastic || !o->law.damping)
        return usage_error("corgen law needs --elastic and --damping, for example --elastic 3/2 --damping 0");
    if (strlen(o->name) > LAW_NAME_MAX)
        return usage_error("--name is too long; allowed: up to %d characters", LAW_NAME_MAX);
    struct output out;
    if (output_open(&out, o->common.output) != STATUS_OK)
        return STATUS_FAILED;
    profile_step("tables");
    const int status = law_header_write(out.file, &o->law.exponents, o->name);
    profile_step(NULL);
    return output_finish(&out, status);
}

static const char help[] =
    "Usage: corgen law --elastic A --damping B --name NAME [--output FILE]\n\n"
    "Writes a self-contained header (C99, C++11, CUDA and HIP) for the contact law\n"
    "x'' + beta x^B x' + x^A = 0, x(0) = 0, x'(0) = 1, with functions of beta from 0 to infinity:\n"
    "NAME_eps_END, NAME_loss_END (1 - eps), NAME_beta_END (the inverse of eps), NAME_beta_of_loss_END and\n"
    "NAME_duration_END, with END = zero_overlap and zero_force; NAME_max_overlap and\n"
    "NAME_time_of_max_overlap. The command needs minutes.\n\n"
    "  --elastic A      elastic exponent, 0 to 24, such as 3/2 or 1.5\n"
    "  --damping B      damping exponent, 0 to 24, such as 0 or 1/4\n"
    "  --name NAME      first part of the functions' names, a C identifier\n" HELP_COMMON "\n"
    "Example: corgen law --elastic 1 --damping 1/2 --name hooke --output hooke.h\n";

#define ARGUMENTS struct law_arguments
static const struct option_rule options[] = {
    OPTION_LAW,
    OPTION("name", C_NAME, name, .required = true),
    OPTION_COMMON,
};

SUBCOMMAND(law, "law", "a C header with every quantity of one contact law", .common.format = FORMAT_TEXT);
