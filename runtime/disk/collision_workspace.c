/* SPDX-License-Identifier: MIT */
#include "runtime/disk/collision_workspace.h"

#include <math.h>
#include <string.h>

/* ---- sizes ---- */

static size_t whole_panels(size_t n)
{
    return (n + COR_PANEL - 1) / COR_PANEL * COR_PANEL;
}

/* Rows of a block: the largest number of modes with the same n in the block */
static size_t rows_of_block(const struct cor_disk_mode *mode, size_t modes, size_t block)
{
    size_t count[COR_LANES] = {0}, most = 0;
    for (size_t i = 0; i < modes; i++)
        if ((size_t)mode[i].n / COR_LANES == block)
            count[(size_t)mode[i].n % COR_LANES]++;
    for (size_t i = 0; i < COR_LANES; i++)
        most = count[i] > most ? count[i] : most;
    return most;
}

static double phi_needed(double alpha, double tolerance, double speed, size_t n_max)
{
    const double fast = speed / 0.1, digits = fmax(-log10(tolerance), 3);
    return pow(alpha, 2.0 / 3) * (cor_tuning.phi_per_digit * digits - cor_tuning.phi_offset) *
               pow(fast, fast < 1 ? cor_tuning.phi_slow : cor_tuning.phi_fast) +
           cor_tuning.phi_per_n * (double)n_max;
}

size_t cor_motion_phi_limit(const struct cor_disk_collision_options *options, size_t n_max)
{
    if (options->phi_points > 0)
        return options->phi_points;
    const double limit =
        cor_tuning.phi_limit * phi_needed(options->alpha, options->tolerance, COR_DISK_COLLISION_MAX_SPEED, n_max);
    return (size_t)fmin(fmax(limit, cor_tuning.least_phi), COR_DISK_COLLISION_MAX_PHI_POINTS);
}

size_t cor_motion_first_phi(const struct cor_motion *m, const struct cor_disk_collision_options *options)
{
    const double phi = fmax(phi_needed(m->alpha, m->tolerance, m->speed, m->size.n_max), cor_tuning.least_phi);
    return options->phi_points > 0 || phi > (double)m->phi_limit ? m->phi_limit : (size_t)phi;
}

struct cor_motion_sizes cor_motion_sizes(const struct cor_disk_mode *mode, size_t modes,
                                         const struct cor_disk_collision_options *options)
{
    struct cor_motion_sizes size = {modes, 0, 0, 0, 0, 0, 0};
    for (size_t i = 0; i < modes; i++) {
        size.n_max = (size_t)mode[i].n > size.n_max ? (size_t)mode[i].n : size.n_max;
        size.omega_max = fmax(size.omega_max, mode[i].omega);
    }
    size.blocks = size.n_max / COR_LANES + 1;
    for (size_t b = 0; b < size.blocks; b++)
        size.cells += rows_of_block(mode, modes, b) * COR_LANES;
    size.terms = whole_panels(size.n_max + 2);
    size.points = whole_panels(cor_motion_phi_limit(options, size.n_max));
    return size;
}

/* ---- memory ---- */

/* The place of n elements of `bytes` bytes, aligned, from *at on; advances *at. NULL if base is NULL. */
static void *workspace_take(char *base, size_t *at, size_t n, size_t bytes)
{
    void *const here = base == NULL ? NULL : base + *at;
    *at += (n * bytes + COR_COLLISION_ALIGNMENT - 1) / COR_COLLISION_ALIGNMENT * COR_COLLISION_ALIGNMENT;
    return here;
}

size_t cor_motion_arrange(struct cor_motion *m, char *base)
{
    const struct cor_motion_sizes *size = &m->size;
    const size_t lanes = size->blocks * COR_LANES, real = sizeof(double);
    size_t at = 0;
    m->place = workspace_take(base, &at, size->modes, sizeof *m->place);
    m->block = workspace_take(base, &at, size->blocks, sizeof *m->block);
    double **const of_cells[] = {&m->c, &m->s, &m->q, &m->p, &m->cosine, &m->sine};
    for (size_t i = 0; i < sizeof of_cells / sizeof *of_cells; i++)
        *of_cells[i] = workspace_take(base, &at, size->cells, real);
    double **const of_n[] = {&m->force_c, &m->force_s, &m->sum_c, &m->sum_s, &m->cc, &m->cs, &m->ss};
    for (size_t i = 0; i < sizeof of_n / sizeof *of_n; i++)
        *of_n[i] = workspace_take(base, &at, lanes, real);
    double **const of_terms[] = {&m->d, &m->e};
    for (size_t i = 0; i < sizeof of_terms / sizeof *of_terms; i++)
        *of_terms[i] = workspace_take(base, &at, size->terms + lanes, real);
    double **const of_points[] = {&m->shape, &m->flat, &m->weight, &m->reach, &m->pressure, &m->response};
    for (size_t i = 0; i < sizeof of_points / sizeof *of_points; i++)
        *of_points[i] = workspace_take(base, &at, size->points, real);
    m->by_point = workspace_take(base, &at, size->points * size->terms, real);
    m->by_term = workspace_take(base, &at, size->points * size->terms, real);
    m->table = workspace_take(base, &at, 8 * size->points, real);
    for (size_t i = 0; i < COR_COLLISION_LEVELS; i++) {
        m->after[i] = workspace_take(base, &at, size->modes, real);
        m->average[i] = workspace_take(base, &at, size->modes, real);
    }
    return at;
}

