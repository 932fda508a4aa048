/* SPDX-License-Identifier: MIT */
#include "sweep/values.h"

#include <ctype.h>
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "runtime/disk/mode_file.h"
#include "support/console.h"
#include "support/formula.h"
#include "support/local.h"
#include "support/output.h"

enum { TOKEN_MAX = 200, BITS = 256, PARTS = 4 };

static const char ranges_are[] = "allowed: FIRST:LAST:+STEP, FIRST:LAST:-STEP, FIRST:LAST:lin:COUNT and "
                                 "FIRST:LAST:log:COUNT, for example 0.1:0.4:log:3";

static bool value_read_number(fmpq_t x, const char *text)
{
    struct decimal number = {0};
    if (strlen(text) > TOKEN_MAX || !decimal_parse(&number, text, DECIMAL_EXPONENT_DIGITS_IN_LIST))
        return false;
    fmpq_set(x, number.value);
    decimal_clear(&number);
    return true;
}

static int values_add(struct values *values, const struct values_rule *rule, const fmpq_t x)
{
    if (values->count == VALUES_MAX)
        return usage_error("--%s: the list has more than %d values; split the sweep", rule->option, VALUES_MAX);
    values->exact = xgrow(values->exact, values->count, sizeof *values->exact);
    values->nearest = xgrow(values->nearest, values->count, sizeof *values->nearest);
    fmpq_init(values->exact + values->count);
    fmpq_set(values->exact + values->count, x);
    values->nearest[values->count++] = decimal_nearest(x);
    return STATUS_OK;
}

static int value_read(fmpq_t x, const struct values_rule *rule, const char *text)
{
    if (!value_read_number(x, text) || !decimal_inside(&rule->range, x) ||
        (rule->whole && !fmpz_is_one(fmpq_denref(x))))
        return usage_error("--%s: '%s' is not %s; write it as %s", rule->option, text, rule->range.allowed,
                           rule->whole ? "940" : "0.1, 1.5e-3 (up to 3 digits in the exponent) or 1/3");
    return STATUS_OK;
}

/* Computes x = A + i (B - A)/n; if `geometric` is true, x = A (B/A)^(i/n). Rounds x if rule->whole. */
static void value_between(fmpq_t x, const struct values_rule *rule, bool geometric, const fmpq_t a, const fmpq_t b,
                          slong i, slong n)
{
    if (i == 0 || i == n) {
        fmpq_set(x, i == 0 ? a : b);
        return;
    }
    if (geometric) {
        LOCAL(arb, y);
        LET(y, BITS, "a*(b/a)^(i/n)", a, b, i, n);
        if (!rule->whole)
            arf_set_round(arb_midref(y), arb_midref(y), DBL_MANT_DIG, ARF_RND_NEAR);
        arf_get_fmpq(x, arb_midref(y));
    } else {
        EXACT(x, "a + (b - a)*i/n", a, b, i, n);
    }
    if (rule->whole) { /* floor(x + 1/2) */
        EXACT(x, "x + 1/2", x);
        fmpz_fdiv_q(fmpq_numref(x), fmpq_numref(x), fmpq_denref(x));
        fmpz_one(fmpq_denref(x));
    }
}

static int values_add_stepped(struct values *values, const struct values_rule *rule, const char *text, const fmpq_t a,
                              const fmpq_t b, const char *step_text)
{
    LOCAL(fmpq, step, x);
    if (step_text[1] == '-' || !value_read_number(step, step_text + 1) || fmpq_is_zero(step) ||
        (rule->whole && !fmpz_is_one(fmpq_denref(step))))
        return usage_error("--%s: the step of '%s' must be + or -, then a %snumber above 0; %s", rule->option, text,
                           rule->whole ? "whole " : "", ranges_are);
    if (*step_text == '-')
        fmpq_neg(step, step);
    fmpq_sub(x, b, a);
    if (fmpq_sgn(x) * fmpq_sgn(step) < 0)
        return usage_error("--%s: the step of '%s' leads away from the last value; %s", rule->option, text, ranges_are);
    int status = STATUS_OK;
    for (fmpq_set(x, a); status == STATUS_OK && fmpq_cmp(x, b) * fmpq_sgn(step) <= 0; fmpq_add(x, x, step))
        status = values_add(values, rule, x);
    return status;
}

static int values_add_spread(struct values *values, const struct values_rule *rule, const char *text, const fmpq_t a,
                             const fmpq_t b, const char *kind, const char *count)
{
    const bool geometric = strcmp(kind, "log") == 0;
    errno = 0;
    const long n = *count && count[strspn(count, "0123456789")] == '\0' ? strtol(count, NULL, 10) : 0;
    if (n < 2 || n > VALUES_MAX || errno)
        return usage_error("--%s: the count of '%s' is not a whole number from 2 to %d; %s", rule->option, text,
                           VALUES_MAX, ranges_are);
    if (geometric && (fmpq_sgn(a) <= 0 || fmpq_sgn(b) <= 0))
        return usage_error("--%s: a log range needs both ends above 0, not '%s'", rule->option, text);
    LOCAL(fmpq, x);
    int status = STATUS_OK;
    for (slong i = 0; i < n && status == STATUS_OK; i++) {
        value_between(x, rule, geometric, a, b, i, n - 1);
        status = values_add(values, rule, x);
    }
    return status;
}

