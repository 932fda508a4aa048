/* SPDX-License-Identifier: MIT */
/* The loops of Rayleigh's energy over nodes and over modes, for one instruction set (sets.h), free of calls;
 * gcc 12 vectorises all of them, in the portable set too (-fopt-info-vec). No set may fuse a multiplication with an
 * addition, and sums have sixteen parts for every width of a vector. All sets therefore give the same bits. */
#include "runtime/disk/rayleigh_parts.h"
#include "runtime/disk/rayleigh_path.h"
#include "runtime/number/kernel_vector.h"

/* ---- one panel of a leg ---- */

enum { LANES = 16 };

/* Returns n, rounded up to whole vectors. */
COR_KERNEL int vectors_of(int n)
{
    return (n + VECTOR - 1) & -VECTOR;
}

SHARED void set_decays(double *restrict rho, const double *restrict u)
{
    for (int i = 0; i < LANES; i++)
        rho[i] = kernel_decay(u[i]);
}

/* The nodes of Gauss's rule in a panel, padded. step: dh, then dp. power, move: arguments of kernel_halley */
struct gauss_nodes {
    double step_re[LANES], step_im[LANES], t_re[LANES], t_im[LANES], power_re[LANES], power_im[LANES], move[LANES];
};

COR_KERNEL void nodes_at(struct gauss_nodes *restrict node, const struct cor_leg_path *path, int from_zero,
                         const double *restrict rho, double panel)
{
    for (int i = 0; i < LANES; i++) {
        const struct path_point point = kernel_path(path, from_zero, rho[i]);
        const struct cx step = cx_scaled(0.5 * panel * rho[i], cx_of(-point.slope.im, point.slope.re));
        const struct cx t = kernel_guess(path, &point, &node->move[i]);
        const struct cx power = cx_over(cx_of(1, 0), cx_times(point.sine, point.sine));
        node->step_re[i] = step.re;
        node->step_im[i] = step.im;
        node->t_re[i] = t.re;
        node->t_im[i] = t.im;
        node->power_re[i] = power.re;
        node->power_im[i] = power.im;
    }
}

SHARED void nodes_begin(struct gauss_nodes *restrict node, const struct cor_leg_path *path, const double *restrict rho,
                        double panel)
{
    if (path->from_zero)
        nodes_at(node, path, 1, rho, panel);
    else
        nodes_at(node, path, 0, rho, panel);
}

SHARED void nodes_solve(struct gauss_nodes *node, double q0, int steps)
{
    for (int k = 0; k < steps; k++)
        for (int i = 0; i < LANES; i++) {
            const struct cx t = kernel_halley(q0, cx_of(node->power_re[i], node->power_im[i]), node->move[i],
                                              cx_of(node->t_re[i], node->t_im[i]));
            node->t_re[i] = t.re;
            node->t_im[i] = t.im;
        }
}

/* Computes t at points of a path. */
static void solve_nodes(struct gauss_nodes *node, const struct cor_leg_path *path, const double *rho, double panel)
{
    nodes_begin(node, path, rho, panel);
    nodes_solve(node, path->q0, path->from_zero ? STEPS_FROM_ZERO : STEPS_FROM_OTHER);
}

static void set_start(const struct cor_leg_path *path, double nearest, double t[2])
{
    struct gauss_nodes node;
    double rho[LANES];
    for (int i = 0; i < LANES; i++)
        rho[i] = nearest;
    solve_nodes(&node, path, rho, 1);
    t[0] = node.t_re[0];
    t[1] = node.t_im[0];
}

/* Multiplies step = dh by sqrt(y/2), which gives dp of a node without the weight of the rule. */
SHARED void nodes_integrate(struct gauss_nodes *node)
{
    for (int i = 0; i < LANES; i++) {
        const struct cx half = cx_of(0.5 * (1 + node->t_re[i]), 0.5 * node->t_im[i]);
        const struct cx step = cx_times(cx_of(node->step_re[i], node->step_im[i]), cx_root(half));
        node->step_re[i] = step.re;
        node->step_im[i] = step.im;
    }
}

