/* SPDX-License-Identifier: MIT */
/* gen/fit: csv files, fits, intervals, ranks. The references take other routes: closed forms, the equations that a
 * minimum of least squares satisfies, sums of squares by the scalar functions of the library, and synthetic data whose
 * truth is known. */
#include "support/console.h" /* before cmocka.h makes a macro of fail */

#include "ball.h"

#include <cor/cor.h>

#include "cor/scene.h"
#include "fit/compare.h"

enum { POINTS_MAX = 400, MODELS = 19 };
static struct random_state *const r = &draw;

/* ---- distributions ---- */

TEST(quantiles_have_closed_forms)
{
    const double pi = acos(-1), level[LEVELS] = {0.68268949213708590, 0.95};
    for (int i = 0; i < LEVELS; i++) {
        const enum distribution_level l = (enum distribution_level)i;
        check_near(erf(normal_quantile(l) / sqrt(2)), level[i], 1e-14);
        check_near(student_quantile(l, 1), tan(pi * level[i] / 2), 1e-8);
        check_near(student_quantile(l, 2), level[i] * sqrt(2 / (1 - level[i] * level[i])), 1e-8);
        /* Cornish and Fisher's expansion, of many degrees of freedom */
        const double n = 1e6, z = normal_quantile(l), z2 = z * z;
        check_near(student_quantile(l, 1000000), z * (1 + (z2 + 1) / (4 * n) + ((5 * z2 + 16) * z2 + 3) / (96 * n * n)),
                   1e-12);
    }
    check_near(student_quantile(LEVEL_95, 10), 2.2281388519649385, 1e-8); /* tables */
}

TEST(tails_have_closed_forms)
{
    for (double x = 0.01; x < 200; x *= 1.7) {
        check_near(chi_squared_tail(x, 2), exp(-x / 2), 1e-12);
        check_near(chi_squared_tail(x, 1), erfc(sqrt(x / 2)), 1e-12);
        check_near(chi_squared_tail(x, 4), exp(-x / 2) * (1 + x / 2), 1e-12);
        check_near(fisher_tail(x, 2, 7), pow(1 + 2 * x / 7, -3.5), 1e-12);
        check_near(fisher_tail(x, 2, 10000), pow(1 + 2 * x / 10000, -5000), 1e-10);
    }
    check_near(fisher_tail(3, 2, 10001), pow(1 + 6. / 10001, -5000.5), 0.01);
    check_near(fisher_tail(1, 5, 5), 0.5, 1e-12); /* F and 1/F are alike */
    for (int t = -2; t <= 2; t++) { /* Wilson and Hilferty's approximation, t standard deviations from the mean */
        const double x = 1e6 + t * sqrt(2e6), z = (cbrt(x / 1e6) - 1 + 2 / 9e6) / sqrt(2 / 9e6);
        check_near(chi_squared_tail(x, 1000000), erfc(z / sqrt(2)) / 2, 1e-7);
    }
    assert_true(chi_squared_tail(0, 3) == 1 && fisher_tail(0, 3, 3) == 1);
}

/* ---- synthetic data ---- */

/* The truth of each curve, whose eps is between 0.4 and 0.95 from 0.1 to 10 m/s, and what it is without its second
 * parameter */
static const struct {
    double theta[FIT_MAX_PARAMETERS];
    enum fit_curve inside;
} truth[FIT_CURVES] = {
    [FIT_SPHERE_ZERO_OVERLAP] = {{-1.2}, FIT_SPHERE_ZERO_OVERLAP},
    [FIT_SPHERE_ZERO_FORCE] = {{-1}, FIT_SPHERE_ZERO_FORCE},
    [FIT_CONSTANT] = {{0.7}, FIT_CONSTANT},
    [FIT_HUNT_CROSSLEY] = {{-2.3}, FIT_HUNT_CROSSLEY},
    [FIT_HERTZ_DASHPOT_ZERO_OVERLAP] = {{-1.5}, FIT_HERTZ_DASHPOT_ZERO_OVERLAP},
    [FIT_HERTZ_DASHPOT_ZERO_FORCE] = {{-1.3}, FIT_HERTZ_DASHPOT_ZERO_FORCE},
    [FIT_POWER_LAW] = {{-0.4, -0.1}, FIT_CONSTANT},
    [FIT_ELASTIC_PLASTIC] = {{-1.2}, FIT_ELASTIC_PLASTIC},
    [FIT_ADHESIVE] = {{0.7, -3}, FIT_CONSTANT},
    [FIT_ADHESIVE_SPHERE_ZERO_OVERLAP] = {{-1.2, -3}, FIT_SPHERE_ZERO_OVERLAP},
    [FIT_ADHESIVE_SPHERE_ZERO_FORCE] = {{-1, -3}, FIT_SPHERE_ZERO_FORCE},
    [FIT_WET] = {{0.8, -3.9}, FIT_CONSTANT},
    [FIT_WET_SPHERE_ZERO_OVERLAP] = {{-1.2, -3.9}, FIT_SPHERE_ZERO_OVERLAP},
    [FIT_WET_SPHERE_ZERO_FORCE] = {{-1, -3.9}, FIT_SPHERE_ZERO_FORCE},
};

struct sample {
    struct fit_point point[POINTS_MAX];
    struct fit_data data;
};

static double normal_deviate(void)
{
    const double radius = sqrt(-2 * log(1 - random_uniform(r, 0, 1)));
    return radius * cos(2 * acos(-1) * random_uniform(r, 0, 1));
}

/* n points with equal steps in ln g from 0.1 to 10 m/s, and normal errors */
static void draw_sample(struct sample *s, enum fit_curve curve, size_t n, double noise, bool with_sigma)
{
    for (size_t i = 0; i < n; i++) {
        const double x = log(0.1) + log(100) * (double)i / (double)(n - 1);
        s->point[i] = (struct fit_point){.speed_m_s = exp(x)};
        s->point[i].sigma = with_sigma ? noise * random_uniform(r, 0.5, 2) : noise;
        fit_curve_eps(curve, truth[curve].theta, &x, &s->point[i].eps, 1);
        s->point[i].eps += s->point[i].sigma * normal_deviate();
    }
    s->data = (struct fit_data){.points = n, .point = s->point, .has_sigma = with_sigma};
}

static double weight(const struct sample *s, size_t i)
{
    return s->data.has_sigma ? 1 / (s->point[i].sigma * s->point[i].sigma) : 1;
}

/* ---- fits by other routes ---- */

static const struct fit_bodies glass = {{7e10, 0.24, 0, 0.005, 1.3e-3}, {7e10, 0.24, 0, INFINITY, INFINITY}, 2500};

