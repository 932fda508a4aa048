/* SPDX-License-Identifier: MIT */
/* Tests the proofs of embedded headers (gen/embed/proof.c, rounding.c). A form with an added error of known size must
 * have a proved error of at least this size, at whichever speed the error is. Compares bounds of rounding errors with
 * counts by hand. */
#include <math.h>

#include "ball.h"
#include "embed/form.h"
#include "enclosure/collision.h"
#include "support/emit_c.h"
#include "support/local.h"

#define UNIT 0x1p-53
/* Size of the added errors; the errors of the fits below are smaller. */
#define BUMP 1e-6

/* Returns a scene with beta = speed^(1/5); the caller clears it. */
static struct embed_scene scene_of(enum cor_end end, double beta_min, double beta_max, struct interpolant *f)
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
    arb_set_d(s.h_star_5, 5.158); /* test_far_parts, which needs the exact value, sets it */
    return s;
}

static void clear_scene(struct embed_scene *s)
{
    FOR_ALL(arb, clear, s->beta_per_root, s->beta_enclosed, s->h_star_5);
}

/* Returns a form for the whole range, with the most accurate roots. */
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

/* ---- errors at a chosen place ---- */

/* Multiplies a form by 1 + BUMP 2 x y/(x^2 + y^2), which is largest at x = y, for several y in the range of the
 * variable x. Fails unless each proof finds this error. */
static void assert_bumps_proved(const struct embed_form *f, const struct embed_scene *s, const char *what)
{
    const double power = 1 / (double)embed_roots[f->variable].degree;
    const double lo = pow(s->speed_min, power), hi = pow(s->speed_max, power);
    const slong m = f->numerator, n = f->denominator;
    for (int i = 0; i <= 8; i++) {
        const double y = lo * pow(hi / lo, i / 8.0), above[] = {y * y, 2 * BUMP * y, 1}, below[] = {y * y, 0, 1};
        double number[40] = {0};
        struct embed_form bumped = *f;
        for (slong j = 0; j <= 2; j++) {
            for (slong k = 0; k <= m; k++)
                number[k + j] += above[j] * f->number[k];
            for (slong k = 0; k <= n; k++)
                number[m + 3 + k + j] += below[j] * (n > 0 ? f->number[m + 1 + k] : 1);
        }
        bumped.numerator += 2;
        bumped.denominator += 2;
        bumped.number = number;
        const struct embed_proof proof = proof_of(&bumped, s);
        check(proof.formula >= BUMP * (1 - 1e-4) && proof.formula <= 1.1 * BUMP && proof.proved,
              "%s: an error of %g, %g proved", what, BUMP, proof.formula);
        assert_true(proof.rounding > 0 && proof.error >= proof.formula + proof.rounding);
    }
}

/* The form is eps = 32 h*^5/speed with beta = speed^(1/5)/2 from 8 to 20. There the exact eps comes from the power law
 * instead of an interpolant. The proved error contains EMBED_FAR_ERROR, the error of the power law. */
TEST(test_far_parts)
{
    struct embed_scene s = scene_of(COR_END_ZERO_OVERLAP, 16, 40, NULL);
    LOCAL(arb, rest);
    assert_int_equal(collision_h_star(s.h_star_5, 128), 0);
    arb_pow_ui(s.h_star_5, s.h_star_5, 5, EMBED_BITS);
    const double h5 = middle(s.h_star_5);
    arb_set_d(s.beta_per_root, 0.5);
    arb_set_d(s.beta_enclosed, 0.5);
    s.beta_min /= 2;
    s.beta_max /= 2;
    double number[] = {32 * h5, 0, 1};
    struct embed_form f = form_of(&s, FAMILY_RATIONAL_SPEED, SPEED, 0, number);
    f.denominator = 1;
    LET(rest, EMBED_BITS, "abs(h5 - s.h_star_5)/h5", h5, s.h_star_5);
    const double least = middle(rest) + EMBED_FAR_ERROR;
    f.error = least; /* the least error that a proof can reach; the samples do not contain EMBED_FAR_ERROR */
    const struct embed_proof proof = proof_of(&f, &s);
    check(proof.formula >= least * (1 - 1e-9) && proof.formula <= 1.1 * least, "h*^5/g is off by %g, %g proved", least,
          proof.formula);
    f.error = 0;
    assert_bumps_proved(&f, &s, "beyond beta = 7");
    clear_scene(&s);
}

