/* SPDX-License-Identifier: MIT */
#include "cli/options.h"

#include <errno.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "disk/modes.h"
#include "series/series.h"
#include "support/console.h"
#include "support/formula.h"
#include "support/local.h"

enum { LONG_OPTION = 256 /* above every char */ };

static const char help_name[] = "help";

const char *const option_formats[] = {[FORMAT_TEXT] = "text", [FORMAT_CSV] = "csv", [FORMAT_JSON] = "json", NULL};
const char *const option_formats_latex[] = {
    [FORMAT_TEXT] = "text", [FORMAT_CSV] = "csv", [FORMAT_JSON] = "json", [FORMAT_LATEX] = "latex", NULL};
const struct option_numbers option_positive = {{"0", NULL, false, false, true, "a finite number above 0"},
                                               DECIMAL_PLAIN};
const struct option_numbers option_not_negative = {{"0", NULL, true, false, true, "a finite number, 0 or more"},
                                                   DECIMAL_PLAIN};
const struct option_numbers option_disk_poisson = {{"-1", "1", false, false, false, "a number between -1 and 1"},
                                                   DECIMAL_SIGN | DECIMAL_RATIO};
const struct option_numbers option_own_exponent = {{"-100", "100", true, true, true, "a number from -100 to 100"},
                                                   DECIMAL_SIGN | DECIMAL_RATIO};
const struct option_numbers option_own_eps = {{"0", "1", true, false, true, "a number from 0 to below 1"},
                                              DECIMAL_PLAIN};
const struct values_rule option_speeds = {
    "speed", {"0", NULL, false, false, true, "a finite number above 0 in m/s"}, false};
_Static_assert(sizeof(enum cor_end) == sizeof(int), "OPTION_WORD fills an int");

static size_t count_rules(const struct option_rule *rules)
{
    size_t n = 0;
    while (rules[n].name)
        n++;
    return n;
}

static bool has_word(const char *words, const char *word)
{
    const size_t n = strlen(word);
    for (const char *at = words; at && (at = strstr(at, word)); at += n)
        if ((at == words || at[-1] == ' ') && (at[n] == ' ' || at[n] == '\0'))
            return true;
    return false;
}

/* ---- values ---- */

static int refuse_real(const char *name, const struct option_numbers *numbers, const char *unit, const char *text)
{
    return usage_error("--%s: '%s' is not %s%s%s; write it as 0.1, 1.5e-3 (up to %d digits in the exponent)%s", name,
                       text, numbers->range.allowed, unit ? " in " : "", unit ? unit : "", DECIMAL_EXPONENT_DIGITS,
                       numbers->forms & DECIMAL_RATIO ? " or 2/3" : "");
}

int options_check_real(const char *name, const struct option_numbers *numbers, const struct decimal *value)
{
    return (value->forms & ~numbers->forms) == 0 && decimal_inside(&numbers->range, value->value)
               ? STATUS_OK
               : refuse_real(name, numbers, NULL, value->text);
}

/* True if the text, of this length, is the unit with a prefix such as G. power: the power of ten of the prefix */
static bool is_unit(int *power, const char *text, size_t length, const char *unit)
{
    static const struct {
        const char *text;
        int power;
    } prefix[] = {{"", 0}, {"n", -9}, {"u", -6}, {"\xc2\xb5", -6}, {"m", -3}, {"c", -2}, {"k", 3}, {"M", 6}, {"G", 9}};
    const bool grams = strncmp(unit, "kg", 2) == 0;
    for (size_t i = 0; i < sizeof prefix / sizeof *prefix; i++) {
        char whole[OPTIONS_MAX_NAME];
        snprintf(whole, sizeof whole, "%s%s", prefix[i].text, grams ? unit + 1 : unit);
        *power = prefix[i].power - (grams ? 3 : 0);
        if (strlen(whole) == length && strncmp(whole, text, length) == 0)
            return true;
    }
    *power = 3; /* 1 g/cm^3 = 10^3 kg/m^3 */
    return strcmp(unit, "kg/m^3") == 0 &&
           ((length == 6 && strncmp(text, "g/cm^3", 6) == 0) || (length == 5 && strncmp(text, "g/cm3", 5) == 0));
}

