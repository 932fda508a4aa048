/* SPDX-License-Identifier: MIT */
#include "cli/options.h"

#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "disk/equation.h"
#include "support/console.h"
#include "sweep/crew.h"
#include "sweep/sweep.h"

enum { NAMES_MAX = 512, EXPONENT_DIGITS_MAX = 6, LONG_OPTION = 256 };

enum key {
    KEY_ORDER,
    KEY_TERMS,
    KEY_DIGITS,
    KEY_COUNT,
    KEY_MODES,
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
    KEY_ALL,
    KEY_SEED,
    KEY_FORCE,
    KEY_PROFILE,
    KEY_TYPE,
    KEY_NAME,
    KEY_FOR,
    KEY_WALL,
    KEY_SPEED,
    KEY_ALPHA,
    KEY_PHI_POINTS,
    KEY_THREADS,
    KEY_DISKS,
    KEY_QUANTITY,
    KEY_POINTS,
    KEY_HELP,
    KEY_REAL /* and as many as there are in enum options_real */
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
    {"count", KEY_COUNT, true, 1, OPTIONS_MAX_COUNT, "the time grows like the power 3/2 of it, past ten hours"},
    {"modes", KEY_MODES, true, 1, OPTIONS_MAX_COUNT, "the time grows like the power 3/2 of it, past ten hours"},
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
    {"all", KEY_ALL, false, 0, 0, NULL},
    {"seed", KEY_SEED, true, 0, OPTIONS_MAX_SEED, "there are no more samples than that"},
    {"force", KEY_FORCE, false, 0, 0, NULL},
    {"profile", KEY_PROFILE, false, 0, 0, NULL},
    {"type", KEY_TYPE, true, 0, 0, NULL},
    {"name", KEY_NAME, true, 0, 0, NULL},
    {"for", KEY_FOR, true, 0, 0, NULL},
    {"wall", KEY_WALL, false, 0, 0, NULL},
    {"speed", KEY_SPEED, true, 0, 0, NULL},
    {"alpha", KEY_ALPHA, true, 0, 0, NULL},
    {"phi-points", KEY_PHI_POINTS, true, 1, COR_DISK_COLLISION_MAX_PHI_POINTS, "walls that need more are not computed"},
    {"threads", KEY_THREADS, true, 1, CREW_MAX_THREADS, "no machine has use for more"},
    {"disks", KEY_DISKS, false, 0, 0, NULL},
    {"quantity", KEY_QUANTITY, true, 0, 0, NULL},
    {"points", KEY_POINTS, true, 2, OPTIONS_MAX_POINTS, "every point takes collisions"},
    {"help", KEY_HELP, false, 0, 0, NULL},
    {"speed-min", KEY_REAL + OPTIONS_SPEED_MIN, true, 0, 0, NULL},
    {"speed-max", KEY_REAL + OPTIONS_SPEED_MAX, true, 0, 0, NULL},
    {"tolerance", KEY_REAL + OPTIONS_TOLERANCE, true, 0, 0, NULL},
    {"g-star", KEY_REAL + OPTIONS_G_STAR, true, 0, 0, NULL},
    {"young", KEY_REAL + OPTIONS_YOUNG, true, 0, 0, NULL},
    {"poisson", KEY_REAL + OPTIONS_POISSON, true, 0, 0, NULL},
    {"radius", KEY_REAL + OPTIONS_RADIUS, true, 0, 0, NULL},
    {"density", KEY_REAL + OPTIONS_DENSITY, true, 0, 0, NULL},
    {"mass", KEY_REAL + OPTIONS_MASS, true, 0, 0, NULL},
    {"dissipation-time", KEY_REAL + OPTIONS_DISSIPATION_TIME, true, 0, 0, NULL},
    {"young-2", KEY_REAL + OPTIONS_YOUNG_2, true, 0, 0, NULL},
    {"poisson-2", KEY_REAL + OPTIONS_POISSON_2, true, 0, 0, NULL},
    {"radius-2", KEY_REAL + OPTIONS_RADIUS_2, true, 0, 0, NULL},
    {"density-2", KEY_REAL + OPTIONS_DENSITY_2, true, 0, 0, NULL},
    {"mass-2", KEY_REAL + OPTIONS_MASS_2, true, 0, 0, NULL},
    {"dissipation-time-2", KEY_REAL + OPTIONS_DISSIPATION_TIME_2, true, 0, 0, NULL},
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

/* beta and a disk's nu: "p/q", or digits with an optional point and an optional decimal exponent. */

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
        if (text == exponent || text - exponent > EXPONENT_DIGITS_MAX)
            return NULL;
    }
    return text;
}

