/* SPDX-License-Identifier: MIT */
/* corgen disk-collide: sweeps of the full dynamics of disks. docs/disks.md. */
#include <stdlib.h>
#include <string.h>

#include "cli/commands.h"
#include "cor/disk.h"
#include "support/console.h"
#include "support/gnuplot.h"
#include "support/parallel.h"

#define DEFAULT_TOLERANCE "1e-8"
#define DEFAULT_HARD_WALL_TOLERANCE "1e-5"
enum { MOST_PARTS = 1000 }; /* --join opens the files of all parts at once */

static const struct option_numbers tolerance_numbers = {
    .range = {TEXT_OF(COR_DISK_COLLISION_MIN_TOLERANCE), "1", true, false, true,
              "a number from " TEXT_OF(COR_DISK_COLLISION_MIN_TOLERANCE) " to below 1"}};
static const struct option_numbers hard_wall_tolerance = {
    .range = {TEXT_OF(COR_DISK_HARD_WALL_MIN_TOLERANCE), "1", true, false, true,
              "a number from " TEXT_OF(COR_DISK_HARD_WALL_MIN_TOLERANCE) " to below 1 (--hard-wall)"}};

/* Reads I/N of --part. */
static int read_part(struct sweep *sweep, const char *text)
{
    const size_t first = strspn(text, "0123456789"),
                 second = text[first] == '/' ? strspn(text + first + 1, "0123456789") : 0;
    const bool is_part = first > 0 && second > 0 && first + 1 + second == strlen(text) && first < 9 && second < 9;
    sweep->part = is_part ? atol(text) : 0;
    sweep->parts = is_part ? atol(text + first + 1) : 0;
    return sweep->part > 0 && sweep->part <= sweep->parts && sweep->parts <= MOST_PARTS
               ? STATUS_OK
               : usage_error("--part: '%s' is not I/N, two whole numbers with 1 <= I <= N <= %d, for example 2/8", text,
                             MOST_PARTS);
}

static int run_disk_collide(const void *arguments)
{
    const struct disk_collide_arguments *const o = arguments;
    struct sweep_request request = o->request;
    struct sweep *const sweep = &request.sweep;
    /* soft walls need alpha and a number of modes; the hard wall has neither */
    const char *const missing = sweep->hard_wall                         ? NULL
                                : !sweep->rayleigh && !sweep->alpha.text ? "alpha"
                                : !sweep->modes.text                     ? "modes"
                                                                         : NULL;
    if (missing)
        return usage_error(
            "corgen disk-collide needs --%s, for example --%s 500, or --hard-wall; see corgen disk-collide --help",
            missing, missing);
    if (sweep->hard_wall && o->tolerance.text &&
        options_check_real("tolerance", &hard_wall_tolerance, &o->tolerance) != STATUS_OK)
        return STATUS_USAGE;
    sweep->part = 1;
    sweep->parts = o->join > 0 ? o->join : 1;
    request.joins = o->join > 0;
    request.is_part = o->part != NULL;
    if (o->part && read_part(sweep, o->part) != STATUS_OK)
        return STATUS_USAGE;
    if (o->part && output_is_direct(o->common.output))
        return usage_error("--part needs --output FILE with the name of a regular file, for example --output eps.csv");
    if (request.plot && gnuplot_check(request.plot) != STATUS_OK)
        return STATUS_USAGE;
    sweep->tolerance =
        options_number(&o->tolerance, strtod(sweep->hard_wall ? DEFAULT_HARD_WALL_TOLERANCE : DEFAULT_TOLERANCE, NULL));
    const int format = o->join > 0 ? FORMAT_CSV : FORMAT_TEXT; /* parts are csv */
    request.format = (enum output_format)(o->common.format == OPTIONS_NOT_GIVEN ? format : o->common.format);
    request.output = o->common.output;
    return sweep_run(&request);
}

