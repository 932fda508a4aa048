/* SPDX-License-Identifier: MIT */
#include "check.h"

#include <cor/cor.h>
#include <cor/disk.h>

static const double smallest = 4.9406564584124654e-324;

/* Y = 70 GPa, nu = 1/5, A = 0.2 microseconds, R = 1 mm, 10 mg */
static const struct cor_body glass = {7e10, 0.2, 2e-7, 1e-3, 1e-5}, lossless = {7e10, 0.2, 0, 1e-3, 1e-5};

static struct cor_sphere_contact contact_of(struct cor_body one, struct cor_body other)
{
    struct cor_sphere_contact c;
    assert_int_equal(cor_sphere_contact_init(&c, &one, &other), COR_OK);
    return c;
}

static struct cor_sphere_contact contact_of_g_star(double g_star)
{
    struct cor_sphere_contact c;
    assert_int_equal(cor_sphere_contact_init_g_star(&c, g_star), COR_OK);
    return c;
}

/* Some contacts have a wall or a rigid partner as either body. This body neither deforms nor dissipates. */
TEST(against_long_double)
{
    const long double c1 = 1.15344885809528879913L;
    for (size_t i = 0; i < points(20000); i++) {
        struct cor_body b[2];
        long double compliance[2];
        for (int k = 0; k < 2; k++) {
            b[k].young_modulus_pa = random_log(&draw, 1e-30, 1e30);
            b[k].poisson_ratio = random_uniform(&draw, -1, 0.5);
            b[k].dissipation_time_s = random_log(&draw, 1e-30, 1e10);
            b[k].radius_m = random_log(&draw, 1e-30, 1e30);
            b[k].mass_kg = random_log(&draw, 1e-60, 1e60);
            if (k == 1 && i % 8 == 1)
                b[k].radius_m = b[k].mass_kg = INFINITY;
            if (k == 1 && i % 8 >= 6)
                b[k].young_modulus_pa = INFINITY;
            if (k == 0 && i % 8 == 7)
                b[k].dissipation_time_s = 0;
            compliance[k] =
                (1 - (long double)b[k].poisson_ratio) * (1 + (long double)b[k].poisson_ratio) / b[k].young_modulus_pa;
        }
        const struct cor_sphere_contact c = contact_of(b[0], b[1]), swapped = contact_of(b[1], b[0]);
        assert_memory_equal(&c, &swapped, sizeof c);
        const long double m = 1 / (1.0L / b[0].mass_kg + 1.0L / b[1].mass_kg);
        const long double r = 1 / (1.0L / b[0].radius_m + 1.0L / b[1].radius_m);
        const long double sum = compliance[0] + compliance[1];
        const long double rho = 4 * sqrtl(r) / (3 * sum);
        const long double a = (b[0].dissipation_time_s * compliance[0] + b[1].dissipation_time_s * compliance[1]) / sum;
        const long double root = powl(rho / m, 0.4L), beta_per_root = 1.5L * a * root;
        const double speed = random_log(&draw, COR_SI_LEAST, COR_SI_MOST);
        const long double beta = beta_per_root * powl(speed, 0.2L);
        const long double g_star = powl(c1 * c.beta_per_root, -5);
        const double computed_g_star = cor_contact_g_star_m_s(&c);
        check_ulp(c.effective_mass_kg, m, 3);
        check_ulp(c.effective_radius_m, r, 3);
        /* at most 16 roundings of half a unit in the last place each */
        check_ulp(c.elastic_constant_n_m15, rho, 8);
        check_ulp(c.dissipation_time_s, a, 8);
        check_ulp(c.beta_per_root, beta_per_root, COR_CONTACT_MAX_ULP);
        check_ulp(c.scale, 1 / root, COR_CONTACT_MAX_ULP);
        check_ulp(cor_contact_beta(&c, speed), beta, COR_CONTACT_MAX_ULP);
        /* g*, a fifth power, has twice the bound and may leave the range */
        if (g_star < 0.9 * COR_SI_MOST && g_star > 1.1 * COR_SI_LEAST)
            check_ulp(computed_g_star, g_star, 2 * COR_CONTACT_MAX_ULP);
    }
}

typedef double contact_function(const struct cor_sphere_contact *, double);

