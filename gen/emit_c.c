/* SPDX-License-Identifier: MIT */
#include "emit_c.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "console.h"
#include "digits.h"

enum { COMMENT_DIGITS = 25, BITS_OF_SMALL = 40, COMMENT_MAX = 4096 };

/* A comment; a star and a slash in the text are kept apart, and no line ends in a space. */
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
    char text[COMMENT_MAX];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    putc('\n', e->file);
    put_comment(e->file, text);
}

/* The fraction if the ball is one exactly and it has a binary denominator of few bits, else digits.
 */
static char *number_text(const arb_t x)
{
    if (!arb_is_exact(x) || arb_bits(x) > BITS_OF_SMALL || arf_cmpabs_2exp_si(arb_midref(x), BITS_OF_SMALL) > 0 ||
        (!arb_is_zero(x) && arf_cmpabs_2exp_si(arb_midref(x), -BITS_OF_SMALL) < 0))
        return digits_of_ball(x, COMMENT_DIGITS);
    fmpq_t exact;
    fmpq_init(exact);
    arf_get_fmpq(exact, arb_midref(x));
    char *text = fmpq_get_str(NULL, 10, exact);
    char *copy = xstrdup(text);
    flint_free(text);
    fmpq_clear(exact);
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

void emit_constants(struct emit *e, const char *const *name, const slong *value, slong count)
{
    fprintf(e->file, "enum {\n");
    for (slong i = 0; i < count; i++)
        fprintf(e->file, "    %s = %ld%s\n", name[i], (long)value[i], i + 1 < count ? "," : "");
    fprintf(e->file, "};\n");
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
