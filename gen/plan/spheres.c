/* SPDX-License-Identifier: MIT */
/* Compares models of eps for viscoelastic spheres and bodies of other laws, from published formulas to corgen's
 * headers. Enclosed collisions are the reference. */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "approximation/pade.h"
#include "cor/contact.h"
#include "cor/law.h"
#include "cor/sphere.h"
#include "embed/form.h"
#include "enclosure/collision.h"
#include "plan/plan.h"
#include "support/console.h"
#include "support/decimal.h"
#include "support/formula.h"
#include "support/local.h"
#include "support/parallel.h"

/* For this beta and above, eps at zero overlap is h*^5 beta^-5 with relative error 2^-60. */
#define OVERLAP_FAR 7.0
#define BETA_LIMIT 1e6
#define LEAST_TOLERANCE 1e-15
enum { TRUTH_BITS = 64, PADE_BITS = 320, PADE_POINTS = 4096, ROOT_REFINEMENT = 2, TEXT = 1024 };
/* Error of beta in half ulps, if a caller writes factor * pow(speed, q) */
#define ROUNDINGS_OF_BETA 2.0

/* Nanoseconds of a single call, and of an element in a loop, measured once. bench/run spheres measured the published
 * formulas and the library. docs/plan.md describes the other measurements. */
static const double cost_published[USES] = {14.6, 14.6}, cost_mueller[USES] = {12.3, 12.3}, cost_power[USES] = {11, 11},
                    cost_simple[USES] = {66, 66}, cost_library[USES] = {4.4, 2.2}, cost_constant[USES] = {0, 0},
                    cost_crossley[USES] = {32, 19}, cost_function[USES] = {17, 17}, cost_pressed[USES] = {5e4, 5e4};

struct spheres {
    struct plan *plan;
    const struct embed_request *request, *with_force;
    const struct cor_scene_contact *contact, *pressed;
    struct embed_scene scene, pressed_scene; /* without and with the constant force */
    struct embed_form form[FAMILIES];
    arb_t h_star;        /* of spheres */
    arb_t force, damped; /* at 1 m/s: the force in units of m g/T, and beta with this force */
    double *other;       /* eps at the other end of contact, at every point */
    double *bare;        /* eps without the constant force */
    atomic_bool failed;
};

static bool is_pressed(const struct spheres *s)
{
    return s->pressed->force_n > 0;
}

/* True if eps is the same at every speed */
static bool is_constant(const struct spheres *s)
{
    return s->scene.constant && !(is_pressed(s) && s->pressed->damping > 0);
}

/* ---- the collisions ---- */

static int other_end(const struct spheres *s)
{
    return s->scene.end == COR_END_ZERO_FORCE ? COR_END_ZERO_OVERLAP : COR_END_ZERO_FORCE;
}

/* Replaces the eps of a collision by its eps under the constant force. */
static int press_point(struct collision *c, const struct spheres *s, double speed_m_s)
{
    const struct cor_exponents *const law = &s->scene.law;
    const struct ratio a = law_elastic(law), q = law_speed_exponent(law);
    LOCAL(arb, speed, beta, force);
    arb_set_d(speed, speed_m_s);
    LET(beta, EMBED_BITS, "s->damped*speed^q", s->damped, speed, q);
    LET(force, EMBED_BITS, "s->force*speed^(-2*a/(a + 1))", s->force, speed, a);
    return collision_solve_pressed(c, beta, force, law, COR_BOTH_ENDS, TRUTH_BITS);
}

/* Computes eps at one point, for both ends of contact. */
static void collide_point(void *context, slong i)
{
    struct spheres *const s = context;
    const struct cor_exponents *const law = &s->scene.law;
    LOCAL(arb, beta);
    LOCAL_INIT(collision, c, (&c));
    arb_set_d(beta, s->plan->speed[i]);
    embed_scene_beta(beta, &s->scene, beta, false);
    int status = 0;
    if (arb_is_zero(beta)) {
        arb_one(c.eps_zero_overlap);
        arb_one(c.eps_zero_force);
    } else if (ball_middle(beta) < OVERLAP_FAR || !law_is_sphere(law)) {
        status = collision_solve(&c, beta, law, TRUTH_BITS);
    } else {
        status = collision_solve_force(&c, beta, law, TRUTH_BITS);
        LET(c.eps_zero_overlap, EMBED_BITS, "(s->h_star/beta)^5", s->h_star, beta);
    }
    s->plan->at[i] = ball_middle(beta);
    s->bare[i] = ball_middle(s->scene.end == COR_END_ZERO_OVERLAP ? c.eps_zero_overlap : c.eps_zero_force);
    if (status == 0 && is_pressed(s))
        status = press_point(&c, s, s->plan->speed[i]);
    if (status != 0)
        atomic_store(&s->failed, true);
    const double eps[] = {ball_middle(c.eps_zero_overlap), ball_middle(c.eps_zero_force)};
    s->plan->truth[i] = eps[s->scene.end];
    s->other[i] = eps[other_end(s)];
}

