/* SPDX-License-Identifier: MIT */
/* Free modes of the disk where they are hard to tell apart or to evaluate, against the frequency equation in Bessel
 * functions as Arb has them: the generator uses ratios from a recurrence, and a count. */
#include "stability.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <cor/disk.h>

#include "disk/equation.h"
#include "disk/modes.h"
#include "support/digits.h"
#include "support/precision.h"

/* One n of one disk: e = 1 + nu, s = 1 - nu */
struct equation {
    slong n, prec;
    arb_t e, s;
};

static void equation_init(struct equation *q, const fmpq_t nu, slong n, slong prec)
{
    q->n = n;
    q->prec = prec;
    arb_init(q->e);
    arb_init(q->s);
    arb_set_fmpq(q->e, nu, prec);
    arb_sub_ui(q->s, q->e, 1, prec);
    arb_neg(q->s, q->s);
    arb_add_ui(q->e, q->e, 1, prec);
}

static void equation_clear(struct equation *q)
{
    arb_clear(q->e);
    arb_clear(q->s);
}

/* J_n(z) and z J_n'(z) of z = sqrt(square) */
static void bessel(arb_t j, arb_t slope, const arb_t square, slong n, slong prec)
{
    arb_t z, order;
    arb_init(z);
    arb_init(order);
    arb_sqrt(z, square, prec);
    arb_set_si(order, n);
    arb_hypgeom_bessel_j(j, order, z, prec);
    arb_set_si(order, n + 1);
    arb_hypgeom_bessel_j(slope, order, z, prec);
    arb_mul(slope, slope, z, prec);
    arb_mul_si(order, j, n, prec);
    arb_sub(slope, order, slope, prec);
    arb_clear(z);
    arb_clear(order);
}

/* The four factors of (g + x - n^2)(g + y - n^2) = n^2 (x - 1)(y - 1), times J_n(kappa) or J_n(kappa'): g + x - n^2,
 * x - 1, g + y - n^2, y - 1. n = 0: g + x and 0. */
static void factors(arb_ptr f, const struct equation *q, const arb_t omega)
{
    arb_t g, square, j, slope, c;
    arb_init(g);
    arb_init(square);
    arb_init(j);
    arb_init(slope);
    arb_init(c);
    arb_sqr(g, omega, q->prec);
    arb_mul(g, g, q->e, q->prec);
    arb_sub_si(c, g, q->n * q->n, q->prec);
    for (int i = 0; i < 2; i++) {
        if (i == 0)
            arb_mul(square, g, q->s, q->prec);
        else
            arb_mul_2exp_si(square, g, 1);
        bessel(j, slope, square, q->n, q->prec);
        arb_mul(f + 2 * i, c, j, q->prec);
        arb_add(f + 2 * i, f + 2 * i, slope, q->prec);
        arb_sub(f + 2 * i + 1, slope, j, q->prec);
    }
    arb_clear(g);
    arb_clear(square);
    arb_clear(j);
    arb_clear(slope);
    arb_clear(c);
}

static void residual(arb_t y, const struct equation *q, const arb_t omega)
{
    arb_ptr f = _arb_vec_init(4);
    factors(f, q, omega);
    if (q->n == 0) {
        arb_set(y, f);
    } else {
        arb_mul(y, f + 1, f + 3, q->prec);
        arb_mul_si(y, y, -q->n * q->n, q->prec);
        arb_addmul(y, f, f + 2, q->prec);
    }
    _arb_vec_clear(f, 4);
}

