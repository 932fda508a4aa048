/* SPDX-License-Identifier: MIT */
#include "sweep/sweep.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cor/status.h"
#include "disk/modes.h"
#include "support/console.h"

#define TEXT_OF_(x) #x
#define TEXT_OF(x) TEXT_OF_(x)

const struct values_rule sweep_speed = {
    "speed",
    {"0", TEXT_OF(COR_DISK_COLLISION_MAX_SPEED), false, true, true,
     "a number above 0 and up to " TEXT_OF(COR_DISK_COLLISION_MAX_SPEED) ", in sqrt(E/rho), where E = rho = R = 1"},
    false};
const struct values_rule sweep_poisson = {
    "poisson", {"-1", "1", false, false, true, "a number between -1 and 1"}, false};
const struct values_rule sweep_alpha = {
    "alpha",
    {TEXT_OF(COR_DISK_COLLISION_MIN_ALPHA), TEXT_OF(COR_DISK_COLLISION_MAX_ALPHA), true, true, true,
     "a number from " TEXT_OF(COR_DISK_COLLISION_MIN_ALPHA) " to " TEXT_OF(COR_DISK_COLLISION_MAX_ALPHA)},
    false};
const struct values_rule sweep_modes = {
    "modes",
    {"1", TEXT_OF(DISK_MODES_MAX), true, true, true, "a whole number from 1 to " TEXT_OF(DISK_MODES_MAX)},
    true};

/* ---- cost ---- */

/* The cost of a row, fitted to 13 rows at tolerance 1e-8: within a factor of 1.8 of their times, and of 2.5 at six
 * other rows (sampled). A step costs in proportion to modes and angles together. The number of steps grows with the
 * duration of the contact, with alpha v, where collisions become chaotic, and for slow disks. Each of the three parts
 * is a product of functions of one parameter, so that the sum over all rows is a product of sums. */
enum { COST_PARTS = 3 };

static double cost_of_modes(double modes)
{
    return modes + 100;
}

static double cost_of_alpha(int part, double alpha)
{
    return part == 1 ? pow(alpha / 25, 1.6) : 1;
}

static double cost_of_speed(int part, double speed)
{
    return part == 0 ? 1 : part == 1 ? pow(speed, 1.6) : 0.01 / speed;
}

static double sum_of(double (*cost)(int part, double value), int part, const struct values *values)
{
    double sum = 0;
    for (size_t i = 0; i < values->count; i++)
        sum += cost(part, values->nearest[i]);
    return sum;
}

/* At the hard wall a row takes about the same time at any speed and nu. Rows in which waves return while the contact
 * ends or splits take up to ten times as long. */
double sweep_cost(const struct sweep *sweep, uint64_t number)
{
    struct sweep_row row;
    sweep_row(&row, sweep, number);
    double cost = 0;
    if (sweep->hard_wall || sweep->rayleigh)
        return 1;
    for (int part = 0; part < COST_PARTS; part++)
        cost += cost_of_alpha(part, row.alpha) * cost_of_speed(part, row.speed);
    return cost * cost_of_modes((double)row.modes);
}

/* ---- rows ---- */

/* Sets the lists of a sweep; returns their number. */
static size_t lists_of(const struct sweep *sweep, const struct values *list[SWEEP_LISTS])
{
    const struct values *const all[SWEEP_LISTS] = {&sweep->speed, &sweep->poisson, &sweep->alpha, &sweep->modes};
    memcpy(list, all, sizeof all);
    if (sweep->rayleigh)
        list[2] = &sweep->modes;
    return sweep->hard_wall ? 2 : sweep->rayleigh ? 3 : SWEEP_LISTS;
}

