/* SPDX-License-Identifier: MIT */
#include "approximation/pieces.h"

#include <float.h>
#include <math.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/digits.h"
#include "support/local.h"
#include "support/parallel.h"

enum {
    WORKING_BITS = 320,
    POINTS = 24,      /* a row's error is sampled at POINTS + 1 places */
    FLOAT_POINTS = 8, /* rows of floats are sampled at FLOAT_POINTS + 1 places */
    FLOAT_PLACE_BITS = 30,
    BITS_TO_LINE = 23 /* numbers in a line of the comment above a table */
};

static bool by_octaves(const struct pieces *p)
{
    return p->variable >= VARIABLE_POWER_OCTAVES;
}

/* True if y is a root of beta or of the loss. The field `end` is beta or the loss itself. */
static bool by_root(const struct pieces *p)
{
    return p->variable == VARIABLE_ROOT_BETA || p->variable == VARIABLE_ROOT_LOSS;
}

slong pieces_columns(const struct pieces *p)
{
    return p->floats ? PIECES_FLOATS : p->degree + 2;
}

/* Returns the cell of a row. Rows of floats: row 0 up to 2^first, then octaves of equal cells. */
struct cell pieces_cell(const struct pieces *p, slong row)
{
    if (p->floats && row == 0)
        return (struct cell){0, 0, ldexp(1, (int)p->first), 0, true};
    struct cell cell = {.plain = p->floats || row < p->plain};
    double step = p->step;
    if (p->floats || by_octaves(p)) {
        const slong cells = WORD(1) << p->octave_bits, above = row - p->floats;
        step = 1.0 / (double)cells;
        cell.octave = (slong)p->first + above / cells;
        cell.node = 1 + step * ((double)(above % cells) + 0.5);
    } else {
        cell.node = p->first + (double)row * step;
    }
    cell.lo = cell.node - step / 2;
    cell.hi = cell.node + step / 2;
    if (p->floats) /* y is beta, not beta 2^-octave */
        return (struct cell){ldexp(cell.node, (int)cell.octave), ldexp(cell.lo, (int)cell.octave),
                             ldexp(cell.hi, (int)cell.octave), 0, true};
    if (!by_octaves(p) && p->variable != VARIABLE_LOG_BETA)
        cell.lo = fmax(cell.lo, 0);
    return cell;
}

static int collision_at(arb_t value, const void *interpolant, const struct pieces *p, const struct cell *cell,
                        const arb_t y)
{
    const struct interpolant *const f = interpolant;
    LOCAL(arb, x);
    int status = STATUS_OK;
    arb_mul_2exp_si(x, y, cell->octave);
    switch (p->variable) {
    case VARIABLE_BETA:
    case VARIABLE_ROOT_BETA:
        if (p->quantity >= EPS_APPROACH_ONLY) { /* use the variable that has an interval at this beta */
            interpolant_at_beta(value, f, p->quantity, y, WORKING_BITS);
            break;
        }
        /* x: the root of beta that is the interpolant's variable near beta = 0 */
        if (p->variable == VARIABLE_BETA || p->root != f->layout->root) {
            arb_pow_ui(x, y, p->variable == VARIABLE_BETA ? 1 : (ulong)p->root, WORKING_BITS);
            arb_root_ui(x, x, (ulong)f->layout->root, WORKING_BITS);
        }
        interpolant_at(value, f, p->quantity, INTERVAL_ROOT, x, WORKING_BITS);
        break;
    case VARIABLE_POWER_OCTAVES: /* beta^5 = z^10 */
        arb_root_ui(x, x, 10, WORKING_BITS);
        interpolant_at(value, f, p->quantity, INTERVAL_ROOT, x, WORKING_BITS);
        break;
    case VARIABLE_LOG_BETA:
    case VARIABLE_LOG_OCTAVES:
        interpolant_tail(value, f, p->quantity, INTERVAL_LOG, x, WORKING_BITS);
        break;
    case VARIABLE_BETA_OCTAVES:
        arb_log(x, x, WORKING_BITS);
        interpolant_at(value, f, p->quantity, INTERVAL_LOG, x, WORKING_BITS);
        break;
    case VARIABLE_BELOW_OCTAVES:
        arb_log(x, x, WORKING_BITS);
        interpolant_tail(value, f, p->quantity, INTERVAL_BELOW, x, WORKING_BITS);
        break;
    case VARIABLE_ROOT_LOSS:
        arb_pow_ui(x, y, (ulong)p->root, WORKING_BITS);
        status = interpolant_inverse(value, f, p->quantity, x, WORKING_BITS);
        break;
    case VARIABLE_LOSS:
    case VARIABLE_EPS_OCTAVES:
        status = interpolant_inverse(value, f, p->quantity, x, WORKING_BITS);
        break;
    case VARIABLE_OTHER:
        break;
    }
    return status;
}

