/* SPDX-License-Identifier: MIT */
/* Compares each function of law.h with the formulas of simulators and textbooks: time and error in one table.
 *     cor_bench_laws > speed.csv
 * Arguments are uniform in the interval of the row. Times are the least of many rounds. The error of an eps or a loss
 * is relative. The error of a damping is the relative change of eps that it causes, |eps(damping) - e|/e. Exact values
 * are the long doubles of the tests. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cor/cor.h>

#include "laws.h"
#include "runtime/number/sets.h"
#include "runtime/scene/simulators.h"
#include "support/timing.h"

enum { COUNT = 2048 };

/* ---- exact values ---- */

#define EXACT(name, end, value)                                                                                        \
    static long double exact_##name(long double zeta)                                                                  \
    {                                                                                                                  \
        const long double l = reference_ratio_exponent(end, zeta);                                                     \
        return value;                                                                                                  \
    }
EXACT(eps_overlap, COR_END_ZERO_OVERLAP, expl(-l))
EXACT(eps_force, COR_END_ZERO_FORCE, expl(-l))
EXACT(loss_force, COR_END_ZERO_FORCE, -expm1l(-l))
EXACT(eps_approach, COR_END_APPROACH_ONLY, expl(-l))
EXACT(eps_limited, COR_END_LIMITED, expl(-l))

/* Returns the largest overlap for a = 3/2. There the spring's energy is the energy of the undamped rebound. */
static long double exact_overlap(long double beta)
{
    return powl(1.25L * powl(reference_hunt_crossley_approach_eps(beta), 2), 0.4L);
}

static long double exact_sphere_force(long double beta)
{
    return cor_sphere_eps_zero_force((double)beta); /* accurate to one unit in the last place */
}

/* ---- formulas in use ---- */

static double formula_eps_overlap(double zeta)
{
    return zeta < 1 ? exp(-COR_PI * zeta / sqrt(1 - zeta * zeta)) : 0;
}

/* Returns eps by Schwager and Poeschel's three cases, as Kratos and others do. */
static double formula_eps_force(double zeta)
{
    if (zeta < 0.70710678118654752440) {
        const double om = sqrt(1 - zeta * zeta);
        return exp(-zeta / om * (COR_PI - atan(2 * zeta * om / (1 - 2 * zeta * zeta))));
    }
    if (zeta < 1) {
        const double om = sqrt(1 - zeta * zeta);
        return exp(-zeta / om * atan(2 * zeta * om / (2 * zeta * zeta - 1)));
    }
    const double om = sqrt(zeta * zeta - 1);
    return zeta == 1 ? exp(-2.0) : exp(-zeta / om * log((zeta + om) / (zeta - om)));
}

static double formula_loss_force(double zeta)
{
    return 1 - formula_eps_force(zeta);
}

static double formula_zeta_overlap(double e)
{
    const double l = log(e);
    return -l / sqrt(COR_PI * COR_PI + l * l);
}

static double formula_lankarani(double e)
{
    return 0.75 * (1 - e) * (1 + e);
}

static double formula_thornton(double e)
{
    return sqrt(1.2) * cor_thornton_gamma(e);
}

