/* SPDX-License-Identifier: MIT */
#include "enclosure/slow_manifold.h"

#include "enclosure/taylor.h"

#include <math.h>
#include <pthread.h>

#include "support/console.h"
#include "support/local.h"

/* Constants in the formula for the degree d of the formal sum. At y = 1/(2 d n) its smallest term has the index 2 d,
 * and the truncated sum has a defect of exp(-(1 + ln 2) d). GUARD_BITS more bits cover constant factors. A law with a
 * small n needs a higher degree, so that (a-b) y is small. */
enum { GUARD_BITS = 24, CLOSING = 4 };

static slong formal_degree(const struct cor_exponents *law, slong bits)
{
    const struct ratio n = law_fall_power(law), slope = RATIO("(law->a - law->b)/n", law, n);
    const double by_bits = (double)(bits + GUARD_BITS) * log(2) / (1 + log(2));
    const double by_slope = (double)CLOSING * fabs(ratio_double(slope));
    return (slong)fmax(by_bits, by_slope) + CLOSING;
}

double slow_manifold_depth(const struct cor_exponents *law, slong bits)
{
    return 2.0 * (double)formal_degree(law, bits);
}

/* Bounds sum_{m >= first} |f_m| y^m from above. */
static void abs_tail(arb_t sum, const arb_poly_t f, slong first, const arb_t y, slong prec)
{
    arb_zero(sum);
    for (slong m = first; m < f->length; m++) {
        const arb_srcptr c = f->coeffs + m;
        LET(sum, prec, "sum + abs(c)*y^m", sum, c, y, m);
    }
    arb_get_ubound_arf(arb_midref(sum), sum, prec);
    mag_zero(arb_radref(sum));
}

/* Computes p_0 = 1, p_m = (p^2)_(m-1) (a - b - n (m-1)/2). This recurrence is order y^m of N(p) = 0, because
 * p p' = (p^2)'/2. */
static void formal_sum(arb_poly_t p, const struct cor_exponents *law, slong degree, slong prec)
{
    const struct ratio n = law_fall_power(law), a = law_elastic(law), b = law_damping(law);
    LOCAL(arb, c);
    arb_poly_one(p);
    arb_poly_fit_length(p, degree + 1);
    for (slong k = 1; k <= degree; k++) {
        arb_dot(c, NULL, 0, p->coeffs, 1, p->coeffs + k - 1, -1, k, prec);
        LET(p->coeffs + k, prec, "c*(a - b - n*(k - 1)/2)", c, a, b, n, k);
        _arb_poly_set_length(p, k + 1);
    }
    /* for Hunt and Crossley's law the sum is 1, and its higher coefficients may be zeros */
    _arb_poly_normalise(p);
}

/* Bounds N(P) = 1 - P + (a-b) y P^2 - (n/2) y^2 (P^2)'. N(P) starts at y^(degree+1), because P is the formal sum up to
 * y^degree. */
static void bound_defect(struct slow_manifold *m, slong degree)
{
    const struct ratio a = law_elastic(&m->law), b = law_damping(&m->law);
    LOCAL(arb_poly, square);
    arb_poly_mul(square, m->p, m->p, m->prec);
    for (slong k = degree + 1; k <= square->length; k++) {
        const arb_srcptr c = square->coeffs + k - 1;
        LET(m->nu, m->prec, "m->nu + abs(c*(a - b - m->n*(k - 1)/2))*m->last^k", m->nu, c, a, b, m->n, k, m->last);
    }
    arb_get_ubound_arf(arb_midref(m->nu), m->nu, m->prec);
    mag_zero(arb_radref(m->nu));
}

/* Computes eta = 2^-bits plus four times the defect. */
static void eta_of(arb_t eta, const struct slow_manifold *m, slong bits)
{
    LET(eta, m->prec, "2^-bits + 4*m->nu", bits, m->nu);
}