/* eps of a model's parameter at a speed, by the scalar functions of the library */
static double eps_of_parameter(const struct fit_model *model, const char *name, double value, double speed)
{
    struct cor_sphere_contact contact;
    struct cor_body body = glass.body_1, wall = glass.body_2;
    const bool zero_force = strcmp(model->end, "zero-force") == 0;
    const enum cor_end end = zero_force ? COR_END_ZERO_FORCE : COR_END_ZERO_OVERLAP;
    if (strcmp(name, "g_star_m_s") == 0) {
        cor_sphere_contact_init_g_star(&contact, value);
    } else if (strcmp(name, "plate_thickness_m") == 0) {
        const struct cor_plate plate = {wall.young_modulus_pa, wall.poisson_ratio, glass.density_2_kg_m3, value};
        cor_plate_contact_init(&contact, &body, &plate);
    } else if (strcmp(name, "dissipation_time_s") == 0) {
        body.dissipation_time_s = wall.dissipation_time_s = value;
        cor_sphere_contact_init(&contact, &body, &wall);
    } else if (strcmp(name, "damping_coefficient_n_s_m") == 0) {
        cor_sphere_contact_init(&contact, &body, &wall);
        const double k = contact.elastic_constant_n_m15, m = contact.effective_mass_kg;
        const double beta = value * pow(m, -0.6) * pow(k, -0.4) * pow(speed, -0.2);
        return cor_law_value(COR_LAW_HERTZ_DASHPOT, end, COR_EPS, beta);
    } else if (strcmp(name, "beta_at_1_m_s") == 0) {
        const double beta = value * pow(speed, -0.2);
        return cor_law_value(COR_LAW_HERTZ_DASHPOT, end, COR_EPS, beta);
    } else if (strcmp(name, "zener_lambda_at_1_m_s") == 0) {
        return cor_sphere_eps_zero_overlap(1.5 * value * pow(speed, 0.2));
    } else if (strcmp(name, "yield_speed_m_s") == 0) {
        return cor_elastic_plastic_eps(speed / value);
    } else if (strcmp(name, "yield_stress_pa") == 0) { /* Thornton's v_y of two bodies */
        cor_sphere_contact_init(&contact, &body, &wall);
        const double r = contact.effective_radius_m, modulus = 0.75 * contact.elastic_constant_n_m15 / sqrt(r);
        const double pi = acos(-1), limit = 1.6 * value;
        return cor_elastic_plastic_eps(speed / (pow(pi / (2 * modulus), 2) * pow(limit, 2.5) *
                                                sqrt(8 * pi * r * r * r / (15 * contact.effective_mass_kg))));
    } else if (strcmp(name, "dissipation_s_m") == 0) {
        return cor_law_value(COR_LAW_HUNT_CROSSLEY, end, COR_EPS, value * speed);
    } else if (strcmp(name, "zeta") == 0) {
        return cor_law_value(COR_LAW_TSUJI, end, COR_EPS, value);
    } else {
        return value;
    }
    return zero_force ? cor_contact_eps_zero_force(&contact, speed) : cor_contact_eps_zero_overlap(&contact, speed);
}

/* eps of a curve; that of a loss by the energy, or the speed, that it takes */
static long double eps_of_theta(enum fit_curve curve, const double *theta, double speed)
{
    const struct fit_model *model = fit_models;
    const enum fit_curve inside = truth[curve].inside;
    if (curve == FIT_POWER_LAW)
        return fminl(1, expl(theta[0]) * powl(speed, theta[1]));
    if (curve == FIT_WET || curve == FIT_WET_SPHERE_ZERO_OVERLAP || curve == FIT_WET_SPHERE_ZERO_FORCE) {
        const double left = speed - exp(theta[1]);
        const long double back = left > 0 ? left * eps_of_theta(inside, theta, left) - expl(theta[1]) : 0;
        return fmaxl(back, 0) / speed;
    }
    if (inside != curve) {
        const long double back = eps_of_theta(inside, theta, speed) * speed;
        return sqrtl(fmaxl(back * back - expl(2 * theta[1]), 0)) / speed;
    }
    while (model->curve != curve)
        model++;
    return eps_of_parameter(model, fit_parameter_name(model, 0, NULL), fit_parameter_value(model, 0, theta[0], NULL),
                            speed);
}

static double squares_of_parameter(const struct sample *s, const struct fit_model *model, const char *name,
                                   double value)
{
    double sum = 0;
    for (size_t i = 0; i < s->data.points; i++) {
        const double residual = s->point[i].eps - eps_of_parameter(model, name, value, s->point[i].speed_m_s);
        sum += weight(s, i) * residual * residual;
    }
    return sum;
}

/* A scan of the sum of squares over the model's parameter finds no lower value than the fit's, and the sum has the
 * threshold's value at both ends of the intervals. */
static void check_parameter(const struct sample *s, const struct fit_model *model, const struct fit_estimate *e,
                            const struct fit_bodies *bodies)
{
    const char *const name = fit_parameter_name(model, 0, bodies);
    const double value = fit_parameter_value(model, 0, e->theta[0], bodies);
    const double least = squares_of_parameter(s, model, name, value);
    if (s->data.has_sigma)
        check_near(e->chi2, least, 1e-9);
    else
        check_near(e->rms, sqrt(least / (double)s->data.points), 1e-9);
    for (int i = -300; i <= 300; i++) {
        const double at = value * exp(0.02 * i), sum = squares_of_parameter(s, model, name, at);
        check(!(sum < least * (1 - 1e-9)), "%s %s: %g is lower at %s = %g than %g at %g", model->name, model->end, sum,
              name, at, least, value);
    }
    const size_t freedom = s->data.points - 1;
    for (int level = 0; level < LEVELS; level++) {
        const enum distribution_level l = (enum distribution_level)level;
        const double quantile = s->data.has_sigma ? normal_quantile(l) : student_quantile(l, freedom);
        const double expected = quantile * quantile * (s->data.has_sigma ? 1 : least / (double)freedom);
        const double end[] = {e->interval[0][level].low, e->interval[0][level].high};
        for (int side = 0; side < 2; side++) {
            const double at = fit_parameter_value(model, 0, end[side], bodies);
            check_near(squares_of_parameter(s, model, name, at) - least, expected, 1e-5);
        }
        assert_true(end[0] < e->theta[0] && e->theta[0] < end[1]);
    }
}

TEST(a_scan_finds_the_same_minimum_and_intervals)
{
    for (int with_sigma = 0; with_sigma < 2; with_sigma++) {
        for (size_t i = 0; i < fit_model_count; i++) {
            const struct fit_model *const model = &fit_models[i];
            struct sample s;
            struct fit_estimate e;
            if (fit_curve_parameters(model->curve) > 1)
                continue;
            draw_sample(&s, model->curve, 15, 0.02, with_sigma);
            fit_estimate_curve(&e, model->curve, &s.data, false);
            check_parameter(&s, model, &e, NULL);
            check_parameter(&s, model, &e, &glass);
        }
    }
}