static int find_truth(struct spheres *s)
{
    int status = STATUS_OK;
    for (slong i = 0; i < s->plan->points && s->scene.own.law; i++)
        s->plan->truth[i] = own_law_value(&s->scene.own, s->plan->at[i] = s->plan->speed[i]);
    if (s->scene.own.law)
        return status;
    s->other = xmalloc(2 * (size_t)s->plan->points * sizeof *s->other);
    s->bare = s->other + s->plan->points;
    LOCAL(arb, yield_speed, liquid_speed);
    if (is_pressed(s))
        status = embed_contact_numbers(s->damped, s->force, yield_speed, liquid_speed, s->with_force, s->pressed,
                                       EMBED_BITS);
    if (status == STATUS_OK && s->scene.beta_max >= OVERLAP_FAR && law_is_sphere(&s->scene.law))
        status = collision_h_star(s->h_star, TRUTH_BITS);
    if (status == STATUS_OK)
        parallel_for(collide_point, s, s->plan->points, "collisions at the points");
    return status == STATUS_OK && !atomic_load(&s->failed) ? STATUS_OK : STATUS_FAILED;
}

/* ---- models ---- */

static double eps_horner(const double *c, slong degree, double z)
{
    double y = c[degree];
    while (degree > 0)
        y = z * y + c[--degree];
    return y;
}

/* Returns the quotient of polynomials of degrees m and n. */
static double eps_quotient(const double *c, slong m, slong n, double z)
{
    return eps_horner(c, m, z) / eps_horner(c + m + 1, n, z);
}

/* [1/4] of Mueller and Poeschel 2011; zero force */
static double eps_mueller_poeschel(double beta)
{
    const double v = sqrt(beta);
    return (1 + 0.501086 * v) / (1 + v * (0.501086 + v * (1.15345 + v * (0.577977 + v * 0.532178))));
}

static double speed_exponent(const struct spheres *s)
{
    return ratio_double(law_speed_exponent(&s->scene.law));
}

static void model_takes_force(const struct spheres *s, struct plan_model *m, const double *cost, const char *leaves_out,
                              char *use)
{
    plan_model_is(s->plan, m, embed_cost(cost, s->request->purpose), leaves_out, use);
}

static void model_is(const struct spheres *s, struct plan_model *m, const double *cost, const char *leaves_out,
                     char *use)
{
    model_takes_force(s, m, cost, is_pressed(s) ? "the constant force" : leaves_out, use);
}

/* Sets values and error of a library function without calling it. The error is its bound, or the effect of a neglected
 * constant force. */
static void model_promise(const struct spheres *s, struct plan_model *m, double error)
{
    for (slong i = 0; i < s->plan->points; i++) {
        m->value[i] = s->bare[i];
        m->error[i] = error;
    }
    m->promised = !is_pressed(s);
}

/* Returns x rounded to ten digits, so that the evaluated number is the printed one. */
static double ten_digits(double x)
{
    char text[DECIMAL_TEXT];
    snprintf(text, sizeof text, "%.10g", x);
    return strtod(text, NULL);
}

