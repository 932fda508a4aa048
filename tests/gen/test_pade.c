/* SPDX-License-Identifier: MIT */
/* Tests Padé approximants: exactly known ones, a published one, the defining conditions, and the analysis. */
#include "ball.h"

#include "approximation/pade.h"
#include "enclosure/collision.h"
#include "support/local.h"

enum { PREC = 256, BITS = 160 };

static double coefficient(const arb_poly_t p, slong power)
{
    LOCAL(arb, x);
    arb_poly_get_coeff_arb(x, p, power);
    return middle(x);
}

static void assert_near(double x, double y, double tolerance)
{
    check(x - y <= tolerance && y - x <= tolerance, "%.17g is not %.17g within %g", x, y, tolerance);
}

/* Fails unless every coefficient of P/Q - c below `count` is a narrow ball around 0. */
static void assert_reexpands(const struct pade *f, const arb_poly_t c, slong count)
{
    LOCAL(arb_poly, s);
    LOCAL(arb, x, y);
    arb_poly_div_series(s, f->p, f->q, count, 4 * PREC);
    for (slong k = 0; k < count; k++) {
        arb_poly_get_coeff_arb(x, s, k);
        arb_poly_get_coeff_arb(y, c, k);
        assert_true(arb_overlaps(x, y));
        arb_sub(x, x, y, PREC);
        assert_true(mag_cmp_2exp_si(arb_radref(x), -BITS / 2) < 0);
    }
}

static struct pade_request ordinary(slong m, slong n, enum cor_end end)
{
    return (struct pade_request){
        .kind = PADE_ORDINARY, .numerator = m, .denominator = n, .end = end, .law = law_sphere};
}

/* [2/3] of exp: (1 + 2/5 z + 1/20 z^2)/(1 - 3/5 z + 3/20 z^2 - 1/60 z^3) */
TEST(test_exponential)
{
    static const struct {
        slong m, n, k, num, den;
    } known[] = {{2, 3, 0, 1, 1},    {2, 3, 1, 2, 5},   {2, 3, 2, 1, 20},  {2, 3, -1, -3, 5}, {2, 3, -2, 3, 20},
                 {2, 3, -3, -1, 60}, {5, 0, 5, 1, 120}, {0, 2, -1, -1, 1}, {0, 2, -2, 1, 2},  {0, 0, 0, 1, 1}};
    LOCAL(pade, f);
    LOCAL(arb_poly, c);
    LOCAL(arb, x);
    arb_poly_set_coeff_si(c, 1, 1);
    arb_poly_exp_series(c, c, 6, PREC);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) { /* numerator: k >= 0; denominator: k < 0 */
        const slong k = known[i].k, num = known[i].num, den = known[i].den;
        assert_true(pade_of_series(f, c, known[i].m, known[i].n, PREC));
        assert_true(arb_poly_degree(f->p) == known[i].m && arb_poly_degree(f->q) == known[i].n);
        assert_true(arb_is_one(arb_poly_get_coeff_ptr(f->q, 0)));
        arb_poly_get_coeff_arb(x, k < 0 ? f->q : f->p, labs(k));
        assert_is(x, "coefficient", k, "num/den", num, den);
        assert_bits(x, BITS);
    }
}

TEST(test_reexpansion)
{
    static const struct {
        slong m, n;
        enum cor_end end;
    } entry[] = {{1, 4, COR_END_ZERO_OVERLAP},  {4, 4, COR_END_ZERO_OVERLAP}, {9, 13, COR_END_ZERO_OVERLAP},
                 {13, 9, COR_END_ZERO_OVERLAP}, {1, 4, COR_END_ZERO_FORCE},   {11, 14, COR_END_ZERO_FORCE}};
    for (size_t i = 0; i < sizeof entry / sizeof *entry; i++) {
        if (left_to_turn(i, 2))
            continue;
        const struct pade_request r = ordinary(entry[i].m, entry[i].n, entry[i].end);
        LOCAL(pade, f);
        LOCAL(arb_poly, c);
        slong root;
        assert_int_equal(pade_compute(f, NULL, &r, PREC), 0);
        assert_int_equal(series_eps(c, &root, r.end, r.numerator + r.denominator, &r.law, PREC), 0);
        assert_int_equal(f->root, root);
        assert_reexpands(f, c, r.numerator + r.denominator + 1);
    }
}

