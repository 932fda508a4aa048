/* SPDX-License-Identifier: MIT */
#include "fit/data.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "support/console.h"
#include "support/decimal.h"

enum { LINE_LENGTH = 65536, MAX_COLUMNS = 256, CELL_SHOWN = 40, EXPONENT_DIGITS = 3 };

const char *const fit_unit_names[] = {[FIT_M_S] = "m/s", [FIT_CM_S] = "cm/s", [FIT_MM_S] = "mm/s", NULL};
static const double unit_m_s[] = {[FIT_M_S] = 1, [FIT_CM_S] = 0.01, [FIT_MM_S] = 0.001};

/* The columns that are read. FIT_M_S, FIT_CM_S and FIT_MM_S index the first three. */
enum column { SPEED_M_S, SPEED_CM_S, SPEED_MM_S, SPEED, EPS, EPS_SIGMA, TIME, RUN, COLUMNS };
static const char *const column_names[COLUMNS] = {[SPEED_M_S] = "speed_m_s",
                                                  [SPEED_CM_S] = "speed_cm_s",
                                                  [SPEED_MM_S] = "speed_mm_s",
                                                  [SPEED] = "speed",
                                                  [EPS] = "eps",
                                                  [EPS_SIGMA] = "eps_sigma",
                                                  [TIME] = "t_s",
                                                  [RUN] = "run"};
static const struct decimal_range speed_range = {"0",  "1e30", false,
                                                 true, true,   "a speed above 0 and up to 1e30, as 0.25"};
static const struct decimal_range eps_range = {"0", "1", true, true, true, "a number from 0 to 1, as 0.85"};
static const struct decimal_range noisy_eps_range = {
    "-1e31", "1e31", true, true, true, "a number from 0 to 1, as 0.85, or beyond by noise"};
static const struct decimal_range sigma_range = {"1e-30", "1e30", true,
                                                 true,    true,   "a number from 1e-30 to 1e30, as 0.01"};
static const struct decimal_range time_range = {"0", "1e30", true, true, true, "a time from 0 s to 1e30 s, as 0.731"};

struct reader {
    const char *name;
    FILE *file;
    char text[LINE_LENGTH + 2]; /* of the line, or its beginning if it is too long */
    long number;                /* of the line */
    bool ended;                 /* there are no more lines */
    char *line, *cell[MAX_COLUMNS];
    int cells;
    int place[COLUMNS]; /* of a column among the cells; -1: the file does not have it */
    int header_cells;
    struct fit_form form;
};

/* ---- messages ---- */