static contact_function *const eps_at_speed[2] = {cor_contact_eps_zero_overlap, cor_contact_eps_zero_force};
static double (*const eps_at_beta[2])(double) = {cor_sphere_eps_zero_overlap, cor_sphere_eps_zero_force};

static double (*const time_of_eps[2])(const struct cor_sphere_contact *, double, double) = {
    cor_contact_dissipation_time_s_zero_overlap, cor_contact_dissipation_time_s_zero_force};

/* The functions of a speed, and their values at the speeds 0 and infinity, and at infinity without dissipation.
 * Functions with results in seconds or metres need a scale. */
static const struct {
    const char *name;
    contact_function *of;
    int scaled;
    double at_zero, at_infinity, elastic;
} functions[] = {{"beta", cor_contact_beta, 0, 0, INFINITY, INFINITY},
                 {"eps, zero overlap", cor_contact_eps_zero_overlap, 0, 1, 0, 1},
                 {"eps, zero force", cor_contact_eps_zero_force, 0, 1, 0, 1},
                 {"duration, zero overlap", cor_contact_duration_s_zero_overlap, 1, INFINITY, INFINITY, 0},
                 {"duration, zero force", cor_contact_duration_s_zero_force, 1, INFINITY, 0, 0},
                 {"largest overlap", cor_contact_max_overlap_m, 1, 0, INFINITY, INFINITY}};

static void special_speeds(const struct cor_sphere_contact *c, int elastic)
{
    for (size_t k = 0; k < COUNT_OF(functions); k++) {
        contact_function *const f = functions[k].of;
        const int known = !isnan(c->beta_per_root) && !(functions[k].scaled && isnan(c->scale));
        const double last = elastic ? functions[k].elastic : functions[k].at_infinity;
        EACH (bad, -1, -smallest, -INFINITY, NAN, smallest, 0.99 * COR_SI_LEAST, COR_SI_MOST, DBL_MAX)
            check(isnan(f(c, *bad)), "%s at %g", functions[k].name, *bad);
        EACH (zero, 0.0, -0.0)
            check(known ? f(c, *zero) == functions[k].at_zero : isnan(f(c, *zero)), "%s at 0", functions[k].name);
        EACH (speed, COR_SI_LEAST, 1e-3, 1, 0.99 * COR_SI_MOST)
            check(isnan(f(c, *speed)) == !known, "%s at %g", functions[k].name, *speed);
        if (k > 0 || !elastic)
            check(known ? f(c, INFINITY) == last : isnan(f(c, INFINITY)), "%s at infinity", functions[k].name);
    }
    const int known = !isnan(c->scale);
    for (int end = 0; end < 2; end++) {
        check(known ? time_of_eps[end](c, 1, 1) == 0 : isnan(time_of_eps[end](c, 1, 1)), "A of 1");
        EACH (zero, 0.0, -0.0)
            check(known ? time_of_eps[end](c, 1, *zero) > DBL_MAX : isnan(time_of_eps[end](c, 1, *zero)), "A of 0");
        EACH (no_eps, -smallest, nextafter(1, 2), INFINITY, -INFINITY, NAN)
            check(isnan(time_of_eps[end](c, 1, *no_eps)), "A of %g", *no_eps);
        EACH (no_speed, 0, -0.0, -1, INFINITY, -INFINITY, NAN, 0.99 * COR_SI_LEAST, COR_SI_MOST)
            check(isnan(time_of_eps[end](c, *no_speed, 0.5)), "A at %g", *no_speed);
    }
}

TEST(speeds)
{
    /* a macro accepts any expression */
    assert_true(COR_CONTACT_EPS_MAX_ERROR(1 + 2) == COR_CONTACT_EPS_MAX_ERROR(3));
    const struct cor_sphere_contact damped = contact_of(glass, glass), elastic = contact_of(lossless, lossless),
                                    without = contact_of_g_star(INFINITY);
    struct cor_sphere_contact c = contact_of_g_star(1);
    special_speeds(&damped, 0);
    special_speeds(&without, 1);
    special_speeds(&elastic, 1);
    special_speeds(&c, 0);
    for (int end = 0; end < 2; end++) {
        EACH (speed, COR_SI_LEAST, 1, 1e249)
            check(eps_at_speed[end](&elastic, *speed) == 1, "speed %g", *speed);
        assert_true(eps_at_speed[end](&c, COR_SI_LEAST) == 1 && eps_at_speed[end](&c, 1e249) > 0);
    }
    /* by Hertz, the duration is 2 tau_0 scale g^(-1/5) at both ends, and the largest overlap is y_0 scale g^(4/5) */
    const long double root = powl(0.3, 0.2L), time = 3.21806545971904308454L * elastic.scale / root;
    check_ulp(cor_contact_duration_s_zero_overlap(&elastic, 0.3), time, 6);
    check_ulp(cor_contact_duration_s_zero_force(&elastic, 0.3), time, 6);
    const long double overlap = 1.09336207394327805637L * elastic.scale * root * root * root * root;
    check_ulp(cor_contact_max_overlap_m(&elastic, 0.3), overlap, 10);
}

