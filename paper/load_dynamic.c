/* SPDX-License-Identifier: MIT */
/* Fig. 10, dynamic: load against compression during a collision. */
#include <math.h>
#include <stdlib.h>

#include "collisions.h"
#include "relaxed_disk.h"
#include "report.h"

static const double alpha = 500, speed[] = {0.1, 0.04};
enum { MODES = 1300, MOST = 20000, DRAWN = 400, SPEEDS = 2 };

struct trace {
    struct cor_disk_moment moment[MOST];
    int count;
    double largest_load;
};

static void trace_record(void *context, const struct cor_disk_moment *moment, const double *q, const double *q_dot)
{
    struct trace *trace = context;
    (void)q;
    (void)q_dot;
    if (trace->count < MOST)
        trace->moment[trace->count++] = *moment;
    trace->largest_load = fmax(trace->largest_load, moment->load);
}

struct watched {
    double largest_compression, largest_load;
    double half;    /* of the largest compression, and there: */
    double load[2]; /* on the way in, on the way out */
    double relaxed;
};

/* Load on the way in and on the way out at one compression */
static void loads_at(const struct trace *trace, double compression, double load[2])
{
    int found = 0;
    for (int i = 1; i < trace->count && found < 2; i++) {
        const struct cor_disk_moment *a = &trace->moment[i - 1], *b = &trace->moment[i];
        const double from = a->position + 1 - compression, to = b->position + 1 - compression;
        if ((from < 0) != (to < 0))
            load[found++] = a->load + (b->load - a->load) * from / (from - to);
    }
}

static int write_load_dynamic(FILE *csv, char verdict[VERDICT_SIZE])
{
    struct trace *trace = malloc(sizeof *trace);
    struct relaxed_disk *relaxed = relaxed_disk_of_modes(&cor_disk_modes_nu033, MODES, alpha, 192);
    struct watched watched[SPEEDS];
    int made = trace != NULL && relaxed != NULL;
    if (!made)
        fprintf(stderr, "cor_paper: out of memory\n");
    fputs("speed,time,compression,load\n", csv);
    for (int i = 0; made && i < SPEEDS; i++) {
        struct cor_disk_collision out;
        trace->count = 0;
        trace->largest_load = 0;
        made = collision_watch(MODES, alpha, speed[i], trace_record, trace, &out, NULL, NULL);
        int first = 0, last = trace->count - 1;
        while (first < last && trace->moment[first].load < 1e-3 * trace->largest_load)
            first++;
        while (last > first && trace->moment[last].load < 1e-3 * trace->largest_load)
            last--;
        const int stride = 1 + (last - first) / DRAWN;
        for (int k = first; made && k <= last; k += stride)
            fprintf(csv, "%g,%.4f,%.5f,%.5f\n", speed[i], trace->moment[k].time, trace->moment[k].position + 1,
                    trace->moment[k].load);
        fputs(i == 0 ? "\n\n" : "", csv);
        struct watched *const w = &watched[i];
        *w = (struct watched){out.max_compression, trace->largest_load, out.max_compression / 2, {NAN, NAN}, NAN};
        loads_at(trace, w->half, w->load);
        struct relaxed_state state;
        made = made && relaxed_disk_press(relaxed, w->half, &state);
        w->relaxed = made ? state.load : NAN;
    }
    if (made)
        snprintf(
            verdict, VERDICT_SIZE,
            "In a collision (below; alpha = %g, %d modes) the loads are higher, as in the paper, and closer to the "
            "relaxed disk at the smaller speed. Compare at half the largest delta, on the way in. The load is %.4f "
            "against %.4f of the relaxed disk at v = %g (delta = %.4f), a ratio of %.2f. It is %.4f against %.4f at "
            "v = %g (delta = %.4f), a ratio of %.2f. On the way out it is %.4f and %.4f. At larger delta the load "
            "of v = %g falls below that of the relaxed disk and oscillates with the fast modes.",
            alpha, MODES, watched[0].load[0], watched[0].relaxed, speed[0], watched[0].half,
            watched[0].load[0] / watched[0].relaxed, watched[1].load[0], watched[1].relaxed, speed[1], watched[1].half,
            watched[1].load[0] / watched[1].relaxed, watched[0].load[1], watched[1].load[1], speed[0]);
    relaxed_disk_free(relaxed);
    free(trace);
    return made;
}

const struct figure load_dynamic_figure = {"load_dynamic", "Fig. 10", "load against compression in a collision",
                                           write_load_dynamic};
