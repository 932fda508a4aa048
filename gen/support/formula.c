/* SPDX-License-Identifier: MIT */
#include "support/formula.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/local.h"

/* A number of a formula: the rational number `exact`, until an operation combines it with a ball */
struct value {
    acb_t ball;
    arb_poly_t function;
    fmpq_t exact;
    bool is_exact, is_function;
};

static void value_init(struct value *x)
{
    acb_init(x->ball);
    arb_poly_init(x->function);
    fmpq_init(x->exact);
    x->is_exact = true;
    x->is_function = false;
}

static void value_clear(struct value *x)
{
    acb_clear(x->ball);
    arb_poly_clear(x->function);
    fmpq_clear(x->exact);
}
LOCAL_STRUCT(value)

/* Returns the real part, which is the first member of both types. */
static arb_ptr real_of(struct value *x)
{
    return (arb_ptr)x->ball;
}

struct reader {
    const char *at, *text;
    const struct operand *operands;
    slong prec;
    bool in_plane, analytic;
    bool undefined;
    const struct formula_algebra *algebra; /* NULL: no functions */
};

static _Noreturn void refuse_formula(const struct reader *r)
{
    fprintf(stderr, "corgen: cannot read \"%s\" in the formula \"%s\"\n", r->at, r->text);
    abort();
}

/* Reads and returns the next character if it is in `which`. Otherwise reads nothing and returns 0. */
static char next_of(struct reader *r, const char *which)
{
    while (*r->at == ' ')
        r->at++;
    while (*which != '\0' && *which != *r->at)
        which++;
    return *which != '\0' ? *r->at++ : '\0';
}

static void expect_sign(struct reader *r, const char *which)
{
    if (next_of(r, which) != *which)
        refuse_formula(r);
}

static void become_ball(struct value *x, slong prec)
{
    if (x->is_exact)
        acb_set_fmpq(x->ball, x->exact, prec);
    x->is_exact = false;
}

static void become_function(struct value *x, slong prec)
{
    become_ball(x, prec);
    if (!x->is_function)
        arb_poly_set_arb(x->function, real_of(x));
    x->is_function = true;
}

static const struct {
    char name;
    void (*exact)(fmpq_t z, const fmpq_t x, const fmpq_t y);
    void (*ball)(arb_t z, const arb_t x, const arb_t y, slong prec);
    void (*plane)(acb_t z, const acb_t x, const acb_t y, slong prec);
} operations[] = {{'+', fmpq_add, arb_add, acb_add},
                  {'-', fmpq_sub, arb_sub, acb_sub},
                  {'*', fmpq_mul, arb_mul, acb_mul},
                  {'/', fmpq_div, arb_div, acb_div}};

static void combine_functions(struct value *y, char name, struct value *x, struct reader *r)
{
    become_function(x, r->prec);
    become_function(y, r->prec);
    if (name == '/')
        r->undefined = !r->algebra->inverse(x->function, x->function) || r->undefined;
    if (name == '+' || name == '-')
        (name == '+' ? arb_poly_add : arb_poly_sub)(y->function, y->function, x->function, r->prec);
    else
        r->algebra->multiply(y->function, y->function, x->function);
}

static void combine_values(struct value *y, char name, struct value *x, struct reader *r)
{
    const slong prec = r->prec;
    if (y->is_function || x->is_function) {
        combine_functions(y, name, x, r);
        return;
    }
    const size_t i = (size_t)(strchr("+-*/", name) - "+-*/");
    if (y->is_exact && x->is_exact && (name != '/' || !fmpq_is_zero(x->exact))) {
        operations[i].exact(y->exact, y->exact, x->exact);
    } else {
        become_ball(x, prec);
        become_ball(y, prec);
        if (acb_is_real(x->ball) && acb_is_real(y->ball))
            operations[i].ball(real_of(y), real_of(y), real_of(x), prec);
        else
            operations[i].plane(y->ball, y->ball, x->ball, prec);
    }
}

static void power_of(struct value *y, struct value *x, const struct reader *r)
{
    const slong prec = r->prec;
    if (y->is_function) {
        arb_poly_set(x->function, y->function);
        for (slong k = fmpz_get_si(fmpq_numref(x->exact)); k > 1; k--)
            r->algebra->multiply(y->function, y->function, x->function);
        return;
    }
    /* Powers with more than 12 bits of exponent would be too long, and FLINT refuses the longest without a message. */
    if (y->is_exact && x->is_exact && fmpz_is_one(fmpq_denref(x->exact)) && !fmpq_is_zero(y->exact) &&
        fmpz_bits(fmpq_numref(x->exact)) <= 12) {
        fmpq_pow_fmpz(y->exact, y->exact, fmpq_numref(x->exact));
        return;
    }
    become_ball(y, prec);
    if (x->is_exact && acb_is_real(y->ball)) {
        arb_pow_fmpq(real_of(y), real_of(y), x->exact, prec);
    } else if (x->is_exact && fmpz_is_one(fmpq_denref(x->exact))) {
        acb_pow_fmpz(y->ball, y->ball, fmpq_numref(x->exact), prec);
    } else if (acb_is_real(y->ball) && acb_is_real(x->ball)) {
        arb_pow(real_of(y), real_of(y), real_of(x), prec);
    } else {
        become_ball(x, prec);
        acb_pow_analytic(y->ball, y->ball, x->ball, r->analytic, prec);
    }
}

