/* SPDX-License-Identifier: MIT */
/* Tests scenes and forms of corgen embed: the conversion of speeds to beta, fits against collisions at the same speeds,
 * emulated arithmetic, operation counts, and the choice of a form. tests/embed/run tests the header. */
#define _XOPEN_SOURCE 700 /* mkstemp */
#include <unistd.h>

#include "support/console.h" /* must precede cmocka.h, which defines a macro fail */

#include "ball.h"
#include "contact/contact.h"
#include "embed/form.h"
#include "enclosure/collision.h"
#include "request.h"

/* A contact with g* = 0.2 m/s */
static const struct given g_star[] = {{COR_SCENE_G_STAR, "0.2"}, {-1, NULL}};

static void scene_init(struct embed_scene *s, struct contacts *contacts, const struct embed_request *request)
{
    assert_int_equal(contacts_of_request(contacts, request), STATUS_OK);
    assert_int_equal(embed_scene_init(s, request, &contacts->contact[0]), STATUS_OK);
}

struct found {
    struct contacts contacts;
    struct embed_scene s;
    struct embed_form form[FAMILIES];
    struct embed_form *chosen; /* the cheapest */
};

static void found_init(struct found *w, const struct embed_request *request)
{
    scene_init(&w->s, &w->contacts, request);
    embed_search(w->form, &w->s);
    for (int purpose = PURPOSE_BALANCED; purpose <= PURPOSE_ARRAY; purpose++)
        assert_true(w->form[embed_choose(w->form, (enum embed_purpose)purpose)].found);
    w->chosen = &w->form[embed_choose(w->form, PURPOSE_BALANCED)];
}

static void found_clear(struct found *w, struct embed_request *request)
{
    for (int k = 0; k < FAMILIES; k++)
        embed_form_clear(&w->form[k]);
    embed_scene_clear(&w->s);
    request_clear(request);
}

/* Returns the scene of a request, and clears the request. */
static struct embed_scene scene_of(const char *min, const char *max, const char *tolerance, int end)
{
    struct embed_request request = request_of(min, max, tolerance, end, g_star);
    struct embed_scene s;
    struct contacts contacts;
    scene_init(&s, &contacts, &request);
    request_clear(&request);
    return s;
}

static void assert_near(double x, double y, double tolerance)
{
    assert_true(fabs(x / y - 1) <= tolerance);
}

/* Returns eps at a speed, by solving that collision. */
static double solved(const struct embed_scene *s, double speed)
{
    LOCAL(collision, c);
    LOCAL(arb, beta);
    const struct ratio power = law_speed_exponent(&s->law);
    LET(beta, EMBED_BITS, "s->beta_per_root*speed^power", s->beta_per_root, speed, power);
    assert_int_equal(collision_solve(c, beta, &s->law, 64), 0);
    return middle(s->end == COR_END_ZERO_OVERLAP ? c->eps_zero_overlap : c->eps_zero_force);
}

/* eps at speeds from speed_min to speed_max, evenly spaced in their logarithm. Solved once for all forms of a scene */
enum { SOLVED = 5 };
struct solved {
    double speed[SOLVED], eps[SOLVED];
};

static struct solved scene_solved(const struct embed_scene *s)
{
    struct solved known;
    for (int k = 0; k < SOLVED; k++) {
        const double speed = s->speed_min * pow(s->speed_max / s->speed_min, k / ((double)SOLVED - 1.0));
        known.speed[k] = embed_rounded(s, fmin(speed, s->speed_max));
        known.eps[k] = solved(s, known.speed[k]);
    }
    return known;
}

/* Fails unless a form is within its tolerance of the solved collisions, and defined outside the range. */
static void check_form(const struct embed_form *f, const struct embed_scene *s, const struct solved *known)
{
    assert_true(f->error <= s->tolerance);
    assert_true(f->cost[USE_SCALAR] > 0 && f->cost[USE_ARRAY] > 0);
    for (int k = 0; k < SOLVED; k++)
        for (int fused = 0; fused < 2; fused++)
            assert_near(embed_form_value(f, known->speed[k], fused), known->eps[k], s->tolerance);
    const double first = embed_form_value(f, s->speed_min, false), last = embed_form_value(f, s->speed_max, false);
    assert_true(embed_form_value(f, 0, false) == first && embed_form_value(f, s->speed_min / 3, false) == first);
    assert_true(embed_form_value(f, INFINITY, false) == last && embed_form_value(f, s->speed_max * 3, false) == last);
    assert_true(isnan(embed_form_value(f, -1, false)) && isnan(embed_form_value(f, NAN, false)));
}

