/* SPDX-License-Identifier: MIT */
#include "approximation/law_layout.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "enclosure/collision.h"
#include "series/restitution.h"
#include "support/console.h"
#include "support/local.h"

enum {
    CONSTANT_BITS = 200,
    CHECK_POINTS = 5,
    DEGREE = 10,
    HEAD_BITS = 26,       /* bits of c_0 in rows that a function multiplies by its argument (runtime/table/row.h) */
    NEAR_OCTAVES = 3,     /* octaves from near_end to the radius of convergence */
    MOST_POWER = 200,     /* largest 1/q; beyond it eps ~ beta^(-1/q) underflows inside the tables */
    DEVIATION_BITS = 60,  /* 1 - beta^(1/q) eps/v_f is negligible below 2^-60 */
    TINY_EPS_OCTAVE = -60 /* for smaller eps, beta_c - beta is negligible against beta_c */
};

/* Points of an interval, and bits of its samples. Intervals of ln(beta) have the length ln(2) up to beta = 8. For
 * ln(beta) >= 2 they are 2 to 3, 3 to 4, 4 to 6, 6 to 8, .... Intervals of ln(beta_c - beta) span 2 octaves.
 * Where eps is almost linear they are wider: they span 5 octaves if they are below 2^BELOW_WIDE_TO, and 10 octaves if
 * they are below 2^BELOW_WIDEST_TO. */
enum {
    NEAR_POINTS = 18,
    MIDDLE_POINTS = 36,
    TAIL_POINTS = 22,
    MIDDLE_POINTS_BELOW = 26, /* points for laws with a threshold, whose eps does not fall by many powers of ten */
    BELOW_POINTS = 19,
    BELOW_LAST_POINTS = 26,
    NEAR_BITS = 84,
    MIDDLE_BITS = 80,
    TAIL_BITS = 80
};
#define BELOW_WIDEST_TO (-24.0)
#define BELOW_WIDE_TO (-10.0)

/* law_layout_restrict adds intervals of zero force for this beta and above. */
#define LEAST_BETA_OF_FORCE 1e-4

/* Accuracy of the rows: 57 bits limit the approximation error to a sixteenth of the last place. */
#define LEAST_BITS 57.0
#define LEAST_BITS_OF_TIMES 56.0
#define MOST_REST 0.1

/* Returns a u at which mu is not above its value for spheres at u = 10. */
static double last_log(const struct cor_exponents *law)
{
    const double u = 10 * (5.0 / 3) / ratio_double(law_mu_power(law));
    const double octave = exp2(floor(log2(u)));
    return octave * ceil(8 * u / octave) / 8;
}

/* ---- intervals ---- */

struct interval_list {
    struct interval *interval;
    int count;
};

static void add_interval(struct interval_list *list, struct interval interval)
{
    if (interval.set == 0 || !(interval.lo < interval.hi))
        return;
    list->interval = xrealloc(list->interval, (size_t)(list->count + 1) * sizeof *list->interval);
    list->interval[list->count++] = interval;
}

/* Adds equal intervals of ln(beta) no longer than ln(2). */
static void add_middle(struct interval_list *list, double beta_lo, double beta_hi, slong points, unsigned set)
{
    const double lo = log(beta_lo), hi = log(beta_hi);
    const int count = (int)ceil((hi - lo) / log(2) - 1e-9);
    for (int i = 0; i < count; i++)
        add_interval(list, (struct interval){INTERVAL_LOG, lo + (hi - lo) * i / count, lo + (hi - lo) * (i + 1) / count,
                                             points, MIDDLE_BITS, FORM_LOG, set});
}

static void add_tail(struct interval_list *list, double end, unsigned set)
{
    for (double lo = LAW_TAIL_FIRST, hi; lo < end; lo = hi) {
        hi = fmin(lo + exp2(floor(log2(lo)) - 1), end);
        add_interval(list, (struct interval){INTERVAL_LOG, lo, hi, TAIL_POINTS, TAIL_BITS, FORM_POWER, set});
    }
}

