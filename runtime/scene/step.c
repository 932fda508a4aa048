/* SPDX-License-Identifier: MIT */
/* The effect of a time step on eps: the dimensionless collision, integrated as in a simulator, from every phase of the
 * first step */
#include "cor/scene.h"

#include <math.h>
#include <string.h>

#include "cor/law.h"
#include "runtime/scene/exponents.h"
#include "runtime/scene/motion.h"
#include "runtime/scene/simulators.h"

const char *const cor_integrator_names[COR_INTEGRATORS + 1] = {"verlet-half-step", "leapfrog",       "symplectic-euler",
                                                               "verlet-full-step", "implicit-euler", NULL};

double cor_scene_elastic_duration_s(const struct cor_scene_contact *contact, double speed_m_s)
{
    const double a = cor_elastic(&contact->law);
    if (!cor_contact_is_sound(contact) || !cor_si_in_range(speed_m_s))
        return NAN;
    const double time = cor_quiet_power(cor_quiet_quotient(contact->mass_kg, contact->stiffness), 1 / (a + 1));
    return cor_quiet_product(cor_quiet_product(cor_hunt_crossley_duration(0, a), time),
                             cor_quiet_power(speed_m_s, (1 - a) / (1 + a)));
}

/* ---- one collision ---- */

enum {
    NODES = 20,     /* nodes in a smooth piece of the phases */
    NODES_LONG = 8, /* the same if one collision needs LONG steps */
    LONG = 1 << 13,
    MOST_PIECES = 256,
    OFTEN = 1 << 10,      /* number of steps between tests for creep to rest */
    MOST_STEPS = 1 << 22, /* largest number of steps of one collision */
    WHOLE_POWER = 32      /* the largest power computed by multiplication */
};
#define FIRST_PHASE 1e-14
/* Bodies in contact with an energy below m (STUCK g)^2/2 part with at most STUCK times the impact speed g, if ever. */
#define STUCK 1e-8
#define HARDLY 1e-6 /* eps below this have the pattern 0, so that jumps between them do not count */
/* The largest change of the speed by the constant force in a step, in units of the impact speed. Above it, bodies that
 * part with the impact speed return within a step. */
#define MOST_PRESS 2.0

struct stepped {
    struct cor_exponents law;
    double a, b, beta, step;
    double press; /* constant force */
    double exact; /* eps */
    double still; /* speed below which bodies with little energy stay in contact */
    double deep;  /* half of the lowest energy_at: below it bodies creep to rest */
    double most;  /* bound of place and velocity, so that no force overflows */
    double ahead; /* the damping force uses the velocity this number of steps after the last half step */
    int roots;    /* this number of square roots gives x^(1/denominator); negative: use pow */
    int implicit; /* the force at the end of the step acts */
    int no_pull;  /* the contact force is never negative */
};

/* Returns x^a + beta x^b v, but 0 if the bodies are apart or if the simulator does not let them pull. */
static double force_at(const struct stepped *m, double x, double v)
{
    double root = x, spring, damper;
    if (!(x > 0))
        return 0;
    if (m->roots >= 0) {
        for (int i = 0; i < m->roots; i++)
            root = sqrt(root);
        spring = whole_power(root, m->law.elastic);
        damper = whole_power(root, m->law.damping);
    } else {
        spring = cor_quiet_power(x, m->a);
        damper = cor_quiet_power(x, m->b);
    }
    double f = spring + m->beta * damper * v;
    if (m->implicit) {
        const double each = m->beta + m->step; /* force per unit of velocity, from damper and spring */
        f = (x + each * (v + m->step * m->press)) / (1 + m->step * each);
    }
    return m->no_pull && f < 0 ? 0 : f;
}

/* A collision from one phase of the first step */
struct bounce {
    double phase, off;     /* off: eps minus the exact eps; NaN if there are too many steps or the motion overflows */
    unsigned long pattern; /* a hash of the steps in which the force pushes; 0 if the bodies stay together */
    long steps;
};

/* Returns twice the energy. Bodies in contact never part if it is below 0. */
static double energy_at(const struct stepped *m, double x, double v)
{
    return v * v + (2 / (m->a + 1) * cor_quiet_power(x, m->a) - 2 * m->press) * x;
}

/* True if the contact force has ended and the bodies fly freely with the velocity `full`. A force of 0 may become
 * positive again if b > a, or if it is positive at the velocity that the damper uses. */
