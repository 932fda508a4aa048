// SPDX-License-Identifier: MIT | after MercuryDPM Drivers/Tutorials/Tutorial3_BouncingBallElastic.cpp | BSD-3-Clause | speed=1
#include <Mercury3D.h>
#include <Species/LinearViscoelasticSpecies.h>
int main()
{
    Mercury3D problem;
    problem.setGravity(Vec3D(0.0, 0.0, -10.0));
    LinearViscoelasticSpecies species;
    species.setDensity(2500.0);
    species.setStiffness(258.5);
    species.setDissipation(0.0);
    problem.speciesHandler.copyAndAddObject(species);
    SphericalParticle p0;
    p0.setSpecies(problem.speciesHandler.getObject(0));
    p0.setRadius(0.005);
    problem.setTimeStep(.005 / 50.0);
    problem.solve();
}
