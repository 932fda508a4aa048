/* SPDX-License-Identifier: MIT */
#include "sweep/ranks.h"

#include <limits.h>
#include <stdlib.h>
#include <time.h>

#include <mpi.h>

#include "support/console.h"

enum { TAG_RELEASE = 0, PAUSE_NANOSECONDS = 20000000 };

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
    if (MPI_Init_thread(NULL, NULL, MPI_THREAD_FUNNELED, &given) != MPI_SUCCESS)
        return fail("MPI does not start");
    joined = true;
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    MPI_Comm_rank(MPI_COMM_WORLD, &mine);
    if (given < MPI_THREAD_FUNNELED) {
        ranks_stop();
        return fail("this MPI does not allow threads (MPI_THREAD_FUNNELED)");
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

/* Polls, because a waiting MPI keeps its processor busy. */
void ranks_wait(void)
{
    const struct timespec pause = {0, PAUSE_NANOSECONDS};
    int rank, tag;
    void *bytes;
    size_t n;
    while (!ranks_receive(&rank, &tag, &bytes, &n))
        nanosleep(&pause, NULL);
    free(bytes);
}

void ranks_release(void)
{
    for (int rank = 1; rank < count; rank++)
        ranks_send(rank, TAG_RELEASE, NULL, 0);
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
    MPI_Send(bytes, (int)n, MPI_BYTE, rank, tag, MPI_COMM_WORLD);
}

bool ranks_receive(int *rank, int *tag, void **bytes, size_t *n)
{
    if (count < 2)
        return false;
    int there = 0, size = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (!there)
        return false;
    MPI_Get_count(&status, MPI_BYTE, &size);
    *rank = status.MPI_SOURCE;
    *tag = status.MPI_TAG;
    *n = (size_t)size;
    *bytes = size > 0 ? xmalloc(*n) : NULL;
    MPI_Recv(*bytes, size, MPI_BYTE, *rank, *tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return true;
}
