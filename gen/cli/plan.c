/* SPDX-License-Identifier: MIT */
/* corgen plan: which model of a collision a scene needs, what it costs and leaves out. */
#include "plan/plan.h"
#include "support/console.h"

int command_plan(const struct options *o)
{
    struct plan plan;
    int status = o->disks ? plan_disks(&plan, o) : plan_spheres(&plan, o);
    struct output out;
    if (status == STATUS_OK)
        status = output_open(&out, o->output);
    if (status == STATUS_OK) {
        plan_print(&plan, o->format, out.file);
        status = output_commit(&out);
    }
    if (status == STATUS_OK && plan.chosen < 0)
        status = fail("no model meets the tolerance %s", o->real[OPTIONS_TOLERANCE]);
    if (!o->disks)
        plan_spheres_clear(&plan);
    plan_clear(&plan);
    return status;
}
