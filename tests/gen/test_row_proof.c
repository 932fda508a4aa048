/* SPDX-License-Identifier: MIT */
/* Tests the proofs of the sphere's rows. Enclosures at complex damping are compared with enclosed collisions on the
 * real axis, and elsewhere with a plain integration in time. The proofs must refuse ellipses up to a singularity, rows
 * with wrong coefficients and wrong samples. The creep series is compared with enclosed collisions. */
#include "ball.h"

#include <complex.h>

#include "approximation/row_proof.h"
#include "enclosure/collision.h"
#include "enclosure/complex_collision.h"
#include "enclosure/creep_series.h"
#include "random.h"
#include "support/enclosed_function.h"
#include "support/local.h"

static void assert_in(struct complex_ball ball, double complex exact, double slack, const char *what)
{
    const double off = cabs(ball.re + I * ball.im - exact);
    check(off <= ball.radius + slack * cabs(exact), "%s: %g %+g i +- %g does not contain %g %+g i", what, ball.re,
          ball.im, ball.radius, creal(exact), cimag(exact));
    if (!(off <= 0.02 * cabs(exact))) /* the centre is off by at most 2 % */
        fail_msg("%s: the centre %g %+g i is far from %g %+g i", what, ball.re, ball.im, creal(exact), cimag(exact));
}

static const char *const field_names[COLLISION_FIELDS] = {"eps at zero overlap",  "eps at zero force",
                                                          "time of zero overlap", "time of zero force",
                                                          "largest overlap",      "its time"};

TEST(test_real_axis)
{
    static const double places[] = {0.2, 0.6, 1.07, 1.3, 1.66, 1.68, 2.2, 2.8, 3.4, 4.1};
    struct complex_collision c, by_log;
    LOCAL(collision, exact);
    LOCAL(arb, beta);
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        const double z = places[i], u = 2 * log(z);
        const bool overlap = z < 3;
        LET(beta, 200, "z^2", z);
        assert_true(complex_collision_root(&c, ball_of(z, 0), overlap));
        assert_true(u < 0.5 || complex_collision_log(&by_log, ball_of(u, 0)));
        assert_int_equal(overlap ? collision_solve(exact, beta, &law_sphere, 50)
                                 : collision_solve_force(exact, beta, &law_sphere, 50),
                         0);
        for (int k = 0; k < COLLISION_FIELDS; k++) {
            const bool of_overlap = k == 0 || k == 2;
            if (!of_overlap || overlap)
                assert_in(c.field[k], middle(exact->field[k]), 1e-12, field_names[k]);
            if (u >= 0.5 && !of_overlap)
                assert_in(by_log.field[k], pow(z, k == 1 ? 10.0 / 3 : 4.0 / 3) * middle(exact->field[k]), 1e-12,
                          field_names[k]);
        }
    }
}

/* One Runge-Kutta step for dw/ds = v/2, dv/ds = -w^2 (beta v + w^2), dt/ds = w */
static void motion_step(double complex y[3], double complex beta, double complex h)
{
    double complex k[4][3];
    for (int i = 0; i < 4; i++) {
        double complex x[3];
        for (int j = 0; j < 3; j++)
            x[j] = y[j] + (i == 0 ? 0 : (i == 3 ? h : h / 2) * k[i - 1][j]);
        k[i][0] = x[1] / 2;
        k[i][1] = -x[0] * x[0] * (beta * x[1] + x[0] * x[0]);
        k[i][2] = x[0];
    }
    for (int j = 0; j < 3; j++)
        y[j] += h / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
}

/* Starts from the event at the real part of beta and follows it with Newton's method to the event at beta. Events: 0 is
 * v = 0, 1 is zero force, 2 is w = 0. `s` is the complex place of the event. */
