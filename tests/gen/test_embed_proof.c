/* SPDX-License-Identifier: MIT */
/* The proofs of embedded headers (gen/embed/proof.c, rounding.c) for forms whose error is known. A form gets an error
 * of known size at a chosen speed, and the proof must find it wherever that speed is. Bounds of rounding errors are
 * compared with counts by hand. */
#include <math.h>

#include "ball.h"
#include "embed/form.h"
#include "enclosure/collision.h"
#include "support/local.h"

#include <cor/sphere.h>

#define UNIT 0x1p-53
/* Size of the errors that forms get; the errors of the fits below are smaller. */
#define BUMP 1e-6

/* A scene with beta = speed^(1/5); to be cleared. */
static struct embed_scene scene_of(enum contact_end end, double beta_min, double beta_max, struct interpolant *f)
{
    struct embed_scene s = {.end = end,
                            .speed_min = pow(beta_min, 5),
                            .speed_max = pow(beta_max, 5),
                            .tolerance = 1e-5,
                            .law = law_sphere,
                            .beta_min = beta_min,
                            .beta_max = beta_max,
                            .interpolant = f};
    FOR_ALL(arb, init, s.beta_per_root, s.beta_enclosed, s.h_star_5);
    arb_one(s.beta_per_root);
    arb_one(s.beta_enclosed);
    arb_set_d(s.h_star_5, 5.158); /* roughly: only test_far_parts uses it */
    return s;
}

static void clear_scene(struct embed_scene *s)
{
    FOR_ALL(arb, clear, s->beta_per_root, s->beta_enclosed, s->h_star_5);
}

/* A form on the whole range, with the finest root */
static struct embed_form form_of(const struct embed_scene *s, enum embed_family family, enum embed_variable variable,
                                 slong numerator, double *number)
{
    return (struct embed_form){.family = family,
                               .variable = variable,
                               .speed_min = s->speed_min,
                               .speed_max = s->speed_max,
                               .numerator = numerator,
                               .refinement = 3,
                               .number = number};
}

static struct embed_proof proof_of(const struct embed_form *f, const struct embed_scene *s)
{
    struct embed_proof proof;
    assert_int_equal(embed_prove(&proof, f, s), 0);
    return proof;
}

/* The whole range is proved; the formula's bound is `error` or a little more; rounding is added. */
static void assert_proved(const struct embed_form *f, const struct embed_scene *s, double error, const char *what)
{
    const struct embed_proof proof = proof_of(f, s);
    check(proof.formula >= error * (1 - 1e-4) && proof.formula <= 1.1 * error && proof.proved,
          "%s: an error of %g, %g proved", what, error, proof.formula);
    assert_true(proof.rounding > 0 && proof.error >= proof.formula + proof.rounding);
}

/* ---- errors at a chosen place ---- */

/* Multiplies p_0, ..., p_degree by c_0 + c_1 x + c_2 x^2. */
static void multiply(double *p, slong degree, double c0, double c1, double c2)
{
    for (slong k = degree + 2; k >= 0; k--)
        p[k] = (k <= degree ? c0 * p[k] : 0) + (k >= 1 && k - 1 <= degree ? c1 * p[k - 1] : 0) +
               (k >= 2 ? c2 * p[k - 2] : 0);
}

/* Gives a rational form the factor 1 + BUMP 2 x y/(x^2 + y^2), with its maximum BUMP at x = y. */
static void bump(double *number, slong *numerator, slong *denominator, double y)
{
    double q[32];
    memcpy(q, number + *numerator + 1, (size_t)(*denominator + 1) * sizeof *q);
    multiply(number, *numerator, y * y, 2 * BUMP * y, 1);
    multiply(q, *denominator, y * y, 0, 1);
    *numerator += 2;
    *denominator += 2;
    memcpy(number + *numerator + 1, q, (size_t)(*denominator + 1) * sizeof *q);
}

/* eps = 32 h*^5/speed from beta = 8 to 20, beta = speed^(1/5)/2, where the power law replaces an interpolant: an error
 * at the ends and between them. The error of the power law itself, EMBED_FAR_ERROR, is part of the bound. */