struct pieces_function pieces_of_collision(const struct interpolant *f)
{
    return (struct pieces_function){collision_at, f};
}

/* Computes the factor s (pieces.h) at y. */
static void set_factor(arb_t s, const struct cell *cell, const arb_t y)
{
    LET(s, WORKING_BITS, cell->plain ? "y - cell->node" : "y^2 - cell->node^2", y, cell->node);
}

/* Returns a sample point of the cell: a double of few bits between its ends. */
static double place_between(const struct pieces *p, const struct cell *cell, double fraction)
{
    if (p->floats) {
        const double unit = ldexp(cell->hi, -FLOAT_PLACE_BITS);
        return nearbyint((cell->lo + (cell->hi - cell->lo) * fraction) / unit) * unit;
    }
    return ldexp(nearbyint(ldexp(cell->lo + (cell->hi - cell->lo) * fraction, 40)), -40);
}

static int cut_exact(arb_ptr c, const struct pieces *p, struct pieces_function f, const struct cell *cell)
{
    const slong n = p->degree;
    LOCAL_VECTOR(t, n);
    LOCAL_VECTOR(quotient, n);
    LOCAL(arb_poly, polynomial);
    LOCAL(arb, node, y, s);
    arb_set_d(node, cell->node);
    int status = f.at(c, f.context, p, cell, node);
    for (slong j = 0; j < n && status == STATUS_OK; j++) {
        /* slightly off the node, because the quotient would be 0/0 at the node */
        arb_set_d(y, place_between(p, cell, (1 + chebyshev_point(j, n)) / 2) + ldexp(1, -41));
        const arb_srcptr f_y = quotient + j;
        status = f.at(quotient + j, f.context, p, cell, y);
        set_factor(s, cell, y);
        LET(quotient + j, WORKING_BITS, "(f_y - c)/s", f_y, c, s);
        arb_sub(t + j, y, node, WORKING_BITS);
    }
    arb_poly_interpolate_barycentric(polynomial, t, quotient, n, WORKING_BITS);
    for (slong k = 0; k < n; k++)
        arb_poly_get_coeff_arb(c + 2 + k, polynomial, k);
    /* c_0 rounded to head_bits, or to a double */
    arb_set_d(node, ball_middle(c));
    if (p->head_bits > 0)
        arf_set_round(arb_midref(node), arb_midref(c), p->head_bits, ARF_RND_NEAR);
    arb_sub(c + 1, c, node, WORKING_BITS);
    if (p->head_bits > 0)
        arb_set(c, node);
    return status;
}

static int cut_row_of_doubles(double *c, struct pieces *p, struct pieces_function f, slong row, const struct cell *cell)
{
    const slong columns = pieces_columns(p);
    arb_ptr exact = p->coefficient + row * columns;
    if (cut_exact(exact, p, f, cell))
        return STATUS_FAILED;
    for (slong k = 0; k < columns; k++)
        if (!digits_to_double(&c[k], exact + k))
            return fail("%s, row %ld: cannot round coefficient %ld: its enclosure is too wide", p->name, (long)row,
                        (long)k);
    return STATUS_OK;
}

/* Computes y = y x + c. */
static void horner_step(arb_t y, const arb_t x, double c)
{
    LET(y, WORKING_BITS, "y*x + c", y, x, c);
}

/* ---- rows of floats ---- */

enum { CUBIC = PIECES_FLOATS - 1 };

static uint32_t word_of(float x)
{
    uint32_t word;
    memcpy(&word, &x, sizeof word);
    return word;
}

static float float_of(uint32_t word)
{
    float x;
    memcpy(&x, &word, sizeof x);
    return x;
}

