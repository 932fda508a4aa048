/* SPDX-License-Identifier: MIT */
/* Shared by the fuzz targets: values made from the bytes of libFuzzer, and properties that must hold. */
#ifndef COR_FUZZ_H
#define COR_FUZZ_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../unit/ulp.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Traps if the condition fails; libFuzzer then saves the input. */
#define REQUIRE(condition, ...)                                                                                        \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            fprintf(stderr, "%s:%d: property violated: %s: ", __FILE__, __LINE__, #condition);                         \
            fprintf(stderr, __VA_ARGS__);                                                                              \
            fputc('\n', stderr);                                                                                       \
            __builtin_trap();                                                                                          \
        }                                                                                                              \
    } while (0)

struct input {
    const uint8_t *at;
    size_t left;
};

/* Copies bytes of the input; zeros if nothing is left. */
static inline void input_take(struct input *in, void *to, size_t size)
{
    const size_t n = size < in->left ? size : in->left;
    memset(to, 0, size);
    if (n == 0)
        return;
    memcpy(to, in->at, n);
    in->at += n;
    in->left -= n;
}

static inline uint8_t take_byte(struct input *in)
{
    uint8_t x;
    input_take(in, &x, sizeof x);
    return x;
}

/* Returns a number from 0 to `most`, all about equally likely. */
static inline size_t take_up_to(struct input *in, size_t most)
{
    uint16_t x;
    input_take(in, &x, sizeof x);
    return x % (most + 1);
}

/* Allocates exactly this number of bytes, so that the sanitizers detect an access beyond. For zero bytes it allocates
 * one byte, which is never set, because malloc(0) may return NULL. */
static inline void *exactly(size_t size)
{
    void *p = malloc(size > 0 ? size : 1);
    if (!p)
        abort();
    return p;
}

#endif
