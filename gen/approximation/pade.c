/* SPDX-License-Identifier: MIT */
#include <stdio.h>

#include "approximation/pade.h"

#include <stdlib.h>
#include <string.h>

#include "enclosure/collision.h"
#include "series/restitution.h"
#include "support/console.h"
#include "support/digits.h"
#include "support/local.h"

enum {
    TAIL_POWER = 5,      /* power of beta in eps -> h*^5/beta^5 at zero overlap; docs/theory.md, 4 */
    GUARD_BITS = 64,     /* more bits than requested */
    LOSS_PER_DEGREE = 5, /* first estimate of the bits that the solution of the system loses per degree */
    MOST_TIMES = 8,      /* ratio of the bits of the last attempt to the bits of the first */
    ROOT_BITS = 40,      /* relative bits of a printed root */
    PLACE_DIGITS = 8
};

/* Table I prints 2.5839, 3.5839 and 2.9839, but these a_k give 2.58401, 3.58401 and 2.98401. One unit in the last digit
 * of a_3 changes these numbers by 2.4e-4, because d_0 is near zero. */
const char *const published_a[4] = {"1", "3/5", "0.315119", "0.161167"};
const char *const published_d[5] = {"2.5839", "3.5839", "2.9839", "1.1487", "0.3265"};

void pade_init(struct pade *f)
{
    FOR_ALL(arb_poly, init, f->p, f->q);
    f->numerator = f->denominator = 0;
    f->root = 1;
    f->variable = "z";
}

void pade_clear(struct pade *f)
{
    FOR_ALL(arb_poly, clear, f->p, f->q);
}

/* Returns the coefficient c_k, and 0 for k < 0. The system's matrix contains such c_k if n > m. */
static void get_coefficient(arb_t x, const arb_poly_t c, slong k)
{
    if (k < 0)
        arb_zero(x);
    else
        arb_poly_get_coeff_arb(x, c, k);
}

/* Computes Q from n equations, i = first .. first+n-1. The right side of sum_j q_j c_{i-j} = ... is limit q_{i+5} if a
 * limit is given and i <= m, otherwise 0. */
static bool find_denominator(struct pade *f, const arb_poly_t c, slong first, slong m, slong n, arb_srcptr limit,
                             slong prec)
{
    LOCAL_MATRIX(n, n, a);
    LOCAL_MATRIX(n, 1, b, q);
    for (slong i = 0; i < n; i++) {
        for (slong j = 1; j <= n; j++)
            get_coefficient(arb_mat_entry(a, i, j - 1), c, first + i - j);
        if (limit && i <= m)
            arb_sub(arb_mat_entry(a, i, i + TAIL_POWER - 1), arb_mat_entry(a, i, i + TAIL_POWER - 1), limit, prec);
        get_coefficient(arb_mat_entry(b, i, 0), c, first + i);
        arb_neg(arb_mat_entry(b, i, 0), arb_mat_entry(b, i, 0));
    }
    const bool regular = n == 0 || arb_mat_solve(q, a, b, prec);
    arb_poly_one(f->q);
    for (slong j = 1; j <= n && regular; j++)
        arb_poly_set_coeff_arb(f->q, j, arb_mat_entry(q, j - 1, 0));
    f->numerator = m;
    f->denominator = n;
    return regular;
}

/* Solves the equations of find_denominator for i = m+1..m+n. P is then Q c up to z^m. */
bool pade_of_series(struct pade *f, const arb_poly_t c, slong m, slong n, slong prec)
{
    const bool regular = find_denominator(f, c, m + 1, m, n, NULL, prec);
    if (regular)
        arb_poly_mullow(f->p, f->q, c, m + 1, prec);
    return regular;
}

/* Solves the equations of find_denominator for i = 0..m+4. At infinity p_i = limit q_{i+5}, which eliminates p_i. */
bool pade_two_point_of_series(struct pade *f, const arb_poly_t c, const arb_t limit, slong m, slong prec)
{
    const bool regular = find_denominator(f, c, 0, m, m + TAIL_POWER, limit, prec);
    arb_poly_shift_right(f->p, f->q, TAIL_POWER);
    arb_poly_scalar_mul(f->p, f->p, limit, prec);
    return regular;
}

/* Finds the block due to an exact zero in the series of eps (power 1) or of 1/eps (power -1). With C_k = 0, [k/0] is
 * [k-1/0], so [k-1/0], [k/0] and [k-1/1] are one fraction and [k/1] does not exist. [0/k] of 1/eps is analogous. */