__attribute__((format(printf, 3, 4))) static int refuse(const struct reader *r, enum column column, const char *format,
                                                        ...)
{
    char why[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
    if (column == COLUMNS)
        return usage_error("%s: line %ld: %s", r->name, r->number, why);
    /* the name of the speed may have a unit */
    const bool has_unit = column == SPEED && r->form.unit != FIT_UNIT_OF_COLUMN && r->place[r->form.unit] >= 0;
    const char *const name = column_names[has_unit ? (enum column)r->form.unit : column];
    return usage_error("%s: line %ld, column %s: %s", r->name, r->number, name, why);
}

static int refuse_cell(const struct reader *r, enum column column, const char *text, const char *allowed)
{
    if (*text == '\0')
        return refuse(r, column, "the cell is empty; allowed: %s", allowed);
    if (strchr(text, r->form.decimal_comma ? '.' : ','))
        return refuse(r, column, "'%.*s' has a decimal %s; allowed: %s, or %s", CELL_SHOWN, text,
                      r->form.decimal_comma ? "point, but --decimal-comma is given" : "comma", allowed,
                      r->form.decimal_comma ? "the command without --decimal-comma" : "--decimal-comma");
    return refuse(r, column, "'%.*s' is not allowed; allowed: %s", CELL_SHOWN, text, allowed);
}

/* ---- lines and cells ---- */

/* UTF-16 by its byte-order mark, or by the zero byte beside an ASCII character; NULL: not */
static const char *utf_16_name(const char *line, size_t length)
{
    if (length < 2)
        return NULL;
    if (memcmp(line, "\xff\xfe", 2) == 0 || (line[0] != '\0' && line[1] == '\0'))
        return "UTF-16LE";
    return memcmp(line, "\xfe\xff", 2) == 0 || (line[0] == '\0' && line[1] != '\0') ? "UTF-16BE" : NULL;
}

/* Ends a line at its end, which is LF or CR LF. A UTF-8 byte-order mark before the first line is skipped. */
static int read_line(struct reader *r)
{
    size_t length = 0;
    int c = 0;
    while (length <= LINE_LENGTH && (c = getc(r->file)) != EOF && c != '\n')
        r->text[length++] = (char)c;
    if (ferror(r->file))
        return fail("cannot read %s: %s", r->name, strerror(errno));
    r->line = r->text;
    r->number++;
    r->ended = c == EOF && length == 0;
    if (length > LINE_LENGTH)
        return refuse(r, COLUMNS, "longer than %d characters; allowed: a csv file, as speed_m_s,eps", LINE_LENGTH);
    const bool null = memchr(r->line, '\0', length);
    if (length > 0 && r->line[length - 1] == '\r')
        length--;
    r->line[length] = '\0';
    if (r->number == 1 && length >= 3 && memcmp(r->line, "\xef\xbb\xbf", 3) == 0) {
        r->line += 3;
        length -= 3;
    }
    const char *const utf_16 = r->number == 1 ? utf_16_name(r->line, length) : NULL;
    if (utf_16)
        return refuse(r, COLUMNS, "the text is %s; allowed: UTF-8, as from iconv -f %s -t UTF-8 FILE", utf_16, utf_16);
    if (null || strchr(r->line, '\r'))
        return refuse(r, COLUMNS, "has a control character; allowed: text with lines that end in LF or CR LF");
    return STATUS_OK;
}

static char *trimmed(char *text)
{
    while (*text == ' ' || *text == '\t')
        text++;
    size_t n = strlen(text);
    while (n > 0 && (text[n - 1] == ' ' || text[n - 1] == '\t'))
        text[--n] = '\0';
    if (n >= 2 && text[0] == '"' && text[n - 1] == '"') {
        text[n - 1] = '\0';
        text++;
    }
    return text;
}

/* The separator that the line has most of outside quotation marks */
static char sniffed_separator(const char *line)
{
    static const char separators[] = {',', ';', '\t'};
    size_t most = 0, count[sizeof separators] = {0};
    bool quoted = false;
    for (; *line; line++) {
        if (*line == '"')
            quoted = !quoted;
        for (size_t i = 0; i < sizeof separators; i++) {
            count[i] += !quoted && *line == separators[i];
            most = count[i] > count[most] ? i : most;
        }
    }
    return separators[most];
}

/* Splits the line at the separators outside quotation marks. Returns false if it has too many cells. */
static bool split_line(struct reader *r)
{
    bool quoted = false;
    if (!r->form.separator)
        r->form.separator = sniffed_separator(r->line);
    char *start = r->line;
    r->cells = 0;
    for (char *at = r->line;; at++) {
        if (*at == '"')
            quoted = !quoted;
        if (*at != '\0' && (*at != r->form.separator || quoted))
            continue;
        const bool last = *at == '\0';
        *at = '\0';
        if (r->cells == MAX_COLUMNS)
            return false;
        r->cell[r->cells++] = trimmed(start);
        if (last)
            return true;
        start = at + 1;
    }
}

/* The next line that is neither empty nor a comment, split into its cells, if there is one */
static int next_row(struct reader *r)
{
    for (;;) {
        const int status = read_line(r);
        if (status != STATUS_OK || r->ended)
            return status;
        const char *const text = r->line + strspn(r->line, " \t");
        if (*text != '\0' && *text != '#')
            return split_line(r)
                       ? STATUS_OK
                       : refuse(r, COLUMNS, "more than %d cells; allowed: a csv file, as speed_m_s,eps", MAX_COLUMNS);
    }
}

static int read_number(double *x, const struct reader *r, enum column column, const struct decimal_range *range)
{
    const char *const text = r->cell[r->place[column]];
    char *const comma = r->form.decimal_comma ? strchr(text, ',') : NULL;
    struct decimal number = {0};
    bool parsed = !(r->form.decimal_comma && strchr(text, '.'));
    if (comma)
        *comma = '.';
    parsed = parsed && decimal_parse(&number, text, EXPONENT_DIGITS);
    if (comma)
        *comma = ',';
    if (!parsed)
        return refuse_cell(r, column, text, range->allowed);
    const bool inside = (number.forms & DECIMAL_RATIO) == 0 && decimal_inside(range, number.value);
    *x = decimal_value(&number);
    decimal_clear(&number);
    return inside ? STATUS_OK : refuse_cell(r, column, text, range->allowed);
}

/* ---- the first row ---- */

static bool has(const struct reader *r, enum column column)
{
    return r->place[column] >= 0;
}

/* The letters and digits of a name, small; a byte beyond ASCII counts as a letter */
static void plain_name(char plain[CELL_SHOWN + 1], const char *name)
{
    size_t n = 0;
    for (; *name && n < CELL_SHOWN; name++)
        if (isalnum((unsigned char)*name) || (unsigned char)*name > 127)
            plain[n++] = (char)tolower((unsigned char)*name);
    plain[n] = '\0';
}

/* "sigma", "eps_err", "std of eps": an error of eps by another name */
static bool means_sigma(const char *plain)
{
    static const char *const words[] = {
        "sigma",        "std",    "stdev",       "stddev", "sd",       "sem",   "err",
        "error",        "errors", "uncertainty", "unc",    "\xcf\x83", "delta", "standarddeviation",
        "standarderror"};
    static const char *const eps[] = {"", "eps", "epsilon", "e", "cor", "restitution", "\xce\xb5"};
    char names[3][2 * CELL_SHOWN];
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        for (size_t j = 0; j < sizeof eps / sizeof *eps; j++) {
            snprintf(names[0], sizeof *names, "%s%s", eps[j], words[i]);
            snprintf(names[1], sizeof *names, "%s%s", words[i], eps[j]);
            snprintf(names[2], sizeof *names, "%sof%s", words[i], eps[j]);
            for (int k = 0; k < 3; k++)
                if (strcmp(plain, names[k]) == 0)
                    return true;
        }
    return false;
}

/* Whether the file may have this column besides those that it has */
static bool is_wanting(const struct reader *r, enum column column)
{
    const bool speed = has(r, SPEED_M_S) || has(r, SPEED_CM_S) || has(r, SPEED_MM_S) || has(r, SPEED);
    const bool given[COLUMNS] = {speed, speed, speed, speed, has(r, EPS), has(r, EPS_SIGMA), speed, !has(r, TIME)};
    return !given[column] && (column > EPS_SIGMA || !has(r, TIME));
}

/* The column that is wanting and whose name is nearly this one; COLUMNS: none */
static enum column nearest_column(const struct reader *r, const char *name)
{
    char plain[CELL_SHOWN + 1], known[CELL_SHOWN + 1];
    plain_name(plain, name);
    for (int column = 0; column < COLUMNS; column++) {
        plain_name(known, column_names[column]);
        const bool near = strlen(known) < 3 ? strcmp(plain, known) == 0 : slips_between(plain, known) <= 1;
        if (is_wanting(r, (enum column)column) && (near || (column == EPS_SIGMA && means_sigma(plain))))
            return (enum column)column;
    }
    return COLUMNS;
}

/* Refuses a name that is nearly one that is read, and lists the others. */
static int list_unused(struct fit_data *data, const struct reader *r)
{
    size_t length = 0;
    for (int i = 0; i < r->cells; i++) {
        bool known = false;
        for (int column = 0; column < COLUMNS; column++)
            known = known || r->place[column] == i;
        if (known)
            continue;
        const enum column near = nearest_column(r, r->cell[i]);
        if (near != COLUMNS)
            return refuse(r, COLUMNS,
                          "the column '%.*s' is not read, but nearly has the name %s; allowed: %s, or a name less "
                          "like it, as remark",
                          CELL_SHOWN, r->cell[i], column_names[near], column_names[near]);
        char *const shown = xprintable(r->cell[i]);
        const size_t size = length + strlen(shown) + 3;
        data->unused = xrealloc(data->unused, size);
        length += (size_t)snprintf(data->unused + length, size - length, "%s%s", length ? ", " : "", shown);
        free(shown);
    }
    return STATUS_OK;
}

static int find_columns(struct reader *r)
{
    for (int column = 0; column < COLUMNS; column++) {
        r->place[column] = -1;
        for (int i = 0; i < r->cells; i++) {
            if (strcmp(r->cell[i], column_names[column]) != 0)
                continue;
            if (r->place[column] >= 0)
                return refuse(r, (enum column)column, "the file has two columns of this name; allowed: one");
            r->place[column] = i;
        }
    }
    r->header_cells = r->cells;
    return STATUS_OK;
}

/* Chooses the column of the speed, and checks it against --unit. Its place becomes that of SPEED. */
static int choose_speed(struct reader *r)
{
    for (int unit = FIT_M_S; unit <= FIT_MM_S; unit++) {
        if (!has(r, (enum column)unit))
            continue;
        if (has(r, SPEED))
            return refuse(r, (enum column)unit, "the file has two columns of speeds; allowed: one");
        if (r->form.unit != FIT_UNIT_OF_COLUMN && r->form.unit != (enum fit_unit)unit)
            return refuse(r, (enum column)unit, "--unit %s contradicts the name; allowed: --unit %s, or none",
                          fit_unit_names[r->form.unit], fit_unit_names[unit]);
        r->place[SPEED] = r->place[unit];
        r->form.unit = (enum fit_unit)unit;
    }
    if (!has(r, SPEED))
        return refuse(r, COLUMNS,
                      "no column speed_m_s; allowed: a first line with the names of the columns, as speed_m_s,eps or "
                      "speed_cm_s,eps,eps_sigma, or t_s for times of bounces");
    if (r->form.unit == FIT_UNIT_OF_COLUMN)
        return refuse(r, SPEED,
                      "the name has no unit; allowed: speed_m_s, speed_cm_s or speed_mm_s, or --unit, as "
                      "--unit cm/s");
    return STATUS_OK;
}

static int read_header(struct fit_data *data, struct reader *r)
{
    int status = find_columns(r);
    if (status == STATUS_OK)
        status = list_unused(data, r);
    if (status != STATUS_OK)
        return status;
    if (!has(r, TIME)) {
        status = choose_speed(r);
        return status != STATUS_OK || has(r, EPS)
                   ? status
                   : refuse(r, COLUMNS, "no column eps; allowed: the columns of a point, as speed_m_s,eps");
    }
    for (int column = SPEED_M_S; column <= EPS_SIGMA; column++)
        if (has(r, (enum column)column))
            return refuse(r, (enum column)column,
                          "not with t_s, whose flights give speed and eps; allowed: t_s and "
                          "run, or speed_m_s and eps");
    return STATUS_OK;
}

/* ---- the points ---- */

/* Adds a point. `bounce` describes it without its index, or is NULL. */
static int add_point(struct fit_data *data, const struct reader *r, struct fit_point point,
                     const struct fit_bounce *bounce)
{
    if (data->points == FIT_MAX_POINTS)
        return refuse(r, COLUMNS, "more than %d points; allowed: at most that many, as every tenth", FIT_MAX_POINTS);
    data->point = xgrow(data->point, data->points, sizeof *data->point);
    if (bounce) {
        data->bounce = xgrow(data->bounce, data->points, sizeof *data->bounce);
        data->bounce[data->points] = *bounce;
    }
    point.line = bounce ? bounce->line[1] : r->number;
    point.row = data->points;
    data->point[data->points++] = point;
    return STATUS_OK;
}

static int read_point(struct fit_data *data, const struct reader *r)
{
    double speed, eps, sigma = 0;
    int status = read_number(&speed, r, SPEED, &speed_range);
    if (status == STATUS_OK && has(r, EPS_SIGMA))
        status = read_number(&sigma, r, EPS_SIGMA, &sigma_range);
    if (status == STATUS_OK)
        status = read_number(&eps, r, EPS, has(r, EPS_SIGMA) ? &noisy_eps_range : &eps_range);
    if (status != STATUS_OK)
        return status;
    if (eps > 1 + FIT_MAX_BEYOND * sigma || eps < -FIT_MAX_BEYOND * sigma)
        return refuse(r, EPS,
                      "'%.*s' is %.3g eps_sigma beyond %d; allowed: a number from 0 to 1, or beyond by %d "
                      "eps_sigma of noise",
                      CELL_SHOWN, r->cell[r->place[EPS]], (eps > 1 ? eps - 1 : -eps) / sigma, eps > 1, FIT_MAX_BEYOND);
    if (speed * unit_m_s[r->form.unit] < 1e-30)
        return refuse_cell(r, SPEED, r->cell[r->place[SPEED]], "a speed of 1e-30 m/s or more, as 0.25");
    const struct fit_point point = {.speed_m_s = speed * unit_m_s[r->form.unit], .eps = eps, .sigma = sigma};
    return add_point(data, r, point, NULL);
}

/* One drop of a ball */
struct drop {
    char run[CELL_SHOWN + 1];
    long bounces;
    double time_s, flight_s; /* of the last bounce, and of the flight before it */
    long line[2];            /* of the last two bounces, the last one second */
};

static int end_drop(const struct reader *r, const struct drop *drop)
{
    return drop->bounces == 0 || drop->bounces >= 3
               ? STATUS_OK
               : refuse(r, TIME, "the drop before this line has %ld bounce%s; allowed: 3 or more, which give one eps",
                        drop->bounces, drop->bounces == 1 ? "" : "s");
}

static int read_bounce(struct fit_data *data, const struct reader *r, struct drop *drop)
{
    double time;
    int status = read_number(&time, r, TIME, &time_range);
    if (status != STATUS_OK)
        return status;
    const char *const run = has(r, RUN) ? r->cell[r->place[RUN]] : "";
    if (drop->bounces > 0 && strncmp(run, drop->run, CELL_SHOWN) != 0) {
        status = end_drop(r, drop);
        drop->bounces = 0;
    }
    if (drop->bounces == 0)
        snprintf(drop->run, sizeof drop->run, "%s", run);
    const double flight = time - drop->time_s;
    if (status == STATUS_OK && drop->bounces > 0 && !(flight > 0))
        return refuse(r, TIME,
                      "%.*s s is not after the bounce before; allowed: ascending times, and another text in "
                      "the column run for another drop",
                      CELL_SHOWN, r->cell[r->place[TIME]]);
    if (status == STATUS_OK && drop->bounces > 1 && flight > FIT_MAX_FLIGHT_RATIO * drop->flight_s)
        return refuse(r, TIME,
                      "a flight of %g s after one of %g s makes eps = %g; allowed: eps up to 1, and by noise up to %g",
                      flight, drop->flight_s, flight / drop->flight_s, FIT_MAX_FLIGHT_RATIO);
    if (status == STATUS_OK && drop->bounces > 1) {
        const struct fit_bounce bounce = {
            0, drop->flight_s, drop->bounces == 2, {drop->line[0], drop->line[1], r->number}};
        const struct fit_point point = {.speed_m_s = r->form.gravity_m_s2 * drop->flight_s / 2,
                                        .eps = flight / drop->flight_s};
        status = add_point(data, r, point, &bounce);
    }
    drop->line[0] = drop->line[1];
    drop->line[1] = r->number;
    drop->bounces++;
    drop->time_s = time;
    drop->flight_s = flight;
    return status;
}

static int read_rows(struct fit_data *data, struct reader *r)
{
    struct drop drop = {.bounces = 0};
    int status;
    while ((status = next_row(r)) == STATUS_OK && !r->ended) {
        if (r->cells != r->header_cells)
            return refuse(r, COLUMNS,
                          "%d cells, but the first row names %d columns; allowed: as many, separated by %s, and "
                          "numbers with a decimal %s",
                          r->cells, r->header_cells,
                          r->form.separator == ','   ? "commas"
                          : r->form.separator == ';' ? "semicolons"
                                                     : "tabs",
                          r->form.decimal_comma ? "comma" : "point");
        status = has(r, TIME) ? read_bounce(data, r, &drop) : read_point(data, r);
        if (status != STATUS_OK)
            return status;
        if (r->number % 1024 == 0)
            progress("reading", r->number, 0);
    }
    progress_end();
    return status == STATUS_OK ? end_drop(r, &drop) : status;
}

/* ---- the whole file ---- */

/* By speed; equal speeds stay in the order of the file. */
static int compare_points(const void *a, const void *b)
{
    const struct fit_point *const p = a, *const q = b;
    if (p->speed_m_s != q->speed_m_s)
        return p->speed_m_s < q->speed_m_s ? -1 : 1;
    return p->row < q->row ? -1 : p->row > q->row;
}

static int read_table(struct fit_data *data, struct reader *r)
{
    int status = next_row(r);
    if (status == STATUS_OK && r->ended)
        return refuse(r, COLUMNS, "the file is empty; allowed: names of columns and points, as speed_m_s,eps");
    if (status == STATUS_OK)
        status = read_header(data, r);
    if (status != STATUS_OK)
        return status;
    if (has(r, TIME) && r->form.unit != FIT_UNIT_OF_COLUMN)
        return refuse(r, TIME,
                      "--unit is that of a column speed, and times of bounces have none; allowed: seconds, as 0.52");
    data->has_sigma = has(r, EPS_SIGMA);
    status = read_rows(data, r);
    if (status == STATUS_OK && data->points < FIT_MIN_POINTS)
        status = refuse(r, COLUMNS, "the file ends after %zu point%s; allowed: %d or more%s", data->points,
                        data->points == 1 ? "" : "s", FIT_MIN_POINTS,
                        has(r, TIME) ? ", from 4 bounces" : ", as 0.1,0.93 and 1,0.89");
    return status;
}

int fit_data_parse(struct fit_data *data, FILE *file, const char *name, const struct fit_form *form)
{
    struct reader r = {.name = name, .file = file, .form = *form};
    *data = (struct fit_data){0};
    const int status = read_table(data, &r);
    progress_end();
    if (status != STATUS_OK) {
        fit_data_clear(data);
        return status;
    }
    qsort(data->point, data->points, sizeof *data->point, compare_points);
    for (size_t i = 0; data->bounce && i < data->points; i++)
        data->bounce[data->point[i].row].point = i;
    return STATUS_OK;
}

int fit_data_read(struct fit_data *data, const char *path, const struct fit_form *form)
{
    const bool standard = strcmp(path, "-") == 0;
    FILE *const file = standard ? stdin : fopen(path, "r");
    if (!file)
        return fail("cannot read %s: %s", path, strerror(errno));
    if (standard && isatty(STDIN_FILENO))
        progress_hold();
    const int status = fit_data_parse(data, file, standard ? "standard input" : path, form);
    progress_resume();
    if (!standard)
        fclose(file);
    return status;
}

void fit_data_copy(struct fit_data *copy, const struct fit_data *data, const bool *left_out)
{
    const size_t n = data->points;
    size_t *const place = xmalloc(n * sizeof *place), kept = 0;
    *copy = (struct fit_data){.point = xmalloc(n * sizeof *copy->point),
                              .has_sigma = data->has_sigma,
                              .bounce = data->bounce ? xmalloc(n * sizeof *copy->bounce) : NULL};
    for (size_t i = 0; i < n; i++) {
        place[i] = copy->points;
        if (!left_out[i])
            copy->point[copy->points++] = data->point[i];
    }
    bool begins = false;
    for (size_t k = 0; data->bounce && k < n; k++) {
        begins = begins || data->bounce[k].begins;
        if (left_out[data->bounce[k].point]) {
            begins = true;
            continue;
        }
        copy->bounce[kept] = data->bounce[k];
        copy->bounce[kept].point = place[data->bounce[k].point];
        copy->bounce[kept++].begins = begins;
        begins = false;
    }
    free(place);
}

void fit_data_clear(struct fit_data *data)
{
    free(data->point);
    free(data->bounce);
    free(data->unused);
    *data = (struct fit_data){0};
}
