/* SPDX-License-Identifier: MIT */
/* Free modes of an elastic disk in double arithmetic, COR_MODE_LANES frequencies of one n at a time.
 *
 * The equation needs only the quotients a_m = kappa J_(m+1)(kappa)/J_m(kappa). The ladder a_(m-1) = z/(2m - a_m), z =
 * kappa^2, goes down from any m > kappa without overflow, and the signs of 2m - a_m count the zeros of J_n below kappa,
 * (11.3). Let N = n + 1, u = a_N/(2N) and A = 1/(1 - u). Then kappa J_n'/J_n = n - a_n with a_n = (z/(2N)) A. A is
 * stored as h/d, and A - 1 as k/d, because 1 - A cancels for n > kappa. d = 1 unless |A| > 1; then h = 1, so that
 * nothing overflows where J_n vanishes. In these variables, with capital letters for kappa', the frequency equation
 * (25) divided by g is
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
#include "runtime/number/environment.h"

/* Accuracy of a_n in bits, more than a double holds */
enum { DOUBLE_BITS = 56, START_BITS = 8 };
enum { LANES = COR_MODE_LANES };

/* ---- one n at LANES frequencies ---- */

struct wave {
    double z[LANES], h[LANES], d[LANES], k[LANES], zeros[LANES];
};

/* The error of a_m shrinks by (J_(m+1)/J_m)^2 a step, and -ln J_m grows from m = kappa on like
 * m arcosh(m/kappa) - sqrt(m^2 - kappa^2). */
long cor_mode_ladder_start(long n, double kappa, long bits)
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

static double first_rung(double z, long m)
{
    return 0.75 * z / (double)(m + 1);
}

/* h, d and k of one lane from r = a_N */
static void wave_end(struct wave *a, int i, double r, long n)
{
    const double k = r / (2 * (double)(n + 1)), d = 1 - k;
    const int tall = fabs(d) < 1;
    a->zeros[i] += d < 0;
    a->h[i] = tall ? 1 : 1 / d;
    a->k[i] = tall ? k : k / d;
    a->d[i] = tall ? d : 1;
}

static void wave_set(struct wave *a, long n)
{
    double greatest = 0, kappa[LANES], two_over_kappa[LANES], first_quotient[LANES], quotient[LANES];
    for (int i = 0; i < LANES; i++)
        greatest = fmax(greatest, a->z[i]);
    const long m = cor_mode_ladder_start(n + 1, sqrt(greatest), DOUBLE_BITS);
    for (int i = 0; i < LANES; i++) {
        kappa[i] = sqrt(a->z[i]);
        two_over_kappa[i] = 2 / kappa[i];
        first_quotient[i] = first_rung(a->z[i], m) / kappa[i];
    }
    cor_mode_set(cor_widest_set())->ladder(two_over_kappa, first_quotient, m, n + 1, quotient, a->zeros);
    for (int i = 0; i < LANES; i++)
        wave_end(a, i, kappa[i] * quotient[i], n);
}

/* z d/dz of h, d and k. z dA/dz is N (1 - A) + z A^2/(4N), Riccati's equation for a_n. */
static void wave_derivative(struct wave *to, const struct wave *a, long n)
{
    const double N = (double)(n + 1);
    for (int i = 0; i < LANES; i++) {
        const double x = a->z[i] * a->h[i] * a->h[i] / (4 * N) - N * a->d[i] * a->k[i];
        const int tall = fabs(a->d[i]) < 1;
        to->h[i] = tall ? 0 : x;
        to->d[i] = tall ? -x : 0;
        to->k[i] = x;
    }
}

struct products {
    double t[3];
};

/* T0, T1, T2 are bilinear. With the derivatives of one wave they are one half of the product rule. */
static struct products products_of(const struct cor_mode_material *m, const struct wave *a, const struct wave *b, int i)
{
    const struct products p = {
        {(m->e * a->d[i] - m->s * a->k[i]) * b->d[i] - 2 * b->k[i] * a->d[i], a->d[i] * b->d[i], a->h[i] * b->h[i]}};
    return p;
}

/* The terms of the equation with the factor g/N, including that factor */
static double rest_of(struct products p, double s, double g, double n)
{
    return g / (n + 1) * ((n - 1) * (p.t[1] - s * p.t[2] / 2) + p.t[0] / 2);
}

/* Both waves of one n, longitudinal and transverse, at LANES frequencies */
struct point {
    double w[LANES]; /* omega^2 */
    struct wave a, b;
};

