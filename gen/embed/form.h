/* SPDX-License-Identifier: MIT */
/* A form computes eps from the speed in the arithmetic of the header. The struct holds its cost and its error. Its
 * coefficients, the search for the cheapest one that meets a scene's tolerance, its proof and its header */
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

/* Operations by kind. A product that is added is one mul_add, which is one instruction on targets with fused
 * multiplication and two on others. */
enum embed_operation {
    OP_MUL_ADD,
    OP_MUL,
    OP_ADD,
    OP_DIV,
    OP_SQRT,
    OP_BITS,    /* shift, mask or sum of integers */
    OP_LOAD,    /* a load from a table at a place that depends on the speed */
    OP_CONVERT, /* between integers and floating point */
    OP_COMPARE, /* with the selection that follows */
    OPERATIONS
};
extern const char *const embed_operation_names[OPERATIONS];

enum embed_use { USE_SCALAR, USE_ARRAY, USES };

/* It is speed^(1/degree): the speed or its fifth root, of which so many square roots are taken. */
extern const struct embed_root {
    slong degree;
    bool fifth;
    int square_roots;
} embed_roots[];

/* Fifth roots from bits: the largest number of refinements, and the relative error after each */
enum { EMBED_REFINEMENTS = 4 };
double embed_root_error(int refinement, bool single);

/* constant - fifth n gives g^(-1/5) from g, where both are integers made of their bits. Then r (1 - e)^(-1/5), e = 1 -
 * g r^5, improves r. The coefficients of step 0 have terms up to e^3, interpolated at Chebyshev points, for the start
 * value with |e| < 0.155; those of step 1 follow, up to the power `refinement`. */
#define EMBED_ROOT_FIFTH 0.2
#define EMBED_ROOT_CONSTANT 5404320840011480.0 /* 1.2 2^52 + 1287166885, of the upper half of a double's bits */
#define EMBED_ROOT_SINGLE 1277903765u

/* From this degree on a polynomial is split into two in x^2, one of the even and one of the odd powers. In a loop this
 * is as fast as Horner's rule, in calls a little faster, and the latency is a fifth smaller. The rows of tables, which
 * are short, are not split. */
enum { EMBED_SPLIT = 4 };

/* Largest size of a table in the processor's cache, and the larger limit for tables in speed where the first does not
 * suffice */
enum { EMBED_TABLE_BYTES = 4096, EMBED_TABLE_BYTES_MOST = 16384 };

struct embed_form {
    enum embed_family family;
    enum embed_variable variable;
    double speed_min, speed_max;
    double onset; /* up to this speed the value is `before`; 0: there is none */
    double before;
    double origin; /* from which every other speed of the struct, and that of the formula, is counted */
    slong numerator, denominator;
    slong rows;     /* rows of a table of polynomials of degree `numerator`; 0: no table */
    double *number; /* p_0, ..., p_m, q_0, ..., q_n; or the rows. Malloc'ed */
    /* pieces in beta: the row is the integer part of y slope + shift, where y is the fifth root of the speed */
    double slope, shift;
    /* pieces in speed: the row is the bits of the speed, shifted down by low_bits, minus `first` */
    uint64_t first;
    /* or the last of these numbers that is not above the speed; there are rows + 1; NULL: by bits */
    const double *knot;
    double error, error_at; /* worst relative error of the samples, and its speed */
    double cost[USES];      /* ns */
    int operations[OPERATIONS];
    int refinement; /* for variables computed from a fifth root */
    int low_bits;
    bool single;
    bool found; /* if false, `why` holds the reason */
    char why[94];
};

void embed_form_clear(struct embed_form *f);

/* The program of a form: the header's function as a list of steps. form.c computes their values and counts their
 * operations, header.c prints them, rounding.c bounds their rounding errors, and proof.c encloses their values without
 * rounding as functions of the speed. */
enum embed_code {
    STEP_CLAMP,         /* the speed, limited to the range of the form */
    STEP_START,         /* the start value of x^(-1/5) */
    STEP_ROW_OF_BITS,   /* the distance from x down to the start of a row, whose number is the upper bits of x */
    STEP_ROW_OF_SEARCH, /* the distance from x down to the start of a row, which is searched in a table */
    STEP_ROW_OF_PLACE,  /* the fraction of x slope + shift, whose integer part is the row */
    STEP_SQRT,
    STEP_HORNER,  /* c[0] + c[stride] x + ... + c[degree] x^(degree/stride); c NULL: of the numbers of a row */
    STEP_DIV,     /* x/y */
    STEP_MUL,     /* x y */
    STEP_MUL_ADD, /* z + x y */
    STEP_OFF      /* 1 - x y */
};
enum { EMBED_STEPS = 28 };

struct embed_program {
    struct embed_step {
        enum embed_code code;
        const char *name; /* of the header's variable, or an expression that later lines contain */
        int x, y, z;      /* steps before this one. Step 0 takes the speed. */
        const double *c;
        slong degree, stride;
    } step[EMBED_STEPS];
    int count;
    int x, argument; /* the root of the speed; the variable of the polynomials, that root or its place in a row */
    int p, q;        /* the polynomials; q = 0 if there is no denominator */
};
/* It refers to the numbers of the form. */
struct embed_program embed_program_of(const struct embed_form *f);

