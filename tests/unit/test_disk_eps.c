/* SPDX-License-Identifier: MIT */
/* Tests the restitution of a disk with all its modes at a rigid wall. The table is interpolated by another method, the
 * uncertainty is compared with collisions, and the limits with other known facts. */
#include "check.h"

#include "cor/disk.h"
#include "cor/status.h"
#include "generated/disk_limits.h"

enum {
    PIECES = sizeof cor_disk_limit_piece / sizeof *cor_disk_limit_piece,
    PER_ROOT = COR_DISK_LIMIT_PER_ROOT,
    COLUMNS = COR_DISK_LIMIT_X_ROOTS * PER_ROOT,
    ROWS = COR_DISK_LIMIT_NU_ROOTS * PER_ROOT
};

/* ---- the table ---- */

/* A cell: its corner and side in units of the roots, and its collisions */
struct cell {
    long double x, nu, side;
    double uncertainty;
    int value[COR_DISK_LIMIT_POINTS];
};
static struct cell cell[PIECES];
static int cells;
/* the cell at each of the smallest squares, x fastest */
static const struct cell *cell_at[ROWS * COLUMNS];
static const struct cor_disk_limit_piece *piece_at[ROWS * COLUMNS];

/* Sets the values of a cell at the places that are in a piece. The values are whole numbers that other pieces share. */
static void values_of_piece(struct cell *of, const struct cor_disk_limit_piece *piece)
{
    for (int k = 0; k < COR_DISK_LIMIT_POINTS; k++) {
        const long double s = (of->x + k % 4 * of->side / 3 - piece->x) * piece->per_x,
                          t = (of->nu + k / 4 * of->side / 3 - piece->nu) * piece->per_nu;
        if (fabsl(s - 0.5L) > 0.5L + 1e-15L || fabsl(t - 0.5L) > 0.5L + 1e-15L)
            continue;
        long double sum = 0;
        for (int i = 15; i >= 0; i--)
            sum += piece->coefficient[i] * powl(s, i % 4) * powl(t, i / 4);
        const int value = (int)lroundl(sum);
        assert_true(value > 0 && fabsl(sum - value) < 1e-8L && (of->value[k] == 0 || of->value[k] == value));
        of->value[k] = value;
    }
}

/* The cells, assembled from their pieces, cover the plane once. */
TEST(test_cells)
{
    for (int i = 0; i < PIECES; i++) {
        const struct cor_disk_limit_piece *const piece = &cor_disk_limit_piece[i];
        const double side = ldexp(1, -piece->depth);
        struct cell *of = cell;
        const struct cell whole = {
            side * floor(piece->x / side), side * floor(piece->nu / side), side, piece->uncertainty, {0}};
        while (of < cell + cells && (of->x != whole.x || of->nu != whole.nu))
            of++;
        if (of == cell + cells)
            cell[cells++] = whole;
        assert_true(of->side == whole.side && of->uncertainty == whole.uncertainty);
        values_of_piece(of, piece);
        for (int k = 0; k < ROWS * COLUMNS; k++) {
            const double x = (k % COLUMNS + 0.5) / PER_ROOT - piece->x, nu = (k / COLUMNS + 0.5) / PER_ROOT - piece->nu;
            if (x < 0 || x * piece->per_x > 1 || nu < 0 || nu * piece->per_nu > 1)
                continue;
            assert_null(cell_at[k]);
            cell_at[k] = of;
            piece_at[k] = piece;
        }
    }
    for (int i = 0; i < 16 * cells; i++)
        assert_true(cell[i / 16].value[i % 16] > 0);
    for (int k = 0; k < ROWS * COLUMNS; k++)
        assert_non_null(cell_at[k]);
}