static bool known_block(struct pade_block *b, const struct pade_request *r)
{
    const struct ratio powers[2] = {{1, 1}, {-1, 1}};
    if (r->kind != PADE_ORDINARY || r->end != COR_END_ZERO_OVERLAP)
        return false;
    for (int i = 0; i < 2; i++) {
        const slong k = restitution_exact_zero(powers[i], &r->law);
        *b = (struct pade_block){.m = i == 0 ? k - 1 : 0, .n = i == 0 ? 0 : k - 1, .size = 2};
        if (k > 0 && r->numerator >= b->m && r->numerator <= b->m + 1 && r->denominator >= b->n &&
            r->denominator <= b->n + 1)
            return true;
    }
    return false;
}

/* True if the interval of det (c_{m+i-j}), i, j < n, contains 0, which happens for an inner entry of a block. */
static bool coefficient_vanishes(const arb_poly_t c, slong m, slong n, slong prec)
{
    if (n <= 0)
        return false;
    LOCAL(arb, det);
    LOCAL_MATRIX(n, n, a);
    for (slong i = 0; i < n; i++)
        for (slong j = 0; j < n; j++)
            get_coefficient(arb_mat_entry(a, i, j), c, m + i - j);
    arb_mat_det(det, a, prec);
    return arb_contains_zero(det);
}

/* Finds the block by one search along the row and one along the column. Vanishing determinants fill a square whose
 * upper left corner is the entry after the fraction's own degrees (Gragg 1972). */
bool pade_block_of(struct pade_block *b, const arb_poly_t c, slong m, slong n, slong prec)
{
    if (!coefficient_vanishes(c, m, n, prec))
        return false;
    const slong known = arb_poly_length(c) - 1;
    slong left = m, up = n, right = m;
    while (left > 0 && coefficient_vanishes(c, left - 1, n, prec))
        left--;
    while (up > 1 && coefficient_vanishes(c, m, up - 1, prec))
        up--;
    while (right + n <= known && coefficient_vanishes(c, right + 1, n, prec))
        right++;
    b->m = left - 1;
    b->n = up - 1;
    b->size = right - left + 2;
    b->open = right + n > known;
    return true;
}

void pade_analysis_init(struct pade_analysis *a)
{
    memset(a, 0, sizeof *a);
    a->root = 1;
    a->variable = "z";
}

void pade_analysis_clear(struct pade_analysis *a)
{
    _acb_vec_clear(a->poles.root, a->poles.count);
    _acb_vec_clear(a->zeros.root, a->zeros.count);
    for (slong i = 0; i < a->pairs; i++)
        arb_clear(a->pair[i].distance);
    free(a->pair);
    pade_analysis_init(a);
}

static bool on_positive_axis(const acb_t z)
{
    return acb_is_real(z) && arb_is_positive(acb_realref(z));
}

/* Isolates all roots of a real polynomial with a leading coefficient that is not 0. Returns false, without roots, if
 * they are not isolated. */
static bool isolate_roots(struct pade_roots *roots, const arb_poly_t real, slong prec)
{
    const slong degree = arb_poly_degree(real);
    if (degree < 0 || arb_contains_zero(arb_poly_get_coeff_ptr(real, degree)))
        return false;
    LOCAL(acb_poly, poly);
    acb_poly_set_arb_poly(poly, real);
    acb_ptr root = _acb_vec_init(degree);
    bool isolated = degree == 0;
    for (slong working = 2 * ROOT_BITS; !isolated; working *= 2) {
        const bool last = working >= prec;
        isolated = acb_poly_find_roots(root, poly, working > 2 * ROOT_BITS ? root : NULL, 0, last ? prec : working) ==
                       degree &&
                   acb_poly_validate_real_roots(root, poly, last ? prec : working);
        for (slong i = 0; i < degree && isolated; i++) {
            if (arb_contains_zero(acb_imagref(root + i)))
                arb_zero(acb_imagref(root + i));
            isolated = acb_rel_accuracy_bits(root + i) >= ROOT_BITS &&
                       !(acb_is_real(root + i) && arb_contains_zero(acb_realref(root + i)));
        }
        if (last)
            break;
    }
    if (!isolated) {
        _acb_vec_clear(root, degree);
        return false;
    }
    _acb_vec_sort_pretty(root, degree);
    *roots = (struct pade_roots){.root = root, .count = degree};
    for (slong i = 0; i < degree; i++)
        roots->positive += on_positive_axis(root + i);
    return true;
}

