/* SPDX-License-Identifier: MIT */
/* Tests modes in double arithmetic (cor_disk_modes_compute) against the proved tables, by sum rules and by the count of
 * modes, for nu between -1 and 1 and close to both. Tests refusals. */
#include "check.h"

#include <cor/disk.h>
#include <cor/status.h>

enum { MOST = COR_DISK_MODES_MAX_COUNT };
static struct cor_disk_mode mode[MOST + 1], other[MOST];

static struct cor_disk_modes compute(double nu, size_t count)
{
    struct cor_disk_modes modes = {0, 0, NULL};
    const struct cor_disk_mode untouched = mode[count];
    const int status = cor_disk_modes_compute(nu, count, mode, &modes);
    check(status == COR_OK, "nu = %.17g, %zu modes: %s", nu, count, cor_status_text(status));
    assert_true(same_bits(modes.nu, nu) && modes.count == count && modes.mode == mode);
    check(memcmp(&untouched, &mode[count], sizeof untouched) == 0, "wrote beyond %zu modes", count);
    return modes;
}

TEST(as_proved)
{
    const struct cor_disk_modes *const tables[] = {&cor_disk_modes_nu033, &cor_disk_modes_nu090};
    for (int t = 0; t < 2; t++) {
        const struct cor_disk_modes *const proved = tables[t];
        double off_omega = 0, off_amplitude = 0;
        compute(proved->nu, proved->count);
        for (size_t i = 0; i < proved->count; i++) {
            const struct cor_disk_mode *const exact = &proved->mode[i];
            check(mode[i].n == exact->n && mode[i].l == exact->l, "mode %zu is (%d, %d), not (%d, %d)", i, mode[i].n,
                  mode[i].l, exact->n, exact->l);
            const double length = hypot(exact->c, exact->s);
            off_omega = fmax(off_omega, fabs(mode[i].omega / exact->omega - 1));
            off_amplitude = fmax(off_amplitude, fabs(mode[i].c - exact->c) / length);
            off_amplitude = fmax(off_amplitude, fabs(mode[i].s - exact->s) / length);
        }
        /* the bounds also hold for longer tables */
        check(off_omega <= 0.1 * COR_DISK_MODES_OMEGA_MAX_ERROR, "%g", off_omega);
        check(off_amplitude <= 0.02 * COR_DISK_MODES_AMPLITUDE_MAX_ERROR, "%g", off_amplitude);
    }
}

/* A short table is the beginning of a long one, up to rounding. Its length is the count below the next frequency. */
TEST(starts_alike)
{
    for (size_t i = 0; i < points(6); i++) {
        const double nu = random_uniform(&draw, -0.99, 0.99);
        const size_t count = (size_t)random_log(&draw, 1, 3000), more = count + (size_t)random_log(&draw, 1, 20000);
        compute(nu, more);
        memcpy(other, mode, count * sizeof *other);
        const double between = 0.5 * (mode[count - 1].omega + mode[count].omega);
        check(cor_disk_modes_below(nu, between) == count, "nu = %.17g: %zu modes below %.17g, not %zu", nu,
              cor_disk_modes_below(nu, between), between, count);
        compute(nu, count);
        for (size_t k = 0; k < count; k++)
            check(mode[k].n == other[k].n && mode[k].l == other[k].l &&
                      fabs(mode[k].omega / other[k].omega - 1) < 1e-13,
                  "nu = %.17g: mode %zu of %zu is (%d, %d) at %.17g, of %zu (%d, %d) at %.17g", nu, k, count, mode[k].n,
                  mode[k].l, mode[k].omega, more, other[k].n, other[k].l, other[k].omega);
    }
}

