/* SPDX-License-Identifier: MIT */
/* Tests the exact trajectory: (49), the equation of motion by another route, and the proof of the truncation error. */
#include "ball.h"

#include "series/jet.h"
#include "series/power_bounds.h"
#include "series/restitution.h"
#include "series/row_sums.h"
#include "series/trajectory.h"
#include "support/local.h"

/* Every rational number of (49) and (47). The t^10 term of x_1 has the digits that are missing in the paper. */
TEST(test_equation_49)
{
    static const struct {
        slong k, j;
        const char *value;
    } printed[] = {
        {0, 0, "1"},          {0, 1, "-4/35"},          {0, 2, "1/175"},
        {0, 3, "-22/104125"}, {0, 4, "52/8017625"},     {1, 0, "-4/15"},
        {1, 1, "3/70"},       {1, 2, "-713/238875"},    {1, 3, "61216/426391875"},
        {2, 0, "1/15"},       {2, 1, "-937/75075"},     {2, 2, "871/808500"},
        {3, 0, "-38/2475"},   {3, 1, "43943/13513500"}, {3, 2, "-1184627/3594591000"},
    };
    fmpq_poly_struct *row = trajectory_exact(3, 4, &law_sphere);
    LOCAL(fmpq, want, got);
    for (size_t i = 0; i < sizeof printed / sizeof *printed; i++) {
        assert_int_equal(fmpq_set_str(want, printed[i].value, 10), 0);
        fmpq_poly_get_coeff_fmpq(got, row + printed[i].k, printed[i].j);
        check(fmpq_equal(want, got), "c[%ld][%ld] is not %s", (long)printed[i].k, (long)printed[i].j, printed[i].value);
    }
    trajectory_exact_free(row, 3 + 1);
}

/* Counts the coefficients of the equation of motion up to tau^(n-1), tau = t^(1/d), that do not vanish at one beta. For
 * x = t X, t times the equation is D (D + 1) X + beta t^(b+1) X^b (D + 1) X + t^(a+1) X^a, D = t d/dt. The powers are
 * series in tau, by exp and ln. */
static slong residual(const fmpq_poly_struct *row, slong order, slong terms, const struct cor_exponents *law)
{
    const slong d = law->denominator, du = law->damping + d, ds = law->elastic + d,
                n = FLINT_MIN((order + 1) * du, (terms + 1) * ds);
    const struct ratio beta = {5, 7}, a = law_elastic(law), b = law_damping(law);
    LOCAL(fmpq, c, other);
    LOCAL(fmpq_poly, x, velocity, sum, log, power);
    slong wrong = 0;
    for (slong k = 0; k <= order; k++)
        for (slong j = 0; j <= terms && k * du + j * ds < n; j++) {
            fmpq_poly_get_coeff_fmpq(c, row + k, j);
            fmpq_poly_get_coeff_fmpq(other, x, k * du + j * ds);
            EXACT(c, "other + c*beta^k", other, c, beta, k);
            fmpq_poly_set_coeff_fmpq(x, k * du + j * ds, c);
        }
    for (slong i = 0; i < n; i++) {
        fmpq_poly_get_coeff_fmpq(c, x, i);
        EXACT(c, "c*(i/d + 1)", c, i, d);
        fmpq_poly_set_coeff_fmpq(velocity, i, c);
        EXACT(c, "c*i/d", c, i, d);
        fmpq_poly_set_coeff_fmpq(sum, i, c);
    }
    fmpq_poly_log_series(log, x, n);
    for (int elastic = 0; elastic < 2; elastic++) {
        EXACT(c, elastic ? "a" : "b", a, b);
        fmpq_poly_scalar_mul_fmpq(power, log, c);
        fmpq_poly_exp_series(power, power, n);
        EXACT(c, elastic ? "1" : "beta", beta);
        fmpq_poly_scalar_mul_fmpq(power, power, c);
        if (!elastic)
            fmpq_poly_mullow(power, power, velocity, n);
        fmpq_poly_shift_left(power, power, elastic ? ds : du);
        fmpq_poly_add(sum, sum, power);
    }
    for (slong i = 0; i < n; i++) {
        fmpq_poly_get_coeff_fmpq(c, sum, i);
        wrong += !fmpq_is_zero(c);
    }
    return wrong;
}

static const char *const laws[][2] = {{"3/2", "1/2"}, {"1", "0"}, {"3/2", "1/4"}, {"3/2", "3/2"},
                                      {"2", "1/3"},   {"0", "1"}, {"1/2", "2"}};
enum { LAWS = sizeof laws / sizeof *laws };

TEST(test_equation_of_motion)
{
    enum { ORDER = 7 };
    for (int i = 0; i < LAWS; i++) {
        const struct cor_exponents law = law_of(laws[i][0], laws[i][1]);
        const slong terms = (ORDER + 1) * (law.damping + law.denominator) / (law.elastic + law.denominator);
        fmpq_poly_struct *row = trajectory_exact(ORDER, terms, &law);
        check(residual(row, ORDER, terms, &law) == 0, "law %s, %s", laws[i][0], laws[i][1]);
        /* an error of 10^-30 in one coefficient is detected */
        LOCAL(fmpq, c);
        fmpq_poly_get_coeff_fmpq(c, row + ORDER, 0);
        EXACT(c, "c + 1/10^30", c);
        fmpq_poly_set_coeff_fmpq(row + ORDER, 0, c);
        assert_true(residual(row, ORDER, terms, &law) > 0);
        trajectory_exact_free(row, ORDER + 1);
    }
}

