/* SPDX-License-Identifier: MIT */
/* What few modes and a soft wall leave out, and what they save: eps against the limit of all modes at a hard wall,
 * which comes from the library's table of limits, and no closer than that is known. */
#include <math.h>

#include <cor/status.h>

#include "collision.h"
#include "stages.h"

static const double model_tolerance = 1e-4;

struct model {
    double speed, alpha;
    size_t n;
    double eps;
};

static void model_collide(void *closure)
{
    struct model *const m = closure;
    struct cor_disk_collision out;
    collision_with_cor(&cor_disk_modes_nu033, m->n, m->alpha, m->speed, model_tolerance, &out);
    m->eps = out.eps;
}

static void limit(void *closure)
{
    struct model *const m = closure;
    m->eps = cor_disk_eps(m->speed, cor_disk_modes_nu033.nu);
}

static void perturbation(void *closure)
{
    struct model *const m = closure;
    struct cor_disk_rayleigh out;
    const int status =
        cor_disk_rayleigh_tolerance(&cor_disk_modes_nu033, COR_DISK_DATUM_CENTRE_OF_MASS, m->speed, 1e-3, &out, &m->n);
    disk_must(status == COR_OK || status == COR_BEYOND_THEORY, cor_status_text(status));
    m->eps = sqrt(1 - out.fraction - out.tail);
}

void collision_models(struct disk_bench *bench)
{
    enum { SPEEDS = 2, SIZES = 6, WALLS = 5, MODELS = 2 + SIZES * WALLS };
    static const double speeds[SPEEDS] = {0.1, 0.01}, softest[SPEEDS] = {125, 500};
    for (int k = 0; k < SPEEDS; k++) {
        struct model model[MODELS] = {{.speed = speeds[k]}, {.speed = speeds[k]}};
        struct job job[MODELS] = {{limit, &model[0], 1, NAN}, {perturbation, &model[1], 1, NAN}};
        for (int i = 2; i < MODELS; i++) {
            const int size = (i - 2) / WALLS, wall = (i - 2) % WALLS;
            model[i] = (struct model){.speed = speeds[k], .alpha = ldexp(softest[k], wall), .n = (size_t)1800 >> size};
            job[i] = (struct job){model_collide, &model[i], 1, NAN};
        }
        timing_measure(job, MODELS, collision_timing(bench));
        const double exact = model[0].eps;
        const double unsure = cor_disk_eps_uncertainty(speeds[k], cor_disk_modes_nu033.nu);
        for (int i = 0; i < MODELS; i++) {
            static const char *const methods[] = {"cor_disk_eps", "Rayleigh", "cor"};
            const struct model *const m = &model[i];
            const double error = fmax(fabs(m->eps - exact), unsure);
            disk_csv(bench, &(struct disk_row){"collision models", methods[i < 2 ? i : 2], m->speed,
                                               m->alpha > 0 ? m->alpha : NAN, m->n, job[i].best_ns / 1e9, error});
        }
    }
}
