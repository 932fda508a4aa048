# SPDX-License-Identifier: MIT | after YADE examples/chained-cylinders/CohesiveCylinderSphere.py | GPL-2.0 | speed=0.1
O.materials.append(CohFrictMat(young=8e5, poisson=0.3, density=4e3, frictionAngle=radians(30), normalCohesion=1e3, shearCohesion=1e3, isCohesive=False, label='mat'))
O.bodies.append([sphere((0, 0, 0.03 * k), 0.01, material='mat') for k in range(2)])
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom6D()], [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys()], [Law2_ScGeom6D_CohFrictPhys_CohesionMoment()]),
    NewtonIntegrator(damping=0.1, gravity=(0, -9.81, 0)),
]
O.dt = 1e-5
