/* SPDX-License-Identifier: MIT */
#include "tables/files.h"

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
#include "support/parallel.h"
#include "sweep/hard_wall.h"

/* The plane of speed and Poisson's ratio, and the roots: its cells before any division */
#define FIRST_SPEED 1e-5
#define LAST_SPEED 0.3
#define FIRST_NU (-0.2)
#define NU_STEP 0.1375
enum { X_ROOTS = 20, NU_ROOTS = 5, ROOTS = X_ROOTS * NU_ROOTS };
#define LAST_NU (FIRST_NU + (double)NU_ROOTS * NU_STEP)
/* MOST_CUTS: largest number of divisions of a cell; a fifth division helps little (docs/disks.md). The unit of
 * coordinates, a sixth of the side of a cell that was divided FINEST times, does not depend on MOST_CUTS. */
enum { MOST_CUTS = 4, FINEST = 8, SIXTHS = 6, ROOT_SIDE = SIXTHS << FINEST };
/* PER_ROOT: number of the smallest cells, which are also the smallest pieces, along a side of a root */
enum {
    PER_ROOT = 1 << MOST_CUTS,
    SMALLEST = ROOT_SIDE / PER_ROOT,
    COLUMNS = X_ROOTS * PER_ROOT,
    ROWS = NU_ROOTS * PER_ROOT,
    PER_SQUARE = COR_DISK_LIMIT_PER_SQUARE,
    SQUARES = COLUMNS / PER_SQUARE * (ROWS / PER_SQUARE)
};
_Static_assert((int)PER_ROOT == COR_DISK_LIMIT_PER_ROOT, "the smallest pieces are the smallest cells");

/* Tolerances of the collisions up to CALM_SPEED and beyond it, and the safety factor on the error of a cell's
 * polynomial at the 9 points between its 16 points */
#define CALM_SPEED COR_DISK_EPS_CALM_SPEED
#define CALM_TOLERANCE 1.5e-5
#define FAST_TOLERANCE 5e-5
#define SAFETY 1.5
/* A cell with this uncertainty or less is not divided. */
#define CALM_WANTED 2e-5
#define FAST_WANTED 1e-4

enum { PLACES_MAX = UINT16_MAX >> 4, LINE = 64, SAMPLE_MISSES = 3 };

/* A collision, at x and nu in sixths from the corner of the plane */
struct scene {
    int32_t x, nu, value, estimate; /* in COR_DISK_LIMIT_UNIT */
};

/* A cell. x, nu: its first corner in sixths. The unit of `value` and `uncertainty` is COR_DISK_LIMIT_UNIT. value[4 j +
 * i]: at place i of x and place j of nu */
enum { SIDE = COR_DISK_LIMIT_SIDE, POINTS = COR_DISK_LIMIT_POINTS };
struct cell {
    int32_t x, nu;
    int depth;
    int32_t uncertainty, value[POINTS];
};

struct limits {
    bool known;
    long seconds; /* processor time of the collisions */
    long scenes;
    int cells, pieces, places;
    struct cell cell[PLACES_MAX];
    uint16_t cell_at[ROWS][COLUMNS];
    /* the pieces that the library evaluates */
    struct cor_disk_limit_piece piece[PLACES_MAX];
    uint16_t square[SQUARES], place[PLACES_MAX];
};
static struct limits table[1];

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

static struct cor_disk_limit_table make_evaluable(void)
{
    return (struct cor_disk_limit_table){X_ROOTS,       NU_ROOTS,     x_of_speed(FIRST_SPEED),
                                         x_step(),      FIRST_NU,     NU_STEP,
                                         table->square, table->place, table->piece};
}

/* True if the tolerance of a collision at x is CALM_TOLERANCE, as in all roots that begin below CALM_SPEED. No cell
 * then has collisions of both tolerances. */
static bool is_calm(int32_t x)
{
    const int32_t column = x > 0 ? (x - 1) / ROOT_SIDE : 0;
    return speed_at(column * ROOT_SIDE) < CALM_SPEED;
}

/* Returns the speed at which the last root that begins below CALM_SPEED ends. */
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
    struct scene *scene; /* scenes in order of place; `first`: first scene of the current material */
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