static void add_constants(const struct spheres *s)
{
    struct plan *const plan = s->plan;
    const slong last = plan->points - 1;
    const bool constant = is_constant(s);
    for (int measured = 0; measured < (constant ? 1 : 2); measured++) {
        double low = plan->truth[0], high = low;
        for (slong i = 1; i <= last; i++) {
            low = fmin(low, plan->truth[i]);
            high = fmax(high, plan->truth[i]);
        }
        /* the constant 2 low high/(low + high) has the smallest relative error */
        struct plan_model *m = plan_add(plan, measured ? "constant eps of the middle speed" : "constant eps");
        const double best = high > 0 ? 2 * low * high / (low + high) : 0;
        const double eps = constant ? low : ten_digits(measured ? plan->truth[last / 2] : best);
        for (slong i = 0; i <= last; i++)
            m->value[i] = eps;
        model_takes_force(s, m, cost_constant,
                          constant                            ? "nothing; eps is the same at every speed"
                          : is_pressed(s) || s->scene.own.law ? "the dependence of eps on the speed"
                          : speed_exponent(s) < 0             ? "the rise of eps with the speed"
                                                              : "the fall of eps with the speed",
                          xprintf(constant ? "double eps = %.17g;\n" : "double eps = %.10g;\n", eps));
    }
}

/* Adds eps = a g^-b. -b is the slope of the line between the ends of ln eps(ln g). It is the best slope, because the
 * function is concave. eps g^b ranges from e^low to e^high, and a is the harmonic mean of these two numbers, which
 * gives the smallest relative error. */
static void add_power_law(const struct spheres *s)
{
    struct plan *const plan = s->plan;
    const slong last = plan->points - 1;
    if (!(plan->truth[0] > 0 && plan->truth[last] > 0)) /* the bodies stay together */
        return;
    struct plan_model *m = plan_add(plan, "power law min(1; a speed^-b)");
    const double slope = log(plan->truth[0] / plan->truth[last]) / log(plan->speed[last] / plan->speed[0]);
    double low = (double)INFINITY, high = -(double)INFINITY;
    for (slong i = 0; i <= last; i++) {
        const double rest = log(plan->truth[i]) + slope * log(plan->speed[i]);
        low = fmin(low, rest);
        high = fmax(high, rest);
    }
    const double a = ten_digits(2 / (exp(-low) + exp(-high))), b = ten_digits(slope);
    for (slong i = 0; i <= last; i++)
        m->value[i] = fmin(1, a * pow(plan->speed[i], -b));
    model_takes_force(s, m, cost_power,
                      speed_exponent(s) < 0 || is_pressed(s) || s->scene.own.law
                          ? "the curvature of ln(eps)"
                          : "the curvature of ln(eps); eps = 1 at rest",
                      xprintf("double eps = fmin(1, %.10g * pow(speed, %.10g));\n", a, -b));
}

/* Returns C statements that define `contact`. */
static char *contact_text(const struct spheres *s)
{
    const struct embed_request *const scene = s->request;
    static const char init[] = "struct cor_sphere_contact contact;\ncor_sphere_contact_init_g_star(&contact, %s);\n";
    char g_star[DECIMAL_TEXT];
    if (scene->number[COR_SCENE_G_STAR].text)
        return xprintf(init, scene->number[COR_SCENE_G_STAR].text);
    if (!embed_given(scene, COR_SCENE_YOUNG) || !embed_given(scene, COR_SCENE_DISSIPATION_TIME) ||
        scene->law == COR_LAW_PLATE)
        return xprintf(init, decimal_text(g_star, cor_scene_damping(s->contact, COR_SCENE_G_STAR)));
    char body[2][TEXT];
    for (int second = 0; second < 2; second++) {
        const char *text[COR_SCENE_BODY];
        for (int i = 0; i < COR_SCENE_BODY; i++)
            text[i] = embed_number_of_body(scene, COR_SCENE_YOUNG + i, second + 1)->text;
        enum { YOUNG, POISSON, RADIUS, DENSITY, MASS, TIME };
        if (second && scene->wall)
            snprintf(body[second], TEXT, "{%s, %s, %s, INFINITY, INFINITY}", text[YOUNG], text[POISSON], text[TIME]);
        else if (!embed_mass_is_given(scene, second + 1))
            snprintf(body[second], TEXT, "{%s, %s, %s, %s, cor_sphere_mass_kg(%s, %s)}", text[YOUNG], text[POISSON],
                     text[TIME], text[RADIUS], text[RADIUS], text[DENSITY]);
        else
            snprintf(body[second], TEXT, "{%s, %s, %s, %s, %s}", text[YOUNG], text[POISSON], text[TIME], text[RADIUS],
                     text[MASS]);
    }
    return xprintf("struct cor_body body_1 = %s;\nstruct cor_body body_2 = %s;\n"
                   "struct cor_sphere_contact contact;\ncor_sphere_contact_init(&contact, &body_1, &body_2);\n",
                   body[0], body[1]);
}

