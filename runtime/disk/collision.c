/* SPDX-License-Identifier: MIT */
/* Full dynamics of a disk at a wall, (41) to (45): the public functions */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cor/status.h"
#include "runtime/disk/collision_parts.h"

/* Returns COR_OK, or the status of the first error in the table and the options. */
static int collision_check(const struct cor_disk_modes *modes, size_t n_modes,
                           const struct cor_disk_collision_options *options)
{
    const int status = options == NULL ? COR_ERROR_NULL : cor_disk_table_check(modes, n_modes);
    if (status != COR_OK)
        return status;
    if (!(isgreaterequal(options->tolerance, COR_DISK_COLLISION_MIN_TOLERANCE) && options->tolerance < 1))
        return COR_ERROR_TOLERANCE;
    if (!(isgreaterequal(options->alpha, COR_DISK_COLLISION_MIN_ALPHA) &&
          options->alpha <= COR_DISK_COLLISION_MAX_ALPHA))
        return COR_ERROR_ALPHA;
    if (options->phi_points > COR_DISK_COLLISION_MAX_PHI_POINTS)
        return COR_ERROR_PHI_POINTS;
    return COR_OK;
}

size_t cor_disk_collision_workspace(const struct cor_disk_modes *modes, size_t n_modes,
                                    const struct cor_disk_collision_options *options)
{
    if (collision_check(modes, n_modes, options) != COR_OK)
        return 0;
    struct cor_motion m;
    m.size = cor_motion_sizes(modes->mode, n_modes, options);
    return cor_motion_arrange(&m, NULL) + COR_ALIGNMENT; /* the workspace may begin at any address */
}

/* ---- data that do not depend on the speed ---- */

/* Sets up *m in the workspace, except for the speed and the angles. */
static int collision_prepare(struct cor_motion *m, void *workspace, size_t bytes, const struct cor_disk_modes *modes,
                             size_t n_modes, const struct cor_disk_collision_options *options)
{
    memset(m, 0, sizeof *m);
    m->size = cor_motion_sizes(modes->mode, n_modes, options);
    if (bytes < cor_motion_arrange(m, NULL) + COR_ALIGNMENT)
        return COR_ERROR_WORKSPACE;
    cor_motion_arrange(m, cor_store_aligned(workspace));
    m->mode = modes->mode;
    m->alpha = options->alpha;
    m->tolerance = options->tolerance;
    m->loops = cor_collision_set(cor_widest_set());
    m->phi_limit = cor_motion_phi_limit(options, m->size.n_max);
    cor_motion_set_modes(m);
    return COR_OK;
}

/* ---- one speed ---- */

static const struct cor_disk_collision collision_unknown = {NAN, NAN, NAN, NAN, NAN, 0, NAN};
static const struct cor_disk_collision collision_without_touch = {NAN, NAN, 0, NAN, 0, 0, NAN};

/* Computes a collision at one speed. Reuses the angles of the previous speed if their number is the same. */
static int collision_of_speed(struct cor_motion *m, const struct cor_disk_collision_options *options, double speed,
                              struct cor_disk_collision *out, const struct cor_disk_collision_detail *detail)
{
    *out = collision_unknown;
    if (!islessequal(speed, COR_DISK_COLLISION_MAX_SPEED))
        return COR_ERROR_SPEED;
    if (speed <= 0) {
        *out = collision_without_touch;
        return COR_WALL_NOT_TOUCHED;
    }
    m->speed = speed;
    m->work_per_step = options->max_steps > 0 ? 1 : 0;
    m->work_left = options->max_steps > 0 ? (double)options->max_steps : COR_TUNING_WORK;
    const size_t phi = cor_motion_first_phi(m, options);
    if (m->phi != phi)
        cor_motion_set_angles(m, phi, 0);
    return cor_collision_runs(m, out, detail);
}

int cor_disk_collision_in(void *workspace, size_t bytes, const struct cor_disk_modes *modes, size_t n_modes,
                          const struct cor_disk_collision_options *options, double speed,
                          struct cor_disk_collision *out, const struct cor_disk_collision_detail *detail)
{
    const int status = collision_check(modes, n_modes, options);
    if (status != COR_OK)
        return status;
    if (workspace == NULL || out == NULL)
        return COR_ERROR_NULL;
    if (!islessequal(speed, COR_DISK_COLLISION_MAX_SPEED))
        return COR_ERROR_SPEED;
    struct cor_motion m;
    const int prepared = collision_prepare(&m, workspace, bytes, modes, n_modes, options);
    return prepared != COR_OK ? prepared : collision_of_speed(&m, options, speed, out, detail);
}

/* ---- many speeds ---- */

int cor_disk_collision_array(const struct cor_disk_modes *modes, size_t n_modes,
                             const struct cor_disk_collision_options *options, const double *speed, size_t n,
                             struct cor_disk_collision *out, int *status)
{
    const int refused = collision_check(modes, n_modes, options);
    if (refused != COR_OK)
        return refused;
    if (n > 0 && (speed == NULL || out == NULL))
        return COR_ERROR_NULL;
    const size_t bytes = cor_disk_collision_workspace(modes, n_modes, options);
    void *const workspace = malloc(bytes);
    if (workspace == NULL)
        return COR_ERROR_MEMORY;
    struct cor_motion m;
    int first = collision_prepare(&m, workspace, bytes, modes, n_modes, options);
    for (size_t i = 0; i < n; i++) {
        const int of_speed = collision_of_speed(&m, options, speed[i], &out[i], NULL);
        if (status != NULL)
            status[i] = of_speed;
        if (first == COR_OK)
            first = of_speed;
    }
    free(workspace);
    return first;
}

int cor_disk_collision(const struct cor_disk_modes *modes, size_t n_modes,
                       const struct cor_disk_collision_options *options, double speed, struct cor_disk_collision *out)
{
    const int status = collision_check(modes, n_modes, options);
    if (status == COR_OK && out != NULL && !islessequal(speed, COR_DISK_COLLISION_MAX_SPEED))
        return COR_ERROR_SPEED; /* *out is unchanged */
    return cor_disk_collision_array(modes, n_modes, options, &speed, 1, out, NULL);
}