/* Returns the c_0' that the lower bits of c_3 contain. */
static double remainder_in(double c_3)
{
    return (double)float_of(word_of((float)c_3) << 16);
}

/* Returns the float nearest to c_3 whose lower 16 bits are the upper bits of c_0', rounded to 8 bits. */
static double with_remainder(double c_3, double remainder)
{
    const uint32_t low = (word_of((float)remainder) + 0x8000) >> 16;
    const uint32_t high = word_of((float)c_3) & 0xffff0000;
    double nearest = (double)float_of(high | low);
    for (int up = -1; up <= 1; up += 2) {
        const double other = (double)float_of((high + (uint32_t)up * 0x10000) | low);
        if (fabs(other - c_3) < fabs(nearest - c_3))
            nearest = other;
    }
    return nearest;
}

/* Returns the nearest float. gcc 12 omits (double)(float) of two neighbours where it vectorizes them. */
static double nearest_float(double x)
{
    volatile float y = (float)x;
    return (double)y;
}

/* Converts a_0 + a_1 t + ... + a_3 t^3 to a row. c_3 is off by d = a_3 - c_3. In the cell of half width h around m, d
 * t^3 is a polynomial of degree 2 plus d h^3 T_3((t - m)/h)/4. The other coefficients absorb that polynomial, and c_0'
 * absorbs its constant term. */
static void columns_of_cubic(double c[PIECES_FLOATS], const double a[PIECES_FLOATS], const struct cell *cell)
{
    const double m = (cell->lo + cell->hi) / 2 - cell->node, h2 = pow((cell->hi - cell->lo) / 2, 2);
    c[3] = with_remainder(a[3], a[0]);
    if (cell->node > 0)
        c[3] = with_remainder(a[3], a[0] + (a[3] - c[3]) * m * (m * m - 0.75 * h2));
    const double d = a[3] - c[3];
    c[1] = nearest_float(a[1] + d * (0.75 * h2 - 3 * m * m));
    c[2] = nearest_float(a[2] + d * 3 * m);
}

/* Computes c_0, and the cubic in t through f - c_0 at the Chebyshev points of the cell. At beta = 0 the row is exact,
 * so that eps never exceeds 1 in any rounding mode. */
static int cut_row_of_floats(double *c, const struct pieces *p, struct pieces_function f, const struct cell *cell)
{
    LOCAL_VECTOR(t, PIECES_FLOATS);
    LOCAL_VECTOR(value, PIECES_FLOATS);
    double a[PIECES_FLOATS];
    LOCAL(arb, y, head, rest);
    LOCAL(arb_poly, cubic);
    arb_set_d(y, cell->node);
    int status = f.at(rest, f.context, p, cell, y);
    arf_set_round(arb_midref(head), arb_midref(rest), p->head_bits > 0 ? p->head_bits : FLT_MANT_DIG, ARF_RND_NEAR);
    arb_sub(rest, rest, head, WORKING_BITS);
    for (slong j = 0; j <= CUBIC && status == STATUS_OK; j++) {
        const double place = place_between(p, cell, (1 + chebyshev_point(j, CUBIC + 1)) / 2);
        arb_set_d(y, place);
        status = f.at(value + j, f.context, p, cell, y);
        arb_sub(value + j, value + j, head, WORKING_BITS);
        arb_set_d(t + j, place - cell->node); /* exact */
    }
    arb_poly_interpolate_barycentric(cubic, t, value, CUBIC + 1, WORKING_BITS);
    for (slong k = 0; k <= CUBIC; k++) {
        arb_poly_get_coeff_arb(y, cubic, k);
        a[k] = ball_middle(k == 0 && cell->node == 0 ? rest : y);
    }
    c[0] = ball_middle(head);
    columns_of_cubic(c, a, cell);
    return status;
}

/* ---- the error of a row ---- */

/* Evaluates the row at y exactly. */
static void row_value(arb_t value, const struct pieces *p, const struct cell *cell, const double *c, const arb_t y)
{
    LOCAL(arb, t, s);
    LET(t, WORKING_BITS, "y - cell->node", y, cell->node);
    set_factor(s, cell, y);
    arb_zero(value);
    for (slong k = pieces_columns(p) - 1; k >= (p->floats ? 1 : 2); k--)
        horner_step(value, t, c[k]);
    horner_step(value, s, p->floats ? remainder_in(c[CUBIC]) : c[1]);
    arb_one(t);
    horner_step(value, t, c[0]);
}

