/* SPDX-License-Identifier: MIT */
/* The proofs of eps for other laws. Enclosures at complex damping are compared with enclosed collisions on the real
 * axis, and with Cauchy's integrals off it. Polynomials are compared with collisions between their samples. Ellipses
 * that reach a singularity are refused. */
#include "ball.h"

#include <complex.h>

#include "approximation/ellipse_bound.h"
#include "approximation/law_layout.h"
#include "approximation/row_proof.h"
#include "enclosure/collision.h"
#include "enclosure/complex_law.h"
#include "random.h"
#include "support/enclosed_function.h"
#include "support/local.h"

enum way { WAY_OVERLAP, WAY_CREEP, WAY_FORCE, WAY_STRONG_FORCE };

static double exact_log_eps(const struct cor_exponents *law, double beta, enum way way)
{
    LOCAL(collision, c);
    LOCAL(arb, x);
    arb_set_d(x, beta);
    assert_int_equal(collision_solve(c, x, law, 60), 0);
    arb_log(x, way == WAY_OVERLAP || way == WAY_CREEP ? c->eps_zero_overlap : c->eps_zero_force, 60);
    return middle(x);
}

static bool enclose(struct complex_ball *y, const struct cor_exponents *law, struct complex_ball log_beta, enum way way)
{
    const bool strong = way == WAY_CREEP || way == WAY_STRONG_FORCE;
    const struct complex_law_pressing pressing = {{0, 0, 0}, {0, 0, 0}};
    const struct complex_law_path path = complex_law_path(law, 2 * exp(log_beta.re), strong);
    switch (way) {
    case WAY_OVERLAP:
        return complex_law_zero_overlap(y, law, ball_exp(log_beta), &pressing, &path);
    case WAY_CREEP:
        return complex_law_creep(y, law, log_beta, &path);
    case WAY_FORCE:
    case WAY_STRONG_FORCE:
        break;
    }
    return complex_law_zero_force(y, law, log_beta, &pressing, &path);
}

/* Every way to an end of contact, with weak and strong damping, for a > b, a = b and a < b */
static const struct {
    const char *elastic, *damping;
    enum way way;
    double beta;
} places[] = {
    {"3/2", "1/2", WAY_OVERLAP, 0.05}, {"3/2", "1/2", WAY_OVERLAP, 1.4},    {"3/2", "1/2", WAY_CREEP, 2.5},
    {"3/2", "1/2", WAY_CREEP, 9},      {"3/2", "1/2", WAY_FORCE, 0.1},      {"3/2", "1/2", WAY_STRONG_FORCE, 3},
    {"3/2", "0", WAY_OVERLAP, 0.1},    {"3/2", "0", WAY_OVERLAP, 0.8},      {"3/2", "0", WAY_FORCE, 0.005},
    {"3/2", "0", WAY_FORCE, 0.3},      {"3/2", "0", WAY_STRONG_FORCE, 1},   {"3/2", "0", WAY_STRONG_FORCE, 6},
    {"3/2", "3/2", WAY_OVERLAP, 0.3},  {"3/2", "3/2", WAY_OVERLAP, 3},      {"3/2", "3/2", WAY_CREEP, 5},
    {"1", "1/2", WAY_OVERLAP, 0.7},    {"1", "1/2", WAY_STRONG_FORCE, 2},   {"3/2", "1/3", WAY_OVERLAP, 0.4},
    {"1", "2", WAY_OVERLAP, 1.5},      {"2", "1/2", WAY_STRONG_FORCE, 0.9},
};
enum { PLACES = sizeof places / sizeof *places };

TEST(test_real_axis)
{
    for (size_t i = 0; i < PLACES; i++) {
        if (!in_turn(i, 2))
            continue;
        const struct cor_exponents law = law_of(places[i].elastic, places[i].damping);
        struct complex_ball y;
        check(enclose(&y, &law, ball_of(log(places[i].beta), 0), places[i].way), "place %zu: no enclosure", i);
        const double exact = exact_log_eps(&law, places[i].beta, places[i].way), off = fabs(y.re - exact);
        check(off <= y.radius && off < 1e-4 && fabs(y.im) <= y.radius, "place %zu: %g %+g i +- %g, not %g", i, y.re,
              y.im, y.radius, exact);
    }
}

/* By Cauchy's integral, the mean over a circle is the value at its centre, and the next moment gives the derivative.
 * Balls that cover the circle contain the values at its points. */
