/* SPDX-License-Identifier: MIT */
/* The floating-point environment and the public functions: for valid arguments none raises FE_INVALID, FE_DIVBYZERO or
 * FE_OVERFLOW, also where these trap, and none sets errno; the other rounding modes and flushing to zero change results
 * by less than 1e-9 of them, and no eps leaves [0, 1]; the modes are afterwards what they were. */
#ifdef __linux__
#define _GNU_SOURCE /* feenableexcept */
#endif
#include "check.h"

#include <errno.h>
#include <fenv.h>

#include <cor/cor.h>

#include "cor_sphere.h"
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

enum { MOST_RESULTS = 16, ARRAY = 37 };

/* The numbers that a call may use, each kind over all of its domain */
struct arguments {
    double beta, eps, speed;                          /* of spheres; 0, infinity and tiny ones included */
    double nu, disk_speed, load, energy, compression; /* of disks, up to their limits */
    double part[4];                                   /* of the last four, up to 1 */
    struct cor_sphere_contact contact;
    struct cor_body body[2];
    size_t modes;
    enum cor_disk_datum datum;
    int has_subnormal;
    float betaf, epsf; /* rounded to nearest, whatever the mode of the test */
};

struct results {
    double value[MOST_RESULTS], tolerance[MOST_RESULTS], least[MOST_RESULTS]; /* least: the smallest normal number */
    int count;
};

static void results_put(struct results *r, double value)
{
    assert_in_range(r->count, 0, MOST_RESULTS - 1);
    r->tolerance[r->count] = 1e-9;
    r->least[r->count] = DBL_MIN;
    r->value[r->count++] = value;
}

/* A float may become its neighbour. */
static void put_float(struct results *r, float value)
{
    results_put(r, (double)value);
    r->tolerance[r->count - 1] = (double)FLT_EPSILON;
    r->least[r->count - 1] = (double)FLT_MIN;
}

static float narrow(double x)
{
    return x > (double)FLT_MAX && x <= DBL_MAX ? FLT_MAX : (float)x;
}

/* ---- the calls ---- */

typedef void call(const struct arguments *a, struct results *r);