static void add_below(struct interval_list *list, const struct law_layout *layout, unsigned set)
{
    const bool linear = law_is_linear(&layout->interpolant.law);
    const double end = log(layout->threshold - layout->overlap_end) + 0.15;
    double lo = log(layout->below_first) - 0.05;
    while (lo < end) {
        const int octaves = lo < BELOW_WIDEST_TO * log(2) ? 10 : lo < BELOW_WIDE_TO * log(2) ? 5 : 2;
        const double hi = fmin(lo + octaves * log(2), end);
        add_interval(list, (struct interval){INTERVAL_BELOW, lo, hi, hi < end ? BELOW_POINTS : BELOW_LAST_POINTS,
                                             MIDDLE_BITS, linear ? FORM_POWER : FORM_LOG, set});
        lo = hi;
    }
}

static void make_intervals(struct law_layout *layout)
{
    const struct cor_exponents *law = &layout->interpolant.law;
    const slong fall = law_fall_power(law).num;
    const unsigned force = law_force_ends(law) ? SET_ZERO_FORCE : 0;
    struct interval_list list = {NULL, 0};
    /* near beta = 0, zero force follows from zero overlap */
    add_interval(&list, (struct interval){INTERVAL_ROOT, 0, layout->near_end, NEAR_POINTS, NEAR_BITS, FORM_QUOTIENT,
                                          SET_LENGTHS | SET_ZERO_OVERLAP});
    if (fall > 0) {
        add_middle(&list, layout->near_end, LAW_MIDDLE_END * 1.01, MIDDLE_POINTS,
                   SET_LENGTHS | SET_ZERO_OVERLAP | force);
        add_tail(&list, layout->last_log, SET_LENGTHS | SET_ZERO_OVERLAP | force);
    } else {
        /* q = 0: eps at zero overlap is a closed form */
        const unsigned overlap = fall == 0 ? 1 << DURATION_ZERO_OVERLAP : SET_ZERO_OVERLAP;
        add_middle(&list, layout->near_end, LAW_MIDDLE_END * 1.01, MIDDLE_POINTS_BELOW, SET_LENGTHS | force);
        add_middle(&list, layout->near_end, layout->overlap_end * 1.13, MIDDLE_POINTS_BELOW, overlap);
        add_below(&list, layout, overlap);
        add_tail(&list, layout->last_log, SET_LENGTHS | force);
    }
    layout->interpolant.interval = list.interval;
    layout->interpolant.intervals = list.count;
}

/* ---- borders ---- */

/* Sets `threshold`, overlap_end (at least beta_c/2), and the range of the rows in beta_c - beta. */
static int find_threshold(struct law_layout *layout)
{
    const struct cor_exponents *law = &layout->interpolant.law;
    LOCAL(arb, beta_c, x);
    const int status = collision_threshold(beta_c, x, law, CONSTANT_BITS);
    layout->threshold = ball_middle(beta_c);
    const double below = arf_get_d(arb_midref(beta_c), ARF_RND_DOWN);
    arb_set_d(x, arf_cmp_d(arb_midref(beta_c), below) > 0 ? below : nextafter(below, 0));
    arb_sub(x, beta_c, x, CONSTANT_BITS);
    layout->below_first = arf_get_d(arb_midref(x), ARF_RND_DOWN);
    /* beta_c - overlap_end is `distance` up to rounding; if it reaches `distance`, the next octave needs a row */
    const double distance = exp2(floor(log2(layout->threshold / 2)));
    layout->overlap_end = layout->threshold - distance;
    LET(x, CONSTANT_BITS, "beta_c - layout->overlap_end", beta_c, layout->overlap_end);
    const bool another_octave = arf_cmp_d(arb_midref(x), nextafter(distance, 0)) > 0;
    layout->below_end = distance * (another_octave ? 1 + 0x1p-20 : 1 + 0x1p-40);
    return status;
}

