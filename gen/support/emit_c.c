/* SPDX-License-Identifier: MIT */
#include "support/emit_c.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/digits.h"
#include "support/local.h"

enum { COMMENT_DIGITS = 25, BITS_OF_SMALL = 40, WIDTH = 120, NUMBER_MAX = 40 };

/* Writes a comment. A star and a slash in the text are separated, and no line ends in a space. */
static void put_comment(FILE *file, const char *text)
{
    size_t length = strlen(text);
    while (length > 0 && text[length - 1] == '\n')
        length--;
    fprintf(file, "/* ");
    for (size_t i = 0; i < length; i++) {
        if (i > 0 && text[i - 1] == '*' && text[i] == '/')
            putc(' ', file);
        if (text[i] != '\n')
            putc(text[i], file);
        else
            fprintf(file, text[i + 1] == '\n' ? "\n *" : "\n * ");
    }
    fprintf(file, " */\n");
}

void emit_open(struct emit *e, FILE *file, const char *guard, const char *banner)
{
    e->file = file;
    e->guard = guard;
    e->decimal = false;
    e->single = false;
    fprintf(file, "/* SPDX-License-Identifier: MIT */\n");
    put_comment(file, banner);
    fprintf(file, "#ifndef %s\n#define %s\n", guard, guard);
}

void emit_close(struct emit *e)
{
    fprintf(e->file, "\n#endif\n");
}

void emit_comment(struct emit *e, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *const text = xvprintf(format, arguments);
    va_end(arguments);
    putc('\n', e->file);
    put_comment(e->file, text);
    free(text);
}

/* The fraction if x is exact and has a binary denominator of few bits, otherwise its digits */
static char *number_text(const arb_t x)
{
    if (!arb_is_exact(x) || arb_bits(x) > BITS_OF_SMALL || arf_cmpabs_2exp_si(arb_midref(x), BITS_OF_SMALL) > 0 ||
        (!arb_is_zero(x) && arf_cmpabs_2exp_si(arb_midref(x), -BITS_OF_SMALL) < 0))
        return digits_of_ball(x, COMMENT_DIGITS);
    LOCAL(fmpq, exact);
    arf_get_fmpq(exact, arb_midref(x));
    char *text = fmpq_get_str(NULL, 10, exact);
    char *copy = xstrdup(text);
    flint_free(text);
    return copy;
}

int emit_doubles(struct emit *e, const char *name, arb_srcptr value, slong length)
{
    fprintf(e->file, "static const double %s[] = {\n", name);
    for (slong i = 0; i < length; i++) {
        double y;
        char *text = number_text(value + i);
        if (!text || !digits_to_double(&y, value + i)) {
            free(text);
            return fail("%s[%ld] is not known well enough to be rounded", name, (long)i);
        }
        fprintf(e->file, "    %a, /* [%ld] %s */\n", y, (long)i, text);
        free(text);
    }
    fprintf(e->file, "};\n");
    return 0;
}

static const char *real_type(const struct emit *e)
{
    return e->single ? "float" : "double";
}

/* The text of a number of the type in C and C++, which reads back to the same bits */
static const char *real(char text[NUMBER_MAX], const struct emit *e, double x)
{
    /* the shortest such text */
    const int most = e->single ? 9 : 17;
    for (int digits = 1; digits <= most; digits++) {
        snprintf(text, NUMBER_MAX, "%.*g", digits, x);
        if (e->single ? strtof(text, NULL) == (float)x : strtod(text, NULL) == x)
            break;
    }
    const size_t length = strlen(text);
    snprintf(text + length, NUMBER_MAX - length, "%s%s", strpbrk(text, ".e") ? "" : ".0", e->single ? "f" : "");
    return text;
}

static FILE *digits_file;

void emit_digits(FILE *file)
{
    digits_file = file;
    if (file)
        fprintf(file, "table,row,column,value,digits\n");
}