/* Returns C statements that compute eps by a call. after: lines after the call */
static char *call_of_beta(const struct spheres *s, const char *call, const char *after)
{
    char *contact = contact_text(s);
    char *text = xprintf("#include \"cor/cor.h\"\n%sdouble eps = %s;\n%s", contact, call, after);
    free(contact);
    return text;
}

static void add_published(const struct spheres *s)
{
    struct plan *const plan = s->plan;
    static const struct {
        const char *name, *leaves_out, *call, *after;
        double (*eps)(double beta);
        const double *cost;
    } published[] = {{"simple theory (27)", "C_3 and all later terms",
                      "cor_sphere_eps_simple(cor_contact_beta(&contact, speed))", "", cor_sphere_eps_simple,
                      cost_simple},
                     {"Pade [1/4] as printed in 1999 (35)", "a_3 and all later terms; zero force",
                      "cor_sphere_eps_published_pade(cor_contact_beta(&contact, speed))", "",
                      cor_sphere_eps_published_pade, cost_published},
                     {"Pade [1/4] as printed in 2011", "all terms above beta^(5/2); zero overlap",
                      "(1 + 0.501086*v)/(1 + v*(0.501086 + v*(1.15345 + v*(0.577977 + v*0.532178))))",
                      "/* v = sqrt(cor_contact_beta(&contact, speed)) */\n", eps_mueller_poeschel, cost_mueller}};
    for (size_t i = 0; i < sizeof published / sizeof *published; i++) {
        struct plan_model *const m = plan_add(plan, "%s", published[i].name);
        for (slong k = 0; k < plan->points; k++)
            m->value[k] = published[i].eps(plan->at[k]);
        model_is(s, m, published[i].cost, published[i].leaves_out,
                 call_of_beta(s, published[i].call, published[i].after));
    }
}

/* Adds f in doubles. The model is `outside` unless the denominator of f is positive at PADE_POINTS + 1 points. */
static void add_pade(const struct spheres *s, const struct pade *f, slong root, bool two_point)
{
    struct plan *const plan = s->plan;
    const slong m = f->numerator, n = f->denominator;
    struct plan_model *model = plan_add(plan, "%s [%ld/%ld]", two_point ? "two-point Pade" : "Pade", (long)m, (long)n);
    double *const c = xmalloc((size_t)(m + n + 2) * sizeof *c);
    LOCAL(arb, x);
    for (slong k = 0; k <= m + n + 1; k++) {
        arb_poly_get_coeff_arb(x, k <= m ? f->p : f->q, k <= m ? k : k - m - 1);
        c[k] = ball_middle(x);
    }
    struct embed_form form = {.variable = root == 2 ? TENTH_ROOT_OF_SPEED : FIFTH_ROOT_OF_SPEED,
                              .numerator = m,
                              .denominator = n,
                              .refinement = ROOT_REFINEMENT,
                              .number = c};
    embed_form_price(&form);
    const double low = plan->at[0], high = plan->at[plan->points - 1];
    for (int k = 0; k <= PADE_POINTS; k++) {
        const double beta = low + (high - low) * k / (double)PADE_POINTS;
        model->outside = model->outside || !(eps_horner(c + m + 1, n, root == 2 ? sqrt(beta) : beta) > 0);
    }
    for (slong i = 0; i < plan->points; i++)
        model->value[i] = eps_quotient(c, m, n, root == 2 ? sqrt(plan->at[i]) : plan->at[i]);
    free(c);
    model_is(s, model, form.cost,
             two_point ? "terms between series and limit"
                       : (root == 2 ? "all after sqrt(beta)^(m+n)" : "C_(m+n+1) and all later terms"),
             xprintf("corgen pade --numerator %ld --denominator %ld%s --end %s --force --header pade.h\n"
                     "/* arrays cor_sphere_pade_%s%s_%ld_%ld_p and _q: eps = P(z)/Q(z), z = %s */\n",
                     (long)m, (long)n, two_point ? " --two-point" : "", contact_end_options[s->scene.end],
                     two_point ? "two_point_" : "", contact_end_names[s->scene.end], (long)m, (long)n,
                     root == 2 ? "sqrt(beta)" : "beta"));
}