/* Sets *fallen to true if beta^(1/q) eps equals v_f to double precision. */
static int is_fallen(bool *fallen, const struct cor_exponents *law, const arb_t v_f, double beta)
{
    const struct ratio power = interpolant_tail_power(law, EPS_ZERO_OVERLAP);
    LOCAL(arb, x);
    LOCAL_INIT(collision, c, (&c));
    arb_set_d(x, beta);
    const int status = collision_solve_overlap(&c, x, law, DEVIATION_BITS + 16);
    LET(x, CONSTANT_BITS, "c.eps_zero_overlap/(x^power*v_f) - 1", c.eps_zero_overlap, x, power, v_f);
    *fallen = arf_cmpabs_2exp_si(arb_midref(x), -DEVIATION_BITS) < 0;
    return status;
}

/* For q > 0, finds the beta above which eps is v_f beta^(-1/q) to double precision. Tries beta = 8 first. Then raises
 * u = ln(beta) up to last_log, with 8 steps in each octave of u. Sets h* = v_f^q. */
static int find_fall(double *h_star, struct law_layout *layout)
{
    const struct cor_exponents *law = &layout->interpolant.law;
    bool fallen = false;
    LOCAL(arb, v_f);
    int status = collision_final_speed(v_f, law, CONSTANT_BITS);
    *h_star = pow(ball_middle(v_f), ratio_double(law_speed_exponent(law)));
    layout->overlap_end = LAW_MIDDLE_END;
    layout->overlap_log = 0;
    if (status == STATUS_OK)
        status = is_fallen(&fallen, law, v_f, LAW_MIDDLE_END);
    int tried = 0;
    for (double u = LAW_TAIL_FIRST; status == STATUS_OK && !fallen; u += exp2(floor(log2(u))) / 8) {
        progress("smallest beta of the power law of eps", tried++, 0);
        layout->overlap_log = u + exp2(floor(log2(u))) / 8;
        if (layout->overlap_log > layout->last_log) {
            layout->overlap_log = layout->last_log;
            break;
        }
        status = is_fallen(&fallen, law, v_f, exp(layout->overlap_log));
    }
    progress_end();
    return status;
}

/* ---- tables ---- */

/* Returns the octave k of x, 2^k <= x < 2^(k+1). */
static double octave_of(double x)
{
    return floor(log2(x));
}

/* The parts of the layout, in the order of enum law_part. In the texts, %s is the end of contact or the quantity.
 * holds: in tables for eps, the quantity at zero overlap; -1: eps itself. stem: of the tables for other quantities */
static const struct part {
    int holds;
    const char *stem_of_eps, *title_of_eps, *stem;
    enum variable variable;
    slong head_bits;
} parts[] = {
    {LOSS_QUOTIENT_ZERO_OVERLAP, "near_loss_%s", "(1 - eps)/beta at %s", "near_%s", VARIABLE_BETA, HEAD_BITS},
    {-1, "middle_eps_%s", "eps at %s", "middle_%s", VARIABLE_BETA_OCTAVES, 0},
    {-1, "tail_eps_%s", "eps at %s", "tail_%s", VARIABLE_LOG_OCTAVES, 0},
    {-1, "below_eps_%s", "eps at %s", "below_%s", VARIABLE_BELOW_OCTAVES, 0},
    {BETA_QUOTIENT_ZERO_OVERLAP, "near_beta_%s", "beta/(1 - eps) at %s", NULL, VARIABLE_LOSS, HEAD_BITS},
    {BETA_ZERO_OVERLAP, "beta_%s", "beta at %s", NULL, VARIABLE_EPS_OCTAVES, 0},
};

/* Sets the rows of a derived layout in a root of beta or of the loss. */
static void set_root(struct pieces *p, const struct law_layout *layout, enum quantity quantity)
{
    const slong root = quantity == DURATION_ZERO_FORCE ? layout->root_of_time : layout->root;
    p->root = is_of_force(quantity) ? root : 1;
    if (p->variable == VARIABLE_BETA)
        p->step = exp2(octave_of(pow(p->end, 1 / (double)p->root)) - 1);
    else
        p->step = 0.125;
    if (p->root > 1)
        p->variable = p->variable == VARIABLE_BETA ? VARIABLE_ROOT_BETA : VARIABLE_ROOT_LOSS;
}