static int has_ended(const struct stepped *m, double x, double v, double full, double f)
{
    return !(x > 0) || (f == 0 && full < 0 && m->a >= m->b && force_at(m, x, v + m->ahead * m->step * m->press) == 0 &&
                        (full * full > 2 * m->press * x || energy_at(m, x, full) < 0));
}

/* Follows a collision. phase: time from first touch to the end of the step in which the bodies touch, in steps. */
static struct bounce follow_bounce(const struct stepped *m, double phase)
{
    const double h = m->step, press = m->press;
    struct bounce one = {phase, (double)NAN, 0, 1};
    double x = phase * h * (1 + press * phase * h / 2), v = 1 + press * h * (phase - 0.5);
    double f = force_at(m, x, v + m->ahead * h * press);
    for (; one.steps < MOST_STEPS; one.steps++) {
        const double before = v, full = v + h / 2 * press; /* velocity at the end of the step, in free flight */
        if (has_ended(m, x, v, full, f)) {
            const double eps = sqrt(fmax(full * full - 2 * press * x, 0)); /* at x = 0 */
            one.pattern = eps > HARDLY ? one.pattern : 0;
            one.off = eps - m->exact;
            return one;
        }
        one.pattern = f == 0 ? one.pattern : 31 * one.pattern + (unsigned long)one.steps;
        v -= h * (f - press);
        if (!(fabs(v) < m->most && fabs(x) < m->most))
            return one;
        const double mean = (before + v) / 2; /* the velocity at x */
        if ((one.steps % OFTEN == 0 && energy_at(m, x, mean) < m->deep) ||
            (((press > 0 && before < 0 && v >= 0) || fabs(v) < m->still) && energy_at(m, x, mean) < STUCK * STUCK)) {
            one.pattern = 0;
            one.off = 0 - m->exact; /* not -0 */
            return one;
        }
        x += h * v;
        f = force_at(m, x, v - m->ahead * h * (f - press));
    }
    return one;
}

static int stepped_init(struct stepped *m, const struct cor_scene_contact *contact, double speed_m_s, int end,
                        double steps, int integrator)
{
    static const int roots[] = {-1, 0, 1, -1, 2};
    const struct cor_exponents *const law = &contact->law;
    const int implicit = integrator == COR_IMPLICIT_EULER;
    if (!cor_contact_is_sound(contact) || !cor_si_in_range(speed_m_s) || contact->adhesion_j_m2 > 0 ||
        contact->plastic || contact->liquid_speed_m_s > 0 ||
        !(end == COR_END_ZERO_OVERLAP || end == COR_END_ZERO_FORCE) || !cor_scene_has_end(contact, end) ||
        integrator < 0 || integrator >= COR_INTEGRATORS || (implicit && !cor_law_is(law, 2, 0)) ||
        !(isgreaterequal(steps, implicit ? COR_SCENE_STEPS_MIN_IMPLICIT : COR_SCENE_STEPS_MIN) &&
          steps <= COR_SCENE_STEPS_MAX))
        return 0;
    const int whole = law->denominator <= 4 && law->elastic <= WHOLE_POWER && law->damping <= WHOLE_POWER;
    m->law = *law;
    m->a = cor_elastic(law);
    m->b = cor_damping(law);
    m->beta = cor_scene_beta(contact, speed_m_s);
    const double duration = cor_hunt_crossley_duration(0, m->a);
    m->step = duration / steps;
    m->press = 0;
    if (contact->force_n > 0)
        m->press =
            cor_quiet_quotient(cor_quiet_product(contact->force_n, cor_scene_elastic_duration_s(contact, speed_m_s)),
                               cor_quiet_product(duration * contact->mass_kg, speed_m_s));
    if (!(isless(m->press * m->step, 1e100) && isless(m->beta, 1e100)))
        return 0;
    m->still = STUCK * fmax(1, sqrt(m->press * cor_quiet_power(m->press, 1 / m->a)));
    m->deep = -m->a / (m->a + 1) * m->press * cor_quiet_power(m->press, 1 / m->a);
    m->most = cor_quiet_power(1e140 / fmax(m->beta, 1), 1 / (fmax(m->a, m->b) + 1));
    m->ahead = integrator == COR_VERLET_FULL_STEP ? 0.5 : 0;
    m->implicit = implicit;
    m->roots = whole ? roots[law->denominator] : -1;
    m->no_pull = end == COR_END_ZERO_FORCE;
    return m->press * m->step <= MOST_PRESS;
}

/* ---- all phases ---- */

