/* SPDX-License-Identifier: MIT */
#include "tables/limits.h"

#include <inttypes.h>
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "cor/status.h"
#ifndef COR_BOOTSTRAP
#include "generated/disk_limits.h"
#endif
#include "runtime/core/disk_limit.h"
#include "support/console.h"
#include "support/emit_c.h"
#include "support/parallel.h"
#include "sweep/hard_wall.h"

/* The plane and its first division */
#define FIRST_SPEED 1e-5
#define LAST_SPEED 0.3
#define FIRST_NU (-0.2)
#define NU_STEP 0.1375
enum { X_ROOTS = 20, NU_ROOTS = 5, ROOTS = X_ROOTS * NU_ROOTS };
#define LAST_NU (FIRST_NU + (double)NU_ROOTS * NU_STEP)
/* Largest number of divisions of a cell. A fifth helps little (docs/disks.md). Coordinates are in sixths of the
 * side of a cell that is divided FINEST times, so that they do not depend on this number. */
enum { MOST_CUTS = 4, FINEST = 8, SIXTHS = 6, ROOT_SIDE = SIXTHS << FINEST };

/* Tolerances of the collisions up to a speed and beyond it, and the factor on the error of a cell's polynomial at the 9
 * points between its 16 */
#define CALM_SPEED COR_DISK_EPS_CALM_SPEED
#define CALM_TOLERANCE 1.5e-5
#define FAST_TOLERANCE 5e-5
#define SAFETY 1.5
/* A cell with this or a smaller uncertainty is not divided any more. */
#define CALM_WANTED 2e-5
#define FAST_WANTED 1e-4

enum { NODES_MAX = INT16_MAX, CELL_TEXT = 200, LINE = 64, SAMPLE_MISSES = 3 };

/* A collision, at x and nu in sixths from the corner of the plane */
struct scene {
    int32_t x, nu, value, estimate; /* in COR_DISK_LIMIT_UNIT */
};

struct limits {
    bool known;
    long seconds; /* processor time of their computation */
    long scenes;
    int nodes, cells;
    int16_t node[NODES_MAX];
    struct cor_disk_limit_cell cell[NODES_MAX];
};
static struct limits *table;

void disk_limits_clear(void)
{
    free(table);
    table = NULL;
}

static void start_table(void)
{
    disk_limits_clear();
    table = xmalloc(sizeof *table);
    memset(table, 0, sizeof *table);
}

/* ---- the plane ---- */

static double x_of_speed(double speed)
{
    return sqrt(sqrt(sqrt(speed)));
}

static double x_step(void)
{
    return (x_of_speed(LAST_SPEED) - x_of_speed(FIRST_SPEED)) / (double)X_ROOTS;
}

static double speed_at(int32_t x)
{
    const double root = x_of_speed(FIRST_SPEED) + x_step() * ((double)x / (double)ROOT_SIDE), square = root * root;
    return square * square * (square * square);
}

static double nu_at(int32_t nu)
{
    return FIRST_NU + NU_STEP * ((double)nu / (double)ROOT_SIDE);
}

static struct cor_disk_limit_table evaluable(const struct limits *limits)
{
    return (struct cor_disk_limit_table){
        X_ROOTS, NU_ROOTS, x_of_speed(FIRST_SPEED), x_step(), FIRST_NU, NU_STEP, limits->node, limits->cell};
}

/* Whether a collision at x is asked for CALM_TOLERANCE: in all roots that begin below CALM_SPEED, so that no cell has
 * collisions of both tolerances */
static bool is_calm(int32_t x)
{
    const int32_t column = x > 0 ? (x - 1) / ROOT_SIDE : 0;
    return speed_at(column * ROOT_SIDE) < CALM_SPEED;
}

/* The speed at which the last of these roots ends */
static double calm_end(void)
{
    int32_t x = ROOT_SIDE;
    while (is_calm(x + ROOT_SIDE))
        x += ROOT_SIDE;
    return speed_at(x);
}

/* ---- collisions ---- */

static int by_place(const void *a, const void *b)
{
    const struct scene *x = a, *y = b;
    return x->nu != y->nu ? (x->nu < y->nu ? -1 : 1) : (x->x > y->x) - (x->x < y->x);
}

struct collisions {
    struct scene *scene; /* in order of place, and where those of one material begin */
    long first;
    struct hard_wall_tables tables;
    atomic_bool failed;
};

