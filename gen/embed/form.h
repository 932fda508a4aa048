/* SPDX-License-Identifier: MIT */
/* A form is a formula for eps in the arithmetic of a generated header. This file declares the search for the cheapest
 * form that meets the tolerance of a scene, the proof of its error, and the function that writes its header. */
#ifndef COR_GEN_EMBED_FORM_H
#define COR_GEN_EMBED_FORM_H

#include <stdint.h>
#include <stdio.h>

#include "embed/scene.h"

enum embed_family {
    FAMILY_SERIES,
    FAMILY_PADE,
    FAMILY_TWO_POINT,
    FAMILY_POLYNOMIAL_BETA,
    FAMILY_RATIONAL_BETA,
    FAMILY_PIECES_BETA,
    FAMILY_PIECES_SPEED,
    FAMILY_RATIONAL_SPEED,
    FAMILY_RATIONAL_SQRT,
    FAMILY_RATIONAL_FOURTH,
    FAMILIES
};

/* The variable of the polynomials */
enum embed_variable { SPEED, SQRT_OF_SPEED, FOURTH_ROOT_OF_SPEED, FIFTH_ROOT_OF_SPEED, TENTH_ROOT_OF_SPEED };

/* Kinds of operations. A multiplication and the addition that follows count as one mul_add: one instruction on targets
 * with fused multiply-add, two on others. */
enum embed_operation {
    OP_MUL_ADD,
    OP_MUL,
    OP_ADD,
    OP_DIV,
    OP_SQRT,
    OP_BITS,    /* shift, mask or sum of integers */
    OP_LOAD,    /* a load from a table at an index that depends on the speed */
    OP_CONVERT, /* conversions between integers and floating point */
    OP_COMPARE, /* a comparison and the selection that follows */
    OPERATIONS
};
extern const char *const embed_operation_names[OPERATIONS];

enum embed_use { USE_SCALAR, USE_ARRAY, USES };

/* Each variable is speed^(1/degree). It is computed by this number of square roots, after a fifth root if `fifth`. */
extern const struct embed_root {
    slong degree;
    bool fifth;
    int square_roots;
} embed_roots[];

/* The number of refinement levels of the fifth root, and the relative error of this root at a level */
enum { EMBED_REFINEMENTS = 4 };
double embed_root_error(int refinement, bool single);

/* The fifth root of g. A start value r of g^(-1/5) has the bits of EMBED_ROOT_CONSTANT - EMBED_ROOT_FIFTH n, where n is
 * the integer with the bits of g. A step multiplies r by a polynomial in e = 1 - g r^5 that approximates (1 -
 * e)^(-1/5). In step 0, |e| < 0.155, and the polynomial interpolates at four Chebyshev points. In step 1 it is the
 * Taylor series up to e^refinement. */
#define EMBED_ROOT_FIFTH 0.2
#define EMBED_ROOT_CONSTANT 5404320840011480.0 /* 1.2 2^52 + 1287166885, for the upper half of a double's bits */
#define EMBED_ROOT_SINGLE 1277903765u

/* A polynomial of this degree or more is split into two polynomials in x^2, one for the even and one for the odd
 * powers. In a loop the split is as fast as Horner's rule. In single calls it is slightly faster, and its latency is a
 * fifth smaller. Rows of tables are short and are not split. */
enum { EMBED_SPLIT = 4 };

/* Largest size of a table in bytes, chosen for the processor's cache. A table in speed may be larger, up to
 * EMBED_TABLE_BYTES_MOST, if no smaller one meets the tolerance. */
enum { EMBED_TABLE_BYTES = 4096, EMBED_TABLE_BYTES_MOST = 16384 };

