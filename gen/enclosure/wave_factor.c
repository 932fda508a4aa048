/* SPDX-License-Identifier: MIT */
#include "enclosure/closed_form.h"

#include "support/formula.h"
#include "support/local.h"

#include <math.h>
#include <stdbool.h>

/* ---- J ----
 *
 * With gamma = c_s/c_p, gamma^2 = (1 - 2 nu)/(2 (1 - nu)) = tau^2/(1 + tau^2), a^2 = |x^2 - gamma^2|, b^2 = |x^2 - 1|,
 * D = (2 x^2 - 1)^2, R = D - 4 x^2 a b and R(x_R) = 0:
 *
 *     J = int_0^gamma x a/(D + 4 x^2 a b) dx + int_gamma^1 4 x^3 a^2 b/(D^2 + 16 x^4 a^2 b^2) dx
 *         - pi x_R a(x_R)/R'(x_R)
 *
 * x = gamma (1 - u^2) and x = 1 - (1 - gamma) u^2 remove the square roots at the ends of the integrals. For gamma^2 =
 * 1/2 both integrands are 0/0 at x = gamma. Near gamma^2 = 1/2, J is instead computed as the imaginary part of int x
 * a/R dx along a path from 0 to 2 that passes above gamma, 1 and x_R. Nothing is singular on this path. */

struct wave_parameters {
    acb_srcptr gamma, gamma2;
};

static int pressure_integrand(acb_ptr y, const acb_t u, void *parameters, slong order, slong prec)
{
    const struct wave_parameters *const p = parameters;
    const bool analytic = order > 0;
    LOCAL(acb, x, a);
    LET_COMPLEX(x, analytic, prec, "(1 - u^2)*p->gamma", u, p->gamma);
    LET_COMPLEX(a, analytic, prec, "sqrt(2 - u^2)*u*p->gamma", u, p->gamma);
    LET_COMPLEX(y, analytic, prec, "2*x*a/((2*x^2 - 1)^2 + 4*sqrt(1 - x^2)*a*x^2)*u*p->gamma", x, a, u, p->gamma);
    return 0;
}

static int shear_integrand(acb_ptr y, const acb_t u, void *parameters, slong order, slong prec)
{
    const struct wave_parameters *const p = parameters;
    const bool analytic = order > 0;
    LOCAL(acb, x, b, c, width);
    LET_COMPLEX(width, analytic, prec, "1 - p->gamma", p->gamma);
    LET_COMPLEX(x, analytic, prec, "1 - u^2*width", u, width);
    LET_COMPLEX(b, analytic, prec, "sqrt((1 + x)*width)*u", x, width, u); /* b = u sqrt((1 - gamma)(1 + x)) */
    LET_COMPLEX(c, analytic, prec, "4*x^2*(x^2 - p->gamma2)*b", x, p->gamma2,
                b); /* the denominator is D^2 + 4 x^2 b c */
    LET_COMPLEX(y, analytic, prec, "2*c/((2*x^2 - 1)^4 + 4*c*b*x^2)*x*width*u", c, x, b, width, u);
    return 0;
}

static void wave_integral(acb_t y, acb_calc_func_t f, void *p, slong prec)
{
    LOCAL(acb, from, to);
    LOCAL(mag, tolerance);
    acb_one(to);
    mag_set_ui_2exp_si(tolerance, 1, -prec);
    acb_calc_integrate(y, f, p, from, to, prec, tolerance, NULL, prec + 20);
}

/* Computes (c_R/c_s)^2, the smallest root of p^3 - 8 p^2 + (24 - 16 gamma^2) p - 16 (1 - gamma^2). The result is not
 * finite where the intervals do not isolate the roots. */
static void rayleigh_root(acb_t p, const acb_t gamma2, slong prec)
{
    enum { DEGREE = 3, LEAST_BITS = 128 };
    LOCAL(acb_poly, cubic);
    LOCAL(acb, c);
    acb_ptr root = _acb_vec_init(DEGREE);
    LET_COMPLEX(c, false, prec, "-16*(1 - gamma2)", gamma2);
    acb_poly_set_coeff_acb(cubic, 0, c);
    LET_COMPLEX(c, false, prec, "24 - 16*gamma2", gamma2);
    acb_poly_set_coeff_acb(cubic, 1, c);
    acb_poly_set_coeff_si(cubic, 2, -8);
    acb_poly_set_coeff_si(cubic, DEGREE, 1);
    const bool isolated = acb_poly_find_roots(root, cubic, NULL, 0, FLINT_MAX(prec, LEAST_BITS)) == DEGREE;
    acb_indeterminate(p);
    for (int k = 0; k < DEGREE && isolated; k++)
        if (k == 0 || arf_cmpabs(arb_midref(acb_realref(root + k)), arb_midref(acb_realref(p))) < 0)
            acb_set(p, root + k);
    _acb_vec_clear(root, DEGREE);
}