/* Adds p at LANES points, from the integrals of the rule. */
SHARED void leg_add_p(struct cor_leg *restrict leg, const double (*row)[LANES], const struct gauss_nodes *node)
{
    for (int k = 0; k < LANES; k += VECTOR) {
        vector re = fill_vector(leg->end_re), im = fill_vector(leg->end_im);
        for (int i = 0; i < COR_LEG_GAUSS; i++) {
            const vector factor = load_vector(row[i] + k);
            re += factor * fill_vector(node->step_re[i]);
            im += factor * fill_vector(node->step_im[i]);
        }
        store_vector(leg->p_re + leg->n + k, re);
        store_vector(leg->p_im + leg->n + k, im);
    }
}

COR_KERNEL void weights_at(double *restrict w_re, double *restrict w_im, const struct cor_leg_path *path, int from_zero,
                           const double *restrict rho, int n)
{
    for (int k = 0; k < n; k++) {
        const struct path_point point = kernel_path(path, from_zero, rho[k]);
        const struct cx w = cx_times(point.slope, cx_scaled(COR_LEG_STEP * rho[k] * path->scale, point.sine));
        w_re[k] = w.re;
        w_im[k] = w.im;
    }
}

SHARED void leg_add_weights(struct cor_leg *restrict leg, const struct cor_leg_path *path, int steps, double top)
{
    double u[LANES], rho[LANES];
    double *const w_re = leg->w_re + leg->n, *const w_im = leg->w_im + leg->n;
    for (int k = 0; k < LANES; k++)
        u[k] = top - k * COR_LEG_STEP;
    set_decays(rho, u);
    if (path->from_zero)
        weights_at(w_re, w_im, path, 1, rho, vectors_of(steps));
    else
        weights_at(w_re, w_im, path, 0, rho, vectors_of(steps));
}

/* Computes a panel of a leg: p and weights at `steps` nodes, and p at the end. */
static void add_panel(const struct cor_leg_path *path, const struct cor_leg_rule *rule, int steps, double top,
                      struct cor_leg *leg)
{
    struct gauss_nodes node;
    double u[LANES], rho[LANES];
    const double width = steps * COR_LEG_STEP;
    for (int i = 0; i < LANES; i++)
        u[i] = top - 0.5 * width * (1 - rule->x[i]);
    set_decays(rho, u);
    solve_nodes(&node, path, rho, width);
    nodes_integrate(&node);
    leg_add_p(leg, steps == COR_LEG_STEPS ? rule->to_steps : rule->to_short, &node);
    leg_add_weights(leg, path, steps, top);
    for (int i = 0; i < COR_LEG_GAUSS; i++) {
        leg->end_re += rule->w[i] * node.step_re[i];
        leg->end_im += rule->w[i] * node.step_im[i];
    }
    leg->n += steps;
}

/* ---- sums ---- */

COR_KERNEL double kernel_total(const double part[COR_LEG_PART])
{
    double total = 0;
    for (int l = 0; l < COR_LEG_PART; l++)
        total += part[l];
    return total;
}

/* Sets e = exp(-omega p). */
COR_KERNEL void kernel_exponentials(int n, const double *restrict p_re, const double *restrict p_im, double omega,
                                    double *restrict e_re, double *restrict e_im)
{
    for (int i = 0; i < (n & -COR_LEG_PART); i++) {
        const double size = kernel_decay(omega * p_re[i]);
        const struct sine_cosine turn = kernel_sincos(omega * p_im[i]);
        e_re[i] = size * turn.cosine;
        e_im[i] = -size * turn.sine;
    }
}

