/* SPDX-License-Identifier: MIT */
/* The tail of Rayleigh's energy.
 *
 * The strengths C^2 of the modes have a mean density 2 omega + a + O(1/omega), where a comes from the curvature of the
 * rim. Waves that leave the point of contact return to it as echoes after times T. An echo of relative strength e adds
 * e cos(omega T + ...) to the density.
 *
 *   - For the average of (2 I)^2 over its phase, an integral over the density continues the sum over modes. The weight
 *   of the modes decreases to 0 over the upper third of the summed frequencies. This smooth cutoff removes all echoes.
 *   - The oscillating part of (2 I)^2 varies like cos(omega tau + ...)/omega^4. An echo with T near tau is in phase.
 *   The strongest echo, with half of the whole strength, is the surface wave along the rim. It consists of the modes
 *   l = 0, whose omega and C^2 continue smoothly as power series in 1/n. The modes l = 0 are summed one by one, far
 *   beyond the table.
 *   - The echoes of waves through the disk are many and weak: e is a few percent, decreasing about like omega^(-1/2).
 *   The modes of the table contain these echoes. Their oscillation, under a weight that is negative before it increases
 *   to 1 (kernel_echo_weight), predicts part of the oscillation beyond the table. The rest is estimated from the echo
 *   strength at T = tau, measured on the modes of the table. */
#include "runtime/disk/rayleigh_parts.h"
#include "runtime/number/elementary.h"
#include "runtime/number/root.h"

#include <math.h>
#include <string.h>

/* Frequencies in units of the highest frequency of the table (docs/theory-disks.md, 13). They are the starts of the
 * cutoff weight and of the echoes' weight, and the two windows that measure the strength of echoes. Chosen. */
#define FADE_FROM 0.65
#define ECHO_FROM 0.15
static const double low_window[2] = {0.35, 0.75}, high_window[2] = {0.6, 1};

/* Factors of the error estimate. Fitted: the smallest, rounded up, that bound the error against sums over 20,000 modes
 * (tests/unit/test_disk_rayleigh.c). */
static const struct {
    double echo_low, half_echo_low; /* weights of the echo strengths in the low window; 1 in the high window */
    double of_echo, of_half_echo;   /* factors of the echo strengths measured at T = tau and at T = tau/2 */
    double of_density, of_fifth;    /* error of the density 2 omega + a: factors of omega_max^-2 and omega_max^-5 */
    /* factor of (omega_max tau)^-2. The density acts like an echo with T = 0. Its effect remains in part, because the
     * weight has a kink. */
    double of_turn;
    /* for a table whose modes l = 0 cannot be continued. Chosen: the error of the tail is as large as the tail. */
    double unknown;
} factors = {.echo_low = 0.7,
             .half_echo_low = 0.4,
             .of_echo = 1.6,
             .of_half_echo = 2,
             .of_density = 0.6,
             .of_fifth = 2000,
             .of_turn = 60,
             .unknown = 1};

/* Relative error of the sums themselves */
#define ROUNDING 1e-11
/* Bounds on the largest n of the modes l = 0 to which the power series in 1/n are fitted. A table with a larger n would
 * have 10^12 modes. */
enum { FIT_FROM = 12, FIT_TO = 1000000 };

/* Returns the mean of (2 I)^2 at line i over its phase. */
static double mean_response(const struct cor_lines *line, int i)
{
    return 2 * (line->re[i] * line->re[i] + line->im[i] * line->im[i]) + 4 * line->other[i] * line->other[i];
}

/* One half of the symmetric Gauss-Legendre rule with 12 points on [0, 1]; DLMF 3.5(v) */
enum { HALF_POINTS = 6 };
static const double gauss_x[HALF_POINTS] = {0.125233408511468916, 0.367831498998180194, 0.587317954286617448,
                                            0.769902674194304687, 0.904117256370474857, 0.981560634246719251};
static const double gauss_w[HALF_POINTS] = {0.249147045813402785, 0.233492536538354809, 0.203167426723065922,
                                            0.160078328543346226, 0.106939325995318431, 0.0471753363865118272};

