/* SPDX-License-Identifier: MIT */
#include "tables/limits.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cor/status.h"
#include "disk/limit_fit.h"
#include "disk/modes_rounded.h"
#include "support/clock.h"
#include "support/console.h"
#include "support/decimal.h"
#include "support/emit_c.h"
#include "support/parallel.h"
#include "sweep/crew.h"

#define PI 3.14159265358979323846

/* Nodes of Chebyshev in log10(speed) and nu, rounded to few digits; halfway between nodes, points to see how well the
 * interpolation does: OFF_NUS materials with OFF_SPEEDS speeds each. */
#define MIDDLE_SPEED 0.03
#define MIDDLE_NU 0.35
#define NU_RANGE 0.55
enum {
    SPEEDS = 13,
    NUS = 17,
    OFF_NUS = 3,
    OFF_NU_STEP = 7,
    OFF_SPEEDS = 4,
    OFF_SPEED_STEP = 3,
    MATERIALS = NUS + OFF_NUS,
    SCENES = NUS * SPEEDS + OFF_NUS * OFF_SPEEDS, /* a scene: a material at a speed */
};

/* alpha v and N: within the regimes of disk_limit_fit.h, and walls not so hard that a rim of so few modes hits them in
 * many small blows, whose outcome is chaotic. */
static const int hardness[] = {22, 30, 41, 56};
static const int counts[] = {3000, 3800, 4800, 6000, 7500};
enum {
    HARDNESSES = sizeof hardness / sizeof *hardness,
    COUNTS = sizeof counts / sizeof *counts,
    EACH = HARDNESSES * COUNTS, /* rows of a scene */
    ROWS = SCENES * EACH,
    SAMPLE = 8,
    TEXT = 24,
    LINE = 128
};

struct row {
    char nu[TEXT], speed[TEXT], alpha[TEXT]; /* the numbers are those that the texts name */
    int material;
    size_t modes;
    double one_minus_eps2; /* NaN: the tolerance was not reached */
};

static struct {
    bool known;
    long seconds; /* of processor time that made them */
    struct row row[ROWS];
} table;

bool disk_limits_known(void)
{
    return table.known;
}

void disk_limits_clear(void)
{
    table.known = false;
}

/* ---- which collisions ---- */

static void node_nu(char text[TEXT], double place)
{
    snprintf(text, TEXT, "%.3f", MIDDLE_NU - NU_RANGE * cos(PI * place / (NUS - 1)));
}

static void node_speed(char text[TEXT], double place)
{
    snprintf(text, TEXT, "%.4g", MIDDLE_SPEED * pow(10, -cos(PI * place / (SPEEDS - 1))));
}

static double number(const char *text)
{
    return strtod(text, NULL);
}

/* Scenes by material, the grid first. */
static void lay_out(struct row row[ROWS])
{
    for (int i = 0; i < ROWS; i++) {
        const int scene = i / EACH, off = scene - NUS * SPEEDS, off_nu = off / OFF_SPEEDS;
        const int nu = off < 0 ? scene / SPEEDS : off_nu * OFF_NU_STEP;
        const int speed = off < 0 ? scene % SPEEDS : off_nu + off % OFF_SPEEDS * OFF_SPEED_STEP;
        const int wall = i % EACH / COUNTS;
        row[i].material = off < 0 ? nu : NUS + off_nu;
        node_nu(row[i].nu, off < 0 ? nu : nu + 0.5);
        node_speed(row[i].speed, off < 0 ? speed : speed + 0.5);
        snprintf(row[i].alpha, TEXT, "%.6g", hardness[wall] / number(row[i].speed));
        row[i].modes = (size_t)counts[i % COUNTS];
        row[i].one_minus_eps2 = NAN;
    }
}

/* ---- collisions ---- */

struct room {
    void *bytes;
    size_t size;
};

struct outcome {
    int status;
    double one_minus_eps2;
};

struct collisions {
    struct row *row;
    const int *chosen; /* of row, `count` of them, by material */
    int count, done;
    struct cor_disk_modes modes; /* of the material at hand */
    struct room *room;           /* of each thread */
};

