/* SPDX-License-Identifier: MIT */
#include "embed/own_law.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/enclosed_function.h"
#include "support/local.h"
#include "support/output.h"

enum { CELL_MOST = 40, CUBIC = 5, CUBIC_BITS = 400 };

/* ---- the table ---- */

static const struct decimal_range range_of_speed = {"0", NULL, false, false, true, NULL},
                                  range_of_eps = {"0", "1", false, true, true, NULL};

static bool read_cell(fmpq_t x, const char *cell, const struct decimal_range *range)
{
    struct decimal number = {0};
    const bool good = strlen(cell) <= CELL_MOST && decimal_parse(&number, cell, DECIMAL_EXPONENT_DIGITS_IN_LIST) &&
                      number.forms == DECIMAL_PLAIN && decimal_inside(range, number.value);
    if (good)
        fmpq_set(x, number.value);
    decimal_clear(&number);
    return good;
}

/* Reads the rows of a table. Returns their number, or 0 after a message. */
static slong read_rows(fmpq *speed, fmpq *eps, const struct table *t, const char *path)
{
    enum { SPEED, EPS, LINE, COLUMNS };
    const slong rows = t->cells / COLUMNS;
    for (slong i = 0; i < rows && i < OWN_ROWS_MOST; i++) {
        char *const *const cell = t->cell + COLUMNS * i;
        const char *const wrong =
            !read_cell(speed + i, cell[SPEED], &range_of_speed) ? "the speed is not a number above 0, in m/s"
            : !read_cell(eps + i, cell[EPS], &range_of_eps)     ? "eps is not a number above 0 and up to 1"
            : i > 0 && fmpq_cmp(speed + i - 1, speed + i) >= 0
                ? "the speed is not above the previous speed; sort the rows by speed, and give each speed once"
                : NULL;
        if (wrong)
            return usage_error("--table %s, line %s: %s", path, cell[LINE], wrong), 0;
    }
    if (rows < 2 || rows > OWN_ROWS_MOST)
        usage_error("--table %s: %ld row%s of numbers; allowed: 2 to " TEXT_OF(OWN_ROWS_MOST) "; leave out rows that "
                                                                                              "are close together",
                    path, (long)rows, rows == 1 ? "" : "s");
    return rows < 2 || rows > OWN_ROWS_MOST ? 0 : rows;
}

/* Computes the slope at the first or the last row from the secants d and the widths h of the two nearest intervals,
 * nearest first. It is the slope of the parabola through three rows, limited so that the cubic stays monotone. */
static void end_slope(fmpq_t slope, const fmpq_t d0, const fmpq_t d1, const fmpq_t h0, const fmpq_t h1)
{
    LOCAL(fmpq, rest);
    EXACT(slope, "((2*h0 + h1)*d0 - h0*d1)/(h0 + h1)", h0, h1, d0, d1);
    EXACT(rest, "slope*slope - 9*d0*d0", slope, d0);
    if (fmpq_sgn(slope) != fmpq_sgn(d0))
        fmpq_zero(slope);
    else if (fmpq_sgn(d0) != fmpq_sgn(d1) && fmpq_sgn(rest) > 0)
        EXACT(slope, "3*d0", d0);
}

/* Sets the cubics of a table of two rows or more. */
static void set_cubics(struct own_law *law, const fmpq *speed, const fmpq *eps)
{
    const slong last = law->rows - 1;
    fmpq *const h = _fmpq_vec_init(3 * law->rows), *const d = h + law->rows, *const slope = d + law->rows;
    for (slong i = 0; i < last; i++) {
        const fmpq *const x = speed + i, *const next = x + 1, *const y = eps + i, *const above = y + 1,
                          *const width = h + i;
        EXACT(h + i, "next - x", next, x);
        EXACT(d + i, "(above - y)/width", above, y, width);
    }
    for (slong i = 1; i < last; i++) {
        const fmpq *const h0 = h + i - 1, *const h1 = h + i, *const d0 = d + i - 1, *const d1 = d + i;
        if (fmpq_sgn(d0) * fmpq_sgn(d1) > 0)
            EXACT(slope + i, "3*(h0 + h1)/((2*h1 + h0)/d0 + (h1 + 2*h0)/d1)", h0, h1, d0, d1);
    }
    end_slope(slope, d, last > 1 ? d + 1 : d, h, last > 1 ? h + 1 : h);
    end_slope(slope + last, d + last - 1, last > 1 ? d + last - 2 : d, h + last - 1, last > 1 ? h + last - 2 : h);
    for (slong i = 0; i <= last; i++) {
        law->speed[i] = decimal_nearest(speed + i);
        law->place[i] = log(law->speed[i]);
    }
    for (slong i = 0; i < last; i++) {
        const fmpq *const width = h + i, *const secant = d + i, *const first = slope + i, *const next = first + 1;
        arb_ptr c = law->cubic + CUBIC * i;
        arb_set_fmpq(c, speed + i, CUBIC_BITS);
        arb_set_fmpq(c + 1, eps + i, CUBIC_BITS);
        arb_set_fmpq(c + 2, first, CUBIC_BITS);
        LET(c + 3, CUBIC_BITS, "(3*secant - 2*first - next)/width", secant, first, next, width);
        LET(c + 4, CUBIC_BITS, "(first + next - 2*secant)/width^2", secant, first, next, width);
    }
    for (slong i = 0; i < CUBIC * last; i++)
        law->near[i] = ball_middle(law->cubic + i);
    _fmpq_vec_clear(h, 3 * law->rows);
}

