/* SPDX-License-Identifier: MIT */
/* The full dynamics of disks with mode tables cut and corrupted, any options and speed, workspaces that begin anywhere
 * and end exactly. Collisions that would take long are kept to few modes and angles. */
#include <time.h>

#include "cor/status.h"
#include "fuzz_table.h"

/* SECONDS_MAX: of a call with sanitizers; without them it is some 20 times faster. */
enum { MODES_MAX = 24, BYTES_MAX = 520000, ALIGNMENT_MAX = 64, SECONDS_MAX = 40 };

static int gives_numbers(int status)
{
    return status == COR_OK || status == COR_TOLERANCE_NOT_REACHED || status == COR_WALL_NOT_TOUCHED ||
           status == COR_CONTACT_NOT_ENDED;
}

static int is_status(int status)
{
    return gives_numbers(status) || status == COR_ERROR_NULL || status == COR_ERROR_MODES ||
           status == COR_ERROR_DISK_POISSON_RATIO || status == COR_ERROR_SPEED || status == COR_ERROR_TOLERANCE ||
           status == COR_ERROR_ALPHA || status == COR_ERROR_PHI_POINTS || status == COR_ERROR_WORKSPACE;
}

struct watched {
    size_t moments;
    double time;
};

static void observe(void *context, const struct cor_disk_moment *moment)
{
    struct watched *watched = context;
    REQUIRE(watched->moments == 0 || moment->time > watched->time, "moment %zu: time %a after %a", watched->moments,
            moment->time, watched->time);
    watched->time = moment->time;
    watched->moments++;
}

static void check_numbers(const struct fuzz_table *table, const struct cor_disk_collision *out, int status,
                          double speed, double tolerance)
{
    if (status == COR_WALL_NOT_TOUCHED)
        REQUIRE(speed <= 0 && isnan(out->eps), "v = %a: eps %a", speed, out->eps);
    if (status == COR_CONTACT_NOT_ENDED)
        REQUIRE(isnan(out->eps) && isnan(out->one_minus_eps2) && isnan(out->contact_time), "eps %a", out->eps);
    if (status != COR_OK)
        return;
    REQUIRE(isfinite(out->eps) && isfinite(out->one_minus_eps2), "COR_OK, eps %a, 1 - eps^2 %a", out->eps,
            out->one_minus_eps2);
    REQUIRE(out->one_minus_eps2 >= 0, "1 - eps^2 = %a", out->one_minus_eps2);
    if (table->sound)
        REQUIRE(out->eps >= -tolerance && out->eps <= 1 + tolerance && out->contact_time > 0 && out->steps > 0,
                "eps %a, time %a, %zu steps", out->eps, out->contact_time, out->steps);
}

static void fuzz_collide(const struct fuzz_table *table, size_t n, const struct cor_disk_collision_options *options,
                         double speed, size_t bytes, struct input *in)
{
    const uint8_t how = take_byte(in);
    const size_t offset = how % ALIGNMENT_MAX;
    char *const memory = exactly(offset + bytes);
    struct cor_disk_collision out, plain;
    struct watched watched = {0, 0};
    double *const values = exactly(4 * n * sizeof *values);
    const struct cor_disk_collision_detail detail = {values,   values + n,     take_byte(in) & 1 ? observe : NULL,
                                                     &watched, values + 2 * n, values + 3 * n};
    memset(memory, UNTOUCHED, offset + bytes);
    memset(&out, UNTOUCHED, sizeof out);
    const clock_t start = clock();
    const int status = cor_disk_collision_in(memory + offset, bytes, &table->modes, n, options, speed, &out,
                                             how & 64 ? &detail : NULL);
    const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    REQUIRE(seconds < (double)SECONDS_MAX, "%g seconds", seconds);
    REQUIRE(is_status(status) && status != COR_ERROR_WORKSPACE, "status %d", status);
    if (gives_numbers(status))
        check_numbers(table, &out, status, speed, options->tolerance);
    else
        REQUIRE(is_untouched(&out, sizeof out), "status %d", status);
    if (how & 64 && status == COR_OK) {
        double sum = 0;
        for (size_t i = 0; i < n; i++) {
            REQUIRE(values[i] >= 0 && values[n + i] >= 0, "mode %zu: %a, on average %a", i, values[i], values[n + i]);
            sum += values[i];
        }
        REQUIRE(fabs(sum - out.one_minus_eps2) <= 1e-12 * sum, "modes together %a, 1 - eps^2 %a", sum,
                out.one_minus_eps2);
        REQUIRE(!detail.observe || watched.moments > 0, "nothing was observed");
    }
    if (how & 128 && !(how & 64)) {
        memset(&plain, UNTOUCHED, sizeof plain);
        REQUIRE(cor_disk_collision(&table->modes, n, options, speed, &plain) == status, "status was %d", status);
        REQUIRE(same(plain.eps, out.eps) && same(plain.one_minus_eps2, out.one_minus_eps2) &&
                    same(plain.contact_time, out.contact_time) && same(plain.energy_drift, out.energy_drift),
                "eps %a, with a workspace %a", plain.eps, out.eps);
    }
    free(values);
    free(memory);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input in = {data, size};
    const uint8_t how = take_byte(&in);
    double speed = take_double(&in);
    struct cor_disk_collision_options options = {take_double(&in), take_double(&in), 0, 0};
    /* two of three are in the middle of what is allowed */
    if (how % 3 != 0) {
        options.alpha = 40 + fmin(fabs(options.alpha), 1) * 1000;
        options.tolerance = fmin(fmax(fabs(options.tolerance), 1e-9), 0.5);
        /* slow ones take long */
        speed = how & 4 ? speed : 0.003 + fmin(fabs(speed), 1) * (COR_DISK_COLLISION_MAX_SPEED - 0.003);
    }
    options.phi_points = how & 8 ? take_up_to(&in, 200) : 0;
    if (how & 16 && how & 32)
        input_take(&in, &options.phi_points, sizeof options.phi_points);
    struct fuzz_table table;
    fuzz_table_take(&table, &in, MODES_MAX);
    const size_t n = how & 64 ? take_up_to(&in, MODES_MAX + 2) : table.modes.count;

    const size_t bytes = cor_disk_collision_workspace(&table.modes, n, &options);
    struct cor_disk_collision out;
    memset(&out, UNTOUCHED, sizeof out);
    char little[8];
    const int refused = cor_disk_collision_in(little, sizeof little, &table.modes, n, &options, speed, &out, NULL);
    REQUIRE(is_status(refused) && !gives_numbers(refused) && is_untouched(&out, sizeof out), "status %d", refused);
    REQUIRE((refused == COR_ERROR_WORKSPACE || refused == COR_ERROR_SPEED) == (bytes > 0), "status %d, %zu bytes",
            refused, bytes);
    if (bytes == 0) {
        REQUIRE(cor_disk_collision(&table.modes, n, &options, speed, &out) == refused, "status was %d", refused);
        REQUIRE(is_untouched(&out, sizeof out), "status %d", refused);
    } else if (bytes <= BYTES_MAX) {
        fuzz_collide(&table, n, &options, speed, bytes, &in);
    }
    REQUIRE(cor_disk_collision(NULL, n, &options, speed, &out) == COR_ERROR_NULL, "no table");
    REQUIRE(cor_disk_collision(&table.modes, n, NULL, speed, &out) == COR_ERROR_NULL, "no options");
    fuzz_table_clear(&table);
    return 0;
}
