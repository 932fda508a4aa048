/* SPDX-License-Identifier: MIT */
/* Array functions for the list COR_LAW_LOOPS, for one instruction set (sets.h). No set may fuse a multiplication with
 * an addition, so all sets and the scalar functions give the same bits. Each block of numbers passes the stages of its
 * function, loops that a compiler vectorises and that the functions share. Numbers outside the interval are then
 * computed one by one. */
#include "cor/law.h"
#include "runtime/law/array.h"
#include "runtime/number/kernel.h"

/* LANES: a multiple of the vector length of every set */
enum { BLOCK = 128, LANES = 8 };

/* The least multiple of LANES from n on. A compiler that sees it, and that it is not 0, leaves out the loop over what
 * is no whole vector. */
#define WHOLE(n) (((n) + LANES - 1) / LANES * LANES)

typedef double law_function(double x);

/* Copies the next m numbers of `in`, which may be the array of results, to `from` and to `inside`, where an end of the
 * interval replaces numbers outside it and fills the block up to whole vectors. Returns whether there were such
 * numbers. */
SHARED int next_block(double *restrict from, double *restrict inside, const double *restrict in, size_t m, double least,
                      double largest)
{
    int outside = 0;
    for (size_t j = 0; j < m; j++) {
        const double x = in[j];
        const int is_inside = (x >= least) & (x <= largest);
        outside |= !is_inside;
        from[j] = x;
        inside[j] = is_inside ? x : largest;
    }
    for (size_t j = m; j < WHOLE(m); j++)
        inside[j] = largest;
    return outside;
}

SHARED void put_block(double *restrict out, const double *restrict to, const double *restrict from, size_t m,
                      int outside, double least, double largest, law_function *function)
{
    /* cppcheck-suppress uninitvar ; the loop before has filled `to` */
    for (size_t j = 0; j < m; j++)
        out[j] = to[j];
    for (size_t j = 0; outside && j < m; j++)
        if (!(from[j] >= least && from[j] <= largest))
            out[j] = function(from[j]);
}

/* ---- stages ---- */

struct pairs {
    double hi[BLOCK], lo[BLOCK];
};

/* The numbers of a block: arguments, results, and what stages leave to later ones */
struct work {
    double x[BLOCK], y[BLOCK];
    struct pairs zeta, numerator; /* of cor_ratio_phase_near; or eps and loss */
    struct pairs exponent, wanted, share;
    double start[BLOCK], slope[BLOCK]; /* or the parts of a root */
};

typedef void stage(struct work *w, size_t n);

KERNEL struct cor_inline_pair pair_at(const struct pairs *p, size_t j)
{
    return cor_pair(p->hi[j], p->lo[j]);
}

KERNEL void put_pair(struct pairs *p, size_t j, struct cor_inline_pair value)
{
    p->hi[j] = value.hi;
    p->lo[j] = value.lo;
}

#define STAGE(name, ...)                                                                                               \
    static void name(struct work *restrict w, size_t n)                                                                \
    {                                                                                                                  \
        const size_t end = WHOLE(n);                                                                                   \
        if (end == 0)                                                                                                  \
            return;                                                                                                    \
        for (size_t j = 0; j < end; j++) {                                                                             \
            const double x = w->x[j];                                                                                  \
            (void)x;                                                                                                   \
            __VA_ARGS__                                                                                                \
        }                                                                                                              \
    }

/* L = -ln(eps), of the damping ratio x */
#define PHASE_OF(about)                                                                                                \
    put_pair(&w->zeta, j, cor_pair(x, 0));                                                                             \
    put_pair(&w->numerator, j, cor_pair(about, 0));
STAGE(FORCE, PHASE_OF(4 * x))
STAGE(APPROACH, PHASE_OF(2 * x))
STAGE(PHASE, put_pair(&w->exponent, j, cor_ratio_phase_near(pair_at(&w->zeta, j), pair_at(&w->numerator, j)));)
STAGE(OVERLAP, put_pair(&w->exponent, j, cor_ratio_overlap_near(x));)
STAGE(LIMITED, const struct cor_ratio_limited parts = cor_ratio_limited_parts(x); put_pair(&w->zeta, j, parts.c);
      put_pair(&w->numerator, j, cor_pair_scaled(parts.c, 4)); put_pair(&w->share, j, parts.share);)
