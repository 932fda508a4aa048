/* SPDX-License-Identifier: MIT */
/* The loops of arrays are their scalars to the last bit: every function of spheres, contacts and laws, every
 * instruction set, any length, any place; and the error of the sphere's functions in float arithmetic. (Public array
 * functions: test_environment.c.) */
#include "check.h"

#include <cor/cor.h>

#include "runtime/law/array.h"
#include "runtime/law/dashpot_array.h"
#include "runtime/sphere/array.h"
#include "runtime/sphere/fast_float.h"

/* SHORT: lengths up to it are all tried; BLOCKS: parts of the arguments that are of one kind each */
enum { MANY = 20000, SHORT = 40, BLOCKS = 40 };

static size_t many; /* MANY, or fewer where COR_TEST_DIVISOR says so */

static const char *const set_name[COR_INSTRUCTION_SETS] = {"portable", "AVX2", "AVX-512"};

/* The loop of one function. Numbers are doubles or floats; eps is read by the functions of two arguments alone. */
struct loop {
    const char *name;
    int floats, number; /* number: of the function, in the list of its kind */
    const struct cor_sphere_contact *contact;
    double (*value)(double);
    float (*valuef)(float);
    double seam[4]; /* where its rows change and end */
    int (*run)(const struct loop *, int set, const void *in, const void *of_eps, void *out, size_t n); /* 0: no set */
};

/* ---- the loops of each kind ---- */

static int run_sphere(const struct loop *l, int set, const void *in, const void *of_eps, void *out, size_t n)
{
    const struct cor_row_loops *const loops = cor_row_loops(set);
    const struct cor_sphere_rows *const rows = &cor_sphere_rows[l->number];
    const struct cor_row_call call = {&rows->table, rows->one, NULL, NULL, NULL, 0};
    (void)of_eps;
    if (loops && l->floats)
        loops->floats(&rows->table, rows->onef, rows->exception.x, in, out, n);
    else if (loops)
        loops->doubles(&call, in, out, n);
    return loops != NULL;
}

static int run_contact(const struct loop *l, int set, const void *in, const void *of_eps, void *out, size_t n)
{
    const struct cor_contact_loops *const loops = cor_contact_loops(set);
    if (loops)
        loops->run(&cor_contact_functions[l->number], l->contact, in, of_eps, out, n);
    return loops != NULL;
}

static int run_law(const struct loop *l, int set, const void *in, const void *of_eps, void *out, size_t n)
{
    const enum cor_law_loop loop = (enum cor_law_loop)l->number;
    (void)of_eps;
    return l->floats ? cor_law_arrayf_of_set(set, loop, in, out, n) : cor_law_array_of_set(set, loop, in, out, n);
}

static int run_dashpot(const struct loop *l, int set, const void *in, const void *of_eps, void *out, size_t n)
{
    (void)of_eps;
    return cor_dashpot_array_of_set(set, (enum cor_dashpot_number)l->number, in, out, n);
}

static struct float_table float_tables(int function)
{
    int k = 0;
#define TABLE(quantity)                                                                                                \
    if (k++ == function)                                                                                               \
        return float_table_##quantity();
    COR_FLOAT_QUANTITIES(TABLE)
    return float_table_eps_zero_overlap();
}

static const struct {
    double (*value)(double);
    float (*valuef)(float), (*fast)(float);
} fast_functions[] = {
#define FAST(quantity) {cor_sphere_##quantity, cor_sphere_##quantity##f, cor_sphere_##quantity##_fastf},
    COR_FLOAT_QUANTITIES(FAST)};

static int run_fast(const struct loop *l, int set, const void *in, const void *of_eps, void *out, size_t n)
{
    const struct cor_row_loops *const loops = cor_row_loops(set);
    const struct float_table table = float_tables(l->number);
    (void)of_eps;
    if (loops)
        loops->fast_floats(&table, fast_functions[l->number].valuef, in, out, n);
    return loops != NULL;
}

/* ---- all of them ---- */

/* As doubles and as floats, whose scalar is the double rounded where there is no other */
#define BOTH(name, number, value, valuef, run, ...)                                                                    \
    {name, 0, number, NULL, value, NULL, __VA_ARGS__, run},                                                            \
    {                                                                                                                  \
        name "f", 1, number, NULL, value, valuef, __VA_ARGS__, run                                                     \
    }
