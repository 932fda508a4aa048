/* SPDX-License-Identifier: MIT */
/* The cosine integral of cor/disk.h for one collision and any frequency,
 *
 *     I(omega) = int_0^(pi/2) sin(theta) cos(omega s(theta)) dtheta,     s(theta) = int_theta^(pi/2) sqrt(y/2) dtheta',
 *     y = 1 + t,     t - ln(1 + t) = q,     q = q0 - 2 ln(sin(theta)),
 *
 * q0 = 2 ln(v_limit/v). y is analytic in 0 < Re(theta) < pi except for branch points at pi/2 +- i Theta, where q = 0
 * and cosh(Theta) = exp(q0/2). On the line between the branch points s is imaginary. The path from 0 to pi/2 may
 * therefore run downwards from 0, come back up to pi/2 - i Theta, and follow that line, which adds nothing to the real
 * part:
 *
 *     I = Re[exp(i omega tau/2) a(omega)] + b(omega) exp(-omega Y),     Y = int_0^Theta sqrt(y(pi/2 - i eta)/2) deta.
 *
 * a omega^2 and b omega^2 vary slowly, without oscillation, and are interpolated. The neglected integral between the
 * far ends of the two legs is below 1e-12 of a at omega = 1.17. No disk has a lower frequency: the lowest mode has
 * omega > 1.1769 at any nu. */
#ifndef COR_RUNTIME_DISK_RAYLEIGH_PARTS_H
#define COR_RUNTIME_DISK_RAYLEIGH_PARTS_H

#include <stddef.h>

#include "cor/disk.h"
#include "runtime/number/kernel.h" /* COR_KERNEL */
#include "runtime/number/sets.h"

enum {
    COR_SPECTRUM_TERMS = 16,  /* terms of a polynomial in (omega - m)/(omega + m), where m is the geometric mean of an
                               * octave */
    COR_SPECTRUM_OCTAVES = 48 /* largest number of octaves */
};

/* One leg of the path, theta = base + h(rho): int sin(theta) exp(i omega s) dtheta =
 * exp(i omega s(base)) sum w exp(-omega p). Re(p) increases; n is a multiple of COR_LEG_PART. */
enum { COR_LEG_PART = 16, COR_LEG_NODES = 528 };

struct cor_leg {
    int n;
    double end_re, end_im; /* p at the current end */
    double p_re[COR_LEG_NODES], p_im[COR_LEG_NODES], w_re[COR_LEG_NODES], w_im[COR_LEG_NODES];
};

/* Size of the equal steps in u = -ln|theta - base|, and number of steps in a panel. A panel has only COR_LEG_SHORT
 * steps where zeros of the sine are about as near as the base. */
#define COR_LEG_STEP 0.14
enum { COR_LEG_STEPS = 16, COR_LEG_SHORT = 4, COR_LEG_GAUSS = 14 };

/* The Gauss-Legendre rule on [-1, 1], padded with zeros. For each of its points, the struct holds integrals of the
 * polynomial that is 1 at this point and 0 at the other points. to_steps: from x = 1 - 2 k/COR_LEG_STEPS to 1.
 * to_short: from x = 1 - 2 k/COR_LEG_SHORT to 1. */
struct cor_leg_rule {
    double x[COR_LEG_STEPS], w[COR_LEG_STEPS];
    double to_steps[COR_LEG_GAUSS][COR_LEG_STEPS], to_short[COR_LEG_GAUSS][COR_LEG_STEPS];
};

/* Number of lines (terms of I at one frequency) that the loops process together, and that their arrays hold */
enum { COR_LINES = 64, COR_LINES_ROOM = COR_LINES + COR_LANES };

/* Weights of modes in the sums below. strength: C^2. mean, echo: C^2 times the two weights of the tail
 * (rayleigh_tail.c). low, high: C^2 of modes l > 0 times the two windows. Places without a mode have weight 0. */
struct cor_mode_weights {
    double strength[COR_LINES], mean[COR_LINES], echo[COR_LINES], low[COR_LINES], high[COR_LINES];
};

/* Sums over modes. fraction: strength times (2 I)^2. faded: mean times the phase average of (2 I)^2, plus echo times
 * the deviation from that average. low, high: these weights times cos, sin of omega tau and cos, sin of omega tau/2. */
struct cor_mode_sums {
    double fraction, faded, low[4], high[4];
};