static void motion_event(double complex y[3], double complex beta, int event)
{
    enum { STEPS = 3000, FEWER_STEPS = STEPS / 10, PARTS = 40, NEWTON = 8 };
    double complex s = 0;
    double complex start[3] = {0, 1, 0};
    for (int j = 0; j < 3; j++)
        y[j] = start[j];
    do { /* roughly finds the event for the real part of beta */
        motion_step(y, creal(beta), 0.002);
        s += 0.002;
    } while (event == 0 ? creal(y[1]) > 0 : event == 1 ? creal(creal(beta) * y[1] + y[0] * y[0]) > 0 : creal(y[0]) > 0);
    for (int part = 0; part <= PARTS; part++) {
        const double complex b = creal(beta) + I * cimag(beta) * part / (double)PARTS;
        for (int k = 0; k < NEWTON; k++) {
            for (int j = 0; j < 3; j++)
                y[j] = start[j];
            for (int i = 0; i < FEWER_STEPS; i++)
                motion_step(y, b, s / (double)FEWER_STEPS);
            const double complex force = -y[0] * y[0] * (b * y[1] + y[0] * y[0]);
            s -= event == 0   ? y[1] / force
                 : event == 1 ? (b * y[1] + y[0] * y[0]) / (b * force + y[0] * y[1])
                              : 2 * y[0] / y[1];
        }
    }
}

TEST(test_complex_plane)
{
    for (int i = 0; i < 12; i++) {
        const double complex z = random_uniform(&draw, 0.5, 1.4) + I * random_uniform(&draw, 0.05, 0.2);
        double complex y[3];
        struct complex_collision c;
        assert_true(complex_collision_root(&c, ball_of(creal(z), cimag(z)), true));
        for (int event = 0; event < 3; event++) {
            motion_event(y, z * z, event);
            static const int speed[] = {4, 1, 0}, time[] = {5, 3, 2};
            assert_in(c.field[speed[event]], event == 0 ? y[0] * y[0] : -y[1], 1e-5, field_names[speed[event]]);
            assert_in(c.field[time[event]], y[2], 1e-5, field_names[time[event]]);
        }
    }
}

/* For beta < -h* no motion turns, so the functions have no enclosure there, and an ellipse that reaches -h* must be
 * refused. This ellipse reaches -h* for rho >= 7.92. rho = 8 is refused only after 6000 balls, which take seconds. */
TEST(test_singular)
{
    leave_to_turn(0, 3);
    struct complex_collision c;
    struct ellipse_bound bound;
    assert_false(complex_collision_root(&c, (struct complex_ball){0, 1.2, 0.03}, true));
    assert_true(complex_collision_root(&c, (struct complex_ball){0.1, 0.7, 0.001}, true));
    assert_int_equal(ellipse_bound_make(&bound, &interpolant_sphere_proof.interval[0], (double)few_or_all(16, 8)), 1);
    /* an ellipse inside another has no larger bound */
    struct ellipse_bound inner;
    assert_int_equal(ellipse_bound_make(&bound, &interpolant_sphere_proof.interval[7], 4), 0);
    assert_int_equal(ellipse_bound_make(&inner, &interpolant_sphere_proof.interval[7], 2), 0);
    for (int q = 0; q < QUANTITIES; q++)
        assert_true(inner.modulus[q] <= 1.2 * bound.modulus[q]);
}

/* The interpolant up to beta = 1, in two intervals. `corgen tables` proves all rows. */
static struct interpolant *interpolant;
static struct interpolant_proof *proof;

static int make_proof(void **state)
{
    (void)state;
    interpolant = interpolant_new(&interpolant_sphere_proof, 0, 1);
    proof = interpolant ? interpolant_proof_new(interpolant, SET_ALL, ELLIPSES_PROVED) : NULL;
    return proof ? 0 : 1;
}

static int clear_proof(void **state)
{
    (void)state;
    interpolant_proof_free(proof);
    interpolant_free(interpolant);
    return 0;
}

#define TABLE(...)                                                                                                     \
    {                                                                                                                  \
        .name = "rows", .title = "rows", .root = 2, .degree = 10, .octave_bits = 3, __VA_ARGS__                        \
    }
