/* SPDX-License-Identifier: MIT */
/* Every instruction set gives the same bits, at any depth and frequency. */
#include "check.h"

#include "runtime/disk/rayleigh_parts.h"

static const double first = 1.07;

static int same_numbers(const double *x, const double *y, int n)
{
    return memcmp(x, y, (size_t)n * sizeof *x) == 0;
}

static void same_coefficients(const struct cor_rayleigh_set *set, const struct cor_spectrum *x,
                              const struct cor_spectrum *y, double q0)
{
    const int of_a = x->octaves * COR_SPECTRUM_TERMS, of_b = x->edges * COR_SPECTRUM_TERMS;
    check(same_bits(x->decay, y->decay) && x->octaves == y->octaves && x->edges == y->edges &&
              same_numbers(x->a_re[0], y->a_re[0], of_a) && same_numbers(x->a_im[0], y->a_im[0], of_a) &&
              same_numbers(x->b[0], y->b[0], of_b),
          "%s, q0 = %a", set->name, q0);
}

static void same_lines(const struct cor_rayleigh_set *set, const struct cor_spectrum *x, const struct cor_spectrum *y,
                       int n, const double *omega)
{
    struct cor_lines left, right;
    cor_spectrum_lines(x, n, omega, &left);
    cor_spectrum_lines(y, n, omega, &right);
    check(same_numbers(left.re, right.re, n) && same_numbers(left.im, right.im, n) &&
              same_numbers(left.cosine, right.cosine, n) && same_numbers(left.sine, right.sine, n) &&
              same_numbers(left.other, right.other, n),
          "%s, tau = %a, omega = %a to %a", set->name, 2 * x->half_time, omega[0], omega[n - 1]);
}

TEST(test_every_set)
{
    static struct cor_spectrum by_portable, by_set;
    int sets = 0;
    for (int i = 0; i < COR_INSTRUCTION_SETS; i++) {
        const struct cor_rayleigh_set *const set = cor_rayleigh_set(i);
        if (!set) {
            printf("instruction set %d: not on this processor\n", i);
            continue;
        }
        sets++;
        for (size_t k = 0; k < points(300); k++) {
            const double q0 = k == 0 ? 0 : k % 2 ? random_uniform(&draw, 0, 40) : random_log(&draw, 1e-9, 1500);
            const double high = k % 3 == 0 ? 1e9 : random_log(&draw, 1.2, 1e4), tau = random_uniform(&draw, 1, 60);
            cor_spectrum_init(cor_rayleigh_set(0), &by_portable, q0, tau, first, high);
            cor_spectrum_init(set, &by_set, q0, tau, first, high);
            same_coefficients(set, &by_portable, &by_set, q0);
            /* any number of lines, within one octave or several */
            for (int n = 1; n <= COR_LINES; n++) {
                double omega[COR_LINES];
                omega[0] = random_log(&draw, first, high);
                for (int j = 1; j < n; j++)
                    omega[j] = fmin(omega[j - 1] * (1 + random_uniform(&draw, 0, n % 2 ? 0.001 : 0.1)), high);
                same_lines(set, &by_portable, &by_set, n, omega);
            }
        }
    }
    assert_true(sets >= 1);
    assert_null(cor_rayleigh_set(COR_INSTRUCTION_SETS));
    assert_null(cor_rayleigh_set(-1));
}

