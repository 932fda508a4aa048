/* SPDX-License-Identifier: MIT */
/* Tests every numeric option of every subcommand at both ends of its range and just outside. The expected range comes
 * from the texts for users: for whole numbers from the help, for other numbers from the refusal. */
#include "support/console.h" /* must precede cmocka.h, which defines a macro fail */

#include "check.h"

#include "cli/commands.h"

static const struct subcommand *const commands[] = {&command_trajectory, &command_series,     &command_pade,
                                                    &command_collide,    &command_disk_modes, &command_contact,
                                                    &command_sample,     &command_embed,      &command_disk_collide,
                                                    &command_plan,       &command_tables,     &command_law};

/* True if the option accepts the text, even if it needs other options. Whole numbers are stored exactly. */
static bool accepts(const struct subcommand *command, const struct option_rule *rule, const char *text)
{
    struct option_rule alone[] = {*rule, {.name = NULL}};
    alone[0].required = false;
    alone[0].needs = NULL;
    char *const name = xprintf("--%s", rule->name), *const value = xstrdup(text), *argv[] = {name, name, value, NULL};
    char *const arguments = memcpy(xmalloc(command->size), command->defaults, command->size);
    bool help;
    const bool accepted = options_parse(arguments, alone, 3, argv, &help) == STATUS_OK;
    if (accepted && rule->kind == OPTION_WHOLE)
        assert_true(*(slong *)(arguments + rule->offset) == strtol(text, NULL, 10));
    options_clear(arguments, alone);
    free(arguments);
    free(name);
    free(value);
    return accepted;
}

static void assert_end(const struct subcommand *command, const struct option_rule *rule, double end, double side,
                       bool allowed)
{
    const bool whole = rule->kind == OPTION_WHOLE || (rule->kind == OPTION_LIST && rule->range.values->whole);
    const double inside = whole ? end + side : nextafter(end, side * INFINITY);
    const double outside = whole ? end - side : nextafter(end, -side * INFINITY);
    const double x[] = {outside, end, inside};
    for (int i = 0; i < 3; i++) {
        char text[DECIMAL_TEXT];
        decimal_text(text, x[i]);
        check(accepts(command, rule, text) == (i == 1 ? allowed : i == 2), "corgen %s --%s %s", command->name,
              rule->name, text);
    }
}

/* Returns the number after the words in the text, or NaN. */
static double number_behind(const char *text, const char *words)
{
    const char *const at = strstr(text, words);
    return at ? strtod(at + strlen(words), NULL) : (double)NAN;
}

/* Checks a refusal's range: "above 0 and up to 1", "from 1e-5 to below 1", "between -1 and 1", "0 or more". */
static void assert_words(const struct subcommand *command, const struct option_rule *rule)
{
    const struct decimal_range range = options_numbers(rule).range;
    const char *const words = range.allowed, *const end = strstr(words, "between ") ? " and " : "to ";
    const double between = number_behind(words, "between "), above = number_behind(words, "above ");
    const double from = strstr(words, "0 or more") ? 0 : number_behind(words, "from ");
    const double below = number_behind(words, "below ");
    const bool open_low = isnan(from), open_high = !isnan(between) || !isnan(below);
    assert_end(command, rule, !open_low ? from : isnan(between) ? above : between, 1, !open_low);
    if (range.high)
        assert_end(command, rule, isnan(below) ? number_behind(words, end) : below, -1, !open_high);
    else
        assert_true(accepts(command, rule, "1e300") && !accepts(command, rule, "1e309"));
}

TEST(test_ends_of_ranges)
{
    int numbers = 0;
    if (!freopen("/dev/null", "w", stderr))
        return;
    for (size_t i = 0; i < COUNT_OF(commands); i++)
        for (const struct option_rule *rule = commands[i]->options; rule->name; rule++) {
            char text[64];
            const bool listed = rule->kind == OPTION_REAL || rule->kind == OPTION_LIST;
            numbers += listed || rule->kind == OPTION_WHOLE;
            if (rule->kind == OPTION_WHOLE) {
                const slong low = rule->range.whole.low, high = rule->range.whole.high;
                snprintf(text, sizeof text, "%ld to %ld", (long)low, (long)high);
                check(strstr(commands[i]->help, text) != NULL, "corgen %s --%s: %s", commands[i]->name, rule->name,
                      text);
                assert_end(commands[i], rule, (double)low, 1, true);
                assert_end(commands[i], rule, (double)high, -1, true);
            } else if (listed) {
                assert_words(commands[i], rule);
            }
        }
    assert_in_range(numbers, 100, 1000);
}