static const char *unit_of(const struct option_rule *rule)
{
    return !rule->scene ? rule->unit : *rule->scene->unit ? rule->scene->unit : NULL;
}

struct option_numbers options_numbers(const struct option_rule *rule)
{
    static char low[DECIMAL_TEXT], high[DECIMAL_TEXT];
    const struct cor_scene_option *const scene = rule->scene;
    if (rule->kind == OPTION_LIST)
        return (struct option_numbers){rule->range.values->range, DECIMAL_PLAIN};
    if (rule->range.number)
        return *rule->range.number;
    decimal_text(low, scene->least);
    decimal_text(high, scene->largest);
    return (struct option_numbers){
        {low, isinf(scene->largest) ? NULL : high, scene->least_allowed, true, true, scene->allowed},
        scene->least < 0 ? DECIMAL_SIGN : DECIMAL_PLAIN};
}

/* Refuses a number with a unit; the message shows the number to write. Checks only the first number of a list. */
static int check_unit(const struct option_rule *rule, const char *text)
{
    const char *const unit = unit_of(rule);
    if (!unit)
        return STATUS_OK;
    const size_t length = rule->kind == OPTION_LIST ? strcspn(text, ",:") : strlen(text);
    const size_t digits = strspn(text, "0123456789.");
    char *end = (char *)text + digits;
    int exponent = 0, power;
    if (digits > 0 && (*end == 'e' || *end == 'E') && end[1] && strchr("+-0123456789", end[1]))
        exponent = (int)strtol(end + 1, &end, 10);
    end += strspn(end, " ");
    if (digits == 0 || end >= text + length || !is_unit(&power, end, length - (size_t)(end - text), unit))
        return STATUS_OK;
    char number[OPTIONS_MAX_NAME];
    const int size = snprintf(number, sizeof number, "%.*s", (int)digits, text);
    if (power + exponent != 0 && size < (int)sizeof number)
        snprintf(number + size, sizeof number - (size_t)size, "e%d", power + exponent);
    return usage_error("--%s: '%.*s' has a unit; write %s, in %s", rule->name, (int)length, text, number, unit);
}

static int parse_value(void *field, const struct option_rule *rule, const char *text)
{
#define LETTERS "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_"
    const char *const name = rule->name, *const *const words = rule->range.words;
    const size_t length = text ? strlen(text) : 0; /* a flag has no text */
    if (check_unit(rule, text) != STATUS_OK)
        return STATUS_USAGE;
    switch (rule->kind) {
    case OPTION_FLAG:
        *(bool *)field = true;
        return STATUS_OK;
    case OPTION_WHOLE: {
        const slong low = rule->range.whole.low, high = rule->range.whole.high;
        errno = 0;
        const long parsed = strtol(text, NULL, 10);
        if (length == 0 || strspn(text, "0123456789") != length || errno || parsed < low || parsed > high)
            return usage_error("--%s: '%s' is not a whole number from %ld to %ld (%s)", name, text, (long)low,
                               (long)high, rule->why);
        *(slong *)field = parsed;
        return STATUS_OK;
    }
    case OPTION_REAL: {
        const struct option_numbers numbers = options_numbers(rule);
        return decimal_parse(field, text, DECIMAL_EXPONENT_DIGITS) ? options_check_real(name, &numbers, field)
                                                                   : refuse_real(name, &numbers, unit_of(rule), text);
    }
    case OPTION_WORD:
        for (int i = 0; words[i]; i++)
            if (strcmp(text, words[i]) == 0) {
                *(int *)field = i;
                return STATUS_OK;
            }
        return refuse_word(text, words, "", "--%s: '%s' is not %s", name, text, rule->why);
    case OPTION_LIST:
        return values_parse(field, rule->range.values, text);
    case OPTION_C_NAME: /* not a keyword or reserved name of C or C++ */
        if (strspn(text, LETTERS) == 0 || strspn(text, LETTERS "0123456789") != length || length > OPTIONS_MAX_NAME)
            return usage_error("--%s: '%s' is not the name of a C function; allowed: letters, digits and _, up to %d, "
                               "and no digit first",
                               name, text, OPTIONS_MAX_NAME);
        if (c_name_is_reserved(text))
            return usage_error("--%s: C or C++ reserves '%s'; give another name, for example my_eps", name, text);
        break;
    case OPTION_TEXT:
    case OPTION_FILE:
    case OPTION_FOLDER:
    case OPTION_ELASTIC:
        if (length == 0)
            return usage_error("--%s: the name is empty; give a name", name);
    }
    *(const char **)field = text;
    return STATUS_OK;
#undef LETTERS
}

