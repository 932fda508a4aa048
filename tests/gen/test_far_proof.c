/* SPDX-License-Identifier: MIT */
/* Tests proofs for strong damping. Compares the enclosed functions with collisions, and the proofs of the stored
 * formulas for large beta with sampled errors. Wrong coefficients must make a proof fail. */
#include "ball.h"

#include "approximation/row_proof.h"
#include "enclosure/collision.h"
#include "generated/sphere_rows.h"
#include "support/local.h"

enum { BITS = 256 };

static struct far_proof proof;

static int make_proof(void **state)
{
    (void)state;
    return far_proof_init(&proof, NULL, INFINITY);
}

static int clear_proof(void **state)
{
    (void)state;
    far_proof_clear(&proof);
    return 0;
}

/* Encloses a quantity, without its power of beta, at one u. */
static void function_at(arb_t y, enum quantity quantity, double u)
{
    LOCAL(arb_poly, f);
    assert_true(far_proof_function(f, &proof, quantity, u, u));
    arb_poly_get_coeff_arb(y, f, 0);
}

/* The enclosures of the functions overlap enclosed collisions. The places are inside the intervals, at their ends, and
 * above the last interval, where 210 mu u^2 is below 2^-70. */
TEST(test_collisions)
{
    static const double places[] = {9.41, 12, 20.25, 37.99, 38, 44};
    enum { PLACES = sizeof places / sizeof *places };
    LOCAL(collision, c);
    LOCAL(arb, beta, y, exact);
    for (size_t k = 0; k < PLACES + points(4); k++) {
        const double u = k < PLACES ? places[k] : random_uniform(&draw, 9.5, k % 2 ? 38 : 14);
        arb_set_d(beta, u);
        arb_exp(beta, beta, 512);
        assert_int_equal(collision_solve_force(c, beta, &law_sphere, 110), 0);
        const struct {
            enum quantity quantity;
            arb_srcptr value;
            int power;
        } of[] = {{MAX_OVERLAP, c->x_max, 2},
                  {TIME_OF_MAX_OVERLAP, c->t_max, 2},
                  {EPS_ZERO_FORCE, c->eps_zero_force, 5},
                  {DURATION_ZERO_FORCE, c->t_zero_force, 2}};
        for (int i = 0; i < 4; i++) {
            const arb_srcptr value = of[i].value;
            const int power = of[i].power;
            LET(exact, 512, "value*beta^(power/3)", value, beta, power);
            function_at(y, of[i].quantity, u);
            assert_bits(y, 70);
            assert_overlap(y, exact, "function", i);
        }
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

static double factor_of(int k, double u)
{
    const double mu = exp(-5 * u / 3);
    const int power = k < 4 ? k / 2 : k < 7 ? k - 4 : k - 7;
    return pow(mu, k < 4 ? 0 : k < 7 ? 1 : 2) * pow(u, power);
}

static double formula_error(const struct formula *f, double at)
{
    LOCAL(arb, u, y, sum);
    arb_set_d(u, at);
    for (int k = 0; k < INTERPOLANT_FAR + 2; k++) {
        const int order = k < 4 ? 0 : k < 7 ? 1 : 2, power = k < 4 ? k / 2 : k < 7 ? k - 4 : k - 7;
        const double c = f->row(0)[k];
        LET(sum, BITS, "sum + c*exp(-5*order*u/3)*u^power", sum, c, order, u, power);
    }
    function_at(y, f->quantity, at);
    LET(sum, BITS, "sum/y - 1", sum, y);
    return fabs(middle(sum));
}

/* The proved bounds of the stored formulas equal the largest sampled errors or exceed them slightly. A coefficient that
 * changes the function by 2^-60 at u = 10 is detected; a normal run checks a quarter of the coefficients. */
TEST(test_formulas)
{
    for (int i = 0; i < FORMULAS; i++) {
        const struct formula *const f = &formulas[i];
        double c[INTERPOLANT_FAR + 2], worst = 0;
        memcpy(c, f->row(0), sizeof c);
        const double bits = far_proof_bits(&proof, f->quantity, c);
        for (double u = FAR_PROOF_FROM; u < FAR_PROOF_TO; u *= 1.003)
            worst = fmax(worst, formula_error(f, u));
        check(bits >= f->least_bits && bits <= -log2(worst) && bits >= -log2(worst) - 0.3,
              "quantity %d: %g bits proved, %g sampled", (int)f->quantity, bits, -log2(worst));
        for (int k = 0; k < INTERPOLANT_FAR + 2; k++) {
            if (!in_turn((size_t)k + (size_t)i, 4))
                continue;
            const double kept = c[k], value = c[0] + c[2] * FAR_PROOF_FROM;
            c[k] += (random_below(&draw, 2) ? 0x1p-50 : -0x1p-50) * value / factor_of(k, FAR_PROOF_FROM) *
                    (k == 0 || k == 2 ? 1 : 0x1p-10); /* smaller changes of the other coefficients are detected, too */
            check(far_proof_bits(&proof, f->quantity, c) < 61, "quantity %d is proved with a wrong coefficient %d",
                  (int)f->quantity, k);
            c[k] = kept;
        }
    }
}

/* Proves the inverse, whose error is the sum of the omitted terms at eps = 2^-23. Refuses a wrong coefficient. */
TEST(test_inverse)
{
    double c[INTERPOLANT_FAR_INVERSE + 1];
    memcpy(c, cor_rows_far_beta_zero_force(0), sizeof c);
    const double bits = far_proof_bits(&proof, BETA_ZERO_FORCE, c), e = 0x1p-23 / c[0], v = -0.6 * log(e);
    check(bits >= 55.5 && bits <= 57, "%g", bits);
    LOCAL(arb, eps); /* the inverse is used only where eps < 2^-23 */
    function_at(eps, EPS_ZERO_FORCE, FAR_PROOF_INVERSE_FROM);
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

/* The duration at zero overlap needs collisions that take seconds. Only long runs and `corgen tables` test it. */
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

/* Without anything to prove, the result is NaN. */
TEST(test_refused)
{
    double c[INTERPOLANT_FAR + 2] = {0};
    assert_true(isnan(far_proof_bits(&proof, EPS_ZERO_OVERLAP, c)));
    LOCAL(arb_poly, y);
    assert_false(far_proof_function(y, &proof, BETA_ZERO_OVERLAP, 10, 11));
    assert_false(far_proof_function(y, &proof, MAX_OVERLAP, 9.3, 9.5));
    assert_false(far_proof_function(y, &proof, MAX_OVERLAP, 19, 21));
}

GROUP(make_proof, clear_proof)