/* A root by secants from `omega` on; a ball around it if the sign changes over 2^-bits of it. */
static bool refine(arb_t root, const struct equation *q, const arb_t omega, slong bits)
{
    arb_t x[2], y[2], step;
    for (int i = 0; i < 2; i++) {
        arb_init(x[i]);
        arb_init(y[i]);
        arb_set(x[i], omega);
        mag_zero(arb_radref(x[i]));
    }
    arb_init(step);
    arb_mul_2exp_si(step, x[0], -60);
    arb_add(x[1], x[1], step, q->prec);
    residual(y[0], q, x[0]);
    for (int i = 0; i < 40; i++) {
        residual(y[1], q, x[1]);
        arb_sub(step, y[1], y[0], q->prec);
        arb_sub(root, x[1], x[0], q->prec);
        arb_mul(root, root, y[1], q->prec);
        arb_div(step, root, step, q->prec);
        mag_zero(arb_radref(step));
        arb_swap(x[0], x[1]);
        arb_swap(y[0], y[1]);
        arb_sub(x[1], x[0], step, q->prec);
        mag_zero(arb_radref(x[1]));
        if (arb_is_zero(step) || !arb_is_finite(step) || arf_cmpabs_2exp_si(arb_midref(step), -bits - 10) < 0)
            break;
    }
    arb_mul_2exp_si(step, x[1], -bits);
    arb_set(root, x[1]);
    arb_sub(x[0], x[1], step, q->prec);
    arb_add(x[1], x[1], step, q->prec);
    residual(y[0], q, x[0]);
    residual(y[1], q, x[1]);
    const bool good =
        !arb_contains_zero(y[0]) && !arb_contains_zero(y[1]) && arf_sgn(arb_midref(y[0])) != arf_sgn(arb_midref(y[1]));
    arb_add_error(root, step);
    for (int i = 0; i < 2; i++) {
        arb_clear(x[i]);
        arb_clear(y[i]);
    }
    arb_clear(step);
    return good;
}

/* S/C from the row with the larger pivots, the size from (26) in closed form, C > 0 */
static void amplitudes(arb_t c, arb_t s, const struct equation *q, const arb_t omega)
{
    arb_ptr f = _arb_vec_init(4);
    arb_t square, x;
    arb_init(square);
    arb_init(x);
    factors(f, q, omega);
    arb_sqr(square, omega, q->prec);
    if (q->n == 0) {
        arb_zero(s);
        arb_sub_ui(x, square, 1, q->prec);
        arb_div(c, square, x, q->prec);
        arb_sqrt(c, c, q->prec);
    } else {
        /* S/C = -(g + x - n^2)/(n (x - 1)) = -n (y - 1)/(g + y - n^2) */
        arb_div(s, f, f + 1, q->prec);
        arb_div_si(s, s, -q->n, q->prec);
        arb_div(x, f + 3, f + 2, q->prec);
        arb_mul_si(x, x, -q->n, q->prec);
        if (arb_rel_accuracy_bits(x) > arb_rel_accuracy_bits(s))
            arb_set(s, x);
        /* C^2 (omega^2 (1 + (S/C)^2) - (1 + n S/C)^2) = 2 omega^2 */
        arb_mul(c, s, s, q->prec);
        arb_add_ui(c, c, 1, q->prec);
        arb_mul(c, c, square, q->prec);
        arb_mul_si(x, s, q->n, q->prec);
        arb_add_ui(x, x, 1, q->prec);
        arb_sqr(x, x, q->prec);
        arb_sub(c, c, x, q->prec);
        arb_mul_2exp_si(square, square, 1);
        arb_div(c, square, c, q->prec);
        arb_sqrt(c, c, q->prec);
        arb_mul(s, s, c, q->prec);
    }
    _arb_vec_clear(f, 4);
    arb_clear(square);
    arb_clear(x);
}

/* omega near a first guess, C and S, each to REFERENCE_BITS; false where so many bits do not give them. J_n needs 4 n
 * bits where n >> kappa; half of the others go to the root. C and S lose bits where their row of the equation nearly
 * vanishes and by the width of omega's ball, so the precision is doubled until they are narrow. */
static bool mode_reference(arb_t root, arb_t c, arb_t s, const fmpq_t nu, slong n, const arb_t guess, slong prec)
{
    enum { REFERENCE_BITS = 100, ATTEMPTS = 4 };
    bool good = false;
    struct precision p = precision_doubling(prec, ATTEMPTS);
    do {
        struct equation q;
        equation_init(&q, nu, n, p.bits);
        good = refine(root, &q, guess, (p.bits - 4 * n) / 2);
        amplitudes(c, s, &q, root);
        good = good && arb_rel_accuracy_bits(c) >= REFERENCE_BITS &&
               (n == 0 || arb_rel_accuracy_bits(s) >= REFERENCE_BITS);
        equation_clear(&q);
    } while (!good && precision_raise(&p));
    return good;
}

