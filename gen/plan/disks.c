/* SPDX-License-Identifier: MIT */
/* Compares models of elastic disks, from disks without vibrations to collisions of many modes, with the collision of
 * all modes with a rigid wall. */
#include <math.h>
#include <stdlib.h>

#include "cor/disk.h"
#include "cor/status.h"
#include "disk/modes.h"
#include "plan/plan.h"
#include "support/console.h"
#include "support/parallel.h"
#include "sweep/hard_wall.h"

/* Collisions with a soft wall of alpha = hardness/v; hardness 0: alpha is PAPER_ALPHA */
#define SOME "higher modes; the wall is a little too soft"
#define MUCH "higher modes; the wall is much too soft"
static const struct {
    size_t modes;
    double hardness;
    const char *leaves_out;
} dynamics[] = {{10, 56, SOME},   {30, 56, SOME},   {100, 56, SOME},
                {300, 56, SOME},  {940, 56, SOME},  {1800, 56, SOME},
                {3600, 56, SOME}, {300, 11, MUCH},  {300, 22, MUCH},
                {1800, 11, MUCH}, {1800, 22, MUCH}, {940, 0, "higher modes; the wall is too soft for slow disks"}};
#define PAPER_ALPHA 500.0
/* Rigid wall. tolerance: of 1 - eps^2. cost: nanoseconds of a collision, which include the computation of its modes;
 * the median of 60 scenes of bench/run, measured once (docs/speed) */
static const struct {
    double tolerance, cost;
} rigid[] = {{1e-3, 7.3e6}, {1e-4, 1e7}, {1e-5, 3.9e7}, {1e-6, 9.8e8}};
enum {
    DYNAMICS = sizeof dynamics / sizeof *dynamics,
    RIGID = sizeof rigid / sizeof *rigid,
    MOST_MODES = 3600,
    QUANTITIES = 3 /* enum plan_quantity */
};
/* The reference is a rigid wall. Its tolerance is TRUTH_SHARE of the requested tolerance, but at least FINEST_TRUTH and
 * at most COARSEST_TRUTH. */
#define TRUTH_SHARE 0.02
#define FINEST_TRUTH 1e-6
#define COARSEST_TRUTH 1e-4
#define COARSEST_TRUTH_OF_OTHERS 1e-5 /* for contact time and compression; finer than COARSE_TOLERANCE */
/* The uncertainty of the contact time and of the largest compression is twice the difference from the result with this
 * tolerance. Reason: the contact time converges like 1/Omega (Omega: highest frequency). */
#define COARSE_TOLERANCE 1e-3
#define LEAST_TOLERANCE 1e-6
#define MIN_SPEED 1e-3 /* keeps alpha = 56/v below COR_DISK_COLLISION_MAX_ALPHA */
#define COLLISION_TOLERANCE 1e-6
/* Nanoseconds, measured once (docs/plan.md). A step of a collision takes NS_STEP, and NS_STEP_MODE for each mode. */
#define NS_STEP 1000.0
#define NS_STEP_MODE 4.0
#define NS_EPS_TABLE 14.0
#define NS_RAYLEIGH 80e3
#define NS_RAYLEIGH_MODE 45.0
#define NS_LEADING_LOG 40.0
/* name: of a quantity. field: of struct cor_disk_collision. ns_law: cost of the quasistatic law in nanoseconds */
static const struct {
    const char *name, *field;
    double ns_law;
} quantities[QUANTITIES] = {
    {"eps", "eps", 0}, {"contact time", "contact_time", 770}, {"largest compression", "max_compression", 130}};

struct disks {
    struct plan *plan;
    const struct decimal *number; /* the request's numbers */
    enum plan_quantity quantity;
    struct cor_disk_modes modes;
    struct cor_disk_collision *collision; /* [dynamics][point] */
    struct hard_wall_tables tables;
};

/* ---- the collisions ---- */

/* Collides disks with a soft wall at one point of the plan. The costliest models come first. */
static void collide_soft(void *context, slong i)
{
    struct disks *const d = context;
    const slong points = d->plan->points, k = DYNAMICS - 1 - i / points, point = i % points;
    const double speed = d->plan->speed[point], hardness = dynamics[k].hardness;
    const double alpha = hardness > 0 ? fmax(COR_DISK_COLLISION_MIN_ALPHA, hardness / speed) : PAPER_ALPHA;
    const struct cor_disk_collision_options options = {alpha, COLLISION_TOLERANCE, 0, 0};
    struct cor_disk_collision *const out = &d->collision[k * points + point];
    *out = (struct cor_disk_collision){NAN, NAN, NAN, NAN, NAN, 0, NAN};
    cor_disk_collision(&d->modes, dynamics[k].modes, &options, speed, out);
}

