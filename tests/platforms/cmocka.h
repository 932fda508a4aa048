/* SPDX-License-Identifier: MIT */
/* Implements the parts of cmocka that tests/unit/ uses, for platforms without a package of cmocka. All tests run; a
 * failed assertion or skip() ends only its own test. The program's status is the number of failed tests. */
#ifndef COR_TESTS_PLATFORMS_CMOCKA_H
#define COR_TESTS_PLATFORMS_CMOCKA_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct CMUnitTest {
    const char *name;
    void (*test_func)(void **state);
};

enum { CMOCKA_FAILED = 1, CMOCKA_SKIPPED };
static jmp_buf cmocka_ended;

#define skip() longjmp(cmocka_ended, CMOCKA_SKIPPED)
#define print_message printf
#define test_malloc malloc
#define test_free free
#define print_error printf
#define fail_msg(...) (printf(__VA_ARGS__), cmocka_fail(__FILE__, __LINE__, ""))
#define assert_that(holds, text) ((holds) ? (void)0 : cmocka_fail(__FILE__, __LINE__, text))
#define assert_true(x) assert_that(x, #x)
#define assert_false(x) assert_that(!(x), "not " #x)
#define assert_null(x) assert_that((x) == NULL, #x " == NULL")
#define assert_non_null(x) assert_that((x) != NULL, #x " != NULL")
#define assert_int_equal(a, b) assert_that((intmax_t)(a) == (intmax_t)(b), #a " == " #b)
#define assert_in_range(x, low, high) assert_that((x) >= (low) && (x) <= (high), #x " in range")
#define assert_string_equal(a, b) assert_that(strcmp(a, b) == 0, #a " == " #b)
#define assert_memory_equal(a, b, size) assert_that(memcmp(a, b, size) == 0, #a " == " #b)

static inline void cmocka_fail(const char *file, int line, const char *text)
{
    printf("\n%s:%d: %s\n", file, line, text);
    longjmp(cmocka_ended, CMOCKA_FAILED);
}

static inline int cmocka_run(const struct CMUnitTest *test, size_t count, int (*setup)(void **state),
                             int (*teardown)(void **state))
{
    static void *state;
    volatile int failed = setup && setup(&state) ? 1 : 0;
    for (volatile size_t i = 0; i < count && test[i].test_func; i++) {
        switch (setjmp(cmocka_ended)) {
        case 0:
            test[i].test_func(&state);
            break;
        case CMOCKA_SKIPPED:
            printf("skipped %s\n", test[i].name);
            break;
        default:
            printf("FAILED %s\n", test[i].name);
            failed++;
        }
        fflush(stdout);
    }
    if (teardown && teardown(&state))
        failed++;
    printf("%d tests failed\n", failed);
    return failed;
}

#define cmocka_run_group_tests(tests, setup, teardown)                                                                 \
    cmocka_run(tests, sizeof(tests) / sizeof *(tests), setup, teardown)
#define cmocka_run_group_tests_name(name, tests, setup, teardown) cmocka_run_group_tests(tests, setup, teardown)

#endif