/* Checks the proof of a form, which covers the whole range. The proved error must bound the errors between the samples,
 * and may be only slightly larger than the largest sampled error. Then changes one number of the form, and checks the
 * proof again. True if the change raised the sampled error. */
static bool check_proof(struct embed_form *f, const struct embed_scene *s)
{
    struct embed_proof proof;
    assert_int_equal(embed_prove(&proof, f, s), STATUS_OK);
    check(proof.error >= f->error && proof.formula <= 1.05 * f->error + proof.rounding && proof.proved &&
              proof.from == s->speed_min + s->origin &&
              proof.rounding < (s->single ? 3e-6 : 1e-11) + 0.1 * s->tolerance,
          "%s: %g proved, %g by rounding, %g sampled", embed_family_name(f->family, s), proof.error, proof.rounding,
          f->error);
    LOCAL(arb, g, eps);
    for (size_t k = 0; k < points(1500); k++) {
        double place = 0.61803398874989485 * (double)k;
        place -= floor(place);
        const double speed = embed_rounded(s, s->speed_min * pow(s->speed_max / s->speed_min, place));
        arb_set_d(g, fmin(fmax(speed, s->speed_min), s->speed_max));
        embed_scene_eps(eps, s, g);
        for (int fused = 0; fused < 2; fused++) {
            const double value = embed_form_value(f, speed, fused);
            LET(g, 200, "value/eps - 1", value, eps);
            check(fabs(middle(g)) <= proof.error, "%s at %.17g m/s: off by %g, %g proved",
                  embed_family_name(f->family, s), speed, fabs(middle(g)), proof.error);
        }
    }
    const double error = f->error, kept = f->number[0];
    f->number[0] *= 1 + 64 * s->tolerance;
    embed_form_assess(f, &s->samples, 1);
    assert_int_equal(embed_prove(&proof, f, s), STATUS_OK);
    assert_true(proof.error >= f->error);
    const bool raised = f->error > error;
    f->number[0] = kept;
    f->error = error;
    return raised;
}

/* Checks all forms of a scene. proved: also proves some of them. For a sphere these are a third of the forms, another
 * third in every turn. For other laws it is the cheapest form. Returns the number of families that have a form. */
static int check_scene(struct embed_request *request, bool proved)
{
    struct found w;
    struct embed_proof proof;
    int found = 0;
    found_init(&w, request);
    const struct solved known = scene_solved(&w.s);
    const bool sphere = law_is_sphere(&w.s.law);
    for (int k = 0; k < FAMILIES; k++) {
        if (w.form[k].found)
            check_form(&w.form[k], &w.s, &known);
        else
            assert_true(w.form[k].why[0] != '\0');
        if (w.form[k].found && proved && (sphere ? in_turn((size_t)k, 3) : &w.form[k] == w.chosen))
            check_proof(&w.form[k], &w.s);
        found += w.form[k].found;
    }
    if (!proved && few_or_all(0, 1) != 0) { /* the proof takes seconds before it gives up */
        assert_int_equal(embed_prove(&proof, w.chosen, &w.s), STATUS_OK);
        assert_true(!proof.proved && !(proof.error < HUGE_VAL) && proof.rounding < w.s.tolerance);
    }
    found_clear(&w, request);
    return found;
}

/* Forms of every family for both ends, several tolerances and both types. Scenes of other laws have q of both signs,
 * beta just below the threshold, beta beyond all rows, or ends that coincide. Families of a series exist only for
 * spheres. */
