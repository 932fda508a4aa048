/* SPDX-License-Identifier: MIT */
/* Collides two equal spheres head-on in Bullet, or one with a plane, with the lines of corgen contact --for bullet. The
 * file bullet_cases.inc, which measure.py writes, contains the array bullet_cases. The first overlap depends on the
 * moment within a time step at which the bodies meet. The program prints for each case the smallest and the largest
 * restitution over 64 such moments. For a spring both numbers are the mean, because corgen states the mean.
 *     eps NAME 64 SMALLEST LARGEST */
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cstdio>

typedef void set_restitution(btRigidBody *body, btDiscreteDynamicsWorld *world);

struct bullet_case {
    const char *name;
    set_restitution *set;
    double speed_m_s;
    int wall, spring;
    double step_s;
};

/* Returns the restitution of bodies that meet after `steps` steps. */
static double restitution(const bullet_case &one, double steps)
{
    const btScalar radius = 0.05, mass = one.wall ? 0.002 : 0.0032;
    const double share = one.wall ? 1 : 0.5; // share of the speed of each moving body
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
    btStaticPlaneShape plane(btVector3(-1, 0, 0), 0);
    const btRigidBody::btRigidBodyConstructionInfo fixed(0, nullptr, &plane);
    btRigidBody left(info), right(one.wall ? fixed : info);
    btRigidBody *const both[] = {&left, &right};
    for (int i = 0; i < 2; i++) {
        const btScalar side = i == 0 ? -1 : 1;
        btTransform place = btTransform::getIdentity();
        if (i == 0 || !one.wall)
            place.setOrigin(btVector3(side * (radius + btScalar(share * one.speed_m_s * steps * one.step_s)), 0, 0));
        both[i]->setWorldTransform(place);
        both[i]->setInterpolationWorldTransform(place);
        both[i]->setFriction(0);
        both[i]->setActivationState(DISABLE_DEACTIVATION);
        world.addRigidBody(both[i]);
        if (i == 0 || !one.wall)
            both[i]->setLinearVelocity(btVector3(-side * btScalar(share * one.speed_m_s), 0, 0));
        one.set(both[i], &world);
    }
    for (int k = 0; k < (one.spring ? 200 : 60); k++)
        world.stepSimulation(btScalar(one.step_s), 0);
    return (right.getLinearVelocity().x() - left.getLinearVelocity().x()) / one.speed_m_s;
}

#include "bullet_cases.inc"

int main()
{
    const int places = 64;
    for (const auto &one : bullet_cases) {
        double smallest = 9, largest = -9, mean = 0;
        for (int k = 0; k < places; k++) {
            const double eps = restitution(one, 20 + (k + 0.5) / places);
            smallest = std::min(smallest, eps);
            largest = std::max(largest, eps);
            mean += eps / places;
        }
        std::printf("eps %s %d %.17g %.17g\n", one.name, places, one.spring ? mean : smallest,
                    one.spring ? mean : largest);
    }
    return 0;
}
