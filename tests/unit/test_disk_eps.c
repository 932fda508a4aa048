/* SPDX-License-Identifier: MIT */
/* The restitution of a disk of all its modes at a rigid wall: the table interpolated by another route, its ends, its
 * uncertainty against collisions, and what else is known of the limits. */
#include "check.h"

#include "cor/disk.h"
#include "cor/status.h"
#include "generated/disk_limits.h"

#define WANTED 2e-5 /* of the uncertainty up to COR_DISK_EPS_CALM_SPEED, and beyond */
#define WANTED_FAST 1e-4

/* ---- the table ---- */

/* Each node but the roots is one of the four quarters of one cell, and each cell belongs to one node. */
static void test_tree(void **state)
{
    (void)state;
    enum { NODES = sizeof cor_disk_limit_node / sizeof *cor_disk_limit_node };
    enum { CELLS = sizeof cor_disk_limit_cell / sizeof *cor_disk_limit_cell };
    static int quarters_of[NODES], nodes_of[CELLS];
    for (int i = 0; i < NODES; i++) {
        const int number = cor_disk_limit_node[i];
        if (number >= 0) {
            assert_true(number < CELLS);
            nodes_of[number]++;
            continue;
        }
        assert_true(-number > i && -number + 3 < NODES);
        for (int k = 0; k < 4; k++)
            quarters_of[-number + k]++;
    }
    for (int i = 0; i < NODES; i++)
        assert_int_equal(quarters_of[i], i >= COR_DISK_LIMIT_X_ROOTS * COR_DISK_LIMIT_NU_ROOTS);
    for (int i = 0; i < CELLS; i++)
        assert_int_equal(nodes_of[i], 1);
    assert_true(fabs(pow(COR_DISK_LIMIT_X_FIRST, 8) / COR_DISK_EPS_MIN_SPEED - 1) < 1e-14);
    assert_true(fabs(pow(COR_DISK_LIMIT_X_FIRST + (double)COR_DISK_LIMIT_X_ROOTS * COR_DISK_LIMIT_X_STEP, 8) /
                         COR_DISK_EPS_MAX_SPEED -
                     1) < 1e-14);
    assert_true(COR_DISK_LIMIT_NU_FIRST == COR_DISK_EPS_MIN_NU);
    assert_true(fabs(COR_DISK_LIMIT_NU_FIRST + (double)COR_DISK_LIMIT_NU_ROOTS * COR_DISK_LIMIT_NU_STEP -
                     COR_DISK_EPS_MAX_NU) < 1e-15);
}

/* A cell with its corner and sides, in the units of the roots */
struct place {
    const struct cor_disk_limit_cell *cell;
    long double x, nu, side;
};

/* By intervals that are halved, where the library follows a fraction */
static struct place place_of(long double x, long double nu)
{
    struct place at = {NULL, fminl(floorl(x), COR_DISK_LIMIT_X_ROOTS - 1),
                       fminl(floorl(nu), COR_DISK_LIMIT_NU_ROOTS - 1), 1};
    int number = cor_disk_limit_node[(int)at.nu * COR_DISK_LIMIT_X_ROOTS + (int)at.x];
    while (number < 0) {
        at.side /= 2;
        const int right = x >= at.x + at.side, upper = nu >= at.nu + at.side;
        at.x += right ? at.side : 0;
        at.nu += upper ? at.side : 0;
        number = cor_disk_limit_node[-number + 2 * upper + right];
    }
    at.cell = &cor_disk_limit_cell[number];
    return at;
}

/* Neville's scheme through four values at 0, 1/3, 2/3, 1 */
static long double neville(const long double value[4], long double t)
{
    long double p[4] = {value[0], value[1], value[2], value[3]};
    for (int order = 1; order < 4; order++)
        for (int i = 0; i + order < 4; i++)
            p[i] =
                ((3 * t - (long double)(i + order)) * p[i] - (3 * t - (long double)i) * p[i + 1]) / -(long double)order;
    return p[0];
}

/* The polynomials again, by another route */
static void test_between(void **state)
{
    (void)state;
    struct random_state random = random_start();
    for (size_t k = points(20000); k > 0; k--) {
        const double v = random_log(&random, COR_DISK_EPS_MIN_SPEED, COR_DISK_EPS_MAX_SPEED);
        const double nu = random_uniform(&random, COR_DISK_EPS_MIN_NU, COR_DISK_EPS_MAX_NU);
        const long double x = (powl(v, 0.125L) - COR_DISK_LIMIT_X_FIRST) / COR_DISK_LIMIT_X_STEP,
                          y = ((long double)nu - COR_DISK_LIMIT_NU_FIRST) / COR_DISK_LIMIT_NU_STEP;
        const struct place at = place_of(x, y);
        long double along[4];
        for (int j = 0; j < 4; j++) {
            long double row[4];
            for (int i = 0; i < 4; i++)
                row[i] = at.cell->value[4 * j + i];
            along[j] = neville(row, (x - at.x) / at.side);
        }
        const long double value = 1e-7L * neville(along, (y - at.nu) / at.side);
        const double found = cor_disk_one_minus_eps2(v, nu), off = cor_disk_one_minus_eps2_uncertainty(v, nu);
        check(fabsl(found - value) <= 1e-13L, "v = %a, nu = %a: %.15f instead of %.15Lf", v, nu, found, value);
        check(off == COR_DISK_LIMIT_UNIT * at.cell->uncertainty, "v = %a, nu = %a: uncertainty %g", v, nu, off);
    }
}

