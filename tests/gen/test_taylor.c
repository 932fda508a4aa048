/* SPDX-License-Identifier: MIT */
/* One enclosed Taylor step: its remainder against the truth, and that no value leaves it out. */
#include "ball.h"

#include "enclosure/taylor.h"

static void taylor_start(struct taylor *y, const struct law *law, slong degree, slong prec, const char *beta)
{
    taylor_init(y, law, 1, degree, prec);
    arb_set_str(y->c1, beta, 600);
    arb_one(y->c2);
    arb_one(y->v);
    taylor_expand(y);
    assert_true(taylor_choose_step(y));
}

/* A short polynomial misses the truth, by a long one, by less than its remainder says; and the remainder is not
 * absurd. */
static void test_remainder(void **state)
{
    (void)state;
    static const char *const laws[][2] = {{"3/2", "1/2"}, {"1", "0"}, {"3/2", "3/2"}, {"2", "1/3"}};
    static const char *const betas[] = {"0.1", "1", "3"};
    const slong prec = 600;
    mag_t missed, claimed;
    arb_t rough, truth;
    mag_init(missed);
    mag_init(claimed);
    arb_init(rough);
    arb_init(truth);
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++)
        for (size_t k = 0; k < sizeof betas / sizeof *betas; k++) {
            struct law law;
            struct taylor low, high;
            assert_null(law_parse(&law, laws[i][0], laws[i][1]));
            /* 40 bits decide the step, 600 the arithmetic: what is missed is truncation alone. */
            taylor_start(&low, &law, 12, 40, betas[k]);
            low.prec = prec;
            taylor_expand(&low);
            taylor_start(&high, &law, 220, prec, betas[k]);
            assert_true(arb_le(low.step, high.step));
            for (int component = TAYLOR_W; component <= TAYLOR_V; component++) {
                mag_set(claimed, component == TAYLOR_W ? low.error_w : low.error_v);
                taylor_value(rough, &low, (enum taylor_component)component, 0, low.step);
                assert_true(mag_cmp(arb_radref(rough), claimed) >= 0);
                taylor_value(truth, &high, (enum taylor_component)component, 0, low.step);
                assert_overlap(rough, truth, "component", component);
                arb_get_mid_arb(rough, rough);
                arb_sub(rough, rough, truth, prec);
                arb_get_mag(missed, rough);
                assert_true(mag_cmp(missed, claimed) <= 0);
                /* Odd and even powers alternate, so some of the next terms vanish: 2^60 is room for that. */
                mag_mul_2exp_si(missed, missed, 60);
                assert_true(mag_is_zero(missed) || mag_cmp(missed, claimed) > 0);
            }
            taylor_clear(&low);
            taylor_clear(&high);
        }
    mag_clear(missed);
    mag_clear(claimed);
    arb_clear(rough);
    arb_clear(truth);
}

/* The remainder of a power series in beta is shared out by its weight: 2^l for coefficient l at weight 1/2. */
static void test_jets(void **state)
{
    (void)state;
    struct taylor y;
    arb_t value;
    mag_t share;
    arb_init(value);
    mag_init(share);
    taylor_init(&y, &law_sphere, 4, 40, 100);
    mag_set_ui_2exp_si(y.weight, 1, -1);
    arb_one(y.c1 + 1);
    arb_one(y.c2);
    arb_one(y.v);
    taylor_expand(&y);
    assert_true(taylor_choose_step(&y));
    for (slong l = 0; l < 4; l++) {
        taylor_value(value, &y, TAYLOR_V, l, y.step);
        mag_mul_2exp_si(share, y.error_v, l);
        assert_true(mag_cmp(arb_radref(value), share) >= 0);
    }
    taylor_clear(&y);
    arb_clear(value);
    mag_clear(share);
}

/* A step of the linear oscillator, entire as its solution is, never spans a zero of the overlap unseen. */
static void test_step_is_short(void **state)
{
    (void)state;
    struct law law;
    struct taylor y;
    arb_t half_period;
    arb_init(half_period);
    assert_null(law_parse(&law, "1", "0"));
    taylor_start(&y, &law, 400, 60, "0.01");
    arb_const_pi(half_period, 60);
    assert_true(arb_lt(y.step, half_period));
    taylor_clear(&y);
    arb_clear(half_period);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_remainder),
        cmocka_unit_test(test_jets),
        cmocka_unit_test(test_step_is_short),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
