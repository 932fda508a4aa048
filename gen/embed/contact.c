/* SPDX-License-Identifier: MIT */
#include "embed/contact.h"

#include "support/local.h"

/* ---- two bodies: include/cor/contact.h ---- */

static const fmpq *number_of(const struct embed_request *request, int which, int body)
{
    return embed_number_of_body(request, which, body)->value;
}

/* c_i = (1 - nu_i^2)/Y_i */
static void compliance_of(fmpq_t c, const struct embed_request *request, int body)
{
    fmpq_set_si(c, 1, 1);
    fmpq_submul(c, number_of(request, COR_SCENE_POISSON, body), number_of(request, COR_SCENE_POISSON, body));
    fmpq_div(c, c, number_of(request, COR_SCENE_YOUNG, body));
}

/* m_i, or m_i = (4/3) pi R_i^3 density_i if the mass is not given */
static void mass_of(arb_t mass, const struct embed_request *request, int body, slong prec)
{
    if (embed_mass_is_given(request, body)) {
        arb_set_fmpq(mass, number_of(request, COR_SCENE_MASS, body), prec);
        return;
    }
    LOCAL(fmpq, volume);
    LOCAL(arb, pi);
    fmpq_pow_si(volume, number_of(request, COR_SCENE_RADIUS, body), 3);
    fmpq_mul(volume, volume, number_of(request, COR_SCENE_DENSITY, body));
    fmpq_mul_ui(volume, volume, 4);
    arb_const_pi(pi, prec);
    arb_set_fmpq(mass, volume, prec);
    arb_mul(mass, mass, pi, prec);
    arb_div_ui(mass, mass, 3, prec);
}

/* beta g^(-1/5) = (3/2) A (rho/m)^(2/5), docs/theory.md, (1.1), with rho = (4/3) sqrt(R)/(c_1 + c_2) and A = (A_1
 * c_1 + A_2 c_2)/(c_1 + c_2). A wall has 1/R = 1/m = 0. */
static void beta_of_materials(arb_t beta, const struct embed_request *request, slong prec)
{
    LOCAL(fmpq, c, compliance, inverse_radius, time, x);
    LOCAL(arb, inverse_mass, mass);
    for (int body = 1; body <= 2; body++) {
        compliance_of(c, request, body);
        fmpq_add(compliance, compliance, c);
        fmpq_addmul(time, number_of(request, COR_SCENE_DISSIPATION_TIME, body), c);
        if (body == 2 && request->wall)
            continue;
        fmpq_inv(x, number_of(request, COR_SCENE_RADIUS, body));
        fmpq_add(inverse_radius, inverse_radius, x);
        mass_of(mass, request, body, prec);
        arb_inv(mass, mass, prec);
        arb_add(inverse_mass, inverse_mass, mass, prec);
    }
    /* (rho/m)^2 */
    fmpq_mul(x, compliance, compliance);
    fmpq_mul(x, x, inverse_radius);
    fmpq_mul_ui(x, x, 9);
    fmpq_inv(x, x);
    fmpq_mul_ui(x, x, 16);
    arb_sqr(inverse_mass, inverse_mass, prec);
    arb_set_fmpq(beta, x, prec);
    arb_mul(beta, beta, inverse_mass, prec);
    arb_root_ui(beta, beta, 5, prec);
    fmpq_div(time, time, compliance);
    arb_set_fmpq(mass, time, prec);
    arb_mul(beta, beta, mass, prec);
    arb_mul_ui(beta, beta, 3, prec);
    arb_mul_2exp_si(beta, beta, -1);
}

/* ---- the characteristic speed ---- */

/* |C_1| = (2/(a+1)) X_0^(b+1) B((b+1)/(a+1), 3/2), X_0 = ((a+1)/2)^(1/(a+1)): docs/theory.md, 9. For spheres this
 * is sqrt(pi) Gamma(3/5)/(2^(1/5) 5^(2/5) Gamma(21/10)), (30) of Ramirez et al. (1999). */
static void first_coefficient(arb_t c, const struct law *law, slong prec)
{
    const struct ratio one = {1, 1}, half = {1, 2}, two = {2, 1};
    const struct ratio a1 = ratio_add(law->a, one), b1 = ratio_add(law->b, one), s = ratio_div(b1, a1);
    LOCAL(arb, factor);
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
}

/* beta g^-q = g*^-q/|C_1|, from eps = 1 - (g/g*)^q + ... = 1 - |C_1| beta + ..., (29) to (31) */
static void beta_of_g_star(arb_t beta, const struct decimal *g_star, const struct law *law, slong prec)
{
    LOCAL(arb, c);
    first_coefficient(c, law, prec);
    arb_set_fmpq(beta, g_star->value, prec);
    arb_pow_ratio(beta, beta, law_speed_exponent(law), prec);
    arb_mul(beta, beta, c, prec);
    arb_inv(beta, beta, prec);
}

/* ---- beta at a speed ---- */

static void beta_of_beta(arb_t beta, const struct embed_request *request, const struct law *law, slong prec)
{
    LOCAL(arb, power);
    arb_set_fmpq(power, request->number[COR_SCENE_AT].value, prec);
    arb_pow_ratio(power, power, law_speed_exponent(law), prec);
    arb_set_fmpq(beta, request->number[COR_SCENE_BETA].value, prec);
    arb_div(beta, beta, power, prec);
}

/* ---- the force K x^a + C x^b x' ---- */

/* beta g^-q = (C/m) (m/K)^((b+1)/(a+1)): docs/theory.md, 9 */
static void beta_of_force(arb_t beta, const struct embed_request *request, const struct law *law, slong prec)
{
    const struct ratio one = {1, 1};
    LOCAL(arb, mass, factor);
    arb_set_fmpq(mass, request->number[COR_SCENE_EFFECTIVE_MASS].value, prec);
    arb_set_fmpq(factor, request->number[COR_SCENE_STIFFNESS].value, prec);
    arb_div(factor, mass, factor, prec);
    arb_pow_ratio(beta, factor, ratio_div(ratio_add(law->b, one), ratio_add(law->a, one)), prec);
    arb_set_fmpq(factor, request->number[COR_SCENE_DAMPING_COEFFICIENT].value, prec);
    arb_mul(beta, beta, factor, prec);
    arb_div(beta, beta, mass, prec);
}

void embed_contact_beta_per_root(arb_t beta_per_root, const struct embed_request *request, const struct law *law,
                                 slong prec)
{
    if (embed_given(request, COR_SCENE_G_STAR))
        beta_of_g_star(beta_per_root, &request->number[COR_SCENE_G_STAR], law, prec);
    else if (embed_given(request, COR_SCENE_BETA))
        beta_of_beta(beta_per_root, request, law, prec);
    else if (embed_given(request, COR_SCENE_STIFFNESS))
        beta_of_force(beta_per_root, request, law, prec);
    else
        beta_of_materials(beta_per_root, request, prec);
}
