/* SPDX-License-Identifier: MIT */
/* Every instruction set gives the same bits, at any depth and frequency. */
#include "check.h"

#include "runtime/disk/rayleigh_spectrum.h"

static const double first = 1.07;

static void same_coefficients(const struct cor_rayleigh_set *set, const struct cor_spectrum *x,
                              const struct cor_spectrum *y, double q0)
{
    check(same_bits(x->decay, y->decay) && x->octaves == y->octaves && x->edges == y->edges, "%s, q0 = %a", set->name,
          q0);
    for (int k = 0; k < x->octaves; k++)
        for (int j = 0; j < COR_SPECTRUM_TERMS; j++)
            check(same_bits(x->a_re[k][j], y->a_re[k][j]) && same_bits(x->a_im[k][j], y->a_im[k][j]) &&
                      (k >= x->edges || same_bits(x->b[k][j], y->b[k][j])),
                  "%s, q0 = %a, octave %d, term %d", set->name, q0, k, j);
}

static void same_lines(const struct cor_rayleigh_set *set, const struct cor_spectrum *x, const struct cor_spectrum *y,
                       int n, const double *omega)
{
    struct cor_lines left, right;
    cor_spectrum_lines(x, n, omega, &left);
    cor_spectrum_lines(y, n, omega, &right);
    for (int i = 0; i < n; i++)
        check(same_bits(left.re[i], right.re[i]) && same_bits(left.im[i], right.im[i]) &&
                  same_bits(left.cosine[i], right.cosine[i]) && same_bits(left.sine[i], right.sine[i]) &&
                  same_bits(left.other[i], right.other[i]),
              "%s, tau = %a, omega = %a", set->name, 2 * x->half_time, omega[i]);
}

static void test_every_set(void **unused)
{
    (void)unused;
    struct random_state state = random_start();
    static struct cor_spectrum by_portable, by_set, by_best;
    int sets = 0;
    for (int i = 0; i < COR_INSTRUCTION_SETS; i++) {
        const struct cor_rayleigh_set *const set = cor_rayleigh_set(i);
        if (!set) {
            printf("instruction set %d: not on this processor\n", i);
            continue;
        }
        sets++;
        for (size_t k = 0; k < points(300); k++) {
            const double q0 = k == 0 ? 0 : k % 2 ? random_uniform(&state, 0, 40) : random_log(&state, 1e-9, 1500);
            const double high = k % 3 == 0 ? 1e9 : random_log(&state, 1.2, 1e4), tau = random_uniform(&state, 1, 60);
            cor_spectrum_init_by(cor_rayleigh_set(0), &by_portable, q0, tau, first, high);
            cor_spectrum_init_by(set, &by_set, q0, tau, first, high);
            cor_spectrum_init(&by_best, q0, tau, first, high);
            same_coefficients(set, &by_portable, &by_set, q0);
            same_coefficients(set, &by_portable, &by_best, q0);
            /* any number of lines, of one octave or of several */
            for (int n = 1; n <= COR_LINES; n++) {
                double omega[COR_LINES];
                omega[0] = random_log(&state, first, high);
                for (int j = 1; j < n; j++)
                    omega[j] = fmin(omega[j - 1] * (1 + random_uniform(&state, 0, n % 2 ? 0.001 : 0.1)), high);
                same_lines(set, &by_portable, &by_set, n, omega);
            }
        }
    }
    assert_true(sets >= 1);
    assert_null(cor_rayleigh_set(COR_INSTRUCTION_SETS));
    assert_null(cor_rayleigh_set(-1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_set),
    };
    return cmocka_run_group_tests_name("disk_rayleigh_spectrum", tests, NULL, NULL);
}
