/* SPDX-License-Identifier: MIT */
/* Tests free modes of the disk, and every mode of generated/disk_modes_*.h. A Rayleigh-Ritz discretisation checks the
 * count of modes. The modes must satisfy the printed equation (25) and the integrals of (26) with Bessel functions of
 * Arb, also at extreme nu. */
#include "ball.h"

#include "cor/disk.h"
#include "disk/modes.h"
#include "generated/disk_modes_nu033.h"
#include "generated/disk_modes_nu090.h"
#include "runtime/disk/mode_source.h"
#include "support/local.h"
#include "support/parallel.h"

LOCAL_STRUCT(disk_mode)
LOCAL_STRUCT(disk_modes)

static void set_nu(fmpq_t nu, const char *text)
{
    assert_int_equal(fmpq_set_str(nu, text, 10), 0);
    fmpq_canonicalise(nu);
}

static void modes_solve(struct disk_modes *modes, const char *text, slong count, slong digits)
{
    LOCAL(fmpq, nu);
    set_nu(nu, text);
    assert_int_equal(disk_modes_solve(modes, nu, count, digits), 0);
    assert_int_equal(modes->count, count);
}

/* ---- one mode, found by counting eigenvalues ---- */

static void assert_same_mode(const struct disk_mode *a, const struct disk_mode *b)
{
    assert_int_equal(a->n, b->n);
    assert_int_equal(a->l, b->l);
    assert_overlap(a->omega, b->omega, "omega of n", a->n);
    assert_overlap(a->c, b->c, "C of n", a->n);
    assert_overlap(a->s, b->s, "S of n", a->n);
}

/* Two roots of n = 1 with a relative gap of 4.2e-4: both are found, and none is missing between or next to them. */
TEST(test_near_pair)
{
    LOCAL(fmpq, nu);
    LOCAL(disk_mode, low, high);
    set_nu(nu, "33/100");
    assert_int_equal(disk_mode_solve(low, nu, 1, 50, 0, 100), 0);
    assert_int_equal(disk_mode_solve(high, nu, 1, 51, 0, 100), 0);
    const double first = middle(low->omega), second = middle(high->omega), gap = second / first - 1;
    check(gap > 4.1e-4 && gap < 4.3e-4, "gap %g", gap);
    LOCAL(arb, w);
    LOCAL_INIT(disk, disk, (&disk, nu, 200));
    for (int i = 0; i < 4; i++) {
        arb_set_d(w, (i < 2 ? first : second) * (i % 2 ? 1 + 1e-9 : 1 - 1e-9));
        arb_sqr(w, w, 200);
        assert_int_equal(disk_count(&disk, 1, w), 50 + (i + 1) / 2);
    }
    /* Newton's method starts at the other root. A bracket that contains both roots proves neither. */
    assert_int_equal(disk_mode_solve(low, nu, 1, 50, second, 4), 0);
    assert_int_equal(disk_mode_solve(high, nu, 1, 51, first, 4), 0);
    assert_true(arb_lt(low->omega, high->omega));
}

/* (3,0) and (2,1) are modes number four and five, and at this nu so close that a few bits cannot separate them. */
TEST(test_crossing)
{
    LOCAL(disk_modes, modes);
    modes_solve(modes, "-6913351158580087868111061636728432469214/10000000000000000000000000000000000000000", 6, 1);
    assert_int_equal(modes->mode[3].n + modes->mode[4].n, 5);
    for (slong k = 1; k < modes->count; k++)
        assert_true(arb_lt(modes->mode[k - 1].omega, modes->mode[k].omega));
}

/* ---- Rayleigh-Ritz ---- */

/* Counts the negative eigenvalues of K - w M by LDL^T. The fields are (u_r, u_phi) = r^p (1, sigma): all fields with
 * this n that are polynomials in x and y up to a degree. The count never exceeds the number of modes below omega, rigid
 * ones included. It equals that number if the degree is high enough. */
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
    LOCAL_MATRIX(size, size, a);
    LOCAL(arb, x);
    for (slong i = 0; i < size; i++)
        for (slong j = 0; j < size; j++) {
            const slong p = field[i].p, q = field[j].p, sp = field[i].sigma, sq = field[j].sigma;
            const slong ring_p = 1 + n * sp, ring_q = 1 + n * sq;
            const slong shear = (sp * (p - 1) - n) * (sq * (q - 1) - n);
            const slong all = 2 * (p * q + ring_p * ring_q) + shear, of_nu = 2 * (p * ring_q + q * ring_p) - shear;
            /* (eps_rr eps_rr + eps_pp eps_pp + nu (..) + (1 - nu)/2 gamma gamma)/(p + q) */
            LET(x, RITZ_PREC, "all + of_nu*nu", all, of_nu, nu);
            if (p + q > 0)
                LET(x, RITZ_PREC, "x/(2*(p + q))", x, p, q);
            else
                assert_true(arb_contains_zero(x)); /* the translation */
            LET(arb_mat_entry(a, i, j), RITZ_PREC, "x - (1 - nu^2)*w*(1 + sp*sq)/(p + q + 2)", x, nu, w, sp, sq, p, q);
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
    return negative;
}