static void ball_abs(arb_t y, const arb_t x, slong prec)
{
    (void)prec;
    arb_abs(y, x);
}

static const struct {
    const char *name;
    void (*of_one)(arb_t y, const arb_t x, slong prec);
    void (*of_two)(arb_t z, const arb_t x, const arb_t y, slong prec);
    void (*plane)(acb_t y, const acb_t x, slong prec);
} functions[] = {
    {"abs", ball_abs, NULL, NULL},    {"acos", arb_acos, NULL, NULL},       {"acosh", arb_acosh, NULL, NULL},
    {"asin", arb_asin, NULL, NULL},   {"digamma", arb_digamma, NULL, NULL}, {"exp", arb_exp, NULL, acb_exp},
    {"expm1", arb_expm1, NULL, NULL}, {"gamma", arb_gamma, NULL, NULL},     {"log", arb_log, NULL, NULL},
    {"log1p", arb_log1p, NULL, NULL}, {"sinc", arb_sinc, NULL, acb_sinc},   {"sinh", arb_sinh, NULL, acb_sinh},
    {"sqrt", arb_sqrt, NULL, NULL},   {"max", NULL, arb_max, NULL},         {"min", NULL, arb_min, NULL}};

static void read_sum(struct value *y, struct reader *r);

static bool is_named(const char *name, const char *word, size_t length)
{
    return *name == *word && strncmp(name, word, length) == 0 && name[length] == '\0';
}

/* Returns the length of a name: letters, digits, _ . -> and an index in brackets. */
static size_t name_length(const char *text)
{
    size_t n = 0;
    while (isalnum((unsigned char)text[n]) || text[n] == '_' || text[n] == '.' || text[n] == '[' || text[n] == ']' ||
           (text[n] == '-' && text[n + 1] == '>') || (text[n] == '>' && n > 0 && text[n - 1] == '-'))
        n++;
    return n;
}

static void apply_to_function(arb_poly_t y, const char *name, struct reader *r)
{
    const bool is_exp = strcmp(name, "exp") == 0, is_log = strcmp(name, "log") == 0;
    if (!is_exp && !is_log && strcmp(name, "sqrt") != 0)
        refuse_formula(r);
    r->undefined = !(is_exp ? r->algebra->exp : is_log ? r->algebra->log : r->algebra->sqrt)(y, y) || r->undefined;
}

static void read_function(struct value *y, struct reader *r, const char *name, size_t length)
{
    LOCAL(value, x);
    size_t i = 0;
    while (i < sizeof functions / sizeof *functions && !is_named(functions[i].name, name, length))
        i++;
    if (i == sizeof functions / sizeof *functions)
        refuse_formula(r);
    read_sum(y, r);
    become_ball(y, r->prec);
    if (y->is_function) {
        apply_to_function(y->function, functions[i].name, r);
    } else if (functions[i].of_two && !r->in_plane) {
        expect_sign(r, ",");
        read_sum(x, r);
        become_ball(x, r->prec);
        functions[i].of_two(real_of(y), real_of(y), real_of(x), r->prec);
    } else if (!r->in_plane) {
        functions[i].of_one(real_of(y), real_of(y), r->prec);
    } else if (functions[i].of_one == arb_sqrt) {
        acb_sqrt_analytic(y->ball, y->ball, r->analytic, r->prec);
    } else if (functions[i].plane) {
        functions[i].plane(y->ball, y->ball, r->prec);
    } else {
        refuse_formula(r);
    }
    expect_sign(r, ")");
}

/* True if `name` is the operand's name, or for a law its name and exponent: .a, .b, ->a or ->b. */
static bool is_operand(const struct operand *x, const char *name, size_t length)
{
    if (!x->law)
        return is_named(x->name, name, length);
    const bool field = x->name[0] == '&';
    const size_t stem = strlen(x->name + field), end = stem + (field ? 1 : 2); /* the length of "." or "->" */
    return length == end + 1 && strncmp(x->name + field, name, stem) == 0 &&
           strncmp(field ? "." : "->", name + stem, end - stem) == 0 && (name[end] == 'a' || name[end] == 'b');
}