static void add_pades(const struct spheres *s)
{
    static const slong ordinary[][2] = {{1, 4}, {2, 3}, {3, 5}, {4, 6}, {6, 9}, {8, 12}, {10, 15}};
    static const slong two_point[] = {2, 4, 8};
    LOCAL_INIT(pade, f, (&f));
    for (size_t i = 0; i < sizeof ordinary / sizeof *ordinary; i++)
        if (pade_of_series(&f, s->scene.series, ordinary[i][0], ordinary[i][1], PADE_BITS))
            add_pade(s, &f, s->scene.series_root, false);
    if (s->scene.end == COR_END_ZERO_OVERLAP)
        for (size_t i = 0; i < sizeof two_point / sizeof *two_point; i++)
            if (pade_two_point_of_series(&f, s->scene.series, s->scene.h_star_5, two_point[i], PADE_BITS))
                add_pade(s, &f, s->scene.series_root, true);
}

static void add_header(const struct spheres *s, const char *tolerance)
{
    const enum embed_family chosen = embed_choose(s->form, s->request->purpose);
    if (chosen == FAMILIES)
        return;
    const struct embed_form *f = &s->form[chosen];
    const struct embed_scene *const scene = is_pressed(s) ? &s->pressed_scene : &s->scene;
    char size[PLAN_NAME];
    embed_form_size(size, sizeof size, f);
    struct plan_model *m = plan_add(s->plan, "header: %s %s", embed_family_name(chosen, scene), size);
    for (char *c = m->name; *c; c++)
        *c = (char)(*c == ',' ? ';' : *c);
    m->elsewhere = f->error;
    for (slong i = 0; i < s->plan->points; i++)
        m->value[i] = embed_form_value(f, s->plan->speed[i] - scene->origin, false);
    struct embed_request request = *s->with_force;
    request.number[EMBED_TOLERANCE].text = tolerance;
    char *const options = embed_options(&request, INT_MAX);
    model_takes_force(s, m, f->cost, "speeds outside the range",
                      xprintf("corgen embed%s%s --for %s --output cor_scene_eps.h\n"
                              "#include \"cor_scene_eps.h\"\ndouble eps = cor_scene_eps(speed);\n",
                              options, embed_end_option(&request), embed_purpose_names[request.purpose]));
    free(options);
}

/* Adds the library with its promised bound. corgen, which computes its tables, cannot call it. */
static void add_library(const struct spheres *s)
{
    struct plan *const plan = s->plan;
    struct plan_model *m = plan_add(plan, "library: cor_contact_eps_%s", contact_end_names[s->scene.end]);
    const double promise =
        COR_CONTACT_EPS_MAX_ERROR(s->scene.slope) + s->scene.slope * COR_CONTACT_MAX_ULP * DBL_EPSILON;
    char call[TEXT];
    snprintf(call, sizeof call, "cor_contact_eps_%s(&contact, speed)", contact_end_names[s->scene.end]);
    model_promise(s, m, promise);
    model_is(s, m, cost_library, "nothing; valid at every speed", call_of_beta(s, call, ""));
}

/* Adds a function of beta: cor_law_value for the Hertz dashpot and Hunt-Crossley's law, otherwise the header of corgen
 * law. The error is its bound plus the effect of rounding beta, because the caller computes beta from the speed. */
static void add_function_of_beta(const struct spheres *s)
{
    struct plan *const plan = s->plan;
    const struct cor_exponents *law = &s->scene.law;
    const bool dashpot = law_elastic(law).num == 3 && law_elastic(law).den == 2 && law_damping(law).num == 0,
               crossley = law_is_hunt_crossley(law);
    const double q = speed_exponent(s), per_beta = s->scene.slope / (5 * fabs(q));
    const struct cor_law_function *const f =
        cor_law_function(crossley ? COR_LAW_HUNT_CROSSLEY : COR_LAW_HERTZ_DASHPOT, (enum cor_end)s->scene.end, COR_EPS);
    const double ulp = dashpot || crossley ? f->max_ulp : 1;
    char call[TEXT];
    if (dashpot || crossley)
        snprintf(call, sizeof call, "cor_law_value(COR_LAW_%s, COR_END_ZERO_%s, COR_EPS, ",
                 dashpot ? "HERTZ_DASHPOT" : "HUNT_CROSSLEY",
                 s->scene.end == COR_END_ZERO_OVERLAP ? "OVERLAP" : "FORCE");
    else
        snprintf(call, sizeof call, "law_eps_%s(", contact_end_names[s->scene.end]);
    struct plan_model *m = dashpot || crossley
                               ? plan_add(plan, "library: %s", f->name)
                               : plan_add(plan, "corgen law: law_eps_%s", contact_end_names[s->scene.end]);
    model_promise(s, m, (ulp + per_beta * ROUNDINGS_OF_BETA) * DBL_EPSILON);
    char *beta = arb_get_str(s->scene.beta_per_root, 17, ARB_STR_NO_RADIUS), *source;
    if (dashpot || crossley)
        source = xprintf("#include \"cor/cor.h\"");
    else
        source = xprintf("corgen law --elastic %s --damping %s --name law --output law.h\n#include \"law.h\"",
                         ratio_text(law_elastic(law)).text, ratio_text(law_damping(law)).text);
    model_is(s, m, crossley ? cost_crossley : cost_function, "nothing; valid at every speed",
             xprintf("%s\ndouble eps = %s%s * pow(speed, %.17g));\n", source, call, beta, q));
    free(source);
    flint_free(beta);
}