static void find_pairs(struct pade_analysis *a)
{
    const slong prec = 2 * ROOT_BITS;
    LOCAL(acb, ratio);
    LOCAL(arb, distance);
    a->pair = xmalloc((size_t)(a->poles.count * a->zeros.count + 1) * sizeof *a->pair);
    for (slong i = 0; i < a->poles.count; i++)
        for (slong j = 0; j < a->zeros.count; j++) {
            const acb_srcptr pole = a->poles.root + i, zero = a->zeros.root + j;
            const arb_srcptr re = acb_realref(pole), im = acb_imagref(pole);
            LET_COMPLEX(ratio, false, prec, "zero/pole - 1", zero, pole);
            acb_abs(distance, ratio, prec);
            if (HOLDS(prec, "distance*PADE_PAIR_DISTANCE > 1", distance, PADE_PAIR_DISTANCE))
                continue;
            struct pade_pair *pair = a->pair + a->pairs++;
            *pair = (struct pade_pair){.pole = i, .zero = j};
            arb_init(pair->distance);
            arb_set(pair->distance, distance);
            pair->spurious =
                !arb_is_negative(re) && !HOLDS(prec, "abs(im)*PADE_PAIR_SLOPE > re", im, PADE_PAIR_SLOPE, re);
            a->spurious += pair->spurious;
        }
}

bool pade_analyse(struct pade_analysis *a, const struct pade *f, slong prec)
{
    pade_analysis_clear(a);
    const bool poles = isolate_roots(&a->poles, f->q, prec), zeros = isolate_roots(&a->zeros, f->p, prec);
    a->root = f->root;
    a->variable = f->variable;
    if (poles && zeros)
        find_pairs(a);
    return poles && zeros;
}

/* Prints z^root, the value of the printed variable: "2.9", or "2.9 + 0.1 i". */
static void print_place(FILE *file, const struct pade_analysis *a, const acb_t z)
{
    LOCAL(acb, place);
    acb_pow_ui(place, z, (ulong)a->root, 2 * ROOT_BITS);
    const double re = ball_middle(acb_realref(place));
    const double im = ball_middle(acb_imagref(place));
    if (acb_is_real(z))
        fprintf(file, "%s = %.*g", a->variable, PLACE_DIGITS, re);
    else
        fprintf(file, "%s = %.*g %c %.*g i", a->variable, PLACE_DIGITS, re, im < 0 ? '-' : '+', PLACE_DIGITS,
                im < 0 ? -im : im);
}

static void print_pair(FILE *file, const struct pade_analysis *a, const struct pade_pair *pair)
{
    print_place(file, a, a->poles.root + pair->pole);
    fprintf(file, " (distance %.1e)", ball_middle(pair->distance));
}

static void print_positive(FILE *file, const struct pade_analysis *a, const struct pade_roots *roots)
{
    const char *separator = "";
    for (slong i = 0; i < roots->count; i++)
        if (on_positive_axis(roots->root + i)) {
            fputs(separator, file);
            print_place(file, a, roots->root + i);
            separator = ", ";
        }
}

char *pade_defects(const struct pade_analysis *a)
{
    if (a->poles.positive == 0 && a->zeros.positive == 0 && a->spurious == 0)
        return NULL;
    char *text;
    size_t size;
    const char *separator = "";
    FILE *file = open_memstream(&text, &size);
    if (!file)
        return xstrdup("out of memory");
    for (int i = 0; i < 2; i++) {
        const struct pade_roots *const roots = i == 0 ? &a->poles : &a->zeros;
        if (roots->positive == 0)
            continue;
        fprintf(file, "%sa %s at ", separator, i == 0 ? "pole" : "zero");
        print_positive(file, a, roots);
        separator = "; ";
    }
    for (slong i = 0; i < a->pairs; i++)
        if (a->pair[i].spurious) {
            fprintf(file, "%sa spurious pole-zero pair at ", separator);
            print_pair(file, a, a->pair + i);
            separator = "; ";
        }
    fclose(file);
    return text;
}

