/* SPDX-License-Identifier: MIT */
/* Rayleigh's energy: the sum over modes, what the modes left out add, and how well that is known.
 *
 * The strengths C^2 of the modes have a density 2 omega + a + O(1/omega); a comes from the rim's curvature. About it
 * they fluctuate: what leaves the point of contact comes back to it as an echo, after times T, and an echo of relative
 * strength e is a term e cos(omega T + ...) in the density. So
 *
 *   - against the mean of (2 I)^2 over its phase, the density takes the place of modes not at a sharp cut but under a
 *     weight that fades over the upper third of the frequencies taken; that leaves nothing of any echo.
 *   - What of (2 I)^2 oscillates, like cos(omega tau + ...)/omega^4, is in step with an echo where T is about tau. The
 *     strongest echo, with half of the whole strength, is the surface wave that has gone round the rim: those are the
 *     modes l = 0, whose omega and C^2 go on smoothly as power series in 1/n. They are summed one by one, far beyond the
 *     modes taken.
 *   - The others, of waves through the disk, are weak, e of some percent that falls about like omega^(-1/2), and many.
 *     The modes taken have them too: the oscillation over these modes, under another weight, that is negative before
 *     it rises to 1, foretells some of the oscillation beyond. See echo_weight. What it misses is estimated from the
 *     strength at T = tau, measured on the modes taken. */
#include <math.h>

#include "cor/disk.h"
#include "cor/status.h"
#include "runtime/disk/quasistatic.h"
#include "runtime/disk/rayleigh_spectrum.h"

/* Below the lowest frequency of any disk, 1.1769 for nu -> 1 */
#define LEAST_OMEGA 1.17
/* Frequencies up to this times the highest one taken are treated one by one. */
#define FAR 8.0
/* The weight begins to fade at this times the highest frequency taken. */
#define FADE_FROM 0.65
/* and the other weight here */
#define ECHO_FROM 0.15
/* Relative error of the sums themselves */
#define ROUNDING 1e-11
/* Modes l = 0 that the power series in 1/n are fitted to, and the least and largest n of the last; a table with a larger
 * one would have 10^12 modes */
enum { FITTED = 5, FIT_FROM = 12, FIT_TO = 1000000 };
/* Modes that tails are computed from where the table has them, more than were asked for or not */
enum { TAIL_MODES = 1800 };

static double amplitude(const struct cor_lines *line, int i)
{
    return 2 * (line->cosine[i] * line->re[i] - line->sine[i] * line->im[i] + line->other[i]);
}

/* (2 I)^2, and its mean over the phase */
static double response(const struct cor_lines *line, int i)
{
    const double x = amplitude(line, i);
    return x * x;
}

static double mean_response(const struct cor_lines *line, int i)
{
    return 2 * (line->re[i] * line->re[i] + line->im[i] * line->im[i]) + 4 * line->other[i] * line->other[i];
}

/* 0 to 1 with three derivatives 0 at both ends */
static double fade(double x)
{
    if (x >= 1)
        return 1;
    const double square = x * x;
    return x > 0 ? square * square * (35 + x * (-84 + x * (70 - 20 * x))) : 0;
}

/* r(x), x = (omega/omega_max - 0.15)/0.85; r(0) = 0, r(1) = 1. With r = 1 beyond the modes taken, an echo that misses tau
 * by dT leaves in the sum
 *
 *     F(u) = int r z^(-3 - 1/2) exp(i u z) dz,     z = omega/omega_max, u = omega_max dT,
 *
 * times what is the same for all r. max |F| = |F(0)| = 0.290, and |F| < 0.09 from u = 15 on, 0.03 from 30. A fade
 * without the negative part, from 0.65, has 0.66 in place of 0.29; nothing can have less than about 0.18, the norm of
 * the Hankel operator (1 + x + y)^(-7/2), and what comes near falls off more slowly. */
static double echo_weight(double x)
{
    const double square = x * x;
    return x > 0 ? square * square * x * (5 + x * (16 * x - 20)) : 0;
}

static double bump(double x)
{
    const double y = 4 * x * (1 - x), square = y * y;
    return x > 0 && x < 1 ? square * square : 0;
}

/* Gauss and Legendre's rule with 12 points on [0, 1], the half of it; DLMF 3.5(v) */
enum { HALF_POINTS = 6 };
static const double gauss_x[HALF_POINTS] = {0.125233408511468916, 0.367831498998180194, 0.587317954286617448,
                                            0.769902674194304687, 0.904117256370474857, 0.981560634246719251};