/* The sums over modes, the surface modes and the interpolation in q0 */
TEST(test_sums_by_every_set)
{
    for (int i = 1; i < COR_INSTRUCTION_SETS; i++) {
        const struct cor_rayleigh_set *const set = cor_rayleigh_set(i), *const portable = cor_rayleigh_set(0);
        for (size_t k = 0; set && k < points(200); k++) {
            const double to = random_log(&draw, 2, 500);
            const struct cor_fading fading = {0.65 * to, 0.15 * to, to, {0.35 * to, 0.75 * to}, {0.6 * to, to}};
            struct cor_mode_weights weights[2];
            struct cor_lines lines;
            double omega[COR_LINES], beyond[COR_LINES], through[COR_LINES], low[2] = {1, 1}, high[2] = {2, 2};
            for (int j = 0; j < COR_LINES; j++) {
                omega[j] = random_uniform(&draw, 0.1 * to, to);
                beyond[j] = random_uniform(&draw, 0, 1) < 0.5;
                through[j] = random_uniform(&draw, 0, 1) < 0.5;
                lines.re[j] = random_uniform(&draw, -1, 1);
                lines.im[j] = random_uniform(&draw, -1, 1);
                lines.other[j] = random_uniform(&draw, -1, 1);
                lines.cosine[j] = random_uniform(&draw, -1, 1);
                lines.sine[j] = random_uniform(&draw, -1, 1);
            }
            memset(weights, 0, sizeof weights);
            for (int j = 0; j < COR_LINES; j++)
                weights[0].strength[j] = weights[1].strength[j] = random_log(&draw, 1e-3, 1e3);
            portable->weigh(&fading, omega, beyond, through, &weights[0], &low[0], &high[0]);
            set->weigh(&fading, omega, beyond, through, &weights[1], &low[1], &high[1]);
            assert_memory_equal(&weights[0], &weights[1], sizeof weights[0]);
            assert_true(same_bits(low[0], low[1]) && same_bits(high[0], high[1]));
            struct cor_mode_sums sums[2] = {{1, 2, {3, 4, 5, 6}, {7, 8, 9, 10}}, {1, 2, {3, 4, 5, 6}, {7, 8, 9, 10}}};
            double fraction[2][COR_LINES];
            portable->sum(&lines, &weights[0], &sums[0], fraction[0]);
            set->sum(&lines, &weights[1], &sums[1], fraction[1]);
            assert_memory_equal(&sums[0], &sums[1], sizeof sums[0]);
            assert_memory_equal(fraction[0], fraction[1], sizeof fraction[0]);
            struct cor_surface_fit fit = {0.5, {0.1, 0.09, 0.08, 0.07, 0.06}, {1, 2, 3, 4, 5}, {5, 4, 3, 2, 1}};
            double surface[2][2][COR_LINES];
            portable->surface(&fit, 10 + (int)k, surface[0][0], surface[0][1]);
            set->surface(&fit, 10 + (int)k, surface[1][0], surface[1][1]);
            assert_memory_equal(surface[0], surface[1], sizeof surface[0]);
            const double *const in[2] = {lines.re, lines.im}, weight[2] = {0.3, -0.7};
            double out[2][COR_LINES];
            portable->blend(2, weight, in, COR_LINES, out[0]);
            set->blend(2, weight, in, COR_LINES, out[1]);
            assert_memory_equal(out[0], out[1], sizeof out[0]);
            check(fabs(out[0][5] - (0.3 * lines.re[5] - 0.7 * lines.im[5])) < 1e-15, "blend");
        }
    }
}

/* Interpolation in q0 at the ends of a piece, at a node and between nodes */
TEST(test_pieces)
{
    const double high = 440, allowed = 1e-13;
    const struct cor_rayleigh_set *const set = cor_rayleigh_set(cor_widest_set());
    double *const room = malloc(cor_spectrum_piece_size(first, high) * sizeof *room);
    assert_non_null(room);
    static struct cor_spectrum direct, interpolated;
    for (int k = -5; k <= 5; k++) {
        struct cor_spectrum_piece piece;
        cor_spectrum_piece_init(&piece, set, ldexp(1, 2 * k), first, high, room);
        for (int j = 0; j < 12; j++) {
            const double place = j == 0 ? 0 : j == 1 ? 0.99999 : j == 2 ? 0.5 : random_uniform(&draw, 0, 1);
            const double q0 = ldexp(1, 2 * k) * pow(4, place), tau = random_uniform(&draw, 1, 60);
            cor_spectrum_init(set, &direct, q0, tau, first, high);
            cor_spectrum_of_piece(&interpolated, &piece, q0, tau);
            for (double omega = 1.18; omega < high; omega *= 1.1) {
                struct cor_lines x, y;
                cor_spectrum_lines(&direct, 1, &omega, &x);
                cor_spectrum_lines(&interpolated, 1, &omega, &y);
                const double size = hypot(x.re[0], x.im[0]);
                const double error = fmax(hypot(x.re[0] - y.re[0], x.im[0] - y.im[0]), fabs(x.other[0] - y.other[0]));
                check(error <= allowed * size, "q0 = %a, omega = %g: %g", q0, omega, error / size);
                check(same_bits(x.cosine[0], y.cosine[0]), "q0 = %a", q0);
            }
            struct cor_lines far;
            const double beyond = 4e6 / direct.half_time; /* too large for the reduction of kernel_sincos */
            cor_spectrum_lines(&direct, 1, &beyond, &far);
            check(same_bits(far.cosine[0], cos(beyond * direct.half_time)), "omega = %g", beyond);
        }
    }
    free(room);
}
