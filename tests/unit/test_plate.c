/* SPDX-License-Identifier: MIT */
/* Tests a sphere on a thin plate: the fields of the contact, sphere and plate integrated as two bodies, a plate with
 * edges. Tests published approximations and the conditions of the theory. */
#include "check.h"

#include <cor/cor.h>

#include "../reference/ode.h"

struct scene {
    struct cor_body sphere;
    struct cor_plate plate;
    double speed;
};

static struct scene random_scene(void)
{
    const double radius = random_log(&draw, 1e-4, 1e-1), density = random_log(&draw, 500, 1e4);
    return (struct scene){
        {random_log(&draw, 1e8, 5e11), random_uniform(&draw, 0, 0.5), 0, radius, cor_sphere_mass_kg(radius, density)},
        {random_log(&draw, 1e9, 5e11), random_uniform(&draw, 0, 0.5), random_log(&draw, 500, 1e4),
         random_log(&draw, 1e-4, 1e-2)},
        random_log(&draw, 1e-3, 30)};
}

/* ---- the fields ---- */

TEST(fields)
{
    for (size_t i = 0; i < points(20000); i++) {
        const struct scene s = random_scene();
        struct cor_sphere_contact c;
        assert_int_equal(cor_plate_contact_init(&c, &s.sphere, &s.plate), COR_OK);
        const long double nu = s.plate.poisson_ratio, h = s.plate.thickness_m, young = s.plate.young_modulus_pa;
        const long double b = young * h * h * h / (12 * (1 - nu * nu)), z = 8 * sqrtl(b * s.plate.density_kg_m3 * h);
        const long double nu_s = s.sphere.poisson_ratio, m = s.sphere.mass_kg;
        const long double modulus = 1 / ((1 - nu_s * nu_s) / s.sphere.young_modulus_pa + (1 - nu * nu) / young);
        const long double k = 4 * modulus * sqrtl(s.sphere.radius_m) / 3, root = powl(k / m, 0.4L);
        check_ulp(c.dissipation_time_s, m / z, COR_CONTACT_MAX_ULP);
        check_ulp(c.beta_per_root, 1.5L * m / z * root, COR_CONTACT_MAX_ULP);
        check_ulp(c.scale, 1 / root, COR_CONTACT_MAX_ULP);
        assert_true(c.effective_mass_kg == s.sphere.mass_kg && c.effective_radius_m == s.sphere.radius_m);
        /* Zener's lambda */
        const long double lambda = m / z * root * powl(s.speed, 0.2L);
        check_ulp(cor_plate_lambda(&c, s.speed), lambda, COR_CONTACT_MAX_ULP);
        /* the end of contact is the zero overlap of the sphere */
        const double eps = cor_contact_eps_zero_overlap(&c, s.speed), beta = 1.5 * (double)lambda;
        assert_true(fabs(eps - cor_sphere_eps_zero_overlap(beta)) <= 1e-14);
    }
}

TEST(refused)
{
    const struct scene good = random_scene();
    struct cor_sphere_contact c;
    assert_int_equal(cor_plate_contact_init(NULL, &good.sphere, &good.plate), COR_ERROR_NULL);
    assert_int_equal(cor_plate_contact_init(&c, NULL, &good.plate), COR_ERROR_NULL);
    assert_true(isnan(c.beta_per_root) && isnan(c.scale));
    assert_int_equal(cor_plate_contact_init(&c, &good.sphere, NULL), COR_ERROR_NULL);
    static const struct {
        size_t number; /* offset in struct scene */
        double value;
        int status;
    } wrong[] = {{offsetof(struct scene, plate.thickness_m), 0, COR_ERROR_THICKNESS},
                 {offsetof(struct scene, plate.density_kg_m3), INFINITY, COR_ERROR_DENSITY},
                 {offsetof(struct scene, plate.young_modulus_pa), INFINITY, COR_ERROR_YOUNG_MODULUS},
                 {offsetof(struct scene, plate.poisson_ratio), NAN, COR_ERROR_POISSON_RATIO},
                 {offsetof(struct scene, sphere.radius_m), INFINITY, COR_ERROR_BOTH_FLAT},
                 {offsetof(struct scene, sphere.mass_kg), INFINITY, COR_ERROR_BOTH_FIXED},
                 {offsetof(struct scene, sphere.mass_kg), -1, COR_ERROR_MASS},
                 {offsetof(struct scene, plate.thickness_m), 1e-170, COR_ERROR_RANGE}};
    struct scene s;
    for (size_t i = 0; i < COUNT_OF(wrong); i++) {
        s = good;
        memcpy((char *)&s + wrong[i].number, &wrong[i].value, sizeof wrong[i].value);
        assert_int_equal(cor_plate_contact_init(&c, &s.sphere, &s.plate), wrong[i].status);
        assert_true(isnan(c.beta_per_root) && isnan(c.dissipation_time_s) && isnan(c.effective_mass_kg));
    }
    /* a viscoelastic sphere adds its own dissipation time, in proportion to its share of the compliance */
    s = good;
    s.sphere.dissipation_time_s = 1e-6;
    struct cor_sphere_contact with;
    assert_int_equal(cor_plate_contact_init(&c, &good.sphere, &good.plate), COR_OK);
    assert_int_equal(cor_plate_contact_init(&with, &s.sphere, &s.plate), COR_OK);
    assert_true(with.dissipation_time_s > c.dissipation_time_s &&
                with.dissipation_time_s < c.dissipation_time_s + 1e-6);
}

