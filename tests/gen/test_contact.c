/* SPDX-License-Identifier: MIT */
/* gen/contact against an integration of the force in SI units, against textbook formulas, every way to give the
 * dissipation there and back, and every number of corgen contact --for put through its host's own conversion. */
#include "check.h"

#include "contact/contact_host.h"
#include "contact/contact_request.h"
#include "contact/contact_rows.h"
#include "cor/contact.h"
#include "cor/hertz_dashpot.h"
#include "cor/sphere.h"
#include "hosts/hosts.h"

static struct law law_named(const char *elastic, const char *damping)
{
    struct law law;
    assert_null(law_parse(&law, elastic, damping));
    return law;
}

/* ---- the force in SI units, integrated ---- */

struct motion {
    double mass, stiffness, coefficient, a, b;
};

static long double force_of(const struct motion *m, long double x, long double v)
{
    if (x <= 0)
        return m->b == 0 ? m->coefficient * v : 0;
    return m->stiffness * powl(x, m->a) + m->coefficient * powl(x, m->b) * v;
}

/* dF/dt */
static long double force_slope(const struct motion *m, long double x, long double v)
{
    const long double acceleration = -force_of(m, x, v) / m->mass;
    return m->stiffness * m->a * powl(x, m->a - 1) * v + m->coefficient * m->b * powl(x, m->b - 1) * v * v +
           m->coefficient * powl(x, m->b) * acceleration;
}

/* The place of the zero of the parabola through three places a step apart, in steps from the middle one */
static long double parabola_zero(long double before, long double at, long double after)
{
    const long double slope = (after - before) / 2, curvature = (after - 2 * at + before) / 2;
    long double s = -at / slope;
    for (int k = 0; k < 20; k++)
        s = -(at + curvature * s * s) / slope;
    return s;
}

/* The largest value of the cubic with the values y and the slopes d at both ends of a step */
static long double cubic_top(const long double y[2], const long double d[2], long double h)
{
    long double low = 0, high = 1, at = 0;
    for (int k = 0; k < 60; k++) {
        at = (low + high) / 2;
        const long double slope =
            6 * at * (1 - at) * (y[1] - y[0]) / h + (1 - at) * (1 - 3 * at) * d[0] - at * (2 - 3 * at) * d[1];
        *(slope > 0 ? &low : &high) = at;
    }
    return y[0] + at * at * (3 - 2 * at) * (y[1] - y[0]) + at * (1 - at) * ((1 - at) * d[0] - at * d[1]) * h;
}

static long double parabola_at(long double before, long double at, long double after, long double s)
{
    return at + (after - before) / 2 * s + (after - 2 * at + before) / 2 * s * s;
}

/* The classical Runge-Kutta method in s, t = T s^4, which is smooth at the start for exponents of quarters. Results go
 * to impact; its beta and NaN fields stay. */
