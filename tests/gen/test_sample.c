/* SPDX-License-Identifier: MIT */
/* Tests corgen sample: the tolerance holds, the errors of all segments are equal, and one point fewer is not enough. An
 * exhaustive search over a grid finds no smaller table. */
#include "scene.h"

#include "contact/sample.h"
#include "cor/law.h"
#include "embed/own_law.h"
#include "embed/request.h"

/* Returns a contact with unknown mass and stiffness. */
static struct cor_scene_contact contact_of(struct cor_exponents law, int way, double damping)
{
    struct cor_scene_contact contact = {
        .law = law, .mass_kg = NAN, .stiffness = NAN, .radius_m = NAN, .solver = contact_enclosed};
    assert_int_equal(cor_scene_set_damping(&contact, way, damping, 1, 0), 0);
    return contact;
}

static struct cor_scene_contact sphere_of(double g_star)
{
    return contact_of(cor_law_exponents[COR_LAW_VISCOELASTIC], COR_SCENE_G_STAR, g_star);
}

static double eps_at(const struct sample_request *r, double speed)
{
    return r->own ? own_law_value(r->own, speed) : scene_eps(r->contact, speed, (int)r->end);
}

static double place(const struct sample_request *r, double speed)
{
    return r->log ? log(speed) : speed;
}

/* Returns d eps/d place by a difference of order 4 with a step in ln(speed). */
static double slope_at(const struct sample_request *r, double speed, double h)
{
    const double d = 8 * (eps_at(r, speed * exp(h)) - eps_at(r, speed * exp(-h))) -
                     (eps_at(r, speed * exp(2 * h)) - eps_at(r, speed * exp(-2 * h)));
    return d / (12 * h) / (r->log ? 1 : speed);
}

/* Returns the largest relative error between two speeds, at evenly spaced places. */
static double error_between(const struct sample_request *r, double low, double high, int places)
{
    const double x0 = place(r, low), x1 = place(r, high), y0 = eps_at(r, low), y1 = eps_at(r, high), w = x1 - x0;
    const double s0 = r->cubic ? slope_at(r, low, 1e-3) : 0, s1 = r->cubic ? slope_at(r, high, 1e-3) : 0;
    double most = 0;
    for (int i = 1; i < places; i++) {
        const double t = (double)i / places, x = x0 + t * w, u = 1 - t;
        const double y =
            r->cubic ? (1 + 2 * t) * u * u * y0 + t * u * u * w * s0 + t * t * (3 - 2 * t) * y1 - t * t * u * w * s1
                     : y0 + t * (y1 - y0);
        most = fmax(most, fabs(y / eps_at(r, r->log ? exp(x) : x) - 1));
    }
    return most;
}

static void check_sample(const struct sample_request *r)
{
    struct sample s;
    assert_int_equal(sample_choose(&s, r), 0);
    double errors[2000], most = 0;
    int unequal = 0;
    assert_true(s.best.count < 2000);
    assert_true(s.best.speed_m_s[0] == r->speed_min && s.best.speed_m_s[s.best.count - 1] == r->speed_max);
    for (size_t i = 0; i + 1 < s.best.count; i++) {
        errors[i] = error_between(r, s.best.speed_m_s[i], s.best.speed_m_s[i + 1], 100);
        assert_true(s.best.value[0][i] == eps_at(r, s.best.speed_m_s[i]));
        most = fmax(most, errors[i]);
    }
    check(most <= r->tolerance, "error %g beyond %g with %zu points", most, r->tolerance, s.best.count);
    check(fabs(most / s.best.error - 1) < 1e-3, "error %g, said to be %g", most, s.best.error);
    /* the grid is fine enough to show that the reported error is not too small */
    double fine = 0;
    for (size_t i = 0; i + 1 < s.best.count; i++)
        if (errors[i] > most * (1 - 1e-3))
            fine = fmax(fine, error_between(r, s.best.speed_m_s[i], s.best.speed_m_s[i + 1], 3000));
    check(s.best.error <= r->tolerance, "error %.9g beyond %g", s.best.error, r->tolerance);
    check(fine <= s.best.error * (1 + 2e-6), "error %.9g, said to be %.9g", fine, s.best.error);
    /* where the curvature changes its sign, a segment may have a smaller error than its neighbours */
    for (size_t i = 0; i + 1 < s.best.count; i++)
        unequal += errors[i] < 0.98 * most;
    check(unequal <= 2, "%d of %zu errors are not the largest", unequal, s.best.count - 1);
    check(s.error_of_fewer > r->tolerance, "one point fewer has %g", s.error_of_fewer);
    check(s.even.count == s.best.count && s.even.error >= s.best.error, "evenly spaced: %g", s.even.error);
    sample_clear(&s);
}