/* Returns the sum of w e, and squares e in place. n is a multiple of COR_LEG_PART. */
COR_KERNEL void kernel_sum_and_square(int n, const double *restrict w_re, const double *restrict w_im,
                                      double *restrict e_re, double *restrict e_im, double *restrict sum_re,
                                      double *restrict sum_im)
{
    double re[COR_LEG_PART] = {0}, im[COR_LEG_PART] = {0};
    for (int i = 0; i < n; i += COR_LEG_PART)
        for (int l = 0; l < COR_LEG_PART; l++) {
            const double r = e_re[i + l], m = e_im[i + l];
            re[l] += w_re[i + l] * r - w_im[i + l] * m;
            im[l] += w_re[i + l] * m + w_im[i + l] * r;
            e_re[i + l] = r * r - m * m;
            e_im[i + l] = 2 * r * m;
        }
    *sum_re = kernel_total(re);
    *sum_im = kernel_total(im);
}

/* Computes the octaves one after the other. Doubling the frequency squares the exponential. */
static void kernel_octaves(const struct cor_leg *leg, double first, int octaves, double re[][COR_SPECTRUM_TERMS],
                           double im[][COR_SPECTRUM_TERMS])
{
    /* quarter: cos(pi k/32), down to 0. half_width: tanh(ln(2)/4) */
    static const double quarter[COR_SPECTRUM_TERMS + 1] = {
        1.000000000000000000, 0.995184726672196886, 0.980785280403230449, 0.956940335732208865, 0.923879532511286756,
        0.88192126434835503,  0.831469612302545237, 0.773010453362736961, 0.707106781186547524, 0.634393284163645498,
        0.555570233019602225, 0.471396736825997649, 0.382683432365089772, 0.290284677254462368, 0.195090322016128268,
        0.098017140329560602, 0.000000000000000000};
    const double half_width = 3 - 2 * COR_ROOT_2;
    double e_re[COR_LEG_NODES], e_im[COR_LEG_NODES];
    for (int k = 0; k < octaves; k++)
        for (int j = 0; j < COR_SPECTRUM_TERMS; j++)
            re[k][j] = im[k][j] = 0;
    for (int j = 0; j < COR_SPECTRUM_TERMS; j++) {
        double cosine[COR_SPECTRUM_TERMS]; /* cos(pi k (j + 1/2)/TERMS) */
        for (int k = 0; k < COR_SPECTRUM_TERMS; k++) {
            const int turn = k * (2 * j + 1) % (4 * COR_SPECTRUM_TERMS), half = 2 * COR_SPECTRUM_TERMS,
                      up = turn < half ? turn : 2 * half - turn;
            cosine[k] = up <= half / 2 ? quarter[up] : -quarter[half - up];
        }
        const double x = half_width * cosine[1];
        double omega = first * COR_ROOT_2 * (1 + x) / (1 - x);
        int n = leg->n;
        kernel_exponentials(n, leg->p_re, leg->p_im, omega, e_re, e_im);
        for (int octave = 0; octave < octaves; octave++, omega *= 2) {
            double sum_re, sum_im;
            while (n > COR_LEG_PART && omega * leg->p_re[n - COR_LEG_PART] > 60) /* 2^-86 */
                n -= COR_LEG_PART;
            kernel_sum_and_square(n, leg->w_re, leg->w_im, e_re, e_im, &sum_re, &sum_im);
            const double factor = omega * omega / (double)COR_SPECTRUM_TERMS;
            for (int k = 0; k < COR_SPECTRUM_TERMS; k++) {
                const double c = (k == 0 ? factor : 2 * factor) * cosine[k];
                re[octave][k] += c * sum_re;
                im[octave][k] += c * sum_im;
            }
        }
    }
}