/* Sets the row's bits to -log2 of the largest relative error found, or to NaN after reporting a failure. Returns the
 * largest |row/c_0 - 1|. */
static double sample_row(double *bits, const struct pieces *p, struct pieces_function f, const struct cell *cell,
                         const double *c)
{
    LOCAL(arb, y, exact, value);
    const int places = p->floats ? FLOAT_POINTS : POINTS;
    double worst = 0, rest = 0;
    for (int k = 0; k <= places; k++) {
        const double fraction = k / (double)places;
        arb_set_d(y, place_between(p, cell, p->floats ? (1 - cos(fraction * acos(-1.0))) / 2 : fraction));
        if (f.at(exact, f.context, p, cell, y))
            worst = NAN;
        row_value(value, p, cell, c, y);
        rest = fmax(rest, fabs(ball_middle(value) / c[0] - 1));
        LET(value, WORKING_BITS, "(value - exact)/exact", value, exact);
        const double error = fabs(arf_get_d(arb_midref(value), ARF_RND_UP)) + mag_get_d(arb_radref(value));
        worst = error <= worst ? worst : error; /* a NaN stays */
    }
    *bits = worst == 0 ? INFINITY : -log2(worst);
    return rest;
}

/* ---- all rows ---- */

/* True if the rows cover the range of the table. */
static bool covers_end(const struct pieces *p)
{
    const struct cell last = pieces_cell(p, p->rows - 1);
    if (by_octaves(p))
        return ldexp(last.hi, (int)last.octave) >= p->end;
    return (by_root(p) ? pow(last.hi, (double)p->root) : last.hi) >= p->end;
}

struct cutting {
    struct pieces *p;
    struct pieces_function f;
    double *rest; /* upper bound of |row/c_0 - 1| for each row */
    atomic_bool failed, missed;
};

static bool is_good(const struct cutting *work, slong row)
{
    const struct pieces *const p = work->p;
    return p->bits[row] >= p->least_bits && (p->most_rest == 0 || work->rest[row] <= p->most_rest);
}

/* Computes a row, unless another row has missed a bound, because the cells are then too wide. */
static void cut_row(void *context, slong row)
{
    struct cutting *const work = context;
    struct pieces *const p = work->p;
    const struct cell cell = pieces_cell(p, row);
    double *const c = p->value + row * pieces_columns(p);
    p->bits[row] = INFINITY;
    work->rest[row] = 0;
    if (atomic_load(&work->failed) || atomic_load(&work->missed))
        return;
    if (p->floats ? cut_row_of_floats(c, p, work->f, &cell) : cut_row_of_doubles(c, p, work->f, row, &cell)) {
        atomic_store(&work->failed, true);
        return;
    }
    if (!p->to_prove)
        work->rest[row] = sample_row(&p->bits[row], p, work->f, &cell, c);
    if (!is_good(work, row))
        atomic_store(&work->missed, true);
}

/* Computes all rows. Sets *missed to the first row that misses a bound, or to -1. If `last`, also reports it. */
static int cut_rows(struct pieces *p, struct pieces_function f, slong *missed, bool last)
{
    struct cutting work = {.p = p, .f = f, .rest = xmalloc((size_t)p->rows * sizeof *work.rest)};
    int status = STATUS_OK;
    parallel_for(cut_row, &work, p->rows, p->name);
    *missed = -1;
    for (slong row = p->rows - 1; row >= 0 && atomic_load(&work.missed); row--)
        if (!is_good(&work, row))
            *missed = row;
    if (atomic_load(&work.failed))
        status = STATUS_FAILED;
    else if (*missed >= 0 && last)
        status = fail("%s, row %ld of %ld: %.1f bits reached, %.1f required; variation %.2g", p->name, (long)*missed,
                      (long)p->rows, p->bits[*missed], p->least_bits, work.rest[*missed]);
    free(work.rest);
    return status;
}

static void pieces_allocate(struct pieces *p)
{
    const slong numbers = p->rows * pieces_columns(p);
    p->coefficient = _arb_vec_init(numbers);
    p->value = xmalloc((size_t)numbers * sizeof *p->value);
    p->bits = xmalloc((size_t)p->rows * sizeof *p->bits);
}