static void point_set(struct point *p, const struct cor_mode_material *m, long n, const double omega[LANES])
{
    for (int i = 0; i < LANES; i++) {
        p->w[i] = omega[i] * omega[i];
        p->a.z[i] = m->s * (m->e * p->w[i]);
        p->b.z[i] = 2 * (m->e * p->w[i]);
    }
    wave_set(&p->a, n);
    if (n > 0)
        wave_set(&p->b, n);
}

/* Negative eigenvalues of the rim's stiffness, free minus clamped, and zeros of both Bessel functions, (11.3). Up to
 * positive factors, the 2 x 2 matrices have det(clamped) = D = x y - n^2, det(free) = F/D, where F is the left side of
 * the equation, and diagonals -y/D and -P/D, where P = y + D/g. */
static double count_of(const struct cor_mode_material *m, const struct wave *a, const struct wave *b, int i, long order)
{
    if (order == 0)
        return a->zeros[i] + (a->h[i] * a->d[i] > 0 && (m->e * a->d[i] - m->s * a->k[i]) * a->d[i] < 0);
    const double n = (double)order, g = b->z[i] / 2;
    const struct products p = products_of(m, a, b, i);
    const double f = rest_of(p, m->s, g, n) - n * (n - 1) / 2 * p.t[0];
    const double part = a->z[i] * p.t[2] / (2 * (n + 1));
    const double det = part + n * (p.t[0] / 2 - 2 * p.t[1]);
    const double trace = n * ((n - 1) * p.t[1] + p.t[0] / 2) - g * b->h[i] * a->d[i] + part;
    const double y = (n * b->d[i] - g * b->h[i] / (n + 1)) * b->d[i];
    const int open = (f < 0) != (det < 0) ? 1 : (trace < 0) == (det < 0) ? 2 : 0;
    const int closed = (det < 0) != (a->d[i] * b->d[i] < 0) ? 1 : y > 0 ? 2 : 0;
    return a->zeros[i] + b->zeros[i] + open - closed + (order > 1);
}

/* Newton's method in omega^2: omega becomes omega sqrt(1 - step). */
static void newton_steps(double step[LANES], const struct point *p, const struct cor_mode_material *m, long order)
{
    struct wave da, db;
    const double n = (double)order, half = n * (n - 1) / 2;
    wave_derivative(&da, &p->a, order);
    if (order == 0) {
        for (int i = 0; i < LANES; i++)
            step[i] = (m->e * p->a.d[i] - m->s * p->a.k[i]) / (m->e * da.d[i] - m->s * da.k[i]);
        return;
    }
    wave_derivative(&db, &p->b, order);
    for (int i = 0; i < LANES; i++) {
        const double g = m->e * p->w[i];
        const struct products both = products_of(m, &p->a, &p->b, i), of_a = products_of(m, &da, &p->b, i),
                              of_b = products_of(m, &p->a, &db, i);
        const double rest = rest_of(both, m->s, g, n);
        const double df = rest + rest_of(of_a, m->s, g, n) + rest_of(of_b, m->s, g, n) - half * (of_a.t[0] + of_b.t[0]);
        step[i] = (rest - half * both.t[0]) / df;
    }
}

/* C > 0 and S at a root, from the more accurate row of
 *
 *     (g + x - n^2) C + n (x - 1) S = 0 = n (y - 1) C + (g + y - n^2) S,      x = n - a_n, y = n - b_n
 *
 * and (11.2). Each row degenerates for some modes. */
