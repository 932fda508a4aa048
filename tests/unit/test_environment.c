/* SPDX-License-Identifier: MIT */
/* Tests the floating-point environment of every public function, from the list that the bindings read. For any
 * arguments, no function raises FE_INVALID, FE_DIVBYZERO or FE_OVERFLOW, even with traps, and none sets errno. If the
 * caller flushes subnormal numbers to zero, results change by a relative 1e-9 at most, and a call keeps this mode. */
#ifdef __linux__
#define _GNU_SOURCE /* feenableexcept */
#endif
#include "check.h"

#include <errno.h>
#include <fenv.h>
#include <signal.h>

#include "cor_sphere.h"
#include "embedded.h"
#include "public_calls.h"
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

/* Adds the functions of generated/cor_sphere.h, which are not in the library's lists. Inverses are called with eps. */
#define INLINE_FUNCTION(name)                                                                                          \
    static void inline_##name(const struct arguments *a, struct results *r)                                            \
    {                                                                                                                  \
        for (size_t i = 0; i < a->n; i++)                                                                              \
            results_put(r, cor_inline_##name(strncmp(#name, "beta", 4) == 0 ? a->eps[i] : a->beta[i]));                \
    }
EMBEDDED_LIST(INLINE_FUNCTION)
#define INLINE_ROW(name) {"cor_inline_" #name, inline_##name, NULL, PUBLIC_double},
static const struct public_function inline_functions[] = {EMBEDDED_LIST(INLINE_ROW)};

#include "scene_calls.h"

static size_t all_count(void)
{
    return function_count() + COUNT_OF(inline_functions);
}

static const struct public_function *any_function(size_t k)
{
    return k < function_count() ? function_number(k) : &inline_functions[k - function_count()];
}

/* ---- arguments and results ---- */

/* If subnormal arguments count as 0, the results may be the ones for 0. Every second set has no subnormal arguments. */
enum { WITHOUT_SUBNORMALS = 1 };
static size_t set_count;
static struct results *expected;  /* results of function k for set i, at k set_count + i */
static unsigned char *takes_long; /* 1: this call is too slow to repeat */

static int setup(void **state)
{
    (void)state;
    struct random_bits random = {{random_bits_next}, random_start()};
    set_count = 2 + points(10);
    sets = calloc(set_count, sizeof *sets);
    scene_sets = calloc(SCENES * set_count, sizeof *scene_sets);
    assert_non_null(sets);
    assert_non_null(scene_sets);
    for (size_t i = 0; i < set_count; i++) {
        arguments_draw(&sets[i], &random.source, PUBLIC_COUNT, i % 2 != WITHOUT_SUBNORMALS);
        scene_sets_draw(i, &random.source);
    }
    expected = calloc(all_count() * set_count, sizeof *expected);
    assert_non_null(expected);
    takes_long = calloc(all_count() * set_count, 1);
    assert_non_null(takes_long);
    for (size_t k = 0; k < all_count(); k++)
        for (size_t i = 0; i < set_count; i++) {
            const clock_t start = clock();
            any_function(k)->call(&sets[i], &expected[k * set_count + i]);
            takes_long[k * set_count + i] = clock() - start > CLOCKS_PER_SEC / 50;
        }
    return 0;
}

static int free_results(void **state)
{
    (void)state;
    for (size_t i = 0; i < all_count() * set_count; i++)
        results_clear(&expected[i]);
    free(expected);
    free(takes_long);
    free(sets);
    free(scene_sets);
    return 0;
}

/* True if a result changes by a small fraction only, or by a few of the smallest normal numbers, because subnormal
 * numbers are lost. Infinite results and NaN must not change. */
static int is_sane(const struct public_function *f, double x, double before)
{
    const int is_float = f->type == PUBLIC_float || strcmp(f->name, "cor_law_arrayf") == 0;
    const double tolerance = is_float ? (double)FLT_EPSILON : 1e-9, least = is_float ? (double)FLT_MIN : DBL_MIN;
    if (isnan(before) || isinf(before))
        return x == before || (isnan(x) && isnan(before));
    return fabs(x - before) <= tolerance * fabs(before) + 64 * least;
}

/* ---- the tests ---- */

enum { REFUSED = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW };

/* Calls the function while subnormal numbers count as 0. Each result must be close to the result in the default
 * environment, for the same arguments or for arguments whose subnormal numbers are replaced by 0. */
static void call_again(size_t k, size_t i)
{
    const struct public_function *const f = any_function(k);
    const struct results *const before = &expected[k * set_count + i];
    struct results r = {NULL, 0, 0}, of_zeros = {NULL, 0, 0};
    fenv_t environment;
    if (takes_long[k * set_count + i])
        return;
    feclearexcept(FE_ALL_EXCEPT);
    f->call(&sets[i], &r);
    check(!fetestexcept(REFUSED), "%s, set %zu: raises an exception", f->name, i);
    feholdexcept(&environment);
    fesetenv(FE_DFL_ENV);
    if (i % 2 != WITHOUT_SUBNORMALS && (k < public_function_count || k >= function_count())) {
        static struct arguments flushed;
        flushed = sets[i];
        arguments_flush(&flushed);
        f->call(&flushed, &of_zeros);
    }
    assert_int_equal(r.count, before->count);
    /* compares no texts, and results for subnormal arguments only in functions of spheres and laws */
    const int compares = strcmp(f->name, "cor_simulator_lines") != 0 &&
                         (i % 2 == WITHOUT_SUBNORMALS || strncmp(f->name, "cor_sphere_", 11) == 0 ||
                          strncmp(f->name, "cor_law_", 8) == 0 || strncmp(f->name, "cor_inline_", 11) == 0);
    for (size_t j = 0; compares && j < r.count; j++)
        check(is_sane(f, r.value[j], before->value[j]) || (of_zeros.count && is_sane(f, r.value[j], of_zeros.value[j])),
              "%s, set %zu, result %zu: %a for %a", f->name, i, j, r.value[j], before->value[j]);
    results_clear(&r);
    results_clear(&of_zeros);
    fesetenv(&environment);
}

/* A flag raised before the call remains, and so does errno. */
TEST(no_exception_and_no_errno)
{
    fesetenv(FE_DFL_ENV);
    for (size_t k = 0; k < all_count(); k++)
        for (size_t i = 0; i < set_count; i++) {
            const int before = i % 3 == 0 ? FE_DIVBYZERO : 0, number = i % 3 == 0 ? ENOENT : 0;
            struct results r = {NULL, 0, 0};
            feclearexcept(FE_ALL_EXCEPT);
            feraiseexcept(before);
            errno = number;
            any_function(k)->call(&sets[i], &r);
            const int raised = fetestexcept(REFUSED), error = errno;
            results_clear(&r);
            check(raised == before, "%s, set %zu: raises %s", any_function(k)->name, i,
                  raised & FE_INVALID    ? "FE_INVALID"
                  : raised & FE_OVERFLOW ? "FE_OVERFLOW"
                  : raised               ? "FE_DIVBYZERO"
                                         : "nothing, and clears FE_DIVBYZERO");
            check(error == number, "%s, set %zu: errno = %d", any_function(k)->name, i, error);
        }
}

#ifdef __GLIBC__
static sigjmp_buf trapped;

static void trap(int signal)
{
    siglongjmp(trapped, signal);
}
#endif

TEST(traps)
{
    fesetenv(FE_DFL_ENV);
#ifdef __GLIBC__
    struct sigaction action, before;
    memset(&action, 0, sizeof action);
    action.sa_handler = trap;
    sigaction(SIGFPE, &action, &before);
    for (volatile size_t k = 0; k < all_count(); k++)
        for (volatile size_t i = 0; i < set_count; i++) {
            struct results r = {NULL, 0, 0};
            if (sigsetjmp(trapped, 1))
                fail_msg("%s, set %zu: traps", any_function(k)->name, (size_t)i);
            feclearexcept(FE_ALL_EXCEPT);
            if (feenableexcept(REFUSED) == -1)
                skip(); /* the machine has no traps */
            any_function(k)->call(&sets[i], &r);
            const int trapping = fedisableexcept(FE_ALL_EXCEPT);
            results_clear(&r);
            check(trapping == REFUSED, "%s, set %zu: the traps changed", any_function(k)->name, (size_t)i);
        }
    sigaction(SIGFPE, &before, NULL);
#else
    skip(); /* no feenableexcept */
#endif
}

TEST(flushing_to_zero)
{
    fesetenv(FE_DFL_ENV);
#ifdef __SSE2__
    const unsigned control = _mm_getcsr(), flush = 0x8040; /* FTZ and DAZ */
    for (size_t k = 0; k < all_count(); k++)
        for (size_t i = 0; i < set_count; i++) {
            _mm_setcsr(control | flush);
            call_again(k, i);
            check((_mm_getcsr() & flush) == flush, "%s: changes the modes", any_function(k)->name);
        }
    _mm_setcsr(control);
#else
    skip();
#endif
}

/* An array function gives the bits of its scalar function, for every length. */
TEST(arrays)
{
    fesetenv(FE_DFL_ENV);
    for (size_t k = 0; k < public_function_count; k++)
        for (size_t i = 0; i < set_count && public_functions[k].elements; i++)
            for (size_t part = 0; part < 3; part++) {
                const size_t n = part == 0 ? PUBLIC_COUNT : part == 1 ? (7 * i + k) % PUBLIC_COUNT : (i + k) % 20;
                struct results r = {NULL, 0, 0}, whole = {NULL, 0, 0};
                sets[i].n = n;
                public_functions[k].call(&sets[i], &whole);
                public_functions[k].elements(&sets[i], &r);
                sets[i].n = PUBLIC_COUNT;
                assert_true(r.count == n && whole.count == n);
                for (size_t j = 0; j < n; j++)
                    check(same_number(r.value[j], whole.value[j]), "%s, set %zu, element %zu of %zu: %a, alone %a",
                          public_functions[k].name, i, j, n, whole.value[j], r.value[j]);
                results_clear(&r);
                results_clear(&whole);
            }
}

GROUP(setup, free_results)
