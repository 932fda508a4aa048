/* SPDX-License-Identifier: MIT */
#include "collision.h"

#include <cor/status.h>

int collision_with_cor(const struct cor_disk_modes *modes, size_t n_modes, double alpha, double speed, double tolerance,
                       struct cor_disk_collision *out)
{
    const struct cor_disk_collision_options options = {.alpha = alpha, .tolerance = tolerance};
    const int status = cor_disk_collision(modes, n_modes, &options, speed, out);
    disk_must(status == COR_OK || status == COR_TOLERANCE_NOT_REACHED, cor_status_text(status));
    return status;
}
