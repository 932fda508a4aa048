/* SPDX-License-Identifier: MIT */
#include "disk_rayleigh_spectrum.h"

#include <math.h>
#include <string.h>

#include "lambert_w.h"

/* ---- complex numbers: <complex.h> would check every product for infinities ---- */

struct number {
    double re, im;
};

static inline struct number number(double re, double im)
{
    const struct number z = {re, im};
    return z;
}

static inline struct number plus(struct number x, struct number y)
{
    return number(x.re + y.re, x.im + y.im);
}

static inline struct number minus(struct number x, struct number y)
{
    return number(x.re - y.re, x.im - y.im);
}

static inline struct number times(struct number x, struct number y)
{
    return number(x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re);
}

static inline struct number scaled(double c, struct number x)
{
    return number(c * x.re, c * x.im);
}

static inline double square_modulus(struct number x)
{
    return x.re * x.re + x.im * x.im;
}

static inline struct number divided(struct number x, struct number y)
{
    return scaled(1 / square_modulus(y), times(x, number(y.re, -y.im)));
}

/* The root with Re >= 0 */
static inline struct number root(struct number x)
{
    const double modulus = sqrt(square_modulus(x)), half = sqrt(0.5 * (modulus + fabs(x.re)));
    if (half == 0)
        return number(0, 0);
    const double other = 0.5 * x.im / half;
    return x.re >= 0 ? number(half, other) : number(fabs(other), x.im < 0 ? -half : half);
}

/* ln(1 + x), without loss at small x */
static inline struct number log1p_of(struct number x)
{
    return number(0.5 * log1p(x.re * (2 + x.re) + x.im * x.im), atan2(x.im, 1 + x.re));
}

static inline struct number sine(struct number x)
{
    const double up = exp(x.im), down = 1 / up;
    const double sinh_im = fabs(x.im) < 0.5 ? sinh(x.im) : 0.5 * (up - down);
    return number(sin(x.re) * 0.5 * (up + down), cos(x.re) * sinh_im);
}

/* t - ln(1 + t) = q on the sheet where Im(t) > 0 for Im(q) > 0, from a point near by: q_near, t_near. */
static struct number solve(struct number q, struct number q_near, struct number t_near)
{
    const struct number s = root(scaled(2, q)), up = s.im < 0 ? scaled(-1, s) : s;
    const double size = square_modulus(s);
    struct number t;
    if (size < 1) {
        /* the series at the branch point, DLMF 5.11.3's; below |s| = 0.1 its next term is 2^-60 */
        static const double c[] = {1, 1.0 / 3, 1.0 / 36, -1.0 / 270, 1.0 / 4320, 1.0 / 17010, -139.0 / 5443200};
        t = number(c[6], 0);
        for (int k = 5; k >= 0; k--)
            t = plus(times(t, up), number(c[k], 0));
        t = times(t, up);
        if (size < 0.01)
            return t;
    } else {
        /* two terms of Taylor's series: t' = (1 + t)/t, t'' = -t'/t^2 */
        const struct number dq = minus(q, q_near), one = number(1, 0);
        const struct number slope = divided(plus(one, t_near), t_near);
        const struct number bend = divided(scaled(0.5, dq), times(t_near, t_near));
        t = plus(t_near, times(times(slope, dq), minus(one, bend)));
    }
    for (int k = 0; k < 12; k++) {
        /* Halley's step: d = f/f', t -= d/(1 - d f''/(2 f')) */
        const struct number y = plus(number(1, 0), t), f = minus(minus(t, log1p_of(t)), q);
        const struct number d = divided(times(f, y), t);
        const struct number step = divided(d, minus(number(1, 0), divided(scaled(0.5, d), times(t, y))));
        t = minus(t, step);
        if (square_modulus(step) < 1e-11 * square_modulus(t)) /* its cube is below 2^-52 */
            break;
    }
    return t;
}

/* ---- quadrature ---- */

enum { GAUSS = 14 };
/* Equal steps in u = -ln|theta - base|: their size, and how many make a panel; more than SHORT_FROM from the base,
 * where zeros of the sine are about as near, only SHORT. */
enum { STEPS = 16, SHORT = 4 };
#define STEP 0.14
#define SHORT_FROM 0.4