/* The start value of g^(-1/5), as the header computes it without fused operations. It does not rise with g. */
double embed_root_start(const struct embed_form *f, double g);

/* The header's function in its arithmetic. `fused`: a product and its
 * addition are rounded once, as compilers may do. */
double embed_form_value(const struct embed_form *f, double speed, bool fused);

/* Fills error and error_at from every stride-th sample. */
void embed_form_assess(struct embed_form *f, const struct embed_samples *samples, slong stride);

/* Fills operations, those of an evaluation with its numbers, and cost. */
void embed_form_price(struct embed_form *f);

/* The cost for a purpose; for the balanced one a single call counts as much as four numbers of an array. */
double embed_cost(const double cost[USES], enum embed_purpose purpose);

/* For spheres without a constant force the text calls speed^(1/5) beta. */
const char *embed_family_name(enum embed_family family, const struct embed_scene *s);
/* The size as text: "[5/6]", "degree 7", "54 rows of degree 3" */
void embed_form_size(char *text, size_t size, const struct embed_form *f);

/* The number of the header's type with these bits, which emit_bits_of tells */
double embed_from_bits(const struct embed_form *f, uint64_t bits);
/* The first speed of a row of FAMILY_PIECES_SPEED */
double embed_row_start(const struct embed_form *f, slong row);

/* ---- coefficients ----
 *
 * Each function fills f->number for its kind of form, rounded to the scene's type. It returns false if the system is
 * singular, if the denominator is not shown to be positive on the whole range, or if the type cannot hold a
 * coefficient. */

/* Polynomial or rational interpolation in f->variable, with the degrees of f. The result is close to the best
 * approximation. */
bool embed_fit_rational(struct embed_form *f, const struct embed_scene *s);

/* The quotient of p and q in z = beta^(1/series_root), converted to the root of the speed that f->variable becomes; q
 * may be 1 */
bool embed_fit_quotient(struct embed_form *f, const struct embed_scene *s, const arb_poly_t p, const arb_poly_t q);

/* Polynomials of degree f->numerator on f->rows pieces: FAMILY_PIECES_BETA on equal ones of the fifth root;
 * FAMILY_PIECES_SPEED on those that f->first and f->low_bits make */
bool embed_fit_pieces(struct embed_form *f, const struct embed_scene *s);

/* ---- the choice (choose.c) ---- */

/* Fills form[FAMILIES], one for each family, found or not: the cheapest member that meets the scene's tolerance. */
void embed_search(struct embed_form *form, const struct embed_scene *s);

/* The cheapest family for a purpose, or FAMILIES if none was found. */
enum embed_family embed_choose(const struct embed_form *form, enum embed_purpose purpose);

/* ---- the proof (proof.c, docs/embed.md, "Tolerance") ----
 *
 * A bound of a form's error at every speed of its scene. The formula with the header's coefficients is compared with
 * the proved interpolant of the collision as functions (row_proof.h), beyond it with what is proved at large beta
 * (row_proof.h), and the rounding errors are added. */

/* eps at zero overlap is h*^5 beta^-5 (1 - d) with 0 < d < EMBED_FAR_ERROR for beta >= EMBED_FAR.
 * tests/gen/test_embed.c encloses d at EMBED_FAR; d falls as beta grows (docs/theory.md, 4). */
#define EMBED_FAR 7.0
#define EMBED_FAR_ERROR 2.7e-17

struct embed_proof {
    double error;    /* relative, of eps from the header; infinite without a proof */
    double formula;  /* of that the formula without rounding */
    double rounding; /* and the rounding */
    bool proved;     /* the error, at every speed of the range from this one on, m/s */
    double from;
};

/* Proves the error of a form of spheres, sampled before. For other laws only the rounding has a bound. Returns
 * STATUS_OK, also without a proof, or STATUS_FAILED after a message if an interpolant is shown to be wrong. */
int embed_prove(struct embed_proof *proof, const struct embed_form *f, const struct embed_scene *s);

/* Proved bounds of the rounding errors of a form in the arithmetic of its header (rounding.c). They assume IEEE 754
 * arithmetic rounded to nearest with a correctly rounded square root, and hold for fused products and others in any
 * mixture. */
struct embed_rounding {
    double error; /* relative, of the result; includes the error of the root of the speed */
    double root;  /* relative, of that root */
    double place; /* absolute, of the place in a table in beta; 0 for other forms */
};

/* Returns false if no bound was found. */
bool embed_rounding_bound(struct embed_rounding *bound, const struct embed_form *f);

/* ---- the header (header.c) ---- */

/* One function, and a banner that states the choice and its reasons */
void embed_header_write(FILE *file, const struct embed_request *request, const struct embed_scene *s,
                        const struct embed_form *form, enum embed_family chosen, const struct embed_proof *proof);

/* A malloc'ed text about the failed families: "neither a series ..., nor ..." */
char *embed_failures(const struct embed_scene *s, const struct embed_form *form);

#endif