TEST(test_ritz)
{
    static const char *const materials[] = {"33/100", "9/10", "0", "-1/2", "-19/20"};
    static const slong orders[] = {0, 1, 2, 3, 7, 20};
    enum { PAIRS = 14, POINTS = 9 };
    for (size_t i = 0; i < COUNT_OF(materials); i++) {
        LOCAL(fmpq, nu);
        LOCAL(arb, w);
        set_nu(nu, materials[i]);
        LOCAL_INIT(disk, disk, (&disk, nu, 128));
        for (size_t k = 0; k < COUNT_OF(orders); k++) {
            const slong n = orders[k];
            for (int point = 0; point < POINTS; point++) {
                /* kappa' is at most n + 12, so the degree is high enough for all modes */
                const double omega = random_uniform(&draw, 0.1, 1) * ((double)n + 12) / sqrt(2 * disk.e_double);
                LET(w, RITZ_PREC, "omega^2", omega);
                const slong ritz = ritz_count(nu, n, w, PAIRS), count = disk_count(&disk, n, w);
                check(count + (n == 1) == ritz, "nu = %s, n = %ld, omega = %a: %ld, and %ld by Ritz", materials[i],
                      (long)n, omega, (long)count, (long)ritz);
                assert_true(ritz_count(nu, n, w, 3) <= ritz);
            }
        }
        /* Ritz frequencies are slightly above the roots */
        LOCAL(disk_mode, mode);
        for (slong n = 0; n <= 3; n++)
            for (slong l = 0; l <= 2; l++) {
                assert_int_equal(disk_mode_solve(mode, nu, n, l, 0, 120), 0);
                mag_zero(arb_radref(mode->omega));
                for (int side = -1; side <= 1; side += 2) {
                    LET(w, RITZ_PREC, "(mode->omega*(1 + side/10^15))^2", mode->omega, side);
                    assert_int_equal(ritz_count(nu, n, w, PAIRS), l + (side > 0) + (n == 1));
                }
            }
    }
}

/* ---- (25) as printed, with Bessel functions of Arb; the generator uses ratios of neighbouring orders ---- */

/* J_n-2 .. J_n+2 at z, where j[2] is J_n, and d = z J_n'(z). */
struct bessel {
    arb_t z, d, j[5];
};

static void bessel_init(struct bessel *b)
{
    FOR_ALL(arb, init, b->z, b->d, b->j[0], b->j[1], b->j[2], b->j[3], b->j[4]);
}

static void bessel_clear(struct bessel *b)
{
    FOR_ALL(arb, clear, b->z, b->d, b->j[0], b->j[1], b->j[2], b->j[3], b->j[4]);
}
LOCAL_STRUCT(bessel)

/* Computes J_n(z) with the additional bits that the series loses at large z. For z < n, where J_n is small, the series
 * of a ball is as narrow as the ball. For larger z it is exp(z) times wider, although no J_n is steeper than 1. */
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

/* Computes j by the recurrence J_m-1 = (2m/z) J_m - J_m+1, and d by (24). */
static void bessel_set(struct bessel *b, slong n, slong prec)
{
    bessel_j(b->j[2], n, b->z, prec);
    bessel_j(b->j[3], n + 1, b->z, prec);
    LET(b->j[1], prec, "2*n*b->j[2]/b->z - b->j[3]", n, b->j[2], b->z, b->j[3]);
    LET(b->j[0], prec, "2*(n - 1)*b->j[1]/b->z - b->j[2]", n, b->j[1], b->z, b->j[2]);
    LET(b->j[4], prec, "2*(n + 1)*b->j[3]/b->z - b->j[2]", n, b->j[3], b->z, b->j[2]);
    LET(b->d, prec, "b->z*b->j[1] - n*b->j[2]", b->z, b->j[1], n, b->j[2]);
}

