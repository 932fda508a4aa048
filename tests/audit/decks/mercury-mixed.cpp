// SPDX-License-Identifier: MIT | after MercuryDPM Drivers/USER/Luca/ShearTest.cpp | BSD-3-Clause | no option
#include "Mercury3D.h"
#include "Species/LinearViscoelasticFrictionSpecies.h"
#include "Species/LinearPlasticViscoelasticFrictionSpecies.h"
int main() {
    Mercury3D problem;
    auto seed = problem.speciesHandler.copyAndAddObject(LinearViscoelasticFrictionSpecies());
    auto steel = problem.speciesHandler.copyAndAddObject(LinearViscoelasticFrictionSpecies());
    auto dough = problem.speciesHandler.copyAndAddObject(LinearPlasticViscoelasticFrictionSpecies());
    seed->setDensity(1000);
    seed->setStiffnessAndRestitutionCoefficient(1000.0, 0.9, 0.001);
    steel->setStiffnessAndRestitutionCoefficient(1000.0, 1.0, 0.001);
    dough->setStiffnessAndRestitutionCoefficient(1000.0, 0.8, 0.001);
    problem.speciesHandler.getMixedObject(seed, steel)->setStiffnessAndRestitutionCoefficient(1000.0, 0.5, 0.001);
    SphericalParticle first;
    first.setSpecies(seed);
    first.setRadius(0.001);
    problem.particleHandler.copyAndAddObject(first);
    SphericalParticle second;
    second.setSpecies(dough);
    problem.particleHandler.copyAndAddObject(second);
    InfiniteWall floor;
    floor.setSpecies(steel);
    floor.set(Vec3D(0, 0, -1), Vec3D(0, 0, 0));
    problem.wallHandler.copyAndAddObject(floor);
}