static const struct pieces tables[] = {
    TABLE(.quantity = EPS_ZERO_OVERLAP, .variable = VARIABLE_BETA, .step = 0.125, .end = 0.9, .rows = 8, .plain = 8),
    TABLE(.quantity = EPS_ZERO_FORCE, .variable = VARIABLE_ROOT_BETA, .step = 0.0625, .end = 0.9, .rows = 16,
          .plain = 4),
    TABLE(.quantity = EPS_ZERO_FORCE, .variable = VARIABLE_POWER_OCTAVES, .first = -8, .end = 0.015625, .rows = 16,
          .plain = 16),
    TABLE(.quantity = LOSS_QUOTIENT_ZERO_OVERLAP, .variable = VARIABLE_BETA, .step = 0.125, .end = 0.9, .rows = 8,
          .plain = 8, .head_bits = 26),
    TABLE(.quantity = DURATION_ZERO_FORCE, .variable = VARIABLE_ROOT_BETA, .step = 0.0625, .end = 0.9, .rows = 16,
          .plain = 16),
    TABLE(.quantity = MAX_OVERLAP, .variable = VARIABLE_BETA, .step = 0.125, .end = 0.9, .rows = 8, .plain = 8),
};
static const struct pieces inverse_tables[] = {
    TABLE(.quantity = BETA_QUOTIENT_ZERO_OVERLAP, .variable = VARIABLE_LOSS, .step = 0.0625, .end = 0.5, .rows = 9,
          .plain = 9, .head_bits = 26),
    TABLE(.quantity = BETA_QUOTIENT_ZERO_FORCE, .variable = VARIABLE_ROOT_LOSS, .step = 0.03125, .end = 0.5, .rows = 24,
          .plain = 24, .head_bits = 26),
    TABLE(.quantity = BETA_ZERO_OVERLAP, .variable = VARIABLE_EPS_OCTAVES, .first = -2, .end = 0.5, .rows = 8,
          .plain = 8),
};

/* A proof must fail if a coefficient other than c_0 is wrong by 2^-49 of the row's value, if c_0' is omitted, or if a
 * node is shifted. */
static void assert_row_guarded(struct pieces *p, slong row, double *c)
{
    const double bits = p->bits[row];
    const struct cell cell = pieces_cell(p, row);
    const double t = (cell.hi - cell.lo) / 2, s = cell.plain ? t : cell.hi * cell.hi - cell.node * cell.node;
    const slong k = 1 + (slong)random_below(&draw, (unsigned)p->degree + 1);
    const double kept = c[k], change = k == 1 ? 0x1p-49 * c[0] : 0x1p-49 * c[0] / (s * pow(t, (double)(k - 2)));
    c[k] += change;
    check(row_proof_bits(proof, p, row, c) < 51, "row %ld is proved with a wrong coefficient %ld, %a", (long)row,
          (long)k, change);
    c[k] = kept;

    const double rest = -log2(fabs(c[1] / c[0])), dropped = c[1];
    c[1] = 0;
    if (rest < bits - 2 && !(row_proof_bits(proof, p, row, c) < rest + 1))
        fail_msg("row %ld is proved without the second part of its constant", (long)row);
    c[1] = dropped;

    const double first = p->first;
    p->first += 0x1p-36;
    if (p->variable != VARIABLE_POWER_OCTAVES && p->variable != VARIABLE_EPS_OCTAVES &&
        row_proof_bits(proof, p, row, c) >= bits - 3)
        fail_msg("row %ld is proved with a node that is not its own", (long)row);
    p->first = first;
}

/* For two tables and one inverse, chosen at random in each run, the proved errors equal the sampled errors or exceed
 * them slightly. Wrong rows are refused. */
