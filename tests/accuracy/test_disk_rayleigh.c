/* SPDX-License-Identifier: MIT */
/* Fractions of single modes against the motion itself in balls of 320 bits: delta'' = -P/pi from the moment of largest
 * compression on, as a power series in time, step after step until nothing is left of delta; and
 *
 *     (2 I)^2 = ((2/(pi v)) int_0^(tau/2) P cos(omega t) dt)^2.
 *
 * Neither theta nor the energy's Lambert function is in it. Frequencies need not be those of a disk. And sums and tails
 * of the library's tables against sums over three times the modes. */
#include "check.h"

#include <cor/disk.h>
#include <cor/status.h>

#include "disk/modes.h"
#include "support/digits.h"
#include "support/formula.h"
#include "support/local.h"

enum { BITS = 320, TERMS = 48, FREQUENCIES = 10, MANY = 6000 };

/* Where the integral of the lowest mode of nu = 0.33 vanishes, centre of mass */
#define QUADRUPOLE_ZERO 0x1.64014a0b3a0b3p-7

static const enum cor_disk_datum datums[3] = {COR_DISK_DATUM_CENTRE_OF_MASS, COR_DISK_DATUM_DIAMETER,
                                              COR_DISK_DATUM_PRINTED};
static struct random_state state;

static void constant_b(arb_t b, double nu, enum cor_disk_datum datum)
{
    if (datum == COR_DISK_DATUM_CENTRE_OF_MASS)
        LET(b, BITS, "-2*log(2) - (1 + nu)/4", nu);
    else if (datum == COR_DISK_DATUM_DIAMETER)
        arb_set_si(b, -1);
    else
        LET(b, BITS, "-1 - nu", nu);
}

static void midpoint(arb_t x)
{
    mag_zero(arb_radref(x));
}

/* delta and u = ln(4 pi/P) + b at rest: (pi/2) v^2 = V = P^2/(2 pi) (u - 1/2), that is e^(2 b) 16 (u - 1/2) e^(-2 u) =
 * v^2; Newton's method in u, from above the minimum u = 1 */
static void at_rest(arb_t delta, arb_t u, const arb_t b, double v)
{
    LOCAL(arb, f, y);
    LET(y, BITS, "log(16) + 2*b - 2*log(v)", b, v);
    arb_mul_2exp_si(u, y, -1); /* too small by about ln(u)/2 */
    arb_set_d(u, fmax(1.5, arf_get_d(arb_midref(u), ARF_RND_NEAR) + 4));
    for (int i = 0; i < 200; i++) { /* f = 2 u - ln(u - 1/2) - y, convex: from above no step goes too far */
        LET(f, BITS, "(2*u - log(u - 1/2) - y)/(2 - 1/(u - 1/2))", u, y);
        arb_sub(u, u, f, BITS);
        midpoint(u);
        if (arf_cmpabs_2exp_si(arb_midref(f), -BITS + 40) < 0)
            break;
    }
    LET(delta, BITS, "4*u*exp(b - u)", u, b); /* P u/pi */
    midpoint(delta);
}

/* The next coefficient of a product of two series */
static void convolve(arb_t sum, arb_srcptr x, arb_srcptr y, int k)
{
    arb_zero(sum);
    for (int i = 0; i <= k; i++)
        arb_addmul(sum, x + i, y + k - i, BITS);
}

/* delta'' = -g, g = delta/u, u' delta (u - 1) = -delta' u: coefficients from delta, delta', u in d[0], d[1], u[0] */
static void series(arb_ptr d, arb_ptr u, arb_ptr g)
{
    arb_ptr e = _arb_vec_init(TERMS), slope_d = _arb_vec_init(TERMS), slope_u = _arb_vec_init(TERMS);
    LOCAL(arb, x, y);
    for (int k = 0; k < TERMS; k++) {
        if (k > 0)
            arb_div_ui(u + k, slope_u + k - 1, (ulong)k, BITS);
        if (k > 1) {
            arb_div_ui(d + k, g + k - 2, (ulong)k * (ulong)(k - 1), BITS);
            arb_neg(d + k, d + k);
        }
        if (k > 0)
            arb_mul_ui(slope_d + k - 1, d + k, (ulong)k, BITS);
        /* g_k u_0 = d_k - (the rest) */
        arb_zero(g + k);
        convolve(x, g, u, k);
        arb_sub(x, d + k, x, BITS);
        arb_div(g + k, x, u, BITS);
        convolve(e + k, d, u, k);
        arb_sub(e + k, e + k, d + k, BITS);
        if (k + 1 < TERMS) {
            /* delta'_k needs d_(k+1), which g_(k-1) gives */
            if (k > 0) {
                arb_div_ui(d + k + 1, g + k - 1, (ulong)k * ((ulong)k + 1), BITS);
                arb_neg(d + k + 1, d + k + 1);
            }
            arb_mul_ui(slope_d + k, d + k + 1, (ulong)k + 1, BITS);
            convolve(y, slope_d, u, k);
            arb_neg(y, y);
            arb_zero(slope_u + k);
            convolve(x, slope_u, e, k);
            arb_sub(x, y, x, BITS);
            arb_div(slope_u + k, x, e, BITS);
        }
    }
    _arb_vec_clear(e, TERMS);
    _arb_vec_clear(slope_d, TERMS);
    _arb_vec_clear(slope_u, TERMS);
}