/* A mode of a table of doubles */
static void take_table_mode(struct outcome *out, const struct cor_disk_modes *table, const struct cor_disk_mode *mode)
{
    fmpq_t nu;
    arb_t omega, root, c, s;
    char name[60];
    fmpq_init(nu);
    arb_init(omega);
    arb_init(root);
    arb_init(c);
    arb_init(s);
    fmpq_set_si(nu, lround(100 * table->nu), 100);
    arb_set_d(omega, mode->omega);
    const bool good = mode_reference(root, c, s, nu, mode->n, omega, 300 + 4 * mode->n);
    snprintf(name, sizeof name, "nu = %g, (%d,%d), omega", table->nu, mode->n, mode->l);
    take_number(out, good ? ball_ulp(mode->omega, root) : HUGE_VAL, name, mode->omega, root, mode->omega);
    take_number(out, ball_ulp(mode->c, c), name, mode->omega, c, mode->c);
    if (mode->n > 0)
        take_number(out, ball_ulp(mode->s, s), name, mode->omega, s, mode->s);
    fmpq_clear(nu);
    arb_clear(omega);
    arb_clear(root);
    arb_clear(c);
    arb_clear(s);
}

/* A mode by the generator: omega to PROMISED bits, C and S enclosed */
static void take_solved_mode(struct outcome *out, const char *nu_text, slong n, slong l, slong prec)
{
    enum { PROMISED = 130 };
    struct disk_mode mode;
    fmpq_t nu;
    arb_t root, c, s;
    char input[160];
    fmpq_init(nu);
    arb_init(root);
    arb_init(c);
    arb_init(s);
    fmpq_set_str(nu, nu_text, 10);
    disk_mode_init(&mode);
    snprintf(input, sizeof input, "nu = %.40s, (%ld,%ld)", nu_text, n, l);
    if (disk_mode_solve(&mode, nu, n, l, PROMISED) != 0) {
        outcome_take(out, HUGE_VAL, input, "a mode", "failed");
    } else {
        const bool good = mode_reference(root, c, s, nu, n, mode.omega, prec);
        char *const exact = arb_get_str(root, 30, ARB_STR_NO_RADIUS);
        char *const value = arb_get_str(mode.omega, 30, ARB_STR_NO_RADIUS);
        double error =
            good && arb_overlaps(root, mode.omega) && arb_overlaps(c, mode.c) && arb_overlaps(s, mode.s) ? 0 : HUGE_VAL;
        error = fmax(error, ball_relative(mode.omega, root));
        /* what C loses against omega */
        out->condition = fmax(out->condition, ball_relative(mode.c, c) / ldexp(1, -PROMISED));
        outcome_take(out, error, input, exact, value);
        flint_free(exact);
        flint_free(value);
    }
    disk_mode_clear(&mode);
    fmpq_clear(nu);
    arb_clear(root);
    arb_clear(c);
    arb_clear(s);
}

static const struct cor_disk_modes *const tables[] = {&cor_disk_modes_nu033, &cor_disk_modes_nu090};

/* The relative gap above mode i of a table, among all modes or those of its n */
static double gap(const struct cor_disk_modes *table, size_t i, bool same_n)
{
    size_t j = i + 1;
    while (j < table->count && same_n && table->mode[j].n != table->mode[i].n)
        j++;
    return j < table->count ? table->mode[j].omega / table->mode[i].omega - 1 : HUGE_VAL;
}