static const double gauss_w[HALF_POINTS] = {0.249147045813402785, 0.233492536538354809, 0.203167426723065922,
                                            0.160078328543346226, 0.106939325995318431, 0.0471753363865118272};

/* ---- the modes l = 0 ---- */

/* Speed of surface waves: xi = (c/c_S)^2, xi^3 - 8 xi^2 + (24 - 16 k) xi - 16 (1 - k) = 0, k = (c_S/c_P)^2, rises in
 * (0, 1) through its one root there. */
static double surface_speed(double nu)
{
    const double k = 0.5 * (1 - nu);
    double low = 0, high = 1;
    for (int i = 0; i < 60; i++) {
        const double xi = 0.5 * (low + high);
        if (((xi - 8) * xi + 24 - 16 * k) * xi - 16 * (1 - k) < 0)
            low = xi;
        else
            high = xi;
    }
    return sqrt(0.5 * (low + high) / (2 * (1 + nu)));
}

struct surface_modes {
    int known; /* the largest n of the table; 0: none that can be continued */
    double speed;
    double node[FITTED], omega[FITTED], strength[FITTED]; /* 1/n; Newton's divided differences */
};

static double newton(const struct surface_modes *modes, const double c[FITTED], double x)
{
    double value = c[FITTED - 1];
    for (int i = FITTED - 2; i >= 0; i--)
        value = value * (x - modes->node[i]) + c[i];
    return value;
}

static double surface_omega(const struct surface_modes *surface, int n)
{
    return surface->speed * n + newton(surface, surface->omega, 1.0 / n);
}

/* omega - speed n and C^2/omega in powers of 1/n */
static void surface_modes_init(struct surface_modes *surface, const struct cor_disk_modes *modes, size_t n_modes)
{
    int last = 0, wanted[FITTED], found = 0;
    for (size_t i = 0; i < n_modes; i++)
        if (modes->mode[i].l == 0 && modes->mode[i].n > last && modes->mode[i].n <= FIT_TO)
            last = modes->mode[i].n;
    surface->known = 0;
    if (last < FIT_FROM)
        return;
    surface->speed = surface_speed(modes->nu);
    for (int k = 0; k < FITTED; k++)
        wanted[k] = last - (last * k) / 8; /* down to half of it */
    for (size_t i = 0; i < n_modes; i++)
        for (int k = 0; k < FITTED && modes->mode[i].l == 0; k++)
            if (modes->mode[i].n == wanted[k]) {
                const struct cor_disk_mode *mode = &modes->mode[i];
                surface->node[k] = 1.0 / mode->n;
                surface->omega[k] = mode->omega - surface->speed * mode->n;
                surface->strength[k] = mode->c * mode->c / mode->omega;
                found++;
            }
    if (found != FITTED)
        return;
    for (int order = 1; order < FITTED; order++)
        for (int k = FITTED - 1; k >= order; k--) {
            const double step = surface->node[k] - surface->node[k - order];
            surface->omega[k] = (surface->omega[k] - surface->omega[k - 1]) / step;
            surface->strength[k] = (surface->strength[k] - surface->strength[k - 1]) / step;
        }
    /* in a table of a disk with none missing the next one comes soon, is not in it, and travels at about that speed */
    const double highest = modes->mode[n_modes - 1].omega, next = surface_omega(surface, last + 1);
    if (next > highest && next < highest + 2 && next < 1.5 * surface->speed * last)
        surface->known = last;
}

/* Sum over the modes l = 0 beyond the table of C^2 times what the response has beyond its mean */
static double surface_sum(const struct surface_modes *surface, const struct cor_spectrum *spectrum, double highest)
{
    double sum = 0, omega[COR_LINES], strength[COR_LINES];
    struct cor_lines lines;
    int n = surface->known, count = COR_LINES;
    if (n == 0)
        return 0;
    do {
        for (count = 0; count < COR_LINES && (count == 0 || omega[count - 1] < FAR * highest); count++) {
            n++;
            omega[count] = surface_omega(surface, n);
            strength[count] = omega[count] * newton(surface, surface->strength, 1.0 / n);
            if (!(omega[count] > highest)) /* no table of a disk */
                return sum;
        }
        cor_spectrum_lines(spectrum, count, omega, &lines);
        for (int i = 0; i < count; i++)
            sum += strength[i] * (response(&lines, i) - mean_response(&lines, i));
    } while (omega[count - 1] < FAR * highest);
    /* beyond: term (n/k)^3 turning by the same angle every time. Its sum is n/(2 - i n z) - 1/2, z the angle's 2 tan of
     * the half: right for small and for large n z, and to some percent between. */
    const int i = count - 1;
    const double c = lines.cosine[i] * lines.re[i] - lines.sine[i] * lines.im[i];
    const double s = lines.cosine[i] * lines.im[i] + lines.sine[i] * lines.re[i];
    const double term = strength[i] * 2 * (c * c - s * s), quadrature = strength[i] * 4 * c * s;
    const double z = 2 * tan(spectrum->half_time * (surface_omega(surface, n + 1) - omega[i]));
    const double size = 4 + (n * z) * (n * z);
    return sum + term * (2 * n / size - 0.5) - quadrature * (n * (n * z) / size);
}

