/* SPDX-License-Identifier: MIT */
#include "embed/contact.h"

/* ---- two bodies ---- */

struct body {
    arb_t compliance;       /* c_i = (1 - nu_i^2)/Y_i */
    arb_t inverse_radius;   /* 1/R_i; 0 of a wall */
    arb_t inverse_mass;     /* 1/m_i; 0 of a wall */
    arb_t dissipation_time; /* A_i */
};

struct pair {
    arb_t compliance, inverse_radius, inverse_mass; /* the sums of both bodies */
    arb_t rho;                                      /* the elastic force is rho overlap^(3/2) */
    arb_t dissipation_time;
};

static void body_init(struct body *body)
{
    arb_init(body->compliance);
    arb_init(body->inverse_radius);
    arb_init(body->inverse_mass);
    arb_init(body->dissipation_time);
}

static void body_clear(struct body *body)
{
    arb_clear(body->compliance);
    arb_clear(body->inverse_radius);
    arb_clear(body->inverse_mass);
    arb_clear(body->dissipation_time);
}

static void pair_init(struct pair *pair)
{
    arb_init(pair->compliance);
    arb_init(pair->inverse_radius);
    arb_init(pair->inverse_mass);
    arb_init(pair->rho);
    arb_init(pair->dissipation_time);
}

static void pair_clear(struct pair *pair)
{
    arb_clear(pair->compliance);
    arb_clear(pair->inverse_radius);
    arb_clear(pair->inverse_mass);
    arb_clear(pair->rho);
    arb_clear(pair->dissipation_time);
}

/* Sets a number of a body. The number of body 2 is that of body 1 unless the request gives its own. */
static void set_number(arb_t x, const struct embed_request *request, enum embed_number which, int body, slong prec)
{
    arb_set_fmpq(x, embed_number_of_body(request, which, body)->value, prec);
}

/* c_i = (1 - nu_i^2)/Y_i, include/cor/contact.h */
static void body_set_compliance(struct body *body, const struct embed_request *request, int which, slong prec)
{
    arb_t young;
    arb_init(young);
    set_number(young, request, EMBED_YOUNG, which, prec);
    set_number(body->compliance, request, EMBED_POISSON, which, prec);
    arb_sqr(body->compliance, body->compliance, prec);
    arb_sub_ui(body->compliance, body->compliance, 1, prec);
    arb_neg(body->compliance, body->compliance);
    arb_div(body->compliance, body->compliance, young, prec);
    arb_clear(young);
}

/* m_i = (4/3) pi R_i^3 density_i if the mass is not given */
static void body_set_mass(arb_t mass, const struct embed_request *request, int which, slong prec)
{
    if (embed_mass_is_given(request, which)) {
        set_number(mass, request, EMBED_MASS, which, prec);
        return;
    }
    arb_t factor;
    arb_init(factor);
    set_number(mass, request, EMBED_RADIUS, which, prec);
    arb_pow_ui(mass, mass, 3, prec);
    set_number(factor, request, EMBED_DENSITY, which, prec);
    arb_mul(mass, mass, factor, prec);
    arb_const_pi(factor, prec);
    arb_mul(mass, mass, factor, prec);
    arb_mul_ui(mass, mass, 4, prec);
    arb_div_ui(mass, mass, 3, prec);
    arb_clear(factor);
}

static void body_set(struct body *body, const struct embed_request *request, int which, slong prec)
{
    body_set_compliance(body, request, which, prec);
    set_number(body->dissipation_time, request, EMBED_DISSIPATION_TIME, which, prec);
    if (which == 2 && request->wall) {
        arb_zero(body->inverse_radius);
        arb_zero(body->inverse_mass);
        return;
    }
    set_number(body->inverse_radius, request, EMBED_RADIUS, which, prec);
    arb_inv(body->inverse_radius, body->inverse_radius, prec);
    body_set_mass(body->inverse_mass, request, which, prec);
    arb_inv(body->inverse_mass, body->inverse_mass, prec);
}

/* rho = (4/3) sqrt(R)/(c_1 + c_2) and A = (A_1 c_1 + A_2 c_2)/(c_1 + c_2), include/cor/contact.h */
static void pair_set(struct pair *pair, const struct body *body_1, const struct body *body_2, slong prec)
{
    arb_add(pair->compliance, body_1->compliance, body_2->compliance, prec);
    arb_add(pair->inverse_radius, body_1->inverse_radius, body_2->inverse_radius, prec);
    arb_add(pair->inverse_mass, body_1->inverse_mass, body_2->inverse_mass, prec);

    arb_rsqrt(pair->rho, pair->inverse_radius, prec);
    arb_mul_ui(pair->rho, pair->rho, 4, prec);
    arb_div_ui(pair->rho, pair->rho, 3, prec);
    arb_div(pair->rho, pair->rho, pair->compliance, prec);

    arb_mul(pair->dissipation_time, body_1->dissipation_time, body_1->compliance, prec);
    arb_addmul(pair->dissipation_time, body_2->dissipation_time, body_2->compliance, prec);
    arb_div(pair->dissipation_time, pair->dissipation_time, pair->compliance, prec);
}