TEST(test_rows)
{
    for (int i = 0; i < 3; i++) {
        struct pieces p = i < 2 ? tables[random_below(&draw, sizeof tables / sizeof *tables)]
                                : inverse_tables[random_below(&draw, sizeof inverse_tables / sizeof *inverse_tables)];
        p.least_bits = 54;
        assert_int_equal(pieces_make(&p, pieces_of_collision(interpolant)), 0);
        const slong columns = p.degree + 2, chosen = (slong)random_below(&draw, (unsigned)p.rows);
        for (slong row = 0; row < p.rows; row++) {
            double *const c = p.value + row * columns;
            const double bits = row_proof_bits(proof, &p, row, c);
            check(bits <= p.bits[row] + 1e-9 && bits >= fmin(p.bits[row], 62) - 1,
                  "table %d, row %ld: %g bits proved, %g sampled", (int)p.quantity, (long)row, bits, p.bits[row]);
            c[0] *= 1 + 0x1p-49;
            assert_true(row_proof_bits(proof, &p, row, c) < 50);
            c[0] /= 1 + 0x1p-49;
            if (row == chosen || row == 0)
                assert_row_guarded(&p, row, c);
        }
        /* the table as a whole */
        assert_int_equal(row_proof_table(&p, proof), 0);
        assert_true(p.proved);
        double worst = INFINITY;
        for (slong row = 0; row < p.rows; row++)
            worst = fmin(worst, p.bits[row]);
        p.least_bits = worst + 0.01;
        assert_int_equal(row_proof_table(&p, proof), 1);
        p.least_bits = 54;
        p.value[(p.rows / 2) * columns + 2] += 0x1p-44;
        p.proved = false;
        assert_int_equal(row_proof_table(&p, proof), 1);
        assert_false(p.proved);
        pieces_clear(&p);
    }
}

/* The proof refuses an interpolant if a sample is wrong in its 52nd bit, or a node in its 40th bit. */
TEST(test_samples)
{
    LOCAL(arb, kept);
    struct samples *const samples = &interpolant->samples[1];
    const struct interval *const interval = &interpolant_sphere_proof.interval[1];
    arb_poly_struct *const polynomial = &samples->polynomial[EPS_ZERO_FORCE];
    assert_true(samples->known);
    const slong j = (slong)random_below(&draw, 40);
    const arb_ptr wrong[] = {samples->value[EPS_ZERO_FORCE] + j, samples->node + j};
    for (int k = 0; k < 2; k++) {
        arb_set(kept, wrong[k]);
        const int bit = k == 0 ? 52 : 40;
        LET(wrong[k], 200, "kept*(1 + 1/2^bit)", kept, bit);
        interpolant_through_samples(polynomial, samples, interval, EPS_ZERO_FORCE);
        struct interpolant_proof *none = interpolant_proof_new(interpolant, SET_ALL, ELLIPSES_PROVED);
        check(!none, "proved with a wrong %s %ld", k == 0 ? "sample" : "node", (long)j);
        arb_set(wrong[k], kept);
    }
    interpolant_through_samples(polynomial, samples, interval, EPS_ZERO_FORCE);
}

/* The proof covers its own intervals and no others. */
TEST(test_unknown)
{
    assert_true(proof->error[0][EPS_ZERO_OVERLAP] < 1e-20);
    assert_false(proof->error[5][EPS_ZERO_OVERLAP] < HUGE_VAL);
    struct pieces p = tables[0];
    const double c[12] = {0.5};
    p.rows = 57;
    assert_true(isnan(row_proof_bits(proof, &p, 40, c)));
    assert_false(row_proof_bits(proof, &p, 4, c) > 10);
    struct interpolant_layout another = interpolant_sphere_proof;
    another.intervals--;
    struct interpolant *other = interpolant_new(&another, 0.01, 0.02);
    assert_null(interpolant_proof_new(other, SET_ALL, ELLIPSES_PROVED));
    interpolant_free(other);
}

/* ---- the creep from zero force to zero overlap ---- */

/* From an enclosed collision, computes Y, rest = t' - 2 ln(Y) - a_1/Y - ... - a_n/Y^n for the time t' from zero force
 * to zero overlap, and a bound of the remainder. Without `last` the sum ends at n - 1. */
