/* SPDX-License-Identifier: MIT */
#include "disk/limit_fit.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "support/console.h"

enum { TERMS_MAX = 6, LEAST_ALPHAS = 4, LEAST_COUNTS = 3 };

/* The terms beside L, u and w */
struct law {
    enum { EDGE_5_3, EDGE_4_3, EDGE_2, EDGE_NONE } edge; /* power of u in the second term */
    bool product, square;                                /* u w, w^2 */
};

/* Rows that a fit omits: those of one alpha or of one N, and those of softer walls */
struct without {
    double alpha, softer_than;
    size_t modes;
};

static bool is_used(const struct disk_limit_row *row, const struct without *without)
{
    return !isnan(row->one_minus_eps2) && row->alpha != without->alpha && row->alpha >= without->softer_than &&
           row->modes != without->modes;
}

/* u and w are divided by their largest values, so that no column is small. Powers are computed without pow(), whose
 * last bit depends on the library. */
static int terms_of(double term[TERMS_MAX], const struct law *law, double speed, const struct disk_limit_row *row)
{
    const double u = DISK_LIMIT_HARDNESS / (row->alpha * speed), w = sqrt(DISK_LIMIT_MODES / (double)row->modes);
    const double root = cbrt(u);
    int n = 0;
    term[n++] = 1;
    term[n++] = u;
    term[n++] = w;
    if (law->edge != EDGE_NONE)
        term[n++] = law->edge == EDGE_5_3 ? u * root * root : law->edge == EDGE_4_3 ? u * root : u * u;
    if (law->product)
        term[n++] = u * w;
    if (law->square)
        term[n++] = w * w;
    return n;
}

