/* SPDX-License-Identifier: MIT */
/* A sweep from its first row to its file, on threads and ranks. docs/disk-collide.md. */
#ifndef COR_GEN_SWEEP_RUN_H
#define COR_GEN_SWEEP_RUN_H

#include "sweep/sweep.h"

struct sweep_request {
    struct sweep sweep; /* lists, tolerance and angles; sweep_run counts the rest */
    int threads;        /* 0: as many as processors; 1 where there are several ranks */
    enum output_format format;
    const char *output; /* file; NULL: standard output */
};

/* STATUS_OK, or another status after a sentence. */
int sweep_run(const struct sweep_request *request);

#endif
