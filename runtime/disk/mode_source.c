/* SPDX-License-Identifier: MIT */
/* Free modes of an elastic disk in double arithmetic, COR_MODE_LANES frequencies of one n at a time.
 *
 * The equation needs J_m and J_(m+1) at both arguments kappa, up to a common factor, for m = N = n + 1. The recurrence
 * J_(m-1) = (2m/kappa) J_m - J_(m+1) runs downwards from any m > kappa, and the signs of J_m count the zeros of J_n
 * below kappa, (11.3). One recurrence at each place of a grid of frequencies serves every n. Between two places a
 * Taylor series extends from the nearer one, if kappa is not far below N. Otherwise a recurrence of a few orders
 * suffices.
 *
 * Let h = J_N, k = (kappa/(2N)) J_(N+1) and d = h - k, which is J_n kappa/(2N). The code stores k, because h - d
 * cancels for n > kappa. Capital letters are for kappa'. The frequency equation (25) divided by g is, up to a factor,
 *
 *     -n(n-1)/2 T0 + (g/N) ((n-1)(T1 - s T2/2) + T0/2) = 0        n >= 1
 *     e d - s k = 0                                              n = 0
 *     T0 = e d D - s k D - 2 K d,   T1 = d D,   T2 = h H
 *
 * Nothing cancels in it where nu is close to -1 or 1. */
#include "runtime/disk/mode_source.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cor/status.h"
#include "runtime/disk/rim.h"
#include "runtime/number/environment.h"
#include "runtime/number/kernel.h"

/* DOUBLE_BITS: bits of accuracy of a_n, more than a double has. START_BITS: margin for the error of the start value */
enum { DOUBLE_BITS = 56, START_BITS = 8 };
enum { LANES = COR_MODE_LANES };

/* ---- waves ---- */

/* Each step of the recurrence reduces the error of a_m by (J_(m+1)/J_m)^2, where -ln J_m grows like m arcosh(m/kappa) -
 * sqrt(m^2 - kappa^2) for m >= kappa. */
long cor_mode_recurrence_start(long n, double kappa, long bits)
{
    const double low = fmax((double)n + 1, ceil(kappa));
    const double x = low / kappa;
    const double wanted = low * acosh(x) - kappa * sqrt((x - 1) * (x + 1)) + 0.35 * (double)(bits + START_BITS);
    double m = low + 2 + cbrt(kappa);
    for (int i = 0; i < 20; i++) {
        const double angle = acosh(m / kappa);
        const double step = (m * angle - kappa * sqrt((m / kappa - 1) * (m / kappa + 1)) - wanted) / angle;
        m = fmax(m - step, low + 1);
        if (fabs(step) < 0.5)
            break;
    }
    return (long)m + 2;
}

static double first_order(double z, long m)
{
    return 0.75 * z / (double)(m + 1);
}

/* Returns how many orders above N > kappa a recurrence starts. Each order reduces the error by the factor
 * (J_(N+1)/J_N)^2 or less. */
static double orders_above(double N, double kappa)
{
    return 2 + 0.35 * (DOUBLE_BITS + START_BITS) / acosh(N / kappa);
}

/* Series are used for kappa >= NEAR N, recurrences for smaller kappa. */
#define NEAR 0.8

/* Returns the order at which the recurrence to N = n + 1 starts for arguments up to kappa. */
static long first_of_recurrence(long n, double kappa)
{
    const double N = (double)(n + 1);
    return kappa <= NEAR * N ? n + 1 + (long)orders_above(N, kappa)
                             : cor_mode_recurrence_start(n + 1, kappa, DOUBLE_BITS);
}

/* Computes a wave of one n from its z by recurrences. Every z is at most highest^2. */
static void wave_climb(struct cor_mode_wave *a, const struct cor_mode_loops *loops, long n, double highest)
{
    const long m = first_of_recurrence(n, highest);
    double kappa[LANES], two_over_kappa[LANES], first_quotient[LANES], quotient[LANES];
    memset(a->zeros, 0, sizeof a->zeros);
    for (int i = 0; i < LANES; i++) {
        kappa[i] = sqrt(a->z[i]);
        two_over_kappa[i] = 2 / kappa[i];
        first_quotient[i] = first_order(a->z[i], m) / kappa[i];
    }
    loops->recurrence(two_over_kappa, first_quotient, m, n + 1, quotient, a->zeros);
    for (int i = 0; i < LANES; i++) {
        a->h[i] = 1;
        a->k[i] = kappa[i] * quotient[i] / (2 * (double)(n + 1));
    }
}

