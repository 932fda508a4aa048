/* SPDX-License-Identifier: MIT */
/* Tabulates eps of a contact over a range of impact speeds by the fewest points whose interpolation meets a relative
 * tolerance. The points are on the curve, and both ends of the range are points. Each point is as far from the previous
 * one as the tolerance allows (docs/contact.md). Then all points move until the segments have the same error, except
 * over inflection points. Evenly spaced points replace them if their largest error is smaller. */
#ifndef COR_GEN_CONTACT_SAMPLE_H
#define COR_GEN_CONTACT_SAMPLE_H

#include <stdio.h>

#include "contact/contact.h"

#define SAMPLE_FINEST 1e-10
#define SAMPLE_COARSEST 0.1
enum { SAMPLE_MOST_POINTS = 20000 };

enum { SAMPLE_QUANTITIES = 2 }; /* eps and duration */

/* The request of corgen sample */
struct sample_request {
    const struct cor_scene_contact *contact;
    const struct own_law *own; /* a law that replaces the contact, whose fields are then 0; NULL: no own law */
    enum cor_end end;
    double speed_min, speed_max; /* m/s */
    double tolerance;            /* relative error, SAMPLE_FINEST to SAMPLE_COARSEST */
    bool log;                    /* interpolate in ln(speed) */
    bool cubic;                  /* cubic Hermite instead of linear interpolation */
    bool duration;               /* tabulate the duration, too, within the tolerance */
};

/* Points of a table. value[0] is eps, value[1] the duration in s if requested. slope is d value/d speed, or with `log`
 * d value/d ln(speed); NULL without `cubic`. error is the largest relative error of the interpolation, measured at 64
 * places between neighbours. */
struct sample_points {
    size_t count;
    double *speed_m_s, *value[SAMPLE_QUANTITIES], *slope[SAMPLE_QUANTITIES];
    double error;
};

struct sample {
    struct sample_points best;
    struct sample_points even; /* a table of the same size, evenly spaced in speed or, with `log`, in its logarithm */
    double error_of_fewer;     /* smallest error with one point fewer; infinite: 1 segment, or more than 1000 */
};

/* Returns STATUS_OK, STATUS_USAGE after a message if the tolerance needs too many points or eps vanishes in the range,
 * or STATUS_FAILED. In every case sample_clear frees the memory. */
int sample_choose(struct sample *sample, const struct sample_request *request);
void sample_clear(struct sample *sample);

/* ---- sample_table.c: text, csv, json, arrays of C, lists of Python, and tables that simulators read ---- */

/* The first three are the formats of enum output_format. */
enum sample_format {
    SAMPLE_TEXT,
    SAMPLE_CSV,
    SAMPLE_JSON,
    SAMPLE_C,
    SAMPLE_PYTHON,
    SAMPLE_MODELICA, /* CombiTable1Ds, CombiTable1Dv: only linear interpolation */
    SAMPLE_OPENFOAM  /* Function1 of type table: only linear interpolation */
};
extern const char *const sample_format_names[]; /* ends with NULL */

void sample_print(FILE *file, const struct sample *sample, const struct sample_request *request,
                  enum sample_format format);

#endif
