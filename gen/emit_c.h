/* SPDX-License-Identifier: MIT */
/* The only file that knows C syntax: what corgen emits is written through these few calls. */
#ifndef COR_GEN_EMIT_C_H
#define COR_GEN_EMIT_C_H

#include <stdio.h>

#include "flint.h"

struct emit {
    FILE *file;
    const char *guard;
};

/* Licence line, banner, include guard. The banner is plain text; its line breaks are kept, and no
 * text can end the comment early. */
void emit_open(struct emit *e, FILE *file, const char *guard, const char *banner);
void emit_close(struct emit *e);

/* A comment on lines of its own, after an empty line. */
void emit_comment(struct emit *e, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* static const double name[]: the doubles nearest to the balls, hexadecimal, with the number itself
 * in decimal beside each (exact if it is a fraction of small whole numbers). Returns 0, or 1 after
 * saying on stderr which ball is too wide to be rounded. */
int emit_doubles(struct emit *e, const char *name, arb_srcptr value, slong length);

/* enum { NAME = value, ... }; */
void emit_constants(struct emit *e, const char *const *name, const slong *value, slong count);

/* #define NAME text */
void emit_define(struct emit *e, const char *name, const char *text);

/* A bound as text: x >= 0 rounded up to two significant digits, "5.3e-11". */
struct bound_text {
    char text[32];
};
struct bound_text emit_bound(double x);

#endif
