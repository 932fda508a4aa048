/* SPDX-License-Identifier: MIT */
#include "cli/subcommand.h"

#include <errno.h>
#include <string.h>

#include "support/console.h"

enum { LINE_MAX_LENGTH = 256 };

static int print_whole(const char *text)
{
    struct output out;
    if (output_open(&out, NULL) != STATUS_OK)
        return STATUS_FAILED;
    fputs(text, out.file);
    return output_commit(&out);
}

static int print_overview(const struct subcommand *table)
{
    struct output out;
    if (output_open(&out, NULL) != STATUS_OK)
        return STATUS_FAILED;
    fputs("corgen computes restitution of viscoelastic spheres, and free modes of elastic disks, exactly or to any "
          "number of "
          "proved digits.\n\nUsage: corgen SUBCOMMAND [OPTION]...\n\n",
          out.file);
    for (const struct subcommand *cmd = table; cmd->name; cmd++)
        fprintf(out.file, "  %-12s %s\n", cmd->name, cmd->summary);
    fputs("\ncorgen SUBCOMMAND --help explains one; corgen --version names the versions.\n"
          "Exit status: 0 done, 1 failed, 2 the command line is wrong.\n"
          "Try: corgen collide --beta 0.1 --digits 30\n",
          out.file);
    return output_commit(&out);
}

static int print_version(const char *version)
{
    char text[LINE_MAX_LENGTH];
    snprintf(text, sizeof text, "corgen %s (GMP %s, MPFR %s, FLINT %s)\n", version, gmp_version, mpfr_get_version(),
             flint_version);
    return print_whole(text);
}

int subcommand_run(const struct subcommand *table, const char *version, int argc, char **argv)
{
    char names[LINE_MAX_LENGTH] = "";
    for (const struct subcommand *cmd = table; cmd->name; cmd++) {
        if (cmd != table)
            strncat(names, ", ", sizeof names - strlen(names) - 1);
        strncat(names, cmd->name, sizeof names - strlen(names) - 1);
    }
    if (argc < 2)
        return usage_error("no subcommand; allowed: %s; see corgen --help", names);
    if (strcmp(argv[1], "--help") == 0)
        return print_overview(table);
    if (strcmp(argv[1], "--version") == 0)
        return print_version(version);

    const struct subcommand *cmd = table;
    while (cmd->name && strcmp(cmd->name, argv[1]) != 0)
        cmd++;
    if (!cmd->name)
        return usage_error("'%.60s' is not a subcommand; allowed: %s; see corgen --help", argv[1], names);

    struct options options;
    bool help;
    int status = options_parse(&options, cmd, argc - 1, argv + 1, &help);
    if (status != STATUS_OK)
        return status;
    if (help)
        return print_whole(cmd->help);
    if (options.profile)
        profile_enable();
    status = cmd->run(&options);
    progress_end();
    profile_report();

    /* For what was printed past output.c: a remark that did not arrive is a failure too. */
    if (status == STATUS_OK && (fflush(stdout) != 0 || ferror(stdout)))
        status = fail("cannot write standard output: %s", strerror(errno));
    return status;
}
