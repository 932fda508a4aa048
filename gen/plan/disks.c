/* SPDX-License-Identifier: MIT */
/* Elastic disks: models from rigid disks without vibrations to collisions of many modes, compared with a rigid wall and
 * all modes */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cor/disk.h"
#include "cor/status.h"
#include "disk/modes.h"
#include "plan/plan.h"
#include "support/console.h"
#include "support/parallel.h"
#include "sweep/hard_wall.h"

/* Every number of modes is combined with every hardness alpha v. */
static const size_t counts[] = {10, 30, 100, 300, 940, 1800, 3600};
static const double hardness[] = {11, 22, 56};
/* Tolerances of the rigid wall on 1 - eps^2, and nanoseconds of a collision with given modes: the median of 30 speeds
 * from 0.001 to 0.3, measured once (docs/plan.md). */
static const struct {
    double tolerance, cost;
} rigid[] = {{1e-3, 4e6}, {1e-4, 7e6}, {1e-5, 5e7}, {1e-6, 5e8}};
enum {
    COUNTS = sizeof counts / sizeof *counts,
    WALLS = sizeof hardness / sizeof *hardness,
    RIGID = sizeof rigid / sizeof *rigid,
    QUANTITIES = 3 /* enum plan_quantity */
};
/* The reference is a rigid wall with this part of the requested tolerance, limited by these bounds. */
#define TRUTH_SHARE 0.02
#define FINEST_TRUTH 1e-6
#define COARSEST_TRUTH 1e-4
#define COARSEST_TRUTH_OF_OTHERS 1e-5 /* for quantities whose levels go beyond those of COARSE_TOLERANCE */
/* The uncertainty of the contact time and of the largest compression is twice their change from a rigid wall with this
 * tolerance, because the contact time converges like 1/Omega. */
#define COARSE_TOLERANCE 1e-3
#define LEAST_TOLERANCE 1e-6
#define MIN_SPEED 1e-3 /* a little below this speed, alpha v = 56 needs an alpha beyond COR_DISK_COLLISION_MAX_ALPHA */
#define COLLISION_TOLERANCE 1e-6
/* The paper's wall and number of modes. */
#define PAPER_ALPHA 500.0
#define PAPER_MODES ((size_t)940)

/* Nanoseconds of a step of a collision, and of each mode in a step, measured once (docs/plan.md). */
#define NS_STEP 1000.0
#define NS_STEP_MODE 4.0
#define NS_EPS_TABLE 14.0
#define NS_RAYLEIGH 80e3
#define NS_RAYLEIGH_MODE 45.0
static const double ns_law[QUANTITIES] = {0, 770, 130}, ns_leading_log[QUANTITIES] = {0, 40, 40};

struct outcome {
    double value[QUANTITIES]; /* eps, contact time, largest compression; NaN if unknown */
    double steps;
};

struct disks {
    const struct plan *plan;
    const struct plan_disks_request *request;
    struct cor_disk_modes modes;
    struct outcome *grid; /* [point][count][wall] */
    struct outcome *paper;
    struct outcome *truth; /* [point] */
    struct hard_wall_tables tables;
};

static struct outcome *outcome_at(const struct disks *d, slong point, int count, int wall)
{
    return &d->grid[(point * COUNTS + count) * WALLS + wall];
}

static double alpha_of(double hard, double speed)
{
    return fmax(COR_DISK_COLLISION_MIN_ALPHA, hard / speed);
}

static void disks_collide_one(const struct disks *d, struct outcome *out, size_t modes, double alpha, double speed)
{
    const struct cor_disk_collision_options options = {alpha, COLLISION_TOLERANCE, 0, 0};
    const size_t bytes = cor_disk_collision_workspace(&d->modes, modes, &options);
    void *const memory = xmalloc(bytes);
    struct cor_disk_collision c = {(double)NAN, (double)NAN, (double)NAN, (double)NAN, (double)NAN, 0, (double)NAN};
    cor_disk_collision_in(memory, bytes, &d->modes, modes, &options, speed, &c, NULL);
    free(memory);
    *out = (struct outcome){{c.eps, c.contact_time, c.max_compression}, (double)c.steps};
}

