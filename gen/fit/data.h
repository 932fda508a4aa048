/* SPDX-License-Identifier: MIT */
/* Measured restitution as a csv file: points (speed, eps, and perhaps the standard deviation of eps), or the times at
 * which a ball bounces. */
#ifndef COR_GEN_FIT_DATA_H
#define COR_GEN_FIT_DATA_H

#include <stdbool.h>
#include <stdio.h>

/* Unit of the speeds. FIT_UNIT_OF_COLUMN: the name of the column, speed_m_s or speed_cm_s, says which. */
enum fit_unit { FIT_M_S, FIT_CM_S, FIT_MM_S, FIT_UNIT_OF_COLUMN };
extern const char *const fit_unit_names[]; /* "m/s", "cm/s", "mm/s", NULL */

#define FIT_GRAVITY_M_S2 9.80665 /* standard gravity */

enum { FIT_MAX_POINTS = 1000000, FIT_MIN_POINTS = 2 };

/* A point may lie beyond 0 or 1 by so many eps_sigma; a flight may be longer than the one before by noise, eps up to
 * FIT_MAX_FLIGHT_RATIO. */
#define FIT_MAX_BEYOND 5
#define FIT_MAX_FLIGHT_RATIO 1.2

/* The bounce between two flights of a ball, which three times determine: t_k, t_(k+1), t_(k+2) */
struct fit_bounce {
    size_t point;    /* its index in fit_data */
    double flight_s; /* T_k = t_(k+1) - t_k */
    bool begins;     /* the first of a drop; every other one shares two times with the one before it */
    long line[3];    /* of the times */
};

struct fit_point {
    double speed_m_s;
    double eps;   /* 0 to 1, or beyond by noise */
    double sigma; /* standard deviation of eps, if has_sigma */
    long line;    /* of a bounce that of its second time; 0: not known */
    size_t row;   /* its place in the file, from 0 on */
};

struct fit_data {
    size_t points;
    struct fit_point *point; /* by ascending speed */
    bool has_sigma;
    struct fit_bounce *bounce; /* as many as points, in the order of the file; NULL: the points are no bounces */
    char *unused;              /* the names of the columns that are not read, "a, b", or NULL */
};

struct fit_form {
    enum fit_unit unit;
    double gravity_m_s2;
    char separator; /* of cells; 0: the one of comma, semicolon and tab that the first row has most of */
    bool decimal_comma;
};
#define FIT_FORM_DEFAULT ((struct fit_form){FIT_UNIT_OF_COLUMN, FIT_GRAVITY_M_S2, 0, false})

/* Reads the file, or standard input if the path is "-", as docs/fit.md has it. Flight k of a ball lasts T_k = t_(k+1) -
 * t_k; eps = T_(k+1)/T_k at the bounce between two flights. Returns STATUS_OK, STATUS_USAGE after a message with line
 * and column, or STATUS_FAILED if the file cannot be read. */
int fit_data_read(struct fit_data *data, const char *path, const struct fit_form *form);
/* The same of an open file, which messages call `name` */
int fit_data_parse(struct fit_data *data, FILE *file, const char *name, const struct fit_form *form);

/* A copy of the points that are not left out. Where bounces are left out, another drop begins. */
void fit_data_copy(struct fit_data *copy, const struct fit_data *data, const bool *left_out);

void fit_data_clear(struct fit_data *data);

#endif