TEST(test_far_parts)
{
    struct embed_scene s = scene_of(END_ZERO_OVERLAP, 16, 40, NULL);
    assert_int_equal(collision_h_star(s.h_star_5, 128), 0);
    arb_pow_ui(s.h_star_5, s.h_star_5, 5, EMBED_BITS);
    const double h5 = middle(s.h_star_5);
    arb_set_d(s.beta_per_root, 0.5);
    arb_set_d(s.beta_enclosed, 0.5);
    s.beta_min /= 2;
    s.beta_max /= 2;
    for (int i = 0; i < 3; i++) {
        double number[16] = {32 * h5, 0, 1};
        struct embed_form f = form_of(&s, FAMILY_RATIONAL_SPEED, SPEED, 0, number);
        f.denominator = 1;
        if (i == 0) {
            LOCAL(arb, rest);
            LET(rest, EMBED_BITS, "abs(h5 - s.h_star_5)/h5", h5, s.h_star_5);
            const double least = middle(rest) + EMBED_FAR_ERROR;
            f.error = least; /* no halving of a part takes EMBED_FAR_ERROR away, which no sample shows */
            const struct embed_proof proof = proof_of(&f, &s);
            f.error = 0;
            check(proof.formula >= least * (1 - 1e-9) && proof.formula <= 1.1 * least, "h*^5/g is off by %g, %g proved",
                  least, proof.formula);
        }
        bump(number, &f.numerator, &f.denominator,
             i == 0   ? s.speed_min
             : i == 1 ? s.speed_max
                      : random_uniform(&draw, s.speed_min, s.speed_max));
        assert_proved(&f, &s, BUMP, "beyond beta = 7");
    }
    clear_scene(&s);
}

/* ---- within the interpolant's intervals ---- */

/* Up to beta = 1: two intervals, made for the first test that needs them */
static struct interpolant *interpolant(void)
{
    static struct interpolant *made;
    if (!made)
        made = interpolant_new(&interpolant_sphere_proof, 0, 1);
    assert_non_null(made);
    return made;
}

static double eps_at(const struct embed_scene *s, double beta)
{
    return s->end == END_ZERO_OVERLAP ? cor_sphere_eps_zero_overlap(beta) : cor_sphere_eps_zero_force(beta);
}

/* The polynomial in x - start of degree `degree` through eps at Chebyshev points between lo and hi, x = beta or
 * beta^5 */
static void fit(double *c, slong degree, const struct embed_scene *s, double lo, double hi, bool of_speed, double start,
                double unit)
{
    enum { MOST = 16 };
    double x[MOST], y[MOST];
    for (slong i = 0; i <= degree; i++) {
        const double at =
            (lo + hi) / 2 + (hi - lo) / 2 * cos(acos(-1) * (2 * (double)i + 1) / (2 * (double)degree + 2));
        x[i] = (at - start) * unit;
        y[i] = eps_at(s, of_speed ? pow(at, 0.2) : at);
    }
    for (slong k = 1; k <= degree; k++) /* divided differences */
        for (slong i = degree; i >= k; i--)
            y[i] = (y[i] - y[i - 1]) / (x[i] - x[i - k]);
    memset(c, 0, (size_t)(degree + 1) * sizeof *c);
    for (slong i = degree; i >= 0; i--) {
        for (slong k = degree; k >= 1; k--)
            c[k] = c[k - 1] - x[i] * c[k];
        c[0] = y[i] - x[i] * c[0];
    }
}

/* A polynomial in beta from 0.15 to 0.95 in two intervals, with an error at the ends and between them */
TEST(test_intervals)
{
    struct embed_scene s = scene_of(END_ZERO_OVERLAP, 0.15, 0.95, interpolant());
    for (int i = 0; i < 3; i++) {
        double number[40] = {0};
        struct embed_form f = form_of(&s, FAMILY_RATIONAL_BETA, FIFTH_ROOT_OF_SPEED, 11, number);
        fit(number, f.numerator, &s, s.beta_min, s.beta_max, false, 0, 1);
        number[f.numerator + 1] = 1;
        bump(number, &f.numerator, &f.denominator,
             i == 0   ? s.beta_min
             : i == 1 ? s.beta_max
                      : random_uniform(&draw, s.beta_min, s.beta_max));
        assert_proved(&f, &s, BUMP, "a rational function of beta");
    }
    clear_scene(&s);
}

