/* SPDX-License-Identifier: MIT */
#include "cli/dispatch.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/words.h"

/* What was printed on standard output arrives, or its failure is reported. */
static int printed(void)
{
    struct output out;
    return output_open(&out, NULL) == STATUS_OK ? output_commit(&out) : STATUS_FAILED;
}

static int print_overview(const struct subcommand *const *table)
{
    overview_print(table, stdout);
    return printed();
}

static int print_help_of(const struct subcommand *cmd)
{
    fputs(cmd->help, stdout);
    return printed();
}

enum { SUBCOMMANDS_MOST = 32 };

/* The subcommand of that name. Returns NULL after a message if `name` is NULL or not a subcommand. */
static const struct subcommand *subcommand_named(const struct subcommand *const *table, const char *name)
{
    for (const struct subcommand *const *row = table; name && *row; row++)
        if (strcmp((*row)->name, name) == 0)
            return *row;
    const char *names[SUBCOMMANDS_MOST + 1] = {NULL};
    for (int i = 0; i < SUBCOMMANDS_MOST && table[i]; i++)
        names[i] = table[i]->name;
    if (name)
        refuse_word(name, names, "", "'%s' is not a subcommand", name);
    else
        refuse_word("", names, "", "no subcommand; see corgen --help");
    return NULL;
}

static int subcommand_start(const struct subcommand *cmd, const void *arguments)
{
    const struct option_common *const common = arguments;
    if (common->profile)
        profile_enable();
    int status = cmd->run(arguments);
    progress_end();
    profile_report();
    /* remarks are printed without output.c; an error of stdout is a failure, too */
    if (status == STATUS_OK && (fflush(stdout) != 0 || ferror(stdout)))
        status = fail("cannot write standard output: %s", strerror(errno));
    return status;
}

static bool word_is(const char *text, const char *word)
{
    return text && strcmp(text, word) == 0;
}

/* corgen --completion SHELL */
static int print_completion(const struct subcommand *const *table, int argc, char **argv)
{
    return argc == 1 && completion_print(argv[0], table, stdout)
               ? printed()
               : usage_error("--completion takes one shell, bash or zsh, as corgen --completion bash");
}

/* corgen help [SUBCOMMAND] */
static int print_help(const struct subcommand *const *table, int argc, char **argv)
{
    if (argc > 1)
        return usage_error("corgen help takes one subcommand, not '%s' too", argv[1]);
    if (argc == 0)
        return print_overview(table);
    const struct subcommand *const cmd = subcommand_named(table, argv[0]);
    return cmd ? print_help_of(cmd) : STATUS_USAGE;
}

static int subcommand_parse_and_start(const struct subcommand *cmd, int argc, char **argv)
{
    void *arguments = xmalloc(cmd->size);
    memcpy(arguments, cmd->defaults, cmd->size);
    bool help;
    int status = options_parse(arguments, cmd->options, argc, argv, &help);
    if (status == STATUS_OK)
        status = help ? print_help_of(cmd) : subcommand_start(cmd, arguments);
    options_clear(arguments, cmd->options);
    free(arguments);
    return status;
}

int subcommand_run(const struct subcommand *const *table, const char *version, int argc, char **argv)
{
    const char *const name = argc < 2 ? NULL : argv[1];
    output_report_size_limit();
    if (word_is(name, "--help") || word_is(name, "-h"))
        return print_overview(table);
    if (word_is(name, "help"))
        return print_help(table, argc - 2, argv + 2);
    if (word_is(name, "--version")) {
        printf("corgen %s (GMP %s, MPFR %s, FLINT %s)\n", version, gmp_version, mpfr_get_version(), flint_version);
        return printed();
    }
    if (word_is(name, "--completion"))
        return print_completion(table, argc - 2, argv + 2);
    const struct subcommand *const cmd = subcommand_named(table, name);
    return cmd ? subcommand_parse_and_start(cmd, argc - 1, argv + 1) : STATUS_USAGE;
}
