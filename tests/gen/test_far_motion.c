/* SPDX-License-Identifier: MIT */
/* Collisions at strong damping: Taylor models against numbers from their domain, the series in mu and ln(beta) against
 * enclosed collisions and closed forms, and the proofs of the stored formulas for large beta against sampled errors and
 * wrong coefficients. */
#include "ball.h"

#include "approximation/far_proof.h"
#include "enclosure/collision.h"
#include "generated/sphere_tables.h"
#include "support/local.h"

static struct random_state random_state;

enum { BITS = 256 };

/* ---- Taylor models ---- */

static const double smallest_a = 0x1p-7, smallest_b = 0x1p-6;

static void random_model(struct expansion *x, slong length)
{
    LOCAL(arb, c);
    LOCAL(mag, rest);
    expansion_zero(x);
    for (slong degree = 0; degree <= EXPANSION_ORDER; degree++)
        for (slong j = 0; j <= degree; j++)
            for (slong n = 0; n < length; n++) {
                arb_set_d(c, random_uniform(&random_state, -1, 1));
                arb_poly_set_coeff_arb(expansion_term(x, degree - j, j), n, c);
            }
    mag_set_d(rest, 1e-9);
    expansion_add_rest(x, rest);
}

/* The model at a point of its domain, with `share` of its rest */
static void value_at(arb_t y, struct expansion *x, double a, double b, const arb_t z, double share)
{
    LOCAL(arb, term);
    arf_set_mag(arb_midref(y), x->rest);
    mag_zero(arb_radref(y));
    LET(y, BITS, "y*share", y, share);
    for (slong degree = 0; degree <= EXPANSION_ORDER; degree++)
        for (slong j = 0; j <= degree; j++) {
            arb_poly_evaluate(term, expansion_term(x, degree - j, j), z, BITS);
            LET(y, BITS, "y + term*a^(degree - j)*b^j", y, term, a, degree, j, b);
        }
}

/* The model contains y at a point. */
static void assert_contains(struct expansion *x, double a, double b, const arb_t z, const arb_t y, const char *what)
{
    LOCAL(arb, value);
    value_at(value, x, a, b, z, 0);
    arb_add_error_mag(value, x->rest);
    check(arb_is_finite(value), "%s at %a, %a", what, a, b);
    assert_overlap(value, y, what, 0);
}

static struct expansion_domain domain_of(double a, double b)
{
    struct expansion_domain domain;
    mag_init(domain.a);
    mag_init(domain.b);
    mag_set_d(domain.a, a);
    mag_set_d(domain.b, b);
    return domain;
}

