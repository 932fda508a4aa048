/* SPDX-License-Identifier: MIT */
/* Arrays are their scalars to the last bit: every function, any length, any place, every instruction set. (Public
 * array functions: test_environment.c.) */
#include "check.h"

#include <cor/cor.h>

#include "runtime/sphere/array.h"
#include "runtime/sphere/fast_float.h"

typedef void contact_loop(const struct cor_contact_function *f, const struct cor_sphere_contact *contact,
                          const double *speed, const double *eps, double *out, size_t n);

static int same(double x, double y)
{
    return same_bits(x, y) || (isnan(x) && isnan(y));
}

static int same_float(float x, float y)
{
    return memcmp(&x, &y, sizeof x) == 0 || (isnan(x) && isnan(y));
}

/* Arguments of every kind, so that a block has what lies inside the tables beside what does not. */
static void fill(double *x, int count)
{
    struct random_state random = random_start();
    const double special[] = {0.0,     -0.0,  NAN,  INFINITY, -INFINITY, -1,      4.9406564584124654e-324,
                              7,       16,    8,    0.25,     DBL_MAX,   DBL_MIN, -4.9406564584124654e-324,
                              0x1p-40, 0x1p8, 1024, 1,        0.5,       16807,   1048576};
    enum { SPECIAL = sizeof special / sizeof *special };
    for (int i = 0; i < count; i++)
        switch (i % 5) {
        case 0:
            x[i] = random_log(&random, 1e-300, 1e300);
            break;
        case 1:
            x[i] = i / 5 % 4 ? random_uniform(&random, 0, 1) : special[i / 20 % SPECIAL];
            break;
        default:
            x[i] = i / 100 % 2 ? random_uniform(&random, 0, 6) : random_log(&random, 1e-4, 20);
        }
}

/* ---- every set, whichever would have been chosen here ---- */

enum { MANY = 20000, CONTACTS = 6 };

struct arguments {
    double x[MANY], eps[MANY], inside[MANY]; /* inside: 0.01 to 0.99, where every function has a table */
    struct cor_sphere_contact contact[CONTACTS];
};

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

static void check_sphere(const struct cor_row_loops *loops, const char *name, const struct cor_sphere_rows *rows,
                         const struct arguments *a)
{
    static double y[MANY + 1];
    static float xf[MANY], yf[MANY];
    const char *const set = loops->name;
    double (*const value)(double) = rows->one;
    const struct cor_row_call call = {&rows->table, value, NULL, NULL, NULL, 0};
    for (size_t n = MANY; n > MANY - 140; n -= 67) {
        y[n] = 7;
        loops->doubles(&call, a->x, y, n);
        for (size_t i = 0; i < n; i++)
            check(same(y[i], value(a->x[i])), "%s, %s(%a)", set, name, a->x[i]);
        check(y[n] == 7, "%s, %s wrote past the end", set, name);
    }
    loops->doubles(&call, a->inside, y, MANY); /* blocks without a number to compute alone */
    for (size_t i = 0; i < MANY; i++)
        check(same(y[i], value(a->inside[i])), "%s, %s(%a)", set, name, a->inside[i]);
    for (size_t n = 1; n < 20; n++) { /* short ones, in place */
        memcpy(y, a->x, sizeof a->x);
        loops->doubles(&call, y + n, y + n, n);
        for (size_t i = 0; i < n; i++)
            check(same(y[n + i], value(a->x[n + i])), "%s, %s, %zu", set, name, n);
        check(same(y[2 * n], a->x[2 * n]), "%s, %s wrote past %zu", set, name, n);
    }
    /* floats: the double rounded, but for one number */
    const float apart[2] = {rows->exception.x, rows->exception.second_x};
    for (size_t i = 0; i < MANY; i++)
        xf[i] =
            i % 531 < 2 && !isnan(apart[i % 531]) ? apart[i % 531] : (float)(i % 1062 < 600 ? a->x[i] : a->inside[i]);
    loops->floats(&rows->table, rows->onef, apart[0], xf, yf, MANY);
    for (size_t i = 0; i < MANY; i++)
        check(same_float(yf[i], rows->onef(xf[i])), "%s, %sf(%a)", set, name, (double)xf[i]);
    loops->floats(&rows->table, rows->onef, apart[0], xf, xf, MANY);
    assert_memory_equal(xf, yf, sizeof yf);
}

