/* SPDX-License-Identifier: MIT */
/* One enclosed Taylor step: its remainder bounds the true error, and every value includes the remainder. */
#include "ball.h"

#include "enclosure/taylor.h"
#include "support/local.h"

/* Starts a step. A constant force replaces the elastic one. */
static void taylor_start(struct taylor *y, const struct cor_exponents *law, slong degree, slong prec, const char *beta,
                         slong force)
{
    taylor_init(y, law, degree, prec);
    arb_set_str(y->c1, beta, 1000);
    arb_set_si(y->c2, force == 0);
    arb_set_si(y->c3, force);
    arb_one(y->v);
    taylor_expand(y);
    assert_true(taylor_choose_step(y));
}

/* The remainder bounds the error of a short polynomial relative to a long one, and is not much too large. */
TEST(test_remainder)
{
    static const char *const laws[][2] = {{"3/2", "1/2"}, {"1", "0"}, {"3/2", "3/2"}, {"2", "1/3"}};
    static const char *const betas[] = {"0.1", "1", "3", "0"}; /* 0: a constant force replaces the elastic force */
    const slong prec = 600;
    LOCAL(mag, missed, claimed);
    LOCAL(arb, rough, truth);
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++)
        for (size_t k = 0; k < sizeof betas / sizeof *betas; k++) {
            const struct cor_exponents given = law_of(laws[i][0], laws[i][1]), law = k < 3 ? given : law_even(&given);
            const slong force = k < 3 ? 0 : 5;
            struct taylor low, high;
            /* the step is chosen for 40 bits and computed with 600, so truncation is the only error */
            taylor_start(&low, &law, force ? 13 : 12, 40, betas[k], force);
            low.prec = prec;
            taylor_expand(&low);
            taylor_start(&high, &law, 220, prec, betas[k], force);
            assert_true(arb_le(low.step, high.step));
            for (int component = TAYLOR_W; component <= TAYLOR_T; component++) {
                const mag_srcptr errors[] = {low.error_w, low.error_v, low.error_t};
                mag_set(claimed, errors[component]);
                taylor_value(rough, &low, (enum taylor_component)component, low.step);
                assert_true(mag_cmp(arb_radref(rough), claimed) >= 0);
                taylor_value(truth, &high, (enum taylor_component)component, low.step);
                assert_overlap(rough, truth, "component", component);
                arb_get_mid_arb(rough, rough);
                arb_sub(rough, rough, truth, prec);
                arb_get_mag(missed, rough);
                assert_true(mag_cmp(missed, claimed) <= 0);
                /* the error may be far below its bound, because every second term may vanish */
                mag_mul_2exp_si(missed, missed, 60);
                assert_true(mag_is_zero(missed) || mag_cmp(missed, claimed) > 0 ||
                            (component == TAYLOR_T && law.denominator == 1));
            }
            taylor_clear(&low);
            taylor_clear(&high);
        }
}

/* One term of the linear oscillator is w = sigma, v = 1. The part omitted from v, 1 - cos(h), is below the bound. */
TEST(test_one_term)
{
    const struct cor_exponents law = law_of("1", "0");
    struct taylor y;
    LOCAL(arb, claimed);
    taylor_start(&y, &law, 1, 20, "0", 0);
    arf_set_mag(arb_midref(claimed), y.error_v);
    assert_true(HOLDS(60, "claimed > y.step^2/2*sinc(y.step/2)^2", claimed, y.step));
    assert_true(HOLDS(60, "claimed < 4*y.step^2", claimed, y.step));
    taylor_clear(&y);
}

/* Without forces w = h/d and v = 1, and only the time has an error, (h/d)^d. */
TEST(test_time_alone)
{
    const struct cor_exponents law = law_of("3/2", "1/3");
    struct taylor y;
    LOCAL(arb, claimed);
    taylor_init(&y, &law, 2, 40);
    arb_one(y.v);
    taylor_expand(&y);
    assert_true(taylor_choose_step(&y) && mag_is_zero(y.error_w) && mag_is_zero(y.error_v));
    arf_set_mag(arb_midref(claimed), y.error_t);
    assert_true(HOLDS(60, "claimed > (y.step/6)^6", claimed, y.step));
    taylor_clear(&y);
}

/* The solution of the linear oscillator is entire, but no step may span an undetected zero of the overlap. */
TEST(test_step_is_short)
{
    const struct cor_exponents law = law_of("1", "0");
    struct taylor y;
    taylor_start(&y, &law, 400, 60, "0.01", 0);
    assert_true(HOLDS(60, "y.step < pi", y.step));
    taylor_clear(&y);
}

/* Under a constant force the step h satisfies 2 L h < 3. The Lipschitz bound L exceeds sqrt(c3/2) under only the force,
 * and sqrt(2) near rest with c2 = c3 = 1. */