TEST(test_scenes)
{
    static const char *const hertz[] = {"3/2", "0"}, *const linear[] = {"1", "2"}, *const crossley[] = {"3/2", "3/2"},
                             *const root[] = {"1", "1/2"};
    enum { OVERLAP = COR_END_ZERO_OVERLAP, FORCE = COR_END_ZERO_FORCE };
    static const struct {
        const char *const *law; /* the exponents; NULL: spheres */
        const char *min, *max, *tolerance, *beta;
        int end;
        enum embed_type type;
        bool proved;
        int least; /* number of families that must have a form */
    } scenes[] = {
        {NULL, "0.1", "10", "1e-6", NULL, OVERLAP, EMBED_DOUBLE, true, 8},
        {NULL, "0.1", "10", "1e-3", NULL, FORCE, EMBED_FLOAT, true, 8},
        {NULL, "1e-4", "1e-2", "1e-9", NULL, FORCE, EMBED_DOUBLE, true, 8},
        {NULL, "1e-4", "1e-2", "1e-5", NULL, OVERLAP, EMBED_FLOAT, true, 10},
        {NULL, "1e-5", "0.1", "1e-13", NULL, OVERLAP, EMBED_DOUBLE, true, 7},
        {hertz, "0.02", "10", "1e-6", "0.5", OVERLAP, EMBED_DOUBLE, false, 4},    /* beta up to 1.093; beta_c = 1.128 */
        {hertz, "1e-50", "1e-46", "1e-12", "0.5", FORCE, EMBED_DOUBLE, false, 4}, /* beta from 7.9e8 */
        {linear, "0.1", "2", "1e-3", "1", FORCE, EMBED_DOUBLE, true, 4},
        {hertz, "1e-3", "10", "1e-9", "0.5", FORCE, EMBED_DOUBLE, true, 4},
        {crossley, "1e-3", "7", "1e-6", "1", FORCE, EMBED_DOUBLE, true, 4},
        {root, "1e2", "1e4", "1e-10", "1", OVERLAP, EMBED_DOUBLE, false, 4}, /* beta above 10: a power of the speed */
    };
    for (size_t i = 0; i < COUNT_OF(scenes); i++) {
        if (!in_turn(i, 11))
            continue;
        struct embed_request request =
            request_of(scenes[i].min, scenes[i].max, scenes[i].tolerance, scenes[i].end,
                       scenes[i].law ? GIVEN({COR_SCENE_BETA, scenes[i].beta}, {COR_SCENE_AT, "1"}) : g_star);
        request.type = scenes[i].type;
        request.elastic = scenes[i].law ? scenes[i].law[0] : NULL;
        request.damping = scenes[i].law ? scenes[i].law[1] : NULL;
        const int found = check_scene(&request, scenes[i].proved);
        assert_true(found >= scenes[i].least && found <= (scenes[i].law ? FAMILIES - 3 : FAMILIES));
    }
}

/* Every specification of a contact gives the same contact as computation in doubles. A collision with the beta found
 * for --restitution must have this eps to twenty digits, at its speed and end. */
