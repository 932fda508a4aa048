/* SPDX-License-Identifier: MIT */
/* Command-line options as data. A subcommand lists its options, each with the field of its struct of arguments that the
 * option fills. options_parse() reads them. */
#ifndef COR_GEN_CLI_OPTIONS_H
#define COR_GEN_CLI_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "cor/scene.h"
#include "series/law.h"
#include "support/decimal.h"
#include "support/output.h"
#include "sweep/values.h"

#define OPTIONS_MAX_NAME 63
#define OPTIONS_NOT_GIVEN (-1)

/* The kind of an option's value, and the type of the field that it fills */
enum option_kind {
    OPTION_FLAG,   /* no value; bool */
    OPTION_WHOLE,  /* an integer in the range `whole`; slong */
    OPTION_REAL,   /* a number in the range `number`; struct decimal */
    OPTION_WORD,   /* one of `words`; the field is the index as an int, or an enum of that size */
    OPTION_LIST,   /* a list according to `values`; struct values */
    OPTION_TEXT,   /* any nonempty text; const char *. range.words: words that a shell completes, or NULL */
    OPTION_FILE,   /* the name of an output; const char * */
    OPTION_FOLDER, /* the name of a folder; const char * */
    OPTION_C_NAME, /* an identifier of C; const char * */
    OPTION_ELASTIC /* the elastic exponent; struct option_law, whose member `damping` is filled by another option */
};

struct option_numbers {
    struct decimal_range range;
    enum decimal_forms forms; /* allowed forms of the text */
};

struct option_rule {
    const char *name; /* name without dashes; NULL ends a list */
    enum option_kind kind;
    bool required;
    size_t offset; /* offset of the field in the struct of arguments */
    union {
        struct {
            slong low, high;
        } whole;
        const struct option_numbers *number;
        const char *const *words; /* ends with NULL */
        const struct values_rule *values;
    } range;
    const struct cor_scene_option *scene; /* row of cor_scene_options with the option's unit and range; NULL: none */
    const char *unit;                     /* unit of a number, such as "Pa"; NULL: no unit */
    const char *why;      /* for messages: the reason for an upper limit, or the kind of the words, such as "a type" */
    const char *excludes; /* options that contradict this one, space separated, or NULL */
    const char *needs;    /* the option that this one requires, or NULL */
};

/* Arguments of every subcommand; the first member of its struct of arguments */
struct option_common {
    int format;         /* enum output_format */
    const char *output; /* file, or directory for `tables`; NULL: standard output */
    bool json_strings;
    bool profile;
};

/* OPTION defines a rule; ... are initialisers of more members of option_rule. OPTION_PLAIN has no further members.
 * ARGUMENTS is the struct of arguments of the subcommand, whose first member is `common`. */
#define OPTION(NAME, KIND, FIELD, ...)                                                                                 \
    {                                                                                                                  \
        .name = (NAME), .kind = OPTION_##KIND, .offset = offsetof(ARGUMENTS, FIELD), __VA_ARGS__                       \
    }
#define OPTION_PLAIN(NAME, KIND, FIELD) OPTION(NAME, KIND, FIELD, .why = NULL)

/* Rules that several subcommands share. OPTION_COMMON and OPTION_LAST end the list. */
#define OPTION_COMMON OPTION_PLAIN("output", FILE, common.output), OPTION_LAST
#define OPTION_LAST                                                                                                    \
    OPTION_PLAIN("profile", FLAG, common.profile),                                                                     \
    {                                                                                                                  \
        .name = NULL                                                                                                   \
    }
#define OPTION_FORMAT(WORDS) OPTION("format", WORD, common.format, .range.words = (WORDS), .why = "a format")
#define OPTION_JSON_STRINGS OPTION("json-strings", FLAG, common.json_strings, .needs = "format")
#define OPTION_DIGITS                                                                                                  \
    OPTION("digits", WHOLE, digits, .range.whole = {1, OPTIONS_MAX_DIGITS}, .why = "more digits would take too long")
#define OPTION_END_OF(FIELD, WORDS) OPTION("end", WORD, FIELD, .range.words = (WORDS), .why = "an end of contact")
#define OPTION_END(FIELD) OPTION_END_OF(FIELD, contact_end_options)
#define OPTION_LAW OPTION_PLAIN("elastic", ELASTIC, law), OPTION_PLAIN("damping", TEXT, law.damping)
#define OPTION_COUNT_WHY "the time grows like the power 3/2 of the count; more modes take over ten hours"

#define OPTIONS_MAX_DIGITS 10000000
#define OPTIONS_DEFAULT_DIGITS 20