STAGE(SHARE, put_pair(&w->exponent, j, cor_inline_pair_times(pair_at(&w->share, j), pair_at(&w->exponent, j)));)

/* of eps or of the loss x */
STAGE(LOG, put_pair(&w->exponent, j, cor_kernel_minus_log(cor_pair(x, 0)));)
STAGE(LOG_OF_LOSS, put_pair(&w->exponent, j, cor_kernel_minus_log_one_minus(x));)
STAGE(HALF, put_pair(&w->exponent, j, cor_pair_scaled(pair_at(&w->exponent, j), 0.5));)

/* Results from L */
STAGE(EXP, w->y[j] = cor_kernel_exp_minus(pair_at(&w->exponent, j));)
STAGE(LOSS, w->y[j] = cor_kernel_one_minus_exp_minus(pair_at(&w->exponent, j));)
STAGE(TIME, w->y[j] = cor_linear_inline_time_of_max_overlap_near(x);)
STAGE(TWICE, w->y[j] *= 2;)
STAGE(TIME_OVERLAP, w->y[j] = cor_linear_inline_duration_zero_overlap_near(x);)
STAGE(OF_OVERLAP, w->y[j] = cor_ratio_of_overlap(pair_at(&w->exponent, j));)

/* zeta where L is the exponent: a start, L there, and a step */
STAGE(START, const struct cor_ratio_start start = cor_ratio_phase_start(w->exponent.hi[j]);
      put_pair(&w->wanted, j, pair_at(&w->exponent, j)); w->start[j] = start.zeta; w->slope[j] = start.slope;
      put_pair(&w->zeta, j, cor_pair(start.zeta, 0)); put_pair(&w->numerator, j, cor_pair(2 * start.zeta, 0));)
STAGE(OF_PHASE, struct cor_ratio_start start; start.zeta = w->start[j]; start.slope = w->slope[j];
      w->y[j] = cor_ratio_phase_step(start, pair_at(&w->wanted, j), pair_at(&w->exponent, j));)
STAGE(START_LIMITED, put_pair(&w->wanted, j, pair_at(&w->exponent, j));
      w->x[j] = cor_ratio_limited_start_near(w->exponent.hi[j]);)
STAGE(OF_LIMITED, w->y[j] = cor_ratio_limited_step(x, pair_at(&w->exponent, j), pair_at(&w->wanted, j));)

/* Hunt and Crossley's law */
STAGE(ROOT, const struct cor_hc_root y = cor_hc_root_near(x); w->start[j] = y.head; w->slope[j] = y.step;)
STAGE(REST, w->slope[j] = cor_hc_rest(x);)
#define SPEEDS_WEAK                                                                                                    \
    struct cor_hc_root y;                                                                                              \
    y.head = w->start[j];                                                                                              \
    y.step = w->slope[j];                                                                                              \
    const struct cor_hc_speeds speeds = cor_hc_speeds_weak(y, x);
STAGE(EPS_WEAK, SPEEDS_WEAK w->y[j] = cor_hc_eps_of(speeds, x);)
STAGE(LOSS_WEAK, SPEEDS_WEAK w->y[j] = cor_hc_loss_of(speeds, x);)
STAGE(EPS_STRONG, w->y[j] = cor_hc_eps_of(cor_hc_speeds_strong(w->slope[j], x), x);)
STAGE(LOSS_STRONG, w->y[j] = cor_hc_loss_of(cor_hc_speeds_strong(w->slope[j], x), x);)
STAGE(EPS, put_pair(&w->zeta, j, cor_pair(x, 0)); put_pair(&w->numerator, j, cor_hc_one_minus(x));)
STAGE(EPS_OF_LOSS, put_pair(&w->zeta, j, cor_hc_one_minus(x)); put_pair(&w->numerator, j, cor_pair(x, 0));)
STAGE(OF_LANGEVIN, w->y[j] = cor_hc_of_langevin(pair_at(&w->zeta, j), pair_at(&w->numerator, j)).hi;)
STAGE(LIMIT, w->y[j] = cor_hc_limit_start(w->zeta.hi[j]); w->x[j] = cor_kernel_max(w->y[j], COR_HC_LIMIT_LEAST);)
STAGE(LIMIT_STEP, w->y[j] -= cor_hc_limit_step(x, w->slope[j], pair_at(&w->zeta, j)); w->x[j] = w->y[j];)
STAGE(EPS_HC_APPROACH, w->y[j] = cor_hc_eps_approach_only_near(x);)
STAGE(LOSS_HC_APPROACH, w->y[j] = cor_hc_loss_approach_only_near(x);)