static void integrate(struct contact_impact *impact, const struct motion *m, double speed, double unit)
{
    enum { STEPS = 12000 };
    const long double h = 2.6L / (double)STEPS;
    long double x[3] = {0}, v[3] = {speed, speed, speed}, f[3] = {0}, t[3] = {0};
    bool turned = false, released = false, ended = false;
    f[0] = f[1] = f[2] = force_of(m, 0, speed);
    impact->max_force_n = (double)f[2];
    for (long i = 0; i < STEPS && !ended; i++) {
        long double dx[4] = {0}, dv[4] = {0}, s = i * h;
        for (int k = 0; k < 4; k++) {
            const long double part = k == 0 ? 0 : k == 3 ? h : h / 2, r = s + part, scale = 4 * unit * r * r * r;
            const long double at = k == 0 ? x[2] : x[2] + part * dx[k - 1], u = k == 0 ? v[2] : v[2] + part * dv[k - 1];
            dx[k] = scale * u;
            dv[k] = -scale * force_of(m, at, u) / m->mass;
        }
        for (int k = 0; k < 2; k++) {
            x[k] = x[k + 1];
            v[k] = v[k + 1];
            f[k] = f[k + 1];
            t[k] = t[k + 1];
        }
        x[2] += h * (dx[0] + 2 * dx[1] + 2 * dx[2] + dx[3]) / 6;
        v[2] += h * (dv[0] + 2 * dv[1] + 2 * dv[2] + dv[3]) / 6;
        f[2] = force_of(m, x[2], v[2]);
        t[2] = unit * powl(s + h, 4);
        if (i < 2)
            continue;
        const long double dx2[2] = {4 * unit * powl(s, 3) * v[1], 4 * unit * powl(s + h, 3) * v[2]};
        const long double df2[2] = {force_slope(m, x[1], v[1]) * 4 * unit * powl(s, 3),
                                    force_slope(m, x[2], v[2]) * 4 * unit * powl(s + h, 3)};
        if (df2[0] > 0 && df2[1] <= 0)
            impact->max_force_n = fmax(impact->max_force_n, (double)cubic_top(&f[1], df2, h));
        if (!turned && v[2] < 0) {
            turned = true;
            impact->max_overlap_m = (double)cubic_top(&x[1], dx2, h);
        }
        if (turned && !released && f[2] < 0) {
            const long double zero = parabola_zero(f[0], f[1], f[2]);
            released = true;
            impact->eps[END_ZERO_FORCE] = (double)(-parabola_at(v[0], v[1], v[2], zero) / speed);
            impact->duration_s[END_ZERO_FORCE] = (double)parabola_at(t[0], t[1], t[2], zero);
        }
        if (x[2] <= 0) {
            /* from the last point of the contact on with the acceleration there */
            const long double late = x[1] / -v[1];
            ended = true;
            impact->eps[END_ZERO_OVERLAP] = (double)(-(v[1] - force_of(m, x[1], v[1]) / m->mass * late) / speed);
            impact->duration_s[END_ZERO_OVERLAP] = (double)(t[1] + late);
        }
    }
    assert_true(turned);
}

static void close_to(const char *what, double computed, double reference, double error)
{
    check(fabs(computed / reference - 1) <= error, "%s: %.15g, not %.15g", what, computed, reference);
}

static void impacts_against_integration(void **state)
{
    (void)state;
    static const struct {
        const char *elastic, *damping;
        double zeta_or_beta;
    } row[] = {{"3/2", "1/2", 0.3}, {"3/2", "1/2", 2}, {"1", "0", 0.2},   {"1", "0", 0.45},    {"3/2", "1/4", 0.4},
               {"3/2", "3/2", 1.5}, {"3/2", "0", 0.2}, {"3/2", "0", 0.7}, {"2", "1/2", 0.3},   {"2", "1", 1.1},
               {"1", "1", 2},       {"1", "1/2", 1},   {"1", "0", 0.8},   {"3/2", "1/4", 1.7}, {"3/2", "1/4", 1}};
    struct random_state random = random_start();
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const struct law law = law_named(row[i].elastic, row[i].damping);
        struct contact_model model = contact_model_of_law(&law);
        const double speed = random_log(&random, 0.01, 10);
        model.mass_kg = random_log(&random, 1e-6, 1);
        model.stiffness = random_log(&random, 1e3, 1e9);
        if (contact_model_is_constant(&model))
            model.damping = row[i].zeta_or_beta;
        else
            contact_model_set_beta(&model, row[i].zeta_or_beta, speed);
        const double a = (double)law.a.num / (double)law.a.den, b = (double)law.b.num / (double)law.b.den;
        const double unit = pow(model.mass_kg / model.stiffness, 1 / (a + 1)) * pow(speed, (1 - a) / (1 + a));
        const struct motion motion = {model.mass_kg, model.stiffness, contact_model_coefficient(&model), a, b};
        struct contact_impact got, want = {0};
        assert_int_equal(contact_model_impact(&got, &model, speed), 0);
        integrate(&want, &motion, speed, unit);
        print_message("x^%s, x^%s: force off by %.1e, overlap by %.1e\n", row[i].elastic, row[i].damping,
                      got.max_force_n / want.max_force_n - 1, got.max_overlap_m / want.max_overlap_m - 1);
        close_to("force", got.max_force_n, want.max_force_n, CONTACT_MODEL_MAX_ERROR / 10);
        close_to("overlap", got.max_overlap_m, want.max_overlap_m, CONTACT_MODEL_MAX_ERROR / 10);
        if (law_force_ends(&law)) {
            close_to("eps, zero force", got.eps[END_ZERO_FORCE], want.eps[END_ZERO_FORCE], 1e-9);
            close_to("duration, zero force", got.duration_s[END_ZERO_FORCE], want.duration_s[END_ZERO_FORCE], 1e-9);
        }
        if (want.duration_s[END_ZERO_OVERLAP] > 0) {
            close_to("eps, zero overlap", got.eps[END_ZERO_OVERLAP], want.eps[END_ZERO_OVERLAP], 1e-4);
            close_to("duration, zero overlap", got.duration_s[END_ZERO_OVERLAP], want.duration_s[END_ZERO_OVERLAP],
                     1e-6);
        }
        double eps;
        for (int end = 0; end < CONTACT_ENDS; end++)
            assert_true(contact_model_eps(&eps, &model, speed, (enum contact_end)end) == 0 &&
                        fabs(eps - got.eps[end]) <= 1e-14 * eps);
    }
}