/* The sum of squares of a curve of two parameters by another formula is the fit's, no point of a grid around it has a
 * lower one, and the intervals are where the least sum over the other parameter reaches the threshold. */
TEST(two_parameters_have_the_least_squares)
{
    for (enum fit_curve curve = 0; curve < FIT_CURVES; curve++) {
        struct sample s;
        struct fit_estimate e;
        if (fit_curve_parameters(curve) < 2)
            continue;
        draw_sample(&s, curve, 25, 0.01, true);
        fit_estimate_curve(&e, curve, &s.data, false);
        long double least[2] = {INFINITY, INFINITY}; /* near the fit; where theta_1 is the end of its interval */
        for (int i = -60; i <= 60; i++)
            for (int k = 0; k <= 61; k++) {
                const double half = (e.interval[0][LEVEL_68].high - e.interval[0][LEVEL_68].low) / 2;
                const double theta[FIT_MAX_PARAMETERS] = {e.theta[0] + 0.05 * i * half,
                                                          k == 61 ? e.interval[1][LEVEL_68].high
                                                                  : e.theta[1] + 0.01 * (k - 30)};
                long double sum = 0;
                for (size_t point = 0; point < s.data.points; point++) {
                    const long double residual =
                        s.point[point].eps - eps_of_theta(curve, theta, s.point[point].speed_m_s);
                    sum += weight(&s, point) * (double)(residual * residual);
                }
                if (i == 0 && k == 30)
                    check_near(e.chi2, (double)sum, 1e-9);
                least[k == 61] = fminl(least[k == 61], sum);
            }
        check(least[0] > e.chi2 * (1 - 1e-9), "curve %d: %Lg below %g", (int)curve, least[0], e.chi2);
        check(fabsl(least[1] - e.chi2 - 1) < 0.01, "curve %d: the interval ends at %Lg", (int)curve, least[1] - e.chi2);
        for (int j = 0; j < 2; j++)
            check(fabs(e.theta[j] - truth[curve].theta[j]) < 0.4, "curve %d: theta_%d = %g", (int)curve, j, e.theta[j]);
    }
}

/* ---- ranks ---- */

static void compare_all(struct fit_comparison *c, const struct sample *s, bool robust)
{
    struct fit_request request = {.robust = robust};
    assert_int_equal(fit_request_models(&request, "all", NULL), STATUS_OK);
    fit_compare(c, &s->data, &request);
}

/* Precise data of a curve: that curve has the least AIC and fits (p is as good as never so small by chance), and the
 * constant does not. */
TEST(the_true_curve_ranks_first)
{
    for (int curve = 0; curve < FIT_CURVES; curve++) {
        for (int way = 0; way < 4; way++) {
            if (!in_turn((size_t)(curve + way), 4))
                continue;
            struct sample s;
            struct fit_comparison c;
            draw_sample(&s, (enum fit_curve)curve, 60, 1e-3, way & 1);
            compare_all(&c, &s, way & 2);
            assert_int_equal(c.models, MODELS);
            const enum fit_curve first = fit_models[c.ranked[0]].curve;
            /* A second parameter may fit the noise. */
            check(first == (enum fit_curve)curve || truth[first].inside == (enum fit_curve)curve,
                  "data of curve %d, the first is curve %d", curve, (int)first);
            check(c.estimate[curve].p_value > 1e-7, "p = %g", c.estimate[curve].p_value);
            assert_true(curve == FIT_CONSTANT || !fit_is_accepted(&c.estimate[FIT_CONSTANT]));
            for (int i = 1; i < c.models; i++) {
                const double before = c.estimate[fit_models[c.ranked[i - 1]].curve].aic,
                             after = c.estimate[fit_models[c.ranked[i]].curve].aic;
                /* models of one curve are equal, and stay in the order of the table */
                assert_true(before < after || (before == after && c.ranked[i - 1] < c.ranked[i]));
            }
        }
    }
}

TEST(aic_is_that_of_the_likelihood)
{
    struct sample s;
    struct fit_comparison c;
    draw_sample(&s, FIT_SPHERE_ZERO_FORCE, 20, 0.02, true);
    compare_all(&c, &s, false);
    for (int curve = 0; curve < FIT_CURVES; curve++)
        check_near(c.estimate[curve].aic, c.estimate[curve].chi2 + 2 * fit_curve_parameters((enum fit_curve)curve),
                   1e-9);
    s.data.has_sigma = NULL;
    compare_all(&c, &s, false);
    for (int curve = 0; curve < FIT_CURVES; curve++)
        check_near(c.estimate[curve].aic,
                   40 * log(c.estimate[curve].rms) + 2 * (fit_curve_parameters((enum fit_curve)curve) + 1), 1e-9);
}

/* ---- how often chance does it ---- */

/* P(X <= k) of n draws with probability p */
static double lower_tail(int n, int k, double p)
{
    double sum = 0;
    for (int i = 0; i <= k; i++)
        sum += exp(lgamma(n + 1.) - lgamma(i + 1.) - lgamma(n - i + 1.) + i * log(p) + (n - i) * log1p(-p));
    return sum;
}

/* k of n draws with a probability from `least` to `most` are neither too few nor too many by chance. */
static bool is_likely(int n, int k, double least, double most)
{
    return lower_tail(n, k, least) > 1e-6 && 1 - lower_tail(n, k - 1, most) > 1e-6;
}

/* ---- extreme data ---- */

TEST(elastic_data_have_no_upper_end)
{
    struct fit_point point[] = {{0.1, 1, 0.01, 0, 0}, {1, 1, 0.01, 0, 1}, {10, 1, 0.01, 0, 2}};
    const struct fit_data data = {.points = 3, .point = point, .has_sigma = true};
    struct fit_estimate e;
    fit_estimate_curve(&e, FIT_SPHERE_ZERO_OVERLAP, &data, false);
    const struct fit_model *const model = &fit_models[0];
    assert_true(fit_parameter_value(model, 0, e.theta[0], NULL) == INFINITY);                  /* g* */
    assert_true(fit_parameter_value(model, 0, e.interval[0][LEVEL_95].low, NULL) == INFINITY); /* theta: weak damping */
    const double g_star = fit_parameter_value(model, 0, e.interval[0][LEVEL_95].high, NULL);
    check(g_star > 1e3 && g_star < 1e12, "g* above %g", g_star);
    fit_estimate_curve(&e, FIT_CONSTANT, &data, false);
    assert_true(e.theta[0] == 1 && e.interval[0][LEVEL_95].high == 1 && e.interval[0][LEVEL_95].low < 1);
}