static void collide(void *context, int thread, uint64_t task, void *result)
{
    struct collisions *const run = context;
    const struct row *const row = &run->row[run->chosen[task]];
    struct room *const room = &run->room[thread];
    const struct cor_disk_collision_options options = {number(row->alpha), DISK_LIMITS_TOLERANCE, 0};
    const size_t needed = cor_disk_collision_workspace(&run->modes, row->modes, &options);
    struct cor_disk_collision collision = {NAN, NAN, NAN, NAN, NAN, 0};
    if (needed > room->size) {
        free(room->bytes);
        room->bytes = xmalloc(needed);
        room->size = needed;
    }
    struct outcome outcome = {cor_disk_collision_in(room->bytes, room->size, &run->modes, row->modes, &options,
                                                    number(row->speed), &collision, NULL),
                              collision.one_minus_eps2};
    if (outcome.status == COR_TOLERANCE_NOT_REACHED)
        outcome = (struct outcome){COR_OK, NAN};
    memcpy(result, &outcome, sizeof outcome);
}

static int finish(void *context, uint64_t task, const void *result)
{
    struct collisions *const run = context;
    struct row *const row = &run->row[run->chosen[task]];
    struct outcome outcome;
    memcpy(&outcome, result, sizeof outcome);
    if (outcome.status != COR_OK)
        return fail("nu = %s, v = %s, alpha = %s, N = %zu: %s", row->nu, row->speed, row->alpha, row->modes,
                    cor_status_text(outcome.status));
    /* as it will be written */
    char text[TEXT];
    snprintf(text, sizeof text, "%.8f", outcome.one_minus_eps2);
    row->one_minus_eps2 = number(text);
    progress("collisions", ++run->done, run->count);
    return STATUS_OK;
}

static int find_modes(struct cor_disk_modes *modes, const char *nu_text, size_t count)
{
    struct decimal nu = {0};
    decimal_set(&nu, nu_text);
    const int status = disk_modes_rounded(modes, nu.value, (slong)count);
    decimal_clear(&nu);
    return status;
}

/* The chosen rows, which are in order of material. */
static int collide_all(struct row *row, const int *chosen, int count)
{
    const int threads = parallel_threads();
    struct collisions run = {row, chosen, count, 0, {0, 0, NULL}, xmalloc((size_t)threads * sizeof(struct room))};
    memset(run.room, 0, (size_t)threads * sizeof *run.room);
    const struct crew_work work = {&run, sizeof(struct outcome), collide, NULL, finish, NULL, NULL};
    struct crew *const crew = crew_start(&work, threads);
    int status = crew ? STATUS_OK : STATUS_FAILED;
    for (int first = 0, end; first < count && status == STATUS_OK; first = end) {
        const struct row *const one = &row[chosen[first]];
        size_t modes = 0;
        for (end = first; end < count && row[chosen[end]].material == one->material; end++)
            modes = row[chosen[end]].modes > modes ? row[chosen[end]].modes : modes;
        status = find_modes(&run.modes, one->nu, modes);
        if (status == STATUS_OK) {
            status = crew_run(crew, (uint64_t)first, (uint64_t)end);
            free((void *)run.modes.mode);
        }
    }
    progress_end();
    crew_stop(crew);
    for (int i = 0; i < threads; i++)
        free(run.room[i].bytes);
    free(run.room);
    return status;
}

static int *all_rows(void)
{
    int *const chosen = xmalloc(ROWS * sizeof *chosen);
    for (int i = 0; i < ROWS; i++)
        chosen[i] = i;
    return chosen;
}

int disk_limits_collide(void)
{
    const double start = clock_processor_seconds();
    disk_limits_clear();
    lay_out(table.row);
    int *const chosen = all_rows();
    const int status = collide_all(table.row, chosen, ROWS);
    free(chosen);
    table.known = status == STATUS_OK;
    table.seconds = lround(clock_processor_seconds() - start);
    return status;
}

/* ---- the file of collisions ---- */

#define SECONDS_START "# made-with "
#define SECONDS_END " seconds of processor time\n"

static const char rows_head[] =
    "# SPDX-License-Identifier: MIT\n"
    "# Collisions of elastic disks of N modes with walls of hardness alpha, (41) to (45) of Gerl and Zippelius "
    "(1999),\n"
    "# to an error of 1e-7 in eps (estimated); disk_limits.h is what they tend to.\n"
    "# Written by:  corgen tables --all\n"
    "# Checked by:  corgen tables --check, which collides a random sample again, and corgen tables --check --all\n";
