/* SPDX-License-Identifier: MIT */
/* Extrapolation of disk collisions: made-up collisions whose limit is known, and what is refused. */
#include <math.h>

#include "check.h"
#include "disk/limit_fit.h"

enum { ALPHAS = 4, COUNTS = 5, ROWS = ALPHAS * COUNTS };

static const double speed = 0.07;

/* What a collision with u = 1/(alpha v) and w = 1/sqrt(N) leaves; power: of the second term in u */
struct law {
    double limit, u, edge, power, w, product, square;
};

static double left(const struct law *law, double alpha, size_t modes)
{
    const double u = 1 / (alpha * speed), w = 1 / sqrt((double)modes);
    return law->limit + law->u * u + law->edge * pow(u, law->power) + law->w * w + law->product * u * w +
           law->square * w * w;
}

static void collide(struct disk_limit_row *row, const struct law *law)
{
    static const double hardness[ALPHAS] = {22, 30, 40, 60};
    static const size_t modes[COUNTS] = {1800, 2600, 4000, 5000, 7000};
    for (int i = 0; i < ROWS; i++) {
        row[i].alpha = hardness[i / COUNTS] / speed;
        row[i].modes = modes[i % COUNTS];
        row[i].one_minus_eps2 = left(law, row[i].alpha, row[i].modes);
    }
}

/* Of the size that disks have */
static struct law random_law(struct random_state *random)
{
    return (struct law){random_uniform(random, 0.02, 0.45),
                        random_uniform(random, -1.1, 0.1),
                        random_uniform(random, -0.2, 1),
                        5.0 / 3,
                        random_uniform(random, 0, 0.3),
                        random_uniform(random, -1, 1),
                        0};
}

static void test_exact(void **state)
{
    (void)state;
    struct random_state random = random_start();
    for (size_t k = points(200); k > 0; k--) {
        const struct law law = random_law(&random);
        struct disk_limit_row row[ROWS];
        struct disk_limit limit;
        collide(row, &law);
        assert_int_equal(disk_limit_fit(&limit, speed, row, ROWS), DISK_LIMIT_OK);
        check(fabs(limit.one_minus_eps2 - law.limit) <= 1e-12, "%.15f instead of %.15f", limit.one_minus_eps2,
              law.limit);
        check(limit.residual <= 1e-14, "residual %g", limit.residual);
        /* only fits with another power can differ, and in proportion to what the power stands beside */
        check(limit.uncertainty <= 2e-3 * fabs(law.edge) + 1e-12, "uncertainty %g, edge %g", limit.uncertainty,
              law.edge);
        check(limit.uncertainty >= 1e-5 * fabs(law.edge), "uncertainty %g, edge %g", limit.uncertainty, law.edge);
    }
}

/* Straight lines are exact where the laws are straight, and no fit then differs. */
static void test_straight(void **state)
{
    (void)state;
    static const struct law law = {0.1, -0.5, 0, 1, 0.15, -0.3, 0};
    struct disk_limit_row row[ROWS];
    struct disk_limit limit;
    collide(row, &law);
    assert_int_equal(disk_limit_fit(&limit, speed, row, ROWS), DISK_LIMIT_OK);
    check(fabs(limit.straight - 0.1) <= 1e-13, "%.15f", limit.straight);
    check(fabs(limit.one_minus_eps2 - 0.1) <= 1e-13, "%.15f", limit.one_minus_eps2);
    check(limit.uncertainty <= 1e-12, "%g", limit.uncertainty);
}

/* Laws that no fit has: the truth is within the uncertainty. */
static void test_covered(void **state)
{
    (void)state;
    struct random_state random = random_start();
    for (size_t k = points(300); k > 0; k--) {
        struct law law = random_law(&random);
        struct disk_limit_row row[ROWS];
        struct disk_limit limit;
        law.edge = random_uniform(&random, 0.1, 1);
        law.power = random_uniform(&random, 4.0 / 3, 2);
        collide(row, &law);
        assert_int_equal(disk_limit_fit(&limit, speed, row, ROWS), DISK_LIMIT_OK);
        check(fabs(limit.one_minus_eps2 - law.limit) <= limit.uncertainty + 1e-12, "power %g: %g off, uncertainty %g",
              law.power, limit.one_minus_eps2 - law.limit, limit.uncertainty);
        law.power = 5.0 / 3;
        law.square = random_uniform(&random, -1, 1);
        collide(row, &law);
        assert_int_equal(disk_limit_fit(&limit, speed, row, ROWS), DISK_LIMIT_OK);
        check(fabs(limit.one_minus_eps2 - law.limit) <= limit.uncertainty + 1e-12, "w^2: %g off, uncertainty %g",
              limit.one_minus_eps2 - law.limit, limit.uncertainty);
    }
}