/* A number of a table by its row and column, with its digits, where these are wanted */
static int put_digits(const struct emit *e, const arb_t x, slong column, double y)
{
    if (!digits_file || e->decimal)
        return STATUS_OK;
    char *text = number_text(x);
    if (!text)
        return fail("%s: a number is not known well enough to be shown", e->table);
    fprintf(digits_file, "%s,%ld,%ld,%a,%s\n", e->table, (long)e->row, (long)column, y, text);
    free(text);
    return STATUS_OK;
}

/* Elements of a table, {...}, separated by commas, in lines that are filled */
static void put_number(struct emit *e, const char *number, bool opens, bool closes)
{
    const int length = (int)strlen(number) + opens + closes;
    if (e->column > 0)
        e->column += fprintf(e->file, ",");
    if (e->column == 0 || e->column + length + 1 > WIDTH)
        e->column = fprintf(e->file, e->column > 0 ? "\n    " : "    ") - (e->column > 0);
    e->column += fprintf(e->file, "%s%s%s", opens ? "{" : "", number, closes ? "}" : "");
}

static int put_ball(struct emit *e, const arb_t x, slong column, bool opens, bool closes)
{
    double y;
    char number[NUMBER_MAX];
    if (!digits_to_double(&y, x))
        return fail("%s, row %ld: number %ld is not known well enough to be rounded", e->table, (long)e->row,
                    (long)column);
    if (put_digits(e, x, column, y))
        return STATUS_FAILED;
    if (e->decimal)
        real(number, e, y);
    else
        snprintf(number, sizeof number, "%a", y);
    put_number(e, number, opens, closes);
    return STATUS_OK;
}

static void table_open(struct emit *e, const char *name)
{
    e->table = name;
    e->row = 0;
    e->column = 0;
}

/* Tables of one row stay local: compilers make constants of their numbers. */
void emit_rows_open(struct emit *e, const char *type, const char *name, slong rows, slong columns)
{
    table_open(e, name);
    e->type = type;
    e->local = e->decimal || rows == 1;
    if (e->local)
        fprintf(e->file, "COR_INLINE const %s *%s(int i)\n{\n    static const %s row[%ld][%ld] = {\n", type, name, type,
                (long)rows, (long)columns);
    else
        fprintf(e->file, "COR_ROWS(%s, %s, %ld, %ld)\n#ifdef COR_ROWS_HERE\n= {\n", type, name, (long)rows,
                (long)columns);
}

int emit_row(struct emit *e, arb_srcptr value, slong columns)
{
    int status = STATUS_OK;
    for (slong i = 0; i < columns && status == STATUS_OK; i++)
        status = put_ball(e, value + i, i, i == 0, i + 1 == columns);
    e->row++;
    return status;
}

void emit_float_row(struct emit *e, const double *value, slong columns)
{
    for (slong i = 0; i < columns; i++) {
        char number[NUMBER_MAX];
        snprintf(number, sizeof number, "%af", value[i]);
        put_number(e, number, i == 0, i + 1 == columns);
    }
}

void emit_rows_close(struct emit *e)
{
    if (e->local)
        fprintf(e->file, "\n    };\n    return row[i];\n}\n");
    else
        fprintf(e->file, "\n}\n#endif\n;\nCOR_ROWS_FUNCTION(%s, %s)\n", e->type, e->table);
}

int emit_one_row(struct emit *e, const char *name, arb_srcptr value, slong columns)
{
    emit_rows_open(e, "double", name, 1, columns);
    const int status = emit_row(e, value, columns);
    emit_rows_close(e);
    return status;
}

void emit_structs_open(struct emit *e, const char *type, const char *name, slong count)
{
    table_open(e, name);
    fprintf(e->file, "static const struct %s %s[%ld] = {\n", type, name, (long)count);
}

int emit_struct(struct emit *e, const slong *whole, slong wholes, arb_srcptr value, slong values)
{
    int status = STATUS_OK;
    for (slong i = 0; i < wholes; i++) {
        char number[NUMBER_MAX];
        snprintf(number, sizeof number, "%ld", (long)whole[i]);
        put_number(e, number, i == 0, false);
    }
    for (slong i = 0; i < values && status == STATUS_OK; i++)
        status = put_ball(e, value + i, wholes + i, wholes + i == 0, i + 1 == values);
    e->row++;
    return status;
}