int pieces_make(struct pieces *p, struct pieces_function f)
{
    slong missed;
    pieces_allocate(p);
    return covers_end(p) ? cut_rows(p, f, &missed, true)
                         : fail("%s: %ld rows do not reach %g", p->name, (long)p->rows, p->end);
}

/* Returns the number of rows up to `end`. */
static slong rows_to_end(const struct pieces *p)
{
    if (by_octaves(p)) {
        const int octave = (int)floor(log2(p->end)) - (ldexp(1, (int)floor(log2(p->end))) == p->end);
        const double part = ldexp(p->end, -octave) - 1; /* the part of the last octave, 0 < part <= 1 */
        return (octave - (slong)p->first) * (WORD(1) << p->octave_bits) +
               (slong)ceil(ldexp(part, (int)p->octave_bits) - 1e-9);
    }
    const double y = by_root(p) ? pow(p->end, 1 / (double)p->root) : p->end;
    return (slong)ceil((y * (1 + 1e-12) - p->first) / p->step - 0.5) + 1;
}

int pieces_fit(struct pieces *p, struct pieces_function f)
{
    enum { HALVINGS = 8 };
    slong missed = 0;
    int status = STATUS_OK;
    for (int i = 1; i <= HALVINGS && missed >= 0 && status == STATUS_OK; i++) {
        if (i > 1) {
            pieces_clear(p);
            p->octave_bits++;
            p->step /= 2;
        }
        p->plain = p->rows = rows_to_end(p);
        pieces_allocate(p);
        status = cut_rows(p, f, &missed, i == HALVINGS);
    }
    return status;
}

void pieces_clear(struct pieces *p)
{
    if (p->coefficient)
        _arb_vec_clear(p->coefficient, p->rows * pieces_columns(p));
    free(p->value);
    free(p->bits);
    p->coefficient = NULL;
    p->value = p->bits = NULL;
}

/* y: the variable. range: the range in a table's title, as a format. Tables by octaves print 2^first and the end, which
 * is also printed as a power of 2 if `log` is true. Other tables print one limit. */
static const struct {
    const char *y, *range;
    bool log;
} variables[] = {
    [VARIABLE_BETA] = {"beta", NULL, false},
    [VARIABLE_ROOT_BETA] = {"beta", NULL, false},
    [VARIABLE_LOG_BETA] = {"ln(beta)", ", beta > exp(%g)", false},
    [VARIABLE_LOSS] = {"1 - eps", ", 1 - eps < 1/%g", false},
    [VARIABLE_ROOT_LOSS] = {"1 - eps", ", 1 - eps < 1/%g", false},
    [VARIABLE_POWER_OCTAVES] = {"beta^5 2^-k", " by x = beta^5, 2^%g <= x < 2^%g", true},
    [VARIABLE_EPS_OCTAVES] = {"eps 2^-k", " by eps, 2^%g <= eps < 2^%g", true},
    [VARIABLE_BETA_OCTAVES] = {"beta 2^-k", ", 2^%g <= beta < %g", false},
    [VARIABLE_LOG_OCTAVES] = {"ln(beta) 2^-k", ", 2^%g <= ln(beta) < %g", false},
    [VARIABLE_BELOW_OCTAVES] = {"(beta_c - beta) 2^-k", ", 2^%g <= beta_c - beta < 2^%g", true},
};

static void domain_text(char text[64], const struct pieces *p)
{
    const char *const range = variables[p->variable].range;
    text[0] = 0;
    if (p->words)
        return;
    if (by_octaves(p))
        snprintf(text, 64, range, p->first, variables[p->variable].log ? log2(p->end) : p->end);
    else if (range)
        snprintf(text, 64, range, p->variable == VARIABLE_LOG_BETA ? p->first - p->step / 2 : 1 / p->end);
    else
        snprintf(text, 64, p->end < 1 ? ", beta < 1/%g" : ", beta < %g", p->end < 1 ? 1 / p->end : p->end);
}