bool options_number_is_good(const char *text)
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
    bool good = options_number_is_good(text);
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
                           text, EXPONENT_DIGITS_MAX);
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

static const struct rule *rule_of(int key)
{
    const struct rule *rule = rules;
    while ((int)rule->key != key)
        rule++;
    return rule;
}

const char *options_real_name(enum options_real which)
{
    return rule_of(KEY_REAL + (int)which)->name;
}

void options_real(arb_t x, const struct options *o, enum options_real which, slong prec)
{
    arb_set_str(x, o->real[which], prec);
}

void options_fraction(fmpq_t x, const char *text)
{
    if (strchr(text, '/')) {
        fmpq_set_str(x, text, 10);
        fmpq_canonicalise(x);
        return;
    }
    /* digits and a power of ten */
    char *digits = xmalloc(strlen(text) + 1);
    size_t n = 0;
    slong exponent = 0;
    bool point = false;
    for (; *text && *text != 'e' && *text != 'E'; text++) {
        if (*text == '.') {
            point = true;
        } else {
            digits[n++] = *text;
            exponent -= point;
        }
    }
    digits[n] = '\0';
    if (*text)
        exponent += strtol(text + 1, NULL, 10);
    fmpz_set_str(fmpq_numref(x), digits, 10);
    fmpz_one(fmpq_denref(x));
    fmpz_t power;
    fmpz_init(power);
    fmpz_ui_pow_ui(power, 10, exponent < 0 ? (ulong)-exponent : (ulong)exponent);
    if (exponent < 0)
        fmpq_div_fmpz(x, x, power);
    else
        fmpq_mul_fmpz(x, x, power);
    fmpz_clear(power);
    free(digits);
}

/* Of a disk in plane stress: any between -1 and 1, as exact as it is written. */
static int parse_poisson(struct options *o, const struct rule *rule, const char *text)
{
    bool inside = options_number_is_good(text + (*text == '-')), apart = false;
    o->real[OPTIONS_POISSON] = text;
    if (inside) {
        fmpq_t margin;
        arb_t x, limit;
        fmpq_init(margin);
        arb_init(x);
        arb_init(limit);
        options_fraction(margin, text);
        fmpq_abs(margin, margin);
        fmpq_sub_si(margin, margin, 1);
        fmpq_neg(margin, margin);
        inside = fmpq_sgn(margin) > 0;
        arb_set_fmpq(x, margin, 64);
        arb_set_str(limit, DISK_MARGIN, 64);
        apart = arb_gt(x, limit);
        fmpq_clear(margin);
        arb_clear(x);
        arb_clear(limit);
    }
    if (!inside)
        return usage_error("--%s: '%.60s' is not a number between -1 and 1, written as 0.33, -2e-1 or 1/3", rule->name,
                           text);
    if (!apart)
        return usage_error("--%s: '%.60s' is nearer than " DISK_MARGIN " to -1 or 1, where a disk has no modes",
                           rule->name, text);
    return STATUS_OK;
}

/* A positive number; Poisson's ratio is between -1 and 1/2, and bodies may have no dissipation. */
static int parse_real(struct options *o, const struct rule *rule, const char *text)
{
    const enum options_real which = (enum options_real)(rule->key - KEY_REAL);
    const bool poisson = which == OPTIONS_POISSON || which == OPTIONS_POISSON_2;
    const bool zero = poisson || which == OPTIONS_DISSIPATION_TIME || which == OPTIONS_DISSIPATION_TIME_2;
    const char *end = skip_decimal(text + (poisson && *text == '-'));
    bool good = end && *end == '\0';
    if (good) {
        const double value = strtod(text, NULL);
        good = poisson ? value > -1 && value <= 0.5 : value >= 0 && value < HUGE_VAL && (zero || value > 0);
    }
    if (!good)
        return usage_error("--%s: '%.60s' is not %s, written as 0.1 or 1.5e-3", rule->name, text,
                           poisson ? "a number above -1 and up to 0.5"
                           : zero  ? "a finite number, 0 or more"
                                   : "a finite number above 0");
    o->real[which] = text;
    return STATUS_OK;
}