/* At places off the grid, collisions: none farther off than the uncertainty. COR_TEST_MULTIPLIER=250: 1000 places. */
static void test_uncertainty(void **state)
{
    (void)state;
    struct random_state random = random_start();
    const double first = pow(COR_DISK_EPS_MIN_SPEED, 0.125), last = pow(COR_DISK_EPS_MAX_SPEED, 0.125);
    const struct cor_disk_hard_wall_options options = {5e-6};
    const size_t places = points(4);
    size_t wanted = 0;
    double worst = 0, largest = 0;
    for (size_t k = 0; k < places; k++) {
        const double v = pow(random_uniform(&random, first, last), 8);
        const double nu = random_uniform(&random, COR_DISK_EPS_MIN_NU, COR_DISK_EPS_MAX_NU);
        struct cor_disk_hard_wall wall;
        const int status = cor_disk_hard_wall_nu(nu, &options, v, &wall);
        assert_true(status == COR_OK || status == COR_TOLERANCE_NOT_REACHED);
        const double off = fabs(cor_disk_one_minus_eps2(v, nu) - wall.one_minus_eps2),
                     uncertainty = cor_disk_one_minus_eps2_uncertainty(v, nu);
        check(off <= uncertainty, "v = %.17g, nu = %.17g: %.7f, off by %.1e, uncertain by %.1e", v, nu,
              cor_disk_one_minus_eps2(v, nu), off, uncertainty);
        worst = fmax(worst, off / uncertainty);
        largest = fmax(largest, off);
        wanted += uncertainty <= (v <= COR_DISK_EPS_CALM_SPEED ? WANTED : WANTED_FAST);
    }
    print_message(
        "%zu places: off by %.1e at most, by %.2f of the uncertainty at most; %zu of them certain to %g, or %g "
        "beyond v = %g\n",
        places, largest, worst, wanted, WANTED, WANTED_FAST, COR_DISK_EPS_CALM_SPEED);
}

/* ---- the functions ---- */

static void test_one_another(void **state)
{
    (void)state;
    struct random_state random = random_start();
    for (size_t k = points(20000); k > 0; k--) {
        const double v = random_log(&random, COR_DISK_EPS_MIN_SPEED, COR_DISK_EPS_MAX_SPEED);
        const double nu = random_uniform(&random, COR_DISK_EPS_MIN_NU, COR_DISK_EPS_MAX_NU);
        const double eps = cor_disk_eps(v, nu), loss = cor_disk_one_minus_eps2(v, nu);
        const double of_eps = cor_disk_eps_uncertainty(v, nu), of_loss = cor_disk_one_minus_eps2_uncertainty(v, nu);
        check(loss > 0 && loss < 0.5 && fabs(eps * eps + loss - 1) <= 4 * DBL_EPSILON, "v = %a, nu = %a", v, nu);
        const double most =
            v <= COR_DISK_EPS_CALM_SPEED ? COR_DISK_EPS_MAX_UNCERTAINTY : COR_DISK_EPS_MAX_UNCERTAINTY_FAST;
        check(of_loss > 0 && of_loss <= most, "v = %a, nu = %a: %g", v, nu, of_loss);
        /* half the width of what (1 - eps^2) +- of_loss makes of eps */
        const double half = (sqrt(1 - loss + of_loss) - sqrt(1 - loss - of_loss)) / 2;
        check(fabs(of_eps - half) <= 1e-4 * half, "v = %a, nu = %a: %g instead of %g", v, nu, of_eps, half);
        /* where a cell ends, a step of no more than the uncertainties */
        const double next = fmin(v * 1.0001, COR_DISK_EPS_MAX_SPEED);
        const double step = cor_disk_one_minus_eps2(next, nu) - loss;
        check(fabs(step) <= 1e-4 + of_loss + cor_disk_one_minus_eps2_uncertainty(next, nu),
              "v = %a, nu = %a: a step of %g", v, nu, step);
    }
}

static void expect_nan(double speed, double nu)
{
    assert_true(isnan(cor_disk_eps(speed, nu)));
    assert_true(isnan(cor_disk_eps_uncertainty(speed, nu)));
    assert_true(isnan(cor_disk_one_minus_eps2(speed, nu)));
    assert_true(isnan(cor_disk_one_minus_eps2_uncertainty(speed, nu)));
}

