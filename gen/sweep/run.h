/* SPDX-License-Identifier: MIT */
/* Runs a sweep on threads and writes its file. docs/disks.md. */
#ifndef COR_GEN_SWEEP_RUN_H
#define COR_GEN_SWEEP_RUN_H

#include "sweep/sweep.h"

struct sweep_request {
    struct sweep sweep; /* its lists, tolerance and angles; sweep_run computes the other fields */
    int threads;        /* 0: one for each processor */
    enum output_format format;
    const char *output; /* file; NULL: standard output */
    const char *plot;   /* a picture of eps over the speed; NULL: none */
};

/* Returns STATUS_OK, or another status after a message. */
int sweep_run(const struct sweep_request *request);

#endif