/* Products, powers and substituted models contain what the numbers give. */
TEST(test_models)
{
    const struct expansion_domain domain = domain_of(smallest_a, smallest_b),
                                  inner = domain_of(smallest_a, 4 * smallest_b);
    struct expansion x, y, z, tau, e;
    LOCAL(arb, at, other, f, g);
    expansion_init(&x, &domain);
    expansion_init(&y, &domain);
    expansion_init(&z, &domain);
    expansion_init(&tau, &domain);
    expansion_init(&e, &domain);
    for (size_t k = 0; k < points(12); k++) {
        const double corner = k % 4 == 0 ? 1 : random_uniform(&random_state, 0, 1);
        const double a = smallest_a * corner, b = smallest_b * (k % 2 ? corner : -corner);
        const double share = (double)(k % 3) - 1, more = (double)(k / 3 % 3) - 1;
        arb_set_d(at, k % 5 == 0 ? 1 : random_uniform(&random_state, 0, 1));
        random_model(&x, k % 8 == 0 ? 60 : 4);
        random_model(&y, k % 8 == 0 ? 50 : 3);
        value_at(f, &x, a, b, at, share);
        value_at(g, &y, a, b, at, more);
        arb_mul(f, f, g, BITS);
        expansion_multiply(&z, &x, &y);
        assert_contains(&z, a, b, at, f, "a product");

        const slong power = (slong)(k % 6);
        LET(f, BITS, "a^power*g", a, power, g);
        expansion_times_a(&z, &y, power);
        assert_contains(&z, a, b, at, f, "a product with a power of a");

        random_model(&x, 3);
        arb_poly_zero(expansion_term(&x, 0, 0));
        value_at(f, &x, a, b, at, share);
        LET(f, BITS, "(f + 1)^(-1/3)", f);
        expansion_power(&z, &x, -1, 3);
        assert_contains(&z, a, b, at, f, "a power");

        random_model(&tau, 1); /* 4 b_0 holds b and more */
        arb_poly_zero(expansion_term(&tau, 0, 0));
        random_model(&e, 1);
        arb_poly_zero(expansion_term(&e, 0, 0));
        random_model(&y, 9);
        y.domain = &inner;
        expansion_substitute(&z, &y, &tau, &e);
        value_at(f, &tau, a, b, at, share);
        value_at(other, &e, a, b, at, more);
        if (arf_sgn(arb_midref(other)) >= 0) { /* z >= 0 */
            value_at(g, &y, a, middle(f), other, 0);
            arb_add_error_2exp_si(g, -50); /* tau as a double */
            assert_contains(&z, a, b, at, g, "a model in a model");
        }
        y.domain = &domain;
    }
    /* tau outside, x with |x| >= 1 */
    y.domain = &inner;
    arb_set_ui(f, 5);
    expansion_zero(&tau);
    expansion_add_number(&tau, 0, 1, f);
    expansion_substitute(&z, &y, &tau, &e);
    assert_false(mag_is_finite(z.rest));
    y.domain = &domain;
    arb_set_ui(f, 128);
    expansion_zero(&x);
    expansion_add_number(&x, 1, 0, f);
    expansion_power(&z, &x, -1, 1);
    assert_false(mag_is_finite(z.rest));
    expansion_clear(&x);
    expansion_clear(&y);
    expansion_clear(&z);
    expansion_clear(&tau);
    expansion_clear(&e);
}

/* y = a + c b x^2 */
static void square_map(struct expansion *y, const struct expansion *x, void *context)
{
    struct expansion b;
    LOCAL(arb, one);
    expansion_init(&b, x->domain);
    expansion_add_number(&b, 0, 1, context);
    expansion_multiply(y, x, x);
    expansion_multiply(y, y, &b);
    arb_one(one);
    expansion_add_number(y, 1, 0, one);
    expansion_clear(&b);
}

/* x = a + b x^2 has the root 2 a/(1 + (1 - 4 a b)^(1/2)). A map that expands is refused. */
TEST(test_fixed_point)
{
    const struct expansion_domain domain = domain_of(smallest_a, smallest_b);
    struct expansion x;
    LOCAL(arb, c, exact, z);
    expansion_init(&x, &domain);
    arb_one(c);
    assert_true(expansion_fixed_point(&x, square_map, c));
    assert_true(mag_cmp_2exp_si(x.rest, -30) < 0); /* 2 a^3 b^2 is left out */
    LET(exact, BITS, "2*smallest_a/(1 + sqrt(1 - 4*smallest_a*smallest_b))", smallest_a, smallest_b);
    assert_contains(&x, smallest_a, smallest_b, z, exact, "a root");
    arb_set_ui(c, 1 << 14); /* no root at the corner */
    expansion_zero(&x);
    assert_false(expansion_fixed_point(&x, square_map, c));
    expansion_clear(&x);
}

/* ---- the series ---- */

static struct far_proof proof;

static int make_proof(void **state)
{
    (void)state;
    return far_proof_init(&proof, NULL);
}

static int clear_proof(void **state)
{
    (void)state;
    far_proof_clear(&proof);
    return 0;
}

enum { SERIES = 4 };

static struct far_series *series_of(int i)
{
    struct far_motion *const m = &proof.motion;
    struct far_series *const all[SERIES] = {&m->max_overlap, &m->time_of_max_overlap, &m->eps_zero_force,
                                            &m->duration_zero_force};
    return all[i];
}

