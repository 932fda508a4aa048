// SPDX-License-Identifier: MIT | after MercuryDPM Drivers, a drum with two kinds | BSD-3-Clause | speed=0.5
#include <Species/LinearViscoelasticFrictionSpecies.h>
int main()
{
    LinearViscoelasticFrictionSpecies small;
    small.setDensity(2000);
    small.setStiffnessAndRestitutionCoefficient(1e4, 0.6, 0.001);
    small.setSlidingFrictionCoefficient(0.5);
}
