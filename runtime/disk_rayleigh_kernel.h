/* SPDX-License-Identifier: MIT */
/* The loops of Rayleigh's energy over nodes and over modes, free of calls, so that compilers vectorise them. Sums go
 * into eight parts, whatever the width of a vector, so that all instruction sets give the same bits. */
#ifndef COR_RUNTIME_DISK_RAYLEIGH_KERNEL_H
#define COR_RUNTIME_DISK_RAYLEIGH_KERNEL_H

#include <stdint.h>
#include <string.h>

#include "disk_rayleigh_spectrum.h"

/* x + 1.5 2^52 - 1.5 2^52 is x rounded to an integer, |x| < 2^51. */
#define ROUND_TO_INTEGER 6755399441055744.0

struct pair_of_numbers {
    double sine, cosine;
};

/* |x| < 2^20: pi/2 in three parts of 33 bits, so that k times the first two is exact; then Taylor's series as far as
 * 2^-55 at pi/4. Error below 2^-52 + 2^-53 |x|, absolute. */
static inline struct pair_of_numbers kernel_sincos(double x)
{
    const double k = (x * 0.63661977236758134 + ROUND_TO_INTEGER) - ROUND_TO_INTEGER;
    const double r = ((x - k * 0x1.921fb544p+0) - k * 0x1.0b4611a6p-34) - k * 0x1.3198a2e037073p-69;
    const double z = r * r;
    const double s =
        r + r * z *
                (-1.0 / 6 +
                 z * (1.0 / 120 + z * (-1.0 / 5040 +
                                       z * (1.0 / 362880 + z * (-1.0 / 39916800 + z * (1.0 / 6227020800 +
                                                                                       z * (-1.0 / 1307674368000)))))));
    const double c =
        1 - z * (0.5 - z * (1.0 / 24 -
                            z * (1.0 / 720 -
                                 z * (1.0 / 40320 - z * (1.0 / 3628800 -
                                                         z * (1.0 / 479001600 - z * (1.0 / 87178291200 -
                                                                                     z * (1.0 / 20922789888000))))))));
    /* the quadrant, -2 to 2 */
    const double m = k - 4 * ((0.25 * k + ROUND_TO_INTEGER) - ROUND_TO_INTEGER);
    const int odd = m * m == 1, sine_turns = (m == 2) | (m == -2) | (m == -1),
              cosine_turns = (m == 2) | (m == -2) | (m == 1);
    struct pair_of_numbers result = {odd ? c : s, odd ? s : c};
    result.sine = sine_turns ? -result.sine : result.sine;
    result.cosine = cosine_turns ? -result.cosine : result.cosine;
    return result;
}

/* exp(-x), x >= 0; 0 beyond 700. Taylor's series on |r| <= ln(2)/2 as far as 2^-55. */
static inline double kernel_exp(double x)
{
    const double y = x < 700 ? -x : -700;
    const double shifted = y * 1.4426950408889634 + ROUND_TO_INTEGER, k = shifted - ROUND_TO_INTEGER;
    const double r = (y - k * 0x1.62e42feep-1) - k * 0x1.a39ef35793c76p-33;
    const double p =
        1.0 / 5040 +
        r * (1.0 / 40320 +
             r * (1.0 / 362880 +
                  r * (1.0 / 3628800 + r * (1.0 / 39916800 + r * (1.0 / 479001600 + r * (1.0 / 6227020800))))));
    const double e =
        1 + (r + r * r * (0.5 + r * (1.0 / 6 + r * (1.0 / 24 + r * (1.0 / 120 + r * (1.0 / 720 + r * p))))));
    uint64_t bits;
    double scale;
    memcpy(&bits, &shifted, sizeof bits);
    bits = (bits + 1023) << 52; /* the integer is in the last bits */
    memcpy(&scale, &bits, sizeof scale);
    return x < 700 ? e * scale : 0;
}

static inline double kernel_total(const double part[COR_LEG_PART])
{
    return ((part[0] + part[4]) + (part[2] + part[6])) + ((part[1] + part[5]) + (part[3] + part[7]));
}