static const char rows_names[] = "nu,speed,alpha,modes,one_minus_eps2\n";

static void row_text(char text[LINE], const struct row *row)
{
    snprintf(text, LINE, "%s,%s,%s,%zu,", row->nu, row->speed, row->alpha, row->modes);
}

int disk_limits_rows_write(FILE *file, const struct disk_table *unused)
{
    (void)unused;
    fputs(rows_head, file);
    fprintf(file, SECONDS_START "%ld" SECONDS_END, table.seconds);
    fputs(rows_names, file);
    for (int i = 0; i < ROWS; i++) {
        char line[LINE];
        row_text(line, &table.row[i]);
        fprintf(file, isnan(table.row[i].one_minus_eps2) ? "%snan\n" : "%s%.8f\n", line, table.row[i].one_minus_eps2);
    }
    return STATUS_OK;
}

/* Passes over `word` at *at; false where it is not there. */
static bool pass(const char **at, const char *word)
{
    const size_t length = strlen(word);
    if (strncmp(*at, word, length) != 0)
        return false;
    *at += length;
    return true;
}

/* As it is written: 0.12345678 or nan, and the line's end. */
static bool pass_value(const char **at, double *value)
{
    if (pass(at, "nan\n")) {
        *value = NAN;
        return true;
    }
    const char *const text = *at;
    if (!pass(at, "0.") || strspn(*at, "0123456789") != 8)
        return false;
    *at += 8;
    *value = number(text);
    return pass(at, "\n");
}

static int read_text(const char *text, const char *path)
{
    const char *at = text;
    disk_limits_clear();
    lay_out(table.row);
    if (!pass(&at, rows_head))
        return fail("%s does not begin like the collisions that corgen tables --all writes", path);
    bool good = pass(&at, SECONDS_START) && strspn(at, "0123456789") > 0 && strspn(at, "0123456789") < TEXT / 2;
    if (good) {
        char *end;
        table.seconds = strtol(at, &end, 10);
        at = end;
    }
    good = good && pass(&at, SECONDS_END) && pass(&at, rows_names);
    for (int i = 0; i < ROWS && good; i++) {
        char line[LINE];
        row_text(line, &table.row[i]);
        good = pass(&at, line) && pass_value(&at, &table.row[i].one_minus_eps2);
    }
    if (!good || *at) {
        long line = 1;
        for (const char *c = text; c < at; c++)
            line += *c == '\n';
        return fail("%s is not as corgen tables --all writes it in line %ld", path, line);
    }
    table.known = true;
    return STATUS_OK;
}

int disk_limits_read(const char *bytes, size_t size, const char *path)
{
    char *const text = xmalloc(size + 1);
    memcpy(text, bytes, size);
    text[size] = '\0';
    const int status = strlen(text) == size ? read_text(text, path) : fail("%s is not a text", path);
    free(text);
    return status;
}

/* ---- once more ---- */

static int check(const int *chosen, int count, const char *of_what)
{
    struct row *const again = xmalloc(sizeof table.row);
    memcpy(again, table.row, sizeof table.row);
    int status = collide_all(again, chosen, count), different = 0, first = 0;
    double most = 0;
    for (int i = 0; i < count && status == STATUS_OK; i++) {
        const double before = table.row[chosen[i]].one_minus_eps2, now = again[chosen[i]].one_minus_eps2;
        const double difference = isnan(before) && isnan(now) ? 0 : fabs(now - before);
        if (!(difference <= DISK_LIMITS_AGREE) && different++ == 0)
            first = chosen[i];
        most = fmax(most, difference);
    }
    if (status == STATUS_OK && different) {
        char line[LINE];
        row_text(line, &table.row[first]);
        status = fail("%s: %d of %d collisions (%s) differ by more than %.0e, first %s%.8f, which is %.8f",
                      DISK_LIMITS_ROWS_FILE, different, count, of_what, DISK_LIMITS_AGREE, line,
                      table.row[first].one_minus_eps2, again[first].one_minus_eps2);
    }
    if (status == STATUS_OK)
        printf("collided %d of %d rows of %s again (%s): 1 - eps^2 differs by %.1e at most\n", count, ROWS,
               DISK_LIMITS_ROWS_FILE, of_what, most);
    free(again);
    return status;
}