static void creep_rest(arb_t rest, arb_t Y, arb_t bound, const struct creep_series *s, const arb_t beta, bool last)
{
    enum { PREC = 200, BITS = 110 };
    LOCAL(collision, c);
    LOCAL(arb, r);
    assert_int_equal(collision_solve(c, beta, &law_sphere, BITS), 0);
    LET(Y, PREC, "sqrt(beta*c->eps_zero_force)*beta^2", beta, c->eps_zero_force); /* x = beta eps at zero force */
    LET(rest, PREC, "(c->t_zero_overlap - c->t_zero_force)/beta - 2*log(Y)", c->t_zero_overlap, c->t_zero_force, beta,
        Y);
    arb_inv(r, Y, PREC);
    for (slong j = 1; j <= CREEP_SERIES_ORDER - (last ? 0 : 1); j++) {
        const arb_srcptr a_j = s->a + j;
        LET(rest, PREC, "rest - a_j*r^j", rest, a_j, r, j);
    }
    creep_series_remainder(bound, s, r);
}

/* a_1 = 2, a_2 = 3/2, a_3 = 3, a_4 = 9 are computed by hand. `rest` is the constant C, so all enclosed collisions give
 * the same `rest` within the remainder, even where Y is small. Without the last term they disagree. */
TEST(test_creep_series)
{
    static const double first[] = {2, 1.5, 3, 9};
    struct creep_series s;
    LOCAL(arb, beta, constant, rest, Y, bound, x);
    creep_series_init(&s, 200);
    for (int j = 0; j < 4; j++)
        assert_true(middle(s.a + j + 1) == first[j]);
    arb_set_d(beta, 1e4);
    creep_rest(constant, Y, bound, &s, beta, true);
    assert_true(middle(bound) < 1e-100);
    for (int i = 0; i < 3; i++) {
        const double b = i == 0 ? 8.2 : random_uniform(&draw, 8.2, i == 1 ? 9 : 20);
        for (int last = 1; last >= (i == 0 ? 0 : 1); last--) {
            arb_set_d(beta, b);
            creep_rest(rest, Y, bound, &s, beta, last);
            assert_true(middle(Y) > (double)CREEP_SERIES_LEAST_Y && arb_is_finite(bound));
            LET(rest, 200, "abs(rest - constant)", rest, constant);
            const double off = middle(rest), allowed = middle(bound);
            if (last && !(off <= allowed + 1e-31))
                fail_msg("beta = %a: the series is off by %g, more than the remainder's bound %g", b, off, allowed);
            if (i == 0 && !last && !(off > allowed))
                fail_msg("beta = %a: the bound %g does not see that the last term is missing", b, allowed);
            if (i == 0)
                assert_true(allowed < 1e-19);
        }
    }
    /* no bound below CREEP_SERIES_LEAST_Y; above it the bound decreases */
    double before = HUGE_VAL;
    for (int i = -2; i < 40; i++) {
        arb_set_d(x, CREEP_SERIES_LEAST_Y + i + 0.5);
        arb_inv(x, x, 200);
        creep_series_remainder(bound, &s, x);
        assert_true(arb_is_finite(bound) == (i >= 0));
        if (i >= 0)
            assert_true(middle(bound) < before);
        before = i >= 0 ? middle(bound) : HUGE_VAL;
    }
    creep_series_clear(&s);
}

/* The enclosed functions of the polynomial p = 1 + w t contain the exact values at random t and at t = -1 and 1. ln and
 * 1/p need w < 1/2. A p with a zero, or a negative p, is refused. */
