/* SPDX-License-Identifier: MIT */
/* Lines, numbers and expressions of the inputs of simulators */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "runtime/scene/audit.h"
#include "runtime/scene/exponents.h"

int audit_is(const char *text, const char *other)
{
    return strcmp(text, other) == 0;
}

int audit_starts(const char *text, const char *start)
{
    return strncmp(text, start, strlen(start)) == 0;
}

int audit_is_space(char c)
{
    return c != '\0' && strchr(" \t\r\n\f\v", c) != NULL;
}

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static int is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

int audit_is_of_name(char c)
{
    return is_letter(c) || is_digit(c) || c == '.';
}

/* Not strtod, which asks the locale for the decimal point. Exact for up to 15 digits and exponents up to 22; within
 * some units of the last place elsewhere. */
static double read_number(const char **text)
{
    const char *at = *text;
    double mantissa = 0;
    int digits = 0, point = 0;
    long exponent = 0;
    for (;; at++) {
        if (*at == '.' && !point) {
            point = 1;
        } else if (is_digit(*at)) {
            if (mantissa < 1e17) {
                mantissa = 10 * mantissa + (*at - '0');
                exponent -= point;
            } else {
                exponent += !point;
            }
            digits++;
        } else {
            break;
        }
    }
    if (digits == 0)
        return (double)NAN;
    if (*at && strchr("eEdD", *at)) {
        const char *power = at + 1;
        const int negative = *power == '-';
        long value = 0;
        power += *power == '-' || *power == '+';
        if (is_digit(*power)) {
            for (; is_digit(*power); power++)
                value = value < 100000 ? 10 * value + (*power - '0') : value;
            exponent += negative ? -value : value;
            at = power;
        }
    }
    *text = at;
    if (mantissa == 0)
        return 0;
    if (exponent < -300) /* 10^-exponent may overflow where the number does not vanish */
        return mantissa / 1e200 / pow(10, (double)(-exponent - 200));
    return exponent < 0 ? mantissa / pow(10, (double)-exponent) : mantissa * pow(10, (double)exponent);
}

double audit_number(const char *text)
{
    const int negative = *text == '-';
    text += *text == '-' || *text == '+';
    const double value = read_number(&text);
    return *text ? (double)NAN : negative ? -value : value;
}

const char *audit_keep(struct audit *a, const char *text, size_t size)
{
    if (a->used + size + 1 > sizeof a->pool) {
        a->unsettled++;
        return "";
    }
    char *const kept = a->pool + a->used;
    memcpy(kept, text, size);
    kept[size] = '\0';
    a->used += size + 1;
    return kept;
}

static void append(char *text, size_t size, const char *format, va_list arguments)
{
    size_t length = strlen(text);
    for (; *format; format++) {
        char number[32] = {*format, '\0'};
        const char *part = number;
        if (*format == '$') {
            part = va_arg(arguments, const char *);
        } else if (*format == '%' || *format == '@') {
            snprintf(number, sizeof number, *format == '%' ? "%.6g" : "%.15g", va_arg(arguments, double));
            char *const comma = strchr(number, ','); /* of the locale */
            if (comma)
                *comma = '.';
        }
        while (*part && length + 1 < size)
            text[length++] = *part++;
    }
    text[length] = '\0';
}

#define APPEND(text, size, format)                                                                                     \
    do {                                                                                                               \
        va_list arguments;                                                                                             \
        va_start(arguments, format);                                                                                   \
        append(text, size, format, arguments);                                                                         \
        va_end(arguments);                                                                                             \
    } while (0)

void audit_append(char *text, size_t size, const char *format, ...)
{
    APPEND(text, size, format);
}

const char *audit_print(struct audit *a, const char *format, ...)
{
    a->printed[0] = '\0';
    APPEND(a->printed, sizeof a->printed, format);
    return a->printed;
}

