/* SPDX-License-Identifier: MIT */
#include "support/emit_c.h"

#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/digits.h"
#include "support/local.h"

enum { COMMENT_DIGITS = 25, BITS_OF_SMALL = 40, WIDTH = 120, NUMBER_MAX = 40 };

/* Writes a comment. Separates a star and a slash in the text, and ends no line with a space. */
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
    *e = (struct emit){.file = file};
    fprintf(file, "/* SPDX-License-Identifier: MIT */\n");
    put_comment(file, banner);
    emit_lines(e, "#ifndef $S\n#define $S\n", guard, guard);
}

void emit_open_tables(struct emit *e, FILE *file, const char *name, const char *what, const char *how,
                      const char *includes)
{
    char *const guard = xprintf("COR_GENERATED_%s_TABLES_H", name),
                *const banner =
                    xprintf("%s\nWritten by:  corgen tables\nChecked by:  corgen tables --check\n\n%s", what, how);
    emit_open(e, file, guard, banner);
    fputs(includes, file);
    free(guard);
    free(banner);
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

/* Returns x as text: a fraction if x is exact with a small power of 2 as its denominator, otherwise its digits. */
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
            return fail("cannot round %s[%ld]: its enclosure is too wide", name, (long)i);
        }
        fprintf(e->file, "    %.17g, /* [%ld] %s */\n", y, (long)i, text);
        free(text);
    }
    fprintf(e->file, "};\n");
    return 0;
}

static const char *real_type(const struct emit *e)
{
    return e->single ? "float" : "double";
}

