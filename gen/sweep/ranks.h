/* SPDX-License-Identifier: MIT */
/* The other processes of one mpirun. There are none unless corgen is built with MPI (-DCOR_WITH_MPI=ON). Only the main
 * thread calls these functions. */
#ifndef COR_GEN_SWEEP_RANKS_H
#define COR_GEN_SWEEP_RANKS_H

#include <stdbool.h>
#include <stddef.h>

/* Joins the other processes if mpirun or a similar launcher has started this one. STATUS_OK, or STATUS_FAILED after a
 * message. */
int ranks_start(void);
void ranks_stop(void);

int ranks_count(void); /* 1 without mpirun */
int ranks_mine(void);  /* from 0 */

/* STATUS_FAILED after a message if a launcher started several processes that cannot find one another: each would do all
 * the work and write the same file. Otherwise STATUS_OK. */
int ranks_check(void);

/* For work that rank 0 does alone: the other ranks call ranks_wait, which returns when rank 0 calls ranks_release. */
void ranks_wait(void);
void ranks_release(void);

void ranks_send(int rank, int tag, const void *bytes, size_t n);

/* Takes a message that has arrived; false if there is none. Never waits. *bytes is malloc'ed, or NULL for an empty
 * message. */
bool ranks_receive(int *rank, int *tag, void **bytes, size_t *n);

#endif