static double quantity_of(const struct disks *d, double eps, double contact_time, double max_compression)
{
    const double value[QUANTITIES] = {eps, contact_time, max_compression};
    return value[d->quantity];
}

/* Collides a disk with the rigid wall. uncertainty: the estimated error of eps */
static int collide_rigid(struct disks *d, double *value, double *uncertainty, double tolerance, double speed)
{
    struct cor_disk_hard_wall h;
    const int status = hard_wall_collide(&h, &d->tables, tolerance, 0, speed);
    *value = quantity_of(d, h.eps, h.contact_time, h.max_compression);
    *uncertainty = h.error_estimate / (2 * h.eps);
    return status == COR_OK || status == COR_TOLERANCE_NOT_REACHED ? STATUS_OK : STATUS_FAILED;
}

static int find_truth(struct disks *d, slong i)
{
    struct plan *const plan = d->plan;
    const double coarsest = plan->relative ? COARSEST_TRUTH_OF_OTHERS : COARSEST_TRUTH;
    const double tolerance = fmin(fmax(TRUTH_SHARE * plan->tolerance, FINEST_TRUTH), coarsest);
    double coarse, of_coarse;
    int status = collide_rigid(d, &plan->truth[i], &plan->uncertainty[i], tolerance, plan->speed[i]);
    if (status == STATUS_OK && plan->relative) {
        status = collide_rigid(d, &coarse, &of_coarse, COARSE_TOLERANCE, plan->speed[i]);
        plan->uncertainty[i] = 2 * fabs(coarse / plan->truth[i] - 1);
    }
    if (status != STATUS_OK || !isfinite(plan->truth[i]) || !isfinite(plan->uncertainty[i]))
        return fail("cannot compute the collision with a rigid wall at the speed %.4g sqrt(E/rho)", plan->speed[i]);
    return STATUS_OK;
}

/* ---- models ---- */

/* Returns C statements that define `modes`. */
static char *modes_text(const struct disks *d, size_t count)
{
    const char *poisson = d->number[COR_SCENE_POISSON].text;
    if (count <= 1800 && (d->modes.nu == 0.33 || d->modes.nu == 0.9))
        return xprintf("#include \"cor/disk.h\"\nconst struct cor_disk_modes *modes = &cor_disk_modes_nu0%d;\n",
                       d->modes.nu == 0.33 ? 33 : 90);
    return xprintf("corgen tables --poisson %s --modes %zu\n"
                   "#include \"cor/disk.h\"\n/* read the file it writes by cor_disk_modes_read */\n"
                   "const struct cor_disk_modes *modes;\n",
                   poisson, count);
}

/* Adds the model of a rigid wall. The error of eps is the promised bound. The error of other quantities is their
 * difference from the reference. */
static int add_rigid(struct disks *d, int k)
{
    struct plan *const plan = d->plan;
    struct plan_model *m = plan_add(plan, "rigid wall: tolerance %g", rigid[k].tolerance);
    int status = STATUS_OK;
    for (slong i = 0; i < plan->points && status == STATUS_OK; i++) {
        double uncertainty;
        m->value[i] = plan->truth[i];
        m->error[i] = rigid[k].tolerance / (2 * plan->truth[i]);
        if (plan->relative)
            status = collide_rigid(d, &m->value[i], &uncertainty, rigid[k].tolerance, plan->speed[i]);
    }
    m->promised = !plan->relative;
    plan_model_is(plan, m, rigid[k].cost, "nothing; estimated, not proved",
                  xprintf("#include \"cor/disk.h\"\nstruct cor_disk_hard_wall_options options = {.tolerance = %g};\n"
                          "struct cor_disk_hard_wall out;\n"
                          "int status = cor_disk_hard_wall_nu(%s, &options, v, &out); /* out.%s */\n",
                          rigid[k].tolerance, d->number[COR_SCENE_POISSON].text, quantities[d->quantity].field));
    return status;
}

