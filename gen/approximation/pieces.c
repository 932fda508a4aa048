/* SPDX-License-Identifier: MIT */
#include "approximation/pieces.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "support/console.h"
#include "support/digits.h"
#include "support/parallel.h"

enum { WORKING_BITS = 320, POINTS = 24 /* where a row's error is sampled */ };

static bool by_octaves(const struct pieces *p)
{
    return p->variable >= VARIABLE_POWER_OCTAVES;
}

/* Whether y is a root, while the end of the table is that of its power */
static bool by_root(const struct pieces *p)
{
    return p->variable == VARIABLE_ROOT_BETA || p->variable == VARIABLE_ROOT_LOSS;
}

struct cell pieces_cell(const struct pieces *p, slong row)
{
    struct cell cell = {.plain = row < p->plain};
    double step = p->step;
    if (by_octaves(p)) {
        const slong cells = WORD(1) << p->octave_bits;
        step = 1.0 / (double)cells;
        cell.octave = (slong)p->first + row / cells;
        cell.node = 1 + step * ((double)(row % cells) + 0.5);
    } else {
        cell.node = p->first + (double)row * step;
    }
    cell.lo = cell.node - step / 2;
    cell.hi = cell.node + step / 2;
    if (!by_octaves(p) && p->variable != VARIABLE_LOG_BETA)
        cell.lo = fmax(cell.lo, 0);
    return cell;
}

/* The root of beta at y, the interpolant's variable near beta = 0 */
static void root_of_beta(arb_t z, const struct pieces *p, const struct interpolant *f, const arb_t y)
{
    if (p->variable == VARIABLE_ROOT_BETA && p->root == interpolant_root(f)) {
        arb_set(z, y);
        return;
    }
    if (p->variable == VARIABLE_ROOT_BETA)
        arb_pow_ui(z, y, (ulong)p->root, WORKING_BITS);
    else
        arb_set(z, y);
    arb_root_ui(z, z, (ulong)interpolant_root(f), WORKING_BITS);
}

/* The quantity at a place of a cell. Returns 0, or 1 after reporting the failure. */
static int quantity_at(arb_t value, const struct pieces *p, const struct interpolant *f, const struct cell *cell,
                       const arb_t y)
{
    arb_t x;
    int status = STATUS_OK;
    arb_init(x);
    arb_mul_2exp_si(x, y, cell->octave);
    switch (p->variable) {
    case VARIABLE_BETA:
    case VARIABLE_ROOT_BETA:
        root_of_beta(x, p, f, y);
        interpolant_value(value, f, p->quantity, x, WORKING_BITS);
        break;
    case VARIABLE_POWER_OCTAVES: /* beta^5 = z^10 */
        arb_root_ui(x, x, 10, WORKING_BITS);
        interpolant_value(value, f, p->quantity, x, WORKING_BITS);
        break;
    case VARIABLE_LOG_BETA:
    case VARIABLE_LOG_OCTAVES:
        interpolant_tail(value, f, p->quantity, x, WORKING_BITS);
        break;
    case VARIABLE_BETA_OCTAVES:
        arb_log(x, x, WORKING_BITS);
        interpolant_at(value, f, p->quantity, INTERVAL_LOG, x, WORKING_BITS);
        break;
    case VARIABLE_BELOW_OCTAVES:
        arb_log(x, x, WORKING_BITS);
        interpolant_below(value, f, p->quantity, x, WORKING_BITS);
        break;
    case VARIABLE_ROOT_LOSS:
        arb_pow_ui(x, y, (ulong)p->root, WORKING_BITS);
        status = interpolant_inverse(value, f, p->quantity, x, WORKING_BITS);
        break;
    case VARIABLE_LOSS:
    case VARIABLE_EPS_OCTAVES:
        status = interpolant_inverse(value, f, p->quantity, x, WORKING_BITS);
        break;
    }
    arb_clear(x);
    return status;
}

/* s of the header at y */
static void factor(arb_t s, const struct cell *cell, const arb_t y)
{
    arb_t node;
    arb_init(node);
    arb_set_d(node, cell->node);
    if (!cell->plain) {
        arb_sqr(s, y, WORKING_BITS);
        arb_submul(s, node, node, WORKING_BITS);
    } else {
        arb_sub(s, y, node, WORKING_BITS);
    }
    arb_clear(node);
}

/* A sample point of the cell: a double between its ends */
static double between(const struct cell *cell, double fraction)
{
    return ldexp(nearbyint(ldexp(cell->lo + (cell->hi - cell->lo) * fraction, 40)), -40);
}

/* c_0 rounded to few bits, or to those of a double */
static void round_head(arb_t head, const struct pieces *p, const arb_t value)
{
    if (p->head_bits > 0) {
        arf_set_round(arb_midref(head), arb_midref(value), p->head_bits, ARF_RND_NEAR);
        mag_zero(arb_radref(head));
    } else {
        arb_set_d(head, arf_get_d(arb_midref(value), ARF_RND_NEAR));
    }
}