/* First and last frequencies of the cutoff weights and of the windows */
struct cor_fading {
    double mean_from, echo_from, to, low[2], high[2];
};

/* Returns a smooth step from 0 to 1, whose first three derivatives vanish at both ends. */
COR_KERNEL double cor_rayleigh_fade(double x)
{
    const double y = x < 0 ? 0 : x > 1 ? 1 : x, square = y * y;
    return square * square * (35 + y * (-84 + y * (70 - 20 * y)));
}

/* For the modes l = 0: Newton's divided differences of omega - speed n and of C^2/omega, as functions of 1/n */
enum { COR_SURFACE_FITTED = 5 };
struct cor_surface_fit {
    double speed, node[COR_SURFACE_FITTED], omega[COR_SURFACE_FITTED], strength[COR_SURFACE_FITTED];
};

/* The loops over nodes and over modes by instruction set: rayleigh_kernel.c. */
struct cor_leg_path;
struct cor_spectrum;
struct cor_lines;

struct cor_rayleigh_set {
    const char *name;
    /* Sets the real and the imaginary part of t at rho. */
    void (*start)(const struct cor_leg_path *path, double rho, double t[2]);
    /* Computes the leg's next panel, which begins at u = top. */
    void (*panel)(const struct cor_leg_path *path, const struct cor_leg_rule *rule, int steps, double top,
                  struct cor_leg *leg);
    /* Computes omega^2 sum w exp(-omega p) in octaves from `first` upwards, as Chebyshev coefficients. */
    void (*octaves)(const struct cor_leg *leg, double first, int octaves, double re[][COR_SPECTRUM_TERMS],
                    double im[][COR_SPECTRUM_TERMS]);
    /* Computes the lines from..to-1 of the octave that begins at `start`. Overwrites up to COR_LANES - 1 more. */
    void (*lines)(const struct cor_spectrum *spectrum, int octave, double start, int from, int to, const double *omega,
                  struct cor_lines *lines);
    /* Computes the other weights from weights->strength, and adds the strengths of all modes times the two windows to
     * *low and *high. beyond: 0 for surface waves, whose weight echo is 0, otherwise 1. through: 1 for modes with l >
     * 0. All arrays have COR_LINES numbers. */
    void (*weigh)(const struct cor_fading *fading, const double *omega, const double *beyond, const double *through,
                  struct cor_mode_weights *weights, double *low, double *high);
    /* Adds to *sums, and sets fraction[i] = strength (2 I)^2. */
    void (*sum)(const struct cor_lines *lines, const struct cor_mode_weights *weights, struct cor_mode_sums *sums,
                double *fraction);
    /* Sets the frequencies and C^2 of the modes n to n + COR_LINES - 1. */
    void (*surface)(const struct cor_surface_fit *fit, int n, double *omega, double *strength);
    /* Sets out[i] = sum weight[k] in[k][i] for i < count. count is a multiple of COR_LEG_PART. */
    void (*blend)(int nodes, const double *weight, const double *const *in, int count, double *out);
};

COR_TABLES(struct cor_rayleigh_set, cor_rayleigh, cor_rayleigh_set)

struct cor_spectrum {
    const struct cor_rayleigh_set *set;
    double half_time;   /* tau/2 */
    double decay;       /* Y */
    double first;       /* frequency at which the first octave begins */
    int octaves, edges; /* octaves: number of octaves of a. edges: number of octaves of b */
    double a_re[COR_SPECTRUM_OCTAVES][COR_SPECTRUM_TERMS], a_im[COR_SPECTRUM_OCTAVES][COR_SPECTRUM_TERMS];
    double b[COR_SPECTRUM_OCTAVES][COR_SPECTRUM_TERMS]; /* coefficients of omega^2 a and omega^2 b */
};

/* Computes the spectrum for frequencies from `first` to `high`; contact_time is tau. All sets give the same bits. */
void cor_spectrum_init(const struct cor_rayleigh_set *set, struct cor_spectrum *spectrum, double q0,
                       double contact_time, double first, double high);

/* The terms of I at frequencies that are processed together */
struct cor_lines {
    double re[COR_LINES_ROOM], im[COR_LINES_ROOM];       /* a */
    double cosine[COR_LINES_ROOM], sine[COR_LINES_ROOM]; /* of omega tau/2 */
    double other[COR_LINES_ROOM];                        /* b exp(-omega Y) */
};

