/* SPDX-License-Identifier: MIT */
/* Contact of the rim with a rigid wall: y >= 0, reach - K y <= 0, y (reach - K y) = 0, where the positive definite
 * matrix K is the compliance that acts at once. docs/theory-disks.md, 17.
 *
 * Nearly always the contact is one piece, angles 0 to m - 1. K = L L' (Cholesky). The leading block of L is the factor
 * of the leading block of K, so one L serves every m. z = L^-1 reach determines m: If angles 0 to j - 1 are in contact,
 * z_j <= 0 means that angle j is not. The solver then checks that no force pulls and that no other angle reaches into
 * the wall. If a check fails, block principal pivoting (Judice and Pires, 1994) finds the contact, starting from the
 * contact of the previous step. */
#include <math.h>
#include <string.h>

#include "runtime/disk/hard_wall_parts.h"

/* PATIENCE: number of rounds of pivoting without progress. In these rounds all wrong angles change sides. Then one
 * angle changes at a time, which always terminates (Murty). */
enum { PATIENCE = 10, MAX_ROUNDS = 10000 };
/* Pulling forces below this fraction of the largest force are rounding errors. */
#define FORCE_ROUNDING 1e-12

static size_t padded_size(size_t n)
{
    return cor_whole(n, COR_LANES);
}

/* Returns the index of the first element of row i. Row r has padded_size(r) elements. */
static size_t row_start(size_t i)
{
    const size_t lanes = COR_LANES, above = i > 0 ? i - 1 : 0, whole = above / lanes;
    return lanes * (lanes * whole * (whole + 1) / 2 + above % lanes * (whole + 1));
}

static void arrange_factor(struct cor_hard_wall_factor *factor, struct cor_store *store, size_t points)
{
    factor->below = cor_store_take(store, row_start(points), sizeof *factor->below);
    factor->pivot = cor_store_take(store, points, sizeof *factor->pivot);
    factor->angle = cor_store_take(store, points, sizeof *factor->angle);
    factor->rows = 0;
}

void cor_hard_wall_contact_arrange(struct cor_hard_wall_contact *contact, struct cor_store *store, size_t points)
{
    contact->points = points;
    COR_STORE_TAKE_DOUBLES(store, 3 * points, &contact->same, &contact->across, &contact->cosine);
    COR_STORE_TAKE_DOUBLES(store, points, &contact->far, &contact->z, &contact->row);
    contact->wanted = cor_store_take(store, points, sizeof *contact->wanted);
    contact->touches = cor_store_take(store, points, 1);
    contact->faulty = cor_store_take(store, points, 1);
    arrange_factor(&contact->whole, store, points);
    arrange_factor(&contact->part, store, points);
}

/* Sets table[points + x] = factor values[|x|]. */
static void mirror_table(size_t points, double factor, const double *values, double *table)
{
    for (size_t i = 0; i < points; i++)
        table[points - 1 - i] = factor * values[i + 1];
    for (size_t i = 0; i < 2 * points; i++)
        table[points + i] = factor * values[i];
}

void cor_hard_wall_contact_begin(struct cor_hard_wall_contact *contact, size_t t_terms, const double *t, size_t q_terms,
                                 const double *q, const struct cor_hard_wall_angles *angles, double constant,
                                 double *scratch)
{
    const size_t points = contact->points;
    contact->constant = constant;
    contact->loops->cosines(angles, t_terms, t, 2 * points, scratch);
    mirror_table(points, 1 / (8 * COR_PI), scratch, contact->same);
    contact->loops->cosines(angles, q_terms, q, 2 * points, scratch);
    mirror_table(points, 1 / (4 * COR_PI), scratch, contact->across);
    mirror_table(points, 0.5, angles->twice_cosine, contact->cosine);
    double greatest = 0;
    for (size_t i = 2 * points; i-- > 0;) {
        greatest = fmax(greatest, 2 * (fabs(contact->same[points + i]) + fabs(contact->across[points + i])));
        if (i < points)
            contact->far[i] = greatest + fabs(constant);
    }
    contact->whole.rows = contact->part.rows = 0;
    contact->pivotings = 0;
    contact->work = 0;
    contact->indefinite = 0;
    memset(contact->touches, 0, points);
    memset(contact->z, 0, points * sizeof *contact->z);
}

/* ---- the compliance and its factor ---- */

