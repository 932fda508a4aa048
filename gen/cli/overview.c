/* SPDX-License-Identifier: MIT */
#include "cli/options.h"

#include <string.h>

enum { MOST_ROWS = 5 };

struct overview_row {
    const char *name, *use; /* a subcommand, and its use for this task */
};

/* A task of a user, its subcommands, and one command that runs as shown */
struct overview_task {
    const char *title;
    struct overview_row row[MOST_ROWS]; /* ends with a NULL name */
    const char *example;                /* command of the first subcommand, without "corgen" */
};

static const struct overview_task tasks[] = {
    {"I have materials",
     {{"contact", "eps, durations, forces and a time step of one contact"},
      {"plan", "the cheapest model of eps for a tolerance and a range of speeds"}},
     "contact --young 7e10 --poisson 0.2 --radius 5e-3 --density 2500 --dissipation-time 1e-6 --speed 0.1,1,10"},
    {"I have a measurement",
     {{"contact", "A and g* from eps measured once: --restitution E --at SPEED"}},
     "contact --young 7e10 --poisson 0.2 --radius 5e-3 --density 2500 --restitution 0.9 --at 1"},
    {"I have a simulator",
     {{"contact", "with --for HOST, lines for its input; --for list names the simulators"},
      {"sample", "eps over speeds as a table; C, Python, Modelica, OpenFOAM"}},
     "contact --young 7e10 --poisson 0.2 --radius 5e-3 --density 2500 --law tsuji --restitution 0.7 --for yade"},
    {"I need a header",
     {{"embed", "one C function from speed to eps, for one scene"},
      {"law", "C functions of beta for any law of contact"},
      {"pade", "with --header, a rational function of beta"}},
     "embed --g-star 20 --speed-min 0.01 --speed-max 10 --tolerance 1e-6 --output cor_scene_eps.h"},
    {"I need more digits",
     {{"collide", "one collision to any number of proved digits"},
      {"series", "coefficients of eps in powers of beta, to any order"},
      {"trajectory", "exact rational coefficients of the motion"},
      {"pade", "Pade approximants of eps"}},
     "collide --beta 0.1 --digits 30"},
    {"I simulate disks",
     {{"disk-collide", "collisions with a wall, over lists of parameters"},
      {"disk-modes", "the free modes of a disk"},
      {"plan", "with --disks, the cheapest model for a tolerance"},
      {"tables", "with --poisson NU, the modes of a material as a C header and a file"}},
     "disk-collide --hard-wall --speed 0.05 --poisson 0.3 --tolerance 1e-3"},
    {"I develop cor", {{"tables", "write or check generated/"}}, "tables --check"},
};
enum { TASKS = sizeof tasks / sizeof *tasks };

static const char *const terms[][2] = {
    {"speed", "impact speed g, at which the bodies approach each other along the line of their centres, m/s"},
    {"eps", "coefficient of restitution: rebound speed over impact speed, from 0 to 1"},
    {"overlap", "length x by which two bodies are compressed, m; elastic spheres have the force K x^(3/2)"},
    {"zero overlap", "one end of contact: the bodies part when the overlap is zero again"},
    {"zero force", "the other end: the bodies part when the force would become attractive; eps is a little larger"},
    {"A", "dissipation time of viscoelastic materials, s: the force is K (x^(3/2) + (3/2) A sqrt(x) x')"},
    {"g*", "characteristic speed, m/s: eps = 1 - (g/g*)^(1/5) + ... for viscoelastic spheres"},
    {"beta", "dimensionless damping, the only number on which eps depends; beta = 0.867 (g/g*)^(1/5)"},
    {"zeta", "damping ratio of the laws linear and tsuji, whose eps is the same at every speed"},
    {"law", "exponents a and b of the force K x^a + C x^b x', or a name for them"},
    {"host", "a simulator whose contact model corgen supports"},
    {"disk", "elastic disk without damping: a collision turns energy into vibrations, its modes"},
};
enum { TERMS = sizeof terms / sizeof *terms };

static bool in_table(const struct subcommand *const *table, const char *name)
{
    while (*table && strcmp((*table)->name, name) != 0)
        table++;
    return *table;
}

void overview_print(const struct subcommand *const *table, FILE *file)
{
    fputs("corgen computes collisions for simulations: the coefficient of restitution eps, durations and forces in SI\n"
          "units, and series, tables and C headers with proved digits.\n\n"
          "Usage: corgen SUBCOMMAND [OPTION]...\n",
          file);
    for (const struct overview_task *task = tasks; task < tasks + TASKS; task++) {
        const char *title = task->title;
        for (const struct overview_row *row = task->row; row < task->row + MOST_ROWS && row->name; row++) {
            if (!in_table(table, row->name))
                continue;
            if (title)
                fprintf(file, "\n%s:\n", title);
            title = NULL;
            fprintf(file, "  %-14s %s\n", row->name, row->use);
        }
        if (in_table(table, task->row[0].name))
            fprintf(file, "  $ corgen %s\n", task->example);
    }
    fputs("\nTerms:\n", file);
    for (size_t i = 0; i < TERMS; i++)
        fprintf(file, "  %-14s %s\n", terms[i][0], terms[i][1]);
    fputs("\n"
          "Options:\n"
          "  --help               print this text; corgen SUBCOMMAND --help prints the options of a subcommand\n"
          "  --version            print the versions of corgen and its libraries\n"
          "  --completion SHELL   print the completion of corgen for bash or zsh\n\n"
          "Exit status: 0 success, 1 failure, 2 wrong command line.\n",
          file);
}
