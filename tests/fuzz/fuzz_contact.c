/* SPDX-License-Identifier: MIT */
/* Every function of cor/contact.h but arrays (fuzz_functions.c has them), and cor_status_text, on raw bit patterns:
 * bodies that cannot be, contacts that no init filled. */
#include "cor/contact.h"
#include "cor/sphere.h"
#include "cor/status.h"
#include "fuzz.h"

enum { LAST_STATUS = COR_ERROR_MEMORY };

static const char *text_of(int status)
{
    const char *text = cor_status_text(status);
    REQUIRE(text && *text && !strchr(text, '\n') && text[strlen(text) - 1] == '.', "status %d", status);
    return text;
}

static struct cor_body take_body(struct input *in)
{
    struct cor_body body;
    body.young_modulus_pa = take_double(in);
    body.poisson_ratio = take_double(in);
    body.dissipation_time_s = take_double(in);
    body.radius_m = take_double(in);
    body.mass_kg = take_double(in);
    return body;
}

/* Fields as an array, in their order */
enum { FIELDS = 7 };
static void fields_of(double field[FIELDS], const struct cor_sphere_contact *contact)
{
    _Static_assert(sizeof *contact == FIELDS * sizeof *field, "a field of struct cor_sphere_contact is not looked at");
    memcpy(field, contact, sizeof *contact);
}

static void check_init(struct cor_sphere_contact *contact, const struct cor_body *a, const struct cor_body *b)
{
    memset(contact, UNTOUCHED, sizeof *contact);
    const int status = cor_sphere_contact_init(contact, a, b);
    double field[FIELDS];
    fields_of(field, contact);
    REQUIRE(status >= COR_OK && status <= COR_ERROR_RANGE && status != COR_ERROR_NULL && status != COR_ERROR_G_STAR,
            "status %d", status);
    for (int i = 0; i < FIELDS; i++) {
        if (status == COR_OK) /* the last may be NaN */
            REQUIRE((field[i] >= 0 && field[i] <= INFINITY) || (i == FIELDS - 1 && isnan(field[i])), "field %d: %a", i,
                    field[i]);
        else
            REQUIRE(isnan(field[i]), "status %d, field %d: %a", status, i, field[i]);
    }
    struct cor_sphere_contact other;
    const int reversed = cor_sphere_contact_init(&other, b, a);
    REQUIRE((status == COR_OK) == (reversed == COR_OK), "statuses %d and %d", status, reversed);
    if (status == COR_OK) {
        double there[FIELDS];
        fields_of(there, &other);
        for (int i = 0; i < FIELDS; i++)
            REQUIRE(same(field[i], there[i]), "exchanged, field %d: %a and %a", i, field[i], there[i]);
    }
}

