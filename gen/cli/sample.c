/* SPDX-License-Identifier: MIT */
/* corgen sample tabulates eps of a contact over a range of speeds with the fewest points. */
#include <math.h>

#include "cli/commands.h"
#include "cli/scene_options.h"
#include "contact/contact.h"
#include "contact/sample.h"
#include "support/console.h"

static int run_sample(const void *arguments)
{
    const struct sample_arguments *const o = arguments;
    const struct decimal *const number = o->scene.number;
    const enum sample_format format = (enum sample_format)o->common.format;
    struct embed_request scene = o->scene;
    struct contacts contacts = {.count = 0};
    struct sample sample;
    struct output out;
    if (scene.end == OPTIONS_NOT_GIVEN)
        scene.end = COR_END_ZERO_OVERLAP;
    struct sample_request request = {.contact = &contacts.contact[0],
                                     .speed_min = embed_number(&scene, EMBED_SPEED_MIN),
                                     .speed_max = embed_number(&scene, EMBED_SPEED_MAX),
                                     .tolerance = embed_number(&scene, EMBED_TOLERANCE),
                                     .log = o->log,
                                     .cubic = o->cubic,
                                     .duration = o->duration};
    int status = embed_check_numbers(number, request.speed_min, request.speed_max, SAMPLE_FINEST, SAMPLE_COARSEST);
    if (status != STATUS_OK)
        return status;
    if ((o->log || o->cubic) && (format == SAMPLE_MODELICA || format == SAMPLE_OPENFOAM))
        return usage_error("--format %s: its reader interpolates linearly in the speed; leave out --log and --cubic",
                           sample_format_names[format]);
    OWN_LAW(own);
    status = own_law_init(&own, &scene);
    if (status == STATUS_OK && own.law)
        status = own_law_check(&own, request.speed_min, request.speed_max);
    else if (status == STATUS_OK)
        status = contacts_without_jkr(&contacts, &scene);
    request.own = own.law ? &own : NULL;
    if (status == STATUS_OK && !own.law && o->duration && isnan(contacts.contact[0].mass_kg))
        status = usage_error("--durations needs bodies, or --stiffness and --effective-mass, for example --stiffness "
                             "1e9 --effective-mass 1e-3");
    if (status != STATUS_OK)
        return status;
    if (!own.law) {
        request.end = (enum cor_end)contacts.scene.end;
        contact_warn(&contacts, request.speed_max);
    }
    status = sample_choose(&sample, &request);
    if (status == STATUS_OK)
        status = output_open(&out, o->common.output);
    if (status == STATUS_OK) {
        sample_print(out.file, &sample, &request, format);
        status = output_commit(&out);
    }
    sample_clear(&sample);
    return status;
}

static const char help[] =
    "Usage: corgen sample BODIES DISSIPATION --speed-min G --speed-max G --tolerance T [OPTION]...\n\n"
    "Prints eps of a contact over a range of impact speeds as a table with the fewest points from which\n"
    "interpolation gives eps within a tolerance.\n\n"
    "  --speed-min G, --speed-max G   range of speeds, m/s; both ends are points\n"
    "  --tolerance T    largest relative error of the interpolated eps, 1e-10 to 0.1\n"
    "  --log            interpolate in the logarithm of the speed\n"
    "  --cubic          use cubic Hermite interpolation, with a column of slopes, instead of linear\n"
    "  --durations      print also the duration of contact, s, within the same tolerance\n" HELP_END_PRESSED
    "  --format F       output format, text (with the evenly spaced table next to it), csv, json, c,\n"
    "                   python, modelica (CombiTable1Ds) or openfoam (Function1 table) (default text)\n" HELP_CONTACT
    "\n" HELP_COMMON "\n"
    "Columns: speed_m_s,eps; then eps_slope_s_m, or eps_slope_per_log with --log, if --cubic is\n"
    "given; then duration_s with --durations, and its slope if --cubic is given, too.\n\n"
    "Example: corgen sample --g-star 0.2 --speed-min 0.01 --speed-max 10 --tolerance 1e-3 --log\n";

#define ARGUMENTS struct sample_arguments
static const struct option_rule options[] = {
    SCENE_RANGE,
    OPTION_PLAIN("log", FLAG, log),
    OPTION_PLAIN("cubic", FLAG, cubic),
    OPTION_PLAIN("durations", FLAG, duration),
    SCENE_OPTIONS(NULL, NULL, ""),
    OPTION_FORMAT(sample_format_names),
    OPTION_COMMON,
};

SUBCOMMAND(sample, "sample", "eps over speeds as the fewest points of a table", .scene.end = OPTIONS_NOT_GIVEN);
