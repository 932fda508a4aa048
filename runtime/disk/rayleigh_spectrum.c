/* SPDX-License-Identifier: MIT */
#include "runtime/disk/rayleigh_spectrum.h"

#include <math.h>
#include <string.h>

#include "runtime/core/lambert_w.h"
#include "runtime/disk/rayleigh_kernel.h"

/* ---- quadrature ---- */

static void legendre(double p[COR_LEG_GAUSS + 2], double x)
{
    p[0] = 1;
    p[1] = x;
    for (int k = 2; k < COR_LEG_GAUSS + 2; k++)
        p[k] = ((2 * k - 1) * x * p[k - 1] - (k - 1) * p[k - 2]) * (1.0 / k);
}

/* Integrals from x to 1: the polynomial's Legendre coefficients are (2 k + 1)/2 sum_j w_j P_k(x_j) f_j, and that of P_k
 * is (P_(k-1)(x) - P_(k+1)(x))/(2 k + 1). From -x on it is what the whole has beyond the mirror image's from x on. */
static void integrals(double row[][COR_LEG_STEPS], int steps, double p[][COR_LEG_GAUSS + 2], const double *w)
{
    for (int k = 0; k <= steps / 2; k++) {
        double at[COR_LEG_GAUSS + 2];
        legendre(at, 1 - 2.0 * k / steps);
        for (int j = 0; j < COR_LEG_GAUSS / 2; j++) {
            double even = 1 - at[1], odd = 0; /* in x_j */
            for (int l = 1; l < COR_LEG_GAUSS; l += 2) {
                odd += p[j][l] * (at[l - 1] - at[l + 1]);
                if (l + 1 < COR_LEG_GAUSS)
                    even += p[j][l + 1] * (at[l] - at[l + 2]);
            }
            const int mirror = COR_LEG_GAUSS - 1 - j;
            row[j][k] = 0.5 * w[j] * (even + odd);
            row[mirror][k] = 0.5 * w[j] * (even - odd);
            if (k > 0) {
                row[j][steps - k] = w[j] - row[mirror][k];
                row[mirror][steps - k] = w[j] - row[j][k];
            }
        }
    }
}

static void rule_init(struct cor_leg_rule *rule)
{
    const double pi = 3.14159265358979323846;
    double p[COR_LEG_GAUSS / 2][COR_LEG_GAUSS + 2];
    memset(rule, 0, sizeof *rule);
    for (int i = 0; i < COR_LEG_GAUSS / 2; i++) {
        double x = cos(pi * (i + 0.75) / (COR_LEG_GAUSS + 0.5)), slope = 1;
        for (int k = 0; k < 4; k++) { /* Newton's method from a guess good to 1e-3: quadratic */
            legendre(p[i], x);
            slope = COR_LEG_GAUSS * (x * p[i][COR_LEG_GAUSS] - p[i][COR_LEG_GAUSS - 1]) / (x * x - 1);
            x -= p[i][COR_LEG_GAUSS] / slope;
        }
        legendre(p[i], x);
        rule->x[i] = x;
        rule->x[COR_LEG_GAUSS - 1 - i] = -x;
        rule->w[i] = rule->w[COR_LEG_GAUSS - 1 - i] = 2 / ((1 - x * x) * slope * slope);
    }
    integrals(rule->to_steps, COR_LEG_STEPS, p, rule->w);
    integrals(rule->to_short, COR_LEG_SHORT, p, rule->w);
}

/* ---- one leg: from its base along a straight ray ---- */

/* Panels that end farther than this from the base are short. */
#define SHORT_FROM 0.4

/* From rho = nearest outwards, until rho = farthest or until Re(p) > enough. Trapezoidal rule in u: the integrand falls
 * off like a power on one side and faster than exponentially on the other, where exp(-omega p) does. */
static void leg_init(struct cor_leg *leg, const struct cor_rayleigh_set *set, const struct cor_leg_rule *rule,
                     const struct cor_leg_path *path, double nearest, double farthest, double enough)
{
    const double last = -log(farthest);
    const struct number t = kernel_solve(path, nearest), y = plus(number(1, 0), t);
    /* int_0^rho sqrt(y/2) drho by parts, y' = 2 y/(y - 1) in u; at the other base y is 1; the ray starts straight
     * down */
    struct number p = scaled(nearest, root(scaled(0.5, y)));
    if (path->from_zero) {
        const struct number inverse = divided(number(1, 0), t), square = times(inverse, inverse);
        /* 1 + 1/t + 1/t^2 - 2 y/t^3 + ...: derivatives r'/r = 1/t, r''/r = 1/t^2 - 2 y/t^3 */
        const struct number second = minus(square, scaled(2, times(y, times(square, inverse))));
        p = times(p, plus(plus(number(1, 0), inverse), second));
    }
    leg->end_re = p.re;
    leg->end_im = p.im;
    leg->n = 1; /* 0 is kept for what lies nearer to the base */
    double top = -log(nearest);
    do {
        const int steps = exp(-top + COR_LEG_STEPS * COR_LEG_STEP) < SHORT_FROM ? COR_LEG_STEPS : COR_LEG_SHORT;
        set->panel(path, rule, steps, top, leg);
        top -= steps * COR_LEG_STEP;
    } while (top > last && leg->end_re < enough && leg->n + 3 * COR_LEG_STEPS < COR_LEG_NODES);
    /* nearer to the base: a geometric series, exp(-omega p) being 1 */
    const double rest = 1 / (exp(path->from_zero ? 2 * COR_LEG_STEP : COR_LEG_STEP) - 1);
    leg->p_re[0] = leg->p_im[0] = 0;
    leg->w_re[0] = rest * leg->w_re[1];
    leg->w_im[0] = rest * leg->w_im[1];
    for (; leg->n % COR_LEG_PART != 0; leg->n++) { /* up to whole parts */
        leg->p_re[leg->n] = leg->end_re;
        leg->p_im[leg->n] = leg->w_re[leg->n] = leg->w_im[leg->n] = 0;
    }
}

