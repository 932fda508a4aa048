/* SPDX-License-Identifier: MIT */
/* A form: a way to compute eps from the speed in the arithmetic of the header, what it costs and how far it is off. */
#ifndef COR_GEN_EMBED_FORM_H
#define COR_GEN_EMBED_FORM_H

#include <stdint.h>

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

/* What the polynomials are in. */
enum embed_variable { SPEED, SQRT_OF_SPEED, FOURTH_ROOT_OF_SPEED, FIFTH_ROOT_OF_SPEED, TENTH_ROOT_OF_SPEED };

/* Operations by kind. A product that is added to something is one mul_add: one instruction where the target has
 * fused multiplication, two elsewhere. */
enum embed_operation {
    OP_MUL_ADD,
    OP_MUL,
    OP_ADD,
    OP_DIV,
    OP_SQRT,
    OP_BITS,    /* shift, mask or sum of integers */
    OP_LOAD,    /* a number out of a table, at a place that depends on the speed */
    OP_CONVERT, /* between integers and floating point */
    OP_COMPARE, /* with the choice that follows */
    OPERATIONS
};
extern const char *const embed_operation_names[OPERATIONS];

enum embed_use { USE_SCALAR, USE_ARRAY, USES };

/* Fifth roots from bits: how many times they are refined, and the relative error left. */
enum { EMBED_REFINEMENTS = 4 };
double embed_root_error(int refinement, bool single);

/* g^(-1/5) from g, both as whole numbers made of their bits: constant - fifth n. Then r (1 - e)^(-1/5), e = 1 - g r^5:
 * embed_root_seed up to e^3 for the guess, whose |e| < 0.155 (through Chebyshev's points), embed_root_step afterwards,
 * up to the power `refinement`. */
#define EMBED_ROOT_FIFTH 0.2
#define EMBED_ROOT_CONSTANT 5404320840011480.0 /* 1.2 2^52 + 1287166885, of the upper half of a double's bits */
#define EMBED_ROOT_SINGLE 1277903765u
extern const double embed_root_seed[4], embed_root_step[4];

/* From this degree on a polynomial is two, in x^2, of the even and of the odd powers: as quick in a loop as Horner's
 * rule, a little quicker in calls, and a result waits a fifth less for its argument. Not the rows of tables, which are
 * short. */
enum { EMBED_SPLIT = 4 };

/* What a table may take of the memory next to the processor, and of speeds, where so little does not suffice. */
enum { EMBED_TABLE_BYTES = 4096, EMBED_TABLE_BYTES_MOST = 16384 };

struct embed_form {
    enum embed_family family;
    enum embed_variable variable;
    double speed_min, speed_max;
    slong numerator, denominator;
    slong rows;     /* of a table of polynomials of degree `numerator`; 0 for none */
    double *number; /* p_0, ..., p_m, q_0, ..., q_n; or the rows. Malloc'ed */
    /* pieces in beta: the row is the whole part of y slope + shift, y the fifth root of the speed */
    double slope, shift;
    /* pieces in speed: the bits of the speed, shifted down by low_bits, less the first */
    uint64_t first;
    double error, error_at; /* worst of the samples, relative; the speed there */
    double cost[USES];      /* ns */
    int operations[OPERATIONS];
    int refinement; /* where the variable is made from a fifth root */
    int low_bits;
    bool single;
    bool found; /* else why says what is in the way */
    char why[94];
};

void embed_form_clear(struct embed_form *f);

/* The header's function, in its arithmetic: operation by operation what emit_form writes. fused: products that are
 * added are rounded once, as compilers may do. */
double embed_form_value(const struct embed_form *f, double speed, bool fused);

/* Fills error and error_at from every stride-th sample. */
void embed_form_assess(struct embed_form *f, const struct embed_samples *samples, slong stride);

/* Fills operations and cost. */
void embed_form_price(struct embed_form *f);

/* For spheres speed^(1/5) is called beta. */
const char *embed_family_name(enum embed_family family, const struct law *law);
/* "[5/6]", "degree 7", "54 rows of degree 3": size as a reader wants it */
void embed_form_size(char *text, size_t size, const struct embed_form *f);

/* The bits of a number of the header's type, and the number that has them. */
uint64_t embed_bits_of(const struct embed_form *f, double x);
double embed_from_bits(const struct embed_form *f, uint64_t bits);

#endif