const char *audit_kept(struct audit *a, const char *format, ...)
{
    a->printed[0] = '\0';
    APPEND(a->printed, sizeof a->printed, format);
    return audit_keep(a, a->printed, strlen(a->printed));
}

void audit_say(struct audit *a, const char *format, ...)
{
    audit_append(a->advice, sizeof a->advice, *a->advice ? " " : "");
    APPEND(a->advice, sizeof a->advice, format);
}

/* ---- lines ---- */

/* Ends a line that is too long by a remark, and skips the rest of it. */
static void put(struct audit *a, size_t *used, char c)
{
    if (*used + 1 < sizeof a->raw)
        a->raw[(*used)++] = c;
    else if (*used + 1 == sizeof a->raw) {
        audit_remark(a, "the line is longer than 8190 characters and is not read", NULL);
        *used += 1;
    }
}

/* Skips a text of Python between triple quotes, of which the first is read. Returns 0 if it is none. */
static int skip_text_of_lines(struct audit *a, char quote)
{
    const char *const text = a->text.text;
    size_t at = a->at;
    if (at + 2 > a->text.size || text[at] != quote || text[at + 1] != quote)
        return 0;
    for (at += 2; at < a->text.size; at++) {
        a->next_line += text[at] == '\n';
        if (at + 2 < a->text.size && text[at] == quote && text[at + 1] == quote && text[at + 2] == quote)
            break;
    }
    a->at = at + 3 < a->text.size ? at + 3 : a->text.size;
    return 1;
}

int audit_next_line(struct audit *a, enum audit_language language)
{
    const char *const text = a->text.text;
    size_t used = 0;
    int open = 0; /* parentheses of Python */
    char quote = '\0';
    if (a->at >= a->text.size)
        return 0;
    a->line = a->next_line;
    while (a->at < a->text.size) {
        const char c = text[a->at++];
        if (c == '\n') {
            a->next_line++;
            while (used > 0 && used < sizeof a->raw && audit_is_space(a->raw[used - 1]))
                used--;
            const int more = language == AUDIT_PYTHON
                                 ? open > 0 || (used > 0 && used < sizeof a->raw && a->raw[used - 1] == '\\')
                                 : used > 0 && used < sizeof a->raw && a->raw[used - 1] == '&';
            if (!more)
                break;
            if (open == 0)
                used--;
            put(a, &used, language == AUDIT_PYTHON ? '\n' : ' ');
            if (language != AUDIT_SCRIPT)
                quote = '\0';
        } else if (quote) {
            quote = c == quote ? '\0' : quote;
            put(a, &used, c);
        } else if (language == AUDIT_PYTHON && (c == '"' || c == '\'') && skip_text_of_lines(a, c)) {
            put(a, &used, '"');
        } else if (c == '#' || (c == '!' && language == AUDIT_NAMELIST)) {
            while (a->at < a->text.size && text[a->at] != '\n')
                a->at++;
        } else {
            if (c == '"' || c == '\'')
                quote = c;
            open += (strchr("([{", c) != NULL) - (strchr(")]}", c) != NULL);
            put(a, &used, c);
        }
    }
    a->raw[used < sizeof a->raw ? used : 0] = '\0';
    return 1;
}

static int is_at(const struct audit *a, const char *word)
{
    const size_t size = strlen(word);
    return a->text.size - a->at >= size && memcmp(a->text.text + a->at, word, size) == 0;
}

int audit_next_part(struct audit *a, const char *ends, const char *start)
{
    const char *const text = a->text.text;
    size_t used = 0;
    int started = *start == '\0', depth = 0;
    char quote = '\0';
    for (; a->at < a->text.size; a->at++) {
        const char c = text[a->at];
        a->next_line += c == '\n';
        if (is_at(a, "<!--") && *start) {
            while (a->at + 1 < a->text.size && !is_at(a, "-->")) {
                a->at++;
                a->next_line += text[a->at] == '\n';
            }
        } else if (!started) {
            started = c == *start;
        } else if (!quote && strchr(ends, c) && !(c == ',' && depth > 0)) {
            if (used > 0)
                break;
            depth = 0;
        } else if (used > 0 || !audit_is_space(c)) {
            if (used == 0)
                a->line = a->next_line;
            if (quote || c == '"' || (c == '\'' && *start))
                quote = !quote ? c : c == quote ? '\0' : quote;
            else
                depth += (c == '[') - (c == ']');
            put(a, &used, c == '\n' ? ' ' : c);
        }
    }
    a->at += a->at < a->text.size;
    a->raw[used < sizeof a->raw ? used : 0] = '\0';
    return used > 0;
}