static void add_table(struct law_layout *layout, enum law_part part, enum quantity quantity, const char *stem,
                      const char *title)
{
    static const char *const ends[] = {"zero_overlap", "zero_force"}, *const words[] = {"zero overlap", "zero force"};
    const struct part *const form = &parts[part];
    const bool eps = is_eps(quantity), other = eps && form->holds >= 0;
    const bool time =
        quantity == DURATION_ZERO_OVERLAP || quantity == DURATION_ZERO_FORCE || quantity == TIME_OF_MAX_OVERLAP;
    const bool below = is_of_overlap(quantity) && layout->threshold < HUGE_VAL;
    const struct {
        double first, end; /* end 0: the table has no rows */
    } range[] = {
        [PART_NEAR] = {0, layout->near_end},
        [PART_MIDDLE] = {layout->near_end, below ? layout->overlap_end : LAW_MIDDLE_END},
        [PART_TAIL] = {LAW_TAIL_FIRST, below                          ? 0
                                       : quantity == EPS_ZERO_OVERLAP ? layout->overlap_log
                                                                      : layout->last_log},
        [PART_BELOW] = {layout->below_first, below ? layout->below_end : 0},
        [PART_INVERSE_NEAR] = {0, 0.5},
        [PART_INVERSE] = {NAN, 0.5},
    };
    struct law_table *const table = &layout->table[layout->tables];
    *table = (struct law_table){.part = part, .serves = quantity};
    snprintf(table->stem, sizeof table->stem, eps ? form->stem_of_eps : form->stem, eps ? ends[quantity] : stem);
    snprintf(table->title, sizeof table->title, eps ? form->title_of_eps : "%s", eps ? words[quantity] : title);
    struct pieces *const p = &table->rows;
    *p = (struct pieces){.quantity = other ? (enum quantity)(form->holds + (int)quantity) : quantity,
                         .variable = form->variable,
                         .root = 1,
                         .first = range[part].first,
                         .end = range[part].end,
                         .degree = DEGREE,
                         .octave_bits = PIECES_OCTAVE_BITS,
                         .head_bits = eps ? form->head_bits : 0,
                         .least_bits = time || part >= PART_INVERSE_NEAR ? LEAST_BITS_OF_TIMES : LEAST_BITS,
                         .most_rest = MOST_REST};
    if (p->first == 0)
        set_root(p, layout, quantity);
    else
        p->first = octave_of(p->first);
    layout->tables += p->end > 0;
}

static void make_tables(struct law_layout *layout)
{
    static const char *const stems[QUANTITIES][2] = {{0},
                                                     {0},
                                                     {"duration_zero_overlap", "duration at zero overlap"},
                                                     {"duration_zero_force", "duration at zero force"},
                                                     {"max_overlap", "largest overlap"},
                                                     {"time_of_max_overlap", "time of the largest overlap"}};
    enum { PARTS = sizeof parts / sizeof *parts };
    const struct cor_exponents *const law = &layout->interpolant.law;
    layout->table = xmalloc((size_t)QUANTITIES * PARTS * sizeof *layout->table);
    for (int i = 0; i < QUANTITIES; i++) {
        const enum quantity quantity = (enum quantity)i;
        /* no table if the ends coincide or eps has a closed form */
        if ((is_of_force(quantity) && !law_force_ends(law)) || (quantity == EPS_ZERO_OVERLAP && law_is_linear(law)))
            continue;
        for (int part = 0; part < (is_eps(quantity) ? PARTS : PART_INVERSE_NEAR); part++)
            add_table(layout, (enum law_part)part, quantity, stems[i][0], stems[i][1]);
    }
}

double law_layout_inverse_octave(const struct law_layout *layout, const struct interpolant *f, enum quantity eps)
{
    const bool force = eps == EPS_ZERO_FORCE;
    if (!force && layout->threshold < HUGE_VAL)
        return TINY_EPS_OCTAVE;
    const double u = force                     ? layout->last_log
                     : layout->overlap_log > 0 ? layout->overlap_log
                                               : log(layout->overlap_end);
    LOCAL(arb, x, y);
    arb_set_d(x, u);
    arb_exp(x, x, 64);
    interpolant_at_beta(y, f, eps, x, 64);
    /* start at the octave of this eps if the samples of beta cover it, otherwise at the next octave */
    const double q = ratio_double(law_speed_exponent(&layout->interpolant.law));
    const bool sampled = !force && u + q * log(2) <= layout->last_log;
    return octave_of(ball_middle(y)) + (sampled ? 0 : 1);
}

