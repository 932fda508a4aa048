/* SPDX-License-Identifier: MIT */
/* Collides two equal spheres head-on with the callback that corgen contact --for rebound prints, at each of the given
 * speeds in m/s. callback.inc has the lines of the callback. The program prints for each speed
 *     eps SPEED VALUE
 * If COR_REBOUND is defined, REBOUND finds and resolves the collision. Otherwise a struct that has only the callback
 * replaces REBOUND's struct, and the speeds follow the formula of its src/collision.c. */
#include <stdio.h>
#include <stdlib.h>

#ifdef COR_REBOUND
#include "rebound.h"
#else
struct reb_simulation {
    double (*coefficient_of_restitution)(const struct reb_simulation *const r, double v);
};
#endif

#include "callback.inc"

#ifdef COR_REBOUND

static double restitution(double speed_m_s)
{
    const double radius_m = 0.01, step_s = 1e-3 / speed_m_s;
    struct reb_simulation *const r = reb_simulation_create();
    r->G = 0;
    r->dt = step_s;
    r->collision = REB_COLLISION_DIRECT;
    r->collision_resolve = reb_collision_resolve_hardsphere;
    r->coefficient_of_restitution = cor_restitution;
    for (int side = -1; side <= 1; side += 2) {
        struct reb_particle p = {0};
        p.m = 1;
        p.r = radius_m;
        p.x = 1.5 * side * radius_m;
        p.vx = -0.5 * side * speed_m_s;
        reb_simulation_add(r, p);
    }
    reb_simulation_steps(r, 100);
    const double rebound_m_s = r->particles[1].vx - r->particles[0].vx;
    reb_simulation_free(r);
    return rebound_m_s / speed_m_s;
}

#else

/* The speed of approach is negative in REBOUND. */
static double restitution(double speed_m_s)
{
    const struct reb_simulation r = {cor_restitution};
    const double approach_m_s = -speed_m_s,
                 change_m_s = -(1 + r.coefficient_of_restitution(&r, approach_m_s)) * approach_m_s;
    return (approach_m_s + change_m_s) / speed_m_s;
}

#endif

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++)
        printf("eps %s %.17g\n", argv[i], restitution(strtod(argv[i], NULL)));
    return 0;
}