static void test_domain(void **state)
{
    (void)state;
    static const double speeds[] = {COR_DISK_EPS_MIN_SPEED, COR_DISK_EPS_MAX_SPEED};
    static const double nus[] = {COR_DISK_EPS_MIN_NU, COR_DISK_EPS_MAX_NU};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            const double v = speeds[i], nu = nus[j];
            assert_true(cor_disk_eps(v, nu) > 0.7 && cor_disk_eps(v, nu) < 1);
            assert_true(cor_disk_eps_uncertainty(v, nu) > 0);
            assert_true(cor_disk_one_minus_eps2(v, nu) > 0);
            assert_true(cor_disk_one_minus_eps2_uncertainty(v, nu) > 0);
            expect_nan(nextafter(v, i == 0 ? 0 : 1), nu);
            expect_nan(v, nextafter(nu, j == 0 ? -1 : 1));
        }
    static const double no_speed[] = {0, -0.1, 1, INFINITY, -INFINITY, NAN};
    static const double no_nu[] = {-1, 1, INFINITY, -INFINITY, NAN};
    for (size_t i = 0; i < sizeof no_speed / sizeof *no_speed; i++)
        expect_nan(no_speed[i], 0.3);
    for (size_t i = 0; i < sizeof no_nu / sizeof *no_nu; i++)
        expect_nan(0.1, no_nu[i]);
}

/* ---- what else is known ---- */

/* From the prototype of the method, another program by another hand, with the errors judged there */
static void test_known(void **state)
{
    (void)state;
    static const struct {
        double speed, one_minus_eps2, error;
    } known[] = {{0.03, 0.0332486, 5e-7}, {0.1, 0.1030896, 5e-7}, {0.3, 0.293641, 3e-6}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const double v = known[i].speed, found = cor_disk_one_minus_eps2(v, 0.33),
                     uncertainty = cor_disk_one_minus_eps2_uncertainty(v, 0.33);
        check(fabs(found - known[i].one_minus_eps2) <= known[i].error + uncertainty, "v = %g: %.7f +- %.1e, not %.7f",
              v, found, uncertainty, known[i].one_minus_eps2);
    }
}

/* Fewer modes and a softer wall: the limit lies beyond a collision with 1800 modes and a harder wall takes it there. */
static void test_collisions(void **state)
{
    (void)state;
    static const double speeds[] = {0.03, 0.1, 0.3};
    for (int i = 0; i < 3; i++) {
        struct cor_disk_collision soft, hard;
        struct cor_disk_collision_options options = {25 / speeds[i], 1e-6, 0, 0};
        assert_int_equal(cor_disk_collision(&cor_disk_modes_nu033, 1800, &options, speeds[i], &soft), 0);
        options.alpha *= 2;
        assert_int_equal(cor_disk_collision(&cor_disk_modes_nu033, 1800, &options, speeds[i], &hard), 0);
        /* one over alpha to the first order; what is left is of the next one, and of the modes left out */
        const double limit = cor_disk_one_minus_eps2(speeds[i], 0.33);
        const double found = 2 * hard.one_minus_eps2 - soft.one_minus_eps2;
        check(fabs(found - limit) <= 0.1 * (limit - soft.one_minus_eps2) + 0.04 * limit,
              "v = %g: %.5f from two walls, %.5f in the limit", speeds[i], found, limit);
    }
}

/* As slow as it gets, eps oscillates in ln v as Rayleigh's method has it, at other speeds but as much. */
static void test_rayleigh(void **state)
{
    (void)state;
    double of_dynamics = 0, of_rayleigh = 0, place = 0, dip = 1, dip_place = 0;
    for (double v = 1e-3; v < 0.03; v *= 1.01) {
        const double loss = cor_disk_one_minus_eps2(v, 0.33);
        if (v < 0.01 && loss > of_dynamics) {
            of_dynamics = loss;
            place = v;
        }
        if (loss < dip) {
            dip = loss;
            dip_place = v;
        }
    }
    for (double v = 2e-4; v < 1e-2; v *= 1.1) {
        struct cor_disk_rayleigh slow;
        assert_int_equal(cor_disk_rayleigh(&cor_disk_modes_nu033, 1800, COR_DISK_DATUM_CENTRE_OF_MASS, v, &slow, NULL),
                         0);
        of_rayleigh = fmax(of_rayleigh, slow.fraction + slow.tail);
    }
    print_message("largest 1 - eps^2 %.5f at v = %.4f, least %.5f at %.4f; Rayleigh's largest %.5f\n", of_dynamics,
                  place, dip, dip_place, of_rayleigh);
    check(fabs(of_dynamics - of_rayleigh) <= 0.1 * of_rayleigh, "%.5f and %.5f", of_dynamics, of_rayleigh);
    check(place < 0.004 && dip_place > 0.013 && dip_place < 0.02, "largest at %.4f, least at %.4f", place, dip_place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tree),        cmocka_unit_test(test_between),  cmocka_unit_test(test_uncertainty),
        cmocka_unit_test(test_one_another), cmocka_unit_test(test_domain),   cmocka_unit_test(test_known),
        cmocka_unit_test(test_collisions),  cmocka_unit_test(test_rayleigh),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