/* The lookup finds the piece that contains a point, even close to the corners of pieces. */
TEST(test_places)
{
    const struct cor_disk_limit_table table = {COR_DISK_LIMIT_X_ROOTS, COR_DISK_LIMIT_NU_ROOTS, COR_DISK_LIMIT_X_FIRST,
                                               COR_DISK_LIMIT_X_STEP,  COR_DISK_LIMIT_NU_FIRST, COR_DISK_LIMIT_NU_STEP,
                                               cor_disk_limit_square,  cor_disk_limit_place,    cor_disk_limit_piece};
    for (int k = 0; k < 4 * ROWS * COLUMNS; k++) {
        const double x = (k / 4 % COLUMNS + (k % 2 ? 0.001 : 0.999)) / PER_ROOT,
                     nu = (k / 4 / COLUMNS + (k / 2 % 2 ? 0.001 : 0.999)) / PER_ROOT;
        assert_true(cor_disk_limit_find(&table, x, nu) == piece_at[k / 4]);
    }
    assert_true(fabs(pow(COR_DISK_LIMIT_X_FIRST, 8) / COR_DISK_EPS_MIN_SPEED - 1) < 1e-14);
    assert_true(fabs(pow(COR_DISK_LIMIT_X_FIRST + (double)COR_DISK_LIMIT_X_ROOTS * COR_DISK_LIMIT_X_STEP, 8) /
                         COR_DISK_EPS_MAX_SPEED -
                     1) < 1e-14);
    assert_true(COR_DISK_LIMIT_NU_FIRST == COR_DISK_EPS_MIN_NU);
    assert_true(fabs(COR_DISK_LIMIT_NU_FIRST + (double)COR_DISK_LIMIT_NU_ROOTS * COR_DISK_LIMIT_NU_STEP -
                     COR_DISK_EPS_MAX_NU) < 1e-15);
}

static const struct cell *cell_of(long double x, long double nu)
{
    const int column = (int)(x * PER_ROOT), row = (int)(nu * PER_ROOT);
    return cell_at[(row < ROWS ? row : ROWS - 1) * COLUMNS + (column < COLUMNS ? column : COLUMNS - 1)];
}

/* Returns Neville's interpolation through four values at 0, 1/3, 2/3, 1. */
static long double neville(const long double value[4], long double t)
{
    long double p[4] = {value[0], value[1], value[2], value[3]};
    for (int order = 1; order < 4; order++)
        for (int i = 0; i + order < 4; i++)
            p[i] =
                ((3 * t - (long double)(i + order)) * p[i] - (3 * t - (long double)i) * p[i + 1]) / -(long double)order;
    return p[0];
}

/* Returns the four values on a side of a cell. across: the side is in x, otherwise in nu. last: the second side */
static void values_on_side(const struct cell *of, int across, int last, long double value[4])
{
    for (int k = 0; k < 4; k++)
        value[k] = across ? of->value[4 * k + 3 * last] : of->value[12 * last + k];
}

/* Returns the cell beyond a side, or NULL where the table ends. */
static const struct cell *cell_beyond(const struct cell *at, int across, int last, long double x, long double y)
{
    const long double beyond = (across ? at->x : at->nu) + (last ? 1 : 0) * at->side + (last ? 1 : -1) * 0x1p-12L;
    *(across ? &x : &y) = beyond;
    const int ends = beyond < 0 || beyond > (across ? COR_DISK_LIMIT_X_ROOTS : COR_DISK_LIMIT_NU_ROOTS);
    return ends ? NULL : cell_of(x, y);
}

/* Returns the polynomial of a cell, joined to smaller neighbours. On a side next to a smaller cell it must equal the
 * polynomial of the smaller cell. On a side in nu, that polynomial replaces the cell's own. On a side in x, the
 * difference is interpolated with zeros elsewhere and added. */