/* Computes all scenes, which are in order of place, so that the scenes of one material are adjacent. */
static int collide_all(struct scene *scene, long count, const char *name)
{
    struct collisions run = {.scene = scene};
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

/* ---- scenes with known results ---- */

struct scenes {
    struct scene *scene; /* scenes in order of place */
    long count;
};

static void add_scene(struct scenes *to, struct scene scene)
{
    to->scene = xgrow(to->scene, (size_t)to->count, sizeof *to->scene);
    to->scene[to->count++] = scene;
}

static void sort_scenes(struct scenes *scenes)
{
    if (scenes->count)
        qsort(scenes->scene, (size_t)scenes->count, sizeof *scenes->scene, by_place);
}

/* ---- cells ---- */

static int32_t sixth_of(const struct cell *cell)
{
    return (ROOT_SIDE / SIXTHS) >> cell->depth;
}

/* Returns point k of a cell. i and j, in sixths of its side, are both even (16 values) or both odd (9 tests). */
enum { PLACES = POINTS + 9 };
static struct scene point_of(const struct cell *cell, int k, int *i, int *j)
{
    *j = k / 7 * 2 + k % 7 / SIDE;
    *i = 2 * (k % 7 % SIDE) + *j % 2;
    return (struct scene){cell->x + *i * sixth_of(cell), cell->nu + *j * sixth_of(cell), 0, 0};
}

/* Returns the scene at a place, or NULL if it is not known. */
static const struct scene *known_scene(const struct scenes *scenes, struct scene key)
{
    return scenes->count ? bsearch(&key, scenes->scene, (size_t)scenes->count, sizeof key, by_place) : NULL;
}

static int find_scenes(struct scenes *scenes, const struct cell *cell, int cells)
{
    struct scenes needed = {0};
    long count = 0;
    for (int k = 0, i, j; k < cells * PLACES; k++) {
        const struct scene scene = point_of(&cell[k / PLACES], k % PLACES, &i, &j);
        if (!known_scene(scenes, scene))
            add_scene(&needed, scene);
    }
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

/* Computes the weights of Lagrange's interpolation through 0, 1, 2, 3 at the place `a`. They are exact if `a` has few
 * bits. */
static void set_weights(double a, double weight[SIDE])
{
    const double b = a - 1, c = a - 2, d = a - 3;
    weight[0] = b * c * d / -6;
    weight[1] = a * c * d / 2;
    weight[2] = a * b * d / -2;
    weight[3] = a * b * c / 6;
}

/* Evaluates the cell's own polynomial, before blending, with the weights of a place, in COR_DISK_LIMIT_UNIT. */
static double cell_value(const struct cell *cell, const double x_weight[SIDE], const double nu_weight[SIDE])
{
    double sum = 0;
    for (int k = 0; k < POINTS; k++)
        sum += nu_weight[k / SIDE] * x_weight[k % SIDE] * cell->value[k];
    return sum;
}

/* Sets the cell's values and the uncertainty of its polynomial. */
static void fill_cell(struct cell *cell, const struct scenes *scenes)
{
    int32_t estimate = 0;
    double missed = 0;
    for (int odd = 0; odd < 2; odd++) /* first the values, then the tests; see point_of */
        for (int k = 0, i, j; k < PLACES; k++) {
            const struct scene *const s = known_scene(scenes, point_of(cell, k, &i, &j));
            double x_weight[SIDE], nu_weight[SIDE];
            if (j % 2 != odd)
                continue;
            estimate = s->estimate > estimate ? s->estimate : estimate;
            if (!odd)
                cell->value[SIDE * j / 2 + i / 2] = s->value;
            set_weights(i / 2.0, x_weight);
            set_weights(j / 2.0, nu_weight);
            if (odd)
                missed = fmax(missed, fabs(cell_value(cell, x_weight, nu_weight) - s->value));
        }
    /* root of the sum of squares: the two parts are independent, and each is several times the actual error */
    cell->uncertainty = (int32_t)ceil(hypot(SAFETY * missed, estimate)) + 1;
}

/* Returns the largest uncertainty that a cell at x may have without being divided. */
static double wanted_at(int32_t x)
{
    return is_calm(x + 1) ? CALM_WANTED : FAST_WANTED;
}

static void cell_cut(const struct cell *cell, struct cell *quarter)
{
    const int32_t half = SIXTHS / 2 * sixth_of(cell);
    for (int k = 0; k < 4; k++)
        quarter[k] =
            (struct cell){.x = cell->x + k % 2 * half, .nu = cell->nu + k / 2 * half, .depth = cell->depth + 1};
}

static void add_cell(struct cell cell)
{
    const int side = PER_ROOT >> cell.depth, x = cell.x / SMALLEST, nu = cell.nu / SMALLEST;
    for (int k = 0; k < side * side; k++)
        table->cell_at[nu + k / side][x + k % side] = (uint16_t)table->cells;
    table->cell[table->cells++] = cell;
}

/* Adds each cell of one depth to the table, or divides it. *cell becomes the list of the quarters. */
static int cell_refine(struct scenes *scenes, struct cell **cell, int *cells)
{
    int status = find_scenes(scenes, *cell, *cells), cut_cells = 0;
    struct cell *const next = xmalloc(4 * (size_t)*cells * sizeof *next);
    for (int i = 0; i < *cells && status == STATUS_OK; i++) {
        struct cell *const c = &(*cell)[i];
        fill_cell(c, scenes);
        if (c->depth < MOST_CUTS && c->uncertainty * COR_DISK_LIMIT_UNIT > wanted_at(c->x))
            cell_cut(c, next + 4 * cut_cells++);
        else if (table->cells == PLACES_MAX)
            status = fail("the table needs more than %d cells", PLACES_MAX);
        else
            add_cell(*c);
    }
    free(*cell);
    *cell = next;
    *cells = 4 * cut_cells;
    return status;
}

/* ---- pieces ---- */

/* A part of a cell. The unit of length is the side of the smallest piece; [0] is in x, [1] in nu. */
struct part {
    const struct cell *cell;
    int first[2], side[2];
};

/* Returns the cell beyond a side of the part's cell, next to the middle of the part. Returns NULL unless that cell is
 * smaller. axis: perpendicular to the side; last: 0 for the first side, 1 for the last side */
static const struct cell *smaller_beyond(const struct part *part, int axis, int last)
{
    const int side = PER_ROOT >> part->cell->depth, end = axis ? ROWS : COLUMNS;
    int at[2] = {part->first[0] + part->side[0] / 2, part->first[1] + part->side[1] / 2};
    at[axis] = part->first[axis] / side * side + (last ? side : -1);
    if (at[axis] < 0 || at[axis] == end)
        return NULL;
    const struct cell *const other = &table->cell[table->cell_at[at[1]][at[0]]];
    return other->depth > part->cell->depth ? other : NULL;
}

/* Returns the place of a point on an axis of a cell, 0 to 3. The unit of `at` is a third of the smallest piece. */
static double place_in(const struct cell *cell, int axis, int at)
{
    const int first = (axis ? cell->nu : cell->x) / SMALLEST;
    return (double)(at - 3 * first) / (double)(PER_ROOT >> cell->depth);
}

/* Evaluates the polynomial on a side of a cell. */
static double value_on_side(const struct cell *cell, int axis, int last, int at)
{
    double weight[2][SIDE] = {{0}};
    set_weights(place_in(cell, !axis, at), weight[!axis]);
    weight[axis][(SIDE - 1) * last] = 1;
    return cell_value(cell, weight[0], weight[1]);
}

/* Evaluates the table's function in a part of a cell, (17.5) of docs/theory-disks.md, at place i of x and j of nu. The
 * numbers have few bits, so that the result is exact. */
static double value_in_part(const struct part *part, int i, int j)
{
    const int at[2] = {3 * part->first[0] + i * part->side[0], 3 * part->first[1] + j * part->side[1]};
    double weight[2][SIDE];
    for (int axis = 0; axis < 2; axis++)
        set_weights(place_in(part->cell, axis, at[axis]), weight[axis]);
    double value = cell_value(part->cell, weight[0], weight[1]);
    for (int side = 0; side < 4; side++) {
        const int axis = side % 2, last = side / 2;
        const struct cell *const other = smaller_beyond(part, axis, last);
        if (other)
            value += weight[axis][(SIDE - 1) * last] *
                     (value_on_side(other, axis, !last, at[!axis]) - value_on_side(part->cell, axis, last, at[!axis]));
    }
    return value;
}

/* Converts four values at 0, 1/3, 2/3, 1, `stride` apart, to the coefficients of the polynomial through them. */
static void to_powers(double *value, int stride)
{
    const double a = value[0], b = value[stride], c = value[2 * stride], d = value[3 * stride];
    value[stride] = (-11 * a + 18 * b - 9 * c + 2 * d) / 2;
    value[2 * stride] = 9 * (2 * a - 5 * b + 4 * c - d) / 2;
    value[3 * stride] = 9 * (-a + 3 * b - 3 * c + d) / 2;
}

/* Cuts a part until each of its sides has only one neighbour, and adds the pieces to the table. Stores the index of
 * each piece in piece_at. Returns false if there are too many pieces. */
static bool add_pieces(const struct part *part, uint16_t piece_at[ROWS][COLUMNS])
{
    bool cut[2] = {false, false};
    for (int side = 0; side < 4; side++) {
        const struct cell *const other = smaller_beyond(part, side % 2, side / 2);
        const int along = !(side % 2);
        cut[along] |= other && PER_ROOT >> other->depth < part->side[along];
    }
    if (cut[0] || cut[1]) {
        const int axis = !cut[0] || (cut[1] && part->side[1] >= part->side[0]);
        struct part half[2] = {*part, *part};
        half[0].side[axis] = half[1].side[axis] = part->side[axis] / 2;
        half[1].first[axis] += part->side[axis] / 2;
        return add_pieces(&half[0], piece_at) && add_pieces(&half[1], piece_at);
    }
    if (table->pieces == PLACES_MAX)
        return false;
    for (int k = 0; k < part->side[0] * part->side[1]; k++)
        piece_at[part->first[1] + k / part->side[0]][part->first[0] + k % part->side[0]] = (uint16_t)table->pieces;
    struct cor_disk_limit_piece *const piece = &table->piece[table->pieces++];
    *piece = (struct cor_disk_limit_piece){.x = (double)part->first[0] / PER_ROOT,
                                           .nu = (double)part->first[1] / PER_ROOT,
                                           .per_x = (float)PER_ROOT / (float)part->side[0],
                                           .per_nu = (float)PER_ROOT / (float)part->side[1],
                                           .uncertainty = (uint16_t)part->cell->uncertainty,
                                           .depth = (uint16_t)part->cell->depth};
    for (int k = 0; k < POINTS; k++)
        piece->coefficient[k] = value_in_part(part, k % SIDE, k / SIDE);
    for (int k = 0; k < SIDE; k++)
        to_powers(piece->coefficient + SIDE * k, 1);
    for (int k = 0; k < SIDE; k++)
        to_powers(piece->coefficient + k, SIDE);
    return true;
}

/* Divides an axis of a square into 2^n equal parts. Returns the least n for which the piece does not change along this
 * axis within a part. */
static int square_bits(uint16_t piece_at[ROWS][COLUMNS], int x, int nu, int axis)
{
    int bits = 0;
    for (int k = 0; k < PER_SQUARE * PER_SQUARE; k++) {
        const int at[2] = {k % PER_SQUARE, k / PER_SQUARE};
        int first[2] = {at[0], at[1]};
        first[axis] &= -(PER_SQUARE >> bits);
        while (piece_at[nu + at[1]][x + at[0]] != piece_at[nu + first[1]][x + first[0]]) {
            bits++;
            first[axis] = at[axis] & -(PER_SQUARE >> bits);
        }
    }
    return bits;
}

/* Sets pieces, squares and places from the cells. */
static int make_pieces(void)
{
    static uint16_t piece_at[ROWS][COLUMNS];
    bool fits = true;
    table->pieces = table->places = 0;
    for (int i = 0; i < table->cells && fits; i++) {
        const struct cell *const c = &table->cell[i];
        const int side = PER_ROOT >> c->depth;
        const struct part whole = {c, {c->x / SMALLEST, c->nu / SMALLEST}, {side, side}};
        fits = add_pieces(&whole, piece_at);
    }
    for (int i = 0; i < SQUARES && fits; i++) {
        const int x = i * PER_SQUARE % COLUMNS, nu = i * PER_SQUARE / COLUMNS * PER_SQUARE;
        const int x_bits = square_bits(piece_at, x, nu, 0), nu_bits = square_bits(piece_at, x, nu, 1);
        fits = table->places + (1 << (x_bits + nu_bits)) <= PLACES_MAX;
        table->square[i] = (uint16_t)(table->places << 4 | nu_bits << 2 | x_bits);
        for (int k = 0; k < 1 << (x_bits + nu_bits) && fits; k++)
            table->place[table->places++] =
                piece_at[nu + (k >> x_bits) * (PER_SQUARE >> nu_bits)][x + k % (1 << x_bits) * (PER_SQUARE >> x_bits)];
    }
    return fits ? STATUS_OK : fail("the table needs more than %d pieces or places", PLACES_MAX);
}

int disk_limits_collide(void)
{
    const double start = (double)clock() / CLOCKS_PER_SEC;
    struct scenes scenes = {0};
    struct cell *cell = xmalloc(ROOTS * sizeof *cell);
    int cells = ROOTS, status = STATUS_OK;
    memset(table, 0, sizeof table);
    for (int i = 0; i < ROOTS; i++)
        cell[i] = (struct cell){.x = i % X_ROOTS * ROOT_SIDE, .nu = i / X_ROOTS * ROOT_SIDE};
    while (cells > 0 && status == STATUS_OK)
        status = cell_refine(&scenes, &cell, &cells);
    free(cell);
    if (status == STATUS_OK)
        status = make_pieces();
    table->scenes = scenes.count;
    table->seconds = lround((double)clock() / CLOCKS_PER_SEC - start);
    table->known = status == STATUS_OK;
    free(scenes.scene);
    return status;
}

/* ---- the file ---- */

static int by_size(const void *a, const void *b)
{
    const int32_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

static void write_banner(FILE *file)
{
    int32_t calm = 0, fast = 0, *const uncertainty = xmalloc((size_t)table->cells * sizeof *uncertainty);
    int of_depth[MOST_CUTS + 1] = {0}, deepest = 0;
    for (int i = 0; i < table->cells; i++) {
        const struct cell *const c = &table->cell[i];
        int32_t *const most = is_calm(c->x + 1) ? &calm : &fast;
        uncertainty[i] = c->uncertainty;
        *most = c->uncertainty > *most ? c->uncertainty : *most;
        of_depth[c->depth]++;
        deepest = c->depth > deepest ? c->depth : deepest;
    }
    qsort(uncertainty, (size_t)table->cells, sizeof *uncertainty, by_size);
    const int32_t median = uncertainty[table->cells / 2];
    free(uncertainty);
    fprintf(
        file,
        "/* SPDX-License-Identifier: MIT */\n"
        "/* 1 - eps^2 of an elastic disk of all its modes at a rigid wall (cor_disk_hard_wall), E = rho = R = 1, for\n"
        " * speeds from %g to %g and Poisson's ratios from %g to %g in plane stress. Evaluated by "
        "runtime/disk/limits.c.\n"
        " *\n"
        " * %ld collisions with the tolerance %g up to v = %g and %g beyond (errors estimated by "
        "cor_disk_hard_wall).\n"
        " * The plane of x = v^(1/8) and nu is cut into %d cells, of depths 0 to %d: ",
        FIRST_SPEED, LAST_SPEED, FIRST_NU, LAST_NU, table->scenes, CALM_TOLERANCE, calm_end(), FAST_TOLERANCE,
        table->cells, deepest);
    for (int k = 0; k <= deepest; k++)
        fprintf(file, "%s%d", k ? ", " : "", of_depth[k]);
    fprintf(file,
            ". A polynomial\n"
            " * of degree 3 interpolates the 4 x 4 collisions of a cell and is joined on its sides: %d pieces,\n"
            " * runtime/core/disk_limit.h.\n"
            " *\n"
            " * Uncertainty of a cell: the root of the sum of two squares, of %g times the largest error of its "
            "polynomial\n"
            " * at 9 collisions between the 16 (measured), and of the largest estimated error of these 25 collisions.\n"
            " * It is an estimate, not a bound: at most %.1e in cells below v = %g, %.2e in the others,\n"
            " * %.1e in half of all.\n"
            " *\n"
            " * Written by:  corgen tables --all, in %ld seconds of processor time\n"
            " * Checked by:  corgen tables --check, which computes one row of one cell again, and corgen tables\n"
            " *              --check --all */\n",
            table->pieces, SAFETY, calm * COR_DISK_LIMIT_UNIT, calm_end(), fast * COR_DISK_LIMIT_UNIT,
            median * COR_DISK_LIMIT_UNIT, table->seconds);
}

static void write_numbers(FILE *file, const char *name, const uint16_t *number, int count)
{
    enum { A_LINE = 80 };
    fprintf(file, "static const uint16_t cor_disk_limit_%s[%d] = {", name, count);
    for (int i = 0; i < count; i++)
        fprintf(file, "%s%u%s", i % A_LINE ? " " : "\n    ", number[i], i + 1 < count ? "," : "");
    fputs("\n};\n\n", file);
}

int disk_limits_write(FILE *file)
{
    write_banner(file);
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
    write_numbers(file, "square", table->square, SQUARES);
    write_numbers(file, "place", table->place, table->places);
    fprintf(file, "static const struct cor_disk_limit_piece cor_disk_limit_piece[%d] = {\n", table->pieces);
    for (const struct cor_disk_limit_piece *p = table->piece; p < table->piece + table->pieces; p++) {
        fprintf(file, "    {%.17g, %.17g, %g, %g, %d, %d, {", p->x, p->nu, (double)p->per_x, (double)p->per_nu,
                p->uncertainty, p->depth);
        for (int k = 0; k < POINTS; k++)
            fprintf(file, "%s%.17g", k ? ", " : "", p->coefficient[k]);
        fputs("}},\n", file);
    }
    fputs("};\n\n#endif\n", file);
    return STATUS_OK;
}

/* ---- the table that corgen was built with ---- */

#ifndef COR_BOOTSTRAP
/* Sets the cells from the pieces. */
static void read_cells(void)
{
    const struct cor_disk_limit_table t = make_evaluable();
    memset(table->cell_at, UINT8_MAX, sizeof table->cell_at);
    for (int i = 0; i < table->pieces; i++) {
        const struct cor_disk_limit_piece *const piece = &table->piece[i];
        const int32_t side = ROOT_SIDE >> piece->depth, third = side / 3;
        struct cell cell = {.x = (int32_t)(piece->x * ROOT_SIDE) / side * side,
                            .nu = (int32_t)(piece->nu * ROOT_SIDE) / side * side,
                            .depth = piece->depth,
                            .uncertainty = piece->uncertainty};
        if (table->cell_at[cell.nu / SMALLEST][cell.x / SMALLEST] != UINT16_MAX)
            continue;
        for (int k = 0; k < POINTS; k++) {
            const int line = k / SIDE;
            const double x = (double)(cell.x + third * (k % SIDE)) / (double)ROOT_SIDE,
                         nu = (double)(cell.nu + third * line) / (double)ROOT_SIDE;
            cell.value[k] =
                (int32_t)lround(cor_disk_limit_value(cor_disk_limit_find(&t, x, nu), x, nu) / COR_DISK_LIMIT_UNIT);
        }
        add_cell(cell);
    }
}
#endif

bool disk_limits_known(const struct cor_disk_limit_piece *piece)
{
#ifndef COR_BOOTSTRAP
    if (!table->known || piece) {
        memset(table, 0, sizeof table);
        table->scenes = COR_DISK_LIMIT_SCENES;
        table->seconds = COR_DISK_LIMIT_SECONDS;
        table->pieces = sizeof cor_disk_limit_piece / sizeof *cor_disk_limit_piece;
        memcpy(table->square, cor_disk_limit_square, sizeof cor_disk_limit_square);
        memcpy(table->place, cor_disk_limit_place, sizeof cor_disk_limit_place);
        memcpy(table->piece, piece ? piece : cor_disk_limit_piece, sizeof cor_disk_limit_piece);
        read_cells();
        table->known = make_pieces() == STATUS_OK;
    }
#else
    (void)piece;
#endif
    return table->known;
}

/* ---- check of the table ---- */

struct check {
    long places[2], wrong; /* numbers of collisions on the grid and between its points */
    double worst[2];       /* on the grid: largest difference; between its points: largest difference/uncertainty */
};

static void check_scene(struct check *check, const struct scene *scene, const struct cell *cell)
{
    const struct cor_disk_limit_table t = make_evaluable();
    const int32_t place = 2 * sixth_of(cell);
    const bool between = (scene->x - cell->x) % place != 0 || (scene->nu - cell->nu) % place != 0;
    const double x = (double)scene->x / (double)ROOT_SIDE, nu = (double)scene->nu / (double)ROOT_SIDE;
    const double value = cor_disk_limit_value(cor_disk_limit_find(&t, x, nu), x, nu);
    const double uncertainty = cor_disk_limit_uncertainty(&t, x, nu);
    const double off = fabs(scene->value * COR_DISK_LIMIT_UNIT - value);
    const double allowed = between ? uncertainty : DISK_LIMITS_AGREE;
    check->places[between]++;
    check->worst[between] = fmax(check->worst[between], between ? off / uncertainty : off);
    if (!(off <= allowed) && check->wrong++ < SAMPLE_MISSES)
        fail(DISK_LIMITS_FILE ": v = %.9g, nu = %.9g: the difference is %.1e, allowed: %.1e", speed_at(scene->x),
             nu_at(scene->nu), off, allowed);
}

static int check_verdict(const struct check *check, const char *of_what)
{
    if (check->wrong)
        return fail("%s: %ld of %ld collisions (%s) differ from the table by more than allowed", DISK_LIMITS_FILE,
                    check->wrong, check->places[0] + check->places[1], of_what);
    printf("computed again at %ld places of %s (%s): 1 - eps^2 differs by %.1e at most. At %ld places between them, it "
           "differs "
           "by %.2f of the uncertainty at most\n",
           check->places[0], DISK_LIMITS_FILE, of_what, check->worst[0], check->places[1], check->worst[1]);
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

/* Checks one row of one cell. A row has one nu, and the modes for it take as long to compute as a collision. */
int disk_limits_check_sample(uint64_t seed)
{
    uint64_t state = 2 * seed + 1;
    for (int i = 0; i < 8; i++) /* mixes the bits, so that similar seeds give unrelated draws */
        sample_draw(&state, 2);
    const struct cell cell = table->cell[sample_draw(&state, (uint64_t)table->cells)];
    const int32_t sixth = sixth_of(&cell), row = cell.nu + 2 * (int32_t)sample_draw(&state, SIDE) * sixth;
    struct scene scene[SIDE + 1];
    for (int32_t k = 0; k < SIDE; k++)
        scene[k] = (struct scene){cell.x + 2 * k * sixth, row, 0, 0};
    scene[SIDE] = (struct scene){cell.x + (1 + 2 * (int32_t)sample_draw(&state, 3)) * sixth, row, 0, 0};
    struct check check = {0};
    const int status = collide_all(scene, SIDE + 1, "collisions");
    if (status != STATUS_OK)
        return status;
    for (int k = 0; k <= SIDE; k++)
        check_scene(&check, &scene[k], &cell);
    char of_what[2 * LINE];
    snprintf(of_what, sizeof of_what, "nu = %.6g, v = %.4g to %.4g, seed %" PRIu64, nu_at(row), speed_at(cell.x),
             speed_at(cell.x + SIXTHS * sixth), seed);
    return check_verdict(&check, of_what);
}

int disk_limits_check_all(void)
{
    struct scenes scenes = {0};
    struct check check = {0};
    const int status = find_scenes(&scenes, table->cell, table->cells);
    for (int k = 0, i, j; k < table->cells * PLACES && status == STATUS_OK; k++) {
        const struct cell *const cell = &table->cell[k / PLACES];
        check_scene(&check, known_scene(&scenes, point_of(cell, k % PLACES, &i, &j)), cell);
    }
    free(scenes.scene);
    return status == STATUS_OK ? check_verdict(&check, "all") : status;
}