static void scene_collide(void *context, slong i)
{
    struct collisions *const run = context;
    struct scene *const scene = &run->scene[run->first + i];
    struct cor_disk_hard_wall out;
    const int status = hard_wall_collide(&out, &run->tables, is_calm(scene->x) ? CALM_TOLERANCE : FAST_TOLERANCE,
                                         SIZE_MAX, speed_at(scene->x));
    if (status != COR_OK && status != COR_TOLERANCE_NOT_REACHED) {
        fail("nu = %.17g, v = %.17g: %s", nu_at(scene->nu), speed_at(scene->x), cor_status_text(status));
        atomic_store(&run->failed, true);
        return;
    }
    scene->value = (int32_t)lround(out.one_minus_eps2 / COR_DISK_LIMIT_UNIT);
    scene->estimate = (int32_t)ceil(out.error_estimate / COR_DISK_LIMIT_UNIT);
}

/* Computes all scenes. They are in order of place, so that those of one material are together. */
static int collide_all(struct scene *scene, long count, const char *name)
{
    struct collisions run = {.scene = scene};
    hard_wall_tables_init(&run.tables);
    progress_enter(name, count);
    for (long end; run.first < count && !run.failed; run.first = end) {
        for (end = run.first; end < count && scene[end].nu == scene[run.first].nu;)
            end++;
        progress_at(run.first);
        hard_wall_tables_set(&run.tables, nu_at(scene[run.first].nu));
        parallel_for(scene_collide, &run, end - run.first, name);
    }
    progress_leave();
    hard_wall_tables_clear(&run.tables);
    return run.failed ? STATUS_FAILED : STATUS_OK;
}

/* ---- scenes that are known ---- */

struct scenes {
    struct scene *scene; /* in order of place */
    long count, capacity;
};

static void add_scene(struct scenes *to, struct scene scene)
{
    if (to->count == to->capacity) {
        to->capacity = to->capacity ? 2 * to->capacity : 1024;
        to->scene = xrealloc(to->scene, (size_t)to->capacity * sizeof *to->scene);
    }
    to->scene[to->count++] = scene;
}

static void sort_scenes(struct scenes *scenes)
{
    if (scenes->count)
        qsort(scenes->scene, (size_t)scenes->count, sizeof *scenes->scene, by_place);
}

static const struct scene *known_scene(const struct scenes *scenes, int32_t x, int32_t nu)
{
    const struct scene key = {x, nu, 0, 0};
    return scenes->count ? bsearch(&key, scenes->scene, (size_t)scenes->count, sizeof key, by_place) : NULL;
}

/* ---- cells ---- */

struct cell {
    int32_t x, nu; /* of its first corner */
    int depth, node;
};

static int32_t sixth_of(const struct cell *cell)
{
    return (ROOT_SIDE / SIXTHS) >> cell->depth;
}

/* The points of a cell: i and j both even for its 16 values, or both odd for 9 points that test the polynomial */
static void need_places(const struct cell *cell, const struct scenes *scenes, struct scenes *needed)
{
    for (int j = 0; j <= SIXTHS; j++)
        for (int i = j % 2; i <= SIXTHS; i += 2) {
            const struct scene scene = {cell->x + i * sixth_of(cell), cell->nu + j * sixth_of(cell), 0, 0};
            if (!known_scene(scenes, scene.x, scene.nu))
                add_scene(needed, scene);
        }
}

static int find_scenes(struct scenes *scenes, const struct cell *cell, int cells)
{
    struct scenes needed = {0};
    long count = 0;
    for (int i = 0; i < cells; i++)
        need_places(&cell[i], scenes, &needed);
    sort_scenes(&needed);
    for (long i = 0; i < needed.count; i++) /* each once */
        if (count == 0 || by_place(&needed.scene[count - 1], &needed.scene[i]) != 0)
            needed.scene[count++] = needed.scene[i];
    char name[LINE];
    snprintf(name, sizeof name, "collisions for %d cells", cells);
    const int status = collide_all(needed.scene, count, name);
    for (long i = 0; i < count; i++)
        add_scene(scenes, needed.scene[i]);
    sort_scenes(scenes);
    free(needed.scene);
    return status;
}