/* Moves `low` to the last phase of its pattern, and `high`, which has another pattern, to just above that phase. */
static void halve_phases(struct bounce *low, struct bounce *high, const struct stepped *m)
{
    double width;
    while ((width = high->phase - low->phase) > 1e-7 * fmin(high->phase, 1 - low->phase) ||
           width * fabs(high->off - low->off) > 1e-13) {
        const double middle = low->phase + width / 2;
        if (!(middle > low->phase && middle < high->phase))
            return;
        const struct bounce other = follow_bounce(m, middle);
        *(other.pattern == low->pattern ? low : high) = other;
    }
}

/* Computes the nodes of a piece, in which eps is smooth except for fourth roots at both ends. The substitution t^4 (35
 * - 84 t + 70 t^2 - 20 t^3) in the midpoint rule removes these roots. If a node has another pattern than `low`, the
 * function moves `high` down to the jump and returns 0. */
static int are_alike(double *off, const struct bounce *low, struct bounce *high, struct bounce *beyond,
                     const struct stepped *m, int nodes, int may_differ)
{
    for (int k = 0; k <= nodes; k++) {
        const double t = (k + 0.5) / nodes, part = t * t * t * t * (35 - t * (84 - t * (70 - t * 20)));
        const struct bounce node =
            k == nodes ? *high : follow_bounce(m, low->phase + (high->phase - low->phase) * part);
        if (node.pattern != low->pattern && !may_differ) {
            *high = *low;
            *beyond = node;
            halve_phases(high, beyond, m);
            return 0;
        }
        if (k < nodes)
            off[k] = node.off;
    }
    return 1;
}

/* Averages eps minus `exact` over all phases. */
static int average_phases(struct cor_step_error *error, const struct stepped *m)
{
    const struct bounce last = follow_bounce(m, 1);
    struct bounce low = follow_bounce(m, FIRST_PHASE), high, beyond = last;
    const int nodes = last.steps < LONG ? NODES : NODES_LONG;
    double off[NODES], weight = 0, squares = 0;
    *error = (struct cor_step_error){0, 0, low.off, low.off};
    if (isnan(low.off) || isnan(last.off))
        return COR_FAULT_STEP;
    for (int pieces = 1; low.phase < 1; pieces++, low = beyond) {
        high = beyond = last;
        while (!are_alike(off, &low, &high, &beyond, m, nodes, pieces == MOST_PIECES))
            ;
        for (int k = 0; k < nodes; k++) {
            const double t = (k + 0.5) / nodes, share = (high.phase - low.phase) * pow(t * (1 - t), 3);
            const double away = off[k] - error->bias;
            if (isnan(off[k]))
                return COR_FAULT_STEP;
            weight += share;
            error->bias += share > 0 ? away * share / weight : 0;
            squares += share * away * (off[k] - error->bias);
            error->least = fmin(error->least, off[k]);
            error->largest = fmax(error->largest, off[k]);
        }
    }
    error->bias = fmin(fmax(error->bias, error->least), error->largest);
    if (squares < 0) /* the results grow without bound */
        return COR_FAULT_STEP;
    error->scatter = sqrt(squares / weight);
    return error->scatter < HUGE_VAL ? COR_FAULT_NONE : COR_FAULT_STEP;
}

int cor_scene_step_error(struct cor_step_error *error, const struct cor_scene_contact *contact, double speed_m_s,
                         int end, double steps, int integrator)
{
    struct stepped m;
    int status = stepped_init(&m, contact, speed_m_s, end, steps, integrator)
                     ? cor_scene_eps(&m.exact, contact, speed_m_s, end)
                     : COR_FAULT_STEP;
    if (status == COR_FAULT_NONE)
        status = average_phases(error, &m);
    if (status != COR_FAULT_NONE)
        *error = (struct cor_step_error){(double)NAN, (double)NAN, (double)NAN, (double)NAN};
    return status;
}

/* ---- the step for an error, and the damping for a step ---- */

/* True if bias and scatter are within the tolerance at this number of steps and up to one more. Between two whole
 * numbers of steps the scatter of some laws varies by 100 %. */
static int is_within(int *status, const struct cor_scene_contact *contact, double speed_m_s, int end, double steps,
                     int integrator, double tolerance)
{
    enum { PARTS = 8 };
    struct cor_step_error error;
    for (int k = 0; k < PARTS; k++) {
        const double n = fmin(steps + (double)k / (double)PARTS, COR_SCENE_STEPS_MAX);
        *status = cor_scene_step_error(&error, contact, speed_m_s, end, n, integrator);
        if (*status != COR_FAULT_NONE || fabs(error.bias) > tolerance || error.scatter > tolerance)
            return 0;
    }
    return 1;
}