/* One datum, eps = 0, has all the weight: beta is infinite, and its intervals hold it. The mirror image has eps = 1. */
TEST(an_end_of_the_range_is_in_its_interval)
{
    struct fit_point point[] = {{1, 0, 1e-40, 0, 0}, {2, 1, 1e20, 0, 1},  {3, 0.2, 1, 0, 2},
                                {4, 0.1, 1, 0, 3},   {5, 0.2, 0.5, 0, 4}, {5, 0.2, 1, 0, 5}};
    const struct fit_data data = {.points = 6, .point = point, .has_sigma = true};
    int infinite = 0;
    for (int image = 0; image < 2; image++) {
        for (int curve = 0; curve < FIT_CURVES; curve++) {
            struct fit_estimate e;
            if (curve == FIT_CONSTANT || curve == FIT_POWER_LAW)
                continue;
            fit_estimate_curve(&e, (enum fit_curve)curve, &data, false);
            for (int j = 0; j < e.parameters; j++)
                for (int level = 0; level < LEVELS; level++)
                    check(e.interval[j][level].low <= e.theta[j] && e.theta[j] <= e.interval[j][level].high,
                          "curve %d, image %d: %g, %g, %g", curve, image, e.interval[j][level].low, e.theta[j],
                          e.interval[j][level].high);
            if (isinf(e.theta[0]))
                infinite++;
        }
        for (size_t i = 0; i < 6; i++)
            point[i].eps = 1 - point[i].eps;
    }
    check(infinite > 2, "%d infinite values of beta", infinite);
}

/* ---- csv files ---- */

static void read_text(struct fit_data *data, char *text)
{
    FILE *const file = fmemopen(text, strlen(text), "r");
    assert_int_equal(fit_data_parse(data, file, "text", &FIT_FORM_DEFAULT), STATUS_OK);
    fclose(file);
}

/* Other forms of a file are in tests/cli. */
TEST(points_are_in_the_order_of_speeds)
{
    struct fit_data data;
    read_text(&data, (char[]){"speed_cm_s,eps,eps_sigma\n200,0.5,0.1\n25,0.6,0.2\n"});
    const struct fit_point *const point = data.point;
    assert_true(data.points == 2 && point[0].speed_m_s == 0.25 && point[1].speed_m_s == 2 && point[0].eps == 0.6);
    assert_true(data.has_sigma && point[0].sigma == 0.2 && point[1].sigma == 0.1);
    fit_data_clear(&data);
}

/* By hand: flights of 1, 0.8 and 0.64 s, and of 0.5 and 0.45 s. */
TEST(flights_give_speeds_and_eps)
{
    struct fit_data data;
    read_text(&data, (char[]){"run,t_s\na,0\na,1\na,1.8\na,2.44\nb,5\nb,5.5\nb,5.95\n"});
    assert_int_equal(data.points, 3);
    const double expected_speed[] = {0.25, 0.4, 0.5}, expected_eps[] = {0.9, 0.8, 0.8};
    for (int i = 0; i < 3; i++) {
        check_near(data.point[i].speed_m_s, expected_speed[i] * FIT_GRAVITY_M_S2, 1e-14);
        check_near(data.point[i].eps, expected_eps[i], 1e-14);
    }
    assert_true(data.bounce && !data.has_sigma);
    fit_data_clear(&data);
}

/* ---- intervals against the truth ---- */

/* Points, or drops of a ball from 0.6 to 1 s of flight. eps of a bounce scatters by eps_sigma about the curve, and each
 * time has an error of its own; with the probability `bad` it is 20 times as large. */
struct setting {
    enum fit_curve curve;
    size_t points; /* 0: bounces */
    bool with_sigma, robust;
    double least, most; /* how often an interval of 95 % holds the truth, in long runs */
    int drops, times;
    double time_sigma_s, eps_sigma, bad;
};

enum { LINES_MAX = 160 };
static struct {
    int drop;
    double time_s;
} written[LINES_MAX]; /* by line of the last drops */

/* The first line is 1, and a time is one line. `late_line` is late by late_s. Every drop but the first has `fewest`
 * times or more. */
static void draw_bounces(struct fit_data *data, const struct setting *b, int fewest, long late_line, double late_s)
{
    char text[40 * LINES_MAX] = "run,t_s\n";
    long line = 1;
    for (int drop = 0; drop < b->drops; drop++) {
        double time = 1, flight = random_uniform(r, 0.6, 1);
        const int fewer = drop > 0 && fewest < b->times ? (int)random_below(r, (size_t)(b->times - fewest + 1)) : 0;
        for (int i = 0; i < b->times - fewer; i++) {
            const double x = log(FIT_GRAVITY_M_S2 * flight / 2);
            const double sigma = b->time_sigma_s * (random_uniform(r, 0, 1) < b->bad ? 20 : 1);
            const double late = ++line == late_line ? late_s : 0;
            assert_true(line < LINES_MAX);
            written[line].drop = drop;
            written[line].time_s = time + late + sigma * normal_deviate();
            snprintf(text + strlen(text), sizeof text - strlen(text), "%d,%.17g\n", drop, written[line].time_s);
            double eps;
            fit_curve_eps(b->curve, truth[b->curve].theta, &x, &eps, 1);
            time += flight;
            flight *= eps + b->eps_sigma * normal_deviate();
        }
    }
    written[line + 1].drop = -1;
    read_text(data, text);
}

