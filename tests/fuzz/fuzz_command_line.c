/* SPDX-License-Identifier: MIT */
/* The whole of corgen, from its command line to its output: the input's lines are the arguments. Subcommands run where
 * they are cheap; the linker puts the functions below before theirs, which look at what the parser let through.
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
#include "cli/options.h"
#include "disk/modes_rounded.h"
#include "embed/choose.h"
#include "fuzz.h"
#include "support/console.h"
#include "sweep/sweep.h"
#include "sweep/values.h"

int LLVMFuzzerInitialize(int *argc, char ***argv);
int corgen_main(int argc, char **argv);

enum { ARGUMENTS_MAX = 24, SIZE_MAX_INPUT = 600, PATH_LENGTH = 4096 };

/* Whether the subcommand was too large to be run */
static bool skipped;

static void require_whole(slong value, slong low, slong high)
{
    REQUIRE(value >= low && value <= high, "%ld", (long)value);
}

static void require_number(const char *text)
{
    if (!text)
        return;
    char *end;
    strtod(text, &end);
    REQUIRE(*text && (*end == '\0' || *end == '/'), "number '%s'", text);
}

/* What holds of any options that the parser lets through */
static void check_options(const struct options *o)
{
    require_whole(o->order, 0, OPTIONS_MAX_ORDER);
    require_whole(o->terms, 0, OPTIONS_MAX_TERMS);
    require_whole(o->digits, 1, OPTIONS_MAX_DIGITS);
    if (o->count != OPTIONS_NOT_GIVEN)
        require_whole(o->count, 1, OPTIONS_MAX_COUNT);
    if (o->numerator != OPTIONS_NOT_GIVEN)
        require_whole(o->numerator, 0, OPTIONS_MAX_DEGREE);
    if (o->denominator != OPTIONS_NOT_GIVEN)
        require_whole(o->denominator, 0, OPTIONS_MAX_DEGREE);
    require_number(o->beta);
    for (int i = 0; i < OPTIONS_REALS; i++)
        require_number(o->real[i]);
    REQUIRE(!o->output || *o->output, "an empty name");
    REQUIRE(!o->header || *o->header, "an empty name");
    REQUIRE(!o->name || (strlen(o->name) <= OPTIONS_MAX_NAME && !isdigit((unsigned char)*o->name)), "name '%s'",
            o->name);
}

static int run_if(bool cheap, int (*command)(const struct options *), const struct options *o)
{
    check_options(o);
    skipped = !cheap;
    return cheap ? command(o) : STATUS_OK;
}

static bool short_number(const char *text)
{
    return !text || (strlen(text) <= 12 && !strpbrk(text, "eE"));
}

static bool simple_law(const struct options *o)
{
    return o->law.a.num <= 9 && o->law.a.den <= 4 && o->law.b.num <= 9 && o->law.b.den <= 4;
}

#define COMMAND(name, cheap)                                                                                           \
    int __real_command_##name(const struct options *o);                                                                \
    int __wrap_command_##name(const struct options *o);                                                                \
    int __wrap_command_##name(const struct options *o)                                                                 \
    {                                                                                                                  \
        return run_if(cheap, __real_command_##name, o);                                                                \
    }

COMMAND(trajectory, o->order <= 8 && o->terms <= 8)
COMMAND(series, o->order <= 6 && o->digits <= 40 && simple_law(o))
COMMAND(pade, o->numerator + o->denominator <= 6 && o->digits <= 40 && !o->header && !o->two_point && simple_law(o))
COMMAND(collide, o->digits <= 20 && short_number(o->beta) && law_is_sphere(&o->law) && strtod(o->beta, NULL) < 3)
COMMAND(disk_modes, o->count <= 6 && o->digits <= 40 && short_number(o->real[OPTIONS_POISSON]))
COMMAND(embed, true)
COMMAND(tables, o->real[OPTIONS_POISSON] && short_number(o->real[OPTIONS_POISSON]) && o->count != OPTIONS_NOT_GIVEN &&
                    o->count <= 6)

static bool few(const char *text, const struct values_rule *rule, size_t most, double least, double largest)
{
    struct values values;
    REQUIRE(values_parse(&values, rule, text) == STATUS_OK, "list '%s' was good and is bad", text);
    REQUIRE(values.count >= 1 && values.count <= VALUES_MAX, "list '%s' has %zu values", text, values.count);
    const bool is = values.count <= most && values_least(&values) >= least && values_largest(&values) <= largest;
    values_clear(&values);
    return is;
}

static bool small_sweep(const struct options *o)
{
    return few(o->list[OPTIONS_LIST_SPEED], &sweep_speed, 4, 0.01, 0.5) &&
           few(o->list[OPTIONS_LIST_POISSON], &sweep_poisson, 1, -0.95, 0.95) &&
           few(o->list[OPTIONS_LIST_ALPHA], &sweep_alpha, 2, 0, 200) &&
           few(o->list[OPTIONS_LIST_MODES], &sweep_modes, 2, 1, 6) && o->collision_tolerance >= 1e-6 &&
           o->phi_points <= 100 && o->threads <= 3;
}

COMMAND(disk_collide, small_sweep(o))

/* plan goes on to where its modes or collisions begin, */
static bool planning;

int __real_command_plan(const struct options *o);
int __wrap_command_plan(const struct options *o);
int __wrap_command_plan(const struct options *o)
{
    planning = true;
    const int status = run_if(true, __real_command_plan, o);
    planning = false;
    return status;
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
struct interpolant *__wrap_interpolant_new(double beta_min, double beta_max);
struct interpolant *__wrap_interpolant_new(double beta_min, double beta_max)
{
    REQUIRE(beta_min > 0 && beta_min < beta_max && beta_max < 1e70, "beta from %a to %a", beta_min, beta_max);
    fail("the fuzzer makes no collisions here");
    return NULL;
}

int __wrap_embed_search(struct embed_form form[FAMILIES], const struct embed_scene *s);
int __wrap_embed_search(struct embed_form form[FAMILIES], const struct embed_scene *s)
{
    (void)form;
    REQUIRE(s->speed_min < s->speed_max, "%a to %a", s->speed_min, s->speed_max);
    return fail("the fuzzer makes no form");
}

void __wrap_disk_modes_use_all_processors(void);
void __wrap_disk_modes_use_all_processors(void)
{
    /* one core is what a fuzzer has */
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
    for (size_t i = 0; i < sizeof number / sizeof *number; i++)
        signal(number[i], SIG_DFL);
    REQUIRE(mkdtemp(home) && chdir(home) == 0 && mkdir("inside", 0700) == 0 && chdir("inside") == 0, "%s", home);
    atexit(leave);
    return 0;
}

/* The lines of the input; false for one that might write elsewhere. */
static bool split(char *text, int *argc, char **argv)
{
    for (const char *slash = text; (slash = strchr(slash, '/')); slash++)
        if (slash == text || !isdigit((unsigned char)slash[-1]) || !isdigit((unsigned char)slash[1]))
            return false;
    *argc = 0;
    argv[(*argc)++] = (char[]){"corgen"};
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
    getopt(1, nothing, "");

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
