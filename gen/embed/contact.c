/* SPDX-License-Identifier: MIT */
#include "embed/scene.h"

#include "enclosure/collision.h"
#include "support/console.h"
#include "support/local.h"
#include "support/root.h"

/* ---- bodies: include/cor/contact.h ---- */

typedef const fmpq *exact; /* a number as written */

static exact number_of(const struct embed_request *request, int which, int body)
{
    return embed_number_of_body(request, which, body)->value;
}

/* Computes m, K, A and R = 1/(1/R_1 + 1/R_2) of two bodies: K = (4/3) sqrt(R)/(c_1 + c_2) and A =
 * (A_1 c_1 + A_2 c_2)/(c_1 + c_2), c_i = (1 - nu_i^2)/Y_i. m_i is given or (4/3) pi R_i^3 rho_i. A wall and a plate
 * have 1/R = 1/m = 0. A plate of thickness h has A_2 = 0, and m/Z is added to A, Z = 4 h^2 sqrt(rho_2/(3 c_2)). A_i is
 * given, or 0, or follows from viscosities as (1 + nu)/(1 - nu) ((2/3) (1 - nu + nu^2) eta_1 + (1 - 2 nu)^2 eta_2)/Y.
 * Without bodies, m and K are the given effective mass and stiffness. */
static void contact_of(arb_t m, arb_t K, arb_t A, arb_t R, const struct embed_request *request, slong prec)
{
    const exact h = request->number[COR_SCENE_PLATE_THICKNESS].value, rho = number_of(request, COR_SCENE_DENSITY, 2);
    const bool plate = request->law == COR_LAW_PLATE, timed = embed_given(request, COR_SCENE_DISSIPATION_TIME);
    LOCAL(arb, c, compliance, curvature, time, inverse);
    if (!embed_given(request, COR_SCENE_YOUNG)) {
        arb_set_fmpq(m, request->number[COR_SCENE_EFFECTIVE_MASS].value, prec);
        arb_set_fmpq(K, request->number[COR_SCENE_STIFFNESS].value, prec);
        if (timed)
            arb_set_fmpq(A, request->number[COR_SCENE_DISSIPATION_TIME].value, prec);
        return;
    }
    for (int body = 1; body <= 2; body++) {
        const exact nu = number_of(request, COR_SCENE_POISSON, body), Y = number_of(request, COR_SCENE_YOUNG, body),
                    r = number_of(request, COR_SCENE_RADIUS, body), mass = number_of(request, COR_SCENE_MASS, body),
                    density = number_of(request, COR_SCENE_DENSITY, body);
        const char *const viscosity = request->viscosity[body == 2 && request->viscosity[1] ? 1 : 0];
        struct decimal eta[2] = {{0}};
        LET(c, prec, "(1 - nu^2)/Y", nu, Y);
        LET(compliance, prec, "compliance + c", compliance, c);
        if (viscosity && embed_viscosity(eta, viscosity))
            LET(time, prec, "(1 + nu)/(1 - nu)*(2/3*(1 - nu + nu^2)*eta[0].value + (1 - 2*nu)^2*eta[1].value)/Y", nu,
                eta[0].value, eta[1].value, Y);
        else if (timed)
            arb_set_fmpq(time, number_of(request, COR_SCENE_DISSIPATION_TIME, body), prec);
        decimal_clear(&eta[0]);
        decimal_clear(&eta[1]);
        if (body == 1 || !plate)
            LET(A, prec, "A + time*c", A, time, c);
        if (body == 1 || !(request->wall || plate)) {
            LET(curvature, prec, "curvature + 1/r", curvature, r);
            LET(inverse, prec,
                embed_mass_is_given(request, body) ? "inverse + 1/mass" : "inverse + 3/(4*r^3*density*pi)", inverse,
                mass, r, density);
        }
    }
    LET(m, prec, "1/inverse", inverse);
    LET(R, prec, "1/curvature", curvature);
    LET(K, prec, "4/3/compliance*sqrt(R)", compliance, R);
    LET(A, prec, plate ? "A/compliance + m/(4*h^2*sqrt(rho/(3*c)))" : "A/compliance", A, compliance, m, h, rho, c);
}

/* ---- beta ---- */

/* Computes beta g^-q = g*^-q/|C_1|, which follows from eps = 1 - (g/g*)^q + ... = 1 - |C_1| beta + ..., where |C_1| =
 * (2/(a+1)) X_0^(b+1) B((b+1)/(a+1), 3/2), X_0 = ((a+1)/2)^(1/(a+1)): docs/theory.md, 9. For spheres |C_1| is
 * sqrt(pi) Gamma(3/5)/(2^(1/5) 5^(2/5) Gamma(21/10)), (29) to (31) of Ramirez et al. (1999). */