/* Adds one member of the list, and modifies its text. */
static int values_add_member(struct values *values, const struct values_rule *rule, char *text)
{
    char whole[TOKEN_MAX];
    snprintf(whole, sizeof whole, "%s", text);
    char *part[PARTS + 1] = {text};
    int parts = 1;
    for (char *c = text; *c && parts <= PARTS; c++) {
        if (*c == ':') {
            *c = '\0';
            part[parts++] = c + 1;
        }
    }
    const bool stepped = parts == 3 && (*part[2] == '+' || *part[2] == '-');
    const bool spread = parts == 4 && (strcmp(part[2], "lin") == 0 || strcmp(part[2], "log") == 0);
    if (parts > 1 && !stepped && !spread)
        return usage_error("--%s: '%s' is not a range; %s", rule->option, whole, ranges_are);
    LOCAL(fmpq, a, b);
    int status = value_read(a, rule, part[0]);
    if (status == STATUS_OK && parts > 1)
        status = value_read(b, rule, part[1]);
    if (status == STATUS_OK)
        status = stepped  ? values_add_stepped(values, rule, whole, a, b, part[2])
                 : spread ? values_add_spread(values, rule, whole, a, b, part[2], part[3])
                          : values_add(values, rule, a);
    return status;
}

/* Compares two indices of a list by value; equal values by index. */
static int compare_places(const void *a, const void *b)
{
    const double *const *x = a, *const *y = b;
    if (**x != **y)
        return **x < **y ? -1 : 1;
    return *x < *y ? -1 : *x > *y;
}

static void values_drop_repeated(struct values *values)
{
    double **place = xmalloc(values->count * sizeof *place);
    bool *repeated = xmalloc(values->count * sizeof *repeated);
    /* start in reverse order, so that a stable sort cannot hide a comparison that ignores the index */
    for (size_t i = 0; i < values->count; i++)
        place[values->count - 1 - i] = values->nearest + i;
    qsort(place, values->count, sizeof *place, compare_places);
    for (size_t i = 0; i < values->count; i++)
        repeated[place[i] - values->nearest] = i > 0 && *place[i] == *place[i - 1];
    values->least = *place[0];
    values->largest = *place[values->count - 1];
    size_t kept = 0;
    for (size_t i = 0; i < values->count; i++) {
        if (!repeated[i]) {
            fmpq_swap(values->exact + kept, values->exact + i);
            values->nearest[kept++] = values->nearest[i];
        }
    }
    for (size_t i = kept; i < values->count; i++)
        fmpq_clear(values->exact + i);
    values->count = kept;
    free(place);
    free(repeated);
}

/* Reads a list from a file. A comma, white space or a comment ends a member. Returns the malloc'ed list, with commas
 * between the members, or NULL after a message. */
static char *read_list(uint32_t *check, const struct values_rule *rule, const char *path)
{
    enum { MOST_BYTES = 1 << 26 };
    struct stat found;
    size_t size = 0, length = 0;
    char *const list = stat(path, &found) == 0 && S_ISREG(found.st_mode) ? read_file(path, MOST_BYTES, &size) : NULL;
    const char *const wrong = list ? "it contains no values" : errno ? strerror(errno) : "it is not a regular file";
    bool comment = false;
    size = list ? size : 0;
    *check = cor_mode_file_check(COR_MODE_FILE_CHECK_START, list ? list : "", size);
    for (size_t i = list && strncmp(list, "\xef\xbb\xbf", 3) == 0 ? 3 : 0; i < size; i++) { /* skip a byte order mark */
        const char c = list[i];
        comment = c == '#' || (comment && c != '\n');
        const bool ends = comment || c == ',' || isspace((unsigned char)c);
        if (!ends || (length > 0 && list[length - 1] != ','))
            list[length++] = ends ? ',' : c ? c : '?'; /* '?' makes the number invalid */
    }
    length -= length > 0 && list[length - 1] == ',';
    if (length > 0) {
        list[length] = '\0';
        return list;
    }
    free(list);
    usage_error("--%s: cannot read a list from '%s': %s; allowed: a file of values and ranges, separated by commas, "
                "spaces or line ends",
                rule->option, path, wrong);
    return NULL;
}

int values_parse(struct values *values, const struct values_rule *rule, const char *text)
{
    *values = (struct values){.text = text};
    errno = 0;
    char *copy = *text == '@' ? read_list(&values->check, rule, text + 1) : xstrdup(text);
    if (!copy)
        return STATUS_USAGE;
    int status = STATUS_OK;
    for (char *member = copy, *next; member && status == STATUS_OK; member = next) {
        next = strchr(member, ',');
        if (next)
            *next++ = '\0';
        if (*member == '\0')
            status = usage_error("--%s: '%s' has an empty entry; separate values and ranges by one comma, for example "
                                 "0.1,0.2 or 0.1:0.5:+0.1",
                                 rule->option, text);
        else
            status = values_add_member(values, rule, member);
    }
    free(copy);
    if (status == STATUS_OK)
        values_drop_repeated(values);
    else
        values_clear(values);
    return status;
}

void values_clear(struct values *values)
{
    for (size_t i = 0; i < values->count; i++)
        fmpq_clear(values->exact + i);
    free(values->exact);
    free(values->nearest);
    *values = (struct values){0};
}