/* A name of C, long enough to say something. */
static int parse_name(struct options *o, const char *text)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
    char all[sizeof letters + 10];
    snprintf(all, sizeof all, "%s0123456789", letters);
    const size_t length = strlen(text);
    if (!*text || !strchr(letters, *text) || strspn(text, all) != length || length > OPTIONS_MAX_NAME ||
        strncmp(text, "__", 2) == 0 || (*text == '_' && text[1] >= 'A' && text[1] <= 'Z'))
        return usage_error("--name: '%.60s' is not a name for a function of C, letters, digits and _, %d at most", text,
                           OPTIONS_MAX_NAME);
    o->name = text;
    return STATUS_OK;
}

/* One of the words of `allowed`: its place among them, or -1. */
static int place_of(const char *word, const char *const *allowed, int count)
{
    for (int i = 0; i < count; i++)
        if (strcmp(word, allowed[i]) == 0)
            return i;
    return -1;
}

static int parse_type(struct options *o, const char *text)
{
    static const char *const types[] = {"double", "float"};
    const int place = place_of(text, types, 2);
    if (place < 0)
        return usage_error("--type: '%.60s' is not a type; allowed: double, float", text);
    o->single = place == 1;
    return STATUS_OK;
}

static int parse_use(struct options *o, const char *text)
{
    static const char *const uses[] = {"balanced", "scalar", "array"};
    const int place = place_of(text, uses, 3);
    if (place < 0)
        return usage_error("--for: '%.60s' is not a use; allowed: balanced, scalar, array", text);
    o->use = (enum options_use)place;
    return STATUS_OK;
}

static int parse_quantity(struct options *o, const char *text)
{
    static const char *const quantities[] = {"eps", "contact-time", "compression"};
    const int place = place_of(text, quantities, 3);
    if (place < 0)
        return usage_error("--quantity: '%.60s' is not a quantity; allowed: eps, contact-time, compression", text);
    o->quantity = (enum options_quantity)place;
    return STATUS_OK;
}

/* corgen plan, when all of the line is known: what goes with --disks, and with spheres, and whose --poisson it is. */
static int parse_plan(struct options *o, const bool *given)
{
    static const enum key of_spheres[] = {KEY_END, KEY_FOR, KEY_WALL};
    if (!o->disks) {
        if (given[KEY_QUANTITY])
            return usage_error("--quantity is for --disks");
        return o->real[OPTIONS_POISSON] ? parse_real(o, rule_of(KEY_REAL + OPTIONS_POISSON), o->real[OPTIONS_POISSON])
                                        : STATUS_OK;
    }
    for (size_t i = 0; i < sizeof of_spheres / sizeof *of_spheres; i++)
        if (given[of_spheres[i]])
            return usage_error("--disks and --%s exclude each other", rule_of((int)of_spheres[i])->name);
    for (int which = OPTIONS_G_STAR; which < OPTIONS_REALS; which++)
        if (o->real[which] && which != OPTIONS_POISSON)
            return usage_error("--disks and --%s exclude each other; a disk has --poisson alone",
                               options_real_name((enum options_real)which));
    if (!o->real[OPTIONS_POISSON])
        return usage_error("corgen plan --disks needs --poisson; see corgen plan --help");
    return parse_poisson(o, rule_of(KEY_REAL + OPTIONS_POISSON), o->real[OPTIONS_POISSON]);
}

/* A list of disk-collide is parsed here to be found good, and there to be used. */
static int parse_list(struct options *o, enum options_list which, const struct values_rule *rule, const char *text)
{
    struct values values;
    const int status = values_parse(&values, rule, text);
    values_clear(&values);
    o->list[which] = text;
    return status;
}

static int parse_collision_tolerance(struct options *o, const char *text)
{
    const char *end = skip_decimal(text);
    const double value = end && *end == '\0' ? strtod(text, NULL) : 0;
    if (!(value >= COR_DISK_COLLISION_MIN_TOLERANCE && value < 1))
        return usage_error("--tolerance: '%.60s' is not a number from %g to below 1, written as 0.001 or 1e-10", text,
                           COR_DISK_COLLISION_MIN_TOLERANCE);
    o->collision_tolerance = value;
    return STATUS_OK;
}