/* The approximant has the series C_0..C_{m+4} at 0, and h*^5/beta^5 (1 + 0 + ... + 0) at infinity. */
TEST(test_two_point)
{
    leave_to_turn(1, 3);
    enum { TWO_POINT_PREC = 128 }; /* a larger m would take seconds */
    const slong m = 8, n = m + 5;
    const struct pade_request r = {
        .kind = PADE_TWO_POINT, .numerator = m, .denominator = n, .end = COR_END_ZERO_OVERLAP, .law = law_sphere};
    LOCAL(pade, f);
    LOCAL(pade_analysis, a);
    LOCAL(collision, collision);
    LOCAL(arb_poly, c, p, q);
    LOCAL(arb, x, y);
    slong root;
    assert_int_equal(pade_compute(f, a, &r, TWO_POINT_PREC), 0);
    assert_null(pade_defects(a));
    assert_int_equal(series_eps(c, &root, r.end, m + n, &r.law, TWO_POINT_PREC), 0);
    assert_reexpands(f, c, m + 5);

    for (slong k = 0; k <= m; k++)
        arb_poly_set_coeff_arb(p, m - k, arb_poly_get_coeff_ptr(f->p, k));
    for (slong k = 0; k <= n; k++)
        arb_poly_set_coeff_arb(q, n - k, arb_poly_get_coeff_ptr(f->q, k));
    arb_poly_div_series(p, p, q, m + 1, TWO_POINT_PREC);
    assert_int_equal(collision_h_star(x, TWO_POINT_PREC), 0);
    arb_poly_get_coeff_arb(y, p, 0);
    assert_is(y, "at infinity", 0, "x^5", x);
    for (slong k = 1; k <= m; k++) {
        arb_poly_get_coeff_arb(x, p, k);
        assert_true(arb_contains_zero(x));
        assert_true(mag_cmp_2exp_si(arb_radref(x), -TWO_POINT_PREC / 2) < 0);
    }
    /* safe but imprecise: all coefficients are positive, the error is 3 % at beta = 3 and 8e-9 at 1/2 */
    for (slong k = 0; k <= m + 1 + n; k++)
        assert_true(
            arb_is_positive(k <= m ? arb_poly_get_coeff_ptr(f->p, k) : arb_poly_get_coeff_ptr(f->q, k - m - 1)));
    static const double beta[] = {3, 0.5}, low[] = {0.02, 5e-9}, high[] = {0.04, 1e-8};
    for (int i = 0; i < 2; i++) {
        LOCAL(arb, z);
        arb_set_d(z, beta[i]);
        assert_int_equal(collision_solve(collision, z, &law_sphere, TWO_POINT_PREC), 0);
        arb_poly_evaluate(x, f->p, z, TWO_POINT_PREC);
        arb_poly_evaluate(y, f->q, z, TWO_POINT_PREC);
        LET(x, TWO_POINT_PREC, "abs(x/y/collision->eps_zero_overlap - 1)", x, y, collision->eps_zero_overlap);
        const double error = middle(x);
        check(error > low[i] && error < high[i], "two-point error %g at beta = %g", error, beta[i]);
    }
}

/* Table I follows from the printed a_k and a fifth coefficient 0. */
TEST(test_published)
{
    static const double d[] = {2.5840, 3.5840, 2.9840, 1.1487, 0.3265};
    const struct pade_request r = {
        .kind = PADE_AS_PUBLISHED, .numerator = 1, .denominator = 4, .end = COR_END_ZERO_OVERLAP, .law = law_sphere};
    LOCAL(pade, f);
    LOCAL(pade_analysis, a);
    assert_int_equal(pade_compute(f, a, &r, PREC), 0);
    assert_null(pade_defects(a));
    assert_string_equal(f->variable, "x");
    assert_near(coefficient(f->p, 0), 1, 0);
    for (int k = 0; k <= 4; k++) { /* the printed values, up to the six decimals of a_3 and a_4 */
        const double computed = k == 0 ? coefficient(f->p, 1) : coefficient(f->q, k);
        assert_near(computed, d[k], 5e-5);
        assert_near(computed, atof(published_d[k]), 2e-4);
    }
}

