/* SPDX-License-Identifier: MIT */
/* A whole collision in the type REAL, which is wider than double; included once for each such type by
 * reference_collision.c, after reference_collision_series.h for double and for REAL. */

/* cos(angle) - 1 and sin(angle), |angle| < 1 */
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

/* Gauss's rule on (-1, 1), from Legendre's polynomials */
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

struct NAME(solver) {
    struct NAME(series) wide;
    struct double_series narrow;
    REAL *weight, *position, *velocity; /* weight: of each point, in both quadrants */
};

/* The rule's points and what each row moves the rim by there: cos(n phi) cos(phi), and -sin(n phi) sin(phi) */
static void NAME(place_points)(const struct disk *disk, struct NAME(solver) * s)
{
    const REAL quarter = NAME(pi)() / 2;
    REAL node[GAUSS], weight[GAUSS];
    NAME(gauss_rule)(node, weight);
    for (size_t j = 0; j < disk->points; j++) {
        const size_t panel = j / GAUSS, at = j % GAUSS;
        const REAL phi = quarter * (2 * panel + 1 + node[at]) / (2 * disk->panels);
        REAL half_cos, half_sin, c[2], cos_phi, sin_phi;
        NAME(small_angle)(phi / 2, &half_cos, &half_sin);
        s->weight[j] = quarter * weight[at] / disk->panels;
        s->wide.shape[j] = -2 * half_sin * half_sin;
        s->narrow.shape[j] = (double)s->wide.shape[j];
        cos_phi = 1 + s->wide.shape[j];
        sin_phi = 2 * half_sin * (1 + half_cos);
        c[0] = 1; /* cos(n phi) and sin(n phi) */
        c[1] = 0;
        for (size_t n = 0; n <= disk->n_max; n++) {
            const size_t row = disk->row_of[n];
            for (size_t i = 0; row < disk->rows && i < 2; i++) {
                const REAL value = i == 0 ? c[0] * cos_phi : -c[1] * sin_phi;
                const size_t by_point = (panel * disk->rows + row + i) * GAUSS + at;
                const size_t by_row = (row / GROUP * disk->points + j) * GROUP + (row + i) % GROUP;
                s->wide.by_point[by_point] = s->wide.by_row[by_row] = value;
                s->narrow.by_point[by_point] = s->narrow.by_row[by_row] = (double)value;
            }
            const REAL next = c[0] * cos_phi - c[1] * sin_phi;
            c[1] = c[1] * cos_phi + c[0] * sin_phi;
            c[0] = next;
        }
    }
}

/* The panels whose pressure matters during a step: those above the negligible position and within `depth` of the
 * farthest point in alpha x. Returns the longest step for which they are all. */
static double NAME(choose_panels)(struct disk *disk, const struct effort *effort, const struct NAME(solver) * s)
{
    const double *const x = s->narrow.rise, *const speed = s->narrow.rise + disk->points; /* alpha x, alpha x' */
    double farthest = -HUGE_VAL, fastest = disk->alpha * disk->speed;
    disk->active = disk->panels;
    for (size_t i = 0; i < disk->panels; i++)
        disk->panel[i] = i;
    for (int k = 0; k < 2; k++)
        double_rim(disk, &s->narrow, k);
    for (size_t j = 0; j < disk->points; j++) {
        farthest = fmax(farthest, x[j] + disk->alpha * s->narrow.shape[j]);
        fastest = fmax(fastest, fabs(speed[j]));
    }
    const double nothing = disk->alpha * negligible_position(disk, effort);
    disk->active = 0;
    for (size_t i = 0; i < disk->panels; i++) {
        double most = -HUGE_VAL;
        for (size_t j = i * GAUSS; j < (i + 1) * GAUSS; j++)
            most = fmax(most, x[j] + disk->alpha * s->narrow.shape[j]);
        if (most > fmax(nothing, farthest + log(effort->tolerance) - MARGIN))
            disk->panel[disk->active++] = i;
    }
    const double most_speed = fabs(s->narrow.position[1 + disk->n]) + swing(disk, s->narrow.position, 1);
    return disk->active > 0 ? MARGIN / 4 / fastest : (nothing - farthest + MARGIN / 4) / (disk->alpha * most_speed);
}