/* Computes the compliances between angle i and angles 0 to n - 1. */
static void compliance_row(const struct cor_hard_wall_contact *contact, size_t i, size_t n, double *row)
{
    const size_t minus = contact->points - i, plus = contact->points + i;
    const double *const same_minus = contact->same + minus, *const same_plus = contact->same + plus;
    const double *const across_minus = contact->across + minus, *const across_plus = contact->across + plus;
    const double *const cosine_minus = contact->cosine + minus, *const cosine_plus = contact->cosine + plus;
    for (size_t j = 0; j < n; j++)
        row[j] = (same_minus[j] + same_plus[j]) +
                 (across_plus[j] * cosine_minus[j] + across_minus[j] * cosine_plus[j]) + contact->constant;
}

/* Adds a row to the factor, for a further angle. */
static void append_row(struct cor_hard_wall_contact *contact, struct cor_hard_wall_factor *factor, size_t angle)
{
    const size_t i = factor->rows++;
    double *const row = factor->below + row_start(i);
    compliance_row(contact, angle, angle + 1, contact->row);
    factor->angle[i] = angle;
    memset(row, 0, padded_size(i) * sizeof *row);
    for (size_t k = 0; k < i; k++)
        row[k] = contact->row[factor->angle[k]];
    contact->work += 0.5 * (double)i * (double)i + 4 * (double)angle;
    for (size_t k = 0; k < i; k++)
        row[k] = (row[k] - contact->loops->dot(padded_size(k), factor->below + row_start(k), row)) * factor->pivot[k];
    const double rest = contact->row[angle] - contact->loops->dot(padded_size(i), row, row);
    contact->indefinite = contact->indefinite || !(rest > 0);
    factor->pivot[i] = rest > 0 ? 1 / sqrt(rest) : 0;
}

/* Returns element i of L^-1 right. z: the elements before it. */
static double solve_forward(struct cor_hard_wall_contact *contact, const struct cor_hard_wall_factor *factor, size_t i,
                            double right, const double *z)
{
    contact->work += (double)padded_size(i);
    return (right - contact->loops->dot(padded_size(i), factor->below + row_start(i), z)) * factor->pivot[i];
}

/* Replaces the n elements of z by L'^-1 z. */
static void solve_backward(struct cor_hard_wall_contact *contact, const struct cor_hard_wall_factor *factor, size_t n,
                           double *z)
{
    contact->work += 0.5 * (double)n * (double)n;
    for (size_t i = n; i-- > 0;) {
        z[i] *= factor->pivot[i];
        contact->loops->subtract(padded_size(i), z[i], factor->below + row_start(i), z);
    }
}

/* ---- the angles in contact ---- */

/* Returns the reach of angle j into the wall under the forces y on angles 0 to m - 1. */
static double reach_under(struct cor_hard_wall_contact *contact, size_t j, double reach, const double *y, size_t m)
{
    contact->work += 4 * (double)m;
    compliance_row(contact, j, m, contact->row);
    memset(contact->row + m, 0, (padded_size(m) - m) * sizeof *contact->row);
    return reach - contact->loops->dot(padded_size(m), contact->row, y);
}

/* True if no angle >= m reaches into the wall. Most angles are too far away for the forces to matter. */
static int is_clear_beyond(struct cor_hard_wall_contact *contact, const double *reach, double negligible,
                           const double *y, size_t m)
{
    double load = 0;
    for (size_t j = 0; j < m; j++)
        load += y[j];
    for (size_t j = m; j < contact->points; j++)
        if (reach[j] + load * contact->far[j - (m > 0 ? m - 1 : 0)] > negligible &&
            reach_under(contact, j, reach[j], y, m) > negligible)
            return 0;
    return 1;
}

/* Solves for a contact of one piece that starts at angle 0, and sets the number m of its angles. Returns 0 if the
 * contact is not of this form, otherwise 1. */
static int solve_whole(struct cor_hard_wall_contact *contact, const double *reach, double negligible, double *y,
                       size_t *pieces_end)
{
    const size_t points = contact->points;
    size_t m = 0;
    for (; m < points && !contact->indefinite; m++) {
        if (contact->whole.rows == m)
            append_row(contact, &contact->whole, m);
        contact->z[m] = solve_forward(contact, &contact->whole, m, reach[m], contact->z);
        if (!(contact->z[m] > 0))
            break;
    }
    *pieces_end = m;
    memset(y, 0, points * sizeof *y);
    memcpy(y, contact->z, m * sizeof *y);
    solve_backward(contact, &contact->whole, m, y);
    double greatest = 0, least = 0;
    for (size_t j = 0; j < m; j++) {
        greatest = fmax(greatest, y[j]);
        least = fmin(least, y[j]);
    }
    if (!(least >= -FORCE_ROUNDING * greatest))
        return 0;
    for (size_t j = 0; j < m; j++)
        y[j] = fmax(y[j], 0);
    return is_clear_beyond(contact, reach, negligible, y, m);
}