TEST(test_balls_contain_rationals)
{
    enum { ORDER = 12, TERMS = 15, PREC = 200 };
    for (int i = 0; i < LAWS; i++) {
        const struct cor_exponents law = law_of(laws[i][0], laws[i][1]);
        struct trajectory t;
        LOCAL(fmpq, c);
        LOCAL(arb, x);
        fmpq_poly_struct *row = trajectory_exact(ORDER, TERMS, &law);
        trajectory_init(&t, ORDER, TERMS, &law, PREC);
        for (slong k = 0; k <= ORDER; k++)
            for (slong j = 0; j <= TERMS; j++) {
                fmpq_poly_get_coeff_fmpq(c, row + k, j);
                EXACT(c, "c*2^(t.shift*j)", c, t.shift, j);
                arb_poly_get_coeff_arb(x, t.x + k, j);
                assert_true(arb_contains_fmpq(x, c));
            }
        trajectory_clear(&t);
        trajectory_exact_free(row, ORDER + 1);
    }
}

/* Checks (3.3) of docs/theory.md, with powers in place of expm1: G maps the ball |R| <= delta into itself. delta is at
 * least 2 G(0), the first trial. */
static void assert_fixed(const struct trajectory_tail *tail, const struct trajectory *t)
{
    enum { BITS = 1000 };
    const slong shift = t->shift, terms = t->terms;
    const struct ratio a = law_elastic(&t->law), b1 = RATIO("t->law.b + 1", &t->law);
    struct power_evidence e;
    LOCAL(power_bounds, b);
    LOCAL(arb, e1, by_b, by_a, image);
    power_evidence_init(&e, t, 16, 48); /* the arguments used in trajectory_tail.c */
    assert_true(power_bounds_prove(b, &e, tail->U, tail->rho));
    const arb_srcptr size = b->size[e.powers - 1], error = b->error[e.powers - 1];
    LET(e1, BITS, "(terms + 1)*(a + 1) + 1", terms, a);
    for (int of_delta = 0; of_delta < 2; of_delta++) {
        LET(image, BITS, "1 - b->inverse*tail->delta*of_delta", b->inverse, tail->delta, of_delta);
        LET(by_b, BITS, "tail->U/b1*((image^(-b1) - 1)*size + error)", tail->U, b1, image, size, error);
        LET(by_a, BITS, "2^shift*tail->rho/(e1 - 1)*((image^(-a) - 1)*b->size[0] + b->last_column)", shift, tail->rho,
            e1, image, a, b->size[0], b->last_column);
        LET(image, BITS, "(by_b + by_a)/e1*(2 - of_delta)", by_b, by_a, e1, of_delta);
        assert_true(HOLDS(BITS, "image < tail->delta*(1 + 2^-20)", image, tail->delta));
    }
    power_evidence_clear(&e);
}

/* The truncation bound holds for the next terms, and is not much too wide. */
TEST(test_truncation_bound)
{
    enum { ORDER = 10, TERMS = 60, MORE = 140, PREC = 500 };
    for (int i = 0; i < 4; i++) {
        const struct cor_exponents law = law_of(laws[i][0], laws[i][1]);
        struct trajectory cut, long_one;
        LOCAL(trajectory_tail, tail);
        LOCAL(arb, y0, t0, sum, term);
        LOCAL(mag, bound);
        turning_point_elastic(y0, t0, &law, PREC);
        trajectory_init(&cut, ORDER, TERMS, &law, PREC);
        trajectory_init(&long_one, ORDER, MORE, &law, PREC);
        assert_true(trajectory_tail_prove(tail, &cut, t0));
        assert_fixed(tail, &cut);
        for (slong k = 0; k <= ORDER; k++)
            for (slong m = 0; m <= 5; m += 5) {
                trajectory_tail_jet(bound, tail, &cut, k, m, t0);
                arb_zero(sum);
                for (slong j = TERMS + 1; j <= MORE; j++) {
                    const slong e =
                        k * (law.damping + law.denominator) + j * (law.elastic + law.denominator) + law.denominator;
                    const struct ratio power = RATIO("e/law.denominator", e, law.denominator);
                    arb_poly_get_coeff_arb(term, long_one.x + k, j);
                    LET(term, PREC, "abs(term)/2^(long_one.shift*j)*t0^(power - m)", term, long_one.shift, j, t0, power,
                        m);
                    for (slong i1 = 0; i1 < m; i1++)
                        LET(term, PREC, "term*(power - i1)/(i1 + 1)", term, power, i1);
                    arb_add(sum, sum, term, PREC);
                }
                arf_set_mag(arb_midref(term), bound);
                mag_zero(arb_radref(term));
                assert_true(arb_lt(sum, term));
                /* the bound is at most 2^50 times the truth, except for the linear law, whose X is entire */
                arb_mul_2exp_si(sum, sum, 50);
                assert_true(i == 1 || arb_gt(sum, term));
            }
        trajectory_clear(&cut);
        trajectory_clear(&long_one);
    }
}