int disk_limits_check_all(void)
{
    int *const chosen = all_rows();
    const int status = check(chosen, ROWS, "all");
    free(chosen);
    return status;
}

/* xorshift64* */
static uint64_t draw(uint64_t *state, uint64_t below)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return (*state * UINT64_C(2685821657736338717) >> 33) % below;
}

/* Of one material, whose modes are what takes longest. */
int disk_limits_check_sample(uint64_t seed)
{
    uint64_t state = 2 * seed + 1;
    for (int i = 0; i < 8; i++) /* seeds that differ in few bits soon differ in all */
        draw(&state, 2);
    const int material = (int)draw(&state, MATERIALS);
    int first = 0, count = 0, chosen[SAMPLE];
    while (table.row[first].material != material)
        first++;
    while (first + count < ROWS && table.row[first + count].material == material)
        count++;
    for (int i = 0; i < SAMPLE; i++)
        chosen[i] = first + (int)draw(&state, (uint64_t)count);
    char of_what[LINE];
    snprintf(of_what, sizeof of_what, "nu = %s, seed %" PRIu64, table.row[first].nu, seed);
    return check(chosen, SAMPLE, of_what);
}

/* ---- limits ---- */

struct limits {
    struct disk_limit of[SCENES];
    double coefficient[NUS][SPEEDS]; /* of T_j(nu) T_i(log10 speed), rounded as they will be written */
    double interpolation;            /* largest error seen halfway between nodes */
};

/* Rounded to so many places, as a text and back. */
static double rounded(char text[TEXT], double value, int places)
{
    snprintf(text, TEXT, "%.*f", places, value);
    return number(text);
}

enum { PLACES = 6, COEFFICIENT_PLACES = 8 };

static double rounded_up(double value)
{
    return ceil(value * 1e6) / 1e6;
}

static int find_limits(struct limits *limits)
{
    for (int i = 0; i < SCENES; i++) {
        const struct row *const row = &table.row[i * EACH];
        struct disk_limit_row of_scene[EACH];
        for (int k = 0; k < EACH; k++)
            of_scene[k] = (struct disk_limit_row){number(row[k].alpha), row[k].modes, row[k].one_minus_eps2};
        const enum disk_limit_status status = disk_limit_fit(&limits->of[i], number(row->speed), of_scene, EACH);
        if (status != DISK_LIMIT_OK)
            return fail("no limit for nu = %s, v = %s: %s", row->nu, row->speed, disk_limit_text(status));
        char text[TEXT];
        limits->of[i].one_minus_eps2 = rounded(text, limits->of[i].one_minus_eps2, PLACES);
        limits->of[i].uncertainty = rounded_up(limits->of[i].uncertainty + 0.5e-6);
    }
    return STATUS_OK;
}

/* sum_k c_k T_k(x_i) = y_i by elimination, y becoming c; the nodes are good ones, and no pivot is small. */
static void interpolate(double *y, const double *x, int n, size_t stride)
{
    double a[SPEEDS > NUS ? SPEEDS : NUS][SPEEDS > NUS ? SPEEDS : NUS] = {{0}};
    for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++)
            a[i][k] = k == 0 ? 1 : k == 1 ? x[i] : 2 * x[i] * a[i][k - 1] - a[i][k - 2];
    for (int k = 0; k < n; k++) {
        int pivot = k;
        for (int i = k + 1; i < n; i++)
            if (fabs(a[i][k]) > fabs(a[pivot][k]))
                pivot = i;
        for (int j = 0; j < n; j++) {
            const double swapped = a[k][j];
            a[k][j] = a[pivot][j];
            a[pivot][j] = swapped;
        }
        const double swapped = y[(size_t)k * stride];
        y[(size_t)k * stride] = y[(size_t)pivot * stride];
        y[(size_t)pivot * stride] = swapped;
        for (int i = k + 1; i < n; i++) {
            const double factor = a[i][k] / a[k][k];
            for (int j = k; j < n; j++)
                a[i][j] -= factor * a[k][j];
            y[(size_t)i * stride] -= factor * y[(size_t)k * stride];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++)
            y[(size_t)k * stride] -= a[k][j] * y[(size_t)j * stride];
        y[(size_t)k * stride] /= a[k][k];
    }
}

