/* SPDX-License-Identifier: MIT */
/* Tests the guarantees that every public function in the list of the bindings gives for any arguments. */
#include <errno.h>
#include <fenv.h>

#include "fuzz.h"

#include "../unit/scene_calls.h"

enum { REFUSED = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW, FEW = 4 };

/* Bits of the input. After its end, random numbers follow, whose seed depends on the whole input. */
struct input_bits {
    struct bit_source source;
    struct input in;
    struct random_state after;
};

static uint64_t next_bits(struct bit_source *source)
{
    struct input_bits *const bits = (struct input_bits *)source;
    uint64_t x;
    if (bits->in.left == 0)
        return random_bits(&bits->after);
    input_take(&bits->in, &x, sizeof x);
    return x;
}

/* Requires that eps and 1 - eps are from 0 to 1 and that other results are not negative. Skips functions of contacts
 * and plates with arbitrary fields, Hunt and Crossley's law, whose beta may be negative, and tangential motion. */
static void check_range(const struct public_function *f, const struct results *r)
{
    static const char *const any[] = {"cor_contact_", "cor_plate_", "hunt_crossley", "cor_tangential_"};
    for (size_t k = 0; k < sizeof any / sizeof *any; k++)
        if (strstr(f->name, any[k]) != NULL)
            return;
    const double most = public_is_part(f, 0, 1) ? 1 + 0x1p-48 : INFINITY;
    for (size_t i = 0; i < r->count && f->type != PUBLIC_several; i++)
        REQUIRE(isnan(r->value[i]) || (r->value[i] >= 0 && r->value[i] <= most), "%s, %zu: %a", f->name, i,
                r->value[i]);
}

static void check_same(const struct public_function *f, const struct results *x, const struct results *y,
                       const char *of)
{
    REQUIRE(x->count == y->count, "%s, %s", f->name, of);
    for (size_t i = 0; i < x->count; i++)
        REQUIRE(same_number(x->value[i], y->value[i]), "%s, %s, %zu: %a, before %a", f->name, of, i, y->value[i],
                x->value[i]);
}

static void check_function(const struct public_function *f, const struct arguments *a)
{
    struct results r = {NULL, 0, 0}, again = {NULL, 0, 0};
    feclearexcept(FE_ALL_EXCEPT);
    errno = 0;
    f->call(a, &r);
    const int raised = fetestexcept(REFUSED), error = errno;
    REQUIRE(raised == 0 && error == 0, "%s raises %x, errno %d", f->name, (unsigned)raised, error);
    check_range(f, &r);
    (f->elements != NULL ? f->elements : f->call)(a, &again);
    check_same(f, &r, &again, f->elements != NULL ? "one by one" : "again");
    results_clear(&r);
    results_clear(&again);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct arguments a;
    static struct scene_arguments scenes[SCENES];
    struct input_bits bits = {{next_bits}, {data, size}, {1}};
    for (size_t i = 0; i < size; i++)
        bits.after.state = (bits.after.state ^ data[i]) * UINT64_C(1099511628211) | 1;
    const size_t chosen = take_up_to(&bits.in, function_count() - 1), how = take_byte(&bits.in);
    const size_t n = how < 0x40 ? 1 + take_up_to(&bits.in, PUBLIC_COUNT - 1) : 1 + how % FEW;
    sets = &a;
    scene_sets = scenes;
    arguments_draw(&a, &bits.source, n, 1);
    memset(a.beta + n, 0, (PUBLIC_COUNT - n) * sizeof *a.beta); /* scenes read all elements */
    if (chosen >= public_function_count)
        scene_sets_draw(0, &bits.source);
    for (size_t k = 0; k < function_count(); k++) /* a slow function runs only if it is chosen */
        if (k == chosen || (n <= FEW && function_number(k)->type != PUBLIC_several))
            check_function(function_number(k), &a);
    return 0;
}