/* Rows in the speed and in beta: an error that grows through one row, to BUMP at its end or its start */
TEST(test_rows)
{
    enum { DEGREE = 5, ROWS = 12 };
    struct embed_scene s = scene_of(END_ZERO_FORCE, 0.5, 1, interpolant());
    for (int of_speed = 0; of_speed < 2; of_speed++) {
        struct embed_form f = form_of(&s, of_speed ? FAMILY_PIECES_SPEED : FAMILY_PIECES_BETA,
                                      of_speed ? SPEED : FIFTH_ROOT_OF_SPEED, DEGREE, NULL);
        f.slope = (double)ROWS * (1 - 1e-9) / (s.beta_max - s.beta_min);
        f.low_bits = 50;
        f.shift = 1e-10 - s.beta_min * f.slope;
        f.first = embed_bits_of(&f, s.speed_min) >> f.low_bits;
        f.rows = of_speed ? (slong)((embed_bits_of(&f, s.speed_max) >> f.low_bits) - f.first + 1) : ROWS;
        double *const number = f.number = calloc((size_t)f.rows * (DEGREE + 1), sizeof *number);
        for (slong row = 0; row < f.rows; row++) {
            const double lo = of_speed ? embed_from_bits(&f, (f.first + (uint64_t)row) << f.low_bits)
                                       : ((double)row - f.shift) / f.slope;
            const double hi = of_speed ? embed_from_bits(&f, (f.first + (uint64_t)row + 1) << f.low_bits)
                                       : ((double)row + 1 - f.shift) / f.slope;
            fit(number + row * (DEGREE + 1), DEGREE, &s, lo, hi, of_speed, lo, of_speed ? 1 : f.slope);
        }
        assert_true(proof_of(&f, &s).formula < BUMP / 10);
        /* the last row in the speed has one argument only */
        const slong row = (slong)random_below(&draw, (unsigned)(f.rows - of_speed));
        double *const c = number + row * (DEGREE + 1);
        const double width = of_speed ? embed_from_bits(&f, (f.first + (uint64_t)row + 1) << f.low_bits) -
                                            embed_from_bits(&f, (f.first + (uint64_t)row) << f.low_bits)
                                      : 1;
        for (int at_end = 0; at_end < 2; at_end++) {
            double kept[DEGREE + 1], power = 1, at_start = c[0], last = 0;
            memcpy(kept, c, sizeof kept);
            for (int k = 0; k <= DEGREE; k++, power *= width)
                last += c[k] * power;
            /* + BUMP eps (x/width)^5, or BUMP eps (1 - x/width)^5 */
            static const double binomial[] = {1, -5, 10, -10, 5, -1};
            power = 1;
            for (int k = 0; k <= DEGREE; k++, power /= width)
                c[k] += at_end ? (k == DEGREE ? BUMP * last * power : 0) : BUMP * at_start * binomial[k] * power;
            const struct embed_proof proof = proof_of(&f, &s);
            check(proof.formula > 0.9 * BUMP && proof.formula < 1.2 * BUMP && proof.proved,
                  "row %ld of %ld, in %s: an error of %g at its %s, %g proved", (long)row, (long)f.rows,
                  of_speed ? "the speed" : "beta", BUMP, at_end ? "end" : "start", proof.formula);
            memcpy(c, kept, sizeof kept);
        }
        free(number);
    }
    clear_scene(&s);
}

/* The interpolant ends at beta = 25/16: no proof of a form that goes on to 2. */
TEST(test_gap)
{
    double number[] = {1, 1};
    struct embed_scene s = scene_of(END_ZERO_OVERLAP, 1, 2, interpolant());
    const struct embed_form f = form_of(&s, FAMILY_POLYNOMIAL_BETA, FIFTH_ROOT_OF_SPEED, 1, number);
    const struct embed_proof proof = proof_of(&f, &s);
    assert_true(!proof.proved && !(proof.error < HUGE_VAL) && proof.rounding < 1e-6);
    clear_scene(&s);
}

/* ---- rounding ---- */

/* Counts by hand for the speed x from 1/2 to 16, in units of 2^-53. Products, sums, the quotient and the roots are
 * rounded once each. */
