/* SPDX-License-Identifier: MIT */
/* Free modes of the disk and every mode of generated/disk_modes_*.h: known values, the count against a Rayleigh-Ritz
 * discretisation, the printed equation (25) and the integrals of (26) with Bessel functions of Arb, and the corners of
 * nu. */
#include "ball.h"

#include "cor/disk.h"
#include "disk/equation.h"
#include "disk/modes.h"
#include "generated/disk_modes_nu033.h"
#include "generated/disk_modes_nu090.h"
#include "runtime/disk/mode_source.h"
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
    modes_solve(&modes[0], "33/100", 5, 17);
    modes_solve(&modes[1], "9/10", 5, 17);
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

/* ---- (25) as printed, with Bessel functions of Arb; the generator has ratios of neighbouring orders ---- */

/* J_n-2 .. J_n+2 at a place z, [2] being J_n, and z J_n'(z). */
struct bessel {
    arb_t z, d;
    arb_struct j[5];
};

static void bessel_init(struct bessel *b)
{
    FOR_ALL(arb, init, b->z, b->d, &b->j[0], &b->j[1], &b->j[2], &b->j[3], &b->j[4]);
}

static void bessel_clear(struct bessel *b)
{
    FOR_ALL(arb, clear, b->z, b->d, &b->j[0], &b->j[1], &b->j[2], &b->j[3], &b->j[4]);
}

/* With the bits that the series loses at large z. Where J_n is small, below n, the series of a ball are as narrow as
 * the ball; beyond, they are exp(z) wider, but no J_n is steeper than 1. */
static void bessel_j(arb_t j, slong n, const arb_t z, slong prec)
{
    LOCAL(arb, order, middle);
    arb_set_si(order, n);
    arb_get_mid_arb(middle, z);
    const slong whole = arf_get_si(arb_midref(middle), ARF_RND_UP);
    arb_hypgeom_bessel_j(j, order, whole < n ? z : middle, prec + 2 * whole);
    if (whole >= n)
        arb_add_error_mag(j, arb_radref(z));
}

static void bessel_set(struct bessel *b, slong n, slong prec)
{
    LOCAL(arb, t);
    bessel_j(&b->j[2], n, b->z, prec);
    bessel_j(&b->j[3], n + 1, b->z, prec);
    for (slong i = 1; i >= 0; i--) { /* J_m-1 = (2m/z) J_m - J_m+1 */
        arb_mul_si(&b->j[i], &b->j[i + 1], 2 * (n - 1 + i), prec);
        arb_div(&b->j[i], &b->j[i], b->z, prec);
        arb_sub(&b->j[i], &b->j[i], &b->j[i + 2], prec);
    }
    arb_mul_si(&b->j[4], &b->j[3], 2 * (n + 1), prec);
    arb_div(&b->j[4], &b->j[4], b->z, prec);
    arb_sub(&b->j[4], &b->j[4], &b->j[2], prec);
    arb_mul(b->d, b->z, &b->j[1], prec); /* z J_n' = z J_n-1 - n J_n, (24) */
    arb_mul_si(t, &b->j[2], n, prec);
    arb_sub(b->d, b->d, t, prec);
}

struct material {
    slong prec;
    arb_t nu, s, kappa_per_omega, kappa1_per_omega;
};

static void material_init(struct material *m, const fmpq_t nu, slong prec)
{
    m->prec = prec;
    FOR_ALL(arb, init, m->nu, m->s, m->kappa_per_omega, m->kappa1_per_omega);
    arb_set_fmpq(m->nu, nu, prec);
    arb_sub_si(m->s, m->nu, 1, prec);
    arb_neg(m->s, m->s);
    arb_mul(m->kappa_per_omega, m->nu, m->nu, prec); /* (18) */
    arb_sub_si(m->kappa_per_omega, m->kappa_per_omega, 1, prec);
    arb_neg(m->kappa_per_omega, m->kappa_per_omega);
    arb_sqrt(m->kappa_per_omega, m->kappa_per_omega, prec);
    arb_add_si(m->kappa1_per_omega, m->nu, 1, prec);
    arb_mul_2exp_si(m->kappa1_per_omega, m->kappa1_per_omega, 1);
    arb_sqrt(m->kappa1_per_omega, m->kappa1_per_omega, prec);
}

static void material_clear(struct material *m)
{
    FOR_ALL(arb, clear, m->nu, m->s, m->kappa_per_omega, m->kappa1_per_omega);
}

