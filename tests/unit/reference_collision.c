/* SPDX-License-Identifier: MIT */
#include "reference_collision.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;
static const double mass = 3.14159265358979323846;

enum { COLUMNS = 8, FEW_COLUMNS = 3, ORDER = 2 * COLUMNS, GAUSS = 16, SAMPLES = 8, MOST_STEPS = 1000000 };

/* What of a load or an energy is none: relative to (pi/2) v^2. */
static const double nothing = 1e-17;

/* State: x_0 + 1, which loses no digits near the wall, and Q of each mode; their velocities; the time integrals of each
 * mode's energy. */
struct problem {
    const struct cor_disk_mode *mode;
    size_t n, n_max, points, size;
    double alpha, speed, tolerance;
    double *weight, *fall;                   /* of the points; cos(phi) - 1 */
    double *along, *across;                  /* cos(n phi) cos(phi), sin(n phi) sin(phi): [n points + j] */
    double *sum_c, *sum_s;                   /* of each n */
    double *pressure;                        /* at each point, with its weight */
    double *acceleration, *position, *delta; /* of the sub-steps */
    double *table[COLUMNS];                  /* of the extrapolation */
    double load;                             /* at the last evaluation */
    size_t evaluations;
};

static double mode_energy(const struct cor_disk_mode *mode, double q, double q_dot)
{
    return mass / 2 * (q_dot * q_dot + mode->omega * mode->omega * q * q);
}

/* Accelerations at the positions y = (x_0 + 1, Q...) */
static void accelerate(struct problem *p, const double *y, double *acceleration)
{
    const size_t points = p->points;
    memset(p->sum_c, 0, (p->n_max + 1) * sizeof(double));
    memset(p->sum_s, 0, (p->n_max + 1) * sizeof(double));
    for (size_t i = 0; i < p->n; i++) {
        p->sum_c[p->mode[i].n] += p->mode[i].c * y[1 + i];
        p->sum_s[p->mode[i].n] += p->mode[i].s * y[1 + i];
    }
    for (size_t j = 0; j < points; j++)
        p->pressure[j] = y[0] + p->fall[j];
    for (size_t k = 0; k <= p->n_max; k++)
        for (size_t j = 0; j < points; j++)
            p->pressure[j] += p->sum_c[k] * p->along[k * points + j] - p->sum_s[k] * p->across[k * points + j];
    p->load = 0;
    for (size_t j = 0; j < points; j++) {
        p->pressure[j] = 2 * p->weight[j] * exp(p->alpha * p->pressure[j]); /* both quadrants */
        p->load += p->pressure[j];
    }
    for (size_t k = 0; k <= p->n_max; k++) {
        double c = 0, s = 0;
        for (size_t j = 0; j < points; j++) {
            c += p->pressure[j] * p->along[k * points + j];
            s += p->pressure[j] * p->across[k * points + j];
        }
        p->sum_c[k] = c;
        p->sum_s[k] = s;
    }
    acceleration[0] = -p->load / mass;
    for (size_t i = 0; i < p->n; i++) {
        const struct cor_disk_mode *const m = &p->mode[i];
        acceleration[1 + i] = -m->omega * m->omega * y[1 + i] - (m->c * p->sum_c[m->n] - m->s * p->sum_s[m->n]) / mass;
    }
    p->evaluations++;
}

/* `count` sub-steps of Stoermer's method; energies by the trapezoidal rule, so that all errors are even in the step. */
static void substeps(struct problem *p, const double *from, const double *first, double step, int count, double *to)
{
    const size_t n = p->n;
    const double h = step / count;
    double *const y = p->position, *const delta = p->delta, *const integral = to + 2 * (1 + n);
    memcpy(y, from, (1 + n) * sizeof(double));
    for (size_t i = 0; i <= n; i++)
        delta[i] = h * (from[1 + n + i] + h / 2 * first[i]);
    for (size_t i = 0; i < n; i++)
        integral[i] = mode_energy(&p->mode[i], from[1 + i], from[2 + n + i]) / 2;
    for (int k = 1; k <= count; k++) {
        for (size_t i = 0; i <= n; i++)
            y[i] += delta[i];
        accelerate(p, y, p->acceleration);
        for (size_t i = 0; i <= n; i++) {
            const double velocity = delta[i] / h + h / 2 * p->acceleration[i];
            to[1 + n + i] = velocity;
            if (i > 0)
                integral[i - 1] += mode_energy(&p->mode[i - 1], y[i], velocity) / (k == count ? 2 : 1);
            delta[i] += h * h * p->acceleration[i];
        }
    }
    memcpy(to, y, (1 + n) * sizeof(double));
    for (size_t i = 0; i < n; i++)
        integral[i] = from[2 * (1 + n) + i] + h * integral[i];
}