/* ---- ways to give a contact ---- */

struct given {
    const char *name, *value;
};

static struct decimal *field_of(struct contact_request *request, const char *name)
{
    static const char *const own[CONTACT_NUMBERS] = {"restitution", "zeta", "plate-thickness"};
    for (int i = 0; i < CONTACT_NUMBERS; i++)
        if (strcmp(own[i], name) == 0)
            return &request->number[i];
    for (int i = 0; i < EMBED_NUMBERS; i++)
        if (strcmp(embed_number_names[i], name) == 0)
            return &request->scene.number[i];
    fail_msg("no option %s", name);
    return NULL;
}

static void request_set(struct contact_request *request, int law, int end, const struct given *given)
{
    *request = (struct contact_request){.law = law, .end = end};
    for (; given->name; given++)
        if (strcmp(given->name, "viscosity") == 0)
            request->viscosity = given->value;
        else
            decimal_set(field_of(request, given->name), given->value);
}

static void request_clear(struct contact_request *request)
{
    for (int i = 0; i < CONTACT_NUMBERS; i++)
        decimal_clear(&request->number[i]);
    for (int i = 0; i < EMBED_NUMBERS; i++)
        decimal_clear(&request->scene.number[i]);
}

static struct contact_models models_of(int law, int end, const struct given *given)
{
    struct contact_request request;
    struct contact_models models;
    request_set(&request, law, end, given);
    assert_int_equal(contact_request_models(&models, &request), 0);
    request_clear(&request);
    return models;
}

#define BODIES                                                                                                         \
    {"young", "7e10"}, {"poisson", "0.2"}, {"radius", "5e-3"},                                                         \
    {                                                                                                                  \
        "density", "2500"                                                                                              \
    }