/* Uses Clenshaw's recurrence. */
static void kernel_lines(const struct cor_spectrum *spectrum, int octave, double start, int from, int to,
                         const double *restrict frequency, struct cor_lines *restrict lines)
{
    const int n = vectors_of(to - from);
    const double *const omega = frequency + from;
    const double middle = COR_ROOT_2 * start, scale = 3 + 2 * COR_ROOT_2;
    const double *const c_re = spectrum->a_re[octave], *const c_im = spectrum->a_im[octave];
    for (int i = 0; i < n; i++) {
        const double x = scale * (omega[i] - middle) / (omega[i] + middle), inverse = 1 / (omega[i] * omega[i]);
        double r1 = c_re[COR_SPECTRUM_TERMS - 1], r2 = 0, m1 = c_im[COR_SPECTRUM_TERMS - 1], m2 = 0;
        for (int k = COR_SPECTRUM_TERMS - 2; k > 0; k--) {
            const double r = 2 * x * r1 - r2 + c_re[k], m = 2 * x * m1 - m2 + c_im[k];
            r2 = r1;
            r1 = r;
            m2 = m1;
            m1 = m;
        }
        const struct sine_cosine turn = kernel_sincos(omega[i] * spectrum->half_time);
        lines->re[from + i] = (x * r1 - r2 + c_re[0]) * inverse;
        lines->im[from + i] = (x * m1 - m2 + c_im[0]) * inverse;
        lines->cosine[from + i] = turn.cosine;
        lines->sine[from + i] = turn.sine;
        lines->other[from + i] = 0;
    }
    if (octave >= spectrum->edges)
        return;
    const double *const c = spectrum->b[octave];
    for (int i = 0; i < n; i++) {
        const double x = scale * (omega[i] - middle) / (omega[i] + middle), inverse = 1 / (omega[i] * omega[i]);
        double b1 = c[COR_SPECTRUM_TERMS - 1], b2 = 0;
        for (int k = COR_SPECTRUM_TERMS - 2; k > 0; k--) {
            const double b = 2 * x * b1 - b2 + c[k];
            b2 = b1;
            b1 = b;
        }
        lines->other[from + i] = (x * b1 - b2 + c[0]) * inverse * kernel_decay(omega[i] * spectrum->decay);
    }
}

/* ---- sums over modes ---- */

/* Returns r(x), x = (omega/omega_max - 0.15)/0.85; r(0) = 0, r(1) = 1. Beyond omega_max r is 1. An echo at
 * T = tau + dT then contributes to the sum
 *
 *     F(u) = int r z^(-3 - 1/2) exp(i u z) dz,     z = omega/omega_max, u = omega_max dT,
 *
 * times a factor that is the same for all r. max |F| = |F(0)| = 0.290, and |F| < 0.09 for u >= 15, 0.03 for u >= 30. A
 * cutoff from 0.65 without a negative part has max |F| = 0.66. max |F| is at least about 0.18 for any weight: the norm
 * of the Hankel operator (1 + x + y)^(-7/2). For weights near this bound |F| decreases more slowly. */
COR_KERNEL double kernel_echo_weight(double x)
{
    const double y = x < 0 ? 0 : x, square = y * y;
    return square * square * y * (5 + y * (16 * y - 20));
}

COR_KERNEL double kernel_bump(double omega, const double window[2])
{
    const double x = (omega - window[0]) / (window[1] - window[0]), y = 4 * x * (1 - x), inside = y < 0 ? 0 : y;
    const double square = inside * inside;
    return square * square;
}

static void kernel_weigh(const struct cor_fading *fading, const double *restrict omega, const double *restrict beyond,
                         const double *restrict through, struct cor_mode_weights *restrict weights,
                         double *restrict low_strength, double *restrict high_strength)
{
    double all_low[COR_LINES], all_high[COR_LINES];
    for (int i = 0; i < COR_LINES; i++) {
        const double strength = weights->strength[i];
        weights->mean[i] =
            cor_rayleigh_fade((omega[i] - fading->mean_from) / (fading->to - fading->mean_from)) * strength;
        weights->echo[i] = kernel_echo_weight((omega[i] - fading->echo_from) / (fading->to - fading->echo_from)) *
                           strength * beyond[i];
        all_low[i] = kernel_bump(omega[i], fading->low) * strength;
        all_high[i] = kernel_bump(omega[i], fading->high) * strength;
        weights->low[i] = all_low[i] * through[i];
        weights->high[i] = all_high[i] * through[i];
    }
    for (int i = 0; i < COR_LINES; i++) {
        *low_strength += all_low[i];
        *high_strength += all_high[i];
    }
}