int sweep_count(struct sweep *sweep)
{
    const struct values *list[SWEEP_LISTS];
    const size_t lists = lists_of(sweep, list);
    double product = 1;
    sweep->rows = 1;
    for (size_t i = 0; i < lists; i++) {
        product *= (double)list[i]->count;
        if (product <= (double)SWEEP_MAX_ROWS)
            sweep->rows *= list[i]->count;
    }
    if (product > (double)SWEEP_MAX_ROWS)
        return usage_error("the lists make %.4g rows; up to %" PRIu64
                           " are allowed, because more take weeks; split the sweep",
                           product, SWEEP_MAX_ROWS);
    if (sweep->hard_wall || sweep->rayleigh) {
        sweep->cost = (double)sweep->rows;
        return STATUS_OK;
    }
    double of_modes = 0;
    for (size_t i = 0; i < sweep->modes.count; i++)
        of_modes += cost_of_modes(sweep->modes.nearest[i]);
    sweep->cost = 0;
    for (int part = 0; part < COST_PARTS; part++)
        sweep->cost += (double)sweep->poisson.count * of_modes * sum_of(cost_of_alpha, part, &sweep->alpha) *
                       sum_of(cost_of_speed, part, &sweep->speed);
    return STATUS_OK;
}

void sweep_clear(struct sweep *sweep)
{
    values_clear(&sweep->speed);
    values_clear(&sweep->poisson);
    values_clear(&sweep->alpha);
    values_clear(&sweep->modes);
}

uint64_t sweep_rows_of_material(const struct sweep *sweep)
{
    return sweep->rows / sweep->poisson.count;
}

void sweep_row(struct sweep_row *row, const struct sweep *sweep, uint64_t number)
{
    row->speed = sweep->speed.nearest[number % sweep->speed.count];
    number /= sweep->speed.count;
    row->modes = 0;
    row->alpha = INFINITY;
    if (!sweep->hard_wall) {
        row->modes = (size_t)sweep->modes.nearest[number % sweep->modes.count];
        number /= sweep->modes.count;
    }
    if (sweep->alpha.count > 0) {
        row->alpha = sweep->alpha.nearest[number % sweep->alpha.count];
        number /= sweep->alpha.count;
    }
    row->material = (size_t)number;
    row->nu = sweep->poisson.nearest[number];
}

/* FNV-1a, 64 bits */
static uint64_t hash_text(uint64_t hash, const char *text)
{
    do
        hash = (hash ^ (unsigned char)*text) * UINT64_C(1099511628211);
    while (*text++);
    return hash;
}

uint64_t sweep_identity(const struct sweep *sweep)
{
    const struct values *list[SWEEP_LISTS];
    const size_t lists = lists_of(sweep, list);
    uint64_t hash = UINT64_C(14695981039346656037);
    char text[3 * DECIMAL_TEXT];
    for (size_t i = 0; i < lists; i++) {
        for (size_t j = 0; j < list[i]->count; j++) {
            snprintf(text, sizeof text, "%a", list[i]->nearest[j]);
            hash = hash_text(hash, text);
            if (list[i] == &sweep->poisson) { /* two exact ratios with one double have different modes */
                char *exact = fmpq_get_str(NULL, 10, list[i]->exact + j);
                hash = hash_text(hash, exact);
                flint_free(exact);
            }
        }
        hash = hash_text(hash, ";");
    }
    snprintf(text, sizeof text, "%a %zu", sweep->tolerance, sweep->phi_points);
    return hash_text(hash, text);
}

static const struct sweep_result no_result = {.collision = {NAN, NAN, NAN, NAN, NAN, 0, NAN},
                                              .hard_wall = {NAN, NAN, NAN, NAN, NAN, 0},
                                              .rayleigh = {NAN, NAN, NAN, NAN}};

void sweep_collide(struct sweep_result *result, const struct sweep *sweep, const struct sweep_row *row,
                   const struct cor_disk_modes *modes, struct hard_wall_tables *tables, struct workspace *workspace)
{
    *result = no_result;
    if (sweep->hard_wall) {
        result->status = hard_wall_collide(&result->hard_wall, tables, sweep->tolerance, 0, row->speed, workspace);
        return;
    }
    if (sweep->rayleigh) { /* the tail must not depend on the modes of other rows */
        const struct cor_disk_modes cut = {modes->nu, row->modes, modes->mode};
        result->status =
            cor_disk_rayleigh(&cut, row->modes, COR_DISK_DATUM_CENTRE_OF_MASS, row->speed, &result->rayleigh, NULL);
        return;
    }
    /* sized for this row alone: the angles chosen must not depend on earlier rows */
    const struct cor_disk_collision_options options = {row->alpha, sweep->tolerance, sweep->phi_points, 0};
    const size_t needed = cor_disk_collision_workspace(modes, row->modes, &options);
    result->status = cor_disk_collision_in(workspace_reserve(workspace, needed), needed, modes, row->modes, &options,
                                           row->speed, &result->collision, NULL);
}