TEST(characteristic_speed)
{
    struct cor_sphere_contact c;
    for (size_t i = 0; i < points(2000); i++) {
        const double g_star = random_log(&draw, 1e-249, 1e249);
        c = contact_of_g_star(g_star);
        check_near(cor_contact_g_star_m_s(&c), g_star, 3 * COR_CONTACT_MAX_ULP * DBL_EPSILON);
        /* |C_1| beta = 1 at g = g* */
        check_near(cor_contact_beta(&c, g_star), -1 / (long double)COR_SPHERE_C1, COR_CONTACT_MAX_ULP * DBL_EPSILON);
        check_nan(c.effective_mass_kg, c.elastic_constant_n_m15);
    }
    /* eps = 1 - (g/g*)^(1/5) + (3/5)(g/g*)^(2/5) - ..., (32) */
    c = contact_of_g_star(3.2e-3);
    check_near(cor_contact_eps_zero_overlap(&c, 3.2e-13), 1 - 0.01 + 0.6e-4, 1e-6);
    /* no dissipation */
    c = contact_of_g_star(INFINITY);
    assert_true(cor_contact_g_star_m_s(&c) == INFINITY);
    const struct cor_body without = {1e9, 0.3, -0.0, 0.01, 0.01};
    c = contact_of(without, without);
    assert_true(cor_contact_g_star_m_s(&c) == INFINITY);
}

static void all_nan(const struct cor_sphere_contact *c)
{
    check_nan(c->effective_mass_kg, c->effective_radius_m, c->elastic_constant_n_m15, c->dissipation_time_s,
              c->beta_per_root, c->scale, c->beta5_per_speed, cor_contact_g_star_m_s(c));
    special_speeds(c, 0);
}

/* Checks that a body with one wrong member is refused, as the first and as the second body. */
static void refused(size_t member, double value, int status)
{
    struct cor_body wrong = glass;
    memcpy((char *)&wrong + member, &value, sizeof value);
    for (int second = 0; second < 2; second++) {
        struct cor_sphere_contact c = {1, 1, 1, 1, 1, 1, 1};
        const int seen = cor_sphere_contact_init(&c, second ? &glass : &wrong, second ? &wrong : &glass);
        check(seen == status, "member at %zu = %g: status %d, not %d", member, value, seen, status);
        all_nan(&c);
    }
}

