/* SPDX-License-Identifier: MIT */
/* corgen audit: the restitution that the input of a simulator really gives. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/commands.h"
#include "contact/contact.h"
#include "cor/audit.h"
#include "support/console.h"
#include "support/output.h"

#define DEFAULT_TOLERANCE "0.01"
enum { MOST_BYTES = 1 << 28 };

/* ---- files ---- */

/* The texts that were read; they last until the end. */
struct texts {
    struct cor_audit_text *text;
    int count;
};

/* Reads a file, "-" for standard input. Returns 0, or an error number. */
static int read_text(struct cor_audit_text *text, struct texts *texts, const char *path)
{
    size_t size;
    char *const bytes = read_file(path, MOST_BYTES, &size);
    if (!bytes)
        return errno;
    *text = (struct cor_audit_text){xstrdup(strcmp(path, "-") == 0 ? "standard input" : path), bytes, size};
    texts->text = xrealloc(texts->text, (size_t)(texts->count + 1) * sizeof *texts->text);
    texts->text[texts->count++] = *text;
    return 0;
}

/* ---- findings ---- */

static const char columns[] = "line,simulator,model,pair,asked,end,speed_m_s,realised,step_bias,step_scatter,advice";

struct audit_run {
    const struct audit_arguments *given;
    struct texts texts;
    FILE *file; /* text */
    struct table table;
    const char *name; /* of the file, which a line number of csv needs no name for; NULL: several */
    int contacts, as_asked, not_as_asked, not_read;
    double tolerance;
};

/* A name in the folder of the text that includes it, otherwise in that of the first text */
static int open_included(void *context, struct cor_audit_text *included, const char *name, const char *from)
{
    struct audit_run *const run = context;
    const char *const folders[] = {from, run->texts.text[0].name};
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        const int folder = *name == '/' ? 0 : (int)(file_name(folders[i]) - folders[i]);
        char *const path = xprintf("%.*s%s", folder, folders[i], name);
        const int wrong = read_text(included, &run->texts, path);
        free(path);
        if (wrong == 0)
            return 0;
    }
    return 1;
}

static void print_finding(FILE *file, const struct cor_audit_finding *f)
{
    fprintf(file, "%s:%ld: ", f->file, f->line);
    if (!f->model) {
        fprintf(file, "%s\n", f->advice);
        return;
    }
    fprintf(file, "%s %s, %s", f->simulator, f->model, f->pair);
    if (!isnan(f->speed_m_s))
        fprintf(file, ", %.6g m/s", f->speed_m_s);
    fputs("\n    ", file);
    if (!isnan(f->asked))
        fprintf(file, "asked for %.6g, ", f->asked);
    if (isnan(f->realised))
        fputs("eps is not known", file);
    else
        fprintf(file, "eps = %.6g at %s", f->realised, cor_end_names[f->end]);
    if (!isnan(f->asked))
        fputs(f->as_asked == 1 ? ": as asked" : ": NOT AS ASKED", file);
    if (!isnan(f->damping))
        fprintf(file, "; %s, %s = %.6g", cor_law_name((enum cor_law)f->law) ? cor_law_name((enum cor_law)f->law) : "",
                f->law == COR_LAW_LINEAR || f->law == COR_LAW_TSUJI ? "zeta" : "beta", f->damping);
    if (!isnan(f->duration_s))
        fprintf(file, "; contact %.3g s", f->duration_s);
    if (!isnan(f->duration_s) && !isnan(f->time_step_s))
        fprintf(file, " = %.4g steps", f->duration_s / f->time_step_s);
    if (!isnan(f->step_bias))
        fprintf(file, "; the step adds %.2g in the mean, with scatter %.2g", f->step_bias, f->step_scatter);
    fputs("\n", file);
    if (*f->advice)
        fprintf(file, "    %s\n", f->advice);
    if (*f->instead)
        fprintf(file, "    write: %s\n", f->instead);
}