TEST(test_ways_of_a_contact)
{
    enum { YOUNG = 1, SPRING = 2, WALL = 4, FORCE = 8 };
    static const struct {
        int law, with, number;
        const char *value, *at, *viscosity;
    } ways[] = {{COR_LAW_VISCOELASTIC, YOUNG, COR_SCENE_DISSIPATION_TIME, "1e-6", NULL, NULL},
                {COR_LAW_VISCOELASTIC, YOUNG | WALL, COR_SCENE_DISSIPATION_TIME, "1e-6", NULL, NULL},
                {COR_LAW_VISCOELASTIC, SPRING, COR_SCENE_DISSIPATION_TIME, "1e-6", NULL, NULL},
                {COR_LAW_VISCOELASTIC, YOUNG, -1, NULL, NULL, "1e3,2e4"},
                {COR_LAW_VISCOELASTIC, YOUNG | WALL, -1, NULL, NULL, "1e3,2e4"},
                {COR_LAW_PLATE, YOUNG, COR_SCENE_PLATE_THICKNESS, "3e-3", NULL, NULL},
                {COR_LAW_PLATE, YOUNG, COR_SCENE_PLATE_THICKNESS, "3e-3", NULL, "1e3,2e4"},
                {COR_LAW_VISCOELASTIC, YOUNG, COR_SCENE_G_STAR, "20", NULL, NULL},
                {COR_LAW_HERTZ_DASHPOT, 0, COR_SCENE_G_STAR, "0.2", NULL, NULL},
                {COR_LAW_HUNT_CROSSLEY, 0, COR_SCENE_G_STAR, "0.2", NULL, NULL},
                {COR_LAW_HERTZ_DASHPOT, 0, COR_SCENE_BETA, "0.3", "32", NULL},
                {COR_LAW_VISCOELASTIC, SPRING, COR_SCENE_DAMPING_COEFFICIENT, "3", NULL, NULL},
                {COR_LAW_HERTZ_DASHPOT, YOUNG, COR_SCENE_DAMPING_COEFFICIENT, "2", NULL, NULL},
                {COR_LAW_HUNT_CROSSLEY, SPRING, COR_SCENE_DAMPING_COEFFICIENT, "2", NULL, NULL},
                {COR_LAW_TSUJI, YOUNG, COR_SCENE_ZETA, "0.1", NULL, NULL},
                {COR_LAW_TSUJI, SPRING, COR_SCENE_BETA, "0.1", NULL, NULL},
                {COR_LAW_LINEAR, SPRING, COR_SCENE_RESTITUTION, "0.5", NULL, NULL},
                {COR_LAW_VISCOELASTIC, YOUNG, COR_SCENE_RESTITUTION, "0.9", "2", NULL},
                {COR_LAW_VISCOELASTIC, YOUNG, COR_SCENE_RESTITUTION, "1", "2", NULL},
                {COR_LAW_VISCOELASTIC, FORCE, COR_SCENE_RESTITUTION, "1e-4", "0.5", NULL},
                {COR_LAW_VISCOELASTIC, FORCE, COR_SCENE_RESTITUTION, "0.99999999", "2", NULL},
                {COR_LAW_HUNT_CROSSLEY, 0, COR_SCENE_RESTITUTION, "0.6", "2", NULL},
                {COR_LAW_HERTZ_DASHPOT, FORCE, COR_SCENE_RESTITUTION, "0.3", "2", NULL}};
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        struct embed_request request = request_of(
            "1", "2", "1e-3", ways[i].with & FORCE ? COR_END_ZERO_FORCE : COR_END_ZERO_OVERLAP, GIVEN({-1, NULL}));
        request.law = ways[i].law;
        request.wall = ways[i].with & WALL;
        request.viscosity[0] = ways[i].viscosity;
        if (ways[i].with & YOUNG)
            request_give(&request,
                         GIVEN({COR_SCENE_YOUNG, "7e10"}, {COR_SCENE_POISSON, "0.2"}, {COR_SCENE_RADIUS, "5e-3"},
                               {COR_SCENE_DENSITY, "2500"}, {COR_SCENE_YOUNG_2, "2e11"}, {COR_SCENE_POISSON_2, "0.3"}));
        if (ways[i].with & SPRING)
            request_give(&request, GIVEN({COR_SCENE_STIFFNESS, "1e9"}, {COR_SCENE_EFFECTIVE_MASS, "1e-3"}));
        request_give(&request, GIVEN({ways[i].number, ways[i].value}, {ways[i].at ? COR_SCENE_AT : -1, ways[i].at}));
        struct contacts contacts;
        LOCAL(arb, beta, force, eps, yield_speed, liquid_speed);
        assert_int_equal(contacts_of_request(&contacts, &request), STATUS_OK);
        const struct cor_scene_contact *const contact = &contacts.contact[0];
        assert_int_equal(embed_contact_numbers(beta, force, yield_speed, liquid_speed, &request, contact, 192),
                         STATUS_OK);
        const double tolerance = 1e-13 + 1e-15 / (1 - (ways[i].at ? fmin(strtod(ways[i].value, NULL), 1 - 1e-9) : 0));
        check(fabs(middle(beta) - cor_scene_beta(contact, 1)) <= tolerance * middle(beta),
              "way %zu: beta %.17g, in doubles %.17g", i, middle(beta), cor_scene_beta(contact, 1));
        assert_true(arb_is_zero(beta) || arb_rel_accuracy_bits(beta) > 50);
        if (ways[i].number == COR_SCENE_RESTITUTION && ways[i].at && !arb_is_zero(beta)) {
            const double at = strtod(ways[i].at, NULL);
            const struct ratio power = law_speed_exponent(&contacts.scene.law);
            const fmpq *const wanted = request.number[COR_SCENE_RESTITUTION].value;
            LET(beta, 192, "beta*at^power", beta, at, power);
            arb_get_mid_arb(beta, beta);
            assert_int_equal(embed_contact_eps(eps, beta, force, &contacts.scene.law, request.end, 128), STATUS_OK);
            assert_true(HOLDS(192, "abs(eps/wanted - 1) < 10^-20", eps, wanted));
        }
        request_clear(&request);
    }
}

