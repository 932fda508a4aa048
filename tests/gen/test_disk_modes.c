/* SPDX-License-Identifier: MIT */
/* Free modes of the disk: known values, the count against a Rayleigh-Ritz discretisation, the printed equation (25)
 * with Bessel functions from elsewhere, mode shapes integrated, sum rules, and the corners of nu. */
#include "ball.h"

#include "disk/equation.h"
#include "disk/modes.h"
#include "runtime/disk/mode_source.h"
#include "support/digits.h"
#include "support/local.h"
#include "support/parallel.h"

static void set_nu(fmpq_t nu, const char *text)
{
    assert_int_equal(fmpq_set_str(nu, text, 10), 0);
    fmpq_canonicalise(nu);
}

static void modes_solve(struct disk_modes *modes, const char *text, slong count, slong digits)
{
    LOCAL(fmpq, nu);
    set_nu(nu, text);
    disk_modes_init(modes);
    assert_int_equal(disk_modes_solve(modes, nu, count, digits), 0);
    assert_int_equal(modes->count, count);
}

static double middle(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

/* ---- known values ---- */

TEST(test_known)
{
    static const struct {
        const char *nu;
        slong n, l;
        const char *omega;
        int decimals;
    } known[] = {
        {"33/100", 2, 0, "1.43853032762639", 14}, {"33/100", 1, 0, "1.68910178466690", 14},
        {"33/100", 0, 0, "2.19004806589272", 14}, {"33/100", 3, 0, "2.21008494893776", 14},
        {"9/10", 2, 0, "1.20715112596031", 14},   {"9/10", 1, 0, "1.55121637766142", 14},
        {"9/10", 3, 0, "1.86897856327933", 14},
    };
    struct disk_modes modes[2];
    modes_solve(&modes[0], "33/100", 1800, 17);
    modes_solve(&modes[1], "9/10", 1800, 17);
    slong place[2] = {0, 0};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const int which = known[i].nu[0] == '9';
        const struct disk_mode *mode = &modes[which].mode[place[which]++];
        assert_int_equal(mode->n, known[i].n);
        assert_int_equal(mode->l, known[i].l);
        check(fabs(middle(mode->omega) - strtod(known[i].omega, NULL)) < 1e-14, "n = %ld", (long)mode->n);
    }
    assert_true(fabs(middle(modes[0].mode[0].c) - 1.38881532256) < 1e-11);
    assert_true(fabs(middle(modes[0].mode[0].s) + 0.44144949742) < 1e-11);

    /* what a table promises: the largest n met, the order, the sign, and digits that are decided */
    static const slong largest[2] = {109, 119};
    for (int which = 0; which < 2; which++) {
        slong n = 0;
        for (slong i = 0; i < modes[which].count; i++) {
            const struct disk_mode *mode = &modes[which].mode[i];
            n = mode->n > n ? mode->n : n;
            assert_true(i == 0 || arb_lt(mode[-1].omega, mode->omega));
            assert_true(arb_is_positive(mode->c));
            assert_true((mode->n == 0) == arb_is_zero(mode->s));
            const arb_struct *const number[] = {mode->omega, mode->c, mode->s};
            for (int k = 0; k < 3; k++) {
                double rounded;
                char *text = digits_of_ball(number[k], 17);
                assert_non_null(text);
                assert_true(digits_to_double(&rounded, number[k]));
                assert_true(fabs(strtod(text, NULL) - rounded) <= 0x1p-52 * fabs(rounded));
                free(text);
            }
        }
        assert_int_equal(n, largest[which]);
    }
    disk_modes_clear(&modes[0]);
    disk_modes_clear(&modes[1]);
}

/* ---- one mode by the count alone ---- */

static void assert_same_mode(const struct disk_mode *a, const struct disk_mode *b)
{
    assert_int_equal(a->n, b->n);
    assert_int_equal(a->l, b->l);
    assert_overlap(a->omega, b->omega, "omega of n", a->n);
    assert_overlap(a->c, b->c, "C of n", a->n);
    assert_overlap(a->s, b->s, "S of n", a->n);
}