static int cut(arb_ptr c, const struct pieces *p, const struct interpolant *f, const struct cell *cell)
{
    const slong n = p->degree;
    arb_ptr t = _arb_vec_init(n), quotient = _arb_vec_init(n);
    arb_poly_t polynomial;
    arb_t node, y, s;
    arb_poly_init(polynomial);
    arb_init(node);
    arb_init(y);
    arb_init(s);
    arb_set_d(node, cell->node);
    int status = quantity_at(c, p, f, cell, node);
    for (slong j = 0; j < n && status == STATUS_OK; j++) {
        /* never the node itself, where the quotient is 0/0 */
        arb_set_d(y, between(cell, (1 + chebyshev_point(j, n)) / 2) + ldexp(1, -41));
        status = quantity_at(quotient + j, p, f, cell, y);
        arb_sub(quotient + j, quotient + j, c, WORKING_BITS);
        factor(s, cell, y);
        arb_div(quotient + j, quotient + j, s, WORKING_BITS);
        arb_sub(t + j, y, node, WORKING_BITS);
    }
    arb_poly_interpolate_barycentric(polynomial, t, quotient, n, WORKING_BITS);
    for (slong k = 0; k < n; k++)
        arb_poly_get_coeff_arb(c + 2 + k, polynomial, k);
    round_head(node, p, c);
    arb_sub(c + 1, c, node, WORKING_BITS);
    if (p->head_bits > 0)
        arb_set(c, node);
    arb_poly_clear(polynomial);
    arb_clear(node);
    arb_clear(y);
    arb_clear(s);
    _arb_vec_clear(t, n);
    _arb_vec_clear(quotient, n);
    return status;
}

/* The row of doubles at y, exactly evaluated. */
static void row_value(arb_t value, const struct pieces *p, const struct cell *cell, const double *c, const arb_t y)
{
    arb_t t, s;
    arb_init(t);
    arb_init(s);
    arb_set_d(t, cell->node);
    arb_sub(t, y, t, WORKING_BITS);
    factor(s, cell, y);
    arb_zero(value);
    for (slong k = p->degree + 1; k >= 2; k--) {
        arb_t term;
        arb_init(term);
        arb_set_d(term, c[k]);
        arb_mul(value, value, t, WORKING_BITS);
        arb_add(value, value, term, WORKING_BITS);
        arb_clear(term);
    }
    arb_mul(value, value, s, WORKING_BITS);
    arb_set_d(t, c[1]);
    arb_add(value, value, t, WORKING_BITS);
    arb_set_d(t, c[0]);
    arb_add(value, value, t, WORKING_BITS);
    arb_clear(t);
    arb_clear(s);
}

/* Quality of a cell from samples: -log2 of the largest relative error, NaN after a reported failure, and the largest
 * |row/c_0 - 1| */
struct quality {
    double bits, rest;
};

static struct quality quality_of(const struct pieces *p, const struct interpolant *f, const struct cell *cell,
                                 const double *c)
{
    arb_t y, exact, value;
    double worst = 0, rest = 0;
    arb_init(y);
    arb_init(exact);
    arb_init(value);
    for (int k = 0; k <= POINTS; k++) {
        arb_set_d(y, between(cell, k / (double)POINTS));
        if (quantity_at(exact, p, f, cell, y))
            worst = NAN;
        row_value(value, p, cell, c, y);
        rest = fmax(rest, fabs(arf_get_d(arb_midref(value), ARF_RND_NEAR) / c[0] - 1));
        arb_sub(value, value, exact, WORKING_BITS);
        arb_div(value, value, exact, WORKING_BITS);
        if (!isnan(worst))
            worst = fmax(worst, fabs(arf_get_d(arb_midref(value), ARF_RND_UP)));
    }
    arb_clear(y);
    arb_clear(exact);
    arb_clear(value);
    return (struct quality){-log2(worst), rest};
}

/* Whether the rows cover the range of the table */
static bool covers_end(const struct pieces *p)
{
    const struct cell last = pieces_cell(p, p->rows - 1);
    if (by_octaves(p))
        return ldexp(last.hi, (int)last.octave) >= p->end;
    return (by_root(p) ? pow(last.hi, (double)p->root) : last.hi) >= p->end;
}

struct cutting {
    struct pieces *p;
    const struct interpolant *f;
    struct quality *quality; /* of each row */
    atomic_bool failed, missed;
};

static bool is_good(const struct pieces *p, struct quality quality)
{
    return quality.bits >= p->least_bits && (p->most_rest == 0 || quality.rest <= p->most_rest);
}