/* ---- two bodies ---- */

/* Computes the speed of the sphere after contact in units of the impact speed. In scaled units with Z = 1/lambda,
 * m u' = -F, w' = F/Z, F = K (s - w)^(3/2). As functions of sigma, where dt = 2 sqrt(s - w) d sigma, all elements of
 * y = {sqrt(s - w), u, t} are smooth. */
static void two_bodies_slopes(long double *dy, const long double *y, const void *lambda)
{
    const long double force = motion_power(y[0], 3);
    dy[0] = y[1] - *(const double *)lambda * force;
    dy[1] = -2 * y[0] * force;
    dy[2] = 2 * y[0];
}

static double two_bodies_eps(double lambda, double *duration)
{
    static ode_value *const overlap = motion_overlap;
    struct ode o = {.slopes = two_bodies_slopes, .of = &lambda, .n = 3, .longest = 0.1L};
    long double y[3] = {0, 1, 0};
    while (ode_until(&o, y, &overlap, 1) < 0) {
    }
    *duration = (double)y[2];
    return (double)-y[1];
}

TEST(against_two_bodies)
{
    for (int i = 0; i < 40; i++) {
        const struct scene s = random_scene();
        struct cor_sphere_contact c;
        assert_int_equal(cor_plate_contact_init(&c, &s.sphere, &s.plate), COR_OK);
        const double lambda = cor_plate_lambda(&c, s.speed), unit = c.scale / pow(s.speed, 0.2);
        if (lambda > 3)
            continue;
        double duration;
        const double eps = two_bodies_eps(lambda, &duration), wanted = cor_contact_eps_zero_overlap(&c, s.speed);
        check(fabs(eps - wanted) < 1e-14, "lambda = %g: %.12g, not %.12g", lambda, wanted, eps);
        check_near(cor_contact_duration_s_zero_overlap(&c, s.speed), duration * unit, 1e-13);
    }
}

/* ---- a plate with edges ----
 *
 * A simply supported square plate of side l, hit in its middle. Its modes sin(i pi x/l) sin(j pi y/l), i and j odd, are
 * propagated exactly under a force that is constant within a step. This uses no impedance and no infinite plate. */
enum { HARMONICS = 50 };

struct square_plate {
    double omega[HARMONICS * HARMONICS], q[HARMONICS * HARMONICS], p[HARMONICS * HARMONICS];
    double cosine[HARMONICS * HARMONICS], sine[HARMONICS * HARMONICS];
};

/* Returns eps in scaled units: mass, stiffness and speed 1, plate of mass 1 per area and impedance 1/lambda. */
static double square_plate_eps(double lambda, double side, double dt)
{
    static struct square_plate plate;
    const double pi = 3.14159265358979311600, stiffness = 1 / (8 * lambda),
                 mass = side * side / 4; /* sqrt(B/rho h), modal mass */
    double own = 0;
    for (int k = 0; k < HARMONICS * HARMONICS; k++) {
        const int row = k / HARMONICS, column = k % HARMONICS;
        const double i = 2 * row + 1, j = 2 * column + 1;
        const double omega = pi * pi * (i * i + j * j) / (side * side) * stiffness;
        plate.omega[k] = omega;
        plate.q[k] = plate.p[k] = 0;
        plate.cosine[k] = cos(omega * dt);
        plate.sine[k] = sin(omega * dt);
        own += (1 - plate.cosine[k]) / (omega * omega * mass);
    }
    double s = 0, u = 1, force = 0;
    for (int step = 0;; step++) {
        double free = 0, mean = force, after = 0, x = 0;
        for (int k = 0; k < HARMONICS * HARMONICS; k++)
            free += plate.q[k] * plate.cosine[k] + plate.p[k] * plate.sine[k] / plate.omega[k];
        for (int turn = 0; turn < 40; turn++) {
            x = s + u * dt - 0.5 * mean * dt * dt - free - own * mean;
            after = x > 0 ? x * sqrt(x) : 0;
            mean = (force + after) / 2;
        }
        for (int k = 0; k < HARMONICS * HARMONICS; k++) {
            const double rest = mean / (plate.omega[k] * plate.omega[k] * mass), q = plate.q[k] - rest, p = plate.p[k];
            plate.q[k] = q * plate.cosine[k] + p * plate.sine[k] / plate.omega[k] + rest;
            plate.p[k] = p * plate.cosine[k] - q * plate.omega[k] * plate.sine[k];
        }
        s += u * dt - 0.5 * mean * dt * dt;
        u -= mean * dt;
        force = after;
        if (x <= 0 && step > 3)
            return -u;
    }
}

