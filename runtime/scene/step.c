/* SPDX-License-Identifier: MIT */
/* What the time step of a simulator does to eps: the dimensionless collision, integrated as the simulator does, from
 * all phases of the first step */
#include "runtime/scene/inside.h"

#include <math.h>
#include <string.h>

#include "cor/law.h"
#include "runtime/scene/exponents.h"
#include "runtime/scene/motion.h"
#include "runtime/scene/simulators.h"

const char *const cor_integrator_names[COR_INTEGRATORS + 1] = {"verlet-half-step", "leapfrog", "symplectic-euler",
                                                               "verlet-full-step", NULL};

int cor_simulator_integrator(const char *simulator)
{
    enum { MOST = 7 };
    static const char *const of[COR_INTEGRATORS][MOST] = {
        [COR_VERLET_HALF_STEP] = {"lammps", "liggghts", "mercurydpm", "openfoam"},
        [COR_LEAPFROG] = {"yade"},
        [COR_SYMPLECTIC_EULER] = {"chrono", "mfix", "kratos", "mujoco", "newton", "esys-particle"}};
    for (int i = 0; i < COR_INTEGRATORS; i++)
        for (int k = 0; of[i][k]; k++)
            if (strcmp(of[i][k], simulator) == 0)
                return i;
    return COR_NO_INTEGRATOR;
}

double cor_scene_elastic_duration_s(const struct cor_scene_contact *contact, double speed_m_s)
{
    const double a = cor_elastic(&contact->law);
    return cor_hunt_crossley_duration(0, a) * pow(contact->mass_kg / contact->stiffness, 1 / (a + 1)) *
           pow(speed_m_s, (1 - a) / (1 + a));
}

/* ---- one collision ---- */

enum {
    PHASES = 128,         /* of the first step; with 256 the mean changes by less than a 50th of the scatter */
    PHASES_LEAST = 16,    /* where collisions are long, as many phases as take */
    ALL_STEPS = 1 << 20,  /* steps together */
    MOST_STEPS = 1 << 22, /* of one collision */
    WHOLE_POWER = 32      /* the largest power by multiplication */
};
/* Bodies in contact that have less energy than m (STUCK g)^2/2 do not part with more than STUCK times the impact speed
 * g. */
#define STUCK 1e-8

struct stepped {
    struct cor_exponents law;
    double a, b, beta, step;
    double ahead; /* the damping force takes the velocity so many steps after the last half step */
    int roots;    /* so many square roots give x^(1/denominator); negative: pow */
    int no_pull;  /* the contact ends at zero force */
};

/* x^a + beta x^b v, but 0 where the bodies are apart and where the simulator does not let them pull */
static double force(const struct stepped *m, double x, double v)
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
        spring = pow(x, m->a);
        damper = pow(x, m->b);
    }
    const double f = spring + m->beta * damper * v;
    return m->no_pull && f < 0 ? 0 : f;
}

/* The rebound speed where the overlap is `phase` steps of free flight after the first step that ends in contact; NaN
 * where the steps are too many or the motion leaves the doubles. */
static double rebound(const struct stepped *m, double phase, long *steps)
{
    const double h = m->step, spring_energy = 2 / (m->a + 1);
    double x = phase * h, v = 1, f = force(m, x, v);
    for (*steps = 1; *steps < MOST_STEPS; ++*steps) {
        v -= h * f;
        x += h * v;
        /* with b > a the force may push again after zero */
        if (!(x > 0) || (f == 0 && v < 0 && m->a >= m->b))
            return fabs(v) < HUGE_VAL ? -v : (double)NAN;
        if (v < STUCK && v > -STUCK && v * v + spring_energy * pow(x, m->a + 1) < STUCK * STUCK)
            return 0;
        f = force(m, x, v - m->ahead * h * f);
    }
    return (double)NAN;
}

static int stepped_init(struct stepped *m, const struct cor_scene_contact *contact, double speed_m_s, int end,
                        double steps, int integrator)
{
    static const int roots[] = {-1, 0, 1, -1, 2};
    const struct cor_exponents *const law = &contact->law;
    const int whole = law->denominator <= 4 && law->elastic <= WHOLE_POWER && law->damping <= WHOLE_POWER;
    m->law = *law;
    m->a = cor_elastic(law);
    m->b = cor_damping(law);
    m->beta = cor_scene_beta(contact, speed_m_s);
    m->step = cor_hunt_crossley_duration(0, m->a) / steps;
    m->ahead = integrator == COR_VERLET_FULL_STEP ? 0.5 : 0;
    m->roots = whole ? roots[law->denominator] : -1;
    m->no_pull = end == COR_END_ZERO_FORCE;
    return !(contact->force_n > 0) && !(contact->adhesion_j_m2 > 0) && !contact->plastic &&
           !(contact->liquid_speed_m_s > 0) && (end == COR_END_ZERO_OVERLAP || end == COR_END_ZERO_FORCE) &&
           cor_scene_has_end(contact, end) && integrator >= 0 && integrator < COR_INTEGRATORS &&
           steps >= COR_SCENE_STEPS_MIN && steps <= COR_SCENE_STEPS_MAX && m->beta >= 0 && m->beta < HUGE_VAL;
}