/* The [1/4] of the true series differs from the published one, and is negative above beta = 2.9. */
TEST(test_true_one_four)
{
    const struct pade_request r = ordinary(1, 4, COR_END_ZERO_OVERLAP);
    LOCAL(pade, f);
    LOCAL(pade_analysis, a);
    assert_int_equal(pade_compute(f, a, &r, PREC), 0);
    const double c1 = coefficient(f->p, 1) - coefficient(f->q, 1);
    assert_near(c1, -1.15344885810, 1e-10);
    assert_near(coefficient(f->p, 1) / -c1, -0.30244058, 1e-8); /* the variable is x = |C_1| beta */
    assert_int_equal(a->poles.count, 4);
    assert_int_equal(a->poles.positive, 0);
    assert_int_equal(a->zeros.count, 1);
    assert_int_equal(a->zeros.positive, 1);
    assert_near(middle(acb_realref(a->zeros.root)), -1 / coefficient(f->p, 1), 1e-9);
    char *defects = pade_defects(a);
    assert_non_null(defects);
    assert_non_null(strstr(defects, "a zero at beta = 2.86656"));
    assert_null(strstr(defects, "pole"));
    free(defects);
}

/* Multiplies p by (z - re)^2 + im^2, normalised to 1 at 0. */
static void multiply_pair(arb_poly_t p, double re, double im)
{
    LOCAL(arb_poly, factor);
    arb_poly_fit_length(factor, 3);
    arb_one(factor->coeffs);
    LET(factor->coeffs + 1, PREC, "-2*re/(re^2 + im^2)", re, im);
    LET(factor->coeffs + 2, PREC, "1/(re^2 + im^2)", re, im);
    _arb_poly_set_length(factor, 3);
    arb_poly_mul(p, p, factor, PREC);
}

TEST(test_spurious_pair)
{
    LOCAL(pade, f);
    LOCAL(pade_analysis, a);
    f->root = 2;
    f->variable = "beta";
    /* poles and zeros away from each other; a pair far from the axis; a pair close to it */
    arb_poly_one(f->p);
    arb_poly_one(f->q);
    multiply_pair(f->q, 1, 3);
    multiply_pair(f->p, 2, 3);
    multiply_pair(f->q, -1, 1);
    multiply_pair(f->p, -1.001, 1);
    assert_true(pade_analyse(a, f, PREC));
    assert_int_equal(a->poles.count, 4);
    assert_int_equal(a->pairs, 2);
    assert_int_equal(a->spurious, 0);
    assert_null(pade_defects(a));

    for (int k = 0; k < 20; k++) { /* pole-zero pairs whose slope is just inside and outside PADE_PAIR_SLOPE */
        LOCAL(pade, g);
        LOCAL(pade_analysis, b);
        const double re = random_uniform(&draw, 0.5, 4), im = re / PADE_PAIR_SLOPE * (k % 2 ? 1.02 : 0.98);
        g->root = 2;
        arb_poly_one(g->p);
        arb_poly_one(g->q);
        multiply_pair(g->q, re, im);
        multiply_pair(g->p, re * 1.001, im);
        assert_true(pade_analyse(b, g, PREC) && b->spurious == (k % 2 ? 0 : 2));
    }

    multiply_pair(f->q, 2, 0.25);
    multiply_pair(f->p, 2.0625, 0.25); /* pole and zero differ by 3 %: no pair */
    assert_true(pade_analyse(a, f, PREC));
    assert_int_equal(a->spurious, 0);

    multiply_pair(f->q, 3, 0.5);
    multiply_pair(f->p, 3.0009765625, 0.5);
    assert_true(pade_analyse(a, f, PREC));
    assert_int_equal(a->pairs, 4);
    assert_int_equal(a->spurious, 2); /* the pair and its conjugate */
    assert_int_equal(a->poles.positive, 0);
    char *defects = pade_defects(a);
    assert_non_null(defects);
    assert_non_null(strstr(defects, "spurious pole-zero pair at beta = 8.75 ")); /* (3 + i/2)^2 */
    free(defects);

    /* a pole, a zero and a pair on the axis */
    LOCAL(arb_poly, shifted);
    LOCAL(arb, x);
    arb_poly_shift_left(shifted, f->q, 1);
    arb_poly_sub(f->q, f->q, shifted, PREC);
    arb_set_d(x, 1.0009765625);
    arb_poly_shift_left(shifted, f->p, 1);
    arb_poly_scalar_mul(shifted, shifted, x, PREC);
    arb_poly_sub(f->p, f->p, shifted, PREC);
    assert_true(pade_analyse(a, f, PREC));
    assert_int_equal(a->poles.positive, 1);
    assert_int_equal(a->zeros.positive, 1);
    assert_int_equal(a->spurious, 3);
    defects = pade_defects(a);
    assert_non_null(strstr(defects, "a pole at beta = 1;"));
    free(defects);

    /* roots that no precision can separate are not reported as isolated */
    arb_poly_mul(f->q, f->q, f->q, PREC);
    assert_false(pade_analyse(a, f, PREC));
}