/* In scaled units, the half width of cor_plate_least_half_width_m is 2 sqrt(pi t_0) (B/(rho h))^(1/4). */
TEST(a_plate_with_edges)
{
    static const struct {
        double lambda, tolerance;
    } row[] = {{0.2, 1.5e-4}, {0.6, 1.5e-3}, {1, 5e-3}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const double lambda = row[i].lambda, beta = 1.5 * lambda, duration = cor_sphere_duration_zero_overlap(beta);
        const double half = 2 * sqrt(acos(-1) * duration) * sqrt(1 / (8 * lambda));
        const double wide = square_plate_eps(lambda, 2 * half, duration / 1500),
                     narrow = square_plate_eps(lambda, half, duration / 600);
        const double eps = cor_sphere_eps_zero_overlap(beta);
        assert_true(fabs(wide / eps - 1) < row[i].tolerance && fabs(narrow / eps - 1) > 4 * row[i].tolerance);
    }
}

/* ---- published ---- */

TEST(published)
{
    /* exp(-1.719 lambda), a fit to Zener's curve in use since 1941; the exact number is 1.73017 = -(3/2) C_1 for small
     * lambda */
    for (double lambda = 0.01; lambda < 0.8; lambda += 0.01)
        assert_true(fabs(cor_sphere_eps_zero_overlap(1.5 * lambda) - exp(-1.719 * lambda)) < 0.022);
    assert_true(fabs(cor_sphere_loss_zero_overlap(1.5e-6) / 1e-6 - 1.730173) < 1e-5);
}

/* ---- conditions of the theory ---- */

TEST(conditions)
{
    for (size_t i = 0; i < points(2000); i++) {
        const struct scene s = random_scene();
        struct cor_sphere_contact c;
        assert_int_equal(cor_plate_contact_init(&c, &s.sphere, &s.plate), COR_OK);
        const double t = cor_contact_duration_s_zero_overlap(&c, s.speed), x = cor_contact_max_overlap_m(&c, s.speed);
        const long double nu = s.plate.poisson_ratio, h = s.plate.thickness_m, young = s.plate.young_modulus_pa;
        const long double b = young * h * h * h / (12 * (1 - nu * nu)),
                          shear = sqrtl(young / (2 * (1 + nu)) / s.plate.density_kg_m3);
        const long double pi = acosl(-1), r = s.sphere.radius_m, density = s.sphere.mass_kg / (4 * pi / 3 * r * r * r);
        check_ulp(cor_plate_contact_radius_ratio(&c, &s.plate, s.speed), sqrtl(r * x) / h, 8);
        check_ulp(cor_plate_shear_crossings(&c, &s.plate, s.speed), t * shear / h, 8);
        check_ulp(cor_plate_sphere_crossings(&c, &s.sphere, s.speed),
                  t * sqrtl(s.sphere.young_modulus_pa / density) / (2 * r), 8);
        check_ulp(cor_plate_least_half_width_m(&c, &s.plate, s.speed),
                  2 * sqrtl(pi * t) * powl(b / (s.plate.density_kg_m3 * h), 0.25L), 8);
        check_nan(cor_plate_least_half_width_m(&c, &s.plate, 0), cor_plate_shear_crossings(&c, &s.plate, -1),
                  cor_plate_contact_radius_ratio(&c, &s.plate, INFINITY),
                  cor_plate_sphere_crossings(&c, &s.sphere, NAN));
        /* numbers that a plate cannot have, although the formulas may have a value there */
        struct cor_plate wrong[] = {s.plate, s.plate, s.plate, s.plate, s.plate};
        wrong[0].thickness_m = -1;
        wrong[1].thickness_m = 0;
        wrong[2].density_kg_m3 = INFINITY;
        wrong[3].poisson_ratio = 0.6;
        wrong[4].young_modulus_pa = 0;
        for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++)
            check_nan(cor_plate_least_half_width_m(&c, &wrong[k], 1), cor_plate_contact_radius_ratio(&c, &wrong[k], 1),
                      cor_plate_shear_crossings(&c, &wrong[k], 1));
        for (int k = 0; k < 6; k++) { /* these numbers of a sphere must be above 0 */
            struct cor_body body = s.sphere;
            *(k / 2 == 0 ? &body.young_modulus_pa : k / 2 == 1 ? &body.radius_m : &body.mass_kg) = -k % 2;
            check_nan(cor_plate_sphere_crossings(&c, &body, 1));
        }
    }
}
