/* SPDX-License-Identifier: MIT */
#include "sweep/sweep.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cor/status.h"
#include "disk/modes.h"
#include "support/clock.h"
#include "support/console.h"
#include "support/decimal.h"
#include "support/gnuplot.h"
#include "support/parallel.h"

/* Number of rows of one parallel loop, whose results are in memory together */
enum { ROWS_AT_A_TIME = 1 << 14 };

/* More curves cannot be distinguished in a picture. */
enum { MOST_CURVES = 12, CURVE_TITLE = 3 * DECIMAL_TEXT };

struct collide {
    struct sweep sweep;
    struct cor_disk_modes modes;    /* soft walls: modes of the current material */
    struct hard_wall_tables tables; /* hard wall: the modes of the current material that the rows need */

    struct journal journal; /* lines go to the journal if it has a path, otherwise to the printer */
    struct sweep_printer printer;
    struct output out; /* file of the printer */
    const char *again; /* last line of an earlier run, computed again as a check, or NULL */
    uint64_t again_row;

    double modes_seconds, rows_seconds, rows_started; /* times: a material's modes; finished rows; start of a loop */
    uint64_t rows, finished, done;                    /* number of rows: of the part; finished; finished by this run */
    uint64_t first;                                   /* first row of a loop over ROWS_AT_A_TIME rows */
    struct sweep_result *result;
    size_t materials_left;
};

/* ---- limits of a sweep ---- */

static bool is_soft(const struct sweep *sweep)
{
    return !sweep->hard_wall && !sweep->rayleigh;
}

/* ---- modes ---- */

static int find_modes(struct collide *run, size_t material)
{
    const double start = clock_seconds();
    if (run->sweep.hard_wall) { /* each row computes the modes that it needs */
        hard_wall_tables_set(&run->tables, run->sweep.poisson.nearest[material]);
        return STATUS_OK;
    }
    free((void *)run->modes.mode);
    run->modes.mode = NULL;
    const int status =
        disk_modes_rounded(&run->modes, run->sweep.poisson.exact + material, (slong)run->sweep.modes.largest);
    profile_step(NULL);
    run->modes_seconds = clock_seconds() - start;
    return status;
}

/* Checks the parameters: calls the integrator, without a workspace, at every corner of the sweep. */
static int refuse_corners(const struct sweep *s, const struct cor_disk_modes *modes)
{
    const double alpha[] = {s->alpha.least, s->alpha.largest}, speed[] = {s->speed.least, s->speed.largest};
    const double count[] = {s->modes.least, s->modes.largest};
    for (int corner = 0; corner < 8; corner++) {
        const double a = alpha[corner & 1], v = speed[corner >> 1 & 1];
        const size_t n = (size_t)fmin(count[corner >> 2], (double)modes->count);
        const struct cor_disk_collision_options options = {a, s->tolerance, (size_t)s->phi_points, 0};
        struct cor_disk_collision out;
        double nothing = 0;
        const int status = cor_disk_collision_in(&nothing, 0, modes, n, &options, v, &out, NULL);
        if (status != COR_ERROR_WORKSPACE)
            return usage_error("--alpha %g with --speed %g and --modes %g: %s", a, v, count[corner >> 2],
                               cor_status_text(status));
    }
    return STATUS_OK;
}

/* ---- rows ---- */

/* number_of converts the index i of a row in the part to its number in the sweep. rows_before returns the number of
 * rows of the part that precede row `number` of the sweep. */
static uint64_t number_of(const struct sweep *sweep, uint64_t i)
{
    return i * (uint64_t)sweep->parts + (uint64_t)sweep->part - 1;
}

static uint64_t rows_before(const struct sweep *sweep, uint64_t number)
{
    const uint64_t part = (uint64_t)sweep->part, parts = (uint64_t)sweep->parts;
    return number < part ? 0 : (number - part) / parts + 1;
}