/* Writes a double or float as the shortest constant of C and C++ that reads back to the same bits. */
static const char *print_real(char text[NUMBER_MAX], const struct emit *e, double x)
{
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

/* Writes one number of a table; commas separate numbers and {rows}, and lines are filled. */
static void put_number(struct emit *e, const char *number, bool opens, bool closes)
{
    const int length = (int)strlen(number) + opens + closes;
    if (e->column > 0)
        e->column += fprintf(e->file, ",");
    if (e->column == 0 || e->column + length + 1 > WIDTH)
        e->column = fprintf(e->file, e->column > 0 ? "\n    " : "    ") - (e->column > 0);
    e->column += fprintf(e->file, "%s%s%s", opens ? "{" : "", number, closes ? "}" : "");
}

/* Writes one table entry. Also appends it with its digits to the digits file, if that is open. */
static int put_ball(struct emit *e, const arb_t x, slong column, bool opens, bool closes)
{
    double y;
    char number[NUMBER_MAX];
    const bool digits = digits_file && (!e->decimal || e->shared);
    char *const text = digits ? number_text(x) : NULL;
    const bool known = (text || !digits) && digits_to_double(&y, x);
    if (known && digits)
        fprintf(digits_file, "%s,%ld,%ld,%a,%s\n", e->table, (long)e->row, (long)column, y, text);
    free(text);
    if (!known)
        return fail("%s, row %ld: cannot round number %ld: its enclosure is too wide", e->table, (long)e->row,
                    (long)column);
    if (e->decimal)
        print_real(number, e, y);
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

/* A table of one row is local to its function, because compilers then use its numbers as constants. */
void emit_rows_open(struct emit *e, const char *type, const char *name, slong rows, slong columns)
{
    table_open(e, name);
    e->type = type;
    e->local = (e->decimal && !e->shared) || rows == 1;
    if (e->local)
        fprintf(e->file, "COR_INLINE const %s *%s(int i)\n{\n    static const %s row[%ld][%ld] = {\n", type, name, type,
                (long)rows, (long)columns);
    else
        fprintf(e->file, "COR_ROWS(%s, %s, %ld, %ld)\n#ifdef COR_ROWS_HERE\n= {\n", type, name, (long)rows,
                (long)columns);
}

int emit_row(struct emit *e, arb_srcptr value, slong columns)
{
    return emit_struct(e, NULL, 0, value, columns);
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

int emit_pair_field(struct emit *e, const char *field, const arb_t value)
{
    double hi = 0, lo = 0;
    LOCAL(arb, rest);
    const int known = digits_to_double(&hi, value);
    arb_set_d(rest, hi);
    arb_sub(rest, value, rest, 2 * FLINT_BITS + 64);
    if (!known || !digits_to_double(&lo, rest))
        return fail("%s: cannot round a number to two doubles: its enclosure is too wide", field);
    fprintf(e->file, "    x.%s.hi = %.17g;\n    x.%s.lo = %.17g;\n", field, hi, field, lo);
    return STATUS_OK;
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

void emit_geometry_real(struct emit *e, const char *table, const char *what, double x)
{
    char number[NUMBER_MAX];
    if (x == rint(x) && fabs(x) < 1e9)
        snprintf(number, sizeof number, "%.1f", x);
    else
        print_real(number, e, x);
    emit_lines(e, "#define $S_$s $s\n", table, what, number);
}

void emit_geometry_integer(struct emit *e, const char *table, const char *what, slong n)
{
    emit_lines(e, n < 0 ? "#define $S_$s ($d)\n" : "#define $S_$s $d\n", table, what, (int)n);
}

uint64_t emit_bits_of(bool single, double x)
{
    const float y = (float)x;
    uint32_t narrow;
    uint64_t wide;
    memcpy(&narrow, &y, sizeof narrow);
    memcpy(&wide, &x, sizeof wide);
    return single ? narrow : wide;
}

void emit_lines(struct emit *e, const char *text, ...)
{
    va_list arguments;
    char number[NUMBER_MAX];
    const char *name;
    va_start(arguments, text);
    for (; *text; text++) {
        if (*text != '$') {
            putc(*text, e->file);
            continue;
        }
        switch (*++text) {
        case 'T':
            fputs(real_type(e), e->file);
            break;
        case 'B':
            fputs(e->single ? "32" : "64", e->file);
            break;
        case 'F':
            fputs(e->single ? "f" : "", e->file);
            break;
        case 's':
            fputs(va_arg(arguments, const char *), e->file);
            break;
        case 'S':
            for (name = va_arg(arguments, const char *); *name; name++)
                putc(toupper((unsigned char)*name), e->file);
            break;
        case 'd':
            fprintf(e->file, "%d", va_arg(arguments, int));
            break;
        case 'x':
            fputs(print_real(number, e, va_arg(arguments, double)), e->file);
            break;
        default: /* 'b' */
            fprintf(e->file, "%" PRIu64, emit_bits_of(e->single, va_arg(arguments, double)));
        }
    }
    va_end(arguments);
}

/* Writes Horner's rule, c_0 + x * (c_1 + x * (... + x * c_n)). text[k]: c_k, where c_n may be the number 1 */
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

void emit_let_polynomial(struct emit *e, const char *name, const char *x, const double *c, slong degree, slong step)
{
    char(*text)[NUMBER_MAX] = xmalloc((size_t)(degree / step + 1) * sizeof *text);
    for (slong k = 0; k * step <= degree; k++)
        print_real(text[k], e, c[k * step]);
    put_horner(e, name, x, text, degree / step, degree >= step && c[degree / step * step] == 1);
    free(text);
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

void emit_table(struct emit *e, const char *name, const double *value, slong rows, slong columns)
{
    fprintf(e->file, "    static const %s %s[%ld][%ld] = {\n", real_type(e), name, (long)rows, (long)columns);
    for (slong row = 0; row < rows; row++) {
        int column = fprintf(e->file, "        {") - 1;
        for (slong k = 0; k < columns; k++) {
            char number[NUMBER_MAX];
            print_real(number, e, value[row * columns + k]);
            if (column + (int)strlen(number) + 2 > COLUMNS)
                column = fprintf(e->file, "\n         ") - 2;
            column += fprintf(e->file, "%s%s", number, k + 1 < columns ? ", " : "");
        }
        fprintf(e->file, "}%s\n", row + 1 < rows ? "," : "");
    }
    fprintf(e->file, "    };\n");
}
