/* SPDX-License-Identifier: MIT */
/* A disk of all its modes at a rigid wall, and how far from it extrapolations ended. */
#include "rigid.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "collisions.h"
#include "cor/status.h"
#include "limit.h"

/* ---- collisions, each once ---- */

enum { MATERIALS = 2, LEVELS = 9, KEPT_MOST = 256 };
static const double nu_of[MATERIALS] = {0.33, 0.9};
static struct cor_disk_modes material[MATERIALS]; /* as many modes as LEVELS levels need */

static struct {
    double nu, speed, tolerance;
    struct cor_disk_hard_wall out;
} kept[KEPT_MOST];
static int kept_count;

static int know_modes(int m)
{
    if (material[m].mode != NULL)
        return COR_OK;
    const double omega = COR_DISK_HARD_WALL_FIRST_OMEGA * pow(2, 0.5 * (LEVELS - 1));
    const size_t count = cor_disk_modes_below(nu_of[m], omega * (1 + 1e-9)) + 1;
    struct cor_disk_mode *const mode = malloc(count * sizeof *mode);
    const int status = mode == NULL ? COR_ERROR_MEMORY : cor_disk_modes_compute(nu_of[m], count, mode, &material[m]);
    if (status != COR_OK)
        free(mode);
    return status;
}

void rigid_wall_clear(void)
{
    for (int m = 0; m < MATERIALS; m++) {
        free((void *)(size_t)material[m].mode);
        material[m].mode = NULL;
    }
}

struct cor_disk_hard_wall rigid_wall(double nu, double speed, double tolerance)
{
    for (int i = 0; i < kept_count; i++)
        if (kept[i].nu == nu && kept[i].speed == speed && kept[i].tolerance == tolerance)
            return kept[i].out;
    const int m = nu == nu_of[0] ? 0 : 1;
    const struct cor_disk_hard_wall_options options = {tolerance, SIZE_MAX};
    struct cor_disk_hard_wall out = {NAN, NAN, NAN, NAN, NAN, 0};
    int status = know_modes(m);
    if (status == COR_OK)
        status = cor_disk_hard_wall(&material[m], material[m].count, &options, speed, &out);
    if (status != COR_OK && status != COR_TOLERANCE_NOT_REACHED)
        fprintf(stderr, "cor_paper: %s\n", cor_status_text(status));
    if (kept_count < KEPT_MOST) {
        kept[kept_count].nu = nu;
        kept[kept_count].speed = speed;
        kept[kept_count].tolerance = tolerance;
        kept[kept_count++].out = out;
    }
    return out;
}

/* ---- how far from it extrapolations ended ---- */

struct miss {
    double most, at, relative; /* the largest of |extrapolated - limit|, its speed, and as a part of the limit */
    int beyond, of;            /* how many are farther off than their uncertainty and that of the limit allow */
};

static void count_miss(struct miss *miss, double extrapolated, double uncertainty, double nu, double speed)
{
    const struct cor_disk_hard_wall out = rigid_wall(nu, speed, RIGID_TOLERANCE);
    const double off = extrapolated - out.one_minus_eps2;
    if (fabs(off) > fabs(miss->most)) {
        miss->most = off;
        miss->at = speed;
        miss->relative = off / out.one_minus_eps2;
    }
    miss->beyond += fabs(off) > uncertainty + out.error_estimate;
    miss->of++;
}

/* ---- the figure: what the others draw as a line ---- */

static void write_line(FILE *csv, double nu)
{
    enum { POINTS = 56 };
    for (int i = 0; i < POINTS; i++) {
        const double v = i < POINTS - 1 ? log_point(1e-6, 0.3, i, POINTS) : 0.3;
        const struct cor_disk_hard_wall out = rigid_wall(nu, v, RIGID_LINE_TOLERANCE);
        fprintf(csv, "%g,%.6g,%.5f,%.5f,%.5f,%.4f,%.5g\n", nu, v, out.one_minus_eps2, out.error_estimate, out.eps,
                out.contact_time, out.max_compression);
    }
}

static int write_rigid_wall(FILE *csv, char verdict[VERDICT_SIZE])
{
    fputs("nu,speed,one_minus_eps2,uncertainty,eps,contact_time,max_compression\n", csv);
    struct miss of_paper = {0}, of_many[MATERIALS] = {{0}}, of_slow = {0};
    double largest_estimate = 0;
    for (int m = 0; m < MATERIALS; m++) {
        write_line(csv, nu_of[m]);
        fputs(m == 0 ? "\n\n" : "", csv);
        for (int i = 0; i < PAPER_SPEEDS; i++) {
            const double v = paper_speed(i);
            const struct limit limit = limit_of(nu_of[m], v);
            count_miss(&of_many[m], limit.one_minus_eps2, limit.uncertainty, nu_of[m], v);
            largest_estimate = fmax(largest_estimate, rigid_wall(nu_of[m], v, RIGID_TOLERANCE).error_estimate);
        }
    }
    for (int i = 0; i < PAPER_SPEEDS; i++)
        count_miss(&of_paper, size_line(0.33, paper_speed(i), 0, WALL_SIZE).at_zero, 0, 0.33, paper_speed(i));
    for (int i = 0; i < SLOW_SPEEDS; i++)
        count_miss(&of_slow, limit_of(0.33, slow_speed(i)).one_minus_eps2, limit_of(0.33, slow_speed(i)).uncertainty,
                   0.33, slow_speed(i));
    snprintf(
        verdict, VERDICT_SIZE,
        "cor_disk_hard_wall computes the limit itself, all modes at a rigid wall, to %.0e in 1 - eps^2 at the "
        "paper's speeds. At nu = 0.33 the extrapolation from the paper's N = 300 to 940 ends up to %+.1e from it, "
        "at v = %g (%+.1f %%). That from N = 940 to 1800 ends up to %+.1e from it, at v = %g (%+.1f %%); %d of its "
        "%d points are farther off than both uncertainties together. At nu = 0.9 the latter ends up to %+.1e off, "
        "at v = %g (%+.1f %%), %d of %d beyond these uncertainties. At the small speeds of the last figure it ends "
        "up to %+.1e off, at v = %.2g (%+.0f %%).",
        largest_estimate, of_paper.most, of_paper.at, 100 * of_paper.relative, of_many[0].most, of_many[0].at,
        100 * of_many[0].relative, of_many[0].beyond, of_many[0].of, of_many[1].most, of_many[1].at,
        100 * of_many[1].relative, of_many[1].beyond, of_many[1].of, of_slow.most, of_slow.at, 100 * of_slow.relative);
    return !isnan(largest_estimate);
}

const struct figure rigid_wall_figure = {"rigid_wall", "Beyond the paper", "the limit of the paper's figures",
                                         write_rigid_wall};
