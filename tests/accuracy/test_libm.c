/* SPDX-License-Identifier: MIT */
/* The functions of the C library that the proofs of rounding errors rest on, against MPFR and against what the proofs
 * assume (tests/proof/libm_errors.h): at random arguments from the intervals for which the library calls them, at the
 * worst arguments known, and uphill from the worst one found.
 *     test_libm [--points N] [--only TEXT] [--seed N]     (N random points of each row, 20000 if not said)
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
#include "tests/proof/libm_errors.h"
#include "ulp.h"

/* What proofs of corgen embed allow for pow (gen/embed/proof.c, SLACK): 1e-13, in units of the last place */
#define POW_ULP 450

enum { KNOWN = 2 };

struct row {
    const char *name;
    double (*value)(double);
    int (*exact)(mpfr_t, const mpfr_t, mpfr_rnd_t);
    double first, last;  /* of the arguments; log-uniform */
    double ulp;          /* assumed */
    double known[KNOWN]; /* 0: none. Zimmermann and others, Accuracy of mathematical functions */
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
static const char *asked; /* the name of a function, as the other program has it */

/* Starts the command, whose standard input and output become to_other and from_other. */
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
    fprintf(to_other, "%s %016" PRIx64 "\n", asked, bits);
    fflush(to_other);
    if (fscanf(from_other, "%" SCNx64, &bits) != 1) {
        fputs("test_libm: COR_TEST_LIBM gives no answer\n", stderr);
        exit(1);
    }
    memcpy(&x, &bits, sizeof x);
    return x;
}

static const char *name_of(double (*value)(double))
{
    return value == cbrt ? "cbrt" : value == log ? "log" : value == log1p ? "log1p" : value == power ? "x^0.2" : "x^5";
}

static const struct row rows[] = {
    {"cbrt, beta^(2/3)", cbrt, mpfr_cbrt, 1, 8, COR_PROOF_CBRT_ULP, {0x1.7a337e1ba1ec2p+1, 0x1.7a337e1ba1ec2p+0}},
    {"cbrt, beta^(-5/3)", cbrt, mpfr_cbrt, 0x1p14, DBL_MAX, COR_PROOF_CBRT_ULP, {0x1.7a337e1ba1ec2p+256}},
    {"cbrt, any double", cbrt, mpfr_cbrt, 0x1p-1074, DBL_MAX, COR_PROOF_CBRT_ULP, {0x1.7a337e1ba1ec2p-257}},
    {"log, of a significand", log, mpfr_log, 0.7071, 1.4143, COR_PROOF_LOG_ULP, {0x1.1211bef8f68e9p+0}},
    {"log, 1 + t", log, mpfr_log, 1.1, 2100, COR_PROOF_LOG_ULP, {0x1.1211bef8f68e9p+0}},
    {"log, a small eps", log, mpfr_log, 0x1p-500, 9.2e-8, COR_PROOF_LOG_ULP, {0x1.1211bef8f68e9p+0}},
    {"log1p, of a quotient", log1p, mpfr_log1p, 0x1p-500, 0.6488, COR_PROOF_LOG1P_ULP, {0}},
    {"pow, x^5", fifth_power, exact_fifth_power, 1e-40, 1e40, POW_ULP, {0}},
    {"pow, x^0.2", power, exact_power, 1e-300, 1e300, POW_ULP, {0}},
};
enum { ROWS = sizeof rows / sizeof *rows };

static double error_of(const void *of, double computed, double x)
{
    const struct row *row = of;
    mpfr_t y;
    mpfr_init2(y, 64);
    mpfr_set_d(y, x, MPFR_RNDN);
    row->exact(y, y, MPFR_RNDN);
    const long double exact = mpfr_get_ld(y, MPFR_RNDN);
    mpfr_clear(y);
    return ulp_error(computed, exact);
}

static double random_argument(struct random_state *r, const void *of)
{
    const struct row *row = of;
    return fmin(random_log(r, row->first, row->last), row->last);
}

int main(int argc, char **argv)
{
    static const char help[] = "test_libm [--points N] [--only TEXT] [--seed N]\n";
    struct search_options o = {.points = 20000, .seed = 19990101, .threads = 1};
    const int status = search_options_read(&o, argc, argv, help);
    if (status != 0)
        return status;
    const char *const other = getenv("COR_TEST_LIBM");
    bool good = true;
    double worst_log = 0;
    if (other && !other_starts(other))
        return fputs("test_libm: COR_TEST_LIBM does not start\n", stderr), 1;
    worst_heading(o.seed);
    for (int i = 0; i < ROWS; i++) {
        const struct row *row = &rows[i];
        const struct search_function search = {.name = row->name,
                                               .value = other ? value_of_other : row->value,
                                               .last = row->last,
                                               .error = error_of,
                                               .random_argument = random_argument,
                                               .row = row};
        struct random_state r = random_seeded(o.seed);
        struct worst worst = {0};
        if (!search_wants(&o, row->name))
            continue;
        asked = name_of(row->value);
        for (uint64_t k = 0; k < o.points; k++)
            worst_random(&worst, &search, &r);
        worst_climb(&worst, &search, 64, 8);
        for (int k = 0; k < KNOWN && row->known[k] != 0; k++)
            worst_take(&worst, error_of(row, search.value(row->known[k]), row->known[k]), row->known[k]);
        good = worst_report(row->name, "", &worst, row->ulp) && good;
        if (row->value == log)
            worst_log = fmax(worst_log, worst.error);
    }
    printf("log is %s%.2f ulp: the bound of t(q) is that %s\n",
           worst_log <= COR_PROOF_LOG_NEAR_ULP ? "within " : "not within ", COR_PROOF_LOG_NEAR_ULP,
           worst_log <= COR_PROOF_LOG_NEAR_ULP ? "of 2 ulp" : "for a log within 1 ulp");
    mpfr_free_cache();
    return good ? 0 : 1;
}