TEST(tolerances_hold)
{
    const struct cor_scene_contact contact = sphere_of(0.2);
    for (int end = 0; end < COR_SCENE_ENDS; end++)
        for (int kind = 0; kind < 4; kind++) {
            const bool cubic = kind / 2, log = kind % 2;
            if (!in_turn((size_t)end + (size_t)kind, 2)) /* test only one end for each kind of table */
                continue;
            const double finest = (double)few_or_all(500, 1) * (cubic ? 1e-7 : 1e-6);
            for (double tolerance = 1e-2; tolerance > finest; tolerance /= 50)
                check_sample(&(struct sample_request){.contact = &contact,
                                                      .end = (enum cor_end)end,
                                                      .speed_min = 0.01,
                                                      .speed_max = 10,
                                                      .tolerance = tolerance,
                                                      .log = log,
                                                      .cubic = cubic});
        }
}

/* The power law min(1, v^-1/4), which has a kink at 1 m/s */
TEST(kink)
{
    static const struct cor_scene_contact none;
    static const double kink = 1;
    static const struct own_law own = {.law = EMBED_LAW_POWER, .real = {1, 0.25}, .part = &kink, .parts = 1};
    for (double tolerance = 0.05; tolerance > 1e-4; tolerance /= 7)
        for (int log = 0; log < 2; log++)
            check_sample(&(struct sample_request){
                .contact = &none, .own = &own, .speed_min = 0.1, .speed_max = 7, .tolerance = tolerance, .log = log});
}

/* ---- an exhaustive search ---- */

/* On a parabola, the largest of GRID_PLACES sampled errors is too small by at most 4e-4, relatively. */
enum { GRID = 60, GRID_PLACES = 48 };

/* Returns the least number of segments with points on a grid over the range; a large number if the grid is too
 * coarse. */
static int fewest_on_grid(const struct sample_request *r, double tolerance)
{
    int best[GRID];
    double speed[GRID];
    for (int i = 0; i < GRID; i++)
        speed[i] = r->speed_min * pow(r->speed_max / r->speed_min, (double)i / (GRID - 1));
    best[0] = 0;
    for (int k = 1; k < GRID; k++) {
        best[k] = GRID;
        for (int i = 0; i < k; i++)
            if (best[i] + 1 < best[k] && error_between(r, speed[i], speed[k], GRID_PLACES) <= tolerance)
                best[k] = best[i] + 1;
    }
    return best[GRID - 1] < GRID ? best[GRID - 1] : SAMPLE_MOST_POINTS;
}

TEST(no_smaller_table)
{
    for (int turn = 0; turn < (int)few_or_all(3, 40); turn++) {
        const struct cor_scene_contact contact = sphere_of(random_log(&draw, 0.01, 1e4));
        struct sample_request r = {.contact = &contact,
                                   .end = (enum cor_end)(turn % 2),
                                   .speed_min = 1e-3,
                                   .speed_max = random_log(&draw, 0.1, 100),
                                   .tolerance = random_log(&draw, 1e-3, 3e-2),
                                   .log = turn % 3 != 0};
        struct sample s;
        assert_int_equal(sample_choose(&s, &r), 0);
        /* eps is convex in the speed, but has an inflection in ln(speed). A segment across the inflection may be longer
         * and still have a smaller error, so the result may have one segment too many. */
        const int segments = (int)s.best.count - 1, more = r.log ? 1 : 0;
        check(segments <= fewest_on_grid(&r, r.tolerance) + more, "%d segments, the grid needs %d", segments,
              fewest_on_grid(&r, r.tolerance));
        /* with one point fewer, freely placed points are at least as good as points on the grid */
        if (isfinite(s.error_of_fewer))
            check(fewest_on_grid(&r, s.error_of_fewer * 0.999) + more > segments - 1,
                  "the grid needs fewer than %d segments for %g", segments - 1, s.error_of_fewer);
        /* with error_of_fewer as the tolerance, one point fewer is enough */
        struct sample fewer;
        r.tolerance = s.error_of_fewer * (1 + 1e-4);
        if (isfinite(s.error_of_fewer)) {
            assert_int_equal(sample_choose(&fewer, &r), 0);
            check(fewer.best.count < s.best.count, "%zu points have %g", fewer.best.count, r.tolerance);
            sample_clear(&fewer);
            /* a tolerance slightly below error_of_fewer is still met */
            r.tolerance = s.error_of_fewer * (1 - 1e-6);
            assert_int_equal(sample_choose(&fewer, &r), 0);
            check(fewer.best.error <= r.tolerance, "error %.9g beyond %.9g", fewer.best.error, r.tolerance);
            sample_clear(&fewer);
        }
        check(s.even.error >= s.best.error, "evenly spaced: %g, not %g", s.even.error, s.best.error);
        sample_clear(&s);
    }
}