static void add_finding(struct audit_run *run, const struct cor_audit_finding *f, bool named)
{
    run->contacts += f->model != NULL;
    run->as_asked += f->as_asked == 1;
    run->not_as_asked += f->model && f->as_asked == 0;
    run->not_read += !f->model;
    if (run->given->common.format == FORMAT_TEXT) {
        print_finding(run->file, f);
        return;
    }
    struct table *const table = &run->table;
    table_add(table, xprintf("%s%s%ld", named ? f->file : "", named ? ":" : "", f->line));
    table_add_text(table, f->simulator);
    table_add_text(table, f->model ? f->model : "");
    table_add_text(table, f->pair);
    table_add_known(table, f->asked, CONTACT_DIGITS);
    table_add_text(table, f->end < 0 ? "" : cor_end_names[f->end]);
    table_add_known(table, f->speed_m_s, CONTACT_DIGITS);
    table_add_known(table, f->realised, CONTACT_DIGITS);
    table_add_known(table, f->step_bias, CONTACT_DIGITS);
    table_add_known(table, f->step_scatter, CONTACT_DIGITS);
    table_add(table, xprintf("%s%s%s%s", f->advice, *f->advice && *f->instead ? " " : "", *f->instead ? "Write: " : "",
                             f->instead));
}

/* Replaces the texts, which the input or its name may have, by printable ones. */
static void take_finding(void *context, const struct cor_audit_finding *found)
{
    struct audit_run *const run = context;
    struct cor_audit_finding f = *found;
    const char **const text[] = {&f.file, &f.pair, &f.advice, &f.instead};
    char *shown[sizeof text / sizeof *text];
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        *text[i] = shown[i] = xprintable(*text[i]);
    add_finding(run, &f, !run->name || strcmp(run->name, found->file) != 0);
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        free(shown[i]);
}

/* ---- the command ---- */

/* Returns STATUS_OK, STATUS_NOT_AS_ASKED, or STATUS_USAGE after a message. */
static int audit_file(struct audit_run *run, struct cor_audit_memory *memory, const char *path)
{
    const struct audit_arguments *const o = run->given;
    const char *const simulator = o->simulator < 0 ? NULL : cor_audit_simulators[o->simulator];
    const struct cor_audit_options options = {.simulator = simulator,
                                              .version = o->version ? cor_simulator_version(o->version) : 0,
                                              .speed_m_s = o->speed.nearest,
                                              .speeds = o->speed.count,
                                              .radius_m = options_number(&o->radius, NAN),
                                              .density_kg_m3 = options_number(&o->density, NAN),
                                              .time_step_s = options_number(&o->time_step, NAN),
                                              .tolerance = run->tolerance,
                                              .solver = contact_enclosed,
                                              .open = open_included,
                                              .report = take_finding,
                                              .context = run};
    struct cor_audit_text text;
    run->texts = (struct texts){0};
    const int wrong = read_text(&text, &run->texts, path);
    if (wrong != 0)
        return usage_error("cannot read %s: %s", path, strerror(wrong));
    run->name = o->files.count == 1 ? text.name : NULL;
    const int found = cor_audit(memory, &text, &options);
    int status = found == COR_AUDIT_NOT_AS_ASKED ? STATUS_NOT_AS_ASKED : STATUS_OK;
    if (found == COR_AUDIT_NO_CONTACT)
        status = usage_error("%s: no contact could be made out; allowed: the input of %s", text.name,
                             simulator ? simulator : "a simulator that corgen audit --help names");
    else if (found == COR_AUDIT_NOT_TEXT)
        status = usage_error("%s is not a text: it holds zero bytes", text.name);
    else if (found == COR_AUDIT_UNKNOWN)
        status = usage_error("%s: no simulator is recognised; name it by --for, as --for lammps", text.name);
    for (int i = 0; i < run->texts.count; i++) {
        free((char *)(uintptr_t)run->texts.text[i].name);
        free((char *)(uintptr_t)run->texts.text[i].text);
    }
    free(run->texts.text);
    return status;
}

