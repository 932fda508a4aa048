/* SPDX-License-Identifier: MIT */
#include "options.h"

#include <errno.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "console.h"

enum { NAMES_MAX = 256, BETA_EXPONENT_DIGITS_MAX = 6, LONG_OPTION = 256 };

enum key {
    KEY_ORDER,
    KEY_TERMS,
    KEY_DIGITS,
    KEY_NUMERATOR,
    KEY_DENOMINATOR,
    KEY_BETA,
    KEY_END,
    KEY_FORMAT,
    KEY_ELASTIC,
    KEY_DAMPING,
    KEY_OUTPUT,
    KEY_HEADER,
    KEY_EXACT,
    KEY_TWO_POINT,
    KEY_AS_PUBLISHED,
    KEY_CHECK,
    KEY_FORCE,
    KEY_PROFILE,
    KEY_HELP
};

struct rule {
    const char *name;
    enum key key;
    bool argument;
    slong low, high; /* of whole numbers */
    const char *why; /* there is an upper limit */
};

static const struct rule rules[] = {
    {"order", KEY_ORDER, true, 0, OPTIONS_MAX_ORDER,
     "an order needs all below it, and their cost grows faster than its cube"},
    {"terms", KEY_TERMS, true, 0, OPTIONS_MAX_TERMS, "the exact rationals of more terms outgrow any memory"},
    {"digits", KEY_DIGITS, true, 1, OPTIONS_MAX_DIGITS, "the arithmetic of more digits outgrows any patience"},
    {"numerator", KEY_NUMERATOR, true, 0, OPTIONS_MAX_DEGREE, "a degree needs a linear system of that size"},
    {"denominator", KEY_DENOMINATOR, true, 0, OPTIONS_MAX_DEGREE, "a degree needs a linear system of that size"},
    {"beta", KEY_BETA, true, 0, 0, NULL},
    {"end", KEY_END, true, 0, 0, NULL},
    {"format", KEY_FORMAT, true, 0, 0, NULL},
    {"elastic", KEY_ELASTIC, true, 0, 0, NULL},
    {"damping", KEY_DAMPING, true, 0, 0, NULL},
    {"output", KEY_OUTPUT, true, 0, 0, NULL},
    {"header", KEY_HEADER, true, 0, 0, NULL},
    {"exact", KEY_EXACT, false, 0, 0, NULL},
    {"two-point", KEY_TWO_POINT, false, 0, 0, NULL},
    {"as-published", KEY_AS_PUBLISHED, false, 0, 0, NULL},
    {"check", KEY_CHECK, false, 0, 0, NULL},
    {"force", KEY_FORCE, false, 0, 0, NULL},
    {"profile", KEY_PROFILE, false, 0, 0, NULL},
    {"help", KEY_HELP, false, 0, 0, NULL},
};
enum { RULES = sizeof rules / sizeof *rules };

static bool has_word(const char *words, const char *word)
{
    size_t n = strlen(word);
    for (const char *at = words; (at = strstr(at, word)); at += n) {
        if ((at == words || at[-1] == ' ') && (at[n] == ' ' || at[n] == '\0'))
            return true;
    }
    return false;
}

/* "a b c" -> "<prefix>a, <prefix>b, <prefix>c" */
static const char *listed(char text[NAMES_MAX], const char *words, const char *prefix)
{
    size_t n = 0;
    const char *before = "";
    while (*words && n + 1 < NAMES_MAX) {
        int length = (int)strcspn(words, " ");
        n += (size_t)snprintf(text + n, NAMES_MAX - n, "%s%s%.*s", before, prefix, length, words);
        words += length;
        words += strspn(words, " ");
        before = ", ";
    }
    return text;
}

static int parse_whole(slong *value, const struct rule *rule, const char *text)
{
    char *end;
    errno = 0;
    long parsed = strtol(text, &end, 10);
    bool digits_only = *text && text[strspn(text, "0123456789")] == '\0';
    if (!digits_only || errno || parsed < rule->low || parsed > rule->high)
        return usage_error("--%s: '%.60s' is not a whole number from %ld to %ld (%s)", rule->name, text,
                           (long)rule->low, (long)rule->high, rule->why);
    *value = parsed;
    return STATUS_OK;
}

