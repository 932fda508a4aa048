/* SPDX-License-Identifier: MIT */
/* Tests every sphere function of the library against the reference: at random points, all doubles near every boundary
 * of a piece, the neighbours of the worst point, special values, contacts. Prints one line for each function; the
 * documentation quotes these lines. Tests the reference itself first (test_reference.c), and functions of floats last
 * (test_floats.c). --help lists the options. */
#include "cor/contact.h"
#include "cor/sphere.h"

#include "reference.h"
#include "search.h"
#include "ulp.h"

#include <stdio.h>

/* A tenth of the points suffices for functions with damping during the approach only: they are short formulas of the
 * largest overlap, which has its own search. */
#define ROW(name, shape, quantity, max_ulp)                                                                            \
    {#name, cor_sphere_##name, shape, max_ulp, quantity, .share = (quantity) >= QUANTITIES ? 10 : 0},
static const struct search_function functions[] = {SPHERE_FUNCTIONS(ROW)};

static long double exact(const struct search_function *f, enum search_shape shape, long double beta)
{
    return reference_value((enum quantity)f->law + (shape == LOSS ? LOSS_OF_EPS : 0), beta);
}

/* ---- random points ---- */

/* Returns a beta, mostly log-uniform in [1e-3, 100], otherwise from the whole range. */
static double random_beta(struct random_state *r)
{
    const double kind = random_uniform(r, 0, 1);
    if (kind < 0.75)
        return exp(log(1e-3) + random_uniform(r, 0, 1) * log(1e5));
    if (kind < 0.85)
        return exp(log(1e-308) + random_uniform(r, 0, 1) * log(1e308) * 2);
    return random_pattern(r, HUGE_VAL);
}

/* Returns an eps: uniform, or near 0 down to the smallest double, or near 1. */
static double random_eps(struct random_state *r)
{
    const double kind = random_uniform(r, 0, 1);
    if (kind < 0.5)
        return random_uniform(r, 0, 1);
    if (kind < 0.75)
        return random_pattern(r, 1);
    return 1 - exp2(-54 * random_uniform(r, 0, 1));
}

static double random_argument(struct random_state *r, const struct search_function *f)
{
    return search_is_inverse(f) ? random_eps(r) : random_beta(r);
}

/* ---- boundaries ---- */

/* The tables have cells of width 1/16 around i/16, in beta at zero overlap and in sqrt(beta) at zero force. The program
 * tests the edges and middles of the first cells, up to these numbers of cells. */
enum { CELLS_IN_BETA = 16 * 16, CELLS_IN_ROOT = 16 * 16 };

/* Edges of regions, ends of the number formats, and arguments whose results are at these ends. Powers of two are
 * added. */
static const double region_boundaries[] = {
    0x1p-1074, 0x1p-1022, 0x1p-149, 0x1p-126, 7.0, 0x1.fffffep+127, 0x1.fffffffffffffp+1023, 1.39e62, 1.01e65, 7.6e304,
};

static void search_boundaries(struct worst *worst, const struct search_function *f, const struct search_options *o)
{
    const uint64_t all = o->points < 1000000 ? 20 : 256, radius = f->share > 0 ? all / f->share : all;
    if (search_is_inverse(f)) {
        for (int i = 0; i <= 256; i++)
            worst_walk(worst, f, o, i / 256.0, radius);
        for (int exponent = -1074; exponent < 0; exponent++)
            worst_walk(worst, f, o, ldexp(1, exponent), 16);
        for (int exponent = -53; exponent < 0; exponent++)
            worst_walk(worst, f, o, 1 - ldexp(1, exponent), radius);
        return;
    }
    for (int i = 1; i <= 2 * CELLS_IN_BETA; i++)
        worst_walk(worst, f, o, i / 32.0, radius);
    for (int i = 1; i <= 2 * CELLS_IN_ROOT; i++)
        worst_walk(worst, f, o, (i / 32.0) * (i / 32.0), radius);
    for (size_t i = 0; i < COUNT_OF(region_boundaries); i++)
        worst_walk(worst, f, o, region_boundaries[i], radius);
    for (int exponent = -1074; exponent < 1024; exponent++)
        worst_walk(worst, f, o, ldexp(1, exponent), exponent > -70 && exponent < 70 ? radius : 16);
}

/* ---- contacts ---- */

/* Returns g^(1/5), by one Newton step after powl, whose exponent is rounded. */
static long double fifth_root(long double g)
{
    const long double r = powl(g, 0.2L), square = r * r;
    return r - (r - g / (square * square)) / 5;
}

/* Returns the error of eps at an impact speed. The unit is (2 + 2 |d ln eps/d ln beta|) 2^-53 eps plus half the
 * smallest subnormal number. */
static double contact_error(enum quantity quantity, double computed, double beta_per_root, double speed)
{
    if (!(speed >= 0))
        return isnan(computed) ? 0 : HUGE_VAL;
    if (speed == 0 || isinf(speed) || beta_per_root == 0)
        return computed == (speed == 0 || beta_per_root == 0) ? 0 : HUGE_VAL;
    const long double beta = beta_per_root * fifth_root(speed), eps = reference_value(quantity, beta);
    const long double sensitivity = beta * fabsl(reference_slope(quantity, beta));
    const long double allowed = eps * COR_CONTACT_EPS_MAX_ERROR(sensitivity / eps) + 0x1p-1075L;
    const long double error = fabsl((long double)computed - eps) / allowed;
    return isnan(error) ? HUGE_VAL : (double)error;
}

struct contact_function {
    const char *name;
    enum quantity quantity;
    double (*value)(const struct cor_sphere_contact *, double);
};

static const struct contact_function contact_functions[] = {
    {"contact_eps_zero_overlap", EPS_ZERO_OVERLAP, cor_contact_eps_zero_overlap},
    {"contact_eps_zero_force", EPS_ZERO_FORCE, cor_contact_eps_zero_force},
};

/* Searches random contacts, each at some speeds. */
static void search_contacts(struct worst *worst, const struct contact_function *f, const struct search_options *o)
{
    enum { SPEEDS = 33 };
    static const double fixed[] = {0.0, -0.0, HUGE_VAL, -1.0, -HUGE_VAL, NAN, COR_SI_LEAST, 0x1.fffffffffffffp+829};
    struct cor_sphere_contact contact;
    struct random_state r = random_seeded(o->seed);
    const uint64_t enough = UINT64_C(100000000), points = o->points < enough ? o->points : enough;
    while (worst->points < points) {
        const double g_star =
            random_uniform(&r, 0, 1) < 0.8 ? exp((random_uniform(&r, 0, 1) - 0.5) * 70) : random_pattern(&r, 1e308);
        if (cor_sphere_contact_init_g_star(&contact, g_star) != 0) /* out of range */
            continue;
        for (int i = 0; i < SPEEDS; i++) {
            const double kind = random_uniform(&r, 0, 1),
                         speed = kind < 0.05  ? fixed[random_below(&r, COUNT_OF(fixed))]
                                 : kind < 0.5 ? g_star * exp((random_uniform(&r, 0, 1) - 0.5) * 40)
                                              : random_pattern(&r, HUGE_VAL);
            const double eps = f->value(&contact, speed);
            if (speed > 0 && speed < HUGE_VAL && !(speed >= COR_SI_LEAST && speed < COR_SI_MOST)) {
                worst->points += isnan(eps) ? 1 : 0; /* out of range */
                continue;
            }
            worst_take(worst, contact_error(f->quantity, eps, contact.beta_per_root, speed), speed);
        }
    }
}

/* ---- running and reporting ---- */

static bool functions_are_good(const struct search_options *o)
{
    bool good = true;
    worst_heading(o->seed);
    for (size_t i = 0; i < COUNT_OF(functions); i++)
        good = search_worst(&functions[i], o) < HUGE_VAL && good;
    for (size_t i = 0; i < COUNT_OF(contact_functions); i++) {
        if (!search_wants(o, contact_functions[i].name))
            continue;
        struct worst worst = {0};
        search_contacts(&worst, &contact_functions[i], o);
        good = worst_report(contact_functions[i].name, &worst, 1) && good;
    }
    printf("contact: error as a part of (2 + 2 |d ln eps/d ln beta|) 2^-53, argument the speed\n");
    return good;
}

static const char help[] = "test_accuracy [--points N] [--stride N] [--threads N] [--seed N] [--only TEXT]\n"
                           "    --points N   random doubles for each function, 1e6 if not said (1e9: a long run)\n"
                           "    --stride N   every Nth float, 2141 if not said (a prime: every last bit occurs)\n"
                           "    --threads N  1 if not said\n"
                           "    --seed N     repeats a run\n"
                           "    --only TEXT  only functions with this in their name\n";

int main(int argc, char **argv)
{
    struct search_options o = {.points = 1000000,
                               .seed = 19990101,
                               .threads = 1,
                               .stride = 2141,
                               .exact = exact,
                               .random_argument = random_argument,
                               .boundaries = search_boundaries,
                               .judges_specials = true,
                               .largest_rise = 1,
                               .radius = 4096};
    const int status = search_options_read(&o, argc, argv, help);
    if (status != 0)
        return status;
    reference_build();
    const bool of_reference = o.only != NULL || reference_is_good(&o), of_doubles = functions_are_good(&o);
    return of_reference && floats_are_good(&o) && of_doubles ? 0 : 1;
}