int cor_scene_step_for(double *steps, const struct cor_scene_contact *contact, double speed_m_s, int end,
                       double tolerance, int integrator)
{
    static const double ratio = 1.2, scanned = 4; /* the scan ends at this multiple of the last n that failed */
    struct stepped m;
    int status = isgreater(tolerance, 0) ? COR_FAULT_NONE : COR_FAULT_STEP;
    *steps = (double)NAN;
    m.press = m.step = 0;
    stepped_init(&m, contact, speed_m_s, end, COR_SCENE_STEPS_MIN, integrator);
    /* the smallest number of steps that stepped_init accepts under the constant force */
    const double least = COR_SCENE_STEPS_MIN * fmax(1, 1.0001 * m.press * m.step / MOST_PRESS);
    double bad = 0, good = least;
    for (double n = good; status == COR_FAULT_NONE && n <= scanned * fmax(bad, least); n *= ratio) {
        if (n > COR_SCENE_STEPS_MAX)
            return COR_FAULT_STEP;
        if (!is_within(&status, contact, speed_m_s, end, n, integrator, tolerance)) {
            bad = n;
            good = n * ratio;
        }
    }
    while (status == COR_FAULT_NONE && bad > 0 && good > 1.001 * bad) {
        const double middle = sqrt(bad * good);
        *(is_within(&status, contact, speed_m_s, end, middle, integrator, tolerance) ? &good : &bad) = middle;
    }
    if (status == COR_FAULT_NONE)
        *steps = good;
    return status;
}

int cor_scene_step_corrected(struct cor_scene_contact *corrected, const struct cor_scene_contact *contact,
                             double speed_m_s, int end, double steps, int integrator)
{
    enum { MOST_CALLS = 100 };
    static const double stride = 1.1, converged = 1e-12, promised = 1e-9;
    struct stepped m;
    struct cor_step_error error = {0, 0, 0, 0};
    struct cor_bracket bracket = {0, 0, 0, 0, 0};
    double factor = 1;
    *corrected = *contact;
    corrected->damping = (double)NAN;
    if (!stepped_init(&m, contact, speed_m_s, end, steps, integrator))
        return COR_FAULT_STEP;
    const double beta = m.beta;
    int status = cor_scene_eps(&m.exact, contact, speed_m_s, end);
    /* The mean eps decreases with the damping, so the Illinois method finds the damping. */
    for (int k = 0; status == COR_FAULT_NONE && k < MOST_CALLS; k++) {
        m.beta = beta * factor;
        status = average_phases(&error, &m);
        if (status == COR_FAULT_NONE &&
            (beta == 0 || fabs(error.bias) < converged ||
             (cor_is_bracketed(&bracket) && bracket.high - bracket.low < 1e-15 * bracket.high))) {
            if (beta > 0 && fabs(error.bias) > promised) /* mean eps jumps past the exact eps: no damping fits */
                return COR_FAULT_NO_DAMPING;
            corrected->damping = contact->damping * factor;
            return COR_FAULT_NONE;
        }
        factor = cor_next_place(&bracket, factor, error.bias, factor * (error.bias > 0 ? stride : 1 / stride));
    }
    return status == COR_FAULT_NONE ? COR_FAULT_NO_DAMPING : status;
}

double cor_simulator_step_damping(const struct cor_simulator_model *model, const struct cor_simulator_target *target,
                                  int same_law, double damping)
{
    if (model->law == COR_LAW_IMPULSE)
        return damping;
    const int crossley = model->law == COR_LAW_HUNT_CROSSLEY, a = target->contacts->law.elastic;
    const struct cor_exponents law =
        crossley ? (struct cor_exponents){a, a, target->contacts->law.denominator} : cor_law_exponents[model->law];
    const struct cor_scene_contact contact =
        cor_model_contact(*target->contacts, same_law && !crossley ? NULL : &law, damping, target->speed_m_s);
    struct cor_scene_contact corrected;
    cor_scene_step_corrected(&corrected, &contact, target->speed_m_s, (int)model->end, target->steps,
                             cor_simulator_of(model->id)->integrator);
    return isgreater(contact.damping, 0) ? damping * (corrected.damping / contact.damping) : damping;
}