/* ---- the sums ---- */

/* Integrals under the weight, of the density 2 omega times the mean response, and of the mean response alone; and of
 * 2 omega times what of the response turns with omega tau/2 */
struct integrals {
    double mean, curvature, half;
};

static void add_panel(struct integrals *sum, const struct cor_spectrum *spectrum, double low, double high,
                      double fade_from, double fade_to)
{
    struct cor_lines lines;
    double omega[2 * HALF_POINTS];
    for (int i = 0; i < HALF_POINTS; i++) {
        omega[HALF_POINTS - 1 - i] = 0.5 * (low + high) - 0.5 * (high - low) * gauss_x[i];
        omega[HALF_POINTS + i] = 0.5 * (low + high) + 0.5 * (high - low) * gauss_x[i];
    }
    cor_spectrum_lines(spectrum, 2 * HALF_POINTS, omega, &lines);
    for (int i = 0; i < 2 * HALF_POINTS; i++) {
        const double w = gauss_w[i < HALF_POINTS ? HALF_POINTS - 1 - i : i - HALF_POINTS];
        const double weight = 0.5 * (high - low) * w * fade((omega[i] - fade_from) / (fade_to - fade_from));
        const double mean = mean_response(&lines, i);
        sum->mean += weight * 2 * omega[i] * mean;
        sum->curvature += weight * mean;
        sum->half +=
            weight * 16 * omega[i] * fabs(lines.other[i]) * sqrt(lines.re[i] * lines.re[i] + lines.im[i] * lines.im[i]);
    }
}

static struct integrals integrate(const struct cor_spectrum *spectrum, double from, double to)
{
    struct integrals sum = {0, 0, 0};
    add_panel(&sum, spectrum, from, to, from, to);
    for (double omega = to; omega < 0.99 * FAR * to; omega *= 2)
        add_panel(&sum, spectrum, omega, 2 * omega, from, to);
    /* beyond: mean response = g/omega^4, where 1/sqrt(g) goes like ln(omega); with r = dln(g)/dln(omega)/2
     * int 2 g omega^-3 = g (1 + r + 3/2 r^2 + ...)/omega^2 */
    const double ends[2] = {0.5 * FAR * to, FAR * to}, end = ends[1];
    struct cor_lines lines;
    cor_spectrum_lines(spectrum, 2, ends, &lines);
    const double g = mean_response(&lines, 1), r = 0.5 * log(16 * g / mean_response(&lines, 0)) / 0.69314718055994531;
    sum.mean += end * end * g * (1 + r * (1 + 1.5 * r));
    return sum;
}

/* sum of C^2 under a bump, times 1, and for l > 0 times exp(i omega tau) and exp(i omega tau/2) */
struct window {
    double low, high, strength, re, im, half_re, half_im;
};

static void window_add(struct window *window, const struct cor_disk_mode *mode, const struct cor_lines *lines, int i)
{
    const double weight = bump((mode->omega - window->low) / (window->high - window->low)) * mode->c * mode->c;
    window->strength += weight;
    if (mode->l == 0)
        return;
    window->re += weight * (lines->cosine[i] * lines->cosine[i] - lines->sine[i] * lines->sine[i]);
    window->im += weight * 2 * lines->cosine[i] * lines->sine[i];
    window->half_re += weight * lines->cosine[i];
    window->half_im += weight * lines->sine[i];
}

/* int bump = 4^4 4! 4!/9! of its width */
static double bump_integral(const struct window *window)
{
    return (window->high - window->low) * (256 * 576 / 362880.0);
}

static double bump_density(const struct window *window)
{
    return bump_integral(window) * (window->high + window->low);
}

static double echo_of(double re, double im, const struct window *window)
{
    return sqrt(re * re + im * im) / bump_density(window);
}

/* Those of the first COR_LINES, or `left`, modes; how many */
static int lines_of(const struct cor_disk_mode *mode, size_t left, const struct cor_spectrum *spectrum,
                    struct cor_lines *lines)
{
    double omega[COR_LINES];
    const int count = left < COR_LINES ? (int)left : COR_LINES;
    for (int i = 0; i < count; i++)
        omega[i] = mode[i].omega;
    cor_spectrum_lines(spectrum, count, omega, lines);
    return count;
}

