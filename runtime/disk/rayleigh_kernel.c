/* SPDX-License-Identifier: MIT */
/* The loops of rayleigh_kernel.h as functions, for one instruction set (instruction_set.h) */
#include "runtime/disk/rayleigh_kernel.h"

static void panel(const struct cor_leg_path *path, const struct cor_leg_rule *rule, int steps, double top,
                  struct cor_leg *leg)
{
    if (path->from_zero)
        kernel_panel(path, 1, rule, steps, top, leg);
    else
        kernel_panel(path, 0, rule, steps, top, leg);
}

const struct cor_rayleigh_set COR_OF_SET(cor_rayleigh) = {
    COR_SET_NAME, panel, kernel_octaves, kernel_lines, kernel_weigh, kernel_sum, kernel_surface, kernel_blend,
};