static const char help[] =
    "Usage: corgen disk-collide --speed LIST --poisson LIST --alpha LIST --modes LIST [OPTION]...\n"
    "       corgen disk-collide --hard-wall --speed LIST --poisson LIST [OPTION]...\n"
    "       corgen disk-collide --rayleigh --speed LIST --poisson LIST --modes LIST [OPTION]...\n\n"
    "Computes the collision of an elastic disk for every combination of the lists: with a wall of\n"
    "potential exp(alpha x)/alpha and the given number of modes, with a rigid wall and all modes, or by\n"
    "Rayleigh's integral for the energy of the vibrations. Units: E = rho = R = 1.\n\n"
    "  --hard-wall      use a rigid wall and all modes, the limit of large alpha and of many modes\n"
    "  --rayleigh       use Rayleigh's energy to first order: fraction of the modes, tail of all higher\n"
    "                   modes, and eps = sqrt(1 - fraction - tail)\n"
    "  --speed LIST     impact speeds, sqrt(E/rho), above 0 and up to 0.5\n"
    "  --poisson LIST   Poisson's ratios in plane stress, between -1 and 1\n"
    "  --alpha LIST     hardnesses of the wall, 40 to 1e5\n"
    "  --modes LIST     numbers of modes, 1 to 10000000\n"
    "  --tolerance T    largest error of eps, 1e-13 to below 1 (default " DEFAULT_TOLERANCE "), or with --hard-wall\n"
    "                   of 1 - eps^2, 1e-7 to below 1 (default " DEFAULT_HARD_WALL_TOLERANCE ")\n"
    "  --phi-points M   number of angles in a quadrant at which the wall's force is evaluated, 1 to 16384\n"
    "                   (default: the number that the tolerance needs)\n"
    "  --part I/N       compute only row I and every N-th row after it, 1 <= I <= N <= 1000, into\n"
    "                   FILE.I-of-N.part, where FILE is the name of --output\n"
    "  --join N         check the files of N parts, 1 to 1000, and join them to --output, as csv or in the\n"
    "                   given --format; the bytes are the same as without --part\n"
    "  --threads K      number of threads, 1 to 1024 (default: the number of processors)\n"
    "  --plot FILE      picture of eps over the speed, .svg, .png or .pdf, by gnuplot; up to 12 curves\n"
    "  --format F       output format, text, csv or json (default text)\n"
    "  --output FILE    file for the output (default standard output). FILE.part contains the rows until\n"
    "                   all are computed; the same command continues an interrupted run\n"
    "  --profile        print the seconds of each step and the peak memory on standard error\n\n"
    "LIST: values and ranges, separated by commas; or @FILE, a file of values and ranges, separated by\n"
    "commas, spaces or lines, where # begins a comment. A value is 0.1, 1.5e-3 or 1/3. A range is\n"
    "  A:B:+S     A, A + S, A + 2 S, ... up to B      (-S: down to B)\n"
    "  A:B:lin:N  N values from A to B at equal distances\n"
    "  A:B:log:N  N values from A to B at equal ratios\n\n"
    "Columns: speed,nu,alpha,modes,eps,one_minus_eps2,contact_time,max_compression,energy_drift,\n"
    "steps,error_estimate,status; with --hard-wall: speed,nu,one_minus_eps2,eps,contact_time,\n"
    "max_compression,error_estimate,status; with --rayleigh: speed,nu,modes,fraction,tail,eps,\n"
    "contact_time,error_estimate,status. Numbers have digits up to the second one of error_estimate. The\n"
    "speed varies fastest, then modes, alpha and poisson. If the status of a row is not ok, the exit\n"
    "status is 1.\n\n"
    "Example: corgen disk-collide --speed 0.01:0.3:log:12 --poisson 0.33,0.9 --alpha 500 --modes 100\n";

#define ARGUMENTS struct disk_collide_arguments
static const struct option_rule options[] = {
    OPTION("speed", LIST, request.sweep.speed, .range.values = &sweep_speed, .required = true),
    OPTION("poisson", LIST, request.sweep.poisson, .range.values = &sweep_poisson, .required = true),
    OPTION("alpha", LIST, request.sweep.alpha, .range.values = &sweep_alpha),
    OPTION("modes", LIST, request.sweep.modes, .range.values = &sweep_modes),
    OPTION("tolerance", REAL, tolerance, .range.number = &tolerance_numbers),
    OPTION("phi-points", WHOLE, request.sweep.phi_points, .range.whole = {1, COR_DISK_COLLISION_MAX_PHI_POINTS},
           .why = "corgen does not compute collisions that need more angles"),
    OPTION("hard-wall", FLAG, request.sweep.hard_wall, .excludes = "alpha modes phi-points"),
    OPTION("rayleigh", FLAG, request.sweep.rayleigh, .excludes = "alpha tolerance phi-points hard-wall"),
    OPTION("plot", FILE, request.plot, .excludes = "part"),
    OPTION("part", TEXT, part, .needs = "output", .excludes = "join format"),
    OPTION("join", WHOLE, join, .range.whole = {1, MOST_PARTS}, .why = "corgen opens the files of all parts at once",
           .needs = "output"),
    OPTION("threads", WHOLE, request.threads, .range.whole = {1, PARALLEL_MAX_THREADS},
           .why = "more threads do not help"),
    OPTION_FORMAT(option_formats),
    OPTION_COMMON,
};

SUBCOMMAND(disk_collide, "disk-collide", "collisions of elastic disks, over lists of parameters",
           .common.format = OPTIONS_NOT_GIVEN);