#define SPHERE(quantity)                                                                                               \
    BOTH(#quantity, COR_SPHERE_##quantity, cor_sphere_##quantity, cor_sphere_##quantity##f, run_sphere,                \
         {7, 8, 16, 0.25}),
#define FAST_FLOAT(quantity)                                                                                           \
    {#quantity "_fastf", 1, -1, NULL, NULL, cor_sphere_##quantity##_fastf, {7, 8, 16, 0.25}, run_fast},
#define LAW(name, public, least, largest, ...)                                                                         \
    BOTH(#name, COR_LAW_##name, cor_##public, NULL, run_law, {least, largest, least, 1}),
#define FORM(loop, function, ...) BOTH(#loop, COR_LAW_##loop, cor_##function, NULL, run_law, __VA_ARGS__)
#define FORMS(law, public, x, end, LAW, X, END)                                                                        \
    FORM(law##_eps##end, public##_eps##end,                                                                            \
         {COR_ROWS_##LAW##_EPS##END##_END, COR_ROWS_##LAW##_LOSS##END##_END, 1, 2}),                                   \
        FORM(law##_loss##end, public##_loss##end,                                                                      \
             {COR_ROWS_##LAW##_EPS##END##_END, COR_ROWS_##LAW##_LOSS##END##_END, COR_INLINE_2_M900, 1}),               \
        FORM(law##_##x##end, public##_##x##end, {COR_ROWS_##LAW##_##X##END##_FIRST, 0.5, 1, 0.25}),                    \
        FORM(law##_##x##_of_loss##end, public##_##x##_of_loss##end, {COR_INLINE_2_M900, 0.5, 1, 0.25}),
#define DASHPOT(function, ...)                                                                                         \
    {#function, 0, COR_DASHPOT_##function, NULL, cor_hertz_dashpot_##function, NULL, __VA_ARGS__, run_dashpot},
#define OF_BETA(function) DASHPOT(function, {0.125, COR_HERTZ_DASHPOT_BETA_C, 0.628, 8})
#define OF_EPS(function) DASHPOT(function, {0.5, 0x1p-60, 1, 0x1p-24})
#define CONTACT(quantity) {#quantity, 0, COR_CONTACT_##quantity, NULL, NULL, NULL, {7, 8, 16807, 1048576}, run_contact},

static const struct loop loops[] = {COR_SPHERE_QUANTITIES(SPHERE) COR_FLOAT_QUANTITIES(FAST_FLOAT) COR_LAW_LOOPS(LAW)
                                        COR_CLOSED_FORMS(FORMS) COR_DASHPOT_LOOPS(OF_BETA, OF_EPS)
                                            COR_CONTACT_QUANTITIES(CONTACT) COR_DISSIPATION_QUANTITIES(CONTACT)};

/* ---- arguments ---- */

/* Of every kind, so that a vector has what lies inside the tables beside what does not; then, block by block, numbers
 * that every function has rows for, those near 0, and those whose products may be subnormal floats. */
static void fill(const double seam[4], double *drawn)
{
    static const double special[] = {0.0,     -0.0,  NAN,  INFINITY, -INFINITY, -1,      4.9406564584124654e-324,
                                     7,       16,    8,    0.25,     DBL_MAX,   DBL_MIN, -4.9406564584124654e-324,
                                     0x1p-40, 0x1p8, 1024, 1,        0.5,       16807,   1048576,
                                     1e300,   1e-310};
    for (size_t i = 0; i < many; i++) {
        const double kind = random_uniform(&draw, 0, 1), *const at = &seam[random_below(&draw, 4)];
        const size_t block = i / (many / BLOCKS + 1) % 5;
        if (block >= 2)
            drawn[i] = block == 2   ? random_uniform(&draw, 0.01, 0.99)
                       : block == 3 ? random_uniform(&draw, 0, 0.1)
                                    : random_log(&draw, i % 4 ? 1e-9 : 1e-45, 7.9);
        else if (kind < 0.5)
            drawn[i] = random_uniform(&draw, 0, block == 0 ? 6 : 1.3);
        else if (kind < 0.7)
            drawn[i] = random_log(&draw, 1e-6, 20);
        else if (kind < 0.8)
            drawn[i] = random_log(&draw, 1e-320, 1e300);
        else if (kind < 0.85)
            drawn[i] = *at * (1 - random_log(&draw, 1e-16, 0.5));
        else if (kind < 0.93)
            drawn[i] =
                nextafter(nextafter(*at, random_uniform(&draw, -1, 2) * *at), random_uniform(&draw, -1, 2) * *at);
        else
            drawn[i] = special[random_below(&draw, COUNT_OF(special))];
    }
}

static int same_float(float a, float b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

static int same(const struct loop *l, const void *a, const void *b)
{
    return l->floats ? same_float(*(const float *)a, *(const float *)b)
                     : same_number(*(const double *)a, *(const double *)b);
}

union column {
    double of_doubles[MANY + 8];
    float of_floats[MANY + 8];
};

/* Arguments, results, and those of the scalar function */
static union column x, eps, y, exact;

static void *at(const struct loop *l, union column *column, size_t i)
{
    return l->floats ? (void *)&column->of_floats[i] : (void *)&column->of_doubles[i];
}

/* Results of n arguments from number `first` on */
static void compare(const struct loop *l, int set, const char *how, size_t first, size_t n)
{
    for (size_t i = first; i < first + n; i++)
        check(same(l, at(l, &exact, i), at(l, &y, i)), "%s, %s, %s: %zu of %zu from %zu", set_name[set], l->name, how,
              i - first, n, first);
}

static void check_loop(const struct loop *l, const double *drawn, int set)
{
    const size_t size = l->floats ? sizeof(float) : sizeof(double);
    const struct cor_contact_function *const f = &cor_contact_functions[l->contact ? l->number : 0];
    for (size_t i = 0; i < many; i++) {
        const float narrow = (float)drawn[i];
        const double mirrored = fabs(drawn[many - 1 - i]);
        if (l->floats) {
            x.of_floats[i] = narrow;
            exact.of_floats[i] = l->valuef ? l->valuef(narrow) : (float)l->value((double)narrow);
            continue;
        }
        x.of_doubles[i] = drawn[i];
        eps.of_doubles[i] = mirrored < 2 ? mirrored : 1 / (1 + fabs(drawn[i]));
        exact.of_doubles[i] = !l->contact ? l->value(drawn[i])
                              : f->one    ? f->one(l->contact, drawn[i])
                                          : f->of_eps(l->contact, drawn[i], eps.of_doubles[i]);
    }
    for (size_t n = 0; n <= many; n += n < SHORT ? 1 : n < 500 ? 61 : 6489)
        for (size_t first = 0; first < 3; first++) {
            const size_t m = first + n <= many ? n : many - first;
            unsigned char *const end = at(l, &y, first + m);
            memset(end, 0x5a, size);
            l->run(l, set, at(l, &x, first), at(l, &eps, first), at(l, &y, first), m);
            compare(l, set, "elsewhere", first, m);
            check(end[0] == 0x5a && end[size - 1] == 0x5a, "%s, %s wrote past %zu", set_name[set], l->name, m);
        }
    for (size_t n = many; n > 0; n = n > SHORT ? SHORT : n / 2) {
        y = x;
        l->run(l, set, &y, &eps, &y, n);
        compare(l, set, "in place", 0, n);
        check(n == many || same(l, at(l, &x, n), at(l, &y, n)), "%s, in place, wrote past %zu", l->name, n);
    }
    if (l->contact) {
        y = eps;
        l->run(l, set, &x, &y, &y, many);
        compare(l, set, "in place of eps", 0, many);
    }
}

enum { CONTACTS = 6 };

static void fill_contacts(struct cor_sphere_contact contact[CONTACTS])
{
    const struct cor_body ice = {7e9, 0.25, 1.2e-4, 0.05, 0.5}, wall = {7e9, 0.25, 1.2e-4, INFINITY, INFINITY};
    assert_int_equal(cor_sphere_contact_init(&contact[0], &ice, &wall), COR_OK);
    contact[1] = contact[0]; /* beta near speed^(1/5) */
    assert_int_equal(cor_sphere_contact_init_g_star(&contact[1], 0.49), COR_OK);
    contact[1].scale = 0.3;
    assert_int_equal(cor_sphere_contact_init_g_star(&contact[2], INFINITY), COR_OK); /* no dissipation, no scale */
    assert_int_equal(cor_sphere_contact_init_g_star(&contact[3], 1e-304), COR_OK);
    contact[3].beta5_per_speed = NAN;
    contact[3].scale = 1e-200;
    contact[4] = contact[1];
    contact[4].beta_per_root = 1e200;
    contact[4].beta5_per_speed = NAN;
    contact[4].scale = 1e160;
    assert_int_equal(cor_sphere_contact_init(&contact[5], NULL, NULL), COR_ERROR_NULL); /* all NaN */
}

TEST(every_set)
{
    static double drawn[MANY];
    struct cor_sphere_contact contact[CONTACTS];
    fill_contacts(contact);
    many = points(MANY) < MANY ? points(MANY) : MANY;
    assert_true(cor_processor_has(COR_PORTABLE) && !cor_row_loops(COR_INSTRUCTION_SETS) && !cor_row_loops(-1));
    for (int set = 0; set < COR_INSTRUCTION_SETS; set++) {
        if (!cor_processor_has(set)) {
            assert_false(cor_law_array_of_set(set, COR_LAW_crossley_eps, NULL, NULL, 0));
            print_message("no %s\n", set_name[set]);
            continue;
        }
        for (size_t k = 0; k < COUNT_OF(loops); k++) {
            struct loop l = loops[k];
            const int of_contact = l.run == run_contact;
            fill(l.seam, drawn);
            if (l.run == run_sphere && l.floats) { /* the floats that one rounding does not serve */
                const struct cor_float_exception *const e = &cor_sphere_rows[l.number].exception;
                for (size_t i = 0; i < many; i += 531)
                    drawn[i] = !isnan(e->x) ? (double)e->x : drawn[i];
                for (size_t i = 1; i < many; i += 531)
                    drawn[i] = !isnan(e->second_x) ? (double)e->second_x : drawn[i];
            }
            if (l.run == run_fast)
                l.number = (int)(k - 2 * COR_SPHERE_COUNT);
            for (int c = 0; c < (of_contact ? CONTACTS : 1); c++) {
                l.contact = of_contact ? &contact[c] : NULL;
                check_loop(&l, drawn, set);
            }
        }
    }
}

/* ---- float arithmetic ---- */

/* In units of the last place of a float; 0 if both are infinite as floats */
static double float_error(float computed, double exact)
{
    int exponent;
    if (isinf((float)exact))
        return isinf(computed) ? 0 : INFINITY;
    frexp(exact, &exponent);
    return fabs((double)computed - exact) / ldexp(1, (exponent < FLT_MIN_EXP ? FLT_MIN_EXP : exponent) - FLT_MANT_DIG);
}

TEST(float_arithmetic)
{
    static const float special[] = {0, -0.0F, INFINITY, NAN, -NAN, -INFINITY, -1, -FLT_MIN, -1e-45F};
    for (size_t k = 0; k < COUNT_OF(fast_functions); k++) {
        for (size_t i = 0; i < COUNT_OF(special); i++) {
            const float computed = fast_functions[k].fast(special[i]);
            check(same_float(computed, fast_functions[k].valuef(special[i])), "%s(%a) = %a",
                  loops[2 * COR_SPHERE_COUNT + k].name, (double)special[i], (double)computed);
        }
        for (size_t i = 0; i < 2 * many; i++) { /* within the tables, of products that are subnormal, and beyond */
            const float at = (float)random_log(&draw, i % 4 ? 1e-9 : 1e-45, i % 5 ? 7.99 : 3e38),
                        computed = fast_functions[k].fast(at);
            check(float_error(computed, fast_functions[k].value((double)at)) <= COR_SPHERE_FAST_FLOAT_MAX_ULP,
                  "%s(%a) = %a", loops[2 * COR_SPHERE_COUNT + k].name, (double)at, (double)computed);
        }
    }
}

RUN_TESTS(every_set, float_arithmetic)