/* ---- the modes of the table ---- */

static void chunk_clear(struct cor_mode_chunk *chunk)
{
    memset(&chunk->weights, 0, sizeof chunk->weights);
    for (int i = 0; i < COR_LINES; i++)
        chunk->omega[i] = 1;
}

void cor_rayleigh_weigh_modes(struct cor_rayleigh_table *table, size_t i, size_t to, struct cor_mode_chunk *chunk)
{
    const struct cor_disk_mode *const mode = table->modes->mode + i;
    chunk_clear(chunk);
    chunk->count = to - i < COR_LINES ? (int)(to - i) : COR_LINES;
    double through[COR_LINES] = {0}, beyond[COR_LINES] = {0};
    for (int j = 0; j < chunk->count; j++) {
        chunk->omega[j] = mode[j].omega;
        chunk->weights.strength[j] = mode[j].c * mode[j].c;
        /* surface waves, l = 0 and n > 1, are continued one by one */
        beyond[j] = mode[j].l != 0 || mode[j].n <= 1;
        through[j] = mode[j].l != 0;
    }
    table->set->weigh(&table->fading, chunk->omega, beyond, through, &chunk->weights, &table->low_strength,
                      &table->high_strength);
}

void cor_rayleigh_add(const struct cor_spectrum *spectrum, const struct cor_mode_chunk *chunk,
                      struct cor_mode_sums *sums, double *mode_fraction)
{
    struct cor_lines lines;
    double fraction[COR_LINES];
    cor_spectrum_lines(spectrum, chunk->count, chunk->omega, &lines);
    spectrum->set->sum(&lines, &chunk->weights, sums, fraction);
    if (mode_fraction)
        memcpy(mode_fraction, fraction, (size_t)chunk->count * sizeof *mode_fraction);
}

/* ---- the modes l = 0 beyond the table ---- */

/* Returns the speed of surface waves: xi = (c/c_S)^2, xi^3 - 8 xi^2 + (24 - 16 k) xi - 16 (1 - k) = 0, k = (c_S/c_P)^2.
 * The polynomial increases in (0, 1) and has one root there. */
static double surface_speed(double nu)
{
    const double k = 0.5 * (1 - nu);
    double low = 0, high = 1;
    for (double xi; cor_halve(&xi, low, high);)
        *(((xi - 8) * xi + 24 - 16 * k) * xi - 16 * (1 - k) < 0 ? &low : &high) = xi;
    return sqrt(0.5 * (low + high) / (2 * (1 + nu)));
}

static void divide_differences(const double *node, double *value)
{
    for (int order = 1; order < COR_SURFACE_FITTED; order++)
        for (int k = COR_SURFACE_FITTED - 1; k >= order; k--)
            value[k] = (value[k] - value[k - 1]) / (node[k] - node[k - order]);
}

/* Fits omega - speed n and C^2/omega in powers of 1/n. */
static void surface_init(struct cor_surface_modes *surface, const struct cor_rayleigh_set *set,
                         const struct cor_disk_modes *modes, size_t n_modes)
{
    struct cor_surface_fit *const fit = &surface->fit;
    int last = 0, wanted[COR_SURFACE_FITTED], found = 0;
    for (size_t i = 0; i < n_modes; i++)
        if (modes->mode[i].l == 0 && modes->mode[i].n > last && modes->mode[i].n <= FIT_TO)
            last = modes->mode[i].n;
    surface->known = surface->n = 0;
    surface->highest = modes->mode[n_modes - 1].omega;
    if (last < FIT_FROM)
        return;
    fit->speed = surface_speed(modes->nu);
    for (int k = 0; k < COR_SURFACE_FITTED; k++)
        wanted[k] = last - (last * k) / 8; /* from the last n down to half of it */
    for (size_t i = 0; i < n_modes; i++)
        for (int k = 0; k < COR_SURFACE_FITTED && modes->mode[i].l == 0; k++)
            if (modes->mode[i].n == wanted[k]) {
                const struct cor_disk_mode *mode = &modes->mode[i];
                fit->node[k] = 1.0 / mode->n;
                fit->omega[k] = mode->omega - fit->speed * mode->n;
                fit->strength[k] = mode->c * mode->c / mode->omega;
                found++;
            }
    if (found != COR_SURFACE_FITTED)
        return;
    divide_differences(fit->node, fit->omega);
    divide_differences(fit->node, fit->strength);
    /* accepts the fit if its next mode follows the table closely, at about the surface speed */
    double omega[COR_LINES], strength[COR_LINES];
    set->surface(fit, last + 1, omega, strength);
    if (omega[0] > surface->highest && omega[0] < surface->highest + 2 && omega[0] < 1.5 * fit->speed * last)
        surface->known = surface->n = last;
}

