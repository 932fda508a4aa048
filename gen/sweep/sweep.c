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
#include "support/emit_c.h"

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

/* ---- rows ---- */

/* Kinds of columns */
enum column_kind {
    COLUMN_LIST = 'l',   /* a number of a list, unchanged */
    COLUMN_COUNT = 'c',  /* number of modes, also from a list */
    COLUMN_PLACES = 'p', /* a result, up to the second digit of its error */
    COLUMN_DIGITS = 'd', /* a time or a compression; its number of digits is the number of decimals of eps */
    COLUMN_WHOLE = 'w',  /* a result with all digits */
    COLUMN_SMALL = 's',  /* a result with SMALL_DIGITS digits */
    COLUMN_STEPS = 'n',
    COLUMN_ERROR = 'e', /* error estimate, rounded up to SMALL_DIGITS; the last column but one */
    COLUMN_STATUS = 't' /* the last column */
};
enum { SMALL_DIGITS = 2, LEAST_DIGITS = 4 };

/* The columns of each kind of sweep. lists: number of columns that contain lists; they come first */
static const struct layout {
    const char *header, *kinds;
    size_t lists;
} soft_layout = {"speed,nu,alpha,modes,eps,one_minus_eps2,contact_time,max_compression,energy_drift,steps,"
                 "error_estimate,status",
                 "lllcppddsnet", 4},
  hard_layout = {"speed,nu,one_minus_eps2,eps,contact_time,max_compression,error_estimate,status", "llppddet", 2},
  rayleigh_layout = {"speed,nu,modes,fraction,tail,eps,contact_time,error_estimate,status", "llcpppwet", 3};

static const struct layout *layout_of(const struct sweep *sweep)
{
    return sweep->hard_wall ? &hard_layout : sweep->rayleigh ? &rayleigh_layout : &soft_layout;
}

/* Returns the list of a column. */
static const struct values *list_of(const struct sweep *sweep, size_t column)
{
    const struct values *const list[] = {&sweep->speed, &sweep->poisson,
                                         sweep->rayleigh ? &sweep->modes : &sweep->alpha, &sweep->modes};
    return list[column];
}

int sweep_count(struct sweep *sweep)
{
    double product = 1;
    sweep->rows = 1;
    for (size_t i = 0; i < layout_of(sweep)->lists; i++) {
        product *= (double)list_of(sweep, i)->count;
        if (product <= (double)SWEEP_MAX_ROWS)
            sweep->rows *= list_of(sweep, i)->count;
    }
    if (product > (double)SWEEP_MAX_ROWS)
        return usage_error("the lists make %.4g rows; allowed: up to %" PRIu64
                           ", because more take weeks; split the sweep",
                           product, SWEEP_MAX_ROWS);
    return STATUS_OK;
}

uint64_t sweep_rows_of_material(const struct sweep *sweep)
{
    return sweep->rows / sweep->poisson.count;
}

/* Returns the list's value in row *number. Sets *number to the row's number among the combinations of later lists. */
static double next_of(const struct values *list, uint64_t *number)
{
    const double value = list->nearest[*number % list->count];
    *number /= list->count;
    return value;
}

void sweep_row(struct sweep_row *row, const struct sweep *sweep, uint64_t number)
{
    row->speed = next_of(&sweep->speed, &number);
    row->modes = sweep->hard_wall ? 0 : (size_t)next_of(&sweep->modes, &number);
    row->alpha = sweep->alpha.count > 0 ? next_of(&sweep->alpha, &number) : INFINITY;
    row->nu = next_of(&sweep->poisson, &number);
}

void sweep_collide(struct sweep_result *result, const struct sweep *sweep, uint64_t number,
                   const struct cor_disk_modes *modes, struct hard_wall_tables *tables)
{
    struct sweep_row row;
    sweep_row(&row, sweep, number);
    if (sweep->hard_wall) {
        struct cor_disk_hard_wall h;
        const int status = hard_wall_collide(&h, tables, sweep->tolerance, 0, row.speed);
        *result = (struct sweep_result){
            {row.speed, row.nu, h.one_minus_eps2, h.eps, h.contact_time, h.max_compression, h.error_estimate}, status};
    } else if (sweep->rayleigh) { /* a table of row.modes modes, because the tail depends on the size of the table */
        const struct cor_disk_modes cut = {modes->nu, row.modes, modes->mode};
        struct cor_disk_rayleigh r = {NAN, NAN, NAN, NAN};
        const int status = cor_disk_rayleigh(&cut, row.modes, COR_DISK_DATUM_CENTRE_OF_MASS, row.speed, &r, NULL);
        const double left = r.fraction + r.tail, eps = left <= 1 ? sqrt(1 - left) : (double)NAN;
        *result = (struct sweep_result){
            {row.speed, row.nu, (double)row.modes, r.fraction, r.tail, eps, r.contact_time, r.error_estimate}, status};
    } else {
        const struct cor_disk_collision_options options = {row.alpha, sweep->tolerance, (size_t)sweep->phi_points, 0};
        struct cor_disk_collision c = {NAN, NAN, NAN, NAN, NAN, 0, NAN};
        const int status = cor_disk_collision(modes, row.modes, &options, row.speed, &c);
        *result = (struct sweep_result){{row.speed, row.nu, row.alpha, (double)row.modes, c.eps, c.one_minus_eps2,
                                         c.contact_time, c.max_compression, c.energy_drift, (double)c.steps,
                                         c.error_estimate},
                                        status};
    }
}

/* ---- lines ---- */

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