/* beta: "p/q", or digits with an optional point and an optional decimal exponent. */

static const char *skip_digits(const char *text)
{
    return text + strspn(text, "0123456789");
}

static const char *skip_decimal(const char *text)
{
    const char *whole = text;
    text = skip_digits(text);
    ptrdiff_t digits = text - whole;
    if (*text == '.') {
        const char *fraction = ++text;
        text = skip_digits(text);
        digits += text - fraction;
    }
    if (digits == 0)
        return NULL;
    if (*text == 'e' || *text == 'E') {
        text++;
        if (*text == '+' || *text == '-')
            text++;
        const char *exponent = text;
        text = skip_digits(text);
        if (text == exponent || text - exponent > BETA_EXPONENT_DIGITS_MAX)
            return NULL;
    }
    return text;
}

static bool beta_is_well_formed(const char *text)
{
    const char *slash = strchr(text, '/');
    if (slash) {
        const char *end = skip_digits(slash + 1);
        return skip_digits(text) == slash && slash != text && end != slash + 1 && *end == '\0' &&
               slash[1 + strspn(slash + 1, "0")] != '\0';
    }
    const char *end = skip_decimal(text);
    return end && *end == '\0';
}

void options_beta(arb_t beta, const struct options *o, slong prec)
{
    if (strchr(o->beta, '/')) {
        fmpq_t ratio;
        fmpq_init(ratio);
        fmpq_set_str(ratio, o->beta, 10);
        fmpq_canonicalise(ratio);
        arb_set_fmpq(beta, ratio, prec);
        fmpq_clear(ratio);
    } else {
        arb_set_str(beta, o->beta, prec);
    }
}

static int parse_beta(struct options *o, const char *text)
{
    o->beta = text;
    bool good = beta_is_well_formed(text);
    if (good) {
        /* Enough bits to see every digit of the text: then only an exact tie is left undecided. */
        slong prec = 4 * (slong)strlen(text) + 64;
        arb_t beta, limit;
        arb_init(beta);
        arb_init(limit);
        options_beta(beta, o, prec);
        arb_set_str(limit, OPTIONS_MAX_BETA, prec);
        good = arb_is_finite(beta) && !arb_gt(beta, limit);
        arb_clear(beta);
        arb_clear(limit);
    }
    if (!good)
        return usage_error("--beta: '%.60s' is not a number from 0 to " OPTIONS_MAX_BETA
                           " written as 0.1, 1.5e-3 (exponent of at most %d digits) or 2/3",
                           text, BETA_EXPONENT_DIGITS_MAX);
    return STATUS_OK;
}

static int parse_end(struct options *o, const char *text)
{
    if (strcmp(text, "zero-overlap") == 0)
        o->end = END_ZERO_OVERLAP;
    else if (strcmp(text, "zero-force") == 0)
        o->end = END_ZERO_FORCE;
    else
        return usage_error("--end: '%.60s' is not an end of contact; allowed: zero-overlap, "
                           "zero-force",
                           text);
    return STATUS_OK;
}

static int parse_format(struct options *o, const struct subcommand *cmd, const char *text)
{
    static const char *const name[] = {
        [FORMAT_TEXT] = "text", [FORMAT_CSV] = "csv", [FORMAT_JSON] = "json", [FORMAT_LATEX] = "latex"};
    for (size_t i = 0; i < sizeof name / sizeof *name; i++) {
        if (strcmp(text, name[i]) == 0 && has_word(cmd->formats, text)) {
            o->format = (enum output_format)i;
            return STATUS_OK;
        }
    }
    char names[NAMES_MAX];
    return usage_error("--format: '%.60s' is not a format of corgen %s; allowed: %s", text, cmd->name,
                       listed(names, cmd->formats, ""));
}