/* Task i: the collisions of one row of a point's grid, with the most modes first, or the paper's collision */
static void disks_collide_row(void *context, slong i)
{
    struct disks *const d = context;
    const slong points = d->plan->points, point = i % points;
    const double speed = d->plan->speed[point];
    const int count = COUNTS - 1 - (int)(i / points);
    if (count < 0) {
        disks_collide_one(d, &d->paper[point], PAPER_MODES, PAPER_ALPHA, speed);
        return;
    }
    for (int k = 0; k < WALLS; k++)
        disks_collide_one(d, outcome_at(d, point, count, k), counts[count], alpha_of(hardness[k], speed), speed);
}

static void disks_collide_all(struct plan *plan, struct disks *d)
{
    d->grid = xmalloc((size_t)plan->points * COUNTS * WALLS * sizeof *d->grid);
    d->paper = xmalloc((size_t)plan->points * sizeof *d->paper);
    parallel_for(disks_collide_row, d, plan->points * (COUNTS + 1), "collisions");
}

/* ---- the rigid wall ---- */

static int collide_rigid(struct disks *d, struct outcome *out, double *uncertainty, double tolerance, double speed)
{
    struct cor_disk_hard_wall h;
    const int status = hard_wall_collide(&h, &d->tables, tolerance, 0, speed);
    *out = (struct outcome){{h.eps, h.contact_time, h.max_compression}, 0};
    *uncertainty = h.error_estimate / (2 * h.eps);
    return status == COR_OK || status == COR_TOLERANCE_NOT_REACHED ? STATUS_OK : STATUS_FAILED;
}

static double truth_tolerance(const struct plan *plan, enum plan_quantity quantity)
{
    const double coarsest = quantity == PLAN_EPS ? COARSEST_TRUTH : COARSEST_TRUTH_OF_OTHERS;
    return fmin(fmax(TRUTH_SHARE * plan->tolerance, FINEST_TRUTH), coarsest);
}

static int find_truth(struct plan *plan, struct disks *d, slong i)
{
    const enum plan_quantity quantity = d->request->quantity;
    struct outcome coarse;
    double of_coarse;
    int status = collide_rigid(d, &d->truth[i], &plan->uncertainty[i], truth_tolerance(plan, quantity), plan->speed[i]);
    plan->truth[i] = d->truth[i].value[quantity];
    if (status == STATUS_OK && quantity != PLAN_EPS) {
        status = collide_rigid(d, &coarse, &of_coarse, COARSE_TOLERANCE, plan->speed[i]);
        plan->uncertainty[i] = 2 * fabs(coarse.value[quantity] / plan->truth[i] - 1);
    }
    if (status != STATUS_OK || !isfinite(plan->truth[i]) || !isfinite(plan->uncertainty[i]))
        return fail("the collision at speed %.4g with a rigid wall is not known", plan->speed[i]);
    return STATUS_OK;
}

/* ---- models ---- */

/* C statements that define `modes` and `v` */
static char *modes_text(const struct disks *d, size_t count)
{
    const char *poisson = d->request->poisson.text;
    if (count <= 1800 && (d->modes.nu == 0.33 || d->modes.nu == 0.9))
        return xprintf("#include \"cor/cor.h\"\nconst struct cor_disk_modes *modes = &cor_disk_modes_nu0%d;\n",
                       d->modes.nu == 0.33 ? 33 : 90);
    return xprintf("corgen tables --poisson %s --modes %zu\n"
                   "#include \"cor/cor.h\"\n/* read the file it writes by cor_disk_modes_read */\n"
                   "const struct cor_disk_modes *modes;\n",
                   poisson, count);
}

static const char *quantity_field(const struct disks *d)
{
    static const char *const fields[QUANTITIES] = {"eps", "contact_time", "max_compression"};
    return fields[d->request->quantity];
}

static void model_is(struct plan_model *m, double cost, const char *leaves_out, char *use)
{
    m->cost = cost;
    m->leaves_out = leaves_out;
    m->use = use;
}

static bool is_relative(const struct disks *d)
{
    return d->request->quantity != PLAN_EPS;
}

/* Adds a rigid wall: the error of eps is its promised bound, that of the other quantities the difference from the
 * reference. */
