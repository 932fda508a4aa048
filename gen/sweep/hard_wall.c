/* SPDX-License-Identifier: MIT */
#include "sweep/hard_wall.h"

#include <math.h>
#include <pthread.h>
#include <stdlib.h>

#include "cor/status.h"
#include "support/console.h"

/* Number of levels whose modes each table contains, up to Omega = 170, 339, 679, 960 */
static const int levels[HARD_WALL_TABLES] = {8, 10, 12, COR_DISK_HARD_WALL_MAX_LEVELS};

void hard_wall_tables_clear(struct hard_wall_tables *tables)
{
    for (int i = 0; i < HARD_WALL_TABLES; i++)
        free((void *)tables->table[i].mode);
    *tables = (struct hard_wall_tables){0};
}

void hard_wall_tables_set(struct hard_wall_tables *tables, double nu)
{
    hard_wall_tables_clear(tables);
    tables->nu = nu;
}

static int make_table(struct cor_disk_modes *table, double nu, int level_count)
{
    const double omega = COR_DISK_HARD_WALL_FIRST_OMEGA * pow(2, 0.5 * (level_count - 1));
    /* all modes below the last Omega, and the next one, which proves that no mode below the last Omega is missing */
    const size_t count = cor_disk_modes_below(nu, omega * (1 + 1e-9)) + 1;
    struct cor_disk_mode *const mode = xmalloc(count * sizeof *mode);
    const int status = cor_disk_modes_compute(nu, count, mode, table);
    if (status != COR_OK)
        free(mode);
    return status;
}

int hard_wall_collide(struct cor_disk_hard_wall *out, struct hard_wall_tables *tables, double tolerance,
                      size_t max_steps, double speed)
{
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    const struct cor_disk_hard_wall_options options = {tolerance, max_steps};
    int status = COR_TOLERANCE_NOT_REACHED;
    *out = (struct cor_disk_hard_wall){NAN, NAN, NAN, NAN, NAN, 0};
    for (int i = 0; i < HARD_WALL_TABLES && status == COR_TOLERANCE_NOT_REACHED; i++) {
        pthread_mutex_lock(&lock);
        status = tables->table[i].mode ? COR_OK : make_table(&tables->table[i], tables->nu, levels[i]);
        const struct cor_disk_modes table = tables->table[i];
        pthread_mutex_unlock(&lock);
        if (status != COR_OK)
            break;
        status = cor_disk_hard_wall(&table, table.count, &options, speed, out);
        if (status == COR_TOLERANCE_NOT_REACHED && out->omega_levels < (size_t)levels[i])
            break; /* the table suffices, and max_steps was too small */
    }
    return status;
}
