/* SPDX-License-Identifier: MIT */
/* With dt = (4 u^3 - 1) ds the motion is the polynomial system
 *
 *     du/ds = p,     dp/ds = -(4 u^3 - 1) (f + kappa u^power p),     p = dx/dt
 *
 * which is regular to the end of the tail, 4 u^3 = 1, where dx/du = 0. */
#include "runtime/scene/motion.h"

#include "runtime/scene/exponents.h"

/* broken_at: u at which the contact breaks: 4^(-1/3) at the end of the tail, (3/4)^(1/3) at the largest pull. lost:
 * twice the energy lost between u = 1 and this u, 2 (3/5 + u^4 - (8/3) u^7 + (16/15) u^10). */
static const double broken_at[COR_SCENE_ENDS] = {0.62996052494743658238, 0.90856029641606982944};
static const double lost[COR_SCENE_ENDS] = {1.3259921049894873165, 0.65486382215035810233};

static double inward_speed(const struct motion *m, double s, double level)
{
    return -cor_motion_v(m, s, level);
}

#define LARGEST 1e4                /* largest u to which a motion is followed */
#define REST 1.1447142425533318678 /* u at which the force vanishes, (3/2)^(1/3) */

static double overlap_of(double u)
{
    return u * (u * u * u - 1);
}

/* True if the motion creeps to the equilibrium overlap x_e and never passes it. Let c be the smallest damping
 * coefficient on the way. The condition is c > 2 sqrt(dF/dx) and 0 <= x'/(x_e - x) < c/2. */
static int is_slow(const struct motion *m)
{
    const double u = cor_motion_start(m), low = fmin(u, REST), high = fmax(u, REST), cube = 4 * high * high * high;
    const double c = m->damper.factor * whole_power(low, m->damper.exponent), stiffness = 4 * high * high * (cube - 3);
    const double towards = u < REST ? m->v[0] : -m->v[0];
    return c * c * (cube - 1) > 4 * stiffness && towards >= 0 && towards < c / 2 * (overlap_of(high) - overlap_of(low));
}

/* True if the bodies stay together: the energy, which never grows, is below the potential energy at the next of the two
 * ends. The potential energy is 0 at first touch. */
static int does_stay(const struct motion *m)
{
    const double u = cor_motion_start(m), cube = u * u * u;
    const double potential = 3 / 5.0 + cube * u * (1 - cube * (8 / 3.0 - 16 / 15.0 * cube));
    return m->v[0] * m->v[0] + 2 * potential < lost[u > broken_at[COR_END_ZERO_FORCE]];
}

/* True if no product of a motion with these numbers overflows */
static int is_moderate(double kappa, double speed)
{
    return isless(kappa, 1e40) && isgreater(speed, 1e-40) && isless(speed, 1e40);
}

/* Solves the collision in the units of motion.h. */
static int solve_jkr(struct cor_full_impact *impact, double kappa, int power, double speed)
{
    struct motion m = {
        .time = {{4, 3, 0}, {-1, 0, 0}}, .spring = {{8.0 / 3, 6, 0}, {-4, 3, 0}}, .damper = {kappa, power, 0}};
    *impact = cor_together;
    if (!is_moderate(kappa, speed) || !cor_motion_init(&m, 1, speed) ||
        !cor_motion_compress(&m, &impact->force_max, is_slow))
        return COR_FAULT_PRESSED;
    impact->max_overlap = overlap_of(m.v[0] > 0 ? REST : cor_motion_start(&m));
    for (int k = 0; cor_motion_start(&m) > broken_at[COR_END_ZERO_OVERLAP] && !does_stay(&m) && !is_slow(&m); k++) {
        if (k == MOTION_MOST_STEPS || !cor_motion_expand(&m))
            return COR_FAULT_PRESSED;
        if (cor_motion_v(&m, m.step, 0) > 0) /* the bodies approach again: the step ends at this turning point */
            m.step = cor_motion_root(&m, inward_speed, k == 0 ? m.step * 0x1p-20 : 0, m.step, 0);
        for (int end = 0; end < COR_SCENE_ENDS; end++)
            if (cor_motion_start(&m) > broken_at[end] && cor_motion_u(&m, m.step, broken_at[end]) <= 0) {
                const double s = cor_motion_root(&m, cor_motion_u, 0, m.step, broken_at[end]);
                impact->eps[end] = -cor_motion_v(&m, s, 0) / speed;
                impact->duration[end] = cor_motion_t(&m, s);
            }
        cor_motion_advance(&m);
    }
    if (kappa == 0) /* exact, without cancellation next to the sticking speed */
        for (int end = 0; end < COR_SCENE_ENDS; end++) {
            const double stick = sqrt(lost[end]);
            impact->eps[end] = speed > stick ? sqrt((speed - stick) * (speed + stick)) / speed : 0;
        }
    return COR_FAULT_NONE;
}

