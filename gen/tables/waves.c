/* SPDX-License-Identifier: MIT */
#include "tables/files.h"

#include <math.h>

#include "approximation/interpolant.h"
#include "enclosure/closed_form.h"
#include "support/console.h"
#include "support/formula.h"
#include "support/local.h"

/* ---- the Chebyshev series on 0 <= tau <= 7/4 ---- */

/* J is interpolated at SAMPLES points. Only the first TERMS terms of the series are stored, because the others are
 * below 1e-17. */
enum { SAMPLES = 110, TERMS = 40, SAMPLE_BITS = 80 };

/* Encloses the c_k of J = sum c_k T_k(8 tau/7 - 1), interpolated at SAMPLES points. */
static void chebyshev_series(arb_ptr c)
{
    enum { BITS = SAMPLE_BITS + 40 };
    LOCAL(arb, angle, x);
    LOCAL(acb, tau, j);
    for (slong i = 0; i < SAMPLES; i++) {
        progress("elastic waves", i, SAMPLES);
        LET(angle, BITS, "(2*i + 1)/(2*SAMPLES)", i, SAMPLES);
        arb_cos_pi(x, angle, BITS);
        LET(acb_realref(tau), BITS, "(x + 1)*7/8", x);
        wave_factor(j, tau, SAMPLE_BITS);
        for (slong k = 0; k < SAMPLES; k++) {
            arb_mul_si(x, angle, k, BITS);
            arb_cos_pi(x, x, BITS);
            arb_addmul(c + k, acb_realref(j), x, BITS);
        }
    }
    progress_end();
    for (slong k = 0; k < SAMPLES; k++) {
        arb_mul_ui(c + k, c + k, k == 0 ? 1 : 2, BITS);
        arb_div_ui(c + k, c + k, SAMPLES, BITS);
    }
}

/* Rounds c to doubles. Returns a proved bound on the total error of omitted terms, enclosed samples and rounding. */
static double round_series(arb_ptr c)
{
    double error = 0;
    LOCAL(arb, rest);
    for (slong k = 0; k < SAMPLES; k++) {
        const double nearest = k < TERMS ? ball_middle(c + k) : 0;
        arb_set_d(rest, nearest);
        arb_sub(rest, c + k, rest, 200);
        error += ball_magnitude(rest);
        arb_set_d(c + k, nearest);
    }
    return error;
}

static const char what[] =
    "J(nu) of a half-space, the part of its compliance that radiates elastic waves, as a Chebyshev series in\n"
    "tau = sqrt(1 - 2 nu): J = sum c_k T_k(8 tau/7 - 1), 0 <= tau <= sqrt(3), -1 <= nu <= 1/2. Evaluated by\n"
    "runtime/sphere/waves.c. Source: docs/laws.md.\n";

int wave_tables_write(FILE *file)
{
    LOCAL_VECTOR(c, SAMPLES);
    chebyshev_series(c);
    const double rounded = round_series(c);
    /* Trefethen, Approximation Theory and Approximation Practice, theorem 8.2 */
    const double cut = 4 * WAVE_ELLIPSE_BOUND * pow(WAVE_ELLIPSE, -(SAMPLES - 1)) / (WAVE_ELLIPSE - 1);
    struct emit e;
    emit_open_tables(&e, file, "wave", what, "Error: proved, see below.\n", "#include \"runtime/number/inline.h\"\n");
    emit_comment(
        &e,
        "The polynomial of degree %d through %d enclosed samples is off by %s at most, proved: |J| is below %g on\n"
        "the ellipse with foci 0 and 7/4 and half axes that add up to %g times 7/8 (tests/gen/test_waves.c). Keeping "
        "%d\n"
        "terms, rounded to doubles, adds %s at most, proved. J is between 0.65 and 3.84.",
        SAMPLES - 1, SAMPLES, emit_bound(cut).text, WAVE_ELLIPSE_BOUND, WAVE_ELLIPSE, TERMS, emit_bound(rounded).text);
    emit_geometry_real(&e, "cor_wave_factor", "END", WAVE_TAU_END);
    emit_geometry_integer(&e, "cor_wave_factor", "TERMS", TERMS);
    const int status = emit_one_row(&e, "cor_rows_wave_factor", c, TERMS);
    emit_close(&e);
    return status;
}