TEST(test_single_modes)
{
    static const char *const materials[] = {"33/100", "-7/10", "0"};
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++) {
        struct disk_modes modes;
        struct disk_mode mode;
        LOCAL(fmpq, nu);
        set_nu(nu, materials[i]);
        modes_solve(&modes, materials[i], 100, 30);
        disk_mode_init(&mode);
        for (slong k = 0; k < modes.count; k += 3) {
            assert_int_equal(disk_mode_solve(&mode, nu, modes.mode[k].n, modes.mode[k].l, 120), 0);
            assert_bits(mode.omega, 110);
            assert_same_mode(&mode, &modes.mode[k]);
        }
        disk_mode_clear(&mode);
        disk_modes_clear(&modes);
    }
}

/* Two roots of n = 1 with a relative gap of 4.2e-4: both, and nothing between or beside them that is missing. */
TEST(test_near_pair)
{
    LOCAL(fmpq, nu);
    struct disk_mode low, high;
    set_nu(nu, "33/100");
    disk_mode_init(&low);
    disk_mode_init(&high);
    assert_int_equal(disk_mode_solve(&low, nu, 1, 50, 100), 0);
    assert_int_equal(disk_mode_solve(&high, nu, 1, 51, 100), 0);
    const double gap = (middle(high.omega) - middle(low.omega)) / middle(low.omega);
    check(gap > 4.1e-4 && gap < 4.3e-4, "gap %g", gap);
    struct disk disk;
    LOCAL(arb, w);
    disk_init(&disk, nu, 200);
    for (int i = 0; i < 4; i++) {
        arb_set_d(w, (i < 2 ? middle(low.omega) : middle(high.omega)) * (i % 2 ? 1 + 1e-9 : 1 - 1e-9));
        arb_sqr(w, w, 200);
        assert_int_equal(disk_count(&disk, 1, w), 50 + (i + 1) / 2);
    }
    disk_clear(&disk);
    disk_mode_clear(&low);
    disk_mode_clear(&high);
}

/* ---- Rayleigh-Ritz ---- */

/* Negative eigenvalues of K - w M in the fields (u_r, u_phi) = r^p (1, sigma), all that are polynomials in x and y of
 * that n up to a degree; by LDL^T. No more than there are modes below omega, the rigid ones included, and as many if
 * the degree is high enough. */
enum { RITZ_MAX = 64 };
static const slong RITZ_PREC = 500;

struct field {
    slong p, sigma;
};

static slong ritz_fields(struct field *field, slong n, slong pairs)
{
    slong count = 0;
    for (slong j = 0; j < pairs; j++) {
        if (n == 0) {
            field[count++] = (struct field){1 + 2 * j, 0};
        } else {
            field[count++] = (struct field){n - 1 + 2 * j, -1};
            field[count++] = (struct field){n + 1 + 2 * j, 1};
        }
    }
    return count;
}

static slong ritz_count(const fmpq_t nu, slong n, const arb_t w, slong pairs)
{
    struct field field[RITZ_MAX];
    const slong size = ritz_fields(field, n, pairs);
    arb_mat_t a;
    LOCAL(arb, ratio, scale, x, y);
    arb_mat_init(a, size, size);
    arb_set_fmpq(ratio, nu, RITZ_PREC);
    arb_mul(scale, ratio, ratio, RITZ_PREC);
    arb_sub_si(scale, scale, 1, RITZ_PREC);
    arb_mul(scale, scale, w, RITZ_PREC); /* -(1 - nu^2) w */
    for (slong i = 0; i < size; i++) {
        for (slong j = 0; j < size; j++) {
            const slong p = field[i].p, q = field[j].p, sp = field[i].sigma, sq = field[j].sigma;
            const slong ring_p = 1 + n * sp, ring_q = 1 + n * sq;
            const slong shear_p = sp * (p - 1) - n, shear_q = sq * (q - 1) - n;
            /* (eps_rr eps_rr + eps_pp eps_pp + nu (..) + (1 - nu)/2 gamma gamma)/(p + q) */
            arb_mul_si(x, ratio, 2 * (p * ring_q + q * ring_p) - shear_p * shear_q, RITZ_PREC);
            arb_add_si(x, x, 2 * (p * q + ring_p * ring_q) + shear_p * shear_q, RITZ_PREC);
            if (p + q > 0)
                arb_div_si(x, x, 2 * (p + q), RITZ_PREC);
            else
                assert_true(arb_contains_zero(x)); /* the translation */
            arb_mul_si(y, scale, 1 + sp * sq, RITZ_PREC);
            arb_div_si(y, y, p + q + 2, RITZ_PREC);
            arb_add(arb_mat_entry(a, i, j), x, y, RITZ_PREC);
        }
    }
    slong negative = 0;
    for (slong k = 0; k < size; k++) {
        const arb_struct *pivot = arb_mat_entry(a, k, k);
        assert_false(arb_contains_zero(pivot));
        negative += arb_is_negative(pivot);
        for (slong i = k + 1; i < size; i++) {
            arb_div(x, arb_mat_entry(a, i, k), pivot, RITZ_PREC);
            for (slong j = k + 1; j < size; j++)
                arb_submul(arb_mat_entry(a, i, j), x, arb_mat_entry(a, k, j), RITZ_PREC);
        }
    }
    arb_mat_clear(a);
    return negative;
}