static int add_rigid(struct plan *plan, struct disks *d, int k)
{
    const enum plan_quantity quantity = d->request->quantity;
    struct plan_model *m = plan_add(plan, "rigid wall: tolerance %g", rigid[k].tolerance);
    int status = STATUS_OK;
    for (slong i = 0; i < plan->points && status == STATUS_OK; i++) {
        struct outcome out = d->truth[i];
        double uncertainty;
        if (quantity != PLAN_EPS)
            status = collide_rigid(d, &out, &uncertainty, rigid[k].tolerance, plan->speed[i]);
        m->value[i] = out.value[quantity];
        m->error[i] = rigid[k].tolerance / (2 * plan->truth[i]);
    }
    m->promised = quantity == PLAN_EPS;
    if (!m->promised)
        plan_compare(plan, m, true);
    model_is(m, rigid[k].cost, "nothing; estimated, not proved",
             xprintf("#include \"cor/cor.h\"\nstruct cor_disk_hard_wall_options options = {.tolerance = %g};\n"
                     "struct cor_disk_hard_wall out;\n"
                     "int status = cor_disk_hard_wall_nu(%s, &options, v, &out); /* out.%s */\n",
                     rigid[k].tolerance, d->request->poisson.text, quantity_field(d)));
    return status;
}

/* hard = 0 stands for the paper's wall */
static void add_dynamics(struct plan *plan, const struct disks *d, size_t modes, double hard, const char *leaves_out)
{
    int n = 0, k = 0;
    while (n < COUNTS - 1 && counts[n] != modes)
        n++;
    while (k < WALLS - 1 && !(hardness[k] >= hard))
        k++;
    struct plan_model *m = hard > 0 ? plan_add(plan, "dynamics: %zu modes; alpha = %g/v", modes, hard)
                                    : plan_add(plan, "dynamics: %zu modes; alpha = %g", modes, PAPER_ALPHA);
    double steps = 0;
    for (slong i = 0; i < plan->points; i++) {
        const struct outcome *out = hard > 0 ? outcome_at(d, i, n, k) : &d->paper[i];
        m->value[i] = out->value[d->request->quantity];
        steps += out->steps / (double)plan->points;
    }
    plan_compare(plan, m, is_relative(d));
    char *table = modes_text(d, modes), alpha[64];
    if (hard > 0)
        snprintf(alpha, sizeof alpha, "fmax(%d, %g / v)", COR_DISK_COLLISION_MIN_ALPHA, hard);
    else
        snprintf(alpha, sizeof alpha, "%g", PAPER_ALPHA);
    model_is(m, steps * (NS_STEP + NS_STEP_MODE * (double)modes), leaves_out,
             xprintf("%sstruct cor_disk_collision_options options = {.alpha = %s, .tolerance = %g};\n"
                     "struct cor_disk_collision out;\n"
                     "int status = cor_disk_collision(modes, %zu, &options, v, &out); /* out.%s */\n",
                     table, alpha, COLLISION_TOLERANCE, modes, quantity_field(d)));
    free(table);
}

static void add_all_dynamics(struct plan *plan, const struct disks *d)
{
    static const size_t soft[] = {300, 1800};
    for (size_t i = 0; i < COUNTS; i++)
        add_dynamics(plan, d, counts[i], hardness[WALLS - 1], "higher modes; some hardness of the wall");
    for (size_t i = 0; i < sizeof soft / sizeof *soft; i++)
        for (int k = 0; k < 2; k++)
            add_dynamics(plan, d, soft[i], hardness[k], "higher modes; much hardness of the wall");
    add_dynamics(plan, d, PAPER_MODES, 0, "higher modes; the wall is soft to slow disks");
}

static void add_rayleigh(struct plan *plan, const struct disks *d)
{
    static const size_t taken[] = {1, 10, 100, 1000};
    for (size_t k = 0; k < sizeof taken / sizeof *taken; k++) {
        struct plan_model *m = plan_add(plan, "Rayleigh: %zu mode%s and tail", taken[k], taken[k] > 1 ? "s" : "");
        const struct cor_disk_modes cut = {d->modes.nu, taken[k], d->modes.mode};
        for (slong i = 0; i < plan->points; i++) {
            struct cor_disk_rayleigh out;
            const int status =
                cor_disk_rayleigh(&cut, taken[k], COR_DISK_DATUM_CENTRE_OF_MASS, plan->speed[i], &out, NULL);
            /* beyond the contact law there is no result, beyond the theory more energy than before the collision */
            if (status == COR_OK || status == COR_BEYOND_THEORY)
                m->value[i] = sqrt(1 - (out.fraction + out.tail));
            m->outside = m->outside || status != COR_OK;
        }
        plan_compare(plan, m, false);
        char *table = modes_text(d, taken[k]);
        model_is(m, NS_RAYLEIGH + NS_RAYLEIGH_MODE * (double)taken[k], "that vibrations act back on the load",
                 xprintf("%sstruct cor_disk_modes cut = {modes->nu, %zu, modes->mode};\nstruct cor_disk_rayleigh out;\n"
                         "int status = cor_disk_rayleigh(&cut, %zu, COR_DISK_DATUM_CENTRE_OF_MASS, v, &out, NULL);\n"
                         "double eps = sqrt(1 - (out.fraction + out.tail));\n",
                         table, taken[k], taken[k]));
        free(table);
    }
}

