/* SPDX-License-Identifier: MIT */
/* Rayleigh's energy with mode tables cut and corrupted, any datum, speed and tolerance. */
#include "cor/status.h"
#include "fuzz_table.h"

enum { MODES_MAX = 1800, MODES_FEW = 60 };

static int gives_numbers(int status)
{
    return status == COR_OK || status == COR_BEYOND_THEORY || status == COR_TOLERANCE_NOT_REACHED;
}

static int is_status(int status)
{
    return gives_numbers(status) || status == COR_ERROR_NULL || status == COR_ERROR_MODES ||
           status == COR_ERROR_DATUM || status == COR_ERROR_DISK_POISSON_RATIO || status == COR_ERROR_SPEED ||
           status == COR_ERROR_TOLERANCE;
}

static void check_sound(const struct fuzz_table *table, enum cor_disk_datum datum, double speed, size_t n,
                        const struct cor_disk_rayleigh *out, const double *part, int status)
{
    REQUIRE(out->fraction >= 0 && out->error_estimate >= 0, "%a, error %a", out->fraction, out->error_estimate);
    /* a tail from one or two modes may be nothing but error, and then below 0 */
    REQUIRE(out->tail >= -out->error_estimate, "%a + %a, error %a", out->fraction, out->tail, out->error_estimate);
    REQUIRE(out->contact_time == cor_disk_contact_time(speed, table->modes.nu, datum), "contact time %a",
            out->contact_time);
    REQUIRE((status == COR_BEYOND_THEORY) == (speed > COR_DISK_RAYLEIGH_MAX_SPEED || out->fraction + out->tail > 1),
            "status %d, v = %a, %a + %a", status, speed, out->fraction, out->tail);
    double sum = 0;
    for (size_t i = 0; part && i < n; i++) {
        REQUIRE(part[i] >= 0 && part[i] <= out->fraction * (1 + 1e-12), "mode %zu: %a of %a", i, part[i],
                out->fraction);
        sum += part[i];
    }
    if (part)
        REQUIRE(fabs(sum - out->fraction) <= 1e-12 * sum, "sum %a, fraction %a", sum, out->fraction);
}

static void check_fixed(const struct fuzz_table *table, enum cor_disk_datum datum, double speed, struct input *in)
{
    const uint8_t how = take_byte(in);
    const size_t n = how & 1 ? table->modes.count : how & 2 ? take_up_to(in, MODES_MAX) : 1;
    double *const part = how & 4 ? NULL : exactly(n * sizeof *part);
    struct cor_disk_rayleigh out, again;
    memset(&out, UNTOUCHED, sizeof out);
    if (part)
        memset(part, UNTOUCHED, n * sizeof *part);
    const int status = cor_disk_rayleigh(&table->modes, n, datum, speed, &out, part);
    REQUIRE(is_status(status) && status != COR_ERROR_TOLERANCE && status != COR_TOLERANCE_NOT_REACHED, "status %d",
            status);
    if (!gives_numbers(status)) {
        REQUIRE(is_untouched(&out, sizeof out) && (!part || is_untouched(part, n * sizeof *part)), "status %d", status);
    } else {
        REQUIRE(n >= 1 && n <= table->modes.count, "%zu modes of %zu", n, table->modes.count);
        if (table->sound)
            check_sound(table, datum, speed, n, &out, part, status);
        REQUIRE(cor_disk_rayleigh(&table->modes, n, datum, speed, &again, NULL) == status &&
                    same(again.fraction, out.fraction) && same(again.tail, out.tail),
                "without parts %a + %a, with them %a + %a", again.fraction, again.tail, out.fraction, out.tail);
    }
    free(part);
}

static void check_tolerance(const struct fuzz_table *table, enum cor_disk_datum datum, double speed, double tolerance)
{
    struct cor_disk_rayleigh out;
    size_t n = SIZE_MAX;
    memset(&out, UNTOUCHED, sizeof out);
    const int status = cor_disk_rayleigh_tolerance(&table->modes, datum, speed, tolerance, &out, &n);
    REQUIRE(is_status(status), "status %d", status);
    if (!gives_numbers(status)) {
        REQUIRE(is_untouched(&out, sizeof out) && n == SIZE_MAX, "status %d, %zu modes", status, n);
        return;
    }
    REQUIRE(tolerance > 0 && tolerance < 1, "tolerance %a, status %d", tolerance, status);
    REQUIRE(n >= 1 && n <= table->modes.count, "%zu modes of %zu", n, table->modes.count);
    if (table->sound && status == COR_OK)
        REQUIRE(out.error_estimate <= tolerance * (out.fraction + out.tail), "error %a of %a", out.error_estimate,
                out.fraction + out.tail);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input in = {data, size};
    const uint8_t how = take_byte(&in);
    const enum cor_disk_datum datum = (enum cor_disk_datum)(how < 240 ? how % 3 : take_int(&in));
    const double speed = take_double(&in), tolerance = take_double(&in);
    struct fuzz_table table;
    fuzz_table_take(&table, &in, how & 32 ? MODES_MAX : MODES_FEW);
    check_fixed(&table, datum, speed, &in);
    if (how & 128)
        check_tolerance(&table, datum, speed, tolerance);
    struct cor_disk_rayleigh out;
    REQUIRE(cor_disk_rayleigh(NULL, 1, datum, speed, &out, NULL) == COR_ERROR_NULL, "no table");
    REQUIRE(cor_disk_rayleigh_tolerance(&table.modes, datum, speed, tolerance, NULL, NULL) != COR_OK, "no result");
    fuzz_table_clear(&table);
    return 0;
}