/* Taylor coefficients of a step from the state; returns its length. */
static double NAME(expand)(struct disk *disk, const struct effort *effort, const struct NAME(solver) * s)
{
    const size_t n = disk->n;
    for (size_t i = 0; i <= n; i++) {
        s->wide.position[i] = s->position[i];
        s->wide.position[1 + n + i] = s->velocity[i];
        s->narrow.position[i] = (double)s->position[i];
        s->narrow.position[1 + n + i] = (double)s->velocity[i];
    }
    double h = NAME(choose_panels)(disk, effort, s);
    for (int k = 0; k < effort->order; k++) {
        if (k >= effort->wide_orders) {
            double_rim(disk, &s->narrow, k);
            double_press(disk, &s->narrow, k);
            double_accelerate(disk, &s->narrow, k);
        } else {
            NAME(rim)(disk, &s->wide, k);
            if (k > 0)
                NAME(press)(disk, &s->wide, k);
            for (size_t a = 0; a < disk->active; a++)
                for (size_t j = disk->panel[a] * GAUSS; j < (disk->panel[a] + 1) * GAUSS; j++) {
                    const size_t at = (size_t)k * disk->points + j;
                    if (k == 0)
                        s->wide.pressure[j] =
                            s->weight[j] * NAME(exp)(s->wide.rise[j] + disk->alpha * s->wide.shape[j]);
                    s->narrow.rise[at] = (double)s->wide.rise[at];
                    s->narrow.pressure[at] = (double)s->wide.pressure[at];
                }
            NAME(accelerate)(disk, &s->wide, k);
            s->narrow.load[k] = (double)s->wide.load[k];
            for (size_t i = (size_t)(k + 2) * (1 + n); i < (size_t)(k + 3) * (1 + n); i++)
                s->narrow.position[i] = (double)s->wide.position[i];
        }
        h = fmin(h, step_allowed(disk, effort, s->narrow.position, k + 2));
    }
    return h;
}

/* The state a time h later */
static void NAME(advance)(const struct disk *disk, const struct effort *effort, const struct NAME(solver) * s, double h)
{
    const size_t n = disk->n;
    for (size_t i = 0; i <= n; i++) {
        REAL position = 0, velocity = 0;
        for (int k = effort->order + 1; k >= 0; k--) {
            const size_t at = (size_t)k * (1 + n) + i;
            const REAL coefficient = k < effort->wide_orders + 2 ? s->wide.position[at] : s->narrow.position[at];
            velocity = velocity * h + position;
            position = position * h + coefficient;
        }
        s->position[i] = position;
        s->velocity[i] = velocity;
    }
}

/* 0, or 2 after MOST_STEPS */
static int NAME(collide)(struct disk *disk, const struct effort *effort, struct course *course)
{
    struct pool pool = {{0}, 0};
    struct NAME(solver) s;
    const double reach = negligible_position(disk, effort);
    double time = reach / disk->speed;
    NAME(take)(disk, effort->wide_orders + 2, &pool, &s.wide);
    double_take(disk, effort->order + 2, &pool, &s.narrow);
    s.weight = pool_take(&pool, disk->points, sizeof(REAL));
    s.position = pool_take(&pool, 1 + disk->n, sizeof(REAL));
    s.velocity = pool_take(&pool, 1 + disk->n, sizeof(REAL));
    disk->panel = pool_take(&pool, disk->panels, sizeof *disk->panel);
    s.wide.mass = NAME(pi)();
    s.narrow.mass = (double)s.wide.mass;
    NAME(place_points)(disk, &s);
    s.position[0] = reach;
    s.velocity[0] = disk->speed;
    for (course->steps = 0; course->steps < MOST_STEPS; course->steps++) {
        const double h = NAME(expand)(disk, effort, &s);
        if (s.velocity[0] < 0 && disk->active == 0 && s.narrow.position[0] + swing(disk, s.narrow.position, 0) < reach)
            break;
        follow(disk, effort, &s.narrow, course, time, h);
        NAME(advance)(disk, effort, &s, h);
        time += h;
    }
    const REAL speed = disk->speed;
    course->eps = (long double)(-s.velocity[0] / speed);
    course->one_minus_eps2 = 0;
    for (size_t i = 0; i < disk->n; i++) {
        const REAL p = s.velocity[1 + i] / speed, q = disk->mode[i].omega * s.position[1 + i] / speed;
        course->after[i] = (double)(p * p + q * q);
        course->one_minus_eps2 += course->after[i];
    }
    pool_free(&pool);
    return course->steps < MOST_STEPS ? 0 : 2;
}
