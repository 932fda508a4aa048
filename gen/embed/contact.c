/* SPDX-License-Identifier: MIT */
#include "embed/contact.h"

#include "enclosure/collision.h"
#include "support/console.h"
#include "support/local.h"

/* ---- bodies: include/cor/contact.h ---- */

static const fmpq *number_of(const struct embed_request *request, int which, int body)
{
    return embed_number_of_body(request, which, body)->value;
}

/* (1 - nu^2)/Y */
static void compliance_of(fmpq_t c, const struct embed_request *request, int body)
{
    fmpq_mul(c, number_of(request, COR_SCENE_POISSON, body), number_of(request, COR_SCENE_POISSON, body));
    fmpq_sub_ui(c, c, 1);
    fmpq_neg(c, c);
    fmpq_div(c, c, number_of(request, COR_SCENE_YOUNG, body));
}

/* A_i; of viscosities (1 + nu)/(1 - nu) ((2/3) (1 - nu + nu^2) eta_1 + (1 - 2 nu)^2 eta_2)/Y */
static void dissipation_time_of(fmpq_t time, const struct embed_request *request, int body)
{
    const char *const viscosity = request->viscosity[body == 2 && request->viscosity[1] ? 1 : 0];
    fmpq_zero(time);
    if (!viscosity) {
        if (embed_given(request, COR_SCENE_DISSIPATION_TIME))
            fmpq_set(time, number_of(request, COR_SCENE_DISSIPATION_TIME, body));
        return;
    }
    const fmpq *const nu = number_of(request, COR_SCENE_POISSON, body);
    struct decimal eta[2] = {{0}};
    LOCAL(fmpq, x, minus);
    embed_viscosity(eta, viscosity);
    fmpq_neg(minus, nu);
    fmpq_add_ui(minus, minus, 1); /* 1 - nu */
    fmpq_mul(x, nu, nu);
    fmpq_add(x, x, minus);
    fmpq_mul(time, x, eta[0].value);
    fmpq_mul_ui(time, time, 2);
    fmpq_div_fmpz(time, time, (fmpz[]){3});
    fmpq_sub(x, minus, nu);
    fmpq_mul(x, x, x);
    fmpq_addmul(time, x, eta[1].value);
    fmpq_add_ui(x, nu, 1);
    fmpq_div(x, x, minus);
    fmpq_mul(time, time, x);
    fmpq_div(time, time, number_of(request, COR_SCENE_YOUNG, body));
    decimal_clear(&eta[0]);
    decimal_clear(&eta[1]);
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

/* m/Z, Z = 4 h^2 sqrt(E rho/(3 (1 - nu^2))) of the plate */
static void plate_time(arb_t time, const struct embed_request *request, const arb_t mass, slong prec)
{
    LOCAL(fmpq, c, x);
    fmpq_pow_si(x, request->number[COR_SCENE_PLATE_THICKNESS].value, 4);
    fmpq_mul_ui(x, x, 16);
    fmpq_mul(x, x, number_of(request, COR_SCENE_DENSITY, 2));
    compliance_of(c, request, 2);
    fmpq_mul_ui(c, c, 3);
    fmpq_div(x, x, c); /* Z^2 */
    arb_set_fmpq(time, x, prec);
    arb_sqrt(time, time, prec);
    arb_div(time, mass, time, prec);
}

/* m, K = (4/3) sqrt(R)/(c_1 + c_2) and A = (A_1 c_1 + A_2 c_2)/(c_1 + c_2) of two bodies. A wall and a plate have 1/R =
 * 1/m = 0; a plate has A_2 = 0, and m/Z is added to A. */
static void bodies_of(arb_t mass, arb_t stiffness, arb_t time, const struct embed_request *request, slong prec)
{
    const bool plate = request->law == COR_LAW_PLATE;
    LOCAL(fmpq, c, compliance, inverse_radius, weighted, x);
    LOCAL(arb, inverse_mass);
    for (int body = 1; body <= 2; body++) {
        compliance_of(c, request, body);
        fmpq_add(compliance, compliance, c);
        dissipation_time_of(x, request, body);
        if (body == 1 || !plate)
            fmpq_addmul(weighted, x, c);
        if (body == 2 && (request->wall || plate))
            continue;
        fmpq_inv(x, number_of(request, COR_SCENE_RADIUS, body));
        fmpq_add(inverse_radius, inverse_radius, x);
        mass_of(mass, request, body, prec);
        arb_inv(mass, mass, prec);
        arb_add(inverse_mass, inverse_mass, mass, prec);
    }
    arb_inv(mass, inverse_mass, prec);
    fmpq_mul(x, compliance, compliance);
    fmpq_mul(x, x, inverse_radius);
    fmpq_mul_ui(x, x, 9);
    fmpq_inv(x, x);
    fmpq_mul_ui(x, x, 16);
    arb_set_fmpq(stiffness, x, prec);
    arb_sqrt(stiffness, stiffness, prec);
    fmpq_div(x, weighted, compliance);
    if (plate)
        plate_time(time, request, mass, prec);
    else
        arb_zero(time);
    arb_set_fmpq(inverse_mass, x, prec);
    arb_add(time, time, inverse_mass, prec);
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
    arb_set_fmpq(beta, request->number[COR_SCENE_BETA].value, prec);
    if (law_is_linear(law))
        return;
    LOCAL(arb, power);
    arb_set_fmpq(power, request->number[COR_SCENE_AT].value, prec);
    arb_pow_ratio(power, power, law_speed_exponent(law), prec);
    arb_div(beta, beta, power, prec);
}

/* ---- the force K x^a + C x^b x' ---- */

/* beta g^-q = (C/m) (m/K)^((b+1)/(a+1)): docs/theory.md, 9. C is given, or (3/2) A K. */
static void beta_of_force(arb_t beta, const struct embed_request *request, const struct law *law, slong prec)
{
    const struct ratio one = {1, 1};
    LOCAL(arb, mass, stiffness, coefficient);
    if (embed_given(request, COR_SCENE_YOUNG)) {
        bodies_of(mass, stiffness, coefficient, request, prec);
    } else {
        arb_set_fmpq(mass, request->number[COR_SCENE_EFFECTIVE_MASS].value, prec);
        arb_set_fmpq(stiffness, request->number[COR_SCENE_STIFFNESS].value, prec);
        if (embed_given(request, COR_SCENE_DISSIPATION_TIME))
            arb_set_fmpq(coefficient, request->number[COR_SCENE_DISSIPATION_TIME].value, prec);
    }
    if (embed_given(request, COR_SCENE_DAMPING_COEFFICIENT)) {
        arb_set_fmpq(coefficient, request->number[COR_SCENE_DAMPING_COEFFICIENT].value, prec);
    } else {
        arb_mul(coefficient, coefficient, stiffness, prec);
        arb_mul_ui(coefficient, coefficient, 3, prec);
        arb_mul_2exp_si(coefficient, coefficient, -1);
    }
    arb_div(stiffness, mass, stiffness, prec);
    arb_pow_ratio(beta, stiffness, ratio_div(ratio_add(law->b, one), ratio_add(law->a, one)), prec);
    arb_mul(beta, beta, coefficient, prec);
    arb_div(beta, beta, mass, prec);
}

/* R of 1/R = 1/R_1 + 1/R_2 */
static void radius_of(arb_t radius, const struct embed_request *request, slong prec)
{
    LOCAL(fmpq, inverse, x);
    for (int body = 1; body <= (request->wall || request->law == COR_LAW_PLATE ? 1 : 2); body++) {
        fmpq_inv(x, number_of(request, COR_SCENE_RADIUS, body));
        fmpq_add(inverse, inverse, x);
    }
    fmpq_inv(x, inverse);
    arb_set_fmpq(radius, x, prec);
}

/* ---- a constant force ---- */

/* -2a/(a+1): the power of the speed in f */
static struct ratio force_power(const struct law *law)
{
    return ratio_div(ratio_mul(ratio_make(-2, 1), law->a), ratio_add(law->a, ratio_make(1, 1)));
}

/* (F/m) (m/K)^(1/(a+1)), F = m G + 2 pi w R */
void embed_contact_force(arb_t force, const struct embed_request *request, const struct law *law, slong prec)
{
    const bool heavy = embed_given(request, COR_SCENE_GRAVITY), sticky = embed_given(request, COR_SCENE_ADHESION);
    LOCAL(arb, mass, stiffness, x);
    arb_zero(force);
    if (!heavy && !sticky)
        return;
    if (embed_given(request, COR_SCENE_YOUNG)) {
        bodies_of(mass, stiffness, x, request, prec);
    } else {
        arb_set_fmpq(mass, request->number[COR_SCENE_EFFECTIVE_MASS].value, prec);
        arb_set_fmpq(stiffness, request->number[COR_SCENE_STIFFNESS].value, prec);
    }
    if (sticky) {
        radius_of(force, request, prec);
        arb_set_fmpq(x, request->number[COR_SCENE_ADHESION].value, prec);
        arb_mul(force, force, x, prec);
        arb_const_pi(x, prec);
        arb_mul(force, force, x, prec);
        arb_mul_2exp_si(force, force, 1);
        arb_div(force, force, mass, prec);
    }
    if (heavy) {
        arb_set_fmpq(x, request->number[COR_SCENE_GRAVITY].value, prec);
        arb_add(force, force, x, prec);
    }
    arb_div(x, mass, stiffness, prec);
    arb_pow_ratio(x, x, ratio_div(ratio_make(1, 1), ratio_add(law->a, ratio_make(1, 1))), prec);
    arb_mul(force, force, x, prec);
}

/* ---- a measured restitution ---- */

enum {
    SOLVE_BITS = 192,
    SOLVE_HALF_WIDTH = -80, /* powers of two */
    SOLVE_HALF_WIDTH_PRESSED = -150,
    SOLVE_STEPS = 8
};

int embed_contact_eps(arb_t eps, const arb_t beta, const arb_t pressing, const struct law *law, int end, slong bits)
{
    struct collision c;
    const bool force = end == END_ZERO_FORCE && law_force_ends(law) && !arb_is_zero(beta);
    collision_init(&c);
    const int status = !arb_is_zero(pressing)
                           ? collision_solve_pressed(&c, beta, pressing, law, end, bits)
                           : (force ? collision_solve_force : collision_solve_overlap)(&c, beta, law, bits);
    arb_set(eps, force ? c.eps_zero_force : c.eps_zero_overlap);
    collision_clear(&c);
    return status ? STATUS_FAILED : STATUS_OK;
}

/* Encloses the beta at which eps, which falls with it, is `wanted`: secants until eps is above it at one end of a
 * narrow ball, and below at the other. */
static int solve_beta(arb_t beta, const arb_t wanted, const arb_t pressing, const struct law *law, int end)
{
    const slong half_width = arb_is_zero(pressing) ? SOLVE_HALF_WIDTH : SOLVE_HALF_WIDTH_PRESSED;
    LOCAL(arb, low, high, above, below, slope);
    for (int step = 0; step < SOLVE_STEPS; step++) {
        arb_get_mid_arb(beta, beta);
        arb_mul_2exp_si(slope, beta, half_width);
        arb_sub(low, beta, slope, SOLVE_BITS);
        arb_add(high, beta, slope, SOLVE_BITS);
        arb_get_mid_arb(low, low); /* an exact beta, with which eps has all of its bits */
        arb_get_mid_arb(high, high);
        if (embed_contact_eps(above, low, pressing, law, end, SOLVE_BITS) != STATUS_OK ||
            embed_contact_eps(below, high, pressing, law, end, SOLVE_BITS) != STATUS_OK)
            return STATUS_FAILED;
        if (arb_gt(above, wanted) && arb_lt(below, wanted)) {
            arb_union(beta, low, high, SOLVE_BITS);
            return STATUS_OK;
        }
        arb_sub(slope, above, below, SOLVE_BITS);
        arb_sub(high, high, low, SOLVE_BITS);
        arb_div(slope, slope, high, SOLVE_BITS);
        arb_sub(above, above, wanted, SOLVE_BITS);
        arb_div(above, above, slope, SOLVE_BITS);
        arb_add(beta, low, above, SOLVE_BITS);
        if (!arb_is_positive(beta))
            break;
    }
    return fail("no damping found at which eps is that of --restitution");
}

static int beta_of_restitution(arb_t beta, const struct embed_request *request, const struct cor_scene_contact *contact,
                               const struct law *law)
{
    const fmpq *const eps = request->number[COR_SCENE_RESTITUTION].value;
    if (fmpq_is_one(eps) || law_is_linear(law)) {
        arb_set_d(beta, cor_scene_beta(contact, 1));
        return STATUS_OK;
    }
    LOCAL(arb, wanted, power, pressing);
    arb_set_fmpq(wanted, eps, SOLVE_BITS);
    arb_set_d(beta, cor_scene_beta(contact, embed_number(request, COR_SCENE_AT)));
    embed_contact_force(pressing, request, law, 2 * SOLVE_BITS);
    arb_set_fmpq(power, request->number[COR_SCENE_AT].value, 2 * SOLVE_BITS);
    arb_pow_ratio(power, power, force_power(law), 2 * SOLVE_BITS);
    arb_mul(pressing, pressing, power, 2 * SOLVE_BITS);
    const int status = solve_beta(beta, wanted, pressing, law, request->end);
    arb_set_fmpq(power, request->number[COR_SCENE_AT].value, SOLVE_BITS);
    arb_pow_ratio(power, power, law_speed_exponent(law), SOLVE_BITS);
    arb_div(beta, beta, power, SOLVE_BITS);
    return status;
}

int embed_contact_beta_per_root(arb_t beta_per_root, const struct embed_request *request,
                                const struct cor_scene_contact *contact, const struct law *law, slong prec)
{
    if (embed_given(request, COR_SCENE_RESTITUTION))
        return beta_of_restitution(beta_per_root, request, contact, law);
    if (embed_given(request, COR_SCENE_G_STAR)) {
        beta_of_g_star(beta_per_root, &request->number[COR_SCENE_G_STAR], law, prec);
    } else if (embed_given(request, COR_SCENE_ZETA)) { /* zeta sqrt(2 (a + 1)) */
        LOCAL(arb, zeta);
        arb_set_fmpq(zeta, request->number[COR_SCENE_ZETA].value, prec);
        arb_set_ratio(beta_per_root, ratio_mul(ratio_add(law->a, (struct ratio){1, 1}), (struct ratio){2, 1}), prec);
        arb_sqrt(beta_per_root, beta_per_root, prec);
        arb_mul(beta_per_root, beta_per_root, zeta, prec);
    } else if (embed_given(request, COR_SCENE_BETA)) {
        beta_of_beta(beta_per_root, request, law, prec);
    } else {
        beta_of_force(beta_per_root, request, law, prec);
    }
    return STATUS_OK;
}

/* ---- yield, and a liquid ---- */

/* v_y^2 = (pi^5/30) p_y^5 R^3/(E*^4 m), where E* = 3 K/(4 sqrt(R)) */
static void yield_speed_of_stress(arb_t speed, const struct embed_request *request, slong prec)
{
    LOCAL(arb, mass, stiffness, unused, radius, x);
    bodies_of(mass, stiffness, unused, request, prec);
    radius_of(radius, request, prec);
    arb_set_fmpq(speed, request->number[COR_SCENE_YIELD_STRESS].value, prec);
    arb_mul_ui(speed, speed, 8, prec); /* 1.6 */
    arb_div_ui(speed, speed, 5, prec);
    arb_const_pi(x, prec);
    arb_mul(speed, speed, x, prec);
    arb_pow_ui(speed, speed, 5, prec);
    arb_div_ui(speed, speed, 30, prec);
    arb_mul_ui(stiffness, stiffness, 3, prec);
    arb_mul_2exp_si(stiffness, stiffness, -2);
    arb_pow_ui(stiffness, stiffness, 4, prec); /* E*^4 R^2 */
    arb_pow_ui(radius, radius, 5, prec);
    arb_mul(speed, speed, radius, prec);
    arb_div(speed, speed, stiffness, prec);
    arb_div(speed, speed, mass, prec);
    arb_sqrt(speed, speed, prec);
}

void embed_elastic_plastic_eps(arb_t eps, const arb_t speed, const arb_t yield_speed, slong prec)
{
    LOCAL(arb, t, x, y);
    arb_div(t, yield_speed, speed, prec);
    arb_mul(x, t, t, prec);
    arb_sub_ui(x, x, 6, prec);
    arb_neg(x, x);
    arb_set_ui(y, 5);
    arb_div(x, y, x, prec);
    arb_sqrt(x, x, prec);
    arb_mul(t, t, x, prec);
    arb_mul(x, t, t, prec);
    arb_add_ui(x, x, 5, prec);
    arb_mul(x, x, x, prec);
    arb_add_ui(y, t, 2, prec);
    arb_mul(x, x, y, prec);
    arb_mul_ui(t, t, 108, prec);
    arb_div(eps, t, x, prec);
    arb_root_ui(eps, eps, 4, prec);
}

/* v_y between two speeds that the double determines, on whose sides eps(at) lies */
static int yield_speed_of_restitution(arb_t speed, const struct embed_request *request, double guess, slong prec)
{
    LOCAL(arb, at, wanted, low, high, eps);
    arb_set_fmpq(at, request->number[COR_SCENE_AT].value, prec);
    arb_set_fmpq(wanted, request->number[COR_SCENE_RESTITUTION].value, prec);
    if (fmpq_is_one(request->number[COR_SCENE_RESTITUTION].value)) {
        arb_set(speed, at);
        return STATUS_OK;
    }
    arb_set_d(low, guess * (1 - 1e-12));
    arb_set_d(high, guess * (1 + 1e-12));
    for (int sign = -1; sign <= 1; sign += 2) {
        embed_elastic_plastic_eps(eps, at, sign < 0 ? low : high, prec);
        if (!(sign < 0 ? arb_lt(eps, wanted) : arb_gt(eps, wanted) && arb_lt(high, at)))
            return fail("the yield speed of --restitution cannot be enclosed: eps is too near to 1");
    }
    for (slong i = 0; i < prec / 2; i++) { /* eps grows with v_y */
        arb_add(speed, low, high, prec);
        arb_mul_2exp_si(speed, speed, -1);
        arb_get_mid_arb(speed, speed);
        embed_elastic_plastic_eps(eps, at, speed, prec);
        if (arb_lt(eps, wanted))
            arb_set(low, speed);
        else if (arb_gt(eps, wanted))
            arb_set(high, speed);
        else
            break;
    }
    arb_union(speed, low, high, prec);
    return STATUS_OK;
}

int embed_contact_yield_speed(arb_t speed, const struct embed_request *request, const struct cor_scene_contact *contact,
                              slong prec)
{
    if (embed_given(request, COR_SCENE_RESTITUTION))
        return yield_speed_of_restitution(speed, request, contact->yield_speed_m_s, prec);
    yield_speed_of_stress(speed, request, prec);
    return STATUS_OK;
}

/* 6 pi eta R^2 ln(outer/inner)/m */
void embed_contact_liquid_speed(arb_t speed, const struct embed_request *request, slong prec)
{
    LOCAL(arb, mass, stiffness, unused, radius);
    LOCAL(fmpq, x);
    arb_zero(speed);
    if (!embed_given(request, COR_SCENE_LIQUID_VISCOSITY))
        return;
    bodies_of(mass, stiffness, unused, request, prec);
    radius_of(radius, request, prec);
    fmpq_div(x, request->number[COR_SCENE_GAP_OUTER].value, request->number[COR_SCENE_GAP_INNER].value);
    arb_set_fmpq(speed, x, prec);
    arb_log(speed, speed, prec);
    arb_mul(radius, radius, radius, prec);
    arb_mul(speed, speed, radius, prec);
    arb_div(speed, speed, mass, prec);
    fmpq_mul_ui(x, request->number[COR_SCENE_LIQUID_VISCOSITY].value, 6);
    arb_set_fmpq(radius, x, prec);
    arb_mul(speed, speed, radius, prec);
    arb_const_pi(radius, prec);
    arb_mul(speed, speed, radius, prec);
}