/* The four quantities of a collision without their powers of beta */
static void scaled_collision(arb_ptr value, struct collision *c, const arb_t u)
{
    LOCAL(arb, beta);
    arb_exp(beta, u, 512);
    assert_int_equal(collision_solve_force(c, beta, &law_sphere, 110), 0);
    arb_struct *const field[SERIES] = {c->x_max, c->t_max, c->eps_zero_force, c->t_zero_force};
    for (int i = 0; i < SERIES; i++) {
        const int thirds = i == 2 ? 5 : 2;
        LET(value + i, 512, "field[i]*exp(thirds*u/3)", field[i], thirds, u);
    }
}

/* The series contain enclosed collisions, and do not if a coefficient of mu^3 is wrong in its tenth bit at 9.5. */
TEST(test_collisions)
{
    static const double places[] = {FAR_MOTION_LEAST_U, 10, 12, 14, 17, 30};
    enum { PLACES = sizeof places / sizeof *places };
    LOCAL(collision, c);
    arb_ptr exact = _arb_vec_init(SERIES);
    LOCAL(arb, u, y, kept);
    for (size_t k = 0; k < PLACES + points(6); k++) {
        arb_set_d(u, k < PLACES ? places[k] : random_uniform(&random_state, FAR_MOTION_LEAST_U, 14));
        scaled_collision(exact, c, u);
        for (int i = 0; i < SERIES; i++) {
            struct far_series *const s = series_of(i);
            far_series_value(y, s, u, BITS);
            assert_bits(y, 78);
            assert_overlap(y, exact + i, "series", i);
            if (k > 0)
                continue;
            for (slong j = 0; j < arb_poly_length(&s->order[3]); j++) {
                arb_struct *const wrong = arb_poly_get_coeff_ptr(&s->order[3], j);
                if (arb_contains_zero(wrong))
                    continue;
                arb_set(kept, wrong);
                LET(wrong, BITS, "wrong*(1 + 1/2^10)", wrong);
                far_series_value(y, s, u, BITS);
                if (arb_overlaps(y, exact + i) && j > 0)
                    fail_msg("series %d does not depend on coefficient %ld of mu^3", i, (long)j);
                arb_set(wrong, kept);
            }
        }
    }
    for (int i = 0; i < SERIES; i++) { /* (8.8) */
        const bool is_time = i % 2 == 1;
        assert_true(mag_get_d(series_of(i)->rest) <= (is_time ? 5.4e-24 : 1.7e-24));
        assert_true(mag_get_d(series_of(i)->rest_per_u) <= (is_time ? 2.4e-24 : 0));
    }
    arb_set_d(u, nextafter(FAR_MOTION_LEAST_U, 0));
    far_series_value(y, series_of(0), u, BITS);
    assert_false(arb_is_finite(y));
    _arb_vec_clear(exact, SERIES);
}

/* The rest of the model stands for what powers of z beyond its length give the coefficients, 2^-96 or so. */
static void assert_coefficient(int i, slong order, slong power, const arb_t exact, const char *what)
{
    LOCAL(arb, c);
    arb_poly_get_coeff_arb(c, &series_of(i)->order[order], power);
    arb_add_error_2exp_si(c, -88);
    assert_overlap(c, exact, what, i);
    assert_true(mag_cmp_2exp_si(arb_radref(c), -87) < 0);
}