/* Computes the left side of (25), or of (20) for n = 0. Sets the Bessel functions k at kappa and k1 at kappa'. */
static void equation(arb_t f, struct bessel *k, struct bessel *k1, const fmpq_t nu, slong n, const arb_t omega,
                     slong prec)
{
    const arb_srcptr J = k->j[2], J1 = k1->j[2];
    LOCAL(arb, s, y, y1, kk);
    LET(s, prec, "1 - nu", nu);
    LET(k->z, prec, "omega*sqrt(1 - nu^2)", omega, nu); /* (18) */
    LET(k1->z, prec, "omega*sqrt(2*(1 + nu))", omega, nu);
    bessel_set(k, n, prec);
    if (n == 0) { /* kappa J_1' + nu J_1 = kappa J_0 - (1 - nu) J_1 */
        LET(f, prec, "k->z*J - s*k->j[3]", k->z, J, s, k->j[3]);
        return;
    }
    bessel_set(k1, n, prec);
    LET(kk, prec, "k->z^2", k->z);
    LET(y, prec, "k->z*k->j[1]", k->z, k->j[1]);
    LET(y1, prec, "k1->z*k1->j[1]", k1->z, k1->j[1]);
    LET(f, prec, "s*(s*(1 - n^2)*y*y1 + (kk - s*(1 - n^2)*n)*(y*J1 + y1*J)) + kk*(kk - 2*s*(n^2 + n))*J*J1", s, n, y,
        y1, kk, J, J1);
}

/* Fails unless the left side of (25) changes its sign within the relative distance 2^-bits of omega. */
static void assert_root(const struct disk_mode *mode, const fmpq_t nu, slong bits, slong prec)
{
    LOCAL(bessel, k, k1);
    LOCAL(arb, omega, below, above);
    for (int side = -1; side <= 1; side += 2) {
        LET(omega, prec, "mode->omega*(1 + side/2^bits)", mode->omega, side, bits);
        mag_zero(arb_radref(omega));
        equation(side > 0 ? above : below, k, k1, nu, mode->n, omega, prec);
    }
    check(!arb_contains_zero(below) && !arb_contains_zero(above) && arb_is_positive(below) != arb_is_positive(above),
          "n = %ld, l = %ld", (long)mode->n, (long)mode->l);
}

/* ---- C and S: (22) or (23) for the ratio of the amplitudes, Lommel's integrals of (26) ---- */

/* Computes int_0^1 r J(a r) J(b r) dr by Lommel's formula; both functions have the order of j[o]. */
static void lommel(arb_t x, const struct bessel *a, const struct bessel *b, int o, slong prec)
{
    const arb_srcptr low = a->j[o - 1], own = a->j[o], high = a->j[o + 1], other = b->j[o], other_low = b->j[o - 1];
    if (a == b)
        LET(x, prec, "(own^2 - low*high)/2", own, low, high);
    else
        LET(x, prec, "(b->z*other_low*own - a->z*low*other)/(a->z^2 - b->z^2)", b->z, other_low, own, a->z, low, other);
}

/* Computes A and B from (22) or from (23), by the equation that determines them better. */
static void amplitudes(arb_t a, arb_t b, const struct bessel *k, const struct bessel *k1, const fmpq_t nu, slong n,
                       slong prec)
{
    const arb_srcptr J = k->j[2], J1 = k1->j[2];
    LOCAL(arb, a2, b2, s);
    LET(s, prec, "1 - nu", nu);
    /* (22): -A [s kappa J' + (kappa^2 - s n^2) J] + n B s [kappa' J' - J] = 0 */
    LET(a, prec, "n*s*(k1->d - J1)", n, s, k1->d, J1);
    LET(b, prec, "s*k->d + (k->z^2 - s*n^2)*J", s, k->d, k->z, n, J);
    /* (23): -2 n A [kappa J' - J] + B [2 kappa' J' + (kappa'^2 - 2 n^2) J] = 0 */
    LET(a2, prec, "2*k1->d + (k1->z^2 - 2*n^2)*J1", k1->d, k1->z, n, J1);
    LET(b2, prec, "2*n*(k->d - J)", n, k->d, J);
    if (arb_rel_accuracy_bits(a2) + arb_rel_accuracy_bits(b2) > arb_rel_accuracy_bits(a) + arb_rel_accuracy_bits(b)) {
        arb_swap(a, a2);
        arb_swap(b, b2);
    }
}

