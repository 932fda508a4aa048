/* SPDX-License-Identifier: MIT */
/* The stack that public functions take, for simulators that call them from threads with little of it: a thread runs on
 * painted memory, and what is not paint afterwards was used. */
#define _POSIX_C_SOURCE 200809L
#include "check.h"

#include <pthread.h>

#include <cor/cor.h>

enum { SIZE = 1 << 20, PAINT = 0xa5, MODES = 300, COUNT = 1800 };

static unsigned char stack[SIZE] __attribute__((aligned(4096)));
static double x[COUNT], y[COUNT];
static float xf[COUNT], yf[COUNT];
static volatile double sink;

/* ---- what is called ---- */

static void nothing(void)
{
}

static void disk_law(void)
{
    static const enum cor_disk_datum datum[] = {COR_DISK_DATUM_CENTRE_OF_MASS, COR_DISK_DATUM_DIAMETER,
                                                COR_DISK_DATUM_PRINTED};
    for (size_t i = 0; i < 3; i++)
        for (double v = 1e-6; v < 0.5; v *= 30)
            sink = cor_disk_load(v, 0.33, datum[i]) + cor_disk_compression(v, 0.33, datum[i]) +
                   cor_disk_energy(v, 0.33, datum[i]) + cor_disk_max_compression(v, 0.33, datum[i]) +
                   cor_disk_max_load(v, 0.33, datum[i]) + cor_disk_contact_time(v, 0.33, datum[i]);
}

static void disk_rayleigh(void)
{
    struct cor_disk_rayleigh out;
    size_t n;
    for (double v = 1e-9; v < 0.03; v *= 100) {
        cor_disk_rayleigh(&cor_disk_modes_nu033, 1800, COR_DISK_DATUM_CENTRE_OF_MASS, v, &out, x);
        cor_disk_rayleigh_tolerance(&cor_disk_modes_nu033, COR_DISK_DATUM_CENTRE_OF_MASS, v, 1e-9, &out, &n);
    }
}

static void observe(void *context, const struct cor_disk_moment *moment)
{
    (void)context;
    sink = moment->load;
}

static void disk_collision(void)
{
    const struct cor_disk_collision_options options = {500, 1e-6, 0, 0};
    static double q[MODES], q_dot[MODES], average[MODES], after[MODES];
    const struct cor_disk_collision_detail detail = {after, average, observe, NULL, q, q_dot};
    struct cor_disk_collision out;
    const size_t bytes = cor_disk_collision_workspace(&cor_disk_modes_nu033, MODES, &options);
    void *const workspace = malloc(bytes + 1);
    if (workspace != NULL)
        cor_disk_collision_in(workspace, bytes, &cor_disk_modes_nu033, MODES, &options, 0.1, &out, &detail);
    free(workspace);
    cor_disk_collision(&cor_disk_modes_nu033, MODES, &options, 0.1, &out);
}

static void disk_limits(void)
{
    sink = cor_disk_eps(0.1, 0.33) + cor_disk_eps_uncertainty(0.1, 0.33) + cor_disk_one_minus_eps2(0.1, 0.33) +
           cor_disk_one_minus_eps2_uncertainty(0.1, 0.33);
}

static void disk_modes_read(void)
{
    struct cor_disk_mode mode[2];
    struct cor_disk_modes modes;
    size_t line;
    sink = cor_disk_modes_read("/dev/null", mode, 2, &modes, &line);
}

static void spheres(void)
{
    for (size_t i = 0; i < COUNT; i += 7) {
        sink = cor_sphere_eps_zero_force(x[i]) + cor_sphere_loss_zero_overlap(x[i]) + cor_sphere_max_overlap(x[i]);
        sink = cor_sphere_beta_zero_force(1 / (1 + x[i])) + cor_sphere_duration_zero_force(x[i]);
    }
    cor_sphere_eps_zero_force_array(x, y, COUNT);
    cor_sphere_eps_zero_overlap_array(x, y, COUNT);
    cor_sphere_eps_zero_force_arrayf(xf, yf, COUNT);
    cor_sphere_duration_zero_force_array(x, y, COUNT);
    cor_sphere_beta_zero_force_array(y, y, COUNT);
}

static void contacts(void)
{
    struct cor_sphere_contact contact;
    cor_sphere_contact_init_g_star(&contact, 0.2);
    sink = cor_contact_eps_zero_force(&contact, 1) + cor_contact_beta(&contact, 1);
    cor_contact_eps_zero_force_array(&contact, x, y, COUNT);
    cor_contact_eps_zero_overlap_array(&contact, x, y, COUNT);
}

/* ---- how much stack ---- */

static void (*called)(void);

static void *call(void *unused)
{
    (void)unused;
    called();
    return NULL;
}

/* Bytes of the painted stack that are in use after a thread has called the function */
static size_t stack_taken(void (*function)(void))
{
    pthread_attr_t attributes;
    pthread_t thread;
    called = function;
    memset(stack, PAINT, SIZE);
    assert_int_equal(pthread_attr_init(&attributes), 0);
    assert_int_equal(pthread_attr_setstack(&attributes, stack, SIZE), 0);
    assert_int_equal(pthread_create(&thread, &attributes, call, NULL), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    pthread_attr_destroy(&attributes);
    size_t free_bytes = 0;
    while (free_bytes < SIZE && stack[free_bytes] == PAINT)
        free_bytes++;
    return SIZE - free_bytes;
}

static void stack_of_functions(void **state)
{
    (void)state;
#if defined __SANITIZE_ADDRESS__ || !defined __OPTIMIZE__
    print_message("skipped: instrumented or not optimised, functions take more\n");
    skip();
#endif
    static const struct {
        const char *name;
        void (*function)(void);
        size_t most; /* what cor/disk.h says, with a margin */
    } group[] = {
        {"cor_disk_rayleigh", disk_rayleigh, 60000},
        {"cor_disk_collision", disk_collision, 10000},
        {"cor_disk_load and others", disk_law, 6000},
        {"cor_disk_eps and others", disk_limits, 6000},
        {"cor_disk_modes_read", disk_modes_read, 6000},
        {"cor/sphere.h", spheres, 24000},
        {"cor/contact.h", contacts, 24000},
    };
    for (size_t i = 0; i < COUNT; i++) {
        x[i] = exp(0.01 * (double)i - 10);
        xf[i] = (float)x[i];
    }
    const size_t thread = stack_taken(nothing);
    for (size_t i = 0; i < sizeof group / sizeof *group; i++) {
        const size_t taken = stack_taken(group[i].function) - thread;
        print_message("%s: %zu bytes\n", group[i].name, taken);
        check(taken <= group[i].most && taken <= COR_DISK_MAX_STACK, "%s: %zu bytes of stack", group[i].name, taken);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stack_of_functions),
    };
    return cmocka_run_group_tests_name("stack", tests, NULL, NULL);
}