/* Computes a row, except after another row has missed a bound, because the grid is then too wide. */
static void cut_row(void *context, slong row)
{
    struct cutting *const work = context;
    struct pieces *const p = work->p;
    const slong columns = p->degree + 2;
    const struct cell cell = pieces_cell(p, row);
    arb_ptr exact = p->coefficient + row * columns;
    double *const c = p->value + row * columns;
    work->quality[row] = (struct quality){INFINITY, 0};
    if (atomic_load(&work->failed) || atomic_load(&work->missed))
        return;
    int status = cut(exact, p, work->f, &cell);
    for (slong k = 0; k < columns && status == STATUS_OK; k++)
        if (!digits_to_double(&c[k], exact + k))
            status = fail("%s, row %ld: coefficient %ld cannot be rounded", p->name, (long)row, (long)k);
    if (status == STATUS_OK) {
        work->quality[row] = quality_of(p, work->f, &cell, c);
        p->bits[row] = work->quality[row].bits;
        if (!is_good(p, work->quality[row]))
            atomic_store(&work->missed, true);
    } else {
        atomic_store(&work->failed, true);
    }
}

/* Computes all rows. Returns STATUS_OK, and sets *good to false if a row misses a bound, with its number and quality,
 * or returns STATUS_FAILED. */
static int cut_rows(struct pieces *p, const struct interpolant *f, bool *good, slong *missed, struct quality *quality)
{
    struct cutting work = {.p = p, .f = f, .quality = xmalloc((size_t)p->rows * sizeof *work.quality)};
    parallel_for(cut_row, &work, p->rows, p->name);
    *good = !atomic_load(&work.missed);
    for (slong row = p->rows - 1; row >= 0; row--)
        if (!is_good(p, work.quality[row])) {
            *missed = row;
            *quality = work.quality[row];
        }
    free(work.quality);
    return atomic_load(&work.failed) ? STATUS_FAILED : STATUS_OK;
}

static void pieces_allocate(struct pieces *p)
{
    const slong numbers = p->rows * (p->degree + 2);
    p->coefficient = _arb_vec_init(numbers);
    p->value = xmalloc((size_t)numbers * sizeof *p->value);
    p->bits = xmalloc((size_t)p->rows * sizeof *p->bits);
}

int pieces_make(struct pieces *p, const struct interpolant *f)
{
    bool good = false;
    slong row = 0;
    struct quality quality = {0, 0};
    pieces_allocate(p);
    if (!covers_end(p))
        return fail("%s: %ld rows do not reach %g", p->name, (long)p->rows, p->end);
    const int status = cut_rows(p, f, &good, &row, &quality);
    return status == STATUS_OK && !good ? fail("%s, row %ld reaches %.1f bits, not the %.1f it must", p->name,
                                               (long)row, quality.bits, p->least_bits)
                                        : status;
}

/* The number of rows up to `end` */
static slong rows_to_end(const struct pieces *p)
{
    if (by_octaves(p)) {
        const int octave = (int)floor(log2(p->end)) - (ldexp(1, (int)floor(log2(p->end))) == p->end);
        const double part = ldexp(p->end, -octave) - 1; /* 0 < part <= 1 */
        return (octave - (slong)p->first) * (WORD(1) << p->octave_bits) +
               (slong)ceil(ldexp(part, (int)p->octave_bits) - 1e-9);
    }
    const double y = by_root(p) ? pow(p->end, 1 / (double)p->root) : p->end;
    return (slong)ceil((y * (1 + 1e-12) - p->first) / p->step - 0.5) + 1;
}

int pieces_fit(struct pieces *p, const struct interpolant *f)
{
    enum { HALVINGS = 8 };
    for (int i = 0; i < HALVINGS; i++) {
        bool good = false;
        slong row = 0;
        struct quality quality = {0, 0};
        p->plain = p->rows = rows_to_end(p);
        pieces_allocate(p);
        const int status = cut_rows(p, f, &good, &row, &quality);
        if (status || good)
            return status;
        if (i + 1 == HALVINGS)
            return fail("%s, row %ld of %ld reaches %.1f bits, not the %.1f it must, or varies by %.2g", p->name,
                        (long)row, (long)p->rows, quality.bits, p->least_bits, quality.rest);
        pieces_clear(p);
        p->octave_bits++;
        p->step /= 2;
    }
    return STATUS_FAILED;
}

void pieces_clear(struct pieces *p)
{
    _arb_vec_clear(p->coefficient, p->rows * (p->degree + 2));
    free(p->value);
    free(p->bits);
}

