/* SPDX-License-Identifier: MIT */
/* Runs corgen from its command line to its output. The lines of the input are the arguments. A function below replaces
 * each subcommand. It first checks the parsed arguments by the rules of the options, and continues if the subcommand is
 * cheap.
 *
 * The program runs in its own directory, two levels deep. Arguments contain slashes only between digits, so nothing
 * outside can be written. stdout and stderr are streams in memory during a run; messages of the sanitizers and of
 * libFuzzer use the descriptors as usual. */
#define _XOPEN_SOURCE 700 /* mkdtemp, open_memstream */
#include <ctype.h>
#include <dirent.h>
#include <getopt.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include "approximation/interpolant.h"
#include "cli/commands.h"
#include "disk/modes.h"
#include "embed/form.h"
#include "fuzz.h"
#include "support/console.h"
#include "support/parallel.h"
#include "sweep/sweep.h"
#include "sweep/values.h"

int LLVMFuzzerInitialize(int *argc, char ***argv);

enum { ARGUMENTS_MAX = 24, SIZE_MAX_INPUT = 600, PATH_LENGTH = 4096 };

/* skipped: the run was too large. planning: the subcommand is plan */
static bool skipped, planning;

/* Requires that the value of an option is in its range, or is its default. */
static void require_option(const char *field, const char *by_default, const struct option_rule *rule)
{
    const bool is_long = rule->kind == OPTION_WHOLE, is_int = rule->kind == OPTION_WORD;
    const slong whole = is_long ? *(const slong *)(const void *)field : is_int ? *(const int *)(const void *)field : 0;
    const struct decimal *const number = (const void *)field;
    const struct values *const list = (const void *)field;
    const char *const *const text = (const void *)field;
    char *end;
    slong words = 0;
    if ((is_long || is_int) && memcmp(field, by_default, is_long ? sizeof(slong) : sizeof(int)) == 0)
        return;
    switch (rule->kind) {
    case OPTION_WHOLE:
        REQUIRE(whole >= rule->range.whole.low && whole <= rule->range.whole.high, "--%s %ld", rule->name, (long)whole);
        break;
    case OPTION_WORD:
        while (rule->range.words[words] != NULL)
            words++;
        REQUIRE(whole >= 0 && whole < words, "--%s %ld", rule->name, (long)whole);
        break;
    case OPTION_REAL:
        if (number->text != NULL) {
            strtod(number->text, &end);
            REQUIRE(*number->text && (*end == '\0' || *end == '/'), "--%s '%s'", rule->name, number->text);
        }
        break;
    case OPTION_LIST:
        REQUIRE(!list->text || (list->count >= 1 && list->count <= VALUES_MAX), "--%s '%s'", rule->name, list->text);
        break;
    case OPTION_C_NAME:
        REQUIRE(!*text || (strlen(*text) <= OPTIONS_MAX_NAME && !isdigit((unsigned char)**text)), "name '%s'", *text);
        break;
    case OPTION_TEXT:
    case OPTION_FILE:
    case OPTION_FOLDER:
        REQUIRE(!*text || **text, "--%s, an empty text", rule->name);
        break;
    default:
        break;
    }
}

static int run_if(bool cheap, const struct subcommand *command, const void *arguments)
{
    for (const struct option_rule *rule = command->options; rule->name != NULL; rule++)
        require_option((const char *)arguments + rule->offset, (const char *)command->defaults + rule->offset, rule);
    skipped = !cheap;
    planning = command == &command_plan;
    return cheap ? command->run(arguments) : STATUS_OK;
}

static bool short_number(const struct decimal *number)
{
    return !number->text || (strlen(number->text) <= 12 && !strpbrk(number->text, "eE"));
}

static bool simple_law(const struct cor_exponents *law)
{
    return law_elastic(law).num <= 9 && law_elastic(law).den <= 4 && law_damping(law).num <= 9 &&
           law_damping(law).den <= 4;
}

/* True if a list is short and its values are in a range, or if the list is absent. */
static bool few(const struct values *values, size_t most, double least, double largest)
{
    return values->count == 0 ? !values->text
                              : values->count <= most && values->least >= least && values->largest <= largest;
}

/* True if no collision is necessary to find the damping of a scene. */
static bool solves_nothing(const struct embed_request *scene)
{
    return !scene->number[COR_SCENE_RESTITUTION].text && !scene->number[COR_SCENE_ZETA].text;
}