static void add_dynamics(const struct disks *d, int k)
{
    struct plan *const plan = d->plan;
    const size_t modes = dynamics[k].modes;
    const double hardness = dynamics[k].hardness;
    const struct cor_disk_collision *const c = &d->collision[k * plan->points];
    struct plan_model *m = hardness > 0 ? plan_add(plan, "dynamics: %zu modes; alpha = %g/v", modes, hardness)
                                        : plan_add(plan, "dynamics: %zu modes; alpha = %g", modes, PAPER_ALPHA);
    double steps = 0;
    for (slong i = 0; i < plan->points; i++) {
        m->value[i] = quantity_of(d, c[i].eps, c[i].contact_time, c[i].max_compression);
        steps += (double)c[i].steps / (double)plan->points;
    }
    char *table = modes_text(d, modes);
    char *alpha =
        hardness > 0 ? xprintf("fmax(%d, %g / v)", COR_DISK_COLLISION_MIN_ALPHA, hardness) : xprintf("%g", PAPER_ALPHA);
    plan_model_is(plan, m, steps * (NS_STEP + NS_STEP_MODE * (double)modes), dynamics[k].leaves_out,
                  xprintf("%sstruct cor_disk_collision_options options = {.alpha = %s, .tolerance = %g};\n"
                          "struct cor_disk_collision out;\n"
                          "int status = cor_disk_collision(modes, %zu, &options, v, &out); /* out.%s */\n",
                          table, alpha, COLLISION_TOLERANCE, modes, quantities[d->quantity].field));
    free(table);
    free(alpha);
}