static void collide_row(void *context, slong i)
{
    struct collide *run = context;
    sweep_collide(&run->result[i], &run->sweep, number_of(&run->sweep, run->first + (uint64_t)i), &run->modes,
                  &run->tables);
}

static int row_finished(void *context, slong i)
{
    struct collide *run = context;
    const struct sweep_result *const result = &run->result[i];
    const uint64_t number = run->first + (uint64_t)i;
    char line[SWEEP_LINE];
    sweep_line(line, &run->sweep, result);
    if (result->status == COR_ERROR_MEMORY)
        return fail("row %" PRIu64 ": %s", number + 1, cor_status_text(result->status));
    if (run->again && number == run->again_row) {
        if (strcmp(line, run->again) != 0)
            return fail("%s was written by another version of corgen or on another machine: its row %" PRIu64
                        " differs from the row computed now; continue with that version and machine, remove the file "
                        "or choose another --output",
                        run->journal.path, number + 1);
        return STATUS_OK;
    }
    run->finished++;
    run->done++;
    if (run->journal.path)
        return journal_add(&run->journal, line);
    sweep_print(&run->printer, line);
    output_show(&run->out);
    return ferror(run->printer.file) ? STATUS_FAILED : STATUS_OK; /* output_commit reports the reason */
}

/* Prints the remaining time, estimated from the previous rows of this run. It is unknown before the first row. */
static void sweep_tick(void *context)
{
    const struct collide *const run = context;
    const double seconds = run->rows_seconds + clock_seconds() - run->rows_started;
    const double rows = seconds * (double)(run->rows - run->finished) / (double)run->done;
    progress_left("collisions", (long)run->finished, (long)run->rows,
                  run->done == 0 ? -1 : rows + run->modes_seconds * (double)run->materials_left);
}

/* Collides all rows from `first` onward. */
static int collide_all(struct collide *run, uint64_t first)
{
    const uint64_t each = sweep_rows_of_material(&run->sweep);
    run->finished = first;
    if (first > 0 && first < run->rows && run->journal.last) {
        run->again = run->journal.last;
        run->again_row = first - 1;
        first--;
    }
    run->result = xmalloc(ROWS_AT_A_TIME * sizeof *run->result);
    for (uint64_t end; first < run->rows; first = end) {
        const size_t material = (size_t)(number_of(&run->sweep, first) / each);
        end = rows_before(&run->sweep, (material + 1) * each);
        run->materials_left = run->sweep.poisson.count - material - 1;
        int status = find_modes(run, material);
        if (status == STATUS_OK && is_soft(&run->sweep))
            status = refuse_corners(&run->sweep, &run->modes);
        if (status != STATUS_OK)
            return status;
        profile_step("collisions");
        run->rows_started = clock_seconds();
        for (run->first = first; run->first < end && status == STATUS_OK; run->first += ROWS_AT_A_TIME) {
            const uint64_t rows = end - run->first < ROWS_AT_A_TIME ? end - run->first : ROWS_AT_A_TIME;
            status = parallel_in_order(collide_row, row_finished, sweep_tick, run, (slong)rows);
        }
        run->rows_seconds += clock_seconds() - run->rows_started;
        profile_step(NULL);
        if (status != STATUS_OK)
            return status;
    }
    return STATUS_OK;
}

/* ---- output ---- */

/* Reports rows whose status is not ok. */
static int report_rows(const struct sweep_printer *p)
{
    const bool beyond = p->beyond_theory > 0;
    return p->tolerance_not_reached + p->failed + p->beyond_theory == 0
               ? STATUS_OK
               : fail("of %" PRIu64 " rows, %" PRIu64 " %s and %" PRIu64 " have no eps; see the column status", p->rows,
                      beyond ? p->beyond_theory : p->tolerance_not_reached,
                      beyond ? "are beyond Rayleigh's theory" : "did not reach the tolerance", p->failed);
}