void emit_structs_close(struct emit *e)
{
    fprintf(e->file, "\n};\n");
}

void emit_constants(struct emit *e, const char *const *name, const slong *value, slong count)
{
    fprintf(e->file, "enum {\n");
    for (slong i = 0; i < count; i++)
        fprintf(e->file, "    %s = %ld%s\n", name[i], (long)value[i], i + 1 < count ? "," : "");
    fprintf(e->file, "};\n");
}

void emit_builder_open(struct emit *e, const char *type, const char *name, const char *start)
{
    fprintf(e->file, "\nCOR_INLINE_LAW struct %s %s(void)\n{\n    struct %s x = %s;\n", type, name, type, start);
}

void emit_builder_set(struct emit *e, const char *field, const char *format, ...)
{
    va_list arguments;
    fprintf(e->file, "    x.%s = ", field);
    va_start(arguments, format);
    vfprintf(e->file, format, arguments);
    va_end(arguments);
    fputs(";\n", e->file);
}

int emit_builder_pair(struct emit *e, const char *field, const arb_t value)
{
    double hi, lo;
    LOCAL(arb, rest);
    int status = !digits_to_double(&hi, value);
    arb_set_d(rest, hi);
    arb_sub(rest, value, rest, 2 * FLINT_BITS + 64);
    status = status || (!arb_is_zero(rest) && !digits_to_double(&lo, rest));
    if (arb_is_zero(rest))
        lo = 0;
    if (status)
        return fail("%s: a number cannot be rounded to two doubles", field);
    fprintf(e->file, "    x.%s.hi = %.17g;\n    x.%s.lo = %.17g;\n", field, hi, field, lo);
    return STATUS_OK;
}

void emit_builder_close(struct emit *e)
{
    fputs("    return x;\n}\n", e->file);
}

void emit_inline_double(struct emit *e, const char *name, const char *argument, const char *format, ...)
{
    va_list arguments;
    fprintf(e->file, "\nCOR_INLINE double %s(double %s)\n{\n    return ", name, argument);
    va_start(arguments, format);
    vfprintf(e->file, format, arguments);
    va_end(arguments);
    fputs(";\n}\n", e->file);
}

void emit_inline_quotient(struct emit *e, const char *name, const char *argument, const char *z, const char *factor,
                          const char *const numerator[2], const char *const denominator[2])
{
    const char *const *const part[2] = {numerator, denominator};
    static const char *const value[2] = {"above", "below"};
    const bool same = strcmp(argument, z) == 0;
    fprintf(e->file, "static inline double %s(double %s)\n{\n", name, argument);
    if (!same)
        fprintf(e->file, "    const double z = %s;\n", z);
    for (int i = 0; i < 2; i++)
        fprintf(e->file, "    double %s = 0;\n    for (int k = %s; k-- > 0;)\n        %s = %s * %s + %s[k];\n",
                value[i], part[i][1], value[i], value[i], same ? argument : "z", part[i][0]);
    fprintf(e->file, "    return %s >= 0 ? %s%sabove / below : (double)NAN;\n}\n", argument, factor ? factor : "",
            factor ? " * " : "");
}

void emit_include(struct emit *e, const char *name)
{
    fprintf(e->file, "#include %s\n", name);
}

void emit_capitals(char *name)
{
    for (; *name; name++)
        *name = (char)toupper((unsigned char)*name);
}

void emit_define(struct emit *e, const char *name, const char *text)
{
    fprintf(e->file, "#define %s %s\n", name, text);
}

struct bound_text emit_bound(double x)
{
    struct bound_text bound;
    double y = x;
    for (;;) {
        snprintf(bound.text, sizeof bound.text, "%.1e", y);
        if (!isfinite(x) || strtod(bound.text, NULL) >= x)
            return bound;
        y *= 1.01;
    }
}

/* ---- functions of one real number ---- */

enum { COLUMNS = 100 };

static void put_geometry(struct emit *e, const char *table, const char *what, const char *number)
{
    fprintf(e->file, "#define ");
    for (const char *at = table; *at; at++)
        putc(toupper((unsigned char)*at), e->file);
    fprintf(e->file, "_%s %s\n", what, number);
}