/* Computes - pi x a/R'(x) at the root. With p = 1/x^2, A = sqrt(1 - gamma^2 p) and 4 A sqrt(1 - p) = (2 - p)^2 it
 * equals
 *     - pi A sqrt(p)/(8 ((2 - p) - (2 - p)^2/4 - 2 (2 - (1 + gamma^2) p)/(2 - p)^2)) */
static void rayleigh_share(acb_t y, const acb_t gamma2, slong prec)
{
    LOCAL(acb, p, q);
    rayleigh_root(p, gamma2, prec);
    LET_COMPLEX(q, false, prec, "2 - p", p);
    LET_COMPLEX(y, false, prec, "-pi*sqrt(1 - gamma2*p)*sqrt(p)/(8*(q - q^2/4 - 2*(q - gamma2*p)/q^2))", gamma2, p, q);
}

/* ---- J along a path ---- */

/* x a/R along a straight line. If x is large, a and b are sqrt(x^2 - gamma^2) and sqrt(x^2 - 1). If x is small, they
 * are i sqrt(gamma^2 - x^2) and i sqrt(1 - x^2), which have no cut there. Both pairs are equal on the path. */
struct path_parameters {
    acb_srcptr from, step, gamma2;
    bool large;
};

static int path_integrand(acb_ptr y, const acb_t u, void *parameters, slong order, slong prec)
{
    const struct path_parameters *const p = parameters;
    const bool analytic = order > 0;
    const int sign = p->large ? 1 : -1;
    LOCAL(acb, x, a, b);
    LET_COMPLEX(x, false, prec, "u*p->step + p->from", u, p->step, p->from);
    LET_COMPLEX(a, analytic, prec, "sqrt(sign*(x^2 - p->gamma2))", sign, x, p->gamma2);
    LET_COMPLEX(b, analytic, prec, "sqrt(sign*(x^2 - 1))", sign, x);
    LET_COMPLEX(y, false, prec, "x*a/((2*x^2 - 1)^2 - 4*sign*a*b*x^2)*p->step", x, a, sign, b, p->step);
    if (!p->large)
        acb_mul_onei(y, y);
    return 0;
}

/* Integrates from 0 through 7/8 + 7/8 i to 2. */
static void path_integral(acb_t y, const acb_t gamma2, slong prec)
{
    LOCAL(acb, from, step, part, parameter);
    struct path_parameters p = {from, step, parameter, false};
    acb_set(parameter, gamma2); /* a copy, because y may be gamma2 */
    acb_set_d_d(step, 0.875, 0.875);
    wave_integral(y, path_integrand, &p, prec);
    p.large = true;
    acb_swap(from, step);
    LET_COMPLEX(step, false, prec, "2 - from", from);
    wave_integral(part, path_integrand, &p, prec);
    acb_add(y, y, part, prec);
}

/* Computes (I(gamma) - conj(I(conj(gamma))))/(2 i), which is Im(I) for real gamma. */
static void wave_factor_by_path(acb_t j, const acb_t gamma2, slong prec)
{
    LOCAL(acb, other);
    acb_conj(other, gamma2);
    path_integral(j, gamma2, prec);
    path_integral(other, other, prec);
    acb_conj(other, other);
    LET_COMPLEX(j, false, prec, "(j - other)/2", j, other);
    acb_div_onei(j, j);
}

void wave_factor_by(acb_t j, enum wave_route route, const acb_t tau, slong prec)
{
    LOCAL(acb, gamma, gamma2, part);
    struct wave_parameters p = {gamma, gamma2};
    LET_COMPLEX(gamma2, false, prec + 20, "tau^2/(1 + tau^2)", tau);
    LET_COMPLEX(gamma, false, prec + 20, "tau/sqrt(1 + tau^2)", tau);
    if (route == WAVE_BY_PATH) {
        wave_factor_by_path(j, gamma2, prec);
    } else {
        wave_integral(j, pressure_integrand, &p, prec);
        wave_integral(part, shear_integrand, &p, prec);
        acb_add(j, j, part, prec);
        rayleigh_share(part, gamma2, prec + 20);
        acb_add(j, j, part, prec);
    }
}

/* The integrals along the axis are slow if gamma^2 is within 0.02 of 1/2, near tau = 1. */
void wave_factor(acb_t j, const acb_t tau, slong prec)
{
    const double x = ball_middle(acb_realref(tau)) - 1;
    wave_factor_by(j, fabs(x) < 0.04 ? WAVE_BY_PATH : WAVE_BY_AXIS, tau, prec);
}