/* The left side of (25), of (20) for n = 0; fills k = kappa, k1 = kappa'. */
static void equation(arb_t f, struct bessel *k, struct bessel *k1, const struct material *m, slong n, const arb_t omega)
{
    arb_mul(k->z, omega, m->kappa_per_omega, m->prec);
    arb_mul(k1->z, omega, m->kappa1_per_omega, m->prec);
    bessel_set(k, n, m->prec);
    if (n == 0) { /* kappa J_1' + nu J_1 = kappa J_0 - (1 - nu) J_1 */
        arb_mul(f, k->z, &k->j[2], m->prec);
        arb_submul(f, m->s, &k->j[3], m->prec);
        return;
    }
    bessel_set(k1, n, m->prec);
    LOCAL(arb, a, b, kk);
    arb_mul(kk, k->z, k->z, m->prec);
    /* (1-nu)^2 (1-n^2) kappa kappa' J_n-1(kappa) J_n-1(kappa') */
    arb_mul(f, k->z, &k->j[1], m->prec);
    arb_mul(a, k1->z, &k1->j[1], m->prec);
    arb_mul(b, f, &k1->j[2], m->prec);
    arb_addmul(b, a, &k->j[2], m->prec); /* kappa J_n-1(kappa) J_n(kappa') + kappa' J_n-1(kappa') J_n(kappa) */
    arb_mul(f, f, a, m->prec);
    arb_mul(f, f, m->s, m->prec);
    arb_mul_si(f, f, 1 - n * n, m->prec);
    arb_mul_si(a, m->s, -(1 - n * n) * n, m->prec);
    arb_add(a, a, kk, m->prec); /* kappa^2 - (1-nu)(1-n^2) n */
    arb_addmul(f, a, b, m->prec);
    arb_mul(f, f, m->s, m->prec);
    arb_mul_si(a, m->s, -2 * (n * n + n), m->prec);
    arb_add(a, a, kk, m->prec);
    arb_mul(a, a, kk, m->prec); /* kappa^4 - 2 (n^2+n)(1-nu) kappa^2 */
    arb_mul(a, a, &k->j[2], m->prec);
    arb_addmul(f, a, &k1->j[2], m->prec);
}