/* No root is found twice or missed: the number of modes below a frequency is (11.3). */
TEST(counted)
{
    for (size_t i = 0; i < points(8); i++) {
        const double nu = i == 0 ? 0.9 : 1 - random_log(&draw, 1e-3, 1.99);
        const size_t count = i == 0 ? MOST : (size_t)random_log(&draw, 1000, 200000);
        compute(nu, count);
        for (size_t k = 0; k + 1 < count; k += 1 + random_below(&draw, i == 0 ? 2000 : 150)) {
            const double omega = 0.5 * (mode[k].omega + mode[k + 1].omega);
            check(mode[k].c > 0 && isfinite(mode[k].s), "nu = %.17g, mode %zu: %g, %g", nu, k, mode[k].c, mode[k].s);
            if (mode[k + 1].omega - mode[k].omega > 1e-12 * omega && omega <= COR_DISK_MODES_MAX_OMEGA)
                check(cor_disk_modes_below(nu, omega) == k + 1, "nu = %.17g: %zu modes below %.17g, not %zu", nu,
                      cor_disk_modes_below(nu, omega), omega, k + 1);
        }
    }
}

/* Checks that l counts from 0 for each n and that frequencies grow. The sums over l of C^2/omega^2 and C S/omega^2 are
 * below (11.5) by about 2 sqrt(1 - nu^2)/(pi Omega), the part of the omitted modes; for n = 0 half of this. */
static void sum_rules(double nu, size_t count)
{
    enum { ORDERS = 2000, CHECKED = 12 };
    static int next[ORDERS];
    double cc[CHECKED] = {0}, cs[CHECKED] = {0};
    memset(next, 0, sizeof next);
    compute(nu, count);
    for (size_t i = 0; i < count; i++) {
        const struct cor_disk_mode *const m = &mode[i];
        assert_in_range(m->n, 0, ORDERS - 1);
        check(m->l == next[m->n]++, "nu = %.17g: (%d, %d) comes out of order", nu, m->n, m->l);
        check(m->c > 0 && isfinite(m->s) && (i == 0 || m->omega > mode[i - 1].omega), "nu = %.17g: mode %zu", nu, i);
        if (m->n < CHECKED) {
            cc[m->n] += m->c * m->c / (m->omega * m->omega);
            cs[m->n] += m->c * m->s / (m->omega * m->omega);
        }
    }
    const double omega = mode[count - 1].omega, pi = 3.14159265358979323846;
    for (int n = 0; n < CHECKED; n++) {
        const double all = n < 2 ? (1 - nu) / 2 : (2 * n - 1 + nu) / (n * n - 1.0);
        const double across = n == 0 ? 0 : n == 1 ? (1 - nu) / 2 : (n * (1 - nu) - 2) / (n * n - 1.0);
        const double tail = (n == 0 ? 1 : 2) * sqrt(1 - nu * nu) / (pi * omega);
        check(fabs(all - cc[n] - tail) < 0.25 * tail + 2 / (omega * omega), "nu = %g, n = %d: %g of %g, tail %g", nu, n,
              cc[n], all, tail);
        check(fabs(across - cs[n]) < 4 / (omega * omega) + 0.1 * tail, "nu = %g, n = %d: %g, not %g", nu, n, cs[n],
              across);
    }
}

TEST(all_materials)
{
    sum_rules(0.33, points(20000) < 60000 ? points(20000) : 60000);
    sum_rules(0, 5000);
    for (size_t i = 0; i < points(4); i++)
        sum_rules(random_uniform(&draw, -0.9, 0.95), (size_t)random_log(&draw, 2000, 6000));
}

/* nu close to -1 and to 1. Near -1 the lowest modes are conformal maps with omega^2 = (n + 1)(n + 2)/2. */
TEST(ends)
{
    EACH (nus, -1 + 0x1p-53, -1 + 1e-12, -1 + 1e-6, -0.999, 0.999, 1 - 1e-6, 1 - 1e-12, 1 - 0x1p-53) {
        compute(*nus, 300);
        for (size_t k = 0; k < 300; k++)
            check(isfinite(mode[k].omega) && isfinite(mode[k].c) && isfinite(mode[k].s) &&
                      (k == 0 || mode[k].omega > mode[k - 1].omega),
                  "nu = %.17g, mode %zu", *nus, k);
        if (*nus < -0.999999)
            for (int n = 1; n < 20; n++)
                check(mode[n].n == n && fabs(mode[n].omega / sqrt((n + 1) * (n + 2) / 2.0) - 1) < 1e-6,
                      "nu = %.17g, n = %d: %.9f", *nus, n, mode[n].omega);
        if (*nus == -1 + 1e-12) /* from corgen disk-modes --poisson -0.999999999999 --count 300 */
            check(fabs(mode[299].omega / 212.48529360875795621 - 1) < COR_DISK_MODES_OMEGA_MAX_ERROR / 10, "%.17g",
                  mode[299].omega);
    }
}