/* good: an init has filled it */
static void check_calls(const struct cor_sphere_contact *contact, int good, struct input *in)
{
    static double (*const function[])(const struct cor_sphere_contact *, double) = {
        cor_contact_beta,
        cor_contact_eps_zero_overlap,
        cor_contact_eps_zero_force,
        cor_contact_duration_s_zero_overlap,
        cor_contact_duration_s_zero_force,
        cor_contact_max_overlap_m,
    };
    enum { FUNCTIONS = sizeof function / sizeof *function, FIRST_EPS = 1, LAST_EPS = 2 };
    const double speed = take_double(in), eps = take_double(in);
    double value[FUNCTIONS];
    for (int i = 0; i < FUNCTIONS; i++) {
        value[i] = function[i](contact, speed);
        if (good && !(speed >= 0))
            REQUIRE(isnan(value[i]), "function %d of %a: %a", i, speed, value[i]);
        if (good && speed >= 0)
            REQUIRE(!isnan(value[i]) || (isnan(contact->scale) && i > LAST_EPS), "function %d of %a: %a", i, speed,
                    value[i]);
        if (good && !isnan(value[i]))
            REQUIRE(value[i] >= 0, "function %d of %a: %a", i, speed, value[i]);
        if (i >= FIRST_EPS && i <= LAST_EPS) {
            REQUIRE(isnan(value[i]) || (value[i] >= 0 && value[i] <= 1), "function %d of %a: %a", i, speed, value[i]);
            if (good && speed == 0)
                REQUIRE(value[i] == 1, "function %d of %a: %a", i, speed, value[i]);
            if (good && speed >= 0)
                REQUIRE(value[i] >= 0, "function %d of %a: %a", i, speed, value[i]);
        }
    }
    if (good && speed >= 0) {
        const double beta = cor_contact_beta(contact, speed), ideal = cor_sphere_eps_zero_overlap(beta);
        /* beta is off by 1.5 ulp, eps by five times that and its own */
        REQUIRE(fabs(ideal - value[FIRST_EPS]) <= 16 * 0x1p-53 * ideal + 2 * 0x1p-1074, "speed %a: eps %a, of beta %a",
                speed, value[FIRST_EPS], ideal);
    }
    const double g_star = cor_contact_g_star_m_s(contact);
    if (good) /* 0 where the fifth power is below all doubles */
        REQUIRE(g_star > 0 || (g_star == 0 && contact->beta_per_root > 1e64), "g* = %a", g_star);
    double (*const times[])(const struct cor_sphere_contact *, double, double) = {
        cor_contact_dissipation_time_s_zero_overlap, cor_contact_dissipation_time_s_zero_force};
    for (int i = 0; i < 2; i++) {
        const double time = times[i](contact, speed, eps);
        if (!(eps >= 0 && eps <= 1) || !(speed > 0) || isinf(speed))
            REQUIRE(isnan(time), "dissipation time %a at speed %a, eps %a", time, speed, eps);
        else if (good && !isnan(time))
            REQUIRE(time >= 0, "dissipation time %a at speed %a, eps %a", time, speed, eps);
    }
}

static void check_material(struct input *in)
{
    const double a = take_double(in), b = take_double(in), c = take_double(in), d = take_double(in);
    const double time = cor_dissipation_time_s(a, b, c, d), mass = cor_sphere_mass_kg(a, b);
    REQUIRE(isnan(time) || time >= 0, "dissipation_time(%a, %a, %a, %a) = %a", a, b, c, d, time);
    if (!(a >= 0 && b >= 0 && c > 0 && d > -1 && d <= 0.5 && d != 0) || isinf(a) || isinf(b) || isinf(c))
        REQUIRE(isnan(time), "dissipation_time(%a, %a, %a, %a) = %a", a, b, c, d, time);
    else
        REQUIRE(time >= 0, "dissipation_time(%a, %a, %a, %a) = %a", a, b, c, d, time);
    REQUIRE(a > 0 && b > 0 ? mass >= 0 : isnan(mass), "mass(%a, %a) = %a", a, b, mass);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input in = {data, size};
    const uint8_t how = take_byte(&in);
    text_of(take_int(&in));
    for (int status = COR_OK; status <= LAST_STATUS; status++)
        REQUIRE(text_of(status) != text_of(-1), "status %d has no text", status);
    struct cor_sphere_contact contact;
    int good = 0;
    switch (how % 4) {
    case 0: { /* whatever bits */
        double field[FIELDS];
        for (int i = 0; i < FIELDS; i++)
            field[i] = take_double(&in);
        memcpy(&contact, field, sizeof contact);
        break;
    }
    case 1: {
        const double g_star = take_double(&in);
        const int status = cor_sphere_contact_init_g_star(&contact, g_star);
        good = status == COR_OK;
        REQUIRE(status == (g_star > 0 ? COR_OK : COR_ERROR_G_STAR), "g* = %a: status %d", g_star, status);
        REQUIRE(good ? contact.beta_per_root >= 0 : isnan(contact.beta_per_root), "g* = %a", g_star);
        REQUIRE(isnan(contact.scale) && isnan(contact.elastic_constant_n_m15), "g* = %a", g_star);
        break;
    }
    default: {
        const struct cor_body a = take_body(&in), b = how % 4 == 2 ? a : take_body(&in);
        check_init(&contact, &a, &b);
        good = !isnan(contact.beta_per_root);
        REQUIRE(cor_sphere_contact_init(how & 4 ? NULL : &contact, how & 8 ? NULL : &a, NULL) == COR_ERROR_NULL,
                "a NULL was taken");
        cor_sphere_contact_init(&contact, &a, &b);
        break;
    }
    }
    check_calls(&contact, good, &in);
    check_material(&in);
    return 0;
}