/* Returns the sticking speed, from a motion backward in time that starts at rest at the end of contact. The end of the
 * tail is a saddle, which the motion leaves along the unstable direction. */
static double sticking_speed(double kappa, int power, int end)
{
    const double start = end == COR_JKR_TAIL && isless(kappa, INFINITY) ? 1e-7 / (1 + kappa) : 0, u = broken_at[end];
    struct motion m = {
        .time = {{4, 3, 0}, {-1, 0, 0}}, .spring = {{8.0 / 3, 6, 0}, {-4, 3, 0}}, .damper = {-kappa, power, 0}};
    const double slope = 12 * u * u, pull = 4 * u * u * u * (1 - 2.0 / 3 * u * u * u);
    if (!is_moderate(kappa, 1))
        return NAN;
    if (kappa == 0)
        return sqrt(lost[end]);
    if (!cor_motion_init(&m, u + start, start * sqrt(slope * pull)))
        return NAN;
    for (int k = 0, turned = 0; k < MOTION_MOST_STEPS && cor_motion_start(&m) < LARGEST; k++) {
        if (!cor_motion_expand(&m)) /* the motion has left the range of speeds */
            break;
        const double begin =
            turned || cor_motion_v(&m, m.step, 0) > 0 ? 0 : cor_motion_root(&m, cor_motion_v, 0, m.step, 0);
        turned = turned || begin > 0;
        if (turned && cor_motion_u(&m, m.step, 1) <= 0)
            return -cor_motion_v(&m, cor_motion_root(&m, cor_motion_u, begin, m.step, 1), 0);
        cor_motion_advance(&m);
    }
    return INFINITY;
}

/* ---- in SI units ---- */

int cor_jkr_has_law(const struct cor_exponents *law)
{
    const int power = 4 * law->damping / law->denominator;
    return cor_law_is_hertz(law) && 4 * law->damping % law->denominator == 0 && (power <= 2 || power == 6);
}

struct units {
    double length, time, force, speed, kappa;
    int power;
};

static struct units units_of(const struct cor_scene_contact *contact, double coefficient)
{
    const double w = contact->adhesion_j_m2, R = contact->radius_m, b = cor_damping(&contact->law);
    const double modulus = cor_si_quotient(0.75 * contact->stiffness, sqrt(R)); /* E* */
    const double area = cor_si_product(cor_si_product(2 * COR_PI * w, R), R);
    const double radius = cbrt(cor_si_quotient(area, modulus)); /* c_0 */
    struct units unit = {.length = cor_si_quotient(radius * radius, R), .force = cor_si_product(COR_PI * w, R)};
    unit.power = cor_jkr_has_law(&contact->law) ? (int)(4 * b) : 0;
    unit.time = sqrt(cor_si_quotient(cor_si_product(contact->mass_kg, unit.length), unit.force));
    unit.speed = cor_si_quotient(unit.length, unit.time);
    const double strength =
        cor_quiet_product(cor_quiet_product(coefficient, cor_quiet_power(unit.length, b)), unit.speed);
    unit.kappa = cor_jkr_has_law(&contact->law) ? cor_quiet_quotient(strength, unit.force) : (double)NAN;
    return unit;
}

int cor_jkr_impact(struct cor_full_impact *impact, const struct cor_scene_contact *contact, double coefficient,
                   double speed_m_s)
{
    const struct units unit = units_of(contact, coefficient);
    const int status = solve_jkr(impact, unit.kappa, unit.power, cor_quiet_quotient(speed_m_s, unit.speed));
    for (int end = 0; end < COR_SCENE_ENDS; end++)
        impact->duration[end] = cor_quiet_product(impact->duration[end], unit.time);
    impact->max_overlap = cor_quiet_product(impact->max_overlap, unit.length);
    impact->force_max = cor_quiet_product(impact->force_max, unit.force);
    return status;
}

double cor_jkr_sticking_speed(const struct cor_scene_contact *contact, double coefficient, int end)
{
    const struct units unit = units_of(contact, coefficient);
    return cor_quiet_product(unit.speed, sticking_speed(unit.kappa, unit.power, end));
}
