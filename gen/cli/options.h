/* SPDX-License-Identifier: MIT */
/* Command-line options shared by the subcommands; every one is parsed and range-checked here. */
#ifndef COR_GEN_CLI_OPTIONS_H
#define COR_GEN_CLI_OPTIONS_H

#include "series/law.h"
#include "series/series.h"
#include "support/output.h"

#define OPTIONS_MAX_ORDER 100000
#define OPTIONS_MAX_TERMS 100000
#define OPTIONS_MAX_DIGITS 10000000
#define OPTIONS_MAX_DEGREE 2000
#define OPTIONS_MAX_COUNT 10000000
#define OPTIONS_MAX_SEED 1000000000
#define OPTIONS_MAX_NAME 63
#define OPTIONS_MAX_POINTS 1000
#define OPTIONS_MAX_BETA "1e6"
#define OPTIONS_DEFAULT_DIGITS 20
#define OPTIONS_DEFAULT_COLLISION_TOLERANCE "1e-8"
#define OPTIONS_NOT_GIVEN (-1)

/* Numbers with a unit, as corgen embed takes them: speeds in m/s, the rest in SI units; those of body 2 at a fixed
 * distance behind those of body 1. */
enum options_real {
    OPTIONS_SPEED_MIN,
    OPTIONS_SPEED_MAX,
    OPTIONS_TOLERANCE,
    OPTIONS_G_STAR,
    OPTIONS_YOUNG,
    OPTIONS_POISSON,
    OPTIONS_RADIUS,
    OPTIONS_DENSITY,
    OPTIONS_MASS,
    OPTIONS_DISSIPATION_TIME,
    OPTIONS_YOUNG_2,
    OPTIONS_POISSON_2,
    OPTIONS_RADIUS_2,
    OPTIONS_DENSITY_2,
    OPTIONS_MASS_2,
    OPTIONS_DISSIPATION_TIME_2,
    OPTIONS_REALS
};

/* Lists, as corgen disk-collide takes them; gen/sweep/values.h. */
enum options_list { OPTIONS_LIST_SPEED, OPTIONS_LIST_POISSON, OPTIONS_LIST_ALPHA, OPTIONS_LIST_MODES, OPTIONS_LISTS };

enum options_use { OPTIONS_BALANCED, OPTIONS_SCALAR, OPTIONS_ARRAY };

/* What corgen plan --disks is asked for. */
enum options_quantity { OPTIONS_EPS, OPTIONS_CONTACT_TIME, OPTIONS_COMPRESSION };

struct options {
    slong order, terms, digits, count;
    slong numerator, denominator; /* OPTIONS_NOT_GIVEN if so */
    const char *beta;             /* text as given, already found good; options_beta makes the ball */
    enum contact_end end;
    enum output_format format;
    struct law law;
    const char *output;              /* file, or directory for `tables`; NULL = standard output */
    const char *header;              /* pade: write a C header here */
    const char *real[OPTIONS_REALS]; /* texts as given, found good; NULL if not given */
    const char *name;                /* embed: of the function */
    const char *list[OPTIONS_LISTS]; /* disk-collide: likewise */
    double collision_tolerance;
    slong phi_points, threads; /* 0 if not given */
    slong seed;                /* OPTIONS_NOT_GIVEN if so */
    enum options_use use;
    enum options_quantity quantity;
    slong points; /* plan: 0 if not given */
    bool disks;
    bool single, wall;
    bool exact, two_point, as_published, check, all, force, profile;
};

/* A subcommand of the one table in main.c. */
struct subcommand {
    const char *name;
    const char *summary;
    const char *help;      /* full text of --help: usage, options, output columns, example */
    const char *accepts;   /* option names it takes, space separated: "order digits end format ..." */
    const char *formats;   /* of --format, likewise; the first is the default */
    const char *requires_; /* options it cannot do without, likewise */
    int (*run)(const struct options *);
};

/* argv[0] is the subcommand's name. STATUS_OK, or STATUS_USAGE after a sentence on stderr. */
int options_parse(struct options *o, const struct subcommand *cmd, int argc, char **argv, bool *help);

/* The number that --beta named: exact if binary can hold it, else the ball around it. */
void options_beta(arb_t beta, const struct options *o, slong prec);

/* A number of SI units, likewise; it was given. */
void options_real(arb_t x, const struct options *o, enum options_real which, slong prec);
const char *options_real_name(enum options_real which); /* speed-min, ... */

/* Whether it is a number without sign: 0.1, 1.5e-3 or 2/3. */
bool options_number_is_good(const char *text);

/* The number that a good text names, exactly: "-0.33", "2e-1" or "1/3". */
void options_fraction(fmpq_t x, const char *text);

int command_trajectory(const struct options *);
int command_series(const struct options *);
int command_pade(const struct options *);
int command_collide(const struct options *);
int command_disk_modes(const struct options *);
int command_disk_collide(const struct options *);
int command_embed(const struct options *);
int command_plan(const struct options *);
int command_tables(const struct options *);

#endif