static void every_way_of_a_sphere(void **state)
{
    (void)state;
    const struct given direct[] = {BODIES, {"dissipation-time", "5e-7"}, {NULL, NULL}};
    const struct contact_model model = models_of(EMBED_VISCOELASTIC, CONTACT_BOTH_ENDS, direct).model[0];
    /* by hand: m = (2/3) pi R^3 rho, R_eff = R/2, E* = E/(2 (1 - nu^2)), K = (4/3) E* sqrt(R_eff) */
    close_to("mass", model.mass_kg, 2.0 / 3 * 3.14159265358979323846 * 125e-9 * 2500, 1e-14);
    close_to("radius", model.radius_m, 2.5e-3, 1e-15);
    close_to("K", model.stiffness, 4.0 / 3 * 7e10 / (2 * 0.96) * sqrt(2.5e-3), 1e-14);
    close_to("A", contact_model_dissipation_time_s(&model), 5e-7, 1e-14);
    close_to("beta", contact_model_beta(&model, 3),
             1.5 * 5e-7 * pow(model.stiffness / model.mass_kg, 0.4) * pow(3, 0.2), 1e-14);
    struct contact_impact impact;
    assert_int_equal(contact_model_impact(&impact, &model, 3), 0);
    char text[4][DECIMAL_TEXT];
    decimal_text(text[0], contact_model_g_star_m_s(&model));
    decimal_text(text[1], impact.eps[0]);
    decimal_text(text[2], impact.eps[1]);
    decimal_text(text[3], contact_model_coefficient(&model));
    const struct given g_star[] = {BODIES, {"g-star", text[0]}, {NULL, NULL}};
    const struct given overlap[] = {BODIES, {"restitution", text[1]}, {"at", "3"}, {NULL, NULL}};
    const struct given force[] = {BODIES, {"restitution", text[2]}, {"at", "3"}, {NULL, NULL}};
    const struct given coefficient[] = {BODIES, {"damping-coefficient", text[3]}, {NULL, NULL}};
    const struct given viscosity[] = {BODIES, {"viscosity", "2e4,3e4"}, {NULL, NULL}};
    char beta_text[DECIMAL_TEXT];
    const struct given beta[] = {BODIES, {"beta", decimal_text(beta_text, impact.beta)}, {"at", "3"}, {NULL, NULL}};
    close_to("g*", models_of(0, -1, g_star).model[0].damping, model.damping, 1e-14);
    close_to("eps at zero overlap", models_of(0, END_ZERO_OVERLAP, overlap).model[0].damping, model.damping, 1e-14);
    close_to("eps at zero force", models_of(0, END_ZERO_FORCE, force).model[0].damping, model.damping, 1e-14);
    close_to("C", models_of(0, -1, coefficient).model[0].damping, model.damping, 1e-14);
    close_to("beta", models_of(0, -1, beta).model[0].damping, model.damping, 1e-14);
    const struct contact_model viscous = models_of(0, -1, viscosity).model[0];
    close_to("viscosity", contact_model_dissipation_time_s(&viscous),
             cor_dissipation_time_viscous_s(2e4, 3e4, 7e10, 0.2), 1e-14);
    /* eps without its end: an answer for each end */
    const struct contact_models both = models_of(0, CONTACT_BOTH_ENDS, overlap);
    assert_true(both.count == 2 && both.measured_end[1] == END_ZERO_FORCE);
    close_to("both", both.model[0].damping, model.damping, 1e-14);
    double eps;
    assert_int_equal(contact_model_eps(&eps, &both.model[1], 3, END_ZERO_FORCE), 0);
    close_to("both", eps, impact.eps[0], 1e-14);
    /* eps = 1 - (g/g*)^(1/5) for slow impacts */
    assert_int_equal(contact_model_eps(&eps, &model, 1e-20, END_ZERO_OVERLAP), 0);
    close_to("g*", 1 - eps, pow(1e-20 / contact_model_g_star_m_s(&model), 0.2), 1e-4);
}

static void other_laws(void **state)
{
    (void)state;
#define SPRING                                                                                                         \
    {"stiffness", "1e5"},                                                                                              \
    {                                                                                                                  \
        "effective-mass", "1e-3"                                                                                       \
    }
    const struct given linear[] = {SPRING, {"restitution", "0.7"}, {NULL, NULL}};
    const struct contact_models m = models_of(EMBED_LINEAR, END_ZERO_OVERLAP, linear);
    const double l = -log(0.7), pi = 3.14159265358979323846, zeta = l / sqrt(pi * pi + l * l);
    close_to("zeta", contact_model_zeta(&m.model[0]), zeta, 1e-14);
    close_to("C", contact_model_coefficient(&m.model[0]), 2 * zeta * sqrt(1e5 * 1e-3), 1e-14);
    struct contact_impact impact;
    assert_int_equal(contact_model_impact(&impact, &m.model[0], 2), 0);
    close_to("duration", impact.duration_s[0], pi / sqrt(1 - zeta * zeta) * sqrt(1e-3 / 1e5), 1e-14);
    assert_true(isnan(contact_model_g_star_m_s(&m.model[0])) && isnan(contact_model_dissipation_time_s(&m.model[0])));
    /* Zener's plate: A = m/(8 sqrt(B rho h)), the force is K x^(3/2) alone, and there is one end */
    const struct given plate[] = {BODIES, {"plate-thickness", "2e-3"}, {"density-2", "2700"}, {NULL, NULL}};
    const struct contact_model p = models_of(CONTACT_LAW_PLATE, CONTACT_BOTH_ENDS, plate).model[0];
    const double bending = 7e10 * 8e-9 / (12 * (1 - 0.04)), mass = 4 * pi / 3 * 125e-9 * 2500;
    close_to("A of the plate", contact_model_dissipation_time_s(&p), mass / (8 * sqrt(bending * 2700 * 2e-3)), 1e-13);
    assert_int_equal(contact_model_impact(&impact, &p, 1), 0);
    assert_true(isnan(impact.eps[END_ZERO_FORCE]) && isnan(impact.duration_s[END_ZERO_FORCE]));
    double no_eps, no_duration;
    assert_int_equal(contact_model_eps_duration(&no_eps, &no_duration, &p, 1, END_ZERO_FORCE), 0);
    assert_true(isnan(no_eps) && isnan(no_duration));
    close_to("force of the plate", impact.max_force_n, p.stiffness * pow(impact.max_overlap_m, 1.5), 1e-13);
    /* the inverse where only collisions are enclosed */
    const struct given power[] = {SPRING, {"restitution", "0.3"}, {"at", "0.5"}, {NULL, NULL}};
    struct contact_request request;
    request_set(&request, 0, END_ZERO_FORCE, power);
    request.scene.elastic = "2";
    request.scene.damping = "1";
    struct contact_models found;
    double eps;
    assert_int_equal(contact_request_models(&found, &request), 0);
    assert_int_equal(contact_model_eps(&eps, &found.model[0], 0.5, END_ZERO_FORCE), 0);
    close_to("inverse of (2, 1)", eps, 0.3, 1e-14);
    assert_int_equal(contact_model_set_eps(&found.model[0], 1, 0.5, END_ZERO_FORCE), 0);
    assert_true(found.model[0].damping == 0);
    request_clear(&request);
}

