// SPDX-License-Identifier: MIT | after MercuryDPM FreeCoolingDemo, discs in two dimensions | BSD-3-Clause | speed=0.1
class Discs : public Mercury2D
{
    void setupInitialConditions() override
    {
        auto species = speciesHandler.copyAndAddObject(LinearViscoelasticSpecies());
        species->setDensity(2000);
        species->setDissipation(0.005);
        species->setStiffness(1e3);
        BaseParticle particle;
        particle.setRadius(0.0001);
        wallHandler.copyAndAddObject(IntersectionOfWalls());
    }
};