static void check_contact(const char *set, contact_loop *array, const char *name, const struct cor_contact_function *f,
                          const struct arguments *a)
{
    double (*const value)(const struct cor_sphere_contact *, double) = f->one;
    static double y[MANY + 1];
    for (int k = 0; k < CONTACTS; k++) {
        const size_t n = MANY - 67 * (size_t)k;
        y[n] = 7;
        array(f, &a->contact[k], a->x, NULL, y, n);
        for (size_t i = 0; i < n; i++)
            check(same(y[i], value(&a->contact[k], a->x[i])), "%s, %s, contact %d, speed %a: %a", set, name, k, a->x[i],
                  y[i]);
        check(y[n] == 7, "%s, %s wrote past the end", set, name);
    }
    for (size_t n = 1; n < 20; n++) {
        memcpy(y, a->x, sizeof a->x);
        array(f, &a->contact[1], y + n, NULL, y + n, n);
        for (size_t i = 0; i < n; i++)
            check(same(y[n + i], value(&a->contact[1], a->x[n + i])), "%s, %s, %zu", set, name, n);
        check(same(y[2 * n], a->x[2 * n]), "%s, %s wrote past %zu", set, name, n);
    }
}

static void check_dissipation(const char *set, contact_loop *array, const char *name,
                              const struct cor_contact_function *f, const struct arguments *a)
{
    double (*const value)(const struct cor_sphere_contact *, double, double) = f->of_eps;
    static double y[MANY + 1];
    for (int k = 0; k < CONTACTS; k++) {
        const size_t n = MANY - 67 * (size_t)k;
        y[n] = 7;
        array(f, &a->contact[k], a->x, a->eps, y, n);
        for (size_t i = 0; i < n; i++)
            check(same(y[i], value(&a->contact[k], a->x[i], a->eps[i])), "%s, %s, contact %d, speed %a, eps %a", set,
                  name, k, a->x[i], a->eps[i]);
        check(y[n] == 7, "%s, %s wrote past the end", set, name);
    }
    /* in place of the speeds, and of eps */
    memcpy(y, a->x, sizeof a->x);
    array(f, &a->contact[0], y, a->eps, y, 300);
    for (size_t i = 0; i < 300; i++)
        check(same(y[i], value(&a->contact[0], a->x[i], a->eps[i])), "%s, %s in place of speeds", set, name);
    memcpy(y, a->eps, sizeof a->eps);
    array(f, &a->contact[0], a->x, y, y, 300);
    for (size_t i = 0; i < 300; i++)
        check(same(y[i], value(&a->contact[0], a->x[i], a->eps[i])), "%s, %s in place of eps", set, name);
}

TEST(every_set)
{
    static struct arguments a;
    int sets = 0;
    fill(a.x, MANY);
    for (int i = 0; i < MANY; i++)
        a.eps[i] = fabs(a.x[MANY - 1 - i]) < 2 ? fabs(a.x[MANY - 1 - i]) : 1 / (1 + fabs(a.x[i]));
    struct random_state random = random_start();
    for (int i = 0; i < MANY; i++)
        a.inside[i] = random_uniform(&random, 0.01, 0.99);
    fill_contacts(a.contact);
    for (int s = 0; s < COR_INSTRUCTION_SETS; s++) {
        const struct cor_row_loops *const loops = cor_row_loops(s);
        const struct cor_contact_loops *const contacts = cor_contact_loops(s);
        if (loops == NULL) {
            print_message("set %d is not in this build or processor\n", s);
            continue;
        }
        sets++;
        print_message("set %s\n", loops->name);
#define CHECK(quantity) check_sphere(loops, #quantity, &cor_sphere_rows[COR_SPHERE_##quantity], &a);
        COR_SPHERE_QUANTITIES(CHECK)
#undef CHECK
#define CHECK(kind, quantity)                                                                                          \
    check_##kind(loops->name, contacts->run, #quantity, &cor_contact_functions[COR_CONTACT_##quantity], &a);
#define CHECK_CONTACT(quantity) CHECK(contact, quantity)
#define CHECK_DISSIPATION(quantity) CHECK(dissipation, quantity)
        COR_CONTACT_QUANTITIES(CHECK_CONTACT)
        COR_DISSIPATION_QUANTITIES(CHECK_DISSIPATION)
#undef CHECK
    }
    assert_true(sets >= 1);
    assert_null(cor_row_loops(COR_INSTRUCTION_SETS));
    assert_null(cor_row_loops(-1));
}

/* ---- arrays in float arithmetic ---- */

struct fast_function {
    const char *name;
    double (*value)(double);
    float (*valuef)(float), (*fast)(float);
    void (*array)(const float *, float *, size_t);
    float at_zero, at_infinity;
};
#define FAST_ROW(quantity, at_zero, at_infinity)                                                                       \
    {                                                                                                                  \
#quantity, cor_sphere_##quantity, cor_sphere_##quantity##f, cor_sphere_##quantity##_fastf,                     \
            cor_sphere_##quantity##_fast_arrayf, at_zero, at_infinity                                                  \
    }

