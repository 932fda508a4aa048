/* SPDX-License-Identifier: MIT */
/* Computes the cooling of a homogeneous gas of equal viscoelastic spheres by kinetic theory with cor's eps(g).
 *
 *     theory MODEL LOSS YOUNG POISSON RADIUS DENSITY DISSIPATION_TIME FRACTION T_OVER_M < TIMES
 *
 * SI units; LOSS multiplies 1 - eps^2 and is 1 for exact contacts; FRACTION is the volume fraction of the spheres,
 * T_OVER_M = <v^2>/3 the temperature at time 0. The MODELs:
 *
 *     zero_overlap, zero_force   contacts end there
 *     rigid                      zero overlap, without the three effects of finite overlaps below
 *
 * For each time of the standard input, in rising order, the program prints
 *
 *     TIME T_OVER_M A2 COLLISIONS SLOPE CONTACT
 *
 * A2 = (4/15) <c^4> - 1 is the second Sonine coefficient, and COLLISIONS the number of collisions of a sphere since
 * time 0. SLOPE = d ln T/d ln(time + T/|dT/dt| at time 0). CONTACT is the mean number of spheres that touch a sphere.
 *
 * Velocities c are in units of v_T = sqrt(2 T/m), B = v_T g_2 d^2 n with the number density n, the diameter d and
 * Carnahan and Starling's g_2. The equations are from Brilliantov and Poeschel, Kinetic Theory of Granular Gases,
 * Oxford University Press (2004):
 *
 *     dT/dt = -(2/3) B mu_2 T,     da2/dt = (4/3) B mu_2 (1 + a2) - (4/15) B mu_4
 *
 * mu_2 and mu_4, the moments of the collision integral, contain eps(g), not its series. Except along the normal, the
 * integrals over directions are Gaussian moments: polynomials in G = g^2/2. The theory neglects a2^2, higher Sonine
 * coefficients, correlations of the velocities, and collisions of three spheres. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cor/cor.h>

/* Normal speeds beyond 10 v_T have the weight exp(-50). eps is smooth in s = g^(1/5). */
#define SPEED_MAX 10.0
#define NODES 64
/* Three effects of finite overlaps, each to first order in x_max/d, the largest overlap divided by the diameter. The
 * last two are for weak damping. B is Euler's beta function.
 *
 * TURNING: the tangential speed g_t turns the pair during the contact, and the centrifugal acceleration a = g_t^2/d
 * pushes the spheres apart. It changes the loss by the fraction -turning(beta) (g_t/g)^2 x_max/d; <g_t^2> = 2 v_T^2.
 * For weak damping the loss is proportional to int sqrt(x) sqrt(g^2 - (4/5) (rho/m) x^(5/2) - 2 a x) dx, so that
 * turning(0) = TURNING, whose denominator is (2/5) B(3/5, 3/2). At eps = 0.85 turning(beta) is smaller by 2 %.
 *
 * SHADOW: g_2 = 1 + (5/2) phi + ... counts a third sphere that shields the pair. Its excluded volume has the soft
 * radius d - delta, delta = Gamma(7/5) (5 T/(2 rho))^(2/5) = Gamma(7/5) 2^(2/5) x_max(v_T). The volume that two spheres
 * of radius r share at distance d is (4/3) pi r^3 (1 - 3 d/(4 r) + d^3/(16 r^3)). Its relative fall is (24/5) delta/d.
 *
 * STORED: the mean energy of a contact is T, and it stores on average B(7/5, 1/2)/B(2/5, 1/2) = 4/9 of its energy. A
 * sphere touched by n_c others on average has the energy (2/9) n_c T in its contacts, in addition to (3/2) T. n_c is
 * proportional to T^(2/5), so the heat capacity is larger by the fraction (7/5) (4/27) n_c. */
#define TURNING (0.8 / 0.50445489426892577)
#define SHADOW (4.8 * 0.88726381750307528 * 1.3195079107728942)
#define STORED (1.4 * 4 / 27)
#define TOLERANCE 1e-10 /* absolute error of each variable in a time step */

struct gas {
    struct cor_sphere_contact contact;
    double (*eps)(const struct cor_sphere_contact *contact, double speed_m_s);
    double loss;
    bool rigid; /* true: without the effects of overlaps */
    double diameter_m;
    double density_m3; /* n */
    double g_2;        /* g_2 of Carnahan and Starling */
    gsl_integration_glfixed_table *rule;
};