static void read_operand(struct value *y, const struct reader *r, const char *name, size_t length)
{
    const struct operand *x = r->operands;
    while (x->name && !is_operand(x, name, length))
        x++;
    if (!x->name)
        refuse_formula(r);
    if ((x->plane && !r->in_plane) || (x->function && !r->algebra))
        refuse_formula(r);
    y->is_function = x->function;
    y->is_exact = !x->ball && !x->plane && !x->function && isnan(x->real);
    if (x->function)
        arb_poly_set(y->function, x->function);
    else if (x->plane)
        acb_set(y->ball, x->plane);
    else if (x->ball)
        arb_set(real_of(y), x->ball);
    else if (!y->is_exact)
        arb_set_d(real_of(y), x->real);
    else if (x->exact)
        fmpq_set(y->exact, x->exact);
    else if (x->law)
        fmpq_set_si(y->exact, name[length - 1] == 'a' ? x->law->elastic : x->law->damping, (ulong)x->law->denominator);
    else
        fmpq_set_si(y->exact, x->ratio.den ? x->ratio.num : x->whole, x->ratio.den ? (ulong)x->ratio.den : 1);
}

/* Reads a number, an operand, a function or a sum in parentheses, and its power. */
static void read_factor(struct value *y, struct reader *r)
{
    if (next_of(r, "-")) {
        read_factor(y, r);
        acb_neg(y->ball, y->ball);
        arb_poly_neg(y->function, y->function);
        fmpq_neg(y->exact, y->exact);
        return;
    }
    const char *const name = r->at;
    const size_t length = name_length(name);
    r->at += length;
    if (isdigit((unsigned char)*name)) {
        char *end;
        fmpq_set_si(y->exact, strtol(name, &end, 10), 1);
        if (end != r->at)
            refuse_formula(r);
    } else if (next_of(r, "(")) {
        if (length > 0) {
            read_function(y, r, name, length);
        } else {
            read_sum(y, r);
            expect_sign(r, ")");
        }
    } else if (is_named("pi", name, length)) {
        arb_const_pi(real_of(y), r->prec);
        y->is_exact = false;
    } else {
        read_operand(y, r, name, length);
    }
    if (next_of(r, "^")) {
        LOCAL(value, x);
        read_factor(x, r);
        power_of(y, x, r);
    }
}

static void read_product(struct value *y, struct reader *r)
{
    read_factor(y, r);
    for (char name; (name = next_of(r, "*/"));) {
        LOCAL(value, x);
        read_factor(x, r);
        combine_values(y, name, x, r);
    }
}

static void read_sum(struct value *y, struct reader *r)
{
    read_product(y, r);
    for (char name; (name = next_of(r, "+-"));) {
        LOCAL(value, x);
        read_product(x, r);
        combine_values(y, name, x, r);
    }
}

/* Reads a sum. After it the text must end or continue with one of `ends`, which is returned. */
static char read_side(struct value *x, struct reader *r, const char *ends)
{
    read_sum(x, r);
    const char end = next_of(r, ends);
    if (*ends ? end == '\0' : *r->at != '\0')
        refuse_formula(r);
    return end;
}

void formula_ball(arb_t y, slong prec, const char *text, const struct operand *operands)
{
    struct reader r = {.at = text, .text = text, .operands = operands, .prec = prec};
    LOCAL(value, x);
    read_side(x, &r, "");
    become_ball(x, prec);
    arb_swap(y, real_of(x));
}

void formula_complex(acb_t y, bool analytic, slong prec, const char *text, const struct operand *operands)
{
    struct reader r = {
        .at = text, .text = text, .operands = operands, .prec = prec, .in_plane = true, .analytic = analytic};
    LOCAL(value, x);
    read_side(x, &r, "");
    become_ball(x, prec);
    acb_swap(y, x->ball);
}

bool formula_function(arb_poly_t y, const struct formula_algebra *algebra, const char *text,
                      const struct operand *operands)
{
    struct reader r = {.at = text, .text = text, .operands = operands, .prec = algebra->bits, .algebra = algebra};
    LOCAL(value, x);
    read_side(x, &r, "");
    become_function(x, r.prec);
    arb_poly_swap(y, x->function);
    if (r.undefined) {
        arb_indeterminate(real_of(x));
        arb_poly_set_arb(y, real_of(x));
    }
    return !r.undefined;
}

void formula_exact(fmpq_t q, const char *text, const struct operand *operands)
{
    struct reader r = {.at = text, .text = text, .operands = operands, .prec = 2};
    LOCAL(value, x);
    read_side(x, &r, "");
    if (!x->is_exact)
        refuse_formula(&r);
    fmpq_swap(q, x->exact);
}

struct ratio formula_ratio(const char *text, const struct operand *operands)
{
    LOCAL(fmpq, q);
    formula_exact(q, text, operands);
    return (struct ratio){fmpz_get_si(fmpq_numref(q)), fmpz_get_si(fmpq_denref(q))};
}

bool formula_holds(slong prec, const char *text, const struct operand *operands)
{
    struct reader r = {.at = text, .text = text, .operands = operands, .prec = prec};
    LOCAL(value, x, y);
    const char sign = read_side(x, &r, "<>");
    read_side(y, &r, "");
    become_ball(x, prec);
    become_ball(y, prec);
    return sign == '<' ? arb_lt(real_of(x), real_of(y)) : arb_gt(real_of(x), real_of(y));
}
