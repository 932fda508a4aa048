/* SPDX-License-Identifier: MIT */
/* The series in beta from the equation of motion, the second route to every y_k, tau_k and C_k */
#include "enclosure/collision.h"

#include "enclosure/motion.h"
#include "enclosure/taylor.h"
#include "series/jet.h"
#include "support/console.h"
#include "support/local.h"

/* Taylor coefficients of a component at the current state, as power series in beta */
static void component_jets(arb_poly_struct *jet, slong count, arb_srcptr f, const struct taylor *y)
{
    for (slong n = 0; n < count; n++) {
        arb_poly_zero(jet + n);
        for (slong l = 0; l < y->jets; l++)
            arb_poly_set_coeff_arb(jet + n, l, f + l * (y->degree + 1) + n);
    }
}

int collision_series(arb_poly_t y_series, arb_poly_t tau, arb_poly_t c, slong order, const struct law *law, slong prec)
{
    const slong count = order + 1;
    struct taylor y;
    arb_poly_struct *w = jet_new(count), *v = jet_new(count), *t = jet_new(count);
    LOCAL(arb_poly, delta);
    LOCAL(arb, value, root, begin);
    bool turned = false, done = false;

    taylor_init(&y, law, count, FLINT_MAX(taylor_degree(prec), count), prec);
    /* The parameter is beta. Norms of series are taken at |beta| = 1/2, well inside |h*| for the sphere. */
    mag_set_ui_2exp_si(y.weight, 1, -1);
    if (count > 1)
        arb_one(y.c1 + 1);
    arb_one(y.c2);
    arb_one(y.v);
    for (slong step = 0; step < TAYLOR_MAX_STEPS && !done; step++) {
        progress("series by the equation of motion", step, 0);
        taylor_expand(&y);
        if (!taylor_choose_step(&y))
            break;
        const enum taylor_component event = turned ? TAYLOR_W : TAYLOR_V;
        taylor_value(value, &y, event, 0, y.step);
        if (arb_is_positive(value)) {
            taylor_advance(&y, y.step);
            continue;
        }
        if (!arb_is_negative(value) || !taylor_root(root, &y, event, begin, y.step))
            break;
        /* After the elastic event all steps are formal operations on power series in beta. */
        taylor_advance(&y, root);
        arb_zero(turned ? y.w : y.v);
        taylor_expand(&y);
        component_jets(w, count, y.w, &y);
        component_jets(v, count, y.v, &y);
        component_jets(t, count, y.t, &y);
        jet_solve(delta, turned ? w : v, count, count, prec);
        if (!turned) {
            jet_compose(y_series, w, count, delta, count, prec);
            arb_poly_pow_ui_trunc_binexp(y_series, y_series, (ulong)law->d, count, prec);
            jet_compose(tau, t, count, delta, count, prec);
            turned = true;
            /* An exact step leads past the turning point, so that the same event does not occur again. */
            if (!taylor_choose_step(&y))
                break;
            arb_get_mid_arb(root, y.step);
            taylor_advance(&y, root);
        } else {
            jet_compose(c, v, count, delta, count, prec);
            arb_poly_neg(c, c);
            done = true;
        }
    }
    progress_end();
    taylor_clear(&y);
    jet_free(w, count);
    jet_free(v, count);
    jet_free(t, count);
    return done ? STATUS_OK
                : fail("the equation of motion could not be carried to order %ld with %ld bits", (long)order,
                       (long)prec);
}