/* Returns the line that identifies a sweep by its command, malloc'ed. */
static char *title_of_whole(const struct sweep *s)
{
    char tolerance[DECIMAL_TEXT];
    decimal_text(tolerance, s->tolerance);
    static const char start[] = "corgen disk-collide, unfinished: --speed";
    if (s->hard_wall)
        return xprintf("%s %s --poisson %s --hard-wall --tolerance %s", start, s->speed.text, s->poisson.text,
                       tolerance);
    if (s->rayleigh)
        return xprintf("%s %s --poisson %s --rayleigh --modes %s", start, s->speed.text, s->poisson.text,
                       s->modes.text);
    return xprintf("%s %s --poisson %s --alpha %s --modes %s --tolerance %s --phi-points %ld", start, s->speed.text,
                   s->poisson.text, s->alpha.text, s->modes.text, tolerance, (long)s->phi_points);
}

/* Returns the title of the whole sweep, followed by the part and, as a comment, the checksum of the files that contain
 * lists. */
static char *title_of(const struct sweep *s, const struct sweep_request *request)
{
    const uint32_t check = s->speed.check ^ 3 * s->poisson.check ^ 5 * s->alpha.check ^ 7 * s->modes.check;
    char *const whole = title_of_whole(s), part[DECIMAL_TEXT] = "", files[DECIMAL_TEXT] = "";
    if (request->is_part || request->joins)
        snprintf(part, sizeof part, " --part %ld/%ld", (long)s->part, (long)s->parts);
    if (check)
        snprintf(files, sizeof files, " # files %08" PRIx32, check);
    char *const title = xprintf("%s%s%s", whole, part, files);
    free(whole);
    return title;
}

/* Returns the malloc'ed name of the journal of a part, without its ending .part. */
static char *part_file(const struct sweep *s, const struct sweep_request *request)
{
    return xprintf("%s.%ld-of-%ld", request->output, (long)s->part, (long)s->parts);
}

/* Computes a part into its journal, which is not removed. */
static int collide_part(struct collide *run, const struct sweep_request *request)
{
    char *const title = title_of(&run->sweep, request), *const file = part_file(&run->sweep, request);
    int status = journal_open(&run->journal, file, title, run->rows);
    if (status == STATUS_OK)
        status = collide_all(run, run->journal.lines);
    if (status == STATUS_OK)
        journal_close(&run->journal, false);
    free(title);
    free(file);
    return status;
}

/* Prints the rows of all parts in the order of the sweep. */
static int join_parts(struct collide *run, const struct sweep_request *request)
{
    struct sweep *const s = &run->sweep;
    struct journal *const part = xmalloc((size_t)s->parts * sizeof *part);
    char *line = NULL;
    slong opened = 0;
    int status = STATUS_OK;
    for (s->part = 1; s->part <= s->parts && status == STATUS_OK; s->part++) {
        char *const title = title_of(s, request), *const file = part_file(s, request);
        status = journal_open_part(&part[opened++], file, title, rows_before(s, s->rows));
        free(title);
        free(file);
    }
    for (uint64_t i = 0; i < s->rows && status == STATUS_OK; i++)
        if (journal_next(&part[i % (uint64_t)s->parts], &line))
            sweep_print(&run->printer, line);
        else
            status = fail("another program has changed %s; run the part again with its --part",
                          part[i % (uint64_t)s->parts].path);
    while (opened > 0)
        journal_close(&part[--opened], false);
    free(part);
    free(line);
    return status;
}