static void variable_text(char text[64], const struct pieces *p)
{
    const char *const name = p->words ? p->words : variables[p->variable].y;
    if (!by_root(p) || p->root == 1)
        snprintf(text, 64, "%s", name);
    else if (p->root == 2)
        snprintf(text, 64, "sqrt(%s)", name);
    else
        snprintf(text, 64, "(%s)^(1/%ld)", name, (long)p->root);
}

static void grid_text(char text[96], const struct pieces *p)
{
    const struct cell first = pieces_cell(p, 0), last = pieces_cell(p, p->rows - 1);
    const slong cells = WORD(1) << p->octave_bits;
    if (p->floats)
        snprintf(text, 96, "one row below %g, then %ld rows in each octave", first.hi, (long)cells);
    else if (by_octaves(p))
        snprintf(text, 96, "%ld rows in each octave k = %ld ... %ld", (long)cells, (long)first.octave,
                 (long)last.octave);
    else
        snprintf(text, 96, "nodes %g + i %g, %g <= y <= %g", p->first, p->step, first.lo, last.hi);
}

/* Returns the bits of all rows, rounded down to tenths, on lines of their own. The caller frees the text. */
static char *bits_text(const struct pieces *p)
{
    enum { EACH = 8 };
    char *const text = xmalloc((size_t)p->rows * EACH + 1);
    size_t size = 0;
    for (slong row = 0; row < p->rows; row++)
        size += (size_t)snprintf(text + size, EACH, "%c%.1f", row % BITS_TO_LINE ? ' ' : '\n',
                                 floor(p->bits[row] * 10) / 10);
    return text;
}

static void emit_description(struct emit *e, const struct pieces *p)
{
    double worst = INFINITY;
    for (slong row = 0; row < p->rows; row++)
        worst = fmin(worst, p->bits[row]);
    char domain[64], variable[64], grid[96],
        known[64] = "proved for the whole cell of each row", *const bits = bits_text(p);
    domain_text(domain, p);
    variable_text(variable, p);
    grid_text(grid, p);
    if (!p->proved)
        snprintf(known, sizeof known, "sampled at %d places of each row", (p->floats ? FLOAT_POINTS : POINTS) + 1);
    emit_comment(e,
                 "%s%s: %ld rows of degree %ld in y = %s, %s.\n"
                 "Relative error of the approximation: 2^-%.1f at most, %s. Bits of the rows:%s",
                 p->title, domain, (long)p->rows, (long)(p->floats ? CUBIC : p->degree), variable, grid,
                 floor(worst * 10) / 10, known, bits);
    free(bits);
}

static void emit_geometry(struct emit *e, const struct pieces *p)
{
    if (by_octaves(p) || p->floats)
        emit_geometry_real(e, p->name, "FIRST", ldexp(1, (int)p->first));
    else
        emit_geometry_real(e, p->name, "FIRST", p->first);
    if (by_octaves(p))
        emit_geometry_integer(e, p->name, "FIRST_OCTAVE", (slong)p->first);
    if (by_octaves(p) || p->floats) {
        emit_geometry_integer(e, p->name, "OCTAVE_BITS", p->octave_bits);
    } else {
        emit_geometry_real(e, p->name, "STEP", p->step);
        emit_geometry_real(e, p->name, "PER_UNIT", 1 / p->step);
    }
    emit_geometry_integer(e, p->name, "ROWS", p->rows);
    if (p->plain < p->rows && !p->floats)
        emit_geometry_integer(e, p->name, "PLAIN_ROWS", p->plain);
    emit_geometry_real(e, p->name, "END", p->end);
}

int pieces_emit(struct emit *e, const struct pieces *p)
{
    const slong columns = pieces_columns(p);
    int status = STATUS_OK;
    emit_description(e, p);
    emit_geometry(e, p);
    emit_rows_open(e, p->floats ? "float" : "double", p->name, p->rows, columns);
    for (slong row = 0; row < p->rows && status == STATUS_OK; row++)
        if (p->floats)
            emit_float_row(e, p->value + row * columns, columns);
        else
            status = emit_row(e, p->coefficient + row * columns, columns);
    emit_rows_close(e);
    return status;
}

int pieces_write(struct emit *e, struct pieces *p, struct pieces_function f)
{
    int status = (p->rows > 0 ? pieces_make : pieces_fit)(p, f);
    if (status == STATUS_OK)
        status = pieces_emit(e, p);
    pieces_clear(p);
    return status;
}