/* ---- lines ---- */

/* Digits of errors and of the energy's drift */
enum { SMALL_DIGITS = 2 };

static const char *status_word(char text[DECIMAL_TEXT], int status)
{
    static const struct {
        int status;
        const char *word;
    } known[] = {{COR_OK, "ok"},
                 {COR_TOLERANCE_NOT_REACHED, "tolerance_not_reached"},
                 {COR_BEYOND_THEORY, "beyond_theory"},
                 {COR_ERROR_SPEED, "beyond_theory"},
                 {COR_WALL_NOT_TOUCHED, "wall_not_touched"},
                 {COR_CONTACT_NOT_ENDED, "contact_not_ended"}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (known[i].status == status)
            return known[i].word;
    snprintf(text, DECIMAL_TEXT, "error_%d", status);
    return text;
}

/* Two digits of an error, rounded up */
static const char *error_text(char text[DECIMAL_TEXT], double error)
{
    if (!(error > 0 && error < (double)INFINITY))
        return decimal_text(text, error);
    snprintf(text, DECIMAL_TEXT, "%.1e", error);
    const int up = strtod(text, NULL) < error, digits = 10 * (text[0] - '0') + text[2] - '0';
    const int exponent = (int)strtol(strchr(text, 'e') + 1, NULL, 10);
    snprintf(text, DECIMAL_TEXT, "%de%d", digits + up, exponent - 1);
    return decimal_text(text, strtod(text, NULL));
}

/* Decimals up to the second digit of the error; all where it is not known */
static int decimals_known(double error)
{
    return error > 0 ? (int)fmin(fmax(1 - floor(log10(error)), 1), DECIMAL_TEXT / 2) : DECIMAL_TEXT / 2;
}

/* A number with so many decimals, or significant digits, or a shorter text that reads back to the same double */
static const char *known_text(char text[DECIMAL_TEXT], bool decimals, int digits, double x)
{
    char whole[DECIMAL_TEXT];
    decimal_text(whole, x);
    const int length =
        decimals ? snprintf(text, DECIMAL_TEXT, "%.*f", digits, x) : snprintf(text, DECIMAL_TEXT, "%.*g", digits, x);
    if (!isfinite(x) || (size_t)length >= strlen(whole))
        snprintf(text, DECIMAL_TEXT, "%s", whole);
    return text;
}

/* The numbers taken during the contact get as many digits as eps has decimals. */
static void hard_wall_line(char line[SWEEP_LINE], const struct sweep_row *row, const struct sweep_result *result)
{
    const struct cor_disk_hard_wall *h = &result->hard_wall;
    const int known = decimals_known(h->error_estimate);
    char text[7][DECIMAL_TEXT], word[DECIMAL_TEXT];
    snprintf(line, SWEEP_LINE, "%s,%s,%s,%s,%s,%s,%s,%s", decimal_text(text[0], row->speed),
             decimal_text(text[1], row->nu), known_text(text[2], true, known, h->one_minus_eps2),
             known_text(text[3], true, known, h->eps), known_text(text[4], false, known, h->contact_time),
             known_text(text[5], false, known, h->max_compression), error_text(text[6], h->error_estimate),
             status_word(word, result->status));
}

static void rayleigh_line(char line[SWEEP_LINE], const struct sweep_row *row, const struct sweep_result *result)
{
    const struct cor_disk_rayleigh *r = &result->rayleigh;
    const double sum = r->fraction + r->tail, eps = sum <= 1 ? sqrt(1 - sum) : (double)NAN;
    const int known = decimals_known(r->error_estimate);
    char text[7][DECIMAL_TEXT], word[DECIMAL_TEXT];
    snprintf(line, SWEEP_LINE, "%s,%s,%zu,%s,%s,%s,%s,%s,%s", decimal_text(text[0], row->speed),
             decimal_text(text[1], row->nu), row->modes, known_text(text[2], true, known, r->fraction),
             known_text(text[3], true, known, r->tail), known_text(text[4], true, known, eps),
             decimal_text(text[5], r->contact_time), error_text(text[6], r->error_estimate),
             status_word(word, result->status));
}

void sweep_line(char line[SWEEP_LINE], const struct sweep *sweep, const struct sweep_row *row,
                const struct sweep_result *result)
{
    if (sweep->hard_wall) {
        hard_wall_line(line, row, result);
        return;
    }
    if (sweep->rayleigh) {
        rayleigh_line(line, row, result);
        return;
    }
    const struct cor_disk_collision *c = &result->collision;
    const int known = decimals_known(c->error_estimate);
    char text[9][DECIMAL_TEXT], word[DECIMAL_TEXT];
    snprintf(line, SWEEP_LINE, "%s,%s,%s,%zu,%s,%s,%s,%s,%s,%zu,%s,%s", decimal_text(text[0], row->speed),
             decimal_text(text[1], row->nu), decimal_text(text[2], row->alpha), row->modes,
             known_text(text[3], true, known, c->eps), known_text(text[4], true, known, c->one_minus_eps2),
             known_text(text[5], false, known, c->contact_time), known_text(text[6], false, known, c->max_compression),
             known_text(text[7], false, SMALL_DIGITS, c->energy_drift), c->steps,
             error_text(text[8], c->error_estimate), status_word(word, result->status));
}

/* ---- tables ---- */

/* The kinds of columns in text format */
enum column_kind {
    COLUMN_LIST,  /* a number of a list, unchanged */
    COLUMN_COUNT, /* number of modes, also from a list */
    COLUMN_RESULT,
    COLUMN_SMALL, /* a result of which two digits suffice */
    COLUMN_STEPS,
    COLUMN_STATUS
};
enum { LEAST_DIGITS = 4 };

struct layout {
    const char *header;
    int columns, eps; /* eps: its column */
    enum column_kind kind[SWEEP_COLUMNS];
};
static const struct layout soft_layout = {SWEEP_HEADER,
                                          SWEEP_COLUMNS,
                                          4,
                                          {COLUMN_LIST, COLUMN_LIST, COLUMN_LIST, COLUMN_COUNT, COLUMN_RESULT,
                                           COLUMN_RESULT, COLUMN_RESULT, COLUMN_RESULT, COLUMN_SMALL, COLUMN_STEPS,
                                           COLUMN_SMALL, COLUMN_STATUS}};
static const struct layout hard_layout = {SWEEP_HARD_WALL_HEADER,
                                          8,
                                          3,
                                          {COLUMN_LIST, COLUMN_LIST, COLUMN_RESULT, COLUMN_RESULT, COLUMN_RESULT,
                                           COLUMN_RESULT, COLUMN_SMALL, COLUMN_STATUS}};

static const struct layout rayleigh_layout = {SWEEP_RAYLEIGH_HEADER,
                                              9,
                                              5,
                                              {COLUMN_LIST, COLUMN_LIST, COLUMN_COUNT, COLUMN_RESULT, COLUMN_RESULT,
                                               COLUMN_RESULT, COLUMN_RESULT, COLUMN_SMALL, COLUMN_STATUS}};

static const struct layout *layout_of(const struct sweep *sweep)
{
    return sweep->hard_wall ? &hard_layout : sweep->rayleigh ? &rayleigh_layout : &soft_layout;
}

/* Cuts a line at its commas; the cells point into `line`. */
static void line_cut(char *cell[SWEEP_COLUMNS], char *line, int columns)
{
    for (int j = 0; j < columns; j++) {
        cell[j] = line;
        line += strcspn(line, ",");
        if (*line)
            *line++ = '\0';
    }
}

static int column_width(const char *name, const struct values *values)
{
    size_t width = strlen(name);
    char text[DECIMAL_TEXT];
    for (size_t i = 0; i < values->count; i++) {
        const size_t n = strlen(decimal_text(text, values->nearest[i]));
        width = n > width ? n : width;
    }
    return (int)width;
}

/* Prints as many digits as the tolerance justifies. */
static void print_text(const struct sweep_printer *p, char *const cell[SWEEP_COLUMNS])
{
    const struct layout *const layout = layout_of(p->sweep);
    for (int j = 0; j + 1 < layout->columns; j++) {
        const enum column_kind kind = layout->kind[j];
        char rounded[DECIMAL_TEXT];
        const char *text = cell[j];
        char *end;
        const double x = strtod(text, &end);
        if ((kind == COLUMN_RESULT || kind == COLUMN_SMALL) && end != text && *end == '\0' && !isnan(x)) {
            snprintf(rounded, sizeof rounded, "%.*g", kind == COLUMN_SMALL ? SMALL_DIGITS : p->digits, x);
            text = rounded;
        }
        fprintf(p->file, kind == COLUMN_COUNT || kind == COLUMN_STEPS ? "%*s  " : "%-*s  ", p->width[j], text);
    }
    fprintf(p->file, "%s\n", cell[layout->columns - 1]);
}

static void print_json(const struct sweep_printer *p, char *const name[SWEEP_COLUMNS], char *const cell[SWEEP_COLUMNS])
{
    const int columns = layout_of(p->sweep)->columns;
    fputs(p->rows ? ",\n  {" : "\n  {", p->file);
    for (int j = 0; j < columns; j++) {
        const char *quote = j + 1 == columns ? "\"" : "";
        const bool finite = j + 1 == columns || (strcmp(cell[j], "nan") != 0 && !strstr(cell[j], "inf"));
        fprintf(p->file, "%s\"%s\": %s%s%s", j ? ", " : "", name[j], quote, finite ? cell[j] : "null", quote);
    }
    fputs("}", p->file);
}

void sweep_print_start(struct sweep_printer *p, const struct sweep *sweep, enum output_format format, FILE *file)
{
    *p = (struct sweep_printer){.file = file, .format = format, .sweep = sweep};
    const struct layout *const layout = layout_of(p->sweep);
    char header[sizeof SWEEP_HEADER];
    char *name[SWEEP_COLUMNS];
    snprintf(header, sizeof header, "%s", layout->header);
    line_cut(name, header, layout->columns);
    const struct values *list[SWEEP_LISTS];
    lists_of(sweep, list);
    p->digits = (int)fmin(fmax(ceil(-log10(sweep->tolerance)), LEAST_DIGITS), DBL_DIG);
    for (int j = 0; j < layout->columns; j++) {
        const enum column_kind kind = layout->kind[j];
        const int number = (int)(sizeof "-0.e-100" - 1) + (kind == COLUMN_SMALL ? SMALL_DIGITS : p->digits);
        const int named = (int)strlen(name[j]);
        if (kind == COLUMN_LIST || kind == COLUMN_COUNT)
            p->width[j] = column_width(name[j], list[j]);
        else if (kind == COLUMN_STEPS)
            p->width[j] = (int)sizeof TEXT_OF(COR_DISK_COLLISION_MAX_STEPS) - 1;
        else
            p->width[j] = number > named ? number : named;
    }
    if (format == FORMAT_CSV)
        fprintf(file, "%s\n", layout->header);
    else if (format == FORMAT_JSON)
        fputs("[", file);
    else
        print_text(p, name);
}

void sweep_print(struct sweep_printer *p, const char *line)
{
    const struct layout *const layout = layout_of(p->sweep);
    if (p->format == FORMAT_CSV)
        fprintf(p->file, "%s\n", line);
    char header[sizeof SWEEP_HEADER], copy[SWEEP_LINE];
    char *name[SWEEP_COLUMNS], *cell[SWEEP_COLUMNS];
    snprintf(header, sizeof header, "%s", layout->header);
    snprintf(copy, sizeof copy, "%s", line);
    line_cut(name, header, layout->columns);
    line_cut(cell, copy, layout->columns);
    if (p->format == FORMAT_JSON)
        print_json(p, name, cell);
    else if (p->format == FORMAT_TEXT)
        print_text(p, cell);
    if (p->sweep->eps)
        p->sweep->eps[p->rows] = strtod(cell[layout->eps], NULL);
    p->rows++;
    const char *status = cell[layout->columns - 1];
    p->tolerance_not_reached += strcmp(status, "tolerance_not_reached") == 0;
    p->beyond_theory += strcmp(status, "beyond_theory") == 0;
    p->failed += strcmp(status, "ok") != 0 && strcmp(status, "tolerance_not_reached") != 0 &&
                 strcmp(status, "beyond_theory") != 0;
}

void sweep_print_end(struct sweep_printer *p)
{
    if (p->format == FORMAT_JSON)
        fputs("\n]\n", p->file);
}