/* Tail and error estimate from the n_modes lowest modes, out->fraction being known */
static void finish(struct cor_disk_rayleigh *out, const struct cor_disk_modes *modes, size_t n_modes,
                   const struct cor_spectrum *spectrum)
{
    const double to = modes->mode[n_modes - 1].omega, from = fmax(FADE_FROM * to, LEAST_OMEGA - 0.1);
    const double echo_from = fmax(ECHO_FROM * to, LEAST_OMEGA - 0.1);
    struct window low = {0.35 * to, 0.75 * to, 0, 0, 0, 0, 0}, high = {0.6 * to, to, 0, 0, 0, 0, 0};
    struct surface_modes surface;
    double faded = 0;
    size_t first = n_modes;
    while (first > 0 && modes->mode[first - 1].omega > echo_from)
        first--;
    for (size_t i = first; i < n_modes; i += COR_LINES) {
        struct cor_lines lines;
        const int count = lines_of(&modes->mode[i], n_modes - i, spectrum, &lines);
        for (int j = 0; j < count; j++) {
            const struct cor_disk_mode *mode = &modes->mode[i + (size_t)j];
            const double strength = mode->c * mode->c, mean = mean_response(&lines, j);
            faded += fade((mode->omega - from) / (to - from)) * strength * mean;
            if (mode->l != 0 || mode->n <= 1)
                faded +=
                    echo_weight((mode->omega - echo_from) / (to - echo_from)) * strength * (response(&lines, j) - mean);
            window_add(&low, mode, &lines, j);
            window_add(&high, mode, &lines, j);
        }
    }
    const struct integrals integrals = integrate(spectrum, from, to);
    surface_modes_init(&surface, modes, n_modes);
    const double curvature = surface.known ? (low.strength - bump_density(&low) + high.strength - bump_density(&high)) /
                                                 (bump_integral(&low) + bump_integral(&high))
                                           : 0;
    out->tail = integrals.mean + curvature * integrals.curvature - faded + surface_sum(&surface, spectrum, to);

    /* Echoes in step with the response, as strong as under the windows; what the density has beyond 2 omega + a; the
     * density itself, an echo of T = 0, of which the kink of echo_weight at 1 leaves some part in (omega_max tau)^2; and
     * without the modes l = 0 the tail is anyone's guess. The factors are the least, rounded up, that hold against sums
     * over twenty thousand modes. */
    const double echo = echo_of(high.re, high.im, &high) + 0.7 * echo_of(low.re, low.im, &low);
    const double half_echo = echo_of(high.half_re, high.half_im, &high) + 0.4 * echo_of(low.half_re, low.half_im, &low);
    const double square = to * to, turned = 2 * spectrum->half_time * to;
    const double rest = surface.known ? 0.6 / square + 2000 / (square * square * to) + 60 / (turned * turned) : 1;
    out->error_estimate = (1.6 * echo + rest) * integrals.mean + (2 * half_echo + rest) * integrals.half +
                          ROUNDING * (out->fraction + fabs(out->tail));
}

static int modes_status(const struct cor_disk_modes *modes, size_t n_modes)
{
    if (!(modes->nu > -1 && modes->nu < 1))
        return COR_ERROR_DISK_POISSON_RATIO;
    if (n_modes == 0 || n_modes > modes->count)
        return COR_ERROR_MODES;
    if (!modes->mode)
        return COR_ERROR_NULL;
    double below = LEAST_OMEGA;
    for (size_t i = 0; i < n_modes; i++) {
        const double omega = modes->mode[i].omega, c = modes->mode[i].c;
        if (!(omega >= below && omega < 1e9 && fabs(c) < 1e9))
            return COR_ERROR_MODES;
        below = omega;
    }
    return COR_OK;
}

static int status_of(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum, double speed)
{
    const int status = modes_status(modes, n_modes);
    if (status)
        return status;
    const double limit = cor_disk_speed_limit(modes->nu, datum);
    if (isnan(limit))
        return COR_ERROR_DATUM;
    if (!(speed >= 0 && speed <= limit))
        return COR_ERROR_SPEED;
    return COR_OK;
}

static int result_status(const struct cor_disk_rayleigh *out, double speed)
{
    return speed > COR_DISK_RAYLEIGH_MAX_SPEED || out->fraction + out->tail > 1 ? COR_BEYOND_THEORY : COR_OK;
}

