/* SPDX-License-Identifier: MIT */
/* Tests that array functions equal their scalar functions to the last bit: for all laws and contacts, every instruction
 * set, any length and alignment. Tests the error of float arrays. test_environment.c tests public functions. */
#define _POSIX_C_SOURCE 200809L
#include "check.h"

#include <cor/cor.h>
#include <sys/mman.h>
#include <unistd.h>

#include "runtime/table/row_loops.h"

/* SHORT: all lengths up to SHORT are tested. BLOCKS: parts of the arguments, each of one kind */
enum { MANY = 20000, SHORT = 40, BLOCKS = 40 };

static size_t many; /* MANY, or fewer with COR_TEST_DIVISOR */

static const char *const set_name[COR_INSTRUCTION_SETS] = {"portable", "AVX2", "AVX-512"};

/* Replaces the library's function, so that array functions use the instruction set that a test selects. */
static int set;
int cor_array_set(void)
{
    return set;
}

/* An array function and its scalar function, of a law, of a contact, or of a contact and eps */
typedef void contact_array(const struct cor_sphere_contact *contact, const double *speed, double *y, size_t n);
typedef void eps_array(const struct cor_sphere_contact *contact, const double *speed, const double *eps, double *y,
                       size_t n);
struct loop {
    const char *name;
    const struct cor_law_function *law;
    int floats; /* 1: calls law->arrayf, not law->array */
    contact_array *of_speed;
    double (*one)(const struct cor_sphere_contact *contact, double speed);
    eps_array *of_eps;
    double (*one_of_eps)(const struct cor_sphere_contact *contact, double speed, double eps);
    const struct cor_sphere_contact *contact;
};

#define OF_SPEED(quantity)                                                                                             \
    {                                                                                                                  \
        .name = #quantity, .of_speed = cor_contact_##quantity##_array, .one = cor_contact_##quantity                   \
    }
#define OF_EPS(quantity)                                                                                               \
    {                                                                                                                  \
        .name = #quantity, .of_eps = cor_contact_##quantity##_array, .one_of_eps = cor_contact_##quantity              \
    }
static const struct loop contact_loops[] = {OF_SPEED(eps_zero_overlap),
                                            OF_SPEED(eps_zero_force),
                                            OF_SPEED(beta),
                                            OF_SPEED(duration_s_zero_overlap),
                                            OF_SPEED(duration_s_zero_force),
                                            OF_SPEED(max_overlap_m),
                                            OF_EPS(dissipation_time_s_zero_overlap),
                                            OF_EPS(dissipation_time_s_zero_force)};