static int init_table(struct own_law *law, const char *path)
{
    struct table t = {0};
    fmpq *const number = _fmpq_vec_init(2 * OWN_ROWS_MOST);
    if (table_read(&t, "table", path, "speed_m_s,eps", 2, true) == STATUS_OK)
        law->rows = read_rows(number, number + OWN_ROWS_MOST, &t, path);
    if (law->rows > 0) {
        law->speed = xmalloc((2 + CUBIC) * (size_t)law->rows * sizeof *law->speed);
        law->place = law->speed + law->rows;
        law->near = law->place + law->rows;
        set_cubics(law, number, number + OWN_ROWS_MOST);
        law->part = law->speed;
        law->parts = law->rows;
        snprintf(law->text, sizeof law->text, "eps of the %ld rows of %s, monotone cubics of the speed",
                 (long)law->rows, path);
    }
    _fmpq_vec_clear(number, 2 * OWN_ROWS_MOST);
    table_clear(&t);
    return law->rows > 0 ? STATUS_OK : STATUS_USAGE;
}

/* ---- a law ---- */

static const struct form {
    int first, second; /* indices of the parameters in request->number; -1: none */
    const char *options, *formula, *text;
} forms[] = {{EMBED_COEFFICIENT, EMBED_EXPONENT,
              "--coefficient A --exponent B, for example --coefficient 0.1157 --exponent 0.234", "exp(-x*b)*a",
              "eps = min(1, A v^-B), A = %s, B = %s, v in m/s"},
             {EMBED_EPS_INF, EMBED_DECAY_SPEED,
              "--eps-inf E --decay-speed V, for example --eps-inf 0.3 --decay-speed 0.01", "exp(-exp(x)/b)*(1 - a) + a",
              "eps = E + (1 - E) exp(-v/V), E = %s, V = %s m/s"},
             {-1, -1, "--table FILE, a csv file with the columns speed_m_s,eps",
              "(((exp(x) - k)*c3 + c2)*(exp(x) - k) + c1)*(exp(x) - k) + c0", NULL}};

int own_law_init(struct own_law *law, const struct embed_request *request)
{
    *law = (struct own_law){0};
    for (int i = 0; i < 3; i++) {
        const struct form *const f = &forms[i];
        const bool chosen = request->law == EMBED_LAW_POWER + i, table = f->first < 0;
        const int given =
            table ? 2 * (request->table != NULL) : embed_given(request, f->first) + embed_given(request, f->second);
        if (!chosen && given > 0)
            return usage_error("--law %s has no %.*s; --law %s has %s", embed_law_names[request->law],
                               (int)strcspn(f->options, " "), f->options, embed_law_names[EMBED_LAW_POWER + i],
                               f->options);
        if (chosen && given < 2)
            return usage_error("--law %s needs %s", embed_law_names[request->law], f->options);
        if (!chosen)
            continue;
        law->law = request->law;
        law->formula = f->formula;
        law->number = _fmpq_vec_init(2);
        law->cubic = _arb_vec_init(CUBIC * OWN_ROWS_MOST);
        if (table)
            continue;
        fmpq_set(law->number, request->number[f->first].value);
        fmpq_set(law->number + 1, request->number[f->second].value);
        for (int k = 0; k < 2; k++)
            law->real[k] = decimal_nearest(law->number + k);
        if (law->law == EMBED_LAW_POWER && !fmpq_is_zero(law->number + 1) && fabs(law->real[1]) < 1e-9)
            return usage_error("--exponent: '%s' is too close to 0; allowed: 0, and 1e-9 to 100 with either sign",
                               request->number[f->second].text);
        snprintf(law->text, sizeof law->text, f->text, request->number[f->first].text, request->number[f->second].text);
    }
    if (!law->law)
        return STATUS_OK;
    LOCAL(arb, onset);
    own_law_onset(onset, law, CUBIC_BITS);
    law->part = law->own_part;
    law->parts = law->law == EMBED_LAW_POWER ? arb_is_finite(onset) : law->law == EMBED_LAW_EXPONENTIAL ? 6 : 0;
    for (int k = 0; k < law->parts; k++)
        law->own_part[k] = law->law == EMBED_LAW_POWER ? ball_middle(onset) : ldexp(law->real[1], k);
    return law->law == EMBED_LAW_TABLE ? init_table(law, request->table) : STATUS_OK;
}