static void near_pairs(struct outcome *out, bool full)
{
    for (size_t k = 0; k < 2; k++) {
        const struct cor_disk_modes *const t = tables[k];
        for (int same_n = 0; same_n < 2; same_n++) {
            /* the nearest few */
            double before = 0;
            for (int i = 0; i < (full ? 60 : 3); i++) {
                size_t best = 0;
                double least = HUGE_VAL;
                for (size_t j = 0; j + 1 < t->count; j++) {
                    const double d = gap(t, j, same_n);
                    if (d < least && d > before) {
                        least = d;
                        best = j;
                    }
                }
                before = least;
                take_table_mode(out, t, &t->mode[best]);
                size_t other = best + 1;
                while (same_n && t->mode[other].n != t->mode[best].n)
                    other++;
                take_table_mode(out, t, &t->mode[other]);
                if (same_n) /* what a relative error of the equation is multiplied by */
                    out->condition = fmax(out->condition, 1 / least);
            }
        }
        for (size_t j = 0; j < t->count; j++) /* by name */
            if (k == 0 && t->mode[j].n == 1 && (t->mode[j].l == 50 || t->mode[j].l == 51))
                take_table_mode(out, t, &t->mode[j]);
        for (size_t j = 0; full && j < t->count; j++)
            take_table_mode(out, t, &t->mode[j]);
    }
}

/* The exact count between and around two near roots; nothing is missed, nothing counted twice. */
static void near_pair_count(struct outcome *out, bool full)
{
    struct disk d;
    fmpq_t nu;
    arb_t w;
    fmpq_init(nu);
    arb_init(w);
    for (size_t k = 0; k < 2; k++) {
        const struct cor_disk_modes *const t = tables[k];
        fmpq_set_si(nu, lround(100 * t->nu), 100);
        disk_init(&d, nu, 200);
        for (size_t i = 0; i < t->count; i++) {
            const struct cor_disk_mode *const m = &t->mode[i];
            const double distance = gap(t, i, true);
            if (!(distance < (full ? 0.1 : 2e-3)))
                continue;
            const double at[] = {m->omega * (1 - 1e-9), m->omega * (1 + 1e-9), m->omega * (1 + distance * (1 - 1e-6)),
                                 m->omega * (1 + distance * (1 + 1e-6))};
            static const int more[] = {0, 1, 1, 2};
            for (int j = 0; j < 4; j++) {
                char input[160], expected[20], found[20];
                arb_set_d(w, at[j]);
                arb_sqr(w, w, 200);
                const slong number = disk_count(&d, m->n, w);
                snprintf(input, sizeof input, "nu = %g, (%d,%d), gap %.2g", t->nu, m->n, m->l, distance);
                snprintf(expected, sizeof expected, "%d", m->l + more[j]);
                snprintf(found, sizeof found, "%ld", number);
                outcome_take(out, number == m->l + more[j] ? 0 : 1, input, expected, found);
            }
        }
        disk_clear(&d);
    }
    fmpq_clear(nu);
    arb_clear(w);
}

static void high_n_tables(struct outcome *out, bool full)
{
    for (size_t k = 0; k < 2; k++) {
        const struct cor_disk_modes *const t = tables[k];
        size_t taken = 0;
        for (int n = 130; n > 60 && taken < (full ? 400 : 6); n--)
            for (size_t i = 0; i < t->count; i++)
                if (t->mode[i].n == n && t->mode[i].l == 0) {
                    take_table_mode(out, t, &t->mode[i]);
                    taken++;
                }
    }
}

static void high_n_generator(struct outcome *out, bool full)
{
    take_solved_mode(out, "33/100", 300, 0, 2500);
    take_solved_mode(out, "33/100", 300, 1, 2500);
    take_solved_mode(out, "9/10", 600, 0, 4500);
    if (full) {
        take_solved_mode(out, "33/100", 3000, 0, 20000);
        take_solved_mode(out, "-9/10", 1000, 3, 8000);
        take_solved_mode(out, "99/100", 2000, 5, 16000);
    }
}