void cor_rayleigh_table_init(struct cor_rayleigh_table *table, const struct cor_rayleigh_set *set,
                             const struct cor_disk_modes *modes, size_t n_modes)
{
    const double to = modes->mode[n_modes - 1].omega;
    table->set = set;
    table->modes = modes;
    table->n_modes = n_modes;
    table->fading.to = to;
    table->fading.mean_from = fmax(FADE_FROM * to, COR_RAYLEIGH_LEAST_OMEGA - 0.1);
    table->fading.echo_from = fmax(ECHO_FROM * to, COR_RAYLEIGH_LEAST_OMEGA - 0.1);
    for (int end = 0; end < 2; end++) {
        table->fading.low[end] = low_window[end] * to;
        table->fading.high[end] = high_window[end] * to;
    }
    table->low_strength = table->high_strength = 0;
    surface_init(&table->surface, set, modes, n_modes);
}

int cor_surface_modes_next(struct cor_surface_modes *surface, const struct cor_rayleigh_set *set,
                           struct cor_mode_chunk *chunk)
{
    const double end = COR_RAYLEIGH_FAR * surface->highest;
    double omega[COR_LINES], strength[COR_LINES];
    if (surface->known == 0)
        return 0;
    /* ends when the last frequency of the previous chunk has reached `end` */
    set->surface(&surface->fit, surface->n, omega, strength);
    if (surface->n > surface->known && !(omega[0] < end))
        return 0;
    set->surface(&surface->fit, surface->n + 1, omega, strength);
    chunk_clear(chunk);
    chunk->count = 0;
    while (chunk->count < COR_LINES && (chunk->count == 0 || chunk->omega[chunk->count - 1] < end)) {
        if (!(omega[chunk->count] > surface->highest)) /* the table does not belong to a disk */
            return 0;
        chunk->omega[chunk->count] = surface->omega = omega[chunk->count];
        chunk->weights.echo[chunk->count] = surface->echo = strength[chunk->count];
        chunk->count++;
    }
    surface->n += chunk->count;
    return 1;
}

/* Returns the sum over the surface modes beyond mode n, the last that was computed. Mode k has the term (n/k)^3, and
 * the phase advances by the same angle from mode to mode. The sum is about n/(2 - i n z) - 1/2, where z is 2 tan of
 * half the angle. This formula is exact in the limits of small and large n z, and a few percent off in between. */
static double surface_rest(const struct cor_spectrum *spectrum, const struct cor_surface_modes *surface)
{
    struct cor_lines lines;
    double omega[COR_LINES], strength[COR_LINES];
    const int n = surface->n;
    spectrum->set->surface(&surface->fit, n + 1, omega, strength);
    cor_spectrum_lines(spectrum, 1, &surface->omega, &lines);
    const double c = lines.cosine[0] * lines.re[0] - lines.sine[0] * lines.im[0];
    const double s = lines.cosine[0] * lines.im[0] + lines.sine[0] * lines.re[0];
    const double term = surface->echo * 2 * (c * c - s * s), quadrature = surface->echo * 4 * c * s;
    const double z = 2 * tan(spectrum->half_time * (omega[0] - surface->omega));
    const double size = 4 + (n * z) * (n * z);
    return term * (2 * n / size - 0.5) - quadrature * (n * (n * z) / size);
}

/* ---- the modes beyond the table ---- */