/* Adds int_0^h g cos(omega (t + s)) ds: moments m_k = int_0^h s^k exp(i omega s) ds by their recurrence, upwards; it
 * loses k!/(omega h)^k, for which there are bits enough. */
static void add_integral(arb_t sum, arb_srcptr g, const arb_t t, const arb_t h, double omega)
{
    LOCAL(acb, start, end, moment, total, factor);
    LOCAL(arb, power, w);
    arb_set_d(w, omega);
    arb_mul(power, w, h, BITS);
    if (arf_cmp_d(arb_midref(power), 0.5) < 0) {
        /* too small for that: series of the cosine itself; c_k of cos(omega (t + s)) */
        arb_ptr c = _arb_vec_init(TERMS);
        arb_mul(power, w, t, BITS);
        arb_sin_cos(acb_imagref(start), acb_realref(start), power, BITS);
        arb_one(power);
        for (int k = 0; k < TERMS; k++) {
            /* cos, -sin, -cos, sin */
            arb_mul(c + k, k % 2 ? acb_imagref(start) : acb_realref(start), power, BITS);
            if (k % 4 == 1 || k % 4 == 2)
                arb_neg(c + k, c + k);
            arb_mul(power, power, w, BITS);
            arb_div_ui(power, power, (ulong)k + 1, BITS);
        }
        arb_set(power, h);
        for (int k = 0; k < TERMS; k++) {
            convolve(w, g, c, k);
            arb_mul(w, w, power, BITS);
            arb_div_ui(w, w, (ulong)k + 1, BITS);
            arb_add(sum, sum, w, BITS);
            arb_mul(power, power, h, BITS);
        }
        _arb_vec_clear(c, TERMS);
    } else {
        arb_sin_cos(acb_imagref(end), acb_realref(end), power, BITS);
        acb_zero(factor);
        arb_inv(acb_imagref(factor), w, BITS);
        arb_neg(acb_imagref(factor), acb_imagref(factor)); /* 1/(i omega) */
        acb_sub_ui(moment, end, 1, BITS);
        acb_mul(moment, moment, factor, BITS);
        arb_one(power);
        acb_zero(total);
        for (int k = 0; k < TERMS; k++) {
            acb_addmul_arb(total, moment, g + k, BITS);
            /* m_(k+1) = (h^(k+1) e^(i omega h) - (k + 1) m_k)/(i omega) */
            arb_mul(power, power, h, BITS);
            acb_mul_ui(moment, moment, (ulong)k + 1, BITS);
            acb_neg(moment, moment);
            acb_addmul_arb(moment, end, power, BITS);
            acb_mul(moment, moment, factor, BITS);
        }
        arb_mul(power, w, t, BITS);
        arb_sin_cos(acb_imagref(start), acb_realref(start), power, BITS);
        acb_mul(total, total, start, BITS);
        arb_add(sum, sum, acb_realref(total), BITS);
    }
}