static void set_amplitudes(struct cor_disk_mode *mode, const struct point *p, const struct cor_mode_material *m, int i)
{
    const double n = mode->n, w = p->w[i], g = m->e * w;
    if (mode->n == 0) {
        mode->c = sqrt(w / (w - 1));
        mode->s = 0;
        return;
    }
    const double ad = p->a.d[i], bd = p->b.d[i], stiff = g - n * (n - 1);
    const double a = p->a.z[i] * p->a.h[i] / (2 * (n + 1)), b = g * p->b.h[i] / (n + 1);
    double c = n * ((n - 1) * ad - a), s = stiff * ad - a;
    const double c_other = stiff * bd - b, s_other = n * ((n - 1) * bd - b);
    /* the sum of a row relative to the largest of its terms */
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

long cor_mode_count(const struct cor_mode_material *material, long n, double omega)
{
    struct point p;
    double same[LANES];
    for (int i = 0; i < LANES; i++)
        same[i] = omega;
    point_set(&p, material, n, same);
    return (long)count_of(material, &p.a, &p.b, 0, n);
}

/* ---- all n at one frequency ---- */

/* With t = g/N^2 < 1/5, a_n <= (s g/(2N))(1 + s t) and b_n <= (g/N)(1 + 2 t), and for n >= 2 the equation times n keeps
 * its sign at omega = 0, because it is at most -(1 + nu)(n(n-1)/2 - 5 omega^2). */
long cor_mode_orders(double omega)
{
    /* n - 1 is above the rounded product x, and n (n - 1) above x^2 + x: roundings do not matter below 2^49 */
    return (long)(omega * sqrt(10.0)) + 2;
}

double cor_mode_total(const struct cor_mode_material *material, double omega)
{
    struct wave a, b;
    memset(&a, 0, sizeof a);
    memset(&b, 0, sizeof b);
    const long orders = cor_mode_orders(omega);
    const double g = material->e * omega * omega, z[2] = {material->s * g, 2 * g};
    long m = cor_mode_ladder_start(orders, sqrt(z[1]), DOUBLE_BITS);
    double r[2] = {first_rung(z[0], m), first_rung(z[1], m)}, zeros[2] = {0, 0}, total = 0;
    for (; m > 0; m--) {
        const long n = m - 1;
        if (n < orders) {
            a.z[0] = z[0];
            b.z[0] = z[1];
            a.zeros[0] = zeros[0];
            b.zeros[0] = zeros[1];
            wave_end(&a, 0, r[0], n);
            wave_end(&b, 0, r[1], n);
            total += count_of(material, &a, &b, 0, n);
        }
        for (int i = 0; i < 2; i++) {
            const double t = 2 * (double)m - r[i];
            zeros[i] += t < 0;
            r[i] = z[i] / t;
        }
    }
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

/* ---- the roots of one n ---- */

/* A bracket of the root with the index `below_low` */
struct bracket {
    double low, high;
    long below_low, below_high; /* numbers of roots below either end */
    double guess;               /* result of Newton's method inside the bracket, or NaN */
};

/* Roots with a smaller relative difference are set equal, because doubles may not separate them. */
#define INSEPARABLE 0x1p-46
/* After a smaller relative step, Newton's method makes one more step. */
#define NEARLY_DONE 0x1p-30

/* Updates the brackets of roots first..end-1 with the number `below` of roots below x. */
static void tell_brackets(struct bracket *bracket, long first, long end, double x, long below, double guess)
{
    for (long l = first; l < end; l++) {
        struct bracket *const b = &bracket[l];
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
}

/* Bisects the bracket, or follows Newton's method if the bracket contains one root only. */
static double next_place(const struct bracket *b)
{
    const int alone = b->below_high - b->below_low == 1;
    return alone && b->guess > b->low && b->guess < b->high ? b->guess : b->low + (b->high - b->low) / 2;
}

static long clamp_count(double count, long most)
{
    return count < 0 ? 0 : count > (double)most ? most : (long)count;
}

/* Evaluates LANES frequencies at a time, spread over the range, so that most brackets begin with one root. */
static void sweep_range(struct bracket *bracket, const struct cor_mode_material *m, long n, double low, double high,
                        long count)
{
    const long places = count + count / 2;
    for (long first = 0; first < places; first += LANES) {
        struct point p;
        double omega[LANES], step[LANES];
        for (int i = 0; i < LANES; i++) {
            const long place = first + i < places ? first + i : places - 1;
            omega[i] = low + (high - low) * ((double)(place + 1) / (double)(places + 1));
        }
        point_set(&p, m, n, omega);
        newton_steps(step, &p, m, n);
        for (int i = 0; i < LANES; i++)
            tell_brackets(bracket, 0, count, omega[i], clamp_count(count_of(m, &p.a, &p.b, i, n), count),
                          omega[i] * sqrt(1 - step[i]));
    }
}

/* Computes the modes l[0..LANES-1] of one n, some of which may be the same. */
static void refine_modes(struct cor_disk_mode *mode, struct bracket *bracket, const struct cor_mode_material *m, long n,
                         const long l[LANES], long count)
{
    struct point p;
    double omega[LANES], step[LANES], before[LANES]; /* before: length of the step to omega, if Newton's method made
                                                      * it */
    int done[LANES] = {0}, last[LANES] = {0}, left = LANES;
    for (int i = 0; i < LANES; i++) {
        omega[i] = next_place(&bracket[l[i]]);
        before[i] = INFINITY;
    }
    while (left > 0) {
        point_set(&p, m, n, omega);
        newton_steps(step, &p, m, n);
        for (int i = 0; i < LANES; i++) {
            if (done[i])
                continue;
            struct bracket *const b = &bracket[l[i]];
            const double guess = omega[i] * sqrt(1 - step[i]);
            const int narrow = b->high - b->low < INSEPARABLE * b->high;
            if (last[i] || narrow) {
                struct cor_disk_mode *const to = &mode[l[i]];
                to->n = (int)n;
                to->l = (int)l[i];
                to->omega = !narrow && fabs(guess - omega[i]) < INSEPARABLE * omega[i] ? guess : omega[i];
                set_amplitudes(to, &p, m, i);
                done[i] = 1;
                left--;
                continue;
            }
            /* steps that do not become shorter do not converge */
            const int useful = fabs(guess - omega[i]) < 0.5 * before[i];
            tell_brackets(bracket, l[i], l[i] + 1, omega[i], clamp_count(count_of(m, &p.a, &p.b, i, n), count),
                          useful ? guess : NAN);
            before[i] = next_place(b) == guess ? fabs(guess - omega[i]) : INFINITY;
            last[i] = fabs(step[i]) < NEARLY_DONE && next_place(b) == guess;
            omega[i] = next_place(b);
        }
    }
}

int cor_mode_find(const struct cor_mode_material *material, long n, double omega, struct cor_disk_mode *mode,
                  long count)
{
    if (count < 1)
        return COR_OK;
    struct bracket *const bracket = malloc((size_t)count * sizeof *bracket);
    if (bracket == NULL)
        return COR_ERROR_MEMORY;
    const double low = n > 1 ? sqrt((double)n * (double)(n - 1) / 10.5) : 0;
    for (long l = 0; l < count; l++) {
        const struct bracket all = {low, omega, 0, count, NAN};
        bracket[l] = all;
    }
    sweep_range(bracket, material, n, low, omega, count);
    for (long first = 0; first < count; first += LANES) {
        long l[LANES];
        for (int i = 0; i < LANES; i++)
            l[i] = first + i < count ? first + i : count - 1;
        refine_modes(mode, bracket, material, n, l, count);
    }
    free(bracket);
    return COR_OK;
}

/* ---- the lowest modes of all n ---- */

static int by_frequency(const void *a, const void *b)
{
    const struct cor_disk_mode *const x = a, *const y = b;
    if (x->omega != y->omega)
        return x->omega < y->omega ? -1 : 1;
    return x->n != y->n ? (x->n < y->n ? -1 : 1) : (x->l > y->l) - (x->l < y->l);
}

/* Every mode below omega, malloc'ed and unsorted */
static int find_below(const struct cor_mode_material *material, double omega, struct cor_disk_mode **mode,
                      size_t *found)
{
    const long orders = cor_mode_orders(omega);
    size_t capacity = (size_t)cor_mode_total(material, omega) + 16;
    int status = COR_OK;
    *found = 0;
    *mode = malloc(capacity * sizeof **mode);
    for (long n = 0; n < orders && status == COR_OK && *mode != NULL; n++) {
        const long count = cor_mode_count(material, n, omega);
        if (count < 1)
            continue;
        if (*found + (size_t)count > capacity) {
            capacity = 2 * (*found + (size_t)count);
            struct cor_disk_mode *const larger = realloc(*mode, capacity * sizeof **mode);
            if (larger == NULL)
                status = COR_ERROR_MEMORY;
            *mode = larger == NULL ? *mode : larger;
        }
        if (status == COR_OK)
            status = cor_mode_find(material, n, omega, *mode + *found, count);
        *found += (size_t)count;
    }
    return *mode == NULL ? COR_ERROR_MEMORY : status;
}

static int modes_compute(double nu, size_t count, struct cor_disk_mode *mode, struct cor_disk_modes *modes)
{
    if (mode == NULL || modes == NULL)
        return COR_ERROR_NULL;
    if (!(nu > -1 && nu < 1))
        return COR_ERROR_DISK_POISSON_RATIO;
    if (count < 1 || count > COR_DISK_MODES_MAX_COUNT)
        return COR_ERROR_MODES;
    const struct cor_mode_material material = {1 + nu, 1 - nu};
    struct cor_disk_mode *all;
    size_t found;
    int status = find_below(&material, cor_mode_upper_end(&material, count), &all, &found);
    if (status == COR_OK && found < count)
        status = COR_ERROR_MODES;
    if (status == COR_OK) {
        qsort(all, found, sizeof *all, by_frequency);
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

static size_t modes_below(double nu, double omega)
{
    const struct cor_mode_material material = {1 + nu, 1 - nu};
    return nu > -1 && nu < 1 && omega > 0 && omega <= COR_DISK_MODES_MAX_OMEGA
               ? (size_t)cor_mode_total(&material, omega)
               : 0;
}

/* ---- in the default floating-point environment ---- */

COR_IN_ENVIRONMENT(int, cor_disk_modes_compute, modes_compute,
                   (double nu, size_t count, struct cor_disk_mode *mode, struct cor_disk_modes *modes),
                   (nu, count, mode, modes))
COR_IN_ENVIRONMENT(size_t, cor_disk_modes_below, modes_below, (double nu, double omega), (nu, omega))