/* A drop alone does not tell whether its times or its bounces scatter. */
static const struct setting settings[] = {
    {FIT_SPHERE_ZERO_OVERLAP, 12, false, false, 0.93, 0.97, 0, 0, 0, 0, 0},
    {FIT_SPHERE_ZERO_FORCE, 12, true, false, 0.93, 0.97, 0, 0, 0, 0, 0},
    {FIT_CONSTANT, 8, false, false, 0.93, 0.97, 0, 0, 0, 0, 0},
    {FIT_HUNT_CROSSLEY, 12, false, false, 0.93, 0.97, 0, 0, 0, 0, 0},
    {FIT_HERTZ_DASHPOT_ZERO_OVERLAP, 12, true, false, 0.93, 0.97, 0, 0, 0, 0, 0},
    {FIT_HERTZ_DASHPOT_ZERO_FORCE, 12, false, false, 0.93, 0.97, 0, 0, 0, 0, 0},
    {FIT_POWER_LAW, 12, false, false, 0.93, 0.97, 0, 0, 0, 0, 0},
    {FIT_POWER_LAW, 12, true, false, 0.93, 0.97, 0, 0, 0, 0, 0},
    {FIT_SPHERE_ZERO_FORCE, 40, false, true, 0.93, 0.97, 0, 0, 0, 0, 0},
    {FIT_POWER_LAW, 40, true, true, 0.93, 0.97, 0, 0, 0, 0, 0},
    {FIT_CONSTANT, 0, false, false, 0.93, 0.985, 10, 8, 1e-3, 0, 0},
    {FIT_CONSTANT, 0, false, false, 0.93, 0.999, 1, 8, 1e-3, 0, 0},
    {FIT_CONSTANT, 0, false, false, 0.7, 0.95, 1, 8, 0, 0.01, 0},
    {FIT_CONSTANT, 0, false, false, 0.89, 0.97, 10, 8, 1e-3, 0.005, 0},
    {FIT_CONSTANT, 0, false, false, 0.89, 0.97, 10, 8, 1e-6, 0.01, 0},
    {FIT_SPHERE_ZERO_OVERLAP, 0, false, false, 0.93, 0.985, 10, 7, 1e-3, 0, 0},
    {FIT_SPHERE_ZERO_FORCE, 0, false, false, 0.89, 0.97, 5, 7, 2e-4, 0.005, 0},
    {FIT_HUNT_CROSSLEY, 0, false, false, 0.93, 0.985, 10, 9, 1e-4, 0, 0},
    {FIT_HERTZ_DASHPOT_ZERO_OVERLAP, 0, false, false, 0.89, 0.97, 10, 6, 5e-4, 0.002, 0},
    {FIT_POWER_LAW, 0, false, false, 0.93, 0.985, 10, 7, 1e-3, 0, 0},
    {FIT_POWER_LAW, 0, false, false, 0.89, 0.97, 10, 7, 1e-3, 0.01, 0},
    {FIT_CONSTANT, 0, false, true, 0.93, 0.985, 10, 8, 1e-3, 0, 0},
    {FIT_POWER_LAW, 0, false, true, 0.89, 0.97, 10, 7, 1e-3, 0.01, 0},
    {FIT_SPHERE_ZERO_FORCE, 0, false, true, 0.93, 0.985, 20, 7, 2e-4, 0, 0.05},
};

/* Of 1000 draws of points, 930 to 970 intervals of 95 % hold the truth, and of 600 draws of bounces as many as their
 * row says; fewer draws have the exact binomial limits of probability 1e-6 instead. The same holds for 68 % of points
 * and for p values below FIT_SIGNIFICANCE. */
TEST(intervals_hold_the_truth)
{
    static const double levels[LEVELS] = {0.68268949213708590, 0.95};
    const bool whole = few_or_all(0, 1) != 0;
    for (size_t k = 0; k < COUNT_OF(settings); k++) {
        const struct setting *const c = &settings[k];
        const int draws = c->points ? (whole ? 1000 : 40) : (whole ? 600 : 12);
        int in[FIT_MAX_PARAMETERS][LEVELS] = {{0}}, rejected = 0;
        if (!c->points && !in_turn(k, 3))
            continue;
        for (int draw = 0; draw < draws; draw++) {
            struct sample s;
            struct fit_estimate e;
            if (c->points)
                draw_sample(&s, c->curve, c->points, 0.015, c->with_sigma);
            else
                draw_bounces(&s.data, c, c->times, 0, 0);
            fit_estimate_curve(&e, c->curve, &s.data, c->robust);
            rejected += !fit_is_accepted(&e);
            for (int j = 0; j < e.parameters; j++)
                for (int l = 0; l < LEVELS; l++)
                    in[j][l] += e.interval[j][l].low <= truth[c->curve].theta[j] &&
                                truth[c->curve].theta[j] <= e.interval[j][l].high;
            if (!c->points)
                fit_data_clear(&s.data);
        }
        for (int j = 0; j < fit_curve_parameters(c->curve); j++)
            for (int l = 0; l < LEVELS; l++) {
                const int n = in[j][l];
                if (whole)
                    print_message("row %zu, parameter %d, level %d: %.1f of 100, rejected %d\n", k, j, l,
                                  100. * n / draws, rejected);
                if (c->points || l == LEVEL_95)
                    check(is_likely(draws, n, c->points ? levels[l] : c->least, c->points ? levels[l] : c->most),
                          "row %zu, parameter %d: %d of %d hold", k, j, n, draws);
                check(!whole || l != LEVEL_95 || (n >= c->least * draws && n <= c->most * draws),
                      "row %zu, parameter %d: %d of %d hold", k, j, n, draws);
            }
        check(1 - lower_tail(draws, rejected - 1, (c->points ? 1 : 2) * FIT_SIGNIFICANCE) > 1e-6,
              "row %zu: %d of %d rejected", k, rejected, draws);
    }
}

/* ---- times of bounces by dense matrices ---- */

/* The whole trajectory of a drop, to first order in the errors at the measured flights: its first time, its first
 * flight and the scatter of eps at each bounce move all later times through T_(k+1) = T_k eps(g T_k/2). With the
 * covariance C = 1 + lambda S S^T of the times and the columns X of the first time and flight, the matrix
 *
 *     [ C    X ]
 *     [ X^T  0 ]
 *
 * has P in the place of C in its inverse: r^T P r is least over X, r_i (P r)_i/P_ii the gain by an error of time i, and
 * its determinant is det C det(X^T C^-1 X), as the restricted likelihood has it. */
enum { DROP_TIMES = 8 };

struct trajectory {
    int times;
    long double residual[DROP_TIMES], of_first_flight[DROP_TIMES], of_scatter[DROP_TIMES][DROP_TIMES];
};

/* T eps(g T/2), by the scalar functions of the library */
static long double next_flight(enum fit_curve curve, const double *theta, long double flight)
{
    return flight * eps_of_theta(curve, theta, (double)(FIT_GRAVITY_M_S2 * flight / 2));
}

static void find_trajectory(struct trajectory *y, enum fit_curve curve, const double *theta, long first_line)
{
    long double residual = 0, of_first_flight = 1, of_scatter[DROP_TIMES] = {0};
    *y = (struct trajectory){.times = 2, .of_first_flight = {0, 1}};
    for (long line = first_line + 2; written[line].drop == written[first_line].drop; line++) {
        const int i = y->times++;
        const long double flight = (long double)written[line - 1].time_s - written[line - 2].time_s;
        const long double h = 1e-3L * flight;
        const long double near = next_flight(curve, theta, flight + h) - next_flight(curve, theta, flight - h),
                          far = next_flight(curve, theta, flight + 2 * h) - next_flight(curve, theta, flight - 2 * h),
                          slope = (8 * near - far) / (12 * h);
        residual = slope * residual + ((long double)written[line].time_s - written[line - 1].time_s) -
                   next_flight(curve, theta, flight);
        of_first_flight *= slope;
        for (int k = 2; k < i; k++)
            of_scatter[k] *= slope;
        of_scatter[i] = flight;
        y->residual[i] = y->residual[i - 1] + residual;
        y->of_first_flight[i] = y->of_first_flight[i - 1] + of_first_flight;
        for (int k = 2; k <= i; k++)
            y->of_scatter[i][k] = y->of_scatter[i - 1][k] + of_scatter[k];
    }
}

