# SPDX-License-Identifier: MIT | after YADE scripts of bonded and of cemented grains, GitHub | MIT | speed=0.1
def rock():
    return JCFpmMat(type=1, young=8e5, poisson=0.3, density=4e3, frictionAngle=0.5, tensileStrength=1e3, cohesion=1e3, label='rock')
O.materials.append(CohFrictMat(young=8e5, poisson=0.3, density=4e3, normalCohesion=1e3, shearCohesion=1e3, label='cement'))
O.bodies.append(sphere((0, 0, 0), 0.01, material='cement'))
O.bodies.append(sphere((0, 0, 1), 0.01, material=rock))
ip = Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom6D()],
        [ip, Ip2_JCFpmMat_JCFpmMat_JCFpmPhys()],
        [Law2_ScGeom6D_CohFrictPhys_CohesionMoment(), Law2_ScGeom_JCFpmPhys_JointedCohesiveFrictionalPM()]),
    NewtonIntegrator(damping=0.1),
]
O.dt = 1e-5
