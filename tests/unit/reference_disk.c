/* SPDX-License-Identifier: MIT */
#include "reference_disk.h"

#include <math.h>
#include <stdlib.h>

#include "dormand_prince.h"

static const double mass = 3.14159265358979323846;

/* P = pi delta/u with u - ln(u) = ln(4/delta) + b, u >= 1: Newton's method from above */
static double load(double compression, double b)
{
    if (!(compression > 0))
        return 0;
    const double right = log(4 / compression) + b;
    double u = right < 1 ? 1 : right + log(right) + 0.5;
    for (int i = 0; i < 40 && u > 1; i++) {
        const double next = u * (right - 1 + log(u)) / (u - 1);
        if (!(fabs(next - u) > 1e-15 * u))
            break;
        u = next > 1 ? next : 1;
    }
    return mass * compression / u;
}

/* state: delta, delta', then omega Re(q), omega Im(q) of every mode */
static void slopes(const struct cor_disk_mode *mode, size_t n, double b, double t, const double *state, double *slope)
{
    const double acceleration = load(state[0], b) / mass;
    slope[0] = state[1];
    slope[1] = -acceleration;
    for (size_t i = 0; i < n; i++) {
        slope[2 + 2 * i] = mode[i].c * acceleration * sin(mode[i].omega * t);
        slope[3 + 2 * i] = -mode[i].c * acceleration * cos(mode[i].omega * t);
    }
}

enum { STAGES = DORMAND_PRINCE_STAGES };

size_t reference_disk_rayleigh(const struct cor_disk_mode *mode, size_t n, double b, double speed, double tolerance,
                               double *fraction, double *contact_time)
{
    static const double node[STAGES] = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};
    const size_t size = 2 + 2 * n;
    double *const memory = calloc((STAGES + 2) * size, sizeof *memory);
    if (!memory)
        return 0;
    double *const state = memory, *const trial = memory + size, *const k = memory + 2 * size;
    double t = 0, step = 1e-6, largest = 0;
    size_t steps = 0;
    int failed = 0;
    for (size_t i = 0; i < size; i++)
        state[i] = 0;
    state[1] = speed;
    slopes(mode, n, b, 0, state, k);
    while (!failed) {
        const int leaving = state[1] < 0;
        if (leaving && state[0] < 1e-13 * largest)
            break;
        if (leaving && step > -state[0] / state[1])
            step = -state[0] / state[1]; /* to delta = 0, or a little before: the force slows it down no more */
        for (int stage = 1; stage < STAGES; stage++) {
            for (size_t i = 0; i < size; i++) {
                double sum = 0;
                for (int j = 0; j < stage; j++)
                    sum += dormand_prince[stage][j] * k[(size_t)j * size + i];
                trial[i] = state[i] + step * sum;
            }
            slopes(mode, n, b, t + node[stage] * step, trial, k + (size_t)stage * size);
        }
        double error = 0;
        for (size_t i = 0; i < size; i++) {
            double sum = 0;
            for (int j = 0; j < STAGES; j++)
                sum += dormand_prince_difference[j] * k[(size_t)j * size + i];
            error = fmax(error, fabs(step * sum) / speed);
        }
        if (error <= tolerance) {
            t += step;
            steps++;
            for (size_t i = 0; i < size; i++) { /* the last stage was at the new state */
                state[i] = trial[i];
                k[i] = k[(STAGES - 1) * size + i];
            }
            largest = fmax(largest, state[0]);
        }
        step *= fmin(5, fmax(0.2, 0.9 * pow(tolerance / fmax(error, 1e-300), 0.2)));
        failed = !(step > 1e-18);
    }
    for (size_t i = 0; i < n; i++) {
        const double re = state[2 + 2 * i] / speed, im = state[3 + 2 * i] / speed;
        fraction[i] = re * re + im * im;
    }
    if (contact_time)
        *contact_time = t - state[0] / state[1];
    free(memory);
    return failed ? 0 : steps;
}
