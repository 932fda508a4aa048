/* SPDX-License-Identifier: MIT */
/* Tests J(nu): known values, two methods, and the bound on an ellipse that gives the error of the table. */
#include "ball.h"

#include "enclosure/closed_form.h"
#include "support/local.h"
#include "tables/files.h"

static void set_tau(acb_t tau, const char *nu, slong prec)
{
    LOCAL(arb, x);
    arb_set_str(x, nu, prec);
    acb_zero(tau);
    LET(acb_realref(tau), prec, "sqrt(1 - 2*x)", x);
}

/* Miller and Pursey's half-space: J from two contours that agree to 30 digits */
TEST(known_values)
{
    static const struct {
        const char *nu, *j;
    } known[] = {{"0.25", "0.930752601914437910 +/- 6e-19"}, {"0.3", "0.862223129240137236 +/- 6e-19"}};
    LOCAL(acb, tau, j);
    LOCAL(arb, exact);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        set_tau(tau, known[i].nu, 128);
        wave_factor(j, tau, 100);
        arb_set_str(exact, known[i].j, 100);
        assert_true(arb_overlaps(acb_realref(j), exact) && arb_rel_accuracy_bits(acb_realref(j)) > 60);
    }
}

TEST(two_routes)
{
    static const char *const nu[] = {"-0.9", "-0.4", "0.1", "0.2", "0.33", "0.45"};
    LOCAL(acb, tau, axis, path);
    for (size_t i = 0; i < sizeof nu / sizeof *nu; i++) {
        set_tau(tau, nu[i], 100);
        wave_factor_by(axis, WAVE_BY_AXIS, tau, 60);
        wave_factor_by(path, WAVE_BY_PATH, tau, 60);
        check(arb_overlaps(acb_realref(axis), acb_realref(path)), "nu = %s", nu[i]);
        assert_true(arb_rel_accuracy_bits(acb_realref(axis)) > 40 && arb_rel_accuracy_bits(acb_realref(path)) > 40);
    }
}

/* Encloses tau on the ellipse, at pi times `angle` from its right end. */
static void on_ellipse(acb_t tau, double angle, double radius)
{
    LOCAL(acb, w);
    arb_set_d(acb_realref(w), angle);
    mag_set_d(arb_radref(acb_realref(w)), radius);
    acb_exp_pi_i(w, w, 53);
    LET_COMPLEX(tau, false, 53, "7/8*(1 + (3/2*w + 2/(3*w))/2)", w); /* WAVE_ELLIPSE */
}

/* True if either route proves |J| < bound. */
static bool is_below(const acb_t tau, double bound)
{
    LOCAL(acb, j);
    LOCAL(mag, size);
    bool holds = false;
    for (int route = WAVE_BY_PATH; route >= WAVE_BY_AXIS && !holds; route--) {
        wave_factor_by(j, (enum wave_route)route, tau, 8);
        acb_get_mag(size, j);
        holds = acb_is_finite(j) && mag_get_d(size) < bound;
    }
    return holds;
}

/* True if |J| < bound is proved on the arc, or on both of its halves. */
static bool arc_holds(double angle, double radius, int depth)
{
    LOCAL(acb, tau);
    on_ellipse(tau, angle, radius);
    return is_below(tau, WAVE_ELLIPSE_BOUND) || (depth < 12 && arc_holds(angle - radius / 2, radius / 2, depth + 1) &&
                                                 arc_holds(angle + radius / 2, radius / 2, depth + 1));
}

/* J is real on the real axis, so the upper half is enough. COR_TEST_MULTIPLIER=160 tests all arcs and the whole
 * inside, in some minutes. */
TEST(bound_on_the_ellipse)
{
    assert_true(WAVE_ELLIPSE == 1.5 && WAVE_TAU_END == 1.75);
    enum { ARCS = 400 };
    const size_t wanted = points(8), step = wanted < ARCS ? ARCS / wanted : 1;
    for (size_t k = 0; k < ARCS; k += step)
        check(arc_holds(((double)k + 0.5) / (double)ARCS, 0.5 / (double)ARCS * (1 + 1e-12), 0), "arc %zu", k);
}

/* True if the square around (x, y) with half side h is outside the ellipse, whose axes are known. */
static bool is_outside(double x, double y, double h)
{
    const double a = 0.875 * (1.5 + 1 / 1.5) / 2, b = 0.875 * (1.5 - 1 / 1.5) / 2;
    const double dx = fmax(0, fabs(x - 0.875) - h) / a, dy = fmax(0, fabs(y) - h) / b;
    return dx * dx + dy * dy > 1;
}

/* True if J is analytic on the square: one of the routes encloses it there, or on its quarters. */
static bool square_holds(double x, double y, double h, int depth)
{
    if (is_outside(x, y, h))
        return true;
    LOCAL(acb, tau);
    acb_set_d_d(tau, x, y);
    mag_set_d(arb_radref(acb_realref(tau)), h * (1 + 1e-9));
    mag_set_d(arb_radref(acb_imagref(tau)), h * (1 + 1e-9));
    const bool holds = is_below(tau, HUGE_VAL);
    for (int k = 0; k < 4 && !holds && depth < 8; k++)
        if (!square_holds(x + (k % 2 ? h : -h) / 2, y + (k / 2 ? h : -h) / 2, h / 2, depth + 1))
            return false;
    return holds || depth < 8;
}

TEST(analytic_inside)
{
    const size_t wanted = points(2);
    size_t count = 0;
    const double h = 0.02;
    for (double x = -0.1; x < 1.9; x += 2 * h) {
        for (double y = 0; y < 0.42; y += 2 * h, count++)
            if (wanted >= 320 || count % (550 / wanted) == 0)
                check(square_holds(x, y, h, 0), "around %g + %g i", x, y);
    }
}

static int clean(void **state)
{
    (void)state;
    flint_cleanup();
    return 0;
}

GROUP(NULL, clean)