/* Without cancellation a polynomial of degree n adds 3 n u: for each degree z, a product and a sum are rounded. The
 * rest, 3 u, is from the roundings of its coefficients, of the denominator 1 and of the quotient. */
TEST(test_evaluation_error)
{
    const double u = 0x1p-53;
    LOCAL(pade_rounded, r);
    arb_poly_one(r->q_double);
    for (slong n = 1; n < 12; n++) {
        double eps, loss;
        for (slong k = 0; k <= n; k++)
            arb_poly_set_coeff_si(r->p_double, k, k + 1);
        arb_poly_set_coeff_si(r->l_double, n - 1, 1);
        pade_evaluation_error(&eps, &loss, r, 4);
        const double least = (3 * (double)n + 3) * u;
        check(eps > least && eps < 1.1 * least, "degree %ld: %g u", (long)n, eps / u);
        check(loss > least - 2 * u && loss < 1.1 * least, "degree %ld: loss %g u", (long)n, loss / u);
    }
}

/* The [1/2] of 1/(1 + z) + d/(1 - z/2) has a pole at 2. Its zero is at 2 (1 + d)/(1 - 2 d), which is 6 d/(1 - 2 d)
 * further out. The distance of a pair is relative to its size. */
TEST(test_near_pair)
{
    static const slong power[] = {10, 53, 300};
    const slong prec = 1200;
    for (size_t i = 0; i < sizeof power / sizeof *power; i++) {
        LOCAL(pade, f);
        LOCAL(pade_analysis, a);
        LOCAL(arb_poly, c);
        LOCAL(arb, d, x);
        f->root = 1;
        f->variable = "z";
        LET(d, prec, "1/2^power[i]", power[i]);
        for (slong k = 0; k <= 8; k++) {
            LET(x, prec, "(-1)^k + d/2^k", k, d);
            arb_poly_set_coeff_arb(c, k, x);
        }
        assert_true(pade_of_series(f, c, 1, 2, prec) && pade_analyse(a, f, prec));
        assert_true(a->pairs == 1 && a->spurious == 1 && a->poles.positive == 1);
        LET(x, prec, "3*d/(1 - 2*d)", d);
        assert_overlap(a->pair->distance, x, "distance for 2^-", power[i]);
    }
}

/* Counts the sign changes on 4.5e-5 <= beta <= 22026, at 100 places per factor e; p(0) > 0. */
static slong sign_changes(const arb_poly_t p)
{
    slong changes = 0;
    int before = 1;
    LOCAL(arb, x, y);
    for (int k = -1000; k <= 1000; k++) {
        arb_set_d(x, exp(k / 100.0));
        arb_poly_evaluate(y, p, x, PREC);
        const int sign = arf_sgn(arb_midref(y));
        changes += sign != before && sign != 0;
        before = sign != 0 ? sign : before;
    }
    return changes;
}

/* On the positive axis, [m/n] of eps has a pole or a zero for each sign change of its polynomials there. */
TEST(test_poles_of_eps)
{
    const slong most = points(6) > 6 ? 14 : 6;
    for (slong m = 0; m <= most; m++)
        for (slong n = 1; m + n <= most; n++) {
            const struct pade_request r = ordinary(m, n, COR_END_ZERO_OVERLAP);
            LOCAL(pade, f);
            LOCAL(pade_analysis, a);
            /* 1/eps has no beta^10, so [0/9] = [0/10] = [1/9], and [1/10] does not exist */
            const bool exists = !(m == 1 && n == 10);
            assert_int_equal(pade_compute(f, a, &r, 100), exists ? 0 : 1);
            if (exists) {
                char *const defects = pade_defects(a);
                const slong poles = sign_changes(f->q), zeros = sign_changes(f->p);
                check(a->poles.positive == poles && a->zeros.positive == zeros && (defects || poles + zeros == 0),
                      "[%ld/%ld]: %ld poles, %ld zeros", (long)m, (long)n, (long)poles, (long)zeros);
                free(defects);
            }
        }
}