/* The time step is the least duration of all impacts over their number of steps, in whatever order they come. */
static void the_time_step_is_for_all_speeds(void **state)
{
    (void)state;
    enum { SPEEDS = 5, STEP_COLUMN = 8 };
    struct random_state random = random_start();
    const struct given measured[] = {BODIES, {"restitution", "0.7"}, {"at", "0.4"}, {NULL, NULL}};
    for (int ends = 1; ends <= 2; ends++) {
        const struct contact_models models =
            models_of(EMBED_VISCOELASTIC, ends == 2 ? CONTACT_BOTH_ENDS : END_ZERO_FORCE, measured);
        assert_int_equal(models.count, ends);
        double speed[SPEEDS], least = INFINITY;
        for (int i = 0; i < SPEEDS; i++)
            speed[i] = random_log(&random, 1e-3, 10);
        speed[2] = 20; /* of the shortest contacts, neither first nor last */
        for (int k = 0; k < ends; k++)
            for (int i = 0; i < SPEEDS; i++) {
                struct contact_impact impact;
                assert_int_equal(contact_model_impact(&impact, &models.model[k], speed[i]), 0);
                for (int end = 0; end < CONTACT_ENDS; end++)
                    least = fmin(least, impact.duration_s[end]);
            }
        struct table table;
        assert_int_equal(contact_rows(&table, &models, speed, SPEEDS, 40, 17), 0);
        for (int i = 0; i < SPEEDS * ends; i++)
            close_to("time step", strtod(table.cell[i * table.columns + STEP_COLUMN], NULL), least / 40, 1e-15);
        table_clear(&table);
    }
}

/* ---- --for: the lines, read again ---- */

/* Follows a line of a template along a line of the output; numbers of words are skipped, that of {n...} is kept. */
static bool line_matches(const char *template, const char *line, double *number)
{
    while (*template && *template != '\n') {
        if (*template == '{' && template[1] != '\n' && strchr(template, '}')) {
            char *end;
            const double value = strtod(line, &end);
            const char next = template[strcspn(template, "}") + 1];
            if (template[1] == 'n' && (template[2] == '}' || template[2] == '/'))
                *number = template[2] == '/' ? 2 * value : value;
            if (strncmp(template, "{root}", 6) == 0)
                *number = value * value;
            if (end == line || strncmp(template, "{spring}", 8) == 0) /* a word, as hertz, or a word and a number */
                for (end = (char *)line; *end && *end != next; end++)
                    ;
            if (strncmp(template, "{spring}", 8) == 0)
                for (end++; *end && *end != next; end++)
                    ;
            line = end;
            template = strchr(template, '}') + 1;
        } else if (*template ++ != *line++) {
            return false;
        }
    }
    return true;
}

