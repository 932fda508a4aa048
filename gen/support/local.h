/* SPDX-License-Identifier: MIT */
/* Local variables of FLINT's types:
 *
 *     LOCAL(arb, x, y);
 *
 * declares arb_t x, y, initialised. They are cleared on every way out of their block, after the value of a return has
 * been computed (the attribute `cleanup` of gcc and clang). For members of a structure:
 *
 *     FOR_ALL(arb, init, s->x, s->y);    FOR_ALL(arb, clear, s->x, s->y);
 *
 * LOCAL_MATRIX(rows, columns, a, b) declares matrices, and LOCAL_VECTOR(x, n) a vector. LOCAL_STRUCT and LOCAL_FROM do
 * the same for structures. */
#ifndef COR_GEN_SUPPORT_LOCAL_H
#define COR_GEN_SUPPORT_LOCAL_H

#include <stdbool.h>

#include "support/flint.h"

#define LOCAL(type, ...) LOCAL_FROM(type, type##_local(), __VA_ARGS__)
#define LOCAL_MATRIX(rows, columns, ...) LOCAL_FROM(arb_mat, arb_mat_local(rows, columns), __VA_ARGS__)

/* Declares an arb_ptr to n numbers. */
#define LOCAL_VECTOR(x, n)                                                                                             \
    __attribute__((cleanup(arb_vector_clear))) const struct arb_vector x##_vector = {_arb_vec_init(n), n};             \
    arb_ptr x = x##_vector.entry

/* Declares x as a struct `name`, which name_init(arguments) initialises and name_clear clears: LOCAL_INIT(taylor, y,
 * (&y, law, prec)) */
#define LOCAL_INIT(name, x, arguments)                                                                                 \
    __attribute__((cleanup(name##_clear))) struct name x;                                                              \
    name##_init arguments

#define LOCAL_FROM(type, value, ...)                                                                                   \
    __attribute__((cleanup(type##_local_clear))) type##_t LOCAL_OF(__VA_ARGS__, 9, 8, 7, 6, 5, 4, 3, 2, 1,             \
                                                                   0)(value, __VA_ARGS__)

/* LOCAL_n declares n variables, n <= 9. */
#define LOCAL_OF(a, b, c, d, e, f, g, h, i, n, ...) LOCAL_##n
#define LOCAL_1(value, x) x = {value}
#define LOCAL_2(value, x, ...) LOCAL_1(value, x), LOCAL_1(value, __VA_ARGS__)
#define LOCAL_3(value, x, ...) LOCAL_1(value, x), LOCAL_2(value, __VA_ARGS__)
#define LOCAL_4(value, x, ...) LOCAL_1(value, x), LOCAL_3(value, __VA_ARGS__)
#define LOCAL_5(value, x, ...) LOCAL_1(value, x), LOCAL_4(value, __VA_ARGS__)
#define LOCAL_6(value, x, ...) LOCAL_1(value, x), LOCAL_5(value, __VA_ARGS__)
#define LOCAL_7(value, x, ...) LOCAL_1(value, x), LOCAL_6(value, __VA_ARGS__)
#define LOCAL_8(value, x, ...) LOCAL_1(value, x), LOCAL_7(value, __VA_ARGS__)
#define LOCAL_9(value, x, ...) LOCAL_1(value, x), LOCAL_8(value, __VA_ARGS__)

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
        type##_struct *const all_[] = {__VA_ARGS__, NULL};                                                             \
        for (type##_struct *const *one_ = all_; *one_; one_++)                                                         \
            type##_##action(*one_);                                                                                    \
    } while (0)

/* Defines LOCAL(name, x) for a struct `name` that has name_init and name_clear. */
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

/* Return the double nearest to the middle of a ball x, an upper bound of |x|, and upper and lower bounds of x. */
static inline double ball_middle(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}
static inline double ball_magnitude(const arb_t x)
{
    LOCAL(mag, m);
    arb_get_mag(m, x);
    return mag_get_d(m);
}
static inline double ball_end(const arb_t x, bool above)
{
    LOCAL(arf, end);
    (above ? arb_get_ubound_arf : arb_get_lbound_arf)(end, x, 64);
    return arf_get_d(end, above ? ARF_RND_CEIL : ARF_RND_FLOOR);
}

struct arb_vector {
    arb_ptr entry;
    slong length;
};
static inline void arb_vector_clear(const struct arb_vector *x)
{
    _arb_vec_clear(x->entry, x->length);
}
static inline arb_mat_struct arb_mat_local(slong rows, slong columns)
{
    arb_mat_t x;
    arb_mat_init(x, rows, columns);
    return *x;
}
static inline void arb_mat_local_clear(arb_mat_t *x)
{
    arb_mat_clear(*x);
}

#endif