static void assert_block(const arb_poly_t c, slong m, slong n, slong at_m, slong at_n, slong size, bool open)
{
    struct pade_block b;
    assert_true(pade_block_of(&b, c, m, n, PREC));
    assert_int_equal(b.m, at_m);
    assert_int_equal(b.n, at_n);
    assert_int_equal(b.size, size);
    assert_true(b.open == open);
}

TEST(test_degenerate)
{
    LOCAL(pade, f);
    struct pade_block b;
    LOCAL(arb_poly, c);

    /* 1/(1 - z/3) is itself a fraction, so every larger approximant is equal to it */
    LOCAL(arb, x);
    arb_one(x);
    for (slong k = 0; k <= 12; k++) {
        arb_poly_set_coeff_arb(c, k, x);
        arb_div_si(x, x, 3, PREC);
    }
    assert_true(pade_of_series(f, c, 0, 1, PREC));
    assert_true(pade_of_series(f, c, 3, 1, PREC));
    assert_false(pade_of_series(f, c, 1, 2, PREC));
    assert_false(pade_of_series(f, c, 4, 4, PREC));
    assert_false(pade_block_of(&b, c, 3, 1, PREC));
    assert_block(c, 1, 2, 0, 1, 12, true);
    assert_block(c, 4, 4, 0, 1, 10, true);

    /* 1 + z^3 + 2 z^4 + ...: each of [0/0]..[2/2] is 1 or does not exist */
    arb_poly_zero(c);
    arb_poly_set_coeff_si(c, 0, 1);
    for (slong k = 3; k <= 10; k++)
        arb_poly_set_coeff_si(c, k, k * k - 3 * k + 1);
    assert_block(c, 1, 1, 0, 0, 3, false);
    assert_block(c, 2, 2, 0, 0, 3, false);
    assert_false(pade_block_of(&b, c, 3, 1, PREC));

    /* eps at zero force has no term in z = sqrt(beta): [1/1] is refused, [0/2] is not */
    struct pade_request r = ordinary(1, 1, COR_END_ZERO_FORCE);
    assert_int_equal(pade_compute(f, NULL, &r, BITS), 1);
    r = ordinary(0, 2, COR_END_ZERO_FORCE);
    assert_int_equal(pade_compute(f, NULL, &r, BITS), 0);
}

/* Fails unless p and q of two Padé approximants overlap, and their degrees and counts of roots agree. */
static void assert_same_fraction(const struct pade_request *r, const struct pade_request *other)
{
    LOCAL(pade, f, g);
    LOCAL(pade_analysis, a);
    assert_int_equal(pade_compute(f, a, r, BITS), 0);
    assert_int_equal(pade_compute(g, NULL, other, BITS), 0);
    assert_poly_overlap(f->p, g->p, r->numerator, "numerator");
    assert_poly_overlap(f->q, g->q, r->denominator, "denominator");
    assert_int_equal(f->numerator, r->numerator);
    assert_int_equal(f->denominator, r->denominator);
    assert_int_equal(a->poles.count, arb_poly_degree(g->q));
    assert_int_equal(a->zeros.count, arb_poly_degree(g->p));
}

/* By the involution (docs/theory.md, 4), 1/eps of the sphere and eps of the law (3/2, 0) have no term beta^10. Ball
 * arithmetic cannot prove that a number is exactly zero. */
TEST(test_exact_zeros)
{
    LOCAL(series, s);
    LOCAL(arb_poly, reciprocal);
    assert_int_equal(series_compute(s, 12, &law_sphere, BITS), 0);
    arb_poly_inv_series(reciprocal, s->c, 13, PREC);
    for (slong k = 0; k <= 12; k++)
        assert_true(arb_contains_zero(arb_poly_get_coeff_ptr(reciprocal, k)) == (k == 10));

    const struct pade_request corner = ordinary(0, 9, COR_END_ZERO_OVERLAP),
                              right = ordinary(0, 10, COR_END_ZERO_OVERLAP),
                              down = ordinary(1, 9, COR_END_ZERO_OVERLAP),
                              inner = ordinary(1, 10, COR_END_ZERO_OVERLAP),
                              next = ordinary(0, 11, COR_END_ZERO_OVERLAP);
    assert_same_fraction(&right, &corner);
    assert_same_fraction(&down, &corner);
    LOCAL(pade, f);
    assert_int_equal(pade_compute(f, NULL, &inner, BITS), 1);
    assert_int_equal(pade_compute(f, NULL, &next, BITS), 0);
    assert_true(arb_is_zero(arb_poly_get_coeff_ptr(f->q, 10)));
    assert_int_equal(arb_poly_degree(f->q), 11);

    struct pade_request hertz = ordinary(9, 0, COR_END_ZERO_OVERLAP), same = hertz;
    assert_null(law_parse(&hertz.law, "3/2", "0"));
    same.law = hertz.law;
    same.numerator = 10;
    assert_same_fraction(&same, &hertz);
    same.numerator = 9;
    same.denominator = 1;
    assert_same_fraction(&same, &hertz);
    same.numerator = 10;
    assert_int_equal(pade_compute(f, NULL, &same, BITS), 1);
}