void own_law_clear(struct own_law *law)
{
    if (law->law) {
        _fmpq_vec_clear(law->number, 2);
        _arb_vec_clear(law->cubic, CUBIC * OWN_ROWS_MOST);
    }
    free(law->speed);
    *law = (struct own_law){0};
}

int own_law_check(const struct own_law *law, double speed_min, double speed_max)
{
    const bool slow = law->rows > 0 && speed_min < law->speed[0];
    if (!slow && !(law->rows > 0 && speed_max > law->speed[law->rows - 1]))
        return STATUS_OK;
    char speed[DECIMAL_TEXT], low[DECIMAL_TEXT], high[DECIMAL_TEXT];
    return usage_error("%s m/s is outside the speeds of the table; allowed: %s to %s m/s",
                       decimal_text(speed, slow ? speed_min : speed_max), decimal_text(low, law->speed[0]),
                       decimal_text(high, law->speed[law->rows - 1]));
}

/* ---- its values ---- */

slong own_law_row(double *end, const struct own_law *law, double x)
{
    slong row = 0;
    while (row + 2 < law->rows && law->place[row + 1] <= x)
        row++;
    *end = row + 2 < law->rows ? law->place[row + 1] : HUGE_VAL;
    return row;
}

/* The operands of a formula */
#define OPERANDS_OF(law, row)                                                                                          \
    const fmpq *const a = (law)->number, *const b = a + 1;                                                             \
    const arb_srcptr k = (law)->cubic + CUBIC * (row), c0 = k + 1, c1 = k + 2, c2 = k + 3, c3 = k + 4

bool own_law_function(arb_poly_t eps, const arb_poly_t x, const struct own_law *law, slong row)
{
    OPERANDS_OF(law, row);
    return LET_FUNCTION(eps, law->formula, x, a, b, k, c0, c1, c2, c3);
}

void own_law_eps(arb_t eps, const struct own_law *law, const arb_t speed, slong prec)
{
    LOCAL(arb, x);
    double end;
    arb_log(x, speed, prec);
    OPERANDS_OF(law, own_law_row(&end, law, ball_middle(x)));
    LET(eps, prec, law->formula, x, a, b, k, c0, c1, c2, c3);
    LET(eps, prec, "min(1, eps)", eps);
}

double own_law_value(const struct own_law *law, double speed)
{
    const double a = law->real[0], b = law->real[1], power = pow(speed, -b);
    double end;
    if (law->law == EMBED_LAW_POWER && !(power > 1e-290 && power < 1e290)) {
        LOCAL(arb, x);
        arb_set_d(x, speed);
        own_law_eps(x, law, x, CUBIC_BITS);
        return ball_middle(x);
    }
    if (law->law != EMBED_LAW_TABLE)
        return law->law == EMBED_LAW_POWER ? fmin(1, a * power) : a + (1 - a) * exp(-speed / b);
    const double *const c = law->near + CUBIC * own_law_row(&end, law, log(speed)), t = speed - c[0];
    return fmin(1, c[1] + t * (c[2] + t * (c[3] + t * c[4])));
}

void own_law_onset(arb_t speed, const struct own_law *law, slong prec)
{
    const fmpq *const a = law->number, *const b = a + 1;
    arb_indeterminate(speed);
    if (law->law == EMBED_LAW_POWER && !fmpq_is_zero(b))
        LET(speed, prec, "a^(1/b)", a, b);
}