/* Viscosities are two numbers in decimal notation. */
TEST(test_viscosities)
{
    static const char *const texts[] = {"1e3,2", "1/3,2", "2,1/3", "2", ",2", "2,"};
    for (size_t i = 0; i < COUNT_OF(texts); i++) {
        struct decimal eta[2] = {{0}};
        assert_int_equal(embed_viscosity(eta, texts[i]), i == 0);
        decimal_clear(&eta[0]);
        decimal_clear(&eta[1]);
    }
}

/* A constant eps becomes a header with one number. Its proved error is the difference from that eps. */
TEST(test_constant)
{
    for (int i = 0; i < 2; i++) {
        struct embed_request request =
            request_of("0.1", "10", "1e-12", COR_END_ZERO_FORCE,
                       GIVEN({COR_SCENE_RESTITUTION, i == 0 ? "0.7" : "1"}, {COR_SCENE_AT, "1"}));
        request.law = i == 0 ? COR_LAW_LINEAR : COR_LAW_VISCOELASTIC;
        struct found w;
        struct embed_proof proof;
        found_init(&w, &request);
        assert_int_equal(w.chosen->family, FAMILY_RATIONAL_SPEED);
        assert_true(embed_form_value(w.chosen, 3, false) == (i == 0 ? 0.7 : 1.0));
        assert_int_equal(embed_prove(&proof, w.chosen, &w.s), STATUS_OK);
        assert_true(proof.proved && proof.error < 0x1p-53);
        w.chosen->number[0] *= 1 + 0x1p-40;
        assert_int_equal(embed_prove(&proof, w.chosen, &w.s), STATUS_OK);
        assert_near(proof.error, 0x1p-40, 1e-3);
        found_clear(&w, &request);
    }
}

/* Tests laws of the user, eps(v). Proves the forms, compares a table with SciPy 1.10's PchipInterpolator, and tests
 * refused ranges. tests/python/test_own_law.py compares the headers with formulas. */
TEST(test_own_laws)
{
    static const char rows[] = "eps,x,speed_m_s\n# a plateau, a peak\n0.9,1,0.01\n0.8,1,0.05\n0.8,1,0.2\n0.85,1,0.7\n"
                               "0.3,1,3\n0.25,1,4\n";
    static const double known[][2] = {
        {0.02, 0.8673519736842106}, {0.1, 0.8}, {0.5, 0.8324}, {1.5, 0.7104891273738002}, {3.5, 0.2654794376835921}};
    static const struct {
        int law;
        const char *a, *b, *min, *max, *tolerance;
        enum embed_type type;
        int status;
    } laws[] = {{EMBED_LAW_POWER, "0.115739", "0.234", "1e-6", "1", "1e-6", EMBED_DOUBLE, STATUS_OK},
                {EMBED_LAW_POWER, "0.5", "-1/10", "1e-3", "1023", "1e-9", EMBED_DOUBLE, STATUS_OK},
                {EMBED_LAW_POWER, "0.5", "-0.1", "1e-3", "1025", "1e-9", EMBED_DOUBLE, STATUS_USAGE},
                {EMBED_LAW_EXPONENTIAL, "0.3", "0.01", "1e-4", "1", "1e-5", EMBED_FLOAT, STATUS_OK},
                {EMBED_LAW_TABLE, NULL, NULL, "0.01", "4", "1e-12", EMBED_DOUBLE, STATUS_OK},
                {EMBED_LAW_TABLE, NULL, NULL, "0.02", "3.9", "1e-6", EMBED_FLOAT, STATUS_OK},
                {EMBED_LAW_TABLE, NULL, NULL, "0.0099", "4", "1e-6", EMBED_DOUBLE, STATUS_USAGE},
                {EMBED_LAW_TABLE, NULL, NULL, "0.01", "4.01", "1e-6", EMBED_DOUBLE, STATUS_USAGE}};
    char path[] = "/tmp/cor_own_law_XXXXXX";
    const int file = mkstemp(path);
    assert_true(file >= 0 && write(file, rows, sizeof rows - 1) == (ssize_t)sizeof rows - 1 && close(file) == 0);
    for (size_t i = 0; i < COUNT_OF(laws); i++) {
        if (laws[i].status == STATUS_OK && left_to_turn(i, 2))
            continue;
        const bool table = laws[i].law == EMBED_LAW_TABLE;
        const int number = laws[i].law == EMBED_LAW_POWER ? EMBED_COEFFICIENT : EMBED_EPS_INF;
        struct embed_request request = request_of(laws[i].min, laws[i].max, laws[i].tolerance, COR_END_ZERO_OVERLAP,
                                                  GIVEN({table ? -1 : number, laws[i].a}, {number + 1, laws[i].b}));
        request.law = laws[i].law;
        request.table = table ? path : NULL;
        request.type = laws[i].type;
        struct found w = {.s = {.tolerance = 0}};
        assert_int_equal(embed_scene_init(&w.s, &request, NULL), laws[i].status);
        if (laws[i].status == STATUS_OK) {
            embed_search(w.form, &w.s);
            w.chosen = &w.form[embed_choose(w.form, PURPOSE_SCALAR)];
            check_proof(w.chosen, &w.s);
            for (size_t k = 0; k < COUNT_OF(known) && table; k++)
                assert_near(embed_form_value(w.chosen, known[k][0], false), known[k][1], w.s.tolerance);
        }
        found_clear(&w, &request);
    }
    remove(path);
}