/* In the order of COR_FLOAT_QUANTITIES */
static const struct fast_function fast_functions[] = {
    FAST_ROW(eps_zero_overlap, 1, 0),
    FAST_ROW(eps_zero_force, 1, 0),
    FAST_ROW(loss_zero_overlap, 0, 1),
    FAST_ROW(loss_zero_force, 0, 1),
    FAST_ROW(duration_zero_overlap, 3.2180655F, INFINITY),
    FAST_ROW(duration_zero_force, 3.2180655F, 0),
    FAST_ROW(max_overlap, 1.0933621F, 0),
    FAST_ROW(time_of_max_overlap, 1.6090327F, 0),
};
enum { FAST_FUNCTIONS = sizeof fast_functions / sizeof *fast_functions };

/* In units of the last place of a float; 0 if both are infinite as floats */
static double float_error(float computed, double exact)
{
    int exponent;
    if (isinf((float)exact))
        return isinf(computed) ? 0 : INFINITY;
    frexp(exact, &exponent);
    return fabs((double)computed - exact) / ldexp(1, (exponent < FLT_MIN_EXP ? FLT_MIN_EXP : exponent) - FLT_MANT_DIG);
}

TEST(fast_special_values)
{
    for (int k = 0; k < FAST_FUNCTIONS; k++) {
        const struct fast_function *f = &fast_functions[k];
        const float x[] = {0, -0.0F, INFINITY, NAN, -NAN, -INFINITY, -1, -FLT_MIN, -1e-45F};
        enum { SPECIALS = sizeof x / sizeof *x, NUMBERS = 3 };
        const float expected[NUMBERS] = {f->at_zero, f->at_zero, f->at_infinity};
        float y[SPECIALS];
        f->array(NULL, NULL, 0);
        f->array(x, y, SPECIALS);
        for (int i = 0; i < SPECIALS; i++)
            check(i < NUMBERS ? y[i] == expected[i] && !signbit(y[i]) : isnan(y[i]), "%s(%a) = %a", f->name,
                  (double)x[i], (double)y[i]);
    }
}

static struct float_table float_tables(int function)
{
    int k = 0;
#define TABLE(quantity)                                                                                                \
    if (k++ == function)                                                                                               \
        return float_table_##quantity();
    COR_FLOAT_QUANTITIES(TABLE)
#undef TABLE
    return float_table_eps_zero_overlap();
}

static void fast(const struct cor_row_loops *loops, const struct float_table *table, const struct fast_function *f,
                 const float *x, float *y, size_t n)
{
    if (loops)
        loops->fast_floats(table, f->valuef, x, y, n);
    else
        f->array(x, y, n);
}

/* Each set, length and place gives the bits of the scalar function. */
static void check_fast(const struct cor_row_loops *loops, const struct float_table *table,
                       const struct fast_function *f, const float *x, const float *expected)
{
    static float y[MANY + 8];
    const char *const set = loops ? loops->name : "public";
    for (size_t n = 0; n <= MANY; n += n < 40 ? 1 : n < 530 ? 61 : 6489)
        for (size_t at = 0; at < 3; at++) {
            y[at + n] = 7;
            fast(loops, table, f, x + at, y + at, n < MANY - at ? n : MANY - at);
            for (size_t i = 0; i < n && i < MANY - at; i++)
                check(same_float(y[at + i], expected[at + i]), "%s, %s(%a), %zu of %zu", set, f->name,
                      (double)x[at + i], i, n);
            check(y[at + n] == 7, "%s, %s wrote past %zu", set, f->name, n);
        }
    memcpy(y, x, MANY * sizeof *y);
    fast(loops, table, f, y, y, MANY);
    for (size_t i = 0; i < MANY; i++)
        check(same_float(y[i], expected[i]), "%s, %s(%a) in place", set, f->name, (double)x[i]);
}

TEST(fast_every_set)
{
    static double wide[MANY];
    static float x[2][MANY], expected[MANY]; /* of every kind; within the tables, and of products that are subnormal */
    struct random_state random = random_start();
    fill(wide, MANY);
    for (int i = 0; i < MANY; i++) {
        x[0][i] = (float)wide[i];
        x[1][i] = (float)random_log(&random, i % 4 ? 1e-9 : 1e-45, 7.99);
    }
    for (int k = 0; k < FAST_FUNCTIONS; k++)
        for (int kind = 0; kind < 2; kind++) {
            for (int i = 0; i < MANY; i++) {
                expected[i] = fast_functions[k].fast(x[kind][i]);
                if (x[kind][i] >= 0)
                    check(float_error(expected[i], fast_functions[k].value((double)x[kind][i])) <=
                              COR_SPHERE_FAST_FLOAT_MAX_ULP,
                          "%s(%a) = %a", fast_functions[k].name, (double)x[kind][i], (double)expected[i]);
            }
            const struct float_table table = float_tables(k);
            check_fast(NULL, &table, &fast_functions[k], x[kind], expected);
            for (int s = 0; s < COR_INSTRUCTION_SETS; s++) {
                if (cor_row_loops(s))
                    check_fast(cor_row_loops(s), &table, &fast_functions[k], x[kind], expected);
            }
        }
}

RUN_TESTS(every_set, fast_special_values, fast_every_set)
