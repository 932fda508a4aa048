/* SPDX-License-Identifier: MIT */
/* Tests how much stack each function in the list of the bindings uses, and whether it allocates memory. Simulators call
 * these functions from threads with a small stack. Each function runs in a thread on a stack filled with a pattern;
 * changed bytes were used. */
#define _POSIX_C_SOURCE 200809L
#include "check.h"

#include <pthread.h>

#include "scene_calls.h"

enum { SIZE = 1 << 20, PAINT = 0xa5, SETS = 12, MOST_RESULTS = 100000 };

static unsigned char stack[SIZE] __attribute__((aligned(4096)));
static struct results results; /* allocated before the calls, outside the painted stack */

static int setup(void **state)
{
    (void)state;
    struct random_bits random = {{random_bits_next}, random_start()};
    results.capacity = MOST_RESULTS;
    results.value = malloc(MOST_RESULTS * sizeof *results.value);
    assert_non_null(results.value);
    sets = calloc(SETS, sizeof *sets);
    scene_sets = calloc(SCENES * SETS, sizeof *scene_sets);
    assert_non_null(sets);
    assert_non_null(scene_sets);
    for (size_t i = 0; i < SETS; i++) {
        arguments_draw(&sets[i], &random.source, PUBLIC_COUNT, 1);
        scene_sets_draw(i, &random.source);
    }
    /* The first set is accepted by every function of disks, with many neighbouring speeds. */
    struct arguments *const a = &sets[0];
    for (size_t i = 0; i < PUBLIC_COUNT; i++)
        a->speed[i] = 1e-3 * (1 + 0.01 * (double)i);
    a->nu[0] = 0.33;
    a->datum[0] = COR_DISK_DATUM_CENTRE_OF_MASS;
    a->n_modes[0] = 4;
    a->disk_collision_options[0] = (struct cor_disk_collision_options){100, 1e-2, 0, 0};
    a->disk_hard_wall_options[0] = (struct cor_disk_hard_wall_options){0.05, 0};
    return 0;
}

/* ---- use of stack ---- */

static const struct public_function *called;

static void *call_with_all(void *unused)
{
    (void)unused;
    for (size_t i = 0; called != NULL && i < SETS; i++) {
        results.count = 0;
        called->call(&sets[i], &results);
    }
    return NULL;
}

/* Returns the bytes of stack that a thread used to call the function. NULL: the thread calls no function. */
static size_t stack_taken(const struct public_function *function)
{
    pthread_attr_t attributes;
    pthread_t thread;
    called = function;
    memset(stack, PAINT, SIZE);
    assert_int_equal(pthread_attr_init(&attributes), 0);
    assert_int_equal(pthread_attr_setstack(&attributes, stack, SIZE), 0);
    assert_int_equal(pthread_create(&thread, &attributes, call_with_all, NULL), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    pthread_attr_destroy(&attributes);
    size_t free_bytes = 0;
    while (free_bytes < SIZE && stack[free_bytes] == PAINT)
        free_bytes++;
    return SIZE - free_bytes;
}

/* Returns the bytes of stack that the headers state, by the first prefix that matches the name. */
static size_t stack_stated(const struct public_function *function, int of_scene)
{
    static const struct {
        const char *name;
        size_t most;
    } stated[] = {
        {"cor_disk_rayleigh", COR_DISK_MAX_STACK},
        {"cor_disk_hard_wall", 28672},
        {"cor_disk_", 8192},
        {"cor_sphere_contact", COR_CONTACT_MAX_STACK},
        {"cor_sphere_mass", 4096},
        {"cor_sphere_", COR_SPHERE_MAX_STACK},
        {"cor_contact_", COR_CONTACT_MAX_STACK},
        {"cor_law_", COR_LAW_MAX_STACK},
        {"cor_hunt_crossley_", COR_LAW_MAX_STACK},
    };
    const size_t count = sizeof stated / sizeof *stated;
    size_t i = 0;
    while (i < count && strncmp(function->name, stated[i].name, strlen(stated[i].name)) != 0)
        i++;
    const int of_a_disk = strncmp(function->name, "cor_disk_", 9) == 0;
    return of_scene                                                       ? COR_SCENE_MAX_STACK
           : i < count && (strstr(function->name, "_array") || of_a_disk) ? stated[i].most
                                                                          : 4096;
}

TEST(stack_of_functions)
{
#if defined __SANITIZE_ADDRESS__ || !defined __OPTIMIZE__
    skip(); /* instrumented or unoptimised functions need more stack */
#endif
    const size_t thread = stack_taken(NULL);
    for (size_t k = 0; k < function_count(); k++) {
        const struct public_function *const f = function_number(k);
        const size_t whole = stack_taken(f), taken = whole > thread ? whole - thread : 0;
        const size_t stated = stack_stated(f, k >= public_function_count);
        check(taken <= stated, "%s: %zu bytes of stack, %zu stated", f->name, taken, stated);
    }
}

/* ---- allocations ---- */

static size_t allocations;

#ifdef COR_TEST_WRAPS_MALLOC /* the linker replaces malloc */
#define WRAP(name, parameters, given)                                                                                  \
    void *__real_##name parameters;                                                                                    \
    void *__wrap_##name parameters;                                                                                    \
    void *__wrap_##name parameters                                                                                     \
    {                                                                                                                  \
        allocations++;                                                                                                 \
        return __real_##name given;                                                                                    \
    }
WRAP(malloc, (size_t size), (size))
WRAP(calloc, (size_t count, size_t size), (count, size))
WRAP(realloc, (void *old, size_t size), (old, size))
#endif

TEST(only_these_allocate)
{
#ifndef COR_TEST_WRAPS_MALLOC
    skip(); /* this linker cannot replace functions of the library */
#endif
    static const char *const allocating[] = {"cor_disk_modes_compute", "cor_disk_rayleigh_array",
                                             "cor_disk_collision",     "cor_disk_collision_array",
                                             "cor_disk_hard_wall",     "cor_disk_hard_wall_nu"};
    for (size_t k = 0; k < function_count(); k++) {
        const struct public_function *const f = function_number(k);
        int stated = 0;
        for (size_t i = 0; i < sizeof allocating / sizeof *allocating; i++)
            stated |= strcmp(f->name, allocating[i]) == 0;
        const size_t before = allocations;
        for (size_t i = 0; i < SETS; i++) {
            results.count = 0;
            f->call(&sets[i], &results);
        }
        check((allocations > before) == stated, "%s allocates %zu times", f->name, allocations - before);
    }
}

static int free_results(void **state)
{
    (void)state;
    results_clear(&results);
    free(sets);
    free(scene_sets);
    return 0;
}

GROUP(setup, free_results)
