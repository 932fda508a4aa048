// SPDX-License-Identifier: MIT | after MercuryDPM Drivers/MercuryCG, a bed of spheres | BSD-3-Clause | speed=0.5
#include "Mercury3D.h"
class Bed : public Mercury3D
{
    void setupInitialConditions() override
    {
        auto species = speciesHandler.copyAndAddObject(LinearViscoelasticSpecies());
        species->setDensity(6.0 / constants::pi);
        species->setCollisionTimeAndRestitutionCoefficient(.01, .1, 1.);
        setTimeStep(.0002);
        SphericalParticle p;
        p.setSpecies(species);
        p.setRadius(0.5);
    }
};
