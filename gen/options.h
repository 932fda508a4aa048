/* SPDX-License-Identifier: MIT */
/* Command-line options shared by the subcommands; every one is parsed and range-checked here. */
#ifndef COR_GEN_OPTIONS_H
#define COR_GEN_OPTIONS_H

#include "law.h"
#include "output.h"
#include "series.h"

#define OPTIONS_MAX_ORDER 100000
#define OPTIONS_MAX_TERMS 100000
#define OPTIONS_MAX_DIGITS 10000000
#define OPTIONS_MAX_DEGREE 2000
#define OPTIONS_MAX_BETA "1e6"
#define OPTIONS_DEFAULT_DIGITS 20
#define OPTIONS_NOT_GIVEN (-1)

struct options {
    slong order, terms, digits;
    slong numerator, denominator; /* OPTIONS_NOT_GIVEN if so */
    const char *beta;             /* text as given, already found good; options_beta makes the ball */
    enum contact_end end;
    enum output_format format;
    struct law law;
    const char *output; /* file, or directory for `tables`; NULL = standard output */
    const char *header; /* pade: write a C header here */
    bool exact, two_point, as_published, check, force, profile;
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

int command_trajectory(const struct options *);
int command_series(const struct options *);
int command_pade(const struct options *);
int command_collide(const struct options *);
int command_tables(const struct options *);

#endif
