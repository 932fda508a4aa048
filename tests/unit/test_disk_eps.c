/* SPDX-License-Identifier: MIT */
/* The restitution of a disk of all its modes at a hard wall: the table interpolated by another route, its ends, its
 * uncertainty, and what else is known of the limits. */
#include "check.h"

#include "cor/disk.h"
#include "generated/disk_limits.h"

enum { SPEEDS = COR_DISK_LIMIT_SPEEDS, NUS = COR_DISK_LIMIT_NUS };

/* The table gives six places, and its polynomial's coefficients eight. */
static const double rounding = 1e-6;

static const struct cor_disk_limit *limit_at(int j, int i)
{
    return &cor_disk_limits[j * SPEEDS + i];
}

/* ---- the table ---- */

static void test_ends(void **state)
{
    (void)state;
    assert_true(limit_at(0, 0)->speed == COR_DISK_EPS_MIN_SPEED);
    assert_true(limit_at(0, SPEEDS - 1)->speed == COR_DISK_EPS_MAX_SPEED);
    assert_true(limit_at(0, 0)->nu == COR_DISK_EPS_MIN_NU);
    assert_true(limit_at(NUS - 1, 0)->nu == COR_DISK_EPS_MAX_NU);
    for (int j = 0; j < NUS; j++)
        for (int i = 0; i < SPEEDS; i++) {
            assert_true(limit_at(j, i)->nu == limit_at(j, 0)->nu && limit_at(j, i)->speed == limit_at(0, i)->speed);
            assert_true(j == 0 || limit_at(j, i)->nu > limit_at(j - 1, i)->nu);
            assert_true(i == 0 || limit_at(j, i)->speed > limit_at(j, i - 1)->speed);
        }
}

static void test_rows(void **state)
{
    (void)state;
    for (int j = 0; j < NUS; j++)
        for (int i = 0; i < SPEEDS; i++) {
            const struct cor_disk_limit *const row = limit_at(j, i);
            const double found = cor_disk_one_minus_eps2(row->speed, row->nu);
            check(fabs(found - row->one_minus_eps2) <= rounding, "nu = %g, v = %g: %.9f instead of %.6f", row->nu,
                  row->speed, found, row->one_minus_eps2);
            check(cor_disk_one_minus_eps2_uncertainty(row->speed, row->nu) >=
                      row->uncertainty + COR_DISK_LIMIT_INTERPOLATION,
                  "nu = %g, v = %g", row->nu, row->speed);
        }
}

/* Lagrange's polynomial through n nodes at x: the weight of node k */
static long double lagrange(const long double *node, int n, int k, long double x)
{
    long double weight = 1;
    for (int i = 0; i < n; i++)
        if (i != k)
            weight *= (x - node[i]) / (node[k] - node[i]);
    return weight;
}

