/* SPDX-License-Identifier: MIT */
#include "sweep/ranks.h"

#include <limits.h>
#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <time.h>

#include <mpi.h>

#include "support/clock.h"
#include "support/console.h"

static const double SHORTEST_PAUSE = 5e-5, LONGEST_PAUSE = 0.02;

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER; /* MPI is called by one thread at a time */
static int count = 1, mine;
static bool joined;

/* MPI is initialised only under a launcher. Without one it would start daemons of its own, and fail where it cannot. */
static bool ranks_launched(void)
{
    static const char *const variable[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMI_RANK", "PMIX_RANK",
                                           "MPI_LOCALNRANKS"};
    for (size_t i = 0; i < sizeof variable / sizeof *variable; i++) {
        if (getenv(variable[i]))
            return true;
    }
    return false;
}

int ranks_start(void)
{
    if (joined || !ranks_launched())
        return STATUS_OK;
    int given;
    if (MPI_Init_thread(NULL, NULL, MPI_THREAD_SERIALIZED, &given) != MPI_SUCCESS)
        return fail("MPI does not start");
    joined = true;
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    MPI_Comm_rank(MPI_COMM_WORLD, &mine);
    if (given < MPI_THREAD_SERIALIZED) {
        ranks_stop();
        return fail("this MPI does not allow threads (MPI_THREAD_SERIALIZED)");
    }
    return STATUS_OK;
}

void ranks_stop(void)
{
    if (joined)
        MPI_Finalize();
    joined = false;
    count = 1;
}

int ranks_check(void)
{
    return STATUS_OK;
}

int ranks_count(void)
{
    return count;
}

int ranks_mine(void)
{
    return mine;
}

void ranks_send(int rank, int tag, const void *bytes, size_t n)
{
    if (n > INT_MAX) { /* the largest table of modes that a sweep allows is shorter */
        fail("a message of %zu bytes is more than MPI sends", n);
        MPI_Abort(MPI_COMM_WORLD, STATUS_FAILED);
    }
    pthread_mutex_lock(&mutex);
    MPI_Send(bytes, (int)n, MPI_BYTE, rank, tag, MPI_COMM_WORLD);
    pthread_mutex_unlock(&mutex);
}

/* Polls, because a waiting MPI keeps its processor busy: ever more rarely, so that a wait lasts an eighth longer or
 * LONGEST_PAUSE more. */
void *ranks_receive(int rank, int tag, size_t *n)
{
    MPI_Status status;
    int there = 0, size = 0;
    void *bytes = NULL;
    const double start = clock_seconds();
    for (;;) {
        pthread_mutex_lock(&mutex);
        MPI_Iprobe(rank, tag, MPI_COMM_WORLD, &there, &status);
        if (there)
            break;
        pthread_mutex_unlock(&mutex);
        const double pause = fmin(SHORTEST_PAUSE + (clock_seconds() - start) / 8, LONGEST_PAUSE);
        nanosleep(&(struct timespec){0, (long)(1e9 * pause)}, NULL);
    }
    MPI_Get_count(&status, MPI_BYTE, &size);
    *n = (size_t)size;
    bytes = size > 0 ? xmalloc(*n) : NULL;
    MPI_Recv(bytes, size, MPI_BYTE, rank, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    pthread_mutex_unlock(&mutex);
    return bytes;
}
