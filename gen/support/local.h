/* SPDX-License-Identifier: MIT */
/* Local variables of FLINT's types:
 *
 *     LOCAL(arb, x, y);
 *
 * declares arb_t x, y, initialised. Whatever way leads out of their block clears them, after the value of a return has
 * been computed (the attribute `cleanup` of gcc and clang). And members of a structure:
 *
 *     FOR_ALL(arb, init, s->x, s->y);    FOR_ALL(arb, clear, s->x, s->y); */
#ifndef COR_GEN_SUPPORT_LOCAL_H
#define COR_GEN_SUPPORT_LOCAL_H

#include "support/flint.h"

#define LOCAL(type, ...)                                                                                               \
    __attribute__((cleanup(type##_local_clear))) type##_t LOCAL_OF(__VA_ARGS__, 9, 8, 7, 6, 5, 4, 3, 2, 1,             \
                                                                   0)(type, __VA_ARGS__)

/* LOCAL_n declares n variables, n <= 9. */
#define LOCAL_OF(a, b, c, d, e, f, g, h, i, n, ...) LOCAL_##n
#define LOCAL_1(type, x) x = {type##_local()}
#define LOCAL_2(type, x, ...) LOCAL_1(type, x), LOCAL_1(type, __VA_ARGS__)
#define LOCAL_3(type, x, ...) LOCAL_1(type, x), LOCAL_2(type, __VA_ARGS__)
#define LOCAL_4(type, x, ...) LOCAL_1(type, x), LOCAL_3(type, __VA_ARGS__)
#define LOCAL_5(type, x, ...) LOCAL_1(type, x), LOCAL_4(type, __VA_ARGS__)
#define LOCAL_6(type, x, ...) LOCAL_1(type, x), LOCAL_5(type, __VA_ARGS__)
#define LOCAL_7(type, x, ...) LOCAL_1(type, x), LOCAL_6(type, __VA_ARGS__)
#define LOCAL_8(type, x, ...) LOCAL_1(type, x), LOCAL_7(type, __VA_ARGS__)
#define LOCAL_9(type, x, ...) LOCAL_1(type, x), LOCAL_8(type, __VA_ARGS__)

#define LOCAL_TYPE(type, structure)                                                                                    \
    static inline structure type##_local(void)                                                                         \
    {                                                                                                                  \
        structure x;                                                                                                   \
        type##_init(&x);                                                                                               \
        return x;                                                                                                      \
    }                                                                                                                  \
    static inline void type##_local_clear(type##_t *x)                                                                 \
    {                                                                                                                  \
        type##_clear(*x);                                                                                              \
    }

#define FOR_ALL(type, action, ...)                                                                                     \
    do {                                                                                                               \
        type##_struct *const all_[] = {__VA_ARGS__};                                                                   \
        for (size_t i_ = 0; i_ < sizeof all_ / sizeof *all_; i_++)                                                     \
            type##_##action(all_[i_]);                                                                                 \
    } while (0)

/* makes LOCAL(name, x) of a struct name with name_init and name_clear */
#define LOCAL_STRUCT(name)                                                                                             \
    typedef struct name name##_t[1];                                                                                   \
    LOCAL_TYPE(name, struct name)

LOCAL_TYPE(fmpz, fmpz)
LOCAL_TYPE(fmpq, fmpq)
LOCAL_TYPE(fmpq_poly, fmpq_poly_struct)
LOCAL_TYPE(mag, mag_struct)
LOCAL_TYPE(arf, arf_struct)
LOCAL_TYPE(arb, arb_struct)
LOCAL_TYPE(acb, acb_struct)
LOCAL_TYPE(arb_poly, arb_poly_struct)
LOCAL_TYPE(acb_poly, acb_poly_struct)

#endif