/* True if the number in `text`, which is a valid decimal, is in the range. */
static bool accepts_number(const struct decimal_range *range, const char *text)
{
    struct decimal number = {0};
    decimal_set(&number, text);
    const bool inside = decimal_inside(range, number.value);
    decimal_clear(&number);
    return inside;
}

/* Returns ", for example --NAME VALUE" with a value that the option accepts. Returns "" if only the user can choose a
 * value. The text is static. */
static const char *example_of(const struct option_rule *rule)
{
    static char text[3 * OPTIONS_MAX_NAME];
    const char *value = "";
    char whole[DECIMAL_TEXT];
    if (rule->kind == OPTION_REAL || rule->kind == OPTION_LIST) {
        const bool list = rule->kind == OPTION_LIST;
        const struct option_numbers numbers = options_numbers(rule);
        value = !(list && rule->range.values->whole) && accepts_number(&numbers.range, "0.1") ? "0.1"
                : accepts_number(&numbers.range, "1")                                         ? "1"
                                                                                              : "100";
    } else if (rule->kind == OPTION_WHOLE) {
        const slong low = rule->range.whole.low, high = rule->range.whole.high, usual = 5;
        snprintf(whole, sizeof whole, "%ld", (long)(low > usual ? low : high < usual ? high : usual));
        value = whole;
    } else if (options_words(rule)) {
        value = options_words(rule)[0];
    } else if (rule->kind == OPTION_FILE) {
        value = "FILE";
    } else if (rule->kind == OPTION_C_NAME) {
        value = "my_eps";
    } else if (rule->kind == OPTION_TEXT || rule->kind == OPTION_ELASTIC) {
        return "";
    }
    snprintf(text, sizeof text, ", for example --%s%s%s", rule->name, *value ? " " : "", value);
    return text;
}

/* ---- the command line ---- */

/* Reports the error that getopt has found. */
static int refuse_option(const struct option_rule *rules, int key, char **argv)
{
    const size_t count = count_rules(rules);
    if (key == ':')
        return usage_error("%s needs a value%s; see corgen %s --help", argv[optind - 1],
                           example_of(&rules[optopt - LONG_OPTION]), argv[0]);
    if (optopt >= LONG_OPTION)
        return usage_error("--%s accepts no value; leave out = and the value",
                           optopt == LONG_OPTION + (int)count ? help_name : rules[optopt - LONG_OPTION].name);
    const char short_option[] = {'-', (char)optopt, '\0'}, *const option = optopt ? short_option : argv[optind - 1];
    const char **name = xmalloc((count + 2) * sizeof *name);
    size_t n = 0;
    for (size_t i = 0; i < count; i++)
        name[n++] = rules[i].name;
    name[n++] = help_name;
    name[n] = NULL;
    char word[OPTIONS_MAX_NAME + 1]; /* --NAME=VALUE without dashes and value */
    snprintf(word, sizeof word, "%.*s", (int)strcspn(option, "="), option);
    const int status =
        refuse_word(word + strspn(word, "-"), name, "--", "corgen %s has no option '%s'", argv[0], option);
    free(name);
    return status;
}