/* Returns the index of mode (n, l) among the first modes, or -1. */
static int place_of(int n, int l, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (mode[i].n == n && mode[i].l == l)
            return (int)i;
    return -1;
}

/* Doubles do not separate two frequencies at a crossing, but the frequencies still grow. */
TEST(crossings)
{
    enum { COUNT = 40 };
    for (size_t found = 0; found < few_or_all(3, 20);) {
        double low = random_uniform(&draw, -0.5, 0.5), high = low + 0.02;
        compute(low, COUNT + 1);
        const size_t i = random_below(&draw, COUNT - 1);
        const struct cor_disk_mode first = mode[i], second = mode[i + 1];
        compute(high, COUNT + 1);
        if (place_of(first.n, first.l, COUNT) < place_of(second.n, second.l, COUNT))
            continue;
        while (high - low > 0x1p-50) {
            const double nu = low + (high - low) / 2;
            compute(nu, COUNT + 1);
            if (place_of(first.n, first.l, COUNT) < place_of(second.n, second.l, COUNT))
                low = nu;
            else
                high = nu;
        }
        for (int at = -100; at <= 100; at++) {
            const double nu = low + at * 0x1p-53;
            compute(nu, COUNT + 1);
            for (size_t k = 1; k < COUNT; k++)
                check(mode[k].omega > mode[k - 1].omega, "nu = %.17g: mode %zu at %.17g", nu, k, mode[k].omega);
        }
        found++;
    }
}

TEST(refusals)
{
    struct cor_disk_modes modes = {7, 7, NULL};
    assert_int_equal(cor_disk_modes_compute(0.3, 10, NULL, &modes), COR_ERROR_NULL);
    assert_int_equal(cor_disk_modes_compute(0.3, 10, mode, NULL), COR_ERROR_NULL);
    EACH (wrong, -1, 1, NAN, INFINITY, -INFINITY, 2) {
        assert_int_equal(cor_disk_modes_compute(*wrong, 10, mode, &modes), COR_ERROR_DISK_POISSON_RATIO);
        assert_int_equal(cor_disk_modes_below(*wrong, 10), 0);
    }
    assert_int_equal(cor_disk_modes_compute(0.3, 0, mode, &modes), COR_ERROR_MODES);
    assert_int_equal(cor_disk_modes_compute(0.3, COR_DISK_MODES_MAX_COUNT + 1, mode, &modes), COR_ERROR_MODES);
    assert_true(modes.nu == 7 && modes.count == 7 && modes.mode == NULL);
    EACH (nowhere, 0, -1, NAN, INFINITY, 1.0001 * COR_DISK_MODES_MAX_OMEGA)
        assert_int_equal(cor_disk_modes_below(0.3, *nowhere), 0);
    for (double omega = 1e-323; omega < 1.1; omega *= 3) /* no disk has a mode below 1.17 */
        assert_int_equal(cor_disk_modes_below(0.33, omega) + cor_disk_modes_below(-0.9, omega), 0);
    assert_int_equal(cor_disk_modes_below(0.33, 1.4385), 0);
    assert_int_equal(cor_disk_modes_below(0.33, 1.4386), 1);
    assert_true(cor_disk_modes_below(0.33, COR_DISK_MODES_MAX_OMEGA) > 1000000);
    assert_int_equal(cor_disk_modes_compute(0.33, 1, mode, &modes), COR_OK);
    assert_true(mode[0].n == 2 && mode[0].l == 0);
}