/* The number of a row in the text; NaN if its lines are not there */
static double number_in_text(const struct host_model *row, const char *text)
{
    const char *template = strchr(row->paste, '|') + 1;
    char title[200];
    double number = NAN;
    snprintf(title, sizeof title, ": %s; made for", row->model);
    const char *const heading = strstr(text, title);
    if (!heading)
        return NAN;
    const char *const end = strstr(heading, "\n\n") ? strstr(heading, "\n\n") : heading + strlen(heading);
    for (; template && *template; template = strchr(template, '\n') ? strchr(template, '\n') + 1 : NULL)
        for (const char *line = heading; line && line < end && strstr(template, "{");
             line = strchr(line, '\n') ? strchr(line, '\n') + 1 : NULL) {
            double candidate = NAN;
            if (line_matches(template, line, &candidate) && !isnan(candidate))
                number = candidate;
        }
    return number;
}

/* eps of a law for the damping, at either end, by the functions of the library */
static double eps_of_damping(const struct host_model *row, double damping)
{
    if (row->law == HOST_SPHERE)
        return row->end == HOST_ZERO_FORCE ? cor_sphere_eps_zero_force(damping) : cor_sphere_eps_zero_overlap(damping);
    if (row->law == HOST_HERTZ_DASHPOT)
        return row->end == HOST_ZERO_FORCE ? cor_hertz_dashpot_eps_zero_force(damping)
                                           : cor_hertz_dashpot_eps_zero_overlap(damping);
    return host_eps(row->law, row->end, damping);
}

static size_t host_realises(const char *host, int law, const struct given *given, double eps, double speed)
{
    struct contact_request request;
    struct contact_models models;
    request_set(&request, law, CONTACT_BOTH_ENDS, given);
    assert_int_equal(contact_request_models(&models, &request), 0);
    char *const text = contact_host_text(host, &request, &models, &speed, 1);
    size_t found = 0;
    for (size_t i = 0; text && i < host_model_count; i++) {
        const struct host_model *const row = &host_models[i];
        if (!row->paste || (strcmp(row->host, host) != 0 && strcmp(host, "esys") != 0))
            continue;
        if (strcmp(host, "esys") == 0 && strcmp(row->host, "esys-particle") != 0)
            continue;
        const double number = number_in_text(row, text);
        if (isnan(number))
            continue;
        const struct host_scene scene = {models.model[0].mass_kg, models.model[0].stiffness, models.model[0].radius_m,
                                         speed};
        const double damping = row->damping_of_e ? row->damping_of_e(number) : row->damping_of_number(number, &scene);
        check(fabs(eps_of_damping(row, damping) - eps) < 1e-9, "%s, %s: %.12g gives eps %.12g, not %g", host,
              row->model, number, eps_of_damping(row, damping), eps);
        found++;
    }
    request_clear(&request);
    free(text);
    return found;
}

static void hosts_realise_what_is_wished(void **state)
{
    (void)state;
    static const struct {
        const char *host;
        size_t linear, tsuji, viscoelastic; /* models with lines for each law */
    } row[] = {{"lammps", 8, 4, 2},  {"liggghts", 4, 2, 2}, {"yade", 2, 2, 1},     {"mercurydpm", 1, 2, 1},
               {"chrono", 2, 1, 1},  {"mfix", 1, 1, 1},     {"openfoam", 0, 1, 1}, {"esys", 0, 1, 1},
               {"mujoco", 2, 0, 0},  {"drake", 1, 1, 1},    {"simbody", 1, 1, 1},  {"bullet", 1, 1, 0},
               {"rebound", 1, 1, 0}, {"modelica", 1, 0, 0}};
    const struct given spring[] = {SPRING, {"restitution", "0.7"}, {NULL, NULL}};
    const struct given bodies[] = {BODIES, {"restitution", "0.7"}, {NULL, NULL}};
    const struct given measured[] = {BODIES, {"restitution", "0.7"}, {"at", "0.4"}, {NULL, NULL}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const size_t linear = host_realises(row[i].host, EMBED_LINEAR, spring, 0.7, 0.4);
        const size_t tsuji = host_realises(row[i].host, EMBED_TSUJI, bodies, 0.7, 0.4);
        const size_t sphere = host_realises(row[i].host, EMBED_VISCOELASTIC, measured, 0.7, 0.4);
        check(linear == row[i].linear && tsuji == row[i].tsuji && sphere == row[i].viscoelastic,
              "%s: %zu linear, %zu Tsuji, %zu viscoelastic", row[i].host, linear, tsuji, sphere);
    }
    assert_int_equal(host_realises("drake", EMBED_HUNT_CROSSLEY, measured, 0.7, 0.4), 1);
    assert_int_equal(host_realises("lammps", EMBED_HERTZ_DASHPOT, measured, 0.7, 0.4), 2);
}