/* (2 I)^2 at the frequencies, and tau */
static void reference(double *response, double *contact_time, const double *omega, double nu, enum cor_disk_datum datum,
                      double v)
{
    arb_ptr d = _arb_vec_init(TERMS), u = _arb_vec_init(TERMS), g = _arb_vec_init(TERMS);
    arb_ptr sum = _arb_vec_init(FREQUENCIES);
    LOCAL(arb, b, t, h, x, y, smallest);
    constant_b(b, nu, datum);
    at_rest(d, u, b, v);
    arb_zero(d + 1);
    arb_mul_2exp_si(smallest, d, -48);
    for (int steps = 0; arb_gt(d, smallest); steps++) {
        check(steps < 2000, "v = %a: the steps vanish", v);
        series(d, u, g);
        /* the last coefficients of delta tell how far it converges; 2^-100 of delta */
        double reach = INFINITY;
        for (int k = TERMS - 4; k < TERMS; k++) {
            arb_div(x, d + k, d, BITS);
            mag_t size; /* its exponent may be beyond a double's */
            mag_init(size);
            arb_get_mag(size, x);
            if (!mag_is_zero(size))
                reach = fmin(reach, exp2((-100 - mag_get_d_log2_approx(size)) / k));
            mag_clear(size);
        }
        /* and no further than half of the way that is left */
        arb_div(x, d, d + 1, BITS);
        const double left = fabs(arf_get_d(arb_midref(x), ARF_RND_NEAR));
        arb_set_d(h, arb_is_zero(d + 1) || reach < 0.5 * left ? reach : 0.5 * left);
        for (int i = 0; i < FREQUENCIES; i++)
            add_integral(sum + i, g, t, h, omega[i]);
        arb_add(t, t, h, BITS);
        _arb_poly_evaluate(x, u, TERMS, h, BITS);
        _arb_poly_derivative(g, d, TERMS, BITS);
        _arb_poly_evaluate(y, g, TERMS - 1, h, BITS);
        arb_set(u, x);
        _arb_poly_evaluate(x, d, TERMS, h, BITS);
        arb_set(d, x);
        arb_set(d + 1, y);
        midpoint(d);
        midpoint(d + 1);
        midpoint(u);
        midpoint(t);
    }
    arb_div(x, d, d + 1, BITS);
    arb_sub(x, t, x, BITS);
    *contact_time = 2 * arf_get_d(arb_midref(x), ARF_RND_NEAR);
    for (int i = 0; i < FREQUENCIES; i++) {
        arb_srcptr integral = sum + i;
        LET(x, BITS, "(2*integral/v)^2", integral, v);
        response[i] = arf_get_d(arb_midref(x), ARF_RND_NEAR);
    }
    _arb_vec_clear(d, TERMS);
    _arb_vec_clear(u, TERMS);
    _arb_vec_clear(g, TERMS);
    _arb_vec_clear(sum, FREQUENCIES);
}

static double worst; /* error in parts of what is allowed */

/* Strengths as in a disk, 2 for a mode: the lowest frequency holds most of the sum. */
static void compare(double nu, enum cor_disk_datum datum, double v, const double *omega)
{
    double expected[FREQUENCIES], f[FREQUENCIES], time;
    struct cor_disk_mode mode[FREQUENCIES];
    struct cor_disk_rayleigh out;
    for (int i = 0; i < FREQUENCIES; i++) {
        const struct cor_disk_mode one = {2, i, omega[i], 1.4142135623730951, 0};
        mode[i] = one;
    }
    const struct cor_disk_modes modes = {nu, FREQUENCIES, mode};
    const int status = cor_disk_rayleigh(&modes, FREQUENCIES, datum, v, &out, f);
    check(status == COR_OK || status == COR_BEYOND_THEORY, "v = %a: %s", v, cor_status_text(status));
    reference(expected, &time, omega, nu, datum, v);
    check(fabs(out.contact_time / time - 1) <= COR_DISK_CONTACT_TIME_MAX_ERROR, "v = %a: %.17g, %.17g", v,
          out.contact_time, time);
    for (int i = 0; i < FREQUENCIES; i++) {
        const double exact = mode[i].c * mode[i].c * expected[i], error = fabs(f[i] - exact);
        const double allowed = fmax(COR_DISK_RAYLEIGH_MAX_ERROR * exact, COR_DISK_RAYLEIGH_MAX_ABSOLUTE * out.fraction);
        check(error <= allowed, "nu = %g, v = %a, omega = %a: %.17g, %.17g", nu, v, omega[i], f[i], exact);
        worst = fmax(worst, error / allowed);
    }
}

TEST(test_hard_points)
{
    /* the lowest of any disk, of nu = 0.33 and 0.9, the 1800th, the 20000th */
    static const double omega[FREQUENCIES] = {
        1.1769, 1.20715112596031, 1.43853032762639, 1.6891017846666, 2.21008494893776, 4.3, 8.6, 25, 62.9, 211.44};
    static const double speeds[] = {1e-300, 1e-12, 1e-8, 1e-4, 1e-3, 1e-2, 0.03, 0.1};
    for (size_t i = 0; i < sizeof speeds / sizeof *speeds; i++)
        compare(0.33, datums[i == 5 ? 0 : 2], speeds[i], omega);
    static const double from_edge[] = {1e-1, 1e-2, 1e-4, 1e-8, 0x1p-50, 0};
    for (size_t i = 0; i < sizeof from_edge / sizeof *from_edge; i++)
        compare(0.9, datums[i % 3], (1 - from_edge[i]) * cor_disk_speed_limit(0.9, datums[i % 3]), omega);
    /* beside the zero of the quadrupole's integral */
    static const double from_zero[] = {0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3};
    for (size_t i = 0; i < sizeof from_zero / sizeof *from_zero; i++)
        compare(0.33, COR_DISK_DATUM_CENTRE_OF_MASS, QUADRUPOLE_ZERO * (1 - from_zero[i]), omega);
}

static int increasing(const void *x, const void *y)
{
    const double a = *(const double *)x, b = *(const double *)y;
    return (a > b) - (a < b);
}

