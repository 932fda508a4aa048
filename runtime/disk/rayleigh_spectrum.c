/* SPDX-License-Identifier: MIT */
#include "runtime/disk/rayleigh_parts.h"
#include "runtime/number/elementary.h"

#include <math.h>
#include <string.h>

#include "runtime/disk/rayleigh_path.h"
#include "runtime/number/lambert_w.h"

/* Derived: b is neglected where exp(-omega Y) is below exp(-LEFT_OUT) = 2^-57. The square of exp(LARGEST_HALF_DEPTH)
 * does not overflow, and for q0 above 600, Theta is q0/2 + ln(2) within 2^-53. */
#define LEFT_OUT 40.0
#define LARGEST_HALF_DEPTH 300.0

/* Shape and ends of the legs. Chosen; tests/unit/test_disk_rayleigh_spectrum.c and
 * tests/accuracy/test_disk_rayleigh.c assert the resulting error.
 *   LEG_ENOUGH    the largest Re(p) times the lowest frequency: exp(-omega p) is then 2^-86, small enough for any sine
 *   LEG_FARTHEST  the largest distance from the base to the end of a leg
 *   LEG_NEAREST   distance of the first node, multiplied by the largest omega and by sqrt(q0/2 + LEG_DEPTH)
 *   LEG_TILT      the ray turns by 1/(1 + LEG_TILT q0): less for large q0, where exp(-omega p) hardly oscillates */
#define LEG_ENOUGH 60.0
#define LEG_FARTHEST 20.0
#define LEG_NEAREST 1e-7
#define LEG_DEPTH 25.0
#define LEG_TILT 0.03

/* ---- quadrature ---- */

static void set_legendre(double p[COR_LEG_GAUSS + 2], double x)
{
    p[0] = 1;
    p[1] = x;
    for (int k = 2; k < COR_LEG_GAUSS + 2; k++)
        p[k] = ((2 * k - 1) * x * p[k - 1] - (k - 1) * p[k - 2]) * (1.0 / k);
}

/* Sets the integrals from x to 1. The polynomial's Legendre coefficients are (2 k + 1)/2 sum_j w_j P_k(x_j) f_j, and
 * the integral of P_k is (P_(k-1)(x) - P_(k+1)(x))/(2 k + 1). The integral from -x is the whole integral minus the
 * integral of the mirror image from x. */