/* The counts of operations agree with counts by hand. A leading coefficient 1 needs no product. */
TEST(test_counts)
{
    double number[] = {1, 2, 3, 4, 5, 6, 1};
    static const struct {
        struct embed_form form;
        int operations[OPERATIONS];
    } counts[] = {{{.variable = SPEED, .numerator = 3, .denominator = 2},
                   {[OP_MUL_ADD] = 4, [OP_ADD] = 1, [OP_DIV] = 1, [OP_COMPARE] = 3}},
                  {{.variable = SQRT_OF_SPEED, .numerator = 4, .denominator = 1, .onset = 1, .origin = 1},
                   {[OP_MUL_ADD] = 4, [OP_MUL] = 1, [OP_ADD] = 2, [OP_DIV] = 1, [OP_SQRT] = 1, [OP_COMPARE] = 4}},
                  {{.variable = SPEED, .family = FAMILY_PIECES_SPEED, .rows = 1, .numerator = 3},
                   {[OP_MUL_ADD] = 3, [OP_ADD] = 1, [OP_BITS] = 3, [OP_LOAD] = 4, [OP_COMPARE] = 3}},
                  {{.variable = FIFTH_ROOT_OF_SPEED, .family = FAMILY_PIECES_BETA, .rows = 1, .numerator = 2},
                   {[OP_MUL_ADD] = 8,
                    [OP_MUL] = 7,
                    [OP_ADD] = 1,
                    [OP_BITS] = 3,
                    [OP_LOAD] = 3,
                    [OP_CONVERT] = 2,
                    [OP_COMPARE] = 3}}};
    for (size_t i = 0; i < COUNT_OF(counts); i++) {
        struct embed_form f = counts[i].form;
        f.number = number;
        embed_form_price(&f);
        assert_memory_equal(f.operations, counts[i].operations, sizeof f.operations);
        assert_true((f.cost[USE_ARRAY] < f.cost[USE_SCALAR]) == (f.operations[OP_SQRT] == 0));
    }
}

TEST(test_choice)
{
    struct embed_form form[FAMILIES];
    memset(form, 0, sizeof form);
    assert_int_equal(embed_choose(form, PURPOSE_BALANCED), FAMILIES);
    form[FAMILY_SERIES] = (struct embed_form){.found = true, .cost = {5, 5}};
    form[FAMILY_PIECES_SPEED] = (struct embed_form){.found = true, .cost = {1, 2}};
    form[FAMILY_RATIONAL_SPEED] = (struct embed_form){.found = true, .cost = {3, 1}};
    assert_int_equal(embed_choose(form, PURPOSE_SCALAR), FAMILY_PIECES_SPEED);
    assert_int_equal(embed_choose(form, PURPOSE_ARRAY), FAMILY_RATIONAL_SPEED);
    assert_int_equal(embed_choose(form, PURPOSE_BALANCED), FAMILY_RATIONAL_SPEED);
    form[FAMILY_RATIONAL_SPEED].found = false;
    assert_int_equal(embed_choose(form, PURPOSE_ARRAY), FAMILY_PIECES_SPEED);
}