TEST(test_counts)
{
    const double x = 16, x4 = x * x * x * x;
    static const struct {
        enum embed_variable variable;
        slong numerator, denominator;
        bool single;
        double number[5];
        const char *what;
    } form[] = {{SPEED, 1, 0, false, {3, 2}, "3 + 2 x"}, /* 2 x once and the sum once; largest at x = 16 */
                {SPEED, 2, 0, false, {1, 0, 1}, "1 + x^2 by Horner's rule: two products and the sum"},
                /* (1 + x^4) + x (0): x^2, x^2 1, x^2 x^2, the even sum, the whole sum: 4 x^4 + 2 (1 + x^4) */
                {SPEED, 4, 0, false, {1, 0, 0, 0, 1}, "1 + x^4, split"},
                /* at x = 16 both sums round once, products with 1 once, and the quotient */
                {SPEED, 1, 1, false, {1, 1, 5, 1}, "(1 + x)/(5 + x)"},
                /* sqrt(x) is rounded once, its root adds a half, and the product */
                {SQRT_OF_SPEED, 1, 0, false, {0, 1}, "sqrt(x)"},
                {FOURTH_ROOT_OF_SPEED, 1, 0, false, {0, 1}, "x^(1/4)"},
                /* float numbers below the smallest normal one: half of the smallest positive one, 2^-150, besides */
                {SPEED, 1, 0, true, {0, 0x1p-127}, "2^-127 x in float"}};
    const double units[] = {1 + 2 * x / (3 + 2 * x),
                            1 + 2 * x * x / (1 + x * x),
                            2 + 4 * x4 / (1 + x4),
                            (1 + x / (1 + x)) + (1 + x / (5 + x)) + 1,
                            2,
                            2.5,
                            (1 + 4) * 0x1p29};
    for (size_t i = 0; i < sizeof form / sizeof *form; i++) {
        double number[5];
        memcpy(number, form[i].number, sizeof number);
        const struct embed_form f = {.variable = form[i].variable,
                                     .speed_min = 0.5,
                                     .speed_max = 16,
                                     .numerator = form[i].numerator,
                                     .denominator = form[i].denominator,
                                     .single = form[i].single,
                                     .number = number};
        struct embed_rounding bound;
        assert_true(embed_rounding_bound(&bound, &f));
        check(bound.error >= units[i] * UNIT * (1 - 1e-9) && bound.error <= units[i] * UNIT * 1.02,
              "%s: %g units proved, %g by hand", form[i].what, bound.error / UNIT, units[i]);
    }
}

/* The root from bits: refined so far, off by so much. Without a refinement the bound is near the error found. */
TEST(test_root)
{
    double number[] = {0, 1};
    for (int single = 0; single < 2; single++)
        for (int refinement = 0; refinement < EMBED_REFINEMENTS; refinement++) {
            const struct embed_form f = {.family = FAMILY_POLYNOMIAL_BETA,
                                         .variable = FIFTH_ROOT_OF_SPEED,
                                         .single = single,
                                         .speed_min = single ? 1e-30 : 1e-250,
                                         .speed_max = single ? 1e30 : 1e250,
                                         .refinement = refinement,
                                         .numerator = 1,
                                         .number = number};
            double worst = 0;
            for (int k = -20000; k <= 20000; k++) {
                const double x = pow(f.speed_max, k / 20000.0), g = single ? (double)(float)x : x;
                for (int fused = 0; fused < 2; fused++)
                    worst = fmax(worst, fabs(embed_form_value(&f, g, fused) / (double)powl((long double)g, 0.2L) - 1));
            }
            assert_true(worst <= embed_root_error(refinement, single));
            assert_true(worst >= embed_root_error(refinement, single) / 20);
            struct embed_rounding bound;
            embed_rounding_bound(&bound, &f);
            check(worst <= bound.root && bound.root <= 3 * embed_root_error(refinement, single) &&
                      (refinement > 0 || bound.root <= 1.25 * worst),
                  "fifth root, %d refinements: %g proved, %g found", refinement, bound.root, worst);
        }
}

/* A polynomial with a zero and one that overflows: no bound. The place in a table has the error of a
 * product and of a sum besides, and a table that is too short is refused. */
TEST(test_limits)
{
    struct embed_rounding bound;
    struct embed_form f = {
        .variable = SPEED, .speed_min = 0.5, .speed_max = 16, .numerator = 1, .number = (double[]){-3, 1}};
    assert_false(embed_rounding_bound(&bound, &f));
    f.number = (double[]){1, 1e308};
    assert_false(embed_rounding_bound(&bound, &f));
    f.variable = FIFTH_ROOT_OF_SPEED;
    f.family = FAMILY_PIECES_BETA;
    f.refinement = EMBED_REFINEMENTS - 1;
    f.numerator = 0;
    f.rows = 1000;
    double row[1000];
    for (int i = 0; i < 1000; i++)
        row[i] = 1;
    f.number = row;
    const double least = pow(0.5, 0.2), most = pow(16, 0.2);
    f.slope = 999.999 / (most - least);
    f.shift = 1e-4 - least * f.slope;
    assert_true(embed_rounding_bound(&bound, &f));
    const double place = most * f.slope * (bound.root + UNIT) + 1000 * UNIT;
    assert_true(bound.place >= place * (1 - 1e-9) && bound.place <= 1.001 * place);
    f.rows = 999;
    assert_false(embed_rounding_bound(&bound, &f));
    f.rows = 1000;
    f.shift -= 2e-4;
    assert_false(embed_rounding_bound(&bound, &f));
}

RUN_TESTS(test_counts, test_root, test_limits, test_far_parts, test_intervals, test_rows, test_gap)
