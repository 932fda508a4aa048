/* SPDX-License-Identifier: MIT */
/* The largest force of a collision: limits, and two routes that must meet. test_contact.c integrates the force. */
#include "check.h"

#include "contact/contact_force.h"

static struct law law_named(const char *elastic, const char *damping)
{
    struct law law;
    assert_null(law_parse(&law, elastic, damping));
    return law;
}

static void close_to(const char *what, double computed, double reference, double error)
{
    check(fabs(computed / reference - 1) <= error, "%s: %.15g, not %.15g", what, computed, reference);
}

/* Hunt and Crossley's force by its first integral, x^(a+1) = (a+1) (f(beta) - f(beta v))/beta^2, at many speeds v */
static double crossley_force(double a, double beta)
{
    const double all = beta - log1p(beta);
    double most = 0;
    for (int i = 0; i <= 20000; i++) {
        const double z = beta * i / 20000;
        const double power = (a + 1) * (all - (z - log1p(z))) / (beta * beta);
        most = fmax(most, pow(fmax(power, 0), a / (a + 1)) * (1 + z));
    }
    return most;
}

static void forces(void **state)
{
    (void)state;
    const struct law linear = law_named("1", "0"), tsuji = law_named("3/2", "1/4"), crossley = law_named("3/2", "3/2");
    /* zeta = 0: an elastic collision */
    close_to("linear", contact_force_max(&linear, 0), 1, 1e-15);
    close_to("Tsuji", contact_force_max(&tsuji, 0), pow(1.25, 0.6), 1e-15);
    close_to("Hunt and Crossley", contact_force_max(&crossley, 0), pow(1.25, 0.6), 1e-15);
    close_to("sphere", contact_force_max(&law_sphere, 0), pow(1.25, 0.6), 1e-12);
    /* linear: exp(-zeta (3 phi - pi)/sin(phi)), phi = acos(zeta), up to zeta = 1/2, then the first moment's 2 zeta */
    for (double zeta = 0.01; zeta < 0.5; zeta += 0.01) {
        const double phi = acos(zeta);
        close_to("linear", contact_force_max(&linear, zeta), exp(-zeta * (3 * phi - 3.14159265358979323846) / sin(phi)),
                 1e-14);
    }
    close_to("linear", contact_force_max(&linear, 0.7), 1.4, 1e-15);
    /* both branches of Tsuji's, and the limit between them */
    const double middle = contact_force_max(&tsuji, 1);
    for (double gap = 1e-3; gap > 1e-15; gap /= 10)
        for (int sign = -1; sign <= 1; sign += 2)
            check(fabs(contact_force_max(&tsuji, 1 + sign * gap) / middle - 1) < 1.5 * gap + 4e-15, "gap %g: %.17g",
                  gap, contact_force_max(&tsuji, 1 + sign * gap));
    assert_true(contact_force_max(&tsuji, 1e8) > 1e6 && isfinite(contact_force_max(&tsuji, 1e8)));
    /* the integration, next to a closed form: (1, 0) and (3/2, 3/2) are limits of other exponents */
    const struct law near = law_named("3/2", "24/16");
    close_to("the same law", contact_force_max(&near, 3), contact_force_max(&crossley, 3), 1e-15);
    for (double beta = 0.05; beta < 100; beta *= 3)
        close_to("first integral", contact_force_max(&crossley, beta), crossley_force(1.5, beta), 1e-6);
    /* small and large damping of Hunt and Crossley's law: f(z) = z - ln(1 + z) for every size of z */
    close_to("small", contact_force_max(&crossley, 1e-9), pow(1.25, 0.6), 1e-8);
    close_to("both sides of 0.1", contact_force_max(&crossley, 0.1), contact_force_max(&crossley, nextafter(0.1, 1)),
             1e-14);
    assert_true(isnan(contact_force_max(&tsuji, -1)) && isnan(contact_force_max(&law_sphere, NAN)) &&
                isnan(contact_force_max(&crossley, INFINITY)));
    /* a sphere of strong damping: loading forgets the spring, F = beta^(2/3) max sqrt(X) V of X'' + sqrt(X) X' = 0,
     * V = 1 - (2/3) X^(3/2), so that F = beta^(2/3) (3/4) (3/8)^(1/3) */
    close_to("strong", contact_force_max(&law_sphere, 1e9), pow(1e9, 2.0 / 3) * 0.75 * cbrt(0.375), 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(forces)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