TEST(test_step_under_a_force)
{
    const struct cor_exponents linear = law_of("1", "0"), law = law_even(&linear);
    struct taylor y;
    taylor_start(&y, &law, 400, 60, "0", 1000);
    assert_true(HOLDS(60, "sqrt(2*y.c3)*y.step < 3", y.c3, y.step));
    arb_one(y.w);
    arb_one(y.c2);
    arb_one(y.c3);
    arb_set_d(y.v, 0x1p-40);
    taylor_expand(&y);
    assert_true(taylor_choose_step(&y));
    assert_true(HOLDS(60, "sqrt(8)*y.step < 3", y.step));
    taylor_clear(&y);
}

enum { ONLINE_PREC = 900, ONLINE_DEGREE = 310, ROUND_OFF_BITS = 16 };

/* product *= f, term by term */
static void multiply(arb_ptr product, arb_srcptr f)
{
    arb_ptr sum = _arb_vec_init(ONLINE_DEGREE + 1);
    for (slong n = 0; n <= ONLINE_DEGREE; n++)
        arb_dot(sum + n, NULL, 0, product, 1, f + n, -1, n + 1, ONLINE_PREC);
    _arb_vec_swap(product, sum, ONLINE_DEGREE + 1);
    _arb_vec_clear(sum, ONLINE_DEGREE + 1);
}

/* Long series are multiplied in blocks. The resulting series must satisfy v' = -w^(d-1) (c1 w^bd v + c2 w^ad), whose
 * products are computed term by term here. The laws need every kind of product. */
TEST(test_online_products)
{
    static const char *const laws[][2] = {{"3/2", "1/2"}, {"3/2", "3/4"}, {"1", "0"}};
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
        const struct cor_exponents law = law_of(laws[i][0], laws[i][1]);
        struct taylor y;
        LOCAL(arb, derivative, force);
        LOCAL(mag, step, power, round_off);
        taylor_start(&y, &law, ONLINE_DEGREE, ONLINE_PREC, "0.7", 0);
        arb_get_mag(step, y.step);
        arb_ptr elastic = _arb_vec_init(ONLINE_DEGREE + 1), damping = _arb_vec_init(ONLINE_DEGREE + 1);
        arb_one(elastic);
        _arb_vec_scalar_mul(damping, y.v, ONLINE_DEGREE + 1, y.c1, ONLINE_PREC);
        for (slong k = 0; k < law.denominator - 1 + law.elastic; k++)
            multiply(elastic, y.w);
        for (slong k = 0; k < law.denominator - 1 + law.damping; k++)
            multiply(damping, y.w);
        for (slong n = 0; n < ONLINE_DEGREE; n++) {
            arb_add(force, elastic + n, damping + n, ONLINE_PREC);
            arb_mul_si(derivative, y.v + n + 1, -(n + 1), ONLINE_PREC);
            assert_overlap(derivative, force, "coefficient", n);
            /* at the end of the longest step, each coefficient contributes only round-off */
            mag_pow_ui(power, step, (ulong)(n + 1));
            mag_mul(round_off, arb_radref(y.v + n + 1), power);
            assert_true(mag_cmp_2exp_si(round_off, ROUND_OFF_BITS - ONLINE_PREC) < 0);
        }
        _arb_vec_clear(elastic, ONLINE_DEGREE + 1);
        _arb_vec_clear(damping, ONLINE_DEGREE + 1);
        taylor_clear(&y);
    }
}

/* Proves a zero by opposite signs of the sum of all terms on its two sides. The zero of w = (1 - s)^3 is known to 2^-4
 * if w is known to 2^-12. A search with few bits must keep the last term of 1 - s + s^60/2^20, which moves the zero. */
TEST(test_zero)
{
    static const int cubic[] = {1, -3, 3, -1};
    const struct cor_exponents law = law_of("1", "0");
    LOCAL(arb, root, begin, end, x);
    for (int k = 1; k <= 40; k++)
        for (int flat = 0; flat < 2; flat++) {
            struct taylor y;
            taylor_init(&y, &law, 60, 128);
            for (int n = 0; n < (flat ? 4 : 2); n++)
                arb_set_si(y.w + n, flat ? cubic[n] : 1 - 2 * n);
            arb_set_si(y.w + 60, !flat);
            arb_mul_2exp_si(y.w + 60, y.w + 60, -20);
            mag_set_ui_2exp_si(y.error_w, (ulong)flat, -12);
            arb_set_d(end, 1 + (flat ? k + 1 : k / 16.0) / 16);
            assert_int_equal(taylor_crosses(root, &y, TAYLOR_W, begin, end), TAYLOR_CROSSED);
            if (flat) {
                arb_one(x);
                arb_add_error_2exp_si(x, -4);
                check(arb_contains(root, x), "the enclosure in [0, 1 + %d/16] leaves possible zeros out", k + 1);
            } else {
                LET(x, 200, "1 - root + root^60/2^20", root);
                check(arb_contains_zero(x), "the enclosure in [0, 1 + %d/256] leaves the zero out", k);
                assert_bits(root, 30);
            }
            taylor_clear(&y);
        }
}