/* ---- tables ---- */

/* Reach of the places beyond the last angle, so low that they never have a pressure. */
#define NOWHERE (-1e6)

void cor_motion_set_modes(struct cor_motion *m)
{
    const struct cor_motion_sizes *size = &m->size;
    const size_t lanes = size->blocks * COR_LANES;
    size_t first = 0;
    for (size_t b = 0; b < size->blocks; b++) {
        m->block[b].first = first;
        m->block[b].rows = rows_of_block(m->mode, size->modes, b);
        first += m->block[b].rows;
    }
    memset(m->c, 0, size->cells * sizeof *m->c);
    memset(m->s, 0, size->cells * sizeof *m->s);
    memset(m->cc, 0, lanes * sizeof *m->cc);
    memset(m->cs, 0, lanes * sizeof *m->cs);
    memset(m->ss, 0, lanes * sizeof *m->ss);
    double *const filled = m->sum_c; /* number of filled rows of each lane */
    memset(filled, 0, lanes * sizeof *filled);
    for (size_t i = 0; i < size->modes; i++) {
        const struct cor_disk_mode *mode = &m->mode[i];
        const size_t n = (size_t)mode->n, row = (size_t)filled[n]++;
        const size_t cell = (m->block[n / COR_LANES].first + row) * COR_LANES + n % COR_LANES;
        const double unit = 1 / sqrt(COR_DISK_MASS * mode->omega);
        m->place[i] = cell;
        m->c[cell] = unit * mode->c;
        m->s[cell] = unit * mode->s;
        m->cc[n] += mode->c * mode->c / COR_DISK_MASS;
        m->cs[n] += mode->c * mode->s / COR_DISK_MASS;
        m->ss[n] += mode->s * mode->s / COR_DISK_MASS;
    }
}

void cor_motion_set_angles(struct cor_motion *m, size_t phi, size_t shift)
{
    const size_t terms = m->size.terms, points = whole_panels(phi), half = 2 * phi;
    m->phi = phi;
    for (size_t i = 0; i < half; i++) { /* half an interval between angles apart; each covers a quarter of a turn */
        m->table[i] = cos((double)i * (COR_PI / (4 * (double)phi)));
        m->table[half + i] = -sin((double)i * (COR_PI / (4 * (double)phi)));
        m->table[2 * half + i] = -m->table[i];
        m->table[3 * half + i] = -m->table[half + i];
    }
    for (size_t j = 0; j < points; j++) {
        const size_t at = 2 * j + shift;
        const double half_sine = sin((double)at * (COR_PI / (8 * (double)phi)));
        m->shape[j] = j < phi ? -2 * half_sine * half_sine : NOWHERE; /* cos(phi_j) - 1 */
        m->flat[j] = 0;
        m->weight[j] = at == 0 ? COR_PI / (2 * (double)phi) : j < phi ? COR_PI / (double)phi : 0;
        for (size_t k = 0; k < terms; k++) {
            const double value = j < phi && k < m->size.n_max + 2 ? m->table[k * at % (4 * half)] : 0;
            m->by_point[(j / COR_PANEL * terms + k) * COR_PANEL + j % COR_PANEL] = value;
            m->by_term[(k / COR_PANEL * points + j) * COR_PANEL + k % COR_PANEL] = value;
        }
    }
    const struct cor_rim rim = {m->size.blocks, m->block, m->c,        m->s,      m->size.n_max + 2,
                                terms,          points,   m->by_point, m->by_term};
    m->rim = rim;
}

double cor_motion_work(const struct cor_motion *m, size_t reached, size_t pressed)
{
    const double used = (double)(m->size.n_max + 2), terms = (double)m->size.terms;
    /* In this order: reach, exponential and search; two transforms and the response; the modes; a constant for each
     * step. */
    return (double)reached * (used + 90) + (double)pressed * (2 * terms + used + 10) + 20 * (double)m->size.cells +
           2000;
}
