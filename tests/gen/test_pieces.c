/* SPDX-License-Identifier: MIT */
/* Tables cut from the interpolant have the stated accuracy, and a table that misses its bound is refused. */
#include "ball.h"

#include "approximation/pieces.h"
#include "enclosure/collision.h"
#include "support/digits.h"
#include "support/local.h"

static const slong PREC = 320;
static struct interpolant *f;

static int setup(void **state)
{
    (void)state;
    f = interpolant_new(&interpolant_sphere_proof, 0, 0.375);
    return f ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    interpolant_free(f);
    return 0;
}

/* Tables of every kind, up to beta = 3/8. In the second one s = beta - node^2 from row 2 onward. */
#define TABLE(of, ...)                                                                                                 \
    {                                                                                                                  \
        .quantity = (of), .root = 2, .octave_bits = PIECES_OCTAVE_BITS, .step = 0.125, .degree = 10, .name = "rows",   \
        .title = "title", .least_bits = 40, __VA_ARGS__                                                                \
    }
static const struct pieces tables[] = {
    TABLE(EPS_ZERO_OVERLAP, .variable = VARIABLE_BETA, .end = 0.25, .rows = 3, .plain = 3),
    TABLE(EPS_ZERO_FORCE, .variable = VARIABLE_ROOT_BETA, .end = 0.25, .rows = 5, .plain = 2),
    TABLE(LOSS_QUOTIENT_ZERO_OVERLAP, .variable = VARIABLE_BETA, .end = 0.25, .rows = 3, .plain = 3),
    TABLE(EPS_ZERO_OVERLAP, .variable = VARIABLE_POWER_OCTAVES, .first = -10, .end = 0x1p-8,
          .rows = 2L * PIECES_PER_OCTAVE, .plain = 2L * PIECES_PER_OCTAVE),
};

/* Evaluates row r in doubles, at a fraction of its width. Sets beta to the damping at that place. */
static double evaluate(const struct pieces *p, slong r, double fraction, double *beta)
{
    double c[32] = {0}, node = p->first + (double)r * p->step, half = p->step / 2, octave = 0;
    for (slong k = 0; k < p->degree + 2; k++)
        assert_true(digits_to_double(&c[k], p->coefficient + r * (p->degree + 2) + k));
    if (p->variable == VARIABLE_POWER_OCTAVES) {
        half = 0.5 / (double)PIECES_PER_OCTAVE;
        node = 1 + half * (2 * (double)(r % PIECES_PER_OCTAVE) + 1);
        const slong octaves = r / PIECES_PER_OCTAVE;
        octave = p->first + (double)octaves;
    }
    const double y = fmax(node - half + 2 * half * fraction, p->variable == VARIABLE_POWER_OCTAVES ? 1 : 0),
                 t = y - node;
    *beta = p->variable == VARIABLE_BETA            ? y
            : p->variable == VARIABLE_POWER_OCTAVES ? pow(ldexp(y, (int)octave), 0.2)
                                                    : y * y;
    double sum = 0;
    for (slong k = p->degree + 1; k >= 2; k--)
        sum = sum * t + c[k];
    return c[0] + (c[1] + sum * (r < p->plain ? t : y * y - node * node));
}

TEST(test_rows_are_the_function)
{
    LOCAL(collision, c);
    LOCAL(arb, x, loss);
    for (int kind = 0; kind < 4; kind++) {
        struct pieces p = tables[kind];
        assert_int_equal(pieces_make(&p, pieces_of_collision(f)), 0);
        for (slong r = 0; r < p.rows; r++) {
            assert_true(p.bits[r] >= p.least_bits);
            double beta;
            const double value = evaluate(&p, r, 0.8, &beta);
            arb_set_d(x, beta);
            assert_int_equal(collision_solve(c, x, &law_sphere, 80), 0);
            const arb_srcptr eps = p.quantity == EPS_ZERO_FORCE ? c->eps_zero_force : c->eps_zero_overlap;
            LET(loss, PREC, "(1 - eps)/x", eps, x);
            const double exact = middle(kind == 2 ? loss : eps);
            /* doubles: allow a few units for the rounding of the sum and of beta */
            check(fabs(value / exact - 1) < 2e-15, "kind %d, row %ld, beta = %g: %.17g, not %.17g", kind, (long)r, beta,
                  value, exact);
            /* c_0 + c_0' is the coefficient; c_0' is the rounding error of c_0 */
            double c0, c1;
            assert_true(digits_to_double(&c0, p.coefficient + r * (p.degree + 2)));
            assert_true(digits_to_double(&c1, p.coefficient + r * (p.degree + 2) + 1));
            assert_true(fabs(c1) <= fabs(c0) * 0x1p-53);
        }
        pieces_clear(&p);
    }
}

/* Refuses more bits than the rows have, and rows too wide for their degree. */
TEST(test_bound_missed)
{
    for (int kind = 0; kind < 4; kind++) {
        struct pieces p = tables[kind];
        p.least_bits = 75;
        assert_int_equal(pieces_make(&p, pieces_of_collision(f)), 1);
        pieces_clear(&p);
        p = tables[kind];
        p.degree = 4;
        p.least_bits = 50;
        assert_int_equal(pieces_make(&p, pieces_of_collision(f)), 1);
        pieces_clear(&p);
        /* a table may be used up to the end of its last row, but not beyond it */
        p = tables[kind];
        p.end = kind == 1 ? 0.5625 * 0.5625 : kind == 3 ? 0x1p-8 : 0.3125;
        assert_int_equal(pieces_make(&p, pieces_of_collision(f)), 0);
        pieces_clear(&p);
        p.end = nextafter(p.end, 1);
        assert_int_equal(pieces_make(&p, pieces_of_collision(f)), 1);
        pieces_clear(&p);
    }
}

GROUP(setup, teardown)