/* Computes C and S at a frequency, with C > 0 by convention. For n = 0, B is 0. */
static void rim_amplitudes(arb_t c, arb_t s, const fmpq_t nu, slong n, const arb_t omega, slong prec)
{
    LOCAL(bessel, k, k1);
    LOCAL(arb, a, b, norm, own, own1, mixed);
    equation(norm, k, k1, nu, n, omega, prec);
    arb_zero(norm);
    if (n > 0)
        amplitudes(a, b, k, k1, nu, n, prec);
    else
        arb_one(a);
    LET(c, prec, "a*k->d + n*b*k1->j[2]", a, k->d, n, b, k1->j[2]); /* (19) at r = 1 */
    LET(s, prec, "-(b*k1->d + n*a*k->j[2])", b, k1->d, n, a, k->j[2]);
    /* u_r - u_phi = A kappa J_n-1(kappa r) + B kappa' J_n-1(kappa' r); the sum has -A, B and J_n+1. The integral is
     * half the sum of both squares. */
    LET(a, prec, "a*k->z", a, k->z);
    LET(b, prec, "b*k1->z", b, k1->z);
    for (int o = 1; o <= 3; o += 2) {
        const int sign = 2 - o;
        lommel(own, k, k, o, prec);
        lommel(own1, k1, k1, o, prec);
        lommel(mixed, k, k1, o, prec);
        LET(norm, prec, "norm + a^2*own + b^2*own1 + 2*sign*a*b*mixed", norm, a, own, b, own1, sign, mixed);
    }
    arb_mul_2exp_si(norm, norm, n > 0 ? -1 : 0); /* the integral of (26) is 1, or 1/2 for n = 0 */
    arb_sqrt(norm, norm, prec);
    if (arb_is_negative(c))
        arb_neg(norm, norm);
    arb_div(c, c, norm, prec);
    arb_div(s, s, norm, prec);
}

/* Fails unless omega is a root of (25), and C and S agree with (22), (23) and (26). */
static void assert_mode(const struct disk_mode *mode, const fmpq_t nu)
{
    LOCAL(arb, c, s);
    assert_root(mode, nu, 95, 400);
    rim_amplitudes(c, s, nu, mode->n, mode->omega, 400);
    assert_bits(c, 80);
    assert_bits(mode->c, 80);
    assert_overlap(mode->c, c, "C of n", mode->n);
    if (mode->n > 0)
        assert_overlap(mode->s, s, "S of n", mode->n);
}

TEST(test_printed_equation)
{
    static const struct {
        const char *nu;
        slong n, l;
    } cases[] = {{"33/100", 2, 0},    {"33/100", 1, 7}, {"9/10", 30, 0},
                 {"-1/2", 3, 2},      {"-9/10", 1, 1},  {"999999999999/1000000000000", 2, 0},
                 {"33/100", 1500, 0}, {"-9/10", 600, 1} /* n far above kappa */};
    LOCAL(fmpq, nu);
    LOCAL(disk_modes, modes);
    LOCAL(disk_mode, mode);
    modes_solve(modes, "-3/5", 900, 30);
    set_nu(nu, "-3/5");
    for (slong k = 0; k < modes->count; k += 13)
        assert_mode(&modes->mode[k], nu);
    for (size_t i = 0; i < COUNT_OF(cases); i++) {
        set_nu(nu, cases[i].nu);
        assert_int_equal(disk_mode_solve(mode, nu, cases[i].n, cases[i].l, 0, 120), 0);
        if (cases[i].n < 100)
            assert_mode(mode, nu);
        else
            assert_root(mode, nu, 100, 4000);
    }
}

/* ---- the tables of the library: each double is nearest to the exact number, and no mode is missing ---- */

enum { PREC = 320, ROOT_BITS = 180, ROOT_DIGITS = 56, ORDERS = 320 /* larger than every n of the tables */ };

static const struct {
    struct cor_disk_modes modes;
    const char *nu;
} table[] = {{COR_DISK_MODES_NU033, "33/100"}, {COR_DISK_MODES_NU090, "9/10"}};

