/* SPDX-License-Identifier: MIT */
/* Elastic disks: from leaving the vibrations out to collisions of many modes, against what collisions of hard walls and
 * all modes tend to. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cor/disk.h"
#include "cor/status.h"
#include "disk/limit_fit.h"
#include "disk/modes.h"
#include "disk/modes_rounded.h"
#include "plan/plan.h"
#include "support/console.h"
#include "support/parallel.h"

/* Every number of modes with every hardness alpha v. Limits are fitted to the last ones. */
static const size_t counts[] = {10, 30, 100, 300, 940, 1800, 2500, 3600};
static const double hardness[] = {11, 22, 30, 41, 56};
enum {
    COUNTS = sizeof counts / sizeof *counts,
    WALLS = sizeof hardness / sizeof *hardness,
    FIT_COUNTS = 3, /* from 1800 on, and walls from 22 on: disk_limit_fit.h */
    FIT_WALLS = 4,
    FIT = FIT_COUNTS * FIT_WALLS,
    QUANTITIES = 3 /* enum plan_quantity */
};
#define COLLISION_TOLERANCE 1e-6
/* The paper's wall and number of modes. */
#define PAPER_ALPHA 500.0
#define PAPER_MODES ((size_t)940)

/* ns, measured once: docs/plan.md. A step of a collision: so much, and so much for each mode. */
#define NS_STEP 1000.0
#define NS_STEP_MODE 4.0
#define NS_EPS_TABLE 170.0
#define NS_RAYLEIGH 80e3
#define NS_RAYLEIGH_MODE 45.0
static const double ns_law[QUANTITIES] = {0, 770, 130}, ns_leading_log[QUANTITIES] = {0, 40, 40};

struct outcome {
    double value[QUANTITIES]; /* NaN: not known */
    bool reached;             /* the tolerance */
    double steps;
};

struct disks {
    const struct plan_disks_request *request;
    struct cor_disk_modes modes;
    struct outcome *grid; /* [point][count][wall] */
    struct outcome *paper;
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
    const struct cor_disk_collision_options options = {alpha, COLLISION_TOLERANCE, 0};
    const size_t bytes = cor_disk_collision_workspace(&d->modes, modes, &options);
    void *const room = xmalloc(bytes);
    struct cor_disk_collision c = {(double)NAN, (double)NAN, (double)NAN, (double)NAN, (double)NAN, 0};
    const int status = cor_disk_collision_in(room, bytes, &d->modes, modes, &options, speed, &c, NULL);
    free(room);
    out->value[PLAN_EPS] = c.eps;
    out->value[PLAN_CONTACT_TIME] = c.contact_time;
    out->value[PLAN_COMPRESSION] = c.max_compression;
    out->reached = status == COR_OK;
    out->steps = (double)c.steps;
}

struct collisions {
    const struct plan *plan;
    struct disks *disks;
};

/* Task i: of a point the collisions of one row of the grid, the most modes first, or the paper's. */
static void disks_collide_row(void *context, slong i)
{
    const struct collisions *const work = context;
    struct disks *const d = work->disks;
    const slong points = work->plan->points, point = i % points;
    const double speed = work->plan->speed[point];
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
    struct collisions work = {plan, d};
    parallel_for(disks_collide_row, &work, plan->points * (COUNTS + 1), "collisions");
}

/* ---- what they tend to ---- */

/* eps of all modes at a hard wall */
static int limit_of_eps(struct plan *plan, const struct disks *d, slong i)
{
    struct disk_limit_row row[FIT];
    for (int k = 0; k < FIT; k++) {
        const int n = COUNTS - FIT_COUNTS + k / FIT_WALLS, wall = WALLS - FIT_WALLS + k % FIT_WALLS;
        const struct outcome *out = outcome_at(d, i, n, wall);
        const double eps = out->value[PLAN_EPS];
        row[k] = (struct disk_limit_row){alpha_of(hardness[wall], plan->speed[i]), counts[n],
                                         out->reached ? 1 - eps * eps : (double)NAN};
    }
    struct disk_limit limit;
    const enum disk_limit_status status = disk_limit_fit(&limit, plan->speed[i], row, FIT);
    if (status != DISK_LIMIT_OK)
        return fail("what collisions at speed %.4g tend to is not known: %s", plan->speed[i], disk_limit_text(status));
    plan->truth[i] = sqrt(1 - limit.one_minus_eps2);
    plan->uncertainty[i] = limit.uncertainty / (2 * plan->truth[i]);
    return STATUS_OK;
}

/* At a hard wall, linear in 1/alpha through two walls. */
static double hard_wall(const struct disks *d, slong i, int count, int softer, int harder, enum plan_quantity quantity)
{
    const double x = outcome_at(d, i, count, softer)->value[quantity],
                 y = outcome_at(d, i, count, harder)->value[quantity];
    return y + (y - x) * hardness[softer] / (hardness[harder] - hardness[softer]);
}