/* Scatter, which numbers of modes have in common for all walls: nearly always within, and never far out. */
static void test_scatter(void **state)
{
    (void)state;
    struct random_state random = random_start();
    size_t out = 0;
    const size_t all = points(1000);
    for (size_t k = 0; k < all; k++) {
        const struct law law = random_law(&random);
        struct disk_limit_row row[ROWS];
        struct disk_limit limit;
        collide(row, &law);
        double scatter[COUNTS];
        for (int i = 0; i < COUNTS; i++)
            scatter[i] = random_uniform(&random, -3e-5, 3e-5);
        for (int i = 0; i < ROWS; i++)
            row[i].one_minus_eps2 += scatter[i % COUNTS] + random_uniform(&random, -1e-6, 1e-6);
        assert_int_equal(disk_limit_fit(&limit, speed, row, ROWS), DISK_LIMIT_OK);
        const double off = fabs(limit.one_minus_eps2 - law.limit);
        out += off > limit.uncertainty;
        check(off <= 4 * limit.uncertainty, "%g off, uncertainty %g", off, limit.uncertainty);
    }
    print_message("%zu of %zu limits are further from the truth than their uncertainty\n", out, all);
    check(20 * out <= all, "%zu of %zu", out, all);
}

static void test_refused(void **state)
{
    (void)state;
    static const struct law law = {0.1, -0.5, 0.7, 5.0 / 3, 0.15, -0.3, 0};
    static const struct disk_limit untouched = {1, 2, 3, 4};
    struct disk_limit limit = untouched;
    struct disk_limit_row row[ROWS];
    collide(row, &law);
    for (int i = 0; i < ROWS; i++) {
        const struct disk_limit_row good = row[i];
        row[i].alpha = DISK_LIMIT_HARDNESS / 0.125; /* alpha v is exact */
        assert_int_equal(disk_limit_fit(&limit, 0.125, row, ROWS), DISK_LIMIT_SOFT_WALL);
        row[i].alpha = nextafter(row[i].alpha, HUGE_VAL);
        assert_int_equal(disk_limit_fit(&limit, 0.125, &row[i], 1), DISK_LIMIT_FEW_ROWS);
        row[i].alpha = NAN;
        assert_int_equal(disk_limit_fit(&limit, speed, row, ROWS), DISK_LIMIT_SOFT_WALL);
        row[i].alpha = INFINITY;
        assert_int_equal(disk_limit_fit(&limit, speed, row, ROWS), DISK_LIMIT_SOFT_WALL);
        row[i] = good;
        row[i].modes = DISK_LIMIT_MODES - 1;
        assert_int_equal(disk_limit_fit(&limit, speed, row, ROWS), DISK_LIMIT_FEW_MODES);
        row[i] = good;
    }
    assert_int_equal(disk_limit_fit(&limit, 0, row, ROWS), DISK_LIMIT_SOFT_WALL);
    assert_int_equal(disk_limit_fit(&limit, NAN, row, ROWS), DISK_LIMIT_SOFT_WALL);
    assert_int_equal(disk_limit_fit(&limit, speed, row, 0), DISK_LIMIT_FEW_ROWS);
    assert_int_equal(disk_limit_fit(&limit, speed, row, (ALPHAS - 1) * COUNTS), DISK_LIMIT_FEW_ROWS);
    /* all four walls, but two numbers of modes */
    struct disk_limit_row two[ROWS];
    size_t n = 0;
    for (int i = 0; i < ROWS; i++)
        if (i % COUNTS < 2)
            two[n++] = row[i];
    assert_int_equal(disk_limit_fit(&limit, speed, two, n), DISK_LIMIT_FEW_ROWS);
    /* a wall of which nothing is known is none */
    for (int i = 0; i < COUNTS; i++)
        row[i].one_minus_eps2 = NAN;
    assert_int_equal(disk_limit_fit(&limit, speed, row, ROWS), DISK_LIMIT_FEW_ROWS);
    assert_memory_equal(&limit, &untouched, sizeof limit);
    /* a single one that is not known does not matter */
    collide(row, &law);
    row[7].one_minus_eps2 = NAN;
    assert_int_equal(disk_limit_fit(&limit, speed, row, ROWS), DISK_LIMIT_OK);
    check(fabs(limit.one_minus_eps2 - law.limit) <= 1e-12, "%.15f", limit.one_minus_eps2);
    row[7].one_minus_eps2 = law.limit + 0.01;
    assert_int_equal(disk_limit_fit(&limit, speed, row, ROWS), DISK_LIMIT_NO_LAW);
    assert_true(limit.residual > DISK_LIMIT_MAX_RESIDUAL);
    for (int status = DISK_LIMIT_OK; status <= DISK_LIMIT_NO_LAW; status++)
        assert_true(strlen(disk_limit_text((enum disk_limit_status)status)) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exact),   cmocka_unit_test(test_straight), cmocka_unit_test(test_covered),
        cmocka_unit_test(test_scatter), cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