/* Computes the exact midpoint of x and the next double. */
static void half_way(arb_t y, double x, double towards)
{
    const double next = nextafter(x, towards);
    LET(y, PREC, "(x + next)/2", x, next);
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

/* Checks a mode of a table. The left side of (25) must change its sign at the root that the generator found. */
static void check_mode(const fmpq_t nu, const struct cor_disk_mode *mode, const struct disk_mode *found)
{
    LOCAL(arb, omega, c, s);
    assert_true(found->n == mode->n && found->l == mode->l);
    assert_root(found, nu, ROOT_BITS, PREC);
    arb_get_mid_arb(omega, found->omega);
    LET(c, PREC, "omega/2^ROOT_BITS", omega, ROOT_BITS);
    arb_add_error(omega, c);
    assert_nearest(mode->omega, omega, "omega", mode);
    rim_amplitudes(c, s, nu, mode->n, omega, PREC);
    assert_nearest(mode->c, c, "C", mode);
    if (mode->n > 0)
        assert_nearest(mode->s, s, "S", mode);
    else
        assert_true(mode->s == 0);
}

TEST(every_mode)
{
    for (size_t i = 0; i < COUNT_OF(table); i++) {
        LOCAL(fmpq, nu);
        LOCAL(disk_modes, modes);
        set_nu(nu, table[i].nu);
        modes_solve(modes, table[i].nu, (slong)table[i].modes.count, ROOT_DIGITS);
        for (size_t k = 0; k < table[i].modes.count; k++)
            if (in_turn(k, 6))
                check_mode(nu, &table[i].modes.mode[k], &modes->mode[k]);
    }
}

/* Counts the modes below omega, without the translation, with the count that test_ritz has checked. */
static slong count_below(const fmpq_t nu, double omega)
{
    LOCAL(arb, w);
    LOCAL_INIT(disk, disk, (&disk, nu, PREC));
    slong count = 0;
    LET(w, PREC, "omega^2", omega);
    for (slong n = 0; n < ORDERS; n++) {
        const slong of_n = disk_count(&disk, n, w);
        assert_true(of_n >= 0);
        count += of_n;
    }
    return count;
}

TEST(none_is_missing)
{
    for (size_t i = 0; i < COUNT_OF(table); i++) {
        LOCAL(fmpq, nu);
        set_nu(nu, table[i].nu);
        const struct cor_disk_modes *const t = &table[i].modes;
        int next[ORDERS] = {0}; /* l counts from 0 without a gap */
        for (size_t k = 0; k < t->count; k++) {
            const struct cor_disk_mode *const mode = &t->mode[k];
            assert_in_range(mode->n, 0, ORDERS - 1);
            check(mode->l == next[mode->n]++ && (k == 0 || mode->omega > mode[-1].omega), "(%d,%d) is out of turn",
                  mode->n, mode->l);
        }
        const size_t places[] = {1, 2, 10, 137, 1000, t->count - 1};
        for (size_t k = 0; k < COUNT_OF(places); k++) {
            const double below = t->mode[places[k] - 1].omega, here = t->mode[places[k]].omega;
            assert_int_equal(count_below(nu, (below + here) / 2), places[k]);
        }
        assert_int_equal(count_below(nu, t->mode[t->count - 1].omega * (1 + 1e-9)), t->count);
    }
}

/* Compares the modes of a nu without a table with cor_disk_modes_compute. */
TEST(test_against_doubles)
{
    leave_to_turn(1, 3);
    enum { COUNT = 4000 };
    static struct cor_disk_mode mode[COUNT];
    struct cor_disk_modes in_doubles;
    LOCAL(disk_modes, modes);
    modes_solve(modes, "-1/2", COUNT, 15);
    assert_int_equal(cor_disk_modes_compute(-0.5, COUNT, mode, &in_doubles), 0);
    for (int k = 0; k < COUNT; k++) {
        const struct disk_mode *const exact = &modes->mode[k];
        const double omega = middle(exact->omega), c = middle(exact->c), s = middle(exact->s);
        const double most = COR_DISK_MODES_AMPLITUDE_MAX_ERROR * hypot(c, s);
        check(exact->n == mode[k].n && exact->l == mode[k].l &&
                  fabs(mode[k].omega - omega) <= COR_DISK_MODES_OMEGA_MAX_ERROR * omega &&
                  fabs(mode[k].c - c) <= most && fabs(mode[k].s - s) <= most,
              "(%d, %d)", mode[k].n, mode[k].l);
    }
}

/* ---- extreme nu ---- */

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
    LOCAL(disk_modes, modes, other);
    static const ulong margins[] = {6, 30, 99};
    for (size_t i = 0; i < COUNT_OF(margins); i++) {
        /* As nu approaches -1, the modes become conformal maps z^(n+1), whose only energy is compression. They have
         * omega^2 = (n+1)(n+2)/2 and C = S = sqrt(n+2). The breathing mode has omega = C = sqrt(2). */
        near_end(nu, -1, margins[i]);
        assert_int_equal(disk_modes_solve(modes, nu, 300, 20), 0);
        for (slong n = 0; n < modes->count && margins[i] > 14; n++) {
            const struct disk_mode *mode = &modes->mode[n];
            assert_int_equal(mode->n, n);
            assert_int_equal(mode->l, 0);
            assert_close(mode->omega, n == 0 ? 2 : (double)((n + 1) * (n + 2)) / 2, "omega", n);
            assert_close(mode->c, (double)(n + 2), "C", n);
            if (n > 0)
                assert_close(mode->s, (double)(n + 2), "S", n);
        }
        for (slong k = 0; k < modes->count; k += 59)
            assert_root(&modes->mode[k], nu, 50, 1500);
        /* as nu approaches 1, the compression of the modes vanishes */
        near_end(nu, 1, margins[i]);
        assert_int_equal(disk_modes_solve(other, nu, 300, 20), 0);
        for (slong k = 0; k < other->count; k += 59)
            assert_root(&other->mode[k], nu, 50, 1500);
    }
    /* the lowest modes that are no conformal maps; omega is of the order 1/sqrt(1 + nu) */
    LOCAL(disk_mode, mode);
    near_end(nu, -1, 30);
    for (slong n = 0; n <= 3; n++) {
        assert_int_equal(disk_mode_solve(mode, nu, n, 4, 0, 140), 0);
        assert_true(middle(mode->omega) > 1e15 && middle(mode->omega) < 1e17);
        assert_root(mode, nu, 120, 600); /* relative distance of a torsional mode: 2^-100 */
    }
}

