/* SPDX-License-Identifier: MIT */
#include "cli/options.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"

enum { SUBCOMMANDS_MOST = 32 };

/* Returns the subcommand of that name, or NULL after a message if `name` is NULL or not a subcommand. */
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

/* Prints the help. Replaces the name of an option in braces by the words that it accepts, as "a, b". */
static void print_subcommand_help(const struct subcommand *cmd, const char *help)
{
    for (const char *at = help; *at; at++) {
        if (*at == '\f') {
            print_subcommand_help(cmd, help_contact);
            continue;
        }
        const struct option_rule *rule = cmd->options;
        const size_t length = *at == '{' ? strcspn(at + 1, "}") : 0;
        while (length > 0 && !(strncmp(rule->name, at + 1, length) == 0 && rule->name[length] == '\0'))
            rule++;
        if (length == 0)
            putchar(*at);
        for (int i = 0; length > 0 && options_words(rule)[i]; i++)
            printf("%s%s", i > 0 ? ", " : "", options_words(rule)[i]);
        at += length > 0 ? length + 1 : 0;
    }
}

/* corgen help [SUBCOMMAND] */
static int print_help(const struct subcommand *const *table, int argc, char **argv)
{
    if (argc > 1)
        return usage_error("corgen help accepts one subcommand; leave out '%s'", argv[1]);
    const struct subcommand *const cmd = argc == 0 ? NULL : subcommand_named(table, argv[0]);
    if (argc == 0)
        overview_print(table, stdout);
    else if (cmd)
        print_subcommand_help(cmd, cmd->help);
    return argc == 0 || cmd ? STATUS_OK : STATUS_USAGE;
}

static int run_word(const struct subcommand *const *table, const char *version, int argc, char **argv)
{
    const char *const name = argc < 2 ? "" : argv[1];
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0)
        return print_help(table, 0, NULL);
    if (strcmp(name, "help") == 0)
        return print_help(table, argc - 2, argv + 2);
    if (strcmp(name, "--version") == 0) {
        printf("corgen %s (GMP %s, MPFR %s, FLINT %s)\n", version, gmp_version, mpfr_get_version(), flint_version);
        return STATUS_OK;
    }
    if (strcmp(name, "--completion") == 0)
        return argc == 3 && completion_print(argv[2], table, stdout)
                   ? STATUS_OK
                   : usage_error("--completion needs one shell, bash or zsh, for example corgen --completion bash");
    const struct subcommand *const cmd = subcommand_named(table, argc < 2 ? NULL : name);
    if (!cmd)
        return STATUS_USAGE;
    struct option_common *const common = xmalloc(cmd->size); /* start of the struct of arguments */
    memcpy(common, cmd->defaults, cmd->size);
    bool help;
    progress_start(cmd->name);
    int status = options_parse(common, cmd->options, argc - 1, argv + 1, &help);
    if (status == STATUS_OK && help) {
        print_subcommand_help(cmd, cmd->help);
    } else if (status == STATUS_OK) {
        if (common->profile)
            profile_enable();
        status = cmd->run(common);
        progress_hold();
        profile_report();
    }
    options_clear(common, cmd->options);
    free(common);
    return status;
}

int subcommand_run(const struct subcommand *const *table, const char *version, int argc, char **argv)
{
    output_report_size_limit();
    const int status = run_word(table, version, argc, argv);
    if (status == STATUS_OK && (fflush(stdout) != 0 || ferror(stdout)))
        return fail("cannot write standard output: %s", strerror(errno));
    return status;
}