/* Reports a missing option, two options that exclude each other, or an option without the one that it needs. */
static int check_given(const struct option_rule *rules, const bool *given, const char *command)
{
    for (size_t i = 0; rules[i].name; i++)
        if (rules[i].required && !given[i])
            return usage_error("corgen %s needs --%s%s; see corgen %s --help", command, rules[i].name,
                               example_of(&rules[i]), command);
    for (size_t i = 0; rules[i].name; i++) {
        if (!given[i])
            continue;
        const struct option_rule *needed = NULL;
        bool met = !rules[i].needs;
        for (size_t j = 0; rules[j].name; j++) {
            if (given[j] && has_word(rules[i].excludes, rules[j].name))
                return usage_error("--%s and --%s exclude each other; see corgen %s --help", rules[j].name,
                                   rules[i].name, command);
            if (rules[i].needs && strcmp(rules[i].needs, rules[j].name) == 0)
                needed = &rules[j];
            met = met || (given[j] && needed == &rules[j]);
        }
        if (!met)
            return usage_error("--%s needs --%s%s; see corgen %s --help", rules[i].name, rules[i].needs,
                               needed ? example_of(needed) : "", command);
    }
    return STATUS_OK;
}

/* Refuses an output that cannot be written, and two names of one file, because one output would replace the other. */
static int check_files(const void *arguments, const struct option_rule *rules, const bool *given)
{
    for (size_t i = 0; rules[i].name; i++)
        for (size_t j = i + 1; rules[j].name && rules[i].kind == OPTION_FILE && given[i]; j++) {
            const bool output = strcmp(rules[j].name, "output") == 0;
            if (rules[j].kind != OPTION_FILE || (!given[j] && !output))
                continue;
            const char *const path = *(const char *const *)((const char *)arguments + rules[i].offset);
            const char *const other =
                given[j] ? *(const char *const *)((const char *)arguments + rules[j].offset) : "/dev/stdout";
            if (output_same_file(path, other))
                return usage_error("--%s and %s%s name the same file, %s; give two different files", rules[i].name,
                                   given[j] ? "--" : "standard ", rules[j].name, path);
        }
    int status = STATUS_OK; /* check all outputs before any computation */
    for (size_t i = 0; rules[i].name && status == STATUS_OK; i++)
        if (rules[i].kind == OPTION_FILE && given[i])
            status = output_check(*(const char *const *)((const char *)arguments + rules[i].offset));
    return status;
}

/* Synonyms of options. Without this list getopt would accept --eps as an abbreviation of --eps-inf. */
static const struct {
    const char *given, *meant;
} synonyms[] = {{"eps", "restitution"}, {"e", "restitution"}, {"cor", "restitution"}, {"mu", "friction"},
                {"nu", "poisson"},      {"youngs", "young"},  {"rho", "density"},     {"velocity", "speed"}};
enum { SYNONYMS = sizeof synonyms / sizeof *synonyms, SYNONYM = 1 << 16 };

