/* SPDX-License-Identifier: MIT */
/* Two equal spheres head-on in Bullet, with the lines of corgen contact --for bullet. The file bullet_cases.inc, which
 * run writes, holds the array bullet_cases. The first overlap depends on where in a time step the spheres meet. The
 * program prints for each case the smallest and the largest restitution of 64 such places, with steps of 1/240 s:
 *     eps NAME 64 SMALLEST LARGEST */
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cstdio>

typedef void set_restitution(btRigidBody *body, btDiscreteDynamicsWorld *world);

struct bullet_case {
    const char *name;
    set_restitution *set;
    double speed_m_s;
};

/* Returns the restitution of spheres that meet after `steps` steps. */
static double restitution(const bullet_case &one, double steps, double step_s)
{
    const btScalar radius = 0.05, mass = 0.0032;
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity(btVector3(0, 0, 0));
    btSphereShape shape(radius);
    btVector3 inertia;
    shape.calculateLocalInertia(mass, inertia);
    const btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    btRigidBody left(info), right(info);
    btRigidBody *const both[] = {&left, &right};
    for (int i = 0; i < 2; i++) {
        const btScalar side = i == 0 ? -1 : 1;
        btTransform place = btTransform::getIdentity();
        place.setOrigin(btVector3(side * (radius + btScalar(one.speed_m_s * steps * step_s / 2)), 0, 0));
        both[i]->setWorldTransform(place);
        both[i]->setInterpolationWorldTransform(place);
        both[i]->setFriction(0);
        both[i]->setActivationState(DISABLE_DEACTIVATION);
        world.addRigidBody(both[i]);
        both[i]->setLinearVelocity(btVector3(-side * btScalar(one.speed_m_s / 2), 0, 0));
        one.set(both[i], &world);
    }
    for (int k = 0; k < 60; k++)
        world.stepSimulation(btScalar(step_s), 0);
    return (right.getLinearVelocity().x() - left.getLinearVelocity().x()) / one.speed_m_s;
}

#include "bullet_cases.inc"

int main()
{
    const int places = 64;
    const double step_s = 1 / 240.0;
    for (const auto &one : bullet_cases) {
        double smallest = 9, largest = -9;
        for (int k = 0; k < places; k++) {
            const double eps = restitution(one, 20 + (k + 0.5) / places, step_s);
            smallest = std::min(smallest, eps);
            largest = std::max(largest, eps);
        }
        std::printf("eps %s %d %.17g %.17g\n", one.name, places, smallest, largest);
    }
    return 0;
}