/* Gauss and Legendre's rule on [-1, 1]; and the integrals from x to 1 of the polynomial through its points, for
 * x = 1 - 2 k/STEPS and 1 - 2 k/SHORT. */
struct rule {
    double x[GAUSS], w[GAUSS], to_steps[STEPS][GAUSS], to_short[SHORT][GAUSS];
};

static void legendre(double p[GAUSS + 2], double x)
{
    p[0] = 1;
    p[1] = x;
    for (int k = 2; k < GAUSS + 2; k++)
        p[k] = ((2 * k - 1) * x * p[k - 1] - (k - 1) * p[k - 2]) / k;
}

static void rule_init(struct rule *rule)
{
    const double pi = 3.14159265358979323846;
    double p[GAUSS][GAUSS + 2], at[GAUSS + 2];
    for (int i = 0; i < GAUSS; i++) {
        double x = cos(pi * (i + 0.75) / (GAUSS + 0.5)), slope = 1;
        for (int k = 0; k < 4; k++) { /* Newton's method from a guess good to 1e-3: quadratic */
            legendre(p[i], x);
            slope = GAUSS * (x * p[i][GAUSS] - p[i][GAUSS - 1]) / (x * x - 1);
            x -= p[i][GAUSS] / slope;
        }
        legendre(p[i], x);
        rule->x[i] = x;
        rule->w[i] = 2 / ((1 - x * x) * slope * slope);
    }
    /* the polynomial's Legendre coefficients are (2 k + 1)/2 sum_j w_j P_k(x_j) f_j, the integral of P_k from x to 1 is
     * (P_(k-1)(x) - P_(k+1)(x))/(2 k + 1) */
    for (int k = 0; k < STEPS + SHORT; k++) {
        const int l = k - STEPS;
        double *const row = l < 0 ? rule->to_steps[k] : rule->to_short[l];
        const double x = l < 0 ? 1 - 2.0 * k / STEPS : 1 - 2.0 * l / SHORT;
        legendre(at, x);
        for (int j = 0; j < GAUSS; j++) {
            double sum = 0.5 * (1 - x);
            for (int k = 1; k < GAUSS; k++)
                sum += 0.5 * p[j][k] * (at[k - 1] - at[k + 1]);
            row[j] = sum * rule->w[j];
        }
    }
}

/* ---- one leg: from its base along a straight ray ---- */

struct shape {
    int from_zero; /* base 0, else pi/2 - i Theta */
    double tilt, q0, theta, tanh_theta;
};

/* h(rho) = -i rho exp(-i tilt rho/(1 + rho)): straight down, then more and more to the left, where exp(-omega p) falls
 * off without turning; and its derivative. */
static struct number h_at(const struct shape *shape, double rho)
{
    const double angle = shape->tilt * rho / (1 + rho);
    return number(-rho * sin(angle), -rho * cos(angle));
}

static struct number slope_at(const struct shape *shape, double rho)
{
    const double angle = shape->tilt * rho / (1 + rho), turn = shape->tilt * rho / ((1 + rho) * (1 + rho));
    return times(number(-sin(angle), -cos(angle)), number(1, -turn));
}

static double cosh_of(double theta)
{
    const double e = exp(theta);
    return 0.5 * (e + 1 / e);
}

static struct number q_at(const struct shape *shape, double rho)
{
    const struct number h = h_at(shape, rho);
    double modulus; /* of sin(theta), and cosh(Theta) to it, squared */
    if (shape->from_zero)
        modulus = square_modulus(sine(h));
    else {
        /* sin(theta)/cosh(Theta) = cos(h) + i tanh(Theta) sin(h) */
        const struct number half = sine(scaled(0.5, h)), full = scaled(shape->tanh_theta, sine(h));
        const struct number square = times(half, half),
                            more = number(-2 * square.re - full.im, -2 * square.im + full.re);
        if (square_modulus(more) < 0.25)
            return scaled(-2, log1p_of(more));
        modulus = square_modulus(number(1 + more.re, more.im));
    }
    /* sin(theta) = exp(i theta)/(2 i) (1 - exp(-2 i theta)), Im(theta) < 0: its argument without a jump, however far */
    const double pi = 3.14159265358979323846, re = h.re + (shape->from_zero ? 0 : 0.5 * pi);
    const double small = exp(2 * h.im - (shape->from_zero ? 0 : 2 * shape->theta));
    const double turned = atan2(small * sin(2 * re), 1 - small * cos(2 * re));
    return number((shape->from_zero ? shape->q0 : 0) - log(modulus), pi - 2 * (re + turned));
}

