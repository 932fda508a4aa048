/* SPDX-License-Identifier: MIT */
/* Every mode of generated/disk_modes_*.h again, by another route than the generator's: the printed equation (25) for
 * the frequency, (22) or (23) for the ratio of the amplitudes, Lommel's integrals of (26) for the normalisation, with
 * Bessel functions of Arb; the generator has none of them, but ratios of neighbouring orders. Each double must be the
 * one nearest to the exact number, and the modes as many as there are below the last. */
#include "ball.h"

#include "cor/disk.h"
#include "generated/disk_modes_nu033.h"
#include "generated/disk_modes_nu090.h"
#include "support/local.h"

enum { PREC = 320, STEPS = 3 /* chords */, ORDERS = 320 /* far above every kappa' of the tables */ };

static const struct {
    struct cor_disk_modes modes;
    slong nu_hundredths;
} table[] = {{COR_DISK_MODES_NU033, 33}, {COR_DISK_MODES_NU090, 90}};

/* J_n-2 .. J_n+2 at a place z, [2] being J_n, and z J_n'(z). */
struct bessel {
    arb_t z, d;
    arb_struct j[5];
};

static void bessel_init(struct bessel *b)
{
    arb_init(b->z);
    arb_init(b->d);
    for (int i = 0; i < 5; i++)
        arb_init(&b->j[i]);
}

static void bessel_clear(struct bessel *b)
{
    arb_clear(b->z);
    arb_clear(b->d);
    for (int i = 0; i < 5; i++)
        arb_clear(&b->j[i]);
}

/* With the bits that the series loses at large z. Where J_n is small, below n, the series of a ball are as narrow as
 * the ball; beyond, they are exp(z) wider, but no J_n is steeper than 1. */
static void bessel_j(arb_t j, slong n, const arb_t z)
{
    LOCAL(arb, order, middle);
    arb_set_si(order, n);
    arb_get_mid_arb(middle, z);
    const slong whole = arf_get_si(arb_midref(middle), ARF_RND_UP);
    arb_hypgeom_bessel_j(j, order, whole < n ? z : middle, PREC + 2 * whole);
    if (whole >= n)
        arb_add_error_mag(j, arb_radref(z));
}

static void bessel_set(struct bessel *b, slong n)
{
    LOCAL(arb, t);
    bessel_j(&b->j[2], n, b->z);
    bessel_j(&b->j[3], n + 1, b->z);
    for (slong i = 1; i >= 0; i--) { /* J_m-1 = (2m/z) J_m - J_m+1 */
        arb_mul_si(&b->j[i], &b->j[i + 1], 2 * (n - 1 + i), PREC);
        arb_div(&b->j[i], &b->j[i], b->z, PREC);
        arb_sub(&b->j[i], &b->j[i], &b->j[i + 2], PREC);
    }
    arb_mul_si(&b->j[4], &b->j[3], 2 * (n + 1), PREC);
    arb_div(&b->j[4], &b->j[4], b->z, PREC);
    arb_sub(&b->j[4], &b->j[4], &b->j[2], PREC);
    arb_mul(b->d, b->z, &b->j[1], PREC); /* z J_n' = z J_n-1 - n J_n, (24) */
    arb_mul_si(t, &b->j[2], n, PREC);
    arb_sub(b->d, b->d, t, PREC);
}

struct material {
    arb_t nu, s, kappa_per_omega, kappa1_per_omega;
};

static void material_init(struct material *m, slong nu_hundredths)
{
    arb_init(m->nu);
    arb_init(m->s);
    arb_init(m->kappa_per_omega);
    arb_init(m->kappa1_per_omega);
    arb_set_si(m->nu, nu_hundredths);
    arb_div_si(m->nu, m->nu, 100, PREC);
    arb_sub_si(m->s, m->nu, 1, PREC);
    arb_neg(m->s, m->s);
    arb_mul(m->kappa_per_omega, m->nu, m->nu, PREC); /* (18) */
    arb_sub_si(m->kappa_per_omega, m->kappa_per_omega, 1, PREC);
    arb_neg(m->kappa_per_omega, m->kappa_per_omega);
    arb_sqrt(m->kappa_per_omega, m->kappa_per_omega, PREC);
    arb_add_si(m->kappa1_per_omega, m->nu, 1, PREC);
    arb_mul_2exp_si(m->kappa1_per_omega, m->kappa1_per_omega, 1);
    arb_sqrt(m->kappa1_per_omega, m->kappa1_per_omega, PREC);
}

static void material_clear(struct material *m)
{
    arb_clear(m->nu);
    arb_clear(m->s);
    arb_clear(m->kappa_per_omega);
    arb_clear(m->kappa1_per_omega);
}

