/* SPDX-License-Identifier: MIT */
#include "phi_sums.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "disk.h"

#define PI 3.14159265358979323846

enum { WIDTH = 8 };
typedef double vector __attribute__((vector_size(WIDTH * sizeof(double))));

static vector vector_load(const double *from)
{
    vector x;
    memcpy(&x, from, sizeof x);
    return x;
}

static void vector_store(double *to, vector x)
{
    memcpy(to, &x, sizeof x);
}

void phi_sums_init(struct phi_sums *sums, size_t terms, size_t points)
{
    disk_must(terms % WIDTH == 0 && terms <= points && (points & (points - 1)) == 0, "no such sums");
    const double p = (double)points;
    *sums = (struct phi_sums){.terms = terms, .points = points};
    sums->two_cos = disk_memory(points, sizeof(double));
    sums->two_cos8 = disk_memory(points, sizeof(double));
    sums->first = disk_memory(2 * WIDTH * points, sizeof(double));
    sums->twiddle = disk_memory(2 * points, sizeof(double));
    sums->quarter = disk_memory(2 * (points + 1), sizeof(double));
    sums->half = disk_memory(2 * points, sizeof(double));
    sums->work = disk_memory(6 * points, sizeof(double));
    for (size_t j = 0; j < points; j++) {
        const double phi = ((double)j + 0.5) * PI / (2 * p);
        sums->two_cos[j] = 2 * cos(phi);
        sums->two_cos8[j] = 2 * cos(WIDTH * phi);
        for (size_t k = 0; k < 2 * WIDTH; k++)
            sums->first[j * 2 * WIDTH + k] = cos(((double)k - WIDTH) * phi);
    }
    double *at = sums->twiddle;
    for (size_t half = points / 2; half > 0; half /= 2) {
        for (size_t i = 0; i < half; i++) {
            at[i] = cos(PI * (double)i / (double)half);
            at[half + i] = -sin(PI * (double)i / (double)half);
        }
        at += 2 * half;
    }
    for (size_t k = 0; k <= points; k++) {
        sums->quarter[2 * k] = cos(PI * (double)k / (4 * p));
        sums->quarter[2 * k + 1] = sin(PI * (double)k / (4 * p));
    }
    for (size_t k = 0; k < points; k++) {
        sums->half[2 * k] = cos(PI * (double)k / p);
        sums->half[2 * k + 1] = sin(PI * (double)k / p);
    }
}

void phi_sums_free(struct phi_sums *sums)
{
    free(sums->two_cos);
    free(sums->two_cos8);
    free(sums->first);
    free(sums->twiddle);
    free(sums->quarter);
    free(sums->half);
    free(sums->work);
}

/* ---- recurrences ---- */

/* Clenshaw's, 32 angles at once */
void phi_sums_reach_recurrence(const struct phi_sums *sums, size_t window, const double *d, double *reach)
{
    for (size_t j = 0; j < window; j += 4 * WIDTH) {
        vector x[4], b[4], next[4];
        for (size_t i = 0; i < 4; i++) {
            x[i] = vector_load(sums->two_cos + j + i * WIDTH);
            b[i] = next[i] = x[i] - x[i];
        }
        for (size_t k = sums->terms - 1; k > 0; k--)
            for (size_t i = 0; i < 4; i++) {
                const vector now = x[i] * b[i] + (d[k] - next[i]);
                next[i] = b[i];
                b[i] = now;
            }
        for (size_t i = 0; i < 4; i++)
            vector_store(reach + j + i * WIDTH, 0.5 * x[i] * b[i] + (d[0] - next[i]));
    }
}

/* cos((k + 8) phi) = 2 cos(8 phi) cos(k phi) - cos((k - 8) phi), 8 terms at once of 8 angles */
void phi_sums_transform_recurrence(const struct phi_sums *sums, size_t window, const double *pressure, double *e)
{
    enum { ANGLES = 8 };
    memset(e, 0, sums->terms * sizeof *e);
    for (size_t j = 0; j < window; j += ANGLES) {
        vector now[ANGLES], before[ANGLES];
        double x[ANGLES];
        for (size_t i = 0; i < ANGLES; i++) {
            before[i] = pressure[j + i] * vector_load(sums->first + (j + i) * 2 * WIDTH);
            now[i] = pressure[j + i] * vector_load(sums->first + (j + i) * 2 * WIDTH + WIDTH);
            x[i] = sums->two_cos8[j + i];
        }
        for (size_t k = 0; k < sums->terms; k += WIDTH) {
            vector sum = vector_load(e + k);
            for (size_t i = 0; i < ANGLES; i++) {
                const vector next = x[i] * now[i] - before[i];
                sum += now[i];
                before[i] = now[i];
                now[i] = next;
            }
            vector_store(e + k, sum);
        }
    }
}

/* ---- transforms ---- */

