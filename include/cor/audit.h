/* SPDX-License-Identifier: MIT */
/* Reads the input of a simulator as it is and reports the restitution that its contacts realise. Part of libcor_scene.
 *
 * The functions open no file, print nothing, allocate nothing and never ask the locale: the caller hands over texts and
 * memory, and receives findings. Nothing is guessed: what a text does not say, and the options do not say either, is
 * NaN in a finding, with a sentence on what is missing. Source: docs/simulators.md. */
#ifndef COR_AUDIT_H
#define COR_AUDIT_H

#include <stddef.h>

#include "scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A text with its name for messages; a zero need not follow it. */
struct cor_audit_text {
    const char *name, *text;
    size_t size;
};

/* One contact at one speed, or, where `model` is NULL, a line that could not be read: then `advice` says why, and the
 * numbers are NaN. Texts last until the reporting function returns. Lengths, times and speeds are in SI units, but
 * for texts without a unit (LAMMPS `units lj`), whose own unit they have. */
struct cor_audit_finding {
    const char *file; /* name of the text */
    long line;        /* from 1; 0: the text as a whole */
    const char *simulator, *model;
    const char *pair;    /* "1-2", "1-wall", "*-*" */
    double asked;        /* e; NaN: the text gives a number of the damping instead */
    int end;             /* enum cor_end, or -1: not known */
    double speed_m_s;    /* NaN: every speed */
    double realised;     /* eps with a time step of zero */
    double damping;      /* cor's parameter: zeta where eps does not depend on the speed, otherwise beta */
    int law;             /* enum cor_law, or -1 */
    double duration_s;   /* of the contact */
    double time_step_s;  /* of the text or the options */
    double step_bias;    /* mean error of eps by the time step, and its standard deviation, over the phases of the */
    double step_scatter; /* first step; NaN: no time step, no speed, or no integrator of cor_scene_step_error */
    int as_asked;        /* 1; 0: eps differs from e, or is not known; -1: eps is known, and no e was asked for */
    const char *advice;  /* sentences; "" if there is nothing to say */
    const char *instead; /* the line that realises e; "" if the line does, or none can */
};

enum cor_audit_status {
    COR_AUDIT_AS_ASKED,     /* every contact realises the e that its text asks for, or asks for none */
    COR_AUDIT_NOT_AS_ASKED, /* some do not, or cannot be judged */
    COR_AUDIT_NO_CONTACT,   /* the text has none that could be made out */
    COR_AUDIT_NOT_TEXT,     /* it holds a zero byte */
    COR_AUDIT_UNKNOWN       /* neither the options nor the text tell the simulator */
};

/* Fills *included with the text that `name` means in the text named `from`, and returns 0; any other number if there is
 * none. The text must last until cor_audit returns. */
typedef int cor_audit_open(void *context, struct cor_audit_text *included, const char *name, const char *from);
typedef void cor_audit_report(void *context, const struct cor_audit_finding *finding);

struct cor_audit_options {
    const char *simulator;                       /* one of cor_audit_simulators; NULL: found in the text */
    long version;                                /* of the simulator, by cor_simulator_version; 0: not known */
    const double *speed_m_s;                     /* impact speeds */
    size_t speeds;                               /* 0: those that the text says */
    double radius_m, density_kg_m3, time_step_s; /* where the text does not say them; NaN: not known */
    double tolerance;                            /* as asked: |eps + bias - e|, scatter <= tolerance e */
    cor_scene_solver *solver;                    /* for laws without functions, or NULL */
    cor_audit_open *open;                        /* NULL: no text can be included */
    cor_audit_report *report;
    void *context; /* of both */
};

/* What cor_audit writes to; its contents mean nothing to the caller, and only one call at a time may use it. */
struct cor_audit_memory {
    double memory[20480];
};

extern const char *const cor_audit_simulators[]; /* ends with NULL */

/* Reports all contacts that the text describes, in its order. Any bytes are a valid text; the time is proportional to
 * its size, and some seconds more for errors of time steps; those that would take longer are left out. Returns enum
 * cor_audit_status. */
int cor_audit(struct cor_audit_memory *memory, const struct cor_audit_text *text,
              const struct cor_audit_options *options);

#ifdef __cplusplus
}
#endif

#endif
