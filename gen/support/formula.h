/* SPDX-License-Identifier: MIT */
/* Computes formulas, which are written as texts, in balls:
 *
 *     LET(y, prec, "2*x/(1 - exp(-2*x)) - k^(1/3)", x, k);       y = ..., with prec bits
 *     if (HOLDS(prec, "abs(x) + 1/8 < m->bound", x, m->bound))   false also where balls do not decide
 *     EXACT(q, "(1 - nu^2)/Y", nu, Y);                           a rational number, without rounding
 *     RATIO("a/(b + 1)", a, b)                                   a rational number as a struct ratio
 *
 * At most 9 operands follow the text, with their C names: arb_t, fmpq_t, struct ratio, slong, int or double. The result
 * may be one of them. An operand of the type struct cor_exponents provides its exponents: law gives law->a and law->b,
 * &s->law gives s->law.a and s->law.b. + - * / ^ group as usual, -x^2 = -(x^2) and x^y^z = x^(y^z). Whole numbers,
 * rational operands and results of only these are exact. They are rounded only when combined with a ball or a double.
 * Functions: abs, acos, acosh, asin, digamma, exp, expm1, gamma, log, log1p, sinc, sinh, sqrt, and max and min of two
 * numbers. The number pi is available. A text that is not a formula ends the program.
 *
 * LET_COMPLEX also computes with acb_t, with + - * / ^, exp, sinc, sinh and sqrt. With `analytic`, a root or a
 * power that is not whole is not finite if its ball touches the cut. */
#ifndef COR_GEN_SUPPORT_FORMULA_H
#define COR_GEN_SUPPORT_FORMULA_H

#include <math.h>
#include <stdbool.h>

#include "cor/law.h"
#include "support/flint.h"

struct ratio {
    slong num;
    slong den; /* above 0; the fraction is in lowest terms */
};

struct operand {
    const char *name;
    arb_srcptr ball;
    acb_srcptr plane; /* complex */
    const arb_poly_struct *function;
    const fmpq *exact;
    struct ratio ratio; /* den = 0: absent */
    slong whole;        /* used if all other members are absent */
    double real;        /* NaN: absent */
    const struct cor_exponents *law;
};

#define LET(y, prec, ...) formula_ball(y, prec, FORMULA(__VA_ARGS__))
#define LET_COMPLEX(y, analytic, prec, ...) formula_complex(y, analytic, prec, FORMULA(__VA_ARGS__))
#define HOLDS(prec, ...) formula_holds(prec, FORMULA(__VA_ARGS__))
#define EXACT(q, ...) formula_exact(q, FORMULA(__VA_ARGS__))
#define RATIO(...) formula_ratio(FORMULA(__VA_ARGS__))

void formula_ball(arb_t y, slong prec, const char *text, const struct operand *operands);
void formula_complex(acb_t y, bool analytic, slong prec, const char *text, const struct operand *operands);

/* The operations of LET_FUNCTION (enclosed_function.h), whose operands are functions. All except products return false
 * if the result is not proved to be defined. */
struct formula_algebra {
    slong bits;
    void (*multiply)(arb_poly_t z, const arb_poly_t x, const arb_poly_t y);
    bool (*inverse)(arb_poly_t y, const arb_poly_t x), (*exp)(arb_poly_t y, const arb_poly_t x);
    bool (*log)(arb_poly_t y, const arb_poly_t x), (*sqrt)(arb_poly_t y, const arb_poly_t x);
};
bool formula_function(arb_poly_t y, const struct formula_algebra *algebra, const char *text,
                      const struct operand *operands);
bool formula_holds(slong prec, const char *text, const struct operand *operands);
void formula_exact(fmpq_t q, const char *text, const struct operand *operands);
struct ratio formula_ratio(const char *text, const struct operand *operands);

#ifdef __cppcheck__ /* cppcheck does not read _Generic */
#define FORMULA(...) FORMULA_TEXT(__VA_ARGS__, 0), NULL
#else
#define FORMULA(...)                                                                                                   \
    FORMULA_TEXT(__VA_ARGS__, 0), (const struct operand[])                                                             \
    {                                                                                                                  \
        FORMULA_OF(__VA_ARGS__, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0, 0)(__VA_ARGS__)                                          \
        {                                                                                                              \
            NULL, NULL, NULL, NULL, NULL, {0, 0}, 0, 0, NULL                                                           \
        }                                                                                                              \
    }
#endif
#define FORMULA_TEXT(text, ...) text
#define FORMULA_OF(text, a, b, c, d, e, f, g, h, i, n, ...) OPERANDS_##n
#define OPERANDS_0(t)
#define OPERANDS_1(t, x) OPERAND(#x, x)
#define OPERANDS_2(t, x, ...) OPERAND(#x, x) OPERANDS_1(t, __VA_ARGS__)
#define OPERANDS_3(t, x, ...) OPERAND(#x, x) OPERANDS_2(t, __VA_ARGS__)
#define OPERANDS_4(t, x, ...) OPERAND(#x, x) OPERANDS_3(t, __VA_ARGS__)
#define OPERANDS_5(t, x, ...) OPERAND(#x, x) OPERANDS_4(t, __VA_ARGS__)
#define OPERANDS_6(t, x, ...) OPERAND(#x, x) OPERANDS_5(t, __VA_ARGS__)
#define OPERANDS_7(t, x, ...) OPERAND(#x, x) OPERANDS_6(t, __VA_ARGS__)
#define OPERANDS_8(t, x, ...) OPERAND(#x, x) OPERANDS_7(t, __VA_ARGS__)
#define OPERANDS_9(t, x, ...) OPERAND(#x, x) OPERANDS_8(t, __VA_ARGS__)
#define OPERAND(name, x)                                                                                               \
    {name, _Generic((x), arb_struct *: (x), const arb_struct *: (x), default: NULL), \
     _Generic((x), acb_struct *: (x), const acb_struct *: (x), default: NULL), \
     _Generic((x), arb_poly_struct *: (x), const arb_poly_struct *: (x), default: NULL), \
     _Generic((x), fmpq *: (x), const fmpq *: (x), default: NULL),                                                     \
     _Generic((x), struct ratio: (x), default: (struct ratio){0, 0}), _Generic((x), int: (x), slong: (x), default: 0), \
     _Generic((x), double: (x), default: NAN),                                                                         \
     _Generic((x), struct cor_exponents *: (x), const struct cor_exponents *: (x), default: NULL)},

#endif