/* What disk-collide takes by a name that another subcommand has for something else; -1: nothing. */
static int parse_collision(struct options *o, const struct rule *rule, const char *text)
{
    switch ((int)rule->key) {
    case KEY_MODES:
        return parse_list(o, OPTIONS_LIST_MODES, &sweep_modes, text);
    case KEY_REAL + OPTIONS_POISSON:
        return parse_list(o, OPTIONS_LIST_POISSON, &sweep_poisson, text);
    case KEY_REAL + OPTIONS_TOLERANCE:
        return parse_collision_tolerance(o, text);
    default:
        return -1;
    }
}

static int parse_one(struct options *o, const struct subcommand *cmd, const struct rule *rule, const char *text)
{
    if (has_word(cmd->accepts, "alpha")) {
        const int status = parse_collision(o, rule, text);
        if (status >= 0)
            return status;
    }
    if (rule->key == KEY_REAL + OPTIONS_POISSON && has_word(cmd->accepts, "disks")) {
        o->real[OPTIONS_POISSON] = text; /* of which body, parse_plan knows */
        return STATUS_OK;
    }
    /* without materials in space it is a disk that is asked for */
    if (rule->key == KEY_REAL + OPTIONS_POISSON && !has_word(cmd->accepts, "young"))
        return parse_poisson(o, rule, text);
    if (rule->key >= KEY_REAL)
        return parse_real(o, rule, text);
    switch (rule->key) {
    case KEY_ORDER:
        return parse_whole(&o->order, rule, text);
    case KEY_TERMS:
        return parse_whole(&o->terms, rule, text);
    case KEY_DIGITS:
        return parse_whole(&o->digits, rule, text);
    case KEY_COUNT:
    case KEY_MODES:
        return parse_whole(&o->count, rule, text);
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
    case KEY_ALL:
        o->all = true;
        break;
    case KEY_SEED:
        return parse_whole(&o->seed, rule, text);
    case KEY_FORCE:
        o->force = true;
        break;
    case KEY_PROFILE:
        o->profile = true;
        break;
    case KEY_TYPE:
        return parse_type(o, text);
    case KEY_NAME:
        return parse_name(o, text);
    case KEY_FOR:
        return parse_use(o, text);
    case KEY_WALL:
        o->wall = true;
        break;
    case KEY_SPEED:
        return parse_list(o, OPTIONS_LIST_SPEED, &sweep_speed, text);
    case KEY_ALPHA:
        return parse_list(o, OPTIONS_LIST_ALPHA, &sweep_alpha, text);
    case KEY_PHI_POINTS:
        return parse_whole(&o->phi_points, rule, text);
    case KEY_THREADS:
        return parse_whole(&o->threads, rule, text);
    case KEY_DISKS:
        o->disks = true;
        break;
    case KEY_QUANTITY:
        return parse_quantity(o, text);
    case KEY_POINTS:
        return parse_whole(&o->points, rule, text);
    case KEY_ELASTIC:
    case KEY_DAMPING:
    case KEY_HELP:
    case KEY_REAL:
        break; /* the caller's: the law needs both its numbers, help ends the parsing */
    }
    return STATUS_OK;
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

    *o = (struct options){.count = OPTIONS_NOT_GIVEN,
                          .numerator = OPTIONS_NOT_GIVEN,
                          .denominator = OPTIONS_NOT_GIVEN,
                          .seed = OPTIONS_NOT_GIVEN,
                          .digits = OPTIONS_DEFAULT_DIGITS,
                          .collision_tolerance = strtod(OPTIONS_DEFAULT_COLLISION_TOLERANCE, NULL),
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

    if (has_word(cmd->accepts, "disks")) {
        const int status = parse_plan(o, given);
        if (status != STATUS_OK)
            return status;
    }

    const char *wrong = law_parse(&o->law, elastic, damping);
    if (wrong)
        return usage_error("--elastic %.60s --damping %.60s: %s", elastic, damping, wrong);
    return STATUS_OK;
}
