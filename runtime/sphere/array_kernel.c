/* SPDX-License-Identifier: MIT */
/* Array functions of the sphere, of beta, eps or an impact speed, by the loops of runtime/table/row_lanes.h, for
 * one instruction set (sets.h). */
#include <stddef.h>

#include "cor/sphere.h"
#include "runtime/sphere/array.h"
#include "runtime/sphere/contact_parts.h"
#include "runtime/sphere/eval.h"
#include "runtime/sphere/fast_float.h"
#include "runtime/table/row_lanes.h"

/* ---- tables in beta and in its root: the first loop ---- */

struct table {
    const double *rows;
    struct cor_inline_grid grid;
    double least, end; /* the table covers 0 and least <= beta < end */
    int root, plain;   /* whether the variable is sqrt(beta); number of rows with s = t */
    struct form form;
};

KERNEL mask table_has(const struct table *table, double beta)
{
    return holds(beta, table->least, table->end) | is_same(beta, 0);
}

/* Returns whether a number lies outside the table; such a number gets the row of 0. */
KERNEL mask table_reduce(struct reduced *r, const struct table *table, const double *in, int count)
{
    const struct cor_inline_grid grid = table->grid;
    mask outside = 0;
    for (int j = 0; j < count; j++) {
        const mask has = table_has(table, in[j]);
        const double beta = choose(has, in[j], 0), y = table->root ? sqrt(beta) : beta;
        const int i = cor_inline_grid_row(grid, y);
        const double node = cor_inline_grid_node(grid, i), t = y - node;
        outside |= ~has;
        r->row[j] = address_of(table->rows, (uint64_t)i);
        r->t[j] = t;
        if (table->form.has_s)
            r->s[j] = choose(mask_of(node < table->plain * grid.step), t, beta - node * node);
        if (table->form.has_m)
            r->m[j] = beta;
    }
    return outside;
}

/* ---- arrays of beta and of eps ---- */

KERNEL void from_beta(const double *in, double *out, size_t n, const struct table *table, scalar *one)
{
    const int stream = streams(out, n);
    for (size_t i = 0, m; i < n; i += m) {
        double from[BLOCK], value[BLOCK];
        struct reduced r;
        m = block_length(out, i, n, stream);
        look_ahead(in, i, n, stream);
        const int count = block_read(from, in + i, m);
        const mask outside = table_reduce(&r, table, from, count);
        block_evaluate(out + i, value, &r, table->form, m, count, !outside, stream);
        if (!outside)
            continue;
        for (size_t j = 0; j < m; j++)
            out[i + j] = table_has(table, from[j]) ? value[j] : one(from[j]);
    }
    end_streaming(stream);
}

#define TABLE(quantity, NAME, least, root, plain, form)                                                                \
    {                                                                                                                  \
        cor_rows_##quantity(0), COR_INLINE_GRID(COR_ROWS_##NAME), least, COR_ROWS_##NAME##_END, root, plain, form      \
    }

KERNEL struct table table_eps_zero_overlap(void)
{
    const struct table table = TABLE(eps_zero_overlap, EPS_ZERO_OVERLAP, 0, 0, 0, form_plain);
    return table;
}

KERNEL struct table table_eps_zero_force(void)
{
    const struct table table = TABLE(eps_zero_force, EPS_ZERO_FORCE, 0, 1, COR_ROWS_EPS_ZERO_FORCE_PLAIN_ROWS, form_s);
    return table;
}

KERNEL struct table table_loss_zero_overlap(void)
{
    const struct table table = TABLE(loss_zero_overlap, LOSS_ZERO_OVERLAP, COR_INLINE_2_M900, 0, 0, form_m);
    return table;
}

KERNEL struct table table_loss_zero_force(void)
{
    const struct table table =
        TABLE(loss_zero_force, LOSS_ZERO_FORCE, COR_INLINE_2_M900, 1, COR_ROWS_LOSS_ZERO_FORCE_PLAIN_ROWS, form_s_m);
    return table;
}

KERNEL struct table table_duration_zero_overlap(void)
{
    const struct table table = TABLE(duration_zero_overlap, DURATION_ZERO_OVERLAP, 0, 0, 0, form_plain);
    return table;
}

KERNEL struct table table_duration_zero_force(void)
{
    const struct table table = TABLE(duration_zero_force, DURATION_ZERO_FORCE, 0, 1, 0, form_plain);
    return table;
}

KERNEL struct table table_max_overlap(void)
{
    const struct table table = TABLE(max_overlap, MAX_OVERLAP, 0, 0, 0, form_plain);
    return table;
}