/* Returns x with this number of decimals or digits, or a shorter text that is read back as the same double. */
static const char *known_text(char text[DECIMAL_TEXT], bool decimals, int digits, double x)
{
    char whole[DECIMAL_TEXT];
    decimal_text(whole, x);
    const int length = snprintf(text, DECIMAL_TEXT, decimals ? "%.*f" : "%.*g", digits, x);
    if (!isfinite(x) || (size_t)length >= strlen(whole))
        snprintf(text, DECIMAL_TEXT, "%s", whole);
    return text;
}

static const char *cell_text(char text[DECIMAL_TEXT], char kind, int decimals, double x)
{
    switch (kind) {
    case COLUMN_PLACES:
    case COLUMN_DIGITS:
        return known_text(text, kind == COLUMN_PLACES, decimals, x);
    case COLUMN_SMALL:
        return known_text(text, false, SMALL_DIGITS, x);
    case COLUMN_ERROR:
        return decimal_text(text, x > 0 ? strtod(emit_bound(x).text, NULL) : x);
    case COLUMN_COUNT:
    case COLUMN_STEPS:
        snprintf(text, DECIMAL_TEXT, "%.0f", x);
        return text;
    default:
        return decimal_text(text, x);
    }
}

void sweep_line(char line[SWEEP_LINE], const struct sweep *sweep, const struct sweep_result *result)
{
    char text[DECIMAL_TEXT];
    const char *const kinds = layout_of(sweep)->kinds;
    const double error = result->value[strlen(kinds) - 2];
    /* number of decimals: up to the second significant digit of the error; `all` if the error is unknown */
    const int all = DECIMAL_TEXT / 2, decimals = error > 0 ? (int)fmin(fmax(1 - floor(log10(error)), 1), all) : all;
    size_t at = 0;
    for (int j = 0; kinds[j] != COLUMN_STATUS; j++)
        at +=
            (size_t)snprintf(line + at, SWEEP_LINE - at, "%s,", cell_text(text, kinds[j], decimals, result->value[j]));
    snprintf(line + at, SWEEP_LINE - at, "%s", status_word(text, result->status));
}

/* ---- tables ---- */

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

/* Prints a cell of the text format. Results have the digits that the tolerance justifies. The status ends the line. */
static void print_text(const struct sweep_printer *p, int j, const char *text)
{
    const char kind = p->table.kinds[j];
    char rounded[DECIMAL_TEXT], *end;
    const double x = strtod(text, &end);
    if (p->digits[j] && end != text && *end == '\0' && !isnan(x)) {
        snprintf(rounded, sizeof rounded, "%.*g", p->digits[j], x);
        text = rounded;
    }
    if (kind == COLUMN_STATUS)
        fprintf(p->file, "%s\n", text);
    else
        fprintf(p->file, kind == COLUMN_COUNT || kind == COLUMN_STEPS ? "%*s  " : "%-*s  ", p->width[j], text);
}

void sweep_print_start(struct sweep_printer *p, const struct sweep *sweep, enum output_format format, FILE *file)
{
    *p = (struct sweep_printer){.file = file, .format = format, .sweep = sweep};
    const int digits = (int)fmin(fmax(ceil(-log10(sweep->tolerance)), LEAST_DIGITS), DBL_DIG);
    table_init(&p->table, layout_of(sweep)->header, layout_of(sweep)->kinds);
    for (int j = 0; j < p->table.columns; j++) {
        const char kind = p->table.kinds[j], *const name = p->table.column[j];
        const bool small = kind == COLUMN_SMALL || kind == COLUMN_ERROR;
        const bool result = kind == COLUMN_PLACES || kind == COLUMN_DIGITS || kind == COLUMN_WHOLE;
        p->digits[j] = small ? SMALL_DIGITS : result ? digits : 0;
        const int number = (int)(sizeof "-0.e-100" - 1) + p->digits[j], named = (int)strlen(name);
        if (kind == COLUMN_LIST || kind == COLUMN_COUNT)
            p->width[j] = column_width(name, list_of(sweep, (size_t)j));
        else if (kind == COLUMN_STEPS)
            p->width[j] = (int)sizeof TEXT_OF(COR_DISK_COLLISION_MAX_STEPS) - 1;
        else
            p->width[j] = number > named ? number : named;
        if (format == FORMAT_TEXT)
            print_text(p, j, name);
    }
    table_print_start(&p->table, format, file);
}

void sweep_print(void *printer, const char *line)
{
    struct sweep_printer *const p = printer;
    struct table *const table = &p->table;
    for (int j = 0; j < table->columns; j++) {
        const size_t length = strcspn(line, ",");
        table_add(table, xprintf("%.*s", (int)length, line));
        line += length + (line[length] == ',');
        if (p->format == FORMAT_TEXT)
            print_text(p, j, table->cell[j]);
        if (p->sweep->eps && strcmp(table->column[j], "eps") == 0)
            p->sweep->eps[p->rows] = strtod(table->cell[j], NULL);
    }
    if (p->format != FORMAT_TEXT)
        table_print_rows(table, p->format, p->rows == 0, p->file);
    const char *const status = table->cell[table->columns - 1];
    const bool coarse = strcmp(status, "tolerance_not_reached") == 0, beyond = strcmp(status, "beyond_theory") == 0;
    p->rows++;
    p->tolerance_not_reached += coarse;
    p->beyond_theory += beyond;
    p->failed += strcmp(status, "ok") != 0 && !coarse && !beyond;
    table_drop_rows(table);
}

void sweep_print_end(struct sweep_printer *p)
{
    table_print_end(p->format, p->file);
    table_clear(&p->table);
}