void pade_print_analysis(FILE *file, const struct pade_analysis *a, const char *prefix)
{
    for (int i = 0; i < 2; i++) {
        const struct pade_roots *const roots = i == 0 ? &a->poles : &a->zeros;
        fprintf(file, "%s%ss on %s > 0: ", prefix, i == 0 ? "pole" : "zero", a->variable);
        if (roots->positive)
            print_positive(file, a, roots);
        else
            fprintf(file, "none");
        fprintf(file, " (proved: %ld of %ld roots of the %s isolated)\n", (long)roots->count, (long)roots->count,
                i == 0 ? "denominator" : "numerator");
    }
    if (a->pairs == 0)
        fprintf(file, "%spole-zero pairs closer than 1/%d of their distance from 0: none\n", prefix,
                PADE_PAIR_DISTANCE);
    for (slong i = 0; i < a->pairs; i++) {
        fprintf(file, "%spole-zero pair at ", prefix);
        print_pair(file, a, a->pair + i);
        fprintf(file, a->pair[i].spurious ? ", near the positive axis: spurious\n"
                                          : ", away from the positive axis: harmless\n");
    }
}

static const char *end_name(enum cor_end end)
{
    return end == COR_END_ZERO_FORCE ? "zero force" : "zero overlap";
}

/* Sets the series (32), (33): 1 - a_1 x + a_2 x^2 - a_3 x^3 + a_4 x^4 with the printed a_k, then 0 as if a_5
 * vanished. */
static int published_series(arb_poly_t c, slong prec)
{
    LOCAL(fmpq, exact);
    LOCAL(arb, a);
    int status = 0;
    arb_poly_one(c);
    for (int k = 1; k <= 4; k++) {
        const char *text = published_a[k - 1];
        if (fmpq_set_str(exact, text, 10) == 0)
            arb_set_fmpq(a, exact, prec);
        else
            status |= arb_set_str(a, text, prec);
        if (k % 2)
            arb_neg(a, a);
        arb_poly_set_coeff_arb(c, k, a);
    }
    return status;
}

const char *pade_refusal(const struct pade_request *r)
{
    if (r->numerator < 0 || r->denominator < 0)
        return "the degrees of a Padé approximant must be 0 or more";
    if (r->kind == PADE_TWO_POINT && !law_is_sphere(&r->law))
        return "a two-point Padé approximant is known only for viscoelastic spheres; leave out --elastic and "
               "--damping";
    if (r->kind == PADE_TWO_POINT && r->end != COR_END_ZERO_OVERLAP)
        return "a two-point Padé approximant exists only at zero overlap, because eps at zero force has logarithms at "
               "large beta; write --end zero-overlap";
    if (r->kind == PADE_TWO_POINT && r->denominator != r->numerator + TAIL_POWER)
        return "a two-point Padé approximant needs --denominator = --numerator + 5, because eps is proportional to "
               "beta^-5 at large beta";
    if (r->kind == PADE_AS_PUBLISHED && (r->numerator != 1 || r->denominator != 4))
        return "the published Padé approximant is [1/4]; write --numerator 1 --denominator 4, or leave out both";
    return NULL;
}

/* Computes the approximant with prec bits. Returns 0 with *regular set, or 1 after a message. */
static int try_precision(struct pade *f, arb_poly_t c, bool *regular, const struct pade_request *r, slong prec)
{
    int status = 0;
    const slong m = r->numerator, n = r->denominator;
    f->root = 1;
    f->variable = "beta";
    switch (r->kind) {
    case PADE_ORDINARY:
        status = series_eps(c, &f->root, r->end, m + n, &r->law, prec);
        if (status)
            break;
        if (m > 0 || r->end != COR_END_ZERO_OVERLAP) {
            *regular = pade_of_series(f, c, m, n, prec);
            break;
        }
        /* use P = 1 and Q = the series of 1/eps. A zero in this series is known to be exact, but a linear system of
         * balls could not show this. */
        arb_poly_one(f->p);
        restitution_power(f->q, c, (struct ratio){-1, 1}, &r->law, n + 1, prec);
        _arb_poly_normalise(f->q);
        f->numerator = 0;
        f->denominator = n;
        *regular = true;
        break;
    case PADE_TWO_POINT: {
        LOCAL(arb, limit);
        status = series_eps(c, &f->root, r->end, m + TAIL_POWER - 1, &r->law, prec) || collision_h_star(limit, prec);
        arb_pow_ui(limit, limit, TAIL_POWER, prec);
        if (status == 0)
            *regular = pade_two_point_of_series(f, c, limit, m, prec);
        break;
    }
    case PADE_AS_PUBLISHED:
        f->variable = "x";
        status = published_series(c, prec);
        if (status == 0)
            *regular = pade_of_series(f, c, m, n, prec);
        break;
    }
    return status;
}