/* beta g^(-1/5) = (3/2) A (rho/m)^(2/5), docs/derivation.md, (1.1) */
static void beta_of_materials(arb_t beta, const struct embed_request *request, slong prec)
{
    struct body body_1, body_2;
    struct pair pair;
    body_init(&body_1);
    body_init(&body_2);
    pair_init(&pair);
    body_set(&body_1, request, 1, prec);
    body_set(&body_2, request, 2, prec);
    pair_set(&pair, &body_1, &body_2, prec);
    arb_mul(beta, pair.rho, pair.inverse_mass, prec);
    arb_pow_ratio(beta, beta, ratio_make(2, 5), prec);
    arb_mul(beta, beta, pair.dissipation_time, prec);
    arb_mul_ui(beta, beta, 3, prec);
    arb_mul_2exp_si(beta, beta, -1);
    body_clear(&body_1);
    body_clear(&body_2);
    pair_clear(&pair);
}

/* ---- the characteristic speed ---- */

/* |C_1| = (2/(a+1)) X_0^(b+1) B((b+1)/(a+1), 3/2), X_0 = ((a+1)/2)^(1/(a+1)): docs/derivation.md, 9. For spheres this
 * is sqrt(pi) Gamma(3/5)/(2^(1/5) 5^(2/5) Gamma(21/10)), (30) of Ramirez et al. (1999). */
static void first_coefficient(arb_t c, const struct law *law, slong prec)
{
    const struct ratio one = {1, 1}, half = {1, 2}, two = {2, 1};
    const struct ratio a1 = ratio_add(law->a, one), b1 = ratio_add(law->b, one), s = ratio_div(b1, a1);
    arb_t factor;
    arb_init(factor);
    arb_set_ratio(factor, ratio_div(a1, two), prec);
    arb_pow_ratio(c, factor, s, prec);
    arb_div(c, c, factor, prec);
    arb_set_ratio(factor, s, prec);
    arb_gamma(factor, factor, prec);
    arb_mul(c, c, factor, prec);
    arb_set_ratio(factor, ratio_add(s, ratio_add(one, half)), prec);
    arb_gamma(factor, factor, prec);
    arb_div(c, c, factor, prec);
    arb_const_pi(factor, prec); /* Gamma(3/2) = sqrt(pi)/2 */
    arb_sqrt(factor, factor, prec);
    arb_mul(c, c, factor, prec);
    arb_mul_2exp_si(c, c, -1);
    arb_clear(factor);
}

/* beta g^-q = g*^-q/|C_1|, from eps = 1 - (g/g*)^q + ... = 1 - |C_1| beta + ..., (29) to (31) */
static void beta_of_g_star(arb_t beta, const struct decimal *g_star, const struct law *law, slong prec)
{
    arb_t c;
    arb_init(c);
    first_coefficient(c, law, prec);
    arb_set_fmpq(beta, g_star->value, prec);
    arb_pow_ratio(beta, beta, law_speed_exponent(law), prec);
    arb_mul(beta, beta, c, prec);
    arb_inv(beta, beta, prec);
    arb_clear(c);
}

/* ---- beta at a speed ---- */

static void beta_of_beta(arb_t beta, const struct embed_request *request, const struct law *law, slong prec)
{
    arb_t power;
    arb_init(power);
    arb_set_fmpq(power, request->number[EMBED_AT].value, prec);
    arb_pow_ratio(power, power, law_speed_exponent(law), prec);
    arb_set_fmpq(beta, request->number[EMBED_BETA].value, prec);
    arb_div(beta, beta, power, prec);
    arb_clear(power);
}

/* ---- the force K x^a + C x^b x' ---- */

/* beta g^-q = (C/m) (m/K)^((b+1)/(a+1)): docs/derivation.md, 9 */
static void beta_of_force(arb_t beta, const struct embed_request *request, const struct law *law, slong prec)
{
    const struct ratio one = {1, 1};
    arb_t mass, factor;
    arb_init(mass);
    arb_init(factor);
    arb_set_fmpq(mass, request->number[EMBED_EFFECTIVE_MASS].value, prec);
    arb_set_fmpq(factor, request->number[EMBED_STIFFNESS].value, prec);
    arb_div(factor, mass, factor, prec);
    arb_pow_ratio(beta, factor, ratio_div(ratio_add(law->b, one), ratio_add(law->a, one)), prec);
    arb_set_fmpq(factor, request->number[EMBED_DAMPING_COEFFICIENT].value, prec);
    arb_mul(beta, beta, factor, prec);
    arb_div(beta, beta, mass, prec);
    arb_clear(mass);
    arb_clear(factor);
}

void embed_contact_beta_per_root(arb_t beta_per_root, const struct embed_request *request, const struct law *law,
                                 slong prec)
{
    if (embed_given(request, EMBED_G_STAR))
        beta_of_g_star(beta_per_root, &request->number[EMBED_G_STAR], law, prec);
    else if (embed_given(request, EMBED_BETA))
        beta_of_beta(beta_per_root, request, law, prec);
    else if (embed_given(request, EMBED_STIFFNESS))
        beta_of_force(beta_per_root, request, law, prec);
    else
        beta_of_materials(beta_per_root, request, prec);
}
