/* SPDX-License-Identifier: MIT */
/* eps of a contact over a range of impact speeds as the fewest points from which interpolation gives it to a relative
 * tolerance.
 *
 * The points lie on the curve, and both ends of the range are points. From each point the next is placed as far away as
 * the tolerance allows (docs/contact.md). All points are then moved until the segments have the same error; a segment
 * over a point of inflection may keep a smaller one. If evenly spaced points have a smaller largest error, they are
 * taken. */
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
    const struct own_law *own; /* instead of the contact, which is all 0 then; NULL: none */
    enum cor_end end;
    double speed_min, speed_max; /* m/s */
    double tolerance;            /* relative error, SAMPLE_FINEST to SAMPLE_COARSEST */
    bool log;                    /* interpolation in the logarithm of the speed */
    bool cubic;                  /* cubic Hermite interpolation of values and slopes; otherwise linear */
    bool duration;               /* the duration, too, within the same tolerance */
};

/* Points of a table. value[0] is eps, value[1] the duration in s if asked for. slope is d value/d speed, or d value/d
 * ln(speed) with `log`; only with `cubic`. error is the largest relative error of the interpolation, measured at 64
 * places between each two points. */
struct sample_points {
    size_t count;
    double *speed_m_s, *value[SAMPLE_QUANTITIES], *slope[SAMPLE_QUANTITIES];
    double error;
};

struct sample {
    struct sample_points best;
    struct sample_points even; /* as many points, equally far apart in speed or, with `log`, in its logarithm */
    double error_of_fewer; /* of one point fewer, equal in all segments; infinite for two points, and not computed for
                            * more than a thousand */
};

/* Returns STATUS_OK; STATUS_USAGE after a message if the tolerance needs too many points or if eps vanishes in the
 * range; STATUS_FAILED. In every case sample_clear frees the memory. */
int sample_choose(struct sample *sample, const struct sample_request *request);
void sample_clear(struct sample *sample);

/* ---- sample_table.c: text, csv, json, arrays of C, lists of Python, and tables that simulators read ---- */

/* The first three are those of enum output_format. */
enum sample_format {
    SAMPLE_TEXT,
    SAMPLE_CSV,
    SAMPLE_JSON,
    SAMPLE_C,
    SAMPLE_PYTHON,
    SAMPLE_MODELICA, /* CombiTable1Ds, CombiTable1Dv: linear interpolation alone */
    SAMPLE_OPENFOAM  /* Function1 of type table: linear interpolation alone */
};
extern const char *const sample_format_names[]; /* ends with NULL */

void sample_print(FILE *file, const struct sample *sample, const struct sample_request *request,
                  enum sample_format format);

#endif