TEST(test_complex_plane)
{
    enum { POINTS = 16 };
    const double radius = 0.2, step = 0.01;
    for (size_t i = 0; i < PLACES; i++) {
        if (!in_turn(i, 4))
            continue;
        const struct cor_exponents law = law_of(places[i].elastic, places[i].damping);
        const double beta = places[i].beta, u = log(beta);
        const enum way way = places[i].way;
        double complex mean = 0, slope = 0;
        for (int k = 0; k < POINTS; k++) {
            const double complex way_out = cexp(2 * acos(-1.0) * I * k / (double)POINTS);
            const struct complex_ball at = ball_of(u + radius * creal(way_out), radius * cimag(way_out));
            struct complex_ball y, wide;
            check(enclose(&y, &law, at, way), "place %zu: no enclosure at point %d", i, k);
            mean += (y.re + I * y.im) / (double)POINTS;
            slope += (y.re + I * y.im) / way_out / radius / (double)POINTS;
            struct complex_ball beside = ball_widened(at, 0.004);
            beside.re += 0.003;
            check(enclose(&wide, &law, beside, way) &&
                      hypot(wide.re - y.re, wide.im - y.im) <= wide.radius + y.radius + 1e-4,
                  "place %zu: a ball about point %d does not contain it", i, k);
        }
        const double exact = exact_log_eps(&law, beta, way);
        const double below = exact_log_eps(&law, beta * exp(-step), way);
        const double above = exact_log_eps(&law, beta * exp(step), way), derivative = (above - below) / (2 * step);
        check(cabs(mean - exact) < 1e-3, "place %zu: the mean is %g %+g i, not %g", i, creal(mean), cimag(mean), exact);
        check(cabs(slope - derivative) < 3e-3 * (1 + fabs(derivative)), "place %zu: the slope is %g %+g i, not %g", i,
              creal(slope), cimag(slope), derivative);
    }
}

/* Above the dashpot's threshold beta_c = 1.128 the bodies never part: enclosures and ellipses are refused. */
TEST(test_singular)
{
    const struct cor_exponents law = law_of("3/2", "0");
    struct complex_ball y;
    assert_false(enclose(&y, &law, ball_of(log(1.2), 0), WAY_OVERLAP));
    assert_false(enclose(&y, &law, (struct complex_ball){log(1.05), 0, 0.1}, WAY_OVERLAP));
}

/* ---- polynomials ---- */

struct scene {
    const char *elastic, *damping;
    enum quantity eps;
    double beta_min, beta_max, wanted;
};

static double largest_error(const struct law_proof *proof, const struct cor_exponents *law, const struct scene *s)
{
    enum { COLLISIONS = 6 };
    const enum way way = s->eps == EPS_ZERO_OVERLAP ? WAY_OVERLAP : WAY_FORCE;
    double largest = 0;
    LOCAL(arb_poly, eps, log_beta);
    LOCAL(arb, t, y);
    for (int k = 0; k < COLLISIONS; k++) {
        const double beta = s->beta_min * pow(s->beta_max / s->beta_min, (k + 0.3) / (double)COLLISIONS);
        double end;
        const int i = law_proof_interval(&end, proof, log(beta));
        assert_true(i >= 0 && end > log(beta));
        /* the part of the interval above beta */
        assert_true(law_proof_eps(eps, log_beta, proof, i, log(beta), fmin(end, log(beta) + 0.1)));
        arb_set_si(t, -1);
        arb_poly_evaluate(y, eps, t, 200);
        arb_log(y, y, 200);
        const double found = middle(y), exact = exact_log_eps(law, beta, way);
        largest = fmax(largest, fabs(found - exact));
        check(fabs(found - exact) <= mag_get_d(arb_radref(y)) + 4e-15, "beta = %g: %.17g, not %.17g", beta, found,
              exact);
        check(mag_get_d(arb_radref(y)) > 0.5 * fmin(beta, 1) * proof->error[i], "beta = %g: a radius of %g", beta,
              mag_get_d(arb_radref(y)));
        check(mag_get_d(arb_radref(y)) < 3 * s->wanted, "beta = %g: a radius of %g", beta, mag_get_d(arb_radref(y)));
    }
    return largest;
}

/* Polynomials in beta, ln(beta) and ln(beta_c - beta) are within their proved errors at both ends. */
TEST(test_polynomials)
{
    static const struct scene scenes[] = {{"3/2", "0", EPS_ZERO_OVERLAP, 0.06, 0.5, 1e-9},
                                          {"3/2", "3/2", EPS_ZERO_OVERLAP, 0.01, 0.3, 1e-12},
                                          {"3/2", "0", EPS_ZERO_FORCE, 0.05, 0.3, 1e-9}};
    for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
        if (!in_turn(k, 3))
            continue;
        const struct scene *const s = &scenes[k];
        const struct cor_exponents law = law_of(s->elastic, s->damping);
        struct law_layout layout;
        assert_int_equal(law_layout_init(&layout, &law), 0);
        law_layout_restrict(&layout, s->eps, s->beta_min);
        struct interpolant *f = interpolant_new(&layout.interpolant, s->beta_min, s->beta_max);
        assert_non_null(f);
        struct law_proof *const proof = law_proof_new(f, s->eps, s->beta_min, s->beta_max, s->wanted);
        assert_non_null(proof);
        assert_true(largest_error(proof, &law, s) < s->wanted);
        /* well outside an interval there is no proof */
        LOCAL(arb_poly, eps, log_beta);
        double end;
        const int i = law_proof_interval(&end, proof, log(s->beta_max) - 0.01);
        assert_true(i >= 0);
        assert_false(law_proof_eps(eps, log_beta, proof, i, end, end + 0.1));
        law_proof_free(proof);
        interpolant_free(f);
        law_layout_clear(&layout);
    }
}