static void beta_of_g_star(arb_t beta, exact g_star, const struct cor_exponents *law, slong prec)
{
    const struct ratio q = law_speed_exponent(law);
    LOCAL(arb, c);
    LOCAL(fmpq, h, s);
    EXACT(h, "(law->a + 1)/2", law);
    EXACT(s, "(law->b + 1)/(law->a + 1)", law);
    /* Gamma(3/2) = sqrt(pi)/2 */
    LET(c, prec, "h^s/h*gamma(s)/gamma(s + 3/2)*sqrt(pi)/2", h, s);
    LET(beta, prec, "1/(g_star^q*c)", g_star, q, c);
}

/* ---- a measured restitution ---- */

enum { SOLVE_BITS = 192, ROOT_BITS = 80, ROOT_BITS_PRESSED = 150 };

int embed_contact_eps(arb_t eps, const arb_t beta, const arb_t pressing, const struct cor_exponents *law, int end,
                      slong bits)
{
    const bool force = end != COR_END_ZERO_OVERLAP && law_force_ends(law) && !arb_is_zero(beta);
    LOCAL_INIT(collision, c, (&c));
    const int status =
        collision_solve_pressed(&c, beta, pressing, law, force ? COR_END_ZERO_FORCE : COR_END_ZERO_OVERLAP, bits);
    arb_set(eps, force ? c.eps_zero_force : c.eps_zero_overlap);
    return status ? STATUS_FAILED : STATUS_OK;
}

/* The eps to find. given: the constant force, or the impact speed of spheres that yield */
struct measured {
    arb_srcptr wanted, given;
    const struct cor_exponents *law;
    int end, *status;
};

/* Computes eps minus the measured eps. The difference falls with beta. */
static bool eps_above(arb_t f, const arb_t beta, const void *context, slong prec)
{
    const struct measured *const m = context;
    *m->status = embed_contact_eps(f, beta, m->given, m->law, m->end, prec);
    arb_sub(f, f, m->wanted, prec);
    return *m->status == STATUS_OK;
}

/* Encloses the beta at which eps is the given restitution. */
static int beta_of_restitution(arb_t beta, const arb_t force, const struct embed_request *request,
                               const struct cor_scene_contact *contact, const struct cor_exponents *law)
{
    const exact eps = request->number[COR_SCENE_RESTITUTION].value, at = request->number[COR_SCENE_AT].value;
    const struct ratio q = law_speed_exponent(law), power = RATIO("-2*law->a/(law->a + 1)", law);
    if (fmpq_is_one(eps) || law_is_linear(law)) {
        arb_set_d(beta, cor_scene_beta(contact, 1));
        return STATUS_OK;
    }
    LOCAL(arb, pressing, wanted);
    arb_set_fmpq(wanted, eps, SOLVE_BITS);
    arb_set_d(beta, cor_scene_beta(contact, embed_number(request, COR_SCENE_AT)));
    LET(pressing, 2 * SOLVE_BITS, "force*at^power", force, at, power);
    int status = STATUS_OK;
    const struct measured measured = {wanted, pressing, law, request->end, &status};
    if (!root_near(beta, eps_above, &measured, arb_is_zero(pressing) ? ROOT_BITS : ROOT_BITS_PRESSED, SOLVE_BITS))
        return status ? STATUS_FAILED
                      : fail("found no damping that gives the eps of --restitution; give another --restitution");
    LET(beta, SOLVE_BITS, "beta/at^q", beta, at, q);
    return STATUS_OK;
}

/* ---- yield, and a liquid ---- */

void embed_elastic_plastic_eps(arb_t eps, const arb_t speed, const arb_t yield_speed, slong prec)
{
    LOCAL(arb, r, t);
    arb_div(r, yield_speed, speed, prec);
    LET(t, prec, "r*sqrt(5/(6 - r^2))", r);
    LET(eps, prec, "(108*t/((t^2 + 5)^2*(t + 2)))^(1/4)", t);
}

/* Subtracts the eps of a yield speed from the measured eps. The difference falls with the yield speed. */
static bool eps_below(arb_t f, const arb_t yield_speed, const void *context, slong prec)
{
    const struct measured *const m = context;
    embed_elastic_plastic_eps(f, m->given, yield_speed, prec);
    arb_sub(f, m->wanted, f, prec);
    return true;
}