TEST(test_ritz)
{
    static const char *const materials[] = {"33/100", "9/10", "0", "-1/2", "-19/20"};
    static const slong orders[] = {0, 1, 2, 3, 7, 20};
    enum { PAIRS = 14, POINTS = 9 };
    struct random_state random = random_start();
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++) {
        LOCAL(fmpq, nu);
        LOCAL(arb, w);
        struct disk disk;
        set_nu(nu, materials[i]);
        disk_init(&disk, nu, 128);
        for (size_t k = 0; k < sizeof orders / sizeof *orders; k++) {
            const slong n = orders[k];
            for (int point = 0; point < POINTS; point++) {
                /* kappa' up to n + 12: the degree is enough for every mode there */
                const double omega = random_uniform(&random, 0.1, 1) * ((double)n + 12) / sqrt(2 * disk.e_double);
                arb_set_d(w, omega);
                arb_mul(w, w, w, RITZ_PREC);
                const slong ritz = ritz_count(nu, n, w, PAIRS), count = disk_count(&disk, n, w);
                check(count + (n == 1) == ritz, "nu = %s, n = %ld, omega = %a: %ld, and %ld by Ritz", materials[i],
                      (long)n, omega, (long)count, (long)ritz);
                const struct cor_mode_material material = {disk.e_double, disk.s_double};
                assert_true(cor_mode_count(&material, n, omega) == count);
                assert_true(ritz_count(nu, n, w, 3) <= ritz);
            }
        }
        /* frequencies: Ritz finds a root from above, and close */
        struct disk_mode mode;
        disk_mode_init(&mode);
        for (slong n = 0; n <= 3; n++) {
            for (slong l = 0; l <= 2; l++) {
                assert_int_equal(disk_mode_solve(&mode, nu, n, l, 120), 0);
                for (int side = -1; side <= 1; side += 2) {
                    arb_set_d(w, 1 + side * 1e-15);
                    arb_mul(w, w, mode.omega, RITZ_PREC);
                    mag_zero(arb_radref(w));
                    arb_mul(w, w, w, RITZ_PREC);
                    assert_int_equal(ritz_count(nu, n, w, PAIRS), l + (side > 0) + (n == 1));
                }
            }
        }
        disk_mode_clear(&mode);
        disk_clear(&disk);
    }
}

/* ---- (25) as printed ---- */

static void printed_equation(arb_t f, const fmpq_t ratio, slong n, const arb_t omega, slong prec)
{
    arb_t nu, s, kappa, kappa_, j[2], j_[2], x, y, order;
    arb_ptr all[] = {nu, s, kappa, kappa_, j[0], j[1], j_[0], j_[1], x, y, order};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        arb_init(all[i]);
    arb_set_fmpq(nu, ratio, prec);
    arb_sub_si(s, nu, 1, prec);
    arb_neg(s, s);
    arb_mul(kappa, nu, nu, prec);
    arb_sub_si(kappa, kappa, 1, prec);
    arb_neg(kappa, kappa);
    arb_sqrt(kappa, kappa, prec);
    arb_mul(kappa, kappa, omega, prec);
    arb_add_si(kappa_, nu, 1, prec);
    arb_mul_2exp_si(kappa_, kappa_, 1);
    arb_sqrt(kappa_, kappa_, prec);
    arb_mul(kappa_, kappa_, omega, prec);
    for (int i = 0; i < 2; i++) { /* j[0] = J_n, j[1] = z J_{n-1} */
        arb_set_si(order, n - i);
        arb_hypgeom_bessel_j(j[i], order, kappa, prec);
        arb_hypgeom_bessel_j(j_[i], order, kappa_, prec);
    }
    arb_mul(j[1], j[1], kappa, prec);
    arb_mul(j_[1], j_[1], kappa_, prec);

    arb_mul(f, s, s, prec);
    arb_mul_si(f, f, 1 - n * n, prec);
    arb_mul(f, f, j[1], prec);
    arb_mul(f, f, j_[1], prec);
    arb_mul(kappa, kappa, kappa, prec);
    arb_mul_si(x, s, (1 - n * n) * n, prec);
    arb_sub(x, kappa, x, prec);
    arb_mul(x, x, s, prec);
    arb_mul(y, j[1], j_[0], prec);
    arb_addmul(y, j_[1], j[0], prec);
    arb_addmul(f, x, y, prec);
    arb_mul_si(x, s, 2 * (n * n + n), prec);
    arb_sub(x, kappa, x, prec);
    arb_mul(x, x, kappa, prec);
    arb_mul(x, x, j[0], prec);
    arb_addmul(f, x, j_[0], prec);
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        arb_clear(all[i]);
}