static struct embed_form fit_of(const struct embed_scene *s, enum embed_family family, enum embed_variable variable,
                                slong numerator, slong denominator)
{
    struct embed_form f = {.family = family,
                           .variable = variable,
                           .speed_min = s->speed_min,
                           .speed_max = s->speed_max,
                           .numerator = numerator,
                           .denominator = denominator};
    assert_true(embed_fit_rational(&f, s));
    embed_form_assess(&f, &s->samples, 1);
    return f;
}

/* Each additional degree improves the fit. */
TEST(test_fit)
{
    struct embed_scene s = scene_of("0.1", "10", "1e-6", COR_END_ZERO_OVERLAP);
    double before = 1;
    for (slong degree = 1; degree <= 7; degree++) {
        struct embed_form f = fit_of(&s, FAMILY_RATIONAL_SPEED, SPEED, degree, degree);
        assert_true(f.error < before / 4);
        before = f.error;
        embed_form_clear(&f);
    }
    embed_scene_clear(&s);
}

/* At zero force, a scene that begins below beta = exp(10) and ends above it is proved as a whole. */
TEST(test_far_force)
{
    leave_to_turn(1, 3);
    struct embed_scene s = scene_of("1e21", "1e24", "1e-6", COR_END_ZERO_FORCE);
    assert_true(log(s.beta_min) < 10 && log(s.beta_max) > 11);
    struct embed_form f = fit_of(&s, FAMILY_RATIONAL_FOURTH, FOURTH_ROOT_OF_SPEED, 5, 6);
    assert_true(f.error < 1e-6);
    check_proof(&f, &s);
    embed_form_clear(&f);
    embed_scene_clear(&s);
}

/* Checks that d of eps = h*^5 beta^-5 (1 - d) at zero overlap is enclosed in 0 < d < limit for beta^5 = x. */
static void assert_power_law(double x, double limit)
{
    enum { FAR_BITS = 128 };
    LOCAL(collision, c);
    LOCAL(arb, beta, d, h_star);
    arb_set_d(d, x);
    arb_root_ui(beta, d, 5, 2 * FAR_BITS); /* collision_solve needs this precision of beta */
    assert_int_equal(collision_solve(c, beta, &law_sphere, FAR_BITS), 0);
    assert_int_equal(collision_h_star(h_star, FAR_BITS), 0);
    LET(d, FAR_BITS, "1 - x*c->eps_zero_overlap/h_star^5", x, c->eps_zero_overlap, h_star);
    assert_true(arb_is_positive(d) && HOLDS(FAR_BITS, "d < limit", d, limit));
}

/* Tests the power law eps = h*^5/beta^5 from EMBED_FAR onward and from beta^5 = 2^14 onward (docs/theory.md, 18). As a
 * form it is a rational function of the speed, h*^5/(b^5 g). Its proof detects an error in the 48th bit of a
 * coefficient. */
TEST(test_far)
{
    assert_power_law(pow(EMBED_FAR, 5), EMBED_FAR_ERROR);
    assert_power_law(0x1p14, 4.1e-17);

    struct embed_scene s = scene_of("1e5", "1e7", "1e-12", COR_END_ZERO_OVERLAP);
    struct embed_form f = fit_of(&s, FAMILY_RATIONAL_SPEED, SPEED, 0, 1);
    struct embed_proof proof;
    assert_true(s.beta_min > 7 && f.error < 1e-15);
    assert_int_equal(embed_prove(&proof, &f, &s), STATUS_OK);
    assert_true(proof.error < 4e-16 && proof.proved);
    f.number[0] *= 1 + 0x1p-48;
    assert_int_equal(embed_prove(&proof, &f, &s), STATUS_OK);
    assert_true(proof.formula > 0x1p-49);
    embed_form_clear(&f);
    embed_scene_clear(&s);
}

