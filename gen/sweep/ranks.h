/* SPDX-License-Identifier: MIT */
/* The other processes of one mpirun, where corgen is built with MPI (-DCOR_WITH_MPI=ON); otherwise there are none.
 * Only the main thread calls these. */
#ifndef COR_GEN_SWEEP_RANKS_H
#define COR_GEN_SWEEP_RANKS_H

#include <stdbool.h>
#include <stddef.h>

/* Joins the others, if mpirun or its like has started this process. STATUS_OK, or STATUS_FAILED after a sentence. */
int ranks_start(void);
void ranks_stop(void);

int ranks_count(void); /* 1 without mpirun */
int ranks_mine(void);  /* from 0 */

/* STATUS_OK, or STATUS_FAILED after a sentence where several processes were started that cannot find one another: they
 * would do the same work and write the same file. */
int ranks_check(void);

/* What one process does alone: the others wait, without work, until rank 0 releases them. */
void ranks_wait(void);
void ranks_release(void);

void ranks_send(int rank, int tag, const void *bytes, size_t n);

/* A message that has come, if there is one: its bytes are malloc'ed, or NULL if it has none. Does not wait. */
bool ranks_receive(int *rank, int *tag, void **bytes, size_t *n);

#endif
