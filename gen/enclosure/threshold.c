/* SPDX-License-Identifier: MIT */
/* With q < 0 the bodies part only below a threshold beta_c (docs/theory.md, 9).
 *
 * Consider, backward in time, a motion that ends with eps = 0; x = beta^(2/m) X, m = -n > 0. It is the unstable
 * manifold of the law with negative damping X'' - X^b X' + X^a = 0,
 *
 *   X' = X^(b+1) g(z),   z = X^m,   g ((b+1) g + m z g') = g - z,   g(0) = 1/(b+1).
 *
 * It turns at a height C*. A collision turns at C(beta) = beta^(-2/m) x_max(beta), which falls with beta. The bodies
 * part if C(beta) is above C*, so beta_c is the root of C(beta) = C*. */
#include "enclosure/collision.h"

#include <math.h>

#include "enclosure/motion.h"
#include "enclosure/taylor.h"
#include "support/console.h"
#include "support/local.h"
#include "support/root.h"

enum { GUARD_BITS = 60, ATTEMPTS = 8, SEARCH_STEPS = 400 };

/* Computes z, and g at z to prec bits. At order z^k the equation gives, with R_k = sum_{0<i<k} g_i g_(k-i):
 *
 *   g_k = -((b+1 + m k/2) R_k + [k = 1])/(1 + m k/(b+1)).
 *
 * [k = 1] is 1 for k = 1, otherwise 0. The factor of R_k is below b+1, so M = |g_1| z + (b+1) M^2 is a majorant of g -
 * g_0. M converges up to z* = 1/(4 (b+1) |g_1|), where M is 1/(2 (b+1)). The terms beyond z^K at z = z* 2^-s are below
 * 2^(-s (K+1))/(2 (b+1)). */
static void unstable_series(arb_t g, arb_t z, const struct cor_exponents *law, slong prec)
{
    enum { SHRINK = 3 };
    const slong terms = prec / SHRINK + 2;
    const struct ratio n = law_fall_power(law);
    LOCAL_VECTOR(c, terms + 1);
    LOCAL(fmpq, b1);
    LOCAL(arb, x);
    EXACT(b1, "law->b + 1", law);
    LET(c, prec, "1/b1", b1);
    for (slong k = 1; k <= terms; k++) {
        arb_zero(x);
        if (k > 1)
            arb_dot(x, NULL, 0, c + 1, 1, c + k - 1, -1, k - 1, prec);
        const slong first = k == 1;
        LET(c + k, prec, "-((x*(b1 - n*k/2) + first)/(1 - n*k/b1))", x, b1, n, k, first);
    }
    const arb_srcptr g1 = c + 1;
    LET(z, prec, "1/abs(b1*g1)/2^(2 + SHRINK)", b1, g1, SHRINK);
    arb_get_lbound_arf(arb_midref(z), z, prec);
    mag_zero(arb_radref(z));
    _arb_poly_evaluate(g, c, terms + 1, z, prec);
    LET(x, prec, "1/b1/2^(1 + SHRINK*(terms + 1))", b1, SHRINK, terms);
    arb_add_error(g, x);
}

/* Computes C* by steps from the end of the series to the turning point. */
static bool unstable_height(arb_t c_star, const struct cor_exponents *law, slong prec)
{
    const struct ratio n = law_fall_power(law);
    const slong d = law->denominator, b1 = law->damping + d;
    LOCAL(arb, g, z);
    unstable_series(g, z, law, prec);
    LOCAL_INIT(taylor, y, (&y, law, taylor_degree(prec), prec));
    arb_set_si(y.c1, -1);
    arb_one(y.c2);
    LET(y.w, prec, "z^(-1/d/n)", z, d, n);
    LET(y.v, prec, "y.w^b1*g", y.w, b1, g);
    const bool turned = taylor_follow(g, &y, TAYLOR_V, "threshold of damping");
    if (turned) {
        taylor_value(z, &y, TAYLOR_W, g);
        arb_pow_ui(c_star, z, (ulong)d, prec);
    }
    return turned;
}

struct height {
    const struct cor_exponents *law;
    arb_srcptr c_star;
};

/* Computes C(beta) - C*. */
static bool height_above(arb_t f, const arb_t beta, const void *context, slong prec)
{
    const struct height *const h = context;
    const struct ratio n = law_fall_power(h->law);
    LOCAL(collision, c);
    const bool solved = motion_solve(c, beta, h->law, MOTION_TURNING_POINT, prec) == MOTION_DONE;
    if (solved)
        LET(f, prec, "beta^(2/n)*c->x_max - h->c_star", beta, n, c->x_max, h->c_star);
    return solved;
}

/* Brackets the root by doubling, shrinks the bracket by the Illinois method, and proves the signs at both ends of an
 * interval of relative width 2^-bits. C(beta) falls, so the interval contains the only root. */
static bool find_threshold(arb_t beta_c, const arb_t c_star, const struct cor_exponents *law, slong bits, slong prec)
{
    const struct height height = {law, c_star};
    LOCAL(bracket, b);
    LOCAL(arb, x, f);
    bool enclosed = false;
    bool sound = true, known[2] = {false, false};
    arb_one(x);
    while (sound && !(known[0] && known[1])) {
        sound = height_above(f, x, &height, prec);
        const bool below = arb_is_positive(f);
        arb_set(below ? b->low : b->high, x);
        arb_set(below ? b->f_low : b->f_high, f);
        known[below] = true;
        arb_mul_2exp_si(x, x, below ? 1 : -1);
    }
    for (int i = 0; i < SEARCH_STEPS && sound && !enclosed; i++) {
        bracket_guess(x, b, prec);
        sound = height_above(f, x, &height, prec);
        enclosed = arf_cmpabs_2exp_si(arb_midref(f), -bits - GUARD_BITS / 4) < 0;
        bracket_shrink(b, x, f);
    }
    arb_set(beta_c, x);
    return sound && enclosed && root_near(beta_c, height_above, &height, bits + 2, prec);
}

int collision_threshold(arb_t beta_c, arb_t c_star, const struct cor_exponents *law, slong bits)
{
    slong prec = bits + GUARD_BITS;
    if (law_fall_power(law).num > 0)
        return fail("a threshold of damping exists only for q <= 0");
    if (law_is_linear(law)) {
        LET(beta_c, prec, "sqrt(2*(law->a + 1))", law);
        return STATUS_OK;
    }
    for (int i = 0; i < ATTEMPTS; i++, prec += prec / 2) {
        const bool found = unstable_height(c_star, law, prec) && find_threshold(beta_c, c_star, law, bits, prec);
        progress_end();
        if (found && arb_rel_accuracy_bits(beta_c) >= bits && arb_rel_accuracy_bits(c_star) >= bits)
            return STATUS_OK;
    }
    return fail_accuracy("the threshold of damping", bits);
}