struct embed_form {
    enum embed_family family;
    enum embed_variable variable;
    double speed_min, speed_max;
    double onset;  /* 0: none */
    double before; /* eps at speeds up to the onset */
    double origin; /* origin, which is subtracted from every speed of this struct except the onset */
    slong numerator, denominator;
    slong rows;     /* number of rows of a table of polynomials of degree `numerator`; 0: no table */
    double *number; /* p_0, ..., p_m, q_0, ..., q_n, or the rows; malloc'ed */
    /* pieces in beta: the row is the integer part of y slope + shift, where y is the fifth root of the speed */
    double slope, shift;
    /* pieces in speed: the row is the bits of the speed, shifted down by low_bits, minus `first` */
    uint64_t first;
    /* pieces in speed: start of each row, and end of the last one; NULL: the row follows from the bits */
    const double *knot;
    double error, error_at; /* worst relative error of the samples, and its speed */
    double cost[USES];      /* ns */
    int operations[OPERATIONS];
    int refinement; /* refinement of the fifth root, for variables that use it */
    int low_bits;
    bool single;
    bool found; /* if false, `why` holds the reason */
    char why[94];
};

void embed_form_clear(struct embed_form *f);

/* The program of a form: the function of the header as a list of steps. form.c evaluates the steps and counts their
 * operations. header.c prints them. rounding.c bounds their rounding errors. proof.c encloses their values without
 * rounding, as functions of the speed. */
enum embed_code {
    STEP_CLAMP,         /* the speed, limited to the range of the form */
    STEP_START,         /* the start value of x^(-1/5) */
    STEP_ROW_OF_BITS,   /* x minus the start of its row, whose number comes from the upper bits of x */
    STEP_ROW_OF_SEARCH, /* x minus the start of its row; the row is found by a search in a table */
    STEP_ROW_OF_PLACE,  /* the fractional part of x slope + shift; the integer part is the row */
    STEP_SQRT,
    STEP_HORNER,  /* c[0] + c[stride] x + ... + c[degree] x^(degree/stride); c NULL: the numbers of a row */
    STEP_DIV,     /* x/y */
    STEP_MUL,     /* x y */
    STEP_MUL_ADD, /* z + x y */
    STEP_OFF      /* 1 - x y */
};
enum { EMBED_STEPS = 28 };

struct embed_program {
    struct embed_step {
        enum embed_code code;
        const char *name; /* name of the variable in the header, or an expression for later lines */
        int x, y, z;      /* earlier steps; step 0 uses the speed */
        const double *c;
        slong degree, stride;
    } step[EMBED_STEPS];
    int count;
    int x, argument; /* steps: x: the root of the speed; argument: x itself, or the place of the root in a row */
    int p, q;        /* steps of the polynomials; q = 0: no denominator */
};
/* Returns the program of a form, which points to the numbers of the form. */
struct embed_program embed_program_of(const struct embed_form *f);

/* Returns the start value of g^(-1/5) as the header computes it without fused operations. It does not rise with g. */
double embed_root_start(const struct embed_form *f, double g);

/* Evaluates the header's function in the arithmetic of the header. `fused`: a product and its addition are rounded
 * once, as compilers may do. */
double embed_form_value(const struct embed_form *f, double speed, bool fused);

/* Fills error and error_at from every stride-th sample. */
void embed_form_assess(struct embed_form *f, const struct embed_samples *samples, slong stride);

/* Sets `operations`, the counts of one evaluation, and `cost`. */
void embed_form_price(struct embed_form *f);

/* Returns the cost for a purpose. The balanced cost is the mean of a single call (weight 1) and an array element
 * (weight 4). */
double embed_cost(const double cost[USES], enum embed_purpose purpose);

/* Returns the name of a family. For spheres without a constant force the name has beta in place of speed^(1/5). */
const char *embed_family_name(enum embed_family family, const struct embed_scene *s);
/* Writes the size as text: "[5/6]", "degree 7", "54 rows, degree 3" */
void embed_form_size(char *text, size_t size, const struct embed_form *f);

/* Returns the number of the header's type with these bits; the inverse of emit_bits_of */
double embed_from_bits(const struct embed_form *f, uint64_t bits);
/* Returns the first speed of a row of FAMILY_PIECES_SPEED */
double embed_row_start(const struct embed_form *f, slong row);