/* The left side of (25), of (20) for n = 0; fills k = kappa, k1 = kappa'. */
static void equation(arb_t f, struct bessel *k, struct bessel *k1, const struct material *m, slong n, const arb_t omega)
{
    arb_mul(k->z, omega, m->kappa_per_omega, PREC);
    arb_mul(k1->z, omega, m->kappa1_per_omega, PREC);
    bessel_set(k, n);
    if (n == 0) { /* kappa J_1' + nu J_1 = kappa J_0 - (1 - nu) J_1 */
        arb_mul(f, k->z, &k->j[2], PREC);
        arb_submul(f, m->s, &k->j[3], PREC);
        return;
    }
    bessel_set(k1, n);
    LOCAL(arb, a, b, kk);
    arb_mul(kk, k->z, k->z, PREC);
    /* (1-nu)^2 (1-n^2) kappa kappa' J_n-1(kappa) J_n-1(kappa') */
    arb_mul(f, k->z, &k->j[1], PREC);
    arb_mul(a, k1->z, &k1->j[1], PREC);
    arb_mul(b, f, &k1->j[2], PREC);
    arb_addmul(b, a, &k->j[2], PREC); /* kappa J_n-1(kappa) J_n(kappa') + kappa' J_n-1(kappa') J_n(kappa) */
    arb_mul(f, f, a, PREC);
    arb_mul(f, f, m->s, PREC);
    arb_mul_si(f, f, 1 - n * n, PREC);
    arb_mul_si(a, m->s, -(1 - n * n) * n, PREC);
    arb_add(a, a, kk, PREC); /* kappa^2 - (1-nu)(1-n^2) n */
    arb_addmul(f, a, b, PREC);
    arb_mul(f, f, m->s, PREC);
    arb_mul_si(a, m->s, -2 * (n * n + n), PREC);
    arb_add(a, a, kk, PREC);
    arb_mul(a, a, kk, PREC); /* kappa^4 - 2 (n^2+n)(1-nu) kappa^2 */
    arb_mul(a, a, &k->j[2], PREC);
    arb_addmul(f, a, &k1->j[2], PREC);
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
static void find_root(arb_t omega, struct bessel *k, struct bessel *k1, const struct material *m,
                      const struct cor_disk_mode *mode)
{
    arb_t end[2], f[2], at;
    arb_init(at);
    for (int i = 0; i < 2; i++) {
        arb_init(end[i]);
        arb_init(f[i]);
        half_way(end[i], mode->omega, i ? HUGE_VAL : 0);
        equation(f[i], k, k1, m, mode->n, end[i]);
    }
    if (arb_contains_zero(f[0]) || arb_contains_zero(f[1]) || arb_is_positive(f[0]) == arb_is_positive(f[1]))
        fail_msg("omega of (%d,%d) is not the double nearest to a root", mode->n, mode->l);
    const int rises = arb_is_positive(f[1]);
    static const slong root_bits[STEPS] = {76, 130, 180};
    for (int step = 0; step < STEPS; step++) {
        arb_sub(f[1], f[1], f[0], PREC);
        arb_div(f[0], f[0], f[1], PREC);
        arb_sub(at, end[0], end[1], PREC);
        arb_addmul(end[0], f[0], at, PREC); /* the chord's zero, and its neighbours, between which the sign changes */
        arb_get_mid_arb(omega, end[0]);
        for (int i = 0; i < 2; i++) {
            arb_mul_2exp_si(at, omega, -root_bits[step]);
            (i ? arb_add : arb_sub)(end[i], omega, at, PREC);
            equation(f[i], k, k1, m, mode->n, end[i]);
            if (i == rises ? !arb_is_positive(f[i]) : !arb_is_negative(f[i]))
                fail_msg("omega of (%d,%d) is not enclosed", mode->n, mode->l);
        }
    }
    arb_union(omega, end[0], end[1], PREC);
    arb_clear(at);
    for (int i = 0; i < 2; i++) {
        arb_clear(end[i]);
        arb_clear(f[i]);
    }
}

/* int_0^1 r J(a r) J(b r) dr, both of the order of j[o]: Lommel. */
static void lommel(arb_t x, const struct bessel *a, const struct bessel *b, int o)
{
    LOCAL(arb, t);
    if (a == b) {
        arb_mul(x, &a->j[o], &a->j[o], PREC);
        arb_submul(x, &a->j[o - 1], &a->j[o + 1], PREC);
        arb_mul_2exp_si(x, x, -1);
    } else {
        arb_mul(x, b->z, &b->j[o - 1], PREC);
        arb_mul(x, x, &a->j[o], PREC);
        arb_mul(t, a->z, &a->j[o - 1], PREC);
        arb_submul(x, t, &b->j[o], PREC);
        arb_mul(t, a->z, a->z, PREC);
        arb_submul(t, b->z, b->z, PREC);
        arb_div(x, x, t, PREC);
    }
}

/* A and B of (22) or (23), whichever determines them better. */
static void amplitudes(arb_t a, arb_t b, const struct bessel *k, const struct bessel *k1, const struct material *m,
                       slong n)
{
    LOCAL(arb, a2, b2, t);
    /* (22): -A [s kappa J' + (kappa^2 - s n^2) J] + n B s [kappa' J' - J] = 0 */
    arb_sub(a, k1->d, &k1->j[2], PREC);
    arb_mul(a, a, m->s, PREC);
    arb_mul_si(a, a, n, PREC);
    arb_mul(b, m->s, k->d, PREC);
    arb_mul_si(t, m->s, -n * n, PREC);
    arb_addmul(t, k->z, k->z, PREC);
    arb_addmul(b, t, &k->j[2], PREC);
    /* (23): -2 n A [kappa J' - J] + B [2 kappa' J' + (kappa'^2 - 2 n^2) J] = 0 */
    arb_mul_2exp_si(a2, k1->d, 1);
    arb_mul(t, k1->z, k1->z, PREC);
    arb_sub_si(t, t, 2 * n * n, PREC);
    arb_addmul(a2, t, &k1->j[2], PREC);
    arb_sub(b2, k->d, &k->j[2], PREC);
    arb_mul_si(b2, b2, 2 * n, PREC);
    if (arb_rel_accuracy_bits(a2) + arb_rel_accuracy_bits(b2) > arb_rel_accuracy_bits(a) + arb_rel_accuracy_bits(b)) {
        arb_swap(a, a2);
        arb_swap(b, b2);
    }
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
    struct bessel k, k1;
    LOCAL(arb, omega, a, b, c, s, norm, t);
    bessel_init(&k);
    bessel_init(&k1);
    const slong n = mode->n;
    find_root(omega, &k, &k1, m, mode);
    equation(t, &k, &k1, m, n, omega);
    if (n > 0)
        amplitudes(a, b, &k, &k1, m, n);
    else
        arb_one(a);
    arb_mul(c, a, k.d, PREC); /* (19) at r = 1 */
    arb_mul(s, b, k1.d, PREC);
    if (n > 0) {
        arb_mul(t, b, &k1.j[2], PREC);
        arb_addmul_si(c, t, n, PREC);
        arb_mul(t, a, &k.j[2], PREC);
        arb_addmul_si(s, t, n, PREC);
    }
    arb_neg(s, s);
    /* u_r - u_phi = A kappa J_n-1(kappa r) + B kappa' J_n-1(kappa' r), and -A, B with J_n+1 for the sum: the integral
     * is half that of both squares */
    arb_mul(a, a, k.z, PREC);
    if (n > 0)
        arb_mul(b, b, k1.z, PREC);
    for (int o = 1; o <= 3; o += 2) {
        lommel(t, &k, &k, o);
        arb_mul(t, t, a, PREC);
        arb_addmul(norm, t, a, PREC);
        if (n == 0)
            continue;
        lommel(t, &k1, &k1, o);
        arb_mul(t, t, b, PREC);
        arb_addmul(norm, t, b, PREC);
        lommel(t, &k, &k1, o);
        arb_mul(t, t, a, PREC);
        arb_mul(t, t, b, PREC);
        arb_mul_si(t, t, o == 1 ? 2 : -2, PREC);
        arb_add(norm, norm, t, PREC);
    }
    if (n > 0)
        arb_mul_2exp_si(norm, norm, -1); /* int = 1, and 1/2 for n = 0 */
    arb_sqrt(norm, norm, PREC);
    arb_div(c, c, norm, PREC);
    arb_div(s, s, norm, PREC);
    if (arb_is_negative(c)) { /* the sign is a convention */
        arb_neg(c, c);
        arb_neg(s, s);
    }
    assert_nearest(mode->c, c, "C", mode);
    if (n > 0)
        assert_nearest(mode->s, s, "S", mode);
    else
        assert_true(mode->s == 0);
    bessel_clear(&k);
    bessel_clear(&k1);
}

TEST(every_mode)
{
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct material m;
        material_init(&m, table[i].nu_hundredths);
        for (size_t k = 0; k < table[i].modes.count; k++)
            if (in_turn(k, 3))
                check_mode(&m, &table[i].modes.mode[k]);
        material_clear(&m);
    }
}

/* ---- none is missing ---- */

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

/* docs/derivation.md, (11.3) */
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
        material_init(&m, table[i].nu_hundredths);
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

RUN_TESTS(every_mode, none_is_missing)