/* sum_k z_k exp(-2 pi i k n/size), radix 2, sorting itself (Stockham): from re, im to where it returns, one of the two
 * pairs. */
static double *transform(const struct phi_sums *sums, double *from, double *to)
{
    const size_t size = sums->points;
    const double *twiddle = sums->twiddle;
    size_t stride = 1;
    for (size_t half = size / 2; half > 0; half /= 2, stride *= 2) {
        const double *restrict const re = from, *restrict const im = from + size;
        double *restrict const re_to = to, *restrict const im_to = to + size;
        for (size_t p = 0; p < half; p++) {
            const double c = twiddle[p], s = twiddle[half + p];
            const size_t a = stride * p, b = stride * (p + half), out = 2 * stride * p;
            for (size_t q = 0; q < stride; q++) {
                const double x = re[a + q] - re[b + q], y = im[a + q] - im[b + q];
                re_to[out + q] = re[a + q] + re[b + q];
                im_to[out + q] = im[a + q] + im[b + q];
                re_to[out + stride + q] = x * c - y * s;
                im_to[out + stride + q] = x * s + y * c;
            }
        }
        twiddle += 2 * half;
        double *const swap = from;
        from = to;
        to = swap;
    }
    return from;
}

/* Makhoul, IEEE Trans. ASSP 28, 27 (1980). With M = 2 points angles on the half circle, v_n = x_2n and
 * v_(M-1-n) = x_(2n+1) have the transform V_k = (d_k exp(-i pi k/(2 M)) + its mirror)/2, and pairs of v are one complex
 * sequence of half the length. */
void phi_sums_reach_fft(const struct phi_sums *sums, const double *d, double *reach)
{
    const size_t size = sums->points, terms = sums->terms;
    double *const z = sums->work, *const re = z, *const im = z + size;
    /* V_k, k < terms, is w_k/2 (w_0 for k = 0), w_k = d_k exp(-i pi k/(4 size)); V_(k + size) is conj(V_(size - k)) */
    for (size_t k = 0; k < size; k++) {
        const size_t m = size - k;
        const double scale = k > 0 ? 0.5 : 1;
        const double a = k < terms ? scale * d[k] * sums->quarter[2 * k] : 0;
        const double b = k < terms ? -scale * d[k] * sums->quarter[2 * k + 1] : 0;
        const double c = m < terms ? 0.5 * d[m] * sums->quarter[2 * m] : 0;
        const double s = m < terms ? 0.5 * d[m] * sums->quarter[2 * m + 1] : 0;
        const double cos_k = sums->half[2 * k], sin_k = sums->half[2 * k + 1];
        /* Z = (V_k + V_(k + size)) + i exp(-i pi k/size) (V_k - V_(k + size)) */
        const double x = a - c, y = b - s;
        re[k] = (a + c) + (sin_k * x - cos_k * y);
        im[k] = (b + s) + (cos_k * x + sin_k * y);
    }
    const double *const v_even = transform(sums, z, z + 2 * size), *const v_odd = v_even + size;
    /* even j = 2 n from v_n, odd j = 2 n + 1 from v_(M - 1 - n); v_2i = v_even[i], v_(2i+1) = v_odd[i] */
    for (size_t n = 0; n < size / 2; n += 2) {
        reach[2 * n] = v_even[n / 2];
        reach[2 * n + 2] = v_odd[n / 2];
        reach[2 * n + 1] = v_odd[size - 1 - n / 2];
        reach[2 * n + 3] = v_even[size - 1 - n / 2];
    }
}

void phi_sums_transform_fft(const struct phi_sums *sums, const double *pressure, double *e)
{
    const size_t size = sums->points;
    double *const z = sums->work, *const v_even = z, *const v_odd = z + size;
    memset(z, 0, 2 * size * sizeof *z);
    for (size_t n = 0; n < size / 2; n += 2) {
        v_even[n / 2] = pressure[2 * n];
        v_odd[n / 2] = pressure[2 * n + 2];
        v_odd[size - 1 - n / 2] = pressure[2 * n + 1];
        v_even[size - 1 - n / 2] = pressure[2 * n + 3];
    }
    const double *const re = transform(sums, z, z + 2 * size), *const im = re + size;
    e[0] = re[0] + im[0];
    for (size_t k = 1; k < sums->terms; k++) {
        const size_t m = size - k;
        const double cos_k = sums->half[2 * k], sin_k = sums->half[2 * k + 1];
        /* V_k = (Z_k + conj(Z_m))/2 - (i/2) exp(-i pi k/size) (Z_k - conj(Z_m)) */
        const double x = re[k] - re[m], y = im[k] + im[m];
        const double v_re = 0.5 * ((re[k] + re[m]) + (cos_k * y - sin_k * x));
        const double v_im = 0.5 * ((im[k] - im[m]) - (cos_k * x + sin_k * y));
        e[k] = sums->quarter[2 * k] * v_re + sums->quarter[2 * k + 1] * v_im;
    }
}
