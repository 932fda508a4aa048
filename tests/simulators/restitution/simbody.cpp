/* SPDX-License-Identifier: MIT */
/* Collides a sphere with a half-space in Simbody's HuntCrossleyForce, with the lines of corgen contact --for simbody.
 * The array simbody_cases is in simbody_cases.inc, which measure.py writes. The program prints for each case, at 1 m/s
 * and for two accuracies of the integrator,
 *     eps NAME ACCURACY VALUE 0 */
#include <Simbody.h>

#include <cstdio>

using namespace SimTK;

typedef void set_parameters(HuntCrossleyForce &force, ContactSurfaceIndex surface);

static double rebound_speed(set_parameters *set, Real accuracy)
{
    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralContactSubsystem contacts(system);
    GeneralForceSubsystem forces(system);
    const Body::Rigid body(MassProperties(1.6e-3, Vec3(0), Inertia(1e-6)));
    MobilizedBody::Slider sphere(matter.updGround(), Transform(), body, Transform());
    const ContactSetIndex surfaces = contacts.createContactSet();
    contacts.addBody(surfaces, sphere, ContactGeometry::Sphere(0.01), Transform());
    contacts.addBody(surfaces, matter.updGround(), ContactGeometry::HalfSpace(), Transform());
    HuntCrossleyForce force(forces, contacts, surfaces);
    for (int i = 0; i < 2; i++)
        set(force, ContactSurfaceIndex(i));
    State state = system.realizeTopology();
    sphere.setQ(state, -0.01); // the half-space is x > 0
    sphere.setU(state, 1);
    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(accuracy);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    stepper.stepTo(0.05);
    return -sphere.getOneU(integrator.getState(), 0);
}

struct simbody_case {
    const char *name;
    set_parameters *set;
};

#include "simbody_cases.inc"

int main()
{
    for (const auto &one : simbody_cases)
        for (const double accuracy : {1e-8, 1e-11})
            std::printf("eps %s %g %.17g 0\n", one.name, accuracy, rebound_speed(one.set, accuracy));
    return 0;
}
