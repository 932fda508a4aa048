/* SPDX-License-Identifier: MIT */
/* Formulas give the results of Arb's functions, exactly if no ball occurs. Texts that are not formulas are refused. */
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "ball.h"
#include "support/formula.h"

enum { PREC = 128 };

/* Each formula at x = 1/3 as a ball and y = 5, and its value */
TEST(test_values)
{
    static const struct {
        const char *text, *value;
    } known[] = {{"1 - x - y", "-4.33333333333333333333333333333333333"},
                 {"y/2*x", "0.83333333333333333333333333333333333"},
                 {"-x^2 + 2^-1^2", "0.38888888888888888888888888888888889"},
                 {"2^3^2*(x + 1)", "682.66666666666666666666666666666667"},
                 {"sqrt(x)*x^(1/2)/x", "1"},
                 {"abs(x - 1)*max(x, y) - min(y, x)", "3"},
                 {"exp(log(x)) - expm1(log1p(x))", "0"},
                 {"acos(x - 1/3)*2/pi + acosh(y/5)", "1"},
                 {"gamma(x + 1/6)^2/pi", "1"},
                 {"x^y*3^y", "1"},
                 {"y^x*5^(2/3)", "5"},
                 {"(y/10)^10^40 + 1", "1"}};
    LOCAL(arb, x, z, value);
    arb_set_ui(x, 1);
    arb_div_ui(x, x, 3, PREC);
    const slong y = 5;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        LET(z, PREC, known[i].text, x, y);
        arb_set_str(value, known[i].value, PREC);
        arb_sub(value, value, z, PREC);
        arb_add_error_2exp_si(value, -100);
        if (!arb_contains_zero(value) || mag_cmp_2exp_si(arb_radref(value), -99) > 0)
            fail_msg("%s is not %s", known[i].text, known[i].value);
    }
}

TEST(test_operands)
{
    const struct ratio third = {1, 3};
    const struct {
        struct ratio b;
        int n[2];
    } s = {{1, 6}, {7, 9}}, *const p = &s;
    LOCAL(fmpq, q, expected);
    LOCAL(arb, x);
    fmpq_set_si(q, 2, 7);
    EXACT(q, "q*p->b/third - s.n[1]^(p->n[0] - 5)", q, third, p->b, s.n[1], p->n[0]);
    fmpq_set_si(expected, -566, 7);
    assert_true(fmpq_equal(q, expected));
    LET(x, 2, "q*7", q);
    assert_true(arb_equal_si(x, -566) == 0 && arb_contains_si(x, -566)); /* rounded exactly once */
    LET(x, PREC, "q*7", q);
    assert_true(arb_equal_si(x, -566));
    LET(x, PREC, "1/0");
    assert_false(arb_is_finite(x));
}

TEST(test_comparisons)
{
    LOCAL(arb, x);
    arb_set_ui(x, 2);
    assert_true(HOLDS(PREC, "x + 1 > 5/2", x));
    assert_false(HOLDS(PREC, "x + 1 < 5/2", x));
    assert_true(HOLDS(PREC, "1/2 < x", x));
    arb_add_error_2exp_si(x, 0);
    assert_false(HOLDS(PREC, "x > 3/2", x) || HOLDS(PREC, "x < 3/2", x)); /* the ball decides neither condition */
}

TEST(test_complex)
{
    LOCAL(acb, z, w, y);
    LOCAL(arb, x);
    acb_set_d_d(z, 0.5, 1);
    acb_set_d_d(w, 3, -0.25);
    arb_set_ui(x, 2);
    LET_COMPLEX(y, false, PREC, "sqrt(z^2 + x*z*w + w^2)/(z + w) - (z - w)^-1*(z - w)*x/2", z, x, w);
    assert_true(acb_contains_zero(y) && mag_cmp_2exp_si(arb_radref(acb_realref(y)), -100) < 0);
    acb_mul_onei(y, z);
    LET_COMPLEX(y, false, PREC, "(sinh(z)*2*exp(z) + 1)/exp(2*z) - sinc(y)*z/sinh(z) + sqrt(w)*w^(-x/4) - 1", z, w, x,
                y);
    assert_true(acb_contains_zero(y) && mag_cmp_2exp_si(arb_radref(acb_realref(y)), -100) < 0);
    for (int analytic = 0; analytic < 2; analytic++) { /* -4 +- i/8 contains a point of the cut */
        acb_set_si(y, -4);
        mag_set_ui_2exp_si(arb_radref(acb_imagref(y)), 1, -3);
        LET_COMPLEX(w, analytic == 1, PREC, "y^(-1/5)", y);
        LET_COMPLEX(y, analytic == 1, PREC, "sqrt(y)", y);
        assert_true(acb_is_finite(y) == (analytic == 0) && acb_is_finite(w) == (analytic == 0));
    }
}

static void ends(const char *text, int kind)
{
    const pid_t child = fork();
    if (child == 0) {
        LOCAL(arb, x);
        LOCAL(fmpq, q);
        LOCAL(acb, z);
        signal(SIGABRT, SIG_DFL);
        if (!freopen("/dev/null", "w", stderr))
            _exit(1);
        if (kind == 0)
            LET(x, PREC, text, x);
        else if (kind == 1)
            EXACT(q, text, q);
        else if (kind == 3)
            LET(x, PREC, text, z);
        else if (kind == 4)
            LET_COMPLEX(z, false, PREC, text, z);
        else
            _exit(HOLDS(PREC, text, x));
        _exit(0);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    if (!WIFSIGNALED(status) || WTERMSIG(status) != SIGABRT)
        fail_msg("%s was taken for a formula", text);
}

TEST(test_refusals)
{
    static const char *const text[] = {"",   "x +", "x 2",    "2x",     "1.5",       "y",
                                       "(x", "x)",  "sin(x)", "max(x)", "abs(x, x)", "x < 1"};
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        ends(text[i], 0);
    ends("q + pi", 1);
    ends("x", 2);
    ends("x < 1 < 2", 2);
    ends("z + 1", 3);
    ends("log(z)", 4);
    ends("max(z, z)", 4);
}