TEST(wrong_inputs)
{
    const size_t young = offsetof(struct cor_body, young_modulus_pa);
    const size_t poisson = offsetof(struct cor_body, poisson_ratio);
    const size_t time = offsetof(struct cor_body, dissipation_time_s);
    const size_t radius = offsetof(struct cor_body, radius_m);
    const size_t mass = offsetof(struct cor_body, mass_kg);
    struct cor_sphere_contact c;
    assert_int_equal(cor_sphere_contact_init_g_star(NULL, 1), COR_ERROR_NULL);
    EACH (not_positive, 0, -0.0, -1, -smallest, -INFINITY, NAN) {
        refused(young, *not_positive, COR_ERROR_YOUNG_MODULUS);
        refused(radius, *not_positive, COR_ERROR_RADIUS);
        refused(mass, *not_positive, COR_ERROR_MASS);
        if (!(*not_positive == 0))
            refused(time, *not_positive, COR_ERROR_DISSIPATION_TIME);
        c = (struct cor_sphere_contact){1, 1, 1, 1, 1, 1, 1};
        assert_int_equal(cor_sphere_contact_init_g_star(&c, *not_positive), COR_ERROR_G_STAR);
        all_nan(&c);
    }
    refused(time, INFINITY, COR_ERROR_DISSIPATION_TIME);
    EACH (bad_poisson, -1, nextafter(0.5, 1), -2, 0.6, INFINITY, -INFINITY, NAN)
        refused(poisson, *bad_poisson, COR_ERROR_POISSON_RATIO);
    /* values that would overflow or vanish */
    EACH (extreme, smallest, 0.99 * COR_SI_LEAST, COR_SI_MOST, DBL_MAX) {
        refused(young, *extreme, COR_ERROR_RANGE);
        refused(radius, *extreme, COR_ERROR_RANGE);
        refused(mass, *extreme, COR_ERROR_RANGE);
        refused(time, *extreme, COR_ERROR_RANGE);
    }

    /* one value for both bodies: infinity, or close to an end of the range */
    const struct {
        size_t member;
        double value;
        int status;
    } both[] = {{radius, INFINITY, COR_ERROR_BOTH_FLAT},      {mass, INFINITY, COR_ERROR_BOTH_FIXED},
                {young, INFINITY, COR_ERROR_BOTH_RIGID},      {poisson, 0.5, COR_OK},
                {poisson, nextafter(-1, 0), COR_OK},          {mass, 2 * COR_SI_LEAST, COR_OK},
                {mass, 1.99 * COR_SI_LEAST, COR_ERROR_RANGE}, {mass, 0.99 * COR_SI_MOST, COR_OK}};
    struct cor_body one;
    for (size_t i = 0; i < COUNT_OF(both); i++) {
        one = glass;
        memcpy((char *)&one + both[i].member, &both[i].value, sizeof both[i].value);
        assert_int_equal(cor_sphere_contact_init(&c, &one, &one), both[i].status);
        if (both[i].status != COR_OK)
            all_nan(&c);
        else
            assert_true(c.effective_mass_kg == one.mass_kg / 2);
    }
    one = glass;
    assert_int_equal(cor_sphere_contact_init(NULL, &one, &one), COR_ERROR_NULL);
    assert_int_equal(cor_sphere_contact_init(&c, NULL, &one), COR_ERROR_NULL);
    all_nan(&c);
    assert_int_equal(cor_sphere_contact_init(&c, &one, NULL), COR_ERROR_NULL);
    all_nan(&c);
    /* beta^5 of a speed in range exceeds the largest double, so eps at zero overlap is subnormal */
    c = (struct cor_sphere_contact){1, 1, 1, 1, 1e60, 1, 1e300};
    const double beyond = cor_contact_eps_zero_overlap(&c, 1e18);
    assert_true(beyond > 0 && beyond == cor_sphere_eps_zero_overlap(cor_contact_beta(&c, 1e18)));
    /* a dissipation time whose beta_per_root underflows is refused, not treated as zero */
    one.dissipation_time_s = smallest;
    one.young_modulus_pa = 1e-10;
    assert_int_equal(cor_sphere_contact_init(&c, &one, &one), COR_ERROR_RANGE);
    all_nan(&c);
}

#define TEXT_OF_(x) #x
#define TEXT_OF(x) TEXT_OF_(x)

TEST(status_texts)
{
    /* for each status, in order, a characteristic word of its text */
    char words[] =
        "No error|NULL|Young's modulus of|Poisson's|dissipation|radius of|mass of|radii|masses|Young's moduli|"
        "characteristic|double|of a disk|datum|cor_disk_speed_limit|sorted by|tolerance must|opened|"
        "version|incomplete|too small|too violent|cannot be met|towards|more steps|hardness|more angles|"
        "smaller than|allocated|density|thickness";
    int count = 0;
    assert_int_equal(COR_OK, 0);
    for (const char *word = strtok(words, "|"); word; word = strtok(NULL, "|"), count++) {
        const char *text = cor_status_text(count);
        assert_non_null(text);
        check(strstr(text, word) != NULL, "status %d: %s", count, text);
        check(text[strlen(text) - 1] == '.' && strchr(text, '\n') == NULL, "status %d: %s", count, text);
    }
    assert_int_equal(COR_ERROR_THICKNESS, count - 1);
    assert_non_null(strstr(cor_status_text(COR_ERROR_ALPHA),
                           "from " TEXT_OF(COR_DISK_COLLISION_MIN_ALPHA) " to " TEXT_OF(COR_DISK_COLLISION_MAX_ALPHA)));
    assert_string_equal(cor_status_text(-1), "This number is not a status of cor.");
    assert_string_equal(cor_status_text(-1), cor_status_text(count));
}