static void add_constant(struct plan *plan, const char *name, const char *eps, const char *leaves_out)
{
    struct plan_model *const m = plan_add(plan, "%s", name);
    for (slong i = 0; i < plan->points; i++)
        m->value[i] = strtod(eps, NULL);
    plan_compare(plan, m, false);
    model_is(m, 0, leaves_out, xprintf("double eps = %s;\n", eps));
}

static void add_models_of_eps(struct plan *plan, const struct disks *d)
{
    double low = 1, high = 0;
    for (slong i = 0; i < plan->points; i++) {
        low = fmin(low, plan->truth[i]);
        high = fmax(high, plan->truth[i]);
    }
    char middle[32];
    snprintf(middle, sizeof middle, "%.6f", (low + high) / 2);
    add_constant(plan, "eps = 1", "1", "vibrations");
    add_constant(plan, "constant eps", middle, "how eps goes with the speed");
    add_rayleigh(plan, d);

    /* the error is the promised uncertainty, for what the table is compared with comes from the same collisions */
    struct plan_model *const m = plan_add(plan, "table: cor_disk_eps");
    m->outside = !(d->modes.nu >= COR_DISK_EPS_MIN_NU && d->modes.nu <= COR_DISK_EPS_MAX_NU);
    for (slong i = 0; i < plan->points; i++) {
        m->value[i] = cor_disk_eps(plan->speed[i], d->modes.nu);
        m->error[i] = (plan->speed[i] <= COR_DISK_EPS_CALM_SPEED ? COR_DISK_EPS_MAX_UNCERTAINTY
                                                                 : COR_DISK_EPS_MAX_UNCERTAINTY_FAST) /
                      (2 * plan->truth[i]);
        m->outside =
            m->outside || !(plan->speed[i] >= COR_DISK_EPS_MIN_SPEED && plan->speed[i] <= COR_DISK_EPS_MAX_SPEED);
    }
    m->promised = true;
    model_is(m, NS_EPS_TABLE, "nothing; estimated, not proved",
             xprintf("#include \"cor/cor.h\"\ndouble eps = cor_disk_eps(v, %s);\n", d->request->poisson.text));
}

typedef double law(double speed, double nu, enum cor_disk_datum datum);

static void add_laws(struct plan *plan, const struct disks *d)
{
    static const char *const name[] = {"centre of mass", "diameter", "as printed"};
    static const char *const datum[] = {"CENTRE_OF_MASS", "DIAMETER", "PRINTED"};
    const bool time = d->request->quantity == PLAN_CONTACT_TIME;
    law *const function = time ? cor_disk_contact_time : cor_disk_max_compression;
    const char *const called = time ? "cor_disk_contact_time" : "cor_disk_max_compression";
    struct plan_model *m = plan_add(plan, "leading logarithm (61)");
    for (slong i = 0; i < plan->points; i++)
        m->value[i] = (time ? cor_disk_contact_time_leading_log : cor_disk_max_compression_leading_log)(plan->speed[i]);
    plan_compare(plan, m, true);
    model_is(m, ns_leading_log[d->request->quantity], "all beside ln(4/v); vibrations",
             xprintf("#include \"cor/cor.h\"\ndouble %s = %s_leading_log(v);\n", quantity_field(d), called));
    for (int k = 0; k < 3; k++) {
        m = plan_add(plan, "quasistatic law: %s", name[k]);
        for (slong i = 0; i < plan->points; i++)
            m->value[i] = function(plan->speed[i], d->modes.nu, (enum cor_disk_datum)k);
        plan_compare(plan, m, true);
        model_is(m, ns_law[d->request->quantity], "vibrations",
                 xprintf("#include \"cor/cor.h\"\ndouble %s = %s(v, %s, COR_DISK_DATUM_%s);\n", quantity_field(d),
                         called, d->request->poisson.text, datum[k]));
    }
}

