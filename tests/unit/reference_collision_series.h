/* SPDX-License-Identifier: MIT */
/* One order of the Taylor series of a collision, in the type REAL; included once for each type by
 * reference_collision.c, which defines struct disk. NAME(x) is x with the type's prefix. */

/* Coefficients of t^k. `rise` is alpha k x_k, which the recurrence of the exponential needs. */
struct NAME(series) {
    REAL *by_point;        /* [panel][row][GAUSS]: what the rows' sums move the rim by at each point */
    REAL *by_row;          /* [row / GROUP][point][GROUP]: the same */
    REAL *shape;           /* [point]: cos(phi) - 1 */
    REAL *position;        /* [k][1 + n]: x_0 + 1 and Q */
    REAL *rise, *pressure; /* [k][point]: with the point's weight */
    REAL *load;            /* [k] */
    REAL *sum, *force;     /* [row] */
    REAL mass;
};

/* The memory of so many orders, in pieces of `pool` */
static void NAME(take)(const struct disk *disk, int orders, struct pool *pool, struct NAME(series) * s)
{
    const size_t k = (size_t)orders, n = 1 + disk->n, points = disk->points, rows = disk->rows;
    REAL **const to[] = {&s->by_point, &s->by_row, &s->shape, &s->position, &s->rise,
                         &s->pressure, &s->load,   &s->sum,   &s->force};
    const size_t count[] = {points * rows, points * rows, points, k * n, k * points, k * points, k, rows, rows};
    for (size_t i = 0; i < sizeof to / sizeof *to; i++)
        *to[i] = pool_take(pool, count[i], sizeof(REAL));
}

/* x_k at the points of the active panels, but for the shape of the disk */
static void NAME(rim)(const struct disk *disk, const struct NAME(series) * s, int k)
{
    const REAL *const position = s->position + (size_t)k * (1 + disk->n);
    const REAL factor = (REAL)disk->alpha * (k > 0 ? k : 1);
    for (size_t r = 0; r < disk->rows; r++)
        s->sum[r] = 0;
    for (size_t i = 0; i < disk->n; i++) {
        s->sum[disk->row[i]] += disk->mode[i].c * position[1 + i];
        s->sum[disk->row[i] + 1] += disk->mode[i].s * position[1 + i];
    }
    for (size_t a = 0; a < disk->active; a++) {
        const size_t panel = disk->panel[a];
        const REAL *table = s->by_point + panel * disk->rows * GAUSS;
        REAL x[GAUSS];
        for (size_t j = 0; j < GAUSS; j++)
            x[j] = position[0];
        for (size_t r = 0; r < disk->rows; r++, table += GAUSS)
            for (size_t j = 0; j < GAUSS; j++)
                x[j] += s->sum[r] * table[j];
        for (size_t j = 0; j < GAUSS; j++)
            s->rise[(size_t)k * disk->points + panel * GAUSS + j] = factor * x[j];
    }
}

/* f = exp(alpha x): k f_k = sum_{i = 1 .. k} alpha i x_i f_{k - i}, k > 0 */
static void NAME(press)(const struct disk *disk, const struct NAME(series) * s, int k)
{
    for (size_t a = 0; a < disk->active; a++) {
        const size_t first = disk->panel[a] * GAUSS;
        REAL f[GAUSS] = {0};
        for (int i = 1; i <= k; i++) {
            const REAL *const rise = s->rise + (size_t)i * disk->points + first;
            const REAL *const pressure = s->pressure + (size_t)(k - i) * disk->points + first;
            for (size_t j = 0; j < GAUSS; j++)
                f[j] += rise[j] * pressure[j];
        }
        for (size_t j = 0; j < GAUSS; j++)
            s->pressure[(size_t)k * disk->points + first + j] = f[j] / k;
    }
}

/* The wall's forces of the order k, and with them the positions of the order k + 2 */
static void NAME(accelerate)(const struct disk *disk, const struct NAME(series) * s, int k)
{
    const REAL *const pressure = s->pressure + (size_t)k * disk->points;
    const REAL *const position = s->position + (size_t)k * (1 + disk->n);
    REAL *const next = s->position + (size_t)(k + 2) * (1 + disk->n);
    for (size_t r = 0; r < disk->rows; r += GROUP) {
        REAL force[GROUP] = {0};
        for (size_t a = 0; a < disk->active; a++)
            for (size_t j = disk->panel[a] * GAUSS; j < (disk->panel[a] + 1) * GAUSS; j++)
                for (size_t i = 0; i < GROUP; i++)
                    force[i] += pressure[j] * s->by_row[(r * disk->points) + j * GROUP + i];
        for (size_t i = 0; i < GROUP; i++)
            s->force[r + i] = force[i];
    }
    s->load[k] = 0;
    for (size_t a = 0; a < disk->active; a++)
        for (size_t j = disk->panel[a] * GAUSS; j < (disk->panel[a] + 1) * GAUSS; j++)
            s->load[k] += pressure[j];
    const REAL orders = (REAL)(k + 1) * (REAL)(k + 2);
    next[0] = -s->load[k] / (s->mass * orders);
    for (size_t i = 0; i < disk->n; i++) {
        const struct cor_disk_mode *const m = &disk->mode[i];
        const REAL omega2 = (REAL)m->omega * (REAL)m->omega;
        const REAL force = m->c * s->force[disk->row[i]] + m->s * s->force[disk->row[i] + 1];
        next[1 + i] = -(omega2 * position[1 + i] + force / s->mass) / orders;
    }
}