static double scaled_speed(const struct row *row)
{
    return log10(number(row->speed) / MIDDLE_SPEED);
}

static double scaled_nu(const struct row *row)
{
    return (number(row->nu) - MIDDLE_NU) / NU_RANGE;
}

static double value_between(const struct limits *limits, double x, double y)
{
    double sum = 0, t_j = 1, t_j_next = y;
    for (int j = 0; j < NUS; j++) {
        double t_i = 1, t_i_next = x;
        for (int i = 0; i < SPEEDS; i++) {
            sum += limits->coefficient[j][i] * t_i * t_j;
            const double t = 2 * x * t_i_next - t_i;
            t_i = t_i_next;
            t_i_next = t;
        }
        const double t = 2 * y * t_j_next - t_j;
        t_j = t_j_next;
        t_j_next = t;
    }
    return sum;
}

static void find_coefficients(struct limits *limits)
{
    double speed[SPEEDS], nu[NUS];
    char text[TEXT];
    for (int i = 0; i < SPEEDS; i++)
        speed[i] = scaled_speed(&table.row[i * EACH]);
    for (int j = 0; j < NUS; j++) {
        nu[j] = scaled_nu(&table.row[j * SPEEDS * EACH]);
        for (int i = 0; i < SPEEDS; i++)
            limits->coefficient[j][i] = limits->of[j * SPEEDS + i].one_minus_eps2;
        interpolate(limits->coefficient[j], speed, SPEEDS, 1);
    }
    for (int i = 0; i < SPEEDS; i++)
        interpolate(&limits->coefficient[0][i], nu, NUS, SPEEDS);
    for (int j = 0; j < NUS; j++)
        for (int i = 0; i < SPEEDS; i++)
            limits->coefficient[j][i] = rounded(text, limits->coefficient[j][i], COEFFICIENT_PLACES);
    double most = 0;
    for (int i = NUS * SPEEDS; i < SCENES; i++) {
        const struct row *const row = &table.row[i * EACH];
        const double between = value_between(limits, scaled_speed(row), scaled_nu(row));
        most = fmax(most, fabs(between - limits->of[i].one_minus_eps2));
    }
    limits->interpolation = rounded_up(most);
}

/* ---- the header ---- */

static const char banner_format[] =
    "1 - eps^2 of an elastic disk that hits a hard wall, alpha -> infinity, with all its modes, N -> infinity: limits\n"
    "of the collisions, (41) to (45) of Gerl and Zippelius (1999), in " DISK_LIMITS_ROWS_FILE
    ". %d speeds from %.9s to %.9s,\n"
    "%d Poisson's numbers from %.9s to %.9s in plane stress, E = rho = R = 1. Evaluated by runtime/disk/limits.c.\n"
    "\n"
    "Each limit is the L of least squares to %d collisions, alpha v = %d ... %d and N = %d ... %d,\n"
    "\n"
    "    1 - eps^2 = L + a u + c u^(5/3) + b w + d u w,     u = 1/(alpha v), w = 1/sqrt(N)\n"
    "\n"
    "and its uncertainty the largest difference of fits with 4/3 or 2 in place of 5/3 or with w^2 besides, plus two\n"
    "standard errors of the jackknife, from fits without each alpha and each N. It is a spread of fits, no bound.\n"
    "Uncertainties go from %s to %s; the fits miss the collisions by %s at most (root mean square). Straight\n"
    "lines in u through the three hardest walls would end up to %s away.\n"
    "\n"
    "Written by:  corgen tables, from " DISK_LIMITS_ROWS_FILE
    "; the collisions by corgen tables --all, in %ld seconds of\n"
    "             processor time\n"
    "Checked by:  corgen tables --check, which collides a random sample again, and corgen tables --check --all\n";