static long double joined(const struct cell *at, long double x, long double y, long double *uncertainty)
{
    const long double x_in = (x - at->x) / at->side, y_in = (y - at->nu) / at->side;
    long double along[4], beside[4] = {0};
    for (int j = 0; j < 4; j++) {
        long double row[4];
        for (int i = 0; i < 4; i++)
            row[i] = at->value[4 * j + i];
        along[j] = neville(row, x_in);
    }
    *uncertainty = at->uncertainty;
    for (int side = 0; side < 4; side++) {
        const int across = side / 2, last = side % 2;
        const struct cell *const other = cell_beyond(at, across, last, x, y);
        if (other == NULL || other->side >= at->side)
            continue;
        long double own[4], others[4], unit[4] = {0};
        unit[3 * last] = 1;
        values_on_side(at, across, last, own);
        values_on_side(other, across, !last, others);
        const long double theirs =
            neville(others, across ? (y - other->nu) / other->side : (x - other->x) / other->side);
        if (across)
            beside[3 * last] = theirs - neville(own, y_in);
        else
            along[3 * last] = theirs;
        const long double part = fabsl(neville(unit, across ? x_in : y_in));
        *uncertainty = fmaxl(*uncertainty, (1 - part) * at->uncertainty + part * other->uncertainty);
    }
    *uncertainty *= 1e-7L;
    return 1e-7L * (neville(along, y_in) + neville(beside, x_in));
}

TEST(test_between)
{
    for (size_t k = points(20000); k > 0; k--) {
        const double v = random_log(&draw, COR_DISK_EPS_MIN_SPEED, COR_DISK_EPS_MAX_SPEED);
        const double nu = random_uniform(&draw, COR_DISK_EPS_MIN_NU, COR_DISK_EPS_MAX_NU);
        const long double x = (powl(v, 0.125L) - COR_DISK_LIMIT_X_FIRST) / COR_DISK_LIMIT_X_STEP,
                          y = ((long double)nu - COR_DISK_LIMIT_NU_FIRST) / COR_DISK_LIMIT_NU_STEP;
        long double uncertainty;
        const long double value = joined(cell_of(x, y), x, y, &uncertainty);
        const double found = cor_disk_one_minus_eps2(v, nu), off = cor_disk_one_minus_eps2_uncertainty(v, nu);
        check(fabsl(found - value) <= 1e-13L, "v = %a, nu = %a: %.15f instead of %.15Lf", v, nu, found, value);
        check(fabsl(off - uncertainty) <= 1e-17L, "v = %a, nu = %a: uncertainty %g instead of %Lg", v, nu, off,
              uncertainty);
    }
}

/* ---- borders ---- */

/* A random point on a side of a rectangle. `off`: the distances in v and nu from this border to the two compared
 * points. */
struct border {
    double v, nu, off[2];
    long double x, y;
};

/* Draws a border. Returns 0 where the table ends. */
static int border_draw(struct random_state *random, long double x, long double y, const long double size[2], int side,
                       struct border *border)
{
    const int across = side / 2, last = side % 2;
    x += size[0] * (across ? last : random_uniform(random, 0, 1));
    y += size[1] * (across ? random_uniform(random, 0, 1) : last);
    if (across ? x == 0 || x == COR_DISK_LIMIT_X_ROOTS : y == 0 || y == COR_DISK_LIMIT_NU_ROOTS)
        return 0;
    const double v = (double)powl(COR_DISK_LIMIT_X_FIRST + COR_DISK_LIMIT_X_STEP * x, 8);
    *border = (struct border){v,
                              (double)(COR_DISK_LIMIT_NU_FIRST + COR_DISK_LIMIT_NU_STEP * y),
                              {across ? 1e-13 * v : 0, across ? 0 : 1e-13},
                              x,
                              y};
    return 1;
}

/* Returns a function just before the border (side = -1) or just after it (1). */
static double at_border(double (*f)(double v, double nu), const struct border *at, int side)
{
    return f(at->v + side * at->off[0], at->nu + side * at->off[1]);
}