/* True if every coefficient has `bits` relative bits. Otherwise sets *power to the index of one that has fewer. */
static bool is_accurate(const arb_poly_t p, slong bits, slong *power)
{
    for (slong i = 0; i < arb_poly_length(p); i++) {
        arb_srcptr x = arb_poly_get_coeff_ptr(p, i);
        if (!arb_is_zero(x) && arb_rel_accuracy_bits(x) < bits) {
            *power = i;
            return false;
        }
    }
    return true;
}

/* Reports the degenerate entry and the reason. */
static int fail_in_block(const struct pade_request *r, const struct pade_block *b, const char *known)
{
    return fail(
        "[%ld/%ld] at %s is degenerate (%s): the approximants [%ld/%ld] to [%ld/%ld]%s are one fraction; use [%ld/%ld]",
        (long)r->numerator, (long)r->denominator, end_name(r->end), known, (long)b->m, (long)b->n,
        (long)(b->m + b->size - 1), (long)(b->n + b->size - 1), b->open ? " and beyond" : "", (long)b->m, (long)b->n);
}

static int fail_degenerate(const arb_poly_t c, const struct pade_request *r, slong prec)
{
    struct pade_block b;
    char known[64];
    if (r->kind == PADE_TWO_POINT || !pade_block_of(&b, c, r->numerator, r->denominator, prec))
        return fail("the equations of [%ld/%ld] at %s are singular to %ld bits; use other degrees", (long)r->numerator,
                    (long)r->denominator, end_name(r->end), (long)prec);
    snprintf(known, sizeof known, "to %ld bits", (long)prec);
    return fail_in_block(r, &b, known);
}

/* Returns the name of a part without `bits` accurate bits, or NULL. Sets *power for an inaccurate coefficient. */
static const char *pade_open(const struct pade *f, struct pade_analysis *a, slong bits, slong *power, slong prec)
{
    if (!is_accurate(f->p, bits, power))
        return "numerator";
    if (!is_accurate(f->q, bits, power))
        return "denominator";
    return a && !pade_analyse(a, f, prec) ? "roots" : NULL;
}

int pade_compute(struct pade *f, struct pade_analysis *a, const struct pade_request *r, slong bits)
{
    const char *why = pade_refusal(r);
    struct pade_block block;
    if (why)
        return fail("%s", why);
    if (known_block(&block, r)) {
        struct pade_request corner = *r;
        corner.numerator = block.m;
        corner.denominator = block.n;
        if (r->numerator > block.m && r->denominator > block.n)
            return fail_in_block(r, &block, "proved: docs/theory.md, 4");
        if (r->numerator > block.m || r->denominator > block.n) {
            const int status = pade_compute(f, a, &corner, bits);
            f->numerator = r->numerator;
            f->denominator = r->denominator;
            return status;
        }
    }

    const slong degrees = r->numerator + r->denominator;
    /* A truly degenerate entry never becomes regular: after a few doublings of the precision the block is reported. */
    const slong first = bits + LOSS_PER_DEGREE * degrees + GUARD_BITS;
    struct precision p = precision_doubling(first, MOST_TIMES * first);
    slong power = 0;
    const char *open = NULL;
    int status = 1;
    bool regular = false;
    LOCAL(arb_poly, c);
    do {
        status = try_precision(f, c, &regular, r, p.bits);
        if (status == 0 && regular)
            open = pade_open(f, a, bits, &power, p.bits);
    } while (status == 0 && (!regular || open) && precision_raise(&p));
    if (status == 0 && !regular)
        status = fail_degenerate(c, r, p.bits);
    else if (status == 0 && open && *open == 'r')
        status = fail("cannot isolate the poles and zeros of [%ld/%ld] with %ld bits; use lower degrees",
                      (long)r->numerator, (long)r->denominator, (long)p.bits);
    else if (status == 0 && open)
        status = fail("cannot prove digits of the coefficient of z^%ld in the %s of [%ld/%ld] with %ld bits: it may be "
                      "0; use other degrees",
                      (long)power, open, (long)r->numerator, (long)r->denominator, (long)p.bits);
    return status;
}
