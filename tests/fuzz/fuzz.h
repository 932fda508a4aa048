/* SPDX-License-Identifier: MIT */
/* What the fuzz targets share: values out of the bytes that libFuzzer hands them, and properties that must hold.
 *
 * Doubles are taken as raw bits, or, for three first bytes of four, from a narrower set where random bits hardly ever
 * fall: special values, exponents around 1. */
#ifndef COR_FUZZ_H
#define COR_FUZZ_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* libFuzzer keeps the input of a program that traps. */
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

/* Zeros where there is nothing left */
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

/* 0 to most, all of them likely */
static inline size_t take_up_to(struct input *in, size_t most)
{
    uint16_t x;
    input_take(in, &x, sizeof x);
    return x % (most + 1);
}

static inline int take_int(struct input *in)
{
    int x;
    input_take(in, &x, sizeof x);
    return x;
}

static inline double double_of(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline double take_double(struct input *in)
{
    static const double special[] = {0.0,
                                     -0.0,
                                     INFINITY,
                                     -INFINITY,
                                     NAN,
                                     1,
                                     -1,
                                     0x1p-1074,
                                     0x1p-1022,
                                     0.5,
                                     0.25,
                                     0.03,
                                     0.33,
                                     0.9,
                                     2,
                                     4,
                                     7,
                                     8,
                                     16,
                                     40,
                                     1e5,
                                     1e-13,
                                     0x1.fffffffffffffp-1,
                                     0x1.0000000000001p+0,
                                     0x1.fffffffffffffp+1023,
                                     0x1p-20,
                                     0x1p-53,
                                     0x1p-900,
                                     0x1p+14,
                                     0x1p+20};
    enum { SPECIALS = sizeof special / sizeof *special };
    uint64_t bits;
    const uint8_t how = take_byte(in);
    if (how >= 0xc0)
        return special[how % SPECIALS];
    input_take(in, &bits, sizeof bits);
    if (how >= 0x40) { /* from 2^-63 to 2^8, one of four of them negative */
        const uint64_t exponent = 1023 - 63 + (bits >> 52) % 72, sign = (how & 3) == 3;
        bits = sign << 63 | exponent << 52 | (bits & (UINT64_C(0xfffffffffffff)));
    }
    return double_of(bits);
}

static inline float take_float(struct input *in)
{
    float x;
    if (take_byte(in) >= 0x40)
        return (float)take_double(in);
    input_take(in, &x, sizeof x);
    return x;
}

/* Equal to the last bit, or both no numbers */
static inline int same(double a, double b)
{
    return bits_of(a) == bits_of(b) || (isnan(a) && isnan(b));
}

/* Memory of exactly so many bytes, so that the sanitizers see a step beyond. None is one byte, never set: malloc may
 * answer no bytes with NULL. */
static inline void *exactly(size_t size)
{
    void *p = malloc(size > 0 ? size : 1);
    if (!p)
        abort();
    return p;
}

/* A pattern that no function writes by chance */
enum { UNTOUCHED = 0xa5 };

static inline int is_untouched(const void *object, size_t size)
{
    const unsigned char *byte = object;
    for (size_t i = 0; i < size; i++)
        if (byte[i] != UNTOUCHED)
            return 0;
    return 1;
}

#endif