KERNEL struct table table_time_of_max_overlap(void)
{
    const struct table table = TABLE(time_of_max_overlap, TIME_OF_MAX_OVERLAP, 0, 0, 0, form_plain);
    return table;
}

KERNEL struct table table_eps_approach_only(void)
{
    const struct table table = TABLE(eps_approach_only, EPS_APPROACH_ONLY, 0, 0, 0, form_plain);
    return table;
}

KERNEL struct table table_loss_approach_only(void)
{
    const struct table table = TABLE(loss_approach_only, LOSS_APPROACH_ONLY, COR_INLINE_2_M900, 0, 0, form_m);
    return table;
}

KERNEL struct table table_duration_approach_only(void)
{
    const struct table table = TABLE(duration_approach_only, DURATION_APPROACH_ONLY, 0, 0, 0, form_plain);
    return table;
}

#define INVERSE_TABLE(end, END, root)                                                                                  \
    {                                                                                                                  \
        cor_rows_near_beta_##end(0), cor_rows_beta_##end(0), COR_INLINE_GRID(COR_ROWS_NEAR_BETA_##END),                \
            COR_INLINE_OCTAVES(COR_ROWS_BETA_##END), root                                                              \
    }

KERNEL struct inverse_table table_beta_zero_overlap(void)
{
    const struct inverse_table table = INVERSE_TABLE(zero_overlap, ZERO_OVERLAP, 0);
    return table;
}

KERNEL struct inverse_table table_beta_zero_force(void)
{
    const struct inverse_table table = INVERSE_TABLE(zero_force, ZERO_FORCE, 1);
    return table;
}

KERNEL struct inverse_table table_beta_approach_only(void)
{
    const struct inverse_table table = INVERSE_TABLE(approach_only, APPROACH_ONLY, 0);
    return table;
}

/* ---- eps of impact speeds ---- */

/* Tables and functions of one end of contact */
struct end {
    const double *power_rows;
    struct cor_inline_octaves power_grid;
    double power_end;
    struct table table;               /* in beta */
    double (*eps_far_root)(double x); /* beyond the table; or NULL */
    double (*contact_eps)(const struct cor_sphere_contact *contact, double speed);
};

/* Uses the rows in x = scale speed = beta^5. Beyond them it uses the rows in the fifth root of x; numbers beyond these
 * it computes one by one. */
KERNEL void eps_from_speed(const struct cor_sphere_contact *contact, const double *in, double *out, size_t n,
                           const struct end *end)
{
    const double scale = contact->beta5_per_speed, least = COR_INLINE_2_M900;
    const uint64_t limit = cor_contact_speed_limit(scale);
    const int stream = streams(out, n);
    for (size_t i = 0, m; i < n; i += m) {
        double from[BLOCK], x[BLOCK], beta[BLOCK], eps[BLOCK], other[BLOCK];
        struct reduced r;
        mask beyond = 0, within = 0;
        m = block_length(out, i, n, stream);
        look_ahead(in, i, n, stream);
        const int count = block_read(from, in + i, m);
        for (int j = 0; j < count; j++) {
            /* -1 is outside every table, and its product cannot overflow as that of a large speed could */
            x[j] = scale * choose(mask_of((int64_t)cor_inline_bits(from[j]) < (int64_t)limit), from[j], -1);
            const mask inside = holds(x[j], end->power_grid.first, end->power_end);
            beyond |= ~inside;
            within |= inside;
            const double y = choose(inside, x[j], end->power_grid.first);
            r.row[j] = address_of(end->power_rows, cor_inline_octaves_row(end->power_grid, y));
            r.t[j] = cor_inline_octaves_t(end->power_grid, y);
        }
        if (within)
            block_evaluate(out + i, eps, &r, form_plain, m, count, !beyond, stream);
        if (!beyond)
            continue;
        for (int j = 0; j < count; j++) {
            /* below 2^-180 eps is 1 to the last bit */
            const mask small = holds(x[j], 0, least), normal = holds(x[j], least, COR_INLINE_2_900);
            const double root = cor_inline_fifth_root_normal(choose(normal, x[j], least));
            /* NaN is not below the end of the table; a negative speed may give x = -0 */
            beta[j] = choose((small | normal) & holds(from[j], 0, cor_inline_infinity()), root, -1);
        }
        table_reduce(&r, &end->table, beta, count);
        evaluate(other, &r, end->table.form, count);
        for (size_t j = 0; j < m; j++) {
            if (holds(x[j], end->power_grid.first, end->power_end))
                out[i + j] = eps[j];
            else if (end->eps_far_root && holds(x[j], end->power_end, COR_INLINE_2_900))
                out[i + j] = end->eps_far_root(x[j]);
            else if (table_has(&end->table, beta[j]))
                out[i + j] = other[j];
            else
                out[i + j] = end->contact_eps(contact, from[j]);
        }
    }
    end_streaming(stream);
}

#define END_OF_CONTACT(end, END, eps_far_root)                                                                         \
    {                                                                                                                  \
        cor_rows_power_eps_zero_##end(0), COR_INLINE_OCTAVES(COR_ROWS_POWER_EPS_ZERO_##END),                           \
            COR_ROWS_POWER_EPS_ZERO_##END##_END, table_eps_zero_##end(), eps_far_root, cor_contact_eps_zero_##end      \
    }

/* ---- beta, times and overlaps of impact speeds ---- */

enum contact_quantity { CONTACT_BETA, CONTACT_DURATION, CONTACT_OVERLAP };

typedef double contact_scalar(const struct cor_sphere_contact *contact, double speed);

/* The operations of contact.c, for speeds at which nothing can overflow (contact_parts.h) */
KERNEL void from_speed(const struct cor_sphere_contact *contact, const double *in, double *out, size_t n,
                       enum contact_quantity quantity, const struct table *table, contact_scalar *one)
{
    const mask ordinary = mask_of(cor_contact_is_ordinary(contact, quantity != CONTACT_BETA));
    for (size_t i = 0, m; i < n; i += m) {
        double from[BLOCK], root[BLOCK], beta[BLOCK], value[BLOCK];
        struct reduced r;
        m = n - i < BLOCK ? n - i : BLOCK;
        const int count = block_read(from, in + i, m);
        for (int j = 0; j < count; j++) {
            const mask has = holds(from[j], COR_CONTACT_LEAST_SPEED, COR_CONTACT_MOST_SPEED) & ordinary;
            const struct cor_inline_pair parts = cor_inline_fifth_root_parts(choose(has, from[j], 1));
            root[j] = parts.hi + parts.lo;
            beta[j] = choose(has, cor_contact_beta_of_root(contact->beta_per_root, parts), -1);
        }
        if (quantity == CONTACT_BETA) {
            memcpy(value, beta, sizeof value);
        } else {
            table_reduce(&r, table, beta, count);
            evaluate(value, &r, table->form, count);
        }
        for (int j = 0; j < count && quantity != CONTACT_BETA; j++)
            value[j] = quantity == CONTACT_DURATION ? cor_contact_duration_of(contact->scale, root[j], value[j])
                                                    : cor_contact_overlap_of(contact->scale, root[j], value[j]);
        for (size_t j = 0; j < m; j++) {
            const mask has =
                quantity == CONTACT_BETA ? holds(beta[j], 0, cor_inline_infinity()) : table_has(table, beta[j]);
            out[i + j] = has ? value[j] : one(contact, from[j]);
        }
    }
}

typedef double dissipation_scalar(const struct cor_sphere_contact *contact, double speed, double eps);

KERNEL void dissipation_from_eps(const struct cor_sphere_contact *contact, const double *speed, const double *eps,
                                 double *out, size_t n, const struct inverse_table *table, dissipation_scalar *one)
{
    const mask ordinary = mask_of(cor_contact_is_ordinary(contact, 1));
    for (size_t i = 0, m; i < n; i += m) {
        double from[BLOCK], of[BLOCK], value[BLOCK];
        struct reduced r;
        m = n - i < BLOCK ? n - i : BLOCK;
        const int count = block_read(from, speed + i, m);
        block_read(of, eps + i, m);
        inverse_reduce(&r, table, of, count);
        evaluate(value, &r, form_m, count);
        for (int j = 0; j < count; j++) {
            const mask has = holds(from[j], COR_CONTACT_LEAST_SPEED, COR_CONTACT_MOST_SPEED) & ordinary;
            const double root = cor_inline_fifth_root_normal(choose(has, from[j], 1));
            value[j] = cor_contact_dissipation_of(choose(has, contact->scale, 1), root, value[j]);
        }
        for (size_t j = 0; j < m; j++) {
            const mask has = holds(from[j], COR_CONTACT_LEAST_SPEED, COR_CONTACT_MOST_SPEED) & ordinary;
            out[i + j] = has && inverse_has(table, of[j]) ? value[j] : one(contact, from[j], of[j]);
        }
    }
}

/* ---- the functions of a set ---- */

#define ARRAY_OF_FLOATS(quantity)                                                                                      \
    static void float_##quantity(const float *in, float *out, size_t n)                                                \
    {                                                                                                                  \
        const struct float_table table = float_table_##quantity();                                                     \
        floats_from_beta(in, out, n, &table, cor_sphere_##quantity##f);                                                \
    }
COR_FLOAT_QUANTITIES(ARRAY_OF_FLOATS)

#define ARRAY_FROM_BETA(quantity)                                                                                      \
    static void array_##quantity(const double *in, double *out, size_t n)                                              \
    {                                                                                                                  \
        const struct table table = table_##quantity();                                                                 \
        from_beta(in, out, n, &table, cor_sphere_##quantity);                                                          \
    }
#define ARRAY_FROM_EPS(quantity)                                                                                       \
    static void array_##quantity(const double *in, double *out, size_t n)                                              \
    {                                                                                                                  \
        const struct inverse_table table = table_##quantity();                                                         \
        from_eps(in, out, n, &table, cor_sphere_##quantity);                                                           \
    }
#define ARRAY_EPS_FROM_SPEED(end_name, END, eps_far_root)                                                              \
    static void contact_eps_zero_##end_name(const struct cor_sphere_contact *contact, const double *in, double *out,   \
                                            size_t n)                                                                  \
    {                                                                                                                  \
        const struct end end = END_OF_CONTACT(end_name, END, eps_far_root);                                            \
        eps_from_speed(contact, in, out, n, &end);                                                                     \
    }
#define ARRAY_FROM_SPEED(quantity, kind, of)                                                                           \
    static void contact_##quantity(const struct cor_sphere_contact *contact, const double *in, double *out, size_t n)  \
    {                                                                                                                  \
        const struct table table = table_##of();                                                                       \
        from_speed(contact, in, out, n, kind, &table, cor_contact_##quantity);                                         \
    }
#define ARRAY_DISSIPATION(end)                                                                                         \
    static void contact_dissipation_time_s_zero_##end(const struct cor_sphere_contact *contact, const double *speed,   \
                                                      const double *eps, double *out, size_t n)                        \
    {                                                                                                                  \
        const struct inverse_table table = table_beta_zero_##end();                                                    \
        dissipation_from_eps(contact, speed, eps, out, n, &table, cor_contact_dissipation_time_s_zero_##end);          \
    }

ARRAY_FROM_BETA(eps_zero_overlap)
ARRAY_FROM_BETA(eps_zero_force)
ARRAY_FROM_BETA(loss_zero_overlap)
ARRAY_FROM_BETA(loss_zero_force)
ARRAY_FROM_BETA(duration_zero_overlap)
ARRAY_FROM_BETA(duration_zero_force)
ARRAY_FROM_BETA(max_overlap)
ARRAY_FROM_BETA(time_of_max_overlap)
ARRAY_FROM_BETA(eps_approach_only)
ARRAY_FROM_BETA(loss_approach_only)
ARRAY_FROM_BETA(duration_approach_only)
ARRAY_FROM_EPS(beta_approach_only)
ARRAY_FROM_EPS(beta_zero_overlap)
ARRAY_FROM_EPS(beta_zero_force)
ARRAY_EPS_FROM_SPEED(overlap, OVERLAP, cor_inline_eps_overlap_far_root)
ARRAY_EPS_FROM_SPEED(force, FORCE, NULL)
ARRAY_FROM_SPEED(beta, CONTACT_BETA, eps_zero_overlap)
ARRAY_FROM_SPEED(duration_s_zero_overlap, CONTACT_DURATION, duration_zero_overlap)
ARRAY_FROM_SPEED(duration_s_zero_force, CONTACT_DURATION, duration_zero_force)
ARRAY_FROM_SPEED(max_overlap_m, CONTACT_OVERLAP, max_overlap)
ARRAY_DISSIPATION(overlap)
ARRAY_DISSIPATION(force)

#define ARRAY_SPHERE_ENTRY(quantity) array_##quantity,
#define ARRAY_FLOAT_ENTRY(quantity) float_##quantity,
#define ARRAY_CONTACT_ENTRY(quantity) contact_##quantity,
const struct cor_array_set COR_OF_SET(cor_array) = {
    COR_SET_NAME, COR_SPHERE_QUANTITIES(ARRAY_SPHERE_ENTRY) COR_FLOAT_QUANTITIES(ARRAY_FLOAT_ENTRY)
                      COR_CONTACT_QUANTITIES(ARRAY_CONTACT_ENTRY) COR_DISSIPATION_QUANTITIES(ARRAY_CONTACT_ENTRY)};