/* v = 0 */
static int at_rest(struct cor_disk_rayleigh *out)
{
    out->fraction = out->tail = out->error_estimate = 0;
    out->contact_time = INFINITY;
    return COR_OK;
}

static void begin(struct cor_disk_rayleigh *out, struct cor_spectrum *spectrum, const struct cor_disk_modes *modes,
                  size_t n_modes, enum cor_disk_datum datum, double speed)
{
    out->fraction = 0;
    out->contact_time = cor_disk_contact_time(speed, modes->nu, datum);
    cor_spectrum_init(spectrum, cor_disk_depth(speed, modes->nu, datum), out->contact_time, LEAST_OMEGA - 0.1,
                      FAR * modes->mode[n_modes - 1].omega);
}

/* Adds the fractions of modes i = from..to-1 to *sum, and puts them into mode_fraction[i] if that is not NULL. */
static void add_fractions(double *sum, const struct cor_disk_modes *modes, size_t from, size_t to,
                          const struct cor_spectrum *spectrum, double *mode_fraction)
{
    for (size_t i = from; i < to; i += COR_LINES) {
        struct cor_lines lines;
        const int count = lines_of(&modes->mode[i], to - i, spectrum, &lines);
        for (int j = 0; j < count; j++) {
            const double c = modes->mode[i + (size_t)j].c, fraction = c * c * response(&lines, j);
            if (mode_fraction)
                mode_fraction[i + (size_t)j] = fraction;
            *sum += fraction;
        }
    }
}

int cor_disk_rayleigh(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum, double speed,
                      struct cor_disk_rayleigh *out, double *mode_fraction)
{
    struct cor_spectrum spectrum;
    if (!modes || !out)
        return COR_ERROR_NULL;
    if (n_modes == 0 || n_modes > modes->count)
        return modes->nu > -1 && modes->nu < 1 ? COR_ERROR_MODES : COR_ERROR_DISK_POISSON_RATIO;
    const size_t least = modes->count < TAIL_MODES ? modes->count : TAIL_MODES, all = n_modes > least ? n_modes : least;
    const int status = status_of(modes, all, datum, speed);
    if (status)
        return status;
    if (speed == 0) {
        for (size_t i = 0; mode_fraction && i < n_modes; i++)
            mode_fraction[i] = 0;
        return at_rest(out);
    }
    begin(out, &spectrum, modes, all, datum, speed);
    add_fractions(&out->fraction, modes, 0, n_modes, &spectrum, mode_fraction);
    struct cor_disk_rayleigh whole = *out;
    add_fractions(&whole.fraction, modes, n_modes, all, &spectrum, NULL);
    finish(&whole, modes, all, &spectrum);
    out->tail = whole.fraction - out->fraction + whole.tail;
    out->error_estimate = whole.error_estimate;
    return result_status(out, speed);
}

int cor_disk_rayleigh_tolerance(const struct cor_disk_modes *modes, enum cor_disk_datum datum, double speed,
                                double tolerance, struct cor_disk_rayleigh *out, size_t *n_modes)
{
    struct cor_spectrum spectrum;
    if (!modes || !out)
        return COR_ERROR_NULL;
    const int status = status_of(modes, modes->count, datum, speed);
    if (status)
        return status;
    if (!(tolerance > 0 && tolerance < 1))
        return COR_ERROR_TOLERANCE;
    if (speed == 0) {
        if (n_modes)
            *n_modes = 1;
        return at_rest(out);
    }
    begin(out, &spectrum, modes, modes->count, datum, speed);
    /* a quarter more modes at a time until they are enough, then halving between that and the number before */
    size_t few = 0, enough = 0, n = 1;
    double sum_few = 0;
    struct cor_disk_rayleigh best = *out;
    for (;;) {
        struct cor_disk_rayleigh trial = *out;
        trial.fraction = sum_few;
        add_fractions(&trial.fraction, modes, few, n, &spectrum, NULL);
        finish(&trial, modes, n, &spectrum);
        if (trial.error_estimate <= tolerance * (trial.fraction + trial.tail)) {
            enough = n;
            best = trial;
        } else {
            few = n;
            sum_few = trial.fraction;
            if (enough == 0)
                best = trial;
        }
        if (enough == 0 && few == modes->count)
            break;
        if (enough != 0 && enough - few == 1)
            break;
        n = enough == 0 ? few + 1 + few / 4 : few + (enough - few) / 2;
        if (n > modes->count)
            n = modes->count;
    }
    *out = best;
    if (n_modes)
        *n_modes = enough ? enough : modes->count;
    return enough ? result_status(out, speed) : COR_TOLERANCE_NOT_REACHED;
}