static double dot(const double *x, const double *y, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

/* Solves a least-squares problem by the Gram-Schmidt method, which orthogonalises each column twice. Returns false if
 * the columns are dependent. column holds `n` columns of `rows` numbers. y becomes the residual. */
static bool solve(double *x, double *column, int n, double *y, size_t rows)
{
    double r[TERMS_MAX][TERMS_MAX] = {{0}};
    for (int j = 0; j < n; j++) {
        double *const q = column + (size_t)j * rows;
        const double before = sqrt(dot(q, q, rows));
        for (int twice = 0; twice < 2; twice++)
            for (int k = 0; k < j; k++) {
                const double *const p = column + (size_t)k * rows;
                const double part = dot(p, q, rows);
                r[k][j] += part;
                for (size_t i = 0; i < rows; i++)
                    q[i] -= part * p[i];
            }
        r[j][j] = sqrt(dot(q, q, rows));
        if (!(r[j][j] > 1e-10 * before))
            return false;
        for (size_t i = 0; i < rows; i++)
            q[i] /= r[j][j];
    }
    for (int j = 0; j < n; j++) {
        const double *const q = column + (size_t)j * rows;
        x[j] = dot(q, y, rows);
        for (size_t i = 0; i < rows; i++)
            y[i] -= x[j] * q[i];
    }
    for (int j = n - 1; j >= 0; j--) {
        for (int k = j + 1; k < n; k++)
            x[j] -= r[j][k] * x[k];
        x[j] /= r[j][j];
    }
    return true;
}

/* The limit from one law. Returns false if the rows do not determine the limit. */
static bool fit(double *limit, double *residual, const struct law *law, const struct without *without, double speed,
                const struct disk_limit_row *row, size_t rows)
{
    double term[TERMS_MAX] = {0}, x[TERMS_MAX] = {0};
    size_t used = 0;
    for (size_t i = 0; i < rows; i++)
        used += is_used(&row[i], without);
    if (used == 0)
        return false;
    double *const column = xmalloc((TERMS_MAX + 1) * used * sizeof *column), *const y = column + TERMS_MAX * used;
    int n = 0;
    for (size_t i = 0, at = 0; i < rows; i++)
        if (is_used(&row[i], without)) {
            n = terms_of(term, law, speed, &row[i]);
            for (int j = 0; j < n; j++)
                column[(size_t)j * used + at] = term[j];
            y[at++] = row[i].one_minus_eps2;
        }
    const bool solved = used >= (size_t)n && solve(x, column, n, y, used);
    if (solved) {
        *limit = x[0];
        *residual = sqrt(dot(y, y, used) / (double)used);
    }
    free(column);
    return solved;
}

static bool is_first(const struct disk_limit_row *row, size_t i, bool of_alpha)
{
    for (size_t k = 0; k < i; k++)
        if (!isnan(row[k].one_minus_eps2) && (of_alpha ? row[k].alpha == row[i].alpha : row[k].modes == row[i].modes))
            return false;
    return !isnan(row[i].one_minus_eps2);
}

/* The third hardest wall; straight lines are fitted to this one and the harder ones. */
static double third_hardest(const struct disk_limit_row *row, size_t rows)
{
    double hardest[3] = {0, 0, 0};
    for (size_t i = 0; i < rows; i++)
        if (is_first(row, i, true)) {
            double alpha = row[i].alpha;
            for (int k = 0; k < 3; k++)
                if (alpha > hardest[k]) {
                    const double lower = hardest[k];
                    hardest[k] = alpha;
                    alpha = lower;
                }
        }
    return hardest[2];
}

static const struct law central = {EDGE_5_3, true, false}, straight = {EDGE_NONE, true, false};

/* Adds the square of the standard error of the limit. Each of n fits omits the rows of one alpha, or of one N. The
 * square is (n - 1)/n times the sum of the squared differences of their limits from the mean. */
static bool jackknife(double *square, bool of_alpha, double speed, const struct disk_limit_row *row, size_t rows)
{
    double limit, residual, sum = 0, sum_of_squares = 0, first = 0, n = 0;
    for (size_t i = 0; i < rows; i++) {
        const struct without one = {of_alpha ? row[i].alpha : 0, 0, of_alpha ? 0 : row[i].modes};
        if (!is_first(row, i, of_alpha))
            continue;
        if (!fit(&limit, &residual, &central, &one, speed, row, rows))
            return false;
        first = n > 0 ? first : limit; /* differences from the first limit are small, so that their squares lose no
                                        * digits */
        sum += limit - first;
        sum_of_squares += (limit - first) * (limit - first);
        n++;
    }
    *square += (n - 1) / n * fmax(sum_of_squares - sum * sum / n, 0);
    return true;
}

enum disk_limit_status disk_limit_fit(struct disk_limit *limit, double speed, const struct disk_limit_row *row,
                                      size_t rows)
{
    static const struct law others[] = {{EDGE_4_3, true, false}, {EDGE_2, true, false}, {EDGE_5_3, true, true}};
    static const struct without nothing = {0, 0, 0};
    size_t alphas = 0, counts = 0;
    for (size_t i = 0; i < rows; i++) {
        if (!(row[i].alpha * speed > DISK_LIMIT_HARDNESS && row[i].alpha < HUGE_VAL))
            return DISK_LIMIT_SOFT_WALL;
        if (row[i].modes < DISK_LIMIT_MODES)
            return DISK_LIMIT_FEW_MODES;
        alphas += is_first(row, i, true);
        counts += is_first(row, i, false);
    }
    struct disk_limit found = {0, 0, 0, 0};
    double other, residual;
    const struct without softer = {0, third_hardest(row, rows), 0};
    if (alphas < LEAST_ALPHAS || counts < LEAST_COUNTS ||
        !fit(&found.one_minus_eps2, &found.residual, &central, &nothing, speed, row, rows) ||
        !fit(&found.straight, &residual, &straight, &softer, speed, row, rows))
        return DISK_LIMIT_FEW_ROWS;
    for (size_t k = 0; k < sizeof others / sizeof *others; k++) {
        if (!fit(&other, &residual, &others[k], &nothing, speed, row, rows))
            return DISK_LIMIT_FEW_ROWS;
        found.uncertainty = fmax(found.uncertainty, fabs(other - found.one_minus_eps2));
    }
    double square = 0;
    if (!jackknife(&square, true, speed, row, rows) || !jackknife(&square, false, speed, row, rows))
        return DISK_LIMIT_FEW_ROWS;
    found.uncertainty += DISK_LIMIT_ERRORS * sqrt(square);
    *limit = found;
    return found.residual <= DISK_LIMIT_MAX_RESIDUAL ? DISK_LIMIT_OK : DISK_LIMIT_NO_LAW;
}

const char *disk_limit_text(enum disk_limit_status status)
{
    switch (status) {
    case DISK_LIMIT_OK:
        return "extrapolated";
    case DISK_LIMIT_SOFT_WALL:
        return "a wall is too soft: its alpha times the speed is not above 20";
    case DISK_LIMIT_FEW_MODES:
        return "a disk has fewer than 1800 modes";
    case DISK_LIMIT_FEW_ROWS:
        return "fewer than four hardnesses or three numbers of modes, or too few collisions of them";
    case DISK_LIMIT_NO_LAW:
        return "the collisions do not follow the laws: the fit is off by more than 2e-4";
    }
    return "no status of an extrapolation";
}
