/* SPDX-License-Identifier: MIT */
/* eps, 1 - eps and the inverse of laws for which eps has a closed form, from generated/closed_form_tables.h: rows of
 * (1 - eps)/x near x = 0, of eps by octaves of x, of x/(1 - eps) up to 1 - eps = 1/2, and of x by octaves of eps, where
 * x is zeta or beta. damping_ratio.h and hunt_crossley.h have the rest. The array functions read the same rows and give
 * the same bits. */
#ifndef COR_RUNTIME_LAW_CLOSED_FORM_H
#define COR_RUNTIME_LAW_CLOSED_FORM_H

#include "generated/closed_form_tables.h"
#include "runtime/law/damping_ratio.h"
#include "runtime/law/hunt_crossley.h"
#include "runtime/table/law.h"

/* FORM(law, public, x, end, LAW, X, END): the functions cor_<law>_eps<end>, ... below, whose public names are
 * cor_<public>_eps<end>, .... Tsuji's damping has those of the linear dashpot. */
#define COR_CLOSED_FORMS(FORM)                                                                                         \
    FORM(ratio, linear, zeta, _zero_overlap, RATIO, ZETA, _ZERO_OVERLAP)                                               \
    FORM(ratio, linear, zeta, _zero_force, RATIO, ZETA, _ZERO_FORCE)                                                   \
    FORM(ratio, linear, zeta, _approach_only, RATIO, ZETA, _APPROACH_ONLY)                                             \
    FORM(ratio, linear, zeta, _limited, RATIO, ZETA, _LIMITED)                                                         \
    FORM(crossley, hunt_crossley, beta, , CROSSLEY, BETA, )                                                            \
    FORM(crossley, hunt_crossley, beta, _approach_only, CROSSLEY, BETA, _APPROACH_ONLY)

/* The value of a table on a grid at y = head + tail, as a pair */
COR_INLINE struct cor_inline_pair cor_grid_value(struct cor_inline_grid grid, const double *(*rows)(int),
                                                 struct cor_inline_pair y)
{
    struct cor_inline_place place = cor_inline_grid_place(grid, y.hi, rows);
    place.t += y.lo;
    return cor_inline_sum(place.row[0], cor_inline_row(place));
}

/* One copy in a source: the public function jumps to it, and calls it in another environment. */
#ifdef __GNUC__
#define COR_ONCE static __attribute__((noinline, unused))
#else
#define COR_ONCE static inline
#endif

#define COR_CLOSED_FORM_FUNCTIONS_(law, public, damping, end, LAW, DAMPING, END)                                       \
    COR_ONCE double cor_##law##_eps##end(double x)                                                                     \
    {                                                                                                                  \
        if (cor_inline_between(x, COR_ROWS_##LAW##_EPS##END##_FIRST, COR_ROWS_##LAW##_EPS##END##_END))                 \
            return cor_inline_row_value(cor_inline_octaves_place(COR_INLINE_OCTAVES(COR_ROWS_##LAW##_EPS##END), x,     \
                                                                 cor_rows_##law##_eps##end));                          \
        if (cor_inline_below(x, COR_ROWS_##LAW##_LOSS##END##_END))                                                     \
            return 1 - cor_inline_row_product(cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_##LAW##_LOSS##END), x,    \
                                                                    cor_rows_##law##_loss##end),                       \
                                              x);                                                                      \
        return cor_##law##_eps_beyond##end(x);                                                                         \
    }                                                                                                                  \
    COR_ONCE double cor_##law##_loss##end(double x)                                                                    \
    {                                                                                                                  \
        if (cor_inline_below(x, COR_ROWS_##LAW##_LOSS##END##_END))                                                     \
            return cor_inline_law_product(                                                                             \
                cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_##LAW##_LOSS##END), x, cor_rows_##law##_loss##end), x); \
        if (cor_inline_between(x, COR_ROWS_##LAW##_EPS##END##_FIRST, COR_ROWS_##LAW##_EPS##END##_END)) {               \
            const struct cor_inline_place place =                                                                      \
                cor_inline_octaves_place(COR_INLINE_OCTAVES(COR_ROWS_##LAW##_EPS##END), x, cor_rows_##law##_eps##end); \
            const struct cor_inline_pair less = cor_pair_two_sum(1, -place.row[0]);                                    \
            return less.hi + (less.lo - cor_inline_row(place));                                                        \
        }                                                                                                              \
        return cor_##law##_loss_beyond##end(x);                                                                        \
    }                                                                                                                  \
    COR_INLINE double cor_##law##_near_##damping##end(double loss)                                                     \
    {                                                                                                                  \
        return cor_inline_law_product(cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_##LAW##_NEAR_##DAMPING##END),     \
                                                            loss, cor_rows_##law##_near_##damping##end),               \
                                      loss);                                                                           \
    }                                                                                                                  \
    COR_ONCE double cor_##law##_##damping##end(double eps)                                                             \
    {                                                                                                                  \
        if (eps >= 0.5 && eps <= 1)                                                                                    \
            return cor_##law##_near_##damping##end(1 - eps);                                                           \
        if (cor_inline_between(eps, COR_ROWS_##LAW##_##DAMPING##END##_FIRST, 0.5))                                     \
            return cor_inline_row_value(cor_inline_octaves_place(COR_INLINE_OCTAVES(COR_ROWS_##LAW##_##DAMPING##END),  \
                                                                 eps, cor_rows_##law##_##damping##end));               \
        return cor_##law##_##damping##_beyond##end(eps);                                                               \
    }                                                                                                                  \
    COR_ONCE double cor_##law##_##damping##_of_loss##end(double loss)                                                  \
    {                                                                                                                  \
        if (cor_inline_below(loss, 0.5))                                                                               \
            return cor_##law##_near_##damping##end(loss);                                                              \
        if (!(loss >= 0 && loss <= 1))                                                                                 \
            return (double)NAN;                                                                                        \
        return loss == 0 ? 0 : cor_##law##_##damping##end(1 - loss);                                                   \
    }
COR_CLOSED_FORMS(COR_CLOSED_FORM_FUNCTIONS_)

/* eps of Hunt and Crossley's law with damping during the approach only as a pair, -1 < beta < inf */
COR_INLINE struct cor_inline_pair cor_crossley_eps_approach_pair(double beta)
{
    if (cor_inline_between(beta, COR_ROWS_CROSSLEY_EPS_APPROACH_ONLY_FIRST, COR_ROWS_CROSSLEY_EPS_APPROACH_ONLY_END)) {
        const struct cor_inline_place place = cor_inline_octaves_place(
            COR_INLINE_OCTAVES(COR_ROWS_CROSSLEY_EPS_APPROACH_ONLY), beta, cor_rows_crossley_eps_approach_only);
        return cor_inline_sum(place.row[0], cor_inline_row(place));
    }
    if (cor_inline_below(beta, COR_ROWS_CROSSLEY_LOSS_APPROACH_ONLY_END)) {
        const struct cor_inline_place place = cor_inline_grid_place(
            COR_INLINE_GRID(COR_ROWS_CROSSLEY_LOSS_APPROACH_ONLY), beta, cor_rows_crossley_loss_approach_only);
        const double head = cor_inline_head(beta), tail = beta - head, c = place.row[0];
        const struct cor_inline_pair eps = cor_pair_two_sum(1, -(head * c)); /* an exact product */
        return cor_inline_sum(eps.hi, eps.lo - (tail * c + beta * cor_inline_row(place)));
    }
    return cor_hc_eps_approach_pair(beta);
}

#endif