/* Which numbers take the first stages */
typedef void splitter(const double *x, unsigned char *is_first, size_t n);

#define SPLIT(name, condition)                                                                                         \
    static void name(const double *restrict x, unsigned char *restrict is_first, size_t n)                             \
    {                                                                                                                  \
        const size_t end = WHOLE(n);                                                                                   \
        for (size_t j = 0; end > 0 && j < end; j++)                                                                    \
            is_first[j] = (unsigned char)(condition);                                                                  \
    }
SPLIT(WEAK, cor_hc_is_weak(x[j]))
SPLIT(LANGEVIN, cor_hc_is_langevin(x[j]))
SPLIT(LANGEVIN_OF_LOSS, cor_hc_is_langevin(1 - x[j]))

/* ---- loops ---- */

enum { MOST_STAGES = 6 };
struct loop {
    double least, largest;
    law_function *one;
    splitter *split; /* NULL: all numbers take the first stages */
    stage *first[MOST_STAGES], *second[MOST_STAGES];
};

#define IN_BRACES(...)                                                                                                 \
    {                                                                                                                  \
        __VA_ARGS__                                                                                                    \
    }
#define LOOP_(name, public, least, largest, stages) {least, largest, cor_##public, NULL, IN_BRACES stages, {NULL}},
#define PARTED_(name, public, least, largest, split, first, second)                                                    \
    {least, largest, cor_##public, split, IN_BRACES first, IN_BRACES second},
static const struct loop loops[] = {COR_LAW_LOOPS(LOOP_, PARTED_)};

static void pass(stage *const *stages, struct work *w, size_t n)
{
    for (int k = 0; k < MOST_STAGES && stages[k]; k++)
        stages[k](w, n);
}

/* The places of a block's numbers: first those of the first stages, then those of the second. */
static size_t part(double *x, size_t *place, const double *inside, const unsigned char *is_first, size_t count,
                   int wanted)
{
    size_t n = 0;
    for (size_t j = 0; j < count; j++) {
        x[n] = inside[j];
        place[n] = j;
        n += is_first[j] == wanted;
    }
    for (size_t j = n; n > 0 && j < WHOLE(n); j++)
        x[j] = x[n - 1];
    return n;
}

static void pass_parted(const struct loop *loop, struct work *w, const double *inside, double *to, size_t n)
{
    unsigned char is_first[BLOCK];
    size_t place[BLOCK];
    loop->split(inside, is_first, n);
    for (int wanted = 1; wanted >= 0; wanted--) {
        const size_t m = part(w->x, place, inside, is_first, WHOLE(n), wanted);
        pass(wanted ? loop->first : loop->second, w, m);
        for (size_t j = 0; j < m; j++)
            to[place[j]] = w->y[j];
    }
}

static void run(enum cor_law_loop number, const double *in, double *out, size_t n)
{
    const struct loop *const loop = &loops[number];
    if (n < 3) { /* the scalar function is faster */
        for (size_t i = 0; i < n; i++)
            out[i] = loop->one(in[i]);
        return;
    }
    for (size_t i = 0; i < n; i += BLOCK) {
        double from[BLOCK], inside[BLOCK], to[BLOCK];
        struct work w;
        const size_t m = n - i < BLOCK ? n - i : BLOCK;
        const int outside = next_block(from, loop->split ? inside : w.x, in + i, m, loop->least, loop->largest);
        if (loop->split)
            pass_parted(loop, &w, inside, to, m);
        else
            pass(loop->first, &w, m);
        put_block(out + i, loop->split ? to : w.y, from, m, outside, loop->least, loop->largest, loop->one);
    }
}

static void run_floats(enum cor_law_loop number, const float *in, float *out, size_t n)
{
    double wide[BLOCK];
    for (size_t i = 0; i < n; i += BLOCK) {
        const size_t m = n - i < BLOCK ? n - i : BLOCK;
        for (size_t j = 0; j < m; j++)
            wide[j] = (double)in[i + j];
        run(number, wide, wide, m);
        for (size_t j = 0; j < m; j++)
            out[i + j] = (float)wide[j];
    }
}

const struct cor_law_loops COR_OF_SET(cor_law_loops) = {run, run_floats};