static void point_at(struct cor_mode_point *p, const struct cor_mode_material *m, int i, long n, double omega)
{
    p->n[i] = (double)n;
    p->omega[i] = omega;
    p->g[i] = m->e * (omega * omega);
    p->a.z[i] = m->s * p->g[i];
    p->b.z[i] = 2 * p->g[i];
}

/* Sets C > 0 and S at a root, from the more accurate row of
 *
 *     (g + x - n^2) C + n (x - 1) S = 0 = n (y - 1) C + (g + y - n^2) S,      x = n - a_n, y = n - b_n
 *
 * and (11.2). Each row degenerates for some modes. */
static void set_amplitudes(struct cor_disk_mode *mode, const struct cor_mode_point *p, int i)
{
    const double n = mode->n, w = p->omega[i] * p->omega[i], g = p->g[i];
    if (mode->n == 0) {
        mode->c = sqrt(w / (w - 1));
        mode->s = 0;
        return;
    }
    const double ad = p->a.h[i] - p->a.k[i], bd = p->b.h[i] - p->b.k[i], stiff = g - n * (n - 1);
    const double a = p->a.z[i] * p->a.h[i] / (2 * (n + 1)), b = g * p->b.h[i] / (n + 1);
    double c = n * ((n - 1) * ad - a), s = stiff * ad - a;
    const double c_other = stiff * bd - b, s_other = n * ((n - 1) * bd - b);
    /* size of the coefficients of a row relative to their terms, which cancel if the row degenerates */
    const double known = (fabs(c) + fabs(s)) / (fabs(stiff * ad) + n * (n * fabs(ad) + fabs(a)));
    const double known_other = (fabs(c_other) + fabs(s_other)) / (fabs(stiff * bd) + n * (n * fabs(bd) + fabs(b)));
    if (known_other > known) {
        c = c_other;
        s = s_other;
    }
    s = -s;
    const double scale = sqrt(2 * w / (w * (c * c + s * s) - (c + n * s) * (c + n * s)));
    mode->c = copysign(scale, c) * c;
    mode->s = copysign(scale, c) * s;
}

/* ---- all n at one frequency ---- */

/* With t = g/N^2 < 1/5, a_n <= (s g/(2N))(1 + s t) and b_n <= (g/N)(1 + 2 t). For n >= 2, the
 * left side of the equation, times n, is at most -(1 + nu)(n(n-1)/2 - 5 omega^2). While this is negative, the left side
 * keeps the sign that it has at omega = 0. */
long cor_mode_orders(double omega)
{
    /* n - 1 exceeds the rounded product x, so n (n - 1) > x^2 + x. The addend x exceeds the rounding error of x^2. */
    return (long)(omega * sqrt(10.0)) + 2;
}

SHARED double count_total(const struct cor_mode_material *material, double omega)
{
    if (omega < 1) /* below every mode, where products in the equation would underflow */
        return 0;
    const struct cor_mode_loops *const loops = cor_mode_set(cor_widest_set());
    const long orders = cor_mode_orders(omega);
    struct cor_mode_point p;
    struct cor_mode_wave *const wave[2] = {&p.a, &p.b};
    for (int i = 0; i < LANES; i++)
        point_at(&p, material, i, 0, omega);
    long m = cor_mode_recurrence_start(orders, sqrt(p.b.z[0]), DOUBLE_BITS);
    double r[2] = {first_order(p.a.z[0], m), first_order(p.b.z[0], m)}, zeros[2] = {0, 0}, total = 0;
    for (; m > 0; m--) {
        const long n = m - 1;
        const int lane = (int)(n % LANES);
        p.n[lane] = (double)n;
        for (int w = 0; w < 2; w++) {
            wave[w]->h[lane] = 1;
            wave[w]->k[lane] = r[w] / (2 * (double)m);
            wave[w]->zeros[lane] = zeros[w];
            const double t = 2 * (double)m - r[w];
            zeros[w] += t < 0;
            r[w] = wave[w]->z[0] / t;
        }
        if (lane > 0 || n >= orders)
            continue;
        loops->equation(&p, material);
        for (int i = 0; i < LANES && n + i < orders; i++)
            total += p.below[i];
    }
    return total;
}