/* (25) vanishes at omega: it changes sign within the relative distance 2^-bits. */
static void assert_root(const struct disk_mode *mode, const fmpq_t nu, slong bits, slong prec)
{
    struct material m;
    struct bessel k, k1;
    LOCAL(arb, omega, below, above);
    material_init(&m, nu, prec);
    bessel_init(&k);
    bessel_init(&k1);
    for (int side = 0; side < 2; side++) {
        arb_set_si(omega, side ? 1 : -1);
        arb_mul_2exp_si(omega, omega, -bits);
        arb_add_si(omega, omega, 1, prec);
        arb_mul(omega, omega, mode->omega, prec);
        mag_zero(arb_radref(omega));
        equation(side ? above : below, &k, &k1, &m, mode->n, omega);
    }
    check(!arb_contains_zero(below) && !arb_contains_zero(above) && arb_is_positive(below) != arb_is_positive(above),
          "n = %ld, l = %ld", (long)mode->n, (long)mode->l);
    bessel_clear(&k);
    bessel_clear(&k1);
    material_clear(&m);
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

/* ---- C and S: (22) or (23) for the ratio of the amplitudes, Lommel's integrals of (26) ---- */

/* int_0^1 r J(a r) J(b r) dr, both of the order of j[o]: Lommel. */
static void lommel(arb_t x, const struct bessel *a, const struct bessel *b, int o, slong prec)
{
    LOCAL(arb, t);
    if (a == b) {
        arb_mul(x, &a->j[o], &a->j[o], prec);
        arb_submul(x, &a->j[o - 1], &a->j[o + 1], prec);
        arb_mul_2exp_si(x, x, -1);
    } else {
        arb_mul(x, b->z, &b->j[o - 1], prec);
        arb_mul(x, x, &a->j[o], prec);
        arb_mul(t, a->z, &a->j[o - 1], prec);
        arb_submul(x, t, &b->j[o], prec);
        arb_mul(t, a->z, a->z, prec);
        arb_submul(t, b->z, b->z, prec);
        arb_div(x, x, t, prec);
    }
}

/* A and B of (22) or (23), whichever determines them better. */
static void amplitudes(arb_t a, arb_t b, const struct bessel *k, const struct bessel *k1, const struct material *m,
                       slong n)
{
    LOCAL(arb, a2, b2, t);
    /* (22): -A [s kappa J' + (kappa^2 - s n^2) J] + n B s [kappa' J' - J] = 0 */
    arb_sub(a, k1->d, &k1->j[2], m->prec);
    arb_mul(a, a, m->s, m->prec);
    arb_mul_si(a, a, n, m->prec);
    arb_mul(b, m->s, k->d, m->prec);
    arb_mul_si(t, m->s, -n * n, m->prec);
    arb_addmul(t, k->z, k->z, m->prec);
    arb_addmul(b, t, &k->j[2], m->prec);
    /* (23): -2 n A [kappa J' - J] + B [2 kappa' J' + (kappa'^2 - 2 n^2) J] = 0 */
    arb_mul_2exp_si(a2, k1->d, 1);
    arb_mul(t, k1->z, k1->z, m->prec);
    arb_sub_si(t, t, 2 * n * n, m->prec);
    arb_addmul(a2, t, &k1->j[2], m->prec);
    arb_sub(b2, k->d, &k->j[2], m->prec);
    arb_mul_si(b2, b2, 2 * n, m->prec);
    if (arb_rel_accuracy_bits(a2) + arb_rel_accuracy_bits(b2) > arb_rel_accuracy_bits(a) + arb_rel_accuracy_bits(b)) {
        arb_swap(a, a2);
        arb_swap(b, b2);
    }
}

/* C and S at a frequency, C > 0 */
static void rim_amplitudes(arb_t c, arb_t s, const struct material *m, slong n, const arb_t omega)
{
    struct bessel k, k1;
    LOCAL(arb, a, b, norm, t);
    bessel_init(&k);
    bessel_init(&k1);
    equation(t, &k, &k1, m, n, omega);
    if (n > 0)
        amplitudes(a, b, &k, &k1, m, n);
    else
        arb_one(a);
    arb_mul(c, a, k.d, m->prec); /* (19) at r = 1 */
    arb_mul(s, b, k1.d, m->prec);
    if (n > 0) {
        arb_mul(t, b, &k1.j[2], m->prec);
        arb_addmul_si(c, t, n, m->prec);
        arb_mul(t, a, &k.j[2], m->prec);
        arb_addmul_si(s, t, n, m->prec);
    }
    arb_neg(s, s);
    /* u_r - u_phi = A kappa J_n-1(kappa r) + B kappa' J_n-1(kappa' r), and -A, B with J_n+1 for the sum: the integral
     * is half that of both squares */
    arb_mul(a, a, k.z, m->prec);
    if (n > 0)
        arb_mul(b, b, k1.z, m->prec);
    for (int o = 1; o <= 3; o += 2) {
        lommel(t, &k, &k, o, m->prec);
        arb_mul(t, t, a, m->prec);
        arb_addmul(norm, t, a, m->prec);
        if (n == 0)
            continue;
        lommel(t, &k1, &k1, o, m->prec);
        arb_mul(t, t, b, m->prec);
        arb_addmul(norm, t, b, m->prec);
        lommel(t, &k, &k1, o, m->prec);
        arb_mul(t, t, a, m->prec);
        arb_mul(t, t, b, m->prec);
        arb_mul_si(t, t, o == 1 ? 2 : -2, m->prec);
        arb_add(norm, norm, t, m->prec);
    }
    if (n > 0)
        arb_mul_2exp_si(norm, norm, -1); /* int = 1, and 1/2 for n = 0 */
    arb_sqrt(norm, norm, m->prec);
    arb_div(c, c, norm, m->prec);
    arb_div(s, s, norm, m->prec);
    if (arb_is_negative(c)) { /* the sign is a convention */
        arb_neg(c, c);
        arb_neg(s, s);
    }
    bessel_clear(&k);
    bessel_clear(&k1);
}

TEST(test_amplitudes)
{
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
        LOCAL(fmpq, nu);
        LOCAL(arb, c, s);
        struct material m;
        struct disk_mode mode;
        disk_mode_init(&mode);
        set_nu(nu, cases[i].nu);
        material_init(&m, nu, 300);
        assert_int_equal(disk_mode_solve(&mode, nu, cases[i].n, cases[i].l, 150), 0);
        rim_amplitudes(c, s, &m, cases[i].n, mode.omega);
        assert_bits(c, 80);
        assert_bits(mode.c, 80);
        assert_overlap(mode.c, c, "C of case", (slong)i);
        if (cases[i].n > 0)
            assert_overlap(mode.s, s, "S of case", (slong)i);
        material_clear(&m);
        disk_mode_clear(&mode);
    }
}

/* ---- the tables of the library: each double is the nearest to the exact number, and none is missing ---- */

enum { PREC = 320, STEPS = 3 /* chords */, ORDERS = 320 /* far above every kappa' of the tables */ };