/* The other quantities, of the most modes; uncertain by what two other walls and fewer modes make of them. */
static int limit_of_other(struct plan *plan, const struct disks *d, slong i, enum plan_quantity quantity)
{
    const int most = COUNTS - 1, half = COUNTS - FIT_COUNTS;
    const double limit = hard_wall(d, i, most, WALLS - 3, WALLS - 1, quantity);
    const double walls = hard_wall(d, i, most, WALLS - 4, WALLS - 2, quantity);
    const double modes = hard_wall(d, i, half, WALLS - 3, WALLS - 1, quantity);
    plan->truth[i] = limit;
    plan->uncertainty[i] = (fabs(walls - limit) + fabs(modes - limit)) / limit;
    if (!isfinite(plan->uncertainty[i]))
        return fail("the collision at speed %.4g does not end", plan->speed[i]);
    return STATUS_OK;
}

/* ---- models ---- */

/* C that makes `modes` and `v` known */
static char *modes_text(const struct disks *d, size_t count)
{
    const char *poisson = d->request->poisson.text;
    if (count <= 1800 && (d->modes.nu == 0.33 || d->modes.nu == 0.9))
        return plan_text("#include \"cor/cor.h\"\nconst struct cor_disk_modes *modes = &cor_disk_modes_nu0%d;\n",
                         d->modes.nu == 0.33 ? 33 : 90);
    return plan_text("corgen tables --poisson %s --modes %zu\n"
                     "#include \"cor/cor.h\"\n/* read the file it writes by cor_disk_modes_read */\n"
                     "const struct cor_disk_modes *modes;\n",
                     poisson, count);
}

static const char *quantity_field(enum plan_quantity quantity)
{
    static const char *const fields[QUANTITIES] = {"eps", "contact_time", "max_compression"};
    return fields[quantity];
}

static bool is_relative(const struct disks *d)
{
    return d->request->quantity != PLAN_EPS;
}

/* hard = 0: the paper's wall */
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
    m->cost = steps * (NS_STEP + NS_STEP_MODE * (double)modes);
    m->leaves_out = leaves_out;
    char *table = modes_text(d, modes), alpha[64];
    if (hard > 0)
        snprintf(alpha, sizeof alpha, "fmax(%d, %g / v)", COR_DISK_COLLISION_MIN_ALPHA, hard);
    else
        snprintf(alpha, sizeof alpha, "%g", PAPER_ALPHA);
    m->use = plan_text("%sstruct cor_disk_collision_options options = {.alpha = %s, .tolerance = %g};\n"
                       "struct cor_disk_collision out;\n"
                       "int status = cor_disk_collision(modes, %zu, &options, v, &out); /* out.%s */\n",
                       table, alpha, COLLISION_TOLERANCE, modes, quantity_field(d->request->quantity));
    free(table);
}

static void add_all_dynamics(struct plan *plan, const struct disks *d)
{
    static const size_t ladder[] = {10, 30, 100, 300, 940, 1800, 3600}, soft[] = {300, 1800};
    for (size_t i = 0; i < sizeof ladder / sizeof *ladder; i++)
        add_dynamics(plan, d, ladder[i], hardness[WALLS - 1], "higher modes; some hardness of the wall");
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
            /* beyond the law it gives nothing, beyond the theory more energy than there is */
            if (status == COR_OK || status == COR_BEYOND_THEORY)
                m->value[i] = sqrt(1 - (out.fraction + out.tail));
            m->outside = m->outside || status != COR_OK;
        }
        plan_compare(plan, m, false);
        m->cost = NS_RAYLEIGH + NS_RAYLEIGH_MODE * (double)taken[k];
        m->leaves_out = "that vibrations act back on the load";
        char *table = modes_text(d, taken[k]);
        m->use =
            plan_text("%sstruct cor_disk_modes cut = {modes->nu, %zu, modes->mode};\nstruct cor_disk_rayleigh out;\n"
                      "int status = cor_disk_rayleigh(&cut, %zu, COR_DISK_DATUM_CENTRE_OF_MASS, v, &out, NULL);\n"
                      "double eps = sqrt(1 - (out.fraction + out.tail));\n",
                      table, taken[k], taken[k]);
        free(table);
    }
}