struct collision_moments {
    double mu_2[2], mu_4[2]; /* coefficients of orders 0 and 1 in a2 */
    double duration_s;       /* mean duration of a contact */
};

/* Returns -d ln(1 - eps^2)/d alpha at alpha = 0, divided by x_max, for the scaled motion x' = u - (2/3) beta x^(3/2),
 * u' = -x^(3/2) - alpha, which ends at x = 0 with u = -eps. y and s are the derivatives of x and u by alpha.
 * Runge-Kutta steps in p, where t = T p^3 (10 - 15 p + 6 p^2), are smooth at both ends. A hundred times more steps
 * change the result by less than 1e-3, for beta from 1e-3 to 2. */
static double turning(double beta)
{
    enum { STEPS = 40 };
    const double duration = cor_sphere_duration_zero_overlap(beta), h = 1.0 / STEPS;
    double now[4] = {0, 1, 0, 0}; /* x, u, y, s */
    if (!(beta > 1e-3))
        return TURNING;
    for (int i = 0; i < STEPS; i++) {
        double k[4][4];
        for (int j = 0; j < 4; j++) {
            const double part = j == 0 ? 0 : j == 3 ? h : h / 2, p = i * h + part;
            const double dt = duration * 30 * p * p * (1 - p) * (1 - p);
            double at[4];
            for (int n = 0; n < 4; n++)
                at[n] = now[n] + (j == 0 ? 0 : part * k[j - 1][n]);
            const double root = sqrt(fmax(at[0], 0));
            k[j][0] = dt * (at[1] - 2.0 / 3 * beta * root * root * root);
            k[j][1] = dt * -(root * root * root);
            k[j][2] = dt * (at[3] - beta * root * at[2]);
            k[j][3] = dt * (-1.5 * root * at[2] - 1);
        }
        for (int n = 0; n < 4; n++)
            now[n] += h * (k[0][n] + 2 * k[1][n] + 2 * k[2][n] + k[3][n]) / 6;
    }
    const double eps = cor_sphere_eps_zero_overlap(beta);
    return -2 * eps * now[3] / ((1 - eps) * (1 + eps)) / cor_sphere_max_overlap(beta);
}

/* x_max/d */
static double overlap(const struct gas *gas, double speed_m_s)
{
    return gas->rigid ? 0 : cor_contact_max_overlap_m(&gas->contact, speed_m_s) / gas->diameter_m;
}

/* Adds the collisions at normal speed g, in units of v_T, with the weight g p(g) dg. */
static void moments_add(struct collision_moments *sum, const struct gas *gas, double v_T, double g, double weight)
{
    const double G = g * g / 2, eps = gas->eps(&gas->contact, g * v_T);
    const double turned = turning(cor_contact_beta(&gas->contact, g * v_T)) * 2 / (g * g) * overlap(gas, g * v_T);
    const double loss = gas->loss * (1 - eps) * (1 + eps) * (1 - turned);
    /* Means at a given g, with s = S_2(c_1^2) + S_2(c_2^2). S: mean of s. SX: mean of s (c_1^2 + c_2^2). SC: mean of
     * s C^2, where C is the normal velocity of the centre of mass. */
    const double S = 3.0 / 16 + G * (-3.0 / 4 + G / 4);
    const double SX = -13.0 / 32 + G * (1.0 / 16 + G * (-1.0 / 8 + G / 4));
    const double SC = -9.0 / 64 + G * (3.0 / 16 + G / 16);
    const double square = loss * loss * G * G / 2;
    sum->mu_2[0] += 2 * M_PI * weight * loss * G;
    sum->mu_2[1] += 2 * M_PI * weight * loss * G * S;
    sum->mu_4[0] += 2 * M_PI * weight * (loss * G * (G + 3.5) - square);
    sum->mu_4[1] += 2 * M_PI * weight * (loss * G * (SX + 4 * SC) - square * S + 2 * (1 + eps) * G);
    sum->duration_s += sqrt(2 * M_PI) * weight * cor_contact_duration_s_zero_overlap(&gas->contact, g * v_T);
}

static struct collision_moments collision_moments(const struct gas *gas, double v_T)
{
    struct collision_moments sum = {{0, 0}, {0, 0}, 0};
    const double s_max = pow(SPEED_MAX, 0.2);
    for (size_t i = 0; i < NODES; i++) {
        double s, ds;
        gsl_integration_glfixed_point(0, s_max, i, &s, &ds, gas->rule);
        const double g = pow(s, 5), dg = 5 * pow(s, 4) * ds;
        moments_add(&sum, gas, v_T, g, g * exp(-g * g / 2) / sqrt(2 * M_PI) * dg);
    }
    return sum;
}