static void test_between(void **state)
{
    (void)state;
    struct random_state random = random_start();
    long double speed[SPEEDS], nu[NUS];
    for (int i = 0; i < SPEEDS; i++)
        speed[i] = logl(limit_at(0, i)->speed);
    for (int j = 0; j < NUS; j++)
        nu[j] = limit_at(j, 0)->nu;
    for (size_t k = points(2000); k > 0; k--) {
        const double v = random_log(&random, COR_DISK_EPS_MIN_SPEED, COR_DISK_EPS_MAX_SPEED);
        const double n = random_uniform(&random, COR_DISK_EPS_MIN_NU, COR_DISK_EPS_MAX_NU);
        long double sum = 0;
        for (int j = 0; j < NUS; j++)
            for (int i = 0; i < SPEEDS; i++)
                sum += limit_at(j, i)->one_minus_eps2 * lagrange(nu, NUS, j, n) *
                       lagrange(speed, SPEEDS, i, logl((long double)v));
        const double found = cor_disk_one_minus_eps2(v, n);
        check(fabsl(found - sum) <= rounding, "v = %a, nu = %a: %.9f instead of %.9Lf", v, n, found, sum);
        /* the largest of the four corners around, and what the interpolation adds */
        double largest = 0;
        for (int j = 0; j + 1 < NUS; j++)
            for (int i = 0; i + 1 < SPEEDS; i++)
                if (limit_at(j, 0)->nu <= n && n <= limit_at(j + 1, 0)->nu && limit_at(0, i)->speed <= v &&
                    v <= limit_at(0, i + 1)->speed)
                    for (int corner = 0; corner < 4; corner++)
                        largest = fmax(largest, limit_at(j + corner / 2, i + corner % 2)->uncertainty);
        const double uncertainty = cor_disk_one_minus_eps2_uncertainty(v, n);
        check(uncertainty == largest + COR_DISK_LIMIT_INTERPOLATION, "v = %a, nu = %a: %g instead of %g", v, n,
              uncertainty, largest + COR_DISK_LIMIT_INTERPOLATION);
    }
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
        check(of_loss > 0 && of_loss <= COR_DISK_EPS_MAX_UNCERTAINTY, "v = %a, nu = %a: %g", v, nu, of_loss);
        /* half the width of what (1 - eps^2) +- of_loss makes of eps */
        const double half = (sqrt(1 - loss + of_loss) - sqrt(1 - loss - of_loss)) / 2;
        check(fabs(of_eps - half) <= 1e-4 * half, "v = %a, nu = %a: %g instead of %g", v, nu, of_eps, half);
        /* no step where a cell of the table ends */
        const double step = v * (1 + 1e-9) <= COR_DISK_EPS_MAX_SPEED ? cor_disk_eps(v * (1 + 1e-9), nu) - eps : 0;
        check(fabs(step) <= 1e-8, "v = %a, nu = %a: a step of %g", v, nu, step);
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

/* Limits found by another program from other collisions, to three digits of eps and 1e-3 in 1 - eps^2. */
static void test_known(void **state)
{
    (void)state;
    static const struct {
        double nu, speed, eps;
    } known[] = {{0.33, 0.1, 0.947}, {0.33, 0.3, 0.840}, {0.9, 0.1, 0.872}, {0.9, 0.3, 0.747}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const double v = known[i].speed, nu = known[i].nu, eps = cor_disk_eps(v, nu);
        const double allowed = 0.5e-3 + 1e-3 / (2 * known[i].eps) + cor_disk_eps_uncertainty(v, nu);
        check(fabs(eps - known[i].eps) <= allowed, "nu = %g, v = %g: %.5f instead of %.3f, by more than %.5f", nu, v,
              eps, known[i].eps, allowed);
    }
}

/* Fewer modes and a softer wall: the limit lies beyond a collision with 1800 modes and a harder wall takes it there. */
static void test_collisions(void **state)
{
    (void)state;
    const struct cor_disk_modes *const tables[] = {&cor_disk_modes_nu033, &cor_disk_modes_nu090};
    static const double speeds[] = {0.03, 0.1, 0.3};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++) {
            struct cor_disk_collision soft, hard;
            struct cor_disk_collision_options options = {25 / speeds[i], 1e-6, 0, 0};
            assert_int_equal(cor_disk_collision(tables[k], 1800, &options, speeds[i], &soft), 0);
            options.alpha *= 2;
            assert_int_equal(cor_disk_collision(tables[k], 1800, &options, speeds[i], &hard), 0);
            /* one over alpha to the first order; what is left is of the next one, and of the modes left out */
            const double limit = cor_disk_one_minus_eps2(speeds[i], tables[k]->nu);
            const double found = 2 * hard.one_minus_eps2 - soft.one_minus_eps2;
            check(fabs(found - limit) <= 0.1 * (limit - soft.one_minus_eps2) + 0.04 * limit,
                  "nu = %g, v = %g: %.5f from two walls, %.5f in the limit", tables[k]->nu, speeds[i], found, limit);
        }
}

/* As slow as it gets, eps oscillates in ln v as Rayleigh's method has it, at other speeds but as much. */
static void test_rayleigh(void **state)
{
    (void)state;
    double of_dynamics = 0, of_rayleigh = 0, place = 0, dip = 1, dip_place = 0;
    for (double v = COR_DISK_EPS_MIN_SPEED; v < 0.03; v *= 1.01) {
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
    for (double v = 1e-4; v < 1e-2; v *= 1.1) {
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
        cmocka_unit_test(test_ends),        cmocka_unit_test(test_rows),     cmocka_unit_test(test_between),
        cmocka_unit_test(test_one_another), cmocka_unit_test(test_domain),   cmocka_unit_test(test_known),
        cmocka_unit_test(test_collisions),  cmocka_unit_test(test_rayleigh),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