static const struct {
    struct cor_disk_modes modes;
    const char *nu;
} table[] = {{COR_DISK_MODES_NU033, "33/100"}, {COR_DISK_MODES_NU090, "9/10"}};

static void table_material(struct material *m, size_t i)
{
    LOCAL(fmpq, nu);
    set_nu(nu, table[i].nu);
    material_init(m, nu, PREC);
}

/* Half way to the double next to x, exactly. */
static void half_way(arb_t y, double x, double towards)
{
    LOCAL(arb, t);
    arb_set_d(y, x);
    arb_set_d(t, nextafter(x, towards));
    arb_add(y, y, t, PREC);
    arb_mul_2exp_si(y, y, -1);
}

/* Proves that the double is the nearest to a root, and encloses that to 180 bits. */
static void find_root(arb_t omega, const struct material *m, const struct cor_disk_mode *mode)
{
    struct bessel k, k1;
    arb_t end[2], f[2], at;
    bessel_init(&k);
    bessel_init(&k1);
    FOR_ALL(arb, init, end[0], end[1], f[0], f[1], at);
    for (int i = 0; i < 2; i++) {
        half_way(end[i], mode->omega, i ? HUGE_VAL : 0);
        equation(f[i], &k, &k1, m, mode->n, end[i]);
    }
    if (arb_contains_zero(f[0]) || arb_contains_zero(f[1]) || arb_is_positive(f[0]) == arb_is_positive(f[1]))
        fail_msg("omega of (%d,%d) is not the double nearest to a root", mode->n, mode->l);
    const int rises = arb_is_positive(f[1]);
    static const slong root_bits[STEPS] = {76, 130, 180};
    for (int step = 0; step < STEPS; step++) {
        arb_sub(f[1], f[1], f[0], m->prec);
        arb_div(f[0], f[0], f[1], m->prec);
        arb_sub(at, end[0], end[1], m->prec);
        arb_addmul(end[0], f[0], at,
                   m->prec); /* the chord's zero, and its neighbours, between which the sign changes */
        arb_get_mid_arb(omega, end[0]);
        for (int i = 0; i < 2; i++) {
            arb_mul_2exp_si(at, omega, -root_bits[step]);
            (i ? arb_add : arb_sub)(end[i], omega, at, m->prec);
            equation(f[i], &k, &k1, m, mode->n, end[i]);
            if (i == rises ? !arb_is_positive(f[i]) : !arb_is_negative(f[i]))
                fail_msg("omega of (%d,%d) is not enclosed", mode->n, mode->l);
        }
    }
    arb_union(omega, end[0], end[1], m->prec);
    bessel_clear(&k);
    bessel_clear(&k1);
    FOR_ALL(arb, clear, end[0], end[1], f[0], f[1], at);
}

static void assert_nearest(double x, const arb_t exact, const char *what, const struct cor_disk_mode *mode)
{
    LOCAL(arb, low, high);
    half_way(low, x, -HUGE_VAL);
    half_way(high, x, HUGE_VAL);
    if (!arb_gt(exact, low) || !arb_lt(exact, high)) {
        arb_fprintn(stderr, exact, 40, 0);
        fail_msg(" is not nearest to %.17g, %s of (%d,%d)", x, what, mode->n, mode->l);
    }
}

static void check_mode(const struct material *m, const struct cor_disk_mode *mode)
{
    LOCAL(arb, omega, c, s);
    find_root(omega, m, mode);
    rim_amplitudes(c, s, m, mode->n, omega);
    assert_nearest(mode->c, c, "C", mode);
    if (mode->n > 0)
        assert_nearest(mode->s, s, "S", mode);
    else
        assert_true(mode->s == 0);
}

TEST(every_mode)
{
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct material m;
        table_material(&m, i);
        for (size_t k = 0; k < table[i].modes.count; k++)
            if (in_turn(k, 3))
                check_mode(&m, &table[i].modes.mode[k]);
        material_clear(&m);
    }
}

static void sequence(arb_ptr j, const arb_t z)
{
    /* an exact place, for the high orders are tiny */
    LOCAL(arb, place, order);
    arb_get_mid_arb(place, z);
    for (slong n = 0; n < ORDERS; n++) {
        arb_set_si(order, n);
        arb_hypgeom_bessel_j(j + n, order, place, PREC);
    }
}

/* Zeros of J_n below z: those of neighbouring orders interlace, and J_m has none for m > z. */
static slong zeros(arb_srcptr j, slong n)
{
    slong count = 0;
    for (; n + 1 < ORDERS; n++) {
        assert_false(arb_contains_zero(j + n));
        count += arb_is_positive(j + n) != arb_is_positive(j + n + 1);
    }
    return count;
}