/* Computes the lines of n <= COR_LINES increasing frequencies. The other lines are 0, for loops over all lines. */
void cor_spectrum_lines(const struct cor_spectrum *spectrum, int n, const double *omega, struct cor_lines *lines);

/* ---- many speeds ---- */

/* Spectra as a function of q0, in pieces [4^k, 4^(k+1)): the coefficients of a and of b/cosh(Theta) are interpolated at
 * Chebyshev points in ln(q0). cosh(Theta) contains the growth of b. Error of a and b, relative to a: below 1e-13,
 * measured from q0 = 1e-3 to 1500 (tests/unit/test_disk_rayleigh_spectrum.c). */
enum { COR_PIECE_NODES = 24 };

struct cor_spectrum_piece {
    const struct cor_rayleigh_set *set;
    double low, first; /* q0 is from low to 4 low. first: where the first octave of all spectra begins */
    int octaves, edges;
    double decay[COR_PIECE_NODES];
    double *node[COR_PIECE_NODES]; /* COR_SPECTRUM_TERMS numbers for each octave of a_re, a_im and b */
};

/* Returns the number of doubles that the nodes of a piece need. */
size_t cor_spectrum_piece_size(double first, double high);
/* Computes the nodes of a piece. room: an array of cor_spectrum_piece_size doubles. */
void cor_spectrum_piece_init(struct cor_spectrum_piece *piece, const struct cor_rayleigh_set *set, double low,
                             double first, double high, double *room);
void cor_spectrum_of_piece(struct cor_spectrum *spectrum, const struct cor_spectrum_piece *piece, double q0,
                           double contact_time);

/* ---- the sums over modes; the tail, which is the sum over all other modes, and its error: rayleigh_tail.c ---- */

/* A lower bound on the frequencies of any disk; the lowest is 1.1769, for nu -> 1 */
#define COR_RAYLEIGH_LEAST_OMEGA 1.17
/* Surface modes up to this multiple of the table's highest frequency are summed one by one. */
#define COR_RAYLEIGH_FAR 8.0

/* Modes that the loops process together, and their weights in the sums */
struct cor_mode_chunk {
    int count;
    double omega[COR_LINES];
    struct cor_mode_weights weights;
};

/* The modes l = 0 beyond the table, which are continued in chunks */
struct cor_surface_modes {
    int known; /* the largest n of the table; 0 if surface_init cannot continue the modes */
    double highest;
    struct cor_surface_fit fit;
    int n;              /* largest n up to which the modes have been continued */
    double omega, echo; /* frequency and weight of the mode with this n */
};

/* Data that the tail of a table needs at every speed. n_modes: the number of the highest mode */
struct cor_rayleigh_table {
    const struct cor_rayleigh_set *set;
    const struct cor_disk_modes *modes;
    size_t n_modes;
    struct cor_fading fading;
    struct cor_surface_modes surface;
    double low_strength, high_strength; /* sums of C^2 times the windows, complete once every mode has been weighted */
};

void cor_rayleigh_table_init(struct cor_rayleigh_table *table, const struct cor_rayleigh_set *set,
                             const struct cor_disk_modes *modes, size_t n_modes);

/* Computes the weights of a chunk of modes that begins with mode number i and ends before number `to`. Adds to the
 * table's sums of C^2. */
void cor_rayleigh_weigh_modes(struct cor_rayleigh_table *table, size_t i, size_t to, struct cor_mode_chunk *chunk);

/* Adds a chunk to the sums at a speed. mode_fraction: NULL, or receives the fractions of the chunk's modes. */
void cor_rayleigh_add(const struct cor_spectrum *spectrum, const struct cor_mode_chunk *chunk,
                      struct cor_mode_sums *sums, double *mode_fraction);

/* Computes the chunk after the modes up to surface->n. Returns 0 if no further chunk exists. */
int cor_surface_modes_next(struct cor_surface_modes *surface, const struct cor_rayleigh_set *set,
                           struct cor_mode_chunk *chunk);

/* Sets the tail beyond out->fraction, and the error estimate. sums: the sums over all modes of the table. surface_sum:
 * the sum `faded` over the chunks of all surface modes. */
void cor_rayleigh_finish(struct cor_disk_rayleigh *out, const struct cor_rayleigh_table *table,
                         const struct cor_spectrum *spectrum, const struct cor_mode_sums *sums, double surface_sum);

#endif