static int run_audit(const void *arguments)
{
    const struct audit_arguments *const o = arguments;
    struct audit_run run = {.given = o, .tolerance = options_number(&o->tolerance, strtod(DEFAULT_TOLERANCE, NULL))};
    char *text = NULL;
    size_t size;
    int status = STATUS_OK;
    if (o->version && cor_simulator_version(o->version) == 0)
        return usage_error("--simulator-version: '%s' is no version; allowed: as '29 Sep 2021' or 3.8.1", o->version);
    struct cor_audit_memory *const memory = xmalloc(sizeof *memory);
    run.file = open_memstream(&text, &size);
    table_init(&run.table, columns, o->files.count == 1 ? "ntttntnnnnt" : "ttttntnnnnt");
    for (int i = 0; i < o->files.count && status != STATUS_USAGE; i++) {
        const int found = audit_file(&run, memory, o->files.name[i]);
        status = found > status ? found : status;
        if (found == STATUS_USAGE)
            status = STATUS_USAGE;
    }
    if (o->common.format != FORMAT_TEXT) {
        table_print(&run.table, (enum output_format)o->common.format, run.file);
    } else {
        fprintf(run.file, "%s%d contact%s: %d as asked within %.3g %%, %d not, %d asked for no e",
                run.contacts ? "\n" : "", run.contacts, run.contacts == 1 ? "" : "s", run.as_asked, 100 * run.tolerance,
                run.not_as_asked, run.contacts - run.as_asked - run.not_as_asked);
        if (run.not_read)
            fprintf(run.file, "; %d line%s not read", run.not_read, run.not_read == 1 ? "" : "s");
        fputs("\n", run.file);
    }
    fclose(run.file);
    if (status != STATUS_USAGE) {
        const int written = output_text(o->common.output, text);
        status = written == STATUS_OK ? status : written;
    }
    free(text);
    table_clear(&run.table);
    free(memory);
    return status;
}

static const char help[] =
    "Usage: corgen audit FILE... [OPTION]...\n\n"
    "Reads the input of a simulator as it is, and prints for every contact that it describes the\n"
    "restitution that was asked for, the one that is realised, and the line that realises what was\n"
    "asked. Lines that cannot be read are named. Nothing is guessed.\n"
    "\nInputs: scripts of LAMMPS (pair_style granular and gran/..., fix wall/gran) and LIGGGHTS\n"
    "(pair_style gran model, fix property/global, fix wall/gran model), YADE's Python (lines of\n"
    "ViscElMat, FrictMat and Ip2_FrictMat_FrictMat_MindlinPhys with numbers or names of numbers),\n"
    "materials of Kratos (json), MFiX (des_en_input, ...), and models of MuJoCo (solref, solimp).\n"
    "\nOptions:\n"
    "  --speed LIST     impact speeds, m/s (default: those of the file)\n"
    "  --radius R       radius of the spheres, m, where the file does not say it\n"
    "  --density RHO    their density, kg/m^3, where the file does not say it\n"
    "  --time-step DT   time step, s (default: that of the file)\n"
    "  --tolerance T    as asked: the mean eps differs from e by at most T e, and the time step\n"
    "                   scatters it by no more (default " DEFAULT_TOLERANCE ")\n"
    "  --for SIMULATOR  the simulator, where the file does not show it\n"
    "  --simulator-version V   its version, as '29 Sep 2021' or 3.8.1: known faults depend on it\n"
    "  --format F       text (default), csv or json\n" HELP_COMMON
    "\nColumns: line,simulator,model,pair,asked,end,speed_m_s,realised,step_bias,step_scatter,advice.\n"
    "The line is FILE:LINE where several files are read.\n"
    "\nExit status: 0 if every e that is asked for is realised, 3 if not or if a contact cannot be\n"
    "judged, 2 if a file has no contact that could be made out.\n"
    "\nExample: corgen audit in.chute --radius 5e-3 --density 2500 --speed 0.1,1\n";

#define ARGUMENTS struct audit_arguments
static const struct option_rule options[] = {
    OPTION("files", FILES, files, .required = true, .operand = "FILE"),
    OPTION("speed", LIST, speed, .range.values = &option_speeds),
    OPTION("radius", REAL, radius, .range.number = &option_positive),
    OPTION("density", REAL, density, .range.number = &option_positive),
    OPTION("time-step", REAL, time_step, .range.number = &option_positive),
    OPTION("tolerance", REAL, tolerance, .range.number = &option_positive),
    OPTION("for", WORD, simulator, .range.words = cor_audit_simulators, .why = "a simulator"),
    OPTION_PLAIN("simulator-version", TEXT, version),
    OPTION_FORMAT(option_formats),
    OPTION_COMMON,
};

SUBCOMMAND(audit, "audit", "the restitution that the input of a simulator really gives",
           .simulator = OPTIONS_NOT_GIVEN);