/* Checks that computed is within a bound, or NaN if the exact value is out of range. */
static void in_range(double computed, long double exact, double bound)
{
    if (exact > 3 * (long double)COR_SI_MOST || exact < (long double)COR_SI_LEAST / 3)
        assert_true(isnan(computed));
    else if (exact < (long double)COR_SI_MOST / 3 && exact > 3 * (long double)COR_SI_LEAST)
        check_ulp(computed, exact, bound);
}

/* By hand: eta_1 = 1e3 and eta_2 = 2e3 Pa s give the factor (5e3)^2/8e3 = 3125, and nu = 1/4 gives
 * (1 - 1/16)(1/2)/(1/16) = 7.5. With Y = 1e9 Pa, A is 3125 * 7.5/3e9 = 7.8125e-6 s. */
TEST(dissipation_time)
{
    check_near(cor_dissipation_time_s(1e3, 2e3, 1e9, 0.25), 7.8125e-6L, 1e-15L);
    assert_true(cor_dissipation_time_s(3, 1, 1e9, 0.25) == 0); /* 3 eta_2 = eta_1 */
    assert_true(cor_dissipation_time_s(1, 1, 1e9, 0.5) == 0);  /* incompressible */
    assert_true(cor_dissipation_time_s(0, 0, 1e9, 0.25) == 0);
    assert_true(cor_dissipation_time_s(0, 1e200, 1e9, 0.25) > 0); /* the square in the formula does not overflow */
    assert_true(isfinite(cor_dissipation_time_s(0, 1e200, 1e9, 0.25)));
    assert_true(cor_dissipation_time_s(3e-200, 1e-200, 1e9, 1e-200) == 0); /* 1/nu^2 does not overflow */
    const double bad[][4] = {{1, 2, 1e9, 0},           {1, 2, 1e9, -0.0},        {1, 2, 1e9, -1},
                             {1, 2, 1e9, 0.51},        {1, 2, 0, 0.25},          {1, 2, -1, 0.25},
                             {-1, 2, 1e9, 0.25},       {1, -2, 1e9, 0.25},       {NAN, 2, 1e9, 0.25},
                             {1, NAN, 1e9, 0.25},      {1, 2, NAN, 0.25},        {1, 2, 1e9, NAN},
                             {1, INFINITY, 1e9, 0.25}, {INFINITY, 1, 1e9, 0.25}, {1, 2, INFINITY, 0.25}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        check(isnan(cor_dissipation_time_s(bad[i][0], bad[i][1], bad[i][2], bad[i][3])), "row %zu", i);
    /* only the result can leave the range */
    for (size_t i = 0; i < points(10000); i++) {
        const double eta1 = i % 2 ? random_log(&draw, 1e-250, 1e249) : random_log(&draw, 1e-3, 1);
        const double eta2 = i % 2 == 0 ? random_log(&draw, 1, 1e3) : 3 * eta1;
        const double young = i % 2 ? random_log(&draw, 1e-250, 1e250) : random_log(&draw, 1, 1e12);
        const double nu = i % 2 ? random_log(&draw, 1e-300, 0.3) : random_uniform(&draw, -1, 0.5);
        const long double e1 = eta1, e2 = eta2, n = nu;
        const long double exact =
            (3 * e2 - e1) * ((3 * e2 - e1) / (3 * (3 * e2 + 2 * e1))) * (1 - n) * (1 + n) * (1 - 2 * n) / n / n / young;
        if (exact != 0)
            in_range(cor_dissipation_time_s(eta1, eta2, young, nu), exact, COR_CONTACT_MAX_ULP);
    }
}

/* kappa of equal materials and of glass on steel, and the angle up to which friction prevents sliding */
TEST(oblique_impacts)
{
    for (double nu = -0.95; nu <= 0.5; nu += 0.05)
        in_range(cor_tangential_kappa(7e10, nu, 7e10, nu), 10.5L * (1 - (long double)nu) / (2 - (long double)nu),
                 COR_CONTACT_MAX_ULP);
    assert_true(cor_tangential_kappa(1, 0.25, 1, 0.25) == 4.5 && cor_tangential_kappa(1e-200, 0.5, 1e-200, 0.5) == 3.5);
    static const double young[][2] = {{7e10, 2.1e11}, {1e-250, 1e249}, {1e-240, 2e-240}, {INFINITY, 1e9}};
    for (size_t i = 0; i < sizeof young / sizeof *young; i++) {
        const long double y1 = young[i][0], y2 = young[i][1], nu_1 = 0.2, nu_2 = -0.3;
        const long double compliance = (1 - nu_1 * nu_1) / y1 + (1 - nu_2 * nu_2) / y2;
        const long double shear = 2 * (2 - nu_1) * (1 + nu_1) / y1 + 2 * (2 - nu_2) * (1 + nu_2) / y2;
        in_range(cor_tangential_kappa(young[i][0], 0.2, young[i][1], -0.3), 21 * compliance / shear,
                 COR_CONTACT_MAX_ULP);
    }
    check_nan(cor_tangential_kappa(0, 0.2, 1, 0.2), cor_tangential_kappa(1, 0.6, 1, 0.2),
              cor_tangential_kappa(1, 0.2, NAN, 0.2), cor_tangential_kappa(1, 0.2, 1, -1),
              cor_tangential_kappa(1e251, 0.2, 1, 0), cor_tangential_kappa(INFINITY, 0.2, INFINITY, 0.2));
    for (double friction = 1e-300; friction < 1e300; friction *= 1e7)
        check_ulp(cor_tangential_stick_angle(4.3, friction), atanl(3.5L * friction / 4.3), COR_CONTACT_MAX_ULP);
    assert_true(cor_tangential_stick_angle(4.5, 0) == 0 && cor_tangential_stick_angle(INFINITY, 1) == 0);
    check_ulp(cor_tangential_stick_angle(1e-300, 1e300), acosl(0), COR_CONTACT_MAX_ULP);
    check_ulp(cor_tangential_stick_angle(4.5, INFINITY), acosl(0), COR_CONTACT_MAX_ULP);
    check_nan(cor_tangential_stick_angle(0, 1), cor_tangential_stick_angle(4.5, -1), cor_tangential_stick_angle(NAN, 1),
              cor_tangential_stick_angle(1, NAN), cor_tangential_stick_angle(INFINITY, INFINITY));
}

/* By hand: a ball of ice, R = 1 cm and 917 kg/m^3, has the mass 4.18879e-6 * 917 = 3.84112e-3 kg. */
TEST(mass_of_a_sphere)
{
    check_near(cor_sphere_mass_kg(0.01, 917), 3.84112e-3L, 1e-6L);
    check_ulp(cor_sphere_mass_kg(1, 1), 4 * acosl(-1) / 3, 0.5L + 1e-3L);
    EACH (bad, 0, -1, NAN, -INFINITY, 1e-251, 1e251)
        check_nan(cor_sphere_mass_kg(*bad, 1), cor_sphere_mass_kg(1, *bad), cor_sphere_mass_kg(INFINITY, *bad));
    assert_true(cor_sphere_mass_kg(1e-200, INFINITY) == INFINITY && cor_sphere_mass_kg(INFINITY, 1e-250) == INFINITY);
    /* the cube of the radius may be out of range although the mass is not */
    for (size_t i = 0; i < points(5000); i++) {
        const double radius = random_log(&draw, 1e-200, 1e200), density = random_log(&draw, 1e-250, 1e249);
        const long double r = radius;
        in_range(cor_sphere_mass_kg(radius, density), 4 * acosl(-1) / 3 * r * r * r * density, 4);
    }
}

/* Contacts whose beta_per_root^5 is not a double, at speeds with a moderate beta. */
TEST(extreme_contacts)
{
    struct cor_sphere_contact c = contact_of_g_star(1);
    EACH (factor, 1e-61, 3e-61, 2e-60, 1e60, 3e61, 1e64, 1e-150, 1e150) {
        /* all fields that the functions read */
        c.beta_per_root = *factor;
        c.beta5_per_speed = NAN;
        for (double exponent = -250; exponent < 250; exponent += 0.37) {
            const double speed = pow(10, exponent), beta = cor_contact_beta(&c, speed);
            for (int end = 0; end < 2; end++) {
                const double eps = eps_at_speed[end](&c, speed);
                check(same_bits(eps, eps_at_beta[end](beta)), "%g at %g", *factor, speed);
            }
        }
        assert_true(cor_contact_eps_zero_overlap(&c, 0) == 1 && cor_contact_eps_zero_force(&c, -0.0) == 1);
        assert_true(cor_contact_eps_zero_overlap(&c, INFINITY) == 0 && isnan(cor_contact_eps_zero_force(&c, -1)));
    }
    /* beta_per_root^5 is a double, but its product with the speed may not be */
    c.beta_per_root = 0x1p20;
    c.beta5_per_speed = 0x1p100;
    for (int exponent = 700; exponent < 830; exponent++) {
        const double speed = ldexp(1.25, exponent), beta = cor_contact_beta(&c, speed);
        for (int end = 0; end < 2; end++) {
            const double eps = eps_at_speed[end](&c, speed), by_beta = eps_at_beta[end](beta);
            check(fabs(eps - by_beta) <= 20 * DBL_EPSILON * by_beta + 0x1p-1074, "end %d at 1.25 2^%d: %a, not %a", end,
                  exponent, eps, by_beta);
        }
    }
    /* beta_per_root^5 is already out of range in cor_sphere_contact_init */
    const struct cor_body soft = {1e-150, 0.3, 1e-10, 1e-3, 1e-3};
    const struct cor_sphere_contact extreme = contact_of(soft, soft);
    assert_true(isnan(extreme.beta5_per_speed) && extreme.beta_per_root > 0);
    assert_true(cor_contact_eps_zero_force(&extreme, 1) == 1);
}

/* Functions of contacts agree with functions of beta, scaled in long double by the numbers of the material. */
TEST(dimensions_against_long_double)
{
    for (size_t i = 0; i < points(3000); i++) {
        struct cor_body body = {random_log(&draw, 1e6, 1e12), random_uniform(&draw, 0, 0.5), 1,
                                random_log(&draw, 1e-6, 10), random_log(&draw, 1e-12, 1e6)};
        const double speed = random_log(&draw, 1e-9, 1e3);
        const long double rho = 2 * sqrtl(body.radius_m / 2.0L) * body.young_modulus_pa /
                                (3 * (1 - (long double)body.poisson_ratio) * (1 + (long double)body.poisson_ratio));
        const long double scale = powl(2 * rho / body.mass_kg, -0.4L), root = powl(speed, 0.2L);
        body.dissipation_time_s = (double)(random_log(&draw, 1e-3, 7) * scale / (1.5L * root));
        const double beta = (double)(1.5L * body.dissipation_time_s / scale * root);
        const struct cor_sphere_contact c = contact_of(body, body);
        check_ulp(cor_contact_duration_s_zero_overlap(&c, speed), cor_sphere_duration_zero_overlap(beta) * scale / root,
                  COR_CONTACT_MAX_ULP);
        check_ulp(cor_contact_duration_s_zero_force(&c, speed), cor_sphere_duration_zero_force(beta) * scale / root,
                  COR_CONTACT_MAX_ULP);
        check_ulp(cor_contact_max_overlap_m(&c, speed),
                  cor_sphere_max_overlap(beta) * scale * root * root * root * root, COR_CONTACT_MAX_ULP);
    }
}

/* A -> eps -> A returns A up to the effect of rounding eps. */
TEST(dissipation_time_from_eps)
{
    for (size_t i = 0; i < points(20000); i++) {
        struct cor_body body = glass;
        body.dissipation_time_s = random_log(&draw, 1e-12, 1e-2);
        body.radius_m = random_log(&draw, 1e-5, 1);
        const struct cor_sphere_contact c = contact_of(body, body);
        body.dissipation_time_s = 1; /* the dissipation time of the given contact is ignored */
        const struct cor_sphere_contact other = contact_of(body, body);
        const double speed = random_log(&draw, 1e-6, 1e3), beta = cor_contact_beta(&c, speed);
        for (int end = 0; end < 2; end++) {
            const double eps = eps_at_speed[end](&c, speed), back = time_of_eps[end](&other, speed, eps);
            const double loss = end ? cor_sphere_loss_zero_force(beta) : cor_sphere_loss_zero_overlap(beta);
            /* |d ln(beta)/d ln(eps)| is about eps/(1 - eps), and less than 1 for small eps */
            const long double condition = 2.0L * eps / loss + 1;
            check(relative_error(back, c.dissipation_time_s) <= (4 * condition + 2 * COR_CONTACT_MAX_ULP) * DBL_EPSILON,
                  "end %d, eps = %a: A = %a -> %a", end, eps, c.dissipation_time_s, back);
        }
    }
}