/* exp(-omega p) */
static inline void kernel_exponentials(int n, const double *restrict p_re, const double *restrict p_im, double omega,
                                       double *restrict e_re, double *restrict e_im)
{
    for (int i = 0; i < n; i++) {
        const double size = kernel_exp(omega * p_re[i]);
        const struct pair_of_numbers turn = kernel_sincos(omega * p_im[i]);
        e_re[i] = size * turn.cosine;
        e_im[i] = -size * turn.sine;
    }
}

/* sum of w e, and e squared in place; n is a multiple of COR_LEG_PART */
static inline void kernel_sum_and_square(int n, const double *restrict w_re, const double *restrict w_im,
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

/* Twice the frequency is the square of the exponential. */
static inline void kernel_octaves(const struct cor_leg *leg, double first, int octaves, double re[][COR_SPECTRUM_TERMS],
                                  double im[][COR_SPECTRUM_TERMS])
{
    /* cos(pi k/32), down to 0; tanh(ln(2)/4) */
    static const double quarter[COR_SPECTRUM_TERMS + 1] = {1,
                                                           0.995184726672196886,
                                                           0.980785280403230449,
                                                           0.956940335732208865,
                                                           0.923879532511286756,
                                                           0.88192126434835503,
                                                           0.831469612302545237,
                                                           0.773010453362736961,
                                                           0.707106781186547524,
                                                           0.634393284163645498,
                                                           0.555570233019602225,
                                                           0.471396736825997649,
                                                           0.382683432365089772,
                                                           0.290284677254462368,
                                                           0.195090322016128268,
                                                           0.098017140329560602,
                                                           0};
    const double half_width = 3 - 2 * 1.4142135623730951;
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
        double omega = first * 1.4142135623730951 * (1 + x) / (1 - x);
        int n = leg->n;
        kernel_exponentials(n, leg->p_re, leg->p_im, omega, e_re, e_im);
        for (int octave = 0; octave < octaves; octave++, omega *= 2) {
            double sum_re, sum_im;
            while (n > COR_LEG_PART && omega * leg->p_re[n - COR_LEG_PART] > 60) /* 2^-86 */
                n -= COR_LEG_PART;
            kernel_sum_and_square(n, leg->w_re, leg->w_im, e_re, e_im, &sum_re, &sum_im);
            const double factor = omega * omega / COR_SPECTRUM_TERMS;
            for (int k = 0; k < COR_SPECTRUM_TERMS; k++) {
                const double c = (k == 0 ? factor : 2 * factor) * cosine[k];
                re[octave][k] += c * sum_re;
                im[octave][k] += c * sum_im;
            }
        }
    }
}

/* Clenshaw's recurrence for lines of one octave, which begins at `start` */
static inline void kernel_lines(const struct cor_spectrum *spectrum, int octave, double start, int n,
                                const double *restrict omega, struct cor_lines *restrict lines)
{
    const double middle = 1.4142135623730951 * start, scale = 3 + 2 * 1.4142135623730951;
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
        const struct pair_of_numbers turn = kernel_sincos(omega[i] * spectrum->half_time);
        lines->re[i] = (x * r1 - r2 + c_re[0]) * inverse;
        lines->im[i] = (x * m1 - m2 + c_im[0]) * inverse;
        lines->cosine[i] = turn.cosine;
        lines->sine[i] = turn.sine;
        lines->other[i] = 0;
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
        lines->other[i] = (x * b1 - b2 + c[0]) * inverse * kernel_exp(omega[i] * spectrum->decay);
    }
}

#define RAYLEIGH(set)                                                                                                  \
    void cor_rayleigh_octaves_##set(const struct cor_leg *leg, double first, int octaves,                              \
                                    double re[][COR_SPECTRUM_TERMS], double im[][COR_SPECTRUM_TERMS])                  \
    {                                                                                                                  \
        kernel_octaves(leg, first, octaves, re, im);                                                                   \
    }                                                                                                                  \
    void cor_rayleigh_lines_##set(const struct cor_spectrum *spectrum, int octave, double start, int n,                \
                                  const double *omega, struct cor_lines *lines)                                        \
    {                                                                                                                  \
        kernel_lines(spectrum, octave, start, n, omega, lines);                                                        \
    }

#endif