double cor_mode_total(const struct cor_mode_material *material, double omega)
{
    const struct cor_environment caller = cor_environment_enter();
    const volatile double total = count_total(material, omega);
    cor_environment_leave(&caller);
    return total;
}

double cor_mode_upper_end(const struct cor_mode_material *material, size_t count)
{
    const double wanted = (double)count + 1, enough = wanted + 2 + wanted / 1000;
    double low = 0, high = 1;
    while (cor_mode_total(material, high) < wanted) {
        low = high;
        high *= 2;
    }
    while (high - low > 1e-12 * high) {
        const double middle = low + (high - low) / 2, total = cor_mode_total(material, middle);
        if (total < wanted)
            low = middle;
        else
            high = middle;
        if (total >= wanted && total <= enough)
            break;
    }
    return high;
}

/* ---- a grid of frequencies ---- */

/* Step of the grid in the larger argument kappa', and smallest kappa for a series. Below this kappa, J_N is close to a
 * power of kappa. */
#define GRID_STEP 1.0
#define LEAST_KAPPA 2.0

/* Recurrences of one wave, one at each place (frequency) of the grid. All have reached the order N = n + 1. They run at
 * places >= `active`; series start from places >= `ready`. */
struct recurrences {
    double unit; /* kappa/omega */
    double *kappa, *two_over_kappa, *above, *here, *zeros;
    long active, ready;
};

/* A bracket of root l */
struct root_search {
    double low, high;
    long below_low, below_high; /* numbers of roots below either end */
    double guess;               /* result of Halley's method, used if inside the bracket */
};

/* Roots of one n that are computed at once */
struct group {
    int lanes;
    long l[LANES], place[LANES]; /* place: index in search.place, or -1 */
    struct root_search bracket[LANES];
    double omega[LANES], highest;
    int moves[2]; /* true if the wave is computed by series */
    struct cor_mode_series series[2];
    struct cor_mode_point point;
};

struct search {
    const struct cor_mode_material *material;
    const struct cor_mode_loops *loops;
    struct recurrences wave[2];
    double *memory, *place, *below, *guess; /* place: frequencies; below: roots below; guess: Halley's root */
    long places, room, first, n;            /* first: the first place at which roots of n are counted */
    struct group *group;
};

static int search_start(struct search *s, double omega)
{
    const double e = s->material->e, unit[2] = {sqrt(s->material->s * e), sqrt(2 * e)};
    s->places = (long)ceil(unit[1] * omega / GRID_STEP);
    s->room = (s->places + 2 * LANES - 1) / LANES * LANES; /* rounded up, so that arrays are whole vectors */
    s->memory = calloc((size_t)s->room * 13, sizeof *s->memory);
    s->group = malloc(sizeof *s->group);
    if (s->memory == NULL || s->group == NULL)
        return COR_ERROR_MEMORY;
    struct cor_store store = {(char *)s->memory, 0};
    const size_t room = (size_t)s->room;
    COR_STORE_TAKE_DOUBLES(&store, room, &s->place, &s->below, &s->guess);
    for (long i = 0; i < s->room; i++)
        s->place[i] = omega * ((double)(i + 1) / (double)s->places);
    for (int w = 0; w < 2; w++) {
        struct recurrences *const a = &s->wave[w];
        a->unit = unit[w];
        a->active = a->ready = s->room;
        COR_STORE_TAKE_DOUBLES(&store, room, &a->kappa, &a->two_over_kappa, &a->above, &a->here, &a->zeros);
        for (long i = 0; i < s->room; i++) {
            a->kappa[i] = unit[w] * s->place[i];
            a->two_over_kappa[i] = 2 / a->kappa[i];
        }
    }
    return COR_OK;
}