TEST(test_refusals)
{
    static const struct {
        enum pade_kind kind;
        slong m, n;
        enum cor_end end;
        bool tsuji, refused;
    } cases[] = {{PADE_ORDINARY, 4, 4, COR_END_ZERO_OVERLAP, false, false},
                 {PADE_ORDINARY, -1, 4, COR_END_ZERO_OVERLAP, false, true},
                 {PADE_TWO_POINT, 4, 4, COR_END_ZERO_OVERLAP, false, true},
                 {PADE_TWO_POINT, 4, 9, COR_END_ZERO_OVERLAP, false, false},
                 {PADE_TWO_POINT, 4, 9, COR_END_ZERO_FORCE, false, true},
                 {PADE_TWO_POINT, 4, 9, COR_END_ZERO_OVERLAP, true, true},
                 {PADE_AS_PUBLISHED, 2, 4, COR_END_ZERO_OVERLAP, false, true},
                 {PADE_AS_PUBLISHED, 1, 4, COR_END_ZERO_OVERLAP, false, false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct pade_request r = ordinary(cases[i].m, cases[i].n, cases[i].end);
        r.kind = cases[i].kind;
        r.law = cases[i].tsuji ? law_of("3/2", "1/4") : law_sphere;
        check((pade_refusal(&r) != NULL) == cases[i].refused, "case %zu", i);
    }
}

/* Tests rounded coefficients of a Padé approximant in beta^(1/root), and the error of their quotient in doubles. */
TEST(test_rounded)
{
    static const struct {
        enum cor_end end;
        slong m, n;
    } entry[] = {{COR_END_ZERO_OVERLAP, 3, 6}, {COR_END_ZERO_FORCE, 4, 7}};
    enum { EVEN = 8, SMALL = 2, BETA_MAX = 2 };
    struct references s;
    LOCAL(collision, collision);
    LOCAL(arb, beta);
    assert_int_equal(references_init(&s, &law_sphere, BETA_MAX, EVEN, SMALL), 0);
    assert_int_equal(s.count, EVEN + SMALL);
    for (size_t k = 0; k < sizeof entry / sizeof *entry; k++) {
        const struct pade_request r = ordinary(entry[k].m, entry[k].n, entry[k].end);
        LOCAL(pade, f);
        LOCAL(pade_rounded, rounded);
        LOCAL(pade_error, error);
        double worst = 0, worst_loss = 0;
        assert_int_equal(pade_compute(f, NULL, &r, PREC), 0);
        assert_int_equal(pade_round(rounded, f), 0);
        pade_approximation_error(error, rounded, r.end, &s);
        for (int i = 1; i <= EVEN; i++) {
            const double b = (double)BETA_MAX * i / (double)EVEN, z = r.end == COR_END_ZERO_FORCE ? sqrt(b) : b;
            double p = 0, q = 0, l = 0;
            for (slong j = 0; j <= entry[k].m + entry[k].n; j++) {
                p += coefficient(rounded->p_double, j) * pow(z, (double)j);
                q += coefficient(rounded->q_double, j) * pow(z, (double)j);
                l += coefficient(rounded->l_double, j) * pow(z, (double)j);
            }
            arb_set_d(beta, b);
            assert_int_equal(collision_solve(collision, beta, &law_sphere, 64), 0);
            const double eps =
                middle(r.end == COR_END_ZERO_FORCE ? collision->eps_zero_force : collision->eps_zero_overlap);
            worst = fmax(worst, fabs(p / q / eps - 1));
            worst_loss = fmax(worst_loss, fabs(b * l / q / (1 - eps) - 1));
        }
        assert_near(error->eps / worst, 1, 1e-6);
        assert_near(error->loss / worst_loss, 1, 1e-6);
    }
    references_clear(&s);
}