TEST(test_law_parse)
{
    struct cor_exponents law;
    assert_null(law_parse(&law, "1.5", "0.5"));
    assert_true(law_is_sphere(&law));
    assert_null(law_parse(&law, "6/4", "1/2"));
    assert_true(law_is_sphere(&law));
    assert_null(law_parse(&law, "1", "0"));
    assert_false(law_is_sphere(&law));
    assert_null(law_parse(&law, "24", "1/16"));
    static const char *const wrong[] = {
        "", "-1", "x", "1/0", "1/17", "65", "3/2 ", "1e3", "nan", "1.00001", "/2", "25", "99999999999999999999"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_non_null(law_parse(&law, wrong[i], "1/2"));
        assert_non_null(law_parse(&law, "3/2", wrong[i]));
    }
    const struct ratio q = law_speed_exponent(&law_sphere);
    assert_true(q.num == 1 && q.den == 5);
}

/* Makes intervals of very different size, and one number in each interval. */
static void random_row(arb_poly_struct *row, arb_poly_struct *point, slong k, slong length, struct random_state *random)
{
    LOCAL(arb, x, y);
    for (slong j = 0; j < length; j++) {
        const double head = random_uniform(random, -1, 1), rest = ldexp(random_uniform(random, -1, 1), -50);
        LET(x, 200, "head + rest", head, rest);
        arb_mul_2exp_si(x, x, -2 * k - j / 2 - (slong)random_below(random, 40));
        if (random_below(random, 8) == 0)
            arb_zero(x);
        arb_set_d(y, random_uniform(random, 0, 1));
        arb_mul_2exp_si(y, y, (slong)random_below(random, 3) * j / 2 - 60);
        arb_add_error(x, y);
        arb_poly_set_coeff_arb(row, j, x);
        /* one end of the interval, or its centre */
        arb_get_rad_arb(y, x);
        arb_mul_si(y, y, (slong)random_below(random, 3) - 1, 200);
        arb_get_mid_arb(x, x);
        arb_add(x, x, y, 400);
        arb_poly_set_coeff_arb(point, j, x);
    }
}

/* The enclosed sums contain the sum for one number of each interval, computed product by product. They are hardly wider
 * than sums of intervals. */
TEST(test_row_sums)
{
    enum { CUT = 100, EXACT = 4000 };
    static const struct {
        struct ratio p;
        slong rows, length;
    } sizes[] = {{{3, 2}, 14, 1}, {{3, 2}, 13, 70}, {{1, 1}, 6, 129}, {{31, 16}, 9, 65}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const struct ratio p = sizes[i].p;
        const slong rows = sizes[i].rows, length = sizes[i].length;
        arb_poly_struct *f[2] = {jet_new(rows), jet_new(rows)}, *point[2] = {jet_new(rows), jet_new(rows)};
        struct row_sums sums;
        LOCAL(arb_poly, sum, product, wide_sum, point_sum);
        arb_poly_struct *const expected[2] = {wide_sum, point_sum};
        LOCAL(arb, x, y);
        LOCAL(mag, wide, cut);
        row_sums_init(&sums, p, rows, length, CUT);
        for (int n = 0; n < 2; n++)
            for (slong k = 1; k < rows; k++)
                random_row(f[n] + k, point[n] + k, k, length, &draw);
        for (slong k = 1; k < rows; k++) {
            row_sums_next(sum, &sums, f[0], f[1], k);
            for (int kind = 0; kind < 2; kind++) {
                arb_poly_struct *const *factor = kind == 0 ? f : point;
                arb_poly_zero(expected[kind]);
                for (slong n = 1; n < k; n++) {
                    arb_set_si(x, (p.num + p.den) * n - p.den * k);
                    arb_poly_mullow(product, factor[0] + n, factor[1] + k - n, length, EXACT);
                    arb_poly_scalar_mul(product, product, x, EXACT);
                    arb_poly_add(expected[kind], expected[kind], product, EXACT);
                }
            }
            for (slong j = 0; j < length; j++) {
                arb_poly_get_coeff_arb(x, sum, j);
                arb_poly_get_coeff_arb(y, expected[1], j);
                check(arb_contains(x, y), "size %zu, row %ld, coefficient %ld", i, (long)k, (long)j);
                arb_poly_get_coeff_arb(y, expected[0], j);
                mag_mul_ui(wide, arb_radref(y), 2);
                mag_set_ui_2exp_si(cut, 1, 20 - CUT - 2 * k);
                mag_add(wide, wide, cut);
                check(mag_cmp(arb_radref(x), wide) <= 0, "size %zu, row %ld, coefficient %ld", i, (long)k, (long)j);
            }
        }
        row_sums_clear(&sums);
        for (int n = 0; n < 2; n++) {
            jet_free(f[n], rows);
            jet_free(point[n], rows);
        }
    }
}