/* True if the field points inwards at p = P +- eta, that is if |N(P)| < eta |1 - 2 (a-b) y P - (a-b) y eta + n y^2 P'|.
 * Proves that the factor of eta is above 1/2, with sums of absolute values for |P| and |P'|, and that P > 3/4. */
static bool tube_is_closed(const struct slow_manifold *m, const arb_t eta)
{
    const struct ratio a = law_elastic(&m->law), b = law_damping(&m->law);
    LOCAL(arb_poly, slope);
    LOCAL(arb, change, x);
    abs_tail(change, m->p, 1, m->last, m->prec); /* |P - 1| */
    arb_poly_derivative(slope, m->p, m->prec);
    abs_tail(x, slope, 0, m->last, m->prec); /* |P'| */
    return HOLDS(m->prec, "2*m->last*(m->n*m->last*x + abs(a - b)*(2*(change + 1) + eta)) < 1", m->last, m->n, x, a, b,
                 change, eta) &&
           HOLDS(m->prec, "change < 1/4", change);
}

/* Integrates y^(m-1-kappa): the result is y^(m - kappa)/(m - kappa), or ln(y) if m = kappa. */
static void time_power(arb_t x, const struct slow_manifold *m, slong power, const arb_t y)
{
    if (power * m->kappa.den == m->kappa.num)
        arb_log(x, y, m->prec);
    else
        LET(x, m->prec, "y^(power - m->kappa)/(power - m->kappa)", y, power, m->kappa);
}

/* Bounds the integral of 1/P - inverse, which equals (1 - P inverse)/P, where |1/P| < 4/3. The numerator starts at
 * y^(degree+1). */
static void bound_time_error(struct slow_manifold *m, slong degree)
{
    LOCAL(arb_poly, product);
    LOCAL(arb, x);
    arb_poly_inv_series(m->inverse, m->p, degree + 1, m->prec);
    arb_poly_mul(product, m->p, m->inverse, m->prec);
    arb_zero(m->time_error);
    for (slong k = degree + 1; k < product->length; k++) {
        const arb_srcptr c = product->coeffs + k;
        time_power(x, m, k, m->last); /* k > kappa, because kappa is at most 1 */
        LET(m->time_error, m->prec, "m->time_error + abs(x*c)", m->time_error, x, c);
    }
    LET(m->time_error, m->prec, "m->time_error/m->n*4/3", m->time_error, m->n);
}

/* Integrates one trajectory from `last` with slope p down to z = 0. Sets its end speed and time. */
static bool follow_manifold(arb_t speed, arb_t time, const struct slow_manifold *m, const arb_t p)
{
    const slong d = m->law.denominator, difference = m->law.elastic - m->law.damping;
    LOCAL(arb, value);
    LOCAL_INIT(taylor, y, (&y, &m->law, taylor_degree(m->prec), m->prec));
    arb_one(y.c1);
    arb_one(y.c2);
    LET(y.w, m->prec, "m->last^(-1/d/m->n)", m->last, d, m->n); /* w = z^(1/d), z = y^(-1/n) */
    LET(y.v, m->prec, "-(y.w^difference*p)", y.w, difference, p);
    if (!taylor_follow(value, &y, TAYLOR_W, "fall along the slow manifold"))
        return false;
    taylor_value(speed, &y, TAYLOR_V, value);
    arb_neg(speed, speed);
    taylor_value(time, &y, TAYLOR_T, value);
    return true;
}

/* Encloses end speed and time of all motions in the tube. -z' as a function of z obeys a scalar equation, so
 * trajectories keep their order. The two edges enclose all others and converge. A faster trajectory needs less time. */
static bool enclose_fall(struct slow_manifold *m, const arb_t eta)
{
    LOCAL(arb, middle, edge, speed, time);
    arb_poly_evaluate(middle, m->p, m->last, m->prec);
    arb_sub(edge, middle, eta, m->prec);
    bool closed = follow_manifold(m->final_speed, m->t_fall, m, edge);
    arb_add(edge, middle, eta, m->prec);
    closed = closed && follow_manifold(speed, time, m, edge);
    arb_union(m->final_speed, m->final_speed, speed, m->prec);
    arb_union(m->t_fall, m->t_fall, time, m->prec);
    return closed;
}

