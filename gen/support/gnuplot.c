/* SPDX-License-Identifier: MIT */
#include "support/gnuplot.h"

#include <errno.h>
#include <math.h>
#include <spawn.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/console.h"
#include "support/output.h"

#define CSS_PIXELS 96.0 /* in an inch */

extern char **environ; /* POSIX has no header that declares environ */

/* The variable `picture` of a script contains its format. */
static const char *const format[] = {"svg", "png", "pdf"};
enum { FORMATS = sizeof format / sizeof *format };

/* Returns the index of the path's format in the list, or FORMATS if it is not there. */
static int format_of(const char *path)
{
    const char *const dot = strrchr(file_name(path), '.');
    int i = 0;
    while (dot && i < FORMATS && strcasecmp(dot + 1, format[i]) != 0)
        i++;
    return i;
}

int gnuplot_check(const char *path)
{
    return format_of(path) < FORMATS ? STATUS_OK
                                     : usage_error("--plot: '%s' is not the name of a picture; allowed: names that end "
                                                   "in .svg, .png or .pdf; a name without an ending gives svg",
                                                   path);
}

static FILE *open_temporary(void)
{
    FILE *const file = tmpfile();
    if (!file)
        fail("cannot create a temporary file: %s", strerror(errno));
    return file;
}

FILE *gnuplot_begin(int width, int height)
{
    FILE *const script = open_temporary();
    if (!script)
        return NULL;
    fprintf(script,
            "if (picture eq 'svg') { set terminal svg size %d,%d fixed font 'DejaVu Sans,13' background 'white' }\n"
            "if (picture eq 'png') { set terminal pngcairo size %d,%d font 'DejaVu Sans,10' background 'white' }\n"
            "if (picture eq 'pdf') { set terminal pdfcairo size %g,%g font 'DejaVu Sans,10' background 'white' }\n"
            "black = '#222222'; grey = '#777777'; light = '#dddddd'; blue = '#0060ad'; red = '#c8421a'\n"
            "green = '#3a7d34'; violet = '#7b3f99'; amber = '#b8860b'\n"
            "set border 3 lc rgb black\nset tics nomirror\nset grid lc rgb light lw 0.7\n"
            "set key samplen 2.2 spacing 1.15 reverse Left\n",
            width, height, width, height, width / CSS_PIXELS, height / CSS_PIXELS);
    return script;
}

/* A string in single quotation marks would need no escapes, but gnuplot 5.4 rejects one with two apostrophes in a row,
 * as in x''. In double quotation marks gnuplot reads escapes, runs a command in backquotes and expands @. */
void gnuplot_quote(FILE *script, const char *text)
{
    char *const shown = xprintable(text);
    fputc('"', script);
    for (const char *at = shown; *at; at++)
        fprintf(script, strchr("\"\\`@", *at) ? "\\%03o" : "%c", (unsigned char)*at);
    fputc('"', script);
    free(shown);
}

/* Starts gnuplot with the script as standard input and `out` as standard output, and waits for its end. Returns its
 * exit status, or -1 with errno if it cannot be started. */
static int run_program(FILE *script, FILE *out, const char *picture)
{
    char variable[32], *const arguments[] = {"gnuplot", "-e", variable, "-", NULL};
    snprintf(variable, sizeof variable, "picture = '%s'", picture);
    posix_spawn_file_actions_t actions;
    pid_t child;
    if (fflush(script) != 0 || lseek(fileno(script), 0, SEEK_SET) != 0)
        return -1;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, fileno(script), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(out), STDOUT_FILENO);
    const int error = posix_spawnp(&child, arguments[0], &actions, NULL, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        errno = error;
        return -1;
    }
    int status;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/* True for lines that name the version of gnuplot, which would make pictures differ between machines. */
static bool names_version(const char *line)
{
    return strncmp(line, "<desc>", 6) == 0 || strstr(line, "Gnuplot") || strstr(line, "GNUPLOT");
}

static long copy_picture(FILE *from, FILE *to, bool svg)
{
    char *line = NULL;
    size_t size = 0;
    long lines = 0;
    for (ssize_t n; (n = getline(&line, &size, from)) >= 0;) {
        if (svg && names_version(line))
            continue;
        fwrite(line, 1, (size_t)n, to);
        lines++;
    }
    free(line);
    return lines;
}

int gnuplot_run(FILE *script, FILE *out, const char *path)
{
    FILE *const picture = open_temporary();
    if (!picture)
        return STATUS_FAILED;
    const int place = format_of(path);
    const int status = run_program(script, picture, format[place]);
    rewind(picture);
    const bool done = status == 0 && copy_picture(picture, out, place == 0) > 0;
    fclose(picture);
    fclose(script);
    if (done)
        return STATUS_OK;
    return status < 0 ? fail("cannot run gnuplot, which draws the picture: %s; install gnuplot or leave out --plot",
                             strerror(errno))
           : place == 0
               ? fail("gnuplot failed to draw the picture")
               : fail("gnuplot failed to draw the picture as %s; use a name that ends in .svg, which needs no library",
                      format[place]);
}

/* ---- eps as a function of the speed ---- */

enum { WIDTH = 720, HEIGHT = 470 };

static const char *const colour[] = {"blue", "red", "green", "violet", "amber", "grey"};
enum { COLOURS = sizeof colour / sizeof *colour };

int eps_plot(const char *path, const char *title, const char *label, double least, const struct eps_curve *curve,
             size_t curves)
{
    struct output out;
    const int status = output_open(&out, path);
    if (status != STATUS_OK)
        return status;
    FILE *const script = gnuplot_begin(WIDTH, HEIGHT);
    if (!script)
        return output_finish(&out, STATUS_FAILED);
    fputs("set key bottom left\nset xlabel ", script);
    gnuplot_quote(script, label);
    fprintf(script, "\nset ylabel 'coefficient of restitution ε'\n%s\nset logscale x\nset format x '%%g'\n",
            isnan(least) ? "set yrange [*:1]" : "set yrange [0:1]\nset ytics 0.2\nset mytics 2");
    double low = INFINITY, high = 0;
    for (size_t i = 0; i < curves; i++)
        for (size_t k = 0; k < curve[i].count; k++) {
            low = fmin(low, curve[i].speed[k]);
            high = fmax(high, curve[i].speed[k]);
        }
    if (low < high) /* the axis ends where the curves end */
        fprintf(script, "set xrange [%.17g:%.17g]\n", low, high);
    fputs("set title ", script);
    gnuplot_quote(script, title);
    fputs(" noenhanced\n", script);
    for (size_t i = 0; i < curves; i++) {
        fprintf(script, "$curve%zu << end_of_curve\n", i);
        for (size_t k = 0; k < curve[i].count; k++)
            if (!isnan(curve[i].eps[k]))
                fprintf(script, "%.17g %.17g\n", curve[i].speed[k], curve[i].eps[k]);
        fputs("end_of_curve\n", script);
    }
    for (size_t i = 0; i < curves; i++) {
        fprintf(script, "%s$curve%zu using 1:2 with lines lw 2.2 dt %zu lc rgb %s title ", i ? ", " : "plot ", i,
                i / COLOURS + 1, colour[i % COLOURS]);
        gnuplot_quote(script, curve[i].title);
    }
    fputs("\nset output\n", script);
    return output_finish(&out, gnuplot_run(script, out.file, path));
}
