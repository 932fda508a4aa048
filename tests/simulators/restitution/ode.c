/* SPDX-License-Identifier: MIT */
/* Collides two equal spheres head-on in ODE, with the numbers and the time step of corgen contact --for gazebo.
 *     ode SOFT_ERP SOFT_CFM STEP_S
 * prints the mean restitution at 1 m/s over 64 places of first touch within a time step:
 *     eps ode 64 MEAN MEAN */
#include <ode/ode.h>

#include <stdio.h>
#include <stdlib.h>

struct collision {
    dWorldID world;
    dJointGroupID joints;
    dSurfaceParameters surface;
};

static void touch(void *data, dGeomID one, dGeomID two)
{
    const struct collision *const c = data;
    dContact contact = {.surface = c->surface};
    if (dCollide(one, two, 1, &contact.geom, sizeof contact) > 0)
        dJointAttach(dJointCreateContact(c->world, c->joints, &contact), dGeomGetBody(one), dGeomGetBody(two));
}

/* Returns the restitution of spheres that meet after `steps` steps. */
static double restitution(const dSurfaceParameters *surface, double steps, double step_s)
{
    const double radius = 0.05, mass = 3.2e-3;
    struct collision c = {dWorldCreate(), dJointGroupCreate(0), *surface};
    const dSpaceID space = dSimpleSpaceCreate(0);
    dBodyID bodies[2];
    for (int i = 0; i < 2; i++) {
        const double side = i == 0 ? -1 : 1;
        const dGeomID sphere = dCreateSphere(space, radius);
        dMass inertia;
        dMassSetSphereTotal(&inertia, mass, radius);
        bodies[i] = dBodyCreate(c.world);
        dBodySetMass(bodies[i], &inertia);
        dBodySetPosition(bodies[i], side * (radius + steps * step_s / 2), 0, 0);
        dBodySetLinearVel(bodies[i], -side / 2, 0, 0);
        dGeomSetBody(sphere, bodies[i]);
    }
    for (int k = 0; k < 200; k++) {
        dSpaceCollide(space, &c, touch);
        dWorldQuickStep(c.world, step_s);
        dJointGroupEmpty(c.joints);
    }
    const double eps = dBodyGetLinearVel(bodies[1])[0] - dBodyGetLinearVel(bodies[0])[0];
    dJointGroupDestroy(c.joints);
    dSpaceDestroy(space);
    dWorldDestroy(c.world);
    return eps;
}

int main(int argc, char **argv)
{
    const int places = 64;
    double mean = 0;
    if (argc != 4)
        return 2;
    const dSurfaceParameters surface = {.mode = dContactSoftERP | dContactSoftCFM,
                                        .soft_erp = strtod(argv[1], NULL),
                                        .soft_cfm = strtod(argv[2], NULL)};
    dInitODE();
    for (int k = 0; k < places; k++)
        mean += restitution(&surface, 20 + (k + 0.5) / places, strtod(argv[3], NULL)) / places;
    printf("eps ode %d %.17g %.17g\n", places, mean, mean);
    return 0;
}
