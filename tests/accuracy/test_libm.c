/* SPDX-License-Identifier: MIT */
/* Tests the functions of the C library that the proofs of rounding errors use, against MPFR and the assumptions of the
 * proofs (tests/proof/errors.h). Random arguments are in the intervals for which the library calls the functions. Then
 * come the worst known arguments, and a search uphill from the worst one found.
 *     test_libm [--points N] [--only TEXT] [--seed N]     (N random points of each row, by default 20000)
 *     COR_TEST_LIBM=COMMAND test_libm ...                 the functions of another C library: COMMAND runs
 *                                                         tests/platforms/libm.c */
#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <mpfr.h>

#include "search.h"
#include "tests/proof/errors.h"
#include "ulp.h"

/* Error of pow, in ulp, that the proofs of gen/embed/proof.c allow: SLACK = 1e-13 there */
#define POW_ULP 450

struct row {
    struct search_function f; /* f.name begins with the name in tests/platforms/libm.c */
    int (*exact)(mpfr_t, const mpfr_t, mpfr_rnd_t);
    double first, last; /* range of the log-uniform arguments */
    double known[2];    /* worst arguments known, or 0; Zimmermann and others, Accuracy of mathematical functions */
};

static double fifth_power(double x)
{
    return pow(x, 5);
}

static int exact_fifth_power(mpfr_t y, const mpfr_t x, mpfr_rnd_t round)
{
    return mpfr_pow_ui(y, x, 5, round);
}

static double power(double x)
{
    return pow(x, 0.2);
}

static int exact_power(mpfr_t y, const mpfr_t x, mpfr_rnd_t round)
{
    mpfr_t exponent;
    mpfr_init2(exponent, 53);
    mpfr_set_d(exponent, 0.2, MPFR_RNDN);
    const int sign = mpfr_pow(y, x, exponent, round);
    mpfr_clear(exponent);
    return sign;
}

/* ---- another C library ---- */

static FILE *to_other, *from_other;
static const char *asked;

/* Starts the command and connects its standard input and output to to_other and from_other. */
static bool other_starts(const char *command)
{
    int to[2], from[2];
    if (pipe(to) != 0 || pipe(from) != 0)
        return false;
    const pid_t child = fork();
    if (child == 0) {
        dup2(to[0], STDIN_FILENO);
        dup2(from[1], STDOUT_FILENO);
        close(to[1]);
        close(from[0]);
        execl("/bin/sh", "sh", "-c", command, (char *)NULL);
        _exit(127);
    }
    close(to[0]);
    close(from[1]);
    to_other = fdopen(to[1], "w");
    from_other = fdopen(from[0], "r");
    return child > 0 && to_other && from_other;
}

static double value_of_other(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    fprintf(to_other, "%.*s %016" PRIx64 "\n", (int)strcspn(asked, ","), asked, bits);
    fflush(to_other);
    if (fscanf(from_other, "%" SCNx64, &bits) != 1) {
        fputs("test_libm: COR_TEST_LIBM gives no answer\n", stderr);
        exit(1);
    }
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* ---- the search ---- */

#define ROW(name, value, ulp, ...)                                                                                     \
    {                                                                                                                  \
        {name, value, OTHER, ulp, 0, 0, 0, 0, 0}, __VA_ARGS__                                                          \
    }
static struct row rows[] = {
    ROW("cbrt, beta^(2/3)", cbrt, COR_PROOF_CBRT_ULP, mpfr_cbrt, 1, 8, {0x1.7a337e1ba1ec2p+1, 0x1.7a337e1ba1ec2p+0}),
    ROW("cbrt, beta^(-5/3)", cbrt, COR_PROOF_CBRT_ULP, mpfr_cbrt, 0x1p14, DBL_MAX, {0x1.7a337e1ba1ec2p+256}),
    ROW("cbrt, any double", cbrt, COR_PROOF_CBRT_ULP, mpfr_cbrt, 0x1p-1074, DBL_MAX, {0x1.7a337e1ba1ec2p-257}),
    ROW("log, of a significand", log, COR_PROOF_LOG_ULP, mpfr_log, 0.7071, 1.4143, {0x1.1211bef8f68e9p+0}),
    ROW("log, 1 + t", log, COR_PROOF_LOG_ULP, mpfr_log, 1.1, 2100, {0x1.1211bef8f68e9p+0}),
    ROW("log, a small eps", log, COR_PROOF_LOG_ULP, mpfr_log, 0x1p-500, 9.2e-8, {0x1.1211bef8f68e9p+0}),
    ROW("log1p, of a quotient", log1p, COR_PROOF_LOG1P_ULP, mpfr_log1p, 0x1p-500, 0.6488, {0}),
    ROW("x^5, pow", fifth_power, POW_ULP, exact_fifth_power, 1e-40, 1e40, {0}),
    ROW("x^0.2, pow", power, POW_ULP, exact_power, 1e-300, 1e300, {0}),
};

static long double exact(const struct search_function *f, enum search_shape shape, long double x)
{
    (void)shape;
    mpfr_t y;
    mpfr_init2(y, 64);
    mpfr_set_ld(y, x, MPFR_RNDN);
    ((const struct row *)f)->exact(y, y, MPFR_RNDN);
    const long double value = mpfr_get_ld(y, MPFR_RNDN);
    mpfr_clear(y);
    return value;
}

static double random_argument(struct random_state *r, const struct search_function *f)
{
    const struct row *const row = (const struct row *)f;
    return fmin(random_log(r, row->first, row->last), row->last);
}

static void known_arguments(struct worst *worst, const struct search_function *f, const struct search_options *o)
{
    const struct row *const row = (const struct row *)f;
    for (size_t k = 0; k < COUNT_OF(row->known) && row->known[k] != 0; k++)
        worst_walk(worst, f, o, row->known[k], 0);
}

int main(int argc, char **argv)
{
    static const char help[] = "test_libm [--points N] [--only TEXT] [--seed N]\n";
    struct search_options o = {.points = 20000,
                               .seed = 19990101,
                               .threads = 1,
                               .exact = exact,
                               .random_argument = random_argument,
                               .boundaries = known_arguments,
                               .radius = 64};
    const int status = search_options_read(&o, argc, argv, help);
    if (status != 0)
        return status;
    const char *const other = getenv("COR_TEST_LIBM");
    bool good = true;
    double worst_log = 0;
    if (other && !other_starts(other))
        return fputs("test_libm: COR_TEST_LIBM does not start\n", stderr), 1;
    worst_heading(o.seed);
    for (size_t i = 0; i < COUNT_OF(rows); i++) {
        asked = rows[i].f.name;
        if (other)
            rows[i].f.value = value_of_other;
        const double worst = search_worst(&rows[i].f, &o);
        good = worst < HUGE_VAL && good;
        if (rows[i].exact == mpfr_log)
            worst_log = fmax(worst_log, worst);
    }
    const bool near = worst_log <= COR_PROOF_LOG_NEAR_ULP;
    printf("log is %s%.2f ulp: the bound of t(q) is that %s\n", near ? "within " : "not within ",
           COR_PROOF_LOG_NEAR_ULP, near ? "of 2 ulp" : "for a log within 1 ulp");
    mpfr_free_cache();
    return good ? 0 : 1;
}
