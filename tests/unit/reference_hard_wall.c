/* SPDX-License-Identifier: MIT */
#include "reference_hard_wall.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_MODES = 4000, MOST_ANGLES = 200 };

static const double pi = 3.14159265358979323846, mass = 3.14159265358979323846;

static const struct reference_wall *wall;
static int modes, angles;
static double rim[MOST_MODES][MOST_ANGLES]; /* sqrt(w_i) s_i */
static double omega[MOST_MODES], q[MOST_MODES], q_dot[MOST_MODES];
static double compliance[MOST_ANGLES][MOST_ANGLES], reach[MOST_ANGLES], force[MOST_ANGLES];
static double equation[MOST_ANGLES][MOST_ANGLES + 1]; /* last column of the system: the right side, then the solution */
static int touches[MOST_ANGLES];

static double rim_function(const struct cor_disk_mode *mode, double phi)
{
    return mode->c * cos(mode->n * phi) * cos(phi) - mode->s * sin(mode->n * phi) * sin(phi);
}

static double angle(int j)
{
    return j * pi / wall->nyquist;
}

/* Returns pi times the static compliance, summed over n up to Nyquist's number (docs/paper-figures.md, Fig. 10). */
static double static_compliance(double nu, double phi, double psi)
{
    double sum = (1 - nu) / 2 * cos(phi) * cos(psi);
    for (int n = 1; n <= wall->nyquist; n++) {
        const double a = n == 1 ? (1 - nu) / 2 : (2 * n - 1 + nu) / ((double)n * n - 1);
        const double b = n == 1 ? (1 - nu) / 2 : (n * (1 - nu) - 2) / ((double)n * n - 1);
        const double d = n == 1 ? (3 + nu) / 2 : a;
        const double x = cos(n * phi) * cos(phi), y = sin(n * phi) * sin(phi);
        const double x_psi = cos(n * psi) * cos(psi), y_psi = sin(n * psi) * sin(psi);
        sum += a * x * x_psi - b * (x * y_psi + y * x_psi) + d * y * y_psi;
        if (n == wall->nyquist) /* the library's cosine series end at Nyquist's number and lack cos((n + 1) phi) */
            sum -= (a + 2 * b + d) / 4 * cos((n + 1) * phi) * cos((n + 1) * psi);
    }
    return sum;
}

static void fill(const struct cor_disk_modes *of)
{
    for (int i = 0; i < modes; i++) {
        const double r2 = pow(of->mode[i].omega / wall->omega, 2);
        const double w = (1 - r2) * (1 - r2) * (1 + wall->fade_next * r2);
        omega[i] = of->mode[i].omega;
        q[i] = q_dot[i] = 0;
        for (int j = 0; j < angles; j++)
            rim[i][j] = sqrt(w) * rim_function(&of->mode[i], angle(j));
    }
    for (int j = 0; j < angles; j++)
        for (int k = 0; k <= j; k++) {
            double sum = static_compliance(of->nu, angle(j), angle(k));
            for (int i = 0; i < modes; i++)
                sum -= rim[i][j] * rim[i][k] / (omega[i] * omega[i]);
            compliance[j][k] = compliance[k][j] = sum / pi;
        }
}

/* Solves the first n equations by Gauss's elimination. They are positive definite, so pivoting is not needed. */
static int eliminate(int n)
{
    for (int k = 0; k < n; k++) {
        if (!(equation[k][k] > 0))
            return 1;
        for (int i = k + 1; i < n; i++) {
            const double factor = equation[i][k] / equation[k][k];
            for (int j = k; j <= n; j++)
                equation[i][j] -= factor * equation[k][j];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++)
            equation[k][n] -= equation[k][j] * equation[j][n];
        equation[k][n] /= equation[k][k];
    }
    return 0;
}

static double gap_at(int j)
{
    double gap = reach[j];
    for (int k = 0; k < angles; k++)
        gap -= compliance[j][k] * force[k];
    return gap;
}

/* Finds the forces for which the rim is exactly at the wall, at all touching angles. */
static int balance(void)
{
    int place[MOST_ANGLES], n = 0;
    for (int j = 0; j < angles; j++) {
        force[j] = 0;
        if (touches[j])
            place[n++] = j;
    }
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < n; k++)
            equation[i][k] = compliance[place[i]][place[k]];
        equation[i][n] = reach[place[i]];
    }
    if (eliminate(n))
        return 1;
    for (int i = 0; i < n; i++)
        force[place[i]] = equation[i][n];
    return 0;
}

/* Removes the touching angle with the most attractive force, or adds the angle deepest in the wall (Lawson and Hanson).
 * */
static int press(void)
{
    for (int round = 0; round < 100 * angles; round++) {
        if (balance())
            return 1;
        int worst = -1;
        double by = -1e-13;
        for (int j = 0; j < angles; j++)
            if (force[j] < by)
                by = force[worst = j];
        if (worst < 0) {
            by = 1e-14;
            for (int j = 0; j < angles; j++)
                if (!touches[j] && reach[j] > -1 && gap_at(j) > by)
                    by = gap_at(worst = j);
            if (worst < 0)
                return 0;
        }
        touches[worst] = !touches[worst];
    }
    return 1;
}

/* Returns a bound on the deviation of the rim from its round shape. */
static double swing(void)
{
    double sum = 0;
    for (int i = 0; i < modes; i++) {
        double most = 0;
        for (int j = 0; j < angles; j++)
            most = fmax(most, fabs(rim[i][j]));
        sum += most * hypot(q[i], q_dot[i] / omega[i]);
    }
    return sum;
}

/* Returns 1 - eps^2, or NaN if a contact is not found or reaches the last angle. */
static double disk_collide(double speed)
{
    const double h = wall->h;
    double v = speed, depth = 0.5 * h * speed;
    for (int j = 0; j < angles; j++)
        touches[j] = 0;
    for (int steps = 0; steps < 1000000; steps++) {
        double load = 0;
        for (int j = 0; j < angles; j++)
            reach[j] = depth + cos(angle(j)) - 1;
        for (int i = 0; i < modes; i++)
            for (int j = 0; j < angles; j++)
                reach[j] += rim[i][j] * q[i];
        if (press() || touches[angles - 1])
            break;
        for (int j = 0; j < angles; j++)
            load += force[j];
        v -= h * load / mass;
        for (int i = 0; i < modes && load > 0; i++) {
            double along = 0;
            for (int j = 0; j < angles; j++)
                along += rim[i][j] * force[j];
            q_dot[i] -= h / mass * along;
        }
        if (v < 0 && load <= 0 && steps % 64 == 0 && depth + swing() < 0)
            return 1 - v / speed * (v / speed);
        for (int i = 0; i < modes; i++) {
            const double turned = cos(omega[i] * h) * q[i] + sin(omega[i] * h) / omega[i] * q_dot[i];
            q_dot[i] = cos(omega[i] * h) * q_dot[i] - sin(omega[i] * h) * omega[i] * q[i];
            q[i] = turned;
        }
        depth += h * v;
    }
    return (double)NAN;
}

double reference_hard_wall(const struct cor_disk_modes *of, double speed, const struct reference_wall *settings)
{
    wall = settings;
    angles = wall->angles;
    modes = 0;
    while (modes < (int)of->count && of->mode[modes].omega < wall->omega)
        modes++;
    if (modes > MOST_MODES || angles > MOST_ANGLES)
        abort();
    fill(of);
    return disk_collide(speed);
}