/* Where between two phases the number of steps changes, as a fraction of their distance, less the middle */
static double jump_between(const struct stepped *m, double phase, double distance, long steps)
{
    double low = 0, high = 1;
    while (high - low > 1e-7) {
        const double middle = (low + high) / 2;
        long other;
        rebound(m, phase + middle * distance, &other);
        *(other == steps ? &low : &high) = middle;
    }
    return (low + high) / 2 - 0.5;
}

/* eps over all phases, less `exact` */
static int phases(struct cor_step_error *error, const struct stepped *m, double exact)
{
    long steps, before = 0;
    double sum = 0, squares = 0, last = 0;
    error->largest = rebound(m, 0.5, &steps) - exact;
    error->least = error->largest;
    if (isnan(error->least))
        return COR_FAULT_STEP;
    const long fit = ALL_STEPS / steps, n = fit > PHASES ? PHASES : fit < PHASES_LEAST ? PHASES_LEAST : fit;
    for (long k = 0; k < n; k++) {
        const double phase = ((double)k + 0.5) / (double)n, off = rebound(m, phase, &steps) - exact;
        if (isnan(off))
            return COR_FAULT_STEP;
        sum += off;
        squares += off * off;
        /* Without x^b the damping force ends in a jump, and eps jumps where the last step does. The value on either
         * side counts up to there. */
        if (m->b == 0 && !m->no_pull && k > 0 && steps != before) {
            const double more = jump_between(m, phase - 1 / (double)n, 1 / (double)n, before);
            sum += more * (last - off);
            squares += more * (last * last - off * off);
        }
        before = steps;
        last = off;
        error->least = fmin(error->least, off);
        error->largest = fmax(error->largest, off);
    }
    error->bias = sum / (double)n;
    error->scatter = sqrt(fmax(squares / (double)n - error->bias * error->bias, 0));
    return COR_FAULT_NONE;
}

int cor_scene_step_error(struct cor_step_error *error, const struct cor_scene_contact *contact, double speed_m_s,
                         int end, double steps, int integrator)
{
    struct stepped m;
    double exact = (double)NAN;
    int status = stepped_init(&m, contact, speed_m_s, end, steps, integrator)
                     ? cor_scene_eps(&exact, contact, speed_m_s, end)
                     : COR_FAULT_STEP;
    if (status == COR_FAULT_NONE)
        status = phases(error, &m, exact);
    if (status != COR_FAULT_NONE)
        *error = (struct cor_step_error){(double)NAN, (double)NAN, (double)NAN, (double)NAN};
    return status;
}

/* ---- the step for an error, and the damping for a step ---- */

/* Whether bias and scatter are within the tolerance at so many steps and up to one more. Between whole numbers of steps
 * the scatter of some laws rises and falls by its own size. */
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
    static const double ratio = 1.2, scanned = 4; /* the scan ends at so many times the steps of the last failure */
    double bad = 0, good = COR_SCENE_STEPS_MIN;
    int status = tolerance > 0 ? COR_FAULT_NONE : COR_FAULT_STEP;
    *steps = (double)NAN;
    for (double n = good; status == COR_FAULT_NONE && n <= scanned * fmax(bad, COR_SCENE_STEPS_MIN); n *= ratio) {
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
    static const double stride = 1.1, converged = 1e-13;
    struct stepped m;
    struct cor_step_error error = {0, 0, 0, 0};
    struct bracket bracket = {0, 0, 0, 0, 0};
    double exact, factor = 1;
    *corrected = *contact;
    corrected->damping = (double)NAN;
    if (!stepped_init(&m, contact, speed_m_s, end, steps, integrator))
        return COR_FAULT_STEP;
    const double beta = m.beta;
    int status = cor_scene_eps(&exact, contact, speed_m_s, end);
    /* The mean falls with the damping: the Illinois method. */
    for (int k = 0; status == COR_FAULT_NONE && k < MOST_CALLS; k++) {
        m.beta = beta * factor;
        status = phases(&error, &m, exact);
        if (status == COR_FAULT_NONE &&
            (beta == 0 || fabs(error.bias) < converged ||
             (is_bracketed(&bracket) && bracket.high - bracket.low < 1e-15 * bracket.high))) {
            corrected->damping = contact->damping * factor;
            return COR_FAULT_NONE;
        }
        factor = next_place(&bracket, factor, error.bias, factor * (error.bias > 0 ? stride : 1 / stride));
    }
    return status == COR_FAULT_NONE ? COR_FAULT_NO_DAMPING : status;
}

double cor_simulator_step_damping(const struct cor_simulator_model *model, const struct cor_simulator_wish *wish,
                                  int same_law, double damping)
{
    if (model->law == COR_LAW_IMPULSE)
        return damping;
    const int crossley = model->law == COR_LAW_HUNT_CROSSLEY, a = wish->contacts->law.elastic;
    const struct cor_exponents law =
        crossley ? (struct cor_exponents){a, a, wish->contacts->law.denominator} : cor_law_exponents[model->law];
    const struct cor_scene_contact contact =
        cor_model_contact(*wish->contacts, same_law && !crossley ? NULL : &law, damping, wish->speed_m_s);
    struct cor_scene_contact corrected;
    cor_scene_step_corrected(&corrected, &contact, wish->speed_m_s, (int)model->end, wish->steps,
                             cor_simulator_integrator(model->simulator));
    return damping * (corrected.damping / contact.damping);
}