/* ---- expressions ---- */

struct audit_variable *audit_variable_named(struct audit *a, const char *name, size_t size)
{
    for (int i = 0; i < a->variables; i++)
        if (strlen(a->variable[i].name) == size && strncmp(a->variable[i].name, name, size) == 0)
            return &a->variable[i];
    return NULL;
}

void audit_set_variable(struct audit *a, const char *name, const char *text, int formula)
{
    struct audit_variable *variable = audit_variable_named(a, name, strlen(name));
    if (!variable) {
        if (a->variables == AUDIT_VARIABLES) {
            audit_remark(a, "too many variables; not read:", name);
            return;
        }
        variable = &a->variable[a->variables++];
        variable->name = audit_keep(a, name, strlen(name));
    }
    variable->text = audit_keep(a, text, strlen(text));
    variable->formula = formula;
}

struct parser {
    struct audit *a;
    const char *at;
    int depth; /* of expressions in expressions, from 0 */
};
static double expression(struct parser *p, int level);

static void skip_space(struct parser *p)
{
    while (audit_is_space(*p->at))
        p->at++;
}

static double variable_value(struct parser *p, const char *name, size_t size)
{
    const struct audit_variable *const variable = audit_variable_named(p->a, name, size);
    if (!variable || p->depth >= AUDIT_DEPTH)
        return (double)NAN;
    struct parser inner = {p->a, variable->text, p->depth};
    const double value = expression(&inner, 0);
    skip_space(&inner);
    return *inner.at ? (double)NAN : value;
}

static double call(const char *name, size_t size, double x, double y)
{
    static const struct {
        const char *name;
        double (*one)(double), (*two)(double, double);
    } functions[] = {{"sqrt", sqrt, NULL},   {"exp", exp, NULL},     {"ln", log, NULL},     {"log10", log10, NULL},
                     {"abs", fabs, NULL},    {"sin", sin, NULL},     {"cos", cos, NULL},    {"tan", tan, NULL},
                     {"asin", asin, NULL},   {"acos", acos, NULL},   {"atan", atan, NULL},  {"atan2", NULL, atan2},
                     {"ceil", ceil, NULL},   {"floor", floor, NULL}, {"round", rint, NULL}, {"min", NULL, fmin},
                     {"max", NULL, fmax},    {"pow", NULL, pow},     {"log", log, NULL},    {"float", NULL, NULL},
                     {"radians", NULL, NULL}};
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        if (strlen(functions[i].name) != size || strncmp(functions[i].name, name, size) != 0)
            continue;
        if (functions[i].one)
            return functions[i].one(x);
        if (functions[i].two)
            return functions[i].two(x, y);
        return *name == 'f' ? x : x * COR_PI / 180;
    }
    return (double)NAN;
}