/* Writes an output file from its finished journal, and any other output row by row. */
static int collide_to_output(struct collide *run, const struct sweep_request *request)
{
    const bool kept = !output_is_direct(request->output) && !request->joins;
    int status = output_open(&run->out, request->output);
    if (status != STATUS_OK)
        return status;
    sweep_print_start(&run->printer, &run->sweep, request->format, run->out.file);
    if (kept) {
        char *const title = title_of(&run->sweep, request);
        status = journal_open(&run->journal, request->output, title, run->sweep.rows);
        free(title);
    }
    if (status == STATUS_OK)
        status = request->joins ? join_parts(run, request) : collide_all(run, run->journal.lines);
    if (status == STATUS_OK && kept)
        status = journal_read(&run->journal, sweep_print, &run->printer);
    if (status == STATUS_OK)
        sweep_print_end(&run->printer);
    if (status == STATUS_OK || ferror(run->out.file))
        status = output_commit(&run->out);
    else
        output_discard(&run->out);
    if (kept)
        journal_close(&run->journal, status == STATUS_OK);
    return status == STATUS_OK ? report_rows(&run->printer) : status;
}

/* ---- picture ---- */

static int refuse_curves(struct collide *run)
{
    const uint64_t curves = run->sweep.rows / run->sweep.speed.count;
    if (run->sweep.speed.count < 2)
        return usage_error("--plot needs two speeds or more, for example --speed 0.01:0.3:log:12");
    if (curves > MOST_CURVES)
        return usage_error("--plot: the lists make %" PRIu64 " curves; allowed: up to %d", curves, MOST_CURVES);
    run->sweep.eps = xmalloc(run->sweep.rows * sizeof *run->sweep.eps);
    return STATUS_OK;
}

static int draw_rows(const struct sweep *sweep, const char *path)
{
    struct eps_curve curve[MOST_CURVES];
    char title[MOST_CURVES][CURVE_TITLE];
    const uint64_t points = sweep->speed.count, curves = sweep->rows / points;
    for (uint64_t i = 0; i < curves; i++) {
        struct sweep_row row;
        sweep_row(&row, sweep, i * points);
        int n = snprintf(title[i], CURVE_TITLE, "ν = %g", row.nu);
        if (is_soft(sweep))
            n += snprintf(title[i] + n, CURVE_TITLE - (size_t)n, ", α = %g", row.alpha);
        if (!sweep->hard_wall)
            snprintf(title[i] + n, CURVE_TITLE - (size_t)n, ", %zu modes", row.modes);
        curve[i] = (struct eps_curve){title[i], sweep->speed.nearest, sweep->eps + i * points, points};
    }
    return eps_plot(path,
                    sweep->hard_wall  ? "elastic disk with all its modes, rigid wall"
                    : sweep->rayleigh ? "elastic disk, Rayleigh's energy"
                                      : "elastic disk, wall of potential exp(α x)/α",
                    "impact speed in units of (E/ρ)^{1/2}", (double)NAN, curve, curves);
}

int sweep_run(const struct sweep_request *request)
{
    struct collide run = {.sweep = request->sweep};
    /* any mode serves here: the modes are not computed yet, and no refusal depends on them */
    static const struct cor_disk_mode mode = {2, 0, 1.4, 1, 0};
    const struct cor_disk_modes modes = {run.sweep.poisson.nearest[0], 1, &mode};
    parallel_use((int)request->threads);
    int status = sweep_count(&run.sweep);
    if (status == STATUS_OK && is_soft(&run.sweep))
        status = refuse_corners(&run.sweep, &modes);
    if (status == STATUS_OK && request->plot)
        status = refuse_curves(&run);
    run.rows = rows_before(&run.sweep, run.sweep.rows);
    if (status == STATUS_OK)
        status = request->is_part ? collide_part(&run, request) : collide_to_output(&run, request);
    if (run.sweep.eps && run.printer.rows == run.sweep.rows) {
        const int drawn = draw_rows(&run.sweep, request->plot);
        status = status == STATUS_OK ? drawn : status;
    }
    free(run.sweep.eps);
    table_clear(&run.printer.table); /* left by a sweep that failed */
    free((void *)run.modes.mode);
    free(run.result);
    hard_wall_tables_clear(&run.tables);
    return status;
}