/* Returns sum x y, in COR_LEG_PART partial sums. */
SHARED double kernel_dot(const double *restrict x, const double *restrict y)
{
    double part[COR_LEG_PART] = {0};
    for (int i = 0; i < COR_LINES; i += COR_LEG_PART)
        for (int l = 0; l < COR_LEG_PART; l++)
            part[l] += x[i + l] * y[i + l];
    return kernel_total(part);
}

static void kernel_sum(const struct cor_lines *restrict lines, const struct cor_mode_weights *restrict weights,
                       struct cor_mode_sums *restrict sums, double *restrict fraction)
{
    double mean[COR_LINES], more[COR_LINES], cosine[COR_LINES], sine[COR_LINES];
    for (int i = 0; i < COR_LINES; i++) {
        const double re = lines->re[i], im = lines->im[i], other = lines->other[i];
        const double c = lines->cosine[i], s = lines->sine[i], x = 2 * (c * re - s * im + other);
        fraction[i] = weights->strength[i] * (x * x);
        mean[i] = 2 * (re * re + im * im) + 4 * other * other;
        more[i] = x * x - mean[i];
        cosine[i] = c * c - s * s;
        sine[i] = 2 * c * s;
    }
    for (int i = 0; i < COR_LINES; i++) /* gives the same bits as a sum over mode_fraction by a caller */
        sums->fraction += fraction[i];
    sums->faded += kernel_dot(weights->mean, mean) + kernel_dot(weights->echo, more);
    sums->low[0] += kernel_dot(weights->low, cosine);
    sums->low[1] += kernel_dot(weights->low, sine);
    sums->low[2] += kernel_dot(weights->low, lines->cosine);
    sums->low[3] += kernel_dot(weights->low, lines->sine);
    sums->high[0] += kernel_dot(weights->high, cosine);
    sums->high[1] += kernel_dot(weights->high, sine);
    sums->high[2] += kernel_dot(weights->high, lines->cosine);
    sums->high[3] += kernel_dot(weights->high, lines->sine);
}

/* Evaluates Newton's interpolation in 1/n. */
COR_KERNEL double kernel_newton(const struct cor_surface_fit *fit, const double *c, double x)
{
    double value = c[COR_SURFACE_FITTED - 1];
    for (int i = COR_SURFACE_FITTED - 2; i >= 0; i--)
        value = value * (x - fit->node[i]) + c[i];
    return value;
}

static void kernel_surface(const struct cor_surface_fit *fit, int n, double *restrict omega, double *restrict strength)
{
    for (int i = 0; i < COR_LINES; i++) {
        const double number = n + i, x = 1 / number;
        omega[i] = fit->speed * number + kernel_newton(fit, fit->omega, x);
        strength[i] = omega[i] * kernel_newton(fit, fit->strength, x);
    }
}

static void kernel_blend(int nodes, const double *weight, const double *const *in, int count, double *out)
{
    for (int i = 0; i < count; i += COR_LEG_PART)
        for (int l = 0; l < COR_LEG_PART; l += VECTOR) {
            vector sum = fill_vector(0);
            for (int k = 0; k < nodes; k++)
                sum += fill_vector(weight[k]) * load_vector(in[k] + i + l);
            store_vector(out + i + l, sum);
        }
}

const struct cor_rayleigh_set COR_OF_SET(cor_rayleigh) = {
    COR_SET_NAME, set_start,  add_panel,      kernel_octaves, kernel_lines,
    kernel_weigh, kernel_sum, kernel_surface, kernel_blend,
};