/* r^T P r of the first times, and ln |det| of the matrix; distance[i] is (P r)_i/sqrt(P_ii). */
static double solve_drop(double *log_determinant, double *distance, const struct trajectory *y, int times, double ratio)
{
    enum { BITS = 160 };
    const int n = times + 2;
    double sum = 0;
    LOCAL_MATRIX(n, n, m, inverse);
    LOCAL(arb, x);
    for (int i = 0; i < times; i++) {
        for (int j = 0; j < times; j++) {
            long double c = i == j;
            for (int k = 0; k < times; k++)
                c += ratio * y->of_scatter[i][k] * y->of_scatter[j][k];
            arb_set_d(arb_mat_entry(m, i, j), (double)c);
        }
        for (int k = 0; k < 2; k++) {
            const double column = k == 0 ? 1 : (double)y->of_first_flight[i];
            arb_set_d(arb_mat_entry(m, i, times + k), column);
            arb_set_d(arb_mat_entry(m, times + k, i), column);
        }
    }
    assert_true(arb_mat_inv(inverse, m, BITS));
    arb_mat_det(x, m, BITS);
    arb_abs(x, x);
    arb_log(x, x, BITS);
    *log_determinant = middle(x);
    for (int i = 0; i < times; i++) {
        long double row = 0;
        for (int j = 0; j < times; j++)
            row += middle(arb_mat_entry(inverse, i, j)) * y->residual[j];
        sum += (double)(y->residual[i] * row);
        if (distance)
            distance[i] = (double)row / sqrt(middle(arb_mat_entry(inverse, i, i)));
    }
    return sum;
}

/* The sum of z^2 over all bounces of the file, and ln(det W/det B). The square of each z, in the order of the file, is
 * what its last time adds; `distance` is by line. Both may be NULL. */
static double solve_dense(double *log_determinant, double *square, double *distance, enum fit_curve curve,
                          const double *theta, double ratio)
{
    double sum = 0, with, without;
    *log_determinant = 0;
    for (long line = 2, first = 2; written[first].drop >= 0; first = line) {
        struct trajectory y;
        double before = 0;
        while (written[line].drop == written[first].drop)
            line++;
        find_trajectory(&y, curve, theta, first);
        for (int times = 3; square && times <= y.times; times++) {
            const double next = solve_drop(&with, NULL, &y, times, ratio);
            *square++ = next - before;
            before = next;
        }
        sum += solve_drop(&with, distance ? distance + first : NULL, &y, y.times, ratio);
        solve_drop(&without, NULL, &y, y.times, 0);
        *log_determinant += with - without;
    }
    return sum;
}

/* Q with the determinants */
static double dense_q(enum fit_curve curve, const double *theta, double ratio, size_t n)
{
    double log_determinant;
    const double sum = solve_dense(&log_determinant, NULL, NULL, curve, theta, ratio);
    return sum * exp(log_determinant / (double)n);
}

struct place {
    const struct fit_estimate *e;
    size_t n;
    double theta[FIT_MAX_PARAMETERS], log_ratio;
    int other; /* the coordinate over which the least Q is looked for, or -1 */
};

static double q_at_ratio(struct place p, double log_ratio)
{
    return dense_q(p.e->curve, p.theta, exp(log_ratio), p.n);
}

static double golden_section(double f(struct place, double), struct place p, double low, double high)
{
    const double golden = 0.6180339887498949;
    double at = high - golden * (high - low), height = f(p, at);
    for (int i = 0; i < 22; i++) {
        const double next = low + golden * (high - low), next_height = f(p, next);
        if (next_height < height) {
            low = at;
            at = next;
            height = next_height;
        } else {
            high = low;
            low = next;
        }
    }
    return height;
}

/* Where the errors of the times or the scatter of the bounces are as good as none, Q is level in lambda. */
static double q_of_theta(struct place p, double x)
{
    double best = -20, least = INFINITY;
    if (p.other >= 0)
        p.theta[p.other] = x;
    for (int u = -24; u <= 20; u++) {
        const double q = q_at_ratio(p, u);
        best = q < least ? u : best;
        least = fmin(q, least);
    }
    return golden_section(q_at_ratio, p, best - 1, best + 1);
}

/* fit_aic at any place: the determinants, the slopes and the band against the dense matrices, with Huber's bend */
static void check_likelihood(const struct fit_data *data, enum fit_curve curve)
{
    const int k = fit_curve_parameters(curve);
    const size_t n = data->points;
    struct fit_estimate at = {.curve = curve, .parameters = k}, noise = {.ratio = random_log(r, 1e-6, 1e6)};
    double log_determinant, square[LINES_MAX], expected = 2 * k;
    for (int j = 0; j < k; j++)
        at.theta[j] = truth[curve].theta[j] + random_uniform(r, -0.05, 0.05);
    const double sum = solve_dense(&log_determinant, square, NULL, curve, at.theta, noise.ratio);
    const double determinants = exp(log_determinant / (2 * (double)n));
    noise.scale = sqrt(sum / (double)n) * determinants * random_log(r, 0.3, 3);
    for (size_t i = 0; i < n; i++) {
        const double z = sqrt(fmax(square[i], 0)) * determinants / noise.scale;
        expected += z <= FIT_HUBER ? z * z : FIT_HUBER * (2 * z - FIT_HUBER);
    }
    const double aic = fit_aic(&at, data, true, &noise);
    check_near(aic, expected, 1e-8);
}

/* The scale and the distances at the estimate, a minimum in theta that no place around has lower, and ends of intervals
 * where Q, least over lambda and the other coordinate, exceeds the minimum by the threshold */
