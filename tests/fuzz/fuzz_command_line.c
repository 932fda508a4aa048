/* SPDX-License-Identifier: MIT */
/* The whole of corgen, from its command line to its output: the input's lines are the arguments. Each subcommand is run
 * by a function below, which first checks what the parser let through, and goes on where the subcommand is cheap.
 *
 * It runs in a directory of its own, two deep, and arguments have no slash but between digits: nothing outside can be
 * written. stdout and stderr are streams in memory meanwhile; what the sanitizers and libFuzzer say goes to the
 * descriptors as always. */
#define _XOPEN_SOURCE 700 /* mkdtemp, open_memstream */
#include <ctype.h>
#include <dirent.h>
#include <getopt.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include "approximation/interpolant.h"
#include "cli/commands.h"
#include "cli/subcommand.h"
#include "disk/modes.h"
#include "embed/choose.h"
#include "fuzz.h"
#include "support/console.h"
#include "support/parallel.h"
#include "sweep/sweep.h"
#include "sweep/values.h"

int LLVMFuzzerInitialize(int *argc, char ***argv);

enum { ARGUMENTS_MAX = 24, SIZE_MAX_INPUT = 600, PATH_LENGTH = 4096 };

/* Whether the subcommand was too large to be run */
static bool skipped;

static void require_whole(slong value, slong low, slong high)
{
    REQUIRE(value >= low && value <= high, "%ld", (long)value);
}

static void require_number(const struct decimal *number)
{
    if (!number->text)
        return;
    char *end;
    strtod(number->text, &end);
    REQUIRE(*number->text && (*end == '\0' || *end == '/'), "number '%s'", number->text);
}

static void require_name(const char *name)
{
    REQUIRE(!name || *name, "an empty name");
}

static int run_if(bool cheap, const struct subcommand *command, const struct option_common *o)
{
    require_whole(o->format, FORMAT_TEXT, FORMAT_LATEX);
    require_name(o->output);
    skipped = !cheap;
    return cheap ? command->run(o) : STATUS_OK;
}

static bool short_number(const struct decimal *number)
{
    return !number->text || (strlen(number->text) <= 12 && !strpbrk(number->text, "eE"));
}

static bool simple_law(const struct option_law *text)
{
    struct law law;
    return options_law(&law, text) == STATUS_OK && law.a.num <= 9 && law.a.den <= 4 && law.b.num <= 9 && law.b.den <= 4;
}

static bool sphere(const struct option_law *text)
{
    struct law law;
    return options_law(&law, text) == STATUS_OK && law_is_sphere(&law);
}

/* A law that the parser let through may be none; then the subcommand says so. */
static bool no_law(const struct option_law *text)
{
    struct law law;
    return options_law(&law, text) != STATUS_OK;
}