/* (25) vanishes at omega: it changes sign within the relative distance 2^-bits. */
static void assert_root(const struct disk_mode *mode, const fmpq_t nu, slong bits, slong prec)
{
    arb_t f[2], omega, shift;
    arb_init(f[0]);
    arb_init(f[1]);
    arb_init(omega);
    arb_init(shift);
    for (int side = 0; side < 2; side++) {
        arb_set_si(shift, side ? 1 : -1);
        arb_mul_2exp_si(shift, shift, -bits);
        arb_add_si(shift, shift, 1, prec);
        arb_mul(omega, shift, mode->omega, prec);
        mag_zero(arb_radref(omega));
        printed_equation(f[side], nu, mode->n, omega, prec);
        check(!arb_contains_zero(f[side]), "n = %ld, l = %ld", (long)mode->n, (long)mode->l);
    }
    check(arb_is_positive(f[0]) != arb_is_positive(f[1]), "n = %ld, l = %ld", (long)mode->n, (long)mode->l);
    arb_clear(f[0]);
    arb_clear(f[1]);
    arb_clear(omega);
    arb_clear(shift);
}

TEST(test_printed_equation)
{
    static const char *const materials[] = {"33/100", "9/10", "-3/5"};
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++) {
        struct disk_modes modes;
        LOCAL(fmpq, nu);
        set_nu(nu, materials[i]);
        modes_solve(&modes, materials[i], 900, 30);
        for (slong k = 0; k < modes.count; k += 13)
            assert_root(&modes.mode[k], nu, 95, 400);
        disk_modes_clear(&modes);
    }
    /* n far above kappa */
    struct disk_mode mode;
    LOCAL(fmpq, nu);
    disk_mode_init(&mode);
    set_nu(nu, "33/100");
    assert_int_equal(disk_mode_solve(&mode, nu, 1500, 0, 120), 0);
    assert_root(&mode, nu, 100, 4000);
    set_nu(nu, "-9/10");
    assert_int_equal(disk_mode_solve(&mode, nu, 600, 1, 120), 0);
    assert_root(&mode, nu, 100, 4000);
    disk_mode_clear(&mode);
}

/* ---- (26) by integration ---- */

/* u_r and u_phi at r, (19), for A and B; only u_r needs B where n = 0. */
static void shape(arb_t ur, arb_t uphi, const arb_t a, const arb_t b, slong n, const arb_t kappa, const arb_t kappa_,
                  const arb_t r, slong prec)
{
    const arb_struct *const wave[2] = {kappa, kappa_};
    arb_t z, order, value[2], slope[2];
    arb_init(z);
    arb_init(order);
    for (int i = 0; i < 2; i++) {
        arb_init(value[i]);
        arb_init(slope[i]);
        arb_mul(z, wave[i], r, prec);
        arb_set_si(order, n);
        arb_hypgeom_bessel_j(value[i], order, z, prec);
        arb_set_si(order, n - 1);
        arb_hypgeom_bessel_j(slope[i], order, z, prec);
        arb_set_si(order, n + 1);
        arb_hypgeom_bessel_j(z, order, z, prec);
        arb_sub(slope[i], slope[i], z, prec); /* 2 J' */
        arb_mul_2exp_si(slope[i], slope[i], -1);
        arb_mul(slope[i], slope[i], wave[i], prec);
        arb_div(value[i], value[i], r, prec);
        arb_mul_si(value[i], value[i], n, prec);
    }
    arb_mul(ur, a, slope[0], prec);
    arb_addmul(ur, b, value[1], prec);
    arb_mul(uphi, a, value[0], prec);
    arb_addmul(uphi, b, slope[1], prec);
    arb_neg(uphi, uphi);
    arb_clear(z);
    arb_clear(order);
    for (int i = 0; i < 2; i++) {
        arb_clear(value[i]);
        arb_clear(slope[i]);
    }
}