static void check_fit(const struct fit_data *data, enum fit_curve curve)
{
    struct fit_estimate e;
    const size_t n = data->points;
    double log_determinant, distance[LINES_MAX];
    struct fit_distance found[LINES_MAX];
    fit_estimate_curve(&e, curve, data, false);
    const double freedom = (double)n - e.parameters;
    const double sum = solve_dense(&log_determinant, NULL, distance, curve, e.theta, e.ratio);
    const double least = dense_q(curve, e.theta, e.ratio, n);
    check_near(e.scale, sqrt(least / freedom), 1e-8);
    check_near(e.time_sigma_s, sqrt(sum / freedom), 1e-8);
    fit_distances(found, &e, data);
    for (size_t i = 0; i < fit_lines(data); i++) {
        const double expected = distance[found[i].line] / e.time_sigma_s;
        check(fabs(found[i].distance - expected) < 1e-7, "distance %.17g, expected %.17g", found[i].distance, expected);
    }
    const struct place p = {.e = &e, .n = n, .theta = {e.theta[0], e.theta[1]}, .log_ratio = log(e.ratio), .other = -1};
    for (int j = 0; j < e.parameters; j++) {
        const double width = e.interval[j][LEVEL_68].high - e.interval[j][LEVEL_68].low, h = 1e-3 * width;
        struct place above = p, below = p;
        if (!isfinite(width))
            continue;
        above.theta[j] += h;
        below.theta[j] -= h;
        const double q_above = q_at_ratio(above, p.log_ratio), q_below = q_at_ratio(below, p.log_ratio);
        const double offset = (q_below - q_above) / (q_below - 2 * least + q_above) / 2 * 1e-3;
        check(fabs(offset) < 1e-5, "theta_%d lies %g of its interval off", j, offset);
        for (int i = 0; i < 10; i++) {
            struct place other = p;
            for (int l = 0; l < e.parameters; l++)
                other.theta[l] += width * random_uniform(r, -3, 3);
            const double q = q_at_ratio(other, p.log_ratio + random_uniform(r, -5, 5));
            check(!(q < least * (1 - 1e-8)), "curve %d: %g at %g, %g is below %g at %g, %g", (int)curve, q,
                  other.theta[0], other.theta[1], least, e.theta[0], e.theta[1]);
        }
    }
    for (int end = 0; end < 4 * e.parameters; end++) {
        const int j = end / 4, level = end / 2 % 2;
        const struct fit_interval *const interval = &e.interval[j][level];
        struct place held = p;
        held.theta[j] = end % 2 ? interval->high : interval->low;
        if (!isfinite(held.theta[j]) || random_below(r, e.parameters > 1 ? 8 : 3) > 0)
            continue;
        double q;
        if (e.parameters > 1) {
            held.other = 1 - j;
            const struct fit_interval *const wide = &e.interval[1 - j][LEVEL_95];
            q = golden_section(q_of_theta, held, wide->low - (wide->high - wide->low),
                               wide->high + (wide->high - wide->low));
        } else {
            q = q_of_theta(held, 0);
        }
        const double t = student_quantile((enum distribution_level)level, n - (size_t)e.parameters);
        check_near(q - least, t * t * least / freedom, 1e-6);
    }
}

/* Sampled with 120 seeds, the largest differences are 5e-10 of the likelihood, 4e-9 of a distance and 1e-6 of an
 * interval in theta. Those of the likelihood are the fit's slopes, by differences with a step of 1e-4 in ln g. */
TEST(times_agree_with_dense_matrices)
{
    for (int draw = 0; draw < FIT_CURVES + 12; draw++) { /* a single drop often has two minima in lambda */
        const double sigma = random_log(r, 2e-5, 5e-4);
        const struct setting b = {.curve = draw < FIT_CURVES ? (enum fit_curve)draw : FIT_CONSTANT,
                                  .drops = draw < FIT_CURVES ? 6 : 1,
                                  .times = DROP_TIMES,
                                  .time_sigma_s = sigma,
                                  .eps_sigma = random_log(r, 0.1, 20) * sigma};
        struct fit_data data;
        draw_bounces(&data, &b, 3, 0, 0);
        for (int i = 0; i < 5; i++)
            check_likelihood(&data, b.curve);
        if (fit_curve_dry(b.curve) == b.curve) /* a loss of about 0 has many minima in lambda */
            check_fit(&data, b.curve);
        fit_data_clear(&data);
    }
}

/* ---- outliers ---- */

/* Of clean draws at most 2 of 100 name a line. An error of 12 sigma is named in 90 of 100, with its line; in 75 of 100
 * where bounces scatter, too. Four of 40 points that are 60 sigma too low do not hide one another. */
TEST(outliers_are_named)
{
    const int all = (int)few_or_all(30, 600);
    struct fit_request request = {.robust = false};
    assert_int_equal(fit_request_models(&request, "constant", NULL), STATUS_OK);
    for (int way = 0; way < 4; way++) { /* few points, many, times, and times of bounces that scatter */
        int named = 0, found = 0;
        const struct setting b = {
            .curve = FIT_CONSTANT, .drops = 10, .times = 8, .time_sigma_s = 1e-3, .eps_sigma = way == 3 ? 0.003 : 0};
        const int draws = way < 2 || all > 100 ? all : 10; /* a drop takes long */
        if (way > 1 && !in_turn((size_t)way, 2))
            continue;
        for (int draw = 0; draw < 2 * draws; draw++) {
            const bool planted = draw & 1;
            struct sample s;
            struct fit_data data;
            struct fit_outliers o;
            if (way < 2) {
                const size_t n = way == 0 ? 6 : 30, place = random_below(r, n);
                draw_sample(&s, FIT_CONSTANT, n, 0.01, false);
                for (size_t i = 0; i < n; i++)
                    s.point[i].line = (long)(10 + i);
                s.point[place].eps -= planted ? 12 * s.point[place].sigma : 0;
                fit_find_outliers(&o, &s.data, &request);
                found += planted && o.count == 1 && o.outlier[0].line == s.point[place].line &&
                         fabs(o.outlier[0].distance) > 4 && o.outlier[0].distance < 0;
            } else {
                const long late = 2 + (long)random_below(r, 80);
                draw_bounces(&data, &b, b.times, planted ? late : 0, 0.012);
                fit_find_outliers(&o, &data, &request);
                for (int i = 0; i < o.count; i++)
                    found += planted && o.outlier[i].line == late && o.outlier[i].distance > 4;
                fit_data_clear(&data);
            }
            named += !planted && o.count > 0;
            fit_data_clear(&o.rest);
        }
        if (all > 100) /* for docs/fit.md */
            print_message("way %d: %d of %d clean draws name a line, %d outliers found\n", way, named, draws, found);
        check(1 - lower_tail(draws, named - 1, 0.02) > 1e-6, "way %d: %d of %d name a line", way, named, draws);
        check(lower_tail(draws, found, way == 3 ? 0.75 : 0.9) > 1e-6, "way %d: %d of %d found", way, found, draws);
    }
    struct sample s;
    struct fit_outliers o;
    draw_sample(&s, FIT_CONSTANT, 40, 0.005, false);
    for (size_t i = 0; i < 40; i++) {
        s.point[i].line = (long)(i + 2);
        s.point[i].eps -= i % 12 == 3 ? 0.3 : 0;
    }
    fit_find_outliers(&o, &s.data, &request);
    assert_int_equal(o.count, 4);
    for (int i = 0; i < 4; i++)
        assert_true((o.outlier[i].line - 2) % 12 == 3 && fabs(o.outlier[i].distance + 60) < 30);
    fit_data_clear(&o.rest);
    /* Six points of unknown sigma: 5 sigma of the other five are no rare distance, 27 are one. */
    for (int far = 0; far < 2; far++) {
        static const double eps[] = {0.69, 0.71, 0.69, 0.71, 0.7};
        for (size_t i = 0; i < 6; i++)
            s.point[i].eps = i < 5 ? eps[i] : 0.7 - (far ? 27 : 5) * 0.01 * sqrt(1.2);
        s.data.points = 6;
        fit_find_outliers(&o, &s.data, &request);
        assert_int_equal(o.count, far);
        fit_data_clear(&o.rest);
    }
    /* A late time leaves out the three bounces that it belongs to; another one, named by chance, two or three more. */
    const struct setting drops = {.curve = FIT_CONSTANT, .drops = 10, .times = 6, .time_sigma_s = 1e-3};
    struct fit_data data;
    draw_bounces(&data, &drops, drops.times, 10, 0.08);
    fit_find_outliers(&o, &data, &request);
    const int fewer = (int)(data.points - o.rest.points);
    check(o.count >= 1 && fewer >= (o.count == 1 ? 3 : 2 * o.count), "%d outliers, %d points less", o.count, fewer);
    fit_data_clear(&data);
    fit_data_clear(&o.rest);
    /* Three of eight points are more than a fourth. */
    s.data = (struct fit_data){.points = 8, .point = s.point, .has_sigma = true};
    for (size_t i = 0; i < 8; i++)
        s.point[i] = (struct fit_point){.speed_m_s = 1, .eps = i < 5 ? 0.7 : 0.4, .sigma = 0.01, .line = (long)(i + 2)};
    fit_find_outliers(&o, &s.data, &request);
    assert_true(o.count <= 2);
    fit_data_clear(&o.rest);
}

