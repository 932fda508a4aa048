/* SPDX-License-Identifier: MIT */
/* The other processes of one mpirun. There are none unless corgen is built with MPI (-DCOR_WITH_MPI=ON). */
#ifndef COR_GEN_SWEEP_RANKS_H
#define COR_GEN_SWEEP_RANKS_H

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

/* Messages between two ranks arrive in order for each tag. Any thread may call these two functions. ranks_receive waits
 * for a message; it returns the bytes, malloc'ed, or NULL for an empty message. */
enum { RANKS_TAG_MAIN = 0 }; /* between the main threads */
void ranks_send(int rank, int tag, const void *bytes, size_t n);
void *ranks_receive(int rank, int tag, size_t *n);

#endif