/* At the sides of all pieces no function jumps, except by rounding. COR_TEST_MULTIPLIER=250: 24 10^6 pairs. */
TEST(test_borders)
{
    size_t pairs = 0;
    double worst = 0;
    for (size_t k = points(20); k > 0; k--)
        for (int i = 0; i < 4 * PIECES; i++) {
            const struct cor_disk_limit_piece *const piece = &cor_disk_limit_piece[i / 4];
            const long double size[2] = {1 / piece->per_x, 1 / piece->per_nu};
            struct border at;
            if (!border_draw(&draw, piece->x, piece->nu, size, i % 4, &at))
                continue;
            for (int k = 0; k < 2; k++) {
                double (*const f)(double, double) = k ? cor_disk_eps : cor_disk_one_minus_eps2;
                const double jump = fabs(at_border(f, &at, 1) - at_border(f, &at, -1));
                check(jump <= COR_DISK_EPS_MAX_JUMP, "v = %.17g, nu = %.17g: a jump of %.1e", at.v, at.nu, jump);
                worst = fmax(worst, jump);
            }
            pairs++;
        }
    print_message("%zu pairs across borders: jumps of %.1e at most\n", pairs, worst);
}

/* ---- against collisions ---- */

/* The largest error of a test relative to the uncertainty, and its largest absolute error */
static double worst_part, worst_error;

static void compare(double v, double nu, double uncertainty)
{
    const struct cor_disk_hard_wall_options options = {5e-6, 0};
    struct cor_disk_hard_wall wall;
    const int status = cor_disk_hard_wall_nu(nu, &options, v, &wall);
    assert_true(status == COR_OK || status == COR_TOLERANCE_NOT_REACHED);
    const double off = fabs(cor_disk_one_minus_eps2(v, nu) - wall.one_minus_eps2);
    check(off <= uncertainty, "v = %.17g, nu = %.17g: %.7f, off by %.1e, uncertain by %.1e", v, nu,
          cor_disk_one_minus_eps2(v, nu), off, uncertainty);
    worst_part = fmax(worst_part, off / uncertainty);
    worst_error = fmax(worst_error, off);
}

static void print_worst(const char *where)
{
    print_message("%s: off by %.1e at most, by %.2f of the uncertainty at most\n", where, worst_error, worst_part);
    worst_part = worst_error = 0;
}

/* Collisions at places off the grid: no error exceeds the uncertainty. COR_TEST_MULTIPLIER=250: 1000 places. */
TEST(test_uncertainty)
{
    const double first = pow(COR_DISK_EPS_MIN_SPEED, 0.125), last = pow(COR_DISK_EPS_MAX_SPEED, 0.125);
    for (size_t k = points(4); k > 0; k--) {
        const double v = pow(random_uniform(&draw, first, last), 8);
        const double nu = random_uniform(&draw, COR_DISK_EPS_MIN_NU, COR_DISK_EPS_MAX_NU);
        compare(v, nu, cor_disk_one_minus_eps2_uncertainty(v, nu));
    }
    print_worst("off the grid");
}

/* At a border with smaller cells, and up to a third of a side from it, the uncertainty is at least the error.
 * COR_TEST_MULTIPLIER=250: 500 places. */
TEST(test_uncertainty_at_borders)
{
    for (size_t places = points(2); places > 0;) {
        const struct cell *const own = &cell[random_below(&draw, (size_t)cells)];
        const int side = (int)random_below(&draw, 4), across = side / 2, last = side % 2;
        const long double size[2] = {own->side, own->side};
        struct border at;
        if (!border_draw(&draw, own->x, own->nu, size, side, &at) ||
            cell_beyond(own, across, last, at.x, at.y)->side >= own->side)
            continue;
        if (places-- % 2 == 0) {
            compare(at.v, at.nu,
                    fmin(at_border(cor_disk_one_minus_eps2_uncertainty, &at, -1),
                         at_border(cor_disk_one_minus_eps2_uncertainty, &at, 1)));
            continue;
        }
        const double inwards = (double)own->side * random_uniform(&draw, 0, 1.0 / 3) * (last ? -1 : 1);
        const double v = across ? pow(pow(at.v, 0.125) + inwards * COR_DISK_LIMIT_X_STEP, 8) : at.v;
        const double nu = across ? at.nu : at.nu + inwards * COR_DISK_LIMIT_NU_STEP;
        compare(v, nu, cor_disk_one_minus_eps2_uncertainty(v, nu));
    }
    print_worst("on and near borders");
}