/* The range of the table, for its title */
static void domain_text(char text[64], const struct pieces *p)
{
    switch (p->variable) {
    case VARIABLE_POWER_OCTAVES:
        snprintf(text, 64, " by x = beta^5, 2^%g <= x < 2^%g", p->first, log2(p->end));
        break;
    case VARIABLE_EPS_OCTAVES:
        snprintf(text, 64, " by eps, 2^%g <= eps < 2^%g", p->first, log2(p->end));
        break;
    case VARIABLE_BETA_OCTAVES:
        snprintf(text, 64, ", 2^%g <= beta < %g", p->first, p->end);
        break;
    case VARIABLE_LOG_OCTAVES:
        snprintf(text, 64, ", 2^%g <= ln(beta) < %g", p->first, p->end);
        break;
    case VARIABLE_BELOW_OCTAVES:
        snprintf(text, 64, ", 2^%g <= beta_c - beta < 2^%g", p->first, log2(p->end));
        break;
    case VARIABLE_LOSS:
    case VARIABLE_ROOT_LOSS:
        snprintf(text, 64, ", 1 - eps < 1/%g", 1 / p->end);
        break;
    case VARIABLE_LOG_BETA:
        snprintf(text, 64, ", beta > exp(%g)", p->first - p->step / 2);
        break;
    default:
        snprintf(text, 64, p->end < 1 ? ", beta < 1/%g" : ", beta < %g", p->end < 1 ? 1 / p->end : p->end);
    }
}

/* The variable y of the table */
static void variable_text(char text[64], const struct pieces *p)
{
    static const char *const names[] = {
        "beta",        "beta",     "ln(beta)",  "1 - eps",       "1 - eps",
        "beta^5 2^-k", "eps 2^-k", "beta 2^-k", "ln(beta) 2^-k", "(beta_c - beta) 2^-k"};
    const char *const name = names[p->variable];
    if (!by_root(p) || p->root == 1)
        snprintf(text, 64, "%s", name);
    else if (p->root == 2)
        snprintf(text, 64, "sqrt(%s)", name);
    else
        snprintf(text, 64, "(%s)^(1/%ld)", name, (long)p->root);
}

static void emit_geometry(struct emit *e, const struct pieces *p)
{
    if (by_octaves(p)) {
        emit_geometry_real(e, p->name, "FIRST", ldexp(1, (int)p->first));
        emit_geometry_integer(e, p->name, "FIRST_OCTAVE", (slong)p->first);
        emit_geometry_integer(e, p->name, "OCTAVE_BITS", p->octave_bits);
    } else {
        emit_geometry_real(e, p->name, "FIRST", p->first);
        emit_geometry_real(e, p->name, "STEP", p->step);
        emit_geometry_real(e, p->name, "PER_UNIT", 1 / p->step);
    }
    emit_geometry_integer(e, p->name, "ROWS", p->rows);
    if (p->plain < p->rows)
        emit_geometry_integer(e, p->name, "PLAIN_ROWS", p->plain);
    emit_geometry_real(e, p->name, "END", p->end);
}

int pieces_emit(struct emit *e, const struct pieces *p)
{
    double worst = INFINITY;
    for (slong row = 0; row < p->rows; row++)
        worst = fmin(worst, p->bits[row]);
    const struct cell first = pieces_cell(p, 0), last = pieces_cell(p, p->rows - 1);
    char grid[96];
    if (by_octaves(p))
        snprintf(grid, sizeof grid, "%ld to each octave k = %ld ... %ld", WORD(1) << p->octave_bits, (long)first.octave,
                 (long)last.octave);
    else
        snprintf(grid, sizeof grid, "nodes %g + i %g, %g <= y <= %g", p->first, p->step, first.lo, last.hi);
    char domain[64], variable[64];
    domain_text(domain, p);
    variable_text(variable, p);
    char known[64];
    if (p->proved)
        snprintf(known, sizeof known, "proved for the whole cell of each row");
    else
        snprintf(known, sizeof known, "sampled at %d places of each row", POINTS + 1);
    emit_comment(e,
                 "%s%s: %ld rows of degree %ld in y = %s, %s.\n"
                 "Relative error of the approximation: 2^-%.1f at most, %s.",
                 p->title, domain, (long)p->rows, (long)p->degree, variable, grid, floor(worst * 10) / 10, known);
    emit_geometry(e, p);
    emit_rows_open(e, p->name, p->rows, p->degree + 2);
    for (slong row = 0; row < p->rows; row++) {
        const struct cell cell = pieces_cell(p, row);
        char text[160];
        char octave[24] = "";
        if (by_octaves(p))
            snprintf(octave, sizeof octave, " 2^%ld", (long)cell.octave);
        snprintf(text, sizeof text, "[%ld] %g <= y <= %g%s, degree %ld, %.1f bits", (long)row, cell.lo, cell.hi, octave,
                 (long)p->degree, floor(p->bits[row] * 10) / 10);
        if (emit_row(e, text, p->coefficient + row * (p->degree + 2), p->degree + 2, row + 1 == p->rows))
            return STATUS_FAILED;
    }
    emit_rows_close(e);
    return STATUS_OK;
}
