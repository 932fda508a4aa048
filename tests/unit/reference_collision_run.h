/* SPDX-License-Identifier: MIT */
/* Computes a whole collision in the type REAL, which is wider than double. reference_collision.c, which defines struct
 * disk, includes this file once for each such type. NAME(x) is x with the prefix of the type. */

/* Computes cos(angle) - 1 and sin(angle) for |angle| < 1. */
static void NAME(small_angle)(REAL angle, REAL *cos_less_1, REAL *sine)
{
    REAL term = 1;
    *cos_less_1 = *sine = 0;
    for (int k = 1; k <= 40; k++) {
        term *= angle / k;
        if (k % 2 == 1)
            *sine += k % 4 == 1 ? term : -term;
        else
            *cos_less_1 += k % 4 == 2 ? -term : term;
    }
}

/* Computes Gauss's rule on (-1, 1) from Legendre's polynomials. */
static void NAME(gauss_rule)(REAL node[GAUSS], REAL weight[GAUSS])
{
    for (int i = 0; i < GAUSS; i++) {
        REAL x = (REAL)cos(3.14159265358979 * (i + 0.75) / ((double)GAUSS + 0.5)), slope = 0;
        for (int step = 0; step < 7; step++) {
            REAL p0 = 1, p1 = x;
            for (int k = 2; k <= GAUSS; k++) {
                const REAL p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
                p0 = p1;
                p1 = p2;
            }
            slope = (REAL)GAUSS * (x * p1 - p0) / (x * x - 1);
            x -= p1 / slope;
        }
        node[i] = x;
        weight[i] = 2 / ((1 - x * x) * slope * slope);
    }
}

/* Taylor coefficients in time. The recurrence for the exponential needs `rise`, which is alpha k x_k. */
struct NAME(series) {
    REAL *table;           /* [point][row]: displacement of the rim per unit of the row's sum */
    REAL *shape, *weight;  /* [point]: alpha (cos(phi) - 1); weights of the rule, for both quadrants */
    REAL *position;        /* [k][1 + n]: x_0 + 1, then Q; rows 0 and 1: positions, velocities */
    REAL *rise, *pressure; /* [k][point]: alpha k x_k, see rim(); pressure times weight */
    REAL *sum;             /* [row] */
};

/* Allocates the memory of a run. The caller frees it. */
static REAL *NAME(take)(const struct disk *disk, struct NAME(series) * s)
{
    const size_t k = (size_t)disk->effort->order + 2, points = disk->points, rows = disk->rows;
    REAL **const to[] = {&s->table, &s->shape, &s->weight, &s->position, &s->rise, &s->pressure, &s->sum};
    const size_t count[] = {rows * points, points, points, k * (1 + disk->n), k * points, k * points, rows};
    size_t used = 0;
    for (size_t i = 0; i < sizeof to / sizeof *to; i++)
        used += count[i];
    REAL *const memory = take(used, sizeof(REAL));
    used = 0;
    for (size_t i = 0; i < sizeof to / sizeof *to; used += count[i++])
        *to[i] = memory + used;
    return memory;
}

/* Sets the points of the rule and the rim displacements there: cos(n phi) cos(phi), and -sin(n phi) sin(phi). */
static void NAME(place_points)(const struct disk *disk, const struct NAME(series) * s)
{
    const REAL quarter = NAME(pi)() / 2;
    REAL node[GAUSS], weight[GAUSS];
    NAME(gauss_rule)(node, weight);
    for (size_t j = 0; j < disk->points; j++) {
        const size_t panels = disk->points / GAUSS, panel = j / GAUSS, at = j % GAUSS;
        const REAL phi = quarter * (2 * panel + 1 + node[at]) / (2 * panels);
        REAL half_cos, half_sin, c[2] = {1, 0}; /* cos(n phi) and sin(n phi) */
        NAME(small_angle)(phi / 2, &half_cos, &half_sin);
        const REAL cos_phi = 1 - 2 * half_sin * half_sin, sin_phi = 2 * half_sin * (1 + half_cos);
        s->weight[j] = quarter * weight[at] / panels;
        s->shape[j] = disk->alpha * (-2 * half_sin * half_sin);
        for (size_t row = 0; row < disk->rows; row += 2) {
            const REAL next = c[0] * cos_phi - c[1] * sin_phi;
            s->table[j * disk->rows + row] = c[0] * cos_phi;
            s->table[j * disk->rows + row + 1] = -c[1] * sin_phi;
            c[1] = c[1] * cos_phi + c[0] * sin_phi;
            c[0] = next;
        }
    }
}

/* Computes alpha k x_k, or alpha x_0 for k = 0, at the active points. Omits the part cos(phi) - 1 of x_0. */
static void NAME(rim)(const struct disk *disk, const struct NAME(series) * s, int k)
{
    const REAL *const position = s->position + (size_t)k * (1 + disk->n);
    const REAL factor = (REAL)disk->alpha * (k > 0 ? k : 1);
    REAL *const rise = s->rise + (size_t)k * disk->points;
    for (size_t r = 0; r < disk->rows; r++)
        s->sum[r] = 0;
    for (size_t i = 0; i < disk->n; i++) {
        REAL *const sum = s->sum + 2 * disk->mode[i].n;
        sum[0] += disk->mode[i].c * position[1 + i];
        sum[1] += disk->mode[i].s * position[1 + i];
    }
    for (size_t j = 0; j < disk->active; j++) {
        REAL x = position[0];
        for (size_t r = 0; r < disk->rows; r++)
            x += s->sum[r] * s->table[j * disk->rows + r];
        rise[j] = factor * x;
    }
}