static void add_rayleigh(const struct disks *d)
{
    struct plan *const plan = d->plan;
    static const size_t taken[] = {1, 10, 100, 1000};
    for (size_t k = 0; k < sizeof taken / sizeof *taken; k++) {
        struct plan_model *m = plan_add(plan, "Rayleigh: %zu mode%s and tail", taken[k], taken[k] > 1 ? "s" : "");
        const struct cor_disk_modes cut = {d->modes.nu, taken[k], d->modes.mode};
        for (slong i = 0; i < plan->points; i++) {
            struct cor_disk_rayleigh out;
            const int status =
                cor_disk_rayleigh(&cut, taken[k], COR_DISK_DATUM_CENTRE_OF_MASS, plan->speed[i], &out, NULL);
            /* NaN if the loss by this theory exceeds the energy (COR_BEYOND_THEORY) */
            if (status == COR_OK || status == COR_BEYOND_THEORY)
                m->value[i] = sqrt(1 - (out.fraction + out.tail));
            m->outside = m->outside || status != COR_OK;
        }
        char *table = modes_text(d, taken[k]);
        plan_model_is(
            plan, m, NS_RAYLEIGH + NS_RAYLEIGH_MODE * (double)taken[k], "the effect of the vibrations on the load",
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
    plan_model_is(plan, m, 0, leaves_out, xprintf("double eps = %s;\n", eps));
}

static void add_models_of_eps(const struct disks *d)
{
    struct plan *const plan = d->plan;
    double low = 1, high = 0;
    for (slong i = 0; i < plan->points; i++) {
        low = fmin(low, plan->truth[i]);
        high = fmax(high, plan->truth[i]);
    }
    char middle[32];
    snprintf(middle, sizeof middle, "%.6f", (low + high) / 2);
    add_constant(plan, "eps = 1", "1", "vibrations");
    add_constant(plan, "constant eps", middle, "the dependence of eps on the speed");
    add_rayleigh(d);

    /* the error is the promised uncertainty, because the reference comes from the same collisions as the table */
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
    plan_model_is(
        plan, m, NS_EPS_TABLE, "nothing; estimated, not proved",
        xprintf("#include \"cor/disk.h\"\ndouble eps = cor_disk_eps(v, %s);\n", d->number[COR_SCENE_POISSON].text));
}

static void add_laws(const struct disks *d)
{
    struct plan *const plan = d->plan;
    static const char *const name[] = {"centre of mass", "diameter", "as printed"};
    static const char *const datum[] = {"CENTRE_OF_MASS", "DIAMETER", "PRINTED"};
    const bool time = d->quantity == PLAN_CONTACT_TIME;
    double (*const function)(double speed, double nu, enum cor_disk_datum datum) =
        time ? cor_disk_contact_time : cor_disk_max_compression;
    const char *const called = time ? "cor_disk_contact_time" : "cor_disk_max_compression";
    struct plan_model *m = plan_add(plan, "leading logarithm (61)");
    for (slong i = 0; i < plan->points; i++)
        m->value[i] = (time ? cor_disk_contact_time_leading_log : cor_disk_max_compression_leading_log)(plan->speed[i]);
    plan_model_is(
        plan, m, NS_LEADING_LOG, "all terms except ln(4/v); vibrations",
        xprintf("#include \"cor/disk.h\"\ndouble %s = %s_leading_log(v);\n", quantities[d->quantity].field, called));
    for (int k = 0; k < 3; k++) {
        m = plan_add(plan, "quasistatic law: %s", name[k]);
        for (slong i = 0; i < plan->points; i++)
            m->value[i] = function(plan->speed[i], d->modes.nu, (enum cor_disk_datum)k);
        plan_model_is(plan, m, quantities[d->quantity].ns_law, "vibrations",
                      xprintf("#include \"cor/disk.h\"\ndouble %s = %s(v, %s, COR_DISK_DATUM_%s);\n",
                              quantities[d->quantity].field, called, d->number[COR_SCENE_POISSON].text, datum[k]));
    }
}

/* ---- the plan ---- */

static int check_range(const struct decimal *number, double low, double high)
{
    const char *const min = number[EMBED_SPEED_MIN].text, *const max = number[EMBED_SPEED_MAX].text;
    if (!(low >= MIN_SPEED && high <= COR_DISK_HARD_WALL_MAX_SPEED))
        return usage_error(
            "--speed-min %s and --speed-max %s are out of range; allowed with --disks: %g to %g sqrt(E/rho)", min, max,
            MIN_SPEED, COR_DISK_HARD_WALL_MAX_SPEED);
    return embed_check_numbers(number, low, high, LEAST_TOLERANCE, 1);
}

static int disks_fill(struct disks *d)
{
    struct plan *const plan = d->plan;
    int status = STATUS_OK;
    hard_wall_tables_set(&d->tables, d->modes.nu);
    for (slong i = 0; i < plan->points && status == STATUS_OK; i++) {
        plan->at[i] = plan->speed[i];
        status = find_truth(d, i);
        progress("rigid walls", (long)i + 1, (long)plan->points);
    }
    progress_end();
    if (status != STATUS_OK)
        return status;
    d->collision = xmalloc(DYNAMICS * (size_t)plan->points * sizeof *d->collision);
    parallel_for(collide_soft, d, DYNAMICS * plan->points, "collisions");
    plan->argument = "speed";
    plan->quantity = quantities[d->quantity].name;
    plan->note =
        "Error: the largest at the points, two digits, rounded up. For cor_disk_eps and the rigid wall it is the\n"
        "documented error. A model meets the tolerance if its error and the uncertainty of the exact value add\n"
        "up to at most 0.97 of the tolerance. More modes and harder walls approach the exact value from opposite\n"
        "sides, so few modes at a soft wall may be right by accident.\n"
        "Cost: from the steps and modes of a collision, measured once (docs/plan.md).\n";
    double uncertainty = 0;
    for (slong i = 0; i < plan->points; i++)
        uncertainty = fmax(uncertainty, plan->uncertainty[i]);
    plan->title = xprintf("Disks of nu = %s at %s to %s sqrt(E/rho): %s from %.4g to %.4g,\n"
                          "for a disk with all its modes at a rigid wall, uncertain by %.1e%s.\n",
                          d->number[COR_SCENE_POISSON].text, d->number[EMBED_SPEED_MIN].text,
                          d->number[EMBED_SPEED_MAX].text, plan->quantity, plan->truth[0],
                          plan->truth[plan->points - 1], uncertainty, plan->relative ? ", relative" : "");
    (plan->relative ? add_laws : add_models_of_eps)(d);
    for (int k = 0; k < DYNAMICS; k++)
        add_dynamics(d, k);
    for (int k = 0; k < RIGID && status == STATUS_OK; k++)
        status = add_rigid(d, k);
    plan_choose(plan);
    return status;
}

int plan_disks(struct plan *plan, const struct embed_request *request, enum plan_quantity quantity, slong points)
{
    const double low = embed_number(request, EMBED_SPEED_MIN), high = embed_number(request, EMBED_SPEED_MAX);
    const double tolerance = embed_number(request, EMBED_TOLERANCE);
    *plan = (struct plan){.chosen = -1};
    int status = check_range(request->number, low, high);
    if (status != STATUS_OK)
        return status;
    plan_init(plan, points ? points : PLAN_DEFAULT_POINTS_DISKS, low, high);
    plan->tolerance = tolerance;
    plan->relative = quantity != PLAN_EPS;
    struct disks d = {.plan = plan, .number = request->number, .quantity = quantity};
    profile_step("modes");
    status = disk_modes_rounded(&d.modes, request->number[COR_SCENE_POISSON].value, MOST_MODES);
    profile_step("collisions");
    if (status == STATUS_OK) {
        status = disks_fill(&d);
        free((void *)d.modes.mode);
    }
    profile_step(NULL);
    free(d.collision);
    hard_wall_tables_clear(&d.tables);
    return status;
}
