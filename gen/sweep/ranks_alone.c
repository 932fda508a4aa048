/* SPDX-License-Identifier: MIT */
#include "sweep/ranks.h"

#include <stdlib.h>

#include "support/console.h"

int ranks_start(void)
{
    return STATUS_OK;
}

int ranks_check(void)
{
    static const char *const variable[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS"};
    for (size_t i = 0; i < sizeof variable / sizeof *variable; i++) {
        const char *size = getenv(variable[i]);
        if (size && strtol(size, NULL, 10) > 1)
            return fail("this corgen is built without MPI, and mpirun has started several; build it with "
                        "-DCOR_WITH_MPI=ON or run it alone");
    }
    return STATUS_OK;
}

void ranks_stop(void)
{
}

int ranks_count(void)
{
    return 1;
}

int ranks_mine(void)
{
    return 0;
}

void ranks_send(int rank, int tag, const void *bytes, size_t n)
{
    (void)rank;
    (void)tag;
    (void)bytes;
    (void)n;
}

void *ranks_receive(int rank, int tag, size_t *n)
{
    (void)rank;
    (void)tag;
    *n = 0;
    return NULL;
}