/* Defines the replacement of a subcommand. cheap: a condition on the arguments; the subcommand runs only if it holds */
#define FUZZED(name, cheap)                                                                                            \
    static int fuzz_##name(const void *arguments)                                                                      \
    {                                                                                                                  \
        const struct name##_arguments *const o = arguments;                                                            \
        return run_if(cheap, &command_##name, arguments);                                                              \
    }

FUZZED(trajectory, o->order <= 8 && o->terms <= 8)
FUZZED(series, o->order <= 6 && o->digits <= 40 && simple_law(&o->law.exponents))
FUZZED(pade, o->request.numerator + o->request.denominator <= 6 && o->digits <= 40 && !o->header && !o->two_point &&
                 simple_law(&o->law.exponents))
FUZZED(collide, o->digits <= 20 && short_number(&o->beta) && law_is_sphere(&o->law.exponents) && !o->stiffness.text &&
                    decimal_value(&o->beta) < 3)
FUZZED(disk_modes, o->count <= 6 && o->digits <= 40 && short_number(&o->poisson))
FUZZED(tables, o->request.modes != 0 && o->request.modes <= 6 && o->request.poisson.text != NULL &&
                   short_number(&o->request.poisson))
FUZZED(disk_collide, few(&o->request.sweep.speed, 4, 0.01, 0.5) && few(&o->request.sweep.poisson, 1, -0.95, 0.95) &&
                         few(&o->request.sweep.alpha, 2, 0, 200) && few(&o->request.sweep.modes, 2, 1, 6) &&
                         (!o->tolerance.text || decimal_value(&o->tolerance) >= 1e-6) &&
                         o->request.sweep.phi_points <= 100 && o->request.threads <= 3)
FUZZED(embed, solves_nothing(&o->scene))
FUZZED(plan, solves_nothing(&o->scene))

/* Runs corgen's subcommands with the functions above in place of their own. */
static int corgen_main(int argc, char **argv)
{
    static const struct {
        const struct subcommand *command;
        int (*run)(const void *arguments);
    } row[] = {
#define ROW(name) {&command_##name, fuzz_##name}
        ROW(trajectory),   ROW(series), ROW(pade), ROW(collide), ROW(disk_modes),
        ROW(disk_collide), ROW(embed),  ROW(plan), ROW(tables)};
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

/* Functions that replace others (CMakeLists.txt, LINKER:--wrap) */
#define WRAPPED(type, name, ...)                                                                                       \
    type __real_##name(__VA_ARGS__);                                                                                   \
    type __wrap_##name(__VA_ARGS__);                                                                                   \
    type __wrap_##name(__VA_ARGS__)

WRAPPED(int, disk_modes_rounded, struct cor_disk_modes *modes, const fmpq_t nu, slong count)
{
    return planning ? fail("the fuzzer finds no modes here") : __real_disk_modes_rounded(modes, nu, count);
}

/* Makes the subcommands embed and plan fail where they would compute collisions. */
WRAPPED(struct interpolant *, interpolant_new, const struct interpolant_layout *layout, double beta_min,
        double beta_max)
{
    (void)layout;
    REQUIRE(beta_min > 0 && beta_min < beta_max && beta_max < 1e70, "beta from %a to %a", beta_min, beta_max);
    fail("the fuzzer makes no collisions here");
    return NULL;
}

WRAPPED(int, collision_h_star, arb_t h, slong bits)
{
    (void)h;
    (void)bits;
    return fail("the fuzzer computes no h* here");
}

WRAPPED(int, series_eps, arb_poly_t eps, slong *root, enum cor_end end, slong order, const struct cor_exponents *law,
        slong bits)
{
    return order < EMBED_SERIES ? __real_series_eps(eps, root, end, order, law, bits) : fail("no long series here");
}

/* Returns the number of files here; temporary ones must not remain. */
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

/* output.c installs its signal handlers once and permanently; afterwards libFuzzer's handlers must be restored. */
int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    static const int number[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGABRT, SIGXCPU};
    struct output out;
    output_open(&out, NULL);
    parallel_use(1); /* one thread */
    for (size_t i = 0; i < sizeof number / sizeof *number; i++)
        signal(number[i], SIG_DFL);
    REQUIRE(mkdtemp(home) && chdir(home) == 0 && mkdir("inside", 0700) == 0 && chdir("inside") == 0, "%s", home);
    atexit(leave);
    return 0;
}

/* Splits the input into lines. Returns false for a line that might write elsewhere. */
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

    /* getopt of glibc continues within an argument of the previous run, unless it is reset */
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