static void set_integrals(double row[][COR_LEG_STEPS], int steps, double p[][COR_LEG_GAUSS + 2], const double *w)
{
    for (int k = 0; k <= steps / 2; k++) {
        double at[COR_LEG_GAUSS + 2];
        set_legendre(at, 1 - 2.0 * k / steps);
        for (int j = 0; j < COR_LEG_GAUSS / 2; j++) {
            double even = 1 - at[1], odd = 0; /* parts that are even and odd in x_j */
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
    double p[COR_LEG_GAUSS / 2][COR_LEG_GAUSS + 2];
    memset(rule, 0, sizeof *rule);
    for (int i = 0; i < COR_LEG_GAUSS / 2; i++) {
        double x = cos(COR_PI * (i + 0.75) / ((double)COR_LEG_GAUSS + 0.5)), slope = 1;
        for (int k = 0; k < 4; k++) { /* Newton's method from a start value with error 1e-3; convergence is quadratic */
            set_legendre(p[i], x);
            slope = (double)COR_LEG_GAUSS * (x * p[i][COR_LEG_GAUSS] - p[i][COR_LEG_GAUSS - 1]) / (x * x - 1);
            x -= p[i][COR_LEG_GAUSS] / slope;
        }
        set_legendre(p[i], x);
        rule->x[i] = x;
        rule->x[COR_LEG_GAUSS - 1 - i] = -x;
        rule->w[i] = rule->w[COR_LEG_GAUSS - 1 - i] = 2 / ((1 - x * x) * slope * slope);
    }
    set_integrals(rule->to_steps, COR_LEG_STEPS, p, rule->w);
    set_integrals(rule->to_short, COR_LEG_SHORT, p, rule->w);
}

/* ---- one leg: from its base along a straight ray ---- */

/* Panels that end farther than this from the base are short */
#define SHORT_FROM 0.4

/* Computes the leg from rho = nearest outwards, until rho = LEG_FARTHEST or Re(p) > enough. The trapezoidal rule in u
 * suits the integrand. It decreases like a power on one side and, because of exp(-omega p), faster than exponentially
 * on the other. */
static void leg_init(struct cor_leg *leg, const struct cor_rayleigh_set *set, const struct cor_leg_rule *rule,
                     const struct cor_leg_path *path, double nearest, double enough)
{
    const double last = -log(LEG_FARTHEST);
    double parts[2];
    set->start(path, nearest, parts);
    const struct cx t = cx_of(parts[0], parts[1]), y = cx_plus(cx_of(1, 0), t);
    /* p is int_0^rho sqrt(y/2) drho, integrated by parts with dy/du = 2 y/(y - 1). At the base pi/2 - i Theta, y is 1.
     * The ray starts straight down. */
    struct cx p = cx_scaled(nearest, cx_root(cx_scaled(0.5, y)));
    if (path->from_zero) {
        const struct cx inverse = cx_over(cx_of(1, 0), t), square = cx_times(inverse, inverse);
        /* p = rho (r + r' + r'' + ...), ' = d/du, with r = sqrt(y/2), r'/r = 1/t and r''/r = 1/t^2 - 2 y/t^3 */
        const struct cx second = cx_minus(square, cx_scaled(2, cx_times(y, cx_times(square, inverse))));
        p = cx_times(p, cx_plus(cx_plus(cx_of(1, 0), inverse), second));
    }
    leg->end_re = p.re;
    leg->end_im = p.im;
    leg->n = 1; /* node 0 represents the part nearer to the base */
    double top = -log(nearest);
    do {
        const int steps = exp(-top + (double)COR_LEG_STEPS * COR_LEG_STEP) < SHORT_FROM ? COR_LEG_STEPS : COR_LEG_SHORT;
        set->panel(path, rule, steps, top, leg);
        top -= steps * COR_LEG_STEP;
    } while (top > last && leg->end_re < enough && leg->n + 3 * COR_LEG_STEPS < COR_LEG_NODES);
    /* nearer to the base, exp(-omega p) is 1 and the sum is a geometric series */
    const double rest = 1 / (exp(path->from_zero ? 2 * COR_LEG_STEP : COR_LEG_STEP) - 1);
    leg->p_re[0] = leg->p_im[0] = 0;
    leg->w_re[0] = rest * leg->w_re[1];
    leg->w_im[0] = rest * leg->w_im[1];
    for (; leg->n % COR_LEG_PART != 0; leg->n++) { /* fills the last part */
        leg->p_re[leg->n] = leg->end_re;
        leg->p_im[leg->n] = leg->w_re[leg->n] = leg->w_im[leg->n] = 0;
    }
}

/* ---- the spectrum ---- */

/* Returns q = -2 ln(cosh(Theta - rho)/cosh(Theta)). The quotient is 1 + 2 sinh(rho/2)^2 - tanh(Theta) sinh(rho), which
 * cancels for large rho. */
static double depth_beyond(double theta, double tanh_theta, double rho)
{
    if (rho > 0.5)
        return 2 * rho + 2 * (log1p(exp(-2 * theta)) - log1p(exp(-2 * (theta - rho))));
    const double half = sinh(0.5 * rho);
    return -2 * log1p(2 * half * half - tanh_theta * sinh(rho));
}

/* Returns Y, with eta = Theta - rho. y is a power series in the square root of rho. */
static double decay_of(const struct cor_leg_rule *rule, double theta, double tanh_theta)
{
    double sum = 0;
    for (double far = theta, near; far > 0; far = near) {
        near = far > 0.3 ? 0.4 * far : 0;
        const double low = sqrt(near), high = sqrt(far);
        for (int i = 0; i < COR_LEG_GAUSS; i++) {
            const double z = low + 0.5 * (1 + rule->x[i]) * (high - low), rho = z * z;
            const double q = depth_beyond(theta, tanh_theta, rho);
            sum += rule->w[i] * (high - low) * z * sqrt(0.5 * (1 + cor_lambert_t(fmax(q, 0))));
        }
    }
    return sum;
}

/* x = cosh(Theta) - 1, Theta and tanh(Theta), where cosh(Theta) = exp(q0/2) */
struct branch_point {
    double x, theta, tanh_theta;
};

static struct branch_point branch_point_of(double q0)
{
    struct branch_point point;
    point.x = expm1(fmin(0.5 * q0, LARGEST_HALF_DEPTH));
    const double root_x = sqrt(point.x * (point.x + 2));
    point.theta = q0 > 2 * LARGEST_HALF_DEPTH ? 0.5 * q0 + COR_LN2 : log1p(point.x + root_x);
    point.tanh_theta = root_x / (1 + point.x);
    return point;
}

static int octaves_between(double first, double high)
{
    return (int)fmin(ceil(log2(high / first) + 1e-9) + 1, COR_SPECTRUM_OCTAVES);
}

/* Returns the number of octaves of b, which is neglected where exp(-omega Y) is below exp(-LEFT_OUT). */
static int count_edges(double decay, double first, int octaves)
{
    int edges = 0;
    while (edges < octaves && decay * ldexp(first, edges) < LEFT_OUT)
        edges++;
    return edges;
}

/* True if the product of `first` and Y may be below LEFT_OUT, by the bound Y > (2/3) (Theta - 1)^(3/2). */
static int may_have_edges(const struct branch_point *point, double first)
{
    return point->theta < 1 || first * pow(point->theta - 1, 1.5) < 1.5 * LEFT_OUT;
}

/* Computes b where it is not negligible or, if edges >= 0, in this number of octaves. Overwrites the caller's leg,
 * because two legs would need 34 kB of stack. */
static void init_edges(struct cor_spectrum *spectrum, struct cor_leg *leg, const struct cor_leg_rule *rule,
                       struct cor_leg_path path, const struct branch_point *point, double nearest, double enough,
                       int edges)
{
    double unused[COR_SPECTRUM_OCTAVES][COR_SPECTRUM_TERMS];
    spectrum->edges = 0;
    spectrum->decay = INFINITY;
    if (edges < 0 && !may_have_edges(point, spectrum->first))
        return;
    spectrum->decay = decay_of(rule, point->theta, point->tanh_theta);
    spectrum->edges = edges < 0 ? count_edges(spectrum->decay, spectrum->first, spectrum->octaves) : edges;
    if (spectrum->edges == 0)
        return;
    path.from_zero = 0;
    path.q0 = path.pi = 0;
    path.scale = 1 + point->x;
    /* a shorter leg suffices, because exp(-omega Y) multiplies b; if edges >= 0, interpolation in q0 needs it whole */
    leg_init(leg, spectrum->set, rule, &path, nearest, edges < 0 ? enough - spectrum->decay : enough);
    spectrum->set->octaves(leg, spectrum->first, spectrum->edges, spectrum->b, unused);
    for (int k = 0; k < spectrum->edges; k++)
        for (int j = 0; j < COR_SPECTRUM_TERMS; j++)
            spectrum->b[k][j] = -spectrum->b[k][j]; /* this leg runs upwards */
}

static void spectrum_init(struct cor_spectrum *spectrum, const struct cor_rayleigh_set *set,
                          const struct cor_leg_rule *rule, double q0, double contact_time, double first, double high,
                          int edges)
{
    struct cor_leg leg;
    const struct branch_point point = branch_point_of(q0);
    const double tilt = 1 / (1 + LEG_TILT * q0);
    const struct cor_leg_path path = {1, tilt, q0, COR_PI, point.tanh_theta, 1};
    const double enough = LEG_ENOUGH / first, nearest = LEG_NEAREST / (high * sqrt(0.5 * q0 + LEG_DEPTH));

    spectrum->set = set;
    spectrum->half_time = 0.5 * contact_time;
    spectrum->first = first;
    spectrum->octaves = octaves_between(first, high);
    leg_init(&leg, set, rule, &path, nearest, enough);
    set->octaves(&leg, first, spectrum->octaves, spectrum->a_re, spectrum->a_im);
    init_edges(spectrum, &leg, rule, path, &point, nearest, enough, edges);
}

void cor_spectrum_init(const struct cor_rayleigh_set *set, struct cor_spectrum *spectrum, double q0,
                       double contact_time, double first, double high)
{
    struct cor_leg_rule rule;
    rule_init(&rule);
    spectrum_init(spectrum, set, &rule, q0, contact_time, first, high, -1);
}

/* ---- many speeds ---- */

size_t cor_spectrum_piece_size(double first, double high)
{
    return (size_t)COR_PIECE_NODES * 3 * (size_t)octaves_between(first, high) * COR_SPECTRUM_TERMS;
}

/* Returns the place of node k of a piece in ln(q0), from -1 to 1. */
static double piece_place(int k)
{
    return -cos(COR_PI * (k + 0.5) / (double)COR_PIECE_NODES);
}

static double piece_q0(const struct cor_spectrum_piece *piece, double x)
{
    return piece->low * exp2(x + 1);
}

void cor_spectrum_piece_init(struct cor_spectrum_piece *piece, const struct cor_rayleigh_set *set, double low,
                             double first, double high, double *room)
{
    struct cor_leg_rule rule;
    struct cor_spectrum spectrum;
    rule_init(&rule);
    piece->set = set;
    piece->low = low;
    piece->first = first;
    piece->octaves = octaves_between(first, high);
    /* b has more octaves for a smaller Y. Y increases with q0, so the smallest q0 has the most octaves of b. */
    const struct branch_point point = branch_point_of(low);
    piece->edges = 0;
    if (may_have_edges(&point, first))
        piece->edges = count_edges(decay_of(&rule, point.theta, point.tanh_theta), first, piece->octaves);
    const size_t of_a = (size_t)piece->octaves * COR_SPECTRUM_TERMS, of_b = (size_t)piece->edges * COR_SPECTRUM_TERMS;
    for (int k = 0; k < COR_PIECE_NODES; k++) {
        const double q0 = piece_q0(piece, piece_place(k));
        double *const node = piece->node[k] = room + (size_t)k * 3 * of_a;
        spectrum_init(&spectrum, set, &rule, q0, 1, first, high, piece->edges);
        piece->decay[k] = piece->edges > 0 ? spectrum.decay : 0;
        memcpy(node, spectrum.a_re, of_a * sizeof *node);
        memcpy(node + of_a, spectrum.a_im, of_a * sizeof *node);
        const double unit = exp(-0.5 * q0);
        for (size_t j = 0; j < of_b; j++)
            node[2 * of_a + j] = unit * spectrum.b[j / COR_SPECTRUM_TERMS][j % COR_SPECTRUM_TERMS];
    }
}

void cor_spectrum_of_piece(struct cor_spectrum *spectrum, const struct cor_spectrum_piece *piece, double q0,
                           double contact_time)
{
    const double x = log2(q0 / piece->low) - 1;
    const size_t of_a = (size_t)piece->octaves * COR_SPECTRUM_TERMS, of_b = (size_t)piece->edges * COR_SPECTRUM_TERMS;
    const double *im[COR_PIECE_NODES], *b[COR_PIECE_NODES];
    double weight[COR_PIECE_NODES], sum = 0, decay = 0;
    /* barycentric weights; at a node, the weight of this node is 1 */
    for (int k = 0; k < COR_PIECE_NODES; k++) {
        const double distance = x - piece_place(k), angle = COR_PI * (k + 0.5) / (double)COR_PIECE_NODES;
        weight[k] = (k % 2 ? -1 : 1) * sin(angle) / (distance == 0 ? 1e-30 : distance);
        sum += weight[k];
        im[k] = piece->node[k] + of_a;
        b[k] = piece->node[k] + 2 * of_a;
    }
    for (int k = 0; k < COR_PIECE_NODES; k++) {
        weight[k] /= sum;
        decay += weight[k] * piece->decay[k];
    }
    spectrum->set = piece->set;
    spectrum->half_time = 0.5 * contact_time;
    spectrum->first = piece->first;
    spectrum->octaves = piece->octaves;
    spectrum->edges = piece->edges;
    spectrum->decay = piece->edges > 0 ? decay : INFINITY;
    piece->set->blend(COR_PIECE_NODES, weight, (const double *const *)piece->node, (int)of_a, spectrum->a_re[0]);
    piece->set->blend(COR_PIECE_NODES, weight, im, (int)of_a, spectrum->a_im[0]);
    const double unit = exp(0.5 * q0);
    for (int k = 0; k < COR_PIECE_NODES; k++)
        weight[k] *= unit;
    piece->set->blend(COR_PIECE_NODES, weight, b, (int)of_b, spectrum->b[0]);
}

/* ---- lines ---- */

void cor_spectrum_lines(const struct cor_spectrum *spectrum, int n, const double *omega, struct cor_lines *lines)
{
    double padded[COR_LINES_ROOM];
    double start = spectrum->first;
    int octave = 0;
    for (int i = 0; i < COR_LINES_ROOM; i++)
        padded[i] = i < n ? omega[i] : 1;
    for (int from = 0, to = 0; from < n; from = to) {
        while (octave < spectrum->octaves - 1 && omega[from] > 2 * start) {
            start *= 2;
            octave++;
        }
        while (to < n && (omega[to] <= 2 * start || octave == spectrum->octaves - 1))
            to++;
        spectrum->set->lines(spectrum, octave, start, from, to, padded, lines);
    }
    double *const arrays[] = {lines->re, lines->im, lines->cosine, lines->sine, lines->other};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++)
        memset(arrays[k] + n, 0, (size_t)(COR_LINES - n) * sizeof(double));
    /* cos and sin of arguments that are too large for the short reduction of the loops */
    for (int i = n; i-- > 0 && omega[i] * spectrum->half_time > 1e6;) {
        lines->cosine[i] = cos(omega[i] * spectrum->half_time);
        lines->sine[i] = sin(omega[i] * spectrum->half_time);
    }
}