/* A and B from C and S at the rim, then the shear stress there and the integral of (26), in Gauss-Legendre nodes. */
TEST(test_normalisation)
{
    enum { NODES = 64 };
    static const slong PREC = 200;
    static const struct {
        const char *nu;
        slong n, l;
    } cases[] = {{"33/100", 2, 0},
                 {"33/100", 0, 0},
                 {"33/100", 0, 4},
                 {"33/100", 1, 0},
                 {"33/100", 1, 7},
                 {"33/100", 5, 4},
                 {"9/10", 2, 1},
                 {"9/10", 30, 0},
                 {"-1/2", 3, 2},
                 {"-9/10", 1, 1},
                 {"999999999999/1000000000000", 2, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const slong n = cases[i].n;
        LOCAL(fmpq, nu);
        struct disk_mode mode;
        arb_t kappa, kappa_, a, b, one, zero, ur[2], uphi[2], det, x, node, weight, sum;
        arb_ptr all[] = {kappa, kappa_, a, b, one, zero, ur[0], ur[1], uphi[0], uphi[1], det, x, node, weight, sum};
        for (size_t k = 0; k < sizeof all / sizeof *all; k++)
            arb_init(all[k]);
        disk_mode_init(&mode);
        set_nu(nu, cases[i].nu);
        assert_int_equal(disk_mode_solve(&mode, nu, n, cases[i].l, 150), 0);
        arb_zero(zero);
        arb_set_fmpq(x, nu, PREC);
        arb_add_si(x, x, 1, PREC);
        arb_mul_2exp_si(kappa_, x, 1);
        arb_sqrt(kappa_, kappa_, PREC);
        arb_mul(kappa_, kappa_, mode.omega, PREC);
        arb_sub_si(a, x, 2, PREC);
        arb_neg(a, a);
        arb_mul(kappa, a, x, PREC);
        arb_sqrt(kappa, kappa, PREC);
        arb_mul(kappa, kappa, mode.omega, PREC);

        arb_one(one);
        shape(ur[0], uphi[0], one, zero, n, kappa, kappa_, one, PREC);
        if (n == 0) {
            arb_div(a, mode.c, ur[0], PREC);
            arb_zero(b);
        } else {
            shape(ur[1], uphi[1], zero, one, n, kappa, kappa_, one, PREC);
            arb_mul(det, ur[0], uphi[1], PREC);
            arb_submul(det, ur[1], uphi[0], PREC);
            arb_mul(a, mode.c, uphi[1], PREC);
            arb_submul(a, mode.s, ur[1], PREC);
            arb_div(a, a, det, PREC);
            arb_mul(b, mode.s, ur[0], PREC);
            arb_submul(b, mode.c, uphi[0], PREC);
            arb_div(b, b, det, PREC);
        }
        for (ulong k = 0; k < NODES; k++) {
            arb_hypgeom_legendre_p_ui_root(node, weight, NODES, k, PREC);
            arb_add_si(node, node, 1, PREC);
            arb_mul_2exp_si(node, node, -1);
            shape(ur[0], uphi[0], a, b, n, kappa, kappa_, node, PREC);
            arb_mul(x, ur[0], ur[0], PREC);
            arb_addmul(x, uphi[0], uphi[0], PREC);
            arb_mul(x, x, node, PREC);
            arb_addmul(sum, x, weight, PREC);
        }
        if (n > 0)
            arb_mul_2exp_si(sum, sum, -1); /* the weights add up to 2, the length is 1 */
        arb_sub_si(sum, sum, 1, PREC);
        check(fabs(middle(sum)) < 1e-25 && arb_rel_accuracy_bits(mode.c) > 80, "n = %ld, l = %ld: %g", (long)n,
              (long)cases[i].l, middle(sum));
        disk_mode_clear(&mode);
        for (size_t k = 0; k < sizeof all / sizeof *all; k++)
            arb_clear(all[k]);
    }
}

/* ---- sums over modes ---- */

/* sum_l C^2/omega^2 and sum_l C S/omega^2 of one n are exact, and so is how the first is missed below Omega,
 * 2 sqrt(1 - nu^2)/(pi Omega), half of it for n = 0; over all n, sum C^2 -> Omega^2; and the number of modes grows like
 * the area (Weyl), with a term from the rim that is linear in Omega. */
TEST(test_sums)
{
    leave_to_turn(1, 3);
    static const char *const materials[] = {"33/100", "9/10", "-1/2"};
    enum { ORDERS = 6 };
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++) {
        LOCAL(fmpq, exact);
        struct disk disk;
        struct disk_modes modes;
        set_nu(exact, materials[i]);
        disk_init(&disk, exact, 64);
        const double nu = disk.e_double - 1;
        modes_solve(&modes, materials[i], 4000, 15);
        const double end = middle(modes.mode[modes.count - 1].omega);
        double all = 0, rim_low = HUGE_VAL, rim_high = -HUGE_VAL, cc[ORDERS] = {0}, cs[ORDERS] = {0};
        for (slong k = 0; k < modes.count; k++) {
            const struct disk_mode *mode = &modes.mode[k];
            const double omega = middle(mode->omega), c = middle(mode->c), s = middle(mode->s);
            all += c * c;
            if (mode->n < ORDERS) {
                cc[mode->n] += c * c / (omega * omega);
                cs[mode->n] += c * s / (omega * omega);
            }
            const double rim = ((double)k - ((1 - nu * nu) + 2 * (1 + nu)) * omega * omega / 8) / omega;
            if (k >= 1000) {
                rim_low = fmin(rim_low, rim);
                rim_high = fmax(rim_high, rim);
            }
        }
        check(fabs(all / (end * end) - 1) < 0.01, "nu = %s: %g", materials[i], all / (end * end));
        check(rim_low > 0.5 && rim_high < 1.1 && rim_high - rim_low < 0.3, "nu = %s: %g to %g", materials[i], rim_low,
              rim_high);
        const double tail = 2 * sqrt(1 - nu * nu) / (acos(-1.0) * end);
        for (int n = 0; n < ORDERS; n++) {
            const double sum_cc = n < 2 ? (1 - nu) / 2 : (2 * n - 1 + nu) / (n * n - 1);
            const double missing = (sum_cc - cc[n]) / (n == 0 ? tail / 2 : tail);
            check(fabs(missing - 1) < 0.05, "nu = %s, n = %d: %g of the tail", materials[i], n, missing);
            if (n >= 2) {
                const double error = (n * (1 - nu) - 2) / (n * n - 1) - cs[n];
                check(fabs(error) < 1e-5, "nu = %s, n = %d: %g", materials[i], n, error);
            }
        }
        disk_modes_clear(&modes);
        disk_clear(&disk);
    }
}