/* ---- the functions ---- */

TEST(test_one_another)
{
    for (size_t k = points(20000); k > 0; k--) {
        const double v = random_log(&draw, COR_DISK_EPS_MIN_SPEED, COR_DISK_EPS_MAX_SPEED);
        const double nu = random_uniform(&draw, COR_DISK_EPS_MIN_NU, COR_DISK_EPS_MAX_NU);
        const double eps = cor_disk_eps(v, nu), loss = cor_disk_one_minus_eps2(v, nu);
        const double of_eps = cor_disk_eps_uncertainty(v, nu), of_loss = cor_disk_one_minus_eps2_uncertainty(v, nu);
        check(loss > 0 && loss < 0.5 && fabs(eps * eps + loss - 1) <= 4 * DBL_EPSILON, "v = %a, nu = %a", v, nu);
        const double most =
            v <= COR_DISK_EPS_CALM_SPEED ? COR_DISK_EPS_MAX_UNCERTAINTY : COR_DISK_EPS_MAX_UNCERTAINTY_FAST;
        check(of_loss > 0 && of_loss <= most, "v = %a, nu = %a: %g", v, nu, of_loss);
        /* half the width of the interval of eps for 1 - eps^2 +- of_loss */
        const double half = (sqrt(1 - loss + of_loss) - sqrt(1 - loss - of_loss)) / 2;
        check(fabs(of_eps - half) <= 1e-4 * half, "v = %a, nu = %a: %g instead of %g", v, nu, of_eps, half);
    }
}

static double (*const functions[])(double v, double nu) = {
    cor_disk_eps, cor_disk_eps_uncertainty, cor_disk_one_minus_eps2, cor_disk_one_minus_eps2_uncertainty};

TEST(test_domain)
{
    static const double speeds[] = {COR_DISK_EPS_MIN_SPEED, COR_DISK_EPS_MAX_SPEED};
    static const double nus[] = {COR_DISK_EPS_MIN_NU, COR_DISK_EPS_MAX_NU};
    for (size_t k = 0; k < COUNT_OF(functions); k++) {
        for (int i = 0; i < 4; i++) {
            const double v = speeds[i / 2], nu = nus[i % 2];
            assert_true(functions[k](v, nu) > 0 && functions[k](v, nu) < 1);
            assert_true(isnan(functions[k](nextafter(v, i / 2), nu)));
            assert_true(isnan(functions[k](v, nextafter(nu, i % 2 ? 1 : -1))));
        }
        EACH (no_speed, 0, -0.1, 1, INFINITY, -INFINITY, NAN)
            assert_true(isnan(functions[k](*no_speed, 0.3)));
        EACH (no_nu, -1, 1, INFINITY, -INFINITY, NAN)
            assert_true(isnan(functions[k](0.1, *no_nu)));
    }
}

/* ---- other known facts ---- */

/* Collisions of 1800 modes lose less than the limit. The loss extrapolated from alpha and 2 alpha approaches it. */
TEST(test_collisions)
{
    static const double speeds[] = {0.03, 0.1, 0.3};
    for (int i = 0; i < 3; i++) {
        struct cor_disk_collision soft, hard;
        struct cor_disk_collision_options options = {25 / speeds[i], 1e-6, 0, 0};
        assert_int_equal(cor_disk_collision(&cor_disk_modes_nu033, 1800, &options, speeds[i], &soft), 0);
        options.alpha *= 2;
        assert_int_equal(cor_disk_collision(&cor_disk_modes_nu033, 1800, &options, speeds[i], &hard), 0);
        /* extrapolated to first order in 1/alpha; the next order and the omitted modes remain */
        const double limit = cor_disk_one_minus_eps2(speeds[i], 0.33);
        const double found = 2 * hard.one_minus_eps2 - soft.one_minus_eps2;
        check(fabs(found - limit) <= 0.1 * (limit - soft.one_minus_eps2) + 0.04 * limit,
              "v = %g: %.5f from two walls, %.5f in the limit", speeds[i], found, limit);
    }
}
