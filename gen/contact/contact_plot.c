/* SPDX-License-Identifier: MIT */
#include "contact/contact_plot.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/console.h"
#include "support/output.h"

enum { NOT_FOUND = 127 };

/* The look of docs/style.gp */
static const char style[] = "set terminal svg size 720,470 fixed font 'DejaVu Sans,13' background 'white'\n"
                            "set border 3 lc rgb '#222222'\nset tics nomirror\nset grid lc rgb '#dddddd' lw 0.7\n"
                            "set key bottom left samplen 2.2 spacing 1.15 reverse Left\n"
                            "set xlabel 'impact speed (m/s)'\nset ylabel 'coefficient of restitution ε'\n"
                            "set yrange [0:1]\nset ytics 0.2\nset mytics 2\nset logscale x\nset format x '%g'\n";
static const char *const colour[] = {"#0060ad", "#c8421a", "#3a7d34", "#7b3f99"};
enum { COLOURS = sizeof colour / sizeof *colour };

static void write_script(FILE *file, const char *title, const struct contact_curve *curve, size_t curves)
{
    fputs(style, file);
    fprintf(file, "set title \"%s\" noenhanced\n", title);
    for (size_t i = 0; i < curves; i++) {
        fprintf(file, "$curve%zu << end_of_curve\n", i);
        for (size_t k = 0; k < curve[i].count; k++)
            if (!isnan(curve[i].eps[k]))
                fprintf(file, "%.17g %.17g\n", curve[i].speed_m_s[k], curve[i].eps[k]);
        fputs("end_of_curve\n", file);
    }
    for (size_t i = 0; i < curves; i++)
        fprintf(file, "%s$curve%zu using 1:2 with %s lw 2.2 lc rgb '%s' title '%s'", i ? ", " : "plot ", i,
                curve[i].count > 1 ? "lines" : "points pt 7", colour[i % COLOURS], curve[i].title);
    fputs("\n", file);
}

/* Starts gnuplot; it reads the script and writes to a pipe, whose reading end is the result, or NULL. */
static FILE *gnuplot_start(FILE *script, pid_t *child)
{
    int ends[2];
    if (pipe(ends) != 0)
        return NULL;
    *child = fork();
    if (*child == 0) {
        dup2(fileno(script), STDIN_FILENO);
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        execlp("gnuplot", "gnuplot", "-", (char *)NULL);
        _exit(NOT_FOUND);
    }
    close(ends[1]);
    if (*child > 0)
        return fdopen(ends[0], "r");
    close(ends[0]);
    return NULL;
}

/* Copies the picture without the lines that name the version of gnuplot. */
static void copy_picture(FILE *to, FILE *from)
{
    char *line = NULL;
    size_t size = 0;
    while (getline(&line, &size, from) > 0)
        if (strncmp(line, "<desc>", 6) != 0 && !strstr(line, "Gnuplot") && !strstr(line, "GNUPLOT"))
            fputs(line, to);
    free(line);
}

static int gnuplot_run(FILE *picture, FILE *script)
{
    pid_t child;
    int result;
    FILE *const from = gnuplot_start(script, &child);
    if (!from)
        return fail("cannot start gnuplot: %s", strerror(errno));
    copy_picture(picture, from);
    fclose(from);
    while (waitpid(child, &result, 0) < 0)
        if (errno != EINTR)
            return fail("cannot wait for gnuplot: %s", strerror(errno));
    if (WIFEXITED(result) && WEXITSTATUS(result) == NOT_FOUND)
        return fail("--plot needs gnuplot, which is not installed (Debian: gnuplot-nox)");
    return result == 0 ? STATUS_OK : fail("gnuplot failed; no picture is written");
}

int contact_plot(const char *path, const char *title, const struct contact_curve *curve, size_t curves)
{
    struct output out;
    FILE *const script = tmpfile();
    if (!script)
        return fail("cannot make a temporary file: %s", strerror(errno));
    write_script(script, title, curve, curves);
    int status = fflush(script) == 0 && fseek(script, 0, SEEK_SET) == 0
                     ? STATUS_OK
                     : fail("cannot write a temporary file: %s", strerror(errno));
    if (status == STATUS_OK)
        status = output_open(&out, path);
    if (status == STATUS_OK) {
        status = gnuplot_run(out.file, script);
        if (status == STATUS_OK)
            status = output_commit(&out);
        else
            output_discard(&out);
    }
    fclose(script);
    return status;
}
