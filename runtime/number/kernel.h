/* SPDX-License-Identifier: MIT */
/* Masks, which the loops of all kernels share. */
#ifndef COR_RUNTIME_KERNEL_H
#define COR_RUNTIME_KERNEL_H

#include "runtime/number/pair.h"

/* Attribute of functions that must not be inlined: functions called once for each block of numbers, and functions
 * called in another floating-point environment */
#if defined(__GNUC__) && !defined(__clang__)
#define SHARED static __attribute__((noinline, noclone))
#elif defined(__clang__)
#define SHARED static __attribute__((noinline))
#else
#define SHARED static
#endif

/* Conditions are masks with all bits 1 or all bits 0, and selections use them. Compilers always vectorise masks, but
 * conditional expressions only sometimes. */
typedef int64_t mask;

COR_KERNEL mask mask_of(int condition)
{
    return -(mask)condition;
}

/* True if first <= x < end. The bits of nonnegative doubles, read as integers, have the order of the doubles. The bits
 * of negative doubles are negative integers. */
COR_KERNEL mask is_between(double x, double first, double end)
{
    const int64_t bits = (int64_t)cor_inline_bits(x);
    return mask_of(bits >= (int64_t)cor_inline_bits(first)) & mask_of(bits < (int64_t)cor_inline_bits(end));
}

COR_KERNEL mask is_same(double x, double y)
{
    return mask_of(cor_inline_bits(x) == cor_inline_bits(y));
}

COR_KERNEL uint64_t choose_bits(mask choice, uint64_t if_true, uint64_t if_false)
{
    return (if_true & (uint64_t)choice) | (if_false & ~(uint64_t)choice);
}

COR_KERNEL double choose_double(mask choice, double if_true, double if_false)
{
    return cor_inline_from_bits(choose_bits(choice, cor_inline_bits(if_true), cor_inline_bits(if_false)));
}

#endif