/* The function of a subcommand: what the parser must have seen to, and whether its work is cheap */
#define FUZZED(name, cheap, ...)                                                                                       \
    static int fuzz_##name(const void *arguments)                                                                      \
    {                                                                                                                  \
        const struct name##_arguments *const o = arguments;                                                            \
        __VA_ARGS__;                                                                                                   \
        return run_if(cheap, &command_##name, &o->common);                                                             \
    }

FUZZED(trajectory, no_law(&o->law) || (o->order <= 8 && o->terms <= 8), require_whole(o->order, 0, 100000),
       require_whole(o->terms, 0, 100000))
FUZZED(series, no_law(&o->law) || (o->order <= 6 && o->digits <= 40 && simple_law(&o->law)),
       require_whole(o->order, 0, 100000), require_whole(o->digits, 1, OPTIONS_MAX_DIGITS))
FUZZED(pade,
       no_law(&o->law) || (o->numerator + o->denominator <= 6 && o->digits <= 40 && !o->header && !o->two_point &&
                           simple_law(&o->law)),
       require_whole(o->numerator, OPTIONS_NOT_GIVEN, 2000), require_whole(o->denominator, OPTIONS_NOT_GIVEN, 2000),
       require_whole(o->digits, 1, OPTIONS_MAX_DIGITS), require_name(o->header))
FUZZED(collide,
       no_law(&o->law) || (o->digits <= 20 && short_number(&o->beta) && sphere(&o->law) && !o->stiffness.text &&
                           decimal_value(&o->beta) < 3),
       require_number(&o->beta), require_whole(o->digits, 1, OPTIONS_MAX_DIGITS))
FUZZED(disk_modes, o->count <= 6 && o->digits <= 40 && short_number(&o->poisson), require_number(&o->poisson),
       require_whole(o->count, 1, DISK_MODES_MAX), require_whole(o->digits, 1, OPTIONS_MAX_DIGITS))
FUZZED(tables,
       o->request.modes != 0 && o->request.modes <= 6 && o->request.poisson.text != NULL &&
           short_number(&o->request.poisson),
       require_number(&o->request.poisson))

/* Whether a list is short and its values are in a range, or the list is not given */
static bool few(const struct values *values, size_t most, double least, double largest)
{
    if (values->count == 0)
        return !values->text;
    REQUIRE(values->count >= 1 && values->count <= VALUES_MAX, "list '%s' has %zu values", values->text, values->count);
    return values->count <= most && values_least(values) >= least && values_largest(values) <= largest;
}

FUZZED(disk_collide,
       few(&o->request.sweep.speed, 4, 0.01, 0.5) && few(&o->request.sweep.poisson, 1, -0.95, 0.95) &&
           few(&o->request.sweep.alpha, 2, 0, 200) && few(&o->request.sweep.modes, 2, 1, 6) &&
           (!o->tolerance.text || decimal_value(&o->tolerance) >= 1e-6) && o->phi_points <= 100 && o->threads <= 3,
       require_number(&o->tolerance))

static void require_scene(const struct embed_request *scene)
{
    for (int i = 0; i < EMBED_NUMBERS; i++)
        require_number(&scene->number[i]);
    REQUIRE(!scene->name || (strlen(scene->name) <= OPTIONS_MAX_NAME && !isdigit((unsigned char)*scene->name)),
            "name '%s'", scene->name);
}

/* Whether the damping of a scene takes no collision */
static bool solves_nothing(const struct embed_request *scene)
{
    return !scene->number[COR_SCENE_RESTITUTION].text && !scene->number[COR_SCENE_ZETA].text;
}

FUZZED(embed, solves_nothing(&o->scene), require_scene(&o->scene))

/* Neither standard input nor gnuplot */
static int fuzz_fit(const void *arguments)
{
    const struct fit_arguments *const o = arguments;
    require_number(&o->gravity);
    for (int i = 0; i < EMBED_NUMBERS; i++)
        require_number(&o->scene.number[i]);
    require_name(o->data);
    return run_if(strcmp(o->data, "-") != 0 && !o->plot, &command_fit, &o->common);
}

/* plan goes on to where its modes or collisions begin, */
static bool planning;

static int fuzz_plan(const void *arguments)
{
    const struct plan_arguments *const o = arguments;
    require_scene(&o->scene);
    planning = true;
    const int status = run_if(solves_nothing(&o->scene), &command_plan, &o->common);
    planning = false;
    return status;
}

/* corgen's subcommands with the functions above in the place of theirs. */
static int corgen_main(int argc, char **argv)
{
    static const struct {
        const struct subcommand *command;
        int (*run)(const void *arguments);
    } row[] = {{&command_trajectory, fuzz_trajectory},
               {&command_series, fuzz_series},
               {&command_pade, fuzz_pade},
               {&command_collide, fuzz_collide},
               {&command_disk_modes, fuzz_disk_modes},
               {&command_disk_collide, fuzz_disk_collide},
               {&command_embed, fuzz_embed},
               {&command_fit, fuzz_fit},
               {&command_plan, fuzz_plan},
               {&command_tables, fuzz_tables}};
    enum { ROWS = sizeof row / sizeof *row };
    struct subcommand copy[ROWS];
    const struct subcommand *table[ROWS + 1] = {NULL};
    for (size_t i = 0; i < ROWS; i++) {
        copy[i] = *row[i].command;
        copy[i].run = row[i].run;
        table[i] = &copy[i];
    }
    return subcommand_run(table, "fuzzed", argc, argv);
}

int __real_disk_modes_rounded(struct cor_disk_modes *modes, const fmpq_t nu, slong count);
int __wrap_disk_modes_rounded(struct cor_disk_modes *modes, const fmpq_t nu, slong count);
int __wrap_disk_modes_rounded(struct cor_disk_modes *modes, const fmpq_t nu, slong count)
{
    return planning ? fail("the fuzzer finds no modes here") : __real_disk_modes_rounded(modes, nu, count);
}

/* A constant that takes a second is computed once. */
int __real_collision_h_star(arb_t h, slong bits);
int __wrap_collision_h_star(arb_t h, slong bits);
int __wrap_collision_h_star(arb_t h, slong bits)
{
    static arb_t known;
    static slong known_bits;
    if (known_bits == 0)
        arb_init(known);
    if (known_bits != bits && __real_collision_h_star(known, bits) != STATUS_OK)
        return STATUS_FAILED;
    known_bits = bits;
    arb_set(h, known);
    return STATUS_OK;
}

/* and embed goes on to where its do. */
struct interpolant *__wrap_interpolant_new(const struct interpolant_layout *layout, double beta_min, double beta_max);
struct interpolant *__wrap_interpolant_new(const struct interpolant_layout *layout, double beta_min, double beta_max)
{
    (void)layout;
    REQUIRE(beta_min > 0 && beta_min < beta_max && beta_max < 1e70, "beta from %a to %a", beta_min, beta_max);
    fail("the fuzzer makes no collisions here");
    return NULL;
}

/* No thread computes the series. */
void __wrap_embed_series_begin(struct embed_series *series, const struct law *law, enum contact_end end);
void __wrap_embed_series_begin(struct embed_series *series, const struct law *law, enum contact_end end)
{
    (void)law;
    (void)end;
    arb_poly_init(series->eps);
}

int __wrap_embed_series_end(struct embed_series *series);
int __wrap_embed_series_end(struct embed_series *series)
{
    (void)series;
    return fail("the fuzzer computes no series");
}

/* The number of files here; temporary ones must not be left. */
static int files_here(const char *directory, bool remove_them)
{
    DIR *const open = opendir(directory);
    REQUIRE(open, "no directory %s", directory);
    int files = 0;
    for (struct dirent *file; (file = readdir(open));) {
        if (strcmp(file->d_name, ".") == 0 || strcmp(file->d_name, "..") == 0 || strcmp(file->d_name, "inside") == 0)
            continue;
        REQUIRE(strncmp(file->d_name, ".corgen-", 8) != 0, "%s/%s was left", directory, file->d_name);
        files++;
        if (!remove_them)
            continue;
        char path[PATH_LENGTH];
        snprintf(path, sizeof path, "%s/%s", directory, file->d_name);
        if (unlink(path) != 0) {
            files_here(path, true);
            rmdir(path);
        }
    }
    closedir(open);
    return files;
}

static char home[] = "/tmp/cor-fuzz-XXXXXX";

static void leave(void)
{
    if (chdir(home) == 0) {
        rmdir("inside");
        rmdir(home);
    }
}

/* output.c sets handlers once, for good; libFuzzer then wants them back. */
int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    static const int number[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGABRT, SIGXCPU};
    struct output out;
    output_open(&out, NULL);
    parallel_use(1); /* a fuzzer has one processor */
    for (size_t i = 0; i < sizeof number / sizeof *number; i++)
        signal(number[i], SIG_DFL);
    REQUIRE(mkdtemp(home) && chdir(home) == 0 && mkdir("inside", 0700) == 0 && chdir("inside") == 0, "%s", home);
    atexit(leave);
    return 0;
}