/* Returns an order at which the recurrence at kappa can begin for every N <= kappa/NEAR. */
static double first_frequency(double kappa)
{
    return kappa / NEAR + orders_above(1, NEAR);
}

/* Lowers all recurrences from order N + 1 to N. */
static void recurrences_lower(struct recurrences *a, const struct search *s, long N)
{
    const long from = a->active - a->active % LANES;
    s->loops->order_step((size_t)(s->room - from), (double)(N + 1), a->two_over_kappa + from, a->above + from,
                         a->here + from, a->zeros + from);
    for (long i = a->active - 1; i >= 0 && a->kappa[i] >= LEAST_KAPPA && first_frequency(a->kappa[i]) >= (double)N;
         i--) {
        a->here[i] = 1;
        a->above[i] = first_order(a->kappa[i] * a->kappa[i], N) / a->kappa[i];
        a->zeros[i] = 0;
        a->active = i;
    }
    while (a->ready > a->active && a->kappa[a->ready - 1] >= NEAR * (double)N)
        a->ready--;
}

/* Returns the frequency that Halley's method finds from a point, or infinity if it fails. */
static double guess_at(const struct cor_mode_point *p, int i)
{
    return islessequal(p->step[i], 1) ? p->omega[i] * sqrt(1 - p->step[i]) : INFINITY;
}

/* Counts the roots of n below every place >= s->first. Returns the number below the last place. */
static long count_places(struct search *s)
{
    const long last = s->places - 1, n = s->n;
    struct cor_mode_point *const p = &s->group->point;
    struct cor_mode_wave *const wave[2] = {&p->a, &p->b};
    long most = 0;
    s->first = s->wave[1].ready < last ? s->wave[1].ready : last;
    for (long from = s->first; from <= last; from += LANES) {
        const int lanes = last - from < LANES ? (int)(last - from) + 1 : LANES;
        for (int i = 0; i < LANES; i++)
            point_at(p, s->material, i, n, s->place[from + i]);
        for (int w = 0; w < 2; w++) {
            const struct recurrences *const a = &s->wave[w];
            if (from < a->ready)
                wave_climb(wave[w], s->loops, n, a->kappa[from + lanes - 1]);
            for (int i = 0; i < LANES && from >= a->ready; i++) {
                wave[w]->h[i] = a->here[from + i];
                wave[w]->k[i] = a->kappa[from + i] * a->above[from + i] / (2 * (double)(n + 1));
                wave[w]->zeros[i] = a->zeros[from + i];
            }
        }
        s->loops->equation(p, s->material);
        for (int i = 0; i < lanes; i++) {
            most = p->below[i] > (double)most ? (long)p->below[i] : most;
            s->below[from + i] = (double)most;
            s->guess[from + i] = guess_at(p, i);
        }
    }
    return most;
}

/* ---- the roots of one n ---- */

/* Roots that differ by a smaller relative amount become equal, because doubles may not separate them. */
#define INSEPARABLE 0x1p-46
/* After a larger relative step, Halley's method makes one more step. */
#define DONE 0x1p-50

static void tell_bracket(struct root_search *b, long l, double x, long below, double guess)
{
    if (l < below && x < b->high) {
        b->high = x;
        b->below_high = below;
        b->guess = guess;
    } else if (l >= below && x > b->low) {
        b->low = x;
        b->below_low = below;
        b->guess = guess;
    }
}

static int is_alone(const struct root_search *b)
{
    return b->below_high - b->below_low == 1;
}

/* Bisects the bracket, or follows Halley's method if the bracket contains only one root. */
static double next_place(const struct root_search *b)
{
    return is_alone(b) && b->guess > b->low && b->guess < b->high ? b->guess : b->low + (b->high - b->low) / 2;
}