/* Sets contact->part to the factor of the angles in contact, and returns their number. Rows already in contact->part or
 * contact->whole are reused. */
static size_t factor_part(struct cor_hard_wall_contact *contact)
{
    struct cor_hard_wall_factor *const part = &contact->part;
    size_t n = 0, kept = 0, whole = 0;
    for (size_t j = 0; j < contact->points; j++)
        if (contact->touches[j])
            contact->wanted[n++] = j;
    while (kept < n && kept < part->rows && part->angle[kept] == contact->wanted[kept])
        kept++;
    while (whole < n && whole < contact->whole.rows && contact->wanted[whole] == whole)
        whole++;
    if (whole > kept) {
        memcpy(part->below + row_start(kept), contact->whole.below + row_start(kept),
               (row_start(whole) - row_start(kept)) * sizeof *part->below);
        memcpy(part->pivot + kept, contact->whole.pivot + kept, (whole - kept) * sizeof *part->pivot);
        memcpy(part->angle + kept, contact->wanted + kept, (whole - kept) * sizeof *part->angle);
        kept = whole;
    }
    part->rows = kept;
    while (part->rows < n)
        append_row(contact, part, contact->wanted[part->rows]);
    return n;
}

/* Computes the forces on the angles in contact. Their signs are arbitrary. */
static void solve_part(struct cor_hard_wall_contact *contact, const double *reach, double *y)
{
    const size_t n = factor_part(contact);
    double *const z = contact->z;
    memset(z, 0, contact->points * sizeof *z);
    for (size_t i = 0; i < n; i++)
        z[i] = solve_forward(contact, &contact->part, i, reach[contact->wanted[i]], z);
    solve_backward(contact, &contact->part, n, z);
    memset(y, 0, contact->points * sizeof *y);
    for (size_t i = 0; i < n; i++)
        y[contact->wanted[i]] = z[i];
}

/* Marks the angles whose force pulls or that reach into the wall. Returns their number. *last: the last of them. */
static size_t find_faults(struct cor_hard_wall_contact *contact, const double *reach, double negligible,
                          const double *y, size_t *last)
{
    size_t m = 0, faults = 0;
    double greatest = 0, load = 0;
    for (size_t j = 0; j < contact->points; j++)
        if (contact->touches[j]) {
            m = j + 1;
            greatest = fmax(greatest, fabs(y[j]));
            load += fabs(y[j]);
        }
    for (size_t j = 0; j < contact->points; j++) {
        const size_t apart = j >= m && m > 0 ? j - (m - 1) : 0;
        contact->faulty[j] = contact->touches[j] ? y[j] < -FORCE_ROUNDING * greatest
                             : reach[j] + load * contact->far[apart] > negligible
                                 ? reach_under(contact, j, reach[j], y, m) > negligible
                                 : 0;
        if (contact->faulty[j]) {
            faults++;
            *last = j;
        }
    }
    return faults;
}

static void contact_pivot(struct cor_hard_wall_contact *contact, const double *reach, double negligible, double *y)
{
    size_t fewest = contact->points + 1, last = 0;
    int patience = PATIENCE;
    for (int round = 0; round < MAX_ROUNDS && !contact->indefinite; round++) {
        solve_part(contact, reach, y);
        const size_t faults = find_faults(contact, reach, negligible, y, &last);
        if (faults == 0)
            break;
        if (faults < fewest) {
            fewest = faults;
            patience = PATIENCE;
        } else if (patience > 0) {
            patience--;
        }
        for (size_t j = patience > 0 ? 0 : last; j <= last; j++)
            if (contact->faulty[j])
                contact->touches[j] = !contact->touches[j];
    }
    for (size_t j = 0; j < contact->points; j++)
        y[j] = fmax(y[j], 0);
}

size_t cor_hard_wall_contact_solve(struct cor_hard_wall_contact *contact, const double *reach, double negligible,
                                   double *y)
{
    const size_t points = contact->points;
    size_t m;
    if (!solve_whole(contact, reach, negligible, y, &m)) {
        contact->pivotings++;
        contact_pivot(contact, reach, negligible, y);
        for (m = points; m > 0 && !(y[m - 1] > 0); m--)
            ;
    }
    for (size_t j = 0; j < points; j++)
        contact->touches[j] = y[j] > 0;
    return m;
}