static struct number sin_at(const struct shape *shape, double rho, double cosh_theta)
{
    const struct number h = h_at(shape, rho);
    if (shape->from_zero)
        return sine(h);
    const struct number half = sine(scaled(0.5, h)), full = scaled(shape->tanh_theta, sine(h));
    const struct number square = times(half, half);
    return scaled(cosh_theta, number(1 - 2 * square.re - full.im, -2 * square.im + full.re));
}

/* From rho = nearest outwards, until rho = farthest or until Re(p) > enough. Trapezoidal rule in u: the integrand falls
 * off like a power on one side and faster than exponentially on the other, where exp(-omega p) does. */
static void leg_init(struct cor_leg *leg, const struct rule *rule, const struct shape *shape, double nearest,
                     double farthest, double enough)
{
    const double cosh_theta = shape->from_zero ? 1 : cosh_of(shape->theta);
    const double last = -log(farthest);
    double top = -log(nearest);
    struct number q = q_at(shape, nearest), t;
    if (shape->from_zero) {
        /* far out t = q + ln(1 + q) + ...; contraction by 1/|t| a step, so the solver begins near enough */
        t = plus(q, log1p_of(q));
        t = solve(q, minus(t, log1p_of(t)), t);
    } else
        t = solve(q, q, number(0, 1));
    /* int_0^rho sqrt(y/2) drho by parts, y' = 2 y/(y - 1) in u; at the other base y is 1; the ray starts straight down */
    struct number y = plus(number(1, 0), t), p = scaled(nearest, root(scaled(0.5, y)));
    if (shape->from_zero) {
        const struct number inverse = divided(number(1, 0), t), square = times(inverse, inverse);
        /* 1 + 1/t + 1/t^2 - 2 y/t^3 + ...: derivatives r'/r = 1/t, r''/r = 1/t^2 - 2 y/t^3 */
        const struct number second = minus(square, scaled(2, times(y, times(square, inverse))));
        p = times(p, plus(plus(number(1, 0), inverse), second));
    }
    leg->n = 1; /* 0 is kept for what lies nearer to the base */
    while (top > last && p.re < enough && leg->n + STEPS < COR_LEG_NODES - STEPS) {
        const int steps = exp(-top + STEPS * STEP) < SHORT_FROM ? STEPS : SHORT;
        const double panel = steps * STEP;
        struct number step[GAUSS];
        for (int i = 0; i < GAUSS; i++) {
            const double rho = exp(-(top - 0.5 * panel * (1 - rule->x[i])));
            const struct number next = q_at(shape, rho);
            t = solve(next, q, t);
            q = next;
            y = plus(number(1, 0), t);
            const struct number slope = slope_at(shape, rho);
            step[i] = scaled(0.5 * panel * rho, times(number(-slope.im, slope.re), root(scaled(0.5, y))));
        }
        for (int k = 0; k < steps; k++) {
            const double *const row = steps == STEPS ? rule->to_steps[k] : rule->to_short[k];
            const double rho = exp(-(top - k * STEP));
            struct number here = p;
            for (int i = 0; i < GAUSS; i++)
                here = plus(here, scaled(row[i], step[i]));
            const struct number w = times(slope_at(shape, rho), scaled(STEP * rho, sin_at(shape, rho, cosh_theta)));
            leg->p_re[leg->n] = here.re;
            leg->p_im[leg->n] = here.im;
            leg->w_re[leg->n] = w.re;
            leg->w_im[leg->n] = w.im;
            leg->n++;
        }
        for (int i = 0; i < GAUSS; i++)
            p = plus(p, scaled(rule->w[i], step[i]));
        top -= panel;
    }
    /* nearer to the base: a geometric series, exp(-omega p) being 1 */
    const double rest = 1 / (exp(shape->from_zero ? 2 * STEP : STEP) - 1);
    leg->p_re[0] = leg->p_im[0] = 0;
    leg->w_re[0] = rest * leg->w_re[1];
    leg->w_im[0] = rest * leg->w_im[1];
    for (; leg->n % COR_LEG_PART != 0; leg->n++) { /* up to whole parts */
        leg->p_re[leg->n] = p.re;
        leg->p_im[leg->n] = leg->w_re[leg->n] = leg->w_im[leg->n] = 0;
    }
}