/* A name with the arguments of a call, if there are any */
static double named(struct parser *p)
{
    const char *name = p->at;
    while (audit_is_of_name(*p->at))
        p->at++;
    const char *const end = p->at;
    size_t size = (size_t)(end - name);
    skip_space(p);
    if (*p->at == '(') {
        double argument[2] = {(double)NAN, (double)NAN};
        int arguments = 0;
        do {
            p->at++;
            const double value = expression(p, 0);
            if (arguments < 2)
                argument[arguments] = value;
            arguments++;
            skip_space(p);
        } while (*p->at == ',');
        if (*p->at != ')')
            return (double)NAN;
        p->at++;
        for (size_t i = size; i > 0; i--) /* math.sqrt */
            if (name[i - 1] == '.') {
                name += i;
                size -= i;
                break;
            }
        return call(name, size, argument[0], argument[1]);
    }
    const double value = variable_value(p, name, size);
    if (!isnan(value))
        return value;
    if (size > 2 && audit_starts(name, "v_"))
        return variable_value(p, name + 2, size - 2);
    if (size >= 2 && (audit_starts(end - 2, "pi") || audit_starts(end - 2, "PI")))
        return COR_PI;
    return size == 2 && audit_starts(name, "dt") ? p->a->time_step / p->a->time : (double)NAN;
}

static double primary(struct parser *p)
{
    skip_space(p);
    if (++p->a->evaluations > AUDIT_EVALUATIONS || p->depth >= AUDIT_DEPTH)
        return (double)NAN;
    if (*p->at == '(') {
        p->at++;
        const double value = expression(p, 0);
        skip_space(p);
        if (*p->at != ')')
            return (double)NAN;
        p->at++;
        return value;
    }
    if (*p->at == '-' || *p->at == '+' || *p->at == '!') {
        const char sign = *p->at++;
        const double value = expression(p, 5);
        return sign == '-' ? -value : sign == '+' ? value : (double)(value == 0);
    }
    return is_letter(*p->at) ? named(p) : read_number(&p->at);
}

/* The operator at `at` and its level; NULL: none. The longest come first. */
static const char *operator_at(const char *at, int *level)
{
    static const struct {
        const char *text;
        int level;
    } operators[] = {{"||", 0}, {"&&", 1}, {"==", 2}, {"!=", 2}, {"<=", 3}, {">=", 3}, {"**", 6}, {"//", -1},
                     {"<", 3},  {">", 3},  {"+", 4},  {"-", 4},  {"*", 5},  {"/", 5},  {"%", 5},  {"^", 6}};
    for (size_t i = 0; i < sizeof operators / sizeof *operators; i++)
        if (audit_starts(at, operators[i].text)) {
            *level = operators[i].level;
            return operators[i].text;
        }
    return NULL;
}

static double operate(const char *operation, double x, double y)
{
    if (isnan(x) || isnan(y))
        return (double)NAN;
    switch (*operation) {
    case '|':
        return x != 0 || y != 0;
    case '&':
        return x != 0 && y != 0;
    case '=':
        return x == y;
    case '!':
        return x != y;
    case '<':
        return operation[1] ? x <= y : x < y;
    case '>':
        return operation[1] ? x >= y : x > y;
    case '+':
        return x + y;
    case '-':
        return x - y;
    case '/':
        return y == 0 ? (double)NAN : x / y;
    case '%':
        return y == 0 ? (double)NAN : fmod(x, y);
    case '^':
        return pow(x, y);
    default:
        return operation[1] ? pow(x, y) : x * y;
    }
}

/* Operators of at least this level; those of one level from the left */
static double expression(struct parser *p, int level)
{
    p->depth++;
    double value = primary(p);
    for (;;) {
        int next = -1;
        skip_space(p);
        const char *const operation = operator_at(p->at, &next);
        if (!operation || next < level || p->a->evaluations > AUDIT_EVALUATIONS)
            break;
        p->at += strlen(operation);
        value = operate(operation, value, expression(p, next + 1));
    }
    p->depth--;
    return value;
}

double audit_value(struct audit *a, const char *text)
{
    struct parser p = {a, text, -1};
    const double value = expression(&p, 0);
    skip_space(&p);
    return *p.at || !isfinite(value) ? (double)NAN : value;
}

double audit_value_of(struct audit *a, const char *text, size_t size)
{
    char copy[256];
    if (size >= sizeof copy)
        return (double)NAN;
    memcpy(copy, text, size);
    copy[size] = '\0';
    return audit_value(a, copy);
}