/* One extrapolated step; the error in the velocities, relative to v; NaN where a sub-step went too far */
static double extrapolate(struct problem *p, const double *from, const double *first, double step, int columns,
                          double *to)
{
    double error = 0;
    for (int k = 0; k < columns; k++) {
        substeps(p, from, first, step, k + 1, to);
        for (size_t i = 0; i < p->size; i++) {
            double value = to[i];
            for (int j = 0; j < k; j++) { /* Neville, over the row before */
                const double ratio = (k + 1.0) / (k - j), correction = (value - p->table[j][i]) / (ratio * ratio - 1);
                p->table[j][i] = value;
                value += correction;
                const double relative = fabs(correction) / p->speed;
                if (k == columns - 1 && j == k - 1 && i > p->n && i <= 2 * p->n + 1 && !(relative <= error))
                    error = relative;
            }
            p->table[k][i] = value;
        }
    }
    memcpy(to, p->table[columns - 1], p->size * sizeof(double));
    return error;
}

struct moment {
    double time, step, load; /* step: to the next one */
    double *state, *first;   /* with the accelerations */
};

/* The state a time t after a moment, in `to`; its load */
static double state_after(struct problem *p, const struct moment *m, double t, int columns, double *to)
{
    if (t > 0)
        extrapolate(p, m->state, m->first, t, columns, to);
    else
        memcpy(to, m->state, p->size * sizeof(double));
    accelerate(p, to, p->acceleration);
    return p->load;
}

/* The time after moment m, within low and high, where the load crosses `level`, or, for level = 0, where the centre of
 * mass turns: regula falsi (Illinois). `to` becomes the state there. */
static double crossing(struct problem *p, const struct moment *m, double low, double high, double level, double *to)
{
    double end[2] = {low, high}, value[2] = {0, 0}, t = low;
    for (int i = -2; i < 60; i++) {
        t = i < 0 ? end[i + 2] : (end[0] * value[1] - end[1] * value[0]) / (value[1] - value[0]);
        const double load = state_after(p, m, t, COLUMNS, to),
                     f = level > 0 ? log(load / level) : to[1 + p->n] / p->speed;
        if (i < 0) {
            value[i + 2] = f;
            continue;
        }
        if (fabs(f) < 1e-14)
            break;
        const int side = (f > 0) == (value[1] > 0);
        end[side] = t;
        value[side] = f;
        value[!side] /= 2;
    }
    return t;
}

/* The largest load after moment m, within low and high: golden section */
static double largest_load(struct problem *p, const struct moment *m, double low, double high, double *to)
{
    const double golden = 0.618033988749894848;
    double x[2] = {high - golden * (high - low), low + golden * (high - low)}, load[2];
    for (int i = 0; i < 2; i++)
        load[i] = state_after(p, m, x[i], COLUMNS, to);
    for (int i = 0; i < 25; i++) {
        const int rise = load[1] > load[0];
        if (rise)
            low = x[0];
        else
            high = x[1];
        x[!rise] = x[rise];
        load[!rise] = load[rise];
        x[rise] = rise ? low + golden * (high - low) : high - golden * (high - low);
        load[rise] = state_after(p, m, x[rise], COLUMNS, to);
    }
    return fmax(load[0], load[1]);
}

/* The farthest that the rim can reach again, were all amplitudes of one sign */
static double farthest(const struct problem *p, const double *state)
{
    double reach = state[0];
    for (size_t i = 0; i < p->n; i++)
        reach +=
            (fabs(p->mode[i].c) + fabs(p->mode[i].s)) * hypot(state[1 + i], state[2 + p->n + i] / p->mode[i].omega);
    return reach;
}

/* Gauss's rule on (-1, 1), from Legendre's polynomials */
static void gauss_rule(double *node, double *weight)
{
    for (int i = 0; i < GAUSS; i++) {
        double x = cos(pi * (i + 0.75) / (GAUSS + 0.5)), slope = 0;
        for (int step = 0; step < 10; step++) {
            double p0 = 1, p1 = x;
            for (int k = 2; k <= GAUSS; k++) {
                const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
                p0 = p1;
                p1 = p2;
            }
            slope = GAUSS * (x * p1 - p0) / (x * x - 1);
            x -= p1 / slope;
        }
        node[i] = x;
        weight[i] = 2 / ((1 - x * x) * slope * slope);
    }
}