/* Adds cor_scene_eps to the plan of contacts under the constant force. This function integrates collisions, and bounds
 * the absolute error of eps^2. */
static void add_pressed(const struct spheres *s)
{
    const struct cor_scene_contact *const c = s->pressed;
    struct plan_model *const m = plan_add(s->plan, "library: cor_scene_eps");
    for (slong i = 0; i < s->plan->points; i++) {
        const double eps = s->plan->truth[i];
        m->value[i] = eps;
        m->error[i] = eps > 0 ? COR_SCENE_PRESSED_ERROR / (2 * eps * eps) : 0;
    }
    m->promised = true;
    model_takes_force(s, m, cost_pressed, "nothing; valid at every speed",
                      xprintf("#include \"cor/scene.h\"\nstruct cor_scene_contact contact = {.law = {%d, %d, %d}, "
                              ".mass_kg = %.17g,\n    .stiffness = %.17g, .radius_m = %.17g, .damping = %.17g, "
                              ".force_n = %.17g};\ndouble eps;\ncor_scene_eps(&eps, &contact, speed, %s);\n",
                              c->law.elastic, c->law.damping, c->law.denominator, c->mass_kg, c->stiffness,
                              isnan(c->radius_m) ? 0 : c->radius_m, c->damping, c->force_n,
                              s->scene.end == COR_END_ZERO_OVERLAP ? "COR_END_ZERO_OVERLAP" : "COR_END_ZERO_FORCE"));
}

static void add_other_end(const struct spheres *s)
{
    struct plan *const plan = s->plan;
    const int end = contact_end_named(other_end(s), is_pressed(s));
    struct plan_model *m = plan_add(plan, "the other end: %s", contact_end_options_pressed[end]);
    memcpy(m->value, s->other, (size_t)plan->points * sizeof *m->value);
    model_takes_force(s, m, is_pressed(s) ? cost_pressed : cost_library, "the end of contact", NULL);
    m->shown = true;
}

/* ---- remarks on effects outside the models: lines that end with \n, malloc'ed ---- */

enum { SCAN = 200, BISECTIONS = 30 };

/* True if the force changes eps by at most the tolerance. False also if a collision cannot be solved. */
static bool may_go(const struct cor_scene_contact *pressed, int end, double tolerance, double speed)
{
    struct cor_scene_contact without_force = *pressed;
    double with, without;
    without_force.force_n = 0;
    return cor_scene_eps(&with, pressed, speed, end) == COR_FAULT_NONE &&
           cor_scene_eps(&without, &without_force, speed, end) == COR_FAULT_NONE &&
           fabs(with / without - 1) <= tolerance;
}

/* Returns a remark on the speed above which gravity or adhesion (force_n > 0) may be omitted. Tests 201 speeds of the
 * range, from the largest down. */