static int parse_one(struct options *o, const struct subcommand *cmd, const struct rule *rule, const char *text)
{
    switch (rule->key) {
    case KEY_ORDER:
        return parse_whole(&o->order, rule, text);
    case KEY_TERMS:
        return parse_whole(&o->terms, rule, text);
    case KEY_DIGITS:
        return parse_whole(&o->digits, rule, text);
    case KEY_NUMERATOR:
        return parse_whole(&o->numerator, rule, text);
    case KEY_DENOMINATOR:
        return parse_whole(&o->denominator, rule, text);
    case KEY_BETA:
        return parse_beta(o, text);
    case KEY_END:
        return parse_end(o, text);
    case KEY_FORMAT:
        return parse_format(o, cmd, text);
    case KEY_OUTPUT:
    case KEY_HEADER:
        if (*text == '\0')
            return usage_error("--%s: the name is empty", rule->name);
        *(rule->key == KEY_OUTPUT ? &o->output : &o->header) = text;
        break;
    case KEY_EXACT:
        o->exact = true;
        break;
    case KEY_TWO_POINT:
        o->two_point = true;
        break;
    case KEY_AS_PUBLISHED:
        o->as_published = true;
        break;
    case KEY_CHECK:
        o->check = true;
        break;
    case KEY_FORCE:
        o->force = true;
        break;
    case KEY_PROFILE:
        o->profile = true;
        break;
    case KEY_ELASTIC:
    case KEY_DAMPING:
    case KEY_HELP:
        break; /* the caller's: the law needs both its numbers, help ends the parsing */
    }
    return STATUS_OK;
}

static const struct rule *rule_of(int key)
{
    const struct rule *rule = rules;
    while ((int)rule->key != key)
        rule++;
    return rule;
}

int options_parse(struct options *o, const struct subcommand *cmd, int argc, char **argv, bool *help)
{
    /* getopt may complete abbreviations, so it is shown only what this subcommand takes. */
    struct option accepted[RULES + 1] = {{0}};
    int n = 0;
    for (int i = 0; i < RULES; i++) {
        if (rules[i].key == KEY_HELP || has_word(cmd->accepts, rules[i].name))
            accepted[n++] = (struct option){rules[i].name, rules[i].argument ? required_argument : no_argument, NULL,
                                            (int)rules[i].key + LONG_OPTION};
    }

    *o = (struct options){.numerator = OPTIONS_NOT_GIVEN,
                          .denominator = OPTIONS_NOT_GIVEN,
                          .digits = OPTIONS_DEFAULT_DIGITS,
                          .end = END_ZERO_OVERLAP};
    *help = false;
    const char *elastic = "3/2";
    const char *damping = "1/2";
    bool given[RULES] = {false};
    char names[NAMES_MAX];

    opterr = 0;
    optind = 1;
    int key;
    while ((key = getopt_long(argc, argv, ":", accepted, NULL)) != -1) {
        if (key == ':')
            return usage_error("%s needs a value; see corgen %s --help", argv[optind - 1], cmd->name);
        if (key == '?' && optopt >= LONG_OPTION)
            return usage_error("--%s takes no value", rule_of(optopt - LONG_OPTION)->name);
        if (key == '?') {
            const char short_option[] = {'-', (char)optopt, '\0'};
            return usage_error("corgen %s does not know '%.60s'; allowed: %s, --help", cmd->name,
                               optopt ? short_option : argv[optind - 1], listed(names, cmd->accepts, "--"));
        }
        const struct rule *rule = rule_of(key - LONG_OPTION);
        given[rule->key] = true;
        if (rule->key == KEY_HELP) {
            *help = true;
            return STATUS_OK;
        }
        if (rule->key == KEY_ELASTIC)
            elastic = optarg;
        if (rule->key == KEY_DAMPING)
            damping = optarg;
        int status = parse_one(o, cmd, rule, optarg);
        if (status != STATUS_OK)
            return status;
    }
    if (optind < argc)
        return usage_error("corgen %s takes options only, not '%.60s'; see corgen %s --help", cmd->name, argv[optind],
                           cmd->name);
    for (int i = 0; i < RULES; i++) {
        if (has_word(cmd->requires_, rules[i].name) && !given[rules[i].key])
            return usage_error("corgen %s needs --%s; see corgen %s --help", cmd->name, rules[i].name, cmd->name);
    }

    const char *wrong = law_parse(&o->law, elastic, damping);
    if (wrong)
        return usage_error("--elastic %.60s --damping %.60s: %s", elastic, damping, wrong);
    return STATUS_OK;
}