static void place_points(struct problem *p, size_t panels)
{
    double node[GAUSS], weight[GAUSS];
    gauss_rule(node, weight);
    /* A disk is pressed in by less than 2 v, and 45/alpha outside the wall the pressure is nothing. */
    const double end = acos(1 - fmin(1, 2 * p->speed + 45 / p->alpha)), width = end / (double)panels;
    for (size_t j = 0; j < p->points; j++) {
        const size_t panel = j / GAUSS;
        const double half = (panel < panels ? width : pi / 2 - end) / 2;
        const double phi = (double)panel * width + half * (1 + node[j % GAUSS]);
        p->weight[j] = half * weight[j % GAUSS];
        p->fall[j] = -2 * sin(phi / 2) * sin(phi / 2);
        for (size_t k = 0; k <= p->n_max; k++) {
            p->along[k * p->points + j] = cos((double)k * phi) * cos(phi);
            p->across[k * p->points + j] = sin((double)k * phi) * sin(phi);
        }
    }
}

/* What the moments tell, once the collision is over */
static void summarise(struct problem *p, const struct moment *moment, size_t count, double *to,
                      struct reference_collision *out, double *energy_average)
{
    size_t turn = 0, at[2] = {count, 0};
    double most = 0;
    for (size_t i = 0; i + 1 < count; i++) {
        if (moment[i].state[1 + p->n] > 0)
            turn = i;
        most = fmax(most, moment[i].load);
    }
    crossing(p, &moment[turn], 0, moment[turn].step, 0, to);
    out->max_compression = to[0];

    /* the largest load: the best vertex of a parabola through three samples, then by full steps */
    const double least = 0.8 * most;
    double low[2] = {0}, high[2] = {0};
    most = 0;
    for (size_t i = 0; i + 1 < count; i++) {
        if (fmax(moment[i].load, moment[i + 1].load) < least)
            continue;
        const double part = moment[i].step / SAMPLES;
        double load[3] = {0, moment[i].load, state_after(p, &moment[i], part, FEW_COLUMNS, to)};
        for (int j = 1; j <= SAMPLES; j++) {
            load[0] = load[1];
            load[1] = load[2];
            load[2] = state_after(p, &moment[i], part * (j + 1), FEW_COLUMNS, to);
            const double slope = (load[2] - load[0]) / 2, bend = load[0] - 2 * load[1] + load[2];
            const double vertex = load[1] - slope * slope / (2 * bend);
            if (load[1] >= load[0] && load[1] >= load[2] && vertex > most) {
                most = vertex;
                at[0] = i;
                low[0] = part * (j - 1);
                high[0] = part * (j + 1);
            }
        }
    }
    out->max_load = most = largest_load(p, &moment[at[0]], low[0], high[0], to);
    at[0] = count;

    /* between which samples the load crosses a thousandth of that first and last */
    const double level = most / 1000;
    for (size_t i = 0; i + 1 < count; i++) {
        const double larger = fmax(moment[i].load, moment[i + 1].load);
        if (larger < 0.1 * level)
            continue;
        const int sampled = fmin(moment[i].load, moment[i + 1].load) < 10 * level ? SAMPLES : 1;
        double before = moment[i].load;
        for (int j = 1; j <= sampled; j++) {
            const double t = moment[i].step * j / sampled;
            const double load = j == sampled ? moment[i + 1].load : state_after(p, &moment[i], t, FEW_COLUMNS, to);
            const int last = before >= level && load < level;
            if ((before < level && load >= level && at[0] == count) || last) {
                at[last] = i;
                low[last] = moment[i].step * (j - 1) / sampled;
                high[last] = t;
            }
            before = load;
        }
    }
    double end[2];
    for (int k = 0; k < 2; k++) {
        end[k] = moment[at[k]].time + crossing(p, &moment[at[k]], low[k], high[k], level, to);
        for (size_t i = 0; energy_average && i < p->n; i++)
            energy_average[i] = to[2 * (1 + p->n) + i] - (k == 0 ? 0 : energy_average[i]);
    }
    out->contact_time = end[1] - end[0];
    for (size_t i = 0; energy_average && i < p->n; i++)
        energy_average[i] /= out->contact_time * mass / 2 * p->speed * p->speed;
}