TEST(test_random_points)
{
    for (size_t i = 0; i < points(12); i++) {
        const enum cor_disk_datum datum = datums[i % 3];
        const double nu = random_uniform(&state, -0.99, 0.99), limit = cor_disk_speed_limit(nu, datum);
        double omega[FREQUENCIES];
        for (int j = 0; j < FREQUENCIES; j++)
            omega[j] = random_log(&state, 1.1769, j < 4 ? 3 : 300);
        qsort(omega, FREQUENCIES, sizeof *omega, increasing);
        compare(nu, datum, random_log(&state, i % 4 ? 1e-9 : 1e-40, limit), omega);
    }
    print_message("worst error: %.2g of what is allowed\n", worst);
}

enum { MOST_SPEEDS = 10000, FEW = 1800, TAKEN = 1000 };

/* `table` against the MANY modes of the same nu, whose tail is known better by far, and their estimate says how well.
 * Sum plus tail from TAKEN of its modes is within `bound` of it from v = 1e-9 on. */
static void compare_tails(const struct cor_disk_modes *many, const struct cor_disk_modes *table, double bound)
{
    static double errors[MOST_SPEEDS], ratios[MOST_SPEEDS];
    double worst_any = 0;
    size_t n = 0;
    for (size_t j = 0; j < points(100) && n < MOST_SPEEDS; j++) {
        const enum cor_disk_datum datum = datums[j % 3];
        const double limit = cor_disk_speed_limit(table->nu, datum);
        const double v = random_log(&state, j % 5 ? 1e-9 : 1e-300, j % 5 ? limit : 1e-9);
        struct cor_disk_rayleigh all, out;
        cor_disk_rayleigh(many, MANY, datum, v, &all, NULL);
        cor_disk_rayleigh(table, TAKEN, datum, v, &out, NULL);
        const double expected = all.fraction + all.tail, error = fabs(out.fraction + out.tail - expected);
        check(error <= (j % 5 ? bound : COR_DISK_RAYLEIGH_TAIL_MAX_ERROR_ANY_SPEED) * expected + all.error_estimate,
              "nu = %g, v = %a: %g", table->nu, v, error / expected);
        check(error <= out.error_estimate + all.error_estimate, "nu = %g, v = %a: %g, estimated %g", table->nu, v,
              error / expected, out.error_estimate / expected);
        if (j % 5) {
            errors[n] = error / expected;
            ratios[n++] = out.error_estimate / error;
        } else {
            worst_any = fmax(worst_any, error / expected);
        }
    }
    qsort(errors, n, sizeof *errors, increasing);
    qsort(ratios, n, sizeof *ratios, increasing);
    print_message("nu = %g, sum plus tail from v = 1e-9 on: worst error %.2g, median %.1g, estimated %.2g to %.3g "
                  "(median) times as large; below: worst %.2g\n",
                  table->nu, errors[n - 1], errors[n / 2], ratios[0], ratios[n / 2], worst_any);
}

/* The library's two tables; with COR_TEST_MULTIPLIER other materials too, for which disk.h has no promise but a remark.
 */
TEST(test_tails)
{
    static struct cor_disk_mode mode[MANY];
    static const long percent[] = {33, 90, -90, -75, -50, -25, 0, 20, 25, 40, 50, 60, 70, 80, 95, 99};
    const size_t materials = points(1) > 1 ? sizeof percent / sizeof *percent : 2;
    for (size_t i = 0; i < materials; i++) {
        struct disk_modes solved;
        LOCAL(fmpq, nu);
        fmpq_set_si(nu, percent[i], 100);
        disk_modes_init(&solved);
        check(disk_modes_solve(&solved, nu, MANY, 17) == 0, "nu = 0.%ld", percent[i]);
        for (slong j = 0; j < MANY; j++) {
            const struct disk_mode *from = &solved.mode[j];
            mode[j].n = (int)from->n;
            mode[j].l = (int)from->l;
            check(digits_to_double(&mode[j].omega, from->omega) && digits_to_double(&mode[j].c, from->c), "mode %ld",
                  (long)j);
        }
        disk_modes_clear(&solved);
        const struct cor_disk_modes many = {(double)percent[i] / 100, MANY, mode}, few = {many.nu, FEW, mode};
        if (i < 2)
            compare_tails(&many, i == 0 ? &cor_disk_modes_nu033 : &cor_disk_modes_nu090,
                          COR_DISK_RAYLEIGH_TAIL_MAX_ERROR);
        else
            compare_tails(&many, &few, COR_DISK_RAYLEIGH_TAIL_MAX_ERROR_ANY_SPEED);
    }
}

int main(void)
{
    state = random_start();
    const struct CMUnitTest tests[] = {test_hard_points, test_random_points, test_tails};
    const int failed = cmocka_run_group_tests_name("disk_rayleigh", tests, NULL, NULL);
    flint_cleanup();
    return failed;
}