TEST(test_enclosed_functions)
{
    static const struct {
        bool (*enclosed)(arb_poly_t y, const arb_poly_t p);
        void (*exact)(arb_t y, const arb_t x, slong prec);
        double w[3];
        int bits[2]; /* bits for the first w, and for the other w */
        bool refuses;
    } functions[] = {{enclosed_exp, arb_exp, {0.35, 0.5, 0.9}, {150, 110}, false},
                     {enclosed_logarithm, arb_log, {0.2, 0.45, 0.49}, {104, 48}, true},
                     {enclosed_inverse, arb_inv, {0.2, 0.45, 0.49}, {100, 44}, true},
                     {enclosed_square_root, arb_sqrt, {0.3, 0.45, 0.49}, {44, 28}, false}};
    LOCAL(arb_poly, p, y);
    LOCAL(arb, x, t, exact);
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        for (int k = 0; k < 20; k++) {
            const double w = functions[i].w[k % 3];
            arb_poly_zero(p);
            enclosed_add_double(p, 1);
            arb_set_d(x, w);
            arb_poly_set_coeff_arb(p, 1, x);
            arb_set_d(t, k < 6 ? 1 - 2 * (k / 3) : random_uniform(&draw, -1, 1));
            arb_poly_evaluate(x, p, t, 2 * ENCLOSED_BITS);
            functions[i].exact(exact, x, 2 * ENCLOSED_BITS);
            assert_true(functions[i].enclosed(y, p));
            arb_poly_evaluate(x, y, t, 2 * ENCLOSED_BITS);
            check(arb_contains(x, exact) && mag_cmp_2exp_si(arb_radref(x), -functions[i].bits[k % 3 > 0]) < 0,
                  "function %zu at w = %g", i, w);
        }
        for (int sign = -1; sign <= 1 && functions[i].refuses; sign += 2) { /* p = -1, and p = 1 + 0.95 t */
            arb_poly_set_si(p, sign);
            arb_set_d(x, sign > 0 ? 0.95 : 0);
            arb_poly_set_coeff_arb(p, 1, x);
            assert_false(functions[i].enclosed(y, p));
        }
    }
}

/* Rows of the duration at zero overlap in ln(beta), with wrong rows and wrong samples. The samples take seconds, so
 * only a long run tests all rows; `corgen tables` proves the rows each time. */
TEST(test_creep_rows)
{
    if (!few_or_all(0, 1))
        skip();
    struct pieces p = TABLE(.quantity = DURATION_ZERO_OVERLAP, .variable = VARIABLE_LOG_BETA, .first = 2.0625,
                            .step = 0.125, .end = 10, .rows = 64, .plain = 64, .least_bits = 56);
    struct interpolant *f = interpolant_new(&interpolant_sphere_proof, 6, 22000);
    struct interpolant_proof *creep = interpolant_proof_new(f, SET_ALL, ELLIPSES_STATED), *kept = proof;
    assert_non_null(creep);
    assert_int_equal(pieces_make(&p, pieces_of_collision(f)), 0);
    proof = creep;
    for (slong row = 0; row < p.rows; row++) {
        double *const c = p.value + row * (p.degree + 2);
        const double sampled = p.bits[row];
        p.bits[row] = row_proof_bits(proof, &p, row, c);
        /* sampled errors are relative to an interpolant that is off by 4e-18, so below 2^-60 they mean nothing */
        check(p.bits[row] >= fmin(sampled, 60) - 2, "row %ld: %g bits proved, %g sampled", (long)row, p.bits[row],
              sampled);
        assert_row_guarded(&p, row, c);
    }
    proof = kept;
    assert_int_equal(row_proof_table(&p, creep), 0);
    const int last = interpolant_sphere_proof.intervals - 1;
    static const enum quantity used[] = {DURATION_ZERO_OVERLAP, DURATION_ZERO_FORCE, EPS_ZERO_FORCE};
    for (int k = 0; k < 3; k++) {
        assert_true(f->samples[last].known);
        arb_struct *const wrong = f->samples[last].value[used[k]] + random_below(&draw, 20);
        LOCAL(arb, exact);
        arb_set(exact, wrong);
        LET(wrong, 200, "exact*(1 + 1/2^58)", exact);
        interpolant_through_samples(&f->samples[last].polynomial[used[k]], &f->samples[last],
                                    &interpolant_sphere_proof.interval[last], used[k]);
        struct interpolant_proof *none = interpolant_proof_new(f, SET_ALL, ELLIPSES_STATED);
        check(!none, "proved with a wrong sample of quantity %d", (int)used[k]);
        arb_set(wrong, exact);
    }
    interpolant_proof_free(creep);
    interpolant_free(f);
    pieces_clear(&p);
}

GROUP(make_proof, clear_proof)