/* The leading terms, and the highest logarithms that the drift alone explains */
TEST(test_closed_forms)
{
    LOCAL(arb, limit, rate, K, x);
    LET(limit, BITS, "(3/2)^(2/3)"); /* X* */
    LET(rate, BITS, "2*limit/3", limit);
    LET(K, BITS, "log(3)/2 - sqrt(3)*pi/6");
    for (int force = 0; force < 2; force++) {
        assert_coefficient(2 * force, 0, 0, limit, "limit of overlap and eps");
        LET(x, BITS, "rate*(K + log(3/limit*sqrt(limit)^force))", rate, K, limit, force);
        assert_coefficient(1 + 2 * force, 0, 0, x, "constant of the time");
        LET(x, BITS, "5*(1 + force)/3*rate", force, rate);
        assert_coefficient(1 + 2 * force, 0, 1, x, "slope of the time");
        /* X falls as X' = -mu X at first: by mu s X* = mu (5/3) u (2/3) X*^2, X*^3 = 9/4, and (25/36) (mu u)^2 next. */
        LET(x, BITS, "-2/3*limit^2*5*(1 + force)/3", limit, force);
        assert_coefficient(2 * force, 1, 1, x, "first drift");
        LET(x, BITS, "(5*(1 + force)/3)^2/4", force);
        assert_coefficient(2 * force, 2, 2, x, "second drift");
        for (slong order = 0; order <= EXPANSION_ORDER; order++)
            assert_true(arb_poly_length(&series_of(2 * force)->order[order]) <= order + 1);
    }
}

/* ---- the formulas of the tables ---- */

struct formula {
    enum quantity quantity;
    const double *(*row)(int);
    double least_bits;
};
static const struct formula formulas[] = {
    {MAX_OVERLAP, cor_rows_far_max_overlap, 70},
    {TIME_OF_MAX_OVERLAP, cor_rows_far_time_of_max_overlap, 70},
    {EPS_ZERO_FORCE, cor_rows_far_eps_zero_force, 64.5},
    {DURATION_ZERO_FORCE, cor_rows_far_duration_zero_force, 69},
};
enum { FORMULAS = sizeof formulas / sizeof *formulas };

/* What c_k is multiplied with at u */
static double factor_of(int k, double u)
{
    const double mu = exp(-5 * u / 3);
    const int power = k < 4 ? k / 2 : k < 7 ? k - 4 : k - 7;
    return pow(mu, k < 4 ? 0 : k < 7 ? 1 : 2) * pow(u, power);
}

/* The error of a formula, relative to the series, at u */
static double formula_error(const struct formula *f, int i, double at)
{
    LOCAL(arb, u, y, sum);
    arb_set_d(u, at);
    for (int k = 0; k < INTERPOLANT_FAR + 2; k++) {
        const int order = k < 4 ? 0 : k < 7 ? 1 : 2, power = k < 4 ? k / 2 : k < 7 ? k - 4 : k - 7;
        const double c = f->row(0)[k];
        LET(sum, BITS, "sum + c*exp(-5*order*u/3)*u^power", sum, c, order, u, power);
    }
    far_series_value(y, series_of(i), u, BITS);
    LET(sum, BITS, "sum/y - 1", sum, y);
    return fabs(middle(sum));
}

/* The proved bounds of the stored formulas are the largest sampled errors, or a little larger. Any wrong coefficient is
 * seen that changes the function by 2^-60 at u = 10; an ordinary run takes a quarter of them. */
TEST(test_formulas)
{
    for (int i = 0; i < FORMULAS; i++) {
        const struct formula *const f = &formulas[i];
        double c[INTERPOLANT_FAR + 2], worst = 0;
        memcpy(c, f->row(0), sizeof c);
        const double bits = far_proof_bits(&proof, f->quantity, c);
        for (double u = FAR_PROOF_FROM; u < FAR_PROOF_TO; u *= 1.003)
            worst = fmax(worst, formula_error(f, i, u));
        check(bits >= f->least_bits && bits <= -log2(worst) && bits >= -log2(worst) - 0.3,
              "quantity %d: %g bits proved, %g sampled", (int)f->quantity, bits, -log2(worst));
        for (int k = 0; k < INTERPOLANT_FAR + 2; k++) {
            if (!in_turn((size_t)k + (size_t)i, 4))
                continue;
            const double kept = c[k], value = c[0] + c[2] * FAR_PROOF_FROM;
            c[k] += (random_below(&random_state, 2) ? 0x1p-50 : -0x1p-50) * value / factor_of(k, FAR_PROOF_FROM) *
                    (k == 0 || k == 2 ? 1 : 0x1p-10); /* the heads have no smaller bits */
            check(far_proof_bits(&proof, f->quantity, c) < 61, "quantity %d is proved with a wrong coefficient %d",
                  (int)f->quantity, k);
            c[k] = kept;
        }
    }
}

