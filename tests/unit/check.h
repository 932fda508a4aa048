/* SPDX-License-Identifier: MIT */
/* Shared by the unit tests: errors in units of the last place, and a seeded random state. COR_SEED=<number> repeats a
 * run. COR_TEST_MULTIPLIER=<number> multiplies the number of random points. COR_TEST_DIVISOR divides it, for tests of
 * memory use. COR_TEST_LONG=1, which tests/run --long sets, runs all cases; a normal run selects a few. */
#ifndef COR_TESTS_CHECK_H
#define COR_TESTS_CHECK_H

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "random.h"
#include "ulp.h"

/* TEST(name) { ... } defines a test function. The program prints the seed and runs the tests of its file from top to
 * bottom. GROUP(before, after) calls `before` first and `after` last. A file without tests of its own defines
 * CHECK_WITHOUT_MAIN. */
#define TEST(test)                                                                                                     \
    static void test##_body(void);                                                                                     \
    static void test##_run(void **state)                                                                               \
    {                                                                                                                  \
        (void)state;                                                                                                   \
        draw_begin();                                                                                                  \
        test##_body();                                                                                                 \
    }                                                                                                                  \
    AT_START test##_add(void)                                                                                          \
    {                                                                                                                  \
        check_add((struct CMUnitTest){.name = #test, .test_func = test##_run}, __LINE__);                              \
    }                                                                                                                  \
    static void test##_body(void)
#define GROUP(before, after)                                                                                           \
    AT_START check_group(void)                                                                                         \
    {                                                                                                                  \
        check_before = before;                                                                                         \
        check_after = after;                                                                                           \
    }
#define AT_START __attribute__((constructor)) static void /* check_add sorts the tests by line */

#define check(condition, ...)                                                                                          \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            print_error("%s is false: ", #condition);                                                                  \
            fail_msg(__VA_ARGS__);                                                                                     \
        }                                                                                                              \
    } while (0)

/* Checks that each of these doubles is a NaN. */
#define check_nan(...)                                                                                                 \
    EACH (nan_, __VA_ARGS__)                                                                                           \
    check(isnan(*nan_), "%a among %s", *nan_, #__VA_ARGS__)

/* check_ulp: within `most` units of the last place. check_near: within the fraction `part` of the exact value. */
#define check_ulp(computed, exact, most)                                                                               \
    do {                                                                                                               \
        const double ulp_ = (computed);                                                                                \
        check(ulp_error(ulp_, exact) <= (most), "%s is %a, %.17g, not %.19Lg", #computed, ulp_, ulp_,                  \
              (long double)(exact));                                                                                   \
    } while (0)
#define check_near(computed, exact, part)                                                                              \
    do {                                                                                                               \
        const long double near_ = (computed), exact_ = (exact);                                                        \
        check(fabsl(near_ - exact_) <= (part)*fabsl(exact_), "%s is %.17Lg, not %.17Lg", #computed, near_, exact_);    \
    } while (0)

static inline long double relative_error(double computed, long double exact)
{
    return fabsl((computed - exact) / exact);
}

static inline uint64_t check_number(const char *variable, uint64_t otherwise)
{
    const char *text = getenv(variable);
    return text != NULL && *text != '\0' ? (uint64_t)strtoull(text, NULL, 0) : otherwise;
}

/* Returns the processor time that this process has used. */
static inline double processor_seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

static inline size_t points(size_t count)
{
    const size_t n =
        count * (size_t)check_number("COR_TEST_MULTIPLIER", 1) / (size_t)check_number("COR_TEST_DIVISOR", 1);
    return n > 0 ? n : 1;
}

static inline size_t few_or_all(size_t few, size_t all)
{
    return check_number("COR_TEST_LONG", 0) ? all : few;
}

/* True for every n-th case in a short run; tests/run --turn sets COR_TEST_TURN, which selects other cases. Always true
 * with COR_TEST_WHOLE=1, which tests/mutation/run sets: the guard of a mutant must not be skipped. */
static inline int in_turn(size_t i, size_t n)
{
    return check_number("COR_TEST_WHOLE", 0) || (i + (size_t)check_number("COR_TEST_TURN", 0)) % few_or_all(n, 1) == 0;
}

/* True if the case belongs to another turn, as in in_turn. False if COR_TEST_TURN is not set. */
static inline int left_to_turn(size_t i, size_t n)
{
    return getenv("COR_TEST_TURN") && !in_turn(i, n);
}

/* Skips a whole test function if left_to_turn() is true. */
#define leave_to_turn(i, n)                                                                                            \
    do {                                                                                                               \
        if (left_to_turn((i), (n)))                                                                                    \
            skip();                                                                                                    \
    } while (0)

static inline uint64_t check_seed(void)
{
    return check_number("COR_SEED", 19990101);
}

static inline struct random_state random_start(void)
{
    return random_seeded(check_seed());
}

/* State of the random numbers. Each test function restarts it, so tests are independent. */
static struct random_state draw;

static inline void draw_begin(void)
{
    draw = random_start();
}

#ifndef CHECK_WITHOUT_MAIN
enum { CHECK_MOST = 64 };
static struct CMUnitTest check_tests[CHECK_MOST]; /* elements without a function are skipped */
static int check_line[CHECK_MOST], check_count;
static int (*check_before)(void **state), (*check_after)(void **state);

static void check_add(struct CMUnitTest test, int line)
{
    if (check_count == CHECK_MOST)
        abort();
    int i = check_count++;
    for (; i > 0 && check_line[i - 1] > line; i--) {
        check_tests[i] = check_tests[i - 1];
        check_line[i] = check_line[i - 1];
    }
    check_tests[i] = test;
    check_line[i] = line;
}

int main(void)
{
    print_message("seed: COR_SEED=%llu\n", (unsigned long long)check_seed());
    return check_count > 0 ? cmocka_run_group_tests(check_tests, check_before, check_after) : 1;
}
#endif

#endif