static int same_float(float a, float b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

static int same(const struct loop *l, const void *a, const void *b)
{
    return l->floats ? same_float(*(const float *)a, *(const float *)b)
                     : same_number(*(const double *)a, *(const double *)b);
}

/* ---- arguments ---- */

/* Draws arguments of every kind, so that a vector has numbers inside and outside the tables. Each of the later blocks
 * has one kind: numbers for which every function has rows; numbers near 0; numbers whose products may be subnormal
 * floats. seam: places where rows end or change. */
static void fill(double *drawn)
{
    static const double special[] = {0.0,     -0.0,  NAN,  INFINITY, -INFINITY, -1,      4.9406564584124654e-324,
                                     7,       16,    8,    0.25,     DBL_MAX,   DBL_MIN, -4.9406564584124654e-324,
                                     0x1p-40, 0x1p8, 1024, 1,        0.5,       16807,   1048576,
                                     1e300,   1e-310};
    static NUMBERS(seam, 0x1p-900, 0x1p-60, 0x1p-24, 0x1p-12, 0x1p-6, 0.0625, 0.125, 0.25, 0.5, 0.627988, 0.75, 1,
                   COR_HERTZ_DASHPOT_BETA_C, 2, 3, 4, 7, 8, 16, 45, 64, 16807, 1048576);
    for (size_t i = 0; i < many; i++) {
        const double kind = random_uniform(&draw, 0, 1), *const at = &seam[random_below(&draw, COUNT_OF(seam))];
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

union column {
    double of_doubles[MANY + 8];
    float of_floats[MANY + 8];
};

/* Arguments, results, and results of the scalar function */
static union column x, eps, y, exact;

static void *at(const struct loop *l, union column *column, size_t i)
{
    return l->floats ? (void *)&column->of_floats[i] : (void *)&column->of_doubles[i];
}

static void run(const struct loop *l, const void *in, const void *of_eps, void *out, size_t n)
{
    if (l->floats)
        l->law->arrayf(in, out, n);
    else if (l->law)
        l->law->array(in, out, n);
    else if (l->of_speed)
        l->of_speed(l->contact, in, out, n);
    else
        l->of_eps(l->contact, in, of_eps, out, n);
}

static void compare(const struct loop *l, const char *how, size_t first, size_t n)
{
    for (size_t i = first; i < first + n; i++)
        check(same(l, at(l, &exact, i), at(l, &y, i)), "%s, %s, %s: %zu of %zu from %zu", set_name[set], l->name, how,
              i - first, n, first);
}

/* Runs a loop over arguments at the end of a page whose next page cannot be read. */
static void check_page(const struct loop *l)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE), n = page / (l->floats ? sizeof(float) : sizeof(double));
    void *memory = NULL;
    assert_int_equal(posix_memalign(&memory, page, 2 * page), 0);
    assert_int_equal(mprotect((char *)memory + page, page, PROT_NONE), 0);
    if (n <= many)
        run(l, memcpy(memory, &x, page), &eps, &y, n);
    assert_int_equal(mprotect((char *)memory + page, page, PROT_READ | PROT_WRITE), 0);
    free(memory);
}

static void check_loop(const struct loop *l, const double *drawn)
{
    const size_t size = l->floats ? sizeof(float) : sizeof(double);
    const int widest = set;
    for (size_t i = 0; i < many; i++) {
        const double mirrored = fabs(drawn[many - 1 - i]);
        if (l->floats) { /* a call for each number, without vectors */
            x.of_floats[i] = (float)drawn[i];
            set = COR_PORTABLE;
            l->law->arrayf(&x.of_floats[i], &exact.of_floats[i], 1);
            set = widest;
            continue;
        }
        x.of_doubles[i] = drawn[i];
        eps.of_doubles[i] = mirrored < 2 ? mirrored : 1 / (1 + fabs(drawn[i]));
        exact.of_doubles[i] = l->law   ? l->law->value(drawn[i])
                              : l->one ? l->one(l->contact, drawn[i])
                                       : l->one_of_eps(l->contact, drawn[i], eps.of_doubles[i]);
    }
    for (size_t n = 0; n <= many; n += n < SHORT ? 1 : n < 500 ? 61 : 6489)
        for (size_t first = 0; first < 3; first++) {
            const size_t m = first + n <= many ? n : many - first;
            unsigned char *const end = at(l, &y, first + m);
            memset(end, 0x5a, size);
            run(l, at(l, &x, first), at(l, &eps, first), at(l, &y, first), m);
            compare(l, "elsewhere", first, m);
            check(end[0] == 0x5a && end[size - 1] == 0x5a, "%s, %s wrote past %zu", set_name[set], l->name, m);
        }
    for (size_t n = many; n > 0; n = n > SHORT ? SHORT : n / 2) {
        y = x;
        run(l, &y, &eps, &y, n);
        compare(l, "in place", 0, n);
        check(n == many || same(l, at(l, &x, n), at(l, &y, n)), "%s, in place, wrote past %zu", l->name, n);
    }
    check_page(l);
    if (l->contact) {
        y = eps;
        run(l, &x, &y, &y, many);
        compare(l, "in place of eps", 0, many);
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
    assert_int_equal(cor_sphere_contact_init_g_star(&contact[2], INFINITY), COR_OK); /* no dissipation, so no scale */
    assert_int_equal(cor_sphere_contact_init_g_star(&contact[3], 1e-249), COR_OK);
    contact[3].beta5_per_speed = NAN;
    contact[3].scale = 1e-150;
    contact[4] = contact[1];
    contact[4].beta_per_root = 1e150;
    contact[4].beta5_per_speed = NAN;
    contact[4].scale = 1e150;
    assert_int_equal(cor_sphere_contact_init(&contact[5], NULL, NULL), COR_ERROR_NULL); /* all NaN */
}

/* Lists each function of laws only once, because linear and Tsuji, and some ends, share functions. */
static size_t law_loops(struct loop *loops)
{
    size_t count = 0;
    for (int c = 0; c < 5 * 4 * COR_QUANTITIES; c++) {
        const struct cor_law_function *const f =
            cor_law_function((enum cor_law)(c / COR_QUANTITIES / 4), (enum cor_end)(c / COR_QUANTITIES % 4),
                             (enum cor_quantity)(c % COR_QUANTITIES));
        size_t k = 0;
        while (f && k < count && loops[k].law->value != f->value)
            k++;
        if (f && k == count)
            loops[count++] = (struct loop){.name = f->name, .law = f};
        if (f && k + 1 == count && f->arrayf)
            loops[count++] = (struct loop){.name = f->name, .law = f, .floats = 1};
    }
    return count;
}

TEST(every_set)
{
    static double drawn[MANY];
    struct cor_sphere_contact contact[CONTACTS];
    struct loop loops[200];
    const size_t laws = law_loops(loops);
    fill_contacts(contact);
    many = points(MANY) < MANY ? points(MANY) : MANY;
    assert_true(cor_processor_has(COR_PORTABLE) && !cor_row_loops(COR_INSTRUCTION_SETS) && !cor_row_loops(-1));
    for (set = 0; set < COR_INSTRUCTION_SETS; set++) {
        if (!cor_processor_has(set)) {
            print_message("no %s\n", set_name[set]);
            continue;
        }
        for (size_t k = 0; k < laws; k++) {
            fill(drawn);
            check_loop(&loops[k], drawn);
        }
        for (size_t k = 0; k < COUNT_OF(contact_loops); k++)
            for (int c = 0; c < CONTACTS; c++) {
                struct loop l = contact_loops[k];
                l.contact = &contact[c];
                fill(drawn);
                check_loop(&l, drawn);
            }
    }
    set = cor_widest_set();
}

/* ---- float arithmetic ---- */

/* Returns the error in units of the last place of a float; 0 if both are infinite as floats. */
static double float_error(float computed, double exact)
{
    int exponent;
    if (isinf((float)exact))
        return isinf(computed) ? 0 : INFINITY;
    frexp(exact, &exponent);
    return fabs((double)computed - exact) / ldexp(1, (exponent < FLT_MIN_EXP ? FLT_MIN_EXP : exponent) - FLT_MANT_DIG);
}

/* Arguments within the tables, with subnormal products, beyond the tables, and special values */
TEST(float_arithmetic)
{
    static const float special[] = {0, -0.0F, INFINITY, NAN, -NAN, -INFINITY, -1, -FLT_MIN, -1e-45F};
    set = cor_widest_set();
    for (int k = 0; k < 4; k++) {
        const struct cor_law_function *const f =
            cor_law_function(COR_LAW_VISCOELASTIC, (enum cor_end)(k / 2), (enum cor_quantity)(k % 2));
        for (size_t i = 0; i < 2 * many + COUNT_OF(special); i++) {
            const float at = i < COUNT_OF(special)
                                 ? special[i]
                                 : (float)random_log(&draw, i % 4 ? 1e-9 : 1e-45, i % 5 ? 7.99 : 3e38);
            const double value = f->value((double)at);
            float computed;
            f->arrayf(&at, &computed, 1);
            check(isnan(value) ? isnan(computed) : float_error(computed, value) <= COR_SPHERE_FLOAT_MAX_ULP,
                  "%s(%a) = %a", f->name, (double)at, (double)computed);
        }
    }
}
