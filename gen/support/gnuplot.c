/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "support/gnuplot.h"

#include <errno.h>
#include <spawn.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/console.h"

extern char **environ; /* POSIX has it in no header */

void gnuplot_style(FILE *script, int width, int height)
{
    fprintf(script,
            "set terminal svg size %d,%d fixed font 'DejaVu Sans,13' background 'white'\n"
            "black = '#222222'; grey = '#777777'; light = '#dddddd'; blue = '#0060ad'; red = '#c8421a'\n"
            "green = '#3a7d34'; violet = '#7b3f99'; amber = '#b8860b'\n"
            "set border 3 lc rgb black\nset tics nomirror\nset grid lc rgb light lw 0.7\n"
            "set key samplen 2.2 spacing 1.15 reverse Left\n",
            width, height);
}

/* A string in single quotation marks would need no escapes, but gnuplot 5.4 rejects one with two apostrophes in a row,
 * as in x''. In double quotation marks gnuplot reads escapes, runs a command in backquotes and expands @. */
void gnuplot_quote(FILE *script, const char *text)
{
    fputc('"', script);
    for (; *text; text++) {
        if (strchr("\"\\`@", *text))
            fprintf(script, "\\%03o", (unsigned)*text);
        else if ((unsigned char)*text >= ' ')
            fputc(*text, script);
    }
    fputc('"', script);
}

/* Starts gnuplot with the script as standard input and `out` as standard output, and waits for its end. Returns its
 * exit status, or -1 with errno if it cannot be started. */
static int run_program(FILE *script, FILE *out)
{
    char *const arguments[] = {"gnuplot", "-", NULL};
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

/* The lines that name the version of gnuplot, which would make pictures differ from machine to machine */
static bool names_version(const char *line)
{
    return strncmp(line, "<desc>", 6) == 0 || strstr(line, "Gnuplot") || strstr(line, "GNUPLOT");
}

static long copy_picture(FILE *from, FILE *to)
{
    char *line = NULL;
    size_t size = 0;
    long lines = 0;
    for (ssize_t n; (n = getline(&line, &size, from)) >= 0;) {
        if (names_version(line))
            continue;
        fwrite(line, 1, (size_t)n, to);
        lines++;
    }
    free(line);
    return lines;
}

int gnuplot_run(FILE *script, FILE *svg)
{
    FILE *const picture = tmpfile();
    if (!picture)
        return fail("cannot make a temporary file: %s", strerror(errno));
    const int status = run_program(script, picture);
    rewind(picture);
    const bool done = status == 0 && copy_picture(picture, svg) > 0;
    fclose(picture);
    if (done)
        return STATUS_OK;
    return status < 0 ? fail("cannot run gnuplot, which draws the picture: %s", strerror(errno))
                      : fail("gnuplot failed to draw the picture");
}