/* Returns the damping by bisection of [0, 16]. times: number of halvings */
static double bisected(double e, int times)
{
    double low = 0, high = 16;
    for (int k = 0; k < times; k++) {
        const double middle = 0.5 * (low + high);
        *(formula_eps_force(middle) > e ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

static double formula_bisected(double e)
{
    return bisected(e, 18);
}

static double formula_bisected_full(double e)
{
    return bisected(e, 58);
}

static double formula_tsuji_2026(double e)
{
    return sqrt(0.4) * cor_tsuji_alpha(e);
}

/* Inverts Mueller and Poeschel's [1/4] Pade approximant in v* = sqrt(beta) by Newton's method, as simulators do. */
static double formula_sphere_newton(double e)
{
    static const double a1 = 0.501086, b1 = 0.501086, b2 = 1.15345, b3 = 0.577977, b4 = 0.532178;
    double v = 1;
    for (int k = 0; k < 40; k++) {
        const double top = 1 + a1 * v, below = 1 + v * (b1 + v * (b2 + v * (b3 + v * b4)));
        const double slope = a1 / below - top * (b1 + v * (2 * b2 + v * (3 * b3 + v * 4 * b4))) / (below * below);
        const double step = (top / below - e) / slope;
        v -= step;
        if (fabs(step) < 1e-12)
            break;
    }
    return v * v;
}

/* Returns eps = h/beta by Newton's method, where h solves f(-h) = f(beta), f(z) = z - ln(1 + z). */
static double formula_crossley(double beta)
{
    const double wanted = beta - log1p(beta);
    double h = beta / (1 + beta);
    for (int k = 0; k < 40; k++) {
        const double off = -h - log1p(-h) - wanted, next = h - off * (1 - h) / h;
        if (fabs(next - h) < 1e-15)
            break;
        h = next < 1 ? next : (h + 1) / 2;
    }
    return h / beta;
}

static double formula_overlap(double beta)
{
    return pow(2.5 * (beta - log1p(beta)) / (beta * beta), 0.4);
}

static double overlap(double beta)
{
    return cor_hunt_crossley_max_overlap(beta, 1.5);
}

static double duration(double beta)
{
    return cor_hunt_crossley_duration(beta, 1.5);
}

static double duration_by_quadrature(double beta)
{
    return cor_hunt_crossley_duration(beta, 1.25);
}

/* Returns u'/u of elastic spheres with friction 0.3, whose contact remembers its displacement. */
static double oblique(double tangent)
{
    static const struct cor_scene_contact contact = {.law = {3, 1, 2}, .mass_kg = 1, .stiffness = 1, .radius_m = 1};
    struct cor_oblique_impact impact = {.restitution = NAN};
    cor_scene_oblique(&impact, &contact, &(struct cor_tangential){.kappa = 4.5}, 0.3, 1, tangent, 0);
    return impact.restitution;
}

static long double exact_oblique(long double tangent)
{
    return oblique((double)tangent); /* within COR_OBLIQUE_ERROR */
}

/* Integrates the impact of oblique() by velocity Verlet with 1000 steps, as LAMMPS does. */
static double formula_oblique(double tangent)
{
    const double h = 3.218e-3;
    double x = h, v = 1, u = tangent, s = h * u;
    for (; x > 0; x += h * v, s += h * u) {
        const double root = sqrt(x), force = x * root, g = fmax(fmin(4.5 * root * s, 1.05 * force), -1.05 * force);
        s = g / (4.5 * root);
        v -= h * force;
        u -= h * g;
    }
    return u / tangent;
}

/* ---- the table ---- */

typedef double scalar_function(double x);
typedef long double exact_function(long double x);

enum { SCALAR = -1, MAX_JOBS = 128 };

/* Replaces the library's function. Array functions then use the instruction set `array_set`. */
static int array_set;
int cor_array_set(void)
{
    return array_set;
}

/* OF: a function of law.h, whose array is timed in every instruction set. OTHER: any other function */
#define OF(LAW, END, QUANTITY) NULL, COR_LAW_##LAW, COR_END_##END, COR_##QUANTITY
#define OTHER(function) function, COR_LAW_VISCOELASTIC, COR_END_ZERO_FORCE, COR_EPS
static const struct method {
    const char *quantity, *method;
    scalar_function *scalar; /* NULL: from law.h */
    enum cor_law law;
    enum cor_end end;
    enum cor_quantity of;
    exact_function *exact; /* exact value, or exact eps for an inverse; NULL: none available */
    int inverse;
    double low, high; /* range of the argument */
} methods[] = {
    {"eps of zeta; zero overlap", "cor", OF(LINEAR, ZERO_OVERLAP, EPS), exact_eps_overlap, 0, 0.01, 0.8},
    {"eps of zeta; zero overlap", "exp(-pi zeta/sqrt(1-zeta^2))", OTHER(formula_eps_overlap), exact_eps_overlap, 0,
     0.01, 0.8},
    {"eps of zeta; zero force", "cor", OF(LINEAR, ZERO_FORCE, EPS), exact_eps_force, 0, 0.01, 2},
    {"eps of zeta; zero force", "three cases: atan or ln; exp", OTHER(formula_eps_force), exact_eps_force, 0, 0.01, 2},
    {"1-eps of zeta; zero force; zeta < 1e-4", "cor", OF(LINEAR, ZERO_FORCE, LOSS), exact_loss_force, 0, 1e-6, 1e-4},
    {"1-eps of zeta; zero force; zeta < 1e-4", "1 - the three cases", OTHER(formula_loss_force), exact_loss_force, 0,
     1e-6, 1e-4},
    {"eps of zeta; approach only", "cor", OF(LINEAR, APPROACH_ONLY, EPS), exact_eps_approach, 0, 0.01, 2},
    {"eps of zeta; limited damper", "cor", OF(LINEAR, LIMITED, EPS), exact_eps_limited, 0, 0.01, 2},
    {"zeta of eps; zero overlap", "cor", OF(LINEAR, ZERO_OVERLAP, DAMPING_OF_EPS), exact_eps_overlap, 1, 0.1, 0.99},
    {"zeta of eps; zero overlap", "-ln(e)/sqrt(pi^2+ln(e)^2)", OTHER(formula_zeta_overlap), exact_eps_overlap, 1, 0.1,
     0.99},
    {"zeta of eps; zero overlap", "LAMMPS tsuji since July 2026: degree 6", OTHER(formula_tsuji_2026),
     exact_eps_overlap, 1, 0.1, 0.99},
    {"zeta of eps; zero force", "cor", OF(LINEAR, ZERO_FORCE, DAMPING_OF_EPS), exact_eps_force, 1, 0.1, 0.99},
    {"zeta of eps; zero force", "Thornton: degree 10; exp; sqrt", OTHER(formula_thornton), exact_eps_force, 1, 0.1,
     0.99},
    {"zeta of eps; zero force", "bisected to 0.0001 (Kratos)", OTHER(formula_bisected), exact_eps_force, 1, 0.1, 0.99},
    {"zeta of eps; zero force", "bisected to the last bit", OTHER(formula_bisected_full), exact_eps_force, 1, 0.1,
     0.99},
    {"zeta of eps; zero force", "the zero-overlap formula (Chrono)", OTHER(formula_zeta_overlap), exact_eps_force, 1,
     0.1, 0.99},
    {"zeta of eps; limited damper", "cor", OF(LINEAR, LIMITED, DAMPING_OF_EPS), exact_eps_limited, 1, 0.1, 0.99},
    {"eps of beta; Hunt-Crossley", "cor", OF(HUNT_CROSSLEY, ZERO_FORCE, EPS), reference_hunt_crossley_eps, 0, 0.01, 5},
    {"eps of beta; Hunt-Crossley", "Newton's method with log1p", OTHER(formula_crossley), reference_hunt_crossley_eps,
     0, 0.01, 5},
    {"beta of eps; Hunt-Crossley", "cor", OF(HUNT_CROSSLEY, ZERO_FORCE, DAMPING_OF_EPS), reference_hunt_crossley_eps, 1,
     0.1, 0.99},
    {"beta of eps; Hunt-Crossley", "Flores: 8(1-e)/(5e)", OTHER(cor_flores_beta), reference_hunt_crossley_eps, 1, 0.1,
     0.99},
    {"beta of eps; Hunt-Crossley", "Lankarani and Nikravesh: 3(1-e^2)/4", OTHER(formula_lankarani),
     reference_hunt_crossley_eps, 1, 0.1, 0.99},
    {"largest overlap; Hunt-Crossley; a = 3/2", "cor", OTHER(overlap), exact_overlap, 0, 0.01, 5},
    {"largest overlap; Hunt-Crossley; a = 3/2", "log1p and pow", OTHER(formula_overlap), exact_overlap, 0, 0.01, 5},
    {"duration; Hunt-Crossley; a = 3/2", "cor", OTHER(duration), NULL, 0, 0.01, 5},
    {"duration; Hunt-Crossley; a = 5/4", "cor", OTHER(duration_by_quadrature), NULL, 0, 0.01, 5},
    {"duration; Tsuji; zero overlap", "cor", OF(TSUJI, ZERO_OVERLAP, DURATION), NULL, 0, 0.01, 0.65},
    {"duration; Tsuji; zero force", "cor", OF(TSUJI, ZERO_FORCE, DURATION), NULL, 0, 0.01, 2},
    {"eps of beta; Hertz and constant dashpot; zero overlap", "cor", OF(HERTZ_DASHPOT, ZERO_OVERLAP, EPS), NULL, 0,
     0.01, 1.1},
    {"eps of beta; Hertz and constant dashpot; zero force", "cor", OF(HERTZ_DASHPOT, ZERO_FORCE, EPS), NULL, 0, 0.2, 5},
    {"1-eps of beta; Hertz and constant dashpot; zero overlap", "cor", OF(HERTZ_DASHPOT, ZERO_OVERLAP, LOSS), NULL, 0,
     0.01, 1.1},
    {"duration; Hertz and constant dashpot; zero force", "cor", OF(HERTZ_DASHPOT, ZERO_FORCE, DURATION), NULL, 0, 0.2,
     5},
    {"beta of eps; Hertz and constant dashpot; zero force", "cor", OF(HERTZ_DASHPOT, ZERO_FORCE, DAMPING_OF_EPS), NULL,
     1, 0.1, 0.49},
    {"beta of eps; Hertz and constant dashpot; zero overlap", "cor", OF(HERTZ_DASHPOT, ZERO_OVERLAP, DAMPING_OF_EPS),
     NULL, 1, 0.1, 0.99},
    {"beta of eps; Hertz and constant dashpot; approach only", "cor", OF(HERTZ_DASHPOT, APPROACH_ONLY, DAMPING_OF_EPS),
     NULL, 1, 0.1, 0.99},
    {"beta of eps; sphere; zero force", "cor", OF(VISCOELASTIC, ZERO_FORCE, DAMPING_OF_EPS), exact_sphere_force, 1, 0.1,
     0.99},
    {"beta of eps; sphere; zero force", "Newton's method on a Pade", OTHER(formula_sphere_newton), exact_sphere_force,
     1, 0.1, 0.99},
    {"u'/u of tan(angle); mindlin; friction 0.3", "cor", OTHER(oblique), NULL, 0, 0.12, 0.36},
    {"u'/u of tan(angle); mindlin; friction 0.3", "velocity Verlet; 1000 steps", OTHER(formula_oblique), exact_oblique,
     0, 0.12, 0.36},
};
enum { METHODS = sizeof methods / sizeof *methods };

struct line {
    const struct method *method;
    int set; /* SCALAR: the scalar function */
    const char *set_name;
    double x[COUNT], y[COUNT], error;
};

static void run_line(void *closure)
{
    struct line *line = closure;
    const struct method *const m = line->method;
    const struct cor_law_function *const law = cor_law_function(m->law, m->end, m->of);
    scalar_function *const f = m->scalar ? m->scalar : law->value;
    array_set = line->set;
    if (line->set == SCALAR)
        for (int i = 0; i < COUNT; i++)
            line->y[i] = f(line->x[i]);
    else
        law->array(line->x, line->y, COUNT);
}

static double worst_error(const struct line *line)
{
    long double worst = 0;
    for (int i = 0; i < COUNT; i++) {
        const long double exact = line->method->inverse ? line->x[i] : line->method->exact(line->x[i]);
        const long double value = line->method->inverse ? line->method->exact(line->y[i]) : line->y[i];
        worst = fmaxl(worst, fabsl(value / exact - 1));
    }
    return (double)worst;
}

static int add_line(struct line *line, const struct method *method, int set)
{
    static const char *const name[COR_INSTRUCTION_SETS] = {"portable", "AVX2", "AVX-512"};
    if (set >= 0 && !cor_processor_has(set))
        return 0;
    line->method = method;
    line->set = set;
    line->set_name = set >= 0 ? name[set] : "scalar";
    /* scattered, but the same in every run: multiples of the golden ratio */
    for (int i = 0; i < COUNT; i++)
        line->x[i] = method->low + (method->high - method->low) * fmod(0.61803398874989485 * (i + 1), 1);
    return 1;
}

int main(int argc, char **argv)
{
    static struct line lines[MAX_JOBS];
    struct job jobs[MAX_JOBS];
    int n = 0;
    for (const struct method *m = methods; m < methods + METHODS; m++)
        for (int set = SCALAR; set < (m->scalar ? 0 : COR_INSTRUCTION_SETS); set++)
            n += add_line(&lines[n], m, set);
    for (int i = 0; i < n; i++)
        jobs[i] = (struct job){run_line, &lines[i], COUNT, 0};
    const int quick = argc > 1 && strcmp(argv[1], "--quick") == 0;
    timing_measure(jobs, (size_t)n, (struct timing){2e5, quick ? 20 : 400, 4});
    printf("quantity,method,instructions,ns,relative_error\n");
    for (int i = 0; i < n; i++) {
        char error[32] = "";
        if (lines[i].method->exact)
            snprintf(error, sizeof error, "%.2g", worst_error(&lines[i]));
        printf("%s,%s%s,%s,%.3g,%s\n", lines[i].method->quantity, lines[i].method->method,
               lines[i].set >= 0 ? " array" : "", lines[i].set_name, jobs[i].best_ns, error);
    }
    return 0;
}
