/* SPDX-License-Identifier: MIT */
/* eps, 1 - eps and the inverse of laws for which eps has a closed form. With x for zeta or beta,
 * generated/closed_form_tables.h has rows of (1 - eps)/x near x = 0, and of eps by octaves of x. For the inverse it has
 * rows of x/(1 - eps) up to 1 - eps = 1/2, and of x by octaves of eps. damping_ratio.h and hunt_crossley.h have the
 * rest. The array functions use the same rows and give the same bits. */
#ifndef COR_RUNTIME_LAW_CLOSED_FORM_H
#define COR_RUNTIME_LAW_CLOSED_FORM_H

#include "generated/closed_form_tables.h"
#include "runtime/law/damping_ratio.h"
#include "runtime/law/functions.h"
#include "runtime/law/hunt_crossley.h"
#include "runtime/table/law.h"
#include "runtime/table/row_loops.h"

/* The scalar and the array function use the same tables. The functions ..._beyond are for arguments for which a table
 * has no row. */
struct cor_closed_form {
    struct cor_row_table eps, loss, damping_of_eps, damping_of_loss;
    double (*eps_beyond)(double x), (*loss_beyond)(double x), (*damping_beyond)(double eps);
};

/* The table damping_of_loss ends at 1/2; larger losses are computed one by one. */
#define FORM(law, x, end, LAW, X, END)                                                                                 \
    {                                                                                                                  \
        COR_ROW_TABLE_OF_PARTS(cor_rows_##law##_loss##end, COR_ROWS_##LAW##_LOSS##END, cor_rows_##law##_eps##end,      \
                               COR_ROWS_##LAW##_EPS##END, COR_ROW_EPS, 0),                                             \
            COR_ROW_TABLE_OF_PARTS(cor_rows_##law##_loss##end, COR_ROWS_##LAW##_LOSS##END, cor_rows_##law##_eps##end,  \
                                   COR_ROWS_##LAW##_EPS##END, COR_ROW_LOSS, COR_INLINE_2_M900),                        \
            COR_ROW_TABLE_OF_INVERSE(COR_ROW_INVERSE, cor_rows_##law##_near_##x##end, COR_ROWS_##LAW##_NEAR_##X##END,  \
                                     cor_rows_##law##_##x##end, COR_ROWS_##LAW##_##X##END),                            \
            COR_ROW_TABLE_OF_GRID(cor_rows_##law##_near_##x##end, COR_ROWS_##LAW##_NEAR_##X##END, COR_ROW_GRID,        \
                                  COR_ROW_PRODUCT, COR_INLINE_2_M900, 0),                                              \
            cor_##law##_eps_beyond##end, cor_##law##_loss_beyond##end, cor_##law##_##x##_beyond##end                   \
    }

static const struct cor_closed_form ratio_zero_overlap = FORM(ratio, zeta, _zero_overlap, RATIO, ZETA, _ZERO_OVERLAP),
                                    ratio_zero_force = FORM(ratio, zeta, _zero_force, RATIO, ZETA, _ZERO_FORCE),
                                    ratio_limited = FORM(ratio, zeta, _limited, RATIO, ZETA, _LIMITED),
                                    ratio_approach_only =
                                        FORM(ratio, zeta, _approach_only, RATIO, ZETA, _APPROACH_ONLY),
                                    crossley_ends = FORM(crossley, beta, , CROSSLEY, BETA, ),
                                    crossley_approach_only =
                                        FORM(crossley, beta, _approach_only, CROSSLEY, BETA, _APPROACH_ONLY);

/* The functions below must be inlined, so that the form is a constant of each caller. */

COR_KERNEL double closed_eps(const struct cor_closed_form *form, double x)
{
    const struct cor_row_table *const rows = &form->eps;
    if (cor_inline_between(x, rows->octaves.first, rows->middle_end))
        return cor_inline_row_value(cor_row_middle(rows, x));
    if (cor_inline_below(x, rows->near_end))
        return 1 - cor_inline_row_product(cor_row_near(rows, x), x);
    return form->eps_beyond(x);
}

COR_KERNEL double closed_loss(const struct cor_closed_form *form, double x)
{
    const struct cor_row_table *const rows = &form->loss;
    if (cor_inline_below(x, rows->near_end))
        return cor_inline_law_product(cor_row_near(rows, x), x);
    if (cor_inline_between(x, rows->octaves.first, rows->middle_end)) {
        const struct cor_inline_place place = cor_row_middle(rows, x);
        const struct cor_inline_pair less = cor_pair_two_sum(1, -place.row[0]);
        return less.hi + (less.lo - cor_inline_row(place));
    }
    return form->loss_beyond(x);
}

COR_KERNEL double closed_damping_of_eps(const struct cor_closed_form *form, double eps)
{
    const struct cor_row_table *const rows = &form->damping_of_eps;
    if (eps >= 0.5 && eps <= 1)
        return cor_inline_law_product(cor_row_near(rows, 1 - eps), 1 - eps);
    if (cor_inline_between(eps, rows->octaves.first, 0.5))
        return cor_inline_row_value(cor_row_middle(rows, eps));
    return form->damping_beyond(eps);
}

COR_KERNEL double closed_damping_of_loss(const struct cor_closed_form *form, double loss)
{
    if (cor_inline_below(loss, 0.5))
        return cor_inline_law_product(cor_row_near(&form->damping_of_loss, loss), loss);
    if (!(loss >= 0 && loss <= 1))
        return (double)NAN;
    return loss == 0 ? 0 : closed_damping_of_eps(form, 1 - loss);
}

COR_KERNEL double closed_formula(const struct cor_closed_form *form, enum cor_quantity quantity, double x)
{
    return quantity == COR_EPS              ? closed_eps(form, x)
           : quantity == COR_LOSS           ? closed_loss(form, x)
           : quantity == COR_DAMPING_OF_EPS ? closed_damping_of_eps(form, x)
                                            : closed_damping_of_loss(form, x);
}

/* Attribute of functions for rare arguments, which must not be inlined */
#ifdef __GNUC__
#define CLOSED_COLD static __attribute__((noinline, unused))
#else
#define CLOSED_COLD static inline
#endif

/* Computes a quantity in the default environment. environment.h explains the volatile operands. */
CLOSED_COLD double closed_anywhere(const struct cor_closed_form *form, enum cor_quantity quantity, double x)
{
    const struct cor_environment caller = cor_environment_enter();
    const volatile double at = x, value = closed_formula(form, quantity, at);
    cor_environment_leave(&caller);
    return value;
}

COR_KERNEL double closed_value(const struct cor_closed_form *form, enum cor_quantity quantity, double x)
{
    return law_is_ordinary(x) ? closed_formula(form, quantity, x) : closed_anywhere(form, quantity, x);
}

/* Returns the damping of a loss. inverse: the damping of an eps; it is called for losses of 1/2 or more. */
COR_KERNEL double closed_value_of_loss(const struct cor_closed_form *form, double (*inverse)(double eps), double loss)
{
    if (!law_is_ordinary(loss))
        return closed_anywhere(form, COR_DAMPING_OF_LOSS, loss);
    if (cor_inline_below(loss, 0.5))
        return cor_inline_row_product(cor_row_near(&form->damping_of_loss, loss), loss);
    return loss >= 0.5 && loss <= 1 ? inverse(1 - loss) : (double)NAN;
}

/* Returns the value of a table on a grid. Argument y and result are pairs. */
COR_INLINE struct cor_inline_pair cor_grid_value(struct cor_inline_grid grid, const double *(*rows)(int),
                                                 struct cor_inline_pair y)
{
    struct cor_inline_place place = cor_inline_grid_place(grid, y.hi, rows);
    place.t += y.lo;
    return cor_inline_sum(place.row[0], cor_inline_row(place));
}

/* Returns eps of Hunt and Crossley's law with damping during the approach only, as a pair, -1 < beta < inf. */
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