/* The lowest modes as `corgen disk-modes` gives them, every number to so many digits */
static void take_lowest(struct outcome *out, const char *nu_text, slong count)
{
    enum { DIGITS = 30 };
    struct disk_modes modes;
    struct equation q;
    fmpq_t nu;
    arb_t root, x[2];
    fmpq_init(nu);
    arb_init(root);
    arb_init(x[0]);
    arb_init(x[1]);
    fmpq_set_str(nu, nu_text, 10);
    disk_modes_init(&modes);
    if (disk_modes_solve(&modes, nu, count, DIGITS) != 0)
        outcome_take(out, HUGE_VAL, nu_text, "modes", "failed");
    for (slong i = 0; i < modes.count; i++) {
        const struct disk_mode *const mode = &modes.mode[i];
        char input[160];
        equation_init(&q, nu, mode->n, 1500 + 200 * mode->n);
        const bool good = refine(root, &q, mode->omega, 500);
        amplitudes(x[0], x[1], &q, root);
        arb_srcptr const given[] = {mode->omega, mode->c, mode->s}, exact[] = {root, x[0], x[1]};
        for (int k = 0; k < (mode->n > 0 ? 3 : 2); k++) {
            char *const value = digits_of_ball(given[k], DIGITS);
            double error = HUGE_VAL;
            if (good && value != NULL && arb_overlaps(given[k], exact[k])) {
                arb_t printed;
                arb_init(printed);
                arb_set_str(printed, value, 400);
                error = ball_absolute(printed, exact[k]) / pow(10, floor(log10(upper(exact[k]))) - (double)DIGITS + 1);
                arb_clear(printed);
            }
            char *const truth = arb_get_str(exact[k], 30, ARB_STR_NO_RADIUS);
            snprintf(input, sizeof input, "%s of (%ld,%ld), nu = %.100s",
                     k == 0   ? "omega"
                     : k == 1 ? "C"
                              : "S",
                     mode->n, mode->l, nu_text);
            outcome_take(out, error, input, truth, value != NULL ? value : "none");
            free(value);
            flint_free(truth);
        }
        equation_clear(&q);
    }
    disk_modes_clear(&modes);
    fmpq_clear(nu);
    arb_clear(root);
    arb_clear(x[0]);
    arb_clear(x[1]);
}

static const char *const near_one[] = {"999999999999/1000000000000",
                                       "999999999999999999999999999999/1000000000000000000000000000000"};

static void modes_to_one(struct outcome *out, bool full)
{
    for (int i = 0; i < 2; i++)
        take_lowest(out, near_one[i], full ? 60 : 12);
}

/* kappa = kappa' at nu = -1: the two factors of the frequency equation are the same */
static void modes_to_minus_one(struct outcome *out, bool full)
{
    for (int i = 0; i < 2; i++) {
        char text[160];
        snprintf(text, sizeof text, "-%s", near_one[i]);
        take_lowest(out, text, full ? 60 : 12);
    }
}

static const struct hard_case modes_cases[] = {
    {"near pairs of modes", "two roots are taken for one, or exchanged",
     "(1,50), (1,51) of nu = 0.33, gap 4.2e-4, and the 3 nearest of each table, of one n and of all (full: all 3600 "
     "modes)",
     "the frequency equation by Arb's Bessel functions, a change of sign over 2^-150", "ulp of omega, C, S", 0.5,
     near_pairs},
    {"near pairs of modes", "the count misses two, or jumps between them",
     "around and between every two modes of one n with a gap below 2e-3 (full: 0.1)", "l of the table", "wrong answers",
     0, near_pair_count},
    {"n >> kappa", "J_n underflows", "l = 0, the 6 largest n of each table (full: all above 60)", "as above",
     "ulp of omega, C, S", 0.5, high_n_tables},
    {"n >> kappa", "the same in the generator", "(300,0), (300,1), (600,0) (full: n to 3000)",
     "as above, 2500 to 20000 bits", "relative, promised 2^-130", 0x1p-129, high_n_generator},
    {"nu -> 1", "kappa = omega sqrt(1 - nu^2) -> 0: powers of it underflow",
     "nu = 1 - 1e-12, 1 - 1e-30, the 12 lowest modes to 30 digits (full: 60)", "as above, 1500 bits and more",
     "units of the last digit", 0.5, modes_to_one},
    {"nu -> -1", "kappa and kappa' coincide, omega grows like (1 + nu)^(-1/2)", "nu = -1 + 1e-12, -1 + 1e-30, likewise",
     "as above, 1500 bits and more", "units of the last digit", 0.5, modes_to_minus_one},
};

const struct case_list stability_modes = {modes_cases, sizeof modes_cases / sizeof *modes_cases};