static void write_banner(struct emit *e, FILE *file, const struct limits *limits)
{
    double least = 1, most = 0, residual = 0, straight = 0;
    for (int i = 0; i < SCENES; i++) {
        const struct disk_limit *const limit = &limits->of[i];
        least = fmin(least, limit->uncertainty);
        most = fmax(most, limit->uncertainty);
        residual = fmax(residual, limit->residual);
        straight = fmax(straight, fabs(limit->straight - limit->one_minus_eps2));
    }
    const struct row *const last = &table.row[(NUS * SPEEDS - 1) * EACH];
    char banner[sizeof banner_format + 20 * TEXT];
    snprintf(banner, sizeof banner, banner_format, SPEEDS, table.row[0].speed, last->speed, NUS, table.row[0].nu,
             last->nu, EACH, hardness[0], hardness[HARDNESSES - 1], counts[0], counts[COUNTS - 1],
             emit_bound(least).text, emit_bound(most).text, emit_bound(residual).text, emit_bound(straight).text,
             table.seconds);
    emit_open(e, file, "COR_DISK_LIMITS_H", banner);
}

int disk_limits_header_write(FILE *file, const struct disk_table *unused)
{
    (void)unused;
    static const char *const size_names[] = {"COR_DISK_LIMIT_SPEEDS", "COR_DISK_LIMIT_NUS"};
    static const slong sizes[] = {SPEEDS, NUS};
    struct limits *const limits = xmalloc(sizeof *limits);
    if (find_limits(limits)) {
        free(limits);
        return STATUS_FAILED;
    }
    find_coefficients(limits);
    struct emit e;
    char text[TEXT];
    write_banner(&e, file, limits);
    fprintf(file, "\n");
    emit_include(&e, "\"runtime/core/disk_limit.h\"");
    fprintf(file, "\n");
    emit_constants(&e, size_names, sizes, 2);
    emit_comment(&e, "x = log10(speed/%g) and y = (nu - %g)/%g go from -1 to 1.", MIDDLE_SPEED, MIDDLE_NU, NU_RANGE);
    snprintf(text, sizeof text, "%g", MIDDLE_SPEED);
    emit_define(&e, "COR_DISK_LIMIT_MIDDLE_SPEED", text);
    snprintf(text, sizeof text, "%g", MIDDLE_NU);
    emit_define(&e, "COR_DISK_LIMIT_MIDDLE_NU", text);
    snprintf(text, sizeof text, "%g", NU_RANGE);
    emit_define(&e, "COR_DISK_LIMIT_NU_RANGE", text);
    emit_comment(&e,
                 "Largest difference between the interpolation below and the limit found for itself, at %d places\n"
                 "halfway between those of the table.",
                 SCENES - NUS * SPEEDS);
    snprintf(text, sizeof text, "%.6f", limits->interpolation);
    emit_define(&e, "COR_DISK_LIMIT_INTERPOLATION", text);

    emit_comment(&e, "{nu, speed, 1 - eps^2, its uncertainty}, the speed running fastest");
    emit_structs_open(&e, "cor_disk_limit", "cor_disk_limits", NUS * SPEEDS);
    for (int i = 0; i < NUS * SPEEDS; i++) {
        char value[TEXT], uncertainty[TEXT];
        rounded(value, limits->of[i].one_minus_eps2, PLACES);
        rounded(uncertainty, limits->of[i].uncertainty, PLACES);
        const char *const decimal[] = {table.row[i * EACH].nu, table.row[i * EACH].speed, value, uncertainty};
        emit_struct_decimals(&e, decimal, 4, i + 1 == NUS * SPEEDS);
    }
    emit_structs_close(&e);
    emit_comment(&e,
                 "1 - eps^2 = sum c_ji T_i(x) T_j(y), the polynomial through the limits; c_ji in [%d j + i], to eight\n"
                 "places.",
                 SPEEDS);
    char coefficient[NUS * SPEEDS][TEXT];
    const char *decimal[NUS * SPEEDS];
    for (int i = 0; i < NUS * SPEEDS; i++) {
        rounded(coefficient[i], limits->coefficient[i / SPEEDS][i % SPEEDS], COEFFICIENT_PLACES);
        decimal[i] = coefficient[i];
    }
    emit_decimals(&e, "cor_disk_limit_coefficients", decimal, NUS * SPEEDS);
    emit_close(&e);
    free(limits);
    return STATUS_OK;
}