/* For a law without a threshold, the last interval contains samples of every quantity. */
TEST(tail)
{
    const struct cor_exponents law = law_of("3/2", "1/2");
    struct law_layout layout;
    assert_int_equal(law_layout_init(&layout, &law), 0);
    const struct interval *const last = &layout.interpolant.interval[layout.interpolant.intervals - 1];
    assert_true(last->form == FORM_POWER && last->hi == layout.last_log && last->set == SET_ALL);
    law_layout_clear(&layout);
}

/* Under a constant force, the path for speed v equals a collision with beta v^q and f v^(-2a/(a+1)). */
TEST(pressed)
{
    static const char *const laws[][2] = {{"3/2", "1/2"}, {"3/2", "0"}, {"3/2", "3/2"},
                                          {"2", "1"},     {"1", "1/2"}, {"5/4", "1"}};
    for (size_t i = 0; i < points(6); i++) {
        const struct cor_exponents law = law_of(laws[i % 6][0], laws[i % 6][1]);
        const double a = ratio_double(law_elastic(&law)), q = ratio_double(law_speed_exponent(&law));
        const double damping = random_uniform(&draw, 0.1, 0.3), v = random_uniform(&draw, 0.9, 1.2);
        LOCAL(arb, sticking, exact_damping);
        arb_set_d(exact_damping, damping);
        assert_int_equal(collision_sticking_force(sticking, exact_damping, &law, 0, 40), 0);
        const double press = middle(sticking) * random_uniform(&draw, 0.1, 0.7);
        const struct complex_law_pressing pressing = {ball_of(press, 0), {log(v), 0, 1e-6}};
        for (int force = 0; force < (law_force_ends(&law) ? 2 : 1); force++) {
            struct complex_law_path path = complex_law_path(&law, damping, false);
            struct complex_ball y;
            LOCAL(collision, c);
            LOCAL(arb, beta, f);
            path.resolution = 0.1;
            arb_set_d(beta, damping * pow(v, q));
            arb_set_d(f, press * pow(v, -2 * a / (a + 1)));
            assert_int_equal(collision_solve_pressed(c, beta, f, &law, force, 60), 0);
            arb_log(f, force ? c->eps_zero_force : c->eps_zero_overlap, 60);
            const double exact = middle(f);
            assert_true(force ? complex_law_zero_force(&y, &law, ball_of(log(damping), 0), &pressing, &path)
                              : complex_law_zero_overlap(&y, &law, ball_of(damping, 0), &pressing, &path));
            check(hypot(y.re - exact, y.im) <= y.radius && y.radius < 0.1 && fabs(y.re - exact) < 0.01,
                  "law %zu, beta %.17g, force %.17g, speed %.17g, end %d: %.6g, enclosed %.6g +- %.1e", i % 6, damping,
                  press, v, force, exact, y.re, y.radius);
        }
    }
}

/* For pressed contacts, the bound on an ellipse exceeds |ln(eps)| of collisions on the real axis. The interval has
 * several strips. */
TEST(test_pressed_ellipse)
{
    const struct cor_exponents law = law_of("3/2", "1/2");
    const double lo = log(0.3), hi = lo + 0.2, rho = 1.5, first_force = 0.3;
    const struct ratio power = interpolant_press_power(&law);
    const struct interval interval = {INTERVAL_LOG, lo, hi, 12, 60, FORM_LOG, 1u << EPS_ZERO_OVERLAP};
    struct ellipse_bound bound;
    double most = 0;
    LOCAL(collision, c);
    LOCAL(arb, press, beta, force, x);
    arb_set_d(press, first_force * exp(-lo * ratio_double(power)));
    const struct interpolant_layout layout = {
        .law = law, .root = 1, .interval = &interval, .intervals = 1, .press = press, .press_log = -10};
    struct interpolant *const f = interpolant_new(&layout, exp(lo), exp(hi));
    assert_non_null(f);
    assert_true(ellipse_bound_of_law(&bound, f, &interval, EPS_ZERO_OVERLAP, rho));
    for (int k = -1; k <= 1; k++) { /* the ends of the ellipse, and its middle */
        const double u = (lo + hi) / 2 + k * (hi - lo) / 4 * (rho + 1 / rho);
        arb_set_d(beta, exp(u));
        LET(force, 60, "press*beta^power", press, beta, power);
        assert_int_equal(collision_solve_pressed(c, beta, force, &law, 0, 40), 0);
        arb_log(x, c->eps_zero_overlap, 60);
        most = fmax(most, -middle(x));
    }
    check(most <= bound.modulus[EPS_ZERO_OVERLAP] && bound.modulus[EPS_ZERO_OVERLAP] < 1.3 * most,
          "%g bounds %g on the real axis", bound.modulus[EPS_ZERO_OVERLAP], most);
    interpolant_free(f);
}