/* Encloses the yield speed v_y that gives the restitution at the speed of --at. */
static int yield_speed_of_restitution(arb_t speed, const struct embed_request *request, double guess, slong prec)
{
    LOCAL(arb, at, wanted);
    const struct measured measured = {.wanted = wanted, .given = at};
    arb_set_fmpq(at, request->number[COR_SCENE_AT].value, prec);
    arb_set_fmpq(wanted, request->number[COR_SCENE_RESTITUTION].value, prec);
    arb_set_d(speed, guess);
    if (fmpq_is_one(request->number[COR_SCENE_RESTITUTION].value))
        arb_set(speed, at);
    else if (!root_near(speed, eps_below, &measured, prec / 2, prec) || !arb_lt(speed, at))
        return fail("--restitution is too close to 1 to enclose the yield speed; use a smaller value");
    return STATUS_OK;
}

int embed_contact_numbers(arb_t beta_per_root, arb_t force, arb_t yield_speed, arb_t liquid_speed,
                          const struct embed_request *request, const struct cor_scene_contact *contact, slong prec)
{
    const struct decimal *const number = request->number;
    const exact zeta = number[COR_SCENE_ZETA].value, beta = number[COR_SCENE_BETA].value,
                at = number[COR_SCENE_AT].value, C = number[COR_SCENE_DAMPING_COEFFICIENT].value,
                gravity = number[COR_SCENE_GRAVITY].value, w = number[COR_SCENE_ADHESION].value,
                p = number[COR_SCENE_YIELD_STRESS].value, outer = number[COR_SCENE_GAP_OUTER].value,
                inner = number[COR_SCENE_GAP_INNER].value, eta = number[COR_SCENE_LIQUID_VISCOSITY].value;
    const struct cor_exponents *const law = &contact->law;
    const struct ratio q = law_speed_exponent(law), a = law_elastic(law), b = law_damping(law);
    LOCAL(arb, m, K, A, R);
    if (embed_given(request, COR_SCENE_YOUNG) || embed_given(request, COR_SCENE_STIFFNESS))
        contact_of(m, K, A, R, request, prec);
    if (embed_given(request, COR_SCENE_GRAVITY))
        arb_set_fmpq(force, gravity, prec);
    if (embed_given(request, COR_SCENE_ADHESION))
        LET(force, prec, "force + 2*pi*w*R/m", force, w, R, m);
    if (!arb_is_zero(force))
        LET(force, prec, "force*(m/K)^(1/(a + 1))", force, m, K, a);
    if (embed_given(request, COR_SCENE_LIQUID_VISCOSITY))
        LET(liquid_speed, prec, "6*pi*eta*R^2*log(outer/inner)/m", eta, R, outer, inner, m);
    if (embed_given(request, COR_SCENE_RESTITUTION))
        return contact->plastic ? yield_speed_of_restitution(yield_speed, request, contact->yield_speed_m_s, prec)
                                : beta_of_restitution(beta_per_root, force, request, contact, law);
    /* plastic: v_y^2 = (pi^5/30) p_y^5 R^3/(E*^4 m), E* = 3 K/(4 sqrt(R)), p_y = 1.6 p for the yield stress p */
    if (contact->plastic)
        LET(yield_speed, prec, "sqrt((p*8/5*pi)^5/30*R^5/(K*3/4)^4/m)", p, R, K, m);
    else if (embed_given(request, COR_SCENE_G_STAR))
        beta_of_g_star(beta_per_root, number[COR_SCENE_G_STAR].value, law, prec);
    else if (embed_given(request, COR_SCENE_ZETA))
        LET(beta_per_root, prec, "zeta*sqrt(2*(a + 1))", zeta, a);
    else if (embed_given(request, COR_SCENE_BETA))
        LET(beta_per_root, prec, law_is_linear(law) ? "beta" : "beta/at^q", beta, at, q);
    else if (embed_given(request, COR_SCENE_DURATION))
        return usage_error("the damping from --duration is not exact enough for a header; replace --duration by --beta "
                           "B --at G, --zeta Z or --restitution E --at G, which corgen contact prints");
    else { /* the force K x^a + C x^b x' has beta g^-q = (C/m) (m/K)^((b+1)/(a+1)); C is given or is (3/2) A K */
        LET(A, prec, embed_given(request, COR_SCENE_DAMPING_COEFFICIENT) ? "C" : "A*K*3/2", C, A, K);
        LET(beta_per_root, prec, "(m/K)^((b + 1)/(a + 1))*A/m", m, K, a, b, A);
    }
    return STATUS_OK;
}