/* Sets the cell's values and the uncertainty of its polynomial. */
static void fill_cell(struct cor_disk_limit_cell *to, const struct cell *cell, const struct scenes *scenes)
{
    const int32_t sixth = sixth_of(cell);
    int32_t estimate = 0;
    double missed = 0;
    for (int j = 0; j < COR_DISK_LIMIT_SIDE; j++)
        for (int i = 0; i < COR_DISK_LIMIT_SIDE; i++) {
            const struct scene *const s = known_scene(scenes, cell->x + 2 * i * sixth, cell->nu + 2 * j * sixth);
            to->value[COR_DISK_LIMIT_SIDE * j + i] = s->value;
            estimate = s->estimate > estimate ? s->estimate : estimate;
        }
    for (int j = 1; j < SIXTHS; j += 2)
        for (int i = 1; i < SIXTHS; i += 2) {
            const struct scene *const s = known_scene(scenes, cell->x + i * sixth, cell->nu + j * sixth);
            const double value = cor_disk_limit_value(to, (double)i / (double)SIXTHS, (double)j / (double)SIXTHS);
            missed = fmax(missed, fabs(value / COR_DISK_LIMIT_UNIT - s->value));
            estimate = s->estimate > estimate ? s->estimate : estimate;
        }
    /* the two parts are independent, and each is several times the actual error */
    to->uncertainty = (int32_t)ceil(hypot(SAFETY * missed, estimate)) + 1;
}

/* What is wanted of a cell that begins at x */
static double wanted_at(int32_t x)
{
    return is_calm(x + 1) ? CALM_WANTED : FAST_WANTED;
}

/* Divides a cell into four. */
static void cell_cut(const struct cell *cell, struct cell *quarter)
{
    const int32_t half = SIXTHS / 2 * sixth_of(cell);
    for (int k = 0; k < 4; k++)
        quarter[k] = (struct cell){cell->x + k % 2 * half, cell->nu + k / 2 * half, cell->depth + 1, table->nodes + k};
    table->node[cell->node] = (int16_t)-table->nodes;
    table->nodes += 4;
}

/* Cells of one depth become part of the table or are divided; *cell becomes the list of their quarters. */
static int cell_refine(struct scenes *scenes, struct cell **cell, int *cells)
{
    int status = find_scenes(scenes, *cell, *cells), cut_cells = 0;
    struct cell *const next = xmalloc(4 * (size_t)*cells * sizeof *next);
    for (int i = 0; i < *cells && status == STATUS_OK; i++) {
        const struct cell *const c = &(*cell)[i];
        struct cor_disk_limit_cell filled;
        fill_cell(&filled, c, scenes);
        if (c->depth == MOST_CUTS || filled.uncertainty * COR_DISK_LIMIT_UNIT <= wanted_at(c->x)) {
            table->node[c->node] = (int16_t)table->cells;
            table->cell[table->cells++] = filled;
        } else if (table->nodes + 4 > NODES_MAX) {
            status = fail("the table needs more than %d cells", NODES_MAX);
        } else {
            cell_cut(c, next + 4 * cut_cells++);
        }
    }
    free(*cell);
    *cell = next;
    *cells = 4 * cut_cells;
    return status;
}

/* Sets the place of each cell. */
static void place_cells(struct cell *of_cell, int node, struct cell cell)
{
    const int number = table->node[node];
    const int32_t half = SIXTHS / 2 * sixth_of(&cell);
    if (number >= 0) {
        of_cell[number] = cell;
        return;
    }
    for (int k = 0; k < 4; k++)
        place_cells(of_cell, -number + k,
                    (struct cell){cell.x + k % 2 * half, cell.nu + k / 2 * half, cell.depth + 1, 0});
}

static struct cell *places_of_cells(void)
{
    struct cell *const of_cell = xmalloc((size_t)table->cells * sizeof *of_cell);
    for (int i = 0; i < ROOTS; i++)
        place_cells(of_cell, i, (struct cell){i % X_ROOTS * ROOT_SIDE, i / X_ROOTS * ROOT_SIDE, 0, 0});
    return of_cell;
}

/* Marks the sides of each cell that are joined to smaller cells, from the centre of the cell. */
static void mark_joined(struct limits *limits)
{
    const struct cor_disk_limit_table t = evaluable(limits);
    struct cell *const of_cell = places_of_cells();
    for (int i = 0; i < limits->cells; i++) {
        const double half = (double)(SIXTHS / 2 * sixth_of(&of_cell[i]));
        const struct cor_disk_limit_place at = cor_disk_limit_find(
            &t, ((double)of_cell[i].x + half) / (double)ROOT_SIDE, ((double)of_cell[i].nu + half) / (double)ROOT_SIDE);
        limits->cell[i].joined = 0;
        for (int side = 0; side < 4; side++)
            limits->cell[i].joined |= (cor_disk_limit_beyond(&t, &at, side & 1, side >> 1).side < at.side) << side;
    }
    free(of_cell);
}