/* Huber's mean of the points that are not out, or, with the bend at infinity, their weighted mean; w: all weights */
static double mean_of(double *w, const struct sample *s, const bool *out, double bend)
{
    double mean = 0.7;
    for (int round = 0; round < (isinf(bend) ? 1 : 200); round++) {
        double sum = *w = 0;
        for (size_t i = 0; i < s->data.points; i++) {
            const double z = fabs(s->point[i].eps - mean) / s->point[i].sigma;
            const double part = out[i] ? 0 : fmin(1, bend / z) * weight(s, i);
            *w += part;
            sum += part * s->point[i].eps;
        }
        mean = sum / *w;
    }
    return mean;
}

/* The rule of compare.h for points of a constant with given sigma, in closed forms: Huber's mean, weighted means, and
 * the distance of a point from the mean of the others. Given sigmas may be too small for the other points. */
static int name_outliers(bool *out, double *distance, const struct sample *s)
{
    const size_t n = s->data.points;
    size_t rest = n;
    double w;
    for (;;) { /* collect */
        const double mean = mean_of(&w, s, out, FIT_HUBER);
        double farthest_z = 0;
        size_t farthest = 0;
        for (size_t i = 0; i < n; i++) {
            const double z = fabs(s->point[i].eps - mean) / s->point[i].sigma;
            farthest = !out[i] && z > farthest_z ? i : farthest;
            farthest_z = out[i] ? farthest_z : fmax(farthest_z, z);
        }
        if (n - rest == FIT_MAX_OUTLIERS || (double)rest * erfc(farthest_z / sqrt(2)) > 0.05 || rest - 1 < 3 * n / 4)
            break;
        out[farthest] = true;
        rest--;
    }
    for (size_t back = n; rest < n; rest++) { /* put back */
        const double mean = mean_of(&w, s, out, INFINITY);
        double chi2 = 0;
        for (size_t i = 0; i < n; i++)
            chi2 += out[i] ? 0 : weight(s, i) * (s->point[i].eps - mean) * (s->point[i].eps - mean);
        const double spread = fmax(chi2 / (double)(rest - 1), 1);
        back = n;
        for (size_t i = 0; i < n; i++) {
            if (!out[i])
                continue;
            distance[i] = (s->point[i].eps - mean) / sqrt(s->point[i].sigma * s->point[i].sigma + 1 / w);
            const double tail = spread > 1 ? fisher_tail(distance[i] * distance[i] / spread, 1, rest - 1)
                                           : erfc(fabs(distance[i]) / sqrt(2));
            if ((double)n * tail >= FIT_SIGNIFICANCE && (back == n || fabs(distance[i]) < fabs(distance[back])))
                back = i;
        }
        if (back == n)
            break;
        out[back] = false;
    }
    return (int)(n - rest);
}

TEST(outliers_follow_closed_forms)
{
    struct fit_request request = {.robust = false};
    int lines[4] = {0}; /* draws that name none, one, two or more */
    assert_int_equal(fit_request_models(&request, "constant", NULL), STATUS_OK);
    for (int draw = 0; draw < 100; draw++) {
        const size_t n = 8 + random_below(r, 20);
        bool out[POINTS_MAX] = {false};
        double distance[POINTS_MAX];
        struct sample s;
        struct fit_outliers o;
        draw_sample(&s, FIT_CONSTANT, n, 0.01, true);
        for (size_t i = 0; i < n; i++) {
            s.point[i].line = (long)i + 1;
            s.point[i].eps += random_below(r, 5) ? 0 : random_uniform(r, -6, 6) * s.point[i].sigma;
            s.point[i].sigma *= draw % 2 ? 0.7 : 1;
        }
        const int count = name_outliers(out, distance, &s);
        fit_find_outliers(&o, &s.data, &request);
        check(o.count == count, "%d lines of %zu, expected %d", o.count, n, count);
        for (int i = 0; i < o.count; i++) {
            const struct fit_distance *const at = &o.outlier[i];
            check(out[at->line - 1] && fabs(at->distance - distance[at->line - 1]) < 1e-5, "line %ld, distance %g",
                  at->line, at->distance);
        }
        lines[count < 3 ? count : 3]++;
        fit_data_clear(&o.rest);
    }
    check(lines[0] && lines[1] && lines[2], "%d, %d, %d", lines[0], lines[1], lines[2]);
}

RUN_TESTS(quantiles_have_closed_forms, tails_have_closed_forms, a_scan_finds_the_same_minimum_and_intervals,
          two_parameters_have_the_least_squares, the_true_curve_ranks_first, aic_is_that_of_the_likelihood,
          intervals_hold_the_truth, elastic_data_have_no_upper_end, an_end_of_the_range_is_in_its_interval,
          points_are_in_the_order_of_speeds, flights_give_speeds_and_eps, times_agree_with_dense_matrices,
          outliers_are_named, outliers_follow_closed_forms)
