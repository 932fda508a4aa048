/* SPDX-License-Identifier: MIT */
#include "cli/options.h"

#include <string.h>

static const char shells[] = "bash zsh";

/* The words that corgen accepts in place of a subcommand */
static const char other_words[] = "help --help --version --completion";

static void print_words(const char *const *words, FILE *file)
{
    for (const char *const *word = words; *word; word++)
        fprintf(file, "%s%s", word == words ? "" : " ", *word);
}

static void print_subcommands(const struct subcommand *const *table, FILE *file)
{
    while (*table)
        fprintf(file, "%s ", (*table++)->name);
}

/* ---- bash ---- */

/* Prints a case branch SUBCOMMAND:--OPTION for each option with a value, and one branch for all options. */
static void print_bash_subcommand(const struct subcommand *cmd, FILE *file)
{
    for (const struct option_rule *rule = cmd->options; rule->name; rule++) {
        if (rule->kind == OPTION_FLAG)
            continue;
        fprintf(file, "        %s:--%s) ", cmd->name, rule->name);
        if (rule->kind == OPTION_FILE || rule->kind == OPTION_FOLDER) {
            fputs("files=1", file);
        } else if (options_words(rule)) {
            fputs("words='", file);
            print_words(options_words(rule), file);
            fputc('\'', file);
        }
        fputs(";;\n", file);
    }
    fprintf(file, "        %s:*) words='", cmd->name);
    for (const struct option_rule *rule = cmd->options; rule->name; rule++)
        fprintf(file, "--%s ", rule->name);
    fputs("--help' ;;\n", file);
}

static void print_bash(const struct subcommand *const *table, FILE *file)
{
    fputs("# SPDX-License-Identifier: MIT\n"
          "# Completion of corgen in bash, written by: corgen --completion bash\n"
          "_corgen() {\n"
          "    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} words='' files=''\n"
          "    # bash splits --option=value into three words\n"
          "    if [ \"$current\" = '=' ]; then\n"
          "        current=''\n"
          "    elif [ \"$previous\" = '=' ]; then\n"
          "        previous=${COMP_WORDS[COMP_CWORD - 2]}\n"
          "    fi\n"
          "    COMPREPLY=()\n"
          "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
          "        words='",
          file);
    print_subcommands(table, file);
    fprintf(file,
            "%s'\n"
            "    else\n"
            "        case ${COMP_WORDS[1]}:$previous in\n"
            "        help:help) words='",
            other_words);
    print_subcommands(table, file);
    fprintf(file, "' ;;\n        --completion:--completion) words='%s' ;;\n", shells);
    for (; *table; table++)
        print_bash_subcommand(*table, file);
    fputs("        esac\n"
          "    fi\n"
          "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
          "    if [ \"$files\" ] && [[ $current != -* ]]; then\n"
          "        compopt -o filenames 2>/dev/null\n"
          "        mapfile -t -O \"${#COMPREPLY[@]}\" COMPREPLY < <(compgen -f -- \"$current\")\n"
          "    fi\n"
          "}\n"
          "complete -F _corgen corgen\n",
          file);
}

/* ---- zsh ---- */

static void print_zsh_option(const struct option_rule *rule, FILE *file)
{
    fprintf(file, " '--%s", rule->name);
    if (rule->kind == OPTION_FILE || rule->kind == OPTION_FOLDER) {
        fputs("=:file:_files", file);
    } else if (options_words(rule)) {
        fprintf(file, "=:%s:(", rule->name);
        print_words(options_words(rule), file);
        fputc(')', file);
    } else if (rule->kind != OPTION_FLAG) {
        fprintf(file, "=:%s: ", rule->name);
    }
    fputc('\'', file);
}

static void print_zsh(const struct subcommand *const *table, FILE *file)
{
    fputs("#compdef corgen\n"
          "# SPDX-License-Identifier: MIT\n"
          "# Completion of corgen in zsh, written by: corgen --completion zsh\n"
          "local -a subcommands\n"
          "subcommands=(\n",
          file);
    for (const struct subcommand *const *row = table; *row; row++)
        fprintf(file, "    '%s:%s'\n", (*row)->name, (*row)->summary);
    fprintf(file,
            ")\nif ((CURRENT == 2)); then\n"
            "    _describe subcommand subcommands\n"
            "    compadd -- %s\n    return\n"
            "fi\n"
            "shift words\n"
            "((CURRENT--))\n"
            "case $words[1] in\n"
            "help) _describe subcommand subcommands ;;\n"
            "--completion) compadd -- %s ;;\n",
            other_words, shells);
    for (; *table; table++) {
        fprintf(file, "%s) _arguments '--help'", (*table)->name);
        for (const struct option_rule *rule = (*table)->options; rule->name; rule++)
            print_zsh_option(rule, file);
        fputs(" ;;\n", file);
    }
    fputs("esac\n", file);
}

bool completion_print(const char *shell, const struct subcommand *const *table, FILE *file)
{
    const bool bash = strcmp(shell, "bash") == 0;
    if (!bash && strcmp(shell, "zsh") != 0)
        return false;
    (bash ? print_bash : print_zsh)(table, file);
    return true;
}