/* Computes f = exp(alpha x): k f_k = sum_{i = 1 .. k} alpha i x_i f_{k - i}. */
static void NAME(press)(const struct disk *disk, const struct NAME(series) * s, int k)
{
    const size_t points = disk->points;
    for (size_t j = 0; j < disk->active; j++) {
        REAL sum = 0;
        for (size_t i = 1; i <= (size_t)k; i++)
            sum += s->rise[i * points + j] * s->pressure[((size_t)k - i) * points + j];
        s->pressure[(size_t)k * points + j] = k > 0 ? sum / k : s->weight[j] * NAME(exp)(s->rise[j] + s->shape[j]);
    }
}

/* Computes the forces of the wall of order k, and from them the positions of order k + 2. */
static void NAME(accelerate)(const struct disk *disk, const struct NAME(series) * s, int k)
{
    const size_t width = 1 + disk->n, at = (size_t)(k + 2) * width;
    const REAL *const pressure = s->pressure + (size_t)k * disk->points;
    const REAL *const position = s->position + (size_t)k * width;
    const REAL orders = (REAL)(k + 1) * (REAL)(k + 2), mass = NAME(pi)();
    REAL load = 0;
    for (size_t r = 0; r < disk->rows; r += 2) {
        REAL c = 0, sine = 0;
        for (size_t j = 0; j < disk->active; j++) {
            c += pressure[j] * s->table[j * disk->rows + r];
            sine += pressure[j] * s->table[j * disk->rows + r + 1];
        }
        s->sum[r] = c;
        s->sum[r + 1] = sine;
    }
    for (size_t j = 0; j < disk->active; j++)
        load += pressure[j];
    disk->load[k] = (double)load;
    s->position[at] = -load / (mass * orders);
    for (size_t i = 0; i < disk->n; i++) {
        const struct cor_disk_mode *const m = &disk->mode[i];
        const REAL force = m->c * s->sum[2 * m->n] + m->s * s->sum[2 * m->n + 1];
        s->position[at + 1 + i] = -((REAL)m->omega * (REAL)m->omega * position[1 + i] + force / mass) / orders;
    }
    for (size_t i = at; i < at + width; i++)
        disk->path[i] = (double)s->position[i];
}

/* Chooses the points whose pressure matters during a step. At these points x is above the negligible position, and
 * alpha x is within ln(tolerance) of its largest value. Returns the longest step for which no other point matters. */
static double NAME(choose_points)(struct disk *disk, const struct NAME(series) * s)
{
    double farthest = -HUGE_VAL, fastest = disk->alpha * disk->speed;
    disk->active = disk->points;
    for (int k = 0; k < 2; k++)
        NAME(rim)(disk, s, k);
    for (size_t j = 0; j < disk->points; j++) {
        farthest = fmax(farthest, (double)(s->rise[j] + s->shape[j]));
        fastest = fmax(fastest, fabs((double)s->rise[disk->points + j]));
    }
    const double nothing = disk->alpha * negligible_position(disk);
    const double least = fmax(nothing, farthest + log(disk->effort->tolerance) - MARGIN);
    while (disk->active > 0 && (double)(s->rise[disk->active - 1] + s->shape[disk->active - 1]) <= least)
        disk->active--;
    const double most_speed = fabs(disk->path[1 + disk->n]) + swing(disk, 1);
    return disk->active > 0 ? MARGIN / 4 / fastest : (nothing - farthest + MARGIN / 4) / (disk->alpha * most_speed);
}

/* Computes the Taylor coefficients of a step from the state. Returns the length of the step. */
static double NAME(expand)(struct disk *disk, const struct NAME(series) * s)
{
    const double h = NAME(choose_points)(disk, s);
    for (int k = 0; k < disk->effort->order; k++) {
        NAME(rim)(disk, s, k);
        NAME(press)(disk, s, k);
        NAME(accelerate)(disk, s, k);
    }
    return fmin(h, step_allowed(disk));
}

static void NAME(advance)(const struct disk *disk, const struct NAME(series) * s, double h)
{
    const size_t width = 1 + disk->n;
    for (size_t i = 0; i < width; i++) {
        REAL position = 0, velocity = 0;
        for (size_t k = (size_t)disk->effort->order + 2; k-- > 0;) {
            velocity = velocity * h + position;
            position = position * h + s->position[k * width + i];
        }
        disk->path[i] = (double)(s->position[i] = position);
        disk->path[width + i] = (double)(s->position[width + i] = velocity);
    }
}

/* Returns 0, or 2 after MOST_STEPS. */
static int NAME(collide)(struct disk *disk)
{
    const double reach = negligible_position(disk);
    struct NAME(series) s;
    REAL *const memory = NAME(take)(disk, &s), *const velocity = s.position + 1 + disk->n;
    double time = reach / disk->speed;
    int steps = 0;
    NAME(place_points)(disk, &s);
    s.position[0] = reach;
    velocity[0] = disk->speed;
    NAME(advance)(disk, &s, 0);
    for (; steps < MOST_STEPS; steps++) {
        const double h = NAME(expand)(disk, &s);
        if (velocity[0] < 0 && disk->active == 0 && disk->path[0] + swing(disk, 0) < reach)
            break;
        follow(disk, time, h);
        NAME(advance)(disk, &s, h);
        time += h;
    }
    const REAL speed = disk->speed;
    disk->eps = (long double)(-velocity[0] / speed);
    disk->one_minus_eps2 = 0;
    for (size_t i = 0; i < disk->n; i++) {
        const REAL p = velocity[1 + i] / speed, q = disk->mode[i].omega * s.position[1 + i] / speed;
        disk->after[i] = (double)(p * p + q * q);
        disk->one_minus_eps2 += disk->after[i];
    }
    free(memory);
    return steps < MOST_STEPS ? 0 : 2;
}
