/* SPDX-License-Identifier: MIT */
#include "runtime/disk/collision_parts.h"

#include <math.h>

/* ---- sizes ---- */

static double phi_needed(double alpha, double tolerance, double speed, size_t n_max)
{
    const double fast = speed / 0.1, digits = fmax(-log10(tolerance), 3);
    return pow(alpha, 2.0 / 3) * (COR_TUNING_PHI_PER_DIGIT * digits - COR_TUNING_PHI_OFFSET) *
               pow(fast, fast < 1 ? COR_TUNING_PHI_SLOW : COR_TUNING_PHI_FAST) +
           COR_TUNING_PHI_PER_N * (double)n_max;
}

size_t cor_motion_phi_limit(const struct cor_disk_collision_options *options, size_t n_max)
{
    if (options->phi_points > 0)
        return options->phi_points;
    const double limit =
        COR_TUNING_PHI_LIMIT * phi_needed(options->alpha, options->tolerance, COR_DISK_COLLISION_MAX_SPEED, n_max);
    return (size_t)fmin(fmax(limit, COR_TUNING_LEAST_PHI), COR_DISK_COLLISION_MAX_PHI_POINTS);
}

size_t cor_motion_first_phi(const struct cor_motion *m, const struct cor_disk_collision_options *options)
{
    const double phi = fmax(phi_needed(m->alpha, m->tolerance, m->speed, m->size.n_max), COR_TUNING_LEAST_PHI);
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
    size.cells = cor_mode_blocks(mode, modes, size.blocks, NULL);
    size.terms = cor_whole(size.n_max + 2, COR_PANEL);
    size.points = cor_whole(cor_motion_phi_limit(options, size.n_max), COR_PANEL);
    return size;
}

/* ---- memory ---- */

size_t cor_motion_arrange(struct cor_motion *m, char *base)
{
    const struct cor_motion_sizes *size = &m->size;
    const size_t lanes = size->blocks * COR_LANES;
    struct cor_store store = {base, 0};
    m->place = cor_store_take(&store, size->modes, sizeof *m->place);
    m->block = cor_store_take(&store, size->blocks, sizeof *m->block);
    COR_STORE_TAKE_DOUBLES(&store, size->cells, &m->c, &m->s, &m->q, &m->p, &m->cosine, &m->sine);
    COR_STORE_TAKE_DOUBLES(&store, lanes, &m->force_c, &m->force_s, &m->sum_c, &m->sum_s, &m->cc, &m->cs, &m->ss);
    COR_STORE_TAKE_DOUBLES(&store, size->terms + lanes, &m->d, &m->e);
    COR_STORE_TAKE_DOUBLES(&store, size->points, &m->shape, &m->flat, &m->weight, &m->reach, &m->pressure,
                           &m->response);
    COR_STORE_TAKE_DOUBLES(&store, size->points * size->terms, &m->by_point, &m->by_term);
    COR_STORE_TAKE_DOUBLES(&store, 8 * size->points, &m->table);
    for (size_t i = 0; i < COR_COLLISION_LEVELS; i++)
        COR_STORE_TAKE_DOUBLES(&store, size->modes, &m->after[i], &m->average[i]);
    return store.used;
}

/* ---- tables ---- */

/* Reach in array elements beyond the last angle, so low that the pressure there is 0 */
#define NOWHERE (-1e6)

void cor_motion_set_modes(struct cor_motion *m)
{
    const struct cor_motion_sizes *size = &m->size;
    cor_mode_blocks(m->mode, size->modes, size->blocks, m->block);
    cor_mode_places(m->mode, size->modes, size->blocks, m->block, m->sum_c, m->place);
    COR_CLEAR_DOUBLES(size->cells, m->c, m->s);
    COR_CLEAR_DOUBLES(size->blocks * COR_LANES, m->cc, m->cs, m->ss);
    for (size_t i = 0; i < size->modes; i++) {
        const struct cor_disk_mode *mode = &m->mode[i];
        const size_t n = (size_t)mode->n;
        const double unit = 1 / sqrt(COR_DISK_MASS * mode->omega);
        m->c[m->place[i]] = unit * mode->c;
        m->s[m->place[i]] = unit * mode->s;
        m->cc[n] += mode->c * mode->c / COR_DISK_MASS;
        m->cs[n] += mode->c * mode->s / COR_DISK_MASS;
        m->ss[n] += mode->s * mode->s / COR_DISK_MASS;
    }
}

void cor_motion_set_angles(struct cor_motion *m, size_t phi, size_t shift)
{
    const size_t terms = m->size.terms, points = cor_whole(phi, COR_PANEL), half = 2 * phi;
    m->phi = phi;
    /* Cosines over a whole turn, a quarter in each of four parts. Their step is half the distance between angles. */
    for (size_t i = 0; i < half; i++) {
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
            /* NOLINTNEXTLINE(clang-analyzer-core.DivideZero): phi > 0 */
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
    /* The four terms: reach, exponential and search at each angle; two transforms and the response at each pressure;
     * the modes; a constant for each step */
    return (double)reached * (used + 90) + (double)pressed * (2 * terms + used + 10) + 20 * (double)m->size.cells +
           2000;
}