/* Integrals over omega with the weight of the cutoff. mean: of 2 omega mean_response. curvature: of mean_response.
 * half: of 2 omega times the amplitude of the part of the response that oscillates with omega tau/2 */
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
        const double weight =
            0.5 * (high - low) * w * cor_rayleigh_fade((omega[i] - fade_from) / (fade_to - fade_from));
        const double mean = mean_response(&lines, i);
        sum->mean += weight * 2 * omega[i] * mean;
        sum->curvature += weight * mean;
        sum->half +=
            weight * 16 * omega[i] * fabs(lines.other[i]) * sqrt(lines.re[i] * lines.re[i] + lines.im[i] * lines.im[i]);
    }
}

static struct integrals tail_integrate(const struct cor_spectrum *spectrum, double from, double to)
{
    struct integrals sum = {0, 0, 0};
    add_panel(&sum, spectrum, from, to, from, to);
    for (double omega = to; omega < 0.99 * COR_RAYLEIGH_FAR * to; omega *= 2)
        add_panel(&sum, spectrum, omega, 2 * omega, from, to);
    /* Beyond the last panel the mean response is g/omega^4, where 1/sqrt(g) varies like ln(omega). With r =
     * dln(g)/dln(omega)/2, the integral of 2 g omega^-3 is g (1 + r + 3/2 r^2 + ...)/omega^2. */
    const double ends[2] = {0.5 * COR_RAYLEIGH_FAR * to, COR_RAYLEIGH_FAR * to}, end = ends[1];
    struct cor_lines lines;
    cor_spectrum_lines(spectrum, 2, ends, &lines);
    const double g = mean_response(&lines, 1), r = 0.5 * log(16 * g / mean_response(&lines, 0)) / COR_LN2;
    sum.mean += end * end * g * (1 + r * (1 + 1.5 * r));
    return sum;
}

/* Returns the integral of the weight in a window, which is 4^4 4! 4!/9! times the width of the window. */
static double bump_integral(const double window[2])
{
    return (window[1] - window[0]) * (256 * 576 / 362880.0);
}

static double bump_density(const double window[2])
{
    return bump_integral(window) * (window[1] + window[0]);
}

/* Returns the strength of an echo, from its two components in a window. */
static double echo_of(const double sums[2], const double window[2])
{
    return sqrt(sums[0] * sums[0] + sums[1] * sums[1]) / bump_density(window);
}

void cor_rayleigh_finish(struct cor_disk_rayleigh *out, const struct cor_rayleigh_table *table,
                         const struct cor_spectrum *spectrum, const struct cor_mode_sums *sums, double surface_sum)
{
    const struct cor_surface_modes *const surface = &table->surface;
    const struct cor_fading *const fading = &table->fading;
    const double *const low = fading->low, *const high = fading->high;
    const struct integrals integrals = tail_integrate(spectrum, fading->mean_from, fading->to);
    const double more = table->low_strength - bump_density(low) + table->high_strength - bump_density(high);
    const double curvature = surface->known ? more / (bump_integral(low) + bump_integral(high)) : 0;
    if (surface->known)
        surface_sum += surface_rest(spectrum, surface);
    const double tail = integrals.mean + curvature * integrals.curvature - sums->faded + surface_sum;
    out->tail = sums->fraction - out->fraction + tail;

    const double echo = echo_of(sums->high, high) + factors.echo_low * echo_of(sums->low, low);
    const double half_echo = echo_of(sums->high + 2, high) + factors.half_echo_low * echo_of(sums->low + 2, low);
    const double square = fading->to * fading->to, turned = 2 * spectrum->half_time * fading->to;
    const double known = factors.of_density / square + factors.of_fifth / (square * square * fading->to) +
                         factors.of_turn / (turned * turned);
    const double rest = surface->known ? known : factors.unknown;
    out->error_estimate = (factors.of_echo * echo + rest) * integrals.mean +
                          (factors.of_half_echo * half_echo + rest) * integrals.half +
                          ROUNDING * (sums->fraction + fabs(tail));
}