/* ---- all of it ---- */

/* Y: eta = Theta - rho, where cosh(eta)/cosh(Theta) = 1 + 2 sinh(rho/2)^2 - tanh(Theta) sinh(rho). y is a power series
 * in the root of rho. */
static double decay_of(const struct rule *rule, double theta, double tanh_theta)
{
    double sum = 0;
    for (double far = theta, near; far > 0; far = near) {
        near = far > 0.3 ? 0.4 * far : 0;
        const double low = sqrt(near), high = sqrt(far);
        for (int i = 0; i < GAUSS; i++) {
            const double z = low + 0.5 * (1 + rule->x[i]) * (high - low), rho = z * z;
            const double half = sinh(0.5 * rho);
            const double q = -2 * log1p(2 * half * half - tanh_theta * sinh(rho));
            sum += rule->w[i] * (high - low) * z * sqrt(0.5 * (1 + cor_lambert_t(fmax(q, 0))));
        }
    }
    return sum;
}

#define SET(set)                                                                                                       \
    {                                                                                                                  \
#set, cor_rayleigh_octaves_##set, cor_rayleigh_lines_##set                                                     \
    }

const struct cor_rayleigh_set *cor_rayleigh_set(int i)
{
    static const struct cor_rayleigh_set portable = SET(portable);
#ifdef COR_X86_SETS
    static const struct cor_rayleigh_set avx2 = SET(avx2), avx512 = SET(avx512);
    if (i == 1)
        return __builtin_cpu_supports("avx2") ? &avx2 : NULL;
    if (i == 2)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                       __builtin_cpu_supports("avx512vl")
                   ? &avx512
                   : NULL;
#endif
    return i == 0 ? &portable : NULL;
}

void cor_spectrum_init(struct cor_spectrum *spectrum, double q0, double contact_time, double first, double high)
{
    int i = COR_RAYLEIGH_SETS - 1;
    while (i > 0 && !cor_rayleigh_set(i))
        i--;
    cor_spectrum_init_by(cor_rayleigh_set(i), spectrum, q0, contact_time, first, high);
}

void cor_spectrum_init_by(const struct cor_rayleigh_set *set, struct cor_spectrum *spectrum, double q0,
                          double contact_time, double first, double high)
{
    struct rule rule;
    struct cor_leg leg;
    double unused[COR_SPECTRUM_OCTAVES][COR_SPECTRUM_TERMS];
    rule_init(&rule);
    const double x = expm1(fmin(0.5 * q0, 300)), root_x = sqrt(x * (x + 2));
    const double theta = q0 > 600 ? 0.5 * q0 + 0.69314718055994531 : log1p(x + root_x), tanh_theta = root_x / (1 + x);
    /* far from the limit exp(-omega p) hardly turns. At `enough` it is 2^-86, and the growth of the sine no matter. */
    const double tilt = 1 / (1 + 0.03 * q0), farthest = 20;
    struct shape shape = {1, tilt, q0, theta, tanh_theta};
    const double enough = 60 / first, nearest = 1e-7 / (high * sqrt(0.5 * q0 + 25));

    spectrum->set = set;
    spectrum->half_time = 0.5 * contact_time;
    spectrum->first = first;
    spectrum->octaves = (int)fmin(ceil(log2(high / first) + 1e-9) + 1, COR_SPECTRUM_OCTAVES);
    leg_init(&leg, &rule, &shape, nearest, farthest, enough);
    set->octaves(&leg, first, spectrum->octaves, spectrum->a_re, spectrum->a_im);

    spectrum->edges = 0;
    spectrum->decay = INFINITY;
    /* Y > (2/3) (Theta - 1)^(3/2) */
    if (theta < 1 || first * pow(theta - 1, 1.5) < 60) {
        spectrum->decay = decay_of(&rule, theta, tanh_theta);
        while (spectrum->edges < spectrum->octaves && spectrum->decay * ldexp(first, spectrum->edges) < 40)
            spectrum->edges++;
        shape.from_zero = 0;
        leg_init(&leg, &rule, &shape, nearest, farthest, enough - spectrum->decay);
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
        struct cor_lines *const into = from == 0 && to == n ? lines : &some;
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