static void add_models_of_eps(struct plan *plan, const struct disks *d)
{
    struct plan_model *m = plan_add(plan, "eps = 1");
    for (slong i = 0; i < plan->points; i++)
        m->value[i] = 1;
    plan_compare(plan, m, false);
    m->leaves_out = "vibrations";
    m->use = plan_text("double eps = 1;\n");
    double low = 1, high = 0;
    for (slong i = 0; i < plan->points; i++) {
        low = fmin(low, plan->truth[i]);
        high = fmax(high, plan->truth[i]);
    }
    char text[32];
    snprintf(text, sizeof text, "%.6f", (low + high) / 2);
    m = plan_add(plan, "constant eps");
    for (slong i = 0; i < plan->points; i++)
        m->value[i] = strtod(text, NULL);
    plan_compare(plan, m, false);
    m->leaves_out = "how eps goes with the speed";
    m->use = plan_text("double eps = %s;\n", text);
    add_rayleigh(plan, d);

    /* What the library promises of its table, which corgen makes and cannot ask here. */
    m = plan_add(plan, "table: cor_disk_eps");
    m->outside = !(d->modes.nu >= COR_DISK_EPS_MIN_NU && d->modes.nu <= COR_DISK_EPS_MAX_NU);
    for (slong i = 0; i < plan->points; i++) {
        m->value[i] = plan->truth[i];
        m->error[i] = COR_DISK_EPS_MAX_UNCERTAINTY / (2 * plan->truth[i]);
    }
    m->promised = true;
    m->cost = NS_EPS_TABLE;
    m->leaves_out = "nothing; estimated, not proved";
    m->use = plan_text("#include \"cor/cor.h\"\ndouble eps = cor_disk_eps(v, %s);\n", d->request->poisson.text);
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
    m->cost = ns_leading_log[d->request->quantity];
    m->leaves_out = "all beside ln(4/v); vibrations";
    m->use = plan_text("#include \"cor/cor.h\"\ndouble %s = %s_leading_log(v);\n", quantity_field(d->request->quantity),
                       called);
    for (int k = 0; k < 3; k++) {
        m = plan_add(plan, "quasistatic law: %s", name[k]);
        for (slong i = 0; i < plan->points; i++)
            m->value[i] = function(plan->speed[i], d->modes.nu, (enum cor_disk_datum)k);
        plan_compare(plan, m, true);
        m->cost = ns_law[d->request->quantity];
        m->leaves_out = "vibrations";
        m->use = plan_text("#include \"cor/cor.h\"\ndouble %s = %s(v, %s, COR_DISK_DATUM_%s);\n",
                           quantity_field(d->request->quantity), called, d->request->poisson.text, datum[k]);
    }
}

/* ---- the plan ---- */

static int read_range(double range[2], double *tolerance, const struct plan_disks_request *request)
{
    range[0] = decimal_value(&request->speed_min);
    range[1] = decimal_value(&request->speed_max);
    *tolerance = decimal_value(&request->tolerance);
    if (!(range[0] >= COR_DISK_EPS_MIN_SPEED && range[1] <= COR_DISK_EPS_MAX_SPEED))
        return usage_error("--speed-min %s to --speed-max %s: what collisions tend to is known from %g to %g, in "
                           "sqrt(E/rho)",
                           request->speed_min.text, request->speed_max.text, COR_DISK_EPS_MIN_SPEED,
                           COR_DISK_EPS_MAX_SPEED);
    if (!(range[1] > range[0]))
        return usage_error("--speed-min %s is not below --speed-max %s", request->speed_min.text,
                           request->speed_max.text);
    if (!(*tolerance >= COLLISION_TOLERANCE && *tolerance < 1))
        return usage_error("--tolerance %s is not from %g, the error of a collision here, to below 1",
                           request->tolerance.text, COLLISION_TOLERANCE);
    return STATUS_OK;
}

static char *disks_title(const struct plan *plan, const struct disks *d)
{
    const slong last = plan->points - 1;
    double uncertainty = 0;
    for (slong i = 0; i <= last; i++)
        uncertainty = fmax(uncertainty, plan->uncertainty[i]);
    return plan_text("Disks of nu = %s at %s to %s sqrt(E/rho): %s from %.4g to %.4g,\n"
                     "what collisions of many modes with hard walls tend to, uncertain by %.1e%s.\n",
                     d->request->poisson.text, d->request->speed_min.text, d->request->speed_max.text, plan->quantity,
                     plan->truth[0], plan->truth[last], uncertainty, is_relative(d) ? ", relative" : "");
}

static int disks_fill(struct plan *plan, struct disks *d)
{
    static const char *const quantity[] = {"eps", "contact time", "largest compression"};
    disks_collide_all(plan, d);
    int status = STATUS_OK;
    for (slong i = 0; i < plan->points && status == STATUS_OK; i++) {
        plan->at[i] = plan->speed[i];
        status = d->request->quantity == PLAN_EPS ? limit_of_eps(plan, d, i)
                                                  : limit_of_other(plan, d, i, d->request->quantity);
    }
    if (status != STATUS_OK)
        return status;
    plan->argument = "speed";
    plan->quantity = quantity[d->request->quantity];
    plan->unit = is_relative(d) ? "relative error" : "error";
    plan->note =
        "Error: the largest of the points; taken where error and uncertainty of what it is compared with are below\n"
        "0.97 of the tolerance. Of cor_disk_eps: what the library promises. More modes and harder walls tend to the\n"
        "truth from two sides, so that few modes at a soft wall may be right by accident.\n"
        "Cost: of a collision, from its steps and modes; all as measured once, docs/plan.md.\n";
    plan->title = disks_title(plan, d);
    if (d->request->quantity == PLAN_EPS)
        add_models_of_eps(plan, d);
    else
        add_laws(plan, d);
    add_all_dynamics(plan, d);
    plan_choose(plan);
    return STATUS_OK;
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
    struct disks d = {.request = request};
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
    return status;
}