/* ---- within the interpolant's intervals ---- */

/* Returns an interpolant up to beta = 1, in two intervals, made for the first test that needs it. */
static struct interpolant *interpolant(void)
{
    static struct interpolant *made;
    if (!made)
        made = interpolant_new(&interpolant_sphere_proof, 0, 1);
    assert_non_null(made);
    return made;
}

/* The proof finds errors of a rational function of beta from 0.15 to 0.95, across two intervals. */
TEST(test_intervals)
{
    struct embed_scene s = scene_of(COR_END_ZERO_OVERLAP, 0.15, 0.95, interpolant());
    struct embed_form f = form_of(&s, FAMILY_RATIONAL_BETA, FIFTH_ROOT_OF_SPEED, 11, NULL);
    assert_true(embed_fit_rational(&f, &s));
    assert_bumps_proved(&f, &s, "a rational function of beta");
    embed_form_clear(&f);
    clear_scene(&s);
}

/* Adds an error that grows to BUMP at the start or end of a row in the speed or in beta. The proof must find it. */
TEST(test_rows)
{
    enum { DEGREE = 5, ROWS = 12 };
    struct embed_scene s = scene_of(COR_END_ZERO_FORCE, 0.5, 1, interpolant());
    for (int of_speed = 0; of_speed < 2; of_speed++) {
        struct embed_form f = form_of(&s, of_speed ? FAMILY_PIECES_SPEED : FAMILY_PIECES_BETA,
                                      of_speed ? SPEED : FIFTH_ROOT_OF_SPEED, DEGREE, NULL);
        f.low_bits = 50;
        f.first = emit_bits_of(f.single, s.speed_min) >> f.low_bits;
        f.rows = of_speed ? (slong)((emit_bits_of(f.single, s.speed_max) >> f.low_bits) - f.first + 1) : ROWS;
        assert_true(embed_fit_pieces(&f, &s));
        assert_true(proof_of(&f, &s).formula < BUMP / 10);
        /* excludes the last row in the speed, which contains only one argument */
        const slong row = (slong)random_below(&draw, (unsigned)(f.rows - of_speed));
        double *const c = f.number + row * (DEGREE + 1);
        const double width = of_speed ? embed_row_start(&f, row + 1) - embed_row_start(&f, row) : 1;
        for (int at_end = 0; at_end < 2; at_end++) {
            double kept[DEGREE + 1], power = 1, at_start = c[0], last = 0;
            memcpy(kept, c, sizeof kept);
            for (int k = 0; k <= DEGREE; k++, power *= width)
                last += c[k] * power;
            /* adds BUMP eps (x/width)^5, or BUMP eps (1 - x/width)^5 */
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
        embed_form_clear(&f);
    }
    clear_scene(&s);
}

/* The interpolant ends at beta = 25/16, so a form up to 2 has no proof. The power law begins at 7, not at 6.9. */
TEST(test_gap)
{
    for (int far = 0; far < 2; far++) {
        double number[] = {1, 1};
        struct embed_scene s = scene_of(COR_END_ZERO_OVERLAP, far ? 6.9 : 1, far ? 8 : 2, interpolant());
        const struct embed_form f = form_of(&s, FAMILY_POLYNOMIAL_BETA, FIFTH_ROOT_OF_SPEED, 1, number);
        const struct embed_proof proof = proof_of(&f, &s);
        assert_true(!proof.proved && !(proof.error < HUGE_VAL) && proof.rounding < 1e-6);
        clear_scene(&s);
    }
}

/* ---- rounding ---- */

/* The bounds agree with counts by hand, in units of 2^-53, for the speed x from 1/2 to 16. Products, sums, the quotient
 * and the roots are each rounded once. */
TEST(test_counts)
{
    const double x = 16, x4 = x * x * x * x;
    const struct {
        enum embed_variable variable;
        slong numerator, denominator;
        double units;
        double number[5];
        const char *what;
    } form[] = {
        {SPEED, 1, 0, 1 + 2 * x / (3 + 2 * x), {3, 2}, "3 + 2 x"}, /* 2 x once and the sum once; largest at x = 16 */
        {SPEED, 2, 0, 1 + 2 * x * x / (1 + x * x), {1, 0, 1}, "1 + x^2 by Horner's rule: two products and the sum"},
        /* Evaluated as (1 + x^4) + x 0. The products x^2, 1 x^2 and x^2 x^2 add 4 x^4; the two sums add 2 (1 + x^4). */
        {SPEED, 4, 0, 2 + 4 * x4 / (1 + x4), {1, 0, 0, 0, 1}, "1 + x^4, split"},
        /* largest at x = 16: each sum, each product by 1, and the quotient round once */
        {SPEED, 1, 1, (1 + x / (1 + x)) + (1 + x / (5 + x)) + 1, {1, 1, 5, 1}, "(1 + x)/(5 + x)"},
        /* sqrt(x) rounds once, and so does the product; the root of sqrt(x) halves its error and rounds once */
        {SQRT_OF_SPEED, 1, 0, 2, {0, 1}, "sqrt(x)"},
        {FOURTH_ROOT_OF_SPEED, 1, 0, 2.5, {0, 1}, "x^(1/4)"},
        /* below the smallest normal float, a result also has an error of half the smallest positive float, 2^-150 */
        {SPEED, 1, 0, (1 + 4) * 0x1p29, {0, 0x1p-127}, "2^-127 x in float"}};
    for (size_t i = 0; i < COUNT_OF(form); i++) {
        double number[5];
        memcpy(number, form[i].number, sizeof number);
        const struct embed_form f = {.variable = form[i].variable,
                                     .speed_min = 0.5,
                                     .speed_max = 16,
                                     .numerator = form[i].numerator,
                                     .denominator = form[i].denominator,
                                     .single = i + 1 == COUNT_OF(form),
                                     .number = number};
        struct embed_rounding bound;
        assert_true(embed_rounding_bound(&bound, &f));
        check(bound.error >= form[i].units * UNIT * (1 - 1e-9) && bound.error <= form[i].units * UNIT * 1.02,
              "%s: %g units proved, %g by hand", form[i].what, bound.error / UNIT, form[i].units);
    }
}

/* The fifth root from the bits of the speed. Without refinements the bound is close to the largest error found. */
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

/* A polynomial with a zero in the range has no bound, nor has a polynomial that overflows. The index of a row has the
 * rounding errors of a product and of a sum. A table is refused if rounding can lead beyond its last row. */
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
    f.slope = 990 / (most - least);
    f.shift = 5 - least * f.slope;
    f.refinement = 1;
    assert_true(embed_rounding_bound(&bound, &f));
    for (int k = 0; k < 4; k++) {
        const double end = (k < 2 ? least : most) * f.slope, off = (k % 2 ? 1.1 : 0.9) * bound.root * end;
        f.shift = k < 2 ? off - end : 1000 - end - off;
        assert_true(embed_rounding_bound(&bound, &f) == k % 2);
    }
}

/* A row 1 - 3/4 x, 0 <= x <= 1. At x = 1 the product adds 3/4 units and the sum 1/4, relative to the value 1/4. */
TEST(test_row_end)
{
    struct embed_form f = {
        .family = FAMILY_PIECES_SPEED, .variable = SPEED, .speed_min = 1, .speed_max = 2, .numerator = 1, .rows = 1};
    struct embed_rounding bound;
    f.number = (double[]){1, -0.75};
    f.low_bits = 52;
    f.first = emit_bits_of(f.single, 1) >> f.low_bits;
    assert_true(embed_rounding_bound(&bound, &f));
    check(bound.error >= 4 * UNIT * (1 - 1e-9) && bound.error <= 5 * UNIT, "a row: %g units", bound.error / UNIT);
}