/* Durations of a law that needs enclosed collisions. A constant eps, for which two points are enough. */
TEST(other_laws)
{
    struct cor_scene_contact contact = contact_of((struct cor_exponents){2, 1, 1}, COR_SCENE_G_STAR, 0.3);
    contact.mass_kg = 1e-3;
    contact.stiffness = 1e6;
    const struct sample_request r = {
        .contact = &contact, .speed_min = 0.1, .speed_max = 1, .tolerance = 1e-3, .duration = true};
    struct sample s;
    assert_int_equal(sample_choose(&s, &r), 0);
    for (size_t i = 0; i < s.best.count; i += 5) {
        const struct cor_scene_impact impact = scene_impact(&contact, s.best.speed_m_s[i]);
        assert_true(fabs(s.best.value[0][i] / impact.eps[0] - 1) < 1e-12);
        assert_true(fabs(s.best.value[1][i] / impact.duration_s[0] - 1) < 1e-12);
    }
    assert_true(s.best.error <= 1e-3 && s.error_of_fewer > 1e-3);
    sample_clear(&s);
    /* many decades of speed, which need several polynomials */
    for (double speed_min = 1e-2; speed_min > 1e-10; speed_min /= (double)few_or_all(2700, 30)) {
        const struct sample_request wide = {
            .contact = &contact, .speed_min = speed_min, .speed_max = 1, .tolerance = 1e-2, .log = true};
        assert_int_equal(sample_choose(&s, &wide), 0);
        for (size_t i = 0; i < s.best.count; i++)
            check(fabs(s.best.value[0][i] / eps_at(&wide, s.best.speed_m_s[i]) - 1) < 1e-12, "eps at %g m/s",
                  s.best.speed_m_s[i]);
        sample_clear(&s);
    }
    /* slopes at the ends of a narrow range need values outside it */
    const struct sample_request narrow = {
        .contact = &contact, .speed_min = 0.5, .speed_max = 0.501, .tolerance = 1e-3, .cubic = true};
    assert_int_equal(sample_choose(&s, &narrow), 0);
    for (size_t i = 0; i < s.best.count; i++)
        check(fabs(s.best.slope[0][i] / slope_at(&narrow, s.best.speed_m_s[i], 1e-3) - 1) < 1e-8, "slope at %g m/s",
              s.best.speed_m_s[i]);
    sample_clear(&s);

    contact = contact_of(cor_law_exponents[COR_LAW_LINEAR], COR_SCENE_ZETA, 0.3);
    const struct sample_request constant = {.contact = &contact, .speed_min = 0.1, .speed_max = 1, .tolerance = 1e-3};
    assert_int_equal(sample_choose(&s, &constant), 0);
    assert_true(s.best.count == 2 && s.best.error < 1e-15);
    sample_clear(&s);
}

/* The range begins close to the onset of yield, where the second derivative of eps jumps. The differences for the
 * slopes must not cross the onset. */
TEST(yield_in_a_liquid)
{
    const double yield = 0.1, liquid = 0.01, beyond = 5e-4;
    const struct cor_scene_contact contact = {.law = cor_law_exponents[COR_LAW_ELASTIC_PLASTIC],
                                              .mass_kg = NAN,
                                              .stiffness = NAN,
                                              .radius_m = NAN,
                                              .plastic = true,
                                              .yield_speed_m_s = yield,
                                              .liquid_speed_m_s = liquid};
    for (int log = 0; log < 2; log++) {
        const struct sample_request r = {.contact = &contact,
                                         .end = COR_END_ZERO_FORCE,
                                         .speed_min = (yield + liquid) * (1 + beyond),
                                         .speed_max = 5,
                                         .tolerance = 1e-5,
                                         .log = log,
                                         .cubic = true};
        struct sample s;
        assert_int_equal(sample_choose(&s, &r), 0);
        assert_true(s.best.error <= r.tolerance && s.best.count > 3);
        for (size_t i = 0; i < s.best.count; i++) {
            const double speed = s.best.speed_m_s[i], eps = cor_elastic_plastic_eps((speed - liquid) / yield);
            const double wet = (eps * (speed - liquid) - liquid) / speed, slope = slope_at(&r, speed, beyond / 4);
            check(fabs(s.best.value[0][i] / wet - 1) < 1e-14, "eps(%g) = %.17g, not %.17g", speed, s.best.value[0][i],
                  wet);
            check(fabs(s.best.slope[0][i] - slope) < 1e-9 * wet / speed, "slope at %g: %.12g, not %.12g", speed,
                  s.best.slope[0][i], slope);
        }
        sample_clear(&s);
    }
}