void emit_geometry_real(struct emit *e, const char *table, const char *what, double x)
{
    char number[NUMBER_MAX];
    if (x == rint(x) && fabs(x) < 1e9)
        snprintf(number, sizeof number, "%.1f", x);
    else
        real(number, e, x);
    put_geometry(e, table, what, number);
}

void emit_geometry_integer(struct emit *e, const char *table, const char *what, slong n)
{
    char number[NUMBER_MAX];
    snprintf(number, sizeof number, n < 0 ? "(%ld)" : "%ld", (long)n);
    put_geometry(e, table, what, number);
}

static void let(struct emit *e, const char *type, const char *name, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
static void let(struct emit *e, const char *type, const char *name, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(e->file, "    const %s %s = ", type, name);
    vfprintf(e->file, format, arguments);
    fprintf(e->file, ";\n");
    va_end(arguments);
}

void emit_function_open(struct emit *e, const char *name, const char *argument)
{
    fprintf(e->file, "COR_INLINE %s %s(%s %s)\n{\n", real_type(e), name, real_type(e), argument);
}

/* The bits of a number of the type, as an integer */
static unsigned long long bits_of(const struct emit *e, double x)
{
    const float y = (float)x;
    uint32_t narrow;
    uint64_t wide;
    memcpy(&narrow, &y, sizeof narrow);
    memcpy(&wide, &x, sizeof wide);
    return e->single ? narrow : wide;
}

void emit_let_clamped(struct emit *e, const char *name, const char *x, double low, double high, bool vector)
{
    char number[NUMBER_MAX];
    if (!vector) {
        real(number, e, low);
        let(e, real_type(e), "above", "%s > %s ? %s : %s", x, number, x, number);
        real(number, e, high);
        let(e, real_type(e), name, "above < %s ? above : %s", number, number);
        return;
    }
    const int width = e->single ? 32 : 64;
    fprintf(e->file, "    /* as whole numbers, which loops over it are made vectors with */\n");
    fprintf(e->file, "    const int%d_t low = INT%d_C(%llu), high = INT%d_C(%llu);\n", width, width, bits_of(e, low),
            width, bits_of(e, high));
    fprintf(e->file, "    int%d_t whole_speed;\n    memcpy(&whole_speed, &%s, sizeof whole_speed);\n", width, x);
    fprintf(e->file, "    const int%d_t above = whole_speed > low ? whole_speed : low;\n", width);
    fprintf(e->file, "    const int%d_t inside = above < high ? above : high;\n", width);
    fprintf(e->file, "    %s %s;\n    memcpy(&%s, &inside, sizeof %s);\n", real_type(e), name, name, name);
}

void emit_let_less(struct emit *e, const char *name, const char *x, double number)
{
    char text[NUMBER_MAX];
    real(text, e, number);
    let(e, real_type(e), name, "%s - %s", x, text);
}

void emit_let_above(struct emit *e, const char *name, const char *x, double end, double before, const char *numerator,
                    const char *denominator)
{
    char number[NUMBER_MAX], first[NUMBER_MAX];
    real(number, e, end);
    real(first, e, before);
    let(e, real_type(e), name, "%s <= %s ? %s : %s%s%s", x, number, first, numerator, denominator ? " / " : "",
        denominator ? denominator : "");
}

void emit_let_sqrt(struct emit *e, const char *name, const char *x)
{
    let(e, real_type(e), name, "sqrt%s(%s)", e->single ? "f" : "", x);
}

/* c_0 + x * (c_1 + x * (... + x * c_n)): Horner's rule. text(k) is c_k; the last may be the number 1. */
static void put_horner(struct emit *e, const char *name, const char *x, char (*text)[NUMBER_MAX], slong degree,
                       bool monic)
{
    const slong last = monic ? degree - 1 : degree;
    int column = fprintf(e->file, "    const %s %s = %s", real_type(e), name, text[0]);
    for (slong k = 1; k <= last; k++) {
        const bool opens = k < last || monic;
        if (column + (int)(strlen(text[k]) + strlen(x)) + 7 > COLUMNS)
            column = fprintf(e->file, "\n       ") - 1;
        column += fprintf(e->file, " + %s * %s%s", x, opens ? "(" : "", text[k]);
    }
    if (monic)
        fprintf(e->file, " + %s", x);
    for (slong k = 0; k < (monic ? last : last - 1); k++)
        putc(')', e->file);
    fprintf(e->file, ";\n");
}

void emit_let_polynomial(struct emit *e, const char *name, const char *x, const double *c, slong degree)
{
    char(*text)[NUMBER_MAX] = xmalloc((size_t)(degree + 1) * sizeof *text);
    for (slong k = 0; k <= degree; k++) {
        char number[NUMBER_MAX];
        real(number, e, c[k]);
        snprintf(text[k], NUMBER_MAX, "%s", number);
    }
    put_horner(e, name, x, text, degree, degree > 0 && c[degree] == 1);
    free(text);
}

void emit_let_product(struct emit *e, const char *name, const char *x, const char *y)
{
    let(e, real_type(e), name, "%s * %s", x, y);
}

void emit_let_split_polynomial(struct emit *e, const char *name, const char *x, const char *square, const double *c,
                               slong degree)
{
    static const char *const parity[] = {"even", "odd"};
    double *part = xmalloc((size_t)(degree + 1) * sizeof *part);
    char names[2][32];
    for (slong odd = 0; odd < 2; odd++) {
        slong n = 0;
        for (slong k = odd; k <= degree; k += 2)
            part[n++] = c[k];
        snprintf(names[odd], sizeof names[odd], "%s_%s", name, parity[odd]);
        emit_let_polynomial(e, names[odd], square, part, n - 1);
    }
    let(e, real_type(e), name, "%s + %s * %s", names[0], x, names[1]);
    free(part);
}

void emit_let_row_polynomial(struct emit *e, const char *name, const char *table, const char *row, const char *t,
                             slong degree)
{
    char(*text)[NUMBER_MAX] = xmalloc((size_t)(degree + 1) * sizeof *text);
    for (slong k = 0; k <= degree; k++)
        snprintf(text[k], NUMBER_MAX, "%s[%s][%ld]", table, row, (long)k);
    put_horner(e, name, t, text, degree, false);
    free(text);
}

/* name = the bits of x */
static void let_bits(struct emit *e, const char *name, const char *x)
{
    fprintf(e->file, "    uint%d_t %s;\n    memcpy(&%s, &%s, sizeof %s);\n", e->single ? 32 : 64, name, name, x, name);
}

static void let_from_bits(struct emit *e, const char *name, const char *bits)
{
    fprintf(e->file, "    %s %s;\n    memcpy(&%s, &%s, sizeof %s);\n", real_type(e), name, name, bits, name);
}

/* Writes a step from an approximation r of g^(-1/5) to a better one, `out`. Names are numbered because all are in one
 * block. */
static void put_root_step(struct emit *e, int step, const char *g, const char *r, const char *out, const double *c,
                          slong degree)
{
    char square[16], fourth[16], off[16], factor[16], one[NUMBER_MAX];
    snprintf(square, sizeof square, "square_%d", step);
    snprintf(fourth, sizeof fourth, "fourth_%d", step);
    snprintf(off, sizeof off, "off_%d", step);
    snprintf(factor, sizeof factor, "factor_%d", step);
    let(e, real_type(e), square, "%s * %s", r, r);
    let(e, real_type(e), fourth, "%s * %s", square, square);
    let(e, real_type(e), off, "%s - %s * %s * %s", real(one, e, 1), g, r, fourth);
    emit_let_polynomial(e, factor, off, c, degree);
    let(e, real_type(e), out, "%s * %s", r, factor);
}

void emit_let_fifth_root(struct emit *e, const char *name, const char *x, const struct emit_fifth_root *root)
{
    char fifth[NUMBER_MAX], constant[NUMBER_MAX];
    fprintf(e->file, "    /* %s^(-1/5), 3 %% off: minus a fifth of the bits */\n", x);
    let_bits(e, "bits", x);
    if (e->single) {
        let(e, "uint32_t", "fifth", "%uu - bits / 5u", root->single_constant);
        let_from_bits(e, "guess", "fifth");
    } else {
        /* the double 2^52 + n holds the integer n in its low bits */
        let(e, "uint64_t", "upper", "(bits >> 32) | UINT64_C(0x4330000000000000)");
        let_from_bits(e, "number", "upper");
        let(e, "double", "fifth", "%s - %s * number", real(constant, e, root->constant), real(fifth, e, root->fifth));
        let_bits(e, "shifted", "fifth");
        fprintf(e->file, "    shifted <<= 32;\n");
        let_from_bits(e, "guess", "shifted");
    }
    fprintf(e->file, "    /* and off = 1 - %s guess^5, so that %s^(-1/5) = guess (1 - off)^(-1/5) */\n", x, x);
    put_root_step(e, 1, x, "guess", root->degree > 0 ? "better" : "inverse", root->seed, 3);
    if (root->degree > 0)
        put_root_step(e, 2, x, "better", "inverse", root->step, root->degree);
    let(e, real_type(e), "square", "inverse * inverse");
    let(e, real_type(e), name, "%s * (square * square)", x);
}

void emit_let_row_of_bits(struct emit *e, const char *row, const char *t, const char *x, int low_bits,
                          unsigned long long first)
{
    const char *type = e->single ? "uint32_t" : "uint64_t";
    let_bits(e, "bits", x);
    let(e, type, "upper", "bits >> %d", low_bits);
    let(e, type, "start_bits", "upper << %d", low_bits);
    let_from_bits(e, "start", "start_bits");
    let(e, type, row, e->single ? "upper - %lluu" : "upper - UINT64_C(%llu)", first);
    let(e, real_type(e), t, "%s - start", x);
}

void emit_let_row_of_grid(struct emit *e, const char *row, const char *t, const char *x, double slope, double shift)
{
    char a[NUMBER_MAX], b[NUMBER_MAX];
    let(e, real_type(e), "place", "%s * %s + %s", x, real(a, e, slope), real(b, e, shift));
    let(e, "int", row, "(int)place");
    let(e, real_type(e), t, e->single ? "place - (float)%s" : "place - %s", row);
}

void emit_table(struct emit *e, const char *name, const double *value, slong rows, slong columns)
{
    fprintf(e->file, "    static const %s %s[%ld][%ld] = {\n", real_type(e), name, (long)rows, (long)columns);
    for (slong row = 0; row < rows; row++) {
        int column = fprintf(e->file, "        {") - 1;
        for (slong k = 0; k < columns; k++) {
            char number[NUMBER_MAX];
            real(number, e, value[row * columns + k]);
            if (column + (int)strlen(number) + 2 > COLUMNS)
                column = fprintf(e->file, "\n         ") - 2;
            column += fprintf(e->file, "%s%s", number, k + 1 < columns ? ", " : "");
        }
        fprintf(e->file, "}%s\n", row + 1 < rows ? "," : "");
    }
    fprintf(e->file, "    };\n");
}

void emit_function_close(struct emit *e, const char *x, const char *numerator, const char *denominator, bool vector)
{
    const char *over = denominator ? " / " : "", *last = denominator ? denominator : "";
    const int width = e->single ? 32 : 64;
    if (!vector) {
        fprintf(e->file, "    return %s >= 0 ? %s%s%s : %sNAN;\n}\n", x, numerator, over, last,
                e->single ? "" : "(double)");
        return;
    }
    fprintf(e->file, "    %s value = %s%s%s;\n", real_type(e), numerator, over, last);
    fprintf(e->file, "    /* all bits set is NaN */\n");
    fprintf(e->file, "    const int%d_t good = %s >= 0;\n", width, x);
    fprintf(e->file, "    int%d_t whole;\n    memcpy(&whole, &value, sizeof whole);\n    whole |= good - 1;\n", width);
    fprintf(e->file, "    memcpy(&value, &whole, sizeof value);\n    return value;\n}\n");
}