/* Negative eigenvalues of [[a, b], [b, d]]. */
static slong negative(double a, double b, double d)
{
    const double determinant = a * d - b * b;
    return determinant < 0 ? 1 : a < 0 ? 2 : 0;
}

/* z J_n'/J_n, in double: the matrices are far from singular between modes. */
static double logarithmic(arb_srcptr j, slong n, const arb_t z)
{
    LOCAL(arb, t);
    arb_div(t, j + n + 1, j + n, PREC);
    arb_mul(t, t, z, PREC);
    const double ratio = arf_get_d(arb_midref(t), ARF_RND_NEAR);
    return (double)n - ratio;
}

/* docs/theory-disks.md, (11.3) */
static slong count_below(const struct material *m, double omega)
{
    arb_ptr j = _arb_vec_init(ORDERS), j1 = _arb_vec_init(ORDERS);
    LOCAL(arb, z, z1);
    arb_set_d(z, omega);
    arb_mul(z1, z, m->kappa1_per_omega, PREC);
    arb_mul(z, z, m->kappa_per_omega, PREC);
    sequence(j, z);
    sequence(j1, z1);
    const double nu = arf_get_d(arb_midref(m->nu), ARF_RND_NEAR), g = omega * omega * (1 + nu);
    slong count = zeros(j, 0);
    const double radial = -g / logarithmic(j, 0, z);
    count += (radial - 1 < 0) - (radial < 0);
    for (slong n = 1; n < ORDERS - 1; n++) {
        const double x = logarithmic(j, n, z), y = logarithmic(j1, n, z1), order = (double)n;
        const double factor = -g / (x * y - order * order);
        count += 1 + zeros(j, n) + zeros(j1, n) + negative(factor * y - 1, (factor - 1) * order, factor * x - 1) -
                 negative(factor * y, factor * order, factor * x);
    }
    _arb_vec_clear(j, ORDERS);
    _arb_vec_clear(j1, ORDERS);
    return count;
}

TEST(none_is_missing)
{
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct material m;
        table_material(&m, i);
        const struct cor_disk_modes *const t = &table[i].modes;
        int next[ORDERS] = {0}; /* l counts from 0 without a gap */
        for (size_t k = 0; k < t->count; k++) {
            const struct cor_disk_mode *const mode = &t->mode[k];
            assert_in_range(mode->n, 0, ORDERS - 1);
            check(mode->l == next[mode->n]++ && (k == 0 || mode->omega > mode[-1].omega), "(%d,%d) is out of turn",
                  mode->n, mode->l);
        }
        const size_t places[] = {1, 2, 10, 137, 1000, t->count - 1};
        for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
            const double below = t->mode[places[k] - 1].omega, here = t->mode[places[k]].omega;
            /* the translation is counted too */
            assert_int_equal(count_below(&m, (below + here) / 2), (slong)places[k] + 1);
        }
        const double last = t->mode[t->count - 1].omega;
        assert_int_equal(count_below(&m, last * (1 + 1e-9)), (slong)t->count + 1);
        material_clear(&m);
    }
}

/* All modes of a material that has no table, against those in double arithmetic, whose sums unit.disk_mode_source knows
 */
TEST(test_against_doubles)
{
    leave_to_turn(1, 3);
    enum { COUNT = 4000 };
    static struct cor_disk_mode mode[COUNT];
    struct cor_disk_modes in_doubles;
    struct disk_modes modes;
    modes_solve(&modes, "-1/2", COUNT, 15);
    assert_int_equal(cor_disk_modes_compute(-0.5, COUNT, mode, &in_doubles), 0);
    for (int k = 0; k < COUNT; k++) {
        const struct disk_mode *const exact = &modes.mode[k];
        const double omega = middle(exact->omega), c = middle(exact->c), s = middle(exact->s);
        const double most = COR_DISK_MODES_AMPLITUDE_MAX_ERROR * hypot(c, s);
        check(exact->n == mode[k].n && exact->l == mode[k].l &&
                  fabs(mode[k].omega - omega) <= COR_DISK_MODES_OMEGA_MAX_ERROR * omega &&
                  fabs(mode[k].c - c) <= most && fabs(mode[k].s - s) <= most,
              "(%d, %d)", mode[k].n, mode[k].l);
    }
    disk_modes_clear(&modes);
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

RUN_TESTS(test_known, test_single_modes, test_near_pair, test_ritz, test_printed_equation, test_amplitudes, every_mode,
          none_is_missing, test_against_doubles, test_corners_of_nu, test_orders, test_threads_and_digits)