#define SPHERE_CALL(name, argument)                                                                                    \
    static void call_##name(const struct arguments *a, struct results *r)                                              \
    {                                                                                                                  \
        results_put(r, cor_sphere_##name(a->argument));                                                                \
        put_float(r, cor_sphere_##name##f(a->argument##f));                                                            \
    }                                                                                                                  \
    static void call_##name##_array(const struct arguments *a, struct results *r)                                      \
    {                                                                                                                  \
        double x[ARRAY], y[ARRAY];                                                                                     \
        float xf[ARRAY], yf[ARRAY];                                                                                    \
        for (int i = 0; i < ARRAY; i++) {                                                                              \
            x[i] = i % 7 == 3 ? a->argument : 0.02 * i;                                                                \
            xf[i] = i % 7 == 3 ? a->argument##f : 0.0625F * (float)i;                                                  \
        }                                                                                                              \
        cor_sphere_##name##_array(x, y, ARRAY);                                                                        \
        cor_sphere_##name##_arrayf(xf, yf, ARRAY);                                                                     \
        for (int i = 0; i < 5; i++) {                                                                                  \
            results_put(r, y[i]);                                                                                      \
            put_float(r, yf[i]);                                                                                       \
        }                                                                                                              \
    }
SPHERE_CALL(eps_zero_overlap, beta)
SPHERE_CALL(eps_zero_force, beta)
SPHERE_CALL(loss_zero_overlap, beta)
SPHERE_CALL(loss_zero_force, beta)
SPHERE_CALL(beta_zero_overlap, eps)
SPHERE_CALL(beta_zero_force, eps)
SPHERE_CALL(duration_zero_overlap, beta)
SPHERE_CALL(duration_zero_force, beta)
SPHERE_CALL(max_overlap, beta)
SPHERE_CALL(time_of_max_overlap, beta)

/* Arrays in float arithmetic */
static void call_fast_arrays(const struct arguments *a, struct results *r)
{
    float x[ARRAY], y[ARRAY];
    for (int i = 0; i < ARRAY; i++)
        x[i] = i % 7 == 3 ? a->betaf : 0.0625F * (float)i;
#define FAST_ARRAY(name)                                                                                               \
    cor_sphere_##name##_fast_arrayf(x, y, ARRAY);                                                                      \
    put_float(r, y[3]);                                                                                                \
    put_float(r, y[4]);
    FAST_ARRAY(eps_zero_overlap)
    FAST_ARRAY(eps_zero_force)
    FAST_ARRAY(loss_zero_overlap)
    FAST_ARRAY(loss_zero_force)
    FAST_ARRAY(duration_zero_overlap)
    FAST_ARRAY(duration_zero_force)
    FAST_ARRAY(max_overlap)
    FAST_ARRAY(time_of_max_overlap)
#undef FAST_ARRAY
}

static void call_fast(const struct arguments *a, struct results *r)
{
    put_float(r, cor_sphere_eps_zero_overlap_fastf(a->betaf));
    put_float(r, cor_sphere_eps_zero_force_fastf(a->betaf));
    put_float(r, cor_sphere_loss_zero_overlap_fastf(a->betaf));
    put_float(r, cor_sphere_loss_zero_force_fastf(a->betaf));
}

static void call_fast_times(const struct arguments *a, struct results *r)
{
    put_float(r, cor_sphere_duration_zero_overlap_fastf(a->betaf));
    put_float(r, cor_sphere_duration_zero_force_fastf(a->betaf));
    put_float(r, cor_sphere_max_overlap_fastf(a->betaf));
    put_float(r, cor_sphere_time_of_max_overlap_fastf(a->betaf));
}

/* generated/cor_sphere.h */
static void call_inline(const struct arguments *a, struct results *r)
{
    results_put(r, cor_inline_eps_zero_overlap(a->beta));
    results_put(r, cor_inline_eps_zero_force(a->beta));
    results_put(r, cor_inline_loss_zero_overlap(a->beta));
    results_put(r, cor_inline_loss_zero_force(a->beta));
    results_put(r, cor_inline_eps_zero_overlap_root(a->beta));
    results_put(r, cor_inline_eps_zero_force_root(a->beta));
}

static void call_inline_times(const struct arguments *a, struct results *r)
{
    results_put(r, cor_inline_duration_zero_overlap(a->beta));
    results_put(r, cor_inline_duration_zero_force(a->beta));
    results_put(r, cor_inline_max_overlap(a->beta));
    results_put(r, cor_inline_time_of_max_overlap(a->beta));
    results_put(r, cor_inline_beta_zero_overlap(a->eps));
    results_put(r, cor_inline_beta_zero_force(a->eps));
}

static void call_formulas_of_1999(const struct arguments *a, struct results *r)
{
    results_put(r, cor_sphere_eps_simple(a->beta));
    results_put(r, cor_sphere_eps_simple_fraction(a->beta, 5));
    results_put(r, cor_sphere_eps_published_pade(a->beta));
}

static void call_contact_init(const struct arguments *a, struct results *r)
{
    struct cor_sphere_contact contact;
    results_put(r, cor_sphere_contact_init(&contact, &a->body[0], &a->body[1]));
    results_put(r, contact.beta_per_root);
    results_put(r, contact.scale);
    results_put(r, contact.beta5_per_speed);
    results_put(r, cor_sphere_contact_init_g_star(&contact, a->speed > 0 ? a->speed : 1));
    results_put(r, contact.beta_per_root);
    results_put(r, contact.beta5_per_speed);
    results_put(r, cor_contact_g_star_m_s(&contact));
    results_put(r, cor_contact_g_star_m_s(&a->contact));
    results_put(r, cor_dissipation_time_s(a->body[0].radius_m, a->body[1].mass_kg, a->body[0].young_modulus_pa, 0.25));
    results_put(r, cor_sphere_mass_kg(a->body[0].radius_m, a->body[1].mass_kg));
}

static void call_contact_eps(const struct arguments *a, struct results *r)
{
    results_put(r, cor_contact_eps_zero_overlap(&a->contact, a->speed));
    results_put(r, cor_contact_eps_zero_force(&a->contact, a->speed));
}

static void call_contact(const struct arguments *a, struct results *r)
{
    results_put(r, cor_contact_beta(&a->contact, a->speed));
    results_put(r, cor_contact_duration_s_zero_overlap(&a->contact, a->speed));
    results_put(r, cor_contact_duration_s_zero_force(&a->contact, a->speed));
    results_put(r, cor_contact_max_overlap_m(&a->contact, a->speed));
    results_put(r, cor_contact_dissipation_time_s_zero_overlap(&a->contact, a->speed, a->eps));
    results_put(r, cor_contact_dissipation_time_s_zero_force(&a->contact, a->speed, a->eps));
}

static void call_contact_arrays(const struct arguments *a, struct results *r)
{
    double g[ARRAY], eps[ARRAY], y[ARRAY];
    for (int i = 0; i < ARRAY; i++) {
        g[i] = i % 7 == 3 ? a->speed : 0.1 * i;
        eps[i] = i % 5 == 2 ? a->eps : 0.02 * i;
    }
#define CONTACT_ARRAY(name)                                                                                            \
    cor_contact_##name##_array(&a->contact, g, y, ARRAY);                                                              \
    results_put(r, y[3]);                                                                                              \
    results_put(r, y[4]);
    CONTACT_ARRAY(beta)
    CONTACT_ARRAY(eps_zero_overlap)
    CONTACT_ARRAY(eps_zero_force)
    CONTACT_ARRAY(duration_s_zero_overlap)
    CONTACT_ARRAY(duration_s_zero_force)
    CONTACT_ARRAY(max_overlap_m)
    cor_contact_dissipation_time_s_zero_overlap_array(&a->contact, g, eps, y, ARRAY);
    results_put(r, y[17]);
    cor_contact_dissipation_time_s_zero_force_array(&a->contact, g, eps, y, ARRAY);
    results_put(r, y[17]);
}

static void call_disk_limits(const struct arguments *a, struct results *r)
{
    results_put(r, cor_disk_load_limit(a->nu, a->datum));
    results_put(r, cor_disk_compression_limit(a->nu, a->datum));
    results_put(r, cor_disk_energy_limit(a->nu, a->datum));
    results_put(r, cor_disk_speed_limit(a->nu, a->datum));
}

static void call_disk_law(const struct arguments *a, struct results *r)
{
    results_put(r, cor_disk_load(a->compression, a->nu, a->datum));
    results_put(r, cor_disk_compression(a->load, a->nu, a->datum));
    results_put(r, cor_disk_energy(a->load, a->nu, a->datum));
    results_put(r, cor_disk_load_of_energy(a->energy, a->nu, a->datum));
    results_put(r, cor_disk_max_load(a->disk_speed, a->nu, a->datum));
    results_put(r, cor_disk_max_compression(a->disk_speed, a->nu, a->datum));
    results_put(r, cor_disk_contact_time(a->disk_speed, a->nu, a->datum));
}

static void call_leading_logarithm(const struct arguments *a, struct results *r)
{
    results_put(r, cor_disk_compression_leading_log(4 * a->part[1]));
    results_put(r, cor_disk_load_leading_log(2 * a->part[3]));
    results_put(r, cor_disk_energy_leading_log(2 * a->part[3]));
    results_put(r, cor_disk_max_compression_leading_log(4 * a->part[0]));
    results_put(r, cor_disk_contact_time_leading_log(4 * a->part[0]));
}

static void call_disk_eps(const struct arguments *a, struct results *r)
{
    const double v = fmax(0.25 * a->part[0], COR_DISK_EPS_MIN_SPEED), nu = fmax(0.75 * a->nu, COR_DISK_EPS_MIN_NU);
    results_put(r, cor_disk_eps(v, nu));
    results_put(r, cor_disk_eps_uncertainty(v, nu));
    results_put(r, cor_disk_one_minus_eps2(v, nu));
    results_put(r, cor_disk_one_minus_eps2_uncertainty(v, nu));
}

static void call_rayleigh(const struct arguments *a, struct results *r)
{
    struct cor_disk_rayleigh out;
    double fraction[60];
    size_t modes = 0;
    const struct cor_disk_modes *const table = a->nu < 0.5 ? &cor_disk_modes_nu033 : &cor_disk_modes_nu090;
    const double v = fmin(a->part[0], cor_disk_speed_limit(table->nu, a->datum));
    results_put(r, cor_disk_rayleigh(table, a->modes, a->datum, v, &out, fraction));
    results_put(r, out.fraction);
    results_put(r, out.tail);
    results_put(r, out.error_estimate);
    results_put(r, out.contact_time);
    results_put(r, fraction[a->modes - 1]);
    results_put(r, cor_disk_rayleigh_tolerance(table, a->datum, v, 0.05, &out, &modes));
    results_put(r, out.fraction);
    results_put(r, (double)modes);
}

static void call_rayleigh_array(const struct arguments *a, struct results *r)
{
    struct cor_disk_rayleigh out[28];
    double v[28];
    for (int i = 0; i < 28; i++)
        v[i] = i == 0 ? fmin(a->part[0], cor_disk_speed_limit(0.33, a->datum)) : ldexp(1 + i, -15);
    results_put(r, cor_disk_rayleigh_array(&cor_disk_modes_nu033, a->modes, a->datum, v, 28, out, NULL, NULL));
    results_put(r, out[0].fraction);
    results_put(r, out[27].fraction);
    results_put(r, out[27].tail);
}

static void call_statuses(const struct arguments *a, struct results *r)
{
    results_put(r, cor_status_text((int)a->modes)[0]);
}

/* share: of the arguments, for what takes long. unit: every result is in [0, 1]. exact: no mode changes a bit. */
static const struct {
    const char *name;
    call *call;
    size_t share;
    int unit, exact;
} calls[] = {
#define SPHERE_ROWS(name, unit)                                                                                        \
    {#name, call_##name, 1, unit, 0},                                                                                  \
    {                                                                                                                  \
#name "_array", call_##name##_array, 4, unit, 1                                                                \
    }
    SPHERE_ROWS(eps_zero_overlap, 1),
    SPHERE_ROWS(eps_zero_force, 1),
    SPHERE_ROWS(loss_zero_overlap, 1),
    SPHERE_ROWS(loss_zero_force, 1),
    SPHERE_ROWS(beta_zero_overlap, 0),
    SPHERE_ROWS(beta_zero_force, 0),
    SPHERE_ROWS(duration_zero_overlap, 0),
    SPHERE_ROWS(duration_zero_force, 0),
    SPHERE_ROWS(max_overlap, 0),
    SPHERE_ROWS(time_of_max_overlap, 0),
    {"fast arrays", call_fast_arrays, 4, 0, 1},
    {"fast eps and loss", call_fast, 1, 1, 0},
    {"fast times and overlap", call_fast_times, 1, 0, 0},
    {"cor_sphere.h, eps and loss", call_inline, 1, 1, 0},
    {"cor_sphere.h, the others", call_inline_times, 1, 0, 0},
    {"formulas of 1999", call_formulas_of_1999, 1, 1, 0},
    {"contact_init", call_contact_init, 1, 0, 1},
    {"contact_eps", call_contact_eps, 1, 1, 0},
    {"contact", call_contact, 1, 0, 0},
    {"contact arrays", call_contact_arrays, 4, 0, 1},
    {"disk limits", call_disk_limits, 1, 0, 1},
    {"disk law", call_disk_law, 8, 0, 1},
    {"leading logarithm", call_leading_logarithm, 1, 0, 1},
    {"disk_eps", call_disk_eps, 1, 1, 0},
    {"rayleigh", call_rayleigh, 200, 0, 1},
    {"rayleigh array", call_rayleigh_array, 1000, 0, 1},
    {"status_text", call_statuses, 1, 0, 1},
};
enum { CALLS = sizeof calls / sizeof *calls };

/* ---- the arguments ---- */

static double one_of(struct random_state *random, const double *x, size_t n)
{
    return x[(size_t)random_uniform(random, 0, (double)n) % n];
}

/* Up to 1, 0 and tiny ones included */
static double part(struct random_state *random)
{
    static const double special[] = {0, 1, 4.9406564584124654e-324, DBL_MIN, 1e-200, 0x1.fffffffffffffp-1, 0.5};
    const double kind = random_uniform(random, 0, 1);
    return kind < 0.2   ? one_of(random, special, sizeof special / sizeof *special)
           : kind < 0.6 ? random_uniform(random, 0, 1)
                        : random_log(random, 1e-300, 1);
}

static double positive(struct random_state *random)
{
    static const double special[] = {0, -0.0, INFINITY, DBL_MAX, DBL_MIN, 4.9406564584124654e-324, 1, 7, 8, 16, 1e300};
    const double kind = random_uniform(random, 0, 1);
    return kind < 0.2   ? one_of(random, special, sizeof special / sizeof *special)
           : kind < 0.6 ? random_log(random, 1e-4, 100)
                        : random_log(random, 5e-324, DBL_MAX);
}

static struct cor_body random_body(struct random_state *random)
{
    const int wild = random_uniform(random, 0, 1) < 0.3;
    struct cor_body body = {random_log(random, 1e6, 1e12), random_uniform(random, -0.9, 0.5),
                            random_log(random, 1e-9, 1e-2), random_log(random, 1e-6, 1), random_log(random, 1e-9, 10)};
    if (wild) {
        body.young_modulus_pa = random_log(random, 1e-300, 1e300);
        body.radius_m = random_log(random, 1e-300, 1e300);
        body.mass_kg = random_log(random, 1e-300, 1e300);
    }
    return body;
}

static void arguments_draw(struct arguments *a, struct random_state *random)
{
    a->beta = positive(random);
    a->speed = positive(random);
    a->eps = part(random);
    a->betaf = narrow(a->beta);
    a->epsf = narrow(a->eps);
    a->nu = random_uniform(random, -0.99, 0.99);
    a->datum = (enum cor_disk_datum)(int)random_uniform(random, 0, 3);
    for (int i = 0; i < 4; i++)
        a->part[i] = part(random);
    a->disk_speed = a->part[0] * cor_disk_speed_limit(a->nu, a->datum);
    a->load = a->part[1] * cor_disk_load_limit(a->nu, a->datum);
    a->energy = a->part[2] * cor_disk_energy_limit(a->nu, a->datum);
    a->compression = a->part[3] * cor_disk_compression_limit(a->nu, a->datum);
    a->modes = 1 + (size_t)random_uniform(random, 0, 59);
    a->body[0] = random_body(random);
    a->body[1] = random_body(random);
    if (random_uniform(random, 0, 1) < 0.2)
        a->body[1].radius_m = a->body[1].mass_kg = INFINITY;
    do {
        const double kind = random_uniform(random, 0, 1);
        if (kind < 0.6)
            cor_sphere_contact_init(&a->contact, &a->body[0], &a->body[1]);
        else
            cor_sphere_contact_init_g_star(&a->contact, kind < 0.7 ? INFINITY : random_log(random, 1e-300, 1e300));
        a->body[0] = random_body(random);
    } while (isnan(a->contact.beta_per_root));
}

/* Where subnormal arguments count as 0, the results are those of 0. */
static int has_subnormal(const struct arguments *a)
{
    const double x[] = {a->beta,        a->eps,     a->speed,   a->disk_speed, a->load,   a->energy,
                        a->compression, a->part[0], a->part[1], a->part[2],    a->part[3]};
    int found = (a->betaf > 0 && a->betaf < FLT_MIN) || (a->epsf > 0 && a->epsf < FLT_MIN);
    for (size_t i = 0; i < sizeof x / sizeof *x; i++)
        found |= x[i] > 0 && x[i] < 2 * DBL_MIN;
    return found;
}

enum { DRAWS = 4000 };
static struct arguments arguments[DRAWS];
static struct results expected[CALLS][DRAWS];

static int setup(void **state)
{
    (void)state;
    struct random_state random = random_start();
    for (size_t i = 0; i < DRAWS; i++) {
        arguments_draw(&arguments[i], &random);
        arguments[i].has_subnormal = has_subnormal(&arguments[i]);
    }
    for (size_t k = 0; k < CALLS; k++)
        for (size_t i = 0; i < DRAWS; i += calls[k].share)
            calls[k].call(&arguments[i], &expected[k][i]);
    return 0;
}

static struct results again(size_t k, size_t i)
{
    struct results r = {{0}, {0}, {0}, 0};
    calls[k].call(&arguments[i], &r);
    assert_int_equal(r.count, expected[k][i].count);
    return r;
}

#define AT "%s, draw %zu (beta %a, eps %a, speed %a, nu %a, disk speed %a)"
#define ARGUMENTS(k, i)                                                                                                \
    calls[k].name, i, arguments[i].beta, arguments[i].eps, arguments[i].speed, arguments[i].nu, arguments[i].disk_speed

/* ---- the tests ---- */

static void no_exception_and_no_errno(void **state)
{
    (void)state;
    for (size_t k = 0; k < CALLS; k++)
        for (size_t i = 0; i < DRAWS; i += calls[k].share) {
            feclearexcept(FE_ALL_EXCEPT);
            errno = 0;
            again(k, i);
            const int raised = fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
            check(raised == 0, AT ": raises %s", ARGUMENTS(k, i),
                  raised & FE_INVALID     ? "FE_INVALID"
                  : raised & FE_DIVBYZERO ? "FE_DIVBYZERO"
                                          : "FE_OVERFLOW");
            check(errno == 0, AT ": errno = %d", ARGUMENTS(k, i), errno);
        }
}

/* A flag raised before stays, and errno too. */
static void what_was_before(void **state)
{
    (void)state;
    for (size_t k = 0; k < CALLS; k++) {
        feclearexcept(FE_ALL_EXCEPT);
        feraiseexcept(FE_DIVBYZERO);
        errno = ENOENT;
        again(k, 0);
        check(fetestexcept(FE_DIVBYZERO) != 0 && errno == ENOENT, "%s", calls[k].name);
    }
    feclearexcept(FE_ALL_EXCEPT);
}

static void traps(void **state)
{
    (void)state;
#ifdef __GLIBC__
    for (size_t k = 0; k < CALLS; k++)
        for (size_t i = 0; i < DRAWS; i += calls[k].share) {
            feclearexcept(FE_ALL_EXCEPT);
            if (feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) == -1) {
                print_message("this machine has no traps\n");
                return;
            }
            const struct results r = again(k, i);
            const int trapping = fedisableexcept(FE_ALL_EXCEPT);
            check(trapping == (FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW), AT ": traps changed", ARGUMENTS(k, i));
            for (int j = 0; j < r.count; j++)
                check(same_bits(r.value[j], expected[k][i].value[j]) || isnan(r.value[j]), AT, ARGUMENTS(k, i));
        }
#else
    print_message("no feenableexcept here\n");
#endif
}

/* By 1e-9, or a few of the smallest normal number where subnormal ones are lost; infinite and NaN alike */
static int sane(double x, double before, double tolerance, double least, int unit, int exact)
{
    if (isnan(before) || isinf(before) || (exact && fabs(before) >= least))
        return same_bits(x, before) || (isnan(x) && isnan(before));
    return fabs(x - before) <= tolerance * fabs(before) + 64 * least && (!unit || (x >= 0 && x <= 1));
}

static void compare_all(const char *mode, int subnormal)
{
    const int direction = fegetround();
    for (size_t k = 0; k < CALLS; k++)
        for (size_t i = 0; i < DRAWS; i += calls[k].share) {
            if (!subnormal && arguments[i].has_subnormal)
                continue;
            const struct results r = again(k, i);
            check(fegetround() == direction, AT ": changes the rounding mode", ARGUMENTS(k, i));
            for (int j = 0; j < r.count; j++)
                check(sane(r.value[j], expected[k][i].value[j], r.tolerance[j], r.least[j], calls[k].unit,
                           calls[k].exact),
                      AT ", %s, result %d: %a for %a", ARGUMENTS(k, i), mode, j, r.value[j], expected[k][i].value[j]);
        }
}

static void rounding_modes(void **state)
{
    (void)state;
    const struct {
        const char *name;
        int mode;
    } modes[] = {
        {"to nearest", FE_TONEAREST}, {"upward", FE_UPWARD}, {"downward", FE_DOWNWARD}, {"toward zero", FE_TOWARDZERO}};
    for (size_t m = 0; m < sizeof modes / sizeof *modes; m++) {
        assert_int_equal(fesetround(modes[m].mode), 0);
        compare_all(modes[m].name, 1);
        assert_int_equal(fesetround(FE_TONEAREST), 0);
    }
}

static void flushing_to_zero(void **state)
{
    (void)state;
#ifdef __SSE2__
    const unsigned control = _mm_getcsr(), flush = 0x8040; /* FTZ and DAZ */
    _mm_setcsr(control | flush);
    compare_all("flushing to zero", 0);
    const unsigned after = _mm_getcsr();
    _mm_setcsr(control);
    assert_true((after & flush) == flush);
#else
    print_message("no flushing to zero here\n");
#endif
}

static int restore(void **state)
{
    (void)state;
    return fesetenv(FE_DFL_ENV);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(no_exception_and_no_errno, restore),
        cmocka_unit_test_teardown(what_was_before, restore),
        cmocka_unit_test_teardown(traps, restore),
        cmocka_unit_test_teardown(rounding_modes, restore),
        cmocka_unit_test_teardown(flushing_to_zero, restore),
    };
    return cmocka_run_group_tests_name("environment", tests, setup, NULL);
}