/* ---- all of it ---- */

/* Y: eta = Theta - rho, where cosh(eta)/cosh(Theta) = 1 + 2 sinh(rho/2)^2 - tanh(Theta) sinh(rho). y is a power series
 * in the root of rho. */
static double decay_of(const struct cor_leg_rule *rule, double theta, double tanh_theta)
{
    double sum = 0;
    for (double far = theta, near; far > 0; far = near) {
        near = far > 0.3 ? 0.4 * far : 0;
        const double low = sqrt(near), high = sqrt(far);
        for (int i = 0; i < COR_LEG_GAUSS; i++) {
            const double z = low + 0.5 * (1 + rule->x[i]) * (high - low), rho = z * z;
            const double half = sinh(0.5 * rho);
            const double q = -2 * log1p(2 * half * half - tanh_theta * sinh(rho));
            sum += rule->w[i] * (high - low) * z * sqrt(0.5 * (1 + cor_lambert_t(fmax(q, 0))));
        }
    }
    return sum;
}

#define RAYLEIGH_ROW(set) {#set, cor_rayleigh_panel_##set, cor_rayleigh_octaves_##set, cor_rayleigh_lines_##set},

const struct cor_rayleigh_set *cor_rayleigh_set(int i)
{
    static const struct cor_rayleigh_set sets[] = {COR_EACH_SET(RAYLEIGH_ROW)};
    return cor_processor_has(i) ? &sets[i] : NULL;
}

void cor_spectrum_init(struct cor_spectrum *spectrum, double q0, double contact_time, double first, double high)
{
    cor_spectrum_init_by(cor_rayleigh_set(cor_widest_set()), spectrum, q0, contact_time, first, high);
}

void cor_spectrum_init_by(const struct cor_rayleigh_set *set, struct cor_spectrum *spectrum, double q0,
                          double contact_time, double first, double high)
{
    struct cor_leg_rule rule;
    struct cor_leg leg;
    double unused[COR_SPECTRUM_OCTAVES][COR_SPECTRUM_TERMS];
    rule_init(&rule);
    const double x = expm1(fmin(0.5 * q0, 300)), root_x = sqrt(x * (x + 2));
    const double theta = q0 > 600 ? 0.5 * q0 + 0.69314718055994531 : log1p(x + root_x), tanh_theta = root_x / (1 + x);
    /* far from the limit exp(-omega p) hardly turns. At `enough` it is 2^-86, and the growth of the sine no matter. */
    const double tilt = 1 / (1 + 0.03 * q0), farthest = 20;
    struct cor_leg_path path = {1, tilt, q0, tanh_theta, 1};
    const double enough = 60 / first, nearest = 1e-7 / (high * sqrt(0.5 * q0 + 25));

    spectrum->set = set;
    spectrum->half_time = 0.5 * contact_time;
    spectrum->first = first;
    spectrum->octaves = (int)fmin(ceil(log2(high / first) + 1e-9) + 1, COR_SPECTRUM_OCTAVES);
    leg_init(&leg, set, &rule, &path, nearest, farthest, enough);
    set->octaves(&leg, first, spectrum->octaves, spectrum->a_re, spectrum->a_im);

    spectrum->edges = 0;
    spectrum->decay = INFINITY;
    /* Y > (2/3) (Theta - 1)^(3/2) */
    if (theta < 1 || first * pow(theta - 1, 1.5) < 60) {
        spectrum->decay = decay_of(&rule, theta, tanh_theta);
        while (spectrum->edges < spectrum->octaves && spectrum->decay * ldexp(first, spectrum->edges) < 40)
            spectrum->edges++;
        path.from_zero = 0;
        path.scale = 1 + x;
        leg_init(&leg, set, &rule, &path, nearest, farthest, enough - spectrum->decay);
        set->octaves(&leg, first, spectrum->edges, spectrum->b, unused);
        for (int k = 0; k < spectrum->edges; k++)
            for (int j = 0; j < COR_SPECTRUM_TERMS; j++)
                spectrum->b[k][j] = -spectrum->b[k][j]; /* upwards */
    }
}

void cor_spectrum_lines(const struct cor_spectrum *spectrum, int n, const double *omega, struct cor_lines *lines)
{
    struct cor_lines some;
    int octave = 0, from = 0;
    double start = spectrum->first;
    while (from < n) {
        int to = from;
        while (octave < spectrum->octaves - 1 && omega[from] > 2 * start) {
            start *= 2;
            octave++;
        }
        while (to < n && (omega[to] <= 2 * start || octave == spectrum->octaves - 1))
            to++;
        struct cor_lines *into = &some;
        if (from == 0 && to == n)
            into = lines;
        const size_t size = (size_t)(to - from) * sizeof(double);
        spectrum->set->lines(spectrum, octave, start, to - from, omega + from, into);
        if (into == &some) {
            memcpy(lines->re + from, some.re, size);
            memcpy(lines->im + from, some.im, size);
            memcpy(lines->cosine + from, some.cosine, size);
            memcpy(lines->sine + from, some.sine, size);
            memcpy(lines->other + from, some.other, size);
        }
        from = to;
    }
    /* too far round for the short reduction */
    for (int i = n; i-- > 0 && omega[i] * spectrum->half_time > 1e6;) {
        lines->cosine[i] = cos(omega[i] * spectrum->half_time);
        lines->sine[i] = sin(omega[i] * spectrum->half_time);
    }
}