/* ---- layouts ---- */

int law_layout_init(struct law_layout *layout, const struct cor_exponents *law)
{
    const struct ratio n = law_fall_power(law);
    *layout = (struct law_layout){.interpolant = {.law = *law, .root = 1, .far = true},
                                  .root = restitution_zero_force_root(law),
                                  .root_of_time = restitution_zero_force_root(law),
                                  .last_log = last_log(law),
                                  .threshold = HUGE_VAL,
                                  .check_points = CHECK_POINTS};
    if (law_force_ends(law)) {
        const slong other = RATIO("law->a - law->b", law).num; /* denominator of 1/(a-b) */
        layout->root_of_time = layout->root / (slong)n_gcd((ulong)layout->root, (ulong)other) * other;
    }
    if (n.num > 0 && -ratio_double(interpolant_tail_power(law, EPS_ZERO_OVERLAP)) > (double)MOST_POWER)
        return fail(
            "eps of this law is proportional to beta^(-%.0f) at large beta, too steep for a table; use other exponents",
            -ratio_double(interpolant_tail_power(law, EPS_ZERO_OVERLAP)));
    double radius; /* radius of convergence of eps in beta: h* = v_f^q, or the threshold */
    const int status = n.num > 0 ? find_fall(&radius, layout) : find_threshold(layout);
    if (n.num <= 0)
        radius = layout->threshold;
    layout->near_end = exp2(floor(log2(fmin(radius, 1))) - (double)NEAR_OCTAVES);
    make_intervals(layout);
    /* eps of linear laws falls faster, so they need more samples, which are quick to compute */
    for (int i = 0; i < 2 && law_is_linear(law); i++)
        law_layout_refine(layout);
    make_tables(layout);
    return status;
}

void law_layout_init_given(struct law_layout *layout, const struct interpolant_layout *interpolant,
                           const struct law_table *table, int tables)
{
    struct interval_list list = {NULL, 0};
    for (const struct interval *i = interpolant->interval; i < interpolant->interval + interpolant->intervals; i++)
        add_interval(&list, *i);
    *layout = (struct law_layout){.interpolant = *interpolant, .threshold = HUGE_VAL, .tables = tables};
    layout->interpolant.interval = list.interval;
    layout->table = xmalloc((size_t)tables * sizeof *table);
    memcpy(layout->table, table, (size_t)tables * sizeof *table);
}

void law_layout_refine(struct law_layout *layout)
{
    struct interval *const interval = (struct interval *)layout->interpolant.interval;
    for (int i = 0; i < layout->interpolant.intervals; i++)
        interval[i].count += interval[i].count / 4;
}

void law_layout_restrict(struct law_layout *layout, enum quantity eps, double beta_min)
{
    const bool force = eps == EPS_ZERO_FORCE && law_force_ends(&layout->interpolant.law);
    const unsigned set = 1u << (force ? EPS_ZERO_FORCE : EPS_ZERO_OVERLAP);
    const struct interval *const old = layout->interpolant.interval;
    struct interval_list list = {NULL, 0};
    /* the first interval, at beta = 0, serves both ends */
    add_interval(&list, *old);
    if (force && beta_min < layout->near_end)
        add_middle(&list, fmax(beta_min, LEAST_BETA_OF_FORCE) / 2, layout->near_end, MIDDLE_POINTS_BELOW, set);
    for (const struct interval *i = old + 1; i < old + layout->interpolant.intervals; i++) {
        struct interval kept = *i;
        kept.set &= set;
        add_interval(&list, kept);
    }
    free((struct interval *)layout->interpolant.interval);
    layout->interpolant.interval = list.interval;
    layout->interpolant.intervals = list.count;
    layout->interpolant.far = force;
}

void law_layout_clear(struct law_layout *layout)
{
    free((struct interval *)layout->interpolant.interval);
    free(layout->table);
    layout->interpolant.interval = NULL;
    layout->table = NULL;
}
