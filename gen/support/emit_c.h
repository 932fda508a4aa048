/* SPDX-License-Identifier: MIT */
/* Only this file contains C syntax. Its functions write all C text that corgen emits. */
#ifndef COR_GEN_SUPPORT_EMIT_C_H
#define COR_GEN_SUPPORT_EMIT_C_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "support/flint.h"

struct emit {
    FILE *file;
    bool single;              /* emit_lines and the functions after it write float instead of double */
    bool decimal;             /* rows and structs in 17 decimal digits, which every C and C++ compiler reads, instead of
                               * hexadecimal */
    bool shared;              /* rows always use the macros of runtime/table/rows.h */
    const char *table, *type; /* name of the current rows or structs, their type, the number of elements written, and
                               * the length of the last line */
    slong row;
    int column;
    bool local; /* true if the table is local to its function */
};

/* From now on, also writes each double of emit_row and emit_struct to a csv file, table,row,column,value,digits. The
 * column digits has 25 significant digits, or an exact fraction of small integers. Omits the numbers of headers with
 * `decimal` but not `shared`. NULL ends the csv file. */
void emit_digits(FILE *file);

/* Writes the licence line, the banner and the include guard. The guard is written in capitals. The banner is plain text
 * with line breaks. No text can end the comment early. */
void emit_open(struct emit *e, FILE *file, const char *guard, const char *banner);
void emit_close(struct emit *e);

/* Opens NAME_tables.h of generated/. The banner contains `what` (the contents), the commands that write and check the
 * file, and `how` (the source of its errors). `includes` are lines that include other headers. */
void emit_open_tables(struct emit *e, FILE *file, const char *name, const char *what, const char *how,
                      const char *includes);
#define EMIT_INCLUDE_ROWS "#include \"runtime/table/rows.h\"\n"

/* Writes a comment on lines of its own, after an empty line. */
void emit_comment(struct emit *e, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Writes static const double name[]: the doubles nearest to the values, in hexadecimal. A comment gives each value in
 * decimal, exact if it is a fraction of small integers. Returns 0, or 1 after reporting on stderr the interval that is
 * too wide to be rounded. */
int emit_doubles(struct emit *e, const char *name, arb_srcptr value, slong length);

/* Writes a function const TYPE *name(int i) that returns row i, TYPE double or float. The table is local to it if it
 * has one row, or if `decimal` is true and `shared` is not (the text then also works on a GPU). Otherwise
 * runtime/table/rows.h decides. Call open, emit_row or emit_float_row for each row, and close. Numbers fill the lines.
 * emit_row returns 0, or 1 after reporting the interval that is too wide. emit_one_row writes a table of one row. */
void emit_rows_open(struct emit *e, const char *type, const char *name, slong rows, slong columns);
int emit_row(struct emit *e, arb_srcptr value, slong columns);
void emit_float_row(struct emit *e, const double *value, slong columns);
void emit_rows_close(struct emit *e);
int emit_one_row(struct emit *e, const char *name, arb_srcptr value, slong columns);

/* Writes static const struct TYPE name[count], whose fields are integers and then doubles. Call open, emit_struct for
 * each element, and close. emit_struct returns as emit_row. */
void emit_structs_open(struct emit *e, const char *type, const char *name, slong count);
int emit_struct(struct emit *e, const slong *whole, slong wholes, arb_srcptr value, slong values);
void emit_structs_close(struct emit *e);

/* Writes #define TABLE_WHAT, a number of a table's geometry. TABLE is the table's name in capitals. Reals are written
 * in decimal and read back to the same bits. */
void emit_geometry_real(struct emit *e, const char *table, const char *what, double x);
void emit_geometry_integer(struct emit *e, const char *table, const char *what, slong n);

/* Writes the statement that sets a field of a struct x, a pair with hi and lo, from an interval. */
int emit_pair_field(struct emit *e, const char *field, const arb_t value);

/* Writes a text. $T becomes the type of real numbers, $B its number of bits, $F the ending of its functions and
 * numbers, "f" or nothing. Arguments replace $s (a text), $S (a text, in capitals) and $d (an int). $x and $b write a
 * double: as text that reads back to the same bits, or its bits as an integer. */
void emit_lines(struct emit *e, const char *text, ...);
uint64_t emit_bits_of(bool single, double x); /* the bits of x, for $b */

/* Define `name` as a polynomial in a variable by Horner's rule. Its coefficients are c[0], c[step], ... up to
 * c[degree], or a row of a table. An addition follows every product, so compilers differ only if they fuse the two. */
void emit_let_polynomial(struct emit *e, const char *name, const char *x, const double *c, slong degree, slong step);
void emit_let_row_polynomial(struct emit *e, const char *name, const char *table, const char *row, const char *t,
                             slong degree);
/* Writes a table local to a function, for these polynomials. */
void emit_table(struct emit *e, const char *name, const double *value, slong rows, slong columns);

/* The text of a bound: x >= 0 rounded up to two significant digits, such as "5.3e-11" */
struct bound_text {
    char text[32];
};
struct bound_text emit_bound(double x);

/* The text of the runtime's evaluator, runtime/number/{inline,pair,fifth_root}.h, runtime/table/row.h and
 * runtime/sphere/eval.h or runtime/table/law.h, in this order. The library and the headers to embed thus share one
 * source. The build copies the text into corgen (cmake/EvaluatorText.cmake), without the lines that include one another
 * and without licence lines. */
extern const char evaluator_inline[], evaluator_pair[], evaluator_elementary[], evaluator_fifth_root[], evaluator_row[],
    evaluator_sphere[], evaluator_law[];

#endif