/* The lines of the input; false for one that might write elsewhere. */
static bool split(char *text, int *argc, char **argv)
{
    static char program[] = "corgen";
    for (const char *slash = text; (slash = strchr(slash, '/')); slash++)
        if (slash == text || !isdigit((unsigned char)slash[-1]) || !isdigit((unsigned char)slash[1]))
            return false;
    *argc = 0;
    argv[(*argc)++] = program;
    for (char *at = text, *next; at && *argc < ARGUMENTS_MAX; at = next) {
        next = strchr(at, '\n');
        if (next)
            *next++ = '\0';
        if (*at || next)
            argv[(*argc)++] = at;
    }
    argv[*argc] = NULL;
    return true;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > SIZE_MAX_INPUT || memchr(data, '\0', size))
        return 0;
    char text[SIZE_MAX_INPUT + 1], *argv[ARGUMENTS_MAX + 1], *said = NULL, *told = NULL;
    memcpy(text, data, size);
    text[size] = '\0';
    int argc;
    if (!split(text, &argc, argv))
        return 0;

    /* glibc's getopt remembers where it was in an argument of the last run, of which a program has but one */
    char *nothing[] = {argv[0], NULL};
    optind = 0;
    (void)getopt(1, nothing, "");

    size_t said_size = 0, told_size = 0;
    FILE *const was_out = stdout, *const was_err = stderr;
    stdout = open_memstream(&said, &said_size);
    stderr = open_memstream(&told, &told_size);
    skipped = false;
    const int status = corgen_main(argc, argv);
    fclose(stdout);
    fclose(stderr);
    stdout = was_out;
    stderr = was_err;

    REQUIRE(status >= STATUS_OK && status <= STATUS_USAGE, "status %d", status);
    if (status != STATUS_OK)
        REQUIRE(told_size > 10 && strstr(told, "corgen: ") && told[told_size - 1] == '\n', "status %d, said '%s'",
                status, told);
    if (status == STATUS_USAGE)
        REQUIRE(said_size == 0, "status %d, printed '%s'", status, said);
    const int files = files_here(".", true), above = files_here("..", true);
    if (status == STATUS_USAGE)
        REQUIRE(files + above == 0, "status %d, %d files", status, files + above);
    if (status == STATUS_OK && !skipped)
        REQUIRE(said_size + (size_t)(files + above) > 0, "status %d, and nothing was written", status);
    free(said);
    free(told);
    return 0;
}
