// SPDX-License-Identifier: MIT | after MercuryDPM Documentation, Hertzian species | BSD-3-Clause | speed=1
#include <Species/HertzianViscoelasticMindlinSpecies.h>
int main()
{
    HertzianViscoelasticMindlinSpecies species;
    species.setDensity(2500);
    species.setEffectiveElasticModulusAndRestitutionCoefficient(1e8, 0.4);
}