/* cor_mode_orders(omega) exceeds every n that has a mode below omega, but only slightly. */
TEST(test_orders)
{
    static const char *const materials[] = {"99/100", "33/100", "0", "-9/10", "-999999/1000000"};
    LOCAL(fmpq, nu);
    LOCAL(arb, w);
    for (size_t i = 0; i < COUNT_OF(materials); i++) {
        set_nu(nu, materials[i]);
        LOCAL_INIT(disk, disk, (&disk, nu, 128));
        for (int k = 0; k < 40; k++) {
            const double omega = random_log(&draw, 0.5, 500);
            const slong orders = cor_mode_orders(omega);
            assert_true((double)orders * (double)(orders - 1) >= 10 * omega * omega && (double)orders < 4 * omega + 4);
            LET(w, 128, "omega^2", omega);
            for (slong n = orders; n < orders + 3; n++)
                assert_int_equal(disk_count(&disk, n, w), 0);
        }
    }
}

/* Any number of threads gives the same bits. More digits give the same modes. */
TEST(test_threads_and_digits)
{
    LOCAL(disk_modes, modes, other);
    modes_solve(modes, "1/3", 150, 20);
    for (int threads = 2; threads <= 4; threads++) {
        parallel_use(threads);
        modes_solve(other, "1/3", 150, 20);
        for (slong k = 0; k < modes->count; k++) {
            const struct disk_mode *const a = &modes->mode[k], *const b = &other->mode[k];
            assert_same_mode(a, b);
            assert_true(arb_equal(a->omega, b->omega) && arb_equal(a->c, b->c) && arb_equal(a->s, b->s));
        }
    }
    parallel_use(0);
    static const slong digits[] = {1, 15, 100, 700};
    for (size_t i = 0; i < COUNT_OF(digits); i++) {
        modes_solve(other, "1/3", i < 3 ? 150 : 20, digits[i]);
        for (slong k = 0; k < other->count; k++) {
            assert_same_mode(&modes->mode[k], &other->mode[k]);
            assert_bits(other->mode[k].omega, digits[i] * 3);
            assert_bits(other->mode[k].c, digits[i] * 3);
        }
    }
    /* the lowest modes do not depend on the requested count */
    for (slong count = 1; count < modes->count; count += count / 8 + 1) {
        modes_solve(other, "1/3", count, 20);
        for (slong k = 0; k < count; k++)
            assert_same_mode(&modes->mode[k], &other->mode[k]);
    }
}
