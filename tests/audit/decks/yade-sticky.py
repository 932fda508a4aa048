# SPDX-License-Identifier: MIT | after YADE scripts with cohesion on new contacts, and of concrete | MIT | no option
O.materials.append(CohFrictMat(young=8e5, poisson=0.3, density=4e3, normalCohesion=1e3, shearCohesion=1e3, label='snow'))
O.materials.append(CpmMat(young=3e10, poisson=0.2, density=4800, sigmaT=3e6, epsCrackOnset=1e-4, relDuctility=30, label='concrete'))
O.materials.append(FrictMat(young=1e9, poisson=0.3, label='steel'))
O.bodies.append(sphere((0, 0, 0), 0.01, material='snow'))
O.bodies.append(sphere((0, 0, 1), 0.01, material='concrete'))
O.bodies.append(facet([(0, 0, 0), (1, 0, 0), (0, 1, 0)], material='steel'))
O.engines = [
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom6D(), Ig2_Facet_Sphere_ScGeom6D()],
        [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionOnNewContacts=True), Ip2_FrictMat_CpmMat_FrictPhys()],
        [Law2_ScGeom6D_CohFrictPhys_CohesionMoment()]),
    NewtonIntegrator(damping=0),
]
