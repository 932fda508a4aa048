# SPDX-License-Identifier: MIT | after YADE examples/test/mindlin.py with gamma | GPL-2.0 | speed=0.05
m = O.materials.append(FrictMat(young=1e7, poisson=0.3, density=2500, frictionAngle=0.3))
O.bodies.append(sphere((0, 0, 0), 0.001, material=m))
O.bodies.append(sphere((0, 0, 0.003), 0.001, material=m))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys(gamma=0.05, en=0.8)],
        [Law2_ScGeom_MindlinPhys_Mindlin(includeAdhesion=True)],
    ),
    NewtonIntegrator(damping=0),
]
O.dt = 1e-7