static void group_start(struct group *group, const struct search *s)
{
    long lowest = group->place[0];
    group->highest = 0;
    for (int i = 0; i < LANES; i++) {
        if (i >= group->lanes) {
            group->omega[i] = group->omega[0];
            group->place[i] = group->place[0];
            continue;
        }
        group->highest = fmax(group->highest, group->bracket[i].high);
        lowest = group->place[i] < lowest ? group->place[i] : lowest;
    }
    for (int w = 0; w < 2; w++) {
        const struct recurrences *const a = &s->wave[w];
        struct cor_mode_series *const series = &group->series[w];
        group->moves[w] = lowest >= a->ready;
        if (!group->moves[w])
            continue;
        for (int i = 0; i < LANES; i++) {
            const long place = group->place[i];
            series->kappa[i] = a->kappa[place];
            series->here[i] = a->here[place];
            series->above[i] = a->above[place];
            series->zeros[i] = a->zeros[place];
        }
        s->loops->series(series, (double)(s->n + 1));
    }
}

static void group_point(struct group *group, const struct search *s)
{
    struct cor_mode_point *const p = &group->point;
    struct cor_mode_wave *const wave[2] = {&p->a, &p->b};
    for (int i = 0; i < LANES; i++)
        point_at(p, s->material, i, s->n, group->omega[i]);
    for (int w = 0; w < 2; w++) {
        const double unit = s->wave[w].unit;
        double t[LANES];
        if (!group->moves[w])
            wave_climb(wave[w], s->loops, s->n, unit * group->highest);
        for (int i = 0; i < LANES && group->moves[w]; i++)
            t[i] = unit * (group->omega[i] - s->place[group->place[i]]);
        if (group->moves[w])
            s->loops->move(wave[w], &group->series[w], (double)(s->n + 1), t);
    }
    s->loops->equation(p, s->material);
}

static void refine_group(struct cor_disk_mode *mode, struct group *group, const struct search *s, long count)
{
    const struct cor_mode_point *const p = &group->point;
    double before[LANES]; /* length of Halley's step to omega; INFINITY if another method gave omega */
    int done[LANES] = {0}, last[LANES] = {0}, left = group->lanes;
    group_start(group, s);
    for (int i = 0; i < LANES; i++)
        before[i] = INFINITY;
    while (left > 0) {
        group_point(group, s);
        for (int i = 0; i < group->lanes; i++) {
            if (done[i])
                continue;
            struct root_search *const b = &group->bracket[i];
            const long l = group->l[i];
            const double omega = p->omega[i], guess = guess_at(p, i), length = fabs(guess - omega);
            const int near = is_alone(b) && length < INSEPARABLE * omega;
            if ((near && (last[i] || length < DONE * omega)) || b->high - b->low < INSEPARABLE * b->high) {
                mode[l].n = (int)s->n;
                mode[l].l = (int)l;
                mode[l].omega = near ? guess : omega;
                set_amplitudes(&mode[l], p, i);
                done[i] = 1;
                left--;
                continue;
            }
            /* a step of Halley's method is used only if it is shorter than half of the previous one */
            tell_bracket(b, l, omega, p->below[i] > 0 ? (long)fmin(p->below[i], (double)count) : 0,
                         length < 0.5 * before[i] ? guess : INFINITY);
            last[i] = near;
            group->omega[i] = near ? guess : next_place(b);
            before[i] = group->omega[i] == guess ? length : INFINITY;
        }
    }
}

/* Computes the modes of n. count: their number, from count_places. */
static void find_order(struct cor_disk_mode *mode, const struct search *s, long count)
{
    const double n = (double)s->n, least = n > 1 ? sqrt(n * (n - 1) / 10.5) : 0;
    struct group *const group = s->group;
    group->lanes = 0;
    long k = s->first;
    for (long l = 0; l < count; l++) {
        while (s->below[k] <= (double)l)
            k++;
        /* wide: the root is below the first place, so the bracket begins at `least` */
        const int i = group->lanes++, wide = k == s->first;
        struct root_search *const b = &group->bracket[i];
        b->low = wide ? least : s->place[k - 1];
        b->high = s->place[k];
        b->below_low = wide ? 0 : (long)s->below[k - 1];
        b->below_high = (long)s->below[k];
        b->guess = s->guess[k];
        if (!wide && !(b->guess > b->low && b->guess < b->high))
            b->guess = s->guess[k - 1];
        group->l[i] = l;
        group->omega[i] = next_place(b);
        group->place[i] = wide ? -1 : b->high - group->omega[i] < group->omega[i] - b->low ? k : k - 1;
        if (group->lanes == LANES || l + 1 == count || (wide && l + 1 == b->below_high)) {
            refine_group(mode, group, s, count);
            group->lanes = 0;
        }
    }
}