int disk_limits_collide(void)
{
    const double start = (double)clock() / CLOCKS_PER_SEC;
    struct scenes scenes = {0};
    struct cell *cell = xmalloc(ROOTS * sizeof *cell);
    int cells = ROOTS, status = STATUS_OK;
    start_table();
    table->nodes = ROOTS;
    for (int i = 0; i < ROOTS; i++)
        cell[i] = (struct cell){i % X_ROOTS * ROOT_SIDE, i / X_ROOTS * ROOT_SIDE, 0, i};
    while (cells > 0 && status == STATUS_OK)
        status = cell_refine(&scenes, &cell, &cells);
    free(cell);
    if (status == STATUS_OK)
        mark_joined(table);
    table->scenes = scenes.count;
    table->seconds = lround((double)clock() / CLOCKS_PER_SEC - start);
    table->known = status == STATUS_OK;
    free(scenes.scene);
    return status;
}

/* ---- the file ---- */

/* The largest uncertainty of cells below, and at and above, calm_end(), and the median of all */
struct summary {
    int32_t calm, fast, median;
    int depth[FINEST + 1], deepest;
};

static int by_size(const void *a, const void *b)
{
    const int32_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

static struct summary summary_of(const struct limits *limits)
{
    struct summary summary = {0};
    struct cell *const of_cell = places_of_cells();
    int32_t *const uncertainty = xmalloc((size_t)limits->cells * sizeof *uncertainty);
    for (int i = 0; i < limits->cells; i++) {
        int32_t *const most = is_calm(of_cell[i].x + 1) ? &summary.calm : &summary.fast;
        uncertainty[i] = limits->cell[i].uncertainty;
        *most = uncertainty[i] > *most ? uncertainty[i] : *most;
        summary.depth[of_cell[i].depth]++;
        summary.deepest = of_cell[i].depth > summary.deepest ? of_cell[i].depth : summary.deepest;
    }
    qsort(uncertainty, (size_t)limits->cells, sizeof *uncertainty, by_size);
    summary.median = uncertainty[limits->cells / 2];
    free(uncertainty);
    free(of_cell);
    return summary;
}

static void write_banner(FILE *file, const struct limits *limits)
{
    const struct summary summary = summary_of(limits);
    fprintf(
        file,
        "/* SPDX-License-Identifier: MIT */\n"
        "/* 1 - eps^2 of an elastic disk of all its modes at a rigid wall (cor_disk_hard_wall), E = rho = R = 1, for\n"
        " * speeds from %g to %g and Poisson's ratios from %g to %g in plane stress. Evaluated by "
        "runtime/disk/limits.c.\n"
        " *\n"
        " * %ld collisions, asked for an error of %g up to v = %g and %g beyond (estimated by "
        "cor_disk_hard_wall).\n"
        " * The plane of x = v^(1/8) and nu is cut into %d cells, of depths 0 to %d: ",
        FIRST_SPEED, LAST_SPEED, FIRST_NU, LAST_NU, limits->scenes, CALM_TOLERANCE, calm_end(), FAST_TOLERANCE,
        limits->cells, summary.deepest);
    for (int k = 0; k <= summary.deepest; k++)
        fprintf(file, "%s%d", k ? ", " : "", summary.depth[k]);
    fprintf(
        file,
        ". Each holds 4 x 4\n"
        " * values, between which polynomials of degree 3 interpolate, joined on the sides, "
        "runtime/core/disk_limit.h.\n"
        " *\n"
        " * Uncertainty of a cell: the root of the squares of two parts, %g times what its polynomial misses at most\n"
        " * at 9 collisions between the 16 (measured) and the largest estimate of the errors of these 25 collisions.\n"
        " * It is an estimate, no bound, and at most %.1e in cells below v = %g, %.2e in the others,\n"
        " * %.1e in half of all.\n"
        " *\n"
        " * Written by:  corgen tables --all, in %ld seconds of processor time\n"
        " * Checked by:  corgen tables --check, which collides at places of one cell again, and corgen tables\n"
        " *              --check --all */\n",
        SAFETY, summary.calm * COR_DISK_LIMIT_UNIT, calm_end(), summary.fast * COR_DISK_LIMIT_UNIT,
        summary.median * COR_DISK_LIMIT_UNIT, limits->seconds);
}

static void write_nodes(FILE *file, const struct limits *limits)
{
    enum { A_LINE = 16 };
    fprintf(file, "static const int16_t cor_disk_limit_node[%d] = {", limits->nodes);
    for (int i = 0; i < limits->nodes; i++)
        fprintf(file, "%s%d%s", i % A_LINE ? " " : "\n    ", limits->node[i], i + 1 < limits->nodes ? "," : "");
    fputs("\n};\n\n", file);
}

static void cell_text(char text[CELL_TEXT], const struct cor_disk_limit_cell *cell)
{
    int n = snprintf(text, CELL_TEXT, "    {%" PRId32 ", %" PRId32 ", {", cell->uncertainty, cell->joined);
    for (int k = 0; k < COR_DISK_LIMIT_POINTS; k++)
        n += snprintf(text + n, CELL_TEXT - (size_t)n, "%s%" PRId32, k ? ", " : "", cell->value[k]);
    snprintf(text + n, CELL_TEXT - (size_t)n, "}},\n");
}

int disk_limits_write(FILE *file)
{
    write_banner(file, table);
    fprintf(file,
            "#ifndef COR_DISK_LIMITS_H\n#define COR_DISK_LIMITS_H\n\n"
            "#include \"runtime/core/disk_limit.h\"\n\n"
            "enum { COR_DISK_LIMIT_X_ROOTS = %d, COR_DISK_LIMIT_NU_ROOTS = %d };\n",
            X_ROOTS, NU_ROOTS);
    const struct {
        const char *name;
        double value;
    } number[] = {
        {"X_FIRST", x_of_speed(FIRST_SPEED)}, {"X_STEP", x_step()}, {"NU_FIRST", FIRST_NU}, {"NU_STEP", NU_STEP}};
    for (size_t i = 0; i < sizeof number / sizeof *number; i++)
        fprintf(file, "#define COR_DISK_LIMIT_%s (%a) /* %.17g */\n", number[i].name, number[i].value, number[i].value);
    fprintf(file, "enum { COR_DISK_LIMIT_SCENES = %ld, COR_DISK_LIMIT_SECONDS = %ld };\n\n", table->scenes,
            table->seconds);
    write_nodes(file, table);
    fprintf(file, "static const struct cor_disk_limit_cell cor_disk_limit_cell[%d] = {\n", table->cells);
    for (int i = 0; i < table->cells; i++) {
        char text[CELL_TEXT];
        cell_text(text, &table->cell[i]);
        fputs(text, file);
    }
    fputs("};\n\n#endif\n", file);
    return STATUS_OK;
}

/* ---- the table that corgen was built with ---- */

bool disk_limits_known(const struct cor_disk_limit_cell *cell)
{
#ifndef COR_BOOTSTRAP
    if (!table || cell) {
        start_table();
        table->scenes = COR_DISK_LIMIT_SCENES;
        table->seconds = COR_DISK_LIMIT_SECONDS;
        table->nodes = sizeof cor_disk_limit_node / sizeof *cor_disk_limit_node;
        table->cells = sizeof cor_disk_limit_cell / sizeof *cor_disk_limit_cell;
        memcpy(table->node, cor_disk_limit_node, sizeof cor_disk_limit_node);
        memcpy(table->cell, cell ? cell : cor_disk_limit_cell, sizeof cor_disk_limit_cell);
        mark_joined(table);
        table->known = true;
    }
#else
    (void)cell;
#endif
    return table && table->known;
}

/* ---- check of the table ---- */

/* The table's value and uncertainty at a point of a cell, sides included, and whether it is a point of its grid */
static struct cor_disk_limit_result result_at(const struct scene *scene, const struct cell *cell, bool *on_grid)
{
    const struct cor_disk_limit_table t = evaluable(table);
    const int32_t sixth = sixth_of(cell), x = scene->x - cell->x, nu = scene->nu - cell->nu;
    struct cor_disk_limit_place at = cor_disk_limit_find(&t, ((double)cell->x + sixth) / (double)ROOT_SIDE,
                                                         ((double)cell->nu + sixth) / (double)ROOT_SIDE);
    at.x_in = (double)x / (SIXTHS * sixth);
    at.nu_in = (double)nu / (SIXTHS * sixth);
    *on_grid = x % (2 * sixth) == 0 && nu % (2 * sixth) == 0;
    return cor_disk_limit_in(&t, &at);
}

struct check {
    long places, between, wrong;
    double worst, worst_between; /* largest difference on the grid, and between the points relative to the
                                  * uncertainty */
};

static void check_scene(struct check *check, const struct scene *scene, const struct cell *cell)
{
    bool on_grid;
    const struct cor_disk_limit_result result = result_at(scene, cell, &on_grid);
    const double off = fabs(scene->value * COR_DISK_LIMIT_UNIT - result.value);
    const double allowed = on_grid ? DISK_LIMITS_AGREE : result.uncertainty;
    check->places += on_grid;
    check->between += !on_grid;
    if (on_grid)
        check->worst = fmax(check->worst, off);
    else
        check->worst_between = fmax(check->worst_between, off / result.uncertainty);
    if (!(off <= allowed) && check->wrong++ < SAMPLE_MISSES)
        fprintf(stderr, "corgen: " DISK_LIMITS_FILE ": v = %.9g, nu = %.9g: off by %.1e, where %.1e is allowed\n",
                speed_at(scene->x), nu_at(scene->nu), off, allowed);
}

static int check_verdict(const struct check *check, const char *of_what)
{
    if (check->wrong)
        return fail("%s: %ld of %ld collisions (%s) are not as the table says", DISK_LIMITS_FILE, check->wrong,
                    check->places + check->between, of_what);
    printf("collided again at %ld places of %s (%s): 1 - eps^2 differs by %.1e at most", check->places,
           DISK_LIMITS_FILE, of_what, check->worst);
    if (check->between)
        printf("; at %ld between them, by %.2f of the uncertainty", check->between, check->worst_between);
    printf("\n");
    return STATUS_OK;
}

/* xorshift64* */
static uint64_t sample_draw(uint64_t *state, uint64_t below)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return (*state * UINT64_C(2685821657736338717) >> 33) % below;
}

