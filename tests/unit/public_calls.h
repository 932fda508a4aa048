/* SPDX-License-Identifier: MIT */
/* Declares a call of every public function of the list public_functions.inc, for tests of their common guarantees. */
#ifndef COR_TESTS_PUBLIC_CALLS_H
#define COR_TESTS_PUBLIC_CALLS_H

#include <stddef.h>
#include <stdint.h>

#include <cor/cor.h>
#include <cor/disk.h>

#include "random.h"

/* More numbers than any loop of the library processes at once */
enum { PUBLIC_COUNT = 150, PUBLIC_MODES = 320 }; /* enough modes for two levels of the rigid wall */

/* Arguments: n values for each parameter name in the headers */
struct arguments {
#define NUMBER(name)                                                                                                   \
    double name[PUBLIC_COUNT];                                                                                         \
    float name##f[PUBLIC_COUNT];
#include "public_functions.inc"
    struct cor_sphere_contact contact[PUBLIC_COUNT];
    struct cor_body body_1[PUBLIC_COUNT], body_2[PUBLIC_COUNT], sphere[PUBLIC_COUNT];
    struct cor_plate plate[PUBLIC_COUNT];
    struct cor_half_space half_space[PUBLIC_COUNT];
    struct cor_disk_modes modes[PUBLIC_COUNT];
    struct cor_disk_mode harmed[PUBLIC_MODES]; /* tables that no disk has */
    struct cor_disk_collision_options disk_collision_options[PUBLIC_COUNT];
    struct cor_disk_hard_wall_options disk_hard_wall_options[PUBLIC_COUNT];
    enum cor_disk_datum datum[PUBLIC_COUNT];
    size_t n_modes[PUBLIC_COUNT];
    int depth[PUBLIC_COUNT], status[PUBLIC_COUNT];
    size_t n;
};

/* A source of random bits */
struct bit_source {
    uint64_t (*next)(struct bit_source *source);
};

struct random_bits {
    struct bit_source source;
    struct random_state random;
};

uint64_t random_bits_next(struct bit_source *source);
size_t draw_below(struct bit_source *source, size_t n);               /* 0, 1, ... or n - 1 */
double draw_size(struct bit_source *source, double low, double high); /* makes all magnitudes about equally likely */

/* Draws arguments inside and outside the domains: special and extreme values, any magnitude, and ordinary values. No
 * subnormal values if `subnormal` is 0. */
void arguments_draw(struct arguments *a, struct bit_source *source, size_t n, int subnormal);
void arguments_flush(struct arguments *a); /* replaces subnormal values by 0 */

struct results {
    double *value;
    size_t count, capacity;
};

void results_put(struct results *r, double value);
void results_clear(struct results *r);

enum public_type { PUBLIC_double, PUBLIC_float, PUBLIC_size_t, PUBLIC_several };

struct public_function {
    const char *name;
    void (*call)(const struct arguments *a, struct results *r);     /* calls for all n arguments, or a single call */
    void (*elements)(const struct arguments *a, struct results *r); /* for an array: a call per element; or NULL */
    enum public_type type;
};

/* True if result j of a call with n arguments is eps or 1 - eps, which is in [0, 1]. Decides by the function's name. */
int public_is_part(const struct public_function *function, size_t j, size_t n);

extern const struct public_function public_functions[];
extern const size_t public_function_count;

#endif