/* y = ln(T/m), a2, collisions of a sphere */
static int cooling(double t, const double y[], double dy[], void *data)
{
    (void)t;
    const struct gas *gas = data;
    const double v_T = sqrt(2 * exp(y[0])), a2 = y[1];
    const double g_2 = 1 + (gas->g_2 - 1) * (1 - SHADOW * overlap(gas, v_T));
    const double B = v_T * g_2 * gas->diameter_m * gas->diameter_m * gas->density_m3;
    const struct collision_moments c = collision_moments(gas, v_T);
    const double mu_2 = c.mu_2[0] + a2 * c.mu_2[1], mu_4 = c.mu_4[0] + a2 * c.mu_4[1];
    dy[2] = 2 * sqrt(2 * M_PI) * B * (1 - a2 / 16);
    dy[0] = -2.0 / 3 * B * mu_2 / (1 + (gas->rigid ? 0 : STORED * dy[2] * c.duration_s));
    dy[1] = 4.0 / 3 * B * mu_2 * (1 + a2) - 4.0 / 15 * B * mu_4;
    return GSL_SUCCESS;
}

static bool gas_init(struct gas *gas, const char *model, const double *number)
{
    const double radius_m = number[3], fraction = number[6];
    const double mass_kg = 4.0 / 3 * M_PI * pow(radius_m, 3) * number[4];
    const struct cor_body sphere = {number[1], number[2], number[5], radius_m, mass_kg};
    const bool zero_force = strcmp(model, "zero_force") == 0;
    gas->rigid = strcmp(model, "rigid") == 0;
    gas->eps = zero_force ? cor_contact_eps_zero_force : cor_contact_eps_zero_overlap;
    gas->loss = number[0];
    gas->diameter_m = 2 * radius_m;
    gas->density_m3 = 6 * fraction / M_PI / pow(gas->diameter_m, 3);
    gas->g_2 = (1 - fraction / 2) / pow(1 - fraction, 3);
    gas->rule = gsl_integration_glfixed_table_alloc(NODES);
    return (gas->rigid || zero_force || strcmp(model, "zero_overlap") == 0) && fraction > 0 && fraction < 0.5 &&
           cor_sphere_contact_init(&gas->contact, &sphere, &sphere) == COR_OK;
}

static int cool(struct gas *gas, double t_over_m)
{
    gsl_odeiv2_system system = {cooling, NULL, 3, gas};
    gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, TOLERANCE, 0);
    double t = 0, next, y[3] = {log(t_over_m), 0, 0}, dy[3];
    cooling(0, y, dy, gas);
    const double unit_s = -1 / dy[0];
    int status = GSL_SUCCESS;
    while (status == GSL_SUCCESS && scanf("%lf", &next) == 1) {
        if (next > t)
            status = gsl_odeiv2_driver_apply(driver, &t, next, y);
        cooling(t, y, dy, gas);
        const double contact = dy[2] * collision_moments(gas, sqrt(2 * exp(y[0]))).duration_s;
        printf("%.10g %.10g %.6g %.6g %.6g %.4g\n", t, exp(y[0]), y[1], y[2], dy[0] * (t + unit_s), contact);
    }
    gsl_odeiv2_driver_free(driver);
    return status;
}

int main(int argc, char **argv)
{
    double number[8];
    bool good = argc == 10;
    for (int i = 0; good && i < 8; i++) {
        char *end;
        number[i] = strtod(argv[i + 2], &end);
        good = *end == '\0' && isfinite(number[i]);
    }
    struct gas gas;
    if (!good || !(number[7] > 0) || !gas_init(&gas, argv[1], number)) {
        fputs("theory MODEL LOSS YOUNG POISSON RADIUS DENSITY DISSIPATION_TIME FRACTION T_OVER_M < TIMES\n"
              "MODEL: zero_overlap, zero_force or rigid; a volume fraction below 0.5; SI units\n",
              stderr);
        return 2;
    }
    const int status = cool(&gas, number[7]);
    gsl_integration_glfixed_table_free(gas.rule);
    return status == GSL_SUCCESS ? 0 : 1;
}