/* ---- the corners ---- */

static void near_end(fmpq_t nu, int side, ulong digits)
{
    fmpz_ui_pow_ui(fmpq_denref(nu), 10, digits);
    fmpz_sub_ui(fmpq_numref(nu), fmpq_denref(nu), 1);
    if (side < 0)
        fmpq_neg(nu, nu);
}

static void assert_close(const arb_t x, double square, const char *what, slong index)
{
    const double error = middle(x) - sqrt(square);
    check(fabs(error) <= 1e-14 * sqrt(square), "%s %ld: %g", what, (long)index, error);
}

TEST(test_corners_of_nu)
{
    LOCAL(fmpq, nu);
    struct disk_modes modes, other;
    disk_modes_init(&modes);
    disk_modes_init(&other);
    static const ulong margins[] = {6, 30, 99};
    for (size_t i = 0; i < sizeof margins / sizeof *margins; i++) {
        /* nu -> -1: conformal maps z^(n+1), which cost compression alone: omega^2 = (n+1)(n+2)/2, C = S = sqrt(n+2);
         * the breathing mode has omega = C = sqrt(2) */
        near_end(nu, -1, margins[i]);
        assert_int_equal(disk_modes_solve(&modes, nu, 300, 20), 0);
        for (slong n = 0; n < modes.count && margins[i] > 14; n++) {
            const struct disk_mode *mode = &modes.mode[n];
            assert_int_equal(mode->n, n);
            assert_int_equal(mode->l, 0);
            assert_close(mode->omega, n == 0 ? 2 : (double)((n + 1) * (n + 2)) / 2, "omega", n);
            assert_close(mode->c, (double)(n + 2), "C", n);
            if (n > 0)
                assert_close(mode->s, (double)(n + 2), "S", n);
        }
        for (slong k = 0; k < modes.count; k += 59)
            assert_root(&modes.mode[k], nu, 50, 1500);
        /* nu -> 1: no compression */
        near_end(nu, 1, margins[i]);
        assert_int_equal(disk_modes_solve(&other, nu, 300, 20), 0);
        for (slong k = 0; k < other.count; k += 59)
            assert_root(&other.mode[k], nu, 50, 1500);
    }
    /* the waves beyond the conformal maps, omega of order 1/sqrt(1 + nu) */
    struct disk_mode mode;
    disk_mode_init(&mode);
    near_end(nu, -1, 30);
    for (slong n = 0; n <= 3; n++) {
        assert_int_equal(disk_mode_solve(&mode, nu, n, 4, 140), 0);
        assert_true(middle(mode.omega) > 1e15 && middle(mode.omega) < 1e17);
        assert_root(&mode, nu, 120, 600); /* a torsional mode is 100 bits away */
    }
    disk_mode_clear(&mode);
    disk_modes_clear(&modes);
    disk_modes_clear(&other);
}