/* Samples one row of one cell, and thus one material, because its modes take as long as a collision. */
int disk_limits_check_sample(uint64_t seed)
{
    uint64_t state = 2 * seed + 1;
    for (int i = 0; i < 8; i++) /* after a few draws, seeds that differ in few bits differ in all bits */
        sample_draw(&state, 2);
    struct cell *const of_cell = places_of_cells();
    const struct cell cell = of_cell[sample_draw(&state, (uint64_t)table->cells)];
    const int32_t sixth = sixth_of(&cell),
                  row = cell.nu + 2 * (int32_t)sample_draw(&state, COR_DISK_LIMIT_SIDE) * sixth;
    struct scene scene[COR_DISK_LIMIT_SIDE + 1];
    for (int32_t k = 0; k < COR_DISK_LIMIT_SIDE; k++)
        scene[k] = (struct scene){cell.x + 2 * k * sixth, row, 0, 0};
    scene[COR_DISK_LIMIT_SIDE] = (struct scene){cell.x + (1 + 2 * (int32_t)sample_draw(&state, 3)) * sixth, row, 0, 0};
    free(of_cell);
    struct check check = {0};
    const int status = collide_all(scene, COR_DISK_LIMIT_SIDE + 1, "collisions");
    if (status != STATUS_OK)
        return status;
    for (int k = 0; k <= COR_DISK_LIMIT_SIDE; k++)
        check_scene(&check, &scene[k], &cell);
    char of_what[2 * LINE];
    snprintf(of_what, sizeof of_what, "nu = %.6g, v = %.4g to %.4g, seed %" PRIu64, nu_at(row), speed_at(cell.x),
             speed_at(cell.x + SIXTHS * sixth), seed);
    return check_verdict(&check, of_what);
}

int disk_limits_check_all(void)
{
    struct cell *const of_cell = places_of_cells();
    struct scenes scenes = {0};
    struct check check = {0};
    const int status = find_scenes(&scenes, of_cell, table->cells);
    for (int i = 0; i < table->cells && status == STATUS_OK; i++)
        for (int j = 0; j <= SIXTHS; j++)
            for (int k = j % 2; k <= SIXTHS; k += 2)
                check_scene(&check,
                            known_scene(&scenes, of_cell[i].x + k * sixth_of(&of_cell[i]),
                                        of_cell[i].nu + j * sixth_of(&of_cell[i])),
                            &of_cell[i]);
    free(of_cell);
    free(scenes.scene);
    return status == STATUS_OK ? check_verdict(&check, "all") : status;
}