/* ---- coefficients ----
 *
 * Each function fills f->number for its kind of form, rounded to the scene's type. It returns false if the system is
 * singular, if the denominator is not shown to be positive on the whole range, or if the type cannot hold a
 * coefficient. */

/* Interpolates eps by a polynomial or a rational function of f->variable, with the degrees of f. The result is close to
 * the best approximation. */
bool embed_fit_rational(struct embed_form *f, const struct embed_scene *s);

/* Converts the quotient of p and q in z = beta^(1/series_root) to f->variable, a root of the speed. q may be 1. */
bool embed_fit_quotient(struct embed_form *f, const struct embed_scene *s, const arb_poly_t p, const arb_poly_t q);

/* Interpolates eps by polynomials of degree f->numerator on f->rows pieces. FAMILY_PIECES_BETA divides the fifth root
 * into equal pieces. FAMILY_PIECES_SPEED has the pieces of f->first and f->low_bits, or of f->knot. */
bool embed_fit_pieces(struct embed_form *f, const struct embed_scene *s);

/* ---- the choice (choose.c) ---- */

/* Fills form[FAMILIES] with the cheapest form of each family that meets the scene's tolerance, or with the reason why
 * none was found. */
void embed_search(struct embed_form *form, const struct embed_scene *s);

/* Returns the cheapest family for a purpose, or FAMILIES if no form was found. */
enum embed_family embed_choose(const struct embed_form *form, enum embed_purpose purpose);

/* ---- the proof of a form's error at every speed of its scene (proof.c, docs/embed.md, "Tolerance") ----
 *
 * It bounds the difference between the formula and eps, and adds the rounding errors. eps is a closed form, the proved
 * interpolant of the collision, or the proved limit at large beta (row_proof.h). */

/* eps at zero overlap is h*^5 beta^-5 (1 - d) with 0 < d < EMBED_FAR_ERROR for beta >= EMBED_FAR.
 * tests/gen/test_embed.c encloses d at EMBED_FAR; d falls as beta grows (docs/theory.md, 4). */
#define EMBED_FAR 7.0
#define EMBED_FAR_ERROR 2.7e-17

struct embed_proof {
    double error;    /* relative error of the header's eps; infinite without a proof */
    double formula;  /* the error of the formula without rounding */
    double rounding; /* the error of the rounding */
    bool proved;     /* the error is proved at the speeds >= from (m/s) of the range */
    double from;
};

/* Bounds the error of a form that embed_form_assess has sampled. If the proof fails, `proved` is false. Returns
 * STATUS_OK, or STATUS_FAILED after a message if an interpolant is shown to be wrong. */
int embed_prove(struct embed_proof *proof, const struct embed_form *f, const struct embed_scene *s);

/* Proved bounds of the rounding errors of a form in the arithmetic of its header (rounding.c). They assume IEEE 754
 * arithmetic rounded to nearest, with a correctly rounded square root. They hold for any mixture of fused and separate
 * operations. */
struct embed_rounding {
    double error; /* relative error of the result; includes the error of the root of the speed */
    double root;  /* relative error of the root of the speed */
    double place; /* absolute error of x slope + shift (pieces in beta); 0 for other forms */
};

/* Returns false if no bound was found. */
bool embed_rounding_bound(struct embed_rounding *bound, const struct embed_form *f);

/* ---- the header (header.c) ---- */

/* Writes the function, and a banner that states the choice and its reasons. */
void embed_header_write(FILE *file, const struct embed_request *request, const struct embed_scene *s,
                        const struct embed_form *form, enum embed_family chosen, const struct embed_proof *proof);

/* Returns a malloc'ed text with the reason of each family: "series in beta: ...; Pade in beta: ..." */
char *embed_failures(const struct embed_scene *s, const struct embed_form *form);

#endif
