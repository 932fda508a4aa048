/* SPDX-License-Identifier: MIT */
#include "runtime/law/array.h"

#include "cor/law.h"
#include "runtime/number/environment.h"
#include "runtime/table/row_loops.h"

struct rows_function {
    struct cor_row_table table;
    double (*one)(double x);
    float (*onef)(float x);
};

/* A loss above 1/2 is computed one by one. */
#define FORM_(law, public, x, end, LAW, X, END)                                                                        \
    {COR_ROW_TABLE_OF_PARTS(cor_rows_##law##_loss##end, COR_ROWS_##LAW##_LOSS##END, cor_rows_##law##_eps##end,         \
                            COR_ROWS_##LAW##_EPS##END, COR_ROW_EPS, 0),                                                \
     cor_##public##_eps##end, cor_##public##_eps##end##f},                                                             \
        {COR_ROW_TABLE_OF_PARTS(cor_rows_##law##_loss##end, COR_ROWS_##LAW##_LOSS##END, cor_rows_##law##_eps##end,     \
                                COR_ROWS_##LAW##_EPS##END, COR_ROW_LOSS, COR_INLINE_2_M900),                           \
         cor_##public##_loss##end, cor_##public##_loss##end##f},                                                       \
        {COR_ROW_TABLE_OF_INVERSE(COR_ROW_INVERSE, cor_rows_##law##_near_##x##end, COR_ROWS_##LAW##_NEAR_##X##END,     \
                                  cor_rows_##law##_##x##end, COR_ROWS_##LAW##_##X##END),                               \
         cor_##public##_##x##end, cor_##public##_##x##end##f},                                                         \
        {COR_ROW_TABLE_OF_GRID(cor_rows_##law##_near_##x##end, COR_ROWS_##LAW##_NEAR_##X##END, COR_ROW_GRID,           \
                               COR_ROW_PRODUCT, COR_INLINE_2_M900, 0),                                                 \
         cor_##public##_##x##_of_loss##end, cor_##public##_##x##_of_loss##end##f},
static const struct rows_function functions[] = {COR_CLOSED_FORMS(FORM_)};

int cor_law_array_of_set(int set, enum cor_law_loop loop, const double *x, double *y, size_t n)
{
    if (!cor_processor_has(set))
        return 0;
    const struct cor_environment caller = cor_environment_enter();
    if (loop < COR_LAW_KERNELS) {
        cor_law_loops(set)->run(loop, x, y, n);
    } else {
        const struct rows_function *const f = &functions[loop - COR_LAW_KERNELS];
        const struct cor_row_call call = {&f->table, f->one, NULL, NULL, NULL, 0};
        cor_row_loops(set)->doubles(&call, x, y, n);
    }
    cor_environment_leave(&caller);
    return 1;
}

int cor_law_arrayf_of_set(int set, enum cor_law_loop loop, const float *x, float *y, size_t n)
{
    if (!cor_processor_has(set))
        return 0;
    const struct cor_environment caller = cor_environment_enter();
    if (loop < COR_LAW_KERNELS) {
        cor_law_loops(set)->run_floats(loop, x, y, n);
    } else {
        const struct rows_function *const f = &functions[loop - COR_LAW_KERNELS];
        cor_row_loops(set)->floats(&f->table, f->onef, NAN, x, y, n);
    }
    cor_environment_leave(&caller);
    return 1;
}
