/* SPDX-License-Identifier: MIT */
/* Every double of generated/sphere_pade.h again, by another route than the generator's: the approximant from
 * Euclid's algorithm on the series instead of a linear system, the rounding by MPFR from the middle of the ball.
 * (The series has a second route of its own, in tests/gen/test_series.c.) */
#include "ball.h"

#include "series.h"
#include "sphere_pade.h"

static const slong BITS = 1200, PREC = 2600;

/* P/Q = f + O(z^(m+n+1)), Q(0) = 1: Euclid on z^(m+n+1) and f, stopped at the first remainder of degree <= m. */
static void euclid(arb_poly_t P, arb_poly_t Q, const arb_poly_t f, slong m, slong n)
{
    arb_poly_t r0, r1, t0, t1, quotient, rest;
    arb_t c;
    arb_poly_init(r0);
    arb_poly_init(r1);
    arb_poly_init(t0);
    arb_poly_init(t1);
    arb_poly_init(quotient);
    arb_poly_init(rest);
    arb_init(c);
    arb_poly_set_coeff_si(r0, m + n + 1, 1);
    arb_poly_set(r1, f);
    arb_poly_truncate(r1, m + n + 1);
    arb_poly_one(t1);
    while (arb_poly_degree(r1) > m) {
        assert_true(arb_poly_divrem(quotient, rest, r0, r1, PREC));
        arb_poly_swap(r0, r1);
        arb_poly_swap(r1, rest);
        arb_poly_mul(rest, quotient, t1, PREC);
        arb_poly_sub(rest, t0, rest, PREC);
        arb_poly_swap(t0, t1);
        arb_poly_swap(t1, rest);
    }
    assert_int_equal(arb_poly_degree(r1), m);
    assert_int_equal(arb_poly_degree(t1), n);
    arb_poly_get_coeff_arb(c, t1, 0);
    arb_poly_scalar_div(P, r1, c, PREC);
    arb_poly_scalar_div(Q, t1, c, PREC);
    arb_poly_clear(r0);
    arb_poly_clear(r1);
    arb_poly_clear(t0);
    arb_poly_clear(t1);
    arb_poly_clear(quotient);
    arb_poly_clear(rest);
    arb_clear(c);
}

static void assert_doubles(const arb_poly_t f, const double *table, slong length, const char *name)
{
    arb_t c;
    mpfr_t middle;
    arb_init(c);
    mpfr_init2(middle, PREC);
    assert_int_equal(arb_poly_degree(f), length - 1);
    for (slong i = 0; i < length; i++) {
        arb_poly_get_coeff_arb(c, f, i);
        if (!arb_is_exact(c))
            assert_bits(c, 80);
        arf_get_mpfr(middle, arb_midref(c), MPFR_RNDN);
        const double want = mpfr_get_d(middle, MPFR_RNDN);
        if (want != table[i])
            fail_msg("%s[%ld] is %a, not %a", name, (long)i, table[i], want);
    }
    arb_clear(c);
    mpfr_clear(middle);
}

static void check(enum contact_end end, const double *p, slong p_length, const double *q, slong q_length,
                  const double *l, slong l_length)
{
    arb_poly_t eps, P, Q;
    slong root;
    arb_poly_init(eps);
    arb_poly_init(P);
    arb_poly_init(Q);
    const slong m = p_length - 1, n = q_length - 1;
    assert_int_equal(series_eps(eps, &root, end, m + n, &law_sphere, BITS), 0);
    assert_int_equal(root, end == END_ZERO_FORCE ? 2 : 1);
    euclid(P, Q, eps, m, n);
    arb_poly_set_coeff_si(P, 0, 1);
    arb_poly_set_coeff_si(Q, 0, 1);
    assert_doubles(P, p, p_length, "p");
    assert_doubles(Q, q, q_length, "q");
    /* 1 - eps = beta L/Q, beta = z^root */
    arb_poly_sub(P, Q, P, PREC);
    arb_poly_shift_right(P, P, root);
    assert_doubles(P, l, l_length, "l");
    arb_poly_clear(eps);
    arb_poly_clear(P);
    arb_poly_clear(Q);
}

static void test_zero_overlap(void **state)
{
    (void)state;
    check(END_ZERO_OVERLAP, cor_sphere_pade_zero_overlap_p, COR_SPHERE_PADE_ZERO_OVERLAP_P,
          cor_sphere_pade_zero_overlap_q, COR_SPHERE_PADE_ZERO_OVERLAP_Q, cor_sphere_pade_zero_overlap_l,
          COR_SPHERE_PADE_ZERO_OVERLAP_L);
}

static void test_zero_force(void **state)
{
    (void)state;
    check(END_ZERO_FORCE, cor_sphere_pade_zero_force_p, COR_SPHERE_PADE_ZERO_FORCE_P, cor_sphere_pade_zero_force_q,
          COR_SPHERE_PADE_ZERO_FORCE_Q, cor_sphere_pade_zero_force_l, COR_SPHERE_PADE_ZERO_FORCE_L);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_zero_overlap),
        cmocka_unit_test(test_zero_force),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