static char *pressing_remark(const struct spheres *s)
{
    const struct cor_scene_contact *const contact = s->pressed;
    const int end = (int)s->scene.end;
    const double tolerance = s->plan->tolerance, speed_max = s->scene.speed_max;
    const double ratio = pow(s->scene.speed_min / speed_max, 1.0 / (double)SCAN);
    const double sticking = cor_scene_sticking_speed(contact, end);
    char *where;
    int k = 0;
    while (k <= SCAN && may_go(contact, end, tolerance, speed_max * pow(ratio, k)))
        k++;
    if (k == 0) {
        where = xprintf("only above this range of speeds");
    } else if (k > SCAN) {
        where = xprintf("at every speed of this range");
    } else {
        double low = speed_max * pow(ratio, k), high = low / ratio;
        for (int i = 0; i < BISECTIONS; i++) {
            const double middle = sqrt(low * high);
            *(may_go(contact, end, tolerance, middle) ? &high : &low) = middle;
        }
        where = xprintf("for %.4g m/s and above", high);
    }
    char *text = xprintf("You may leave out the constant force of %.4g N %s: eps then changes by less than %g.\nWith "
                         "the force, the bodies stick together at speeds up to %.4g m/s.\n",
                         contact->force_n, where, tolerance, sticking);
    free(where);
    return text;
}

char *plan_wave_remark(const struct embed_request *request, double speed, double eps)
{
    struct cor_scene scene;
    struct cor_sphere_contact contact;
    if (!request->wall || embed_given(request, COR_SCENE_G_STAR) || !embed_given(request, COR_SCENE_YOUNG) ||
        embed_request_scene(&scene, request) != STATUS_OK)
        return NULL;
    const struct cor_body sphere = cor_scene_body(&scene, 1), wall = cor_scene_body(&scene, 2);
    const struct cor_half_space half_space = {wall.young_modulus_pa, wall.poisson_ratio,
                                              sphere.mass_kg / cor_sphere_mass_kg(sphere.radius_m, 1)};
    cor_sphere_contact_init(&contact, &sphere, &wall);
    const double waves = cor_contact_wave_loss(&contact, &half_space, speed), all = (1 - eps) * (1 + eps);
    if (isnan(waves))
        return NULL;
    return xprintf("Elastic waves in a massive wall as dense as the sphere cause the loss 1 - eps^2 = %.2g at %.4g "
                   "m/s, to first\norder. This dissipation time gives %.2g. %s\n",
                   waves, speed, all,
                   waves < all ? "A measured dissipation time includes the waves."
                               : "This is less than the loss by waves, so the dissipation time is too small.");
}

/* ---- the plan ---- */

#define NOTE(times)                                                                                                    \
    "Error: the largest at the points, compared with enclosed values, two digits, rounded up. For functions of the\n"  \
    "library it is the documented bound. A model meets the tolerance if its error and the uncertainty of the exact\n"  \
    "value add up to at most 0.97 of the tolerance. Cost: ns for one eps, " times ".\n"                                \
    "Costs of Pade approximants and headers are counted from their operations (docs/embed.md); the others were\n"      \
    "measured once (docs/plan.md). Compare only their ratios: processors differ.\n"
static const char *const notes[] = {/* by purpose */
                                    NOTE("as (single call + 4 in a loop)/5 (--for balanced)"),
                                    NOTE("in single calls (--for scalar)"), NOTE("in a loop (--for array)"),
                                    NOTE("in single calls (--for rebound)")};

static char *spheres_remark(const struct spheres *s)
{
    const struct plan *const plan = s->plan;
    const slong last = plan->points - 1;
    char *waves = plan_wave_remark(s->request, plan->speed[last], plan->truth[last]);
    if (!waves && !is_pressed(s) && !embed_given(s->request, COR_SCENE_POISSON))
        return NULL;
    const char *const friction =
        embed_given(s->request, COR_SCENE_POISSON)
            ? "Friction does not change eps. Leave it out if only the normal velocities matter; otherwise\ncorgen "
              "contact --friction MU --angle LIST gives spin and rebound angle.\n"
            : "";
    char *const pressing = is_pressed(s) ? pressing_remark(s) : xprintf("%s", "");
    char *const both = xprintf("%s%s%s", waves ? waves : "", pressing, friction);
    free(waves);
    free(pressing);
    return both;
}

