/* SPDX-License-Identifier: MIT */
#include "embed/form.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "approximation/pade.h"
#include "enclosure/collision.h"
#include "support/console.h"
#include "support/local.h"
#include "support/parallel.h"

enum {
    COARSE = 64, /* the first assessment of a form uses every COARSE-th sample */
    POLYNOMIAL_MAX = 24,
    RATIONAL_MAX = 40, /* largest sum of degrees */
    PADE_MAX = 40,
    PADE_SKEW = 6, /* largest difference of the degrees of denominator and numerator */
    PIECE_DEGREE_MAX = 9,
    LARGE_PIECE_DEGREE_MAX = 11, /* largest degree of pieces in large tables */
    FRACTION_BITS_MAX = 8,
    ROWS_MAX = 256
};

/* Fraction of the tolerance for the error at the samples, because the error between them may be slightly larger. */
static const double margin = 0.97;

static struct embed_form form_blank(const struct embed_scene *s, enum embed_family family, enum embed_variable variable,
                                    slong numerator, slong denominator)
{
    struct embed_form f = {.family = family,
                           .variable = variable,
                           .numerator = numerator,
                           .denominator = denominator,
                           .single = s->single,
                           .onset = s->onset,
                           .before = s->pressed ? 0 : 1,
                           .origin = s->origin,
                           .speed_min = s->speed_min,
                           .speed_max = s->speed_max};
    if (variable >= FIFTH_ROOT_OF_SPEED) /* use the coarsest fifth root that the tolerance permits */
        while (f.refinement < EMBED_REFINEMENTS - 1 &&
               8 * s->slope * embed_root_error(f.refinement, s->single) > s->tolerance)
            f.refinement++;
    snprintf(f.why, sizeof f.why, "none of the degrees tried meets the tolerance");
    return f;
}

static double balanced_cost(const struct embed_form *f)
{
    return embed_cost(f->cost, PURPOSE_BALANCED);
}

/* Fits a form, or converts a quotient in beta^(1/series_root) to a form. If the form meets the tolerance and costs less
 * than *best, stores it there. True if the form meets the tolerance. */
static bool try_form(struct embed_form *best, struct embed_form f, const struct embed_scene *s,
                     const struct pade *quotient)
{
    f.found = quotient     ? embed_fit_quotient(&f, s, quotient->p, quotient->q)
              : f.rows > 0 ? embed_fit_pieces(&f, s)
                           : embed_fit_rational(&f, s);
    for (slong stride = COARSE; f.found && stride >= 1; stride /= COARSE) {
        embed_form_assess(&f, &s->samples, stride);
        f.found = f.error <= (stride > 1 ? 1 : margin) * s->tolerance;
    }
    if (f.found)
        embed_form_price(&f);
    if (f.found && !(best->found && balanced_cost(best) <= balanced_cost(&f))) {
        embed_form_clear(best);
        *best = f;
        return true;
    }
    embed_form_clear(&f);
    return f.found;
}

/* Tries polynomials, or rational functions whose degrees are nearly equal. */
static void search_rational(struct embed_form *best, const struct embed_scene *s, enum embed_variable variable)
{
    const bool polynomial = best->family == FAMILY_POLYNOMIAL_BETA;
    for (slong total = 1; total <= (polynomial ? POLYNOMIAL_MAX : RATIONAL_MAX); total++) {
        const slong m = polynomial ? total : total / 2, other = total % 2 ? m + 1 : m - 1;
        if (try_form(best, form_blank(s, best->family, variable, m, total - m), s, NULL) ||
            (!polynomial && try_form(best, form_blank(s, best->family, variable, other, total - other), s, NULL)))
            return;
    }
}

/* ---- from the series at beta = 0 ---- */

static bool try_quotient(struct embed_form *best, const struct embed_scene *s, const struct pade *f, slong m, slong n)
{
    const enum embed_variable variable = s->series_root == 1 ? FIFTH_ROOT_OF_SPEED : TENTH_ROOT_OF_SPEED;
    return try_form(best, form_blank(s, best->family, variable, m, n), s, f);
}

/* The radius of convergence of eps in powers of beta (docs/theory.md, 3). If beta exceeds NEAR_CONVERGENCE of the
 * radius, the message about a failed search states this as the reason. */
#define CONVERGENCE 1.388
#define NEAR_CONVERGENCE 0.97

static void search_series(struct embed_form *best, const struct embed_scene *s)
{
    LOCAL_INIT(pade, f, (&f));
    arb_poly_one(f.q);
    for (slong degree = 1; degree <= EMBED_SERIES && !best->found; degree++) {
        arb_poly_set_trunc(f.p, s->series, degree + 1);
        try_quotient(best, s, &f, degree, 0);
    }
    if (!best->found && s->beta_max > NEAR_CONVERGENCE * CONVERGENCE)
        snprintf(best->why, sizeof best->why, "beta exceeds the radius of convergence, %g", CONVERGENCE);
}

static void search_pade(struct embed_form *best, const struct embed_scene *s)
{
    LOCAL_INIT(pade, f, (&f));
    for (slong total = 1; total <= PADE_MAX && !best->found; total++)
        for (slong skew = total % 2; skew <= PADE_SKEW && skew <= total && !best->found; skew += 2) {
            const slong m = (total - skew) / 2, n = total - m;
            if (pade_of_series(&f, s->series, m, n, EMBED_BITS))
                try_quotient(best, s, &f, m, n);
        }
}