/* Chooses `last` so that eta is below 2^(1-bits). Returns false if the precision does not suffice. */
static bool manifold_make(struct slow_manifold *m, const struct cor_exponents *law, slong bits, slong prec)
{
    const slong degree = formal_degree(law, bits);
    LOCAL(arb, eta);
    m->law = *law;
    m->n = law_fall_power(law);
    m->kappa = RATIO("(law->b - law->a + 1)/m->n", law, m->n);
    m->prec = prec;
    FOR_ALL(arb_poly, init, m->p, m->inverse);
    FOR_ALL(arb, init, m->last, m->nu, m->time_error, m->final_speed, m->t_fall);

    formal_sum(m->p, law, degree, prec);
    LET(m->last, prec, "1/(2*m->n*degree)", m->n, degree);
    arb_get_mid_arb(m->last, m->last);
    bound_defect(m, degree);
    eta_of(eta, m, bits);
    if (!tube_is_closed(m, eta))
        return false;
    bound_time_error(m, degree);
    return enclose_fall(m, eta);
}

/* All manifolds so far, newest first. A thread that needs a manifold waits while another thread computes one. */
static struct slow_manifold *kept_manifolds;
static pthread_mutex_t kept_lock = PTHREAD_MUTEX_INITIALIZER;

const struct slow_manifold *slow_manifold_of(const struct cor_exponents *law, slong bits, slong prec)
{
    /* collisions at different beta need different precisions; rounding up makes many of them equal */
    enum { PREC_STEP = 32 };
    prec = (prec + PREC_STEP - 1) / PREC_STEP * PREC_STEP;
    pthread_mutex_lock(&kept_lock);
    struct slow_manifold *m = kept_manifolds;
    while (m && !(m->bits == bits && m->prec == prec && law_equal(&m->law, law)))
        m = m->next;
    if (!m) {
        m = xmalloc(sizeof *m);
        *m = (struct slow_manifold){.bits = bits, .next = kept_manifolds};
        m->closed = manifold_make(m, law, bits, prec);
        kept_manifolds = m;
    }
    pthread_mutex_unlock(&kept_lock);
    return m->closed ? m : NULL;
}

bool slow_manifold_reached(const struct slow_manifold *m, const arb_t y, const arb_t p, slong bits)
{
    LOCAL(arb, x);
    arb_poly_evaluate(x, m->p, y, m->prec);
    return arb_lt(y, m->last) && HOLDS(m->prec, "abs(x - p) < 2^-bits", x, p, bits);
}

bool slow_manifold_time(arb_t time, const struct slow_manifold *m, const arb_t y, const arb_t p, slong bits)
{
    LOCAL(arb, x, eta, error);
    if (!slow_manifold_reached(m, y, p, bits))
        return false;
    /* sum_k inverse_k [y^(k-kappa)/(k-kappa)]/n from y to `last` */
    arb_zero(time);
    for (slong k = 0; k < m->inverse->length; k++) {
        const arb_srcptr c = m->inverse->coeffs + k;
        time_power(x, m, k, m->last);
        time_power(error, m, k, y);
        LET(time, m->prec, "time + c*(x - error)/m->n", time, c, x, error, m->n);
    }
    arb_add_error(time, m->time_error);
    /* |1/p - 1/P| <= eta/(3/4 - eta)^2 < 2 eta, integrated like the term of degree 0 */
    eta_of(eta, m, bits);
    time_power(x, m, 0, m->last);
    time_power(error, m, 0, y);
    LET(error, m->prec, "2*eta*(x - error)/m->n", eta, x, error, m->n);
    arb_add_error(time, error);
    return true;
}