static double number_after(const char *text, const char *name, double otherwise)
{
    const char *const at = strstr(text, name);
    return at ? strtod(at + strlen(name), NULL) : otherwise;
}

/* The lines for Chrono's Hertz contact, put through ChContactSMC's force: kn R sqrt(x) x + gn m R sqrt(x) x', never
 * attractive. Type::BULLET takes the default for R, 0.1 m unless set; Type::MULTICORE computes R1 R2/(R1 + R2). */
static void chrono_finds_the_radius(void **state)
{
    (void)state;
    struct random_state random = random_start();
    for (int i = 0; i < 8; i++) {
        const double r1 = random_log(&random, 1e-4, 0.3), r2 = random_log(&random, 1e-4, 0.3);
        const double e = random_uniform(&random, 0.2, 0.97), speed = random_log(&random, 0.01, 5);
        char text[5][DECIMAL_TEXT];
        const struct given bodies[] = {{"young", decimal_text(text[0], random_log(&random, 1e6, 1e11))},
                                       {"poisson", "0.3"},
                                       {"density", "2500"},
                                       {"radius", decimal_text(text[1], r1)},
                                       {"radius-2", decimal_text(text[2], r2)},
                                       {"restitution", decimal_text(text[3], e)},
                                       {"at", decimal_text(text[4], speed)},
                                       {NULL, NULL}};
        struct contact_request request;
        struct contact_models models;
        request_set(&request, EMBED_VISCOELASTIC, END_ZERO_FORCE, bodies);
        assert_int_equal(contact_request_models(&models, &request), 0);
        char *const lines = contact_host_text("chrono", &request, &models, &speed, 1);
        assert_non_null(lines);
        const double kn = number_after(lines, "SetKn(", NAN), gn = number_after(lines, "SetGn(", NAN);
        const double found[] = {number_after(lines, "SetDefaultEffectiveCurvatureRadius(", 0.1), r1 * r2 / (r1 + r2)};
        const double mass = models.model[0].mass_kg;
        for (int k = 0; k < 2; k++) {
            const double stiffness = kn * found[k];
            const struct motion motion = {mass, stiffness, gn * mass * found[k], 1.5, 0.5};
            struct contact_impact impact = {0};
            integrate(&impact, &motion, speed, pow(mass / stiffness, 0.4) * pow(speed, -0.2));
            check(fabs(impact.eps[END_ZERO_FORCE] - e) < 1e-8, "Chrono with R = %g realises %.9g, not %.9g", found[k],
                  impact.eps[END_ZERO_FORCE], e);
        }
        free(lines);
        request_clear(&request);
    }
}

/* Every host of the list has lines, a version and a comment. */
static void the_list_is_whole(void **state)
{
    (void)state;
    static const char *const host[] = {"lammps", "liggghts", "yade",  "mercurydpm", "chrono", "mfix",    "openfoam",
                                       "esys",   "mujoco",   "drake", "simbody",    "bullet", "rebound", "modelica"};
    char *text = NULL;
    size_t size;
    FILE *const file = open_memstream(&text, &size);
    contact_host_list(file);
    fclose(file);
    for (size_t i = 0; i < sizeof host / sizeof *host; i++) {
        char line[40];
        assert_int_equal(contact_host_check(host[i]), 0);
        snprintf(line, sizeof line, "%s\n    ", host[i]);
        assert_non_null(strstr(text, line));
    }
    free(text);
    assert_int_equal(contact_host_check("kratos"), 2); /* in the table, without lines */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(impacts_against_integration),
        cmocka_unit_test(every_way_of_a_sphere),
        cmocka_unit_test(other_laws),
        cmocka_unit_test(the_time_step_is_for_all_speeds),
        cmocka_unit_test(hosts_realise_what_is_wished),
        cmocka_unit_test(chrono_finds_the_radius),
        cmocka_unit_test(the_list_is_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