/* The next moment, at a state; 0 without memory */
static struct moment *new_moment(const struct problem *p, struct moment **moment, size_t *count, double time,
                                 const double *state)
{
    if ((*count & (*count - 1)) == 0) { /* at every power of two */
        struct moment *const larger = realloc(*moment, (2 * *count + 1) * sizeof *larger);
        if (!larger)
            return NULL;
        *moment = larger;
    }
    struct moment *const now = &(*moment)[*count];
    now->state = malloc((p->size + 1 + p->n) * sizeof(double));
    if (!now->state)
        return NULL;
    memcpy(now->state, state, p->size * sizeof(double));
    now->first = now->state + p->size;
    now->time = time;
    ++*count;
    return now;
}

/* From before the contact till after it; 0 if all went well */
static int collide(struct problem *p, struct moment **moment, size_t *count, double *to)
{
    const double energy = mass / 2 * p->speed * p->speed;
    /* of the rim of a disk that keeps its shape, where the wall's energy is nothing */
    const double reach = fmin(0, (log(nothing * energy * p->alpha) - 0.5 * log(2 * pi / p->alpha)) / p->alpha);
    double step = 0.1 / (p->alpha * p->speed + p->mode[p->n - 1].omega), time = reach / p->speed;
    memset(to, 0, p->size * sizeof(double));
    to[0] = reach;
    to[1 + p->n] = p->speed;
    while (*count < MOST_STEPS) {
        struct moment *const now = new_moment(p, moment, count, time, to);
        if (!now)
            return 1;
        accelerate(p, now->state, now->first);
        now->load = p->load;
        if (now->state[1 + p->n] < 0 && now->load < nothing * energy * p->alpha && farthest(p, now->state) < reach)
            return 0;
        double error;
        do {
            now->step = step;
            error = extrapolate(p, now->state, now->first, step, COLUMNS, to);
            const double factor = error >= 0 ? 0.9 * pow(p->tolerance / fmax(error, 1e-30), 1.0 / (ORDER - 1)) : 0;
            step *= fmin(3, fmax(0.2, factor));
            if (!(step > 1e-12))
                return 1;
        } while (!(error <= p->tolerance));
        time += now->step;
    }
    return 1;
}

int reference_disk_collision(const struct cor_disk_mode *mode, size_t n, double alpha, double speed, double tolerance,
                             size_t panels, struct reference_collision *out, double *energy_after,
                             double *energy_average)
{
    struct problem p = {.mode = mode, .n = n, .alpha = alpha, .speed = speed, .tolerance = tolerance};
    for (size_t i = 0; i < n; i++)
        if ((size_t)mode[i].n > p.n_max)
            p.n_max = (size_t)mode[i].n;
    p.points = (panels + 1) * GAUSS;
    p.size = 2 * (1 + n) + n;
    const size_t wave = p.n_max + 1;
    double *const memory =
        malloc(((3 + 2 * wave) * p.points + 2 * wave + 3 * (1 + n) + (COLUMNS + 1) * p.size) * sizeof *memory);
    if (!memory)
        return 1;
    double *at = memory;
    double **const part[] = {&p.weight, &p.fall,  &p.pressure,     &p.along,    &p.across,
                             &p.sum_c,  &p.sum_s, &p.acceleration, &p.position, &p.delta};
    const size_t length[] = {p.points, p.points, p.points, wave * p.points, wave * p.points,
                             wave,     wave,     1 + n,    1 + n,           1 + n};
    for (size_t i = 0; i < sizeof part / sizeof *part; i++) {
        *part[i] = at;
        at += length[i];
    }
    for (int k = 0; k < COLUMNS; k++, at += p.size)
        p.table[k] = at;
    double *const to = at;
    place_points(&p, panels);

    struct moment *moment = NULL;
    size_t count = 0;
    const int failed = collide(&p, &moment, &count, to);
    if (!failed) {
        const double energy = mass / 2 * speed * speed, *const last = moment[count - 1].state;
        out->eps = -last[1 + n] / speed;
        out->one_minus_eps2 = 0;
        for (size_t i = 0; i < n; i++) {
            const double left = mode_energy(&mode[i], last[1 + i], last[2 + n + i]) / energy;
            out->one_minus_eps2 += left;
            if (energy_after)
                energy_after[i] = left;
        }
        out->energy_drift = out->eps * out->eps + out->one_minus_eps2 - 1;
        summarise(&p, moment, count, to, out, energy_average);
        out->steps = count - 1;
        out->evaluations = p.evaluations;
    }
    for (size_t i = 0; i < count; i++)
        free(moment[i].state);
    free(moment);
    free(memory);
    return failed;
}