/* ---- the plan ---- */

static int read_range(double range[2], double *tolerance, const struct plan_disks_request *request)
{
    range[0] = decimal_value(&request->speed_min);
    range[1] = decimal_value(&request->speed_max);
    *tolerance = decimal_value(&request->tolerance);
    if (!(range[0] >= MIN_SPEED && range[1] <= COR_DISK_HARD_WALL_MAX_SPEED))
        return usage_error("--speed-min %s to --speed-max %s: models are compared from %g to %g, in sqrt(E/rho)",
                           request->speed_min.text, request->speed_max.text, MIN_SPEED, COR_DISK_HARD_WALL_MAX_SPEED);
    if (!(range[1] > range[0]))
        return usage_error("--speed-min %s is not below --speed-max %s", request->speed_min.text,
                           request->speed_max.text);
    if (!(*tolerance >= LEAST_TOLERANCE && *tolerance < 1))
        return usage_error("--tolerance %s is not from %g, the error of a collision here, to below 1",
                           request->tolerance.text, LEAST_TOLERANCE);
    return STATUS_OK;
}

static char *disks_title(const struct plan *plan, const struct disks *d)
{
    const slong last = plan->points - 1;
    double uncertainty = 0;
    for (slong i = 0; i <= last; i++)
        uncertainty = fmax(uncertainty, plan->uncertainty[i]);
    return xprintf("Disks of nu = %s at %s to %s sqrt(E/rho): %s from %.4g to %.4g,\n"
                   "of a disk of all its modes at a rigid wall, uncertain by %.1e%s.\n",
                   d->request->poisson.text, d->request->speed_min.text, d->request->speed_max.text, plan->quantity,
                   plan->truth[0], plan->truth[last], uncertainty, is_relative(d) ? ", relative" : "");
}

static int disks_fill(struct plan *plan, struct disks *d)
{
    static const char *const quantity[] = {"eps", "contact time", "largest compression"};
    d->truth = xmalloc((size_t)plan->points * sizeof *d->truth);
    hard_wall_tables_set(&d->tables, d->modes.nu);
    int status = STATUS_OK;
    for (slong i = 0; i < plan->points && status == STATUS_OK; i++) {
        plan->at[i] = plan->speed[i];
        status = find_truth(plan, d, i);
        progress("rigid walls", (long)i + 1, (long)plan->points);
    }
    progress_end();
    if (status != STATUS_OK)
        return status;
    disks_collide_all(plan, d);
    plan->argument = "speed";
    plan->quantity = quantity[d->request->quantity];
    plan->unit = is_relative(d) ? "relative error" : "error";
    plan->note =
        "Error: the largest of the points, two digits, rounded up; taken where error and uncertainty of what it is\n"
        "compared with are below 0.97 of the tolerance. Of cor_disk_eps and the rigid wall: what the library "
        "promises.\n"
        "More modes and harder walls tend to the truth from two sides, so that few modes at a soft wall may be right "
        "by\n"
        "accident.\n"
        "Cost: of a collision, from its steps and modes; all as measured once, docs/plan.md.\n";
    plan->title = disks_title(plan, d);
    if (d->request->quantity == PLAN_EPS)
        add_models_of_eps(plan, d);
    else
        add_laws(plan, d);
    add_all_dynamics(plan, d);
    for (int k = 0; k < RIGID && status == STATUS_OK; k++)
        status = add_rigid(plan, d, k);
    plan_choose(plan);
    return status;
}

int plan_disks(struct plan *plan, const struct plan_disks_request *request)
{
    *plan = (struct plan){.chosen = -1};
    double range[2], tolerance;
    int status = read_range(range, &tolerance, request);
    if (status != STATUS_OK)
        return status;
    plan_init(plan, request->points ? request->points : PLAN_DEFAULT_POINTS_DISKS, range[0], range[1]);
    plan->tolerance = tolerance;
    struct disks d = {.plan = plan, .request = request};
    hard_wall_tables_init(&d.tables);
    profile_step("modes");
    status = disk_modes_rounded(&d.modes, request->poisson.value, (slong)counts[COUNTS - 1]);
    profile_step("collisions");
    if (status == STATUS_OK) {
        status = disks_fill(plan, &d);
        free((void *)d.modes.mode);
    }
    profile_step(NULL);
    free(d.grid);
    free(d.paper);
    free(d.truth);
    hard_wall_tables_clear(&d.tables);
    return status;
}