/* No mode of any n >= cor_mode_orders(omega) is below omega, and not many n are looked at in vain. */
TEST(test_orders)
{
    static const char *const materials[] = {"99/100", "33/100", "0", "-9/10", "-999999/1000000"};
    LOCAL(fmpq, nu);
    LOCAL(arb, w);
    struct random_state random = random_start();
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++) {
        struct disk disk;
        set_nu(nu, materials[i]);
        disk_init(&disk, nu, 128);
        for (int k = 0; k < 40; k++) {
            const double omega = random_log(&random, 0.5, 500);
            const slong orders = cor_mode_orders(omega);
            assert_true((double)orders * (double)(orders - 1) >= 10 * omega * omega && (double)orders < 4 * omega + 4);
            arb_set_d(w, omega);
            arb_mul(w, w, w, 128);
            for (slong n = orders; n < orders + 3; n++)
                assert_int_equal(disk_count(&disk, n, w), 0);
        }
        disk_clear(&disk);
    }
}

/* The same numbers to the bit from any number of threads, and the same modes in more digits. */
TEST(test_threads_and_digits)
{
    struct disk_modes modes, other;
    modes_solve(&modes, "1/3", 150, 20);
    for (int threads = 2; threads <= 4; threads++) {
        parallel_use(threads);
        modes_solve(&other, "1/3", 150, 20);
        for (slong k = 0; k < modes.count; k++) {
            assert_same_mode(&modes.mode[k], &other.mode[k]);
            assert_true(arb_equal(modes.mode[k].omega, other.mode[k].omega));
            assert_true(arb_equal(modes.mode[k].c, other.mode[k].c));
            assert_true(arb_equal(modes.mode[k].s, other.mode[k].s));
        }
        disk_modes_clear(&other);
    }
    parallel_use(0);
    static const slong digits[] = {1, 15, 100, 700};
    for (size_t i = 0; i < sizeof digits / sizeof *digits; i++) {
        modes_solve(&other, "1/3", i < 3 ? 150 : 20, digits[i]);
        for (slong k = 0; k < other.count; k++) {
            assert_same_mode(&modes.mode[k], &other.mode[k]);
            assert_bits(other.mode[k].omega, digits[i] * 3);
            assert_bits(other.mode[k].c, digits[i] * 3);
        }
        disk_modes_clear(&other);
    }
    /* the lowest are the lowest, however many are asked for */
    for (slong count = 1; count < modes.count; count += count / 8 + 1) {
        modes_solve(&other, "1/3", count, 20);
        for (slong k = 0; k < count; k++)
            assert_same_mode(&modes.mode[k], &other.mode[k]);
        disk_modes_clear(&other);
    }
    disk_modes_clear(&modes);
}

RUN_TESTS(test_known, test_single_modes, test_near_pair, test_ritz, test_printed_equation, test_normalisation,
          test_sums, test_corners_of_nu, test_orders, test_threads_and_digits)