/* The inverse, with right and wrong coefficients. Its error is that of the terms left out at eps = 2^-23. */
TEST(test_inverse)
{
    double c[INTERPOLANT_FAR_INVERSE + 1];
    memcpy(c, cor_rows_far_beta_zero_force(0), sizeof c);
    const double bits = far_proof_bits(&proof, BETA_ZERO_FORCE, c), e = 0x1p-23 / c[0], v = -0.6 * log(e);
    check(bits >= 55.5 && bits <= 57, "%g", bits);
    LOCAL(arb, u, eps); /* The inverse is used where eps < 2^-23 only. */
    arb_set_d(u, FAR_PROOF_INVERSE_FROM);
    far_series_value(eps, &proof.motion.eps_zero_force, u, BITS);
    assert_true(middle(eps) * exp(-5 * FAR_PROOF_INVERSE_FROM / 3) > 1.01 * 0x1p-23);
    for (int k = 0; k < INTERPOLANT_FAR_INVERSE + 1; k++) {
        if (!in_turn((size_t)k, 4))
            continue;
        const double kept = c[k], factor = k < 2 ? 0.6 / c[0] : k < 5 ? e * pow(v, k - 2) : e * e * pow(v, k - 5);
        c[k] += 0x1p-51 / factor;
        const double wrong = far_proof_bits(&proof, BETA_ZERO_FORCE, c);
        check(wrong < 51.5, "the inverse is proved to %g bits with a wrong coefficient %d", wrong, k);
        c[k] = kept;
    }
}

/* The duration at zero overlap needs collisions that take seconds: in a long run, and in `corgen tables`. */
TEST(test_duration)
{
    if (!few_or_all(0, 1))
        skip();
    struct interpolant *f = interpolant_new(&interpolant_sphere_proof, 6, 22000);
    struct interpolant_proof *rows = f ? interpolant_proof_new(f, SET_ALL, ELLIPSES_STATED) : NULL;
    assert_non_null(rows);
    proof.rows = rows;
    double c[INTERPOLANT_FAR + 2];
    memcpy(c, cor_rows_far_duration_zero_overlap(0), sizeof c);
    const double bits = far_proof_bits(&proof, DURATION_ZERO_OVERLAP, c);
    check(bits >= 70, "%g bits proved of the duration at zero overlap", bits);
    for (int k = 0; k < INTERPOLANT_FAR + 2; k++) {
        const double kept = c[k], value = c[0] + c[2] * FAR_PROOF_FROM;
        c[k] += 0x1p-50 * value / factor_of(k, FAR_PROOF_FROM);
        check(far_proof_bits(&proof, DURATION_ZERO_OVERLAP, c) < 51,
              "the duration at zero overlap is proved with a wrong coefficient %d", k);
        c[k] = kept;
    }
    interpolant_proof_free(rows);
    interpolant_free(f);
    proof.rows = NULL;
}

/* Where there is nothing to prove, the answer is NaN. */
TEST(test_refused)
{
    double c[INTERPOLANT_FAR + 2] = {0};
    assert_true(isnan(far_proof_bits(&proof, EPS_ZERO_OVERLAP, c)));
    LOCAL(arb_poly, y);
    assert_false(far_proof_function(y, &proof, BETA_ZERO_OVERLAP, 10, 11));
    assert_true(far_proof_function(y, &proof, MAX_OVERLAP, FAR_MOTION_LEAST_U - 1, 11));
    assert_false(arb_is_finite(arb_poly_get_coeff_ptr(y, 0)));
}

int main(void)
{
    random_state = random_start();
    const struct CMUnitTest tests[] = {test_models,   test_fixed_point, test_collisions, test_closed_forms,
                                       test_formulas, test_inverse,     test_duration,   test_refused};
    return cmocka_run_group_tests(tests, make_proof, clear_proof);
}
