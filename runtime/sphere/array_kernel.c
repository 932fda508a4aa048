/* SPDX-License-Identifier: MIT */
/* Array functions of an impact speed, for one instruction set (sets.h). The loops of runtime/table/row_loops.h evaluate
 * the rows; the functions before and after them convert speeds and results as contact.c does. Speeds at which a product
 * might overflow (contact_parts.h) are computed one by one. */
#include "runtime/sphere/array.h"
#include "runtime/sphere/contact_parts.h"

struct call {
    const struct cor_contact_function *f;
    const struct cor_sphere_contact *contact;
    const double *speed;
    mask ordinary; /* true if nothing can overflow */
    double root[COR_ROW_BLOCK];
};

/* Sets x = beta^5, the product of scale and speed. Where this product might overflow, x is negative, which is outside
 * every table. */
static void eps_before(void *context, const double *in, double *x, size_t m)
{
    const struct call *const call = context;
    const double scale = call->contact->beta5_per_speed;
    const double limit = cor_inline_from_bits(cor_contact_speed_limit(scale));
    for (size_t j = 0; j < m; j++)
        x[j] = scale * choose_double(is_between(in[j], COR_SI_LEAST, limit), in[j], -1);
}

/* Beyond the rows in x, uses rows in beta = x^(1/5). Beyond the rows in beta, computes values one by one. */
static void eps_after(void *context, const struct cor_row_block *block, double *value)
{
    const struct call *const call = context;
    const struct cor_contact_function *const f = call->f;
    const double *const in = block->in, *const x = block->x, least = COR_INLINE_2_M900;
    double beta[COR_ROW_BLOCK], taken[COR_ROW_BLOCK], other[COR_ROW_BLOCK];
    for (size_t j = 0; j < block->m; j++) {
        /* x < 2^-900 is beta < 2^-180, where eps is 1 to the last bit */
        const mask small = is_between(x[j], 0, least), normal = is_between(x[j], least, COR_INLINE_2_900);
        const double root = cor_inline_fifth_root_normal(choose_double(normal, x[j], least));
        /* NaN is not below the end of the table; a negative speed may give x = -0 */
        beta[j] = choose_double((small | normal) & is_between(in[j], 0, cor_inline_infinity()), root, -1);
    }
    COR_OF_SET(cor_row_loops).block(f->beyond, beta, taken, other, block->m);
    for (size_t j = 0; j < block->m; j++) {
        if (is_same(x[j], block->taken[j]))
            continue;
        if (f->eps_far_root && is_between(x[j], f->table->end, COR_INLINE_2_900))
            value[j] = f->eps_far_root(x[j]);
        else
            value[j] = is_same(beta[j], taken[j]) ? other[j] : f->one(call->contact, in[j]);
    }
}

static mask is_ordinary_speed(const struct call *call, double speed)
{
    return is_between(speed, COR_SI_LEAST, COR_SI_MOST) & call->ordinary;
}

/* Sets x = beta, or -1 if the speed is not ordinary. */
static void beta_before(void *context, const double *in, double *x, size_t m)
{
    struct call *const call = context;
    for (size_t j = 0; j < m; j++) {
        const mask has = is_ordinary_speed(call, in[j]);
        const struct cor_inline_pair parts = cor_inline_fifth_root_parts(choose_double(has, in[j], 1));
        call->root[j] = parts.hi + parts.lo;
        x[j] = choose_double(has, cor_contact_beta_of_root(call->contact->beta_per_root, parts), -1);
    }
}

static void beta_after(void *context, const struct cor_row_block *block, double *value)
{
    const struct call *const call = context;
    const enum cor_contact_kind kind = call->f->kind;
    const double scale = call->contact->scale;
    for (size_t j = 0; kind == CONTACT_DURATION && j < block->m; j++)
        value[j] = cor_contact_duration_of(scale, call->root[j], value[j]);
    for (size_t j = 0; kind == CONTACT_OVERLAP && j < block->m; j++)
        value[j] = cor_contact_overlap_of(scale, call->root[j], value[j]);
    for (size_t j = 0; block->outside && j < block->m; j++)
        if (!is_same(block->x[j], block->taken[j]))
            value[j] = call->f->one(call->contact, block->in[j]);
}

static void dissipation_after(void *context, const struct cor_row_block *block, double *value)
{
    const struct call *const call = context;
    const double scale = call->contact->scale, *const speed = call->speed + block->i;
    mask all = mask_of(block->outside == 0);
    for (size_t j = 0; j < block->m; j++) {
        const mask has = is_ordinary_speed(call, speed[j]);
        const double root = cor_inline_fifth_root_normal(choose_double(has, speed[j], 1));
        value[j] = cor_contact_dissipation_of(choose_double(has, scale, 1), root, value[j]);
        all &= has;
    }
    for (size_t j = 0; !all && j < block->m; j++)
        if (!(is_ordinary_speed(call, speed[j]) & is_same(block->x[j], block->taken[j])))
            value[j] = call->f->of_eps(call->contact, speed[j], block->in[j]);
}

static void loop_contact(const struct cor_contact_function *f, const struct cor_sphere_contact *contact,
                         const double *speed, const double *eps, double *out, size_t n)
{
    const enum cor_contact_kind kind = f->kind;
    struct call call; /* not initialized, because `root` is a long array */
    call.f = f;
    call.contact = contact;
    call.speed = speed;
    call.ordinary = mask_of(cor_contact_is_ordinary(contact, kind != CONTACT_BETA));
    struct cor_row_call loop = {f->table, NULL, &call, beta_before, beta_after, kind != CONTACT_BETA};
    if (kind == CONTACT_EPS) {
        loop.before = eps_before;
        loop.after = eps_after;
        loop.always_after = 0;
    } else if (kind == CONTACT_DISSIPATION) {
        loop.before = NULL;
        loop.after = dissipation_after;
    }
    COR_OF_SET(cor_row_loops).doubles(&loop, kind == CONTACT_DISSIPATION ? eps : speed, out, n);
}

const struct cor_contact_loops COR_OF_SET(cor_contact_loops) = {loop_contact};