static int parse_all(void *arguments, const struct option_rule *rules, const struct option *accepted, bool *given,
                     int argc, char **argv, bool *help)
{
    opterr = 0;
    optind = 1;
    for (int key; (key = getopt_long(argc, argv, ":h", accepted, NULL)) != -1;) {
        if (key == ':' || key == '?')
            return refuse_option(rules, key, argv);
        if (key >= SYNONYM)
            return usage_error("corgen %s has no option '--%s' (did you mean --%s?); see corgen %s --help", argv[0],
                               synonyms[key - SYNONYM].given, synonyms[key - SYNONYM].meant, argv[0]);
        const size_t i = (size_t)(key - LONG_OPTION);
        if (key == 'h' || !rules[i].name) {
            *help = true;
            return STATUS_OK;
        }
        if (given[i])
            return usage_error("--%s is given twice; give it once", rules[i].name);
        given[i] = true;
        const int status = parse_value((char *)arguments + rules[i].offset, &rules[i], optarg);
        if (status != STATUS_OK)
            return status;
    }
    if (optind < argc)
        return usage_error("corgen %s accepts only options, not '%s'; see corgen %s --help", argv[0], argv[optind],
                           argv[0]);
    const int status = check_given(rules, given, argv[0]);
    const struct option_common *const common = arguments;
    if (status == STATUS_OK && common->json_strings && common->format != FORMAT_JSON)
        return usage_error("--json-strings needs --format json; see corgen %s --help", argv[0]);
    return status == STATUS_OK ? check_files(arguments, rules, given) : status;
}

int options_parse(void *arguments, const struct option_rule *rules, int argc, char **argv, bool *help)
{
    const size_t n = count_rules(rules);
    struct option *accepted = xmalloc((n + 2 + SYNONYMS) * sizeof *accepted);
    bool *given = xmalloc((n + 1) * sizeof *given);
    for (size_t i = 0; i < n; i++)
        accepted[i] = (struct option){rules[i].name, rules[i].kind == OPTION_FLAG ? no_argument : required_argument,
                                      NULL, LONG_OPTION + (int)i};
    accepted[n] = (struct option){help_name, no_argument, NULL, LONG_OPTION + (int)n};
    size_t count = n + 1;
    for (size_t k = 0; k < SYNONYMS * n; k++)
        if (strcmp(rules[k % n].name, synonyms[k / n].meant) == 0)
            accepted[count++] = (struct option){synonyms[k / n].given, optional_argument, NULL, SYNONYM + (int)(k / n)};
    accepted[count] = (struct option){0};
    memset(given, 0, n * sizeof *given);
    *help = false;
    int status = parse_all(arguments, rules, accepted, given, argc, argv, help);
    for (size_t i = 0; i < n && !*help && status == STATUS_OK; i++)
        if (rules[i].kind == OPTION_ELASTIC) {
            struct option_law *const law = (void *)((char *)arguments + rules[i].offset);
            const char *const a = law->elastic ? law->elastic : "3/2", *const b = law->damping ? law->damping : "1/2";
            const char *const wrong = law_parse(&law->exponents, a, b);
            status = wrong ? usage_error("--elastic %s --damping %s: %s", a, b, wrong) : STATUS_OK;
        }
    free(accepted);
    free(given);
    return status;
}

void options_clear(void *arguments, const struct option_rule *rules)
{
    for (const struct option_rule *rule = rules; rule->name; rule++) {
        void *const field = (char *)arguments + rule->offset;
        if (rule->kind == OPTION_REAL)
            decimal_clear(field);
        else if (rule->kind == OPTION_LIST)
            values_clear(field);
    }
}

const char *const *options_words(const struct option_rule *rule)
{
    return rule->kind == OPTION_WORD || rule->kind == OPTION_TEXT ? rule->range.words : NULL;
}

/* ---- shared by subcommands ---- */

double options_number(const struct decimal *given, double otherwise)
{
    return given->text ? decimal_value(given) : otherwise;
}

int options_disk_poisson(const struct decimal *poisson)
{
    struct decimal least = {0};
    LOCAL(fmpq, below, above);
    decimal_set(&least, DISK_MARGIN);
    EXACT(below, "1 - poisson->value - least.value", poisson->value, least.value);
    EXACT(above, "1 + poisson->value - least.value", poisson->value, least.value);
    decimal_clear(&least);
    const bool apart = fmpq_sgn(below) > 0 && fmpq_sgn(above) > 0;
    return apart ? STATUS_OK
                 : usage_error("--poisson: '%s' is closer than " DISK_MARGIN " to -1 or 1, where a disk has no modes",
                               poisson->text);
}