extern const char *const option_formats[];       /* text, csv, json */
extern const char *const option_formats_latex[]; /* text, csv, json, latex */
extern const struct option_numbers option_positive, option_not_negative, option_disk_poisson, option_own_exponent,
    option_own_eps;
extern const struct values_rule option_speeds; /* m/s */

/* Texts of a law's two exponents (NULL: the sphere's exponent), and the law that options_parse makes from them */
struct option_law {
    const char *elastic, *damping;
    struct cor_exponents exponents;
};

/* Fills *arguments and *help from argv[1], ... Returns STATUS_OK, STATUS_USAGE after a message that names the command
 * argv[0], or STATUS_FAILED after a message about a file that cannot be written. In all cases options_clear() frees the
 * memory that the fields own. */
int options_parse(void *arguments, const struct option_rule *rules, int argc, char **argv, bool *help);
void options_clear(void *arguments, const struct option_rule *rules);

/* Returns the range of a number, OPTION_REAL or OPTION_LIST. Its texts are valid until the next call. */
struct option_numbers options_numbers(const struct option_rule *rule);

/* Returns the words that a shell completes for an option, or NULL. */
const char *const *options_words(const struct option_rule *rule);

double options_number(const struct decimal *given, double otherwise); /* nearest double, or `otherwise` without text */

/* Return STATUS_OK, or STATUS_USAGE after a message. */
int options_check_real(const char *name, const struct option_numbers *numbers, const struct decimal *value);
int options_disk_poisson(const struct decimal *poisson); /* refuses values too close to -1 or 1 */

/* ---- subcommands of corgen, the rows of the table in main.c ---- */

struct subcommand {
    const char *name;
    const char *summary;
    const char *help; /* full text of --help: usage, options, output columns, example */
    const struct option_rule *options;
    size_t size;                       /* size of its struct of arguments, which begins with struct option_common */
    const void *defaults;              /* values of the struct's members if their options are not given */
    int (*run)(const void *arguments); /* exit status */
};

/* Defines the subcommand of a file that has ARGUMENTS, help, options and run_NAME. ...: the defaults of its options */
#define SUBCOMMAND(NAME, WORD, SUMMARY, ...)                                                                           \
    const struct subcommand command_##NAME = {                                                                         \
        WORD, SUMMARY, help, options, sizeof(ARGUMENTS), &(const ARGUMENTS){__VA_ARGS__}, run_##NAME}

/* Parts of help texts. A form feed is replaced by help_contact, the options of a contact. */
extern const char help_contact[];
#define HELP_LAW                                                                                                       \
    "  --elastic A, --damping B   exponents of x'' + beta x^B x' + x^A = 0, 0 to 24, such as 3/2 or 1.5\n"             \
    "                             (default 3/2 and 1/2, viscoelastic spheres)\n"
#define HELP_DIGITS "  --digits D       number of significant digits, all proved, 1 to 10000000 (default 20)\n"
#define HELP_JSON_STRINGS "  --json-strings   print json numbers that have more digits than a double as strings\n"
#define HELP_END "  --end E          end of contact, zero-overlap or zero-force (default zero-overlap)\n"
#define HELP_COMMON                                                                                                    \
    "  --output FILE    file for the output, changed only if everything succeeds (default standard output)\n"          \
    "  --profile        print the seconds of each step and the peak memory on standard error\n"

/* Chooses a subcommand from a table that ends with NULL, and runs it. Returns the exit status. */
int subcommand_run(const struct subcommand *const *table, const char *version, int argc, char **argv);

/* Prints corgen --help: the subcommands grouped by the user's task, and the terms of all help texts. Omits the
 * subcommands that are not in the table, and their examples. */
void overview_print(const struct subcommand *const *table, FILE *file);

/* Writes the script of completions for a shell, bash or zsh, from the tables of subcommands and options. Returns false
 * for another shell. */
bool completion_print(const char *shell, const struct subcommand *const *table, FILE *file);

/* A table of proved digits. proved_table_write fills it with more and more bits until every digit is decided, and
 * prints it. A table of exact numbers is filled once. */
enum { PROVED_TABLE_NAME = 64 };

struct proved_table {
    slong digits;
    const void *arguments; /* for `fill` */
    /* Initialises a table and fills it, computing with `bits` bits. Returns STATUS_OK or STATUS_FAILED. `undecided`
     * stays empty, or becomes the name of the first number whose digits are undecided. */
    int (*fill)(struct table *table, char undecided[PROVED_TABLE_NAME], const void *arguments, slong bits);
    /* prints FORMAT_TEXT and FORMAT_LATEX; NULL: the common text format */
    void (*print_text)(FILE *file, const struct table *table, const void *arguments);
};

/* Returns the exit status. */
int proved_table_write(const struct proved_table *proved, const struct option_common *common);

#endif