/* ---- the lowest modes of all n ---- */

static int by_frequency(const void *a, const void *b)
{
    const struct cor_disk_mode *const x = a, *const y = b;
    if (x->omega != y->omega)
        return x->omega < y->omega ? -1 : 1;
    return x->n != y->n ? (x->n < y->n ? -1 : 1) : (x->l > y->l) - (x->l < y->l);
}

SHARED int find_modes(const struct cor_mode_material *material, const struct cor_mode_loops *loops, double omega,
                      struct cor_disk_mode **mode, size_t *found)
{
    const long orders = cor_mode_orders(omega);
    /* for each n, count_places may find one root more than cor_mode_total */
    const size_t capacity = (size_t)cor_mode_total(material, omega) + 2 * (size_t)orders;
    struct search s = {.material = material, .loops = loops};
    *found = 0;
    *mode = malloc(capacity * sizeof **mode);
    int status = *mode == NULL ? COR_ERROR_MEMORY : search_start(&s, omega);
    long N = status == COR_OK ? (long)fmax(first_frequency(s.wave[1].kappa[s.room - 1]), (double)orders) : 0;
    for (; N > 0 && status == COR_OK; N--) {
        recurrences_lower(&s.wave[0], &s, N);
        recurrences_lower(&s.wave[1], &s, N);
        if (N > orders)
            continue;
        s.n = N - 1;
        const long count = count_places(&s);
        if ((size_t)count > capacity - *found) {
            status = COR_ERROR_MODES;
        } else {
            find_order(*mode + *found, &s, count);
            *found += (size_t)count;
        }
    }
    free(s.memory);
    free(s.group);
    if (status == COR_OK)
        qsort(*mode, *found, sizeof **mode, by_frequency);
    return status;
}

/* The loops compute both sides of a condition. cor_environment_leave discards exceptions of the unused side. */
int cor_mode_find(const struct cor_mode_material *material, const struct cor_mode_loops *loops, double omega,
                  struct cor_disk_mode **mode, size_t *found)
{
    const struct cor_environment caller = cor_environment_enter();
    const volatile int status = find_modes(material, loops, omega, mode, found);
    cor_environment_leave(&caller);
    return status;
}

int cor_disk_modes_compute(double nu, size_t count, struct cor_disk_mode *mode, struct cor_disk_modes *modes)
{
    if (mode == NULL || modes == NULL)
        return COR_ERROR_NULL;
    if (!isless(fabs(nu), 1))
        return COR_ERROR_DISK_POISSON_RATIO;
    if (count < 1 || count > COR_DISK_MODES_MAX_COUNT)
        return COR_ERROR_MODES;
    const struct cor_mode_material material = {1 + nu, 1 - nu};
    struct cor_disk_mode *all = NULL;
    size_t found;
    int status =
        cor_mode_find(&material, cor_mode_set(cor_widest_set()), cor_mode_upper_end(&material, count), &all, &found);
    if (status == COR_OK && found < count)
        status = COR_ERROR_MODES;
    if (status == COR_OK) {
        for (size_t i = 1; i < count; i++) /* doubles may not separate two frequencies */
            if (!(all[i].omega > all[i - 1].omega))
                all[i].omega = nextafter(all[i - 1].omega, INFINITY);
        memcpy(mode, all, count * sizeof *mode);
        modes->nu = nu;
        modes->count = count;
        modes->mode = mode;
    }
    free(all);
    return status;
}

size_t cor_disk_modes_below(double nu, double omega)
{
    const struct cor_mode_material material = {1 + nu, 1 - nu};
    return isless(fabs(nu), 1) && isgreater(omega, 0) && islessequal(omega, COR_DISK_MODES_MAX_OMEGA)
               ? (size_t)cor_mode_total(&material, omega)
               : 0;
}