/* Fails unless s->onset is the largest number of its type that does not exceed the speed at which yield begins. */
static void assert_onset(const struct embed_scene *s, const arb_t speed)
{
    LOCAL(arb, onset, next);
    arb_set_d(onset, s->onset);
    arb_set_d(next, s->single ? (double)nextafterf((float)s->onset, HUGE_VALF) : nextafter(s->onset, HUGE_VAL));
    assert_true(arb_le(onset, speed) && arb_gt(next, speed));
}

TEST(test_yield)
{
    for (int i = 0; i < 20; i++) {
        char number[32];
        snprintf(number, sizeof number, "%.17g", i < 4 ? 1 : random_uniform(&draw, 0.5, 0.99));
        struct embed_request request =
            request_of("0.01", "20", "1e-3", 0, GIVEN({COR_SCENE_RESTITUTION, number}, {COR_SCENE_AT, "2.1"}));
        struct embed_scene s;
        struct contacts contacts;
        request.law = COR_LAW_ELASTIC_PLASTIC;
        request.type = i % 2 ? EMBED_FLOAT : EMBED_DOUBLE;
        scene_init(&s, &contacts, &request);
        assert_near(middle(s.yield_speed), contacts.contact[0].yield_speed_m_s, 1e-12);
        assert_onset(&s, s.yield_speed);
        embed_scene_clear(&s);
        request_clear(&request);
    }
}

/* Headers for a ball on a wall under gravity, and for sticky balls, agree with the library's integration in doubles
 * (runtime/scene/pressed.c). */
TEST(test_pressed)
{
    static const struct {
        enum cor_law law;
        int end;
        bool sticky;
        const char *restitution, *min, *max, *tolerance;
    } scenes[] = {{COR_LAW_VISCOELASTIC, END_SURFACE, true, "0.7", "0.03", "2", "1e-6"}, /* the fastest comes first */
                  {COR_LAW_VISCOELASTIC, COR_END_ZERO_OVERLAP, false, "0.6", "0.0068", "1", "1e-8"},
                  {COR_LAW_HERTZ_DASHPOT, END_SURFACE, false, "0.8", "0.013", "10", "1e-5"},
                  {COR_LAW_HUNT_CROSSLEY, COR_END_ZERO_OVERLAP, true, "0.5", "0.1", "3", "1e-4"}};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        if (!in_turn(i, 4))
            continue;
        struct embed_request request = request_of(
            scenes[i].min, scenes[i].max, scenes[i].tolerance, scenes[i].end,
            GIVEN({COR_SCENE_YOUNG, "7e7"}, {COR_SCENE_POISSON, "0.22"}, {COR_SCENE_RADIUS, "5e-3"},
                  {COR_SCENE_DENSITY, "2500"}, {COR_SCENE_AT, "1"}, {COR_SCENE_RESTITUTION, scenes[i].restitution},
                  {scenes[i].sticky ? COR_SCENE_ADHESION : COR_SCENE_GRAVITY, scenes[i].sticky ? "0.05" : "9.81"}));
        request.law = (int)scenes[i].law;
        request.wall = !scenes[i].sticky;
        request.adhesion_model = scenes[i].sticky ? COR_ADHESION_DMT : COR_ADHESION_NONE;
        struct found w;
        found_init(&w, &request);
        const struct cor_scene_contact *const contact = &w.contacts.contact[0];
        const double sticking = cor_scene_sticking_speed(contact, w.contacts.scene.end);
        assert_true(w.s.pressed && sticking < embed_number(&request, EMBED_SPEED_MIN));
        assert_near(middle(w.s.sticking_speed), sticking, 1e-8);
        assert_true(check_proof(w.chosen, &w.s));
        assert_onset(&w.s, w.s.sticking_speed);
        for (int k = 0; k <= 40; k++) {
            const double speed = w.s.speed_min * pow(w.s.speed_max / w.s.speed_min, k / 40.0);
            double eps;
            assert_int_equal(cor_scene_eps(&eps, contact, speed + w.s.origin, w.contacts.scene.end), COR_FAULT_NONE);
            assert_near(embed_form_value(w.chosen, speed, k % 2), eps,
                        w.s.tolerance + COR_SCENE_PRESSED_ERROR / (eps * eps));
        }
        assert_true(embed_form_value(w.chosen, w.s.onset - w.s.origin, false) == 0);
        found_clear(&w, &request);
    }
}