/* Adds all models; needs the reference and the series. header: the tolerance of the header */
static void add_models(struct spheres *s, const char *header)
{
    const bool sphere = law_is_sphere(&s->scene.law);
    const struct plan *const p = s->plan;
    const slong last = p->points - 1;
    s->plan->title =
        xprintf("%s at %s to %s m/s, contact to %s: beta from %.4g to %.4g, eps from %.4g to %.4g.\n",
                s->request->law == COR_LAW_PLATE ? "A sphere and a plate"
                : sphere                         ? "Spheres"
                                                 : law_equation(&s->scene.law).text,
                s->request->number[EMBED_SPEED_MIN].text, s->request->number[EMBED_SPEED_MAX].text,
                is_pressed(s) && s->scene.end == COR_END_ZERO_FORCE ? "the surface" : cor_end_names[s->scene.end],
                p->at[0], p->at[last], p->truth[0], p->truth[last]);
    if (s->scene.own.law) {
        free(s->plan->title);
        s->plan->title = xprintf("%s, at %s to %s m/s: eps from %.4g to %.4g.\n", s->scene.own.text,
                                 s->request->number[EMBED_SPEED_MIN].text, s->request->number[EMBED_SPEED_MAX].text,
                                 p->truth[0], p->truth[last]);
    }
    s->plan->remark = s->scene.own.law ? NULL : spheres_remark(s);
    add_constants(s);
    if (!is_constant(s))
        add_power_law(s);
    if (!s->scene.constant) {
        if (sphere) {
            add_published(s);
            add_pades(s);
        }
        embed_search(s->form, is_pressed(s) ? &s->pressed_scene : &s->scene);
        add_header(s, header);
        if (!s->scene.own.law)
            (sphere ? add_library : add_function_of_beta)(s);
    }
    if (is_pressed(s) && !is_constant(s))
        add_pressed(s);
    if (cor_scene_ends_differ(s->contact))
        add_other_end(s);
    plan_choose(s->plan);
}

int plan_spheres(struct plan *plan, const struct embed_request *request, const struct cor_scene_contact *contact,
                 const struct embed_request *with_force, const struct cor_scene_contact *pressed, slong points)
{
    *plan = (struct plan){.chosen = -1};
    const double tolerance = embed_number(request, EMBED_TOLERANCE);
    int status = embed_check_numbers(request->number, embed_number(request, EMBED_SPEED_MIN),
                                     embed_number(request, EMBED_SPEED_MAX), LEAST_TOLERANCE, 1);
    if (status != STATUS_OK)
        return status;
    struct spheres s = {
        .plan = plan, .request = request, .contact = contact, .with_force = with_force, .pressed = pressed};
    struct embed_request embed = *request, forced = *with_force; /* tolerance: EMBED_COARSEST at most */
    struct decimal coarsest = {0};
    decimal_set(&coarsest, TEXT_OF(EMBED_COARSEST));
    if (tolerance > EMBED_COARSEST)
        embed.number[EMBED_TOLERANCE] = forced.number[EMBED_TOLERANCE] = coarsest;
    FOR_ALL(arb, init, s.h_star, s.force, s.damped);
    profile_step("scene, series");
    status = embed_request_check(&embed);
    if (status == STATUS_OK)
        status = embed_scene_init(&s.scene, &embed, contact);
    if (status == STATUS_OK && is_pressed(&s) && !s.scene.constant)
        status = embed_scene_init(&s.pressed_scene, &forced, pressed);
    if (status == STATUS_OK && !s.scene.own.law && s.scene.beta_max > BETA_LIMIT)
        status = fail("beta is up to %.3g at these speeds; allowed: up to %g; use a narrower range of speeds",
                      s.scene.beta_max, BETA_LIMIT);
    if (status == STATUS_OK) {
        const double low = s.scene.own.law ? embed_number(request, EMBED_SPEED_MIN) : s.scene.speed_min;
        plan_init(plan, points ? points : PLAN_DEFAULT_POINTS, low, s.scene.speed_max);
        plan->argument = s.scene.own.law ? "speed" : "beta";
        plan->quantity = "eps";
        plan->relative = true;
        plan->tolerance = tolerance;
        plan->note = notes[request->purpose];
        profile_step("collisions");
        status = find_truth(&s);
    }
    if (status == STATUS_OK)
        add_models(&s, embed.number[EMBED_TOLERANCE].text);
    profile_step(NULL);
    for (int i = 0; i < FAMILIES; i++)
        embed_form_clear(&s.form[i]);
    embed_scene_clear(&s.scene);
    if (is_pressed(&s) && !s.scene.constant)
        embed_scene_clear(&s.pressed_scene);
    FOR_ALL(arb, clear, s.h_star, s.force, s.damped);
    free(s.other);
    decimal_clear(&coarsest);
    return status;
}