static void search_two_point(struct embed_form *best, const struct embed_scene *s)
{
    LOCAL_INIT(pade, f, (&f));
    if (s->end != COR_END_ZERO_OVERLAP)
        snprintf(best->why, sizeof best->why, "eps at zero force has no power law at large beta");
    for (slong m = 0; s->end == COR_END_ZERO_OVERLAP && 2 * m + 5 <= PADE_MAX && !best->found; m++)
        if (pade_two_point_of_series(&f, s->series, s->h_star_5, m, EMBED_BITS))
            try_quotient(best, s, &f, m, m + 5);
}

/* ---- tables ---- */

static slong table_bytes(const struct embed_form *f)
{
    return f->rows * (f->numerator + 1) * (f->single ? 4 : 8);
}

static void search_pieces_beta(struct embed_form *best, const struct embed_scene *s)
{
    for (slong degree = 1; degree <= PIECE_DEGREE_MAX && !best->found; degree++) {
        struct embed_form f = form_blank(s, FAMILY_PIECES_BETA, FIFTH_ROOT_OF_SPEED, degree, 0);
        for (f.rows = 4; f.rows <= ROWS_MAX && table_bytes(&f) <= EMBED_TABLE_BYTES && !best->found; f.rows *= 2)
            try_form(best, f, s, NULL);
    }
}

static void search_pieces_speed(struct embed_form *best, const struct embed_scene *s)
{
    if (s->knot) { /* try the table's own cubics */
        struct embed_form f = form_blank(s, FAMILY_PIECES_SPEED, SPEED, 3, 0);
        f.rows = s->knots - 1;
        f.knot = s->knot;
        try_form(best, f, s, NULL);
        return;
    }
    for (slong least = 0, most = EMBED_TABLE_BYTES; most <= EMBED_TABLE_BYTES_MOST; least = most, most *= 2)
        for (slong degree = 1; degree <= (least == 0 ? PIECE_DEGREE_MAX : LARGE_PIECE_DEGREE_MAX); degree++)
            for (int bits = 0; bits <= FRACTION_BITS_MAX && !best->found; bits++) {
                struct embed_form f = form_blank(s, FAMILY_PIECES_SPEED, SPEED, degree, 0);
                f.low_bits = (s->single ? 23 : 52) - bits;
                f.first = emit_bits_of(f.single, s->speed_min) >> f.low_bits;
                f.rows = (slong)((emit_bits_of(f.single, s->speed_max) >> f.low_bits) - f.first) + 1;
                if (table_bytes(&f) > least && table_bytes(&f) <= most)
                    try_form(best, f, s, NULL);
            }
    if (!best->found)
        snprintf(best->why, sizeof best->why, "no table of %d bytes or less meets the tolerance",
                 EMBED_TABLE_BYTES_MOST);
}

/* ---- all families ---- */

struct search {
    struct embed_form *form;
    const struct embed_scene *scene;
};

static void search_family(void *context, slong family)
{
    const struct search *const work = context;
    const struct embed_scene *const s = work->scene;
    struct embed_form *const form = &work->form[family];
    static const struct {
        void (*search)(struct embed_form *, const struct embed_scene *); /* NULL: polynomials or rational functions */
        enum embed_variable variable;
    } families[FAMILIES] = {{search_series, SPEED},       {search_pade, SPEED},
                            {search_two_point, SPEED},    {NULL, FIFTH_ROOT_OF_SPEED},
                            {NULL, FIFTH_ROOT_OF_SPEED},  {search_pieces_beta, SPEED},
                            {search_pieces_speed, SPEED}, {NULL, SPEED},
                            {NULL, SQRT_OF_SPEED},        {NULL, FOURTH_ROOT_OF_SPEED}};
    const enum embed_variable variable = families[family].variable;
    *form = form_blank(s, (enum embed_family)family, SPEED, 0, 0);
    if (s->constant) {
        if (family == FAMILY_RATIONAL_SPEED)
            try_form(form, *form, s, NULL);
        snprintf(form->why, sizeof form->why, "eps is the same at every speed");
    } else if (family <= FAMILY_TWO_POINT && (!law_is_sphere(&s->law) || !arb_is_zero(s->liquid_speed) || s->pressed)) {
        snprintf(form->why, sizeof form->why, "exists only for viscoelastic spheres%s",
                 s->pressed                     ? " without a constant force"
                 : arb_is_zero(s->liquid_speed) ? ""
                                                : " without a liquid");
    } else if (families[family].search) {
        families[family].search(form, s);
    } else {
        search_rational(form, s, variable);
        if (s->end == COR_END_ZERO_FORCE && variable == FIFTH_ROOT_OF_SPEED) /* there eps is analytic in sqrt(beta) */
            search_rational(form, s, TENTH_ROOT_OF_SPEED);
    }
}

void embed_search(struct embed_form *form, const struct embed_scene *s)
{
    struct search search = {form, s};
    profile_step("forms");
    parallel_for(search_family, &search, FAMILIES, "forms");
    profile_step(NULL);
}

enum embed_family embed_choose(const struct embed_form *form, enum embed_purpose purpose)
{
    enum embed_family best = FAMILIES;
    double least = INFINITY;
    for (int i = 0; i < FAMILIES; i++)
        if (form[i].found && embed_cost(form[i].cost, purpose) < least) {
            least = embed_cost(form[i].cost, purpose);
            best = (enum embed_family)i;
        }
    return best;
}
